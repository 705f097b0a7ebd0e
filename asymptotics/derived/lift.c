/* A branch as power series: every crossing by Newton's method in truncated series arithmetic. */
#include "asymptotics/derived/branch.h"

#include "asymptotics/derived/evaluate.h"
#include "asymptotics/derived/scoped.h"

void of_crossings_init(struct of_crossings *s)
{
  for (int i = 0; i < MOST_CROSSINGS; i++)
    series_init(&s->at[i]);
}

void of_crossings_clear(struct of_crossings *s)
{
  for (int i = 0; i < MOST_CROSSINGS; i++)
    series_clear(&s->at[i]);
}

void phase_series_set(struct phase_series *to, const struct phase_constants *from, const fmpq_t L)
{
  to->kind = from->kind;
  to->has_laws = false;
  to->pi_squared = NULL;
  series_set_rational(&to->fraction, from->fraction);
  for (int i = 0; i < 2; i++)
    series_set_rational(&to->curve[i], from->curve[i]);
  for (int i = 0; i < 3; i++)
    series_set_rational(&to->beta[i], from->beta[i]);
  series_set_si(&to->whole, 1);
  series_set_rational(&to->unit, L);
}

/* A line c = a + b s up to the next crossing; a_slope is the derivative of a, as c_slope in lift_phase is that of c. */
struct line {
  struct series a, a_slope, b;
};
#define LINE(of) of(series, &s->a) of(series, &s->a_slope) of(series, &s->b)
SCOPED_PARTS(line, struct line, LINE)

/* A curve q |l'| near a crossing. Exact: as series in the time since the base point, with its derivative. */
struct curve {
  const struct crossing *at;
  const struct series *q;
  bool exact;
  struct series value, rate;
};
#define CURVE(of) of(series, &s->value) of(series, &s->rate)
SCOPED_PARTS(curve, struct curve, CURVE)

static void curve_at(struct curve *curve, const struct branch *b, int i, const struct phase_series *p,
                     const struct ring *ring)
{
  const struct crossing *at = &b->crossing[i];
  const struct ring longer = { ring->length + 1, ring->precision }; /* one more, for the derivative */
  SCOPED(fmpq, u);
  curve->at = at;
  curve->q = &p->curve[at->curve];
  if (p->has_laws)
    series_set(&curve->value, &p->law.at[i]);
  curve->exact = p->has_laws
                 || (series_rational_coefficient(u, &at->offset, 0)
                     && scallop_exact_speed_series(&curve->value, at->piece, u, p->pi_squared, &longer));
  if (curve->exact) {
    series_mul(&curve->value, &curve->value, curve->q, &longer);
    series_derivative(&curve->rate, &curve->value, ring);
  }
}

/* Computes the curve and its derivative at time x after the base point, x a series. */
static void curve_along(struct series *value, struct series *rate, const struct curve *curve, const struct series *x,
                        const struct ring *ring)
{
  if (curve->exact && x->kind != SERIES_BALLS) {
    series_compose(value, &curve->value, x, ring);
    series_compose(rate, &curve->rate, x, ring);
    return;
  }
  SCOPED(arb, u);
  SCOPED(arb_poly, time, speed, slope);
  series_coefficient(u, &curve->at->offset, 0, ring->precision);
  series_get_ball_poly(time, x, ring->length, ring->precision);
  scallop_ball_speed_along(speed, slope, curve->at->piece, u, time, ring->length, ring->precision);
  series_set_ball_poly(value, speed, ring->length < x->known ? ring->length : x->known);
  series_set_ball_poly(rate, slope, value->known);
  series_mul(value, value, curve->q, ring);
  series_mul(rate, rate, curve->q, ring);
}

struct intersection { /* intersection of a curve and a line within balls */
  const struct scallop_piece *piece;
  fmpq_t q;
  arb_t a, b;
};
#define MEETING(of) of(fmpq, s->q) of(arb, s->a) of(arb, s->b)
SCOPED_PARTS(meeting, struct intersection, MEETING)

static bool gap_of(arb_t gap, arb_t slope, const arb_t u, void *meeting, slong precision)
{
  const struct intersection *m = meeting;
  gap_at(gap, slope, m->piece, m->q, m->a, m->b, u, precision);
  return true;
}

/* Encloses a crossing: at->offset, before only near it, becomes a ball that contains the crossing for all lines in
 * `line`; if same, the ball also contains the offset given. */
