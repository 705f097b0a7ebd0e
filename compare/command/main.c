#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <gsl/gsl_errno.h>

#include "compare/points/counts.h"
#include "compare/command/commands.h"
#include "compare/text/progress.h"
#include "compare/text/message.h"
#include "compare/text/shipped.h"

static int unknown_command(const char *name)
{
  fprintf(stderr, "scallop: unknown command '%s'%s (see scallop --help)\n", name, did_you_mean(nearest_command(name)));
  return EXIT_USAGE;
}

/* Help and version are output too: a full device is an error. */
static enum exit_code flushed(void)
{
  if (fflush(stdout) == 0 && !ferror(stdout))
    return EXIT_DONE;
  fprintf(stderr, "scallop: cannot write standard output: %s\n", strerror(errno));
  return EXIT_FILE;
}

/* Where standard output or error is closed, a file that is opened would take its place, and messages would be written
 * into it. What stands there instead cannot be written to either. */
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

static bool is_help(const char *word)
{
  return strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0 || strcmp(word, "help") == 0;
}

static int give_help(const char *name)
{
  const struct command *command = name ? command_named(name) : NULL;
  if (name && !command && !is_help(name))
    return unknown_command(name);
  help_of(stdout, command);
  return flushed();
}

static int give_completion(const char *shell)
{
  if (!shell || strcmp(shell, "bash") != 0) {
    fprintf(stderr, "scallop: --completion takes the name of a shell, bash, and not '%s'\n", shell ? shell : "");
    return EXIT_USAGE;
  }
  fputs(shipped_completion->text, stdout);
  return flushed();
}

/* Is argument option, perhaps with =VALUE? Then *value is that, and otherwise stays. */
static bool is_request(const char *argument, const char *option, const char **value)
{
  size_t length = strlen(option);
  if (strncmp(argument, option, length) != 0 || (argument[length] != '\0' && argument[length] != '='))
    return false;
  if (argument[length] == '=')
    *value = argument + length + 1;
  return true;
}

/* What does not begin with a command; value: the argument behind it, or NULL. */
static int answer(const char *first, const char *value)
{
  if (is_help(first))
    return give_help(value);
  if (strcmp(first, "--version") == 0) {
    puts("scallop " SCALLOP_VERSION);
    return flushed();
  }
  if (is_request(first, "--man", &value)) {
    fputs("scallop: there is no --man any more: `make install` installs the manual, which `man scallop` and "
          "`man scallop-steady` show\n",
          stderr);
    return EXIT_USAGE;
  }
  if (is_request(first, "--completion", &value))
    return give_completion(value);
  if (first[0] != '-')
    return unknown_command(first);
  fprintf(stderr,
          "scallop: the command comes first, then options such as '%s': scallop COMMAND %s (see scallop --help)\n",
          first, first);
  return EXIT_USAGE;
}

int main(int count, char **arguments)
{
  gsl_set_error_handler_off();
  keep_places();
  /* A closed pipe and a file that may not grow are failed writes, with a message: half a table is an error. */
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
  static char rows[1 << 16];
  if (!isatty(STDOUT_FILENO))
    setvbuf(stdout, rows, _IOFBF, sizeof rows);
  if (count < 2) {
    help_of(stderr, NULL);
    return EXIT_USAGE;
  }
  const struct command *command = command_named(arguments[1]);
  if (!command)
    return answer(arguments[1], arguments[2]);
  struct arguments read;
  enum exit_code code;
  enum reading reading = options_read(&read, command, commands, count, arguments, &code);
  if (reading == READ_HELP) {
    help_of(stdout, command);
    code = flushed();
  } else if (reading == READ_RUN) {
    point_tell_noise(&read.options.request.point, &read.options.request.style);
    progress_begin(read.options.request.style.quiet);
    code = command_make(&read);
    const struct table_choice *choice = read.options.request.style.choice;
    if (plot_refused() || (choice && choice->refused))
      code = EXIT_USAGE; /* columns were named that the table has not */
    if (read.options.request.stats)
      counts_print();
  }
  progress_clear();
  options_free(&read);
  return (int)code;
}
