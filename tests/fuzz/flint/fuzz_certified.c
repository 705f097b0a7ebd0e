/* The two solvers against each other: doubles and ball arithmetic, for the same doubles. Coarse on purpose, 1e-9 of the
 * natural size of each result: tests/numerics/certified/test_agree.c counts ulps, this looks for the crawler where
 * one of them is lost. */
#include "tests/fuzz/crawler.h"
#include "tests/fuzz/target.h"
#include "tests/support/agree.h"

enum { DIGITS = 20 };
static const double COARSE = 1e-9;
static struct fuzz_case now;

/* Not judged: what jumps where a mode goes, and has two sides at rest */
static bool may_jump(int q, const struct ball_answer *exact, bool same)
{
  const arb_struct *start = exact->value[Q_V_START], *mid = exact->value[Q_V_MID];
  return q == Q_T1 || q == Q_DT || (q == Q_MULTIPLIER && (!same || arb_is_zero(start) || arb_is_zero(mid)));
}

static void judge(const struct motion *m, const struct unit *unit)
{
  struct answer got;
  SCOPED(ball_answer, exact);
  bool solved = answer_in_double(&got, m), certified = answer_of_doubles(&exact, m, DIGITS);
  if (!solved || !(certified || exact.status == SCALLOP_EUNDECIDED))
    fuzz_fail("status %d, certified %d, for %s", (int)got.status, (int)exact.status, fuzz_describe(&now));
  bool same = certified && same_modes(got.modes, exact.modes);
  for (int q = quantity_first(m->of); certified && q < (int)quantity_end(m->of); q++) {
    if (!exact.value[q] || may_jump(q, &exact, same))
      continue;
    double natural = q == Q_MEAN_VELOCITY ? unit->length / unit->time : unit_of_quantity(unit, q, got.value[q].high);
    if (!(off_by(&got.value[q], exact.value[q]) <= COARSE * natural))
      fuzz_fail("%s is %.17g, certified %.17g, for %s", quantity_rows[q].name, got.value[q].high,
                middle(exact.value[q]), fuzz_describe(&now));
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  now = fuzz_case_of(data, size);
  const struct scallop_crawler *c = &now.crawler;
  if (now.wildness == RAW || c->gait == &sawtooth_gait)
    return 0; /* fractions of thousands of digits; and a gait without a certified steady state */
  const struct motion steady = steady_motion(c);
  judge(&steady, &(struct unit){ c->L / c->T / fmin(c->alpha, 1 - c->alpha), c->L, c->T, 1 });
  for (int kind = 0; kind < 2; kind++) {
    const struct motion m = phase_motion(c, (enum scallop_phase_kind)kind, now.v0);
    double tau = scallop_phase_duration(c, m.phase), v = c->L / tau + fabs(now.v0);
    judge(&m, &(struct unit){ v, v * tau, tau, 1 });
  }
  return 0;
}