static bool enclose(struct crossing *at, const struct series *curve, const struct line *line, bool same,
                    slong precision)
{
  SCOPED(meeting, m);
  SCOPED(arb, given, u);
  m.piece = at->piece;
  series_rational_coefficient(m.q, curve, 0);
  series_coefficient(m.a, &line->a, 0, precision);
  series_coefficient(m.b, &line->b, 0, precision);
  series_coefficient(given, &at->offset, 0, precision);
  arb_set(u, given);
  bool found = enclose_root(u, gap_of, &m, same ? given : NULL, precision);
  if (found)
    series_set_ball(&at->offset, u);
  return found;
}

/* Computes the time of the base point since the start of the phase. */
static void base_time(struct series *time, const struct crossing *at, const struct ring *ring)
{
  series_set(time, &at->offset);
  if (at->piece->anchor == SCALLOP_FROM_END) {
    SCOPED(series, one);
    series_set_si(&one, 1);
    series_sub(time, &one, time, ring);
  }
}

/* Solves curve(x) = line(base + x) with x = 0 at the base point. closing: curve'(x) - b there. */
static bool solve_crossing(struct series *x, struct series *closing, const struct curve *curve, const struct line *line,
                           const struct series *base, const struct ring *ring)
{
  bool solved = true, last = false;
  SCOPED(series, gap, term);
  series_set_si(x, 0);
  for (slong length = 2; solved && !last; length *= 2) {
    last = length >= ring->length;
    struct ring part = { last ? ring->length : length, ring->precision };
    x->known = SERIES_ALL; /* a polynomial that is correct up to half of this length */
    curve_along(&gap, closing, curve, x, &part);
    series_add(&term, base, x, &part);
    series_mul(&term, &term, &line->b, &part);
    series_add(&term, &term, &line->a, &part);
    series_sub(&gap, &gap, &term, &part);
    for (slong k = 0; gap.kind == SERIES_BALLS && k < length / 2;
         k++) /* x solves the equation up to here, whatever its balls are */
      series_set_zero(&gap, k);
    series_sub(closing, closing, &line->b, &part);
    solved = series_div(&gap, &gap, closing, &part);
    series_sub(x, x, &gap, &part);
  }
  series_truncate(x, ring->length);
  return solved;
}

/* Solves curve'(x) = b: there the line leaves the curve. way: the integral of the curve up to x. */
static bool leave_curve(struct series *x, struct line *line, struct series *way, const struct curve *curve,
                        const struct ring *ring)
{
  const struct ring longer = { ring->length + 1, ring->precision };
  bool solved = curve->exact, last = false;
  SCOPED(series, bend, gap, slope);
  series_set_si(x, 0);
  if (solved)
    series_derivative(&bend, &curve->rate, ring);
  for (slong length = 2; solved && !last; length *= 2) {
    last = length >= ring->length;
    const struct ring part = { last ? ring->length : length, ring->precision };
    x->known = SERIES_ALL;
    series_compose(&gap, &curve->rate, x, &part);
    series_sub(&gap, &gap, &line->b, &part);
    series_compose(&slope, &bend, x, &part);
    solved = series_div(&gap, &gap, &slope, &part);
    series_sub(x, x, &gap, &part);
  }
  if (solved) {
    series_truncate(x, ring->length);
    series_mul(&gap, &line->b, x, ring);
    series_compose(&line->a, &curve->value, x, ring);
    series_sub(&line->a, &line->a, &gap, ring);
    series_set_si(&line->a_slope, 0);
    series_integral(way, &curve->value, &longer);
    series_compose(way, way, x, ring);
  }
  return solved;
}

/* Computes the integral of c from s to t: a (t - s) + b (t^2 - s^2)/2. */
static void travel_between(struct series *way, const struct line *line, const struct series *s, const struct series *t,
                           const struct ring *ring)
{
  SCOPED(fmpq, half);
  fmpq_set_si(half, 1, 2);
  SCOPED(series, duration, middle);
  series_sub(&duration, t, s, ring);
  series_add(&middle, t, s, ring);
  series_mul(&middle, &middle, &line->b, ring);
  series_scale(&middle, &middle, half, ring);
  series_add(&middle, &middle, &line->a, ring);
  series_mul(way, &duration, &middle, ring);
}

