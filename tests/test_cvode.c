/* CVODE beside the exact solver, as tests/test_odeiv.c has GSL's. The bound: BOUND tolerance (L/(T min(alpha, 1 - alpha)) + |v|)
 * for velocities, and T times that for the displacement; the largest share of it that was seen is printed. */
#include "tests/check.h"

#include <float.h>
#include <stdio.h>
#include <unistd.h>

#include "numerics/cvode.h"
#include "tests/random_crawler.h"

enum { EACH = 30, EXTREMES = 500, BOUND = 512 };

static double worst_share;

static void check_share(double got, double wanted, double tolerance)
{
  worst_share = fmax(worst_share, fabs(got - wanted) / tolerance);
  CHECK_NEAR(got, wanted, tolerance);
}

static struct scallop_rival *cvode_rival(double tolerance)
{
  if (!scallop_has_cvode())
    skip();
  struct scallop_rival *rival = scallop_cvode_rival(tolerance);
  assert_non_null(rival);
  return rival;
}

static struct scallop_rival_period solved(const struct scallop_crawler *c, double v0, double tolerance)
{
  struct scallop_rival_period p = { .v_end = NAN };
  struct scallop_rival *rival = cvode_rival(tolerance);
  assert_int_equal(rival->period(rival, c, v0, NULL, &p), SCALLOP_OK);
  scallop_rival_destroy(rival);
  return p;
}

static struct scallop_period_result compare(const struct scallop_crawler *c, double v0, double tolerance)
{
  struct scallop_period_result exact;
  assert_int_equal(scallop_period(c, v0, &exact), SCALLOP_OK);
  struct scallop_rival_period p = solved(c, v0, tolerance);
  double unit = c->L / (c->T * fmin(c->alpha, 1 - c->alpha)), bound = BOUND * tolerance;
  check_share(p.v_mid, exact.v_mid, bound * (unit + fabs(exact.v_mid)));
  check_share(p.v_end, exact.v_end, bound * (unit + fabs(exact.v_end)));
  check_share(p.displacement, exact.displacement, bound * c->T * (unit + fabs(v0)));
  assert_true(p.steps >= 0 && p.evaluations >= p.steps && p.events >= 0);
  return exact;
}

/* Every family of crawlers and gait; every regime, and bodies that are let go and stopped again, must have been among them. */
TEST(agrees)
{
  struct random r = { 20130311 };
  int regimes[3] = { 0 }, held = 0;
  worst_share = 0;
  for (int family = 0; family < FAMILIES; family++)
    for (int i = 0; i < EACH * ALL_GAITS; i++) {
      struct scallop_crawler c = random_crawler(&r, (enum family)family, every_gait[i % ALL_GAITS]);
      double v0 = random_start(&r, &c, SCALLOP_EXTENSION);
      if (family == STICK_SLIP && i % 2)
        set_eps(&c, random_decades(&r, 60, 1e4));
      struct scallop_period_result exact = compare(&c, v0, i % 3 ? 1e-6 : 1e-10);
      const struct scallop_modes *m = exact.modes;
      regimes[exact.regime]++;
      for (int k = 0; k + 2 < m[0].count && k + 2 < SCALLOP_MODES_KEPT; k++)
        held += m[0].kept[k].s1 * m[0].kept[k].s2 == 0 && m[0].kept[k + 1].s1 * m[0].kept[k + 1].s2 != 0;
    }
  print_message("%d sliding, %d stick-slip, %d at rest; %d let go and stopped again; worst %.2g of the bound\n", regimes[0],
                regimes[1], regimes[2], held, worst_share);
  for (int i = 0; i < 3; i++)
    assert_true(regimes[i] >= 10);
  assert_true(held >= 10);
}

TEST(tolerance_controls_error)
{
  struct scallop_crawler c = scallop_crawler_default();
  struct scallop_period_result exact;
  double last = INFINITY;
  c.gait = &scallop_gait_sinusoidal;
  assert_int_equal(scallop_period(&c, 1.317, &exact), SCALLOP_OK);
  for (int digits = 2; digits <= 14; digits += 4) {
    double error = fabs(solved(&c, 1.317, pow(10, -digits)).v_end - exact.v_end);
    CHECK_AT_MOST(error, 1e-2 * last);
    last = error;
  }
}

