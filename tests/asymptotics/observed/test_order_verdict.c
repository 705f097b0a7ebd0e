/* Verdicts: each kind of table, its reason in words, and the grid convergence index. */
#include "tests/support/check.h"

#include <stdio.h>

#include "asymptotics/observed/judged.h"

enum { MOST = 200 };

static struct scallop_order_point points[MOST];
static struct scallop_order_result result;
static int count;

static void judge(double order, bool at_least, bool values)
{
  struct scallop_order_wanted wanted = { .order = order, .tolerance = 0.1, .at_least = at_least, .values = values };
  scallop_order(points, &count, &wanted, &result);
}

static void print_last(void) { print_error("%s: %s\n", scallop_order_verdict_text(result.verdict), result.reason); }

/* Numbers h, err, h, err, ... */
#define TABLE(...) take((const double[]){ __VA_ARGS__ }, sizeof((const double[]){ __VA_ARGS__ }) / sizeof(double))
static void take(const double *numbers, size_t size)
{
  check_failed = print_last;
  count = (int)size / 2;
  for (int i = 0; i < count; i++)
    points[i] = (struct scallop_order_point){ .h = numbers[2 * i], .err = numbers[2 * i + 1] };
}

typedef double error_of(double h);
static void fill(error_of *e, int rows, double h0, double ratio)
{
  check_failed = print_last;
  count = rows;
  for (int i = 0; i < rows; i++, h0 /= ratio)
    points[i] = (struct scallop_order_point){ .h = h0, .err = e(h0) };
}

static void expect(enum scallop_order_verdict verdict, const char *reason)
{
  assert_string_equal(scallop_order_verdict_text(result.verdict), scallop_order_verdict_text(verdict));
  if (reason)
    assert_string_equal(result.reason, reason);
}

TEST(textbook_table)
{
  TABLE(0.1, 0.011, 0.05, 0.0026, 0.025, 6.3e-4, 0.0125, 1.57e-4);
  judge(2, false, false);
  expect(SCALLOP_ORDER_PASS, "order 2.04 in rows 1 to 4");
  assert_int_equal(result.interval, SCALLOP_ORDER_SLOPE);
  assert_int_equal(result.used, 4);
  /* least squares by hand: the slope over log2 h is (3 (y1 - y4) + y2 - y3)/10 */
  double y[4];
  for (int i = 0; i < 4; i++)
    y[i] = log2(points[i].err);
  CHECK_NEAR(result.order, (3 * (y[0] - y[3]) + y[1] - y[2]) / 10, 1e-13);
  judge(1.5, false, false);
  expect(SCALLOP_ORDER_TOO_HIGH, "order 2.04 is 0.54 above the expected 1.5 in rows 1 to 4");
  judge(1.5, true, false);
  expect(SCALLOP_ORDER_PASS, NULL);
  judge(3, true, false);
  expect(SCALLOP_ORDER_TOO_LOW, "order 2.04 is 0.96 below the expected 3 in rows 1 to 4");
  judge(NAN, false, false);
  expect(SCALLOP_ORDER_MEASURED, "order 2.04 in rows 1 to 4");
}

static double corrected(double h) { return 0.7 * h * h * (1 + h); }
static double lower_term(double h) { return h * h + 2e-3 * h; }
static double higher_term(double h) { return fabs(h * h - 3.1e-2 * h); }
static double logarithm(double h) { return h * h * log(1 / h); }
static double over_logarithm(double h) { return h * h / log(1 / h); }

