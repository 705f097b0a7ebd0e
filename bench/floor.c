#include "bench/floor.h"

/* docs/background/solver.md, "The regular steady state": t1, dT and the velocities are linear in c_e, the velocity at
 * the start of the extension. Small letters: e extension, c contraction; in L/tau and tau of each phase. */
void floor_steady(const struct scallop_crawler *crawler, struct floor_result *result)
{
  double M = crawler->m1 + crawler->m2, F = crawler->F1 + crawler->F2, a = crawler->alpha, b = 1 - a;
  double steep_e = 4 * (crawler->m2 / M), steep_c = 4 * (crawler->m1 / M);
  double f1 = crawler->F1 / F, f2 = crawler->F2 / F, delta = (crawler->F1 - crawler->F2) / F;
  double eps = crawler->T * crawler->T * F / (M * crawler->L), eps_e = eps * a * a, eps_c = eps * b * b;
  double between_e = delta * eps_e, between_c = delta * eps_c;
  double t_e = 1 / (steep_e + eps_e), t_c = 1 / (steep_c + eps_c);
  double n_e = 1 / (steep_e + between_e), n_c = 1 / (steep_c - between_c);
  double u0_e = between_e * n_e, u1_e = (steep_e - between_e) * n_e * t_e;
  double u0_c = -between_c * n_c, u1_c = (steep_c + between_c) * n_c * t_c;
  double across = (steep_e - eps_e) * (b / a), f_e = f1 * a, f_c = f2 * b, turned = (t_c + u1_c) * across;
  double at_zero = 0.5 * delta * (a - b) - f_e * u0_e - f_c * (u0_c + turned * u0_e);
  double c_e = at_zero / (f_e * (t_e + u1_e) + f_c * turned * u1_e);
  double t1_e = t_e * c_e, dT_e = u0_e + u1_e * c_e, c_c = across * dT_e, t1_c = t_c * c_c, dT_c = u0_c + u1_c * c_c;
  double x_e = steep_e * t1_e, y_e = steep_e * dT_e, x_c = steep_c * t1_c, y_c = steep_c * dT_c;
  double travel_e = (c_e + x_e) * t1_e + (x_e + y_e) * (1 - t1_e - dT_e) + (2 * y_e - eps_e * dT_e) * dT_e;
  double travel_c = (c_c + x_c) * t1_c + (x_c + y_c) * (1 - t1_c - dT_c) + (2 * y_c - eps_c * dT_c) * dT_c;
  double unit = crawler->L / crawler->T;
  result->froude = 1 / eps;
  result->v_start = c_e / a * unit;
  result->v_mid = c_c / b * unit;
  result->displacement = 0.5 * (travel_e + travel_c) * crawler->L;
  result->mean_velocity = result->displacement / crawler->T;
  result->multiplier = (steep_e - eps_e) * u1_e * (steep_c - eps_c) * u1_c;
}
