/* The claims in words that a single example decides, or that hold for every crawler: each figure from another route,
 * the double solver, a closed form of the quadratic gait, or pencil and paper. The verdicts are those of
 * data/claims.tsv, with which `make check` compares the table of claims. */
#include "tests/support/claim_table.h"

static int begin(void **state)
{
  const struct scallop_crawler crawler = paper(0);
  fill_claim_table(&claims, &crawler, false);
  return (void)state, 0;
}

/* The displacement of a sliding crawler with both asymmetries changes its sign where the row says, and stays 0 at F1 =
 * 1000. */
TEST(both_asymmetries_and_no_displacement)
{
  for (int g = 0; g < 2; g++) {
    const struct claim_row *row = row_of("two_asymmetries_suffice_to_move", g, "F1 varied");
    double low, high, up, down;
    READ_NUMBERS(row, "displacement/L ", 4, "%lf at F1 = %lf, %lf at %lf", &up, &low, &down, &high);
    assert_true(low < high && high < low * (1 + 1e-9));
    for (int i = 0; i < 2; i++) {
      struct scallop_crawler c = paper(g);
      c.alpha = 0.55;
      c.F1 = i ? high * (1 + 1e-9) : low * (1 - 1e-9);
      struct scallop_steady_result s = steady_of(&c);
      assert_int_equal(s.period.regime, SCALLOP_SLIDING);
      assert_true(i ? s.period.displacement < 0 : s.period.displacement > 0);
    }
    struct scallop_crawler rests = paper(g);
    rests.F1 = 1000; /* above m2 l'' + F2 at its largest: 641 and 790 */
    assert_int_equal(steady_of(&rests).period.regime, SCALLOP_AT_REST);
    CHECK_EQUAL(steady_of(&rests).period.displacement, 0);
  }
}

