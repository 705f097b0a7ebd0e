/* Where the expansion breaks down: how far a series in T can be trusted, what ends it, and maps of both. Needs FLINT. */
#ifndef SCALLOP_BREAKDOWN_H
#define SCALLOP_BREAKDOWN_H

#include "compare/answers/points.h"
#include "compare/text/values.h"
#include "compare/answers/quantities.h"
#include "compare/text/message.h"
#include "model/model.h"

/* Of the steady state, and of one phase from a start velocity that does not depend on T. */
enum breakdown_source { FROM_PUBLISHED, FROM_DERIVED, FROM_LIMIT, BREAKDOWN_SOURCES };

struct breakdown_series {
  enum breakdown_source source;
  long order; /* derived: terms below T^order; of no meaning for the others                   */
  enum quantity_id quantity;
};

/* One series of the steady state of a crawler, for one value of T or for a search: thread-safe. T of the crawler is the period.
 * The relative error series/exact - 1; nan where there is no such series, or no exact value; 0 where both are 0. */
double breakdown_error(const struct scallop_crawler *crawler, const struct breakdown_series *series);
/* The largest T up to which the absolute value of that stays below tolerance: 0 if it does not as T -> 0, INFINITY if for every T up to
 * permanent rest, nan where there is no such series. T of the crawler is not used. */
double breakdown_reach(const struct scallop_crawler *crawler, const struct breakdown_series *series, double tolerance);

/* The table of one crawler */
struct breakdown_options {
  struct request request;
  struct given_word source;
  struct given_count order;
  const char *quantity, *only;   /* the only one, or NULL */
  const char *map[2], *range[2]; /* what varies along x and y; FROM:TO:COUNT, or NULL */
  struct given_number tolerance;
  bool boundaries;
};
enum exit_code breakdown_table(const struct breakdown_options *options);

#endif
