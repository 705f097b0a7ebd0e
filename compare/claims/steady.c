/* The claims in words about steady states: what is needed to move, which way, how many there are, when one is reached, and (27) for
 * which alpha. Each is decided by a certified example. */
#include <math.h>
#include <string.h>

#include "compare/answers/answer_flint.h"
#include "compare/claims/decide.h"
#include "compare/answers/point_flint.h"

/* One steady state that decides */

bool slides_and_moves(const struct scallop_certified_steady *s)
{
  return s->regime == SCALLOP_SLIDING && arb_is_nonzero(s->displacement);
}

bool sticks_and_moves(const struct scallop_certified_steady *s)
{
  return s->regime == SCALLOP_STICK_SLIP && arb_is_nonzero(s->displacement);
}

bool never_moves(const struct scallop_certified_steady *s)
{
  return s->regime == SCALLOP_AT_REST && arb_is_zero(s->displacement);
}

bool body_2_alone_sticks(const struct scallop_certified_steady *s)
{
  bool second = false, first = false;
  for (int kind = 0; kind < 2; kind++)
    for (int i = 0; i < s->modes[kind].count && i < SCALLOP_MODES_KEPT; i++) {
      second = second || s->modes[kind].kept[i].s2 == 0;
      first = first || s->modes[kind].kept[i].s1 == 0;
    }
  return second && !first;
}

bool starts_and_moves_back(const struct scallop_certified_steady *s)
{
  return s->regime == SCALLOP_SLIDING && arb_is_negative(s->v_start) && arb_is_negative(s->displacement);
}

/* What was measured of a certified steady state, and a command that prints it */
static const struct scallop_certified_steady *describe(struct question *q, const struct scallop_crawler *c)
{
  const struct scallop_certified_steady *s = certified_steady(q, c);
  char modes[MOTION_MODES_TEXT];
  measured(q, "certified: Froude %.6g, v_start T/L = %.6f, displacement/L = %.6f, modes %s", middle(s->froude),
           middle(s->v_start) / (c->L / c->T), middle(s->displacement) / c->L,
           motion_modes_text(modes, OF_STEADY, s->modes));
  command(q, "scallop steady --certified", c, " | cut -f 9,10,12,15,16");
  return s;
}

void example(struct question *q)
{
  const struct example *e = q->with;
  struct scallop_crawler c = paper_crawler(q);
  double *const to[] = { &c.m1, &c.m2, &c.F1, &c.F2, &c.L, &c.T, &c.alpha };
  double from[CRAWLER_NUMBERS];
  crawler_numbers(&e->with, from);
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    *to[i] = from[i] > 0 ? from[i] : *to[i];
  under(q, "%s", e->conditions);
  bool shown = e->does(describe(q, &c));
  settle(q, shown && !e->refutes, shown);
}

/* Two regimes of sliding: v_start in the direction of translation at a small ratio of forces, and against it at a large one */
void two_regimes_exist(struct question *q)
{
  const struct scallop_certified_steady *s[2];
  for (int i = 0; i < 2; i++) {
    struct scallop_crawler c = paper_crawler(q);
    c.F1 = i ? 40 : 4;
    s[i] = certified_steady(q, &c);
  }
  const double L = q->crawler.L, unit = L / q->crawler.T;
  bool along = slides_and_moves(s[0]) && arb_is_positive(s[0]->displacement) && arb_is_positive(s[0]->v_start);
  bool against = slides_and_moves(s[1]) && arb_is_positive(s[1]->displacement) && arb_is_negative(s[1]->v_start);
  under(q, "the paper's crawler, F1/F2 = 4 and 40");
  measured(q, "certified: sliding, v_start T/L = %.6f and displacement/L = %.6f at F1/F2 = 4, %.6f and %.6f at 40",
           middle(s[0]->v_start) / unit, middle(s[0]->displacement) / L, middle(s[1]->v_start) / unit,
           middle(s[1]->displacement) / L);
  settle(q, along && against, false);
}

/* Both asymmetries, sliding, and no displacement: it is continuous, so where it changes its sign it is 0. */

static double displacement_at(const void *crawler, double F1)
{
  struct scallop_crawler c = *(const struct scallop_crawler *)crawler;
  c.F1 = F1;
  return steady_state(&c).period.displacement;
}