/* Rows of one steady state: Froude number, start velocity and displacement as the double solver has them. */
TEST(figures_of_steady_states)
{
  static const struct {
    const char *claim, *conditions;
    double m1, F1, T, alpha;
    enum scallop_regime regime;
  } rows[] = {
    { "moving_needs_a_high_Froude_number", "sliding", 1, 34.9776, 1, 0.75, SCALLOP_SLIDING },
    { "moving_needs_a_high_Froude_number", "T = 6", 1, 4, 6, 0.75, SCALLOP_STICK_SLIP },
    { "moving_needs_a_high_Froude_number", "T = 14", 1, 4, 14, 0.75, SCALLOP_STICK_SLIP },
    { "one_degree_of_freedom_can_move", "the paper's crawler", 1, 4, 1, 0.75, SCALLOP_SLIDING },
    { "one_degree_of_freedom_can_move", "F1 = 300", 1, 300, 1, 0.75, SCALLOP_STICK_SLIP },
    { "start_velocity_opposes_motion_at_low_Froude", "", 1, 90, 1, 0.55, SCALLOP_SLIDING },
    { "the_forces_must_differ_not_the_coefficients", "", 4, 4, 1, 0.75, SCALLOP_SLIDING },
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
    for (int g = 0; g < 2; g++) {
      const struct claim_row *row = row_of(rows[k].claim, g, rows[k].conditions);
      struct scallop_crawler c = paper(g);
      c.m1 = rows[k].m1, c.F1 = rows[k].F1, c.T = rows[k].T, c.alpha = rows[k].alpha;
      struct scallop_steady_result s = steady_of(&c);
      assert_int_equal(s.period.regime, rows[k].regime);
      CHECK_RELATIVE(number_after(row, "Froude "), s.froude, 1e-5);
      CHECK_NEAR(number_after(row, "v_start T/L = "), s.period.v_start * c.T / c.L, 1e-6);
      CHECK_NEAR(number_after(row, "displacement/L = "), s.period.displacement / c.L, 1e-6);
    }
}

/* The start velocity along the translation at F1/F2 = 4, and against it at 40 */
TEST(two_regimes)
{
  for (int g = 0; g < 2; g++) {
    const struct claim_row *row = row_of("start_velocity_has_two_regimes", g, "4 and 40");
    double v[2], moved[2];
    READ_NUMBERS(row, "v_start T/L = ", 4, "%lf and displacement/L = %lf at F1/F2 = 4, %lf and %lf at 40", &v[0],
                 &moved[0], &v[1], &moved[1]);
    for (int i = 0; i < 2; i++) {
      struct scallop_crawler c = paper(g);
      c.F1 = i ? 40 : 4;
      struct scallop_steady_result s = steady_of(&c);
      assert_int_equal(s.period.regime, SCALLOP_SLIDING);
      CHECK_NEAR(v[i], s.period.v_start * c.T / c.L, 1e-6);
      CHECK_NEAR(moved[i], s.period.displacement / c.L, 1e-6);
    }
    assert_true(v[0] > 0 && v[1] < 0 && moved[0] > 0 && moved[1] > 0);
  }
}

/* For the quadratic gait, from rest and sliding, with s = (F1-F2) T^2/(4 m2 L), dT = T s/(1 + s) and
 * dvC = [F1 - F2 - 2 F1 s/(1 + s)] T/M, whose slope is F1 - F2 - 2 F1 [s/(1 + s) + 2 s/(1 + s)^2], over M. */
TEST(slope_of_figure_4B)
{
  static const double durations[] = { 0.49, 0.51, 1.65 }, alpha[] = { 0.51, 0.51, 0.75 }, T[] = { 1, 1, 2.2 };
  for (int i = 0; i < 3; i++) {
    double s = 3 * durations[i] * durations[i] / 40, slope = 3 - 8 * (s / (1 + s) + 2 * s / ((1 + s) * (1 + s)));
    struct scallop_crawler c = paper(0);
    c.alpha = alpha[i], c.T = T[i];
    struct scallop_steady_result r = steady_of(&c);
    assert_true(i < 2 ? slope > 0 : slope < 0);
    assert_true(slope * r.period.v_start < 0 && r.period.displacement > 0);
    struct scallop_crawler one = paper(0);
    one.alpha = 0.5, one.T = 2 * durations[i];
    struct scallop_phase_result p = phase_of(&one, SCALLOP_EXTENSION, 0);
    CHECK_NEAR(p.dT, durations[i] * s / (1 + s), 1e-14);
    CHECK_NEAR(p.v_end, (3 - 8 * s / (1 + s)) * durations[i] / 2, 1e-13);
  }
  double s[2];
  for (int i = 0; i < 2; i++)
    s[i] = 3 * (i ? 1.65 : 1.64) * (i ? 1.65 : 1.64) / 40;
  CHECK_NEAR(number_after(row_of("start_velocity_is_backward_where_dvC_falls", 0, ""), "dvC changes by "),
             (3 - 8 * s[1] / (1 + s[1])) * 1.65 / 2 - (3 - 8 * s[0] / (1 + s[0])) * 1.64 / 2, 1e-6);
}

struct centre {
  double at[5];
  int samples;
};

static bool note_centre(void *context, const struct scallop_sample *sample)
{
  struct centre *c = context;
  c->at[c->samples++] = sample->xC;
  return true;
}

/* What the centre does in each phase of the steady motion, from its trajectory: alpha = 3/4 is the third of four
 * samples. */
TEST(boundary_from_trajectories)
{
  static const char *const which[] = { "F1/F2", "together", "T alone" }, *const values[] = { "F1/F2 = ", "F2 = ",
                                                                                             "T = " };
  for (int k = 0; k < 6; k++) {
    int g = k / 3, varied = k % 3;
    const struct claim_row *row = row_of("v_mid_peaks_where_v_start_is_0", g, which[varied]);
    const struct claim_row *moves = row_of("contraction_loses_least_where_v_start_is_0", g, which[varied]);
    double v[3], x[3], back[3], out[3];
    READ_NUMBERS(row, "v_mid T/L = ", 3, "%lf, %lf, %lf", &v[0], &v[1], &v[2]);
    READ_NUMBERS(row, values[varied], 3, "%lf, %lf, %lf", &x[0], &x[1], &x[2]);
    READ_NUMBERS(moves, "contraction is ", 6, "%lf, %lf, %lf there; of the extension %lf, %lf, %lf", &back[0], &back[1],
                 &back[2], &out[0], &out[1], &out[2]);
    for (int i = 0; i < 3; i++) {
      struct scallop_crawler c = paper(g);
      struct centre centre = { .samples = 0 };
      c.F1 = varied == 0 ? x[i] : varied == 1 ? 4 * x[i] : 4;
      c.F2 = varied == 1 ? x[i] : 1;
      c.T = varied == 2 ? x[i] : 1;
      struct scallop_steady_result s = steady_of(&c);
      assert_int_equal(scallop_trajectory(&c, s.period.v_start, 1, 4, note_centre, &centre), SCALLOP_OK);
      CHECK_NEAR(v[i], s.period.v_mid * c.T / c.L, 1e-6);
      CHECK_NEAR(out[i], (centre.at[3] - centre.at[0]) / c.L, 1e-6);
      CHECK_NEAR(back[i], (centre.at[4] - centre.at[3]) / c.L, 1e-6);
      if (i != 1)
        assert_true(i ? s.period.v_start < 0 : s.period.v_start > 0);
    }
    assert_true(v[0] > v[1] && v[1] > v[2] && back[0] > back[1] && back[1] > back[2] && back[2] > 0);
    assert_true(out[0] < out[1] && out[1] > out[2]);
  }
}

/* Pencil and paper, for the quadratic gait: duration 3/4, |l'| = L/tau at a quarter of it */
TEST(by_hand)
{
  double tau = 0.75, s = 3 * tau * tau / 40, dT = tau * s / (1 + s);
  const struct claim_row *row = row_of("body_1_is_slower_in_the_first_interval", 0, "m1 = 0.5");
  CHECK_NEAR(number_after(row, "v1 T/L = "), -1 / (1.5 * tau) + 3 * tau / (4 * 1.5 * 10), 1e-6);
  CHECK_NEAR(number_after(row, "v2 T/L = "), 0.5 / (1.5 * tau) + 3 * tau / (4 * 1.5 * 10), 1e-6);
  row = row_of("last_interval_carries_the_centre_forward", 0, "");
  CHECK_NEAR(number_after(row, "dxC/L = "), (3 * tau * tau / 4 - 4 * dT * dT / 2) / 10, 1e-9); /* - F1 dT^2/M */
  CHECK_NEAR(number_after(row, "would be "), 3 * tau * tau / 40, 1e-9);
  row = row_of("first_interval_accelerates_l", 0, "");
  CHECK_NEAR(number_after(row, "ends, "), s / (1 + s), 1e-6);
  CHECK_NEAR(number_after(row, "l'' = "), -4, 1e-6);
  row = row_of("equal_forces_centre", 0, ""); /* dx1 = -m2 L/M, dx2 = m1 L/M */
  CHECK_NEAR(number_after(row, "dxC/L = "), (-1. / 3 + 2. / 3) / 2, 1e-6);
  CHECK_NEAR(number_after(row, "(8) gives "), (2 - 1) / 2. * (-1. / 3), 1e-6);
  CHECK_NEAR(number_after(row_of("kinematic_length", 0, ""), "= "), 1, 1e-12);
  CHECK_NEAR(number_after(row_of("kinematic_length", 1, ""), "= "), 9.869604401089358 / 8, 1e-12);
  /* x0' t1/2 = x0'^2 M tau^2/(2 m1 4 L); t1 = x0' M tau^2/(4 m2 L) = U alpha tau/(2 L), U = 30/9.25 from (28) */
  CHECK_NEAR(number_after(row_of("eqB3_x2_first_switch_exceeds_its_remainder", 0, ""), "x2(0), is "), 2 / 80., 1e-6);
  CHECK_NEAR(number_after(row_of("t1_is_small", 0, "v_start"), "t1 is "), 30 / 9.25 * 0.75 / 20, 5e-5);
}

/* The formulas printed without a remainder, once more from the paper; the exact times from the double solver */
TEST(formulas_without_remainder)
{
  for (int g = 0; g < 2; g++) {
    struct scallop_crawler c = paper(g);
    double e = 0.75, k = 0.25, l0 = (g ? 9.869604401089358 / 2 : 4) * 10, F = 3, S = 5, M = 2, v0 = 1;
    double e0 = l0 / (e * e), eT = -e0, k0 = -l0 / (k * k), kT = -k0;
    const struct {
      const char *claim;
      double exact, printed;
    } formulas[] = {
      { "eq13_dT_without_remainder", phase_of(&c, SCALLOP_EXTENSION, 0).dT, -F / (eT - F) * e },
      { "eqA5_t1_without_remainder", phase_of(&c, SCALLOP_EXTENSION, v0).t1, v0 * M / (e0 + S) },
      { "eqA14_dT_without_remainder", phase_of(&c, SCALLOP_EXTENSION, v0).dT,
        -1 / (eT - F) * (v0 * M * (e0 - F) / (e0 + S) + F * e) },
      { "eqB2_t1_without_remainder", phase_of(&c, SCALLOP_CONTRACTION, v0).t1, v0 * M / (-k0 + S) },
      { "eqB5_dT_without_remainder", phase_of(&c, SCALLOP_CONTRACTION, v0).dT,
        1 / (kT - F) * (v0 * M * (k0 - F) / (k0 - S) - F * k) },
    };
    for (size_t i = 0; i < sizeof formulas / sizeof *formulas; i++) {
      const struct claim_row *row = row_of(formulas[i].claim, g, "");
      CHECK_NEAR(number_after(row, " = "), formulas[i].exact, 1e-12);
      CHECK_NEAR(number_after(row, "gives "), formulas[i].printed, 1e-12);
      assert_int_equal(fabs(formulas[i].exact - formulas[i].printed) > 1e-8, g);
    }
  }
}

/* What holds for every crawler, for others than the default one: an extension of the quadratic gait in closed form, and
 * start velocities of any size. The scans meet hundreds of crawlers that they are about. */
TEST(statements_about_every_crawler)
{
  struct random r = { 4711 };
  for (int n = 0; n < 1000; n++) {
    struct scallop_crawler c = { .L = 1, .alpha = random_between(&r, 0.05, 0.95), .gait = every_gait[n % 2], .T = 1 };
    c.m1 = random_decades(&r, 0.1, 10), c.m2 = random_decades(&r, 0.1, 10);
    c.F2 = random_decades(&r, 0.1, 10), c.F1 = c.F2 * random_decades(&r, 1.01, 10);
    double s = random_between(&r, 0.01, 0.99), delta = (c.F1 - c.F2) / (c.F1 + c.F2);
    c.T = sqrt(4 * c.m2 * s / (c.F1 - c.F2)) / c.alpha;
    struct scallop_phase_result rest = phase_of(&c, SCALLOP_EXTENSION, 0);
    if (n % 2 == 0)
      assert_int_equal(rest.regime == SCALLOP_SLIDING, s < delta);
    if (n % 2 == 0 && s < delta)
      CHECK_RELATIVE(rest.dT / (c.alpha * c.T), s / (1 + s), 1e-13); /* below 1/2, and growing with s */
    double v0 = random_between(&r, 0.01, 4)
                / c.T; /* at the largest a body may never turn: friction then takes all it can */
    struct scallop_phase_result from_v0 = phase_of(&c, SCALLOP_EXTENSION, v0);
    assert_true(from_v0.dxC > rest.dxC && from_v0.v_end - v0 < rest.v_end);
    struct scallop_steady_result steady_state = steady_of(&c);
    assert_true(steady_state.period.v_mid >= steady_state.period.v_start);
  }
  static const char *const counted[] = { "velocity_rises_over_extension", "centre_moves_forward_in_an_extension",
                                         "extension_from_rest_has_two_intervals", "first_interval_is_the_greater_part",
                                         "last_interval_grows_with_duration" };
  for (size_t i = 0; i < sizeof counted / sizeof *counted; i++)
    for (int g = 0; g < 2; g++)
      CHECK_AT_MOST(300, number_after(row_of(counted[i], g, "quasi-random"), "("));
}

int main(void) { return check_run(begin, empty); }
