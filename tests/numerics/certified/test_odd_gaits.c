/* Motions with gaits of every kind that model.h allows: dwells, stretches in which l rests, and both bodies are one on
 * friction F1 + F2 until they rest as well, by hand; what becomes of more modes than are kept. The solvers against
 * each other: test_agree.c, test_integrators.c. */
#include <float.h>

#include "asymptotics/derived/branch.h"
#include "tests/support/agree.h"
#include "tests/support/odd_gaits.h"

/* Extensions of tau = 3/4. Body 1 is held whenever it is at rest: its friction is above m2 |l''| + F2. In the dwell at
 * the start v' = -(F1 + F2)/M = -64: from v0 = 3 both rest after 3/64, 9/128 further on; then body 2 goes out and back.
 * Above every curve the dwells are nothing special: v' = -64 throughout. nan: not looked at */
static const struct {
  const struct scallop_gait *gait;
  double F1, v0;
  const char *modes;
  enum scallop_regime regime;
  double numbers[6]; /* t1, dT, v_end, dx1, dx2, dxC */
} extensions[] = {
  { &wait_gait,
    127,
    3,
    "++ 00 0+ 00 0- 00",
    SCALLOP_STICK_SLIP,
    { 3. / 64, 0.75 / 8, 0, 9. / 128, 137. / 128, 73. / 128 } },
  { &wait_gait, 127, -3, "-- 00 0+ 00 0- 00", SCALLOP_STICK_SLIP, { 3. / 64, 0.75 / 8, 0, -9. / 128, NAN, NAN } },
  { &wait_gait, 1023, 0, "00 0+ 00 0- 00", SCALLOP_AT_REST, { 0.75 / 8, 0.75 / 8, 0, 0, 1, 0.5 } },
  { &pause_gait, 127, 1000, "++", SCALLOP_SLIDING, { NAN, NAN, 952, NAN, NAN, 732 } },
};

static struct scallop_crawler anchored(const struct scallop_gait *gait, double F1)
{
  struct scallop_crawler c = with_gait(gait);
  c.F1 = F1;
  c.L = 1;
  return c;
}

TEST(extensions_by_hand)
{
  for (size_t i = 0; i < sizeof extensions / sizeof *extensions; i++) {
    struct scallop_crawler c = anchored(extensions[i].gait, extensions[i].F1);
    struct scallop_phase_result r = phase_of(&c, SCALLOP_EXTENSION, extensions[i].v0);
    const double got[] = { r.t1, r.dT, r.v_end, r.dx1, r.dx2, r.dxC };
    modes_are(&r.modes, extensions[i].modes);
    assert_int_equal(r.regime, extensions[i].regime);
    for (int q = 0; q < 6; q++)
      if (!isnan(extensions[i].numbers[q]))
        CHECK_RELATIVE(got[q], extensions[i].numbers[q], q < 3 ? 2e-16 : 1e-15);
  }
}

/* Body 1 never moves, whatever body 2 does; with less friction, but fast, no body ever rests. Held by a dwell for any
 * length of time, and moving otherwise: stick-slip, and the start is forgotten. */
TEST(periods_by_hand)
{
  struct scallop_crawler c = anchored(&wait_gait, 1023);
  struct scallop_period_result p = period_of(&c, 0);
  modes_are(&p.modes[SCALLOP_CONTRACTION], "00 0- 00 0+ 00");
  assert_true(p.v_end == 0 && p.multiplier == 0 && p.displacement == 0 && p.regime == SCALLOP_AT_REST);
  c = anchored(&pause_gait, 127);
  p = period_of(&c, 1000);
  CHECK_EQUAL(p.multiplier, 1);
  CHECK_RELATIVE(p.balance, -1, 1e-15);
  c = with_gait(&wait_gait);
  c.F1 = 60;
  c.F2 = 50;
  p = period_of(&c, 0.5);
  assert_true(p.regime == SCALLOP_STICK_SLIP && p.multiplier == 0 && p.v_end == period_of(&c, -2).v_end);
}

