#include "model/measured/spline_fit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/golden.h"

/* A spline on one or two arcs of uniform segments. One circle has its own B-spline coefficients; of two arcs that meet
 * at l' = 0, some follow from the others and from the two values at the ends. */
struct arc {
  double begin, width; /* width of a segment */
  int segments, first; /* count of segments, index of the first unknown */
};
struct basis {
  struct arc arcs[2];
  int count, unknowns; /* of arcs, of unknowns; with two arcs the values at their ends are the first unknowns */
  double period;
};
struct part { /* a coefficient as a sum over unknowns */
  int index[2];
  double weight[2];
};

static struct part part_of(const struct basis *b, int arc, int i)
{
  const struct arc *a = &b->arcs[arc];
  if (b->count == 1)
    return (struct part){ { (i + a->segments) % a->segments, 0 }, { 1, 0 } };
  int end = a->segments; /* coefficients -1, ..., end + 1; the arc's own are 1 to end - 1 */
  if (i <= 0 || i >= end) {
    bool late = i >= end;
    int own = a->first + (late ? end - 2 : 0), value = late ? 1 - arc : arc;
    if (i < 0 || i > end)
      return (struct part){ { own, 0 }, { 1, 0 } };
    return (struct part){ { value, own }, { 1.5, -0.5 } };
  }
  return (struct part){ { a->first + i - 1, 0 }, { 1, 0 } };
}

struct system {
  const struct samples *samples;
  struct basis basis;
  double *normal, *penalty, *factor, *right, *x; /* n x n, n x n, n x n, n, n */
};

static double coefficient(const struct system *y, int arc, int i)
{
  struct part p = part_of(&y->basis, arc, i);
  return p.weight[0] * y->x[p.index[0]] + p.weight[1] * y->x[p.index[1]];
}

/* Adds the square of a row of four coefficients to a matrix, and its product with l to the right side. */
static void add_row(double *matrix, double *right, const struct basis *b, int arc, int first, const double w[4],
                    double l)
{
  int n = b->unknowns, index[8];
  double weight[8];
  for (int i = 0; i < 4; i++) {
    struct part p = part_of(b, arc, first + i);
    for (int j = 0; j < 2; j++) {
      index[2 * i + j] = p.index[j];
      weight[2 * i + j] = w[i] * p.weight[j];
    }
  }
  for (int i = 0; i < 8; i++) {
    for (int j = 0; j < 8; j++)
      matrix[index[i] * n + index[j]] += weight[i] * weight[j];
    if (right)
      right[index[i]] += weight[i] * l;
  }
}

static void set_weights(double w[4], double f)
{
  double g = 1 - f;
  w[0] = g * g * g / 6;
  w[1] = ((3 * f - 6) * f * f + 4) / 6;
  w[2] = ((3 * g - 6) * g * g + 4) / 6;
  w[3] = f * f * f / 6;
}

/* Returns the arc of t, and writes its segment and the elapsed fraction of the segment. */
static int place_of(const struct basis *b, double t, int *segment, double *part)
{
  int arc = 0;
  double u = t - b->arcs[0].begin;
  u -= b->period * floor(u / b->period);
  if (b->count == 2 && u >= b->arcs[0].width * b->arcs[0].segments) {
    arc = 1;
    u -= b->arcs[0].width * b->arcs[0].segments;
  }
  const struct arc *a = &b->arcs[arc];
  *segment = (int)fmin(fmax(floor(u / a->width), 0), a->segments - 1);
  *part = u / a->width - *segment;
  return arc;
}

static void set_normal(struct system *y)
{
  const struct samples *s = y->samples;
  const struct basis *b = &y->basis;
  size_t n = (size_t)b->unknowns;
  memset(y->normal, 0, n * n * sizeof *y->normal);
  memset(y->penalty, 0, n * n * sizeof *y->penalty);
  memset(y->right, 0, n * sizeof *y->right);
  for (int i = 0; i < s->count; i++) {
    int segment;
    double f, w[4];
    int arc = place_of(b, s->at[i].t, &segment, &f);
    set_weights(w, f);
    add_row(y->normal, y->right, b, arc, segment - 1, w, s->at[i].l);
  }
  for (int arc = 0; arc < b->count; arc++) {
    const struct arc *a = &b->arcs[arc];
    double scale = pow(a->width / b->period * FIT_SEGMENTS, -2.5); /* of an integral of l'''^2 */
    const double third[4] = { -scale, 3 * scale, -3 * scale, scale };
    for (int i = 0; i < a->segments; i++)
      add_row(y->penalty, NULL, b, arc, i - 1, third, 0);
  }
}

