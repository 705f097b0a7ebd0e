/* The solver of numerics/event in a type wider than double, from the parameters to the results: included once for each
 * type, with
 *
 *     real          the type
 *     REAL_BITS     of its significand
 *     WIDE          what the solver at the end is called
 *
 *     real_sine, real_cosine     of 0 <= x < 1
 *
 * defined before. Not public. */
#include <math.h>
#include <stddef.h>

#include "model/law.h"
#include "numerics/wide/wide.h"

#define ROUNDING ((real)1 / (1LL << REAL_BITS / 2) / (1LL << (REAL_BITS - REAL_BITS / 2)))
#define SOLVE static inline
#include "numerics/event/period.h"

#include "model/root.h"
#include "numerics/wide/wide_law.h"

#ifdef __wasm__ /* where size counts more */
#define WALKS_ONLY true
#endif
#include "numerics/event/solve.h"

/* shape->net with all its digits: the ends of pieces are exact. */
static real net_time(const struct scallop_shape *shape)
{
  real net = 0;
  for (int i = 0; i < shape->count; i++) {
    const struct scallop_piece *p = &shape->pieces[i];
    net += p->direction * (p->anchor == SCALLOP_FROM_START ? (real)p->end - p->begin : (real)p->begin - p->end);
  }
  return net;
}

static struct walker walker_of(const struct scallop_crawler *c, bool walks)
{
  real M = (real)c->m1 + c->m2, F = (real)c->F1 + c->F2, T = c->T;
  struct walker s = {
    .fraction = { c->alpha, 1 - (real)c->alpha }, .eps = T / c->L * T * F / M, .gait = c->gait, .walks = walks
  };
  s.driven = s.fraction[0] * net_time(&c->gait->phase[0]) + s.fraction[1] * net_time(&c->gait->phase[1]);
  for (int kind = 0; kind < 2; kind++)
    s.phase[kind] = (struct phase_input){ .shape = &c->gait->phase[kind],
                                          .mu1 = c->m1 / M,
                                          .mu2 = c->m2 / M,
                                          .f1 = c->F1 / F,
                                          .f2 = c->F2 / F,
                                          .delta = ((real)c->F1 - c->F2) / F,
                                          .eps = s.eps * s.fraction[kind] * s.fraction[kind] };
  return s;
}

static struct scallop_wide split(real x)
{
  double high = (double)x;
  return (struct scallop_wide){ high, isfinite(high) ? (double)(x - high) : 0 };
}

static void wide_phase(const struct scallop_crawler *c, enum scallop_phase_kind kind, double v0,
                       struct scallop_wide_phase *out)
{
  const struct walker s = walker_of(c, true);
  struct period_motion m;
  real tau = s.fraction[kind] * c->T, unit = c->L / tau, way[3], size[3];
  motion_walk(&s.phase[kind], v0 / unit, NULL, NULL, &m);
  motion_bodies(&s.phase[kind], kind, ((real)c->m1 - c->m2) / ((real)c->m1 + c->m2), &m, way, size);
  *out = (struct scallop_wide_phase){ .t1 = split(m.first_switch * tau),
                                      .dT = split(m.last_switch * tau),
                                      .v_end = split(m.c_end * unit),
                                      .dx1 = split(way[0] * c->L),
                                      .dx2 = split(way[1] * c->L),
                                      .dxC = split(way[2] * c->L),
                                      .dx1_size = (double)(size[0] * c->L),
                                      .dx2_size = (double)(size[1] * c->L),
                                      .dxC_size = (double)(size[2] * c->L),
                                      .regime = motion_regime(&m),
                                      .modes = m.modes };
}

static struct scallop_wide_period told(const struct scallop_crawler *c, const struct walker *s, const struct period *p)
{
  real velocity = (real)c->L / c->T;
  return (struct scallop_wide_period){ .v_start = split(p->c_start * velocity),
                                       .v_mid = split(p->c_mid * velocity),
                                       .v_end = split(p->c_end * velocity),
                                       .displacement = split(p->travel * c->L),
                                       .displacement_size = (double)(p->size * c->L),
                                       .multiplier = split(period_multiplier(s, p)),
                                       .regime = period_regime(p),
                                       .modes = { p->phase[0].modes, p->phase[1].modes } };
}

static void wide_period(const struct scallop_crawler *c, double v0, bool walks, struct scallop_wide_period *out)
{
  const struct walker s = walker_of(c, walks);
  struct period p = { .continues = false };
  period_solve(&s, v0 * (real)c->T / c->L, &p);
  period_sum_up(&s, &p);
  *out = told(c, &s, &p);
}

static void wide_steady(const struct scallop_crawler *c, const double guess[2], bool walks,
                        struct scallop_wide_steady *out)
{
  const struct walker s = walker_of(c, walks);
  struct period p = { .continues = false };
  struct scallop_work ignored = { 0 };
  real work = 0, start = guess[0] * (real)c->T / c->L;
  if (guess[1] == 0 && guess[0] != 0)
    start = steady_from_rest(&s, &p);
  steady_find(&s, start, steady_bound(&s), &p, &ignored);
  period_sum_up(&s, &p);
  steady_find_from_level(&s, &p, &ignored);
  for (int kind = 0; kind < 2; kind++)
    work += (c->F1 * p.phase[kind].path[0] + c->F2 * p.phase[kind].path[1]) * c->L;
  *out = (struct scallop_wide_steady){
    .froude = split(1 / s.eps),
    .mean_velocity = split(p.travel * c->L / c->T),
    .friction_work = split(work),
    .cost_of_transport = split(p.travel == 0 ? NAN : work / (((real)c->F1 + c->F2) * (magnitude(p.travel) * c->L))),
    .period = told(c, &s, &p)
  };
}

const struct wide_solver WIDE = { wide_phase, wide_period, wide_steady };
