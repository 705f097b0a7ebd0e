/* Curves between regions of a square, of which nothing is known but which region a point belongs to.
 *
 * A curve is found where it crosses a line of a grid. From a point p of it the next one is sought on the circle around
 * p: with the region A on the left and B on the right, the circle passes from B to A where the curve leaves it. That
 * angle is predicted from the last two secants, bracketed, and bisected. The radius is halved where the curve turns
 * more than it should, or where a third region shows: so p comes to within MAP_NEAR of a junction, or of the edge of
 * the square. A region that is thinner than MAP_THIN, such as a line on which a symmetry holds, is a part of the curve.
 *
 * Where a third region is first seen, the changes on the arc are the beginnings of further curves; a beginning that
 * lies on a known curve is none. A region that has no node of the grid in a line, and meets no curve that is found, is
 * missed. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/maps/curves.h"
#include "compare/text/memory.h"
#include "numerics/threads.h"

enum { AROUND = 32, MOST_POINTS = 100000, MOST_CURVES = 10000, MOST_BATCH = 64 };

static const double pi = 3.14159265358979323846;
static const double most_turn = 0.2,
                    least_turn = 0.05; /* between two secants, in radians                             */
static const double corner = 1e-7;     /* steps so small may turn by any angle                           */
static const double same_place = 1e-8; /* two points that should be one, when both have been bisected      */

struct tracer {
  struct square square;
  double step;
  struct map_curves *curves;
  struct change *seeds;
  long seed_count;
  bool out_of_memory;
};

static void add_seed(struct tracer *t, const struct change *c)
{
  if (c->before == MAP_NOWHERE || c->after == MAP_NOWHERE)
    return;
  struct change *seeds = with_room(t->seeds, t->seed_count, sizeof *seeds);
  if (!seeds) {
    t->out_of_memory = true;
    return;
  }
  t->seeds = seeds;
  t->seeds[t->seed_count++] = *c;
}

static void add_seeds(struct tracer *t, const struct change *list, long count)
{
  for (long i = 0; i < count; i++)
    add_seed(t, &list[i]);
}

/* Line i of a grid with so many cells: not at even fractions, where symmetries hold more often than elsewhere, and a
 * little inside. */
static double grid_line(int i, int cells)
{
  return i == 0 ? MAP_NEAR : i == cells ? 1 - MAP_NEAR : (i + 0.0618) / (cells + 0.1);
}

/* Where the lines along u, or along v, change their region: at the nodes of the grid and between. */
static void seed_lines(struct tracer *t, bool along_u, int along, int across)
{
  for (int j = 0; j <= across; j++) {
    double fixed = grid_line(j, across);
    struct changes c = { .count = 0 };
    const struct path p = along_u ? (struct path){ .v = fixed, .a = 1 } : (struct path){ .u = fixed, .b = 1 };
    double s0 = grid_line(0, along);
    int before = region_on(&t->square, &p, s0);
    for (int i = 1; i <= along; i++) {
      double s1 = grid_line(i, along);
      int after = region_on(&t->square, &p, s1);
      c.count = 0;
      find_changes(&t->square, &p, s0, before, s1, after, &c);
      add_seeds(t, c.list, c.count);
      s0 = s1;
      before = after;
    }
  }
}

enum outcome { STEP_DONE, STEP_THIRD, STEP_LOST };

struct step {
  double u, v, angle, radius; /* from a point of the curve, as it goes: the last secant's angle         */
  double bend, last;          /* by how much that changes with the length; and the last radius         */
  int left, right;
  struct change next;     /* STEP_DONE                                                          */
  int third;              /* STEP_THIRD: what shows                                             */
  struct changes changes; /* on the arc                                                      */
};

static bool is_third(const struct step *s, int region)
{
  return region != s->left && region != s->right && region != MAP_NOWHERE;
}

/* The third region in the changes of an arc, or MAP_NOWHERE. */
static int third_of(const struct step *s)
{
  for (int i = 0; i < s->changes.count; i++)
    if (is_third(s, s->changes.list[i].after))
      return s->changes.list[i].after;
  return MAP_NOWHERE;
}

/* The angle of the next secant: secants have the directions of the curve at their middles. */
static double predicted(const struct step *s) { return s->angle + s->bend * (s->last + s->radius) / 2; }

/* Near the end of a curve nothing new is to be found. */
static bool gives_seeds(const struct tracer *t, const struct step *s) { return s->radius > t->step / 16; }

