/* What must hold of the derived expansions whatever the motion is: they do not depend on how far one looks, on units,
 * on the names of the bodies or on the direction of space, and time reversal leaves its mark. */
#include "tests/support/expansions.h"

TEST(few_terms_and_many)
{
  struct random r = { 20260831 };
  SCOPED(pair, p);
  for (int i = 0; i < check_cases(6 * GAITS); i++) {
    draw(&p, &r, gaits[i % GAITS]);
    for (int kind = 0; kind < 2 && i % GAITS < WITH_SERIES_OF_PHASES; kind++) {
      assert_true(expand_phase(&p.phase[0], &p.crawler[0], kind, p.v0[0], 6));
      assert_true(expand_phase(&p.phase[1], &p.crawler[0], kind, p.v0[0], 30));
      for (int q = 0; q < PHASE; q++)
        check_equal(phase_series(&p.phase[0], q), phase_series(&p.phase[1], q), 1, 6, "6 and 30 terms of a phase");
    }
    assert_true(expand_steady(&p.steady[0], &p.crawler[0], 6));
    assert_true(expand_steady(&p.steady[1], &p.crawler[0], 30));
    for (int q = 0; q < STEADY; q++)
      check_equal(steady_series(&p.steady[0], q), steady_series(&p.steady[1], q), 1, 6, "6 and 30 terms");
  }
}

/* Every number of terms gives that many. */
TEST(every_order)
{
  struct random r = { 20260832 };
  SCOPED(pair, p);
  for (int i = 0; i < WITH_SERIES_OF_PHASES; i++) {
    draw(&p, &r, gaits[i]);
    fmpq_set_si(p.v0[0], 3, 2);
    assert_true(expand_phase(&p.phase[1], &p.crawler[0], 0, p.v0[0], ORDER));
    assert_true(expand_steady(&p.steady[1], &p.crawler[0], ORDER));
    for (slong order = 1; order < ORDER; order++) {
      assert_true(expand_phase(&p.phase[0], &p.crawler[0], 0, p.v0[0], order));
      assert_true(expand_steady(&p.steady[0], &p.crawler[0], order));
      for (int q = 0; q < PHASE; q++)
        check_equal(phase_series(&p.phase[0], q), phase_series(&p.phase[1], q), 1, order, "order of a phase");
      for (int q = 0; q < STEADY; q++)
        check_equal(steady_series(&p.steady[0], q), steady_series(&p.steady[1], q), 1, order, "order");
    }
  }
}

/* Units of mass, length and force such that the unit of time is a fraction. */
static void change_units(struct pair *p, fmpq_t length, fmpq_t time, struct random *r)
{
  struct scallop_rational_crawler *c = &p->crawler[1];
  SCOPED(fmpq, mass, force);
  random_positive(length, r);
  random_positive(time, r);
  random_positive(mass, r);
  fmpq_mul(force, mass, length);
  fmpq_div(force, force, time);
  fmpq_div(force, force, time);
  fmpq_mul(c->m1, c->m1, mass);
  fmpq_mul(c->m2, c->m2, mass);
  fmpq_mul(c->F1, c->F1, force);
  fmpq_mul(c->F2, c->F2, force);
  fmpq_mul(c->L, c->L, length);
  fmpq_mul(p->v0[1], p->v0[1], length);
  fmpq_div(p->v0[1], p->v0[1], time);
}

TEST(units)
{
  struct random r = { 20260833 };
  SCOPED(pair, p);
  SCOPED(fmpq, length, time, factor, per_time);
  for (int i = 0; i < 6 * WITH_SERIES_OF_PHASES; i++) {
    draw(&p, &r, gaits[i % WITH_SERIES_OF_PHASES]);
    change_units(&p, length, time, &r);
    fmpq_inv(per_time, time);
    for (int kind = 0; kind < 2; kind++) {
      for (int k = 0; k < 2; k++)
        assert_true(expand_phase(&p.phase[k], &p.crawler[k], kind, p.v0[k], ORDER));
      for (int q = 0; q < PHASE; q++) {
        fmpq_pow_si(factor, time, phase_time[q]);
        if (phase_length[q] == 1 || phase_time[q] < 0)
          fmpq_mul(factor, factor, length);
        check_scaled(phase_series(&p.phase[0], q), phase_series(&p.phase[1], q), factor, per_time, ORDER,
                     "units of a phase");
      }
    }
    for (int k = 0; k < 2; k++)
      assert_true(expand_steady(&p.steady[k], &p.crawler[k], ORDER));
    for (int q = 0; q < STEADY; q++) {
      fmpq_set(factor, length);
      if (q < 2)
        fmpq_div(factor, factor, time);
      check_scaled(steady_series(&p.steady[0], q), steady_series(&p.steady[1], q), factor, per_time, ORDER, "units");
    }
  }
}

static void exchange_bodies(struct scallop_rational_crawler *c)
{
  fmpq_swap(c->m1, c->m2);
  fmpq_swap(c->F1, c->F2);
}

