/* Every formula of the paper, as printed, against an independent transcription.
 *
 * The wanted numbers come from the LaTeX source of arXiv 1303.2669, transcribed into exact rational
 * arithmetic without a look at asymptotics/. The points below are fractions over 4096, exact in double
 * precision, so the only error is the rounding of the formula itself. Beside each number stands its
 * size: the same formula with the absolute value of every term (a quotient a/b counts |a| |b| / b^2 with
 * the sizes of a and b), rounded up. If no path through a formula has more than 32 operations, then
 * its rounding error is below 32 u = 16 epsilon times the size, in whichever order it is evaluated.
 * The longest, A.15 and B.6, have about 20. */
#include <float.h>

#include "asymptotics/published/read.h"
#include "tests/support/check.h"

#define ROUNDING (16 * DBL_EPSILON)

enum { POINTS = 2 };

#define AT(m1, m2, F1, F2, T, l0, lT, l_start, l_end, v0, t1, dT, x_switch) \
  { \
    .of = { m1, m2, F1, F2, (m1) + (m2), NAN, NAN, NAN, T, l0, lT, NAN, NAN, l_start, l_end, v0, t1, dT, x_switch } \
  }
/* m1, m2, F1, F2, T, l0, lT; l_start, l_end, v0, t1, dT, x_switch. F1 > F2, then F1 < F2 */
static const struct scallop_values extension[POINTS] = {
  AT(6743 / 4096., 4465 / 4096., 12979 / 4096., 7485 / 4096., 2459 / 4096., 37935 / 4096., -38861 / 4096., 0,
     7089 / 4096., 2945 / 4096., 883 / 4096., 957 / 4096., -3521 / 4096.),
  AT(3075 / 4096., 5815 / 4096., 4461 / 4096., 14853 / 4096., 2549 / 4096., 45099 / 4096., -37089 / 4096., 0,
     8715 / 4096., 2605 / 4096., 485 / 4096., 701 / 4096., -3591 / 4096.),
};

static const struct scallop_values contraction[POINTS] = {
  AT(2541 / 4096., 7673 / 4096., 12933 / 4096., 7771 / 4096., 3091 / 4096., -52743 / 4096., 47975 / 4096., 8193 / 4096.,
     0, 2835 / 4096., 1055 / 4096., 643 / 4096., -2451 / 4096.),
  AT(2751 / 4096., 7579 / 4096., 7561 / 4096., 16783 / 4096., 5459 / 4096., -28889 / 4096., 47361 / 4096.,
     11187 / 4096., 0, 1869 / 4096., 781 / 4096., 591 / 4096., -1173 / 4096.),
};

/* A gait whose l0 and -lT differ. The steady formulas read nothing but those of the extension. */
static const struct scallop_piece straight = { .linear = true };
static const struct scallop_gait lopsided = {
  "lopsided",
  { { .pieces = &straight, .count = 1, .l0 = 16105 / 4096., .lT = -36275 / 4096. }, { .l0 = NAN, .lT = NAN } }
};

static const struct scallop_crawler crawler[POINTS] = {
  /* m1, m2, F1, F2, L, T, alpha */
  { 3353 / 4096., 5671 / 4096., 16901 / 4096., 6379 / 4096., 7727 / 4096., 2941 / 4096., 2599 / 4096., &lopsided },
  { 2949 / 4096., 3043 / 4096., 4217 / 4096., 13129 / 4096., 8005 / 4096., 4075 / 4096., 941 / 4096., &lopsided },
};

struct wanted {
  const char *name, *equation;
  enum scallop_setting setting;
  enum scallop_quantity quantity;
  int remainder;
  double value[POINTS], size[POINTS];
};

#define PHASE(f, equation, setting, quantity, remainder, v1, s1, v2, s2) \
  { \
#f, equation, setting, SCALLOP_##quantity, remainder, { v1, v2 }, { s1, s2 } \
  }
