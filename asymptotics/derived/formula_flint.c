/* The operations of a formula in balls, and on series in T. */
#include "asymptotics/derived/formula_flint.h"

#include <stdlib.h>
#include <string.h>

#include "asymptotics/derived/scoped.h"
#include "model/exact/ball.h"

static void set_log10(arb_t value, const arb_t x, slong precision) { arb_log_base_ui(value, x, 10, precision); }
static void set_negative(arb_t value, const arb_t x, slong precision)
{
  (void)precision;
  arb_neg(value, x);
}
static void set_size(arb_t value, const arb_t x, slong precision)
{
  (void)precision;
  arb_abs(value, x);
}

static void (*const of_one[])(arb_t, const arb_t, slong) = {
  [FORMULA_NEGATE] = set_negative, [FORMULA_ABS] = set_size, [FORMULA_SQRT] = arb_sqrt,
  [FORMULA_EXP] = arb_exp,         [FORMULA_LOG] = arb_log,  [FORMULA_LOG10] = set_log10,
  [FORMULA_SIN] = arb_sin,         [FORMULA_COS] = arb_cos,  [FORMULA_ASIN] = arb_asin,
};
static void (*const of_two[])(arb_t, const arb_t, const arb_t, slong) = {
  [FORMULA_ADD] = arb_add,   [FORMULA_SUBTRACT] = arb_sub, [FORMULA_MULTIPLY] = arb_mul, [FORMULA_DIVIDE] = arb_div,
  [FORMULA_POWER] = arb_pow, [FORMULA_MIN] = arb_min,      [FORMULA_MAX] = arb_max,
};

void formula_number(fmpq_t number, const struct formula_step *step)
{
  char text[FORMULA_DIGITS];
  memcpy(text, step->text + step->at, (size_t)step->length);
  text[step->length] = '\0';
  if (step->number == 0 || !scallop_rational_parse(number, text)) /* 0, with an exponent that is too large */
    fmpq_zero(number);
}

static void set_operand(arb_t value, const struct formula_step *s, arb_srcptr values, slong precision)
{
  if (s->operation == FORMULA_QUANTITY)
    arb_set(value, values + s->place);
  else if (s->operation == FORMULA_PI)
    arb_const_pi(value, precision);
  else {
    SCOPED(fmpq, number);
    formula_number(number, s);
    arb_set_fmpq(value, number, precision);
  }
}

void formula_ball(arb_t value, const struct formula *formula, arb_srcptr values, slong precision)
{
  arb_ptr stack = _arb_vec_init(FORMULA_DEPTH), top = stack; /* the last value is at top - 1 */
  for (const struct formula_step *s = formula->steps, *end = s + formula->count; s < end; s++) {
    if (s->operation < FORMULA_NEGATE)
      set_operand(top++, s, values, precision);
    else if (s->operation < FORMULA_ADD)
      of_one[s->operation](top - 1, top - 1, precision);
    else {
      top--;
      of_two[s->operation](top - 1, top - 1, top, precision);
    }
  }
  arb_set(value, top - 1);
  _arb_vec_clear(stack, FORMULA_DEPTH);
}

static const char *put_operand(struct series *value, const struct formula_step *s, const struct series *values,
                               struct names *names)
{
  if (s->operation == FORMULA_QUANTITY && series_is_unknown(&values[s->place]))
    return "does not exist for this motion";
  if (s->operation == FORMULA_PI && names && names->pi < 0)
    return "is no rational number";
  if (s->operation == FORMULA_QUANTITY)
    series_set(value, &values[s->place]);
  else if (s->operation == FORMULA_PI)
    series_set_pi(value, names);
  else {
    SCOPED(fmpq, number);
    formula_number(number, s);
    series_set_rational(value, number);
  }
  return NULL;
}

static const char *put_negative(struct series *to, const struct series *a, const struct ring *ring)
{
  (void)ring;
  series_neg(to, a);
  return NULL;
}

static const char no_series[] = "has no series in T";

/* Functions of one operand; NULL: see no_series. */
static const char *(*const series_of_one[FORMULA_ADD])(struct series *, const struct series *, const struct ring *) = {
  [FORMULA_NEGATE] = put_negative, [FORMULA_SQRT] = series_sqrt, [FORMULA_EXP] = series_exp,
  [FORMULA_LOG] = series_log,      [FORMULA_SIN] = series_sin,   [FORMULA_COS] = series_cos,
};

