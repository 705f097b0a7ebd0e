/* The steady state in ball arithmetic: found by Newton's method, and then proven. */
#include <stdlib.h>

#include "numerics/certified/certify.h"

enum { STEADY_BALLS = 7 };

static arb_ptr steady_ball(struct scallop_certified_steady *r, int i)
{
  arb_ptr all[STEADY_BALLS] = { r->froude,        r->v_start,    r->v_mid,        r->displacement,
                                r->mean_velocity, r->multiplier, r->friction_work };
  return all[i];
}

void scallop_certified_steady_init(struct scallop_certified_steady *r)
{
  for (int i = 0; i < STEADY_BALLS; i++)
    arb_init(steady_ball(r, i));
  r->regime = SCALLOP_SLIDING;
  r->modes[0].count = r->modes[1].count = 0;
}

void scallop_certified_steady_clear(struct scallop_certified_steady *r)
{
  for (int i = 0; i < STEADY_BALLS; i++)
    arb_clear(steady_ball(r, i));
}

static bool is_zero_at(const struct scallop_piece *piece, double u)
{
  SCOPED(arb, at, speed);
  arb_set_d(at, u);
  scallop_ball_speed(speed, piece, at, 2 * FLINT_BITS);
  return arb_is_zero(speed);
}

/* Where a phase begins l' is 0, and was so at the end of the phase before, or jumps. */
static bool is_told_of_jumps(const struct scallop_gait *gait)
{
  for (int kind = 0; kind < 2; kind++) {
    const struct scallop_shape *before = &gait->phase[1 - kind];
    const struct scallop_piece *first = &gait->phase[kind].pieces[0], *last = &before->pieces[before->count - 1];
    if (!first->jump && !(is_zero_at(first, first->begin) && is_zero_at(last, last->end)))
      return false;
  }
  return true;
}

static bool has_jump(const struct scallop_gait *gait)
{
  for (int kind = 0; kind < 2; kind++)
    for (int i = 0; i < gait->phase[kind].count; i++)
      if (gait->phase[kind].pieces[i].jump)
        return true;
  return false;
}

/* Velocities in L/T */

struct period {
  struct scallop_forces forces[2];
  struct scallop_march march[2];
  fmpq_t fraction[2];
  arb_t v_mid, v_end, multiplier;
  const char *why;
};
#define PERIOD_PARTS(of) \
  of(scallop_forces, &s->forces[0]) of(scallop_forces, &s->forces[1]) of(scallop_march, &s->march[0]) \
      of(scallop_march, &s->march[1]) of(fmpq, s->fraction[0]) of(fmpq, s->fraction[1]) of(arb, s->v_mid) \
          of(arb, s->v_end) of(arb, s->multiplier)
SCOPED_PARTS(period, struct period, PERIOD_PARTS)

static bool march_phase(struct period *period, int kind, arb_t after, const arb_t before, slong precision)
{
  struct scallop_march *march = &period->march[kind];
  SCOPED(arb, fraction, start);
  arb_set_fmpq(fraction, period->fraction[kind], precision);
  arb_mul(start, before, fraction, precision);
  bool decided = scallop_march_phase(march, &period->forces[kind], start, precision);
  if (decided)
    arb_div(after, march->v_end, fraction, precision);
  else
    period->why = march->why;
  return decided;
}

static bool march_period(struct period *period, const arb_t v, slong precision)
{
  if (!march_phase(period, 0, period->v_mid, v, precision)
      || !march_phase(period, 1, period->v_end, period->v_mid, precision))
    return false;
  arb_mul(period->multiplier, period->march[0].multiplier, period->march[1].multiplier, precision);
  return true;
}

struct start_search {
  struct period period;
  arb_t v, low, high; /* exact; the steady state is between low and high */
  arb_t gain, fall;   /* P(v) - v, and minus its slope there      */
  slong known;        /* the precision of these two, 0: not known */
  bool jumps;         /* l' does: steady states may fill an interval */
};

#define SEARCH_PARTS(of) \
  of(period, &s->period) of(arb, s->v) of(arb, s->low) of(arb, s->high) of(arb, s->gain) of(arb, s->fall)
SCOPED_PARTS(search, struct start_search, SEARCH_PARTS)

static void search_of(struct start_search *s, const struct scallop_rational_crawler *crawler)
{
  s->known = 0;
  s->jumps = has_jump(crawler->gait);
  s->period.why = NULL;
  for (int kind = 0; kind < 2; kind++) {
    scallop_forces_of(&s->period.forces[kind], crawler, (enum scallop_phase_kind)kind);
    scallop_rational_fraction(s->period.fraction[kind], crawler, (enum scallop_phase_kind)kind);
  }
}

