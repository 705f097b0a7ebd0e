/* At the edge between two sequences of modes a line just touches a curve. The start velocity is bisected to
 * the last digit of such edges, and the phase solved on both sides and around: each ends, and v_end is
 * continuous across the edge, because the map never drives two motions apart. */
#include "tests/support/odd_gaits.h"
#include "tests/support/random_crawler.h"
#include "tests/support/solved.h"

enum { CRAWLERS = 150, SCAN = 24, AROUND = 8 };

static int edges;

static void around_edge(const struct scallop_crawler *c, enum scallop_phase_kind kind, double low, double high)
{
  struct scallop_phase_result below = phase_of(c, kind, low);
  for (double mid; (mid = low + (high - low) / 2) > low && mid < high && fabs(mid) >= 1e-290;) {
    struct scallop_phase_result r = phase_of(c, kind, mid);
    *(modes_alike(&r.modes, &below.modes) ? &low : &high) = mid;
  }
  edges++;
  if (fabs(low) < 1e-290 || fabs(high) < 1e-290) /* at rest: beside it are only denormal numbers */
    return;
  double v = low, unit = c->L / scallop_phase_duration(c, kind);
  double before = phase_of(c, kind, v).v_end;
  for (int k = 0; k < AROUND; k++)
    v = nextafter(v, -INFINITY);
  for (int k = 0; k < 2 * AROUND; k++, v = nextafter(v, INFINITY)) {
    /* 2 AROUND ulp of v0, and a few roundings of velocities of the size of l' */
    CHECK_NEAR(phase_of(c, kind, v).v_end, before, (2 * AROUND * fabs(v) + 64 * unit) * 0x1p-52);
  }
}

TEST(every_edge)
{
  struct random r = { 31 };
  for (int n = 0; n < CRAWLERS; n++) {
    struct scallop_crawler c = random_crawler(&r, n % 2 ? STICK_SLIP : ORDINARY, every_gait[n % SMOOTH_GAITS]);
    enum scallop_phase_kind kind = n / SMOOTH_GAITS % 2 ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION;
    double most = 2.2 * c.L / scallop_phase_duration(&c, kind), last = -most;
    struct scallop_phase_result before = phase_of(&c, kind, last);
    for (int k = 1; k <= SCAN; k++) {
      double v = -most + 2 * most * k / SCAN;
      struct scallop_phase_result here = phase_of(&c, kind, v);
      if (!modes_alike(&here.modes, &before.modes))
        around_edge(&c, kind, last, v);
      before = here;
      last = v;
    }
  }
  print_message("%d edges\n", edges);
  assert_true(edges > CRAWLERS);
}

/* This one did not end: the line touches the curve at the very time from which friction can hold the body. */
TEST(touches_where_it_is_held)
{
  struct scallop_crawler c = { 0x1.49c2df9c1169bp+1, 0x1.78116d2fc8bbcp-1,    0x1.3305d4310c97ep+8,
                               0x1.7a4c877234cdap+7, 0x1.5ac4f07b010d9p+3,    0x1.0a883a7556ce8p+0,
                               0x1.9a4765770dcfap-3, &scallop_gait_sinusoidal };
  struct scallop_phase_result r = phase_of(&c, SCALLOP_EXTENSION, 0x1.0237f030f73d5p+5);
  modes_are(&r.modes, "++ -+ 0+ ++");
}

/* Body 1 comes to rest against a friction that stops it in less time than an ulp of the phase: it is held from then on,
 * and was once found to slide on for a twelfth of the phase. */
TEST(stops_at_once)
{
  struct scallop_crawler c = { 1.6810482026957038e-09, 19782534.230478894,  231.11260285226103, 0.13007378432978592, 1,
                               66095444.255873002,     0.66363254363346347, &minimum_jerk_gait };
  struct scallop_phase_result r = phase_of(&c, SCALLOP_EXTENSION, -3.302e-10);
  modes_are(&r.modes, "-- 0+");
  CHECK_NEAR(r.dx1, 0, 1e-14);
}

/* m1 = m2 = 1, tau = 1, L = 1: l' = 0 at t = 3/4, where both bodies, which go backward at -12 + 16 t -+ l'/2, come to
 * rest at once. */
