/* Statements about every crawler: held against random ones, masses and forces within a factor of 10, 0.05 < alpha <
 * 0.95, Froude from 0.1. Those that hold have their proofs in docs/theory.md, The motion in words; here stands how far
 * each is from failing. */
#include <float.h>
#include <math.h>
#include <string.h>

#include <gsl/gsl_qrng.h>

#include "compare/claims/statement.h"

enum { RANDOM_CRAWLERS = 400 };

/* Of a Sobol sequence: L = 1, eps from 0.01 to 10 */
static struct scallop_crawler next_crawler(gsl_qrng *sequence, const struct scallop_gait *gait)
{
  double u[6];
  gsl_qrng_get(sequence, u);
  struct scallop_crawler c = { .L = 1, .gait = gait, .alpha = 0.05 + 0.9 * u[4] };
  c.m1 = pow(10, 2 * u[0] - 1), c.m2 = pow(10, 2 * u[1] - 1);
  c.F1 = pow(10, 2 * u[2] - 1), c.F2 = pow(10, 2 * u[3] - 1);
  c.T = sqrt((c.m1 + c.m2) / (c.F1 + c.F2)) * pow(10, 1.5 * u[5] - 1);
  return c;
}

/* What a statement is about: a number, which is -INFINITY where it is about other crawlers */

static double forwards(double x, const struct scallop_crawler *c) { return c->F1 > c->F2 ? x : -x; }

/* How far the velocity is from the steady one, over L/T, once it is within 1e-6 or after 20000 periods from rest */
static void settled(struct question *q, struct scallop_crawler c, double x[RANDOM_NUMBERS])
{
  const double v = steady(q, c).v_start;
  struct scallop_period_result p = { .v_end = 0 };
  for (int n = 0; n < 20000 && fabs(p.v_end - v) * c.T > 1e-6; n++)
    p.v_end = scallop_period(&c, p.v_end, &p) < 0 ? NAN : p.v_end;
  x[0] = fabs(p.v_end - v) * c.T;
}

enum { MULTIPLIER, SLIDES_BACKWARD, STICKS_BACKWARD, BOTH_REST, EXCHANGED };

static void steady_state(struct question *q, struct scallop_crawler c, double x[RANDOM_NUMBERS])
{
  const struct solved s = steady(q, c);
  const double backward = forwards(s.displacement, &c) * (c.alpha > 0.5 ? -1 : 1);
  const bool slides = s.regime == SCALLOP_SLIDING;
  x[MULTIPLIER] = s.multiplier;
  x[SLIDES_BACKWARD] = slides ? backward : -INFINITY;
  x[STICKS_BACKWARD] = slides ? -INFINITY : backward;
  x[BOTH_REST] = strstr(s.modes, "00") != NULL;
  x[EXCHANGED] = fabs(s.displacement + steady(q, exchanged(c)).displacement);
}

enum { EQUAL_FORCES_MOVE, EQUAL_FORCES_AGREE, EQUAL_TIMES_MOVE, EQUAL_TIMES_FORWARD, QUICK_BACKWARD };

/* With F2 = F1; with alpha = 1/2; at Froude number 1e8 */
static void changed(struct question *q, struct scallop_crawler c, double x[RANDOM_NUMBERS])
{
  struct scallop_crawler equal = c, half = c, quick = c;
  equal.F2 = c.F1;
  half.alpha = 0.5;
  quick.T = 1e-4 * sqrt((c.m1 + c.m2) / (c.F1 + c.F2) * c.L);
  const struct solved e = steady(q, equal), h = steady(q, half), k = steady(q, quick);
  const double forward = forwards(h.v_start, &c);
  x[EQUAL_FORCES_MOVE] = fabs(e.displacement);
  x[EQUAL_FORCES_AGREE] = strcmp(e.modes, "-+ | +-") == 0 ? fabs(e.v_start) * c.T : 1;
  x[EQUAL_TIMES_MOVE] = fabs(h.displacement);
  x[EQUAL_TIMES_FORWARD] = fmax(fabs(h.v_start + h.v_mid), forward) * c.T;
  x[QUICK_BACKWARD] = -k.v_start * k.displacement;
}

enum { V0_TAKES_WAY, V0_ADDS_CHANGE };

static void moving(struct question *q, struct scallop_crawler c, double x[RANDOM_NUMBERS])
{
  const double v0 = 0.1 * c.L / c.T;
  const struct solved rest = extension(q, c, 0), p = extension(q, c, v0);
  x[V0_TAKES_WAY] = rest.dxC - p.dxC;
  x[V0_ADDS_CHANGE] = p.v_end - v0 - rest.v_end;
}

