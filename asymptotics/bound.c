/* Error bounds of the steady state's series: Taylor's theorem with the remainder in Lagrange's form, the last
 * coefficient enclosed for every eps between 0 and eps0. That the motion has the branch's modes all the way is
 * proven interval by interval; the steady state is unique (docs/theory.md), so it is this one. */
#include "asymptotics/derived.h"

#include <stddef.h>

#include "asymptotics/limit.h"

void scallop_bound_init(struct scallop_bound *b)
{
  arb_init(b->C);
  arb_init(b->T0);
  arb_init(b->T_end);
  b->power = 0;
  b->ends = NULL;
}

void scallop_bound_clear(struct scallop_bound *b)
{
  arb_clear(b->C);
  arb_clear(b->T0);
  arb_clear(b->T_end);
}

/* ---- the modes are those of the branch ---- */

struct segment { /* c = a + b s in one region of one phase                                    */
  const struct phase_constants *p;
  int region;
  arb_t a, b;
  slong precision;
};

/* How far c is inside the region from curve j at offset u, and the derivative of that by u */
static void room(arb_t gap, arb_t slope, const struct segment *g, const struct scallop_piece *piece, int j, const arb_t u)
{
  slong precision = g->precision;
  bool forward = piece->anchor == SCALLOP_FROM_START;
  arb_t term;
  arb_init(term);
  if (forward)
    arb_set(term, u);
  else
    arb_sub_si(term, u, 1, precision), arb_neg(term, term);
  arb_mul(gap, g->b, term, precision);
  arb_add(gap, gap, g->a, precision);
  scallop_ball_speed(term, piece, u, precision);
  arb_mul_fmpz(term, term, fmpq_numref(g->p->curve[j]), precision);
  arb_div_fmpz(term, term, fmpq_denref(g->p->curve[j]), precision);
  arb_sub(gap, gap, term, precision);
  scallop_ball_rate(slope, piece, u, precision);
  arb_mul_fmpz(slope, slope, fmpq_numref(g->p->curve[j]), precision);
  arb_div_fmpz(slope, slope, fmpq_denref(g->p->curve[j]), precision);
  arb_sub(slope, g->b, slope, precision);
  if (!forward)
    arb_neg(slope, slope);
  if (g->region > j) { /* below it */
    arb_neg(gap, gap);
    arb_neg(slope, slope);
  }
  arb_clear(term);
}

/* c keeps off curve j between offsets lo and hi; it touches it, transversally, within the end whose flag is set. */
static bool keeps_off(const struct segment *g, const struct scallop_piece *piece, int j, const arf_t lo, const arf_t hi,
                      bool touches_lo, bool touches_hi, int depth)
{
  arb_t u, gap, slope;
  arf_t middle;
  arb_init(u);
  arb_init(gap);
  arb_init(slope);
  arf_init(middle);
  arb_set_interval_arf(u, lo, hi, g->precision);
  room(gap, slope, g, piece, j, u);
  bool off = arb_is_positive(gap) || (touches_lo && !touches_hi && arb_is_positive(slope))
             || (touches_hi && !touches_lo && arb_is_negative(slope));
  if (!off && depth > 0) {
    arf_add(middle, lo, hi, ARF_PREC_EXACT, ARF_RND_DOWN);
    arf_mul_2exp_si(middle, middle, -1);
    off = keeps_off(g, piece, j, lo, middle, touches_lo, false, depth - 1)
          && keeps_off(g, piece, j, middle, hi, false, touches_hi, depth - 1);
  }
  arb_clear(u);
  arb_clear(gap);
  arb_clear(slope);
  arf_clear(middle);
  return off;
}

/* One end of a segment: a crossing, or an end of the phase (curve -1) */
struct edge {
  int curve;
  int piece;    /* its index                                                                    */
  arb_t offset; /* in that piece                                                                */
};

static void edge_at_end(struct edge *e, int piece, double offset)
{
  e->curve = -1;
  e->piece = piece;
  arb_set_d(e->offset, offset);
}

