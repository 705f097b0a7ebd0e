/* A sweep: a list of points. Variables of a group advance together; a product is every combination of its groups, the
 * first slowest; the products of a sweep follow one another. What a variable may set is one table (sweep.c). */
#ifndef SCALLOP_COMPARE_POINTS_SWEEP_H
#define SCALLOP_COMPARE_POINTS_SWEEP_H

#include "compare/points/point.h"
#include "compare/text/digits.h"
#include "asymptotics/formula.h"

enum {
  SWEEP_GROUPS = 10, /* one for each parameter of the command line */
  SWEEP_VARIABLES = 8,
  SWEEP_PRODUCTS = 16,
  SWEEP_LABELS = 8,
  SWEEP_RANGE = 1000000000 /* most values of a range */
};
#define SWEEP_POINTS 1e15 /* of a product at most: they fit a long with room to spare */

/* What a variable sets. F1_over_F2 and m1_over_m2 keep body 2 as it is; froude sets T when all else is set. */
enum sweep_target {
  TARGET_NUMBER, /* m1 m2 F1 F2 L T alpha */
  TARGET_GAIT,
  TARGET_PHASE,
  TARGET_V0, /* up to here what a point has under that name */
  TARGET_F1_OVER_F2,
  TARGET_M1_OVER_M2,
  TARGET_FROUDE,
  TARGET_LABEL /* no parameter: a text beside the point */
};

/* Those of them that follow from parameters: settled when these are set. By their place behind TARGET_F1_OVER_F2. */
enum sweep_ratio { F1_OVER_F2, M1_OVER_M2, FROUDE, SWEEP_RATIOS };

struct sweep_end { /* of a range */
  bool is_formula; /* of what is set further out */
  double number;
  struct formula formula;
};

struct sweep_variable {
  const char *name, *sets; /* the parameter that it sets: F1 for F1_over_F2, T for froude, else its own name */
  enum sweep_target target;
  int place;          /* of a number among the crawler's, of a label among the labels */
  long count;         /* values; 1: the same throughout its group */
  const char **texts; /* a list of values as they were written; NULL: a range */
  char *kept;         /* what they point into, where it is the variable's own */
  bool is_log;        /* a range */
  bool needs_onset;   /* to know its ends: they are formulas of sticking_onset */
  struct sweep_end from, to;
};

struct sweep_group {
  int variables;
  struct sweep_variable variable[SWEEP_VARIABLES];
  long count;
};
struct sweep_product {
  int groups;
  struct sweep_group group[SWEEP_GROUPS];
};
struct sweep {
  int products; /* at least one, which may have no groups: one point */
  struct sweep_product *product;
};

/* Sets name, sets, target and place, but of a label. False: there is no such variable. */
bool sweep_variable_of_name(struct sweep_variable *variable, const char *name);
/* NULL, or what is wrong with a value of the variable, at the point. Lives until the next call. */
const char *sweep_wrong(const struct sweep_variable *variable, const struct point *point, const char *text);
/* The variable of the product that sets the same as another one, or NULL. */
const struct sweep_variable *sweep_set_twice(const struct sweep_product *product);
/* The variables of all products, one after another: number i, or NULL after the last. */
const struct sweep_variable *sweep_variable(const struct sweep *sweep, int i);
long sweep_points(const struct sweep *sweep);
void sweep_variable_free(struct sweep_variable *variable);
void sweep_free(struct sweep *sweep);

/* A point of a sweep or of a file, and what is beside its parameters */
struct sweep_place {
  struct point point;
  const char *label[SWEEP_LABELS];                /* NULL: none */
  double ratio[SWEEP_RATIOS];                     /* as they are set; else nan */
  const char *const *carried;                     /* the cells of a row of a file that are no parameters */
  char why[POINT_STATUS];                         /* why the parameters are no point, or "" */
  bool is_unread;                                 /* then they are not even known */
  bool ends_group;                                /* it is the last of a group that varies fastest */
  char written[CRAWLER_NUMBERS + 1][DIGITS_TEXT]; /* what values of ranges are written as; the last: v0 */
};
/* Goes to a point that has nothing beside it. */
void sweep_place_set(struct sweep_place *place, const struct point *point);
/* What the copy's point was written as is in the copy. */
void sweep_place_copy(struct sweep_place *copy, const struct sweep_place *place);

/* Sets a variable that takes numbers at the place, and what follows from it. */
void sweep_set(struct sweep_place *place, const struct sweep_variable *variable, double value);

/* Where a sweep is. What a group that stays sets is not worked out again. Zero at first. */
struct sweep_cursor {
  const struct sweep_product *product;
  long index[SWEEP_GROUPS];
  double value[SWEEP_GROUPS][SWEEP_VARIABLES]; /* of ranges */
};
/* The value of a formula at the point as it is so far */
typedef double sweep_formula(void *context, const struct formula *formula);
/* Moves the place, which begins as { 0 }, to index[g] in group g of the product; base: where nothing varies. */
void sweep_move(struct sweep_cursor *cursor, struct sweep_place *place, const struct point *base,
                const struct sweep_product *product, const long *index, sweep_formula *value, void *context);
/* Advances index by one point. False: it was the last, and index is that of the first again. */
bool sweep_next(const struct sweep_product *product, long index[SWEEP_GROUPS]);

#endif
