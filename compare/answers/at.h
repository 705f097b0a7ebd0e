/* A point, and what has been computed of it: each thing when it is first asked for, and once.
 *
 * What tables ask of a point are quantities by name (quantities.h), collected in a struct asked before the first point:
 * so that what nobody asks for is not computed, and what several tables ask for is computed once. */
#ifndef SCALLOP_COMPARE_ANSWERS_AT_H
#define SCALLOP_COMPARE_ANSWERS_AT_H

#include "compare/answers/answer.h"
#include "compare/points/sweep.h"

/* The motions of a point: its steady state; an extension or a contraction with the start velocity of the point; and
 * either of these from rest. */
enum motion_of_point { STEADY_STATE, FROM_START, FROM_REST = FROM_START + 2, POINT_MOTIONS = FROM_REST + 2 };

/* The steady state counts as an extension. */
static inline enum scallop_phase_kind phase_kind(enum motion_of_point m)
{
  return m == STEADY_STATE ? SCALLOP_EXTENSION : (enum scallop_phase_kind)((m - FROM_START) % 2);
}

struct solved { /* one of them, as far as it has been asked for */
  bool in_double, with_errors, with_second_walk;
  struct motion motion;
  struct answer answer;
  double estimate[QUANTITIES]; /* of the errors of the numbers of the answer */
};

struct series_error { /* of a series with what it should be */
  bool done;
  double value, exact, error; /* error: 0 below the accuracy that is wanted */
};

/* What a recording does not tell of the numbers that low. and high. are asked of (scallop_measured_error) */
struct at_data {
  struct at *at; /* for points with other gaits */
  bool done;
  double error[MOST_QUANTITIES];
};

struct at {
  const struct asked *asked;
  bool certified_errors;
  struct sweep_place place;
  char why[POINT_STATUS]; /* the first thing that could not be done, or "" */
  long failures;          /* so far */
  long moves;             /* so far: points differ where it does */
  struct at_flint *flint; /* NULL: nothing has needed it yet */
  struct at_study *study; /* likewise */
  struct at_data *data;   /* likewise */
  bool is_outside;        /* the parameters are no point: nothing but they can be told */
  bool as_written;        /* regime, modes and status are those of certified answers: set for each row */
  struct solved solved[POINT_MOTIONS];
  double onset;
  struct scallop_crawler onset_of;
  bool has[MOST_QUANTITIES];
  double value[MOST_QUANTITIES];
  struct series_error comparison[MOST_QUANTITIES];
  char text[MOTION_WORDS]; /* what at_text returns */
};

/* Notes why something cannot be done, if it is the first. Returns nan. */
double at_fail(struct at *at, const char *why);

/* asked outlives it. NULL: the message is on stderr. */
struct at *at_new(const struct asked *asked);
void at_free(struct at *at); /* or NULL */

/* Goes to the point in at->place. */
void at_move(struct at *at);
/* A formula of what is set so far, for the ends of ranges; at->place becomes that. */
double at_formula_so_far(void *at, const struct sweep_place *place, const struct formula *formula);
/* Before each row of another table: what failed for one table is no matter of the next. */
void at_begin_row(struct at *at);

/* A quantity by its place among those asked for: nan where it cannot be had, and why then says why. Of a text the
 * number that it is. */
double at_number(struct at *at, int quantity);
/* How far a number may be off for what the recording of a measured gait does not tell; nan: its low. and high. are not
 * asked for, or there is no recording. Of these two the same. */
double at_data_error(struct at *at, int quantity);
/* A text; of certified values so many digits, 0: as many as a double has. It lives until the next call. */
const char *at_text(struct at *at, int quantity, long digits);
double at_formula(struct at *at, const struct formula *formula);
/* The start velocity of the phase. */
double at_v0(struct at *at);

/* What a point needs FLINT for: certified answers, and series. Motions are those of the point, and their start
 * velocities known. NULL until the part of the program that needs FLINT is there (answers/flint.h), which such
 * quantities take for granted. */
struct at_flint_functions {
  void (*free)(struct at_flint *flint);
  /* The sum of a derived series, or of its first term. */
  double (*sum)(struct at *at, const struct quantity *series, enum motion_of_point m);
  /* Of a series and the quantity of the certified answer that it is to be; the error is 0 below the accuracy. */
  struct series_error (*compare)(struct at *at, const struct quantity *series, int quantity, enum motion_of_point m);
  /* A certified value with so many digits, or the certified regime or modes; it lives until the next call. */
  const char *(*text)(struct at *at, const struct quantity *q, long digits, enum motion_of_point m);
  void (*end_thread)(void); /* by a thread that has used any of these, at its end */
};
extern const struct at_flint_functions *at_flint;

/* Quantities that take a study of the crawler along T: likewise */
struct at_study_functions {
  void (*free)(struct at_study *study);
  double (*number)(struct at *at, const struct quantity *q);
  const char *(*text)(struct at *at, const struct quantity *q); /* it lives until the next call */
};
extern const struct at_study_functions *at_study;

#endif
