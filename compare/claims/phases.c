/* The claims in words about a single phase. Each is decided by a certified example, whose numbers are doubles exactly. */
#include <stdio.h>

#include "compare/claims/family.h"
#include "compare/claims/proven.h"
#include "compare/claims/words.h"

enum { MEASURED = 200, REASON = 320, REST = 120 };

/* ---- equal friction: (8), and the centre ---- */

static void equal_centre_row(const struct words *w, const struct words_claim *claim)
{
  char measured[MEASURED], reason[REASON];
  struct scallop_certified_phase p;
  struct scallop_crawler c = words_paper_crawler(w);
  arb_t printed;
  arb_init(printed);
  c.F1 = c.F2, c.m1 = 2;
  scallop_certified_phase_init(&p);
  bool solved = proven_phase(&p, &c, SCALLOP_EXTENSION, 0);
  arb_mul_2exp_si(printed, p.dx1, -1); /* (m1/m2 - 1)/2 = 1/2 */
  snprintf(measured, sizeof measured,
           "certified: dx_1/L = %.6f, dx_C/L = %.6f, and (8) gives %.6f; (1 - m1/m2)/2 dx_1 is right",
           proven_over(p.dx1, c.L), proven_over(p.dxC, c.L), proven_over(printed, c.L));
  crawler_command(reason, REASON, "", "phase --certified", &c, " | cut -f 14,16");
  words_enter(w, claim, "the paper's crawler, F1 = F2 = 1, m1 = 2", true,
              words_verdict(solved && arb_overlaps(printed, p.dxC), solved && !arb_overlaps(printed, p.dxC)), measured,
              reason);
  scallop_certified_phase_clear(&p);
  arb_clear(printed);
}

static void still_centre_row(const struct words *w, const struct words_claim *claim)
{
  struct scallop_certified_phase p[2];
  struct scallop_crawler c = words_paper_crawler(w);
  bool solved = true, still = true;
  c.F1 = c.F2;
  for (int kind = 0; kind < 2; kind++) {
    scallop_certified_phase_init(&p[kind]);
    solved = proven_phase(&p[kind], &c, (enum scallop_phase_kind)kind, 0) && solved;
    still = still && arb_contains_zero(p[kind].dxC) && mag_cmp_2exp_si(arb_radref(p[kind].dxC), -80) < 0;
  }
  words_enter(w, claim, "the paper's crawler, F1 = F2 = 1", true, words_verdict(solved && still, solved && !still),
              still ? "by (6) x_C' = (m1-m2)/(2M) l'; certified: |dx_C| < 2^-80 in both phases" : "certified: dx_C is not 0",
              NULL);
  for (int kind = 0; kind < 2; kind++)
    scallop_certified_phase_clear(&p[kind]);
}

/* ---- which way the centre moves ---- */

static void heavy_front_row(const struct words *w, const struct words_claim *claim)
{
  char measured[MEASURED], reason[REASON];
  struct scallop_certified_phase p;
  struct scallop_crawler c = words_paper_crawler(w);
  c.m2 = 4;
  scallop_certified_phase_init(&p);
  bool solved = proven_phase(&p, &c, SCALLOP_EXTENSION, 0);
  snprintf(measured, sizeof measured, "certified: dx_C/L = %.6f, dx_1/L = %.6f, dx_2/L = %.6f", proven_over(p.dxC, c.L),
           proven_over(p.dx1, c.L), proven_over(p.dx2, c.L));
  crawler_command(reason, REASON, "", "phase --certified", &c, " | cut -f 14,15,16");
  words_enter(w, claim, "the paper's crawler, m2 = 4, from rest", true,
              words_verdict(solved && arb_is_positive(p.dxC), solved && arb_is_negative(p.dxC)), measured, reason);
  scallop_certified_phase_clear(&p);
}

