#include "numerics/certified/march.h"

#include <string.h>

void scallop_forces_of(struct scallop_forces *forces, const struct scallop_rational_crawler *c,
                       enum scallop_phase_kind kind)
{
  SCOPED(fmpq, M, unit);
  forces->kind = kind;
  scallop_exact_of(&forces->exact, c->gait);
  fmpq_add(M, c->m1, c->m2);
  fmpq_div(forces->share[0], c->m2, M);
  fmpq_neg(forces->share[0], forces->share[0]);
  fmpq_div(forces->share[1], c->m1, M);
  scallop_rational_duration(unit, c, kind);
  fmpq_mul(unit, unit, unit);
  fmpq_div(unit, unit, M);
  fmpq_div(unit, unit, c->L);
  fmpq_mul(forces->friction[0], c->F1, unit);
  fmpq_mul(forces->friction[1], c->F2, unit);
}

#define ZERO(kind, part) kind##_zero(part);
static void set_to_zero(struct scallop_march *s) { MARCH_PARTS(ZERO) }

void march_reset(struct scallop_march *m, const struct scallop_forces *forces, const arb_t v0, slong precision)
{
  set_to_zero(m);
  m->forces = forces;
  m->precision = precision;
  arb_one(m->multiplier);
  for (int body = 0; body < 2; body++) {
    arb_set(m->v[body], v0);
    arb_set_fmpq(m->share[body], forces->share[body], precision);
    m->s[body] = 0;
    m->departure[body] = SCALLOP_APART;
    m->moves[body] = false;
  }
  m->switches = m->sticks = false;
  memset(&m->modes, 0, sizeof m->modes);
  m->why = NULL;
}

static int rear(const struct scallop_march *m) { return m->forces->kind == SCALLOP_EXTENSION ? 0 : 1; }

/* Forces are divided by M here. */

/* n1 F1 + n2 F2 */
static void friction(fmpq_t sum, const struct scallop_march *m, int n1, int n2)
{
  SCOPED(fmpq, term);
  fmpq_mul_si(sum, m->forces->friction[0], n1);
  fmpq_mul_si(term, m->forces->friction[1], n2);
  fmpq_add(sum, sum, term);
}

void march_friction_sum(arb_t sum, const struct scallop_march *m, int n1, int n2)
{
  SCOPED(fmpq, exact);
  friction(exact, m, n1, n2);
  arb_set_fmpq(sum, exact, m->precision);
}

/* x_body'' now if it goes in direction s and the other body as it goes; where l'' is even, rounded once. */
static void acceleration(arb_t value, struct scallop_march *m, int body, int s)
{
  SCOPED(fmpq, drag, exact);
  friction(drag, m, body == 0 ? s : m->s[0], body == 0 ? m->s[1] : s);
  if (m->even) {
    fmpq_mul(exact, m->forces->share[body], m->bend);
    fmpq_sub(exact, exact, drag);
    arb_set_fmpq(value, exact, m->precision);
  } else {
    SCOPED(arb, force);
    scallop_enclose_gait(value, m->piece, m->now, 1, m->precision);
    arb_mul(value, value, m->share[body], m->precision);
    arb_set_fmpq(force, drag, m->precision);
    arb_sub(value, value, force, m->precision);
  }
}

enum hold march_hold_against(struct scallop_march *m, int body, int side)
{
  SCOPED(arb, value);
  acceleration(value, m, body, side);
  int sign = arb_sgn_nonzero(value);
  bool at_its_limit = m->even && arb_is_zero(value);
  return sign == side ? PULLED : sign == -side || at_its_limit ? HELD : UNDECIDED;
}

void march_shear(struct scallop_march *m, int body, int s)
{
  SCOPED(arb, before, after);
  acceleration(before, m, body, s);
  acceleration(after, m, body, -s);
  arb_div(after, after, before, m->precision);
  arb_mul(m->multiplier, m->multiplier, after, m->precision);
}

