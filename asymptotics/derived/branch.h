/* Branches: motions with one sequence of modes, described at one value of eps, and expanded around it as series. Not
 * public.
 *
 * As in docs/background/theory.md, c is the velocity of the centre of mass, in units of L and the duration of the
 * phase: a straight line of slope eps beta between its crossings of curve 0, q_0 |l'| (the rear body turns), and curve
 * 1, q_1 |l'| (the front body turns). Region j lies above curve j, region j + 1 below it. At eps = 0 the line is
 * horizontal: the limit T -> 0 at fixed c. */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_BRANCH_H
#define SCALLOP_ASYMPTOTICS_DERIVED_BRANCH_H

#include "asymptotics/derived/series.h"
#include "model/exact/ball.h"

enum { MOST_CROSSINGS = 16, SCALLOP_MOST_TERMS = 1000 };

/* Returns the reason why a crawler has no expansion below T^order, or NULL: an argument outside its domain, or a gait
 * without exact law or with bodies that turn within a phase too (branch_is_possible). */
const char *not_expandable(const struct scallop_rational_crawler *crawler, slong order, slong precision);
/* Returns status; writes the reason to *why unless why is NULL. */
enum scallop_status refused_for(enum scallop_status status, const char *reason, const char **why);
/* Returns true if l' has one sign in each phase, the sign of its net gain, and is 0 at most at the ends; otherwise the
 * motion for T -> 0 has modes that no branch has. */
bool branch_is_possible(const struct scallop_gait *gait);
extern const char *const branch_impossible;

/* Computes (F1 + F2)/(M L): eps over the square of the time. */
void set_kappa(fmpq_t kappa, const struct scallop_rational_crawler *crawler);
/* Computes x q, rounded twice; aliases are allowed. */
void ball_times(arb_t product, const arb_t x, const fmpq_t q, slong precision);
/* Computes the time since the start of the phase at offset u of a piece, or the reverse; aliases are allowed. */
void time_of_offset(arb_t time, const struct scallop_piece *piece, const arb_t u, slong precision);
/* Computes q |l'| - (a + b time) at offset u of a piece, and its derivative with respect to u. */
void gap_at(arb_t gap, arb_t slope, const struct scallop_piece *piece, const fmpq_t q, const arb_t a, const arb_t b,
            const arb_t u, slong precision);

/* Computes the value of a function at x and its derivative; returns false if it has no value there. */
typedef bool root_function(arb_t value, arb_t slope, const arb_t x, void *of, slong precision);
/* Encloses a root: x, a place near it, becomes a ball that contains the root of every function within the balls of f.
 * Newton's interval operator maps a ball into itself; the ball also contains `holding` unless that is NULL. f is called
 * with exact places first, and last with this ball. Returns false if no ball was found. */
bool enclose_root(arb_t x, root_function *f, void *of, arb_srcptr holding, slong precision);

struct phase_constants { /* constants of one phase of a crawler */
  enum scallop_phase_kind kind;
  const struct scallop_shape *shape;
  fmpq_t fraction; /* fraction of the period */
  fmpq_t curve[2]; /* q_0 = m_front/M > 0, q_1 = -m_rear/M < 0                                    */
  fmpq_t beta[3];  /* slope of c in each region over eps: -1, (F_rear - F_front)/(F1 + F2), 1 */
};
#define PHASE_CONSTANTS(of) \
  of(fmpq, s->fraction) of(fmpq, s->curve[0]) of(fmpq, s->curve[1]) of(fmpq, s->beta[0]) of(fmpq, s->beta[1]) \
      of(fmpq, s->beta[2])
SCOPED_PARTS(phase_constants, struct phase_constants, PHASE_CONSTANTS)
void phase_constants_set(struct phase_constants *p, const struct scallop_rational_crawler *c,
                         enum scallop_phase_kind kind);

/* A crossing, or (tangent, only the first) the release of a body stuck from the start, where c leaves this curve */
struct crossing {
  bool tangent;
  const struct scallop_piece *piece; /* the piece in which it happens */
  int curve, to;                     /* the curve, and the region after it */
  struct series offset;              /* a constant, exact or a ball: the offset at the base point */
};

