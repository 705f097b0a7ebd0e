/* The exact motion over one phase, in units where the phase lasts 1, L is 1 and forces are in
 * F1 + F2. Used by phase.c, steady.c and trajectory.c; not public. */
#ifndef SCALLOP_NUMERICS_EVENT_MOTION_H
#define SCALLOP_NUMERICS_EVENT_MOTION_H

#include "model/law.h"
#include "numerics/numerics.h"

/* l' and l'' at an offset of a piece */
static inline void piece_rates(const struct scallop_piece *p, double u, double *velocity, double *acceleration)
{
  if (p->curve->rates) {
    p->curve->rates(p, u, velocity, acceleration);
  } else {
    *velocity = p->curve->velocity(p, u);
    *acceleration = p->curve->acceleration(p, u);
  }
}

struct motion_input {
  const struct scallop_scaled *scaled;
  const struct scallop_shape *shape;
  double eps;  /* tau^2 (F1 + F2)/(M L), tau the duration of this phase */
  double base; /* velocities at the start and at the end are counted from this: 0, or as in walk.h */
};

static inline struct motion_input motion_input_of(const struct scallop_scaled *s, enum scallop_phase_kind kind)
{
  return (struct motion_input){ s, &s->gait->phase[kind], s->eps * (s->fraction[kind] * s->fraction[kind]), 0 };
}

struct motion {
  double c_end;         /* velocity of the centre of mass at the end                                */
  double travel;        /* integral of c: how far the centre of mass comes                           */
  double size;          /* sum of the magnitudes of the parts of that, which rounding goes with      */
  double extra_impulse; /* integral of c'/eps - (its value with the bodies in opposite motion,
                               delta sgn l'): zero where nothing but the stronger driving body matters;
                               meaningless if it forgets                                                */
  double slope;         /* (d c_end / d c_0 - 1)/eps, from the right; meaningless if it forgets     */
  double stretch;       /* d c_end / d c_0, as a product without cancellation; likewise              */
  double furthest;      /* the largest |c| since a body was held, of a phase of many pieces; else 0         */
  bool forgets;         /* c was glued to a curve, if only for an instant: d c_end / d c_0 = 0       */
  bool delicate; /* a curve was crossed nearly at a tangent, or where it is nearly level: slope and stretch depend on
                               where in the last digit                                                  */
  bool sticks;   /* a body is stuck for some time                                            */
  bool never_moved[2];      /* body 1, body 2 stuck throughout                                          */
  double first_switch;      /* from the start; nan if none                                              */
  double last_switch;       /* back from the end; nan if none                                           */
  struct scallop_work work; /* periods: 0                                                           */
  unsigned trail;           /* 0, or the modes in short: motion_modes tells them                    */
  struct scallop_modes modes;
};
/* How far the centre of mass, body 1 and body 2 come, and the sizes of the parts; and how far each body slides. */
struct motion_ways {
  double way[3], size[3], path[2];
};

/* What friction has left of the velocity at the end, as a fraction, if that is so little that rounding of what is gone
 * shows in it; else 1, as for two ramps, for which ramps_solve does not set furthest. */
double motion_left(const struct scallop_shape *shape, const struct motion *motion);

void motion_modes(const struct motion *motion, enum scallop_phase_kind kind, struct scallop_modes *modes);

/* The level of a curve over a plateau of l' that c is no further from than `near`; 0: there is none. */
double motion_level(const struct motion_input *input, double c, double near);

/* c0: velocity of the centre of mass at the start, in L/tau. visit may be NULL. */
void motion_solve(const struct motion_input *input, double c0, struct motion *motion, scallop_visitor *visit,
                  void *context);
/* The same, with the ways of the bodies as well. */
void motion_solve_ways(const struct motion_input *input, double c0, struct motion *motion, struct motion_ways *ways);

#endif