/* Changes from region r to region `to` at time s: adds (beta[r] - beta[to]) s to the balance, eps times this to a, and
 * their derivatives to balance_slope and a_slope. */
static void change_region(struct lift *l, struct line *line, const struct phase_series *p, int r, int to,
                          const struct series *eps, const struct series *s, const struct series *s_slope,
                          const struct ring *ring)
{
  SCOPED(series, drop, term, change);
  series_sub(&drop, &p->beta[r], &p->beta[to], ring);
  series_mul(&term, s, &drop, ring);
  series_add(&l->balance, &l->balance, &term, ring);
  series_mul(&change, &term, eps, ring);
  series_add(&line->a, &line->a, &change, ring);
  series_mul(&term, s_slope, &drop, ring);
  series_add(&l->balance_slope, &l->balance_slope, &term, ring);
  series_mul(&change, &term, eps, ring);
  series_add(&line->a_slope, &line->a_slope, &change, ring);
  series_mul(&line->b, eps, &p->beta[to], ring);
}

static void set_time(struct lift *l, int i, const struct series *base, const struct series *x, const struct ring *ring)
{
  SCOPED(series, one);
  series_set_si(&one, 1);
  series_add(&l->when.at[i], base, x, ring);
  series_sub(&l->left.at[i], &one, base, ring); /* first: an exact 1 - 1 is 0 */
  series_sub(&l->left.at[i], &l->left.at[i], x, ring);
}

static void finish(struct lift *l, const struct line *line, const struct phase_series *p, int region,
                   const struct series *since, const struct ring *ring)
{
  SCOPED(series, one);
  series_set_si(&one, 1);
  travel_between(&l->c_end, line, since, &one, ring);
  series_add(&l->travel, &l->travel, &l->c_end, ring);
  series_add(&l->c_end, &line->a, &line->b, ring);
  series_set(&l->c_end_slope, &line->a_slope);
  series_add(&l->balance, &l->balance, &p->beta[region], ring);
}

bool lift_phase(struct lift *l, struct branch *b, const struct phase_series *p, const struct series *eps,
                const struct series *c, const struct series *c_slope, enum crossings crossings, const struct ring *ring)
{
  /* times enter c multiplied by eps, and the displacements by c: if both begin later, one term fewer contributes, and
   * the last one is the largest in names */
  const struct ring of_times = { ring->length - (p->has_laws && eps->first > 1 && ring->length > 1), ring->precision };
  SCOPED(curve, curve);
  SCOPED(line, line);
  SCOPED(series, x, closing, base, since);
  series_set(&line.a, c);
  series_set(&line.a_slope, c_slope);
  series_mul(&line.b, eps, &p->beta[b->first_region], ring);
  series_set_si(&since, 0);
  series_set_si(&l->balance, 0);
  series_set_si(&l->balance_slope, 0);
  series_set_si(&l->travel, 0);
  for (int i = 0; i < b->count; i++) {
    struct crossing *at = &b->crossing[i];
    const struct ring *of_crossing = at->tangent ? ring : &of_times; /* at a tangent, c itself changes */
    if (crossings != CROSSINGS_KNOWN
        && !enclose(at, &p->curve[at->curve], &line, crossings == CROSSINGS_THE_SAME, ring->precision))
      return false;
    curve_at(&curve, b, i, p, of_crossing);
    base_time(&base, at, ring);
    if (at->tangent) {
      if (!leave_curve(&x, &line, &l->travel_to.at[i], &curve, of_crossing))
        return false; /* GCOVR_EXCL_LINE: balls too wide */
      series_set_si(&closing, 0);
    } else if (!solve_crossing(&x, &closing, &curve, &line, &base, of_crossing)
               || !series_div(&closing, &line.a_slope, &closing, ring)) /* d(time)/d(unknown) */
      return false;
    set_time(l, i, &base, &x, ring);
    if (!at->tangent)
      travel_between(&l->travel_to.at[i], &line, &since, &l->when.at[i], ring);
    series_add(&l->travel, &l->travel, &l->travel_to.at[i], ring);
    series_set(&l->travel_to.at[i], &l->travel);
    series_set(&since, &l->when.at[i]);
    change_region(l, &line, p, branch_region(b, i), at->to, eps, &since, &closing, ring);
  }
  finish(l, &line, p, branch_region(b, b->count), &since, ring);
  return true;
}
