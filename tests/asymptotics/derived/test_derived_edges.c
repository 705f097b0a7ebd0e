/* Derived expansions: pi^2 and a fraction in its place, and what is refused, and how. */
#include "tests/support/expansions.h"
#include "tests/support/solved.h"

/* A fraction so close to pi^2 that only the last bits notice */
static void nearly_pi_squared(fmpq_t q)
{
  SCOPED(arb, pi);
  arb_const_pi(pi, 2 * PRECISION);
  arb_mul(pi, pi, pi, 2 * PRECISION);
  arf_get_fmpq(q, arb_midref(pi));
}

TEST(pi_squared_as_a_fraction)
{
  struct random r = { 20260837 };
  SCOPED(pair, p);
  SCOPED(fmpq, pi_squared);
  SCOPED(arb, x, y);
  nearly_pi_squared(pi_squared);
  for (int i = 0; i < 20; i++) {
    enum scallop_phase_kind kind = i % 2 ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION;
    draw(&p, &r, &scallop_gait_sinusoidal);
    assert_true(expand_phase(&p.phase[0], &p.crawler[0], kind, p.v0[0], ORDER));
    assert_int_equal(
        scallop_expand_phase(&p.crawler[0], kind, p.v0[0], ORDER, PRECISION, pi_squared, &p.phase[1], NULL),
        SCALLOP_OK);
    assert_string_equal(p.phase[0].modes, p.phase[1].modes);
    for (int q = 0; q < PHASE; q++) {
      assert_int_equal(phase_series(&p.phase[1], q)->kind, SERIES_FRACTIONS);
      for (slong k = 0; k < ORDER; k++) {
        series_coefficient(x, phase_series(&p.phase[0], q), k, PRECISION);
        series_coefficient(y, phase_series(&p.phase[1], q), k, PRECISION);
        arb_sub(x, x, y, PRECISION);
        CHECK_AT_MOST(at_most(x), 1e-90 * (1 + at_most(y)));
        assert_int_equal(series_coefficient_is_zero(phase_series(&p.phase[0], q), k), arb_is_zero(y));
      }
    }
  }
}

static void refuses_phase(struct pair *p, slong order, slong precision, const char *fragment)
{
  const char *why = NULL;
  enum scallop_status status = scallop_expand_phase(&p->crawler[1], SCALLOP_EXTENSION, p->v0[0], order, precision, NULL,
                                                    &p->phase[0], &why);
  assert_int_equal(status, SCALLOP_EDOMAIN);
  assert_non_null(why);
  assert_non_null(strstr(why, fragment));
  assert_int_equal(
      scallop_expand_phase(&p->crawler[1], SCALLOP_EXTENSION, p->v0[0], order, precision, NULL, &p->phase[0], NULL),
      status);
  assert_string_equal(p->phase[0].modes, p->phase[1].modes);
  assert_int_equal(p->phase[0].switches, p->phase[1].switches);
  for (int q = 0; q < PHASE; q++)
    check_equal(phase_series(&p->phase[0], q), phase_series(&p->phase[1], q), 1, ORDER, "a refused phase");
}

static void refuses_steady(struct pair *p, slong order, slong precision, enum scallop_status wanted,
                           const char *fragment)
{
  const char *why = NULL;
  assert_int_equal(scallop_expand_steady(&p->crawler[1], order, precision, &p->steady[0], &why), wanted);
  assert_non_null(why);
  assert_non_null(strstr(why, fragment));
  assert_int_equal(scallop_expand_steady(&p->crawler[1], order, precision, &p->steady[0], NULL), wanted);
  assert_string_equal(p->steady[0].modes, p->steady[1].modes);
  for (int q = 0; q < STEADY; q++)
    check_equal(steady_series(&p->steady[0], q), steady_series(&p->steady[1], q), 1, ORDER, "a refused steady state");
}

TEST(refusals)
{
  static const slong orders[] = { 0, -1, SCALLOP_MOST_TERMS + 1, WORD_MAX };
  struct random r = { 20260838 };
  SCOPED(pair, p);
  draw(&p, &r, &scallop_gait_quadratic);
  fmpq_set_si(p.v0[0], 2, 1);
  for (int k = 0; k < 2; k++) {
    assert_true(expand_phase(&p.phase[k], &p.crawler[0], SCALLOP_EXTENSION, p.v0[0], ORDER));
    assert_true(expand_steady(&p.steady[k], &p.crawler[0], ORDER));
  }
  for (size_t i = 0; i < sizeof orders / sizeof *orders; i++) {
    refuses_phase(&p, orders[i], PRECISION, "order");
    refuses_steady(&p, orders[i], PRECISION, SCALLOP_EDOMAIN, "order");
  }
  refuses_phase(&p, 4, 0, "bits");
  refuses_steady(&p, 4, 0, SCALLOP_EDOMAIN, "bits");
  fmpq *const fields[] = { p.crawler[1].m1, p.crawler[1].F2, p.crawler[1].L, p.crawler[1].alpha };
  for (size_t i = 0; i < sizeof fields / sizeof *fields; i++) {
    fmpq_neg(fields[i], fields[i]);
    refuses_phase(&p, 4, PRECISION, "domain");
    refuses_steady(&p, 4, PRECISION, SCALLOP_EDOMAIN, "domain");
    fmpq_neg(fields[i], fields[i]);
  }
  p.crawler[1].gait = &minimum_jerk_gait; /* l'' = 0 at the ends of its phases */
  refuses_phase(&p, 4, PRECISION, "l'' = 0");
  fmpq_set_si(p.crawler[1].alpha, 1, 2);
  refuses_steady(&p, 4, PRECISION, SCALLOP_EDOMAIN, "l'' = 0");
  p.crawler[1].gait = &sawtooth_gait;
  refuses_steady(&p, 4, PRECISION, SCALLOP_EDOMAIN, "jumps");
  fmpq_set_si(p.crawler[1].alpha, 2, 3);
  refuses_steady(&p, 4, PRECISION, SCALLOP_EUNDECIDED, "");
}

/* At m1 = 0.08627301503..., otherwise the default crawler, body 2 ceases to turn in the contraction as T -> 0. Near
 * that, above it, the limit is either refused or the one with the right modes: an extrapolation from the other side
 * would be smooth and wrong. */
TEST(limit_near_a_touch)
{
  struct scallop_crawler defaults = with_gait(&scallop_gait_sinusoidal);
  static const char *const masses[] = {
    "0.0863", "0.0862731", "0.086273115", "0.0862730151", "0.08627301504", "0.0862"
  };
  int refused = 0;
  SCOPED(scallop_expansion, e);
  SCOPED(scallop_rational, c);
  scallop_rational_of(&c, &defaults);
  for (size_t i = 0; i < sizeof masses / sizeof *masses; i++) {
    assert_true(scallop_rational_parse(c.m1, masses[i]));
    enum scallop_status status = scallop_expand_steady(&c, 4, PRECISION, &e, NULL);
    bool turns = fmpq_get_d(c.m1) > 0.08627301503417;
    assert_true(status == SCALLOP_OK || status == SCALLOP_EUNDECIDED);
    refused += status != SCALLOP_OK;
    if (status == SCALLOP_OK)
      assert_string_equal(e.modes, turns ? "++ -+ ++ | ++ +- ++" : "++ -+ ++ | ++");
  }
  assert_true(refused < (int)(sizeof masses / sizeof *masses));
}
