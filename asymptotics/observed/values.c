/* Errors from values: three refinements yield one order. */
#include <float.h>
#include <math.h>

#include "asymptotics/observed/judged.h"

/* Returns (h1^p - h2^p)/(h2^p - h3^p) with h1 > h2 > h3: increases with p, and is log(h1/h2)/log(h2/h3) at p = 0. */
static double difference_ratio(double p, double h1, double h2, double h3)
{
  double a = log(h1 / h2), b = log(h2 / h3);
  return p == 0 ? a / b : exp(p * a) * -expm1(-p * a) / -expm1(-p * b);
}

/* Returns the order from three values, or nan. */
static double order_of_three(const struct scallop_order_point *p)
{
  double ratio = (p[0].err - p[1].err) / (p[1].err - p[2].err);
  double low = -50, high = 50;
  if (!(ratio > 0) || !isfinite(ratio))
    return NAN;
  for (double mid = 0; low < mid && mid < high; mid = low + (high - low) / 2) /* the ratio is monotone in p */
    *(difference_ratio(mid, p[0].h, p[1].h, p[2].h) < ratio ? &low : &high) = mid;
  return low;
}

/* Sets the noise to the rounding of a double. If values repeat, the noise is at least half the resolution of the
 * values, which is their smallest difference other than 0. */
static void note_noise(struct scallop_order_point *values, int count)
{
  double least = INFINITY;
  bool repeated = false;
  for (int i = 0; i + 1 < count; i++) {
    double difference = fabs(values[i].err - values[i + 1].err);
    repeated |= difference == 0;
    least = difference > 0 ? fmin(least, difference) : least;
  }
  double resolved = repeated && isfinite(least) ? least : 0;
  for (int i = 0; i < count; i++)
    values[i].noise = fmax(DBL_EPSILON / 2 * fabs(values[i].err), resolved / 2);
}

static bool is_above_noise(const struct scallop_order_point *values)
{
  return fabs(values[0].err - values[1].err) > POINTS_ABOVE_NOISE * (values[0].noise + values[1].noise);
}

/* Returns the median of the orders of three values each, or 1. */
static double middle_order(const struct scallop_order_point *values, int count)
{
  double orders[MOST_SORTED];
  int n = 0;
  for (int i = 0; i + 2 < count && n < MOST_SORTED; i++) {
    double here = is_above_noise(&values[i]) && is_above_noise(&values[i + 1]) ? order_of_three(&values[i]) : NAN;
    if (isfinite(here) && fabs(here) < 49)
      orders[n++] = here;
  }
  return n == 0 ? 1 : points_ranked(orders, n, n / 2);
}

/* Returns the grid convergence index between two values, the second on the finer grid. */
static double grid_index(const struct scallop_order_point *v, double p)
{
  static const double safety = 1.25;
  return safety * fabs(v[0].err - v[1].err) / (fabs(v[1].err) * expm1(p * log(v[0].h / v[1].h)));
}

static void set_grid_convergence(const struct judged *j)
{
  const struct scallop_order_point *v = j->p + j->count - 3; /* coarse, medium, fine */
  double p = order_of_three(v), q = isnan(j->wanted->order) ? p : j->wanted->order;
  if (!(p > 0))
    return;
  j->result->gci = grid_index(v + 1, p);
  j->result->asymptotic_ratio = grid_index(v, q) / (pow(v[1].h / v[2].h, q) * grid_index(v + 1, q));
}

void points_from_values(struct judged *j, bool announced)
{
  struct scallop_order_point *v = j->p;
  if (j->count < 3) {
    j->count = 0;
    return;
  }
  set_grid_convergence(j);
  if (!announced)
    note_noise(v, j->count);
  double p = middle_order(v, j->count);
  /* v_i - v_{i+1} = C (h_i^p - h_{i+1}^p): divided by 1 - (h_{i+1}/h_i)^p it is C h_i^p */
  for (int i = 0; i + 1 < j->count; i++) {
    double share = -expm1(-p * log(v[i].h / v[i + 1].h));
    v[i].err = (v[i].err - v[i + 1].err) / share;
    v[i].noise = (v[i].noise + v[i + 1].noise) / fabs(share);
  }
  j->count--;
}
