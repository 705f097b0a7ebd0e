/* The short cuts of the solver against the long way: the closed forms of ramps.c and the joint Newton's method of regular.c
 * beside the walk from event to event, which a gait takes that does not say what it is (concave and ramps left false). */
#include "tests/check.h"

#include <float.h>
#include <string.h>

#include "numerics/ramps.h"
#include "tests/random_crawler.h"

enum { CRAWLERS = 4000, PHASES = 100000 };

/* The same gait, which does not say so */
static struct scallop_gait plain(const struct scallop_gait *gait)
{
  struct scallop_gait copy = *gait;
  for (int kind = 0; kind < 2; kind++)
    copy.phase[kind].concave = copy.phase[kind].ramps = false;
  return copy;
}

/* ---- what a gait says of itself ---- */

static void check_concave(const struct scallop_gait *gait, const struct scallop_shape *shape)
{
  enum { STEPS = 64 };
  double last = INFINITY;
  assert_int_equal(shape->pieces[0].anchor, SCALLOP_FROM_START);
  assert_int_equal(shape->pieces[shape->count - 1].anchor, SCALLOP_FROM_END);
  for (int k = 0; k < shape->count; k++) {
    const struct scallop_piece *p = &shape->pieces[k];
    assert_false(p->jump);
    for (int i = 0; i <= STEPS; i++) {
      double u = p->begin + (p->end - p->begin) * i / STEPS, rate = p->direction * p->curve->acceleration(p, u);
      assert_true(rate <= last + 4 * DBL_EPSILON * fabs(rate));
      last = rate;
    }
  }
  const struct scallop_piece *first = &shape->pieces[0], *end = &shape->pieces[shape->count - 1];
  assert_true(first->curve->velocity(first, 0) == 0 && end->curve->velocity(end, 0) == 0);
  CHECK_NEAR(shape->l0, first->curve->acceleration(first, 0), 0);
  CHECK_NEAR(shape->lT, end->curve->acceleration(end, 0), 0);
  (void)gait;
}

static void gaits_are_what_they_say(void **state)
{
  (void)state;
  int concave = 0, ramps = 0;
  for (int i = 0; i < ALL_GAITS; i++)
    for (int kind = 0; kind < 2; kind++) {
      const struct scallop_shape *shape = &every_gait[i]->phase[kind];
      if (shape->concave)
        check_concave(every_gait[i], shape);
      assert_true(shape->concave || !shape->ramps);
      assert_true(!shape->ramps || (shape->count == 2 && shape->pieces[0].linear && shape->pieces[1].linear));
      concave += shape->concave;
      ramps += shape->ramps;
    }
  assert_true(concave == 6 && ramps == 2);
}

/* ---- a phase of two ramps ---- */

struct walked {
  struct motion motion;
  struct scallop_modes modes;
};

static struct walked walk(const struct motion_input *in, double c0, enum scallop_phase_kind kind)
{
  struct scallop_shape shape = *in->shape;
  struct motion_input plainly = *in;
  struct walked w;
  shape.ramps = false;
  plainly.shape = &shape;
  motion_solve(&plainly, c0, &w.motion, NULL, NULL);
  motion_modes(&w.motion, kind, &w.modes);
  return w;
}

/* The same operations in the same order, but for the way along a curve: the same bits. */
static void check_phase(const struct motion_input *in, double c0, enum scallop_phase_kind kind)
{
  struct motion m;
  struct scallop_modes modes;
  struct walked w = walk(in, c0, kind);
  if (!ramps_solve(in, c0, &m))
    return;
  ramps_modes(m.trail, kind, &modes);
  assert_int_equal(modes.count, w.modes.count);
  assert_memory_equal(modes.kept, w.modes.kept, (size_t)modes.count * sizeof *modes.kept);
  CHECK_EQUAL(m.c_end, w.motion.c_end);
  CHECK_EQUAL(m.first_switch, w.motion.first_switch);
  CHECK_EQUAL(m.last_switch, w.motion.last_switch);
  assert_true(m.forgets == w.motion.forgets && m.sticks == w.motion.sticks);
  assert_memory_equal(m.never_moved, w.motion.never_moved, sizeof m.never_moved);
  CHECK_NEAR(m.travel, w.motion.travel, 4 * DBL_EPSILON * (2 + fabs(c0)));
  if (!m.forgets) {
    CHECK_EQUAL(m.extra_impulse, w.motion.extra_impulse);
    CHECK_EQUAL(m.slope, w.motion.slope);
  }
}

static void ramps_are_the_walk(void **state)
{
  (void)state;
  struct random r = { 20261122 };
  long closed = 0;
  for (long n = 0; n < PHASES; n++) {
    struct scallop_crawler c = random_crawler(&r, (enum family)(n % FAMILIES), &scallop_gait_quadratic);
    enum scallop_phase_kind kind = n % 2 ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION;
    struct scallop_scaled s;
    struct motion m;
    if (scallop_scale(&c, &s) != SCALLOP_OK)
      continue;
    struct motion_input in = motion_input_of(&s, kind);
    double c0 = n % 3 == 0 ? 0 : n % 3 == 1 ? random_between(&r, -3, 3) : random_between(&r, -1, 1) * in.eps;
    closed += ramps_solve(&in, c0, &m);
    check_phase(&in, c0, kind);
  }
  assert_true(closed > PHASES * 0.9);
}

