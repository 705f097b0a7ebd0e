/* The formulas of asymptotics.h as series in T, from their texts: with exact coefficients where the parameters
 * are, so that what a formula leaves out of the derived expansion is known term by term. Needs FLINT. */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_EVALUATE_H
#define SCALLOP_ASYMPTOTICS_DERIVED_EVALUATE_H

#include "asymptotics/asymptotics.h"
#include "asymptotics/derived/series.h"
#include "asymptotics/formula.h"
#include "model/exact/ball.h"

/* What the names in the texts stand for. T is the duration of the phase, or the period in the steady setting. */
struct scallop_symbols {
  struct series value[SCALLOP_SYMBOLS];
  struct names *names; /* NULL, or those in which the values are rational functions                    */
};
void scallop_symbols_init(struct scallop_symbols *s);
void scallop_symbols_clear(struct scallop_symbols *s);

/* All but t1, dT and x_switch, which the formulas that take them as given need and the caller sets. T is the variable
 * x; set it to a constant to evaluate at a point. v0 may be NULL (steady). pi_squared: as in model/exact/ball.h, or
 * NULL. */
void scallop_symbols_set(struct scallop_symbols *s, const struct scallop_rational_crawler *crawler,
                         enum scallop_phase_kind kind, const fmpq_t v0, const fmpq_t pi_squared,
                         const struct ring *ring);

/* Those that follow from others: T, l at both ends, and L_kin, of L, l0 and lT */
void scallop_symbols_complete(struct scallop_symbols *s, enum scallop_phase_kind kind, const struct ring *ring);

/* |l'| at time x after offset u of a piece, as a series in x: false where it is not exact. A sine is, at u = 0, in pi
 * up to SERIES_PI_TERMS terms, and in fractions with a number in the place of pi^2. */
bool scallop_exact_speed_series(struct series *speed, const struct scallop_piece *piece, const fmpq_t u,
                                const fmpq_t pi_squared, const struct ring *ring);
/* Likewise at the anchor, in balls where it is not exact. */
void scallop_speed_series(struct series *speed, const struct scallop_piece *piece, const fmpq_t pi_squared,
                          const struct ring *ring);

/* The formula for that phase. One that is printed for an extension is carried to a contraction by exchanging the
 * bodies. Returns NULL, or `message`: what a series cannot do and where in the text, or what is wrong with that. */
const char *scallop_formula_expand(struct series *value, const struct scallop_formula *formula,
                                   const struct scallop_symbols *s, enum scallop_phase_kind kind,
                                   const struct ring *ring, char message[FORMULA_MESSAGE]);

/* The value of a formula that was read, of the setting of `formula`, in balls: for the phase of this kind and duration
 * T, from v0, or for the period T of the steady state, where v0 is not looked at. given: t1, dT and x_switch, or NULL.
 * Not finite: it may have none there (arb_is_finite), or takes what is not given, or L_kin where l'' = 0 at both ends
 * of the phase. */
void scallop_formula_in_balls(arb_t value, const struct formula *read, const struct scallop_formula *formula,
                              const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind,
                              const fmpq_t v0, const fmpq_t T, arb_srcptr given, slong precision);

#endif
