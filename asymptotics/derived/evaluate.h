/* The formulas of asymptotics.h as series in T, from their texts, with exact coefficients for exact parameters: the
 * difference from the derived expansion is then known term by term. Needs FLINT. */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_EVALUATE_H
#define SCALLOP_ASYMPTOTICS_DERIVED_EVALUATE_H

#include "asymptotics/asymptotics.h"
#include "asymptotics/derived/series.h"
#include "asymptotics/formula.h"
#include "model/exact/ball.h"

/* Values of the names in the texts. T is the duration of the phase, or the period in the steady setting. */
struct scallop_symbols {
  struct series value[SCALLOP_SYMBOLS];
  struct names *names; /* NULL, or the names of which the values are rational functions */
};
void scallop_symbols_init(struct scallop_symbols *s);
void scallop_symbols_clear(struct scallop_symbols *s);

/* Sets all values except t1, dT and x_switch: the caller sets these for formulas that contain them. T is the variable
 * x; set it to a constant to evaluate at a point. v0: NULL in the steady state. pi_squared: see model/exact/ball.h. */
void scallop_symbols_set(struct scallop_symbols *s, const struct scallop_rational_crawler *crawler,
                         enum scallop_phase_kind kind, const fmpq_t v0, const fmpq_t pi_squared,
                         const struct ring *ring);

/* Sets the dependent values: T, l at both ends, and L_kin, from L, l0 and lT. */
void scallop_symbols_complete(struct scallop_symbols *s, enum scallop_phase_kind kind, const struct ring *ring);

/* Computes |l'| at time x after offset u of a piece, as a series in x; returns false if it is not exact. A sine is
 * exact at u = 0: in pi up to SERIES_PI_TERMS terms, and in fractions with a substitute for pi^2. */
bool scallop_exact_speed_series(struct series *speed, const struct scallop_piece *piece, const fmpq_t u,
                                const fmpq_t pi_squared, const struct ring *ring);

/* Expands the formula for this phase. A formula that is printed for an extension is converted to a contraction by
 * exchanging the bodies. Returns NULL, or `message`: the operation that a series does not allow and its place in the
 * text, or the mistake in the text. */
const char *scallop_formula_expand(struct series *value, const struct scallop_formula *formula,
                                   const struct scallop_symbols *s, enum scallop_phase_kind kind,
                                   const struct ring *ring, char message[FORMULA_MESSAGE]);

/* Evaluates a formula that was read, of the setting of `formula`, in balls: for the phase of this kind and duration T,
 * from v0, or for the period T of the steady state, independent of v0. given: t1, dT and x_switch, or NULL. The value
 * is not finite (arb_is_finite) if it may not exist, or depends on a value that is not given, or on L_kin with l'' = 0
 * at both ends. */
void scallop_formula_in_balls(arb_t value, const struct formula *read, const struct scallop_formula *formula,
                              const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind,
                              const fmpq_t v0, const fmpq_t T, arb_srcptr given, slong precision);

#endif
