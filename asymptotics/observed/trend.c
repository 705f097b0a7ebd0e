#include "asymptotics/observed/trend.h"

#include <math.h>
#include <stddef.h>

#include "asymptotics/observed/points.h"
#include "asymptotics/observed/rounding.h"
#include "asymptotics/observed/student.h"

/* A change of the local order over the run that is smaller decides nothing. */
static const double SEEN = 0.005;
/* Sums of squares are compared. A term that dies away is as good as another if it leaves at most so many times as much; one that does not has to be
 * so many times better than those. */
static const double AS_GOOD = 4, BETTER[] = { [TREND_LEAVING] = 8, [TREND_CREEPING] = 25 };
static const double SURE = 0.995;
/* Tables that people print; the bound on what rounding explains takes the square of their length. */
enum { MOST_PRINTED = 64, MOST_STEPS = 30 };
/* In h^p |log h|^r an r smaller than this is taken for a coincidence. */
static const double LEAST_POWER = 0.4;
/* Of two terms with opposite signs the smaller one is at most so much of the larger. */
static const double CANCELLED = 0.9975;
/* Of log(1 + c): the step of the grid, what is a step no longer, and the end of the grid where h spans hundreds of decades. */
static const double STEP = 1.5, SMALL_STEP = 1e-12, MOST_GROWTH = 60;

/* What bends the line. Two terms: log(1 + c u), u = (h/h0)^power, h0 the coarsest h where power > 0 and the finest otherwise. Of a creeping one
 * (power 0 or nan) a multiple: x^2 for 0, log|log h| for nan. */
