/* The claims in words about a single phase, and those of the appendices that are not about an order. Each is decided by a certified
 * example, whose numbers are doubles exactly. */
#include <math.h>

#include "compare/claims/decide.h"

/* Equal friction: (8), and the centre */

void equal_forces_centre(struct question *q)
{
  struct scallop_crawler c = paper_crawler(q);
  c.F1 = c.F2, c.m1 = 2;
  const struct scallop_certified_phase *p = certified_phase(q, &c, SCALLOP_EXTENSION, 0);
  arb_ptr printed = certified_number(q);
  arb_mul_2exp_si(printed, p->dx1, -1); /* (m1/m2 - 1)/2 = 1/2 */
  under(q, "the paper's crawler, F1 = F2 = 1, m1 = 2");
  measured(q, "certified: dx_1/L = %.6f, dx_C/L = %.6f, and (8) gives %.6f; (1 - m1/m2)/2 dx_1 is right",
           middle(p->dx1) / c.L, middle(p->dxC) / c.L, middle(printed) / c.L);
  command(q, "scallop phase --certified", &c, " | cut -f 14,16");
  settle(q, arb_overlaps(printed, p->dxC), true);
}

void still_centre(struct question *q)
{
  struct scallop_crawler c = paper_crawler(q);
  bool still = true;
  c.F1 = c.F2;
  for (int kind = 0; kind < 2; kind++) {
    arb_srcptr moved = certified_phase(q, &c, (enum scallop_phase_kind)kind, 0)->dxC;
    still = still && arb_contains_zero(moved) && mag_cmp_2exp_si(arb_radref(moved), -80) < 0;
  }
  under(q, "the paper's crawler, F1 = F2 = 1");
  measured(q,
           still ? "by (6) x_C' = (m1-m2)/(2M) l'; certified: |dx_C| < 2^-80 in both phases" : "certified: dx_C is not 0");
  settle(q, still, true);
}

/* Which way the centre moves */

void heavy_front(struct question *q)
{
  struct scallop_crawler c = paper_crawler(q);
  c.m2 = 4;
  const struct scallop_certified_phase *p = certified_phase(q, &c, SCALLOP_EXTENSION, 0);
  under(q, "the paper's crawler, m2 = 4, from rest");
  measured(q, "certified: dx_C/L = %.6f, dx_1/L = %.6f, dx_2/L = %.6f", middle(p->dxC) / c.L, middle(p->dx1) / c.L,
           middle(p->dx2) / c.L);
  command(q, "scallop phase --certified", &c, " | cut -f 14,15,16");
  settle_by_sign(q, p->dxC);
}

void steady_contraction(struct question *q)
{
  struct scallop_crawler c = paper_crawler(q);
  const struct scallop_certified_steady *s = certified_steady(q, &c);
  arb_ptr moved = certified_move(q, &c, SCALLOP_CONTRACTION, s->v_mid);
  under(q, "the paper's crawler in its steady state");
  measured(q, "certified: from v_mid T/L = %.6f the centre moves by dx_C/L = %.6f in the contraction",
           middle(s->v_mid) / (c.L / c.T), middle(moved) / c.L);
  command(q, "scallop phase --phase contraction", &c, " --v0 %.7g | cut -f 10,16", middle(s->v_mid));
  settle(q, arb_is_negative(moved), arb_is_positive(moved));
}

void longer_is_faster(struct question *q)
{
  struct scallop_crawler c = paper_crawler(q);
  double fast[2];
  for (int kind = 0; kind < 2; kind++)
    fast[kind] = c.L / scallop_phase_duration(&c, (enum scallop_phase_kind)kind);
  under(q, "the paper's crawler");
  measured(q, "mean |l'| is L over the duration: %.6g in the longer extension, %.6g in the contraction", fast[0], fast[1]);
  command(q, "scallop trajectory --start rest --periods 1 --samples 4", &c, " | cut -f 1,7");
  settle(q, fast[0] > fast[1], true);
}

