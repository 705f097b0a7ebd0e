/* Trajectories against the phases and periods they are made of, against their own derivative, and over
 * a hundred thousand periods. */
#include <float.h>

#include "tests/support/odd_gaits.h"
#include "tests/support/solved.h"

enum { BOUND = 16, CRAWLERS = 25, MANY = 100000 };
#define ULP DBL_EPSILON

/* The samples of the last run: of a trajectory all, of those that are stopped as many as were wanted */
enum { ROOM = 4097 };
static struct track {
  struct scallop_sample sample[ROOM];
  long count, most;
} t;

static bool keep(void *context, const struct scallop_sample *sample)
{
  struct track *track = context;
  assert_true(track->count < ROOM);
  track->sample[track->count++] = *sample;
  return track->count != track->most;
}

static void record(const struct scallop_crawler *c, double v0, long periods, long samples)
{
  t.count = t.most = 0;
  assert_int_equal(scallop_trajectory(c, v0, periods, samples, keep, &t), SCALLOP_OK);
  assert_int_equal(t.count, periods * samples + 1);
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

/* Both velocities, and every position, as phases and periods give them; alpha = k/8, so that sample k of 8 is at the
 * very end of the extension. Where l' jumps there the bodies have no common velocity. */
static void ends_of_phases(struct scallop_crawler c, double v0, int k)
{
  enum { PERIODS = 5 };
  bool jumps = c.gait == &sawtooth_gait;
  c.alpha = k / 8.;
  record(&c, v0, PERIODS, 8);
  double v = v0, x[3] = { 0, 0, 0 }, way = 0, size = fastest(&c, v0);
  for (int n = 0; n < PERIODS; n++) {
    const struct scallop_sample *begin = &t.sample[8 * n];
    double near = BOUND * ULP * (n + 1) * size;
    struct scallop_period_result p = period_of(&c, v);
    CHECK_EQUAL(begin->t, n * c.T);
    for (int kind = 0; kind < 2; kind++) {
      const struct scallop_sample *s = &begin[kind == SCALLOP_EXTENSION ? k : 8];
      struct scallop_phase_result r = phase_of(&c, kind, v);
      v = r.v_end;
      x[0] += r.dx1;
      x[1] += r.dx2;
      x[2] += r.dxC;
      CHECK_NEAR(s->v1, v, jumps ? INFINITY : near);
      CHECK_NEAR(s->v2, v, jumps ? INFINITY : near);
      CHECK_NEAR(s->x1, x[0], near * c.T);
      CHECK_NEAR(s->x2, x[1], near * c.T);
      CHECK_NEAR(s->xC, x[2], near * c.T);
      CHECK_NEAR(s->l, kind == SCALLOP_EXTENSION ? c.L : 0, ULP * c.L);
    }
    way += p.displacement;
    CHECK_NEAR(v, p.v_end, near);
    CHECK_NEAR(begin[8].xC, way, near * c.T);
  }
}

TEST(against_phases_and_periods)
{
  struct random r = { 51 };
  for (int n = 0; n < check_cases(FAMILIES * CRAWLERS); n++) {
    struct scallop_crawler c = random_crawler(&r, (enum family)(n % FAMILIES), every_gait[n % ALL_GAITS]);
    double v0 = random_start(&r, &c, SCALLOP_EXTENSION);
    ends_of_phases(c, v0, 1 + random_below(&r, 7));
  }
}

/* The largest |l''|: it is monotone in each piece. */
static double steepest(const struct scallop_gait *gait)
{
  double most = 0;
  for (int kind = 0; kind < 2; kind++)
    for (int i = 0; i < gait->phase[kind].count; i++) {
      const struct scallop_piece *p = &gait->phase[kind].pieces[i];
      most = fmax(most, fmax(fabs(p->curve->acceleration(p, p->begin)), fabs(p->curve->acceleration(p, p->end))));
    }
  return most;
}

/* x2 - x1 = l, v2 - v1 = l', xC between; and each step of x is the mean of v over it: the trapezium
 * rule is within (its two ends) step/2 times the variation of v, which accelerations bound. */
static void one_motion(const struct scallop_crawler *c, double v0)
{
  enum { SAMPLES = 2048, PERIODS = 2 };
  record(c, v0, PERIODS, SAMPLES);
  double short_phase = fmin(c->alpha, 1 - c->alpha) * c->T, step = c->T / SAMPLES;
  double acceleration = steepest(c->gait) * c->L / (short_phase * short_phase) + (c->F1 + c->F2) / fmin(c->m1, c->m2);
  double noise = BOUND * ULP * PERIODS * fastest(c, v0) * c->T, near = 0.25 * acceleration * step * step + noise;
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
    CHECK_NEAR(s[1].x1 - s->x1, 0.5 * (s->v1 + s[1].v1) * step, near);
    CHECK_NEAR(s[1].x2 - s->x2, 0.5 * (s->v2 + s[1].v2) * step, near);
  }
}

/* Also of gaits that rest within a phase, or go back */
TEST(velocity_is_the_derivative)
{
  static const struct scallop_gait *const odd[] = { &pause_gait, &wait_gait, &hesitant_gait, &there_and_back_gait };
  struct random r = { 53 };
  for (int n = 0; n < check_cases(80); n++) {
    const struct scallop_gait *gait = n % 3 ? every_gait[n % SMOOTH_GAITS] : odd[n / 3 % 4];
    struct scallop_crawler c = random_crawler(&r, n % 2 ? ORDINARY : STICK_SLIP, gait);
    c.alpha = random_between(&r, 0.1, 0.9);
    one_motion(&c, random_start(&r, &c, SCALLOP_EXTENSION));
  }
}

/* A body that is stuck has velocity exactly 0 and, within rounding, stays where it is. */
TEST(a_stuck_body_stays)
{
  for (int g = 0; g < SMOOTH_GAITS; g++) {
    struct scallop_crawler c = { 1000, 1, 1000, 1, 1, 1, 0.5, every_gait[g] };
    record(&c, 0, 3, 64);
    for (long j = 0; j < t.count; j++) {
      CHECK_EQUAL(t.sample[j].v1, 0);
      CHECK_NEAR(t.sample[j].x1, 0, BOUND * ULP * c.m2 / c.m1);
      CHECK_NEAR(t.sample[j].x2, t.sample[j].l, BOUND * ULP);
    }
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

TEST(stops_when_told)
{
  enum { SAMPLES = 13 };
  struct scallop_crawler c = scallop_crawler_default();
  struct scallop_sample all[SAMPLES];
  record(&c, 0, 3, 4);
  memcpy(all, t.sample, sizeof all);
  for (long most = 1; most <= SAMPLES; most++) {
    t = (struct track){ .most = most };
    assert_int_equal(scallop_trajectory(&c, 0, 3, 4, keep, &t), most < SAMPLES ? SCALLOP_STOPPED : SCALLOP_OK);
    assert_int_equal(t.count, most);
    assert_memory_equal(t.sample, all, (size_t)most * sizeof *all);
  }
}
