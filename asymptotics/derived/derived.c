/* The expansions of derived.h: a phase or the steady state around T = 0, from the branch that its limit begins. */
#include "asymptotics/derived/derived.h"

#include <stdio.h>
#include <string.h>

#include "asymptotics/derived/evaluate.h"
#include "asymptotics/derived/limit.h"
#include "asymptotics/derived/scoped.h"

static void modes_text(char *text, size_t size, const struct branch *b, enum scallop_phase_kind kind)
{
  static const char *const names[2][3] = { { "++", "-+", "--" }, { "++", "+-", "--" } };
  static const char *const held[2][2] = { { "0+", "-0" }, { "+0", "0-" } };
  size_t at = 0;
  for (int i = 0; i <= b->count && at < size; i++) {
    const struct crossing *next = i < b->count ? &b->crossing[i] : NULL;
    const char *mode = next && next->tangent ? held[kind][next->curve] : names[kind][branch_region(b, i)];
    at += (size_t)snprintf(text + at, size - at, "%s%s", i ? " " : "", mode);
  }
}

/* |way| of the separation from the start of the phase to a crossing at offset 0 of its piece: the integral of |l'| */
static void way_to(struct series *way, const struct lift *l, int i, const struct branch *b,
                   const struct phase_series *p, const fmpq_t pi_squared, const struct ring *ring)
{
  const struct scallop_piece *piece = b->crossing[i].piece;
  SCOPED(series, speed);
  if (p->has_laws)
    series_set(&speed, &p->law.at[i]);
  else
    scallop_speed_series(&speed, piece, pi_squared, ring);
  series_integral(&speed, &speed, ring);
  if (piece->anchor == SCALLOP_FROM_END) { /* times are measured from the end: minus what is left */
    series_neg(way, &l->left.at[i]);
    series_compose(way, &speed, way, ring);
    series_add(way, way, &p->whole, ring);
  } else
    series_compose(way, &speed, &l->when.at[i], ring);
}

/* unit (travel - share way): a point at that share goes back while the separation grows by way */
static void position(struct series *to, const struct series *travel, const struct series *share,
                     const struct series *way, const struct phase_series *p, const struct ring *ring)
{
  SCOPED(series, back);
  series_mul(&back, way, share, ring);
  series_sub(to, travel, &back, ring);
  series_mul(to, to, &p->unit, ring);
}

/* The rear body's, and that of its counterpart in a contraction */
static void rear_position(struct series *to, const struct lift *l, int i, const struct branch *b,
                          const struct phase_series *p, const fmpq_t pi_squared, const struct ring *ring)
{
  SCOPED(series, way);
  way_to(&way, l, i, b, p, pi_squared, ring);
  position(to, &l->travel_to.at[i], &p->curve[0], &way, p, ring);
}

static void displacements(struct scallop_phase_expansion *e, const struct lift *l, const struct phase_series *p,
                          const struct ring *ring)
{
  bool extension = p->kind == SCALLOP_EXTENSION;
  SCOPED(series, centre);
  SCOPED(fmpq, half);
  fmpq_set_si(half, 1, 2);
  series_add(&centre, &p->curve[0], &p->curve[1], ring);
  series_scale(&centre, &centre, half, ring);
  position(extension ? &e->dx1 : &e->dx2, &l->travel, &p->curve[0], &p->whole, p, ring);
  position(extension ? &e->dx2 : &e->dx1, &l->travel, &p->curve[1], &p->whole, p, ring);
  position(&e->dxC, &l->travel, &centre, &p->whole, p, ring);
}

/* c at the start is v0 T/L and eps is T^2 (F1 + F2)/(M L), both in units of the phase. */
static void start_series(struct series *c, struct series *eps, const struct scallop_rational_crawler *crawler,
                         const fmpq_t v0, const struct ring *ring)
{
  SCOPED(fmpq, q, M);
  series_set_x(c);
  fmpq_div(q, v0, crawler->L);
  series_scale(c, c, q, ring);
  series_set_x(eps);
  series_shift(eps, eps, 1);
  fmpq_add(M, crawler->m1, crawler->m2);
  fmpq_add(q, crawler->F1, crawler->F2);
  fmpq_div(q, q, M);
  fmpq_div(q, q, crawler->L);
  series_scale(eps, eps, q, ring);
}