/* Body 1 comes to zero and is off again within less than a step: CVODE must stop where it turns. */
TEST(dip_within_a_step)
{
  struct scallop_crawler c = { 1, 1, 1, 1, 1, 2, 0.5, &scallop_gait_sinusoidal };
  char modes[SCALLOP_MODES_TEXT];
  for (int digits = 2; digits <= 8; digits++) {
    struct scallop_period_result exact = compare(&c, 1.32, pow(10, -digits));
    scallop_modes_text(&exact.modes[0], modes);
    assert_string_equal(modes, "++ 0+ ++");
    assert_true(solved(&c, 1.32, pow(10, -digits)).events >= 2);
  }
}

/* Friction far above what the gait asks for: a stuck body needs no integration. */
TEST(at_rest)
{
  struct scallop_crawler c = scallop_crawler_default();
  c.F1 = 4e5;
  c.F2 = 1e3;
  struct scallop_rival_period p = solved(&c, 0, 1e-10);
  CHECK_NEAR(p.displacement, 0, 4 * DBL_EPSILON * c.L);
  CHECK_EQUAL(p.v_end, 0);
  assert_int_equal(p.evaluations, 0);
}

/* Powers of two as units, so every digit must stay; and nothing may be remembered of the crawler before. */
TEST(any_units)
{
  struct scallop_crawler c = scallop_crawler_default(), d, other;
  struct scallop_rival *rival = cvode_rival(1e-9);
  struct scallop_rival_period a = solved(&c, 0.731, 1e-9), b;
  const double length = 0x1p200, time = 0x1p-150, mass = 0x1p-300;
  const double force = mass * length / time / time;
  other = c;
  other.T = 37;
  d = (struct scallop_crawler){ c.m1 * mass,  c.m2 * mass, c.F1 * force, c.F2 * force,
                                c.L * length, c.T * time,  c.alpha,      c.gait };
  assert_int_equal(rival->period(rival, &other, -3.1, NULL, &b), SCALLOP_OK);
  assert_int_equal(rival->period(rival, &d, 0.731 * length / time, NULL, &b), SCALLOP_OK);
  CHECK_EQUAL(b.v_mid, a.v_mid * length / time);
  CHECK_EQUAL(b.v_end, a.v_end * length / time);
  CHECK_EQUAL(b.displacement, a.displacement * length);
  assert_int_equal(b.steps, a.steps);
  assert_int_equal(b.evaluations, a.evaluations);
  scallop_rival_destroy(rival);
}

/* Whatever the crawler, there is an answer that agrees, and never an endless run. */
TEST(extremes_end)
{
  struct random r = { 1736 };
  worst_share = 0;
  for (int i = 0; i < EXTREMES; i++) {
    struct scallop_crawler c = { .m1 = random_decades(&r, 1e-9, 1e9),
                                 .m2 = random_decades(&r, 1e-9, 1e9),
                                 .F1 = random_decades(&r, 1e-9, 1e9),
                                 .F2 = random_decades(&r, 1e-9, 1e9),
                                 .L = 1,
                                 .T = random_decades(&r, 1e-12, 1e12),
                                 .alpha = i % 3 ? random_between(&r, 0, 1) : random_decades(&r, 1e-9, 1e-3),
                                 .gait = every_gait[i % SMOOTH_GAITS] };
    double v0 = i % 5 ? random_between(&r, -1, 1) * random_decades(&r, 1e-9, 1e9) / c.T : 0;
    compare(&c, v0, 1e-8);
  }
  print_message("extremes: worst %.2g of the bound\n", worst_share);
}

