/* model/: definitions of crawler, gait and phase.
 *
 * Two bodies, masses m1 and m2, Coulomb friction forces F1 and F2 (isotropic, static = sliding), with the separation
 * l(t) = x2 - x1 prescribed and periodic. This folder has parameters, l(t) and its derivatives, validation and scaling,
 * and solves no motion. It prints nothing and has no state. The functions of this header and of gaits.h depend on libm
 * only and allocate nothing; ball.h and fractions.h have the same in balls and in fractions; FLINT allocates. */
#ifndef SCALLOP_MODEL_MODEL_H
#define SCALLOP_MODEL_MODEL_H

#include <stdbool.h>

#include "model/version.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Status of every call that can fail. Below zero: failed, with outputs unchanged unless the function states otherwise.
 * Above zero: done, with a remark. */
enum scallop_status {
  SCALLOP_OK = 0,
  SCALLOP_INTERVAL = 1,    /* the steady states fill an interval; both ends are returned   */
  SCALLOP_STOPPED = 2,     /* ended early at the caller's request; outputs hold the result up to there */
  SCALLOP_EDOMAIN = -1,    /* a parameter is outside its domain                            */
  SCALLOP_ERANGE = -2,     /* a scaled quantity overflows, or underflows and loses digits  */
  SCALLOP_ECONVERGE = -3,  /* an iteration did not converge */
  SCALLOP_EUNDECIDED = -4, /* not decided at the highest precision tried: the motion touches a boundary, or almost */
  SCALLOP_ESTOPPED = -5    /* ended early at the caller's request, without a result */
};
const char *scallop_status_text(enum scallop_status status); /* returns a constant text */

/* Phases: l grows by the amplitude in an extension, and shrinks by it in a contraction. */
enum scallop_phase_kind { SCALLOP_EXTENSION = 0, SCALLOP_CONTRACTION = 1 };

/* Origin of the time of a piece. Times near the end of a phase are kept as distances to that end: dT ~ T^3 (from rest)
 * would vanish in T - dT otherwise. */
enum scallop_anchor { SCALLOP_FROM_START = 0, SCALLOP_FROM_END = 1 };

struct scallop_piece;

/* l, l' and l'' in one piece at offset u from the anchor, in units of the phase's duration and the amplitude.
 * Derivatives are with respect to time (not u). */
struct scallop_curve {
  double (*length)(const struct scallop_piece *, double u);       /* l(u) - l(anchor)              */
  double (*velocity)(const struct scallop_piece *, double u);     /* l'(u)                         */
  double (*acceleration)(const struct scallop_piece *, double u); /* l''(u)                        */
  double (*when)(const struct scallop_piece *, double a);         /* u with l''(u) = a; nan: no such u */
  /* l' and l'' at once, if that is cheaper, else NULL; the same values as from the two functions above */
  void (*rates)(const struct scallop_piece *, double u, double *velocity, double *acceleration);
};

/* Exact |l'| of a piece as a function of the offset u, for solvers with more digits than a double; each double is taken
 * as exact. Polynomial: sum over k <= degree of c[k] u^k / denominator. */
enum { SCALLOP_LAW_MOST_DEGREE = 15 };
struct scallop_polynomial_law {
  double c[SCALLOP_LAW_MOST_DEGREE + 1], denominator;
};
/* Degree 1: (start + slope u) / (divisor (parts[0] + parts[1] + parts[2])). */
struct scallop_ramp_law {
  double start, slope, divisor, parts[3];
};
/* Bernstein form: sum over j <= degree of b[j] binomial(degree, j) x^j (1 - x)^(degree - j), with x = (u -
 * near)/(far - near). b[implied] is not stored but follows from the way, the integral of |l'| from near to far: (far
 * - near) times the mean of all b[j]. The way is way + more[0] + more[1] + ...: the ways of all pieces can then add
 * up to 1 exactly though each is accurate to its last digit. */
