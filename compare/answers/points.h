/* Points: the one of the command line, those of its lists and ranges, or rows of parameters from a TSV file, one at a
 * time; and what of a point stands in tables. */
#ifndef SCALLOP_COMPARE_ANSWERS_POINTS_H
#define SCALLOP_COMPARE_ANSWERS_POINTS_H

#include "compare/points/gaits.h"
#include "compare/points/point.h"
#include "compare/points/sweep.h"
#include "compare/text/message.h"
#include "compare/text/table.h"
#include "compare/text/values.h"

/* What every command is asked: of which point, or of the points in which file, and how its table is written. The
 * options of a command are a struct that begins with it. */
struct request {
  struct style style;
  struct point point;
  struct sweep sweep; /* lists and ranges of options: no product, or one, at whose first point point is */
  const char *points; /* file name, "-" for standard input, or NULL */
  const char *book;   /* file name of a book of formulas, or NULL     */
  bool stats;         /* prints afterwards what was computed */
};

/* What a command adds to the row of a point behind its parameters: the cells of its columns. refused is NULL, or why
 * the point could not even be read; the row then has no numbers and that status. Returns NULL, or why it was not
 * solved. */
struct sheet;
typedef const char *point_row(struct table *table, const struct point *point, const void *context, const char *refused);

/* A row has the crawler's parameters and extra; then, of a file, the columns that are no parameters, byte for byte, but
 * for those whose names are taken; then columns. */
struct point_table {
  const char *const *extra; /* parameters beyond the crawler's that the points may name, phase or v0, NULL-terminated */
  const char *const *columns; /* of the command; of a sheet the texts of its own names */
  struct sheet *sheet;        /* which has the columns and rows, or NULL: row adds the cells of the columns */
  bool v0_may_be_nan;         /* where none was given */
  bool as_written;            /* parameters with all the digits that were given */
  point_row *row;
  const void *context;
};
/* Are there, or may there be, many points? */
bool has_many_points(const struct request *request);
/* Runs row over the points of request->points, over those of request->sweep, or over the one point of the request
 * itself. Opens and closes the table. */
enum exit_code for_each_point(const struct request *request, const struct point_table *of);

/* The one of names (NULL-terminated, or NULL: none) that is name, or NULL. */
const char *name_among(const char *const *names, const char *name);

/* " m1=1 ...": the parameters without those in not_held; as below */
enum { PARAMETERS_TEXT = CRAWLER_NUMBERS * (NUMBER_LENGTH + 8) + GAIT_TEXT };
void parameters_text(char text[PARAMETERS_TEXT], const struct point *point, const char *const *not_held,
                     bool as_written);
/* "# parameters: m1=1 ...": the parameters that hold in every row. Left out are those in not_held (NULL-terminated, or
 * NULL: none), which vary or are not used. as_written: numbers with all the digits that were given; else doubles. No
 * line where nothing holds. */
void note_parameters(struct table *table, const struct point *point, const char *const *not_held, bool as_written);

/* Prints a note where the gait is a noisy measurement: its spline goes through every point. */
void point_tell_noise(const struct point *point, const struct style *style);

#endif
