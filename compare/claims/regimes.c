/* The claims in words about steady states: what is needed to move, which way, and how the start velocity goes with that. Each is decided
 * by a certified example. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/claims/family.h"
#include "compare/claims/proven.h"
#include "compare/claims/words.h"

enum { MEASURED = 200, REASON = 320, CONDITIONS = 160 };

/* ---- one steady state that decides ---- */

static bool slides_and_moves(const struct scallop_certified_steady *s)
{
  return s->regime == SCALLOP_SLIDING && arb_is_nonzero(s->displacement);
}

static bool sticks_and_moves(const struct scallop_certified_steady *s)
{
  return s->regime == SCALLOP_STICK_SLIP && arb_is_nonzero(s->displacement);
}

static bool never_moves(const struct scallop_certified_steady *s)
{
  return s->regime == SCALLOP_AT_REST && arb_is_zero(s->displacement);
}

static bool body_2_alone_sticks(const struct scallop_certified_steady *s)
{
  bool second = false, first = false;
  for (int kind = 0; kind < 2; kind++)
    for (int i = 0; i < s->modes[kind].count && i < SCALLOP_MODES_KEPT; i++) {
      second = second || s->modes[kind].kept[i].s2 == 0;
      first = first || s->modes[kind].kept[i].s1 == 0;
    }
  return second && !first;
}

static bool starts_and_moves_back(const struct scallop_certified_steady *s)
{
  return s->regime == SCALLOP_SLIDING && arb_is_negative(s->v_start) && arb_is_negative(s->displacement);
}

/* The paper's crawler with other numbers, where they are not 0; what it does, and whether that refutes the claim or shows it. */
struct example {
  const char *conditions;
  double m1, m2, F1, F2, L, T, alpha;
  bool (*does)(const struct scallop_certified_steady *s);
  bool refutes;
};

enum { MOVES, STICK_SLIP_MOVES, REST, BODY_2_STICKS, LOW_FROUDE, LOWER_FROUDE, LOWEST_FROUDE, STARTS_BACK, COEFFICIENTS };

#define PAPER "the paper's crawler"
static const struct example examples[] = {
  [MOVES] = { PAPER, .does = slides_and_moves },
  [STICK_SLIP_MOVES] = { PAPER ", F1 = 300", .F1 = 300, .does = sticks_and_moves },
  [REST] = { PAPER ", F1 = 1000", .F1 = 1000, .does = never_moves, .refutes = true },
  [BODY_2_STICKS] = { "m1 = 0.1, m2 = 1.9, F1 = 5.1, F2 = 1.2, L = 1, T = 0.93, alpha = 0.71", 0.1, 1.9, 5.1, 1.2, 1, 0.93,
                      0.71, body_2_alone_sticks, true },
  [LOW_FROUDE] = { PAPER ", F1 = 34.9776: sliding", .F1 = 34.9776, .does = slides_and_moves, .refutes = true },
  [LOWER_FROUDE] = { PAPER ", T = 6", .T = 6, .does = sticks_and_moves, .refutes = true },
  [LOWEST_FROUDE] = { PAPER ", T = 14", .T = 14, .does = sticks_and_moves, .refutes = true },
  [STARTS_BACK] = { PAPER ", F1 = 90, alpha = 0.55", .F1 = 90, .alpha = 0.55, .does = starts_and_moves_back,
                    .refutes = true },
  [COEFFICIENTS] = { PAPER ", m1 = 4: F1/m1 = F2/m2", .m1 = 4, .does = slides_and_moves },
};

static double or_else(double x, double otherwise) { return x > 0 ? x : otherwise; }

static struct scallop_crawler crawler_of(const struct words *w, const struct example *e)
{
  struct scallop_crawler c = words_paper_crawler(w);
  c.m1 = or_else(e->m1, c.m1), c.m2 = or_else(e->m2, c.m2);
  c.F1 = or_else(e->F1, c.F1), c.F2 = or_else(e->F2, c.F2);
  c.L = or_else(e->L, c.L), c.T = or_else(e->T, c.T);
  c.alpha = or_else(e->alpha, c.alpha);
  return c;
}

enum { MODES = 64 };

