/* Statements about every crawler, tested with random ones: masses and forces from 0.1 to 10, 0.05 < alpha < 0.95,
 * Froude number from 0.1. Proofs are in docs/background/theory.md, The motion in words; the numbers are margins. */
#include <float.h>
#include <math.h>
#include <string.h>

#include <gsl/gsl_qrng.h>

#include "compare/claims/decide.h"

enum { RANDOM_CRAWLERS = 400 };

/* Numbers of a crawler's steady state, and from FIRST_FROM_REST on of an extension from rest */
enum number {
  MULTIPLIER,
  SETTLES_LATE,
  SEVERAL_STATES,
  BOTH_REST,
  EXCHANGE_CHANGES,
  EQUAL_FORCES_MOVE,
  EQUAL_TIMES_MOVE,
  EQUAL_FORCES_DIFFER,
  EQUAL_TIMES_FORWARD,
  QUICK_STARTS_BACKWARD,
  SLIDES_BACKWARD,
  STICKS_BACKWARD,
  VELOCITY_FALLS,
  FIRST_FROM_REST,
  V0_TAKES_WAY = FIRST_FROM_REST,
  V0_ADDS_CHANGE,
  CENTRE_BACKWARD,
  TURNS_OTHERWISE,
  LAST_OVER_HALF,
  LAST_SHRINKS
};

/* The statement holds for a crawler if its number is at most the limit. The summary is `found`, a format for the
 * largest number; if NULL, and the statement holds for all, `holds`, a format for the count of crawlers. */
struct fact {
  enum number number;
  double limit;
  const char *holds, *found;
};

/* Returns 10^x, rounded once: pow differs between C libraries in the last bit. */
static double power_of_10(double x)
{
  SCOPED(arb, ten, power);
  arb_set_ui(ten, 10);
  arb_set_d(power, x);
  arb_pow(power, ten, power, EVIDENCE_BITS);
  return middle(power);
}

/* Returns the next crawler of a Sobol sequence: L = 1, eps from 0.01 to 10 */
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

/* Returns the number of the statement; -INFINITY if the statement excludes this crawler. */
static double number_of(struct question *q, struct scallop_crawler c)
{
  const enum number number = ((const struct fact *)q->claim->data)->number;
  c.F2 = number == EQUAL_FORCES_MOVE ? c.F1 : c.F2;
  c.alpha = number == EQUAL_TIMES_MOVE ? 0.5 : c.alpha;
  if (number == QUICK_STARTS_BACKWARD) /* Froude number 1e8 */
    c.T = 1e-4 * sqrt((c.m1 + c.m2) / (c.F1 + c.F2) * c.L);
  const struct solved s = number < FIRST_FROM_REST ? solve_steady_state(q, c) : solve_extension(q, c, 0);
  const bool slides = s.regime == SCALLOP_SLIDING;
  const double forwards = c.F1 > c.F2 ? 1 : -1, backwards = forwards * (c.alpha > 0.5 ? -1 : 1);
  const double v0 = 0.1 * c.L / c.T, half = scallop_phase_duration(&c, SCALLOP_EXTENSION) / 2;
  struct scallop_crawler longer = c;
  longer.T *= 1.01;
  const struct solved l = number == LAST_SHRINKS ? solve_extension(q, longer, 0) : s;
  switch (number) {
  case MULTIPLIER: return s.multiplier;
  case SETTLES_LATE: return periods_from_rest(&c, 1e-6, 20000) == 0;
  case SEVERAL_STATES: return !s.single;
  case BOTH_REST: return strstr(s.modes, "00") != NULL;
  case EXCHANGE_CHANGES: return fabs(s.displacement + solve_steady_state(q, exchange_bodies(c)).displacement);
  case EQUAL_FORCES_MOVE:
  case EQUAL_TIMES_MOVE: return fabs(s.displacement);
  case EQUAL_FORCES_DIFFER: return strcmp(s.modes, "-+ | +-") == 0 ? fabs(s.v_start) * c.T : 1;
  case EQUAL_TIMES_FORWARD: return fmax(fabs(s.v_start + s.v_mid), forwards * s.v_start) * c.T;
  case QUICK_STARTS_BACKWARD: return -s.v_start * s.displacement;
  case SLIDES_BACKWARD: return slides ? backwards * s.displacement : -INFINITY;
  case STICKS_BACKWARD: return slides ? -INFINITY : backwards * s.displacement;
  case VELOCITY_FALLS: return slides ? s.v_start - s.v_mid : -INFINITY;
  case V0_TAKES_WAY: return s.dxC - solve_extension(q, c, v0).dxC;
  case V0_ADDS_CHANGE: return solve_extension(q, c, v0).v_end - v0 - s.v_end;
  case CENTRE_BACKWARD: return -s.dxC;
  case TURNS_OTHERWISE: return slides ? strcmp(s.modes, "-+ ++") != 0 : -INFINITY;
  case LAST_OVER_HALF: return slides ? s.dT - half : -INFINITY;
  case LAST_SHRINKS: return slides && l.regime == SCALLOP_SLIDING ? s.dT - l.dT : -INFINITY;
  }
  return NAN;
}

