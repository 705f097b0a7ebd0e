/* A phase put back into Newton's law, the friction law, and the balances of momentum and energy, interval by interval.
 *
 * Units as in struct scallop_interval: lengths in L, times in the duration tau of the phase, masses in M, so that
 * friction is f_i = tau^2 F_i/(M L). Between the ends of an interval every balance is a closed form of c, l, l' and x
 * there.
 *
 * Tolerances are a number of unit roundoffs of the sum of the absolute values of the terms. The time of an event is
 * uncertain by a rounding, and with it what changes at that time: law_size. Header-only; who includes it says what
 * happens when a law is broken. */
#ifndef SCALLOP_TESTS_SUPPORT_LAWS_H
#define SCALLOP_TESTS_SUPPORT_LAWS_H

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#include "numerics/numerics.h"

static inline double sense(const struct scallop_interval *i) { return i->piece->anchor == SCALLOP_FROM_START ? 1 : -1; }
static inline double duration(const struct scallop_interval *i) { return sense(i) * (i->u_end - i->u_begin); }
static inline double length(const struct scallop_interval *i, double u) { return i->piece->curve->length(i->piece, u); }
static inline double rate(const struct scallop_interval *i, double u) { return i->piece->curve->velocity(i->piece, u); }
static inline double bend(const struct scallop_interval *i, double u)
{
  return i->piece->curve->acceleration(i->piece, u);
}
static inline bool glued(const struct scallop_interval *i) { return i->mode.s1 == 0 || i->mode.s2 == 0; }

static inline bool follows(const struct scallop_interval *b, const struct scallop_interval *a)
{
  if (b->piece == a->piece)
    return a->u_end == b->u_begin;
  return b->piece == a->piece + 1 && a->u_end == a->piece->end && b->u_begin == b->piece->begin;
}

/* What is wrong with their order: they cover the phase, from x = 0, and in each a body slides for some time; NULL:
 * nothing. */
static inline const char *disorder(const struct scallop_interval *first, int count, const struct scallop_shape *shape)
{
  const struct scallop_interval *last = first + count - 1;
  if (count < 1 || first->piece != shape->pieces || first->u_begin != first->piece->begin || first->x_begin != 0)
    return "the first does not begin with the phase";
  if (last->piece != shape->pieces + shape->count - 1 || last->u_end != last->piece->end)
    return "the last does not end with the phase";
  for (const struct scallop_interval *i = first; i <= last; i++)
    if (!(duration(i) > 0) || (i->mode.s1 == 0 && i->mode.s2 == 0) || (i > first && !follows(i, i - 1)))
      return "one is empty, at rest or does not follow the one before it";
  return NULL;
}

struct law_phase {
  struct scallop_crawler crawler;
  enum scallop_phase_kind kind;
  double v0, roundoff; /* how many unit roundoffs are allowed, times one */
  double unit;         /* of velocities */
  double mu[2], f[2];
  const struct scallop_interval *interval;
  int count;
};

/* Does not return; i may be NULL. */
static void law_is_broken(const struct law_phase *p, const struct scallop_interval *i, const char *what, double got,
                          double wanted, double tolerance, int line);
static double law_worst_share; /* of a tolerance, that was used */

/* Where terms overflow or leave the normal range there is nothing to hold the difference against. */
static inline void law_near(const struct law_phase *p, const struct scallop_interval *i, const char *what, double got,
                            double wanted, double terms, int line)
{
  double tolerance = p->roundoff * terms + DBL_MIN, off = fabs(got - wanted);
  if (isfinite(tolerance) && !(off <= tolerance))
    law_is_broken(p, i, what, got, wanted, tolerance, line);
  if (off <= tolerance)
    law_worst_share = fmax(law_worst_share, off / tolerance);
}
#define LAW(i, got, wanted, terms) law_near(p, i, #got, got, wanted, terms, __LINE__)

