/* Motion as a function of T: its answer, Froude number, and the T of permanent rest. */
#include "compare/breakdown/motion.h"

#include <math.h>

struct motion motion_at(const struct motion *m, double T)
{
  struct motion at = *m;
  at.crawler.T = m->of == OF_STEADY ? T : 2 * T;
  at.crawler.alpha = m->of == OF_STEADY ? m->crawler.alpha : 0.5;
  return at;
}

bool motion_in_wide(const struct motion *m, double T, struct answer *a)
{
  const struct motion at = motion_at(m, T);
  struct answer rounded;
  if (!answer_in_wide(a, &at, SCALLOP_BINARY128))
    return false;
  if (m->of == OF_STEADY && answer_in_double(&rounded, &at) && rounded.value[Q_DISPLACEMENT].high == 0)
    a->value[Q_DISPLACEMENT] = a->value[Q_MEAN_VELOCITY] = (struct scallop_wide){ 0, 0 };
  return true;
}

bool motion_has(const struct motion *m, enum quantity_id quantity)
{
  return quantity_rows[quantity].has_series && quantity_rows[quantity].of == m->of;
}

double motion_froude(const struct motion *s, double T)
{
  const struct scallop_crawler *c = &s->crawler;
  return (c->m1 + c->m2) / (c->F1 + c->F2) * c->L / T / T;
}

double motion_natural_time(const struct motion *s) { return sqrt(motion_froude(s, 1)); }

/* Returns max |l''| of a phase of duration 1: l'' is monotone within a piece. Sets *jumps if l' jumps. */
static double max_acceleration(const struct scallop_shape *shape, bool *jumps)
{
  double max = 0;
  for (const struct scallop_piece *p = shape->pieces; p < shape->pieces + shape->count; p++) {
    max = fmax(max, fmax(fabs(p->curve->acceleration(p, p->begin)), fabs(p->curve->acceleration(p, p->end))));
    *jumps |= p->jump;
  }
  return max;
}

/* A body i at rest stays at rest while m_j |l''| + F_j <= F_i: for every T from sqrt(m_j max|l''| L/(F_i - F_j)) on, if
 * l'' is taken of a phase of duration 1. Equal forces F take the place of their difference here. Friction stops a start
 * velocity after |v0| M/(F1 + F2). A jump of l' sets both bodies in motion; the centre of mass then approaches the
 * velocity of one of them at a rate of |F1 - F2|/M or more, from at most the sum of the largest |l'| of both phases. */
double motion_last_time(const struct motion *s)
{
  const struct scallop_crawler *c = &s->crawler;
  const struct scallop_shape *phase = c->gait->phase;
  bool jumps = false;
  double M = c->m1 + c->m2, difference = fmax(fabs(c->F1 - c->F2), 1e-12 * (c->F1 + c->F2));
  if (c->F1 == c->F2)
    difference = c->F1;
  double a = s->of == OF_STEADY ? c->alpha : 1, b = s->of == OF_STEADY ? 1 - c->alpha : 1;
  double most = fmax(max_acceleration(&phase[0], &jumps) / (a * a), max_acceleration(&phase[1], &jumps) / (b * b));
  double jump = jumps ? (phase[0].peak / a + phase[1].peak / b) / fmin(a, b) : 0;
  double rest = sqrt(fmax(fmax(c->m1, c->m2) * most, M * jump) * c->L / difference);
  double stop = s->of == OF_STEADY ? 0 : fabs(s->v0) * M / (c->F1 + c->F2);
  return 2 * fmax(rest, 16 * stop);
}