/* Where a crossing is by now: a crossing may have moved on into the next piece, or back, if l' has no corner there. */
static void edge_at_crossing(struct edge *e, const struct crossing *at, const struct phase_constants *p, slong precision)
{
  const struct scallop_shape *shape = p->shape;
  e->curve = at->curve;
  e->piece = (int)(at->piece - shape->pieces);
  series_coefficient(e->offset, &at->offset, 0, precision);
  for (int moved = 1; moved != 0;) {
    const struct scallop_piece *piece = &shape->pieces[e->piece];
    double u = arf_get_d(arb_midref(e->offset), ARF_RND_NEAR), sense = piece->anchor == SCALLOP_FROM_START ? 1 : -1;
    bool goes_on = false, turns = false;
    moved = sense * (u - piece->end) > 0 ? 1 : sense * (piece->begin - u) > 0 ? -1 : 0;
    if (moved > 0 && e->piece + 1 < shape->count)
      goes_on = scallop_piece_goes_on(piece, piece + 1, &turns);
    else if (moved < 0 && e->piece > 0)
      goes_on = scallop_piece_goes_on(piece - 1, piece, &turns);
    if (!goes_on)
      return;
    e->piece += moved;
    if (turns)
      arb_sub_si(e->offset, e->offset, 1, precision), arb_neg(e->offset, e->offset);
  }
}

/* The segment between two edges keeps off the curves of its region. */
static bool segment_is_clear(const struct segment *g, const struct edge *from, const struct edge *to)
{
  enum { DEPTH = 30 };
  bool clear = true;
  arf_t early, late;
  arf_init(early);
  arf_init(late);
  for (int i = from->piece; clear && i <= to->piece; i++) {
    const struct scallop_piece *piece = &g->p->shape->pieces[i];
    bool forward = piece->anchor == SCALLOP_FROM_START;
    arf_set_d(early, piece->begin);
    arf_set_d(late, piece->end);
    if (i == from->piece)
      (forward ? arb_get_lbound_arf : arb_get_ubound_arf)(early, from->offset, g->precision);
    if (i == to->piece)
      (forward ? arb_get_ubound_arf : arb_get_lbound_arf)(late, to->offset, g->precision);
    for (int j = g->region == 2 ? 1 : 0; clear && j <= (g->region == 0 ? 0 : 1); j++) {
      bool at_early = i == from->piece && from->curve == j, at_late = i == to->piece && to->curve == j;
      clear = keeps_off(g, piece, j, forward ? early : late, forward ? late : early, forward ? at_early : at_late,
                        forward ? at_late : at_early, DEPTH);
    }
  }
  arf_clear(early);
  arf_clear(late);
  return clear;
}

static const char *const sticks[2][2] = {
  { "body 1 comes to rest in the extension", "body 2 comes to rest in the extension" },
  { "body 2 comes to rest in the contraction", "body 1 comes to rest in the contraction" }
};
static const char *const grazes[2] = { "a body begins or ceases to turn in the extension",
                                       "a body begins or ceases to turn in the contraction" };
static const char *const starts[2] = { "the velocity at the start of the extension reaches 0",
                                       "the velocity at the start of the contraction reaches 0" };
static const char *const leaves[2] = { "a switching time of the extension reaches a corner of l'",
                                       "a switching time of the contraction reaches a corner of l'" };

/* The curve is crossed, not followed: its slope lies beyond those of c on both of its sides. And it happens in its piece. */
static const char *crossing_holds(const struct edge *at, const struct phase_constants *p, int from, int into,
                                  const arb_t eps, slong precision)
{
  const struct scallop_piece *piece = &p->shape->pieces[at->piece];
  const char *why = NULL;
  arb_t along, limit;
  arb_init(along);
  arb_init(limit);
  scallop_ball_rate(along, piece, at->offset, precision);
  arb_mul_fmpz(along, along, fmpq_numref(p->curve[at->curve]), precision);
  arb_div_fmpz(along, along, fmpq_denref(p->curve[at->curve]), precision);
  arb_set_fmpq(limit, p->beta[into], precision);
  arb_mul(limit, limit, eps, precision);
  arb_sub(along, along, limit, precision);
  if (!(from < into ? arb_is_positive(along) : arb_is_negative(along)))
    why = sticks[p->kind][at->curve];
  bool forward = piece->anchor == SCALLOP_FROM_START, goes_on = false, turned;
  if (at->piece + 1 < p->shape->count)
    goes_on = scallop_piece_goes_on(piece, piece + 1, &turned);
  arb_set_d(limit, piece->end);
  arb_sub(limit, limit, at->offset, precision);
  if (!goes_on && !(forward ? arb_is_nonnegative(limit) : arb_is_nonpositive(limit)))
    why = at->piece + 1 < p->shape->count ? leaves[p->kind] : starts[1 - p->kind]; /* where the other phase starts */
  goes_on = at->piece > 0 && scallop_piece_goes_on(piece - 1, piece, &turned);
  arb_set_d(limit, piece->begin);
  arb_sub(limit, at->offset, limit, precision);
  if (!goes_on && !(forward ? arb_is_nonnegative(limit) : arb_is_nonpositive(limit)))
    why = at->piece > 0 ? leaves[p->kind] : starts[p->kind];
  arb_clear(along);
  arb_clear(limit);
  return why;
}

