#include "asymptotics/asymptotics.h"

#include <math.h>
#include <stddef.h>

struct scallop_phase_point scallop_phase_point(const struct scallop_crawler *c, enum scallop_phase_kind kind, double v0)
{
  const struct scallop_shape *shape = &c->gait->phase[kind];
  bool extension = kind == SCALLOP_EXTENSION;
  return (struct scallop_phase_point){ .m1 = c->m1,
                                       .m2 = c->m2,
                                       .F1 = c->F1,
                                       .F2 = c->F2,
                                       .T = scallop_phase_duration(c, kind),
                                       .l0 = shape->l0 * c->L,
                                       .lT = shape->lT * c->L,
                                       .l_start = extension ? 0 : c->L,
                                       .l_end = extension ? c->L : 0,
                                       .v0 = v0,
                                       .t1 = NAN,
                                       .dT = NAN,
                                       .x_switch = NAN };
}

struct scallop_phase_point scallop_exchanged(const struct scallop_phase_point *p)
{
  struct scallop_phase_point q = *p;
  q.m1 = p->m2, q.m2 = p->m1;
  q.F1 = p->F2, q.F2 = p->F1;
  q.l0 = -p->l0, q.lT = -p->lT;
  q.l_start = p->l_end, q.l_end = p->l_start;
  return q;
}

#define REST(f, number, quantity, order) \
  { \
#f, number, SCALLOP_AT_REST_START, quantity, order, f, NULL \
  }
#define EXTENSION(f, number, quantity, order) \
  { \
#f, number, SCALLOP_MOVING_EXTENSION, quantity, order, f, NULL \
  }
#define CONTRACTION(f, number, quantity, order) \
  { \
#f, number, SCALLOP_MOVING_CONTRACTION, quantity, order, f, NULL \
  }
#define STEADY(f, number, quantity, order) \
  { \
#f, number, SCALLOP_STEADY, quantity, order, NULL, f \
  }

const struct scallop_formula scallop_published[] = {
  REST(rest_dT_unexpanded, "(13)", SCALLOP_LAG, 0),
  REST(rest_dT, "(14)", SCALLOP_LAG, 5),
  REST(rest_x1_switch, "(15)", SCALLOP_REAR_AT_LAST, 3),
  REST(rest_v1_end, "(18)", SCALLOP_VELOCITY_AT_END, 3),
  REST(rest_x1_end, "(19)", SCALLOP_REAR_AT_END, 4),
  REST(rest_x2_end, "(20)", SCALLOP_FRONT_AT_END, 4),
  REST(rest_xC_end, "(21)", SCALLOP_CENTRE_AT_END, 4),
  EXTENSION(text_extension_velocity_change, "(22)", SCALLOP_VELOCITY_CHANGE, 3),
  EXTENSION(text_extension_xC_end, "(23)", SCALLOP_CENTRE_AT_END, 4),
  CONTRACTION(text_contraction_velocity_change, "(24)", SCALLOP_VELOCITY_CHANGE, 3),
  CONTRACTION(text_contraction_xC_end, "(25)", SCALLOP_CENTRE_AT_END, 4),
  STEADY(text_steady_velocity_l0_lT, "(26)", SCALLOP_STEADY_VELOCITY, 1),
  STEADY(text_steady_velocity, "(27)", SCALLOP_STEADY_VELOCITY, 1),
  STEADY(text_steady_xC, "(28)", SCALLOP_STEADY_DISPLACEMENT, 4),
  EXTENSION(A_t1_unexpanded, "(A.5)", SCALLOP_FIRST_SWITCH, 0),
  EXTENSION(A_t1, "(A.6)", SCALLOP_FIRST_SWITCH, 6),
  EXTENSION(A_x1_first_switch, "(A.7)", SCALLOP_REAR_AT_FIRST, 0),
  EXTENSION(A_dT_unexpanded, "(A.14)", SCALLOP_LAG, 0),
  EXTENSION(A_dT_product, "(A.15)", SCALLOP_LAG, 6),
  EXTENSION(A_dT, "(A.16)", SCALLOP_LAG, 5),
  EXTENSION(A_x1_switch, "(A.18)", SCALLOP_REAR_AT_LAST, 4),
  EXTENSION(A_v1_end_from_dT, "(A.22)", SCALLOP_VELOCITY_AT_END, 4),
  EXTENSION(A_v1_end, "(A.22)", SCALLOP_VELOCITY_AT_END, 3),
  EXTENSION(A_x1_end_from_dT, "(A.23)", SCALLOP_REAR_AT_END, 6),
  EXTENSION(A_x1_end_from_dT_short, "(A.23)", SCALLOP_REAR_AT_END, 4),
  EXTENSION(A_x1_end, "(A.23)", SCALLOP_REAR_AT_END, 4),
  EXTENSION(A_vC_end, "(A.24)", SCALLOP_VELOCITY_AT_END, 3),
  EXTENSION(A_xC_end, "(A.25)", SCALLOP_CENTRE_AT_END, 4),
  CONTRACTION(B_t1_unexpanded, "(B.2)", SCALLOP_FIRST_SWITCH, 0),
  CONTRACTION(B_t1, "(B.2)", SCALLOP_FIRST_SWITCH, 6),
  CONTRACTION(B_x2_first_switch, "(B.3)", SCALLOP_REAR_AT_FIRST, 2),
  CONTRACTION(B_dT_unexpanded, "(B.5)", SCALLOP_LAG, 0),
  CONTRACTION(B_dT_product, "(B.6)", SCALLOP_LAG, 6),
  CONTRACTION(B_dT, "(B.6)", SCALLOP_LAG, 5),
  CONTRACTION(B_x2_switch, "(B.8)", SCALLOP_REAR_AT_LAST, 4),
  CONTRACTION(B_v2_end_from_dT, "(B.10)", SCALLOP_VELOCITY_AT_END, 0),
  CONTRACTION(B_v2_end, "(B.10)", SCALLOP_VELOCITY_AT_END, 3),
  CONTRACTION(B_x2_end, "(B.11)", SCALLOP_REAR_AT_END, 4),
  CONTRACTION(B_vC_end, "(B.12)", SCALLOP_VELOCITY_AT_END, 3),
  CONTRACTION(B_xC_end, "(B.13)", SCALLOP_CENTRE_AT_END, 4),
  { .name = NULL },
};
