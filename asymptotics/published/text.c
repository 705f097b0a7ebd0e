/* The formulas of the main text, as printed. */
#include "asymptotics/published/terms.h"

typedef const struct scallop_crawler crawler;

double scallop_equal_v1_end(point *p)
{
  const double speed = 0; /* l'(T) */
  return -p->m2 / mass(p) * speed;
}

double scallop_equal_x1_end(point *p) { return -p->m2 / mass(p) * (p->l_end - p->l_start); }

double scallop_equal_xC_end(point *p) { return 0.5 * (p->m1 / p->m2 - 1) * scallop_equal_x1_end(p); }

double scallop_rest_v1_switch(point *p)
{
  return p->dT * (p->m2 * p->lT / (p->T * p->T) - p->F1 + p->F2) + (p->F1 - p->F2) * p->T;
}

double scallop_rest_dT_unexpanded(point *p)
{
  return -(p->F1 - p->F2) / (p->m2 * p->lT / (p->T * p->T) - p->F1 + p->F2) * p->T;
}

double scallop_rest_dT(point *p) { return -(p->F1 - p->F2) / (p->m2 * p->lT) * (p->T * p->T * p->T); }

double scallop_rest_x1_switch(point *p) { return scallop_rest_x1_end(p); } /* (15) and (19) print the same terms */

double scallop_rest_v1_end(point *p) { return drive(p) * p->T; }

double scallop_rest_x1_end(point *p) { return -p->m2 / (p->m1 + p->m2) * p->l_end + drive(p) * p->T * p->T / 2; }

double scallop_rest_x2_end(point *p) { return p->m1 / (p->m1 + p->m2) * p->l_end + 0.5 * drive(p) * p->T * p->T; }

double scallop_rest_xC_end(point *p)
{
  return 0.5 * (p->m1 - p->m2) / (p->m1 + p->m2) * p->l_end + 0.5 * drive(p) * p->T * p->T;
}

double scallop_text_extension_velocity_change(point *p)
{
  return drive(p) * p->T - p->v0 * (2 * p->F1 / p->m2) * (1 / p->l0 - 1 / p->lT) * (p->T * p->T);
}

double scallop_text_extension_xC_end(point *p)
{
  double T = p->T;
  return 0.5 * (p->m1 - p->m2) / (p->m1 + p->m2) * p->l_end + p->v0 * T + 0.5 * drive(p) * T * T
         - p->v0 * 2 * p->F1 / (p->m2 * p->l0) * (T * T * T);
}

double scallop_text_contraction_velocity_change(point *p)
{
  return -drive(p) * p->T + p->v0 * (2 * p->F2 / p->m1) * (1 / p->l0 - 1 / p->lT) * (p->T * p->T);
}

/* The paper writes l(T) for the separation at which the contraction begins. */
double scallop_text_contraction_xC_end(point *p)
{
  double T = p->T;
  return -0.5 * (p->m1 - p->m2) / (p->m1 + p->m2) * p->l_start + p->v0 * T - 0.5 * drive(p) * T * T
         + p->v0 * 2 * p->F2 / (p->m1 * p->l0) * (T * T * T);
}

static double reduced_mass(crawler *c) { return c->m1 * c->m2 / (c->m1 + c->m2); }

static double resistance(crawler *c) /* alpha^2 F1 m1 + (1 - alpha)^2 F2 m2 */
{
  double beta = 1 - c->alpha;
  return c->alpha * c->alpha * c->F1 * c->m1 + beta * beta * c->F2 * c->m2;
}

double scallop_text_steady_velocity_l0_lT(crawler *c)
{
  double l0 = c->gait->phase[SCALLOP_EXTENSION].l0 * c->L, lT = c->gait->phase[SCALLOP_EXTENSION].lT * c->L;
  return (c->F1 - c->F2) * (2 * c->alpha - 1) / (2 * c->T * (1 / l0 - 1 / lT) * resistance(c)) * reduced_mass(c);
}

double scallop_text_steady_velocity(crawler *c) { return scallop_text_steady_xC(c) / c->T; }

double scallop_text_steady_xC(crawler *c)
{
  double L_kin = scallop_kinematic_length(c->gait, SCALLOP_EXTENSION, c->L);
  return (c->F1 - c->F2) * (2 * c->alpha - 1) * L_kin * reduced_mass(c) / resistance(c);
}

double scallop_text_froude(crawler *c) { return (c->m1 + c->m2) * c->L / (c->T * c->T * (c->F1 + c->F2)); }
