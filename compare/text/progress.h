/* One line about work that takes more than two seconds, on standard error if that is a terminal: what is done, how much
 * of it, the seconds that have passed, and those that are left. A timer of the processor time writes it anew twice a
 * second, whatever the program is doing: a loop only says how far it is. */
#ifndef SCALLOP_COMPARE_TEXT_PROGRESS_H
#define SCALLOP_COMPARE_TEXT_PROGRESS_H

#include <stdbool.h>

void progress_begin(bool quiet); /* Quiet, or without it, or without a terminal: there is no line. */
/* What is being done, and then how much; all: 0 where that is not known. By one thread at a time. */
void progress_show(const char *format, ...) __attribute__((format(printf, 1, 2)));
void progress_count(long done, long all);
bool progress_is_counted(void); /* Is something of which it is known how many there are? */
/* Clears the line, before something else is written: the next one comes half a second later at the earliest. */
void progress_clear(void);
void progress_end(void); /* and forgets what was done */

#endif
