#include <stddef.h>

#include "model/families.h"

static const double least = 0x1p-100; /* fraction of a phase */

/* The next piece of a phase, from offset begin to offset end. */
static void add(struct scallop_straight *g, int kind, enum scallop_anchor anchor, double begin, double end,
                struct scallop_ramp_law ramp, double base)
{
  struct scallop_shape *shape = &g->gait.phase[kind];
  int i = shape->count++, direction = kind == SCALLOP_EXTENSION ? 1 : -1, sense = anchor == SCALLOP_FROM_START ? 1 : -1;
  long double divisor = (long double)ramp.divisor * ((long double)ramp.parts[0] + ramp.parts[1] + ramp.parts[2]);
  g->laws[kind][i] = (struct scallop_law){ SCALLOP_LAW_RAMP, 1, .ramp = ramp, .base = base };
  g->pieces[kind][i] = (struct scallop_piece){ .begin = begin,
                                               .end = end,
                                               .anchor = anchor,
                                               .direction = direction,
                                               .linear = true,
                                               .velocity = (double)(direction * ramp.start / divisor),
                                               .acceleration = (double)(direction * sense * ramp.slope / divisor),
                                               .curve = &scallop_curve_linear,
                                               .law = &g->laws[kind][i] };
}

static void begin_gait(struct scallop_straight *g, const char *name)
{
  g->gait.name = name;
  for (int kind = 0; kind < 2; kind++)
    g->gait.phase[kind] = (struct scallop_shape){ .pieces = g->pieces[kind], .concave = true };
}

static void end_phase(struct scallop_straight *g, int kind, double peak)
{
  struct scallop_shape *shape = &g->gait.phase[kind];
  shape->l0 = shape->pieces[0].acceleration;
  shape->lT = shape->pieces[shape->count - 1].acceleration;
  shape->peak = peak;
  shape->net = shape->pieces[0].direction;
  shape->ramps = shape->count == 2;
}

/* Where a piece begins or ends must be a double, from the start or from the end: 1 - x is one if x >= 1/2. */
static void add_plateau(struct scallop_straight *g, int kind, double up, double down)
{
  const struct scallop_ramp_law level = { 1, 0, 1, { 1, -up / 2, -down / 2 } };
  double V = (double)(1 / (1 - (long double)up / 2 - (long double)down / 2));
  bool from_start = up < 0.5, from_end = down < 0.5;
  if (from_start)
    add(g, kind, SCALLOP_FROM_START, up, from_end ? 0.5 : 1 - down, level, -0.5 * V * up);
  if (from_end)
    add(g, kind, SCALLOP_FROM_END, from_start ? 0.5 : 1 - up, down, level, 0.5 * V * down);
}

/* Rises for beta of the phase, falls for the rest */
static void add_skewed(struct scallop_straight *g, int kind, double b)
{
  double rest = 1 - b;
  bool is_exact = 1 - rest == b; /* else what falls is split, so that it begins at a double */
  add(g, kind, SCALLOP_FROM_START, 0, b, (struct scallop_ramp_law){ 0, 2, b, { 1, 0, 0 } }, 0);
  if (is_exact) {
    add(g, kind, SCALLOP_FROM_END, rest, 0, (struct scallop_ramp_law){ 0, 2, rest, { 1, 0, 0 } }, 0);
  } else {
    add(g, kind, SCALLOP_FROM_START, b, 0.5, (struct scallop_ramp_law){ 2, -2, 1, { 1, -b, 0 } },
        (double)(-b / (1 - (long double)b)));
    add(g, kind, SCALLOP_FROM_END, 0.5, 0, (struct scallop_ramp_law){ 0, 2, 1, { 1, -b, 0 } }, 0);
  }
  end_phase(g, kind, 2);
}

static void add_trapezoid(struct scallop_straight *g, int kind, double up, double down)
{
  add(g, kind, SCALLOP_FROM_START, 0, up, (struct scallop_ramp_law){ 0, 1, up, { 1, -up / 2, -down / 2 } }, 0);
  add_plateau(g, kind, up, down);
  add(g, kind, SCALLOP_FROM_END, down, 0, (struct scallop_ramp_law){ 0, 1, down, { 1, -up / 2, -down / 2 } }, 0);
  end_phase(g, kind, (double)(1 / (1 - (long double)up / 2 - (long double)down / 2)));
}

enum scallop_status scallop_make_trapezoidal(struct scallop_straight *g, const char *name, const double up[2],
                                             const double down[2])
{
  for (int kind = 0; kind < 2; kind++)
    if (!(up[kind] >= least && up[kind] < 1 && down[kind] >= least && up[kind] + down[kind] <= 1))
      return SCALLOP_EDOMAIN;
  begin_gait(g, name);
  for (int kind = 0; kind < 2; kind++)
    if (up[kind] + down[kind] == 1)
      add_skewed(g, kind, up[kind]);
    else
      add_trapezoid(g, kind, up[kind], down[kind]);
  return SCALLOP_OK;
}

enum scallop_status scallop_make_skewed(struct scallop_straight *g, const char *name, const double beta[2])
{
  for (int kind = 0; kind < 2; kind++)
    if (!(beta[kind] >= least && beta[kind] < 1))
      return SCALLOP_EDOMAIN;
  begin_gait(g, name);
  for (int kind = 0; kind < 2; kind++)
    add_skewed(g, kind, beta[kind]);
  return SCALLOP_OK;
}

static enum scallop_status make_trapezoidal(union scallop_made_gait *made, const char *name, const double *x, int count,
                                            const char **why)
{
  (void)count;
  (void)why;
  return scallop_make_trapezoidal(&made->straight, name, (const double[]){ x[0], x[2] },
                                  (const double[]){ x[1], x[3] });
}

static enum scallop_status make_skewed(union scallop_made_gait *made, const char *name, const double *x, int count,
                                       const char **why)
{
  (void)count;
  (void)why;
  return scallop_make_skewed(&made->straight, name, x);
}

const struct scallop_gait_family scallop_family_trapezoidal = {
  .name = "trapezoidal",
  .numbers = "UP,DOWN",
  .usual = "0.25,0.25",
  .allowed =
      "trapezoidal:UP,DOWN or trapezoidal:UP,DOWN,UP,DOWN, fractions of the extension and of the contraction in which "
      "|l'| rises and falls: from 2^-100, UP + DOWN at most 1",
  .sentence = "|l'| rises for a fraction UP of each phase, stays, and falls for DOWN; UP,DOWN,UP,DOWN: the second pair "
              "is for the "
              "contraction",
  .sample = "trapezoidal:0.2,0.3",
  .each = 2,
  .make = make_trapezoidal
};

const struct scallop_gait_family scallop_family_skewed = {
  .name = "skewed",
  .numbers = "BETA",
  .usual = "0.25",
  .allowed =
      "skewed:BETA or skewed:BETA,BETA, fractions of the extension and of the contraction in which |l'| rises: from "
      "2^-100, below 1",
  .sentence = "|l'| rises for a fraction BETA of each phase and falls for the rest; BETA,BETA: the second is for the "
              "contraction",
  .sample = "skewed:0.3",
  .each = 1,
  .make = make_skewed
};
