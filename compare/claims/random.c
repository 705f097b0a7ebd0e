/* The claims in words about every crawler: held against random ones, masses and forces within a factor of 10, 0.05 < alpha < 0.95,
 * Froude from 0.1. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/claims/words.h"
#include "numerics/numerics.h"

enum { RANDOM_CRAWLERS = 400 };

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
/* Of a crawler that the statement is not about */
static const double NOT_MEANT = -INFINITY;

struct largest {
  double value; /* NAN if any is not a number                                                          */
  int of;       /* crawlers that are meant                                                             */
  struct scallop_crawler where;
};

/* The largest value of probe over random crawlers, and where it occurs */
static struct largest largest(probe *p, const struct scallop_gait *gait)
{
  struct largest most = { -INFINITY, 0, scallop_crawler_default() };
  gsl_qrng *q = gsl_qrng_alloc(gsl_qrng_sobol, 6);
  for (int i = 0; q && i < RANDOM_CRAWLERS && !isnan(most.value); i++) {
    struct scallop_crawler c = words_random(q, gait);
    double x = p(&c);
    most.of += x > NOT_MEANT;
    if (x > most.value || isnan(x)) {
      most.value = x;
      most.where = c;
    }
  }
  if (!q)
    most.value = NAN;
  else
    gsl_qrng_free(q);
  return most;
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

/* ---- statements that hold, with their proofs in docs/theory.md, The motion in words: how far each is from failing ---- */

/* A probe of what no crawler does: its values. */
static const double DOES = 1, DOES_NOT = -1;

/* F1 > F2, the paper's convention; F1 = F2 is for the caller to leave out. */
static struct scallop_crawler stronger_first(const struct scallop_crawler *c)
{
  struct scallop_crawler s = *c;
  s.F1 = fmax(c->F1, c->F2);
  s.F2 = fmin(c->F1, c->F2);
  return s;
}

/* An extension from v0, in L over its duration */
static struct scallop_phase_result extension(const struct scallop_crawler *c, double v0)
{
  struct scallop_phase_result r;
  if (scallop_phase(c, SCALLOP_EXTENSION, v0 * c->L / (c->alpha * c->T), &r) < 0)
    return (struct scallop_phase_result){ .dT = NAN, .v_end = NAN, .dxC = NAN, .regime = SCALLOP_SLIDING };
  return r;
}

static bool modes_are(const struct scallop_modes *modes, const char *text)
{
  char own[SCALLOP_MODES_TEXT];
  scallop_modes_text(modes, own);
  return strcmp(own, text) == 0;
}

static double both_rest(const struct scallop_crawler *c)
{
  struct scallop_steady_result s = words_steady(c);
  for (int kind = 0; kind < 2; kind++)
    for (int i = 0; i < s.period.modes[kind].count && i < SCALLOP_MODES_KEPT; i++)
      if (s.period.modes[kind].kept[i].s1 == 0 && s.period.modes[kind].kept[i].s2 == 0)
        return DOES;
  return DOES_NOT;
}

static double not_mirrored(const struct scallop_crawler *c)
{
  struct scallop_crawler mirrored = *c;
  mirrored.m1 = c->m2, mirrored.m2 = c->m1, mirrored.F1 = c->F2, mirrored.F2 = c->F1;
  return fabs(words_steady(c).period.displacement + words_steady(&mirrored).period.displacement) / c->L;
}

static double not_opposed(const struct scallop_crawler *c)
{
  struct scallop_crawler equal = *c;
  equal.F2 = equal.F1;
  struct scallop_steady_result s = words_steady(&equal);
  bool opposed = modes_are(&s.period.modes[0], "-+") && modes_are(&s.period.modes[1], "+-");
  return opposed ? fabs(s.period.v_start) * c->T / c->L : DOES;
}

/* How far v_start is from -v_mid, and on the side of F1 - F2 */
static double symmetric_start(const struct scallop_crawler *c)
{
  struct scallop_crawler symmetric = *c;
  symmetric.alpha = 0.5;
  struct scallop_steady_result s = words_steady(&symmetric);
  double sign = c->F1 > c->F2 ? 1 : -1;
  return fmax(fabs(s.period.v_start + s.period.v_mid), sign * s.period.v_start) * c->T / c->L;
}

static double slows_in_extension(const struct scallop_crawler *c)
{
  struct scallop_crawler s = stronger_first(c);
  struct scallop_steady_result r = words_steady(&s);
  if (r.period.regime != SCALLOP_SLIDING || s.F1 == s.F2)
    return NOT_MEANT;
  return (r.period.v_start - r.period.v_mid) * s.T / s.L;
}

/* At a Froude number of 1e8 */
static double starts_against_motion(const struct scallop_crawler *c)
{
  struct scallop_crawler fast = *c;
  fast.T = 1e-4 * words_natural_time(c);
  struct scallop_steady_result s = words_steady(&fast);
  return s.period.v_start * s.period.displacement < 0 ? DOES : DOES_NOT;
}

static double centre_goes_back(const struct scallop_crawler *c)
{
  struct scallop_crawler s = stronger_first(c);
  s.m2 = s.m1;
  return s.F1 == s.F2 ? NOT_MEANT : -extension(&s, 0).dxC / s.L;
}

static double last_interval(const struct scallop_crawler *c)
{
  struct scallop_crawler s = stronger_first(c);
  struct scallop_phase_result r = extension(&s, 0);
  return r.regime == SCALLOP_SLIDING && s.F1 > s.F2 ? r.dT / (s.alpha * s.T) : NOT_MEANT;
}

static double not_two_intervals(const struct scallop_crawler *c)
{
  struct scallop_crawler s = stronger_first(c);
  struct scallop_phase_result r = extension(&s, 0);
  if (r.regime != SCALLOP_SLIDING || s.F1 == s.F2)
    return NOT_MEANT;
  return modes_are(&r.modes, "-+ ++") ? DOES_NOT : DOES;
}

/* By how much the last interval of an extension from rest shrinks when the duration grows by 1 % */
static double last_interval_shrinks(const struct scallop_crawler *c)
{
  struct scallop_crawler s = stronger_first(c), longer = s;
  longer.T = 1.01 * s.T;
  struct scallop_phase_result r = extension(&s, 0), l = extension(&longer, 0);
  bool slide = r.regime == SCALLOP_SLIDING && l.regime == SCALLOP_SLIDING && s.F1 > s.F2;
  return slide ? (r.dT - l.dT) / r.dT : NOT_MEANT;
}

/* From v0 = L over the duration times a tenth of alpha, against rest */
static double start_velocity_holds_back(const struct scallop_crawler *c)
{
  return extension(c, 0).dxC / c->L - extension(c, 0.1 * c->alpha).dxC / c->L;
}

static double start_velocity_adds_velocity(const struct scallop_crawler *c)
{
  double unit = c->L / (c->alpha * c->T), v0 = 0.1 * c->alpha;
  return extension(c, v0).v_end / unit - v0 - extension(c, 0).v_end / unit;
}

/* The largest value over the crawlers, which shall not be above a limit; both where it is not and where it is, that is measured. */
struct limit {
  probe *of;
  double most;
  const char *conditions, *below, *above;
};

#define SET "400 quasi-random crawlers, masses and forces within 100:1"
static const char whole_set[] = SET ", sliding to stick-slip", from_rest[] = SET ", F1 > F2, from rest, those that slide";
static const char still[] = "largest |displacement|/L: below 1e-14", moved[] = "largest |displacement|/L: above 1e-14";

enum {
  EQUAL_FORCES,
  SYMMETRIC_TIMING,
  UNSETTLED,
  BOTH_REST,
  NOT_MIRRORED,
  NOT_OPPOSED,
  SYMMETRIC_START,
  SLOWS,
  AGAINST_MOTION,
  GOES_BACK,
  LAST_INTERVAL,
  NOT_TWO,
  SHRINKS,
  HOLDS_BACK,
  ADDS_VELOCITY
};
static const struct limit limits[] = {
  [EQUAL_FORCES] = { equal_forces, WORDS_ZERO, whole_set, still, moved },
  [SYMMETRIC_TIMING] = { symmetric_timing, WORDS_ZERO, whole_set, still, moved },
  [UNSETTLED] = { unsettled, 1e-6, whole_set, "largest |v - v_start| T/L after at most 20000 periods from rest: below 1e-6",
                  "largest |v - v_start| T/L after at most 20000 periods from rest: above 1e-6" },
  [BOTH_REST] = { both_rest, 0, whole_set, "x2' - x1' = l'; both bodies at rest at once in a steady state: never",
                  "both bodies at rest at once in a steady state: for one at least" },
  [NOT_MIRRORED] = { not_mirrored, WORDS_ZERO, SET "; m1 and m2, F1 and F2 exchanged",
                     "displacement of one plus that of the other, over L: below 1e-14",
                     "displacement of one plus that of the other, over L: above 1e-14" },
  [NOT_OPPOSED] = { not_opposed, WORDS_ZERO, SET "; F2 = F1", "the modes are -+ | +- and |v_start| T/L is below 1e-14",
                    "other modes, or |v_start| T/L above 1e-14" },
  [SYMMETRIC_START] = { symmetric_start, WORDS_ZERO, SET "; alpha = 1/2",
                        "v_start = -v_mid to 1e-14 L/T, and never on the side of F1 - F2",
                        "v_start is not -v_mid, or on the side of F1 - F2" },
  [SLOWS] = { slows_in_extension, 0, SET ", F1 > F2, the steady states that slide", "v_mid > v_start for all",
              "v_mid < v_start for one at least" },
  [AGAINST_MOTION] = { starts_against_motion, 0, SET ", Froude number 1e8", "v_start against the displacement: never",
                       "v_start against the displacement: for one at least" },
  [GOES_BACK] = { centre_goes_back, 0, SET ", F1 > F2, m1 = m2, from rest", "dx_C > 0 for all",
                  "dx_C < 0 for one at least" },
  [LAST_INTERVAL] = { last_interval, 0.5, from_rest, "dT is less than half of the duration for all",
                      "dT is more than half of the duration for one at least" },
  [NOT_TWO] = { not_two_intervals, 0, from_rest, "the modes are -+ ++ for all", "other modes for one at least" },
  [SHRINKS] = { last_interval_shrinks, 0, from_rest, "dT grows with the duration for all, here by 1 %",
                "dT shrinks for one at least, the duration growing by 1 %" },
  [HOLDS_BACK] = { start_velocity_holds_back, 0, SET ", v0 = alpha/10 L over the duration",
                   "dx_C is larger than from rest for all", "dx_C is smaller than from rest for one at least" },
  [ADDS_VELOCITY] = { start_velocity_adds_velocity, 0, SET ", v0 = alpha/10 L over the duration",
                      "v_end - v0 is smaller than from rest for all",
                      "v_end - v0 is larger than from rest for one at least" },
};

static void within_limit(const struct words *w, const struct words_claim *claim)
{
  const struct limit *limit = &limits[claim->which];
  char measured[200];
  struct largest x = largest(limit->of, w->crawler.gait);
  bool holds = x.value <= limit->most && x.of > 0;
  int used = snprintf(measured, sizeof measured, "%s", holds ? limit->below : limit->above);
  if (x.of < RANDOM_CRAWLERS)
    snprintf(measured + used, sizeof measured - (size_t)used, " (%d crawlers)", x.of);
  words_enter(w, claim, limit->conditions, true, words_verdict(holds, x.of > 0), measured, NULL);
}

static void attracts(const struct words *w, const struct words_claim *claim)
{
  char text[120];
  double x = largest(multiplier, w->crawler.gait).value;
  snprintf(text, sizeof text, "largest multiplier of the period map: %.4f", x);
  words_enter(w, claim, whole_set, true, words_verdict(x < 1, true), text, NULL);
}

static void moves_forward(const struct words *w, const struct words_claim *claim)
{
  char text[120], reason[320];
  bool sliding = claim->which;
  struct largest x = largest(sliding ? backward_sliding : backward_sticking, w->crawler.gait);
  const struct scallop_crawler *c = &x.where;
  bool holds = x.value <= WORDS_ZERO;
  snprintf(text, sizeof text, "largest displacement/L against the sign of (F1-F2)(2 alpha-1): %.3g", holds ? 0 : x.value);
  snprintf(reason, sizeof reason,
           "scallop steady --m1 %.4g --m2 %.4g --F1 %.4g --F2 %.4g --L 1 --T %.4g --alpha %.4g --gait %s", c->m1, c->m2,
           c->F1, c->F2, c->T, c->alpha, w->crawler.gait->name);
  words_enter(w, claim,
              sliding ? "400 quasi-random crawlers: those that slide" : "400 quasi-random crawlers: those in stick-slip",
              sliding, words_verdict(holds, true), text, reason);
}

const struct words_claim words_at_random[] = {
  { "equal_forces_do_not_move", "4.1", "displacement", WORDS_EACH_GAIT, within_limit, EQUAL_FORCES },
  { "symmetric_timing_does_not_move", "4.2", "displacement", WORDS_EACH_GAIT, within_limit, SYMMETRIC_TIMING },
  { "steady_state_attracts", "4.3.2", "multiplier", WORDS_EACH_GAIT, attracts, 0 },
  { "motion_always_settles", "5", "v", WORDS_EACH_GAIT, within_limit, UNSETTLED },
  { "longer_extension_moves_forward", "4.4", "displacement", WORDS_EACH_GAIT, moves_forward, true },
  { "longer_extension_moves_forward", "4.4", "displacement", WORDS_EACH_GAIT, moves_forward, false },
  { "one_body_always_moves", "2", "modes", WORDS_EACH_GAIT, within_limit, BOTH_REST },
  { "which_body_is_1_does_not_matter", "2", "displacement", WORDS_EACH_GAIT, within_limit, NOT_MIRRORED },
  { "equal_forces_bodies_oppose", "(6), (7)", "modes", WORDS_EACH_GAIT, within_limit, NOT_OPPOSED },
  { "velocity_rises_over_extension", "4.2", "v_mid", WORDS_EACH_GAIT, within_limit, SLOWS },
  { "symmetric_timing_starts_backward", "4.2", "v_start", WORDS_EACH_GAIT, within_limit, SYMMETRIC_START },
  { "centre_moves_forward_in_an_extension", "4.3", "dx_C", WORDS_EACH_GAIT, within_limit, GOES_BACK },
  { "extension_from_rest_has_two_intervals", "4.3.1", "modes", WORDS_EACH_GAIT, within_limit, NOT_TWO },
  { "first_interval_is_the_greater_part", "4.3.1", "dT", WORDS_EACH_GAIT, within_limit, LAST_INTERVAL },
  { "last_interval_grows_with_duration", "4.3.1", "dT", WORDS_EACH_GAIT, within_limit, SHRINKS },
  { "start_velocity_adds_displacement", "4.3.2", "dx_C", WORDS_EACH_GAIT, within_limit, HOLDS_BACK },
  { "start_velocity_takes_velocity_change", "4.3.2", "v_end", WORDS_EACH_GAIT, within_limit, ADDS_VELOCITY },
  { "start_velocity_is_forward_at_high_Froude", "5", "v_start", WORDS_EACH_GAIT, within_limit, AGAINST_MOTION },
  { .claim = NULL }
};
