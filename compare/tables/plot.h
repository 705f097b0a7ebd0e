/* Plots of finished tables by scripts/plots/plot.sh and gnuplot. The script receives the table, its kind and the
 * options in environment variables, therefore no text can become a command. */
#ifndef SCALLOP_COMPARE_TABLES_PLOT_H
#define SCALLOP_COMPARE_TABLES_PLOT_H

#include <stdbool.h>

#include "compare/tables/aligned.h"

/* Each text is the value of an option (docs/reference/plots.md), or NULL. */
struct plot {
  const char *file;               /* the picture: its name ends in .svg, .png or .pdf; NULL: no picture      */
  const char *table;              /* a file in TSV                                                           */
  const char *of;                 /* kind of the table (scripts/plots/plot/request.awk); NULL: of a scene    */
  const char *picture;            /* name of a picture of the tool, in place of the picture of that kind     */
  const char *script;             /* or path of a gnuplot script                                             */
  const char *title, *x, *y, *by; /* y and by: names between commas                                          */
  const char *x_range, *y_range, *size;
  bool log_x, log_y;
  column_meaning *meaning; /* of columns, or NULL */
};

/* Returns true if the name ends like a picture's. */
bool plot_kind(const char *file);

/* Sets the value of an option, "plot" or "plot-NAME". The text must outlive the plot. Returns NULL or the error, valid
 * until the next call. */
const char *plot_set(struct plot *plot, const char *option, const char *text);

/* Draws the picture and replaces an earlier one atomically. Returns false after a message of `command` on stderr;
 * the earlier picture remains. */
bool plot_draw(const struct plot *plot, const char *command);

/* Returns true if a plot was refused for its options, such as a missing column: the exit code is then EXIT_USAGE. */
bool plot_refused(void);

#endif
