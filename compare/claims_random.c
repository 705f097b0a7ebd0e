/* The claims in words about every crawler: held against random ones, masses and forces within a factor of 10, 0.05 < alpha < 0.95,
 * Froude from 0.1. */
#include <math.h>
#include <stdio.h>

#include "compare/claims_words.h"

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

/* The largest value of probe over random crawlers, and where it occurs; NAN if any is not a number. */
static double largest(probe *p, const struct scallop_gait *gait, struct scallop_crawler *where)
{
  gsl_qrng *q = gsl_qrng_alloc(gsl_qrng_sobol, 6);
  double most = -INFINITY;
  for (int i = 0; q && i < RANDOM_CRAWLERS; i++) {
    struct scallop_crawler c = words_random(q, gait);
    double x = p(&c);
    if (x > most || isnan(x)) {
      most = x;
      *where = c;
    }
    if (isnan(x))
      break;
  }
  if (q)
    gsl_qrng_free(q);
  return q ? most : NAN;
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

/* The largest value over the crawlers, which shall not be above a limit; both where it is and where not, that is measured. */
struct limit {
  probe *of;
  double most;
  const char *below, *above; /* what was measured                                                   */
};

static const struct limit limits[] = {
  { equal_forces, WORDS_ZERO, "largest |displacement|/L: below 1e-14", "largest |displacement|/L: above 1e-14" },
  { symmetric_timing, WORDS_ZERO, "largest |displacement|/L: below 1e-14", "largest |displacement|/L: above 1e-14" },
  { unsettled, 1e-6, "largest |v - v_start| T/L after at most 20000 periods from rest: below 1e-6",
    "largest |v - v_start| T/L after at most 20000 periods from rest: above 1e-6" },
};
enum { EQUAL_FORCES, SYMMETRIC_TIMING, UNSETTLED };

static const char *const set = "400 quasi-random crawlers, masses and forces within 100:1, sliding to stick-slip";

static void within_limit(const struct words *w, const struct words_claim *claim)
{
  const struct limit *limit = &limits[claim->which];
  struct scallop_crawler where;
  bool holds = largest(limit->of, w->crawler.gait, &where) <= limit->most;
  words_enter(w, claim, set, true, words_verdict(holds, true), holds ? limit->below : limit->above, NULL);
}

static void attracts(const struct words *w, const struct words_claim *claim)
{
  char text[120];
  struct scallop_crawler where;
  double x = largest(multiplier, w->crawler.gait, &where);
  snprintf(text, sizeof text, "largest multiplier of the period map: %.4f", x);
  words_enter(w, claim, set, true, words_verdict(x < 1, true), text, NULL);
}

static void moves_forward(const struct words *w, const struct words_claim *claim)
{
  char text[120], reason[320];
  bool sliding = claim->which;
  struct scallop_crawler where = scallop_crawler_default();
  double x = largest(sliding ? backward_sliding : backward_sticking, w->crawler.gait, &where);
  snprintf(text, sizeof text, "largest displacement/L against the sign of (F1-F2)(2 alpha-1): %.3g",
           x <= WORDS_ZERO ? 0 : x);
  snprintf(reason, sizeof reason,
           "scallop steady --m1 %.4g --m2 %.4g --F1 %.4g --F2 %.4g --L 1 --T %.4g --alpha %.4g --gait %s", where.m1,
           where.m2, where.F1, where.F2, where.T, where.alpha, w->crawler.gait->name);
  words_enter(w, claim,
              sliding ? "400 quasi-random crawlers: those that slide" : "400 quasi-random crawlers: those in stick-slip",
              sliding, words_verdict(x <= WORDS_ZERO, true), text, reason);
}

const struct words_claim words_at_random[] = {
  { "equal_forces_do_not_move", "4.1", "displacement", WORDS_EACH_GAIT, within_limit, EQUAL_FORCES },
  { "symmetric_timing_does_not_move", "4.2", "displacement", WORDS_EACH_GAIT, within_limit, SYMMETRIC_TIMING },
  { "steady_state_attracts", "4.3.2", "multiplier", WORDS_EACH_GAIT, attracts, 0 },
  { "motion_always_settles", "5", "v", WORDS_EACH_GAIT, within_limit, UNSETTLED },
  { "longer_extension_moves_forward", "4.4", "displacement", WORDS_EACH_GAIT, moves_forward, true },
  { "longer_extension_moves_forward", "4.4", "displacement", WORDS_EACH_GAIT, moves_forward, false },
  { .claim = NULL }
};
