/* The checksum of some memory: FNV-1a (Fowler, Noll & Vo), 32 bits. */
#ifndef SCALLOP_CHECKSUM_H
#define SCALLOP_CHECKSUM_H

#include <stddef.h>
#include <stdint.h>

/* Of memory after what `before` is the checksum of: CHECKSUM_OF_NOTHING, or that of an earlier piece. */
#define CHECKSUM_OF_NOTHING UINT32_C(2166136261)
static inline uint32_t checksum_after(uint32_t before, const void *memory, size_t size)
{
  const unsigned char *byte = (const unsigned char *)memory;
  for (size_t i = 0; i < size; i++)
    before = (before ^ byte[i]) * UINT32_C(16777619);
  return before;
}

#endif
