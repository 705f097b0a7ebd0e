/* Gaits whose l' jumps: constant:R, of which with R = 0, l' constant out and back, all is known in closed form
 * (docs/background/theory.md), and is what R -> 0 tends to; and where the steady states fill an interval. */
#include <float.h>

#include "compare/points/gaits.h"
#include "tests/support/agree.h"

enum { CRAWLERS = 1500, DIGITS = 40 };

/* A crawler with one steady state, F1 > F2 and the extension the longer phase (others are seen in a mirror:
 * test_symmetry.c); and how near to rounding that is, in L/T: the velocities that meet, over what is left until there
 * is an interval of them */
static struct scallop_crawler next_crawler(struct random *r, double *size)
{
  static const enum family families[] = { ORDINARY, STICK_SLIP, SMALL_PERIOD };
  struct scallop_crawler c = { 0 };
  double delta = 0;
  while (delta > 0.9 || delta < 1e-3 || c.alpha - 0.5 < 1e-3) {
    c = random_crawler(r, families[random_below(r, 3)], &sawtooth_gait);
    delta = (c.F1 - c.F2) / (c.F1 + c.F2);
  }
  *size = (1 / c.alpha + 1 / (1 - c.alpha) + crawler_eps(&c)) / (1 - delta);
  return c;
}

/* The cases of docs/background/theory.md, told from each other by the multiplier: body 1 is held, it slides on, or body
 * 2 reverses as well. Returns which. */
static int check_by_hand(const struct scallop_crawler *c, const struct scallop_period_result *p, double near)
{
  double M = c->m1 + c->m2, a = c->alpha, b = 1 - a, eps = crawler_eps(c), delta = (c->F1 - c->F2) / (c->F1 + c->F2);
  double U = c->m2 / M / a, W = c->m1 / M / b, down = -c->m1 / M / a, held = -c->m2 / M / b;
  double v_start = p->v_start * c->T / c->L, v_mid = p->v_mid * c->T / c->L, way = p->displacement / c->L;
  if (p->multiplier > 0) {
    bool both = p->multiplier < delta * (1 + delta) / 2;
    double t = delta * (a - b) / (1 - delta), s = both ? ((down - W) / eps + delta * a - t) / (1 + delta) : 0;
    CHECK_NEAR(v_mid, W + eps * (t + s), near);
    CHECK_NEAR(v_start, both ? down - eps * s : W + eps * (t - delta * a), near);
    CHECK_NEAR(p->multiplier, both ? delta * delta : delta, 8 * DBL_EPSILON);
    return both ? 2 : 1;
  }
  CHECK_NEAR(fmin(fabs(v_mid - U), fabs(v_start - held)), 0, near);
  if (U <= W) {
    CHECK_NEAR(v_mid, U, near);
    CHECK_NEAR(v_start, fmax(U - eps * delta * b, held), near);
    if (v_start >= down) /* held in the contraction as well it slides back by as much as it came */
      CHECK_NEAR(way, v_start > held + near ? U - eps * delta * b * b : 0, near);
  }
  return 0;
}

/* Every arithmetic agrees, also where l' jumps in one phase only. */
static void check_agreement(struct scallop_crawler c, double size)
{
  static const char *const texts[] = { "constant:0", "constant:0,0.125", "constant:0.25,0" };
  const struct unit unit = { size * c.L / c.T, size * c.L, c.T, 1 };
  for (int i = 0; i < 3; i++) {
    c.gait = gait_of_text(texts[i]).gait;
    const struct motion m = steady_motion(&c);
    agree(&m, &unit, &(struct allowed){ { 16 * DBL_EPSILON, 16 * ULP_LONG, 1e-28 } });
  }
}

/* What short ramps R change is of the order of R, as long as R is small beside what is left until there is an interval
 * of steady states. */
TEST(steady_states_by_hand)
{
  struct random r = { 2026112201 };
  int cases[3] = { 0 };
  for (int i = 0; i < CRAWLERS; i++) {
    double size;
    struct scallop_crawler c = next_crawler(&r, &size), ramps = c;
    double near = 16 * DBL_EPSILON * size, unit = c.L / c.T;
    struct scallop_period_result p = steady_of(&c).period;
    cases[check_by_hand(&c, &p, near)]++;
    if (i % 50 == 0)
      check_agreement(c, size);
    for (int k = 20; i % 5 == 0 && k <= 50; k += 10) {
      char text[40];
      snprintf(text, sizeof text, "constant:%.17g", ldexp(1, -k));
      ramps.gait = gait_of_text(text).gait;
      struct scallop_period_result q = steady_of(&ramps).period;
      CHECK_NEAR(q.v_start / unit, p.v_start / unit, near + 8 * ldexp(1, -k) * size);
      CHECK_NEAR(q.v_mid / unit, p.v_mid / unit, near + 8 * ldexp(1, -k) * size);
    }
  }
  print_message("held %d, sliding %d, both bodies turn %d\n", cases[0], cases[1], cases[2]);
  assert_true(cases[0] >= 5 && cases[1] >= 5 && cases[2] >= 5);
}

