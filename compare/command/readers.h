/* The rows of options, and how their values are read. A command's options are a struct of its own that begins with
 * struct request (answers/request.h), and a row for each: its name, how it is read, and which field it sets; an
 * argument of the command line and a member of a scene are read by the same row. What it takes, what it is for and what
 * holds where it is not given stands in docs/help/COMMAND.txt. A new option is a field, a row and a line there. */
#ifndef SCALLOP_COMPARE_COMMAND_READERS_H
#define SCALLOP_COMPARE_COMMAND_READERS_H

#include <float.h>
#include <stddef.h>

#include "compare/answers/rows.h"
#include "compare/text/values.h"

/* --digits: of doubles, and where they are proven. */
enum { DOUBLE_DIGITS = 17, MOST_DIGITS = 10000, OPTION_VALUE = 48, MOST_VALUES = 2 };

/* Called for each value of an option. Returns NULL, or what is wrong; the message lives until the next call. */
struct option;
typedef const char *option_reader(void *options, const struct option *option, const char *text);
option_reader read_parameter, /* of the point, or what varies, by its name                              */
    read_product,             /* begins another product of what varies                                  */
    read_flag,                /* bool                                                                   */
    read_real,                /* struct optional_number, from least to most                                */
    read_whole,               /* struct optional_count, likewise                                           */
    read_word,                /* struct optional_word, one of words                                        */
    read_text,                /* const char *, one for each value, not empty: allowed says what it is   */
    read_format, read_output, /* of the style                                                           */
    read_digits,              /* likewise, from 1 to most                                               */
    read_plot,                /* likewise, of its plot, by its name                                     */
    read_choice,              /* likewise: which columns                                                */
    read_sample,              /* of the request: how many samples, and of which kind                    */
    read_shard;               /* likewise: which part of the sweep                                      */

struct option {
  const char *name; /* without the dashes; NULL behind the last */
  option_reader *read;
  size_t field; /* in the struct of the command */
  double least, most;
  const char *const *words; /* NULL-terminated */
  const char *allowed;
  int values; /* how many it takes where it is more than one */
};
/* How many values it takes. */
int option_values(const struct option *option);

/* What two options have to do with each other: one that has no effect is refused. */
struct option_rule {
  const char *names; /* separated by blanks, NAME, or NAME=VALUE for an option with that value: none may be given */
  enum { RULE_WITH, RULE_WITHOUT } when;
  const char *others;  /* one of these, separated by blanks */
  const char *message; /* behind "--NAME "; NULL: that it has nothing to do with the other, or without it */
};

/* Rows that many commands have. */
#define OPTION(named, reader, ...) \
  { \
    .name = named, .read = reader, __VA_ARGS__ \
  }
#define OPTION_FIELD(type, member) .field = offsetof(struct type, member)
#define OPTION_POINT(name) OPTION(name, read_parameter, )
#define OPTIONS_TO_L OPTION_POINT("m1"), OPTION_POINT("m2"), OPTION_POINT("F1"), OPTION_POINT("F2"), OPTION_POINT("L")
#define OPTIONS_ALPHA_GAIT \
  OPTION_POINT("alpha"), OPTION_POINT("gait"), OPTION_NUMBER("smooth", request, smooth, POSITIVE)
#define OPTIONS_CRAWLER OPTIONS_TO_L, OPTION_POINT("T"), OPTIONS_ALPHA_GAIT
#define OPTIONS_PHASE OPTION_POINT("phase"), OPTION_POINT("v0")
#define OPTIONS_VARY \
  OPTION_POINT("mu1"), OPTION_POINT("mu2"), OPTION_POINT("g"), OPTION_POINT("F1_over_F2"), OPTION_POINT("m1_over_m2"), \
      OPTION_POINT("froude"), OPTION_POINT("label"), OPTION("and", read_product, ), OPTION("sample", read_sample, ), \
      OPTION("shard", read_shard, ), OPTION_FLAG("skip-complete", request, skip_complete)
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
#define OPTION_FORMULAS OPTION_TEXT("formulas", request, formulas, "a file name")
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
#define OPTIONS_LAST \
  OPTION("columns", read_choice, ), OPTION_OUTPUT, OPTION_COUNT("threads", request, threads, 1, MAX_THREADS), \
      OPTION_QUIET, NO_MORE_OPTIONS
#define OPTIONS_OF_DOUBLES OPTION_FORMAT, OPTION_DIGITS(DIGITS_OF_DOUBLES, DOUBLE_DIGITS), OPTIONS_LAST

#endif
