/* The judgement of one case of `stress`: the numbers of its answer in double against certified ones. Needs FLINT.
 *
 * The unit of judgement. Each parameter is a double and so known to an ulp at best. For a result y and its parameters
 * x_i
 *
 *     unit = max(ulp(y), sum over i of the larger |y(x_i one ulp up or down) - y|),   condition number = unit/ulp(y)
 *
 * with y certified and the changes from binary128 arithmetic: differences, not derivatives, so that kinks and square
 * roots at the boundaries of modes count for what they are. Where y is 0 there is a unit all the same, but no ulp. The
 * promise is an error of at most 8 units; docs/stability.md lists the exceptions. */
#ifndef SCALLOP_COMPARE_STRESS_JUDGE_H
#define SCALLOP_COMPARE_STRESS_JUDGE_H

#include "compare/stress/families.h"

/* The quantities of the motion (answers/quantities.h), in order; of a trajectory x and v at its end. */
enum { STRESS_QUANTITIES = 6 };
const char *stress_quantity_name(enum stress_kind kind, int quantity);

struct stress_number {
  /* false: the motion has no such quantity (t1 of a phase without a change of mode), or it may jump here */
  bool exists;
  double exact, got; /* exact: rounded to double; got: in double              */
  double error, unit;
  double ulp;           /* 0 where exact is 0 or tiny                           */
  double resolved;      /* by 113 bits, of what the number is counted in        */
  double resolved_sum;  /* by 113 bits, of the parts that it is the sum of; set where a promise seems broken */
  double wide_error[2]; /* of long double and binary128                         */
  double estimate;      /* of the error, as a solve returns it                  */
  double rounding;      /* largest minus smallest result of the four rounding modes */
  double perturbed;     /* the largest change where one parameter is an ulp off */
};

enum stress_outcome {
  STRESS_SOLVED,
  STRESS_REFUSED,   /* by the double solver: out of its range; or the steady states fill an interval */
  STRESS_UNDECIDED, /* by the certified solver: binary128 replaces it   */
  STRESS_BROKEN     /* a promise is broken for the case as a whole      */
};
struct stress_judgement {
  enum stress_outcome outcome;
  const char *why;  /* of another outcome than solved                               */
  bool other_modes; /* than binary128 finds: quantities that jump there are not judged */
  bool only_error;  /* a trajectory: neither roundings nor estimates are judged     */
  struct stress_number number[STRESS_QUANTITIES];
};
void stress_judge(const struct stress_case *stressed, struct stress_judgement *judgement);

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

/* Has the case an answer to judge? */
bool stress_is_judged(const struct stress_judgement *judgement, int quantity);
/* NULL: the promise holds for this quantity; else what is broken. */
const char *stress_broken(const struct stress_judgement *judgement, int quantity);

#endif
