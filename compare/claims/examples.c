/* Statements that one certified example decides: single phases, steady states, and the appendices except orders. */
#include <math.h>
#include <string.h>

#include "compare/claims/decide.h"

/* Single phases */

static void equal_forces_centre(struct question *q, struct scallop_crawler c)
{
  const struct printed_value by_8 = evaluate_printed(c, "eq8_dxC");
  conclude(q, is_zero(by_8.error),
           "certified: dx1/L = %.6f, dxC/L = %.6f, and (8) gives %.6f; (1 - m1/m2)/2 dx1 is right",
           solve_extension(q, c, 0).dx1 / c.L, by_8.exact / c.L, by_8.value / c.L);
  show(q, "scallop phase --certified%s --columns dx1,dxC", write_options(q, c));
}

static void keeps_the_centre(struct question *q, struct scallop_crawler c)
{
  const double forth = solve_extension(q, c, 0).dxC, back = solve_contraction(q, c, 0).dxC;
  const int stays = is_zero(fabs(forth) + fabs(back));
  conclude(q, stays, "by (6) xC' = (m1-m2)/(2M) l'; certified: %s",
           stays > 0 ? "|dxC| < 2^-80 in both phases" : "dxC is not 0");
}

static void velocity_rises(struct question *q, struct scallop_crawler c)
{
  const double v0 = 20, v_end = solve_extension(q, c, v0).v_end;
  conclude(q, compare(v_end, v0), "certified: v_end = %.6f", v_end);
  show(q, "scallop phase --certified --v0 20%s --columns v0,v_end", write_options(q, c));
}

static void moves_forward(struct question *q, struct scallop_crawler c)
{
  const struct solved p = solve_extension(q, c, 0);
  conclude(q, compare(p.dxC, 0), "certified: dxC/L = %.6f, dx1/L = %.6f, dx2/L = %.6f", p.dxC / c.L, p.dx1 / c.L,
           p.dx2 / c.L);
  show(q, "scallop phase --certified%s --columns dx1,dx2,dxC", write_options(q, c));
}

static void moves_backward(struct question *q, struct scallop_crawler c)
{
  const double v_mid = solve_steady_state(q, c).v_mid, dxC = solve_contraction(q, c, v_mid).dxC;
  conclude(q, compare(0, dxC), "certified: from v_mid T/L = %.6f the centre moves by dxC/L = %.6f in the contraction",
           v_mid * c.T / c.L, dxC / c.L);
  show(q, "scallop phase --phase contraction%s --v0 %.7g --columns v0,dxC", write_options(q, c), v_mid);
}

static void longer_extension_is_faster(struct question *q, struct scallop_crawler c)
{
  const double forth = c.L / scallop_phase_duration(&c, SCALLOP_EXTENSION);
  const double back = c.L / scallop_phase_duration(&c, SCALLOP_CONTRACTION);
  conclude(q, compare(forth, back),
           "mean |l'| is L over the duration: %.6g in the longer extension, %.6g in the contraction", forth, back);
  show(q, "scallop trajectory --start rest --periods 1 --samples 4%s --columns t,l", write_options(q, c));
}

static void first_interval_accelerates(struct question *q, struct scallop_crawler c)
{
  const double before = solve_extension(q, c, 0).dT / scallop_phase_duration(&c, SCALLOP_EXTENSION);
  double rate;
  scallop_gait_at(c.gait, SCALLOP_EXTENSION, 1 - before, NULL, NULL, &rate);
  conclude(q, compare(rate, 0),
           "certified: when it ends, %.6f of the duration before T, l'' = %.6f L/T^2, T the duration; l' > 0 is meant",
           before, rate);
  show(q,
       "the steps of l, the last column, shrink while v1 < 0: scallop trajectory --start rest --periods 1 --samples "
       "8%s --columns t,v1,l",
       write_options(q, c));
}

