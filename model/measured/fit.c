#include "model/measured/fit.h"

#include <math.h>
#include <stdlib.h>

#include "model/measured/spline_fit.h"

/* Returns sample i of a circle, -count <= i < 2 count. */
static struct sample around(const struct samples *s, int i)
{
  int turn = i < 0 ? -1 : i >= s->count ? 1 : 0;
  struct sample x = s->at[i - turn * s->count];
  x.t += turn * s->period;
  return x;
}

static double sign(double x) { return x < 0 ? -1 : 1; }

/* Steffen's slopes (Astron. Astrophys. 239, 1990, p. 443) */
static void set_monotone_slopes(struct scallop_knot *k, const struct samples *s)
{
  for (int i = 0; i < s->count; i++) {
    struct sample a = around(s, i - 1), b = s->at[i], c = around(s, i + 1);
    double before = b.t - a.t, after = c.t - b.t;
    double from = (b.l - a.l) / before, to = (c.l - b.l) / after;
    double parabola = (from * after + to * before) / (before + after);
    k[i].slope = (sign(from) + sign(to)) * fmin(fabs(from), fmin(fabs(to), 0.5 * fabs(parabola)));
  }
}

/* Row i of a cyclic tridiagonal system, with a diagonal of 1 */
struct cyclic_row {
  double before, after, right, corner;
};

/* Solves for x, in right. The two corners are a change of rank one, with column `corner` (Sherman & Morrison). */
static void solve_cyclic(struct cyclic_row *row, int n)
{
  double low = row[0].before, high = row[n - 1].after, last = 1 + 2 * low * high;
  row[0] = (struct cyclic_row){ 0, row[0].after / 1.5, row[0].right / 1.5, -0.5 / 1.5 };
  row[n - 1] = (struct cyclic_row){ row[n - 1].before / last, 0, row[n - 1].right / last, high / last };
  for (int i = 1; i < n; i++) {
    double pivot = 1 - row[i].before * row[i - 1].after;
    row[i].after /= pivot;
    row[i].right = (row[i].right - row[i].before * row[i - 1].right) / pivot;
    row[i].corner = (row[i].corner - row[i].before * row[i - 1].corner) / pivot;
  }
  for (int i = n - 2; i >= 0; i--) {
    row[i].right -= row[i].after * row[i + 1].right;
    row[i].corner -= row[i].after * row[i + 1].corner;
  }
  double factor = (row[0].right - 2 * low * row[n - 1].right) / (1 + row[0].corner - 2 * low * row[n - 1].corner);
  for (int i = 0; i < n; i++)
    row[i].right -= factor * row[i].corner;
}

/* Sets the slopes that make l'' continuous on the whole circle. */
static bool set_cubic_slopes(struct scallop_knot *k, const struct samples *s)
{
  struct cyclic_row *row = s->count > 1 ? calloc((size_t)s->count, sizeof *row) : NULL;
  for (int i = 0; row && i < s->count; i++) {
    struct sample a = around(s, i - 1), b = s->at[i], c = around(s, i + 1);
    double before = b.t - a.t, after = c.t - b.t, both = 2 * (before + after);
    row[i] = (struct cyclic_row){ .before = after / both,
                                  .after = before / both,
                                  .right = 3 * (after * (b.l - a.l) / before + before * (c.l - b.l) / after) / both };
  }
  if (!row)
    return false; /* GCOVR_EXCL_LINE: no memory */
  solve_cyclic(row, s->count);
  for (int i = 0; i < s->count; i++)
    k[i].slope = row[i].right;
  free(row);
  return true;
}

static bool interpolate(struct curve *curve, enum scallop_fit kind, const struct samples *s)
{
  for (int i = 0; i < s->count; i++)
    curve->knots[i] = (struct scallop_knot){ .time = s->at[i].t, .length = s->at[i].l };
  curve->count = s->count;
  if (kind == SCALLOP_FIT_MONOTONE)
    set_monotone_slopes(curve->knots, s);
  return kind == SCALLOP_FIT_MONOTONE || set_cubic_slopes(curve->knots, s);
}

