/* Gaits made to measure (model/gaits.h, compare/points/gaits.h): that they are what they say, what is refused, and
 * what is known of motions with them in closed form or by symmetry. */
#include <float.h>

#include "compare/points/gait_file.h"
#include "compare/points/gaits.h"
#include "model/gaits.h"
#include "model/law.h"
#include "tests/support/odd_gaits.h"
#include "tests/support/random_gait.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/solved.h"

static double time_of(const struct scallop_piece *p, double u) { return p->anchor == SCALLOP_FROM_START ? u : 1 - u; }

/* Where one piece ends the next one begins, with the same l' and l; at 1/2 the anchor changes. */
static void check_seam(const struct scallop_piece *p, const struct scallop_piece *q, double peak)
{
  double at = p->end;
  if (p->anchor != q->anchor) {
    at = 1 - p->end;
    CHECK_EQUAL(1 - at, p->end);
  }
  CHECK_EQUAL(q->begin, at);
  CHECK_NEAR(q->curve->velocity(q, q->begin), p->curve->velocity(p, p->end), 8 * DBL_EPSILON * peak);
}

/* l' has the sign that the piece says, l'' is monotone, and `when` finds it */
static void check_piece(const struct scallop_piece *p, double peak)
{
  enum { PLACES = 16 };
  double a0 = p->curve->acceleration(p, p->begin), a1 = p->curve->acceleration(p, p->end), last = a0;
  double range = fabs(p->end - p->begin), ulp = 64 * DBL_EPSILON * (fabs(a0) + fabs(a1) + peak / range);
  for (int i = 1; i < PLACES; i++) {
    double u = p->begin + (p->end - p->begin) * i / PLACES, v = p->curve->velocity(p, u),
           a = p->curve->acceleration(p, u);
    assert_true(p->direction == 0 ? v == 0 : p->direction * v > 0);
    if (p->curve->rates) { /* promised to be the same, to the last digit */
      double velocity, acceleration;
      p->curve->rates(p, u, &velocity, &acceleration);
      assert_true(velocity == v && acceleration == a);
    }
    CHECK_AT_MOST(a1 > a0 ? last - a : a - last, ulp);
    last = a;
    if (p->linear || fabs(a1 - a0) < 1e-3 * peak)
      continue;
    CHECK_NEAR(p->curve->acceleration(p, p->curve->when(p, a)), a, ulp);
  }
}

static void check_shape(const struct scallop_gait *gait, int kind)
{
  const struct scallop_shape *shape = &gait->phase[kind];
  const struct scallop_piece *first = &shape->pieces[0], *last = &shape->pieces[shape->count - 1];
  double ends[2], net = 0, peak = 0;
  scallop_gait_at(gait, (enum scallop_phase_kind)kind, 0, &ends[0], NULL, NULL);
  scallop_gait_at(gait, (enum scallop_phase_kind)kind, 1, &ends[1], NULL, NULL);
  CHECK_NEAR(ends[0], kind, 8 * DBL_EPSILON);
  CHECK_NEAR(ends[1], 1 - kind, 8 * DBL_EPSILON);
  CHECK_EQUAL(first->begin, 0);
  CHECK_EQUAL(last->end, 0);
  assert_int_equal(first->anchor, SCALLOP_FROM_START);
  assert_int_equal(last->anchor, SCALLOP_FROM_END);
  CHECK_EQUAL(first->curve->velocity(first, 0), 0);
  CHECK_EQUAL(last->curve->velocity(last, 0), 0);
  CHECK_EQUAL(first->curve->acceleration(first, 0), shape->l0);
  CHECK_EQUAL(last->curve->acceleration(last, 0), shape->lT);
  for (int i = 0; i < shape->count; i++) {
    const struct scallop_piece *p = &shape->pieces[i];
    check_piece(p, shape->peak);
    if (i > 0)
      check_seam(p - 1, p, shape->peak);
    net += p->direction * (time_of(p, p->end) - time_of(p, p->begin));
    for (int k = 0; k <= 64; k++)
      peak = fmax(peak, fabs(p->curve->velocity(p, p->begin + (p->end - p->begin) * k / 64)));
  }
  CHECK_NEAR(shape->net, net, 1e-15 * shape->count);
  CHECK_AT_MOST(peak, shape->peak * (1 + 8 * DBL_EPSILON));
  CHECK_AT_MOST(0.99 * shape->peak, peak);
}

/* l' is the derivative of l, l'' that of l': by differences that do not cross a seam */
static void check_derivatives(const struct scallop_shape *shape)
{
  for (int i = 0; i < shape->count; i++) {
    const struct scallop_piece *p = &shape->pieces[i];
    double range = p->end - p->begin, u = p->begin + 0.4 * range, h = 1e-4 * range,
           forward = p->anchor == SCALLOP_FROM_START ? 1 : -1;
    double rise = p->curve->length(p, u + h) - p->curve->length(p, u - h);
    double v = p->curve->velocity(p, u), bend = p->curve->velocity(p, u + h) - p->curve->velocity(p, u - h);
    double a = p->curve->acceleration(p, u), size = fabs(a) + shape->peak / fabs(range);
    CHECK_NEAR(rise / (2 * h), forward * v, 1e-6 * fabs(range) * size + DBL_EPSILON / fabs(h));
    CHECK_NEAR(bend / (2 * h), forward * a, 1e-6 * size);
  }
}

