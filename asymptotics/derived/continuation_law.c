/* The curves of a branch at complex times. */
#include "asymptotics/derived/continuation.h"
#include "asymptotics/derived/scoped.h"
#if __FLINT_RELEASE >= 30000
#include <flint/acb_hypgeom.h>
#else
#include <acb_hypgeom.h>
#endif

/* S(h) = sin(pi h)/(pi h) = g(y), y = -(pi h)^2/4, and S' = -(pi^2/2) h g', S'' = -(pi^2/2) (g' + 2 y g''): g is the
 * entire function 0F1(; 3/2; y), with derivatives (2/3) 0F1(; 5/2; y) and (4/15) 0F1(; 7/2; y). acb_poly_sinc_series
 * does not accept balls that contain 0. */
static void sine_quotient(acb_ptr S, const acb_t h, const arb_t pi_squared, slong precision)
{
  static const int factors[][2] = { { 1, 1 }, { 2, 3 }, { 4, 15 } };
  SCOPED(acb, y, a);
  acb_mul(y, h, h, precision);
  acb_mul_arb(y, y, pi_squared, precision);
  acb_mul_2exp_si(y, y, -2);
  acb_neg(y, y);
  for (int k = 0; k < 3; k++) {
    acb_set_d(a, k + 1.5);
    acb_hypgeom_0f1_direct(S + k, a, y, 0, precision);
    acb_mul_si(S + k, S + k, factors[k][0], precision);
    acb_div_si(S + k, S + k, factors[k][1], precision);
  }
  acb_mul_2exp_si(y, y, 1);
  acb_mul(S + 2, S + 2, y, precision);
  acb_add(S + 2, S + 2, S + 1, precision);
  acb_mul(S + 1, S + 1, h, precision);
  for (int k = 1; k < 3; k++) {
    acb_mul_arb(S + k, S + k, pi_squared, precision);
    acb_mul_2exp_si(S + k, S + k, -1);
    acb_neg(S + k, S + k);
  }
}

/* D = (sin(pi b) - sin(pi a))/(b - a) = C(m) S(h), C = pi cos(pi m), m = (a + b)/2, h = (b - a)/2: D_a = (D_m - D_h)/2,
 * D_b = (D_m + D_h)/2, D_aa = (D_mm - 2 D_mh + D_hh)/4, D_ab = (D_mm - D_hh)/4, D_bb = (D_mm + 2 D_mh + D_hh)/4 */
static void joined_sine(acb_ptr jet, const acb_t a, const acb_t b, slong precision)
{
  SCOPED_BALLS(S, 3);
  SCOPED_BALLS(C, 3);
  SCOPED(acb, m, h, even, mixed);
  SCOPED(arb, pi, square);
  arb_const_pi(pi, precision);
  arb_mul(square, pi, pi, precision);
  acb_add(m, a, b, precision);
  acb_sub(h, b, a, precision);
  acb_mul_2exp_si(m, m, -1);
  acb_mul_2exp_si(h, h, -1);
  sine_quotient(S, h, square, precision);
  acb_sin_cos_pi(C + 1, C, m, precision);
  acb_mul_arb(C, C, pi, precision);
  acb_mul_arb(C + 1, C + 1, square, precision);
  acb_neg(C + 1, C + 1);
  acb_mul_arb(C + 2, C, square, precision);
  acb_neg(C + 2, C + 2);
  acb_mul(jet + JET_VALUE, C, S, precision);
  acb_mul(m, C + 1, S, precision); /* D_m, D_h and, instead of jets, D_mm and D_hh */
  acb_mul(h, C, S + 1, precision);
  acb_mul(jet + JET_AA, C + 2, S, precision);
  acb_mul(jet + JET_BB, C, S + 2, precision);
  acb_sub(jet + JET_A, m, h, precision);
  acb_add(jet + JET_B, m, h, precision);
  acb_add(even, jet + JET_AA, jet + JET_BB, precision);
  acb_sub(jet + JET_AB, jet + JET_AA, jet + JET_BB, precision);
  acb_mul(mixed, C + 1, S + 1, precision);
  acb_mul_2exp_si(mixed, mixed, 1);
  acb_sub(jet + JET_AA, even, mixed, precision);
  acb_add(jet + JET_BB, even, mixed, precision);
  for (int k = JET_A; k < JET; k++)
    acb_mul_2exp_si(jet + k, jet + k, k < JET_AA ? -1 : -2);
}

static void lone_sine(acb_ptr jet, const acb_t b, slong precision)
{
  SCOPED(arb, pi);
  arb_const_pi(pi, precision);
  acb_sin_cos_pi(jet + JET_VALUE, jet + JET_B, b, precision);
  acb_mul_arb(jet + JET_B, jet + JET_B, pi, precision);
  arb_mul(pi, pi, pi, precision);
  acb_mul_arb(jet + JET_BB, jet + JET_VALUE, pi, precision);
  acb_neg(jet + JET_BB, jet + JET_BB);
}

/* Replaces d by a d + f. */
static void step(acb_t d, const acb_t f, const acb_t a, slong precision)
{
  acb_mul(d, d, a, precision);
  acb_add(d, d, f, precision);
}

/* Horner's rule for the law at b, f = c + b f, and for its divided difference, d = f + a d, with their derivatives. */
static void polynomial(acb_ptr jet, const struct continued_crossing *at, const acb_t a, const acb_t b, slong precision)
{
  acb_ptr d = jet;
  SCOPED_BALLS(f, 3);
  for (slong k = arb_poly_degree(at->law); k >= 0; k--) {
    if (at->joined) { /* d = f + a d, by decreasing derivatives */
      acb_mul(d + JET_AA, d + JET_AA, a, precision);
      acb_addmul_ui(d + JET_AA, d + JET_A, 2, precision);
      step(d + JET_AB, d + JET_B, a, precision);
      step(d + JET_BB, f + 2, a, precision);
      step(d + JET_A, d + JET_VALUE, a, precision);
      step(d + JET_B, f + 1, a, precision);
      step(d + JET_VALUE, f, a, precision);
    }
    for (slong j = 2; j >= 0; j--) {
      acb_mul(f + j, f + j, b, precision);
      if (j > 0)
        acb_addmul_ui(f + j, f + j - 1, (ulong)j, precision);
    }
    acb_add_arb(f, f, arb_poly_get_coeff_ptr(at->law, k), precision);
  }
  if (!at->joined) {
    acb_swap(jet + JET_VALUE, f);
    acb_swap(jet + JET_B, f + 1);
    acb_swap(jet + JET_BB, f + 2);
  }
}

void continued_law(acb_ptr jet, const struct continued_crossing *at, const acb_t a, const acb_t b, slong precision)
{
  SCOPED(arb, factor);
  _acb_vec_zero(jet, JET);
  if (at->sine) { /* (pi/2) sin(pi s) */
    arb_const_pi(factor, precision);
    arb_mul_2exp_si(factor, factor, -1);
    arb_mul(factor, factor, at->q, precision);
    if (at->joined)
      joined_sine(jet, a, b, precision);
    else
      lone_sine(jet, b, precision);
  } else {
    SCOPED(acb, x, y);
    acb_sub_arb(x, a, at->base, precision);
    acb_sub_arb(y, b, at->base, precision);
    polynomial(jet, at, x, y, precision);
    arb_set(factor, at->q);
  }
  _acb_vec_scalar_mul_arb(jet, jet, JET, factor, precision);
}
