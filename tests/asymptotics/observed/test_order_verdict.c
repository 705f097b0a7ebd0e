/* Verdicts and orders: each kind of table, its reason in words, which points are left out, values instead of errors,
 * and the grid convergence index. */
#include "tests/support/check.h"

#include <stdio.h>
#include <stdlib.h>

#include "asymptotics/observed/judged.h"

enum { MOST = 200 };

static struct scallop_order_point points[MOST];
static struct scallop_order_result result;
static int count;

static void print_last(void) { print_error("%s: %s\n", scallop_order_verdict_text(result.verdict), result.reason); }

/* Numbers h, err, h, err, ... */
static void read_rows(const char *rows)
{
  char *at = (char *)rows, *end;
  check_failed = print_last;
  count = 0;
  for (double h; h = strtod(at, &end), end != at; count++)
    points[count] = (struct scallop_order_point){ .h = h, .err = strtod(end, &at) };
}

typedef double error_of(double h);
static void fill(error_of *e, int rows, double h0, double ratio)
{
  check_failed = print_last;
  count = rows;
  for (int i = 0; i < rows; i++, h0 /= ratio)
    points[i] = (struct scallop_order_point){ .h = h0, .err = e(h0) };
}

enum how { EXACTLY, AT_LEAST, VALUES };
static void judge(double order, enum how how)
{
  struct scallop_order_wanted wanted = {
    .order = order, .tolerance = 0.1, .at_least = how == AT_LEAST, .values = how == VALUES
  };
  scallop_order(points, &count, &wanted, &result);
}

static void measure(enum how how) { judge(NAN, how); }

static void expect(enum scallop_order_verdict verdict, const char *reason)
{
  assert_string_equal(scallop_order_verdict_text(result.verdict), scallop_order_verdict_text(verdict));
  if (reason && strncmp(reason, "...", 3) == 0)
    assert_non_null(strstr(result.reason, reason + 3));
  else if (reason)
    assert_string_equal(result.reason, reason);
}

/* A reproducible rounding error between -1 and 1 */
static double jitter(double h) { return fmod(1e7 * fabs(sin(1e5 * h)), 2) - 1; }
static double corrected(double h) { return 0.7 * h * h * (1 + h); }
static double lower_term(double h) { return h * h + 2e-3 * h; }
static double higher_term(double h) { return fabs(h * h - 3.1e-2 * h); }
static double logarithm(double h) { return h * h * log(1 / h); }
static double over_logarithm(double h) { return h * h / log(1 / h); }
static double levels_off(double h) { return h * h + 1e-3; }
static double levels_off_low(double h) { return pow(h, 3) + 1e-8; }
static double flat(double h) { return 0.25 + 0 * h; }
static double at_roundoff(double h) { return pow(h, 4) + 1e-14 * jitter(h); }
static double at_high_floor(double h) { return pow(h, 4) + 1e-4 * (2 + jitter(h)); }
static double one_digit(double h) { return pow(10, round(log10(h))); }
static double ends_at_zero(double h) { return h < 1e-5 ? 0 : at_roundoff(h); }
static double value(double h) { return 3.25 + h * h; }
static double cubic(double h) { return 2.385 * h * h * h * (1 + 0.7 * h); }
static double cubic_to_zero(double h) { return h < 0.04 ? 0 : cubic(h); }
static double square_negative(double h) { return -0.31 * h * h * (1 - h); }
static double growing(double h) { return 1e-3 / h; }
static double root(double h) { return sqrt(h); }
static double changes_sign(double h) { return h * h * (h - 0.3); }
static double oscillates(double h) { return h * h * (1.5 + sin(40 * log(h))); }
static double early_kink(double h) { return h > 0.1 ? 0.01 * sqrt(h / 0.1) : h * h; }
static double at_floor(double h) { return h * h * h * h + 1e-9 * jitter(h); }
static double only_noise(double h) { return 1e-12 * jitter(h); }
static double stays(double h) { return 2.385 + 0 * h; }
static double stays_nearly(double h) { return 2.385 * (1 + 2e-16 * fmod(-log2(h), 3)); }

