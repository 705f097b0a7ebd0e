#include "compare/stress/periods.h"

#include <math.h>

enum { DIGITS = 60, BITS = 220 };

bool ball_period_solve(struct ball_period *p, const struct scallop_rational_crawler *c, const fmpq_t v_start,
                       long digits, const char **why)
{
  SCOPED(ball_answer, phase);
  arb_zero(p->displacement);
  for (int kind = SCALLOP_EXTENSION; kind <= SCALLOP_CONTRACTION; kind++) {
    bool first = kind == SCALLOP_EXTENSION;
    if (!answer_in_balls(&phase, c, OF_PHASE, (enum scallop_phase_kind)kind, first ? v_start : p->v_mid, digits)) {
      *why = phase.why ? phase.why : scallop_status_text(phase.status);
      return false;
    }
    arb_add(p->displacement, p->displacement, phase.value[Q_DXC], 4 * digits);
    arb_set(p->v_end, phase.value[Q_V_END]);
    p->modes[kind] = phase.modes[0];
    if (first)
      ball_middle_exact(p->v_mid, p->v_end);
  }
  return true;
}

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

void ball_middle_exact(fmpq_t middle, const arb_t x)
{
  if (arb_contains_zero(x))
    fmpq_zero(middle);
  else
    arf_get_fmpq(middle, arb_midref(x));
}

static bool keep_last(void *context, const struct scallop_sample *sample)
{
  *(struct scallop_sample *)context = *sample;
  return true;
}

bool trajectory_in_double(const struct stress_case *s, struct scallop_wide end[TRAJECTORY_ENDS])
{
  struct scallop_sample last = { .t = 0 };
  bool solved = scallop_trajectory(&s->crawler, s->v0, s->periods, 1, keep_last, &last) >= 0;
  end[END_X] = (struct scallop_wide){ last.xC, 0 };
  end[END_V] = (struct scallop_wide){ last.v1, 0 };
  return solved;
}

/* (1 - lambda^m)/(1 - lambda), and lambda^m */
static void geometric(arb_t sum, arb_t power, const arb_t lambda, ulong m)
{
  SCOPED(arb, below);
  arb_pow_ui(power, lambda, m, BITS);
  arb_sub_ui(sum, power, 1, BITS);
  arb_sub_ui(below, lambda, 1, BITS);
  arb_div(sum, sum, below, BITS);
}

/* Periods from v* - d, v*, v* + d */
enum { BEFORE, STEADY, AFTER, STARTS };

/* x_n and v_n; d = v0 - v* */
static void sum_periods(struct scallop_wide *end, const struct ball_period *p, const arb_t v, const arb_t d,
                        const arb_t lambda, long n)
{
  SCOPED(arb, linear, bent, sum, power, square);
  arb_sub(linear, p[AFTER].displacement, p[BEFORE].displacement, BITS); /* 2 B d */
  arb_mul_2exp_si(linear, linear, -1);
  arb_add(bent, p[AFTER].displacement, p[BEFORE].displacement, BITS); /* 2 D + 2 C d^2 */
  arb_mul_2exp_si(bent, bent, -1);
  arb_sub(bent, bent, p[STEADY].displacement, BITS);
  arb_mul(square, lambda, lambda, BITS);
  geometric(sum, power, square, (ulong)n);
  arb_mul(bent, bent, sum, BITS);
  geometric(sum, power, lambda, (ulong)n);
  arb_addmul(bent, linear, sum, BITS);
  arb_addmul_si(bent, p[STEADY].displacement, n, BITS);
  arb_set(sum, v);
  arb_addmul(sum, power, d, BITS);
  end[END_X] = ball_middle(bent);
  end[END_V] = ball_middle(sum);
}

/* v0 lies a distance d beyond v*, and as far before it is 2 v* - v0. */
static bool solve_periods(struct ball_period p[STARTS], const struct scallop_rational_crawler *c, const arb_t v_start,
                          const fmpq_t v0)
{
  const char *why;
  SCOPED(fmpq, v);
  ball_middle_exact(v, v_start);
  if (!ball_period_solve(&p[AFTER], c, v0, DIGITS, &why) || !ball_period_solve(&p[STEADY], c, v, DIGITS, &why))
    return false;
  fmpq_mul_2exp(v, v, 1);
  fmpq_sub(v, v, v0);
  return ball_period_solve(&p[BEFORE], c, v, DIGITS, &why) && same_modes(p[AFTER].modes, p[BEFORE].modes);
}

struct periods {
  struct ball_period from[STARTS];
};
#define PERIODS_PARTS(of) \
  of(ball_period, &s->from[BEFORE]) of(ball_period, &s->from[STEADY]) of(ball_period, &s->from[AFTER])
SCOPED_PARTS(periods, struct periods, PERIODS_PARTS)

bool trajectory_in_balls(const struct stress_case *s, struct scallop_wide end[TRAJECTORY_ENDS])
{
  SCOPED(scallop_rational, c);
  SCOPED(ball_answer, steady);
  SCOPED(periods, period);
  SCOPED(fmpq, v0);
  SCOPED(arb, d);
  scallop_rational_of(&c, &s->crawler);
  scallop_rational_set_double(v0, s->v0);
  if (!answer_in_balls(&steady, &c, OF_STEADY, SCALLOP_EXTENSION, NULL, DIGITS)
      || !solve_periods(period.from, &c, steady.value[Q_V_START], v0))
    return false;
  arb_set_d(d, s->v0);
  arb_sub(d, d, steady.value[Q_V_START], BITS);
  sum_periods(end, period.from, steady.value[Q_V_START], d, steady.value[Q_MULTIPLIER], s->periods);
  return true;
}
