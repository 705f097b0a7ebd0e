/* The short cuts of the solver against the long way: the roots of concave.h and the joint
 * Newton's method of regular.c beside the walk from event to event, which a gait takes that does not say what it is
 * (concave and ramps left false). */
#include <float.h>

#include "numerics/event/stuck.h"
#include "numerics/wide/wide.h"
#include "tests/support/random_crawler.h"
#include "tests/support/solved.h"

enum { CRAWLERS = 4000, PHASES = 100000 };

/* Two ramps of different slopes, and other ones in the contraction */
static struct scallop_straight made_skewed;
#define skewed_gait made_skewed.gait

/* The same gait, which does not say so */
static struct scallop_gait plain(const struct scallop_gait *gait)
{
  struct scallop_gait copy = *gait;
  for (int kind = 0; kind < 2; kind++)
    copy.phase[kind].concave = copy.phase[kind].ramps = false;
  return copy;
}

static void check_concave(const struct scallop_shape *shape)
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
}

TEST(gaits_are_what_they_say)
{
  int concave = 0, ramps = 0;
  for (int i = 0; i <= ALL_GAITS; i++)
    for (int kind = 0; kind < 2; kind++) {
      const struct scallop_shape *shape = &(i < ALL_GAITS ? every_gait[i] : &skewed_gait)->phase[kind];
      if (shape->concave)
        check_concave(shape);
      assert_true(shape->concave || !shape->ramps);
      assert_true(!shape->ramps || (shape->count == 2 && shape->pieces[0].linear && shape->pieces[1].linear));
      concave += shape->concave;
      ramps += shape->ramps;
    }
  assert_true(concave == 8 && ramps == 4);
}

static struct phase_input phase_in(const struct scallop_scaled *s, enum scallop_phase_kind kind)
{
  return phase_input_of(s, &s->gait->phase[kind], s->fraction[kind]);
}

/* The same operations in the same order, but for the way along a curve: the same bits where slopes are powers of 2,
 * else nearly. */
static void check_phase(const struct phase_input *in, double c0)
{
  struct period_motion m, w;
  motion_walk(in, c0, NULL, NULL, &w);
  if (!short_cut(in, c0, &m))
    return;
  assert_int_equal(m.modes.count, w.modes.count);
  assert_memory_equal(m.modes.kept, w.modes.kept, (size_t)m.modes.count * sizeof *m.modes.kept);
  bool exact = in->shape == &scallop_gait_quadratic.phase[0] || in->shape == &scallop_gait_quadratic.phase[1];
  double roundings = exact ? 0 : 16 * DBL_EPSILON;
  CHECK_NEAR(m.c_end, w.c_end, roundings * (fabs(c0) + in->eps + 2));
  CHECK_NEAR(m.first_switch, w.first_switch, roundings);
  CHECK_NEAR(m.last_switch, w.last_switch, roundings);
  assert_true(m.forgets == w.forgets && m.sticks == w.sticks);
  assert_memory_equal(m.never_moved, w.never_moved, sizeof m.never_moved);
  CHECK_NEAR(m.way[0], w.way[0], 4 * DBL_EPSILON * (2 + fabs(c0)));
  if (!m.forgets) {
    CHECK_NEAR(m.extra_impulse, w.extra_impulse, roundings);
    CHECK_NEAR(m.slope, w.slope, roundings * (fabs(m.slope) + in->eps * m.slope * m.slope));
  }
}

TEST(ramps_are_the_walk)
{
  struct random r = { 20261122 };
  long closed = 0;
  for (long n = 0; n < PHASES; n++) {
    struct scallop_crawler c = random_crawler(&r, (enum family)(n % FAMILIES),
                                              n % 5 ? &skewed_gait : &scallop_gait_quadratic);
    enum scallop_phase_kind kind = n % 2 ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION;
    struct scallop_scaled s;
    struct period_motion m;
    if (scallop_scale(&c, &s) != SCALLOP_OK)
      continue;
    const struct phase_input in = phase_in(&s, kind);
    double c0 = n % 3 == 0 ? 0 : n % 3 == 1 ? random_between(&r, -3, 3) : random_between(&r, -1, 1) * in.eps;
    closed += short_cut(&in, c0, &m);
    check_phase(&in, c0);
  }
  print_message("%ld of %d in closed form\n", closed, PHASES);
  assert_true(closed > PHASES * 0.7);
}

