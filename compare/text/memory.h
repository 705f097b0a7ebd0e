/* Memory of lists that grow by one item at a time. */
#ifndef SCALLOP_COMPARE_TEXT_MEMORY_H
#define SCALLOP_COMPARE_TEXT_MEMORY_H

#include <stdlib.h>

/* Returns the list with memory for one more item than count. It reallocates when count is 0 or a power of two: a list
 * must always grow by this function. NULL: out of memory; the list is unchanged. */
static inline void *list_grown(void *list, long count, size_t size)
{
  return (count & (count - 1)) != 0 ? list : realloc(list, (size_t)(count > 0 ? 2 * count : 1) * size);
}

#endif
