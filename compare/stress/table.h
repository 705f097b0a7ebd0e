/* `scallop stress`: how many digits survive. Cases of many families (families.h) are solved in double and judged by certified values
 * (judge.h). The work is spread over all cores by OpenMP, and the table does not depend on how many there are. Needs FLINT. */
#ifndef SCALLOP_STRESS_TABLE_H
#define SCALLOP_STRESS_TABLE_H

#include "compare/text/message.h"

struct options;
/* The table of families. */
enum exit_code stress_table(const struct options *options);
/* The table of one point. */
enum exit_code stress_point(const struct options *options);

#endif
