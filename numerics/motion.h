/* The exact motion over one phase, in units where the phase lasts 1, L is 1 and forces are in
 * F1 + F2. Used by phase.c, steady.c and trajectory.c; not public. */
#ifndef SCALLOP_MOTION_H
#define SCALLOP_MOTION_H

#include "numerics/numerics.h"

/* A phase whose |l'| rises along one straight line and falls along another, from rest to rest (ramps.h) */
struct ramps {
  double up, down;  /* |l'| = up t until t = top, then down (1 - t)                                       */
  double top, rest; /* rest = 1 - top                                                                    */
};

struct motion_input {
  const struct scallop_shape *shape;
  double mu1, mu2, f1, f2, delta;
  double eps; /* tau^2 (F1 + F2)/(M L), tau the duration of this phase */
  bool has_ramps;
  struct ramps ramps;
};

struct motion {
  double c_end;             /* velocity of the centre of mass at the end                                */
  double travel;            /* integral of c                                                            */
  double extra_impulse;     /* integral of c'/eps - (its value with the bodies in opposite motion,
                               delta sgn l'): zero where nothing but the stronger driving body matters  */
  double slope;             /* (d c_end / d c_0 - 1)/eps, from the right; meaningless if it forgets     */
  bool forgets;             /* c was glued to a curve, if only for an instant: d c_end / d c_0 = 0       */
  bool sticks;              /* a body is stuck for some time                                            */
  bool never_moved[2];      /* body 1, body 2 stuck throughout                                          */
  double first_switch;      /* from the start; nan if none                                              */
  double last_switch;       /* back from the end; nan if none                                           */
  struct scallop_work work; /* periods: 0                                                           */
  unsigned trail;           /* 0, or the modes in short: motion_modes tells them                    */
  struct scallop_modes modes;
};
void motion_modes(const struct motion *motion, enum scallop_phase_kind kind, struct scallop_modes *modes);

struct motion_input motion_input_of(const struct scallop_scaled *scaled, enum scallop_phase_kind kind);

/* c0: velocity of the centre of mass at the start, in L/tau. visit may be NULL. */
void motion_solve(const struct motion_input *input, double c0, struct motion *motion, scallop_visitor *visit, void *context);

#endif
