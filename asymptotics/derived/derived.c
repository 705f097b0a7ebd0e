/* The expansions of derived.h: a phase or the steady state around T = 0, from the branch of its limit. */
#include "asymptotics/derived/derived.h"

#include <stdio.h>

#include "asymptotics/derived/evaluate.h"
#include "asymptotics/derived/scoped.h"

enum { EXPANDED = sizeof((struct scallop_expansion *)0)->of / sizeof(struct series) };

static void forget(struct scallop_expansion *e)
{
  e->switches = false;
  for (int q = 0; q < EXPANDED; q++)
    series_set_unknown(&e->of[q]);
}

void scallop_expansion_init(struct scallop_expansion *e)
{
  for (int q = 0; q < EXPANDED; q++)
    series_init(&e->of[q]);
  forget(e);
  e->modes[0] = '\0';
}

void scallop_expansion_clear(struct scallop_expansion *e)
{
  for (int q = 0; q < EXPANDED; q++)
    series_clear(&e->of[q]);
}

const struct series *scallop_expansion_of(const struct scallop_expansion *e, enum scallop_quantity quantity)
{
  return series_is_unknown(&e->of[quantity]) ? NULL : &e->of[quantity];
}

/* Writes the modes of a phase, and returns the end of the text. */
static char *put_modes(char *to, const char *end, const struct branch *b, enum scallop_phase_kind kind)
{
  static const char *const names[2][3] = { { "++", "-+", "--" }, { "++", "+-", "--" } };
  static const char *const stuck[2][2] = { { "0+", "-0" }, { "+0", "0-" } };
  for (int i = 0; i <= b->count; i++) {
    const struct crossing *next = i < b->count ? &b->crossing[i] : NULL;
    const char *mode = next && next->tangent ? stuck[kind][next->curve] : names[kind][branch_region(b, i)];
    to += snprintf(to, (size_t)(end - to), "%s%s", i ? " " : "", mode);
  }
  return to;
}

/* Computes in balls the integral of |l'|(t(x)) t'(x): fewer products than a composition takes. */
static void way_in_balls(struct series *way, const struct scallop_piece *piece, const struct series *t,
                         const struct ring *ring)
{
  SCOPED(arb, zero);
  SCOPED(arb_poly, time, speed, rate);
  SCOPED(series, growth);
  series_get_ball_poly(time, t, ring->length, ring->precision);
  scallop_ball_speed_along(speed, rate, piece, zero, time, ring->length, ring->precision);
  series_set_ball_poly(way, speed, FLINT_MIN(ring->length, t->known));
  series_derivative(&growth, t, ring);
  series_mul(way, way, &growth, ring);
  series_integral(way, way, ring);
}

/* Computes the integral of |l'| from the start of the phase to a crossing at offset 0 of its piece. */
static void way_to(struct series *way, const struct lift *l, int i, const struct branch *b,
                   const struct phase_series *p, const struct ring *ring)
{
  const struct scallop_piece *piece = b->crossing[i].piece;
  const bool from_end = piece->anchor == SCALLOP_FROM_END; /* measured from the end: minus the rest */
  SCOPED(fmpq, anchor);
  SCOPED(series, speed, t);
  series_set(&t, from_end ? &l->left.at[i] : &l->when.at[i]);
  if (from_end)
    series_neg(&t, &t);
  const bool exact =
      p->has_laws || (t.kind != SERIES_BALLS && scallop_exact_speed_series(&speed, piece, anchor, p->pi_squared, ring));
  if (p->has_laws)
    series_set(&speed, &p->law.at[i]);
  if (!exact)
    way_in_balls(way, piece, &t, ring);
  else {
    series_truncate(&speed, ring->length);
    series_integral(&speed, &speed, ring);
    series_compose(way, &speed, &t, ring);
  }
  if (from_end)
    series_add(way, way, &p->whole, ring);
}

/* Computes unit (travel - share way): the point recedes by this share of the growth of the separation. */
static void position(struct series *to, const struct series *travel, const struct series *share,
                     const struct series *way, const struct phase_series *p, const struct ring *ring)
{
  SCOPED(series, back);
  series_mul(&back, way, share, ring);
  series_sub(to, travel, &back, ring);
  series_mul(to, to, &p->unit, ring);
}

/* Computes the position of the rear body, and of its counterpart in a contraction. */
static void rear_position(struct series *to, const struct lift *l, int i, const struct branch *b,
                          const struct phase_series *p, const struct ring *ring)
{
  SCOPED(series, way);
  way_to(&way, l, i, b, p, ring);
  position(to, &l->travel_to.at[i], &p->curve[0], &way, p, ring);
}

static void displacements(struct scallop_expansion *e, const struct lift *l, const struct phase_series *p,
                          const struct ring *ring)
{
  SCOPED(series, centre);
  SCOPED(fmpq, half);
  fmpq_set_si(half, 1, 2);
  series_add(&centre, &p->curve[0], &p->curve[1], ring);
  series_scale(&centre, &centre, half, ring);
  position(&e->rear_at_end, &l->travel, &p->curve[0], &p->whole, p, ring);
  position(&e->front_at_end, &l->travel, &p->curve[1], &p->whole, p, ring);
  position(&e->dxC, &l->travel, &centre, &p->whole, p, ring);
  const bool extension = p->kind == SCALLOP_EXTENSION;
  series_set(&e->dx1, extension ? &e->rear_at_end : &e->front_at_end);
  series_set(&e->dx2, extension ? &e->front_at_end : &e->rear_at_end);
}

