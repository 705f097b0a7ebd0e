/* The energy that friction takes in a period of the steady state, and the cost of transport: force times way, and in
 * double against binary128, and that against balls. */
#include <float.h>

#include "tests/support/agree.h"

enum { CRAWLERS = 200, DIGITS = 25 };

static double friction_work(const struct scallop_crawler *c, const struct scallop_steady_result *s)
{
  double work = NAN;
  assert_int_equal(scallop_friction_work(c, s->period.v_start, s->period.v_mid, &work), SCALLOP_OK);
  return work;
}

static struct scallop_crawler under_test;

static void name_the_culprit(void) { print_crawler(&under_test); }

static enum scallop_phase_kind phase;

static void add_work(void *context, const struct scallop_interval *i)
{
  const struct scallop_span span = scallop_interval_span(i, &under_test, phase);
  *(double *)context += under_test.F1 * fabs(span.dx1) + under_test.F2 * fabs(span.dx2);
}

/* Force times way, interval by interval, in which no body turns. That this is what the linkage gives, less the kinetic
 * energy, is a law of laws.h. */
TEST(force_times_way)
{
  struct random r = { 20261122 };
  int judged[3] = { 0 };
  check_failed = name_the_culprit;
  for (int n = 0; n < 2 * CRAWLERS; n++) {
    struct scallop_steady_result s;
    double sum = 0;
    under_test = random_crawler(&r, (enum family)(n / ALL_GAITS % FAMILIES), every_gait[n % ALL_GAITS]);
    assert_true(scallop_steady(&under_test, &s) >= 0);
    const double start[] = { s.period.v_start, s.period.v_mid };
    for (phase = SCALLOP_EXTENSION; phase <= SCALLOP_CONTRACTION; phase++)
      assert_int_equal(scallop_phase_intervals(&under_test, phase, start[phase], add_work, &sum), SCALLOP_OK);
    CHECK_RELATIVE(friction_work(&under_test, &s), sum, 64 * DBL_EPSILON);
    judged[s.period.regime]++;
  }
  check_failed = NULL;
  assert_true(judged[0] > 10 && judged[1] > 10 && judged[2] > 10);
}

enum { NAMED = 2 };
static const enum quantity_id named[NAMED] = { Q_FRICTION_WORK, Q_COST_OF_TRANSPORT };

static struct answer in_binary128(const struct scallop_crawler *c)
{
  const struct motion m = steady_motion(c);
  struct answer a;
  assert_true(answer_in_wide(&a, &m, SCALLOP_BINARY128));
  return a;
}

/* As in numerics.h: what one ulp of each parameter changes it by, or its own ulp if that is more. */
static double unit_of(enum quantity_id q, const struct scallop_crawler *c, const struct answer *at)
{
  double sum = 0;
  for (int i = 0; i < PARAMETERS; i++) {
    struct scallop_crawler moved = *c;
    *parameter(&moved, i) = nextafter(*parameter(&moved, i), 0);
    const struct answer a = in_binary128(&moved);
    sum += wide_apart(&a.value[q], &at->value[q]);
  }
  return fmax(sum, nextafter(at->value[q].high, INFINITY) - at->value[q].high);
}

/* Binary128 beside balls: to 20 digits at least, which are far beyond a double's. Double beside it: 8 units, as every
 * number of the solver. The cost has one where there is a displacement. */
TEST(every_arithmetic_agrees)
{
  struct random r = { 20261123 };
  int costs = 0, certified = 0;
  SCOPED(ball_answer, balls);
  check_failed = name_the_culprit;
  for (int n = 0; n < CRAWLERS; n++) {
    under_test = random_crawler(&r, (enum family)(n / SMOOTH_GAITS % FAMILIES), every_gait[n % SMOOTH_GAITS]);
    const struct motion m = steady_motion(&under_test);
    const struct answer wide = in_binary128(&under_test);
    struct answer a;
    bool in_balls = n % 3 == 0 && answer_of_doubles(&balls, &m, DIGITS);
    assert_true(answer_in_double(&a, &m) && isnan(a.value[Q_FRICTION_WORK].high));
    assert_int_equal(answer_complete(&a, &m), SCALLOP_OK);
    bool has_cost = a.value[Q_DISPLACEMENT].high != 0;
    assert_int_equal(isnan(a.value[Q_COST_OF_TRANSPORT].high), !has_cost);
    costs += has_cost;
    certified += in_balls;
    for (int q = 0; q < 1 + has_cost; q++) {
      const struct scallop_wide *number = &wide.value[named[q]];
      CHECK_AT_MOST(wide_apart(&a.value[named[q]], number), 8 * unit_of(named[q], &under_test, &wide));
      if (in_balls && balls.value[named[q]])
        CHECK_AT_MOST(off_by(number, balls.value[named[q]]), 1e-20 * fabs(number->high));
    }
  }
  check_failed = NULL;
  assert_true(costs > CRAWLERS / 2 && certified > CRAWLERS / 4);
}
