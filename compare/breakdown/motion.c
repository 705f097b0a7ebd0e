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

/* max |l''| of a phase of duration 1: l'' is monotone within a piece. Sets *jumps where l' jumps. */
static double most_acceleration(const struct scallop_shape *shape, bool *jumps)
{
  double most = 0;
  for (const struct scallop_piece *p = shape->pieces; p < shape->pieces + shape->count; p++) {
    most = fmax(most, fmax(fabs(p->curve->acceleration(p, p->begin)), fabs(p->curve->acceleration(p, p->end))));
    *jumps |= p->jump;
  }
  return most;
}

/* A body i that rests is held there while m_j |l''| + F_j <= F_i: for every T from sqrt(m_j max|l''| L/(F_i - F_j)) on,
 * l'' here being that of a phase of duration 1. With equal forces nothing depends on how they differ, and m_j |l''| is
 * to be compared with them. A start velocity is used up after |v0| M/(F1 + F2). Where l' jumps it throws the bodies
 * into motion; the velocity of the centre of mass comes to the level of one of them at the rate |F1 - F2|/M at least,
 * from as far as the fastest motions of both phases are apart. */
double motion_last_time(const struct motion *s)
{
  const struct scallop_crawler *c = &s->crawler;
  const struct scallop_shape *phase = c->gait->phase;
  bool jumps = false;
  double M = c->m1 + c->m2, difference = fmax(fabs(c->F1 - c->F2), 1e-12 * (c->F1 + c->F2));
  if (c->F1 == c->F2)
    difference = c->F1;
  double a = s->of == OF_STEADY ? c->alpha : 1, b = s->of == OF_STEADY ? 1 - c->alpha : 1;
  double most = fmax(most_acceleration(&phase[0], &jumps) / (a * a), most_acceleration(&phase[1], &jumps) / (b * b));
  double thrown = jumps ? (phase[0].peak / a + phase[1].peak / b) / fmin(a, b) : 0;
  double rest = sqrt(fmax(fmax(c->m1, c->m2) * most, M * thrown) * c->L / difference);
  double stop = s->of == OF_STEADY ? 0 : fabs(s->v0) * M / (c->F1 + c->F2);
  return 2 * fmax(rest, 16 * stop);
}
