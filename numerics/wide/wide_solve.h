/* The walk (walk.h) in a type wider than double, from the parameters to the results: included once for each type, with
 *
 *     real          the type
 *     REAL_BITS     of its significand
 *     WIDE          what the solver at the end is called
 *
 *     real_sine, real_cosine     of 0 <= x < 1
 *
 * defined before. Not public. */
#include <math.h>
#include <stddef.h>

#include "numerics/event/motion.h"
#include "numerics/event/start.h"
#include "numerics/wide/wide.h"

/* 2^-REAL_BITS: half of the distance from 1 to the next number */
#define ROUNDING ((real)1 / (1LL << REAL_BITS / 2) / (1LL << (REAL_BITS - REAL_BITS / 2)))

#include "numerics/wide/wide_law.h"

typedef real root_function(const void *context, real u, real *slope);
struct root_end {
  real u, f, slope;
};

static real root_between(root_function *f, const void *context, struct root_end a, struct root_end b);

struct rate_search {
  const struct scallop_piece *piece;
  real wanted; /* of the derivative of |l'| with respect to u */
};

static real rate_beyond(const void *context, real u, real *slope)
{
  const struct rate_search *s = context;
  *slope = speed_derivative(s->piece, u, 2);
  return speed_derivative(s->piece, u, 1) - s->wanted;
}

static real walk_when(const struct scallop_piece *p, real a)
{
  const struct rate_search search = { p, law_sense(p) * p->direction * a };
  struct root_end begin = { .u = p->begin }, end = { .u = p->end };
  begin.f = rate_beyond(&search, begin.u, &begin.slope);
  end.f = rate_beyond(&search, end.u, &end.slope);
  const bool changes = (begin.f > 0) != (end.f > 0) || begin.f == 0 || end.f == 0;
  return changes ? root_between(rate_beyond, &search, begin, end) : NAN;
}

#define walk_show(walk, u, c) ((void)(walk), (void)(u), (void)(c)) /* nobody is told */
#include "numerics/event/walk.h"
#undef walk_show

/* Where to begin: at the root in double of the gap to a curve, or of l'' = a; else at the end that is nearer to it. */
static real near_root(root_function *f, const void *context, struct root_end a, struct root_end b)
{
  double lo = (double)(a.u < b.u ? a.u : b.u), hi = (double)(a.u < b.u ? b.u : a.u), u = NAN;
  if (f == gap_value) {
    const struct gap *g = context;
    const struct scallop_piece *p = g->walk->piece;
    double sense = (double)g->walk->sense, step = hi - lo, velocity, acceleration;
    u = magnitude(a.f) < magnitude(b.f) ? (double)a.u : (double)b.u;
    for (int i = 0; i < 12 && u >= lo && u <= hi && !(fabs(step) <= 4 * DBL_EPSILON * u); i++) {
      piece_rates(p, u, &velocity, &acceleration);
      double gap = (double)(g->walk->in->base + g->anchor) + (double)g->c_slope * (sense * u)
                   - (double)g->curve * p->direction * velocity;
      double slope = sense * ((double)g->c_slope - (double)g->curve * p->direction * acceleration);
      step = -gap / slope;
      u += step;
    }
  } else if (f == rate_beyond) {
    const struct rate_search *s = context;
    u = s->piece->curve->when(s->piece, law_sense(s->piece) * s->piece->direction * (double)s->wanted);
  }
  if (u > lo && u < hi)
    return u;
  return magnitude(a.f) < magnitude(b.f) ? a.u : b.u;
}

