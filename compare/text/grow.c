#include "compare/text/grow.h"

#include <stdlib.h>

void *grown(void *array, long count, size_t size)
{
  if ((count & (count - 1)) != 0)
    return array;
  return realloc(array, (count > 0 ? 2 * (size_t)count : 1) * size);
}

uint32_t checksum_after(uint32_t before, const void *memory, size_t size)
{
  const unsigned char *byte = memory;
  for (size_t i = 0; i < size; i++)
    before = (before ^ byte[i]) * UINT32_C(16777619);
  return before;
}
