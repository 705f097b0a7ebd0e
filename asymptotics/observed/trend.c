#include "asymptotics/observed/trend.h"

#include <math.h>
#include <stddef.h>

#include "asymptotics/observed/points.h"
#include "asymptotics/observed/rounding.h"
#include "asymptotics/observed/student.h"

/* A change of the local order over the run that is smaller decides nothing. */
static const double SEEN = 0.005;
/* A term that does not die away has to explain the bend this many times better than those that do. */
static const double BETTER = 4;
static const double SURE = 0.995;
/* Tables that people print; the bound on what rounding explains takes the square of their length. */
enum { MOST_PRINTED = 64 };
/* In h^p |log h|^r an r smaller than this is taken for a coincidence. */
static const double LEAST_POWER = 0.4;

/* A term of x: log(1 + c u)/c with u = (h/h0)^power, h0 the coarsest h where power > 0 and the finest otherwise; u itself for c = 0. */
struct shape {
  enum trend_kind kind;
  double power; /* 0: x^2; nan: log|log h| */
  double c;
};
/* Of those that die away the first ones are taken where they are as good. */
static const struct shape shapes[] = {
  { TREND_SETTLING, 1, 0 }, { TREND_SETTLING, 2, 0 },    { TREND_SETTLING, 1, 0.5 },  { TREND_SETTLING, 1, -0.5 },
  { TREND_SETTLING, 1, 2 }, { TREND_SETTLING, 1, -0.8 }, { TREND_SETTLING, 1, 8 },    { TREND_SETTLING, 2, 0.5 },
  { TREND_SETTLING, 2, 2 }, { TREND_SETTLING, 2, -0.5 }, { TREND_SETTLING, 2, -0.8 }, { TREND_SETTLING, 2, 8 },
  { TREND_SETTLING, 3, 0 }, { TREND_SETTLING, 4, 0 },    { TREND_SETTLING, 0.5, 0 },  { TREND_SETTLING, 0.5, 2 },
  { TREND_LEAVING, -1, 0 }, { TREND_LEAVING, -1, 2 },    { TREND_LEAVING, -1, 8 },    { TREND_LEAVING, -2, 0 },
  { TREND_LEAVING, -2, 2 }, { TREND_LEAVING, -2, 8 },    { TREND_LEAVING, -0.5, 0 },  { TREND_LEAVING, -1, -0.8 },
  { TREND_CREEPING, 0, 0 }, { TREND_CREEPING, NAN, 0 },
};
enum { SHAPES = sizeof shapes / sizeof *shapes };

struct run {
  const struct scallop_order_point *points;
  int count, first;
  double n, x, y, xx, xy; /* means, and sums of products of what is left of x and y without them */
  double coarsest, finest;
};

static int next_of(const struct run *r, int i) { return points_next(r->points, r->count, i); }
static double x_of(const struct run *r, int i) { return log(r->points[i].h) - r->x; }
static double y_of(const struct run *r, int i) { return log(fabs(r->points[i].err)) - r->y; }

static struct run run_of(const struct scallop_order_point *points, int count, int first)
{
  struct run r = { .points = points, .count = count, .first = points_next(points, count, first) };
  for (int i = r.first; i < count; i = next_of(&r, i + 1)) {
    r.n++;
    r.x += log(points[i].h);
    r.y += log(fabs(points[i].err));
    r.finest = points[i].h;
  }
  r.coarsest = points[r.first].h;
  r.x /= r.n;
  r.y /= r.n;
  for (int i = r.first; i < count; i = next_of(&r, i + 1)) {
    r.xx += x_of(&r, i) * x_of(&r, i);
    r.xy += x_of(&r, i) * y_of(&r, i);
  }
  return r;
}

static double power_of(const struct run *r, double power, double h)
{
  return pow(h / (power > 0 ? r->coarsest : r->finest), power);
}

static double term(const struct run *r, const struct shape *s, double h)
{
  double x = log(h / r->finest);
  if (s->kind == TREND_CREEPING)
    return isnan(s->power) ? log(fabs(log(h))) : x * x;
  double u = power_of(r, s->power, h);
  return s->c == 0 ? u : log1p(s->c * u) / s->c;
}

/* d term/dx */
static double term_slope(const struct run *r, const struct shape *s, double h)
{
  if (s->kind == TREND_CREEPING)
    return isnan(s->power) ? 1 / log(h) : 2 * log(h / r->finest);
  double u = power_of(r, s->power, h);
  return s->power * u / (1 + s->c * u);
}

struct bend {
  const struct shape *shape;
  double slope, factor, left; /* of the line, of the term, and the sum of squares that both leave  */
  double variance;            /* of the slope, in units of that of a point                        */
};