void falling_velocity(struct question *q)
{
  struct scallop_crawler c = paper_crawler(q);
  const struct scallop_certified_phase *p = certified_phase(q, &c, SCALLOP_EXTENSION, 20);
  arb_ptr gain = certified_number(q);
  arb_sub_ui(gain, p->v_end, 20, EVIDENCE_BITS);
  under(q, "the paper's crawler, from v0 = 20");
  q->row.inside = false;
  measured(q, "certified: v_end = %.6f", middle(p->v_end));
  command(q, "scallop phase --certified --v0 20", &c, " | cut -f 10,13");
  settle_by_sign(q, gain);
}

/* The first interval of an extension from rest */

void first_interval_accelerates(struct question *q)
{
  struct scallop_crawler c = paper_crawler(q);
  const struct scallop_certified_phase *p = certified_phase(q, &c, SCALLOP_EXTENSION, 0);
  arb_ptr part = certified_number(q), speed = certified_number(q), rate = certified_number(q);
  arb_set_d(part, scallop_phase_duration(&c, SCALLOP_EXTENSION));
  arb_div(part, p->dT, part, EVIDENCE_BITS);
  certified_law(speed, rate, &c, SCALLOP_EXTENSION, part, true);
  under(q, "the paper's crawler, from rest");
  measured(q, "certified: when it ends, %.6f of the duration before T, l'' = %.6f L/T^2, T the duration; l' > 0 is meant",
           middle(part), middle(rate));
  reason(q, "the steps of l, the last column, shrink while v1 < 0: ");
  command(q, "scallop trajectory --start rest --periods 1 --samples 8", &c, " | cut -f 1,5,7");
  settle(q, p->switches && arb_is_positive(rate), p->switches && arb_is_negative(rate));
}

/* x = x a + b */
static void line(arb_t x, double a, double b)
{
  arb_t y;
  arb_init(y);
  arb_set_d(y, a);
  arb_mul(x, x, y, EVIDENCE_BITS);
  arb_set_d(y, b);
  arb_add(x, x, y, EVIDENCE_BITS);
  arb_clear(y);
}

/* v1 and v2 at a quarter of the duration, both bodies having moved oppositely from rest */
void body_1_slower(struct question *q)
{
  struct scallop_crawler c = paper_crawler(q);
  c.m1 = *(const double *)q->with;
  double tau = scallop_phase_duration(&c, SCALLOP_EXTENSION), M = c.m1 + c.m2;
  double gained = (c.F1 - c.F2) * tau / 4 * tau / c.L; /* x_C' M, in L/tau */
  arb_ptr quarter = certified_number(q), rate = certified_number(q), sum = certified_number(q);
  arb_ptr v1 = certified_number(q), v2 = certified_number(q);
  const struct scallop_certified_phase *p = certified_phase(q, &c, SCALLOP_EXTENSION, 0);
  under(q, "the paper's crawler, %sfrom rest", c.m1 == 1 ? "" : "m1 = 0.5, ");
  arb_set_d(quarter, tau / 4);
  bool opposed = p->switches && arb_lt(quarter, p->t1);
  arb_set_d(quarter, 0.25);
  certified_law(v1, rate, &c, SCALLOP_EXTENSION, quarter, false);
  arb_set(v2, v1);
  line(v1, -c.m2, gained);
  line(v2, c.m1, gained);
  arb_add(sum, v1, v2, EVIDENCE_BITS);
  measured(q, "v1 + v2 = [2 (F1-F2) t - (m2-m1) l']/M; certified at a quarter of the duration: v1 T/L = %.6f, v2 T/L = %.6f",
           middle(v1) / (M * tau / c.T), middle(v2) / (M * tau / c.T));
  command(q, "scallop trajectory --start rest --periods 1 --samples 16", &c, " | grep '^0.1875' | cut -f 5,6");
  settle(q, opposed && arb_is_positive(sum), opposed && arb_is_negative(sum));
}