enum { VELOCITY_FALLS, CENTRE_BACKWARD, TURNS_OTHERWISE, LAST_OVER_HALF, LAST_SHRINKS };

/* With F1 > F2, the names of the bodies exchanged if need be; what is said of sliding is not about others. */
static void stronger_first(struct question *q, struct scallop_crawler c, double x[RANDOM_NUMBERS])
{
  const double F1 = fmax(c.F1, c.F2), F2 = fmin(c.F1, c.F2);
  c.F1 = F1, c.F2 = F2;
  struct scallop_crawler same = c, longer = c;
  same.m2 = c.m1;
  longer.T *= 1.01;
  const struct solved s = steady(q, c), p = extension(q, c, 0), l = extension(q, longer, 0);
  const double half = scallop_phase_duration(&c, SCALLOP_EXTENSION) / 2;
  const bool slides = F1 > F2 && p.regime == SCALLOP_SLIDING;
  x[VELOCITY_FALLS] = F1 > F2 && s.regime == SCALLOP_SLIDING ? s.v_start - s.v_mid : -INFINITY;
  x[CENTRE_BACKWARD] = F1 > F2 ? -extension(q, same, 0).dxC : -INFINITY;
  x[TURNS_OTHERWISE] = slides ? strcmp(p.modes, "-+ ++") != 0 : -INFINITY;
  x[LAST_OVER_HALF] = slides ? p.dT - half : -INFINITY;
  x[LAST_SHRINKS] = slides && l.regime == SCALLOP_SLIDING ? p.dT - l.dT : -INFINITY;
}

/* The counterexample as it is printed, with four digits, certified; or, if that is none, in doubles */
static void certify(struct question *q)
{
  const struct statement *claim = q->claim;
  struct scallop_crawler c = q->crawler;
  double *const numbers[] = { &c.m1, &c.m2, &c.F1, &c.F2, &c.T, &c.alpha }, x[RANDOM_NUMBERS];
  for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
    *numbers[i] = short_number(*numbers[i], 4);
  q->by = CERTIFIED_CRAWLER;
  claim->measure(q, c, x);
  if (compare(x[claim->number], claim->limit) > 0) {
    q->crawler = c;
    q->largest = x[claim->number];
  } else {
    q->by = MEASURED;
    q->solved = true;
  }
}

void at_random(struct question *q, struct scallop_crawler any)
{
  const struct statement *claim = q->claim;
  gsl_qrng *sequence = gsl_qrng_alloc(gsl_qrng_sobol, 6);
  int meant = 0, held = 0, failed = 0;
  double x[RANDOM_NUMBERS], *const largest = &q->largest;
  *largest = -INFINITY;
  q->by = MEASURED;
  for (int i = 0; sequence && i < RANDOM_CRAWLERS; i++) {
    const struct scallop_crawler c = next_crawler(sequence, any.gait);
    claim->measure(q, c, x);
    const double number = x[claim->number];
    if (number == -INFINITY)
      continue;
    meant++;
    held += number <= claim->limit;
    failed += number > claim->limit;
    q->crawler = number > *largest ? c : q->crawler;
    *largest = fmax(*largest, number);
  }
  gsl_qrng_free(sequence);
  if (failed > 0) {
    certify(q);
    conclude(q, -1, "not so for %d of %d crawlers, by up to %.3g", failed, meant, *largest - claim->limit);
  } else {
    q->by = SAMPLED;
    conclude(q, held > 0 && held == meant, claim->holds, meant);
  }
  q->row.sampled = meant;
}

static void attracts(struct question *q, struct scallop_crawler c)
{
  at_random(q, c);
  if (q->row.verdict == CLAIM_HOLDS)
    conclude(q, 1, "largest multiplier of the period map: %.4f", q->largest);
}

static void moves_forward(struct question *q, struct scallop_crawler c)
{
  at_random(q, c);
  if (q->row.verdict != CLAIM_REFUTED)
    return;
  c = q->crawler;
  conclude(q, -1, "largest displacement/L against the sign of (F1-F2)(2 alpha-1): %.3g", q->largest);
  show(q, "scallop steady --m1 %.4g --m2 %.4g --F1 %.4g --F2 %.4g --L 1 --T %.4g --alpha %.4g --gait %s", c.m1, c.m2,
       c.F1, c.F2, c.T, c.alpha, c.gait->name);
}

#define SET "400 quasi-random crawlers, masses and forces within 100:1"
static const char whole_set[] = SET ", sliding to stick-slip", faster[] = SET ", v0 = alpha/10 L over the duration";
static const char from_rest[] = SET ", F1 > F2, from rest, those that slide";
static const char forward[] = "longer_extension_moves_forward", still[] = "largest |displacement|/L: below 1e-14";

