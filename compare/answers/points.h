/* Points: rows of parameters from a TSV file, one at a time or in blocks. */
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

/* Points, column by column. 400 kB: however many rows a file has, there is one of these. */
enum { POINT_BLOCK = 1024, POINT_STATUS = 320 };
struct point_block {
  struct scallop_crawlers crawlers;              /* count <= POINT_BLOCK; the columns are the next two                  */
  double numbers[CRAWLER_NUMBERS][POINT_BLOCK];  /* of a row that could not be read, those of the options              */
  const struct scallop_gait *gaits[POINT_BLOCK]; /* likewise                                                        */
  char refused[POINT_BLOCK][POINT_STATUS];       /* why a row could not be read; else ""                              */
};

/* What a command does with a block: adds its rows to the table in their order. Returns how many were not solved. */
typedef long block_rows(struct table *table, const struct options *options, const struct point_block *block);

/* As for_each_point, for options->points in blocks: full ones but for the last, or, for a terminal, of one row. */
enum exit_code for_each_block(const struct options *options, const char *const *columns, block_rows *rows);

/* The leading cells: the crawler's parameters; of a point that was refused, nan and -. */
void point_parameters(struct table *table, const struct options *point, const char *refused);
void point_crawler(struct table *table, const struct scallop_crawler *crawler, const char *refused);

/* Cells for numbers[count] that are all nan, for rows without an answer. */
void point_blank(struct table *table, int count);

#endif
