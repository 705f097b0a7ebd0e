/* A measured gait, and the table that it is read from: rows of t and l, or of t and the positions x1 and x2. */
#ifndef SCALLOP_COMPARE_POINTS_GAIT_FILE_H
#define SCALLOP_COMPARE_POINTS_GAIT_FILE_H

#include "model/measured/measured.h"

struct gait_file {
  struct scallop_measured *measured;
  struct scallop_measured_gait best;
  char columns[120]; /* which columns were taken for what */
};

/* Reads FILE, FILE:KIND, FILE:KIND=SIGMA or one of these with :period=P behind it; KIND is monotone, cubic, smooth or
 * phases, SIGMA the noise of a row. A header names the columns, t and l or x1 and x2, with or without units; without
 * one they are t and l. Rows without a number are left out. NULL, or what is wrong with it, which lives until the next
 * call; *unreadable: the file could not be read at all. text: the gait's name, which is kept. */
const char *gait_file_read(struct gait_file *gait, const char *name, const char *text, bool *unreadable);
/* The same of a table, which is called name in messages. Needs no files. */
const char *gait_file_of_table(struct gait_file *gait, const char *name, const char *table, const char *text);
void gait_file_free(struct gait_file *gait);

#endif