/* Where the steady states fill an interval: its ends, in L/T. Allowed: some ulp of the velocities that meet there */
static void interval_is(const struct scallop_crawler *c, double low, double high, int ulps, double size)
{
  struct scallop_steady_result s;
  struct scallop_wide_steady w;
  double unit = c->L / c->T, near = ulps * DBL_EPSILON * size, outside = (high - low) / 64;
  assert_int_equal(scallop_steady(c, &s), SCALLOP_INTERVAL);
  CHECK_NEAR(s.v_low / unit, low, near);
  CHECK_NEAR(s.v_high / unit, high, near);
  CHECK_EQUAL(s.period.v_start, fmin(fmax(0, s.v_low), s.v_high));
  CHECK_NEAR(s.period.balance, 0, DBL_EPSILON);
  for (int k = 1; k < 8; k++) {
    double v = (low + (high - low) * k / 8) * unit;
    CHECK_NEAR(period_of(c, v).v_end, v, near * unit);
  }
  assert_true(period_of(c, (high + outside) * unit).v_end < (high + outside) * unit);
  assert_true(period_of(c, (low - outside) * unit).v_end > (low - outside) * unit);
  assert_int_equal(scallop_wide_steady(SCALLOP_BINARY128, c, &w), SCALLOP_EDOMAIN);
}

/* The curves are at mu2/alpha, -mu1/alpha in extension (rate: eps delta) and at mu1/(1 - alpha), -mu2/(1 - alpha) in
 * contraction (rate: -eps delta). With F1 = F2 c stays where it is between all four. With alpha = 1/2 it goes by eps
 * delta/2 and back. */
TEST(equal_forces_or_phases)
{
  struct random r = { 21 };
  for (int n = 0; n < 2 * CRAWLERS; n++) {
    struct scallop_crawler c = random_crawler(&r, ORDINARY, &sawtooth_gait);
    double M = c.m1 + c.m2, mu1 = c.m1 / M, mu2 = c.m2 / M, a = c.alpha, b = 1 - c.alpha;
    if (n % 2 == 0) {
      double low = -fmin(mu1 / a, mu2 / b), high = fmin(mu2 / a, mu1 / b);
      c.F2 = c.F1;
      interval_is(&c, low, high, 8, fmax(-low, high) + crawler_eps(&c));
      continue;
    }
    c.alpha = 0.5;
    set_eps(&c, random_decades(&r, 1e-6, 2 * fmin(mu1, mu2)));
    double swing = 0.5 * crawler_eps(&c) * (c.F1 - c.F2) / (c.F1 + c.F2), room = 2 * fmin(mu1, mu2),
           low = -room - fmin(swing, 0), high = room - fmax(swing, 0);
    interval_is(&c, low, high, 8, fmax(-low, high) + crawler_eps(&c));
  }
}

/* (F1 - F2) alpha = (F1 + F2) (1 - alpha), where the longer phase gains in opposite motion what friction takes from
 * both bodies, which go forward, in the other. With eps = 1/4 and (F1 - F2)/(F1 + F2) = 3/5 c rises by 3/32 in the
 * extension, at most to m2/(M alpha) = 3/2, and begins to fall fast at m1/(M (1 - alpha)) = 1/6. */
TEST(what_one_phase_gains_the_other_takes)
{
  const struct scallop_crawler c = { 0.125, 1.875, 4, 1, 10, 1, 0.625, &sawtooth_gait }, d = exchanged(&c);
  double low = 1. / 6 + 0.25 * 0.375 - 3. / 32, high = 3. / 2 - 3. / 32;
  interval_is(&c, low, high, 16, 4.5);
  interval_is(&d, -high, -low, 16, 4.5);
}

/* l' = 9/8 for three quarters of a phase and then 5/8, with F1 = 4, F2 = 1, alpha = 3/4 and m1 = m2. Between the curves
 * 5/12 and 3/4 of the two speeds in extension both bodies go forward in the slow quarter, and friction takes there 2
 * (4/5) (3/4)/4 = 3/10: all of the drive (3/5)(2 alpha - 1), for every start. c goes up by 0.3375 eps, down by 0.1875
 * eps, and by 0.15 eps in the contraction. */
#define SPEED(from, to, anchored, sign, speed) \
  { \
    .begin = (from), .end = (to), .anchor = (anchored), .direction = (sign), .jump = true, .linear = true, \
    .velocity = (sign) * (speed), .curve = &scallop_curve_linear \
  }
