/* Decision of claims: motions, expansions, verdicts. Needs FLINT. Not public. */
#ifndef SCALLOP_COMPARE_CLAIMS_DECIDE_H
#define SCALLOP_COMPARE_CLAIMS_DECIDE_H

#include "asymptotics/derived/evaluate.h"
#include "compare/answers/answer_flint.h"
#include "compare/claims/claims.h"

/* Claims about an order: the motion is expanded as T -> 0 and sampled; a row has the terms that a formula leaves out */

/* Condition under which a formula is tested. The crawler has F1 > F2 and alpha > 1/2, unless the text contains "F1 <
 * F2", "F2 > F1", "alpha < 1/2" or "m1 a hundredth". */
struct condition {
  enum scallop_setting setting;
  enum scallop_phase_kind kind;
  const char *text;
  bool inside;       /* assumed by the paper */
  double v0;         /* in units of sqrt(L (F1 + F2)/M) */
  bool equal_forces; /* F2 = F1 */
  bool reversed;     /* the roles of the bodies are exchanged, compared with the paper */
  /* In place of a motion, l' (as REAR_AT_END) and l (as FRONT_AT_END) at the time T before the end of an extension of
   * duration 1, with L = 1. A claim that holds for one crawler holds for all. */
  bool at_end;
};

/* Motion of the crawler under one condition (trial.c). mirrored: reflected, with the bodies exchanged; the paper's
 * formulas then apply to a reversed motion. */
struct trial {
  const struct condition *condition;
  bool mirrored;
  fmpq_t v0;
  struct scallop_rational_crawler crawler; /* T is not used */
  struct series_answer series;             /* status SCALLOP_OK: the motion has an expansion in powers of T */
  slong terms;
  struct sample *samples;
};
/* Sets up a trial: expands the motion and samples it. */
void trial_begin(struct trial *m, const struct scallop_rational_crawler *crawler, const struct condition *condition,
                 bool mirrored);
void trial_clear(struct trial *m);
bool trial_expand(struct trial *m, slong terms);
bool trial_is_steady(const struct trial *m);
/* Returns the expansion of a quantity, NULL if it does not exist. */
const struct series *trial_series(const struct trial *m, enum scallop_quantity quantity);
/* Returns the power of the leading term. A formula without a text is this term. */
slong trial_leading_power(const struct scallop_formula *formula);
/* Sets points and count of the row: the certified error of the formula at every T at which the motion has the modes of
 * the limit. Returns the relative difference from this error of left_out, the derived expansion minus the formula, at
 * the smallest T at which the error is accurate; nan if no such T exists. */
double trial_measure(struct claim_row *row, const struct trial *m, const struct scallop_formula *formula,
                     const struct series *left_out);
/* Returns formula/exact - 1, certified, at the crawler's period T; nan if either has no value. */
double trial_error_at_T(const struct trial *m, const struct scallop_formula *formula);

struct claim_row row_of_formula(const struct scallop_formula *f, const struct scallop_gait *gait,
                                const struct condition *condition);
/* Adds the row (proof.c), with the verdict from the terms that the formula leaves out. why, unless NULL: the reason why
 * the claim is undecided, "" if unknown. */
void claim_table_decide(struct claim_table *claims, struct claim_row *row, struct trial *m,
                        const struct scallop_formula *formula, const char *why);
/* Returns true if the formula has another dimension than its quantity, or none at all (dimension.c). why: both */
enum { DIMENSION_WHY = 300 };
bool dimension_refutes(char why[DIMENSION_WHY], const struct trial *trial, const struct scallop_formula *formula);
/* Records a contradiction of the table. */
void claim_table_contradict(struct claim_table *claims, const struct claim_row *row, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Appends to the text, truncated to its size. */
void append(char *text, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));
double short_number(double x, int digits); /* Rounds x as a printed command does. */
double middle(const arb_t x);

/* Claims in words (statement.c): a row has the claim, its place in the paper and the crawler; its function solves
 * motions, compares numbers, and prints the result. */
