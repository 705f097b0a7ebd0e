#include "compare/stress/trajectory.h"

#include "compare/stress/ball_period.h"

enum { DIGITS = 60, BITS = 220 };

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
  arb_t below;
  arb_init(below);
  arb_pow_ui(power, lambda, m, BITS);
  arb_sub_ui(sum, power, 1, BITS);
  arb_sub_ui(below, lambda, 1, BITS);
  arb_div(sum, sum, below, BITS);
  arb_clear(below);
}

/* Periods from v* - d, v*, v* + d */
enum { BEFORE, STEADY, AFTER, STARTS };

/* x_n and v_n; d = v0 - v* */
static void sum_periods(struct scallop_wide *end, const struct ball_period *p, const arb_t v, const arb_t d,
                        const arb_t lambda, long n)
{
  arb_ptr t = _arb_vec_init(5), linear = t, bent = t + 1, sum = t + 2, power = t + 3, square = t + 4;
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
  _arb_vec_clear(t, 5);
}

static bool solve_periods(struct ball_period p[STARTS], const struct scallop_rational_crawler *c, const arb_t v_start,
                          const fmpq_t v0)
{
  const char *why;
  fmpq_t v;
  fmpq_init(v);
  ball_middle_exact(v, v_start);
  bool solved = ball_period_solve(&p[AFTER], c, v0, DIGITS, &why) && ball_period_solve(&p[STEADY], c, v, DIGITS, &why);
  fmpq_mul_2exp(v, v, 1);
  fmpq_sub(v, v, v0);
  solved = solved && ball_period_solve(&p[BEFORE], c, v, DIGITS, &why) && same_modes(p[AFTER].modes, p[BEFORE].modes);
  fmpq_clear(v);
  return solved;
}

bool trajectory_in_balls(const struct stress_case *s, struct scallop_wide end[TRAJECTORY_ENDS])
{
  struct scallop_rational_crawler c;
  struct ball_answer steady;
  struct ball_period period[STARTS];
  fmpq_t v0;
  arb_t d;
  scallop_rational_init(&c);
  ball_answer_init(&steady);
  for (int i = 0; i < STARTS; i++)
    ball_period_init(&period[i]);
  fmpq_init(v0);
  arb_init(d);
  scallop_rational_of(&c, &s->crawler);
  scallop_rational_set_double(v0, s->v0);
  bool solved = answer_in_balls(&steady, &c, OF_STEADY, SCALLOP_EXTENSION, NULL, DIGITS)
                && solve_periods(period, &c, steady.value[Q_V_START], v0);
  if (solved) {
    arb_set_d(d, s->v0);
    arb_sub(d, d, steady.value[Q_V_START], BITS);
    sum_periods(end, period, steady.value[Q_V_START], d, steady.value[Q_MULTIPLIER], s->periods);
  }
  arb_clear(d);
  fmpq_clear(v0);
  for (int i = 0; i < STARTS; i++)
    ball_period_clear(&period[i]);
  ball_answer_clear(&steady);
  scallop_rational_clear(&c);
  return solved;
}
