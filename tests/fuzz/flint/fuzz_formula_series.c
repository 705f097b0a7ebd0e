/* Formulas as series: identities that hold for whatever is taken, the same with more terms and bits, the value of a
 * formula of numbers in balls, and an untouched value where it refuses. Read by another parser: fuzz_formula.c. */
#include "asymptotics/derived/formula_flint.h"

#include "asymptotics/symbolic/symbolic.h"

#include <stdlib.h>
#include <string.h>

#include "tests/fuzz/target.h"
#include "tests/support/scoped.h"

enum { LONGEST = 120, MOST_POWERS = 2 /* of powers: numbers would have millions of digits */ };
static const struct ring ring = { .length = 6, .precision = 100 }, longer = { .length = 15, .precision = 150 };

/* x is the variable, h is 1/2, b a ball */
static const char symbols[] = "xhb";
enum { SYMBOLS = sizeof symbols - 1 };

static int place_of(void *context, const char *name)
{
  (void)context;
  const char *found = strlen(name) == 1 ? strchr(symbols, *name) : NULL;
  return found ? (int)(found - symbols) : -1;
}

static const struct formula_names names = { .place = place_of };

static bool evaluate_text(struct series *value, const char *text, const struct ring *in)
{
  struct formula formula;
  char message[FORMULA_MESSAGE];
  struct series values[SYMBOLS];
  if (formula_read(&formula, text, &names, message))
    return false;
  for (int i = 0; i < SYMBOLS; i++)
    series_init(&values[i]);
  SCOPED(fmpq, half);
  SCOPED(arb, pi);
  fmpq_set_si(half, 1, 2);
  arb_const_pi(pi, ring.precision);
  series_set_x(&values[0]);
  series_set_rational(&values[1], half);
  series_set_ball(&values[2], pi);
  bool evaluated = !formula_series(value, &formula, values, NULL, in, message);
  for (int i = 0; i < SYMBOLS; i++)
    series_clear(&values[i]);
  return evaluated;
}

/* Evaluates the formula that consists of these parts, NULL-terminated. */
static bool evaluate(struct series *value, const char *const *parts)
{
  char formula[3 * LONGEST + 32] = "";
  for (size_t used = 0; *parts; used = strlen(formula), parts++)
    snprintf(formula + used, sizeof formula - used, "%s", *parts);
  return evaluate_text(value, formula, &ring);
}
#define EVALUATE(value, ...) evaluate(value, (const char *const[]){ __VA_ARGS__, NULL })

static bool ratio_equal(const struct ratio *a, const struct ratio *b)
{
  const fmpz_mpoly_ctx_struct *of = a->names->ring;
  return fmpz_mpoly_equal(a->over, b->over, of) && fmpz_mpoly_equal(a->under, b->under, of);
}

static bool are_equal(const struct series *a, const struct series *b)
{
  if (a->kind != b->kind || a->first != b->first || a->known != b->known || series_terms(a) != series_terms(b))
    return false;
  bool equal = a->kind == SERIES_FRACTIONS ? fmpq_poly_equal(a->rational, b->rational)
               : a->kind == SERIES_BALLS   ? arb_poly_equal(a->ball, b->ball)
                                           : true;
  for (slong k = 0; a->kind == SERIES_NAMED && k < a->named.length; k++)
    equal = equal && ratio_equal(&a->named.coeffs[k], &b->named.coeffs[k]);
  return equal;
}

/* May every coefficient that is known be 0? */
static bool may_vanish(const struct series *s)
{
  if (s->kind != SERIES_BALLS)
    return series_terms(s) == 0;
  for (slong i = 0; i < arb_poly_length(s->ball); i++)
    if (!arb_contains_zero(arb_poly_get_coeff_ptr(s->ball, i)))
      return false;
  return true;
}

/* Without the variable: the same in balls, where they have a value; exact without functions, powers and a ball */
static void judge_in_balls(const struct series *value, const char *text)
{
  struct formula formula;
  char message[FORMULA_MESSAGE];
  int places[FORMULA_STEPS];
  formula_read(&formula, text, &names, message);
  for (int i = 0, count = formula_places(&formula, places); i < count; i++)
    if (places[i] == 0)
      return;
  arb_ptr values = _arb_vec_init(SYMBOLS);
  SCOPED(arb, wanted, got);
  arb_set_d(values + 1, 0.5);
  arb_const_pi(values + 2, ring.precision);
  formula_ball(wanted, &formula, values, ring.precision);
  series_coefficient(got, value, 0, ring.precision);
  if (value->kind == SERIES_BALLS && text[strspn(text, "0123456789h+-*/() ")] == '\0')
    fuzz_fail("'%s' is not exact", text);
  if (value->known < SERIES_ALL || (arb_is_finite(wanted) && !arb_overlaps(got, wanted)))
    fuzz_fail("'%s' is something else in balls", text);
  _arb_vec_clear(values, SYMBOLS);
}