struct question;
struct statement {
  const char *name, *place, *quantity; /* place: in the paper */
  const char *conditions; /* a format: %s is "the paper's crawler" or the default; set_conditions reads its numbers */
  void (*test)(struct question *q, struct scallop_crawler c);
  const void *data;           /* further input of the function */
  enum scallop_regime regime; /* of the steady state in question */
  bool shows;                 /* an example proves the claim; else it refutes the claim */
  bool outside;               /* of the paper's conditions */
  bool only_paper_gaits;      /* no row for other gaits */
  bool only_paper_crawler;    /* no row for the default crawler of claims */
  bool proven;                /* for the paper's gaits, in docs/background/theory.md: The motion in words */
};
/* Statements in the order of the table of claims; the last has name NULL. Families and figures are decided for the
 * paper's crawler, then for the default one. */
extern const struct statement statements_at_random[], statements_by_example[], statements_of_families[],
    statements_of_figures[];

struct question { /* a statement while it is decided, for one crawler */
  const struct statement *claim;
  struct scallop_crawler crawler;
  bool of_the_paper;      /* the paper's figures have this crawler */
  enum claim_evidence by; /* motions are solved in balls if CERTIFIED_CRAWLER (initially), else in doubles */
  bool solved;            /* all motions so far were solved */
  struct claim_row row;
  char options[200];
};
/* Sets the verdict, 1 (holds), -1 (refuted) or 0 (undecided), and the summary. */
void conclude(struct question *q, int verdict, const char *format, ...) __attribute__((format(printf, 3, 4)));
/* Sets the reason of a claim that does not hold: a command that shows it, sometimes after words and a colon. */
void show(struct question *q, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Returns the options that turn the default crawler into c: " --F1 2 --gait sinusoidal" */
const char *write_options(struct question *q, struct scallop_crawler c);

/* Solution of a motion: its quantities, by name and by enum quantity_id, nan if missing. Certified numbers have 30
 * proven digits, rounded once. 0 is proven to be below 2^-80 in size, any other number has a proven sign. */
struct solved {
  union {
    struct {
      double froude, v_start, v_mid, displacement, mean_velocity, multiplier;
      double t1, dT, v_end, dx1, dx2, dxC, friction_work, cost_of_transport, at_first;
    };
    double of[ALL_QUANTITIES];
  };
  enum scallop_regime regime;
  char modes[MOTION_MODES_TEXT]; /* "++ -+ ++ | ++ +- ++" */
  bool single;                   /* in doubles: the steady state is unique */
};
enum { EVIDENCE_DIGITS = 30, EVIDENCE_BITS = 160 };
/* Solve a motion in balls or doubles, as q->by states; q NULL: in doubles. */
struct solved solve_steady_state(struct question *q, struct scallop_crawler c);
struct solved solve_extension(struct question *q, struct scallop_crawler c, double v0);
struct solved solve_contraction(struct question *q, struct scallop_crawler c, double v0);
/* Rounds a certified number: 0 if it may be 0 and is below 2^-80; nan if it may be 0 and is not so small. */
double round_certified(const arb_t x);
/* Certified value of a formula, exact value of its quantity (nan for a text), and their difference. formula: the name
 * of a formula of the paper, for a phase from rest or from v0 = 1; or a text in the symbols of the steady state */
struct printed_value {
  double value, exact, error;
};
struct printed_value evaluate_printed(struct scallop_crawler c, const char *formula);
/* Counts periods from rest until the velocity is within `near` L/T of the steady one, in doubles; 0: more than max. */
int periods_from_rest(const struct scallop_crawler *c, double near, int max);

struct scallop_crawler exchange_bodies(struct scallop_crawler c); /* Exchanges the names of the bodies. */
/* Sets numbers of the crawler as the conditions state: each part between commas, semicolons and colons that reads like
 * "T = 2", "F1 = F2 = 1", "alpha = 1/2" or "m1 = m2"; then exchanges the forces if "F1 > F2" requires it. False: they
 * are equal. */
bool set_conditions(struct scallop_crawler *c, const char *conditions);

/* Returns 1 if a > b, -1 if a < b, 0 if they differ by no more than roundings or one of them is nan. */
int compare(double a, double b);
/* Returns, for a certified number, 1 if it is 0 to 2^-80, -1 if not, 0 if undecided. */
int is_zero(double x);

/* Compares a number of each of 400 random crawlers with a limit; the statement's data has both (random.c). */
void at_random(struct question *q, struct scallop_crawler any);
extern const struct fact steady_state_is_unique;

void v_mid_peaks(struct question *q, struct scallop_crawler c);
void contraction_loses_least(struct question *q, struct scallop_crawler c);

#endif
