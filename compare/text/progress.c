#include "compare/text/progress.h"

#include <errno.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>

#include "compare/text/stopwatch.h"

enum { DELAY = 2 };                 /* seconds before the first line */
static const double interval = 0.5; /* seconds between lines */

static struct {
  double begun, next; /* next: the earliest time of the next line */
  char what[100];
  long done, all;
} work;
static volatile sig_atomic_t is_written;

static void put(const char *line)
{
  ssize_t written = write(STDERR_FILENO, line, strlen(line));
  (void)written; /* an error cannot be reported */
}

/* Writes the line; a signal handler: for integers and a text snprintf neither allocates nor waits. */
static void tick(int signal)
{
  const int error = errno;
  const double time = stopwatch_now(), passed = time - work.begun;
  const long done = work.done, all = work.all;
  char line[300], count[50] = "", left[80] = "";
  (void)signal;
  if (passed < DELAY || time < work.next)
    return;
  if (done > 0 && done <= all) {
    snprintf(count, sizeof count, " %ld of %ld,", done, all);
    snprintf(left, sizeof left, ", about %ld s left, %ld in 10 s",
             (long)(passed * (double)(all - done) / (double)done + 0.5), (long)(10 * (double)done / passed));
  }
  snprintf(line, sizeof line, "\r\033[Kscallop:%s%s%s %ld s%s", *work.what ? " " : "", work.what, count, (long)passed,
           left);
  put(line);
  is_written = true;
  work.next = time + interval;
  errno = error;
}

void progress_begin(bool quiet)
{
  const struct itimerval timer = { { 0, 100000 }, { 1, 0 } };
  const struct sigaction action = { .sa_handler = tick, .sa_flags = SA_RESTART };
  work.begun = stopwatch_now();
  if (!quiet && isatty(STDERR_FILENO) && sigaction(SIGVTALRM, &action, NULL) == 0)
    setitimer(ITIMER_VIRTUAL, &timer, NULL);
}

/* The handler may read a text that is partly changed; the next line corrects it. */
void progress_show(const char *format, ...)
{
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(work.what, sizeof work.what, format, arguments);
  va_end(arguments);
}

void progress_count(long done, long all)
{
  work.done = done;
  work.all = all;
}

bool progress_is_counted(void) { return work.all > 0; }

void progress_clear(void)
{
  if (!is_written)
    return;
  put("\r\033[K");
  is_written = false;
  work.next = stopwatch_now() + interval;
}

void progress_end(void)
{
  progress_clear();
  progress_show("%s", "");
  progress_count(0, 0);
}
