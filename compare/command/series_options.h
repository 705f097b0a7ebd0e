/* `scallop series`: its options; rows of points, and what needs FLINT. */
#ifndef SCALLOP_COMPARE_COMMAND_SERIES_OPTIONS_H
#define SCALLOP_COMPARE_COMMAND_SERIES_OPTIONS_H

#include <string.h>

#include "compare/answers/rows.h"
#include "compare/text/values.h"

struct series_options {
  struct request request;
  struct optional_word source; /* published, derived, limit or closed */
  struct optional_count order; /* of the derived series: terms below T^order */
  bool bound, symbolic;
  const char *only;                         /* these series only: names, and equations of formulas, or NULL: all */
  const char *parts;                        /* of each in a row: value, exact, error, relative; or NULL */
  bool rows, orders;                        /* a row for each point, of one point too; the orders of the errors in T */
  struct optional_number expect, tolerance; /* of the orders */
  struct optional_word emit;                /* text: a table */
};
/* Is this the source? With --bound and --symbolic it is derived where none is given. */
static inline bool is_from(const struct series_options *o, const char *source)
{
  bool derived = !o->source.given && (o->bound || o->symbolic);
  return strcmp(derived ? "derived" : o->source.value, source) == 0;
}
/* series_rows.c. A row for each point, or for each series the order along T, and not the table of one point? */
bool series_are_rows(const struct series_options *options);
/* These rows, or the published formulas at one point. NULL, or what is wrong. */
const char *series_plan(const void *options, struct rows *rows);

/* series_flint.c: --source derived|limit, --symbolic and --bound */
enum exit_code series_report(const struct series_options *options);
/* series_bound_flint.c: --bound, of the crawler as it was written */
struct scallop_rational_crawler;
enum exit_code series_bound(const struct series_options *options, const struct scallop_rational_crawler *crawler);

#endif
