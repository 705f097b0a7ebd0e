/* Measured gaits that rest and rise steeply, as motors that step do: splines through random knots. Header-only. */
#ifndef SCALLOP_TESTS_SUPPORT_RANDOM_RISES_H
#define SCALLOP_TESTS_SUPPORT_RANDOM_RISES_H

#include <stdlib.h>

#include "model/gaits.h"
#include "tests/support/random_crawler.h"

enum { RISES_MOST = 12, RISES_PIECES = 2 * RISES_MOST };

struct rises {
  struct scallop_knot knots[2][RISES_MOST];
  struct scallop_piece pieces[RISES_PIECES];
  struct scallop_law laws[RISES_PIECES];
  struct scallop_spline spline;
};

/* Slopes within Fritsch & Carlson's bounds: the harmonic mean of the chords, 0 where l rests on a side */
static inline void rises_slopes(struct scallop_knot *k, int count)
{
  for (int i = 1; i + 1 < count; i++) {
    double before = (k[i].length - k[i - 1].length) / (k[i].time - k[i - 1].time);
    double after = (k[i + 1].length - k[i].length) / (k[i + 1].time - k[i].time);
    k[i].slope = before * after > 0 ? 2 / (1 / before + 1 / after) : 0;
  }
}

/* l rests, or creeps, and rises within `width` of the phase, some times over. */
static inline int rises_phase(struct random *r, struct scallop_knot *k, double width, bool extension)
{
  int steps = 1 + random_below(r, 4), count = 1;
  double time = 0, length = 0;
  k[0] = (struct scallop_knot){ 0 };
  for (int i = 0; i < steps; i++) {
    time += random_between(r, 0.3, 0.9) / (steps + 1);
    if (random_below(r, 3) == 0)
      length += random_between(r, 0.02, 0.3) / (steps + 1);
    k[count++] = (struct scallop_knot){ .time = scallop_knot_round(time), .length = scallop_knot_round(length) };
    time += width * random_between(r, 0.2, 1);
    length += random_between(r, 0.1, 0.7) / (steps + 1);
    k[count++] = (struct scallop_knot){ .time = scallop_knot_round(time), .length = scallop_knot_round(length) };
  }
  k[count++] = (struct scallop_knot){ .time = 1, .length = 1 };
  for (int i = 0; !extension && i < count; i++)
    k[i].length = 1 - k[i].length;
  rises_slopes(k, count);
  return count;
}

static inline const struct scallop_gait *rises_draw(struct rises *g, struct random *r, double width)
{
  const int count[2] = { rises_phase(r, g->knots[0], width, true), rises_phase(r, g->knots[1], width, false) };
  const struct scallop_knot *const knots[2] = { g->knots[0], g->knots[1] };
  g->spline = (struct scallop_spline){ .pieces = g->pieces, .laws = g->laws };
  assert_int_equal(scallop_make_spline(&g->spline, "rises", knots, count), SCALLOP_OK);
  return &g->spline.gait;
}

#endif
