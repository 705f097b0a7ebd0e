/* Functions of series: identities, closed forms, and how many terms are known. */
#include "tests/support/cases.h"

#include "tests/support/random_series.h"

typedef const char *series_function(struct series *to, const struct series *a, const struct ring *ring);

static void take(series_function *f, struct series *to, const struct series *a, const struct ring *in)
{
  const char *wrong = f(to, a, in);
  if (wrong)
    fail_msg("refused: %s", wrong);
}

static void raise_to(struct series *to, const struct series *a, slong p, slong q, const struct ring *in)
{
  SCOPED(series, power);
  SCOPED(fmpq, value);
  fmpq_set_si(value, p, (ulong)q);
  series_set_rational(&power, value);
  const char *wrong = series_power(to, a, &power, in);
  if (wrong)
    fail_msg("refused: %s", wrong);
}

/* A random series that begins with a number above 0 at x^first: in fractions or balls, cut or not. One whose first
 * coefficient is `leading`, unless that is 0 */
static void positive_series(struct series *s, struct random *r, slong first, slong leading)
{
  SCOPED(fmpq, c);
  SCOPED(series, more);
  random_terms(&more, r, 1, 1 + random_below(r, LENGTH));
  fmpq_set_si(c, leading ? leading : 1 + random_below(r, 20), leading ? 1 : 1 + (ulong)random_below(r, 9));
  series_set_rational(s, c);
  series_add(s, s, &more, &longer);
  if (random_below(r, 2))
    as_balls(s, s);
  if (random_below(r, 2))
    series_truncate(s, 1 + random_below(r, LENGTH));
  series_shift(s, s, first);
}

/* Every known ball is thin: the identities say something. */
static void check_thin(const struct series *s)
{
  SCOPED(arb, c);
  for (slong k = s->first; k < least(s->known, FAR); k++) {
    series_coefficient(c, s, k, PRECISION);
    assert_true(arb_is_finite(c) && mag_cmp_2exp_si(arb_radref(c), -PRECISION / 2) < 0);
  }
}

static void check_is(const struct series *got, const struct series *wanted, const char *what)
{
  check_same(got, wanted, what);
  check_known(got, least(wanted->known, wanted->first + LENGTH), what);
  check_thin(got);
}

TEST(exp_and_log_undo_each_other)
{
  struct random r = { 20260901 };
  SCOPED(work, w);
  for (int i = 0; i < 200; i++) {
    positive_series(&w[0], &r, 0, random_below(&r, 2));
    take(series_log, &w[1], &w[0], &ring);
    take(series_exp, &w[1], &w[1], &ring);
    check_is(&w[1], &w[0], "exp(log(a))");
    take(series_exp, &w[2], &w[0], &ring);
    take(series_log, &w[2], &w[2], &ring);
    check_is(&w[2], &w[0], "log(exp(a))");
  }
}

TEST(sin_and_cos)
{
  struct random r = { 20260902 };
  SCOPED(work, w);
  for (int i = 0; i < 200; i++) {
    positive_series(&w[0], &r, random_below(&r, 8), 0);
    take(series_sin, &w[1], &w[0], &ring);
    take(series_cos, &w[2], &w[0], &ring);
    series_mul(&w[3], &w[1], &w[1], &ring);
    series_mul(&w[4], &w[2], &w[2], &ring);
    series_add(&w[3], &w[3], &w[4], &ring);
    series_set_si(&w[4], 1);
    check_same(&w[3], &w[4], "sin^2 + cos^2");
    check_known(&w[3], least(w[0].known, LENGTH), "sin^2 + cos^2");
    check_thin(&w[3]);
  }
}

TEST(roots_and_powers)
{
  struct random r = { 20260903 };
  SCOPED(work, w);
  for (int i = 0; i < 200; i++) {
    slong q = 1 + random_below(&r, 5), p = 1 + random_below(&r, 5);
    positive_series(&w[0], &r, q * (random_below(&r, 7) - 3), i % 2);
    raise_to(&w[1], &w[0], 1, q, &ring);
    if (w[0].kind == SERIES_FRACTIONS && i % 2)
      assert_true(w[1].kind == SERIES_FRACTIONS);
    raise_to(&w[2], &w[1], q, 1, &ring);
    check_is(&w[2], &w[0], "a^(1/q)^q");
    raise_to(&w[2], &w[1], p, 1, &ring);
    raise_to(&w[3], &w[0], p, q, &ring);
    check_is(&w[3], &w[2], "a^(p/q)");
    raise_to(&w[3], &w[0], -p, q, &ring);
    series_mul(&w[3], &w[3], &w[2], &ring);
    series_set_si(&w[4], 1);
    check_same(&w[3], &w[4], "a^(-p/q) a^(p/q)");
    positive_series(&w[0], &r, 2 * (random_below(&r, 7) - 3), 0);
    take(series_sqrt, &w[1], &w[0], &ring);
    series_mul(&w[1], &w[1], &w[1], &ring);
    check_is(&w[1], &w[0], "sqrt(a)^2");
  }
}