struct scallop_bernstein_law {
  double b[SCALLOP_LAW_MOST_DEGREE + 1];
  double near, far, way;
  int implied, more_count;
  const double *more;
};
/* Sine: (pi/2) sin(pi u). */
enum scallop_law_kind { SCALLOP_LAW_POLYNOMIAL, SCALLOP_LAW_SINE, SCALLOP_LAW_RAMP, SCALLOP_LAW_BERNSTEIN };
struct scallop_law {
  enum scallop_law_kind kind;
  int degree;
  union {
    struct scallop_polynomial_law polynomial;
    struct scallop_ramp_law ramp;
    struct scallop_bernstein_law bernstein;
  };
  /* For struct scallop_curve, rounded: l of the piece continued to u = 0 (or to near), minus l at the anchor; times
   * the piece's direction unless that is 0. */
  double base;
};

/* One smooth piece of a phase. The solver requires: l' keeps the sign `direction` and l'' is monotone inside the piece;
 * the pieces are contiguous and cover the phase. If l' is 0 at an end of a piece and does not jump there, velocity
 * returns exactly 0. A dwell, in which l rests, is one or more pieces with direction = 0, linear = true, velocity =
 * acceleration = 0, and a curve of constant length. */
struct scallop_piece {
  double begin, end; /* offsets from the anchor, in the order of time, within [0, 1]     */
  enum scallop_anchor anchor;
  int direction;       /* sign of l': +1 or -1; 0 in a dwell                               */
  bool jump;           /* l' jumps at the start of the piece */
  bool linear;         /* l' is linear: l'(u) = velocity + acceleration * (time - anchor)  */
  double velocity;     /* linear pieces: l' at the anchor; others: for the curve's own use */
  double acceleration; /* linear pieces: l''; others: for the curve's own use */
  const struct scallop_curve *curve;
  const struct scallop_law *law; /* NULL: a linear piece is exactly its numbers; other pieces have no exact law */
  /* The piece in fractions (fractions.h) if its doubles are rounded, else NULL */
  const struct scallop_fractions *exact;
};

/* One phase of a gait, of duration 1 and amplitude 1 */
struct scallop_shape {
  const struct scallop_piece *pieces;
  int count;
  double l0, lT; /* l'' at its start and end times duration^2: the paper's l_0, l_T   */
  double peak;   /* max |l'|                                                         */
  double net;    /* time with l' > 0 minus time with l' < 0: +1 or -1 for most        */
  /* Hints for faster methods of the solver; both may be left false. */
  bool concave; /* |l'| is concave, 0 at both ends; the first piece is anchored at the start, the last at the end */
  bool ramps;   /* concave, with two pieces, each a SCALLOP_RAMP */
  bool bell;    /* the same as concave, but |l'| is convex, then concave, then convex, and no piece is linear */
};

/* A periodic separation l(t): an extension, then a contraction */
struct scallop_gait {
  const char *name;
  struct scallop_shape phase[2]; /* indexed by enum scallop_phase_kind                             */
};

/* quadratic: l'' = +-4/tau^2, then -+4/tau^2, changing at half of the phase. sinusoidal: half a
 * cosine, l = (1 - cos(pi t / tau)) / 2 and back. */
extern const struct scallop_gait scallop_gait_quadratic, scallop_gait_sinusoidal;
/* The curve of pieces with linear = true. A piece that neither begins nor ends at its anchor needs a law, for its
 * base. */
extern const struct scallop_curve scallop_curve_linear;
/* A linear piece at rest (l' = 0) at its anchor: offsets of begin and end, sign of l', value of l''. */
#define SCALLOP_RAMP(from, to, anchored, sign, slope) \
  { \
    .begin = (from), .end = (to), .anchor = (anchored), .direction = (sign), .linear = true, .acceleration = (slope), \
    .curve = &scallop_curve_linear \
  }

