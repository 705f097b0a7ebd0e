/* The claims in words about the figures and about steady states: each figure from the double solver or a closed form.
 * The verdicts are those of data/claims.tsv, with which `make check` compares the table of claims. */
#include "tests/support/claim_table.h"

static int begin(void **state) { return (void)state, fill(false); }

static const char *const by_ratio = "the paper's crawler; F1/F2 from 1.01 to 7838 by 1 %";
static const char *const by_forces = "the paper's crawler; F1 and F2 together, 1/Froude from 1e-3 to 92 by 1 %";
static const char *const by_period = "the paper's crawler; T alone, 1/Froude from 1e-3 to 91 by 2 %";

/* x: F1/F2, or with `forces` F2, and F1 = 4 F2 */
static struct scallop_steady_result steady_at(double x, struct scallop_crawler c, bool forces)
{
  c.F2 = forces ? x : 1;
  c.F1 = forces ? 4 * x : x;
  return steady_of(&c);
}

static double mean_speed(double x, const struct scallop_crawler *c, bool forces)
{
  return steady_at(x, *c, forces).mean_velocity * c->T / c->L;
}

/* Where v_start vanishes, from either side */
static void boundary_between(double *low, double *high, const struct scallop_crawler *c, bool forces)
{
  for (int i = 0; i < 60; i++) {
    double mid = 0.5 * (*low + *high);
    *(steady_at(mid, *c, forces).period.v_start > 0 ? low : high) = mid;
  }
}

/* The boundary and both slopes there from the double solver: differences over 1e-6, so good to some 1e-6. */
TEST(boundary_is_a_kink)
{
  for (int k = 0; k < 4; k++) {
    const struct scallop_crawler c = paper(k % 2);
    bool forces = k > 1;
    const struct claim_row *row = find("mean_velocity_peaks_where_v_start_is_0", k % 2, forces ? by_forces : by_ratio,
                                       true);
    double at, before, after, low = forces ? 5 : 30, high = forces ? 10 : 40, h = 1e-6;
    READ_NUMBERS(row, " = ", 3, "%lf the certified slope d(<U> T/L)/d ln is %lf before, %lf after", &at, &before,
                 &after);
    boundary_between(&low, &high, &c, forces);
    double here = mean_speed(low, &c, forces);
    CHECK_RELATIVE(at, low, 1e-9);
    CHECK_NEAR((here - mean_speed(low * (1 - h), &c, forces)) / h, before, 5e-6);
    CHECK_NEAR((mean_speed(low * (1 + h), &c, forces) - here) / h, after, 5e-6);
    assert_true(before - after > 0.1);
  }
}

/* docs/background/theory.md, Where the start velocity vanishes: the multiplier is a smooth number times f g, so at the
 * boundary it jumps by the ratio of these, and d v_start/dx by g/(1 - multiplier). */
TEST(jump_of_the_slope)
{
  for (int i = 0; i < 2; i++) {
    struct scallop_crawler c = scallop_crawler_default();
    double low = i ? 5 : 30, high = i ? 9 : 40, m[2], slope[2], fg[2], g[2], h = 1e-7;
    boundary_between(&low, &high, &c, i);
    for (int after = 0; after < 2; after++) {
      double sign = after ? 1 : -1, x = after ? high : low;
      struct scallop_steady_result near = steady_at(x * (1 + sign * h), c, i),
                                   far = steady_at(x * (1 + sign * 2 * h), c, i);
      c.F2 = i ? (after ? high : low) : 1;
      c.F1 = i ? 4 * c.F2 : after ? high : low;
      double beta = (c.F1 - c.F2) / (c.F1 + c.F2), eps = c.T * c.T * (c.F1 + c.F2) / ((c.m1 + c.m2) * c.L);
      double e = c.alpha * c.alpha * eps, k = (1 - c.alpha) * (1 - c.alpha) * eps,
             q = 0.5 * 4; /* m1 = m2, Lambda = 4 */
      double f = after ? (q + e * beta) / (q + e) : (q - e * beta) / (q + e);
      g[after] = after ? (q - k) / (q + k * beta) : (q - k) / (q - k * beta);
      fg[after] = f * g[after];
      m[after] = near.period.multiplier;
      slope[after] = sign * (far.period.v_start - near.period.v_start);
    }
    CHECK_NEAR(m[0] / m[1], fg[0] / fg[1], 1e-5);
    CHECK_NEAR(slope[0] / slope[1], g[0] * (1 - m[1]) / (g[1] * (1 - m[0])), 1e-4);
  }
}

