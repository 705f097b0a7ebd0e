#include "compare/maps/path.h"

#include <math.h>
#include <stddef.h>

static const double finest = 1e-16; /* of a bisection */

static void place(const struct path *p, double s, double *u, double *v)
{
  *u = p->arc ? p->u + p->a * cos(s) : p->u + s * p->a;
  *v = p->arc ? p->v + p->a * sin(s) : p->v + s * p->b;
}

int region_on(const struct square *square, const struct path *p, double s)
{
  double u, v;
  place(p, s, &u, &v);
  return u >= 0 && u <= 1 && v >= 0 && v <= 1 ? square->region(square->context, u, v) : MAP_NOWHERE;
}

static double length(const struct path *p) { return p->arc ? p->a : hypot(p->a, p->b); }

static void add_change(struct changes *c, const struct path *p, double at, int before, int after)
{
  struct change *last = c->count > 0 ? &c->list[c->count - 1] : NULL;
  if (last && last->after == before && (at - last->at) * length(p) <= MAP_THIN) { /* thin: a part of the curve */
    last->after = after;
    c->count -= last->before == after;
    return;
  }
  if (c->count == MOST_CHANGES)
    return;
  struct change new = { .at = at, .before = before, .after = after };
  place(p, at, &new.u, &new.v);
  c->list[c->count++] = new;
}

void find_changes(const struct square *square, const struct path *p, double s0, int before, double s1, int after,
                  struct changes *c)
{
  if (before == after)
    return;
  for (;;) {
    double middle = s0 + (s1 - s0) / 2;
    if (middle <= s0 || middle >= s1 || (s1 - s0) * length(p) <= finest) {
      add_change(c, p, s0, before, after);
      return;
    }
    int here = region_on(square, p, middle);
    if (here == before)
      s0 = middle;
    else if (here == after || (s1 - s0) * length(p) <= MAP_THIN / 2)
      s1 = middle;
    else {
      find_changes(square, p, s0, before, middle, here, c);
      s0 = middle;
      before = here;
    }
  }
}