/* The bracket begins narrow, so that a region that is near but not met is not seen. */
static enum outcome take_step(const struct tracer *t, struct step *s)
{
  const struct path arc = { .arc = true, .u = s->u, .v = s->v, .a = s->radius };
  const double ahead = predicted(s);
  for (double width = 1e-6; width < pi; width *= 8) {
    double from = ahead - width, to = ahead + width;
    int right = region_on(&t->square, &arc, from), left = region_on(&t->square, &arc, to);
    bool known = (right == s->left || right == s->right) && (left == s->left || left == s->right);
    if (known && (right != s->right || left != s->left))
      continue;
    s->changes.count = 0;
    if (known || gives_seeds(t, s))
      find_changes(&t->square, &arc, from, right, to, left, &s->changes);
    if (known && s->changes.count == 1) {
      s->next = s->changes.list[0];
      return STEP_DONE;
    }
    s->third = is_third(s, right) ? right : is_third(s, left) ? left : third_of(s);
    return s->third == MAP_NOWHERE ? STEP_LOST : STEP_THIRD;
  }
  return STEP_LOST;
}

static double to_edge(double x) { return x < 0.5 ? x : 1 - x; }
static bool is_at_edge(double u, double v) { return fmin(to_edge(u), to_edge(v)) < 20 * MAP_NEAR; }

static bool add_point(struct tracer *t, struct map_curve *c, double u, double v)
{
  struct map_point *points = c->count < MOST_POINTS ? with_room(c->points, c->count, sizeof *points) : NULL;
  if (!points) {
    t->out_of_memory |= c->count < MOST_POINTS;
    return false;
  }
  c->points = points;
  c->points[c->count++] = (struct map_point){ .u = u, .v = v, .end = MAP_GOES_ON, .third = MAP_NOWHERE };
  return true;
}

/* Puts the last point, which is near an edge, onto it, if the same two regions meet there. */
static void reach_edge(struct tracer *t, struct map_curve *c)
{
  const struct map_point last = c->points[c->count - 1];
  bool across_u = to_edge(last.u) < to_edge(last.v);
  double edge = (across_u ? last.u : last.v) < 0.5 ? 0 : 1, here = across_u ? last.v : last.u, reach = 100 * MAP_NEAR;
  const struct path p = across_u ? (struct path){ .u = edge, .v = here, .b = 1 }
                                 : (struct path){ .u = here, .v = edge, .a = 1 };
  int before = region_on(&t->square, &p, -reach), after = region_on(&t->square, &p, reach);
  struct changes found = { .count = 0 };
  if ((before == c->left && after == c->right) || (before == c->right && after == c->left))
    find_changes(&t->square, &p, -reach, before, reach, after, &found);
  if (found.count == 1) {
    c->points[c->count - 1].u = found.list[0].u;
    c->points[c->count - 1].v = found.list[0].v;
  }
}

static bool is_back(const struct tracer *t, const struct step *s, double u0, double v0)
{
  double du = u0 - s->u, dv = v0 - s->v, distance = hypot(du, dv);
  double off = remainder(atan2(dv, du) - s->angle, 2 * pi);
  if (!(distance > 0) || distance > s->radius || fabs(off) > 1)
    return false;
  struct step back = *s;
  back.radius = distance;
  return take_step(t, &back) == STEP_DONE && hypot(back.next.u - u0, back.next.v - v0) < same_place;
}

/* Goes on to the point that the step has found, by this turn. */
static void advance(const struct tracer *t, struct step *s, double turn)
{
  bool bends = s->last > 0 && fabs(turn) <= most_turn;
  s->bend = bends ? turn / ((s->last + s->radius) / 2) : 0;
  s->last = s->radius;
  s->u = s->next.u;
  s->v = s->next.v;
  s->angle = s->next.at;
  if (fabs(turn) <= least_turn)
    s->radius = fmin(2 * s->radius, t->step);
}

static struct step step_from(const struct map_curve *c, const struct map_point *p, double angle, double radius)
{
  return (struct step){
    .u = p->u, .v = p->v, .angle = angle, .radius = radius, .left = c->left, .right = c->right, .third = MAP_NOWHERE
  };
}