/* By products and, where |n| > 64, by the other route; a negative base, too */
TEST(large_whole_powers)
{
  struct random r = { 20260904 };
  SCOPED(work, w);
  for (int i = 0; i < 40; i++) {
    positive_series(&w[0], &r, random_below(&r, 5) - 2, 0);
    if (i % 2)
      series_neg(&w[0], &w[0]);
    raise_to(&w[1], &w[0], 64, 1, &ring);
    raise_to(&w[2], &w[0], 7, 1, &ring);
    series_mul(&w[1], &w[1], &w[2], &ring);
    raise_to(&w[3], &w[0], 71, 1, &ring);
    check_same(&w[3], &w[1], "a^71");
    check_known(&w[3], w[1].known, "a^71");
    raise_to(&w[4], &w[0], -71, 1, &ring);
    series_mul(&w[4], &w[4], &w[3], &ring);
    series_set_si(&w[5], 1);
    check_same(&w[4], &w[5], "a^-71 a^71");
  }
}

/* Nothing but O(x^4), or O(1) */
TEST(of_what_is_not_known)
{
  SCOPED(work, w);
  series_truncate(&w[5], 4);
  take(series_sin, &w[6], &w[5], &ring);
  take(series_cos, &w[7], &w[5], &ring);
  assert_true(w[6].known == 4 && w[7].known == 4);
  assert_string_equal(series_sqrt(&w[0], &w[5], &ring), "of what may be 0");
  series_shift(&w[5], &w[5], -4);
  assert_string_equal(series_exp(&w[0], &w[5], &ring), "of what is not known at T = 0");
}

/* Coefficient k times x^(step k) is the one before times (a + b k)/(c + d k): hypergeometric, from `first` on. */
struct closed_form {
  const char *name;
  series_function *f;
  slong constant, first, step; /* of constant + x, from the term x^first, which is 1, on */
  slong a[2][2], c[2][2];      /* (a0 + a1 k)(b0 + b1 k) over the same of c, for k = 1, 2, ... */
};

TEST(closed_forms)
{
  static const struct closed_form forms[] = {
    { "exp", series_exp, 0, 0, 1, { { 1, 0 }, { 1, 0 } }, { { 0, 1 }, { 1, 0 } } },
    { "log", series_log, 1, 1, 1, { { 0, -1 }, { 1, 0 } }, { { 1, 1 }, { 1, 0 } } },
    { "sin", series_sin, 0, 1, 2, { { -1, 0 }, { 1, 0 } }, { { 0, 2 }, { 1, 2 } } },
    { "cos", series_cos, 0, 0, 2, { { -1, 0 }, { 1, 0 } }, { { -1, 2 }, { 0, 2 } } },
    { "sqrt", series_sqrt, 1, 0, 1, { { 3, -2 }, { 1, 0 } }, { { 0, 2 }, { 1, 0 } } },
  };
  SCOPED(work, w);
  SCOPED(fmpq, wanted, got);
  for (size_t i = 0; i < sizeof forms / sizeof *forms; i++) {
    const struct closed_form *f = &forms[i];
    series_set_x(&w[0]);
    series_set_si(&w[1], f->constant);
    series_add(&w[0], &w[0], &w[1], &ring);
    take(f->f, &w[1], &w[0], &ring);
    assert_true(w[1].kind == SERIES_FRACTIONS && w[1].known == LENGTH + (f->step == 2 ? f->first : 0));
    fmpq_one(wanted);
    for (slong power = 0, k = 1; power < w[1].known; power++) {
      bool there = power >= f->first && (power - f->first) % f->step == 0;
      assert_true(series_rational_coefficient(got, &w[1], power));
      if (there ? !fmpq_equal(got, wanted) : !fmpq_is_zero(got))
        fail_msg("%s: the coefficient of x^%ld", f->name, (long)power);
      if (!there)
        continue;
      for (int j = 0; j < 2; j++) {
        fmpq_mul_si(wanted, wanted, f->a[j][0] + f->a[j][1] * k);
        fmpz_mul_si(fmpq_denref(wanted), fmpq_denref(wanted), f->c[j][0] + f->c[j][1] * k);
        fmpq_canonicalise(wanted);
      }
      k++;
    }
  }
}

