/* The operations of a formula on series in T. */
#include "asymptotics/derived/formula_flint.h"
#include "asymptotics/derived/scoped.h"

static const char *set_operand(struct series *value, const struct formula_step *s, const struct series *values)
{
  if (s->operation == FORMULA_QUANTITY && series_is_unknown(&values[s->place]))
    return "does not exist for this motion";
  if (s->operation == FORMULA_QUANTITY)
    series_set(value, &values[s->place]);
  else if (s->operation == FORMULA_PI)
    series_set_pi(value);
  else {
    SCOPED(fmpq, number);
    formula_number(number, s);
    series_set_rational(value, number);
  }
  return NULL;
}

static const char *set_negative(struct series *to, const struct series *a, const struct ring *ring)
{
  (void)ring;
  series_neg(to, a);
  return NULL;
}

static const char *(*const of_one[])(struct series *, const struct series *, const struct ring *) = {
  [FORMULA_NEGATE] = set_negative, [FORMULA_ABS] = series_abs, [FORMULA_SQRT] = series_sqrt,
  [FORMULA_EXP] = series_exp,      [FORMULA_LOG] = series_log, [FORMULA_LOG10] = series_log10,
  [FORMULA_SIN] = series_sin,      [FORMULA_COS] = series_cos, [FORMULA_ASIN] = series_asin,
};

/* a becomes a OPERATION b. NULL, or what a series cannot do */
static const char *of_two(struct series *a, const struct series *b, enum formula_operation operation,
                          const struct ring *ring)
{
  switch (operation) {
  case FORMULA_ADD: series_add(a, a, b, ring); return NULL;
  case FORMULA_SUBTRACT: series_sub(a, a, b, ring); return NULL;
  case FORMULA_MULTIPLY: series_mul(a, a, b, ring); return NULL;
  case FORMULA_DIVIDE: return series_div(a, a, b, ring) ? NULL : "divides by what may be 0";
  case FORMULA_POWER: return series_power(a, a, b, ring);
  case FORMULA_MIN: return series_min(a, a, b, ring);
  default: return series_max(a, a, b, ring);
  }
}

const char *formula_series(struct series *value, const struct formula *formula, const struct series *values,
                           const struct ring *ring, char message[FORMULA_MESSAGE])
{
  struct series stack[FORMULA_DEPTH], *top = stack; /* the last value is at top[-1] */
  const char *wrong = NULL;
  for (int i = 0; i < FORMULA_DEPTH; i++)
    series_init(&stack[i]);
  for (const struct formula_step *s = formula->steps, *end = s + formula->count; s < end && !wrong; s++) {
    if (s->operation < FORMULA_NEGATE)
      wrong = set_operand(top++, s, values);
    else if (s->operation < FORMULA_ADD)
      wrong = of_one[s->operation](&top[-1], &top[-1], ring);
    else {
      top--;
      wrong = of_two(&top[-1], &top[0], s->operation, ring);
    }
    if (wrong)
      formula_refuse(message, s, wrong);
  }
  if (!wrong)
    series_set(value, stack);
  for (int i = 0; i < FORMULA_DEPTH; i++)
    series_clear(&stack[i]);
  return wrong ? message : NULL;
}
