/* What the solvers refuse: parameters, start velocities and counts that are none, and results beyond the normal range
 * of a double, whichever of them it is; the same motion in moderate units is not refused. */
#include <float.h>

#include "tests/support/random_crawler.h"
#include "tests/support/solved.h"

/* EVERY: of steady states, and from v0; FROM_V0: steady states exist; EXTENSION: only what goes through one */
enum refused { EVERY, FROM_V0, EXTENSION };
struct refusal {
  const char *why;
  struct scallop_crawler crawler;
  double v0;
  enum refused what;
  enum scallop_status wanted;
};
static const struct refusal *under_test;

static void name_the_culprit(void)
{
  print_error("%s, from v0 = %g: ", under_test->why, under_test->v0);
  if (under_test->crawler.gait)
    print_crawler(&under_test->crawler);
}

static void no_visit(void *context, const struct scallop_interval *interval)
{
  (void)interval;
  *(int *)context += 1;
}

static bool no_sample(void *context, const struct scallop_sample *sample)
{
  (void)sample;
  *(int *)context += 1;
  return true;
}

static void refuse_in_wide(const struct refusal *r, enum scallop_width width)
{
  const struct scallop_crawler *c = &r->crawler;
  for (int kind = 0; kind < (r->what == EXTENSION ? 1 : 2); kind++)
    REFUSES(scallop_wide_phase, scallop_wide_phase(width, c, (enum scallop_phase_kind)kind, r->v0, &out), r->wanted);
  REFUSES(scallop_wide_period, scallop_wide_period(width, c, r->v0, &out), r->wanted);
  if (r->what != FROM_V0)
    REFUSES(scallop_wide_steady, scallop_wide_steady(width, c, &out), r->wanted);
}

/* With the status wanted, and nothing is touched */
static void refuse(const struct refusal *r)
{
  const struct scallop_crawler *c = &r->crawler;
  const struct scallop_steady_result steady = { 0 };
  const struct scallop_phase_result phase = { .t1 = 0 };
  const struct scallop_period_result period = { 0 };
  int calls = 0;
  double work = 42;
  under_test = r;
  for (int k = 0; k < (r->what == EXTENSION ? 1 : 2); k++) {
    enum scallop_phase_kind kind = (enum scallop_phase_kind)k;
    REFUSES(scallop_phase_result, scallop_phase(c, kind, r->v0, &out), r->wanted);
    REFUSES(scallop_phase_error, scallop_phase_error(c, kind, r->v0, &phase, &out), r->wanted);
    assert_int_equal(scallop_phase_intervals(c, kind, r->v0, no_visit, &calls), r->wanted);
    assert_int_equal(scallop_friction_work(c, k == 0 ? r->v0 : 0, k == 0 ? 0 : r->v0, &work), r->wanted);
  }
  REFUSES(scallop_period_result, scallop_period(c, r->v0, &out), r->wanted);
  REFUSES(scallop_period_error, scallop_period_error(c, r->v0, &period, &out), r->wanted);
  assert_int_equal(scallop_trajectory(c, r->v0, 2, 3, no_sample, &calls), r->wanted);
  if (r->what != FROM_V0) {
    REFUSES(scallop_steady_result, scallop_steady(c, &out), r->wanted);
    REFUSES(scallop_steady_error, scallop_steady_error(c, &steady, &out), r->wanted);
  }
  assert_true(calls == 0 && work == 42);
  refuse_in_wide(r, SCALLOP_LONG_DOUBLE);
  refuse_in_wide(r, SCALLOP_BINARY128);
}

TEST(bad_parameters)
{
  static const double bad[] = { NAN, -NAN, INFINITY, -INFINITY, 0, -0.0, -1, -1e-300 },
                      bad_alpha[] = { NAN, INFINITY, -INFINITY, 0, 1, -0.25, 1.25 };
  check_failed = name_the_culprit;
  for (int i = 0; i < PARAMETERS; i++)
    for (size_t k = 0; k < (i == 6 ? sizeof bad_alpha : sizeof bad) / sizeof *bad; k++) {
      struct refusal r = { "a bad parameter", scallop_crawler_default(), 0, EVERY, SCALLOP_EDOMAIN };
      *parameter(&r.crawler, i) = i == 6 ? bad_alpha[k] : bad[k];
      refuse(&r);
    }
  check_failed = NULL;
}

