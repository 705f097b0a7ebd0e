/* Verdicts on formulas of one's own, as `claims --formula` gives them: orders and coefficients derived by hand, or with
 * fractions apart from the toolkit. */
#include "tests/support/claim_table.h"

#include "compare/points/gaits.h"
#include "compare/formulas/formula_file.h"

/* The crawler of the table of claims, one with equal forces, and one with the larger friction at body 2 */
static const struct scallop_crawler usual = { 1.3, 0.9, 3.7, 1.1, 9.7, 1, 0.7, NULL };
static const struct scallop_crawler equal = { 1.3, 0.9, 1.1, 1.1, 9.7, 1, 0.7, NULL };
static const struct scallop_crawler weaker = { 1.3, 0.9, 1.1, 3.7, 9.7, 1, 0.7, NULL };

#define REST SCALLOP_AT_REST_START
#define MOVING SCALLOP_MOVING_EXTENSION
#define V_END SCALLOP_VELOCITY_AT_END
#define DISPLACEMENT SCALLOP_STEADY, SCALLOP_STEADY_DISPLACEMENT
#define CENTRE "(F1-F2)*T^2/(2*M)+L*(m1-m2)/2/M"

static const struct verdict {
  const char *text;
  enum scallop_setting setting;
  enum scallop_quantity quantity;
  int claimed;
  const char *gait;
  const struct scallop_crawler *crawler;
  enum claim_verdict verdict;
  long order; /* derived */
  const char *coefficient, *reason;
} verdicts[] = {
  /* A coefficient that depends on pi vanishes or does not, for certain. With the sinusoidal gait lT = -pi^2 L/2. */
  { "(F1 - F2)*T/M + pi*0*T", REST, V_END, 3, "sinusoidal", &usual, CLAIM_HOLDS, 3, NULL, NULL },
  { "(F1 - F2)*T/M - 4*F1*(F1-F2)/(m2*M*pi^2*L)*T^3", REST, V_END, 5, "sinusoidal", &usual, CLAIM_HOLDS, 5, NULL,
    NULL },
  { "(F1 - F2)*T/M + 4*F1*(F1-F2)/(m2*M*pi^2*L)*T^3", REST, V_END, 5, "sinusoidal", &usual, CLAIM_REFUTED, 3, NULL,
    "T^3" },
  { "(F1 - F2)*T/M + (pi - 355/113)*T", REST, V_END, 3, "sinusoidal", &usual, CLAIM_REFUTED, 1, NULL, NULL },
  { "(F1 - F2)*T/M/(pi + T)*(pi + T)", REST, V_END, 3, "quadratic", &usual, CLAIM_HOLDS, 3, NULL, NULL },
  { "(F1 - F2)*T/M + sin(pi)*T", REST, V_END, 3, "quadratic", &usual, CLAIM_UNDECIDED, 0, NULL, "T^1" },
  /* A number that a motion does not have makes a formula inapplicable: L_kin where l'' is the same at both ends, and
   * what belongs to a change of mode where there is none. */
  { "L_kin*m1*m2/M", DISPLACEMENT, 4, "minimum-jerk", &usual, CLAIM_UNDECIDED, 0, NULL, "L_kin does not exist" },
  { "0*L_kin", DISPLACEMENT, 4, "minimum-jerk", &usual, CLAIM_UNDECIDED, 0, NULL, "L_kin does not exist" },
  { "L_kin", DISPLACEMENT, 4, "constant:0", &usual, CLAIM_UNDECIDED, 0, NULL,
    "no expansion in powers of T is known for this motion: " },
  { "0", REST, SCALLOP_LAG, 2, "quadratic", &equal, CLAIM_UNDECIDED, 0, NULL, "no body turns" },
  { "T", REST, SCALLOP_FIRST_SWITCH, 2, "quadratic", &equal, CLAIM_UNDECIDED, 0, NULL, "no body turns" },
  { "T*dT", REST, V_END, 2, "quadratic", &equal, CLAIM_UNDECIDED, 0, NULL, "dT does not exist" },
  /* Errors of order 0 and below */
  { "(F1-F2)/M*T", MOVING, V_END, 2, "quadratic", &usual, CLAIM_REFUTED, 0, "17/10", NULL },
  { "v0 + (F1-F2)/M*T", MOVING, V_END, 2, "quadratic", &usual, CLAIM_HOLDS, 2, "-629/873", NULL },
  { "(F1-F2)/M*T + 1e-300*T^-10", REST, V_END, 3, "quadratic", &usual, CLAIM_REFUTED, -10, NULL,
    "at the T measured it goes as T^3" },
  { "(F1-F2)/M*T + 1/T^6", REST, V_END, 3, "quadratic", &usual, CLAIM_REFUTED, -6, "-1", NULL },
  { "v0 + 1/T^3", MOVING, V_END, 2, "quadratic", &usual, CLAIM_REFUTED, -3, "-1", NULL },
  /* Where l'' = 0 at the start friction holds a body until l'' exceeds it, for a time of the order of T^3. Coefficients
   * by hand, in fractions: t1 = T^3 (F1 - F2)/(24 m2 L) + ...: M eps beta = m2 l'' */
  { CENTRE, REST, SCALLOP_CENTRE_AT_END, 4, "polynomial:0,0,4,-3", &usual, CLAIM_HOLDS, 4, "-845/115236", NULL },
  { "0*T", REST, SCALLOP_FIRST_SWITCH, 3, "polynomial:0,0,4,-3", &usual, CLAIM_HOLDS, 3, "65/5238", NULL },
  { CENTRE, REST, SCALLOP_CENTRE_AT_END, 4, "polynomial:0,0,0,5,-4", &usual, CLAIM_UNDECIDED, 0, NULL,
    "fractional powers of T" },
  { CENTRE, REST, SCALLOP_CENTRE_AT_END, 4, "polynomial:0,-3,10,-6", &usual, CLAIM_UNDECIDED, 0, NULL,
    "no series is derived for that" },
  /* Powers beyond what errors in doubles show */
  { "T^60", REST, V_END, SCALLOP_EQUALITY, "quadratic", &equal, CLAIM_REFUTED, 60, "-1", NULL },
  { "T^60", REST, V_END, 60, "quadratic", &equal, CLAIM_HOLDS, 60, "-1", NULL },
  { "T^16", REST, V_END, 16, "quadratic", &equal, CLAIM_HOLDS, 16, "-1", NULL },
  { "0", REST, V_END, SCALLOP_EQUALITY, "quadratic", &equal, CLAIM_HOLDS, SERIES_ALL, NULL,
    "every coefficient vanishes" },
  /* What was looked at ends below the power that is claimed: beside 1/T^100 at T^-44, and of exp(T^30) at T^56. */
  { "T^-100 + (F1-F2)/M*T - T^-100 + T", REST, V_END, 3, "quadratic", &usual, CLAIM_UNDECIDED, -44, NULL,
    "below T^-44" },
  { "exp(T^30) - 1 - T^30", REST, V_END, 999, "quadratic", &equal, CLAIM_UNDECIDED, 56, NULL, "below T^56" },
  { "exp(T^30) - 1 - T^30", REST, V_END, 56, "quadratic", &equal, CLAIM_HOLDS, 56, NULL, NULL },
  { "exp(T^30) - 1 - T^30", REST, V_END, 55, "quadratic", &equal, CLAIM_SHARPER, 56, NULL, NULL },
  { "T + sin(T)*v0*T^-40", REST, V_END, 3, "sinusoidal", &usual, CLAIM_UNDECIDED, -17, NULL, "below T^-17" },
  { "T + sin(T)*v0*T^-40", REST, V_END, SCALLOP_EQUALITY, "sinusoidal", &usual, CLAIM_REFUTED, -17, NULL,
    "but the certified error is not 0" },
  { "T + sin(T)*v0*T^-12", REST, V_END, 3, "sinusoidal", &usual, CLAIM_REFUTED, 1, "2/11", NULL },
  /* A number that no fraction is, and a power beyond what is looked at, leave the coefficients below as exact as they
   * are. sqrt(2)*T^3: the coefficient by hand, -2405/9603 - sqrt(2) */
  { "(F1-F2)/M*T + T^998", REST, V_END, 3, "quadratic", &usual, CLAIM_HOLDS, 3, "-2405/9603", NULL },
  { "T^998 + (F1-F2)/M*T", REST, V_END, 2, "sinusoidal", &usual, CLAIM_SHARPER, 3, NULL, "T^3" },
  { "(F1-F2)/M*T + exp(1)*T^100", REST, V_END, 3, "polynomial:0,0,4,-3", &usual, CLAIM_HOLDS, 3, "-10465/115236",
    NULL },
  { "(F1-F2)/M*T + exp(1)*T^5", REST, V_END, 3, "quadratic", &usual, CLAIM_HOLDS, 3, NULL, NULL },
  { "(F1-F2)/M*T - sqrt(2)*T^2 + sqrt(2)*T^3", REST, V_END, 3, "quadratic", &usual, CLAIM_REFUTED, 2,
    "[1.41421356237 +/- 3.10e-12]", NULL },
  { "(F1-F2)/M*T + sqrt(2)*T^3", REST, V_END, 3, "quadratic", &usual, CLAIM_HOLDS, 3, "[-1.66465613240 +/- 3.30e-12]",
    NULL },
  { "(F1-F2)/M*T + sin(pi)*T + T^998", REST, V_END, 3, "quadratic", &usual, CLAIM_UNDECIDED, 0, NULL,
    "T^1 cannot be distinguished from 0" },
  { "v0 + k0*exp(1)*T^80", MOVING, SCALLOP_VELOCITY_CHANGE, 1, "quadratic", &usual, CLAIM_REFUTED, 0, NULL, NULL },
  { "k0*exp(1)*T^80", REST, V_END, 3, "quadratic", &equal, CLAIM_SHARPER, SERIES_ALL, NULL, NULL },
  /* The rear body is body 1 in an extension, and 2 in a contraction, also where the other one turns: from rest with
   * F1 < F2. Where it turns x1 = (F1 - F2)/(2 M) (T - dT)^2 - m2/M l, dT of the order of T^3 and l = L - O(T^4). */
  { "0", REST, SCALLOP_REAR_AT_LAST, 1, "quadratic", &weaker, CLAIM_REFUTED, 0, "-873/220", NULL },
  { "-m2*L/M + (F1-F2)/(2*M)*T^2", REST, SCALLOP_REAR_AT_LAST, 4, "quadratic", &weaker, CLAIM_HOLDS, 4, NULL, NULL },
  { "x_switch + T^3", REST, SCALLOP_REAR_AT_LAST, 3, "quadratic", &weaker, CLAIM_HOLDS, 3, "-1", NULL },
  { "x_switch - T^3", REST, SCALLOP_REAR_AT_LAST, 3, "sinusoidal", &weaker, CLAIM_HOLDS, 3, "1", NULL },
  /* What holds for one crawler by coincidence, m1 + m2 = 11/5, is not proven for all; finitely many coefficients are no
   * equality. */
  { "t1 + (M - 11/5)*T^4", MOVING, SCALLOP_FIRST_SWITCH, 3, "quadratic", &usual, CLAIM_SHARPER, 51, NULL,
    "of other crawlers as T^4" },
  { "v0", MOVING, V_END, 2, "quadratic", &equal, CLAIM_HOLDS, 2, NULL, "of other crawlers as T^1" },
  { "x_switch + T^20", MOVING, SCALLOP_REAR_AT_LAST, 3, "sinusoidal", &usual, CLAIM_SHARPER, 16, NULL, "below T^16" },
  { "x_switch + T^20", MOVING, SCALLOP_REAR_AT_LAST, SCALLOP_EQUALITY, "sinusoidal", &usual, CLAIM_REFUTED, 16, NULL,
    "the certified error is not 0" },
  { "x_switch + T^48/(1 - 3*T)", MOVING, SCALLOP_REAR_AT_LAST, 3, "quadratic", &usual, CLAIM_SHARPER, 48, NULL, NULL },
};

