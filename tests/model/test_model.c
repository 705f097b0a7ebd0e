/* The validation of a crawler and its scaling. */
#include <float.h>

#include "model/model.h"
#include "tests/support/random_crawler.h"
#include "tests/support/solved.h"

#define ULP DBL_EPSILON

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
  static const struct scallop_complaint untouched = { "untouched", 2.385, NULL };
  const char *const name[] = { "m1", "m2", "F1", "F2", "L", "T", "alpha" };
  const double bad[] = { NAN, INFINITY, -INFINITY, 0, -0.0, -2.385, -DBL_TRUE_MIN },
               most[] = { DBL_MAX, DBL_MAX, DBL_MAX, DBL_MAX, DBL_MAX, DBL_MAX, 1 - ULP / 2 };
  struct scallop_crawler c;
  for (int i = 0; i < PARAMETERS; i++) {
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
      c = scallop_crawler_default();
      *parameter(&c, i) = bad[k];
      complains(&c, name[i], bad[k]);
      if (i + 1 < PARAMETERS) { /* the first bad one is named */
        *parameter(&c, i + 1) = -1;
        complains(&c, name[i], bad[k]);
      }
    }
    for (int k = 0; k < 2; k++) {
      struct scallop_complaint complaint = untouched;
      c = scallop_crawler_default();
      *parameter(&c, i) = k ? DBL_TRUE_MIN : most[i];
      assert_int_equal(scallop_crawler_check(&c, &complaint), SCALLOP_OK);
      assert_memory_equal(&complaint, &untouched, sizeof complaint);
      assert_int_equal(scallop_crawler_check(&c, NULL), SCALLOP_OK);
    }
  }
  c = scallop_crawler_default();
  for (c.alpha = 1; c.alpha <= 1 + ULP; c.alpha += ULP)
    complains(&c, "alpha", c.alpha);
  c = with_gait(NULL);
  complains(&c, "gait", NAN);
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
