/* The claims in words about the figures: one extension against its duration (figure 4), the steady state against F1/F2, alpha and T
 * (figure 5). */
#include <float.h>
#include <math.h>

#include "compare/answers/answer.h"
#include "compare/claims/decide.h"

/* One extension from rest against its duration. x: the duration */

static struct scallop_phase_result lasting(const struct scallop_crawler *crawler, double x)
{
  struct scallop_crawler c = *crawler;
  c.alpha = 0.5;
  c.T = 2 * x;
  return extension(&c, 0);
}

static double v_end_of(const void *crawler, double x) { return lasting(crawler, x).v_end; }

/* The longest extension without sticking */
static double longest_sliding(struct scallop_crawler c)
{
  c.alpha = 0.5;
  return 0.5 * sticking_onset(&c);
}

enum { STEPS = 400 };

/* The least d(dx_C) over d((F1-F2)T^2/(2M)) from one duration to the next, up to sticking */
static double least_growth(const struct scallop_crawler *c)
{
  double onset = longest_sliding(*c), x = onset / (10 * STEPS), before = lasting(c, x).dxC, least = INFINITY;
  double growth = (c->F1 - c->F2) / (2 * (c->m1 + c->m2));
  for (int j = 1; j <= STEPS; j++) {
    double longer = onset * j / STEPS, moved = lasting(c, longer).dxC;
    least = fmin(least, (moved - before) / (growth * (longer - x) * (longer + x)));
    before = moved;
    x = longer;
  }
  return least;
}

/* The duration with the highest v_end, over that at which sticking begins */
static double peak_of_velocity(const struct scallop_crawler *c)
{
  double onset = longest_sliding(*c), highest = 0, at = 0;
  for (int j = 1; j <= STEPS; j++)
    if (lasting(c, onset * j / STEPS).v_end > highest) {
      highest = lasting(c, onset * j / STEPS).v_end;
      at = onset * j / STEPS;
    }
  return highest_between(v_end_of, c, at - onset / STEPS, at + onset / STEPS) / onset;
}

/* For F1/F2 = 2, 10, 40 */
static void three_ratios(struct question *q, double (*f)(const struct scallop_crawler *), double values[3])
{
  static const double ratios[] = { 2, 10, 40 };
  under(q, "%s, from rest, F1/F2 = 2, 10, 40", q->whose);
  for (int i = 0; i < 3; i++) {
    struct scallop_crawler c = q->crawler;
    c.F1 = ratios[i] * c.F2;
    values[i] = f(&c);
  }
}

void displacement_grows(struct question *q)
{
  double least[3];
  three_ratios(q, least_growth, least);
  double x = fmin(fmin(least[0], least[1]), least[2]);
  measured(q, "least d(dx_C) over d((F1-F2)T^2/(2M)), 400 durations up to sticking: %.6f", x);
  settle(q, x > 0, true);
}

void velocity_change_peaks(struct question *q)
{
  double peak[3];
  three_ratios(q, peak_of_velocity, peak);
  measured(q, "dv_C peaks at %.6f, %.6f, %.6f of the duration at which sticking begins", peak[0], peak[1], peak[2]);
  settle(q, peak[0] < 0.99 && peak[1] < 0.99 && peak[2] < 0.99, true);
}

/* One extension of the paper's crawler from a start velocity, against its duration */

struct fall {
  struct scallop_crawler c; /* with the duration after which it is shorter in T                       */
  double v0, longer, size;
};

/* The largest fall of the displacement between two durations, T from 0.05 on by 2 % */
static void largest_fall(struct fall *worst, struct scallop_crawler c, double v0)
{
  enum { DURATIONS = 260 };
  double most = -INFINITY, at = 0.05;
  c.T = at;
  for (int i = 0; i < DURATIONS; i++, c.T *= 1.02) {
    double x = extension(&c, v0).dxC / c.L;
    if (most - x > worst->size) {
      *worst = (struct fall){ c, v0, c.T, most - x };
      worst->c.T = at;
    }
    if (x > most) {
      most = x;
      at = c.T;
    }
  }
}