/* From beyond every curve both bodies go one way for the whole period, whatever l does: friction takes (F1 + F2) T / M
 * at most. */
static void bracket(struct start_search *s, const struct scallop_rational_crawler *c)
{
  enum { ROUGH = 64 };
  SCOPED(arb, term);
  arb_one(s->high);
  for (int kind = 0; kind < 2; kind++) {
    const struct scallop_forces *forces = &s->period.forces[kind];
    arb_set_d(term, c->gait->phase[kind].peak);
    arb_div_fmpz(term, term, fmpq_numref(s->period.fraction[kind]), ROUGH);
    arb_mul_fmpz(term, term, fmpq_denref(s->period.fraction[kind]), ROUGH);
    arb_add(s->high, s->high, term, ROUGH);
    for (int i = 0; i < 2; i++) { /* F tau^2/(M L) / fraction = F tau T/(M L) */
      arb_set_fmpq(term, forces->friction[i], ROUGH);
      arb_div_fmpz(term, term, fmpq_numref(s->period.fraction[kind]), ROUGH);
      arb_mul_fmpz(term, term, fmpq_denref(s->period.fraction[kind]), ROUGH);
      arb_add(s->high, s->high, term, ROUGH);
    }
  }
  arb_get_ubound_arf(arb_midref(s->high), s->high, ROUGH);
  mag_zero(arb_radref(s->high));
  arb_neg(s->low, s->high);
  arb_zero(s->v);
}

/* P(v) - v at s->v, where v is exact. Narrows the bracket: P does not fall, so it maps what is on one side of its fixed
 * points to the same side, and nearer. */
static bool probe(struct start_search *s, slong precision)
{
  s->known = 0;
  if (!march_period(&s->period, s->v, precision))
    return false;
  s->known = precision;
  arb_sub(s->gain, s->period.v_end, s->v, precision);
  arb_sub_ui(s->fall, s->period.multiplier, 1, precision);
  arb_neg(s->fall, s->fall);
  int sign = arb_sgn_nonzero(s->gain);
  if (sign > 0)
    arb_get_lbound_arf(arb_midref(s->low), s->period.v_end, precision);
  if (sign < 0)
    arb_get_ubound_arf(arb_midref(s->high), s->period.v_end, precision);
  return true;
}

/* Sets v to the middle of the bracket, by order of magnitude if the bracket spans many. */
static void middle(arb_t v, const struct start_search *s, slong precision)
{
  int sign = arb_sgn_nonzero(s->low);
  slong low = arf_abs_bound_lt_2exp_si(arb_midref(s->low)), high = arf_abs_bound_lt_2exp_si(arb_midref(s->high));
  if (sign == arb_sgn_nonzero(s->high) && labs(low - high) > 2) {
    arb_set_si(v, sign);
    arb_mul_2exp_si(v, v, low / 2 + high / 2);
  } else {
    arb_add(v, s->low, s->high, precision);
    arb_mul_2exp_si(v, v, -1);
    arb_get_mid_arb(v, v);
  }
}

/* Takes one step of Newton's method, or goes to the middle of the bracket if that step leads out of it. Nothing here
 * need be rigorous. Returns true if v cannot be better at this precision. */
static bool step(struct start_search *s, mag_t last, slong precision)
{
  SCOPED(arb, t);
  SCOPED(mag, size);
  arb_div(t, s->gain, s->fall, precision);
  arb_get_mag(size, t);
  mag_mul_2exp_si(size, size, 1);
  arb_add(t, t, s->v, precision);
  arb_get_mid_arb(t, t);
  bool slow = mag_cmp(size, last) > 0;
  if (!arb_is_finite(t) || slow || !arb_ge(t, s->low) || !arb_le(t, s->high)) {
    middle(t, s, precision);
    mag_inf(last);
  } else {
    mag_set(last, size);
    mag_mul_2exp_si(last, last, -1);
  }
  bool same = arb_equal(t, s->v);
  s->known = same ? s->known : 0;
  arb_swap(s->v, t);
  return same;
}

/* v right up to the digits that this precision has. A v at which the motion cannot be decided is left for one near
 * it. */
