/* The steady state as a series around its limit. */
#include "asymptotics/derived/limit.h"
#include "asymptotics/derived/scoped.h"

#include <math.h>

/* Both phases from start velocity s->w; balance and slope of the period. */
static bool lift_period(struct steady_lift *s, const struct branch branch[2],
                        const struct phase_series *const phases[2], const struct series *eps, struct series *balance,
                        struct series *slope, const struct ring *ring)
{
  bool lifted = true;
  SCOPED(series, c, c_slope, here);
  series_set(&c, &s->w);
  series_set_si(&c_slope, 1);
  series_set_si(balance, 0);
  series_set_si(slope, 0);
  series_set_si(&s->travel, 0);
  for (int k = 0; lifted && k < 2; k++) {
    const struct series *fraction = &phases[k]->fraction;
    struct lift *phase = &s->phase[k];
    series_mul(&here, eps, fraction, ring);
    series_mul(&here, &here, fraction, ring);
    series_mul(&c, &c, fraction, ring);
    series_mul(&c_slope, &c_slope, fraction, ring);
    lifted = lift_phase(phase, &branch[k], phases[k], &here, &c, &c_slope, NULL, ring);
    series_div(&c, &phase->c_end, fraction, ring);
    series_div(&c_slope, &phase->c_end_slope, fraction, ring);
    if (k == SCALLOP_EXTENSION)
      series_set(&s->w_mid, &c);
    series_mul(&here, &phase->balance, fraction, ring);
    series_add(balance, balance, &here, ring);
    series_mul(&here, &phase->balance_slope, fraction, ring);
    series_add(slope, slope, &here, ring);
    series_add(&s->travel, &s->travel, &phase->travel, ring);
  }
  return lifted;
}

bool steady_lift_from(struct steady_lift *s, const struct series *w, const struct branch branch[2],
                      const struct phase_series *const phases[2], const struct series *eps, const struct ring *ring)
{
  bool lifted = true, last = false;
  SCOPED(series, balance, slope);
  series_set(&s->w, w);
  for (slong length = ring->length > 1 ? 2 : 1; lifted && !last; length *= 2) {
    last = length >= ring->length;
    const struct ring part = { last ? ring->length : length, ring->precision };
    s->w.known = SERIES_ALL;
    lifted = lift_period(s, branch, phases, eps, &balance, &slope, &part);
    for (slong k = 0; balance.kind == SERIES_BALLS && k < (length + 1) / 2;
         k++) /* w is right so far, whatever its balls */
      series_set_zero(&balance, k);
    lifted = lifted && series_div(&balance, &balance, &slope, &part);
    series_sub(&s->w, &s->w, &balance, &part);
  }
  if (lifted) /* once more, for what depends on w */
    lifted = lift_period(s, branch, phases, eps, &balance, &slope, ring);
  return lifted;
}

bool steady_lift(struct steady_lift *s, const struct limit *l, const struct series *eps, const struct ring *ring)
{
  SCOPED(phase_series, extension, contraction);
  SCOPED(fmpq, one);
  fmpq_one(one);
  phase_series_set(&extension, &l->phase[0], one);
  phase_series_set(&contraction, &l->phase[1], one);
  return steady_lift_from(s, &l->w, l->branch, (const struct phase_series *[]){ &extension, &contraction }, eps, ring);
}
