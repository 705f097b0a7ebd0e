/* model/: what a crawler, a gait and a phase ARE.
 *
 * Two bodies, masses m1 and m2, Coulomb friction forces F1 and F2 (isotropic, static = sliding), with the separation
 * l(t) = x2 - x1 prescribed and periodic. Nothing here moves anything: this folder holds parameters, l(t) and its
 * derivatives, validation and scaling. It prints nothing and holds no state. What this header and gaits.h declare
 * depends on libm only and allocates nothing; ball.h and fractions.h have the same in balls and in fractions, through
 * FLINT, which allocates.
 */
#ifndef SCALLOP_MODEL_MODEL_H
#define SCALLOP_MODEL_MODEL_H

#include <stdbool.h>

#include "model/version.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What every call that can fail returns. Below zero: failed, and the outputs are untouched.
 * Above zero: done, and there is something to know. */
enum scallop_status {
  SCALLOP_OK = 0,
  SCALLOP_INTERVAL = 1,    /* the steady states fill an interval; both ends are returned   */
  SCALLOP_STOPPED = 2,     /* ended early, as the caller wished; what was reached is returned */
  SCALLOP_EDOMAIN = -1,    /* a parameter is outside its domain                            */
  SCALLOP_ERANGE = -2,     /* a scaled quantity overflows, or underflows and loses digits  */
  SCALLOP_ECONVERGE = -3,  /* an iteration ended without an answer                         */
  SCALLOP_EUNDECIDED = -4, /* no finite precision decides it: the motion touches a boundary exactly, or almost */
  SCALLOP_ESTOPPED = -5    /* ended early, as the caller wished, with nothing to return    */
};
const char *scallop_status_text(enum scallop_status status);

enum scallop_phase_kind { SCALLOP_EXTENSION = 0, SCALLOP_CONTRACTION = 1 };

/* Where a piece measures its own time from. Times near the end of a phase are kept as distances to
 * that end: dT ~ T^3 would vanish in T - dT otherwise. */
enum scallop_anchor { SCALLOP_FROM_START = 0, SCALLOP_FROM_END = 1 };

struct scallop_piece;

/* l, l' and l'' in one piece at offset u from the anchor, in units where the phase lasts 1 and the
 * amplitude is 1. Derivatives are with respect to time (not u). */
struct scallop_curve {
  double (*length)(const struct scallop_piece *, double u);       /* l(u) - l(anchor)              */
  double (*velocity)(const struct scallop_piece *, double u);     /* l'(u)                         */
  double (*acceleration)(const struct scallop_piece *, double u); /* l''(u)                        */
  double (*when)(const struct scallop_piece *, double a);         /* u with l''(u) = a, nan if none */
  /* l' and l'' at once where that is cheaper, or NULL; the same values as from the two above        */
  void (*rates)(const struct scallop_piece *, double u, double *velocity, double *acceleration);
};

/* |l'| of a piece exactly, as a function of the offset u, for those who need more digits than a double has: doubles
 * stand for exactly what they are. Polynomial: sum over k <= degree of c[k] u^k / denominator. */
enum { SCALLOP_LAW_MOST_DEGREE = 15 };
struct scallop_polynomial_law {
  double c[SCALLOP_LAW_MOST_DEGREE + 1], denominator;
};
/* Degree 1: (start + slope u) / (divisor (parts[0] + parts[1] + parts[2])). */
struct scallop_ramp_law {
  double start, slope, divisor, parts[3];
};
/* sum over j <= degree of b[j] binomial(degree, j) x^j (1 - x)^(degree - j), with x = (u - near)/(far - near). The
 * coefficient b[implied] is given by the way instead, which is what |l'| covers from near to far, (far - near) times
 * the mean of all b[j]. It is way + more[0] + more[1] + ..., so that the ways of all pieces can add up to 1 exactly
 * though each is right to its last digit. */
struct scallop_bernstein_law {
  double b[SCALLOP_LAW_MOST_DEGREE + 1];
  double near, far, way;
  int implied, more_count;
  const double *more;
};
/* A sine is (pi/2) sin(pi u). */
enum scallop_law_kind { SCALLOP_LAW_POLYNOMIAL, SCALLOP_LAW_SINE, SCALLOP_LAW_RAMP, SCALLOP_LAW_BERNSTEIN };
struct scallop_law {
  enum scallop_law_kind kind;
  int degree;
  union {
    struct scallop_polynomial_law polynomial;
    struct scallop_ramp_law ramp;
    struct scallop_bernstein_law bernstein;
  };
  /* For struct scallop_curve, rounded: l where u is 0, or near, as the piece would have it there, minus l at the
   * anchor; times the piece's direction, where that is not 0. */
  double base;
};

/* One smooth piece of a phase. Promises the solver relies on: l' keeps the sign `direction` and l'' is monotone inside
 * the piece; pieces follow each other without a gap and cover the phase. Where l' is 0 at an end of a piece, and does
 * not jump there, velocity says exactly 0. A dwell, where l rests, is a piece (or some in a row) with direction = 0 and
 * linear = true, velocity = acceleration = 0, and a curve whose length stays what it is there. */
