#include <math.h>
#include <stddef.h>

#include "asymptotics/observed/floor.h"
#include "asymptotics/observed/points.h"
#include "asymptotics/observed/reason.h"
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
enum { LEAST = 4, MOST_FEW = 6, MANY = 32 };

static bool is_used(const struct scallop_order_point *p, int i) { return p[i].use == SCALLOP_ORDER_USED; }
static bool is_zero(const struct scallop_order_point *p, int i) { return p[i].use == SCALLOP_ORDER_ZERO; }
static bool is_floor(const struct scallop_order_point *p, int i) { return p[i].use == SCALLOP_ORDER_FLOOR; }
static bool is_coarse(const struct scallop_order_point *p, int i) { return p[i].use == SCALLOP_ORDER_COARSE; }
static bool is_before_change(const struct scallop_order_point *p, int i)
{
  return p[i].use == SCALLOP_ORDER_BEFORE_SIGN_CHANGE;
}
static bool is_nan(const struct scallop_order_point *p, int i) { return isnan(p[i].err) || isnan(p[i].h); }
static bool is_infinite(const struct scallop_order_point *p, int i) { return isinf(p[i].err) || isinf(p[i].h); }
static bool is_not_positive(const struct scallop_order_point *p, int i) { return p[i].h <= 0; }
static bool is_bad_noise(const struct scallop_order_point *p, int i) { return !(p[i].noise >= 0); }

static void give(struct judged *j, enum scallop_order_verdict verdict) { j->result->verdict = verdict; }

/* The rows of the first h that is repeated. Points with another fault are not sorted: of those as many as a page
 * holds are compared. */
static void say_repeated(struct judged *j, const char *between)
{
  enum { PAGE = 1000 };
  bool sorted = *between == '\0';
  for (int i = 0; i + 1 < j->count && (sorted || i < PAGE); i++)
    for (int k = i + 1; k < j->count && k <= (sorted ? i + 1 : PAGE); k++)
      if (j->points[i].h == j->points[k].h) {
        long a = j->points[i].row, b = j->points[k].row;
        reason_add(j, "%sh repeated in rows %ld and %ld", between, a < b ? a : b, a < b ? b : a);
        return;
      }
}

static void say_invalid(struct judged *j)
{
  static const struct {
    reason_picks *picks;
    const char *what;
  } faults[] = { { is_nan, "NaN" },
                 { is_infinite, "an infinite number" },
                 { is_not_positive, "h <= 0" },
                 { is_bad_noise, "noise < 0 or NaN" } };
  bool said = false;
  for (size_t f = 0; f < sizeof faults / sizeof *faults; f++)
    if (reason_count(j, faults[f].picks, 0, j->count - 1) > 0) {
      reason_add(j, "%s%s", said ? "; " : "", faults[f].what);
      reason_add_rows(j, faults[f].picks, 0, j->count - 1);
      said = true;
    }
  say_repeated(j, said ? "; " : "");
  give(j, SCALLOP_ORDER_INVALID);
}

/* The pairwise order of the two finest used points */
static double finest_order(const struct judged *j)
{
  int last = points_last(j->points, j->count);
  return points_slope(&j->points[points_last(j->points, last)], &j->points[last]);
}

static void set_order(struct judged *j, enum scallop_order_interval interval, double order, double low, double high)
{
  struct scallop_order_result *r = j->result;
  r->order = order;
  r->low = low;
  r->high = high;
  r->interval = interval;
  r->used = points_count(SCALLOP_ORDER_USED, j->points, j->count, 0);
}

/* The pairwise orders of the used points from first on */
static void set_pairwise_order(struct judged *j, int first, double order)
{
  double low = INFINITY, high = -INFINITY;
  for (int i = points_next(j->points, j->count, first), k; i < j->count; i = k) {
    k = points_next(j->points, j->count, i + 1);
    if (k < j->count) {
      low = fmin(low, points_slope(&j->points[i], &j->points[k]));
      high = fmax(high, points_slope(&j->points[i], &j->points[k]));
    }
  }
  set_order(j, SCALLOP_ORDER_PAIRWISE, order, fmin(low, order), fmax(high, order));
}

static bool judge_few(struct judged *j)
{
  int used = points_count(SCALLOP_ORDER_USED, j->points, j->count, 0);
  int zero = points_count(SCALLOP_ORDER_ZERO, j->points, j->count, 0);
  int floor = points_count(SCALLOP_ORDER_FLOOR, j->points, j->count, 0);
  bool exact = j->count >= 3 && !j->wanted->values;
  for (int i = 0; i < j->count; i++)
    exact = exact && fabs(j->points[i].err) <= j->points[i].noise;
  if (used >= 3)
    return false;
  if (used == 2)
    set_pairwise_order(j, 0, finest_order(j));
  give(j, exact ? (isnan(j->wanted->order) ? SCALLOP_ORDER_MEASURED : SCALLOP_ORDER_PASS)
          : floor + (j->wanted->values ? zero : 0) == 0 ? SCALLOP_ORDER_INSUFFICIENT
                                                        : SCALLOP_ORDER_FLOOR_LIMITED);
  if (exact)
    reason_add(j, zero == j->count ? "exact: every err is 0" : "exact: every err is within its noise");
  else
    reason_add(j, "%d usable %s, an order takes 3", used,
               j->wanted->values ? "differences of values"
               : used == 1       ? "row"
                                 : "rows");
  return true;
}

