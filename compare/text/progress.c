#include "compare/text/progress.h"

#include <stdarg.h>
#include <stdio.h>
#include <unistd.h>

struct progress progress_begin(bool quiet) { return (struct progress){ .shown = !quiet && isatty(STDERR_FILENO) }; }

void progress_show(const struct progress *p, const char *format, ...)
{
  va_list arguments;
  if (!p->shown)
    return;
  fputs("\r\033[K", stderr);
  va_start(arguments, format);
  vfprintf(stderr, format, arguments);
  va_end(arguments);
}

void progress_end(const struct progress *p) { progress_show(p, "%s", ""); }
