/* The building blocks of `stress --stiff`: certified scenes, creep where a body is stuck against what is measured, the
 * order in delta, and what is said when a stepper gives up. */
#include <float.h>

#include <gsl/gsl_errno.h>

#include "asymptotics/observed/order.h"
#include "compare/stress/stiff.h"
#include "numerics/integrators/integrator.h"
#include "tests/support/random_crawler.h"
#include "tests/support/solved.h"

enum { LONG = 100000, DECADES = 6 };

static const double pi = 3.14159265358979323846;

/* T = 4: body 1 sticks. */
static struct scallop_crawler sticking(int gait)
{
  struct scallop_crawler c = with_gait(every_gait[gait]);
  c.T = 4;
  return c;
}

static struct stiff_scene scene_of(const struct scallop_crawler *c)
{
  struct stiff_scene scene;
  assert_null(stiff_scene_init(&scene, "made up", c));
  assert_string_equal(scene.names[0], "made up");
  return scene;
}

static struct stiff_result run_of(const struct stiff_scene *scene, int digits, double tolerance, long steps)
{
  struct stiff_result run;
  double delta = pow(10, -digits);
  stiff_solve(scene, delta, tolerance > 0 ? tolerance : stiff_tolerance(delta), steps, &run);
  return run;
}

/* High is what the double solver gives, and low is what it cannot: less than an ulp, and not just 0. */
TEST(certified_values)
{
  for (int i = 0; i < 4; i++) {
    struct scallop_crawler c = sticking(i % 2);
    c.T = i < 2 ? 1 : 4;
    struct stiff_scene scene = scene_of(&c);
    struct scallop_period_result exact = period_of(&c, scene.v_start);
    CHECK_NEAR(exact.v_end, scene.v_end.high, 1e-14 * c.L / c.T);
    CHECK_NEAR(exact.displacement, scene.displacement.high, 1e-14 * c.L);
    CHECK_NEAR(scene.v_start, scene.v_end.high, 1e-14 * c.L / c.T);
    const struct scallop_wide *values[] = { &scene.v_end, &scene.displacement };
    for (int k = 0; k < 2; k++) {
      assert_true(values[k]->low != 0);
      CHECK_AT_MOST(fabs(values[k]->low), 0.5 * DBL_EPSILON * fabs(values[k]->high));
    }
    CHECK_RELATIVE(scene.scaled.eps, 5 * c.T * c.T / 20, 4 * DBL_EPSILON);
    assert_string_equal(scene.names[2], i < 2 ? "sliding" : "stick-slip");
    assert_int_equal(scene.stuck.body, i < 2 ? 0 : 1);
  }
}

/* By hand: while body 1 is stuck the mechanism pulls it with -(m2 l'' + F2). l'' = -40/9 in the second half of the
 * quadratic extension, which lasts 3, and that is to its end. Sinusoidal, l'' = (5 pi^2/9) cos(pi t/3): it is let go
 * when the force has grown to its friction, -l'' = 5. */
static double sinusoidal_creep(double t) { return atanh((-5 * pi * pi / 9 * cos(pi * t / 3) - 1) / 4); }

TEST(held_by_hand)
{
  enum { PARTS = 200000 };
  struct scallop_crawler quadratic = sticking(0), sinusoidal = sticking(1);
  struct stiff_scene scene = scene_of(&quadratic);
  struct stiff_interval held = scene.stuck;
  const double force = (40 / 9.0 - 1) / 4;
  assert_int_equal(held.phase, SCALLOP_EXTENSION);
  CHECK_EQUAL(held.v0, scene.v_start);
  CHECK_RELATIVE(held.end, 3, 1e-14);
  CHECK_RELATIVE(held.force, force, 1e-13);
  CHECK_RELATIVE(held.velocity, atanh(force), 1e-12);
  CHECK_RELATIVE(held.creep, atanh(force) * (3 - held.begin) / 4, 1e-12);
  held = scene_of(&sinusoidal).stuck;
  double sum = 0, part = (held.end - held.begin) / PARTS;
  for (int i = 0; i < PARTS; i++)
    sum += sinusoidal_creep(held.begin + (i + 0.5) * part) * part;
  CHECK_RELATIVE(held.end, 3 / pi * acos(-9 / (pi * pi)), 1e-12);
  CHECK_RELATIVE(held.velocity, sinusoidal_creep((held.begin + held.end) / 2), 1e-12);
  CHECK_RELATIVE(held.creep, sum / 4, 1e-5);
}

