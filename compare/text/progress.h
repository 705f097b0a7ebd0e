/* One line about long work, on standard error if that is a terminal. Each new one replaces the last. */
#ifndef SCALLOP_PROGRESS_H
#define SCALLOP_PROGRESS_H

#include <stdbool.h>

struct progress {
  bool shown;
};

struct progress progress_begin(bool quiet);
void progress_show(const struct progress *progress, const char *format, ...) __attribute__((format(printf, 2, 3)));
void progress_end(const struct progress *progress); /* clears the line */

#endif
