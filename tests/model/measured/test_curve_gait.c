/* The gait of a curve: turns that lie almost on a knot, and slopes that rounding made too steep. */
#include "model/measured/curve_gait.h"
#include "tests/support/check.h"

enum { KNOTS = 4 };

static const char *made(struct curve_gait *gait, struct scallop_knot knots[KNOTS])
{
  const struct curve curve = { knots, KNOTS, 1 };
  return gait_of_curve(gait, &curve, "x");
}

/* l' keeps its sign within each piece, and is 0 at the ends of the phases. */
static void check_gait(const struct curve_gait *g)
{
  for (int kind = 0; kind < 2; kind++) {
    const struct scallop_shape *shape = &g->spline.gait.phase[kind];
    for (int i = 0; i < shape->count; i++) {
      const struct scallop_piece *p = &shape->pieces[i];
      for (int k = 1; k < 8; k++)
        assert_true(p->direction * p->curve->velocity(p, p->begin + k * (p->end - p->begin) / 8) >= 0);
    }
    CHECK_EQUAL(shape->pieces[0].curve->velocity(&shape->pieces[0], shape->pieces[0].begin), 0);
  }
}

TEST(turns_almost_on_a_knot)
{
  const double slopes[] = { 1e-9, -1e-9, 0, 0.5, -0.5 };
  for (size_t i = 0; i < sizeof slopes / sizeof *slopes; i++) {
    struct scallop_knot knots[KNOTS] = { { 0, 0, slopes[i] }, { 0.25, 0.5, 3 }, { 0.5, 1, 0 }, { 0.75, 0.5, -3 } };
    struct curve_gait g;
    assert_null(made(&g, knots));
    check_gait(&g);
    CHECK_NEAR(g.L, 1, fabs(slopes[i]) < 1e-8 ? 1e-9 : 0.05);
    CHECK_NEAR(g.alpha, 0.5, fabs(slopes[i]) < 1e-8 ? 1e-7 : 0.05);
    curve_gait_free(&g);
  }
}

/* At three times the mean slope, and an ulp more, l' is 0 at the other end of the piece. */
TEST(slopes_that_are_too_steep)
{
  struct scallop_knot knots[KNOTS] = {
    { 0, 0, 0 }, { 0.25, 0.5, 6 * (1 + 0x1p-52) }, { 0.5, 1, 0 }, { 0.75, 0.5, -6 }
  };
  struct curve_gait g;
  assert_null(made(&g, knots));
  check_gait(&g);
  CHECK_EQUAL(g.L, 1);
  curve_gait_free(&g);
}

/* Two turns between two knots: l goes back in between. */
TEST(turns_between_knots)
{
  for (int back = 0; back < 2; back++) {
    struct scallop_knot knots[KNOTS] = { { 0, 0, 0 }, { 0.25, 0.5, -4 }, { 0.5, 1, 0 }, { 0.75, 0.5, -3 } };
    struct curve_gait g;
    for (int i = 0; back && i < KNOTS; i++) {
      knots[i].length = 1 - knots[i].length;
      knots[i].slope = -knots[i].slope;
    }
    assert_null(made(&g, knots));
    check_gait(&g);
    assert_true(fabs(g.spline.gait.phase[back].net) < 1);
    curve_gait_free(&g);
  }
}

TEST(curves_that_are_no_gait)
{
  struct scallop_knot rest[KNOTS] = { { 0, 1, 0 }, { 0.25, 1, 0 }, { 0.5, 1, 0 }, { 0.75, 1, 0 } },
                      near[KNOTS] = { { 0.25 - 0x1p-54, 0.9, 0 }, { 0.25, 1, 0 }, { 0.5, 0.5, -2 }, { 0.75, 0, 0 } };
  struct curve_gait g;
  assert_string_equal(made(&g, rest), "l is the same throughout: there is no gait in that");
  curve_gait_free(&g);
  assert_non_null(made(&g, near));
  curve_gait_free(&g);
}