/* The line after a crossing meets the one before it there. */
static void bend(struct segment *g, const struct crossing *at, const arb_t eps)
{
  slong precision = g->precision;
  arb_t s, b;
  arb_init(s);
  arb_init(b);
  series_coefficient(s, &at->offset, 0, precision);
  if (at->piece->anchor == SCALLOP_FROM_END)
    arb_sub_si(s, s, 1, precision), arb_neg(s, s);
  arb_set_fmpq(b, g->p->beta[at->to], precision);
  arb_mul(b, b, eps, precision);
  arb_sub(g->b, g->b, b, precision);
  arb_addmul(g->a, g->b, s, precision);
  arb_set(g->b, b);
  g->region = at->to;
  arb_clear(s);
  arb_clear(b);
}

/* NULL, or why the modes of the phase are not shown to be those of the branch. c: at its start; becomes that at its end. */
static const char *phase_holds(const struct branch *b, const struct phase_constants *p, const arb_t eps, arb_t c,
                               slong precision)
{
  const struct scallop_shape *shape = p->shape;
  struct segment g = { .p = p, .region = b->first_region, .precision = precision };
  struct edge from, to;
  const char *why = NULL;
  arb_init(g.a);
  arb_init(g.b);
  arb_init(from.offset);
  arb_init(to.offset);
  arb_set(g.a, c);
  arb_set_fmpq(g.b, p->beta[g.region], precision);
  arb_mul(g.b, g.b, eps, precision);
  if (g.region != 1 && !(g.region == 0 ? arb_is_positive(c) : arb_is_negative(c)))
    why = starts[p->kind];
  edge_at_end(&from, 0, shape->pieces[0].begin);
  for (int i = 0; !why && i < b->count; i++) {
    const struct crossing *at = &b->crossing[i];
    edge_at_crossing(&to, at, p, precision);
    why = crossing_holds(&to, p, g.region, at->to, eps, precision);
    if (!why && !segment_is_clear(&g, &from, &to))
      why = grazes[p->kind];
    bend(&g, at, eps);
    from.curve = to.curve;
    from.piece = to.piece;
    arb_set(from.offset, to.offset);
  }
  edge_at_end(&to, shape->count - 1, shape->pieces[shape->count - 1].end);
  if (!why && !segment_is_clear(&g, &from, &to))
    why = grazes[p->kind];
  arb_add(c, g.a, g.b, precision);
  arb_clear(g.a);
  arb_clear(g.b);
  arb_clear(from.offset);
  arb_clear(to.offset);
  return why;
}

static const char *period_holds(const struct limit *l, const arb_t w, const arb_t eps, slong precision)
{
  const char *why = NULL;
  arb_t c, here, fraction;
  arb_init(c);
  arb_init(here);
  arb_init(fraction);
  arb_set(c, w);
  for (int k = 0; !why && k < 2; k++) {
    arb_set_fmpq(fraction, l->phase[k].fraction, precision);
    arb_mul(here, eps, fraction, precision);
    arb_mul(here, here, fraction, precision);
    arb_mul(c, c, fraction, precision);
    why = phase_holds(&l->branch[k], &l->phase[k], here, c, precision);
    arb_div(c, c, fraction, precision);
  }
  arb_clear(c);
  arb_clear(here);
  arb_clear(fraction);
  return why;
}

/* ---- from eps = 0 on ---- */

static void copy_offsets(struct limit *to, const struct limit *from)
{
  for (int k = 0; k < 2; k++) {
    to->branch[k].count = from->branch[k].count;
    to->branch[k].first_region = from->branch[k].first_region;
    for (int i = 0; i < from->branch[k].count; i++) {
      to->branch[k].crossing[i].piece = from->branch[k].crossing[i].piece;
      to->branch[k].crossing[i].curve = from->branch[k].crossing[i].curve;
      to->branch[k].crossing[i].to = from->branch[k].crossing[i].to;
      series_set(&to->branch[k].crossing[i].offset, &from->branch[k].crossing[i].offset);
    }
  }
  series_set(&to->w, &from->w);
}

