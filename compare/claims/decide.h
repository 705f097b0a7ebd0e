/* How the claims in words are decided: functions, some with a parameter, which the row of a claim (words.c) gives as q->with. A function
 * fills in conditions, measured, reason and verdict, and inside where that is not true; without conditions there is no row. Not public. */
#ifndef SCALLOP_CLAIMS_DECIDE_H
#define SCALLOP_CLAIMS_DECIDE_H

#include "compare/claims/family.h"

typedef void decide(struct question *q);

/* random.c: every crawler. A bound holds if the largest value of the probe over random crawlers is not above the limit. */
typedef double probe(struct scallop_crawler c);
struct bound {
  const char *conditions;
  double limit;
  probe *probe;
  const char *below, *above; /* what is measured where the bound holds, and where it does not */
};
decide at_most; /* with a bound: */
extern const struct bound equal_forces_do_not_move, symmetric_timing_does_not_move, motion_settles, one_body_moves,
    bodies_are_exchanged, equal_forces_oppose, velocity_rises, symmetric_timing_starts_backward, centre_moves_forward,
    two_intervals, first_interval_is_greater, last_interval_grows, start_velocity_adds_displacement,
    start_velocity_takes_velocity, starts_forward_at_high_froude;
decide steady_state_attracts, displacement_from_rest, steady_state_is_unique;
decide moves_forward; /* with anything: those that slide; NULL: those in stick-slip */

/* phases.c: a single phase */
decide equal_forces_centre, still_centre, falling_velocity, heavy_front, steady_contraction, longer_is_faster,
    first_interval_accelerates, last_interval_carries, opposite_phases, swallowed_term;
decide body_1_slower; /* with a double: m1 */
decide t1_is_small;   /* with anything: from the steady start velocity; NULL: from v0 = 1 */
struct printed {      /* t1 or dT by a formula of the paper, from v0 */
  enum scallop_phase_kind kind;
  bool is_t1;
  double v0;
};
decide without_remainder; /* with a struct printed */

/* steady.c: steady states. An example: the paper's crawler with these numbers (0: the paper's) does that. Does this refute the claim? */
typedef bool deed(const struct scallop_certified_steady *s);
deed slides_and_moves, sticks_and_moves, never_moves, body_2_alone_sticks, starts_and_moves_back;
struct example {
  const char *conditions;
  struct scallop_crawler with;
  deed *does;
  bool refutes;
};
decide example; /* with a struct example */
decide reversible_kinematics, unique_with_jumps, standstill, kinematic_length, forward_where_dv_rises,
    backward_where_dv_falls, two_regimes_exist;
struct alphas { /* in hundredths, from first on by 8; one of them to name; (27) as it is, or of the bodies exchanged */
  int first, shown;
  bool mirrored;
};
decide velocity_in_the_limit; /* with a struct alphas */
decide reached;               /* with a double: T */

/* boundary.c: where the start velocity vanishes; with an enum varied (family.h) */
decide start_velocity_changes_sign, peaks_at_boundary, one_maximum, decays_once_sticking, v_mid_peaks, contraction_loses;
decide peak_for_alphas, peak_for_masses, peak_at_random; /* with nothing */

/* figures.c */
struct ratios { /* F1/F2 */
  const char *text;
  int count;
  double value[4];
};
decide never_falls; /* with a struct ratios */
decide displacement_grows, velocity_change_peaks, no_velocity_at_ratio_1, no_velocity_at_large_ratio,
    velocity_grows_with_alpha, velocity_as_1_over_T;

#endif
