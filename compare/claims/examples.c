/* The claims in words that one certified example decides: single phases, steady states, and what the appendices say
 * beside orders. */

#include "compare/claims/decide.h"
#include "compare/claims/evidence.h"

/* Both asymmetries, sliding, and no displacement: it is continuous, so where it changes its sign it is 0. */

static double displacement_at(const void *crawler, double F1)
{
  struct scallop_crawler c = *(const struct scallop_crawler *)crawler;
  c.F1 = F1;
  return steady_state(&c).period.displacement;
}

/* x1, x2: F1 on both sides of the change of sign */
static void standstill(struct question *q)
{
  struct scallop_crawler c = q->crawler;
  c.alpha = 0.55;
  double F1 = last_positive(displacement_at, &c, 70, 94);
  q->found[0] = short_number(F1 * (1 - 1e-10), 12);
  q->found[1] = short_number(F1 * (1 + 1e-10), 12);
  proven(q);
}

static const char extends[] = "centre_moves_forward_in_an_extension", froude[] = "moving_needs_a_high_Froude_number";
static const char slower[] = "body_1_is_slower_in_the_first_interval", v_mid[] = "v_mid_peaks_where_v_start_is_0";
static const char one_degree[] = "one_degree_of_freedom_can_move", suffice[] = "two_asymmetries_suffice_to_move";
static const char loss[] = "contraction_loses_least_where_v_start_is_0";

/* v1 and v2 at a quarter of the duration, both bodies having moved oppositely from rest */
#define XC_GAINED "((F1 - F2)*duration/4 "
#define OPPOSED "speed_at_quarter*L/duration)/(m1 + m2)*T/L"
static const char opposite_speeds[] = "2*(F1 - F2)*duration/4 > (m2 - m1)*speed_at_quarter*L/duration";
static const char speeds[] = "v1 + v2 = [2 (F1-F2) t - (m2-m1) l']/M; certified at a quarter of the duration: v1 T/L = "
                             "{6f " XC_GAINED "- m2*" OPPOSED "}, v2 T/L = {6f " XC_GAINED "+ m1*" OPPOSED "}";
static const char show_speeds[] =
    "scallop trajectory --start rest --periods 1 --samples 16{options} | grep '^0.1875' | cut -f 5,6";

/* Without the last interval, the friction of the first one acting to the end, the centre would come as far as (21) has
 * it. */
#define FIRST_TO_THE_END "(F1 - F2)*duration^2/(2*(m1 + m2))"

static const char body_2_sticks[] = "steady m1=0.1 m2=1.9 F1=5.1 F2=1.2 L=1 T=0.93 alpha=0.71";
static const char body_2_sticks_for[] = "m1 = 0.1, m2 = 1.9, F1 = 5.1, F2 = 1.2, L = 1, T = 0.93, alpha = 0.71";
static const char steady_state_is[] =
    "certified: Froude {6g froude}, v_start T/L = {6f v_start*T/L}, displacement/L = {6f "
    "displacement/L}, modes {modes}";
static const char show_steady[] = "scallop steady --certified{options} | cut -f 9,10,12,15,16";

/* Three steady states through the boundary where v_start is 0: before it, at it and behind it, 1 % apart */
static const char passage[] = "the paper's crawler, {6} from 1 % below to 1 % above the boundary";
static const char three[] = "steady at=x1; steady at=x2; steady at=x3";
static const char v_mid_is[] =
    "certified: v_start changes its sign; v_mid T/L = {6f v_mid*T/L}, {6f v_mid:2*T:2/L}, {6f "
    "v_mid:3*T:3/L} at {2} = {6g x1}, {6g x2}, {6g x3}";
static const char show_v_mid[] = "v_mid, the last column, is not highest in the second row: {table} | cut -f 6,10,11";
static const char and_phases[] =
    "steady at=x1; steady at=x2; steady at=x3; extension at=x1 v0=v_start:1; extension at=x2 v0=v_start:2; extension "
    "at=x3 v0=v_start:3; contraction at=x1 v0=v_mid:1; contraction at=x2 v0=v_mid:2; contraction at=x3 v0=v_mid:3";
