/* Pictures of finished tables. scripts/plots/plot.sh draws them, with gnuplot: it is handed the table, what that is of,
 * and the options, as variables of its environment, so that no text is a command. */
#ifndef SCALLOP_COMPARE_TABLES_PLOT_H
#define SCALLOP_COMPARE_TABLES_PLOT_H

#include <stdbool.h>

#include "compare/tables/aligned.h"

/* Each text is as an option takes it (docs/reference/plots.md), or NULL. */
struct plot {
  const char *file;               /* the picture: its name ends in .svg, .png or .pdf; NULL: no picture     */
  const char *table;              /* a file, in TSV                                                         */
  const char *of;                 /* what the table is of (scripts/plots/plot/request.awk); NULL: of a scene */
  const char *picture;            /* the name of a picture that comes with the tool: in place of that kind's */
  const char *script;             /* or the path of a script for gnuplot                                     */
  const char *title, *x, *y, *by; /* y and by: names with commas between                                    */
  const char *x_range, *y_range, *size;
  bool log_x, log_y;
  column_meaning *meaning; /* of columns, or NULL */
};

/* Is that the name of a picture? */
bool plot_kind(const char *file);

/* Sets what an option says, "plot" or "plot-" and a name. The text must outlive the plot. NULL, or what is wrong, until
 * the next call. */
const char *plot_set(struct plot *plot, const char *option, const char *text);

/* Draws the picture, which replaces an earlier one when it is complete. False: the message, in the name of a command,
 * is on stderr, and the earlier picture stays. */
bool plot_draw(const struct plot *plot, const char *command);

/* Has a picture been refused for what is asked, such as a column that is not there? Then the command ends with
 * EXIT_USAGE. */
bool plot_refused(void);

#endif
