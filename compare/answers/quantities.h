/* Quantities of a point: their names, descriptions and units.
 *
 * One table, quantity_rows, has all plain names: numbers of a motion, computed by answer.c and answer_flint.c in each
 * arithmetic, and formulas of other quantities. Further names are the labels of a sweep, the columns of a file of
 * points, and
 *
 *     eq28_displacement, eq14_dT, ...             a formula of the paper, named as in `series`
 *     eq14_dT:contraction                         a formula for a phase from rest, in the contraction
 *     derived_8.displacement, derived_8.dxC, ...  the sum of the derived terms below T^8
 *     limit.displacement                          the limit T -> 0: the first term
 *     exact.S, error.S, relative.S   for a series S of these: the exact value, S - exact, and error.S / |exact.S|
 *     certified.displacement, ...                 a proven value with all digits
 *     reach_1e-2.S   for a series S of the steady state: the largest T up to which |S/exact - 1| stays below 1e-2
 *     value.S        S at this T, from balls; nan: no value
 *     deviation.S    S/exact - 1 at this T, in binary128; error_limit.S: the limit of its size as T -> 0, if not 0
 *     verdict.S order.S   for a formula S: whether the claimed order of its error is right, and the proven order
 *     v_start_error, ...                          the error of the double, estimated in wider arithmetic
 *     low.N high.N   for a number N: its bounds from the recording of a measured gait
 */
#ifndef SCALLOP_COMPARE_ANSWERS_QUANTITIES_H
#define SCALLOP_COMPARE_ANSWERS_QUANTITIES_H

#include <stdbool.h>

#include "asymptotics/asymptotics.h"
#include "compare/tables/aligned.h"
#include "compare/points/sweep.h"
#include "model/model.h"

/* The motion of a quantity: the steady state, or one phase from a start velocity. */
enum quantity_of { OF_STEADY, OF_PHASE };

enum quantity_id {
  Q_FROUDE,
  Q_V_START,
  Q_V_MID,
  Q_DISPLACEMENT,
  Q_MEAN_VELOCITY,
  Q_MULTIPLIER,
  FIRST_OF_PHASE,
  Q_T1 = FIRST_OF_PHASE,
  Q_DT,
  Q_V_END,
  Q_DX1,
  Q_DX2,
  Q_DXC,
  QUANTITIES,
  Q_FRICTION_WORK = QUANTITIES, /* columns only by name: in double they take a second pass */
  Q_COST_OF_TRANSPORT,
  NAMED_QUANTITIES,
  /* Quantities of the paper's formulas without a column: the position of the rear body, relative to its start, at the
   * first and at the last change of mode; v_end - v0; the velocity of a body that turns, 0. */
  Q_AT_FIRST = NAMED_QUANTITIES,
  Q_AT_LAST,
  Q_CHANGE,
  Q_TURNING,
  ALL_QUANTITIES
};

/* The kind of a quantity; the comments state the meaning of `which` */
enum quantity_kind {
  QUANTITY_ANSWER,   /* enum quantity_id, also for ESTIMATE, DERIVED, LIMIT and CERTIFIED */
  QUANTITY_NUMBER,   /* place among the numbers of a point */
  QUANTITY_RATIO,    /* enum ratio_place */
  QUANTITY_ONSET,    /* the onset of sticking */
  QUANTITY_ESTIMATE, /* estimated error of an answer */
  QUANTITY_SAMPLE,   /* enum sample_value */
  QUANTITY_STUDIED,  /* enum studied */
  QUANTITY_FORMULA,  /* a formula of other quantities */
  QUANTITY_EXACT,    /* the exact value of a series */
  QUANTITY_ERROR,
  QUANTITY_RELATIVE,
  QUANTITY_DATA,      /* -1 or 1: another quantity plus `which` times its uncertainty from the recording */
  QUANTITY_PUBLISHED, /* from here series: a formula of the paper, or of a formula file */
  QUANTITY_DERIVED,
  QUANTITY_LIMIT,
  QUANTITY_GAIT, /* from here texts */
  QUANTITY_PHASE_NAME,
  QUANTITY_LABEL,   /* place among the labels */
  QUANTITY_CARRIED, /* place among the cells of a file of points */
  QUANTITY_REGIME,
  QUANTITY_MODES,
  QUANTITY_WORDS, /* the modes with their times */
  QUANTITY_STATUS,
  QUANTITY_CERTIFIED,
  QUANTITY_STUDIED_TEXT /* enum studied */
};

enum studied { /* results of a study of the crawler along T (compare/summary/studied.c) */
               STUDIED_REACH,
               STUDIED_VALUE,
               STUDIED_DEVIATION,
               STUDIED_ERROR_LIMIT,
               STUDIED_ORDER,
               STUDIED_TRANSITION_T,
               STUDIED_BEST_ORDER,
               STUDIED_BEST_ERROR,
               STUDIED_VERDICT,
               STUDIED_TRANSITION,
               STUDIED_REVERSALS
};

enum sample_value { SAMPLE_T, SAMPLE_X1, SAMPLE_X2, SAMPLE_XC, SAMPLE_V1, SAMPLE_V2, SAMPLE_L, SAMPLE_VALUES };