bool expand_branch(struct scallop_phase_expansion *e, const struct branch *b, const struct phase_series *p,
                   const struct series *c, const struct series *eps, const fmpq_t pi_squared, const struct ring *ring)
{
  SCOPED(lift, l);
  SCOPED(series, none);
  bool lifted = lift_phase(&l, b, p, eps, c, &none, pi_squared, ring);
  if (lifted) {
    int last = b->count - 1;
    e->switches = b->count > 0;
    displacements(e, &l, p, ring);
    series_mul(&e->v_end, &l.c_end, &p->unit, ring);
    series_shift(&e->v_end, &e->v_end, -1);
    if (e->switches) {
      series_shift(&e->t1, &l.when.at[0], 1);
      series_shift(&e->dT, &l.left.at[last], 1);
      rear_position(&e->at_first, &l, 0, b, p, pi_squared, ring);
      rear_position(&e->at_last, &l, last, b, p, pi_squared, ring);
    }
    modes_text(e->modes, sizeof e->modes, b, p->kind);
  }
  return lifted;
}

static enum scallop_status refuse(const char **why, const char *reason)
{
  if (why)
    *why = reason;
  return SCALLOP_EDOMAIN;
}

static enum scallop_status check(const struct scallop_rational_crawler *crawler, slong order, slong precision,
                                 const char **why)
{
  if (!scallop_rational_is_valid(crawler))
    return refuse(why, "a parameter is outside its domain");
  if (order < 1 || order > SCALLOP_MOST_TERMS)
    return refuse(why, "the order is outside of 1 to 1000");
  if (precision < 16)
    return refuse(why, "fewer than 16 bits");
  if (!scallop_gait_is_exact(crawler->gait))
    return refuse(why, "the gait has no exact law");
  return branch_is_possible(crawler->gait) ? SCALLOP_OK : refuse(why, branch_impossible);
}

enum scallop_status scallop_expand_phase(const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind,
                                         const fmpq_t v0, slong order, slong precision, const fmpq_t pi_squared,
                                         struct scallop_phase_expansion *expansion, const char **why)
{
  enum scallop_status status = check(crawler, order, precision, why);
  if (status != SCALLOP_OK)
    return status;
  const struct ring ring = { order + 2, precision }; /* formulas may divide by times, which begin with T or T^3 */
  ENDED_BY(phase_constants_clear) struct phase_constants p;
  phase_constants_init(&p, crawler, kind);
  SCOPED(phase_series, in_series);
  phase_series_set(&in_series, &p, crawler->L);
  ENDED_BY(branch_clear) struct branch b;
  branch_init(&b);
  SCOPED(series, c, eps);
  start_series(&c, &eps, crawler, v0, &ring);
  int at_start = fmpq_sgn(v0), at_end = at_start != 0 ? at_start : fmpq_sgn(p.beta[1]);
  if (!branch_from_ends(&b, &p, at_start, at_end)
      || !expand_branch(expansion, &b, &in_series, &c, &eps, pi_squared, &ring))
    status = refuse(why, branch_without_ends);
  return status;
}

/* From a series in T^2 and units of L to one in T, times T^power */
static void in_period(struct series *to, const struct series *from, const fmpq_t L, slong power,
                      const struct ring *ring)
{
  const struct ring longer = { 2 * ring->length, ring->precision };
  series_inflate(to, from, 2);
  series_scale(to, to, L, &longer);
  series_shift(to, to, power);
}

/* What the symmetries say of the displacement (docs/theory.md): balls around 0 become 0. */
static void use_symmetries(struct series *travel, const struct limit *l, slong terms)
{
  for (slong k = 0; k < terms; k++)
    if (l->returns || (l->even && k % 2 == 1))
      series_set_zero(travel, k);
}

static void set_eps(struct series *eps, const struct scallop_rational_crawler *crawler, const struct ring *ring)
{
  SCOPED(fmpq, zero);
  SCOPED(series, unused);
  start_series(&unused, eps, crawler, zero, ring); /* kappa T^2 */
  series_shift(eps, eps, -1);                      /* the variable is T^2 here */
}

