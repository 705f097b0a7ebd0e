/* What is known of one motion as a function of T: its series, how far each reaches, where the motion changes, and where
 * the series converge. Of a steady state T is the period, of one phase from velocity v0 its duration; T of the crawler
 * is not used, and parameters are the doubles they are. */
#ifndef SCALLOP_COMPARE_BREAKDOWN_MOTION_H
#define SCALLOP_COMPARE_BREAKDOWN_MOTION_H

#include "asymptotics/derived/singularity.h"
#include "compare/answers/answer_flint.h"
#include "compare/breakdown/breakdown.h"

enum { BREAKDOWN_BITS = 256 }; /* of the balls that errors are formed in */

/* motion.c. The motion at T. A phase is the half of a period: its duration is then exactly T. */
struct motion motion_at(const struct motion *motion, double T);
/* The answer in binary128 at T. A displacement that is 0 in double is 0. */
bool motion_in_wide(const struct motion *motion, double T, struct answer *answer);
/* Is it a quantity of this motion that has a series? */
bool motion_has(const struct motion *motion, enum quantity_id quantity);
/* The Froude number, and the duration at which it is 1. */
double motion_froude(const struct motion *motion, double T);
double motion_natural_time(const struct motion *motion);
/* Beyond this T nothing changes any more: the body with the larger friction rests for good. */
double motion_last_time(const struct motion *motion);

/* mode_change.c. What happens where the modes change, in words: causes, separated by "; ", in text, which is returned.
 * What follows from another cause is left out: a body that is held to the end of a phase makes the next one begin from
 * rest, so what changes at its beginning is not said. Of both answers modes of extension and contraction, regime and
 * the sign of v_start are used. */
enum { MODE_CHANGE_TEXT = 400 };
const char *mode_change_text(char text[MODE_CHANGE_TEXT], const struct answer *before, const struct answer *after);

/* transitions.c. What ends the expansion: where the sequence of modes changes as T grows, and where a body turns in
 * another part of the gait. And what does not end it: where the crawler turns back. */
enum transition_kind { CHANGE_OF_MODES, CHANGE_OF_PART, CHANGE_OF_WAY };
struct transition {
  double T;
  enum transition_kind of;
  char what[MODE_CHANGE_TEXT];
  struct scallop_modes modes[2]; /* from here on */
  const char *status;            /* how it is known: certified, binary128 or double */
  double error;                  /* of T, as far as the recording of a measured gait tells; else nan */
  bool is_own;                   /* of this curve: another one does not have it */
};
struct transitions {
  struct scallop_modes first[2];            /* the modes below the first transition   */
  double from, until;                       /* searched: this range of T         */
  int per_octave;                           /* in so many steps                  */
  enum transition_kind finest;              /* what is looked for */
  bool is_rough;                            /* T to four digits, and nothing proven */
  long count, reversals, left_out;          /* left_out: other curves through the recording do not have them */
  struct transition *transition, *reversal; /* reversals: changes of way, of a steady state */
};
/* limit_modes: those for T -> 0, or "" where they are not known. Takes a quarter of a second. Of a measured gait pieces
 * are no parts, and what changes is left out unless it does with other curves through the recording, too. */
void transitions_find(struct transitions *transitions, const struct motion *motion, const char *limit_modes);
void transitions_clear(struct transitions *transitions);
const struct scallop_modes *transitions_modes_at(const struct transitions *transitions, double T);

/* study.c. All that is found of a motion. Terms below T^STUDY_MANY tell the best order, and where the poles of a
 * rational function are; at STUDY_PLACES (reach.c) the answer in binary128 is kept, shared by all comparisons. */
