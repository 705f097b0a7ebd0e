#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

#include "asymptotics/observed/judged.h"

/* Changes of the local order over the run below this are ignored. */
static const double SEEN = 0.005;
/* Factors between sums of squares. A term that vanishes as h -> 0 is as good as another if its sum is at most AS_GOOD
 * times as large; any other term must be BETTER times better than those. */
static const double AS_GOOD = 4, BETTER[] = { 0, 0, 8, 25 }; /* by enum trend_kind */
static const double SURE = 0.995;
/* Ratio of the sum of squares of a bend to a line without the finest point, above which the bend is ignored */
static const double FINEST = 4;
/* Ratio of a noise floor to an error at which the weight of the error is one half */
static const double WEIGHED = 0.03;
/* Limits of printed tables: the bound of the effect of rounding takes the square of their length. */
enum { MOST_PRINTED = 64, MOST_DIGITS = 6, MOST_STEPS = 30 };
/* In h^p |log h|^r a smaller |r| counts as a coincidence. */
static const double LEAST_SECOND = 0.4, LOG_09 = -0.105;
/* Largest ratio of two terms with opposite signs */
static const double CANCELLED = 0.9975;
/* For log(1 + c): the step of the grid, the smallest step, and the end of the grid if h spans hundreds of decades */
static const double STEP = 1.5, SMALL_STEP = 1e-12, MOST_GROWTH = 60;

/* A bend of the line. Two terms: log(1 + c u), u = (h/h0)^power, h0 the coarsest h for power > 0, else the finest.
 * Creeping (power 0 or nan): a multiple of x^2 for 0, of log|log h| for nan. */
struct shape {
  enum trend_kind kind;
  double power;
};
/* Among equally good terms that vanish as h -> 0 the first is taken. */
static const struct shape shapes[] = {
  { TREND_SETTLING, 1 }, { TREND_SETTLING, 2 }, { TREND_SETTLING, 3 },   { TREND_SETTLING, 4 }, { TREND_SETTLING, 0.5 },
  { TREND_LEAVING, -1 }, { TREND_LEAVING, -2 }, { TREND_LEAVING, -0.5 }, { TREND_CREEPING, 0 }, { TREND_CREEPING, NAN },
};
enum { SHAPES = sizeof shapes / sizeof *shapes };

/* Logarithms of h and |err|, the weight, and bounds of the effect of rounding and known noise on y. In long tables,
 * means of equally many points. */
struct entry {
  double x, y, weight, moved;
};
enum { MOST_ENTRIES = 512 };

struct row_range {
  const struct entry *entry; /* from the coarsest h on */
  int count;
  double weight, x, y, xx, xy; /* their sum, means, and sums of products of x and y without the means */
  double coarsest, finest;     /* values of x */
};

static double x_of(const struct row_range *r, int i) { return r->entry[i].x - r->x; }
static double y_of(const struct row_range *r, int i) { return r->entry[i].y - r->y; }

static struct row_range run_of(const struct entry *entry, int count)
{
  struct row_range r = { entry, count, 0, 0, 0, 0, 0, entry[0].x, entry[count - 1].x };
  for (int i = 0; i < count; i++) {
    r.weight += entry[i].weight;
    r.x += entry[i].weight * entry[i].x;
    r.y += entry[i].weight * entry[i].y;
  }
  r.x /= r.weight;
  r.y /= r.weight;
  for (int i = 0; i < count; i++) {
    r.xx += entry[i].weight * x_of(&r, i) * x_of(&r, i);
    r.xy += entry[i].weight * x_of(&r, i) * y_of(&r, i);
  }
  return r;
}

/* A line with a bend: err = e^a h^slope (1 + c u), or e^a h^slope e^(factor term) if it creeps. */
struct bend {
  const struct shape *shape; /* NULL: the line alone                                      */
  double c;
  double slope, factor; /* of the line, of the term */
  double left;          /* sum of squares of the residuals */
  double variance;      /* of the slope, in units of the variance of a point */
  double others;        /* largest distance from slopes of equally good bends */
};

static bool creeps(const struct bend *b) { return b->shape && b->shape->kind == TREND_CREEPING; }

/* The bend at one h: the known part, the term multiplied by the factor of the fit, and the contribution of each to the
 * local order. For two terms log(1 + c u), and its derivative with respect to log(1 + c). */
struct bend_terms {
  double known, term, known_order, term_order;
};

static struct bend_terms bend_terms_at(const struct row_range *r, const struct bend *b, double x)
{
  struct bend_terms at = { 0, 0, 0, 0 };
  if (!b->shape)
    return at;
  double power = b->shape->power, above = x - r->finest;
  if (creeps(b)) {
    at.term = isnan(power) ? log(fabs(x)) : above * above;
    at.term_order = isnan(power) ? 1 / x : 2 * above;
    return at;
  }
  double u = exp(power * (power > 0 ? x - r->coarsest : above)), cu = b->c * u;
  at.known = log1p(cu);
  at.term = (1 + b->c) * u / (1 + cu);
  at.known_order = power * cu / (1 + cu);
  return at;
}

