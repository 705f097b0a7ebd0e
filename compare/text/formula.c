#include "compare/text/formula.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct parser {
  const char *text, *at; /* the formula, and what is to be read next */
  struct arithmetic compiled;
  arithmetic_names *names;
  void *context;
  int nested;
};

/* ---- complaints ---- */

static char message[320];

static bool fail(const struct parser *p, const char *at, const char *format, ...) __attribute__((format(printf, 3, 4)));
static bool fail(const struct parser *p, const char *at, const char *format, ...)
{
  va_list arguments;
  int used = snprintf(message, sizeof message, "character %ld: ", (long)(at - p->text) + 1);
  va_start(arguments, format);
  vsnprintf(message + used, sizeof message - (size_t)used, format, arguments);
  va_end(arguments);
  return false;
}

static bool is_in_number(char c) { return isdigit((unsigned char)c) || c == '.'; }

static bool is_in_name(char c) { return isalnum((unsigned char)c) || c == '_' || c == '.' || c == ':'; }

static bool has_meaning(char c) { return c == '\0' || isalnum((unsigned char)c) || strchr(".+-*/^(),", c); }

enum { SHOWN = 40 };

static void show(char text[SHOWN], char c)
{
  if (c == '\0')
    snprintf(text, SHOWN, "the end");
  else if (isgraph((unsigned char)c))
    snprintf(text, SHOWN, "'%c'", c);
  else
    snprintf(text, SHOWN, "the byte 0x%02x", (unsigned)(unsigned char)c);
}

static bool fail_here(const struct parser *p, const char *what)
{
  char shown[SHOWN];
  show(shown, *p->at);
  if (has_meaning(*p->at))
    return fail(p, p->at, "%s before %s", what, shown);
  return fail(p, p->at, "%s has no meaning: a formula is of numbers, names, + - * / ^ ( ) and commas", shown);
}

/* ---- steps ---- */

static bool add(struct parser *p, const char *at, struct arithmetic_step step)
{
  if (p->compiled.count == ARITHMETIC_STEPS)
    return fail(p, at, "the formula is too long: it may have %d numbers, names and operations", ARITHMETIC_STEPS);
  p->compiled.steps[p->compiled.count++] = step;
  return true;
}

static bool add_operation(struct parser *p, const char *at, enum arithmetic_operation operation)
{
  return add(p, at, (struct arithmetic_step){ .operation = operation });
}

/* ---- reading ---- */

/* The next character that is no blank */
static char next(struct parser *p)
{
  p->at += strspn(p->at, " \t");
  return *p->at;
}

static bool read_sum(struct parser *p);

static const char *skip_digits(const char *at)
{
  while (isdigit((unsigned char)*at))
    at++;
  return at;
}

/* Where a decimal number ends; at itself: there is none. */
static const char *end_of_number(const char *at)
{
  const char *whole = skip_digits(at), *end = *whole == '.' ? skip_digits(whole + 1) : whole;
  if (end == at + (*at == '.')) /* no digit */
    return at;
  if (*end == 'e' || *end == 'E') {
    const char *exponent = end + 1 + (end[1] == '+' || end[1] == '-');
    if (isdigit((unsigned char)*exponent))
      end = skip_digits(exponent);
  }
  return end;
}

static bool has_digit_but_zero(const char *from, const char *to)
{
  for (; from < to && *from != 'e' && *from != 'E'; from++)
    if (*from >= '1' && *from <= '9')
      return true;
  return false;
}

static bool read_number_step(struct parser *p)
{
  const char *start = p->at, *end = end_of_number(start);
  char *read;
  double number = strtod(start, &read);
  if (end == start)
    return fail(p, start, "there is no digit beside the point");
  if (read != end) /* 0x10 */
    return fail(p, start, "a number is decimal, as 16 or 1.6e1");
  if (isinf(number) || (number == 0 && has_digit_but_zero(start, end)))
    return fail(p, start, "the number is too %s for a double", isinf(number) ? "large" : "small");
  p->at = end;
  return add(p, start, (struct arithmetic_step){ .operation = ARITHMETIC_NUMBER, .number = number });
}

