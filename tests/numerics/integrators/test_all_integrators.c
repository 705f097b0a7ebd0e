/* What holds for every integrator: what it refuses, other units, rest, patience, that it forgets, and steady states.
 * What each is for itself: the programs beside this one. */
#include <limits.h>

#include <gsl/gsl_errno.h>

#include "tests/support/integrators.h"
#include "tests/support/said.h"

static struct scallop_integrator *rkf45(double tolerance)
{
  return scallop_odeiv_integrator(SCALLOP_ODEIV_RKF45, tolerance);
}
static struct scallop_integrator *rk8pd(double tolerance)
{
  return scallop_odeiv_integrator(SCALLOP_ODEIV_RK8PD, tolerance);
}
static struct scallop_integrator *unknown(double tolerance) { return scallop_odeiv_integrator(2, tolerance); }
static struct scallop_integrator *none(double tolerance) { return scallop_odeiv_integrator(-1, tolerance); }
static struct scallop_integrator *smoothed(double tolerance) { return scallop_smoothed_integrator(1e-3, tolerance); }
static struct scallop_integrator *smoothed_over(double delta) { return scallop_smoothed_integrator(delta, 1e-6); }
static struct scallop_integrator *moreau(double steps) { return scallop_moreau_integrator((long)steps); }

/* sharp, coarse: what it is made with where it is to be exact, or quick. questions: how many it is told to go on for
 * before its patience ends, and in what steps. rest: what the displacement of a crawler at rest may be off by, in L.
 * steady: what a steady state is off by, over 1 - multiplier, in the fastest l'; 0: not asked */
static const struct kind {
  const char *name;
  struct scallop_integrator *(*make)(double with);
  double sharp, coarse;
  long questions, step;
  double rest, steady;
} kinds[] = {
  { "rkf45", rkf45, 1e-10, 1e-9, 4, 1, 4 * DBL_EPSILON, 68 * 1e-10 },
  { "rk8pd", rk8pd, 1e-10, 1e-9, 4, 1, 4 * DBL_EPSILON, 68 * 1e-10 },
  { "cvode", scallop_cvode_integrator, 1e-10, 1e-9, 19, 1, 4 * DBL_EPSILON, 512 * 1e-10 },
  { "smoothed", smoothed, 1e-7, 1e-6, 40, 10, INFINITY, 0 },
  /* asked before the first step, and 6 times for 3 x 256 steps in each of two pieces of the extension */
  { "moreau", moreau, 4096, 6 * 256, 11, 1, 1e-13, 0 },
};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* Those that this program was built with */
static bool is_there(const struct kind *k) { return k->make != scallop_cvode_integrator || scallop_has_cvode(); }
/* NOLINTBEGIN(bugprone-macro-parentheses): k is declared */
#define FOR_KINDS(k) \
  for (const struct kind *k = kinds; k < kinds + KINDS; k++) \
    if (is_there(k))
/* NOLINTEND(bugprone-macro-parentheses) */

TEST(bad_handles)
{
  static const struct {
    struct scallop_integrator *(*make)(double with);
    double with[9]; /* the last is 7 */
  } bad[] = {
    { rkf45, { 0, -1e-9, 0.1001, 1, 2e-16, 1e-17, NAN, INFINITY, 7 } },
    { rk8pd, { 0, -1e-9, 0.1001, 1, 2e-16, 1e-17, NAN, INFINITY, 7 } },
    { scallop_cvode_integrator, { 0, -1e-9, 0.1001, 1, 2e-16, 1e-17, NAN, INFINITY, 7 } },
    { smoothed, { 0, -1e-9, 0.1001, 1, 2e-16, NAN, INFINITY, 7 } },
    { smoothed_over, { 0, -1e-3, NAN, INFINITY, 7 } },
    { moreau, { 0, -1, 7 } },
    { unknown, { 1e-9, 7 } },
    { none, { 1e-9, 7 } },
  };
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
    for (const double *with = bad[i].with; *with != 7; with++)
      assert_null(bad[i].make(*with));
  if ((double)LONG_MAX > 0x1p53)
    assert_null(scallop_moreau_integrator(LONG_MAX));
  assert_true(scallop_has_cvode() || !scallop_cvode_integrator(1e-9));
  scallop_integrator_destroy(NULL);
}