/* The row of a table of claims, which is to be freed, about the formula alone */
static const struct claim_row *decided(struct claim_table *of_one, const struct scallop_formula *formula,
                                       const struct scallop_crawler *crawler, const char *gait)
{
  struct scallop_crawler c = *crawler;
  SCOPED(scallop_rational, exact);
  c.gait = gait_of_text(gait).gait;
  assert_non_null(c.gait);
  rational_crawler(&exact, &c);
  claim_table_add_formula(of_one, &exact, true, formula);
  return of_one->rows;
}

TEST(formulas)
{
  for (const struct verdict *v = verdicts; v < verdicts + sizeof verdicts / sizeof *verdicts; v++) {
    const struct scallop_formula formula = { .name = "formula",
                                             .equation = "-",
                                             .setting = v->setting,
                                             .quantity = v->quantity,
                                             .remainder = v->claimed,
                                             .text = v->text };
    struct claim_table table_of_one = { .rows = NULL };
    const struct claim_row *row = decided(&table_of_one, &formula, v->crawler, v->gait);
    print_message("%s, %s: %s, order %ld, %s: %s\n", v->text, v->gait, claim_verdict_text(row->verdict),
                  row->derived_order, row->coefficient, row->reason);
    assert_string_equal(table_of_one.contradiction, "");
    assert_int_equal(row->verdict, v->verdict);
    if (row->proven)
      CHECK_EQUAL((double)row->derived_order, (double)v->order);
    if (v->coefficient)
      assert_string_equal(row->coefficient, v->coefficient);
    if (v->reason)
      assert_non_null(strstr(row->reason, v->reason));
    claim_table_free(&table_of_one);
  }
}

