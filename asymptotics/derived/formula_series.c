/* The operations of a formula on series in T. */
#include "asymptotics/derived/formula_flint.h"

#include <stdio.h>
#include <stdlib.h>

static const char *refuse(char message[FORMULA_MESSAGE], const struct formula_step *s, const char *what)
{
  snprintf(message, FORMULA_MESSAGE, "character %d: %s %s", s->at + 1, formula_operation_text(s->operation), what);
  return message;
}

static void set_operand(struct series *value, const struct formula_step *s, const struct series *values,
                        const struct ring *ring)
{
  if (s->operation == FORMULA_QUANTITY)
    series_set(value, &values[s->place]);
  else if (s->operation == FORMULA_PI) {
    arb_t pi;
    arb_init(pi);
    arb_const_pi(pi, ring->precision);
    series_set_ball(value, pi);
    arb_clear(pi);
  } else {
    fmpq_t number;
    fmpq_init(number);
    formula_number(number, s);
    series_set_rational(value, number);
    fmpq_clear(number);
  }
}

/* Is it an exact constant, whole and at most FORMULA_SERIES_POWER in size? */
static bool get_power(long *power, const struct series *s)
{
  bool is_constant = s->exact && s->known >= SERIES_ALL;
  for (slong i = s->first; is_constant && i < s->first + fmpq_poly_length(s->rational); i++)
    is_constant = i == 0 || series_coefficient_is_zero(s, i);
  fmpq_t value;
  fmpq_init(value);
  bool got = is_constant && series_rational_coefficient(value, s, 0) && fmpz_is_one(fmpq_denref(value))
             && fmpz_bits(fmpq_numref(value)) < 8 && labs(fmpz_get_si(fmpq_numref(value))) <= FORMULA_SERIES_POWER;
  *power = got ? fmpz_get_si(fmpq_numref(value)) : 0;
  fmpq_clear(value);
  return got;
}

/* Bits of the largest exact coefficient; balls have as many as the ring */
static slong bits_of(const struct series *s)
{
  const fmpq_poly_struct *p = s->rational;
  slong bits = s->exact ? _fmpz_vec_max_bits(p->coeffs, p->length) : 0;
  return s->exact ? labs(bits) + (slong)fmpz_bits(fmpq_poly_denref(p)) : 0;
}

/* value becomes value^exponent */
static const char *set_power(struct series *value, const struct series *exponent, const struct formula_step *s,
                             const struct ring *ring, char message[FORMULA_MESSAGE])
{
  long power;
  if (!get_power(&power, exponent))
    return refuse(message, s, "takes a whole number from -64 to 64 as the power of a series");
  if (bits_of(value) * labs(power) > FORMULA_SERIES_BITS)
    return refuse(message, s, "makes a number of more than 300000 digits");
  struct series base, one;
  series_init(&base);
  series_init(&one);
  series_set(&base, value);
  series_set_si(&one, 1);
  series_set_si(value, 1);
  for (long i = 0; i < labs(power); i++)
    series_mul(value, value, &base, ring);
  bool raised = power >= 0 || series_div(value, &one, value, ring);
  series_clear(&base);
  series_clear(&one);
  return raised ? NULL : refuse(message, s, "divides by what may be 0");
}

/* a becomes a OPERATION b. NULL, or the message */
static const char *of_two(struct series *a, const struct series *b, const struct formula_step *s, const struct ring *ring,
                          char message[FORMULA_MESSAGE])
{
  switch (s->operation) {
  case FORMULA_ADD: series_add(a, a, b, ring); return NULL;
  case FORMULA_SUBTRACT: series_sub(a, a, b, ring); return NULL;
  case FORMULA_MULTIPLY: series_mul(a, a, b, ring); return NULL;
  case FORMULA_DIVIDE: return series_div(a, a, b, ring) ? NULL : refuse(message, s, "divides by what may be 0");
  case FORMULA_POWER: return set_power(a, b, s, ring, message);
  default: return refuse(message, s, "of a series is not known");
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
      set_operand(top++, s, values, ring);
    else if (s->operation == FORMULA_NEGATE)
      series_neg(&top[-1], &top[-1]);
    else if (s->operation < FORMULA_ADD)
      wrong = refuse(message, s, "of a series is not known");
    else {
      top--;
      wrong = of_two(&top[-1], &top[0], s, ring, message);
    }
  }
  if (!wrong)
    series_set(value, stack);
  for (int i = 0; i < FORMULA_DEPTH; i++)
    series_clear(&stack[i]);
  return wrong;
}