#define OF_SIZE(L, T) 1, 1, 4, 1, L, T, 0.75, &scallop_gait_quadratic
#define VAST 0.5, 0.5, 4e301, 1e301, 1e308, 1e3, 0.5, &scallop_gait_quadratic
static const struct refused {
  struct scallop_integrator *(*make)(double with); /* NULL: every one, made coarse */
  double with;
  struct scallop_crawler crawler;
  double v0;
  enum scallop_status wanted;
} refusals[] = {
  { NULL, 0, { OF_SIZE(10, 1) }, NAN, SCALLOP_EDOMAIN },
  { NULL, 0, { OF_SIZE(10, 1) }, -INFINITY, SCALLOP_EDOMAIN },
  { NULL, 0, { OF_SIZE(10, 1) }, 5e-324, SCALLOP_ERANGE },
  { NULL, 0, { 1, 1, 4, 1, 10, 1, 1, &scallop_gait_quadratic }, 1, SCALLOP_EDOMAIN },
  { NULL, 0, { 1, 1, 4, 1, 10, 1, 0.75, NULL }, 1, SCALLOP_EDOMAIN },
  { NULL, 0, { OF_SIZE(10, 1e-200) }, 1, SCALLOP_ERANGE }, /* eps underflows           */
  { NULL, 0, { VAST }, 5e306, SCALLOP_ERANGE },            /* the displacement is 50 L */
  { NULL, 0, { VAST }, -5e306, SCALLOP_ERANGE },
  { moreau, 100, { OF_SIZE(10, 100) }, 1e307, SCALLOP_ERANGE },        /* ... overflows            */
  { smoothed_over, DBL_MIN, { OF_SIZE(10, 1) }, 1, SCALLOP_ERANGE },   /* alpha times it is less */
  { smoothed_over, 1e-300, { OF_SIZE(10, 1e10) }, 1, SCALLOP_ERANGE }, /* stiffness overflows    */
  { smoothed_over, 1e-3, { 1, 1, 4e298, 1e298, 1e300, 10, 0.75, &scallop_gait_quadratic }, 1e308, SCALLOP_ERANGE },
};

TEST(bad_input)
{
  for (const struct refused *f = refusals; f < refusals + sizeof refusals / sizeof *refusals; f++)
    FOR_KINDS (k)
      if (!f->make || k == kinds) {
        INTEGRATOR(integrator, f->make ? f->make(f->with) : k->make(k->coarse));
        check_refused(integrator, &f->crawler, f->v0, NULL, f->wanted);
      }
}

/* Lengths, times and forces in other units: powers of two, so every digit must stay; and nothing may be remembered of
 * the crawler before. */
TEST(other_units_and_crawlers)
{
  const struct units u = { .mass = 0x1p-300, .length = 0x1p200, .time = 0x1p-150 };
  struct scallop_crawler c = with_gait(&scallop_gait_sinusoidal), other = scallop_crawler_default();
  struct scallop_crawler d = in_units(&c, &u);
  other.T = 7;
  FOR_KINDS (k) {
    INTEGRATOR(integrator, k->make(k->sharp));
    struct scallop_integrator_period a = integrator_period(integrator, &c, 0.731);
    integrator_period(integrator, &other, -3.1);
    struct scallop_integrator_period b = integrator_period(integrator, &d, 0.731 * u.length / u.time), again;
    CHECK_EQUAL(b.v_mid, a.v_mid * u.length / u.time);
    CHECK_EQUAL(b.v_end, a.v_end * u.length / u.time);
    CHECK_EQUAL(b.displacement, a.displacement * u.length);
    assert_true(b.steps == a.steps && b.evaluations == a.evaluations);
    integrator_period(integrator, &other, -3.1);
    again = integrator_period(integrator, &c, 0.731);
    assert_memory_equal(&again, &a, sizeof again); /* doubles and longs, no padding */
  }
}

/* Friction far above what the gait asks for: one body never moves, and the other returns. A stuck body needs no
 * integration. */
TEST(at_rest)
{
  FOR_KINDS (k)
    for (int i = 0; i < 2 * SMOOTH_GAITS && isfinite(k->rest); i++)
      for (double with = k->make == moreau ? 1 : k->sharp; with <= k->sharp; with *= 8) {
        struct scallop_crawler c = with_gait(every_gait[i / 2]);
        c.F1 = i % 2 ? 4e5 : 1e3;
        c.F2 = i % 2 ? 1e3 : 4e5;
        INTEGRATOR(integrator, k->make(with));
        struct scallop_integrator_period p = integrator_period(integrator, &c, 0);
        assert_true(p.v_mid == 0 && p.v_end == 0 && (k->make == moreau || p.evaluations == 0));
        CHECK_NEAR(p.displacement, 0, k->rest * c.L);
      }
}