TEST(gaits_are_gaits)
{
  struct random r = { 20261201 };
  struct random_gait made;
  for (int i = 0; i < 100 * RANDOM_GAITS; i++) {
    const struct scallop_gait *gait = i < 2 ? every_gait[i]
                                            : random_gait(&r, (enum random_gait_kind)(i % RANDOM_GAITS), &made);
    for (int kind = 0; kind < 2; kind++) {
      check_shape(gait, kind);
      check_derivatives(&gait->phase[kind]);
    }
  }
}

static void check_same_motions(const struct scallop_gait *gait, const struct scallop_gait *other, double tolerance)
{
  struct random r = { 20261202 };
  for (int i = 0; i < 200; i++) {
    struct scallop_crawler c = random_crawler(&r, (enum family)(i % FAMILIES), gait), d = c;
    struct scallop_steady_result a, b;
    struct scallop_phase_result p, q;
    d.gait = other;
    double v0 = random_start(&r, &c, SCALLOP_CONTRACTION), unit = c.L / scallop_phase_duration(&c, SCALLOP_CONTRACTION);
    assert_int_equal(scallop_steady(&c, &a), scallop_steady(&d, &b));
    CHECK_NEAR(a.period.v_start, b.period.v_start, tolerance * fabs(b.period.v_start));
    CHECK_NEAR(a.period.displacement, b.period.displacement, tolerance * c.L);
    CHECK_NEAR(a.period.multiplier, b.period.multiplier, tolerance);
    assert_int_equal(scallop_phase(&c, SCALLOP_CONTRACTION, v0, &p), scallop_phase(&d, SCALLOP_CONTRACTION, v0, &q));
    CHECK_NEAR(p.v_end, q.v_end, tolerance * (unit + fabs(v0)));
    CHECK_NEAR(p.dxC, q.dxC, tolerance * (c.L + fabs(v0) * c.L / unit));
    assert_int_equal(p.modes.count, q.modes.count);
  }
}

/* A trapezoid without a plateau and a skewed gait that is not skewed have the very numbers of the quadratic gait. */
TEST(halves_are_quadratic)
{
  check_same_motions(gait_of_text("trapezoidal:0.5,0.5").gait, &scallop_gait_quadratic, 0);
  check_same_motions(gait_of_text("skewed:0.5").gait, &scallop_gait_quadratic, 0);
}

/* However its coefficients are scaled */
TEST(minimum_jerk_is_a_polynomial)
{
  check_same_motions(gait_of_text("polynomial:0,0,1.0,-1.5,0.6").gait, &minimum_jerk_gait, 1e-12);
}

/* Written out by hand, by laws of another kind */
TEST(gaits_by_hand)
{
  check_same_motions(gait_of_text("polynomial:0,12,-4,-3").gait, &leaning_gait, 1e-12);
  check_same_motions(&scallop_gait_quadratic, &ramps_gait, 1e-12);
}

/* skewed is a trapezoid without a plateau, but for the definition of the rest by 1 - beta */
TEST(skewed_is_a_trapezoid)
{
  struct scallop_straight skewed, trapezoid;
  const double beta[2] = { 0.375, 0.6875 }, rest[2] = { 0.625, 0.3125 };
  assert_int_equal(scallop_make_skewed(&skewed, "skewed", beta), SCALLOP_OK);
  assert_int_equal(scallop_make_trapezoidal(&trapezoid, "trapezoidal", beta, rest), SCALLOP_OK);
  assert_true(skewed.gait.phase[0].ramps && trapezoid.gait.phase[0].ramps);
  check_same_motions(&skewed.gait, &trapezoid.gait, 0);
}

/* beta = 0.3: 1 - beta is no double, so what falls is in two pieces; 0.375 beside it needs one */
TEST(pieces_begin_at_doubles)
{
  struct scallop_straight g;
  assert_int_equal(scallop_make_skewed(&g, "skewed", (const double[]){ 0.3, 0.7 }), SCALLOP_OK);
  assert_int_equal(g.gait.phase[0].count, 3);
  assert_int_equal(g.gait.phase[1].count, 2);
  assert_false(g.gait.phase[0].ramps);
  assert_true(g.gait.phase[0].concave && g.gait.phase[1].ramps);
  /* neither 0.3 and 0.7 nor 0.1 and 0.9 are doubles, and the sums of those are below and above 1: they are meant to be
   * 1 */
  assert_int_equal(
      scallop_make_trapezoidal(&g, "trapezoidal", (const double[]){ 0.3, 0.1 }, (const double[]){ 0.7, 0.9 }),
      SCALLOP_OK);
  assert_int_equal(g.gait.phase[0].count, 3);
  assert_int_equal(g.gait.phase[1].count, 3);
  CHECK_EQUAL(g.gait.phase[0].peak, 2);
  /* 0.25 and 0.125 leave a plateau in two pieces, 0.75 and 0.125 in one */
  assert_int_equal(
      scallop_make_trapezoidal(&g, "trapezoidal", (const double[]){ 0.25, 0.75 }, (const double[]){ 0.125, 0.125 }),
      SCALLOP_OK);
  assert_int_equal(g.gait.phase[0].count, 4);
  assert_int_equal(g.gait.phase[1].count, 3);
}

