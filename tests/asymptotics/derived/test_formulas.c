/* The texts of the formulas: in double and as series, against a second reader of formulas, and coefficient
 * by coefficient against the derived expansions. */
#include <ctype.h>
#include <float.h>
#include <stdlib.h>

#include "asymptotics/derived/evaluate.h"
#include "model/gaits.h"
#include "tests/support/exact.h"

enum { PRECISION = 300, LENGTH = 24 };
static const struct ring ring = { LENGTH, PRECISION };

/* The size is what the formula is with the absolute value of every term, as in test_published.c: a rounding error is a
 * few epsilon of it. */
struct sized {
  double value, size;
};

struct reader {
  const char *at;
  const struct scallop_formula *formula;
  const struct scallop_symbols *symbols;
  bool exchanged;
};

static const char *const names[SCALLOP_SYMBOLS] = { "m1",    "m2", "F1", "F2", "M",       "L",  "L_kin",
                                                    "alpha", "T",  "l0", "lT", "k0",      "kT", "l_start",
                                                    "l_end", "v0", "t1", "dT", "x_switch" };
static const char *const exchanged_names[SCALLOP_SYMBOLS] = { "m2",      "m1", "F2", "F1", "M",       "L",  "L_kin",
                                                              "alpha",   "T",  "l0", "lT", "k0",      "kT", "l_end",
                                                              "l_start", "v0", "t1", "dT", "x_switch" };

static struct sized sum(struct reader *r);

static struct sized atom(struct reader *r)
{
  struct sized result = { NAN, NAN };
  char *end;
  if (*r->at == '(') {
    r->at++;
    result = sum(r);
    r->at++;
    return result;
  }
  if (isdigit((unsigned char)*r->at)) {
    result.value = result.size = strtod(r->at, &end);
    r->at = end;
    return result;
  }
  size_t length = 0;
  while (isalnum((unsigned char)r->at[length]) || r->at[length] == '_')
    length++;
  SCOPED(arb, ball);
  for (int i = 0; i < SCALLOP_SYMBOLS; i++) {
    const char *name = (r->exchanged ? exchanged_names : names)[i];
    if (strlen(name) != length || memcmp(name, r->at, length) != 0)
      continue;
    series_coefficient(ball, &r->symbols->value[i], 0, PRECISION);
    bool turns = r->exchanged && (name[0] == 'l' || name[0] == 'k') && (name[1] == '0' || name[1] == 'T');
    result.value = turns ? -middle(ball) : middle(ball);
    result.size = fabs(result.value);
  }
  for (const struct scallop_part *part = r->formula->parts; part && part->name; part++)
    if (strlen(part->name) == length && memcmp(part->name, r->at, length) == 0) {
      struct reader inner = *r;
      inner.at = part->text;
      result = sum(&inner);
    }
  r->at += length;
  return result;
}

static struct sized power(struct reader *r)
{
  struct sized base = atom(r);
  if (*r->at != '^')
    return base;
  int n = r->at[1] - '0';
  r->at += 2;
  return (struct sized){ pow(base.value, n), pow(base.size, n) };
}

static struct sized product(struct reader *r)
{
  bool minus = *r->at == '-';
  r->at += minus;
  struct sized result = power(r);
  while (*r->at == '*' || *r->at == '/') {
    bool times = *r->at++ == '*';
    struct sized factor = power(r);
    result.value = times ? result.value * factor.value : result.value / factor.value;
    result.size *= times ? factor.size : factor.size / (factor.value * factor.value);
  }
  result.value = minus ? -result.value : result.value;
  return result;
}

static struct sized sum(struct reader *r)
{
  struct sized result = product(r);
  for (;;) {
    while (*r->at == ' ')
      r->at++;
    if (*r->at != '+' && *r->at != '-')
      return result;
    double sign = *r->at++ == '+' ? 1 : -1;
    while (*r->at == ' ')
      r->at++;
    struct sized term = product(r);
    result.value += sign * term.value;
    result.size += term.size;
  }
}

/* No formula has more than 32 operations; the inputs l0, lT and L_kin are rounded themselves, and enter with small
 * powers. */
#define ROUNDING (32 * DBL_EPSILON)

static bool of_extension(const struct scallop_formula *f)
{
  return f->setting != SCALLOP_MOVING_CONTRACTION && f->setting != SCALLOP_STEADY;
}

static void check_value(const struct scallop_formula *f, const struct scallop_symbols *s, enum scallop_phase_kind kind,
                        double function)
{
  struct reader r = { f->text, f, s, of_extension(f) && kind == SCALLOP_CONTRACTION };
  SCOPED(series, value);
  SCOPED(arb, ball);
  char message[FORMULA_MESSAGE];
  assert_null(scallop_formula_expand(&value, f, s, kind, &ring, message));
  assert_int_equal(next_nonzero(&value, 1, LENGTH), LENGTH);
  series_coefficient(ball, &value, 0, PRECISION);
  struct sized again = sum(&r);
  if (*r.at != '\0' || !check_near(function, middle(ball), ROUNDING * again.size)
      || !check_near(again.value, middle(ball), ROUNDING * again.size)) {
    fail_msg("%s: the function gives %.17g, the text %.17g, read again %.17g, size %g", f->name, function, middle(ball),
             again.value, again.size);
  }
}

static void set_symbol(struct scallop_symbols *s, enum scallop_symbol symbol, double value)
{
  SCOPED(fmpq, exact);
  scallop_rational_set_double(exact, value);
  series_set_rational(&s->value[symbol], exact);
}

