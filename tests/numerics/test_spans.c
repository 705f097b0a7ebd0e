/* The intervals of a phase in the units of the parameters: they cover the phase, follow one another, add up to it, and
 * are on the trajectory. */
#include <float.h>

#include "numerics/numerics.h"
#include "tests/support/check.h"
#include "tests/support/random_crawler.h"

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

/* A velocity has the sign that the mode says, up to rounding; that of a stuck body is 0. */
static void check_sign(int sign, double begin, double end, double tolerance)
{
  if (sign == 0) {
    CHECK_EQUAL(begin, 0);
    CHECK_EQUAL(end, 0);
  } else
    assert_true(sign * begin >= -tolerance && sign * end >= -tolerance);
}

static void check_phase(const struct scallop_crawler *c, enum scallop_phase_kind kind, double v0)
{
  struct kept k = { .crawler = c, .kind = kind };
  struct scallop_phase_result r;
  double tau = scallop_phase_duration(c, kind), x1 = 0, x2 = 0;
  assert_int_equal(scallop_phase(c, kind, v0, &r), SCALLOP_OK);
  assert_int_equal(scallop_phase_intervals(c, kind, v0, keep, &k), SCALLOP_OK);
  /* an operation errs by half an ulp of its result, and no number here is a sum of more than some ten that are as large
   * as this */
  double speed = 4 * c->L / tau + fabs(v0) + (c->F1 + c->F2) / (c->m1 + c->m2) * tau, near = 32 * DBL_EPSILON;
  for (int i = 0; i < k.count; i++) {
    const struct scallop_span *s = &k.span[i], *before = s - 1;
    CHECK_NEAR(s->t_begin, i == 0 ? 0 : before->t_end, near * tau);
    assert_true(s->duration > 0);
    CHECK_NEAR(s->t_end - s->t_begin, s->duration, near * tau);
    CHECK_NEAR(s->v1_begin, i == 0 ? v0 : before->v1_end, near * speed);
    CHECK_NEAR(s->v2_begin, i == 0 ? v0 : before->v2_end, near * speed);
    check_sign(s->mode.s1, s->v1_begin, s->v1_end, near * speed);
    check_sign(s->mode.s2, s->v2_begin, s->v2_end, near * speed);
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

/* Where the bodies are when a span begins, and the sample that the trajectory has at some time */
struct passage {
  struct kept *phase;
  double x1, x2;
  double steepest; /* no body accelerates more */
  double near;     /* of positions             */
};

/* A body that has been at x with velocity v is after that time (or was, before it) within steepest time^2/2 of x + v
 * time. */
static void on_the_way(const struct passage *p, const struct scallop_sample *sample, double time, const double x[2],
                       const double v[2])
{
  double bend = p->steepest * time * time / 2 + p->near;
  CHECK_NEAR(sample->x1, x[0] + v[0] * time, bend);
  CHECK_NEAR(sample->x2, x[1] + v[1] * time, bend);
}

static bool is_on_a_span(void *context, const struct scallop_sample *sample)
{
  const struct passage *p = context;
  double x[2] = { p->x1, p->x2 };
  bool found = false;
  if (sample->t > p->phase->span[p->phase->count - 1].t_end)
    return false;
  for (int i = 0; i < p->phase->count; i++) {
    const struct scallop_span *s = &p->phase->span[i];
    const double after[2] = { x[0] + s->dx1, x[1] + s->dx2 };
    if (s->t_begin <= sample->t && sample->t <= s->t_end) {
      on_the_way(p, sample, sample->t - s->t_begin, x, (double[]){ s->v1_begin, s->v2_begin });
      on_the_way(p, sample, sample->t - s->t_end, after, (double[]){ s->v1_end, s->v2_end });
      found = true;
    }
    x[0] = after[0];
    x[1] = after[1];
  }
  assert_true(found);
  return true;
}

TEST(spans_are_on_the_trajectory)
{
  struct random r = { 20261123 };
  for (int i = 0; i < check_cases(400); i++) {
    struct scallop_crawler c = random_crawler(&r, (enum family)(i % FAMILIES), every_gait[i % SMOOTH_GAITS]);
    double tau = scallop_phase_duration(&c, SCALLOP_EXTENSION), friction = (c.F1 + c.F2) / (c.m1 + c.m2);
    double v0 = i % 5 == 0 ? 0 : random_between(&r, -2, 2) * c.L / c.T;
    struct kept k = { .crawler = &c, .kind = SCALLOP_EXTENSION };
    struct passage p = { .phase = &k,
                         .steepest = 10 * c.L / (tau * tau) + friction, /* the trapezoid's l'' is 128/13 */
                         .near = 32 * DBL_EPSILON * (4 * c.L + tau * (fabs(v0) + friction * tau)) };
    assert_int_equal(scallop_phase_intervals(&c, SCALLOP_EXTENSION, v0, keep, &k), SCALLOP_OK);
    assert_true(scallop_trajectory(&c, v0, 1, 512, is_on_a_span, &p) >= 0);
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