#define PASS SCALLOP_ORDER_PASS
#define MEASURED SCALLOP_ORDER_MEASURED
#define TOO_LOW SCALLOP_ORDER_TOO_LOW
#define TOO_HIGH SCALLOP_ORDER_TOO_HIGH
#define DRIFTING SCALLOP_ORDER_DRIFTING
#define PLATEAU SCALLOP_ORDER_PLATEAU
#define FLOOR SCALLOP_ORDER_FLOOR_LIMITED
#define INSUFFICIENT SCALLOP_ORDER_INSUFFICIENT
#define SCATTERED SCALLOP_ORDER_SCATTERED
enum { NOT_A_PASS = 100 };

#define OF(e, rows, h0, ratio) \
  NULL, { e, rows, h0, ratio }
#define ROWS(text) \
  text, { NULL, 0, 0, 0 }
#define TEXTBOOK ROWS("0.1 0.011  0.05 0.0026  0.025 6.3e-4  0.0125 1.57e-4")
static const struct told {
  const char *rows;
  struct {
    error_of *e;
    int rows;
    double h0, ratio;
  } of; /* where rows is NULL */
  double order;
  enum how how;
  int verdict;
  const char *reason; /* whole, or behind ... a part of it; NULL: any */
  double found;       /* the order that is found, to 1e-3, where it is not 0 */
  int used;           /* at least */
} told[] = {
  { TEXTBOOK, 2, EXACTLY, PASS, "order 2.04 in rows 1 to 4", 0, 4 },
  { TEXTBOOK, 1.5, EXACTLY, TOO_HIGH, "order 2.04 is 0.54 above the expected 1.5 in rows 1 to 4", 0, 0 },
  { TEXTBOOK, 1.5, AT_LEAST, PASS, NULL, 0, 0 },
  { TEXTBOOK, 3, AT_LEAST, TOO_LOW, "order 2.04 is 0.96 below the expected 3 in rows 1 to 4", 0, 0 },
  { TEXTBOOK, NAN, EXACTLY, MEASURED, "order 2.04 in rows 1 to 4", 0, 0 },
  /* orders that drift */
  { OF(corrected, 5, 0.5, 2), 2, EXACTLY, PASS, NULL, 2, 0 },
  { OF(corrected, 4, 0.5, 2), 1, EXACTLY, TOO_HIGH, NULL, 0, 0 },
  { OF(lower_term, 5, 0.5, 2), 2, EXACTLY, DRIFTING,
    "the orders fall faster and faster: a term of lower order takes over: pairwise orders 1.99, 1.99, 1.98, 1.96 in "
    "rows 1 to 5",
    0, 0 },
  { OF(higher_term, 5, 1, 2), 2, EXACTLY, DRIFTING, NULL, 0, 0 },
  { OF(higher_term, 5, 1, 2), 2, AT_LEAST, DRIFTING,
    "the orders rise faster and faster: a term of lower order has the other sign: pairwise orders 2.05, 2.1, 2.22, "
    "2.58 in rows 1 to 5",
    0, 0 },
  { OF(over_logarithm, 8, 1e-3, 10), 2, AT_LEAST, PASS, NULL, 0, 0 },
  /* that come down to 2, from tables too short for a limit; that arrive from far; that only pass by */
  { ROWS("0.5 0.26  0.25 0.055  0.125 0.012  0.0625 0.0029"), 2, EXACTLY, PASS,
    "the orders have come to 2.05: 2.24, 2.2, 2.05", 0, 0 },
  { ROWS("0.5 0.7  0.25 0.1  0.125 0.02  0.0625 0.004"), 2, EXACTLY, NOT_A_PASS, NULL, 0, 0 },
  { ROWS("0.1 4.3e-2  0.05 1.9e-2  0.025 6.6e-3  0.0125 1.9e-3  0.00625 5e-4  0.003125 1.27e-4"), 2, EXACTLY, PASS,
    "the orders have come to 1.98: 1.18, 1.53, 1.8, 1.93, 1.98", 0, 0 },
  { ROWS("1 1.07  0.5 0.16  0.25 0.0331  0.125 0.0107"), 2, EXACTLY, DRIFTING,
    "the orders have not settled: pairwise orders 2.74, 2.27, 1.63 in rows 1 to 4", 0, 0 },
  { ROWS("0.1 5.12e-2  0.05 2.49e-3  0.025 8.93e-5  0.0125 2.89e-6  0.00625 8.72e-8"), 5, EXACTLY, PASS, NULL, 0, 0 },
  { ROWS("0.1 0.1  0.05 2.5e-2  0.025 6.25e-3  0.0125 1.56e-3  0.00625 3.9e-4  0.003125 1.95e-4"), 2, EXACTLY, DRIFTING,
    NULL, 0, 0 },
  /* floors */
  { OF(levels_off, 9, 0.5, 2), 2, EXACTLY, PLATEAU,
    "err stops falling near 0.001 in rows 6 to 9: a plateau far above roundoff", 0, 0 },
  { OF(levels_off, 5, 0.1, 2), 2, EXACTLY, PLATEAU, NULL, 0, 0 },
  { OF(levels_off, 9, 0.5, 2), NAN, EXACTLY, PLATEAU, NULL, 0, 0 },
  { OF(levels_off, 14, 1, 2), NAN, EXACTLY, PLATEAU, NULL, 0, 0 }, /* converges to something else than the answer */
  { OF(levels_off_low, 14, 1, 2), 3, EXACTLY, PLATEAU, NULL, 0, 0 },
  { OF(flat, 5, 0.5, 2), 2, EXACTLY, TOO_LOW, "order 0 is 2 below the expected 2 in rows 1 to 5", 0, 0 },
  { OF(flat, 4, 0.5, 2), NAN, EXACTLY, MEASURED, "order 0 in rows 1 to 4", 0, 0 },
  { OF(at_roundoff, 20, 0.5, 2), 4, EXACTLY, PASS, "...left out: ", 0, 8 },
  { OF(at_high_floor, 8, 0.25, 2), 4, EXACTLY, FLOOR, NULL, 0, 0 },
  { OF(only_noise, 20, 1, 2), NAN, EXACTLY, FLOOR, NULL, 0, 0 },
  /* four rows above roundoff; and a difference quotient, whose roundoff grows as 1/h */
  { ROWS("0.5 1.1e-4  0.25 4.4e-7  0.125 1.7e-9  0.0625 6.7e-12  0.03125 4.4e-16  0.015625 2.2e-16"), 8, EXACTLY, PASS,
    "order 7.99 in rows 1 to 4; left out: roundoff in rows 5 and 6", 0, 0 },
  { ROWS("1e-1 4.53e-3  1e-2 4.53e-5  1e-3 4.53e-7  1e-4 4.53e-9  1e-5 5.86e-11  1e-6 1.63e-10  1e-7 5.86e-11  "
         "1e-8 6.6e-9  1e-9 6.6e-9  1e-10 6.73e-7  1e-11 1.04e-5"),
    2, EXACTLY, PASS, NULL, 0, 0 },
  /* A plateau behind rows of slope 1 is none of roundoff's; a finest row that is off is no drift; a rough floor leaves
   * the rows above it. */
  { ROWS("0.5 2.73  0.166667 0.913  0.0555556 0.306  0.0185185 0.104  0.00617284 0.0361  0.00205761 0.0136  "
         "0.000685871 0.00615  0.000228624 0.00365"),
    1, EXACTLY, PLATEAU, "err stops falling near 0.0037 in rows 7 and 8: a plateau far above roundoff", 0, 0 },
  { ROWS("0.5 0.0625  0.25 0.00390625  0.125 0.000244140625  0.0625 1.52587890625e-05  0.03125 9.5367431640625e-07  "
         "0.015625 5.93e-08"),
    4, EXACTLY, PASS, "order 4 in rows 1 to 5; left out: roundoff in row 6", 0, 0 },
  { ROWS("0.5247 0.886418  0.2624 0.221553  0.1312 0.0553687  0.06559 0.0138258  0.0328 0.00348085  0.0164 "
         "0.000863772  0.008199 0.000196189  0.0041 0.000101625  0.00205 4.78873e-05  0.001025 5.92781e-05  0.0005124 "
         "6.75894e-05"),
    2, EXACTLY, PASS, NULL, 0, 0 },
  { ROWS("0.5 1  0.25 0.1  0.125 0.03125  0.0625 0.015625  0.03125 0.0078125"), 1, EXACTLY, PASS, NULL, 0, 0 },
  /* h^4 + 4e-7 h, 3 digits: the slow tail is a term of lower order and no floor. */
  { ROWS("0.5 0.0232  0.2464 0.00137  0.1214 8.06e-5  0.05984 4.77e-6  0.02949 2.92e-7  0.01453 2.24e-8  0.007161 "
         "3.86e-9  0.003529 1.48e-9"),
    4, EXACTLY, NOT_A_PASS, NULL, 0, 0 },
  /* More rows than anybody prints, of few digits: rounding is not looked at. A zero behind a floor is none of it. */
  { OF(one_digit, 100, 1, 1.2), 1, EXACTLY, PASS, NULL, 0, 0 },
  { OF(ends_at_zero, 20, 0.5, 2), 4, EXACTLY, PASS, "...err is 0 in rows", 0, 0 },
  { OF(oscillates, 20, 1, 1.3), NAN, EXACTLY, NOT_A_PASS, NULL, 0, 0 },
  /* few rows, and zeros */
  { ROWS(""), NAN, EXACTLY, INSUFFICIENT, NULL, 0, 0 },
  { ROWS("1 1  0.5 0.25"), 2, EXACTLY, INSUFFICIENT, "2 usable rows, an order takes 3", 2, 0 },
  { ROWS("1 1"), 2, EXACTLY, INSUFFICIENT, "1 usable row, an order takes 3", 0, 0 },
  { ROWS("1 1"), NAN, EXACTLY, INSUFFICIENT, NULL, 0, 0 },
  { ROWS("1 1  0.5 0.25  0.25 0.2  0.125 0.19"), 2, EXACTLY, PLATEAU,
    "err stops falling near 0.19 in rows 2 to 4: a plateau far above roundoff", 0, 0 },
  { ROWS("1 1  0.5 0.25  0.25 0.0625"), 2, EXACTLY, PASS, "order 2 in rows 1 to 3", 0, 0 },
  { ROWS("1 1  0.5 0.25  0.25 0.05"), 2.16, EXACTLY, SCATTERED, NULL, 0, 0 },
  { ROWS("1 0  0.5 0  0.25 0"), 2, EXACTLY, PASS, "exact: every err is 0", 0, 0 },
  { ROWS("1 0  0.5 0  0.25 0"), NAN, EXACTLY, MEASURED, "exact: every err is 0", 0, 0 },
  { ROWS("1 0  0.5 0.25  0.25 0.0625  0.125 0.015625  0.0625 0.00390625"), 2, EXACTLY, PASS,
    "order 2 in rows 2 to 5; left out: err is 0 in row 1", 0, 0 },
  { ROWS("1 -0.3  0.5 0.25  0.25 0.0625  0.125 0.015625  0.0625 0.00390625"), 2, EXACTLY, PASS,
    "order 2 in rows 2 to 5; left out: before a change of sign in row 1", 0, 0 },
  { ROWS("0.1 -0.1  0.05 0.025  0.025 -0.00625  0.0125 0.00156  0.00625 -3.9e-4"), 2, EXACTLY, INSUFFICIENT,
    "1 usable row, an order takes 3; left out: before a change of sign in rows 1 to 4", 0, 0 },
  /* tables that are none */
  { ROWS("1 1  0.5 0.25  0.5 0.1  0.125 nan"), 2, EXACTLY, SCALLOP_ORDER_INVALID,
    "NaN in row 4; h repeated in rows 2 and 3", 0, 0 },
  { ROWS("1 1  0.5 0.25  0.3 0.1  0.125 1  0.5 4"), 2, EXACTLY, SCALLOP_ORDER_INVALID, "h repeated in rows 2 and 5", 0,
    0 },
  { ROWS("1 1  0.5 0.25  0.25 inf  0.125 1"), NAN, EXACTLY, SCALLOP_ORDER_INVALID, NULL, 0, 0 },
  { ROWS("1 1  nan 0.25  0.3 0.1  0.125 1"), NAN, EXACTLY, SCALLOP_ORDER_INVALID, NULL, 0, 0 },
  { ROWS("1 1  0.5 0.25  0.3 0.1  0 1"), NAN, EXACTLY, SCALLOP_ORDER_INVALID, NULL, 0, 0 },
  /* values; down to roundoff; that stay the same, or are noise alone: neither is exact, for all that is known */
  { ROWS("1 3  0.5 3  0.25 3  0.125 3"), 2, VALUES, FLOOR, NULL, 0, 0 },
  { ROWS("1 3  0.5 2"), 2, VALUES, INSUFFICIENT, NULL, 0, 0 },
  { ROWS("1 3  0.5 2"), NAN, VALUES, INSUFFICIENT, NULL, 0, 0 },
  { OF(value, 40, 1, 2), 2, VALUES, PASS, NULL, 0, 15 },
  { OF(stays, 12, 1, 2), NAN, VALUES, FLOOR, NULL, 0, 0 },
  { OF(stays_nearly, 20, 1, 2), NAN, VALUES, FLOOR, NULL, 0, 0 },
};

