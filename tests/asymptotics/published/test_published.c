/* Every formula of the paper, as printed, against an independent transcription; and formulas that are read once.
 *
 * The wanted numbers come from the LaTeX source of arXiv 1303.2669, transcribed into exact rational
 * arithmetic without a look at asymptotics/. The points below are fractions over 4096, exact in double
 * precision, so the only error is the rounding of the formula itself. Beside each number stands its
 * size: the same formula with the absolute value of every term (a quotient a/b counts |a| |b| / b^2 with
 * the sizes of a and b), rounded up. If no path through a formula has more than 32 operations, then
 * its rounding error is below 32 u = 16 epsilon times the size, in whichever order it is evaluated.
 * The longest, A.15 and B.6, have about 20. */
#include <float.h>

#include <stdio.h>

#include "asymptotics/published/read.h"
#include "tests/support/random_crawler.h"

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

/* The text as it stands, or of this form around it, %s */
static double value_in(const char *form, const char *name, const struct scallop_values *values)
{
  struct formula read;
  char message[FORMULA_MESSAGE], text[400];
  const struct scallop_formula *f = scallop_formula_named(name);
  assert_non_null(f);
  snprintf(text, sizeof text, form, f->text);
  const struct scallop_formula row = { .setting = f->setting, .text = text, .parts = f->parts };
  assert_null(scallop_formula_text(&read, &row, NULL, message));
  return formula_double(&read, values->of);
}

static double value_of(const char *name, const struct scallop_values *values) { return value_in("%s", name, values); }

static struct scallop_values point_of(enum scallop_setting setting, int i)
{
  return setting == SCALLOP_STEADY               ? scallop_steady_values(&crawler[i])
         : setting == SCALLOP_MOVING_CONTRACTION ? contraction[i]
                                                 : extension[i];
}