/* Without the last interval, the friction of the first one acting to the end, the centre would come as far as (21) has it. */
void last_interval_carries(struct question *q)
{
  struct scallop_crawler c = paper_crawler(q);
  double tau = scallop_phase_duration(&c, SCALLOP_EXTENSION);
  const struct scallop_certified_phase *p = certified_phase(q, &c, SCALLOP_EXTENSION, 0);
  arb_ptr without = certified_number(q);
  arb_set_d(without, (c.F1 - c.F2) * tau * tau / 4); /* M = 2, m1 = m2 */
  under(q, "the paper's crawler, an extension from rest");
  measured(q, "certified: dx_C/L = %.9f; with the friction of the first interval to the end it would be %.9f",
           middle(p->dxC) / c.L, middle(without) / c.L);
  reason(q, "dxC is below (F1-F2) 0.75^2/(2M) = 0.421875: ");
  command(q, "scallop phase --certified", &c, " | cut -f 16");
  settle(q, p->switches && arb_gt(p->dxC, without), p->switches && arb_lt(p->dxC, without));
}

void opposite_phases(struct question *q)
{
  struct scallop_crawler c = paper_crawler(q);
  c.alpha = 0.5;
  arb_srcptr out = certified_phase(q, &c, SCALLOP_EXTENSION, 1)->v_end;
  arb_srcptr back = certified_phase(q, &c, SCALLOP_CONTRACTION, 1)->v_end;
  arb_ptr sum = certified_number(q);
  arb_add(sum, out, back, EVIDENCE_BITS);
  arb_sub_ui(sum, sum, 2, EVIDENCE_BITS);
  under(q, "the paper's crawler, alpha = 1/2, from v0 = 1");
  measured(q, "certified: the velocity changes by %.6f in the extension and by %.6f in the contraction", middle(out) - 1,
           middle(back) - 1);
  reason(q, "for p in extension contraction; do ");
  command(q, "scallop phase --v0 1", &c, " --phase $p | tail -n 1 | cut -f 10,13; done");
  settle(q, arb_contains_zero(sum), arb_is_nonzero(sum));
}

/* Is the first switching time a smaller and smaller part of the duration as T -> 0? From the steady start velocity, or v0 = 1 */

void t1_is_small(struct question *q)
{
  bool from_steady_state = q->with != NULL;
  double part[2], v0 = 1;
  bool turns = true;
  struct scallop_crawler c = paper_crawler(q);
  for (int i = 0; i < 2; i++) {
    c.T = i ? 1e-20 : 1e-10;
    if (from_steady_state)
      v0 = middle(certified_steady(q, &c)->v_start);
    const struct scallop_certified_phase *p = certified_phase(q, &c, SCALLOP_EXTENSION, v0);
    turns = p->switches && turns;
    part[i] = middle(p->t1) / scallop_phase_duration(&c, SCALLOP_EXTENSION);
  }
  under(q, "the paper's crawler, from %s", from_steady_state ? "its steady v_start ~ 1/T, to a double's digits" : "v0 = 1");
  measured(q, "certified: t1 is %.4g of the duration at T = 1e-10 and %.4g at T = 1e-20", part[0], part[1]);
  command(q, "scallop phase", &c, " --v0 %.7g | cut -f 6,11", v0);
  settle(q, turns && part[1] < 1e-6 * part[0], turns);
}

