/* Arrays that grow by one element. */
#ifndef SCALLOP_GROW_H
#define SCALLOP_GROW_H

#include <stddef.h>

/* An array of count elements of that size, with room for one more: moved, or the same. It has room for the next power of two, so no
 * other number of elements may have been allocated. NULL: out of memory, and the array is as it was. */
void *grown(void *array, long count, size_t size);

#endif
