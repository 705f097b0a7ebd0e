/* Gaits (model/model.h, model/gaits.h, compare/points/gaits.h): that they are what they say, what is refused, and what
 * is known of motions with them in closed form or by symmetry. */
#include <float.h>

#include "compare/points/gait_file.h"
#include "compare/points/gaits.h"
#include "model/gaits.h"
#include "model/law.h"
#include "tests/support/cases.h"
#include "tests/support/odd_gaits.h"
#include "tests/support/random_gait.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/solved.h"

#define PI 3.14159265358979323846

static const struct scallop_gait *gait_of(const char *text)
{
  struct gait_result a = gait_of_text(text);
  if (!a.gait)
    fail_msg("%s: %s", text, a.wrong);
  return a.gait;
}

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

/* l' has the sign that the piece says, l'' is monotone, and `when` finds where it has a value; compared as values of
 * l'', since where l'' turns a rounding of it moves u by far more. To a few ulp for the gaits that have no numbers. */
static void check_piece(const struct scallop_piece *p, double peak, bool closely)
{
  const int places = closely ? 200 : 16;
  double a0 = p->curve->acceleration(p, p->begin), a1 = p->curve->acceleration(p, p->end), last = a0;
  double high = fmax(a0, a1), low = fmin(a0, a1), past = fmax(1, high - low), range = fabs(p->end - p->begin);
  double ulp = closely ? 8 * DBL_EPSILON * fmax(fabs(a0), fabs(a1))
                       : 64 * DBL_EPSILON * (fabs(a0) + fabs(a1) + peak / range);
  CHECK_EQUAL(p->curve->when(p, high + past), NAN);
  CHECK_EQUAL(p->curve->when(p, low - past), NAN);
  if (p->linear)
    CHECK_EQUAL(p->curve->when(p, p->acceleration), p->begin);
  for (int i = 1; i < places; i++) {
    double u = p->begin + (p->end - p->begin) * i / places, v = p->curve->velocity(p, u),
           a = p->curve->acceleration(p, u);
    assert_true(p->direction == 0 ? v == 0 : p->direction * v > 0);
    if (p->curve->rates) { /* promised to be the same, to the last digit */
      double velocity, acceleration;
      p->curve->rates(p, u, &velocity, &acceleration);
      assert_true(velocity == v && acceleration == a);
    }
    CHECK_AT_MOST(a1 > a0 ? last - a : a - last, closely ? 0 : ulp);
    assert_true(!closely || p->linear || a != last);
    last = a;
    if (p->linear || (!closely && fabs(a1 - a0) < 1e-3 * peak))
      continue;
    double back = p->curve->when(p, a);
    CHECK_NEAR(p->curve->acceleration(p, back), a, ulp);
    assert_true((back - p->begin) * (p->end - back) >= 0);
  }
}

/* l' is the derivative of l, l'' that of l': by differences that do not cross a seam */
static void check_derivatives(const struct scallop_piece *p, double peak)
{
  double range = p->end - p->begin, u = p->begin + 0.4 * range, h = 1e-4 * range,
         forward = p->anchor == SCALLOP_FROM_START ? 1 : -1;
  double rise = p->curve->length(p, u + h) - p->curve->length(p, u - h);
  double v = p->curve->velocity(p, u), bend = p->curve->velocity(p, u + h) - p->curve->velocity(p, u - h);
  double a = p->curve->acceleration(p, u), size = fabs(a) + peak / fabs(range);
  CHECK_NEAR(rise / (2 * h), forward * v, 1e-6 * fabs(range) * size + DBL_EPSILON / fabs(h));
  CHECK_NEAR(bend / (2 * h), forward * a, 1e-6 * size);
}

