/* The expansions that the paper should have: derived here, to any order, for any crawler and any gait whose pieces
 * are analytic, with exact rational coefficients where gait and parameters are rational and balls elsewhere.
 *
 * Switching times are roots of "velocity of a body = 0"; each is found by Newton's method in truncated series
 * arithmetic. docs/theory.md has the derivation. Never looks at numerics/: the two routes meet in compare/ and in
 * the tests. Needs FLINT; prints nothing, holds no state.
 */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_DERIVED_H
#define SCALLOP_ASYMPTOTICS_DERIVED_DERIVED_H

#include "asymptotics/asymptotics.h"
#include "asymptotics/derived/series.h"
#include "model/exact/ball.h"

enum { SCALLOP_MOST_TERMS = 1000, SCALLOP_BRANCH_TEXT = 120 };

/* One phase from start velocity v0, in powers of T, the duration of the phase, at fixed v0. */
struct scallop_phase_expansion {
  bool switches; /* false: the mode never changes, and t1, dT, at_first, at_last are 0              */
  struct series t1, dT;
  struct series v_end;
  struct series dx1, dx2, dxC;
  struct series at_first, at_last; /* the rear body, from its start, at the first and the last change of mode */
  struct series turning_velocity;  /* of the body that turns there: 0                                    */
  char modes[SCALLOP_BRANCH_TEXT]; /* for T -> 0, as in "++ -+ ++"                                    */
};
#define PHASE_EXPANSION(of) \
  of(series, &s->t1) of(series, &s->dT) of(series, &s->v_end) of(series, &s->dx1) of(series, &s->dx2) \
      of(series, &s->dxC) of(series, &s->at_first) of(series, &s->at_last) of(series, &s->turning_velocity)
SCOPED_PARTS(scallop_phase_expansion, struct scallop_phase_expansion, PHASE_EXPANSION)

/* All coefficients below T^order, 1 <= order <= SCALLOP_MOST_TERMS; balls have `precision` bits, less what is lost. T
 * and alpha of the crawler are not used. pi_squared: NULL, or a rational number that takes the place of pi^2 in a
 * sinusoidal gait, which makes its coefficients exact: for proving identities (see model/exact/ball.h).
 * SCALLOP_EDOMAIN: an argument outside its domain, l' that is 0 or changes its sign within a phase, or l'' = 0 where a
 * phase begins or ends, so that the switching times go as fractional powers of T. *why (may be NULL) says which. */
enum scallop_status scallop_expand_phase(const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind,
                                         const fmpq_t v0, slong order, slong precision, const fmpq_t pi_squared,
                                         struct scallop_phase_expansion *expansion, const char **why);

/* The steady state, in powers of the period T. */
struct scallop_steady_expansion {
  struct series v_start, v_mid; /* odd powers from T^-1 on: the first coefficient is the limit U of v_start T */
  struct series displacement;   /* of the geometric centre; even powers, and for reversible gaits only those of T^4
                                          unless alpha = 1/2                                               */
  struct series mean_velocity;  /* displacement / T                                                    */
  struct series friction_work;  /* sum over the bodies of F_i times how far body i slides; powers as displacement */
  char modes[2 * SCALLOP_BRANCH_TEXT]; /* for T -> 0, as in "++ -+ ++ | ++ +- ++"                   */
};
#define STEADY_EXPANSION(of) \
  of(series, &s->v_start) of(series, &s->v_mid) of(series, &s->displacement) of(series, &s->mean_velocity) \
      of(series, &s->friction_work)
SCOPED_PARTS(scallop_steady_expansion, struct scallop_steady_expansion, STEADY_EXPANSION)

/* All coefficients below T^order. SCALLOP_EDOMAIN as above; SCALLOP_EUNDECIDED: in the limit a body touches v = 0
 * without turning, where no power series exists, or is too close to that for this precision. */
enum scallop_status scallop_expand_steady(const struct scallop_rational_crawler *crawler, slong order, slong precision,
                                          struct scallop_steady_expansion *expansion, const char **why);

/* The expansion of one of the quantities that the formulas are about, of the right setting; NULL if there is none, as
 * of switching times where no body turns. */
const struct series *scallop_phase_quantity(const struct scallop_phase_expansion *e, enum scallop_phase_kind kind,
                                            enum scallop_quantity quantity);
const struct series *scallop_steady_quantity(const struct scallop_steady_expansion *e, enum scallop_quantity quantity);

struct scallop_bound { /* |exact - terms below T^order| <= C T^power for 0 < T <= T0                */
  int power;
  arb_t C, T0;      /* upper end of C and lower end of T0 are meant                              */
  arb_t T_end;      /* up to here the modes are those of T -> 0                                  */
  const char *ends; /* what happens there, or why the proof stops (static text)                  */
};
void scallop_bound_init(struct scallop_bound *b);
void scallop_bound_clear(struct scallop_bound *b);

/* Bounds for v_start and displacement of the steady state, both from one proof: [0] and [1]. order >= 1.
 * Statuses as scallop_expand_steady; SCALLOP_EDOMAIN also where the start velocity is 0 in the limit (alpha = 1/2). */
enum scallop_status scallop_steady_bounds(const struct scallop_rational_crawler *crawler, slong order, slong precision,
                                          struct scallop_bound bounds[2], const char **why);

/* That bound's T_end alone: for every T from 0 to there the steady state is proven to have the modes of T -> 0; T is
 * the lower end. Some thousandths below where they end. Statuses as scallop_expand_steady. */
enum scallop_status scallop_steady_modes_hold(const struct scallop_rational_crawler *crawler, slong precision, arb_t T,
                                              const char **ends, const char **why);

#endif