static void polish(struct start_search *s, slong precision)
{
  enum { MOST_NUDGES = 8 };
  SCOPED(mag, last);
  mag_inf(last);
  int nudges = 0;
  for (slong i = 0; i < 4 * precision; i++) {
    if (probe(s, precision)) {
      if (arb_contains_zero(s->gain) || step(s, last, precision))
        break;
    } else {
      if (nudges++ == MOST_NUDGES)
        break;
      arb_ptr side = nudges % 2 ? s->high : s->low;
      arb_mul_si(s->v, s->v, 1023, precision);
      arb_add(s->v, s->v, side, precision);
      arb_mul_2exp_si(s->v, s->v, -10);
      arb_get_mid_arb(s->v, s->v);
    }
  }
}

static bool has_sign_at(struct start_search *s, const arb_t v, int sign, slong precision)
{
  if (!march_period(&s->period, v, precision))
    return false; /* GCOVR_EXCL_LINE: a side that cannot be decided within a rounding of one that is */
  arb_sub(s->gain, s->period.v_end, v, precision);
  return arb_sgn_nonzero(s->gain) == sign;
}

static const char not_unique[] =
    "l' jumps, and the steady states fill an interval, or almost: in double the status has its ends";

/* How far from v the sign of P(v) - v is looked for first: 4 (P(v) - v) over its slope */
static void first_radius(arb_t radius, const struct start_search *s, slong precision)
{
  arb_div(radius, s->gain, s->fall, precision);
  arb_get_mag(arb_radref(radius), radius);
  arf_set_mag(arb_midref(radius), arb_radref(radius));
  mag_zero(arb_radref(radius));
  arb_mul_2exp_si(radius, radius, 2);
  if (!arb_is_zero(radius))
    return;
  if (arb_is_zero(s->v)) /* exactly steady, as below */
    arb_one(radius);
  else
    arb_abs(radius, s->v);
  arb_mul_2exp_si(radius, radius, -precision);
}

/* Finds a narrow ball around v across which P(v) - v changes its sign. Returns false if undecided. */
static bool prove(struct start_search *s, arb_t proven, slong precision)
{
  enum { TRIES = 6, WIDER = 6 };
  SCOPED(arb, radius, low, high);
  if (s->known != precision && !probe(s, precision))
    return false;
  if (arb_is_zero(s->gain) && !s->jumps) {
    arb_set(proven, s->v);
    return march_period(&s->period, proven, precision);
  }
  if (s->jumps && arb_contains_zero(s->gain) && arb_contains_zero(s->fall)) {
    s->period.why = not_unique;
    return false;
  }
  first_radius(radius, s, precision);
  for (int i = 0; i < TRIES && arb_is_finite(radius); i++) {
    arb_sub(low, s->v, radius, ARF_PREC_EXACT);
    arb_add(high, s->v, radius, ARF_PREC_EXACT);
    if (has_sign_at(s, low, 1, precision) && has_sign_at(s, high, -1, precision)) {
      arb_set(proven, s->v);
      arb_add_error(proven, radius);
      return march_period(&s->period, proven, precision);
    }
    arb_mul_2exp_si(radius, radius, WIDER); /* GCOVR_EXCL_LINE: the first radius has always done */
  }
  return false; /* GCOVR_EXCL_LINE: the first radius has always done */
}

/* Searches from 0, as all can be exact there: a crawler that friction brings to rest, equal forces. */
static bool find_steady(struct start_search *s, arb_t v, slong rough, slong precision)
{
  for (slong p = FLINT_MIN(rough, precision);; p = FLINT_MIN(2 * p, precision)) {
    polish(s, p);
    if (p == precision)
      break;
  }
  s->period.why = NULL; /* what a velocity on the way could not decide is of no interest */
  return prove(s, v, precision);
}

/* The centre of mass rests: no friction impulse in opposite motion under equal forces. */
static bool is_balanced(const struct period *p)
{
  bool balanced = fmpq_equal(p->forces[0].friction[0], p->forces[0].friction[1]);
  for (int kind = 0; kind < 2; kind++)
    balanced = balanced && !p->march[kind].switches && !p->march[kind].sticks && arb_is_zero(p->march[kind].v_end);
  return balanced;
}

/* Returns whether the contraction maps velocities as the extension maps their opposites. Then the mirror image of the
 * only steady state, half a period late, is steady, and therefore is that state itself: the displacement is 0. */
static bool is_mirrored(const struct scallop_rational_crawler *c, const struct period *period)
{
  const struct scallop_shape *phase = c->gait->phase;
  bool mirrored = fmpq_equal(period->fraction[0], period->fraction[1]) && scallop_gait_mirrors(c->gait);
  for (int i = 0; mirrored && i < phase[0].count; i++)
    mirrored = phase[0].pieces[i].direction == -phase[1].pieces[i].direction;
  return mirrored;
}

