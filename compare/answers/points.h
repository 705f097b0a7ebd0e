/* Points: rows of parameters from a TSV file, one at a time. */
#ifndef SCALLOP_POINTS_H
#define SCALLOP_POINTS_H

#include "compare/command/compare.h"

/* What a command does with one point: adds one row to the table. refused is NULL, or why the point could
 * not even be read; the row then has no numbers and that status. Returns NULL, or why it was not solved. */
typedef const char *point_row(struct table *table, const struct options *point, const char *refused);

/* Runs row over the points of options->points, or over the one point of the options themselves.
 * extra: parameters beyond the crawler's that the points may name (NULL-terminated).
 * Opens and closes the table; columns are written first: the crawler's parameters, extra, and columns. */
enum exit_code for_each_point(const struct options *options, const char *const *extra, const char *const *columns,
                              point_row *row);

enum { POINT_STATUS = 320 }; /* the most that is said of a point */

/* The leading cells: the crawler's parameters; of a point that was refused, nan and -. */
void point_parameters(struct table *table, const struct options *point, const char *refused);
void point_crawler(struct table *table, const struct scallop_crawler *crawler, const char *refused);

/* Cells for numbers[count] that are all nan, for rows without an answer. */
void point_blank(struct table *table, int count);

#endif
