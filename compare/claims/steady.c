/* The claims in words about the steady state: (27) for which alpha, when the steady state is reached, and two gaits
 * that the paper does not have. */
#include <math.h>

#include "compare/claims/decide.h"
#include "compare/claims/evidence.h"

/* (27) over the certified v_start for alphas 0.08 apart, minus 1. x1: the largest error, at alpha = x2; x3: that at the
 * alpha to name; x4: the alpha of the motions */
void velocity_in_the_limit(struct question *q)
{
  const struct alphas *alphas = q->claim->with;
  for (int i = alphas->first; i <= alphas->first + 48; i += 8) {
    q->found[3] = i / 100.;
    solve_motions(q, true);
    double error = q->solved ? number_of(q, alphas->error) : NAN;
    if (i == alphas->shown)
      q->found[2] = error;
    if (!(fabs(error) <= fabs(q->found[0]))) {
      q->found[0] = error;
      q->found[1] = i / 100.;
    }
  }
  q->row.inside = alphas->first > 50;
  if (fabs(q->found[0]) < 1e-15)
    rest_on_samples(q, 7);
  conclude(q);
  if (!q->of_the_paper)
    *q->row.reason = '\0';
}

/* Periods from rest until the velocity is within 1e-6 L/T of the steady one, or, with `same`, until it is the same; 0:
 * not in 1000 */
static int periods_until(const struct scallop_crawler *c, bool same)
{
  struct scallop_period_result p = { .v_end = 0 };
  double v = steady_state(c).period.v_start;
  for (int n = 1; n <= 1000; n++) {
    double before = p.v_end;
    if (scallop_period(c, before, &p) < 0)
      return 0;
    if (same ? p.v_end == before : fabs(p.v_end - v) <= 1e-6 * c->L / c->T)
      return same ? n - 1 : n;
  }
  return 0;
}

/* x1: periods until the velocity is the steady one; x2: until it is near */
void reached(struct question *q)
{
  solve_motions(q, true);
  q->found[0] = periods_until(&q->motion[1].crawler, true);
  q->found[1] = periods_until(&q->motion[1].crawler, false);
  conclude(q);
}

/* l' constant out and back: many steady states */
static const struct scallop_piece out[] = {
  { .begin = 0, .end = 1, .direction = 1, .jump = true, .linear = true, .velocity = 1, .curve = &scallop_curve_linear }
};
static const struct scallop_piece back[] = { { .begin = 0,
                                               .end = 1,
                                               .direction = -1,
                                               .jump = true,
                                               .linear = true,
                                               .velocity = -1,
                                               .curve = &scallop_curve_linear } };
static const struct scallop_gait sawtooth = {
  "sawtooth", { { out, 1, 0, 0, 1, 1, false, false }, { back, 1, 0, 0, 1, -1, false, false } }
};

/* x1, x2: the ends of the interval of steady start velocities */
static void unique_with_jumps(struct question *q)
{
  struct scallop_crawler c = q->crawler;
  struct scallop_steady_result r;
  c.alpha = 0.5;
  c.gait = &sawtooth;
  q->row.gait = sawtooth.name;
  q->solved = scallop_steady(&c, &r) >= 0;
  q->found[0] = r.v_low * c.T / c.L;
  q->found[1] = r.v_high * c.T / c.L;
  conclude(q);
}

/* Section 4.2 takes l(t) = l(T - t) for symmetric; its argument needs l'' to change sign from phase to phase. A gait
 * with the first and not the second: phases of equal duration, the extension gathering speed in its first fifth and
 * losing it in the rest, the contraction the same backward in time. */
static const struct scallop_piece quick_start[] = { SCALLOP_RAMP(0, 0.2, SCALLOP_FROM_START, 1, 10),
                                                    SCALLOP_RAMP(0.8, 0, SCALLOP_FROM_END, 1, -2.5) };
static const struct scallop_piece quick_end[] = { SCALLOP_RAMP(0, 0.8, SCALLOP_FROM_START, -1, -2.5),
                                                  SCALLOP_RAMP(0.2, 0, SCALLOP_FROM_END, -1, 10) };
static const struct scallop_gait reversible = {
  "reversible", { { quick_start, 2, 10, -2.5, 2, 1, true, true }, { quick_end, 2, -2.5, 10, 2, -1, true, true } }
};

static void reversible_kinematics(struct question *q)
{
  q->crawler.gait = &reversible;
  q->row.gait = reversible.name;
  solve_motions(q, false);
  conclude(q);
}

const struct claim claims_once[] = {
  { "reversible_kinematics_do_not_move", "4.2", "displacement", reversible_kinematics,
    "l(t) = l(T - t): l' rises for 0.2 of the extension and falls for 0.8, alpha = 1/2, else the paper's crawler",
    "steady alpha=0.5", .says = "abs(displacement)/L <= 1e-14", .measured = "displacement/L: {6f displacement/L}" },
  { "steady_state_is_unique", "5", "v_start", unique_with_jumps,
    "l' constant out and back, with jumps; alpha = 1/2, else the paper's crawler", .says = "x1 = x2", .outside = true,
    .measured = "every v_start T/L from {6f x1} to {6f x2} is steady",
    .reason =
        "by hand: while |x_C'| < L/T the bodies move oppositely throughout; x_C' gains (F1-F2)T/(2M) = 0.75 in the "
        "extension and loses it again" },
  { .name = NULL },
};