/* A contraction is an extension with the bodies exchanged, if the gait goes back as it came. */
TEST(contraction_is_an_extension_exchanged)
{
  struct random r = { 20260834 };
  static const int partner[PHASE] = { 0, 2, 1, 3, 4, 5, 6, 7 };
  SCOPED(pair, p);
  for (int i = 0; i < 6 * WITH_SERIES_OF_PHASES; i++) {
    draw(&p, &r, gaits[i % WITH_SERIES_OF_PHASES]);
    exchange_bodies(&p.crawler[1]);
    for (int kind = 0; kind < 2; kind++) {
      assert_true(expand_phase(&p.phase[0], &p.crawler[0], kind, p.v0[0], ORDER));
      assert_true(expand_phase(&p.phase[1], &p.crawler[1], 1 - kind, p.v0[0], ORDER));
      for (int q = 0; q < PHASE; q++)
        check_equal(phase_series(&p.phase[0], q), phase_series(&p.phase[1], partner[q]), 1, ORDER, "exchanged phases");
    }
    fmpq_neg(p.crawler[1].alpha, p.crawler[1].alpha);
    fmpq_add_si(p.crawler[1].alpha, p.crawler[1].alpha, 1);
    for (int k = 0; k < 2; k++)
      assert_true(expand_steady(&p.steady[k], &p.crawler[k], ORDER));
    check_equal(&p.steady[0].v_mid, &p.steady[1].v_start, 1, ORDER, "exchanged phases: v_mid");
    check_equal(&p.steady[0].v_start, &p.steady[1].v_mid, 1, ORDER, "exchanged phases: v_start");
    check_equal(&p.steady[0].displacement, &p.steady[1].displacement, 1, ORDER, "exchanged phases: displacement");
  }
}

/* In a mirror the bodies change places and velocities their signs. */
TEST(mirrored)
{
  struct random r = { 20260835 };
  static const int partner[PHASE] = {
    0, 2, 1, 3, 4, 5, -1, -1
  }; /* at_first, at_last: of the rear body, the front one there */
  SCOPED(pair, p);
  for (int i = 0; i < check_cases(6 * GAITS); i++) {
    draw(&p, &r, gaits[i % GAITS]);
    exchange_bodies(&p.crawler[1]);
    fmpq_neg(p.v0[1], p.v0[0]);
    for (int kind = 0; kind < 2 && i % GAITS < WITH_SERIES_OF_PHASES; kind++) {
      for (int k = 0; k < 2; k++)
        assert_true(expand_phase(&p.phase[k], &p.crawler[k], kind, p.v0[k], ORDER));
      for (int q = 0; q < PHASE; q++)
        if (partner[q] >= 0)
          check_equal(phase_series(&p.phase[0], q), phase_series(&p.phase[1], partner[q]), q < 4 ? -1 : 1, ORDER,
                      "mirrored");
    }
    for (int k = 0; k < 2; k++)
      assert_true(expand_steady(&p.steady[k], &p.crawler[k], ORDER));
    for (int q = 0; q < STEADY; q++)
      check_equal(steady_series(&p.steady[0], q), steady_series(&p.steady[1], q), -1, ORDER, "mirrored steady state");
  }
}

/* Backward in time friction drives: eps becomes -eps, T becomes i T, and the steady motion is that of the exchanged
 * phases. So for a gait that looks the same backward v_mid has the coefficients of v_start with alternating signs, and
 * the displacement has powers of T^4 only. For the trapezoid neither holds. */
TEST(reversed_in_time)
{
  struct random r = { 20260836 };
  int differ = 0, others = 0;
  SCOPED(scallop_rational, c);
  SCOPED(scallop_expansion, e);
  SCOPED(series, mid);
  for (int i = 0; i < 10 * WITH_SERIES_OF_PHASES; i++) { /* the trapezoid comes last */
    bool reversible = i / 10 < REVERSIBLE;
    random_exact_crawler(&c, &r, gaits[i / 10]);
    if (!expand_steady(&e, &c, 2 * ORDER)) {
      assert_false(reversible); /* a range of trapezoids has no series: test_derived.c */
      continue;
    }
    for (slong k = 0; 2 * k - 1 < 2 * ORDER; k++) {
      series_neg(&mid, &e.v_mid);
      differ += !same_coefficient(k % 2 ? &mid : &e.v_mid, &e.v_start, 2 * k - 1, PRECISION);
      others += k % 2 && !series_coefficient_is_zero(&e.displacement, 2 * k);
      assert_true(series_coefficient_is_zero(&e.v_start, 2 * k) && series_coefficient_is_zero(&e.v_mid, 2 * k));
      assert_true(series_coefficient_is_zero(&e.displacement, 2 * k + 1));
    }
    if (reversible && differ + others > 0) {
      print_error("%d coefficients of v_mid differ, %d of the displacement are there\n", differ, others);
      print_exact_crawler(&c);
      fail();
    }
  }
  assert_true(differ > 0 && others > 0);
}