TEST(steady_state)
{
  struct scallop_crawler c = scallop_crawler_default();
  struct scallop_rival *rival = cvode_rival(1e-10);
  struct scallop_steady_result exact;
  struct scallop_rival_steady s;
  c.gait = &scallop_gait_sinusoidal;
  assert_int_equal(scallop_steady(&c, &exact), SCALLOP_OK);
  double off = BOUND * 1e-10 * c.L / c.T / (1 - exact.period.multiplier);
  assert_int_equal(scallop_rival_root(rival, &c, 1e-10, NULL, &s), SCALLOP_OK);
  CHECK_NEAR(s.v_start, exact.period.v_start, off);
  CHECK_NEAR(s.displacement, exact.period.displacement, off * c.T);
  assert_int_equal(scallop_rival_simulate(rival, &c, 0, 1e-10, NULL, &s), SCALLOP_OK);
  CHECK_NEAR(s.v_start, exact.period.v_start, off);
  CHECK_NEAR(s.displacement, exact.period.displacement, off * c.T);
  scallop_rival_destroy(rival);
}

static void refused(const struct scallop_crawler *c, double v0, const struct scallop_patience *patience,
                    enum scallop_status wanted)
{
  struct scallop_rival *rival = cvode_rival(1e-9);
  struct scallop_rival_period p, before;
  memset(&p, 0x5a, sizeof p);
  before = p;
  assert_int_equal(rival->period(rival, c, v0, patience, &p), wanted);
  assert_memory_equal(&p, &before, sizeof p);
  scallop_rival_destroy(rival);
}

static bool count_down(void *context) { return (*(long *)context)-- > 0; }

TEST(statuses)
{
  const double bad_tolerances[] = { 0, -1e-9, 0.1001, 1e-17, NAN, INFINITY };
  struct scallop_crawler good = scallop_crawler_default(), c = good;
  for (int i = 0; i < 6; i++)
    assert_null(scallop_cvode_rival(bad_tolerances[i]));
  refused(&good, NAN, NULL, SCALLOP_EDOMAIN);
  refused(&good, 5e-324, NULL, SCALLOP_ERANGE);
  c.alpha = 1;
  refused(&c, 1, NULL, SCALLOP_EDOMAIN);
  c = good;
  c.T = 1e-200;
  refused(&c, 1, NULL, SCALLOP_ERANGE);
  for (long most = 0; most < 20; most++) {
    long left = most;
    const struct scallop_patience patience = { count_down, &left };
    refused(&good, 1, &patience, SCALLOP_ESTOPPED);
    assert_int_equal(left, -1);
  }
}

static double rough_acceleration(const struct scallop_piece *p, double u)
{
  (void)p;
  return u < 1 / 3.0 ? 1 : 1e20;
}

/* A gait that breaks its promise to be smooth, and then its values are no numbers: it fails, and in silence. */
TEST(fails_in_silence)
{
  const struct scallop_curve *linear = &scallop_curve_linear;
  const struct scallop_curve rough = { linear->length, linear->velocity, rough_acceleration, linear->when, NULL };
  struct scallop_piece piece = { .begin = 0, .end = 1, .direction = 1, .velocity = 1, .curve = &rough };
  const struct scallop_shape shape = { .pieces = &piece, .count = 1, .l0 = 1, .lT = -1, .peak = 1, .net = 1 };
  const struct scallop_gait gait = { "rough", { shape, shape } };
  struct scallop_crawler c = scallop_crawler_default();
  if (!scallop_has_cvode())
    skip();
  FILE *said = tmpfile();
  int stderr_kept = dup(STDERR_FILENO), stdout_kept = dup(STDOUT_FILENO);
  c.gait = &gait;
  assert_non_null(said);
  assert_true(fflush(stdout) == 0 && stderr_kept >= 0 && stdout_kept >= 0);
  assert_true(dup2(fileno(said), STDERR_FILENO) >= 0 && dup2(fileno(said), STDOUT_FILENO) >= 0);
  refused(&c, 100, NULL, SCALLOP_ECONVERGE);
  piece.velocity = NAN;
  refused(&c, 100, NULL, SCALLOP_ECONVERGE);
  assert_true(fflush(stdout) == 0 && dup2(stderr_kept, STDERR_FILENO) >= 0 && dup2(stdout_kept, STDOUT_FILENO) >= 0);
  assert_int_equal(lseek(fileno(said), 0, SEEK_END), 0);
  assert_true(fclose(said) == 0 && close(stderr_kept) == 0 && close(stdout_kept) == 0);
}

TEST(left_out_only_without_sundials) { assert_int_equal(scallop_cvode_rival(1e-9) != NULL, scallop_has_cvode()); }
