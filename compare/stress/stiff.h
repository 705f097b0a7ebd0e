/* Smoothed friction (scallop_smoothed_integrator): one period from the exact steady start, as its width delta -> 0.
 * Needs FLINT. */
#ifndef SCALLOP_COMPARE_STRESS_STIFF_H
#define SCALLOP_COMPARE_STRESS_STIFF_H

#include "compare/answers/answer.h"

/* Longest interval, within a phase of the exact period, in which a body is stuck. With smoothed friction the body
 * creeps at a velocity v_delta artanh(force/friction), v_delta = delta L/T, to balance the force on it. */
struct stiff_interval {
  int body; /* 1 or 2; 0: no body is ever stuck */
  enum scallop_phase_kind phase;
  double v0;         /* of both bodies at the start of this phase */
  double begin, end; /* since the start of the phase */
  double force;      /* |force|/friction in the middle */
  double velocity;   /* in the middle, over v_delta, with its sign */
  double creep;      /* distance in the interval, over delta L */
};

struct stiff_scene {
  const char *names[4]; /* of scene, gait, regime and stepper */
  struct scallop_crawler crawler;
  struct scallop_scaled scaled;
  double v_start;                          /* the certified steady one, rounded */
  struct scallop_wide v_end, displacement; /* in binary128, of the period from exactly this v_start */
  char modes[MOTION_MODES_TEXT];
  struct stiff_interval stuck;
};
/* Solves the exact period. Returns NULL, or the reason of a failure. GSL's error handler must be off. */
const char *stiff_scene_init(struct stiff_scene *scene, const char *name, const struct scallop_crawler *crawler);

enum { STIFF_V_END, STIFF_DISPLACEMENT, STIFF_CREEP, STIFF_QUANTITIES, STIFF_STATUS = 80 };
struct stiff_result { /* nan: unknown */
  double delta, tolerance;
  double error[STIFF_QUANTITIES];             /* smoothed - exact, over L/T and L; exact creep is 0 */
  double own_error[STIFF_QUANTITIES];         /* of the stepper: change of the answer with ten times the tolerance */
  double creep_over_delta, velocity, last;    /* of the stuck body; in the middle and at the end, over v_delta */
  double predicted_creep, predicted_velocity; /* from struct stiff_interval */
  double steps, evaluations;                  /* of the period */
  bool solved;
  char status[STIFF_STATUS]; /* "ok", or the reason of a failure, and the number of steps before it */
};
/* Returns a tolerance for delta that makes the stepper's error small beside the model's, as far as rounding allows. */
double stiff_tolerance(double delta);
/* Solves one period with smoothed friction, and the phase of the stuck interval. tolerance: at most a tenth of the
 * integrator's largest; max_steps: accepted steps allowed for either */
void stiff_solve(const struct stiff_scene *scene, double delta, double tolerance, long max_steps,
                 struct stiff_result *result);

#endif
