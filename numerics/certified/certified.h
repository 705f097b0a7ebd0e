/* The exact motion in ball arithmetic: every returned digit is proven.
 *
 * Independent of motion.c, and by another route: an error in one shows as a disagreement. Laboratory variables, the
 * velocities of the bodies themselves, forces from Newton's law, P(v) = v solved unchanged; a higher precision makes up
 * for lost digits. Each switching time is enclosed and shown to be the only one in its interval, each mode follows from
 * the forces, and precision is raised until the requested digits hold. A motion that no precision decides is
 * SCALLOP_EUNDECIDED: a body that touches v = 0 exactly, a force exactly at its limit where l'' varies. Needs FLINT.
 * Parameters are exact rationals: nothing is rounded on the way in.
 */
#ifndef SCALLOP_NUMERICS_CERTIFIED_CERTIFIED_H
#define SCALLOP_NUMERICS_CERTIFIED_CERTIFIED_H

#include "model/exact/ball.h"
#include "numerics/numerics.h"

#ifdef __cplusplus
extern "C" {
#endif

/* 1 <= digits <= this. */
enum { SCALLOP_MOST_DIGITS = 100000 };

struct scallop_certified_phase {
  bool switches; /* false: the mode never changes, and t1, dT, at_first, at_last are meaningless */
  arb_t t1, dT;  /* as in struct scallop_phase_result                                          */
  arb_t v_end;
  arb_t dx1, dx2, dxC;
  arb_t at_first, at_last; /* position, from its start, of the rear body (1 in an extension, 2 in a contraction) at the
                              first and at the last change of mode                                    */
  arb_t multiplier;        /* d v_end / d v0, from the right if it has two sides; 0 once a body has stuck */
  enum scallop_regime regime;
  struct scallop_modes modes;
};
void scallop_certified_phase_init(struct scallop_certified_phase *phase);
void scallop_certified_phase_clear(struct scallop_certified_phase *phase);

/* One phase from start velocity v0. Every result is enclosed to a relative radius of 10^-digits; a result that is 0, or
 * cannot be distinguished from 0, to 10^-digits of its natural size (tau, L/tau or L) at least. SCALLOP_EDOMAIN: a
 * parameter outside its domain, digits too, or a gait without an exact law; SCALLOP_EUNDECIDED: see above; *why then
 * names the cause (static text), if why is not NULL. */
enum scallop_status scallop_certified_phase(const struct scallop_rational_crawler *crawler,
                                            enum scallop_phase_kind kind, const fmpq_t v0, long digits,
                                            struct scallop_certified_phase *phase, const char **why);

struct scallop_certified_steady {
  arb_t froude, v_start, v_mid, displacement, mean_velocity, multiplier;
  arb_t friction_work; /* the sum over the bodies of F_i times how far body i slides, one way and the other */
  enum scallop_regime regime;
  struct scallop_modes modes[2];
};
void scallop_certified_steady_init(struct scallop_certified_steady *steady);
void scallop_certified_steady_clear(struct scallop_certified_steady *steady);

/* The steady state, proven to exist and to be the only one: P(v) - v never rises and changes its sign across the ball
 * v_start, over all of which the modes are the same; where l' does not jump it is 0 only once
 * (docs/background/theory.md), else it has one sign beyond either end of the ball. SCALLOP_EUNDECIDED also if the
 * steady states fill an interval, as they can if l' jumps; SCALLOP_EDOMAIN also if l' is not 0 at the start or end of a
 * phase, and the piece is not marked with a jump. Accuracy and statuses as above. */
enum scallop_status scallop_certified_steady(const struct scallop_rational_crawler *crawler, long digits,
                                             struct scallop_certified_steady *steady, const char **why);

#ifdef __cplusplus
}
#endif

#endif