#define REST(f, equation, quantity, remainder, v1, s1, v2, s2) \
  PHASE(f, equation, SCALLOP_AT_REST_START, quantity, remainder, v1, s1, v2, s2)
#define EQUAL(f, equation, quantity, v1, s1, v2, s2) REST(f, equation, quantity, SCALLOP_EQUALITY, v1, s1, v2, s2)
#define EXTENSION(f, equation, quantity, remainder, v1, s1, v2, s2) \
  PHASE(f, equation, SCALLOP_MOVING_EXTENSION, quantity, remainder, v1, s1, v2, s2)
#define CONTRACTION(f, equation, quantity, remainder, v1, s1, v2, s2) \
  PHASE(f, equation, SCALLOP_MOVING_CONTRACTION, quantity, remainder, v1, s1, v2, s2)
#define STEADY(f, equation, quantity, remainder, v1, s1, v2, s2) \
  { \
#f, equation, SCALLOP_STEADY, SCALLOP_##quantity, remainder, { v1, v2 }, { s1, s2 } \
  }

/* function, equation, what it gives, exponent of the printed remainder, then value and size twice. (25) prints l(T): in
 * section 4.3.3 that is the amplitude, l at the start of the contraction. A.7 says "v0 t1/2 = O(T^2)", which is no
 * remainder. (12) prints O(dT^2), and dT is of order T^3; (A.4) O(t1^2), and t1 is of order T^2. (A.13) prints none;
 * its first line is the second over M. (B.11) prints the velocity x2'(T - dT), which is 0. x2(0) of appendix B is 0:
 * positions count from the start. (6) is the velocity at T, where l' = 0. Short exact values: A.7 is 2945 883 / 2^25,
 * B.3 is 2835 1055 / 2^25. */
