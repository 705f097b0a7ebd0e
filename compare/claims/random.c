/* Statements about every crawler: held against random ones, masses and forces within a factor of 10, 0.05 < alpha <
 * 0.95, Froude from 0.1. Those that hold have their proofs in docs/theory.md, The motion in words; here stands how far
 * each is from failing. */
#include <float.h>
#include <math.h>
#include <string.h>

#include <gsl/gsl_qrng.h>

#include "compare/claims/decide.h"

enum { RANDOM_CRAWLERS = 400 };

/* 10^x, rounded once: pow of one C library differs from that of another in the last bit. */
static double power_of_10(double x)
{
  SCOPED(arb, ten, power);
  arb_set_ui(ten, 10);
  arb_set_d(power, x);
  arb_pow(power, ten, power, EVIDENCE_BITS);
  return middle(power);
}

/* Of a Sobol sequence: L = 1, eps from 0.01 to 10 */
static struct scallop_crawler next_crawler(gsl_qrng *sequence, const struct scallop_gait *gait)
{
  double u[6];
  gsl_qrng_get(sequence, u);
  struct scallop_crawler c = { .L = 1, .gait = gait, .alpha = 0.05 + 0.9 * u[4] };
  c.m1 = power_of_10(2 * u[0] - 1), c.m2 = power_of_10(2 * u[1] - 1);
  c.F1 = power_of_10(2 * u[2] - 1), c.F2 = power_of_10(2 * u[3] - 1);
  c.T = sqrt((c.m1 + c.m2) / (c.F1 + c.F2)) * power_of_10(1.5 * u[5] - 1);
  return c;
}

/* What statements are about: numbers, -INFINITY where a statement is about other crawlers */

static double forwards(double x, const struct scallop_crawler *c) { return c->F1 > c->F2 ? x : -x; }

static double multiplier(struct question *q, struct scallop_crawler c) { return steady(q, c).multiplier; }

static double settles_late(struct question *q, struct scallop_crawler c)
{
  (void)q;
  return periods_from_rest(&c, 1e-6, 20000) == 0;
}

/* Of crawlers that slide, or of those that do not */
static double moves_backward(struct question *q, struct scallop_crawler c)
{
  const struct solved s = steady(q, c);
  const bool meant = (s.regime == SCALLOP_SLIDING) == (q->claim->regime == SCALLOP_SLIDING);
  return meant ? forwards(s.displacement, &c) * (c.alpha > 0.5 ? -1 : 1) : -INFINITY;
}

static double both_rest(struct question *q, struct scallop_crawler c)
{
  return strstr(steady(q, c).modes, "00") != NULL;
}

static double exchange_changes(struct question *q, struct scallop_crawler c)
{
  return fabs(steady(q, c).displacement + steady(q, exchanged(c)).displacement);
}

static double equal_forces_move(struct question *q, struct scallop_crawler c)
{
  c.F2 = c.F1;
  return fabs(steady(q, c).displacement);
}

static double equal_forces_agree(struct question *q, struct scallop_crawler c)
{
  const struct solved s = steady(q, c);
  return strcmp(s.modes, "-+ | +-") == 0 ? fabs(s.v_start) * c.T : 1;
}

static double equal_times_move(struct question *q, struct scallop_crawler c)
{
  c.alpha = 0.5;
  return fabs(steady(q, c).displacement);
}

static double equal_times_start_forward(struct question *q, struct scallop_crawler c)
{
  const struct solved s = steady(q, c);
  return fmax(fabs(s.v_start + s.v_mid), forwards(s.v_start, &c)) * c.T;
}

static double quick_starts_backward(struct question *q, struct scallop_crawler c)
{
  c.T = 1e-4 * sqrt((c.m1 + c.m2) / (c.F1 + c.F2) * c.L); /* Froude number 1e8 */
  const struct solved s = steady(q, c);
  return -s.v_start * s.displacement;
}

static double v0_takes_way(struct question *q, struct scallop_crawler c)
{
  return extension(q, c, 0).dxC - extension(q, c, 0.1 * c.L / c.T).dxC;
}