static inline long double law_duration(const struct scallop_crawler *c, enum scallop_phase_kind kind)
{
  return (kind == SCALLOP_EXTENSION ? c->alpha : 1 - c->alpha) * (long double)c->T;
}

/* A force in M L/tau^2. In long double: what is in between may be beyond a double, or too small for one. */
static inline double law_force(const struct law_phase *p, double force)
{
  const struct scallop_crawler *c = &p->crawler;
  long double tau = law_duration(c, p->kind);
  return (double)(tau / c->L * (force / ((long double)c->m1 + c->m2)) * tau);
}

static inline struct law_phase law_phase_of(const struct scallop_crawler *c, enum scallop_phase_kind kind, double v0,
                                            int roundings, const struct scallop_interval *interval, int count)
{
  double M = c->m1 + c->m2;
  struct law_phase p = { .crawler = *c,
                         .kind = kind,
                         .v0 = v0,
                         .roundoff = roundings * (0.5 * DBL_EPSILON),
                         .unit = (double)(c->L / law_duration(c, kind)),
                         .mu = { c->m1 / M, c->m2 / M },
                         .interval = interval,
                         .count = count };
  p.f[0] = law_force(&p, c->F1);
  p.f[1] = law_force(&p, c->F2);
  return p;
}

/* velocity of a body: c - mu2 l', c + mu1 l' */
static inline double law_velocity(const struct law_phase *p, const struct scallop_interval *i, int body, double c,
                                  double u)
{
  return c + (body == 0 ? -p->mu[1] : p->mu[0]) * rate(i, u);
}

/* What a velocity in this interval is a sum of, with a rounding of u, which may be below the normal range */
static inline double law_size_of(const struct law_phase *p, const struct scallop_interval *i, int body)
{
  double mu = p->mu[1 - body], l = fmax(fabs(rate(i, i->u_begin)), fabs(rate(i, i->u_end)));
  double b = fmax(fabs(bend(i, i->u_begin)), fabs(bend(i, i->u_end)));
  return fmax(fabs(i->c_begin), fabs(i->c_end)) + mu * l
         + (fabs(i->c_slope) + mu * b) * (fmax(i->u_begin, i->u_end) + DBL_MIN);
}

static inline double law_size(const struct law_phase *p, const struct scallop_interval *i)
{
  return fmax(law_size_of(p, i, 0), law_size_of(p, i, 1));
}

/* Friction on both bodies while they slide. F1 - F2 from the inputs: it can be small. */
static inline double law_friction(const struct law_phase *p, const struct scallop_interval *i)
{
  return -law_force(p, p->crawler.F1 * i->mode.s1 + p->crawler.F2 * i->mode.s2);
}

/* The impulse of friction. A stuck body is held with what its own velocity 0 and the other one's Newton's law leave,
 * -mu_other l'' - friction of the other. */
static inline double law_impulse(const struct law_phase *p, const struct scallop_interval *i)
{
  double change = rate(i, i->u_end) - rate(i, i->u_begin);
  return i->mode.s1 == 0 ? p->mu[1] * change : i->mode.s2 == 0 ? -p->mu[0] * change : law_friction(p, i) * duration(i);
}

/* Both bodies slide: mu1 x1'' + mu2 x2'' = friction. One is stuck: it stays so. A body that slides has the velocity of
 * its sign at both ends. */
static inline void law_of_motion(const struct law_phase *p, const struct scallop_interval *i)
{
  if (!glued(i))
    LAW(i, i->c_slope, law_friction(p, i), fabs(law_friction(p, i)));
  else
    LAW(i, i->glue, i->mode.s1 == 0 ? p->mu[1] : -p->mu[0], i->mode.s1 == 0 ? p->mu[1] : p->mu[0]);
  for (int end = 0; end < 2; end++)
    for (int body = 0; body < 2; body++) {
      double v = law_velocity(p, i, body, end ? i->c_end : i->c_begin, end ? i->u_end : i->u_begin);
      int sign = body == 0 ? i->mode.s1 : i->mode.s2;
      LAW(i, sign == 0 ? v : fmin(sign * v, 0), 0, law_size_of(p, i, body));
    }
}

