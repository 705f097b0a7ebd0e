/* The two solvers against each other: doubles and ball arithmetic, for the same doubles. Coarse on purpose, 1e-9 of the
 * natural size of each result: tests/numerics/certified/test_agree.c counts ulps, this looks for the crawler where
 * one of them is lost. */
#include "tests/fuzz/crawler.h"
#include "tests/fuzz/target.h"
#include "tests/support/scoped.h"
#include "tests/support/solved.h"

enum { DIGITS = 20 };
static const double COARSE = 1e-9;
static struct fuzz_case now;

static void near(const char *what, double got, const arb_t ball, double natural)
{
  double wanted = middle(ball);
  if (!(fabs(got - wanted) <= COARSE * natural))
    fuzz_fail("%s is %.17g, certified %.17g, for %s", what, got, wanted, fuzz_describe(&now));
}

static void judge(const char *what, enum scallop_status status, enum scallop_status certified)
{
  bool known = certified == SCALLOP_OK || certified == SCALLOP_EUNDECIDED;
  if (status < 0 || !known)
    fuzz_fail("%s: status %d, certified %d, for %s", what, (int)status, (int)certified, fuzz_describe(&now));
}

static void judge_phase(const struct scallop_rational_crawler *exact, enum scallop_phase_kind kind)
{
  const struct scallop_crawler *c = &now.crawler;
  struct scallop_phase_result r;
  double tau = scallop_phase_duration(c, kind);
  double v = c->L / tau + fabs(now.v0);
  SCOPED(fmpq, v0);
  scallop_rational_set_double(v0, now.v0);
  SCOPED(scallop_certified_phase, certified);
  enum scallop_status status = scallop_certified_phase(exact, kind, v0, DIGITS, &certified, NULL);
  judge("phase", scallop_phase(c, kind, now.v0, &r), status);
  if (status == SCALLOP_OK) {
    near("v_end", r.v_end, certified.v_end, v);
    near("dx1", r.dx1, certified.dx1, v * tau);
    near("dx2", r.dx2, certified.dx2, v * tau);
    near("dxC", r.dxC, certified.dxC, v * tau);
  }
}

static void judge_steady(const struct scallop_rational_crawler *exact)
{
  const struct scallop_crawler *c = &now.crawler;
  struct scallop_steady_result r;
  double v = c->L / c->T / fmin(c->alpha, 1 - c->alpha);
  SCOPED(scallop_certified_steady, certified);
  enum scallop_status status = scallop_certified_steady(exact, DIGITS, &certified, NULL);
  judge("steady", scallop_steady(c, &r), status);
  if (status == SCALLOP_OK) {
    near("v_start", r.period.v_start, certified.v_start, v);
    near("v_mid", r.period.v_mid, certified.v_mid, v);
    near("displacement", r.period.displacement, certified.displacement, c->L);
    near("mean_velocity", r.mean_velocity, certified.mean_velocity, c->L / c->T);
    bool same = modes_alike(&r.period.modes[0], &certified.modes[0])
                && modes_alike(&r.period.modes[1], &certified.modes[1]);
    if (same && !arb_is_zero(certified.v_start) && !arb_is_zero(certified.v_mid))
      near("multiplier", r.period.multiplier, certified.multiplier,
           1); /* it jumps where a mode goes; at rest it has two sides */
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  now = fuzz_case_of(data, size);
  if (now.wildness == RAW || now.crawler.gait == &sawtooth_gait)
    return 0; /* fractions of thousands of digits; and a gait without a certified steady state */
  SCOPED(scallop_rational, exact);
  scallop_rational_of(&exact, &now.crawler);
  judge_steady(&exact);
  judge_phase(&exact, SCALLOP_EXTENSION);
  judge_phase(&exact, SCALLOP_CONTRACTION);
  return 0;
}