void standstill(struct question *q)
{
  const struct scallop_certified_steady *s[2];
  struct scallop_crawler c = paper_crawler(q);
  char modes[2][MOTION_MODES_TEXT];
  c.alpha = 0.55;
  double F1 = last_positive(displacement_at, &c, 70, 94), place[2];
  for (int i = 0; i < 2; i++) {
    struct scallop_crawler at = c;
    place[i] = at.F1 = short_number(F1 * (i ? 1 + 1e-10 : 1 - 1e-10), 12);
    s[i] = certified_steady(q, &at);
    motion_modes_text(modes[i], OF_STEADY, s[i]->modes);
  }
  bool slide = s[0]->regime == SCALLOP_SLIDING && s[1]->regime == SCALLOP_SLIDING && strcmp(modes[0], modes[1]) == 0;
  bool zero = slide && arb_is_positive(s[0]->displacement) && arb_is_negative(s[1]->displacement);
  under(q, "the paper's crawler, alpha = 0.55; F1 varied");
  if (zero && q->solved)
    measured(q, "certified: displacement/L %.2e at F1 = %.12g, %.2e at %.12g: 0 between; sliding at both, %s",
             middle(s[0]->displacement) / c.L, place[0], middle(s[1]->displacement) / c.L, place[1], modes[0]);
  else
    measured(q, "that it changes its sign for F1 from 70 to 94, sliding, is not proven");
  reason(q, "displacement changes its sign: printf 'F1\\n%.12g\\n%.12g\\n' | ", place[0], place[1]);
  command(q, "scallop steady --points - --certified", &c, " | cut -f 3,12,15");
  settle(q, false, zero);
}

/* Figure 4B against the start velocity: where dv_C rises (sign 1) or falls (-1) with the duration of an extension from rest, at the
 * durations named, v_start should have that sign. */
static void slope_of_figure_4B(struct question *q, struct scallop_crawler c, int sign, const double *durations, int count)
{
  struct scallop_crawler one = c;
  arb_ptr change = certified_number(q);
  double first = NAN;
  bool always = true;
  one.alpha = 0.5;
  for (int i = 0; i < count; i++) {
    one.T = short_number(2 * durations[i], 6);
    certified_phase(q, &one, SCALLOP_EXTENSION, 0);
    if (i == 0)
      continue;
    arb_sub(change, q->phase[i].v_end, q->phase[i - 1].v_end, EVIDENCE_BITS);
    always = always && (sign > 0 ? arb_is_positive(change) : arb_is_negative(change));
    first = i == 1 ? middle(change) : first;
  }
  const struct scallop_certified_steady *s = certified_steady(q, &c);
  bool as_said = always && arb_is_positive(s->displacement);
  bool opposite = sign > 0 ? arb_is_negative(s->v_start) : arb_is_positive(s->v_start);
  measured(q, "certified: from duration %g to %g dv_C changes by %.6f; v_start T/L = %.6f, displacement/L = %.6f",
           durations[0], durations[1], first, middle(s->v_start) / (c.L / c.T), middle(s->displacement) / c.L);
  command(q, "scallop steady --certified", &c, " | cut -f 9,10,12,15,16");
  settle(q, as_said && !opposite, as_said);
}

void forward_where_dv_rises(struct question *q)
{
  static const double durations[] = { 0.485, 0.49, 0.51, 0.515 };
  struct scallop_crawler c = paper_crawler(q);
  c.alpha = 0.51;
  under(q, "the paper's crawler, alpha = 0.51: dv_C rises at both durations, 0.51 T and 0.49 T");
  slope_of_figure_4B(q, c, 1, durations, 4);
}
void backward_where_dv_falls(struct question *q)
{
  static const double durations[] = { 1.64, 1.65, 1.66 };
  struct scallop_crawler c = paper_crawler(q);
  c.T = 2.2;
  under(q, "the paper's crawler, alpha = 0.75, T = 2.2: dv_C falls at the duration alpha T");
  slope_of_figure_4B(q, c, -1, durations, 3);
}

