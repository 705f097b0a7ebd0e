#include <math.h>
#include <stddef.h>

#include "asymptotics/observed/judged.h"
#include "asymptotics/observed/trend.h"

/* The tail of a table that has just settled: the finest three or more points, over this many times in h. */
static const double TAIL = 3.9;
/* Where the tail decides, the slope over all points may be this many tolerances off. */
static const double ON_THE_WAY = 2.5;
/* A run with an interval so many times narrower counts instead of a longer one. */
static const double FAR_BETTER = 10;
/* Three points of a longer table count if they are on a line so well. */
static const double ALIGNED = 0.05;
/* Of so many points and more, the coarsest are left out several at a time. */
enum { MOST_FEW = 6, MANY = 32 };

/* The rows are named in the order of h. */
static void give(struct judged *j, enum scallop_order_verdict verdict)
{
  j->result->verdict = verdict;
  points_sort(j->p, j->count);
}

/* The rows of the first h that is repeated. Points with another fault are not sorted: of those as many as a page
 * holds are compared. */
static void say_repeated(struct judged *j, const char *between)
{
  enum { PAGE = 1000 };
  bool sorted = *between == '\0';
  for (int i = 0; i + 1 < j->count && (sorted || i < PAGE); i++)
    for (int k = i + 1; k < j->count && k <= (sorted ? i + 1 : PAGE); k++)
      if (j->p[i].h == j->p[k].h) {
        long a = j->p[i].row, b = j->p[k].row;
        reason_add(j, "%sh repeated in rows %ld and %ld", between, a < b ? a : b, a < b ? b : a);
        return;
      }
}

/* The pairwise order of the two finest used points */
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

/* The pairwise orders of the used points from first on */
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

/* Fewer than three points have no order, unless all are exact. */
static void judge_few(struct judged *j)
{
  int zero = reason_count(j, 0, SCALLOP_ORDER_ZERO), floor = reason_count(j, 0, SCALLOP_ORDER_FLOOR);
  bool exact = j->count >= 3 && !j->wanted->values;
  for (int i = 0; i < j->count; i++)
    exact = exact && fabs(j->p[i].err) <= j->p[i].noise;
  if (j->used == 2)
    set_pairwise_order(j, 0, finest_order(j));
  give(j, exact ? (isnan(j->wanted->order) ? SCALLOP_ORDER_MEASURED : SCALLOP_ORDER_PASS)
          : floor + (j->wanted->values ? zero : 0) == 0 ? SCALLOP_ORDER_INSUFFICIENT
                                                        : SCALLOP_ORDER_FLOOR_LIMITED);
  if (exact)
    reason_add(j, zero == j->count ? "exact: every err is 0" : "exact: every err is within its noise");
  else
    reason_add(j, "%d usable %s, an order takes 3", j->used,
               j->wanted->values ? "differences of values"
               : j->used == 1    ? "row"
                                 : "rows");
}

static bool meets(const struct scallop_order_wanted *w, double order)
{
  return order >= w->order - w->tolerance && (w->at_least || order <= w->order + w->tolerance);
}

/* How far the i-th pairwise order is off the one that is expected */
static double off(const struct judged *j, int i) { return points_slope(&j->p[i], &j->p[i + 1]) - j->wanted->order; }

/* The pairwise orders of few points move away from the one that is expected, faster and faster. */
static bool moves_away(const struct judged *j)
{
  const struct scallop_order_wanted *w = j->wanted;
  const int pairs = j->used - 1;
  if (pairs < 3 || pairs > MOST_FEW || (w->at_least && off(j, pairs - 1) > 0))
    return false;
  double side = off(j, pairs - 1) < 0 ? -1 : 1;
  bool away = side * off(j, pairs - 1) > w->tolerance / (pairs == 3 ? 2 : 4);
  for (int k = 1; k < pairs; k++)
    away = away && fabs(off(j, k)) > fabs(off(j, k - 1))
           && side * (off(j, k) - off(j, k - 1)) > (k == 1 ? 0 : side * (off(j, k - 1) - off(j, k - 2)));
  return away;
}

/* They come closer to it step by step, from one side, and the last one is there; in steps that shrink, where that is
 * asked for. */
static bool comes_closer(const struct judged *j, bool in_shorter_steps)
{
  const int pairs = j->used - 1;
  bool closer = pairs >= 3 && pairs <= MOST_FEW && fabs(off(j, pairs - 1)) <= j->wanted->tolerance;
  for (int k = 1; k < pairs && closer; k++)
    closer = off(j, k) * off(j, k - 1) > 0 && fabs(off(j, k)) < fabs(off(j, k - 1))
             && (!in_shorter_steps || k < 2 || fabs(off(j, k - 1) - off(j, k)) < fabs(off(j, k - 2) - off(j, k - 1)));
  return closer;
}

