/* Accuracy tests of `scallop stress`: cases of many families (families.c) are solved in double and compared with
 * certified values (judge.c). Needs FLINT.
 *
 * Unit of errors: each parameter is a double, hence known to an ulp at best. For a result y and its parameters x_i
 *
 *     unit = max(ulp(y), sum over i of the larger |y(x_i one ulp up or down) - y|),   condition number = unit/ulp(y)
 *
 * with y certified (a closed form for a trajectory), and the changes from binary128 arithmetic: differences, not
 * derivatives, to count kinks and square roots at the boundaries of modes in full. y = 0 has a unit, but no ulp. The
 * bound is an error of 8 units; docs/background/stability.md lists the exceptions. */
#ifndef SCALLOP_COMPARE_STRESS_STRESS_H
#define SCALLOP_COMPARE_STRESS_STRESS_H

#include "compare/answers/answer.h"
#include "compare/answers/request.h"

struct stress_options {
  struct request request;
  const char *family;                /* the only one, or NULL */
  struct optional_count cases, seed; /* cases: of each family, 0: the default; seed: of their parameters */
  bool check, full, stiff, quick;
};
/* Write the table of families, the table of one point, and the table of smoothed friction (stiff.h). */
enum exit_code stress_table(const struct stress_options *options);
enum exit_code stress_point(const struct stress_options *options);
enum exit_code stress_stiff(const struct stress_options *options);

/* nan: unknown; a trajectory has error and unit alone */
struct stress_number {
  /* false: the motion has no such quantity (t1 of a phase without a change of mode), it may jump here, or the case has
   * no answer to judge */
  bool judged;
  double exact, got;       /* exact: rounded to double; got: computed in double */
  double error, unit, ulp; /* ulp: nan if exact is 0 or tiny */
  double estimate;         /* of the error, from the solver */
  double rounding;         /* largest minus smallest result of the four rounding modes */
  double perturbed;        /* largest change if one parameter is an ulp off */
  double resolved;         /* least error that 113 bits resolve; an estimate is compared with this, if larger */
  double wide_error[3];    /* of double, long double and binary128 */
  const char *broken;      /* name of a bound that is exceeded, or NULL */
};
enum stress_outcome {
  STRESS_SOLVED,
  STRESS_REFUSED,   /* by the double solver: out of its range; or the steady states fill an interval */
  STRESS_UNDECIDED, /* by the certified solver: binary128 replaces it */
  STRESS_BROKEN     /* a bound does not hold for the whole case */
};
struct stress_case {
  struct motion motion;
  long periods; /* of a trajectory, from the start velocity of the motion; else 0 */
  /* results of stress_judge: */
  enum stress_outcome outcome;
  const char *why;  /* of another outcome than solved */
  bool other_modes; /* the modes differ from binary128's; quantities that jump there are not judged */
  struct stress_number number[QUANTITIES]; /* of a trajectory Q_DXC is x, Q_V_END is v, at its end */
};
void stress_judge(struct stress_case *stressed);
/* Returns the name of a bound that a judged number exceeds, or NULL. */
const char *stress_broken(const struct stress_number *number);
const char *stress_quantity_name(const struct stress_case *stressed, int quantity);

/* Writes the options of a case: "--m1 1 --m2 ... --gait quadratic", then for a phase "--phase extension --v0 0", for a
 * trajectory "--start 3.1 --periods 1000". text has STRESS_ARGUMENTS bytes. */
enum { STRESS_ARGUMENTS = 400 + GAIT_TEXT };
void stress_arguments(const struct stress_case *stressed, char *text);

/* Bounds in units. In a directed rounding each operation errs by up to an ulp instead of a half, so a result by twice
 * as much, and the spread is between two results; a change of one parameter moves the result by a unit, and both
 * results err. An estimate may be up to STRESS_MAX_ESTIMATE times the largest of the error, the 128th part of an ulp,
 * and 2^-111 of the parts of a sum (wide.h). */
enum {
  STRESS_BOUND = 8,
  STRESS_ROUNDING = 4 * STRESS_BOUND,
  STRESS_PERTURBED = 1 + 2 * STRESS_BOUND,
  STRESS_MAX_ESTIMATE = 100
};

enum stress_kind { STRESS_STEADY, STRESS_PHASE, STRESS_TRAJECTORY };
/* Family of cases: changes to ordinary cases, made from x[0] to x[6]; all x are quasi-random in [0, 1) */
struct stress_family {
  const char *name, *about;
  enum stress_kind kind;
  double sizes;                   /* m, F and L are from 10^-sizes to 10^sizes; 0: ordinary */
  double eps[2], T[2];            /* decades of T^2 (F1 + F2)/(M L), or of T; 0, 0: ordinary */
  int masses, forces;             /* index of the x that changes their ratio by up to 12 decades either way, or 0 */
  int equal_forces, equal_phases; /* index of the x that brings their difference near 0, or 0 */
  double scale;                   /* units of m, F and L: each times 10^-scale to 10^scale */
  int change;                     /* further change of alpha or T, a constant of families.c */
  int start;                      /* of a phase or a trajectory, a constant of families.c */
  int boundary;                   /* kind of a boundary nearby */
  const char *regime;             /* of the steady state; NULL: any */
  const char *gait;               /* the only gait, unless the user gives one; NULL: all gaits */
};
extern const struct stress_family stress_families[]; /* the last has no name */
/* Makes `count` cases of a family from a seed. Returns their count, smaller if hundreds of tries give no case. */
int stress_make(const struct stress_family *family, const struct scallop_gait *gait, unsigned long seed, int count,
                struct stress_case *cases);

#endif
