/* The family constant: l' is constant out and back, but for short ramps at the ends of each phase; without them it
 * jumps there. */
#include "model/families.h"

static const struct scallop_law level = { SCALLOP_LAW_RAMP, 1, .ramp = { 1, 0, 1, { 1, 0, 0 } } };

/* |l'| = 1 in two pieces, so that times are measured from the nearer end of the phase */
#define LEVEL(from, to, anchored, sign, jumps) \
  { \
    .begin = (from), .end = (to), .anchor = (anchored), .direction = (sign), .jump = (jumps), .linear = true, \
    .velocity = (sign), .curve = &scallop_curve_linear, .law = &level \
  }
#define LEVEL_PHASE(sign) \
  { \
    LEVEL(0, 0.5, SCALLOP_FROM_START, sign, true), LEVEL(0.5, 0, SCALLOP_FROM_END, sign, false) \
  }

static const struct scallop_piece level_phase[2][2] = { LEVEL_PHASE(1), LEVEL_PHASE(-1) };

enum scallop_status scallop_make_constant(struct scallop_straight *g, const char *name, const double ramp[2])
{
  double made[2];
  for (int kind = 0; kind < 2; kind++)
    made[kind] = ramp[kind] == 0 ? 0.5 : ramp[kind];
  enum scallop_status status = scallop_make_trapezoidal(g, name, made, made);
  if (status != SCALLOP_OK)
    return status;
  bool jumps = ramp[SCALLOP_EXTENSION] == 0 || ramp[SCALLOP_CONTRACTION] == 0;
  for (int kind = 0; kind < 2; kind++) {
    struct scallop_shape *shape = &g->gait.phase[kind];
    if (ramp[kind] == 0) {
      double direction = shape->net;
      g->pieces[kind][0] = level_phase[kind][0];
      g->pieces[kind][1] = level_phase[kind][1];
      *shape = (struct scallop_shape){ .pieces = g->pieces[kind], .count = 2, .peak = 1, .net = direction };
    } else if (jumps) {
      g->pieces[kind][0].jump = true;
      shape->concave = shape->ramps = false;
    }
  }
  return SCALLOP_OK;
}

static enum scallop_status make(union scallop_made_gait *made, const char *name, const double *x, int count,
                                const char **why)
{
  (void)count;
  (void)why;
  return scallop_make_constant(&made->straight, name, x);
}

const struct scallop_gait_family scallop_family_constant = {
  .name = "constant",
  .numbers = "R",
  .allowed = "constant:R or constant:R,R, the fraction of each phase, or of the extension and of the contraction, that "
             "each of two "
             "ramps takes: 0, or from 2^-100 to 0.5",
  .sentence = "l' is constant out and back but for ramps that each take R of a phase; with R = 0 it jumps; R,R: the "
              "second is for "
              "the contraction",
  .sample = "constant:0",
  .each = 1,
  .make = make
};
