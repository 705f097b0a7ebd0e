/* What the claims in words share, and those about the figures: one extension against its duration, the steady state against F1/F2,
 * alpha and T. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <gsl/gsl_qrng.h>

#include "compare/breakdown/events.h"
#include "compare/claims/words.h"
#include "numerics/numerics.h"

const char *words_whose(const struct words *l) { return l->of_the_paper ? "the paper's crawler" : "the ledger's crawler"; }

struct scallop_crawler words_paper_crawler(const struct words *w)
{
  struct scallop_crawler c = scallop_crawler_default();
  c.gait = w->crawler.gait;
  return c;
}

enum claim_verdict words_verdict(bool holds, bool proven)
{
  return holds ? CLAIM_HOLDS : proven ? CLAIM_REFUTED : CLAIM_UNDECIDED;
}

void words_enter(const struct words *w, const struct words_claim *claim, const char *conditions, bool inside,
                 enum claim_verdict verdict, const char *measured, const char *reason)
{
  struct claim_row row = { .equation = claim->section,
                           .quantity = claim->quantity,
                           .gait = w->crawler.gait->name,
                           .conditions = conditions,
                           .inside = inside,
                           .claimed_order = NAN,
                           .slope = NAN,
                           .fit = { .order = NAN, .lo = NAN, .hi = NAN },
                           .verdict = verdict };
  snprintf(row.claim, sizeof row.claim, "%s", claim->claim);
  snprintf(row.measured, sizeof row.measured, "%s", measured);
  if (verdict != CLAIM_HOLDS && reason)
    snprintf(row.reason, sizeof row.reason, "%s", reason);
  w->sink(w->context, &row);
}

struct scallop_steady_result words_steady(const struct scallop_crawler *c)
{
  struct scallop_steady_result r;
  if (scallop_steady(c, &r) < 0)
    return (struct scallop_steady_result){ .mean_velocity = NAN,
                                           .period = { .v_start = NAN, .displacement = NAN, .multiplier = NAN } };
  return r;
}

/* The duration at which the Froude number is 1 */
double words_natural_time(const struct scallop_crawler *c) { return sqrt((c->m1 + c->m2) / (c->F1 + c->F2) * c->L); }

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

static void reversible_kinematics(const struct words *l, const struct words_claim *claim)
{
  struct words r = *l;
  char text[120];
  r.crawler = scallop_crawler_default();
  r.crawler.alpha = 0.5;
  r.crawler.gait = &reversible;
  double moved = words_steady(&r.crawler).period.displacement / r.crawler.L;
  snprintf(text, sizeof text, "displacement/L: %.6f", moved);
  words_enter(&r, claim,
              "l(t) = l(T - t): l' rises for 0.2 of the extension and falls for 0.8, alpha = 1/2, else the paper's crawler",
              true, words_verdict(fabs(moved) <= WORDS_ZERO, true), text, NULL);
}

/* ---- one extension from rest against its duration, figure 4 ---- */

static struct scallop_phase_result extension(const struct scallop_crawler *crawler, double ratio, double T)
{
  struct scallop_crawler c = *crawler;
  struct scallop_phase_result r;
  c.F1 = ratio * c.F2;
  c.alpha = 0.5;
  c.T = 2 * T;
  if (scallop_phase(&c, SCALLOP_EXTENSION, 0, &r) < 0)
    return (struct scallop_phase_result){ .dxC = NAN, .v_end = NAN, .regime = SCALLOP_AT_REST };
  return r;
}

/* The longest extension from rest without sticking, to neighbouring doubles; nan if there is none */
static double onset_of_sticking(const struct scallop_crawler *crawler, double ratio)
{
  struct motion s = { .of = OF_PHASE, .crawler = *crawler };
  struct events events;
  double onset = NAN;
  s.crawler.F1 = ratio * s.crawler.F2;
  events_find(&events, &s, "");
  for (long i = 0; i < events.count && isnan(onset); i++)
    if (strstr(events.event[i].what, "onset of sticking"))
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

enum { GROWTH, PEAK };

static void over_durations(const struct words *l, const struct words_claim *claim)
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
  if (claim->which == GROWTH)
    snprintf(text, sizeof text, "least d(dx_C) over d((F1-F2)T^2/(2M)), 400 durations up to sticking: %.6f", least);
  else
    snprintf(text, sizeof text, "dv_C peaks at %.6f, %.6f, %.6f of the duration at which sticking begins", peak_at[0],
             peak_at[1], peak_at[2]);
  bool holds = claim->which == GROWTH ? least > 0 : peaks_inside == 3;
  words_enter(l, claim, range, l->of_the_paper, words_verdict(holds, true), text, NULL);
}