/* Ramps of R are a trapezoid of R and R; R = 0 is |l'| = 1 with jumps, in one phase or in both. */
TEST(constant_gaits)
{
  struct scallop_straight constant;
  const double bad[] = { -0.1, 0x1p-101, 0.5 + 0x1p-53, 1, NAN, INFINITY };
  check_same_motions(gait_of_text("constant:0.1").gait, gait_of_text("trapezoidal:0.1,0.1").gait, 0);
  check_same_motions(gait_of_text("constant:0.125,0.5").gait, gait_of_text("trapezoidal:0.125,0.125,0.5,0.5").gait, 0);
  check_same_motions(gait_of_text("constant:1e-9,0.2").gait, gait_of_text("trapezoidal:1e-9,1e-9,0.2,0.2").gait, 0);
  for (int which = 1; which < 4; which++) {
    const double some[2] = { which & 1 ? 0 : 0.25, which & 2 ? 0 : 0.5 };
    assert_int_equal(scallop_make_constant(&constant, "constant", some), SCALLOP_OK);
    for (int kind = 0; kind < 2; kind++) {
      const struct scallop_shape *shape = &constant.gait.phase[kind];
      double sign = kind == SCALLOP_EXTENSION ? 1 : -1;
      assert_true(shape->pieces[0].jump && !shape->pieces[1].jump && !shape->concave && !shape->ramps);
      CHECK_EQUAL(shape->net, sign);
      CHECK_EQUAL(shape->peak, some[kind] == 0 ? 1 : 1 / (1 - some[kind]));
      for (int i = 0; i <= 8; i++) {
        double s = i / 8., length, velocity;
        scallop_gait_at(&constant.gait, (enum scallop_phase_kind)kind, s, &length, &velocity, NULL);
        if (some[kind] != 0)
          continue;
        CHECK_EQUAL(length, kind == SCALLOP_EXTENSION ? s : 1 - s);
        CHECK_EQUAL(velocity, sign);
      }
    }
  }
  for (size_t i = 0; i < 2 * sizeof bad / sizeof *bad; i++) {
    const double some[2] = { i % 2 ? 0 : bad[i / 2], i % 2 ? bad[i / 2] : 0.25 };
    assert_int_equal(scallop_make_constant(&constant, "", some), SCALLOP_EDOMAIN);
  }
}

TEST(bad_straight_gaits)
{
  static const double bad[] = { 0, -0.1, 1, 1.5, 0x1p-101, NAN, INFINITY };
  struct scallop_straight g;
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
    for (int at = 0; at < 4; at++) {
      double x[4] = { 0.25, 0.25, 0.25, 0.25 };
      x[at] = bad[i];
      assert_int_equal(scallop_make_trapezoidal(&g, "", x, x + 2), SCALLOP_EDOMAIN);
      assert_int_equal(scallop_make_skewed(&g, "", x + at % 2), at < 2 ? SCALLOP_EDOMAIN : SCALLOP_OK);
    }
  const double much[2] = { 0.5, 0.5 }, more[2] = { 0.5, 0.5 + 0x1p-52 };
  assert_int_equal(scallop_make_trapezoidal(&g, "", much, more), SCALLOP_EDOMAIN);
}

/* Every family: its sample is one of its gaits; how many numbers it takes, and that those of the extension hold for the
 * contraction. */
TEST(families)
{
  static union scallop_made_gait one, two;
  const struct scallop_gait_family *family;
  const double x[SCALLOP_GAIT_NUMBERS + 1] = { 0.125, 0.25, 0.375, 0.0625 };
  const char *why;
  assert_null(scallop_gait_family(-1));
  assert_true(scallop_made_gait_size == sizeof one);
  for (int i = 0; (family = scallop_gait_family(i)) != NULL; i++) {
    const struct scallop_gait *sample = gait_of_text(family->sample).gait;
    int each = family->each;
    assert_non_null(sample);
    assert_int_equal(strncmp(family->sample, family->name, strlen(family->name)), 0);
    assert_true(family->sentence && !family->numbers == !family->allowed && !family->fixed == (family->make != NULL));
    assert_true(!family->fixed || family->fixed == sample);
    for (int count = 0; count <= SCALLOP_GAIT_NUMBERS + 1; count++)
      if (each == 0 || (count != each && count != 2 * each))
        assert_int_equal(scallop_make_gait(&one, family, "", x, count, &why), SCALLOP_EDOMAIN);
    if (each == 0)
      continue;
    const double twice[4] = { x[0], x[1 % each], x[0], x[1 % each] };
    assert_int_equal(scallop_make_gait(&one, family, "one", x, each, &why), SCALLOP_OK);
    assert_int_equal(scallop_make_gait(&two, family, "two", twice, 2 * each, &why), SCALLOP_OK);
    check_same_motions(&one.gait, &two.gait, 0);
    assert_int_equal(scallop_make_gait(&two, family, "two", x, 2 * each, &why), SCALLOP_OK);
    assert_false(scallop_gait_mirrors(&two.gait));
  }
}

TEST(bad_polynomials)
{
  static const struct {
    double c[8];
    int degree;
    const char *why;
  } bad[] = { { { 0, 0, 1 }, 2, "degree" },
              { { 0, 0, 0, 0 }, 3, "degree" },
              { { 0, 1, 3, -7. / 3 }, 3, "start" },
              { { 0, 0, 3, -2.0000000000000013 }, 3, "end" },
              { { 0, 0, -3, 2 }, 3, "positive" },
              { { 0, 0, NAN, 2 }, 3, "finite" },
              { { 0, 0, INFINITY, 2 }, 3, "finite" },
              /* l' = s (1 - s) (1/2 - s)^2 touches 0; (1/3 - s)^2 too, but for rounding */
              { { 0, 0, 0.125, -5. / 12, 0.5, -0.2 }, 5, "so near to 0" },
              { { 0, 0, 1. / 18, -7. / 27, 5. / 12, -0.2 }, 5, "so near to 0" } };
  struct scallop_polynomial g;
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    const char *why = "";
    assert_int_equal(scallop_make_polynomial(&g, "", bad[i].c, bad[i].degree, &why), SCALLOP_EDOMAIN);
    if (!strstr(why, bad[i].why))
      fail_msg("%s, and not %s", why, bad[i].why);
    assert_int_equal(scallop_make_polynomial(&g, "", bad[i].c, bad[i].degree, NULL), SCALLOP_EDOMAIN);
  }
}

