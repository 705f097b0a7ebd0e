/* The energy that friction takes in a period of the steady state, and the cost of transport: against the work of the
 * mechanism, in double against binary128, and that against balls. */
#include <float.h>

#include "tests/support/agree.h"

enum { CRAWLERS = 300, DIGITS = 25 };

static double friction_work(const struct scallop_crawler *c, const struct scallop_steady_result *s)
{
  double work = NAN;
  assert_int_equal(scallop_friction_work(c, s->period.v_start, s->period.v_mid, &work), SCALLOP_OK);
  return work;
}

struct mechanism {
  const struct scallop_crawler *crawler;
  double tau;
  double work, size; /* of the tension, and the sum of the magnitudes of its parts */
};

/* The tension pulls body 1 by +S and body 2 by -S, apart with power -S l'. From Newton's law for a body that moves, in
 * units of the crawler: m_i x_i'' = +-S - F_i s_i. */
static double power(const struct mechanism *m, const struct scallop_interval *i, double u)
{
  const struct scallop_crawler *c = m->crawler;
  double rate = i->piece->curve->velocity(i->piece, u), bend = i->piece->curve->acceleration(i->piece, u);
  double M = c->m1 + c->m2, c_rate = i->mode.s1 && i->mode.s2 ? i->c_slope : i->glue * bend;
  double unit = c->L / (m->tau * m->tau), x1 = unit * (c_rate - c->m2 / M * bend),
         x2 = unit * (c_rate + c->m1 / M * bend);
  double push = i->mode.s2 ? c->m2 * x2 + c->F2 * i->mode.s2 : -(c->m1 * x1 + c->F1 * i->mode.s1);
  return i->mode.s1 == 0 && i->mode.s2 == 0 ? 0 : push * rate * c->L;
}

/* Gauss's rule with three points in PANELS parts: an interval lies in one piece, where l' is smooth. */
static void add_work(void *context, const struct scallop_interval *i)
{
  enum { PANELS = 32 };
  static const double node[3] = { -0.77459666924148337704, 0, 0.77459666924148337704 };
  static const double weight[3] = { 5. / 18, 8. / 18, 5. / 18 };
  struct mechanism *m = context;
  double step = (i->u_end - i->u_begin) / PANELS;
  for (int k = 0; k < PANELS; k++)
    for (int j = 0; j < 3; j++) {
      double part = power(m, i, i->u_begin + step * (k + 0.5 + 0.5 * node[j])) * weight[j] * fabs(step);
      m->work += part;
      m->size += fabs(part);
    }
}

/* The kinetic energy returns after a period, so that friction takes what the mechanism gives. Of gaits whose l' jumps
 * the impulses at the jumps give nothing on the whole: they change the energy of l' alone, which returns too. Allowed:
 * 1e-11 of the parts for the rule, and what the kinetic energy of the centre of mass changes by where a velocity is a
 * few ulp off. */
TEST(takes_what_the_mechanism_gives)
{
  struct random r = { 20261122 };
  int judged[3] = { 0 };
  for (int n = 0; n < CRAWLERS; n++) {
    enum family family = (enum family)(n / ALL_GAITS % FAMILIES);
    struct scallop_crawler c = random_crawler(&r, family, every_gait[n % ALL_GAITS]);
    struct scallop_steady_result s;
    struct mechanism m = { .crawler = &c };
    assert_true(scallop_steady(&c, &s) >= 0);
    for (int kind = 0; kind < 2; kind++) {
      m.tau = scallop_phase_duration(&c, (enum scallop_phase_kind)kind);
      double v = kind == SCALLOP_EXTENSION ? s.period.v_start : s.period.v_mid;
      assert_true(scallop_phase_intervals(&c, (enum scallop_phase_kind)kind, v, add_work, &m) == SCALLOP_OK);
    }
    double work = friction_work(&c, &s), v = fmax(fabs(s.period.v_start), fabs(s.period.v_mid));
    double allowed = 1e-11 * m.size + 8 * DBL_EPSILON * (c.m1 + c.m2) * v * v;
    if (!(fabs(work - m.work) <= allowed))
      print_crawler(&c);
    CHECK_NEAR(work, m.work, allowed);
    judged[s.period.regime] += allowed < 1e-6 * work; /* else the inertia outweighs friction, as for tiny eps */
  }
  print_message("judged: %d sliding, %d stick-slip, %d at rest\n", judged[0], judged[1], judged[2]);
  for (int regime = 0; regime < 3; regime++)
    assert_true(judged[regime] > 10);
}

enum { NAMED = 2 };
static const enum quantity_id named[NAMED] = { Q_FRICTION_WORK, Q_COST_OF_TRANSPORT };

static void in_binary128(struct answer *a, const struct scallop_crawler *c)
{
  const struct motion m = steady_motion(c);
  assert_true(answer_in_wide(a, &m, SCALLOP_BINARY128));
}