const struct statement statements_at_random[] = {
  { "equal_forces_do_not_move", "4.1", "displacement", whole_set, .measure = changed, .number = EQUAL_FORCES_MOVE,
    .limit = 1e-14, .proven = true, .holds = still },
  { "symmetric_timing_does_not_move", "4.2", "displacement", whole_set, .measure = changed, .number = EQUAL_TIMES_MOVE,
    .limit = 1e-14, .proven = true, .holds = still },
  { "steady_state_attracts", "4.3.2", "multiplier", whole_set, .measure = steady_state, .number = MULTIPLIER,
    .limit = 1 - DBL_EPSILON, .holds = "%d crawlers", .decide = attracts },
  { "motion_always_settles", "5", "v", whole_set, .measure = settled, .limit = 1e-6,
    .holds = "largest |v - v_start| T/L after at most 20000 periods from rest: below 1e-6" },
  { forward, "4.4", "displacement", "400 quasi-random crawlers: those that slide", .measure = steady_state,
    .number = SLIDES_BACKWARD, .limit = 1e-14, .decide = moves_forward,
    .holds = "largest displacement/L against the sign of (F1-F2)(2 alpha-1): 0" },
  { forward, "4.4", "displacement", "400 quasi-random crawlers: those in stick-slip", .measure = steady_state,
    .number = STICKS_BACKWARD, .limit = 1e-14, .decide = moves_forward, .outside = true,
    .holds = "largest displacement/L against the sign of (F1-F2)(2 alpha-1): 0" },
  { "one_body_always_moves", "2", "modes", whole_set, .measure = steady_state, .number = BOTH_REST, .proven = true,
    .holds = "x2' - x1' = l'; both bodies at rest at once in a steady state: never" },
  { "which_body_is_1_does_not_matter", "2", "displacement", SET "; m1 and m2, F1 and F2 exchanged",
    .measure = steady_state, .number = EXCHANGED, .limit = 1e-14, .proven = true,
    .holds = "displacement of one plus that of the other, over L: below 1e-14" },
  { "equal_forces_bodies_oppose", "(6), (7)", "modes", SET "; F2 = F1", .measure = changed,
    .number = EQUAL_FORCES_AGREE, .limit = 1e-14, .proven = true,
    .holds = "the modes are -+ | +- and |v_start| T/L is below 1e-14" },
  { "velocity_rises_over_extension", "4.2", "v_mid", SET ", F1 > F2, the steady states that slide",
    .measure = stronger_first, .number = VELOCITY_FALLS, .proven = true,
    .holds = "v_mid >= v_start for all (%d crawlers)" },
  { "symmetric_timing_starts_backward", "4.2", "v_start", SET "; alpha = 1/2", .measure = changed,
    .number = EQUAL_TIMES_FORWARD, .limit = 1e-14, .proven = true,
    .holds = "v_start = -v_mid to 1e-14 L/T, and never on the side of F1 - F2" },
  { "centre_moves_forward_in_an_extension", "4.3", "dx_C", SET ", F1 > F2, m1 = m2, from rest",
    .measure = stronger_first, .number = CENTRE_BACKWARD, .limit = -DBL_MIN, .proven = true,
    .holds = "dx_C > 0 for all (%d crawlers)" },
  { "extension_from_rest_has_two_intervals", "4.3.1", "modes", from_rest, .measure = stronger_first,
    .number = TURNS_OTHERWISE, .proven = true, .holds = "the modes are -+ ++ for all (%d crawlers)" },
  { "first_interval_is_the_greater_part", "4.3.1", "dT", from_rest, .measure = stronger_first, .number = LAST_OVER_HALF,
    .proven = true, .holds = "dT is at most half of the duration for all (%d crawlers)" },
  { "last_interval_grows_with_duration", "4.3.1", "dT", from_rest, .measure = stronger_first, .number = LAST_SHRINKS,
    .proven = true, .holds = "dT does not shrink with the duration for any, here by 1 %% (%d crawlers)" },
  { "start_velocity_adds_displacement", "4.3.2", "dx_C", faster, .measure = moving, .number = V0_TAKES_WAY,
    .proven = true, .holds = "dx_C is not smaller than from rest for any" },
  { "start_velocity_takes_velocity_change", "4.3.2", "v_end", faster, .measure = moving, .number = V0_ADDS_CHANGE,
    .proven = true, .holds = "v_end - v0 is not larger than from rest for any" },
  { "start_velocity_is_forward_at_high_Froude", "5", "v_start", SET ", Froude number 1e8", .measure = changed,
    .number = QUICK_BACKWARD, .holds = "v_start against the displacement: never" },
  { .name = NULL },
};
