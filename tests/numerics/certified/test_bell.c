/* Gaits of which |l'| is convex, then concave, then convex in each phase: which they are, and the steady states that
 * numerics/event/regular.c solves without a search, within the bound. */
#include <math.h>

#include "compare/points/gaits.h"
#include "tests/support/agree.h"
#include "tests/support/random_crawler.h"

static const struct {
  const char *text;
  bool bell, concave; /* in both phases */
} gaits[] = {
  { "minimum-jerk", true, false },
  { "polynomial:0,0,0,35,-84,70,-20", true, false },
  { "polynomial:0,0,20,-15,-12,10", true, false },             /* with its peak after the middle         */
  { "polynomial:0,6,-8,3", true, false },                      /* concave from the start                 */
  { "polynomial:0,3,-2", false, true },                        /* concave throughout                     */
  { "polynomial:0,0,0.63,-2.695,4.578,-3.5,1", false, false }, /* with two peaks                         */
  { "polynomial:0,0,0,0,0,0,1716,-9009,20020,-24024,16380,-6006,924", false, false }, /* too level at ends */
};
enum { GAITS = sizeof gaits / sizeof *gaits };

TEST(bells_are_recognized)
{
  for (int i = 0; i < GAITS; i++) {
    const struct scallop_gait *gait = gait_of_text(gaits[i].text).gait;
    for (int kind = 0; kind < 2; kind++)
      if (gait->phase[kind].bell != gaits[i].bell || gait->phase[kind].concave != gaits[i].concave)
        fail_msg("%s: bell %d, concave %d", gaits[i].text, gait->phase[kind].bell, gait->phase[kind].concave);
  }
}

/* Cubics through points of minimum-jerk; mixed: the contraction is two parabolas of l', concave */
static const struct scallop_gait *spline(bool mixed)
{
  static struct scallop_piece pieces[16];
  static struct scallop_law laws[16];
  static struct scallop_spline made;
  static const struct scallop_knot out[] = {
    { 0, 0, 0 }, { 0.25, 0.103515625, 1.0546875 }, { 0.5, 0.5, 1.875 }, { 0.75, 0.896484375, 1.0546875 }, { 1, 1, 0 }
  };
  static const struct scallop_knot home[] = {
    { 0, 1, 0 }, { 0.25, 0.896484375, -1.0546875 }, { 0.5, 0.5, -1.875 }, { 0.75, 0.103515625, -1.0546875 }, { 1, 0, 0 }
  };
  static const struct scallop_knot concave[] = { { 0, 1, 0 }, { 0.5, 0.5, -1.5 }, { 1, 0, 0 } };
  const struct scallop_knot *const knots[2] = { out, mixed ? concave : home };
  made = (struct scallop_spline){ .pieces = pieces, .laws = laws };
  assert_int_equal(scallop_make_spline(&made, "spline", knots, (const int[2]){ 5, mixed ? 3 : 5 }), SCALLOP_OK);
  assert_true(made.gait.phase[0].bell && made.gait.phase[1].bell == !mixed && made.gait.phase[1].concave == mixed);
  return &made.gait;
}

/* Of all crawlers, modes and velocity are those of a period that is followed from event to event. Where only the
 * crossings were looked at, 8 of 1000 had a body stuck in between. */
TEST(bells_move_as_the_walk_says)
{
  struct random r = { 43 };
  const long many = check_cases(6000);
  long solved = 0;
  for (long i = 0; i < many; i++) {
    const int gait = (int)(i % GAITS);
    struct scallop_steady_result s;
    struct scallop_period_result p;
    struct scallop_crawler c = { .m1 = random_decades(&r, 0.05, 20),
                                 .m2 = random_decades(&r, 0.05, 20),
                                 .F1 = random_decades(&r, 0.05, 20),
                                 .F2 = random_decades(&r, 0.05, 20),
                                 .T = 1,
                                 .alpha = random_between(&r, 0.02, 0.98),
                                 .gait = gait_of_text(gaits[gait].text).gait };
    c.L = (c.F1 + c.F2) / (c.m1 + c.m2) / random_decades(&r, 6e-6, 20);
    if (!gaits[gait].bell || scallop_steady(&c, &s) != SCALLOP_OK || s.work.periods > 2)
      continue;
    solved++;
    assert_int_equal(scallop_period(&c, s.period.v_start, &p), SCALLOP_OK);
    if (!same_modes(p.modes, s.period.modes))
      fail_msg("%s: m1 %.17g m2 %.17g F1 %.17g F2 %.17g L %.17g alpha %.17g", gaits[gait].text, c.m1, c.m2, c.F1, c.F2,
               c.L, c.alpha);
    CHECK_NEAR(p.v_end, p.v_start, 1e-9 * fabs(p.v_start));
  }
  assert_true(solved > many / 10);
}

/* Draws crawlers that slide. Returns how many were solved without a search; side: whether each phase ends in the
 * direction in which it began (+1), or in the other one (-1). */
static int solve_bells(struct random *r, const struct scallop_gait *gait, int side, int many)
{
  int solved = 0;
  for (int i = 0; i < many; i++) {
    struct motion m = { .of = OF_STEADY };
    struct scallop_steady_result s;
    struct scallop_crawler *c = &m.crawler;
    *c = (struct scallop_crawler){ .m1 = random_decades(r, 0.3, 3),
                                   .m2 = random_decades(r, 0.3, 3),
                                   .F1 = random_decades(r, 0.3, 3),
                                   .T = 1,
                                   .alpha = side > 0 ? random_between(r, 0.1, 0.9) : random_between(r, 0.4, 0.6),
                                   .gait = gait };
    c->F2 = side > 0 ? random_decades(r, 0.3, 3) : c->F1 * random_between(r, 0.4, 1.1);
    c->L = (c->F1 + c->F2) / (c->m1 + c->m2) / random_decades(r, 1e-4, 2);
    assert_int_equal(scallop_steady(c, &s), SCALLOP_OK);
    const struct scallop_mode *kept = s.period.modes[0].kept;
    const bool straight_on = kept[0].s1 == kept[2].s1;
    if (s.work.periods > 2 || s.period.modes[0].count != 3 || straight_on != (side > 0))
      continue;
    solved++;
    assert_int_not_equal(bound_is_kept(&m, 0, false), STRESS_BROKEN);
  }
  return solved;
}

TEST(bells_keep_the_bound)
{
  struct random r = { 41 };
  const int many = (int)check_cases(40);
  for (int i = 0; i < GAITS; i++) {
    const int solved = gaits[i].bell ? solve_bells(&r, gait_of_text(gaits[i].text).gait, 1, many) : many;
    if (solved < many / 2)
      fail_msg("%s: %d of %d are solved without a search", gaits[i].text, solved, many);
  }
  assert_true(solve_bells(&r, spline(false), 1, many) >= many / 2);
  assert_true(solve_bells(&r, spline(true), 1, many) >= many / 2);
  assert_true(solve_bells(&r, gait_of_text("minimum-jerk").gait, -1, many) >= many / 4);
}
