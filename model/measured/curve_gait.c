#include "model/measured/curve_gait.h"

#include <math.h>
#include <stdlib.h>

/* Computes the turns of the cubic between two knots, as fractions of the interval. Returns their count, at most 2. */
static int turns_between(const struct scallop_knot *a, const struct scallop_knot *b, double x[2])
{
  double duration = b->time - a->time, mean = (b->length - a->length) / duration;
  double p = a->slope, q = 3 * mean - a->slope - b->slope, r = b->slope;
  double bend = p - 2 * q + r, half = q - p, square = half * half - bend * p;
  if (!(square > 0))
    return 0;
  double root = half > 0 ? -half - sqrt(square) : sqrt(square) - half; /* roots of bend x^2 + 2 half x + p */
  const double both[2] = { root / bend, p / root };
  int count = 0;
  for (int i = 0; i < 2; i++)
    if (both[i] > 0 && both[i] < 1)
      x[count++] = both[i];
  if (count == 2 && x[0] > x[1]) {
    double first = x[0];
    x[0] = x[1];
    x[1] = first;
  }
  return count;
}

static struct scallop_knot later(struct scallop_knot knot, double period)
{
  knot.time += period;
  return knot;
}

/* Copies the knots, inserts one at each turn of l, and repeats the first at the end. */
static int add_turns(struct scallop_knot *all, const struct curve *c)
{
  const double near = 1e-7; /* of the interval between two knots: a turn so near to a knot is moved to it */
  int count = 0;
  for (int i = 0; i < c->count; i++)
    all[count++] = c->knots[i];
  for (int i = 0, n = count; i < n; i++) {
    struct scallop_knot a = all[i], b = i + 1 < n ? all[i + 1] : later(all[0], c->period);
    double x[2];
    for (int j = 0, turns = turns_between(&a, &b, x); j < turns; j++)
      if (x[j] < near)
        all[i].slope = 0;
      else if (x[j] > 1 - near)
        all[(i + 1) % n].slope = 0;
      else
        all[count++] = (struct scallop_knot){ .time = a.time + x[j] * (b.time - a.time),
                                              .length = cubic_length(&a, &b, b.time - a.time, x[j]) };
  }
  return count;
}

static int extreme(const struct scallop_knot *k, int count, int sense)
{
  int at = 0;
  for (int i = 1; i < count; i++)
    if (sense * k[i].length > sense * k[at].length)
      at = i;
  return at;
}

/* Corrects slopes with a wrong sign or too steep for their piece, by rounding. Returns true if it changed them. */
static bool make_monotone(struct scallop_knot *a, struct scallop_knot *b)
{
  if (scallop_knots_are_monotone(a, b))
    return false;
  double way = b->length - a->length, steepest = 3 * fabs(way) / (b->time - a->time) * (1 - 0x1p-51);
  for (int i = 0; i < 2; i++) {
    double *slope = i == 0 ? &a->slope : &b->slope, size = way < 0 ? -*slope : *slope;
    *slope = copysign(fmin(fmax(size, 0), steepest), way);
  }
  return true;
}

/* Writes knots first to last, past the end of the circle, as knots of a phase. Returns their count. */
static int set_phase(struct scallop_knot *phase, const struct scallop_knot *all, int count, int first, int last,
                     double period, const struct curve_gait *g, double low)
{
  double begin = all[first].time, duration = (last < count ? all[last].time : all[last - count].time + period) - begin;
  int used = 0;
  for (int i = first; i <= last; i++) {
    struct scallop_knot k = i < count ? all[i] : later(all[i - count], period);
    k.time = i == last ? 1 : scallop_knot_round((k.time - begin) / duration);
    k.length = scallop_knot_round((k.length - low) / g->L);
    k.slope = i == first || i == last ? 0 : k.slope * duration / g->L;
    if (used == 0 || k.time > phase[used - 1].time)
      phase[used++] = k;
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (int i = 1; i < used; i++)
      changed |= make_monotone(&phase[i - 1], &phase[i]);
  }
  return used;
}

static bool make_memory(struct scallop_spline *s, const int count[2])
{
  size_t pieces = (size_t)scallop_spline_pieces(count);
  s->pieces = malloc(pieces * sizeof *s->pieces);
  s->laws = malloc(pieces * sizeof *s->laws);
  return s->pieces && s->laws;
}

static const char *lay_phases(struct curve_gait *g, struct scallop_knot *all, int count, double period,
                              const char *name)
{
  int least = extreme(all, count, -1), most = extreme(all, count, 1);
  double low = all[least].length, rise = all[most].time - all[least].time;
  g->L = all[most].length - low;
  g->alpha = (rise > 0 ? rise : rise + period) / period;
  if (!(g->L > 0))
    return "l is the same throughout: there is no gait in that";
  struct scallop_knot *phases[2] = { all + count, all + 2 * count + 1 };
  int top = most > least ? most : most + count;
  const int counts[2] = { set_phase(phases[0], all, count, least, top, period, g, low),
                          set_phase(phases[1], all, count, most, least + (top < count ? count : 0), period, g, low) };
  const struct scallop_knot *const knots[2] = { phases[0], phases[1] };
  if (!make_memory(&g->spline, counts))
    return "out of memory"; /* GCOVR_EXCL_LINE */
  return scallop_make_spline(&g->spline, name, knots, counts) == SCALLOP_OK
             ? NULL
             : "no monotone pieces of a spline go through these rows: some differ in l or t by 1e-16 of the range only";
}

const char *gait_of_curve(struct curve_gait *g, const struct curve *curve, const char *name)
{
  struct scallop_knot *all = calloc((size_t)curve->count * 9 + 6, sizeof *all);
  *g = (struct curve_gait){ .L = 0 };
  if (!all)
    return "out of memory"; /* GCOVR_EXCL_LINE */
  int count = add_turns(all, curve);
  qsort(all, (size_t)count, sizeof *all, by_time);
  const char *wrong = lay_phases(g, all, count, curve->period, name);
  free(all);
  return wrong;
}

void curve_gait_free(struct curve_gait *g)
{
  free(g->spline.pieces);
  free(g->spline.laws);
  *g = (struct curve_gait){ .L = 0 };
}
