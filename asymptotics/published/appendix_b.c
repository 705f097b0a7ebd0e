/* The formulas of Appendix B, as printed: a contraction that begins with velocity v0 > 0. Positions
 * are counted from where the body (or the centre) was at the start. */
#include "asymptotics/published/terms.h"

double scallop_B_t1_unexpanded(point *p) { return p->v0 * mass(p) / (-p->m1 * p->l0 / (p->T * p->T) + p->F1 + p->F2); }

double scallop_B_t1(point *p)
{
  double T2 = p->T * p->T;
  return -p->v0 * mass(p) / (p->m1 * p->l0) * T2 * (1 + T2 * (p->F1 + p->F2) / (p->m1 * p->l0));
}

double scallop_B_x2_first_switch(point *p) { return p->v0 * p->t1 / 2; }

double scallop_B_dT_unexpanded(point *p)
{
  double a0 = p->l0 / (p->T * p->T), aT = p->lT / (p->T * p->T);
  double fraction = (p->m1 * a0 - p->F1 + p->F2) / (p->m1 * a0 - p->F1 - p->F2);
  return (p->v0 * mass(p) * fraction - (p->F1 - p->F2) * p->T) / (p->m1 * aT - p->F1 + p->F2);
}

double scallop_B_dT_product(point *p)
{
  double T2 = p->T * p->T, D = p->F1 - p->F2, kT = p->m1 * p->lT, k0 = p->m1 * p->l0;
  return -D / kT * cube(p->T) * (1 + T2 * D / kT)
         + T2 * p->v0 * mass(p) / kT * (1 + T2 * D / kT) * (1 - T2 * D / k0) * (1 + T2 * (p->F1 + p->F2) / k0);
}

double scallop_B_dT(point *p)
{
  double T2 = p->T * p->T, D = p->F1 - p->F2, kT = p->m1 * p->lT, k0 = p->m1 * p->l0;
  double leading = p->v0 * mass(p) / kT;
  return leading * T2 - D / kT * cube(p->T) + leading * (D / kT + 2 * p->F2 / k0) * (T2 * T2);
}

double scallop_B_x2_switch_from_times(point *p)
{
  double T = p->T, dT = p->dT, t1 = p->t1, mu = p->m1 / mass(p), a0 = p->l0 / (T * T), aT = p->lT / (T * T);
  double between = T - dT - t1;
  return -mu * p->l_start + 0.5 * mu * (dT * dT * aT - t1 * t1 * a0) - mu * t1 * a0 * between
         - 0.5 * drive(p) * (between * between) + p->v0 * t1 / 2;
}

double scallop_B_x2_switch_collected(point *p)
{
  double T = p->T, dT = p->dT, t1 = p->t1, mu = p->m1 / mass(p), a0 = p->l0 / (T * T), aT = p->lT / (T * T);
  return -mu * p->l_start - T * T * (0.5 * drive(p)) - t1 * T * (mu * a0 - drive(p)) + T * dT * drive(p)
         + dT * dT * (0.5 * mu * aT - 0.5 * drive(p)) + t1 * t1 * (mu * a0 - 0.5 * drive(p)) + t1 * dT * (mu * a0 - drive(p))
         + p->v0 * t1 / 2;
}

double scallop_B_x2_switch(point *p)
{
  double T = p->T;
  return -p->m1 / mass(p) * p->l_start + p->v0 * T - 0.5 * (drive(p) + p->v0 * p->v0 * mass(p) / (p->m1 * p->lT)) * (T * T)
         + p->v0 / p->m1 * ((p->F1 - p->F2) / p->lT + 2 * p->F2 / p->l0) * cube(T);
}

double scallop_B_v2_end_from_dT(point *p)
{
  return p->m1 / mass(p) * p->dT * p->lT / (p->T * p->T) - (p->F1 + p->F2) / mass(p) * p->dT;
}

double scallop_B_v2_end(point *p) { return p->v0 - drive(p) * p->T + p->v0 * (2 * p->F2 / p->m1) * (1 / p->l0 - 1 / p->lT); }

/* The position at T - Delta T is printed with a dot, x2'(T - Delta T), and that velocity is 0. */
double scallop_B_x2_end_from_dT(point *p) { return 0.5 * p->m1 / mass(p) * (p->dT * p->dT) * p->lT / (p->T * p->T); }

double scallop_B_x2_end(point *p)
{
  double T = p->T;
  return -p->m1 / mass(p) * p->l_start + p->v0 * T - 0.5 * drive(p) * (T * T)
         + p->v0 * 2 * p->F2 / (p->m1 * p->l0) * cube(T);
}

double scallop_B_vC_end(point *p) { return scallop_B_v2_end(p); }

double scallop_B_xC_end(point *p)
{
  double T = p->T;
  return -0.5 * (p->m1 - p->m2) / mass(p) * p->l_start + p->v0 * T - 0.5 * drive(p) * (T * T)
         + p->v0 * 2 * p->F2 / (p->m1 * p->l0) * cube(T);
}
