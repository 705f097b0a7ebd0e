/* Parametrised gaits: trapezoidal, skewed, constant, polynomial, and splines through data. The doubles of a law define
 * the gait exactly (struct scallop_law): solvers of every precision solve for the same gait.
 *
 * The caller provides the memory. A gait points into it, therefore the memory must not move or change while the gait is
 * used. SCALLOP_EDOMAIN: the numbers define no gait, and the memory is unspecified. */
#ifndef SCALLOP_MODEL_GAITS_H
#define SCALLOP_MODEL_GAITS_H

#include "model/model.h"

#ifdef __cplusplus
extern "C" {
#endif

/* one + up (the rise of |l'|) + down (its fall), as fractions of a phase */
struct scallop_straight_form {
  double one, up, down;
};
/* Inputs of the doubles of a piece: its begin and end, and |l'| = (start + slope u)/(divisor mean). */
struct scallop_straight_line {
  struct scallop_straight_form begin, end;
  double start, slope;
  struct scallop_straight_form divisor, mean;
};

/* Memory for a gait with piecewise linear |l'| */
struct scallop_straight {
  struct scallop_gait gait;
  struct scallop_piece pieces[2][4];
  struct scallop_law laws[2][4];
  struct scallop_straight_line lines[2][4];
};

/* Makes a trapezoidal gait. In each phase |l'| rises linearly from 0 to V during the fraction up[kind] of the
 * duration, stays at V, and falls linearly to 0 during down[kind]: V = 1/(1 - up/2 - down/2), in units of the phase
 * and the amplitude. If the double nearest to up + down is 1 (for instance 0.1 and 0.9), |l'| has no constant part
 * and falls during 1 - up; up = down = 1/2 is the quadratic gait. Domain: 2^-100 <= up, down and up < 1, up + down
 * <= 1. name: kept, not copied. */
enum scallop_status scallop_make_trapezoidal(struct scallop_straight *straight, const char *name, const double up[2],
                                             const double down[2]);

/* Makes a skewed gait: l'' is constant during a fraction beta[kind] of each phase, and has another constant value in
 * the rest. |l'| rises to 2 and falls to 0. beta = 1/2 is the quadratic gait. Domain: 2^-100 <= beta <= 1 - 2^-53. */
enum scallop_status scallop_make_skewed(struct scallop_straight *straight, const char *name, const double beta[2]);

/* Makes a trapezoidal gait with up = down = ramp[kind], with the same doubles; ramp[kind] = 0: l' is constant
 * throughout the phase and jumps at its ends, and the steady states of a crawler can fill an interval
 * (SCALLOP_INTERVAL). Domain: 0, or 2^-100 <= ramp <= 1/2. */
enum scallop_status scallop_make_constant(struct scallop_straight *straight, const char *name, const double ramp[2]);

enum {
  SCALLOP_POLYNOMIAL_DEGREE = SCALLOP_LAW_MOST_DEGREE + 1,
  SCALLOP_POLYNOMIAL_PIECES = 2 * SCALLOP_POLYNOMIAL_DEGREE
};

/* Memory for a polynomial gait */
struct scallop_polynomial {
  struct scallop_gait gait;
  struct scallop_piece pieces[2][SCALLOP_POLYNOMIAL_PIECES];
  struct scallop_law laws[SCALLOP_POLYNOMIAL_PIECES];
  double ways[SCALLOP_POLYNOMIAL_PIECES];
};

/* Makes l = sum over k = 1, ..., degree of c[k] s^k / sum of c[k], s the elapsed fraction of the extension, reversed in
 * the contraction; c[0] is ignored. Minimum jerk is 0, 0, 10, -15, 6. The gait is this polynomial with its Bernstein
 * coefficients rounded to doubles. A coefficient that half an ulp of each c[k] can change to 0 is set to 0, in
 * particular the slopes at the ends. Domain: 2 <= degree <= SCALLOP_POLYNOMIAL_DEGREE; c[1] = 0; sum of k c[k] = 0 to
 * half an ulp of each c[k]; sum of c[k] >= 1e-6 sum of |c[k]|; rounding must not hide the sign of l' between the ends.
 * *why, if why is not NULL: the reason of a failure. */
enum scallop_status scallop_make_polynomial(struct scallop_polynomial *polynomial, const char *name, const double *c,
                                            int degree, const char **why);

/* A point of one phase: the elapsed fraction of the phase, from 0 to 1; l in units of the amplitude, from 0 to 1 in
 * the extension and from 1 to 0 in the contraction; dl/dtime. */
struct scallop_knot {
  double time, length, slope;
};

/* Memory for a spline; the caller provides arrays of scallop_spline_pieces() pieces and laws. */
struct scallop_spline {
  struct scallop_gait gait;
  struct scallop_piece *pieces;
  struct scallop_law *laws;
};

/* Rounds a time or length 0 <= x <= 1 to the nearest multiple of 2^-53, as knots require: differences are then
 * exact. */
double scallop_knot_round(double x);
/* Returns an upper bound of the pieces of a spline through count[kind] knots in each phase. */
int scallop_spline_pieces(const int count[2]);

/* Returns true if l is monotone between two knots. Its slope is the quadratic with the Bernstein coefficients b0 = a's
 * slope, b1 = 3 (length gained)/(time passed) - b0 - b2, b2 = b's slope. The slope keeps its sign if b0 and b2 have
 * this sign, and either both are in size at most three times the mean slope (Fritsch & Carlson, SIAM J. Numer. Anal.
 * 17, 1980) or b1^2 <= b0 b2. */
bool scallop_knots_are_monotone(const struct scallop_knot *a, const struct scallop_knot *b);

/* Makes the cubic Hermite spline through count[kind] >= 2 knots of each phase. Between knots of equal length l
 * rests: a piece with direction 0. Domain: times and lengths are multiples of 2^-53; times increase; first and last
 * knots are as above and have slope 0; lengths are within [0, 1]; l is monotone between two knots. */
enum scallop_status scallop_make_spline(struct scallop_spline *spline, const char *name,
                                        const struct scallop_knot *const knots[2], const int count[2]);

#ifdef __cplusplus
}
#endif

#endif
