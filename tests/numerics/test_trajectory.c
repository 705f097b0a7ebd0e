/* Trajectories against the phases and periods they are made of, against their own derivative, and over
 * a hundred thousand periods; and what every function of numerics/ refuses. */
#include <float.h>
#include <stdlib.h>

#include "tests/support/random_crawler.h"
#include "tests/support/solved.h"

enum { BOUND = 16, CRAWLERS = 25, MANY = 100000 };
#define ULP DBL_EPSILON

struct track {
  struct scallop_sample *sample;
  long count, room;
  long stop_after; /* samples, 0: never */
};

static bool keep(void *context, const struct scallop_sample *sample)
{
  struct track *t = context;
  assert_true(t->count < t->room);
  t->sample[t->count++] = *sample;
  return t->count != t->stop_after;
}

/* All samples; the caller frees .sample. */
static struct track run(const struct scallop_crawler *c, double v0, long periods, long samples)
{
  struct track t = { .room = periods * samples + 1 };
  t.sample = calloc((size_t)t.room, sizeof *t.sample);
  assert_non_null(t.sample);
  assert_int_equal(scallop_trajectory(c, v0, periods, samples, keep, &t), SCALLOP_OK);
  assert_int_equal(t.count, t.room);
  return t;
}

static bool keep_last(void *context, const struct scallop_sample *sample)
{
  *(struct scallop_sample *)context = *sample;
  return true;
}

static struct scallop_sample last_of(const struct scallop_crawler *c, double v0, long periods)
{
  struct scallop_sample last;
  assert_int_equal(scallop_trajectory(c, v0, periods, 1, keep_last, &last), SCALLOP_OK);
  return last;
}

static double fastest(const struct scallop_crawler *c, double v0)
{
  return fabs(v0) + 3 * c->L / (c->T * fmin(c->alpha, 1 - c->alpha));
}

/* Both velocities, and every position, as the phase gives them; alpha = k/8, so that sample k of 8 is
 * at the very end of the extension. */
static void ends_of_phases(const struct scallop_crawler *given, double v0, int k)
{
  struct scallop_crawler c = *given;
  c.alpha = k / 8.;
  enum { PERIODS = 5 };
  struct track t = run(&c, v0, PERIODS, 8);
  double v = v0, x1 = 0, x2 = 0, xC = 0;
  for (int n = 0; n < PERIODS; n++) {
    double loose = BOUND * ULP * (n + 1);
    for (int kind = 0; kind < 2; kind++) {
      const struct scallop_sample *s = &t.sample[8 * n + (kind == 0 ? k : 8)];
      struct scallop_phase_result r = phase_of(&c, kind, v);
      v = r.v_end;
      x1 += r.dx1;
      x2 += r.dx2;
      xC += r.dxC;
      double size = fastest(&c, v0);
      CHECK_NEAR(s->v1, v, loose * size);
      CHECK_NEAR(s->v2, v, loose * size);
      CHECK_NEAR(s->x1, x1, loose * size * c.T);
      CHECK_NEAR(s->x2, x2, loose * size * c.T);
      CHECK_NEAR(s->xC, xC, loose * size * c.T);
      CHECK_NEAR(s->l, kind == SCALLOP_EXTENSION ? c.L : 0, ULP * c.L);
    }
  }
  free(t.sample);
}

TEST(against_phases)
{
  struct random r = { 51 };
  for (int family = 0; family < FAMILIES; family++)
    for (int n = 0; n < check_cases(CRAWLERS); n++) {
      struct scallop_crawler c = random_crawler(&r, (enum family)family, every_gait[n % SMOOTH_GAITS]);
      double v0 = random_start(&r, &c, SCALLOP_EXTENSION);
      ends_of_phases(&c, v0, 1 + random_below(&r, 7));
    }
}

/* Period starts against the iterated period map, and the end against its displacements. */
TEST(against_periods)
{
  struct random r = { 52 };
  for (int n = 0; n < check_cases(FAMILIES * CRAWLERS); n++) {
    struct scallop_crawler c = random_crawler(&r, (enum family)(n % FAMILIES), every_gait[n % ALL_GAITS]);
    double v0 = random_start(&r, &c, SCALLOP_EXTENSION), v = v0, x = 0, size = fastest(&c, v0);
    struct track t = run(&c, v0, 20, 1);
    for (int k = 0; k < 20; k++) {
      double loose = BOUND * ULP * (k + 1) * size;
      CHECK_NEAR(t.sample[k].xC, x, loose * c.T);
      CHECK_EQUAL(t.sample[k].t, k * c.T);
      if (n % ALL_GAITS < SMOOTH_GAITS) /* v1 = v2 only where l' = 0 */
        CHECK_NEAR(t.sample[k].v1, v, loose);
      struct scallop_period_result p = period_of(&c, v);
      v = p.v_end;
      x += p.displacement;
    }
    CHECK_NEAR(t.sample[20].v1, v, 20 * BOUND * ULP * size);
    CHECK_NEAR(t.sample[20].x2, x, 20 * BOUND * ULP * size * c.T);
    free(t.sample);
  }
}

