#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include "compare/compare.h"

const struct command *const commands[] = { &command_phase,
                                           &command_steady,
                                           &command_trajectory,
                                           &command_series,
                                           &command_claims,
                                           &command_order,
                                           &command_figure,
                                           &command_workprec,
                                           &command_stress,
                                           &command_breakdown,
                                           NULL };

void complain(const char *command, const char *format, ...)
{
  va_list arguments;
  va_start(arguments, format);
  fprintf(stderr, "scallop %s: ", command);
  vfprintf(stderr, format, arguments);
  fputc('\n', stderr);
  va_end(arguments);
}
