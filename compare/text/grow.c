#include "compare/text/grow.h"

#include <stdlib.h>

void *grown(void *array, long count, size_t size)
{
  if ((count & (count - 1)) != 0)
    return array;
  return realloc(array, (count > 0 ? 2 * (size_t)count : 1) * size);
}
