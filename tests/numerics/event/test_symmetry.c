/* What must be true of any solver of this model, whatever the numbers: units, mirror images, exchanged bodies, a
 * monotone and nonexpansive period map with one fixed point.
 *
 * ULP below is DBL_EPSILON. Where two routes round differently the bound is BOUND ulp of the terms of what is solved.
 */
#include <float.h>

#include "tests/support/odd_gaits.h"
#include "tests/support/solved.h"

enum { BOUND = 8, CRAWLERS = 600 };
#define ULP DBL_EPSILON

static double velocity_unit(const struct scallop_crawler *c) { return c->L / c->T; }

/* What rounding does to a steady velocity, in units of a roundoff: it is itself rounded, and it is the root of the
 * balance, whose terms are of the size of (F1 - F2)/(F1 + F2) and, where the bodies change direction both ways, of
 * min(1, eps). */
static double steady_size(const struct scallop_crawler *c, const struct scallop_steady_result *s)
{
  double eps = crawler_eps(c), delta = fabs(c->F1 - c->F2) / (c->F1 + c->F2);
  double v = fmax(fabs(s->period.v_start), fabs(s->period.v_mid)), step = 1e-3 * fmax(v, eps * velocity_unit(c));
  double fall = period_of(c, s->period.v_start - step).balance - period_of(c, s->period.v_start + step).balance;
  return fmax(v, (delta + fmin(1, eps)) * 2 * step / fall);
}

/* The same for the displacement, the integral of velocities; where a body sticks, they follow l'. */
static double displacement_size(const struct scallop_crawler *c, const struct scallop_steady_result *s)
{
  return c->T * steady_size(c, s) + (s->period.regime == SCALLOP_SLIDING ? 0 : c->L);
}

static struct scallop_crawler under_test;

static void name_the_culprit(void) { print_crawler(&under_test); }

typedef void crawler_test(struct random *r, const struct scallop_crawler *c);

/* Every family and every gait with a continuous l'; `odd`: also gaits that rest within a phase, or go
 * back, or whose l' jumps */
static void for_crawlers(uint64_t seed, int count, bool odd, crawler_test *test)
{
  static const struct scallop_gait *const gaits[] = { &pause_gait, &wait_gait, &hesitant_gait, &there_and_back_gait,
                                                      &sawtooth_gait };
  struct random r = { seed };
  check_failed = name_the_culprit;
  for (int family = 0; family < FAMILIES + odd; family++)
    for (int n = 0; n < check_cases(count); n++) {
      under_test = family < FAMILIES ? random_crawler(&r, (enum family)family, every_gait[n % SMOOTH_GAITS])
                                     : random_crawler(&r, n % 2 ? ORDINARY : STICK_SLIP, gaits[n / 2 % 5]);
      test(&r, &under_test);
    }
  check_failed = NULL;
}

/* The same crawler in other units, in a mirror, with the bodies exchanged, or with the phases exchanged as well */
struct view {
  struct scallop_crawler crawler;
  double velocity, length, time;
  bool bodies, phases;
};

/* A phase is the same to the last digit, */
static void same_phase(const struct view *v, const struct scallop_phase_result *a, const struct scallop_phase_result *b)
{
  int sign = v->velocity < 0 ? -1 : 1;
  CHECK_EQUAL(b->t1, a->t1 * v->time);
  CHECK_EQUAL(b->dT, a->dT * v->time);
  CHECK_EQUAL(b->v_end, a->v_end * v->velocity);
  CHECK_EQUAL(b->dx1, (v->bodies ? a->dx2 : a->dx1) * v->length);
  CHECK_EQUAL(b->dx2, (v->bodies ? a->dx1 : a->dx2) * v->length);
  CHECK_EQUAL(b->dxC, a->dxC * v->length);
  assert_true(a->modes.count == b->modes.count && a->regime == b->regime);
  for (int i = 0; i < a->modes.count && i < SCALLOP_MODES_KEPT; i++) {
    const struct scallop_mode was = a->modes.kept[i], is = b->modes.kept[i];
    assert_true(is.s1 == sign * (v->bodies ? was.s2 : was.s1) && is.s2 == sign * (v->bodies ? was.s1 : was.s2));
  }
}