/* The bodies exchanged, and the phases too: everything has the other sign. */
TEST(held_in_a_mirror)
{
  for (int i = 0; i < 2; i++) {
    struct scallop_crawler c = sticking(i), d = exchanged(&c);
    struct stiff_interval a = scene_of(&c).stuck, b = scene_of(&d).stuck;
    assert_true(a.body == 1 && b.body == 2 && b.phase == SCALLOP_EXTENSION);
    CHECK_RELATIVE(b.creep, -a.creep, 1e-9);
    CHECK_RELATIVE(b.velocity, -a.velocity, 1e-12);
    c.alpha = 0.25; /* the phases only: stuck in the contraction, as long, and as fast to the other side */
    struct stiff_interval late = scene_of(&c).stuck;
    assert_true(late.body == 1 && late.phase == SCALLOP_CONTRACTION);
    CHECK_RELATIVE(late.creep, -a.creep, 1e-9);
    CHECK_RELATIVE(late.end - late.begin, a.end - a.begin, 1e-12);
  }
}

/* Body 1 never moves. Quadratic, over both halves of the longer phase, whichever that is: l'' = +-4/90 and the signs of
 * a contraction. */
TEST(held_all_the_time)
{
  const double halves = atanh(-(4 / 90.0 + 1) / 4) + atanh((4 / 90.0 - 1) / 4);
  for (int i = 0; i < 2; i++) {
    struct scallop_crawler c = sticking(0);
    c.T = 40;
    c.alpha = i == 0 ? 0.75 : 0.25;
    struct stiff_scene scene = scene_of(&c);
    assert_string_equal(scene.names[2], "at-rest");
    assert_int_equal(scene.stuck.phase, i == 0 ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION);
    CHECK_EQUAL(scene.stuck.begin, 0);
    CHECK_RELATIVE(scene.stuck.end, 30, 1e-14);
    CHECK_RELATIVE(scene.stuck.creep, (i == 0 ? 1 : -1) * halves * 15 / 40, 1e-9);
  }
}

TEST(errors_are_the_periods)
{
  struct scallop_crawler c = sticking(1);
  struct stiff_scene scene = scene_of(&c);
  struct stiff_result run = run_of(&scene, 3, 1e-9, LONG);
  struct scallop_integrator_period period[2], p, looser;
  for (int k = 0; k < 2; k++) {
    struct scallop_integrator *integrator = scallop_smoothed_integrator(1e-3, k == 0 ? 1e-9 : 1e-8);
    assert_int_equal(integrator->period(integrator, &c, scene.v_start, NULL, &period[k]), SCALLOP_OK);
    scallop_integrator_destroy(integrator);
  }
  p = period[0];
  looser = period[1];
  CHECK_NEAR(run.error[STIFF_V_END], (p.v_end - scene.v_start) * c.T / c.L, 1e-14);
  CHECK_NEAR(run.error[STIFF_DISPLACEMENT], (p.displacement - scene.displacement.high) / c.L, 1e-15);
  CHECK_NEAR(run.own_error[STIFF_V_END], fabs(p.v_end - looser.v_end) * c.T / c.L, 1e-15);
  CHECK_EQUAL(run.steps, (double)p.steps);
  CHECK_EQUAL(run.evaluations, (double)p.evaluations);
  assert_string_equal(run.status, "ok");
}

/* What is left against the prediction is of a higher order in delta. */
TEST(creep_is_as_predicted)
{
  for (int i = 0; i < 8; i++) {
    struct scallop_crawler c = sticking(i % 2);
    c.alpha = i & 2 ? 0.75 : 0.25;
    c = i & 4 ? exchanged(&c) : c;
    struct stiff_scene scene = scene_of(&c);
    double before = INFINITY;
    for (int digits = 3; digits <= 6; digits++) {
      struct stiff_result run = run_of(&scene, digits, 0, LONG);
      double delta = run.delta;
      double off = fabs(run.error[STIFF_CREEP] / delta / scene.stuck.creep - 1);
      CHECK_AT_MOST(off, 2 * sqrt(delta));
      CHECK_NEAR(run.velocity, scene.stuck.velocity, 20 * delta);
      CHECK_AT_MOST(off, 0.5 * before);
      before = off;
    }
  }
}