enum scallop_status scallop_expand_steady(const struct scallop_rational_crawler *crawler, slong order, slong precision,
                                          struct scallop_steady_expansion *e, const char **why)
{
  const char *reason = NULL;
  enum scallop_status status = check(crawler, order, precision, why);
  if (status != SCALLOP_OK)
    return status;
  const struct ring ring = { order / 2 + 2, precision };
  SCOPED(fmpq, energy);
  ENDED_BY(limit_clear) struct limit l;
  limit_init(&l, crawler);
  SCOPED(steady_lift, s);
  SCOPED(series, eps);
  set_eps(&eps, crawler, &ring);
  status = limit_find(&l, crawler, precision, &reason);
  if (status == SCALLOP_OK && !l.at_rest && !steady_lift(&s, &l, &eps, &ring)) {
    status = SCALLOP_EUNDECIDED;              /* GCOVR_EXCL_LINE: only if rounding undoes what limit_find has shown */
    reason = "a crossing is not transversal"; /* GCOVR_EXCL_LINE */
  }
  if (status == SCALLOP_OK) {
    char modes[2][SCALLOP_BRANCH_TEXT - 2];
    use_symmetries(&s.travel, &l, ring.length);
    in_period(&e->v_start, &s.w, crawler->L, -1, &ring);
    in_period(&e->v_mid, &s.w_mid, crawler->L, -1, &ring);
    in_period(&e->displacement, &s.travel, crawler->L, 0, &ring);
    series_shift(&e->mean_velocity, &e->displacement, -1);
    fmpq_add(energy, crawler->F1, crawler->F2);
    fmpq_mul(energy, energy, crawler->L);
    steady_friction_work(&e->friction_work, &l, &s, &eps, &ring);
    for (slong k = 1; l.even && k < ring.length; k += 2)
      series_set_zero(&e->friction_work, k);
    in_period(&e->friction_work, &e->friction_work, energy, 0, &ring);
    for (int k = 0; k < 2; k++)
      modes_text(modes[k], sizeof modes[k], &l.branch[k], (enum scallop_phase_kind)k);
    snprintf(e->modes, sizeof e->modes, "%s | %s", modes[0], modes[1]);
  } else if (why)
    *why = reason;
  return status;
}

/* Does the quantity belong to a change of mode? */
static bool is_of_switch(enum scallop_quantity quantity)
{
  switch (quantity) {
  case SCALLOP_LAG:
  case SCALLOP_FIRST_SWITCH:
  case SCALLOP_REAR_AT_FIRST:
  case SCALLOP_REAR_AT_LAST:
  case SCALLOP_VELOCITY_AT_FIRST:
  case SCALLOP_VELOCITY_AT_LAST: return true;
  default: return false;
  }
}

const struct series *scallop_phase_quantity(const struct scallop_phase_expansion *e, enum scallop_phase_kind kind,
                                            enum scallop_quantity quantity)
{
  bool extension = kind == SCALLOP_EXTENSION;
  if (!e->switches && is_of_switch(quantity))
    return NULL;
  switch (quantity) {
  case SCALLOP_LAG: return &e->dT;
  case SCALLOP_FIRST_SWITCH: return &e->t1;
  case SCALLOP_REAR_AT_FIRST: return &e->at_first;
  case SCALLOP_REAR_AT_LAST: return &e->at_last;
  case SCALLOP_REAR_AT_END: return extension ? &e->dx1 : &e->dx2;
  case SCALLOP_FRONT_AT_END: return extension ? &e->dx2 : &e->dx1;
  case SCALLOP_CENTRE_AT_END: return &e->dxC;
  case SCALLOP_VELOCITY_AT_END:
  case SCALLOP_VELOCITY_CHANGE: return &e->v_end;
  case SCALLOP_VELOCITY_AT_FIRST:
  case SCALLOP_VELOCITY_AT_LAST: return &e->turning_velocity;
  default: return NULL;
  }
}

const struct series *scallop_steady_quantity(const struct scallop_steady_expansion *e, enum scallop_quantity quantity)
{
  switch (quantity) {
  case SCALLOP_STEADY_VELOCITY: return &e->v_start;
  case SCALLOP_STEADY_V_MID: return &e->v_mid;
  case SCALLOP_STEADY_DISPLACEMENT: return &e->displacement;
  case SCALLOP_STEADY_MEAN_VELOCITY: return &e->mean_velocity;
  case SCALLOP_STEADY_FRICTION_WORK: return &e->friction_work;
  default: return NULL;
  }
}
