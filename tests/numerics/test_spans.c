/* The intervals of a phase in the units of the parameters: they cover the phase, follow one another, add up to it, and
 * obey the laws of motion. */
#include <float.h>

#include "tests/support/random_crawler.h"
#include "tests/support/solved.h"

enum { KEPT = 64 };

struct kept {
  const struct scallop_crawler *crawler;
  enum scallop_phase_kind kind;
  struct scallop_span span[KEPT];
  int count;
};

static void keep(void *context, const struct scallop_interval *interval)
{
  struct kept *k = context;
  assert_true(k->count < KEPT);
  k->span[k->count++] = scallop_interval_span(interval, k->crawler, k->kind);
}

/* A velocity has the sign that the mode says, up to rounding; that of a stuck body is 0, and so is its way. */
static void check_body(int sign, double begin, double end, double way, double near)
{
  assert_true(sign == 0 ? begin == 0 && end == 0 && way == 0 : sign * begin >= -near && sign * end >= -near);
}

/* The bodies part as l says; while both slide friction alone changes their momentum, evenly. */
static void check_motion(const struct kept *k, const struct scallop_span *s, double near_speed, double near_way)
{
  const struct scallop_crawler *c = k->crawler;
  double l[2], rate[2], tau = scallop_phase_duration(c, k->kind), M = c->m1 + c->m2, mu1 = c->m1 / M, mu2 = c->m2 / M;
  scallop_gait_at(c->gait, k->kind, fmin(s->t_begin / tau, 1), &l[0], &rate[0], NULL);
  scallop_gait_at(c->gait, k->kind, fmin(s->t_end / tau, 1), &l[1], &rate[1], NULL);
  CHECK_NEAR(s->dx2 - s->dx1, (l[1] - l[0]) * c->L, near_way);
  CHECK_NEAR(s->v2_begin - s->v1_begin, rate[0] * c->L / tau, near_speed);
  CHECK_NEAR(s->v2_end - s->v1_end, rate[1] * c->L / tau, near_speed);
  check_body(s->mode.s1, s->v1_begin, s->v1_end, s->dx1, near_speed);
  check_body(s->mode.s2, s->v2_begin, s->v2_end, s->dx2, near_speed);
  if (s->mode.s1 == 0 || s->mode.s2 == 0)
    return;
  double begin = mu1 * s->v1_begin + mu2 * s->v2_begin, end = mu1 * s->v1_end + mu2 * s->v2_end;
  CHECK_NEAR(end - begin, -(c->F1 * s->mode.s1 + c->F2 * s->mode.s2) / M * s->duration, near_speed);
  CHECK_NEAR(mu1 * s->dx1 + mu2 * s->dx2, (begin + end) / 2 * s->duration, near_way);
}

static void check_phase(const struct scallop_crawler *c, enum scallop_phase_kind kind, double v0)
{
  struct kept k = { .crawler = c, .kind = kind };
  struct scallop_phase_result r = phase_of(c, kind, v0);
  double tau = scallop_phase_duration(c, kind), x1 = 0, x2 = 0;
  assert_int_equal(scallop_phase_intervals(c, kind, v0, keep, &k), SCALLOP_OK);
  /* an operation errs by half an ulp of its result, and no number here is a sum of more than some ten that are as large
   * as this: also l'' times tau, 10 at most, as the time of an event is off by an ulp */
  double speed = 4 * c->L / tau + fabs(v0) + (c->F1 + c->F2) / (c->m1 + c->m2) * tau, near = 32 * DBL_EPSILON;
  for (int i = 0; i < k.count; i++) {
    const struct scallop_span *s = &k.span[i], *before = s - 1;
    CHECK_NEAR(s->t_begin, i == 0 ? 0 : before->t_end, near * tau);
    assert_true(s->duration > 0);
    CHECK_NEAR(s->t_end - s->t_begin, s->duration, near * tau);
    CHECK_NEAR(s->v1_begin, i == 0 ? v0 : before->v1_end, near * speed);
    CHECK_NEAR(s->v2_begin, i == 0 ? v0 : before->v2_end, near * speed);
    check_motion(&k, s, near * speed, near * speed * tau);
    x1 += s->dx1;
    x2 += s->dx2;
  }
  CHECK_NEAR(k.span[k.count - 1].t_end, tau, near * tau);
  CHECK_NEAR(k.span[k.count - 1].v1_end, r.v_end, near * speed);
  CHECK_NEAR(k.span[k.count - 1].v2_end, r.v_end, near * speed);
  CHECK_NEAR(x1, r.dx1, near * speed * tau);
  CHECK_NEAR(x2, r.dx2, near * speed * tau);
}

TEST(spans_are_the_phase)
{
  struct random r = { 20261122 };
  for (int i = 0; i < check_cases(4000); i++) {
    struct scallop_crawler c = random_crawler(&r, (enum family)(i % FAMILIES), every_gait[i % SMOOTH_GAITS]);
    enum scallop_phase_kind kind = i / SMOOTH_GAITS % 2 ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION;
    double v0 = random_between(&r, -2, 2) * c.L / c.T;
    check_phase(&c, kind, i % 5 == 0 ? 0 : v0);
  }
}

/* l' jumps at the ends: the bodies have the velocities of inside. */
TEST(of_a_gait_that_jumps)
{
  const struct scallop_crawler c = { 1, 3, 4, 1, 10, 2, 0.5, every_gait[SAWTOOTH] };
  struct kept k = { .crawler = &c, .kind = SCALLOP_EXTENSION };
  assert_int_equal(scallop_phase_intervals(&c, SCALLOP_EXTENSION, 1, keep, &k), SCALLOP_OK);
  CHECK_RELATIVE(k.span[0].v1_begin, 1 - 0.75 * 10, 4 * DBL_EPSILON);
  CHECK_RELATIVE(k.span[0].v2_begin, 1 + 0.25 * 10, 4 * DBL_EPSILON);
}
