/* The root of a monotone function, for every floating type. Included as text, not public. The including file defines
 *
 *     real          the type
 *     ROUNDING      2^-bits of it: half of the distance from 1 to the next number */
#include <float.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* Returns f(u), and writes its derivative to *slope. */
typedef real root_function(const void *context, real u, real *slope);

struct root_end {
  real u, f, slope;
};

static inline real root_size(real x) { return x < 0 ? -x : x; }

/* Returns the number halfway between two numbers >= 0, in the order of the doubles: at most 64 bisections of any
 * interval of doubles, however small the numbers. A wider type also bisects within an ulp of a double. */
static inline real root_halfway(real a, real b)
{
  const double ends[2] = { (double)a, (double)b };
  uint64_t bits[2];
  memcpy(bits, ends, sizeof bits);
  bits[0] = bits[0] / 2 + bits[1] / 2 + (bits[0] & bits[1] & 1);
  double middle;
  memcpy(&middle, bits, sizeof middle);
  return (middle > a) != (middle > b) && middle != a && middle != b ? (real)middle : a + (b - a) / 2;
}

/* Returns the step from p to the zero of the inverse cubic through p and the point before it. No power of f is formed:
 * it could underflow. */
static inline real root_cubic_step(const struct root_end *p, const struct root_end *before)
{
  real d = p->f - before->f, steep = 1 / p->slope, part = p->f / d;
  real e = before->u - p->u + d * steep, g = d * (1 / before->slope - steep);
  return part * part * (3 * e + g - part * (g + 2 * e)) - p->f * steep;
}

/* Returns true if a step of inverse cubic interpolation ends at the root to all digits. Its error is about k^3 (step
 * last)^2, k the relative change of the slope per unit of u: large near a graze, and at least 1/u. */
static inline bool root_is_last(const struct root_end *p, const struct root_end *before, real step, real last)
{
  real k = root_size((p->slope - before->slope) / (last * p->slope)), least = 1 / root_size(p->u);
  k = k > least ? k : least;
  real error = (k * step) * (k * last);
  return error * error <= ROUNDING / 128 * (k * root_size(p->u));
}

/* Returns true if Newton's method starts better from the first end of the bracket: f f'' > 0 there, therefore no
 * overshoot; or, if f is straight, if |f| and with it the rounding of the step is smaller there. */
static inline bool root_begins_at(const struct root_end *a, const struct root_end *b)
{
  real bend = b->slope - a->slope;
  bool straight = root_size(bend) <= 0x1p13 * ROUNDING * root_size(a->slope);
  return straight ? root_size(a->f) < root_size(b->f) : (a->f > 0) == ((bend > 0) == (b->u > a->u));
}

static inline bool root_is_between(real u, real a, real b) { return (u > a) != (u > b) && u != a && u != b; }

/* Returns the root of f between a and b, both >= 0, to the last digit that f can resolve. Needs: f monotone, f(a) and
 * f(b) of opposite sign or zero; fastest if f does not change its curvature.
 *
 * Method: a step of Newton's method, then cubic interpolation of the inverse function through the last two points and
 * their slopes. The bracket is halved instead if a step leaves it, or after STEPS steps: near a graze f is nearly flat.
 */
static real root_between(root_function *f, const void *context, struct root_end a, struct root_end b)
{
  enum { STEPS = 12 };
  if (a.f == 0 || b.f == 0)
    return a.f == 0 ? a.u : b.u;
  struct root_end before, p = root_begins_at(&a, &b) ? a : b;
  real step = -p.f / p.slope;
  bool last = false;
  for (int i = 0;; i++) {
    real next = p.u + step;
    bool between = root_is_between(next, a.u, b.u);
    if (last || root_size(step) <= 8 * ROUNDING * root_size(p.u))
      return between ? next : p.u;
    if (!between || i > STEPS)
      next = root_halfway(a.u, b.u);
    if (next == a.u || next == b.u)
      return root_size(a.f) < root_size(b.f) ? a.u : b.u;
    before = p;
    p.u = next;
    p.f = f(context, p.u, &p.slope);
    if (p.f == 0)
      return p.u;
    *((p.f > 0) == (a.f > 0) ? &a : &b) = p;
    step = root_cubic_step(&p, &before);
    last = root_is_last(&p, &before, step, p.u - before.u);
  }
}
