/* Statements about the figures and the steady state: one extension against its duration (figure 4), mean velocity
 * against F1/F2, alpha and T (figure 5), range of alpha for (27), and number of periods to the steady state. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "compare/claims/decide.h"
#include "model/golden.h"

/* Figure 4, in doubles: an extension takes half of the period T. */

static const double ratios[] = { 2, 10, 40 };

static struct solved extension_at(struct scallop_crawler c, double T)
{
  c.T = T;
  return solve_extension(NULL, c, 0);
}

static double minus_v_end(void *c, double T) { return -extension_at(*(struct scallop_crawler *)c, T).v_end; }

/* Returns the least d(dxC) over d((F1-F2)T^2/(2M)) from one duration to the next, up to sticking. */
static double least_growth(const struct scallop_crawler *c)
{
  enum { STEPS = 400 };
  const double onset = sticking_onset(c), growth = (c->F1 - c->F2) / (8 * (c->m1 + c->m2));
  double T = onset / (10 * STEPS), dxC = extension_at(*c, T).dxC, least = INFINITY;
  for (int j = 1; j <= STEPS; j++) {
    const double before = T, moved = dxC;
    T = onset * j / STEPS;
    dxC = extension_at(*c, T).dxC;
    least = fmin(least, (dxC - moved) / (growth * (T - before) * (T + before)));
  }
  return least;
}

static void displacement_grows(struct question *q, struct scallop_crawler c)
{
  double least = INFINITY;
  q->by = MEASURED;
  c.alpha = 0.5;
  for (int i = 0; i < 3; i++) {
    c.F1 = ratios[i] * c.F2;
    least = fmin(least, least_growth(&c));
  }
  conclude(q, compare(least, 0), "least d(dxC) over d((F1-F2)T^2/(2M)), 400 durations up to sticking: %.6f", least);
}

static void velocity_change_peaks(struct question *q, struct scallop_crawler c)
{
  double x[3];
  q->by = MEASURED;
  c.alpha = 0.5;
  for (int i = 0; i < 3; i++) {
    c.F1 = ratios[i] * c.F2;
    const double onset = sticking_onset(&c);
    x[i] = golden_least(minus_v_end, &c, 0.01 * onset, onset, 1e-9 * onset) / onset;
  }
  conclude(q, compare(0.99, fmax(fmax(x[0], x[1]), x[2])),
           "dvC peaks at %.6f, %.6f, %.6f of the duration at which sticking begins", x[0], x[1], x[2]);
}

struct fall { /* decrease of the displacement of an extension from v0, between two periods */
  double size, v0, F1, T[2];
};

/* Sets fall to the largest decrease, if larger; T from 0.05 by 2 % */
static void find_fall(struct fall *fall, struct scallop_crawler c, double v0)
{
  enum { PERIODS = 260 };
  double most = -INFINITY, at = 0.05;
  c.T = at;
  for (int i = 0; i < PERIODS; i++, c.T *= 1.02) {
    double x = solve_extension(NULL, c, v0).dxC / c.L;
    if (most - x > fall->size)
      *fall = (struct fall){ most - x, v0, c.F1, { short_number(at, 4), short_number(c.T, 4) } };
    if (x > most) {
      most = x;
      at = c.T;
    }
  }
}

static void never_falls(struct question *q, struct scallop_crawler c)
{
  static const double velocities[] = { 0.5, 1, 2, 5, 10, 20 };
  struct fall fall = { .size = 1e-14 };
  for (const double *F1 = q->claim->data; *F1 > 0; F1++)
    for (size_t j = 0; j < sizeof velocities / sizeof *velocities; j++) {
      c.F1 = *F1;
      find_fall(&fall, c, velocities[j]);
    }
  if (fall.size == 1e-14) {
    q->by = MEASURED;
    conclude(q, 1, "it never falls by more than 1e-14 L");
    return;
  }
  double dxC[2], duration[2];
  c.F1 = fall.F1;
  for (int i = 0; i < 2; i++) {
    c.T = fall.T[i];
    dxC[i] = solve_extension(q, c, fall.v0).dxC / c.L;
    duration[i] = scallop_phase_duration(&c, SCALLOP_EXTENSION);
  }
  conclude(q, compare(dxC[1], dxC[0]),
           "certified: from v0 = %.6g at F1 = %.6g dxC/L is %.6f for T = %.4g and %.6f for T = %.4g; these extensions "
           "last %.6g and %.6g",
           fall.v0, fall.F1, dxC[0], fall.T[0], dxC[1], fall.T[1], duration[0], duration[1]);
  show(q,
       "dxC falls from the first row to the second: printf 'T\\n%.4g\\n%.4g\\n' | scallop phase --points - --F1 %.6g "
       "--v0 %.6g%s --columns T,dxC",
       fall.T[0], fall.T[1], fall.F1, fall.v0, write_options(q, q->crawler));
}

