/* The claims in words: each with the figure that decides it. */
#include <float.h>
#include <math.h>
#include <stdio.h>

#include <gsl/gsl_qrng.h>

#include "compare/breakdown_parts.h"
#include "compare/claims_words.h"
#include "compare/counts.h"

enum { RANDOM_CRAWLERS = 400 };
/* A displacement in L that is only rounding: a dozen terms of size up to 1, the start velocity known to an ulp. */
static const double ZERO = 1e-14;

const char *words_whose(const struct words *l) { return l->of_the_paper ? "the paper's crawler" : "the ledger's crawler"; }

static struct claim_row make_row(const struct words *l, const char *claim, const char *section, const char *quantity,
                                 const char *conditions, bool inside, bool holds, const char *measured)
{
  struct claim_row row = { .equation = section,
                           .quantity = quantity,
                           .gait = l->crawler.gait->name,
                           .conditions = conditions,
                           .inside = inside,
                           .claimed_order = NAN,
                           .slope = NAN,
                           .fit = { .order = NAN, .lo = NAN, .hi = NAN },
                           .verdict = holds ? CLAIM_HOLDS : CLAIM_REFUTED };
  snprintf(row.claim, sizeof row.claim, "%s", claim);
  snprintf(row.measured, sizeof row.measured, "%s", measured);
  return row;
}

enum claim_verdict words_verdict(bool holds, bool proven)
{
  return holds ? CLAIM_HOLDS : proven ? CLAIM_REFUTED : CLAIM_UNDECIDED;
}

void words_enter(const struct words *w, const struct words_claim *claim, enum claim_verdict verdict, const char *measured,
                 const char *reason)
{
  struct claim_row row = make_row(w, claim->claim, claim->section, claim->quantity, claim->conditions, claim->inside, false,
                                  measured);
  row.verdict = verdict;
  if (verdict != CLAIM_HOLDS && reason)
    snprintf(row.reason, sizeof row.reason, "%s", reason);
  w->sink(w->context, &row);
}

static void enter(const struct words *l, const char *claim, const char *section, const char *quantity,
                  const char *conditions, bool inside, bool holds, const char *measured)
{
  struct claim_row row = make_row(l, claim, section, quantity, conditions, inside, holds, measured);
  l->sink(l->context, &row);
}

struct scallop_steady_result words_steady(const struct scallop_crawler *c)
{
  struct scallop_steady_result r;
  if (counted_steady(c, &r) < 0)
    return (struct scallop_steady_result){ .mean_velocity = NAN,
                                           .period = { .v_start = NAN, .displacement = NAN, .multiplier = NAN } };
  return r;
}

/* The duration at which the Froude number is 1 */
double words_natural_time(const struct scallop_crawler *c) { return sqrt((c->m1 + c->m2) / (c->F1 + c->F2) * c->L); }

/* ---- over random crawlers: masses and forces within a factor of 10, 0.05 < alpha < 0.95, Froude from 0.1 ---- */

/* 10^x for x in [-1, 1] by its own series: the same bits on every machine */
static double power_of_ten(double x)
{
  double y = x * 2.302585092994046 / 64, p = 1 + y * (1 + y / 2 * (1 + y / 3 * (1 + y / 4 * (1 + y / 5))));
  for (int i = 0; i < 6; i++)
    p *= p;
  return p;
}

struct scallop_crawler words_random(gsl_qrng *q, const struct scallop_gait *gait)
{
  double u[6];
  gsl_qrng_get(q, u);
  struct scallop_crawler c = { .L = 1, .gait = gait, .alpha = 0.05 + 0.9 * u[4] };
  c.m1 = power_of_ten(2 * u[0] - 1), c.m2 = power_of_ten(2 * u[1] - 1);
  c.F1 = power_of_ten(2 * u[2] - 1), c.F2 = power_of_ten(2 * u[3] - 1);
  c.T = sqrt((c.m1 + c.m2) / (c.F1 + c.F2)) * power_of_ten(1.5 * u[5] - 1);
  return c;
}

