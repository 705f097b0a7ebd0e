/* Gaits that the library does not have and the others of the tests are not like: l' that changes its sign, rests or
 * jumps within a phase, more modes than are kept, phases of two kinds. Header-only; knows public headers only. */
#ifndef SCALLOP_TESTS_SUPPORT_ODD_GAITS_H
#define SCALLOP_TESTS_SUPPORT_ODD_GAITS_H

#include "tests/support/random_crawler.h"

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

/* PIECES(1) in the extension and PIECES(-1) in the contraction */
#define TWO_WAY_GAIT(name, text, PIECES, l0, lT, peak, net) \
  static const struct scallop_piece name##_out[] = { PIECES(1) }, name##_back[] = { PIECES(-1) }; \
  enum { name##_count = sizeof name##_out / sizeof *name##_out }; \
  static const struct scallop_gait name##_gait = { \
    text, \
    { { name##_out, name##_count, l0, lT, peak, net, false, false, false }, \
      { name##_back, name##_count, -(l0), -(lT), peak, -(net), false, false, false } } \
  }

/* there and back: out to 9/8 until 3/4 of the phase, and back by 1/8 */
#define THERE_AND_BACK(sign) \
  RUN(0, 0.375, sign, 0, (sign)*8), RUN(0.375, 0.75, sign, (sign)*6, (sign) * -8), \
      RUN(0.75, 0.875, -(sign), (sign)*6, (sign) * -8), SCALLOP_RAMP(0.125, 0, SCALLOP_FROM_END, -(sign), (sign)*8)
TWO_WAY_GAIT(there_and_back, "there-and-back", THERE_AND_BACK, 8, 8, 3, 0.5);

/* detour: three humps, of 1, 1/2 and 1/2, with the same |l'| in both phases but not the opposite l': + + - and - + - */
#define DETOUR(sign) \
  RUN(0, 0.25, sign, 0, (sign)*16), RUN(0.25, 0.5, sign, (sign)*8, (sign) * -16), RUN(0.5, 0.625, 1, -16, 32), \
      RUN(0.625, 0.75, 1, 24, -32), RUN(0.75, 0.875, -1, 24, -32), SCALLOP_RAMP(0.125, 0, SCALLOP_FROM_END, -1, 32)
static const struct scallop_piece detour_out[] = { DETOUR(1) }, detour_back[] = { DETOUR(-1) };
static const struct scallop_gait detour_gait = { "detour",
                                                 { { detour_out, 6, 16, 32, 4, 0.5, false, false, false },
                                                   { detour_back, 6, -16, 32, 4, -0.5, false, false, false } } };

#define REST(from, to) \
  { \
    .begin = (from), .end = (to), .linear = true, .curve = &run \
  }
#define REST_AT_LAST(from) \
  { \
    .begin = (from), .end = 0, .anchor = SCALLOP_FROM_END, .linear = true, .curve = &scallop_curve_linear \
  }

/* pause: half of the way, rest in two pieces, the other half */
#define PAUSE(sign) \
  RUN(0, 0.125, sign, 0, (sign)*32), RUN(0.125, 0.25, sign, (sign)*8, (sign) * -32), REST(0.25, 0.375), \
      REST(0.375, 0.5), RUN(0.5, 0.75, sign, (sign) * -4, (sign)*8), \
      SCALLOP_RAMP(0.25, 0, SCALLOP_FROM_END, sign, (sign) * -8)
TWO_WAY_GAIT(pause, "pause", PAUSE, 32, -8, 4, 0.75);

/* wait: rest, out to 9/8, rest, back by 1/8, rest */
#define WAIT(sign) \
  REST(0, 0.125), RUN(0.125, 0.375, sign, (sign) * -2.25, (sign)*18), \
      RUN(0.375, 0.625, sign, (sign)*11.25, (sign) * -18), REST(0.625, 0.75), \
      RUN(0.75, 0.8125, -(sign), (sign)*24, (sign) * -32), RUN(0.8125, 0.875, -(sign), (sign) * -28, (sign)*32), \
      REST_AT_LAST(0.125)
TWO_WAY_GAIT(wait, "wait", WAIT, 0, 0, 4.5, 0.375);

/* hesitant: out at once, then rest; back in two humps, between which l' touches 0 */
static struct scallop_piece hesitant_pieces[16];
static struct scallop_law hesitant_laws[16];
static struct scallop_spline made_hesitant = { .pieces = hesitant_pieces, .laws = hesitant_laws };
#define hesitant_gait made_hesitant.gait

__attribute__((constructor)) static void make_hesitant(void)
{
  static const struct scallop_knot out[] = { { 0, 0, 0 }, { 0.5, 1, 0 }, { 1, 1, 0 } },
                                   back[] = { { 0, 1, 0 }, { 0.5, 0.5, 0 }, { 1, 0, 0 } };
  const struct scallop_knot *const knots[2] = { out, back };
  const int count[2] = { 3, 3 };
  if (scallop_spline_pieces(count) > 16 || scallop_make_spline(&made_hesitant, "hesitant", knots, count) != SCALLOP_OK)
    abort();
}

/* stride: l' = 3/2, then 1/2, with jumps */
#define STRIDES(sign) STRIDE(0, 0.5, (sign)*1.5), STRIDE(0.5, 1, (sign)*0.5)
TWO_WAY_GAIT(stride, "stride", STRIDES, 0, 0, 1.5, 1);

/* By their polynomial laws: l, l' and l'' at offset u, and where l'' has a value, by bisection, as it is monotone in a
 * piece */
static inline double law_sum(const struct scallop_piece *p, double u, int order)
{
  double sum = 0;
  for (int k = p->law->degree; k >= (order > 0 ? order : 0); k--)
    sum = sum * u + p->law->polynomial.c[k] * (order < 0 ? 1. / (k + 1) : order == 0 ? 1 : k);
  return (p->anchor == SCALLOP_FROM_START || order == 0 ? 1 : -1) * p->direction * (order < 0 ? sum * u : sum)
         / p->law->polynomial.denominator;
}
static inline double law_length(const struct scallop_piece *p, double u) { return law_sum(p, u, -1); }
static inline double law_rate(const struct scallop_piece *p, double u) { return law_sum(p, u, 0); }
static inline double law_bend(const struct scallop_piece *p, double u) { return law_sum(p, u, 1); }
static inline double law_when(const struct scallop_piece *p, double a)
{
  double low = p->begin, high = p->end;
  if (law_bend(p, low) > law_bend(p, high)) {
    low = p->end;
    high = p->begin;
  }
  if (!(law_bend(p, low) <= a && a <= law_bend(p, high)))
    return NAN;
  for (double mid; (mid = 0.5 * (low + high)) != low && mid != high;)
    *(law_bend(p, mid) < a ? &low : &high) = mid;
  return high;
}
static const struct scallop_curve law_curve = { law_length, law_rate, law_bend, law_when, NULL };

/* leaning: l' = 12/5 s (1 - s) (2 + s); ramps: the quadratic gait, which does not say that it is one */
static const struct scallop_law leaning_first = { SCALLOP_LAW_POLYNOMIAL, 3, .polynomial = { { 0, 24, -12, -12 }, 5 } },
                                leaning_last = { SCALLOP_LAW_POLYNOMIAL, 3, .polynomial = { { 0, 36, -48, 12 }, 5 } },
                                one_ramp = { SCALLOP_LAW_POLYNOMIAL, 1, .polynomial = { { 0, 4 }, 1 } };
#define BY_LAW(from, to, anchored, sign, exactly) \
  { \
    .begin = (from), .end = (to), .anchor = SCALLOP_FROM_##anchored, .direction = (sign), .curve = &law_curve, \
    .law = &(exactly) \
  }
#define LEANING(sign) BY_LAW(0, 0.5, START, sign, leaning_first), BY_LAW(0.5, 0, END, sign, leaning_last)
TWO_WAY_GAIT(leaning, "leaning", LEANING, 4.8, -7.2, 1.514712742658157179, 1); /* the peak at (sqrt 7 - 1)/3 */
#define RAMP_BY_LAW(from, to, anchored, sign, bend) \
  { \
    .begin = (from), .end = (to), .anchor = SCALLOP_FROM_##anchored, .direction = (sign), .linear = true, \
    .acceleration = (bend), .curve = &scallop_curve_linear, .law = &one_ramp \
  }
#define RAMPS(sign) RAMP_BY_LAW(0, 0.5, START, sign, 4 * (sign)), RAMP_BY_LAW(0.5, 0, END, sign, -4 * (sign))
TWO_WAY_GAIT(ramps, "ramps", RAMPS, 4, -4, 2, 1);

/* parabola: l' = 6 s (1 - s) in one piece, which has its anchor at one end only, and which a straight line can touch at
 * a rational point */
static const struct scallop_law parabola_law = { SCALLOP_LAW_POLYNOMIAL, 2, .polynomial = { { 0, 6, -6 }, 1 } };
static const struct scallop_piece parabola_extension[] = { { .end = 1, .direction = 1, .law = &parabola_law } };
static const struct scallop_piece parabola_contraction[] = {
  { .begin = 1, .anchor = SCALLOP_FROM_END, .direction = -1, .law = &parabola_law }
};
static const struct scallop_gait parabola_gait = { "parabola",
                                                   { { parabola_extension, 1, 6, -6, 1.5, 1, false, false, false },
                                                     { parabola_contraction, 1, -6, 6, 1.5, -1, false, false,
                                                       false } } };

/* The extension of one and the contraction of another */
static inline struct scallop_gait mixed_gait(const struct scallop_gait *extension,
                                             const struct scallop_gait *contraction)
{
  return (struct scallop_gait){ "mixed",
                                { extension->phase[SCALLOP_EXTENSION], contraction->phase[SCALLOP_CONTRACTION] } };
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
      double begin = (double)i / TEETH, middle = begin + 0.5 / TEETH, end = begin + 1.0 / TEETH,
             slope = sign * 4 * TEETH;
      t->pieces[kind][2 * i] = (struct scallop_piece)RUN(begin, middle, sign, -slope * begin, slope);
      t->pieces[kind][2 * i + 1] = (struct scallop_piece)RUN(middle, end, sign, slope * end, -slope);
    }
    t->pieces[kind][TEETH_PIECES - 1] = (struct scallop_piece)SCALLOP_RAMP(0.5 / TEETH, 0, SCALLOP_FROM_END, sign,
                                                                           -sign * 4 * TEETH);
    t->gait.phase[kind] = (struct scallop_shape){
      t->pieces[kind], TEETH_PIECES, sign * 4 * TEETH, -sign * 4 * TEETH, 2, sign, false, false, false
    };
  }
  t->gait.name = "teeth";
}

#endif
