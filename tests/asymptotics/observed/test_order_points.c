/* Orders that nobody expected: right ones with honest intervals, which points are left out, and values instead of
 * errors. */
#include "tests/support/check.h"

#include "asymptotics/observed/order.h"

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

static int left; /* of the points */
static struct scallop_order_result measure(int count, bool values)
{
  const struct scallop_order_wanted wanted = { .order = NAN, .tolerance = 0.1, .values = values };
  struct scallop_order_result result;
  left = count;
  scallop_order(points, &left, &wanted, &result);
  return result;
}

static struct scallop_order_result measure_errors(error_of *e, int count, double ratio)
{
  double h = 1;
  for (int i = 0; i < count; i++, h /= ratio)
    points[i] = (struct scallop_order_point){ .h = h, .err = e(h) };
  return measure(count, false);
}

#define EXPECT(verdict_, result) \
  assert_string_equal(scallop_order_verdict_text((result).verdict), scallop_order_verdict_text(verdict_))

TEST(finds_orders)
{
  static const struct {
    error_of *e;
    double order;
  } cases[] = { { cubic, 3 },  { square_negative, 2 }, { constant, 0 }, { growing, -1 },
                { root, 0.5 }, { changes_sign, 2 },    { at_floor, 4 }, { early_kink, 2 } };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
    for (double ratio = 1.3; ratio < 3; ratio += 0.35) {
      struct scallop_order_result fit = measure_errors(cases[k].e, 24, ratio);
      EXPECT(SCALLOP_ORDER_MEASURED, fit);
      CHECK_NEAR(fit.order, cases[k].order, 0.1);
      assert_true(fit.low <= cases[k].order + 1e-9 && cases[k].order <= fit.high + 1e-9);
      assert_true(fit.used >= 3);
    }
}

TEST(leaves_out_with_a_reason)
{
  measure_errors(at_floor, 24, 2);
  assert_int_equal(points[0].use, SCALLOP_ORDER_USED);
  for (int i = 8; i < 24; i++) /* h^4 < 1e-9 from here on */
    assert_int_equal(points[i].use, SCALLOP_ORDER_FLOOR);
  measure_errors(early_kink, 12, 2);
  assert_int_equal(points[0].use, SCALLOP_ORDER_COARSE);
  measure_errors(changes_sign, 12, 2);
  assert_int_equal(points[0].use, SCALLOP_ORDER_BEFORE_SIGN_CHANGE);
  assert_int_equal(points[11].use, SCALLOP_ORDER_USED);
  measure_errors(cubic, 6, 2);
  points[5].err = 0;
  EXPECT(SCALLOP_ORDER_MEASURED, measure(6, false));
  assert_int_equal(points[5].use, SCALLOP_ORDER_ZERO);
}

TEST(known_noise_is_never_fitted)
{
  double h = 1;
  for (int i = 0; i < 20; i++, h /= 2)
    points[i] = (struct scallop_order_point){ .h = h, .err = h * h + 1e-6, .noise = 1e-6 };
  struct scallop_order_result fit = measure(20, false);
  EXPECT(SCALLOP_ORDER_MEASURED, fit);
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
  struct scallop_order_result fit = measure(30, false);
  EXPECT(SCALLOP_ORDER_MEASURED, fit);
  CHECK_NEAR(fit.order, -1, 0.05);
}

/* A table that converges to something else than the answer is not of the order that it shows on the way. */
TEST(wrong_limit)
{
  for (int i = 0; i < 14; i++)
    points[i] = (struct scallop_order_point){ .h = ldexp(1, -i), .err = ldexp(1, -2 * i) + 1e-3 };
  EXPECT(SCALLOP_ORDER_PLATEAU, measure(14, false));
}