typedef double probe(const struct scallop_crawler *);

/* The largest value of probe over random crawlers, and where it occurs; NAN if any is not a number. */
static double largest(probe *p, const struct scallop_gait *gait, struct scallop_crawler *where)
{
  gsl_qrng *q = gsl_qrng_alloc(gsl_qrng_sobol, 6);
  double most = -INFINITY;
  for (int i = 0; q && i < RANDOM_CRAWLERS; i++) {
    struct scallop_crawler c = words_random(q, gait);
    double x = p(&c);
    if (x > most || isnan(x)) {
      most = x;
      *where = c;
    }
    if (isnan(x))
      break;
  }
  if (q)
    gsl_qrng_free(q);
  return q ? most : NAN;
}

static double equal_forces(const struct scallop_crawler *c)
{
  struct scallop_crawler equal = *c;
  equal.F2 = equal.F1;
  return fabs(words_steady(&equal).period.displacement) / equal.L;
}

static double symmetric_timing(const struct scallop_crawler *c)
{
  struct scallop_crawler symmetric = *c;
  symmetric.alpha = 0.5;
  return fabs(words_steady(&symmetric).period.displacement) / symmetric.L;
}

static double multiplier(const struct scallop_crawler *c) { return words_steady(c).period.multiplier; }

/* How far the velocity is from the steady one, over L/T, once it is within 1e-6 or after 20000 periods from rest */
static double unsettled(const struct scallop_crawler *c)
{
  struct scallop_steady_result s = words_steady(c);
  struct scallop_period_result p = { .v_end = 0 };
  for (int n = 0; n < 20000 && fabs(p.v_end - s.period.v_start) > 1e-6 * c->L / c->T; n++)
    if (scallop_period(c, p.v_end, &p) < 0)
      return NAN;
  return fabs(p.v_end - s.period.v_start) * c->T / c->L;
}

/* -displacement/L in the direction in which a longer extension should carry: sign (F1 - F2)(2 alpha - 1) */
static double backward(const struct scallop_crawler *c, bool sliding)
{
  double sign = (c->F1 - c->F2) * (2 * c->alpha - 1) > 0 ? 1 : -1;
  struct scallop_steady_result s = words_steady(c);
  return (s.period.regime == SCALLOP_SLIDING) == sliding ? -sign * s.period.displacement / c->L : -1;
}

static double backward_sliding(const struct scallop_crawler *c) { return backward(c, true); }
static double backward_sticking(const struct scallop_crawler *c) { return backward(c, false); }

static void over_random_crawlers(const struct words *l)
{
  const struct scallop_gait *gait = l->crawler.gait;
  const char *set = "400 quasi-random crawlers, masses and forces within 100:1, sliding to stick-slip";
  char text[120];
  struct scallop_crawler where = scallop_crawler_default();
  double x = largest(equal_forces, gait, &where);
  snprintf(text, sizeof text, "largest |displacement|/L: %s", x <= ZERO ? "below 1e-14" : "above 1e-14");
  enter(l, "equal_forces_do_not_move", "4.1", "displacement", set, true, x <= ZERO, text);
  x = largest(symmetric_timing, gait, &where);
  snprintf(text, sizeof text, "largest |displacement|/L: %s", x <= ZERO ? "below 1e-14" : "above 1e-14");
  enter(l, "symmetric_timing_does_not_move", "4.2", "displacement", set, true, x <= ZERO, text);
  x = largest(multiplier, gait, &where);
  snprintf(text, sizeof text, "largest multiplier of the period map: %.4f", x);
  enter(l, "steady_state_attracts", "4.3.2", "multiplier", set, true, x < 1, text);
  x = largest(unsettled, gait, &where);
  snprintf(text, sizeof text, "largest |v - v_start| T/L after at most 20000 periods from rest: %s 1e-6",
           x <= 1e-6 ? "below" : "above");
  enter(l, "motion_always_settles", "5", "v", set, true, x <= 1e-6, text);
  for (int sliding = 1; sliding >= 0; sliding--) {
    x = largest(sliding ? backward_sliding : backward_sticking, gait, &where);
    snprintf(text, sizeof text, "largest displacement/L against the sign of (F1-F2)(2 alpha-1): %.3g", x <= ZERO ? 0 : x);
    struct claim_row row = make_row(l, "longer_extension_moves_forward", "4.4", "displacement",
                                    sliding ? "400 quasi-random crawlers: those that slide"
                                            : "400 quasi-random crawlers: those in stick-slip",
                                    sliding, x <= ZERO, text);
    if (x > ZERO)
      snprintf(row.reason, sizeof row.reason,
               "scallop steady --m1 %.4g --m2 %.4g --F1 %.4g --F2 %.4g --L 1 --T %.4g --alpha %.4g --gait %s", where.m1,
               where.m2, where.F1, where.F2, where.T, where.alpha, gait->name);
    l->sink(l->context, &row);
  }
}

