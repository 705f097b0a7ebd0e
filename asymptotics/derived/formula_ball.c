/* The operations of a formula in balls. */
#include "asymptotics/derived/formula_flint.h"

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