static const struct wanted wanted[] = {
  EQUAL(eq6_v_end, "(6)", VELOCITY_AT_END, 0, 0, 0, 0),
  EQUAL(eq7_dx1, "(7)", REAR_AT_END, -0.6894747552320329, 0.69, -1.391731322281004, 1.4),
  EQUAL(eq8_dxC, "(8)", CENTRE_AT_END, -0.17588169008046708, 0.87, 0.32788854884350394, 1.1),
  REST(eq12_v_switch, "(12)", VELOCITY_AT_LAST, 6, -6.212704512083536, 11, -6.825521347196394, 9.5),
  REST(eq13_dT_unexpanded, "(13)", LAG, 0, 0.026808290694446713, 0.12, -0.051502197069753184, 0.12),
  REST(eq14_dT, "(14)", LAG, 5, 0.028061372584542442, 0.11, -0.04756570143367021, 0.089),
  REST(eq15_x1_switch, "(15)", REAR_AT_LAST, 3, -0.60114079554811875, 1.1, -1.618084792184347, 1.9),
  REST(eq18_v_end, "(18)", VELOCITY_AT_END, 3, 0.29427889293640703, 1.1, -0.72745689503655793, 1.4),
  REST(eq19_dx1, "(19)", REAR_AT_END, 4, -0.60114079554811875, 1.1, -1.618084792184347, 1.9),
  REST(eq20_dx2, "(20)", FRONT_AT_END, 4, 1.1295720950768812, 1.4, 0.50960075469065303, 1.2),
  REST(eq21_dxC, "(21)", CENTRE_AT_END, 4, 0.26421564976438125, 1.2, -0.55424201874684697, 1.5),
  EXTENSION(eq22_dv, "(22)", VELOCITY_CHANGE, 3, -0.027173575514144656, 1.5, -0.80351340249732869, 1.5),
  EXTENSION(eq23_dxC, "(23)", CENTRE_AT_END, 4, 0.59820373100550692, 1.8, -0.17981763617887389, 2),
  CONTRACTION(eq24_dv, "(24)", VELOCITY_CHANGE, 3, -0.77444456145361044, 2, -1.0676023489190069, 5.4),
  CONTRACTION(eq25_dxC, "(25)", CENTRE_AT_END, 4, 0.73963165433062903, 2.3, 0.17053230175683636, 6),
  STEADY(eq26_v_start, "(26)", STEADY_VELOCITY, 1, 0.77175258713458994, 1.8, 0.79208096544673749, 1.6),
  STEADY(eq27_v_start, "(27)", STEADY_VELOCITY, 1, 0.77175258713458994, 1.8, 0.79208096544673749, 1.6),
  STEADY(eq28_displacement, "(28)", STEADY_DISPLACEMENT, 4, 0.5541319235260813, 1.3, 0.78802000346568732, 1.6),
  EXTENSION(eqA4_v_first_switch, "(A.4)", VELOCITY_AT_FIRST, 4, -1.8814848228492953, 3.4, -1.8232599098538154, 3.1),
  EXTENSION(eqA5_t1_unexpanded, "(A.5)", FIRST_SWITCH, 0, 0.059603637104378757, 0.06, 0.030621577116750929, 0.031),
  EXTENSION(eqA6_t1, "(A.6)", FIRST_SWITCH, 6, 0.057707608295358414, 0.083, 0.030203652269704073, 0.039),
  EXTENSION(eqA7_x1_first_switch, "(A.7)", REAR_AT_FIRST, 0, 0.07749900221824646, 0.078, 0.03765299916267395, 0.038),
  EXTENSION(eqA13_v_switch, "(A.13)", VELOCITY_AT_LAST, SCALLOP_EQUALITY, -0.4631337227552516, 18, -1.7458677663002957,
            15),
  EXTENSION(eqA13_v_switch_from_v0, "(A.13)", VELOCITY_AT_LAST, SCALLOP_EQUALITY, -4.623032852862457, 13,
            -5.511870774443563, 11),
  EXTENSION(eqA14_dT_unexpanded, "(A.14)", LAG, 0, 0.0797318772329716, 0.19, -0.0086516334897053304, 0.18),
  REST(eqA15B6_dT_product, "(A.15), (B.6)", LAG, 7, 0.02674971873097531, 0.13, -0.05120131674280494, 0.11),
  EXTENSION(eqA15_dT_product, "(A.15)", LAG, 6, 0.07787782144508062, 0.24, -0.0091824999621818195, 0.17),
  EXTENSION(eqA16_dT, "(A.16)", LAG, 5, 0.077906295296028238, 0.21, -0.0050466384557489983, 0.14),
  EXTENSION(eqA17_x1_switch_from_times, "(A.17)", REAR_AT_LAST, 4, 0.2512413136553578, 4.7, -0.33171115884111796, 4.7),
  EXTENSION(eqA17_x1_switch_collected, "(A.17)", REAR_AT_LAST, 4, 0.2512413136553578, 4.7, -0.33171115884111796, 4.7),
  EXTENSION(eqA18_x1_switch, "(A.18)", REAR_AT_LAST, 4, -0.3119760421514802, 1.7, -1.22663294996182, 2.3),
  EXTENSION(eqA22_v_end_from_dT, "(A.22)", VELOCITY_AT_END, 4, 2.0236100526906373, 2.9, 2.2455916264578379, 3),
  EXTENSION(eqA22_v_end, "(A.22)", VELOCITY_AT_END, 3, 0.69182056511085534, 2.2, -0.16752707437232869, 2.1),
  EXTENSION(eqA23_dx1_from_dT, "(A.23)", REAR_AT_END, 6, -0.62321840570984621, 1.2, -0.68455081419104683, 1.2),
  EXTENSION(eqA23_dx1_from_dT_short, "(A.23)", REAR_AT_END, 4, -0.57338318467758717, 1.2, -0.65273400595364491, 1.2),
  EXTENSION(eqA23_dx1, "(A.23)", REAR_AT_END, 4, -0.07184440813842655, 1.6, -1.2009422067881477, 2.3),
  EXTENSION(eqA24_v_end, "(A.24)", VELOCITY_AT_END, 3, 0.69182056511085534, 2.2, -0.16752707437232869, 2.1),
  EXTENSION(eqA25_dxC, "(A.25)", CENTRE_AT_END, 4, 0.79351203717407345, 1.8, -0.13709943335064769, 2),
  CONTRACTION(eqB2_t1_unexpanded, "(B.2)", FIRST_SWITCH, 0, 0.09044974073325081, 0.091, 0.13365233003137495, 0.14),
  CONTRACTION(eqB2_t1, "(B.2)", FIRST_SWITCH, 6, 0.078704741812080506, 0.17, -0.53016211066593015, 1.4),
  CONTRACTION(eqB3_x2_first_switch, "(B.3)", REAR_AT_FIRST, 2, 0.089136511087417603, 0.09, 0.043502122163772583, 0.044),
  CONTRACTION(eqB5_dT_unexpanded, "(B.5)", LAG, 0, 0.037543731553911991, 0.75, 0.46141448540941523, 2.2),
  CONTRACTION(eqB6_dT_product, "(B.6)", LAG, 6, 0.021715129955513204, 0.77, 0.30846172689620658, 11),
  CONTRACTION(eqB6_dT, "(B.6)", LAG, 5, 0.037503650025935569, 0.53, 0.0051848282657064118, 3.3),
  CONTRACTION(eqB7_x2_switch_from_times, "(B.7)", REAR_AT_LAST, 4, 0.3046756835264675, 4, -0.0009869053999545638, 4.5),
  CONTRACTION(eqB7_x2_switch_collected, "(B.7)", REAR_AT_LAST, 4, 0.11808472070591278, 4, -0.02020935422037194, 4.5),
  CONTRACTION(eqB8_x2_switch, "(B.8)", REAR_AT_LAST, 4, -0.25571348690008118, 2, -1.5682914024023175, 6.2),
  CONTRACTION(eqB10_v_end_from_dT, "(B.10)", VELOCITY_AT_END, 0, 0.48501736904897061, 1.2, -0.089897674277532193, 0.6),
  CONTRACTION(eqB10_v_end, "(B.10)", VELOCITY_AT_END, 3, -0.37945634118994885, 3, 0.37522904934964997, 4.9),
  CONTRACTION(eqB11_dx2_from_dT, "(B.11)", REAR_AT_END, 4, 0.06304603620208517, 0.064, 0.018045543304647943, 0.019),
  CONTRACTION(eqB11_dx2, "(B.11)", REAR_AT_END, 4, -0.26049041598187097, 1.8, -1.1950682841806636, 5.3),
  CONTRACTION(eqB12_v_end, "(B.12)", VELOCITY_AT_END, 3, -0.37945634118994885, 3, 0.37522904934964997, 4.9),
  CONTRACTION(eqB13_dxC, "(B.13)", CENTRE_AT_END, 4, 0.73963165433062903, 2.3, 0.17053230175683636, 6),
};

