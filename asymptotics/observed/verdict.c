/* The rules of docs/reference/order.md, in their order. */
#include <math.h>
#include <stddef.h>

#include "asymptotics/observed/judged.h"

/* Smallest ratio of h in the tail of a table that has just settled: the finest three or more points */
static const double TAIL = 3.9;
/* Largest distance of the overall slope from the expected order, in tolerances, if the tail decides */
static const double ON_THE_WAY = 2.5;
/* Ratio of the intervals at which a shorter run replaces a longer one */
static const double FAR_BETTER = 10;
/* Largest half-width of a slope through three points of a longer table */
static const double ALIGNED = 0.05;
/* Pairs for rules on pairwise orders; count of points from which several are left out at a time */
enum { LEAST_PAIRS = 3, MOST_PAIRS = 6, MANY = 32 };

/* Returns the pairwise order of the two finest used points. */
static double finest_order(const struct judged *j) { return points_slope(&j->p[j->used - 2], &j->p[j->used - 1]); }

static void set_order(struct judged *j, enum scallop_order_interval interval, double order, double low, double high)
{
  struct scallop_order_result *r = j->result;
  r->order = order;
  r->low = low;
  r->high = high;
  r->interval = interval;
  r->used = j->used;
}

/* Sets the interval to the pairwise orders of the used points from first on. */
static void set_pairwise_order(struct judged *j, int first, double order)
{
  double low = order, high = order;
  for (int i = first; i + 1 < j->used; i++) {
    double slope = points_slope(&j->p[i], &j->p[i + 1]);
    low = fmin(low, slope);
    high = fmax(high, slope);
  }
  set_order(j, SCALLOP_ORDER_PAIRWISE, order, low, high);
}

/* Judges fewer than three used points, which determine no order: the table passes only if every err is within noise. */
static void judge_few(struct judged *j)
{
  int zero = reason_count(j, 0, SCALLOP_ORDER_ZERO), floor = reason_count(j, 0, SCALLOP_ORDER_FLOOR);
  bool values = j->wanted->values, exact = j->count >= 3 && !values;
  for (int i = 0; i < j->count; i++)
    exact = exact && fabs(j->p[i].err) <= j->p[i].noise;
  if (j->used == 2)
    set_pairwise_order(j, 0, finest_order(j));
  if (exact) {
    j->result->verdict = isnan(j->wanted->order) ? SCALLOP_ORDER_MEASURED : SCALLOP_ORDER_PASS;
    reason_add(j, "exact: every err is %s", zero == j->count ? "0" : "within its noise");
    return;
  }
  j->result->verdict = floor + (values ? zero : 0) > 0 ? SCALLOP_ORDER_FLOOR_LIMITED : SCALLOP_ORDER_INSUFFICIENT;
  reason_add(j, "%d usable %s, an order takes 3", j->used,
             values         ? "differences of values"
             : j->used == 1 ? "row"
                            : "rows");
}

static bool meets(const struct scallop_order_wanted *w, double order)
{
  return order >= w->order - w->tolerance && (w->at_least || order <= w->order + w->tolerance);
}

/* Computes the distances of few pairwise orders from the expected one. Returns their count, 0 for other counts. */
static int deviations_of(const struct judged *j, double off[MOST_PAIRS])
{
  const int pairs = j->used - 1;
  if (pairs < LEAST_PAIRS || pairs > MOST_PAIRS)
    return 0;
  for (int i = 0; i < pairs; i++)
    off[i] = points_slope(&j->p[i], &j->p[i + 1]) - j->wanted->order;
  return pairs;
}

/* Returns true if the pairwise orders move away from the expected order at an increasing rate. */
static bool departs_from_expected(const struct judged *j)
{
  double off[MOST_PAIRS], before = 0;
  const int pairs = deviations_of(j, off);
  if (pairs == 0 || (j->wanted->at_least && off[pairs - 1] > 0))
    return false;
  double side = off[pairs - 1] < 0 ? -1 : 1;
  bool away = side * off[pairs - 1] > j->wanted->tolerance / (pairs == LEAST_PAIRS ? 2 : 4);
  for (int k = 1; k < pairs && away; k++) {
    double step = side * (off[k] - off[k - 1]);
    away = fabs(off[k]) > fabs(off[k - 1]) && step > before;
    before = step;
  }
  return away;
}

/* Returns true if they approach it step by step, from one side, and the last one is within the tolerance; with
 * in_shorter_steps, only if the steps decrease. */
