/* Sweeps: lists of points. The variables of a group advance together; a product is every combination of its groups, the
 * first slowest; the products of a sweep follow one another. point_parameters lists the parameters that can vary. */
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
  SWEEP_RANGE = 1000000000 /* maximum number of values of a range */
};
#define SWEEP_POINTS 1e15 /* maximum of a product: the sum of all products fits a long */

struct sweep_end { /* an end of a range */
  bool is_formula; /* of parameters of slower groups */
  double number;
  struct formula formula;
};

struct sweep_variable {
  const char *name, *sets; /* as in struct parameter; for a label its name */
  enum target target;
  int place;          /* of the number that it sets, or of the label among the labels */
  long count;         /* number of values; 1: constant in its group */
  const char **texts; /* a list of values as given, in one block of memory; NULL: a range */
  bool is_log;        /* a range with equal ratios */
  bool is_sampled;    /* a range that the samples of its group cover */
  struct sweep_end from, to;
};

/* Samples of all variables of a group: points of GSL's Sobol sequence, or random points, where coordinate d of point i
 * is output i n + d of splitmix64 for n coordinates. */
enum sampling { SAMPLING_NONE, SAMPLING_SOBOL, SAMPLING_RANDOM };
/* Sobol sequences (sobol.c); begin NULL: not in this build */
extern struct sweep_sobol {
  void *(*begin)(int dimensions);
  void (*next)(void *generator, double *x);
  void (*end)(void *generator);
} sweep_sobol;

struct sweep {
  int products; /* 0: one point; a product without groups is one point, too */
  struct sweep_product {
    int groups;
    struct sweep_group {
      int variables;
      struct sweep_variable variable[SWEEP_VARIABLES];
      long count;
      enum sampling sampling; /* of its sampled ranges */
      uint64_t seed;
    } group[SWEEP_GROUPS];
  } * product;
};

/* Sets a variable without values. Returns false if name is not a parameter; it may be a label. */
bool sweep_variable_of_name(struct sweep_variable *variable, const char *name);
/* Returns NULL or the error of a value of the variable at the point, valid until the next call. */
const char *sweep_wrong(const struct sweep_variable *variable, const struct point *point, const char *text);
/* Returns a variable of the product that sets the same parameter as another one, or NULL. */
const struct sweep_variable *sweep_set_twice(const struct sweep_product *product);
/* Returns variable i = 0, 1, ... of all products, or NULL after the last. */
const struct sweep_variable *sweep_variable(const struct sweep *sweep, int i);
long sweep_points(const struct sweep *sweep); /* number of points */
void sweep_free(struct sweep *sweep);

/* A point of a sweep or of a file, with its labels and other cells */
struct sweep_place {
  struct point point;
  const char *label[SWEEP_LABELS];          /* NULL: no label */
  const char *const *carried;               /* the cells of a row of a file that are not parameters */
  char why[POINT_STATUS];                   /* why the parameters are invalid, or "" */
  bool is_unread;                           /* the parameters could not be read */
  bool ends_group;                          /* the last point of the fastest group */
  char written[POINT_NUMBERS][DIGITS_TEXT]; /* texts of values of ranges */
};
/* Sets the point, without labels and cells. */
void sweep_place_set(struct sweep_place *place, const struct point *point);
/* Copies a place; texts of the copied point lie in the copy. */
void sweep_place_copy(struct sweep_place *copy, const struct sweep_place *place);

/* Sets a numeric variable, and the parameters that depend on it. */
void sweep_set(struct sweep_place *place, const struct sweep_variable *variable, double value);

/* A function that evaluates a formula of the parameters set so far */
typedef double sweep_formula(void *context, const struct sweep_place *place, const struct formula *formula);
/* A walk through the points of a sweep, in any order; fastest in the order of the points */
struct sweep_walk {
  const struct sweep_product *product;        /* of the current point; NULL: before the first step */
  long first;                                 /* index of the product's first point                */
  long value[SWEEP_GROUPS];                   /* index of the value of each group                  */
  struct sweep_place place[SWEEP_GROUPS + 1]; /* [g]: groups before g are set                      */
  const struct sweep_group *sampled;          /* the group of the current sample                   */
  long drawn;                                 /* index of the current sample                       */
  double sample[SWEEP_VARIABLES];             /* its coordinates, from 0 to 1                      */
  void *generator;                            /* of GSL */
};
void sweep_walk_end(struct sweep_walk *walk);
/* Returns point `number`, from 0, of the sweep; `about` has the parameters that do not vary. */
const struct sweep_place *sweep_point(struct sweep_walk *walk, const struct sweep *sweep, const struct point *about,
                                      long number, sweep_formula *value, void *context);
/* Returns value i of a numeric variable of a group; the ends of a range must not be formulas. */
double sweep_number(struct sweep_walk *walk, const struct sweep_group *group, int variable, long i);

#endif