/* Figure 5 */

static void vanishes_at_ratio_1(struct question *q, struct scallop_crawler c)
{
  c.F1 = c.F2;
  const int zero = is_zero(solve_steady_state(q, c).mean_velocity);
  conclude(q, zero, "|mean velocity| T/L at F1/F2 = 1: %s 1e-14", zero > 0 ? "below" : "above");
}

static void vanishes_at_large_ratio(struct question *q, struct scallop_crawler c)
{
  static const double large[] = { 1e2, 1e4, 1e6 };
  double v[3];
  for (int i = 0; i < 3; i++) {
    c.F1 = large[i] * c.F2;
    v[i] = solve_steady_state(q, c).mean_velocity * c.T / c.L;
  }
  conclude(q, is_zero(v[2]), "mean velocity T/L at F1/F2 = 1e2, 1e4, 1e6: %.3g, %.3g, %.3g", v[0], v[1], v[2]);
}

static void grows_with_alpha(struct question *q, struct scallop_crawler c)
{
  double before = -INFINITY, least = INFINITY, at = 0;
  q->by = MEASURED;
  for (int i = 50; i < 100; i++) {
    c.alpha = i / 100.0;
    double v = solve_steady_state(q, c).mean_velocity * c.T / c.L;
    if (v - before < least) {
      least = v - before;
      at = c.alpha;
    }
    before = v;
  }
  conclude(q, compare(least, 0), "least change of mean velocity T/L between alphas 0.01 apart: %.3g at alpha = %.2f",
           least, at);
}

static void goes_as_1_over_T(struct question *q, struct scallop_crawler c)
{
  enum { POINTS = 24 };
  struct scallop_order_point points[POINTS];
  struct scallop_order_wanted wanted = { .order = NAN, .tolerance = CLAIM_TOLERANCE };
  int count = POINTS;
  q->by = MEASURED;
  for (int k = 0; k < POINTS; k++, c.T /= 2) {
    double v = solve_steady_state(q, c).mean_velocity;
    points[k] = (struct scallop_order_point){ .h = c.T, .err = v, .noise = 8 * DBL_EPSILON * fabs(v) };
  }
  scallop_order(points, &count, &wanted, &q->row.fit);
  q->row.claimed_order = -1;
  q->solved = q->row.fit.verdict == SCALLOP_ORDER_MEASURED;
  conclude(q, fabs(q->row.fit.order + 1) <= CLAIM_TOLERANCE ? 1 : -1, "mean velocity ~ T^%.3f", q->row.fit.order);
}

/* (27), T -> 0 */

static double velocity_by_27(struct scallop_crawler c, bool mirrored)
{
  return mirrored ? -velocity_by_27(exchange_bodies(c), false) : evaluate_printed(c, "eq27_v_start").value;
}

/* alpha in hundredths, seven by steps of 8 from the start in the conditions; the summary has the fourth */
static void in_the_limit(struct question *q, struct scallop_crawler c)
{
  const bool mirrored = strstr(q->claim->name, "mirrored");
  const int first = strstr(q->claim->conditions, "from 0.51") ? 51 : 1, named = first + 24;
  double largest = 0, at = 0, shown = 0;
  for (int i = first; i <= first + 48; i += 8) {
    c.alpha = i / 100.;
    const double error = velocity_by_27(c, mirrored) / solve_steady_state(q, c).v_start - 1;
    if (i == named)
      shown = error;
    if (!(fabs(error) <= fabs(largest))) {
      largest = error;
      at = c.alpha;
    }
  }
  q->row.inside = first > 50;
  if (fabs(largest) < 1e-15) {
    q->by = SAMPLED;
    q->row.sampled = 7;
    conclude(q, 1, "relative error, certified: below 1e-15 throughout");
  } else
    conclude(q, -1, "relative error, certified: %.6f at alpha = %.2f, largest %.6f at alpha = %.2f", shown,
             named / 100., largest, at);
  q->crawler.T = scallop_crawler_default().T; /* the command sets T */
  if (q->of_the_paper)
    show(q, "published against exact: scallop series --T 1e-6 --alpha %.2f%s | grep '^eq27_v_start.(27)'", named / 100.,
         write_options(q, q->crawler));
}

