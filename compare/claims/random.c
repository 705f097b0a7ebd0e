/* The claims in words about every crawler: held against random ones, masses and forces within a factor of 10, 0.05 < alpha < 0.95,
 * Froude from 0.1. Those that hold have their proofs in docs/theory.md, The motion in words; here stands how far each is from failing. */
#include <math.h>
#include <string.h>

#include "compare/claims/decide.h"

static const double DOES = 1, DOES_NOT = -1;
/* Of a crawler that the statement is not about */
static const double NOT_MEANT = -INFINITY;

struct largest {
  double value; /* NAN if any is not a number                                                          */
  int of;       /* crawlers that are meant                                                             */
  struct scallop_crawler where;
};

/* The largest value over the first so many random crawlers, and where it occurs */
static struct largest largest(probe *p, const struct scallop_gait *gait, int count)
{
  struct scallop_crawler c[RANDOM_CRAWLERS];
  struct largest most = { -INFINITY, 0, scallop_crawler_default() };
  if (random_crawlers(c, count, gait) == 0)
    most.value = NAN;
  for (int i = 0; i < count && !isnan(most.value); i++) {
    double x = p(c[i]);
    most.of += x > NOT_MEANT;
    if (x > most.value || isnan(x)) {
      most.value = x;
      most.where = c[i];
    }
  }
  return most;
}

void at_most(struct question *q)
{
  const struct bound *b = q->with;
  under(q, "%s", b->conditions);
  struct largest x = largest(b->probe, q->crawler.gait, RANDOM_CRAWLERS);
  bool holds = x.value <= b->limit && x.of > 0;
  measured(q, "%s", holds ? b->below : b->above);
  if (x.of < RANDOM_CRAWLERS)
    measured(q, " (%d crawlers)", x.of);
  settle(q, holds, x.of > 0);
}

#define SET "400 quasi-random crawlers, masses and forces within 100:1"
static const char whole_set[] = SET ", sliding to stick-slip", from_rest[] = SET ", F1 > F2, from rest, those that slide";

/* Steady states */

static double moved(struct scallop_crawler c) { return fabs(steady_state(&c).period.displacement); }
static const char still[] = "largest |displacement|/L: below 1e-14", moving[] = "largest |displacement|/L: above 1e-14";

static double moved_by_equal_forces(struct scallop_crawler c)
{
  c.F2 = c.F1;
  return moved(c);
}
const struct bound equal_forces_do_not_move = { whole_set, EVIDENCE_ZERO, moved_by_equal_forces, still, moving };

static double moved_by_symmetric_timing(struct scallop_crawler c)
{
  c.alpha = 0.5;
  return moved(c);
}
const struct bound symmetric_timing_does_not_move = { whole_set, EVIDENCE_ZERO, moved_by_symmetric_timing, still, moving };

static double multiplier(struct scallop_crawler c) { return steady_state(&c).period.multiplier; }
void steady_state_attracts(struct question *q)
{
  double x = largest(multiplier, q->crawler.gait, RANDOM_CRAWLERS).value;
  under(q, "%s", whole_set);
  measured(q, "largest multiplier of the period map: %.4f", x);
  settle(q, x < 1, true);
}

/* How far the velocity is from the steady one, over L/T, once it is within 1e-6 or after 20000 periods from rest */
static double unsettled(struct scallop_crawler c)
{
  double v = steady_state(&c).period.v_start;
  struct scallop_period_result p = { .v_end = 0 };
  for (int n = 0; n < 20000 && fabs(p.v_end - v) > 1e-6 * c.L / c.T; n++)
    if (scallop_period(&c, p.v_end, &p) < 0)
      return NAN;
  return fabs(p.v_end - v) * c.T / c.L;
}
const struct bound motion_settles = { whole_set, 1e-6, unsettled,
                                      "largest |v - v_start| T/L after at most 20000 periods from rest: below 1e-6",
                                      "largest |v - v_start| T/L after at most 20000 periods from rest: above 1e-6" };

/* -displacement/L in the direction in which a longer extension should carry: sign (F1 - F2)(2 alpha - 1) */
static double backward(struct scallop_crawler c, bool sliding)
{
  double sign = (c.F1 - c.F2) * (2 * c.alpha - 1) > 0 ? 1 : -1;
  struct scallop_steady_result s = steady_state(&c);
  return (s.period.regime == SCALLOP_SLIDING) == sliding ? -sign * s.period.displacement / c.L : -1;
}
static double backward_sliding(struct scallop_crawler c) { return backward(c, true); }
static double backward_sticking(struct scallop_crawler c) { return backward(c, false); }