/* A plain name. The rows of enum quantity_id come first; rows that are formulas follow. */
struct quantity_row {
  const char *name;
  const char *unit;     /* in words, in the parameters' units; "1": dimensionless; NULL: not printed */
  const char *sentence; /* the description */
  enum quantity_of of;
  bool has_series; /* in powers of T */
  enum quantity_kind kind;
  int which;
  const char *formula;
};
extern const struct quantity_row quantity_rows[]; /* the last has name NULL */

/* Return the first column of a motion, and the end of its contiguous columns. */
static inline enum quantity_id quantity_first(enum quantity_of of) { return of == OF_STEADY ? 0 : FIRST_OF_PHASE; }
static inline enum quantity_id quantity_end(enum quantity_of of)
{
  return of == OF_STEADY ? FIRST_OF_PHASE : QUANTITIES;
}

/* Returns the meaning and unit of the column called name, until the next call; NULL: unknown, or without a unit. */
const struct column_meaning *quantity_meaning(const char *name);
/* Returns NAMED_QUANTITIES if no quantity has the name. */
enum quantity_id quantity_of_name(const char *name);

/* Return the quantity of a formula of the paper in a phase of this kind, and its name in the paper's symbols, with the
 * bodies of that phase: "x1(T-dT)", "dT". */
enum quantity_id quantity_of_formula(const struct scallop_formula *formula, enum scallop_phase_kind kind);
const char *formula_quantity_text(const struct scallop_formula *formula, enum scallop_phase_kind kind);
/* Returns true if the formula takes switching times, or a position at one, as given. */
bool formula_takes_given(const struct scallop_formula *formula);

enum { QUANTITY_NAME = 64, QUANTITY_LABELS = SWEEP_LABELS, MAX_QUANTITIES = 400 };

struct quantity {
  char name[QUANTITY_NAME];
  enum quantity_kind kind;
  int which;
  enum quantity_of motion;
  int phase;        /* enum scallop_phase_kind of a published formula and its errors; -1: the phase of the point */
  bool from_rest;   /* the phase begins at rest, with any v0 of the point */
  bool is_compared; /* a series, compared with the exact value */
  long order;       /* QUANTITY_DERIVED: the terms below T^order */
  int of;           /* place of the series, or number, that the quantity is derived from; else -1 */
  double tolerance; /* STUDIED_REACH */
  const struct scallop_formula *formula; /* QUANTITY_PUBLISHED */
  struct formula *own;                   /* QUANTITY_FORMULA */
};

/* The quantities that tables request, each once. */
struct quantities {
  int count, labels;
  const char *label[QUANTITY_LABELS]; /* owned */
  int carries;                        /* columns of a file of points that are not parameters */
  const char *const *carried;
  struct quantity item[MAX_QUANTITIES]; /* last: unused items are not initialised, so their pages are not used */
};

/* Returns the place of the quantity called name and adds it if it is new; -1: unknown name; -2: the list is full. */
int quantity_named(struct quantities *all, const char *name);
/* Adds a formula of quantities under a name. Returns its place; negative: the formula is wrong, or the list is full. */
int quantity_of_text(struct quantities *all, const char *name, const char *formula);
/* Returns true if name is a quantity other than a formula of the paper, or begins like one. */
bool quantity_is_other(const char *name);
/* Returns the known name nearest to an unknown one, or NULL. */
const char *quantity_near(const struct quantities *all, const char *name);

static inline bool quantity_is_text(const struct quantity *q) { return q->kind >= QUANTITY_GAIT; }
static inline bool quantity_is_comparison(const struct quantity *q)
{
  return q->kind >= QUANTITY_EXACT && q->kind <= QUANTITY_RELATIVE;
}
/* Returns true for a series: published, derived, or the limit. */
static inline bool quantity_is_series(const struct quantity *q)
{
  return q->kind >= QUANTITY_PUBLISHED && q->kind <= QUANTITY_LIMIT;
}

enum { DIGITS_OF_DOUBLE = 17 };
/* Errors against doubles are 0 below this part of the exact value. */
#define ACCURACY_OF_DOUBLES 1e-10

/* The quantities that tables request of points, and their accuracy; complete before the first point */
struct requirements {
  const char *command;   /* for messages */
  bool from_steady;      /* a phase without v0 starts with the velocity of the steady state; else from rest */
  bool v0_only_if_given; /* the column v0 is nan if v0 is not given */
  bool certified_errors; /* errors against certified values; else against the double solver */
  double accuracy;       /* errors below this part of the exact value are 0; 0: errors are not rounded */
  long digits;           /* maximum of the certified values */
  struct quantities quantities;
};
/* Returns a list without quantities, or NULL: out of memory. */
struct requirements *requirements_new(const char *command);
void requirements_free(struct requirements *required);
/* Returns the name of the first quantity that needs FLINT, or NULL. */
const char *quantity_needing_flint(const struct requirements *required);
/* Returns true if errors are against certified values. */
bool errors_are_certified(const struct requirements *required);

#endif