/* Follows the branch to every eps in the ball: crossings and w become enclosures. NULL, or why not. */
static const char *follow_to(struct limit *l, const arb_t eps, bool check_modes, slong precision)
{
  const char *why = "the steady state is not shown to be smooth in T";
  arb_t w;
  arb_init(w);
  series_coefficient(w, &l->w, 0, precision);
  if (limit_follow(l, w, eps, precision)) {
    series_set_ball(&l->w, w);
    why = check_modes ? period_holds(l, w, eps, precision) : NULL;
  }
  arb_clear(w);
  return why;
}

/* The largest eps, to a thousandth, up to which the modes are shown to be those of the branch; *ends: what happens there. */
static void find_end(arf_t end, const char **ends, const struct limit *from, const struct scallop_rational_crawler *crawler,
                     slong precision)
{
  enum { STEPS = 5000, FINEST = -10, SMALLEST = -400 };
  struct limit here, trial;
  arf_t step, next;
  arb_t eps;
  limit_init(&here, crawler);
  limit_init(&trial, crawler);
  arf_init(step);
  arf_init(next);
  arb_init(eps);
  copy_offsets(&here, from);
  arf_zero(end);
  arf_one(step);
  for (int i = 0; i < STEPS; i++) {
    arf_add(next, end, step, precision, ARF_RND_NEAR);
    arb_set_interval_arf(eps, end, next, precision);
    copy_offsets(&trial, &here);
    const char *why = follow_to(&trial, eps, true, precision);
    if (!why) {
      copy_offsets(&here, &trial);
      arf_set(end, next);
      arf_mul_2exp_si(step, step, 1);
      continue;
    }
    *ends = why;
    arf_mul_2exp_si(step, step, -1);
    if (arf_cmpabs_2exp_si(step, SMALLEST) < 0)
      break;
    arf_mul_2exp_si(next, end, FINEST);
    if (arf_cmp(step, next) < 0)
      break;
  }
  limit_clear(&here);
  limit_clear(&trial);
  arf_clear(step);
  arf_clear(next);
  arb_clear(eps);
}

struct cover {
  struct limit here; /* followed to where we are                                               */
  const slong *power;
  slong precision;
  arb_t most[2]; /* the largest |coefficient of x^power[i]| so far, of w and of the displacement over L */
};

enum { MORE = 8 }; /* further terms, by which a coefficient is carried from the middle of an interval to all of it */

static bool lift_at(struct cover *cover, struct steady_lift *lifted, const arb_t eps)
{
  slong n = cover->power[0] > cover->power[1] ? cover->power[0] : cover->power[1];
  const struct ring ring = { n + MORE + 1, cover->precision };
  struct series eps_series, x;
  series_init(&eps_series);
  series_init(&x);
  series_set_x(&x);
  series_set_ball(&eps_series, eps);
  series_add(&eps_series, &eps_series, &x, &ring);
  bool found = !follow_to(&cover->here, eps, false, cover->precision)
               && steady_lift(lifted, &cover->here, &eps_series, &ring);
  series_clear(&eps_series);
  series_clear(&x);
  return found;
}

/* The coefficient c_n at eps + h, |h| <= r: sum over k < MORE of binomial(n + k, n) c_(n+k) h^k, from the middle, and the last
 * term with c_(n+MORE) from anywhere in the interval. Its absolute value. */
static void carry(arb_t value, const struct series *middle, const struct series *all, slong n, const mag_t r,
                  slong precision)
{
  arb_t h, power, term;
  fmpz_t ways;
  fmpz_init(ways);
  arb_init(h);
  arb_init(power);
  arb_init(term);
  mag_set(arb_radref(h), r);
  arb_one(power);
  arb_zero(value);
  for (slong k = 0; k <= MORE; k++) {
    series_coefficient(term, k < MORE ? middle : all, n + k, precision);
    fmpz_bin_uiui(ways, (ulong)(n + k), (ulong)n);
    arb_mul_fmpz(term, term, ways, precision);
    arb_addmul(value, term, power, precision);
    arb_mul(power, power, h, precision);
  }
  arb_abs(value, value);
  fmpz_clear(ways);
  arb_clear(h);
  arb_clear(power);
  arb_clear(term);
}