/* The figures of the rows about the steady state and about a phase, from the double solver */
TEST(figures_of_steady_states)
{
  for (int g = 0; g < 2; g++) {
    struct scallop_crawler c = paper(g);
    double multiplier, v0, F1, moved, T, further, longer;
    c.T = 2;
    struct scallop_steady_result s = steady_of(&c);
    const struct claim_row *row = find("steady_state_is_reached", g,
                                       "the paper's crawler, T = 2, from rest; read as: after finitely many periods",
                                       true);
    READ_NUMBERS(row, "certified multiplier ", 1, "%lf", &multiplier);
    CHECK_NEAR(multiplier, s.period.multiplier, 1e-10);
    row = find("eq27_v_start_in_the_limit", 0, "the paper's crawler, T = 1e-20, alpha from 0.01 to 0.49 by 0.08",
               false);
    double error, worst;
    READ_NUMBERS(row, "relative error, certified: ", 2, "%lf at alpha = 0.25, largest %lf at alpha = 0.01", &error,
                 &worst);
    CHECK_NEAR(error, 24. / 13, 1e-6); /* (r - 1)(1 - 2 alpha)/(alpha^2 r + (1 - alpha)^2), r = 4 */
    CHECK_NEAR(worst, 3 * 0.98 / 0.9805, 1e-6);
    row = find("displacement_grows_with_duration", g,
               "the paper's crawler, F1/F2 = 1/4, 1/2, from v0 = 0.5, 1, 2, 5, 10, 20; T from 0.05 to 8.4 by 2 %",
               false);
    READ_NUMBERS(row, "certified: from v0 = ", 6, "%lf at F1 = %lf dxC/L is %lf for T = %lf and %lf for T = %lf", &v0,
                 &F1, &moved, &T, &further, &longer);
    for (int i = 0; i < 2; i++) {
      c.F1 = F1;
      c.T = i ? longer : T;
      CHECK_NEAR(phase_of(&c, SCALLOP_EXTENSION, v0).dxC / c.L, i ? further : moved, 1e-6);
    }
  }
}

/* docs/background/theory.md: with s = (F1-F2) T^2/(4 m2 L), from rest, up to sticking, dxC/dT = (F1-F2) T/M [1 - (2
 * F1/(F1-F2)) s^2 (3+s)/(1+s)^3], and beyond it (F1-F2) T/M / (1+s)^2, until body 1 never moves. */
TEST(extension_from_rest)
{
  struct random r = { 77 };
  for (int n = 0; n < 2000; n++) {
    struct scallop_crawler c = { .L = 1, .alpha = 0.5, .gait = &scallop_gait_quadratic };
    c.m1 = random_decades(&r, 0.1, 10), c.m2 = random_decades(&r, 0.1, 10);
    c.F2 = random_decades(&r, 0.1, 10), c.F1 = c.F2 * random_decades(&r, 1.01, 100);
    double s = random_between(&r, 0.01, 0.99), M = c.m1 + c.m2, delta = (c.F1 - c.F2) / (c.F1 + c.F2), h = 1e-5;
    double T = sqrt(4 * c.m2 * c.L * s / (c.F1 - c.F2)), x[2];
    if (fabs(s - delta) < 1e-3)
      continue;
    for (int i = 0; i < 2; i++) {
      c.T = 2 * T * (i ? 1 + h : 1 - h);
      x[i] = phase_of(&c, SCALLOP_EXTENSION, 0).dxC;
    }
    double unit = (c.F1 - c.F2) * T / M, slope = s * s * (3 + s) / ((1 + s) * (1 + s) * (1 + s));
    double wanted = s < delta ? 1 - (1 + delta) / delta * slope : 1 / ((1 + s) * (1 + s));
    CHECK_NEAR((x[1] - x[0]) / (2 * h * T) / unit, wanted, 1e-6);
    assert_true(wanted > 0);
  }
}

