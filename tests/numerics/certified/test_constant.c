/* The gait constant:R. With R = 0, l' constant out and back, all is known in closed form (docs/background/theory.md),
 * and is what R -> 0 tends to. */
#include <float.h>

#include "compare/points/gaits.h"
#include "numerics/wide/wide.h"
#include "tests/support/certified_balls.h"
#include "tests/support/random_crawler.h"
#include "tests/support/solved.h"

enum { CRAWLERS = 1500, DIGITS = 40 };

static const struct scallop_gait *gait_of(const char *text)
{
  const struct scallop_gait *gait = gait_of_text(text).gait;
  assert_non_null(gait);
  return gait;
}

/* A crawler in units of L, T and (F1 + F2)/M, with F1 > F2 and the extension the longer phase: others are seen in a
 * mirror (velocities change their sign, the bodies their names) and with the phases and the bodies exchanged. */
struct model {
  long double a, b, eps, delta; /* fractions of the period; (F1 - F2)/(F1 + F2)                                     */
  long double U, W, lower[2];   /* where the rear body turns in the extension and in the contraction; the front body */
  bool mirrored, exchanged;
};

static struct model model_of(const struct scallop_crawler *c)
{
  struct model m;
  long double M = (long double)c->m1 + c->m2, F = (long double)c->F1 + c->F2, mu1 = c->m1 / M, mu2 = c->m2 / M;
  bool back = c->F1 < c->F2, shorter = c->alpha < 0.5;
  m.a = shorter ? 1 - (long double)c->alpha : c->alpha;
  m.b = shorter ? c->alpha : 1 - (long double)c->alpha;
  m.eps = (long double)c->T * c->T * F / (M * c->L);
  m.delta = fabsl((long double)c->F1 - c->F2) / F;
  m.mirrored = back != shorter; /* with the phases exchanged the bodies are, and F1 - F2 has another sign */
  m.exchanged = shorter;
  long double heavy = back ? mu1 : mu2; /* the share of the body with less friction */
  m.U = heavy / m.a;
  m.W = (1 - heavy) / m.b;
  m.lower[0] = -(1 - heavy) / m.a;
  m.lower[1] = -heavy / m.b;
  return m;
}

/* From c0, falling with eps to `above`, with eps delta from there on to `stop`, where it stays */
static long double falls(const struct model *m, long double c0, long double above, long double stop, long double time)
{
  long double first = c0 > above ? fminl((c0 - above) / m->eps, time) : 0;
  if (c0 < stop)
    return fminl(stop, c0 + m->eps * time);
  return fmaxl(stop, c0 - m->eps * first - m->eps * m->delta * (time - first));
}

static long double extension(const struct model *m, long double c0)
{
  return -falls(m, -c0, -m->lower[0], -m->U, m->a);
}
static long double contraction(const struct model *m, long double c0) { return falls(m, c0, m->W, m->lower[1], m->b); }

struct steady {
  long double v_start, v_mid, multiplier;
};

/* The cases of docs/background/theory.md, for 0 < delta < 1 and a > b */
static struct steady steady_by_hand(const struct model *m)
{
  long double start = contraction(m, m->U), k = m->delta * (m->a - m->b) / (1 - m->delta);
  if (extension(m, start) >= m->U) /* body 1 is held at the end of the extension */
    return (struct steady){ start, m->U, 0 };
  start = m->lower[1];
  if (contraction(m, extension(m, start)) <= start) /* and here at the end of the contraction */
    return (struct steady){ start, extension(m, start), 0 };
  long double mid = m->W + m->eps * k, slope = m->delta;
  start = mid - m->eps * m->delta * m->a;
  if (start < m->lower[0]) { /* body 2 turns in the extension, too: after s */
    long double s = ((m->lower[0] - m->W) / m->eps + m->delta * m->a - k) / (1 + m->delta);
    start = m->lower[0] - m->eps * s;
    mid = m->W + m->eps * (k + s);
    slope *= m->delta;
  }
  return (struct steady){ start, mid, slope };
}

static struct steady steady_of_model(const struct model *m)
{
  struct steady s = steady_by_hand(m), given = s;
  if (m->exchanged) {
    s.v_start = given.v_mid;
    s.v_mid = given.v_start;
  }
  if (m->mirrored) {
    s.v_start = -s.v_start;
    s.v_mid = -s.v_mid;
  }
  return s;
}

static struct scallop_crawler next_crawler(struct random *r, const struct scallop_gait *gait)
{
  static const enum family families[] = { ORDINARY, STICK_SLIP, SMALL_PERIOD };
  struct scallop_crawler c;
  do
    c = random_crawler(r, families[random_below(r, 3)], gait);
  while (fabs(c.F1 - c.F2) > 0.9 * (c.F1 + c.F2) || fabs(c.F1 - c.F2) < 1e-3 * (c.F1 + c.F2)
         || fabs(c.alpha - 0.5) < 1e-3);
  return c;
}