/* The absolute values of the coefficients for every eps in the ball; false if the branch could not be followed there. */
static bool coefficients(struct cover *cover, arb_t value[2], const arb_t eps)
{
  struct steady_lift middle, all;
  arb_t point;
  steady_lift_init(&middle);
  steady_lift_init(&all);
  arb_init(point);
  arb_set_arf(point, arb_midref(eps));
  bool found = lift_at(cover, &middle, point) && lift_at(cover, &all, eps);
  for (int i = 0; found && i < 2; i++) {
    carry(value[i], i == 0 ? &middle.w : &middle.travel, i == 0 ? &all.w : &all.travel, cover->power[i], arb_radref(eps),
          cover->precision);
    found = arb_is_finite(value[i]);
  }
  steady_lift_clear(&middle);
  steady_lift_clear(&all);
  arb_clear(point);
  return found;
}

/* The values at a few points: less than the largest, and of its size. */
static void take_points(struct cover *cover, arb_t value[2], const arf_t end)
{
  enum { POINTS = 16 };
  arb_t eps;
  arb_init(eps);
  for (ulong i = 1; i <= POINTS; i++) {
    arf_mul_ui(arb_midref(eps), end, i, cover->precision, ARF_RND_DOWN);
    arf_mul_2exp_si(arb_midref(eps), arb_midref(eps), -4);
    if (coefficients(cover, value, eps))
      for (int k = 0; k < 2; k++)
        arb_max(cover->most[k], cover->most[k], value[k], cover->precision);
  }
  arb_clear(eps);
}

/* value <= 2 most, or it is nothing beside a function of size 1 on [0, end]: some coefficients vanish identically */
static bool is_tight(const arb_t value, const arb_t most, const arf_t end, slong n, slong precision)
{
  arb_t room, size;
  arb_init(room);
  arb_init(size);
  arb_mul_2exp_si(room, most, 1);
  arb_sub(room, room, value, precision);
  arb_set_arf(size, end);
  arb_pow_ui(size, size, (ulong)n, precision);
  arb_mul(size, size, value, precision);
  bool tight = arb_is_nonnegative(room)
               || (mag_cmp_2exp_si(arb_radref(size), -precision / 2) < 0
                   && arf_cmpabs_2exp_si(arb_midref(size), -precision / 2) < 0);
  arb_clear(room);
  arb_clear(size);
  return tight;
}

/* Covers [0, end] by intervals, which are halved while they are wide or their balls are: more than twice the value at points. */
static bool take_intervals(struct cover *cover, arb_t value[2], const arf_t end)
{
  enum { MOST = 6000, NARROW = -11 };
  arf_t lo, hi, step, narrow;
  arb_t eps;
  bool found = true;
  arf_init(lo);
  arf_init(hi);
  arf_init(step);
  arf_init(narrow);
  arb_init(eps);
  arf_mul_2exp_si(step, end, -4);
  arf_mul_2exp_si(narrow, end, NARROW);
  for (int i = 0; found && arf_cmp(lo, end) < 0; i++) {
    arf_add(hi, lo, step, cover->precision, ARF_RND_UP);
    arb_set_interval_arf(eps, lo, hi, cover->precision);
    bool followed = coefficients(cover, value, eps), tight = followed;
    for (int k = 0; k < 2; k++)
      tight = tight && is_tight(value[k], cover->most[k], end, cover->power[k], cover->precision);
    found = i < MOST;
    if (tight || (followed && arf_cmp(step, narrow) < 0)) {
      for (int k = 0; k < 2; k++)
        arb_max(cover->most[k], cover->most[k], value[k], cover->precision);
      arf_set(lo, hi);
      arf_mul_2exp_si(step, step, 1);
    } else
      arf_mul_2exp_si(step, step, -1);
  }
  arf_clear(lo);
  arf_clear(hi);
  arf_clear(step);
  arf_clear(narrow);
  arb_clear(eps);
  return found;
}

/* The largest |coefficient of x^power[i]| of w and of the displacement over L, for all eps in [0, end]: an upper bound. */
static bool largest_coefficients(arb_t most[2], const slong power[2], const arf_t end, const struct limit *from,
                                 const struct scallop_rational_crawler *crawler, slong precision)
{
  struct cover cover = { .power = power, .precision = precision };
  arb_t value[2];
  limit_init(&cover.here, crawler);
  for (int k = 0; k < 2; k++) {
    arb_init(value[k]);
    arb_init(cover.most[k]);
  }
  copy_offsets(&cover.here, from);
  take_points(&cover, value, end);
  copy_offsets(&cover.here, from);
  bool found = take_intervals(&cover, value, end);
  for (int k = 0; k < 2; k++) {
    arb_get_ubound_arf(arb_midref(most[k]), cover.most[k], precision);
    mag_zero(arb_radref(most[k]));
    arb_clear(value[k]);
    arb_clear(cover.most[k]);
  }
  limit_clear(&cover.here);
  return found;
}