/* Two zeros of l', 1e-4 apart, and nearly two more near the end: each has its piece. Their distance is from a search
 * for all zeros in 60 digits, of C1 + 2 C2 s + ... less its value at the end times s^6. */
TEST(two_zeros_and_almost_two)
{
  static const double c[] = { 0,
                              0,
                              0.15456065558773208,
                              -0.67635268360914214,
                              1.3060806298739194,
                              -1.3195741346534107,
                              0.68224748223722309,
                              -0.14285714285714285 };
  struct scallop_polynomial g;
  assert_int_equal(scallop_make_polynomial(&g, "", c, 7, NULL), SCALLOP_OK);
  const struct scallop_shape *shape = &g.gait.phase[SCALLOP_EXTENSION];
  double back = 0;
  for (int i = 0; i < shape->count; i++)
    if (shape->pieces[i].direction < 0)
      back += fabs(shape->pieces[i].end - shape->pieces[i].begin);
  CHECK_RELATIVE(back, 1.1640201457269268e-4, 1e-10);
}

TEST(bad_splines)
{
  const struct scallop_knot good[3] = { { 0, 0, 0 }, { 0.5, 0.25, 1 }, { 1, 1, 0 } };
  const struct scallop_knot back[2] = { { 0, 1, 0 }, { 1, 0, 0 } };
  const struct {
    int at;
    struct scallop_knot knot;
  } bad[] = { { 0, { 0x1p-53, 0, 0 } },   { 0, { 0, 0.1, 0 } },      { 0, { 0, 0, 1 } },
              { 1, { 0, 0.25, 1 } },      { 1, { 1, 0.25, 1 } },     { 1, { 0x1.8p-54, 0.25, 1 } },
              { 1, { 0.5, 0x1p-60, 0 } }, { 1, { 0.5, 1.25, 0 } },   { 1, { 0.5, -0.25, 0 } },
              { 1, { 0.5, 0.25, -1 } },   { 1, { 0.5, 0.25, 1.6 } }, { 1, { 0.5, 0.25, NAN } },
              { 1, { NAN, 0.25, 1 } },    { 1, { 0.5, NAN, 1 } },    { 1, { 0.5, 0, 0.1 } },
              { 2, { 1, 0.5, 0 } },       { 2, { 0.75, 1, 0 } },     { 2, { 1, 1, -1 } } };
  struct scallop_piece pieces[5];
  struct scallop_law laws[5];
  const int count[2] = { 3, 2 };
  struct scallop_spline s = { .pieces = pieces, .laws = laws };
  struct scallop_knot knots[3];
  const struct scallop_knot *const phases[2] = { knots, back };
  assert_int_equal(scallop_spline_pieces(count), 5);
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    memcpy(knots, good, sizeof good);
    assert_int_equal(scallop_make_spline(&s, "", phases, count), SCALLOP_OK);
    knots[bad[i].at] = bad[i].knot;
    if (scallop_make_spline(&s, "", phases, count) != SCALLOP_EDOMAIN)
      fail_msg("knot %d: %g %g %g", bad[i].at, bad[i].knot.time, bad[i].knot.length, bad[i].knot.slope);
  }
  assert_int_equal(scallop_make_spline(&s, "", phases, (const int[2]){ 1, 2 }), SCALLOP_EDOMAIN);
}

/* Once up and down |l'| is concave; with a rest, or a way back, it is not. */
TEST(concave_splines)
{
  const struct scallop_knot once[3] = { { 0, 0, 0 }, { 0.5, 0.5, 1.5 }, { 1, 1, 0 } },
                            rest[4] = { { 0, 0, 0 }, { 0.25, 0.5, 0 }, { 0.5, 0.5, 0 }, { 1, 1, 0 } },
                            detour[4] = { { 0, 0, 0 }, { 0.25, 0.75, 0 }, { 0.5, 0.5, 0 }, { 1, 1, 0 } },
                            back[3] = { { 0, 1, 0 }, { 0.5, 0.5, -1.5 }, { 1, 0, 0 } };
  const struct scallop_knot *const out[3] = { once, rest, detour };
  struct scallop_piece pieces[MOST_SPLINE_PIECES];
  struct scallop_law laws[MOST_SPLINE_PIECES];
  struct scallop_spline s = { .pieces = pieces, .laws = laws };
  for (int i = 0; i < 3; i++) {
    const struct scallop_knot *const phases[2] = { out[i], back };
    assert_int_equal(scallop_make_spline(&s, "", phases, (const int[2]){ i == 0 ? 3 : 4, 3 }), SCALLOP_OK);
    assert_int_equal(s.gait.phase[SCALLOP_EXTENSION].concave, i == 0);
    assert_true(s.gait.phase[SCALLOP_CONTRACTION].concave);
    CHECK_EQUAL(s.gait.phase[SCALLOP_EXTENSION].net, 1 - i * 0.25); /* the share of the phase there, minus that back */
  }
}