/* L_kin = l0 lT/[2 (lT - l0)]: L for the quadratic gait, pi^2 L/8 for the sinusoidal one */
void kinematic_length(struct question *q)
{
  arb_ptr l0 = certified_number(q), lT = certified_number(q), speed = certified_number(q);
  arb_ptr length = certified_number(q), printed = certified_number(q), zero = certified_number(q);
  bool sinusoidal = q->crawler.gait == &scallop_gait_sinusoidal;
  if (!sinusoidal && q->crawler.gait != &scallop_gait_quadratic)
    return;
  certified_law(speed, l0, &q->crawler, SCALLOP_EXTENSION, zero, false);
  certified_law(speed, lT, &q->crawler, SCALLOP_EXTENSION, zero, true);
  arb_mul(length, l0, lT, EVIDENCE_BITS);
  arb_sub(lT, lT, l0, EVIDENCE_BITS);
  arb_mul_2exp_si(lT, lT, 1);
  arb_div(length, length, lT, EVIDENCE_BITS);
  arb_one(printed);
  if (sinusoidal) {
    arb_const_pi(printed, EVIDENCE_BITS);
    arb_sqr(printed, printed, EVIDENCE_BITS);
    arb_mul_2exp_si(printed, printed, -3);
  }
  bool equal = arb_overlaps(length, printed);
  under(q, "L_kin = L for the quadratic gait, pi^2 L/8 for the sinusoidal one");
  measured(q, "certified: l0 lT/[2 (lT - l0)] = %.12f L", middle(length));
  settle(q, equal && arb_rel_accuracy_bits(length) > 100, !equal);
}

/* (27), v_start T -> (F1-F2)(2 alpha-1) L_kin m* / (alpha^2 F1 m1 + (1-alpha)^2 F2 m2), for which alpha? */

/* (27) over the certified v_start at T = 1e-20, minus 1; mirrored: of the bodies exchanged, and with the opposite sign */
static double relative_error(const struct scallop_crawler *crawler, double alpha, bool mirrored)
{
  const struct scallop_formula *formula = scallop_published;
  struct scallop_rational_crawler exact;
  struct question q;
  struct scallop_crawler c = *crawler;
  double error = NAN;
  while (strcmp(formula->name, "text_steady_velocity") != 0)
    formula++;
  c.alpha = alpha;
  c.T = 1e-20;
  question_init(&q);
  scallop_rational_init(&exact);
  arb_srcptr v_start = certified_steady(&q, &c)->v_start;
  arb_ptr ratio = certified_number(&q);
  if (mirrored)
    c = (struct scallop_crawler){ c.m2, c.m1, c.F2, c.F1, c.L, c.T, c.alpha, c.gait };
  rational_crawler(&exact, &c);
  if (q.solved && published_in_balls(ratio, formula, &exact, SCALLOP_EXTENSION, NULL, exact.T, NULL, EVIDENCE_BITS)) {
    arb_div(ratio, ratio, v_start, EVIDENCE_BITS);
    if (mirrored)
      arb_neg(ratio, ratio);
    arb_sub_ui(ratio, ratio, 1, EVIDENCE_BITS);
    error = middle(ratio);
  }
  scallop_rational_clear(&exact);
  question_clear(&q);
  return error;
}

void velocity_in_the_limit(struct question *q)
{
  const struct alphas *alphas = q->with;
  const int first = alphas->first, shown = alphas->shown;
  const bool mirrored = alphas->mirrored;
  int last = first + 48, at = first;
  double worst = 0;
  for (int i = first; i <= last; i += 8) {
    double error = relative_error(&q->crawler, i / 100., mirrored);
    if (!(fabs(error) <= fabs(worst))) {
      worst = error;
      at = i;
    }
  }
  bool holds = fabs(worst) < 1e-15;
  under(q, "%s, T = 1e-20, alpha from %.2f to %.2f by 0.08%s", q->whose, first / 100., last / 100.,
        mirrored ? "; with F1 m1 and F2 m2 exchanged below the line" : "");
  q->row.inside = first > 50;
  if (holds)
    measured(q, "relative error, certified: below 1e-15 throughout");
  else
    measured(q, "relative error, certified: %.6f at alpha = %.2f, largest %.6f at alpha = %.2f",
             relative_error(&q->crawler, shown / 100., mirrored), shown / 100., worst, at / 100.);
  if (q->of_the_paper) {
    const struct scallop_crawler c = paper_crawler(q);
    reason(q, "published against exact: scallop series --T 1e-6 --alpha %.2f", shown / 100.);
    command(q, "", &c, " | grep '^text_steady_velocity.(27)'");
  }
  settle(q, holds, isfinite(worst));
}

/* Is the steady state reached? */

