/* The options of the command line: what they are called, what they take, what --help says of them, and how they are set. */
#ifndef SCALLOP_OPTION_TABLE_H
#define SCALLOP_OPTION_TABLE_H

#include <stdbool.h>

#include "compare/command/options.h"

/* --digits: of doubles, and where they are proven. */
enum { DOUBLE_DIGITS = 17, MOST_DIGITS = 10000 };
/* That this text is no --digits for the command; the message lives until the next call of this or of not_allowed. */
const char *digits_refused(const struct command *command, const char *text);

enum { OPTION_VALUE = 48, OPTION_RANGE = 80 };

/* What is done with options of one kind. */
struct option_kind {
  const char *(*set)(struct options *, const char *name, const char *text); /* called for each of the values */
  /* The value that options hold; NULL: an option of this kind has none unless it is given */
  void (*show)(const struct options *, const char *name, char text[OPTION_VALUE]);
  /* What follows help and depends on the command; NULL: nothing does */
  void (*add)(char text[OPTION_RANGE], const struct command *command);
};

struct option_description {
  const char *name;        /* without the dashes, and after a dot that of the only command it is about         */
  const char *placeholder; /* one for each value it takes, separated by blanks; NULL: a flag                   */
  const char *help;
  const struct option_kind *kind;
};

/* Of an option that several commands take, the description for this one comes first. NULL: no command takes it. */
const struct option_description *describe_option(const char *name, const struct command *command);

/* Does the command take it? */
bool option_accepted(const struct command *command, const char *name);

/* How many values it takes. */
int option_value_count(const struct option_description *option);

/* Does it take more than one operand? Then what it calls them ends in "...". */
bool many_operands(const struct command *command);

#endif