static void modes_text(char text[MODES], const struct scallop_certified_steady *s)
{
  char modes[2][SCALLOP_MODES_TEXT];
  for (int kind = 0; kind < 2; kind++)
    scallop_modes_text(&s->modes[kind], modes[kind]);
  snprintf(text, MODES, "%.30s | %.30s", modes[0], modes[1]);
}

/* What was measured of a steady state, and a command that prints it */
static void describe(char measured[MEASURED], char reason[REASON], const struct scallop_certified_steady *s,
                     const struct scallop_crawler *c)
{
  char modes[MODES];
  modes_text(modes, s);
  snprintf(measured, MEASURED, "certified: Froude %.6g, v_start T/L = %.6f, displacement/L = %.6f, modes %s",
           proven_middle(s->froude), proven_over(s->v_start, c->L / c->T), proven_over(s->displacement, c->L), modes);
  crawler_command(reason, REASON, "", "steady --certified", c, " | cut -f 9,10,12,15,16");
}

static void example_row(const struct words *w, const struct words_claim *claim)
{
  const struct example *e = &examples[claim->which];
  char measured[MEASURED], reason[REASON];
  struct scallop_certified_steady s;
  struct scallop_crawler c = crawler_of(w, e);
  scallop_certified_steady_init(&s);
  bool shown = proven_steady(&s, &c) && e->does(&s);
  describe(measured, reason, &s, &c);
  words_enter(w, claim, e->conditions, true, words_verdict(shown && !e->refutes, shown), measured, reason);
  scallop_certified_steady_clear(&s);
}

/* ---- both asymmetries, sliding, and no displacement ---- */

/* F1 where the displacement changes its sign, in doubles */
static double standstill(const struct scallop_crawler *c, double low, double high)
{
  for (double mid; (mid = 0.5 * (low + high)) > low && mid < high;) {
    struct scallop_crawler at = *c;
    at.F1 = mid;
    *(words_steady(&at).period.displacement > 0 ? &low : &high) = mid;
  }
  return low;
}

/* The displacement is continuous, so where it changes its sign it is 0. */
static void standstill_row(const struct words *w, const struct words_claim *claim)
{
  char measured[MEASURED], reason[REASON], options[120], modes[2][MODES];
  struct scallop_certified_steady s[2];
  struct scallop_crawler c = words_paper_crawler(w);
  c.alpha = 0.55;
  double F1 = standstill(&c, 70, 94), place[2];
  bool slide = true;
  crawler_options(options, sizeof options, &c, NULL);
  for (int i = 0; i < 2; i++) {
    place[i] = c.F1 = short_number(F1 * (i ? 1 + 1e-10 : 1 - 1e-10), 12);
    scallop_certified_steady_init(&s[i]);
    slide = proven_steady(&s[i], &c) && slide && s[i].regime == SCALLOP_SLIDING;
    modes_text(modes[i], &s[i]);
  }
  bool zero = slide && strcmp(modes[0], modes[1]) == 0 && arb_is_positive(s[0].displacement)
              && arb_is_negative(s[1].displacement);
  snprintf(measured, MEASURED, "that it changes its sign for F1 from 70 to 94, sliding, is not proven");
  if (zero)
    snprintf(measured, MEASURED,
             "certified: displacement/L %.2e at F1 = %.12g, %.2e at %.12g: 0 between; sliding at both, %s",
             proven_over(s[0].displacement, c.L), place[0], proven_over(s[1].displacement, c.L), place[1], modes[0]);
  snprintf(reason, REASON,
           "displacement changes its sign: printf 'F1\\n%.12g\\n%.12g\\n' | scallop steady --points - --certified%s | "
           "cut -f 3,12,15",
           place[0], place[1], options);
  words_enter(w, claim, "the paper's crawler, alpha = 0.55; F1 varied", true, words_verdict(false, zero), measured, reason);
  for (int i = 0; i < 2; i++)
    scallop_certified_steady_clear(&s[i]);
}

/* ---- figure 4B against the start velocity ---- */

/* alpha, T; the slope of dv_C against the duration of an extension from rest, at the durations named; the sign that v_start should have */
static const struct slope {
  double alpha, T;
  double durations[4];
  int count, sign;
  const char *conditions;
} slopes[] = { { 0.51,
                 1,
                 { 0.485, 0.49, 0.51, 0.515 },
                 4,
                 1,
                 "the paper's crawler, alpha = 0.51: dv_C rises at both durations, 0.51 T and 0.49 T" },
               { 0.75,
                 2.2,
                 { 1.64, 1.65, 1.66 },
                 3,
                 -1,
                 "the paper's crawler, alpha = 0.75, T = 2.2: dv_C falls at the duration alpha T" } };

