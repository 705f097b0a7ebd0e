/* The short cuts of the solver against the long way: the roots of concave.h and the closed form of ramps beside the
 * walk from event to event. That steady states found by the joint Newton's method of regular.c are those of the walk:
 * test_symmetry.c. */
#include <float.h>

#include "numerics/event/stuck.h"
#include "numerics/wide/wide.h"
#include "tests/support/random_crawler.h"
#include "tests/support/solved.h"

enum { CRAWLERS = 4000, PHASES = 25000 };

/* Two ramps of different slopes, and other ones in the contraction */
static struct scallop_straight made_skewed;
#define skewed_gait made_skewed.gait

/* Concave: l'' falls all the way, and l' does not jump; its values at the ends: tests/model/test_gaits.c */
TEST(gaits_are_what_they_say)
{
  enum { STEPS = 64 };
  int concave = 0, ramps = 0;
  for (int i = 0; i <= ALL_GAITS; i++)
    for (int kind = 0; kind < 2; kind++) {
      const struct scallop_shape *shape = &(i < ALL_GAITS ? every_gait[i] : &skewed_gait)->phase[kind];
      const struct scallop_piece *p = shape->pieces;
      double last = INFINITY;
      assert_true(shape->concave || !shape->ramps);
      assert_true(!shape->ramps || (shape->count == 2 && p[0].linear && p[1].linear));
      concave += shape->concave;
      ramps += shape->ramps;
      for (int k = 0; shape->concave && k <= STEPS * shape->count; k++) {
        const struct scallop_piece *q = p + (k == 0 ? 0 : (k - 1) / STEPS);
        double u = q->begin + (q->end - q->begin) * (k - (double)STEPS * (double)(q - p)) / STEPS,
               bend = q->direction * q->curve->acceleration(q, u);
        assert_true(!q->jump && bend <= last + 4 * DBL_EPSILON * fabs(bend));
        last = bend;
      }
    }
  assert_true(concave == 8 && ramps == 4);
}

static struct phase_input phase_in(const struct scallop_scaled *s, enum scallop_phase_kind kind)
{
  return phase_input_of(s, &s->gait->phase[kind], s->fraction[kind]);
}

/* Roundings of c are those of a crossing over the difference of the slopes: a body that sticks does so near the top. */
static double where_it_is_flat(const struct phase_input *in, const struct passage *k)
{
  double delta = in->shape->pieces[0].direction * k->sign > 0 ? in->delta : -in->delta;
  return 4 * DBL_EPSILON * k->z / fabs(k->fall + k->side * in->eps * delta);
}

/* Of ramps the same operations in the same order, but for the way along a curve: the same bits where slopes are powers
 * of 2, else nearly. */
static void check_motion(const struct phase_input *in, double c0, bool exact, const struct period_motion *m,
                         const struct period_motion *walk)
{
  bool ramps = in->shape->ramps;
  double ulps = exact ? 0 : 16 * DBL_EPSILON, size = 2 + fabs(c0) + in->eps,
         flat = m->sticks && !ramps ? where_it_is_flat(in, &m->passage) : 0, slope = fabs(walk->slope);
  assert_int_equal(m->modes.count, walk->modes.count);
  assert_memory_equal(m->modes.kept, walk->modes.kept, (size_t)m->modes.count * sizeof *m->modes.kept);
  assert_true(m->forgets == walk->forgets && m->sticks == walk->sticks);
  assert_memory_equal(m->never_moved, walk->never_moved, sizeof m->never_moved);
  CHECK_NEAR(m->c_end, walk->c_end, ulps * size);
  CHECK_NEAR(m->way[0], walk->way[0], ramps ? 4 * DBL_EPSILON * (2 + fabs(c0)) : ulps * size);
  CHECK_NEAR(m->first_switch, walk->first_switch, ulps + flat);
  CHECK_NEAR(m->last_switch, walk->last_switch, ulps + flat);
  if (m->forgets)
    return;
  CHECK_NEAR(m->extra_impulse, walk->extra_impulse, ramps ? ulps : 4 * ulps);
  CHECK_NEAR(m->slope, walk->slope, ramps ? ulps * (slope + in->eps * slope * slope) : 1e3 * ulps * slope);
}

static const struct {
  const struct scallop_gait *gait;
  bool ramps;
} short_cuts[] = { { &scallop_gait_quadratic, true },
                   { &skewed_gait, true },
                   { &skewed_gait, false },
                   { &scallop_gait_sinusoidal, false },
                   { &trapezoid_gait, false } };