/* and so is the steady state in units of powers of two. */
static void same_crawler(const struct view *v, const struct scallop_crawler *c, double v0)
{
  for (int kind = 0; kind < 2; kind++) {
    struct scallop_phase_result a = phase_of(c, kind, v0),
                                b = phase_of(&v->crawler, v->phases ? 1 - kind : kind, v0 * v->velocity);
    same_phase(v, &a, &b);
  }
  struct scallop_steady_result a = steady_of(c), b = steady_of(&v->crawler);
  double near = v->bodies ? BOUND * ULP : 0;
  CHECK_NEAR(v->phases ? b.period.v_mid : b.period.v_start, a.period.v_start * v->velocity, near * steady_size(c, &a));
  CHECK_NEAR(b.period.displacement, a.period.displacement * v->length, near * displacement_size(c, &a));
  if (v->bodies)
    return;
  CHECK_EQUAL(b.froude, a.froude);
  CHECK_EQUAL(b.mean_velocity, a.mean_velocity * v->velocity);
  CHECK_EQUAL(b.v_low, a.v_low * v->velocity);
  CHECK_EQUAL(b.period.v_mid, a.period.v_mid * v->velocity);
  CHECK_EQUAL(b.period.multiplier, a.period.multiplier);
  CHECK_EQUAL(b.period.balance, a.period.balance);
}

static void in_binary_units(struct random *r, const struct scallop_crawler *c)
{
  struct units u = { ldexp(1, random_below(r, 41) - 20), ldexp(1, random_below(r, 41) - 20),
                     ldexp(1, random_below(r, 41) - 20) };
  const struct view v = { in_units(c, &u), u.length / u.time, u.length, u.time, false, false };
  same_crawler(&v, c, random_start(r, c, SCALLOP_EXTENSION));
}

/* x -> -x makes body 1 of body 2; l stays. Negation rounds nothing. */
static void mirrored(struct random *r, const struct scallop_crawler *c)
{
  const struct view v = { exchanged(c), -1, -1, 1, true, false };
  same_crawler(&v, c, random_start(r, c, SCALLOP_CONTRACTION));
}

/* Calling body 1 body 2 turns an extension into a contraction: l' -> -l'. A gait whose phases are not each other's
 * mirror image is another one then. */
static void relabelled(struct random *r, const struct scallop_crawler *given)
{
  struct scallop_crawler c = *given;
  c.alpha = (1 + random_below(r, 1023)) / 1024.; /* 1 - alpha is exact */
  struct view v = { exchanged(&c), 1, 1, 1, true, true };
  v.crawler.alpha = 1 - c.alpha;
  if (c.gait != &hesitant_gait)
    same_crawler(&v, &c, random_start(r, &c, SCALLOP_EXTENSION));
}

TEST(units_of_powers_of_two) { for_crawlers(11, CRAWLERS, true, in_binary_units); }
TEST(mirror_image) { for_crawlers(13, CRAWLERS, true, mirrored); }
TEST(bodies_exchanged) { for_crawlers(14, CRAWLERS, true, relabelled); }

static double largest_velocity(const struct scallop_crawler *c, double v0)
{
  return fmax(fabs(v0), 2 * c->gait->phase[0].peak * c->L / (c->T * fmin(c->alpha, 1 - c->alpha)));
}

static void map_is_monotone_and_nonexpansive(struct random *r, const struct scallop_crawler *c)
{
  double a = random_start(r, c, SCALLOP_EXTENSION), b = random_start(r, c, SCALLOP_CONTRACTION);
  double noise = BOUND * ULP * largest_velocity(c, fmax(fabs(a), fabs(b)));
  double apart = fabs(b - a), after = (b > a ? 1 : -1) * (period_of(c, b).v_end - period_of(c, a).v_end);
  CHECK_AT_MOST(-after, noise);
  CHECK_AT_MOST(after, apart + noise);
}

static long differences, sharp_differences;

/* The balance carries (P(v) - v)/eps without cancellation, so it is what is differenced. The difference lies between
 * the derivatives within the step; where these differ, at a kink, the check is weak, hence the count. */