enum { WANTED = sizeof wanted / sizeof *wanted };

/* The formulas from rest for the two contractions, which scallop_exchanged turns into extensions. */
static const struct {
  const char *name;
  double value[POINTS], size[POINTS];
} rest_of_contraction[] = {
  { "eq12_v_switch", { -2.7561604083169398, 2.0449825302824483 }, { 6.7, 9.5 } },
  { "eq13_dT_unexpanded", { -0.082706772977913301, 0.45303286241709114 }, { 0.52, 1.9 } },
  { "eq14_dT", { -0.074537611327285746, 0.68633010769180352 }, { 0.3, 1.9 } },
  { "eq15_x1_switch", { -0.64151625372856033, 0.065517507119885026 }, { 1.1, 2.9 } },
  { "eq18_v_end", { -0.38138288860571275, 1.1898108985509439 }, { 1.6, 3.2 } },
  { "eq19_dx1", { -0.64151625372856033, 0.065517507119885026 }, { 1.1, 2.9 } },
  { "eq20_dx2", { 1.3587278868964397, 2.796718678994885 }, { 2.1, 4.1 } },
  { "eq21_dxC", { 0.35860581658393967, 1.431118093057385 }, { 1.6, 3.5 } },
  { "eqA15B6_dT_product", { -0.08189988377559966, 0.3328923402430954 }, { 0.42, 4.3 } },
};