TEST(tables)
{
  for (const struct told *t = told; t < told + sizeof told / sizeof *told; t++) {
    if (t->rows)
      read_rows(t->rows);
    else
      fill(t->of.e, t->of.rows, t->of.h0, t->of.ratio);
    judge(t->order, t->how);
    if (t->verdict == NOT_A_PASS)
      assert_true(result.verdict > MEASURED);
    else
      expect((enum scallop_order_verdict)t->verdict, t->reason);
    if (t->found != 0)
      CHECK_NEAR(result.order, t->found, 1e-3);
    assert_true(result.used >= t->used);
  }
}

/* Which interval goes with the order, and what it is by hand */
TEST(intervals)
{
  static const struct {
    const char *rows;
    enum scallop_order_interval interval;
    double low, high; /* 0: any */
  } cases[] = {
    { "0.1 0.011  0.05 0.0026  0.025 6.3e-4  0.0125 1.57e-4", SCALLOP_ORDER_SLOPE, 0, 0 },
    { "0.5 0.26  0.25 0.055  0.125 0.012  0.0625 0.0029", SCALLOP_ORDER_PAIRWISE, 0, 0 },
    { "1 1  0.5 0.25  0.25 0.0625", SCALLOP_ORDER_PAIRWISE, 2, 2 },
    { "0.1 0.1  0.05 2.5e-2  0.025 6.25e-3  0.0125 1.56e-3  0.00625 3.9e-4  0.003125 1.95e-4", SCALLOP_ORDER_PAIRWISE,
      1, 2.0023101606872 },
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    read_rows(cases[i].rows);
    judge(2, EXACTLY);
    assert_int_equal(result.interval, cases[i].interval);
    if (i == 0) /* least squares by hand: the slope over log2 h is (3 (y1 - y4) + y2 - y3)/10 */
      CHECK_NEAR(result.order, (3 * log2(points[0].err / points[3].err) + log2(points[1].err / points[2].err)) / 10,
                 1e-13);
    if (cases[i].low != 0) {
      CHECK_NEAR(result.low, cases[i].low, 1e-12);
      CHECK_NEAR(result.high, cases[i].high, 1e-12);
    }
  }
  fill(corrected, 5, 0.5, 2);
  judge(2, EXACTLY);
  assert_int_equal(result.interval, SCALLOP_ORDER_LIMIT);
  assert_string_equal(scallop_order_interval_text(SCALLOP_ORDER_NO_INTERVAL), "none");
}