static void say_left_out(struct judged *j)
{
  static const struct {
    reason_picks *picks;
    const char *what;
  } uses[] = { { is_zero, "err is 0" },
               { is_floor, "roundoff" },
               { is_coarse, "not yet in the trend" },
               { is_before_change, "before a change of sign" } };
  const char *between = "; left out: ";
  for (size_t u = 0; u < sizeof uses / sizeof *uses; u++)
    if (reason_count(j, uses[u].picks, 0, j->count - 1) > 0) {
      reason_add(j, "%s%s", between, uses[u].what);
      reason_add_rows(j, uses[u].picks, 0, j->count - 1);
      between = ", ";
    }
}

static bool meets(const struct scallop_order_wanted *w, double order)
{
  return order >= w->order - w->tolerance && (w->at_least || order <= w->order + w->tolerance);
}

/* How far the pairwise orders of few points are off the one that is expected. Returns how many there are, 0 for too
 * many. */
static int few_orders(const struct judged *j, double off[MOST_FEW])
{
  int pairs = 0;
  for (int i = points_next(j->points, j->count, 0), k; i < j->count; i = k) {
    k = points_next(j->points, j->count, i + 1);
    if (k < j->count && pairs == MOST_FEW)
      return 0;
    if (k < j->count)
      off[pairs++] = points_slope(&j->points[i], &j->points[k]) - j->wanted->order;
  }
  return pairs;
}

/* They move away from the one that is expected, faster and faster. */
static bool moves_away(const struct judged *j)
{
  const struct scallop_order_wanted *w = j->wanted;
  double off[MOST_FEW];
  int pairs = few_orders(j, off);
  if (pairs < 3 || (w->at_least && off[pairs - 1] > 0))
    return false;
  double side = off[pairs - 1] < 0 ? -1 : 1;
  bool away = side * off[pairs - 1] > w->tolerance / (pairs == 3 ? 2 : 4);
  for (int k = 1; k < pairs; k++)
    away = away && fabs(off[k]) > fabs(off[k - 1])
           && side * (off[k] - off[k - 1]) > (k == 1 ? 0 : side * (off[k - 1] - off[k - 2]));
  return away;
}

/* They come closer to it step by step, from one side, and the last one is there; in steps that shrink, where that is
 * asked for. */
static bool comes_closer(const struct judged *j, bool in_shorter_steps)
{
  double off[MOST_FEW];
  int pairs = few_orders(j, off);
  bool closer = pairs >= 3 && fabs(off[pairs - 1]) <= j->wanted->tolerance;
  for (int k = 1; k < pairs; k++)
    closer = closer && off[k] * off[k - 1] > 0 && fabs(off[k]) < fabs(off[k - 1])
             && (!in_shorter_steps || k < 2 || fabs(off[k - 1] - off[k]) < fabs(off[k - 2] - off[k - 1]));
  return closer;
}

/* Do the finest three or more points, over a factor TAIL, have the order, and the pair of the finest two, and are
 * those before farther from it? Then that is set. */
static bool tail_arrives(struct judged *j, const struct trend *all)
{
  const struct scallop_order_wanted *w = j->wanted;
  int first = points_last(j->points, j->count), tail = 1, coarsest = points_next(j->points, j->count, 0);
  double finest = j->points[first].h;
  while (first > 0 && (tail < 3 || j->points[first].h < TAIL * finest))
    tail += is_used(j->points, --first);
  if (tail == all->points || j->points[first].h < TAIL * finest)
    return false;
  double order = trend_of(j->points, j->count, first, j->level).slope;
  double before = points_slope(&j->points[coarsest], &j->points[first]);
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
  if (on_the_way && tail_arrives(j, all))
    return true;
  if (!comes_closer(j, !on_the_way))
    return false;
  set_pairwise_order(j, 0, finest_order(j));
  return true;
}