struct branch {
  int first_region, count;
  struct crossing crossing[MOST_CROSSINGS];
};
void branch_init(struct branch *b);
void branch_clear(struct branch *b);
SCOPED_KIND(branch, struct branch)
void branch_set(struct branch *to, const struct branch *from);
int branch_region(const struct branch *b, int segment); /* 0 <= segment <= count */

/* Finds the crossings at the ends of a phase, at |l'| = 0. Signs are +1 or -1, of c at the end; 0 at the end: no
 * crossing; 0 at the start: a phase from rest, with a tangent point first if l'' = 0: friction holds a body until l''
 * exceeds it. Returns NULL, or the reason: l'' = 0 at such an end, or also l''' at the start from rest, so the crossing
 * moves as a fractional power of T; or the piece there has another anchor. */
extern const char *const branch_without_ends;
const char *branch_from_ends(struct branch *b, const struct phase_constants *p, int sign_at_start, int sign_at_end);
/* Finds the crossings of a phase from v0, and its constants. The reason can also be not_expandable. */
const char *branch_of_phase(struct branch *b, struct phase_constants *p, const struct scallop_rational_crawler *crawler,
                            enum scallop_phase_kind kind, const fmpq_t v0, slong order, slong precision);

/* Finds the crossings of the level c (a ball without 0) through one phase at eps = 0, with their offsets as balls.
 * Returns false if c touches a curve, or is too wide to decide. */
bool branch_of_level(struct branch *b, const struct phase_constants *p, const arb_t c, slong precision);

/* A series for each crossing */
struct of_crossings {
  struct series at[MOST_CROSSINGS];
};
void of_crossings_init(struct of_crossings *s);
void of_crossings_clear(struct of_crossings *s);

/* The constants of a phase as series, and the units of its motion: numbers of a crawler, or names for all crawlers with
 * the same modes. */
struct phase_series {
  enum scallop_phase_kind kind;
  const fmpq *pi_squared; /* NULL, or the substitute for pi^2: see model/exact/ball.h */
  struct series fraction, curve[2], beta[3];
  struct series whole; /* change of l in the phase */
  struct series unit;  /* unit of the displacements */
  /* true: |l'| is law[i] as a function of the time since the base point of crossing i; false: of its piece */
  bool has_laws;
  struct of_crossings law;
};
#define PHASE_SERIES(of) \
  of(series, &s->fraction) of(series, &s->curve[0]) of(series, &s->curve[1]) of(series, &s->beta[0]) \
      of(series, &s->beta[1]) of(series, &s->beta[2]) of(series, &s->whole) of(series, &s->unit) \
          of(of_crossings, &s->law)
SCOPED_PARTS(phase_series, struct phase_series, PHASE_SERIES)
void phase_series_set(struct phase_series *to, const struct phase_constants *from, const fmpq_t L);

struct lift {               /* the motion of a phase as series in x */
  struct of_crossings when; /* times of the crossings, from the start of the phase   */
  struct of_crossings left; /* 1 - when */
  struct of_crossings travel_to;
  struct series c_end, balance;             /* balance: (c_end - c_start)/eps, computed without a division */
  struct series c_end_slope, balance_slope; /* their derivatives with respect to the unknown of c_start */
  struct series travel;                     /* displacement of the centre of mass */
};
#define LIFT(of) \
  of(of_crossings, &s->when) of(of_crossings, &s->left) of(of_crossings, &s->travel_to) of(series, &s->c_end) \
      of(series, &s->c_end_slope) of(series, &s->balance) of(series, &s->balance_slope) of(series, &s->travel)
SCOPED_PARTS(lift, struct lift, LIFT)
/* Crossings at the base point: known from the branch; enclosed again for these balls, near the earlier place; or, the
 * same, enclosed again and proven to be the crossing in the ball of the offset, by uniqueness */
enum crossings { CROSSINGS_KNOWN, CROSSINGS_ANEW, CROSSINGS_THE_SAME };
/* Computes the motion for series eps, c and c_slope (the derivative of c); their constant terms are the base point.
 * Returns false if a crossing is not transversal, or was not enclosed. */
bool lift_phase(struct lift *lift, struct branch *b, const struct phase_series *p, const struct series *eps,
                const struct series *c, const struct series *c_slope, enum crossings crossings,
                const struct ring *ring);

#endif