/* Exact coincidences are left to the walk: c at the curve just where it turns, c at 0 just at the end. */
static void coincidences(void **state)
{
  (void)state;
  struct scallop_crawler c = { 1, 1, 1, 1, 1, 1, 0.5, &scallop_gait_quadratic };
  struct scallop_scaled s;
  struct motion m;
  assert_int_equal(scallop_scale(&c, &s), SCALLOP_OK);
  struct motion_input in = motion_input_of(&s, SCALLOP_EXTENSION);
  assert_false(ramps_solve(&in, 1 + 0.5 * in.eps, &m)); /* on curve 0 at half time */
  assert_false(ramps_solve(&in, -1 - 0.5 * in.eps, &m));
  assert_false(ramps_solve(&in, 0, &m)); /* equal forces: c stays 0, and is 0 at the end */
  assert_true(ramps_solve(&in, nextafter(1 + 0.5 * in.eps, 2), &m));
}

/* ---- the steady state ---- */

/* The condition of the steady velocity: what an ulp of the forces, masses and times does to it. */
static double condition(const struct scallop_crawler *c)
{
  const double step = 0x1p-26;
  double worst = 0;
  for (int i = 0; i < 7; i++) {
    double v[2];
    for (int up = 0; up < 2; up++) {
      struct scallop_crawler moved = *c;
      double *field[] = { &moved.m1, &moved.m2, &moved.F1, &moved.F2, &moved.L, &moved.T, &moved.alpha };
      struct scallop_steady_result r;
      *field[i] *= up ? 1 + step : 1 - step;
      if (scallop_steady(&moved, &r) < 0)
        return INFINITY;
      v[up] = r.period.v_start;
    }
    worst += fabs(v[1] - v[0]) / (2 * step);
  }
  return worst;
}

static double worst_share;

static void check_steady(const struct scallop_crawler *c)
{
  struct scallop_gait gait = plain(c->gait);
  struct scallop_crawler long_way = *c;
  struct scallop_steady_result a, b;
  long_way.gait = &gait;
  assert_int_equal(scallop_steady(c, &a), scallop_steady(&long_way, &b));
  double unit = fmax(fabs(b.period.v_start), condition(&long_way)) * DBL_EPSILON;
  worst_share = fmax(worst_share, unit > 0 ? fabs(a.period.v_start - b.period.v_start) / unit : 0);
  CHECK_NEAR(a.period.v_start, b.period.v_start, 8 * unit);
  CHECK_NEAR(a.period.v_mid, b.period.v_mid, 16 * unit * (1 + a.period.multiplier) + 8 * DBL_EPSILON * fabs(b.period.v_mid));
  CHECK_NEAR(a.period.multiplier, b.period.multiplier, 64 * DBL_EPSILON);
  assert_int_equal(a.period.regime, b.period.regime);
  for (int phase = 0; phase < 2; phase++) {
    assert_int_equal(a.period.modes[phase].count, b.period.modes[phase].count);
    assert_memory_equal(a.period.modes[phase].kept, b.period.modes[phase].kept,
                        (size_t)a.period.modes[phase].count * sizeof *a.period.modes[phase].kept);
  }
}

static void steady_states(void **state)
{
  const struct scallop_gait *gait = *state;
  struct random r = { 20261123 };
  long shortened = 0;
  worst_share = 0;
  for (long n = 0; n < CRAWLERS; n++) {
    struct scallop_crawler c = random_crawler(&r, n % 2 ? ORDINARY : n % 4 ? SMALL_PERIOD : STICK_SLIP, gait);
    struct scallop_steady_result s;
    assert_true(scallop_steady(&c, &s) >= 0);
    shortened += s.work.periods == 1;
    check_steady(&c);
  }
  print_message("%s: %ld of %d by a short cut, worst %.1f ulp of max(value, condition)\n", gait->name, shortened, CRAWLERS,
                worst_share);
  assert_true(shortened > CRAWLERS / 4);
}

/* The short cut is taken where it should be, and its work is counted. */
static void work_is_counted(void **state)
{
  (void)state;
  struct scallop_crawler c = scallop_crawler_default();
  struct scallop_steady_result r;
  assert_int_equal(scallop_steady(&c, &r), SCALLOP_OK);
  assert_true(r.work.periods == 1 && r.work.events == 4 && r.work.gait_evaluations == 0 && r.work.root_iterations == 0);
  c.gait = &scallop_gait_sinusoidal;
  assert_int_equal(scallop_steady(&c, &r), SCALLOP_OK);
  assert_true(r.work.periods == 1 && r.work.events == 4);
  assert_true(r.work.root_iterations >= 1 && r.work.root_iterations <= 6);
  assert_int_equal(r.work.gait_evaluations, 4 * r.work.root_iterations);
  struct scallop_gait gait = plain(c.gait);
  c.gait = &gait;
  assert_int_equal(scallop_steady(&c, &r), SCALLOP_OK);
  assert_true(r.work.periods > 1 && r.work.events == 4 * r.work.periods && r.work.gait_evaluations > 20 * r.work.periods);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(gaits_are_what_they_say),
    cmocka_unit_test(ramps_are_the_walk),
    cmocka_unit_test(coincidences),
    cmocka_unit_test_prestate(steady_states, (void *)&scallop_gait_quadratic),
    cmocka_unit_test_prestate(steady_states, (void *)&scallop_gait_sinusoidal),
    cmocka_unit_test_prestate(steady_states, (void *)&trapezoid_gait),
    cmocka_unit_test(work_is_counted),
  };
  return cmocka_run_group_tests_name("shortcuts", tests, NULL, NULL);
}
