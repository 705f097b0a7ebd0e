/* The claims in words, in the order of the ledger: name, place in the paper, what it is about, for what it is decided, and by which
 * function. A new claim is a row here and its function. */
#include "compare/claims/words.h"

#include <math.h>
#include <stdio.h>

/* For what a claim is decided: once, for each gait, for each gait with the paper's crawler and with the ledger's, with the paper's. */
enum scope { ONCE, EACH_GAIT, EACH_CRAWLER, OF_THE_PAPER };

static const char forward[] = "longer_extension_moves_forward", extends[] = "centre_moves_forward_in_an_extension";
static const char rises[] = "velocity_rises_over_extension", slower[] = "body_1_is_slower_in_the_first_interval";
static const char froude[] = "moving_needs_a_high_Froude_number", one_degree[] = "one_degree_of_freedom_can_move";
static const char suffice[] = "two_asymmetries_suffice_to_move", v_mid[] = "v_mid_peaks_where_v_start_is_0";
static const char loss[] = "contraction_loses_least_where_v_start_is_0", changes[] = "start_velocity_changes_sign";
static const char peaks[] = "mean_velocity_peaks_where_v_start_is_0", decays[] = "mean_velocity_decays_once_sticking_begins";
static const char limit[] = "text_steady_velocity_in_the_limit", grows[] = "displacement_grows_with_duration";
static const char unique[] = "steady_state_is_unique", reached[] = "steady_state_is_reached";