static double size_of(const struct model *m) { return (double)(m->U + m->W - m->lower[0] - m->lower[1] + m->eps); }

TEST(steady_states_by_hand)
{
  struct random r = { 2026112201 };
  int seen[4] = { 0 };
  for (int i = 0; i < CRAWLERS; i++) {
    struct scallop_crawler c = next_crawler(&r, gait_of("constant:0"));
    struct model m = model_of(&c);
    struct steady hand = steady_of_model(&m);
    struct scallop_steady_result s;
    assert_int_equal(scallop_steady(&c, &s), SCALLOP_OK);
    double unit = c.L / c.T, allowed = 16 * DBL_EPSILON * size_of(&m) / (1 - (double)m.delta);
    CHECK_NEAR(s.period.v_start / unit, (double)hand.v_start, allowed);
    CHECK_NEAR(s.period.v_mid / unit, (double)hand.v_mid, allowed);
    CHECK_NEAR(s.period.multiplier, (double)hand.multiplier, 8 * DBL_EPSILON);
    bool both = hand.multiplier == 0 && steady_by_hand(&m).v_mid == m.U && steady_by_hand(&m).v_start == m.lower[1];
    if (both && m.U <= m.W
        && m.lower[1] >= m.lower[0]) /* body 1 is held in both phases: it goes back as far as it came */
      assert_true(s.period.displacement == 0);
    if (hand.multiplier == 0 && m.U <= m.W && !both) { /* L (m2/(M a) - eps delta b^2) */
      long double way = m.U * (m.a + m.b) - m.eps * m.delta * m.b * m.b;
      if (steady_by_hand(&m).v_mid == m.U && steady_by_hand(&m).v_start >= m.lower[0])
        CHECK_NEAR(fabs(s.period.displacement) / c.L, (double)fabsl(way), allowed);
    }
    seen[both ? 3 : hand.multiplier == 0 ? 0 : hand.multiplier == m.delta ? 1 : 2]++;
  }
  for (int i = 0; i < 4; i++)
    if (seen[i] < 5)
      fail_msg("case %d was seen %d times", i, seen[i]);
  print_message("held %d, sliding %d, both bodies turn %d, held in both phases %d\n", seen[0], seen[1], seen[2],
                seen[3]);
}

/* What R changes is of the order of R, as long as R is small beside what is left until there is an interval of steady
 * states. */
TEST(short_ramps_tend_to_none)
{
  struct random r = { 2026112202 };
  for (int i = 0; i < CRAWLERS / 5; i++) {
    struct scallop_crawler c = next_crawler(&r, gait_of("constant:0"));
    struct model m = model_of(&c);
    struct steady hand = steady_of_model(&m);
    for (int k = 20; k <= 50; k += 10) {
      char text[40];
      snprintf(text, sizeof text, "constant:%.17g", ldexp(1, -k));
      c.gait = gait_of(text);
      double allowed = (8 * ldexp(1, -k) + 16 * DBL_EPSILON) * size_of(&m) / (1 - (double)m.delta);
      struct scallop_steady_result s = steady_of(&c);
      CHECK_NEAR(s.period.v_start * c.T / c.L, (double)hand.v_start, allowed);
      CHECK_NEAR(s.period.v_mid * c.T / c.L, (double)hand.v_mid, allowed);
    }
  }
}

/* Where the steady states fill an interval: F1 = F2; alpha = 1/2; (F1 - F2) alpha = (F1 + F2) (1 - alpha), where the
 * longer phase gains in opposite motion what friction takes from both bodies, which go forward, in the other. The ends
 * of that one by hand, in L/T: eps b under the line in the contraction at W, and U in the extension. */
