/* The exact solver against 50-digit values (tests/support/reference.tsv, made by scripts/python/reference.py).
 *
 * The bound: BOUND ulp times the larger of the result and its absolute condition number (sum over the
 * inputs p of |p dq/dp|, in the table). For nearly equal forces and nearly symmetric timing the
 * displacement is also held to 1e-15 L. The largest error seen is printed, in those ulp. */
#include <float.h>

#include "tests/support/reference.h"

enum { QUANTITIES = 7, BOUND = 8 };

static const char *const quantities[QUANTITIES] = { "t1", "dT", "v_end", "dxC", "v_start", "v_mid", "displacement" };

static struct {
  double worst;
  char where[200];
} worst[QUANTITIES];

static void compare(const struct row *r, int q, double got, double L)
{
  double wanted = number_in(r, "", quantities[q]), cond = number_in(r, "cond_", quantities[q]);
  const char *family = cell(r, "", "family");
  bool nearly = strstr(family, "near") != NULL && strcmp(quantities[q], "displacement") == 0;
  double tolerance = BOUND * DBL_EPSILON * fmax(fabs(wanted), cond);
  if (nearly)
    tolerance = fmin(tolerance, 1e-15 * L);
  if (isnan(wanted)) {
    CHECK_EQUAL(got, wanted);
    return;
  }
  double share = tolerance > 0 ? fabs(got - wanted) / tolerance : 0;
  if (share > worst[q].worst) {
    worst[q].worst = share;
    snprintf(worst[q].where, sizeof worst[q].where, "%s %s, off by %.2g of %.17g, cond %g", family, cell(r, "", "gait"),
             got - wanted, wanted, cond);
  }
  if (!check_near(got, wanted, tolerance)) {
    print_error("%s %s %s:", family, cell(r, "", "kind"), cell(r, "", "gait"));
    for (int i = 3; i < 12; i++)
      print_error(" %s=%s", reference_header.cell[i], r->cell[i]);
    print_error("\n%s: cond %g ", quantities[q], cond);
    check_fail(quantities[q], got, wanted, tolerance, "absolute", __FILE__, __LINE__);
  }
}

static void check_row(const struct row *r)
{
  const struct scallop_crawler c = { number_in(r, "", "m1"),    number_in(r, "", "m2"),
                                     number_in(r, "", "F1"),    number_in(r, "", "F2"),
                                     number_in(r, "", "L"),     number_in(r, "", "T"),
                                     number_in(r, "", "alpha"), scallop_gait_named(cell(r, "", "gait")) };
  if (of_steady_state(r)) {
    struct scallop_steady_result s = steady_of(&c);
    char both[BOTH_MODES_TEXT];
    compare(r, 4, s.period.v_start, c.L);
    compare(r, 5, s.period.v_mid, c.L);
    compare(r, 6, s.period.displacement, c.L);
    assert_string_equal(both_modes(s.period.modes, both), cell(r, "", "modes"));
    return;
  }
  struct scallop_phase_result p = phase_of(&c, phase_in(r), number_in(r, "", "v0"));
  compare(r, 0, p.t1, c.L);
  compare(r, 1, p.dT, c.L);
  compare(r, 2, p.v_end, c.L);
  compare(r, 3, p.dxC, c.L);
  modes_are(&p.modes, cell(r, "", "modes"));
}

TEST(every_row)
{
  for_reference_rows(check_row);
  for (int q = 0; q < QUANTITIES; q++)
    print_message("%-13s worst %.1f ulp: %s\n", quantities[q], BOUND * worst[q].worst, worst[q].where);
}