/* |v1| < |v2|, v1 < 0 < v2: from rest M v1 = (F1 - F2) t - m2 l' and M v2 = (F1 - F2) t + m1 l' */
static void body_1_is_slower(struct question *q, struct scallop_crawler c)
{
  const double t = scallop_phase_duration(&c, SCALLOP_EXTENSION) / 4, gained = (c.F1 - c.F2) * t;
  double rate; /* l' in L over the duration */
  scallop_gait_at(c.gait, SCALLOP_EXTENSION, 0.25, NULL, &rate, NULL);
  const double v1 = (gained - c.m2 * rate * c.L / (4 * t)) / (c.m1 + c.m2);
  const double v2 = (gained + c.m1 * rate * c.L / (4 * t)) / (c.m1 + c.m2);
  const bool in_first = solve_extension(q, c, 0).t1 > t;
  conclude(q, in_first ? compare(v2, -v1) : 0,
           "v1 + v2 = [2 (F1-F2) t - (m2-m1) l']/M; certified at a quarter of the duration: v1 T/L = %.6f, v2 T/L = "
           "%.6f",
           v1 * c.T / c.L, v2 * c.T / c.L);
  show(q, "scallop trajectory --start rest --periods 1 --samples 16%s --columns t,v1,v2 | grep '^0.1875'",
       write_options(q, c));
}

/* With the friction of the first interval up to the end the displacement would be (21). */
static void last_interval_carries(struct question *q, struct scallop_crawler c)
{
  const double duration = scallop_phase_duration(&c, SCALLOP_EXTENSION), dxC = solve_extension(q, c, 0).dxC;
  const double by_21 = (c.F1 - c.F2) * duration * duration / (2 * (c.m1 + c.m2));
  conclude(q, compare(dxC, by_21),
           "certified: dxC/L = %.9f; with the friction of the first interval to the end it would be %.9f", dxC / c.L,
           by_21 / c.L);
  show(q, "dxC is below (F1-F2) 0.75^2/(2M) = 0.421875: scallop phase --certified%s --columns dxC",
       write_options(q, c));
}

static void contraction_is_opposite(struct question *q, struct scallop_crawler c)
{
  const double forth = solve_extension(q, c, 1).v_end - 1, back = solve_contraction(q, c, 1).v_end - 1;
  conclude(q, -(compare(forth, -back) != 0),
           "certified: the velocity changes by %.6f in the extension and by %.6f in the contraction", forth, back);
  show(q, "for p in extension contraction; do scallop phase --v0 1%s --phase $p --columns v0,v_end | tail -n 1; done",
       write_options(q, c));
}

/* Steady states */

static void conclude_steady(struct question *q, struct scallop_crawler c, const struct solved *s, int verdict)
{
  conclude(q, verdict, "certified: Froude %.6g, v_start T/L = %.6f, displacement/L = %.6f, modes %s", s->froude,
           s->v_start * c.T / c.L, s->displacement / c.L, s->modes);
  show(q, "scallop steady --certified%s --columns froude,v_start,displacement,regime,modes", write_options(q, c));
}

/* Refuted if body 2 sticks at some time, and body 1 never. */
static void body_2_sticks(struct question *q, struct scallop_crawler c)
{
  const struct solved s = solve_steady_state(q, c);
  const char *end = s.modes + strlen(s.modes) - 1;
  const bool body_1 = *s.modes == '0' || strstr(s.modes, " 0"), body_2 = *end == '0' || strstr(s.modes, "0 ");
  conclude_steady(q, c, &s, -(body_2 && !body_1));
}

/* The motion has the stated regime, and moves unless at rest. */
static void has_regime(struct question *q, struct scallop_crawler c)
{
  const struct solved s = solve_steady_state(q, c);
  const bool moves = compare(s.displacement, 0) != 0, as_stated = moves != (q->claim->regime == SCALLOP_AT_REST);
  conclude_steady(q, c, &s, s.regime != q->claim->regime || !as_stated ? 0 : q->claim->shows ? 1 : -1);
}

static void opposes_motion(struct question *q, struct scallop_crawler c)
{
  const struct solved s = solve_steady_state(q, c);
  conclude_steady(q, c, &s, -(s.regime == SCALLOP_SLIDING && s.v_start < 0 && s.displacement < 0));
}

