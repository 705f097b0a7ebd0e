/* A progress line for work of more than two seconds, on standard error if that is a terminal: the task, its progress,
 * the elapsed and the remaining seconds. A timer of the processor time rewrites it twice a second; loops only set the
 * counts. */
#ifndef SCALLOP_COMPARE_TEXT_PROGRESS_H
#define SCALLOP_COMPARE_TEXT_PROGRESS_H

#include <stdbool.h>

void progress_begin(bool quiet); /* no line appears if quiet, without this call, or without a terminal */
/* Set the task, and the counts of it; all: 0 if unknown. One thread at a time may call them. */
void progress_show(const char *format, ...) __attribute__((format(printf, 1, 2)));
void progress_count(long done, long all);
bool progress_is_counted(void); /* true if `all` is known */
/* Clears the line before other output; it appears again after half a second or later. */
void progress_clear(void);
void progress_end(void); /* clears the line, the task and the counts */

#endif
