/* Floors: rows at the fine end in which falling errors no longer fall. A rough floor is roundoff, or the tolerance of a
 * solver: the points on it and near it are left out. A smooth floor far above roundoff is a plateau: the table
 * converges to another value, and plateau is its verdict. */
#include <math.h>

#include "asymptotics/observed/judged.h"

/* A tail is a floor if its overall and its first order are below FLAT times the upper quartile of all orders (at most
 * 1), or below FLATTER times the median of the last FEW orders before it; the latter only if h falls by a factor APART
 * from row to row: the orders of closer rows are noise. */
static const double FLAT = 0.5, FLATTER = 0.35, APART = 1.2;
/* A floor requires an order of at least this somewhere in the table. */
static const double STEEP = 0.1;
/* Errors up to ROUNDOFF are near the roundoff of a quantity of order 1: a floor there is not due to the method. If the
 * other rules do not decide and LEAST_TREND errors are at least NEAR_ROUNDOFF, these determine the order. */
static const double ROUNDOFF = 1e-11, NEAR_ROUNDOFF = 1e-12;
/* Fraction of the largest error. A rough floor may be this high: tolerances of solvers, single precision. */
static const double ROUGH = 1e-6;
/* A plateau: C h^p + D fits with misfit FITS (C h^p + D h^q with FITS_WELL: no floor); or the three finest errors have
 * a ratio of at most LEVEL; or, of few rows, the floor's at most SMOOTH, VERY_SMOOTH if it is low: roundoff jumps. */
static const double FITS = 0.1, FITS_WELL = 0.05, LEVEL = 1.03, SMOOTH = 1.5, VERY_SMOOTH = 1.2;
/* A floor is accepted if the finest error is this many times its extrapolation from the orders before. */
static const double HELD_UP = 1.5;
/* Ratios of an error to a floor: above FAR_ABOVE no trend shows the floor; above ABOVE_FLOOR it is a few percent;
 * errors above NEAR_FLOOR are used, with lower weights, if too few others exist. */
static const double FAR_ABOVE = 1000, ABOVE_FLOOR = 30, NEAR_FLOOR = 3;
static const double LEAST_POWER = 0.5, MOST_POWER = 12, MOST_LOWER = 4, NEXT_POWER = 1.02;
/* Rows at the start of a floor; rows before it in the fit; sufficient rows far above it */
enum { BEGINS = 3, BEFORE = 4, ENOUGH = 5, FEW = 5 };

/* Returns the slope of this rank among the slopes from points[first] on. */
static double slope_ranked(const struct scallop_order_point *points, int first, int count, int rank)
{
  double slopes[MOST_SORTED];
  for (int i = 0; i < count; i++)
    slopes[i] = points_slope(&points[first + i], &points[first + i + 1]);
  return points_ranked(slopes, count, rank);
}

/* Returns the upper quartile of the slopes. */
static double steepness(const struct scallop_order_point *points, int count)
{
  int slopes = count > MOST_SORTED ? MOST_SORTED : count - 1;
  return slopes > 0 ? slope_ranked(points, 0, slopes, 3 * slopes / 4) : 0;
}

/* Returns the median of the last FEW slopes before point i, 0 for fewer slopes or if rows are close. */
static double middle_before(const struct scallop_order_point *points, int i)
{
  for (int k = i - FEW; k < i; k++)
    if (k < 0 || points[k].h <= APART * points[k + 1].h)
      return 0;
  return slope_ranked(points, i - FEW, FEW, FEW / 2);
}

/* Returns the first point from which the errors no longer fall, though they fell before, by more than noise in two
 * neighbours explains; -1: they fall. */
