/* Gaits, the validation of a crawler and its scaling. */
#include <float.h>

#include "model/model.h"
#include "tests/support/odd_gaits.h"
#include "tests/support/solved.h"

#define PI 3.14159265358979323846
#define ULP DBL_EPSILON

typedef void piece_test(const struct scallop_shape *shape, const struct scallop_piece *piece);

static void for_pieces(piece_test *test)
{
  for (int g = 0; g < ALL_GAITS; g++)
    for (int kind = 0; kind < 2; kind++) {
      const struct scallop_shape *shape = &every_gait[g]->phase[kind];
      for (int i = 0; i < shape->count; i++)
        test(shape, &shape->pieces[i]);
    }
}

static double inside(const struct scallop_piece *p, double x) { return p->begin + (p->end - p->begin) * x; }

/* l'' is monotone in a piece, and `when` finds where it has a value. Compared as values of l'', since
 * where l'' turns a rounding of it moves u by far more. */
static void when_inverts(const struct scallop_shape *shape, const struct scallop_piece *p)
{
  (void)shape;
  double at_begin = p->curve->acceleration(p, p->begin), at_end = p->curve->acceleration(p, p->end);
  double high = fmax(at_begin, at_end), low = fmin(at_begin, at_end), past = fmax(1, high - low);
  assert_true(isnan(p->curve->when(p, high + past)));
  assert_true(isnan(p->curve->when(p, low - past)));
  if (p->linear) {
    CHECK_EQUAL(p->curve->when(p, high), p->begin);
    return;
  }
  double last = at_begin;
  for (int k = 1; k < 200; k++) {
    double u = inside(p, k / 200.), a = p->curve->acceleration(p, u), back = p->curve->when(p, a);
    assert_true((a - last) * (at_end - at_begin) > 0);
    last = a;
    CHECK_NEAR(p->curve->acceleration(p, back), a, 8 * ULP * fmax(fabs(low), fabs(high)));
    assert_true((back - p->begin) * (p->end - back) >= 0);
  }
}

TEST(when_inverts_acceleration) { for_pieces(when_inverts); }

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
  for (int g = 0; g < SMOOTH_GAITS; g++)
    for (int n = 0; n < 2000; n++) {
      double s = n == 0 ? 0 : n == 1 ? 1 : random_between(&r, 0, 1), want[3], l, v, a;
      formulas(g, s, &want[0], &want[1], &want[2]);
      scallop_gait_at(every_gait[g], SCALLOP_EXTENSION, s, &l, &v, &a);
      CHECK_NEAR(l, want[0], 16 * ULP);
      CHECK_NEAR(v, want[1], 16 * ULP);
      CHECK_NEAR(a, want[2], 64 * ULP);
      scallop_gait_at(every_gait[g], SCALLOP_CONTRACTION, s, &l, NULL, NULL);
      CHECK_NEAR(l, 1 - want[0], 16 * ULP);
      scallop_gait_at(every_gait[g], SCALLOP_CONTRACTION, s, NULL, &v, NULL);
      CHECK_NEAR(v, -want[1], 16 * ULP);
      scallop_gait_at(every_gait[g], SCALLOP_CONTRACTION, s, NULL, NULL, &a);
      CHECK_NEAR(a, -want[2], 64 * ULP);
    }
}

/* A linear piece that does not touch its anchor: right up to a constant, which is all the solver uses. */
TEST(linear_length_in_the_middle)
{
  const struct scallop_piece *middle = &trapezoid_gait.phase[SCALLOP_EXTENSION].pieces[1];
  for (double u = 0.25; u <= 0.875; u += 0.125)
    CHECK_NEAR(scallop_curve_linear.length(middle, u) - scallop_curve_linear.length(middle, 0.25), 16 * (u - 0.25) / 13,
               2 * ULP);
}

