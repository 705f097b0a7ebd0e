/* Formulas: the first byte chooses the values of the quantities, the rest is the formula. A name or a number is worth
 * what it is, and with each operation and function around it a formula is worth what C makes of its value (which of two
 * operations comes first: tests/asymptotics/test_formula.c); what is refused is refused with a place in the text, and
 * changes nothing. */
#include "asymptotics/formula.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/fuzz/target.h"

static const char *const names[] = { "F1", "T", "series:dT.15", "abs" };
enum { NAMES = sizeof names / sizeof *names };

static int place_of(void *context, const char *name)
{
  (void)context;
  for (int i = 0; i < NAMES; i++)
    if (strcmp(name, names[i]) == 0)
      return i;
  return -1;
}

static bool same(double a, double b) { return same_bits(a, b) || (isnan(a) && isnan(b)); }

/* More may be around it, unless that makes it too long. */
static void judge_form(const char *form, const char *text, const double *values, double wanted)
{
  struct formula formula;
  const size_t size = strlen(form) + strlen(text) + 1;
  char message[FORMULA_MESSAGE], *whole = malloc(size);
  if (!whole)
    fuzz_fail("out of memory");
  snprintf(whole, size, form, text);
  const char *wrong = formula_read(&formula, whole, &(struct formula_names){ .place = place_of }, message);
  if (wrong ? !strstr(wrong, ": too much within") && !strstr(wrong, "too long")
            : !same(formula_double(&formula, values), wanted))
    fuzz_fail("%s: %s, or not %a", whole, wrong ? wrong : "another value", wanted);
  free(whole);
}

/* What it is worth where it is a name or a number, and what other formulas are that it is a part of */
static void judge_value(const struct formula *formula, const char *text, const double *values)
{
  int places[FORMULA_STEPS], used = formula_places(formula, places), place = place_of(NULL, text);
  char *end;
  const double got = formula_double(formula, values), number = strtod(text, &end), f = values[0];
  for (int i = 0; i < used; i++)
    if (places[i] < 0 || places[i] >= NAMES)
      fuzz_fail("place %d in %s", places[i], text);
  if ((place >= 0 && !same(got, values[place]))
      || (*end == '\0' && strspn(text, ".0123456789") > 0 && !same(got, number)))
    fuzz_fail("%s = %a", text, got);
  const struct {
    const char *form;
    double wanted;
  } forms[] = { { " ( %s ) ", got },
                { "-(%s)", -got },
                { "(%s)+F1", got + f },
                { "F1-(%s)", f - got },
                { "(%s) * F1", got * f },
                { "F1/(%s)", f / got },
                { "(%s)^2.5", pow(got, 2.5) },
                { "abs(%s)", fabs(got) },
                { "sqrt(%s)", sqrt(got) },
                { "exp (%s)", exp(got) },
                { "log(%s)", log(got) },
                { "log10(%s)", log10(got) },
                { "sin(%s)", sin(got) },
                { "cos(%s)", cos(got) },
                { "asin(%s)", asin(got) },
                { "min(%s,F1)", isnan(got) || isnan(f) ? NAN
                                : got < f              ? got
                                                       : f },
                { "max(F1, %s)", isnan(got) || isnan(f) ? NAN
                                 : f > got              ? f
                                                        : got } };
  for (size_t i = 0; i < sizeof forms / sizeof *forms; i++)
    judge_form(forms[i].form, text, values, forms[i].wanted);
}

static void judge_refusal(const char *wrong, const char *text)
{
  char *end;
  long place = strncmp(wrong, "character ", 10) == 0 ? strtol(wrong + 10, &end, 10) : 0;
  if (place < 1 || place > (long)strlen(text) + 1 || strncmp(end, ": ", 2) != 0 || strlen(end) < 10)
    fuzz_fail("'%s' is refused with '%s'", text, wrong);
  for (const char *c = wrong; *c; c++)
    if (*c < 0x20 || *c > 0x7e)
      fuzz_fail("'%s' is refused with the byte %d", text, *c);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  static const double pool[] = { 4.25, 0.3, -2.385, 0.0, -0.0, 1e-300, -1e300, NAN, INFINITY, 2, 16, 0.5 };
  struct formula formula;
  double values[NAMES];
  if (size == 0)
    return 0;
  for (size_t i = 0; i < NAMES; i++)
    values[i] = pool[(data[0] + i * (1 + data[0] / 32U)) % (sizeof pool / sizeof *pool)];
  char *text = fuzz_text(data + 1, size - 1);
  memset(&formula, UNTOUCHED, sizeof formula);
  char message[FORMULA_MESSAGE];
  const char *wrong = formula_read(&formula, text, &(struct formula_names){ .place = place_of }, message);
  if (!wrong)
    judge_value(&formula, text, values);
  else if (!untouched(&formula, sizeof formula))
    fuzz_fail("'%s' is refused, and the formula changed", text);
  else
    judge_refusal(wrong, text);
  free(text);
  return 0;
}