TEST(stops_where_the_length_turns)
{
  struct scallop_crawler c = { 1, 1, 20, 12, 1, 2, 0.5, &there_and_back_gait };
  struct scallop_phase_result r = phase_of(&c, SCALLOP_EXTENSION, -12);
  modes_are(&r.modes, "-- +- 0-");
  CHECK_EQUAL(r.t1, 0.75);
  CHECK_EQUAL(r.v_end, 0);
  CHECK_EQUAL(r.dx1, -4.5 - 1.125 / 2); /* and then it is held, while l falls by 1/8 */
  CHECK_EQUAL(r.dx2, -4.5 + 1.125 / 2 - 0.125);
}

/* m1 = m2 = 1, tau = 1, L = 1, F1 - F2 = 6: body 1 is held while l'' = 5, lets go for 1/32 where l'' = 8, at an
 * acceleration of -1, and comes back as fast where l'' = 4. Each piece is straight. */
#define BUMP_END (9. / 32 + 67. / 560)
#define BUMP_FALL ((1.5 + 4 * 67. / 560) / (1 - BUMP_END))
#define BUMP(sign) \
  RUN(0, 0.25, sign, 0, (sign)*5), RUN(0.25, 9. / 32, sign, (sign) * -0.75, (sign)*8), \
      RUN(9. / 32, BUMP_END, sign, (sign)*0.375, (sign)*4), \
      RUN(BUMP_END, 0.75, sign, (sign)*BUMP_FALL, (sign) * -BUMP_FALL), \
      SCALLOP_RAMP(0.25, 0, SCALLOP_FROM_END, sign, (sign) * -BUMP_FALL)

TEST(lets_go_for_a_while)
{
  static const struct scallop_piece out[] = { BUMP(1) }, back[] = { BUMP(-1) };
  static const struct scallop_gait bump = { "bump",
                                            { { out, 5, 5, -BUMP_FALL, 2, 1, false, false, false },
                                              { back, 5, -5, BUMP_FALL, 2, -1, false, false, false } } };
  struct scallop_crawler c = { 1, 1, 7, 1, 1, 2, 0.5, &bump };
  struct scallop_phase_result r = phase_of(&c, SCALLOP_EXTENSION, 0);
  modes_are(&r.modes, "0+ -+ 0+");
  CHECK_EQUAL(r.t1, 0.25);
  CHECK_EQUAL(r.dx1, -0x1p-10);
  CHECK_EQUAL(r.v_end, 0);
}

/* Forces so weak that the square of a velocity is nothing: a phase is the first half of the period all the same. */
TEST(weak_forces)
{
  static const struct {
    struct scallop_crawler crawler;
    double v0, v_mid;
  } cases[] = {
    { { 36.626869277420411, 2.3911884071309298e-05, 709.08612760092365, 2.9961505568387519e-06, 0.61207812813796758,
        6.5952214710378513e-76, 2.8529183881134063e-06, &scallop_gait_sinusoidal },
      1.8867979468063009e-80,
      5.529e-80 },
    { { 1.1043461739757818e-06, 174.32928666529079, 1365.612623937154, 10935.025825297991, 0.24579963240708735,
        7.5062844931743244e-81, 0.21028367271181539, &scallop_gait_sinusoidal },
      0,
      -8.66e-80 },
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    struct scallop_phase_result r = phase_of(&cases[i].crawler, SCALLOP_EXTENSION, cases[i].v0);
    struct scallop_period_result p = period_of(&cases[i].crawler, cases[i].v0);
    CHECK_NEAR(r.v_end, cases[i].v_mid, 1e-3 * fabs(cases[i].v_mid));
    CHECK_NEAR(r.v_end, p.v_mid, 1e-14 * fabs(p.v_mid));
  }
}

/* So light a body that the steady velocity is 1e-147 of l': no bracket is too wide. */
TEST(far_from_the_guess)
{
  struct scallop_crawler c = {
    1, 1.2351507177350147e+146, 1.2480035652144186,      0.28962761566487188, 0.1436206993167419,
    1, 0.39310801961328146,     &scallop_gait_sinusoidal
  };
  struct scallop_steady_result s = steady_of(&c);
  CHECK_NEAR(s.period.v_start, -7.170448668775392e-147, 1e-160);
  CHECK_NEAR(s.period.v_end, s.period.v_start, 1e-160);
}