bool expand_branch(struct scallop_expansion *e, struct branch *b, const struct phase_series *p, const struct series *c,
                   const struct series *eps, const struct series *v0, const struct ring *ring)
{
  const int last = b->count - 1;
  SCOPED(lift, l);
  SCOPED(series, none);
  if (!lift_phase(&l, b, p, eps, c, &none, CROSSINGS_KNOWN, ring))
    return false; /* GCOVR_EXCL_LINE: balls too wide */
  forget(e);
  displacements(e, &l, p, ring);
  series_mul(&e->v_end, &l.c_end, &p->unit, ring);
  series_shift(&e->v_end, &e->v_end, -1);
  series_sub(&e->v_change, &e->v_end, v0, ring);
  series_set_zero(&e->v_change, 0);
  e->switches = last >= 0;
  if (e->switches) {
    series_shift(&e->t1, &l.when.at[0], 1);
    series_shift(&e->dT, &l.left.at[last], 1);
    rear_position(&e->rear_at_first, &l, 0, b, p, ring);
    rear_position(&e->rear_at_last, &l, last, b, p, ring);
    series_set_si(&e->v_at_first, 0);
    series_set_si(&e->v_at_last, 0);
  }
  put_modes(e->modes, e->modes + sizeof e->modes, b, p->kind);
  return true;
}

/* Sets kappa x^power: eps in units of the phase or the period, x being T or T^2. */
static void set_eps(struct series *eps, const struct scallop_rational_crawler *crawler, slong power)
{
  SCOPED(fmpq, kappa);
  set_kappa(kappa, crawler);
  series_set_rational(eps, kappa);
  series_shift(eps, eps, power);
}

enum scallop_status scallop_expand_phase(const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind,
                                         const fmpq_t v0, slong order, slong precision, const fmpq_t pi_squared,
                                         struct scallop_expansion *expansion, const char **why)
{
  SCOPED(phase_constants, p);
  SCOPED(phase_series, in_series);
  SCOPED(branch, b);
  SCOPED(fmpq, start);
  SCOPED(series, c, eps, velocity);
  const char *none = branch_of_phase(&b, &p, crawler, kind, v0, order, precision);
  if (none)
    return refused_for(SCALLOP_EDOMAIN, none, why);
  const struct ring ring = { order + 2, precision }; /* formulas may divide by times, of order T or T^3 */
  phase_series_set(&in_series, &p, crawler->L);
  in_series.pi_squared = pi_squared;
  fmpq_div(start, v0, crawler->L); /* c at the start is v0 T/L */
  series_set_rational(&c, start);
  series_shift(&c, &c, 1);
  set_eps(&eps, crawler, 2);
  series_set_rational(&velocity, v0);
  return expand_branch(expansion, &b, &in_series, &c, &eps, &velocity, &ring)
             ? SCALLOP_OK
             : refused_for(SCALLOP_EDOMAIN, branch_without_ends, why);
}

/* Converts a series in T^2 and units of `unit` to a series in T, times T^power. */
static void in_period(struct series *to, const struct series *from, const fmpq_t unit, slong power,
                      const struct ring *ring)
{
  const struct ring longer = { 2 * ring->length, ring->precision };
  series_inflate(to, from, 2);
  series_scale(to, to, unit, &longer);
  series_shift(to, to, power);
}

/* Uses the symmetries (docs/background/theory.md): balls around 0 become 0. */
static void use_symmetries(struct series *travel, struct series *work, const struct limit *l, slong terms)
{
  for (slong k = 0; k < terms; k++) {
    if (l->returns || (l->even && k % 2 == 1))
      series_set_zero(travel, k);
    if (l->even && k % 2 == 1)
      series_set_zero(work, k);
  }
}

enum scallop_status scallop_expand_steady(const struct scallop_rational_crawler *crawler, slong order, slong precision,
                                          struct scallop_expansion *e, const char **why)
{
  const char *none = not_expandable(crawler, order, precision);
  if (none)
    return refused_for(SCALLOP_EDOMAIN, none, why);
  const struct ring ring = { order / 2 + 2, precision };
  SCOPED(fmpq, energy);
  SCOPED(limit, l);
  SCOPED(steady_lift, s);
  SCOPED(series, eps, work);
  set_eps(&eps, crawler, 1); /* the variable is T^2 here */
  enum scallop_status status = limit_find(&l, crawler, precision, why);
  if (status != SCALLOP_OK)
    return status;
  if (!l.at_rest && !steady_lift(&s, &l, NULL, &eps, &ring)) /* GCOVR_EXCL_LINE: if rounding spoils the proof */
    return refused_for(SCALLOP_EUNDECIDED, "a crossing is not transversal", why); /* GCOVR_EXCL_LINE */
  forget(e);
  steady_friction_work(&work, &l, &s, &eps, &ring);
  use_symmetries(&s.travel, &work, &l, ring.length);
  fmpq_add(energy, crawler->F1, crawler->F2);
  fmpq_mul(energy, energy, crawler->L);
  in_period(&e->friction_work, &work, energy, 0, &ring);
  in_period(&e->v_start, &s.w, crawler->L, -1, &ring);
  in_period(&e->v_mid, &s.w_mid, crawler->L, -1, &ring);
  in_period(&e->displacement, &s.travel, crawler->L, 0, &ring);
  series_shift(&e->mean_velocity, &e->displacement, -1);
  const char *end = e->modes + sizeof e->modes;
  char *at = put_modes(e->modes, end, &l.branch[0], SCALLOP_EXTENSION);
  at += snprintf(at, (size_t)(end - at), " | ");
  put_modes(at, end, &l.branch[1], SCALLOP_CONTRACTION);
  return SCALLOP_OK;
}