static void check_shape(const struct scallop_gait *gait, int kind, bool closely)
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
  if (shape->l0 != 0 || !first->jump) { /* but for constant speed */
    CHECK_EQUAL(first->curve->velocity(first, 0), 0);
    CHECK_EQUAL(last->curve->velocity(last, 0), 0);
  }
  CHECK_EQUAL(first->curve->acceleration(first, 0), shape->l0);
  CHECK_EQUAL(last->curve->acceleration(last, 0), shape->lT);
  for (int i = 0; i < shape->count; i++) {
    const struct scallop_piece *p = &shape->pieces[i];
    check_piece(p, shape->peak, closely);
    check_derivatives(p, shape->peak);
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

TEST(gaits_are_gaits)
{
  struct random r = { 20261201 };
  struct random_gait made;
  for (int i = 0; i < 100 * RANDOM_GAITS; i++) {
    const struct scallop_gait *gait = i < ALL_GAITS ? every_gait[i]
                                                    : random_gait(&r, (enum random_gait_kind)(i % RANDOM_GAITS), &made);
    for (int kind = 0; kind < 2; kind++)
      check_shape(gait, kind, i < ALL_GAITS);
  }
}

/* The gaits by their formulas, in an extension; a contraction is 1 - l. Their terms add up to at most
 * 31 (l), 15 (l') and 60 (l''), which the tolerances of gait_at_a_time follow. */
static void formulas(int gait, double s, double *l, double *v, double *a)
{
  bool early = s <= 0.5;
  double left = 1 - s, height = 16. / 13;
  switch (gait) {
  case 0: *l = early ? 2 * s * s : 1 - 2 * left * left, *v = 4 * (early ? s : left), *a = early ? 4 : -4; break;
  case 1: *l = 0.5 * (1 - cos(PI * s)), *v = 0.5 * PI * sin(PI * s), *a = 0.5 * PI * PI * cos(PI * s); break;
  case 2:
    *l = s < 0.25 ? 2 * height * s * s : s < 0.875 ? height * (s - 0.125) : 1 - 4 * height * left * left;
    *v = height * (s < 0.25 ? 4 * s : s < 0.875 ? 1 : 8 * left);
    *a = height * (s < 0.25 ? 4 : s < 0.875 ? 0 : -8);
    break;
  case 3:
    *l = s * s * s * (10 - 15 * s + 6 * s * s), *v = 30 * s * s * left * left, *a = 60 * s * left * (1 - 2 * s);
    break;
  default: *l = s, *v = 1, *a = 0;
  }
}

TEST(gait_at_a_time)
{
  struct random r = { 43 };
  for (int g = 0; g < ALL_GAITS; g++)
    for (int n = 0; n < 2000; n++) {
      double s = n == 0 ? 0 : n == 1 ? 1 : random_between(&r, 0, 1), want[3], l, v, a;
      double ulp = g == SAWTOOTH ? DBL_EPSILON / 32 : DBL_EPSILON;
      formulas(g, s, &want[0], &want[1], &want[2]);
      scallop_gait_at(every_gait[g], SCALLOP_EXTENSION, s, &l, &v, &a);
      CHECK_NEAR(l, want[0], 16 * ulp);
      CHECK_NEAR(v, want[1], 16 * ulp);
      CHECK_NEAR(a, want[2], 64 * ulp);
      scallop_gait_at(every_gait[g], SCALLOP_CONTRACTION, s, &l, NULL, NULL);
      CHECK_NEAR(l, 1 - want[0], 16 * ulp);
      scallop_gait_at(every_gait[g], SCALLOP_CONTRACTION, s, NULL, &v, NULL);
      CHECK_NEAR(v, -want[1], 16 * ulp);
      scallop_gait_at(every_gait[g], SCALLOP_CONTRACTION, s, NULL, NULL, &a);
      CHECK_NEAR(a, -want[2], 64 * ulp);
    }
}

/* Paper, section 4.3.3: L and pi^2 L/8; l_0 l_T/(2 (l_T - l_0)) with the sign of a length. */
TEST(kinematic_length)
{
  for (int kind = 0; kind < 2; kind++) {
    enum scallop_phase_kind k = (enum scallop_phase_kind)kind;
    CHECK_EQUAL(scallop_kinematic_length(&scallop_gait_quadratic, k, 2.385), 2.385);
    CHECK_RELATIVE(scallop_kinematic_length(&scallop_gait_sinusoidal, k, 2.385), PI * PI / 8 * 2.385, 4 * DBL_EPSILON);
    CHECK_RELATIVE(scallop_kinematic_length(&trapezoid_gait, k, 1), 64. / 13 * 128 / 13 / (2 * 192. / 13),
                   4 * DBL_EPSILON);
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

/* One gait by two names, or written out by hand, by laws of another kind. A trapezoid without a plateau and a skewed
 * gait that is not skewed have the very numbers of the quadratic gait; skewed is a trapezoid without a plateau, but for
 * the definition of the rest by 1 - beta; ramps of R are a trapezoid of R and R; a polynomial may have any scale. */
TEST(the_same_gait)
{
  FOR_CASES (one, "trapezoidal:0.5,0.5 = quadratic|skewed:0.5 = quadratic|constant:0.1 = trapezoidal:0.1,0.1|"
                  "skewed:0.375,0.6875 = trapezoidal:0.375,0.625,0.6875,0.3125|trapezoidal = trapezoidal:0.25,0.25|"
                  "constant:0.125,0.5 = trapezoidal:0.125,0.125,0.5,0.5|skewed = skewed:0.25,0.25|"
                  "constant:1e-9,0.2 = trapezoidal:1e-9,1e-9,0.2,0.2") {
    const char *other = wanted_of(one);
    check_same_motions(gait_of(one), gait_of(other), 0);
  }
  check_same_motions(gait_of("polynomial:0,0,1.0,-1.5,0.6"), &minimum_jerk_gait, 1e-12);
  check_same_motions(gait_of("polynomial:0,12,-4,-3"), &leaning_gait, 1e-12);
  check_same_motions(&scallop_gait_quadratic, &ramps_gait, 1e-12);
  assert_ptr_equal(gait_of("quadratic"), &scallop_gait_quadratic);
  assert_ptr_equal(gait_of("trapezoidal"), gait_of("trapezoidal"));
}

/* Pieces begin at doubles: 1 - 0.3 is none, so what falls is in two pieces; 0.375 beside it needs one. Neither 0.3 and
 * 0.7 nor 0.1 and 0.9 are doubles, and the sums of those are below and above 1: they are meant to be 1. 0.25 and 0.125
 * leave a plateau in two pieces, 0.75 and 0.125 in one. R = 0 is |l'| = 1 with jumps, in one phase or in both. */
TEST(pieces_of_straight_gaits)
{
  FOR_CASES (gait,
             "skewed:0.3,0.7 = 3 concave 2; 2 ramps 2|skewed:0.375 = 2 ramps 2; 2 ramps 2|"
             "trapezoidal:0.375,0.625 = 2 ramps 2; 2 ramps 2|trapezoidal:0.3,0.7,0.1,0.9 = 3 concave 2; 3 concave 2|"
             "trapezoidal:0.25,0.125,0.75,0.125 = 4 concave 1.2307692307692308; 3 concave "
             "1.7777777777777777|constant:0 = 2 jump 1; 2 jump 1|"
             "constant:0,0.5 = 2 jump 1; 2 jump 2|constant:0.25,0 = 4 jump 1.3333333333333333; 2 jump 1") {
    const char *wanted = wanted_of(gait);
    char got[LONGEST_CASE] = "";
    for (int kind = 0; kind < 2; kind++) {
      const struct scallop_shape *shape = &gait_of(gait)->phase[kind];
      const char *what = shape->pieces[0].jump ? "jump" : shape->ramps ? "ramps" : shape->concave ? "concave" : "none";
      check_shape(gait_of(gait), kind, false);
      assert_true(!shape->pieces[1].jump && (!shape->pieces[0].jump || !(shape->ramps || shape->concave)));
      CHECK_EQUAL(shape->net, kind == SCALLOP_EXTENSION ? 1 : -1);
      snprintf(got + strlen(got), sizeof got - strlen(got), "%s%d %s %.17g", kind ? "; " : "", shape->count, what,
               shape->peak);
    }
    assert_string_equal(got, wanted);
  }
}

/* One number that is not allowed, among others of 1/4 */
TEST(bad_straight_gaits)
{
  enum { BAD = 8 };
  static const struct {
    const struct scallop_gait_family *family;
    double bad[BAD];
  } refused[] = {
    { &scallop_family_trapezoidal, { 0, -0.1, 1, 1.5, 0x1p-101, NAN, INFINITY, 0.75 + 0x1p-52 } },
    { &scallop_family_skewed, { 0, -0.1, 1, 1.5, 0x1p-101, NAN, INFINITY, -INFINITY } },
    { &scallop_family_constant, { 0.5 + 0x1p-53, -0.1, 1, 1.5, 0x1p-101, NAN, INFINITY, -INFINITY } },
  };
  union scallop_made_gait made;
  const char *why;
  for (int f = 0; f < 3; f++)
    for (int at = 0; at < 2 * refused[f].family->each; at++)
      for (int i = 0; i <= BAD; i++) {
        double x[4] = { 0.25, 0.25, 0.25, 0.25 };
        x[at] = i < BAD ? refused[f].bad[i] : 0x1p-100;
        assert_int_equal(scallop_make_gait(&made, refused[f].family, "", x, 2 * refused[f].family->each, &why),
                         i < BAD ? SCALLOP_EDOMAIN : SCALLOP_OK);
      }
}

/* Every family: its sample is one of its gaits; how many numbers it takes, and that those of the extension hold for the
 * contraction. Two have no numbers, and are known by their names alone. */
TEST(families)
{
  static union scallop_made_gait one, two;
  const struct scallop_gait_family *family;
  const double x[SCALLOP_GAIT_NUMBERS + 1] = { 0.125, 0.25, 0.375, 0.0625 };
  const char *why;
  int fixed = 0;
  assert_null(scallop_gait_family(-1));
  assert_true(scallop_made_gait_size == sizeof one);
  for (int i = 0; (family = scallop_gait_family(i)) != NULL; i++) {
    const struct scallop_gait *sample = gait_of(family->sample);
    int each = family->each;
    assert_int_equal(strncmp(family->sample, family->name, strlen(family->name)), 0);
    assert_true(family->sentence && !family->numbers == !family->allowed && !family->fixed == (family->make != NULL));
    assert_true(!family->fixed || (family->fixed == sample && scallop_gait_named(sample->name) == sample));
    assert_true(!family->fixed || strcmp(scallop_gait_name(fixed++), family->name) == 0);
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
  assert_int_equal(fixed, 2);
  assert_true(!scallop_gait_name(-1) && !scallop_gait_name(fixed) && !scallop_gait_name(1000));
  assert_true(!scallop_gait_named("Quadratic") && !scallop_gait_named(""));
}

/* Two zeros of l', 1e-4 apart, and nearly two more near the end: each has its piece. Their distance is from a search
 * for all zeros in 60 digits, of C1 + 2 C2 s + ... less its value at the end times s^6. */
TEST(two_zeros_and_almost_two)
{
  const struct scallop_shape *shape = &gait_of("polynomial:0,0.15456065558773208,-0.67635268360914214,"
                                               "1.3060806298739194,-1.3195741346534107,0.68224748223722309,"
                                               "-0.14285714285714285")
                                           ->phase[SCALLOP_EXTENSION];
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
  static struct random_gait made;
  assert_int_equal(scallop_spline_pieces((const int[2]){ 3, 2 }), 5);
  assert_int_equal(spline_through(&made, good, 3, back, 2), SCALLOP_OK);
  assert_int_equal(spline_through(&made, good, 1, back, 2), SCALLOP_EDOMAIN);
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    struct scallop_knot knots[3] = { good[0], good[1], good[2] };
    knots[bad[i].at] = bad[i].knot;
    if (spline_through(&made, knots, 3, back, 2) != SCALLOP_EDOMAIN)
      fail_msg("knot %d: %g %g %g", bad[i].at, bad[i].knot.time, bad[i].knot.length, bad[i].knot.slope);
  }
}

/* Once up and down |l'| is concave; with a rest, or a way back, it is not. */
TEST(concave_splines)
{
  const struct scallop_knot out[3][4] = { { { 0, 0, 0 }, { 0.5, 0.5, 1.5 }, { 1, 1, 0 } },
                                          { { 0, 0, 0 }, { 0.25, 0.5, 0 }, { 0.5, 0.5, 0 }, { 1, 1, 0 } },
                                          { { 0, 0, 0 }, { 0.25, 0.75, 0 }, { 0.5, 0.5, 0 }, { 1, 1, 0 } } },
                            back[3] = { { 0, 1, 0 }, { 0.5, 0.5, -1.5 }, { 1, 0, 0 } };
  static struct random_gait made;
  for (int i = 0; i < 3; i++) {
    assert_int_equal(spline_through(&made, out[i], i == 0 ? 3 : 4, back, 3), SCALLOP_OK);
    const struct scallop_shape *phase = made.spline.gait.phase;
    assert_int_equal(phase[SCALLOP_EXTENSION].concave, i == 0);
    assert_true(phase[SCALLOP_CONTRACTION].concave);
    CHECK_EQUAL(phase[SCALLOP_EXTENSION].net, 1 - i * 0.25); /* the share of the phase there, minus that back */
  }
}

/* The extension is over at half of its phase, and l rests for the other half: friction then takes (F1 + F2) tau/2 / M
 * from the velocity that both bodies have, but no more than there is. What comes before is a phase of half the duration
 * with the same cubic, 3 s^2 - 2 s^3. */
TEST(rest_at_the_end)
{
  const struct scallop_knot out[3] = { { 0, 0, 0 }, { 0.5, 1, 0 }, { 1, 1, 0 } },
                            back[2] = { { 0, 1, 0 }, { 1, 0, 0 } };
  static struct random_gait made;
  assert_int_equal(spline_through(&made, out, 3, back, 2), SCALLOP_OK);
  const struct scallop_shape *extension = &made.spline.gait.phase[0];
  assert_int_equal(extension->pieces[extension->count - 1].direction, 0);
  CHECK_EQUAL(extension->net, 0.5);
  struct random r = { 20261204 };
  for (int i = 0; i < 300; i++) {
    struct scallop_crawler c = random_crawler(&r, i % 2 ? STICK_SLIP : ORDINARY, &made.spline.gait), d = c;
    double tau = scallop_phase_duration(&c, SCALLOP_EXTENSION), v0 = random_start(&r, &c, SCALLOP_EXTENSION);
    d.gait = gait_of("polynomial:0,3,-2");
    d.T = c.T / 2;
    struct scallop_phase_result p = phase_of(&c, SCALLOP_EXTENSION, v0), q = phase_of(&d, SCALLOP_EXTENSION, v0);
    double brake = (c.F1 + c.F2) / (c.m1 + c.m2), time = fmin(tau / 2, fabs(q.v_end) / brake),
           size = c.L + (fabs(v0) + c.L / tau) * tau;
    double v = copysign(fabs(q.v_end) - brake * time, q.v_end),
           x = copysign((fabs(q.v_end) + fabs(v)) / 2 * time, q.v_end);
    CHECK_NEAR(p.v_end, time < tau / 2 ? 0 : v, 1e-13 * size / tau);
    CHECK_NEAR(p.dxC, q.dxC + x, 1e-13 * size);
  }
}

/* With l'' = 0 at the ends a body that starts from rest, and is held at first, turns back before the end by a time that
 * goes as T^2: at T = 1e-80 by 1e-81 of the phase, in a piece that takes a fifth of it. */
TEST(turns_next_to_the_ends)
{
  struct scallop_crawler c = { 2.1585372372426566, 0.4367960174828488,     1.6360601029330115,
                               6.624494351254064,  1.1004164832244088,     0x1p-80,
                               0.8403785467147827, gait_of("minimum-jerk") };
  struct scallop_phase_result got, wanted = phase_of(&c, SCALLOP_EXTENSION, 0);
  for (int k = 20; k <= 180; k += 40) {
    c.T = ldexp(1, -80 - k);
    got = phase_of(&c, SCALLOP_EXTENSION, 0);
    CHECK_NEAR(ldexp(got.dT, 2 * k), wanted.dT, 1e-13 * wanted.dT);
    CHECK_NEAR(ldexp(got.t1, 3 * k), wanted.t1, 1e-13 * wanted.t1);
    CHECK_NEAR(got.dxC, wanted.dxC, 1e-15 * c.L);
  }
}

/* What mirrors and what is reversible */
TEST(symmetric_gaits)
{
  FOR_CASES (gait,
             "quadratic = both|sinusoidal = both|constant:0 = both|trapezoidal = both|trapezoidal:0.2,0.3 = mirrors|"
             "trapezoidal:0.2,0.2,0.3,0.3 = reversible|trapezoidal:0.2,0.3,0.3,0.2 = none|skewed:0.5 = both|"
             "skewed:0.3 = mirrors|skewed:0.3,0.7 = none|minimum-jerk = both|polynomial:0,0.5,0,-0.25 = mirrors|"
             "polynomial:0,-0.1,0.4,-0.25 = mirrors") {
    const char *wanted = wanted_of(gait);
    bool mirrors = scallop_gait_mirrors(gait_of(gait)), reversible = scallop_gait_is_reversible(gait_of(gait));
    const char *got = mirrors && reversible ? "both" : mirrors ? "mirrors" : reversible ? "reversible" : "none";
    if (strcmp(got, wanted) != 0)
      fail_msg("%s: %s", gait, got);
  }
  assert_false(scallop_gait_is_reversible(&parabola_gait)); /* one piece, anchored at one end: it is, unseen */
}

/* Every number that |l'| depends on: changed in one piece of one phase it ends both symmetries. */
TEST(gaits_that_are_not_symmetric)
{
  enum { CHANGES = 8 };
  for (int change = 0; change < 4 * CHANGES; change++) {
    const int kind = change / CHANGES / 2, piece = change / CHANGES % 2;
    struct scallop_gait gait = change % CHANGES == 0 ? scallop_gait_sinusoidal : scallop_gait_quadratic;
    struct scallop_piece pieces[2], *p = &pieces[piece];
    memcpy(pieces, gait.phase[kind].pieces, sizeof pieces);
    gait.phase[kind].pieces = pieces;
    assert_true(scallop_gait_mirrors(&gait) && scallop_gait_is_reversible(&gait));
    switch (change % CHANGES) {
    case 0: p->law = scallop_gait_quadratic.phase[0].pieces[0].law; break;
    case 1: p->begin += 0.125; break;
    case 2: p->end += 0.125; break;
    case 3: p->velocity = 0.5; break;
    case 4: p->acceleration *= 0.5; break;
    case 5: p->linear = false; break;
    case 6: p->anchor = p->anchor == SCALLOP_FROM_START ? SCALLOP_FROM_END : SCALLOP_FROM_START; break;
    default: gait.phase[kind].count = 1;
    }
    assert_false(scallop_gait_mirrors(&gait) || scallop_gait_is_reversible(&gait));
  }
}

/* Every number of a law counts but its base and what lies behind its degree. */
TEST(laws_are_compared)
{
  enum { MOST = SCALLOP_LAW_MOST_DEGREE, RAMP = 1, BERNSTEIN, LAWS = 4 };
  static const int numbers[LAWS] = { MOST + 2, 6, MOST + 4, 0 };
  const double more[2] = { 8, 9 };
  const struct scallop_law laws[LAWS] = {
    { SCALLOP_LAW_POLYNOMIAL, 2, .polynomial = { { 1, 2, 3, 4 }, 5 } },
    { SCALLOP_LAW_RAMP, 1, .ramp = { 1, 2, 3, { 4, 5, 6 } } },
    { SCALLOP_LAW_BERNSTEIN, 2, .bernstein = { { 1, 2, 3, 4 }, 5, 6, 7, .implied = 1, .more_count = 2, .more = more } },
    { .kind = SCALLOP_LAW_SINE },
  };
  struct scallop_law other;
  for (int i = 0; i < LAWS; i++) {
    for (int k = 0; k < LAWS; k++) {
      other = laws[k];
      other.base++;
      assert_int_equal(law_same(&laws[i], &other), i == k);
      other.degree--;
      assert_false(law_same(&laws[i], &other));
    }
    for (int k = 0; k < numbers[i]; k++) {
      other = laws[i];
      ((double *)&other.polynomial)[k] += 0.5;
      assert_int_equal(law_same(&laws[i], &other), i != RAMP && k > 2 && k <= MOST);
    }
  }
  for (int change = 0; change < 5; change++) {
    const double copy[2] = { change == 1 ? 8.5 : 8, change == 2 ? 9.5 : 9 };
    other = laws[BERNSTEIN];
    other.bernstein.more = copy;
    other.bernstein.implied += change == 3;
    other.bernstein.more_count -= change == 4;
    assert_int_equal(law_same(&laws[BERNSTEIN], &other), change == 0);
  }
}

static const char path[] = "gait";
static char text[64];

/* The gait measured in a file of these bytes, by the choices behind its name. Each file has another name: what was read
 * once is not read again. */
static struct gait_result measured(const char *bytes, size_t size, const char *choices)
{
  static int number;
  char name[24];
  snprintf(name, sizeof name, "%s%d", path, number++);
  FILE *file = fopen(name, "w");
  assert_non_null(file);
  assert_int_equal(fwrite(bytes, 1, size, file), size);
  assert_int_equal(fclose(file), 0);
  snprintf(text, sizeof text, "measured:%s%s", name, choices);
  struct gait_result answer = gait_of_text(text);
  assert_int_equal(remove(name), 0);
  return answer;
}

static struct gait_result monotone(const char *table) { return measured(table, strlen(table), ":monotone"); }

TEST(bad_files)
{
  FOR_CASES (table,
             " = : fewer than four rows|# nothing\n\n = : fewer than four rows|t l\n0 0\n = : fewer than four rows|"
             "0 0\n1 1\n2 0\n = : fewer than four rows|0 0\n1 1\n2 0\n2 1\n = : fewer than four rows|"
             "0 0\n1 inf\n2 0.5\n3 0\n = :2: column 2, 'inf', is not a finite number|"
             "0 0\n1 1e999\n2 0.5\n3 0\n = :2: column 2, '1e999', is not a finite number|"
             "0 0\n1 1\n2 x\n3 0\n = :3: column 2, 'x', is not a finite number|"
             "t l\n0 0\n1 1\ny 0.5\n3 0\n = :4: column 1, 'y', is not a finite number|"
             "0 0 1\n1 1 7\n2 0.5 1\n3 0 1\n = :1: 3 columns without a header|"
             "t x\n0 0\n1 1\n2 0.5\n3 0\n = : no columns are named t and l, or t, x1 and x2|"
             "t x1\n0 0\n1 1\n2 0.5\n3 0\n = : no columns are named t and l, or t, x1 and x2|"
             "0 0\n1 1\n2 3\n3 4\n4 5\n5 7\n = : not periodic|0 1\n1 1\n2 1\n3 1\n = : l is the same throughout|"
             "0 0\n1 1\n2 -1e308\n3 1e308\n4 0\n = : the range") {
    const char *says = wanted_of(table);
    struct gait_result a = monotone(table);
    assert_null(a.gait);
    assert_int_equal(a.fault, GAIT_UNKNOWN);
    if (!strstr(a.wrong, path) || !strstr(a.wrong, says))
      fail_msg("%s, and not %s", a.wrong, says);
  }
  assert_non_null(strstr(measured("0 0\n1 1\0\n2 0\n", 12, "").wrong, ":2: this is not a text file"));
}

TEST(files_that_cannot_be_read)
{
  assert_int_equal(gait_of_text("measured:/nowhere/at/all").fault, GAIT_UNREADABLE);
  assert_int_equal(gait_of_text("measured:/tmp").fault, GAIT_UNREADABLE);
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
  struct gait_result a = measured(table, size, "");
  assert_null(a.gait);
  assert_non_null(strstr(a.wrong, ":100001: more than 100000 rows"));
  free(table);
}

/* Comments, blank lines, a header, any blanks, CRLF; the period begins at the minimum. */
TEST(a_good_file)
{
  struct gait_result a = monotone("# a comment\r\n\r\nt\tl\r\n 1 3\n2 \t 5\n# more\n3 2\n5 1\n6 2\n11 3.0000000001\n");
  double l[3];
  assert_non_null(a.gait);
  scallop_gait_at(a.gait, SCALLOP_EXTENSION, 1. / 7, &l[0], NULL, NULL);
  scallop_gait_at(a.gait, SCALLOP_EXTENSION, 6. / 7, &l[1], NULL, NULL);
  scallop_gait_at(a.gait, SCALLOP_CONTRACTION, 1. / 3, &l[2], NULL, NULL);
  for (int i = 0; i < 3; i++)
    CHECK_NEAR(l[i], i == 1 ? 0.5 : 0.25, 1e-15);
  assert_ptr_equal(gait_of(text), a.gait);
  assert_string_equal(a.gait->name, text);
  assert_null(gait_file_of(&scallop_gait_quadratic));
}

/* The same gait however it is written: l goes from 1 to 5 and back in T = 10, and out from t = 5 to t = 2, a period
 * later. */
TEST(the_same_recording)
{
  FOR_CASES (table,
             "0 3\n1 5\n2 2\n4 1\n5 2\n10 3\n|# 1\r\n\r\nt\tl\r\n 1 3\n2 \t 5\n# 2\n3 2\n5 1\n6 2\n11 3.0000000001\n|"
             "0 3\n4 1\n1 5\n2 2\n10 3\n5 2\n|time [s],length (mm)\n0,3\n1,5\n2,2\n4,1\n5,2\n10,3\n|"
             "t [s]   x1 [m]   x2 [m]\n0 1 4\n1 0 5\n2 -1 1\n4 0 1\n5 2 4\n10 0 3\n|"
             "n,x2,t,x1\n1,4,0,1\n2,5,1,0\n3,1,2,-1\n4,1,4,0\n5,4,5,2\n6,3,10,0\n|"
             "t,l\n0,3\n1,5\n1.5,\n2,2\n3,NaN\n4,1\n5,2\n10,3\n|t l\n0 3\n1 4\n1 6\n2 2\n4 1\n5 2\n10 3\n") {
    const struct gait_result a = monotone(table);
    const struct gait_file *file = a.gait ? gait_file_of(a.gait) : NULL;
    if (!file || file->best.L != 4 || file->best.T != 10 || file->best.alpha != 0.7)
      fail_msg("%s: %s", table, file ? "other numbers" : a.wrong);
  }
}

/* A kind and its noise, and the period, are told from the name of a file that has a colon: T, or 0 if there is no such
 * file. */
TEST(choices)
{
  static const char table[] = "0 0\n.3 .5\n.7 1\n1 1.3\n1.3 1.7\n1.7 1.9\n2 2\n2.3 1.6\n2.6 1.2\n3 .6\n3.4 .4\n"
                              "3.7 .2\n3.9 .1\n4 0\n";
  FOR_CASES (choice,
             " = 4|:cubic = 4|:smooth = 4|:phases=0.01 = 4|:smooth=0.01:period=5 = 5|:period=8 = 8|:cubic=0.1 = 0|"
             ":smooth=-1 = 0|:spline = 0|:period=0 = 0") {
    double T = strtod(wanted_of(choice), NULL);
    const struct gait_result a = measured(table, sizeof table - 1, choice);
    if (a.gait ? gait_file_of(a.gait)->best.T != T : T != 0 || a.fault != GAIT_UNREADABLE)
      fail_msg("%s: %s", choice, a.wrong);
  }
}

/* What is no gait, and what is said of it. l' = s (1 - s) (1/2 - s)^2 touches 0; (1/3 - s)^2 too, but for rounding. */
TEST(bad_texts)
{
  struct scallop_polynomial g;
  const char *why = "";
  FOR_CASES (
      name,
      "trapezodal = did you mean 'trapezoidal'|skewed:0.3x = '0.3x' is not a number|skewed:0.1,0.2,0.3 = skewed:BETA|"
      "trapezoidal:0.1,0.2,0.3 = UP + DOWN|trapezoidal:0.6,0.5 = UP + DOWN|polynomial:0, = '' is not a number|"
      "minimum-jerk:1 = did you mean 'minimum-jerk'|polynomial = polynomial:C1,C2|polynomial:0,1 = degree|"
      "polynomial:0,0,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1 = degree|polynomial:0,0,0 = degree|"
      "polynomial:1,3,-2.3333333333333335 = start|polynomial:0,3,-2.0000000000000013 = end|"
      "polynomial:0,-3,2 = positive|polynomial:0,0.125,-0.4166666666666667,0.5,-0.2 = so near to 0|"
      "polynomial:0,0.05555555555555555,-0.25925925925925924,0.4166666666666667,-0.2 = so near to 0") {
    const char *says = wanted_of(name);
    struct gait_result a = gait_of_text(name);
    assert_null(a.gait);
    if (!strstr(a.wrong, says))
      fail_msg("%s, and not %s", a.wrong, says);
  }
  for (int i = 0; i < 2; i++) {
    const double c[] = { 0, 0, i == 0 ? NAN : INFINITY, 2 };
    assert_int_equal(scallop_make_polynomial(&g, "", c, 3, NULL), SCALLOP_EDOMAIN);
    assert_int_equal(scallop_make_polynomial(&g, "", c, 3, &why), SCALLOP_EDOMAIN);
    assert_non_null(strstr(why, "finite"));
  }
}

/* A gait measured at 2n + 1 equally spaced points of l, which is given over the extension and goes the same way back */
static const struct scallop_gait *sampled(double (*l)(double s), int n)
{
  char table[32768];
  size_t size = 0;
  for (int i = 0; i <= 2 * n; i++)
    size += (size_t)snprintf(table + size, sizeof table - size, "%d %.17g\n", i,
                             l(i <= n ? (double)i / n : 2 - (double)i / n));
  struct gait_result a = monotone(table);
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

static double wave(double s) { return 0.5 - 0.5 * cos(PI * s); }
static double parabolas(double s) { return s < 0.5 ? 2 * s * s : 1 - 2 * (1 - s) * (1 - s); }

/* Steffen's slope is that of the parabola through three points, to second order, unless twice a secant is less, which
 * where |l'| is concave from 0 it is not: so l' is right to second order. The steady state follows. */
TEST(samples_of_the_sinusoidal_gait)
{
  struct scallop_crawler c, d = with_gait(&scallop_gait_sinusoidal);
  double last = worst_velocity(sampled(wave, 8), d.gait);
  for (int n = 16; n <= 256; n *= 2) {
    c = with_gait(sampled(wave, n));
    double now = worst_velocity(c.gait, d.gait);
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

int main(void) { return check_run(scratch_begin, scratch_end); }
