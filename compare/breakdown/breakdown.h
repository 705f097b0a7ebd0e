/* Where the expansion breaks down: how far a series in T can be trusted, and what ends it. Needs FLINT. */
#ifndef SCALLOP_COMPARE_BREAKDOWN_BREAKDOWN_H
#define SCALLOP_COMPARE_BREAKDOWN_BREAKDOWN_H

#include "compare/answers/request.h"
#include "compare/answers/quantities.h"
#include "compare/text/values.h"

enum breakdown_source { FROM_USER, FROM_PUBLISHED, FROM_DERIVED, FROM_LIMIT };

struct breakdown_options {
  struct request request;
  struct optional_word source, only, quantity;
  struct optional_count order;   /* of the derived terms: below T^order */
  const char *map[2], *range[2]; /* what varies along x and y; FROM:TO:COUNT, or NULL */
  struct optional_number tolerance;
  bool all; /* the table, without more                                 */
  bool boundaries;
};

/* Is it the source that was asked for, if any was? */
bool breakdown_takes(const struct breakdown_options *options, enum breakdown_source source);
/* The table of one crawler */
enum exit_code breakdown_table(const struct breakdown_options *options);

#endif