TEST(drifts)
{
  fill(corrected, 5, 0.5, 2);
  judge(2, false, false);
  expect(SCALLOP_ORDER_PASS, NULL);
  assert_int_equal(result.interval, SCALLOP_ORDER_LIMIT);
  CHECK_NEAR(result.order, 2, 1e-3);
  fill(corrected, 4, 0.5, 2);
  judge(1, false, false);
  expect(SCALLOP_ORDER_TOO_HIGH, NULL);
  for (int rows = 4; rows <= 12; rows++)
    for (double h0 = 0.1; h0 < 0.6; h0 *= 5) {
      if (rows == 4 && h0 > 0.1)
        continue;
      fill(lower_term, rows, h0, 2);
      judge(2, false, false);
      assert_true(result.verdict != SCALLOP_ORDER_PASS);
      fill(lower_term, rows, h0, 2);
      judge(2, true, false);
      assert_true(result.verdict != SCALLOP_ORDER_PASS);
    }
  fill(lower_term, 5, 0.5, 2);
  judge(2, false, false);
  expect(SCALLOP_ORDER_DRIFTING, "the orders fall faster and faster: a term of lower order takes over: "
                                 "pairwise orders 1.99, 1.99, 1.98, 1.96 in rows 1 to 5");
  fill(higher_term, 5, 1, 2);
  judge(2, false, false);
  expect(SCALLOP_ORDER_DRIFTING, NULL);
  judge(2, true, false);
  expect(SCALLOP_ORDER_DRIFTING, "the orders rise faster and faster: a term of lower order has the other sign: "
                                 "pairwise orders 2.05, 2.1, 2.22, 2.58 in rows 1 to 5");
  for (int rows = 5; rows < 12; rows++) {
    fill(logarithm, rows, 1e-3, 10);
    judge(2, false, false);
    expect(SCALLOP_ORDER_DRIFTING, NULL);
    judge(2, true, false);
    expect(SCALLOP_ORDER_DRIFTING, NULL);
    judge(NAN, false, false);
    expect(SCALLOP_ORDER_DRIFTING, NULL);
  }
  fill(over_logarithm, 8, 1e-3, 10);
  judge(2, true, false);
  expect(SCALLOP_ORDER_PASS, NULL);
}

/* The orders come down to 2, from a table too short for a limit. */
TEST(arrives)
{
  TABLE(0.5, 0.26, 0.25, 0.055, 0.125, 0.012, 0.0625, 0.0029);
  judge(2, false, false);
  expect(SCALLOP_ORDER_PASS, "the orders have come to 2.05: 2.24, 2.2, 2.05");
  assert_int_equal(result.interval, SCALLOP_ORDER_PAIRWISE);
  TABLE(0.5, 0.7, 0.25, 0.1, 0.125, 0.02, 0.0625, 0.004);
  judge(2, false, false);
  assert_true(result.verdict != SCALLOP_ORDER_PASS);
}

/* Orders that arrive from far, and orders that only pass by. */
TEST(arrives_or_passes_by)
{
  TABLE(0.1, 4.3e-2, 0.05, 1.9e-2, 0.025, 6.6e-3, 0.0125, 1.9e-3, 0.00625, 5e-4, 0.003125, 1.27e-4);
  judge(2, false, false);
  expect(SCALLOP_ORDER_PASS, "the orders have come to 1.98: 1.18, 1.53, 1.8, 1.93, 1.98");
  TABLE(1, 1.07, 0.5, 0.16, 0.25, 0.0331, 0.125, 0.0107);
  judge(2, false, false);
  expect(SCALLOP_ORDER_DRIFTING, "the orders have not settled: pairwise orders 2.74, 2.27, 1.63 in rows 1 to 4");
  TABLE(0.1, 5.12e-2, 0.05, 2.49e-3, 0.025, 8.93e-5, 0.0125, 2.89e-6, 0.00625, 8.72e-8);
  judge(5, false, false);
  expect(SCALLOP_ORDER_PASS, NULL);
  TABLE(0.1, 0.1, 0.05, 2.5e-2, 0.025, 6.25e-3, 0.0125, 1.56e-3, 0.00625, 3.9e-4, 0.003125, 1.95e-4);
  judge(2, false, false);
  expect(SCALLOP_ORDER_DRIFTING, NULL);
  CHECK_NEAR(result.low, 1, 1e-12);
  CHECK_NEAR(result.high, 2, 0.01);
}

static double levels_off(double h) { return h * h + 1e-3; }
static double levels_off_low(double h) { return pow(h, 3) + 1e-8; }
static double flat(double h) { return 0.25 + 0 * h; }
static double jitter(double h) { return fmod(1e7 * fabs(sin(1e5 * h)), 2) - 1; }
static double at_roundoff(double h) { return pow(h, 4) + 1e-14 * jitter(h); }
static double at_high_floor(double h) { return pow(h, 4) + 1e-4 * (2 + jitter(h)); }

