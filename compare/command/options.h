/* The arguments of the command line. A command's options are a struct of its own that begins with struct request
 * (answers/request.h), and a row for each: its name, how it is read, and which field it sets. What it takes, what it is
 * for and what holds where it is not given stands in docs/help/COMMAND.txt. A new option is a field, a row and a line
 * there. One that leaves is a row of removed[] in options.c for a version: {"NAME" or "NAME VALUE", its command or NULL
 * for all, what to use instead}. An option or a value that a command still has is found before that row. */
#ifndef SCALLOP_COMPARE_COMMAND_OPTIONS_H
#define SCALLOP_COMPARE_COMMAND_OPTIONS_H

#include "compare/command/readers.h"

/* What two options have to do with each other: one that has no effect is refused. */
struct option_rule {
  /* Separated by blanks, NAME, or NAME=VALUE for an option with that value: of these none may be given */
  const char *names;
  enum { RULE_WITH, RULE_WITHOUT } when;
  /* one of these, separated by blanks */
  const char *others;
  const char
      *message; /* behind "--NAME "; NULL: that it has nothing to do with the other, or without it              */
};

struct arguments;

/* One command: `scallop NAME`. What --help prints is docs/help/NAME.txt. */
struct command {
  const char *name;
  const char *operand;             /* "FILE", or NULL if there is none; "FILE..." where it takes more than one  */
  const struct option *options;    /* the last without a name                                                   */
  const struct option_rule *rules; /* the last without names; NULL: there are none                               */
  size_t size;                     /* of its struct                                                             */
  const void *initial;             /* what that holds before anything is read, but for the request; NULL: zeros */
  struct {
    int first, end;
  } quantities; /* that --help lists, by enum quantity_id                                    */
  /* NULL: scallop_crawler_default() */
  const struct scallop_crawler *defaults;
  /* What follows from the options, when all are read: NULL, or what is wrong. NULL: nothing. */
  const char *(*complete)(void *options);
  /* What no rule says of the options: false, the message being on stderr. NULL: nothing. */
  bool (*is_sound)(const void *options);
  /* Plans a table with a row for each point: NULL, or what is wrong, until the next call; "": that has been said. No
   * such function, or has_rows is false: the table of `run`. has_rows NULL: always true. */
  const char *(*plan)(const void *options, struct rows *rows);
  bool (*has_rows)(const void *options);
  enum exit_code (*run)(const struct arguments *arguments, const void *options);
};

struct arguments {
  const struct command *command;
  char **all;       /* of the program, NULL-terminated */
  int count, place; /* how many those are, and the one that is being read */
  const char **operands;
  int operand_count;
  unsigned long given; /* a bit for each row of the options, in their order */
  union {              /* the struct of the command; its first member is the request */
    struct request request;
    char room[1024];
    void *aligned;
    double aligned_too;
  } options;
};

/* Has it a row for each point? */
bool command_has_rows(const struct command *command, const void *options);
/* Makes the table that the options ask for, once the book that they name is read. */
enum exit_code command_make(const struct arguments *arguments);

/* Takes one more value of an option of the command. NULL, or what is wrong, until the next call. */
const char *option_take(struct arguments *arguments, const struct option *option, const char *text);
/* What is wrong with the name of an option that the command does not take; argument: as it is written */
const char *option_unknown(const struct arguments *arguments, const char *name, const char *argument);
/* Completes the options. Do all go together? False: the message is on stderr. */
bool options_are_sound(struct arguments *arguments);

/* NULL: the command does not take it. */
const struct option *option_of(const struct command *command, const char *name);
/* The first of the options with these names, separated by blanks, that is given; NULL: none is. NAME=VALUE: given with
 * that value. */
const struct option *given_option(const struct arguments *arguments, const char *names);

/* What holds where no option is given. */
void options_initial(struct arguments *arguments, const struct command *command);

enum reading { READ_RUN, READ_HELP, READ_REFUSED };
/* Reads all[2], ... : the arguments behind the command's name. commands: all of them, to tell options of others from
 * those of none, here and later. READ_REFUSED: *code is the exit code, and the message is on stderr. Whichever it is,
 * options_free ends it. */
enum reading options_read(struct arguments *arguments, const struct command *command,
                          const struct command *const *commands, int count, char **all, enum exit_code *code);
void options_free(struct arguments *arguments);

#endif
