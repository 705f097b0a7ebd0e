#include "numerics/event/ramps.h"

#include <math.h>
#include <stddef.h>

#include "model/scaling.h"

/* Regions and curves are those of motion.c. By symmetry c starts at or above 0 here: a motion that starts below is seen
 * in a mirror, which exchanges curve 0 with curve 1 and region 0 with region 2. */

/* All of it fits into registers once the functions below are one, which is why they are inline by force. */
struct progress {
  struct line line;
  double extra0, extra2; /* what regions 0 and 2 add to extra_impulse per unit of time              */
  double c, travel, size, extra_impulse, slope, stretch, first_switch, last_switch;
  unsigned trail, shift, events;
  bool held;
};
#define INLINE SCALLOP_INLINE

/* A state that lasts, from time t after the start and r before the end. */
INLINE void begin(struct progress *p, enum trail_state state, double t, double r)
{
  p->first_switch = p->shift == TRAIL_BITS ? t : p->first_switch;
  p->last_switch = p->shift > 0 ? r : p->last_switch;
  p->trail |= (unsigned)(state + 1) << p->shift;
  p->shift += TRAIL_BITS;
}

/* On along a straight line to velocity c. */
INLINE void slide(struct progress *p, double c, double duration, double extra)
{
  p->travel += 0.5 * (p->c + c) * duration;
  p->size += 0.5 * (fabs(p->c) + fabs(c)) * duration;
  p->extra_impulse += extra * duration;
  p->c = c;
}

/* On along a curve to velocity c; way: what |l'| covers meanwhile, q that of the curve. */
INLINE void hold(struct progress *p, double c, double q, double way)
{
  p->travel += q * way;
  p->size += fabs(q) * way;
  p->held = true;
  p->c = c;
}

/* A curve is crossed: along is its slope, where c' is `slope` before and `then` afterwards, and extra changes by
 * `change`. */
INLINE void cross(struct progress *p, double change, double slope, double then, double along)
{
  double x = change / (slope - along);
  p->stretch *= (then - along) / (slope - along);
  p->slope += x + p->line.eps * x * p->slope;
  p->events++;
}

/* The way up. False: too close to call. */

/* Between the curves from time t: c can only meet curve 1, and is then held by it. */
INLINE bool between_up(struct progress *p, const struct ramps *r, double t, enum trail_state *state)
{
  const struct line *s = &p->line;
  double d = r->top - t, c = p->c + s->between * d, steep = r->up * s->q1, floor = -steep * r->top;
  if (c > floor || s->between >= -steep) {
    begin(p, BETWEEN, t, 1 - t);
    *state = BETWEEN;
    slide(p, c, d, 0);
    return c != floor;
  }
  double u = (p->c - s->between * t) / (-s->between - steep);
  if (u > t) {
    begin(p, BETWEEN, t, 1 - t);
    slide(p, -steep * u, u - t, 0);
  } else if (t > 0) {
    return false;
  }
  begin(p, HELD_BELOW, u, 1 - u);
  *state = HELD_BELOW;
  hold(p, floor, -s->q1, 0.5 * r->up * (r->top - u) * (r->top + u));
  p->events++;
  return u < r->top;
}

INLINE bool go_up(struct progress *p, const struct ramps *r, enum trail_state *state)
{
  const struct line *s = &p->line;
  double steep = r->up * s->q0, t = p->c / (steep + s->eps);
  *state = ABOVE;
  if (p->c > 0)
    begin(p, ABOVE, 0, 1);
  if (t >= r->top) {
    slide(p, p->c - s->eps * r->top, r->top, p->extra0);
    return t > r->top;
  }
  slide(p, steep * t, t, p->extra0);
  if (steep > s->between) {
    cross(p, -p->extra0, -s->eps, s->between, steep);
    return between_up(p, r, t, state);
  }
  begin(p, HELD_ABOVE, t, 1 - t);
  *state = HELD_ABOVE;
  hold(p, steep * r->top, s->q0, 0.5 * r->up * (r->top - t) * (r->top + t));
  p->events++;
  return true;
}

/* The way down: times count back from the end. */

INLINE void held_to_end(struct progress *p, const struct ramps *r, double u, double q)
{
  hold(p, 0, q, 0.5 * r->down * (u * u));
}

/* Between the curves from u on: c meets the one on whose side it would end. */
INLINE bool between_down(struct progress *p, const struct ramps *r, double u)
{
  const struct line *s = &p->line;
  double end = p->c + s->between * u, q = end > 0 ? s->q0 : -s->q1, steep = r->down * q;
  double meets = end / (s->between + steep), sign = end > 0 ? 1 : -1;
  if (!(meets > 0 && meets < u))
    return false;
  slide(p, steep * meets, u - meets, 0);
  if (sign * steep > s->eps) {
    double extra = end > 0 ? p->extra0 : p->extra2;
    cross(p, extra, s->between, -sign * s->eps, -steep);
    begin(p, end > 0 ? ABOVE : BELOW, 1 - meets, meets);
    slide(p, p->c - sign * s->eps * meets, meets, extra);
    return true;
  }
  p->events++;
  begin(p, end > 0 ? HELD_ABOVE : HELD_BELOW, 1 - meets, meets);
  held_to_end(p, r, meets, q);
  return true;
}