/* Newton's method in a bracket, which is halved where that leaves it or is slow. */
static real root_between(root_function *f, const void *context, struct root_end a, struct root_end b)
{
  if (a.f == 0 || b.f == 0)
    return a.f == 0 ? a.u : b.u;
  struct root_end p = { .u = near_root(f, context, a, b) };
  real before = a.u - b.u;
  for (int i = 0; i < 20000; i++) { /* of halvings towards 0, in a wide type's range of exponents */
    p.f = f(context, p.u, &p.slope);
    if (p.f == 0)
      break;
    *((p.f < 0) == (a.f < 0) ? &a : &b) = p;
    real step = -p.f / p.slope, next = p.u + step;
    bool slow = magnitude(step) > magnitude(before) / 2;
    /* nothing but rounding is left of it */
    if (magnitude(step) <= (slow ? 1024 : 2) * ROUNDING * magnitude(p.u))
      break;
    if (slow || (next > a.u) == (next > b.u)) {
      next = (a.u + b.u) / 2;
      step = next - p.u;
      if (next == a.u || next == b.u) /* rounding of f is more than that of u */
        break;
    }
    p.u = next;
    before = step;
  }
  return p.u;
}

struct wide_scaled { /* as in struct scallop_scaled                                                        */
  struct walk_input phase[2];
  real fraction[2], eps, velocity, driven;
};

/* shape->net with all its digits: the ends of pieces are exact. */
static real net_time(const struct scallop_shape *shape)
{
  real net = 0;
  for (int i = 0; i < shape->count; i++) {
    const struct scallop_piece *p = &shape->pieces[i];
    net += p->direction * (p->anchor == SCALLOP_FROM_START ? (real)p->end - p->begin : (real)p->begin - p->end);
  }
  return net;
}

static void scale(const struct scallop_crawler *c, struct wide_scaled *s)
{
  real M = (real)c->m1 + c->m2, F = (real)c->F1 + c->F2, T = c->T, L = c->L;
  s->fraction[0] = c->alpha;
  s->fraction[1] = 1 - (real)c->alpha;
  s->eps = T / L * T * F / M;
  s->velocity = L / T;
  s->driven = s->fraction[0] * net_time(&c->gait->phase[0]) + s->fraction[1] * net_time(&c->gait->phase[1]);
  for (int kind = 0; kind < 2; kind++)
    s->phase[kind] = (struct walk_input){ .shape = &c->gait->phase[kind],
                                          .mu1 = c->m1 / M,
                                          .mu2 = c->m2 / M,
                                          .f1 = c->F1 / F,
                                          .f2 = c->F2 / F,
                                          .delta = ((real)c->F1 - c->F2) / F,
                                          .eps = s->eps * s->fraction[kind] * s->fraction[kind] };
}

static struct scallop_wide split(real x)
{
  double high = (double)x;
  return (struct scallop_wide){ high, isfinite(high) ? (double)(x - high) : 0 };
}

/* As in phase.c: how far something comes, from the way whose parts cancel least. */
static real best_way(const struct walk_result *r, const real beyond[3], real *size)
{
  int best = 0;
  for (int i = 1; i < 3; i++)
    if (r->size[i] + magnitude(beyond[i]) < r->size[best] + magnitude(beyond[best]))
      best = i;
  *size = r->size[best] + magnitude(beyond[best]);
  return r->way[best] + beyond[best];
}

static void wide_phase(const struct scallop_crawler *c, enum scallop_phase_kind kind, double v0,
                       struct scallop_wide_phase *out)
{
  struct wide_scaled s;
  struct walk_result r;
  scale(c, &s);
  real unit = s.velocity / s.fraction[kind], tau = s.fraction[kind] * c->T, stroke = kind == SCALLOP_EXTENSION ? 1 : -1;
  const struct walk_input *in = &s.phase[kind];
  walk_phase(in, v0 / unit, NULL, &out->modes, &r);
  out->t1 = split(r.first_switch * tau);
  out->dT = split(r.last_switch * tau);
  out->v_end = split(r.c_end * unit);
  real middle = ((real)c->m1 - c->m2) / ((real)c->m1 + c->m2) / 2;
  const real beyond[3][3] = { { -stroke * in->mu2, 0, -stroke },
                              { stroke * in->mu1, stroke, 0 },
                              { stroke * middle, stroke / 2, -stroke / 2 } };
  struct scallop_wide *const way[3] = { &out->dx1, &out->dx2, &out->dxC };
  double *const sizes[3] = { &out->dx1_size, &out->dx2_size, &out->dxC_size };
  for (int i = 0; i < 3; i++) {
    real size;
    *way[i] = split(best_way(&r, beyond[i], &size) * c->L);
    *sizes[i] = (double)(size * c->L);
  }
  out->regime = r.never_moved[0] || r.never_moved[1] ? SCALLOP_AT_REST
                : r.sticks                           ? SCALLOP_STICK_SLIP
                                                     : SCALLOP_SLIDING;
}