/* As in numerics.h: what one ulp of each parameter changes it by, or its own ulp if that is more. */
static void units_of(double unit[NAMED], const struct scallop_crawler *c, const struct answer *at)
{
  double sum[NAMED] = { 0, 0 };
  for (int i = 0; i < PARAMETERS; i++) {
    struct scallop_crawler moved = *c;
    struct answer a;
    *parameter(&moved, i) = nextafter(*parameter(&moved, i), 0);
    in_binary128(&a, &moved);
    for (int q = 0; q < NAMED; q++)
      sum[q] += wide_apart(&a.value[named[q]], &at->value[named[q]]);
  }
  for (int q = 0; q < NAMED; q++)
    unit[q] = fmax(sum[q], nextafter(at->value[named[q]].high, INFINITY) - at->value[named[q]].high);
}

/* 8 units, as every number of the solver. The cost has one where there is a displacement. */
TEST(double_is_right)
{
  struct random r = { 20261123 };
  double worst[NAMED] = { 0, 0 };
  int costs = 0;
  for (int n = 0; n < CRAWLERS; n++) {
    struct scallop_crawler c = random_crawler(&r, (enum family)(n / SMOOTH_GAITS % FAMILIES),
                                              every_gait[n % SMOOTH_GAITS]);
    const struct motion m = steady_motion(&c);
    struct answer a, exact;
    double unit[NAMED];
    assert_true(answer_in_double(&a, &m));
    assert_true(isnan(a.value[Q_FRICTION_WORK].high));
    assert_int_equal(answer_complete(&a, &m), SCALLOP_OK);
    in_binary128(&exact, &c);
    units_of(unit, &c, &exact);
    bool has_cost = a.value[Q_DISPLACEMENT].high != 0;
    assert_int_equal(isnan(a.value[Q_COST_OF_TRANSPORT].high), !has_cost);
    costs += has_cost;
    for (int q = 0; q < 1 + has_cost; q++) {
      double units = wide_apart(&a.value[named[q]], &exact.value[named[q]]) / unit[q];
      if (!(units <= 8))
        print_crawler(&c);
      CHECK_AT_MOST(units, 8);
      worst[q] = fmax(worst[q], units);
    }
  }
  print_message("worst: %.3g and %.3g units, %d costs\n", worst[0], worst[1], costs);
  assert_true(costs > CRAWLERS / 2);
}

/* To 20 digits at least, which are far beyond a double's. */
TEST(binary128_is_certified)
{
  struct random r = { 20261124 };
  int solved = 0;
  SCOPED(ball_answer, b);
  for (int n = 0; n < CRAWLERS / 3; n++) {
    struct scallop_crawler c = random_crawler(&r, (enum family)(n / SMOOTH_GAITS % FAMILIES),
                                              every_gait[n % SMOOTH_GAITS]);
    const struct motion m = steady_motion(&c);
    struct answer a;
    if (!answer_of_doubles(&b, &m, DIGITS))
      continue;
    solved++;
    in_binary128(&a, &c);
    for (int q = 0; q < NAMED; q++)
      if (b.value[named[q]])
        CHECK_AT_MOST(off_by(&a.value[named[q]], b.value[named[q]]), 1e-20 * fabs(a.value[named[q]].high));
  }
  assert_true(solved > CRAWLERS / 4);
}

/* Equal forces in the limit of no inertia at all, and a body that never moves: the other one slides L and back. */
TEST(known_work)
{
  struct scallop_crawler c = { 1, 3, 2, 2, 10, 1e-6, 0.7, &scallop_gait_sinusoidal };
  struct scallop_steady_result s = steady_of(&c);
  CHECK_RELATIVE(friction_work(&c, &s), 2 * 10 * 2, 8 * DBL_EPSILON); /* c = 0: the paths are 2 L m2/M and 2 L m1/M */
  c = (struct scallop_crawler){ 1, 3, 1e6, 2, 10, 1, 0.7, &scallop_gait_quadratic };
  s = steady_of(&c);
  assert_int_equal(s.period.regime, SCALLOP_AT_REST);
  CHECK_RELATIVE(friction_work(&c, &s), 2 * 10 * 2, 8 * DBL_EPSILON);
}

TEST(refusals)
{
  struct scallop_crawler c = { 1, 1, 4, 1, 10, 1, 0.75, &scallop_gait_quadratic };
  double work = 42;
  assert_int_equal(scallop_friction_work(&c, NAN, 0, &work), SCALLOP_EDOMAIN);
  assert_int_equal(scallop_friction_work(&c, 0, INFINITY, &work), SCALLOP_EDOMAIN);
  c.F1 = -1;
  assert_int_equal(scallop_friction_work(&c, 1, 1, &work), SCALLOP_EDOMAIN);
  c.F1 = c.F2 = 1e308;
  c.m1 = c.m2 = 1e300;
  assert_int_equal(scallop_friction_work(&c, 0, 0, &work), SCALLOP_ERANGE);
  const struct scallop_crawler light = {
    3e-308, 3e-308, 4e-308, 3e-308, 0.01, 0.1, 0.75, &scallop_gait_quadratic
  }; /* the work is subnormal */
  assert_int_equal(scallop_friction_work(&light, 0, 0, &work), SCALLOP_ERANGE);
  assert_true(work == 42);
}
