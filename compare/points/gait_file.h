/* A measured gait: the file, and the spline through it. */
#ifndef SCALLOP_COMPARE_POINTS_GAIT_FILE_H
#define SCALLOP_COMPARE_POINTS_GAIT_FILE_H

#include <stddef.h>

#include "model/gaits.h"

struct gait_row {
  double t, l;
  long line;
};
struct gait_file {
  struct scallop_spline spline;
  double L, T, alpha;    /* of the table itself */
  struct gait_row *rows; /* 0 to last: the last one is the first one, a period later */
  long last;
  long least; /* the first row with the smallest l */
  long most;  /* the first one after it with the largest, from last on a period later */
};

/* Reads a file of t and l, and lays the spline through it. NULL, or what is wrong with it: it lives until the next
 * call; *unreadable: the file could not be read at all. text: the gait's name, which is kept. */
const char *gait_file_read(struct gait_file *gait, const char *name, const char *text, bool *unreadable);
/* The same of a table, which is called name in messages. Needs no files. */
const char *gait_file_of_table(struct gait_file *gait, const char *name, const char *table, const char *text);
void gait_file_free(struct gait_file *gait);

#endif
