/* How claims are decided. Needs FLINT. Not public. */
#ifndef SCALLOP_COMPARE_CLAIMS_DECIDE_H
#define SCALLOP_COMPARE_CLAIMS_DECIDE_H

#include "asymptotics/derived/evaluate.h"
#include "compare/answers/answer_flint.h"
#include "compare/claims/claims.h"

/* About an order: the motion is expanded as T -> 0 and sampled, and what a formula leaves out of that is a row. */

/* Under which a formula is tested. Where the text says "F1 < F2", "F2 > F1", "alpha < 1/2" or "m1 a hundredth", the
 * crawler, with F1 > F2 and alpha > 1/2, is changed so. */
struct condition {
  enum scallop_setting setting;
  enum scallop_phase_kind kind;
  const char *text;
  bool inside;       /* assumed by the paper */
  double v0;         /* in units of sqrt(L (F1 + F2)/M) */
  bool equal_forces; /* F2 = F1 */
  bool reversed;     /* the bodies exchange their roles against the paper */
  /* In place of a motion l' and l before the end of an extension, T = L = 1, at the time T before that: REAR_AT_END is
   * l', and FRONT_AT_END l. What holds for one crawler holds for all. */
  bool at_end;
};

/* The crawler under one condition (trial.c); mirrored: seen in a mirror, the bodies exchanged, so that a reversed
 * motion becomes one that the paper's formulas are for. */
struct trial {
  const struct condition *condition;
  bool mirrored;
  fmpq_t v0;
  struct scallop_rational_crawler crawler; /* T is not used */
  struct series_answer series;             /* status: whether the motion has an expansion in powers of T */
  slong terms;
  struct sample *samples;
};
/* Begins with the motion expanded, and sampled. */
void trial_begin(struct trial *m, const struct scallop_rational_crawler *crawler, const struct condition *condition,
                 bool mirrored);
void trial_clear(struct trial *m);
bool trial_expand(struct trial *m, slong terms);
bool trial_is_steady(const struct trial *m);
/* The expansion of a quantity, NULL: it has none. Of a formula without a text its leading term */
const struct series *trial_series(const struct trial *m, enum scallop_quantity quantity);
slong trial_leading_power(const struct scallop_formula *formula);
/* The certified error of the formula at every T where the motion has the modes of the limit: points and count of the
 * row. Returns how far left_out, the derived expansion minus the formula, summed, is from that error, over the latter,
 * at the smallest T where it has digits; nan: there is none. */
double trial_measure(struct claim_row *row, const struct trial *m, const struct scallop_formula *formula,
                     const struct series *left_out);

/* The formula over the certified value, less 1, at the crawler's T, the period; nan: it has none there. */
double trial_error_at_T(const struct trial *m, const struct scallop_formula *formula);

struct claim_row row_of_formula(const struct scallop_formula *f, const struct scallop_gait *gait,
                                const struct condition *condition);
/* Adds the row (proof.c), with the verdict from what the formula leaves out of the motion. why: nothing can be said of
 * that, for this reason, "" where none is known; or NULL. */
void claim_table_decide(struct claim_table *claims, struct claim_row *row, struct trial *m,
                        const struct scallop_formula *formula, const char *why);
/* Has the formula another dimension than what it gives, or none (dimension.c)? why: which */
enum { DIMENSION_WHY = 300 };
bool dimension_refutes(char why[DIMENSION_WHY], const struct trial *trial, const struct scallop_formula *formula);
/* Notes what cannot be. */
void claim_table_contradict(struct claim_table *claims, const struct claim_row *row, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Behind what the text holds, as far as there is room */
void append(char *text, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));
double short_number(double x, int digits); /* as a command says it */
double middle(const arb_t x);

/* In words (statement.c): a row says what is claimed, where, and of which crawler; its function solves motions,
 * compares numbers, and prints what was found. */