TEST(drifts_of_any_length)
{
  for (int rows = 4; rows <= 12; rows++)
    for (double h0 = 0.1; h0 < 0.6; h0 *= 5)
      for (int how = EXACTLY; how <= AT_LEAST; how++) {
        fill(lower_term, rows, h0, 2);
        judge(2, (enum how)how);
        assert_true((rows == 4 && h0 > 0.1) || result.verdict != PASS);
      }
  for (int rows = 5; rows < 12; rows++) {
    fill(logarithm, rows, 1e-3, 10);
    judge(2, EXACTLY);
    expect(DRIFTING, NULL);
    judge(2, AT_LEAST);
    expect(DRIFTING, NULL);
    judge(NAN, EXACTLY);
    expect(DRIFTING, NULL);
  }
}

TEST(finds_orders)
{
  static const struct {
    error_of *e;
    double order;
  } cases[] = { { cubic, 3 },  { square_negative, 2 }, { flat, 0 },     { growing, -1 },
                { root, 0.5 }, { changes_sign, 2 },    { at_floor, 4 }, { early_kink, 2 } };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
    for (double ratio = 1.3; ratio < 3; ratio += 0.35) {
      fill(cases[k].e, 24, 1, ratio);
      measure(EXACTLY);
      expect(MEASURED, NULL);
      CHECK_NEAR(result.order, cases[k].order, 0.1);
      assert_true(result.low <= cases[k].order + 1e-9 && cases[k].order <= result.high + 1e-9 && result.used >= 3);
    }
}