/* The steady state */

static void is_reached(struct question *q, struct scallop_crawler c)
{
  const double multiplier = solve_steady_state(q, c).multiplier;
  if (multiplier == 0)
    conclude(q, 1, "certified multiplier 0; from rest the velocity is the steady one after %d period",
             periods_from_rest(&c, 1e-15, 1000));
  else
    conclude(q, is_zero(multiplier),
             "certified multiplier %.10f > 0: the distance shrinks by that and is never 0; within 1e-6 L/T after %d "
             "periods",
             multiplier, periods_from_rest(&c, 1e-6, 1000));
  show(q, "the multiplier is not 0: scallop steady --certified%s --columns multiplier", write_options(q, c));
}

static const char grows[] = "displacement_grows_with_duration", reached[] = "steady_state_is_reached";
static const char limit[] = "eq27_v_start_in_the_limit", from_rest[] = "%s, from rest, F1/F2 = 2, 10, 40";

const struct statement statements_of_figures[] = {
  { grows, "4.4", "dxC", from_rest, .test = displacement_grows },
  { "velocity_change_is_not_monotone", "4.4", "dvC", from_rest, .test = velocity_change_peaks },
  { "mean_velocity_vanishes_at_ratio_1", "4.5", "mean velocity", "%s", .test = vanishes_at_ratio_1 },
  { "mean_velocity_vanishes_at_large_ratio", "4.5", "mean velocity", "%s", .test = vanishes_at_large_ratio },
  { "mean_velocity_grows_with_alpha", "4.5", "mean velocity", "%s, alpha from 0.50 to 0.99", .test = grows_with_alpha },
  { "mean_velocity_goes_as_1_over_T", "4.3.3", "mean velocity", "%s", .test = goes_as_1_over_T },
  { limit, "(27)", "v_start", "%s, T = 1e-20, alpha from 0.51 to 0.99 by 0.08", .test = in_the_limit },
  { limit, "(27)", "v_start", "%s, T = 1e-20, alpha from 0.01 to 0.49 by 0.08", .test = in_the_limit },
  { "eq27_v_start_mirrored_in_the_limit", "(27)", "v_start",
    "%s, T = 1e-20, alpha from 0.01 to 0.49 by 0.08; with F1 m1 and F2 m2 exchanged below the line",
    .test = in_the_limit, .only_paper_crawler = true },
  { grows, "4.4", "dxC", "%s, F1/F2 = 2, 4, 10, 40, from v0 = 0.5, 1, 2, 5, 10, 20; T from 0.05 to 8.4 by 2 %%",
    .test = never_falls, .data = (const double[]){ 2, 4, 10, 40, 0 }, .outside = true, .only_paper_crawler = true },
  { grows, "4.4", "dxC", "%s, F1/F2 = 1/4, 1/2, from v0 = 0.5, 1, 2, 5, 10, 20; T from 0.05 to 8.4 by 2 %%",
    .test = never_falls, .data = (const double[]){ 0.25, 0.5, 0 }, .outside = true, .only_paper_crawler = true },
  { "steady_state_is_unique", "5", "v_start", "l' continuous, any masses, forces > 0 and alpha", .test = at_random,
    .data = &steady_state_is_unique, .proven = true, .only_paper_crawler = true },
  { reached, "5", "v", "%s, T = 2, from rest; read as: after finitely many periods", .test = is_reached,
    .only_paper_crawler = true },
  { reached, "5", "v", "%s, T = 4, from rest; read as: after finitely many periods", .test = is_reached,
    .only_paper_crawler = true },
  { .name = NULL },
};