static double v0_adds_change(struct question *q, struct scallop_crawler c)
{
  const double v0 = 0.1 * c.L / c.T;
  return extension(q, c, v0).v_end - v0 - extension(q, c, 0).v_end;
}

static double velocity_falls(struct question *q, struct scallop_crawler c)
{
  const struct solved s = steady(q, c);
  return s.regime == SCALLOP_SLIDING ? s.v_start - s.v_mid : -INFINITY;
}

static double centre_backward(struct question *q, struct scallop_crawler c) { return -extension(q, c, 0).dxC; }

static double turns_otherwise(struct question *q, struct scallop_crawler c)
{
  const struct solved p = extension(q, c, 0);
  return p.regime == SCALLOP_SLIDING ? strcmp(p.modes, "-+ ++") != 0 : -INFINITY;
}

static double last_over_half(struct question *q, struct scallop_crawler c)
{
  const struct solved p = extension(q, c, 0);
  return p.regime == SCALLOP_SLIDING ? p.dT - scallop_phase_duration(&c, SCALLOP_EXTENSION) / 2 : -INFINITY;
}

static double last_shrinks(struct question *q, struct scallop_crawler c)
{
  const struct solved p = extension(q, c, 0);
  c.T *= 1.01;
  const struct solved longer = extension(q, c, 0);
  return p.regime == SCALLOP_SLIDING && longer.regime == SCALLOP_SLIDING ? p.dT - longer.dT : -INFINITY;
}

/* The counterexample as it is printed, with four digits, certified; or, if that is none, in doubles */
static void certify(struct question *q)
{
  struct scallop_crawler c = q->crawler;
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    *crawler_field(&c, i) = short_number(crawler_number(&c, i), 4);
  q->by = CERTIFIED_CRAWLER;
  const double number = q->claim->measure(q, c);
  if (compare(number, q->claim->limit) > 0) {
    q->crawler = c;
    q->largest = number;
  } else {
    q->by = MEASURED;
    q->solved = true;
  }
}

void at_random(struct question *q, struct scallop_crawler c)
{
  const double limit = q->claim->limit;
  gsl_qrng *sequence = gsl_qrng_alloc(gsl_qrng_sobol, 6);
  int meant = 0, held = 0, failed = 0;
  q->largest = -INFINITY;
  q->by = MEASURED;
  for (int i = 0; sequence && i < RANDOM_CRAWLERS; i++) {
    c = next_crawler(sequence, c.gait);
    const double number = set_conditions(&c, q->claim->conditions) ? q->claim->measure(q, c) : -INFINITY;
    meant += number != -INFINITY;
    held += number != -INFINITY && number <= limit;
    failed += number > limit;
    q->crawler = number > q->largest ? c : q->crawler;
    q->largest = fmax(q->largest, number);
  }
  gsl_qrng_free(sequence);
  q->row.sampled = meant;
  if (failed > 0)
    certify(q);
  else
    q->by = SAMPLED;
  const int verdict = failed > 0 ? -1 : held > 0 && held == meant;
  c = q->crawler;
  if (q->claim->found)
    conclude(q, verdict, q->claim->found, fmax(q->largest, 0));
  else if (failed > 0)
    conclude(q, verdict, "not so for %d of %d crawlers, by up to %.3g", failed, meant, q->largest - limit);
  else
    conclude(q, verdict, q->claim->holds, meant);
  if (q->claim->found)
    show(q, "scallop steady --m1 %.4g --m2 %.4g --F1 %.4g --F2 %.4g --L 1 --T %.4g --alpha %.4g --gait %s", c.m1, c.m2,
         c.F1, c.F2, c.T, c.alpha, c.gait->name);
}

#define SET "400 quasi-random crawlers, masses and forces within 100:1"
static const char whole_set[] = SET ", sliding to stick-slip", faster[] = SET ", v0 = alpha/10 L over the duration";
static const char from_rest[] = SET ", F1 > F2, from rest, those that slide";
static const char backward[] = "largest displacement/L against the sign of (F1-F2)(2 alpha-1): %.3g";
static const char forward[] = "longer_extension_moves_forward", still[] = "largest |displacement|/L: below 1e-14";