/* Computes a = a OPERATION b. Returns NULL, or the reason of a refusal. */
static const char *series_of_two(struct series *a, const struct series *b, enum formula_operation operation,
                                 const struct ring *ring)
{
  switch (operation) {
  case FORMULA_ADD: series_add(a, a, b, ring); return NULL;
  case FORMULA_SUBTRACT: series_sub(a, a, b, ring); return NULL;
  case FORMULA_MULTIPLY: series_mul(a, a, b, ring); return NULL;
  case FORMULA_DIVIDE: return series_div(a, a, b, ring) ? NULL : "divides by what may be 0";
  case FORMULA_POWER: return series_power(a, a, b, ring);
  default: return no_series;
  }
}

enum { MOST_TERMS = 200, MOST_DEGREE = 2000, MOST_BITS = 20000, MOST_TERMS_OF_A_STEP = 100000 };

static bool is_short(const fmpz_mpoly_t p, const fmpz_mpoly_ctx_t ring)
{
  return fmpz_mpoly_length(p, ring) <= MOST_TERMS && labs(fmpz_mpoly_max_bits(p)) <= MOST_BITS
         && fmpz_mpoly_total_degree_fits_si(p, ring) && fmpz_mpoly_total_degree_si(p, ring) <= MOST_DEGREE;
}

/* Returns true if values of names are small enough for a fast result. */
static bool is_small(const struct series *s, const struct names *names)
{
  bool small = labs(s->first) <= SERIES_FARTHEST && !names_given_up(names)
               && (s->kind != SERIES_FRACTIONS || series_bits(s) <= MOST_BITS);
  for (slong k = 0; s->kind == SERIES_NAMED && k < s->named.length && small; k++)
    small = is_short(s->named.coeffs[k].over, names->ring) && is_short(s->named.coeffs[k].under, names->ring);
  return small;
}

/* Returns true if the series is an integer to which names can be raised. */
static bool is_whole_power(const struct series *s)
{
  SCOPED(fmpq, power);
  return s->known >= SERIES_ALL && s->first >= 0 && s->first + series_terms(s) <= 1
         && series_rational_coefficient(power, s, 0) && fmpz_is_one(fmpq_denref(power))
         && fmpz_cmpabs(fmpq_numref(power), (fmpz[]){ SERIES_EXACT_POWER }) <= 0;
}

/* Returns the reason why the result of an operation on names is not a rational function; top: after the last value. */
static const char *why_not_rational(enum formula_operation operation, const struct series *top)
{
  if (operation == FORMULA_POWER)
    return is_whole_power(top - 1) ? NULL : "is a formula for whole powers from -64 to 64 only";
  bool is_function = (operation > FORMULA_NEGATE && operation < FORMULA_ADD) || operation > FORMULA_POWER;
  return is_function ? "is no rational function" : NULL;
}

/* Replaces the operands of a step on the stack by its result. Returns NULL, or the reason of a refusal. */
static const char *take_step(struct series **top, const struct formula_step *s, const struct series *values,
                             struct names *names, const struct ring *ring)
{
  const enum formula_operation operation = s->operation;
  const char *wrong = names ? why_not_rational(operation, *top) : NULL;
  if (wrong)
    return wrong;
  if (operation < FORMULA_NEGATE)
    return put_operand((*top)++, s, values, names);
  struct series *last = *top - 1;
  if (operation < FORMULA_ADD)
    return series_of_one[operation] ? series_of_one[operation](last, last, ring) : no_series;
  *top = last;
  return series_of_two(last - 1, last, operation, ring);
}

const char *formula_series(struct series *value, const struct formula *formula, const struct series *values,
                           struct names *names, const struct ring *ring, char message[FORMULA_MESSAGE])
{
  struct series stack[FORMULA_DEPTH], *top = stack; /* the last value is at top[-1] */
  const char *wrong = NULL;
  for (int i = 0; i < FORMULA_DEPTH; i++)
    series_init(&stack[i]);
  for (const struct formula_step *s = formula->steps, *end = s + formula->count; s < end && !wrong; s++) {
    if (names) {
      names->terms = 0;
      names->most_terms = MOST_TERMS_OF_A_STEP;
    }
    wrong = take_step(&top, s, values, names, ring);
    if (!wrong && names && !is_small(top - 1, names))
      wrong = "grows beyond 200 terms, degree 2000 or 20000 bits";
    if (wrong)
      formula_refuse(message, s, wrong);
  }
  if (names)
    names->most_terms = 0;
  if (!wrong)
    series_set(value, stack);
  for (int i = 0; i < FORMULA_DEPTH; i++)
    series_clear(&stack[i]);
  return wrong ? message : NULL;
}