/* Roundings of c are those of a crossing over the difference of the slopes: a body that sticks does so near the top. */
static double where_it_is_flat(const struct phase_input *in, const struct passage *k)
{
  double delta = in->shape->pieces[0].direction * k->sign > 0 ? in->delta : -in->delta;
  return 4 * DBL_EPSILON * k->z / fabs(k->fall + k->side * in->eps * delta);
}

static void many_phases(const struct scallop_gait *gait)
{
  struct random r = { 20261124 };
  long solved = 0, regular = 0, stuck = 0;
  for (long n = 0; n < PHASES / 4; n++) {
    struct scallop_crawler c = random_crawler(&r, (enum family)(n % FAMILIES), gait);
    enum scallop_phase_kind kind = n % 2 ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION;
    struct scallop_scaled s;
    struct period_motion m, w;
    if (scallop_scale(&c, &s) != SCALLOP_OK)
      continue;
    struct phase_input in = phase_in(&s, kind);
    struct scallop_shape concave = *in.shape;
    concave.ramps = false;
    in.shape = &concave;
    double c0 = n % 3 == 0 ? 0 : n % 3 == 1 ? random_between(&r, -2, 2) : random_between(&r, -1, 1) * in.eps;
    motion_walk(&in, c0, NULL, NULL, &w);
    regular += !w.sticks && w.modes.count == (c0 == 0 ? 2 : 3);
    if (!short_cut(&in, c0, &m))
      continue;
    solved++;
    assert_int_equal(m.modes.count, w.modes.count);
    assert_memory_equal(m.modes.kept, w.modes.kept, (size_t)m.modes.count * sizeof *m.modes.kept);
    double size = 2 + fabs(c0) + in.eps, roundings = 16 * DBL_EPSILON;
    CHECK_NEAR(m.c_end, w.c_end, roundings * size);
    CHECK_NEAR(m.way[0], w.way[0], roundings * size);
    double flat = m.sticks ? where_it_is_flat(&in, &m.passage) : 0;
    CHECK_NEAR(m.first_switch, w.first_switch, roundings + flat);
    CHECK_NEAR(m.last_switch, w.last_switch, roundings + flat);
    assert_true(m.forgets == w.forgets && m.sticks == w.sticks);
    assert_memory_equal(m.never_moved, w.never_moved, sizeof m.never_moved);
    stuck += m.sticks;
    if (m.forgets)
      continue;
    CHECK_NEAR(m.extra_impulse, w.extra_impulse, 4 * roundings);
    CHECK_NEAR(m.slope, w.slope, 1e3 * roundings * fabs(w.slope));
  }
  print_message("%s: %ld of %d, %ld of them slide, %ld stick\n", gait->name, solved, PHASES / 4, regular, stuck);
  assert_true(solved > 1000 && solved - stuck > 0.8 * (double)regular);
}

TEST(concave_is_the_walk_sinusoidal) { many_phases(&scallop_gait_sinusoidal); }
TEST(concave_is_the_walk_trapezoid) { many_phases(&trapezoid_gait); }
TEST(concave_is_the_walk_skewed) { many_phases(&skewed_gait); }