/* Both asymmetries, sliding, and no displacement: it is continuous, hence 0 at a change of sign. */
static void two_asymmetries_suffice(struct question *q, struct scallop_crawler c)
{
  const char *others = write_options(q, c);
  double F1 = 70, beyond = 94; /* the displacement is positive, and is not */
  for (double x; halfway(&x, F1, beyond);) {
    c.F1 = x;
    *(solve_steady_state(NULL, c).displacement > 0 ? &F1 : &beyond) = x;
  }
  struct scallop_crawler d = c;
  c.F1 = short_number(F1 * (1 - 1e-10), 12);
  d.F1 = short_number(F1 * (1 + 1e-10), 12);
  const struct solved s = solve_steady_state(q, c), t = solve_steady_state(q, d);
  const bool slide = s.regime == SCALLOP_SLIDING && t.regime == SCALLOP_SLIDING && strcmp(s.modes, t.modes) == 0;
  const bool changes = slide && s.displacement * t.displacement < 0;
  conclude(q, -changes, "certified: displacement/L %.2e at F1 = %.12g, %.2e at %.12g%s%s", s.displacement / c.L, c.F1,
           t.displacement / c.L, d.F1, changes ? ": 0 between; sliding at both, " : "", changes ? s.modes : "");
  show(q,
       "displacement changes its sign: printf 'F1\\n%.12g\\n%.12g\\n' | scallop steady --points - --certified%s "
       "--columns F1,displacement,regime",
       c.F1, d.F1, others);
}

/* Sign of v_start if the change of velocity from rest, v_end, rises (or falls) between all durations compared */
static void where_dvC_changes(struct question *q, struct scallop_crawler c)
{
  const double *duration = q->claim->data;
  const int claimed = duration[0] < 1 ? 1 : -1; /* it rises, and v_start > 0 */
  double dv[4] = { 0 };
  bool changes = true;
  int count = 0;
  for (; duration[count] > 0; count++) {
    struct scallop_crawler one = c;
    one.alpha = 0.5;
    one.T = 2 * duration[count];
    dv[count] = solve_extension(q, one, 0).v_end;
    changes = changes && (count == 0 || compare(dv[count], dv[count - 1]) == claimed);
  }
  const struct solved s = solve_steady_state(q, c);
  conclude(q, changes && s.displacement > 0 ? claimed * compare(s.v_start, 0) : 0,
           "certified: from duration %g to %g dvC changes by %.6f; v_start T/L = %.6f, displacement/L = %.6f",
           duration[0], duration[1], dv[1] - dv[0], s.v_start * c.T / c.L, s.displacement / c.L);
  show(q, "scallop steady --certified%s --columns froude,v_start,displacement,regime,modes", write_options(q, c));
}

static void two_regimes(struct question *q, struct scallop_crawler c)
{
  struct scallop_crawler d = c;
  d.F1 = 40;
  const struct solved s = solve_steady_state(q, c), t = solve_steady_state(q, d);
  const bool both = s.regime == SCALLOP_SLIDING && t.regime == SCALLOP_SLIDING && s.displacement > 0
                    && t.displacement > 0 && s.v_start > 0 && t.v_start < 0;
  conclude(q, both,
           "certified: sliding, v_start T/L = %.6f and displacement/L = %.6f at F1/F2 = 4, %.6f and %.6f at 40",
           s.v_start * c.T / c.L, s.displacement / c.L, t.v_start * c.T / c.L, t.displacement / c.L);
}

/* Formulas */

static void kinematic_length(struct question *q, struct scallop_crawler c)
{
  const char *excess = c.gait == &scallop_gait_sinusoidal ? "l0*lT/(2*(lT - l0)) - pi^2/8*L"
                                                          : "l0*lT/(2*(lT - l0)) - L";
  conclude(q, is_zero(evaluate_printed(c, excess).value), "certified: l0 lT/[2 (lT - l0)] = %.12f L",
           evaluate_printed(c, "l0*lT/(2*(lT - l0))").value / c.L);
}

/* From v0, or from the steady state: its start velocity goes as 1/T */
static void t1_is_small(struct question *q, struct scallop_crawler c)
{
  static const double T[] = { 1e-10, 1e-20 };
  const double *v0 = q->claim->data;
  double part[2], start = 0;
  for (int i = 0; i < 2; i++) {
    c.T = T[i];
    start = v0 ? *v0 : solve_steady_state(q, c).v_start;
    part[i] = solve_extension(q, c, start).t1 / scallop_phase_duration(&c, SCALLOP_EXTENSION);
  }
  conclude(q, compare(1e-6 * part[0], part[1]),
           "certified: t1 is %.4g of the duration at T = 1e-10 and %.4g at T = 1e-20", part[0], part[1]);
  show(q, "scallop phase%s --v0 %.7g --columns T,t1", write_options(q, c), start);
}

