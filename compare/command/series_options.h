/* Options of `scallop series`, and its tables: rows of points, and tables that need FLINT. */
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
  const char *only;                         /* names of series, and equations of formulas; NULL: all */
  const char *parts;                        /* of each series in a row: value, exact, error, relative; or NULL */
  bool rows, orders;                        /* rows for points, for one point too; orders of the errors in T */
  struct optional_number expect, tolerance; /* of the orders */
  struct optional_word emit;                /* text: a table */
};
/* Returns true if this is the source; the default with --bound and --symbolic is derived. */
static inline bool is_from(const struct series_options *o, const char *source)
{
  bool derived = !o->source.given && (o->bound || o->symbolic);
  return strcmp(derived ? "derived" : o->source.value, source) == 0;
}
/* series_rows.c. Returns true for a row for each point, or an order along T for each series; false for one point. */
bool series_are_rows(const struct series_options *options);
/* Plans these rows, or the published formulas at one point. Returns NULL, or an error. */
const char *series_plan(const void *options, struct rows *rows);

/* series_flint.c. Writes --source derived|limit, --symbolic and --bound. */
enum exit_code series_report(const struct series_options *options);
/* series_bound_flint.c. Writes --bound. crawler: in decimals as typed */
struct scallop_rational_crawler;
enum exit_code series_bound(const struct series_options *options, const struct scallop_rational_crawler *crawler);

#endif
