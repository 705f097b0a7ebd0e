/* Quantities: what can be asked of a point, by name, and in which words and units.
 *
 * All plain names stand in one table, quantity_rows: a number of a motion, with its value in each of the arithmetics
 * that have it (answer.c, answer_flint.c); or a formula of others, which is a row there and no more. Beside these there
 * are the labels of a sweep, the columns of a file of points, and
 *
 *     eq28_displacement, eq14_dT, ...                a formula of the paper, as `series` names it; of a phase from rest
 *     eq14_dT:contraction                         that of the contraction, whatever the point's phase is
 *     derived_8.displacement, derived_8.dxC, ...  the sum of the derived terms below T^8
 *     limit.displacement                          the limit T -> 0: the first term
 *     exact.S, error.S, relative.S   of a series S of these: what it should be, S - exact, and that over |exact|
 *     certified.displacement, ...                 with all digits, proven
 *     reach_1e-2.S   of a series S of the steady state: the largest T up to which |S/exact - 1| stays below 1e-2
 *     value.S        S at this T, from balls; nan where it has none
 *     deviation.S    S/exact - 1 at this T, by binary128; error_limit.S: what its size tends to as T -> 0, if not to 0
 *     verdict.S order.S   of a formula S: is the order that is claimed of its error right, and the one that is proven
 *     v_start_error, ...                          what the double is off by, estimated in wider arithmetic
 *     low.N high.N   of a number N: between these it is, as far as the recording of a measured gait tells
 */
#ifndef SCALLOP_COMPARE_ANSWERS_QUANTITIES_H
#define SCALLOP_COMPARE_ANSWERS_QUANTITIES_H

#include <stdbool.h>

#include "asymptotics/asymptotics.h"
#include "compare/tables/aligned.h"
#include "compare/points/sweep.h"
#include "model/model.h"

/* What a quantity is of: the steady state, or one phase from a start velocity. */
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
  Q_FRICTION_WORK = QUANTITIES, /* columns where their names are asked for: in double they take a second walk */
  Q_COST_OF_TRANSPORT,
  NAMED_QUANTITIES,
  /* No columns, but what formulas of the paper are about: the position of the rear body, from its start, at the first
   * and at the last change of mode; v_end less v0; the velocity of a body that turns, 0. */
  Q_AT_FIRST = NAMED_QUANTITIES,
  Q_AT_LAST,
  Q_CHANGE,
  Q_TURNING,
  ALL_QUANTITIES
};

/* How a quantity is taken; `which` of them: */
enum quantity_kind {
  QUANTITY_ANSWER,   /* enum quantity_id; likewise of estimates, derived series, limits and what is certified */
  QUANTITY_NUMBER,   /* its place among the numbers of a point */
  QUANTITY_RATIO,    /* enum ratio_place */
  QUANTITY_ONSET,    /* of sticking */
  QUANTITY_ESTIMATE, /* of the error of an answer */
  QUANTITY_SAMPLE,   /* enum sample_value */
  QUANTITY_STUDIED,  /* enum studied */
  QUANTITY_FORMULA,  /* of other quantities */
  QUANTITY_EXACT,    /* what a series should be */
  QUANTITY_ERROR,
  QUANTITY_RELATIVE,
  QUANTITY_DATA,      /* of another quantity: which times what a recording does not tell is added, -1 or 1 */
  QUANTITY_PUBLISHED, /* series: of the paper, or of a formula file */
  QUANTITY_DERIVED,
  QUANTITY_LIMIT,
  QUANTITY_GAIT, /* texts */
  QUANTITY_PHASE_NAME,
  QUANTITY_LABEL,   /* its place among them */
  QUANTITY_CARRIED, /* its place among the cells of a file of points */
  QUANTITY_REGIME,
  QUANTITY_MODES,
  QUANTITY_WORDS, /* the modes with their times */
  QUANTITY_STATUS,
  QUANTITY_CERTIFIED,
  QUANTITY_STUDIED_TEXT /* enum studied */
};

