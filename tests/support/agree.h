/* One motion in double, long double, binary128 and balls: the modes of all are alike, and the numbers of each lie
 * within its stated error of those that are certified. Header-only; needs FLINT. */
#ifndef SCALLOP_TESTS_SUPPORT_AGREE_H
#define SCALLOP_TESTS_SUPPORT_AGREE_H

#include <float.h>

#include "compare/answers/answer_flint.h"
#include "compare/stress/stress.h"
#include "tests/support/certified_balls.h"

/* What a number is counted in; `one`: a multiplier */
struct unit {
  double velocity, length, time, one;
};
/* How many of these a number may be off by in double and in both wider types; 0: not solved in that type */
enum { IN_DOUBLE, IN_LONG_DOUBLE, IN_BINARY128, ARITHMETICS };
struct allowed {
  double units[ARITHMETICS];
};
/* Two doubles hold no more than 100 bits. */
#define ULP_LONG 0x1p-63
#define ULP_WIDE 0x1p-99

static inline struct motion steady_motion(const struct scallop_crawler *c)
{
  return (struct motion){ .of = OF_STEADY, .crawler = *c };
}

static inline struct motion phase_motion(const struct scallop_crawler *c, enum scallop_phase_kind phase, double v0)
{
  return (struct motion){ OF_PHASE, *c, phase, v0 };
}

static inline void disagree(const struct motion *m, const char *where, const char *what, double off, double most)
{
  print_crawler(&m->crawler);
  fail_msg("%s %d from v0 = %.17g, %s: %s, off by %.3g of %.3g", m->of == OF_STEADY ? "steady state" : "phase",
           (int)m->phase, m->v0, where, what, off, most);
}

static inline double unit_of_quantity(const struct unit *unit, int q, double value)
{
  const char *name = quantity_rows[q].unit;
  if (q == Q_FROUDE)
    return fabs(value);
  return strcmp(name, "1") == 0        ? unit->one
         : strcmp(name, "time") == 0   ? unit->time
         : strcmp(name, "length") == 0 ? unit->length
                                       : unit->velocity;
}

static inline double off_by(const struct scallop_wide *got, const arb_t exact)
{
  SCOPED(arb, value, low);
  arb_set_d(value, got->high);
  arb_set_d(low, got->low);
  arb_add(value, value, low, 400);
  return apart(value, exact);
}

/* error[q]: what else the number may not be further off than; NULL: no more is asked */
static inline void answer_agrees(const struct motion *m, const char *where, const struct answer *got,
                                 const struct ball_answer *exact, const struct unit *unit, double units,
                                 const double *error)
{
  if (got->status != SCALLOP_OK || got->regime != exact->regime || !same_modes(got->modes, exact->modes))
    disagree(m, where, "status, regime or modes", NAN, 0);
  for (int q = quantity_first(m->of); q < (int)quantity_end(m->of); q++) {
    const struct scallop_wide *value = &got->value[q];
    if (!exact->value[q]) {
      assert_true(isnan(value->high));
      continue;
    }
    double off = off_by(value, exact->value[q]), radius = mag_get_d(arb_radref(exact->value[q])),
           most = units * unit_of_quantity(unit, q, value->high);
    if (!(off <= most))
      disagree(m, where, quantity_rows[q].name, off, most);
    if (error && !(off - 2.001 * radius <= error[q]))
      disagree(m, "the error that is stated", quantity_rows[q].name, off, error[q]);
  }
}

static inline void agree(const struct motion *m, const struct unit *unit, const struct allowed *allowed)
{
  static const char *const names[ARITHMETICS] = { "double", "long double", "binary128" };
  enum { DIGITS_OF_BALLS = 40 };
  struct answer got;
  double error[QUANTITIES];
  SCOPED(ball_answer, exact);
  if (!answer_of_doubles(&exact, m, DIGITS_OF_BALLS))
    disagree(m, "balls", exact.why ? exact.why : scallop_status_text(exact.status), NAN, 0);
  assert_true(answer_with_errors(&got, m, error));
  answer_agrees(m, names[0], &got, &exact, unit, allowed->units[IN_DOUBLE], error);
  for (int w = 0; w < 2; w++)
    if (allowed->units[1 + w] > 0 && scallop_width_bits((enum scallop_width)w) > 0) {
      assert_true(answer_in_wide(&got, m, (enum scallop_width)w));
      answer_agrees(m, names[1 + w], &got, &exact, unit, allowed->units[1 + w], NULL);
    }
}

/* The bound of numerics.h, 8 units of the number, and of the error that is stated (compare/stress/stress.h).
 * pieces: 0, or how many there are of a gait with many: where c goes on from one to the next it is rounded twice, a
 * unit at most, and in directed rounding all these have one sign. to_epsilon: 8 * 2^-52 of the number are allowed as
 * well, which is up to twice as many ulp. Returns what became of the case: not STRESS_BROKEN. */
static inline enum stress_outcome bound_is_kept(const struct motion *m, int pieces, bool to_epsilon)
{
  struct stress_case s = { .motion = *m };
  char text[STRESS_ARGUMENTS];
  stress_judge(&s);
  for (int q = 0; q < QUANTITIES; q++) {
    const struct stress_number *n = &s.number[q];
    const char *broken = n->broken;
    if (to_epsilon && broken && strcmp(broken, "error") == 0 && n->error <= STRESS_BOUND * DBL_EPSILON * fabs(n->exact))
      broken = NULL;
    if (pieces > 0 && s.outcome != STRESS_BROKEN)
      broken = !n->judged || n->error <= (STRESS_BOUND + pieces) * n->unit ? NULL : "error";
    if (!broken)
      continue;
    stress_arguments(&s, text);
    fail_msg("%s of %s: %.3g units, %.3g over the rounding modes, condition %.3g; %s", broken,
             stress_quantity_name(&s, q), n->error / n->unit, n->rounding / n->unit, n->unit / n->ulp, text);
  }
  return s.outcome;
}

#endif