/* With l'' = 0 at the ends a body that starts from rest, and is held at first, turns back before the end by a time that
 * goes as T^2: at T = 1e-80 by 1e-81 of the phase, in a piece that takes a fifth of it. */
TEST(turns_next_to_the_ends)
{
  struct scallop_crawler c = { 2.1585372372426566, 0.4367960174828488,
                               1.6360601029330115, 6.624494351254064,
                               1.1004164832244088, 0x1p-80,
                               0.8403785467147827, NULL };
  struct scallop_phase_result got;
  c.gait = gait_of_text("minimum-jerk").gait;
  struct scallop_phase_result wanted = phase_of(&c, SCALLOP_EXTENSION, 0);
  for (int k = 20; k <= 180; k += 40) {
    c.T = ldexp(1, -80 - k);
    got = phase_of(&c, SCALLOP_EXTENSION, 0);
    CHECK_NEAR(ldexp(got.dT, 2 * k), wanted.dT, 1e-13 * wanted.dT);
    CHECK_NEAR(ldexp(got.t1, 3 * k), wanted.t1, 1e-13 * wanted.t1);
    CHECK_NEAR(got.dxC, wanted.dxC, 1e-15 * c.L);
  }
}

/* What mirrors and what is reversible */
TEST(the_same_laws)
{
  static const struct {
    const char *text;
    bool mirrors, reversible;
  } gaits[] = { { "trapezoidal", true, true },
                { "trapezoidal:0.2,0.3", true, false },
                { "trapezoidal:0.2,0.2,0.3,0.3", false, true },
                { "trapezoidal:0.2,0.3,0.3,0.2", false, false },
                { "skewed:0.5", true, true },
                { "skewed:0.3", true, false },
                { "skewed:0.3,0.7", false, false },
                { "minimum-jerk", true, true },
                { "polynomial:0,0.5,0,-0.25", true, false },
                { "polynomial:0,-0.1,0.4,-0.25", true, false } };
  for (size_t i = 0; i < sizeof gaits / sizeof *gaits; i++) {
    struct gait_result a = gait_of_text(gaits[i].text);
    if (!a.gait)
      fail_msg("%s: %s", gaits[i].text, a.wrong);
    if (scallop_gait_mirrors(a.gait) != gaits[i].mirrors || scallop_gait_is_reversible(a.gait) != gaits[i].reversible)
      fail_msg("%s", gaits[i].text);
  }
}

/* The extension is over at half of its phase, and l rests for the other half: friction then takes (F1 + F2) tau/2 / M
 * from the velocity that both bodies have, but no more than there is. What comes before is a phase of half the duration
 * with the same cubic, 3 s^2 - 2 s^3. */
TEST(rest_at_the_end)
{
  struct scallop_piece pieces[7];
  struct scallop_law laws[7];
  struct scallop_spline s = { .pieces = pieces, .laws = laws };
  const struct scallop_knot out[3] = { { 0, 0, 0 }, { 0.5, 1, 0 }, { 1, 1, 0 } },
                            back[2] = { { 0, 1, 0 }, { 1, 0, 0 } };
  assert_int_equal(
      scallop_make_spline(&s, "rest", (const struct scallop_knot *const[2]){ out, back }, (const int[2]){ 3, 2 }),
      SCALLOP_OK);
  assert_int_equal(s.gait.phase[0].pieces[s.gait.phase[0].count - 1].direction, 0);
  CHECK_EQUAL(s.gait.phase[0].net, 0.5);
  struct random r = { 20261204 };
  for (int i = 0; i < 300; i++) {
    struct scallop_crawler c = random_crawler(&r, i % 2 ? STICK_SLIP : ORDINARY, &s.gait), d = c;
    double tau = scallop_phase_duration(&c, SCALLOP_EXTENSION), v0 = random_start(&r, &c, SCALLOP_EXTENSION);
    d.gait = gait_of_text("polynomial:0,3,-2").gait;
    d.T = c.T / 2;
    struct scallop_phase_result p = phase_of(&c, SCALLOP_EXTENSION, v0);
    struct scallop_phase_result q = phase_of(&d, SCALLOP_EXTENSION, v0);
    double brake = (c.F1 + c.F2) / (c.m1 + c.m2), time = fmin(tau / 2, fabs(q.v_end) / brake),
           size = c.L + (fabs(v0) + c.L / tau) * tau;
    double v = copysign(fabs(q.v_end) - brake * time, q.v_end),
           x = copysign((fabs(q.v_end) + fabs(v)) / 2 * time, q.v_end);
    if (time < tau / 2)
      v = 0;
    CHECK_NEAR(p.v_end, v, 1e-13 * size / tau);
    CHECK_NEAR(p.dxC, q.dxC + x, 1e-13 * size);
  }
}

static const char path[] = "gait";
static const char *choice = ":monotone"; /* behind the name of the file */
static char text[64];

/* The gait measured in a file of these bytes. Each has another name: what was read once is not read again. */
static struct gait_result measured(const char *bytes, size_t size)
{
  static int number;
  char name[24];
  snprintf(name, sizeof name, "%s%d", path, number++);
  FILE *file = fopen(name, "w");
  assert_non_null(file);
  assert_int_equal(fwrite(bytes, 1, size, file), size);
  assert_int_equal(fclose(file), 0);
  snprintf(text, sizeof text, "measured:%s%s", name, choice);
  struct gait_result answer = gait_of_text(text);
  assert_int_equal(remove(name), 0);
  return answer;
}