#define QUADRATIC &scallop_gait_quadratic
static const struct refusal refusals[] = {
  { "no gait", { 1, 1, 4, 1, 10, 1, 0.75, NULL }, 0, EVERY, SCALLOP_EDOMAIN },
  { "a bad start", { 1, 1, 4, 1, 10, 1, 0.75, QUADRATIC }, NAN, FROM_V0, SCALLOP_EDOMAIN },
  { "a bad start", { 1, 1, 4, 1, 10, 1, 0.75, QUADRATIC }, INFINITY, FROM_V0, SCALLOP_EDOMAIN },
  { "a bad start", { 1, 1, 4, 1, 10, 1, 0.75, QUADRATIC }, -INFINITY, FROM_V0, SCALLOP_EDOMAIN },
  { "eps overflows", { 1, 1, 4, 1, 10, 1e200, 0.5, QUADRATIC }, 0, EVERY, SCALLOP_ERANGE },
  { "eps underflows", { 1, 1, 4, 1, 10, 1e-170, 0.5, QUADRATIC }, 0, EVERY, SCALLOP_ERANGE },
  { "eps overflows: L", { 1, 1, 4, 1, 1e-320, 1, 0.5, QUADRATIC }, 0, EVERY, SCALLOP_ERANGE },
  { "M overflows", { 1e308, 1e308, 4, 1, 10, 1, 0.5, QUADRATIC }, 0, EVERY, SCALLOP_ERANGE },
  { "F1 + F2 overflows", { 1, 1, 1e308, 1e308, 10, 1, 0.5, QUADRATIC }, 0, EVERY, SCALLOP_ERANGE },
  { "m1/M is subnormal", { 1e-320, 1, 4, 1, 10, 1, 0.5, QUADRATIC }, 0, EVERY, SCALLOP_ERANGE },
  { "F1/F is subnormal", { 1, 1, 1e-310, 1, 10, 1, 0.5, QUADRATIC }, 0, EVERY, SCALLOP_ERANGE },
  { "v0 in L/tau overflows", { 1, 1, 1e-200, 1e-200, 1e-200, 1, 0.5, QUADRATIC }, 1e200, FROM_V0, SCALLOP_ERANGE },
  /* eps of the period is normal; of one phase it is not, or L/tau is not */
  { "eps alpha^2 underflows", { 1, 1, 4, 1, 10, 1, 1e-170, QUADRATIC }, 0, EXTENSION, SCALLOP_ERANGE },
  { "eps alpha^2 loses digits", { 1, 1, 4, 1, 10, 1, 1e-158, QUADRATIC }, 0, EXTENSION, SCALLOP_ERANGE },
  { "L/T overflows", { 1e-15, 1e-15, 4e290, 1e290, 1e300, 1e-9, 0.5, QUADRATIC }, 0, EXTENSION, SCALLOP_ERANGE },
};

TEST(refused)
{
  check_failed = name_the_culprit;
  for (size_t i = 0; i < sizeof refusals / sizeof *refusals; i++)
    refuse(&refusals[i]);
  check_failed = NULL;
}

/* Of friction alone, and of a trajectory */
TEST(refused_by_one)
{
  const struct scallop_crawler c = scallop_crawler_default(),
                               strong = { 1e300, 1e300, 1e308, 1e308, 10, 1, 0.75, QUADRATIC },
                               light = { 3e-308, 3e-308, 4e-308, 3e-308, 0.01, 0.1, 0.75, QUADRATIC };
  const long bad[][2] = { { 0, 1 }, { 1, 0 }, { -1, 1 }, { 1, -1 }, { 0, 0 } };
  int calls = 0;
  double work = 42;
  assert_int_equal(scallop_friction_work(&strong, 0, 0, &work), SCALLOP_ERANGE);
  assert_int_equal(scallop_friction_work(&light, 0, 0, &work), SCALLOP_ERANGE); /* the work is subnormal */
  for (size_t k = 0; k < sizeof bad / sizeof *bad; k++)
    assert_int_equal(scallop_trajectory(&c, 0, bad[k][0], bad[k][1], no_sample, &calls), SCALLOP_EDOMAIN);
  assert_true(calls == 0 && work == 42);
  assert_int_equal(scallop_trajectory(&c, 0, 1, 1, no_sample, &calls), SCALLOP_OK); /* but not the least */
  assert_int_equal(calls, 2);
}

/* In units of L/T, with eps = T^2 (F1 + F2)/(M L); m1 = m2 and F1 = 4 F2, L and T as they come. */
static struct scallop_crawler crawler_in(double L, double T, double eps, double alpha)
{
  double friction = eps * (L / T) / T, M = friction < 1 ? 1e9 : 1; /* friction: (F1 + F2)/M */
  return (struct scallop_crawler){ M / 2, M / 2, 0.8 * M * friction, 0.2 * M * friction, L, T, alpha, QUADRATIC };
}

/* Times in units of an extension, half of T, or of the period, and v0 in L over that. `first`: of the numbers in their
 * order the first that is beyond the range. */
enum motion { PHASE, PERIOD, STEADY };
static const char *const names[][6] = { { "v_end", "dx1", "dx2", "dxC", "t1", "dT" },
                                        { "v_mid", "v_end", "displacement" },
                                        { "froude", "v_start", "v_mid", "displacement" } };