/* ---- section 4.2 takes l(t) = l(T - t) for symmetric; its argument needs l'' to change sign from phase to phase.
 * A gait with the first and not the second: phases of equal duration, the extension gathering speed in its first fifth
 * and losing it in the rest, the contraction the same backward in time. ---- */

static const struct scallop_piece quick_start[] = { SCALLOP_RAMP(0, 0.2, SCALLOP_FROM_START, 1, 10),
                                                    SCALLOP_RAMP(0.8, 0, SCALLOP_FROM_END, 1, -2.5) };
static const struct scallop_piece quick_end[] = { SCALLOP_RAMP(0, 0.8, SCALLOP_FROM_START, -1, -2.5),
                                                  SCALLOP_RAMP(0.2, 0, SCALLOP_FROM_END, -1, 10) };
static const struct scallop_gait reversible = {
  "reversible", { { quick_start, 2, 10, -2.5, 2, 1, true, true }, { quick_end, 2, -2.5, 10, 2, -1, true, true } }
};

static void reversible_kinematics(const struct words *l)
{
  struct words r = *l;
  char text[120];
  r.crawler = scallop_crawler_default();
  r.crawler.alpha = 0.5;
  r.crawler.gait = &reversible;
  double moved = words_steady(&r.crawler).period.displacement / r.crawler.L;
  snprintf(text, sizeof text, "displacement/L: %.6f", moved);
  enter(&r, "reversible_kinematics_do_not_move", "4.2", "displacement",
        "l(t) = l(T - t): l' rises for 0.2 of the extension and falls for 0.8, alpha = 1/2, else the paper's crawler", true,
        fabs(moved) <= ZERO, text);
}

/* ---- one extension from rest against its duration, figure 4 ---- */

static struct scallop_phase_result extension(const struct scallop_crawler *crawler, double ratio, double T)
{
  struct scallop_crawler c = *crawler;
  struct scallop_phase_result r;
  c.F1 = ratio * c.F2;
  c.alpha = 0.5;
  c.T = 2 * T;
  if (counted_phase(&c, SCALLOP_EXTENSION, 0, &r) < 0)
    return (struct scallop_phase_result){ .dxC = NAN, .v_end = NAN, .regime = SCALLOP_AT_REST };
  return r;
}

/* The longest extension from rest without sticking, to neighbouring doubles; nan if there is none */
static double onset_of_sticking(const struct scallop_crawler *crawler, double ratio)
{
  struct subject s = { .crawler = *crawler, .kind = SCALLOP_EXTENSION };
  struct events events;
  double onset = NAN;
  s.crawler.F1 = ratio * s.crawler.F2;
  events_find(&events, &s, "");
  for (int i = 0; i < events.count && isnan(onset); i++)
    if (events.event[i].regime == SCALLOP_STICK_SLIP)
      onset = events.event[i].T;
  events_clear(&events);
  return onset;
}

