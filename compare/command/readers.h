/* Rows of options, and readers of their values. A command has a struct of options, with struct request
 * (answers/request.h) as its first member, and a row for each option: its name, reader and field. One row reads an
 * argument of the command line and a member of a scene. docs/help/COMMAND.txt has the allowed values, purpose and
 * default. A new option is a field, a row and a line there. */
#ifndef SCALLOP_COMPARE_COMMAND_READERS_H
#define SCALLOP_COMPARE_COMMAND_READERS_H

#include <float.h>
#include <stddef.h>

#include "compare/answers/rows.h"
#include "compare/text/values.h"

/* DOUBLE_DIGITS, MAX_DIGITS: the most of --digits, for doubles and for proven numbers */
enum { DOUBLE_DIGITS = 17, MAX_DIGITS = 10000, OPTION_VALUE = 48, MAX_VALUES = 2 };

/* Reads one value of an option. Returns NULL, or an error, valid until the next call. */
struct option;
typedef const char *option_reader(void *options, const struct option *option, const char *text);
option_reader read_parameter, /* a parameter, or its range, by the option's name */
    read_product,             /* begins another product of a sweep */
    read_flag,                /* bool */
    read_real,                /* struct optional_number, from min to max */
    read_whole,               /* struct optional_count, from min to max */
    read_word,                /* struct optional_word, one of words */
    read_text,                /* const char *, one for each value, not empty; allowed describes it in messages */
    read_format, read_output, /* of the style */
    read_digits,              /* of the style, from 1 to max */
    read_plot,                /* of the plot in the style, by the option's name */
    read_choice,              /* columns, in the style */
    read_sample,              /* samples, their count and kind, in the request */
    read_shard;               /* part of the sweep, in the request */

struct option {
  const char *name; /* without the dashes; the last row has NULL */
  option_reader *read;
  size_t field; /* in the struct of the command */
  double min, max;
  const char *const *words; /* NULL-terminated */
  const char *allowed;
  int values; /* count, if more than one */
};
/* Returns the count of values. */
int option_values(const struct option *option);

/* Rule between options: one without effect is refused. */
struct option_rule {
  const char *names; /* separated by blanks, NAME, or NAME=VALUE for an option with this value: each is refused */
  enum { RULE_WITH, RULE_WITHOUT } when;
  const char *others;  /* separated by blanks: with, or without, any of these */
  const char *message; /* after "--NAME "; NULL: "has nothing to do with" the other, or without it */
};

/* Rows of several commands */
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
  OPTION(name, read_whole, OPTION_FIELD(type, member), .min = low, .max = high)
#define OPTION_NUMBER(name, type, member, ...) OPTION(name, read_real, OPTION_FIELD(type, member), __VA_ARGS__)
#define FROM_TO(low, high, what) .min = low, .max = high, .allowed = what
#define FINITE FROM_TO(-DBL_MAX, DBL_MAX, "a finite number")
#define POSITIVE FROM_TO(DBL_TRUE_MIN, DBL_MAX, "a finite number > 0")
#define OPTIONS_ERRORS \
  OPTION_NUMBER("accuracy", request, accuracy, FROM_TO(1e-300, 0.999, "a number between 1e-300 and 1")), \
      OPTION_WORD("reference", request, reference, reference_words)
extern const char *const reference_words[];
#define OPTION_POINTS OPTION_TEXT("points", request, points, "a file name")
#define OPTION_FORMULAS OPTION_TEXT("formulas", request, formulas, "a file name")
#define OPTION_FORMAT OPTION("format", read_format, )
#define OPTION_DIGITS(range, high) OPTION("digits", read_digits, .max = high, .allowed = range)
#define DIGITS_OF_DOUBLES "from 1 to 17"
#define DIGITS_PROVEN(where) DIGITS_OF_DOUBLES "; " where " to 10000"
#define OPTION_OUTPUT OPTION("output", read_output, )
#define OPTION_PLOT(name) OPTION(name, read_plot, )
#define OPTIONS_PLOT \
  OPTION_PLOT("plot"), OPTION_PLOT("plot-x"), OPTION_PLOT("plot-y"), OPTION_PLOT("plot-by"), \
      OPTION_PLOT("plot-x-range"), OPTION_PLOT("plot-y-range"), OPTION_PLOT("plot-title"), OPTION_PLOT("plot-size")
#define OPTION_STATS OPTION_FLAG("stats", request, stats)
#define OPTION_QUIET OPTION_FLAG("quiet", request, style.quiet)
/* Last rows: NO_MORE_OPTIONS ends each table of options, OPTIONS_OF_DOUBLES the options of a table of doubles. */
#define NO_MORE_OPTIONS OPTION(NULL, NULL, )
#define OPTIONS_LAST \
  OPTION("columns", read_choice, ), OPTION_OUTPUT, OPTION_COUNT("threads", request, threads, 1, MAX_THREADS), \
      OPTION_QUIET, NO_MORE_OPTIONS
#define OPTIONS_OF_DOUBLES OPTION_FORMAT, OPTION_DIGITS(DIGITS_OF_DOUBLES, DOUBLE_DIGITS), OPTIONS_LAST

#endif
