/* `scallop series`: its options, and what it prints of derived series, which needs FLINT. */
#ifndef SCALLOP_COMPARE_COMMAND_SERIES_OPTIONS_H
#define SCALLOP_COMPARE_COMMAND_SERIES_OPTIONS_H

#include <string.h>

#include "compare/answers/points.h"
#include "compare/text/values.h"

struct series_options {
  struct request request;
  struct given_word source; /* published, derived, limit or closed */
  struct given_count order; /* of the derived series: terms below T^order */
  bool bound, symbolic;
  const char *only;       /* of the published formulas: their names and equations, or NULL: all */
  struct given_word emit; /* text: a table */
};
/* Is this the source? With --bound and --symbolic it is derived where none is given. */
static inline bool is_from(const struct series_options *o, const char *source)
{
  bool derived = !o->source.given && (o->bound || o->symbolic);
  return strcmp(derived ? "derived" : o->source.value, source) == 0;
}

/* --source derived|limit, and --bound */
enum exit_code series_derived(const struct series_options *options);
/* --symbolic */
enum exit_code series_symbolic(const struct series_options *options);

#endif
