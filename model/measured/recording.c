#include "model/measured/recording.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "model/golden.h"

enum { LEAST_ROWS = 4, LAGS = 600 }; /* count of lags that are tried as the period */
static const double closes = 1e-9;   /* largest relative difference of equal times, or of equal lengths */

struct rows {
  struct sample *at;
  int count;
  double low, high; /* range of l */
};

/* Sorts by t, and replaces samples at the same time by their mean. */
static void tidy(struct sample *at, int *count, double least_step)
{
  int used = 0;
  qsort(at, (size_t)*count, sizeof *at, by_time);
  for (int i = 0; i < *count;) {
    double sum = 0;
    int same = 0;
    for (; i + same < *count && at[i + same].t <= at[i].t + least_step; same++)
      sum += at[i + same].l;
    at[used++] = (struct sample){ at[i].t, sum / same };
    i += same;
  }
  *count = used;
}

static double linear_at(const struct rows *r, double t)
{
  int low = 0, high = r->count - 1;
  while (high - low > 1) {
    int middle = (low + high) / 2;
    *(r->at[middle].t <= t ? &low : &high) = middle;
  }
  const struct sample *a = &r->at[low], *b = &r->at[high];
  return a->l + (b->l - a->l) * (t - a->t) / (b->t - a->t);
}

/* Returns the mean square of l(t) - l(t - lag), over the variance of l, from at most about 2000 rows; infinite if no
 * more than a fifth of them have a t - lag. */
static double dissimilarity(const struct rows *r, double lag)
{
  enum { MOST = 2000 };
  const int step = 1 + r->count / MOST;
  double squares = 0, sum = 0, sum_of_squares = 0;
  int count = 0, all = 0;
  for (int i = 0; i < r->count; i += step, all++) {
    double l = (r->at[i].l - r->low) / (r->high - r->low);
    sum += l;
    sum_of_squares += l * l;
    if (r->at[i].t - lag < r->at[0].t)
      continue;
    double change = (r->at[i].l - linear_at(r, r->at[i].t - lag)) / (r->high - r->low);
    squares += change * change;
    count++;
  }
  return count * 5 > all ? squares / count / (sum_of_squares / all - (sum / all) * (sum / all)) : INFINITY;
}

/* Returns the shortest lag after which the recording repeats: the first low valley of dissimilarity(); else 0. */
static double repeats_after(const struct rows *r)
{
  const double like = 0.06;
  double span = r->at[r->count - 1].t - r->at[0].t, step = span / LAGS, lags[3] = { 0 }, values[3] = { 0 };
  bool rose = false;
  for (int i = 1; i < LAGS; i++) {
    lags[2] = i * step;
    values[2] = dissimilarity(r, lags[2]);
    rose = rose || values[2] > 0.5;
    if (rose && values[1] < like && values[1] <= values[0] && values[1] <= values[2])
      return lags[1];
    for (int j = 0; j < 2; j++) {
      lags[j] = lags[j + 1];
      values[j] = values[j + 1];
    }
  }
  return 0;
}

/* Returns the samples in units of the period, and of the range of l. */
static struct samples folded(const struct rows *r, double period)
{
  struct samples s = { .at = malloc((size_t)r->count * sizeof *s.at), .count = r->count, .period = 1 };
  for (int i = 0; s.at && i < r->count; i++)
    s.at[i] = (struct sample){ fmod(r->at[i].t - r->at[0].t, period) / period,
                               (r->at[i].l - r->low) / (r->high - r->low) };
  if (s.at)
    tidy(s.at, &s.count, closes);
  return s;
}

struct period_search {
  const struct rows *recorded;
  struct fit fit;
};

/* Returns the residual of a smooth curve through the recording, folded with this period. */
static double residual_of_period(void *folding, double period)
{
  struct period_search *f = folding;
  struct samples s = folded(f->recorded, period);
  struct curve curve = { .knots = NULL };
  double left = s.at && curve_through(&curve, &f->fit, &s) ? curve_residual(&curve, &s) : INFINITY;
  free(curve.knots);
  free(s.at);
  return left;
}

