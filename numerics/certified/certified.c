#include "numerics/certified/certify.h"

#include <stdlib.h>

enum { PHASE_BALLS = 9 };

static arb_ptr phase_ball(struct scallop_certified_phase *r, int i)
{
  arb_ptr all[PHASE_BALLS] = { r->t1, r->dT, r->v_end, r->dx1, r->dx2, r->dxC, r->at_first, r->at_last, r->multiplier };
  return all[i];
}

void scallop_certified_phase_init(struct scallop_certified_phase *r)
{
  for (int i = 0; i < PHASE_BALLS; i++)
    arb_init(phase_ball(r, i));
  r->switches = false;
  r->regime = SCALLOP_SLIDING;
  r->modes.count = 0;
}

void scallop_certified_phase_clear(struct scallop_certified_phase *r)
{
  for (int i = 0; i < PHASE_BALLS; i++)
    arb_clear(phase_ball(r, i));
}

bool certified_domain(const struct scallop_rational_crawler *c, long digits)
{
  return scallop_rational_is_valid(c) && fmpq_sgn(c->T) > 0 && digits >= 1 && digits <= SCALLOP_MOST_DIGITS
         && scallop_gait_is_exact(c->gait);
}

slong certified_bits(long digits) { return (slong)((double)digits * 3.3219280948873624) + 4; }

static slong log2_size(const fmpq_t x) { return (slong)fmpz_bits(fmpq_numref(x)) - (slong)fmpz_bits(fmpq_denref(x)); }

/* Bits that are lost on the way: P(v) - v is 1 - O(eps), dT of order eps, ratios cancel, and so does a phase that is
 * short. */
slong certified_lost_bits(const struct scallop_rational_crawler *c)
{
  slong eps = 2 * log2_size(c->T) + FLINT_MAX(log2_size(c->F1), log2_size(c->F2)) - log2_size(c->L)
              - FLINT_MAX(log2_size(c->m1), log2_size(c->m2));
  slong lost = 64 + 2 * labs(eps) + labs(log2_size(c->F1) - log2_size(c->F2))
               + labs(log2_size(c->m1) - log2_size(c->m2));
  SCOPED(fmpq, fraction);
  for (int kind = 0; kind < 2; kind++) {
    scallop_rational_fraction(fraction, c, (enum scallop_phase_kind)kind);
    lost += 4 * labs(log2_size(fraction));
  }
  return lost;
}

slong certified_more(slong precision) { return precision + precision / 2 + 64; }
slong certified_most(slong first) { return 4 * first + 8192; }

/* Enough bits of its own, or a 0 to enough bits of its natural size. */
bool certified_is_accurate(const arb_t x, const arb_t size, slong bits)
{
  if (!arb_contains_zero(x))
    return arb_rel_accuracy_bits(x) >= bits;
  SCOPED(mag, most, allowed);
  arb_get_mag(most, x);
  arb_get_mag_lower(allowed, size);
  mag_mul_2exp_si(allowed, allowed, -bits);
  return mag_cmp(most, allowed) <= 0;
}

enum scallop_regime certified_regime(bool sticks, bool both_move)
{
  return !both_move ? SCALLOP_AT_REST : sticks ? SCALLOP_STICK_SLIP : SCALLOP_SLIDING;
}

/* In the units of the crawler; false: not accurate enough. */
static bool phase_result(struct scallop_certified_phase *r, struct scallop_march *m, const fmpq_t tau, const fmpq_t L,
                         slong bits)
{
  SCOPED(arb, time, velocity, length, one);
  slong p = m->precision;
  arb_set_fmpq(time, tau, p);
  arb_set_fmpq(length, L, p);
  arb_div(velocity, length, time, p);
  arb_one(one);
  arb_set(r->t1, m->first);
  arb_sub_ui(r->dT, m->last, 1, p);
  arb_neg(r->dT, r->dT);
  arb_set(r->v_end, m->v_end);
  arb_set(r->dx1, m->x[0]);
  arb_set(r->dx2, m->x[1]);
  arb_add(r->dxC, m->x[0], m->x[1], p);
  arb_mul_2exp_si(r->dxC, r->dxC, -1);
  arb_set(r->at_first, m->at_first);
  arb_set(r->at_last, m->at_last);
  arb_set(r->multiplier, m->multiplier);
  const arb_ptr size_of[PHASE_BALLS] = { time, time, velocity, length, length, length, length, length, one };
  bool accurate = true;
  for (int i = 0; i < PHASE_BALLS; i++) {
    arb_mul(phase_ball(r, i), phase_ball(r, i), size_of[i], p);
    accurate = accurate && certified_is_accurate(phase_ball(r, i), size_of[i], bits);
  }
  r->switches = m->switches;
  r->modes = m->modes;
  r->regime = certified_regime(m->sticks, m->moves[0] && m->moves[1]);
  return accurate;
}

void certified_say(const char **why, const char *reason)
{
  if (why)
    *why = reason;
}

const char *const certified_not_enough = "the result does not settle to the digits asked for at any precision tried";

enum scallop_status scallop_certified_phase(const struct scallop_rational_crawler *crawler,
                                            enum scallop_phase_kind kind, const fmpq_t v0, long digits,
                                            struct scallop_certified_phase *phase, const char **why)
{
  if (!certified_domain(crawler, digits))
    return SCALLOP_EDOMAIN;
  SCOPED(scallop_certified_phase, result);
  SCOPED(scallop_forces, forces);
  SCOPED(scallop_march, march);
  SCOPED(fmpq, tau, scaled);
  SCOPED(arb, start);
  scallop_forces_of(&forces, crawler, kind);
  scallop_rational_duration(tau, crawler, kind);
  fmpq_mul(scaled, v0, tau);
  fmpq_div(scaled, scaled, crawler->L);
  slong bits = certified_bits(digits), first = bits + certified_lost_bits(crawler);
  const char *reason = NULL;
  for (slong p = first; p <= certified_most(first); p = certified_more(p)) {
    arb_set_fmpq(start, scaled, p);
    bool marched = scallop_march_phase(&march, &forces, start, p);
    if (marched && phase_result(&result, &march, tau, crawler->L, bits)) {
      struct scallop_certified_phase before = *phase;
      *phase = result;
      result = before;
      return SCALLOP_OK;
    }
    reason = marched ? certified_not_enough : march.why;
  }
  certified_say(why, reason);
  return SCALLOP_EUNDECIDED;
}
