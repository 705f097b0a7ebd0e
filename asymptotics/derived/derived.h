/* The correct expansions, derived to any order, for any crawler and any gait with analytic pieces, with exact rational
 * coefficients if gait and parameters are rational, otherwise in balls.
 *
 * Switching times are roots of "velocity of a body = 0"; each is found by Newton's method in truncated series
 * arithmetic. docs/background/theory.md has the derivation. Independent of numerics/: the two methods are compared in
 * compare/ and in the tests. Needs FLINT; prints nothing, has no state. */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_DERIVED_H
#define SCALLOP_ASYMPTOTICS_DERIVED_DERIVED_H

#include "asymptotics/asymptotics.h"
#include "asymptotics/derived/limit.h"
#include "model/exact/ball.h"

/* One phase from start velocity v0, in powers of its duration T, at fixed v0; or the steady state, in powers of the
 * period T. There v_start and v_mid have odd powers from T^-1 on, with the limit U of v_start T as first coefficient.
 * displacement and friction_work (the sum over the bodies of F_i times the sliding distance of body i) have even
 * powers; the displacement of a reversible gait has only powers of T^4 unless alpha = 1/2. */
#define SCALLOP_EXPANSION_OF(word, NAME) struct series word;
struct scallop_expansion {
  union {
    struct series of[SCALLOP_QUANTITIES + 2]; /* series_is_unknown: the motion has no such quantity */
    struct {                                  /* the series by name */
      SCALLOP_QUANTITY_LIST(SCALLOP_EXPANSION_OF)
      struct series dx1, dx2; /* of bodies 1 and 2, whichever is the rear one */
    };
  };
  bool switches;   /* true: a body turns; false: the motion has no switching times */
  char modes[240]; /* for T -> 0: "++ -+ ++", or "++ -+ ++ | ++ +- ++" of the steady state */
};
void scallop_expansion_init(struct scallop_expansion *e);
void scallop_expansion_clear(struct scallop_expansion *e);
SCOPED_KIND(scallop_expansion, struct scallop_expansion)
/* Returns the series of a quantity; NULL if it does not exist, for instance switching times if no body turns. */
const struct series *scallop_expansion_of(const struct scallop_expansion *e, enum scallop_quantity quantity);

/* Expand one phase: all coefficients below T^order, 1 <= order <= SCALLOP_MOST_TERMS; balls have `precision` bits, less
 * cancellation. T and alpha of the crawler are not used. pi_squared: NULL, or a rational substitute for pi^2 in a
 * sinusoidal gait: its coefficients are then exact, to prove identities (see model/exact/ball.h). SCALLOP_EDOMAIN: an
 * argument outside its domain, l' that is 0 or changes its sign within a phase, or l'' = 0 at the start or the end of a
 * phase: the switching times are then fractional powers of T. *why (may be NULL) is the reason. */
enum scallop_status scallop_expand_phase(const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind,
                                         const fmpq_t v0, slong order, slong precision, const fmpq_t pi_squared,
                                         struct scallop_expansion *expansion, const char **why);
/* Expands the steady state. SCALLOP_EDOMAIN as above; SCALLOP_EUNDECIDED: in the limit a body touches v = 0 without
 * turning, and no power series exists, or is too close to that for this precision. */
enum scallop_status scallop_expand_steady(const struct scallop_rational_crawler *crawler, slong order, slong precision,
                                          struct scallop_expansion *expansion, const char **why);

/* Computes the expansion of a phase from its branch: as scallop_expand_phase. c, at the start, and eps as for
 * lift_phase; v_change is relative to v0. */
bool expand_branch(struct scallop_expansion *e, struct branch *b, const struct phase_series *p, const struct series *c,
                   const struct series *eps, const struct series *v0, const struct ring *ring);

struct scallop_bound { /* |exact - terms below T^order| <= C T^power for 0 < T <= T0                */
  int power;
  arb_t C, T0;      /* valid with the upper end of C and the lower end of T0 */
  arb_t T_end;      /* up to here the modes are proven to be the modes of T -> 0 */
  const char *ends; /* the event there, or the reason why the proof stops (static text) */
};
#define SCALLOP_BOUND(of) of(arb, s->C) of(arb, s->T0) of(arb, s->T_end)
SCOPED_PARTS(scallop_bound, struct scallop_bound, SCALLOP_BOUND)

/* Bounds v_start and displacement of the steady state, both from one proof: [0] and [1]. order >= 1. Statuses as
 * scallop_expand_steady; SCALLOP_EDOMAIN also if the start velocity is 0 in the limit (alpha = 1/2). */
enum scallop_status scallop_steady_bounds(const struct scallop_rational_crawler *crawler, slong order, slong precision,
                                          struct scallop_bound bounds[2], const char **why);

/* Computes only T_end of this bound: for every T from 0 to the lower end of T the steady state is proven to have the
 * modes of T -> 0. It is a few thousandths below the end of these modes. Statuses as scallop_expand_steady. */
enum scallop_status scallop_steady_modes_hold(const struct scallop_rational_crawler *crawler, slong precision, arb_t T,
                                              const char **ends, const char **why);

#endif
