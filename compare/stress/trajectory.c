/* Long trajectories for `stress`: millions of periods in double against a closed form in ball arithmetic.
 *
 * With v* the steady start velocity, lambda the multiplier and D(v) the displacement over a period from v, a motion that keeps its modes
 * obeys v_n - v* = lambda^n d exactly where l' is made of ramps, d = v_0 - v*, and D is then a quadratic polynomial. So
 *
 *     x_n = n D(v*) + B d (1 - lambda^n)/(1 - lambda) + C d^2 (1 - lambda^(2 n))/(1 - lambda^2),
 *
 * B and C from D(v* - d), D(v*) and D(v* + d). For other gaits that holds but for terms of order d^3 and, in v_n, d^2: d is then no more
 * than the rounding of v* to a double. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "numerics/numerics.h"
#include "compare/stress/stress.h"
#include "numerics/certified.h"

enum { DIGITS = 60, BITS = 220, PARAMETERS = 8 };

struct ending { /* of a trajectory */
  struct scallop_wide x, v;
};

static struct scallop_wide two_doubles(const arb_t y)
{
  arb_t rest;
  struct scallop_wide w = { arf_get_d(arb_midref(y), ARF_RND_NEAR), 0 };
  arb_init(rest);
  arb_set_d(rest, w.high);
  arb_sub(rest, y, rest, BITS);
  w.low = arf_get_d(arb_midref(rest), ARF_RND_NEAR);
  arb_clear(rest);
  return w;
}

static void nearest_rational(fmpq_t q, const arb_t y)
{
  fmpz_t mantissa, exponent;
  fmpz_init(mantissa);
  fmpz_init(exponent);
  arf_get_fmpz_2exp(mantissa, exponent, arb_midref(y));
  fmpq_set_fmpz(q, mantissa);
  if (fmpz_sgn(exponent) >= 0)
    fmpq_mul_2exp(q, q, fmpz_get_ui(exponent));
  else
    fmpq_div_2exp(q, q, (ulong)-fmpz_get_si(exponent));
  fmpz_clear(mantissa);
  fmpz_clear(exponent);
}