static const struct function {
  const char *name;
  enum arithmetic_operation operation;
  bool of_many;
} functions[] = { { "abs", ARITHMETIC_ABS, false }, { "sqrt", ARITHMETIC_SQRT, false },   { "exp", ARITHMETIC_EXP, false },
                  { "log", ARITHMETIC_LOG, false }, { "log10", ARITHMETIC_LOG10, false }, { "min", ARITHMETIC_MIN, true },
                  { "max", ARITHMETIC_MAX, true } };
enum { FUNCTIONS = sizeof functions / sizeof *functions };

static const struct function *function_named(const char *name)
{
  for (int i = 0; i < FUNCTIONS; i++)
    if (strcmp(functions[i].name, name) == 0)
      return &functions[i];
  return NULL;
}

/* After the parenthesis at open */
static bool read_close(struct parser *p, const char *open)
{
  char c = next(p);
  if (c == '\0')
    return fail(p, open, "this '(' is not closed");
  if (c != ')')
    return fail_here(p, c == ',' ? "a function is missing" : "an operator or ')' is missing");
  p->at++;
  return true;
}

/* Of two arguments the operation is one step, of three two */
static bool read_arguments(struct parser *p, const struct function *f, const char *start)
{
  const char *open = p->at;
  int count = 0;
  do {
    p->at++;
    if (!read_sum(p) || (f->of_many && count > 0 && !add_operation(p, start, f->operation)))
      return false;
    count++;
  } while (next(p) == ',');
  if (!read_close(p, open))
    return false;
  if (f->of_many ? count < 2 : count != 1)
    return fail(p, start, "%s takes %s, not %d", f->name, f->of_many ? "two arguments or more" : "one argument", count);
  return f->of_many || add_operation(p, start, f->operation);
}

static bool read_name(struct parser *p)
{
  const char *start = p->at;
  char name[ARITHMETIC_NAME];
  size_t length = 0;
  while (is_in_name(start[length]))
    length++;
  if (length >= ARITHMETIC_NAME)
    return fail(p, start, "a name of %zu characters: it may have %d", length, ARITHMETIC_NAME - 1);
  memcpy(name, start, length);
  name[length] = '\0';
  p->at += length;
  if (next(p) == '(') {
    const struct function *f = function_named(name);
    return f ? read_arguments(p, f, start)
             : fail(p, start, "'%s' is no function: there are abs sqrt exp log log10 min max", name);
  }
  int place = p->names(p->context, name);
  if (place < 0)
    return fail(p, start, "'%s' is no quantity%s", name,
                function_named(name) ? " but a function: '(' is missing after it" : " known here");
  return add(p, start, (struct arithmetic_step){ .operation = ARITHMETIC_QUANTITY, .place = place });
}

static bool read_value(struct parser *p)
{
  char c = next(p);
  const char *open = p->at;
  if (is_in_number(c))
    return read_number_step(p);
  if (isalpha((unsigned char)c))
    return read_name(p);
  if (c != '(')
    return fail_here(p, "a number, a name or '(' is missing");
  p->at++;
  return read_sum(p) && read_close(p, open);
}

static bool read_factor(struct parser *p);

static bool read_power(struct parser *p)
{
  if (!read_value(p))
    return false;
  if (next(p) != '^')
    return true;
  const char *sign = p->at++;
  return read_factor(p) && add_operation(p, sign, ARITHMETIC_POWER);
}

static bool read_negative(struct parser *p)
{
  const char *sign = p->at++;
  return read_factor(p) && add_operation(p, sign, ARITHMETIC_NEGATE);
}

static bool read_factor(struct parser *p)
{
  char c = next(p);
  if (p->nested == ARITHMETIC_NESTED)
    return fail(p, p->at, "too much within one another: %d parentheses, minus signs and powers are allowed",
                ARITHMETIC_NESTED);
  p->nested++;
  bool read = c == '-' ? read_negative(p) : read_power(p);
  p->nested--;
  return read;
}

