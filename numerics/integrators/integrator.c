#include "numerics/integrators/integrator.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include "numerics/integrators/integrator_phases.h"

enum {
  COMPARISONS = 16, /* with strides of one length; then they double */
  REVERSALS = 8,    /* of the direction in which the velocity creeps: one can be an accident of the steps */
  ITERATIONS = 200
};

void scallop_integrator_destroy(struct scallop_integrator *integrator)
{
  if (integrator)
    integrator->destroy(integrator);
}

struct fixed_point_search {
  struct scallop_integrator *integrator;
  const struct scallop_crawler *crawler;
  const struct scallop_patience *patience;
  struct scallop_integrator_steady at;
};

static bool good_tolerance(double tolerance) { return tolerance >= 0 && isfinite(tolerance); }

static enum scallop_status next_period(struct fixed_point_search *s, double v0,
                                       struct scallop_integrator_period *period)
{
  if (!integrator_patience_lasts(s->patience))
    return SCALLOP_ESTOPPED;
  enum scallop_status status = s->integrator->period(s->integrator, s->crawler, v0, s->patience, period);
  if (status != SCALLOP_OK)
    return status;
  s->at.periods++;
  s->at.steps += period->steps;
  s->at.evaluations += period->evaluations;
  s->at.events += period->events;
  return SCALLOP_OK;
}

/* Where patience ends a search, what it has found so far is its result. */
static enum scallop_status conclude(enum scallop_status status, const struct scallop_integrator_steady *found,
                                    struct scallop_integrator_steady *steady)
{
  if (status == SCALLOP_OK || status == SCALLOP_ESTOPPED)
    *steady = *found;
  return status == SCALLOP_ESTOPPED ? SCALLOP_STOPPED : status;
}

/* Changes of the start velocity, each over `stride` periods. */
struct watch {
  double mark;   /* velocity at the end of the last stride */
  double before; /* the last change, nan before the end of the first stride */
  long stride, since;
  int comparisons, reversals;
};

/* The most that is left to go after two changes that a geometric series may continue, each known to the noise. */
static double left(double change, double before, double noise)
{
  double m = (fabs(change) + noise) / fabs(before);
  return m < 1 ? fabs(change) * (m / (1 - m)) : INFINITY;
}

/* The end of a stride, with the velocity at v. */
static void next_stride(struct watch *w, double v)
{
  double change = v - w->mark;
  w->reversals += (change > 0 && w->before < 0) || (change < 0 && w->before > 0);
  w->since = 0;
  w->mark = v;
  if (++w->comparisons == COMPARISONS) {
    w->comparisons = 0;
    w->stride *= 2;
  }
  w->before = change;
}

/* Returns whether the velocity has settled to within `close`, or to the noise, after one more period from `from` to
 * v. */
static bool settled(struct watch *w, double from, double v, double close, double noise)
{
  if (v == from)
    return true;
  if (++w->since < w->stride)
    return false;
  double change = v - w->mark;
  bool near = fabs(v - from) <= close && left(change, w->before, noise) <= close;
  next_stride(w, v);
  return near || change == 0 || w->reversals == REVERSALS;
}

enum scallop_status scallop_integrator_simulate(struct scallop_integrator *integrator,
                                                const struct scallop_crawler *crawler, double v0, double tolerance,
                                                const struct scallop_patience *patience,
                                                struct scallop_integrator_steady *steady)
{
  struct fixed_point_search s = { integrator, crawler, patience, { .v_start = v0, .displacement = NAN } };
  struct watch w = { .mark = v0, .before = NAN, .stride = 1 };
  struct scallop_integrator_period period;
  struct scallop_scaled scaled;
  enum scallop_status status = scallop_scale(crawler, &scaled);
  if (status != SCALLOP_OK)
    return status;
  if (!isfinite(v0) || !good_tolerance(tolerance))
    return SCALLOP_EDOMAIN;
  for (bool done = false; !done;) {
    double from = s.at.v_start;
    status = next_period(&s, from, &period);
    if (status != SCALLOP_OK)
      break;
    double size = scaled.velocity + fabs(period.v_end);
    s.at.v_start = period.v_end;
    s.at.displacement = period.displacement;
    done = settled(&w, from, period.v_end, tolerance * size, 8 * DBL_EPSILON * size);
  }
  return conclude(status, &s.at, steady);
}

