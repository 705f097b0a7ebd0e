#include "compare/answers/answer.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "numerics/numerics.h"
#include "compare/text/digits.h"
#include "compare/text/halfway.h"
#include "compare/text/table.h"

struct motion motion_of(const struct point *p, enum quantity_of of)
{
  return (struct motion){ .of = of, .crawler = p->crawler, .phase = p->phase, .v0 = p->v0 };
}

static void forget(struct answer *a, enum scallop_status status)
{
  *a = (struct answer){ .status = status, .v_low = NAN, .v_high = NAN };
  for (int q = 0; q < ALL_QUANTITIES; q++)
    a->value[q].high = NAN;
}

static void take_period_modes(struct answer *a, enum scallop_regime regime, const struct scallop_modes modes[2])
{
  a->regime = regime;
  a->modes[0] = modes[0];
  a->modes[1] = modes[1];
}

static void take_steady(struct answer *a, const struct scallop_steady_result *r)
{
  a->value[Q_FROUDE].high = r->froude;
  a->value[Q_V_START].high = r->period.v_start;
  a->value[Q_V_MID].high = r->period.v_mid;
  a->value[Q_DISPLACEMENT].high = r->period.displacement;
  a->value[Q_MEAN_VELOCITY].high = r->mean_velocity;
  a->value[Q_MULTIPLIER].high = r->period.multiplier;
  a->v_low = r->v_low;
  a->v_high = r->v_high;
  a->work = r->work;
  take_period_modes(a, r->period.regime, r->period.modes);
}

static void take_phase(struct answer *a, double v0, const struct scallop_phase_result *r)
{
  a->value[Q_T1].high = r->t1;
  a->value[Q_DT].high = r->dT;
  a->value[Q_V_END].high = r->v_end;
  a->value[Q_DX1].high = r->dx1;
  a->value[Q_DX2].high = r->dx2;
  a->value[Q_DXC].high = r->dxC;
  a->value[Q_CHANGE].high = r->v_end - v0;
  a->value[Q_TURNING].high = isnan(r->dT) ? NAN : 0;
  a->work = r->work;
  a->regime = r->regime;
  a->modes[0] = r->modes;
}

/* The solver's results, which its error estimates start from */
struct solved {
  struct scallop_steady_result steady;
  struct scallop_phase_result phase;
};

static bool solve(struct answer *a, const struct motion *m, struct solved *s)
{
  bool steady = m->of == OF_STEADY;
  forget(a, steady ? scallop_steady(&m->crawler, &s->steady) : scallop_phase(&m->crawler, m->phase, m->v0, &s->phase));
  if (a->status < 0)
    return false;
  if (steady)
    take_steady(a, &s->steady);
  else
    take_phase(a, m->v0, &s->phase);
  return true;
}

bool answer_in_double(struct answer *a, const struct motion *m)
{
  struct solved s;
  return solve(a, m, &s);
}

/* Positions of the rear body, from its start and in L, at the first and at the last change of mode. */
struct turning {
  double mu_front, stroke; /* stroke: l gained over the phase, +1 or -1 */
  struct scallop_mode mode;
  bool started;
  double first, last;
};

static void note_turning(void *context, const struct scallop_interval *i)
{
  struct turning *t = context;
  if (t->started && (i->mode.s1 != t->mode.s1 || i->mode.s2 != t->mode.s2)) {
    double way = i->piece->anchor == SCALLOP_FROM_END ? t->stroke : 0;
    t->last = i->x_begin - t->mu_front * t->stroke * (way + i->piece->curve->length(i->piece, i->u_begin));
    if (isnan(t->first))
      t->first = t->last;
  }
  t->mode = i->mode;
  t->started = true;
}

bool answer_turnings(struct answer *a, const struct motion *m)
{
  const struct scallop_crawler *c = &m->crawler;
  bool extension = m->phase == SCALLOP_EXTENSION;
  struct turning t = {
    .mu_front = (extension ? c->m2 : c->m1) / (c->m1 + c->m2), .stroke = extension ? 1 : -1, .first = NAN, .last = NAN
  };
  enum scallop_status status = scallop_phase_intervals(c, m->phase, m->v0, note_turning, &t);
  a->value[Q_AT_FIRST].high = t.first * c->L;
  a->value[Q_AT_LAST].high = t.last * c->L;
  return status >= 0;
}

static bool slides_from_rest(struct scallop_crawler c, double T)
{
  struct scallop_phase_result r;
  c.T = T;
  return scallop_phase(&c, SCALLOP_EXTENSION, 0, &r) == SCALLOP_OK && r.regime == SCALLOP_SLIDING;
}

double sticking_onset(const struct scallop_crawler *c)
{
  enum { MOST_DOUBLINGS = 400 };
  double sliding = 0, sticking = 1;
  int doublings = 0;
  while (slides_from_rest(*c, sticking) && doublings++ < MOST_DOUBLINGS)
    sticking *= 2;
  for (double mid; doublings < MOST_DOUBLINGS && halfway(&mid, sliding, sticking);)
    *(slides_from_rest(*c, mid) ? &sliding : &sticking) = mid;
  return doublings < MOST_DOUBLINGS && sliding > 0 ? sliding : NAN;
}

