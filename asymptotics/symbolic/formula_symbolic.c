/* The operations of a formula on series with rational functions as coefficients. */
#include "asymptotics/symbolic/formula_symbolic.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/derived/formula_flint.h"
#include "asymptotics/derived/scoped.h"

enum { MOST_TERMS = 200, MOST_DEGREE = 2000, MOST_BITS = 20000, MOST_POWER = 64, MOST_FIRST = 4096 };

static slong smaller(slong a, slong b) { return a < b ? a : b; }

/* Takes zeros off the front. */
static void strip(struct symbolic_laurent *a, const struct symbols *s)
{
  slong zeros = 0;
  while (zeros < a->count && symbolic_is_zero(a->term[zeros], s))
    zeros++;
  a->first += zeros;
  a->count -= zeros;
  for (slong k = 0; k < a->count; k++)
    a->term[k] = a->term[k + zeros];
}

struct symbolic_laurent symbolic_laurent_of(struct symbols *s, const struct symbolic_series *series, slong first)
{
  struct symbolic_laurent value = { .first = first, .count = series->length };
  for (slong k = 0; k < series->length; k++)
    value.term[k] = series->term[k];
  strip(&value, s);
  return value;
}

struct symbolic_laurent symbolic_laurent_set(struct symbols *s, symbolic value, slong power)
{
  const struct symbolic_series series = symbolic_series_set(s, value, 0, SYMBOLIC_TERMS);
  return symbolic_laurent_of(s, &series, power);
}

symbolic symbolic_laurent_term(struct symbols *s, const struct symbolic_laurent *a, slong power)
{
  slong k = power - a->first;
  return k < 0 ? symbolic_number(s, 0, 1) : k < a->count ? a->term[k] : NULL;
}

static struct symbolic_laurent sum(struct symbols *s, const struct symbolic_laurent *a,
                                   const struct symbolic_laurent *b, bool sub)
{
  struct symbolic_laurent value = { .first = smaller(a->first, b->first) };
  slong known = smaller(smaller(a->first + a->count, b->first + b->count), value.first + SYMBOLIC_TERMS);
  for (slong power = value.first; power < known; power++)
    value.term[value.count++] = (sub ? symbolic_sub : symbolic_add)(s, symbolic_laurent_term(s, a, power),
                                                                    symbolic_laurent_term(s, b, power));
  strip(&value, s);
  return value;
}

struct symbolic_laurent symbolic_laurent_sub(struct symbols *s, const struct symbolic_laurent *a,
                                             const struct symbolic_laurent *b)
{
  return sum(s, a, b, true);
}

static struct symbolic_series terms_of(const struct symbolic_laurent *a, slong length)
{
  struct symbolic_series series = { .length = length };
  for (slong k = 0; k < length; k++)
    series.term[k] = a->term[k];
  return series;
}

typedef struct symbolic_series combine(struct symbols *s, const struct symbolic_series *a,
                                       const struct symbolic_series *b, slong length);

/* A product, or a quotient whose divisor is not 0 */
static struct symbolic_laurent combined(struct symbols *s, const struct symbolic_laurent *a,
                                        const struct symbolic_laurent *b, combine *of_series, slong first)
{
  slong length = smaller(a->count, b->count);
  if (length == 0)
    return (struct symbolic_laurent){ .first = first };
  const struct symbolic_series left = terms_of(a, length), right = terms_of(b, length);
  const struct symbolic_series series = of_series(s, &left, &right, length);
  return symbolic_laurent_of(s, &series, first);
}

static struct symbolic_laurent product(struct symbols *s, const struct symbolic_laurent *a,
                                       const struct symbolic_laurent *b)
{
  return combined(s, a, b, symbolic_series_mul, a->first + b->first);
}

static bool is_short(const fmpz_mpoly_t a, const struct symbols *s)
{
  slong bits = fmpz_mpoly_max_bits(a);
  return fmpz_mpoly_length(a, s->ring) <= MOST_TERMS && labs(bits) <= MOST_BITS
         && fmpz_mpoly_total_degree_fits_si(a, s->ring) && fmpz_mpoly_total_degree_si(a, s->ring) <= MOST_DEGREE;
}

static bool is_small(const struct symbolic_laurent *a, const struct symbols *s)
{
  bool small = labs(a->first) <= MOST_FIRST;
  for (slong k = 0; k < a->count && small; k++)
    small = is_short(a->term[k]->over, s) && is_short(a->term[k]->under, s);
  return small;
}

static const char too_large[] = "grows beyond 200 terms, degree 2000 or 20000 bits",
                  no_function[] = "is no rational function";

