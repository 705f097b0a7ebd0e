/* Pictures of finished tables, drawn by gnuplot in a process of its own.
 *
 * gnuplot runs scripts/plots/common.gp, then the script of the picture, with these variables: table and output_file, paths; kind, "svg",
 * "png" or "pdf"; title and x_column; the arrays y_columns and by_columns, of which ys and bys elements are used; log_x and log_y, 0 or
 * 1. Texts reach gnuplot as quoted bytes: no name or path can be taken for a command. */
#ifndef SCALLOP_PLOT_H
#define SCALLOP_PLOT_H

#include <stdbool.h>

enum { PLOT_COLUMNS = 8 };

struct plot {
  const char *table;                /* a file, in TSV                                                       */
  const char *file;                 /* the picture: its name ends in .svg, .png or .pdf                     */
  const char *program;              /* the text of a script that comes with the tool; NULL: curves.gp       */
  const char *script;               /* in place of program: the path of a script, or NULL                   */
  const char *title, *x;            /* or NULL                                                              */
  const char *y[PLOT_COLUMNS + 1];  /* columns, NULL-terminated                                             */
  const char *by[PLOT_COLUMNS + 1]; /* a curve for each combination of the values in these columns          */
  bool log_x, log_y;
};

/* What a file is by its ending: "svg", "png", "pdf", or NULL: nothing that can be drawn. */
const char *plot_kind(const char *file);

/* Draws the picture, which replaces an earlier one when it is complete. False: the message, in the name of a command, is on stderr, and
 * the earlier picture stays. */
bool plot_draw(const struct plot *plot, const char *command);

#endif
