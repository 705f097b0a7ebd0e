/* How the claims in words are decided. A claim is a row of texts about motions: which are solved, what must be so of
 * them, and what is printed. Two deciders serve most rows: `proven` solves the motions in balls, for one crawler;
 * `at_random` solves them in double, for random crawlers. The others find numbers, or solve many crawlers, and then
 * conclude as these do. Needs FLINT. Not public.
 *
 * Motions     "steady F1=40; contraction v0=v_mid:1": the steady state of the base crawler with F1 = 40, then a
 *             contraction. A number is set to a formula (asymptotics/formula.h) without blanks; v0~FORMULA rounds to a
 *             double; at=FORMULA takes the member of the claim's family. The base crawler, motion 0, is the one that
 *             the row is for, in `at_random` a random one. A start velocity in a ball is solved for both of its ends:
 *             all that is asked of a phase rises or falls with v0, since motions under one l never cross.
 * Names       in formulas. A parameter or a quantity (compare/answers/quantities.h) is that of the first motion,
 *             `NAME:2` that of the second; where motions are set, a parameter is that of the base crawler. A formula of
 *             the paper by its name, and the names in its texts (l0, lT, M). T is the period, `duration` that of the
 *             phase. x1, x2, ... and root: what the decider found, as the shortest decimals, and exactly. x_first:
 *             where the rear body is at t1. speed_at_quarter, rate_at_dT: |l'| at a quarter of the duration, and l'' dT
 *             before its end, in L over the duration (squared). 1 if it is so, else 0: sliding, sticking, resting (the
 *             regime), switches (the mode), sticks_1, sticks_2, sticks_both (in some mode), oppose (modes -+ | +-),
 *             turns_once (-+ ++), like_first (the modes of the first motion), single (one steady state), stronger_1 (F1
 *             > F2), longer (alpha > 1/2), sinusoidal (the gait).
 * Statements  FORMULA > FORMULA, or <, <=, =. In balls "=" holds if the difference is 0 to 2^-80, and fails if it is
 *             not 0.
 * Texts       {3f FORMULA}: a number with three digits, as %.3f prints it (likewise e, g). {modes}: those of the first
 *             motion; {options}: what makes the default crawler the first motion's; {modes:2}, {options:0}: of another.
 *             {table}: a command that prints the steady states, with the numbers in which they differ. {whose}, {gait}:
 *             of the row. {1}: what the decider worded. {+TEXT}, {-TEXT}: where the claim holds, where it is refuted.
 *             */
#ifndef SCALLOP_COMPARE_CLAIMS_DECIDE_H
#define SCALLOP_COMPARE_CLAIMS_DECIDE_H

#include "compare/answers/answer_flint.h"
#include "compare/claims/claims.h"

struct question;
typedef void decide(struct question *q);

/* What varies in a family of crawlers: F1/F2, F1 varied; F2, with F1/F2 kept; T. */
enum varied { VARY_RATIO, VARY_FORCES, VARY_PERIOD };

struct claim {
  const char *name, *place, *quantity; /* place: in the paper                                             */
  decide *decide;
  const char *conditions, *motions;  /* conditions, measured and reason: texts                         */
  const char *says, *needs;          /* a statement, and a formula that must be positive for that to count, or NULL */
  const char *shown_by, *refuted_by; /* or one formula: positive, an example shows the claim, or refutes it      */
  const char *measured, *reason;     /* reason: of what does not hold                                  */
  const void *with;                  /* a parameter of the function                                    */
  enum varied varied;                /* of the family                                                          */
  bool outside;                      /* of the paper's conditions                                              */
  bool of_its_gaits_alone;           /* the paper's: no row for another                                        */
  bool of_its_crawler;               /* the paper's, not the ledger's                                          */
  bool proven;                       /* for the paper's gaits, in docs/theory.md: The motion in words                 */
};
/* In the order of the ledger; the last has name NULL. Decided for each gait with the paper's crawler (examples),
 * or with random ones; and for each gait with the paper's crawler and with the ledger's (families). */
extern const struct claim claims_at_random[], claims_by_example[], claims_of_families[];

enum { EVIDENCE_BITS = 160, MOTIONS = 10, FOUND = 9 };

struct moved {
  enum quantity_of of;
  enum scallop_phase_kind kind;
  struct scallop_crawler crawler;
  struct scallop_rational_crawler exact; /* in balls the shortest decimals that read back, else the doubles  */
  arb_t v0;
  struct ball_answer answer;
  arb_struct value[ALL_QUANTITIES]; /* not finite where there is none                                  */
  enum scallop_regime regime;
  struct scallop_modes modes[2];
  bool single;
};

/* One claim in words while it is decided, for one crawler. */
struct question {
  const struct claim *claim;
  struct scallop_crawler crawler; /* with the gait in question                                        */
  bool of_the_paper;              /* it is the one of the paper's figures                             */
  struct claim_row row;           /* its evidence: of the motions that were solved last                    */
  struct moved motion[MOTIONS];   /* [0]: the base crawler, not solved                                */
  int motions;
  bool solved;             /* all of them                                                              */
  double found[FOUND];     /* x1, x2, ...                                                              */
  arb_t root;              /* likewise, exactly                                                         */
  const char *word[FOUND]; /* {1}, {2}, ...                                                        */
};
void question_init(struct question *q, const struct scallop_crawler *crawler);
void question_clear(struct question *q);

/* The claim's motions, of the question's crawler: in balls with 30 digits, or in double. */
void solve_motions(struct question *q, bool in_balls);
/* A formula; without a number names are those of the first motion. */
void value_of(arb_t value, struct question *q, const char *formula);
double number_of(struct question *q, const char *formula);
/* What the claim says, of the motions that were solved: 1 it holds, -1 it does not, 0 undecided. excess: left side -
 * right side, with > the other way round: where it is largest the claim is nearest to failing. */
int judge(struct question *q, arb_t excess);
/* holds or refuted where one of them is proven, and every motion that was asked for is solved, else undecided; and the
 * texts of the row. */
void settle(struct question *q, bool holds, bool fails);
/* What was solved last are samples of all that the claim is about: so many. */
void rest_on_samples(struct question *q, int count);
/* settle by what the claim says, or by its example */
void conclude(struct question *q);
/* Appends a text with its {...}. size: of text */
void say(struct question *q, char *text, size_t size, const char *format);

decide proven, at_random;

decide velocity_in_the_limit, reached;
struct alphas { /* in hundredths, from first on by 8; one of them to name; the relative error, a formula */
  int first, shown;
  const char *error;
};
/* boundary.c: where the start velocity vanishes; the claim's `varied` says of which family */
decide start_velocity_changes_sign, peaks_at_boundary, one_maximum, decays_once_sticking, through_boundary;
/* figures.c */
decide displacement_grows, velocity_change_peaks, velocity_grows_with_alpha, velocity_as_1_over_T;
decide never_falls; /* with ratios F1/F2, 0 behind the last one */

#endif