static void steady_contraction_row(const struct words *w, const struct words_claim *claim)
{
  char measured[MEASURED], reason[REASON], rest[REST];
  struct scallop_certified_steady s;
  struct scallop_crawler c = words_paper_crawler(w);
  arb_t moved;
  arb_init(moved);
  scallop_certified_steady_init(&s);
  bool solved = proven_steady(&s, &c) && proven_move(moved, &c, SCALLOP_CONTRACTION, s.v_mid);
  snprintf(measured, sizeof measured,
           "certified: from v_mid T/L = %.6f the centre moves by dx_C/L = %.6f in the contraction",
           proven_over(s.v_mid, c.L / c.T), proven_over(moved, c.L));
  snprintf(rest, sizeof rest, " --v0 %.7g | cut -f 10,16", proven_middle(s.v_mid));
  crawler_command(reason, REASON, "", "phase --phase contraction", &c, rest);
  words_enter(w, claim, "the paper's crawler in its steady state", true,
              words_verdict(solved && arb_is_negative(moved), solved && arb_is_positive(moved)), measured, reason);
  scallop_certified_steady_clear(&s);
  arb_clear(moved);
}

static void slower_row(const struct words *w, const struct words_claim *claim)
{
  char measured[MEASURED], reason[REASON];
  struct scallop_crawler c = words_paper_crawler(w);
  double extension = c.L / scallop_phase_duration(&c, SCALLOP_EXTENSION),
         contraction = c.L / scallop_phase_duration(&c, SCALLOP_CONTRACTION);
  snprintf(measured, sizeof measured,
           "mean |l'| is L over the duration: %.6g in the longer extension, %.6g in the contraction", extension,
           contraction);
  crawler_command(reason, REASON, "", "trajectory --start rest --periods 1 --samples 4", &c, " | cut -f 1,7");
  words_enter(w, claim, "the paper's crawler", true, words_verdict(extension > contraction, true), measured, reason);
}

static void falling_velocity_row(const struct words *w, const struct words_claim *claim)
{
  char measured[MEASURED], reason[REASON];
  struct scallop_certified_phase p;
  struct scallop_crawler c = words_paper_crawler(w);
  arb_t gain;
  arb_init(gain);
  scallop_certified_phase_init(&p);
  bool solved = proven_phase(&p, &c, SCALLOP_EXTENSION, 20);
  arb_sub_ui(gain, p.v_end, 20, PROVEN_BITS);
  snprintf(measured, sizeof measured, "certified: v_end = %.6f", proven_middle(p.v_end));
  crawler_command(reason, REASON, "", "phase --certified --v0 20", &c, " | cut -f 10,13");
  words_enter(w, claim, "the paper's crawler, from v0 = 20", false,
              words_verdict(solved && arb_is_positive(gain), solved && arb_is_negative(gain)), measured, reason);
  scallop_certified_phase_clear(&p);
  arb_clear(gain);
}

/* ---- the first interval of an extension from rest ---- */

static void acceleration_row(const struct words *w, const struct words_claim *claim)
{
  char measured[MEASURED], reason[REASON];
  struct scallop_certified_phase p;
  struct scallop_crawler c = words_paper_crawler(w);
  arb_t part, rate;
  arb_init(part);
  arb_init(rate);
  scallop_certified_phase_init(&p);
  bool solved = proven_phase(&p, &c, SCALLOP_EXTENSION, 0) && p.switches;
  arb_set_d(rate, scallop_phase_duration(&c, SCALLOP_EXTENSION));
  arb_div(part, p.dT, rate, PROVEN_BITS);
  proven_acceleration(rate, &c, SCALLOP_EXTENSION, part, true);
  snprintf(measured, sizeof measured,
           "certified: when it ends, %.6f of the duration before T, l'' = %.6f L/T^2, T the duration; l' > 0 is meant",
           proven_middle(part), proven_middle(rate));
  crawler_command(reason, REASON, "the steps of l, the last column, shrink while v1 < 0: ",
                  "trajectory --start rest --periods 1 --samples 8", &c, " | cut -f 1,5,7");
  words_enter(w, claim, "the paper's crawler, from rest", true,
              words_verdict(solved && arb_is_positive(rate), solved && arb_is_negative(rate)), measured, reason);
  scallop_certified_phase_clear(&p);
  arb_clear(part);
  arb_clear(rate);
}