TEST(every_formula_is_the_printed_one)
{
  int differences = 0;
  for (const struct wanted *w = wanted; w < wanted + WANTED; w++)
    for (int i = 0; i < POINTS; i++) {
      const struct scallop_values p = point_of(w->setting, i);
      differences += differs(w->name, i, value_of(w->name, &p), w->value[i], w->size[i]);
    }
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

/* How the printed formulas compare with each other: a formula beside another one, or beside this form of it. The sizes
 * are the sums of those in the table.
 *
 * (23) and (A.25) differ by the sign of the last term, (24) and (B.12) by the factor T^2 of all but friction. Appendix
 * B is appendix A with the bodies exchanged, except where one of them is misprinted. The third line of (A.17) is the
 * second with its products written out; that of (B.7) is so only with 1/2 in front of m1 l''(0) t1^2/M. */
TEST(formulas_beside_each_other)
{
  static const struct {
    const char *name, *other, *form;
    double size;
    bool exchanged; /* the bodies, for the first of them */
  } beside[] = {
    { "eq26_v_start", "eq27_v_start", "%s", 4, false },
    { "eqA25_dxC", "eq23_dxC", "%s + 4*v0*F1/(m2*l0)*T^3", 4, false },
    { "eq24_dv", "eqB12_v_end", "(%s - v0 + (F1 - F2)/M*T)*T^2 - (F1 - F2)/M*T", 16, false },
    { "eqA17_x1_switch_collected", "eqA17_x1_switch_from_times", "%s", 9.4, false },
    { "eqB7_x2_switch_collected", "eqB7_x2_switch_from_times", "%s + m1/M*l0*t1^2/T^2/2", 9.4, false },
    { "eqA5_t1_unexpanded", "eqB2_t1_unexpanded", "%s", 24, true },
    { "eqA6_t1", "eqB2_t1", "%s", 24, true },
    { "eqA7_x1_first_switch", "eqB3_x2_first_switch", "%s", 24, true },
    { "eqA14_dT_unexpanded", "eqB5_dT_unexpanded", "%s", 24, true },
    { "eqA15_dT_product", "eqB6_dT_product", "%s", 24, true },
    { "eqA16_dT", "eqB6_dT", "%s", 24, true },
    { "eqA17_x1_switch_from_times", "eqB7_x2_switch_from_times", "%s", 24, true },
    { "eqA18_x1_switch", "eqB8_x2_switch", "%s", 24, true },
    { "eqA22_v_end_from_dT", "eqB10_v_end_from_dT", "%s", 24, true },
    { "eq22_dv", "eq24_dv", "%s", 24, true },
    { "eq23_dxC", "eq25_dxC", "%s", 24, true },
  };
  int differences = 0;
  for (size_t k = 0; k < sizeof beside / sizeof *beside; k++)
    for (int i = 0; i < POINTS; i++) {
      const struct scallop_values q = point_of(scallop_formula_named(beside[k].other)->setting, i),
                                  p = beside[k].exchanged ? scallop_exchanged(&q) : q;
      double value = value_of(beside[k].name, &p);
      differences += differs(beside[k].name, i, value, value_in(beside[k].form, beside[k].other, &q), beside[k].size);
      assert_true(strcmp(beside[k].form, "%s") == 0 || fabs(value - value_of(beside[k].other, &q)) > 0.01);
    }
  assert_int_equal(differences, 0);
}

/* l'' = +-4 L/T^2 for the quadratic gait, +-(pi^2/2) L/T^2 for the sinusoidal one; T of the phase: 11/16 5/8 and
 * 5/16 5/8. */
TEST(phase_points)
{
  struct scallop_crawler c = { 1.25, 0.75, 3.5, 1.125, 2.5, 0.625, 0.6875, &scallop_gait_quadratic };
  static const double T[2] = { 0.4296875, 0.1953125 }, l0[2] = { 10, 12.337005501361698274 }; /* 5/4 pi^2 */
  for (int i = 0; i < 4; i++) {
    const bool back = i % 2;
    const double bend = back ? -l0[i / 2] : l0[i / 2];
    c.gait = i < 2 ? &scallop_gait_quadratic : &scallop_gait_sinusoidal;
    const struct scallop_values p = scallop_phase_values(&c, back ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION, 0.375),
                                expected = AT(c.m1, c.m2, c.F1, c.F2, T[back], bend, -bend, back ? c.L : 0,
                                              back ? 0 : c.L, 0.375, NAN, NAN, NAN);
    for (int k = 0; k < SCALLOP_SYMBOLS; k++)
      if (k != SCALLOP_SYMBOL_L && k != SCALLOP_SYMBOL_L_kin && k != SCALLOP_SYMBOL_alpha && k != SCALLOP_SYMBOL_k0
          && k != SCALLOP_SYMBOL_kT)
        CHECK_RELATIVE(p.of[k], expected.of[k],
                       k == SCALLOP_SYMBOL_l0 || k == SCALLOP_SYMBOL_lT ? 4 * DBL_EPSILON
                       : k == SCALLOP_SYMBOL_T                          ? DBL_EPSILON
                                                                        : 0);
  }
}

/* A number of the motion with the bodies exchanged, and which it is without; twice exchanged all is as before. */
TEST(exchanged_is_the_same_motion)
{
#define SAME(symbol, of, sign) \
  { \
    SCALLOP_SYMBOL_##symbol, SCALLOP_SYMBOL_##of, sign \
  }
  static const struct {
    enum scallop_symbol symbol, of;
    int sign;
  } same[] = {
    SAME(m1, m2, 1), SAME(m2, m1, 1), SAME(F1, F2, 1), SAME(F2, F1, 1), SAME(l0, l0, -1),           SAME(lT, lT, -1),
    SAME(T, T, 1),   SAME(v0, v0, 1), SAME(t1, t1, 1), SAME(dT, dT, 1), SAME(x_switch, x_switch, 1)
  };
  for (int i = 0; i < 2 * POINTS; i++) {
    const struct scallop_values *p = i < POINTS ? &extension[i] : &contraction[i - POINTS];
    struct scallop_values once = scallop_exchanged(p), twice = scallop_exchanged(&once);
    for (size_t k = 0; k < sizeof same / sizeof *same; k++)
      CHECK_EQUAL(once.of[same[k].symbol], same[k].sign * p->of[same[k].of]);
    CHECK_EQUAL(once.of[SCALLOP_SYMBOL_l_end] - once.of[SCALLOP_SYMBOL_l_start],
                p->of[SCALLOP_SYMBOL_l_start] - p->of[SCALLOP_SYMBOL_l_end]);
    assert_memory_equal(&twice, p, sizeof twice);
  }
}

/* All of the formula file, once each and in the order of the paper, with what is printed beside it */
TEST(the_file_lists_every_formula)
{
  for (int k = 0; k < WANTED; k++) {
    const struct scallop_formula *f = &scallop_published[k];
    const struct wanted *w = &wanted[k];
    assert_string_equal(f->name, w->name);
    if (strcmp(f->equation, w->equation) != 0 || f->setting != w->setting || f->quantity != w->quantity
        || f->remainder != w->remainder)
      fail_msg("%s: %s, setting %d, quantity %d, remainder %d", f->name, f->equation, (int)f->setting, (int)f->quantity,
               f->remainder);
    assert_int_equal(f->when && strcmp(f->when[0], "F1 = F2") == 0, k < 3); /* (6) to (8) */
    assert_true(k < 3 || !f->when);
  }
  assert_null(scallop_published[WANTED].name);
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

/* ---- formulas that are read once, through the public face ---- */

static struct scallop_read_formula *must_read(const struct scallop_formula *formula)
{
  char message[SCALLOP_FORMULA_MESSAGE] = "";
  struct scallop_read_formula *read = scallop_formula_read(formula, message);
  if (!read)
    fail_msg("\"%s\": %s", formula->text, message);
  return read;
}

/* Every formula of the paper and every correction has a name of its own; read once and evaluated often, it is
 * scallop_published_value to the last bit. */
TEST(published_formulas)
{
  const struct scallop_formula *const lists[] = { scallop_published, scallop_corrected };
  struct random r = { 20261122 };
  int values = 0;
  for (int i = 0; i < 2; i++)
    for (const struct scallop_formula *f = lists[i]; f->name; f++) {
      struct scallop_read_formula *read = must_read(f);
      assert_true(scallop_formula_named(f->name) == f);
      for (int k = 0; k < 8; k++) {
        struct scallop_crawler c = moderate_crawler(&r, 10, 0.1, every_gait[k % 3]);
        enum scallop_phase_kind kind = k % 2 ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION;
        double v0 = random_between(&r, -3, 3), t1 = random_between(&r, 0, 1), dT = random_between(&r, 0, 1),
               x = t1 - dT;
        double got = scallop_formula_double(read, &c, kind, v0, t1, dT, x);
        CHECK_EQUAL(got, scallop_published_value(f, &c, kind, v0, t1, dT, x));
        values += isfinite(got) != 0;
      }
      scallop_formula_free(read);
    }
  assert_true(values > 400);
}

/* The row and its texts are gone when the formula is evaluated. */
static struct scallop_read_formula *read_from_the_stack(enum scallop_setting setting, const char *text)
{
  char texts[2][80], name[] = "mstar";
  snprintf(texts[0], sizeof texts[0], "%s", text);
  snprintf(texts[1], sizeof texts[1], "m1*m2/M");
  const struct scallop_part parts[] = { { name, texts[1] }, { NULL, NULL } };
  const struct scallop_formula row = { .setting = setting, .text = texts[0], .parts = parts };
  struct scallop_read_formula *read = must_read(&row);
  memset(texts, '?', sizeof texts);
  memset(name, '?', sizeof name);
  return read;
}

/* The formula and the arithmetic beside it round at most 12 times each. */
TEST(own_formulas)
{
  static const char text[] = "-(F1 - F2)/mstar*T^2*sqrt(L)/8";
  static const enum scallop_setting settings[] = { SCALLOP_AT_REST_START, SCALLOP_MOVING_EXTENSION,
                                                   SCALLOP_MOVING_CONTRACTION, SCALLOP_STEADY };
  const struct scallop_crawler c = { 1.3, 0.9, 3.7, 1.1, 2.3, 0.7, 0.6, &scallop_gait_quadratic };
  const double scale = sqrt(2.3) / 8 * (1.3 + 0.9) / (1.3 * 0.9), T = 0.7;
  for (int i = 0; i < 4; i++) {
    struct scallop_read_formula *read = read_from_the_stack(settings[i], text);
    bool steady = settings[i] == SCALLOP_STEADY, from_extension = i < 2;
    double in_extension = steady ? T : 0.6 * T, in_contraction = steady ? T : 0.4 * T;
    double exchange = from_extension ? -1 : 1; /* F1 - F2 */
    CHECK_RELATIVE(scallop_formula_double(read, &c, SCALLOP_EXTENSION, 0, NAN, NAN, NAN),
                   -(3.7 - 1.1) * scale * in_extension * in_extension, 12 * DBL_EPSILON);
    CHECK_RELATIVE(scallop_formula_double(read, &c, SCALLOP_CONTRACTION, 0, NAN, NAN, NAN),
                   -(3.7 - 1.1) * exchange * scale * in_contraction * in_contraction, 12 * DBL_EPSILON);
    scallop_formula_free(read);
  }
}

TEST(given_values)
{
  const struct scallop_crawler c = scallop_crawler_default();
  const struct scallop_formula row = { .setting = SCALLOP_MOVING_EXTENSION, .text = "v0 + 2*t1 + 4*dT + 8*x_switch" };
  struct scallop_read_formula *read = must_read(&row);
  CHECK_EQUAL(scallop_formula_double(read, &c, SCALLOP_EXTENSION, 1, 16, 256, 4096), 33825);
  CHECK_EQUAL(scallop_formula_double(read, &c, SCALLOP_EXTENSION, 1, 16, NAN, 4096), NAN);
  static const enum scallop_symbol taken[] = { SCALLOP_SYMBOL_v0, SCALLOP_SYMBOL_t1, SCALLOP_SYMBOL_dT,
                                               SCALLOP_SYMBOL_x_switch };
  for (int i = 0; i < SCALLOP_SYMBOLS; i++) {
    bool is_taken = false;
    for (int k = 0; k < 4; k++)
      is_taken = is_taken || taken[k] == (enum scallop_symbol)i;
    assert_int_equal(scallop_formula_takes(read, (enum scallop_symbol)i), is_taken);
  }
  scallop_formula_free(read);
  scallop_formula_free(NULL);
}

TEST(refusals)
{
  static const struct scallop_part loop[] = { { "a", "b + 1" }, { "b", "F1*(" }, { NULL, NULL } };
  static const struct {
    enum scallop_setting setting;
    const char *text;
    const struct scallop_part *parts;
    const char *message;
  } refused[] = {
    { SCALLOP_STEADY, "2*(F1 - F2", NULL, "character 3: this '(' is not closed" },
    { SCALLOP_STEADY, "", NULL, "character 1: there is no formula" },
    { SCALLOP_STEADY, "F3*T", NULL, "character 1: 'F3' is no quantity known here" },
    { SCALLOP_STEADY, "F1 + a", loop, "b, character 5: a number, a name or '(' is missing before the end" },
    { SCALLOP_STEADY, "v0*T", NULL, "the steady state has no v0" },
    { SCALLOP_STEADY, "F1*x_switch", NULL, "the steady state has no x_switch" },
  };
  for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
    const struct scallop_formula row = { .setting = refused[i].setting,
                                         .text = refused[i].text,
                                         .parts = refused[i].parts };
    char message[SCALLOP_FORMULA_MESSAGE] = "";
    assert_null(scallop_formula_read(&row, message));
    assert_string_equal(message, refused[i].message);
  }
}

/* The name that has the same last letter */
static const char *same_end(const char *name, const char *const *names)
{
  while (*names && (*names)[strlen(*names) - 1] != name[strlen(name) - 1])
    names++;
  return *names;
}

TEST(a_misspelt_part_is_among_the_names)
{
  static const struct scallop_part parts[] = { { "halfz", "F1/2" }, { NULL, NULL } };
  const struct scallop_formula row = { .setting = SCALLOP_STEADY, .text = "T*hafz", .parts = parts };
  char message[FORMULA_MESSAGE] = "";
  struct formula read;
  assert_non_null(scallop_formula_text(&read, &row, same_end, message));
  assert_string_equal(message, "character 3: 'hafz' is no quantity known here: did you mean 'halfz'?");
}