static bool goes_on(const double *durations, int count, int sign, const struct scallop_crawler *crawler, double *change)
{
  struct scallop_certified_phase p;
  struct scallop_crawler c = *crawler;
  arb_t before;
  bool always = true;
  arb_init(before);
  scallop_certified_phase_init(&p);
  c.alpha = 0.5;
  for (int i = 0; i < count; i++) {
    c.T = short_number(2 * durations[i], 6);
    always = proven_phase(&p, &c, SCALLOP_EXTENSION, 0) && always;
    arb_sub(before, p.v_end, before, PROVEN_BITS);
    if (i > 0) {
      always = always && (sign > 0 ? arb_is_positive(before) : arb_is_negative(before));
      change[i - 1] = proven_over(before, 1);
    }
    arb_set(before, p.v_end);
  }
  scallop_certified_phase_clear(&p);
  arb_clear(before);
  return always;
}

static void slope_row(const struct words *w, const struct words_claim *claim)
{
  const struct slope *slope = &slopes[claim->which];
  char measured[MEASURED], reason[REASON], modes[MEASURED];
  struct scallop_certified_steady s;
  struct scallop_crawler c = words_paper_crawler(w);
  double change[3] = { 0 };
  c.alpha = slope->alpha, c.T = slope->T;
  scallop_certified_steady_init(&s);
  bool as_said = goes_on(slope->durations, slope->count, slope->sign, &c, change) && proven_steady(&s, &c)
                 && arb_is_positive(s.displacement);
  bool opposite = slope->sign > 0 ? arb_is_negative(s.v_start) : arb_is_positive(s.v_start);
  describe(modes, reason, &s, &c);
  snprintf(measured, sizeof measured,
           "certified: from duration %g to %g dv_C changes by %.6f; v_start T/L = %.6f, displacement/L = %.6f",
           slope->durations[0], slope->durations[1], change[0], proven_over(s.v_start, c.L / c.T),
           proven_over(s.displacement, c.L));
  words_enter(w, claim, slope->conditions, true, words_verdict(as_said && !opposite, as_said), measured, reason);
  scallop_certified_steady_clear(&s);
}

/* ---- through the boundary where v_start vanishes ---- */

enum { PLACES = 3 };

struct passage {
  struct family family;
  double x[PLACES]; /* before the boundary, at it, behind it: 1 % apart                              */
  struct scallop_certified_steady s[PLACES];
  bool proven; /* the states, and that v_start changes its sign                                       */
};

static void pass(struct passage *p, const struct words *w, enum varied varied)
{
  struct scan scan;
  p->family = (struct family){ words_paper_crawler(w), varied };
  family_scan(&scan, &p->family, false);
  double at = rough_boundary(&p->family, &scan);
  p->proven = isfinite(at);
  for (int i = 0; i < PLACES; i++) {
    p->x[i] = p->proven ? short_number(at * (0.99 + 0.01 * i), 6) : 1;
    struct scallop_crawler c = family_member(&p->family, p->x[i]);
    scallop_certified_steady_init(&p->s[i]);
    p->proven = proven_steady(&p->s[i], &c) && p->proven;
  }
  p->proven = p->proven && arb_is_positive(p->s[0].v_start) && arb_is_negative(p->s[PLACES - 1].v_start);
}

static void passed(struct passage *p)
{
  for (int i = 0; i < PLACES; i++)
    scallop_certified_steady_clear(&p->s[i]);
}

static const char *const ranges[] = { "the paper's crawler, F1/F2 from 1 % below to 1 % above the boundary",
                                      "the paper's crawler, F1 and F2 together, from 1 % below to 1 % above the boundary",
                                      "the paper's crawler, T alone, from 1 % below to 1 % above the boundary" };

/* Of three balls: is the middle one above its neighbours, or below one of them? */
static bool peaks(const arb_t x0, const arb_t x1, const arb_t x2) { return arb_gt(x1, x0) && arb_gt(x1, x2); }
static bool exceeded(const arb_t x0, const arb_t x1, const arb_t x2) { return arb_lt(x1, x0) || arb_lt(x1, x2); }