enum { FROM_REST = sizeof rest_of_contraction / sizeof *rest_of_contraction };

/* Says which formula is off, and counts it, so that one run shows every difference. */
static int differs(const char *name, int i, double got, double value, double size)
{
  if (check_near(got, value, ROUNDING * size))
    return 0;
  print_error("%s at point %d = %.17g, wanted %.17g: off by %.3g of its size\n", name, i, got, value,
              (got - value) / size);
  return 1;
}

/* The text as it stands */
static double value_of(const char *name, const struct scallop_values *values)
{
  struct formula read;
  char message[FORMULA_MESSAGE];
  const struct scallop_formula *f = scallop_formula_named(name);
  assert_non_null(f);
  assert_null(scallop_formula_text(&read, f, NULL, message));
  return formula_double(&read, values->of);
}

static double value_at(const struct wanted *w, int i)
{
  const struct scallop_values steady = scallop_steady_values(&crawler[i]);
  return value_of(w->name, w->setting == SCALLOP_STEADY               ? &steady
                           : w->setting == SCALLOP_MOVING_CONTRACTION ? &contraction[i]
                                                                      : &extension[i]);
}

TEST(every_formula_is_the_printed_one)
{
  int differences = 0;
  for (const struct wanted *w = wanted; w < wanted + WANTED; w++)
    for (int i = 0; i < POINTS; i++)
      differences += differs(w->name, i, value_at(w, i), w->value[i], w->size[i]);
  assert_int_equal(differences, 0);
}

TEST(rest_formulas_hold_for_a_contraction_with_the_bodies_exchanged)
{
  int differences = 0;
  for (int k = 0; k < FROM_REST; k++)
    for (int i = 0; i < POINTS; i++) {
      struct scallop_values p = scallop_exchanged(&contraction[i]);
      differences += differs(rest_of_contraction[k].name, i, value_of(rest_of_contraction[k].name, &p),
                             rest_of_contraction[k].value[i], rest_of_contraction[k].size[i]);
    }
  assert_int_equal(differences, 0);
}

TEST(kinematic_length)
{
  static const double length[POINTS] = { 2.5684060060901695, 2.6608114505955489 };
  int differences = 0;
  for (int i = 0; i < POINTS; i++) {
    double got = scallop_kinematic_length(&lopsided, SCALLOP_EXTENSION, crawler[i].L);
    differences += differs("L_kin", i, got, length[i], length[i]);
  }
  assert_int_equal(differences, 0);
}

/* How the printed formulas compare with each other: the sizes are the sums of those in the table. */
TEST(equations_26_and_27_agree)
{
  for (int i = 0; i < POINTS; i++) {
    const struct scallop_values v = scallop_steady_values(&crawler[i]);
    CHECK_NEAR(value_of("eq26_v_start", &v), value_of("eq27_v_start", &v), ROUNDING * 4);
  }
}

TEST(equation_23_and_A25_differ_by_the_sign_of_the_last_term)
{
  for (int i = 0; i < POINTS; i++) {
    const struct scallop_values *p = &extension[i];
    double last = p->of[SCALLOP_SYMBOL_v0] * 2 * p->of[SCALLOP_SYMBOL_F1]
                  / (p->of[SCALLOP_SYMBOL_m2] * p->of[SCALLOP_SYMBOL_l0]) * p->of[SCALLOP_SYMBOL_T]
                  * p->of[SCALLOP_SYMBOL_T] * p->of[SCALLOP_SYMBOL_T];
    CHECK_NEAR(value_of("eqA25_dxC", p) - value_of("eq23_dxC", p), 2 * last, ROUNDING * 4);
  }
}