static const struct claim {
  const char *name, *place, *quantity;
  enum scope scope;
  decide *decide;
} claims[] = {
  { "reversible_kinematics_do_not_move", "4.2", "displacement", ONCE, reversible_kinematics },
  { unique, "5", "v_start", ONCE, unique_with_jumps },

  { "equal_forces_do_not_move", "4.1", "displacement", EACH_GAIT, equal_forces_do_not_move },
  { "symmetric_timing_does_not_move", "4.2", "displacement", EACH_GAIT, symmetric_timing_does_not_move },
  { "steady_state_attracts", "4.3.2", "multiplier", EACH_GAIT, steady_state_attracts },
  { "motion_always_settles", "5", "v", EACH_GAIT, motion_settles },
  { forward, "4.4", "displacement", EACH_GAIT, sliding_moves_forward },
  { forward, "4.4", "displacement", EACH_GAIT, sticking_moves_forward },
  { "one_body_always_moves", "2", "modes", EACH_GAIT, one_body_moves },
  { "which_body_is_1_does_not_matter", "2", "displacement", EACH_GAIT, bodies_are_exchanged },
  { "equal_forces_bodies_oppose", "(6), (7)", "modes", EACH_GAIT, equal_forces_oppose },
  { rises, "4.2", "v_mid", EACH_GAIT, velocity_rises },
  { "symmetric_timing_starts_backward", "4.2", "v_start", EACH_GAIT, symmetric_timing_starts_backward },
  { extends, "4.3", "dx_C", EACH_GAIT, centre_moves_forward },
  { "extension_from_rest_has_two_intervals", "4.3.1", "modes", EACH_GAIT, two_intervals },
  { "first_interval_is_the_greater_part", "4.3.1", "dT", EACH_GAIT, first_interval_is_greater },
  { "last_interval_grows_with_duration", "4.3.1", "dT", EACH_GAIT, last_interval_grows },
  { "start_velocity_adds_displacement", "4.3.2", "dx_C", EACH_GAIT, start_velocity_adds_displacement },
  { "start_velocity_takes_velocity_change", "4.3.2", "v_end", EACH_GAIT, start_velocity_takes_velocity },
  { "start_velocity_is_forward_at_high_Froude", "5", "v_start", EACH_GAIT, starts_forward_at_high_froude },
  { peaks, "4.4", "mean velocity", EACH_GAIT, peak_at_random },

  { "equal_forces_centre", "(8)", "dx_C", EACH_GAIT, equal_forces_centre },
  { "equal_forces_and_masses_keep_the_centre", "4.1", "dx_C", EACH_GAIT, still_centre },
  { rises, "4.2", "v_end", EACH_GAIT, falling_velocity },
  { extends, "4.3", "dx_C", EACH_GAIT, heavy_front },
  { "centre_moves_backward_in_a_contraction", "4.3", "dx_C", EACH_GAIT, steady_contraction },
  { "longer_extension_is_faster", "4.3", "l'", EACH_GAIT, longer_is_faster },
  { "first_interval_accelerates_l", "4.3.1", "l''", EACH_GAIT, first_interval_accelerates },
  { slower, "4.3.1", "v1, v2", EACH_GAIT, body_1_slower },
  { slower, "4.3.1", "v1, v2", EACH_GAIT, light_body_1_slower },
  { "last_interval_carries_the_centre_forward", "4.3.1, 5", "dx_C", EACH_GAIT, last_interval_carries },
  { "contraction_is_the_opposite_of_the_extension", "4.3.3", "v_end", EACH_GAIT, opposite_phases },

  { "only_body_1_sticks", "2", "modes", EACH_GAIT, body_2_sticks },
  { "with_one_body_stuck_that_of_less_friction_moves", "2", "modes", EACH_GAIT, body_2_sticks },
  { froude, "2, 5", "displacement", EACH_GAIT, low_froude },
  { froude, "2, 5", "displacement", EACH_GAIT, lower_froude },
  { froude, "2, 5", "displacement", EACH_GAIT, lowest_froude },
  { one_degree, "3, 5", "displacement", EACH_GAIT, sliding_moves },
  { one_degree, "3, 5", "displacement", EACH_GAIT, stick_slip_moves },
  { suffice, "3 (c), abstract", "displacement", EACH_GAIT, standstill },
  { suffice, "3 (c), abstract", "displacement", EACH_GAIT, stays_at_rest },
  { "the_forces_must_differ_not_the_coefficients", "4.3.3", "displacement", EACH_GAIT, equal_coefficients_move },
  { "kinematic_length", "4.3.3", "L_kin", EACH_GAIT, kinematic_length },
  { "start_velocity_is_forward_where_dv_C_rises", "4.4", "v_start", EACH_GAIT, forward_where_dv_rises },
  { "start_velocity_is_backward_where_dv_C_falls", "4.4", "v_start", EACH_GAIT, backward_where_dv_falls },
  { v_mid, "4.4", "v_mid", EACH_GAIT, v_mid_peaks_by_ratio },
  { v_mid, "4.4", "v_mid", EACH_GAIT, v_mid_peaks_by_forces },
  { v_mid, "4.4", "v_mid", EACH_GAIT, v_mid_peaks_by_period },
  { loss, "4.4", "dx_C", EACH_GAIT, contraction_loses_by_ratio },
  { loss, "4.4", "dx_C", EACH_GAIT, contraction_loses_by_forces },
  { loss, "4.4", "dx_C", EACH_GAIT, contraction_loses_by_period },
  { "start_velocity_opposes_motion_at_low_Froude", "5", "v_start", EACH_GAIT, starts_back },
  { "start_velocity_has_two_regimes", "4.5, 5", "v_start", EACH_GAIT, two_regimes_exist },

  { "t1_is_small", "(A.6)", "t1", EACH_GAIT, t1_from_1 },
  { "t1_is_small", "(A.6), 4.3.3", "t1", EACH_GAIT, t1_from_steady_state },
  { "B_x2_first_switch_exceeds_its_remainder", "(B.3)", "x2(t1)", EACH_GAIT, swallowed_term },
  { "rest_dT_without_remainder", "(13)", "dT", EACH_GAIT, dT_from_rest },
  { "A_t1_without_remainder", "(A.5)", "t1", EACH_GAIT, t1_of_extension },
  { "A_dT_without_remainder", "(A.14)", "dT", EACH_GAIT, dT_of_extension },
  { "B_t1_without_remainder", "(B.2)", "t1", EACH_GAIT, t1_of_contraction },
  { "B_dT_without_remainder", "(B.5)", "dT", EACH_GAIT, dT_of_contraction },

  { changes, "4.4", "v_start", EACH_CRAWLER, sign_changes_by_ratio },
  { peaks, "4.4", "mean velocity", EACH_CRAWLER, peaks_by_ratio },
  { "mean_velocity_has_one_maximum", "4.5", "mean velocity", EACH_CRAWLER, one_maximum },
  { decays, "4.5", "mean velocity", EACH_CRAWLER, decays_by_ratio },
  { changes, "4.4", "v_start", EACH_CRAWLER, sign_changes_by_forces },
  { peaks, "4.4", "mean velocity", EACH_CRAWLER, peaks_by_forces },
  { decays, "4.5", "mean velocity", EACH_CRAWLER, decays_by_forces },
  { changes, "4.4", "v_start", EACH_CRAWLER, sign_changes_by_period },
  { peaks, "4.4", "mean velocity", EACH_CRAWLER, peaks_by_period },
  { decays, "4.5", "mean velocity", EACH_CRAWLER, decays_by_period },
  { peaks, "4.4", "mean velocity", OF_THE_PAPER, peak_for_alphas },
  { peaks, "4.4", "mean velocity", OF_THE_PAPER, peak_for_masses },
  { grows, "4.4", "dx_C", EACH_CRAWLER, displacement_grows },
  { "velocity_change_is_not_monotone", "4.4", "dv_C", EACH_CRAWLER, velocity_change_peaks },
  { "mean_velocity_vanishes_at_ratio_1", "4.5", "mean velocity", EACH_CRAWLER, no_velocity_at_ratio_1 },
  { "mean_velocity_vanishes_at_large_ratio", "4.5", "mean velocity", EACH_CRAWLER, no_velocity_at_large_ratio },
  { "mean_velocity_grows_with_alpha", "4.5", "mean velocity", EACH_CRAWLER, velocity_grows_with_alpha },
  { "mean_velocity_goes_as_1_over_T", "4.3.3", "mean velocity", EACH_CRAWLER, velocity_as_1_over_T },
  { limit, "(27)", "v_start", EACH_CRAWLER, velocity_of_longer_extension },
  { limit, "(27)", "v_start", EACH_CRAWLER, velocity_of_longer_contraction },
  { "text_steady_velocity_mirrored_in_the_limit", "(27)", "v_start", OF_THE_PAPER, velocity_mirrored },
  { grows, "4.4", "dx_C", OF_THE_PAPER, displacement_of_strong_rear },
  { grows, "4.4", "dx_C", OF_THE_PAPER, displacement_of_weak_rear },
  { grows, "4.4", "dx_C", OF_THE_PAPER, displacement_from_rest },
  { unique, "5", "v_start", OF_THE_PAPER, steady_state_is_unique },
  { reached, "5", "v", OF_THE_PAPER, reached_at_T_2 },
  { reached, "5", "v", OF_THE_PAPER, reached_at_T_4 },
};
enum { CLAIMS = sizeof claims / sizeof *claims };

