/* The operations on series term by term, against sums that are written out here. */
#include "tests/support/random_series.h"

/* The coefficient of x^k in a b */
static void convolution(fmpq_t sum, const struct series *a, const struct series *b, slong k)
{
  SCOPED(fmpq, p, q);
  fmpq_zero(sum);
  for (slong i = a->first; i <= k - b->first; i++) {
    series_rational_coefficient(p, a, i);
    series_rational_coefficient(q, b, k - i);
    fmpq_addmul(sum, p, q);
  }
}

static void check_coefficient(const struct series *s, slong power, const fmpq_t wanted, const char *what)
{
  SCOPED(fmpq, got);
  assert_true(series_rational_coefficient(got, s, power));
  if (!fmpq_equal(got, wanted))
    fail_msg("%s: x^%ld", what, (long)power);
}

/* What is known to all orders stays so. */
static slong shifted(slong known, slong power) { return known >= SERIES_ALL ? SERIES_ALL : known + power; }

TEST(products_are_convolutions)
{
  struct random r = { 20260804 };
  SCOPED(work, w);
  SCOPED(fmpq, sum);
  for (int i = 0; i < 300; i++) {
    random_series(&w[0], &r, random_below(&r, 9) - 4);
    random_series(&w[1], &r, random_below(&r, 9) - 4);
    series_mul(&w[2], &w[0], &w[1], &ring);
    slong first = w[0].first + w[1].first;
    slong known = first + least(LENGTH, least(w[0].known - w[0].first, w[1].known - w[1].first));
    check_known(&w[2], known, "a b");
    assert_true(w[2].known <= least(shifted(w[0].known, w[1].first), shifted(w[1].known, w[0].first)));
    for (slong k = first; k < least(w[2].known, FAR); k++) {
      convolution(sum, &w[0], &w[1], k);
      check_coefficient(&w[2], k, sum, "a b");
    }
    series_mul(&w[0], &w[0], &w[1], &ring); /* in place: the same, and no more is known */
    assert_int_equal(w[0].known, w[2].known);
    for (slong k = first; k < least(w[2].known, FAR); k++) {
      assert_true(series_rational_coefficient(sum, &w[2], k));
      check_coefficient(&w[0], k, sum, "a b in place of a");
    }
  }
}

/* f(g) by Horner's rule in the ring */
static void horner(struct series *to, const struct series *f, const struct series *g, const struct ring *in)
{
  SCOPED(fmpq, c);
  SCOPED(series, sum, term);
  for (slong k = 2 * LENGTH; k >= 0; k--) {
    series_rational_coefficient(c, f, k);
    series_set_rational(&term, c);
    series_mul(&sum, &sum, g, in);
    series_add(&sum, &sum, &term, in);
  }
  series_set(to, &sum);
}

TEST(composition)
{
  struct random r = { 20260805 };
  SCOPED(work, w);
  for (int i = 0; i < 200; i++) {
    random_terms(&w[0], &r, random_below(&r, 3), 1 + random_below(&r, LENGTH));
    random_terms(&w[1], &r, 1 + random_below(&r, 3), 1 + random_below(&r, LENGTH));
    horner(&w[2], &w[0], &w[1], &longer);
    slong known = LENGTH;
    for (int k = 0; k < 2; k++) /* what is cut off either does not count below its power */
      if (random_below(&r, 2)) {
        slong cut = w[k].first + 1 + random_below(&r, LENGTH);
        series_truncate(&w[k], cut);
        known = least(known, cut);
      }
    series_compose(&w[3], &w[0], &w[1], &ring);
    check_known(&w[3], known, "f(g)");
    check_same(&w[3], &w[2], "f(g)");
    as_balls(&w[4], &w[1]);
    series_compose(&w[4], &w[0], &w[4], &ring);
    check_known(&w[4], known, "f(g) in balls");
    check_same(&w[4], &w[2], "f(g) in balls");
    series_compose(&w[0], &w[0], &w[1], &ring);
    check_same(&w[0], &w[2], "f(g) in place of f");
  }
}

static void check_inflated(const struct series *a, slong power)
{
  SCOPED(fmpq, c);
  SCOPED(series, w);
  series_inflate(&w, a, power);
  assert_true(a->known < SERIES_ALL ? w.known == power * a->known : w.known >= FAR);
  for (slong k = -FAR; k < least(w.known, FAR); k++) {
    if (k % power != 0)
      fmpq_zero(c);
    else
      series_rational_coefficient(c, a, k / power);
    check_coefficient(&w, k, c, "a(x^power)");
  }
}

