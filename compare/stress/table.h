/* `scallop stress`: how many digits survive. Cases of many families (families.h) are solved in double and judged by
 * certified values (judge.h). The work is spread over all cores by OpenMP, and the table does not depend on how many
 * there are. Needs FLINT. */
#ifndef SCALLOP_COMPARE_STRESS_TABLE_H
#define SCALLOP_COMPARE_STRESS_TABLE_H

#include "compare/answers/request.h"
#include "compare/text/message.h"
#include "compare/text/values.h"

struct stress_options {
  struct request request;
  const char *family;             /* the only one, or NULL */
  struct given_count cases, seed; /* of each family, 0: as many as is usual; of their parameters */
  bool check, full, stiff, quick, summary;
};
/* The table of families. */
enum exit_code stress_table(const struct stress_options *options);
/* The table of one point. */
enum exit_code stress_point(const struct stress_options *options);
/* --stiff: the table of stiff runs (stiff_measure.h), or with --summary a row for each series of them. */
enum exit_code stress_stiff(const struct stress_options *options);

#endif
