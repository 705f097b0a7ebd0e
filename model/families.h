/* The families of gaits: all that commands, --help, documents and Python know of them. libm only; nothing is allocated.
 *
 * A new family is a function that makes its gaits, its struct scallop_gait_family beside that, and a row of
 * SCALLOP_GAIT_FAMILIES.
 */
#ifndef SCALLOP_MODEL_FAMILIES_H
#define SCALLOP_MODEL_FAMILIES_H

#include <stddef.h>

#include "model/gaits.h"

#ifdef __cplusplus
extern "C" {
#endif

/* In the order in which they are listed, those with a fixed gait first: ROW(family, law) for scallop_family_FAMILY.
 * law: what makes fractions of its numbers, in model/exact/exact_gaits.c; NULL: its doubles stand for it. */
#define SCALLOP_GAIT_FAMILIES(ROW) \
  ROW(quadratic, NULL) \
  ROW(sinusoidal, NULL) \
  ROW(trapezoidal, exact_trapezoidal) \
  ROW(skewed, exact_one_ramp) \
  ROW(constant, exact_one_ramp) \
  ROW(minimum_jerk, exact_polynomial) \
  ROW(polynomial, exact_polynomial)

union scallop_made_gait { /* memory for a gait of any family that is made of numbers */
  struct scallop_gait gait;
  struct scallop_straight straight;
  struct scallop_polynomial polynomial;
};
extern const size_t scallop_made_gait_size; /* of the union, for callers in other languages */

enum { SCALLOP_GAIT_NUMBERS = SCALLOP_POLYNOMIAL_DEGREE }; /* the most that a gait is made of */

struct scallop_gait_family {
  const char *name;     /* "trapezoidal"; with ':' and the numbers after it the name of a gait           */
  const char *numbers;  /* what they are called: "UP,DOWN"; NULL: none are given                         */
  const char *usual;    /* the numbers where none are given: "0.25,0.25"; NULL: some must be, or none are */
  const char *allowed;  /* the numbers and their domain, in words; NULL: none are given                   */
  const char *sentence; /* what the gait is                                                              */
  const char *sample;   /* one of them in full, for checks; its numbers not the usual ones, where it has any  */
  int each;             /* numbers of a phase, which hold for both, or twice as many; 0: any number, of both   */
  const struct scallop_gait *fixed; /* the only gait of a family without numbers, else NULL                    */
  /* x: of both phases, the extension first. SCALLOP_EDOMAIN: not as allowed, or as *why says, if that is set. NULL:
   * fixed, or not of numbers */
  enum scallop_status (*make)(union scallop_made_gait *made, const char *name, const double *x, int count,
                              const char **why);
};

#define SCALLOP_DECLARE_FAMILY(family, law) extern const struct scallop_gait_family scallop_family_##family;
SCALLOP_GAIT_FAMILIES(SCALLOP_DECLARE_FAMILY)
#undef SCALLOP_DECLARE_FAMILY

/* i = 0, 1, ...; NULL after the last */
const struct scallop_gait_family *scallop_gait_family(int i);

/* A gait of the family with these numbers: family->each of them, which then hold for the contraction too, or twice as
 * many. name: as in gaits.h. SCALLOP_EDOMAIN: too many or too few, not as allowed, or the family is fixed; *why then
 * says more, or is NULL. */
enum scallop_status scallop_make_gait(union scallop_made_gait *made, const struct scallop_gait_family *family,
                                      const char *name, const double *x, int count, const char **why);

#ifdef __cplusplus
}
#endif

#endif
