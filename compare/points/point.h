/* Points: a crawler, its gait, and optionally a phase with a start velocity. A point keeps the text of each number:
 * certified answers take 0.7 as 7/10. */
#ifndef SCALLOP_COMPARE_POINTS_POINT_H
#define SCALLOP_COMPARE_POINTS_POINT_H

#include <stdbool.h>

#include "compare/text/message.h"
#include "model/model.h"

/* The names of the crawler's parameters, NULL-terminated: the numbers, then the gait. The place of a number is its
 * index; v0 has the place behind them. */
enum { CRAWLER_NUMBERS = 7, PLACE_OF_V0 = CRAWLER_NUMBERS, POINT_NUMBERS };
extern const char *const crawler_parameters[];

/* Ratios change body 1 and keep body 2, coefficients of friction set the friction force of their body from its weight,
 * and the Froude number sets T. They depend on other parameters, therefore sweeps apply them after these. */
enum ratio_place { M1_OVER_M2, MU1, MU2, F1_OVER_F2, FROUDE, RATIOS };

enum target { /* up to TARGET_FROUDE numbers, from TARGET_M1_OVER_M2 on ratios; a label is a text in sweeps */
              TARGET_NUMBER,
              TARGET_V0,
              TARGET_M1_OVER_M2,
              TARGET_MU1,
              TARGET_MU2,
              TARGET_F1_OVER_F2,
              TARGET_FROUDE,
              TARGET_GRAVITY,
              TARGET_GAIT,
              TARGET_PHASE,
              TARGET_LABEL
};
struct parameter {
  const char *name, *sets; /* the parameter that it sets: F1 for F1_over_F2, T for froude, else its own name */
  enum target target;
  size_t field;        /* offset of a number in a point */
  const char *allowed; /* values of a number, in words */
};
/* The parameters of a point: the numbers by their places, the ratios, g, gait and phase */
enum { PLACE_OF_RATIOS = POINT_NUMBERS, POINT_PARAMETERS = PLACE_OF_RATIOS + RATIOS + 3 };
extern const struct parameter point_parameters[POINT_PARAMETERS];
/* Returns the parameter called name, or NULL. */
const struct parameter *parameter_named(const char *name);

/* Returns the item of names (NULL-terminated, or NULL) that equals name, or NULL. */
const char *name_among(const char *const *names, const char *name);

struct point {
  struct scallop_crawler crawler;
  struct scallop_crawler usual;       /* default L, T and alpha, unless a measured gait has its own */
  const char *written[POINT_NUMBERS]; /* texts of m1 m2 F1 F2 L T alpha v0; NULL: not given         */
  double ratio[RATIOS];               /* as given, else 0                                           */
  enum scallop_phase_kind phase;
  double v0, gravity; /* gravity: for mu1 and mu2 */
  bool has_gait, has_phase, has_v0;
  bool unreadable; /* the file of a measured gait could not be read */
};

enum { POINT_STATUS = 320 }; /* maximum size of the status of a point */

struct point point_initial(const struct scallop_crawler *usual);

#define USUAL_GRAVITY 9.81 /* the default */

/* Sets a parameter from text; text must outlive the point. Returns NULL or the error, valid until the next call. */
const char *point_set(struct point *point, const char *name, const char *text);
/* Sets a number by its place in the same way. */
const char *point_set_number(struct point *point, int place, const char *text);

/* Sets L, T and alpha that are not given: from a measured gait, else the defaults. Called after the last parameter. */
void point_complete(struct point *point);

/* Return a number of the crawler by its place < CRAWLER_NUMBERS. */
double crawler_number(const struct scallop_crawler *crawler, int place);
double *crawler_field(struct scallop_crawler *crawler, int place);
/* Writes all numbers, in the order of their names. Returns the place of a name, or CRAWLER_NUMBERS if it is not a
 * number. */
void crawler_numbers(const struct scallop_crawler *crawler, double numbers[CRAWLER_NUMBERS]);
int crawler_place(const char *name);
bool same_crawler(const struct scallop_crawler *a, const struct scallop_crawler *b);

#endif
