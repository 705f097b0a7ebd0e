/* The formulas of Appendix A, as printed: an extension that begins with velocity v0 > 0. */
#include "asymptotics/published/terms.h"

double scallop_A_v1_first_switch(point *p)
{
  return -p->m2 / mass(p) * p->t1 * p->l0 / (p->T * p->T) - (p->F1 + p->F2) / mass(p) * p->t1 + p->v0;
}

double scallop_A_t1_unexpanded(point *p) { return p->v0 * mass(p) / (p->m2 * p->l0 / (p->T * p->T) + p->F1 + p->F2); }

double scallop_A_t1(point *p)
{
  double T2 = p->T * p->T;
  return p->v0 * mass(p) / (p->m2 * p->l0) * T2 * (1 - T2 * (p->F1 + p->F2) / (p->m2 * p->l0));
}

double scallop_A_x1_first_switch(point *p) { return p->v0 * p->t1 / 2; }

double scallop_A_v1_switch(point *p)
{
  double T2 = p->T * p->T, D = p->F1 - p->F2;
  return p->dT * (p->m2 * p->lT / T2 - D) + p->t1 * (p->m2 * p->l0 / T2 - D) + D * p->T;
}

double scallop_A_v1_switch_from_v0(point *p)
{
  double a0 = p->l0 / (p->T * p->T), aT = p->lT / (p->T * p->T), D = p->F1 - p->F2;
  return p->dT * (p->m2 * aT - D) + p->v0 * mass(p) * (p->m2 * a0 - p->F1 + p->F2) / (p->m2 * a0 + p->F1 + p->F2) + D * p->T;
}

double scallop_A_dT_unexpanded(point *p)
{
  double a0 = p->l0 / (p->T * p->T), aT = p->lT / (p->T * p->T);
  double fraction = (p->m2 * a0 - p->F1 + p->F2) / (p->m2 * a0 + p->F1 + p->F2);
  return -(p->v0 * mass(p) * fraction + (p->F1 - p->F2) * p->T) / (p->m2 * aT - p->F1 + p->F2);
}

double scallop_rest_dT_product(point *p)
{
  double D = p->F1 - p->F2, kT = p->m2 * p->lT;
  return -cube(p->T) * D / kT * (1 + p->T * p->T * D / kT);
}

double scallop_A_dT_product(point *p)
{
  double T2 = p->T * p->T, D = p->F1 - p->F2, kT = p->m2 * p->lT, k0 = p->m2 * p->l0;
  return -cube(p->T) * D / kT * (1 + T2 * D / kT)
         - T2 * p->v0 * mass(p) / kT * (1 + T2 * D / kT) * (1 - T2 * D / k0) * (1 - T2 * (p->F1 + p->F2) / k0);
}

double scallop_A_dT(point *p)
{
  double T2 = p->T * p->T, D = p->F1 - p->F2, kT = p->m2 * p->lT, k0 = p->m2 * p->l0;
  double leading = p->v0 * mass(p) / kT;
  return -leading * T2 - D / kT * cube(p->T) - leading * (D / kT - 2 * p->F1 / k0) * (T2 * T2);
}

double scallop_A_x1_switch_from_times(point *p)
{
  double T = p->T, dT = p->dT, t1 = p->t1, mu = p->m2 / mass(p), a0 = p->l0 / (T * T), aT = p->lT / (T * T);
  double between = T - dT - t1;
  return -mu * p->l_end - 0.5 * mu * (dT * dT * aT - t1 * t1 * a0) + mu * t1 * a0 * between
         + 0.5 * drive(p) * (between * between) + p->v0 * t1 / 2;
}

double scallop_A_x1_switch_collected(point *p)
{
  double T = p->T, dT = p->dT, t1 = p->t1, mu = p->m2 / mass(p), a0 = p->l0 / (T * T), aT = p->lT / (T * T);
  return -mu * p->l_end + T * T * (0.5 * drive(p)) + dT * dT * (-0.5 * mu * aT + 0.5 * drive(p))
         + t1 * t1 * (-0.5 * mu * a0 + 0.5 * drive(p)) - T * dT * drive(p) + t1 * T * (mu * a0 - drive(p))
         + t1 * dT * (-mu * a0 + drive(p)) + p->v0 * t1 / 2;
}

double scallop_A_x1_switch(point *p)
{
  double T = p->T;
  return -p->m2 / mass(p) * p->l_end + p->v0 * T + 0.5 * (drive(p) + p->v0 * p->v0 * mass(p) / (p->m2 * p->lT)) * (T * T)
         + p->v0 / p->m2 * ((p->F1 - p->F2) / p->lT - 2 * p->F1 / p->l0) * cube(T);
}

double scallop_A_v1_end_from_dT(point *p)
{
  return -p->dT * (p->m2 / mass(p) * p->lT / (p->T * p->T) + (p->F1 + p->F2) / mass(p));
}

double scallop_A_v1_end(point *p)
{
  return p->v0 + drive(p) * p->T - p->v0 * (2 * p->F1 / p->m2) * (1 / p->l0 - 1 / p->lT) * (p->T * p->T);
}

double scallop_A_x1_end_from_dT(point *p)
{
  return scallop_A_x1_end_from_dT_short(p) - 0.5 * (p->F1 + p->F2) / mass(p) * (p->dT * p->dT);
}

double scallop_A_x1_end_from_dT_short(point *p)
{
  return -0.5 * p->m2 / mass(p) * p->lT * (p->dT / p->T) * (p->dT / p->T) + p->x_switch;
}

double scallop_A_x1_end(point *p)
{
  double T = p->T;
  return -p->m2 / mass(p) * p->l_end + p->v0 * T + 0.5 * drive(p) * (T * T) + p->v0 * 2 * p->F1 / (p->m2 * p->l0) * cube(T);
}

double scallop_A_vC_end(point *p) { return scallop_A_v1_end(p); }

double scallop_A_xC_end(point *p)
{
  double T = p->T;
  return 0.5 * (p->m1 - p->m2) / mass(p) * p->l_end + p->v0 * T + 0.5 * drive(p) * (T * T)
         + p->v0 * 2 * p->F1 / (p->m2 * p->l0) * cube(T);
}
