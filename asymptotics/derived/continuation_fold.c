/* Branch points. With v_p as the parameter t all functions are analytic in t, also z; the branch, as a function of z,
 * is not analytic at z'(t) = 0. */
#include <math.h>

#include "asymptotics/derived/continuation.h"
#include "asymptotics/derived/scoped.h"

enum { NEIGHBOURHOOD_BITS = 64 };

void fold_init(struct fold *f, const struct continuation *c)
{
  *f = (struct fold){ .c = c };
  f->v = _acb_vec_init(c->n + 1);
  f->first = _acb_vec_init(c->n + 1);
  f->around = _acb_vec_init(c->n + 1);
}

void fold_clear(struct fold *f)
{
  _acb_vec_clear(f->v, f->c->n + 1);
  _acb_vec_clear(f->first, f->c->n + 1);
  _acb_vec_clear(f->around, f->c->n + 1);
}

/* Returns the coordinate that changes most with z. */
static slong steepest(acb_srcptr first, slong n)
{
  slong best = 0;
  SCOPED(mag, most, here);
  for (slong j = 0; j < n; j++) {
    acb_get_mag(here, first + j);
    if (mag_cmp(here, most) > 0) {
      mag_set(most, here);
      best = j;
    }
  }
  return best;
}

/* Encloses v and both derivatives for the ball in v[p]. */
static bool enclose(struct fold *f, acb_t second, slong precision)
{
  return continuation_enclose(f->v, f->around, f->c, f->p, precision)
         && continuation_derivatives(f->first, second, f->c, f->v, f->p, precision);
}

static double size_of(const acb_t z)
{
  SCOPED(mag, size);
  acb_get_mag(size, z);
  return mag_get_d(size);
}

/* Iterates t -= z'/z'' until the step is negligible; v, first and second are then computed there. */
static bool approach(struct fold *f, acb_t second, double far, slong precision)
{
  enum { STEPS = 40 };
  SCOPED(acb, step, began);
  acb_get_mid(began, f->v + f->c->n);
  for (int i = 0; i < STEPS; i++) {
    acb_get_mid(f->v + f->p, f->v + f->p);
    if (!enclose(f, second, precision))
      return false; /* GCOVR_EXCL_LINE: balls too wide */
    acb_sub(step, f->v + f->c->n, began, precision);
    if (!(size_of(step) < far))
      return false;
    acb_div(step, f->first + f->c->n, second, precision);
    if (!acb_is_finite(step))
      return false; /* GCOVR_EXCL_LINE: balls too wide */
    if (size_of(step) < ldexp(1, -(int)precision / 2))
      return true;
    acb_sub(f->v + f->p, f->v + f->p, step, precision);
  }
  return false;
}

/* Proves the fold by Newton's interval operator for z' in a ball of t: t - z'(t)/z''(ball) lies inside it, and contains
 * the only zero of z'. */
static bool prove(struct fold *f, acb_t second, slong precision)
{
  SCOPED(acb, zero, rate);
  SCOPED(mag, size);
  acb_set(zero, f->v + f->p);
  acb_set(rate, f->first + f->c->n);
  mag_set_ui_2exp_si(size, 1, -precision / 3);
  acb_add_error_mag(f->v + f->p, size);
  if (!enclose(f, second, precision))
    return false; /* GCOVR_EXCL_LINE: balls too wide */
  acb_div(rate, rate, second, precision);
  acb_sub(zero, zero, rate, precision);
  if (!acb_is_finite(zero) || !acb_contains_interior(f->v + f->p, zero))
    return false; /* GCOVR_EXCL_LINE: balls too wide */
  acb_set(f->v + f->p, zero);
  return enclose(f, second, precision);
}

/* Returns size^2/2 times the lower bound of the ball |z''| over the square |Re t|, |Im t| <= size around the branch
 * point; 0: not proven to be positive. A ball is convex, therefore it contains the mean of z'' in the remainder of
 * Taylor's theorem, and |z - z*| is at least this at distance size. */
static double clearance(acb_ptr around, const struct fold *f, double size)
{
  slong n = f->c->n;
  SCOPED_BALLS(v, n + 1);
  SCOPED_BALLS(first, n + 1);
  SCOPED(acb, second);
  SCOPED(arf, least);
  SCOPED(mag, half);
  _acb_vec_set(v, f->v, n + 1);
  mag_set_d(half, size);
  acb_add_error_mag(v + f->p, half);
  if (continuation_enclose(v, around, f->c, f->p, NEIGHBOURHOOD_BITS)
      && continuation_derivatives(first, second, f->c, v, f->p, NEIGHBOURHOOD_BITS))
    acb_get_abs_lbound_arf(least, second, NEIGHBOURHOOD_BITS);
  return fmax(0,
              arf_get_d(least, ARF_RND_DOWN) * size * size / 2 * (1 - 0x1p-20)); /* t* is known much more accurately */
}

/* Chooses the size with the largest clearance, of 2, 1, 1/2, ... */
static bool set_neighbourhood(struct fold *f)
{
  enum { LARGEST = 1, SMALLEST = -20 };
  SCOPED_BALLS(around, f->c->n + 1);
  f->clear = 0;
  for (int i = LARGEST; i >= SMALLEST; i--) {
    double size = ldexp(1, i), clear = clearance(around, f, size);
    if (clear > 0 && clear < f->clear)
      break;
    if (clear > f->clear) {
      f->clear = clear;
      f->size = size;
      _acb_vec_swap(f->around, around, f->c->n + 1);
    }
  }
  return f->clear > 0;
}

bool fold_find(struct fold *f, acb_srcptr v, double far, slong precision)
{
  SCOPED(acb, second);
  _acb_vec_set(f->v, v, f->c->n + 1);
  if (!continuation_derivatives(f->first, second, f->c, f->v, f->c->n, precision))
    return false; /* GCOVR_EXCL_LINE: balls too wide */
  f->p = steepest(f->first, f->c->n);
  return approach(f, second, far, precision) && prove(f, second, precision) && set_neighbourhood(f);
}

bool fold_holds(const struct fold *f, acb_srcptr v)
{
  SCOPED(acb, way);
  acb_sub(way, v + f->p, f->v + f->p, NEIGHBOURHOOD_BITS);
  for (slong j = 0; j <= f->c->n; j++)
    if (j != f->p && !acb_contains(f->around + j, v + j))
      return false;
  return size_of(way) < f->size;
}
