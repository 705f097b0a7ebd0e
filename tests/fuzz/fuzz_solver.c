/* The solver, whatever the doubles: an answer of finite numbers, or a negative status and nothing touched; and what the
 * answers say about each other. The laws of motion: fuzz_laws.c; many crawlers at once: tests/numerics/test_batch.c.
 *
 * Tolerances are ROUNDINGS unit roundoffs of the sum of the absolute values of what a number is a sum of. */
#include <float.h>
#include <stdlib.h>

#include "tests/fuzz/crawler.h"
#include "tests/fuzz/target.h"

enum { ROUNDINGS = 64, PERIODS = 3, SAMPLES = 5 };
#define ROUNDOFF (ROUNDINGS * (0.5 * DBL_EPSILON))
#define LEAST (ROUNDINGS * DBL_TRUE_MIN) /* the same below the normal range */

static struct fuzz_case now;

#define REQUIRE(condition) \
  do { \
    if (!(condition)) \
      fuzz_fail("line %d: %s does not hold for %s", __LINE__, #condition, fuzz_describe(&now)); \
  } while (0)
#define NEAR(got, wanted, tolerance) \
  do { \
    double near_got = (got), near_wanted = (wanted), near_tolerance = (tolerance) + LEAST; \
    if (!(fabs(near_got - near_wanted) <= near_tolerance) && isfinite(near_tolerance)) \
      fuzz_fail("line %d: %s is %.17g, not %.17g within %.3g, for %s", __LINE__, #got, near_got, near_wanted, \
                near_tolerance, fuzz_describe(&now)); \
  } while (0)

/* Without an answer the status says why, and nothing is touched. */
static bool is_refused(enum scallop_status status, const void *answer, size_t size)
{
  REQUIRE(status >= 0 || ((status == SCALLOP_EDOMAIN || status == SCALLOP_ERANGE) && untouched(answer, size)));
  return status < 0;
}

static void judge_modes(const struct scallop_modes *modes)
{
  REQUIRE(modes->count >= 1);
  for (int i = 0; i < modes->count && i < SCALLOP_MODES_KEPT; i++) {
    struct scallop_mode m = modes->kept[i];
    REQUIRE(abs(m.s1) <= 1 && abs(m.s2) <= 1);
    REQUIRE(m.s1 != 0 || m.s2 != 0);
    REQUIRE(i == 0 || m.s1 != modes->kept[i - 1].s1 || m.s2 != modes->kept[i - 1].s2);
  }
}

/* The highest speed on the curves l' of the bodies, of both phases */
static double highest(void)
{
  const struct scallop_crawler *c = &now.crawler;
  double M = c->m1 + c->m2, all = 0;
  for (int kind = 0; kind < 2; kind++)
    all = fmax(all, c->gait->phase[kind].peak * (c->L / scallop_phase_duration(c, (enum scallop_phase_kind)kind)));
  return all * fmax(c->m1 / M, c->m2 / M);
}

/* What friction can do to the velocity in a period */
static double friction(void)
{
  const struct scallop_crawler *c = &now.crawler;
  return c->T * ((c->F1 + c->F2) / (c->m1 + c->m2));
}

static double size_of_velocities(void) { return highest() + friction() + fabs(now.v0); }

static void judge_phase(enum scallop_phase_kind kind)
{
  struct scallop_phase_result r;
  const struct scallop_crawler *c = &now.crawler;
  memset(&r, UNTOUCHED, sizeof r);
  enum scallop_status status = scallop_phase(c, kind, now.v0, &r);
  if (is_refused(status, &r, sizeof r))
    return;
  double tau = scallop_phase_duration(c, kind), stroke = kind == SCALLOP_EXTENSION ? c->L : -c->L;
  judge_modes(&r.modes);
  REQUIRE(status == SCALLOP_OK);
  REQUIRE(isfinite(r.v_end) && isfinite(r.dx1) && isfinite(r.dx2) && isfinite(r.dxC));
  REQUIRE(r.modes.count > 1 ? r.t1 >= 0 && r.dT >= 0 : isnan(r.t1) && isnan(r.dT));
  if (r.modes.count > 1) {
    REQUIRE(r.t1 + r.dT <= tau * (1 + ROUNDOFF));
    REQUIRE(r.modes.count > 2 || fabs(r.t1 + r.dT - tau) <= ROUNDOFF * tau);
  }
  REQUIRE(r.regime == SCALLOP_SLIDING || r.regime == SCALLOP_STICK_SLIP || r.regime == SCALLOP_AT_REST);
  double terms = fabs(r.dx1) + fabs(r.dx2) + fabs(r.dxC) + c->L;
  NEAR(r.dx2 - r.dx1, stroke, ROUNDOFF * terms);
  NEAR(r.dx1 + r.dx2, 2 * r.dxC, ROUNDOFF * terms);
  REQUIRE(fabs(r.v_end) <= fmax(highest(), fabs(now.v0)) * (1 + ROUNDOFF) + DBL_MIN);
}

static void judge_period(struct scallop_period_result *r)
{
  memset(r, UNTOUCHED, sizeof *r);
  enum scallop_status status = scallop_period(&now.crawler, now.v0, r);
  if (is_refused(status, r, sizeof *r))
    return;
  REQUIRE(status == SCALLOP_OK && r->v_start == now.v0);
  REQUIRE(isfinite(r->v_mid) && isfinite(r->v_end) && isfinite(r->displacement) && !isnan(r->balance));
  REQUIRE(r->multiplier >= 0 && r->multiplier <= 1);
  judge_modes(&r->modes[0]);
  judge_modes(&r->modes[1]);
  NEAR(r->v_end - r->v_start, r->balance * friction(),
       ROUNDOFF * (size_of_velocities() + fabs(r->balance * friction())));
}

static double balance_at(double v)
{
  struct scallop_period_result r;
  enum scallop_status status = scallop_period(&now.crawler, v, &r);
  return status == SCALLOP_OK ? r.balance : NAN;
}

/* The balance falls with the velocity: it is above 0 a little before the root, and below a little after, but for
 * rounding. */
static void judge_root(const struct scallop_steady_result *s)
{
  double v = s->period.v_start, step = ROUNDOFF * fabs(v) + LEAST;
  double before = balance_at(v - step), after = balance_at(v + step), noise = ROUNDOFF;
  if (s->period.multiplier == 0) /* then it is a difference of velocities */
    noise *= 1 + (highest() + fabs(v)) / friction();
  REQUIRE(isnan(before) || before >= -noise);
  REQUIRE(isnan(after) || after <= noise);
  struct scallop_period_result p;
  if (scallop_period(&now.crawler, v, &p) == SCALLOP_OK)
    NEAR(p.v_end, v, ROUNDOFF * (highest() + friction() + fabs(v)));
}

static void judge_steady(void)
{
  struct scallop_steady_result s;
  memset(&s, UNTOUCHED, sizeof s);
  enum scallop_status status = scallop_steady(&now.crawler, &s);
  if (is_refused(status, &s, sizeof s))
    return;
  const struct scallop_period_result *p = &s.period;
  REQUIRE(status == SCALLOP_OK || status == SCALLOP_INTERVAL);
  REQUIRE(isfinite(s.froude) && isfinite(s.mean_velocity) && isfinite(p->v_start) && isfinite(p->v_mid));
  REQUIRE(isfinite(p->v_end) && isfinite(p->displacement) && isfinite(p->balance));
  REQUIRE(p->multiplier >= 0 && p->multiplier <= 1);
  REQUIRE(s.v_low <= p->v_start && p->v_start <= s.v_high);
  REQUIRE((status == SCALLOP_INTERVAL) == (s.v_low < s.v_high));
  REQUIRE(fabs(p->v_start) <= highest() * (1 + ROUNDOFF) && fabs(p->v_mid) <= highest() * (1 + ROUNDOFF));
  REQUIRE(fabs(p->displacement) <= highest() * now.crawler.T * (1 + ROUNDOFF));
  judge_modes(&p->modes[0]);
  judge_modes(&p->modes[1]);
  judge_root(&s);
}

struct seen {
  long count;
  struct scallop_sample last;
};

static bool see(void *context, const struct scallop_sample *s)
{
  struct seen *seen = context;
  double terms = fabs(s->x1) + fabs(s->x2) + now.crawler.L;
  REQUIRE(isfinite(s->t) && isfinite(s->x1) && isfinite(s->x2) && isfinite(s->xC) && isfinite(s->v1)
          && isfinite(s->v2));
  REQUIRE(seen->count == 0 ? s->t == 0 && s->x1 == 0 && s->x2 == 0 : s->t >= seen->last.t);
  REQUIRE(s->l >= -ROUNDOFF * now.crawler.L && s->l <= now.crawler.L * (1 + ROUNDOFF));
  NEAR(s->x2 - s->x1, s->l, ROUNDOFF * terms);
  NEAR(s->x1 + s->x2, 2 * s->xC, ROUNDOFF * terms);
  seen->count++;
  seen->last = *s;
  return true;
}

static void judge_trajectory(const struct scallop_period_result *first)
{
  struct seen seen = { 0 };
  enum scallop_status status = scallop_trajectory(&now.crawler, now.v0, PERIODS, SAMPLES, see, &seen);
  if (status < 0) {
    REQUIRE(status == SCALLOP_ERANGE || (status == SCALLOP_EDOMAIN && seen.count == 0));
    return;
  }
  REQUIRE(status == SCALLOP_OK && seen.count == PERIODS * SAMPLES + 1);
  seen = (struct seen){ 0 };
  REQUIRE(scallop_trajectory(&now.crawler, now.v0, 1, 1, see, &seen) == SCALLOP_OK && seen.count == 2);
  if (untouched(first, sizeof *first))
    return;
  NEAR(seen.last.v1, first->v_end, ROUNDOFF * size_of_velocities());
  NEAR(seen.last.xC, first->displacement, ROUNDOFF * (now.crawler.L + size_of_velocities() * now.crawler.T));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  struct scallop_period_result period;
  now = fuzz_case_of(data, size);
  judge_phase(SCALLOP_EXTENSION);
  judge_phase(SCALLOP_CONTRACTION);
  judge_period(&period);
  judge_trajectory(&period);
  judge_steady();
  return 0;
}
