/* The functions that decide the claims in words, one for each row of the table in words.c. Not public. */
#ifndef SCALLOP_CLAIMS_WORDS_H
#define SCALLOP_CLAIMS_WORDS_H

#include "compare/claims/evidence.h"

/* Fills in conditions, measured, reason and verdict, and inside where that is not true; without conditions there is no row. */
typedef void decide(struct question *q);

/* random.c: every crawler */
decide equal_forces_do_not_move, symmetric_timing_does_not_move, steady_state_attracts, motion_settles,
    sliding_moves_forward, sticking_moves_forward, one_body_moves, bodies_are_exchanged, equal_forces_oppose, velocity_rises,
    symmetric_timing_starts_backward, centre_moves_forward, two_intervals, first_interval_is_greater, last_interval_grows,
    start_velocity_adds_displacement, start_velocity_takes_velocity, starts_forward_at_high_froude, displacement_from_rest,
    steady_state_is_unique;
/* phases.c: a single phase */
decide equal_forces_centre, still_centre, falling_velocity, heavy_front, steady_contraction, longer_is_faster,
    first_interval_accelerates, body_1_slower, light_body_1_slower, last_interval_carries, opposite_phases, t1_from_1,
    t1_from_steady_state, swallowed_term, dT_from_rest, t1_of_extension, dT_of_extension, t1_of_contraction,
    dT_of_contraction;
/* steady.c: steady states */
decide reversible_kinematics, unique_with_jumps, body_2_sticks, low_froude, lower_froude, lowest_froude, sliding_moves,
    stick_slip_moves, standstill, stays_at_rest, equal_coefficients_move, kinematic_length, forward_where_dv_rises,
    backward_where_dv_falls, starts_back, two_regimes_exist, velocity_of_longer_extension, velocity_of_longer_contraction,
    velocity_mirrored, reached_at_T_2, reached_at_T_4;
/* boundary.c: where the start velocity vanishes */
decide peak_at_random, sign_changes_by_ratio, sign_changes_by_forces, sign_changes_by_period, peaks_by_ratio,
    peaks_by_forces, peaks_by_period, one_maximum, decays_by_ratio, decays_by_forces, decays_by_period, peak_for_alphas,
    peak_for_masses, v_mid_peaks_by_ratio, v_mid_peaks_by_forces, v_mid_peaks_by_period, contraction_loses_by_ratio,
    contraction_loses_by_forces, contraction_loses_by_period;
/* figures.c */
decide displacement_grows, velocity_change_peaks, displacement_of_strong_rear, displacement_of_weak_rear,
    no_velocity_at_ratio_1, no_velocity_at_large_ratio, velocity_grows_with_alpha, velocity_as_1_over_T;

#endif