struct wide_period {
  struct walk_result phase[2];
  real c_start, c_mid, c_end, balance, noise, slope; /* as in struct period                                       */
  bool forgets;
};

static void run_period(const struct wide_scaled *s, real c_start, struct scallop_modes modes[2], struct wide_period *p)
{
  real extra[2], slope[2];
  p->c_start = p->c_mid = p->c_end = c_start;
  for (int kind = 0; kind < 2; kind++) {
    real a = s->fraction[kind];
    p->c_mid = p->c_end;
    walk_phase(&s->phase[kind], p->c_mid * a, NULL, &modes[kind], &p->phase[kind]);
    p->c_end = p->phase[kind].c_end / a;
    extra[kind] = a * p->phase[kind].extra_impulse;
    slope[kind] = a * a * p->phase[kind].slope;
  }
  real driven = s->phase[0].delta * s->driven;
  p->forgets = p->phase[0].forgets || p->phase[1].forgets;
  p->balance = driven + extra[0] + extra[1];
  p->noise = (magnitude(driven) + magnitude(extra[0]) + magnitude(extra[1])) * ROUNDING;
  p->slope = slope[0] + slope[1] + s->eps * slope[0] * slope[1];
}

/* As in period.c: over a whole period all come equally far. */
static real travel_of(const struct walk_result phase[2], real *size)
{
  int best = 0;
  for (int i = 1; i < 3; i++)
    if (phase[0].size[i] + phase[1].size[i] < phase[0].size[best] + phase[1].size[best])
      best = i;
  *size = phase[0].size[best] + phase[1].size[best];
  return phase[0].way[best] + phase[1].way[best];
}

static void period_out(const struct scallop_crawler *c, const struct wide_scaled *s, const struct wide_period *p,
                       struct scallop_wide_period *out)
{
  real near_1 = 1 + s->eps * p->slope;
  bool never = false, sticks = p->phase[0].sticks || p->phase[1].sticks;
  for (int body = 0; body < 2; body++)
    never |= p->phase[0].never_moved[body] && p->phase[1].never_moved[body];
  out->v_start = split(p->c_start * s->velocity);
  out->v_mid = split(p->c_mid * s->velocity);
  out->v_end = split(p->c_end * s->velocity);
  real size;
  out->displacement = split(travel_of(p->phase, &size) * c->L);
  out->displacement_size = (double)(size * c->L);
  out->multiplier = split(p->forgets ? 0 : 2 * near_1 > 1 ? near_1 : p->phase[0].stretch * p->phase[1].stretch);
  out->regime = never ? SCALLOP_AT_REST : sticks ? SCALLOP_STICK_SLIP : SCALLOP_SLIDING;
}

static void wide_period(const struct scallop_crawler *c, double v0, struct scallop_wide_period *out)
{
  struct wide_scaled s;
  struct wide_period p;
  scale(c, &s);
  run_period(&s, v0 / s.velocity, out->modes, &p);
  period_out(c, &s, &p, out);
}

static bool settled(const struct wide_period *p)
{
  real change = p->forgets ? p->c_end - p->c_start : p->balance / p->slope;
  return magnitude(change) <= 2 * ROUNDING * magnitude(p->c_start)
         || (!p->forgets && magnitude(p->balance) <= p->noise);
}

