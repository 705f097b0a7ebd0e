/* The energy dissipated by friction in a period of the steady state, as a series: from the energy balance, whereas
 * numerics/ adds up the lengths of the paths of the bodies. */
#include "asymptotics/derived/limit.h"
#include "asymptotics/derived/scoped.h"

/* Computes the factor of |l'| in the power of friction in a region, over F1 + F2, without the part that is the loss of
 * kinetic energy of the centre of mass. */
static void power_of_region(fmpq_t power, const struct phase_constants *p, int region)
{
  SCOPED(fmpq, rear, front); /* twice the friction of that body times its curve */
  fmpq_add_si(rear, p->beta[1], 1);
  fmpq_mul(rear, rear, p->curve[0]);
  fmpq_sub_si(front, p->beta[1], 1);
  fmpq_mul(front, front, p->curve[1]); /* minus the same product */
  if (region > 0)
    fmpq_neg(rear, rear);
  if (region > 1)
    fmpq_neg(front, front);
  fmpq_sub(power, front, rear);
  fmpq_div_2exp(power, power, 1);
}

/* Computes the integral of |l'| from the start of the phase to the crossing at the base point. */
static void way_to_base(struct series *way, const struct crossing *at, const struct phase_constants *p, slong precision)
{
  SCOPED(arb, from, to, part, sum);
  for (const struct scallop_piece *piece = p->shape->pieces; piece <= at->piece; piece++) {
    scallop_ball_begin(from, piece, precision);
    scallop_ball_end(to, piece, precision);
    if (piece == at->piece)
      series_coefficient(to, &at->offset, 0, precision);
    scallop_ball_way(part, piece, from, to, precision);
    arb_add(sum, sum, part, precision);
  }
  series_set_ball(way, sum);
}

/* Adds the dissipation of a phase to work, over (F1 + F2) L, without the loss of kinetic energy of the centre of mass:
 * 0 over the period. c, at the start (overwritten), and eps are the phase's. |l'| is c/q at a crossing, therefore its
 * integral so far is the integral of (c/q) dt over the variable of the series. */
static void add_friction_work(struct series *work, const struct branch *b, const struct phase_constants *p,
                              const struct lift *lift, struct series *c, const struct series *eps,
                              const struct ring *ring)
{
  SCOPED(series, since, term, way);
  SCOPED(fmpq, power, next);
  power_of_region(power, p, b->first_region);
  for (int i = 0; i < b->count; i++) {
    const struct crossing *at = &b->crossing[i];
    series_sub(&term, &lift->when.at[i], &since, ring);
    series_mul(&term, &term, eps, ring);
    series_scale(&term, &term, p->beta[branch_region(b, i)], ring);
    series_add(c, c, &term, ring); /* at this crossing */
    series_set(&since, &lift->when.at[i]);
    series_derivative(&term, &since, ring);
    series_mul(&term, &term, c, ring);
    fmpq_inv(next, p->curve[at->curve]);
    series_scale(&term, &term, next, ring);
    series_integral(&term, &term, ring);
    way_to_base(&way, at, p, ring->precision);
    series_add(&way, &way, &term, ring);
    power_of_region(next, p, at->to);
    fmpq_sub(power, power, next);
    series_scale(&way, &way, power, ring);
    series_add(work, work, &way, ring);
    fmpq_set(power, next);
  }
  series_set_rational(&term, power); /* the integral of |l'| up to the end is 1 */
  series_add(work, work, &term, ring);
}

void steady_friction_work(struct series *work, const struct limit *l, const struct steady_lift *s,
                          const struct series *eps, const struct ring *ring)
{
  SCOPED(series, c, here);
  series_set_si(work, 0);
  for (int k = 0; k < 2; k++) {
    const struct phase_constants *p = &l->phase[k];
    series_scale(&c, k == SCALLOP_EXTENSION ? &s->w : &s->w_mid, p->fraction, ring);
    series_scale(&here, eps, p->fraction, ring);
    series_scale(&here, &here, p->fraction, ring);
    add_friction_work(work, &l->branch[k], p, &s->phase[k], &c, &here, ring);
  }
}