static bool approaches_expected(const struct judged *j, bool in_shorter_steps)
{
  double off[MOST_PAIRS], before = INFINITY;
  const int pairs = deviations_of(j, off);
  bool closer = pairs > 0 && fabs(off[pairs - 1]) <= j->wanted->tolerance;
  for (int k = 1; k < pairs && closer; k++) {
    double step = fabs(off[k] - off[k - 1]);
    closer = off[k] * off[k - 1] > 0 && fabs(off[k]) < fabs(off[k - 1]) && (!in_shorter_steps || step < before);
    before = step;
  }
  return closer;
}

/* Sets the order and returns true if the finest points, three or more over a factor TAIL, and the two finest have the
 * expected order, and the points before are farther from it. */
static bool tail_arrives(struct judged *j)
{
  const struct scallop_order_wanted *w = j->wanted;
  int first = j->used - 3;
  while (first > 0 && j->p[first].h < TAIL * j->p[j->used - 1].h)
    first--;
  if (first <= 0)
    return false;
  double order = trend_from(j, first).slope, before = points_slope(&j->p[0], &j->p[first]);
  if (!meets(w, order) || !meets(w, finest_order(j)) || fabs(before - w->order) < fabs(order - w->order))
    return false;
  set_pairwise_order(j, first, order);
  return true;
}

/* Sets the order and returns true if a table reaches the expected order at its fine end, and approaches it all the way.
 * slope: over all points. */
static bool has_arrived(struct judged *j, double slope)
{
  bool on_the_way = fabs(slope - j->wanted->order) <= ON_THE_WAY * j->wanted->tolerance;
  if (on_the_way && tail_arrives(j))
    return true;
  if (!approaches_expected(j, !on_the_way))
    return false;
  set_pairwise_order(j, 0, finest_order(j));
  return true;
}

static void report_drift(struct judged *j, const char *how)
{
  j->result->verdict = SCALLOP_ORDER_DRIFTING;
  reason_add(j, "%s: pairwise orders ", how);
  reason_add_orders(j);
  reason_add_rows(j, 0, SCALLOP_ORDER_USED);
}

/* Compares a known order with the expected order. */
static void compare(struct judged *j, const struct trend *whole)
{
  const struct scallop_order_wanted *w = j->wanted;
  struct scallop_order_result *r = j->result;
  bool measured = isnan(w->order), pass = measured || meets(w, r->order);
  if (pass && !whole->rounded && departs_from_expected(j)) {
    report_drift(j, "the orders move away from the expected one");
    return;
  }
  pass = pass || (r->interval != SCALLOP_ORDER_LIMIT && has_arrived(j, whole->slope));
  r->verdict = measured              ? SCALLOP_ORDER_MEASURED
               : pass                ? SCALLOP_ORDER_PASS
               : r->order < w->order ? SCALLOP_ORDER_TOO_LOW
                                     : SCALLOP_ORDER_TOO_HIGH;
  reason_add(j, "order %.3g", r->order);
  if (!pass)
    reason_add(j, " is %.2g %s the expected %g", fabs(r->order - w->order), r->order < w->order ? "below" : "above",
               w->order);
  reason_add_rows(j, 0, SCALLOP_ORDER_USED);
}

/* Result of a run of points: the order, its uncertainty `off`, and whether that is within the tolerance (known) */
struct estimate {
  enum scallop_order_interval interval;
  double order, off, low, high;
  int first;
  bool known, drifts;
};

/* Returns the result of the run from first on; finer: the trend of the run without its coarsest points. */
static struct estimate estimate_of(const struct judged *j, int first, const struct trend *t, const struct trend *finer)
{
  const double tolerance = j->wanted->tolerance;
  bool settles = t->kind == TREND_SETTLING;
  double off = fmax(t->half_width, fabs(t->slope - t->finest_order));
  double limit_off = fmax(t->limit_half_width, finer->points >= LEAST_TREND ? fabs(finer->limit - t->limit) : 0);
  struct estimate a = { SCALLOP_ORDER_SLOPE, t->slope, 0, 0, 0, first, false, false };
  a.off = settles ? fmax(off, fabs(t->slope - t->limit)) : off; /* a bend makes the slope uncertain */
  if (settles && limit_off <= tolerance) {
    a.interval = SCALLOP_ORDER_LIMIT;
    a.order = t->limit;
    a.off = limit_off;
  }
  a.low = a.order - a.off;
  a.high = a.order + a.off;
  if (t->kind == TREND_STRAIGHT && finer->kind == TREND_STRAIGHT && t->points > LEAST_TREND
      && t->high - t->low <= 2 * tolerance) {
    a.interval = SCALLOP_ORDER_CONFIDENCE;
    a.low = t->low;
    a.high = t->high;
  }
  a.known = a.high - a.low <= 2 * tolerance;
  return a;
}

