/* Truncated Laurent series: identities, also of functions, values of finite sums, what a series claims to know, what is
 * read from text: formulas as series and in balls, numbers into fractions. */
#include "tests/support/cases.h"

#include <stdio.h>

#include "asymptotics/derived/formula_flint.h"
#include "tests/support/exact.h"

enum { PRECISION = 200, LENGTH = 9, FAR = 60 }; /* FAR: beyond every power that is looked at */

static const struct ring ring = { LENGTH, PRECISION }, longer = { 3 * LENGTH, PRECISION };

static slong least(slong a, slong b) { return a < b ? a : b; }

/* Series to work with: SCOPED(work, w). Formulas call the first of them a, b and c; x is the variable. */
enum { WORK = 8, LETTERS = 4 };
typedef struct series scoped_work[WORK];
static void scoped_begin_work(scoped_work *w)
{
  for (int i = 0; i < WORK; i++)
    series_init(&(*w)[i]);
}
static void scoped_end_work(scoped_work *w)
{
  for (int i = 0; i < WORK; i++)
    series_clear(&(*w)[i]);
}

static int place_of(void *context, const char *name)
{
  static const char letters[] = "xabc";
  const char *found = strchr(letters, *name);
  return (void)context, found && !name[1] ? (int)(found - letters) : -1;
}
static const struct formula_names names = { .place = place_of };

/* NULL, or what is wrong with it */
static const char *try_formula(struct series *value, const char *text, const struct series *abc)
{
  static char message[FORMULA_MESSAGE];
  struct formula formula;
  SCOPED(series, x);
  series_set_x(&x);
  const struct series values[LETTERS] = { x, abc[0], abc[1], abc[2] };
  const char *wrong = formula_read(&formula, text, &names, message);
  return wrong ? wrong : formula_series(value, &formula, values, NULL, &ring, message);
}

static void evaluate(struct series *value, const char *text, const struct series *abc)
{
  const char *wrong = try_formula(value, text, abc);
  if (wrong)
    fail_msg("%s: %s", text, wrong);
}

/* Random terms from x^first on, the first of which is not 0; an even series now and then, for the zeros in between. */
static void random_terms(struct series *s, struct random *r, slong first, slong terms)
{
  SCOPED(fmpq_poly, poly);
  SCOPED(fmpq, c);
  slong step = 1 + random_below(r, 4) / 3;
  for (slong k = 0; k < terms; k += step) {
    random_fraction(c, r);
    if (k == 0 && fmpq_is_zero(c))
      fmpq_one(c);
    fmpq_poly_set_coeff_fmpq(poly, k, c);
  }
  series_set_rational_poly(s, poly, SERIES_ALL);
  series_shift(s, s, first);
}

/* Of which everything is known, or only the first few terms */
static void random_series(struct series *s, struct random *r, slong first)
{
  random_terms(s, r, first, 1 + random_below(r, LENGTH));
  if (random_below(r, 2))
    series_truncate(s, first + 1 + random_below(r, LENGTH));
}

/* Each coefficient times a power of pi, one way or another */
static void bring_in_pi(struct series *s, struct random *r)
{
  SCOPED(series, pi);
  const slong first = s->first, known = s->known;
  series_set_pi_poly(s, s->rational, random_below(r, 3), random_below(r, 3), SERIES_ALL);
  s->first = first;
  s->known = known;
  series_set_pi(&pi, NULL);
  if (random_below(r, 2))
    series_div(s, s, &pi, &longer);
  else
    series_add(s, s, &pi, &longer);
}

