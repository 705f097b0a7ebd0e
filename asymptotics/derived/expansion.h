/* What is derived and proven about the series of a motion, coefficient by coefficient; and formulas in balls. Needs
 * FLINT.
 *
 * At fixed crawler and start velocity, a quantity of a motion is a series in T: of one phase in powers of the duration
 * of the phase, of the steady state in powers of the period. Each coefficient comes from the equations of motion alone,
 * to any order. It is an exact fraction where the gait has rational coefficients (scallop_gait_is_rational: the
 * quadratic one has, the sinusoidal one has not), and a ball that encloses it elsewhere; SCALLOP_STEADY_FRICTION_WORK
 * is always in balls. docs/background/theory.md has the derivation.
 *
 *     struct scallop_series *series;
 *     fmpq_t coefficient;
 *     if (scallop_series_of_steady(&series, &crawler, 10, 128, &why) == SCALLOP_OK) {
 *       if (scallop_series_rational(coefficient, series, SCALLOP_STEADY_DISPLACEMENT, 2)) ...
 *       scallop_series_free(series);
 *     }
 *
 * The series says what happens for T -> 0, up to where the sequence of modes changes: compare scallop_series_modes with
 * the modes that an exact solution has at your T. Nothing here prints or holds state; series and read formulas may be
 * used by several threads at a time.
 */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_EXPANSION_H
#define SCALLOP_ASYMPTOTICS_DERIVED_EXPANSION_H

#include "asymptotics/asymptotics.h"
#include "model/exact/ball.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The series of all quantities of one motion. What it is made of is private: a later library may keep more. */
struct scallop_series;

/* Derives all coefficients below T^order, 1 <= order <= 1000, of one phase from start velocity v0 (0: from rest), or of
 * the steady state. Balls have `precision` bits, 16 or more, less what is lost on the way: ask for twice as many as are
 * needed, and look at their radii. T of the crawler is not used, nor is alpha for a phase. *series becomes a new one,
 * to be freed by scallop_series_free.
 *
 * Failures leave *series as it was; *why, if why is not NULL, becomes a sentence in static text. SCALLOP_EDOMAIN: an
 * argument outside its domain, a gait without exact law, or one for which no series in powers of T exists: l' is 0 or
 * changes its sign within a phase, or l'' = 0 where a phase begins or ends. Of the steady state also
 * SCALLOP_EUNDECIDED: for T -> 0 a body touches v = 0 without turning, or is too close to that for this precision. */
enum scallop_status scallop_series_of_phase(struct scallop_series **series,
                                            const struct scallop_rational_crawler *crawler,
                                            enum scallop_phase_kind kind, const fmpq_t v0, slong order, slong precision,
                                            const char **why);
enum scallop_status scallop_series_of_steady(struct scallop_series **series,
                                             const struct scallop_rational_crawler *crawler, slong order,
                                             slong precision, const char **why);
void scallop_series_free(struct scallop_series *series); /* which may be NULL */

/* The coefficient of T^power, for any power below the order; negative ones too: v_start and v_mid begin with T^-1. Of a
 * phase there are the quantities of SCALLOP_QUANTITY_LIST from dT to v_at_last, of the steady state those from v_start
 * on; of a phase in which the mode does not change none that belongs to a switching time. Units: that of the quantity
 * over that of T^power.
 *
 * rational: false, and coefficient stays, where it is no known fraction (or scallop_series_ball returns false). A
 * coefficient among balls that is proven to be 0 is the fraction 0. ball: false, and coefficient stays: the motion has
 * no such quantity, or power is not below the order. */
bool scallop_series_rational(fmpq_t coefficient, const struct scallop_series *series, enum scallop_quantity quantity,
                             slong power);
bool scallop_series_ball(arb_t coefficient, const struct scallop_series *series, enum scallop_quantity quantity,
                         slong power);

/* The power of the first term, below which all coefficients are 0; the order, if there is none, or no such quantity. */
slong scallop_series_first(const struct scallop_series *series, enum scallop_quantity quantity);

/* The modes for T -> 0: "++ -+ ++" of a phase, "++ -+ ++ | ++ +- ++" of the steady state. The text lives as long as the
 * series. */
const char *scallop_series_modes(const struct scallop_series *series);

/* Encloses the value of a formula, with `precision` bits (2 or more) in each operation; numbers and parameters are
 * exactly what is written. T of the crawler is the period, of a phase too. given: three balls, t1, dT and x_switch, or
 * NULL: none is given. kind, v0 and given are not looked at by a formula of the steady state. A value that is not
 * finite (arb_is_finite): a quotient, power or function whose argument may be outside its domain, a symbol that was not
 * given, or L_kin where l'' = 0 at both ends of the phase. SCALLOP_EDOMAIN, and value stays: a parameter outside its
 * domain, T and the precision too, or a gait without exact law. */
enum scallop_status scallop_formula_ball(arb_t value, const struct scallop_read_formula *read,
                                         const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind,
                                         const fmpq_t v0, arb_srcptr given, slong precision);

#ifdef __cplusplus
}
#endif

#endif
