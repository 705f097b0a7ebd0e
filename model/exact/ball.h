/* The crawler and the gait to any precision: parameters as exact rationals, l' in ball arithmetic and, if they exist,
 * with exact rational coefficients. The series of asymptotics/ and the certified solver of numerics/ are based on it.
 * Needs FLINT; allocates through it, prints nothing.
 *
 * Everything about a gait is in the units of model.h: phase duration 1, amplitude 1. u is an offset from the anchor of
 * a piece, speed is |l'|, and derivatives are with respect to time, not u. */
#ifndef SCALLOP_MODEL_EXACT_BALL_H
#define SCALLOP_MODEL_EXACT_BALL_H

#include "model/exact/flint.h"
#include "model/model.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A crawler with exact parameters */
struct scallop_rational_crawler {
  fmpq_t m1, m2, F1, F2, L, T, alpha; /* domains as in struct scallop_crawler */
  const struct scallop_gait *gait;
};

/* The parameters live from init to clear. */
void scallop_rational_init(struct scallop_rational_crawler *crawler);
void scallop_rational_clear(struct scallop_rational_crawler *crawler);
void scallop_rational_copy(struct scallop_rational_crawler *to, const struct scallop_rational_crawler *from);

/* Sets the parameters to the exact values of the doubles. Domain: finite. */
void scallop_rational_of(struct scallop_rational_crawler *exact, const struct scallop_crawler *crawler);

/* Sets x to the exact value of a finite double. */
void scallop_rational_set_double(fmpq_t x, double value);

/* Sets x to the exact value of a number in a text: 0.7 is 7/10, 1e-30 is 1/10^30, 0x1.8p-3 is 3/16. Accepts the
 * finite numbers of C's strtod; decimal exponents up to 10^5 in size. Returns false on any other text; x is then
 * unchanged. */
bool scallop_rational_parse(fmpq_t x, const char *text);

/* Returns true if m1, m2, F1, F2, L > 0, 0 < alpha < 1, and a gait is set; T is ignored. */
bool scallop_rational_is_valid(const struct scallop_rational_crawler *crawler);

/* Computes the fraction of the period that a phase takes: alpha or 1 - alpha. */
void scallop_rational_fraction(fmpq_t fraction, const struct scallop_rational_crawler *crawler,
                               enum scallop_phase_kind kind);
/* Computes the duration of a phase: alpha T or (1 - alpha) T. */
void scallop_rational_duration(fmpq_t duration, const struct scallop_rational_crawler *crawler,
                               enum scallop_phase_kind kind);

/* Returns true if every coefficient of l' is rational: series then have exact coefficients. */
bool scallop_gait_is_rational(const struct scallop_gait *gait);

void scallop_ball_begin(arb_t u, const struct scallop_piece *piece, slong precision); /* offset of the start */
void scallop_ball_end(arb_t u, const struct scallop_piece *piece, slong precision);   /* offset of the end */

/* Computes |l'| at offset u of a piece; any ball within [0, 1]. */
void scallop_ball_speed(arb_t speed, const struct scallop_piece *piece, const arb_t u, slong precision);
/* Computes d|l'|/dt there. */
void scallop_ball_rate(arb_t rate, const struct scallop_piece *piece, const arb_t u, slong precision);
/* Computes the integral of |l'| from offset u to offset v of a piece, in the direction from u to v in time: negative
 * if v is earlier. */
void scallop_ball_way(arb_t way, const struct scallop_piece *piece, const arb_t u, const arb_t v, slong precision);

/* Returns true if next, the following piece, continues the same analytic function: l' then has no corner between
 * them. |l'| at offset u of piece is |l'| at offset u of next or, with *turned, at 1 - u. */
bool scallop_piece_continues(const struct scallop_piece *piece, const struct scallop_piece *next, bool *turned);

/* Computes |l'| at time x after the time of offset u, as a series in x with `length` coefficients. */
void scallop_ball_speed_series(arb_poly_t series, const struct scallop_piece *piece, const arb_t u, slong length,
                               slong precision);
/* Compute |l'| and d|l'|/dt at a time after the time of offset u that is a series without a constant term. */
void scallop_ball_speed_along(arb_poly_t speed, arb_poly_t rate, const struct scallop_piece *piece, const arb_t u,
                              const arb_poly_t time, slong length, slong precision);
/* Computes |l'| with exact coefficients. A sinusoidal piece has them at u = 0 only, and as rational functions of
 * pi^2. The caller substitutes any rational number for pi^2: an identity between such series for random pi_squared
 * also holds for pi^2, because pi is transcendental. pi_squared may be NULL for polynomial pieces. Returns false if
 * no such coefficients exist. */
bool scallop_rational_speed_series(fmpq_poly_t series, const struct scallop_piece *piece, const fmpq_t u, slong length,
                                   const fmpq_t pi_squared);

#ifdef __cplusplus
}
#endif

#endif