static int onset_before(const struct scallop_order_point *points, int count)
{
  const struct scallop_order_point *last = &points[count - 1];
  double steep = steepness(points, count);
  for (int i = 1; i + 1 < count && steep >= STEEP; i++) {
    double flat = fmax(FLAT * fmin(1, steep), FLATTER * middle_before(points, i));
    double rest = points_slope(&points[i], last);
    if (points_slope(&points[i], &points[i + 1]) < flat && rest < flat)
      return (steepness(points, i + 1) - rest) * log(points[i].h / last->h) > log(HELD_UP) ? i : -1;
  }
  return -1;
}

/* Returns the first point of a floor, or -1. The finest point of a rough floor may be low by chance: it is then
 * ignored, unless a finer point is already ignored because its error is 0. */
static int find_floor(const struct judged *j)
{
  bool spare = j->used > 1 && j->count > LEAST_TREND + 1;
  for (int i = j->used; spare && i < j->count; i++)
    spare = j->p[i].h >= j->p[j->used - 1].h;
  int onset = j->used > 0 ? onset_before(j->p, j->used) : -1;
  return onset < 0 && spare ? onset_before(j->p, j->used - 1) : onset;
}

/* Returns the misfit of C h^p + D h^q with C, D > 0 and the best p > q, the root mean square of the relative residuals,
 * from a few rows before onset on. NAN: too few rows; INFINITY: D h^q is less than half of the finest error. */
static double misfit_of(const struct judged *j, int onset, double q)
{
  const struct scallop_order_point *finest = &j->p[j->used - 1];
  const int first = onset > BEFORE ? onset - BEFORE : 0, n = j->used - first;
  if (n < BEFORE + 1 || n > MOST_SORTED)
    return NAN;
  double best = INFINITY;
  for (double power = q + LEAST_POWER; power <= MOST_POWER; power *= NEXT_POWER) {
    double cc = 0, cd = 0, dd = 0, c = 0, d = 0;
    for (const struct scallop_order_point *p = &j->p[first]; p <= finest; p++) {
      double x = p->h / finest->h, constant = pow(x, q) / fabs(p->err), falling = pow(x, power) / fabs(p->err);
      cc += falling * falling;
      cd += falling * constant;
      dd += constant * constant;
      c += falling;
      d += constant;
    }
    double C = (c * dd - d * cd) / (cc * dd - cd * cd), D = (d * cc - c * cd) / (cc * dd - cd * cd);
    if (C > 0 && D > fabs(finest->err) / 2)
      best = fmin(best, sqrt(fmax(0, n - C * c - D * d) / n));
  }
  return best;
}

/* Sizes of the errors of p[first..end) */
struct range {
  double least, most;
};

static struct range sizes(const struct judged *j, int first, int end)
{
  struct range r = { INFINITY, 0 };
  for (int i = first; i < end; i++) {
    r.least = fmin(r.least, fabs(j->p[i].err));
    r.most = fmax(r.most, fabs(j->p[i].err));
  }
  return r;
}

/* A floor: the rows p[onset..used) */
struct floor {
  int onset, rows;
  double least, level; /* smallest error; largest error at the start: roundoff may grow from there */
  bool rough;          /* an error is larger than one of a larger h                                         */
  bool dense;          /* the rows of the table are close on average */
  bool high, near_roundoff;
};

static struct floor floor_at(const struct judged *j, int onset)
{
  const int used = j->used, begins = onset + BEGINS;
  const double level = sizes(j, onset, begins < used ? begins : used).most, largest = sizes(j, 0, used).most;
  double least = INFINITY;
  bool rough = false;
  for (int i = onset; i < used; i++) {
    rough = rough || fabs(j->p[i].err) > least;
    least = fmin(least, fabs(j->p[i].err));
  }
  const bool dense = pow(APART, used - 1) * j->p[used - 1].h > j->p[0].h;
  struct floor found = {
    onset, used - onset, least, level, rough, dense, level > ROUGH * largest, level <= ROUNDOFF * fmax(1, largest)
  };
  return found;
}

/* Returns the largest of the used errors from first on over the smallest. */
static double spread(const struct judged *j, int first)
{
  struct range r = sizes(j, first, j->used);
  return r.most / r.least;
}

