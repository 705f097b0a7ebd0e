/* The arithmetic of truncated Laurent series: the laws of a ring, quotients, and what a series claims to know. */
#include "tests/support/random_series.h"

static void check_laws(const struct series *a, const struct series *b, const struct series *c)
{
  SCOPED(work, w);
  series_add(&w[0], a, b, &ring);
  series_add(&w[1], b, a, &ring);
  check_same(&w[0], &w[1], "a + b = b + a");
  series_add(&w[0], &w[0], c, &ring);
  series_add(&w[1], b, c, &ring);
  series_add(&w[1], a, &w[1], &ring);
  check_same(&w[0], &w[1], "(a + b) + c = a + (b + c)");
  series_mul(&w[0], a, b, &ring);
  series_mul(&w[1], b, a, &ring);
  check_same(&w[0], &w[1], "a b = b a");
  series_mul(&w[0], &w[0], c, &ring);
  series_mul(&w[1], b, c, &ring);
  series_mul(&w[1], a, &w[1], &ring);
  check_same(&w[0], &w[1], "(a b) c = a (b c)");
  series_add(&w[0], b, c, &ring);
  series_mul(&w[0], a, &w[0], &ring);
  series_mul(&w[1], a, b, &ring);
  series_mul(&w[2], a, c, &ring);
  series_add(&w[1], &w[1], &w[2], &ring);
  check_same(&w[0], &w[1], "a (b + c) = a b + a c");
  series_sub(&w[0], a, b, &ring);
  series_neg(&w[1], b);
  series_add(&w[1], a, &w[1], &ring);
  check_same(&w[0], &w[1], "a - b = a + (-b)");
  series_sub(&w[1], a, a, &ring);
  series_add(&w[1], &w[1], b, &ring);
  check_same(&w[1], b, "(a - a) + b = b");
}

TEST(laws_of_a_ring)
{
  struct random r = { 20260801 };
  SCOPED(work, w);
  for (int i = 0; i < 400; i++) {
    for (int k = 0; k < 3; k++)
      random_series(&w[k], &r, random_below(&r, 9) - 4);
    check_laws(&w[0], &w[1], &w[2]);
    for (int k = 0; k < 3; k++)
      as_balls(&w[3 + k], &w[k]);
    check_laws(&w[3], &w[4], &w[5]);
    check_laws(&w[0], &w[4], &w[2]);
  }
}

/* A quotient of series with n known terms from their first on has n known terms, wherever they begin. */
static void check_division(const struct series *a, const struct series *b)
{
  SCOPED(work, w);
  assert_true(series_div(&w[0], a, b, &ring));
  check_known(&w[0], least(least(a->known - a->first, b->known - b->first), LENGTH) + a->first - b->first, "a/b");
  series_mul(&w[1], &w[0], b, &ring);
  check_known(&w[1], least(w[0].known - w[0].first, least(b->known - b->first, LENGTH)) + a->first, "(a/b) b");
  check_same(&w[1], a, "(a/b) b = a");
  series_set(&w[2], a); /* aliases */
  assert_true(series_div(&w[2], &w[2], b, &ring));
  check_same(&w[2], &w[0], "a/b in place of a");
  series_set(&w[2], b);
  assert_true(series_div(&w[2], a, &w[2], &ring));
  check_same(&w[2], &w[0], "a/b in place of b");
}

TEST(division_undoes_multiplication)
{
  struct random r = { 20260802 };
  SCOPED(work, w);
  for (int i = 0; i < 400; i++) {
    random_series(&w[0], &r, random_below(&r, 9) - 4);
    random_series(&w[1], &r, random_below(&r, 9) - 4);
    as_balls(&w[2], &w[0]);
    as_balls(&w[3], &w[1]);
    check_division(&w[0], &w[1]);
    check_division(&w[2], &w[3]);
    check_division(&w[0], &w[3]);
    check_division(&w[2], &w[1]);
  }
}

/* A divisor whose first coefficients are exactly 0 begins later. */
TEST(division_by_a_series_with_leading_zeros)
{
  SCOPED(work, w);
  SCOPED(arb_poly, poly);
  arb_poly_set_coeff_si(poly, 2, 4); /* 4 x^2, with two zeros in front */
  series_set_ball_poly(&w[0], poly, SERIES_ALL);
  series_set_si(&w[1], 1);
  assert_true(series_div(&w[2], &w[1], &w[0], &ring));
  series_scale_si(&w[2], &w[2], 4, &ring);
  series_shift(&w[2], &w[2], 2);
  check_same(&w[2], &w[1], "4 x^2/(4 x^2)");
  check_known(&w[2], LENGTH, "4 x^2/(4 x^2)");
}

/* Refused, with the quotient as it was: 0, 0 with an error term, and a ball that holds 0. */
TEST(division_by_what_may_be_zero)
{
  struct random r = { 20260803 };
  SCOPED(work, w);
  SCOPED(arb, ball);
  random_terms(&w[0], &r, -2, 5);
  series_set(&w[1], &w[0]);
  series_set_si(&w[2], 1);
  series_set_si(&w[3], 0);
  assert_false(series_div(&w[0], &w[2], &w[3], &ring));
  series_set_x(&w[3]);
  series_truncate(&w[3], 1);
  assert_false(series_div(&w[0], &w[2], &w[3], &ring));
  arb_set_si(ball, 1);
  mag_set_d(arb_radref(ball), 1.5);
  series_set_ball(&w[3], ball);
  assert_false(series_div(&w[0], &w[2], &w[3], &ring));
  assert_false(series_div(&w[0], &w[0], &w[3], &ring));
  series_set_x(&w[4]);
  series_add(&w[3], &w[3], &w[4], &ring); /* the ball may be 0, so that what is behind it does not count */
  assert_false(series_div(&w[0], &w[2], &w[3], &ring));
  assert_true(w[0].kind == SERIES_FRACTIONS && w[0].first == -2 && w[0].known == SERIES_ALL);
  check_same(&w[0], &w[1], "unchanged");
}

