/* Phases, periods and steady states in double, and the rates of a piece of a gait. Not public. */
#ifndef SCALLOP_NUMERICS_EVENT_MOTION_H
#define SCALLOP_NUMERICS_EVENT_MOTION_H

#include <float.h>
#include <math.h>

#include "model/law.h"

typedef double real;
#define ROUNDING (DBL_EPSILON / 2)
#define SMALL_STEP 1e-9
#define SMALL_THIRD_STEP 2e-6
#define SOLVE
#include "numerics/event/period.h"

/* Numbers for which double is not enough; numerics.c computes them again in wider arithmetic. */
struct doubt {
  /* the fraction of the parts of a displacement that is left, if it needs wider arithmetic; else 1 */
  double left;
  /* a change of the start velocity by less than an ulp changes the multiplier */
  bool delicate;
  bool amplified; /* left is of a velocity: rounding of times, or of what friction has taken, is many ulp of it */
};
/* As scallop_phase, scallop_period and scallop_steady, in double alone. */
enum scallop_status solve_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                                struct scallop_phase_result *result, struct doubt *doubt);
enum scallop_status solve_period(const struct scallop_crawler *crawler, double v0, struct scallop_period_result *result,
                                 struct doubt *doubt);
enum scallop_status solve_steady(const struct scallop_crawler *crawler, struct scallop_steady_result *result,
                                 struct doubt *doubt);

/* Neither the start velocity nor the time in which friction may undo it is lost in the scaling. */
static inline bool start_is_kept(double v0, double c0, double eps)
{
  return v0 == 0 || (fabs(c0) < DBL_MAX && fabs(c0) / (64 * (1 + eps)) > 0);
}

/* The crawler and the velocity of its start in units of L and T, or, for a phase, c0 in L/tau. SCALLOP_EDOMAIN: a bad
 * crawler, or v0 not finite; SCALLOP_ERANGE: scaling overflows, or loses v0. */
static inline enum scallop_status start_scaled(const struct scallop_crawler *crawler, double v0,
                                               struct scallop_scaled *scaled, double *c0)
{
  enum scallop_status status = scallop_scale(crawler, scaled);
  if (status != SCALLOP_OK)
    return status;
  if (!isfinite(v0))
    return SCALLOP_EDOMAIN;
  *c0 = v0 / scaled->velocity;
  return start_is_kept(v0, *c0, scaled->eps) ? SCALLOP_OK : SCALLOP_ERANGE;
}

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

/* The mean of sgn l' over the period: 2 alpha - 1 for the usual gaits, correctly rounded */
SCALLOP_INLINE double period_driven(const struct scallop_gait *gait, double alpha)
{
  double e = gait->phase[SCALLOP_EXTENSION].net, c = gait->phase[SCALLOP_CONTRACTION].net;
  return alpha * (e - c) + c;
}

/* Returns whether the phases are nearly mirror images: then all but about 2 alpha - 1 of their displacement cancels. */
SCALLOP_INLINE int period_undoes(double driven) { return (driven < 0 ? -driven : driven) < 0x1p-10; }

/* fraction: of the period */
SCALLOP_INLINE struct phase_input phase_input_of(const struct scallop_scaled *s, const struct scallop_shape *shape,
                                                 double fraction)
{
  return (struct phase_input){ shape, s->mu1, s->mu2, s->f1, s->f2, s->delta, s->eps * (fraction * fraction), 0 };
}
struct walker walker_of(const struct scallop_scaled *scaled);

/* Solves a phase without a walk (concave_phase). Returns false if it is of another kind. */
bool short_cut(const struct phase_input *input, double c_0, struct period_motion *motion);

/* Returns the fraction of the velocity that friction has left at the end, if it is so small that rounding of the rest
 * shows; else 1, also for two straight pieces. */
double motion_left(const struct scallop_shape *shape, const struct period_motion *motion);

/* Velocities in L/T, the displacement in L */
void period_result(const struct walker *walker, const struct period *period, struct scallop_period_result *result);

#endif