/* ---- in units of the crawler ---- */

/* (F1 + F2)/(M L): eps / T^2 */
static void eps_over_T2(arb_t kappa, const struct scallop_rational_crawler *c, slong precision)
{
  fmpq_t q, M;
  fmpq_init(q);
  fmpq_init(M);
  fmpq_add(M, c->m1, c->m2);
  fmpq_add(q, c->F1, c->F2);
  fmpq_div(q, q, M);
  fmpq_div(q, q, c->L);
  arb_set_fmpq(kappa, q, precision);
  fmpq_clear(q);
  fmpq_clear(M);
}

static void time_of(arb_t T, const arf_t eps, const arb_t kappa, slong precision)
{
  arb_set_arf(T, eps);
  arb_div(T, T, kappa, precision);
  arb_sqrt(T, T, precision);
}

static enum scallop_status bounds_from(const struct limit *l, const struct scallop_rational_crawler *crawler, slong order,
                                       slong precision, struct scallop_bound bounds[2], const char **why)
{
  slong of_displacement = (order + 1) / 2;
  if (l->even)
    of_displacement += of_displacement % 2;
  const slong power[2] = { order / 2 + 1, of_displacement };
  const char *ends = NULL;
  arf_t end, eps0;
  arb_t kappa, most[2];
  arf_init(end);
  arf_init(eps0);
  arb_init(kappa);
  arb_init(most[0]);
  arb_init(most[1]);
  eps_over_T2(kappa, crawler, precision);
  find_end(end, &ends, l, crawler, precision);
  arf_mul_ui(eps0, end, 13, precision, ARF_RND_DOWN); /* T0 is 0.9 of T_end */
  arf_mul_2exp_si(eps0, eps0, -4);
  bool found = !arf_is_zero(end) && largest_coefficients(most, power, eps0, l, crawler, precision);
  for (int i = 0; found && i < 2; i++) {
    struct scallop_bound *b = &bounds[i];
    b->power = (int)(2 * power[i] - (i == 0));
    b->ends = ends;
    arb_pow_ui(b->C, kappa, (ulong)power[i], precision);
    arb_mul(b->C, b->C, most[i], precision);
    arb_mul_fmpz(b->C, b->C, fmpq_numref(crawler->L), precision);
    arb_div_fmpz(b->C, b->C, fmpq_denref(crawler->L), precision);
    if (i == 1 && l->returns)
      arb_zero(b->C);
    time_of(b->T0, eps0, kappa, precision);
    time_of(b->T_end, end, kappa, precision);
  }
  if (!found && why)
    *why = "the modes of the limit are not shown to hold for any T > 0: it is too close to a boundary";
  arf_clear(end);
  arf_clear(eps0);
  arb_clear(kappa);
  arb_clear(most[0]);
  arb_clear(most[1]);
  return found ? SCALLOP_OK : SCALLOP_EUNDECIDED;
}

enum scallop_status scallop_steady_bounds(const struct scallop_rational_crawler *crawler, slong order, slong precision,
                                          struct scallop_bound bounds[2], const char **why)
{
  struct limit l;
  const char *reason = NULL;
  enum scallop_status status = SCALLOP_EDOMAIN;
  if (order < 1 || order > SCALLOP_MOST_TERMS) {
    if (why)
      *why = "the order is outside of 1 to 1000";
    return status;
  }
  limit_init(&l, crawler);
  status = limit_find(&l, crawler, precision, &reason);
  if (status == SCALLOP_OK && series_coefficient_is_zero(&l.w, 0)) {
    reason = "the start velocity is 0 in the limit (F1 = F2, or alpha = 1/2): this bound is for those where it is not";
    status = SCALLOP_EDOMAIN;
  }
  if (status == SCALLOP_OK)
    status = bounds_from(&l, crawler, order, precision, bounds, &reason);
  if (status != SCALLOP_OK && why)
    *why = reason;
  limit_clear(&l);
  return status;
}