/* An even or odd function of c x^first: exact with as many terms as there are, wherever it begins */
TEST(far_from_the_constant_term)
{
  SCOPED(work, w);
  SCOPED(fmpq, c);
  for (slong first = 1; first < 3 * LENGTH; first++) {
    series_set_x(&w[0]);
    raise_to(&w[0], &w[0], first, 1, &ring);
    take(series_sin, &w[1], &w[0], &ring);
    take(series_exp, &w[3], &w[0], &ring);
    assert_true(w[1].kind == SERIES_FRACTIONS && w[1].known == first + LENGTH && w[3].known == LENGTH);
    assert_true(series_rational_coefficient(c, &w[1], first) && fmpq_is_one(c));
    if (3 * first < w[1].known) {
      series_rational_coefficient(c, &w[1], 3 * first);
      fmpq_mul_si(c, c, -6);
      assert_true(fmpq_is_one(c));
    }
  }
}

/* One random function of a, the same in both rings */
static const char *random_function(struct series *to, const struct series *a, int which, const struct ring *in)
{
  static series_function *const functions[] = { series_exp, series_log, series_sin, series_cos, series_sqrt };
  enum { FUNCTIONS = sizeof functions / sizeof *functions };
  if (which < FUNCTIONS)
    return functions[which](to, a, in);
  SCOPED(series, power);
  SCOPED(fmpq, value);
  static const slong powers[][2] = { { 1, 3 }, { -3, 2 }, { 65, 1 }, { 7, 1 } };
  fmpq_set_si(value, powers[which - FUNCTIONS][0], (ulong)powers[which - FUNCTIONS][1]);
  series_set_rational(&power, value);
  return series_power(to, a, &power, in);
}
enum { RANDOM_FUNCTIONS = 9 };

/* Whatever is known of the function of a series that is cut, with n terms, is the same with 3 n terms and nothing cut
 * off: what is cut off is not 0. */
TEST(what_is_known_is_right)
{
  struct random r = { 20260906 };
  int taken[RANDOM_FUNCTIONS] = { 0 };
  SCOPED(work, w);
  for (int i = 0; i < 1200; i++) {
    int which = i % RANDOM_FUNCTIONS;
    random_terms(&w[0], &r, random_below(&r, 13) / 3 - 2, LENGTH);
    if (random_below(&r, 2))
      positive_series(&w[0], &r, 0, random_below(&r, 2));
    series_set(&w[1], &w[0]);
    series_truncate(&w[1], w[1].first + 1 + random_below(&r, LENGTH));
    if (random_function(&w[2], &w[1], which, &ring) || random_function(&w[3], &w[0], which, &longer))
      continue;
    taken[which]++;
    check_known(&w[3], w[2].known, "with three times the terms");
    check_same(&w[2], &w[3], "n and 3 n terms");
  }
  for (int i = 0; i < RANDOM_FUNCTIONS; i++)
    if (taken[i] < 5)
      fail_msg("function %d is taken %d times", i, taken[i]);
}

/* The ball of each coefficient holds the fraction. */
TEST(balls_hold_the_fractions)
{
  struct random r = { 20260907 };
  SCOPED(work, w);
  SCOPED(fmpq, exact);
  SCOPED(arb, ball);
  int compared = 0;
  for (int i = 0; i < 600; i++) {
    random_terms(&w[0], &r, random_below(&r, 3), 1 + random_below(&r, LENGTH));
    if (i % 4 == 0) {
      series_set_si(&w[1], 1);
      series_add(&w[0], &w[1], &w[0], &ring);
    }
    as_balls(&w[1], &w[0]);
    if (random_function(&w[2], &w[0], i % RANDOM_FUNCTIONS, &ring))
      continue;
    assert_null(random_function(&w[3], &w[1], i % RANDOM_FUNCTIONS, &ring));
    for (slong k = -FAR; k < least(least(w[2].known, w[3].known), FAR) && w[2].kind == SERIES_FRACTIONS;
         k++, compared++) {
      series_rational_coefficient(exact, &w[2], k);
      series_coefficient(ball, &w[3], k, PRECISION);
      assert_true(arb_contains_fmpq(ball, exact));
    }
  }
  assert_true(compared > 1000);
}
