/* Memory: lists that grow by one item at a time. */
#ifndef SCALLOP_COMPARE_TEXT_MEMORY_H
#define SCALLOP_COMPARE_TEXT_MEMORY_H

#include <stdlib.h>

/* The list with room for one item more than the count it has: moved, as a rule, wherever the count is a power of two,
 * so no other number of items may have been allocated. NULL: out of memory, and the list stays as it is. */
static inline void *with_room(void *list, long count, size_t size)
{
  return (count & (count - 1)) != 0 ? list : realloc(list, (size_t)(count > 0 ? 2 * count : 1) * size);
}

#endif
