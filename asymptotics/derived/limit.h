/* The limit T -> 0 of the steady state, and the steady state as a series around it. Not public: derived.h is.
 *
 * In units of L and of the period, the start velocity w = v_start T/L and the displacement over L are functions of
 * eps = T^2 (F1 + F2)/(M L) alone. At eps = 0 the centre of mass moves with constant velocity w, determined by a zero
 * friction impulse over a period: the sum over the phases of fraction times balance. */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_LIMIT_H
#define SCALLOP_ASYMPTOTICS_DERIVED_LIMIT_H

#include "asymptotics/derived/branch.h"

struct limit {
  struct phase_constants phase[2];
  struct branch branch[2];
  struct series w; /* a constant: exact, or a ball                                          */
  bool at_rest;    /* F1 = F2: c = 0 throughout, at every eps                               */
  bool returns;    /* the displacement is 0 at every eps: F1 = F2, or phases that mirror each other */
  bool even;       /* the displacement is an even function of eps (docs/background/theory.md)          */
};
#define LIMIT_PARTS(of) \
  of(phase_constants, &s->phase[0]) of(phase_constants, &s->phase[1]) of(branch, &s->branch[0]) \
      of(branch, &s->branch[1]) of(series, &s->w)
SCOPED_PARTS(limit, struct limit, LIMIT_PARTS)
void limit_set(struct limit *to, const struct limit *from);

/* Finds the limit. Returns SCALLOP_OK; SCALLOP_EDOMAIN if not_expandable, or if no power series exists;
 * SCALLOP_EUNDECIDED if c touches a curve. *why is the reason, unless why is NULL. */
enum scallop_status limit_find(struct limit *l, const struct scallop_rational_crawler *crawler, slong precision,
                               const char **why);

/* Returns true if l' is linear at each crossing: times and velocities are then linear in the velocity at the start. */
bool limit_is_linear(const struct limit *l);

struct steady_lift {
  struct series w, w_mid, travel; /* as functions of eps = eps0 + x */
  struct lift phase[2];
};
#define STEADY_LIFT(of) \
  of(series, &s->w) of(series, &s->w_mid) of(series, &s->travel) of(lift, &s->phase[0]) of(lift, &s->phase[1])
SCOPED_PARTS(steady_lift, struct steady_lift, STEADY_LIFT)
/* Expands the steady state in x, from l->w and the branches' offsets at the base point. eps: the series eps0 + x, or
 * any other in x. phases: NULL, or substitutes for l->phase; l->w is then in their units. */
bool steady_lift(struct steady_lift *s, struct limit *l, const struct phase_series *const phases[2],
                 const struct series *eps, const struct ring *ring);

/* Expands s->w alone. */
bool steady_lift_start(struct steady_lift *s, struct limit *l, const struct phase_series *const phases[2],
                       const struct series *eps, const struct ring *ring);

/* Computes the energy dissipated by friction in a period, in units of (F1 + F2) L. s: the result of steady_lift for l,
 * unless l->at_rest. */
void steady_friction_work(struct series *work, const struct limit *l, const struct steady_lift *s,
                          const struct series *eps, const struct ring *ring);

/* Follows the limit in balls: encloses w and the crossings of every eps in the ball. w: on input a place near it.
 * Returns false, with the branches unchanged, if they were not found. */
bool limit_follow(struct limit *l, arb_t w, const arb_t eps, slong precision);

/* Proves that a motion has the modes of the branches, for every eps and the start velocities w and w_mid of the two
 * phases within the balls, with crossings enclosed by the branches' offsets: between its crossings c stays off the
 * curves, and at each it passes through the curve. Returns NULL, or the reason of a failure (static text): near the end
 * of a branch, the event there. */
const char *limit_holds(const struct limit *l, const arb_t w, const arb_t w_mid, const arb_t eps, slong precision);

#endif