/* Periods from rest until the velocity is within 1e-6 L/T of the steady one, or, with `same`, until it is the same; 0: not in 1000 */
static int periods_until(const struct scallop_crawler *c, bool same)
{
  struct scallop_period_result p = { .v_end = 0 };
  double v = steady_state(c).period.v_start;
  for (int n = 1; n <= 1000; n++) {
    double before = p.v_end;
    if (scallop_period(c, before, &p) < 0)
      return 0;
    if (same ? p.v_end == before : fabs(p.v_end - v) <= 1e-6 * c->L / c->T)
      return same ? n - 1 : n;
  }
  return 0;
}

void reached(struct question *q)
{
  struct scallop_crawler c = q->crawler;
  c.T = *(const double *)q->with;
  arb_srcptr multiplier = certified_steady(q, &c)->multiplier;
  bool zero = arb_is_zero(multiplier), proven = q->solved && (zero || arb_is_positive(multiplier));
  if (!proven)
    measured(q, "not proven");
  else if (zero)
    measured(q, "certified multiplier 0; from rest the velocity is the steady one after %d period", periods_until(&c, true));
  else
    measured(q,
             "certified multiplier %.10f > 0: the distance shrinks by that and is never 0; within 1e-6 L/T after %d periods",
             middle(multiplier), periods_until(&c, false));
  under(q, "the paper's crawler, T = %g, from rest; read as: after finitely many periods", c.T);
  reason(q, "the multiplier is not 0: ");
  command(q, "scallop steady --certified", &c, " | cut -f 14");
  settle(q, proven && zero, proven);
}

/* Two gaits that the paper does not have */

/* l' constant out and back: many steady states */
static const struct scallop_piece out[] = {
  { .begin = 0, .end = 1, .direction = 1, .jump = true, .linear = true, .velocity = 1, .curve = &scallop_curve_linear }
};
static const struct scallop_piece back[] = {
  { .begin = 0, .end = 1, .direction = -1, .jump = true, .linear = true, .velocity = -1, .curve = &scallop_curve_linear }
};
static const struct scallop_gait sawtooth = {
  "sawtooth", { { out, 1, 0, 0, 1, 1, false, false }, { back, 1, 0, 0, 1, -1, false, false } }
};

void unique_with_jumps(struct question *q)
{
  struct scallop_crawler c = scallop_crawler_default();
  struct scallop_steady_result r;
  c.alpha = 0.5;
  c.gait = &sawtooth;
  bool many = scallop_steady(&c, &r) == SCALLOP_INTERVAL;
  double unit = c.L / c.T;
  q->row.gait = sawtooth.name;
  q->row.inside = false;
  under(q, "l' constant out and back, with jumps; alpha = 1/2, else the paper's crawler");
  measured(q, "every v_start T/L from %.6f to %.6f is steady", r.v_low / unit, r.v_high / unit);
  reason(q, "by hand: while |x_C'| < L/T the bodies move oppositely throughout; x_C' gains (F1-F2)T/(2M) = 0.75 in the "
            "extension and loses it again");
  settle(q, !many, true);
}

/* Section 4.2 takes l(t) = l(T - t) for symmetric; its argument needs l'' to change sign from phase to phase. A gait with the first and
 * not the second: phases of equal duration, the extension gathering speed in its first fifth and losing it in the rest, the contraction
 * the same backward in time. */
static const struct scallop_piece quick_start[] = { SCALLOP_RAMP(0, 0.2, SCALLOP_FROM_START, 1, 10),
                                                    SCALLOP_RAMP(0.8, 0, SCALLOP_FROM_END, 1, -2.5) };
static const struct scallop_piece quick_end[] = { SCALLOP_RAMP(0, 0.8, SCALLOP_FROM_START, -1, -2.5),
                                                  SCALLOP_RAMP(0.2, 0, SCALLOP_FROM_END, -1, 10) };
static const struct scallop_gait reversible = {
  "reversible", { { quick_start, 2, 10, -2.5, 2, 1, true, true }, { quick_end, 2, -2.5, 10, 2, -1, true, true } }
};

void reversible_kinematics(struct question *q)
{
  struct scallop_crawler c = scallop_crawler_default();
  c.alpha = 0.5;
  c.gait = &reversible;
  double moved = steady_state(&c).period.displacement / c.L;
  q->row.gait = reversible.name;
  under(q, "l(t) = l(T - t): l' rises for 0.2 of the extension and falls for 0.8, alpha = 1/2, else the paper's crawler");
  measured(q, "displacement/L: %.6f", moved);
  settle(q, fabs(moved) <= EVIDENCE_ZERO, true);
}
