/* The verdicts on orders, against what pencil and paper give: they were derived by hand from the expansion of
 * the motion; the committed table is compared byte by byte elsewhere. */
#include "tests/support/claim_table.h"

static int begin(void **state) { return (void)state, fill(true); }

/* The order of the first term that a formula leaves out, where the paper's conditions hold. */
TEST(orders_inside)
{
  static const struct {
    const char *claim;
    double quadratic, sinusoidal;
    enum claim_verdict verdicts[2];
  } known[] = {
    { "eq14_dT", 5, 5, { CLAIM_HOLDS, CLAIM_HOLDS } },
    { "eq18_v_end", 3, 3, { CLAIM_HOLDS, CLAIM_HOLDS } },
    { "eq21_dxC", 6, 6, { CLAIM_SHARPER, CLAIM_SHARPER } },
    { "eq22_dv", 3, 3, { CLAIM_HOLDS, CLAIM_HOLDS } },
    { "eq23_dxC", 5, 5, { CLAIM_SHARPER, CLAIM_SHARPER } },
    { "eqA25_dxC", 3, 3, { CLAIM_REFUTED, CLAIM_REFUTED } },
    { "eqA6_t1", 6, 4, { CLAIM_HOLDS, CLAIM_REFUTED } },
    { "eqA16_dT", 5, 4, { CLAIM_HOLDS, CLAIM_REFUTED } },
    { "eqB12_v_end", 0, 0, { CLAIM_REFUTED, CLAIM_REFUTED } },
    { "eqB13_dxC", 5, 5, { CLAIM_SHARPER, CLAIM_SHARPER } },
    { "eq27_v_start", 1, -1, { CLAIM_HOLDS, CLAIM_REFUTED } },
    { "eq28_displacement", 4, 0, { CLAIM_HOLDS, CLAIM_REFUTED } },
  };
  for (size_t k = 0; k < sizeof known / sizeof *known; k++)
    for (int g = 0; g < 2; g++) {
      const struct claim_row *row = find(known[k].claim, g, "", INSIDE);
      print_message("%s %s: %.3f\n", row->claim, row->gait, row->fit.order);
      CHECK_NEAR(row->fit.order, g ? known[k].sinusoidal : known[k].quadratic, 1e-6);
      CHECK_EQUAL((double)row->derived_order, g ? known[k].sinusoidal : known[k].quadratic);
      assert_int_equal(row->verdict, known[k].verdicts[g]);
    }
}

/* What lines (A.4), (A.17) and (B.7) leave out of l' and l at t1, the first term: t1 = tau T^2, and l' = t l0/T^2 + t^3
 * k0/(6 T^4) + ... Their v0 is 0.37 sqrt(L (F1+F2)/M) to two digits. */
TEST(lines_with_given_times)
{
  double m1 = 1.7, m2 = 0.8, M = m1 + m2, L = 11.3, pi = 3.14159265358979324, v0 = 1.8;
  double l0 = pi * pi * L / 2, k0 = -pi * pi * pi * pi * L / 2;
  double of_1 = m2 / M * k0 / 6 * pow(v0 * M / (m2 * l0), 3), of_2 = m1 / M * k0 / 6 * pow(v0 * M / (m1 * l0), 3);
  const struct {
    const char *claim;
    long order;
    double coefficient;
  } known[] = { { "eqA4_v_first_switch", 2, -of_1 },
                { "eqA17_x1_switch_from_times", 3, of_1 },
                { "eqA17_x1_switch_collected", 3, of_1 },
                { "eqB7_x2_switch_from_times", 3, of_2 } };
  CHECK_NEAR(0.37 * sqrt(L * 5.4 / M), v0, 0.05);
  for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
    const struct claim_row *row = find(known[k].claim, 1, "", INSIDE);
    double coefficient;
    assert_int_equal(row->verdict, CLAIM_REFUTED);
    CHECK_EQUAL((double)row->derived_order, (double)known[k].order);
    assert_int_equal(sscanf(row->coefficient, "[%lf", &coefficient), 1);
    CHECK_RELATIVE(coefficient, known[k].coefficient, 1e-11);
    row = find(known[k].claim, 0, "", INSIDE);
    assert_true(row->exact && row->verdict == CLAIM_SHARPER);
  }
  const struct claim_row *row = find("eqB7_x2_switch_collected", 1, "", INSIDE);
  assert_int_equal(row->verdict, CLAIM_REFUTED);
  CHECK_EQUAL((double)row->derived_order, 2);
}