/* v1 and v2 at a quarter of the duration, both bodies having moved oppositely from rest, in L/T */
static void quarter_velocities(arb_t v1, arb_t v2, const struct scallop_crawler *c)
{
  arb_t part, gained, speed;
  arb_init(part);
  arb_init(gained);
  arb_init(speed);
  arb_one(part);
  arb_mul_2exp_si(part, part, -2);
  proven_speed(speed, c, SCALLOP_EXTENSION, part, false);
  double tau = scallop_phase_duration(c, SCALLOP_EXTENSION), M = c->m1 + c->m2;
  arb_set_d(gained, (c->F1 - c->F2) * tau / 4 * tau / c->L); /* c M, in L/tau */
  arb_set_d(part, -c->m2);
  arb_mul(v1, part, speed, PROVEN_BITS);
  arb_set_d(part, c->m1);
  arb_mul(v2, part, speed, PROVEN_BITS);
  arb_set_d(part, M * tau / c->T);
  arb_add(v1, v1, gained, PROVEN_BITS);
  arb_add(v2, v2, gained, PROVEN_BITS);
  arb_div(v1, v1, part, PROVEN_BITS);
  arb_div(v2, v2, part, PROVEN_BITS);
  arb_clear(part);
  arb_clear(gained);
  arb_clear(speed);
}

/* which: m1 < m2 */
static void slower_body_row(const struct words *w, const struct words_claim *claim)
{
  char measured[MEASURED], reason[REASON];
  struct scallop_certified_phase p;
  struct scallop_crawler c = words_paper_crawler(w);
  arb_t v1, v2, sum;
  arb_init(v1);
  arb_init(v2);
  arb_init(sum);
  if (claim->which)
    c.m1 = 0.5;
  scallop_certified_phase_init(&p);
  arb_set_d(sum, scallop_phase_duration(&c, SCALLOP_EXTENSION) / 4);
  bool opposed = proven_phase(&p, &c, SCALLOP_EXTENSION, 0) && p.switches && arb_lt(sum, p.t1);
  quarter_velocities(v1, v2, &c);
  arb_add(sum, v1, v2, PROVEN_BITS);
  snprintf(measured, sizeof measured,
           "v1 + v2 = [2 (F1-F2) t - (m2-m1) l']/M; certified at a quarter of the duration: v1 T/L = %.6f, v2 T/L = %.6f",
           proven_middle(v1), proven_middle(v2));
  crawler_command(reason, REASON, "", "trajectory --start rest --periods 1 --samples 16", &c,
                  " | grep '^0.1875' | cut -f 5,6");
  words_enter(w, claim, claim->which ? "the paper's crawler, m1 = 0.5, from rest" : "the paper's crawler, from rest", true,
              words_verdict(opposed && arb_is_positive(sum), opposed && arb_is_negative(sum)), measured, reason);
  scallop_certified_phase_clear(&p);
  arb_clear(v1);
  arb_clear(v2);
  arb_clear(sum);
}