/* The computed map at a start velocity. */
struct tried {
  double v0, change, displacement;
};

struct root_search {
  struct fixed_point_search search;
  enum scallop_status status;
  int count;
  struct tried tried[ITERATIONS + 2]; /* the ends of the bracket come first */
};

static double change(double v0, void *context)
{
  struct root_search *r = context;
  struct scallop_integrator_period period;
  r->status = next_period(&r->search, v0, &period);
  if (r->status != SCALLOP_OK)
    return NAN; /* at which GSL's solver ends */
  r->tried[r->count++] = (struct tried){ v0, period.v_end - v0, period.displacement };
  return period.v_end - v0;
}

/* Beyond these both bodies move the same way whatever l' does, and friction slows them down. */
static void bracket(const struct scallop_scaled *s, double *lo, double *hi)
{
  double e = s->gait->phase[SCALLOP_EXTENSION].peak / s->fraction[SCALLOP_EXTENSION];
  double c = s->gait->phase[SCALLOP_CONTRACTION].peak / s->fraction[SCALLOP_CONTRACTION];
  const double margin = 1.01; /* an integrator must see it too */
  *lo = -margin * s->velocity * fmax(s->mu1 * e, s->mu2 * c);
  *hi = margin * s->velocity * fmax(s->mu2 * e, s->mu1 * c);
}

/* Records v and its displacement if v is a velocity that Brent's method tried. */
static void take(struct root_search *r, double v)
{
  for (int i = 0; i < r->count; i++)
    if (r->tried[i].v0 == v) {
      r->search.at.v_start = v;
      r->search.at.displacement = r->tried[i].displacement;
    }
}

static enum scallop_status iterate(struct root_search *r, gsl_root_fsolver *solver, double tolerance, double unit)
{
  for (int i = 0; i < ITERATIONS; i++) {
    double v = gsl_root_fsolver_root(solver);
    double width = gsl_root_fsolver_x_upper(solver) - gsl_root_fsolver_x_lower(solver);
    take(r, v);
    if (width <= fmax(tolerance, DBL_EPSILON) * (unit + fabs(v)))
      return SCALLOP_OK;
    if (gsl_root_fsolver_iterate(solver) != GSL_SUCCESS)
      return SCALLOP_ECONVERGE;
    r->search.at.root_iterations++;
  }
  return SCALLOP_ECONVERGE; /* GCOVR_EXCL_LINE: Brent's method ends before ITERATIONS */
}

/* Friction slows a crawler down that is faster than anything can drive it. If the map does not show it, its errors are
 * larger than what friction does in a period, and a root of it would mean nothing. */
static enum scallop_status find_root(struct root_search *r, double lo, double hi, double tolerance, double unit)
{
  gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
  gsl_function f = { change, r };
  enum scallop_status status = SCALLOP_ECONVERGE;
  if (solver && gsl_root_fsolver_set(solver, &f, lo, hi) == GSL_SUCCESS && r->tried[0].change > 0
      && r->tried[1].change < 0)
    status = iterate(r, solver, tolerance, unit);
  if (solver)
    gsl_root_fsolver_free(solver);
  return r->status != SCALLOP_OK ? r->status : status;
}

enum scallop_status scallop_integrator_root(struct scallop_integrator *integrator,
                                            const struct scallop_crawler *crawler, double tolerance,
                                            const struct scallop_patience *patience,
                                            struct scallop_integrator_steady *steady)
{
  struct root_search r = { .search = { integrator, crawler, patience, { .v_start = NAN, .displacement = NAN } } };
  struct scallop_scaled scaled;
  double lo, hi;
  enum scallop_status status = scallop_scale(crawler, &scaled);
  if (status != SCALLOP_OK)
    return status;
  if (!good_tolerance(tolerance))
    return SCALLOP_EDOMAIN;
  bracket(&scaled, &lo, &hi);
  if (!isfinite(lo) || !isfinite(hi))
    return SCALLOP_ERANGE;
  return conclude(find_root(&r, lo, hi, tolerance, scaled.velocity), &r.search.at, steady);
}