/* ---- the steady state against F1/F2 and alpha, figure 5 ---- */

static struct scallop_crawler with_ratio(const struct words *l, double ratio)
{
  struct scallop_crawler c = l->crawler;
  c.F1 = ratio * c.F2;
  return c;
}

static void at_ratio_1(const struct words *l, const struct words_claim *claim)
{
  char text[120];
  struct scallop_crawler equal = with_ratio(l, 1);
  double at_1 = fabs(words_steady(&equal).mean_velocity) * equal.T / equal.L;
  snprintf(text, sizeof text, "|mean velocity| T/L at F1/F2 = 1: %s", at_1 <= WORDS_ZERO ? "below 1e-14" : "above 1e-14");
  words_enter(l, claim, words_whose(l), l->of_the_paper, words_verdict(at_1 <= WORDS_ZERO, true), text, NULL);
}

static void at_large_ratio(const struct words *l, const struct words_claim *claim)
{
  static const double ratios[] = { 1e2, 1e4, 1e6 };
  char text[120];
  double far[3];
  for (int i = 0; i < 3; i++) {
    struct scallop_crawler c = with_ratio(l, ratios[i]);
    far[i] = words_steady(&c).mean_velocity * c.T / c.L;
  }
  snprintf(text, sizeof text, "mean velocity T/L at F1/F2 = 1e2, 1e4, 1e6: %.3g, %.3g, %.3g", far[0], far[1], far[2]);
  words_enter(l, claim, words_whose(l), l->of_the_paper, words_verdict(fabs(far[2]) <= WORDS_ZERO, true), text, NULL);
}

static void over_alpha(const struct words *l, const struct words_claim *claim)
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
  words_enter(l, claim, range, l->of_the_paper, words_verdict(least_rise > 0, true), text, NULL);
}

static void over_period(const struct words *l, const struct words_claim *claim)
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
  struct claim_row row = { .slope = NAN,
                           .equation = claim->section,
                           .quantity = claim->quantity,
                           .gait = l->crawler.gait->name,
                           .conditions = words_whose(l),
                           .inside = l->of_the_paper,
                           .claimed_order = -1,
                           .fit = fit,
                           .verdict = holds ? CLAIM_HOLDS : CLAIM_REFUTED };
  snprintf(text, sizeof text, "mean velocity ~ T^%.3f", fit.order);
  snprintf(row.claim, sizeof row.claim, "%s", claim->claim);
  snprintf(row.measured, sizeof row.measured, "%s", text);
  l->sink(l->context, &row);
}

const struct words_claim words_of_figures[] = {
  { "reversible_kinematics_do_not_move", "4.2", "displacement", WORDS_ONCE, reversible_kinematics, 0 },
  { "displacement_grows_with_duration", "4.4", "dx_C", WORDS_EACH_CRAWLER, over_durations, GROWTH },
  { "velocity_change_is_not_monotone", "4.4", "dv_C", WORDS_EACH_CRAWLER, over_durations, PEAK },
  { "mean_velocity_vanishes_at_ratio_1", "4.5", "mean velocity", WORDS_EACH_CRAWLER, at_ratio_1, 0 },
  { "mean_velocity_vanishes_at_large_ratio", "4.5", "mean velocity", WORDS_EACH_CRAWLER, at_large_ratio, 0 },
  { "mean_velocity_grows_with_alpha", "4.5", "mean velocity", WORDS_EACH_CRAWLER, over_alpha, 0 },
  { "mean_velocity_goes_as_1_over_T", "4.3.3", "mean velocity", WORDS_EACH_CRAWLER, over_period, 0 },
  { .claim = NULL }
};