static const char loss_is[] = "certified: dx_C/L of the contraction is {6f dxC:7/L}, {6f dxC:8/L}, {6f dxC:9/L} there; "
                              "of the extension {6f dxC:4/L}, {6f dxC:5/L}, {6f dxC:6/L}";
static const char show_loss[] =
    "dx_C of the contraction at the boundary: scallop phase --phase contraction{options:2} --v0 {6g "
    "v_mid:2} | cut -f 16";
#define V_MID(by) \
  { \
    v_mid, "4.4", "v_mid", through_boundary, passage, three, \
        .needs = "min(v_start, -v_start:3)", .says = "v_mid:2 > max(v_mid, v_mid:3)", .measured = v_mid_is, \
        .reason = show_v_mid, .varied = (by) \
  }
#define LOSS(by) \
  { \
    loss, "4.4", "dx_C", through_boundary, passage, and_phases, \
        .needs = "min(v_start, -v_start:3)", .says = "dxC:8 > max(dxC:7, dxC:9)", .measured = loss_is, \
        .reason = show_loss, .varied = (by) \
  }

/* Formulas printed with "=" and no remainder */
#define WITHOUT_REMAINDER(name, place, quantity, from, motion, formula, shows) \
  { \
    name "_without_remainder", place, #quantity, proven, \
        "as printed, without a remainder; the paper's crawler, from " from, motion, \
        .needs = "switches", .says = #quantity " = " #formula, \
        .measured = "certified: " #quantity " = {12f " #quantity "}; the formula gives {12f " #formula \
                    "}{+, the same to 30 digits}", \
        .reason = "scallop phase --certified{options} " shows \
  }