TEST(floors)
{
  fill(levels_off, 9, 0.5, 2);
  judge(2, false, false);
  expect(SCALLOP_ORDER_PLATEAU, "err stops falling near 0.001 in rows 6 to 9: a plateau far above roundoff");
  fill(levels_off, 5, 0.1, 2);
  judge(2, false, false);
  expect(SCALLOP_ORDER_PLATEAU, NULL);
  fill(levels_off_low, 14, 1, 2);
  judge(3, false, false);
  expect(SCALLOP_ORDER_PLATEAU, NULL);
  fill(flat, 5, 0.5, 2);
  judge(2, false, false);
  expect(SCALLOP_ORDER_TOO_LOW, "order 0 is 2 below the expected 2 in rows 1 to 5");
  fill(at_roundoff, 20, 0.5, 2);
  judge(4, false, false);
  expect(SCALLOP_ORDER_PASS, NULL);
  assert_non_null(strstr(result.reason, "left out: "));
  assert_true(result.used >= 8);
  /* four rows above roundoff; and a difference quotient, whose roundoff grows as 1/h */
  TABLE(0.5, 1.1e-4, 0.25, 4.4e-7, 0.125, 1.7e-9, 0.0625, 6.7e-12, 0.03125, 4.4e-16, 0.015625, 2.2e-16);
  judge(8, false, false);
  expect(SCALLOP_ORDER_PASS, "order 7.99 in rows 1 to 4; left out: roundoff in rows 5 and 6");
  TABLE(1e-1, 4.53e-3, 1e-2, 4.53e-5, 1e-3, 4.53e-7, 1e-4, 4.53e-9, 1e-5, 5.86e-11, 1e-6, 1.63e-10, 1e-7, 5.86e-11,
        1e-8, 6.6e-9, 1e-9, 6.6e-9, 1e-10, 6.73e-7, 1e-11, 1.04e-5);
  judge(2, false, false);
  expect(SCALLOP_ORDER_PASS, NULL);
  fill(at_high_floor, 8, 0.25, 2);
  judge(4, false, false);
  expect(SCALLOP_ORDER_FLOOR_LIMITED, NULL);
}

/* A plateau behind rows of slope 1 is none of roundoff's; a finest row that is off is no drift; a rough floor leaves
 * the rows above it. */
TEST(fine_ends)
{
  TABLE(0.5, 2.73, 0.166667, 0.913, 0.0555556, 0.306, 0.0185185, 0.104, 0.00617284, 0.0361, 0.00205761, 0.0136,
        0.000685871, 0.00615, 0.000228624, 0.00365);
  judge(1, false, false);
  expect(SCALLOP_ORDER_PLATEAU, "err stops falling near 0.0037 in rows 7 and 8: a plateau far above roundoff");
  TABLE(0.5, 0.0625, 0.25, 0.00390625, 0.125, 0.000244140625, 0.0625, 1.52587890625e-05, 0.03125, 9.5367431640625e-07,
        0.015625, 5.93e-08);
  judge(4, false, false);
  expect(SCALLOP_ORDER_PASS, "order 4 in rows 1 to 5; left out: roundoff in row 6");
  TABLE(0.5247, 0.886418, 0.2624, 0.221553, 0.1312, 0.0553687, 0.06559, 0.0138258, 0.0328, 0.00348085, 0.0164,
        0.000863772, 0.008199, 0.000196189, 0.0041, 0.000101625, 0.00205, 4.78873e-05, 0.001025, 5.92781e-05, 0.0005124,
        6.75894e-05);
  judge(2, false, false);
  expect(SCALLOP_ORDER_PASS, NULL);
  TABLE(0.5, 1, 0.25, 0.1, 0.125, 0.03125, 0.0625, 0.015625, 0.03125, 0.0078125);
  judge(1, false, false);
  expect(SCALLOP_ORDER_PASS, NULL);
}

/* h^4 + 4e-7 h, 3 digits: the slow tail is a term of lower order and no floor. */
TEST(lower_term_is_no_floor)
{
  TABLE(0.5, 0.0232, 0.2464, 0.00137, 0.1214, 8.06e-5, 0.05984, 4.77e-6, 0.02949, 2.92e-7, 0.01453, 2.24e-8, 0.007161,
        3.86e-9, 0.003529, 1.48e-9);
  judge(4, false, false);
  assert_true(result.verdict != SCALLOP_ORDER_PASS);
}

