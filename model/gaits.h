/* Gaits made to measure: trapezoidal, skewed, constant, polynomial, and splines through data. The doubles of a law
 * define its gait exactly (struct scallop_law), so that solvers of every precision solve for the same gait.
 *
 * The caller gives the memory. A gait points into it, so that it must neither move nor change while the gait is used.
 * SCALLOP_EDOMAIN: the numbers make no gait, and the memory holds none.
 */
#ifndef SCALLOP_MODEL_GAITS_H
#define SCALLOP_MODEL_GAITS_H

#include "model/model.h"

#ifdef __cplusplus
extern "C" {
#endif

/* one + up (what |l'| rises for) + down (what it falls for), as fractions of a phase */
struct scallop_straight_form {
  double one, up, down;
};
/* What the doubles of a piece are made from: where it begins and ends, and |l'| = (start + slope u)/(divisor mean). */
struct scallop_straight_line {
  struct scallop_straight_form begin, end;
  double start, slope;
  struct scallop_straight_form divisor, mean;
};

struct scallop_straight {
  struct scallop_gait gait;
  struct scallop_piece pieces[2][4];
  struct scallop_law laws[2][4];
  struct scallop_straight_line lines[2][4];
};

/* Each phase takes a fraction up[kind] of its duration to bring |l'| from 0 to V along a straight line, stays there,
 * and takes down[kind] to come back to 0: V = 1/(1 - up/2 - down/2), in units where the phase lasts 1 and the amplitude
 * is 1. Where the double nearest to up + down is 1 (0.1 and 0.9, say) there is nothing in between, and what falls takes
 * 1 - up; up = down = 1/2 is the quadratic gait. Domain: 2^-100 <= up, down and up < 1, up + down <= 1. name: is kept,
 * not copied. */
enum scallop_status scallop_make_trapezoidal(struct scallop_straight *straight, const char *name, const double up[2],
                                             const double down[2]);

/* l'' is constant for a fraction beta[kind] of each phase, and has another constant value for the rest: l is quadratic,
 * |l'| rises to 2 and falls. beta = 1/2 is the quadratic gait. Domain: 2^-100 <= beta <= 1 - 2^-53. */
enum scallop_status scallop_make_skewed(struct scallop_straight *straight, const char *name, const double beta[2]);

/* Trapezoidal with up = down = ramp[kind], the very same numbers; or, where ramp[kind] = 0, l' constant throughout the
 * phase: it jumps where that begins and ends, and the steady states of a crawler can then fill an interval
 * (SCALLOP_INTERVAL). Domain: 0, or 2^-100 <= ramp <= 1/2. */
enum scallop_status scallop_make_constant(struct scallop_straight *straight, const char *name, const double ramp[2]);

enum {
  SCALLOP_POLYNOMIAL_DEGREE = SCALLOP_LAW_MOST_DEGREE + 1,
  SCALLOP_POLYNOMIAL_PIECES = 2 * SCALLOP_POLYNOMIAL_DEGREE
};

struct scallop_polynomial {
  struct scallop_gait gait;
  struct scallop_piece pieces[2][SCALLOP_POLYNOMIAL_PIECES];
  struct scallop_law laws[SCALLOP_POLYNOMIAL_PIECES];
  double ways[SCALLOP_POLYNOMIAL_PIECES];
};

/* l = sum over k = 1, ..., degree of c[k] s^k / sum of c[k], s the part of the extension that has passed, and the same
 * back in the contraction; c[0] is not looked at. Minimum jerk is 0, 0, 10, -15, 6. The gait is that polynomial with
 * its Bernstein coefficients rounded to doubles. What half an ulp of each c[k] can change them to is taken for 0: so
 * slopes at the ends, which must be 0, are. Domain: 2 <= degree <= SCALLOP_POLYNOMIAL_DEGREE, c[1] = 0, sum of k c[k] =
 * 0 as far as half an ulp of each can tell, and the sum of c[k] at least a millionth of that of |c[k]|; l' must not
 * come so near to 0 between the ends that its sign there cannot be told from rounding. *why, which may be NULL: what is
 * wrong. */
enum scallop_status scallop_make_polynomial(struct scallop_polynomial *polynomial, const char *name, const double *c,
                                            int degree, const char **why);

/* A point of one phase: the part of the phase that has passed, from 0 to 1; l in units of the amplitude, which begins
 * and ends with 0 and 1 in the extension and with 1 and 0 in the contraction; dl/dtime. */
struct scallop_knot {
  double time, length, slope;
};

struct scallop_spline { /* laws and pieces for scallop_spline_pieces() of them, in the memory of the caller */
  struct scallop_gait gait;
  struct scallop_piece *pieces;
  struct scallop_law *laws;
};

/* time or length as a knot has it: the nearest multiple of 2^-53, so that differences are exact. For 0 <= x <= 1. */
double scallop_knot_round(double x);
/* At most as many pieces as a spline through count knots in each phase has. */
int scallop_spline_pieces(const int count[2]);

/* Whether l is monotone between two knots. Its slope is the quadratic with the Bernstein coefficients b0 = a's slope,
 * b1 = 3 (length gained)/(time passed) - b0 - b2, b2 = b's; it keeps its sign where b0 and b2 have it and, in size,
 * both are at most three times the mean slope (Fritsch & Carlson, SIAM J. Numer. Anal. 17, 1980), or b1^2 <= b0 b2. */
bool scallop_knots_are_monotone(const struct scallop_knot *a, const struct scallop_knot *b);

/* The cubic Hermite spline through count[kind] >= 2 knots of each phase. Between knots of equal length l rests: a piece
 * with direction 0. Domain: times and lengths are multiples of 2^-53, times increase, first and last knots are as above
 * and have slope 0, lengths are within [0, 1], and between two knots l is monotone. */
enum scallop_status scallop_make_spline(struct scallop_spline *spline, const char *name,
                                        const struct scallop_knot *const knots[2], const int count[2]);

#ifdef __cplusplus
}
#endif

#endif
