/* Curves between regions whose shape is known. */
#include "compare/maps/curves.h"
#include "tests/support/check.h"

static const double pi = 3.14159265358979323846;

static double centre_u = 0.43, centre_v = 0.57; /* of what is round or has a corner */
static int disc(void *context, double u, double v)
{
  const double *radius = context;
  return hypot(u - centre_u, v - centre_v) < *radius;
}

static struct map_curves follow(map_region *region, void *context, int cells)
{
  struct map_curves c;
  assert_true(map_follow(region, context, cells, cells, 1.0 / cells, &c));
  return c;
}

/* Angles by which the points go around the centre, added up */
static double way_around(const struct map_curve *c)
{
  double way = 0;
  for (long i = 0; i + 1 < c->count; i++) {
    const struct map_point *p = &c->points[i], *q = p + 1;
    way += remainder(atan2(q->v - centre_v, q->u - centre_u) - atan2(p->v - centre_v, p->u - centre_u), 2 * pi);
  }
  return way;
}

TEST(closed_curve)
{
  double radius = 0.31;
  struct map_curves c = follow(disc, &radius, 16);
  assert_int_equal(c.count, 1);
  const struct map_curve *circle = &c.curves[0];
  bool inside_left = circle->left == 1;
  for (long i = 0; i < circle->count; i++) {
    const struct map_point *p = &circle->points[i];
    CHECK_NEAR(hypot(p->u - centre_u, p->v - centre_v), radius, 1e-15);
    double inward = ((centre_u - p->u) * p->nu + (centre_v - p->v) * p->nv) / radius;
    CHECK_NEAR(inward, inside_left ? 1 : -1, 0.06); /* normals from chords of up to 1/16 */
  }
  assert_int_equal(circle->points[0].end, MAP_CLOSED);
  assert_int_equal(circle->points[circle->count - 1].end, MAP_CLOSED);
  CHECK_NEAR(way_around(circle), inside_left ? 2 * pi : -2 * pi, 1e-12);
  map_curves_clear(&c);
}

/* Smaller than a cell: it is seen if a line of the grid has a node in it, and then followed with steps as small as it
 * needs. */
TEST(small_circle)
{
  double radius = 0.02;
  struct map_curves c = follow(disc, &radius, 41);
  assert_int_equal(c.count, 1);
  CHECK_NEAR(fabs(way_around(&c.curves[0])), 2 * pi, 1e-12);
  map_curves_clear(&c);
}

static int sectors(void *context, double u, double v)
{
  (void)context;
  double angle = atan2(v - centre_v, u - centre_u);
  return angle < -2 ? 0 : angle < 0.3 ? 1 : angle < 0.35 ? 2 : 3; /* and 3 ends at pi, where 0 begins */
}

TEST(junction)
{
  struct map_curves c = follow(sectors, NULL, 20);
  assert_int_equal(c.count, 4);
  for (int k = 0; k < 4; k++) {
    const struct map_curve *curve = &c.curves[k];
    const struct map_point *first = &curve->points[0], *last = &curve->points[curve->count - 1];
    assert_true((first->end == MAP_JUNCTION && last->end == MAP_OPEN)
                || (first->end == MAP_OPEN && last->end == MAP_JUNCTION));
    const struct map_point *met = first->end == MAP_JUNCTION ? first : last, *edge = met == first ? last : first;
    CHECK_NEAR(hypot(met->u - centre_u, met->v - centre_v), 0, 1e-9);
    assert_true(met->third >= 0 && met->third != curve->left && met->third != curve->right);
    assert_true(edge->u == 0 || edge->u == 1 || edge->v == 0 || edge->v == 1);
  }
  map_curves_clear(&c);
}

/* A right angle, and the region that is a line */
static int corner_and_line(void *context, double u, double v)
{
  const int *line = context;
  return *line && v == centre_v && u > centre_u ? 2 : u > centre_u && v > centre_v;
}

TEST(corner)
{
  for (int line = 0; line < 2; line++) {
    struct map_curves c = follow(corner_and_line, &line, 12);
    assert_int_equal(c.count, 1);
    const struct map_curve *curve = &c.curves[0];
    for (long i = 0; i < curve->count; i++) {
      const struct map_point *p = &curve->points[i];
      CHECK_NEAR(fmin(fabs(p->u - centre_u), fabs(p->v - centre_v)), 0, 1e-15);
    }
    assert_int_equal(curve->points[0].end, MAP_OPEN);
    assert_int_equal(curve->points[curve->count - 1].end, MAP_OPEN);
    map_curves_clear(&c);
  }
}

/* Two curves that approach each other as a cusp: the strip between them gets thinner than any step. */
static int cusp(void *context, double u, double v)
{
  (void)context;
  double width = u < 0.8 ? 0.3 * (0.8 - u) * (0.8 - u) : 0;
  return v < 0.5 ? 0 : v < 0.5 + width ? 1 : 2;
}

TEST(thin_strip)
{
  struct map_curves c = follow(cusp, NULL, 20);
  assert_int_equal(c.count, 3);
  for (int k = 0; k < 3; k++) {
    const struct map_curve *curve = &c.curves[k];
    assert_true(curve->count < 1000);
    for (long i = 0; i < curve->count; i++) {
      const struct map_point *p = &curve->points[i];
      double above = 0.5 + (p->u < 0.8 ? 0.3 * (0.8 - p->u) * (0.8 - p->u) : 0);
      CHECK_NEAR(fmin(fabs(p->v - 0.5), fabs(p->v - above)), 0, 1e-13);
      if (p->end == MAP_JUNCTION) /* where the strip is as thin as MAP_THIN */
        CHECK_NEAR(p->u, 0.8, 2 * sqrt(MAP_THIN / 0.3));
    }
  }
  map_curves_clear(&c);
}

/* Nothing lies there: no more is known of it. */
static int half(void *context, double u, double v)
{
  (void)context;
  return u > 0.7 ? MAP_NOWHERE : v > 0.3 + 0.2 * u;
}

TEST(ends_at_nowhere)
{
  struct map_curves c = follow(half, NULL, 10);
  assert_int_equal(c.count, 1);
  const struct map_curve *curve = &c.curves[0];
  const struct map_point *a = &curve->points[0], *b = &curve->points[curve->count - 1];
  const struct map_point *right = a->u > b->u ? a : b;
  assert_int_equal(right->end, MAP_STOPS);
  CHECK_NEAR(right->u, 0.7, 1e-10);
  map_curves_clear(&c);
}