/* The duration between a and b after which the velocity is highest */
static double highest_velocity(const struct scallop_crawler *crawler, double ratio, double a, double b)
{
  while (b - a > 1e-8 * b) {
    double left = a + (b - a) / 3, right = b - (b - a) / 3;
    if (extension(crawler, ratio, left).v_end < extension(crawler, ratio, right).v_end)
      a = left;
    else
      b = right;
  }
  return a + (b - a) / 2;
}

struct durations {
  double least;   /* d(dx_C) over d((F1-F2)T^2/(2M)) */
  double peak_at; /* of dv_C, over the onset of sticking */
};

static struct durations up_to_sticking(const struct scallop_crawler *c, double ratio)
{
  enum { STEPS = 400 };
  struct durations d = { .least = INFINITY };
  double onset = onset_of_sticking(c, ratio), T = onset / (10 * STEPS), highest = 0;
  double before = extension(c, ratio, T).dxC, growth = (ratio - 1) * c->F2 / (2 * (c->m1 + c->m2));
  for (int j = 1; j <= STEPS; j++) {
    double longer = onset * j / STEPS;
    struct scallop_phase_result r = extension(c, ratio, longer);
    d.least = fmin(d.least, (r.dxC - before) / (growth * (longer - T) * (longer + T)));
    before = r.dxC;
    T = longer;
    if (r.v_end > highest) {
      highest = r.v_end;
      d.peak_at = (double)j / STEPS;
    }
  }
  double step = onset / STEPS;
  d.peak_at = highest_velocity(c, ratio, d.peak_at * onset - step, d.peak_at * onset + step) / onset;
  return d;
}

static void over_durations(const struct words *l)
{
  static const double ratios[] = { 2, 10, 40 };
  double least = INFINITY, peak_at[3];
  int peaks_inside = 0;
  char range[80];
  snprintf(range, sizeof range, "%s, from rest, F1/F2 = 2, 10, 40", words_whose(l));
  for (int i = 0; i < 3; i++) {
    struct durations d = up_to_sticking(&l->crawler, ratios[i]);
    least = fmin(least, d.least);
    peak_at[i] = d.peak_at;
    peaks_inside += d.peak_at < 0.99;
  }
  char text[120];
  snprintf(text, sizeof text, "least d(dx_C) over d((F1-F2)T^2/(2M)), 400 durations up to sticking: %.6f", least);
  enter(l, "displacement_grows_with_duration", "4.4", "dx_C", range, l->of_the_paper, least > 0, text);
  snprintf(text, sizeof text, "dv_C peaks at %.6f, %.6f, %.6f of the duration at which sticking begins", peak_at[0],
           peak_at[1], peak_at[2]);
  enter(l, "velocity_change_is_not_monotone", "4.4", "dv_C", range, l->of_the_paper, peaks_inside == 3, text);
}

/* ---- the steady state against F1/F2 and alpha, figure 5 ---- */

static struct scallop_crawler with_ratio(const struct words *l, double ratio)
{
  struct scallop_crawler c = l->crawler;
  c.F1 = ratio * c.F2;
  return c;
}

static void over_force_ratio(const struct words *l)
{
  char text[120];
  struct scallop_crawler equal = with_ratio(l, 1);
  double at_1 = fabs(words_steady(&equal).mean_velocity) * equal.T / equal.L;
  snprintf(text, sizeof text, "|mean velocity| T/L at F1/F2 = 1: %s", at_1 <= ZERO ? "below 1e-14" : "above 1e-14");
  enter(l, "mean_velocity_vanishes_at_ratio_1", "4.5", "mean velocity", words_whose(l), l->of_the_paper, at_1 <= ZERO, text);
  static const double ratios[] = { 1e2, 1e4, 1e6 };
  double far[3];
  for (int i = 0; i < 3; i++) {
    struct scallop_crawler c = with_ratio(l, ratios[i]);
    far[i] = words_steady(&c).mean_velocity * c.T / c.L;
  }
  snprintf(text, sizeof text, "mean velocity T/L at F1/F2 = 1e2, 1e4, 1e6: %.3g, %.3g, %.3g", far[0], far[1], far[2]);
  enter(l, "mean_velocity_vanishes_at_large_ratio", "4.5", "mean velocity", words_whose(l), l->of_the_paper,
        fabs(far[2]) <= ZERO, text);
}