static struct gait_result measured_text(const char *table) { return measured(table, strlen(table)); }

TEST(bad_files)
{
  static const struct {
    const char *table, *says;
  } bad[] = { { "", ": fewer than four rows" },
              { "# nothing\n\n", ": fewer than four rows" },
              { "t l\n0 0\n", ": fewer than four rows" },
              { "0 0\n1 1\n2 0\n", ": fewer than four rows" },
              { "0 0\n1 1\n2 0\n2 1\n", ": fewer than four rows" },
              { "0 0\n1 inf\n2 0.5\n3 0\n", ":2: column 2, 'inf', is not a finite number" },
              { "0 0\n1 1e999\n2 0.5\n3 0\n", ":2: column 2, '1e999', is not a finite number" },
              { "0 0\n1 1\n2 x\n3 0\n", ":3: column 2, 'x', is not a finite number" },
              { "t l\n0 0\n1 1\ny 0.5\n3 0\n", ":4: column 1, 'y', is not a finite number" },
              { "0 0 1\n1 1 7\n2 0.5 1\n3 0 1\n", ":1: 3 columns without a header" },
              { "t x\n0 0\n1 1\n2 0.5\n3 0\n", ": no columns are named t and l, or t, x1 and x2" },
              { "t x1\n0 0\n1 1\n2 0.5\n3 0\n", ": no columns are named t and l, or t, x1 and x2" },
              { "0 0\n1 1\n2 3\n3 4\n4 5\n5 7\n", ": not periodic" },
              { "0 1\n1 1\n2 1\n3 1\n", ": l is the same throughout" },
              { "0 0\n1 1\n2 -1e308\n3 1e308\n4 0\n", ": the range" } };
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    struct gait_result a = measured_text(bad[i].table);
    assert_null(a.gait);
    assert_int_equal(a.fault, GAIT_UNKNOWN);
    if (!strstr(a.wrong, path) || !strstr(a.wrong, bad[i].says))
      fail_msg("%s, and not %s", a.wrong, bad[i].says);
  }
  struct gait_result binary = measured("0 0\n1 1\0\n2 0\n", 12);
  assert_non_null(strstr(binary.wrong, ":2: this is not a text file"));
}

TEST(files_that_cannot_be_read)
{
  struct gait_result none = gait_of_text("measured:/nowhere/at/all"), folder = gait_of_text("measured:/tmp");
  assert_int_equal(none.fault, GAIT_UNREADABLE);
  assert_null(none.gait);
  assert_int_equal(folder.fault, GAIT_UNREADABLE);
  assert_int_equal(gait_of_text("measured:a\tb").fault, GAIT_UNKNOWN);
  assert_int_equal(gait_of_text("measured:").fault, GAIT_UNKNOWN);
}

TEST(too_long_a_file)
{
  enum { ROWS = 100001 };
  char *table = malloc(ROWS * 16);
  size_t size = 0;
  assert_non_null(table);
  for (int i = 0; i < ROWS; i++)
    size += (size_t)snprintf(table + size, 16, "%d %d\n", i, i % 2);
  struct gait_result a = measured(table, size);
  assert_null(a.gait);
  assert_non_null(strstr(a.wrong, ":100001: more than 100000 rows"));
  free(table);
}

/* Comments, blank lines, a header, any blanks, CRLF; the period begins at the minimum. */
TEST(a_good_file)
{
  double l, l_later;
  struct gait_result a = measured_text(
      "# a comment\r\n\r\nt\tl\r\n 1 3\n2 \t 5\n# more\n3 2\n5 1\n6 2\n11 3.0000000001\n");
  if (!a.gait) {
    fail_msg("%s", a.wrong);
    return;
  }
  const struct gait_file *file = gait_file_of(a.gait);
  assert_non_null(file);
  CHECK_EQUAL(file->best.L, 4);
  CHECK_EQUAL(file->best.T, 10);
  CHECK_EQUAL(file->best.alpha, 0.7); /* from t = 5 to t = 2, a period later */
  scallop_gait_at(a.gait, SCALLOP_EXTENSION, 1. / 7, &l, NULL, NULL);
  CHECK_NEAR(l, 0.25, 1e-15);
  scallop_gait_at(a.gait, SCALLOP_EXTENSION, 6. / 7, &l, NULL, NULL);
  CHECK_NEAR(l, 0.5, 1e-15);
  scallop_gait_at(a.gait, SCALLOP_CONTRACTION, 1. / 3, &l_later, NULL, NULL);
  CHECK_NEAR(l_later, 0.25, 1e-15);
  assert_ptr_equal(gait_of_text(text).gait, a.gait);
  assert_string_equal(a.gait->name, text);
  assert_null(gait_file_of(&scallop_gait_quadratic));
}