void moves_forward(struct question *q)
{
  bool sliding = q->with != NULL;
  struct largest x = largest(sliding ? backward_sliding : backward_sticking, q->crawler.gait, RANDOM_CRAWLERS);
  const struct scallop_crawler *c = &x.where;
  bool holds = x.value <= EVIDENCE_ZERO;
  under(q, "400 quasi-random crawlers: those %s", sliding ? "that slide" : "in stick-slip");
  q->row.inside = sliding;
  measured(q, "largest displacement/L against the sign of (F1-F2)(2 alpha-1): %.3g", holds ? 0 : x.value);
  reason(q, "scallop steady --m1 %.4g --m2 %.4g --F1 %.4g --F2 %.4g --L 1 --T %.4g --alpha %.4g --gait %s", c->m1, c->m2,
         c->F1, c->F2, c->T, c->alpha, c->gait->name);
  settle(q, holds, true);
}

static double both_rest(struct scallop_crawler c)
{
  struct scallop_steady_result s = steady_state(&c);
  for (int kind = 0; kind < 2; kind++)
    for (int i = 0; i < s.period.modes[kind].count && i < SCALLOP_MODES_KEPT; i++)
      if (s.period.modes[kind].kept[i].s1 == 0 && s.period.modes[kind].kept[i].s2 == 0)
        return DOES;
  return DOES_NOT;
}
const struct bound one_body_moves = { whole_set, 0, both_rest,
                                      "x2' - x1' = l'; both bodies at rest at once in a steady state: never",
                                      "both bodies at rest at once in a steady state: for one at least" };

static double not_mirrored(struct scallop_crawler c)
{
  struct scallop_crawler mirrored = c;
  mirrored.m1 = c.m2, mirrored.m2 = c.m1, mirrored.F1 = c.F2, mirrored.F2 = c.F1;
  return fabs(steady_state(&c).period.displacement + steady_state(&mirrored).period.displacement);
}
const struct bound bodies_are_exchanged = { SET "; m1 and m2, F1 and F2 exchanged", EVIDENCE_ZERO, not_mirrored,
                                            "displacement of one plus that of the other, over L: below 1e-14",
                                            "displacement of one plus that of the other, over L: above 1e-14" };

static bool modes_are(const struct scallop_modes *modes, const char *text)
{
  char own[SCALLOP_MODES_TEXT];
  scallop_modes_text(modes, own);
  return strcmp(own, text) == 0;
}

static double not_opposed(struct scallop_crawler c)
{
  c.F2 = c.F1;
  struct scallop_steady_result s = steady_state(&c);
  bool opposed = modes_are(&s.period.modes[0], "-+") && modes_are(&s.period.modes[1], "+-");
  return opposed ? fabs(s.period.v_start) * c.T / c.L : DOES;
}
const struct bound equal_forces_oppose = { SET "; F2 = F1", EVIDENCE_ZERO, not_opposed,
                                           "the modes are -+ | +- and |v_start| T/L is below 1e-14",
                                           "other modes, or |v_start| T/L above 1e-14" };

/* F1 > F2, the paper's convention; F1 = F2 is for the caller to leave out. */
static struct scallop_crawler stronger_first(struct scallop_crawler c)
{
  double F1 = c.F1;
  c.F1 = fmax(F1, c.F2);
  c.F2 = fmin(F1, c.F2);
  return c;
}

static double slows_in_extension(struct scallop_crawler c)
{
  c = stronger_first(c);
  struct scallop_steady_result r = steady_state(&c);
  return r.period.regime == SCALLOP_SLIDING && c.F1 > c.F2 ? (r.period.v_start - r.period.v_mid) * c.T / c.L : NOT_MEANT;
}
const struct bound velocity_rises = { SET ", F1 > F2, the steady states that slide", 0, slows_in_extension,
                                      "v_mid > v_start for all", "v_mid < v_start for one at least" };

/* How far v_start is from -v_mid, and on the side of F1 - F2 */
static double symmetric_start(struct scallop_crawler c)
{
  c.alpha = 0.5;
  struct scallop_steady_result s = steady_state(&c);
  double sign = c.F1 > c.F2 ? 1 : -1;
  return fmax(fabs(s.period.v_start + s.period.v_mid), sign * s.period.v_start) * c.T / c.L;
}
const struct bound symmetric_timing_starts_backward = { SET "; alpha = 1/2", EVIDENCE_ZERO, symmetric_start,
                                                        "v_start = -v_mid to 1e-14 L/T, and never on the side of F1 - F2",
                                                        "v_start is not -v_mid, or on the side of F1 - F2" };

/* At a Froude number of 1e8 */
static double starts_against_motion(struct scallop_crawler c)
{
  c.T = 1e-4 * natural_time(&c);
  struct scallop_steady_result s = steady_state(&c);
  return s.period.v_start * s.period.displacement < 0 ? DOES : DOES_NOT;
}
const struct bound starts_forward_at_high_froude = { SET ", Froude number 1e8", 0, starts_against_motion,
                                                     "v_start against the displacement: never",
                                                     "v_start against the displacement: for one at least" };