/* x2 - x1 = l, v2 - v1 = l', xC between; and each step of x is the mean of v over it: the trapezium
 * rule is within (its two ends) step/2 times the variation of v, which accelerations bound. */
static void one_motion(const struct scallop_crawler *c, double v0)
{
  enum { SAMPLES = 2048, PERIODS = 2 };
  struct track t = run(c, v0, PERIODS, SAMPLES);
  double short_phase = fmin(c->alpha, 1 - c->alpha), step = c->T / SAMPLES;
  double steepest = 10 * c->L / (c->T * c->T * short_phase * short_phase);
  double acceleration = steepest + (c->F1 + c->F2) / fmin(c->m1, c->m2);
  double noise = BOUND * ULP * PERIODS * fastest(c, v0) * c->T;
  for (long j = 0; j < t.count; j++) {
    const struct scallop_sample *s = &t.sample[j];
    double length, rate, at = (double)(j % SAMPLES) / SAMPLES;
    enum scallop_phase_kind kind = at < c->alpha ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
    double in_phase = kind == SCALLOP_EXTENSION ? at / c->alpha : (at - c->alpha) / (1 - c->alpha);
    scallop_gait_at(c->gait, kind, in_phase, &length, &rate, NULL);
    double whole = (double)(j / SAMPLES); /* NOLINT(bugprone-integer-division) */
    CHECK_NEAR(s->t, (whole + at) * c->T, ULP * s->t);
    CHECK_NEAR(s->l, length * c->L, BOUND * ULP * c->L);
    CHECK_NEAR(s->x2 - s->x1, s->l, noise);
    CHECK_NEAR(s->xC, 0.5 * (s->x1 + s->x2), noise);
    CHECK_NEAR(s->v2 - s->v1, rate * c->L / scallop_phase_duration(c, kind), noise / c->T);
    if (j + 1 == t.count)
      break;
    CHECK_NEAR(s[1].x1 - s->x1, 0.5 * (s->v1 + s[1].v1) * step, 0.25 * acceleration * step * step + noise);
    CHECK_NEAR(s[1].x2 - s->x2, 0.5 * (s->v2 + s[1].v2) * step, 0.25 * acceleration * step * step + noise);
  }
  free(t.sample);
}

TEST(velocity_is_the_derivative)
{
  struct random r = { 53 };
  for (int n = 0; n < check_cases(80); n++) {
    struct scallop_crawler c = random_crawler(&r, n % 2 ? ORDINARY : STICK_SLIP, every_gait[n % SMOOTH_GAITS]);
    c.alpha = random_between(&r, 0.1, 0.9);
    one_motion(&c, random_start(&r, &c, SCALLOP_EXTENSION));
  }
}

/* A body that is stuck has velocity exactly 0 and, within rounding, stays where it is. */
TEST(a_stuck_body_stays)
{
  for (int g = 0; g < SMOOTH_GAITS; g++) {
    struct scallop_crawler c = { 1000, 1, 1000, 1, 1, 1, 0.5, every_gait[g] };
    struct track t = run(&c, 0, 3, 64);
    for (long j = 0; j < t.count; j++) {
      CHECK_EQUAL(t.sample[j].v1, 0);
      CHECK_NEAR(t.sample[j].x1, 0, BOUND * ULP * c.m2 / c.m1);
      CHECK_NEAR(t.sample[j].x2, t.sample[j].l, BOUND * ULP);
    }
    free(t.sample);
  }
}

/* v_start is rounded, and the map brings it back: what is left is one rounding of the velocity and one
 * of the displacement in every period, none of which grows. */
