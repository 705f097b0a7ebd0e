/* The options of the command line: what they are called, what they take, what --help says of them, and how they are set. */
#ifndef SCALLOP_OPTION_TABLE_H
#define SCALLOP_OPTION_TABLE_H

#include <stdbool.h>

#include "compare/options.h"

/* --digits: of doubles, and where they are proven. */
enum { DOUBLE_DIGITS = 17, MOST_DIGITS = 10000 };

struct option_description {
  const char *name;        /* without the dashes, and after a dot that of the only command it is about         */
  const char *placeholder; /* one for each value it takes, separated by blanks; NULL: a flag                   */
  const char *help;
  const char *(*set)(struct options *, const char *name, const char *text); /* called for each of the values   */
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