TEST(refuses)
{
  EXPECT(SCALLOP_ORDER_INSUFFICIENT, measure_errors(cubic, 2, 2));
  assert_true(measure_errors(oscillates, 20, 1.3).verdict > SCALLOP_ORDER_MEASURED);
  EXPECT(SCALLOP_ORDER_FLOOR_LIMITED, measure_errors(only_noise, 20, 2));
  EXPECT(SCALLOP_ORDER_INSUFFICIENT, measure(0, false));
  static const struct scallop_order_point bad[] = { /* the last has the h of the one before it */
                                                    { .h = 0.125, .err = NAN },
                                                    { .h = 0.125, .err = INFINITY },
                                                    { .h = NAN, .err = 0.01 },
                                                    { .h = 0, .err = 0.01 },
                                                    { .h = 0.25, .err = 0.01 }
  };
  for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
    measure_errors(cubic, 6, 2);
    points[3] = bad[k];
    EXPECT(SCALLOP_ORDER_INVALID, measure(6, false));
  }
  for (int i = 0; i < 6; i++)
    points[i] = (struct scallop_order_point){ .h = ldexp(1, -i), .err = 0, .noise = 1e-16 };
  EXPECT(SCALLOP_ORDER_MEASURED, measure(6, false));
  CHECK_EQUAL(measure(6, false).order, NAN);
}

TEST(unsorted_is_sorted)
{
  for (int i = 0; i < 10; i++)
    points[i] = (struct scallop_order_point){ .h = ldexp(1, -(i * 7 % 10)), .err = cubic(ldexp(1, -(i * 7 % 10))) };
  struct scallop_order_result fit = measure(10, false);
  EXPECT(SCALLOP_ORDER_MEASURED, fit);
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
    struct scallop_order_result fit = measure(9, true);
    assert_int_equal(left, 8);
    EXPECT(SCALLOP_ORDER_MEASURED, fit);
    CHECK_NEAR(fit.order, p, 0.02);
    CHECK_NEAR(points[0].err, 0.9, 0.02);
  }
  EXPECT(SCALLOP_ORDER_INSUFFICIENT, measure(2, true));
}

/* Values as simulations print them: pi + 0.9 h^p in doubles, rounded to a decimal, or with noise of that size; h down
 * to far below where the values stay. */
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

/* Never a wrong order; and an order where there is nothing but the rounding of doubles, whatever the length of the
 * table, or where values that are rounded more stay the same in the end. */
TEST(values_meet_a_floor)
{
  static const double decimals[] = { 1e-8, 1e-10 };
  for (int kind = IN_DOUBLES; kind <= NOISY; kind++)
    for (int k = 0; k < 2; k++)
      for (double p = 1; p <= 6; p++)
        for (int count = 12; count <= 40; count += 4)
          for (int even = 0; even < 2; even++) {
            fill_values(count, p, (enum values)kind, decimals[k], even);
            struct scallop_order_result fit = measure(count, true);
            bool fitted = fit.verdict == SCALLOP_ORDER_MEASURED;
            bool sees_it = kind == IN_DOUBLES || (kind == ROUNDED && count == 40);
            if (fitted ? check_near(fit.order, p, 0.1) : !sees_it)
              continue;
            print_error("order %g, %s to %g, %s, %d values: %s, %g\n", p, kind == NOISY ? "noisy" : "rounded",
                        kind == IN_DOUBLES ? 2e-16 : decimals[k], even ? "even" : "uneven", count,
                        scallop_order_verdict_text(fit.verdict), fit.order);
            fail();
          }
}

/* Values that stay the same, or are noise alone, have no order; nor are they exact, for all that is known of their
 * error. */
TEST(values_without_an_order)
{
  for (int i = 0; i < 12; i++)
    points[i] = (struct scallop_order_point){ .h = ldexp(1, -i), .err = 2.385 };
  EXPECT(SCALLOP_ORDER_FLOOR_LIMITED, measure(12, true));
  for (int i = 0; i < 20; i++)
    points[i] = (struct scallop_order_point){ .h = ldexp(1, -i), .err = 2.385 * (1 + 2e-16 * (i % 3)) };
  EXPECT(SCALLOP_ORDER_FLOOR_LIMITED, measure(20, true));
}

/* The noise of values is known: their differences have that of both. */
TEST(values_with_known_noise)
{
  for (int i = 0; i < 20; i++)
    points[i] =
        (struct scallop_order_point){ .h = ldexp(1, -i), .err = 1 + ldexp(1, -2 * i) + 1e-7 * (i % 2), .noise = 1e-7 };
  struct scallop_order_result fit = measure(20, true);
  EXPECT(SCALLOP_ORDER_MEASURED, fit);
  CHECK_NEAR(fit.order, 2, 0.02);
  for (int i = 0; i < left; i++)
    assert_true(points[i].use != SCALLOP_ORDER_USED || ldexp(1, -2 * i) > 1e-5);
}
