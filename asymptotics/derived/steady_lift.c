/* The steady state as a series around its limit. */
#include "asymptotics/derived/limit.h"
#include "asymptotics/derived/scoped.h"

#include <math.h>

void steady_lift_init(struct steady_lift *s)
{
  series_init(&s->w);
  series_init(&s->w_mid);
  series_init(&s->travel);
  lift_init(&s->phase[0]);
  lift_init(&s->phase[1]);
}

void steady_lift_clear(struct steady_lift *s)
{
  series_clear(&s->w);
  series_clear(&s->w_mid);
  series_clear(&s->travel);
  lift_clear(&s->phase[0]);
  lift_clear(&s->phase[1]);
}

/* Both phases from start velocity s->w; balance and slope of the period. */
static bool lift_period(struct steady_lift *s, const struct limit *l, const struct series *eps, struct series *balance,
                        struct series *slope, const struct ring *ring)
{
  bool lifted = true;
  SCOPED(fmpq, inverse);
  SCOPED(series, c, c_slope, here);
  series_set(&c, &s->w);
  series_set_si(&c_slope, 1);
  series_set_si(balance, 0);
  series_set_si(slope, 0);
  series_set_si(&s->travel, 0);
  for (int k = 0; lifted && k < 2; k++) {
    const struct phase_constants *p = &l->phase[k];
    struct lift *phase = &s->phase[k];
    fmpq_inv(inverse, p->fraction);
    series_scale(&here, eps, p->fraction, ring);
    series_scale(&here, &here, p->fraction, ring);
    series_scale(&c, &c, p->fraction, ring);
    series_scale(&c_slope, &c_slope, p->fraction, ring);
    lifted = lift_phase(phase, &l->branch[k], p, &here, &c, &c_slope, NULL, ring);
    series_scale(&c, &phase->c_end, inverse, ring);
    series_scale(&c_slope, &phase->c_end_slope, inverse, ring);
    if (k == SCALLOP_EXTENSION)
      series_set(&s->w_mid, &c);
    series_scale(&here, &phase->balance, p->fraction, ring);
    series_add(balance, balance, &here, ring);
    series_scale(&here, &phase->balance_slope, p->fraction, ring);
    series_add(slope, slope, &here, ring);
    series_add(&s->travel, &s->travel, &phase->travel, ring);
  }
  return lifted;
}

bool steady_lift(struct steady_lift *s, const struct limit *l, const struct series *eps, const struct ring *ring)
{
  bool lifted = true, last = false;
  SCOPED(series, balance, slope);
  series_set(&s->w, &l->w);
  for (slong length = ring->length > 1 ? 2 : 1; lifted && !last; length *= 2) {
    last = length >= ring->length;
    const struct ring part = { last ? ring->length : length, ring->precision };
    s->w.known = SERIES_ALL;
    lifted = lift_period(s, l, eps, &balance, &slope, &part);
    for (slong k = 0; balance.kind == SERIES_BALLS && k < (length + 1) / 2;
         k++) /* w is right so far, whatever its balls */
      series_set_zero(&balance, k);
    lifted = lifted && series_div(&balance, &balance, &slope, &part);
    series_sub(&s->w, &s->w, &balance, &part);
  }
  if (lifted && ring->length > 1) /* once more, for what depends on w */
    lifted = lift_period(s, l, eps, &balance, &slope, ring);
  return lifted;
}