/* The kinetic energy changes by what the linkage does, force times l', less what friction takes. x: of the centre of
 * mass, a difference of numbers of the size of reached. */
static inline void law_of_energy(const struct law_phase *p, const struct scallop_interval *i, double x, double reached)
{
  double mu1 = p->mu[0], mu2 = p->mu[1], s1 = i->mode.s1, s2 = i->mode.s2;
  double l = length(i, i->u_end) - length(i, i->u_begin),
         l_size = fabs(length(i, i->u_end)) + fabs(length(i, i->u_begin));
  double begin = rate(i, i->u_begin), end = rate(i, i->u_end), squares = end * end - begin * begin;
  double change = 0.5 * (i->c_end * i->c_end - i->c_begin * i->c_begin + mu1 * mu2 * squares);
  double of_centre = glued(i) ? 0.5 * i->glue * squares : law_friction(p, i) * l; /* integral of c' l' */
  double work = i->mode.s2 != 0 ? mu2 * (of_centre + 0.5 * mu1 * squares) + p->f[1] * s2 * l
                                : -(mu1 * (of_centre - 0.5 * mu2 * squares) + p->f[0] * s1 * l);
  double lost = p->f[0] * s1 * (x - mu2 * l) + p->f[1] * s2 * (x + mu1 * l);
  double forces = p->f[0] + p->f[1], speed = fmax(fabs(i->c_begin), fabs(i->c_end)) + fmax(fabs(begin), fabs(end));
  speed += (fabs(i->c_slope) + fmax(fabs(bend(i, i->u_begin)), fabs(bend(i, i->u_end))))
           * (fmax(i->u_begin, i->u_end) + DBL_MIN);
  LAW(i, change, work - lost, speed * speed + forces * (l_size + reached + speed * duration(i) + DBL_MIN));
}

/* All of these, what the phase begins and ends with, and the order of its intervals */
static inline void laws_hold(const struct law_phase *p, const struct scallop_phase_result *r)
{
  const struct scallop_interval *first = p->interval, *last = first + p->count - 1;
  const struct scallop_crawler *c = &p->crawler;
  const char *wrong = disorder(first, p->count, &c->gait->phase[p->kind]);
  double total = 0, terms = 0, half = (c->m1 - c->m2) / (c->m1 + c->m2) * 0.5;
  double stroke = p->kind == SCALLOP_EXTENSION ? 1 : -1, travel = r->dxC / c->L - half * stroke;
  if (wrong)
    law_is_broken(p, NULL, wrong, NAN, NAN, 0, __LINE__);
  for (const struct scallop_interval *i = first; i <= last; i++) {
    double one = law_impulse(p, i), x = (i < last ? i[1].x_begin : travel) - i->x_begin;
    if (i > first) /* between them may be one that is shorter than a rounding */
      LAW(i, i->c_begin, i[-1].c_end, law_size(p, i - 1) + law_size(p, i));
    law_of_motion(p, i);
    LAW(i, i->c_end - i->c_begin, one, law_size(p, i));
    law_of_energy(p, i, x, fabs(i->x_begin) + fabs(x) + (i < last ? 0 : (fabs(r->dxC) + DBL_MIN) / c->L + fabs(half)));
    total += one;
    terms += fabs(one) + law_size(p, i);
  }
  LAW(last, last->c_end - first->c_begin, total, terms);
  LAW(last, r->v_end / p->unit, last->c_end, fabs(last->c_end) + DBL_MIN / p->unit);
  /* unless the bodies brake in less than the least normal number */
  LAW(first, p->v0 / p->unit, first->c_begin, fabs(first->c_begin) + (p->f[0] + p->f[1]) * (DBL_MIN / p->roundoff));
}

#endif
