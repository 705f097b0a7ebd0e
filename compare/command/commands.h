/* The commands, each in a file of its name, and what they are given: `scallop NAME` and what is behind it. */
#ifndef SCALLOP_COMPARE_COMMAND_COMMANDS_H
#define SCALLOP_COMPARE_COMMAND_COMMANDS_H

#include "compare/command/readers.h"

struct arguments;

struct command {
  const char *name;                /* what --help prints is docs/help/NAME.txt                               */
  const char *operand;             /* "FILE", or NULL if there is none; "FILE..." where it takes more than one */
  const struct option *options;    /* the last without a name                                                */
  const struct option_rule *rules; /* the last without names; NULL: there are none                           */
  size_t size;                     /* of its struct                                                          */
  const void *initial; /* what that holds before anything is read, but for the request; NULL: zeros          */
  struct {
    int first, end;
  } quantities;                           /* that --help lists, by enum quantity_id */
  const struct scallop_crawler *defaults; /* NULL: scallop_crawler_default()        */
  /* What follows from the options, when all are read, and what no rule says of them: NULL, or what is wrong. NULL:
   * nothing. */
  const char *(*complete)(void *options);
  /* Plans a table with a row for each point: NULL, or what is wrong, until the next call; "": that has been said. No
   * such function, or has_rows is false: the table of `run`. has_rows NULL: always true. */
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
  int count, place; /* how many those are, and the one that is being read */
  const char **operands;
  int operand_count;
  unsigned long given; /* a bit for each row of the options, in their order */
  union {              /* the struct of the command; its first member is the request */
    struct request request;
    char room[2048];
    void *aligned;
    double aligned_too;
  } options;
};
enum reading { READ_RUN, READ_HELP, READ_REFUSED };
/* Reads all[2], ... : the arguments behind the command's name. commands: all of them, to tell options of others from
 * those of none, here and later. READ_REFUSED: *code is the exit code, and the message is on stderr. Whichever it is,
 * options_free ends it. */
enum reading options_read(struct arguments *arguments, const struct command *command,
                          const struct command *const *commands, int count, char **all, enum exit_code *code);
void options_free(struct arguments *arguments);
/* Has it a row for each point? */
bool command_has_rows(const struct command *command, const void *options);
/* Makes the table that the options ask for, once the formula file that they name is read. */
enum exit_code command_make(const struct arguments *arguments);

/* What holds where no option is given. */
void options_initial(struct arguments *arguments, const struct command *command);
/* NULL: the command does not take it. */
const struct option *option_of(const struct command *command, const char *name);
/* Takes the values of an option of the command. NULL, or what is wrong, until the next call. */
const char *option_take(struct arguments *arguments, const struct option *option, const char *const *texts, int count);
/* What is wrong with the name of an option that the command does not take; argument: as it is written */
const char *option_unknown(const struct arguments *arguments, const char *name, const char *argument);
/* What to use in place of an option, or of a value of it, that was there before this version; NULL: it never was.
 * command: "" of the program */
const char *option_instead(const char *command, const char *name, const char *value);
/* Completes the options. Do all go together? False: the message is on stderr. */
bool options_are_sound(struct arguments *arguments);
/* The first of the options with these names, separated by blanks, that is given; NULL: none is. NAME=VALUE: given with
 * that value. */
const struct option *given_option(const struct arguments *arguments, const char *names);

/* list.c: the command of this name; NULL: there is none. */
const struct command *command_named(const char *name);
/* Prints the page of a command or topic: docs/help/NAME.txt, of which scripts/dev/man.awk makes the manual. */
void help_print(FILE *to, const char *name);

#endif
