/* The families of gaits, described once for commands, --help, documents and Python. libm only; nothing is allocated.
 *
 * A new family is a function that makes its gaits, its struct scallop_gait_family in the same file, and a row of
 * SCALLOP_GAIT_FAMILIES. */
#ifndef SCALLOP_MODEL_FAMILIES_H
#define SCALLOP_MODEL_FAMILIES_H

#include <stddef.h>

#include "model/gaits.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Rows in the order of lists, families with a fixed gait first: ROW(family, law) for scallop_family_FAMILY. law: the
 * function of model/exact/exact_gaits.c that makes fractions of the gait's numbers; NULL: the doubles of the gait
 * are exact. */
#define SCALLOP_GAIT_FAMILIES(ROW) \
  ROW(quadratic, NULL) \
  ROW(sinusoidal, NULL) \
  ROW(trapezoidal, exact_trapezoidal) \
  ROW(skewed, exact_one_ramp) \
  ROW(constant, exact_one_ramp) \
  ROW(minimum_jerk, exact_polynomial) \
  ROW(polynomial, exact_polynomial)

/* Memory for a gait of any family with numbers */
union scallop_made_gait {
  struct scallop_gait gait;
  struct scallop_straight straight;
  struct scallop_polynomial polynomial;
};
extern const size_t scallop_made_gait_size; /* size of the union, for callers in other languages */

enum { SCALLOP_GAIT_NUMBERS = SCALLOP_POLYNOMIAL_DEGREE }; /* maximal count of the numbers of a gait */

struct scallop_gait_family {
  const char *name;     /* "trapezoidal"; a gait is named by it, or by it, ':' and the numbers */
  const char *numbers;  /* names of the numbers: "UP,DOWN"; NULL: the gait has no numbers */
  const char *usual;    /* default numbers: "0.25,0.25"; NULL: no default, or no numbers */
  const char *allowed;  /* the numbers and their domain, in words; NULL: the gait has no numbers */
  const char *sentence; /* description of the gait */
  const char *sample;   /* name of one gait for checks, with numbers other than the default */
  int each; /* count of numbers for one phase; twice as many set both phases; 0: any count, for both phases */
  const struct scallop_gait *fixed; /* the only gait of a family without numbers, else NULL */
  /* Makes a gait of the numbers x, extension first, both phases given. SCALLOP_EDOMAIN: x is not in the domain;
   * *why, if set, is the reason. NULL: the family is fixed. */
  enum scallop_status (*make)(union scallop_made_gait *made, const char *name, const double *x, int count,
                              const char **why);
};

#define SCALLOP_DECLARE_FAMILY(family, law) extern const struct scallop_gait_family scallop_family_##family;
SCALLOP_GAIT_FAMILIES(SCALLOP_DECLARE_FAMILY)
#undef SCALLOP_DECLARE_FAMILY

/* Returns family i = 0, 1, ...; NULL after the last. */
const struct scallop_gait_family *scallop_gait_family(int i);

/* Makes the gait of the family with these numbers: family->each of them for both phases, or twice as many. name: kept,
 * as in gaits.h. SCALLOP_EDOMAIN: wrong count, numbers outside the domain, or a fixed family; *why is then the reason
 * or NULL. */
enum scallop_status scallop_make_gait(union scallop_made_gait *made, const struct scallop_gait_family *family,
                                      const char *name, const double *x, int count, const char **why);

#ifdef __cplusplus
}
#endif

#endif