/* Do the finest three or more points, over a factor TAIL, have the order, and the pair of the finest two, and are
 * those before farther from it? Then that is set. */
static bool tail_arrives(struct judged *j)
{
  const struct scallop_order_wanted *w = j->wanted;
  int first = j->used - 3;
  while (first > 0 && j->p[first].h < TAIL * j->p[j->used - 1].h)
    first--;
  if (first <= 0)
    return false;
  double order = trend_of(j->p + first, j->used - first, j->level).slope;
  double before = points_slope(&j->p[0], &j->p[first]);
  if (!meets(w, order) || !meets(w, finest_order(j)) || fabs(before - w->order) < fabs(order - w->order))
    return false;
  set_pairwise_order(j, first, order);
  return true;
}

/* A table that reaches the order at its fine end, and comes closer to it all the way: sets the order, and returns
 * whether it is so. */
static bool has_arrived(struct judged *j, const struct trend *all)
{
  bool on_the_way = fabs(all->slope - j->wanted->order) <= ON_THE_WAY * j->wanted->tolerance;
  if (on_the_way && tail_arrives(j))
    return true;
  if (!comes_closer(j, !on_the_way))
    return false;
  set_pairwise_order(j, 0, finest_order(j));
  return true;
}

static void say_drift(struct judged *j, const char *how)
{
  reason_add(j, "%s: pairwise orders ", how);
  reason_add_orders(j);
  give(j, SCALLOP_ORDER_DRIFTING);
  reason_add_rows(j, 0, SCALLOP_ORDER_USED);
}

/* The order is known: is it the one that is expected? */
static void compare(struct judged *j, const struct trend *whole)
{
  const struct scallop_order_wanted *w = j->wanted;
  struct scallop_order_result *r = j->result;
  bool measured = isnan(w->order), pass = measured || meets(w, r->order);
  if (pass && !whole->rounded && moves_away(j)) {
    say_drift(j, "the orders move away from the expected one");
    return;
  }
  pass = pass || (r->interval != SCALLOP_ORDER_LIMIT && has_arrived(j, whole));
  give(j, measured              ? SCALLOP_ORDER_MEASURED
          : pass                ? SCALLOP_ORDER_PASS
          : r->order < w->order ? SCALLOP_ORDER_TOO_LOW
                                : SCALLOP_ORDER_TOO_HIGH);
  reason_add(j, "order %.3g", r->order);
  if (!pass)
    reason_add(j, " is %.2g %s the expected %g", fabs(r->order - w->order), r->order < w->order ? "below" : "above",
               w->order);
  reason_add_rows(j, 0, SCALLOP_ORDER_USED);
}

/* What a run of points says, from first on: the order, give or take off */
struct answer {
  enum scallop_order_interval interval;
  double order, off, low, high;
  int first;
};

/* finer: the trend of the run without its coarsest points */
static struct answer answer_of(const struct judged *j, int first, const struct trend *t, const struct trend *finer)
{
  double off = fmax(t->half_width, fabs(t->slope - t->finest_order));
  double limit_off = fmax(t->limit_half_width, finer->points >= LEAST_TREND ? fabs(finer->limit - t->limit) : 0);
  if (t->kind == TREND_SETTLING && limit_off <= j->wanted->tolerance)
    return (
        struct answer){ SCALLOP_ORDER_LIMIT, t->limit, limit_off, t->limit - limit_off, t->limit + limit_off, first };
  if (t->kind == TREND_SETTLING) /* a slope that bends towards another order is none */
    off = fmax(off, fabs(t->slope - t->limit));
  struct answer a = { SCALLOP_ORDER_SLOPE, t->slope, off, t->slope - off, t->slope + off, first };
  if (t->kind == TREND_STRAIGHT && finer->kind == TREND_STRAIGHT && t->points > LEAST_TREND
      && t->high - t->low <= 2 * j->wanted->tolerance) {
    a.interval = SCALLOP_ORDER_CONFIDENCE;
    a.low = t->low;
    a.high = t->high;
  }
  return a;
}

/* Sets it, and returns whether the order is known to the tolerance. */
static bool sets_order(struct judged *j, const struct answer *a)
{
  set_order(j, a->interval, a->order, a->low, a->high);
  if (j->result->used == 3)
    set_pairwise_order(j, 0, a->order);
  return j->result->high - j->result->low <= (j->result->used == 3 ? 1 : 2) * j->wanted->tolerance;
}

/* A term takes over, or the order changes like a logarithm: no pass, unless the order is at least the one that is
 * expected and creeps */
