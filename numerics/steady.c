#include <float.h>
#include <math.h>

#include "numerics/period.h"

enum { STEPS = 500 };

struct bracket { double lo, hi; };

/* Above the highest curve both bodies always move forward, below the lowest always backward. */
static struct bracket surely(const struct scallop_scaled *s)
{
  double e = s->gait->phase[SCALLOP_EXTENSION].peak / s->fraction[SCALLOP_EXTENSION];
  double c = s->gait->phase[SCALLOP_CONTRACTION].peak / s->fraction[SCALLOP_CONTRACTION];
  double margin = 1 + 8 * DBL_EPSILON;
  return (struct bracket){ -(fmax(s->mu1 * e, s->mu2 * c) + s->eps) * margin,
                           (fmax(s->mu2 * e, s->mu1 * c) + s->eps) * margin };
}

/* The steady velocity for T -> 0 when it is small against |l'|: only a place to begin. */
static double first_guess(const struct scallop_scaled *s)
{
  const struct scallop_shape *e = &s->gait->phase[SCALLOP_EXTENSION];
  const struct scallop_shape *c = &s->gait->phase[SCALLOP_CONTRACTION];
  double a = s->fraction[SCALLOP_EXTENSION], b = s->fraction[SCALLOP_CONTRACTION];
  double spread_e = 2 * a * a * fabs(1 / e->l0 - 1 / e->lT), spread_c = 2 * b * b * fabs(1 / c->l0 - 1 / c->lT);
  double driven = s->delta * (a - b);
  double forward = s->f1 * spread_e / s->mu2 + s->f2 * spread_c / s->mu1;
  double backward = s->f2 * spread_e / s->mu1 + s->f1 * spread_c / s->mu2;
  return driven / (driven > 0 ? forward : backward);
}

/* The balance is 0 at c without contraction: find the ends of the interval on which it is. */
static struct bracket zero_interval(const struct scallop_scaled *s, struct bracket outside, double c)
{
  struct bracket inside = { c, c };
  struct period p;
  for (double mid; (mid = outside.lo + (inside.lo - outside.lo) / 2) > outside.lo && mid < inside.lo;) {
    period_solve(s, mid, &p);
    *(p.balance == 0 ? &inside.lo : &outside.lo) = mid;
  }
  for (double mid; (mid = inside.hi + (outside.hi - inside.hi) / 2) > inside.hi && mid < outside.hi;) {
    period_solve(s, mid, &p);
    *(p.balance == 0 ? &inside.hi : &outside.hi) = mid;
  }
  return inside;
}

/* Newton's method on the balance, kept inside a bracket that is halved when Newton is slow. Once a
 * body has been stuck the map forgets where it began, and its value is the next guess. */
static enum scallop_status find_root(const struct scallop_scaled *s, struct period *p, struct bracket *at)
{
  struct bracket b = surely(s);
  double c = fmin(fmax(first_guess(s), b.lo), b.hi), width = b.hi - b.lo;
  if (isnan(c))
    c = 0;
  for (int i = 0; i < STEPS; i++) {
    period_solve(s, c, p);
    double balance = p->stuck ? p->c_end - c : p->balance;
    *at = (struct bracket){ c, c };
    if (balance == 0) {
      if (!p->stuck && p->balance_slope == 0)
        *at = zero_interval(s, b, c);
      return SCALLOP_OK;
    }
    *(balance > 0 ? &b.lo : &b.hi) = c;
    double next = p->stuck ? p->c_end : c - balance / p->balance_slope;
    bool last = !p->stuck && (fabs(balance) <= p->noise || fabs(next - c) <= 2 * DBL_EPSILON * fabs(c));
    if (!(next >= b.lo && next <= b.hi))
      next = b.lo + (b.hi - b.lo) / 2;
    if (i % 4 == 3) {
      if (b.hi - b.lo > width / 4 && !last)
        next = b.lo + (b.hi - b.lo) / 2;
      width = b.hi - b.lo;
    }
    if (last || next == c || (i > 8 && (next == b.lo || next == b.hi))) {
      *at = (struct bracket){ next, next };
      period_solve(s, next, p);
      return SCALLOP_OK;
    }
    c = next;
  }
  return SCALLOP_ECONVERGE;
}

enum scallop_status scallop_steady(const struct scallop_crawler *crawler, struct scallop_steady_result *result)
{
  struct scallop_scaled scaled;
  struct period period;
  struct bracket at;
  enum scallop_status status = scallop_scale(crawler, &scaled);
  if (status != SCALLOP_OK)
    return status;
  double unit = crawler->L / crawler->T;
  if (!isnormal(unit))
    return SCALLOP_ERANGE;
  status = find_root(&scaled, &period, &at);
  if (status != SCALLOP_OK)
    return status;
  if (at.lo < at.hi)
    period_solve(&scaled, fmin(fmax(0, at.lo), at.hi), &period);
  struct scallop_steady_result answer = { .froude = 1 / scaled.eps, .v_low = at.lo * unit, .v_high = at.hi * unit };
  period_result(crawler, &scaled, &period, &answer.period);
  answer.mean_velocity = answer.period.displacement / crawler->T;
  if (!isfinite(answer.mean_velocity))
    return SCALLOP_ERANGE;
  *result = answer;
  return at.lo < at.hi ? SCALLOP_INTERVAL : SCALLOP_OK;
}
