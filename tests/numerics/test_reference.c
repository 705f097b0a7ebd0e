/* The exact solver against 50-digit values (tests/support/reference.tsv, made by scripts/python/reference.py).
 *
 * The bound: BOUND ulp times the larger of the result and its absolute condition number (sum over the inputs p of |p
 * dq/dp|, in the table). For nearly equal forces and nearly symmetric timing the displacement is also held to 1e-15 L.
 * The largest error of each number is printed, in those ulp. */
#include <float.h>

#include "tests/support/reference.h"

enum { BOUND = 8, QUANTITIES = 7 };
static const char *const quantities[QUANTITIES] = { "t1", "dT", "v_end", "dxC", "v_start", "v_mid", "displacement" };
static double worst[QUANTITIES];

static void compare(const struct row *r, int q, double got)
{
  const char *quantity = quantities[q];
  double wanted = number_in(r, "", quantity), L = number_in(r, "", "L");
  double tolerance = BOUND * DBL_EPSILON * fmax(fabs(wanted), number_in(r, "cond_", quantity));
  if (strstr(cell(r, "", "family"), "near") && strcmp(quantity, "displacement") == 0)
    tolerance = fmin(tolerance, 1e-15 * L);
  if (tolerance > 0)
    worst[q] = fmax(worst[q], fabs(got - wanted) / tolerance);
  if (check_near(got, wanted, tolerance))
    return;
  for (int i = 0; i < 12; i++)
    print_error(" %s=%s", reference_header.cell[i], r->cell[i]);
  check_fail(quantity, got, wanted, tolerance, "absolute", __FILE__, __LINE__);
}

static void check_row(const struct row *r)
{
  struct scallop_crawler c = { .gait = scallop_gait_named(cell(r, "", "gait")) };
  static const char *const names[PARAMETERS] = { "m1", "m2", "F1", "F2", "L", "T", "alpha" };
  char both[BOTH_MODES_TEXT];
  for (int i = 0; i < PARAMETERS; i++)
    *parameter(&c, i) = number_in(r, "", names[i]);
  if (of_steady_state(r)) {
    struct scallop_period_result p = steady_of(&c).period;
    compare(r, 4, p.v_start);
    compare(r, 5, p.v_mid);
    compare(r, 6, p.displacement);
    assert_string_equal(both_modes(p.modes, both), cell(r, "", "modes"));
    return;
  }
  struct scallop_phase_result p = phase_of(&c, phase_in(r), number_in(r, "", "v0"));
  compare(r, 0, p.t1);
  compare(r, 1, p.dT);
  compare(r, 2, p.v_end);
  compare(r, 3, p.dxC);
  modes_are(&p.modes, cell(r, "", "modes"));
}

TEST(every_row)
{
  for_reference_rows(check_row);
  for (int q = 0; q < QUANTITIES; q++)
    print_message("%-13s worst %.1f ulp\n", quantities[q], BOUND * worst[q]);
}