static void multiplier_is_the_derivative(struct random *r, const struct scallop_crawler *c)
{
  double v0 = random_start(r, c, SCALLOP_EXTENSION), unit = velocity_unit(c), eps = crawler_eps(c);
  double step = 1e-5 * fmax(fabs(v0), eps * unit), spread = 0;
  v0 += copysign(3 * step, v0); /* off the kink at 0 */
  struct scallop_period_result at = period_of(c, v0), end = period_of(c, v0 + step);
  double slope = (end.balance - at.balance) / ((v0 + step - v0) / unit);
  for (int k = 1; k <= 4; k++)
    spread = fmax(spread, fabs(period_of(c, v0 + step * k / 4).multiplier - at.multiplier) / eps);
  double terms = 1 + fabs(slope) * largest_velocity(c, v0) / unit; /* what a rounding of c does to the balance */
  double noise = BOUND * ULP * (terms * unit / step + 1 / eps);
  CHECK_NEAR((at.multiplier - 1) / eps, slope, 2 * spread + noise);
  assert_true(at.multiplier >= 0 && at.multiplier <= 1);
  differences++;
  sharp_differences += 2 * spread + noise < 1e-3 * fmax(1, 1e-3 / eps);
}

TEST(period_map) { for_crawlers(15, CRAWLERS, true, map_is_monotone_and_nonexpansive); }

TEST(multiplier)
{
  for_crawlers(16, CRAWLERS, false, multiplier_is_the_derivative);
  print_message("%ld of %ld differences sharp\n", sharp_differences, differences);
  assert_true(sharp_differences > differences / 2);
}

/* At a kink: m1 = m2, F1 = F2, eps of the phase 1/16, the start such that the rear body comes to rest for an instant at
 * the middle of the extension, where l' peaks. To the right it never turns back. */
TEST(multiplier_at_grazing_is_the_right_one)
{
  struct scallop_crawler c = { 1, 1, 0.25, 0.25, 1, 1, 0.5, &scallop_gait_quadratic };
  double v0 = 2.0625, step = 0x1p-12;
  struct scallop_period_result at = period_of(&c, v0), right = period_of(&c, v0 + step);
  CHECK_NEAR(at.multiplier, (right.v_end - at.v_end) / step, 64 * ULP / step);
}

static long solved, shortened, other_modes;

/* By the walk from event to event, whichever way it was found */
static void steady_is_a_fixed_point(struct random *r, const struct scallop_crawler *c)
{
  (void)r;
  const struct scallop_gait gait = walked_gait(c->gait);
  struct scallop_crawler walks = *c;
  walks.gait = &gait;
  struct scallop_steady_result s = steady_of(c);
  const struct scallop_period_result *p = &s.period;
  double v = fmax(fabs(p->v_start), fabs(p->v_mid)), eps = crawler_eps(c);
  solved++;
  shortened += s.work.periods == 1;
  /* the balance changes sign within BOUND ulp of v_start, however steep it is there */
  struct scallop_period_result below = period_of(&walks, p->v_start - BOUND * ULP * v),
                               above = period_of(&walks, p->v_start + BOUND * ULP * v);
  CHECK_AT_MOST(-below.balance, BOUND * ULP);
  CHECK_AT_MOST(above.balance, BOUND * ULP);
  double fall = below.balance - above.balance;
  if (!(fall > 1e-3)) /* else a plateau of l': a rounding of v decides on much of the phase */
    CHECK_NEAR(p->balance, 0, fall + BOUND * ULP);
  /* c is rounded to a curve at every change of mode */
  int rounded = 1 + p->modes[0].count + p->modes[1].count;
  CHECK_NEAR(p->v_end, p->v_start, rounded * BOUND * ULP * fmax(v, eps * velocity_unit(c)));
  assert_true(s.v_low == p->v_start && s.v_high == p->v_start);
  CHECK_RELATIVE(s.froude, 1 / eps, BOUND * ULP);
  CHECK_RELATIVE(s.mean_velocity, p->displacement / c->T, BOUND * ULP);
  /* the same operations both ways, so that no condition number comes in, unless they are contracted
   * (tests/support/check.h) */
  struct scallop_period_result again = period_of(c, p->v_start), walked = period_of(&walks, p->v_start);
  CHECK_NEAR(again.v_mid, p->v_mid, BOUND * ULP * v);
  CHECK_NEAR(again.displacement, p->displacement, (BOUND * ULP + SAME_BITS) * (v * c->T + fabs(p->displacement)));
  CHECK_NEAR(walked.v_mid, p->v_mid, BOUND * ULP * fmax(v, velocity_unit(c)));
  if (s.work.periods != 1)
    return;
  if (modes_alike(&walked.modes[0], &p->modes[0]) && modes_alike(&walked.modes[1], &p->modes[1])) {
    CHECK_NEAR(walked.multiplier, p->multiplier, 64 * ULP);
    assert_int_equal(walked.regime, p->regime);
  } else
    other_modes++; /* c lies on a plateau of |l'|: every motion near it is another */
}