/* The same numbers as balls */
static void as_balls(struct series *to, const struct series *from)
{
  SCOPED(arb_poly, poly);
  SCOPED(arb, c);
  for (slong k = 0; k < series_terms(from); k++) {
    series_coefficient(c, from, from->first + k, PRECISION);
    arb_poly_set_coeff_arb(poly, k, c);
  }
  series_set_ball_poly(to, poly, SERIES_ALL);
  series_shift(to, to, from->first);
  series_truncate(to, from->known);
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

/* All coefficients that both know are the same. The lowest power of interest: -FAR. */
static void check_same(const struct series *a, const struct series *b, const char *what)
{
  slong known = least(least(a->known, b->known), FAR);
  for (slong k = -FAR; k < known; k++)
    if (!same_coefficient(a, b, k, PRECISION))
      fail_msg("%s: the coefficients of x^%ld differ", what, (long)k);
}

/* ... and s knows at least so many */
static void check_known(const struct series *s, slong known, const char *what)
{
  if (s->known < known)
    fail_msg("%s: known below x^%ld, not x^%ld", what, (long)s->known, (long)known);
}

static bool is_thin(const arb_t x) { return arb_is_finite(x) && mag_cmp_2exp_si(arb_radref(x), -PRECISION / 2) < 0; }

/* Both sides are the same for series a, b and c; in those that are made of `of` of them, by products, quotients and
 * powers, the left side knows as many terms as the one that knows the fewest. Where b_is_slope, b is the derivative of
 * a, and the left side that of the function. Drawn are: any; positive at x^0, from 1 in every other case; positive from
 * x^0 to x^7 on; positive from a power on that has roots; the same, of either sign. */
enum drawn { ANY, AT_0, FROM_0, ROOTS, SIGNED };
static const struct identities {
  enum drawn drawn;
  int of;
  bool b_is_slope;
  const char *texts;
} identities[] = {
  { ANY, 0, false, "a + b = b + a|(a + b) + c = a + (b + c)|a*(b + c) = a*b + a*c|a - b = a + (-b)|(a - a) + b = b" },
  { ANY, 2, false, "a*b = b*a|(a/b)*b = a|a/b = a*(1/b)" },
  { ANY, 3, false, "(a*b)*c = a*(b*c)" },
  { AT_0, 1, false, "exp(log(a)) = a|log(exp(a)) = a" },
  { FROM_0, 0, false, "sin(a)^2 + cos(a)^2 = 1" },
  { ROOTS, 1, false, "sqrt(a)^2 = a|(a^(1/3))^3 = a|a^(5/6) = (a^(1/6))^5|a^(2/3) = (a^(1/3))^2|a^(-3/2)*a^(3/2) = 1" },
  /* by products and, beyond the 64th power, by the other route */
  { SIGNED, 1, false, "a^71 = a^64*a^7|a^-71*a^71 = 1" },
  { FROM_0, 0, true, "exp(a) = b*exp(a)|sin(a) = b*cos(a)|cos(a) = -b*sin(a)|a^2 = 2*a*b" },
  { AT_0, 0, true, "log(a) = b/a|a^(-2/3) = -2/3*b*a^(-5/3)" },
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

static void check_identity(const struct identities *i, const char *left, const char *right, struct random *r)
{
  SCOPED(work, w);
  SCOPED(arb, c);
  slong known = LENGTH;
  for (int k = 0; k < 3; k++) {
    draw(&w[k], r, i->drawn);
    if (k < i->of)
      known = least(known, w[k].known - w[k].first);
  }
  if (i->b_is_slope)
    series_derivative(&w[1], &w[0], &longer);
  evaluate(&w[3], left, w);
  evaluate(&w[4], right, w);
  if (i->b_is_slope)
    series_derivative(&w[3], &w[3], &ring);
  check_same(&w[3], &w[4], left);
  if (i->of)
    check_known(&w[3], w[4].first + known, left);
  if (i->drawn == FROM_0)
    check_known(&w[3], least(w[0].known, LENGTH) - i->b_is_slope, left);
  for (slong k = w[3].first; i->drawn != ANY && i->drawn != SIGNED && k < least(w[3].known, FAR); k++) {
    series_coefficient(c, &w[3], k, PRECISION); /* thin: the identity says something */
    assert_true(is_thin(c));
  }
}

TEST(identities_hold)
{
  struct random r = { 20260801 };
  for (size_t i = 0; i < sizeof identities / sizeof *identities; i++)
    FOR_CASES (text, identities[i].texts) {
      const char *right = wanted_of(text);
      for (int n = 0; n < 200; n++)
        check_identity(&identities[i], text, right, &r);
    }
}

/* A divisor whose first coefficients are exactly 0 begins later: 4 x^2, with two zeros in front. Refused, with the
 * quotient as it was: 0, 0 with an error term, a ball that holds 0, also before other terms. */
TEST(division_by_what_is_or_may_be_zero_at_first)
{
  struct random r = { 20260803 };
  SCOPED(work, w);
  SCOPED(arb, ball);
  SCOPED(arb_poly, poly);
  arb_poly_set_coeff_si(poly, 2, 4);
  series_set_ball_poly(&w[0], poly, SERIES_ALL);
  evaluate(&w[1], "1", w);
  evaluate(&w[2], "4*x^2/a", w);
  check_same(&w[2], &w[1], "4 x^2/(4 x^2)");
  check_known(&w[2], LENGTH, "4 x^2/(4 x^2)");
  random_terms(&w[0], &r, -2, 5);
  series_set(&w[1], &w[0]);
  series_set_si(&w[2], 0);
  series_truncate(&w[3], 1);
  arb_set_si(ball, 1);
  mag_set_d(arb_radref(ball), 1.5);
  series_set_ball(&w[4], ball);
  series_set_x(&w[5]);
  series_add(&w[5], &w[5], &w[4], &ring);
  for (int k = 2; k <= 5; k++)
    for (int in_place = 0; in_place < 2; in_place++)
      assert_false(series_div(&w[0], &w[in_place ? 0 : 1], &w[k], &ring));
  assert_true(w[0].kind == SERIES_FRACTIONS && w[0].first == -2 && w[0].known == SERIES_ALL);
  check_same(&w[0], &w[1], "unchanged");
}

/* One step of a random calculation, the same in both rings; what is not whole at x = 0 may be refused. */
enum { ARITHMETIC = 8, FUNCTIONS = 13, STEPS = ARITHMETIC + FUNCTIONS };
static const char *function_step(struct series *to, const struct series *a, const struct series *b, int step,
                                 const struct ring *in)
{
  typedef const char *series_function(struct series * to, const struct series *a, const struct ring *ring);
  static series_function *const functions[] = { series_exp, series_log, series_sin, series_cos, series_sqrt };
  static const slong powers[][2] = { { 1, 3 }, { -3, 2 }, { 65, 1 }, { 7, 1 } };
  SCOPED(series, power);
  SCOPED(fmpq, value);
  if (step < 5)
    return functions[step](to, a, in);
  if (step < 9) {
    fmpq_set_si(value, powers[step - 5][0], (ulong)powers[step - 5][1]);
    series_set_rational(&power, value);
    return series_power(to, a, &power, in);
  }
  if (a->first < 0 || (step == 9 && b->first < 1))
    return "not whole";
  switch (step) {
  case 9: series_compose(to, a, b, in); break;
  case 10: series_integral(to, a, in); break;
  case 11: series_derivative(to, a, in); break;
  default: series_inflate(to, a, 2);
  }
  return NULL;
}

static const char *random_step(struct series *to, const struct series *a, const struct series *b, int step,
                               const struct ring *in)
{
  SCOPED(fmpq, half);
  switch (step) {
  case 0: series_add(to, a, b, in); break;
  case 1: series_sub(to, a, b, in); break;
  case 2: series_mul(to, a, b, in); break;
  case 3: return series_div(to, a, b, in) ? NULL : "may be 0";
  case 4: series_shift(to, a, 1); break;
  case 5:
    fmpq_set_si(half, -1, 2);
    series_scale(to, a, half, in);
    break;
  case 6: series_neg(to, a); break;
  case 7:
    series_set(to, a);
    series_set_zero(to, 1);
    break;
  default: return function_step(to, a, b, step - ARITHMETIC, in);
  }
  return NULL;
}

/* In place of either operand the result is the same, and as much is known. */
static void check_in_place(const struct series *wanted, const struct series *a, const struct series *b, int step)
{
  SCOPED(work, w);
  for (int k = 0; k < 2; k++) {
    series_set(&w[0], a);
    series_set(&w[1], b);
    random_step(&w[k], &w[0], &w[1], step, &ring);
    check_same(&w[k], wanted, "in place of an operand");
    assert_int_equal(w[k].known, wanted->known);
  }
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
  SCOPED(series, result);
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
    if (random_step(&result, &few[a], &few[b], step, &ring))
      continue;
    check_in_place(&result, &few[a], &few[b], step);
    series_set(&few[to], &result);
    assert_null(random_step(&many[to], &many[a], &many[b], step, &longer));
    check_few_and_many(&few[to], &many[to]);
  }
}

/* The same of functions: what is cut off is not 0. Those that are whole know as much as their operands do. */
TEST(what_is_known_is_right)
{
  struct random r = { 20260808 };
  int taken[STEPS] = { 0 };
  SCOPED(work, w);
  for (int i = 0; i < 200; i++)
    check_calculation(&r, i % 2);
  for (int i = 0; i < 1300; i++) {
    int step = ARITHMETIC + i % FUNCTIONS;
    random_terms(&w[0], &r, random_below(&r, 13) / 3 - 2, LENGTH);
    if (random_below(&r, 2))
      positive_series(&w[0], &r, 0, random_below(&r, 2));
    random_terms(&w[4], &r, 1 + random_below(&r, 3), LENGTH);
    series_set(&w[1], &w[0]);
    series_set(&w[5], &w[4]);
    series_truncate(&w[1], w[1].first + 1 + random_below(&r, LENGTH));
    if (random_below(&r, 2))
      series_truncate(&w[5], w[5].first + 1 + random_below(&r, LENGTH));
    if (random_step(&w[2], &w[1], &w[5], step, &ring) || random_step(&w[3], &w[0], &w[4], step, &longer))
      continue;
    taken[step]++;
    check_few_and_many(&w[2], &w[3]);
    check_in_place(&w[2], &w[1], &w[5], step);
    slong whole = least(w[1].known, LENGTH), more = step - ARITHMETIC - 9;
    if (more >= 0)
      check_known(&w[2],
                  more == 0   ? least(whole, w[5].known)
                  : more == 3 ? 2 * whole
                              : whole + (more == 1) - (more == 2),
                  "whole");
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
    assert_true(!thin || is_thin(ball));
  }
  return compared;
}

TEST(balls_hold_what_is_exact)
{
  struct random r = { 20260809 };
  SCOPED(work, w);
  int compared = 0, in_names = 0;
  for (int i = 0; i < 1600; i++) {
    bool function = i % 2;
    int step = function ? ARITHMETIC + i / 2 % FUNCTIONS : random_below(&r, ARITHMETIC),
        in_pi = i % 4 == 0 || (step >= ARITHMETIC + 9 && i % 3) ? 1 + random_below(&r, 3) : 0; /* of which, as bits */
    for (int k = 0; k < 2; k++) {
      if (function)
        random_terms(&w[k], &r, k + random_below(&r, 3), 1 + random_below(&r, LENGTH));
      else
        random_series(&w[k], &r, random_below(&r, 9) - 4);
      if (in_pi >> k & 1)
        bring_in_pi(&w[k], &r);
      if (i % 8 == 1 && k == 0) {
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
      compared += check_enclosed(&w[4], &w[5], !function);
    in_names += function && w[4].kind == SERIES_NAMED;
  }
  assert_true(compared > 1000 && in_names > 20);
}

/* Functions of pi of more bits than they may have become balls. */
TEST(large_functions_of_pi)
{
  SCOPED(work, w);
  evaluate(&w[0], "3 + pi", w);
  for (int i = 0; i < 14 && w[0].kind == SERIES_NAMED; i++)
    series_mul(&w[0], &w[0], &w[0], &ring);
  assert_int_equal(w[0].kind, SERIES_BALLS);
}

/* Nothing but O(x^4), or O(1) */
TEST(of_what_is_not_known)
{
  SCOPED(work, w);
  series_truncate(&w[0], 4);
  evaluate(&w[6], "sin(a)", w);
  evaluate(&w[7], "cos(a)", w);
  assert_true(w[6].known == 4 && w[7].known == 4);
  assert_string_equal(try_formula(&w[1], "sqrt(a)", w), "character 1: sqrt of what may be 0");
  series_shift(&w[0], &w[0], -4);
  assert_string_equal(try_formula(&w[1], "exp(a)", w), "character 1: exp of what is not known at T = 0");
}

/* An odd function of x^first is exact with as many terms as there are, wherever it begins. */
TEST(far_from_the_constant_term)
{
  SCOPED(work, w);
  for (slong first = 1; first < 3 * LENGTH; first++) {
    series_set_x(&w[0]);
    series_shift(&w[0], &w[0], first - 1);
    evaluate(&w[3], "sin(a)", w);
    evaluate(&w[4], "exp(a)", w);
    evaluate(&w[5], "a - a^3/6", w);
    assert_true(w[3].kind == SERIES_FRACTIONS && w[3].known == first + LENGTH && w[4].known == LENGTH);
    series_truncate(&w[3], 5 * first);
    check_same(&w[3], &w[5], "sin(x^first)");
  }
}

/* The terms below x^before, by powers of an exact x */
static void sum_of_terms(fmpq_t sum, const struct series *s, const fmpq_t x, slong before)
{
  SCOPED(fmpq, c, power);
  fmpq_zero(sum);
  for (slong k = s->first; k < least(before, s->first + series_terms(s)); k++) {
    assert_true(series_rational_coefficient(c, s, k));
    fmpq_pow_si(power, x, k);
    fmpq_addmul(sum, c, power);
  }
}

static void check_sum(const struct series *s, const fmpq_t x, const fmpq_t wanted, const char *what)
{
  SCOPED(fmpq, sum);
  sum_of_terms(sum, s, x, s->known);
  if (!fmpq_equal(sum, wanted))
    fail_msg("%s has another value", what);
}

/* Finite sums have values at a fraction x, which tell what the operations are. */
static void check_values(const struct series *a, const struct series *b, const fmpq_t x, struct random *r)
{
  static const struct ring all = { 200, PRECISION };
  SCOPED(series, s);
  SCOPED(fmpq, p, q, other, wanted);
  slong power = random_below(r, 9) - 4, inflated = 1 + random_below(r, 3), zero = random_below(r, 20) - 10;
  sum_of_terms(p, a, x, FAR);
  sum_of_terms(q, b, x, FAR);
  fmpq_add(wanted, p, q);
  series_add(&s, a, b, &all);
  check_sum(&s, x, wanted, "a + b");
  fmpq_mul(wanted, p, q);
  series_mul(&s, a, b, &all);
  check_sum(&s, x, wanted, "a b");
  fmpq_pow_si(other, x, power);
  fmpq_mul(wanted, p, other);
  series_shift(&s, a, power);
  check_sum(&s, x, wanted, "a x^power");
  fmpq_pow_si(other, x, inflated);
  sum_of_terms(wanted, a, other, FAR);
  series_inflate(&s, a, inflated);
  check_sum(&s, x, wanted, "a(x^power)");
  random_fraction(other, r);
  fmpq_mul(wanted, p, other);
  series_scale(&s, a, other, &all);
  check_sum(&s, x, wanted, "a times a number");
  series_set(&s, a); /* a coefficient that is proven to be 0 becomes 0, and nothing else changes */
  series_set_zero(&s, zero);
  assert_true(series_coefficient_is_zero(&s, zero) && s.known == a->known);
  series_rational_coefficient(other, a, zero);
  fmpq_pow_si(wanted, x, zero);
  fmpq_mul(other, other, wanted);
  fmpq_sub(wanted, p, other);
  check_sum(&s, x, wanted, "a without a term");
  if (a->first >= 0 && b->first > 0) {
    sum_of_terms(wanted, a, q, FAR);
    series_compose(&s, a, b, &all);
    check_sum(&s, x, wanted, "a(b)");
  }
}

/* So do the values in balls, of the terms below any power. */
TEST(values)
{
  struct random r = { 20260810 };
  SCOPED(work, w);
  SCOPED(fmpq, x, sum);
  SCOPED(arb, at, value);
  for (int i = 0; i < 300; i++) {
    random_positive(x, &r);
    arb_set_fmpq(at, x, PRECISION);
    for (int k = 0; k < 2; k++)
      random_terms(&w[k], &r, random_below(&r, 9) - (i % 2 ? 4 : 0), 1 + random_below(&r, LENGTH));
    check_values(&w[0], &w[1], x, &r);
    as_balls(&w[1], &w[0]);
    slong before = w[0].first + random_below(&r, LENGTH + 2);
    sum_of_terms(sum, &w[0], x, before);
    for (int k = 0; k < 2; k++) {
      series_value(value, &w[k], at, before, PRECISION);
      assert_true(arb_contains_fmpq(value, sum) && is_thin(value));
    }
  }
}

/* (a b)' = a' b + a b', and (integral a)' = a; the integral is 0 at 0. */
TEST(integral_and_derivative)
{
  struct random r = { 20260807 };
  SCOPED(work, w);
  series_set_x(&w[0]);
  series_derivative(&w[3], &w[0], &ring);
  evaluate(&w[4], "1", w);
  check_same(&w[3], &w[4], "x'");
  for (int i = 0; i < 200; i++) {
    for (int k = 0; k < 2; k++)
      random_series(&w[k], &r, random_below(&r, 4));
    series_mul(&w[2], &w[0], &w[1], &longer);
    for (int k = 0; k < 3; k++)
      series_derivative(&w[3 + k], &w[k], &longer);
    series_mul(&w[3], &w[3], &w[1], &longer);
    series_mul(&w[4], &w[4], &w[0], &longer);
    series_add(&w[3], &w[3], &w[4], &longer);
    check_same(&w[3], &w[5], "(a b)'");
    series_integral(&w[2], &w[0], &ring);
    assert_true(series_coefficient_is_zero(&w[2], 0));
    series_derivative(&w[3], &w[2], &ring);
    check_same(&w[3], &w[0], "derivative of the integral");
  }
}

/* The numbers that formulas below name: a = 3, b = 1/2, c = 0 */
static void set_numbers(scoped_work *w)
{
  SCOPED(fmpq, half);
  fmpq_set_si(half, 1, 2);
  series_set_si(&(*w)[0], 3);
  series_set_rational(&(*w)[1], half);
  series_set_si(&(*w)[2], 0);
}

/* Each is what stands behind it, and nothing but a number: powers, decimals, which are exact, roots and functions that
 * are fractions. */
TEST(numbers_by_formulas)
{
  static const char cases[] =
      "2^10 = 1024|7^1 = 7|7^0 = 1|c^0 = 1|c^3 = 0|(1 + a)^2 = 16|b^3 = 1/8|2 ^ 3 = 8|2^-1 = 1/2|2^(2) = 4|2^3^2 = 512|"
      "2^(4/2) = 4|b^-3 = 8|(x^2 + 3*x)^2/x^2 - x^2 - 6*x = 9|0.1 = 1/10|1.5 = 3/2|25e-2*4 = 1|.5 + 1e3 = 2001/2|"
      "0e-999999 = 0|sqrt(9/4) = 3/2|8^(1/3) = 2|(8/27)^(-2/a) = 9/4|sqrt(c) = 0|c^b = 0|c^65 = 0|2^1.0 = 2|exp(c) = 1|"
      "log(1) = 0|sin(c) = 0|cos(c) = 1|exp(x - x) = 1|sqrt(x^2) - x = 0|sqrt(x^-4)*x^2 = 1|(8*x^3)^(5/3)/x^5 = 32|"
      "(x^64)^b/x^32 = 1|(x^100 - x^100)^64 = 0|(pi^2 - 1)/(3*pi + 3)/(pi - 1) = 1/3";
  SCOPED(work, w);
  SCOPED(fmpq, wanted, got);
  set_numbers(&w);
  FOR_CASES (text, cases) {
    assert_int_equal(fmpq_set_str(wanted, wanted_of(text), 10), 0);
    evaluate(&w[3], text, w);
    if (!series_rational_coefficient(got, &w[3], 0) || !fmpq_equal(got, wanted)
        || next_nonzero(&w[3], 1, LENGTH) < LENGTH || next_nonzero(&w[3], -LENGTH, 0) < 0)
      fail_msg("%s is something else", text);
  }
}

/* Whether coefficients are fractions, functions of pi or balls, and how much is known: 0 for everything */
TEST(kinds_of_formulas)
{
  static const char *const cases[] = {
    [SERIES_FRACTIONS] = "exp(x) = 9|log(1 + x) = 9|sin(x) = 10|cos(x) = 9|sqrt(1 + x) = 9|sqrt(1 + 2*x + x^2) = 9|"
                         "1/(1 - x)^2 = 9|(1 + x)^3/x = 0",
    [SERIES_NAMED] = "pi = 0|pi*x/3 = 0|1/(pi + x) = 9",
    [SERIES_BALLS] = "2^b = 0|exp(1) = 0|log(2) = 0|sin(1) = 0|2^65 = 0|sqrt(2)*x = 0|exp(pi) = 0|sqrt(pi) = 0|"
                     "sin(pi) = 0|pi^0.5 = 0|4^(1/65) = 0",
  };
  SCOPED(work, w);
  set_numbers(&w);
  for (int kind = SERIES_FRACTIONS; kind <= SERIES_BALLS; kind++)
    FOR_CASES (text, cases[kind]) {
      slong known = strtol(wanted_of(text), NULL, 10);
      evaluate(&w[3], text, w);
      if ((int)w[3].kind != kind || w[3].known != (known ? known : SERIES_ALL))
        fail_msg("%s: kind %d, known below x^%ld", text, (int)w[3].kind, (long)w[3].known);
    }
}

/* 1/(1 - x)^2 and (1 + x)^3/x, by what everybody knows of them, and what is 0 by what is known of pi */
TEST(series_in_the_variable)
{
  static const char cases[] =
      "1/(1 - x)^2 = 1+2*x+3*x^2+4*x^3+5*x^4+6*x^5+7*x^6+8*x^7+9*x^8|(1 + x)^3/x = 1/x+3+3*x+x^2|pi*0 = 0|"
      "pi*x - x*pi = 0|1/pi - 1/(pi + x) - x/(pi*(pi + x)) = 0|(pi + x)^7/(pi + x)^6 - pi - x = 0|"
      "(1/(pi - 22/7) - 1/(pi + x))*(pi - 22/7) = (22/7 + x)/(pi + x)";
  SCOPED(work, w);
  FOR_CASES (text, cases) {
    const char *right = wanted_of(text);
    evaluate(&w[3], text, w);
    evaluate(&w[4], right, w);
    check_same(&w[3], &w[4], text);
  }
}

/* The series at x = 2^-10, and the same in balls, against C's library: what the series leaves off is at most 2^-53 of
 * it, for (1 + x)^70, and each formula multiplies few ulp by less than 4. */
TEST(functions_at_a_small_x)
{
  static const char in_both[] =
      "sqrt(2 + x)|exp(1 - 3*x)|log(2 + x)|sin(1 + x)|cos(b + x)|sin(x)|(2 + x)^2.5|(1 + x)^(1/3)|(a - x)^-0.7|"
      "sqrt(x^2 + x^3)|sqrt(a/x^2 + 1)|(x^3 + x^4)^(2/3)|(x + 1)^70|(-2 - x)^-67|exp(log(2)*sin(x))|sin(pi*x)/x|"
      "exp(2*x + 1)|cos(x)/x|(x - 2)^66|log(1 + x)/x|sqrt(exp(x)*4)|a/7 - -c|b^a|2^-3|0.1",
                    in_balls[] = "abs(-a)|log10(a)|asin(b)|min(3, b)|max(1,b,3)|2*pi*0.25",
                    no_value[] = "1/c|sqrt(-1)|log(c)|asin(3)|(-1)^b|c^-1";
  const double values[LETTERS] = { 0x1p-10, 3, 0.5, 0 };
  char message[FORMULA_MESSAGE];
  struct formula formula;
  SCOPED(work, w);
  SCOPED(arb, got, tenth);
  arb_ptr balls = _arb_vec_init(LETTERS);
  for (int i = 0; i < LETTERS; i++)
    arb_set_d(balls + i, values[i]);
  set_numbers(&w);
  for (int k = 0; k < 3; k++)
    FOR_CASES (text, k == 2 ? no_value : k ? in_balls : in_both) {
      assert_null(formula_read(&formula, text, &names, message));
      double wanted = formula_double(&formula, values);
      formula_ball(got, &formula, balls, PRECISION);
      for (int in_series = 0; in_series < (k ? 1 : 2); in_series++) {
        if (in_series) {
          evaluate(&w[3], text, w);
          series_value(got, &w[3], balls, w[3].known, PRECISION);
        }
        if (k == 2 ? arb_is_finite(got)
                   : !check_relative(middle(got), wanted, 16 * 0x1p-53) || arb_rel_accuracy_bits(got) <= PRECISION - 40)
          fail_msg("%s is %.17g, not %.17g", text, middle(got), wanted);
      }
    }
  assert_null(formula_read(&formula, "0.1", &names, message));
  formula_ball(got, &formula, balls, PRECISION);
  arb_set_ui(tenth, 1);
  arb_div_ui(tenth, tenth, 10, 2 * PRECISION);
  assert_true(arb_contains(got, tenth) && arb_rel_accuracy_bits(got) > PRECISION - 3);
  _arb_vec_clear(balls, LETTERS);
}

/* Refused, with these words, and the value as it was; of what is no formula at all there is another test. */
TEST(what_a_series_cannot_do)
{
  static const char *const refusals[][2] = {
    { "1 + sqrt(x)", "character 5: sqrt gives a power of T that is not whole" },
    { "x^b", "character 2: ^ gives a power of T that is not whole" },
    { "1 + (x^2)^4097", "character 10: ^ gives a power of T beyond 4096" },
    { "(x^65)^64 + 1", "character 7: ^ gives a power of T beyond 4096" },
    { "sqrt(-2)", "character 1: sqrt of what is negative" },
    { "(x - 2)^b", "character 8: ^ of what is negative" },
    { "(-2)^b", "character 5: ^ of what is negative" },
    { "sin(pi)^0.2", "character 8: ^ of what may be 0" },
    { "sqrt(1/x - exp(1)/exp(1)/x)", "character 1: sqrt of what may be 0" },
    { "2 + log(x)", "character 5: log of a power of T: a series has no logarithm of T" },
    { "log(x - 1)", "character 1: log of what is negative" },
    { "log(c)", "character 1: log of what may be 0" },
    { "exp(1/x)", "character 1: exp of a negative power of T is not a series" },
    { "sin(x^-2)", "character 1: sin of a negative power of T is not a series" },
    { "cos(-2/x)", "character 1: cos of a negative power of T is not a series" },
    { "exp(1e300)", "character 1: exp is too large" },
    { "2 + asin(x)", "character 5: asin has no series in T" },
    { "abs(x)", "character 1: abs has no series in T" },
    { "log10(1 + x)", "character 1: log10 has no series in T" },
    { "min(x, 1)", "character 1: min has no series in T" },
    { "max(x, 1, a)", "character 1: max has no series in T" },
    { "(1 + x)^x", "character 8: ^ has a series for powers that are fractions only" },
    { "2^pi", "character 2: ^ has a series for powers that are fractions only" },
    { "3^1e300", "character 2: ^ is too large" },
    { "2 + 1/(x - x)", "character 6: / divides by what may be 0" },
    { "1/(3-a)", "character 2: / divides by what may be 0" },
    { "a + c^-2", "character 6: ^ divides by what may be 0" },
    { "c^-65", "character 2: ^ of what may be 0" },
    { "(((2^64)^64)^63)^5", "character 17: ^ is too large" },
    { "(((x/2^64)^64)^63)^-5", "character 19: ^ is too large" },
    { "1 + unknown", "character 5: 'unknown' is no quantity known here" },
  };
  struct random r = { 20260812 };
  SCOPED(work, w);
  SCOPED(fmpq, number);
  set_numbers(&w);
  random_terms(&w[3], &r, -2, 6);
  series_set(&w[4], &w[3]);
  for (size_t i = 0; i < sizeof refusals / sizeof *refusals; i++) {
    const char *wrong = try_formula(&w[3], refusals[i][0], w);
    if (!wrong || strcmp(wrong, refusals[i][1]) != 0)
      fail_msg("%s: %s", refusals[i][0], wrong ? wrong : "is taken");
    assert_true(w[3].kind == SERIES_FRACTIONS && w[3].first == w[4].first && w[3].known == SERIES_ALL);
    check_same(&w[3], &w[4], refusals[i][0]);
  }
  evaluate(&w[3], "(((2^64)^64)^63)^4", w);
  assert_true(series_rational_coefficient(number, &w[3], 0) && fmpz_is_one(fmpq_denref(number)));
  assert_true(fmpz_bits(fmpq_numref(number)) == 1 + 64 * 64 * 63 * 4);
}

/* Each is the fraction behind it, which FLINT reads by itself, or no number. In hexadecimal, and in decimals with all
 * of its digits, a double is read as the number it is. */
TEST(numbers)
{
  static const char good
      [] = "0.7 = 7/10|.5 = 1/2|5. = 5|+3 = 3|-3 = -3|-.25 = -1/4|0 = 0|-0 = 0|0.0 = 0|007 = 7|1e3 = 1000|1E3 = 1000|"
           "1e+3 = 1000|25e-2 = 1/4|1.5e1 = 15|5.e1 = 50|.5e1 = 5|0x1.8p-3 = 3/16|0x10 = 16|0X1P4 = 16|0x.8 = 1/2|"
           "0xaB = 171|-0x1p0 = -1|0x1e5 = 485|0x1.p+1 = 2|1e-0 = 1|0e99999 = 0|1e-30 = "
           "1/1000000000000000000000000000000|"
           "123456789012345678901234567890.5 = 246913578024691357802469135781/2",
  bad[] =
      "| |1e|1e+|1e-|abc|1e999999|1e-999999|inf|nan|-inf|1 | 1|--1|+-1|-|+|.|-.|1..2|1.2.3|1,5|1_000|0x|0x.|0xg|0x1p|"
      "1p3|1f|1e5.5|1e 5|1e+ 5|e5|1/2|1d5|1-|infinity|0x1.8p-3 |1e1e1|1e100001|1e99999999999999999999";
  static char digits[2000];
  struct random r = { 20260814 };
  SCOPED(fmpq, got, wanted);
  FOR_CASES (text, good) {
    assert_int_equal(fmpq_set_str(wanted, wanted_of(text), 10), 0);
    if (!scallop_rational_parse(got, text) || !fmpq_equal(got, wanted))
      fail_msg("%s is not read as that", text);
  }
  FOR_CASES (text, bad)
    if (scallop_rational_parse(got, text) || !fmpq_equal(got, wanted))
      fail_msg("\"%s\" is taken", text);
  for (int i = 0; i < 500; i++) {
    double value = random_decades(&r, 1e-300, 1e300) * (random_below(&r, 2) ? 1 : -1);
    scallop_rational_set_double(wanted, value);
    snprintf(digits, sizeof digits, i % 2 ? "%a" : "%.1100e", value);
    assert_true(scallop_rational_parse(got, digits) && fmpq_equal(got, wanted));
  }
}