/* A body that is let go gradually leaves at v_delta/4 ln(1/delta) and a constant; one that is let go by a jump, at its
 * creep. */
TEST(last_velocity)
{
  for (int gradual = 0; gradual < 2; gradual++) {
    struct scallop_crawler c = sticking(gradual);
    struct stiff_scene scene = scene_of(&c);
    double before = NAN;
    for (int digits = 5; digits <= 8; digits++) {
      struct stiff_result run = run_of(&scene, digits, 0, LONG);
      if (!gradual)
        CHECK_NEAR(run.last, run.velocity, 0.01);
      else if (digits > 5)
        CHECK_NEAR((run.last - before) / log(10), 0.25, 0.003);
      before = run.last;
    }
  }
}

static bool count(void *context)
{
  ++*(long *)context;
  return true;
}

/* As many steps as it takes are enough, and one less is not. A scene that cannot be is refused. */
TEST(what_gives_up)
{
  struct scallop_crawler c = sticking(0);
  struct stiff_scene scene = scene_of(&c);
  struct scallop_integrator *integrator = scallop_smoothed_integrator(1e-3, 1e-9);
  struct scallop_integrator_period p;
  long steps = 0;
  const struct scallop_patience patience = { count, &steps };
  assert_int_equal(integrator->period(integrator, &c, scene.v_start, &patience, &p), SCALLOP_OK);
  scallop_integrator_destroy(integrator);
  assert_true(run_of(&scene, 3, 1e-9, steps).solved);
  assert_false(run_of(&scene, 3, 1e-9, steps - 1).solved);
  struct stiff_result run = run_of(&scene, 3, 1e-9, 100);
  assert_false(run.solved);
  assert_string_equal(run.status, "cut off after 100 accepted steps");
  CHECK_EQUAL(run.steps, NAN);
  for (int i = 0; i < STIFF_QUANTITIES; i++)
    CHECK_EQUAL(run.error[i], NAN);
  assert_false(run_of(&scene, 3, 1, LONG).solved); /* not a tolerance */
  c.T = 1e-200;
  assert_non_null(stiff_scene_init(&scene, "too short", &c));
  c.T = 1;
  c.alpha = 1;
  assert_non_null(stiff_scene_init(&scene, "no alpha", &c));
}

TEST(order_of_the_model)
{
  const struct scallop_order_wanted wanted = { .order = 1, .tolerance = 0.1 };
  for (int i = 0; i < 4; i++) {
    struct scallop_crawler c = sticking(i % 2);
    c.T = i < 2 ? 1 : 4;
    struct stiff_scene scene = scene_of(&c);
    struct stiff_result runs[DECADES];
    for (int k = 0; k < DECADES; k++)
      runs[k] = run_of(&scene, 1 + k, 0, LONG);
    for (int quantity = 0; quantity < (i < 2 ? STIFF_CREEP : STIFF_QUANTITIES); quantity++) {
      struct scallop_order_point points[DECADES];
      struct scallop_order_result fit;
      int count = DECADES;
      for (int k = 0; k < DECADES; k++) {
        points[k] = (struct scallop_order_point){ .h = runs[k].delta, .err = runs[k].error[quantity] };
        CHECK_AT_MOST(runs[k].own_error[quantity], 0.1 * fabs(runs[k].error[quantity]));
      }
      scallop_order(points, &count, &wanted, &fit);
      print_message("%s, T = %g: order %.4f (%.4f to %.4f)\n", c.gait->name, c.T, fit.order, fit.low, fit.high);
      CHECK_NEAR(fit.order, 1, i == 3 ? 0.09 : 0.01); /* a logarithm in the last of them */
      assert_int_equal(fit.verdict, SCALLOP_ORDER_PASS);
    }
  }
}

int main(void)
{
  gsl_set_error_handler_off();
  return check_run(NULL, NULL);
}
