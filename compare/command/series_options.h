/* `scallop series`: its options, and what it prints of derived series, which needs FLINT. */
#ifndef SCALLOP_COMPARE_COMMAND_SERIES_OPTIONS_H
#define SCALLOP_COMPARE_COMMAND_SERIES_OPTIONS_H

#include <string.h>

#include "compare/answers/rows.h"
#include "compare/text/values.h"

struct series_options {
  struct request request;
  struct given_word source; /* published, derived, limit or closed */
  struct given_count order; /* of the derived series: terms below T^order */
  bool bound, symbolic;
  const char *only;                      /* these series: names, and equations of formulas, or NULL: all */
  const char *parts;                     /* of each in a row: value, exact, error, relative; or NULL */
  bool rows, orders;                     /* a row for each point, of one point too; the orders of the errors in T */
  struct given_number expect, tolerance; /* of the orders */
  struct given_word emit;                /* text: a table */
};
/* Is this the source? With --bound and --symbolic it is derived where none is given. */
static inline bool is_from(const struct series_options *o, const char *source)
{
  bool derived = !o->source.given && (o->bound || o->symbolic);
  return strcmp(derived ? "derived" : o->source.value, source) == 0;
}

/* A formula and the motion that it is about: a kind of phase, or the period. */
enum { PERIOD = SCALLOP_CONTRACTION + 1 };
struct series_use {
  const struct scallop_formula *formula;
  int of;
};
enum { MOST_SERIES = 96 };
/* series_rows.c. Each formula that is asked for, once for each motion that it is about. Returns how many. */
int series_uses(struct series_use uses[MOST_SERIES], const struct series_options *options);
/* Its name as a quantity */
const char *series_use_name(char name[QUANTITY_NAME], const struct series_use *use);
/* Rows of points: NULL, or what is wrong */
const char *series_plan(const void *options, struct rows *rows);

/* --source derived|limit, --symbolic and --bound */
enum exit_code series_report(const struct series_options *options);

#endif
