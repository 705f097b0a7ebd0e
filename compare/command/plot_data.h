/* The curves of a plot, read from its table. */
#ifndef SCALLOP_PLOT_DATA_H
#define SCALLOP_PLOT_DATA_H

#include "compare/command/plot.h"

/* Points in the order of the rows. Where a row has none that the axes can show, x and y are nan: the curve is
 * interrupted. */
struct plot_curve {
  struct plot_point {
    double x, y;
  } * points;
  long count, room;
  long shown; /* those that are not nan */
};

struct plot_data {
  int quantities, values;   /* y columns; values of the column by, 1 where there is none */
  char *value[PLOT_VALUES]; /* as they stand in the table                               */
  struct plot_curve curves[PLOT_VALUES][PLOT_QUANTITIES];
  struct plot_point least, most; /* of all points that are shown */
};

/* False: the message, in the name of a command, is on stderr, and there is nothing to free. */
bool plot_data_read(struct plot_data *data, const struct plot *plot, const char *command);
void plot_data_free(struct plot_data *data);

#endif
