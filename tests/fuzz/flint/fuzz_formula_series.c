/* Formulas as series: identities that hold for whatever is taken, the same with more terms and bits, the value of a
 * formula of numbers in balls, and an untouched value where it refuses. In double: fuzz_formula.c. */
#include "asymptotics/derived/formula_flint.h"
#include "asymptotics/symbolic/symbolic.h"

#include <stdlib.h>
#include <string.h>

#include "tests/fuzz/target.h"
#include "tests/support/exact.h"

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

static bool evaluate_in(struct series *value, const char *text, const struct ring *in)
{
  struct formula formula;
  char message[FORMULA_MESSAGE];
  SCOPED(series, x, h, b);
  SCOPED(fmpq, half);
  SCOPED(arb, pi);
  if (formula_read(&formula, text, &names, message))
    return false;
  fmpq_set_si(half, 1, 2);
  arb_const_pi(pi, ring.precision);
  series_set_x(&x);
  series_set_rational(&h, half);
  series_set_ball(&b, pi);
  return !formula_series(value, &formula, (const struct series[SYMBOLS]){ x, h, b }, NULL, in, message);
}

/* The format has the text once or twice. */
static bool evaluate(struct series *value, const char *format, const char *text)
{
  char formula[3 * LONGEST + 32];
  snprintf(formula, sizeof formula, format, text, text);
  return evaluate_in(value, formula, &ring);
}

/* All coefficients are the same that both know. */
static bool agree(const struct series *a, const struct series *b)
{
  const slong known = a->known < b->known ? a->known : b->known, first = a->first < b->first ? a->first : b->first;
  for (slong k = first - 1; k < known && k < first + longer.length; k++)
    if (!same_coefficient(a, b, k, longer.precision))
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

/* Identities, wherever both sides are taken; what is taken once is taken with more around it. */
static void judge(const struct series *value, const char *text)
{
  static const struct {
    const char *format;
    int factor; /* the formula is so many times value */
    bool must_be_taken;
  } identities[] = { { " (%s) ", 1, true },       { "-(%s)", -1, true },        { "(%s)-(%s)", 0, true },
                     { "(%s)/(%s)-1", 0, false }, { "exp(log(%s))", 1, false }, { "sin(%s)^2+cos(%s)^2-1", 0, false } };
  SCOPED(series, got, wanted, more);
  for (size_t i = 0; i < sizeof identities / sizeof *identities; i++) {
    series_set_si(&wanted, identities[i].factor);
    series_mul(&wanted, &wanted, value, &ring);
    if (!evaluate(&got, identities[i].format, text) ? identities[i].must_be_taken : !agree(&got, &wanted))
      fuzz_fail("%s of '%s' is something else", identities[i].format, text);
    if (i < 2 && (got.kind != value->kind || got.known != value->known))
      fuzz_fail("%s of '%s' is known to another power", identities[i].format, text);
  }
  if (evaluate_in(&more, text, &longer) && !agree(value, &more))
    fuzz_fail("'%s' has other coefficients with more terms and bits", text);
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
  if (evaluate_in(&value, text, &ring)) {
    judge_in_balls(&value, text);
    judge_symbolic(&value, text);
    judge(&value, text);
  } else if (value.kind != untouched.kind || !agree(&value, &untouched))
    fuzz_fail("'%s' is refused, and something changed", text);
  free(text);
  return 0;
}
