/* The exact motion as a function of T. */
#include <math.h>

#include "compare/breakdown/parts.h"

bool subject_has(const struct subject *subject, enum quantity_id quantity)
{
  return quantity_rows[quantity].has_series && (quantity_rows[quantity].of == OF_STEADY) == subject->steady;
}

struct scallop_crawler subject_crawler(const struct subject *s, double T)
{
  struct scallop_crawler c = s->crawler;
  c.T = s->steady ? T : 2 * T;
  c.alpha = s->steady ? c.alpha : 0.5;
  return c;
}

static struct motion subject_at(const struct subject *s, double T)
{
  return (struct motion){
    .of = s->steady ? OF_STEADY : OF_PHASE, .crawler = subject_crawler(s, T), .phase = s->kind, .v0 = s->v0
  };
}

void subject_in_double(const struct subject *s, double T, struct answer *a)
{
  const struct motion m = subject_at(s, T);
  answer_in_double(a, &m);
}

/* A displacement that vanishes by symmetry is exactly 0 in double, and in binary128 what rounding leaves of it. */
void subject_in_wide(const struct subject *s, double T, struct answer *a)
{
  const struct motion m = subject_at(s, T);
  struct answer rounded;
  if (answer_in_wide(a, &m, SCALLOP_BINARY128) && s->steady && answer_in_double(&rounded, &m)
      && rounded.value[Q_DISPLACEMENT].high == 0)
    a->value[Q_DISPLACEMENT] = a->value[Q_MEAN_VELOCITY] = (struct scallop_wide){ 0, 0 };
}

bool subject_in_balls(const struct subject *s, double T, long digits, arb_ptr values)
{
  const struct motion m = subject_at(s, T);
  struct ball_answer a;
  ball_answer_init(&a);
  bool done = answer_of_doubles(&a, &m, digits);
  for (int q = 0; q < QUANTITIES; q++)
    if (done && a.value[q])
      arb_set(values + q, a.value[q]);
    else
      arb_indeterminate(values + q);
  ball_answer_clear(&a);
  return done;
}

double subject_froude(const struct subject *s, double T)
{
  const struct scallop_crawler *c = &s->crawler;
  return (c->m1 + c->m2) / (c->F1 + c->F2) * c->L / T / T;
}

double subject_natural_time(const struct subject *s)
{
  const struct scallop_crawler *c = &s->crawler;
  return sqrt((c->m1 + c->m2) / (c->F1 + c->F2) * c->L);
}

/* max |l''|: l'' is monotone within a piece */
static double most_acceleration(const struct scallop_shape *shape)
{
  double most = 0;
  for (int i = 0; i < shape->count; i++) {
    const struct scallop_piece *p = &shape->pieces[i];
    most = fmax(most, fmax(fabs(p->curve->acceleration(p, p->begin)), fabs(p->curve->acceleration(p, p->end))));
  }
  return most;
}

/* A body i that rests is held there while m_j |l''| + F_j <= F_i: for every T from sqrt(m_j max|l''| L/(F_i - F_j)) on, l'' here being
 * that of a phase of duration 1. With equal forces nothing depends on how they differ, and m_j |l''| is to be compared with them. A
 * start velocity is used up after |v0| M/(F1 + F2). */
double subject_last_time(const struct subject *s)
{
  const struct scallop_crawler *c = &s->crawler;
  const struct scallop_shape *phase = c->gait->phase;
  double difference = fmax(fabs(c->F1 - c->F2), 1e-12 * (c->F1 + c->F2));
  if (c->F1 == c->F2)
    difference = c->F1;
  double a = s->steady ? c->alpha : 1, b = s->steady ? 1 - c->alpha : 1;
  double most = fmax(most_acceleration(&phase[0]) / (a * a), most_acceleration(&phase[1]) / (b * b));
  double rest = sqrt(fmax(c->m1, c->m2) * c->L / difference * most);
  double stop = s->steady ? 0 : fabs(s->v0) * (c->m1 + c->m2) / (c->F1 + c->F2);
  return 2 * fmax(rest, 16 * stop);
}