static void judge_drift(struct judged *j, const struct trend *t)
{
  const struct scallop_order_wanted *w = j->wanted;
  bool rises = t->finest_order > t->coarsest_order, creeps = t->kind == TREND_CREEPING;
  set_pairwise_order(j, 0, finest_order(j));
  if (w->at_least && t->finest_order >= w->order && creeps) {
    give(j, SCALLOP_ORDER_PASS);
    reason_add(j, "the local order is %.3g at the finest h", t->finest_order);
    reason_add_rows(j, 0, SCALLOP_ORDER_USED);
    return;
  }
  say_drift(j, creeps  ? "the orders change as slowly as a logarithm"
               : rises ? "the orders rise faster and faster: a term of lower order has the other sign"
                       : "the orders fall faster and faster: a term of lower order takes over");
}

/* Runs of points, each without the coarsest of the one before, until one says what the order is; where that is a
 * limit, until the shortest, and one that knows it far better counts instead. */
static void judge_trend(struct judged *j)
{
  struct trend whole = trend_of(j->p, j->used, j->level);
  if (whole.finest_is_off) {
    j->p[j->used - 1].use = SCALLOP_ORDER_FLOOR;
    points_sort_by_use(j);
    whole = trend_of(j->p, j->used, j->level);
  }
  int half = (whole.points + 1) / 2, least = whole.points <= LEAST_TREND ? whole.points
                                             : half > LEAST_TREND        ? half
                                                                         : LEAST_TREND;
  struct trend t = whole, finer;
  struct answer all = { .interval = SCALLOP_ORDER_NO_INTERVAL }, best = all;
  for (int first = 0, next; t.points >= least || (t.points == 3 && t.half_width < ALIGNED); first = next, t = finer) {
    bool known = best.interval != SCALLOP_ORDER_NO_INTERVAL,
         drifts = t.kind == TREND_LEAVING || t.kind == TREND_CREEPING;
    drifts = drifts && (first == 0 || t.points > LEAST_TREND); /* few points bend by chance */
    if (known && (best.interval != SCALLOP_ORDER_LIMIT || drifts))
      break;
    if (drifts) {
      points_leave_out(j, first, SCALLOP_ORDER_COARSE);
      judge_drift(j, &t);
      return;
    }
    next = first + 1 + t.points / MANY;
    finer = t.points >= LEAST_TREND ? trend_of(j->p + next, j->used - next, j->level) : (struct trend){ 0 };
    struct answer a = answer_of(j, first, &t, &finer);
    if (first == 0)
      all = a;
    if (known ? a.off < best.off / FAR_BETTER : sets_order(j, &a))
      best = a;
  }
  if (best.interval != SCALLOP_ORDER_NO_INTERVAL) {
    points_leave_out(j, best.first, SCALLOP_ORDER_COARSE);
    sets_order(j, &best);
    compare(j, &whole);
    return;
  }
  sets_order(j, &all);
  if (!isnan(j->wanted->order) && has_arrived(j, &whole)) {
    reason_add(j, "the orders have come to %.3g: ", j->result->order);
    reason_add_orders(j);
    give(j, SCALLOP_ORDER_PASS);
  } else if (whole.kind == TREND_SETTLING) {
    set_pairwise_order(j, 0, finest_order(j));
    say_drift(j, "the orders have not settled");
  } else {
    reason_add(j, "the order is %.3g to no better than %.2g: pairwise orders ", j->result->order,
               j->result->high - j->result->order);
    reason_add_orders(j);
    give(j, SCALLOP_ORDER_SCATTERED);
  }
}

static void leave_out_before_sign_change(struct judged *j)
{
  int change = 0;
  for (int i = 1; i < j->used; i++)
    if ((j->p[i].err < 0) != (j->p[i - 1].err < 0))
      change = i;
  points_leave_out(j, change, SCALLOP_ORDER_BEFORE_SIGN_CHANGE);
}

/* Judges the points that are used, and returns whether they decide. */
static bool judge_used(struct judged *j)
{
  leave_out_before_sign_change(j);
  (j->used < 3 ? judge_few : judge_trend)(j);
  return j->result->verdict <= SCALLOP_ORDER_MEASURED;
}

/* Zeros, and errors too near their known noise. Once an error has met its noise, so have all finer ones. */
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

static void judge(struct judged *j)
{
  bool announced = false, valid = points_sort(j->p, j->count);
  for (int i = 0; i < j->count; i++)
    announced |= j->p[i].noise > 0;
  if (!valid) {
    say_repeated(j, reason_add_all(j, true, "", "; "));
    give(j, SCALLOP_ORDER_INVALID);
    return;
  }
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
  *result = (struct scallop_order_result){
    .order = NAN, .low = NAN, .high = NAN, .gci = NAN, .asymptotic_ratio = NAN, .interval = SCALLOP_ORDER_NO_INTERVAL
  };
  struct judged j = { .p = points, .count = *count, .wanted = wanted, .result = result };
  for (int i = 0; i < j.count; i++)
    if (points[i].row == 0)
      points[i].row = i + 1;
  judge(&j);
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
