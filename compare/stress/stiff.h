/* Friction smoothed over delta (scallop_smoothed_integrator): one period from the exact steady start, as delta -> 0.
 * Needs FLINT. */
#ifndef SCALLOP_COMPARE_STRESS_STIFF_H
#define SCALLOP_COMPARE_STRESS_STIFF_H

#include "compare/answers/answer.h"

/* The longest time, within a phase of the exact period, for which a body is stuck. Smoothed friction makes it creep at
 * the velocity whose friction is the force that holds it, v_delta artanh(force/friction), v_delta = delta L/T. */
struct stiff_held {
  int body; /* 1 or 2; 0: no body is stuck for any length of time */
  enum scallop_phase_kind phase;
  double v0;         /* velocity of both bodies where that phase begins */
  double begin, end; /* since the phase began */
  double force;      /* |force|/friction in the middle of the stretch */
  double velocity;   /* in the middle, over v_delta, with its sign */
  double creep;      /* distance over the stretch, over delta L */
};

struct stiff_scene {
  const char *names[4]; /* its own, that of the gait, of the regime and of the stepper */
  struct scallop_crawler crawler;
  struct scallop_scaled scaled;
  double v_start;                          /* the certified steady one, rounded */
  struct scallop_wide v_end, displacement; /* in binary128, of the period from this very v_start */
  char modes[MOTION_MODES_TEXT];
  struct stiff_held held;
};
/* NULL, or why there is nothing to compare with. GSL's error handler must be off. */
const char *stiff_scene_init(struct stiff_scene *scene, const char *name, const struct scallop_crawler *crawler);

enum { STIFF_V_END, STIFF_DISPLACEMENT, STIFF_CREEP, STIFF_QUANTITIES, STIFF_STATUS = 80 };
struct stiff_run { /* nan: not known */
  double delta, tolerance;
  double error[STIFF_QUANTITIES]; /* smoothed - exact, over L/T and L; all of creep, which ought to be 0 */
  double own[STIFF_QUANTITIES];   /* of the stepper: how much the answer changes with ten times the tolerance */
  double creep_over_delta, velocity, last;    /* of the held body; in the middle and at the end, over v_delta */
  double predicted_creep, predicted_velocity; /* those of struct stiff_held */
  double steps, evaluations;                  /* of the period */
  bool solved;
  char status[STIFF_STATUS]; /* "ok", or why it gave up, and after how many steps */
};
/* The tolerance that goes with delta: where all of the steppers leave the error of the model for as long as they can,
 * and no less than rounding allows. */
double stiff_tolerance(double delta);
/* tolerance: a tenth of the largest that the integrator takes at most. most: accepted steps that a period, or the
 * phase of the stretch, may take. */
void stiff_solve(const struct stiff_scene *scene, double delta, double tolerance, long most, struct stiff_run *run);

#endif