static bool is_plateau(const struct judged *j, const struct floor *f)
{
  double misfit = f->dense ? NAN : misfit_of(j, f->onset, 0);
  return !f->near_roundoff
         && (misfit < FITS || (!f->dense && spread(j, j->used - 3) <= LEVEL) /* a floor has two rows, and one before */
             || (f->high ? isnan(misfit) && spread(j, f->onset) <= SMOOTH
                         : f->rows > 2 && spread(j, f->onset) <= VERY_SMOOTH));
}

/* Returns true if the floor is a term of lower order that dominates. */
static bool is_lower_term(const struct judged *j, const struct floor *f)
{
  if (!f->rough && !f->near_roundoff)
    for (double q = 0.5; q <= MOST_LOWER; q += 0.5)
      if (misfit_of(j, f->onset, q) < FITS_WELL)
        return true;
  return false;
}

/* Leaves out the rows of the floor, and rows too near it. */
static void leave_out_floor(struct judged *j, const struct floor *f, bool smooth)
{
  int far = 0;
  for (int i = 0; i < f->onset; i++)
    far += fabs(j->p[i].err) >= ABOVE_FLOOR * f->level;
  bool few = !f->near_roundoff && !smooth && !f->dense && far < ENOUGH;
  for (int i = 0; i < j->used; i++)
    if (i >= f->onset || fabs(j->p[i].err) < (few ? NEAR_FLOOR : ABOVE_FLOOR) * f->level)
      j->p[i].use = SCALLOP_ORDER_FLOOR;
  points_sort_by_use(j);
  j->level = f->rough && !f->dense ? f->level : 0;
  j->near_floor = fmax(j->near_floor, f->rough ? FAR_ABOVE * f->level : 0);
}

bool floor_judge(struct judged *j, bool announced)
{
  j->near_floor = announced ? 0 : NEAR_ROUNDOFF;
  int onset = announced ? -1 : find_floor(j);
  if (onset < 0)
    return true;
  const struct floor f = floor_at(j, onset);
  bool smooth = is_plateau(j, &f);
  if (!smooth && is_lower_term(j, &f))
    return true;
  leave_out_floor(j, &f, smooth);
  int enough = !f.high ? 0 : f.dense ? f.rows + 1 : LEAST_TREND;
  if (f.near_roundoff || (!smooth && j->used >= enough))
    return true;
  j->result->verdict = smooth ? SCALLOP_ORDER_PLATEAU : SCALLOP_ORDER_FLOOR_LIMITED;
  reason_add(j, "err stops falling near %.2g", f.least);
  reason_add_rows(j, onset + reason_count(j, 0, SCALLOP_ORDER_ZERO), SCALLOP_ORDER_FLOOR); /* not the rows near it */
  reason_add(j, smooth    ? ": a plateau far above roundoff"
                : f.rough ? ": a rough floor, with too few rows above"
                          : ": a floor, with too few rows above");
  return false;
}

static bool is_candidate(const struct scallop_order_point *p)
{
  return p->use != SCALLOP_ORDER_FLOOR && p->use != SCALLOP_ORDER_ZERO;
}

bool floor_leave_out_near(struct judged *j)
{
  int candidates = 0, above = 0;
  for (int i = 0; i < j->count; i++)
    if (is_candidate(&j->p[i])) {
      candidates++;
      above += fabs(j->p[i].err) >= j->near_floor;
    }
  if (above < LEAST_TREND || above == candidates)
    return false;
  for (int i = 0; i < j->count; i++)
    if (is_candidate(&j->p[i]))
      j->p[i].use = fabs(j->p[i].err) >= j->near_floor ? SCALLOP_ORDER_USED : SCALLOP_ORDER_FLOOR;
  points_sort_by_use(j);
  *j->result->reason = '\0';
  return true;
}