static void check_phase_texts(const struct scallop_crawler *c, struct scallop_symbols *s, enum scallop_phase_kind kind,
                              struct random *r)
{
  static const enum scallop_symbol given[] = { SCALLOP_SYMBOL_t1, SCALLOP_SYMBOL_dT, SCALLOP_SYMBOL_x_switch };
  double start = random_between(r, -3, 3), T = scallop_phase_duration(c, kind);
  double times[] = { T * random_between(r, 0, 0.5), T * random_between(r, 0, 0.5), random_between(r, -9, 9) };
  SCOPED(fmpq, v0);
  SCOPED(scallop_rational, exact);
  scallop_rational_of(&exact, c);
  scallop_rational_set_double(v0, start);
  scallop_symbols_set(s, &exact, kind, v0, NULL, &ring);
  set_symbol(s, SCALLOP_SYMBOL_T, T);
  for (int i = 0; i < 3; i++)
    set_symbol(s, given[i], times[i]);
  const struct scallop_formula *const lists[] = { scallop_published, scallop_corrected };
  for (int i = 0; i < 2; i++)
    for (const struct scallop_formula *f = lists[i]; f->name; f++)
      if (f->setting != SCALLOP_STEADY && (of_extension(f) || kind == SCALLOP_CONTRACTION))
        check_value(f, s, kind, scallop_published_value(f, c, kind, start, times[0], times[1], times[2]));
}

static void check_steady_texts(const struct scallop_crawler *c, struct scallop_symbols *s)
{
  SCOPED(scallop_rational, exact);
  scallop_rational_of(&exact, c);
  scallop_symbols_set(s, &exact, SCALLOP_EXTENSION, NULL, NULL, &ring);
  set_symbol(s, SCALLOP_SYMBOL_T, c->T);
  const struct scallop_formula *const lists[] = { scallop_published, scallop_corrected };
  for (int i = 0; i < 2; i++)
    for (const struct scallop_formula *f = lists[i]; f->name; f++)
      if (f->setting == SCALLOP_STEADY)
        check_value(f, s, SCALLOP_EXTENSION, scallop_published_value(f, c, SCALLOP_EXTENSION, NAN, NAN, NAN, NAN));
}

/* k0 and kT in double, of laws of each kind */
TEST(fourth_derivatives)
{
  struct scallop_polynomial made[2];
  const char *why;
  const struct scallop_gait *gaits[] = { &scallop_gait_quadratic, &scallop_gait_sinusoidal,
                                         &trapezoid_gait,         &made[0].gait,
                                         &made[1].gait,           &minimum_jerk_gait };
  assert_int_equal(scallop_make_polynomial(&made[0], "a", (double[]){ 0, 0, 3, -2 }, 3, &why), SCALLOP_OK);
  assert_int_equal(scallop_make_polynomial(&made[1], "b", (double[]){ 0, 0, 0, 10, -15, 6 }, 5, &why), SCALLOP_OK);
  SCOPED(scallop_rational, exact);
  SCOPED(scallop_symbols, s);
  SCOPED(arb, k);
  fmpq_set_si(exact.L, 1, 1);
  for (size_t i = 0; i < 2 * sizeof gaits / sizeof *gaits; i++)
    for (int end = 0; end < 2; end++) {
      enum scallop_phase_kind kind = i % 2 ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION;
      exact.gait = gaits[i / 2];
      scallop_symbols_set(&s, &exact, kind, NULL, NULL, &ring);
      series_coefficient(k, &s.value[end ? SCALLOP_SYMBOL_kT : SCALLOP_SYMBOL_k0], 0, 128);
      double wanted = arf_get_d(arb_midref(k), ARF_RND_NEAR);
      CHECK_NEAR(scallop_fourth_derivative(&exact.gait->phase[kind], end), wanted,
                 8 * DBL_EPSILON * (fabs(wanted) + 1));
    }
  const struct scallop_piece lawless = { .end = 1, .direction = 1 };
  CHECK_EQUAL(scallop_fourth_derivative(&(struct scallop_shape){ .pieces = &lawless, .count = 1 }, true), NAN);
}

TEST(a_text_is_the_same_number_in_double_and_as_a_series)
{
  static const struct scallop_gait *const gaits[] = { &scallop_gait_quadratic, &scallop_gait_sinusoidal,
                                                      &trapezoid_gait };
  struct random r = { 20260851 };
  SCOPED(scallop_symbols, s);
  for (int i = 0; i < 300; i++) {
    struct scallop_crawler c = random_crawler(&r, ORDINARY, gaits[i % 3]);
    check_phase_texts(&c, &s, SCALLOP_EXTENSION, &r);
    check_phase_texts(&c, &s, SCALLOP_CONTRACTION, &r);
    check_steady_texts(&c, &s);
  }
}

/* What corrects a formula gives the same quantity, and no less of it. */
TEST(corrected_ones_exist)
{
  for (const struct scallop_formula *f = scallop_published; f->name; f++) {
    if (!f->corrected)
      continue;
    const struct scallop_formula *right = scallop_formula_named(f->corrected);
    assert_non_null(right);
    assert_int_equal(right->quantity, f->quantity);
    assert_true(right->remainder >= f->remainder);
    assert_true(right->setting == f->setting
                || (f->setting == SCALLOP_MOVING_CONTRACTION && right->setting == SCALLOP_MOVING_EXTENSION));
    assert_non_null(strstr(right->equation, f->equation));
  }
  for (const struct scallop_formula *f = scallop_corrected; f->name; f++)
    assert_true(f->text && !f->corrected);
}