/* What is printed as an equality holds if nothing is left out, and is refuted by whatever is. */
TEST(equalities)
{
  static const struct {
    const char *claim;
    enum claim_verdict verdicts[2];
  } known[] = {
    { "eq6_v_end", { CLAIM_HOLDS, CLAIM_HOLDS } },        { "eq7_dx1", { CLAIM_HOLDS, CLAIM_HOLDS } },
    { "eq8_dxC", { CLAIM_REFUTED, CLAIM_REFUTED } },      { "corrected_equal_dxC", { CLAIM_HOLDS, CLAIM_HOLDS } },
    { "eqA13_v_switch", { CLAIM_HOLDS, CLAIM_REFUTED } }, { "eqA13_v_switch_from_v0", { CLAIM_HOLDS, CLAIM_REFUTED } }
  };
  for (size_t k = 0; k < sizeof known / sizeof *known; k++)
    for (int g = 0; g < 2; g++) {
      const struct claim_row *row = find(known[k].claim, g, "", INSIDE);
      assert_true(isinf(row->claimed_order));
      assert_int_equal(row->verdict, known[k].verdicts[g]);
      assert_int_equal(row->exact, row->verdict == CLAIM_HOLDS);
    }
}

/* Seen in a mirror these formulas are themselves, so that they leave out the same. */
TEST(mirrored_rows_are_about_the_motion_itself)
{
  static const char *const names[] = { "eq18_v_end", "eq21_dxC" };
  static const char *const conditions[] = { "extension from rest, F1 < F2", "contraction from rest, F2 < F1" };
  for (int i = 0; i < 8; i++) {
    int g = i >> 2;
    char mirrored[64];
    snprintf(mirrored, sizeof mirrored, "%s:mirrored", names[i & 1]);
    const struct claim_row *row = find(names[i & 1], g, conditions[i >> 1 & 1], OUTSIDE);
    const struct claim_row *seen = find(mirrored, g, conditions[i >> 1 & 1], OUTSIDE);
    assert_string_equal(seen->quantity, row->quantity);
    assert_string_equal(seen->coefficient, row->coefficient);
  }
}

/* For alpha < 1/2 and F1 > F2 the start velocity is negative, and with body names exchanged the appendices' result is
 * (F1-F2)(2 alpha-1) L m* / (alpha^2 F2 m2 + (1-alpha)^2 F1 m1): the published one is off at leading order. */
TEST(steady_outside)
{
  const struct claim_row *row = find("eq28_displacement", 0, "alpha < 1/2, F1 > F2", OUTSIDE);
  CHECK_NEAR(row->fit.order, 0, 1e-6);
  assert_int_equal(row->verdict, CLAIM_REFUTED);
  row = find("eq28_displacement", 0, "alpha < 1/2, F1 < F2", OUTSIDE);
  assert_int_equal(row->verdict, CLAIM_HOLDS);
  struct scallop_crawler c = { 1.7, 0.8, 4.1, 1.3, 11.3, 1e-7, 0.34, &scallop_gait_quadratic };
  struct scallop_steady_result s = steady_of(&c);
  double a = c.alpha, b = 1 - a, reduced = c.m1 * c.m2 / (c.m1 + c.m2);
  CHECK_RELATIVE(s.period.displacement,
                 (c.F1 - c.F2) * (2 * a - 1) * c.L * reduced / (a * a * c.F2 * c.m2 + b * b * c.F1 * c.m1), 1e-13);
}

/* The same crawler in other units of force and length: every verdict stays. */
TEST(units_do_not_matter)
{
  struct claim_table other = { .rows = NULL };
  struct scallop_crawler c = { 1.7, 0.8, 4.1e9, 1.3e9, 11.3e-3, 1, 0.66, &scallop_gait_quadratic };
  SCOPED(scallop_rational, exact);
  rational_crawler(&exact, &c);
  claim_table_add_orders(&other, &exact, NULL);
  claim_table_add_words(&other, &c);
  assert_string_equal(claims.contradiction, "");
  assert_string_equal(other.contradiction, "");
  for (int i = 0; i < other.count; i++) { /* the rows of the first gait come first */
    const struct claim_row *row = &claims.rows[i];
    if (strcmp(other.rows[i].claim, row->claim) != 0 || other.rows[i].verdict != row->verdict)
      fail_msg("%s %s, %s", row->claim, row->gait, row->conditions);
  }
  assert_true(other.count > 100);
  claim_table_free(&other);
}

int main(void) { return check_run(begin, empty); }
