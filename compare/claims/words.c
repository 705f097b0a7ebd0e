/* The claims in words about families of crawlers, and how the rows of all claims in words come into the ledger
 * (decide.h). */
#include "compare/claims/decide.h"

#include <math.h>
#include <stdio.h>

#include "compare/claims/evidence.h"

static const char peaks[] = "mean_velocity_peaks_where_v_start_is_0", grows[] = "displacement_grows_with_duration";
static const char survey[] = "{whose}; {1}", ratios[] = "{whose}, from rest, F1/F2 = 2, 10, 40";
static const char two[] = "steady at=x1; steady at=x2", not_higher[] = "mean_velocity:2 <= mean_velocity";

#define CHANGES(by) \
  { \
    "start_velocity_changes_sign", "4.4", "v_start", start_velocity_changes_sign, survey, \
        .varied = (by), .measured = "{+certified: v_start > 0 at {2} = {10g x1} (1 - 2^-60) and not at (1 + 2^-60)}", \
        .reason = "no change of sign was proven" \
  }
#define PEAKS(by) \
  { \
    peaks, "4.4", "mean velocity", peaks_at_boundary, survey, two, \
        .varied = (by), .says = not_higher, \
        .measured = "at {2} = {10g x3} the certified slope d({3})/d ln is {6f x4} before, {6f x5} after; {3} is {6f " \
                    "x6} there, highest {6f x7} at {4g x8}{4}", \
        .reason = "mean_velocity is lower at the boundary, the first row: {table} | cut -f {5}" \
  }
/* Only of F1/F2 does the paper say so without restriction to sliding. */
#define DECAYS(by, where) \
  { \
    "mean_velocity_decays_once_sticking_begins", "4.5", "mean velocity", decays_once_sticking, \
        "{whose}; {1}, where a body sticks" where, two, \
        .varied = (by), .outside = (by) != VARY_RATIO, .says = not_higher, \
        .measured = "{+it never rises between neighbours}{-certified: {3} rises from {6f mean_velocity*T:0/L} at {2} " \
                    "= {6g x1} to {6f mean_velocity:2*T:0/L} at {6g x2}{4}}", \
        .reason = "mean_velocity rises, in stick-slip: {table} | cut -f {5}" \
  }

/* (27) for alphas 0.08 apart */
#define IN_THE_LIMIT(from, to, and_so, shown) \
  "(27)", "v_start", velocity_in_the_limit, "{whose}, T = 1e-20, alpha from " from " to " to " by 0.08" and_so, \
      "steady alpha=x4 T=1e-20; steady alpha=x4 T=1e-20 m1=m2 m2=m1 F1=F2 F2=F1", \
      .says = "abs(x1) < 1e-15", \
      .measured = "relative error, certified: {+below 1e-15 throughout}{-{6f x3} at alpha = " shown \
                  ", largest {6f x1} at alpha = {2f x2}}", \
      .reason = "published against exact: scallop series --T 1e-6 --alpha " shown \
                "{options:0} | grep '^text_steady_velocity.(27)'"
static const char relative_error[] = "text_steady_velocity/v_start - 1";
static const struct alphas upper_half = { 51, 75, relative_error }, lower_half = { 1, 25, relative_error };
static const struct alphas mirrored = { 1, 25, "-text_steady_velocity:2/v_start - 1" };

#define NEVER_FALLS(text, ...) \
  { \
    grows, "4.4", "dx_C", never_falls, \
        "the paper's crawler, F1/F2 = " text ", from v0 = 0.5, 1, 2, 5, 10, 20; T from 0.05 to 8.4 by 2 %", \
        "extension F1=x1 v0=x2 T=x3; extension F1=x1 v0=x2 T=x4", \
        .says = "dxC <= dxC:2", \
        .measured = "{+it never falls by more than 1e-14 L}{-certified: from v0 = {6g x2} at F1 = {6g x1} dx_C/L is " \
                    "{6f dxC/L} for T = {4g x3} and {6f dxC:2/L} for T = {4g x4}; these extensions last {6g " \
                    "duration} and {6g duration:2}}", \
        .reason = "dxC falls from the first row to the second: printf 'T\\n{4g x3}\\n{4g x4}\\n' | scallop phase " \
                  "--points - --F1 {6g x1} --v0 {6g x2}{options:0} | cut -f 6,16", \
        .with = (const double[]){ __VA_ARGS__, 0 }, .outside = true, .of_its_crawler = true \
  }
#define REACHED(T) \
  { \
    "steady_state_is_reached", "5", "v", reached, \
        "the paper's crawler, T = " T ", from rest; read as: after finitely many periods", "steady T=" T, \
        .says = "multiplier = 0", \
        .measured = "certified multiplier {+0; from rest the velocity is the steady one after {0f x1} period}{-{10f " \
                    "multiplier} > 0: the distance shrinks by that and is never 0; within 1e-6 L/T after {0f x2} " \
                    "periods}", \
        .reason = "the multiplier is not 0: scallop steady --certified{options} | cut -f 14", .of_its_crawler = true \
  }