static void v_mid_row(const struct words *w, const struct words_claim *claim)
{
  char measured[MEASURED], reason[REASON];
  struct passage p;
  double unit[PLACES];
  pass(&p, w, (enum varied)claim->which);
  for (int i = 0; i < PLACES; i++) {
    struct scallop_crawler c = family_member(&p.family, p.x[i]);
    unit[i] = c.L / c.T;
  }
  bool holds = p.proven && peaks(p.s[0].v_mid, p.s[1].v_mid, p.s[2].v_mid);
  bool fails = p.proven && exceeded(p.s[0].v_mid, p.s[1].v_mid, p.s[2].v_mid);
  snprintf(measured, sizeof measured, "%s: v_start changes its sign; v_mid T/L = %.6f, %.6f, %.6f at %s = %.6g, %.6g, %.6g",
           p.proven ? "certified" : "not proven", proven_over(p.s[0].v_mid, unit[0]), proven_over(p.s[1].v_mid, unit[1]),
           proven_over(p.s[2].v_mid, unit[2]), family_name(&p.family), p.x[0], p.x[1], p.x[2]);
  snprintf(reason, sizeof reason, "v_mid, the last column, is not highest in the second row: ");
  family_points(reason + strlen(reason), sizeof reason - strlen(reason), &p.family, p.x, PLACES);
  snprintf(reason + strlen(reason), sizeof reason - strlen(reason), " | cut -f 6,10,11");
  words_enter(w, claim, ranges[claim->which], true, words_verdict(holds, fails), measured, reason);
  passed(&p);
}

/* dx_C of a phase of the steady motion at the three places */
static bool phase_moves(arb_t moved[PLACES], const struct passage *p, enum scallop_phase_kind kind)
{
  bool proven = p->proven;
  for (int i = 0; i < PLACES; i++) {
    struct scallop_crawler c = family_member(&p->family, p->x[i]);
    const struct scallop_certified_steady *s = &p->s[i];
    arb_init(moved[i]);
    proven = proven_move(moved[i], &c, kind, kind == SCALLOP_EXTENSION ? s->v_start : s->v_mid) && proven;
  }
  return proven;
}

static void contraction_row(const struct words *w, const struct words_claim *claim)
{
  char measured[MEASURED], reason[REASON], rest[40];
  struct passage p;
  arb_t out[PLACES], back[PLACES];
  pass(&p, w, (enum varied)claim->which);
  bool proven = phase_moves(out, &p, SCALLOP_EXTENSION);
  proven = phase_moves(back, &p, SCALLOP_CONTRACTION) && proven;
  bool holds = proven && peaks(back[0], back[1], back[2]), fails = proven && exceeded(back[0], back[1], back[2]);
  const double L = p.family.crawler.L;
  snprintf(measured, sizeof measured,
           "%s: dx_C/L of the contraction is %.6f, %.6f, %.6f there; of the extension %.6f, %.6f, %.6f",
           proven ? "certified" : "not proven", proven_over(back[0], L), proven_over(back[1], L), proven_over(back[2], L),
           proven_over(out[0], L), proven_over(out[1], L), proven_over(out[2], L));
  struct scallop_crawler c = family_member(&p.family, p.x[1]);
  snprintf(rest, sizeof rest, " --v0 %.6g | cut -f 16", proven_middle(p.s[1].v_mid));
  crawler_command(reason, REASON, "dx_C of the contraction at the boundary: ", "phase --phase contraction", &c, rest);
  words_enter(w, claim, ranges[claim->which], true, words_verdict(holds, fails), measured, reason);
  for (int i = 0; i < PLACES; i++) {
    arb_clear(out[i]);
    arb_clear(back[i]);
  }
  passed(&p);
}

/* ---- L_kin = l0 lT/[2 (lT - l0)]: L for the quadratic gait, pi^2 L/8 for the sinusoidal one ---- */