/* As a formula, where it has one: h a symbol, b nothing that is known. With 1/2 for h the coefficients are the same,
 * where those are defined. */
static void judge_symbolic(const struct series *value, const char *text)
{
  struct formula formula;
  struct symbols s;
  SCOPED(series, x, h, unknown, in_symbols);
  char message[FORMULA_MESSAGE];
  SCOPED(fmpq, got, wanted);
  fmpq *half = _fmpq_vec_init(1);
  fmpq_set_si(half, 1, 2);
  formula_read(&formula, text, &names, message);
  symbols_init(&s);
  symbols_add(&s, NAMED_F1, 0, SCALLOP_EXTENSION);
  symbols_begin(&s);
  series_set_x(&x);
  series_set_ratio(&h, symbolic_place(&s, 0));
  series_set_unknown(&unknown);
  const struct series values[SYMBOLS] = { x, h, unknown };
  bool has_formula = !formula_series(&in_symbols, &formula, values, &s.names, &ring, message), defined = true;
  const slong end = in_symbols.first + series_terms(&in_symbols);
  for (slong k = in_symbols.first; has_formula && k < end; k++) /* not where a divisor is 0 for h = 1/2 only */
    defined = defined && symbolic_value(got, symbolic_coefficient(&s, &in_symbols, k), &s, half);
  for (slong k = -4; has_formula && defined && k < end && k < value->known; k++) {
    symbolic_value(got, symbolic_coefficient(&s, &in_symbols, k), &s, half);
    if (series_rational_coefficient(wanted, value, k) && !fmpq_equal(got, wanted))
      fuzz_fail("'%s' as a formula has another coefficient of x^%ld", text, (long)k);
  }
  _fmpq_vec_clear(half, 1);
  symbols_end(&s);
}

/* What is known of it is the same with more terms and bits, if it is taken then. */
static void judge_known(const struct series *value, const char *text)
{
  SCOPED(series, more);
  SCOPED(arb, a, b);
  if (!evaluate_text(&more, text, &longer))
    return;
  slong known = value->known < more.known ? value->known : more.known;
  for (slong i = value->first - 1; i < known && i < value->first + longer.length; i++) {
    series_coefficient(a, value, i, ring.precision);
    series_coefficient(b, &more, i, longer.precision);
    if (!arb_overlaps(a, b))
      fuzz_fail("'%s' has another coefficient of x^%ld with more terms", text, (long)i);
  }
}

/* Identities of functions, wherever all of them are taken */
static void judge_functions(const char *t)
{
  SCOPED(series, zero);
  if (EVALUATE(&zero, "exp(log(", t, "))-(", t, ")") && !may_vanish(&zero))
    fuzz_fail("exp(log(%s)) is something else", t);
  if (EVALUATE(&zero, "sin(", t, ")^2+cos(", t, ")^2-1") && !may_vanish(&zero))
    fuzz_fail("sin^2 + cos^2 of '%s' is not 1", t);
}

static void judge(const struct series *value, const char *text)
{
  SCOPED(series, other, negative);
  if (!EVALUATE(&other, " (", text, " ) ") || !are_equal(value, &other))
    fuzz_fail("in parentheses '%s' is something else", text);
  series_neg(&negative, value);
  if (!EVALUATE(&other, "-(", text, ")") || !are_equal(&negative, &other))
    fuzz_fail("-(%s) is not minus that", text);
  if (!EVALUATE(&other, "(", text, ")-(", text, ")") || !may_vanish(&other))
    fuzz_fail("'%s' minus itself is not 0", text);
  if (EVALUATE(&other, "(", text, ")/(", text, ")-1") && !may_vanish(&other))
    fuzz_fail("'%s' over itself is not 1", text);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  int powers = 0, nested = 0;
  for (size_t i = 0; i < size; i++) {
    powers += data[i] == '^';
    nested += data[i] == '^' || data[i] == '-' || data[i] == '(';
  }
  if (size > LONGEST || powers > MOST_POWERS || nested > FORMULA_NESTED - 4 /* the identities add some */
      || memchr(data, '\0', size))
    return 0;
  char *text = fuzz_text(data, size);
  SCOPED(series, value, untouched);
  series_set_si(&untouched, 22);
  series_set(&value, &untouched);
  if (EVALUATE(&value, text)) {
    judge_in_balls(&value, text);
    judge_symbolic(&value, text);
    judge_known(&value, text);
    judge(&value, text);
    judge_functions(text);
  } else if (!are_equal(&value, &untouched))
    fuzz_fail("'%s' is refused, and something changed", text);
  free(text);
  return 0;
}
