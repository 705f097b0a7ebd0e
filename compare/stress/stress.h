/* stress: how many digits survive. Cases of many families, hard ones above all, solved in double and judged by certified values.
 * Needs FLINT; the work is spread over all cores by OpenMP, and what comes out does not depend on how many there are.
 *
 * The unit of judgement. Each parameter is a double and so known to an ulp at best. For a result y and its parameters x_i
 *
 *     unit = max(ulp(y), sum over i of the larger |y(x_i one ulp up or down) - y|),       condition number = unit/ulp(y)
 *
 * with y from certified and the changes from binary128 arithmetic: differences, not derivatives, so that kinks and square roots at
 * the boundaries of modes count for what they are. Where y is 0 there is a unit all the same, but no ulp. The promise is an error of
 * at most 8 units.
 */
#ifndef SCALLOP_STRESS_H
#define SCALLOP_STRESS_H

#include "compare/answers/points.h"
#include "compare/text/values.h"
#include "compare/answers/gaits.h"
#include "numerics/wide.h"

/* ---- cases ---- */

enum stress_kind { STRESS_STEADY, STRESS_PHASE, STRESS_TRAJECTORY };
struct stress_case {
  enum stress_kind kind;
  struct scallop_crawler crawler;
  enum scallop_phase_kind phase; /* of a phase                                                             */
  double v0;                     /* of a phase, or a trajectory                                            */
  long periods;                  /* of a trajectory                                                        */
};

struct stress_family {
  const char *name, *about;
  enum stress_kind kind;
  /* The case of quasi-random x[STRESS_DIMENSIONS] in [0, 1), in which the gait is set; false: these give none, try the next. */
  bool (*make)(struct stress_case *stressed, const double *x);
};
enum { STRESS_DIMENSIONS = 10 };
extern const struct stress_family stress_families[]; /* the last has no name */

/* count cases of a family, the same for the same seed. Returns how many there are: fewer where hundreds of tries give none. */
int stress_make(const struct stress_family *family, const struct scallop_gait *gait, unsigned long seed, int count,
                struct stress_case *cases);

/* "--m1 1 --m2 ... --gait quadratic", then of a phase "--phase extension --v0 0", of a trajectory "--start 3.1 --periods 1000". text holds STRESS_ARGUMENTS bytes. */
enum { STRESS_ARGUMENTS = 400 + GAIT_TEXT };
void stress_arguments(const struct stress_case *stressed, char *text);

/* ---- judgement ---- */

enum { STRESS_QUANTITIES = 6 };
/* Those of answers/quantities.h of the motion, in order; of a trajectory x and v at its end. */
const char *stress_quantity_name(enum stress_kind kind, int quantity);

enum stress_outcome {
  STRESS_SOLVED,
  STRESS_REFUSED /* by the solver, for its range */,
  STRESS_UNDECIDED /* certified */,
  STRESS_LIED
};
struct stress_judgement {
  enum stress_outcome outcome;
  bool other_modes;                /* than binary128 finds: what jumps there is not judged                          */
  bool only_error;                 /* neither roundings nor estimates are looked at                              */
  const char *why;                 /* of another outcome than solved                                            */
  bool has[STRESS_QUANTITIES];     /* false: there is no such number (t1 of a phase without a change of mode)   */
  double exact[STRESS_QUANTITIES]; /* rounded to double                                                         */
  double got[STRESS_QUANTITIES];
  double error[STRESS_QUANTITIES], unit[STRESS_QUANTITIES], ulp[STRESS_QUANTITIES]; /* ulp: 0 where exact is 0 or tiny */
  double wide_error[2][STRESS_QUANTITIES]; /* of long double and binary128                                      */
  double estimate[STRESS_QUANTITIES];      /* of the error, as a solve returns it                              */
  double rounding[STRESS_QUANTITIES];      /* largest minus smallest result of the four rounding modes        */
  double perturbed[STRESS_QUANTITIES];     /* the largest change of the result where one parameter is an ulp off */
};
void stress_judge(const struct stress_case *stressed, struct stress_judgement *judgement);
void stress_judge_trajectory(const struct stress_case *stressed, struct stress_judgement *judgement);

/* What the two have in common. One of the parameters m1 m2 F1 F2 L T alpha v0 replaced by the double so many places on; false: there is no such
 * parameter here, or that one is not allowed. |a - b|. */
bool stress_neighbour(const struct stress_case *stressed, int parameter, double towards, int places,
                      struct stress_case *next);
double stress_difference(const struct scallop_wide *a, const struct scallop_wide *b);

/* What is promised, in units. In a directed rounding each operation errs by up to an ulp instead of a half, so a result by twice as
 * much, and the spread is between two of them; a change of one parameter moves the result by a unit, and both ends err. An estimate may
 * be so many times the error, or the 128th part of an ulp if that is more. */
enum {
  STRESS_PROMISE = 8,
  STRESS_ROUNDING = 4 * STRESS_PROMISE,
  STRESS_PERTURBED = 1 + 2 * STRESS_PROMISE,
  STRESS_GENEROUS = 100
};

/* NULL: the promise holds for this quantity; else what is broken. */
const char *stress_broken(const struct stress_judgement *judgement, int quantity);

/* `scallop stress`; of one point */
struct stress_options {
  struct request request;
  const char *family;             /* the only one, or NULL */
  struct given_count cases, seed; /* of each family, 0: as many as is usual; of their parameters */
  bool check, full, stiff, quick, summary;
};
enum exit_code stress_table(const struct stress_options *options);
enum exit_code stress_point(const struct stress_options *options);

#endif