struct shape {
  enum trend_kind kind;
  double power;
};
/* Of those that die away the first ones are taken where they are as good. */
static const struct shape shapes[] = {
  { TREND_SETTLING, 1 }, { TREND_SETTLING, 2 }, { TREND_SETTLING, 3 },   { TREND_SETTLING, 4 }, { TREND_SETTLING, 0.5 },
  { TREND_LEAVING, -1 }, { TREND_LEAVING, -2 }, { TREND_LEAVING, -0.5 }, { TREND_CREEPING, 0 }, { TREND_CREEPING, NAN },
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

/* A line and what bends it: err = e^a h^slope (1 + c u), or e^a h^slope e^(factor term) for what creeps. */
struct bend {
  const struct shape *shape; /* NULL: the line alone                                      */
  double c;
  double slope, factor; /* of the line, of the term                                  */
  double left;          /* the sum of squares                                        */
  double variance;      /* of the slope, in units of that of a point                 */
  double others;        /* how far the slopes of bends that are as good are from it  */
};

static bool creeps(const struct bend *b) { return b->shape && b->shape->kind == TREND_CREEPING; }

/* At one h: what bends the line by a known amount, what least squares finds the factor of, and how much each adds to the local order.
 * Of two terms log(1 + c u), and its derivative to log(1 + c). */
struct bent {
  double known, term, known_order, term_order;
};

static struct bent bent_at(const struct run *r, const struct bend *b, double h)
{
  if (!b->shape)
    return (struct bent){ 0 };
  double power = b->shape->power, x = log(h / r->finest);
  if (creeps(b))
    return isnan(power) ? (struct bent){ .term = log(fabs(log(h))), .term_order = 1 / log(h) }
                        : (struct bent){ .term = x * x, .term_order = 2 * x };
  double u = exp(power * log(h / (power > 0 ? r->coarsest : r->finest))), cu = b->c * u;
  return (struct bent){ .known = log1p(cu), .term = (1 + b->c) * u / (1 + cu), .known_order = power * cu / (1 + cu) };
}

/* The local order at h */
static double order_at(const struct run *r, const struct bend *b, double h)
{
  struct bent at = bent_at(r, b, h);
  return b->slope + at.known_order + b->factor * at.term_order;
}

/* Least squares of what the known leaves of y, over x and the term. */
static void fit(const struct run *r, struct bend *b)
{
  double known = 0, term = 0, yx = r->xy, tx = 0, tt = 0, ty = 0;
  for (int i = r->first; i < r->count; i = next_of(r, i + 1)) {
    struct bent at = bent_at(r, b, r->points[i].h);
    double rest = y_of(r, i) - at.known;
    known += at.known / r->n;
    term += at.term / r->n;
    yx -= at.known * x_of(r, i);
    tx += at.term * x_of(r, i);
    tt += at.term * at.term;
    ty += at.term * rest;
  }
  tt -= r->n * term * term + tx / r->xx * tx;
  ty += r->n * term * known - tx / r->xx * yx;
  bool bends = tt > 0;
  b->factor = bends ? ty / tt : 0;
  b->slope = (yx - (creeps(b) ? b->factor * tx : 0)) / r->xx;
  b->variance = 1 / r->xx + (bends ? tx / r->xx * tx / r->xx / tt : 0);
  b->left = 0;
  for (int i = r->first; i < r->count; i = next_of(r, i + 1)) {
    struct bent at = bent_at(r, b, r->points[i].h);
    double rest = y_of(r, i) - (at.known - known) - b->slope * x_of(r, i) - (creeps(b) ? b->factor * (at.term - term) : 0);
    b->left += rest * rest;
  }
}

static struct bend bend_at(const struct run *r, const struct shape *shape, double t)
{
  struct bend b = { .shape = shape, .c = expm1(t) };
  fit(r, &b);
  return b;
}

/* From b to the best c near it, with low <= log(1 + c) <= high: Newton's method on the residuals made linear, in shorter steps where that fails */
static struct bend refine(const struct run *r, struct bend best, double low, double high)
{
  double step = best.factor;
  for (int k = 0; k < MOST_STEPS && fabs(step) > SMALL_STEP; k++) {
    double t = log1p(best.c) + fmin(fmax(step, -STEP), STEP);
    struct bend b = bend_at(r, best.shape, fmin(fmax(t, low), high));
    step = b.left < best.left ? b.factor : step / 4;
    best = b.left < best.left ? b : best;
  }
  return best;
}

/* The best c, between those where the second term is all but the first, with the other sign, and where it is as large at the far end: from the
 * best of a grid, or from 0. */
static struct bend best_of(const struct run *r, const struct shape *shape)
{
  struct bend none = bend_at(r, shape, 0);
  if (shape->kind == TREND_CREEPING)
    return none;
  double low = log1p(-CANCELLED);
  double high = fmin(log1p(shape->power > 0 ? pow(r->coarsest / r->finest, shape->power) : 1), MOST_GROWTH);
  struct bend best = none;
  for (double t = low; t < high + STEP; t += STEP) {
    struct bend b = bend_at(r, shape, fmin(t, high));
    best = b.left < best.left ? b : best;
  }
  best = refine(r, best, low, high);
  none = refine(r, none, low, high);
  return none.left <= best.left ? none : best;
}

/* Four points leave one degree of freedom, which terms that take over fit by chance.
 * The first of those that die away that is about as good as the best of them, unless another is much better */
static struct bend best_bend(const struct run *r)
{
  struct bend bends[SHAPES], other;
  double least = INFINITY, least_other = INFINITY;
  for (int i = 0; i < SHAPES; i++) {
    if (isnan(shapes[i].power) && !(r->coarsest < 0.9)) /* log h = 0 at h = 1 */
      continue;
    bends[i] = best_of(r, &shapes[i]);
    if (isnan(shapes[i].power) && fabs(bends[i].factor) < LEAST_POWER)
      continue;
    if (shapes[i].kind == TREND_SETTLING)
      least = fmin(least, bends[i].left);
    else if (BETTER[shapes[i].kind] * bends[i].left < least_other && (r->n > 4 || shapes[i].kind == TREND_CREEPING)) {
      other = bends[i];
      least_other = BETTER[shapes[i].kind] * other.left;
    }
  }
  if (least_other < least)
    return other;
  int first = 0;
  while (bends[first].left > AS_GOOD * least)
    first++;
  for (int i = first + 1; i < SHAPES && shapes[i].power >= 1; i++)
    if (bends[i].left <= AS_GOOD * least)
      bends[first].others = fmax(bends[first].others, fabs(bends[i].slope - bends[first].slope));
  return bends[first];
}

/* Where errors are C h^p but for rounding and noise of at most e_k, in logarithms, least squares leaves at most the sum over k of |1_ik - H_ik| e_k,
 * H_ik = 1/n + x_i x_k/sum x^2. */
static bool explained_by_rounding(const struct run *r, const struct bend *line)
{
  if (r->n > MOST_PRINTED)
    return false;
  struct rounding rounding = rounding_of(r->points, r->count, r->first);
  bool explained = rounding.unit > 0 || points_noise_is_known(r->points, r->count);
  for (int i = r->first; i < r->count && explained; i = next_of(r, i + 1)) {
    double most = 0;
    for (int k = r->first; k < r->count; k = next_of(r, k + 1)) {
      const struct scallop_order_point *p = &r->points[k];
      most += fabs((i == k) - 1 / r->n - x_of(r, i) * x_of(r, k) / r->xx)
              * (rounding_share(&rounding, p->err) + p->noise / fabs(p->err));
    }
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
  struct bend line = bend_at(&r, NULL, 0);
  struct trend t = { .kind = TREND_STRAIGHT, .points = (int)r.n, .slope = line.slope };
  t.half_width = half_width(&line, r.n - 2);
  t.limit = t.coarsest_order = t.finest_order = t.slope;
  t.limit_half_width = t.half_width;
  t.rounded = explained_by_rounding(&r, &line);
  if (t.points < 4 || t.rounded)
    return t;
  struct bend bend = best_bend(&r);
  double dof = r.n - 3, sure = student_quantile(SURE, (long)dof);
  double from = order_at(&r, &bend, r.coarsest), to = order_at(&r, &bend, r.finest);
  if (!(line.left - bend.left > sure * sure * bend.left / dof))
    return t;
  if (!(fabs(from - to) > SEEN)) { /* no more than a wider interval */
    t.half_width = fmax(t.half_width, fabs((bend.shape->kind == TREND_SETTLING ? bend.slope : to) - t.slope));
    return t;
  }
  t.kind = bend.shape->kind;
  t.coarsest_order = from;
  t.finest_order = to;
  t.limit = bend.slope;
  t.limit_half_width = fmax(fmax(half_width(&bend, dof), bend.others), fabs(to - bend.slope));
  return t;
}
