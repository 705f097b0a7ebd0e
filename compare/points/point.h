/* A point: a crawler, its gait and, where asked, a phase with a start velocity; and each of its numbers as it was
 * written, so that certified answers can take 0.7 as 7/10. */
#ifndef SCALLOP_COMPARE_POINTS_POINT_H
#define SCALLOP_COMPARE_POINTS_POINT_H

#include <stdbool.h>

#include "compare/text/message.h"
#include "model/model.h"

/* Names of the parameters that describe a crawler, NULL-terminated: first the numbers, then the gait. */
enum { CRAWLER_NUMBERS = 7 };
extern const char *const crawler_parameters[];

/* The one of names (NULL-terminated, or NULL: none) that is name, or NULL. */
const char *name_among(const char *const *names, const char *name);

struct point {
  struct scallop_crawler crawler;
  struct scallop_crawler usual;         /* L, T and alpha where neither they are written nor the gait has its own   */
  const char *written[CRAWLER_NUMBERS]; /* m1 m2 F1 F2 L T alpha as they were written, NULL where not given        */
  enum scallop_phase_kind phase;
  double v0;
  const char *written_v0;
  bool has_gait, has_phase, has_v0;
  bool unreadable; /* the file of a measured gait */
};

enum { POINT_STATUS = 320 }; /* the most that is said of a point */

struct point point_initial(const struct scallop_crawler *usual);

/* A parameter by its name, m1 m2 F1 F2 L T alpha gait phase v0, from text, which must outlive the point. Returns NULL,
 * or what is wrong with the text. The message lives until the next call. */
const char *point_set(struct point *point, const char *name, const char *text);
/* The same for a number by its place among the crawler's, CRAWLER_NUMBERS for v0. */
const char *point_set_number(struct point *point, int place, const char *text);
/* The same for a number that is known, and written as text. */
const char *point_set_double(struct point *point, int place, double x, const char *text);

/* Sets L, T and alpha where they are not written: those of the table of a measured gait, or the usual ones. After the
 * last parameter is set. */
void point_complete(struct point *point);

/* One of the crawler's numbers by its name; nan: it has none of that name. */
double crawler_parameter(const struct scallop_crawler *crawler, const char *name);
/* The same by its place among them, < CRAWLER_NUMBERS */
double crawler_number(const struct scallop_crawler *crawler, int place);
double *crawler_field(struct scallop_crawler *crawler, int place);
/* All of them, in the order of their names; the place of one, or CRAWLER_NUMBERS where it is none. */
void crawler_numbers(const struct scallop_crawler *crawler, double numbers[CRAWLER_NUMBERS]);
int crawler_place(const char *name);
bool same_crawler(const struct scallop_crawler *a, const struct scallop_crawler *b);

#endif