/* D(v), and the modes on the way. */
static bool displacement(arb_t d, char modes[2 * SCALLOP_MODES_TEXT], const struct scallop_rational_crawler *c,
                         const fmpq_t v)
{
  struct scallop_certified_phase phase;
  fmpq_t start;
  bool solved = true;
  scallop_certified_phase_init(&phase);
  fmpq_init(start);
  fmpq_set(start, v);
  arb_zero(d);
  memset(modes, 0, 2 * SCALLOP_MODES_TEXT);
  for (int kind = 0; solved && kind < 2; kind++) {
    solved = scallop_certified_phase(c, (enum scallop_phase_kind)kind, start, DIGITS, &phase, NULL) == SCALLOP_OK;
    if (!solved)
      break;
    arb_add(d, d, phase.dxC, BITS);
    nearest_rational(start, phase.v_end);
    scallop_modes_text(&phase.modes, modes + kind * SCALLOP_MODES_TEXT);
  }
  fmpq_clear(start);
  scallop_certified_phase_clear(&phase);
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

enum { BEFORE, STEADY, AFTER, SIDES };

/* x_n and v_n from D at v* - d, v*, v* + d. */
static void conclude(struct ending *end, arb_srcptr D, const arb_t v, const arb_t d, const arb_t lambda, long n)
{
  arb_ptr t = _arb_vec_init(5), linear = t, bent = t + 1, sum = t + 2, power = t + 3, square = t + 4;
  arb_sub(linear, D + AFTER, D + BEFORE, BITS); /* 2 B d */
  arb_mul_2exp_si(linear, linear, -1);
  arb_add(bent, D + AFTER, D + BEFORE, BITS); /* 2 D + 2 C d^2 */
  arb_mul_2exp_si(bent, bent, -1);
  arb_sub(bent, bent, D + STEADY, BITS);
  arb_mul(square, lambda, lambda, BITS);
  geometric(sum, power, square, (ulong)n);
  arb_mul(bent, bent, sum, BITS);
  geometric(sum, power, lambda, (ulong)n);
  arb_addmul(bent, linear, sum, BITS);
  arb_addmul_si(bent, D + STEADY, n, BITS);
  arb_set(sum, v);
  arb_addmul(sum, power, d, BITS);
  end->x = two_doubles(bent);
  end->v = two_doubles(sum);
  _arb_vec_clear(t, 5);
}

/* False: not certified, or the modes are not the same for all velocities on the way. */
static bool closed_form(const struct stress_case *s, struct ending *end)
{
  struct scallop_rational_crawler c;
  struct scallop_certified_steady steady;
  char modes[SIDES][2 * SCALLOP_MODES_TEXT];
  arb_ptr D = _arb_vec_init(SIDES + 1), d = D + SIDES;
  fmpq_t v, v0;
  scallop_rational_init(&c);
  scallop_certified_steady_init(&steady);
  fmpq_init(v);
  fmpq_init(v0);
  scallop_rational_of(&c, &s->crawler);
  scallop_rational_set_double(v0, s->v0);
  bool solved = scallop_certified_steady(&c, DIGITS, &steady, NULL) == SCALLOP_OK;
  if (solved) {
    arb_set_d(d, s->v0);
    arb_sub(d, d, steady.v_start, BITS);
    nearest_rational(v, steady.v_start);
    solved = displacement(D + AFTER, modes[AFTER], &c, v0) && displacement(D + STEADY, modes[STEADY], &c, v);
    fmpq_mul_2exp(v, v, 1);
    fmpq_sub(v, v, v0);
    solved = solved && displacement(D + BEFORE, modes[BEFORE], &c, v)
             && memcmp(modes[AFTER], modes[BEFORE], sizeof modes[AFTER]) == 0;
  }
  if (solved)
    conclude(end, D, steady.v_start, d, steady.multiplier, s->periods);
  fmpq_clear(v);
  fmpq_clear(v0);
  scallop_certified_steady_clear(&steady);
  scallop_rational_clear(&c);
  _arb_vec_clear(D, SIDES + 1);
  return solved;
}

static bool keep_last(void *context, const struct scallop_sample *sample)
{
  *(struct scallop_sample *)context = *sample;
  return true;
}

/* Adds to the unit what the double next to one parameter makes of the ending. */
static void disturb(const struct stress_case *s, int parameter, const struct ending *exact, struct stress_judgement *j)
{
  double most[2] = { 0, 0 };
  for (int side = -1; side <= 1; side += 2) {
    struct stress_case next;
    struct ending there;
    if (!stress_neighbour(s, parameter, side * INFINITY, 1, &next) || !closed_form(&next, &there))
      continue;
    most[0] = fmax(most[0], stress_difference(&there.x, &exact->x));
    most[1] = fmax(most[1], stress_difference(&there.v, &exact->v));
  }
  j->unit[0] += most[0];
  j->unit[1] += most[1];
}

void stress_judge_trajectory(const struct stress_case *s, struct stress_judgement *j)
{
  struct ending exact;
  struct scallop_sample last = { .t = 0 };
  *j = (struct stress_judgement){ .outcome = STRESS_SOLVED, .only_error = true };
  if (!closed_form(s, &exact)) {
    j->outcome = STRESS_REFUSED;
    j->why = "no closed form: the modes change on the way";
    return;
  }
  if (scallop_trajectory(&s->crawler, s->v0, s->periods, 1, keep_last, &last) < 0) {
    j->outcome = STRESS_LIED;
    j->why = "the trajectory was not solved";
    return;
  }
  for (int parameter = 0; parameter < PARAMETERS; parameter++)
    disturb(s, parameter, &exact, j);
  const double got[2] = { last.xC, last.v1 };
  const struct scallop_wide *const right[2] = { &exact.x, &exact.v };
  for (int q = 0; q < 2; q++) {
    const struct scallop_wide value = { got[q], 0 };
    j->has[q] = true;
    j->got[q] = got[q];
    j->exact[q] = right[q]->high;
    j->error[q] = stress_difference(&value, right[q]);
    j->ulp[q] = right[q]->high != 0 ? ldexp(1, ilogb(right[q]->high) - (DBL_MANT_DIG - 1)) : 0;
    j->unit[q] = fmax(j->unit[q], j->ulp[q]);
  }
}