TEST(leaves_out_with_a_reason)
{
  static const struct {
    error_of *e;
    int rows, first, last; /* the points that are so */
    enum scallop_order_use use;
  } cases[] = {
    { at_floor, 24, 0, 0, SCALLOP_ORDER_USED },       { at_floor, 24, 8, 23, SCALLOP_ORDER_FLOOR }, /* h^4 < 1e-9 */
    { early_kink, 12, 0, 0, SCALLOP_ORDER_COARSE },   { changes_sign, 12, 0, 0, SCALLOP_ORDER_BEFORE_SIGN_CHANGE },
    { changes_sign, 12, 11, 11, SCALLOP_ORDER_USED }, { cubic_to_zero, 6, 5, 5, SCALLOP_ORDER_ZERO }
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    fill(cases[k].e, cases[k].rows, 1, 2);
    measure(EXACTLY);
    expect(MEASURED, NULL);
    for (int i = cases[k].first; i <= cases[k].last; i++)
      assert_int_equal(points[i].use, cases[k].use);
  }
}

/* Known noise is never fitted, of errors and of values, whose differences have that of both; errors that grow are no
 * roundoff floor when the rounding is known to be far below them. Orders: 2, -1, 2 */
TEST(known_noise)
{
  for (int kind = 0; kind < 3; kind++) {
    check_failed = print_last;
    count = kind == 1 ? 30 : 20;
    for (int i = 0; i < count; i++) {
      double h = ldexp(1, -i);
      points[i] = kind == 0 ? (struct scallop_order_point){ .h = h, .err = h * h + 1e-6, .noise = 1e-6 }
                  : kind == 1
                      ? (struct scallop_order_point){ .h = h, .err = i < 4 ? 1e-3 * h * h : 1e-6 / h, .noise = 1e-14 }
                      : (struct scallop_order_point){ .h = h, .err = 1 + h * h + 1e-7 * (i % 2), .noise = 1e-7 };
    }
    measure(kind == 2 ? VALUES : EXACTLY);
    expect(MEASURED, NULL);
    CHECK_NEAR(result.order, kind == 1 ? -1 : 2, kind == 1 ? 0.05 : 0.02);
    for (int i = 0; i < count; i++)
      assert_true(kind == 1 || points[i].use != SCALLOP_ORDER_USED
                  || (kind == 0 ? points[i].err > 1e-4 : ldexp(1, -2 * i) > 1e-5));
  }
}