TEST(names)
{
  assert_ptr_equal(scallop_gait_named("quadratic"), &scallop_gait_quadratic);
  assert_ptr_equal(scallop_gait_named("sinusoidal"), &scallop_gait_sinusoidal);
  assert_null(scallop_gait_named("Quadratic"));
  assert_null(scallop_gait_named(""));
  int count = 0;
  for (; scallop_gait_name(count); count++)
    assert_string_equal(scallop_gait_named(scallop_gait_name(count))->name, scallop_gait_name(count));
  assert_int_equal(count, 2);
  assert_null(scallop_gait_name(-1));
  assert_null(scallop_gait_name(1000));
}

/* Paper, section 4.3.3: L and pi^2 L/8; l_0 l_T/(2 (l_T - l_0)) with the sign of a length. */
TEST(kinematic_length)
{
  for (int kind = 0; kind < 2; kind++) {
    enum scallop_phase_kind k = (enum scallop_phase_kind)kind;
    CHECK_EQUAL(scallop_kinematic_length(&scallop_gait_quadratic, k, 2.385), 2.385);
    CHECK_RELATIVE(scallop_kinematic_length(&scallop_gait_sinusoidal, k, 2.385), PI * PI / 8 * 2.385, 4 * ULP);
    CHECK_RELATIVE(scallop_kinematic_length(&trapezoid_gait, k, 1), 64. / 13 * 128 / 13 / (2 * 192. / 13), 4 * ULP);
  }
}

static void complains(const struct scallop_crawler *c, const char *name, double given)
{
  struct scallop_complaint complaint = { NULL, 0, NULL };
  assert_int_equal(scallop_crawler_check(c, &complaint), SCALLOP_EDOMAIN);
  assert_string_equal(complaint.name, name);
  CHECK_EQUAL(complaint.given, given);
  assert_non_null(complaint.allowed);
  assert_int_equal(scallop_crawler_check(c, NULL), SCALLOP_EDOMAIN);
  REFUSES(scallop_scaled, scallop_scale(c, &out), SCALLOP_EDOMAIN);
}

TEST(validation)
{
  const char *const name[] = { "m1", "m2", "F1", "F2", "L", "T", "alpha" };
  const double bad[] = { NAN, INFINITY, -INFINITY, 0, -0.0, -2.385, -DBL_TRUE_MIN };
  for (int i = 0; i < PARAMETERS; i++)
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
      struct scallop_crawler c = scallop_crawler_default();
      *parameter(&c, i) = bad[k];
      complains(&c, name[i], bad[k]);
      if (i + 1 < PARAMETERS) { /* the first bad one is named */
        *parameter(&c, i + 1) = -1;
        complains(&c, name[i], bad[k]);
      }
    }
  struct scallop_crawler c = scallop_crawler_default();
  c.alpha = 1;
  complains(&c, "alpha", 1);
  c.alpha = 1 + ULP;
  complains(&c, "alpha", 1 + ULP);
  c = scallop_crawler_default();
  c.gait = NULL;
  complains(&c, "gait", NAN);
}

TEST(good_crawlers_leave_the_complaint_alone)
{
  struct scallop_complaint complaint = { "untouched", 2.385, NULL };
  struct scallop_crawler c = scallop_crawler_default();
  assert_int_equal(scallop_crawler_check(&c, &complaint), SCALLOP_OK);
  assert_string_equal(complaint.name, "untouched");
  c.alpha = 1 - ULP / 2;
  c.m1 = DBL_TRUE_MIN;
  c.F2 = DBL_MAX;
  assert_int_equal(scallop_crawler_check(&c, &complaint), SCALLOP_OK);
  assert_int_equal(scallop_crawler_check(&c, NULL), SCALLOP_OK);
}

