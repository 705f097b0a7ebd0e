/* The claims in words about the steady state: (27) for which alpha and when the steady state is reached. */
#include <math.h>

#include "compare/claims/decide.h"
#include "compare/claims/evidence.h"

/* (27) over the certified v_start for alphas 0.08 apart, minus 1. x1: the largest error, at alpha = x2; x3: that at the
 * alpha to name; x4: the alpha of the motions */
void velocity_in_the_limit(struct question *q)
{
  const struct alphas *alphas = q->claim->with;
  for (int i = alphas->first; i <= alphas->first + 48; i += 8) {
    q->found[3] = i / 100.;
    solve_motions(q, true);
    double error = q->solved ? number_of(q, alphas->error) : NAN;
    if (i == alphas->shown)
      q->found[2] = error;
    if (!(fabs(error) <= fabs(q->found[0]))) {
      q->found[0] = error;
      q->found[1] = i / 100.;
    }
  }
  q->row.inside = alphas->first > 50;
  if (fabs(q->found[0]) < 1e-15)
    rest_on_samples(q, 7);
  conclude(q);
  if (!q->of_the_paper)
    *q->row.reason = '\0';
}

/* Periods from rest until the velocity is within 1e-6 L/T of the steady one, or, with `same`, until it is the same; 0:
 * not in 1000 */
static int periods_until(const struct scallop_crawler *c, bool same)
{
  struct scallop_period_result p = { .v_end = 0 };
  double v = steady_state(c).period.v_start;
  for (int n = 1; n <= 1000; n++) {
    double before = p.v_end;
    if (scallop_period(c, before, &p) < 0)
      return 0;
    if (same ? p.v_end == before : fabs(p.v_end - v) <= 1e-6 * c->L / c->T)
      return same ? n - 1 : n;
  }
  return 0;
}

/* x1: periods until the velocity is the steady one; x2: until it is near */
void reached(struct question *q)
{
  solve_motions(q, true);
  q->found[0] = periods_until(&q->motion[1].crawler, true);
  q->found[1] = periods_until(&q->motion[1].crawler, false);
  conclude(q);
}