void march_advance(struct scallop_march *m, const arb_t to)
{
  SCOPED(arb, from, until, way);
  scallop_enclose_offset(from, m->piece, m->now, m->precision);
  scallop_enclose_offset(until, m->piece, to, m->precision);
  scallop_ball_way(way, m->piece, from, until, m->precision);
  arb_addmul_si(m->l_now, way, m->piece->direction, m->precision);
  arb_set(m->now, to);
}

/* v += share (l' - rate) - drag h, x += v h + share (l gained - rate h) - drag h^2/2 */
static void slide(struct scallop_march *m, int body, const arb_t rate, const arb_t h, const arb_t drag)
{
  arb_ptr v = m->v[body], x = m->x[body];
  slong p = m->precision;
  SCOPED(arb, t);
  arb_mul(t, m->rate, h, p);
  arb_sub(t, m->l_now, t, p);
  arb_addmul(x, t, m->share[body], p);
  arb_mul_2exp_si(t, h, -1);
  arb_mul(t, t, drag, p);
  arb_sub(t, v, t, p);
  arb_addmul(x, t, h, p);
  arb_sub(t, rate, m->rate, p);
  arb_addmul(v, t, m->share[body], p);
  arb_submul(v, drag, h, p);
}

void march_rest(struct scallop_march *m, int body)
{
  arb_zero(m->v[body]);
  arb_mul_si(m->v[1 - body], m->rate, body == 0 ? 1 : -1, m->precision);
}

void march_settle_at(struct scallop_march *m, const arb_t rate)
{
  SCOPED(arb, h, drag, x1, x2);
  const arb_ptr before[2] = { x1, x2 };
  slong p = m->precision;
  for (int i = 0; i < 2; i++)
    arb_set(before[i], m->x[i]);
  if (is_stuck(m)) {
    int body = the_stuck(m);
    (body == 0 ? arb_add : arb_sub)(m->x[1 - body], m->x[1 - body], m->l_now, p);
    arb_set(m->rate, rate);
    march_rest(m, body);
  } else {
    arb_sub(h, m->now, m->since, p);
    march_friction_sum(drag, m, m->s[0], m->s[1]);
    slide(m, 0, rate, h, drag);
    slide(m, 1, rate, h, drag);
    arb_set(m->rate, rate);
  }
  for (int i = 0; i < 2; i++) { /* in the directions of the mode */
    arb_sub(before[i], m->x[i], before[i], p);
    arb_addmul_si(m->path[i], before[i], m->s[i], p);
  }
  arb_set(m->since, m->now);
  arb_add(m->l_since, m->l_since, m->l_now, p);
  arb_zero(m->l_now);
}

void march_settle(struct scallop_march *m)
{
  SCOPED(arb, rate);
  scallop_enclose_gait(rate, m->piece, m->now, 0, m->precision);
  march_settle_at(m, rate);
}

void march_take_down(struct scallop_march *m)
{
  struct scallop_mode mode = { (signed char)m->s[0], (signed char)m->s[1] };
  struct scallop_modes *modes = &m->modes;
  struct scallop_mode *last = &modes->kept[FLINT_MAX(FLINT_MIN(modes->count, SCALLOP_MODES_KEPT) - 1, 0)];
  if (modes->count > 0 && last->s1 == mode.s1 && last->s2 == mode.s2)
    return;
  last += modes->count > 0 && modes->count < SCALLOP_MODES_KEPT; /* the last place holds the last mode */
  *last = mode;
  modes->count++;
  m->sticks = m->sticks || is_stuck(m);
  m->moves[0] = m->moves[0] || m->s[0] != 0;
  m->moves[1] = m->moves[1] || m->s[1] != 0;
  if (modes->count == 1)
    return;
  if (!m->switches) {
    arb_set(m->first, m->now);
    arb_set(m->at_first, m->x[rear(m)]);
  }
  m->switches = true;
  arb_set(m->last, m->now);
  arb_set(m->at_last, m->x[rear(m)]);
}