/* Certifies the counterexample with the four digits printed; returns `largest`, in doubles, if this fails. */
static double certify(struct question *q, double largest, double limit)
{
  struct scallop_crawler c = q->crawler;
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    *crawler_field(&c, i) = short_number(crawler_number(&c, i), 4);
  q->by = CERTIFIED_CRAWLER;
  const double number = number_of(q, c);
  if (compare(number, limit) > 0) {
    q->crawler = c;
    return number;
  }
  q->by = MEASURED;
  q->solved = true;
  return largest;
}

void at_random(struct question *q, struct scallop_crawler c)
{
  const struct fact *fact = q->claim->data;
  gsl_qrng *sequence = gsl_qrng_alloc(gsl_qrng_sobol, 6);
  int meant = 0, held = 0, failed = 0;
  double largest = -INFINITY;
  q->by = MEASURED;
  for (int i = 0; sequence && i < RANDOM_CRAWLERS; i++) {
    c = next_crawler(sequence, c.gait);
    const double number = set_conditions(&c, q->claim->conditions) ? number_of(q, c) : -INFINITY;
    meant += number != -INFINITY;
    held += number != -INFINITY && number <= fact->limit;
    failed += number > fact->limit;
    q->crawler = number > largest ? c : q->crawler;
    largest = fmax(largest, number);
  }
  gsl_qrng_free(sequence);
  q->row.sampled = meant;
  if (failed > 0)
    largest = certify(q, largest, fact->limit);
  else
    q->by = SAMPLED;
  const int verdict = failed > 0 ? -1 : held > 0 && held == meant;
  c = q->crawler;
  if (fact->found)
    conclude(q, verdict, fact->found, fmax(largest, 0));
  else if (failed > 0)
    conclude(q, verdict, "not so for %d of %d crawlers, by up to %.3g", failed, meant, largest - fact->limit);
  else
    conclude(q, verdict, fact->holds, meant);
  if (fact->found)
    show(q, "scallop steady --m1 %.4g --m2 %.4g --F1 %.4g --F2 %.4g --L 1 --T %.4g --alpha %.4g --gait %s", c.m1, c.m2,
         c.F1, c.F2, c.T, c.alpha, c.gait->name);
}

const struct fact steady_state_is_unique = {
  .number = SEVERAL_STATES,
  .holds = "proven for continuous l' (docs/background/theory.md, How many steady states); the solver finds one for %d "
           "of 400 quasi-random crawlers"
};

#define SET "400 quasi-random crawlers, masses and forces within 100:1"
static const char whole_set[] = SET ", sliding to stick-slip", faster[] = SET ", v0 = alpha/10 L over the duration";
static const char from_rest[] = SET ", F1 > F2, from rest, those that slide";
static const char backward[] = "largest displacement/L against the sign of (F1-F2)(2 alpha-1): %.3g";
static const char forward[] = "longer_extension_moves_forward", still[] = "largest |displacement|/L: below 1e-14";

#define FACT(...) \
  .test = at_random, .data = &(const struct fact) { __VA_ARGS__ }