/* Least squares of y over x and the term; shape NULL: over x alone */
static struct bend fit(const struct run *r, const struct shape *shape)
{
  double mean = 0, tx = 0, tt = 0, ty = 0;
  for (int i = r->first; shape && i < r->count; i = next_of(r, i + 1))
    mean += term(r, shape, r->points[i].h) / r->n;
  for (int i = r->first; shape && i < r->count; i = next_of(r, i + 1))
    tx += (term(r, shape, r->points[i].h) - mean) * x_of(r, i);
  for (int i = r->first; shape && i < r->count; i = next_of(r, i + 1)) {
    double rest = term(r, shape, r->points[i].h) - mean - tx / r->xx * x_of(r, i);
    tt += rest * rest;
    ty += rest * y_of(r, i);
  }
  struct bend b = { .shape = shape, .factor = tt > 0 ? ty / tt : 0 };
  b.slope = (r->xy - b.factor * tx) / r->xx;
  b.variance = 1 / r->xx + (tt > 0 ? tx / r->xx * tx / r->xx / tt : 0);
  for (int i = r->first; i < r->count; i = next_of(r, i + 1)) {
    double bent = shape ? b.factor * (term(r, shape, r->points[i].h) - mean) : 0;
    double rest = y_of(r, i) - b.slope * x_of(r, i) - bent;
    b.left += rest * rest;
  }
  return b;
}

/* Four points leave one degree of freedom, which terms that take over fit by chance.
 * The first of those that die away that is about as good as the best of them, unless another is much better */
static struct bend best_bend(const struct run *r)
{
  struct bend bends[SHAPES], other = { .left = INFINITY };
  double least = INFINITY;
  for (int i = 0; i < SHAPES; i++) {
    if (isnan(shapes[i].power) && !(r->coarsest < 0.9)) /* log h = 0 at h = 1 */
      continue;
    bends[i] = fit(r, &shapes[i]);
    if (isnan(shapes[i].power) && fabs(bends[i].factor) < LEAST_POWER)
      continue;
    if (shapes[i].kind == TREND_SETTLING)
      least = fmin(least, bends[i].left);
    else if (bends[i].left < other.left && (r->n > 4 || shapes[i].kind == TREND_CREEPING))
      other = bends[i];
  }
  if (BETTER * other.left < least)
    return other;
  int first = 0;
  while (bends[first].left > BETTER * least)
    first++;
  return bends[first];
}

/* Where errors are C h^p but for rounding by at most e_k, in logarithms, least squares leaves at most the sum over k of |1_ik - H_ik| e_k,
 * H_ik = 1/n + x_i x_k/sum x^2. */
static bool explained_by_rounding(const struct run *r, const struct bend *line)
{
  if (r->n > MOST_PRINTED)
    return false;
  struct rounding rounding = rounding_of(r->points, r->count, r->first);
  bool explained = rounding.unit > 0;
  for (int i = r->first; i < r->count && explained; i = next_of(r, i + 1)) {
    double most = 0;
    for (int k = r->first; k < r->count; k = next_of(r, k + 1))
      most += fabs((i == k) - 1 / r->n - x_of(r, i) * x_of(r, k) / r->xx) * rounding_share(&rounding, r->points[k].err);
    explained = fabs(y_of(r, i) - line->slope * x_of(r, i)) <= most;
  }
  return explained;
}

static double half_width(const struct bend *b, double dof)
{
  return student_quantile(0.95, (long)dof) * sqrt(b->left / dof * b->variance);
}

struct trend trend_of(const struct scallop_order_point *points, int count, int first)
{
  struct run r = run_of(points, count, first);
  struct bend line = fit(&r, NULL);
  struct trend t = { .kind = TREND_STRAIGHT, .points = (int)r.n, .slope = line.slope };
  t.half_width = half_width(&line, r.n - 2);
  t.limit = t.coarsest_order = t.finest_order = t.slope;
  t.limit_half_width = t.half_width;
  t.rounded = explained_by_rounding(&r, &line);
  if (t.points < 4 || t.rounded)
    return t;
  struct bend bend = best_bend(&r);
  double dof = r.n - 3, sure = student_quantile(SURE, (long)dof);
  double from = bend.slope + bend.factor * term_slope(&r, bend.shape, r.coarsest);
  double to = bend.slope + bend.factor * term_slope(&r, bend.shape, r.finest);
  if (!(line.left - bend.left > sure * sure * bend.left / dof) || !(fabs(from - to) > SEEN))
    return t;
  t.kind = bend.shape->kind;
  t.coarsest_order = from;
  t.finest_order = to;
  t.limit = bend.slope;
  t.limit_half_width = fmax(half_width(&bend, dof), fabs(to - bend.slope));
  return t;
}