/* From the last point in the direction of angle to the end, which becomes that of the last point. */
static void follow(struct tracer *t, struct map_curve *c, double angle, double radius)
{
  struct step own = step_from(c, &c->points[c->count - 1], angle, radius), *s = &own;
  const double u0 = s->u, v0 = s->v;
  enum map_end end = MAP_GOES_ON;
  while (end == MAP_GOES_ON) {
    if (c->count > 3 && is_back(t, s, u0, v0)) {
      add_point(t, c, u0, v0);
      end = MAP_CLOSED;
      break;
    }
    enum outcome outcome = take_step(t, s);
    double turn = outcome == STEP_DONE ? remainder(s->next.at - s->angle, 2 * pi) : 0;
    if (outcome == STEP_DONE && (fabs(turn) <= most_turn || s->radius <= corner)) {
      advance(t, s, turn);
      if (!add_point(t, c, s->u, s->v))
        end = MAP_STOPS;
      continue;
    }
    if (outcome == STEP_THIRD && gives_seeds(t, s))
      add_seeds(t, s->changes.list, s->changes.count);
    s->radius /= 2;
    if (s->radius < MAP_NEAR)
      end = is_at_edge(s->u, s->v) ? MAP_OPEN : outcome == STEP_THIRD ? MAP_JUNCTION : MAP_STOPS;
  }
  c->points[c->count - 1].end = end;
  c->points[c->count - 1].third = end == MAP_JUNCTION ? s->third : MAP_NOWHERE;
}

/* The angles at which the curve leaves a small circle around a point of it: angle[0] with the region after of the seed
 * on the left, angle[1] with it on the right; nan: it does not. False: there are other regions in it, or more than one
 * curve. */
static bool find_ways(const struct tracer *t, const struct change *seed, double radius, double angle[2])
{
  const struct path circle = { .arc = true, .u = seed->u, .v = seed->v, .a = radius };
  struct changes c = { .count = 0 };
  double s0 = 0.1;
  int first = region_on(&t->square, &circle, s0), before = first;
  for (int i = 1; i <= AROUND; i++) {
    double s1 = 0.1 + 2 * pi * i / AROUND;
    int after = i == AROUND ? first : region_on(&t->square, &circle, s1);
    find_changes(&t->square, &circle, s0, before, s1, after, &c);
    s0 = s1;
    before = after;
  }
  angle[0] = angle[1] = NAN;
  for (const struct change *here = c.list; here < c.list + c.count; here++) {
    bool backward = here->before == seed->after && here->after == seed->before;
    bool along = backward || (here->before == seed->before && here->after == seed->after);
    bool to_outside = here->before == MAP_NOWHERE || here->after == MAP_NOWHERE;
    if (along ? !isnan(angle[backward]) : !to_outside)
      return false;
    if (along)
      angle[backward] = here->at;
  }
  int ways = !isnan(angle[0]) + !isnan(angle[1]);
  return ways == 2 || (ways == 1 && is_at_edge(seed->u, seed->v));
}

/* Across the curve to the left, from the points beside each. */
static void set_normals(struct map_curve *c)
{
  for (long i = 0; i < c->count; i++) {
    const struct map_point *a = &c->points[i > 0 ? i - 1 : 0], *b = &c->points[i + 1 < c->count ? i + 1 : i];
    double du = b->u - a->u, dv = b->v - a->v, size = hypot(du, dv);
    c->points[i].nu = size > 0 ? -dv / size : 0;
    c->points[i].nv = size > 0 ? du / size : 0;
  }
}

void map_curve_reverse(struct map_curve *c)
{
  int left = c->left;
  c->left = c->right;
  c->right = left;
  for (long i = 0, j = c->count - 1; i < j; i++, j--) {
    struct map_point point = c->points[i];
    c->points[i] = c->points[j];
    c->points[j] = point;
  }
  set_normals(c);
}

/* False: no curve leaves this point, or no memory is left. */
static bool trace(struct tracer *t, const struct change *seed, struct map_curve *c)
{
  double angle[2], radius = t->step / 8;
  *c = (struct map_curve){ .left = seed->before, .right = seed->after };
  while (!find_ways(t, seed, radius, angle)) {
    radius /= 4;
    if (radius < MAP_NEAR)
      return false;
  }
  if (!add_point(t, c, seed->u, seed->v))
    return false;
  if (!isnan(angle[1]))
    follow(t, c, angle[1], radius);
  map_curve_reverse(c);
  enum map_end first = isnan(angle[1]) ? MAP_OPEN : c->points[0].end;
  if (!isnan(angle[0]) && first != MAP_CLOSED)
    follow(t, c, angle[0], radius);
  else
    c->points[c->count - 1].end = first == MAP_CLOSED ? MAP_CLOSED : MAP_OPEN;
  c->points[0].end = first;
  for (int turned = 0; turned < 2; turned++) {
    if (c->points[c->count - 1].end == MAP_OPEN)
      reach_edge(t, c);
    map_curve_reverse(c);
  }
  return true;
}

