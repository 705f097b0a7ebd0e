/* The observed order of a table of h and err: err ~ C h^p as h -> 0, and a verdict on an order that is expected. */
#ifndef SCALLOP_ORDER_H
#define SCALLOP_ORDER_H

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

enum scallop_order_use {
  SCALLOP_ORDER_USED,
  SCALLOP_ORDER_ZERO,
  SCALLOP_ORDER_FLOOR,
  SCALLOP_ORDER_COARSE,
  SCALLOP_ORDER_BEFORE_SIGN_CHANGE
};
const char *scallop_order_use_text(enum scallop_order_use use);

struct scallop_order_point {
  double h;                   /* > 0                                                                    */
  double err;                 /* signed                                                                 */
  double noise;               /* rounding error of err if it is known, else 0                           */
  long row;                   /* what a reason calls the point: a row of a table; 0: its place, from 1   */
  double pairwise;            /* out: order between this point and the next finer one; nan for the last */
  enum scallop_order_use use; /* out                                                                    */
};

#ifdef __cplusplus
}
#endif

#endif