/* The same with delta = (F1-F2)/(F1+F2), at which s a body sticks: dvC = (F1-F2) T/M (1 - s/delta)/(1+s) is highest at
 * the root of s^2 + (3 + delta) s - delta, and the integral of s^2 (3+s)/(1+s)^3 is s + 3/(1+s) - 1/(1+s)^2. */
static double integral(double s) { return s + 3 / (1 + s) - 1 / ((1 + s) * (1 + s)); }

TEST(onset_of_sticking)
{
  static const double ratios[] = { 2, 10, 40 };
  static const char *const whose[] = { "the paper's crawler, from rest, F1/F2 = 2, 10, 40",
                                       "the default crawler of claims, from rest, F1/F2 = 2, 10, 40" };
  for (int k = 0; k < 2; k++) {
    const struct claim_row *row = find("velocity_change_is_not_monotone", 0, whose[k], k == 0 ? INSIDE : OUTSIDE);
    double peak[3], least, delta = 39. / 41, before = delta * (399. / 400) * (399. / 400);
    READ_NUMBERS(row, "dvC peaks at ", 3, "%lf, %lf, %lf", &peak[0], &peak[1], &peak[2]);
    for (int i = 0; i < 3; i++) {
      double d = (ratios[i] - 1) / (ratios[i] + 1), s = (sqrt((3 + d) * (3 + d) + 4 * d) - (3 + d)) / 2;
      CHECK_NEAR(peak[i], sqrt(s / d), 1e-6);
    }
    row = find("displacement_grows_with_duration", 0, whose[k], k == 0 ? INSIDE : OUTSIDE);
    READ_NUMBERS(row, "least d(dxC) over d((F1-F2)T^2/(2M)), 400 durations up to sticking: ", 1, "%lf", &least);
    CHECK_NEAR(least, 1 - (1 + delta) / delta * (integral(delta) - integral(before)) / (delta - before), 1e-6);
  }
}

/* Where T alone is varied, mean velocity is given in L/T0, T0 being the T of the crawler. */
TEST(speeds_where_T_is_varied)
{
  const struct claim_row *row = find("mean_velocity_peaks_where_v_start_is_0", 0, by_period, INSIDE);
  struct scallop_crawler c = scallop_crawler_default();
  double speed, highest, at, T0;
  READ_NUMBERS(row, "<U> T0/L is ", 4, "%lf there, highest %lf at T = %lf; T0 = %lf", &speed, &highest, &at, &T0);
  assert_null(strstr(row->summary, "<U> T/L"));
  c.T = at;
  struct scallop_steady_result s = steady_of(&c);
  CHECK_RELATIVE(highest, s.mean_velocity * T0 / c.L, 1e-4);
}

/* Of a crawler with hardly any friction at body 2 no boundary is found where F1/F2 is varied. */
TEST(without_a_boundary)
{
  struct claim_table other = { .rows = NULL };
  const struct scallop_crawler c = { 1.3, 0.9, 3.7, 0.001, 9.7, 1, 0.7, &scallop_gait_quadratic };
  int undecided = 0;
  claim_table_add_words(&other, &c);
  for (const struct claim_row *row = other.rows; row < other.rows + other.count; row++) {
    undecided += row->verdict == CLAIM_UNDECIDED && !row->inside;
    assert_null(strstr(row->reason, "nan"));
  }
  assert_int_not_equal(undecided, 0);
  claim_table_free(&other);
}

/* A refutation in words comes with a command; the crawler in it does what the row says. */
TEST(example_moves_backward)
{
  for (int g = 0; g < 2; g++) {
    const struct claim_row *row = find("longer_extension_moves_forward", g, "", INSIDE);
    struct scallop_crawler c = { .L = 1, .gait = scallop_gait_named(row->gait) };
    assert_int_equal(sscanf(row->reason, "scallop steady --m1 %lf --m2 %lf --F1 %lf --F2 %lf --L 1 --T %lf --alpha %lf",
                            &c.m1, &c.m2, &c.F1, &c.F2, &c.T, &c.alpha),
                     6);
    struct scallop_steady_result s = steady_of(&c);
    assert_int_equal(s.period.regime, SCALLOP_SLIDING);
    assert_true(s.period.displacement * (c.F1 - c.F2) * (2 * c.alpha - 1) < 0);
    assert_true(fabs(s.period.displacement) > 1e-3);
  }
}

int main(void) { return check_run(begin, empty); }
