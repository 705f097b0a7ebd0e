#include <float.h>
#include <math.h>
#include <stdbool.h>

#include "numerics/period.h"

enum { STEPS = 500 };

struct bracket {
  double lo, hi;
};

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

/* No contraction, and a balance of nothing but rounding: c lies in an interval of steady states. Only
 * where l' jumps over 0 can c pass a whole period without being sheared by a curve (docs/theory.md). */
static bool flat(const struct scallop_scaled *s, double c)
{
  struct period p;
  period_solve(s, c, &p);
  return !p.forgets && p.balance_slope == 0 && fabs(p.balance) <= p.noise;
}

static bool has_jump(const struct scallop_scaled *s)
{
  for (int kind = 0; kind < 2; kind++)
    for (int i = 0; i < s->gait->phase[kind].count; i++)
      if (s->gait->phase[kind].pieces[i].jump)
        return true;
  return false;
}

/* The end, on the side of outside, of the flat stretch that holds inside. */
static double flat_end(const struct scallop_scaled *s, double inside, double outside)
{
  for (double mid; (mid = inside + (outside - inside) / 2) != inside && mid != outside;)
    *(flat(s, mid) ? &inside : &outside) = mid;
  return inside;
}

/* The steady states around the root c: c itself, or the interval that it belongs to, perhaps as its end. */
static struct bracket steady_states(const struct scallop_scaled *s, double c)
{
  struct bracket all = surely(s);
  double step = ldexp(all.hi - all.lo, -40);
  const double near[] = { c, c - step, c + step };
  for (int i = 0; has_jump(s) && i < 3; i++)
    if (flat(s, near[i]))
      return (struct bracket){ flat_end(s, near[i], all.lo), flat_end(s, near[i], all.hi) };
  return (struct bracket){ c, c };
}

/* Newton's method on the balance, kept inside a bracket that is halved whenever two steps did not halve
 * the balance. Once a body has been stuck the map forgets where it began, and its value is the next guess. Ends
 * where the balance is nothing but rounding, where a step changes nothing, or where the bracket holds no
 * further number. */
static enum scallop_status find_root(const struct scallop_scaled *s, struct period *p)
{
  struct bracket b = surely(s);
  double c = first_guess(s), last = INFINITY, before = INFINITY;
  c = isnan(c) ? 0 : fmin(fmax(c, b.lo), b.hi);
  for (int i = 0; i < STEPS; i++) {
    period_solve(s, c, p);
    double balance = p->forgets ? p->c_end - c : p->balance;
    double next = p->forgets ? p->c_end : c - balance / p->balance_slope;
    if (balance == 0 || (!p->forgets && p->balance_slope == 0 && fabs(balance) <= p->noise))
      return SCALLOP_OK;
    if (!p->forgets && (fabs(balance) <= p->noise || fabs(next - c) <= 2 * DBL_EPSILON * fabs(c))) {
      period_solve(s, next, p);
      return SCALLOP_OK;
    }
    *(balance > 0 ? &b.lo : &b.hi) = c;
    double middle = b.lo + (b.hi - b.lo) / 2;
    bool slow = fabs(balance) > before / 2;
    before = last;
    last = fabs(balance);
    c = slow || !(next > b.lo && next < b.hi) ? middle : next;
    if (!(c > b.lo && c < b.hi))
      return SCALLOP_OK;
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
  status = find_root(&scaled, &period);
  if (status != SCALLOP_OK)
    return status;
  at = steady_states(&scaled, period.c_start);
  if (at.lo < at.hi)
    period_solve(&scaled, fmin(fmax(0, at.lo), at.hi), &period);
  struct scallop_steady_result answer = { .froude = 1 / scaled.eps,
                                          .v_low = at.lo * scaled.velocity,
                                          .v_high = at.hi * scaled.velocity };
  period_result(crawler, &scaled, &period, &answer.period);
  answer.mean_velocity = answer.period.displacement / crawler->T;
  if (!isfinite(answer.mean_velocity))
    return SCALLOP_ERANGE;
  *result = answer;
  return at.lo < at.hi ? SCALLOP_INTERVAL : SCALLOP_OK;
}