const struct claim claims_of_families[] = {
  CHANGES(VARY_RATIO),
  PEAKS(VARY_RATIO),
  { "mean_velocity_has_one_maximum", "4.5", "mean velocity", one_maximum,
    "{whose}; {1}: \"increases to a maximum and then decays to zero\"", "steady at=x1; steady at=x2; steady at=x3",
    .varied = VARY_RATIO, .measured = "certified maxima of <U> T/L: {0f x4};{4}",
    .reason = "mean_velocity falls and rises again: {table} | cut -f {5}" },
  DECAYS(VARY_RATIO, ": \"then decays to zero as the asymmetry increases\""),
  CHANGES(VARY_FORCES),
  PEAKS(VARY_FORCES),
  DECAYS(VARY_FORCES, ""),
  CHANGES(VARY_PERIOD),
  PEAKS(VARY_PERIOD),
  DECAYS(VARY_PERIOD, ""),
  { grows, "4.4", "dx_C", displacement_grows, ratios, .says = "min(x1, x2, x3) > 0",
    .measured = "least d(dx_C) over d((F1-F2)T^2/(2M)), 400 durations up to sticking: {6f min(x1, x2, x3)}" },
  { "velocity_change_is_not_monotone", "4.4", "dv_C", velocity_change_peaks, ratios, .says = "max(x1, x2, x3) < 0.99",
    .measured = "dv_C peaks at {6f x1}, {6f x2}, {6f x3} of the duration at which sticking begins" },
  { "mean_velocity_vanishes_at_ratio_1", "4.5", "mean velocity", proven, "{whose}", "steady F1=F2",
    .says = "mean_velocity = 0", .measured = "|mean velocity| T/L at F1/F2 = 1: {+below}{-above} 1e-14" },
  { "mean_velocity_vanishes_at_large_ratio", "4.5", "mean velocity", proven, "{whose}",
    "steady F1=1e2*F2; steady F1=1e4*F2; steady F1=1e6*F2", .says = "mean_velocity:3 = 0",
    .measured = "mean velocity T/L at F1/F2 = 1e2, 1e4, 1e6: {3g mean_velocity*T/L}, {3g mean_velocity:2*T/L}, {3g "
                "mean_velocity:3*T/L}" },
  { "mean_velocity_grows_with_alpha", "4.5", "mean velocity", velocity_grows_with_alpha,
    "{whose}, alpha from 0.50 to 0.99", .says = "x1 > 0",
    .measured = "least change of mean velocity T/L between alphas 0.01 apart: {3g x1} at alpha = {2f x2}" },
  { "mean_velocity_goes_as_1_over_T", "4.3.3", "mean velocity", velocity_as_1_over_T, "{whose}",
    .says = "abs(x1 + 1) <= 0.02", .measured = "mean velocity ~ T^{3f x1}" },
  { "text_steady_velocity_in_the_limit", IN_THE_LIMIT("0.51", "0.99", "", "0.75"), .with = &upper_half },
  { "text_steady_velocity_in_the_limit", IN_THE_LIMIT("0.01", "0.49", "", "0.25"), .with = &lower_half },
  { "text_steady_velocity_mirrored_in_the_limit",
    IN_THE_LIMIT("0.01", "0.49", "; with F1 m1 and F2 m2 exchanged below the line", "0.25"), .with = &mirrored,
    .of_its_crawler = true },
  NEVER_FALLS("2, 4, 10, 40", 2, 4, 10, 40),
  NEVER_FALLS("1/4, 1/2", 0.25, 0.5),
  { "steady_state_is_unique", "5", "v_start", at_random, "l' continuous, any masses, forces > 0 and alpha", "steady",
    .says = "single = 1", .proven = true, .of_its_crawler = true,
    .measured =
        "proven for continuous l' (docs/theory.md, How many steady states); the solver finds one for {0f x2} of 400 "
        "quasi-random crawlers" },
  REACHED("2"),
  REACHED("4"),
  { .name = NULL },
};

static bool is_of_the_paper(const struct scallop_gait *gait)
{
  return gait == &scallop_gait_quadratic || gait == &scallop_gait_sinusoidal;
}

static void add_row(struct ledger *ledger, const struct claim *claim, const struct scallop_crawler *crawler,
                    bool of_the_paper)
{
  struct question q;
  if ((claim->of_its_gaits_alone && !is_of_the_paper(crawler->gait)) || ledger_expects(ledger))
    return;
  question_init(&q, crawler);
  q.claim = claim;
  q.of_the_paper = of_the_paper;
  q.row = (struct claim_row){ .equation = claim->place,
                              .quantity = claim->quantity,
                              .gait = crawler->gait->name,
                              .inside = of_the_paper && !claim->outside,
                              .in_words = true,
                              .claimed_order = NAN,
                              .mismatch = NAN,
                              .fit = { .order = NAN, .low = NAN, .high = NAN } };
  snprintf(q.row.claim, sizeof q.row.claim, "%s", claim->name);
  claim->decide(&q);
  ledger_add(ledger, &q.row);
  question_clear(&q);
}

static void add_rows(struct ledger *ledger, const struct claim *claims, const struct scallop_crawler *crawler,
                     bool of_the_paper)
{
  for (const struct claim *claim = claims; claim->name; claim++)
    if (of_the_paper || !claim->of_its_crawler)
      add_row(ledger, claim, crawler, of_the_paper);
}

void ledger_add_words(struct ledger *ledger, const struct scallop_crawler *crawler, const struct scallop_gait *gait)
{
  struct scallop_crawler paper = scallop_crawler_default(), own = *crawler;
  own.T = 0.5 * natural_time(crawler);
  for (int g = 0; gait ? g == 0 : scallop_gait_name(g) != NULL; g++) {
    paper.gait = own.gait = gait ? gait : scallop_gait_named(scallop_gait_name(g));
    add_rows(ledger, claims_at_random, &paper, true);
    add_rows(ledger, claims_by_example, &paper, true);
    add_rows(ledger, claims_of_families, &paper, true);
    add_rows(ledger, claims_of_families, &own, false);
  }
}
