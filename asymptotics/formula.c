/* Formulas read into operations by recursive descent, one function for each line of the grammar in formula.h, and
 * evaluated in doubles. */
#include "asymptotics/formula.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct parser {
  const char *text; /* text of the formula, or of the part that is read */
  const char *part; /* name of the part, or NULL */
  const char *at;   /* next character to be read */
  struct formula made;
  const struct formula_names *names;
  int nested;
  char *message;
};

static const char *const texts[] = { "a number", "a name", "pi", "-", "abs", "sqrt", "exp", "log", "log10", "sin",
                                     "cos",      "asin",   "+",  "-", "*",   "/",    "^",   "min", "max" };
static const char *const functions[] = {
  "abs", "sqrt", "exp", "log", "log10", "sin", "cos", "asin", "min", "max", NULL
};

const char *formula_operation_text(enum formula_operation operation) { return texts[operation]; }

static bool fail(const struct parser *p, const char *at, const char *format, ...) __attribute__((format(printf, 3, 4)));
static bool fail(const struct parser *p, const char *at, const char *format, ...)
{
  va_list arguments;
  int used = p->part ? snprintf(p->message, FORMULA_MESSAGE, "%s, ", p->part) : 0;
  used += snprintf(p->message + used, FORMULA_MESSAGE - (size_t)used, "character %ld: ", (long)(at - p->text) + 1);
  va_start(arguments, format);
  vsnprintf(p->message + used, FORMULA_MESSAGE - (size_t)used, format, arguments);
  va_end(arguments);
  return false;
}

static bool is_in_name(char c) { return isalnum((unsigned char)c) || c == '_' || c == '.' || c == ':'; }

static bool fail_here(const struct parser *p, const char *what)
{
  char found[40], c = *p->at;
  if (isgraph((unsigned char)c))
    snprintf(found, sizeof found, "'%c'", c);
  else
    snprintf(found, sizeof found, "the byte 0x%02x", (unsigned)(unsigned char)c);
  if (c == '\0' || isalnum((unsigned char)c) || strchr(".+-*/^(),", c))
    return fail(p, p->at, "%s before %s", what, c ? found : "the end");
  return fail(p, p->at, "%s has no meaning: a formula is of numbers, names, + - * / ^ ( ) and commas", found);
}

static bool add_step(struct parser *p, const char *at, struct formula_step step)
{
  if (p->made.count == FORMULA_STEPS)
    return fail(p, at, "the formula is too long: it may have %d numbers, names and operations", FORMULA_STEPS);
  step.text = p->text;
  step.at = (int)(at - p->text);
  p->made.steps[p->made.count++] = step;
  return true;
}

static bool add(struct parser *p, const char *at, enum formula_operation operation)
{
  return add_step(p, at, (struct formula_step){ .operation = operation });
}

/* Skips blanks and returns the next character. */
static char next(struct parser *p)
{
  p->at += strspn(p->at, " \t");
  return *p->at;
}

/* Reads a number from its first digit or point. */
static bool read_number(struct parser *p)
{
  const char *start = p->at;
  char *end;
  errno = 0;
  double number = strtod(start, &end);
  if (end == start)
    return fail(p, start, "there is no digit beside the point");
  if (start[0] == '0' && tolower((unsigned char)start[1]) == 'x')
    return fail(p, start, "a number is decimal, as 16 or 1.6e1");
  if (end - start >= FORMULA_DIGITS)
    return fail(p, start, "a number of %ld characters: it may have %d", (long)(end - start), FORMULA_DIGITS - 1);
  if (errno == ERANGE && (isinf(number) || number == 0))
    return fail(p, start, "the number is too %s for a double", number == 0 ? "small" : "large");
  p->at = end;
  return add_step(p, start,
                  (struct formula_step){ .operation = FORMULA_NUMBER, .length = (int)(end - start), .number = number });
}

/* Returns the function of this name, or FORMULA_NUMBER for an unknown name. */
static enum formula_operation function_named(const char *name)
{
  for (int i = FORMULA_ABS; i <= FORMULA_MAX; i++)
    if (strcmp(texts[i], name) == 0)
      return (enum formula_operation)i;
  return FORMULA_NUMBER;
}