static void exceeds_its_remainder(struct question *q, struct scallop_crawler c)
{
  const char *others = write_options(q, c);
  static const double T[] = { 1e-10, 1e-20 };
  double term[2]; /* over the duration squared; the remainder goes as this square */
  for (int i = 0; i < 2; i++) {
    c.T = T[i];
    double duration = scallop_phase_duration(&c, SCALLOP_CONTRACTION);
    term[i] = solve_contraction(q, c, 1).at_first / (duration * duration);
  }
  conclude(q, term[0] > 0 ? compare(fabs(term[1] / term[0] - 1), 1e-6) : 0,
           "certified: the term, x2(t1) - x2(0), is %.6f tau^2 at T = 1e-10 and %.6f tau^2 at 1e-20, tau the duration: "
           "of the remainder's order",
           term[0], term[1]);
  show(q,
       "it is x0' t1/2, and t1 goes as T^2: printf 'T\\n1e-10\\n1e-20\\n' | scallop phase --points - --phase "
       "contraction --v0 1%s --columns T,t1",
       others);
}

/* A formula printed with "=" and no remainder */
static void without_remainder(struct question *q, struct scallop_crawler c)
{
  const struct scallop_formula *f = formula_named(q->claim->data);
  const struct printed_value p = evaluate_printed(c, f->name);
  conclude(q, is_zero(p.error), "certified: %s = %.12f; the formula gives %.12f%s", q->claim->quantity, p.exact,
           p.value, p.error == 0 ? ", the same to 30 digits" : "");
  show(q, "scallop phase --certified%s --v0 %d --phase %s --columns %s", write_options(q, c),
       f->setting != SCALLOP_AT_REST_START, f->setting == SCALLOP_MOVING_CONTRACTION ? "contraction" : "extension",
       q->claim->quantity);
}

static const char froude[] = "moving_needs_a_high_Froude_number", suffice[] = "two_asymmetries_suffice_to_move";
static const char as_printed[] = "as printed, without a remainder; %s, from v0 = 1";
static const char v_mid[] = "v_mid_peaks_where_v_start_is_0", loss[] = "contraction_loses_least_where_v_start_is_0";
static const char body_2_sticks_for[] = "m1 = 0.1, m2 = 1.9, F1 = 5.1, F2 = 1.2, L = 1, T = 0.93, alpha = 0.71";
#define NEAR_BOUNDARY "from 1 %% below to 1 %% above the boundary"
static const char near_ratio[] = "%s, F1/F2 " NEAR_BOUNDARY, near_period[] = "%s, T alone, " NEAR_BOUNDARY;
static const char near_forces[] = "%s, F1 and F2 together, " NEAR_BOUNDARY;

