#include "compare/stress/periods.h"

#include <math.h>

enum { DIGITS = 60, BITS = 220 };

struct scallop_wide ball_middle(const arb_t x)
{
  struct scallop_wide w = { 0, 0 };
  SCOPED(arf, low);
  if (arb_contains_zero(x))
    return w;
  w.high = arf_get_d(arb_midref(x), ARF_RND_NEAR);
  arf_set_d(low, w.high);
  arf_sub(low, arb_midref(x), low, ARF_PREC_EXACT, ARF_RND_NEAR);
  if (isfinite(w.high))
    w.low = arf_get_d(low, ARF_RND_NEAR);
  return w;
}

static void set_end(struct answer *a, struct scallop_wide x, struct scallop_wide v)
{
  *a = (struct answer){ .status = SCALLOP_OK };
  for (int q = 0; q < ALL_QUANTITIES; q++)
    a->value[q].high = NAN;
  a->value[Q_DXC] = x;
  a->value[Q_V_END] = v;
}

static bool keep_last(void *context, const struct scallop_sample *sample)
{
  *(struct scallop_sample *)context = *sample;
  return true;
}

bool trajectory_in_double(const struct stress_case *s, struct answer *end)
{
  struct scallop_sample last = { .t = 0 };
  bool solved = scallop_trajectory(&s->motion.crawler, s->motion.v0, s->periods, 1, keep_last, &last) >= 0;
  set_end(end, (struct scallop_wide){ last.xC, 0 }, (struct scallop_wide){ last.v1, 0 });
  return solved;
}

static void middle_exact(fmpq_t middle, const arb_t x)
{
  if (arb_contains_zero(x))
    fmpq_zero(middle);
  else
    arf_get_fmpq(middle, arb_midref(x));
}

bool period_in_balls(struct ball_answer *first, struct ball_answer *second, arb_t displacement,
                     const struct scallop_rational_crawler *c, const fmpq_t v_start)
{
  SCOPED(fmpq, v_mid);
  if (!answer_in_balls(first, c, OF_PHASE, SCALLOP_EXTENSION, v_start, DIGITS))
    return false;
  middle_exact(v_mid, first->value[Q_V_END]);
  if (!answer_in_balls(second, c, OF_PHASE, SCALLOP_CONTRACTION, v_mid, DIGITS))
    return false;
  arb_add(displacement, first->value[Q_DXC], second->value[Q_DXC], BITS);
  first->modes[1] = second->modes[0];
  return true;
}

/* x_n, from D(v* - d), D(v*), D(v* + d), lambda and its power lambda^n */
static void sum_periods(arb_t x, const arb_t before, const arb_t steady, const arb_t after, const arb_t lambda,
                        const arb_t power, long n)
{
  SCOPED(arb, linear, bent, sum, ratio);
  arb_sub(linear, after, before, BITS); /* 2 B d */
  arb_add(bent, after, before, BITS);
  arb_submul_si(bent, steady, 2, BITS); /* 2 C d^2 */
  arb_sub_ui(sum, power, 1, BITS);
  arb_sub_ui(ratio, lambda, 1, BITS);
  arb_div(sum, sum, ratio, BITS);
  arb_mul_si(x, steady, 2 * n, BITS);
  arb_addmul(x, linear, sum, BITS);
  arb_add_ui(ratio, power, 1, BITS);
  arb_mul(sum, sum, ratio, BITS);
  arb_add_ui(ratio, lambda, 1, BITS);
  arb_div(sum, sum, ratio, BITS);
  arb_addmul(x, bent, sum, BITS);
  arb_mul_2exp_si(x, x, -1);
}

bool trajectory_in_balls(const struct stress_case *s, struct answer *end)
{
  SCOPED(scallop_rational, c);
  SCOPED(ball_answer, steady, plus, minus, rest);
  SCOPED(fmpq, v0, mirrored);
  SCOPED(arb, before, after, x, v, power);
  scallop_rational_of(&c, &s->motion.crawler);
  scallop_rational_set_double(v0, s->motion.v0);
  if (!answer_in_balls(&steady, &c, OF_STEADY, SCALLOP_EXTENSION, NULL, DIGITS))
    return false;
  const arb_struct *v_start = steady.value[Q_V_START], *lambda = steady.value[Q_MULTIPLIER];
  middle_exact(mirrored, v_start);
  fmpq_mul_2exp(mirrored, mirrored, 1);
  fmpq_sub(mirrored, mirrored, v0);
  if (!period_in_balls(&plus, &rest, after, &c, v0) || !period_in_balls(&minus, &rest, before, &c, mirrored)
      || !same_modes(plus.modes, minus.modes))
    return false;
  arb_pow_ui(power, lambda, (ulong)s->periods, BITS);
  sum_periods(x, before, steady.value[Q_DISPLACEMENT], after, lambda, power, s->periods);
  arb_set_fmpq(v, v0, BITS);
  arb_sub(v, v, v_start, BITS);
  arb_mul(v, v, power, BITS);
  arb_add(v, v, v_start, BITS);
  set_end(end, ball_middle(x), ball_middle(v));
  return true;
}
