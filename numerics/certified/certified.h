/* The exact motion in ball arithmetic: every digit that is returned is proven, up to mistakes in this program and in
 * FLINT. Needs FLINT.
 *
 * The solver is written independently of motion.c, and by another route, so that the two can disagree: it uses the
 * velocities of the bodies in the laboratory, computes forces from Newton's law, and solves P(v) = v for the period map
 * P without rearrangement. The higher precision restores the digits that this loses. Each switching time is enclosed
 * and shown to be the only one in its interval, each mode follows from the forces, and the precision is raised until
 * the requested digits hold. If no precision decides a motion, the status is SCALLOP_EUNDECIDED: a body touches v = 0
 * exactly, or a force is exactly at its limit while l'' varies. Parameters are exact rationals: no input is rounded. */
#ifndef SCALLOP_NUMERICS_CERTIFIED_CERTIFIED_H
#define SCALLOP_NUMERICS_CERTIFIED_CERTIFIED_H

#include "model/exact/ball.h"
#include "numerics/numerics.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The largest allowed number of digits; the smallest is 1. */
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

/* Solves one phase from start velocity v0. Every result is enclosed with a relative radius of at most 10^-digits. A
 * result that is 0, or cannot be distinguished from 0, is enclosed with a radius of at most 10^-digits of its natural
 * unit: tau, L/tau or L, with the duration tau of the phase. SCALLOP_EDOMAIN: a parameter or digits outside its domain,
 * or a gait without an exact law; SCALLOP_EUNDECIDED: see the head of this file; *why, if why is not NULL, is then the
 * reason (a constant text). */
enum scallop_status scallop_certified_phase(const struct scallop_rational_crawler *crawler,
                                            enum scallop_phase_kind kind, const fmpq_t v0, long digits,
                                            struct scallop_certified_phase *phase, const char **why);

struct scallop_certified_steady {
  arb_t froude, v_start, v_mid, displacement, mean_velocity, multiplier;
  arb_t friction_work; /* the sum over the bodies of F_i times the length of the path of body i */
  enum scallop_regime regime;
  struct scallop_modes modes[2];
};
void scallop_certified_steady_init(struct scallop_certified_steady *steady);
void scallop_certified_steady_clear(struct scallop_certified_steady *steady);

/* Solves the steady state, and proves that it exists and is the only one. P(v) - v never rises as v grows, and changes
 * its sign across the ball v_start; the modes are the same for all start velocities in this ball. If l' does not jump,
 * P(v) - v is 0 only once (docs/background/theory.md); if l' jumps, it has one sign beyond either end of the ball.
 * Accuracy and statuses as above. SCALLOP_EUNDECIDED also if the steady states fill an interval, as they can if l'
 * jumps. SCALLOP_EDOMAIN also if l' is not 0 at the start or the end of a phase and the piece does not declare a
 * jump. */
enum scallop_status scallop_certified_steady(const struct scallop_rational_crawler *crawler, long digits,
                                             struct scallop_certified_steady *steady, const char **why);

#ifdef __cplusplus
}
#endif

#endif
