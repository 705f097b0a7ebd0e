/* Gaits with piecewise linear |l'|: trapezoidal, skewed, constant. */
#include "model/families.h"

static const double least = 0x1p-100; /* fraction of a phase */

typedef struct scallop_straight_form form;
static const form ZERO = { 0, 0, 0 }, HALF = { 0.5, 0, 0 }, ONE = { 1, 0, 0 }, UP = { 0, 1, 0 }, DOWN = { 0, 0, 1 },
                  BUT_UP = { 1, -1, 0 }, BUT_DOWN = { 1, 0, -1 }, MEAN = { 1, -0.5, -0.5 };

static double value(form f, double up, double down) { return f.one + f.up * up + f.down * down; }

/* Adds the next piece of a phase, from offset begin to offset end. */
static void add(struct scallop_straight *g, int kind, enum scallop_anchor anchor, struct scallop_straight_line line,
                double up, double down, double base)
{
  struct scallop_shape *shape = &g->gait.phase[kind];
  int i = shape->count++, direction = kind == SCALLOP_EXTENSION ? 1 : -1, sense = anchor == SCALLOP_FROM_START ? 1 : -1;
  struct scallop_ramp_law ramp = {
    line.start, line.slope, value(line.divisor, up, down), { line.mean.one, line.mean.up * up, line.mean.down * down }
  };
  long double divisor = (long double)ramp.divisor * ((long double)ramp.parts[0] + ramp.parts[1] + ramp.parts[2]);
  g->lines[kind][i] = line;
  g->laws[kind][i] = (struct scallop_law){ SCALLOP_LAW_RAMP, 1, .ramp = ramp, .base = base };
  g->pieces[kind][i] = (struct scallop_piece){ .begin = value(line.begin, up, down),
                                               .end = value(line.end, up, down),
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

/* Adds the constant part. Its ends must be doubles, from the start or from the end: 1 - x is a double if x >= 1/2. */
static void add_plateau(struct scallop_straight *g, int kind, double up, double down)
{
  double V = (double)(1 / (1 - (long double)up / 2 - (long double)down / 2));
  bool from_start = up < 0.5, from_end = down < 0.5;
  if (from_start)
    add(g, kind, SCALLOP_FROM_START, (struct scallop_straight_line){ UP, from_end ? HALF : BUT_DOWN, 1, 0, ONE, MEAN },
        up, down, -0.5 * V * up);
  if (from_end)
    add(g, kind, SCALLOP_FROM_END, (struct scallop_straight_line){ from_start ? HALF : BUT_UP, DOWN, 1, 0, ONE, MEAN },
        up, down, 0.5 * V * down);
}

/* Adds a phase in which |l'| rises for a fraction b and falls for the rest. */
static void add_skewed(struct scallop_straight *g, int kind, double b)
{
  double rest = 1 - b;
  bool is_exact = 1 - rest == b; /* false: the falling part is split, to begin at a double */
  add(g, kind, SCALLOP_FROM_START, (struct scallop_straight_line){ ZERO, UP, 0, 2, UP, ONE }, b, rest, 0);
  if (is_exact) {
    add(g, kind, SCALLOP_FROM_END, (struct scallop_straight_line){ BUT_UP, ZERO, 0, 2, BUT_UP, ONE }, b, rest, 0);
  } else {
    add(g, kind, SCALLOP_FROM_START, (struct scallop_straight_line){ UP, HALF, 2, -2, ONE, BUT_UP }, b, rest,
        (double)(-b / (1 - (long double)b)));
    add(g, kind, SCALLOP_FROM_END, (struct scallop_straight_line){ HALF, ZERO, 0, 2, ONE, BUT_UP }, b, rest, 0);
  }
  end_phase(g, kind, 2);
}

static void add_trapezoid(struct scallop_straight *g, int kind, double up, double down)
{
  if (up + down == 1) {
    add_skewed(g, kind, up);
    return;
  }
  add(g, kind, SCALLOP_FROM_START, (struct scallop_straight_line){ ZERO, UP, 0, 1, UP, MEAN }, up, down, 0);
  add_plateau(g, kind, up, down);
  add(g, kind, SCALLOP_FROM_END, (struct scallop_straight_line){ DOWN, ZERO, 0, 1, DOWN, MEAN }, up, down, 0);
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

enum scallop_status scallop_make_constant(struct scallop_straight *g, const char *name, const double ramp[2])
{
  for (int kind = 0; kind < 2; kind++)
    if (!(ramp[kind] == 0 || (ramp[kind] >= least && ramp[kind] <= 0.5)))
      return SCALLOP_EDOMAIN;
  begin_gait(g, name);
  for (int kind = 0; kind < 2; kind++)
    if (ramp[kind] != 0)
      add_trapezoid(g, kind, ramp[kind], ramp[kind]);
    else { /* |l'| = 1, in two pieces: times are measured from the nearer end of the phase */
      add_plateau(g, kind, 0, 0);
      end_phase(g, kind, 1);
      g->gait.phase[kind].l0 = g->gait.phase[kind].lT = 0; /* instead of -0 */
    }
  for (int kind = 0; kind < 2 && (ramp[0] == 0 || ramp[1] == 0); kind++) { /* l' jumps */
    g->pieces[kind][0].jump = true;
    g->gait.phase[kind].concave = g->gait.phase[kind].ramps = false;
  }
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

static enum scallop_status make_constant(union scallop_made_gait *made, const char *name, const double *x, int count,
                                         const char **why)
{
  (void)count;
  (void)why;
  return scallop_make_constant(&made->straight, name, x);
}

const struct scallop_gait_family scallop_family_trapezoidal = {
  .name = "trapezoidal",
  .numbers = "UP,DOWN",
  .usual = "0.25,0.25",
  .allowed =
      "trapezoidal:UP,DOWN or trapezoidal:UP,DOWN,UP,DOWN, fractions of the extension and of the contraction in which "
      "|l'| rises and falls: from 2^-100, UP + DOWN at most 1",
  .sentence = "|l'| rises for a fraction UP of each phase, stays, and falls for DOWN; UP,DOWN,UP,DOWN: the second pair "
              "is for the contraction",
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

const struct scallop_gait_family scallop_family_constant = {
  .name = "constant",
  .numbers = "R",
  .allowed = "constant:R or constant:R,R, the fraction of each phase, or of the extension and of the contraction, that "
             "each of two ramps takes: 0, or from 2^-100 to 0.5",
  .sentence = "l' is constant out and back but for ramps that each take R of a phase; with R = 0 it jumps; R,R: the "
              "second is for the contraction",
  .sample = "constant:0",
  .each = 1,
  .make = make_constant
};
