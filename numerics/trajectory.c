#include <math.h>

#include "numerics/event/motion.h"

struct recorder {
  const struct scallop_crawler *crawler;
  const struct scallop_scaled *scaled;
  scallop_sampler *sampler;
  void *context;
  long samples, next; /* samples in a period; the next one to take                             */
  double period_number;
  enum scallop_phase_kind kind;
  double x_start; /* of the centre of mass when the phase began, in L                       */
  bool stopped, overflow;
};

/* The state at offset u of an interval; x: of the centre of mass, from where x1 = x2 = l = 0. */
static struct scallop_sample state_at(const struct recorder *r, const struct scallop_interval *i, double u)
{
  const struct scallop_piece *p = i->piece;
  const struct scallop_scaled *s = r->scaled;
  double L = r->crawler->L, unit = L / scallop_phase_duration(r->crawler, r->kind);
  double duration = p->anchor == SCALLOP_FROM_START ? u - i->u_begin : i->u_begin - u;
  double velocity = p->curve->velocity(p, u), length = p->curve->length(p, u);
  double c = i->c_begin + i->c_slope * duration, x = 0.5 * (i->c_begin + c) * duration;
  if (i->glue != 0) {
    c = i->glue * velocity;
    x = i->glue * (length - p->curve->length(p, i->u_begin));
  }
  x += r->x_start + i->x_begin;
  length += (r->kind == SCALLOP_EXTENSION) == (p->anchor == SCALLOP_FROM_END) ? 1 : 0;
  return (struct scallop_sample){ .x1 = (x - s->mu2 * length) * L,
                                  .x2 = (x + s->mu1 * length) * L,
                                  .xC = (x + 0.5 * s->mu_difference * length) * L,
                                  .v1 = (c - s->mu2 * velocity) * unit,
                                  .v2 = (c + s->mu1 * velocity) * unit,
                                  .l = length * L };
}

static void record(void *context, const struct scallop_interval *interval)
{
  struct recorder *r = context;
  const struct scallop_scaled *s = r->scaled;
  bool from_start = interval->piece->anchor == SCALLOP_FROM_START;
  double s_end = from_start ? interval->u_end : 1 - interval->u_end;
  double before = r->kind == SCALLOP_EXTENSION ? 0 : s->fraction[SCALLOP_EXTENSION];
  while (r->next < r->samples && !r->stopped) {
    double at = (double)r->next / (double)r->samples, in_phase = (at - before) / s->fraction[r->kind];
    if (!(in_phase < s_end))
      return;
    struct scallop_sample sample = state_at(r, interval, from_start ? in_phase : 1 - in_phase);
    sample.t = (r->period_number + at) * r->crawler->T;
    r->overflow = !isfinite(sample.x1) || !isfinite(sample.x2) || !isfinite(sample.v1) || !isfinite(sample.v2)
                  || !isfinite(sample.t);
    r->stopped = r->overflow || !r->sampler(r->context, &sample);
    r->next++;
  }
}

enum scallop_status scallop_trajectory(const struct scallop_crawler *crawler, double v0, long periods, long samples,
                                       scallop_sampler *sampler, void *context)
{
  struct scallop_scaled scaled;
  struct sum c = { 0, 0 }, x = { 0, 0 }; /* where periods begin */
  enum scallop_status status = start_scaled(crawler, v0, &scaled, &c.total);
  if (status == SCALLOP_OK && (periods < 1 || samples < 1))
    status = SCALLOP_EDOMAIN;
  if (status != SCALLOP_OK)
    return status;
  const struct walker walker = walker_of(&scaled);
  struct recorder r = {
    .crawler = crawler, .scaled = &scaled, .sampler = sampler, .context = context, .samples = samples
  };
  for (long n = 0; n < periods && !r.stopped; n++) {
    struct period p = { .c_start = sum_value(&c), .c_end = sum_value(&c) };
    r.period_number = (double)n;
    r.next = 0;
    for (int kind = 0; kind < 2; kind++) {
      r.kind = (enum scallop_phase_kind)kind;
      r.x_start = sum_value(&x) + (kind == SCALLOP_EXTENSION ? 0 : p.phase[SCALLOP_EXTENSION].way[0]);
      p.c_mid = p.c_end;
      motion_walk(&walker.phase[kind], p.c_mid * scaled.fraction[kind], record, &r, &p.phase[kind]);
      p.c_end = p.phase[kind].c_end / scaled.fraction[kind];
    }
    period_conclude(&walker, &p);
    period_sum_up(&walker, &p);
    sum_add(&x, p.travel);
    if (p.forgets)
      c = (struct sum){ p.c_end, 0 };
    else
      sum_add(&c, scaled.eps * p.balance);
  }
  double position = sum_value(&x) * crawler->L, velocity = sum_value(&c) * scaled.velocity;
  if (r.overflow || (!r.stopped && !isfinite(position)))
    return SCALLOP_ERANGE;
  if (r.stopped)
    return SCALLOP_STOPPED;
  sampler(context, &(struct scallop_sample){ (double)periods * crawler->T, position, position, position, velocity,
                                             velocity, 0 });
  return SCALLOP_OK;
}