#define TWO_SPEEDS(sign) SPEED(0, 0.75, SCALLOP_FROM_START, sign, 1.125), SPEED(0.25, 0, SCALLOP_FROM_END, sign, 0.625)

TEST(two_speeds)
{
  static const struct scallop_piece out[] = { TWO_SPEEDS(1) }, back[] = { TWO_SPEEDS(-1) };
  static const struct scallop_gait gait = {
    "two-speed", { { out, 2, 0, 0, 1.125, 1, false, false, false }, { back, 2, 0, 0, 1.125, -1, false, false, false } }
  };
  const struct scallop_crawler c = { 1, 1, 4, 1, 2560, 1, 0.75, &gait };
  double eps = 0x1p-10;
  interval_is(&c, 5. / 12 - 0.15 * eps, 0.75 - 0.3375 * eps, 8, 0.75 + eps);
}

static void check_undecided(const struct scallop_rational_crawler *c)
{
  const char *why = "";
  SCOPED(scallop_certified_steady, s);
  assert_int_equal(scallop_certified_steady(c, DIGITS, &s, &why), SCALLOP_EUNDECIDED);
  assert_non_null(strstr(why, "fill an interval"));
}

/* In balls all is exact. */
TEST(intervals_are_told)
{
  const struct scallop_crawler many[] = { { 1, 1, 2, 2, 8, 1, 0.5, &sawtooth_gait },
                                          { 1.5, 1, 2, 2, 10, 1, 0.7, &sawtooth_gait },
                                          { 1.5, 1, 4, 1, 10, 1, 0.5, &sawtooth_gait } };
  SCOPED(scallop_rational, c);
  for (int i = 0; i < 3; i++) {
    scallop_rational_of(&c, &many[i]);
    check_undecided(&c);
  }
}

/* The third condition holds for the decimals 0.006, 0.15 and 0.52, but not for the doubles nearest to them: of these
 * one end of the interval is the steady state, and the other end if alpha is an ulp less. What rounding takes away is
 * an interval all the same. */
TEST(an_interval_of_decimals_only)
{
  const struct scallop_crawler doubles = { 1.8, 0.105, 0.006, 0.15, 1.6, 1.4, 0.52, &sawtooth_gait };
  struct scallop_crawler same[] = { doubles, doubles }, away = doubles;
  struct scallop_steady_result s;
  SCOPED(scallop_certified_steady, exact);
  SCOPED(scallop_rational, c);
  same[1].alpha = nextafter(doubles.alpha, 0);
  for (int i = 0; i < 2; i++) {
    certify_steady(&exact, &same[i], 20);
    assert_int_equal(scallop_steady(&same[i], &s), SCALLOP_INTERVAL);
    CHECK_RELATIVE(s.v_low, -2.0216335727264866, 16 * DBL_EPSILON);
    CHECK_RELATIVE(s.v_high, -0.13123359580052493, 256 * DBL_EPSILON); /* a difference of numbers of size 2 */
    CHECK_RELATIVE(i == 0 ? s.v_low : s.v_high, middle(exact.v_start), 256 * DBL_EPSILON);
  }
  away.alpha += 64 * DBL_EPSILON;
  steady_of(&away);
  crawler_of_fractions(&c, "1.8 0.105 0.006 0.15 1.6 1.4 0.52", &sawtooth_gait);
  check_undecided(&c);
}

/* v_start is 0 exactly, and -2 L/T, and P(v) - v as well: that this is the only steady state is still shown from either
 * side of it. */
TEST(exactly_steady)
{
  const struct scallop_crawler crawlers[] = { { 5, 3, 3, 1, 0.125, 1, 0.75, &sawtooth_gait },
                                              { 1, 1, 4, 1, 10, 10, 0.75, &sawtooth_gait } };
  SCOPED(scallop_certified_steady, s);
  for (int i = 0; i < 2; i++) {
    certify_steady(&s, &crawlers[i], DIGITS);
    assert_true(arb_contains_si(s.v_start, i == 0 ? 0 : -2) && !arb_is_exact(s.v_start));
    assert_true(arb_is_zero(s.multiplier));
  }
}

/* With equal forces the centre of mass rests: no body turns where l' jumps to 0 from some other value, and nothing is
 * sheared. */
TEST(nothing_turns_at_the_end)
{
  const struct scallop_crawler c = { 1, 1, 2, 2, 8, 1, 0.5, &sawtooth_gait };
  SCOPED(scallop_certified_phase, p);
  for (int kind = 0; kind < 2; kind++) {
    certify_phase(&p, &c, kind, 0, DIGITS);
    assert_true(arb_is_zero(p.v_end) && arb_is_one(p.multiplier) && !p.switches);
  }
}