/* The same gait however it is written: L, T and alpha are those of the first table. */
TEST(other_tables)
{
  static const char *const tables[] = { "0 3\n1 5\n2 2\n4 1\n5 2\n10 3\n",
                                        "0 3\n4 1\n1 5\n2 2\n10 3\n5 2\n", /* unsorted */
                                        "time [s],length (mm)\n0,3\n1,5\n2,2\n4,1\n5,2\n10,3\n",
                                        "t [s]   x1 [m]   x2 [m]\n0 1 4\n1 0 5\n2 -1 1\n4 0 1\n5 2 4\n10 0 3\n",
                                        "n,x2,t,x1\n1,4,0,1\n2,5,1,0\n3,1,2,-1\n4,1,4,0\n5,4,5,2\n6,3,10,0\n",
                                        "t,l\n0,3\n1,5\n1.5,\n2,2\n3,NaN\n4,1\n5,2\n10,3\n", /* without a number */
                                        "t l\n0 3\n1 4\n1 6\n2 2\n4 1\n5 2\n10 3\n" };       /* twice at 1 */
  for (size_t i = 0; i < sizeof tables / sizeof *tables; i++) {
    struct gait_result a = measured_text(tables[i]);
    if (!a.gait)
      fail_msg("%s: %s", tables[i], a.wrong);
    const struct gait_file *file = gait_file_of(a.gait);
    CHECK_EQUAL(file->best.L, 4);
    CHECK_EQUAL(file->best.T, 10);
    CHECK_EQUAL(file->best.alpha, 0.7);
  }
}

/* A kind and its noise, and the period, are told from the name of a file that has a colon. */
TEST(choices)
{
  static const struct {
    const char *choice;
    double T; /* 0: no such file */
  } all[] = {
    { "", 4 },          { ":cubic", 4 },     { ":smooth", 4 },    { ":phases=0.01", 4 }, { ":smooth=0.01:period=5", 5 },
    { ":period=8", 8 }, { ":cubic=0.1", 0 }, { ":smooth=-1", 0 }, { ":spline", 0 },      { ":period=0", 0 }
  };
  for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
    choice = all[i].choice;
    struct gait_result a = measured_text(
        "0 0\n.3 .5\n.7 1\n1 1.3\n1.3 1.7\n1.7 1.9\n2 2\n2.3 1.6\n2.6 1.2\n3 .6\n3.4 .4\n"
        "3.7 .2\n3.9 .1\n4 0\n");
    choice = ":monotone";
    assert_int_equal(!a.gait, all[i].T == 0);
    if (a.gait)
      CHECK_EQUAL(gait_file_of(a.gait)->best.T, all[i].T);
    else
      assert_int_equal(a.fault, GAIT_UNREADABLE);
  }
}

TEST(texts)
{
  static const struct {
    const char *text, *says;
  } bad[] = {
    { "trapezodal", "did you mean 'trapezoidal'" }, { "skewed:0.3x", "'0.3x' is not a number" },
    { "skewed:0.1,0.2,0.3", "skewed:BETA" },        { "trapezoidal:0.1,0.2,0.3", "UP + DOWN" },
    { "trapezoidal:0.6,0.5", "UP + DOWN" },         { "minimum-jerk:1", "did you mean 'minimum-jerk'" },
    { "polynomial", "polynomial:C1,C2" },           { "polynomial:0,0,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1", "degree" },
    { "polynomial:0,", "'' is not a number" }
  };
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    struct gait_result a = gait_of_text(bad[i].text);
    assert_null(a.gait);
    if (!strstr(a.wrong, bad[i].says))
      fail_msg("%s, and not %s", a.wrong, bad[i].says);
  }
  assert_ptr_equal(gait_of_text("quadratic").gait, &scallop_gait_quadratic);
  struct gait_result a = gait_of_text("trapezoidal"), b = gait_of_text("trapezoidal:0.25,0.25");
  assert_ptr_equal(gait_of_text("trapezoidal").gait, a.gait);
  check_same_motions(a.gait, b.gait, 0);
  check_same_motions(gait_of_text("skewed").gait, gait_of_text("skewed:0.25,0.25").gait, 0);
}

/* A gait measured at 2n + 1 equally spaced points of l, which is given over the extension and goes the same way back */
static const struct scallop_gait *sampled(double (*l)(double s), int n)
{
  char table[32768];
  size_t size = 0;
  for (int i = 0; i <= 2 * n; i++)
    size += (size_t)snprintf(table + size, sizeof table - size, "%d %.17g\n", i,
                             l(i <= n ? (double)i / n : 2 - (double)i / n));
  struct gait_result a = measured(table, size);
  assert_non_null(a.gait);
  return a.gait;
}

static double worst_velocity(const struct scallop_gait *got, const struct scallop_gait *wanted)
{
  enum { PLACES = 5000 };
  double worst = 0, v, w;
  for (int i = 0; i <= PLACES; i++) {
    scallop_gait_at(got, SCALLOP_EXTENSION, (double)i / PLACES, NULL, &v, NULL);
    scallop_gait_at(wanted, SCALLOP_EXTENSION, (double)i / PLACES, NULL, &w, NULL);
    worst = fmax(worst, fabs(v - w));
  }
  return worst;
}

static double wave(double s) { return 0.5 - 0.5 * cos(3.14159265358979323846 * s); }
static double parabolas(double s) { return s < 0.5 ? 2 * s * s : 1 - 2 * (1 - s) * (1 - s); }

/* Steffen's slope is that of the parabola through three points, to second order, unless twice a secant is less, which
 * where |l'| is concave from 0 it is not: so l' is right to second order. The steady state follows. */
TEST(samples_of_the_sinusoidal_gait)
{
  struct scallop_crawler c = scallop_crawler_default(), d = c;
  d.gait = &scallop_gait_sinusoidal;
  double last = worst_velocity(sampled(wave, 8), &scallop_gait_sinusoidal);
  for (int n = 16; n <= 256; n *= 2) {
    c.gait = sampled(wave, n);
    double now = worst_velocity(c.gait, &scallop_gait_sinusoidal);
    CHECK_NEAR(log2(last / now), 2, 0.1);
    CHECK_NEAR(steady_of(&c).period.v_start, steady_of(&d).period.v_start, now * c.L / c.T);
    last = now;
  }
}

