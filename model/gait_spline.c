#include "model/gaits.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

#include "model/law.h"

typedef long double real;
#include "model/bernstein.h"

double scallop_knot_round(double x) { return rint(x * 0x1p53) * 0x1p-53; }

int scallop_spline_pieces(const int count[2])
{
  return count[0] + count[1];
} /* one between two knots, and one for the middle */

static bool is_rounded(double x) { return x >= 0 && x <= 1 && scallop_knot_round(x) == x; }

bool scallop_knots_are_monotone(const struct scallop_knot *a, const struct scallop_knot *b)
{
  double way = b->length - a->length, sign = way < 0 ? -1 : 1;
  long double duration = (long double)b->time - a->time, three = 3 * (long double)fabs(way);
  long double first = sign * a->slope * duration, last = sign * b->slope * duration, middle = three - first - last;
  if (!(first >= 0 && last >= 0))
    return false;
  return (first <= three && last <= three) || (way != 0 && middle * middle <= first * last);
}

static bool is_phase(const struct scallop_knot *knots, int count, int kind)
{
  if (count < 2)
    return false;
  const struct scallop_knot *last = &knots[count - 1];
  if (knots[0].time != 0 || last->time != 1 || knots[0].slope != 0 || last->slope != 0 || knots[0].length != kind
      || last->length != 1 - kind)
    return false;
  for (int i = 0; i < count; i++)
    if (!is_rounded(knots[i].time) || !is_rounded(knots[i].length) || !isfinite(knots[i].slope)
        || (i > 0 && !(knots[i].time > knots[i - 1].time && scallop_knots_are_monotone(&knots[i - 1], &knots[i]))))
      return false;
  return true;
}

/* Adds the piece of the cubic between two knots that lies between the times from and to, on one side of the middle. */
static void add(struct scallop_spline *s, int at, const struct scallop_knot *a, const struct scallop_knot *b, int kind,
                double from, double to)
{
  struct scallop_piece *piece = &s->pieces[at];
  bool late = from >= 0.5;
  *piece = (struct scallop_piece){ .begin = late ? 1 - from : from,
                                   .end = late ? 1 - to : to,
                                   .anchor = late ? SCALLOP_FROM_END : SCALLOP_FROM_START,
                                   .direction = (b->length > a->length) - (b->length < a->length) };
  piece->law = &s->laws[at];
  const struct scallop_knot *near = late ? b : a, *far = late ? a : b;
  int d = piece->direction;
  double base = near->length - (late ? 1 - kind : kind);
  if (d == 0) {
    const struct scallop_ramp_law rest = { 0, 0, 1, { 1, 0, 0 } };
    s->laws[at] = (struct scallop_law){ SCALLOP_LAW_RAMP, 1, .ramp = rest, .base = base };
    piece->linear = true;
    piece->curve = &scallop_curve_linear;
    return;
  }
  const struct scallop_bernstein_law cubic = { .b = { d * near->slope, 0, d * far->slope },
                                               .near = late ? 1 - near->time : near->time,
                                               .far = late ? 1 - far->time : far->time,
                                               .way = d * (b->length - a->length),
                                               .implied = 1 };
  s->laws[at] = (struct scallop_law){ SCALLOP_LAW_BERNSTEIN, 2, .bernstein = cubic, .base = d * base };
  piece->curve = &law_curve_bernstein;
}

/* Adds the pieces of a phase from index at on. Returns the count of pieces so far. */
static int add_phase(struct scallop_spline *s, int at, const struct scallop_knot *knots, int count, int kind)
{
  for (int i = 1; i < count; i++) {
    double from = knots[i - 1].time, to = knots[i].time;
    if (from < 0.5 && to > 0.5) {
      add(s, at++, &knots[i - 1], &knots[i], kind, from, 0.5);
      from = 0.5;
    }
    add(s, at++, &knots[i - 1], &knots[i], kind, from, to);
  }
  return at;
}

/* Returns the maximum of b0 (1 - x)^2 + 2 b1 x (1 - x) + b2 x^2, 0 <= x <= 1. */
static long double largest(const long double b[3])
{
  long double ends = b[0] > b[2] ? b[0] : b[2], rise = b[1] - b[0], bend = b[0] - 2 * b[1] + b[2];
  return bend < 0 && rise > 0 && b[1] > b[2] ? b[0] - rise * rise / bend : ends;
}

static double peak_of(const struct scallop_shape *shape)
{
  long double peak = 0;
  for (int i = 0; i < shape->count; i++)
    if (shape->pieces[i].direction != 0) {
      struct bernstein f = bernstein_of(shape->pieces[i].law);
      peak = fmaxl(peak, largest(f.b));
    }
  return (double)peak;
}

/* By the changes of d|l'|/dt from knot to knot, to the precision of long double; neither if l rests or goes back. */
static void set_bends(struct scallop_shape *shape, int kind)
{
  long double last = 0;
  int part = 0;
  bool bell = true, concave = true;
  for (int i = 0; i < shape->count; i++) {
    const struct scallop_piece *p = &shape->pieces[i];
    if (p->direction != (kind == SCALLOP_EXTENSION ? 1 : -1))
      return;
    struct bernstein f = bernstein_of(p->law);
    bool forward = p->anchor == SCALLOP_FROM_START;
    const long double *b = f.b, range = f.far - f.near;
    const long double first = (forward ? b[1] - b[0] : b[1] - b[2]) / range,
                      then = (forward ? b[2] - b[1] : b[0] - b[1]) / range, bend[2] = { first - last, then - first };
    for (int j = i == 0 ? 1 : 0; j < 2; j++) {
      bell = bell && law_is_bell(&part, bend[j]);
      concave = concave && bend[j] <= 0;
    }
    last = then;
  }
  shape->concave = concave;
  shape->bell = bell && !concave;
}

static void conclude(struct scallop_shape *shape, int kind)
{
  const struct scallop_piece *first = &shape->pieces[0], *last = &shape->pieces[shape->count - 1];
  shape->l0 = first->curve->acceleration(first, first->begin);
  shape->lT = last->curve->acceleration(last, last->end);
  shape->peak = peak_of(shape);
  shape->net = 0;
  for (int i = 0; i < shape->count; i++)
    shape->net += shape->pieces[i].direction * fabs(shape->pieces[i].end - shape->pieces[i].begin);
  set_bends(shape, kind);
}

enum scallop_status scallop_make_spline(struct scallop_spline *s, const char *name,
                                        const struct scallop_knot *const knots[2], const int count[2])
{
  for (int kind = 0; kind < 2; kind++)
    if (!is_phase(knots[kind], count[kind], kind))
      return SCALLOP_EDOMAIN;
  s->gait = (struct scallop_gait){ .name = name };
  for (int kind = 0, at = 0; kind < 2; kind++) {
    struct scallop_shape *shape = &s->gait.phase[kind];
    int first = at;
    at = add_phase(s, at, knots[kind], count[kind], kind);
    shape->pieces = s->pieces + first;
    shape->count = at - first;
    conclude(shape, kind);
  }
  return SCALLOP_OK;
}
