/* The order estimator: right orders with honest intervals, and a refusal of what cannot be judged. */
#include "tests/support/check.h"

#include "asymptotics/observed/estimate.h"

enum { MOST = 64 };

static struct scallop_order_point points[MOST];

typedef double error_of(double h);

static double cubic(double h) { return 2.385 * h * h * h * (1 + 0.7 * h); }
static double square_negative(double h) { return -0.31 * h * h * (1 - h); }
static double constant(double h) { return 0.25 + 0 * h; }
static double growing(double h) { return 1e-3 / h; }
static double root(double h) { return sqrt(h); }
static double changes_sign(double h) { return h * h * (h - 0.3); }
static double oscillates(double h) { return h * h * (1.5 + sin(40 * log(h))); }
static double early_kink(double h) { return h > 0.1 ? 0.01 * sqrt(h / 0.1) : h * h; }

/* A reproducible rounding error between -1 and 1 */
static double jitter(double h) { return fmod(1e7 * fabs(sin(1e5 * h)), 2) - 1; }
static double at_floor(double h) { return h * h * h * h + 1e-9 * jitter(h); }
static double only_noise(double h) { return 1e-12 * jitter(h); }

static struct order_fit estimate(error_of *e, int count, double ratio)
{
  double h = 1;
  for (int i = 0; i < count; i++, h /= ratio)
    points[i] = (struct scallop_order_point){ .h = h, .err = e(h) };
  return order_estimate(points, count);
}

TEST(finds_orders)
{
  static const struct {
    error_of *e;
    double order;
  } cases[] = { { cubic, 3 },  { square_negative, 2 }, { constant, 0 }, { growing, -1 },
                { root, 0.5 }, { changes_sign, 2 },    { at_floor, 4 }, { early_kink, 2 } };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
    for (double ratio = 1.3; ratio < 3; ratio += 0.35) {
      struct order_fit fit = estimate(cases[k].e, 24, ratio);
      assert_int_equal(fit.state, ORDER_FITTED);
      CHECK_NEAR(fit.order, cases[k].order, 0.1);
      assert_true(fit.lo <= cases[k].order + 1e-9 && cases[k].order <= fit.hi + 1e-9);
      assert_true(fit.used >= 3);
    }
}

TEST(leaves_out_with_a_reason)
{
  estimate(at_floor, 24, 2);
  assert_int_equal(points[0].use, SCALLOP_ORDER_USED);
  for (int i = 8; i < 24; i++) /* h^4 < 1e-9 from here on */
    assert_int_equal(points[i].use, SCALLOP_ORDER_FLOOR);
  estimate(early_kink, 12, 2);
  assert_int_equal(points[0].use, SCALLOP_ORDER_COARSE);
  estimate(changes_sign, 12, 2);
  assert_int_equal(points[0].use, SCALLOP_ORDER_BEFORE_SIGN_CHANGE);
  assert_int_equal(points[11].use, SCALLOP_ORDER_USED);
  estimate(cubic, 6, 2);
  points[5].err = 0;
  assert_int_equal(order_estimate(points, 6).state, ORDER_FITTED);
  assert_int_equal(points[5].use, SCALLOP_ORDER_ZERO);
}

TEST(known_noise_is_never_fitted)
{
  double h = 1;
  for (int i = 0; i < 20; i++, h /= 2)
    points[i] = (struct scallop_order_point){ .h = h, .err = h * h + 1e-6, .noise = 1e-6 };
  struct order_fit fit = order_estimate(points, 20);
  assert_int_equal(fit.state, ORDER_FITTED);
  CHECK_NEAR(fit.order, 2, 0.02);
  for (int i = 0; i < 20; i++)
    assert_true(points[i].use != SCALLOP_ORDER_USED || points[i].err > 1e-4);
}

/* Errors that grow are no roundoff floor when the rounding is known to be far below them. */
TEST(growing_above_known_noise)
{
  for (int i = 0; i < 30; i++) {
    double h = ldexp(1, -i);
    points[i] = (struct scallop_order_point){ .h = h, .err = (i < 4 ? 1e-3 * h * h : 1e-6 / h), .noise = 1e-14 };
  }
  struct order_fit fit = order_estimate(points, 30);
  assert_int_equal(fit.state, ORDER_FITTED);
  CHECK_NEAR(fit.order, -1, 0.05);
}

/* A table that converges to something else than the answer is not of the order that it shows on the way. */
TEST(wrong_limit)
{
  for (int i = 0; i < 14; i++)
    points[i] = (struct scallop_order_point){ .h = ldexp(1, -i), .err = ldexp(1, -2 * i) + 1e-3 };
  struct order_fit fit = order_estimate(points, 14);
  assert_int_equal(order_judge(&fit, 2, 0.1), ORDER_VERDICT_FLOOR_LIMITED);
}

