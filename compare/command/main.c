/* Program: the command of the first argument, help, version and completion. */
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "compare/command/commands.h"
#include "compare/points/counts.h"
#include "compare/text/progress.h"
#include "compare/text/shipped.h"

/* Prints a message without the name of a command. */
static enum exit_code refuse(const char *what)
{
  fprintf(stderr, "scallop: %s\n", what);
  return EXIT_USAGE;
}

/* Commands and topics have a page each. The name nearest to an unknown command may be a topic. */
static enum exit_code refuse_name(const char *what, const char *name, const char *before_topic)
{
  const char *near = nearest_in(name, shipped_help, sizeof *shipped_help);
  near = near && !command_named(near) ? wrong_text("%s%s", before_topic, near) : near;
  return refuse(wrong_text("unknown %s '%.400s'%s (see scallop --help)", what, name, did_you_mean(near)));
}

/* Flushes help or version; a full device is an error. */
static enum exit_code flushed(void)
{
  if (fflush(stdout) == 0 && !ferror(stdout))
    return EXIT_DONE;
  fprintf(stderr, "scallop: cannot write standard output: %s\n", strerror(errno));
  return EXIT_FILE;
}

/* Opens closed standard output or error for reading: otherwise the next file would get its number, and messages. */
static void reserve_streams(void)
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

/* Handles arguments that do not begin with a command. next: the second argument, or NULL */
static enum exit_code answer(const char *first, const char *next)
{
  char option[OPTION_VALUE];
  snprintf(option, sizeof option, "%.*s", (int)strcspn(first, "="), first);
  const char *value = strchr(first, '=') ? strchr(first, '=') + 1 : next;
  const char *instead = strncmp(option, "--", 2) == 0 ? option_instead("", option + 2, NULL) : NULL;
  const char *page = next && !is_help(next) ? next : "scallop";
  if (instead)
    return refuse(wrong_text("%s is no longer there: %s", option, instead));
  if (is_help(first) && !shipped_text(shipped_help, page))
    return refuse_name("command or topic", page, "");
  if (strcmp(option, "--completion") == 0 && (!value || strcmp(value, "bash") != 0))
    return refuse(wrong_text("--completion takes the name of a shell, bash, and not '%s'", value ? value : ""));
  if (is_help(first))
    help_print(stdout, page);
  else if (strcmp(first, "--version") == 0)
    puts("scallop " SCALLOP_VERSION);
  else if (strcmp(option, "--completion") == 0)
    fputs(shipped_completion->text, stdout);
  else if (first[0] != '-')
    return refuse_name("command", first, "help ");
  else
    return refuse(
        wrong_text("the command comes first, then options such as '%.80s': scallop COMMAND %.80s (see scallop "
                   "--help)",
                   first, first));
  return flushed();
}

static enum exit_code run(const struct arguments *a)
{
  const struct request *r = &a->options.request;
  print_recording(&r->point, &r->style);
  progress_begin(r->style.quiet);
  counts_are_printed = r->stats;
  if (r->threads.given) { /* before OpenMP is loaded */
    char number[24];
    snprintf(number, sizeof number, "%ld", r->threads.value);
    setenv("OMP_NUM_THREADS", number, true);
  }
  enum exit_code code = command_make(a);
  if (code == EXIT_DONE)
    print_decimal_commas(&r->sweep, &r->style);
  if (r->stats)
    counts_print();
  /* a name in --columns or --plot may not be a column of the table */
  return plot_refused() || (r->style.choice && r->style.choice->refused) ? EXIT_USAGE : code;
}

int main(int count, char **arguments)
{
  reserve_streams();
  /* A closed pipe and a file at its size limit are failed writes, with a message: half a table is an error. */
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
  static char rows[1 << 16];
  if (!isatty(STDOUT_FILENO))
    setvbuf(stdout, rows, _IOFBF, sizeof rows);
  if (count < 2) {
    help_print(stderr, "scallop");
    return EXIT_USAGE;
  }
  const struct command *command = command_named(arguments[1]);
  if (!command)
    return (int)answer(arguments[1], arguments[2]);
  struct arguments read;
  enum exit_code code;
  enum reading reading = options_read(&read, command, commands, count, arguments, &code);
  if (reading == READ_HELP) {
    help_print(stdout, command->name);
    code = flushed();
  } else if (reading == READ_RUN)
    code = run(&read);
  progress_clear();
  options_free(&read);
  return (int)code;
}
