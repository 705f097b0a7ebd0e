/* A sweep: a list of points. Variables of a group advance together; a product is every combination of its groups, the
 * first slowest; the products of a sweep follow one another. What a variable may set is one table (sweep.c). */
#ifndef SCALLOP_COMPARE_POINTS_SWEEP_H
#define SCALLOP_COMPARE_POINTS_SWEEP_H

#include <stdint.h>

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

struct sweep_end { /* of a range */
  bool is_formula; /* of what is set further out */
  double number;
  struct formula formula;
};

struct sweep_variable {
  const char *name, *sets; /* as of a parameter, or the name of a label */
  enum target target;
  int place;          /* of the number that it sets, of a label among the labels */
  long count;         /* values; 1: the same throughout its group */
  const char **texts; /* a list of values as they were written, in one piece of memory; NULL: a range */
  bool is_log;        /* a range */
  bool is_sampled;    /* a range: count is that of the samples of its group */
  struct sweep_end from, to;
};

/* Samples of all variables of a group at once: points of a Sobol sequence, as GSL has it, or random ones, of which
 * number d of point i is the output i n + d of splitmix64, n being how many numbers a point has. */
enum sampling { SAMPLING_NONE, SAMPLING_SOBOL, SAMPLING_RANDOM };
/* Sobol sequences in so many dimensions (sobol.c); begin NULL: this build has none. */
extern struct sweep_sobol {
  void *(*begin)(int dimensions);
  void (*next)(void *generator, double *x);
  void (*end)(void *generator);
} sweep_sobol;

struct sweep {
  int products; /* at least one, which may have no groups: one point */
  struct sweep_product {
    int groups;
    struct sweep_group {
      int variables;
      struct sweep_variable variable[SWEEP_VARIABLES];
      long count;
      enum sampling sampling; /* of its ranges that are sampled */
      uint64_t seed;
    } group[SWEEP_GROUPS];
  } * product;
};

/* One without values yet. False: there is none of that name, but for labels. */
bool sweep_variable_of_name(struct sweep_variable *variable, const char *name);
/* NULL, or what is wrong with a value of the variable, at the point. Lives until the next call. */
const char *sweep_wrong(const struct sweep_variable *variable, const struct point *point, const char *text);
/* The variable of the product that sets the same as another one, or NULL. */
const struct sweep_variable *sweep_set_twice(const struct sweep_product *product);
/* The variables of all products, one after another: number i, or NULL after the last. */
const struct sweep_variable *sweep_variable(const struct sweep *sweep, int i);
long sweep_points(const struct sweep *sweep); /* 1 where nothing varies */
void sweep_free(struct sweep *sweep);

/* A point of a sweep or of a file, and what is beside its parameters */
struct sweep_place {
  struct point point;
  const char *label[SWEEP_LABELS];          /* NULL: none */
  const char *const *carried;               /* the cells of a row of a file that are no parameters */
  char why[POINT_STATUS];                   /* why the parameters are no point, or "" */
  bool is_unread;                           /* then they are not even known */
  bool ends_group;                          /* it is the last of a group that varies fastest */
  char written[POINT_NUMBERS][DIGITS_TEXT]; /* what values of ranges are written as */
};
/* Goes to a point that has nothing beside it. */
void sweep_place_set(struct sweep_place *place, const struct point *point);
/* What the copy's point was written as is in the copy. */
void sweep_place_copy(struct sweep_place *copy, const struct sweep_place *place);

/* Sets a variable that takes numbers at the place, and what follows from it. */
void sweep_set(struct sweep_place *place, const struct sweep_variable *variable, double value);

/* The value of a formula at the point as it is so far */
typedef double sweep_formula(void *context, const struct sweep_place *place, const struct formula *formula);
/* A way through the points of a sweep, in any order; a step to the next is quickest. */
struct sweep_walk {
  const struct sweep_product *product;        /* of the point where it is; NULL: it is nowhere yet */
  long first;                                 /* the number of that product's first point          */
  long value[SWEEP_GROUPS];                   /* of each group                                     */
  struct sweep_place place[SWEEP_GROUPS + 1]; /* in front of the groups, behind the first, ... */
  const struct sweep_group *sampled;          /* a group of samples, and the one that was drawn last, its numbers: */
  long drawn;
  double sample[SWEEP_VARIABLES]; /* from 0 to 1 */
  void *generator;                /* of GSL      */
};
void sweep_walk_end(struct sweep_walk *walk);
/* The point of that number, from 0, of what varies about a point. */
const struct sweep_place *sweep_point(struct sweep_walk *walk, const struct sweep *sweep, const struct point *about,
                                      long number, sweep_formula *value, void *context);
/* Value i of a variable of a group that takes numbers, and whose ends, if it is a range, are no formulas. */
double sweep_number(struct sweep_walk *walk, const struct sweep_group *group, int variable, long i);

#endif
