/* Breakdown of the expansion: the T at which a series ceases to be accurate, and transitions. Needs FLINT. */
#ifndef SCALLOP_COMPARE_BREAKDOWN_BREAKDOWN_H
#define SCALLOP_COMPARE_BREAKDOWN_BREAKDOWN_H

#include "compare/answers/request.h"
#include "compare/answers/quantities.h"
#include "compare/text/values.h"

enum breakdown_source { FROM_USER, FROM_PUBLISHED, FROM_DERIVED, FROM_LIMIT };

struct breakdown_options {
  struct request request;
  struct optional_word source, only, quantity;
  struct optional_count order;   /* derived terms are those below T^order */
  const char *map[2], *range[2]; /* variables along x and y; FROM:TO:COUNT, or NULL */
  struct optional_number tolerance;
  bool all; /* the table in place of the page */
  bool boundaries;
};

/* Returns true if no source is requested, or this one. */
bool breakdown_takes(const struct breakdown_options *options, enum breakdown_source source);
/* Writes the table of one crawler. */
enum exit_code breakdown_table(const struct breakdown_options *options);

#endif
