#include "compare/answers/answer_flint.h"

#include <stddef.h>
#include <string.h>

#include "asymptotics/derived/evaluate.h"
#include "asymptotics/published/read.h"
#include "compare/points/point_flint.h"
#include "model/exact/scoped.h"

/* Returns the bits of the digits, and spare bits that keep the rounding of the subtraction below the radius. */
static slong bits_of(long digits) { return (slong)(3.33 * (double)digits) + 256; }

/* Returns friction_work / ((F1 + F2) |displacement|), or NULL if the displacement may be 0. */
static const arb_struct *cost_of_transport(struct ball_answer *a, const struct scallop_rational_crawler *c, slong bits)
{
  SCOPED(fmpq, forces);
  fmpq_add(forces, c->F1, c->F2);
  arb_set_fmpq(a->cost, forces, bits);
  arb_mul(a->cost, a->cost, a->steady.displacement, bits);
  arb_abs(a->cost, a->cost);
  arb_div(a->cost, a->steady.friction_work, a->cost, bits);
  return arb_contains_zero(a->steady.displacement) ? NULL : a->cost;
}

#define BALL(member) offsetof(struct ball_answer, member)
#define BOTH(member) BALL(member), offsetof(struct series_answer, member)
/* The offsets of the quantities in the answers; 0: absent; if_switches: exists only if the mode changes */
static const struct {
  enum quantity_of of;
  bool if_switches;
  size_t ball, series;
} places[ALL_QUANTITIES] = {
  [Q_FROUDE] = { OF_STEADY, false, BALL(steady.froude), 0 },
  [Q_V_START] = { OF_STEADY, false, BOTH(steady.v_start) },
  [Q_V_MID] = { OF_STEADY, false, BOTH(steady.v_mid) },
  [Q_DISPLACEMENT] = { OF_STEADY, false, BOTH(steady.displacement) },
  [Q_MEAN_VELOCITY] = { OF_STEADY, false, BOTH(steady.mean_velocity) },
  [Q_MULTIPLIER] = { OF_STEADY, false, BALL(steady.multiplier), 0 },
  [Q_FRICTION_WORK] = { OF_STEADY, false, BOTH(steady.friction_work) },
  [Q_T1] = { OF_PHASE, true, BOTH(phase.t1) },
  [Q_DT] = { OF_PHASE, true, BOTH(phase.dT) },
  [Q_V_END] = { OF_PHASE, false, BOTH(phase.v_end) },
  [Q_DX1] = { OF_PHASE, false, BOTH(phase.dx1) },
  [Q_DX2] = { OF_PHASE, false, BOTH(phase.dx2) },
  [Q_DXC] = { OF_PHASE, false, BOTH(phase.dxC) },
  [Q_AT_FIRST] = { OF_PHASE, true, BALL(phase.at_first), offsetof(struct series_answer, phase.rear_at_first) },
  [Q_AT_LAST] = { OF_PHASE, true, BALL(phase.at_last), offsetof(struct series_answer, phase.rear_at_last) },
  [Q_CHANGE] = { OF_PHASE, false, BALL(change), 0 },
  [Q_TURNING] = { OF_PHASE, true, BALL(turning), offsetof(struct series_answer, phase.v_at_last) },
};

/* Returns the value at this place of an answer, or NULL: such a motion has no such quantity. */
static const void *value_at(const void *answer, int q, size_t place, enum quantity_of of, bool switches)
{
  bool has = place > 0 && places[q].of == of && (switches || !places[q].if_switches);
  return has ? (const char *)answer + place : NULL;
}