const struct statement statements_at_random[] = {
  { "equal_forces_do_not_move", "4.1", "displacement", whole_set, FACT(EQUAL_FORCES_MOVE, 1e-14, .holds = still),
    .proven = true },
  { "symmetric_timing_does_not_move", "4.2", "displacement", whole_set, FACT(EQUAL_TIMES_MOVE, 1e-14, .holds = still),
    .proven = true },
  { "steady_state_attracts", "4.3.2", "multiplier", whole_set,
    FACT(MULTIPLIER, 1 - DBL_EPSILON, .found = "largest multiplier of the period map: %.4f") },
  { "motion_always_settles", "5", "v", whole_set,
    FACT(SETTLES_LATE, 0, .holds = "largest |v - v_start| T/L after at most 20000 periods from rest: below 1e-6") },
  { forward, "4.4", "displacement", "400 quasi-random crawlers: those that slide",
    FACT(SLIDES_BACKWARD, 1e-14, .found = backward) },
  { forward, "4.4", "displacement", "400 quasi-random crawlers: those in stick-slip",
    FACT(STICKS_BACKWARD, 1e-14, .found = backward), .outside = true },
  { "one_body_always_moves", "2", "modes", whole_set,
    FACT(BOTH_REST, 0, .holds = "x2' - x1' = l'; both bodies at rest at once in a steady state: never"),
    .proven = true },
  { "which_body_is_1_does_not_matter", "2", "displacement", SET "; m1 and m2, F1 and F2 exchanged",
    FACT(EXCHANGE_CHANGES, 1e-14, .holds = "displacement of one plus that of the other, over L: below 1e-14"),
    .proven = true },
  { "equal_forces_bodies_oppose", "(6), (7)", "modes", SET "; F2 = F1",
    FACT(EQUAL_FORCES_DIFFER, 1e-14, .holds = "the modes are -+ | +- and |v_start| T/L is below 1e-14"),
    .proven = true },
  { "velocity_rises_over_extension", "4.2", "v_mid", SET ", F1 > F2, the steady states that slide",
    FACT(VELOCITY_FALLS, 0, .holds = "v_mid >= v_start for all (%d crawlers)"), .proven = true },
  { "symmetric_timing_starts_backward", "4.2", "v_start", SET "; alpha = 1/2",
    FACT(EQUAL_TIMES_FORWARD, 1e-14, .holds = "v_start = -v_mid to 1e-14 L/T, and never on the side of F1 - F2"),
    .proven = true },
  { "centre_moves_forward_in_an_extension", "4.3", "dxC", SET ", F1 > F2, m1 = m2, from rest",
    FACT(CENTRE_BACKWARD, -DBL_MIN, .holds = "dxC > 0 for all (%d crawlers)"), .proven = true },
  { "extension_from_rest_has_two_intervals", "4.3.1", "modes", from_rest,
    FACT(TURNS_OTHERWISE, 0, .holds = "the modes are -+ ++ for all (%d crawlers)"), .proven = true },
  { "first_interval_is_the_greater_part", "4.3.1", "dT", from_rest,
    FACT(LAST_OVER_HALF, 0, .holds = "dT is at most half of the duration for all (%d crawlers)"), .proven = true },
  { "last_interval_grows_with_duration", "4.3.1", "dT", from_rest,
    FACT(LAST_SHRINKS, 0, .holds = "dT does not shrink with the duration for any, here by 1 %% (%d crawlers)"),
    .proven = true },
  { "start_velocity_adds_displacement", "4.3.2", "dxC", faster,
    FACT(V0_TAKES_WAY, 0, .holds = "dxC is not smaller than from rest for any"), .proven = true },
  { "start_velocity_takes_velocity_change", "4.3.2", "v_end", faster,
    FACT(V0_ADDS_CHANGE, 0, .holds = "v_end - v0 is not larger than from rest for any"), .proven = true },
  { "start_velocity_is_forward_at_high_Froude", "5", "v_start", SET ", Froude number 1e8",
    FACT(QUICK_STARTS_BACKWARD, 0, .holds = "v_start against the displacement: never") },
  { .name = NULL },
};
