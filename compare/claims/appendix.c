/* The claims of the appendices that are not about an order: what is small, what a remainder swallows, and formulas printed without one. Each
 * is decided by a certified example, whose numbers are doubles exactly. */
#include <math.h>
#include <stdio.h>

#include "compare/claims/family.h"
#include "compare/claims/proven.h"
#include "compare/claims/words.h"

enum { MEASURED = 200, REASON = 320, REST = 120 };

/* The first switching time over the duration as T -> 0, from the steady start velocity or from v0 = 1 */
enum { STEADY_START, FIXED_START };

static void first_interval_row(const struct words *w, const struct words_claim *claim)
{
  char measured[MEASURED], reason[REASON], rest[REST];
  double part[2], v0 = 1;
  bool solved = true;
  struct scallop_crawler c = words_paper_crawler(w);
  struct scallop_certified_steady s;
  struct scallop_certified_phase p;
  scallop_certified_steady_init(&s);
  scallop_certified_phase_init(&p);
  for (int i = 0; i < 2; i++) {
    c.T = i ? 1e-20 : 1e-10;
    if (claim->which == STEADY_START) {
      solved = proven_steady(&s, &c) && solved;
      v0 = proven_middle(s.v_start);
    }
    solved = proven_phase(&p, &c, SCALLOP_EXTENSION, v0) && p.switches && solved;
    part[i] = proven_over(p.t1, scallop_phase_duration(&c, SCALLOP_EXTENSION));
  }
  snprintf(measured, sizeof measured, "certified: t1 is %.4g of the duration at T = 1e-10 and %.4g at T = 1e-20", part[0],
           part[1]);
  snprintf(rest, sizeof rest, " --v0 %.7g | cut -f 6,11", v0);
  crawler_command(reason, REASON, "", "phase", &c, rest);
  words_enter(w, claim,
              claim->which == STEADY_START ? "the paper's crawler, from its steady v_start ~ 1/T, to a double's digits"
                                           : "the paper's crawler, from v0 = 1",
              true, words_verdict(solved && part[1] < 1e-6 * part[0], solved), measured, reason);
  scallop_certified_steady_clear(&s);
  scallop_certified_phase_clear(&p);
}

static void swallowed_row(const struct words *w, const struct words_claim *claim)
{
  char measured[MEASURED], reason[REASON];
  double over[2];
  bool proven = true;
  struct scallop_crawler c = words_paper_crawler(w);
  struct scallop_certified_phase p;
  scallop_certified_phase_init(&p);
  for (int i = 0; i < 2; i++) {
    c.T = i ? 1e-20 : 1e-10;
    double tau = scallop_phase_duration(&c, SCALLOP_CONTRACTION);
    proven = proven_phase(&p, &c, SCALLOP_CONTRACTION, 1) && p.switches && proven;
    over[i] = proven_over(p.at_first, tau) / tau;
  }
  bool swallowed = proven && over[0] > 0 && fabs(over[1] / over[0] - 1) < 1e-6;
  snprintf(
      measured, sizeof measured,
      "certified: the term, x2(t1) - x2(0), is %.6f tau^2 at T = 1e-10 and %.6f tau^2 at 1e-20, tau the duration: of the "
      "remainder's order",
      over[0], over[1]);
  c.T = scallop_crawler_default().T;
  crawler_command(reason, REASON, "it is x0' t1/2, and t1 goes as T^2: printf 'T\\n1e-10\\n1e-20\\n' | ",
                  "phase --points - --phase contraction --v0 1", &c, " | cut -f 6,11");
  words_enter(w, claim, "the paper's crawler, from v0 = 1", true, words_verdict(proven && !swallowed, swallowed), measured,
              reason);
  scallop_certified_phase_clear(&p);
}

/* Formulas printed with "=" and no remainder, for any l. In both phases, with m the mass of the body that does not turn, d = F1 - F2,
 * S = F1 + F2 and s = -1 in an extension, 1 in a contraction:
 *   t1 = x0' M/(S - s m l''(0)),   dT = [s x0' M (m l''(0) - d)/(m l''(0) - s S) - d T]/(m l''(T) - d). */
static const struct printed {
  enum scallop_phase_kind kind;
  bool first; /* t1, else dT                                                                        */
  double v0;
  const char *conditions;
} formulas[] = { { SCALLOP_EXTENSION, false, 0, "as printed, without a remainder; the paper's crawler, from rest" },
                 { SCALLOP_EXTENSION, true, 1, "as printed, without a remainder; the paper's crawler, from v0 = 1" },
                 { SCALLOP_EXTENSION, false, 1, "as printed, without a remainder; the paper's crawler, from v0 = 1" },
                 { SCALLOP_CONTRACTION, true, 1, "as printed, without a remainder; the paper's crawler, from v0 = 1" },
                 { SCALLOP_CONTRACTION, false, 1, "as printed, without a remainder; the paper's crawler, from v0 = 1" } };

