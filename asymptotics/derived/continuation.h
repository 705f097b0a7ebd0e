/* A branch continued to complex z. Not public: singularity.h is.
 *
 * The unknowns are w, the velocity of the centre of mass at the start, and the times s_1, ..., s_m of the crossings,
 * each since the start of its phase. With eps = kappa z^power they solve (docs/background/theory.md)
 *
 *     q_i lambda_i(s_i) = f w + eps (sum over j of A_ij s_j + A_i),   crossing i, f the fraction of its phase,
 *     sum over i of B_i s_i + B = 0   (steady state: z = T^2)   or   w = (v0/L) z   (one phase: z = T).
 *
 * If two crossings in a row are of the same curve and the same analytic law, s_i = s_(i-1) solves the second equation
 * too, and means nothing: q_i (lambda_i(s_i) - lambda_i(s_(i-1)))/(s_i - s_(i-1)) = f^2 eps beta_i takes its place.
 * Each lambda_i is a polynomial or a sine, so all these are entire functions of v = (w, s_1, ..., s_m, z). The
 * solutions are a curve; any coordinate v_p can be the parameter on a part of it: z where the branch is an analytic
 * function of z, another one around a branch point.
 */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_CONTINUATION_H
#define SCALLOP_ASYMPTOTICS_DERIVED_CONTINUATION_H

#include "asymptotics/derived/limit.h"
#include "asymptotics/derived/singularity.h"

/* Complex balls that end with their block: SCOPED_BALLS(v, n) makes an acb_ptr v. */
struct complex_balls {
  acb_ptr at;
  slong count;
};
static inline void complex_balls_end(struct complex_balls *b) { _acb_vec_clear(b->at, b->count); }
#define SCOPED_BALLS(name, n) \
  ENDED_BY(complex_balls_end) struct complex_balls name##_scoped = { _acb_vec_init(n), n }; \
  acb_ptr name = name##_scoped.at

struct continued_crossing {
  bool sine, joined; /* joined: with the crossing before, as above                                 */
  arb_t q, base;     /* the time that the polynomial is around                                     */
  arb_poly_t law;    /* lambda_i; not of a sine                                                    */
  arb_t drop;        /* of the slope of c behind it, over eps                                      */
};

struct continuation {
  slong m, n;         /* crossings; unknowns, n = m + 1: v[n] is z                               */
  slong first_phase;  /* so many of the crossings are in it                                      */
  slong power, scale; /* z is T^(3 - power) over 2^scale                                         */
  arb_t kappa, fraction[2];
  acb_mat_t fixed, per_eps; /* the right sides: (fixed + eps per_eps) (v, 1), rows: crossings, then the last equation */
  struct continued_crossing crossing[2 * MOST_CROSSINGS];
  acb_ptr start; /* v at z = 0                                                                       */
};
/* eps = kappa T^2 */
void continue_steady(struct continuation *c, const struct limit *limit, const fmpq_t kappa, bool join, slong precision);
/* The first m crossings; velocity: v0/L */
void continue_phase(struct continuation *c, const struct branch *branch, const struct phase_constants *phase, slong m,
                    const fmpq_t velocity, const fmpq_t kappa, bool join, slong precision);
void continuation_clear(struct continuation *c);

/* q_i lambda_i(b), or of a joined crossing q_i (lambda_i(b) - lambda_i(a))/(b - a), with first and second
 * derivatives */
enum { JET_VALUE, JET_A, JET_B, JET_AA, JET_AB, JET_BB, JET };
void continued_law(acb_ptr jet, const struct continued_crossing *at, const acb_t a, const acb_t b, slong precision);

/* The k-th derivative of eps by z */
void continued_eps(acb_t eps, const struct continuation *c, const acb_t z, slong k, slong precision);
/* matrix[row] times (v, last) */
void continued_row(acb_t sum, const acb_mat_t matrix, slong row, acb_srcptr v, slong last, slong precision);
void continued_residual(acb_mat_t f, const struct continuation *c, acb_srcptr v, slong precision);
/* n rows, n + 1 columns */
void continued_jacobian(acb_mat_t jacobian, const struct continuation *c, acb_srcptr v, slong precision);
/* minus the second derivative of the equations in a direction */
void continued_bend(acb_mat_t bend, const struct continuation *c, acb_srcptr v, acb_srcptr direction, slong precision);
/* The derivative of a value in a direction in which z rests */
void continued_gain(acb_t gain, const struct continuation *c, enum continued_value value, acb_srcptr v,
                    acb_srcptr direction, slong precision);

/* v[p] is a ball, the others are a place near: they become balls that hold a solution for every value of v[p], the only
 * one within `around` (v[p] the same there). Krawczyk's operator, see docs/background/theory.md. False: not shown. */
bool continuation_enclose(acb_ptr v, acb_ptr around, const struct continuation *c, slong p, slong precision);
/* The derivatives by v[p] of what v encloses: all first ones, and the second one of z. False: not found. */
bool continuation_derivatives(acb_ptr first, acb_t second, const struct continuation *c, acb_srcptr v, slong p,
                              slong precision);

/* Where z as a function of v_p has a simple critical point: the branch point. Up to the distance `size` of v_p from
 * there it has no other, and at that distance |z - v[n]| >= clear: so in the disc of that radius around v[n] the
 * solutions within `around` are analytic but at v[n]. */
struct fold {
  const struct continuation *c;
  slong p;
  acb_ptr v, first, around; /* the branch point; the derivatives by v_p there; a box                  */
  double size, clear;
};
void fold_init(struct fold *f, const struct continuation *c);
void fold_clear(struct fold *f);
/* By Newton's method from v, at most `far` away in z. False: none was found and proven. */
bool fold_find(struct fold *f, acb_srcptr v, double far, slong precision);
/* v, balls that hold a solution, is in the neighbourhood. */
bool fold_holds(const struct fold *f, acb_srcptr v);

/* Part of the proof: for |z| up to r, in the directions from `from` pi to `to` pi, the branch is an analytic function
 * of z. */
struct sector {
  double r, step, from, to;
  double looked;      /* the step at which a branch point was last looked for                         */
  acb_ptr at, around; /* v at r in the middle direction, and a box in which it is the only solution for all of them */
};

enum { MOST_SECTORS = 4096, MOST_FOLDS = 8, MOST_PLACES = 64, MOST_WORK = 2500000, CELL_BITS = 64 };
struct search {
  const struct continuation *apart, *joined; /* without and with joined crossings                     */
  slong n, precision;
  double last;   /* direction over pi: the others mirror those from 0 to here                          */
  double disc;   /* proven around z = 0                                                               */
  acb_ptr start; /* and the box there                                                                 */
  struct sector sector[MOST_SECTORS];
  int sectors;
  struct fold fold[MOST_FOLDS]; /* those that the branch meets                                        */
  int folds;
  acb_ptr place; /* z of all that were found                                                          */
  int places;
  double reach; /* |z| of the nearest, rounded up                                                     */
};

/* both: the equations without and with joined crossings; last: the direction over pi that the others mirror */
struct search *search_new(const struct continuation both[2], double last, slong precision);
void search_free(struct search *s);
/* Carries that sector on which has come least far, until all reach the nearest fold. Returns |z| up to where the proof
 * has come. */
double search_cover(struct search *s);

#endif