static void no_drift(const struct scallop_crawler *c)
{
  struct scallop_steady_result s = steady_of(c);
  const struct scallop_period_result *p = &s.period;
  struct scallop_sample last = last_of(c, p->v_start, MANY);
  double v = fmax(fabs(p->v_start), fabs(p->v_mid)), stuck = p->regime == SCALLOP_SLIDING ? 0 : c->L;
  CHECK_NEAR(last.v1, p->v_start, BOUND * ULP * v);
  CHECK_NEAR(last.x1, MANY * p->displacement, MANY * BOUND * ULP * fmax(fabs(p->displacement), fmax(v * c->T, stuck)));
  CHECK_RELATIVE(last.t, MANY * c->T, ULP);
}

TEST(steady_does_not_drift)
{
  struct random r = { 54 };
  struct scallop_crawler c = scallop_crawler_default();
  no_drift(&c);
  c.T = 1e-3;
  no_drift(&c);
  for (int n = 0; n < 6; n++) { /* minimum jerk needs its slow `when`: the library's gaits */
    c = random_crawler(&r, (enum family)(n % 4), every_gait[n % 2]);
    no_drift(&c);
  }
}

/* Small T, quadratic, forward: the map is v* + m (v - v*) while the modes stay ++ -+ ++ | ++ +- ++, so
 * v_n = v* (1 - m^n) from rest, with 1 - m = v_1/v*, which has no cancellation. */
static void geometric(double T, double F, long n)
{
  struct scallop_crawler c = scallop_crawler_default();
  c.T = T;
  c.F1 = 4 * F;
  c.F2 = F;
  struct scallop_steady_result s = steady_of(&c);
  struct scallop_period_result first = period_of(&c, 0);
  double target = s.period.v_start, loss = first.v_end / target;
  CHECK_NEAR(1 - s.period.multiplier, loss, 4 * ULP);
  CHECK_RELATIVE(last_of(&c, 0, n).v1, -target * expm1((double)n * log1p(-loss)), BOUND * ULP);
}

TEST(from_rest_geometrically)
{
  geometric(1e-3, 1, MANY); /* eps = 2.5e-7: a tenth of the way */
  geometric(1e-3, 1, 1000);
  geometric(1e-3, 100, MANY);   /* nearly there */
  geometric(1e-2, 1, 3 * MANY); /* there */
  geometric(1e-8, 1, MANY);     /* eps = 2.5e-17: hardly begun */
}

/* From rest and from far away the steady state is reached. */
TEST(converges)
{
  struct random r = { 55 };
  for (int n = 0; n < check_cases(60); n++) {
    struct scallop_crawler c = random_crawler(&r, n % 2 ? ORDINARY : STICK_SLIP, every_gait[n % SMOOTH_GAITS]);
    c.alpha = random_between(&r, 0.1, 0.9);
    set_eps(&c, random_decades(&r, 0.5, 60));
    struct scallop_steady_result s = steady_of(&c);
    const double starts[] = { 0, 2 * fastest(&c, 0), -2 * fastest(&c, 0) };
    for (int k = 0; k < 3; k++)
      CHECK_NEAR(last_of(&c, starts[k], 2000).v1, s.period.v_start,
                 BOUND * ULP * fastest(&c, 0) / (1 - s.period.multiplier));
  }
}

