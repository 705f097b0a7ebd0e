/* A branch: motions with one sequence of modes, described around one value of eps, and carried from there as
 * series. Not public.
 *
 * As in docs/background/theory.md, c is the velocity of the centre of mass, with the phase as the unit of time and L as
 * that of length: a straight line of slope eps beta between its crossings of curve 0, q_0 |l'| (the rear body turns),
 * and curve 1, q_1 |l'| (the front body turns). Region j lies above curve j, region j + 1 below it. At eps = 0
 * the line is horizontal: that is the limit T -> 0 at fixed c.
 */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_BRANCH_H
#define SCALLOP_ASYMPTOTICS_DERIVED_BRANCH_H

#include "asymptotics/derived/series.h"
#include "model/exact/ball.h"

enum { MOST_CROSSINGS = 16, SCALLOP_MOST_TERMS = 1000 };

/* What keeps a crawler from having expansions below T^order at all, or NULL: an argument outside its domain, or a gait
 * that has no exact law or whose bodies turn within a phase too (branch_is_possible). */
const char *not_expandable(const struct scallop_rational_crawler *crawler, slong order, slong precision);
/* Returns status; *why becomes the reason, unless why is NULL. */
enum scallop_status refused_for(enum scallop_status status, const char *reason, const char **why);
/* Whether l' has one sign in each phase, that of its net gain, and is 0 at its ends at most: else the motion for T -> 0
 * has modes that no branch has. */
bool branch_is_possible(const struct scallop_gait *gait);
extern const char *const branch_impossible;

/* (F1 + F2)/(M L): eps over the square of the time */
void set_kappa(fmpq_t kappa, const struct scallop_rational_crawler *crawler);
/* x q, rounded twice; aliases are allowed. */
void ball_times(arb_t product, const arb_t x, const fmpq_t q, slong precision);
/* The time since the start of the phase at offset u of a piece, and the other way round; aliases are allowed. */
void time_of_offset(arb_t time, const struct scallop_piece *piece, const arb_t u, slong precision);
/* q |l'| - (a + b time) at offset u of a piece, and its derivative by u */
void gap_at(arb_t gap, arb_t slope, const struct scallop_piece *piece, const fmpq_t q, const arb_t a, const arb_t b,
            const arb_t u, slong precision);

/* The value of a function at x and its derivative; false: it has none there. */
typedef bool root_function(arb_t value, arb_t slope, const arb_t x, void *of, slong precision);
/* x, a place near a root, becomes a ball that holds it, for all functions within the balls that f gives: Newton's
 * interval operator maps a ball into itself, one that also holds `holding`, unless that is NULL. f is called with exact
 * places first, and last with that ball. False: none was found. */
bool enclose_root(arb_t x, root_function *f, void *of, arb_srcptr holding, slong precision);

struct phase_constants { /* of one phase of a crawler                                             */
  enum scallop_phase_kind kind;
  const struct scallop_shape *shape;
  fmpq_t fraction; /* of the period                                                               */
  fmpq_t curve[2]; /* q_0 = m_front/M > 0, q_1 = -m_rear/M < 0                                    */
  fmpq_t beta[3];  /* slope of c in each region over eps: -1, (F_rear - F_front)/(F1 + F2), 1     */
};
#define PHASE_CONSTANTS(of) \
  of(fmpq, s->fraction) of(fmpq, s->curve[0]) of(fmpq, s->curve[1]) of(fmpq, s->beta[0]) of(fmpq, s->beta[1]) \
      of(fmpq, s->beta[2])
SCOPED_PARTS(phase_constants, struct phase_constants, PHASE_CONSTANTS)
void phase_constants_set(struct phase_constants *p, const struct scallop_rational_crawler *c,
                         enum scallop_phase_kind kind);

/* tangent: not a crossing, but where a body that was held from the start is let go, and c leaves its curve, that one.
 * Only the first */