static void add_row(struct ledger *ledger, const struct claim *claim, const struct scallop_crawler *crawler,
                    bool of_the_paper)
{
  struct question q;
  question_init(&q);
  q.crawler = *crawler;
  q.of_the_paper = of_the_paper;
  q.whose = of_the_paper ? "the paper's crawler" : "the ledger's crawler";
  q.row = (struct claim_row){ .equation = claim->place,
                              .quantity = claim->quantity,
                              .gait = crawler->gait->name,
                              .inside = of_the_paper,
                              .claimed_order = NAN,
                              .slope = NAN,
                              .fit = { .order = NAN, .lo = NAN, .hi = NAN } };
  snprintf(q.row.claim, sizeof q.row.claim, "%s", claim->name);
  claim->decide(&q);
  if (q.row.verdict == CLAIM_HOLDS)
    *q.row.reason = '\0';
  if (*q.row.conditions)
    ledger_add(ledger, &q.row);
  question_clear(&q);
}

static void add_rows(struct ledger *ledger, enum scope first, enum scope last, const struct scallop_crawler *crawler,
                     bool of_the_paper)
{
  for (int i = 0; i < CLAIMS; i++)
    if (claims[i].scope >= first && claims[i].scope <= last)
      add_row(ledger, &claims[i], crawler, of_the_paper);
}

void ledger_add_words(struct ledger *ledger, const struct scallop_crawler *crawler, const struct scallop_gait *gait)
{
  struct scallop_crawler paper = scallop_crawler_default(), own = *crawler;
  own.T = 0.5 * natural_time(crawler);
  if (!gait)
    add_rows(ledger, ONCE, ONCE, &paper, true);
  for (int g = 0; gait ? g == 0 : scallop_gait_name(g) != NULL; g++) {
    paper.gait = own.gait = gait ? gait : scallop_gait_named(scallop_gait_name(g));
    add_rows(ledger, EACH_GAIT, EACH_GAIT, &paper, true);
    add_rows(ledger, EACH_CRAWLER, OF_THE_PAPER, &paper, true);
    add_rows(ledger, EACH_CRAWLER, EACH_CRAWLER, &own, false);
  }
}
