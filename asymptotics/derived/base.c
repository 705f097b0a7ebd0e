/* The base point of a branch in balls, followed from crossing to crossing. */
#include "asymptotics/derived/branch.h"
#include "asymptotics/derived/scoped.h"

#include <math.h>

struct straight { /* c = a + b s                                                               */
  arb_t a, b, a_slope;
};

/* u becomes a ball that holds the crossing for every line within the balls of line: Newton's interval operator maps it
 * into itself. u comes in as a place near it. */
static bool enclose(arb_t u, const struct crossing *at, const fmpq_t q, const struct straight *line, bool same,
                    slong precision)
{
  enum { TRIES = 60, STEPS = 40 };
  bool inside = false;
  SCOPED(arb, given);
  arb_set(given, u);
  SCOPED(arb, gap, slope, wide, next);
  for (int i = 0; i < STEPS; i++) { /* the middle of u, for the middle of the line */
    mag_zero(arb_radref(u));
    gap_at(gap, slope, at->piece, q, line->a, line->b, u, precision);
    arb_div(gap, gap, slope, precision);
    if (!arb_is_finite(gap))
      break;
    arf_sub(arb_midref(u), arb_midref(u), arb_midref(gap), precision, ARF_RND_NEAR);
    if (arf_cmpabs_mag(arb_midref(gap), arb_radref(gap)) <= 0)
      break;
  }
  mag_zero(arb_radref(u));
  gap_at(gap, slope, at->piece, q, line->a, line->b, u, precision);
  arb_div(next, gap, slope, precision);
  arb_set(wide, u);
  arb_get_mag(arb_radref(wide), next);
  for (int i = 0; i < TRIES && !inside && arb_is_finite(next); i++) {
    mag_mul_2exp_si(arb_radref(wide), arb_radref(wide), 1);
    if (mag_is_zero(arb_radref(wide)))
      mag_set_ui_2exp_si(arb_radref(wide), 1, -precision);
    gap_at(next, slope, at->piece, q, line->a, line->b, wide, precision);
    arb_div(next, gap, slope, precision);
    arb_sub(next, u, next, precision);
    inside = arb_is_finite(next) && arb_contains(wide, next) && (!same || arb_contains(wide, given));
    if (arf_cmpabs_2exp_si(arb_midref(u), 1) > 0 || mag_cmp_2exp_si(arb_radref(wide), 1) > 0)
      break;
  }
  if (inside)
    arb_set(u, next);
  return inside;
}

/* After the crossing at time s with ds/d(unknown) = s_slope, from region r to region `to`. */
static void bend(struct base *base, struct straight *line, const struct phase_constants *p, int r, int to,
                 const arb_t eps, const arb_t s, const arb_t s_slope, slong precision)
{
  SCOPED(arb, term);
  SCOPED(fmpq, drop);
  fmpq_sub(drop, p->beta[r], p->beta[to]);
  ball_times(term, s, drop, precision);
  arb_add(base->balance, base->balance, term, precision);
  arb_addmul(line->a, term, eps, precision);
  ball_times(term, s_slope, drop, precision);
  arb_add(base->balance_slope, base->balance_slope, term, precision);
  arb_addmul(line->a_slope, term, eps, precision);
  ball_times(line->b, eps, p->beta[to], precision);
}

bool base_follow(struct base *base, struct branch *b, const struct phase_constants *p, const arb_t eps, const arb_t c,
                 const arb_t c_slope, bool same, slong precision)
{
  struct straight line;
  arb_t u[MOST_CROSSINGS], gap, slope;
  bool found = true;
  arb_init(line.a);
  arb_init(line.b);
  arb_init(line.a_slope);
  arb_init(gap);
  arb_init(slope);
  for (int i = 0; i < b->count; i++)
    arb_init(u[i]);
  arb_set(line.a, c);
  arb_set(line.a_slope, c_slope);
  ball_times(line.b, eps, p->beta[b->first_region], precision);
  arb_zero(base->balance);
  arb_zero(base->balance_slope);
  for (int i = 0; found && i < b->count; i++) {
    const struct crossing *at = &b->crossing[i];
    series_coefficient(u[i], &at->offset, 0, precision);
    found = enclose(u[i], at, p->curve[at->curve], &line, same, precision);
    gap_at(gap, slope, at->piece, p->curve[at->curve], line.a, line.b, u[i], precision);
    if (at->piece->anchor == SCALLOP_FROM_END)
      arb_neg(slope, slope);
    arb_div(slope, line.a_slope, slope, precision);
    time_of_offset(gap, at->piece, u[i], precision);
    bend(base, &line, p, branch_region(b, i), at->to, eps, gap, slope, precision);
    found = found && arb_is_finite(slope);
  }
  if (found) {
    arb_add(base->c_end, line.a, line.b, precision);
    arb_set(base->c_end_slope, line.a_slope);
    arb_set_fmpq(gap, p->beta[branch_region(b, b->count)], precision);
    arb_add(base->balance, base->balance, gap, precision);
  }
  for (int i = 0; i < b->count; i++) {
    if (found)
      series_set_ball(&b->crossing[i].offset, u[i]);
    arb_clear(u[i]);
  }
  arb_clear(line.a);
  arb_clear(line.b);
  arb_clear(line.a_slope);
  arb_clear(gap);
  arb_clear(slope);
  return found;
}
