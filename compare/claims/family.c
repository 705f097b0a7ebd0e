#include "compare/claims/family.h"

#include <math.h>

#include "compare/claims/evidence.h"

static struct scallop_crawler member(const struct scallop_crawler *crawler, enum varied varied, double x)
{
  struct scallop_crawler c = *crawler;
  if (varied == VARY_PERIOD)
    c.T = x;
  else if (varied == VARY_RATIO)
    c.F1 = x * c.F2;
  else {
    c.F1 = x * (c.F1 / c.F2);
    c.F2 = x;
  }
  return c;
}

static struct place place_at(const struct family *f, double x)
{
  struct scallop_crawler c = member(&f->crawler, f->varied, x);
  struct scallop_steady_result r = steady_state(&c);
  return (struct place){ .x = x,
                         .speed = r.mean_velocity * f->crawler.T / f->crawler.L,
                         .v_start = r.period.v_start,
                         .sliding = isfinite(r.mean_velocity) && r.period.regime == SCALLOP_SLIDING };
}

/* In doubles */

static double speed_of(const void *family, double x) { return place_at(family, x).speed; }
static double start_of(const void *family, double x) { return place_at(family, x).v_start; }

static double rough_boundary(const struct family *f)
{
  for (int i = 1; i < f->count; i++)
    if (f->scan[i - 1].v_start > 0 && f->scan[i].v_start <= 0)
      return last_positive(start_of, f, f->scan[i - 1].x, f->scan[i].x);
  return NAN;
}

static void keep_maximum(struct family *f, struct place at)
{
  if (at.speed > f->maximum[f->highest].speed)
    f->highest = f->maxima;
  f->maximum[f->maxima++] = at;
}

static void find_maxima(struct family *f)
{
  for (int i = 1; i + 1 < f->count && f->maxima < PEAKS_MOST; i++)
    if (f->scan[i].speed > f->scan[i - 1].speed && f->scan[i].speed > f->scan[i + 1].speed)
      keep_maximum(f, place_at(f, highest_between(speed_of, f, f->scan[i - 1].x, f->scan[i + 1].x)));
}

void family_scan(struct family *f, const struct scallop_crawler *c, enum varied varied, bool coarse)
{
  double x = 1.01, factor = coarse ? 1.04 : 1.01;
  *f = (struct family){ .crawler = *c, .varied = varied, .count = coarse ? 229 : 900, .before = NAN, .after = NAN };
  if (varied == VARY_FORCES) {
    x = 1e-3 * (c->m1 + c->m2) * c->L / (c->T * c->T) / (1 + c->F1 / c->F2);
    f->count = SCAN_MOST;
  } else if (varied == VARY_PERIOD) {
    x = sqrt(1e-3 * (c->m1 + c->m2) * c->L / (c->F1 + c->F2));
    f->count = SCAN_MOST / 2;
  }
  for (int i = 0; i < f->count; i++, x *= factor)
    f->scan[i] = place_at(f, x);
  f->boundary = rough_boundary(f);
  find_maxima(f);
}

bool family_peaks_at_boundary(const struct family *f)
{
  return f->maxima > 0 && fabs(f->maximum[f->highest].x / f->boundary - 1) < 1e-5;
}

/* Proven */

void family_prove_maxima(struct family *f)
{
  const struct claim higher = { .motions = "steady at=0.99*x1; steady at=x1; steady at=1.01*x1",
                                .says = "mean_velocity:2 > max(mean_velocity, mean_velocity:3)",
                                .varied = f->varied };
  int count = f->maxima;
  struct question q;
  arb_t excess;
  arb_init(excess);
  question_init(&q, &f->crawler);
  q.claim = &higher;
  f->maxima = f->highest = 0;
  for (int i = 0; i < count; i++) {
    q.found[0] = f->maximum[i].x;
    solve_motions(&q, true);
    if (judge(&q, excess) > 0)
      keep_maximum(f, f->maximum[i]);
  }
  question_clear(&q);
  arb_clear(excess);
}

/* The boundary from the left: from 2^-48 or so of it to the zero of the line through the two members */
static const char from_left[] = "steady at=root*(1-2^-39); steady at=root*(1-2^-40)";
static const char before[] = "(mean_velocity:2 - mean_velocity)*T:0/L*2^40";
static const char refined[] = "root + root*2^-40*(v_start:2/(v_start - v_start:2) - 1)";
static const char across[] =
    "steady at=root*(1-2^-60); steady at=root*(1+2^-60); steady at=root*(1+2^-40); steady at=root*(1+2^-39)";
static const char after[] = "(mean_velocity:4 - mean_velocity:3)*T:0/L*2^40";

void family_prove_boundary(struct family *f)
{
  enum { ROOT_BITS = 96 };
  struct claim claim = { .motions = from_left, .varied = f->varied };
  struct question q;
  arb_t x;
  if (isnan(f->boundary))
    return;
  question_init(&q, &f->crawler);
  arb_init(x);
  q.claim = &claim;
  arb_set_d(q.root, f->boundary);
  solve_motions(&q, true);
  value_of(x, &q, before);
  f->before = middle(x);
  f->rises_before = q.solved && arb_is_positive(x);
  value_of(x, &q, refined);
  f->found = q.solved && arb_is_finite(x);
  arf_set_round(arb_midref(q.root), f->found ? arb_midref(x) : arb_midref(q.root), ROOT_BITS, ARF_RND_NEAR);
  claim.motions = across;
  solve_motions(&q, true);
  f->found = f->found && q.solved && arb_is_positive(&q.motion[1].value[Q_V_START])
             && arb_is_nonpositive(&q.motion[2].value[Q_V_START]);
  value_of(x, &q, after);
  f->after = middle(x);
  f->falls_after = q.solved && arb_is_negative(x);
  f->boundary_speed = number_of(&q, "mean_velocity:3*T:0/L");
  f->boundary = middle(q.root);
  question_clear(&q);
  arb_clear(x);
}

bool family_peak_is_proven(const struct family *f)
{
  return f->found && f->rises_before && f->falls_after && family_peaks_at_boundary(f);
}