enum studied { /* what takes a study of the crawler along T (compare/summary/studied.c) */
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

/* A plain name. The rows of enum quantity_id come first, and behind them those that are formulas of others. */
struct quantity_row {
  const char *name;
  const char *unit;     /* in words, of the parameters' units; 1: a number without one; NULL: it is not told */
  const char *sentence; /* what it is */
  enum quantity_of of;
  bool has_series; /* in powers of T */
  enum quantity_kind kind;
  int which;
  const char *formula;
};
extern const struct quantity_row quantity_rows[]; /* the last without a name */

/* The columns of a motion: the first, and the one after the last; they stand together. */
static inline enum quantity_id quantity_first(enum quantity_of of) { return of == OF_STEADY ? 0 : FIRST_OF_PHASE; }
static inline enum quantity_id quantity_end(enum quantity_of of)
{
  return of == OF_STEADY ? FIRST_OF_PHASE : QUANTITIES;
}

/* What the column of this name is, for people, in their units; NULL: it is none of these. */
const struct column_meaning *quantity_meaning(const char *name);
/* That of this name, or NAMED_QUANTITIES. */
enum quantity_id quantity_of_name(const char *name);

/* What a formula of the paper is about, in a phase of this kind; and the same in the paper's symbols and the names of
 * the bodies of that phase: "x1(T-dT)", "dT". */
enum quantity_id quantity_of_formula(const struct scallop_formula *formula, enum scallop_phase_kind kind);
const char *formula_quantity_text(const struct scallop_formula *formula, enum scallop_phase_kind kind);
/* Does the formula take switching times, or a position at one, as given? */
bool formula_takes_given(const struct scallop_formula *formula);

enum { QUANTITY_NAME = 64, QUANTITY_LABELS = SWEEP_LABELS, MOST_QUANTITIES = 400 };

struct quantity {
  char name[QUANTITY_NAME];
  enum quantity_kind kind;
  int which;
  enum quantity_of motion; /* that it is about */
  int phase;               /* of a formula, and of what is about one: that it is of; -1: that of the point */
  bool from_rest;          /* likewise: whatever the start of the point is */
  bool is_compared;        /* a series with what it should be */
  long order;              /* derived: of the terms below T^order */
  int of;                  /* what is about a series: its place in the list; else -1 */
  double tolerance;        /* of a reach */
  const struct scallop_formula *formula; /* published */
  struct formula *own;                   /* of QUANTITY_FORMULA */
};

/* The quantities that tables ask for, each once. */
struct quantities {
  int count, labels;
  const char *label[QUANTITY_LABELS]; /* freed with it */
  int carries;                        /* columns of a file of points that are no parameters */
  const char *const *carried;
  struct quantity item[MOST_QUANTITIES]; /* last, and of those that are not used not even the memory */
};

/* The place of the quantity called name, which is added if it is new; -1: there is none of that name; -2: no room for
 * more. */
int quantity_named(struct quantities *all, const char *name);
/* The same of a formula of quantities, which is called name from then on; negative also where the formula is wrong. */
int quantity_of_text(struct quantities *all, const char *name, const char *formula);
/* Is it the name of a quantity, or what names of quantities begin with, but not that of a formula? */
bool quantity_is_other(const char *name);
/* The known name nearest to one that is none, or NULL. */
const char *quantity_near(const struct quantities *all, const char *name);

static inline bool quantity_is_text(const struct quantity *q) { return q->kind >= QUANTITY_GAIT; }
static inline bool quantity_is_comparison(const struct quantity *q)
{
  return q->kind >= QUANTITY_EXACT && q->kind <= QUANTITY_RELATIVE;
}
/* Is it a series: published, derived, or the limit? */
static inline bool quantity_is_series(const struct quantity *q)
{
  return q->kind >= QUANTITY_PUBLISHED && q->kind <= QUANTITY_LIMIT;
}

enum { DIGITS_OF_DOUBLE = 17 };
/* Errors against doubles are told down to this part of the exact value. */
#define ACCURACY_OF_DOUBLES 1e-10

/* What tables ask of points, known before the first: quantities, and how well they have to be known */
struct asked {
  const char *command;   /* for messages */
  bool from_steady;      /* a phase without a v0 starts with the velocity of the steady state; else from rest */
  bool tells_no_start;   /* the column v0 is nan where no v0 is given */
  bool certified_errors; /* else errors are those against the double solver */
  double accuracy; /* of errors: below this part of the exact value they are 0; 0: they are as doubles have them */
  long digits;     /* of certified values: the most that are wanted */
  struct quantities quantities;
};
/* With no quantities yet; NULL: no memory. */
struct asked *asked_nothing(const char *command);
void asked_free(struct asked *asked);
/* What needs FLINT: the name of the first of these quantities, or NULL. */
const char *asked_needs_flint(const struct asked *asked);
/* Are errors those against certified values? */
bool asked_certifies_errors(const struct asked *asked);

#endif