void swallowed_term(struct question *q)
{
  double over[2];
  bool turns = true;
  struct scallop_crawler c = paper_crawler(q);
  for (int i = 0; i < 2; i++) {
    c.T = i ? 1e-20 : 1e-10;
    double tau = scallop_phase_duration(&c, SCALLOP_CONTRACTION);
    const struct scallop_certified_phase *p = certified_phase(q, &c, SCALLOP_CONTRACTION, 1);
    turns = p->switches && turns;
    over[i] = middle(p->at_first) / tau / tau;
  }
  bool swallowed = turns && over[0] > 0 && fabs(over[1] / over[0] - 1) < 1e-6;
  under(q, "the paper's crawler, from v0 = 1");
  measured(
      q,
      "certified: the term, x2(t1) - x2(0), is %.6f tau^2 at T = 1e-10 and %.6f tau^2 at 1e-20, tau the duration: of the "
      "remainder's order",
      over[0], over[1]);
  c = paper_crawler(q);
  reason(q, "it is x0' t1/2, and t1 goes as T^2: printf 'T\\n1e-10\\n1e-20\\n' | ");
  command(q, "scallop phase --points - --phase contraction --v0 1", &c, " | cut -f 6,11");
  settle(q, turns && !swallowed, swallowed);
}

/* Formulas printed with "=" and no remainder, for any l. In both phases, with m the mass of the body that does not turn, d = F1 - F2,
 * S = F1 + F2 and s = -1 in an extension, 1 in a contraction:
 *   t1 = x0' M/(S - s m l''(0)),   dT = [s x0' M (m l''(0) - d)/(m l''(0) - s S) - d T]/(m l''(T) - d). */

/* m l'' at the start or the end of the phase */
static void end_force(arb_t force, const struct scallop_crawler *c, enum scallop_phase_kind kind, bool from_end)
{
  double tau = scallop_phase_duration(c, kind), m = kind == SCALLOP_EXTENSION ? c->m2 : c->m1;
  arb_t at, speed;
  arb_init(at);
  arb_init(speed);
  certified_law(speed, force, c, kind, at, from_end);
  arb_set_d(speed, tau * tau);
  arb_div(force, force, speed, EVIDENCE_BITS);
  line(force, m * c->L, 0);
  arb_clear(at);
  arb_clear(speed);
}

static void printed_time(arb_t time, const struct scallop_crawler *c, enum scallop_phase_kind kind, bool is_t1, double v0)
{
  double d = c->F1 - c->F2, S = c->F1 + c->F2, s = kind == SCALLOP_EXTENSION ? -1 : 1, M = c->m1 + c->m2;
  arb_t below;
  arb_init(below);
  end_force(below, c, kind, false);
  arb_set(time, below);
  if (is_t1) {
    line(below, -s, S);
    arb_set_d(time, v0 * M);
  } else {
    line(time, s * v0 * M, -s * v0 * M * d);
    line(below, 1, -s * S);
    arb_div(time, time, below, EVIDENCE_BITS);
    line(time, 1, -d * scallop_phase_duration(c, kind));
    end_force(below, c, kind, true);
    line(below, 1, -d);
  }
  arb_div(time, time, below, EVIDENCE_BITS);
  arb_clear(below);
}

void without_remainder(struct question *q)
{
  const struct printed *given = q->with;
  const enum scallop_phase_kind kind = given->kind;
  const bool is_t1 = given->is_t1;
  const double v0 = given->v0;
  struct scallop_crawler c = paper_crawler(q);
  const struct scallop_certified_phase *p = certified_phase(q, &c, kind, v0);
  arb_srcptr exact = is_t1 ? p->t1 : p->dT;
  arb_ptr difference = certified_number(q);
  printed_time(difference, &c, kind, is_t1, v0);
  double printed = middle(difference);
  arb_sub(difference, difference, exact, EVIDENCE_BITS);
  bool holds = q->solved && p->switches && arb_contains_zero(difference);
  under(q, "as printed, without a remainder; the paper's crawler, from %s", v0 > 0 ? "v0 = 1" : "rest");
  measured(q, "certified: %s = %.12f; the formula gives %.12f%s", q->row.quantity, middle(exact), printed,
           holds ? ", the same to 30 digits" : "");
  command(q, "scallop phase --certified", &c, " --v0 %g --phase %s | cut -f %d", v0,
          kind == SCALLOP_EXTENSION ? "extension" : "contraction", is_t1 ? 11 : 12);
  settle(q, holds, p->switches && arb_is_nonzero(difference));
}
