/* The claims in words about every crawler: held against random ones, masses and forces within a factor of 10, 0.05 <
 * alpha < 0.95, Froude from 0.1. Those that hold have their proofs in docs/theory.md, The motion in words; here stands
 * how far each is from failing. */
#include <math.h>

#include "compare/claims/decide.h"
#include "compare/claims/evidence.h"

void rest_on_samples(struct question *q, int count)
{
  q->row.evidence = SAMPLED;
  q->row.sampled = count;
}

/* The counterexample as it is printed, with four digits, certified; or, if that is none, in doubles */
static void certify_rounded(struct question *q, arb_t excess)
{
  const struct scallop_crawler found = q->crawler;
  double *const numbers[] = { &q->crawler.m1, &q->crawler.m2, &q->crawler.F1,
                              &q->crawler.F2, &q->crawler.T,  &q->crawler.alpha };
  for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
    *numbers[i] = short_number(*numbers[i], 4);
  solve_motions(q, true);
  if (judge(q, excess) < 0)
    return;
  q->crawler = found;
  solve_motions(q, false);
}

/* Where the claim is nearest to failing, or fails most, is the base crawler in the end; x1: for how many it is meant;
 * x2: for how many it holds. */
void at_random(struct question *q)
{
  struct scallop_crawler c[RANDOM_CRAWLERS];
  int meant = 0, held = 0, failed = 0, worst = 0, count = random_crawlers(c, RANDOM_CRAWLERS, q->crawler.gait);
  double most = -INFINITY;
  arb_t x;
  arb_init(x);
  for (int i = 0; i < count; i++) {
    q->crawler = c[i];
    solve_motions(q, false);
    if (q->solved && q->claim->needs && !(number_of(q, q->claim->needs) > 0))
      continue;
    int holds = judge(q, x);
    meant++;
    held += holds > 0;
    failed += holds < 0;
    if (middle(x) > most) {
      most = middle(x);
      worst = i;
    }
  }
  q->crawler = c[worst];
  q->found[0] = meant;
  q->found[1] = held;
  if (failed > 0)
    certify_rounded(q, x);
  else {
    solve_motions(q, false);
    rest_on_samples(q, meant);
  }
  settle(q, held > 0 && held == meant, failed > 0);
  arb_clear(x);
}

/* x1: how far the velocity is from the steady one, over L/T, once it is within 1e-6 or after 20000 periods from rest */
static void settles(struct question *q)
{
  struct scallop_crawler c[RANDOM_CRAWLERS];
  int count = random_crawlers(c, RANDOM_CRAWLERS, q->crawler.gait);
  q->found[0] = count > 0 ? 0 : NAN;
  for (int i = 0; i < count; i++) {
    double v = steady_state(&c[i]).period.v_start, unit = c[i].L / c[i].T;
    struct scallop_period_result p = { .v_end = 0 };
    for (int n = 0; n < 20000 && fabs(p.v_end - v) > 1e-6 * unit; n++)
      p.v_end = scallop_period(&c[i], p.v_end, &p) < 0 ? NAN : p.v_end;
    double far = fabs(p.v_end - v) / unit;
    q->found[0] = far <= q->found[0] ? q->found[0] : far;
  }
  rest_on_samples(q, count);
  conclude(q);
}

#define SET "400 quasi-random crawlers, masses and forces within 100:1"
#define STRONGER_FIRST " F1=max(F1,F2) F2=min(F1,F2)"
static const char whole_set[] = SET ", sliding to stick-slip",
                  from_rest[] = SET ", F1 > F2, from rest, those that slide";
static const char still[] = "largest |displacement|/L: {+below}{-above} 1e-14",
                  faster[] = SET ", v0 = alpha/10 L over the duration";
static const char from_rest_and_moving[] = "extension; extension v0=0.1*L/T",
                  forward[] = "longer_extension_moves_forward";
static const char backward[] = "displacement/L*(1 - 2*stronger_1)*(2*longer - 1) <= 1e-14";
static const char most_backward[] =
    "largest displacement/L against the sign of (F1-F2)(2 alpha-1): {+0}{-{3g displacement/"
    "L*(1 - 2*stronger_1)*(2*longer - 1)}}";
static const char where[] =
    "scallop steady --m1 {4g m1} --m2 {4g m2} --F1 {4g F1} --F2 {4g F2} --L 1 --T {4g T} --alpha {4g "
    "alpha} --gait {gait}";