enum scallop_status answer_friction(struct answer *a, const struct motion *m)
{
  const struct scallop_crawler *c = &m->crawler;
  double *work = &a->value[Q_FRICTION_WORK].high, way = fabs(a->value[Q_DISPLACEMENT].high);
  enum scallop_status status = scallop_friction_work(c, a->value[Q_V_START].high, a->value[Q_V_MID].high, work);
  if (status != SCALLOP_OK)
    return status;
  a->value[Q_COST_OF_TRANSPORT].high = way == 0 ? NAN : *work / (c->F1 + c->F2) / way;
  return SCALLOP_OK;
}

double published_value(const struct scallop_formula *formula, const struct scallop_phase_point *point,
                       const struct motion *motion, const struct answer *given)
{
  struct scallop_phase_point p = *point;
  p.t1 = given->value[Q_T1].high;
  p.dT = given->value[Q_DT].high;
  p.x_switch = given->value[Q_AT_LAST].high;
  if (formula->setting == SCALLOP_AT_REST_START && motion->phase == SCALLOP_CONTRACTION)
    p = scallop_exchanged(&p);
  return formula->phase(&p);
}

bool answer_with_errors(struct answer *a, const struct motion *m, double errors[QUANTITIES])
{
  struct solved s;
  for (int q = 0; q < QUANTITIES; q++)
    errors[q] = NAN;
  if (!solve(a, m, &s))
    return false;
  if (m->of == OF_STEADY) {
    struct scallop_steady_error e = { NAN, NAN, NAN, NAN, NAN, NAN };
    scallop_steady_error(&m->crawler, &s.steady, &e);
    errors[Q_FROUDE] = e.froude;
    errors[Q_V_START] = e.v_start;
    errors[Q_V_MID] = e.v_mid;
    errors[Q_DISPLACEMENT] = e.displacement;
    errors[Q_MEAN_VELOCITY] = e.mean_velocity;
    errors[Q_MULTIPLIER] = e.multiplier;
    return true;
  }
  struct scallop_phase_error e = { NAN, NAN, NAN, NAN, NAN, NAN };
  scallop_phase_error(&m->crawler, m->phase, m->v0, &s.phase, &e);
  errors[Q_T1] = e.t1;
  errors[Q_DT] = e.dT;
  errors[Q_V_END] = e.v_end;
  errors[Q_DX1] = e.dx1;
  errors[Q_DX2] = e.dx2;
  errors[Q_DXC] = e.dxC;
  return true;
}

static bool steady_in_wide(struct answer *a, const struct motion *m, enum scallop_width width)
{
  struct scallop_wide_steady r;
  forget(a, scallop_wide_steady(width, &m->crawler, &r));
  if (a->status < 0)
    return false;
  a->value[Q_FROUDE] = r.froude;
  a->value[Q_V_START] = r.period.v_start;
  a->value[Q_V_MID] = r.period.v_mid;
  a->value[Q_DISPLACEMENT] = r.period.displacement;
  a->value[Q_MEAN_VELOCITY] = r.mean_velocity;
  a->value[Q_MULTIPLIER] = r.period.multiplier;
  a->value[Q_FRICTION_WORK] = r.friction_work;
  a->value[Q_COST_OF_TRANSPORT] = r.cost_of_transport;
  take_period_modes(a, r.period.regime, r.period.modes);
  return true;
}

bool answer_in_wide(struct answer *a, const struct motion *m, enum scallop_width width)
{
  if (m->of == OF_STEADY)
    return steady_in_wide(a, m, width);
  struct scallop_wide_phase r;
  forget(a, scallop_wide_phase(width, &m->crawler, m->phase, m->v0, &r));
  if (a->status < 0)
    return false;
  a->value[Q_T1] = r.t1;
  a->value[Q_DT] = r.dT;
  a->value[Q_V_END] = r.v_end;
  a->value[Q_DX1] = r.dx1;
  a->value[Q_DX2] = r.dx2;
  a->value[Q_DXC] = r.dxC;
  a->regime = r.regime;
  a->modes[0] = r.modes;
  return true;
}

const char *motion_modes_text(char text[MOTION_MODES_TEXT], enum quantity_of of, const struct scallop_modes modes[2])
{
  scallop_modes_text(&modes[0], text);
  if (of == OF_PHASE)
    return text;
  size_t length = strlen(text);
  memcpy(text + length, " | ", sizeof " | ");
  scallop_modes_text(&modes[1], text + length + 3);
  return text;
}

bool same_modes(const struct scallop_modes a[2], const struct scallop_modes b[2])
{
  for (int phase = 0; phase < 2; phase++) {
    int kept = a[phase].count < SCALLOP_MODES_KEPT ? (int)a[phase].count : SCALLOP_MODES_KEPT;
    if (a[phase].count != b[phase].count || memcmp(a[phase].kept, b[phase].kept, (size_t)kept * sizeof *a[phase].kept) != 0)
      return false;
  }
  return true;
}

const char *answer_status_text(char text[ANSWER_STATUS], const struct answer *a)
{
  char low[NUMBER_TEXT], high[NUMBER_TEXT];
  if (a->status < 0)
    return scallop_status_text(a->status);
  if (a->status != SCALLOP_INTERVAL)
    return "ok";
  number_text(low, a->v_low, 0);
  number_text(high, a->v_high, 0);
  snprintf(text, ANSWER_STATUS, "interval of steady states: v_start from %s to %s", low, high);
  return text;
}