static void set_estimate(struct judged *j, const struct estimate *a)
{
  set_order(j, a->interval, a->order, a->low, a->high);
  if (j->used == 3)
    set_pairwise_order(j, 0, a->order);
}

/* Judges a run with a dominating term, or with orders that change like a logarithm. The latter passes if the expected
 * order is a lower bound and the finest order reaches it; all else is drifting. */
static void judge_drift(struct judged *j, const struct trend *t)
{
  const struct scallop_order_wanted *w = j->wanted;
  bool rises = t->finest_order > t->coarsest_order, creeps = t->kind == TREND_CREEPING;
  set_pairwise_order(j, 0, finest_order(j));
  if (w->at_least && t->finest_order >= w->order && creeps) {
    j->result->verdict = SCALLOP_ORDER_PASS;
    reason_add(j, "the local order is %.3g at the finest h", t->finest_order);
    reason_add_rows(j, 0, SCALLOP_ORDER_USED);
    return;
  }
  report_drift(j, creeps  ? "the orders change as slowly as a logarithm"
                  : rises ? "the orders rise faster and faster: a term of lower order has the other sign"
                          : "the orders fall faster and faster: a term of lower order takes over");
}

/* Returns the result of the longest run that determines the order, or, if it is a limit, of a shorter run that is far
 * more accurate; else of all points. Each run omits the coarsest points of its predecessor. If a run drifts first,
 * drifts is set, and *whole becomes its trend. */
static struct estimate best_estimate(const struct judged *j, struct trend *whole)
{
  const int half = (whole->points + 1) / 2, fewest = half > LEAST_TREND ? half : LEAST_TREND;
  const int least = whole->points < fewest ? whole->points : fewest;
  const struct estimate none = { SCALLOP_ORDER_NO_INTERVAL, 0, 0, 0, 0, 0, false, false };
  const struct trend no_trend = { TREND_STRAIGHT, false, false, 0, 0, 0, 0, 0, 0, 0, 0, 0 };
  struct estimate best = none;
  struct trend t = *whole, finer;
  for (int first = 0, next; t.points >= least || (t.points == 3 && t.half_width < ALIGNED); first = next, t = finer) {
    bool drifts = t.kind == TREND_LEAVING || t.kind == TREND_CREEPING;
    drifts = drifts && (first == 0 || t.points > LEAST_TREND); /* few points bend by chance */
    if (best.known && (best.interval != SCALLOP_ORDER_LIMIT || drifts))
      break;
    if (drifts) {
      *whole = t;
      best = none;
      best.first = first;
      best.drifts = true;
      return best;
    }
    next = first + 1 + t.points / MANY;
    finer = t.points >= LEAST_TREND ? trend_from(j, next) : no_trend;
    struct estimate a = estimate_of(j, first, &t, &finer);
    if (first == 0 || (best.known ? a.off < best.off / FAR_BETTER : a.known))
      best = a;
  }
  return best;
}

/* Judges a table without a run that determines the order to the tolerance. */
static void judge_unknown(struct judged *j, const struct trend *whole)
{
  struct scallop_order_result *r = j->result;
  if (has_arrived(j, whole->slope)) {
    r->verdict = SCALLOP_ORDER_PASS;
    reason_add(j, "the orders have come to %.3g: ", r->order);
  } else if (whole->kind == TREND_SETTLING) {
    set_pairwise_order(j, 0, finest_order(j));
    report_drift(j, "the orders have not settled");
    return;
  } else {
    r->verdict = SCALLOP_ORDER_SCATTERED;
    reason_add(j, "the order is %.3g to no better than %.2g: pairwise orders ", r->order, r->high - r->order);
  }
  reason_add_orders(j);
}

