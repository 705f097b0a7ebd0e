/* The crawler and the gait again, with all their digits: parameters as exact rationals, l' in ball
 * arithmetic and, where it has them, with exact rational coefficients. Both routes that go beyond double
 * precision, the series of asymptotics/ and the certified solver of numerics/, start from here.
 * Needs FLINT; allocates through it, prints nothing.
 *
 * Everything about a gait is in the units of model.h: the phase lasts 1, the amplitude is 1. u is an offset
 * from the anchor of a piece, speed is |l'|, and derivatives are with respect to time, not u.
 */
#ifndef SCALLOP_MODEL_EXACT_BALL_H
#define SCALLOP_MODEL_EXACT_BALL_H

#include "model/exact/flint.h"
#include "model/model.h"

#ifdef __cplusplus
extern "C" {
#endif

struct scallop_rational_crawler {
  fmpq_t m1, m2, F1, F2, L, T, alpha; /* domains as in struct scallop_crawler */
  const struct scallop_gait *gait;
};

void scallop_rational_init(struct scallop_rational_crawler *crawler);
void scallop_rational_clear(struct scallop_rational_crawler *crawler);
void scallop_rational_copy(struct scallop_rational_crawler *to, const struct scallop_rational_crawler *from);

/* The very numbers that the doubles are. They must be finite. */
void scallop_rational_of(struct scallop_rational_crawler *exact, const struct scallop_crawler *crawler);

/* x becomes the double, exactly. It must be finite. */
void scallop_rational_set_double(fmpq_t x, double value);

/* x becomes the number that the text says, exactly: 0.7 is 7/10, 1e-30 is 1/10^30, 0x1.8p-3 is 3/16. Takes what
 * C's strtod takes for a finite number; decimal exponents up to 10^5 in size. False: anything else, and x stays. */
bool scallop_rational_parse(fmpq_t x, const char *text);

/* Whether m1, m2, F1, F2, L > 0, 0 < alpha < 1, and there is a gait; T is not looked at. */
bool scallop_rational_is_valid(const struct scallop_rational_crawler *crawler);

/* The fraction of the period and the duration of a phase: alpha and alpha T, or 1 - alpha and (1 - alpha) T. */
void scallop_rational_fraction(fmpq_t fraction, const struct scallop_rational_crawler *crawler,
                               enum scallop_phase_kind kind);
void scallop_rational_duration(fmpq_t duration, const struct scallop_rational_crawler *crawler,
                               enum scallop_phase_kind kind);

/* Whether every coefficient of l' is rational, so that series have exact coefficients. */
bool scallop_gait_is_rational(const struct scallop_gait *gait);

/* The offsets at which a piece begins and ends */
void scallop_ball_begin(arb_t u, const struct scallop_piece *piece, slong precision);
void scallop_ball_end(arb_t u, const struct scallop_piece *piece, slong precision);

/* |l'| and d|l'|/dt at offset u of a piece; any ball within [0, 1]. */
void scallop_ball_speed(arb_t speed, const struct scallop_piece *piece, const arb_t u, slong precision);
void scallop_ball_rate(arb_t rate, const struct scallop_piece *piece, const arb_t u, slong precision);
/* The integral of |l'| from offset u to offset v of a piece, in the direction from u to v in time: negative if v is
 * earlier. */
void scallop_ball_way(arb_t way, const struct scallop_piece *piece, const arb_t u, const arb_t v, slong precision);

/* Whether next, the piece that follows, goes on with the same analytic function, so that their meeting is no corner of
 * l'. Then |l'| at offset u of piece is that at offset u of next or, with *turned, at 1 - u. */
bool scallop_piece_goes_on(const struct scallop_piece *piece, const struct scallop_piece *next, bool *turned);

/* |l'| at time x after the one at offset u, as a series in x with `length` coefficients. */
void scallop_ball_speed_series(arb_poly_t series, const struct scallop_piece *piece, const arb_t u, slong length,
                               slong precision);
/* |l'| and d|l'|/dt where the time after the one at offset u is itself a series, without a constant term. */
void scallop_ball_speed_along(arb_poly_t speed, arb_poly_t rate, const struct scallop_piece *piece, const arb_t u,
                              const arb_poly_t time, slong length, slong precision);
/* |l'| with exact coefficients. A sinusoidal piece has them at u = 0 only, and as rational functions of pi^2,
 * which is then any rational number that the caller puts in its place: an identity between such series for
 * random pi_squared is one for pi^2, because pi is transcendental. pi_squared may be NULL for polynomial pieces.
 * False: there are no such coefficients. */
bool scallop_rational_speed_series(fmpq_poly_t series, const struct scallop_piece *piece, const fmpq_t u, slong length,
                                   const fmpq_t pi_squared);

#ifdef __cplusplus
}
#endif

#endif
