/* Study of one motion as a function of T: its series, the reach of each, transitions, and radii of convergence. T is
 * the period of a steady state, or the duration of one phase from velocity v0; T of the crawler is not used. Parameters
 * are exactly the doubles given. */
#ifndef SCALLOP_COMPARE_BREAKDOWN_MOTION_H
#define SCALLOP_COMPARE_BREAKDOWN_MOTION_H

#include "asymptotics/derived/singularity.h"
#include "compare/answers/answer_flint.h"
#include "compare/breakdown/breakdown.h"

enum { BREAKDOWN_BITS = 256 }; /* precision of the balls of errors */

/* motion.c. Returns the motion at T. A phase is half of a period, to make its duration exactly T. */
struct motion motion_at(const struct motion *motion, double T);
/* Computes the answer in binary128 at T. A displacement that is 0 in double is 0. */
bool motion_in_wide(const struct motion *motion, double T, struct answer *answer);
/* Returns true if this motion has the quantity, and a series of it. */
bool motion_has(const struct motion *motion, enum quantity_id quantity);
/* Return the Froude number, and the duration at which it is 1. */
double motion_froude(const struct motion *motion, double T);
double motion_natural_time(const struct motion *motion);
/* Returns a T beyond which the modes do not change: the body with the larger friction is permanently at rest. */
double motion_last_time(const struct motion *motion);

/* mode_change.c. Writes the causes of a change of modes, separated by "; "; returns text. Consequences of another cause
 * are omitted: if a body is stuck to the end of a phase, the next one begins from rest, and a change at its beginning
 * is not stated. Reads modes, regime and the sign of v_start of both answers. */
enum { MODE_CHANGE_TEXT = 400 };
const char *mode_change_text(char text[MODE_CHANGE_TEXT], const struct answer *before, const struct answer *after);

/* transitions.c. Transitions end the expansion: as T increases, the sequence of modes changes, or a body turns in
 * another part of the gait. A reversal of the direction of crawling does not end it. */
enum transition_kind { CHANGE_OF_MODES, CHANGE_OF_PART, CHANGE_OF_DIRECTION };
struct transition {
  double T;
  enum transition_kind of;
  char causes[MODE_CHANGE_TEXT];
  struct scallop_modes modes[2]; /* above T */
  const char *evidence;          /* certified, binary128 or double */
  double error;                  /* of T, from the recording of a measured gait; else nan */
  bool is_own;                   /* measured gait: another curve through the recording does not have it */
};
struct transitions {
  struct scallop_modes first[2];            /* modes below the first transition */
  double from, until;                       /* range of T that was searched */
  int per_octave;                           /* steps per octave of T */
  enum transition_kind finest;              /* CHANGE_OF_PART: changes of modes and of parts; else of modes alone */
  bool is_rough;                            /* T to four digits, without a proof */
  long count, reversals, left_out;          /* left_out: other curves through the recording do not have them */
  struct transition *transition, *reversal; /* reversals: changes of direction, of a steady state */
};
/* Finds transitions and reversals. limit_modes: the modes for T -> 0, or "" if unknown. Takes a quarter of a second. A
 * measured gait has no parts; transitions that other curves through its recording do not have are left out. */
void transitions_find(struct transitions *transitions, const struct motion *motion, const char *limit_modes);
void transitions_clear(struct transitions *transitions);
const struct scallop_modes *transitions_modes_at(const struct transitions *transitions, double T);

/* study.c. Results for one motion, each computed once. Terms below T^STUDY_MANY give the best order, and the poles of a
 * rational function; answers in binary128 at STUDY_PLACES (reach.c) are shared by all comparisons. */
enum { STUDY_MANY = 96, STUDY_MANY_BITS = 1024, STUDY_PLACES = 4097 };
struct study_place {
  bool known;
  struct answer exact;
};
struct study { /* initially zero */
  struct motion motion;
  struct scallop_rational_crawler crawler; /* of the motion, in fractions */
  fmpq_t v0;
  struct series_answer derived;           /* terms below T^order; without a series no values, and modes "" */
  struct series_answer many;              /* terms below T^STUDY_MANY; modes NULL: not yet computed */
  struct transitions transitions;         /* until 0: not yet computed */
  struct scallop_singularity singularity; /* of the branch, after at most `crossings` crossings */
  int crossings;                          /* 0: not yet computed */
  bool has_singularity;
  struct study_place *places; /* NULL: no study has begun */
};
/* Begins a study in place of an earlier one, with the derived series below T^order. Returns NULL, or an error of the
 * crawler, without a study. */