static const char *divide(struct symbolic_laurent *a, const struct symbolic_laurent *b, struct symbols *s)
{
  if (b->count == 0)
    return "divides by what is 0";
  *a = combined(s, a, b, symbolic_series_div, a->first - b->first);
  return NULL;
}

/* Is it a whole number from -MOST_POWER to MOST_POWER? */
static bool is_whole(slong *whole, const struct symbolic_laurent *b, struct symbols *s)
{
  SCOPED(fmpz, number);
  bool is_constant = b->first + b->count >= SYMBOLIC_TERMS && (b->count == 0 || b->first == 0);
  for (slong k = 1; k < b->count && is_constant; k++)
    is_constant = symbolic_is_zero(b->term[k], s);
  if (is_constant && b->count > 0) {
    is_constant = fmpz_mpoly_is_one(b->term[0]->under, s->ring) && fmpz_mpoly_is_fmpz(b->term[0]->over, s->ring);
    if (is_constant)
      fmpz_mpoly_get_fmpz(number, b->term[0]->over, s->ring);
  }
  bool is = is_constant && fmpz_cmpabs(number, (fmpz[]){ MOST_POWER }) <= 0;
  *whole = is ? fmpz_get_si(number) : 0;
  return is;
}

static const char *raise_to(struct symbolic_laurent *a, const struct symbolic_laurent *b, struct symbols *s)
{
  struct symbolic_laurent base = *a;
  slong n;
  if (!is_whole(&n, b, s))
    return "is a formula for whole powers from -64 to 64 only";
  *a = symbolic_laurent_set(s, symbolic_number(s, 1, 1), 0);
  for (slong i = labs(n); i > 0; i--) {
    *a = product(s, a, &base);
    if (!is_small(a, s))
      return too_large;
  }
  const struct symbolic_laurent raised = *a;
  if (n < 0)
    *a = symbolic_laurent_set(s, symbolic_number(s, 1, 1), 0);
  return n < 0 ? divide(a, &raised, s) : NULL;
}

/* a becomes a OPERATION b. NULL, or what cannot be done */
static const char *of_two(struct symbolic_laurent *a, const struct symbolic_laurent *b,
                          enum formula_operation operation, struct symbols *s)
{
  switch (operation) {
  case FORMULA_ADD: *a = sum(s, a, b, false); return NULL;
  case FORMULA_SUBTRACT: *a = sum(s, a, b, true); return NULL;
  case FORMULA_MULTIPLY: *a = product(s, a, b); return NULL;
  case FORMULA_DIVIDE: return divide(a, b, s);
  case FORMULA_POWER: return raise_to(a, b, s);
  default: return no_function;
  }
}

static const char *set_operand(struct symbolic_laurent *value, const struct formula_step *step,
                               const struct symbolic_laurent *const *values, struct symbols *s)
{
  if (step->operation == FORMULA_PI) {
    if (symbols_place(s, NAMED_pi, 0, SCALLOP_EXTENSION) < 0)
      return "is no rational number";
    *value = symbolic_laurent_set(s, symbolic_named(s, NAMED_pi), 0);
    return NULL;
  }
  if (step->operation == FORMULA_QUANTITY) {
    if (!values[step->place])
      return "is not known as a formula here";
    *value = *values[step->place];
    return NULL;
  }
  SCOPED(fmpq, number);
  formula_number(number, step);
  *value = symbolic_laurent_set(s, symbolic_fraction(s, number), 0);
  return NULL;
}

const char *formula_symbolic(struct symbolic_laurent *value, const struct formula *formula,
                             const struct symbolic_laurent *const *values, struct symbols *s,
                             char message[FORMULA_MESSAGE])
{
  struct symbolic_laurent *stack = flint_calloc(FORMULA_DEPTH, sizeof *stack), *top = stack, zero;
  const char *wrong = NULL;
  for (const struct formula_step *step = formula->steps; step < formula->steps + formula->count && !wrong; step++) {
    if (step->operation < FORMULA_NEGATE)
      wrong = set_operand(top++, step, values, s);
    else if (step->operation == FORMULA_NEGATE) {
      zero = symbolic_laurent_set(s, symbolic_number(s, 0, 1), top[-1].first);
      top[-1] = sum(s, &zero, &top[-1], true);
    } else if (step->operation < FORMULA_ADD)
      wrong = no_function;
    else {
      top--;
      wrong = of_two(&top[-1], &top[0], step->operation, s);
    }
    if (!wrong && !is_small(&top[-1], s))
      wrong = too_large;
    if (wrong)
      formula_refuse(message, step, wrong);
  }
  if (!wrong)
    *value = stack[0];
  flint_free(stack);
  return wrong ? message : NULL;
}
