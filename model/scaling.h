/* The arithmetic of scallop_scale, inline and without branches, for loops over many crawlers. Not public. */
#ifndef SCALLOP_MODEL_SCALING_H
#define SCALLOP_MODEL_SCALING_H

#include <float.h>

#include "model/model.h"

/* Inline in loops over many crawlers: a call would prevent vector instructions. (make coverage requires each
 * function once.) */
#if defined __wasm__ && !defined SCALLOP_INLINE /* size matters more */
#define SCALLOP_INLINE static inline
#endif
#ifndef SCALLOP_INLINE
#define SCALLOP_INLINE static inline __attribute__((always_inline))
#endif

/* Returns true if the number is normal. It is below DBL_MAX, the result of an overflow that is not rounded up. */
SCALLOP_INLINE int scaling_is_normal(double positive) { return (positive >= DBL_MIN) & (positive < DBL_MAX); }

/* Returns true if a result keeps its digits when it is scaled back. Far below its natural unit it has few digits to
 * lose. */
SCALLOP_INLINE int scaling_keeps(double scaled, double result)
{
  double a = scaled < 0 ? -scaled : scaled, b = result < 0 ? -result : result;
  return (b < DBL_MAX) & ((a < 0x1p-960) | (b >= DBL_MIN));
}

/* Returns a result scaled back; scaling_keeps judges it. 0 below the normal doubles: the rounding mode would decide the
 * only digit. */
SCALLOP_INLINE double scaling_back(double scaled, double unit)
{
  double result = scaled * unit, size = result < 0 ? -result : result;
  return size >= DBL_MIN ? result : 0 * scaled;
}

/* Writes all scaled quantities; the gait is left unchanged. */
SCALLOP_INLINE void scaling_set(double m1, double m2, double F1, double F2, double L, double T, double alpha,
                                struct scallop_scaled *s)
{
  double M = m1 + m2, F = F1 + F2;
  s->mu1 = m1 / M;
  s->mu2 = m2 / M;
  s->mu_difference = (m1 - m2) / M;
  s->f1 = F1 / F;
  s->f2 = F2 / F;
  s->delta = (F1 - F2) / F;
  s->eps = (T / L) * (F / M * T);
  s->fraction[SCALLOP_EXTENSION] = alpha;
  s->fraction[SCALLOP_CONTRACTION] = 1 - alpha;
  s->velocity = L / T;
}

/* Writes all scaled quantities. Returns true if every parameter is in its domain and every scaled quantity and
 * intermediate result is normal; otherwise scallop_scale determines the reason. */
SCALLOP_INLINE int scaling_of(double m1, double m2, double F1, double F2, double L, double T, double alpha,
                              struct scallop_scaled *s)
{
  double friction = (F1 + F2) / (m1 + m2), rest = 1 - alpha;
  scaling_set(m1, m2, F1, F2, L, T, alpha, s);
  double shorter = alpha < rest ? alpha : rest, square = shorter * shorter;
  int positive = (m1 > 0) & (m2 > 0) & (F1 > 0) & (F2 > 0) & (L > 0) & (T > 0) & (alpha > 0) & (alpha < 1);
  int normal = scaling_is_normal(s->mu1) & scaling_is_normal(s->mu2) & scaling_is_normal(s->f1)
               & scaling_is_normal(s->f2) & scaling_is_normal(T / L) & scaling_is_normal(friction)
               & scaling_is_normal(friction * T) & (square >= DBL_MIN) & scaling_is_normal(s->eps * square)
               & (s->eps < DBL_MAX) & (s->velocity >= DBL_MIN) & (s->velocity < DBL_MAX * shorter);
  return positive & normal;
}

/* Returns true if a parameter is far from over- and underflow. With such parameters every scaled quantity is normal:
 * eps times the square of a phase's fraction is a product of seven. */
static inline bool scaling_is_moderate(double x) { return x >= 0x1p-100 && x <= 0x1p100; }

#endif