struct crossing {
  bool tangent;
  const struct scallop_piece *piece; /* in which it happens                                        */
  int curve, to;                     /* which curve, and the region behind it                      */
  struct series offset;              /* a constant, exact or a ball: where it happens at the base point */
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

/* The crossings of the ends of a phase, where |l'| = 0: sign +1 or -1 is that of c there, 0 at the end for none, 0 at
 * the start for a phase from rest. That begins with a tangent point where l'' = 0: friction holds a body until l''
 * exceeds it. Not NULL, but why: l'' = 0 at such an end, or l''' too at the start from rest, where the crossing moves
 * as a fractional power of T; or the piece there has its anchor elsewhere. */
extern const char *const branch_without_ends;
const char *branch_from_ends(struct branch *b, const struct phase_constants *p, int sign_at_start, int sign_at_end);
/* Those of a phase from v0, and its constants; not NULL also where not_expandable. */
const char *branch_of_phase(struct branch *b, struct phase_constants *p, const struct scallop_rational_crawler *crawler,
                            enum scallop_phase_kind kind, const fmpq_t v0, slong order, slong precision);

/* The crossings of the level c (a ball that is not 0) through one phase at eps = 0, with their offsets as balls.
 * False: c touches a curve, or is too wide to tell. */
bool branch_of_level(struct branch *b, const struct phase_constants *p, const arb_t c, slong precision);

/* A series for each crossing */
struct of_crossings {
  struct series at[MOST_CROSSINGS];
};
void of_crossings_init(struct of_crossings *s);
void of_crossings_clear(struct of_crossings *s);

/* The constants of a phase as series, and what its motion is measured in: numbers of a crawler, or names that stand for
 * those of any crawler with its modes. */
struct phase_series {
  enum scallop_phase_kind kind;
  const fmpq *pi_squared; /* NULL, or in the place of pi^2: see model/exact/ball.h              */
  struct series fraction, curve[2], beta[3];
  struct series whole; /* how much l changes in the phase                                    */
  struct series unit;  /* of the displacements                                                */
  bool has_laws;       /* |l'| is law[i] in the time since the base point of crossing i; else that of its piece */
  struct of_crossings law;
};
#define PHASE_SERIES(of) \
  of(series, &s->fraction) of(series, &s->curve[0]) of(series, &s->curve[1]) of(series, &s->beta[0]) \
      of(series, &s->beta[1]) of(series, &s->beta[2]) of(series, &s->whole) of(series, &s->unit) \
          of(of_crossings, &s->law)
SCOPED_PARTS(phase_series, struct phase_series, PHASE_SERIES)
void phase_series_set(struct phase_series *to, const struct phase_constants *from, const fmpq_t L);

struct lift {               /* the motion of a phase as series in x                                    */
  struct of_crossings when; /* times of the crossings, from the start of the phase   */
  struct of_crossings left; /* 1 minus that                                          */
  struct of_crossings travel_to;
  struct series c_end, balance;             /* balance: (c_end - c_start)/eps, formed without a division       */
  struct series c_end_slope, balance_slope; /* their derivatives by the unknown that c_start depends on */
  struct series travel;                     /* of the centre of mass                                               */
};
#define LIFT(of) \
  of(of_crossings, &s->when) of(of_crossings, &s->left) of(of_crossings, &s->travel_to) of(series, &s->c_end) \
      of(series, &s->c_end_slope) of(series, &s->balance) of(series, &s->balance_slope) of(series, &s->travel)
SCOPED_PARTS(lift, struct lift, LIFT)
/* Where the crossings are at the base point: where the branch has them; or each is enclosed anew for these balls, from
 * where it was before. The same: it must be the very crossing that the offset's ball holds, shown by its lying where
 * there is only one. */
enum crossings { CROSSINGS_KNOWN, CROSSINGS_ANEW, CROSSINGS_THE_SAME };
/* eps, c and c_slope (the derivative of c) as series whose constant terms are the base point. False: a crossing is not
 * transversal, or was not enclosed. */
bool lift_phase(struct lift *lift, struct branch *b, const struct phase_series *p, const struct series *eps,
                const struct series *c, const struct series *c_slope, enum crossings crossings,
                const struct ring *ring);

#endif