const struct statement statements_by_example[] = {
  { "equal_forces_centre", "(8)", "dxC", "%s, F1 = F2 = 1, m1 = 2", .test = equal_forces_centre },
  { "equal_forces_and_masses_keep_the_centre", "4.1", "dxC", "%s, F1 = F2 = 1", .test = keeps_the_centre },
  { "velocity_rises_over_extension", "4.2", "v_end", "%s, from v0 = 20", .test = velocity_rises, .outside = true },
  { "centre_moves_forward_in_an_extension", "4.3", "dxC", "%s, m2 = 4, from rest", .test = moves_forward },
  { "centre_moves_backward_in_a_contraction", "4.3", "dxC", "%s in its steady state", .test = moves_backward },
  { "longer_extension_is_faster", "4.3", "l'", "%s", .test = longer_extension_is_faster },
  { "first_interval_accelerates_l", "4.3.1", "l''", "%s, from rest", .test = first_interval_accelerates },
  { "body_1_is_slower_in_the_first_interval", "4.3.1", "v1, v2", "%s, from rest", .test = body_1_is_slower },
  { "body_1_is_slower_in_the_first_interval", "4.3.1", "v1, v2", "%s, m1 = 0.5, from rest", .test = body_1_is_slower },
  { "last_interval_carries_the_centre_forward", "4.3.1, 5", "dxC", "%s, an extension from rest",
    .test = last_interval_carries },
  { "contraction_is_the_opposite_of_the_extension", "4.3.3", "v_end", "%s, alpha = 1/2, from v0 = 1",
    .test = contraction_is_opposite },

  { "only_body_1_sticks", "2", "modes", body_2_sticks_for, .test = body_2_sticks },
  { "with_one_body_stuck_that_of_less_friction_moves", "2", "modes", body_2_sticks_for, .test = body_2_sticks },
  { froude, "2, 5", "displacement", "%s, F1 = 34.9776: sliding", .test = has_regime },
  { froude, "2, 5", "displacement", "%s, T = 6", .test = has_regime, .regime = SCALLOP_STICK_SLIP, .outside = true },
  { froude, "2, 5", "displacement", "%s, T = 14", .test = has_regime, .regime = SCALLOP_STICK_SLIP, .outside = true },
  { "one_degree_of_freedom_can_move", "3, 5", "displacement", "%s", .test = has_regime, .shows = true },
  { "one_degree_of_freedom_can_move", "3, 5", "displacement", "%s, F1 = 300", .test = has_regime,
    .regime = SCALLOP_STICK_SLIP, .shows = true },
  { suffice, "3 (c), abstract", "displacement", "%s, alpha = 0.55; F1 varied", .test = two_asymmetries_suffice },
  { suffice, "3 (c), abstract", "displacement", "%s, F1 = 1000", .test = has_regime, .regime = SCALLOP_AT_REST,
    .outside = true },
  { "the_forces_must_differ_not_the_coefficients", "4.3.3", "displacement", "%s, m1 = 4: F1/m1 = F2/m2",
    .test = has_regime, .shows = true },
  { "kinematic_length", "4.3.3", "L_kin", "L_kin = L for the quadratic gait, pi^2 L/8 for the sinusoidal one",
    .test = kinematic_length, .only_paper_gaits = true },
  { "start_velocity_is_forward_where_dvC_rises", "4.4", "v_start",
    "%s, alpha = 0.51: dvC rises at both durations, 0.51 T and 0.49 T", .test = where_dvC_changes,
    .data = (const double[]){ 0.485, 0.49, 0.51, 0.515, 0 } },
  { "start_velocity_is_backward_where_dvC_falls", "4.4", "v_start",
    "%s, alpha = 0.75, T = 2.2: dvC falls at the duration alpha T", .test = where_dvC_changes,
    .data = (const double[]){ 1.64, 1.65, 1.66, 0 } },
  { v_mid, "4.4", "v_mid", near_ratio, .test = v_mid_peaks },
  { v_mid, "4.4", "v_mid", near_forces, .test = v_mid_peaks },
  { v_mid, "4.4", "v_mid", near_period, .test = v_mid_peaks },
  { loss, "4.4", "dxC", near_ratio, .test = contraction_loses_least },
  { loss, "4.4", "dxC", near_forces, .test = contraction_loses_least },
  { loss, "4.4", "dxC", near_period, .test = contraction_loses_least },
  { "start_velocity_opposes_motion_at_low_Froude", "5", "v_start", "%s, F1 = 90, alpha = 0.55",
    .test = opposes_motion },
  { "start_velocity_has_two_regimes", "4.5, 5", "v_start", "%s, F1/F2 = 4 and 40", .test = two_regimes },

  { "t1_is_small", "(A.6)", "t1", "%s, from v0 = 1", .test = t1_is_small, .data = (const double[]){ 1 } },
  { "t1_is_small", "(A.6), 4.3.3", "t1", "%s, from its steady v_start ~ 1/T, to a double's digits",
    .test = t1_is_small },
  { "eqB3_x2_first_switch_exceeds_its_remainder", "(B.3)", "x2(t1)", "%s, from v0 = 1", .test = exceeds_its_remainder },
  { "eq13_dT_without_remainder", "(13)", "dT", "as printed, without a remainder; %s, from rest",
    .test = without_remainder, .data = "eq13_dT_unexpanded" },
  { "eqA5_t1_without_remainder", "(A.5)", "t1", as_printed, .test = without_remainder, .data = "eqA5_t1_unexpanded" },
  { "eqA14_dT_without_remainder", "(A.14)", "dT", as_printed, .test = without_remainder,
    .data = "eqA14_dT_unexpanded" },
  { "eqB2_t1_without_remainder", "(B.2)", "t1", as_printed, .test = without_remainder, .data = "eqB2_t1_unexpanded" },
  { "eqB5_dT_without_remainder", "(B.5)", "dT", as_printed, .test = without_remainder, .data = "eqB5_dT_unexpanded" },
  { .name = NULL },
};
