/* Table of `scallop workprec`: error against run time of every method for the steady state. Needs FLINT. */
#ifndef SCALLOP_COMPARE_WORKPREC_TABLE_H
#define SCALLOP_COMPARE_WORKPREC_TABLE_H

#include "compare/answers/request.h"
#include "compare/text/message.h"
#include "compare/text/values.h"

struct workprec_options {
  struct request request;
  bool quick;
  struct optional_number limit; /* seconds for each setting; 0: not given */
};
enum exit_code workprec_table(const struct workprec_options *options);

#endif