/* Returns the local order at log h = x. */
static double order_at(const struct row_range *r, const struct bend *b, double x)
{
  struct bend_terms at = bend_terms_at(r, b, x);
  return b->slope + at.known_order + b->factor * at.term_order;
}

/* Fits y minus the known part by least squares, over x and the term. */
static void fit(const struct row_range *r, struct bend *b)
{
  struct bend_terms at[MOST_ENTRIES] = { { 0, 0, 0, 0 } };
  double known = 0, term = 0, yx = r->xy, tx = 0, tt = 0, ty = 0;
  for (int i = 0; i < r->count; i++) {
    double w = r->entry[i].weight;
    at[i] = bend_terms_at(r, b, r->entry[i].x);
    known += w * at[i].known / r->weight;
    term += w * at[i].term / r->weight;
    yx -= w * at[i].known * x_of(r, i);
    tx += w * at[i].term * x_of(r, i);
    tt += w * at[i].term * at[i].term;
    ty += w * at[i].term * (y_of(r, i) - at[i].known);
  }
  tt -= r->weight * term * term + tx / r->xx * tx;
  ty += r->weight * term * known - tx / r->xx * yx;
  bool bends = tt > 0;
  b->factor = bends ? ty / tt : 0;
  b->slope = (yx - (creeps(b) ? b->factor * tx : 0)) / r->xx;
  b->variance = 1 / r->xx + (bends ? tx / r->xx * tx / r->xx / tt : 0);
  b->left = 0;
  for (int i = 0; i < r->count; i++) {
    double rest = y_of(r, i) - (at[i].known - known) - b->slope * x_of(r, i)
                  - (creeps(b) ? b->factor * (at[i].term - term) : 0);
    b->left += r->entry[i].weight * rest * rest;
  }
}

static struct bend bend_at(const struct row_range *r, const struct shape *shape, double t)
{
  struct bend b = { shape, expm1(t), 0, 0, 0, 0, 0 };
  fit(r, &b);
  return b;
}

/* Refines c of the best bend, with low <= log(1 + c) <= high: Newton's method on the linearized residuals, with shorter
 * steps if it fails. */
static struct bend refine(const struct row_range *r, struct bend best, double low, double high)
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

/* Returns the bend with the best c, between an almost complete cancellation by the second term and equal size of both
 * terms at the finest h; starts from the best of a grid, or from 0. */
static struct bend best_of(const struct row_range *r, const struct shape *shape)
{
  struct bend none = bend_at(r, shape, 0);
  if (shape->kind == TREND_CREEPING)
    return none;
  double low = log1p(-CANCELLED);
  double high = fmin(log1p(shape->power > 0 ? exp((r->coarsest - r->finest) * shape->power) : 1), MOST_GROWTH);
  struct bend best = none;
  for (double t = low; t < high + STEP; t += STEP) {
    struct bend b = bend_at(r, shape, fmin(t, high));
    best = b.left < best.left ? b : best;
  }
  best = refine(r, best, low, high);
  none = refine(r, none, low, high);
  return none.left <= best.left ? none : best;
}

static double half_width(const struct bend *b, int dof)
{
  return student_quantile(0.95, dof) * sqrt(b->left / dof * b->variance);
}

/* Returns the first term that vanishes as h -> 0 and is about as good as the best of these, unless another is much
 * better. Four points leave one degree of freedom, with which dominating terms fit by chance. */
