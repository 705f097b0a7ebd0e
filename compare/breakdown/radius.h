/* The radius of convergence of a series. */
#ifndef SCALLOP_COMPARE_BREAKDOWN_RADIUS_H
#define SCALLOP_COMPARE_BREAKDOWN_RADIUS_H

#include "asymptotics/derived/singularity.h"
#include "compare/breakdown/series.h"

struct radius {
  const char *method;  /* poles, singularity, or bound: T is proven to be no more than the radius          */
  double T, low, high; /* |T| of the nearest singularity; the radius is proven to be within [low, high]      */
  const char *status;
  char note[800];
};
/* From the coefficients below T^order, where the series is that of a rational function. False: it is not. */
bool radius_from_poles(struct radius *r, const struct series *series, slong order);
/* Of the branch that the series expand, or of its first crossing alone, which t1 depends on. False: there is none. */
bool singularity_of(struct scallop_singularity *s, const struct expansions *e, bool first_crossing);
void radius_from_singularity(struct radius *r, const struct scallop_singularity *s, enum quantity_id quantity);

#endif