/* Returns the gait of this name, or NULL. */
const struct scallop_gait *scallop_gait_named(const char *name);
const char *scallop_gait_name(int i); /* returns the name of gait i = 0, 1, ...; NULL after the last */

/* Returns true if l' is known exactly in every piece of both phases: the piece has a law, or is linear. */
bool scallop_gait_is_exact(const struct scallop_gait *gait);
/* Returns true if |l'| of the contraction equals |l'| of the extension, piece by piece. */
bool scallop_gait_mirrors(const struct scallop_gait *gait);
/* Returns true if |l'| of each phase is symmetric about the middle of the phase: time reversal leaves the gait
 * unchanged. */
bool scallop_gait_is_reversible(const struct scallop_gait *gait);

/* Writes l, l' and l'' of one phase at s = t/tau in [0, 1], from its start. length is l: 0 at the start of an
 * extension, 1 at the start of a contraction. Any of the three may be NULL. */
void scallop_gait_at(const struct scallop_gait *gait, enum scallop_phase_kind kind, double s, double *length,
                     double *velocity, double *acceleration);

/* Parameters, in SI or any consistent units. Every m, F, L, T > 0 and finite; 0 < alpha < 1 is the fraction of the
 * period T that the extension takes. */
struct scallop_crawler {
  double m1, m2;
  double F1, F2;
  double L, T, alpha;
  const struct scallop_gait *gait;
};

/* Returns m1 = m2 = 1, F1 = 4, F2 = 1, L = 10, T = 1, alpha = 3/4, quadratic. */
struct scallop_crawler scallop_crawler_default(void);

/* A bad parameter, its value and its domain: "F1 = -3: a finite number > 0" */
struct scallop_complaint {
  const char *name;
  double given;
  const char *allowed;
};

/* Returns SCALLOP_OK, or SCALLOP_EDOMAIN with the first bad parameter in *complaint (may be NULL). */
enum scallop_status scallop_crawler_check(const struct scallop_crawler *crawler, struct scallop_complaint *complaint);

/* Returns the duration of a phase: alpha T or (1 - alpha) T. */
double scallop_phase_duration(const struct scallop_crawler *crawler, enum scallop_phase_kind kind);

/* The crawler in units of L, T and F1 + F2. Differences that can be small (F1 - F2, 2 alpha - 1) are formed once,
 * from the inputs, in which they are exact or correctly rounded. */
struct scallop_scaled {
  double mu1, mu2;      /* m1/M, m2/M                                            */
  double mu_difference; /* (m1 - m2)/M                                           */
  double f1, f2;        /* F1/(F1 + F2), F2/(F1 + F2)                            */
  double delta;         /* (F1 - F2)/(F1 + F2)                                   */
  double eps;           /* T^2 (F1 + F2)/(M L) = 1/Froude                        */
  double fraction[2];   /* alpha, 1 - alpha                                      */
  double velocity;      /* L/T                                                   */
  const struct scallop_gait *gait;
};

/* Scales the crawler. SCALLOP_EDOMAIN as scallop_crawler_check; SCALLOP_ERANGE if eps, a ratio or a velocity (also
 * of either phase alone), or the square of the phase's fraction is not a normal number. */
enum scallop_status scallop_scale(const struct scallop_crawler *crawler, struct scallop_scaled *scaled);

/* Returns the paper's kinematic length, section 4.3.3, for amplitude L: l_0 l_T / (2 (l_T - l_0)) of an extension, and
 * minus this expression of a contraction: its l_0 and l_T have the opposite sign. L for the quadratic gait, pi^2 L / 8
 * for the sinusoidal one. */
double scallop_kinematic_length(const struct scallop_gait *gait, enum scallop_phase_kind kind, double L);

/* Returns l'''' at the start or the end of a phase, in units of its duration and the amplitude; nan if the gait has
 * no exact law. */
double scallop_fourth_derivative(const struct scallop_shape *shape, bool at_end);

#ifdef __cplusplus
}
#endif

#endif
