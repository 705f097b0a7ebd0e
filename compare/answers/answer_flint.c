#include "compare/answers/answer_flint.h"

#include <string.h>

#include "asymptotics/derived/evaluate.h"
#include "compare/answers/point_flint.h"

void ball_answer_init(struct ball_answer *a)
{
  memset(a, 0, sizeof *a);
  scallop_certified_steady_init(&a->steady);
  scallop_certified_phase_init(&a->phase);
  arb_init(a->change);
  arb_init(a->turning);
  arb_init(a->cost);
}

void ball_answer_clear(struct ball_answer *a)
{
  scallop_certified_steady_clear(&a->steady);
  scallop_certified_phase_clear(&a->phase);
  arb_clear(a->change);
  arb_clear(a->turning);
  arb_clear(a->cost);
}

/* More than the digits take, so that the subtraction rounds nothing that is known */
static slong bits_of(long digits) { return (slong)(3.33 * (double)digits) + 256; }

/* Over (F1 + F2) |displacement|, unless that is 0. */
static const arb_struct *cost_of_transport(struct ball_answer *a, const struct scallop_rational_crawler *c, slong bits)
{
  fmpq_t forces;
  fmpq_init(forces);
  fmpq_add(forces, c->F1, c->F2);
  arb_set_fmpq(a->cost, forces, bits);
  arb_mul(a->cost, a->cost, a->steady.displacement, bits);
  arb_abs(a->cost, a->cost);
  arb_div(a->cost, a->steady.friction_work, a->cost, bits);
  fmpq_clear(forces);
  return arb_contains_zero(a->steady.displacement) ? NULL : a->cost;
}

static void take_steady(struct ball_answer *a, const struct scallop_rational_crawler *c, long digits)
{
  const struct scallop_certified_steady *s = &a->steady;
  a->value[Q_FROUDE] = s->froude;
  a->value[Q_V_START] = s->v_start;
  a->value[Q_V_MID] = s->v_mid;
  a->value[Q_DISPLACEMENT] = s->displacement;
  a->value[Q_MEAN_VELOCITY] = s->mean_velocity;
  a->value[Q_MULTIPLIER] = s->multiplier;
  a->value[Q_FRICTION_WORK] = s->friction_work;
  a->value[Q_COST_OF_TRANSPORT] = cost_of_transport(a, c, bits_of(digits));
  a->regime = s->regime;
  a->modes[0] = s->modes[0];
  a->modes[1] = s->modes[1];
}

static void take_phase(struct ball_answer *a, const fmpq_t v0, long digits)
{
  const struct scallop_certified_phase *p = &a->phase;
  a->value[Q_T1] = p->switches ? p->t1 : NULL;
  a->value[Q_DT] = p->switches ? p->dT : NULL;
  a->value[Q_V_END] = p->v_end;
  a->value[Q_DX1] = p->dx1;
  a->value[Q_DX2] = p->dx2;
  a->value[Q_DXC] = p->dxC;
  a->value[Q_AT_FIRST] = p->switches ? p->at_first : NULL;
  a->value[Q_AT_LAST] = p->switches ? p->at_last : NULL;
  a->value[Q_TURNING] = p->switches ? a->turning : NULL;
  a->value[Q_CHANGE] = a->change;
  slong bits = bits_of(digits);
  arb_set_fmpq(a->change, v0, bits);
  arb_sub(a->change, p->v_end, a->change, bits);
  a->regime = p->regime;
  a->modes[0] = p->modes;
}

bool answer_in_balls(struct ball_answer *a, const struct scallop_rational_crawler *c, enum quantity_of of,
                     enum scallop_phase_kind phase, const fmpq_t v0, long digits)
{
  memset(a->value, 0, sizeof a->value);
  a->why = NULL;
  a->status = of == OF_STEADY ? scallop_certified_steady(c, digits, &a->steady, &a->why)
                              : scallop_certified_phase(c, phase, v0, digits, &a->phase, &a->why);
  if (a->status != SCALLOP_OK)
    return false;
  if (of == OF_STEADY)
    take_steady(a, c, digits);
  else
    take_phase(a, v0, digits);
  return true;
}

bool answer_of_doubles(struct ball_answer *a, const struct motion *m, long digits)
{
  struct scallop_rational_crawler exact;
  fmpq_t v0;
  scallop_rational_init(&exact);
  scallop_rational_of(&exact, &m->crawler);
  fmpq_init(v0);
  scallop_rational_set_double(v0, m->v0);
  bool done = answer_in_balls(a, &exact, m->of, m->phase, v0, digits);
  fmpq_clear(v0);
  scallop_rational_clear(&exact);
  return done;
}

/* A few digits more than are printed, so that the last one is right to a unit. */
static long digits_to_solve(long digits)
{
  enum { SPARE = 3 };
  return digits + SPARE < SCALLOP_MOST_DIGITS ? digits + SPARE : SCALLOP_MOST_DIGITS;
}

bool answer_in_decimals(struct answer *a, char *texts[QUANTITIES], const struct point *point, enum quantity_of of,
                        long digits, const char **why)
{
  struct scallop_rational_crawler crawler;
  struct ball_answer b;
  fmpq_t v0;
  scallop_rational_init(&crawler);
  fmpq_init(v0);
  ball_answer_init(&b);
  rational_point(&crawler, v0, point);
  bool done = answer_in_balls(&b, &crawler, of, point->phase, v0, digits_to_solve(digits));
  *a = (struct answer){ .status = b.status, .regime = b.regime, .modes = { b.modes[0], b.modes[1] } };
  *why = b.why;
  for (int q = 0; q < QUANTITIES; q++)
    texts[q] = done && b.value[q] ? decimal_text(b.value[q], digits) : NULL;
  ball_answer_clear(&b);
  fmpq_clear(v0);
  scallop_rational_clear(&crawler);
  return done;
}

