/* What gnuplot is told. */
#ifndef SCALLOP_PLOT_SCRIPT_H
#define SCALLOP_PLOT_SCRIPT_H

#include <stdio.h>

#include "compare/command/plot_data.h"

/* The curves of a plot into the file that gnuplot calls output. */
void plot_script_write(FILE *to, const struct plot *plot, const struct plot_data *data, const char *output);

/* The plot's own script or program, in the same place. common: the script to load before a script, or NULL. */
void plot_script_load(FILE *to, const struct plot *plot, const char *common, const char *output);

#endif
