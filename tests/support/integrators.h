/* What the tests of integrators share: an integrator held against the exact solver, in other units, told to stop, and
 * what it refuses. Header-only. */
#ifndef SCALLOP_TESTS_SUPPORT_INTEGRATORS_H
#define SCALLOP_TESTS_SUPPORT_INTEGRATORS_H

#include <float.h>

#include "numerics/integrators/integrator.h"
#include "tests/support/random_crawler.h"
#include "tests/support/solved.h"

static inline void end_integrator(struct scallop_integrator **integrator) { scallop_integrator_destroy(*integrator); }
/* An integrator that there must be, and that ends with its block */
#define INTEGRATOR(name, made) \
  struct scallop_integrator *name __attribute__((cleanup(end_integrator))) = (made); \
  assert_non_null(name)

static inline struct scallop_integrator_period integrator_period(struct scallop_integrator *integrator,
                                                                 const struct scallop_crawler *c, double v0)
{
  struct scallop_integrator_period p = { .v_end = NAN };
  assert_int_equal(integrator->period(integrator, c, v0, NULL, &p), SCALLOP_OK);
  assert_true(p.steps >= 0 && p.evaluations >= p.steps && p.events >= 0);
  return p;
}

/* The largest share of a bound that was seen */
static double worst_share;

static inline void check_share(double got, double wanted, double tolerance)
{
  worst_share = fmax(worst_share, fabs(got - wanted) / tolerance);
  CHECK_NEAR(got, wanted, tolerance);
}

static inline double fastest_l(const struct scallop_crawler *c) { return c->L / (c->T * fmin(c->alpha, 1 - c->alpha)); }

/* bound (L/(T min(alpha, 1 - alpha)) + |v|) for velocities, and T times that for the displacement */
static inline void check_period(const struct scallop_integrator_period *p, const struct scallop_crawler *c, double v0,
                                const struct scallop_period_result *exact, double bound)
{
  double unit = fastest_l(c);
  check_share(p->v_mid, exact->v_mid, bound * (unit + fabs(exact->v_mid)));
  check_share(p->v_end, exact->v_end, bound * (unit + fabs(exact->v_end)));
  check_share(p->displacement, exact->displacement, bound * c->T * (unit + fabs(v0)));
}

/* The larger difference of v_end and of the displacement, in L/T, in L */
static inline double distance(const struct scallop_crawler *c, const struct scallop_integrator_period *p, double v_end,
                              double displacement)
{
  return fmax(fabs(p->v_end - v_end) * c->T / c->L, fabs(p->displacement - displacement) / c->L);
}

/* Slope of log error against log h, by least squares over h, h/ratio, h/ratio^2 ... */
static inline double observed_order(const double *error, int count, double ratio)
{
  double sum = 0, weights = 0;
  for (int i = 0; i < count; i++) {
    double x = i - 0.5 * (count - 1);
    sum -= x * log(error[i]) / log(ratio);
    weights += x * x;
  }
  return sum / weights;
}

/* By root and by simulation from v0, within a bound of the velocity */
static inline void check_steady(struct scallop_integrator *integrator, const struct scallop_crawler *c, double v0,
                                double tolerance, double bound)
{
  struct scallop_integrator_steady s;
  struct scallop_steady_result exact = steady_of(c);
  assert_int_equal(scallop_integrator_root(integrator, c, tolerance, NULL, &s), SCALLOP_OK);
  check_share(s.v_start, exact.period.v_start, bound);
  check_share(s.displacement, exact.period.displacement, bound * c->T);
  assert_true(s.periods > 2 && s.periods <= s.root_iterations + 2 && s.root_iterations < 60);
  assert_int_equal(scallop_integrator_simulate(integrator, c, v0, tolerance, NULL, &s), SCALLOP_OK);
  check_share(s.v_start, exact.period.v_start, bound);
  check_share(s.displacement, exact.period.displacement, bound * c->T);
}

/* Not taken, and nothing touched */
static inline void check_refused(struct scallop_integrator *integrator, const struct scallop_crawler *c, double v0,
                                 const struct scallop_patience *patience, enum scallop_status wanted)
{
  REFUSES(scallop_integrator_period, integrator->period(integrator, c, v0, patience, &out), wanted);
}

/* Patience for so many questions: then -1 is left */
static inline bool count_down(void *left) { return (*(long *)left)-- > 0; }
#define PATIENCE(name, left) const struct scallop_patience name = { count_down, &(left) }

/* A gait of one piece with curves of its own, which may break every bound */
struct odd_piece {
  struct scallop_curve curve;
  struct scallop_piece piece;
  struct scallop_gait gait;
};
static inline const struct scallop_gait *odd_gait(struct odd_piece *o,
                                                  double (*velocity)(const struct scallop_piece *, double),
                                                  double (*acceleration)(const struct scallop_piece *, double))
{
  const struct scallop_curve *linear = &scallop_curve_linear;
  o->curve = (struct scallop_curve){ linear->length, velocity ? velocity : linear->velocity,
                                     acceleration ? acceleration : linear->acceleration, linear->when, NULL };
  o->piece = (struct scallop_piece){ .end = 1, .direction = 1, .velocity = 1, .curve = &o->curve };
  const struct scallop_shape shape = { .pieces = &o->piece, .count = 1, .l0 = 1, .lT = -1, .peak = 1, .net = 1 };
  o->gait = (struct scallop_gait){ "odd", { shape, shape } };
  return &o->gait;
}

#endif