const struct statement statements_at_random[] = {
  { "equal_forces_do_not_move", "4.1", "displacement", whole_set, .measure = equal_forces_move, .limit = 1e-14,
    .proven = true, .holds = still },
  { "symmetric_timing_does_not_move", "4.2", "displacement", whole_set, .measure = equal_times_move, .limit = 1e-14,
    .proven = true, .holds = still },
  { "steady_state_attracts", "4.3.2", "multiplier", whole_set, .measure = multiplier, .limit = 1 - DBL_EPSILON,
    .found = "largest multiplier of the period map: %.4f" },
  { "motion_always_settles", "5", "v", whole_set, .measure = settles_late,
    .holds = "largest |v - v_start| T/L after at most 20000 periods from rest: below 1e-6" },
  { forward, "4.4", "displacement", "400 quasi-random crawlers: those that slide", .measure = moves_backward,
    .limit = 1e-14, .found = backward },
  { forward, "4.4", "displacement", "400 quasi-random crawlers: those in stick-slip", .measure = moves_backward,
    .limit = 1e-14, .regime = SCALLOP_STICK_SLIP, .outside = true, .found = backward },
  { "one_body_always_moves", "2", "modes", whole_set, .measure = both_rest, .proven = true,
    .holds = "x2' - x1' = l'; both bodies at rest at once in a steady state: never" },
  { "which_body_is_1_does_not_matter", "2", "displacement", SET "; m1 and m2, F1 and F2 exchanged",
    .measure = exchange_changes, .limit = 1e-14, .proven = true,
    .holds = "displacement of one plus that of the other, over L: below 1e-14" },
  { "equal_forces_bodies_oppose", "(6), (7)", "modes", SET "; F2 = F1", .measure = equal_forces_agree, .limit = 1e-14,
    .proven = true, .holds = "the modes are -+ | +- and |v_start| T/L is below 1e-14" },
  { "velocity_rises_over_extension", "4.2", "v_mid", SET ", F1 > F2, the steady states that slide",
    .measure = velocity_falls, .proven = true, .holds = "v_mid >= v_start for all (%d crawlers)" },
  { "symmetric_timing_starts_backward", "4.2", "v_start", SET "; alpha = 1/2", .measure = equal_times_start_forward,
    .limit = 1e-14, .proven = true, .holds = "v_start = -v_mid to 1e-14 L/T, and never on the side of F1 - F2" },
  { "centre_moves_forward_in_an_extension", "4.3", "dx_C", SET ", F1 > F2, m1 = m2, from rest",
    .measure = centre_backward, .limit = -DBL_MIN, .proven = true, .holds = "dx_C > 0 for all (%d crawlers)" },
  { "extension_from_rest_has_two_intervals", "4.3.1", "modes", from_rest, .measure = turns_otherwise, .proven = true,
    .holds = "the modes are -+ ++ for all (%d crawlers)" },
  { "first_interval_is_the_greater_part", "4.3.1", "dT", from_rest, .measure = last_over_half, .proven = true,
    .holds = "dT is at most half of the duration for all (%d crawlers)" },
  { "last_interval_grows_with_duration", "4.3.1", "dT", from_rest, .measure = last_shrinks, .proven = true,
    .holds = "dT does not shrink with the duration for any, here by 1 %% (%d crawlers)" },
  { "start_velocity_adds_displacement", "4.3.2", "dx_C", faster, .measure = v0_takes_way, .proven = true,
    .holds = "dx_C is not smaller than from rest for any" },
  { "start_velocity_takes_velocity_change", "4.3.2", "v_end", faster, .measure = v0_adds_change, .proven = true,
    .holds = "v_end - v0 is not larger than from rest for any" },
  { "start_velocity_is_forward_at_high_Froude", "5", "v_start", SET ", Froude number 1e8",
    .measure = quick_starts_backward, .holds = "v_start against the displacement: never" },
  { .name = NULL },
};