/* Returns the period near a first guess that fits the recording best. */
static double refined(const struct rows *r, double period)
{
  struct period_search folding = { r, { .kind = SCALLOP_FIT_SMOOTH } };
  double step = (r->at[r->count - 1].t - r->at[0].t) / LAGS;
  residual_of_period(&folding, period); /* chooses the smoothness */
  return golden_least(residual_of_period, &folding, period - step, period + step, 1e-5 * step);
}

/* Computes the length of a single period. Its last row repeats the first, and is removed, or (*gap) is one step before.
 * Returns false if a step would not bring l back. */
static bool close_gap(struct rows *r, double *period, bool *gap)
{
  struct sample first = r->at[0], last = r->at[r->count - 1];
  double span = last.t - first.t, steepest = 0, step = span / (r->count - 1);
  *gap = !(fabs(last.l - first.l) <= closes * (r->high - r->low));
  *period = *gap ? span + step : span;
  for (int i = 1; i < r->count; i++)
    steepest = fmax(steepest, fabs((r->at[i].l - r->at[i - 1].l) / (r->at[i].t - r->at[i - 1].t)));
  r->count -= !*gap;
  return !*gap || fabs(first.l - last.l) / step <= 1.5 * steepest;
}

/* Returns NULL, or the reason of the failure. */
static const char *check(struct rows *r)
{
  if (r->count < LEAST_ROWS)
    return "fewer than four rows with numbers at different times: through so few every curve would be the same";
  r->low = r->high = r->at[0].l;
  for (int i = 1; i < r->count; i++) {
    r->low = fmin(r->low, r->at[i].l);
    r->high = fmax(r->high, r->at[i].l);
  }
  if (!isfinite(r->high - r->low) || !isfinite(r->at[r->count - 1].t - r->at[0].t))
    return "the range of t and that of l must not overflow";
  return r->high > r->low ? NULL : "l is the same throughout: there is no gait in that";
}

static void describe(struct recording *g, int rows, double span, bool gap)
{
  int used = snprintf(g->understood, sizeof g->understood, "%d rows", rows);
  char *end = g->understood + used;
  size_t left = sizeof g->understood - (size_t)used;
  if (g->folded)
    snprintf(end, left, ", %.4g periods of %.10g, folded into one", span / g->period, g->period);
  else if (gap)
    snprintf(end, left, ", closed over a gap of one step after the last, period %.10g", g->period);
  else
    snprintf(end, left, ", one period of %.10g", g->period);
}

static const char *find_period(struct recording *g, struct rows *r, double period)
{
  bool gap = false;
  int rows = r->count;
  double span = r->at[rows - 1].t - r->at[0].t, repeats = period > 0 || rows < FIT_LEAST ? 0 : repeats_after(r);
  if (repeats > 0)
    period = refined(r, repeats);
  if (!(period > 0) && !close_gap(r, &period, &gap))
    return "not periodic: l at the end is further from l at the start than a step between rows can bring it";
  g->start = r->at[0].t;
  g->low = r->low;
  g->range = r->high - r->low;
  g->period = period;
  g->folded = span > period * (1 + closes);
  g->samples = folded(r, period);
  describe(g, rows, span, gap);
  return g->samples.at ? NULL : "out of memory";
}

const char *recording_of(struct recording *g, const double *t, const double *l, int count, double period)
{
  struct rows r = { .at = malloc(((size_t)count + 1) * sizeof *r.at), .count = count };
  *g = (struct recording){ .folded = false };
  if (!r.at)
    return "out of memory"; /* GCOVR_EXCL_LINE */
  for (int i = 0; i < count; i++)
    r.at[i] = (struct sample){ t[i], l[i] };
  tidy(r.at, &r.count, 0);
  const char *wrong = check(&r);
  wrong = wrong ? wrong : find_period(g, &r, period);
  free(r.at);
  return wrong;
}