TEST(equation_24_and_B12_differ_by_the_factor_T2)
{
  for (int i = 0; i < POINTS; i++) {
    const struct scallop_values *p = &contraction[i];
    double friction = -(p->of[SCALLOP_SYMBOL_F1] - p->of[SCALLOP_SYMBOL_F2])
                      / (p->of[SCALLOP_SYMBOL_m1] + p->of[SCALLOP_SYMBOL_m2]) * p->of[SCALLOP_SYMBOL_T];
    double last24 = value_of("eq24_dv", p) - friction,
           lastB12 = value_of("eqB12_v_end", p) - p->of[SCALLOP_SYMBOL_v0] - friction;
    assert_true(fabs(last24) > 0.1);
    CHECK_NEAR(last24, lastB12 * (p->of[SCALLOP_SYMBOL_T] * p->of[SCALLOP_SYMBOL_T]), ROUNDING * 16);
  }
}

/* Appendix B is appendix A with the bodies exchanged, except where one of them is misprinted. */
TEST(appendix_B_is_appendix_A_exchanged)
{
  static const struct {
    const char *name, *a, *b;
  } pair[] = {
    { "A.5 and B.2", "eqA5_t1_unexpanded", "eqB2_t1_unexpanded" },
    { "A.6 and B.2", "eqA6_t1", "eqB2_t1" },
    { "A.7 and B.3", "eqA7_x1_first_switch", "eqB3_x2_first_switch" },
    { "A.14 and B.5", "eqA14_dT_unexpanded", "eqB5_dT_unexpanded" },
    { "A.15 and B.6", "eqA15_dT_product", "eqB6_dT_product" },
    { "A.16 and B.6", "eqA16_dT", "eqB6_dT" },
    { "A.17 and B.7", "eqA17_x1_switch_from_times", "eqB7_x2_switch_from_times" },
    { "A.18 and B.8", "eqA18_x1_switch", "eqB8_x2_switch" },
    { "A.22 and B.10", "eqA22_v_end_from_dT", "eqB10_v_end_from_dT" },
    { "22 and 24", "eq22_dv", "eq24_dv" },
    { "23 and 25", "eq23_dxC", "eq25_dxC" },
  };
  int differences = 0;
  for (size_t k = 0; k < sizeof pair / sizeof *pair; k++)
    for (int i = 0; i < POINTS; i++) {
      struct scallop_values p = scallop_exchanged(&contraction[i]);
      differences += differs(pair[k].name, i, value_of(pair[k].a, &p), value_of(pair[k].b, &contraction[i]), 24);
    }
  assert_int_equal(differences, 0);
}

/* The third line of (A.17) is the second with its products written out; that of (B.7) is so only with 1/2 in front of
 * m1 l''(0) t1^2/M. */
TEST(lines_of_A17_and_B7)
{
  for (int i = 0; i < POINTS; i++) {
    const struct scallop_values *a = &extension[i], *b = &contraction[i];
    CHECK_NEAR(value_of("eqA17_x1_switch_collected", a), value_of("eqA17_x1_switch_from_times", a), ROUNDING * 9.4);
    double half = 0.5 * b->of[SCALLOP_SYMBOL_m1] / (b->of[SCALLOP_SYMBOL_m1] + b->of[SCALLOP_SYMBOL_m2])
                  * b->of[SCALLOP_SYMBOL_l0] * b->of[SCALLOP_SYMBOL_t1] * b->of[SCALLOP_SYMBOL_t1]
                  / (b->of[SCALLOP_SYMBOL_T] * b->of[SCALLOP_SYMBOL_T]);
    CHECK_NEAR(value_of("eqB7_x2_switch_collected", b) - half, value_of("eqB7_x2_switch_from_times", b),
               ROUNDING * 9.4);
    assert_true(fabs(half) > 0.01);
  }
}

