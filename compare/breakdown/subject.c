/* The exact motion as a function of T. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/breakdown/parts.h"
#include "compare/answers/counts_flint.h"
#include "compare/answers/exact.h"
#include "numerics/certified.h"

const char *breakdown_quantity_text(enum breakdown_quantity quantity)
{
  static const char *const text[] = { "v_start", "v_mid", "displacement", "mean_velocity", "t1",
                                      "dT",      "v_end", "dx1",          "dx2",           "dxC" };
  return text[quantity];
}

bool subject_has(const struct subject *subject, enum breakdown_quantity quantity)
{
  return (quantity < STEADY_QUANTITIES) == subject->steady;
}

struct scallop_crawler subject_crawler(const struct subject *s, double T)
{
  struct scallop_crawler c = s->crawler;
  c.T = s->steady ? T : 2 * T;
  c.alpha = s->steady ? c.alpha : 0.5;
  return c;
}

static void forget(struct exact *e)
{
  for (int i = 0; i < BREAKDOWN_QUANTITIES; i++)
    e->value[i] = (struct scallop_wide){ NAN, 0 };
  e->modes[0].count = e->modes[1].count = 0;
}

void exact_in_double(const struct subject *s, double T, struct exact *e)
{
  struct scallop_crawler c = subject_crawler(s, T);
  forget(e);
  if (s->steady) {
    struct scallop_steady_result r;
    e->status = counted_steady(&c, &r);
    if (e->status < 0)
      return;
    e->value[OF_V_START].high = r.period.v_start;
    e->value[OF_V_MID].high = r.period.v_mid;
    e->value[OF_DISPLACEMENT].high = r.period.displacement;
    e->value[OF_MEAN_VELOCITY].high = r.mean_velocity;
    e->regime = r.period.regime;
    e->modes[0] = r.period.modes[0];
    e->modes[1] = r.period.modes[1];
    return;
  }
  struct scallop_phase_result r;
  e->status = counted_phase(&c, s->kind, s->v0, &r);
  if (e->status < 0)
    return;
  const double values[] = { r.t1, r.dT, r.v_end, r.dx1, r.dx2, r.dxC };
  for (int i = OF_T1; i <= OF_DXC; i++)
    e->value[i].high = values[i - OF_T1];
  e->regime = r.regime;
  e->modes[0] = r.modes;
}

/* A displacement that vanishes by symmetry is exactly 0 in double, and in binary128 what rounding leaves of it. */
static void keep_zeros(const struct scallop_crawler *c, struct exact *e)
{
  struct scallop_steady_result r;
  if (counted_steady(c, &r) >= 0 && r.period.displacement == 0)
    e->value[OF_DISPLACEMENT] = e->value[OF_MEAN_VELOCITY] = (struct scallop_wide){ 0, 0 };
}

void exact_in_wide(const struct subject *s, double T, struct exact *e)
{
  struct scallop_crawler c = subject_crawler(s, T);
  forget(e);
  if (s->steady) {
    struct scallop_wide_steady r;
    e->status = scallop_wide_steady(SCALLOP_BINARY128, &c, &r);
    if (e->status < 0)
      return;
    e->value[OF_V_START] = r.period.v_start;
    e->value[OF_V_MID] = r.period.v_mid;
    e->value[OF_DISPLACEMENT] = r.period.displacement;
    e->value[OF_MEAN_VELOCITY] = r.mean_velocity;
    e->regime = r.period.regime;
    e->modes[0] = r.period.modes[0];
    e->modes[1] = r.period.modes[1];
    keep_zeros(&c, e);
    return;
  }
  struct scallop_wide_phase r;
  e->status = scallop_wide_phase(SCALLOP_BINARY128, &c, s->kind, s->v0, &r);
  if (e->status < 0)
    return;
  const struct scallop_wide values[] = { r.t1, r.dT, r.v_end, r.dx1, r.dx2, r.dxC };
  for (int i = OF_T1; i <= OF_DXC; i++)
    e->value[i] = values[i - OF_T1];
  e->regime = r.regime;
  e->modes[0] = r.modes;
}

static bool certified_steady(const struct scallop_rational_crawler *c, long digits, arb_ptr values)
{
  struct scallop_certified_steady r;
  scallop_certified_steady_init(&r);
  bool done = counted_certified_steady(c, digits, &r, NULL) == SCALLOP_OK;
  const arb_struct *const all[] = { r.v_start, r.v_mid, r.displacement, r.mean_velocity };
  for (int i = 0; done && i < STEADY_QUANTITIES; i++)
    arb_set(values + i, all[i]);
  scallop_certified_steady_clear(&r);
  return done;
}

static bool certified_phase(const struct scallop_rational_crawler *c, const struct subject *s, long digits, arb_ptr values)
{
  struct scallop_certified_phase r;
  fmpq_t v0;
  fmpq_init(v0);
  scallop_rational_set_double(v0, s->v0);
  scallop_certified_phase_init(&r);
  bool done = counted_certified_phase(c, s->kind, v0, digits, &r, NULL) == SCALLOP_OK;
  const arb_struct *const all[] = { r.t1, r.dT, r.v_end, r.dx1, r.dx2, r.dxC };
  for (int i = OF_T1; done && i < BREAKDOWN_QUANTITIES; i++)
    if (r.switches || i > OF_DT)
      arb_set(values + i, all[i - OF_T1]);
  scallop_certified_phase_clear(&r);
  fmpq_clear(v0);
  return done;
}

bool exact_certified(const struct subject *s, double T, long digits, arb_ptr values)
{
  struct scallop_crawler c = subject_crawler(s, T);
  struct scallop_rational_crawler exact;
  scallop_rational_init(&exact);
  scallop_rational_of(&exact, &c);
  for (int i = 0; i < BREAKDOWN_QUANTITIES; i++)
    arb_indeterminate(values + i);
  bool done = s->steady ? certified_steady(&exact, digits, values) : certified_phase(&exact, s, digits, values);
  scallop_rational_clear(&exact);
  return done;
}

void subject_modes_text(const struct subject *s, const struct scallop_modes modes[2], char *text)
{
  if (s->steady)
    period_modes_text(text, modes);
  else
    scallop_modes_text(&modes[0], text);
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
