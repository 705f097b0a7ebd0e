/* Measured gaits, from tables with rows of t and l, or of t and the positions x1 and x2. */
#ifndef SCALLOP_COMPARE_POINTS_GAIT_FILE_H
#define SCALLOP_COMPARE_POINTS_GAIT_FILE_H

#include "model/measured/measured.h"

struct gait_file {
  struct scallop_measured *measured;
  struct scallop_measured_gait best;
  char columns[120]; /* a text: which columns are t and l */
};

/* Reads FILE, FILE:KIND, FILE:KIND=SIGMA or one of these followed by :period=P; KIND is monotone, cubic, smooth or
 * phases, SIGMA the noise of a row. A header names the columns, t and l or x1 and x2, with or without units; without a
 * header they are t and l. Rows without a number are skipped. text: the gait's name; it must outlive the gait.
 * Returns NULL or the error, valid until the next call; *unreadable: the file could not be read. */
const char *gait_file_read(struct gait_file *gait, const char *name, const char *text, bool *unreadable);
/* Reads a table from memory; name: its name in messages, with the same options behind it. */
const char *gait_file_of_table(struct gait_file *gait, const char *name, const char *table, const char *text);
void gait_file_free(struct gait_file *gait);

#endif