bool formula_is_word(const char *name) { return function_named(name) != FORMULA_NUMBER || strcmp(name, "pi") == 0; }

static bool read_sum(struct parser *p);

/* Reads the parenthesis that closes the parenthesis at open. */
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

/* Reads the arguments of a function: the operation is one step for two arguments, two steps for three. */
static bool read_arguments(struct parser *p, enum formula_operation function, const char *start)
{
  const char *open = p->at;
  bool of_many = function >= FORMULA_MIN;
  int count = 0;
  do {
    p->at++;
    if (!read_sum(p) || (of_many && count > 0 && !add(p, start, function)))
      return false;
    count++;
  } while (next(p) == ',');
  if (!read_close(p, open))
    return false;
  if (of_many ? count < 2 : count != 1)
    return fail(p, start, "%s takes %s, not %d", texts[function], of_many ? "two arguments or more" : "one argument",
                count);
  return of_many || add(p, start, function);
}

/* Reports an unknown name, or, if a list of functions is given, a name that is not in it. */
static bool fail_name(const struct parser *p, const char *start, const char *name, const char *const *of)
{
  static const char no_function[] = "function: there are abs sqrt exp log log10 sin cos asin min max";
  const char *near = p->names->nearest ? p->names->nearest(p->names->context, name, of) : NULL;
  if (!of && function_named(name) != FORMULA_NUMBER)
    return fail(p, start, "'%s' is no quantity but a function: '(' is missing after it", name);
  return fail(p, start, "'%s' is no %s%s%s%s", name, of ? no_function : "quantity known here",
              near ? ": did you mean '" : "", near ? near : "", near ? "'?" : "");
}

static bool read_all(struct parser *p);

/* Reads the text of a part instead of its name. */
static bool read_part(struct parser *p, const char *name, const char *text)
{
  const struct parser outside = *p;
  p->text = p->at = text;
  p->part = name;
  bool read = read_all(p);
  p->text = outside.text;
  p->part = outside.part;
  p->at = outside.at;
  return read;
}

static bool read_name(struct parser *p)
{
  const char *start = p->at;
  char name[FORMULA_NAME];
  size_t length = 0;
  while (is_in_name(start[length]))
    length++;
  if (length >= FORMULA_NAME)
    return fail(p, start, "a name of %zu characters: it may have %d", length, FORMULA_NAME - 1);
  memcpy(name, start, length);
  name[length] = '\0';
  p->at += length;
  enum formula_operation function = function_named(name);
  if (next(p) == '(')
    return function != FORMULA_NUMBER ? read_arguments(p, function, start) : fail_name(p, start, name, functions);
  int place = p->names->place(p->names->context, name);
  if (place >= 0)
    return add_step(p, start, (struct formula_step){ .operation = FORMULA_QUANTITY, .place = place });
  const char *text = p->names->part ? p->names->part(p->names->context, name) : NULL;
  if (text)
    return read_part(p, name, text);
  return strcmp(name, "pi") == 0 ? add(p, start, FORMULA_PI) : fail_name(p, start, name, NULL);
}

static bool read_value(struct parser *p)
{
  char c = next(p);
  const char *open = p->at;
  if (isdigit((unsigned char)c) || c == '.')
    return read_number(p);
  if (isalpha((unsigned char)c))
    return read_name(p);
  if (c != '(')
    return fail_here(p, "a number, a name or '(' is missing");
  p->at++;
  return read_sum(p) && read_close(p, open);
}

static bool read_factor(struct parser *p)
{
  bool is_negative = next(p) == '-';
  const char *sign = p->at;
  if (p->nested == FORMULA_NESTED)
    return fail(p, sign, "too much within one another: %d parentheses, minus signs and powers are allowed%s",
                FORMULA_NESTED, p->part ? "; does the part use itself?" : "");
  p->nested++;
  p->at += is_negative;
  bool read = is_negative ? read_factor(p) && add(p, sign, FORMULA_NEGATE) : read_value(p);
  if (read && !is_negative && next(p) == '^') {
    sign = p->at++;
    read = read_factor(p) && add(p, sign, FORMULA_POWER);
  }
  p->nested--;
  return read;
}

