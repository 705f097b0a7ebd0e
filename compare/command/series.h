/* The options of `scallop series`. */
#ifndef SCALLOP_SERIES_OPTIONS_H
#define SCALLOP_SERIES_OPTIONS_H

#include "compare/answers/points.h"
#include "compare/text/values.h"

struct series_options {
  struct request request;
  struct given_word source; /* published, derived or limit */
  struct given_count order; /* of the derived series: terms below T^order */
  bool bound;
};

#endif