static const struct beyond {
  enum motion of;
  double L, T, eps, alpha, v0;
  const char *first;
} beyond[] = {
  { PHASE, 1e-307, 1, 0.5, 0.5, 0, "v_end" },
  { PHASE, 1e308, 2e3, 0.5, 0.5, 50, "dx1" },
  { PHASE, 1e308, 2e3, 0.5, 0.5, -50, "dx1" },
  { PHASE, 1e308, 2e3, 0.1, 0.5, 1.45, "dx2" },
  { PHASE, 1e-307, 1e-6, 0.1, 0.5, 0, "dxC" },
  { PHASE, 1e-295, 2e-300, 0.5, 0.5, 1e-9, "t1" },
  { PHASE, 1e-290, 2e-300, 1e-9, 0.5, 0, "dT" },
  { PERIOD, 1e-305, 1, 1e-3, 0.5, 0, "v_mid" }, /* of the order of eps */
  { PERIOD, 1e-302, 1, 1e-4, 0.5, 0, "v_end" }, /* of that of eps^2    */
  { PERIOD, 1e308, 1e3, 0.5, 0.5, 50, "displacement" },
  { PERIOD, 1e308, 1e3, 0.5, 0.5, -50, "displacement" },
  { STEADY, 1, 1e154, 1e308, 0.75, 0, "froude" },
  { STEADY, 3e-308, 1, 1, 0.75, 0, "v_start" },
  { STEADY, 1e-304, 1, 31.9999, 0.25, 0, "v_mid" }, /* v_start is 0 */
  { STEADY, 3e-308, 1e-10, 0.1, 0.75, 0, "displacement" },
};

static bool in_range(double x) { return x == 0 || (fabs(x) >= DBL_MIN && fabs(x) <= DBL_MAX); }

/* The numbers of the names, of the crawler whose L and time are 1, in units of L and time */
static void find_numbers(const struct beyond *b, double L, double time, double number[6])
{
  const struct scallop_crawler moderate = crawler_in(1, b->of == PHASE ? 2 : 1, b->eps, b->alpha);
  double velocity = L / time;
  if (b->of == PHASE) {
    struct scallop_phase_result r = phase_of(&moderate, SCALLOP_EXTENSION, b->v0);
    const double all[6] = { r.v_end * velocity, r.dx1 * L, r.dx2 * L, r.dxC * L, r.t1 * time, r.dT * time };
    memcpy(number, all, sizeof all);
  } else if (b->of == PERIOD) {
    struct scallop_period_result r = period_of(&moderate, b->v0);
    const double all[6] = { r.v_mid * velocity, r.v_end * velocity, r.displacement * L };
    memcpy(number, all, sizeof all);
  } else {
    struct scallop_steady_result s = steady_of(&moderate);
    const struct scallop_period_result *p = &s.period;
    const double all[6] = { s.froude, p->v_start * velocity, p->v_mid * velocity, p->displacement * L };
    memcpy(number, all, sizeof all);
  }
}

TEST(beyond_the_range)
{
  for (const struct beyond *b = beyond; b < beyond + sizeof beyond / sizeof *beyond; b++) {
    struct scallop_crawler c = crawler_in(b->L, b->T, b->eps, b->alpha);
    double time = b->of == PHASE ? b->T / 2 : b->T, v0 = b->v0 * (c.L / time), number[6];
    if (b->of == PHASE)
      REFUSES(scallop_phase_result, scallop_phase(&c, SCALLOP_EXTENSION, v0, &out), SCALLOP_ERANGE);
    else if (b->of == PERIOD)
      REFUSES(scallop_period_result, scallop_period(&c, v0, &out), SCALLOP_ERANGE);
    else
      REFUSES(scallop_steady_result, scallop_steady(&c, &out), SCALLOP_ERANGE);
    if (strcmp(b->first, "froude") == 0) /* eps alone is beyond the range: moderate units do not help */
      continue;
    find_numbers(b, c.L, time, number);
    bool before = true;
    for (int i = 0; i < 6 && before; i++) {
      before = strcmp(names[b->of][i], b->first) != 0;
      if (in_range(number[i]) != before)
        fail_msg("row %d: %s, and %s is not the first", (int)(b - beyond), names[b->of][i], b->first);
    }
  }
}

struct last_sample {
  long count;
  struct scallop_sample sample;
};
static bool keep(void *context, const struct scallop_sample *sample)
{
  struct last_sample *last = context;
  last->count++;
  last->sample = *sample;
  return isfinite(sample->t) && isfinite(sample->x1) && isfinite(sample->x2) && isfinite(sample->v1)
         && isfinite(sample->v2);
}

/* v0 in units of L/T. Whichever number of the next sample would overflow, those before it are given. */
static const struct {
  double L, T, eps, v0;
} motions[] = { { 1e308, 1e3, 0.5, -1 },  { 1e308, 1e3, 0.5, 1 },  { 1e308, 1e3, 1e-3, 0.5 },
                { 8e307, 1, 0.01, -0.5 }, { 8e307, 1, 0.01, 0.5 }, { 1e10, 1e308, 1e300, 0 } };

TEST(trajectories)
{
  for (size_t i = 0; i < sizeof motions / sizeof *motions; i++) {
    struct scallop_crawler c = crawler_in(motions[i].L, motions[i].T, motions[i].eps, 0.5);
    struct last_sample last = { 0 };
    assert_int_equal(scallop_trajectory(&c, motions[i].v0 * (c.L / c.T), 10, 64, keep, &last), SCALLOP_ERANGE);
    assert_true(last.count > 1 && last.count < 10 * 64);
    assert_true(keep(&(struct last_sample){ 0 }, &last.sample));
  }
}
