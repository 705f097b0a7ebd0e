/* What the randomised tests share: a seeded generator, crawlers and start velocities of several
 * families, and gaits. Header-only; knows public headers only. */
#ifndef SCALLOP_TESTS_SUPPORT_RANDOM_CRAWLER_H
#define SCALLOP_TESTS_SUPPORT_RANDOM_CRAWLER_H

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "model/gaits.h"
#include "numerics/numerics.h"
#include "tests/support/check.h"

struct random {
  uint64_t state;
};

/* splitmix64 (Steele, Lea & Flood 2014) */
static inline uint64_t random_bits(struct random *r)
{
  uint64_t z = r->state += UINT64_C(0x9e3779b97f4a7c15);
  z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
  return z ^ (z >> 31);
}

static inline double random_between(struct random *r, double lo, double hi)
{
  return lo + (hi - lo) * ((double)(random_bits(r) >> 11) * 0x1p-53);
}

static inline double random_decades(struct random *r, double lo, double hi) /* log-uniform */
{
  return exp(random_between(r, log(lo), log(hi)));
}

static inline int random_below(struct random *r, int n) { return (int)(random_bits(r) % (uint64_t)n); }

/* Three gaits of the families, made when the program starts: l' rises over the first quarter of a phase, is constant,
 * and falls over the last eighth; l'' = 0 at both ends of a phase; l' = +1, then -1, so that it jumps between them. */
static struct scallop_straight made_trapezoid, made_sawtooth;
static struct scallop_polynomial made_minimum_jerk;
#define trapezoid_gait made_trapezoid.gait
#define minimum_jerk_gait made_minimum_jerk.gait
#define sawtooth_gait made_sawtooth.gait

__attribute__((constructor)) static void make_gaits_of_tests(void)
{
  const double up[2] = { 0.25, 0.25 }, down[2] = { 0.125, 0.125 }, none[2] = { 0, 0 };
  const double c[] = { 0, 0, 0, 10, -15, 6 };
  if (scallop_make_trapezoidal(&made_trapezoid, "trapezoid", up, down) != SCALLOP_OK
      || scallop_make_polynomial(&made_minimum_jerk, "minimum-jerk", c, 5, NULL) != SCALLOP_OK
      || scallop_make_constant(&made_sawtooth, "sawtooth", none) != SCALLOP_OK)
    abort();
}

enum { SMOOTH_GAITS = 4, SAWTOOTH = 4, ALL_GAITS = 5 }; /* the first SMOOTH_GAITS have a continuous l' */
static const struct scallop_gait *const every_gait[ALL_GAITS] = { &scallop_gait_quadratic, &scallop_gait_sinusoidal,
                                                                  &trapezoid_gait, &minimum_jerk_gait, &sawtooth_gait };

enum family {
  ORDINARY,
  STICK_SLIP,
  EXTREME_RATIOS,
  SMALL_PERIOD,
  EQUAL_FORCES,
  NEARLY_EQUAL_FORCES,
  ALPHA_EDGE,
  FAMILIES
};

static inline double crawler_eps(const struct scallop_crawler *c)
{
  return c->T * c->T * (c->F1 + c->F2) / ((c->m1 + c->m2) * c->L);
}

/* For the report of a failure. */
static inline void print_crawler(const struct scallop_crawler *c)
{
  print_error("m1=%.17g m2=%.17g F1=%.17g F2=%.17g L=%.17g T=%.17g alpha=%.17g %s\n", c->m1, c->m2, c->F1, c->F2, c->L,
              c->T, c->alpha, c->gait->name);
}

/* Scales the forces so that eps is the one wanted. */
static inline void set_eps(struct scallop_crawler *c, double eps)
{
  double factor = eps / crawler_eps(c);
  c->F1 *= factor;
  c->F2 *= factor;
}

static inline struct scallop_crawler random_crawler(struct random *r, enum family family,
                                                    const struct scallop_gait *gait)
{
  double edge = family == EXTREME_RATIOS ? 1e3 : 5; /* the ratios are up to its square */
  struct scallop_crawler c = { random_decades(r, 1 / edge, edge), random_decades(r, 1 / edge, edge),
                               random_decades(r, 1 / edge, edge), random_decades(r, 1 / edge, edge),
                               random_between(r, 0.5, 20),        random_between(r, 0.3, 2),
                               random_between(r, 0.05, 0.95),     gait };
  if (family == EQUAL_FORCES)
    c.F2 = c.F1;
  if (family == NEARLY_EQUAL_FORCES)
    c.F2 = c.F1 * (1 + random_decades(r, 1e-15, 1e-3));
  if (family == ALPHA_EDGE)
    c.alpha = random_below(r, 2) ? random_decades(r, 1e-9, 1e-2) : 1 - random_decades(r, 1e-9, 1e-2);
  if (family == SMALL_PERIOD)
    c.T = random_decades(r, 1e-8, 1e-2);
  else
    set_eps(&c, family == STICK_SLIP ? random_decades(r, 1, 60) : random_decades(r, 1e-3, 20));
  return c;
}

/* Parameters of the same order of magnitude, T = 1; alpha as far from 0 and 1 as `edge` */
static inline struct scallop_crawler moderate_crawler(struct random *r, double ratio, double edge,
                                                      const struct scallop_gait *gait)
{
  struct scallop_crawler c = { .T = 1, .gait = gait };
  double *const all[] = { &c.m1, &c.m2, &c.F1, &c.F2 };
  for (int i = 0; i < 4; i++)
    *all[i] = random_decades(r, 1 / ratio, ratio);
  c.L = random_decades(r, 0.1, 10);
  c.alpha = random_between(r, edge, 1 - edge);
  return c;
}

/* From rest, forward and backward: of the size of l', of what friction does in a phase, very small
 * and beyond every curve. */
static inline double random_start(struct random *r, const struct scallop_crawler *c, enum scallop_phase_kind kind)
{
  double tau = scallop_phase_duration(c, kind), M = c->m1 + c->m2;
  const double sizes[] = { 0,
                           2 * c->L / tau,
                           c->m1 / M * c->L / tau,
                           c->m2 / M * c->L / tau,
                           tau * (c->F1 + c->F2) / M,
                           1e-9 * c->L / tau,
                           5 * c->L / tau };
  return sizes[random_below(r, sizeof sizes / sizeof *sizes)] * random_between(r, -1, 1);
}

#endif
