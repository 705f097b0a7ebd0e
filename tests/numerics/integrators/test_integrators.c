/* GSL's integrators and CVODE against the exact solver. They share the model and nothing else, so each checks
 * the other: over seeded crawlers of every regime they agree to the tolerance.
 *
 * The bound: bound_of[method] tolerance (L/(T min(alpha, 1 - alpha)) + |v|) for velocities, and T times that for the
 * displacement. Friction never lets an error in velocity grow (the multiplier is at most 1), so the errors of the steps
 * add up and no more; Adams's method takes the more of them. The largest share of the bound that was seen is
 * printed. */
#include "tests/support/integrators.h"
#include "tests/support/odd_gaits.h"

enum { EACH = 30, CVODE = 2, METHODS = 3 }; /* the others are steppers of scallop_odeiv_integrator */
static const double bound_of[METHODS] = { 32, 32, 512 };

/* All that this program was built with */
static int methods(void) { return scallop_has_cvode() ? METHODS : CVODE; }

static struct scallop_integrator *make(int method, double tolerance)
{
  return method == CVODE ? scallop_cvode_integrator(tolerance)
                         : scallop_odeiv_integrator((enum scallop_odeiv_stepper)method, tolerance);
}

static struct scallop_integrator_period compare(const struct scallop_crawler *c, double v0,
                                                const struct scallop_period_result *exact, int method, double tolerance)
{
  INTEGRATOR(integrator, make(method, tolerance));
  struct scallop_integrator_period p = integrator_period(integrator, c, v0);
  check_period(&p, c, v0, exact, bound_of[method] * tolerance);
  return p;
}

/* Every family of crawlers and every gait: with plateaus, with l'' = 0 at both ends of a phase, with jumps of l'; and
 * gaits whose l' changes its sign, rests or jumps within a phase. Every regime, both directions of travel, crawlers
 * that turn round, and bodies that are let go and stopped again must have been among them. */
enum { ODD = 8, GAITS = ALL_GAITS + ODD };
static void agree(int first, int end, long events[METHODS])
{
  static struct teeth teeth;
  const struct scallop_gait mixed = mixed_gait(&scallop_gait_quadratic, &scallop_gait_sinusoidal);
  const struct scallop_gait *const odd[ODD] = { &there_and_back_gait, &detour_gait,   &teeth.gait, &pause_gait,
                                                &wait_gait,           &hesitant_gait, &mixed,      &stride_gait };
  struct random r = { 20130311 };
  int regimes[3] = { 0 }, held = 0, backward = 0, reversed = 0;
  if (end > methods())
    skip();
  grow_teeth(&teeth);
  worst_share = 0;
  for (int i = 0; i < FAMILIES * EACH * GAITS; i++) {
    enum family family = (enum family)(i % FAMILIES);
    int gait = i / FAMILIES % GAITS;
    struct scallop_crawler c = random_crawler(&r, family, gait < ALL_GAITS ? every_gait[gait] : odd[gait - ALL_GAITS]);
    if (family == STICK_SLIP && i / FAMILIES % 2)
      set_eps(&c, random_decades(&r, 60, 1e4));
    struct scallop_steady_result steady;
    assert_true(scallop_steady(&c, &steady) >= 0);
    const double starts[] = { 0, random_between(&r, -2, 2) * c.L / c.T, steady.period.v_start, -steady.period.v_start };
    double v0 = starts[random_below(&r, 4)], tolerance = pow(10, -6 - 3 * random_below(&r, 3));
    struct scallop_period_result exact = period_of(&c, v0);
    for (int method = first; method < end; method++)
      events[method] += compare(&c, v0, &exact, method, tolerance).events;
    const struct scallop_modes *m = exact.modes;
    regimes[exact.regime]++;
    backward += exact.displacement < 0;
    reversed += v0 * exact.v_end < 0;
    for (int k = 0; k + 2 < m[0].count && k + 2 < SCALLOP_MODES_KEPT; k++)
      held += m[0].kept[k].s1 * m[0].kept[k].s2 == 0 && m[0].kept[k + 1].s1 * m[0].kept[k + 1].s2 != 0;
  }
  print_message(
      "%d sliding, %d stick-slip, %d at rest; %d backward, %d turned round; %d let go and stopped again; worst %.2g of "
      "the bound\n",
      regimes[0], regimes[1], regimes[2], backward, reversed, held, worst_share);
  for (int i = 0; i < 3; i++)
    assert_true(regimes[i] >= 10);
  assert_true(backward >= 20 && reversed >= 10 && held >= 10);
}

