/* The families of gaits with polynomial coefficients, made by gait_polynomial.c. */
#include <string.h>

#include "model/families.h"

static enum scallop_status make(union scallop_made_gait *made, const char *name, const double *x, int count,
                                const char **why)
{
  double c[SCALLOP_GAIT_NUMBERS + 1] = { 0 }; /* c[0] of s^0 */
  memcpy(c + 1, x, (size_t)count * sizeof *x);
  return scallop_make_polynomial(&made->polynomial, name, c, count, why);
}

const struct scallop_gait_family scallop_family_polynomial = {
  .name = "polynomial",
  .numbers = "C1,C2,...",
  .allowed = "polynomial:C1,C2,... of degree 3 to 16 with l' = 0 at both ends and C1 + C2 + ... > 0",
  .sentence = "l/L = (C1 s + C2 s^2 + ...)/(C1 + C2 + ...), up to s^16, s the part of the extension that has passed; "
              "l' = 0 at both "
              "ends",
  .sample = "polynomial:0,0,0,35,-84,70,-20",
  .make = make
};

const struct scallop_gait_family scallop_family_minimum_jerk = { .name = "minimum-jerk",
                                                                 .usual = "0,0,10,-15,6",
                                                                 .sentence = "polynomial:0,0,10,-15,6",
                                                                 .sample = "minimum-jerk",
                                                                 .make = make };