INLINE bool above_down(struct progress *p, const struct ramps *r)
{
  const struct line *s = &p->line;
  double u = r->rest, end = p->c - s->eps * u, steep = r->down * s->q0;
  if (end > 0) {
    slide(p, end, u, p->extra0);
    return true;
  }
  double meets = end / (steep - s->eps);
  if (!(meets > 0 && meets < u))
    return false;
  slide(p, steep * meets, u - meets, p->extra0);
  if (-steep > s->between) {
    cross(p, -p->extra0, -s->eps, s->between, -steep);
    begin(p, BETWEEN, 1 - meets, meets);
    return between_down(p, r, meets);
  }
  p->events++;
  begin(p, HELD_ABOVE, 1 - meets, meets);
  held_to_end(p, r, meets, s->q0);
  return true;
}

/* The slope of the curve changes where l' begins to fall, and this can let the body go. */
INLINE bool held_down(struct progress *p, const struct ramps *r, bool above)
{
  const struct line *s = &p->line;
  double u = r->rest, steep = r->down * (above ? s->q0 : s->q1);
  if (above ? -steep > s->between : steep < s->between) {
    /* GCOVR_EXCL_START: never, with up and down > 0: a body is held on the way up where the slope of its curve, which
     * then changes its sign, lies between 0 and s->between */
    p->events++;
    begin(p, BETWEEN, r->top, u);
    return between_down(p, r, u);
    /* GCOVR_EXCL_STOP */
  }
  if (steep > s->eps) {
    p->events++;
    begin(p, above ? ABOVE : BELOW, r->top, u);
    slide(p, p->c + (above ? -s->eps : s->eps) * u, u, above ? p->extra0 : p->extra2);
    return true;
  }
  held_to_end(p, r, u, above ? s->q0 : -s->q1);
  return true;
}

INLINE bool go_down(struct progress *p, const struct ramps *r, enum trail_state state)
{
  switch (state) {
  case ABOVE: return above_down(p, r);
  case BETWEEN: return between_down(p, r, r->rest);
  case HELD_ABOVE:
  case HELD_BELOW: return held_down(p, r, state == HELD_ABOVE);
  case BELOW: break; /* not on the way up: GCOVR_EXCL_LINE */
  }
  return false; /* GCOVR_EXCL_LINE */
}

/* Region 0 to region 2 and back, curve 0 to curve 1 and back */
unsigned trail_mirrored(unsigned trail)
{
  static const unsigned char other[] = { 0, 1 + BELOW, 1 + BETWEEN, 1 + ABOVE, 1 + HELD_BELOW, 1 + HELD_ABOVE };
  unsigned out = 0;
  for (int shift = 0; trail >> shift; shift += TRAIL_BITS)
    out |= (unsigned)other[trail >> shift & TRAIL_MASK] << shift;
  return out;
}

void trail_modes(unsigned trail, enum scallop_phase_kind kind, struct scallop_modes *modes)
{
  static const struct scallop_mode mode[2][6] = {
    { { 0, 0 }, { 1, 1 }, { -1, 1 }, { -1, -1 }, { 0, 1 }, { -1, 0 } },
    { { 0, 0 }, { 1, 1 }, { 1, -1 }, { -1, -1 }, { 1, 0 }, { 0, -1 } },
  };
  int count = 0;
  for (; trail; trail >>= TRAIL_BITS)
    modes->kept[count++] = mode[kind][trail & TRAIL_MASK];
  modes->count = count;
}

bool ramps_solve(const struct motion_input *in, double c0, struct motion *motion)
{
  const struct ramps ramps = ramps_of(in->shape);
  bool rear_is_1 = in->shape->pieces[0].direction > 0, forward = c0 >= 0;
  double sign = forward ? 1 : -1;
  struct progress p = {
    .line = line_of(in, rear_is_1 == forward), .c = fabs(c0), .stretch = 1, .first_switch = NAN, .last_switch = NAN
  };
  p.extra0 = -2 * p.line.f_first;
  p.extra2 = 2 * p.line.f_second;
  enum trail_state state;
  if (!go_up(&p, &ramps, &state) || !go_down(&p, &ramps, state))
    return false;
  motion->c_end = sign * p.c + 0.0; /* no -0 */
  motion->travel = sign * p.travel;
  motion->size = p.size;
  motion->extra_impulse = sign * p.extra_impulse;
  motion->slope = p.slope;
  motion->stretch = p.stretch;
  motion->delicate = false;
  motion->forgets = motion->sticks = p.held;
  motion->first_switch = p.first_switch;
  motion->last_switch = p.last_switch;
  motion->trail = forward ? p.trail : trail_mirrored(p.trail);
  motion->never_moved[rear_is_1 ? 0 : 1] = motion->trail == 1 + HELD_ABOVE;
  motion->never_moved[rear_is_1 ? 1 : 0] = motion->trail == 1 + HELD_BELOW;
  motion->work = (struct scallop_work){ .events = p.events };
  return true;
}