/* Factors normal + stiffness penalty = factor factor^T. Returns false if it is not positive definite. */
static bool factor_system(struct system *y, double stiffness)
{
  int n = y->basis.unknowns;
  double *c = y->factor;
  for (int i = 0; i < n; i++)
    for (int j = 0; j <= i; j++) {
      double sum = y->normal[i * n + j] + stiffness * y->penalty[i * n + j];
      for (int k = 0; k < j; k++)
        sum -= c[i * n + k] * c[j * n + k];
      if (i == j && !(sum > 0))
        return false; /* GCOVR_EXCL_LINE: only by rounding */
      c[i * n + j] = i == j ? sqrt(sum) : sum / c[j * n + j];
    }
  return true;
}

static void solve_factored(const struct system *y, const double *right, double *x)
{
  int n = y->basis.unknowns;
  const double *c = y->factor;
  for (int i = 0; i < n; i++) {
    double sum = right[i];
    for (int k = 0; k < i; k++)
      sum -= c[i * n + k] * x[k];
    x[i] = sum / c[i * n + i];
  }
  for (int i = n - 1; i >= 0; i--) {
    for (int k = i + 1; k < n; k++)
      x[i] -= c[k * n + i] * x[k];
    x[i] /= c[i * n + i];
  }
}

/* Returns the sum of the squares of the residuals. */
static double residual(const struct system *y)
{
  const struct basis *b = &y->basis;
  double squares = 0;
  for (int i = 0; i < y->samples->count; i++) {
    int segment;
    double f, w[4], left = y->samples->at[i].l;
    int arc = place_of(b, y->samples->at[i].t, &segment, &f);
    set_weights(w, f);
    for (int j = 0; j < 4; j++)
      left -= w[j] * coefficient(y, arc, segment - 1 + j);
    squares += left * left;
  }
  return squares;
}

/* Returns the effective degrees of freedom: the trace of the map from the samples to the curve's values at them. */
static double freedom(const struct system *y)
{
  int n = y->basis.unknowns;
  double trace = 0, x[2 * FIT_SEGMENTS + 8];
  for (int i = 0; i < n; i++) {
    solve_factored(y, y->normal + i * n, x);
    trace += x[i];
  }
  return trace;
}

static bool solve_at(struct system *y, double stiffness)
{
  bool solved = factor_system(y, stiffness);
  if (solved)
    solve_factored(y, y->right, y->x);
  return solved;
}

/* Returns the estimated error at a sample that is left out. */
static double score_of(void *system, double power)
{
  struct system *y = system;
  bool solved = solve_at(y, pow(10, power));
  double count = y->samples->count, left = solved ? count - freedom(y) : 0;
  return left > 0 ? sqrt(count * residual(y)) / left : INFINITY;
}

/* Chooses the stiffness by generalized cross-validation. Its score can have more than one valley. */
static double choose_by_validation(struct system *y)
{
  enum { FROM = -12, TO = 6 };
  double best = FROM, lowest = INFINITY;
  for (int power = FROM; power <= TO; power++) {
    double score = score_of(y, power);
    if (score < lowest) {
      lowest = score;
      best = power;
    }
  }
  return pow(10, golden_least(score_of, y, best - 1, best + 1, 0.05));
}

/* Chooses the stiffness that gives the residuals the root mean square sigma; they increase with it. */
static double choose_by_noise(struct system *y, double sigma)
{
  double from = -12, to = 8;
  for (int i = 0; i < 24; i++) {
    double middle = (from + to) / 2;
    bool below = solve_at(y, pow(10, middle)) && residual(y) < sigma * sigma * y->samples->count;
    *(below ? &from : &to) = middle;
  }
  return pow(10, to);
}

static void choose_stiffness(struct system *y, struct fit *fit)
{
  fit->stiffness = fit->sigma > 0 ? choose_by_noise(y, fit->sigma) : choose_by_validation(y);
  fit->score = score_of(y, log10(fit->stiffness));
}

static int within(int low, int x, int high) { return x < low ? low : x > high ? high : x; }

/* Sets 7 segments for 10 samples: the score is then an estimate of the error for exact samples, too. */
static void set_basis(struct system *y, const struct fit *fit)
{
  const struct samples *s = y->samples;
  struct basis *b = &y->basis;
  b->period = s->period;
  b->count = fit->kind == SCALLOP_FIT_PHASES ? 2 : 1;
  double begin = b->count == 2 ? fit->turns[0] : 0, end = b->count == 2 ? fit->turns[1] : 0;
  double length = b->count == 2 ? end - begin - s->period * floor((end - begin) / s->period) : s->period;
  b->unknowns = b->count == 2 ? 2 : 0;
  for (int i = 0; i < b->count; i++) {
    double rows = 0.7 * s->count * length / s->period;
    int segments = within(b->count == 2 ? 4 : 8, (int)rows, FIT_SEGMENTS / b->count);
    b->arcs[i] = (struct arc){ begin, length / segments, segments, b->unknowns };
    b->unknowns += b->count == 2 ? segments - 1 : segments;
    begin += length;
    length = s->period - length;
  }
  set_normal(y);
}