/* Of many rows means are fitted: the order stays what it is. */
TEST(many_rows)
{
  enum { ROWS = 20000 };
  static struct scallop_order_point many[ROWS];
  for (int noisy = 0; noisy < 2; noisy++) {
    for (int i = 0; i < ROWS; i++) {
      double h = pow(10, -3.0 * i / ROWS);
      many[i] = (struct scallop_order_point){ .h = h, .err = h * h * (1 + h) * (noisy ? 1 + 0.1 * jitter(h) : 1) };
    }
    int rows = ROWS;
    struct scallop_order_wanted wanted = { .order = 2, .tolerance = 0.1 };
    scallop_order(many, &rows, &wanted, &result);
    expect(SCALLOP_ORDER_PASS, NULL);
    assert_int_equal(result.interval, SCALLOP_ORDER_LIMIT);
    CHECK_NEAR(result.order, 2, noisy ? 0.05 : 1e-4);
  }
}

/* Where no order is expected, none passes. */
TEST(measured_only)
{
  fill(flat, 4, 0.5, 2);
  judge(NAN, false, false);
  expect(SCALLOP_ORDER_MEASURED, "order 0 in rows 1 to 4");
  TABLE(1, 1);
  judge(NAN, false, false);
  expect(SCALLOP_ORDER_INSUFFICIENT, NULL);
  fill(levels_off, 9, 0.5, 2);
  judge(NAN, false, false);
  expect(SCALLOP_ORDER_PLATEAU, NULL);
}

/* More rows than anybody prints, of few digits: rounding is not looked at. A zero behind a floor is none of it. */
static double one_digit(double h) { return pow(10, round(log10(h))); }
static double ends_at_zero(double h) { return h < 1e-5 ? 0 : at_roundoff(h); }
TEST(long_tables_and_zeros)
{
  fill(one_digit, 100, 1, 1.2);
  judge(1, false, false);
  expect(SCALLOP_ORDER_PASS, NULL);
  fill(ends_at_zero, 20, 0.5, 2);
  judge(4, false, false);
  expect(SCALLOP_ORDER_PASS, NULL);
  assert_non_null(strstr(result.reason, "err is 0 in rows"));
}

TEST(invalid_tables)
{
  TABLE(1, 1, 0.5, 0.25, 0.5, 0.1, 0.125, NAN);
  judge(2, false, false);
  expect(SCALLOP_ORDER_INVALID, "NaN in row 4; h repeated in rows 2 and 3");
  TABLE(1, 1, 0.5, 0.25, 0.3, 0.1, 0.125, 1, 0.5, 4);
  judge(2, false, false);
  expect(SCALLOP_ORDER_INVALID, "h repeated in rows 2 and 5");
  TABLE(-1, 1, 0, 0.25, 0.3, INFINITY, 0.125, 1, 0.0625, 4);
  points[4].noise = -1;
  judge(2, false, false);
  expect(SCALLOP_ORDER_INVALID, "an infinite number in row 3; h <= 0 in rows 1 and 2; noise < 0 or NaN in row 5");
  for (int i = 0; i < 30; i++)
    points[i] = (struct scallop_order_point){ .h = i + 1,
                                              .err = i % 4 == 1 || i % 4 == 2 ? NAN : 1,
                                              .row = i < 20 ? 0 : 3 * i };
  count = 30;
  judge(2, false, false);
  expect(SCALLOP_ORDER_INVALID, "NaN in rows 2, 3, 6, 7, 10, 11, 14, 15, 18, 19, 63 and 4 more");
  CHECK_EQUAL(result.order, NAN);
}

