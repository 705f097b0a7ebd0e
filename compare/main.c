#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <gsl/gsl_errno.h>

#include "compare/compare.h"

static void help(FILE *to)
{
  fputs("Example: scallop steady --F1 3 --T 0.5\n\n"
        "scallop COMMAND [options]: a two-body crawler on dry friction, its exact motion and the\n"
        "asymptotic series said to describe it, side by side.\n\nCommands:\n",
        to);
  for (const struct command *const *c = commands; *c; c++)
    fprintf(to, "  %-12s %s\n", (*c)->name, (*c)->summary);
  fputs("\nscallop COMMAND --help tells what a command takes and prints. scallop --version: the version.\n"
        "Exit codes: 0 done, 1 a check failed, 2 bad usage or input, 3 a computation could not be done,\n"
        "4 a file or standard output could not be read or written. A closed pipe is such a case: scallop ... | head -n 1.\n"
        "A run that a signal ends returns the signal's. Whatever ends it, -o FILE leaves the earlier file or the new one.\n",
        to);
}

static int unknown(const char *name)
{
  if (name[0] == '-') {
    fprintf(stderr, "scallop: the command comes first, then options such as '%s': scallop COMMAND %s (see scallop --help)\n",
            name, name);
    return EXIT_USAGE;
  }
  enum { MOST = 32 };
  const char *names[MOST + 1] = { NULL };
  for (int i = 0; i < MOST && commands[i]; i++)
    names[i] = commands[i]->name;
  const char *near = nearest(name, names);
  fprintf(stderr, "scallop: unknown command '%s'%s%s%s (see scallop --help)\n", name, near ? ": did you mean '" : "",
          near ? near : "", near ? "'?" : "");
  return EXIT_USAGE;
}

/* Help and version are output too: a full device is an error. */
static int flushed(void)
{
  if (fflush(stdout) == 0 && !ferror(stdout))
    return EXIT_DONE;
  fprintf(stderr, "scallop: cannot write standard output: %s\n", strerror(errno));
  return EXIT_FILE;
}

/* Where standard output or error is closed, a file that is opened would take its place, and messages would be written into it. What
 * stands there instead cannot be written to either. */
static void keep_places(void)
{
  for (int place = STDOUT_FILENO; place <= STDERR_FILENO; place++) {
    if (fcntl(place, F_GETFD) >= 0)
      continue;
    int other = open("/", O_RDONLY);
    if (other < 0 || other == place)
      continue;
    dup2(other, place);
    close(other);
  }
}

static const struct command *command_named(const char *name)
{
  const struct command *const *c = commands;
  while (*c && strcmp(name, (*c)->name) != 0)
    c++;
  return *c;
}

int main(int count, char **arguments)
{
  gsl_set_error_handler_off();
  keep_places();
  /* A closed pipe and a file that may not grow are failed writes, with a message: half a table is an error. */
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
  if (count < 2) {
    help(stderr);
    return EXIT_USAGE;
  }
  const char *first = arguments[1];
  bool asks_help = strcmp(first, "--help") == 0 || strcmp(first, "-h") == 0 || strcmp(first, "help") == 0;
  const struct command *about = asks_help && count > 2 ? command_named(arguments[2]) : NULL;
  if (asks_help) {
    if (about)
      options_help(stdout, about);
    else
      help(stdout);
    return flushed();
  }
  if (strcmp(first, "--version") == 0) {
    puts("scallop " SCALLOP_VERSION);
    return flushed();
  }
  const struct command *command = command_named(first);
  if (!command)
    return unknown(first);
  struct options options;
  int code;
  if (options_read(&options, command, count, arguments, &code))
    return (int)command->run(&options);
  return code == EXIT_DONE ? flushed() : code;
}