static void check_point(const struct scallop_crawler *c, enum scallop_phase_kind kind, double T, double l0)
{
  struct scallop_values p = scallop_phase_values(c, kind, 0.375);
  CHECK_EQUAL(p.of[SCALLOP_SYMBOL_m1], c->m1);
  CHECK_EQUAL(p.of[SCALLOP_SYMBOL_m2], c->m2);
  CHECK_EQUAL(p.of[SCALLOP_SYMBOL_F1], c->F1);
  CHECK_EQUAL(p.of[SCALLOP_SYMBOL_F2], c->F2);
  CHECK_EQUAL(p.of[SCALLOP_SYMBOL_v0], 0.375);
  CHECK_RELATIVE(p.of[SCALLOP_SYMBOL_T], T, DBL_EPSILON);
  CHECK_RELATIVE(p.of[SCALLOP_SYMBOL_l0], l0, 4 * DBL_EPSILON);
  CHECK_RELATIVE(p.of[SCALLOP_SYMBOL_lT], -l0, 4 * DBL_EPSILON);
  CHECK_EQUAL(p.of[SCALLOP_SYMBOL_l_start], kind == SCALLOP_EXTENSION ? 0 : c->L);
  CHECK_EQUAL(p.of[SCALLOP_SYMBOL_l_end], kind == SCALLOP_EXTENSION ? c->L : 0);
  CHECK_EQUAL(p.of[SCALLOP_SYMBOL_t1], NAN);
  CHECK_EQUAL(p.of[SCALLOP_SYMBOL_dT], NAN);
  CHECK_EQUAL(p.of[SCALLOP_SYMBOL_x_switch], NAN);
}

/* l'' = +-4 L/T^2 for the quadratic gait, +-(pi^2/2) L/T^2 for the sinusoidal one; T of the phase. */
TEST(phase_points)
{
  struct scallop_crawler c = { 1.25, 0.75, 3.5, 1.125, 2.5, 0.625, 0.6875, &scallop_gait_quadratic };
  check_point(&c, SCALLOP_EXTENSION, 0.4296875, 10);    /* 11/16 5/8 = 55/128 */
  check_point(&c, SCALLOP_CONTRACTION, 0.1953125, -10); /*  5/16 5/8 = 25/128 */
  c.gait = &scallop_gait_sinusoidal;
  check_point(&c, SCALLOP_EXTENSION, 0.4296875, 12.337005501361698274);
  check_point(&c, SCALLOP_CONTRACTION, 0.1953125, -12.337005501361698274); /* 5/4 pi^2 */
}

TEST(exchanged_is_the_same_motion)
{
  for (int i = 0; i < POINTS; i++) {
    const struct scallop_values *p = &contraction[i];
    struct scallop_values x = scallop_exchanged(p);
    CHECK_EQUAL(x.of[SCALLOP_SYMBOL_m1], p->of[SCALLOP_SYMBOL_m2]);
    CHECK_EQUAL(x.of[SCALLOP_SYMBOL_m2], p->of[SCALLOP_SYMBOL_m1]);
    CHECK_EQUAL(x.of[SCALLOP_SYMBOL_F1], p->of[SCALLOP_SYMBOL_F2]);
    CHECK_EQUAL(x.of[SCALLOP_SYMBOL_F2], p->of[SCALLOP_SYMBOL_F1]);
    CHECK_EQUAL(x.of[SCALLOP_SYMBOL_l0], -p->of[SCALLOP_SYMBOL_l0]);
    CHECK_EQUAL(x.of[SCALLOP_SYMBOL_lT], -p->of[SCALLOP_SYMBOL_lT]);
    CHECK_EQUAL(x.of[SCALLOP_SYMBOL_l_end] - x.of[SCALLOP_SYMBOL_l_start],
                p->of[SCALLOP_SYMBOL_l_start] - p->of[SCALLOP_SYMBOL_l_end]);
    CHECK_EQUAL(x.of[SCALLOP_SYMBOL_T], p->of[SCALLOP_SYMBOL_T]);
    CHECK_EQUAL(x.of[SCALLOP_SYMBOL_v0], p->of[SCALLOP_SYMBOL_v0]);
    CHECK_EQUAL(x.of[SCALLOP_SYMBOL_t1], p->of[SCALLOP_SYMBOL_t1]);
    CHECK_EQUAL(x.of[SCALLOP_SYMBOL_dT], p->of[SCALLOP_SYMBOL_dT]);
    CHECK_EQUAL(x.of[SCALLOP_SYMBOL_x_switch], p->of[SCALLOP_SYMBOL_x_switch]);
  }
}