TEST(within_the_noise)
{
  read_rows("1 1e-16  0.5 0  0.25 1e-16");
  for (int i = 0; i < 3; i++)
    points[i].noise = 1e-16;
  judge(2, EXACTLY);
  expect(PASS, "exact: every err is within its noise");
  for (int i = 0; i < 3; i++)
    points[i].err = 0;
  measure(EXACTLY);
  expect(MEASURED, NULL);
  CHECK_EQUAL(result.order, NAN);
}

/* Rows in any order are sorted; of many rows means are fitted: the order stays what it is. */
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
    expect(PASS, NULL);
    assert_int_equal(result.interval, SCALLOP_ORDER_LIMIT);
    CHECK_NEAR(result.order, 2, noisy ? 0.05 : 1e-4);
  }
  count = 10;
  for (int i = 0; i < 10; i++)
    points[i] = (struct scallop_order_point){ .h = ldexp(1, -(i * 7 % 10)), .err = cubic(ldexp(1, -(i * 7 % 10))) };
  measure(EXACTLY);
  expect(MEASURED, NULL);
  CHECK_NEAR(result.order, 3, 0.1);
  assert_true(points[0].h > points[1].h);
}

TEST(invalid_rows_are_listed)
{
  read_rows("-1 1  0 0.25  0.3 inf  0.125 1  0.0625 4");
  points[4].noise = -1;
  judge(2, EXACTLY);
  expect(SCALLOP_ORDER_INVALID, "an infinite number in row 3; h <= 0 in rows 1 and 2; noise < 0 or NaN in row 5");
  count = 30;
  for (int i = 0; i < 30; i++)
    points[i] = (struct scallop_order_point){ i + 1, i % 4 == 1 || i % 4 == 2 ? NAN : 1, .row = i < 20 ? 0 : 3 * i };
  judge(2, EXACTLY);
  expect(SCALLOP_ORDER_INVALID, "NaN in rows 2, 3, 6, 7, 10, 11, 14, 15, 18, 19, 63 and 4 more");
  CHECK_EQUAL(result.order, NAN);
}

