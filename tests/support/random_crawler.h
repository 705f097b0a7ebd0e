/* What the randomised tests share: a seeded generator, crawlers and start velocities of several
 * families, and three gaits that the library does not have. Header-only; knows public headers only. */
#ifndef SCALLOP_TESTS_SUPPORT_RANDOM_CRAWLER_H
#define SCALLOP_TESTS_SUPPORT_RANDOM_CRAWLER_H

#include <math.h>
#include <stdint.h>

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

/* trapezoid: l' rises over the first quarter, is constant, and falls over the last eighth. Height
 * 16/13 makes the area 1. The middle piece does not touch its anchor, so it has a length of its own:
 * l(1/4) = 2/13. */
static inline double plateau_length(const struct scallop_piece *p, double u)
{
  return p->direction * (16 * u - 2) / 13;
}
static inline double plateau_velocity(const struct scallop_piece *p, double u) { return (void)u, p->velocity; }
static inline double plateau_acceleration(const struct scallop_piece *p, double u) { return (void)p, (void)u, 0; }
static inline double plateau_when(const struct scallop_piece *p, double a) { return a == 0 ? p->begin : NAN; }

static const struct scallop_curve plateau = { plateau_length, plateau_velocity, plateau_acceleration, plateau_when,
                                              NULL };

static const struct scallop_law plateau_law = { SCALLOP_LAW_POLYNOMIAL, 0, .polynomial = { { 16 }, 13 } };
static const struct scallop_law rise_law = { SCALLOP_LAW_POLYNOMIAL, 1, .polynomial = { { 0, 64 }, 13 } };
static const struct scallop_law fall_law = { SCALLOP_LAW_POLYNOMIAL, 1, .polynomial = { { 0, 128 }, 13 } };

#define TRAPEZOID(sign) \
  { .begin = 0, \
    .end = 0.25, \
    .direction = (sign), \
    .linear = true, \
    .acceleration = (sign)*64. / 13, \
    .curve = &scallop_curve_linear, \
    .law = &rise_law }, \
      { .begin = 0.25, \
        .end = 0.875, \
        .direction = (sign), \
        .linear = true, \
        .velocity = (sign)*16. / 13, \
        .curve = &plateau, \
        .law = &plateau_law }, \
  { \
    .begin = 0.125, .end = 0, .anchor = SCALLOP_FROM_END, .direction = (sign), .linear = true, \
    .acceleration = (sign) * -128. / 13, .curve = &scallop_curve_linear, .law = &fall_law \
  }

static const struct scallop_piece trapezoid_extension[] = { TRAPEZOID(1) };
static const struct scallop_piece trapezoid_contraction[] = { TRAPEZOID(-1) };
static const struct scallop_gait trapezoid_gait = {
  "trapezoid",
  { { trapezoid_extension, 3, 64. / 13, -128. / 13, 16. / 13, 1, true, false },
    { trapezoid_contraction, 3, -64. / 13, 128. / 13, 16. / 13, -1, true, false } }
};

/* minimum jerk: l = 10 s^3 - 15 s^4 + 6 s^5, symmetric about s = 1/2. l''' = 0 at (3 - sqrt 3)/6
 * from either end, where the pieces are split so that l'' is monotone in each. l'' = 0 at both ends. */
static inline double jerk_sign(const struct scallop_piece *p)
{
  return p->anchor == SCALLOP_FROM_START ? p->direction : -p->direction;
}
static inline double jerk_length(const struct scallop_piece *p, double u)
{
  return jerk_sign(p) * (u * u * u * (10 - u * (15 - 6 * u)));
}
static inline double jerk_velocity(const struct scallop_piece *p, double u)
{
  double root = u * (1 - u);
  return p->direction * 30 * (root * root);
}
static inline double jerk_bend(double u) { return 60 * u * (1 - u) * (1 - 2 * u); }
static inline double jerk_acceleration(const struct scallop_piece *p, double u) { return jerk_sign(p) * jerk_bend(u); }
/* The u between below and above with jerk_bend(u) = level, or nan; the bend is monotone there. By bisection: slow,
 * right to the last digit. */
static inline double jerk_place(double below, double above, double level)
{
  if (jerk_bend(below) > jerk_bend(above)) {
    double end = below;
    below = above;
    above = end;
  }
  if (!(jerk_bend(below) <= level && level <= jerk_bend(above)))
    return NAN;
  if (level == jerk_bend(below))
    return below;
  for (double mid; (mid = 0.5 * (below + above)) != below && mid != above;)
    *(jerk_bend(mid) < level ? &below : &above) = mid;
  return above;
}
static inline double jerk_when(const struct scallop_piece *p, double a)
{
  return jerk_place(p->begin, p->end, jerk_sign(p) * a);
}

static const struct scallop_curve jerk_curve = { jerk_length, jerk_velocity, jerk_acceleration, jerk_when, NULL };

static const struct scallop_law jerk_law = { SCALLOP_LAW_POLYNOMIAL, 4, .polynomial = { { 0, 0, 30, -60, 30 }, 1 } };

#define JERK_TURN 0.21132486540518711775
#define JERK(from, to, anchored, sign) \
  { \
    .begin = (from), .end = (to), .anchor = (anchored), .direction = (sign), .curve = &jerk_curve, .law = &jerk_law \
  }
#define MINIMUM_JERK(sign) \
  JERK(0, JERK_TURN, SCALLOP_FROM_START, sign), JERK(JERK_TURN, 0.5, SCALLOP_FROM_START, sign), \
      JERK(0.5, JERK_TURN, SCALLOP_FROM_END, sign), JERK(JERK_TURN, 0, SCALLOP_FROM_END, sign)

static const struct scallop_piece jerk_extension[] = { MINIMUM_JERK(1) };
static const struct scallop_piece jerk_contraction[] = { MINIMUM_JERK(-1) };
static const struct scallop_gait minimum_jerk_gait = { "minimum-jerk",
                                                       { { jerk_extension, 4, 0, 0, 1.875, 1, false, false },
                                                         { jerk_contraction, 4, 0, 0, 1.875, -1, false, false } } };

/* sawtooth: l' = +1, then -1; it jumps between the phases. */
#define SAWTOOTH(sign) \
  { \
    .begin = 0, .end = 1, .direction = (sign), .jump = true, .linear = true, .velocity = (sign), \
    .curve = &scallop_curve_linear \
  }

static const struct scallop_piece sawtooth_extension[] = { SAWTOOTH(1) };
static const struct scallop_piece sawtooth_contraction[] = { SAWTOOTH(-1) };
static const struct scallop_gait sawtooth_gait = { "sawtooth",
                                                   { { sawtooth_extension, 1, 0, 0, 1, 1, false, false },
                                                     { sawtooth_contraction, 1, 0, 0, 1, -1, false, false } } };

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
