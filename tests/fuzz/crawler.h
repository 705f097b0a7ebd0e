/* Bytes as a crawler and a start velocity: the first byte chooses the gait and how wild the numbers are, eight doubles
 * follow. */
#ifndef SCALLOP_TESTS_FUZZ_CRAWLER_H
#define SCALLOP_TESTS_FUZZ_CRAWLER_H

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tests/support/random_crawler.h"

/* Ratios to a few hundred; to 10^18; any bit pattern at all, for the paper's two gaits alone */
enum wildness { TAME, WIDE, RAW, WILDNESSES };
enum { RAW_GAITS = 2 };

struct fuzz_case {
  struct scallop_crawler crawler;
  double v0;
  enum wildness wildness;
};

/* The mantissa as it is, the exponent from -span to span: what is equal stays equal, and a bit that changes is a small
 * step. */
static inline double fuzz_tamed(double x, int span)
{
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  int exponent = (int)(bits >> 52 & 0x7ff) % (2 * span + 1) - span;
  double size = ldexp(1 + (double)(bits & 0xfffffffffffffU) * 0x1p-52, exponent);
  return bits >> 63 ? -size : size;
}

/* Between 0 and 1, at either end as near as the exponent says */
static inline double fuzz_fraction(double x, int span)
{
  double size = fuzz_tamed(x, span), fraction = 0.5 / (1 + fabs(size));
  return signbit(size) ? 1 - fraction : fraction;
}

/* Missing bytes are 0. */
static inline struct fuzz_case fuzz_case_of(const uint8_t *data, size_t size)
{
  double x[8] = { 0 };
  int choice = size > 0 ? data[0] : 0;
  enum wildness wildness = (enum wildness)(choice / ALL_GAITS % WILDNESSES);
  if (size > 1)
    memcpy(x, data + 1, size - 1 < sizeof x ? size - 1 : sizeof x);
  if (wildness != RAW) {
    int span = wildness == TAME ? 4 : 30;
    for (int i = 0; i < 6; i++)
      x[i] = fabs(fuzz_tamed(x[i], span));
    x[6] = fuzz_fraction(x[6], span);
    x[7] = x[7] == 0 ? 0 : fuzz_tamed(x[7], span);
  }
  const struct scallop_gait *gait = every_gait[choice % (wildness == RAW ? RAW_GAITS : ALL_GAITS)];
  return (struct fuzz_case){ { x[0], x[1], x[2], x[3], x[4], x[5], x[6], gait }, x[7], wildness };
}

static inline const char *fuzz_describe(const struct fuzz_case *f)
{
  static char text[320];
  const struct scallop_crawler *c = &f->crawler;
  snprintf(text, sizeof text,
           "--m1 %.17g --m2 %.17g --F1 %.17g --F2 %.17g --L %.17g --T %.17g --alpha %.17g --gait %s --v0 %.17g", c->m1,
           c->m2, c->F1, c->F2, c->L, c->T, c->alpha, c->gait->name, f->v0);
  return text;
}

#endif
