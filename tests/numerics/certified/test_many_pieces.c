/* Gaits of very many pieces: the error must not grow with them, nor the modes change. */
#include <float.h>
#include <stdlib.h>

#include "model/gaits.h"
#include "tests/support/certified_balls.h"
#include "tests/support/random_rises.h"

/* The size of the ways that are added up: of the mechanism, of the start, and of friction. */
static double way_size(const struct scallop_crawler *c, double v0, double tau)
{
  return c->L + (fabs(v0) + (c->F1 + c->F2) * tau / (c->m1 + c->m2)) * tau;
}

/* The quadratic gait in very many pieces */
enum { CUTS = 512 }; /* of each half of a phase */

struct cut {
  struct scallop_piece pieces[2][2 * CUTS];
  struct scallop_gait gait;
};

static void cut_up(struct cut *cut)
{
  cut->gait = scallop_gait_quadratic;
  cut->gait.name = "cut-up";
  for (int kind = 0; kind < 2; kind++) {
    struct scallop_shape *shape = &cut->gait.phase[kind];
    for (int i = 0; i < 2 * CUTS; i++) {
      bool late = i >= CUTS;
      struct scallop_piece *p = &cut->pieces[kind][i];
      *p = shape->pieces[late];
      p->begin = (late ? 2 * CUTS - i : i) * (0.5 / CUTS);
      p->end = (late ? 2 * CUTS - i - 1 : i + 1) * (0.5 / CUTS);
    }
    shape->pieces = cut->pieces[kind];
    shape->count = 2 * CUTS;
    shape->concave = shape->ramps = false;
  }
}

TEST(cut_up_it_is_the_same)
{
  static struct cut cut;
  struct random r = { 20261301 };
  cut_up(&cut);
  for (int i = 0; i < 400; i++) {
    struct scallop_crawler c = random_crawler(&r, i % 4 == 0 ? STICK_SLIP : ORDINARY, &scallop_gait_quadratic);
    enum scallop_phase_kind kind = random_below(&r, 2) ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
    double v0 = random_start(&r, &c, kind), tau = scallop_phase_duration(&c, kind), way = way_size(&c, v0, tau);
    struct scallop_phase_result whole = phase_of(&c, kind, v0);
    c.gait = &cut.gait;
    struct scallop_phase_result parts = phase_of(&c, kind, v0);
    assert_int_equal(parts.modes.count, whole.modes.count);
    assert_int_equal(parts.regime, whole.regime);
    CHECK_RELATIVE(parts.t1, whole.t1, 4 * DBL_EPSILON);
    CHECK_RELATIVE(parts.dT, whole.dT, 16 * DBL_EPSILON);
    CHECK_NEAR(parts.v_end, whole.v_end, 2 * DBL_EPSILON * way / tau);
    CHECK_NEAR(parts.dx1, whole.dx1, 2 * DBL_EPSILON * way);
    CHECK_NEAR(parts.dx2, whole.dx2, 2 * DBL_EPSILON * way);
    CHECK_NEAR(parts.dxC, whole.dxC, 2 * DBL_EPSILON * way);
  }
}

/* A spline, as through data: out, back a little, out; a dwell; and the other way */
enum { KNOTS = 513 };

struct drawn {
  struct scallop_knot knots[2][KNOTS];
  struct scallop_spline spline;
};

static double drawn_length(double s)
{
  double pi = 3.14159265358979323846, part = s < 1. / 3 ? 1.2 * s : s < 0.5 ? 0.4 : 0.4 + 1.2 * (s - 0.5);
  double wave = sin(pi * part), l = (1 - cos(pi * part)) / 2 + 0.1 * wave * wave * sin(6 * pi * part);
  return fmin(fmax(l, 0), 1);
}

static void draw_phase(struct random *r, struct scallop_knot *k, bool up)
{
  for (int i = 0; i < KNOTS; i++) {
    double s = (i + (i == 0 || i == KNOTS - 1 ? 0 : random_between(r, -0.3, 0.3))) / (KNOTS - 1);
    double l = i == 0 ? 0 : i == KNOTS - 1 ? 1 : drawn_length(s);
    k[i] = (struct scallop_knot){ scallop_knot_round(s), scallop_knot_round(up ? l : 1 - l), 0 };
  }
  rises_slopes(k, KNOTS);
}