/* Whatever the start, the iteration of the map ends there: uniqueness, and the map and the balance agree. n is such
 * that multiplier^n is below an ulp. */
static void steady_is_reached(struct random *r, const struct scallop_crawler *given)
{
  struct scallop_crawler c = *given;
  c.alpha = fmin(fmax(c.alpha, 0.02), 0.98);
  set_eps(&c, random_decades(r, 0.3, 60));
  struct scallop_steady_result s = steady_of(&c);
  double far = 1.5 * largest_velocity(&c, 0) + crawler_eps(&c) * velocity_unit(&c);
  const double starts[] = { 0, -far, far, random_between(r, -far, far) };
  double settled = 1 - s.period.multiplier;
  for (int k = 0; k < 4; k++) {
    double v = starts[k];
    long limit = 2000 + (long)(40 / settled), n = 0;
    bool at_rest = false; /* but for a velocity that scaling will soon refuse, as too small to keep its digits */
    for (double old = INFINITY; n < limit && v != old && !at_rest; n++) {
      old = v;
      v = period_of(&c, v).v_end;
      at_rest = v != 0 && fabs(v) < 1e-300 * far;
    }
    CHECK_NEAR(v, s.period.v_start, BOUND * ULP * largest_velocity(&c, 0) / settled);
  }
}

/* alpha = 1/2: half a period later all is reversed, v(t + T/2) = -v(t). F1 = F2: c = 0 solves it. */
static void symmetric_goes_nowhere(struct random *r, const struct scallop_crawler *given)
{
  (void)r;
  struct scallop_crawler c = *given;
  c.alpha = 0.5;
  struct scallop_steady_result s = steady_of(&c);
  CHECK_NEAR(s.period.v_mid, -s.period.v_start, BOUND * ULP * steady_size(&c, &s));
  CHECK_NEAR(s.period.displacement, 0, BOUND * ULP * displacement_size(&c, &s));
  c = *given;
  c.F2 = c.F1;
  s = steady_of(&c);
  assert_true(s.period.v_start == 0 && s.period.v_mid == 0 && s.period.displacement == 0);
  assert_int_equal(s.period.regime, SCALLOP_SLIDING);
}

TEST(fixed_point)
{
  for_crawlers(18, CRAWLERS, false, steady_is_a_fixed_point);
  print_message("%ld of %ld by a short cut, %ld with other modes than the walk\n", shortened, solved, other_modes);
  assert_true(shortened > solved / 4 && other_modes <= shortened / 400);
}
TEST(reached_from_anywhere) { for_crawlers(19, CRAWLERS / 2, false, steady_is_reached); }
TEST(no_displacement) { for_crawlers(20, CRAWLERS, false, symmetric_goes_nowhere); }

/* Where a root finder that keeps its bracket badly has gone wrong: Newton's method jumps between the two ends of the
 * bracket (the balance is piecewise linear), or is thrown off a root it has found. */
TEST(awkward_fixed_points)
{
  const struct scallop_crawler awkward[] = {
    { 0.8600653530882657, 0.091638556541162694, 0.14221223671773683, 0.6712699065680231, 15.404457108972549,
      1.6337619364041711, 0.64779187280096906, &trapezoid_gait },
    { 2.0207504562843486, 0.24696599292836602, 1.4616632709221586, 4.8513944284664561, 10.847848234780091,
      0.00018661733411097476, 0.757337499771089, &trapezoid_gait },
    { 1.005555104355869, 0.34464279269686077, 0.20340021387305435, 1.9351561748532251, 6.2489810736853961,
      0.00042542337761461294, 0.13370486197499587, &scallop_gait_sinusoidal },
  };
  check_failed = name_the_culprit;
  for (size_t k = 0; k < sizeof awkward / sizeof *awkward; k++) {
    under_test = awkward[k];
    steady_is_a_fixed_point(NULL, &under_test);
  }
  check_failed = NULL;
}