static void over_alpha(const struct words *l)
{
  double before = -INFINITY, least_rise = INFINITY, at_least = NAN;
  char text[120], range[80];
  snprintf(range, sizeof range, "%s, alpha from 0.50 to 0.99", words_whose(l));
  for (int i = 50; i < 100; i++) {
    struct scallop_crawler c = l->crawler;
    c.alpha = i / 100.0;
    double u = words_steady(&c).mean_velocity * c.T / c.L;
    if (u - before < least_rise) {
      least_rise = u - before;
      at_least = c.alpha;
    }
    before = u;
  }
  snprintf(text, sizeof text, "least change of mean velocity T/L between alphas 0.01 apart: %.3g at alpha = %.2f",
           least_rise, at_least);
  enter(l, "mean_velocity_grows_with_alpha", "4.5", "mean velocity", range, l->of_the_paper, least_rise > 0, text);
}

static void over_period(const struct words *l)
{
  enum { POINTS = 24 };
  struct order_point points[POINTS];
  char text[120];
  for (int k = 0; k < POINTS; k++) {
    struct scallop_crawler c = l->crawler;
    c.T = ldexp(c.T, -k);
    double u = words_steady(&c).mean_velocity;
    points[k] = (struct order_point){ .h = c.T, .err = u, .noise = 8 * DBL_EPSILON * fabs(u) };
  }
  struct order_fit fit = order_estimate(points, POINTS);
  bool holds = fit.state == ORDER_FITTED && fabs(fit.order + 1) <= 0.02;
  struct claim_row row = { .claim = "mean_velocity_goes_as_1_over_T",
                           .slope = NAN,
                           .equation = "4.3.3",
                           .quantity = "mean velocity",
                           .gait = l->crawler.gait->name,
                           .conditions = words_whose(l),
                           .inside = l->of_the_paper,
                           .claimed_order = -1,
                           .fit = fit,
                           .verdict = holds ? CLAIM_HOLDS : CLAIM_REFUTED };
  snprintf(text, sizeof text, "mean velocity ~ T^%.3f", fit.order);
  snprintf(row.measured, sizeof row.measured, "%s", text);
  l->sink(l->context, &row);
}

void claims_in_words(const struct scallop_crawler *crawler, const struct scallop_gait *gait, claim_sink *sink, void *context)
{
  struct words l = { .sink = sink, .context = context };
  if (!gait) {
    reversible_kinematics(&l);
    words_of_jumps(&l);
  }
  for (int g = 0; gait ? g == 0 : scallop_gait_name(g) != NULL; g++) {
    l.crawler.gait = gait ? gait : scallop_gait_named(scallop_gait_name(g));
    over_random_crawlers(&l);
    words_of_random_peaks(&l);
    for (int paper = 1; paper >= 0; paper--) {
      const struct scallop_gait *this_gait = l.crawler.gait;
      l.crawler = paper ? scallop_crawler_default() : *crawler;
      if (!paper)
        l.crawler.T = 0.5 * words_natural_time(crawler);
      l.crawler.gait = this_gait;
      l.of_the_paper = paper;
      words_of_peaks(&l);
      over_durations(&l);
      over_force_ratio(&l);
      over_alpha(&l);
      over_period(&l);
      words_of_steady_states(&l);
    }
  }
}
