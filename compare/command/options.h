/* The arguments of the command line. A command's options are a struct of its own that begins with struct request
 * (answers/request.h), and a row for each: its name, what it takes, what --help says of it, what holds where it is not
 * given, how it is read, and which field it sets. A new option is a field and a row. One that leaves is a row of
 * removed[] in options.c for a version: {"NAME" or "NAME VALUE", its command or NULL for all, what to use instead}. An
 * option or a value that a command still has is found before that row. */
#ifndef SCALLOP_COMPARE_COMMAND_OPTIONS_H
#define SCALLOP_COMPARE_COMMAND_OPTIONS_H

#include <float.h>
#include <stdbool.h>
#include <stddef.h>

#include "compare/answers/rows.h"
#include "compare/text/values.h"

/* The text of what a macro stands for, so that --help tells the numbers that are used */
#define TEXT_OF(...) TEXT_OF_WRITTEN(__VA_ARGS__)
#define TEXT_OF_WRITTEN(...) #__VA_ARGS__

/* --digits: of doubles, and where they are proven. */
enum { DOUBLE_DIGITS = 17, MOST_DIGITS = 10000, OPTION_VALUE = 48 };

struct option;

/* How options of one kind are read. */
struct option_kind {
  /* Called for each of the values, with the text of it. Returns NULL, or what is wrong; the message lives until the
   * next call. */
  const char *(*read)(void *options, const struct option *option, const char *text);
  /* The value that the options hold, "" where there is none; NULL: one of this kind has none unless it is given. */
  void (*show)(const void *options, const struct option *option, char text[OPTION_VALUE]);
};
extern const struct option_kind
    parameter_option,             /* of the point, or what varies, by its name                              */
    product_option,               /* begins another product of what varies                                  */
    flag_option,                  /* bool                                                                   */
    number_option,                /* struct given_number, from least to most                                */
    count_option,                 /* struct given_count, likewise                                           */
    word_option,                  /* struct given_word, one of words                                        */
    text_option,                  /* const char *, one for each value, not empty: allowed says what it is   */
    format_option, output_option, /* of the style                                                           */
    digits_option,                /* likewise, from 1 to most                                               */
    plot_option,                  /* likewise, of its plot, by its name                                     */
    columns_option;               /* likewise: which columns                                                */