TEST(refuses)
{
  assert_int_equal(estimate(cubic, 2, 2).state, ORDER_INSUFFICIENT);
  assert_int_equal(estimate(oscillates, 20, 1.3).state, ORDER_NOT_ASYMPTOTIC);
  assert_true(estimate(only_noise, 20, 2).state != ORDER_FITTED);
  assert_int_equal(order_estimate(points, 0).state, ORDER_INSUFFICIENT);
  static const struct scallop_order_point bad[] = { /* the last has the h of the one before it */
                                                    { .h = 0.125, .err = NAN },
                                                    { .h = 0.125, .err = INFINITY },
                                                    { .h = NAN, .err = 0.01 },
                                                    { .h = 0, .err = 0.01 },
                                                    { .h = 0.25, .err = 0.01 }
  };
  for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
    estimate(cubic, 6, 2);
    points[3] = bad[k];
    assert_int_equal(order_estimate(points, 6).state, ORDER_INVALID);
  }
  for (int i = 0; i < 6; i++)
    points[i] = (struct scallop_order_point){ .h = ldexp(1, -i), .err = 0, .noise = 1e-16 };
  assert_int_equal(order_estimate(points, 6).state, ORDER_EXACT);
  CHECK_EQUAL(order_estimate(points, 6).order, NAN);
}

TEST(unsorted_is_sorted)
{
  for (int i = 0; i < 10; i++)
    points[i] = (struct scallop_order_point){ .h = ldexp(1, -(i * 7 % 10)), .err = cubic(ldexp(1, -(i * 7 % 10))) };
  struct order_fit fit = order_estimate(points, 10);
  assert_int_equal(fit.state, ORDER_FITTED);
  CHECK_NEAR(fit.order, 3, 0.1);
  assert_true(points[0].h > points[1].h);
}

TEST(from_values)
{
  /* pi + h^p with ratios that change: 1.5, 2, 1.5, ... */
  for (double p = 0.5; p <= 4; p += 0.5) {
    double h = 1;
    for (int i = 0; i < 9; i++, h /= i % 2 ? 2 : 1.5)
      points[i] = (struct scallop_order_point){ .h = h, .err = 3.14159 + 0.9 * pow(h, p) };
    int left = 9;
    struct order_fit fit = order_estimate_values(points, &left);
    assert_int_equal(left, 8);
    assert_int_equal(fit.state, ORDER_FITTED);
    CHECK_NEAR(fit.order, p, 0.02);
    CHECK_NEAR(points[0].err, 0.9, 0.02);
  }
  int two = 2;
  assert_int_equal(order_estimate_values(points, &two).state, ORDER_INSUFFICIENT);
}

/* Values as simulations print them: pi + 0.9 h^p in doubles, rounded to a decimal, or with noise of that size; h down to far below
 * where the values stay. */
enum values { IN_DOUBLES, ROUNDED, NOISY };

static void fill_values(int count, double p, enum values kind, double decimal, bool even)
{
  double h = 1;
  for (int i = 0; i < count; i++, h /= even || i % 2 ? 2 : 1.5) {
    double value = 3.14159265358979 + 0.9 * pow(h, p);
    if (kind != IN_DOUBLES)
      value = kind == NOISY ? value + decimal * jitter(h) : decimal * round(value / decimal);
    points[i] = (struct scallop_order_point){ .h = h, .err = value };
  }
}

/* Never a wrong order; and an order where there is nothing but the rounding of doubles, whatever the length of the table, or where
 * values that are rounded more stay the same in the end. */
TEST(values_meet_a_floor)
{
  static const double decimals[] = { 1e-8, 1e-10 };
  for (int kind = IN_DOUBLES; kind <= NOISY; kind++)
    for (int k = 0; k < 2; k++)
      for (double p = 1; p <= 6; p++)
        for (int count = 12; count <= 40; count += 4)
          for (int even = 0; even < 2; even++) {
            int left = count;
            fill_values(count, p, (enum values)kind, decimals[k], even);
            struct order_fit fit = order_estimate_values(points, &left);
            bool fitted = fit.state == ORDER_FITTED;
            bool sees_it = kind == IN_DOUBLES || (kind == ROUNDED && count == 40);
            if (fitted ? check_near(fit.order, p, 0.1) : !sees_it)
              continue;
            print_error("order %g, %s to %g, %s, %d values: %s, %g\n", p, kind == NOISY ? "noisy" : "rounded",
                        kind == IN_DOUBLES ? 2e-16 : decimals[k], even ? "even" : "uneven", count,
                        order_state_text(fit.state), fit.order);
            fail();
          }
}

