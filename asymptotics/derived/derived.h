/* The expansions that the paper should have: derived here, to any order, for any crawler and any gait whose pieces
 * are analytic, with exact rational coefficients where gait and parameters are rational and balls elsewhere.
 *
 * Switching times are roots of "velocity of a body = 0"; each is found by Newton's method in truncated series
 * arithmetic. docs/background/theory.md has the derivation. Never looks at numerics/: the two routes meet in compare/
 * and in the tests. Needs FLINT; prints nothing, holds no state.
 */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_DERIVED_H
#define SCALLOP_ASYMPTOTICS_DERIVED_DERIVED_H

#include "asymptotics/asymptotics.h"
#include "asymptotics/derived/limit.h"
#include "model/exact/ball.h"

/* One phase from start velocity v0, in powers of T, the duration of the phase, at fixed v0; or the steady state, in
 * powers of the period T: there v_start and v_mid have odd powers from T^-1 on, the first coefficient being the limit U
 * of v_start T, and displacement and friction_work (the sum over the bodies of F_i times how far body i slides) even
 * ones, for reversible gaits of the displacement only those of T^4 unless alpha = 1/2. */
#define SCALLOP_EXPANSION_OF(word, NAME) struct series word;
struct scallop_expansion {
  union {
    struct series of[SCALLOP_QUANTITIES + 2]; /* series_is_unknown: the motion has no such quantity */
    struct {                                  /* the same by their words */
      SCALLOP_QUANTITY_LIST(SCALLOP_EXPANSION_OF)
      struct series dx1, dx2; /* of the bodies, whichever is the rear one */
    };
  };
  bool switches;   /* whether a body turns; otherwise there are no switching times */
  char modes[240]; /* for T -> 0, as in "++ -+ ++", or "++ -+ ++ | ++ +- ++" of the steady state */
};
void scallop_expansion_init(struct scallop_expansion *e);
void scallop_expansion_clear(struct scallop_expansion *e);
SCOPED_KIND(scallop_expansion, struct scallop_expansion)
/* NULL where there is none, as of switching times where no body turns */
const struct series *scallop_expansion_of(const struct scallop_expansion *e, enum scallop_quantity quantity);

/* All coefficients below T^order, 1 <= order <= SCALLOP_MOST_TERMS; balls have `precision` bits, less what is lost. T
 * and alpha of the crawler are not used. pi_squared: NULL, or a rational number that takes the place of pi^2 in a
 * sinusoidal gait, which makes its coefficients exact: for proving identities (see model/exact/ball.h).
 * SCALLOP_EDOMAIN: an argument outside its domain, l' that is 0 or changes its sign within a phase, or l'' = 0 where a
 * phase begins or ends, so that the switching times go as fractional powers of T. *why (may be NULL) says which. */
enum scallop_status scallop_expand_phase(const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind,
                                         const fmpq_t v0, slong order, slong precision, const fmpq_t pi_squared,
                                         struct scallop_expansion *expansion, const char **why);
/* SCALLOP_EDOMAIN as above; SCALLOP_EUNDECIDED: in the limit a body touches v = 0 without turning, where no power
 * series exists, or is too close to that for this precision. */
enum scallop_status scallop_expand_steady(const struct scallop_rational_crawler *crawler, slong order, slong precision,
                                          struct scallop_expansion *expansion, const char **why);

/* What a phase does, from what its limit has: as scallop_expand_phase. c, at the start, and eps as for lift_phase; v0
 * is what v_change leaves out. */
bool expand_branch(struct scallop_expansion *e, struct branch *b, const struct phase_series *p, const struct series *c,
                   const struct series *eps, const struct series *v0, const struct ring *ring);

struct scallop_bound { /* |exact - terms below T^order| <= C T^power for 0 < T <= T0                */
  int power;
  arb_t C, T0;      /* upper end of C and lower end of T0 are meant                              */
  arb_t T_end;      /* up to here the modes are those of T -> 0                                  */
  const char *ends; /* what happens there, or why the proof stops (static text)                  */
};
#define SCALLOP_BOUND(of) of(arb, s->C) of(arb, s->T0) of(arb, s->T_end)
SCOPED_PARTS(scallop_bound, struct scallop_bound, SCALLOP_BOUND)

/* Bounds for v_start and displacement of the steady state, both from one proof: [0] and [1]. order >= 1.
 * Statuses as scallop_expand_steady; SCALLOP_EDOMAIN also where the start velocity is 0 in the limit (alpha = 1/2). */
enum scallop_status scallop_steady_bounds(const struct scallop_rational_crawler *crawler, slong order, slong precision,
                                          struct scallop_bound bounds[2], const char **why);

/* That bound's T_end alone: for every T from 0 to there the steady state is proven to have the modes of T -> 0; T is
 * the lower end. Some thousandths below where they end. Statuses as scallop_expand_steady. */
enum scallop_status scallop_steady_modes_hold(const struct scallop_rational_crawler *crawler, slong precision, arb_t T,
                                              const char **ends, const char **why);

#endif