const struct claim claims_at_random[] = {
  { "equal_forces_do_not_move", "4.1", "displacement", at_random, whole_set, "steady F2=F1",
    .says = "abs(displacement) <= 1e-14", .proven = true, .measured = still },
  { "symmetric_timing_does_not_move", "4.2", "displacement", at_random, whole_set, "steady alpha=0.5",
    .says = "abs(displacement) <= 1e-14", .proven = true, .measured = still },
  { "steady_state_attracts", "4.3.2", "multiplier", at_random, whole_set, "steady", .says = "multiplier < 1",
    .measured = "largest multiplier of the period map: {4f multiplier}" },
  { "motion_always_settles", "5", "v", settles, whole_set, NULL, .says = "x1 <= 1e-6",
    .measured = "largest |v - v_start| T/L after at most 20000 periods from rest: {+below}{-above} 1e-6" },
  { forward, "4.4", "displacement", at_random, "400 quasi-random crawlers: those that slide", "steady",
    .needs = "sliding", .says = backward, .measured = most_backward, .reason = where },
  { forward, "4.4", "displacement", at_random, "400 quasi-random crawlers: those in stick-slip", "steady",
    .needs = "1 - sliding", .says = backward, .measured = most_backward, .reason = where, .outside = true },
  { "one_body_always_moves", "2", "modes", at_random, whole_set, "steady", .says = "sticks_both = 0", .proven = true,
    .measured = "x2' - x1' = l'; both bodies at rest at once in a steady state: {+never}{-for one at least}" },
  { "which_body_is_1_does_not_matter", "2", "displacement", at_random, SET "; m1 and m2, F1 and F2 exchanged",
    "steady; steady m1=m2 m2=m1 F1=F2 F2=F1", .says = "abs(displacement + displacement:2) <= 1e-14", .proven = true,
    .measured = "displacement of one plus that of the other, over L: {+below}{-above} 1e-14" },
  { "equal_forces_bodies_oppose", "(6), (7)", "modes", at_random, SET "; F2 = F1", "steady F2=F1",
    .says = "1 - oppose + abs(v_start)*T/L <= 1e-14", .proven = true,
    .measured =
        "{+the modes are -+ | +- and |v_start| T/L is below 1e-14}{-other modes, or |v_start| T/L above 1e-14}" },
  { "velocity_rises_over_extension", "4.2", "v_mid", at_random, SET ", F1 > F2, the steady states that slide",
    "steady" STRONGER_FIRST, .needs = "sliding*(F1 - F2)", .says = "v_start <= v_mid", .proven = true,
    .measured = "{+v_mid >= v_start for all}{-v_mid < v_start for one at least} ({0f x1} crawlers)" },
  { "symmetric_timing_starts_backward", "4.2", "v_start", at_random, SET "; alpha = 1/2", "steady alpha=0.5",
    .says = "max(abs(v_start + v_mid), v_start*(2*stronger_1 - 1))*T/L <= 1e-14", .proven = true,
    .measured = "{+v_start = -v_mid to 1e-14 L/T, and never}{-v_start is not -v_mid, or} on the side of F1 - F2" },
  { "centre_moves_forward_in_an_extension", "4.3", "dx_C", at_random, SET ", F1 > F2, m1 = m2, from rest",
    "extension m2=m1" STRONGER_FIRST, .needs = "F1 - F2", .says = "dxC > 0", .proven = true,
    .measured = "{+dx_C > 0 for all}{-dx_C < 0 for one at least} ({0f x1} crawlers)" },
  { "extension_from_rest_has_two_intervals", "4.3.1", "modes", at_random, from_rest, "extension" STRONGER_FIRST,
    .needs = "sliding*(F1 - F2)", .says = "turns_once = 1", .proven = true,
    .measured = "{+the modes are -+ ++ for all}{-other modes for one at least} ({0f x1} crawlers)" },
  { "first_interval_is_the_greater_part", "4.3.1", "dT", at_random, from_rest, "extension" STRONGER_FIRST,
    .needs = "sliding*(F1 - F2)", .says = "dT <= duration/2", .proven = true,
    .measured =
        "dT is {+at most half of the duration for all}{-more than half of the duration for one at least} ({0f x1} "
        "crawlers)" },
  { "last_interval_grows_with_duration", "4.3.1", "dT", at_random, from_rest,
    "extension" STRONGER_FIRST "; extension" STRONGER_FIRST " T=1.01*T", .needs = "sliding*sliding:2*(F1 - F2)",
    .says = "dT <= dT:2", .proven = true,
    .measured = "dT {+does not shrink with the duration for any, here}{-shrinks for one at least, the duration "
                "growing} by 1 % ({0f x1} crawlers)" },
  { "start_velocity_adds_displacement", "4.3.2", "dx_C", at_random, faster, from_rest_and_moving,
    .says = "dxC <= dxC:2", .proven = true,
    .measured = "dx_C is {+not smaller than from rest for any}{-smaller than from rest for one at least}" },
  { "start_velocity_takes_velocity_change", "4.3.2", "v_end", at_random, faster, from_rest_and_moving,
    .says = "v_end:2 - v0:2 <= v_end", .proven = true,
    .measured = "v_end - v0 is {+not larger than from rest for any}{-larger than from rest for one at least}" },
  { "start_velocity_is_forward_at_high_Froude", "5", "v_start", at_random, SET ", Froude number 1e8",
    "steady T=1e-4*sqrt((m1+m2)/(F1+F2)*L)", .says = "0 <= v_start*displacement",
    .measured = "v_start against the displacement: {+never}{-for one at least}" },
  { .name = NULL },
};
