/* Truncated Laurent series: identities, also of functions, closed forms, what a series claims to know, and operations
 * term by term, against sums that are written out here. */
#include "tests/support/cases.h"

#include "asymptotics/derived/formula_flint.h"
#include "tests/support/random_series.h"

typedef const char *series_function(struct series *to, const struct series *a, const struct ring *ring);

static void take(series_function *f, struct series *to, const struct series *a, const struct ring *in)
{
  const char *wrong = f(to, a, in);
  if (wrong)
    fail_msg("refused: %s", wrong);
}

static const char *raise_to(struct series *to, const struct series *a, slong p, slong q, const struct ring *in)
{
  SCOPED(series, power);
  SCOPED(fmpq, value);
  fmpq_set_si(value, p, (ulong)q);
  series_set_rational(&power, value);
  return series_power(to, a, &power, in);
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

static int place_of(void *context, const char *name) { return (void)context, *name - 'a'; }

static void evaluate(struct series *value, const char *text, const struct series of[3])
{
  const struct formula_names names = { .place = place_of };
  struct formula formula;
  char message[FORMULA_MESSAGE];
  if (formula_read(&formula, text, &names, message) || formula_series(value, &formula, of, NULL, &ring, message))
    fail_msg("%s: %s", text, message);
}

/* Both sides are the same for series a, b and c, and where `known` is set the left one knows as many terms as there are
 * of the right one. Those are: any; positive at x^0, from 1 in every other case; positive from x^0 to x^7 on; positive
 * from a power on that has roots; the same, of either sign. */
enum drawn { ANY, AT_0, FROM_0, ROOTS, SIGNED };
static const struct identity {
  const char *text;
  enum drawn drawn;
  bool known;
} identities[] = {
  { "a + b = b + a", ANY, false },
  { "(a + b) + c = a + (b + c)", ANY, false },
  { "a*b = b*a", ANY, false },
  { "(a*b)*c = a*(b*c)", ANY, false },
  { "a*(b + c) = a*b + a*c", ANY, false },
  { "a - b = a + (-b)", ANY, false },
  { "(a - a) + b = b", ANY, false },
  { "exp(log(a)) = a", AT_0, true },
  { "log(exp(a)) = a", AT_0, true },
  { "sin(a)^2 + cos(a)^2 = 1", FROM_0, false },
  { "sqrt(a)^2 = a", ROOTS, true },
  { "(a^(1/3))^3 = a", ROOTS, true },
  { "a^(5/6) = (a^(1/6))^5", ROOTS, true },
  { "a^(2/3) = (a^(1/3))^2", ROOTS, true },
  { "a^(-3/2)*a^(3/2) = 1", ROOTS, false },
  { "a^71 = a^64*a^7", SIGNED, true }, /* by products and, beyond the 64th power, by the other route */
  { "a^-71*a^71 = 1", SIGNED, false },
};

static void draw(struct series *s, struct random *r, enum drawn drawn)
{
  if (drawn == ANY) {
    random_series(s, r, random_below(r, 9) - 4);
    if (random_below(r, 2))
      as_balls(s, s);
    return;
  }
  positive_series(s, r,
                  drawn == AT_0     ? 0
                  : drawn == FROM_0 ? random_below(r, 8)
                                    : 6 * (random_below(r, 3) - 1),
                  drawn == AT_0 || drawn == ROOTS ? random_below(r, 2) : 0);
  if (drawn == SIGNED && random_below(r, 2))
    series_neg(s, s);
}

TEST(identities_hold)
{
  struct random r = { 20260801 };
  SCOPED(work, w);
  for (size_t i = 0; i < sizeof identities / sizeof *identities; i++)
    for (int n = 0; n < 200; n++) {
      const struct identity *of = &identities[i];
      char text[LONGEST_CASE];
      snprintf(text, sizeof text, "%s", of->text);
      for (int k = 0; k < 3; k++)
        draw(&w[k], &r, of->drawn);
      const char *right = wanted_of(text);
      evaluate(&w[3], text, w);
      evaluate(&w[4], right, w);
      check_same(&w[3], &w[4], of->text);
      if (of->known)
        check_known(&w[3], least(w[4].known, w[4].first + LENGTH), of->text);
      if (of->drawn == FROM_0)
        check_known(&w[3], least(w[0].known, LENGTH), of->text);
      if (of->drawn != ANY && of->drawn != SIGNED)
        check_thin(&w[3]);
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

/* One step of a random calculation, the same in both rings; a function may refuse. */
enum { ARITHMETIC = 6, FUNCTIONS = 9, STEPS = ARITHMETIC + FUNCTIONS };
static const char *random_step(struct series *to, const struct series *a, const struct series *b, int step,
                               const struct ring *in)
{
  static series_function *const functions[] = { series_exp, series_log, series_sin, series_cos, series_sqrt };
  static const slong powers[][2] = { { 1, 3 }, { -3, 2 }, { 65, 1 }, { 7, 1 } };
  SCOPED(fmpq, half);
  if (step >= ARITHMETIC + 5)
    return raise_to(to, a, powers[step - ARITHMETIC - 5][0], powers[step - ARITHMETIC - 5][1], in);
  switch (step) {
  case 0: series_add(to, a, b, in); break;
  case 1: series_sub(to, a, b, in); break;
  case 2: series_mul(to, a, b, in); break;
  case 3: series_div(to, a, b, in); break;
  case 4: series_shift(to, a, 1); break;
  case 5:
    fmpq_set_si(half, -1, 2);
    series_scale(to, a, half, in);
    break;
  default: return functions[step - ARITHMETIC](to, a, in);
  }
  return NULL;
}

static void check_few_and_many(const struct series *few, const struct series *many)
{
  check_known(many, least(few->known, FAR / 4), "with three times the terms");
  check_same(few, many, "n and 3 n terms");
}

/* Six numbers, each replaced again and again by a result of two others: whatever is known with n terms is the same with
 * 3 n terms and nothing cut off. Known is never more than the longer calculation knows. */
static void check_calculation(struct random *r, bool balls)
{
  enum { NUMBERS = 6 };
  SCOPED(work, few, many);
  for (int i = 0; i < NUMBERS; i++) {
    random_terms(&many[i], r, random_below(r, 5) - 2, 1 + random_below(r, LENGTH));
    if (balls && i % 2)
      as_balls(&many[i], &many[i]);
    series_set(&few[i], &many[i]);
    if (random_below(r, 3) == 0)
      series_truncate(&few[i], few[i].first + 1 + random_below(r, LENGTH));
  }
  for (int i = 0; i < 12; i++) {
    int to = random_below(r, NUMBERS), a = random_below(r, NUMBERS), b = random_below(r, NUMBERS),
        step = random_below(r, ARITHMETIC);
    if (step == 3 && (series_coefficient_is_zero(&few[b], few[b].first) || few[b].known <= few[b].first))
      step = 2;
    random_step(&few[to], &few[a], &few[b], step, &ring);
    random_step(&many[to], &many[a], &many[b], step, &longer);
    check_few_and_many(&few[to], &many[to]);
  }
}

/* The same of functions: what is cut off is not 0. */
TEST(what_is_known_is_right)
{
  struct random r = { 20260808 };
  int taken[STEPS] = { 0 };
  SCOPED(work, w);
  for (int i = 0; i < 400; i++)
    check_calculation(&r, i % 2);
  for (int i = 0; i < 1200; i++) {
    int step = ARITHMETIC + i % FUNCTIONS;
    random_terms(&w[0], &r, random_below(&r, 13) / 3 - 2, LENGTH);
    if (random_below(&r, 2))
      positive_series(&w[0], &r, 0, random_below(&r, 2));
    series_set(&w[1], &w[0]);
    series_truncate(&w[1], w[1].first + 1 + random_below(&r, LENGTH));
    if (random_step(&w[2], &w[1], NULL, step, &ring) || random_step(&w[3], &w[0], NULL, step, &longer))
      continue;
    taken[step]++;
    check_known(&w[3], w[2].known, "with three times the terms");
    check_few_and_many(&w[2], &w[3]);
  }
  for (int i = ARITHMETIC; i < STEPS; i++)
    if (taken[i] < 5)
      fail_msg("function %d is taken %d times", i, taken[i]);
}

/* The ball of each coefficient holds the fraction, or the function of pi, and is thin. Returns how many. */
static int check_enclosed(const struct series *exact, const struct series *balls, bool thin)
{
  SCOPED(arb, wanted, ball);
  SCOPED(fmpq, fraction);
  int compared = 0;
  for (slong k = -FAR; k < least(least(exact->known, balls->known), FAR); k++, compared++) {
    series_coefficient(wanted, exact, k, 2 * PRECISION);
    series_coefficient(ball, balls, k, PRECISION);
    bool is_fraction = series_rational_coefficient(fraction, exact, k);
    assert_true(is_fraction ? arb_contains_fmpq(ball, fraction) : arb_contains(ball, wanted));
    assert_true(!thin || mag_cmp_2exp_si(arb_radref(ball), -PRECISION / 2) < 0);
  }
  return compared;
}

TEST(balls_hold_what_is_exact)
{
  struct random r = { 20260809 };
  SCOPED(work, w);
  int compared = 0;
  for (int i = 0; i < 1200; i++) {
    bool function = i % 2;
    int step = function ? ARITHMETIC + i / 2 % FUNCTIONS : random_below(&r, ARITHMETIC),
        in_pi = i % 4 == 0 ? 1 + random_below(&r, 3) : 0; /* of which of the two, as bits */
    for (int k = 0; k < 2; k++) {
      if (function)
        random_terms(&w[k], &r, random_below(&r, 3), 1 + random_below(&r, LENGTH));
      else
        random_series(&w[k], &r, random_below(&r, 9) - 4);
      if (in_pi >> k & 1)
        bring_in_pi(&w[k], &r);
      if (i % 8 == 1) {
        series_set_si(&w[6], 1);
        series_add(&w[k], &w[6], &w[k], &ring);
      }
      as_balls(&w[2 + k], &w[k]);
    }
    if (random_step(&w[4], &w[0], &w[1], step, &ring))
      continue;
    assert_null(random_step(&w[5], &w[2], &w[3], step, &ring));
    assert_true(function || (w[4].kind != SERIES_BALLS && w[5].kind == SERIES_BALLS));
    if (w[4].kind != SERIES_BALLS)
      compared += function * check_enclosed(&w[4], &w[5], !function);
  }
  assert_true(compared > 1000);
}

/* What takes one series, and of more bits than functions of pi may have */
TEST(functions_of_pi_one_by_one)
{
  struct random r = { 20261124 };
  SCOPED(work, w);
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
    check_enclosed(&w[0], &w[1], false);
  }
  SCOPED(series, pi, large);
  series_set_pi(&pi, NULL);
  series_set_si(&large, 3);
  series_add(&large, &large, &pi, &ring);
  for (int i = 0; i < 14 && large.kind == SERIES_NAMED; i++)
    series_mul(&large, &large, &large, &ring);
  assert_int_equal(large.kind, SERIES_BALLS);
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
    assert_null(raise_to(&w[0], &w[0], first, 1, &ring));
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