TEST(defaults)
{
  struct scallop_crawler c = scallop_crawler_default();
  const double wanted[PARAMETERS] = { 1, 1, 4, 1, 10, 1, 0.75 };
  for (int i = 0; i < PARAMETERS; i++)
    CHECK_EQUAL(*parameter(&c, i), wanted[i]);
  assert_ptr_equal(c.gait, &scallop_gait_quadratic);
  CHECK_EQUAL(scallop_phase_duration(&c, SCALLOP_EXTENSION), 0.75);
  CHECK_EQUAL(scallop_phase_duration(&c, SCALLOP_CONTRACTION), 0.25);
}

TEST(scaled_values)
{
  struct random r = { 44 };
  for (int n = 0; n < 2000; n++) {
    struct scallop_crawler c = random_crawler(&r, (enum family)(n % FAMILIES), &scallop_gait_quadratic);
    long double M = (long double)c.m1 + c.m2, F = (long double)c.F1 + c.F2;
    struct scallop_scaled s;
    assert_int_equal(scallop_scale(&c, &s), SCALLOP_OK);
    CHECK_RELATIVE(s.mu1, (double)(c.m1 / M), 2 * ULP);
    CHECK_RELATIVE(s.mu2, (double)(c.m2 / M), 2 * ULP);
    CHECK_RELATIVE(s.f1, (double)(c.F1 / F), 2 * ULP);
    CHECK_RELATIVE(s.f2, (double)(c.F2 / F), 2 * ULP);
    /* small differences to full relative accuracy */
    CHECK_RELATIVE(s.mu_difference, (double)(((long double)c.m1 - c.m2) / M), 2 * ULP);
    CHECK_RELATIVE(s.delta, (double)(((long double)c.F1 - c.F2) / F), 2 * ULP);
    CHECK_RELATIVE(s.eps, (double)((long double)c.T * c.T * F / (M * c.L)), 4 * ULP);
    CHECK_EQUAL(s.fraction[SCALLOP_EXTENSION], c.alpha);
    CHECK_EQUAL(s.fraction[SCALLOP_CONTRACTION], 1 - c.alpha);
    assert_ptr_equal(s.gait, c.gait);
  }
}

/* ERANGE and nothing written, or eps to a few ulp: never fewer digits in silence. */
static void scale_or_refuse(const struct scallop_crawler *c, bool must_refuse)
{
  struct scallop_scaled s;
  if (must_refuse || scallop_scale(c, &s) != SCALLOP_OK) {
    REFUSES(scallop_scaled, scallop_scale(c, &out), SCALLOP_ERANGE);
    return;
  }
  long double M = (long double)c->m1 + c->m2, F = (long double)c->F1 + c->F2;
  CHECK_RELATIVE(s.eps, (double)((long double)c->T * c->T * F / (M * c->L)), 4 * ULP);
}

TEST(range)
{
  const struct scallop_gait *g = &scallop_gait_quadratic;
  const struct scallop_crawler refused[] = {
    { 1, 1, 4, 1, 10, 1e160, 0.5, g },         /* eps overflows                */
    { 1, 1, 4, 1, 10, 1e-160, 0.5, g },        /* eps underflows               */
    { 1, 1, 1e-300, 1e-300, 1e8, 1, 0.5, g },  /* eps is subnormal             */
    { 1e-309, 1e300, 4, 1, 10, 1, 0.5, g },    /* m1/M underflows              */
    { 1, 1e-309, 4, 1, 10, 1, 0.5, g },        /* m2/M is subnormal            */
    { 1, 1, 1e300, 1e-20, 10, 1, 0.5, g },     /* F2/F underflows              */
    { DBL_MAX, DBL_MAX, 4, 1, 10, 1, 0.5, g }, /* M overflows                  */
    { 1, 1, DBL_MAX, DBL_MAX, 10, 1, 0.5, g }, /* F1 + F2 overflows            */
  };
  for (size_t k = 0; k < sizeof refused / sizeof *refused; k++)
    scale_or_refuse(&refused[k], true);
  struct random r = { 45 };
  for (int n = 0; n < 20000; n++) {
    double size = random_decades(&r, 1e-300, 1e300), force = random_decades(&r, 1e-300, 1e300);
    struct scallop_crawler c = { size, size, force, force, 1, 1, 0.5, g };
    c.m2 *= random_between(&r, 0.5, 2);
    c.F2 *= random_between(&r, 0.5, 2);
    c.L = random_decades(&r, 1e-300, 1e300);
    c.T = random_decades(&r, 1e-300, 1e300);
    scale_or_refuse(&c, false);
  }
}