/* Above the highest curve both bodies always move forward, below the lowest always backward. */
static real surely(const struct wide_scaled *s)
{
  return 2 * (s->phase[0].shape->peak / s->fraction[0] + s->phase[1].shape->peak / s->fraction[1] + s->eps);
}

/* Newton's method on the balance, or, once a body has been stuck, the map itself, inside a bracket from -high to high
 * that is halved where they are slow. False: neither ends. */
static bool find_steady(const struct wide_scaled *s, real c, real high, struct scallop_modes modes[2],
                        struct wide_period *p)
{
  real low = -high, last = 4 * high, before = last;
  bool found = false;
  for (int i = 0; i < 40000 && !found; i++) { /* the exponents of a wide type are halved no longer than that */
    run_period(s, c, modes, p);
    if (settled(p))
      return true;
    real change = p->forgets ? p->c_end - c : -p->balance / p->slope;
    *((p->forgets ? change : p->balance) > 0 ? &low : &high) = c;
    bool slow = magnitude(change) > before / 2;
    before = last;
    last = magnitude(change);
    real next = c + change;
    if (slow || !(next > low && next < high))
      next = low + (high - low) / 2;
    found = next == low || next == high;
    c = next;
  }
  if (found && !p->forgets && p->slope == 0) /* no root on this side of a kink */
    run_period(s, p->c_start == low ? high : low, modes, p);
  return found;
}

static real friction_work(const struct scallop_crawler *c, const struct wide_period *p)
{
  real work = 0;
  for (int kind = 0; kind < 2; kind++)
    work += c->F1 * p->phase[kind].path[0] + c->F2 * p->phase[kind].path[1];
  return work * c->L;
}

/* As in steady.c. */
static void find_from_level(const struct wide_scaled *s, struct scallop_modes modes[2], struct wide_period *p)
{
  const real c = p->c_start, rounding = 8 * ROUNDING, near = magnitude(c) / (1 << 19);
  const real reach = 2 * s->eps < near ? 2 * s->eps : near;
  for (int kind = 0; kind < 2; kind++) {
    real a = s->fraction[kind], b = s->fraction[1 - kind];
    real level = walk_level(&s->phase[kind], c * a, (reach + 8 * rounding * magnitude(c)) * a);
    if (level == 0)
      continue;
    real base = level / a, same = walk_level(&s->phase[1 - kind], base * b, rounding * magnitude(base * b));
    struct wide_scaled from_level = *s;
    struct scallop_modes these[2];
    struct wide_period q;
    from_level.phase[kind].base = level;
    from_level.phase[1 - kind].base = same != 0 ? same : base * b;
    if (find_steady(&from_level, 0, reach, these, &q) && 4 * magnitude(q.c_start) < 3 * reach
        && magnitude(q.c_mid) < 2 * reach) {
      q.c_start += base;
      q.c_mid += base;
      q.c_end += base;
      *p = q;
      modes[0] = these[0];
      modes[1] = these[1];
      return;
    }
  }
}

static bool wide_steady(const struct scallop_crawler *c, double guess, struct scallop_wide_steady *out)
{
  struct wide_scaled s;
  struct wide_period p;
  scale(c, &s);
  bool found = find_steady(&s, guess / s.velocity, surely(&s), out->period.modes, &p);
  find_from_level(&s, out->period.modes, &p);
  out->froude = split(1 / s.eps);
  period_out(c, &s, &p, &out->period);
  real size, travel = travel_of(p.phase, &size), work = friction_work(c, &p);
  out->mean_velocity = split(travel * s.velocity);
  out->friction_work = split(work);
  out->cost_of_transport = split(travel == 0 ? NAN : work / (((real)c->F1 + c->F2) * (magnitude(travel) * c->L)));
  return found;
}

const struct wide_solver WIDE = { wide_phase, wide_period, wide_steady };