/* A displacement that cancels is that of the body whose parts cancel least, with short cuts as by the walk. */
static void many_periods(const struct scallop_gait *gait)
{
  struct random r = { 20261125 };
  long cancelled = 0, stuck = 0;
  for (long n = 0; n < PHASES / 4; n++) {
    struct scallop_crawler c = random_crawler(&r, n % 2 ? STICK_SLIP : ORDINARY, gait);
    struct scallop_scaled s;
    struct period p = { .continues = false }, q = { .continues = false };
    assert_int_equal(scallop_scale(&c, &s), SCALLOP_OK);
    struct walker walker = walker_of(&s), walks = walker;
    walks.walks = true;
    double c0 = random_between(&r, -1, 1) * fmin(1, s.eps);
    period_solve(&walker, c0, &p);
    period_solve(&walks, c0, &q);
    if (!p.phase[0].short_cut || !p.phase[1].short_cut)
      continue;
    double size = p.size;
    period_sum_up(&walker, &p);
    period_sum_up(&walks, &q);
    cancelled += p.size < size;
    stuck += p.size < size && p.phase[0].sticks;
    CHECK_NEAR(p.c_end, q.c_end, 64 * DBL_EPSILON * (1 + s.eps));
    CHECK_NEAR(p.size, q.size, 64 * DBL_EPSILON * (1 + s.eps));
    CHECK_NEAR(p.travel, q.travel, 64 * DBL_EPSILON * (1 + s.eps));
  }
  print_message("%s: %ld, %ld of them stuck\n", gait->name, cancelled, stuck);
  assert_true(cancelled > 1000 && stuck > 200);
}

TEST(ways_of_bodies_quadratic) { many_periods(&scallop_gait_quadratic); }
TEST(ways_of_bodies_sinusoidal) { many_periods(&scallop_gait_sinusoidal); }

/* Displacements of which too little is left are computed again in wider arithmetic by short cuts: they are those of the
 * walk in binary128 to the last digit. */
static void many_mended(const struct scallop_gait *gait)
{
  struct random r = { 20261126 };
  long mended = 0, stuck = 0;
  for (long n = 0; n < CRAWLERS; n++) {
    struct scallop_crawler c = random_crawler(&r, n % 2 ? STICK_SLIP : ORDINARY, gait);
    struct scallop_steady_result plain, mends;
    struct scallop_wide_steady exact;
    struct doubt doubt;
    c.alpha = 0.5 + random_between(&r, -1, 1) * random_decades(&r, 1e-8, 0.1);
    assert_int_equal(solve_steady(&c, &plain, &doubt), SCALLOP_OK);
    if (!(doubt.left < 1))
      continue;
    assert_int_equal(scallop_steady(&c, &mends), SCALLOP_OK);
    assert_int_equal(scallop_wide_steady(SCALLOP_BINARY128, &c, &exact), SCALLOP_OK);
    CHECK_RELATIVE(mends.period.displacement, exact.period.displacement.high, 2 * DBL_EPSILON);
    mended++;
    stuck += mends.period.regime == SCALLOP_STICK_SLIP;
  }
  print_message("%s: %ld, %ld of them stuck\n", gait->name, mended, stuck);
  assert_true(mended > CRAWLERS / 40 && stuck > CRAWLERS / 100);
}

TEST(mended_quadratic) { many_mended(&scallop_gait_quadratic); }
TEST(mended_skewed) { many_mended(&skewed_gait); }
TEST(mended_sinusoidal) { many_mended(&scallop_gait_sinusoidal); }

/* Exact coincidences are left to the walk: c at the curve just where it turns, c at 0 just at the end. */
TEST(coincidences)
{
  struct scallop_crawler c = { 1, 1, 1, 1, 1, 1, 0.5, &scallop_gait_quadratic };
  struct scallop_scaled s;
  struct period_motion m;
  assert_int_equal(scallop_scale(&c, &s), SCALLOP_OK);
  const struct phase_input in = phase_in(&s, SCALLOP_EXTENSION);
  assert_false(short_cut(&in, 1 + 0.5 * in.eps, &m)); /* on curve 0 at half time */
  assert_false(short_cut(&in, -1 - 0.5 * in.eps, &m));
  assert_false(short_cut(&in, 0, &m)); /* equal forces: c stays 0, and is 0 at the end */
  assert_true(short_cut(&in, nextafter(1 + 0.5 * in.eps, 0), &m));
}

/* What relative changes of the forces, masses and times do to the velocities at the start and in the middle. */
static void conditions(const struct scallop_crawler *c, double condition[2])
{
  const double step = 0x1p-26;
  condition[0] = condition[1] = 0;
  for (int i = 0; i < PARAMETERS; i++) {
    struct scallop_steady_result r[2];
    for (int up = 0; up < 2; up++) {
      struct scallop_crawler moved = *c;
      *parameter(&moved, i) *= up ? 1 + step : 1 - step;
      assert_true(scallop_steady(&moved, &r[up]) >= 0);
    }
    condition[0] += fabs(r[1].period.v_start - r[0].period.v_start) / (2 * step);
    condition[1] += fabs(r[1].period.v_mid - r[0].period.v_mid) / (2 * step);
  }
}