static void say_drift(struct judged *j, const char *how)
{
  give(j, SCALLOP_ORDER_DRIFTING);
  reason_add(j, "%s: pairwise orders ", how);
  reason_add_orders(j);
  reason_add_rows(j, is_used, 0, j->count - 1);
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
  reason_add_rows(j, is_used, 0, j->count - 1);
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
  double limit_off = fmax(t->limit_half_width, finer->points >= LEAST ? fabs(finer->limit - t->limit) : 0);
  if (t->kind == TREND_SETTLING && limit_off <= j->wanted->tolerance)
    return (
        struct answer){ SCALLOP_ORDER_LIMIT, t->limit, limit_off, t->limit - limit_off, t->limit + limit_off, first };
  if (t->kind == TREND_SETTLING) /* a slope that bends towards another order is none */
    off = fmax(off, fabs(t->slope - t->limit));
  struct answer a = { SCALLOP_ORDER_SLOPE, t->slope, off, t->slope - off, t->slope + off, first };
  if (t->kind == TREND_STRAIGHT && finer->kind == TREND_STRAIGHT && t->points > LEAST
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
    reason_add_rows(j, is_used, 0, j->count - 1);
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
  struct trend whole = trend_of(j->points, j->count, 0, j->level);
  if (whole.finest_is_off) {
    j->points[points_last(j->points, j->count)].use = SCALLOP_ORDER_FLOOR;
    whole = trend_of(j->points, j->count, 0, j->level);
  }
  int least = whole.points <= LEAST ? whole.points : (whole.points + 1) / 2 > LEAST ? (whole.points + 1) / 2 : LEAST;
  struct trend t = whole, finer;
  struct answer all = { .interval = SCALLOP_ORDER_NO_INTERVAL }, best = all;
  for (int first = 0, next; t.points >= least || (t.points == 3 && t.half_width < ALIGNED); first = next, t = finer) {
    bool known = best.interval != SCALLOP_ORDER_NO_INTERVAL,
         drifts = t.kind == TREND_LEAVING || t.kind == TREND_CREEPING;
    drifts = drifts && (first == 0 || t.points > LEAST); /* few points bend by chance */
    if (known && (best.interval != SCALLOP_ORDER_LIMIT || drifts))
      break;
    if (drifts) {
      points_leave_out_first(j->points, first, SCALLOP_ORDER_COARSE);
      judge_drift(j, &t);
      return;
    }
    next = first;
    for (int k = 0; k <= t.points / MANY; k++)
      next = points_next(j->points, j->count, next) + 1;
    finer = t.points >= LEAST ? trend_of(j->points, j->count, next, j->level) : (struct trend){ 0 };
    struct answer a = answer_of(j, first, &t, &finer);
    if (first == 0)
      all = a;
    if (known ? a.off < best.off / FAR_BETTER : sets_order(j, &a))
      best = a;
  }
  if (best.interval != SCALLOP_ORDER_NO_INTERVAL) {
    points_leave_out_first(j->points, best.first, SCALLOP_ORDER_COARSE);
    sets_order(j, &best);
    compare(j, &whole);
    return;
  }
  sets_order(j, &all);
  if (!isnan(j->wanted->order) && has_arrived(j, &whole)) {
    give(j, SCALLOP_ORDER_PASS);
    reason_add(j, "the orders have come to %.3g: ", j->result->order);
    reason_add_orders(j);
  } else if (whole.kind == TREND_SETTLING) {
    set_pairwise_order(j, 0, finest_order(j));
    say_drift(j, "the orders have not settled");
  } else {
    give(j, SCALLOP_ORDER_SCATTERED);
    reason_add(j, "the order is %.3g to no better than %.2g: pairwise orders ", j->result->order,
               j->result->high - j->result->order);
    reason_add_orders(j);
  }
}

/* Judges the points that are used, and returns whether they decide. */
static bool judge_used(struct judged *j)
{
  points_leave_out_before_sign_change(j->points, j->count);
  if (!judge_few(j))
    judge_trend(j);
  return j->result->verdict <= SCALLOP_ORDER_MEASURED;
}

static void judge(struct judged *j)
{
  for (int i = 0; i < j->count; i++)
    if (j->points[i].row == 0)
      j->points[i].row = i + 1;
  if (!points_sort(j->points, j->count)) {
    say_invalid(j);
    return;
  }
  bool announced = points_noise_is_known(j->points, j->count);
  if (j->wanted->values) {
    points_grid_convergence(j->points, j->count, j->wanted->order, &j->result->gci, &j->result->asymptotic_ratio);
    points_from_values(j->points, &j->count);
  }
  points_note_pairwise(j->points, j->count);
  points_leave_out_noise(j->points, j->count);
  if (!floor_judge(j, announced))
    return;
  if (!judge_used(j) && floor_leave_out_near(j))
    judge_used(j);
  if (j->result->used > 0 || j->result->verdict == SCALLOP_ORDER_INSUFFICIENT)
    say_left_out(j);
}

void scallop_order(struct scallop_order_point *points, int *count, const struct scallop_order_wanted *wanted,
                   struct scallop_order_result *result)
{
  *result = (struct scallop_order_result){
    .order = NAN, .low = NAN, .high = NAN, .gci = NAN, .asymptotic_ratio = NAN, .interval = SCALLOP_ORDER_NO_INTERVAL
  };
  struct judged j = { .points = points, .count = *count, .wanted = wanted, .result = result };
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