/* With equally spaced points the parabola through three of them is the gait, but for those around the middle, where l''
 * jumps: the secants on both sides are 2 - 2/n there, and l' is 2. That is all that is wrong: motions whose bodies turn
 * elsewhere are the same. */
TEST(samples_of_the_quadratic_gait)
{
  for (int n = 8; n <= 512; n *= 2)
    CHECK_NEAR(worst_velocity(sampled(parabolas, n), &scallop_gait_quadratic), 2. / n, 1e-12);
  struct random r = { 20261205 };
  const struct scallop_gait *gait = sampled(parabolas, 64);
  int compared = 0;
  for (int i = 0; i < 200; i++) {
    struct scallop_crawler c = random_crawler(&r, ORDINARY, gait), d = c;
    d.gait = &scallop_gait_quadratic;
    double v0 = random_start(&r, &c, SCALLOP_EXTENSION), tau = scallop_phase_duration(&c, SCALLOP_EXTENSION);
    struct scallop_phase_result q = phase_of(&d, SCALLOP_EXTENSION, v0);
    if (q.modes.count != 3 || q.regime != SCALLOP_SLIDING || q.t1 > 0.45 * tau || q.dT > 0.45 * tau)
      continue;
    struct scallop_phase_result p = phase_of(&c, SCALLOP_EXTENSION, v0);
    CHECK_NEAR(p.t1, q.t1, 1e-13 * tau);
    CHECK_NEAR(p.dT, q.dT, 1e-13 * tau);
    CHECK_NEAR(p.v_end, q.v_end, 1e-13 * (c.L / tau + fabs(v0)));
    CHECK_NEAR(p.dxC, q.dxC, 1e-13 * (c.L + fabs(v0) * tau));
    compared++;
  }
  assert_true(compared > 50);
}

/* Every number of a law counts but its base and what lies behind its degree. numbers: of `other`, a copy of law. */
static void check_each_number(const struct scallop_law *law, struct scallop_law *other, double *const numbers[],
                              int count)
{
  assert_true(law_same(law, other));
  for (int i = 0; i < count; i++) {
    *numbers[i] += 0.5;
    assert_false(law_same(law, other));
    *numbers[i] -= 0.5;
  }
  other->base += 1;
  assert_true(law_same(law, other));
  other->degree--;
  assert_false(law_same(law, other));
}

TEST(laws_are_compared)
{
  const double more[2] = { 8, 9 };
  double copy[2] = { 8, 9 };
  const struct scallop_law laws[4] = {
    { SCALLOP_LAW_POLYNOMIAL, 2, .polynomial = { { 1, 2, 3, 4 }, 5 } },
    { SCALLOP_LAW_RAMP, 1, .ramp = { 1, 2, 3, { 4, 5, 6 } } },
    { SCALLOP_LAW_BERNSTEIN, 2, .bernstein = { { 1, 2, 3, 4 }, 5, 6, 7, .implied = 1, .more_count = 2, .more = more } },
    { .kind = SCALLOP_LAW_SINE },
  };
  struct scallop_law p = laws[0], r = laws[1], b = laws[2];
  for (int i = 0; i < 4; i++)
    for (int k = 0; k < 4; k++)
      assert_int_equal(law_same(&laws[i], &laws[k]), i == k);
  p.polynomial.c[3] = 0;
  check_each_number(
      &laws[0], &p,
      (double *[]){ &p.polynomial.c[0], &p.polynomial.c[1], &p.polynomial.c[2], &p.polynomial.denominator }, 4);
  check_each_number(&laws[1], &r,
                    (double *[]){ &r.ramp.start, &r.ramp.slope, &r.ramp.divisor, &r.ramp.parts[0], &r.ramp.parts[1],
                                  &r.ramp.parts[2] },
                    6);
  b.bernstein.b[3] = 0;
  b.bernstein.more = copy;
  check_each_number(&laws[2], &b,
                    (double *[]){ &b.bernstein.b[0], &b.bernstein.b[1], &b.bernstein.b[2], &b.bernstein.near,
                                  &b.bernstein.far, &b.bernstein.way, &copy[0], &copy[1] },
                    8);
  assert_true(law_same(&laws[3], &(struct scallop_law){ .kind = SCALLOP_LAW_SINE }));
  b = laws[2];
  b.bernstein.implied = 2;
  assert_false(law_same(&laws[2], &b));
  b = laws[2];
  b.bernstein.more_count = 1;
  assert_false(law_same(&laws[2], &b));
}

/* l'' of a straight piece is what it is from the beginning of the piece, and nothing else anywhere. */
TEST(a_ramp_has_one_acceleration)
{
  struct scallop_straight g;
  const double quarters[2] = { 0.25, 0.25 };
  assert_int_equal(scallop_make_trapezoidal(&g, "trapezoidal", quarters, quarters), SCALLOP_OK);
  const struct scallop_shape *shape = &g.gait.phase[SCALLOP_EXTENSION];
  for (int i = 0; i < shape->count; i++) {
    const struct scallop_piece *p = &shape->pieces[i];
    CHECK_EQUAL(p->curve->when(p, p->acceleration), p->begin);
    CHECK_EQUAL(p->curve->when(p, p->acceleration + 1), NAN);
  }
}

int main(void) { return check_run(scratch_begin, scratch_end); }