static double is_single(struct scallop_crawler c)
{
  struct scallop_steady_result s = steady_state(&c);
  return isfinite(s.mean_velocity) && s.v_low == s.v_high ? DOES : NOT_MEANT;
}
void steady_state_is_unique(struct question *q)
{
  int single = largest(is_single, q->crawler.gait, RANDOM_CRAWLERS).of;
  under(q, "l' continuous, any masses, forces > 0 and alpha");
  measured(q,
           "proven for continuous l' (docs/theory.md, How many steady states); the solver finds one for %d of 400 "
           "quasi-random crawlers",
           single);
  settle(q, single == RANDOM_CRAWLERS, true);
}

/* One extension */

/* From v0, in L over its duration */
static struct scallop_phase_result extension_from(const struct scallop_crawler *c, double v0)
{
  return extension(c, v0 * c->L / (c->alpha * c->T));
}

static double centre_goes_back(struct scallop_crawler c)
{
  c = stronger_first(c);
  c.m2 = c.m1;
  return c.F1 == c.F2 ? NOT_MEANT : -extension(&c, 0).dxC;
}
const struct bound centre_moves_forward = { SET ", F1 > F2, m1 = m2, from rest", 0, centre_goes_back, "dx_C > 0 for all",
                                            "dx_C < 0 for one at least" };

static double not_two_intervals(struct scallop_crawler c)
{
  c = stronger_first(c);
  struct scallop_phase_result r = extension(&c, 0);
  if (r.regime != SCALLOP_SLIDING || c.F1 == c.F2)
    return NOT_MEANT;
  return modes_are(&r.modes, "-+ ++") ? DOES_NOT : DOES;
}
const struct bound two_intervals = { from_rest, 0, not_two_intervals, "the modes are -+ ++ for all",
                                     "other modes for one at least" };

static double last_interval(struct scallop_crawler c)
{
  c = stronger_first(c);
  struct scallop_phase_result r = extension(&c, 0);
  return r.regime == SCALLOP_SLIDING && c.F1 > c.F2 ? r.dT / (c.alpha * c.T) : NOT_MEANT;
}
const struct bound first_interval_is_greater = { from_rest, 0.5, last_interval,
                                                 "dT is less than half of the duration for all",
                                                 "dT is more than half of the duration for one at least" };

/* By how much the last interval of an extension from rest shrinks when the duration grows by 1 % */
static double last_interval_shrinks(struct scallop_crawler c)
{
  c = stronger_first(c);
  struct scallop_phase_result r = extension(&c, 0);
  c.T *= 1.01;
  struct scallop_phase_result longer = extension(&c, 0);
  bool slide = r.regime == SCALLOP_SLIDING && longer.regime == SCALLOP_SLIDING && c.F1 > c.F2;
  return slide ? (r.dT - longer.dT) / r.dT : NOT_MEANT;
}
const struct bound last_interval_grows = { from_rest, 0, last_interval_shrinks,
                                           "dT grows with the duration for all, here by 1 %",
                                           "dT shrinks for one at least, the duration growing by 1 %" };

/* From v0 = L over the duration times a tenth of alpha, against rest */
static double holds_back(struct scallop_crawler c) { return extension(&c, 0).dxC - extension_from(&c, 0.1 * c.alpha).dxC; }
const struct bound start_velocity_adds_displacement = { SET ", v0 = alpha/10 L over the duration", 0, holds_back,
                                                        "dx_C is larger than from rest for all",
                                                        "dx_C is smaller than from rest for one at least" };

static double adds_velocity(struct scallop_crawler c)
{
  double unit = c.L / (c.alpha * c.T), v0 = 0.1 * c.alpha;
  return extension_from(&c, v0).v_end / unit - v0 - extension(&c, 0).v_end / unit;
}
const struct bound start_velocity_takes_velocity = { SET ", v0 = alpha/10 L over the duration", 0, adds_velocity,
                                                     "v_end - v0 is smaller than from rest for all",
                                                     "v_end - v0 is larger than from rest for one at least" };

static double falls_with_duration(struct scallop_crawler c)
{
  enum { DURATIONS = 150 };
  double before = -INFINITY;
  bool falls = false;
  c.T = 0.01 * natural_time(&c);
  for (int i = 0; i < DURATIONS; i++, c.T *= 1.05) {
    double x = extension(&c, 0).dxC * (c.F1 > c.F2 ? 1 : -1);
    falls = falls || !(x >= before - 1e-14);
    before = x;
  }
  return falls ? DOES : NOT_MEANT;
}
/* From rest the displacement grows in the direction of F1 - F2, past sticking too. */
void displacement_from_rest(struct question *q)
{
  struct largest x = largest(falls_with_duration, q->crawler.gait, 100);
  under(q, "from rest, any masses, forces and duration; in the direction of F1 - F2");
  measured(q,
           "proven (docs/theory.md, One extension against its duration); of 100 quasi-random crawlers and 150 durations "
           "each it falls for %d",
           x.of);
  settle(q, x.of == 0 && !isnan(x.value), true);
}