static void check_exchanged_twice(const struct scallop_values *p)
{
  struct scallop_values once = scallop_exchanged(p), twice = scallop_exchanged(&once);
  assert_memory_equal(&twice, p, sizeof twice);
  assert_memory_not_equal(&once, p, sizeof once);
}

TEST(exchanged_twice_is_the_identity)
{
  for (int i = 0; i < POINTS; i++) {
    check_exchanged_twice(&extension[i]);
    check_exchanged_twice(&contraction[i]);
  }
}

static int length_of(const struct scallop_formula *list)
{
  int n = 0;
  while (list[n].name)
    n++;
  return n;
}

/* All of the formula file, once each and in the order of the paper, with what is printed beside it */
TEST(the_file_lists_every_formula)
{
  assert_int_equal(length_of(scallop_published), WANTED);
  for (int k = 0; k < WANTED; k++) {
    const struct scallop_formula *f = &scallop_published[k];
    const struct wanted *w = &wanted[k];
    assert_string_equal(f->name, w->name);
    if (strcmp(f->equation, w->equation) != 0 || f->setting != w->setting || f->quantity != w->quantity
        || f->remainder != w->remainder)
      fail_msg("%s: %s, setting %d, quantity %d, remainder %d", f->name, f->equation, (int)f->setting, (int)f->quantity,
               f->remainder);
    if (k < 3) /* (6) to (8) */
      assert_string_equal(f->when[0], "F1 = F2");
    else
      assert_null(f->when);
  }
}

TEST(names_are_unique)
{
  const struct scallop_formula *const lists[] = { scallop_published, scallop_corrected };
  for (int i = 0; i < 2; i++)
    for (const struct scallop_formula *f = lists[i]; f->name; f++)
      assert_true(scallop_formula_named(f->name) == f);
  assert_null(scallop_formula_named("text_steady"));
}

/* Conditions in doubles, for the explorer; one that cannot be read does not hold. */
TEST(conditions_in_doubles)
{
  static const struct {
    const char *when;
    bool holds;
  } cases[] = { { "m1 < 2*F2", true }, { "m1 > 2*F2", false }, { "2*m1 = 5", true }, { "m1", false },
                { "m3 > 1", false },   { "F2=F1", false },     { NULL, true } };
  const struct scallop_values values = {
    .of = { [SCALLOP_SYMBOL_m1] = 2.5, [SCALLOP_SYMBOL_F2] = 3, [SCALLOP_SYMBOL_F1] = 4 }
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    const char *const when[] = { cases[i].when, NULL };
    const struct scallop_formula f = { .name = "f", .setting = SCALLOP_STEADY, .when = when };
    assert_int_equal(scallop_formula_is_claimed(&f, &values), cases[i].holds);
  }
  assert_true(scallop_condition_is_equal_forces(" F2 = F1 ") && scallop_condition_is_equal_forces("F1=F2"));
  assert_false(scallop_condition_is_equal_forces("F1 = F2 + m1") || scallop_condition_is_equal_forces("F1 = m2"));
}
