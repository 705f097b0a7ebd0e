/* The solver in wider arithmetic, and the estimates of errors that come from it, at the edges. Against certified
 * values: test_agree.c. */
#include <float.h>

#include "numerics/wide/wide.h"
#include "tests/support/random_crawler.h"
#include "tests/support/solved.h"

enum { CRAWLERS = 60 };

/* A wrong number is told so: by how much it is wrong. */
TEST(estimate_of_a_wrong_number)
{
  struct scallop_crawler c = scallop_crawler_default();
  struct scallop_phase_error e;
  struct scallop_phase_result p = phase_of(&c, SCALLOP_EXTENSION, 2.5);
  p.v_end += 1e-9;
  p.dx1 -= 1e-3;
  p.t1 = NAN;
  assert_int_equal(scallop_phase_error(&c, SCALLOP_EXTENSION, 2.5, &p, &e), SCALLOP_OK);
  CHECK_RELATIVE(e.v_end, 1e-9, 0.01);
  CHECK_RELATIVE(e.dx1, 1e-3, 0.01);
  CHECK_EQUAL(e.t1, NAN);
  CHECK_AT_MOST(e.dT, 1e-16);
}

/* A period from the steady start velocity ends where it began, to what the rounding of that to a double changes. */
TEST(period_and_steady_state_agree)
{
  for (int g = 0; g < 2; g++)
    for (int width = 0; width < 2; width++) {
      struct scallop_crawler c = with_gait(every_gait[g]);
      struct scallop_wide_steady s;
      struct scallop_wide_period p;
      struct scallop_period_error e;
      assert_int_equal(scallop_wide_steady((enum scallop_width)width, &c, &s), SCALLOP_OK);
      assert_int_equal(scallop_wide_period((enum scallop_width)width, &c, s.period.v_start.high, &p), SCALLOP_OK);
      double rounded = -s.period.v_start.low; /* v_end - v_start = multiplier times the distance */
      double change = (p.v_end.high - s.period.v_start.high) + (p.v_end.low - s.period.v_start.low);
      CHECK_NEAR(change, s.period.multiplier.high * rounded,
                 ldexp(100, width == SCALLOP_LONG_DOUBLE ? 1 - LDBL_MANT_DIG : -104));
      CHECK_EQUAL(p.multiplier.high, s.period.multiplier.high);
      struct scallop_period_result d = period_of(&c, 1);
      assert_int_equal(scallop_period_error(&c, 1, &d, &e), SCALLOP_OK);
      CHECK_AT_MOST(e.v_mid, 1e-14);
      CHECK_AT_MOST(e.v_end, 1e-14);
      CHECK_AT_MOST(e.displacement, 1e-14);
      CHECK_AT_MOST(e.multiplier, 1e-14);
    }
}

/* A sinusoidal gait that says no law */
enum { MOST = 4 };
static struct scallop_gait lawless_gait(struct scallop_piece pieces[2][MOST])
{
  struct scallop_gait gait = scallop_gait_sinusoidal;
  for (int kind = 0; kind < 2; kind++) {
    assert_true(gait.phase[kind].count <= MOST);
    for (int i = 0; i < gait.phase[kind].count; i++) {
      pieces[kind][i] = gait.phase[kind].pieces[i];
      pieces[kind][i].law = NULL;
    }
    gait.phase[kind].pieces = pieces[kind];
  }
  return gait;
}

/* A gait without a law; and steady states that fill an interval. What every solver refuses: test_range.c. */
TEST(refusals)
{
  struct scallop_piece pieces[2][MOST];
  const struct scallop_gait gait = lawless_gait(pieces);
  struct scallop_crawler lawless = with_gait(&gait), many = with_gait(&sawtooth_gait);
  many.alpha = 0.5;
  for (int width = SCALLOP_LONG_DOUBLE; width <= SCALLOP_BINARY128; width++) {
    enum scallop_width w = (enum scallop_width)width;
    REFUSES(scallop_wide_steady, scallop_wide_steady(w, &lawless, &out), SCALLOP_EDOMAIN);
    REFUSES(scallop_wide_phase, scallop_wide_phase(w, &lawless, SCALLOP_EXTENSION, 1, &out), SCALLOP_EDOMAIN);
    REFUSES(scallop_wide_steady, scallop_wide_steady(w, &many, &out), SCALLOP_EDOMAIN);
  }
}

#if defined __x86_64__ || defined __i386__
static void set_control_word(unsigned short word) { __asm__ volatile("fldcw %0" : : "m"(word)); }

/* The processor may be set to round long double to 53 bits: then binary128 takes its place, and no solve waits for
 * digits that never come. */
TEST(long_double_rounded_to_double)
{
  enum { USUAL = 0x37f, ROUNDED = 0x27f };
  struct random r = { 20261205 };
  struct scallop_wide_steady w;
  set_control_word(ROUNDED);
  int bits = scallop_width_bits(SCALLOP_LONG_DOUBLE);
  struct scallop_crawler c = scallop_crawler_default();
  enum scallop_status status = scallop_wide_steady(SCALLOP_LONG_DOUBLE, &c, &w);
  set_control_word(USUAL);
  assert_int_equal(bits, 0);
  assert_int_equal(status, SCALLOP_EDOMAIN);
  assert_int_equal(scallop_width_bits(SCALLOP_LONG_DOUBLE), LDBL_MANT_DIG);
  for (int n = 0; n < CRAWLERS; n++) {
    struct scallop_steady_result rounded;
    c = random_crawler(&r, NEARLY_EQUAL_FORCES, every_gait[n % 2]);
    struct scallop_steady_result usual = steady_of(&c);
    set_control_word(ROUNDED);
    status = scallop_steady(&c, &rounded);
    set_control_word(USUAL);
    assert_int_equal(status, SCALLOP_OK);
    CHECK_RELATIVE(rounded.period.displacement, usual.period.displacement, 16 * DBL_EPSILON);
  }
}
#endif