static void judge_trend(struct judged *j)
{
  struct trend whole = trend_from(j, 0);
  if (whole.finest_is_off) {
    j->p[j->used - 1].use = SCALLOP_ORDER_FLOOR;
    points_sort_by_use(j);
    whole = trend_from(j, 0);
  }
  struct trend t = whole;
  struct estimate best = best_estimate(j, &t);
  const bool of_three = j->used == 3;
  if (best.known || best.drifts)
    points_leave_out(j, best.first, SCALLOP_ORDER_COARSE);
  set_estimate(j, &best);
  if (of_three) /* pairwise orders are more informative than a line with one degree of freedom */
    best.known = j->result->high - j->result->low <= j->wanted->tolerance;
  if (best.drifts)
    judge_drift(j, &t);
  else
    (best.known ? compare : judge_unknown)(j, &whole);
}

static void leave_out_before_sign_change(struct judged *j)
{
  int change = 0;
  for (int i = 1; i < j->used; i++)
    if ((j->p[i].err < 0) != (j->p[i - 1].err < 0))
      change = i;
  points_leave_out(j, change, SCALLOP_ORDER_BEFORE_SIGN_CHANGE);
}

/* Judges the used points. Returns true if they decide. */
static bool judge_used(struct judged *j)
{
  leave_out_before_sign_change(j);
  (j->used < 3 ? judge_few : judge_trend)(j);
  return j->result->verdict <= SCALLOP_ORDER_MEASURED;
}

/* Leaves out zeros, the first error that is near its known noise, and all finer errors. */
static void leave_out_noise(struct judged *j)
{
  bool met = false;
  for (int i = 0; i < j->count; i++) {
    struct scallop_order_point *p = &j->p[i];
    met |= p->noise > 0 && fabs(p->err) <= POINTS_ABOVE_NOISE * p->noise;
    p->use = p->err == 0 ? SCALLOP_ORDER_ZERO : met ? SCALLOP_ORDER_FLOOR : SCALLOP_ORDER_USED;
  }
  points_sort_by_use(j);
}

/* Sorts by h. Writes faults and the first repeated h to the reason; returns false if it finds any. */
static bool is_valid(struct judged *j)
{
  bool valid = !reason_add_all(j, true, "", "; ");
  points_sort_by_h(j);
  for (int i = 0; i + 1 < j->count; i++)
    if (j->p[i].h == j->p[i + 1].h) {
      long a = j->p[i].row, b = j->p[i + 1].row;
      reason_add(j, "%sh repeated in rows %ld and %ld", valid ? "" : "; ", a < b ? a : b, a < b ? b : a);
      return false;
    }
  return valid;
}

static void judge(struct judged *j)
{
  if (!is_valid(j)) {
    j->result->verdict = SCALLOP_ORDER_INVALID;
    return;
  }
  bool announced = false;
  for (int i = 0; i < j->count; i++)
    announced |= j->p[i].noise > 0;
  if (j->wanted->values)
    points_from_values(j, announced);
  for (int i = 0; i < j->count; i++)
    j->p[i].pairwise = i + 1 < j->count && j->p[i].err != 0 && j->p[i + 1].err != 0
                           ? points_slope(&j->p[i], &j->p[i + 1])
                           : NAN;
  leave_out_noise(j);
  if (!floor_judge(j, announced))
    return;
  if (!judge_used(j) && floor_leave_out_near(j))
    judge_used(j);
  if (j->result->used > 0 || j->result->verdict == SCALLOP_ORDER_INSUFFICIENT)
    reason_add_all(j, false, "; left out: ", ", ");
}

void scallop_order(struct scallop_order_point *points, int *count, const struct scallop_order_wanted *wanted,
                   struct scallop_order_result *result)
{
  const struct scallop_order_result nothing = {
    SCALLOP_ORDER_PASS, NAN, NAN, NAN, SCALLOP_ORDER_NO_INTERVAL, 0, NAN, NAN, ""
  };
  *result = nothing;
  struct judged j = { points, *count, 0, wanted, result, 0, 0 };
  for (int i = 0; i < j.count; i++)
    if (points[i].row == 0)
      points[i].row = i + 1;
  judge(&j);
  points_sort_by_h(&j);
  *count = j.count;
}

const char *scallop_order_verdict_text(enum scallop_order_verdict verdict)
{
  static const char *const text[] = { "pass",      "measured", "too-low",       "too-high",     "drifting",
                                      "scattered", "plateau",  "floor-limited", "insufficient", "invalid" };
  return text[verdict];
}

const char *scallop_order_interval_text(enum scallop_order_interval interval)
{
  static const char *const text[] = { "none", "confidence-95", "slope-95", "limit", "pairwise" };
  return text[interval];
}