TEST(integrators_of_gsl_agree)
{
  long events[METHODS] = { 0 };
  agree(0, CVODE, events);
  CHECK_NEAR((double)events[SCALLOP_ODEIV_RKF45], (double)events[SCALLOP_ODEIV_RK8PD], 0.01 * (double)events[0]);
}

TEST(cvode_agrees) { agree(CVODE, CVODE + 1, (long[METHODS]){ 0 }); }

/* Parted from rest: both bodies at rest where l'' = 0, with equal forces: friction could hold either, but l' is about
 * to part them, and then neither can hold the other. A dip within a step: body 1 comes to zero and is off again within
 * one step, which begins and ends with it moving forward: only a look inside the step can tell, and CVODE must stop
 * where it turns. A light body, 1e17 times lighter: its acceleration cannot be had as a difference from the other's, or
 * locating its events takes over a hundred steps (of a random search). */
static const struct {
  const char *what;
  struct scallop_crawler crawler;
  double v0;
  const char *modes;
  int digits, cvode_digits, last_digits; /* of the tolerances */
  long events, steps, cvode_steps;       /* at least and at most */
} special[] = {
  { "parted from rest",
    { 3.2, 0.28, 0.024, 0.024, 12.6, 1.45, 0.4, &minimum_jerk_gait },
    0,
    "-+",
    10,
    10,
    10,
    0,
    1000,
    5000 },
  { "a dip within a step",
    { 1, 1, 1, 1, 1, 2, 0.5, &scallop_gait_sinusoidal },
    1.32,
    "++ 0+ ++",
    4,
    2,
    8,
    2,
    1000,
    5000 },
  { "a light body",
    { 330326390.34026927, 1.1252853324524996e-09, 234226.26838151389, 280.42533842860473, 1, 92.04635526320547,
      0.78442465681124307, &scallop_gait_sinusoidal },
    -0.02662866572576535,
    "-- -+ 0+",
    9,
    9,
    9,
    0,
    49,
    499 },
};

TEST(special_crawlers)
{
  for (size_t i = 0; i < sizeof special / sizeof *special; i++)
    for (int method = 0; method < methods(); method++) {
      const struct scallop_crawler *c = &special[i].crawler;
      struct scallop_period_result exact = period_of(c, special[i].v0);
      modes_are(&exact.modes[0], special[i].modes);
      for (int n = method == CVODE ? special[i].cvode_digits : special[i].digits; n <= special[i].last_digits; n++) {
        struct scallop_integrator_period p = compare(c, special[i].v0, &exact, method, pow(10, -n));
        if (p.events < special[i].events || p.steps > (method == CVODE ? special[i].cvode_steps : special[i].steps))
          fail_msg("%s, method %d: %ld events, %ld steps", special[i].what, method, p.events, p.steps);
      }
    }
}

/* Whatever the crawler, there is an answer that agrees, and never an endless run. */
TEST(extremes_end)
{
  struct random r = { 1736 };
  worst_share = 0;
  for (int i = 0; i < 2000; i++) {
    struct scallop_crawler c = { .m1 = random_decades(&r, 1e-9, 1e9),
                                 .m2 = random_decades(&r, 1e-9, 1e9),
                                 .F1 = random_decades(&r, 1e-9, 1e9),
                                 .F2 = random_decades(&r, 1e-9, 1e9),
                                 .L = 1,
                                 .T = random_decades(&r, 1e-12, 1e12),
                                 .alpha = i % 3 ? random_between(&r, 0, 1) : random_decades(&r, 1e-9, 1e-3),
                                 .gait = scallop_gait_named(scallop_gait_name(i % 2)) };
    double v0 = i % 5 ? random_between(&r, -1, 1) * random_decades(&r, 1e-9, 1e9) / c.T : 0;
    struct scallop_period_result exact = period_of(&c, v0);
    compare(&c, v0, &exact, i / 6 % CVODE, 1e-8);
    if (i % 4 == 0) {
      c.gait = every_gait[i / 4 % SMOOTH_GAITS];
      exact = period_of(&c, v0);
      for (int method = CVODE; method < methods(); method++)
        compare(&c, v0, &exact, method, 1e-8);
    }
  }
  print_message("extremes: worst %.2g of the bound\n", worst_share);
}
