/* Pictures of finished tables, drawn by gnuplot in a process of its own.
 *
 * Without a script of its own a plot has curves of its y columns over its x column, whose names label the axes. The rows are
 * read here: gnuplot gets numbers and quoted names, and no name or path can be taken for a command. With a script or a
 * program gnuplot runs that one, with the variables table, output_file and kind (svg, png or pdf), terminal and output set,
 * and tabs between columns. First it runs what plots have in common: for a script the plot_common.gp beside it, if there is
 * one, for a program the one that comes with the tool. */
#ifndef SCALLOP_PLOT_H
#define SCALLOP_PLOT_H

#include <stdbool.h>

struct plot {
  const char *table;    /* a file, in TSV                                                   */
  const char *file;     /* the picture, by its ending .svg, .png or .pdf                    */
  const char *script;   /* a file for gnuplot, or NULL                                      */
  const char *program;  /* the text of a script that comes with the tool, or NULL           */
  const char *title;    /* or NULL                                                          */
  const char *x;        /* columns by their names; with a script they are not looked at     */
  const char *const *y; /* NULL-terminated, 1 to PLOT_QUANTITIES                            */
  const char *by;       /* a curve for each value of this column, or for each combination of those of several, whose names
                           commas separate: PLOT_VALUES curves at most; or NULL */
  bool log_x, log_y;
};

enum { PLOT_QUANTITIES = 16, PLOT_VALUES = 24, PLOT_BY = 8 };

/* What a file is by its ending: "svg", "png", "pdf", or NULL: nothing that can be drawn. */
const char *plot_kind(const char *file);

/* Draws the picture; it is written aside and has its name when it is complete (compare/text/aside.h). False: the message, in the
 * name of a command, is on stderr, and an earlier picture stays. */
bool plot_draw(const struct plot *plot, const char *command);

#endif
