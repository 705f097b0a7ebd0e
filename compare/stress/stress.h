/* `scallop stress`: how many digits survive. Cases of many families (families.c) are solved in double and judged by
 * certified values (judge.c). Needs FLINT.
 *
 * The unit of judgement. Each parameter is a double and so known to an ulp at best. For a result y and its parameters
 * x_i
 *
 *     unit = max(ulp(y), sum over i of the larger |y(x_i one ulp up or down) - y|),   condition number = unit/ulp(y)
 *
 * with y certified, of a trajectory a closed form, and the changes from binary128 arithmetic: differences, not
 * derivatives, so that kinks and square roots at the boundaries of modes count for what they are. Where y is 0 there is
 * a unit all the same, but no ulp. The promise is an error of at most 8 units; docs/background/stability.md lists the
 * exceptions. */
#ifndef SCALLOP_COMPARE_STRESS_STRESS_H
#define SCALLOP_COMPARE_STRESS_STRESS_H

#include "compare/answers/answer.h"
#include "compare/answers/request.h"

struct stress_options {
  struct request request;
  const char *family;                /* the only one, or NULL */
  struct optional_count cases, seed; /* of each family, 0: as many as is usual; of their parameters */
  bool check, full, stiff, quick;
};
/* The table of families, and that of one point. */
enum exit_code stress_table(const struct stress_options *options);
enum exit_code stress_point(const struct stress_options *options);
/* --stiff: the table of stiff runs (stiff.h) */
enum exit_code stress_stiff(const struct stress_options *options);

/* nan: not known, of a trajectory all but error and unit */
struct stress_number {
  /* false: the motion has no such quantity (t1 of a phase without a change of mode), it may jump here, or the case has
   * no answer to judge */
  bool judged;
  double exact, got;       /* exact: rounded to double; got: in double              */
  double error, unit, ulp; /* ulp: nan where exact is 0 or tiny */
  double estimate;         /* of the error, as a solve returns it                  */
  double rounding;         /* largest minus smallest result of the four rounding modes */
  double perturbed;        /* the largest change where one parameter is an ulp off  */
  double resolved;      /* by 113 bits: what an error counts as where it is compared with its estimate, if it is less */
  double wide_error[3]; /* of double, long double and binary128 */
  const char *broken;   /* the promise that is broken, or NULL */
};
enum stress_outcome {
  STRESS_SOLVED,
  STRESS_REFUSED,   /* by the double solver: out of its range; or the steady states fill an interval */
  STRESS_UNDECIDED, /* by the certified solver: binary128 replaces it   */
  STRESS_BROKEN     /* a promise is broken for the case as a whole      */
};
struct stress_case {
  struct motion motion;
  long periods; /* of a trajectory, from the start velocity of the motion; else 0 */
  /* what stress_judge finds */
  enum stress_outcome outcome;
  const char *why;                         /* of another outcome than solved                               */
  bool other_modes;                        /* than binary128 finds: quantities that jump there are not judged */
  struct stress_number number[QUANTITIES]; /* of a trajectory Q_DXC is x, Q_V_END is v, at its end */
};
void stress_judge(struct stress_case *stressed);
/* Which promise is broken by a number that is judged, or NULL */
const char *stress_broken(const struct stress_number *number);
const char *stress_quantity_name(const struct stress_case *stressed, int quantity);

/* The options of a case: "--m1 1 --m2 ... --gait quadratic", then for a phase "--phase extension --v0 0", for a
 * trajectory "--start 3.1 --periods 1000". text holds STRESS_ARGUMENTS bytes. */
enum { STRESS_ARGUMENTS = 400 + GAIT_TEXT };
void stress_arguments(const struct stress_case *stressed, char *text);

/* What is promised, in units. In a directed rounding each operation errs by up to an ulp instead of a half, so a result
 * by twice as much, and the spread is between two of them; a change of one parameter moves the result by a unit, and
 * both ends err. An estimate may be so many times the error, or the 128th part of an ulp, or 2^-111 of the parts of a
 * sum (wide.h), if that is more. */
enum {
  STRESS_PROMISE = 8,
  STRESS_ROUNDING = 4 * STRESS_PROMISE,
  STRESS_PERTURBED = 1 + 2 * STRESS_PROMISE,
  STRESS_GENEROUS = 100
};

enum stress_kind { STRESS_STEADY, STRESS_PHASE, STRESS_TRAJECTORY };
/* A family changes ordinary cases, which x[0] to x[6] make; all x are quasi-random in [0, 1). */
struct stress_family {
  const char *name, *about;
  enum stress_kind kind;
  double sizes;                   /* m, F and L are from 10^-sizes to 10^sizes; 0: those of an ordinary case */
  double eps[2], T[2];            /* decades of T^2 (F1 + F2)/(M L), or of T; 0, 0: those of an ordinary case */
  int masses, forces;             /* which x moves their ratio by up to 12 decades either way; 0: none */
  int equal_forces, equal_phases; /* which x brings their difference near 0; 0: none */
  double scale;                   /* the units of m, F and L: each times 10^-scale to 10^scale */
  int change;         /* of alpha or T besides, as families.c names it                                        */
  int start;          /* of a phase or a trajectory, likewise                                                 */
  int boundary;       /* of this kind: it is near                                                             */
  const char *regime; /* of the steady state; NULL: any                                                       */
  const char *gait;   /* the one gait that it is made for, unless another is given; NULL: it is made for all */
};
extern const struct stress_family stress_families[]; /* the last has no name */
/* count cases of a family, the same for the same seed. Returns how many there are: fewer where hundreds of tries give
 * none. */
int stress_make(const struct stress_family *family, const struct scallop_gait *gait, unsigned long seed, int count,
                struct stress_case *cases);

#endif
