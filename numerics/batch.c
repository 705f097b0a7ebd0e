#include <math.h>
#include <stddef.h>

#include "numerics/numerics.h"

static void put(double *column, long i, double value)
{
  if (column)
    column[i] = value;
}

static void store(const struct scallop_steady_states *s, long i, const struct scallop_steady_result *r)
{
  put(s->froude, i, r->froude);
  put(s->v_start, i, r->period.v_start);
  put(s->v_mid, i, r->period.v_mid);
  put(s->displacement, i, r->period.displacement);
  put(s->mean_velocity, i, r->mean_velocity);
  put(s->multiplier, i, r->period.multiplier);
  put(s->v_low, i, r->v_low);
  put(s->v_high, i, r->v_high);
  if (s->regime)
    s->regime[i] = r->period.regime;
  for (int phase = 0; s->modes && phase < 2; phase++)
    s->modes[i][phase] = r->period.modes[phase];
}

long scallop_steady_batch(const struct scallop_crawlers *c, const struct scallop_steady_states *states, int threads)
{
  static const struct scallop_steady_result none = {
    .froude = NAN,
    .mean_velocity = NAN,
    .period = { .v_start = NAN, .v_mid = NAN, .displacement = NAN, .multiplier = NAN },
    .v_low = NAN,
    .v_high = NAN
  };
  long failed = 0;
  (void)threads;
  for (long i = 0; i < c->count; i++) {
    struct scallop_crawler one = { c->m1[i], c->m2[i], c->F1[i], c->F2[i], c->L[i], c->T[i], c->alpha[i], c->gait[i] };
    struct scallop_steady_result result;
    enum scallop_status status = scallop_steady(&one, &result);
    store(states, i, status < 0 ? &none : &result);
    if (states->status)
      states->status[i] = status;
    failed += status < 0;
  }
  return failed;
}
