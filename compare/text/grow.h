/* Memory: arrays that grow by one element, and checksums. */
#ifndef SCALLOP_GROW_H
#define SCALLOP_GROW_H

#include <stddef.h>
#include <stdint.h>

/* An array of count elements of that size, with room for one more: moved, or the same. It has room for the next power of two, so no
 * other number of elements may have been allocated. NULL: out of memory, and the array is as it was. */
void *grown(void *array, long count, size_t size);

/* FNV-1a (Fowler, Noll & Vo), 32 bits, of memory after what `before` is the checksum of. */
#define CHECKSUM_OF_NOTHING UINT32_C(2166136261)
uint32_t checksum_after(uint32_t before, const void *memory, size_t size);

#endif