static bool read_product(struct parser *p)
{
  bool read = read_factor(p);
  for (char c; read && ((c = next(p)) == '*' || c == '/');) {
    const char *sign = p->at++;
    read = read_factor(p) && add(p, sign, c == '*' ? FORMULA_MULTIPLY : FORMULA_DIVIDE);
  }
  return read;
}

static bool read_sum(struct parser *p)
{
  bool read = read_product(p);
  for (char c; read && ((c = next(p)) == '+' || c == '-');) {
    const char *sign = p->at++;
    read = read_product(p) && add(p, sign, c == '+' ? FORMULA_ADD : FORMULA_SUBTRACT);
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

const char *formula_read(struct formula *formula, const char *text, const struct formula_names *names,
                         char message[FORMULA_MESSAGE])
{
  struct parser p = { .text = text, .at = text, .names = names, .message = message };
  if (!read_all(&p))
    return message;
  *formula = p.made;
  return NULL;
}

int formula_places(const struct formula *formula, int places[FORMULA_STEPS])
{
  int count = 0;
  for (const struct formula_step *s = formula->steps, *end = s + formula->count; s < end; s++) {
    int i = 0;
    if (s->operation != FORMULA_QUANTITY)
      continue;
    while (i < count && places[i] != s->place)
      i++;
    if (i == count)
      places[count++] = s->place;
  }
  return count;
}

const char *formula_refuse(char message[FORMULA_MESSAGE], const struct formula_step *step, const char *wrong)
{
  static const char in_names[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_.:";
  const char *at = step->text + step->at, *operation = formula_operation_text(step->operation);
  bool is_name = step->operation < FORMULA_NEGATE;
  snprintf(message, FORMULA_MESSAGE, "character %d: %.*s %s", step->at + 1,
           is_name ? (int)strspn(at, in_names) : FORMULA_NAME, is_name ? at : operation, wrong);
  return message;
}

static const double PI = 0x1.921fb54442d18p+1;

static double negate(double x) { return -x; }

static double (*const of_one[])(double) = {
  [FORMULA_NEGATE] = negate, [FORMULA_ABS] = fabs, [FORMULA_SQRT] = sqrt, [FORMULA_EXP] = exp,   [FORMULA_LOG] = log,
  [FORMULA_LOG10] = log10,   [FORMULA_SIN] = sin,  [FORMULA_COS] = cos,   [FORMULA_ASIN] = asin,
};

static double power(double base, double exponent)
{
  double size = fabs(exponent), product = 1;
  if (!(size <= FORMULA_PRODUCTS) || size != floor(size))
    return pow(base, exponent);
  for (int left = (int)size; left > 0; left /= 2) {
    if (left % 2 == 1)
      product *= base;
    base *= base;
  }
  return exponent < 0 ? 1 / product : product;
}

static double of_two(enum formula_operation operation, double a, double b)
{
  switch (operation) {
  case FORMULA_ADD: return a + b;
  case FORMULA_SUBTRACT: return a - b;
  case FORMULA_MULTIPLY: return a * b;
  case FORMULA_DIVIDE: return a / b;
  case FORMULA_POWER: return power(a, b);
  case FORMULA_MIN: return a < b || isnan(a) ? a : b;
  default: return a > b || isnan(a) ? a : b;
  }
}

double formula_double(const struct formula *formula, const double *values)
{
  double below[FORMULA_DEPTH + 1], *top = below, last = 0; /* the last value, and the values below it */
  for (const struct formula_step *s = formula->steps, *end = s + formula->count; s < end; s++) {
    if (s->operation < FORMULA_NEGATE) {
      *top++ = last;
      last = s->operation == FORMULA_NUMBER ? s->number : s->operation == FORMULA_PI ? PI : values[s->place];
    } else if (s->operation < FORMULA_ADD)
      last = of_one[s->operation](last);
    else {
      top--; /* formula_read ensures both operands: NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage) */
      last = of_two(s->operation, *top, last);
    }
  }
  return last;
}