TEST(stops_when_told)
{
  struct scallop_crawler c = scallop_crawler_default();
  struct track all = run(&c, 0, 3, 4);
  for (long stop = 1; stop <= 13; stop++) {
    struct scallop_sample room[13];
    struct track t = { room, 0, 13, stop };
    assert_int_equal(scallop_trajectory(&c, 0, 3, 4, keep, &t), stop < 13 ? SCALLOP_STOPPED : SCALLOP_OK);
    assert_int_equal(t.count, stop);
    for (long j = 0; j < stop; j++)
      assert_memory_equal(&room[j], &all.sample[j], sizeof room[j]);
  }
  free(all.sample);
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

/* Every function that goes through an extension refuses with the status wanted, and touches nothing. */
static void refused(const struct scallop_crawler *c, double v0, bool v0_matters, enum scallop_status wanted)
{
  int calls = 0;
  REFUSES(scallop_phase_result, scallop_phase(c, SCALLOP_EXTENSION, v0, &out), wanted);
  assert_int_equal(scallop_phase_intervals(c, SCALLOP_EXTENSION, v0, no_visit, &calls), wanted);
  REFUSES(scallop_period_result, scallop_period(c, v0, &out), wanted);
  assert_int_equal(scallop_trajectory(c, v0, 2, 3, no_sample, &calls), wanted);
  if (!v0_matters)
    REFUSES(scallop_steady_result, scallop_steady(c, &out), wanted);
  assert_int_equal(calls, 0);
}

/* ... and a contraction */
static void all_refused(const struct scallop_crawler *c, double v0, bool v0_matters, enum scallop_status wanted)
{
  int calls = 0;
  refused(c, v0, v0_matters, wanted);
  REFUSES(scallop_phase_result, scallop_phase(c, SCALLOP_CONTRACTION, v0, &out), wanted);
  assert_int_equal(scallop_phase_intervals(c, SCALLOP_CONTRACTION, v0, no_visit, &calls), wanted);
  assert_int_equal(calls, 0);
}

TEST(bad_parameters)
{
  const double bad[] = { NAN, -NAN, INFINITY, -INFINITY, 0, -0.0, -1, -1e-300 };
  const double bad_alpha[] = { NAN, INFINITY, -INFINITY, 0, 1, -0.25, 1.25 };
  for (size_t k = 0; k < sizeof bad / sizeof *bad; k++)
    for (int i = 0; i < 6; i++) {
      struct scallop_crawler c = scallop_crawler_default();
      *parameter(&c, i) = bad[k];
      all_refused(&c, 0, false, SCALLOP_EDOMAIN);
    }
  struct scallop_crawler c = scallop_crawler_default();
  for (size_t k = 0; k < sizeof bad_alpha / sizeof *bad_alpha; k++) {
    c.alpha = bad_alpha[k];
    all_refused(&c, 0, false, SCALLOP_EDOMAIN);
  }
  c = with_gait(NULL);
  all_refused(&c, 0, false, SCALLOP_EDOMAIN);
}

TEST(bad_start)
{
  struct scallop_crawler c = scallop_crawler_default();
  const double bad[] = { NAN, INFINITY, -INFINITY };
  for (size_t k = 0; k < sizeof bad / sizeof *bad; k++)
    all_refused(&c, bad[k], true, SCALLOP_EDOMAIN);
}

TEST(bad_counts)
{
  struct scallop_crawler c = scallop_crawler_default();
  const long bad[][2] = { { 0, 1 }, { 1, 0 }, { -1, 1 }, { 1, -1 }, { 0, 0 } };
  int calls = 0;
  for (size_t k = 0; k < sizeof bad / sizeof *bad; k++)
    assert_int_equal(scallop_trajectory(&c, 0, bad[k][0], bad[k][1], no_sample, &calls), SCALLOP_EDOMAIN);
  assert_int_equal(calls, 0);
}

TEST(out_of_range)
{
  const struct scallop_gait *g = &scallop_gait_quadratic;
  const struct scallop_crawler bad[] = {
    { 1, 1, 4, 1, 10, 1e200, 0.5, g },     /* eps overflows         */
    { 1, 1, 4, 1, 10, 1e-170, 0.5, g },    /* eps underflows        */
    { 1, 1, 4, 1, 1e-320, 1, 0.5, g },     /* eps overflows: L      */
    { 1e308, 1e308, 4, 1, 10, 1, 0.5, g }, /* M overflows        */
    { 1, 1, 1e308, 1e308, 10, 1, 0.5, g }, /* F1 + F2 overflows  */
    { 1e-320, 1, 4, 1, 10, 1, 0.5, g },    /* m1/M is subnormal     */
    { 1, 1, 1e-310, 1, 10, 1, 0.5, g },    /* F1/F is subnormal     */
  };
  for (size_t k = 0; k < sizeof bad / sizeof *bad; k++)
    all_refused(&bad[k], 0, false, SCALLOP_ERANGE);
  struct scallop_crawler c = { 1, 1, 4, 1, 1e-200, 1, 0.5, g };
  c.F1 = c.F2 = 1e-200;
  all_refused(&c, 1e200, true, SCALLOP_ERANGE); /* v0 in L/tau overflows */
}

/* eps of the period is normal; of one phase it is not, or L/tau is not. Nothing but ERANGE will do for
 * a function that goes through that phase. */
TEST(out_of_range_in_one_phase)
{
  const struct scallop_gait *g = &scallop_gait_quadratic;
  const struct scallop_crawler bad[] = {
    { 1, 1, 4, 1, 10, 1, 1e-170, g },                    /* eps alpha^2 underflows   */
    { 1, 1, 4, 1, 10, 1, 1e-158, g },                    /* ... and loses digits     */
    { 1e-15, 1e-15, 4e290, 1e290, 1e300, 1e-9, 0.5, g }, /* L/T overflows         */
  };
  for (size_t k = 0; k < sizeof bad / sizeof *bad; k++)
    refused(&bad[k], 0, false, SCALLOP_ERANGE);
}
