#include "compare/answers/exact.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "numerics/numerics.h"
#include "compare/text/table.h"

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

enum scallop_status exact_phase_start(const struct scallop_crawler *c, enum scallop_phase_kind kind, double v0,
                                      struct exact_phase *exact)
{
  enum scallop_status status = scallop_phase(c, kind, v0, &exact->phase);
  exact->kind = kind;
  exact->v0 = v0;
  exact->at_first = exact->at_last = NAN;
  return status;
}

enum scallop_status exact_phase_turnings(const struct scallop_crawler *c, struct exact_phase *exact)
{
  bool extension = exact->kind == SCALLOP_EXTENSION;
  struct turning t = {
    .mu_front = (extension ? c->m2 : c->m1) / (c->m1 + c->m2), .stroke = extension ? 1 : -1, .first = NAN, .last = NAN
  };
  enum scallop_status status = scallop_phase_intervals(c, exact->kind, exact->v0, note_turning, &t);
  exact->at_first = t.first * c->L;
  exact->at_last = t.last * c->L;
  return status;
}

enum scallop_status exact_phase_solve(const struct scallop_crawler *c, enum scallop_phase_kind kind, double v0,
                                      struct exact_phase *exact)
{
  enum scallop_status status = exact_phase_start(c, kind, v0, exact);
  return status == SCALLOP_OK ? exact_phase_turnings(c, exact) : status;
}

double exact_quantity(const struct exact_phase *e, enum scallop_quantity quantity)
{
  bool extension = e->kind == SCALLOP_EXTENSION;
  switch (quantity) {
  case SCALLOP_LAG: return e->phase.dT;
  case SCALLOP_FIRST_SWITCH: return e->phase.t1;
  case SCALLOP_REAR_AT_FIRST: return e->at_first;
  case SCALLOP_REAR_AT_LAST: return e->at_last;
  case SCALLOP_REAR_AT_END: return extension ? e->phase.dx1 : e->phase.dx2;
  case SCALLOP_FRONT_AT_END: return extension ? e->phase.dx2 : e->phase.dx1;
  case SCALLOP_CENTRE_AT_END: return e->phase.dxC;
  case SCALLOP_VELOCITY_AT_END: return e->phase.v_end;
  case SCALLOP_VELOCITY_CHANGE: return e->phase.v_end - e->v0;
  case SCALLOP_VELOCITY_AT_FIRST:
  case SCALLOP_VELOCITY_AT_LAST: return isnan(e->phase.dT) ? NAN : 0;
  case SCALLOP_STEADY_VELOCITY:
  case SCALLOP_STEADY_DISPLACEMENT: break;
  }
  return NAN;
}

double published_value(const struct scallop_formula *formula, const struct scallop_phase_point *point,
                       const struct exact_phase *exact)
{
  struct scallop_phase_point p = *point;
  p.t1 = exact->phase.t1;
  p.dT = exact->phase.dT;
  p.x_switch = exact->at_last;
  if (formula->setting == SCALLOP_AT_REST_START && exact->kind == SCALLOP_CONTRACTION)
    p = scallop_exchanged(&p);
  return formula->phase(&p);
}

const char *formula_quantity_text(const struct scallop_formula *f, enum scallop_phase_kind kind)
{
  static const char *const of_contraction[] = { "dT",    "t1",     "x2(t1)", "x2(T-dT)", "x2(T)",
                                                "x1(T)", "x_C(T)", "v(T)",   "v(T)-v0" };
  static const char *const of_extension[] = {
    "dT", "t1", "x1(t1)", "x1(T-dT)", "x1(T)", "x2(T)", "x_C(T)", "v(T)", "v(T)-v0"
  };
  if (f->quantity == SCALLOP_VELOCITY_AT_FIRST || f->quantity == SCALLOP_VELOCITY_AT_LAST)
    return f->quantity == SCALLOP_VELOCITY_AT_FIRST ? "v(t1)" : "v(T-dT)";
  if (f->setting == SCALLOP_STEADY)
    return f->quantity == SCALLOP_STEADY_VELOCITY ? "v_start" : "displacement";
  return (kind == SCALLOP_EXTENSION ? of_extension : of_contraction)[f->quantity];
}

const char *period_modes_text(char text[PERIOD_MODES_TEXT], const struct scallop_modes modes[2])
{
  scallop_modes_text(&modes[0], text);
  size_t length = strlen(text);
  memcpy(text + length, " | ", sizeof " | ");
  scallop_modes_text(&modes[1], text + length + 3);
  return text;
}

const char *steady_status_text(char text[STEADY_STATUS], enum scallop_status status, double v_low, double v_high)
{
  char low[NUMBER_TEXT], high[NUMBER_TEXT];
  if (status != SCALLOP_INTERVAL)
    return "ok";
  number_text(low, v_low, 0);
  number_text(high, v_high, 0);
  snprintf(text, STEADY_STATUS, "interval of steady states: v_start from %s to %s", low, high);
  return text;
}