/* Without the last interval, the friction of the first one acting to the end, the centre would come as far as (21) has it. */
static void last_interval_row(const struct words *w, const struct words_claim *claim)
{
  char measured[MEASURED], reason[REASON];
  struct scallop_certified_phase p;
  struct scallop_crawler c = words_paper_crawler(w);
  double tau = scallop_phase_duration(&c, SCALLOP_EXTENSION);
  arb_t without;
  arb_init(without);
  scallop_certified_phase_init(&p);
  bool solved = proven_phase(&p, &c, SCALLOP_EXTENSION, 0) && p.switches;
  arb_set_d(without, (c.F1 - c.F2) * tau * tau / 4); /* M = 2, m1 = m2 */
  bool carries = arb_gt(p.dxC, without), brakes = arb_lt(p.dxC, without);
  snprintf(measured, sizeof measured,
           "certified: dx_C/L = %.9f; with the friction of the first interval to the end it would be %.9f",
           proven_over(p.dxC, c.L), proven_over(without, c.L));
  crawler_command(reason, REASON, "dxC is below (F1-F2) 0.75^2/(2M) = 0.421875: ", "phase --certified", &c, " | cut -f 16");
  words_enter(w, claim, "the paper's crawler, an extension from rest", true,
              words_verdict(solved && carries, solved && brakes), measured, reason);
  scallop_certified_phase_clear(&p);
  arb_clear(without);
}

/* ---- the contraction against the extension ---- */

static void opposite_row(const struct words *w, const struct words_claim *claim)
{
  char measured[MEASURED], reason[REASON];
  struct scallop_certified_phase e, c;
  struct scallop_crawler crawler = words_paper_crawler(w);
  arb_t sum;
  arb_init(sum);
  crawler.alpha = 0.5;
  scallop_certified_phase_init(&e);
  scallop_certified_phase_init(&c);
  bool solved = proven_phase(&e, &crawler, SCALLOP_EXTENSION, 1) && proven_phase(&c, &crawler, SCALLOP_CONTRACTION, 1);
  arb_add(sum, e.v_end, c.v_end, PROVEN_BITS);
  arb_sub_ui(sum, sum, 2, PROVEN_BITS);
  snprintf(measured, sizeof measured,
           "certified: the velocity changes by %.6f in the extension and by %.6f in the contraction",
           proven_middle(e.v_end) - 1, proven_middle(c.v_end) - 1);
  crawler_command(reason, REASON, "for p in extension contraction; do ", "phase --v0 1", &crawler,
                  " --phase $p | tail -n 1 | cut -f 10,13; done");
  words_enter(w, claim, "the paper's crawler, alpha = 1/2, from v0 = 1", true,
              words_verdict(solved && arb_contains_zero(sum), solved && arb_is_nonzero(sum)), measured, reason);
  scallop_certified_phase_clear(&e);
  scallop_certified_phase_clear(&c);
  arb_clear(sum);
}

static const char forward[] = "centre_moves_forward_in_an_extension";

const struct words_claim words_of_phases[] = {
  { "equal_forces_centre", "(8)", "dx_C", WORDS_EACH_GAIT, equal_centre_row, 0 },
  { "equal_forces_and_masses_keep_the_centre", "4.1", "dx_C", WORDS_EACH_GAIT, still_centre_row, 0 },
  { "velocity_rises_over_extension", "4.2", "v_end", WORDS_EACH_GAIT, falling_velocity_row, 0 },
  { forward, "4.3", "dx_C", WORDS_EACH_GAIT, heavy_front_row, 0 },
  { "centre_moves_backward_in_a_contraction", "4.3", "dx_C", WORDS_EACH_GAIT, steady_contraction_row, 0 },
  { "longer_extension_is_faster", "4.3", "l'", WORDS_EACH_GAIT, slower_row, 0 },
  { "first_interval_accelerates_l", "4.3.1", "l''", WORDS_EACH_GAIT, acceleration_row, 0 },
  { "body_1_is_slower_in_the_first_interval", "4.3.1", "v1, v2", WORDS_EACH_GAIT, slower_body_row, false },
  { "body_1_is_slower_in_the_first_interval", "4.3.1", "v1, v2", WORDS_EACH_GAIT, slower_body_row, true },
  { "last_interval_carries_the_centre_forward", "4.3.1, 5", "dx_C", WORDS_EACH_GAIT, last_interval_row, 0 },
  { "contraction_is_the_opposite_of_the_extension", "4.3.3", "v_end", WORDS_EACH_GAIT, opposite_row, 0 },
  { .claim = NULL }
};
