#include <signal.h>
#include <stdio.h>
#include <string.h>

#include <gsl/gsl_errno.h>

#include "compare/compare.h"

static void help(FILE *to)
{
  fputs("Example: scallop steady --F1 3 --T 0.5\n\n"
        "scallop COMMAND [options]: a two-body crawler on dry friction, its exact motion and the\n"
        "asymptotic series said to describe it, side by side.\n\nCommands:\n", to);
  for (const struct command *const *c = commands; *c; c++)
    fprintf(to, "  %-12s %s\n", (*c)->name, (*c)->summary);
  fputs("\nscallop COMMAND --help tells what a command takes and prints. scallop --version: the version.\n"
        "Exit codes: 0 done, 1 a check failed, 2 bad usage or input, 3 a computation could not be done,\n"
        "4 a file could not be read or written.\n", to);
}

static int unknown(const char *name)
{
  enum { MOST = 32 };
  const char *names[MOST + 1] = { NULL };
  for (int i = 0; i < MOST && commands[i]; i++)
    names[i] = commands[i]->name;
  const char *near = nearest(name, names);
  fprintf(stderr, "scallop: unknown command '%s'%s%s%s; see scallop --help\n", name,
          near ? ": did you mean '" : "", near ? near : "", near ? "'?" : "");
  return EXIT_USAGE;
}

int main(int count, char **arguments)
{
  gsl_set_error_handler_off();
  signal(SIGPIPE, SIG_IGN); /* a closed pipe is a failed write, with a message */
  if (count < 2) {
    help(stderr);
    return EXIT_USAGE;
  }
  if (strcmp(arguments[1], "--help") == 0 || strcmp(arguments[1], "-h") == 0 || strcmp(arguments[1], "help") == 0) {
    help(stdout);
    return EXIT_DONE;
  }
  if (strcmp(arguments[1], "--version") == 0) {
    puts("scallop " SCALLOP_VERSION);
    return EXIT_DONE;
  }
  for (const struct command *const *c = commands; *c; c++)
    if (strcmp(arguments[1], (*c)->name) == 0) {
      struct options options;
      int code;
      return options_read(&options, *c, count - 2, arguments + 2, &code) ? (int)(*c)->run(&options) : code;
    }
  return unknown(arguments[1]);
}