/* M L / (T^2 (F1 + F2)) = 1 / (friction_1 + friction_2), times the fraction of the period squared for the units of a
 * phase. */
static void froude_number(arb_t froude, const struct period *period, slong precision)
{
  SCOPED(fmpq, number);
  fmpq_add(number, period->forces[0].friction[0], period->forces[0].friction[1]);
  fmpq_div(number, number, period->fraction[0]);
  fmpq_div(number, number, period->fraction[0]);
  fmpq_inv(number, number);
  arb_set_fmpq(froude, number, precision);
}

/* In units of (F1 + F2) L */
static void friction_work(arb_t work, const struct period *period, slong precision)
{
  const struct scallop_march *m = period->march;
  const fmpq *friction[2] = { period->forces[0].friction[0], period->forces[0].friction[1] };
  SCOPED(arb, path, force);
  SCOPED(fmpq, sum);
  fmpq_add(sum, friction[0], friction[1]);
  arb_zero(work);
  for (int i = 0; i < 2; i++) {
    arb_add(path, m[0].path[i], m[1].path[i], precision);
    arb_set_fmpq(force, friction[i], precision);
    arb_addmul(work, path, force, precision);
  }
  arb_set_fmpq(force, sum, precision);
  arb_div(work, work, force, precision);
}

/* Converts lengths from L and velocities from L/T to the crawler's units. Returns false if not accurate enough. */
static bool steady_result(struct scallop_certified_steady *r, const struct period *period, const arb_t v,
                          const struct scallop_rational_crawler *c, slong bits, slong precision)
{
  const struct scallop_march *m = period->march;
  SCOPED(arb, length, velocity, one, energy);
  arb_set_fmpq(length, c->L, precision);
  arb_set_fmpq(velocity, c->T, precision);
  arb_div(velocity, length, velocity, precision);
  arb_one(one);
  arb_set_fmpq(energy, c->F1, precision);
  arb_set_fmpq(r->friction_work, c->F2, precision);
  arb_add(energy, energy, r->friction_work, precision);
  arb_mul(energy, energy, length, precision);
  arb_set(r->v_start, v);
  arb_set(r->v_mid, period->v_mid);
  arb_set(r->multiplier, period->multiplier);
  arb_add(r->displacement, m[0].x[0], m[1].x[0], precision);
  arb_add(r->mean_velocity, m[0].x[1], m[1].x[1], precision);
  bool accurate = arb_intersection(r->displacement, r->displacement, r->mean_velocity, precision);
  if (is_balanced(period) || is_mirrored(c, period))
    arb_zero(r->displacement);
  arb_set(r->mean_velocity, r->displacement);
  froude_number(r->froude, period, precision);
  friction_work(r->friction_work, period, precision);
  const arb_ptr size_of[STEADY_BALLS] = { one, velocity, velocity, length, velocity, one, energy };
  for (int i = 0; i < STEADY_BALLS; i++) {
    arb_mul(steady_ball(r, i), steady_ball(r, i), size_of[i], precision);
    accurate = accurate && certified_is_accurate(steady_ball(r, i), size_of[i], bits);
  }
  r->modes[0] = m[0].modes;
  r->modes[1] = m[1].modes;
  r->regime = certified_regime(m[0].sticks || m[1].sticks,
                               (m[0].moves[0] || m[1].moves[0]) && (m[0].moves[1] || m[1].moves[1]));
  return accurate;
}

enum scallop_status scallop_certified_steady(const struct scallop_rational_crawler *crawler, long digits,
                                             struct scallop_certified_steady *steady, const char **why)
{
  if (!certified_domain(crawler, digits) || !is_told_of_jumps(crawler->gait))
    return SCALLOP_EDOMAIN;
  SCOPED(scallop_certified_steady, result);
  SCOPED(search, search);
  SCOPED(arb, v);
  search_of(&search, crawler);
  bracket(&search, crawler);
  slong bits = certified_bits(digits), rough = certified_lost_bits(crawler) + 64,
        first = bits + certified_lost_bits(crawler);
  const char *reason = NULL;
  for (slong p = first; p <= certified_most(first); p = certified_more(p)) {
    bool found = find_steady(&search, v, rough, p);
    if (found && steady_result(&result, &search.period, v, crawler, bits, p)) {
      struct scallop_certified_steady before = *steady;
      *steady = result;
      result = before;
      return SCALLOP_OK;
    }
    reason = !found && search.period.why ? search.period.why : certified_not_enough;
  }
  certified_say(why, reason);
  return SCALLOP_EUNDECIDED;
}