enum { STUDY_MANY = 96, STUDY_MANY_BITS = 1024, STUDY_PLACES = 4097 };
struct study_place {
  bool known;
  struct answer exact;
};
struct study { /* zero at first */
  struct motion motion;
  struct scallop_rational_crawler crawler; /* the same in fractions */
  fmpq_t v0;
  struct series_answer derived;   /* the terms below T^order; where there is no series no value, and modes "" */
  struct series_answer many;      /* likewise below T^STUDY_MANY; modes: NULL, before they are first asked for */
  struct transitions transitions; /* until: 0, likewise */
  struct scallop_singularity singularity; /* of the branch, where it has one, up to so many crossings; 0: likewise */
  int crossings;
  bool has_singularity;
  struct study_place *places; /* NULL: there is no study */
};
/* In place of an earlier one. order: of the derived series below T^order. NULL, or what is wrong with the crawler, of
 * which there is then no study. */
const char *study_begin(struct study *study, const struct motion *motion, slong order);
void study_clear(struct study *study);
const struct transitions *study_transitions(struct study *study);
/* Of a quantity the derived series with the terms below T^STUDY_MANY, or NULL */
const struct series *study_many(struct study *study, enum quantity_id quantity);
/* Why there is no derived series */
const char *study_why_none(const struct study *study);
/* Whether the expansion is about the motion at T, in words, by its transitions; until the next call */
const char *study_where(const struct study *study, double T);
struct best_order { /* of truncation: with the terms below T^order the size of the error is least */
  slong order;
  double error;         /* INFINITY: there is none */
  bool gains_from_more; /* that is all terms below T^STUDY_MANY, and more might be better still */
};
/* At T, by the certified value there */
struct best_order study_best_order(struct study *study, enum quantity_id quantity, double T);
/* Makes x, beside what it should be, its relative error; 0/0 is none. */
void relative_error(arb_t x, const arb_t exact, slong precision);

struct series_item { /* one series for one quantity */
  enum breakdown_source source;
  enum quantity_id quantity;
  const struct scallop_formula *formula; /* of a formula file, or published */
  slong before;                          /* derived: the terms below T^before */
};
struct series_item series_of_formula(const struct scallop_formula *formula, enum quantity_id quantity);
const char *series_name(const struct series_item *item);
/* Is the formula about the quantity, or about one that becomes it: a displacement the mean velocity, a change of
 * velocity the velocity at the end? */
bool series_is_about(const struct scallop_formula *formula, const struct motion *motion, enum quantity_id quantity);
/* All series of a quantity, by their source; order: of the derived one. Returns how many. */
enum { MOST_ITEMS = 32 };
int series_items(struct series_item items[MOST_ITEMS], const struct study *study, enum quantity_id quantity,
                 slong order);
/* Value at T; nan or not finite where there is none. */
void series_item_value(arb_t value, const struct series_item *item, const struct study *study, double T);

/* reach.c. series/exact - 1 as a function of T */
struct comparison {
  const struct study *study;
  struct series_item item;
  double tolerance;
};
/* The error at T by binary128; nan where it has none, 0 where both are 0 */
double comparison_error(const struct comparison *c, double T);
/* Is the error proven to be below the tolerance just below T, and not just above? Of gaits with many pieces that would
 * take seconds: false. */
bool comparison_is_proven(const struct comparison *c, double T);
/* The largest T up to which |error| stays below the tolerance: 0 if it does not as T -> 0, INFINITY if for every T up
 * to permanent rest, nan where there is no such value. */
double comparison_reach(const struct comparison *c);
/* The error for T -> 0, if it settles at a value other than 0; else nan. */
double comparison_limit(const struct comparison *c);

/* radius.c. The radius of convergence of a series */
struct radius {
  const char *method;  /* poles, singularity, or bound: T is proven to be no more than the radius         */
  double T, low, high; /* |T| of the nearest singularity; the radius is proven to be within [low, high]   */
  const char *status;
  char note[800];
};
/* From the coefficients below T^order, where the series is that of a rational function. False: it is not. */
bool radius_from_poles(struct radius *r, const struct series *series, slong order);
/* From the nearest singularity of the branch that the series expand. False: there is none. */
bool radius_from_branch(struct radius *r, struct study *study, enum quantity_id quantity);
/* By the one or the other; false: there is none, as the note says. */
bool radius_of(struct radius *r, struct study *study, enum quantity_id quantity);

#endif