/* A dwell of a fourth of the time costs a fourth of the friction there is. What the phases of unlike duration bring has
 * to be more, or it comes to rest there however short the period is: (F1 - F2)/(F1 + F2) (2 alpha - 1) 3/4 = 0.576
 * here, and 0.225 by default. With phases of one duration what the contraction does is the mirror image of what the
 * extension does, half a period late. */
TEST(slides_on)
{
  struct scallop_crawler c = with_gait(&pause_gait);
  c.T = 1. / 64;
  struct scallop_steady_result s = steady_of(&c);
  modes_are(&s.period.modes[0], "++ -+ ++ 00 -+ ++");
  c.F1 = 49;
  c.alpha = 0.9;
  s = steady_of(&c);
  modes_are(&s.period.modes[0], "++ -+ ++ -+ ++");
  modes_are(&s.period.modes[1], "++ +- ++ +- ++");
  assert_int_equal(s.period.regime, SCALLOP_SLIDING);
  CHECK_NEAR(s.period.balance, 0, 1e-15);
  CHECK_RELATIVE(period_of(&c, s.period.v_start).v_end, s.period.v_start, 1e-15);
  assert_true(s.period.multiplier > 0 && s.period.multiplier < 1);
  c.alpha = 0.5;
  s = steady_of(&c);
  CHECK_RELATIVE(s.period.v_mid, -s.period.v_start, 1e-13);
  CHECK_EQUAL(s.period.displacement, 0);
}

/* There is no series for it, and the reason says that l' is 0 within a phase. */
TEST(no_series_with_a_dwell)
{
  assert_false(branch_is_possible(&pause_gait) || branch_is_possible(&wait_gait) || branch_is_possible(&hesitant_gait));
  assert_non_null(strstr(branch_impossible, "l' is 0"));
}

/* With phases of one duration a gait leads nowhere if the contraction does the opposite of the extension, and detour
 * does not, though |l'| is the same. */
TEST(the_same_speeds_in_other_directions)
{
  const struct unit unit = { 10, 10, 1, 1 };
  const struct allowed allowed = { { 1e-12, 0, 1e-27 } };
  for (int i = 0; i < 2; i++) {
    struct scallop_crawler c = with_gait(i == 0 ? &there_and_back_gait : &detour_gait);
    c.alpha = 0.5;
    const struct motion m = steady_motion(&c);
    agree(&m, &unit, &allowed);
    double displacement = steady_of(&c).period.displacement;
    assert_true(i == 0 ? displacement == 0 : fabs(displacement) >= 1e-5 * c.L);
  }
}

static void count_mode(void *context, const struct scallop_interval *interval)
{
  struct scallop_modes *m = context;
  struct scallop_mode *last = &m->kept[1];
  if (m->count == 0 || last->s1 != interval->mode.s1 || last->s2 != interval->mode.s2)
    m->count++;
  *last = interval->mode;
}

/* All are counted; the text has the first ones, "...", and the last. */
TEST(modes_beyond_those_kept)
{
  struct teeth teeth;
  grow_teeth(&teeth);
  struct scallop_crawler c = with_gait(&teeth.gait);
  struct scallop_modes counted = { .count = 0 };
  char text[SCALLOP_MODES_TEXT];
  SCOPED(scallop_certified_phase, exact);
  c.F1 = c.F2 = 0.1;
  certify_phase(&exact, &c, SCALLOP_EXTENSION, 5, 30);
  struct scallop_phase_result d = phase_of(&c, SCALLOP_EXTENSION, 5);
  assert_int_equal(scallop_phase_intervals(&c, SCALLOP_EXTENSION, 5, count_mode, &counted), SCALLOP_OK);
  assert_true(d.modes.count == 2 * TEETH + 1 && counted.count == d.modes.count && modes_alike(&exact.modes, &d.modes));
  scallop_modes_text(&d.modes, text);
  assert_int_equal(strlen(text), 3 * SCALLOP_MODES_KEPT - 1 + strlen("... "));
  assert_memory_equal(text, "++ -+ ++ -+ ", strlen("++ -+ ++ -+ "));
  assert_string_equal(text + strlen(text) - strlen("++ ... ++"), "++ ... ++");
}
