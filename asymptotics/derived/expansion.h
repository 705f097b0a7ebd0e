/* Derived series of a motion, with proven coefficients; and formulas in balls. Needs FLINT.
 *
 * At fixed crawler and start velocity, a quantity of a motion is a series in T: of one phase in powers of the duration
 * of the phase, of the steady state in powers of the period. Each coefficient is derived from the equations of motion
 * alone, to any order. It is an exact fraction if the gait has rational coefficients (scallop_gait_is_rational: true
 * for the quadratic gait, false for the sinusoidal one), otherwise a ball that encloses it;
 * SCALLOP_STEADY_FRICTION_WORK is always in balls. docs/background/theory.md has the derivation.
 *
 *     struct scallop_series *series;
 *     fmpq_t coefficient;
 *     if (scallop_series_of_steady(&series, &crawler, 10, 128, &why) == SCALLOP_OK) {
 *       if (scallop_series_rational(coefficient, series, SCALLOP_STEADY_DISPLACEMENT, 2)) ...
 *       scallop_series_free(series);
 *     }
 *
 * The series describes the motion for T -> 0, up to the first change of the sequence of modes: compare
 * scallop_series_modes with the modes of an exact solution at your T. The functions print nothing and have no state;
 * several threads may use series and read formulas at a time. */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_EXPANSION_H
#define SCALLOP_ASYMPTOTICS_DERIVED_EXPANSION_H

#include "asymptotics/asymptotics.h"
#include "model/exact/ball.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The series of all quantities of one motion. Its members are private, and may change in a later library. */
struct scallop_series;

/* Derives all coefficients below T^order, 1 <= order <= 1000, of one phase from start velocity v0 (0: from rest). Balls
 * have `precision` bits, 16 or more, less cancellation: request twice the bits that you need, and check the radii. T of
 * the crawler is not used, nor is alpha for a phase. *series becomes a new one; the caller frees it by
 * scallop_series_free.
 *
 * On failure *series is unchanged; *why, if why is not NULL, becomes a sentence in static text. SCALLOP_EDOMAIN: an
 * argument outside its domain, a gait without exact law, or a gait for which no series in powers of T exists: l' is 0
 * or changes its sign within a phase, or l'' = 0 at the start or the end of a phase. */
enum scallop_status scallop_series_of_phase(struct scallop_series **series,
                                            const struct scallop_rational_crawler *crawler,
                                            enum scallop_phase_kind kind, const fmpq_t v0, slong order, slong precision,
                                            const char **why);
/* Derives all coefficients of the steady state in the same way; also SCALLOP_EUNDECIDED: for T -> 0 a body touches v =
 * 0 without reversing, or is too close to that for this precision. */
enum scallop_status scallop_series_of_steady(struct scallop_series **series,
                                             const struct scallop_rational_crawler *crawler, slong order,
                                             slong precision, const char **why);
void scallop_series_free(struct scallop_series *series); /* NULL is allowed */

/* Computes the coefficient of T^power, for any power below the order, including negative ones: v_start and v_mid begin
 * with T^-1. A phase has the quantities of SCALLOP_QUANTITY_LIST from dT to v_at_last, the steady state those from
 * v_start on; a phase without changes of mode has no quantity of a switching time. The unit is the quantity's over
 * T^power.
 *
 * Returns false, with coefficient unchanged, if it is not a known fraction (or scallop_series_ball returns false). A
 * coefficient among balls that is proven to be 0 is the fraction 0. */
bool scallop_series_rational(fmpq_t coefficient, const struct scallop_series *series, enum scallop_quantity quantity,
                             slong power);
/* Encloses this coefficient. Returns false, with coefficient unchanged, if the motion has no such quantity, or power is
 * not below the order. */
bool scallop_series_ball(arb_t coefficient, const struct scallop_series *series, enum scallop_quantity quantity,
                         slong power);

/* Returns the power of the first term: all lower coefficients are 0. Returns the order if all are 0 or the quantity
 * does not exist. */
slong scallop_series_first(const struct scallop_series *series, enum scallop_quantity quantity);

/* Returns the modes for T -> 0: "++ -+ ++" of a phase, "++ -+ ++ | ++ +- ++" of the steady state. The text is valid as
 * long as the series. */
const char *scallop_series_modes(const struct scallop_series *series);

/* Encloses the value of a formula, with `precision` bits (2 or more) in each operation; numbers and parameters are
 * exactly as written. T of the crawler is the period, also for a phase. given: three balls, t1, dT and x_switch, or
 * NULL: not given. A formula of the steady state ignores kind, v0 and given. The value is not finite (arb_is_finite) if
 * the argument of a quotient, power or function may be outside its domain, a symbol is not given, or L_kin is used with
 * l'' = 0 at both ends of the phase. SCALLOP_EDOMAIN, with value unchanged: a parameter, T or the precision outside its
 * domain, or a gait without exact law. */
enum scallop_status scallop_formula_ball(arb_t value, const struct scallop_read_formula *read,
                                         const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind,
                                         const fmpq_t v0, arb_srcptr given, slong precision);

#ifdef __cplusplus
}
#endif

#endif