static int knots_of(const struct system *y, struct scallop_knot *k)
{
  int count = 0;
  for (int arc = 0; arc < y->basis.count; arc++) {
    const struct arc *a = &y->basis.arcs[arc];
    for (int i = 0; i < a->segments; i++) {
      double before = coefficient(y, arc, i - 1), at = coefficient(y, arc, i), after = coefficient(y, arc, i + 1);
      k[count++] = (struct scallop_knot){ .time = a->begin + i * a->width,
                                          .length = (before + 4 * at + after) / 6,
                                          .slope = (after - before) / (2 * a->width) };
    }
  }
  return count;
}

struct turn_search {
  struct system *system;
  struct fit *fit;
  int which;
};

/* Returns the least-squares cost with one turn at t. */
static double cost_with_turn(void *context, double t)
{
  struct turn_search *s = context;
  struct system *y = s->system;
  s->fit->turns[s->which] = t;
  set_basis(y, s->fit);
  if (!solve_at(y, s->fit->stiffness))
    return INFINITY; /* GCOVR_EXCL_LINE: only by rounding */
  int n = y->basis.unknowns;
  double cost = residual(y);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++)
      cost += s->fit->stiffness * y->x[i] * y->penalty[i * n + j] * y->x[j];
  return cost;
}

/* Moves both turns by at most a step: l'' may jump there, therefore the cost depends on their position. */
static void move_turns(struct system *y, struct fit *fit, double step)
{
  for (int which = 0; which < 2; which++) {
    struct turn_search search = { y, fit, which };
    double t = fit->turns[which];
    fit->turns[which] = golden_least(cost_with_turn, &search, t - step, t + step, 1e-3 * step);
  }
}

static void turns_of(const struct scallop_knot *k, int count, double turns[2])
{
  int least = 0, most = 0;
  for (int i = 1; i < count; i++) {
    least = k[i].length < k[least].length ? i : least;
    most = k[i].length > k[most].length ? i : most;
  }
  turns[0] = k[least].time;
  turns[1] = k[most].time;
}

/* Chooses the turns, starting from the turns of the smooth curve. */
static void choose_turns(struct system *y, struct fit *fit, struct scallop_knot *knots)
{
  struct fit smooth = { .kind = SCALLOP_FIT_SMOOTH, .sigma = fit->sigma };
  double segment = y->samples->period / within(8, y->samples->count, FIT_SEGMENTS);
  set_basis(y, &smooth);
  choose_stiffness(y, &smooth);
  solve_at(y, smooth.stiffness);
  turns_of(knots, knots_of(y, knots), fit->turns);
  for (double step = 1.5; step > 0.2; step /= 4) {
    set_basis(y, fit);
    choose_stiffness(y, fit);
    move_turns(y, fit, step * segment);
  }
}

static bool begin_system(struct system *y, const struct samples *s)
{
  const size_t n = 2 * FIT_SEGMENTS + 8;
  *y = (struct system){ .samples = s, .normal = malloc((3 * n * n + 2 * n) * sizeof(double)) };
  if (!y->normal)
    return false; /* GCOVR_EXCL_LINE: no memory */
  y->penalty = y->normal + n * n;
  y->factor = y->penalty + n * n;
  y->right = y->factor + n * n;
  y->x = y->right + n;
  return true;
}

int spline_fit(struct scallop_knot *knots, struct fit *fit, const struct samples *s)
{
  struct system y;
  if (!begin_system(&y, s))
    return 0; /* GCOVR_EXCL_LINE: no memory */
  bool known = fit->stiffness > 0;
  if (fit->moves && fit->kind == SCALLOP_FIT_PHASES)
    move_turns(&y, fit, 0.5 * s->period / within(8, s->count, FIT_SEGMENTS));
  else if (fit->kind == SCALLOP_FIT_PHASES && !known)
    choose_turns(&y, fit, knots);
  set_basis(&y, fit);
  if (!known)
    choose_stiffness(&y, fit);
  int count = solve_at(&y, fit->stiffness) ? knots_of(&y, knots) : 0;
  if (!known && count > 0)
    fit->noise = sqrt(residual(&y) / fmax(s->count - freedom(&y), 1));
  free(y.normal);
  return count;
}