/* NASA's example of the grid convergence index: the pressure recovery of an inlet on three grids (NPARC Alliance,
 * Examining Spatial (Grid) Convergence): p = 1.786170, gci = 0.103083 %, gci of the coarser two 0.356249 %. */
TEST(grid_convergence)
{
  static const char inlet[] = "4 0.96178  2 0.96854  1 0.97050";
  read_rows(inlet);
  measure(VALUES);
  expect(INSUFFICIENT, "2 usable differences of values, an order takes 3");
  CHECK_NEAR(result.order, 1.786170, 1e-6);
  CHECK_NEAR(result.gci, 0.00103083, 1e-8);
  CHECK_NEAR(result.asymptotic_ratio, 0.00356249 / (pow(2, 1.786170) * 0.00103083), 1e-5);
  CHECK_NEAR(result.asymptotic_ratio, 0.97050 / 0.96854, 1e-12);
  read_rows(inlet);
  judge(2, VALUES);
  CHECK_NEAR(result.asymptotic_ratio, (0.96854 - 0.96178) / (0.97050 - 0.96854) / 4 * 0.97050 / 0.96854, 1e-12);
  read_rows("4 1  2 2  1 1.5");
  judge(2, VALUES);
  CHECK_EQUAL(result.gci, NAN);
}

/* Values as simulations print them: pi + 0.9 h^p in doubles, rounded to a decimal, or with noise of that size; h down
 * to far below where the values stay; every other ratio 1.5, or all of them 2. */
enum values { IN_DOUBLES, ROUNDED, NOISY };

static void fill_values(int rows, double p, enum values kind, double decimal, bool even)
{
  double h = 1;
  check_failed = print_last;
  count = rows;
  for (int i = 0; i < rows; i++, h /= even || i % 2 ? 2 : 1.5) {
    double x = 3.14159265358979 + 0.9 * pow(h, p);
    if (kind != IN_DOUBLES)
      x = kind == NOISY ? x + decimal * jitter(h) : decimal * round(x / decimal);
    points[i] = (struct scallop_order_point){ .h = h, .err = x };
  }
}

TEST(from_values)
{
  for (double p = 0.5; p <= 4; p += 0.5) {
    fill_values(9, p, IN_DOUBLES, 0, false);
    measure(VALUES);
    assert_int_equal(count, 8);
    expect(MEASURED, NULL);
    CHECK_NEAR(result.order, p, 0.02);
    CHECK_NEAR(points[0].err, 0.9, 0.02);
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
        for (int rows = 12; rows <= 40; rows += 4)
          for (int even = 0; even < 2; even++) {
            fill_values(rows, p, (enum values)kind, decimals[k], even);
            measure(VALUES);
            bool fitted = result.verdict == MEASURED, sees_it = kind == IN_DOUBLES || (kind == ROUNDED && rows == 40);
            if (fitted ? !check_near(result.order, p, 0.1) : sees_it)
              fail_msg("order %g, kind %d to %g, %s, %d values: %s, %g", p, kind, decimals[k], even ? "even" : "uneven",
                       rows, scallop_order_verdict_text(result.verdict), result.order);
          }
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