TEST(shift_scale_and_inflate)
{
  struct random r = { 20260806 };
  SCOPED(work, w);
  SCOPED(fmpq, c, factor);
  for (int i = 0; i < 200; i++) {
    random_series(&w[0], &r, random_below(&r, 9) - 4);
    random_fraction(factor, &r);
    slong power = random_below(&r, 9) - 4;
    series_shift(&w[1], &w[0], power);
    series_scale(&w[2], &w[0], factor, &ring);
    assert_true(w[0].known == SERIES_ALL ? w[1].known == SERIES_ALL : w[1].known == w[0].known + power);
    assert_true(least(w[2].known, FAR) == least(w[0].known, FAR));
    for (slong k = -FAR + 5; k < least(w[0].known, FAR - 5); k++) {
      series_rational_coefficient(c, &w[0], k);
      check_coefficient(&w[1], k + power, c, "a x^power");
      fmpq_mul(c, c, factor);
      check_coefficient(&w[2], k, c, "a times a number");
    }
    check_inflated(&w[0], 1 + random_below(&r, 3));
  }
}

TEST(integral_and_derivative)
{
  struct random r = { 20260807 };
  SCOPED(work, w);
  SCOPED(fmpq, c);
  for (int i = 0; i < 200; i++) {
    random_series(&w[0], &r, random_below(&r, 4));
    as_balls(&w[1], &w[0]);
    series_derivative(&w[2], &w[1], &ring); /* of balls it holds that of the fractions in them */
    series_derivative(&w[1], &w[0], &ring);
    assert_true(w[2].known == w[1].known);
    for (slong k = 0; k < least(w[1].known, FAR); k++)
      assert_true(same_coefficient(&w[1], &w[2], k, PRECISION));
    series_integral(&w[1], &w[0], &ring);
    series_derivative(&w[2], &w[0], &ring);
    check_known(&w[1], least(w[0].known, LENGTH) + 1, "integral");
    check_known(&w[2], least(w[0].known, LENGTH) - 1, "derivative");
    assert_true(w[0].known == SERIES_ALL || w[1].known <= w[0].known + 1);
    assert_true(w[0].known == SERIES_ALL || w[2].known <= w[0].known - 1);
    for (slong k = 0; k < least(w[0].known, FAR); k++) {
      series_rational_coefficient(c, &w[0], k);
      fmpq_mul_si(c, c, k);
      if (k - 1 < w[2].known)
        check_coefficient(&w[2], k - 1, c, "derivative");
      series_rational_coefficient(c, &w[0], k);
      fmpz_mul_si(fmpq_denref(c), fmpq_denref(c), k + 1);
      fmpq_canonicalise(c);
      if (k + 1 < w[1].known)
        check_coefficient(&w[1], k + 1, c, "integral");
    }
    assert_true(series_coefficient_is_zero(&w[1], 0));
  }
}

/* Terms below x^before, by powers of an exact x */
static void sum_of_terms(fmpq_t sum, const struct series *s, const fmpq_t x, slong before)
{
  SCOPED(fmpq, c, power);
  fmpq_zero(sum);
  for (slong k = s->first; k < before; k++) {
    series_rational_coefficient(c, s, k);
    fmpq_pow_si(power, x, k);
    fmpq_addmul(sum, c, power);
  }
}

TEST(values)
{
  struct random r = { 20260810 };
  SCOPED(work, w);
  SCOPED(fmpq, x, sum);
  SCOPED(arb, at, value);
  for (int i = 0; i < 200; i++) {
    random_positive(x, &r);
    arb_set_fmpq(at, x, PRECISION);
    random_terms(&w[0], &r, random_below(&r, 9) - 4, 1 + random_below(&r, LENGTH));
    as_balls(&w[1], &w[0]);
    slong before = w[0].first + random_below(&r, LENGTH + 2);
    sum_of_terms(sum, &w[0], x, before);
    for (int k = 0; k < 2; k++) {
      series_value(value, &w[k], at, before, PRECISION);
      assert_true(arb_contains_fmpq(value, sum));
      assert_true(mag_cmp_2exp_si(arb_radref(value), -PRECISION / 2) < 0);
    }
  }
}

/* A coefficient that is proven to be 0 becomes 0 and nothing else changes. */
TEST(a_term_set_to_zero)
{
  struct random r = { 20260811 };
  SCOPED(work, w);
  for (int i = 0; i < 100; i++) {
    random_series(&w[0], &r, random_below(&r, 9) - 4);
    as_balls(&w[1], &w[0]);
    slong power = random_below(&r, 20) - 10;
    for (int k = 0; k < 2; k++) {
      series_set(&w[2], &w[k]);
      series_set_zero(&w[2], power);
      assert_true(series_coefficient_is_zero(&w[2], power) && w[2].known == w[k].known);
      for (slong j = -FAR; j < least(w[k].known, FAR); j++)
        assert_true(j == power || same_coefficient(&w[2], &w[k], j, PRECISION));
    }
  }
}