const char *study_begin(struct study *study, const struct motion *motion, slong order);
void study_clear(struct study *study);
const struct transitions *study_transitions(struct study *study);
/* Returns the derived series of a quantity, with the terms below T^STUDY_MANY, or NULL. */
const struct series *study_many(struct study *study, enum quantity_id quantity);
/* Returns the reason why no derived series exists. */
const char *study_no_series_text(const struct study *study);
/* Returns the position of T relative to transitions, in words, valid until the next call. */
const char *study_position_text(const struct study *study, double T);
struct best_order { /* truncation with the least error: terms below T^order */
  slong order;
  double error;         /* INFINITY: unknown */
  bool gains_from_more; /* all terms below T^STUDY_MANY are used, and more might reduce the error */
};
/* Finds the best order at T, from the certified value. */
struct best_order study_best_order(struct study *study, enum quantity_id quantity, double T);
/* Sets x to its relative error against exact; 0/0 is 0. */
void relative_error(arb_t x, const arb_t exact, slong precision);

struct series_item { /* one series for one quantity */
  enum breakdown_source source;
  enum quantity_id quantity;
  const struct scallop_formula *formula; /* of a formula file, or published */
  slong before;                          /* derived: the terms below T^before */
};
struct series_item series_of_formula(const struct scallop_formula *formula, enum quantity_id quantity);
const char *series_name(const struct series_item *item);
/* Returns true if the formula gives the quantity, or one to compute it from: a displacement gives the mean velocity, a
 * change of velocity the velocity at the end. */
bool series_is_about(const struct scallop_formula *formula, const struct motion *motion, enum quantity_id quantity);
/* Lists all series of a quantity, by their source; order: of the derived one. Returns their count. */
enum { MAX_ITEMS = 32 };
int series_items(struct series_item items[MAX_ITEMS], const struct study *study, enum quantity_id quantity,
                 slong order);
/* Evaluates the series at T; not finite without a value. */
void series_item_value(arb_t value, const struct series_item *item, const struct study *study, double T);

/* reach.c. series/exact - 1 as a function of T */
struct comparison {
  const struct study *study;
  struct series_item item;
  double tolerance;
};
/* Returns the error at T from binary128; 0 if series and exact value are 0, nan without a value. */
double comparison_error(const struct comparison *c, double T);
/* Returns true if the error is proven to be below the tolerance just below T, and not just above; false for gaits with
 * many pieces, as a proof would take seconds. */
bool comparison_is_proven(const struct comparison *c, double T);
/* Returns the largest T up to which |error| stays below the tolerance: 0 if it is not below it as T -> 0, INFINITY if
 * it is for every T up to permanent rest, nan without a value. */
double comparison_reach(const struct comparison *c);
/* Returns the limit of the error as T -> 0 if it is not 0, else nan. */
double comparison_limit(const struct comparison *c);

/* radius.c. Radius of convergence of a series */
struct radius {
  const char *method;  /* poles, singularity, or bound: T is proven to be no more than the radius         */
  double T, low, high; /* |T| of the nearest singularity; the radius is proven to be within [low, high]   */
  const char *evidence;
  char note[800];
};
/* Finds the radius of the series of a rational function, from the coefficients below T^order. False: it is not one. */
bool radius_from_poles(struct radius *r, const struct series *series, slong order);
/* Finds the radius from the nearest singularity of the branch that is expanded. False: no singularity was found. */
bool radius_from_branch(struct radius *r, struct study *study, enum quantity_id quantity);
/* Finds the radius from poles, else from the branch. False: no radius, and the note has the reason. */
bool radius_of(struct radius *r, struct study *study, enum quantity_id quantity);

#endif
