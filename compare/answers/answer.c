#include "compare/answers/answer.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "numerics/numerics.h"
#include "compare/text/digits.h"
#include "compare/text/table.h"

struct motion motion_of(const struct point *p, enum quantity_of of)
{
  return (struct motion){ .of = of, .crawler = p->crawler, .phase = p->phase, .v0 = p->v0 };
}

static void forget(struct answer *a, enum scallop_status status)
{
  *a = (struct answer){ .status = status, .v_low = NAN, .v_high = NAN };
  for (int q = 0; q < QUANTITIES; q++)
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
  take_period_modes(a, r->period.regime, r->period.modes);
}

static void take_phase(struct answer *a, const struct scallop_phase_result *r)
{
  a->value[Q_T1].high = r->t1;
  a->value[Q_DT].high = r->dT;
  a->value[Q_V_END].high = r->v_end;
  a->value[Q_DX1].high = r->dx1;
  a->value[Q_DX2].high = r->dx2;
  a->value[Q_DXC].high = r->dxC;
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
    take_phase(a, &s->phase);
  return true;
}

bool answer_in_double(struct answer *a, const struct motion *m)
{
  struct solved s;
  return solve(a, m, &s);
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
