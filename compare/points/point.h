/* A point: a crawler, its gait and, where asked, a phase with a start velocity; and each of its numbers as it was
 * written, so that certified answers can take 0.7 as 7/10. */
#ifndef SCALLOP_COMPARE_POINTS_POINT_H
#define SCALLOP_COMPARE_POINTS_POINT_H

#include <stdbool.h>

#include "compare/text/message.h"
#include "model/model.h"

/* Names of the parameters that describe a crawler, NULL-terminated: first the numbers, then the gait. Numbers have
 * places in their order; v0 has the place behind them. */
enum { CRAWLER_NUMBERS = 7, PLACE_OF_V0 = CRAWLER_NUMBERS, POINT_NUMBERS };
extern const char *const crawler_parameters[];

/* Ratios keep body 2 as it is, coefficients of friction set the force of their body under its weight, and the Froude
 * number sets T. They follow from other parameters, so sweeps settle them
 * when these are set. */
enum ratio_place { M1_OVER_M2, MU1, MU2, F1_OVER_F2, FROUDE, RATIOS };

enum target { /* up to TARGET_FROUDE numbers, the last five ratios; a label is of sweeps: a text beside the point */
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
  size_t field;        /* a number: where it is in a point */
  const char *allowed; /* likewise */
};
/* What can be set of a point: the numbers by their places, the ratios behind them, gait and phase. */
enum { PLACE_OF_RATIOS = POINT_NUMBERS, POINT_PARAMETERS = PLACE_OF_RATIOS + RATIOS + 3 };
extern const struct parameter point_parameters[POINT_PARAMETERS];
/* NULL: there is none of that name. */
const struct parameter *parameter_named(const char *name);

/* The one of names (NULL-terminated, or NULL: none) that is name, or NULL. */
const char *name_among(const char *const *names, const char *name);

struct point {
  struct scallop_crawler crawler;
  struct scallop_crawler usual;       /* L, T and alpha where neither they are written nor the gait has its own   */
  const char *written[POINT_NUMBERS]; /* m1 m2 F1 F2 L T alpha v0 as they were written, NULL where not given      */
  double ratio[RATIOS];               /* as they were set; else 0                                                 */
  enum scallop_phase_kind phase;
  double v0, gravity; /* gravity: of mu1 and mu2 */
  bool has_gait, has_phase, has_v0;
  bool unreadable; /* the file of a measured gait */
};

enum { POINT_STATUS = 320 }; /* the most that is said of a point */

struct point point_initial(const struct scallop_crawler *usual);

#define USUAL_GRAVITY 9.81 /* where none is set */

/* A parameter by its name from text, which must outlive the point. NULL, or what is wrong, until the next call. */
const char *point_set(struct point *point, const char *name, const char *text);
/* The same for a number by its place. */
const char *point_set_number(struct point *point, int place, const char *text);

/* Sets L, T and alpha where they are not written: those of the table of a measured gait, or the usual ones. After the
 * last parameter is set. */
void point_complete(struct point *point);

/* One of the crawler's numbers by its place among them, < CRAWLER_NUMBERS */
double crawler_number(const struct scallop_crawler *crawler, int place);
double *crawler_field(struct scallop_crawler *crawler, int place);
/* All of them, in the order of their names; the place of one, or CRAWLER_NUMBERS where it is none. */
void crawler_numbers(const struct scallop_crawler *crawler, double numbers[CRAWLER_NUMBERS]);
int crawler_place(const char *name);
bool same_crawler(const struct scallop_crawler *a, const struct scallop_crawler *b);

#endif