/* x = x a + b */
static void line(arb_t x, double a, double b)
{
  arb_t y;
  arb_init(y);
  arb_set_d(y, a);
  arb_mul(x, x, y, PROVEN_BITS);
  arb_set_d(y, b);
  arb_add(x, x, y, PROVEN_BITS);
  arb_clear(y);
}

/* m l'' at the start or the end of the phase */
static void end_force(arb_t force, const struct scallop_crawler *c, enum scallop_phase_kind kind, bool from_end)
{
  double tau = scallop_phase_duration(c, kind), m = kind == SCALLOP_EXTENSION ? c->m2 : c->m1;
  arb_t none, unit;
  arb_init(none);
  arb_init(unit);
  proven_acceleration(force, c, kind, none, from_end);
  arb_set_d(unit, tau * tau);
  arb_div(force, force, unit, PROVEN_BITS);
  line(force, m * c->L, 0);
  arb_clear(none);
  arb_clear(unit);
}

static void printed_time(arb_t time, const struct printed *f, const struct scallop_crawler *c)
{
  double d = c->F1 - c->F2, S = c->F1 + c->F2, s = f->kind == SCALLOP_EXTENSION ? -1 : 1, M = c->m1 + c->m2;
  arb_t below;
  arb_init(below);
  end_force(below, c, f->kind, false);
  arb_set(time, below);
  if (f->first) {
    line(below, -s, S);
    arb_set_d(time, f->v0 * M);
  } else {
    line(time, s * f->v0 * M, -s * f->v0 * M * d);
    line(below, 1, -s * S);
    arb_div(time, time, below, PROVEN_BITS);
    line(time, 1, -d * scallop_phase_duration(c, f->kind));
    end_force(below, c, f->kind, true);
    line(below, 1, -d);
  }
  arb_div(time, time, below, PROVEN_BITS);
  arb_clear(below);
}

static void printed_row(const struct words *w, const struct words_claim *claim)
{
  const struct printed *f = &formulas[claim->which];
  char measured[MEASURED], reason[REASON], rest[REST];
  struct scallop_certified_phase p;
  struct scallop_crawler c = words_paper_crawler(w);
  arb_t difference;
  arb_init(difference);
  scallop_certified_phase_init(&p);
  bool solved = proven_phase(&p, &c, f->kind, f->v0) && p.switches;
  arb_srcptr exact = f->first ? p.t1 : p.dT;
  printed_time(difference, f, &c);
  double printed = proven_middle(difference);
  arb_sub(difference, difference, exact, PROVEN_BITS);
  bool holds = solved && arb_contains_zero(difference), differs = solved && arb_is_nonzero(difference);
  snprintf(measured, sizeof measured, "certified: %s = %.12f; the formula gives %.12f%s", claim->quantity,
           proven_middle(exact), printed, holds ? ", the same to 30 digits" : "");
  snprintf(rest, sizeof rest, " --v0 %g --phase %s | cut -f %d", f->v0,
           f->kind == SCALLOP_EXTENSION ? "extension" : "contraction", f->first ? 11 : 12);
  crawler_command(reason, REASON, "", "phase --certified", &c, rest);
  words_enter(w, claim, f->conditions, true, words_verdict(holds, differs), measured, reason);
  scallop_certified_phase_clear(&p);
  arb_clear(difference);
}

const struct words_claim words_of_appendices[] = {
  { "t1_is_small", "(A.6)", "t1", WORDS_EACH_GAIT, first_interval_row, FIXED_START },
  { "t1_is_small", "(A.6), 4.3.3", "t1", WORDS_EACH_GAIT, first_interval_row, STEADY_START },
  { "B_x2_first_switch_exceeds_its_remainder", "(B.3)", "x2(t1)", WORDS_EACH_GAIT, swallowed_row, 0 },
  { "rest_dT_without_remainder", "(13)", "dT", WORDS_EACH_GAIT, printed_row, 0 },
  { "A_t1_without_remainder", "(A.5)", "t1", WORDS_EACH_GAIT, printed_row, 1 },
  { "A_dT_without_remainder", "(A.14)", "dT", WORDS_EACH_GAIT, printed_row, 2 },
  { "B_t1_without_remainder", "(B.2)", "t1", WORDS_EACH_GAIT, printed_row, 3 },
  { "B_dT_without_remainder", "(B.5)", "dT", WORDS_EACH_GAIT, printed_row, 4 },
  { .claim = NULL }
};