static void measure_fall(struct question *q, const struct fall *worst)
{
  const struct scallop_crawler paper = paper_crawler(q);
  struct scallop_crawler c = worst->c, longer = worst->c;
  double v0 = worst->v0;
  c.T = short_number(c.T, 4);
  longer.T = short_number(worst->longer, 4);
  arb_srcptr first = certified_phase(q, &c, SCALLOP_EXTENSION, v0)->dxC;
  arb_srcptr second = certified_phase(q, &longer, SCALLOP_EXTENSION, v0)->dxC;
  settle(q, false, arb_lt(second, first));
  measured(
      q,
      "%s: from v0 = %g at F1 = %g dx_C/L is %.6f for T = %.4g and %.6f for T = %.4g; these extensions last %.6g and %.6g",
      q->row.verdict == CLAIM_REFUTED ? "certified" : "not proven", v0, c.F1, extension(&c, v0).dxC / c.L, c.T,
      extension(&longer, v0).dxC / c.L, longer.T, c.T * c.alpha, longer.T * c.alpha);
  reason(q, "dxC falls from the first row to the second: printf 'T\\n%.4g\\n%.4g\\n' | ", c.T, longer.T);
  reason(q, "scallop phase --points - --F1 %g --v0 %g", c.F1, v0);
  command(q, "", &paper, " | cut -f 6,16");
}

void never_falls(struct question *q)
{
  static const double velocities[] = { 0.5, 1, 2, 5, 10, 20 };
  const struct ratios *ratios = q->with;
  struct fall worst = { .size = 1e-14 };
  under(q, "the paper's crawler, F1/F2 = %s, from v0 = 0.5, 1, 2, 5, 10, 20; T from 0.05 to 8.4 by 2 %%", ratios->text);
  q->row.inside = false;
  for (int i = 0; i < ratios->count; i++)
    for (size_t j = 0; j < sizeof velocities / sizeof *velocities; j++) {
      struct scallop_crawler c = q->crawler;
      c.F1 = ratios->value[i];
      largest_fall(&worst, c, velocities[j]);
    }
  if (worst.v0 > 0) {
    measure_fall(q, &worst);
    return;
  }
  measured(q, "it never falls by more than 1e-14 L");
  settle(q, true, false);
}

/* The steady state */

static double mean_velocity(const struct scallop_crawler *c) { return steady_state(c).mean_velocity * c->T / c->L; }

void no_velocity_at_ratio_1(struct question *q)
{
  struct scallop_crawler c = q->crawler;
  c.F1 = c.F2;
  bool holds = fabs(mean_velocity(&c)) <= EVIDENCE_ZERO;
  under(q, "%s", q->whose);
  measured(q, "|mean velocity| T/L at F1/F2 = 1: %s", holds ? "below 1e-14" : "above 1e-14");
  settle(q, holds, true);
}

void no_velocity_at_large_ratio(struct question *q)
{
  double far[3];
  struct scallop_crawler c = q->crawler;
  for (int i = 0; i < 3; i++) {
    static const double ratios[] = { 1e2, 1e4, 1e6 };
    c.F1 = ratios[i] * c.F2;
    far[i] = mean_velocity(&c);
  }
  under(q, "%s", q->whose);
  measured(q, "mean velocity T/L at F1/F2 = 1e2, 1e4, 1e6: %.3g, %.3g, %.3g", far[0], far[1], far[2]);
  settle(q, fabs(far[2]) <= EVIDENCE_ZERO, true);
}

void velocity_grows_with_alpha(struct question *q)
{
  double before = -INFINITY, least_rise = INFINITY, at_least = NAN;
  for (int i = 50; i < 100; i++) {
    struct scallop_crawler c = q->crawler;
    c.alpha = i / 100.0;
    double u = mean_velocity(&c);
    if (u - before < least_rise) {
      least_rise = u - before;
      at_least = c.alpha;
    }
    before = u;
  }
  under(q, "%s, alpha from 0.50 to 0.99", q->whose);
  measured(q, "least change of mean velocity T/L between alphas 0.01 apart: %.3g at alpha = %.2f", least_rise, at_least);
  settle(q, least_rise > 0, true);
}

void velocity_as_1_over_T(struct question *q)
{
  enum { POINTS = 24 };
  struct order_point points[POINTS];
  for (int k = 0; k < POINTS; k++) {
    struct scallop_crawler c = q->crawler;
    c.T = ldexp(c.T, -k);
    double u = steady_state(&c).mean_velocity;
    points[k] = (struct order_point){ .h = c.T, .err = u, .noise = 8 * DBL_EPSILON * fabs(u) };
  }
  q->row.claimed_order = -1;
  q->row.fit = order_estimate(points, POINTS);
  under(q, "%s", q->whose);
  measured(q, "mean velocity ~ T^%.3f", q->row.fit.order);
  settle(q, q->row.fit.state == ORDER_FITTED && fabs(q->row.fit.order + 1) <= 0.02, true);
}