TEST(few_rows)
{
  TABLE(1, 1, 0.5, 0.25);
  judge(2, false, false);
  expect(SCALLOP_ORDER_INSUFFICIENT, "2 usable rows, an order takes 3");
  CHECK_EQUAL(result.order, 2);
  TABLE(1, 1);
  judge(2, false, false);
  expect(SCALLOP_ORDER_INSUFFICIENT, "1 usable row, an order takes 3");
  TABLE(1, 1, 0.5, 0.25, 0.25, 0.2, 0.125, 0.19);
  judge(2, false, false);
  expect(SCALLOP_ORDER_PLATEAU, "err stops falling near 0.19 in rows 2 to 4: a plateau far above roundoff");
  TABLE(1, 1, 0.5, 0.25, 0.25, 0.0625);
  judge(2, false, false);
  expect(SCALLOP_ORDER_PASS, "order 2 in rows 1 to 3");
  assert_int_equal(result.interval, SCALLOP_ORDER_PAIRWISE);
  TABLE(1, 1, 0.5, 0.25, 0.25, 0.05);
  judge(2.16, false, false);
  expect(SCALLOP_ORDER_SCATTERED, NULL);
  TABLE(1, 0, 0.5, 0, 0.25, 0);
  judge(2, false, false);
  expect(SCALLOP_ORDER_PASS, "exact: every err is 0");
  judge(NAN, false, false);
  expect(SCALLOP_ORDER_MEASURED, "exact: every err is 0");
  TABLE(1, 1e-16, 0.5, 0, 0.25, 1e-16);
  for (int i = 0; i < 3; i++)
    points[i].noise = 1e-16;
  judge(2, false, false);
  expect(SCALLOP_ORDER_PASS, "exact: every err is within its noise");
  TABLE(1, 0, 0.5, 0.25, 0.25, 0.0625, 0.125, 0.015625, 0.0625, 0.00390625);
  judge(2, false, false);
  expect(SCALLOP_ORDER_PASS, "order 2 in rows 2 to 5; left out: err is 0 in row 1");
  TABLE(1, -0.3, 0.5, 0.25, 0.25, 0.0625, 0.125, 0.015625, 0.0625, 0.00390625);
  judge(2, false, false);
  expect(SCALLOP_ORDER_PASS, "order 2 in rows 2 to 5; left out: before a change of sign in row 1");
  TABLE(0.1, -0.1, 0.05, 0.025, 0.025, -0.00625, 0.0125, 0.00156, 0.00625, -3.9e-4);
  judge(2, false, false);
  expect(SCALLOP_ORDER_INSUFFICIENT,
         "1 usable row, an order takes 3; left out: before a change of sign in rows 1 to 4");
  assert_string_equal(scallop_order_interval_text(SCALLOP_ORDER_NO_INTERVAL), "none");
}

/* NASA's example of the grid convergence index: the pressure recovery of an inlet on three grids (NPARC Alliance,
 * Examining Spatial (Grid) Convergence): p = 1.786170, gci = 0.103083 %, gci of the coarser two 0.356249 %. */
TEST(grid_convergence)
{
  TABLE(4, 0.96178, 2, 0.96854, 1, 0.97050);
  judge(NAN, false, true);
  expect(SCALLOP_ORDER_INSUFFICIENT, "2 usable differences of values, an order takes 3");
  CHECK_NEAR(result.order, 1.786170, 1e-6);
  CHECK_NEAR(result.gci, 0.00103083, 1e-8);
  CHECK_NEAR(result.asymptotic_ratio, 0.00356249 / (pow(2, 1.786170) * 0.00103083), 1e-5);
  CHECK_NEAR(result.asymptotic_ratio, 0.97050 / 0.96854, 1e-12);
  TABLE(4, 0.96178, 2, 0.96854, 1, 0.97050);
  judge(2, false, true);
  CHECK_NEAR(result.asymptotic_ratio, (0.96854 - 0.96178) / (0.97050 - 0.96854) / 4 * 0.97050 / 0.96854, 1e-12);
  TABLE(4, 1, 2, 2, 1, 1.5);
  judge(2, false, true);
  CHECK_EQUAL(result.gci, NAN);
  TABLE(1, 3, 0.5, 3, 0.25, 3, 0.125, 3);
  judge(2, false, true);
  expect(SCALLOP_ORDER_FLOOR_LIMITED, NULL);
  TABLE(1, 3, 0.5, 2);
  judge(2, false, true);
  expect(SCALLOP_ORDER_INSUFFICIENT, NULL);
}

static double value(double h) { return 3.25 + h * h; }
TEST(values_down_to_roundoff)
{
  fill(value, 40, 1, 2);
  judge(2, false, true);
  expect(SCALLOP_ORDER_PASS, NULL);
  assert_true(result.used >= 15);
}

/* Abramowitz & Stegun, table 26.10; 1.96 far out */
TEST(student)
{
  CHECK_NEAR(student_quantile(0.95, 1), 12.706, 5e-4);
  CHECK_NEAR(student_quantile(0.95, 2), 4.303, 5e-4);
  CHECK_NEAR(student_quantile(0.95, 10), 2.228, 5e-4);
  CHECK_NEAR(student_quantile(0.995, 9), 3.690, 5e-4);
  CHECK_RELATIVE(student_quantile(0.95, 200), student_quantile(0.95, 201), 4e-5);
  CHECK_NEAR(student_quantile(0.95, 100000000), 1.9599639845400545, 1e-7);
}