/* Conditions are about the numbers as they are written, not about doubles. */
TEST(conditions_are_exact)
{
  static const struct {
    const char *condition;
    bool met;
  } cases[] = { { "M = 2.2", true },
                { "m1 + m2 = 22/10", true },
                { "F1 = 3.7000000000000000001", false },
                { "L*alpha = 6.79", true },
                { "1/0 > 0", false },
                { "1/(M - 2.2) > 0", false },
                { "pi*F2 > 3.4557", true },
                { "pi*F2 < 3.4557", false },
                { "sin(pi) = 0", false },
                { "F1*pi/pi = 3.7", true },
                { "L_kin = L", true },
                { "0.1 + 0.2 = 0.3", true },
                { "alpha > 0.7", false },
                { "M", false } };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    const char *const when[] = { cases[i].condition, NULL };
    const struct scallop_formula formula = { .name = "f",
                                             .equation = "-",
                                             .setting = REST,
                                             .quantity = V_END,
                                             .remainder = 3,
                                             .text = "(F1-F2)/M*T",
                                             .when = when };
    struct claim_table table_of_one = { .rows = NULL };
    if (decided(&table_of_one, &formula, &usual, "quadratic")->inside != cases[i].met)
      fail_msg("%s", cases[i].condition);
    claim_table_free(&table_of_one);
  }
}