static void kinematic_length_row(const struct words *w, const struct words_claim *claim)
{
  char measured[MEASURED];
  arb_t l0, lT, length, printed;
  arb_init(l0);
  arb_init(lT);
  arb_init(length);
  arb_init(printed);
  proven_acceleration(l0, &w->crawler, SCALLOP_EXTENSION, printed, false);
  proven_acceleration(lT, &w->crawler, SCALLOP_EXTENSION, printed, true);
  arb_mul(length, l0, lT, PROVEN_BITS);
  arb_sub(lT, lT, l0, PROVEN_BITS);
  arb_mul_2exp_si(lT, lT, 1);
  arb_div(length, length, lT, PROVEN_BITS);
  arb_one(printed);
  if (w->crawler.gait == &scallop_gait_sinusoidal) {
    arb_const_pi(printed, PROVEN_BITS);
    arb_sqr(printed, printed, PROVEN_BITS);
    arb_mul_2exp_si(printed, printed, -3);
  }
  bool holds = arb_overlaps(length, printed) && arb_rel_accuracy_bits(length) > 100;
  snprintf(measured, sizeof measured, "certified: l0 lT/[2 (lT - l0)] = %.12f L", proven_middle(length));
  if (w->crawler.gait == &scallop_gait_quadratic || w->crawler.gait == &scallop_gait_sinusoidal)
    words_enter(w, claim, "L_kin = L for the quadratic gait, pi^2 L/8 for the sinusoidal one", true,
                words_verdict(holds, !arb_overlaps(length, printed)), measured, NULL);
  arb_clear(l0);
  arb_clear(lT);
  arb_clear(length);
  arb_clear(printed);
}

static const char suffice[] = "two_asymmetries_suffice_to_move", froude[] = "moving_needs_a_high_Froude_number";
static const char v_mid[] = "v_mid_peaks_where_v_start_is_0", loss[] = "contraction_loses_least_where_v_start_is_0";

const struct words_claim words_of_regimes[] = {
  { "only_body_1_sticks", "2", "modes", WORDS_EACH_GAIT, example_row, BODY_2_STICKS },
  { "with_one_body_stuck_that_of_less_friction_moves", "2", "modes", WORDS_EACH_GAIT, example_row, BODY_2_STICKS },
  { froude, "2, 5", "displacement", WORDS_EACH_GAIT, example_row, LOW_FROUDE },
  { froude, "2, 5", "displacement", WORDS_EACH_GAIT, example_row, LOWER_FROUDE },
  { froude, "2, 5", "displacement", WORDS_EACH_GAIT, example_row, LOWEST_FROUDE },
  { "one_degree_of_freedom_can_move", "3, 5", "displacement", WORDS_EACH_GAIT, example_row, MOVES },
  { "one_degree_of_freedom_can_move", "3, 5", "displacement", WORDS_EACH_GAIT, example_row, STICK_SLIP_MOVES },
  { suffice, "3 (c), abstract", "displacement", WORDS_EACH_GAIT, standstill_row, 0 },
  { suffice, "3 (c), abstract", "displacement", WORDS_EACH_GAIT, example_row, REST },
  { "the_forces_must_differ_not_the_coefficients", "4.3.3", "displacement", WORDS_EACH_GAIT, example_row, COEFFICIENTS },
  { "kinematic_length", "4.3.3", "L_kin", WORDS_EACH_GAIT, kinematic_length_row, 0 },
  { "start_velocity_is_forward_where_dv_C_rises", "4.4", "v_start", WORDS_EACH_GAIT, slope_row, 0 },
  { "start_velocity_is_backward_where_dv_C_falls", "4.4", "v_start", WORDS_EACH_GAIT, slope_row, 1 },
  { v_mid, "4.4", "v_mid", WORDS_EACH_GAIT, v_mid_row, VARY_RATIO },
  { v_mid, "4.4", "v_mid", WORDS_EACH_GAIT, v_mid_row, VARY_FORCES },
  { v_mid, "4.4", "v_mid", WORDS_EACH_GAIT, v_mid_row, VARY_PERIOD },
  { loss, "4.4", "dx_C", WORDS_EACH_GAIT, contraction_row, VARY_RATIO },
  { loss, "4.4", "dx_C", WORDS_EACH_GAIT, contraction_row, VARY_FORCES },
  { loss, "4.4", "dx_C", WORDS_EACH_GAIT, contraction_row, VARY_PERIOD },
  { "start_velocity_opposes_motion_at_low_Froude", "5", "v_start", WORDS_EACH_GAIT, example_row, STARTS_BACK },
  { .claim = NULL }
};
