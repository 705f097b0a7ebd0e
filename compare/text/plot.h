/* Pictures of finished tables, drawn by gnuplot in a process of its own.
 *
 * gnuplot runs scripts/plots/common.gp, then the script of the picture, with these variables: table and output_file,
 * paths; kind, "svg", "png" or "pdf"; title and x_column; the arrays y_columns and by_columns, of which ys and bys
 * elements are used; log_x and log_y, 0 or 1; width and height, 0: those of the script; low_x, high_x, low_y and
 * high_y, where has_x_range or has_y_range is 1; abs_y, 1: magnitudes; over_column; limit; unit(column), a function:
 * the unit of a column, or "". Texts reach gnuplot as quoted bytes: no name or path can be taken for a command. */
#ifndef SCALLOP_COMPARE_TEXT_PLOT_H
#define SCALLOP_COMPARE_TEXT_PLOT_H

#include <stdbool.h>

#include "compare/text/aligned.h"

enum { PLOT_COLUMNS = 8, LEAST_SIZE = 200, MOST_SIZE = 10000 };

struct plot_range {
  double low, high; /* low < high */
  bool is_given, is_log;
};

struct plot {
  const char *of;                   /* what the table is of: a name in drawing.c, or any other                */
  const char *table;                /* a file, in TSV                                                       */
  const char *file;                 /* the picture: its name ends in .svg, .png or .pdf; NULL: no picture   */
  const char *program;              /* the text of a script that comes with the tool; NULL: curves.gp       */
  const char *script;               /* in place of program: the path of a script, or NULL                   */
  const char *title, *x;            /* or NULL                                                              */
  const char *y[PLOT_COLUMNS + 1];  /* columns, NULL-terminated                                             */
  const char *by[PLOT_COLUMNS + 1]; /* a curve for each combination of the values in these columns          */
  bool log_x, log_y;
  struct plot_range x_range, y_range;
  bool magnitudes;         /* are drawn, of numbers with a sign                                 */
  const char *over;        /* the column that y is divided by, or NULL                          */
  double limit;            /* where a line is drawn; NAN: none                                  */
  long width, height;      /* of an SVG, in pixels; 0: as the script has it */
  column_meaning *meaning; /* of columns, or NULL                           */
};

/* What a file is by its ending: "svg", "png", "pdf", or NULL: nothing that can be drawn. */
const char *plot_kind(const char *file);

/* Sets what an option says of the plot: "plot", or "plot-" and a name as a scene's plot has it (docs/plots.md). NULL,
 * or what is wrong, until the next call. */
const char *plot_set(struct plot *plot, const char *option, const char *text);

/* Fills in, from what the table is of and from the rows of plot->table, what the plot leaves open: the script for this
 * kind of table, the columns of both axes and of the curves, and whether an axis is logarithmic. False: the message is
 * on stderr: a column that is named is not there, or the table cannot be drawn. */
bool plot_choose(struct plot *plot, const char *command);

/* Is the name of the picture free, or that of a plain file? False: the message is on stderr. */
bool plot_may_replace(const struct plot *plot, const char *command);

/* Draws the picture, which replaces an earlier one when it is complete. False: the message, in the name of a command,
 * is on stderr, and the earlier picture stays. */
bool plot_draw(const struct plot *plot, const char *command);

#endif
