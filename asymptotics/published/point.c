/* The parameters of a phase as the paper's formulas take them. */
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
