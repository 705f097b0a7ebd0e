/* Commands, each in a file of its name, and their arguments: `scallop NAME ...`. */
#ifndef SCALLOP_COMPARE_COMMAND_COMMANDS_H
#define SCALLOP_COMPARE_COMMAND_COMMANDS_H

#include "compare/command/readers.h"

struct arguments;

struct command {
  const char *name;                /* the help is docs/help/NAME.txt */
  const char *operand;             /* "FILE", "FILE..." for several files, or NULL */
  const struct option *options;    /* the last without a name */
  const struct option_rule *rules; /* the last without names; or NULL */
  size_t size;                     /* of its struct of options */
  const void *initial;             /* defaults of this struct except the request; NULL: zeros */
  struct {
    int first, end;
  } quantities;                           /* listed by --help, by enum quantity_id */
  const struct scallop_crawler *defaults; /* NULL: scallop_crawler_default() */
  /* Completes and checks the options after all are read; returns NULL, or an error. May be NULL. */
  const char *(*complete)(void *options);
  /* Plans a table with a row for each point; returns NULL, or an error, valid until the next call; "": it has been
   * printed. Without this function, or if has_rows returns false, `run` writes the table. has_rows NULL: true */
  const char *(*plan)(const void *options, struct rows *rows);
  bool (*has_rows)(const void *options);
  enum exit_code (*run)(const struct arguments *arguments, const void *options);
};
extern const struct command command_phase, command_steady, command_trajectory, command_series, command_claims,
    command_order, command_figure, command_workprec, command_stress, command_breakdown, command_summary, command_run,
    command_merge;
extern const struct command *const commands[]; /* NULL-terminated */

struct arguments {
  const struct command *command;
  char **all;       /* of the program, NULL-terminated */
  int count, place; /* of all; index of the argument being read */
  const char **operands;
  int operand_count;
  unsigned long given; /* a bit for each row of the options, in their order */
  union {              /* the struct of the command; its first member is the request */
    struct request request;
    char bytes[2048];
    void *aligned;
    double aligned_too;
  } options;
};
enum reading { READ_RUN, READ_HELP, READ_REFUSED };
/* Reads all[2], ...: the arguments after the command's name. commands: all commands, for messages about their options,
 * here and later. READ_REFUSED: *code is the exit code, and a message is on stderr. Call options_free in any case. */
enum reading options_read(struct arguments *arguments, const struct command *command,
                          const struct command *const *commands, int count, char **all, enum exit_code *code);
void options_free(struct arguments *arguments);
/* Returns true if the table has a row for each point. */
bool command_has_rows(const struct command *command, const void *options);
/* Reads the formula file, if any, and writes the requested table. */
enum exit_code command_make(const struct arguments *arguments);

/* Sets all defaults. */
void options_initial(struct arguments *arguments, const struct command *command);
/* Returns the option of this name, or NULL if the command does not take it. */
const struct option *option_of(const struct command *command, const char *name);
/* Sets an option of the command. Returns NULL, or an error, valid until the next call. */
const char *option_take(struct arguments *arguments, const struct option *option, const char *const *texts, int count);
/* Returns an error for an option that the command does not take. argument: its spelling */
const char *option_unknown(const struct arguments *arguments, const char *name, const char *argument);
/* Returns a replacement for a removed option, or a removed value of an option; NULL: it never existed. command: "" for
 * options of the program */
const char *option_instead(const char *command, const char *name, const char *value);
/* Completes the options, and checks all rules. False: a message is on stderr. */
bool options_complete(struct arguments *arguments);
/* Returns the first given option of these names, separated by blanks, or NULL. NAME=VALUE: given with this value */
const struct option *given_option(const struct arguments *arguments, const char *names);

/* list.c: returns the command of this name, or NULL. */
const struct command *command_named(const char *name);
/* Prints the page of a command or topic, docs/help/NAME.txt; scripts/dev/man.awk makes the manual of these. */
void help_print(FILE *to, const char *name);

#endif
