/* A point, and what has been computed of it: each thing when it is first asked for, and once.
 *
 * What tables ask of a point are quantities by name (quantities.h), collected in a struct asked before the first point:
 * so that what nobody asks for is not computed, and what several tables ask for is computed once. */
#ifndef SCALLOP_COMPARE_ANSWERS_AT_H
#define SCALLOP_COMPARE_ANSWERS_AT_H

#include "compare/answers/stretches.h"
#include "compare/points/sweep.h"

enum { DIGITS_OF_DOUBLE = 17, MOST_CERTIFIED_DIGITS = 10000 };

/* What is known before the first point */
struct asked {
  struct quantities quantities;
  bool from_steady;      /* a phase without a v0 starts with the velocity of the steady state; else from rest */
  bool as_written;       /* --certified: parameters with all their digits, regime and modes as they are proven */
  bool certified_errors; /* else errors are those against the double solver */
  double accuracy;       /* of errors: below this part of the exact value they are 0 */
  long digits;           /* of certified values: the most that are wanted */
};
/* Errors against doubles are told down to this part of the exact value. */
#define ACCURACY_OF_DOUBLES 1e-10
struct asked asked_nothing(void);
/* Does any of the quantities need FLINT? */
bool asked_needs_flint(const struct asked *asked);

/* What is solved once at a point; those of two each for the steady state and for the phase, by enum quantity_of */
enum cell { IN_DOUBLE, WITH_ERRORS = 2, IN_BALLS = 4, TURNINGS = 6, FRICTION, CELLS };

struct comparison { /* of a series with what it should be */
  bool done;
  double value, exact, error; /* error: 0 below the accuracy that is wanted */
};

struct at {
  const struct asked *asked;
  bool certified_errors;
  struct point point;
  double v0;                  /* the start of the phase, for what is of it */
  char why[POINT_STATUS];     /* the first thing that could not be done, or "" */
  long failures;              /* so far */
  struct at_flint *flint;     /* NULL: nothing needs it */
  struct swept swept;         /* what is beside the parameters */
  const char *const *carried; /* the cells of the row of a file that are no parameters */
  bool is_outside;            /* the parameters are no point: nothing but they can be told */
  bool is_unread;             /* nor can they */
  bool tells_steady;          /* the row has something of the steady state in doubles */
  bool has_cell[CELLS];
  struct motion motion[2];
  struct answer answer[2];
  double estimate[2][QUANTITIES]; /* of the errors of the numbers of the answer */
  enum scallop_status friction;   /* of the walk that gives its work */
  double onset;
  struct scallop_crawler onset_of;
  bool has[MOST_QUANTITIES];
  double value[MOST_QUANTITIES];
  struct comparison comparison[MOST_QUANTITIES];
  char text[MOTION_WORDS]; /* what at_text returns */
};

/* Notes why something cannot be done, if it is the first. Returns nan. */
double at_fail(struct at *at, const char *why);

/* asked outlives it. False: no memory. */
bool at_init(struct at *at, const struct asked *asked);
void at_clear(struct at *at);

/* Goes to a point. refused: NULL, or why it could not be read. */
void at_move(struct at *at, const struct point *point, const char *refused);
/* Goes to a point of a sweep: index[g] is the place in group g of the product, base the point where nothing varies. */
void at_sweep(struct at *at, const struct point *base, const struct sweep_product *product, const long *index);
/* Before each row of another table: what failed for one table is no matter of the next. */
void at_begin_row(struct at *at);

/* A quantity by its place among those asked for: nan where it cannot be had, and why then says why. Of a text the
 * number that it is. */
double at_number(struct at *at, int quantity);
/* A text; of certified values so many digits, 0: as many as a double has. It lives until the next call. */
const char *at_text(struct at *at, int quantity, long digits);
double at_formula(struct at *at, const struct formula *formula);
/* The start velocity of the phase. */
double at_v0(struct at *at);

/* What a point needs FLINT for: certified answers, and series, which are kept for the last crawlers. Weak: `scallop` is
 * linked without this table, and hands what needs it over to the program that has it. */
extern const struct at_flint_functions {
  struct at_flint *(*create)(const struct asked *asked); /* NULL: no memory */
  void (*free)(struct at_flint *flint);
  /* Goes to the point. The start of its phase is taken from there with the first thing that is of the phase. */
  void (*move)(const struct at *at);
  /* Solves the steady state or the phase of the point, for the functions below. */
  void (*certify)(const struct at *at, enum quantity_of of);
  /* The sum of a derived series, or of its first term, at the point. */
  double (*sum)(struct at *at, const struct quantity *series);
  /* Of a series and the quantity of the certified answer that it is to be; the error is 0 below the accuracy. */
  struct comparison (*compare)(struct at *at, const struct quantity *series, int quantity);
  /* A certified value with so many digits; it lives until the next call. */
  const char *(*text)(struct at *at, const struct quantity *q, long digits);
  /* The regime and the modes of the certified answer; false: there is none. */
  bool (*modes)(struct at *at, enum quantity_of of, enum scallop_regime *regime, struct scallop_modes modes[2]);
} at_flint __attribute__((weak, visibility("hidden")));

#endif