TEST(intervals)
{
  const struct scallop_gait *gait = gait_of("constant:0");
  const struct scallop_crawler many[] = { { 1, 1, 2, 2, 8, 1, 0.5, gait }, /* in balls all is exact */
                                          { 1.5, 1, 2, 2, 10, 1, 0.7, gait },
                                          { 1.5, 1, 4, 1, 10, 1, 0.5, gait },
                                          { 0.125, 1.875, 4, 1, 10, 1, 0.625, gait },
                                          { 1.875, 0.125, 1, 4, 10, 1, 0.625, gait } };
  for (int i = 0; i < 5; i++) {
    const struct scallop_crawler *c = &many[i];
    struct scallop_steady_result s;
    struct scallop_wide_steady w;
    const char *why = "";
    SCOPED(scallop_certified_steady, exact);
    assert_int_equal(scallop_steady(c, &s), SCALLOP_INTERVAL);
    assert_true(s.v_low < s.v_high);
    assert_int_equal(scallop_wide_steady(SCALLOP_BINARY128, c, &w), SCALLOP_EDOMAIN);
    if (i < 3) {
      SCOPED(scallop_rational, fractions);
      scallop_rational_of(&fractions, c);
      assert_int_equal(scallop_certified_steady(&fractions, DIGITS, &exact, &why), SCALLOP_EUNDECIDED);
      assert_non_null(strstr(why, "fill an interval"));
    }
    if (i >= 3) {
      struct model m = model_of(c);
      double sign = i == 3 ? 1 : -1, rise = (double)(m.eps * m.delta * m.a), low = (double)(m.W + m.eps * m.b) - rise,
             high = (double)m.U - rise, unit = c->L / c->T;
      CHECK_NEAR((i == 3 ? s.v_low : -s.v_high) / unit, low, 16 * DBL_EPSILON * size_of(&m));
      CHECK_NEAR((i == 3 ? s.v_high : -s.v_low) / unit, high, 16 * DBL_EPSILON * size_of(&m));
      CHECK_NEAR(period_of(c, sign * (low + high) / 2 * unit).v_end, sign * (low + high) / 2 * unit,
                 16 * DBL_EPSILON * size_of(&m) * unit);
    }
  }
}

/* The third condition holds for the decimals 0.006, 0.15 and 0.52, but not for the doubles nearest to them: of these
 * one end of the interval is the steady state, and the other end if alpha is an ulp less. What rounding takes away is
 * an interval all the same. */
TEST(an_interval_of_decimals_only)
{
  const struct scallop_crawler doubles = { 1.8, 0.105, 0.006, 0.15, 1.6, 1.4, 0.52, gait_of("constant:0") };
  struct scallop_crawler moved = doubles, away = doubles;
  const struct scallop_crawler *const same[] = { &doubles, &moved };
  const char *why = "";
  struct scallop_steady_result s;
  SCOPED(scallop_certified_steady, exact);
  SCOPED(scallop_rational, decimals);
  moved.alpha = nextafter(moved.alpha, 0);
  for (int i = 0; i < 2; i++) {
    certify_steady(&exact, same[i], 20);
    assert_int_equal(scallop_steady(same[i], &s), SCALLOP_INTERVAL);
    CHECK_RELATIVE(s.v_low, -2.0216335727264866, 16 * DBL_EPSILON);
    CHECK_RELATIVE(s.v_high, -0.13123359580052493, 256 * DBL_EPSILON); /* a difference of numbers of size 2 */
    CHECK_RELATIVE(i == 0 ? s.v_low : s.v_high, middle(exact.v_start), 256 * DBL_EPSILON);
  }
  away.alpha += 64 * DBL_EPSILON;
  assert_int_equal(scallop_steady(&away, &s), SCALLOP_OK);
  scallop_rational_of(&decimals, &doubles);
  assert_true(scallop_rational_parse(decimals.m1, "1.8") && scallop_rational_parse(decimals.m2, "0.105")
              && scallop_rational_parse(decimals.F1, "0.006") && scallop_rational_parse(decimals.F2, "0.15")
              && scallop_rational_parse(decimals.L, "1.6") && scallop_rational_parse(decimals.T, "1.4")
              && scallop_rational_parse(decimals.alpha, "0.52"));
  assert_int_equal(scallop_certified_steady(&decimals, 20, &exact, &why), SCALLOP_EUNDECIDED);
  assert_non_null(strstr(why, "fill an interval"));
}

/* v_start is 0 exactly, and -2 L/T, and P(v) - v as well: that this is the only steady state is still shown from either
 * side of it. */
TEST(exactly_steady)
{
  const struct scallop_gait *gait = gait_of("constant:0");
  const struct scallop_crawler crawlers[] = { { 5, 3, 3, 1, 0.125, 1, 0.75, gait },
                                              { 1, 1, 4, 1, 10, 10, 0.75, gait } };
  for (int i = 0; i < 2; i++) {
    SCOPED(scallop_certified_steady, s);
    certify_steady(&s, &crawlers[i], DIGITS);
    assert_true(arb_contains_si(s.v_start, i == 0 ? 0 : -2) && !arb_is_exact(s.v_start));
    assert_true(arb_is_zero(s.multiplier));
  }
}

/* With equal forces the centre of mass rests: no body turns where l' jumps to 0 from some other value, and nothing is
 * sheared. */
TEST(nothing_turns_at_the_end)
{
  const struct scallop_crawler c = { 1, 1, 2, 2, 8, 1, 0.5, gait_of("constant:0") };
  for (int kind = 0; kind < 2; kind++) {
    SCOPED(scallop_certified_phase, p);
    certify_phase(&p, &c, kind, 0, DIGITS);
    assert_true(arb_is_zero(p.v_end) && arb_is_one(p.multiplier) && !p.switches);
  }
}
