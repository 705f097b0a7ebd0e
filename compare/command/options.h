/* The arguments of the command line. A command's options are a struct of its own that begins with struct request
 * (answers/request.h), and a row for each: its name, how it is read, and which field it sets. What it takes, what it is
 * for and what holds where it is not given stands in docs/help/COMMAND.txt. A new option is a field, a row and a line
 * there. One that leaves is a row of removed[] in options.c for a version: {"NAME" or "NAME VALUE", its command or NULL
 * for all, what to use instead}. An option or a value that a command still has is found before that row. */
#ifndef SCALLOP_COMPARE_COMMAND_OPTIONS_H
#define SCALLOP_COMPARE_COMMAND_OPTIONS_H

#include <float.h>
#include <stdbool.h>
#include <stddef.h>

#include "compare/answers/rows.h"
#include "compare/text/values.h"

/* --digits: of doubles, and where they are proven. */
enum { DOUBLE_DIGITS = 17, MOST_DIGITS = 10000, OPTION_VALUE = 48 };

/* How the value of an option is read. Called for each of its values, with the text of it. Returns NULL, or what is
 * wrong; the message lives until the next call. */
struct option;
typedef const char *option_reader(void *options, const struct option *option, const char *text);
option_reader read_parameter, /* of the point, or what varies, by its name                              */
    read_product,             /* begins another product of what varies                                  */
    read_flag,                /* bool                                                                   */
    read_real,                /* struct given_number, from least to most                                */
    read_whole,               /* struct given_count, likewise                                           */
    read_word,                /* struct given_word, one of words                                        */
    read_text,                /* const char *, one for each value, not empty: allowed says what it is   */
    read_format, read_output, /* of the style                                                           */
    read_digits,              /* likewise, from 1 to most                                               */
    read_plot,                /* likewise, of its plot, by its name                                     */
    read_choice;              /* likewise: which columns                                                */

struct option {
  const char *name; /* without the dashes */
  option_reader *read;
  size_t field; /* in the struct of the command */
  double least, most;
  const char *const *words; /* NULL-terminated */
  const char *allowed;
  int values;       /* how many it takes where it is more than one */
  const char *also; /* what else it may be called by who does not know its name: "did you mean"; or NULL */
};

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

/* Rows that many commands have. */
#define OPTION(named, reader, ...) \
  { \
    .name = named, .read = reader, __VA_ARGS__ \
  }
#define OPTION_FIELD(type, member) .field = offsetof(struct type, member)
#define OPTION_POINT(name) OPTION(name, read_parameter, )
#define OPTIONS_TO_L \
  OPTION("m1", read_parameter, .also = "mass1"), OPTION("m2", read_parameter, .also = "mass2"), \
      OPTION("F1", read_parameter, .also = "friction1"), OPTION("F2", read_parameter, .also = "friction2"), \
      OPTION("L", read_parameter, .also = "stroke")
#define OPTION_T OPTION("T", read_parameter, .also = "period")
#define OPTIONS_ALPHA_GAIT OPTION_POINT("alpha"), OPTION_POINT("gait")
#define OPTIONS_CRAWLER OPTIONS_TO_L, OPTION_T, OPTIONS_ALPHA_GAIT
#define OPTIONS_PHASE OPTION_POINT("phase"), OPTION_POINT("v0")
#define OPTIONS_VARY \
  OPTION_POINT("F1_over_F2"), OPTION_POINT("m1_over_m2"), OPTION_POINT("froude"), OPTION_POINT("label"), \
      OPTION("and", read_product, )
#define OPTION_FLAG(name, type, member) OPTION(name, read_flag, OPTION_FIELD(type, member))
#define OPTION_TEXT(name, type, member, what) OPTION(name, read_text, OPTION_FIELD(type, member), .allowed = what)
#define OPTION_WORD(name, type, member, list) OPTION(name, read_word, OPTION_FIELD(type, member), .words = list)
#define OPTION_COUNT(name, type, member, low, high) \
  OPTION(name, read_whole, OPTION_FIELD(type, member), .least = low, .most = high)
#define OPTION_NUMBER(name, type, member, ...) OPTION(name, read_real, OPTION_FIELD(type, member), __VA_ARGS__)
#define FROM_TO(low, high, what) .least = low, .most = high, .allowed = what
#define FINITE FROM_TO(-DBL_MAX, DBL_MAX, "a finite number")
#define POSITIVE FROM_TO(DBL_TRUE_MIN, DBL_MAX, "a finite number > 0")
#define OPTIONS_ERRORS \
  OPTION_NUMBER("accuracy", request, accuracy, FROM_TO(1e-300, 0.999, "a number between 1e-300 and 1")), \
      OPTION_WORD("reference", request, reference, reference_words)
extern const char *const reference_words[];
#define OPTION_POINTS OPTION_TEXT("points", request, points, "a file name")
#define OPTION_BOOK OPTION_TEXT("book", request, book, "a file name")
#define OPTION_FORMAT OPTION("format", read_format, )
#define OPTION_DIGITS(range, high) OPTION("digits", read_digits, .most = high, .allowed = range)
#define DIGITS_OF_DOUBLES "from 1 to 17"
#define DIGITS_PROVEN(where) DIGITS_OF_DOUBLES "; " where " to 10000"
#define OPTION_OUTPUT OPTION("output", read_output, )
#define OPTION_PLOT(name) OPTION(name, read_plot, )
#define OPTIONS_PLOT \
  OPTION_PLOT("plot"), OPTION_PLOT("plot-x"), OPTION_PLOT("plot-y"), OPTION_PLOT("plot-by"), \
      OPTION_PLOT("plot-x-range"), OPTION_PLOT("plot-y-range"), OPTION_PLOT("plot-title"), OPTION_PLOT("plot-size")
#define OPTION_STATS OPTION_FLAG("stats", request, stats)
#define OPTION_QUIET OPTION_FLAG("quiet", request, style.quiet)
/* The last rows: NO_MORE_OPTIONS ends each table, and those of a table of doubles end with OPTIONS_OF_DOUBLES. */
#define NO_MORE_OPTIONS OPTION(NULL, NULL, )
#define OPTIONS_LAST OPTION("columns", read_choice, ), OPTION_OUTPUT, OPTION_QUIET, NO_MORE_OPTIONS
#define OPTIONS_OF_DOUBLES OPTION_FORMAT, OPTION_DIGITS(DIGITS_OF_DOUBLES, DOUBLE_DIGITS), OPTIONS_LAST

/* Are there as many digits as the numbers have, of doubles unless they are proven? False: the message is on stderr.
 * range: DIGITS_PROVEN. */
bool digits_hold(const struct style *style, bool proven, const char *range);

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
/* How many values it takes. */
int option_values(const struct option *option);

/* What holds where no option is given. */
void options_initial(struct arguments *arguments, const struct command *command);

enum reading { READ_RUN, READ_HELP, READ_REFUSED };
/* Reads all[2], ... : the arguments behind the command's name. READ_REFUSED: *code is the exit code, and the message is
 * on stderr. Whichever it is, options_free ends it. */
enum reading options_read(struct arguments *arguments, const struct command *command, int count, char **all,
                          enum exit_code *code);
void options_free(struct arguments *arguments);

#endif