bool answer_in_balls(struct ball_answer *a, const struct scallop_rational_crawler *c, enum quantity_of of,
                     enum scallop_phase_kind phase, const fmpq_t v0, long digits)
{
  const slong bits = bits_of(digits);
  memset(a->value, 0, sizeof a->value);
  a->why = NULL;
  a->status = of == OF_STEADY ? scallop_certified_steady(c, digits, &a->steady, &a->why)
                              : scallop_certified_phase(c, phase, v0, digits, &a->phase, &a->why);
  if (a->status != SCALLOP_OK)
    return false;
  for (int q = 0; q < ALL_QUANTITIES; q++)
    a->value[q] = value_at(a, q, places[q].ball, of, a->phase.switches);
  if (of == OF_STEADY) {
    a->value[Q_COST_OF_TRANSPORT] = cost_of_transport(a, c, bits);
    a->regime = a->steady.regime;
    memcpy(a->modes, a->steady.modes, sizeof a->modes);
  } else {
    arb_set_fmpq(a->change, v0, bits);
    arb_sub(a->change, a->phase.v_end, a->change, bits);
    a->regime = a->phase.regime;
    a->modes[0] = a->phase.modes;
  }
  return true;
}

bool answer_of_doubles(struct ball_answer *a, const struct motion *m, long digits)
{
  SCOPED(scallop_rational, exact);
  SCOPED(fmpq, v0);
  scallop_rational_of(&exact, &m->crawler);
  scallop_rational_set_double(v0, m->v0);
  return answer_in_balls(a, &exact, m->of, m->phase, v0, digits);
}

bool published_in_balls(arb_t value, const struct scallop_formula *f, const struct scallop_rational_crawler *crawler,
                        enum scallop_phase_kind phase, const fmpq_t v0, const fmpq_t T, const struct ball_answer *given,
                        slong precision)
{
  struct formula read;
  char message[FORMULA_MESSAGE];
  if (scallop_formula_text(&read, f, NULL, message))
    return false;
  arb_ptr balls = _arb_vec_init(3);
  if (given) {
    arb_set(balls, given->phase.t1);
    arb_set(balls + 1, given->phase.dT);
    arb_set(balls + 2, given->phase.at_last);
  }
  scallop_formula_in_balls(value, &read, f, crawler, phase, v0, T, given ? balls : NULL, precision);
  _arb_vec_clear(balls, 3);
  return arb_is_finite(value);
}

slong series_first_power(const struct series *s)
{
  slong k = s->first, end = k + series_terms(s);
  while (k < end && series_coefficient_is_zero(s, k))
    k++;
  return k < end ? k : s->known;
}

/* Returns the series of the cost of transport, or NULL: too few terms are known, or the displacement is 0. A
 * displacement that begins with T^2 costs four terms; the expansion to an even order provides these. */
static const struct series *cost_series(struct series_answer *a, const struct scallop_rational_crawler *c, slong order,
                                        slong precision)
{
  const struct ring ring = { order + 4, precision };
  const struct series *way = &a->steady.displacement;
  slong first = series_first_power(way);
  if (first >= order || !series_div(&a->cost, &a->steady.friction_work, way, &ring))
    return NULL;
  SCOPED(fmpq, factor);
  SCOPED(arb, x);
  series_coefficient(x, way, first, precision);
  fmpq_add(factor, c->F1, c->F2);
  fmpq_inv(factor, factor);
  if (arb_is_negative(x))
    fmpq_neg(factor, factor);
  series_scale(&a->cost, &a->cost, factor, &ring);
  return a->cost.known >= order ? &a->cost : NULL;
}

bool answer_in_series(struct series_answer *a, const struct scallop_rational_crawler *c, enum quantity_of of,
                      enum scallop_phase_kind phase, const fmpq_t v0, slong order, slong precision)
{
  a->why = NULL;
  a->status = of == OF_STEADY ? scallop_expand_steady(c, order + order % 2, precision, &a->steady, &a->why)
                              : scallop_expand_phase(c, phase, v0, order, precision, NULL, &a->phase, &a->why);
  for (int q = 0; q < ALL_QUANTITIES; q++)
    a->value[q] = value_at(a, q, places[q].series, of, a->phase.switches);
  a->modes = of == OF_STEADY ? a->steady.modes : a->phase.modes;
  a->value[Q_COST_OF_TRANSPORT] = of == OF_STEADY && a->status == SCALLOP_OK ? cost_series(a, c, order, precision)
                                                                             : NULL;
  return a->status == SCALLOP_OK;
}