static struct bend best_bend(const struct row_range *r, struct trend *t)
{
  struct bend bends[SHAPES], other;
  double least = INFINITY, least_other = INFINITY;
  for (int i = 0; i < SHAPES; i++) {
    if (isnan(shapes[i].power) && !(r->coarsest < LOG_09)) /* log h = 0 at h = 1 */
      continue;
    bends[i] = best_of(r, &shapes[i]);
    if (isnan(shapes[i].power) && fabs(bends[i].factor) < LEAST_SECOND)
      continue;
    if (shapes[i].power >= 1) {
      double half = half_width(&bends[i], r->count - 3);
      t->low = fmin(t->low, bends[i].slope - half);
      t->high = fmax(t->high, bends[i].slope + half);
    }
    if (shapes[i].kind == TREND_SETTLING)
      least = fmin(least, bends[i].left);
    else if (BETTER[shapes[i].kind] * bends[i].left < least_other
             && (r->count > 4 || shapes[i].kind == TREND_CREEPING)) {
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

/* Returns true if rounding and noise of at most e_k explain the residuals: if the errors are C h^p up to these, in
 * logarithms, the residuals of least squares are at most the sum over k of |1_ik - H_ik| e_k, H_ik = 1/n + x_i x_k/sum
 * x^2. */
static bool explained_by_rounding(const struct row_range *r, const struct bend *line)
{
  bool explained = r->count > 0 && r->entry[0].moved > 0;
  for (int i = 0; i < r->count && explained; i++) {
    double most = 0;
    for (int k = 0; k < r->count; k++)
      most += r->entry[k].moved
              * fabs((i == k) - r->entry[k].weight * (1 / r->weight + x_of(r, i) * x_of(r, k) / r->xx));
    explained = fabs(y_of(r, i) - line->slope * x_of(r, i)) <= most;
  }
  return explained;
}

/* Returns true if a line through all but the finest point is better than the bend by a factor FINEST. */
static bool finest_is_off(const struct row_range *r, const struct bend *bend)
{
  struct row_range without = run_of(r->entry, r->count - 1);
  return bend_at(&without, NULL, 0).left * FINEST < bend->left;
}

/* Returns the digits of the shortest decimal that reads back as x, or more than MOST_DIGITS. */
static int digits_of(double x)
{
  char text[40];
  for (int digits = 1; digits <= MOST_DIGITS; digits++) {
    snprintf(text, sizeof text, "%.*e", digits - 1, x);
    if (strtod(text, NULL) == x)
      return digits;
  }
  return MOST_DIGITS + 1;
}

static double last_place(double x, int digits) { return pow(10, floor(log10(fabs(x))) - digits + 1); }

/* Sets bounds of the effect of rounding and known noise on the logarithms of printed errors. Errors were rounded to the
 * digits of the longest or to the most decimals found, whichever is coarser; doubles were not rounded. */
static void note_rounding(struct entry *entry, const struct scallop_order_point *points, int count, double level)
{
  int digits = 0;
  double unit = INFINITY;
  for (int i = 0; i < count; i++) {
    int here = digits_of(points[i].err);
    digits = here > digits ? here : digits;
    unit = fmin(unit, last_place(points[i].err, here));
  }
  for (int i = 0; i < count; i++) {
    double err = fabs(points[i].err), place = digits > MOST_DIGITS ? 0 : fmax(last_place(err, digits), unit);
    entry[i].moved = place / 2 / err + (points[i].noise + level) / err;
  }
}

/* Returns a run with lower weights for errors near noise of this level. */
static struct row_range run_of_points(struct entry entry[MOST_ENTRIES], const struct scallop_order_point *points,
                                      int count, double level)
{
  const int together = (count + MOST_ENTRIES - 1) / MOST_ENTRIES;
  for (int i = 0; i < count; i++) {
    double err = fabs(points[i].err), noise = level / (err * WEIGHED), weight = 1 / (1 + noise * noise);
    struct entry *e = &entry[i / together];
    e->weight += weight;
    e->x += weight / e->weight * (log(points[i].h) - e->x);
    e->y += weight / e->weight * (log(err) - e->y);
  }
  if (count <= MOST_PRINTED)
    note_rounding(entry, points, count, level);
  return run_of(entry, (count + together - 1) / together);
}

struct trend trend_from(const struct judged *j, int first)
{
  struct entry entry[MOST_ENTRIES] = { { 0, 0, 0, 0 } };
  struct row_range r = run_of_points(entry, j->p + first, j->used - first, j->level);
  struct bend line = bend_at(&r, NULL, 0);
  const double p = line.slope, half = half_width(&line, r.count - 2);
  struct trend t = { TREND_STRAIGHT, false, false, j->used - first, p, half, p, p, p, half, p, p };
  t.rounded = explained_by_rounding(&r, &line);
  if (r.count < LEAST_TREND)
    return t;
  struct bend bend = best_bend(&r, &t);
  if (t.rounded)
    return t;
  const int dof = r.count - 3;
  double sure = student_quantile(SURE, dof);
  double from = order_at(&r, &bend, r.coarsest), to = order_at(&r, &bend, r.finest);
  if (!(line.left - bend.left > sure * sure * bend.left / dof))
    return t;
  if (!(fabs(from - to) > SEEN)) { /* a wider interval suffices if scatter is not the only cause */
    t.low = -INFINITY;
    t.half_width = fmax(t.half_width, fabs((bend.shape->kind == TREND_SETTLING ? bend.slope : to) - t.slope));
    return t;
  }
  t.finest_is_off = bend.shape->kind != TREND_SETTLING && finest_is_off(&r, &bend);
  if (t.finest_is_off)
    return t;
  t.kind = bend.shape->kind;
  t.coarsest_order = from;
  t.finest_order = to;
  t.limit = bend.slope;
  t.limit_half_width = fmax(fmax(half_width(&bend, dof), bend.others), fabs(to - bend.slope));
  return t;
}
