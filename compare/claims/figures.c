/* The claims in words about the figures: one extension against its duration (figure 4), the steady state against F1/F2,
 * alpha and T (figure 5). */
#include <float.h>
#include <math.h>

#include "compare/answers/answer.h"
#include "compare/claims/decide.h"
#include "compare/claims/evidence.h"

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

/* x1, x2, x3: for F1/F2 = 2, 10, 40 */
static void three_ratios(struct question *q, double (*f)(const struct scallop_crawler *))
{
  static const double ratios[] = { 2, 10, 40 };
  for (int i = 0; i < 3; i++) {
    struct scallop_crawler c = q->crawler;
    c.F1 = ratios[i] * c.F2;
    q->found[i] = f(&c);
  }
  conclude(q);
}

void displacement_grows(struct question *q) { three_ratios(q, least_growth); }
void velocity_change_peaks(struct question *q) { three_ratios(q, peak_of_velocity); }

/* The largest fall of the displacement of an extension between two durations: x1: F1, x2: v0, x3, x4: T from 0.05 on by
 * 2 % */
static void largest_fall(double found[4], double *size, struct scallop_crawler c, double v0)
{
  enum { DURATIONS = 260 };
  double most = -INFINITY, at = 0.05;
  c.T = at;
  for (int i = 0; i < DURATIONS; i++, c.T *= 1.02) {
    double x = extension(&c, v0).dxC / c.L;
    if (most - x > *size) {
      *size = most - x;
      found[0] = c.F1, found[1] = v0, found[2] = short_number(at, 4), found[3] = short_number(c.T, 4);
    }
    if (x > most) {
      most = x;
      at = c.T;
    }
  }
}

void never_falls(struct question *q)
{
  static const double velocities[] = { 0.5, 1, 2, 5, 10, 20 };
  double size = 1e-14;
  for (const double *ratio = q->claim->with; *ratio > 0; ratio++)
    for (size_t j = 0; j < sizeof velocities / sizeof *velocities; j++) {
      struct scallop_crawler c = q->crawler;
      c.F1 = *ratio;
      largest_fall(q->found, &size, c, velocities[j]);
    }
  if (size > 1e-14)
    proven(q);
  else
    settle(q, true, false);
}

/* The least rise of mean velocity T/L from one alpha to the next, x1, and the latter, x2 */
void velocity_grows_with_alpha(struct question *q)
{
  double before = -INFINITY;
  q->found[0] = INFINITY;
  for (int i = 50; i < 100; i++) {
    struct scallop_crawler c = q->crawler;
    c.alpha = i / 100.0;
    double u = steady_state(&c).mean_velocity * c.T / c.L;
    if (u - before < q->found[0]) {
      q->found[0] = u - before;
      q->found[1] = c.alpha;
    }
    before = u;
  }
  conclude(q);
}

/* x1: the order of mean velocity in T */
void velocity_as_1_over_T(struct question *q)
{
  enum { POINTS = 24 };
  struct scallop_order_point points[POINTS];
  for (int k = 0; k < POINTS; k++) {
    struct scallop_crawler c = q->crawler;
    c.T = ldexp(c.T, -k);
    double u = steady_state(&c).mean_velocity;
    points[k] = (struct scallop_order_point){ .h = c.T, .err = u, .noise = 8 * DBL_EPSILON * fabs(u) };
  }
  q->row.claimed_order = -1;
  struct scallop_order_wanted wanted = { .order = NAN, .tolerance = CLAIM_TOLERANCE };
  int count = POINTS;
  scallop_order(points, &count, &wanted, &q->row.fit);
  q->solved = q->row.fit.verdict == SCALLOP_ORDER_MEASURED;
  q->found[0] = q->row.fit.order;
  conclude(q);
}