struct scallop_piece {
  double begin, end; /* offsets from the anchor, in the order of time, within [0, 1]     */
  enum scallop_anchor anchor;
  int direction;       /* sign of l': +1 or -1; 0 in a dwell                               */
  bool jump;           /* l' jumps where the piece begins                                  */
  bool linear;         /* l' is linear: l'(u) = velocity + acceleration * (time - anchor)  */
  double velocity;     /* linear pieces: l' at the anchor; others: for the curve's own use */
  double acceleration; /* linear pieces: l''; others likewise */
  const struct scallop_curve *curve;
  const struct scallop_law *law; /* NULL: a linear piece is exactly what its numbers say; others have no exact law */
  /* NULL, or what the piece is in fractions (fractions.h), where doubles are only near */
  const struct scallop_fractions *exact;
};

struct scallop_shape { /* one phase of a gait, duration 1, amplitude 1                      */
  const struct scallop_piece *pieces;
  int count;
  double l0, lT; /* l'' at its start and end times duration^2: the paper's l_0, l_T   */
  double peak;   /* max |l'|                                                         */
  double net;    /* time with l' > 0 minus time with l' < 0: +1 or -1 for most        */
  /* What lets the solver take short cuts; both may be left false. */
  bool concave; /* |l'| is concave, 0 at both ends; the first piece is anchored at the start, the last at the end */
  bool ramps;   /* and there are two pieces, each a SCALLOP_RAMP                            */
};

struct scallop_gait {
  const char *name;
  struct scallop_shape phase[2]; /* indexed by enum scallop_phase_kind                             */
};

/* quadratic: l'' = +-4/tau^2, then -+4/tau^2, changing at half of the phase. sinusoidal: half a
 * cosine, l = (1 - cos(pi t / tau)) / 2 and back. */
extern const struct scallop_gait scallop_gait_quadratic, scallop_gait_sinusoidal;
/* For pieces with linear = true. One that neither begins nor ends at its anchor needs a law, for its base. */
extern const struct scallop_curve scallop_curve_linear;
/* Such a piece, at rest (l' = 0) at its anchor: it begins and ends at these offsets, l' has this sign, l'' this
 * value. */
#define SCALLOP_RAMP(from, to, anchored, sign, slope) \
  { \
    .begin = (from), .end = (to), .anchor = (anchored), .direction = (sign), .linear = true, .acceleration = (slope), \
    .curve = &scallop_curve_linear \
  }

/* The gait called name, or NULL. scallop_gait_name(i) lists them, NULL after the last. */
const struct scallop_gait *scallop_gait_named(const char *name);
const char *scallop_gait_name(int i);

/* Whether l' is known exactly in every piece of both phases: the piece has a law, or is linear. */
bool scallop_gait_is_exact(const struct scallop_gait *gait);
/* Whether |l'| of the contraction is that of the extension, piece by piece. */
bool scallop_gait_mirrors(const struct scallop_gait *gait);
/* Whether |l'| of each phase is symmetric about its middle: the motion of the separation looks the same backward in
 * time. */
bool scallop_gait_is_reversible(const struct scallop_gait *gait);

/* l, l' and l'' of one phase at s = t/tau in [0, 1], from its start. length: l itself, so 0 at the
 * start of an extension and 1 at the start of a contraction. Any of the three may be NULL. */
void scallop_gait_at(const struct scallop_gait *gait, enum scallop_phase_kind kind, double s, double *length,
                     double *velocity, double *acceleration);

/* SI or any consistent units. Every m, F, L, T > 0 and finite; 0 < alpha < 1: the fraction of the
 * period T that the extension takes. */
struct scallop_crawler {
  double m1, m2;
  double F1, F2;
  double L, T, alpha;
  const struct scallop_gait *gait;
};

/* m1 = m2 = 1, F1 = 4, F2 = 1, L = 10, T = 1, alpha = 3/4, quadratic. */
struct scallop_crawler scallop_crawler_default(void);

struct scallop_complaint { /* what is wrong with a crawler: "F1 = -3: a finite number > 0" */
  const char *name;
  double given;
  const char *allowed;
};

/* SCALLOP_OK, or SCALLOP_EDOMAIN with the first bad parameter in *complaint (may be NULL). */
enum scallop_status scallop_crawler_check(const struct scallop_crawler *crawler, struct scallop_complaint *complaint);

/* Duration of a phase: alpha T or (1 - alpha) T. */
double scallop_phase_duration(const struct scallop_crawler *crawler, enum scallop_phase_kind kind);

/* The crawler in units of L, T and F1 + F2. Differences that can be small (F1 - F2, 2 alpha - 1)
 * are formed from the inputs, where they are exact or correctly rounded, and never again. */
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

/* SCALLOP_EDOMAIN as scallop_crawler_check; SCALLOP_ERANGE if eps, a ratio or a velocity, also
 * those of either phase alone, or the square of the phase's fraction is not a normal number. */
enum scallop_status scallop_scale(const struct scallop_crawler *crawler, struct scallop_scaled *scaled);

/* The paper's kinematic length, section 4.3.3: l_0 l_T / (2 (l_T - l_0)) of an extension, for amplitude L, and
 * minus that of a contraction, whose l_0 and l_T have the other sign.
 * L for the quadratic gait, pi^2 L / 8 for the sinusoidal one. */
double scallop_kinematic_length(const struct scallop_gait *gait, enum scallop_phase_kind kind, double L);

/* l'''' at the start, or at the end, of a phase, in units where it lasts 1 and the amplitude is 1; nan where the gait
 * has no exact law. */
double scallop_fourth_derivative(const struct scallop_shape *shape, bool at_end);

#ifdef __cplusplus
}
#endif

#endif