TEST(phases_are_those_of_the_walk)
{
  for (size_t i = 0; i < sizeof short_cuts / sizeof *short_cuts; i++) {
    struct random r = { 20261124 };
    long solved = 0, regular = 0, stuck = 0;
    for (long n = 0; n < PHASES; n++) {
      struct scallop_crawler c = random_crawler(&r, (enum family)(n % FAMILIES), short_cuts[i].gait);
      struct scallop_scaled s;
      struct period_motion m, walk;
      if (scallop_scale(&c, &s) != SCALLOP_OK)
        continue;
      struct phase_input in = phase_in(&s, n % 2 ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION);
      struct scallop_shape shape = *in.shape;
      shape.ramps = short_cuts[i].ramps;
      in.shape = &shape;
      double c0 = n % 3 == 0 ? 0 : n % 3 == 1 ? random_between(&r, -3, 3) : random_between(&r, -1, 1) * in.eps;
      motion_walk(&in, c0, NULL, NULL, &walk);
      regular += !walk.sticks && walk.modes.count == (c0 == 0 ? 2 : 3);
      if (!short_cut(&in, c0, &m))
        continue;
      solved++;
      stuck += m.sticks;
      check_motion(&in, c0, short_cuts[i].gait == &scallop_gait_quadratic, &m, &walk);
    }
    print_message("%s: %ld of %d, %ld of them stick; %ld are regular\n", short_cuts[i].gait->name, solved, PHASES,
                  stuck, regular);
    assert_true((double)solved > (short_cuts[i].ramps ? 0.7 * PHASES : 1000));
    assert_true((double)(solved - stuck) > 0.8 * (double)regular);
  }
}

/* A displacement that cancels is that of the body whose parts cancel least, with short cuts as by the walk. */
static void many_periods(const struct scallop_gait *gait)
{
  struct random r = { 20261125 };
  long cancelled = 0, stuck = 0;
  for (long n = 0; n < PHASES; n++) {
    struct scallop_crawler c = random_crawler(&r, n % 2 ? STICK_SLIP : ORDINARY, gait);
    struct scallop_scaled s;
    struct period p = { .continues = false }, q = { .continues = false };
    assert_int_equal(scallop_scale(&c, &s), SCALLOP_OK);
    struct walker walker = walker_of(&s), walks = walker;
    walks.walks = true;
    double c0 = random_between(&r, -1, 1) * fmin(1, s.eps), near = 64 * DBL_EPSILON * (1 + s.eps);
    period_solve(&walker, c0, &p);
    period_solve(&walks, c0, &q);
    if (!p.phase[0].short_cut || !p.phase[1].short_cut)
      continue;
    double size = p.size;
    period_sum_up(&walker, &p);
    period_sum_up(&walks, &q);
    cancelled += p.size < size;
    stuck += p.size < size && p.phase[0].sticks;
    CHECK_NEAR(p.c_end, q.c_end, near);
    CHECK_NEAR(p.size, q.size, near);
    CHECK_NEAR(p.travel, q.travel, near);
  }
  assert_true(cancelled > 1000 && stuck > 200);
}

/* Displacements of which too little is left are computed again in wider arithmetic by short cuts: they are those of the
 * walk in binary128 to the last digit. */
static void many_mended(const struct scallop_gait *gait)
{
  struct random r = { 20261126 };
  long mended = 0, stuck = 0;
  for (long n = 0; n < CRAWLERS; n++) {
    struct scallop_crawler c = random_crawler(&r, n % 2 ? STICK_SLIP : ORDINARY, gait);
    struct scallop_steady_result plain;
    struct scallop_wide_steady exact;
    struct doubt doubt;
    c.alpha = 0.5 + random_between(&r, -1, 1) * random_decades(&r, 1e-8, 0.1);
    assert_int_equal(solve_steady(&c, &plain, &doubt), SCALLOP_OK);
    if (!(doubt.left < 1))
      continue;
    struct scallop_steady_result mends = steady_of(&c);
    assert_int_equal(scallop_wide_steady(SCALLOP_BINARY128, &c, &exact), SCALLOP_OK);
    CHECK_RELATIVE(mends.period.displacement, exact.period.displacement.high, 2 * DBL_EPSILON);
    mended++;
    stuck += mends.period.regime == SCALLOP_STICK_SLIP;
  }
  print_message("%s: %ld mended, %ld of them stuck\n", gait->name, mended, stuck);
  assert_true(mended > CRAWLERS / 40 && stuck > CRAWLERS / 100);
}

TEST(displacements_that_cancel)
{
  many_periods(&scallop_gait_quadratic);
  many_periods(&scallop_gait_sinusoidal);
  many_mended(&scallop_gait_quadratic);
  many_mended(&skewed_gait);
  many_mended(&scallop_gait_sinusoidal);
}

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

/* The short cut is taken where it should be, and its work is counted. */
TEST(work_is_counted)
{
  struct scallop_crawler c = scallop_crawler_default();
  struct scallop_work w = steady_of(&c).work;
  assert_true(w.periods == 1 && w.events == 4 && w.gait_evaluations == 0 && w.root_iterations == 0);
  c.gait = &scallop_gait_sinusoidal;
  w = steady_of(&c).work;
  assert_true(w.periods == 1 && w.events == 4 && w.root_iterations >= 1 && w.root_iterations <= 6);
  assert_int_equal(w.gait_evaluations, 4 * w.root_iterations);
  struct scallop_gait walked = walked_gait(c.gait);
  c.gait = &walked;
  w = steady_of(&c).work;
  assert_true(w.periods > 1 && w.events == 4 * w.periods && w.gait_evaluations > 20 * w.periods);
}

static int make_gait(void **state)
{
  (void)state;
  return scallop_make_skewed(&made_skewed, "skewed", (const double[2]){ 0.25, 0.625 }) == SCALLOP_OK ? 0 : -1;
}

int main(void) { return check_run(make_gait, NULL); }
