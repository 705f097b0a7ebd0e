/* Gaits that the library does not have and the others of the tests are not like: l' that changes its sign or jumps within a phase,
 * more modes than are kept, phases of two kinds. Header-only; knows public headers only. */
#ifndef ODD_GAITS_H
#define ODD_GAITS_H

#include <math.h>

#include "model/model.h"

/* ---- made of straight pieces, every one but the last measured from the start ---- */

static inline double run_velocity(const struct scallop_piece *p, double u) { return p->velocity + p->acceleration * u; }
static inline double run_acceleration(const struct scallop_piece *p, double u) { return (void)u, p->acceleration; }
static inline double run_when(const struct scallop_piece *p, double a) { return a == p->acceleration ? p->begin : NAN; }
static inline double run_way(const struct scallop_piece *p, double u)
{
  return (u - p->begin) * (run_velocity(p, p->begin) + run_velocity(p, u)) / 2;
}
static inline double run_length(const struct scallop_piece *p, double u)
{
  double way = run_way(p, u);
  for (; p->begin > 0; p--)
    way += run_way(p - 1, (p - 1)->end);
  return way;
}

static const struct scallop_curve run = { run_length, run_velocity, run_acceleration, run_when, NULL };

#define RUN(from, to, sign, at_0, slope) \
  { \
    .begin = (from), .end = (to), .direction = (sign), .linear = true, .velocity = (at_0), .acceleration = (slope), \
    .curve = &run \
  }
#define STRIDE(from, to, at_0) \
  { \
    .begin = (from), .end = (to), .direction = (at_0) > 0 ? 1 : -1, .jump = true, .linear = true, .velocity = (at_0), \
    .curve = &run \
  }

/* there and back: out to 9/8 until 3/4 of the phase, and back by 1/8 */
#define THERE_AND_BACK(sign) \
  RUN(0, 0.375, sign, 0, (sign)*8), RUN(0.375, 0.75, sign, (sign)*6, (sign) * -8), \
      RUN(0.75, 0.875, -(sign), (sign)*6, (sign) * -8), SCALLOP_RAMP(0.125, 0, SCALLOP_FROM_END, -(sign), (sign)*8)

static const struct scallop_piece back_extension[] = { THERE_AND_BACK(1) };
static const struct scallop_piece back_contraction[] = { THERE_AND_BACK(-1) };
static const struct scallop_gait there_and_back_gait = { "there-and-back",
                                                         { { back_extension, 4, 8, 8, 3, 0.5, false, false },
                                                           { back_contraction, 4, -8, -8, 3, -0.5, false, false } } };

/* detour: three humps, of 1, 1/2 and 1/2, with the same |l'| in both phases but not the opposite l': + + - and - + - */
#define HUMPS_2_AND_3 \
  RUN(0.5, 0.625, 1, -16, 32), RUN(0.625, 0.75, 1, 24, -32), RUN(0.75, 0.875, -1, 24, -32), \
      SCALLOP_RAMP(0.125, 0, SCALLOP_FROM_END, -1, 32)

static const struct scallop_piece detour_extension[] = { RUN(0, 0.25, 1, 0, 16), RUN(0.25, 0.5, 1, 8, -16), HUMPS_2_AND_3 };
static const struct scallop_piece detour_contraction[] = { RUN(0, 0.25, -1, 0, -16), RUN(0.25, 0.5, -1, -8, 16),
                                                           HUMPS_2_AND_3 };
static const struct scallop_gait detour_gait = { "detour",
                                                 { { detour_extension, 6, 16, 32, 4, 0.5, false, false },
                                                   { detour_contraction, 6, -16, 32, 4, -0.5, false, false } } };

/* stride: l' = 3/2, then 1/2, with jumps */
static const struct scallop_piece stride_extension[] = { STRIDE(0, 0.5, 1.5), STRIDE(0.5, 1, 0.5) };
static const struct scallop_piece stride_contraction[] = { STRIDE(0, 0.5, -1.5), STRIDE(0.5, 1, -0.5) };
static const struct scallop_gait stride_gait = {
  "stride", { { stride_extension, 2, 0, 0, 1.5, 1, false, false }, { stride_contraction, 2, 0, 0, 1.5, -1, false, false } }
};

/* ---- put together when asked for ---- */

/* The extension of one and the contraction of another */
static inline struct scallop_gait mixed_gait(const struct scallop_gait *extension, const struct scallop_gait *contraction)
{
  return (struct scallop_gait){ "mixed", { extension->phase[SCALLOP_EXTENSION], contraction->phase[SCALLOP_CONTRACTION] } };
}

/* teeth: |l'| up to 2 and down to 0, TEETH times */
enum { TEETH = 16, TEETH_PIECES = 2 * TEETH };
struct teeth {
  struct scallop_piece pieces[2][TEETH_PIECES];
  struct scallop_gait gait;
};
static inline void grow_teeth(struct teeth *t)
{
  for (int kind = 0; kind < 2; kind++) {
    int sign = kind == SCALLOP_EXTENSION ? 1 : -1;
    for (int i = 0; i < TEETH; i++) {
      double begin = (double)i / TEETH, middle = begin + 0.5 / TEETH, end = begin + 1.0 / TEETH, slope = sign * 4 * TEETH;
      t->pieces[kind][2 * i] = (struct scallop_piece)RUN(begin, middle, sign, -slope * begin, slope);
      t->pieces[kind][2 * i + 1] = (struct scallop_piece)RUN(middle, end, sign, slope * end, -slope);
    }
    t->pieces[kind][TEETH_PIECES - 1] = (struct scallop_piece)SCALLOP_RAMP(0.5 / TEETH, 0, SCALLOP_FROM_END, sign,
                                                                           -sign * 4 * TEETH);
    t->gait.phase[kind] =
        (struct scallop_shape){ t->pieces[kind], TEETH_PIECES, sign * 4 * TEETH, -sign * 4 * TEETH, 2, sign, false, false };
  }
  t->gait.name = "teeth";
}

#endif