static double worst_share;
static long touches;

static void check_steady(const struct scallop_crawler *c)
{
  struct scallop_gait gait = plain(c->gait);
  struct scallop_crawler long_way = *c;
  struct scallop_steady_result a, b;
  long_way.gait = &gait;
  assert_int_equal(scallop_steady(c, &a), scallop_steady(&long_way, &b));
  double condition[2], got[2] = { a.period.v_start, a.period.v_mid }, wanted[2] = { b.period.v_start, b.period.v_mid };
  conditions(&long_way, condition);
  for (int i = 0; i < 2; i++) {
    double unit = fmax(fabs(wanted[i]), condition[i]) * DBL_EPSILON;
    worst_share = fmax(worst_share, unit > 0 ? fabs(got[i] - wanted[i]) / unit : 0);
    CHECK_NEAR(got[i], wanted[i], 8 * unit);
  }
  if (!modes_alike(&a.period.modes[0], &b.period.modes[0])
      || !modes_alike(&a.period.modes[1],
                      &b.period.modes[1])) { /* c lies on a plateau of |l'|: every motion near it is another */
    touches++;
    return;
  }
  CHECK_NEAR(a.period.multiplier, b.period.multiplier, 64 * DBL_EPSILON);
  assert_int_equal(a.period.regime, b.period.regime);
}

static void many_steady_states(const struct scallop_gait *gait)
{
  struct random r = { 20261123 };
  long shortened = 0;
  worst_share = 0;
  touches = 0;
  for (long n = 0; n < CRAWLERS; n++) {
    struct scallop_crawler c = random_crawler(&r, n % 2 ? ORDINARY : n % 4 ? SMALL_PERIOD : STICK_SLIP, gait);
    struct scallop_steady_result s;
    assert_true(scallop_steady(&c, &s) >= 0);
    shortened += s.work.periods == 1;
    check_steady(&c);
  }
  print_message("%s: %ld of %d by a short cut, worst %.1f ulp of max(value, condition)\n", gait->name, shortened,
                CRAWLERS, worst_share);
  assert_true(shortened > CRAWLERS / 4);
  assert_true(touches <= (gait == &trapezoid_gait ? CRAWLERS / 100 : 0));
}

TEST(steady_states_quadratic) { many_steady_states(&scallop_gait_quadratic); }
TEST(steady_states_sinusoidal) { many_steady_states(&scallop_gait_sinusoidal); }
TEST(steady_states_trapezoid) { many_steady_states(&trapezoid_gait); }
TEST(steady_states_skewed) { many_steady_states(&skewed_gait); }

/* The short cut is taken where it should be, and its work is counted. */
TEST(work_is_counted)
{
  struct scallop_crawler c = scallop_crawler_default();
  struct scallop_steady_result r = steady_of(&c);
  assert_true(r.work.periods == 1 && r.work.events == 4 && r.work.gait_evaluations == 0 && r.work.root_iterations == 0);
  c.gait = &scallop_gait_sinusoidal;
  r = steady_of(&c);
  assert_true(r.work.periods == 1 && r.work.events == 4);
  assert_true(r.work.root_iterations >= 1 && r.work.root_iterations <= 6);
  assert_int_equal(r.work.gait_evaluations, 4 * r.work.root_iterations);
  struct scallop_gait gait = plain(c.gait);
  c.gait = &gait;
  r = steady_of(&c);
  assert_true(r.work.periods > 1 && r.work.events == 4 * r.work.periods
              && r.work.gait_evaluations > 20 * r.work.periods);
}

static int make_gait(void **state)
{
  (void)state;
  return scallop_make_skewed(&made_skewed, "skewed", (const double[2]){ 0.25, 0.625 }) == SCALLOP_OK ? 0 : -1;
}

int main(void) { return check_run(make_gait, NULL); }
