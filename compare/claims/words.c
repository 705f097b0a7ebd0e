/* The claims in words, in the order of the ledger: name, place in the paper, what it is about, for what it is decided, by which
 * function, and with which parameter of the function (decide.h). A new claim is a row here, and its function if it is of a new kind. */
#include "compare/claims/decide.h"

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
static const char unique[] = "steady_state_is_unique", arrives[] = "steady_state_is_reached";

static const struct example body_2_sticks = { "m1 = 0.1, m2 = 1.9, F1 = 5.1, F2 = 1.2, L = 1, T = 0.93, alpha = 0.71",
                                              { 0.1, 1.9, 5.1, 1.2, 1, 0.93, 0.71, NULL },
                                              body_2_alone_sticks,
                                              true };
static const enum varied by_ratio = VARY_RATIO, by_forces = VARY_FORCES, by_period = VARY_PERIOD;

static const struct claim {
  const char *name, *place, *quantity;
  enum scope scope;
  decide *decide;
  const void *with;
} claims[] = {
  { "reversible_kinematics_do_not_move", "4.2", "displacement", ONCE, reversible_kinematics, NULL },
  { unique, "5", "v_start", ONCE, unique_with_jumps, NULL },

  { "equal_forces_do_not_move", "4.1", "displacement", EACH_GAIT, at_most, &equal_forces_do_not_move },
  { "symmetric_timing_does_not_move", "4.2", "displacement", EACH_GAIT, at_most, &symmetric_timing_does_not_move },
  { "steady_state_attracts", "4.3.2", "multiplier", EACH_GAIT, steady_state_attracts, NULL },
  { "motion_always_settles", "5", "v", EACH_GAIT, at_most, &motion_settles },
  { forward, "4.4", "displacement", EACH_GAIT, moves_forward, "sliding" },
  { forward, "4.4", "displacement", EACH_GAIT, moves_forward, NULL },
  { "one_body_always_moves", "2", "modes", EACH_GAIT, at_most, &one_body_moves },
  { "which_body_is_1_does_not_matter", "2", "displacement", EACH_GAIT, at_most, &bodies_are_exchanged },
  { "equal_forces_bodies_oppose", "(6), (7)", "modes", EACH_GAIT, at_most, &equal_forces_oppose },
  { rises, "4.2", "v_mid", EACH_GAIT, at_most, &velocity_rises },
  { "symmetric_timing_starts_backward", "4.2", "v_start", EACH_GAIT, at_most, &symmetric_timing_starts_backward },
  { extends, "4.3", "dx_C", EACH_GAIT, at_most, &centre_moves_forward },
  { "extension_from_rest_has_two_intervals", "4.3.1", "modes", EACH_GAIT, at_most, &two_intervals },
  { "first_interval_is_the_greater_part", "4.3.1", "dT", EACH_GAIT, at_most, &first_interval_is_greater },
  { "last_interval_grows_with_duration", "4.3.1", "dT", EACH_GAIT, at_most, &last_interval_grows },
  { "start_velocity_adds_displacement", "4.3.2", "dx_C", EACH_GAIT, at_most, &start_velocity_adds_displacement },
  { "start_velocity_takes_velocity_change", "4.3.2", "v_end", EACH_GAIT, at_most, &start_velocity_takes_velocity },
  { "start_velocity_is_forward_at_high_Froude", "5", "v_start", EACH_GAIT, at_most, &starts_forward_at_high_froude },
  { peaks, "4.4", "mean velocity", EACH_GAIT, peak_at_random, NULL },

  { "equal_forces_centre", "(8)", "dx_C", EACH_GAIT, equal_forces_centre, NULL },
  { "equal_forces_and_masses_keep_the_centre", "4.1", "dx_C", EACH_GAIT, still_centre, NULL },
  { rises, "4.2", "v_end", EACH_GAIT, falling_velocity, NULL },
  { extends, "4.3", "dx_C", EACH_GAIT, heavy_front, NULL },
  { "centre_moves_backward_in_a_contraction", "4.3", "dx_C", EACH_GAIT, steady_contraction, NULL },
  { "longer_extension_is_faster", "4.3", "l'", EACH_GAIT, longer_is_faster, NULL },
  { "first_interval_accelerates_l", "4.3.1", "l''", EACH_GAIT, first_interval_accelerates, NULL },
  { slower, "4.3.1", "v1, v2", EACH_GAIT, body_1_slower, &(const double){ 1 } },
  { slower, "4.3.1", "v1, v2", EACH_GAIT, body_1_slower, &(const double){ 0.5 } },
  { "last_interval_carries_the_centre_forward", "4.3.1, 5", "dx_C", EACH_GAIT, last_interval_carries, NULL },
  { "contraction_is_the_opposite_of_the_extension", "4.3.3", "v_end", EACH_GAIT, opposite_phases, NULL },

  { "only_body_1_sticks", "2", "modes", EACH_GAIT, example, &body_2_sticks },
  { "with_one_body_stuck_that_of_less_friction_moves", "2", "modes", EACH_GAIT, example, &body_2_sticks },
  { froude, "2, 5", "displacement", EACH_GAIT, example,
    &(const struct example){ "the paper's crawler, F1 = 34.9776: sliding", { .F1 = 34.9776 }, slides_and_moves, true } },
  { froude, "2, 5", "displacement", EACH_GAIT, example,
    &(const struct example){ "the paper's crawler, T = 6", { .T = 6 }, sticks_and_moves, true } },
  { froude, "2, 5", "displacement", EACH_GAIT, example,
    &(const struct example){ "the paper's crawler, T = 14", { .T = 14 }, sticks_and_moves, true } },
  { one_degree, "3, 5", "displacement", EACH_GAIT, example,
    &(const struct example){ "the paper's crawler", { .m1 = 0 }, slides_and_moves, false } },
  { one_degree, "3, 5", "displacement", EACH_GAIT, example,
    &(const struct example){ "the paper's crawler, F1 = 300", { .F1 = 300 }, sticks_and_moves, false } },
  { suffice, "3 (c), abstract", "displacement", EACH_GAIT, standstill, NULL },
  { suffice, "3 (c), abstract", "displacement", EACH_GAIT, example,
    &(const struct example){ "the paper's crawler, F1 = 1000", { .F1 = 1000 }, never_moves, true } },
  { "the_forces_must_differ_not_the_coefficients", "4.3.3", "displacement", EACH_GAIT, example,
    &(const struct example){ "the paper's crawler, m1 = 4: F1/m1 = F2/m2", { .m1 = 4 }, slides_and_moves, false } },
  { "kinematic_length", "4.3.3", "L_kin", EACH_GAIT, kinematic_length, NULL },
  { "start_velocity_is_forward_where_dv_C_rises", "4.4", "v_start", EACH_GAIT, forward_where_dv_rises, NULL },
  { "start_velocity_is_backward_where_dv_C_falls", "4.4", "v_start", EACH_GAIT, backward_where_dv_falls, NULL },
  { v_mid, "4.4", "v_mid", EACH_GAIT, v_mid_peaks, &by_ratio },
  { v_mid, "4.4", "v_mid", EACH_GAIT, v_mid_peaks, &by_forces },
  { v_mid, "4.4", "v_mid", EACH_GAIT, v_mid_peaks, &by_period },
  { loss, "4.4", "dx_C", EACH_GAIT, contraction_loses, &by_ratio },
  { loss, "4.4", "dx_C", EACH_GAIT, contraction_loses, &by_forces },
  { loss, "4.4", "dx_C", EACH_GAIT, contraction_loses, &by_period },
  { "start_velocity_opposes_motion_at_low_Froude", "5", "v_start", EACH_GAIT, example,
    &(const struct example){
        "the paper's crawler, F1 = 90, alpha = 0.55", { .F1 = 90, .alpha = 0.55 }, starts_and_moves_back, true } },
  { "start_velocity_has_two_regimes", "4.5, 5", "v_start", EACH_GAIT, two_regimes_exist, NULL },

  { "t1_is_small", "(A.6)", "t1", EACH_GAIT, t1_is_small, NULL },
  { "t1_is_small", "(A.6), 4.3.3", "t1", EACH_GAIT, t1_is_small, "steady" },
  { "B_x2_first_switch_exceeds_its_remainder", "(B.3)", "x2(t1)", EACH_GAIT, swallowed_term, NULL },
  { "rest_dT_without_remainder", "(13)", "dT", EACH_GAIT, without_remainder,
    &(const struct printed){ SCALLOP_EXTENSION, false, 0 } },
  { "A_t1_without_remainder", "(A.5)", "t1", EACH_GAIT, without_remainder,
    &(const struct printed){ SCALLOP_EXTENSION, true, 1 } },
  { "A_dT_without_remainder", "(A.14)", "dT", EACH_GAIT, without_remainder,
    &(const struct printed){ SCALLOP_EXTENSION, false, 1 } },
  { "B_t1_without_remainder", "(B.2)", "t1", EACH_GAIT, without_remainder,
    &(const struct printed){ SCALLOP_CONTRACTION, true, 1 } },
  { "B_dT_without_remainder", "(B.5)", "dT", EACH_GAIT, without_remainder,
    &(const struct printed){ SCALLOP_CONTRACTION, false, 1 } },

  { changes, "4.4", "v_start", EACH_CRAWLER, start_velocity_changes_sign, &by_ratio },
  { peaks, "4.4", "mean velocity", EACH_CRAWLER, peaks_at_boundary, &by_ratio },
  { "mean_velocity_has_one_maximum", "4.5", "mean velocity", EACH_CRAWLER, one_maximum, &by_ratio },
  { decays, "4.5", "mean velocity", EACH_CRAWLER, decays_once_sticking, &by_ratio },
  { changes, "4.4", "v_start", EACH_CRAWLER, start_velocity_changes_sign, &by_forces },
  { peaks, "4.4", "mean velocity", EACH_CRAWLER, peaks_at_boundary, &by_forces },
  { decays, "4.5", "mean velocity", EACH_CRAWLER, decays_once_sticking, &by_forces },
  { changes, "4.4", "v_start", EACH_CRAWLER, start_velocity_changes_sign, &by_period },
  { peaks, "4.4", "mean velocity", EACH_CRAWLER, peaks_at_boundary, &by_period },
  { decays, "4.5", "mean velocity", EACH_CRAWLER, decays_once_sticking, &by_period },
  { peaks, "4.4", "mean velocity", OF_THE_PAPER, peak_for_alphas, NULL },
  { peaks, "4.4", "mean velocity", OF_THE_PAPER, peak_for_masses, NULL },
  { grows, "4.4", "dx_C", EACH_CRAWLER, displacement_grows, NULL },
  { "velocity_change_is_not_monotone", "4.4", "dv_C", EACH_CRAWLER, velocity_change_peaks, NULL },
  { "mean_velocity_vanishes_at_ratio_1", "4.5", "mean velocity", EACH_CRAWLER, no_velocity_at_ratio_1, NULL },
  { "mean_velocity_vanishes_at_large_ratio", "4.5", "mean velocity", EACH_CRAWLER, no_velocity_at_large_ratio, NULL },
  { "mean_velocity_grows_with_alpha", "4.5", "mean velocity", EACH_CRAWLER, velocity_grows_with_alpha, NULL },
  { "mean_velocity_goes_as_1_over_T", "4.3.3", "mean velocity", EACH_CRAWLER, velocity_as_1_over_T, NULL },
  { limit, "(27)", "v_start", EACH_CRAWLER, velocity_in_the_limit, &(const struct alphas){ 51, 75, false } },
  { limit, "(27)", "v_start", EACH_CRAWLER, velocity_in_the_limit, &(const struct alphas){ 1, 25, false } },
  { "text_steady_velocity_mirrored_in_the_limit", "(27)", "v_start", OF_THE_PAPER, velocity_in_the_limit,
    &(const struct alphas){ 1, 25, true } },
  { grows, "4.4", "dx_C", OF_THE_PAPER, never_falls, &(const struct ratios){ "2, 4, 10, 40", 4, { 2, 4, 10, 40 } } },
  { grows, "4.4", "dx_C", OF_THE_PAPER, never_falls, &(const struct ratios){ "1/4, 1/2", 2, { 0.25, 0.5 } } },
  { grows, "4.4", "dx_C", OF_THE_PAPER, displacement_from_rest, NULL },
  { unique, "5", "v_start", OF_THE_PAPER, steady_state_is_unique, NULL },
  { arrives, "5", "v", OF_THE_PAPER, reached, &(const double){ 2 } },
  { arrives, "5", "v", OF_THE_PAPER, reached, &(const double){ 4 } },
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
  q.with = claim->with;
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
