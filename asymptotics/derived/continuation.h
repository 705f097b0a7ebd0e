/* Continuation of a branch to complex z. Not public: singularity.h is.
 *
 * The unknowns are w, the velocity of the centre of mass at the start, and the times s_1, ..., s_m of the crossings,
 * each since the start of its phase. With eps = kappa z^power they solve (docs/background/theory.md)
 *
 *     q_i lambda_i(s_i) = f w + eps (sum over j of A_ij s_j + A_i),   crossing i, f the fraction of its phase,
 *     sum over i of B_i s_i + B = 0   (steady state: z = T^2)   or   w = (v0/L) z   (one phase: z = T).
 *
 * If two consecutive crossings are of the same curve and the same analytic law, s_i = s_(i-1) is a spurious solution of
 * the second equation. It is replaced by q_i (lambda_i(s_i) - lambda_i(s_(i-1)))/(s_i - s_(i-1)) = f^2 eps beta_i. Each
 * lambda_i is a polynomial or a sine, therefore all equations are entire functions of v = (w, s_1, ..., s_m, z). The
 * solutions are a curve; on a part of it any coordinate v_p can be the parameter: z if the branch is an analytic
 * function of z, another one near a branch point. */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_CONTINUATION_H
#define SCALLOP_ASYMPTOTICS_DERIVED_CONTINUATION_H

#include "asymptotics/derived/limit.h"
#include "asymptotics/derived/singularity.h"

/* Complex balls, cleared at the end of their block: SCOPED_BALLS(v, n) makes an acb_ptr v. */
struct complex_balls {
  acb_ptr at;
  slong count;
};
static inline void complex_balls_end(struct complex_balls *b) { _acb_vec_clear(b->at, b->count); }
#define SCOPED_BALLS(name, n) \
  ENDED_BY(complex_balls_end) struct complex_balls name##_scoped = { _acb_vec_init(n), n }; \
  acb_ptr name = name##_scoped.at

struct continued_crossing {
  bool sine, joined; /* joined: uses the second equation with the crossing before */
  arb_t q, base;     /* center of the polynomial in time */
  arb_poly_t law;    /* lambda_i; unused for a sine */
  arb_t drop;        /* decrease of the slope of c at the crossing, over eps */
};

struct continuation {
  slong m, n;         /* counts of crossings and of unknowns, n = m + 1: v[n] is z */
  slong first_phase;  /* count of crossings in the first phase */
  slong power, scale; /* z is T^(3 - power) over 2^scale                                         */
  arb_t kappa, fraction[2];
  acb_mat_t fixed, per_eps; /* the right sides: (fixed + eps per_eps) (v, 1), rows: crossings, then the last equation */
  struct continued_crossing crossing[2 * MOST_CROSSINGS];
  acb_ptr start; /* v at z = 0                                                                       */
};
/* Sets the equations of the steady state; eps = kappa T^2. */
void continue_steady(struct continuation *c, const struct limit *limit, const fmpq_t kappa, bool join, slong precision);
/* Sets the equations of the first m crossings of a phase; velocity: v0/L. */
void continue_phase(struct continuation *c, const struct branch *branch, const struct phase_constants *phase, slong m,
                    const fmpq_t velocity, const fmpq_t kappa, bool join, slong precision);
void continuation_clear(struct continuation *c);

/* Computes q_i lambda_i(b), or, joined, q_i (lambda_i(b) - lambda_i(a))/(b - a), with first and second derivatives. */
enum { JET_VALUE, JET_A, JET_B, JET_AA, JET_AB, JET_BB, JET };
void continued_law(acb_ptr jet, const struct continued_crossing *at, const acb_t a, const acb_t b, slong precision);

/* Computes the k-th derivative of eps with respect to z. */
void continued_eps(acb_t eps, const struct continuation *c, const acb_t z, slong k, slong precision);
/* Computes matrix[row] times (v, last). */
void continued_row(acb_t sum, const acb_mat_t matrix, slong row, acb_srcptr v, slong last, slong precision);
void continued_residual(acb_mat_t f, const struct continuation *c, acb_srcptr v, slong precision);
/* Computes the Jacobian: n rows, n + 1 columns. */
void continued_jacobian(acb_mat_t jacobian, const struct continuation *c, acb_srcptr v, slong precision);
/* Computes minus the second derivative of the equations in a direction. */
void continued_bend(acb_mat_t bend, const struct continuation *c, acb_srcptr v, acb_srcptr direction, slong precision);
/* Computes the derivative of a value in a direction with constant z. */
void continued_gain(acb_t gain, const struct continuation *c, enum continued_value value, acb_srcptr v,
                    acb_srcptr direction, slong precision);

/* Encloses solutions: v[p] is a ball; the other coordinates, near a solution, become balls that contain a solution for
 * every value of v[p], the only one within `around` (with the same v[p]). Krawczyk's operator, see
 * docs/background/theory.md. Returns false without a proof. */
bool continuation_enclose(acb_ptr v, acb_ptr around, const struct continuation *c, slong p, slong precision);
/* Computes the derivatives with respect to v[p] of the solutions in v: all first ones, and the second one of z. Returns
 * false if they were not found. */
bool continuation_derivatives(acb_ptr first, acb_t second, const struct continuation *c, acb_srcptr v, slong p,
                              slong precision);

/* A branch point: z as a function of v_p has a simple critical point. No other is within the distance `size` of v_p,
 * and at this distance |z - v[n]| >= clear: in the disc of radius `clear` around v[n] the solutions within `around` are
 * analytic except at v[n]. */
struct fold {
  const struct continuation *c;
  slong p;
  acb_ptr v, first, around; /* the branch point; the derivatives with respect to v_p there; a box */
  double size, clear;
};
void fold_init(struct fold *f, const struct continuation *c);
void fold_clear(struct fold *f);
/* Finds a branch point by Newton's method from v, at most `far` away in z. Returns false if the proof fails. */
bool fold_find(struct fold *f, acb_srcptr v, double far, slong precision);
/* Returns true if v, balls that contain a solution, is in the neighbourhood. */
bool fold_holds(const struct fold *f, acb_srcptr v);

/* A proven sector: for |z| <= r and arguments from `from` pi to `to` pi the branch is an analytic function of z. */
struct sector {
  double r, step, from, to;
  double looked; /* step of the last search for a branch point */
  /* v at r in the middle direction, and a box in which it is the only solution for all directions */
  acb_ptr at, around;
};

enum { MOST_SECTORS = 4096, MOST_FOLDS = 8, MOST_PLACES = 64, MOST_WORK = 2500000, CELL_BITS = 64 };
struct singularity_search {
  const struct continuation *apart, *joined; /* without and with joined crossings                     */
  slong n, precision;
  double last;   /* last direction over pi: the other directions mirror those from 0 to here */
  double disc;   /* radius of the proven disc around z = 0 */
  acb_ptr start; /* box of the disc */
  struct sector sector[MOST_SECTORS];
  int sectors;
  struct fold fold[MOST_FOLDS]; /* branch points that the branch meets */
  int folds;
  acb_ptr place; /* z of all branch points that were found */
  int places;
  double reach; /* |z| of the nearest, rounded up */
};

/* Starts a search; both: equations without and with joined crossings; last: last direction over pi, then mirrored. */
struct singularity_search *search_new(const struct continuation both[2], double last, slong precision);
void search_free(struct singularity_search *s);
/* Extends the sector with the smallest radius, until all reach the nearest fold. Returns the proven radius in |z|. */
double search_cover(struct singularity_search *s);

#endif