/* One phase, or a period, in double; the largest of the numbers in *size; 0: there are none */
static enum scallop_status solve_double(bool whole, const struct scallop_crawler *c, double v0, double *size)
{
  struct scallop_phase_result p = { 0 };
  struct scallop_period_result q = { 0 };
  enum scallop_status status = whole ? scallop_period(c, v0, &q) : scallop_phase(c, SCALLOP_EXTENSION, v0, &p);
  const double numbers[] = { p.v_end, p.dx1, p.dx2, p.dxC, q.v_mid, q.v_end, q.displacement };
  *size = 0;
  for (int i = 0; i < 7; i++)
    *size = fmax(*size, fabs(numbers[i]));
  return status;
}

static enum scallop_status solve_wide(bool whole, const struct scallop_crawler *c, double v0, bool *kept)
{
  struct scallop_wide_phase phase = { .v_end = { 7, 7 } };
  struct scallop_wide_period period = { .v_end = { 7, 7 } };
  enum scallop_status status = whole ? scallop_wide_period(SCALLOP_BINARY128, c, v0, &period)
                                     : scallop_wide_phase(SCALLOP_BINARY128, c, SCALLOP_EXTENSION, v0, &phase);
  *kept = (whole ? period.v_end.low : phase.v_end.low) == 7;
  return status;
}

/* At the last units in which the numbers are in range in double: true ones are beyond, some times, and then that is
 * said, and else never. With so long a period and such small masses no number is larger than the displacement. */
TEST(beyond_the_range)
{
  enum { TRIES = 120, LAST = 6 };
  struct random r = { 20261203 };
  int beyond[2] = { 0 };
  for (int n = 0; n < TRIES; n++) {
    const double T = 1e3, mass = 1e-12;
    bool whole = n % 4 < 2, kept;
    struct scallop_crawler c = random_crawler(&r, ORDINARY, every_gait[n % 2]);
    double shorter = c.T / T, v0 = random_between(&r, -80, 80) * c.L / T, low = 1, high = 0x1p1023, size;
    c.m1 *= mass;
    c.m2 *= mass;
    c.F1 *= mass * shorter * shorter;
    c.F2 *= mass * shorter * shorter;
    c.T = T;
    while (nextafter(low, high) < high) {
      double unit = high > 4 * low ? sqrt(low) * sqrt(high) : low + (high - low) / 2;
      struct scallop_crawler there = in_units(&c, &(struct units){ 1, unit, 1 });
      *(solve_double(whole, &there, v0 * unit, &size) == SCALLOP_OK ? &low : &high) = unit;
    }
    for (int i = 0; i < LAST; i++, low = nextafter(low, 0)) {
      struct scallop_crawler there = in_units(&c, &(struct units){ 1, low, 1 });
      if (solve_double(whole, &there, v0 * low, &size) != SCALLOP_OK)
        continue;
      enum scallop_status status = solve_wide(whole, &there, v0 * low, &kept);
      assert_int_equal(status, kept ? SCALLOP_ERANGE : SCALLOP_OK);
      if (kept)
        CHECK_AT_MOST(1 - size / DBL_MAX, 0x1p-40);
      beyond[whole] += kept;
    }
  }
  assert_true(beyond[0] > 0 && beyond[1] > 0);
}

/* What cancels stays as doubles have it, good to a few ulp of the amplitude. */
TEST(of_a_gait_without_a_law)
{
  struct scallop_piece pieces[2][MOST];
  const struct scallop_gait lawless = lawless_gait(pieces);
  struct random r = { 20261123 };
  for (int i = 0; i < check_cases(400); i++) {
    struct scallop_crawler c = random_crawler(&r, i % 2 ? EQUAL_FORCES : NEARLY_EQUAL_FORCES, &scallop_gait_sinusoidal);
    double wanted = steady_of(&c).period.displacement, near = 64 * DBL_EPSILON * c.L;
    double low = -20 * c.L / c.T, high = 20 * c.L / c.T; /* a start velocity from which body 1 hardly gets anywhere */
    for (int n = 0; n < 40; n++)
      *(phase_of(&c, SCALLOP_EXTENSION, (low + high) / 2).dx1 > 0 ? &high : &low) = (low + high) / 2;
    double dx1 = phase_of(&c, SCALLOP_EXTENSION, low).dx1;
    c.gait = &lawless;
    struct scallop_period_result steady = steady_of(&c).period;
    CHECK_NEAR(steady.displacement, wanted, near);
    CHECK_NEAR(period_of(&c, steady.v_start).displacement, wanted, near);
    CHECK_NEAR(phase_of(&c, SCALLOP_EXTENSION, low).dx1, dx1, near + 64 * DBL_EPSILON * fabs(low) * c.T);
  }
}
