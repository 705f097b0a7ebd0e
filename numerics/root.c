#include "numerics/root.h"

#include <math.h>
#include <stdbool.h>
#include <stdalign.h>
#include <stddef.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

enum { NEWTON_STEPS = 8, BRENT_STEPS = 200, BRENT_STATE = 128 };

struct problem { root_function *f; const void *context; };

static double value(double u, void *params)
{
  const struct problem *p = params;
  return p->f(p->context, u, NULL);
}

/* GSL's Brent solver on a state of our own, so that nothing is allocated. */
static double brent(struct problem *problem, double a, double b)
{
  alignas(max_align_t) unsigned char state[BRENT_STATE];
  double lo = a < b ? a : b, hi = a < b ? b : a;
  gsl_function f = { value, problem };
  gsl_root_fsolver solver = { .type = gsl_root_fsolver_brent, .state = state };
  if (gsl_root_fsolver_brent->size > sizeof state || gsl_root_fsolver_set(&solver, &f, lo, hi) != GSL_SUCCESS)
    return NAN;
  for (int i = 0; i < BRENT_STEPS; i++) {
    if (gsl_root_fsolver_iterate(&solver) != GSL_SUCCESS)
      break;
    lo = gsl_root_fsolver_x_lower(&solver);
    hi = gsl_root_fsolver_x_upper(&solver);
    if (gsl_root_test_interval(lo, hi, 0, 1e-15) == GSL_SUCCESS)
      break;
  }
  return gsl_root_fsolver_root(&solver);
}

double root_between(root_function *f, const void *context, double a, double b)
{
  double slope_a, slope_b;
  double fa = f(context, a, &slope_a), fb = f(context, b, &slope_b);
  if (fa == 0)
    return a;
  if (fb == 0)
    return b;
  /* f'' has the sign of (slope_b - slope_a)/(b - a) */
  double curvature = b > a ? slope_b - slope_a : slope_a - slope_b;
  bool from_a = fa * curvature > 0;
  double u = from_a ? a : b, fu = from_a ? fa : fb, slope = from_a ? slope_a : slope_b;
  double lo = a < b ? a : b, hi = a < b ? b : a;
  for (int i = 0; i < NEWTON_STEPS; i++) {
    double next = fmin(fmax(u - fu / slope, lo), hi);
    double step = fabs(next - u);
    u = next;
    /* quadratic convergence: after a step below sqrt(ulp) the next one is below the last digit */
    fu = f(context, u, &slope);
    if (fu == 0 || slope == 0)
      return u;
    if (step <= 1e-9 * fabs(u))
      return fmin(fmax(u - fu / slope, lo), hi);
  }
  struct problem problem = { f, context };
  u = brent(&problem, a, b);
  fu = f(context, u, &slope);
  return slope != 0 ? fmin(fmax(u - fu / slope, lo), hi) : u;
}