/* Values that stay the same, or are noise alone, have no order; nor are they exact, for all that is known of their error. */
TEST(values_without_an_order)
{
  for (int i = 0; i < 12; i++)
    points[i] = (struct scallop_order_point){ .h = ldexp(1, -i), .err = 2.385 };
  int left = 12;
  struct order_fit fit = order_estimate_values(points, &left);
  assert_int_equal(order_judge(&fit, 2, 0.1), ORDER_VERDICT_FLOOR_LIMITED);
  for (int i = 0; i < 20; i++)
    points[i] = (struct scallop_order_point){ .h = ldexp(1, -i), .err = 2.385 * (1 + 2e-16 * (i % 3)) };
  left = 20;
  fit = order_estimate_values(points, &left);
  assert_int_equal(order_judge(&fit, 2, 0.1), ORDER_VERDICT_FLOOR_LIMITED);
}

/* The noise of values is known: their differences have that of both. */
TEST(values_with_known_noise)
{
  int left = 20;
  for (int i = 0; i < 20; i++)
    points[i] =
        (struct scallop_order_point){ .h = ldexp(1, -i), .err = 1 + ldexp(1, -2 * i) + 1e-7 * (i % 2), .noise = 1e-7 };
  struct order_fit fit = order_estimate_values(points, &left);
  assert_int_equal(fit.state, ORDER_FITTED);
  CHECK_NEAR(fit.order, 2, 0.02);
  for (int i = 0; i < left; i++)
    assert_true(points[i].use != SCALLOP_ORDER_USED || ldexp(1, -2 * i) > 1e-5);
}

/* No error at all passes for any order; errors within a hundred times their noise do not. */
TEST(errors_that_are_zero)
{
  struct order_fit fit;
  for (int noise = 0; noise < 2; noise++) {
    for (int i = 0; i < 6; i++)
      points[i] =
          (struct scallop_order_point){ .h = ldexp(1, -i), .err = noise ? 1e-17 * i : 0, .noise = noise ? 1e-16 : 0 };
    fit = order_estimate(points, 6);
    assert_int_equal(fit.state, ORDER_EXACT);
    assert_int_equal(order_judge(&fit, 4, 0.1), ORDER_PASS);
  }
  points[2].err = 2e-15;
  fit = order_estimate(points, 6);
  assert_int_equal(order_judge(&fit, 4, 0.1), ORDER_VERDICT_FLOOR_LIMITED);
  points[0].err = points[1].err = 0;
  fit = order_estimate(points, 2);
  assert_int_equal(order_judge(&fit, 4, 0.1), ORDER_VERDICT_INSUFFICIENT);
}

TEST(verdicts)
{
  static const struct {
    error_of *e;
    int count;
    double expect;
    enum order_verdict verdict;
  } cases[] = {
    { cubic, 20, 3, ORDER_PASS },
    { cubic, 20, 4, ORDER_TOO_LOW },
    { cubic, 20, 2, ORDER_TOO_HIGH },
    { constant, 20, 2, ORDER_TOO_LOW },
    { growing, 20, 1, ORDER_TOO_LOW },
    { cubic, 2, 3, ORDER_VERDICT_INSUFFICIENT },
    { oscillates, 20, 2, ORDER_VERDICT_NOT_ASYMPTOTIC },
    { early_kink, 12, 2, ORDER_PASS },
    { at_floor, 20, 4, ORDER_PASS },
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    struct order_fit fit = estimate(cases[k].e, cases[k].count, cases[k].e == oscillates ? 1.3 : 2);
    assert_string_equal(order_verdict_text(order_judge(&fit, cases[k].expect, 0.1)), order_verdict_text(cases[k].verdict));
  }
  /* two usable points, then a floor */
  static const double floor_errors[] = { 1, 0.06, 1e-5, 1.1e-5, 0.9e-5, 1.2e-5, 1e-5, 0.8e-5 };
  for (int i = 0; i < 8; i++)
    points[i] = (struct scallop_order_point){ .h = pow(10, -i), .err = floor_errors[i] * (i > 2 && i % 2 ? -1 : 1) };
  struct order_fit fit = order_estimate(points, 8);
  assert_int_equal(order_judge(&fit, 2, 0.1), ORDER_VERDICT_FLOOR_LIMITED);
  fit.state = ORDER_INVALID;
  assert_int_equal(order_judge(&fit, 2, 0.1), ORDER_VERDICT_INVALID);
  /* an order within the tolerance but an interval far beyond it is no pass */
  fit = (struct order_fit){ ORDER_FITTED, 2.05, 1.65, 2.45, 4 };
  assert_int_equal(order_judge(&fit, 2, 0.1), ORDER_VERDICT_NOT_ASYMPTOTIC);
}