/* Is the seed on the curve between point i and the next? */
static bool is_between(const struct tracer *t, const struct map_curve *c, long i, const struct change *seed)
{
  const struct map_point *p = &c->points[i], *q = &c->points[i + 1];
  double du = q->u - p->u, dv = q->v - p->v, size = hypot(du, dv);
  double su = seed->u - p->u, sv = seed->v - p->v, radius = hypot(su, sv);
  if (radius < same_place || hypot(seed->u - q->u, seed->v - q->v) < same_place)
    return true;
  if (su * du + sv * dv < 0 || radius > 1.1 * size || fabs(su * dv - sv * du) > 0.3 * size * size)
    return false;
  struct step s = step_from(c, p, atan2(dv, du), radius);
  return take_step(t, &s) == STEP_DONE && hypot(s.next.u - seed->u, s.next.v - seed->v) < same_place;
}

static bool same_pair(int a, int b, int c, int d) { return (a == c && b == d) || (a == d && b == c); }

static bool is_known(const struct tracer *t, const struct change *seed)
{
  for (long k = 0; k < t->curves->count; k++) {
    const struct map_curve *c = &t->curves->curves[k];
    bool same = same_pair(c->left, c->right, seed->before, seed->after);
    for (long i = 0; same && i + 1 < c->count; i++)
      if (is_between(t, c, i, seed))
        return true;
  }
  return false;
}

static void add_curve(struct tracer *t, const struct map_curve *c)
{
  struct map_curves *all = t->curves;
  struct map_curve *curves = with_room(all->curves, all->count, sizeof *curves);
  if (!curves) {
    t->out_of_memory = true;
    free(c->points);
    return;
  }
  all->curves = curves;
  all->curves[all->count++] = *c;
}

/* Curves between different pairs of regions are different: one seed of each pair. Seeds on curves that are known, or
 * that have been taken, go; the others stay. */
static long take_batch(struct tracer *t, struct change batch[MOST_BATCH])
{
  long count = 0, left = 0;
  for (long i = 0; i < t->seed_count; i++) {
    const struct change *seed = &t->seeds[i];
    bool waits = count == MOST_BATCH;
    for (long k = 0; k < count && !waits; k++)
      waits = same_pair(batch[k].before, batch[k].after, seed->before, seed->after);
    if (waits)
      t->seeds[left++] = *seed;
    else if (!is_known(t, seed))
      batch[count++] = *seed;
  }
  t->seed_count = left;
  return count;
}

/* Traces one curve of each pair of regions, on all cores; false where there is none left, or no memory. What is found
 * does not depend on the number of threads. */
static bool do_round(struct tracer *t)
{
  struct change batch[MOST_BATCH];
  struct map_curve curves[MOST_BATCH];
  struct tracer own[MOST_BATCH];
  bool traced[MOST_BATCH];
  long count = take_batch(t, batch);
#pragma omp parallel for schedule(dynamic) num_threads(threads_for(0, count))
  for (long k = 0; k < count; k++) {
    own[k] = (struct tracer){ .square = t->square, .step = t->step };
    traced[k] = trace(&own[k], &batch[k], &curves[k]);
  }
  for (long k = 0; k < count; k++) {
    add_seeds(t, own[k].seeds, own[k].seed_count);
    free(own[k].seeds);
    t->out_of_memory |= own[k].out_of_memory;
    if (traced[k])
      add_curve(t, &curves[k]);
    else
      t->curves->lost++;
  }
  return count > 0 && !t->out_of_memory && t->curves->count < MOST_CURVES;
}

bool map_follow(map_region *region, void *context, int columns, int rows, double step, struct map_curves *curves)
{
  struct tracer t = { .square = { region, context }, .step = step, .curves = curves };
  *curves = (struct map_curves){ .count = 0 };
  seed_lines(&t, true, columns, rows);
  seed_lines(&t, false, rows, columns);
  while (do_round(&t))
    ;
  free(t.seeds);
  return !t.out_of_memory;
}

void map_curves_clear(struct map_curves *curves)
{
  for (long i = 0; i < curves->count; i++)
    free(curves->curves[i].points);
  free(curves->curves);
  *curves = (struct map_curves){ .count = 0 };
}