/* One step of a random calculation, the same in both rings. In `shorter` every series may have been cut. */
static void random_step(struct series *to, const struct series *a, const struct series *b, int step,
                        const struct ring *in)
{
  SCOPED(fmpq, half);
  switch (step) {
  case 0: series_add(to, a, b, in); break;
  case 1: series_sub(to, a, b, in); break;
  case 2: series_mul(to, a, b, in); break;
  case 3: series_div(to, a, b, in); break;
  case 4: series_shift(to, a, 1); break;
  default: fmpq_set_si(half, -1, 2); series_scale(to, a, half, in);
  }
}

/* Six numbers, each replaced again and again by a result of two others: whatever is known with n terms is the same with
 * 3 n terms and nothing cut off. Known is never more than the longer calculation knows. */
static void check_calculation(struct random *r, bool balls)
{
  enum { NUMBERS = 6, STEPS = 12 };
  SCOPED(work, few, many);
  for (int i = 0; i < NUMBERS; i++) {
    random_terms(&many[i], r, random_below(r, 5) - 2, 1 + random_below(r, LENGTH));
    if (balls && i % 2)
      as_balls(&many[i], &many[i]);
    series_set(&few[i], &many[i]);
    if (random_below(r, 3) == 0)
      series_truncate(&few[i], few[i].first + 1 + random_below(r, LENGTH));
  }
  for (int i = 0; i < STEPS; i++) {
    int to = random_below(r, NUMBERS), a = random_below(r, NUMBERS), b = random_below(r, NUMBERS),
        step = random_below(r, 6);
    if (step == 3 && (series_coefficient_is_zero(&few[b], few[b].first) || few[b].known <= few[b].first))
      step = 2;
    random_step(&few[to], &few[a], &few[b], step, &ring);
    random_step(&many[to], &many[a], &many[b], step, &longer);
    check_known(&many[to], least(few[to].known, FAR / 4), "with three times the terms");
    check_same(&few[to], &many[to], "n and 3 n terms");
  }
}

TEST(what_is_known_is_right)
{
  struct random r = { 20260808 };
  for (int i = 0; i < 400; i++)
    check_calculation(&r, i % 2);
}

/* The ball of each coefficient holds the fraction, or the function of pi, and is thin. */
TEST(balls_hold_what_is_exact)
{
  struct random r = { 20260809 };
  SCOPED(work, w);
  SCOPED(arb, exact, ball);
  for (int i = 0; i < 600; i++) {
    int step = random_below(&r, 6), in_pi = i % 2 ? 1 + random_below(&r, 3) : 0; /* of which of the two, as bits */
    for (int k = 0; k < 2; k++) {
      random_series(&w[k], &r, random_below(&r, 9) - 4);
      if (in_pi >> k & 1)
        bring_in_pi(&w[k], &r);
      as_balls(&w[2 + k], &w[k]);
    }
    random_step(&w[4], &w[0], &w[1], step, &ring);
    random_step(&w[5], &w[2], &w[3], step, &ring);
    assert_true(w[4].kind != SERIES_BALLS && w[5].kind == SERIES_BALLS);
    for (slong k = w[4].first; k < least(least(w[4].known, w[5].known), FAR); k++) {
      series_coefficient(exact, &w[4], k, 2 * PRECISION);
      series_coefficient(ball, &w[5], k, PRECISION);
      assert_true(arb_contains(ball, exact));
      assert_true(mag_cmp_2exp_si(arb_radref(ball), -PRECISION / 2) < 0);
    }
  }
}

/* The same of what takes one series, and of more bits than functions of pi may have */
TEST(functions_of_pi_one_by_one)
{
  struct random r = { 20261124 };
  SCOPED(work, w);
  SCOPED(arb, exact, ball);
  for (int i = 0; i < 60; i++) {
    random_series(&w[0], &r, random_below(&r, 3));
    bring_in_pi(&w[0], &r);
    series_mul(&w[0], &w[0], &w[0], &longer);
    if (w[0].first < 0)
      continue;
    as_balls(&w[1], &w[0]);
    for (int k = 0; k < 2; k++) {
      struct series *s = &w[k];
      i % 3 == 0   ? series_inflate(s, s, 2)
      : i % 3 == 1 ? series_integral(s, s, &longer)
                   : series_derivative(s, s, &longer);
      series_set_zero(s, s->first + 1);
      series_neg(s, s);
    }
    assert_int_equal(w[0].kind, SERIES_NAMED);
    for (slong k = w[0].first; k < least(least(w[0].known, w[1].known), FAR); k++) {
      series_coefficient(exact, &w[0], k, 2 * PRECISION);
      series_coefficient(ball, &w[1], k, PRECISION);
      assert_true(arb_contains(ball, exact));
    }
  }
  SCOPED(series, pi, large);
  series_set_pi(&pi, NULL);
  series_set_si(&large, 3);
  series_add(&large, &large, &pi, &ring);
  for (int i = 0; i < 14 && large.kind == SERIES_NAMED; i++)
    series_mul(&large, &large, &large, &ring);
  assert_int_equal(large.kind, SERIES_BALLS);
}
