/* Formulas: the first byte chooses the values of the quantities, the rest is the formula. What is compiled is worth
 * what a plain reading of the text gives, which looks for the operation that comes last and then at what is on both
 * sides of it; what is refused is refused with a place in the text, and changes nothing. */
#include "asymptotics/formula.h"

#include <ctype.h>
#include <float.h>
#include <math.h>
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

enum kind { NUMBER = '0', NAME = 'a' }; /* or the character itself */

struct token {
  char kind;
  const char *text;
  size_t length;
};

static size_t length_of_name(const char *at)
{
  size_t length = 0;
  while (isalnum((unsigned char)at[length]) || (at[length] != '\0' && strchr("_.:", at[length])))
    length++;
  return length;
}

static struct token *split(const char *text, int *count)
{
  struct token *tokens = malloc((strlen(text) + 1) * sizeof *tokens);
  if (!tokens)
    fuzz_fail("out of memory");
  *count = 0;
  for (const char *at = text + strspn(text, " \t"); *at; at += strspn(at, " \t")) {
    struct token token = { .kind = *at, .text = at, .length = 1 };
    char *end;
    if (isalpha((unsigned char)*at)) {
      token.kind = NAME;
      token.length = length_of_name(at);
    } else if (strtod(at, &end), isdigit((unsigned char)*at) || *at == '.') {
      token.kind = NUMBER;
      token.length = (size_t)(end - at);
    }
    if (token.length == 0)
      fuzz_fail("'%s' was taken for a formula", text);
    tokens[(*count)++] = token;
    at += token.length;
  }
  return tokens;
}

/* The first or the last of these operators with an operand on its left, outside of parentheses; -1: there is none. */
static int find(const struct token *tokens, int from, int to, const char *operators, bool last)
{
  int found = -1, depth = 0;
  for (int i = from; i < to && (last || found < 0); i++) {
    depth += (tokens[i].kind == '(') - (tokens[i].kind == ')');
    bool binary = i > from && strchr(")0a", tokens[i - 1].kind) != NULL;
    if (depth == 0 && binary && strchr(operators, tokens[i].kind))
      found = i;
  }
  return found;
}

static double power(double x, double n)
{
  double powers[5] = { x }, product = 1;
  if (!(fabs(n) <= 16 && n == trunc(n)))
    return pow(x, n);
  for (int i = 1; i < 5; i++)
    powers[i] = powers[i - 1] * powers[i - 1];
  for (int i = 0; i < 5; i++)
    if ((int)fabs(n) & 1 << i)
      product *= powers[i];
  return n < 0 ? 1 / product : product;
}

static double worth(const struct token *tokens, int from, int to, const double *values);

static double of_function(const char *name, const struct token *tokens, int from, int to, const double *values)
{
  int comma = find(tokens, from, to, ",", true);
  double x = worth(tokens, comma < 0 ? from : comma + 1, to, values);
  if (strncmp(name, "abs", 3) == 0)
    return fabs(x);
  if (strncmp(name, "sqrt", 4) == 0)
    return sqrt(x);
  if (strncmp(name, "exp", 3) == 0)
    return exp(x);
  if (strncmp(name, "log10", 5) == 0)
    return log10(x);
  if (strncmp(name, "log", 3) == 0)
    return log(x);
  if (strncmp(name, "sin", 3) == 0)
    return sin(x);
  if (strncmp(name, "cos", 3) == 0)
    return cos(x);
  if (strncmp(name, "asin", 4) == 0)
    return asin(x);
  if (comma < 0)
    return x;
  double rest = of_function(name, tokens, from, comma, values);
  if (isnan(x) || isnan(rest))
    return NAN;
  return name[1] == 'i' ? (rest < x ? rest : x) : (rest > x ? rest : x);
}

static double of_operands(char operation, double a, double b)
{
  switch (operation) {
  case '+': return a + b;
  case '-': return a - b;
  case '*': return a * b;
  case '/': return a / b;
  default: return power(a, b);
  }
}

static double worth(const struct token *tokens, int from, int to, const double *values)
{
  const struct token *first = &tokens[from];
  int at = find(tokens, from, to, "+-", true);
  if (at < 0)
    at = find(tokens, from, to, "*/", true);
  if (at < 0 && first->kind == '-')
    return -worth(tokens, from + 1, to, values);
  if (at < 0)
    at = find(tokens, from, to, "^", false);
  if (at >= 0)
    return of_operands(tokens[at].kind, worth(tokens, from, at, values), worth(tokens, at + 1, to, values));
  if (first->kind == '(')
    return worth(tokens, from + 1, to - 1, values);
  if (first->kind == NUMBER)
    return strtod(first->text, NULL);
  if (to > from + 1)
    return of_function(first->text, tokens, from + 2, to - 1, values);
  for (int i = 0; i < NAMES; i++)
    if (strlen(names[i]) == first->length && strncmp(names[i], first->text, first->length) == 0)
      return values[i];
  if (first->length == 2 && strncmp(first->text, "pi", 2) == 0)
    return 0x1.921fb54442d18p+1;
  fuzz_fail("'%s' was taken for a quantity", first->text);
}

static void judge_value(const struct formula *formula, const char *text, const double *values)
{
  int count, places[FORMULA_STEPS], used = formula_places(formula, places);
  for (int i = 0; i < used; i++)
    if (places[i] < 0 || places[i] >= NAMES)
      fuzz_fail("place %d in %s", places[i], text);
  struct token *tokens = split(text, &count);
  double got = formula_double(formula, values), wanted = worth(tokens, 0, count, values);
  if (!same_bits(got, wanted) && !(isnan(got) && isnan(wanted)))
    fuzz_fail("%s = %a, not %a", text, got, wanted);
  free(tokens);
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