TEST(status_texts)
{
  for (int status = SCALLOP_EUNDECIDED; status <= SCALLOP_INTERVAL; status++)
    for (int other = status + 1; other <= SCALLOP_STOPPED; other++)
      assert_string_not_equal(scallop_status_text((enum scallop_status)status),
                              scallop_status_text((enum scallop_status)other));
  assert_string_equal(scallop_status_text(SCALLOP_ESTOPPED), scallop_status_text(SCALLOP_STOPPED));
  assert_string_equal(scallop_status_text((enum scallop_status)99), "unknown status");
}

/* The quadratic gait, pieces of which can be changed */
struct copied_gait {
  struct scallop_piece pieces[2][2];
  struct scallop_gait gait;
};
static void copy_gait(struct copied_gait *to, const struct scallop_gait *from)
{
  to->gait = *from;
  for (int kind = 0; kind < 2; kind++) {
    memcpy(to->pieces[kind], from->phase[kind].pieces, sizeof to->pieces[kind]);
    to->gait.phase[kind].pieces = to->pieces[kind];
  }
}

TEST(symmetric_gaits)
{
  for (int g = 0; g < ALL_GAITS; g++)
    assert_true(scallop_gait_mirrors(every_gait[g]));
  assert_true(scallop_gait_is_reversible(&scallop_gait_quadratic));
  assert_true(scallop_gait_is_reversible(&scallop_gait_sinusoidal));
  assert_true(scallop_gait_is_reversible(&minimum_jerk_gait));
  assert_false(scallop_gait_is_reversible(&trapezoid_gait));
  assert_true(scallop_gait_is_reversible(&sawtooth_gait));
  assert_false(scallop_gait_is_reversible(&parabola_gait)); /* one piece, anchored at one end: it is, unseen */
}

/* Every number that |l'| depends on: changed in one piece of one phase it ends both symmetries. */
TEST(gaits_that_are_not_symmetric)
{
  struct copied_gait c;
  for (int kind = 0; kind < 2; kind++)
    for (int piece = 0; piece < 2; piece++)
      for (int change = 0; change < 6; change++) {
        copy_gait(&c, &scallop_gait_quadratic);
        assert_true(scallop_gait_mirrors(&c.gait) && scallop_gait_is_reversible(&c.gait));
        struct scallop_piece *p = &c.pieces[kind][piece];
        switch (change) {
        case 0: p->begin += 0.125; break;
        case 1: p->end += 0.125; break;
        case 2: p->velocity = 0.5; break;
        case 3: p->acceleration *= 0.5; break;
        case 4: p->linear = false; break;
        default: p->anchor = p->anchor == SCALLOP_FROM_START ? SCALLOP_FROM_END : SCALLOP_FROM_START;
        }
        assert_false(scallop_gait_mirrors(&c.gait));
        assert_false(scallop_gait_is_reversible(&c.gait));
      }
  copy_gait(&c, &scallop_gait_sinusoidal);
  c.pieces[1][0].law = scallop_gait_quadratic.phase[0].pieces[0].law;
  assert_false(scallop_gait_mirrors(&c.gait));
  assert_false(scallop_gait_is_reversible(&c.gait));
  copy_gait(&c, &scallop_gait_quadratic);
  c.gait.phase[1].count = 1;
  assert_false(scallop_gait_mirrors(&c.gait));
}