void decimals_free(char *texts[QUANTITIES])
{
  for (int q = 0; q < QUANTITIES; q++)
    flint_free(texts[q]);
}

bool published_in_balls(arb_t value, const struct scallop_formula *f, const struct scallop_rational_crawler *crawler,
                        enum scallop_phase_kind phase, const fmpq_t v0, const fmpq_t T, const struct ball_answer *given,
                        slong precision)
{
  const struct ring ring = { 1, precision };
  const bool steady = f->setting == SCALLOP_STEADY;
  const enum scallop_phase_kind kind = steady ? SCALLOP_EXTENSION : phase;
  struct scallop_symbols symbols;
  struct series sum;
  scallop_symbols_init(&symbols);
  series_init(&sum);
  scallop_symbols_set(&symbols, crawler, kind, steady ? NULL : v0, NULL, &ring);
  series_set_rational(&symbols.value[SYMBOL_T], T);
  if (given) {
    series_set_ball(&symbols.value[SYMBOL_t1], given->phase.t1);
    series_set_ball(&symbols.value[SYMBOL_dT], given->phase.dT);
    series_set_ball(&symbols.value[SYMBOL_x_switch], given->phase.at_last);
  }
  bool found = scallop_formula_expand(&sum, f, &symbols, kind, &ring);
  if (found)
    series_coefficient(value, &sum, 0, precision);
  series_clear(&sum);
  scallop_symbols_clear(&symbols);
  return found;
}

void series_answer_init(struct series_answer *a)
{
  memset(a, 0, sizeof *a);
  scallop_steady_expansion_init(&a->steady);
  scallop_phase_expansion_init(&a->phase);
  series_init(&a->cost);
}

void series_answer_clear(struct series_answer *a)
{
  scallop_steady_expansion_clear(&a->steady);
  scallop_phase_expansion_clear(&a->phase);
  series_clear(&a->cost);
}

/* Where the displacement begins with T^2 four terms are lost, which the expansion to an even order has to spare. NULL: it is 0, or begins later. */
static const struct series *cost_series(struct series_answer *a, const struct scallop_rational_crawler *c, slong order,
                                        slong precision)
{
  const struct ring ring = { order + 4, precision };
  const struct series *way = &a->steady.displacement;
  slong first = way->first;
  fmpq_t factor;
  arb_t x;
  while (first < order && series_coefficient_is_zero(way, first))
    first++;
  if (first >= order || !series_div(&a->cost, &a->steady.friction_work, way, &ring))
    return NULL;
  fmpq_init(factor);
  arb_init(x);
  series_coefficient(x, way, first, precision);
  fmpq_add(factor, c->F1, c->F2);
  fmpq_inv(factor, factor);
  if (arb_is_negative(x))
    fmpq_neg(factor, factor);
  series_scale(&a->cost, &a->cost, factor, &ring);
  fmpq_clear(factor);
  arb_clear(x);
  return a->cost.known >= order ? &a->cost : NULL;
}

static void take_expansions(struct series_answer *a, enum quantity_of of)
{
  const struct scallop_steady_expansion *s = &a->steady;
  const struct scallop_phase_expansion *p = &a->phase;
  bool steady = of == OF_STEADY, switches = !steady && p->switches;
  a->modes = steady ? s->modes : p->modes;
  a->value[Q_V_START] = steady ? &s->v_start : NULL;
  a->value[Q_V_MID] = steady ? &s->v_mid : NULL;
  a->value[Q_DISPLACEMENT] = steady ? &s->displacement : NULL;
  a->value[Q_MEAN_VELOCITY] = steady ? &s->mean_velocity : NULL;
  a->value[Q_FRICTION_WORK] = steady ? &s->friction_work : NULL;
  a->value[Q_T1] = switches ? &p->t1 : NULL;
  a->value[Q_DT] = switches ? &p->dT : NULL;
  a->value[Q_V_END] = steady ? NULL : &p->v_end;
  a->value[Q_DX1] = steady ? NULL : &p->dx1;
  a->value[Q_DX2] = steady ? NULL : &p->dx2;
  a->value[Q_DXC] = steady ? NULL : &p->dxC;
  a->value[Q_AT_FIRST] = switches ? &p->at_first : NULL;
  a->value[Q_AT_LAST] = switches ? &p->at_last : NULL;
  a->value[Q_TURNING] = switches ? &p->turning_velocity : NULL;
}

bool answer_in_series(struct series_answer *a, const struct scallop_rational_crawler *c, enum quantity_of of,
                      enum scallop_phase_kind phase, const fmpq_t v0, slong order, slong precision)
{
  a->why = NULL;
  a->status = of == OF_STEADY ? scallop_expand_steady(c, order + order % 2, precision, &a->steady, &a->why)
                              : scallop_expand_phase(c, phase, v0, order, precision, NULL, &a->phase, &a->why);
  take_expansions(a, of);
  a->value[Q_COST_OF_TRANSPORT] = of == OF_STEADY && a->status == SCALLOP_OK ? cost_series(a, c, order, precision) : NULL;
  return a->status == SCALLOP_OK;
}