static struct drawn *draw_gait(void)
{
  struct drawn *d = calloc(1, sizeof *d);
  const struct scallop_knot *const knots[2] = { d->knots[0], d->knots[1] };
  const int count[2] = { KNOTS, KNOTS };
  struct random r = { 20261302 };
  draw_phase(&r, d->knots[0], true);
  draw_phase(&r, d->knots[1], false);
  size_t pieces = (size_t)scallop_spline_pieces(count);
  d->spline.pieces = calloc(pieces, sizeof *d->spline.pieces);
  d->spline.laws = calloc(pieces, sizeof *d->spline.laws);
  assert_int_equal(scallop_make_spline(&d->spline, "drawn", knots, count), SCALLOP_OK);
  return d;
}

static void rub_out(struct drawn *d)
{
  free(d->spline.pieces);
  free(d->spline.laws);
  free(d);
}

TEST(the_gait_has_it_all)
{
  struct drawn *d = draw_gait();
  for (int kind = 0; kind < 2; kind++) {
    const struct scallop_shape *shape = &d->spline.gait.phase[kind];
    int seen[3] = { 0, 0, 0 };
    for (int i = 0; i < shape->count; i++)
      seen[shape->pieces[i].direction + 1]++;
    assert_true(seen[0] > 10 && seen[1] > 10 && seen[2] > 10);
    CHECK_AT_MOST(shape->peak, 4);
  }
  rub_out(d);
}

static void compare(const struct scallop_crawler *c, enum scallop_phase_kind kind, double v0)
{
  SCOPED(scallop_certified_phase, exact);
  double tau = scallop_phase_duration(c, kind), way = way_size(c, v0, tau);
  struct scallop_phase_result got = phase_of(c, kind, v0);
  certify_phase(&exact, c, kind, v0, 20);
  assert_true(modes_alike(&got.modes, &exact.modes));
  assert_int_equal(got.regime, exact.regime);
  CHECK_NEAR(got.v_end, middle(exact.v_end), 2 * DBL_EPSILON * way / tau);
  CHECK_NEAR(got.dx1, middle(exact.dx1), 2 * DBL_EPSILON * way);
  CHECK_NEAR(got.dx2, middle(exact.dx2), 2 * DBL_EPSILON * way);
  CHECK_NEAR(got.dxC, middle(exact.dxC), 2 * DBL_EPSILON * way);
  if (exact.switches) {
    CHECK_NEAR(got.t1, middle(exact.t1), 4 * DBL_EPSILON * tau);
    CHECK_NEAR(got.dT, middle(exact.dT), 4 * DBL_EPSILON * tau);
  }
}

TEST(a_spline_through_many_knots)
{
  struct random r = { 20261303 };
  struct drawn *d = draw_gait();
  for (int i = 0; i < 24; i++) {
    struct scallop_crawler c = random_crawler(&r, i % 3 == 0 ? STICK_SLIP : ORDINARY, &d->spline.gait);
    enum scallop_phase_kind kind = i % 2 ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
    compare(&c, kind, random_start(&r, &c, kind));
  }
  rub_out(d);
}

TEST(its_steady_state)
{
  struct drawn *d = draw_gait();
  const struct scallop_crawler c = { 2, 1, 9, 1, 3, 0.5, 0.8, &d->spline.gait };
  struct scallop_steady_result got = steady_of(&c);
  SCOPED(scallop_certified_steady, exact);
  certify_steady(&exact, &c, 20);
  for (int kind = 0; kind < 2; kind++)
    assert_true(modes_alike(&got.period.modes[kind], &exact.modes[kind]));
  CHECK_NEAR(got.period.v_start, middle(exact.v_start), 4 * DBL_EPSILON * c.L / c.T);
  CHECK_NEAR(got.period.displacement, middle(exact.displacement), 4 * DBL_EPSILON * c.L);
  rub_out(d);
}