struct question;
struct statement {
  const char *name, *place, *quantity; /* place: in the paper */
  const char *conditions; /* a format: %s is whose crawler it is; the crawler gets what they say of its numbers */
  void (*test)(struct question *q, struct scallop_crawler c);
  const void *data;           /* what else the function takes */
  enum scallop_regime regime; /* of the steady state that it is about */
  bool shows;                 /* the example shows what is claimed; else it refutes that */
  bool outside;               /* of the paper's conditions */
  bool of_its_gaits_alone;    /* the paper's: no row for another */
  bool of_its_crawler;        /* the paper's, not the default one */
  bool proven;                /* for the paper's gaits, in docs/background/theory.md: The motion in words */
};
/* In the order of the table of claims; the last has name NULL. Those of families and figures are decided with the
 * paper's crawler, and then with the default one. */
extern const struct statement statements_at_random[], statements_by_example[], statements_of_families[],
    statements_of_figures[];

struct question { /* a statement while it is decided, for one crawler */
  const struct statement *claim;
  struct scallop_crawler crawler;
  bool of_the_paper;      /* it is the one of the paper's figures */
  enum claim_evidence by; /* how motions are solved: CERTIFIED_CRAWLER, to begin with; else in doubles */
  bool solved;            /* all motions so far */
  struct claim_row row;
  char options[200];
};
/* The verdict, 1, -1 or 0, it is not known; and what was found. */
void conclude(struct question *q, int verdict, const char *format, ...) __attribute__((format(printf, 3, 4)));
/* Of what does not hold: a command that shows it, behind words perhaps */
void show(struct question *q, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* " --F1 2 --gait sinusoidal", what makes the default crawler this one */
const char *options(struct question *q, struct scallop_crawler c);

/* A motion that is solved: its quantities, by name and by enum quantity_id, nan where it has none. Certified numbers
 * have 30 proven digits, rounded once. They are 0 only where they are proven to be below 2^-80, and otherwise have a
 * proven sign. */
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
  bool single;                   /* in doubles: there is one steady state */
};
enum { EVIDENCE_DIGITS = 30, EVIDENCE_BITS = 160 };
struct solved steady(struct question *q, struct scallop_crawler c); /* q NULL: in doubles */
struct solved extension(struct question *q, struct scallop_crawler c, double v0);
struct solved contraction(struct question *q, struct scallop_crawler c, double v0);
double certain(const arb_t x);
/* A formula of the paper by its name, of a phase from rest or from v0 = 1, or a text in the names of its formulas of
 * the steady state; what it is about, nan of a text; and their difference: certified */
struct printed {
  double value, exact, error;
};
struct printed printed(struct scallop_crawler c, const char *formula);
/* Periods from rest until the velocity is as near to the steady one, over L/T, at most so many; 0: more, in doubles */
int periods_from_rest(const struct scallop_crawler *c, double near, int most);

struct scallop_crawler exchanged(struct scallop_crawler c); /* the names of its bodies */
/* Sets the numbers of the crawler that conditions in words give it: those of their parts, between commas, semicolons
 * and colons, that are as "T = 2", "F1 = F2 = 1", "alpha = 1/2" or "m1 = m2"; and exchanges the forces where "F1 > F2"
 * asks for it. False: they are equal. */
bool set_conditions(struct scallop_crawler *c, const char *conditions);

/* 1: a > b; -1: a < b; 0: they do not differ by more than roundings do, or one of them is nan */
int compare(double a, double b);
/* Of a certified number: 1: it is 0, to 2^-80; -1: it is not; 0: not known */
int is_zero(double x);

/* A number of each of 400 random crawlers (random.c), which the data of the statement says */
void at_random(struct question *q, struct scallop_crawler any);
extern const struct fact steady_state_is_unique;

void v_mid_peaks(struct question *q, struct scallop_crawler c);
void contraction_loses_least(struct question *q, struct scallop_crawler c);

#endif