/* It ends at once, and touches nothing. With more than enough the answer is what it is without. */
TEST(patience_ends)
{
  const long enough = 1000000;
  struct scallop_crawler c = scallop_crawler_default();
  FOR_KINDS (k) {
    INTEGRATOR(integrator, k->make == smoothed ? scallop_smoothed_integrator(1e-2, 1e-6) : k->make(k->coarse));
    struct scallop_integrator_period patient, alone = integrator_period(integrator, &c, 1);
    long left = enough;
    PATIENCE(patience, left);
    assert_int_equal(integrator->period(integrator, &c, 1, &patience, &patient), SCALLOP_OK);
    long asked = enough - left;
    assert_true(k->make == moreau     ? asked == 12
                : k->make == smoothed ? asked <= patient.steps
                                      : 2 * asked > patient.steps); /* those that are rejected are not asked for */
    assert_memory_equal(&patient, &alone, sizeof alone);
    for (long most = 0; most < asked; most += most < k->questions ? k->step : 1 + asked / 7) {
      left = most;
      check_refused(integrator, &c, 1, &patience, SCALLOP_ESTOPPED);
      assert_int_equal(left, -1);
    }
    assert_true(integrator_period(integrator, &c, 1).v_end == alone.v_end); /* as good as new */
  }
}

/* Gaits that break their rules. To be smooth: no step across the jump is short enough. To be monotone: no end of
 * steps. To be there: no step into the hole is short enough. */
static double rough(const struct scallop_piece *p, double u) { return (void)p, u < 1 / 3.0 ? 1 : 1e20; }
static double restless(const struct scallop_piece *p, double u) { return (void)p, 1e6 * sin(1e8 * u); }
static double hole(const struct scallop_piece *p, double u) { return (void)p, u < 1 / 3.0 ? u : NAN; }

static const struct broken {
  struct scallop_integrator *(*make)(double with);
  double with;
  double (*velocity)(const struct scallop_piece *, double), (*acceleration)(const struct scallop_piece *, double);
  double at_0, slope, v0;
} broken[] = {
  { rkf45, 1e-9, NULL, rough, 1, 0, 100 },
  { rk8pd, 1e-9, NULL, rough, 1, 0, 100 },
  { rkf45, 1e-9, NULL, restless, 1, 0, 100 },
  { smoothed_over, 1e-3, hole, NULL, 0, 1, 1 },
  { scallop_cvode_integrator, 1e-9, NULL, rough, 1, 0, 100 },
  { scallop_cvode_integrator, 1e-9, NULL, rough, NAN, 0, 100 },
};

/* They fail, and in silence. */
TEST(no_convergence)
{
  struct said said;
  said_begin(&said);
  for (size_t i = 0; i < sizeof broken / sizeof *broken; i++) {
    struct odd_piece odd;
    if (broken[i].make == scallop_cvode_integrator && !scallop_has_cvode())
      continue;
    INTEGRATOR(integrator, broken[i].make(broken[i].with));
    struct scallop_crawler c = with_gait(odd_gait(&odd, broken[i].velocity, broken[i].acceleration));
    odd.piece.velocity = broken[i].at_0;
    odd.piece.acceleration = broken[i].slope;
    check_refused(integrator, &c, broken[i].v0, NULL, SCALLOP_ECONVERGE);
  }
  assert_string_equal(said_end(&said), "");
}

/* What a steady state is off by is the error of a period over 1 - multiplier. Of the first two crawlers nothing tells
 * forward from backward; of one body 1 sticks in each period, and forgets. The others slide, and stick. */
TEST(steady_states)
{
  struct random r = { 2718 };
  int regimes[3] = { 0 };
  for (int i = 0; i < 24; i++) {
    struct scallop_crawler c = { 2.3, 0.9, 1.7, 1.7, 3.1, 1.2, 0.5, every_gait[i % 2] };
    if (i == 2)
      c = (struct scallop_crawler){ 1, 1, 4, 1, 10, 6, 0.75, &scallop_gait_sinusoidal };
    if (i > 2) {
      c = random_crawler(&r, i % 2 ? STICK_SLIP : ORDINARY, every_gait[i / 2 % 2]);
      c.alpha = random_between(&r, 0.2, 0.8);
      set_eps(&c, i % 2 ? random_decades(&r, 1, 300) : random_decades(&r, 0.1, 1));
    }
    struct scallop_period_result p = steady_of(&c).period;
    regimes[p.regime]++;
    FOR_KINDS (k)
      if (k->steady > 0) {
        INTEGRATOR(integrator, k->make(k->sharp));
        check_steady(integrator, &c, random_start(&r, &c, SCALLOP_EXTENSION), k->sharp,
                     k->steady * (fastest_l(&c) + fabs(p.v_start)) / (1 - p.multiplier));
      }
  }
  assert_true(regimes[0] >= 3 && regimes[1] >= 3 && regimes[2] >= 3);
}

int main(void)
{
  gsl_set_error_handler_off();
  return check_run(NULL, NULL);
}