const struct claim claims_by_example[] = {
  { "equal_forces_centre", "(8)", "dx_C", proven, "the paper's crawler, F1 = F2 = 1, m1 = 2", "extension F1=F2 m1=2",
    .says = "dxC = equal_xC_end",
    .measured =
        "certified: dx_1/L = {6f dx1/L}, dx_C/L = {6f dxC/L}, and (8) gives {6f equal_xC_end/L}; (1 - m1/m2)/2 dx_1 "
        "is right",
    .reason = "scallop phase --certified{options} | cut -f 14,16" },
  { "equal_forces_and_masses_keep_the_centre", "4.1", "dx_C", proven, "the paper's crawler, F1 = F2 = 1",
    "extension F1=F2; contraction F1=F2", .says = "abs(dxC) + abs(dxC:2) = 0",
    .measured = "by (6) x_C' = (m1-m2)/(2M) l'; certified: {+|dx_C| < 2^-80 in both phases}{-dx_C is not 0}" },
  { "velocity_rises_over_extension", "4.2", "v_end", proven, "the paper's crawler, from v0 = 20", "extension v0=20",
    .says = "v_end > v0", .measured = "certified: v_end = {6f v_end}",
    .reason = "scallop phase --certified --v0 20{options} | cut -f 10,13", .outside = true },
  { extends, "4.3", "dx_C", proven, "the paper's crawler, m2 = 4, from rest", "extension m2=4", .says = "dxC > 0",
    .measured = "certified: dx_C/L = {6f dxC/L}, dx_1/L = {6f dx1/L}, dx_2/L = {6f dx2/L}",
    .reason = "scallop phase --certified{options} | cut -f 14,15,16" },
  { "centre_moves_backward_in_a_contraction", "4.3", "dx_C", proven, "the paper's crawler in its steady state",
    "steady; contraction v0=v_mid:1", .says = "dxC:2 < 0",
    .measured =
        "certified: from v_mid T/L = {6f v_mid*T/L} the centre moves by dx_C/L = {6f dxC:2/L} in the contraction",
    .reason = "scallop phase --phase contraction{options} --v0 {7g v_mid} | cut -f 10,16" },
  { "longer_extension_is_faster", "4.3", "l'", proven, "the paper's crawler", "extension; contraction",
    .says = "L/duration > L/duration:2",
    .measured = "mean |l'| is L over the duration: {6g L/duration} in the longer extension, {6g L/duration:2} in the "
                "contraction",
    .reason = "scallop trajectory --start rest --periods 1 --samples 4{options} | cut -f 1,7" },
  { "first_interval_accelerates_l", "4.3.1", "l''", proven, "the paper's crawler, from rest", "extension",
    .needs = "switches", .says = "rate_at_dT > 0",
    .measured =
        "certified: when it ends, {6f dT/duration} of the duration before T, l'' = {6f rate_at_dT} L/T^2, T the "
        "duration; l' > 0 is meant",
    .reason =
        "the steps of l, the last column, shrink while v1 < 0: scallop trajectory --start rest --periods 1 --samples "
        "8{options} | cut -f 1,5,7" },
  { slower, "4.3.1", "v1, v2", proven, "the paper's crawler, from rest", "extension", .needs = "t1 - duration/4",
    .says = opposite_speeds, .measured = speeds, .reason = show_speeds },
  { slower, "4.3.1", "v1, v2", proven, "the paper's crawler, m1 = 0.5, from rest", "extension m1=0.5",
    .needs = "t1 - duration/4", .says = opposite_speeds, .measured = speeds, .reason = show_speeds },
  { "last_interval_carries_the_centre_forward", "4.3.1, 5", "dx_C", proven,
    "the paper's crawler, an extension from rest", "extension", .needs = "switches", .says = "dxC > " FIRST_TO_THE_END,
    .measured = "certified: dx_C/L = {9f dxC/L}; with the friction of the first interval to the end it would be "
                "{9f " FIRST_TO_THE_END "/L}",
    .reason = "dxC is below (F1-F2) 0.75^2/(2M) = 0.421875: scallop phase --certified{options} | cut -f 16" },
  { "contraction_is_the_opposite_of_the_extension", "4.3.3", "v_end", proven,
    "the paper's crawler, alpha = 1/2, from v0 = 1", "extension alpha=0.5 v0=1; contraction alpha=0.5 v0=1",
    .says = "v_end - v0 = v0:2 - v_end:2",
    .measured = "certified: the velocity changes by {6f v_end - v0} in the extension and by {6f v_end:2 - v0:2} in the "
                "contraction",
    .reason = "for p in extension contraction; do scallop phase --v0 1{options} --phase $p | tail -n 1 | cut -f 10,13; "
              "done" },

  { "only_body_1_sticks", "2", "modes", proven, body_2_sticks_for, body_2_sticks,
    .refuted_by = "(1 - sticks_1)*sticks_2", .measured = steady_state_is, .reason = show_steady },
  { "with_one_body_stuck_that_of_less_friction_moves", "2", "modes", proven, body_2_sticks_for, body_2_sticks,
    .refuted_by = "(1 - sticks_1)*sticks_2", .measured = steady_state_is, .reason = show_steady },
  { froude, "2, 5", "displacement", proven, "the paper's crawler, F1 = 34.9776: sliding", "steady F1=34.9776",
    .refuted_by = "sliding*abs(displacement)", .measured = steady_state_is, .reason = show_steady },
  { froude, "2, 5", "displacement", proven, "the paper's crawler, T = 6", "steady T=6", .outside = true,
    .refuted_by = "sticking*abs(displacement)", .measured = steady_state_is, .reason = show_steady },
  { froude, "2, 5", "displacement", proven, "the paper's crawler, T = 14", "steady T=14", .outside = true,
    .refuted_by = "sticking*abs(displacement)", .measured = steady_state_is, .reason = show_steady },
  { one_degree, "3, 5", "displacement", proven, "the paper's crawler", "steady",
    .shown_by = "sliding*abs(displacement)", .measured = steady_state_is },
  { one_degree, "3, 5", "displacement", proven, "the paper's crawler, F1 = 300", "steady F1=300",
    .shown_by = "sticking*abs(displacement)", .measured = steady_state_is },
  { suffice, "3 (c), abstract", "displacement", standstill, "the paper's crawler, alpha = 0.55; F1 varied",
    "steady alpha=0.55 F1=x1; steady alpha=0.55 F1=x2",
    .refuted_by = "min(sliding, sliding:2, like_first:2, -displacement*displacement:2)",
    .measured =
        "certified: displacement/L {2e displacement/L} at F1 = {12g x1}, {2e displacement:2/L} at {12g x2}{-: 0 "
        "between; sliding at both, {modes}}",
    .reason =
        "displacement changes its sign: printf 'F1\\n{12g x1}\\n{12g x2}\\n' | scallop steady --points - --certified "
        "--alpha 0.55{options:0} | cut -f 3,12,15" },
  { suffice, "3 (c), abstract", "displacement", proven, "the paper's crawler, F1 = 1000", "steady F1=1000",
    .outside = true, .refuted_by = "resting", .measured = steady_state_is, .reason = show_steady },
  { "the_forces_must_differ_not_the_coefficients", "4.3.3", "displacement", proven,
    "the paper's crawler, m1 = 4: F1/m1 = F2/m2", "steady m1=4", .shown_by = "sliding*abs(displacement)",
    .measured = steady_state_is },
  { "kinematic_length", "4.3.3", "L_kin", proven, "L_kin = L for the quadratic gait, pi^2 L/8 for the sinusoidal one",
    "extension", .says = "l0*lT/(2*(lT - l0)) = L*(1 + sinusoidal*(pi^2/8 - 1))",
    .measured = "certified: l0 lT/[2 (lT - l0)] = {12f l0*lT/(2*(lT - l0))/L} L", .of_its_gaits_alone = true },
  { "start_velocity_is_forward_where_dv_C_rises", "4.4", "v_start", proven,
    "the paper's crawler, alpha = 0.51: dv_C rises at both durations, 0.51 T and 0.49 T",
    "extension alpha=0.5 T=0.97; extension alpha=0.5 T=0.98; extension alpha=0.5 T=1.02; extension alpha=0.5 T=1.03; "
    "steady "
    "alpha=0.51",
    .needs = "min(v_end:2 - v_end, v_end:3 - v_end:2, v_end:4 - v_end:3, displacement:5)", .says = "v_start:5 > 0",
    .measured = "certified: from duration 0.485 to 0.49 dv_C changes by {6f v_end:2 - v_end}; v_start T/L = {6f "
                "v_start:5*T:5/L}, displacement/L = {6f displacement:5/L}",
    .reason = "scallop steady --certified{options:5} | cut -f 9,10,12,15,16" },
  { "start_velocity_is_backward_where_dv_C_falls", "4.4", "v_start", proven,
    "the paper's crawler, alpha = 0.75, T = 2.2: dv_C falls at the duration alpha T",
    "extension alpha=0.5 T=3.28; extension alpha=0.5 T=3.3; extension alpha=0.5 T=3.32; steady T=2.2",
    .needs = "min(v_end - v_end:2, v_end:2 - v_end:3, displacement:4)", .says = "v_start:4 < 0",
    .measured = "certified: from duration 1.64 to 1.65 dv_C changes by {6f v_end:2 - v_end}; v_start T/L = {6f "
                "v_start:4*T:4/L}, displacement/L = {6f displacement:4/L}",
    .reason = "scallop steady --certified{options:4} | cut -f 9,10,12,15,16" },
  V_MID(VARY_RATIO),
  V_MID(VARY_FORCES),
  V_MID(VARY_PERIOD),
  LOSS(VARY_RATIO),
  LOSS(VARY_FORCES),
  LOSS(VARY_PERIOD),
  { "start_velocity_opposes_motion_at_low_Froude", "5", "v_start", proven, "the paper's crawler, F1 = 90, alpha = 0.55",
    "steady F1=90 alpha=0.55", .refuted_by = "min(sliding, -v_start, -displacement)", .measured = steady_state_is,
    .reason = show_steady },
  { "start_velocity_has_two_regimes", "4.5, 5", "v_start", proven, "the paper's crawler, F1/F2 = 4 and 40",
    "steady F1=4; steady F1=40",
    .shown_by = "min(sliding, sliding:2, displacement, displacement:2, v_start, -v_start:2)",
    .measured =
        "certified: sliding, v_start T/L = {6f v_start*T/L} and displacement/L = {6f displacement/L} at F1/F2 = 4, "
        "{6f v_start:2*T/L} and {6f displacement:2/L} at 40" },

  { "t1_is_small", "(A.6)", "t1", proven, "the paper's crawler, from v0 = 1",
    "extension v0=1 T=1e-10; extension v0=1 T=1e-20", .needs = "switches*switches:2",
    .says = "t1:2/duration:2 < 1e-6*t1/duration",
    .measured = "certified: t1 is {4g t1/duration} of the duration at T = 1e-10 and {4g t1:2/duration:2} at T = 1e-20",
    .reason = "scallop phase{options:2} --v0 {7g v0:2} | cut -f 6,11" },
  { "t1_is_small", "(A.6), 4.3.3", "t1", proven,
    "the paper's crawler, from its steady v_start ~ 1/T, to a double's digits",
    "steady T=1e-10; steady T=1e-20; extension T=1e-10 v0~v_start:1; extension T=1e-20 v0~v_start:2",
    .needs = "switches:3*switches:4", .says = "t1:4/duration:4 < 1e-6*t1:3/duration:3",
    .measured =
        "certified: t1 is {4g t1:3/duration:3} of the duration at T = 1e-10 and {4g t1:4/duration:4} at T = 1e-20",
    .reason = "scallop phase{options:2} --v0 {7g v0:4} | cut -f 6,11" },
  { "B_x2_first_switch_exceeds_its_remainder", "(B.3)", "x2(t1)", proven, "the paper's crawler, from v0 = 1",
    "contraction v0=1 T=1e-10; contraction v0=1 T=1e-20", .needs = "x_first",
    .says = "abs(x_first:2/duration:2^2/(x_first/duration^2) - 1) > 1e-6",
    .measured = "certified: the term, x2(t1) - x2(0), is {6f x_first/duration^2} tau^2 at T = 1e-10 and {6f "
                "x_first:2/duration:2^2} tau^2 at 1e-20, tau the duration: of the remainder's order",
    .reason = "it is x0' t1/2, and t1 goes as T^2: printf 'T\\n1e-10\\n1e-20\\n' | scallop phase --points - --phase "
              "contraction --v0 1{options:0} | cut -f 6,11" },
  WITHOUT_REMAINDER("rest_dT", "(13)", dT, "rest", "extension", rest_dT_unexpanded,
                    "--v0 0 --phase extension | cut -f 12"),
  WITHOUT_REMAINDER("A_t1", "(A.5)", t1, "v0 = 1", "extension v0=1", A_t1_unexpanded,
                    "--v0 1 --phase extension | cut -f 11"),
  WITHOUT_REMAINDER("A_dT", "(A.14)", dT, "v0 = 1", "extension v0=1", A_dT_unexpanded,
                    "--v0 1 --phase extension | cut -f 12"),
  WITHOUT_REMAINDER("B_t1", "(B.2)", t1, "v0 = 1", "contraction v0=1", B_t1_unexpanded,
                    "--v0 1 --phase contraction | cut -f 11"),
  WITHOUT_REMAINDER("B_dT", "(B.5)", dT, "v0 = 1", "contraction v0=1", B_dT_unexpanded,
                    "--v0 1 --phase contraction | cut -f 12"),
  { .name = NULL },
};