struct option {
  const char *name;     /* without the dashes                                                                       */
  const char *argument; /* one word for each value it takes, separated by blanks; NULL: a flag                      */
  const char *help;
  const char *otherwise; /* what holds where it is not given, in which %s stands for the value; NULL: that value     */
  const struct option_kind *kind;
  size_t field; /* in the struct of the command                                                             */
  double least, most;
  const char *const *words; /* NULL-terminated */
  const char *allowed;
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
#define OPTION(...) \
  { \
    __VA_ARGS__ \
  }
#define OPTION_FIELD(type, member) .field = offsetof(struct type, member)
#define OPTION_POINT(name, argument, help, otherwise) OPTION(name, argument, help, otherwise, .kind = &parameter_option)
#define OPTION_NUMBER_OF(name, argument, also_called, help, otherwise) \
  OPTION(name, argument, help, otherwise, .kind = &parameter_option, .also = also_called)
#define OPTIONS_TO_L(numbers) \
  OPTION_NUMBER_OF("m1", "M", "mass1", "mass of body 1", numbers), \
      OPTION_NUMBER_OF("m2", "M", "mass2", "mass of body 2", numbers), \
      OPTION_NUMBER_OF("F1", "F", "friction1", "Coulomb friction force of body 1", numbers), \
      OPTION_NUMBER_OF("F2", "F", "friction2", "Coulomb friction force of body 2", numbers), \
      OPTION_NUMBER_OF("L", "L", "stroke", "amplitude of the separation x2 - x1", numbers)
#define OPTION_T(otherwise) OPTION_NUMBER_OF("T", "T", "period", "period", otherwise)
#define OPTIONS_ALPHA_GAIT(numbers, gait) \
  OPTION_POINT("alpha", "A", "fraction of the period that the extension takes", numbers), \
      OPTION_POINT("gait", "GAIT", "one of the gaits above", gait)
#define OPTIONS_CRAWLER(numbers, gait) OPTIONS_TO_L(numbers), OPTION_T(numbers), OPTIONS_ALPHA_GAIT(numbers, gait)
#define OPTION_PHASE(otherwise) OPTION_POINT("phase", "PHASE", "extension or contraction", otherwise)
#define OPTION_V0(otherwise) OPTION_POINT("v0", "V", "velocity of both bodies at the start of the phase", otherwise)
#define OPTION_FLAG(name, help, type, member) \
  OPTION(name, NULL, help, NULL, .kind = &flag_option, OPTION_FIELD(type, member))
#define OPTION_TEXT(name, argument, help, otherwise, type, member, text) \
  OPTION(name, argument, help, otherwise, .kind = &text_option, OPTION_FIELD(type, member), .allowed = text)
#define OPTION_WORD(name, argument, help, otherwise, type, member, list) \
  OPTION(name, argument, help, otherwise, .kind = &word_option, OPTION_FIELD(type, member), .words = list)
#define OPTION_COUNT(name, argument, help, otherwise, type, member, low, high) \
  OPTION(name, argument, help, otherwise, .kind = &count_option, OPTION_FIELD(type, member), .least = low, .most = high)
#define OPTION_NUMBER(name, argument, help, otherwise, type, member, ...) \
  OPTION(name, argument, help, otherwise, .kind = &number_option, OPTION_FIELD(type, member), __VA_ARGS__)
#define FROM_TO(low, high, text) .least = low, .most = high, .allowed = text
#define FINITE FROM_TO(-DBL_MAX, DBL_MAX, "a finite number")
#define POSITIVE FROM_TO(DBL_TRUE_MIN, DBL_MAX, "a finite number > 0")
#define OPTIONS_VARY \
  OPTION_POINT("F1_over_F2", "X", "F1 = X F2", NULL), OPTION_POINT("m1_over_m2", "X", "m1 = X m2", NULL), \
      OPTION_POINT("froude", "X", "the Froude number, which sets T when all else is set", NULL), \
      OPTION_POINT("label", "NAME=TEXT,...", "a column of texts, each for a block of rows", NULL), \
      OPTION("and", NULL, "what varies from here on follows as rows of their own", NULL, .kind = &product_option)
#define OPTIONS_ERRORS(otherwise) \
  OPTION_NUMBER("accuracy", "D", \
                "errors of series below this part of the exact value are 0; below 1e-10 they are " \
                "errors against certified values", \
                otherwise, request, accuracy, FROM_TO(1e-300, 0.999, "a number between 1e-300 and 1")), \
      OPTION_WORD("reference", "WHICH", "what errors of series are against: exact (in doubles) or certified", \
                  "by the accuracy", request, reference, reference_words)
extern const char *const reference_words[];
#define OPTION_POINTS \
  OPTION_TEXT( \
      "points", "FILE", \
      "points from a TSV file ('-': standard input) whose header names parameters; other columns are carried along", \
      NULL, request, points, "a file name")
#define OPTION_BOOK(help) OPTION_TEXT("book", "FILE", help, NULL, request, book, "a file name")
#define OPTION_FORMAT(otherwise) \
  OPTION("format", "F", "tsv, json (one object a line), csv, markdown or table (aligned, of 6 digits)", otherwise, \
         .kind = &format_option)
#define OPTION_DIGITS(range, otherwise, high) \
  OPTION("digits", "N", "significant digits " range, otherwise, .kind = &digits_option, .most = high, .allowed = range)
#define READ_BACK "as many as read back exactly"
#define DIGITS_OF_DOUBLES "from 1 to 17"
#define DIGITS_PROVEN(where) DIGITS_OF_DOUBLES "; " where " to 10000"
#define OPTION_OUTPUT(otherwise) \
  OPTION("output", "FILE", "write there when all is done ('-': to standard output, as without it); also -o", \
         otherwise, .kind = &output_option)
#define OPTION_PLOT(name, argument, help, otherwise) OPTION(name, argument, help, otherwise, .kind = &plot_option)
#define OPTIONS_PLOT \
  OPTION_PLOT("plot", "FILE", "draw the table: FILE ends in .svg, .png or .pdf (needs gnuplot)", NULL), \
      OPTION_PLOT("plot-x", "NAME", "the column along x", "what varies"), \
      OPTION_PLOT("plot-y", "NAME,...", "the columns that are drawn; of a map: what its colours show", \
                  "those of the table's kind"), \
      OPTION_PLOT("plot-by", "NAME,...", "a curve for each combination of values in these columns", \
                  "what else varies"), \
      OPTION_PLOT("plot-x-range", "FROM:TO", "the ends of the x axis, with :log or :linear", "those of the table"), \
      OPTION_PLOT("plot-y-range", "FROM:TO", "the ends of the y axis, with :log or :linear", "those of the table"), \
      OPTION_PLOT("plot-title", "TEXT", "the title of the picture", "the parameters that hold"), \
      OPTION_PLOT("plot-size", "WxH", "width and height in pixels, from 200 to 10000", \
                  "800x500, more where there is more to show")
#define OPTION_STATS OPTION_FLAG("stats", "afterwards, on standard error, what was computed, as counts", request, stats)
#define OPTION_QUIET OPTION_FLAG("quiet", "no notes on standard error, only errors", request, style.quiet)
/* The last rows: NO_MORE_OPTIONS ends each table, and those of a table of doubles end with OPTIONS_OF_DOUBLES. */
#define NO_MORE_OPTIONS OPTION(.name = NULL)
#define OPTION_COLUMNS \
  OPTION("columns", "LIST", "only these columns, in this order, and new ones: a,b,\"c = F1/F2\"", "all", \
         .kind = &columns_option)
#define OPTIONS_LAST OPTION_COLUMNS, OPTION_OUTPUT(NULL), OPTION_QUIET, NO_MORE_OPTIONS
#define OPTIONS_OF_DOUBLES \
  OPTION_FORMAT("tsv"), OPTION_DIGITS(DIGITS_OF_DOUBLES, READ_BACK, DOUBLE_DIGITS), OPTIONS_LAST

/* Are there as many digits as the numbers have, of doubles unless they are proven? False: the message is on stderr.
 * range: DIGITS_PROVEN. */
bool digits_hold(const struct style *style, bool proven, const char *range);

struct arguments;

/* One command: `scallop NAME`. What its columns mean is docs/help/NAME.txt, for --help. */
struct command {
  const char *name;
  const char *summary;             /* one line                                                                  */
  const char *example;             /* what `--help` shows first                                                 */
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
  const struct command *const *commands; /* all of them */
  char **all;                            /* of the program, NULL-terminated */
  int count, place;                      /* how many those are, and the one that is being read */
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
/* Makes the table that the options ask for. */
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
/* Does the command take more than one operand? */
bool takes_operands(const struct command *command);

/* What holds where no option is given. */
void options_initial(struct arguments *arguments, const struct command *command);

enum reading { READ_RUN, READ_HELP, READ_REFUSED };
/* Reads all[2], ... : the arguments behind the command's name. commands: all of them, to tell options of others from
 * those of none. READ_REFUSED: *code is the exit code, and the message is on stderr. Whichever it is, options_free ends
 * it. */
enum reading options_read(struct arguments *arguments, const struct command *command,
                          const struct command *const *commands, int count, char **all, enum exit_code *code);
/* Reads the book that the options name, if they do: the exit code, the message being on stderr. */
enum exit_code options_book(const struct arguments *arguments);
/* The exit code of a command that ended with code: EXIT_USAGE where --columns named what its table has not. */
enum exit_code options_judge(const struct arguments *arguments, enum exit_code code);
void options_free(struct arguments *arguments);

#endif
