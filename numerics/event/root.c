#include "numerics/event/root.h"

#include <math.h>
#include <stdbool.h>

#include "numerics/event/itp.h"

enum { STEPS = 12 };

struct problem {
  root_function *f;
  const void *context;
};

static double value(const struct problem *p, double u)
{
  double slope;
  return p->f(p->context, u, &slope);
}

/* From p towards the root: the cubic through p and the point before it, as u over f, at f = 0. Written so that no power
 * of f is formed, which could underflow. */
static double inverse_cubic_step(const struct root_end *p, const struct root_end *before)
{
  double d = p->f - before->f, steep = 1 / p->slope, part = p->f / d;
  double e = before->u - p->u + d * steep, g = d * (1 / before->slope - steep);
  return part * part * (3 * e + g - part * (g + 2 * e)) - p->f * steep;
}

/* Will a step of inverse cubic interpolation end at the root to all digits? Its error is about k^3 (step last)^2, with
 * k the relative change of the slope per unit of u, which is large near a graze and is 1/u at least. */
static bool is_last(const struct root_end *p, const struct root_end *before, double step, double last)
{
  double k = fmax(fabs((p->slope - before->slope) / (last * p->slope)), 1 / fabs(p->u));
  double error = (k * step) * (k * last);
  return error * error <= 1e-18 * (k * fabs(p->u));
}

static double clamp(double u, double a, double b)
{
  double lo = a < b ? a : b, hi = a < b ? b : a;
  return u < lo ? lo : u > hi ? hi : u;
}

/* The first of u a few ulp, 16 times that, and so on towards far at which f has no longer the sign that it has at u:
 * the root may be so near to 0 that halving the whole interval would not get there. */
static double beyond_root(const struct problem *problem, double u, double f, double far)
{
  for (double step = copysign(4 * DBL_EPSILON * fmax(fabs(u), DBL_MIN), far - u); fabs(step) < fabs(far - u);
       step *= 16)
    if ((value(problem, u + step) > 0) != (f > 0))
      return u + step;
  return far;
}

/* Between u and far f changes its sign. Where they are of different orders of magnitude the root is looked for by these
 * first: where f has hardly a slope at 0 it may be as near to that as a square root, and halving would be slow. Returns
 * the end opposite to *u, which becomes the end where f has the sign of f_u. */
static double same_magnitude(const struct problem *problem, double *u, double f_u, double far)
{
  const double far_apart = 0x1p40;
  if (!(fmax(*u, far) > far_apart * fmax(fmin(*u, far), DBL_MIN)))
    return far;
  while (fmax(*u, far) > 16 * fmax(fmin(*u, far), DBL_MIN)) {
    double middle = sqrt(*u > DBL_MIN ? *u : DBL_MIN) * sqrt(far > DBL_MIN ? far : DBL_MIN);
    *((value(problem, middle) > 0) == (f_u > 0) ? u : &far) = middle;
  }
  return far;
}

double root_between(root_function *f, const void *context, struct root_end a, struct root_end b)
{
  if (a.f == 0 || b.f == 0)
    return a.f == 0 ? a.u : b.u;
  bool straight = fabs(b.slope - a.slope) <= 0x1p-40 * fabs(a.slope);
  bool from_a = straight ? fabs(a.f) < fabs(b.f) /* the step that rounding does least to */
                         : (a.f > 0) == ((b.slope - a.slope > 0) == (b.u > a.u)); /* f f'' > 0 there */
  struct root_end before = from_a ? a : b, p = before;
  p.u = clamp(before.u - before.f / before.slope, a.u, b.u);
  double last_step = p.u - before.u;
  if (fabs(last_step)
      <= 4 * DBL_EPSILON
             * fabs(p.u)) /* so near to the root that the next step would divide by a difference of roundings */
    return p.u;
  int steps = 0;
  for (; steps < STEPS && p.u != before.u; steps++) { /* else the root is too near the end for a step to show */
    p.f = f(context, p.u, &p.slope);
    if (p.f == 0 || p.f == before.f || p.slope == 0)
      break;
    double step = inverse_cubic_step(&p, &before);
    double next = clamp(p.u + step, a.u, b.u);
    if (is_last(&p, &before, step, last_step))
      return next;
    before = p;
    last_step = next - p.u;
    p.u = next;
  }
  if (steps == STEPS) /* p.f is that of the step before, and may have the other sign */
    p.f = f(context, p.u, &p.slope);
  if (p.f == 0)
    return p.u;
  const struct problem problem = { f, context };
  double far = (p.f > 0) == (a.f > 0) ? b.u : a.u;
  far = beyond_root(&problem, p.u, p.f, far);
  far = same_magnitude(&problem, &p.u, p.f, far);
  p.u = itp_root(f, context, p.u, far);
  p.f = f(context, p.u, &p.slope);
  return p.slope != 0 ? clamp(p.u - p.f / p.slope, a.u, b.u) : p.u;
}