struct samples samples_every_other(const struct samples *all, int first)
{
  struct samples half = { .at = malloc((size_t)all->count * sizeof *half.at), .period = all->period };
  for (int i = first; half.at && i < all->count; i += 2)
    half.at[half.count++] = all->at[i];
  return half;
}

double curve_residual(const struct curve *curve, const struct samples *s)
{
  double squares = 0;
  for (int i = 0; i < s->count; i++) {
    double left = s->at[i].l - curve_at(curve, s->at[i].t);
    squares += left * left;
  }
  return sqrt(squares / s->count);
}

/* Returns the residual at every other sample of the cubic through the others; with noise it exceeds the noise. */
static double cubic_residual(const struct samples *s)
{
  struct samples half = samples_every_other(s, 0), others = samples_every_other(s, 1);
  struct fit fit = { .kind = SCALLOP_FIT_CUBIC };
  struct curve curve = { .knots = NULL };
  double left = half.at && others.at && curve_through(&curve, &fit, &half) ? curve_residual(&curve, &others) : INFINITY;
  free(curve.knots);
  free(half.at);
  free(others.at);
  return left;
}

/* Chooses the kind with the smallest estimated error at samples that are left out. */
static void choose_kind(struct curve *curve, struct fit *fit, const struct samples *s)
{
  struct fit smooth = *fit, phases = *fit;
  smooth.kind = SCALLOP_FIT_SMOOTH;
  phases.kind = SCALLOP_FIT_PHASES;
  fit->kind = SCALLOP_FIT_CUBIC;
  fit->score = cubic_residual(s);
  if (s->count < FIT_LEAST || spline_fit(curve->knots, &smooth, s) == 0 || spline_fit(curve->knots, &phases, s) == 0)
    return;
  const struct fit *better = phases.score < smooth.score ? &phases : &smooth;
  if (fit->sigma > 0 || fit->score > better->score)
    *fit = *better;
}

bool curve_through(struct curve *curve, struct fit *fit, const struct samples *s)
{
  size_t most = (size_t)(s->count > FIT_SEGMENTS ? s->count : FIT_SEGMENTS) + 8;
  *curve = (struct curve){ .knots = malloc(most * sizeof *curve->knots), .period = s->period };
  if (!curve->knots)
    return false; /* GCOVR_EXCL_LINE: no memory */
  if (fit->kind == SCALLOP_FIT_CHOSEN)
    choose_kind(curve, fit, s);
  if (fit->kind == SCALLOP_FIT_MONOTONE || fit->kind == SCALLOP_FIT_CUBIC)
    return interpolate(curve, fit->kind, s);
  curve->count = spline_fit(curve->knots, fit, s);
  return curve->count > 0;
}

double cubic_length(const struct scallop_knot *a, const struct scallop_knot *b, double duration, double x)
{
  double y = 1 - x;
  return y * y * (1 + 2 * x) * a->length + x * x * (1 + 2 * y) * b->length
         + duration * x * y * (y * a->slope - x * b->slope);
}

/* Returns l between two knots, or after the last one. */
double curve_at(const struct curve *c, double t)
{
  int low = 0, high = c->count;
  t = c->knots[0].time + fmod(t - c->knots[0].time, c->period);
  if (t < c->knots[0].time)
    t += c->period;
  while (high - low > 1) {
    int middle = (low + high) / 2;
    *(c->knots[middle].time <= t ? &low : &high) = middle;
  }
  const struct scallop_knot *a = &c->knots[low], *b = &c->knots[high % c->count];
  double duration = (high < c->count ? b->time : b->time + c->period) - a->time;
  return cubic_length(a, b, duration, (t - a->time) / duration);
}
