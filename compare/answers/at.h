/* The evaluation of a point: each quantity is computed once, when a table first requests it.
 *
 * The quantities of all tables (quantities.h) are collected in a struct requirements before the first point: the
 * program computes only these, and each once for all tables. */
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

struct solution { /* one motion; the flags state what has been computed */
  bool in_double, with_errors, is_complete;
  struct motion motion;
  struct answer answer;
  double estimate[QUANTITIES]; /* the estimated errors of the answer */
};

struct series_error { /* a series compared with the exact value */
  bool done;
  double value, exact, error; /* error: 0 below the requested accuracy */
};

/* The uncertainty that a recording leaves in the numbers behind low. and high. (scallop_measured_error) */
struct at_data {
  struct at *at; /* evaluates the other gaits */
  bool done;
  double error[MAX_QUANTITIES];
};

struct at {
  const struct requirements *required;
  bool certified_errors;
  struct sweep_place place;
  char why[POINT_STATUS]; /* the reason of the first failure, or "" */
  long failures;          /* so far */
  long moves;             /* counts points and alternative gaits: data of another count are of another crawler */
  struct at_flint *flint; /* these three: NULL until first needed */
  struct at_study *study;
  struct at_data *data;
  bool is_outside; /* the parameters are invalid: only these are known */
  bool as_written; /* regime, modes and status are certified; set for each row */
  struct solution solved[POINT_MOTIONS];
  double onset;
  struct scallop_crawler onset_of;
  bool has[MAX_QUANTITIES];
  double value[MAX_QUANTITIES];
  struct series_error comparison[MAX_QUANTITIES];
  char text[MOTION_WORDS]; /* what at_text returns */
};

/* Counts a failure and stores the reason of the first one. Returns nan. */
double at_fail(struct at *at, const char *why);

/* Returns NULL after a message on stderr. required must outlive the evaluation. */
struct at *at_new(const struct requirements *required);
void at_free(struct at *at); /* may be NULL */

/* Begins with the point that at->place has been set to. */
void at_begin_point(struct at *at);
/* Evaluates a formula, an end of a range, of the variables set so far; copies place to at->place. */
double at_formula_so_far(void *at, const struct sweep_place *place, const struct formula *formula);
/* Clears the failures of the previous table before a row of another one. */
void at_begin_row(struct at *at);

/* Returns a quantity by its place in required->quantities, a text converted to a number; nan: the point has no value,
 * or the computation failed and at->why is set. */
double at_number(struct at *at, int quantity);
/* Returns the uncertainty of a number, or of its low. and high., that comes from the recording of a measured gait; nan:
 * neither low. nor high. is requested, or the gait is not measured. */
double at_data_error(struct at *at, int quantity);
/* Returns a text, valid until the next call. digits: of certified values; 0: DIGITS_OF_DOUBLE. */
const char *at_text(struct at *at, int quantity, long digits);
double at_formula(struct at *at, const struct formula *formula);
/* Returns the start velocity of the phase. */
double at_v0(struct at *at);

/* The functions that need FLINT: certified answers and series of a motion of the point with known start velocity. NULL
 * until the part of the program with FLINT is loaded (answers/flint.h); at_new loads it for quantities that need it. */
struct at_flint_functions {
  void (*free)(struct at_flint *flint);
  /* Returns the sum of a derived series, or its first term. */
  double (*sum)(struct at *at, const struct quantity *series, enum motion_of_point m);
  /* Compares a series with a quantity of the certified answer; the error is 0 below the accuracy. */
  struct series_error (*compare)(struct at *at, const struct quantity *series, int quantity, enum motion_of_point m);
  /* Returns a certified value with digits, or the certified regime or modes, valid until the next call. */
  const char *(*text)(struct at *at, const struct quantity *q, long digits, enum motion_of_point m);
  void (*end_thread)(void); /* called by each thread that has used the functions, at its end */
};
extern const struct at_flint_functions *at_flint;

/* The functions for quantities that need a study of the crawler along T; NULL until loaded */
struct at_study_functions {
  void (*free)(struct at_study *study);
  double (*number)(struct at *at, const struct quantity *q);
  const char *(*text)(struct at *at, const struct quantity *q); /* valid until the next call */
};
extern const struct at_study_functions *at_study;

#endif