static bool read_product(struct parser *p)
{
  bool read = read_factor(p);
  for (char c; read && ((c = next(p)) == '*' || c == '/');) {
    const char *sign = p->at++;
    read = read_factor(p) && add_operation(p, sign, c == '*' ? ARITHMETIC_MULTIPLY : ARITHMETIC_DIVIDE);
  }
  return read;
}

static bool read_sum(struct parser *p)
{
  bool read = read_product(p);
  for (char c; read && ((c = next(p)) == '+' || c == '-');) {
    const char *sign = p->at++;
    read = read_product(p) && add_operation(p, sign, c == '+' ? ARITHMETIC_ADD : ARITHMETIC_SUBTRACT);
  }
  return read;
}

static bool read_all(struct parser *p)
{
  if (next(p) == '\0')
    return fail(p, p->at, "there is no formula");
  if (!read_sum(p))
    return false;
  switch (next(p)) {
  case '\0': return true;
  case ')': return fail(p, p->at, "this ')' closes nothing");
  case ',': return fail(p, p->at, "this ',' is not between the arguments of a function");
  default: return fail_here(p, "an operator is missing");
  }
}

const char *arithmetic_compile(struct arithmetic *formula, const char *text, arithmetic_names *names, void *context)
{
  struct parser p = { .text = text, .at = text, .names = names, .context = context };
  if (!read_all(&p))
    return message;
  *formula = p.compiled;
  return NULL;
}

/* ---- values ---- */

static double power(double base, double exponent)
{
  double size = fabs(exponent), product = 1;
  if (!(size <= ARITHMETIC_PRODUCTS) || size != floor(size))
    return pow(base, exponent);
  for (int left = (int)size; left > 0; left /= 2) {
    if (left % 2 == 1)
      product *= base;
    base *= base;
  }
  return exponent < 0 ? 1 / product : product;
}

static double of_one(enum arithmetic_operation operation, double x)
{
  switch (operation) {
  case ARITHMETIC_NEGATE: return -x;
  case ARITHMETIC_ABS: return fabs(x);
  case ARITHMETIC_SQRT: return sqrt(x);
  case ARITHMETIC_EXP: return exp(x);
  case ARITHMETIC_LOG: return log(x);
  default: return log10(x);
  }
}

static double of_two(enum arithmetic_operation operation, double a, double b)
{
  switch (operation) {
  case ARITHMETIC_ADD: return a + b;
  case ARITHMETIC_SUBTRACT: return a - b;
  case ARITHMETIC_MULTIPLY: return a * b;
  case ARITHMETIC_DIVIDE: return a / b;
  case ARITHMETIC_POWER: return power(a, b);
  case ARITHMETIC_MIN: return a < b || isnan(a) ? a : b;
  default: return a > b || isnan(a) ? a : b;
  }
}

static bool takes_one(enum arithmetic_operation operation)
{
  return operation == ARITHMETIC_NEGATE || (operation >= ARITHMETIC_ABS && operation <= ARITHMETIC_LOG10);
}

double arithmetic_value(const struct arithmetic *formula, const double *values)
{
  double stack[ARITHMETIC_STEPS / 2 + 1] = { 0 }; /* each value but the last needs an operation that takes it away */
  double *top = stack;                            /* the last value is at top[-1]                                  */
  for (const struct arithmetic_step *s = formula->steps, *end = s + formula->count; s < end; s++) {
    if (s->operation == ARITHMETIC_NUMBER)
      *top++ = s->number;
    else if (s->operation == ARITHMETIC_QUANTITY)
      *top++ = values[s->place];
    else if (takes_one(s->operation))
      top[-1] = of_one(s->operation, top[-1]);
    else {
      top--;
      top[-1] = of_two(s->operation, top[-1], top[0]);
    }
  }
  return top[-1];
}

int arithmetic_places(const struct arithmetic *formula, int places[ARITHMETIC_STEPS])
{
  int count = 0;
  for (const struct arithmetic_step *s = formula->steps, *end = s + formula->count; s < end; s++) {
    int i = 0;
    if (s->operation != ARITHMETIC_QUANTITY)
      continue;
    while (i < count && places[i] != s->place)
      i++;
    if (i == count)
      places[count++] = s->place;
  }
  return count;
}
