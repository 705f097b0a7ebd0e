/* Motions with gaits of every kind that model.h allows: that they are gaits, what integrators make of them, what
 * becomes of more modes than are kept, and of very many pieces. The solvers against each other: test_agree.c. */
#include <float.h>

#include "numerics/integrators/integrator.h"
#include "tests/support/agree.h"
#include "tests/support/columns.h"
#include "tests/support/odd_gaits.h"

enum { ODD = 8 };
static struct teeth teeth;
static struct scallop_gait curved_last;
static const struct scallop_gait *const odd_gaits[ODD] = { &there_and_back_gait, &detour_gait, &teeth.gait,
                                                           &pause_gait,          &wait_gait,   &hesitant_gait,
                                                           &curved_last,         &stride_gait };

static int make_gaits(void **state)
{
  (void)state;
  grow_teeth(&teeth);
  curved_last = mixed_gait(&scallop_gait_quadratic, &scallop_gait_sinusoidal);
  return 0;
}

/* Each phase gains the amplitude, and l' is the derivative of l. */
TEST(gaits_are_gaits)
{
  enum { PLACES = 64 }; /* ends of pieces are at multiples of 1/32 */
  for (int g = 0; g < ODD; g++)
    for (int kind = 0; kind < 2; kind++) {
      const enum scallop_phase_kind k = (enum scallop_phase_kind)kind;
      double l, next, v, length = kind == SCALLOP_EXTENSION ? 0 : 1;
      scallop_gait_at(odd_gaits[g], k, 0, &l, NULL, NULL);
      CHECK_NEAR(l, length, 1e-15);
      scallop_gait_at(odd_gaits[g], k, 1, &l, NULL, NULL);
      CHECK_NEAR(l, 1 - length, 1e-15);
      for (int i = 0; i < PLACES; i++) {
        double s = (i + 0.5) / PLACES, h = 1e-4;
        scallop_gait_at(odd_gaits[g], k, s - h, &l, NULL, NULL);
        scallop_gait_at(odd_gaits[g], k, s + h, &next, NULL, NULL);
        scallop_gait_at(odd_gaits[g], k, s, NULL, &v, NULL);
        CHECK_NEAR((next - l) / (2 * h), v, 1e-6);
      }
    }
}

/* With phases of one duration a gait leads nowhere if the contraction does the opposite of the extension, and detour
 * does not, though |l'| is the same. */
TEST(the_same_speeds_in_other_directions)
{
  const struct unit unit = { 10, 10, 1, 1 };
  const struct allowed allowed = { { 1e-12, 0, 1e-27 } };
  for (int i = 0; i < 2; i++) {
    struct scallop_crawler c = with_gait(i == 0 ? &there_and_back_gait : &detour_gait);
    c.alpha = 0.5;
    const struct motion m = steady_motion(&c);
    agree(&m, &unit, &allowed);
    double displacement = steady_of(&c).period.displacement;
    assert_true(i == 0 ? displacement == 0 : fabs(displacement) >= 1e-5 * c.L);
  }
}

TEST(integrators)
{
  struct random r = { 20261105 };
  struct scallop_integrator *integrator[2] = { scallop_odeiv_integrator(SCALLOP_ODEIV_RK8PD, 1e-11),
                                               scallop_cvode_integrator(1e-11) };
  for (int i = 0; i < check_cases(30 * ODD); i++) {
    struct scallop_crawler c = random_crawler(&r, i / ODD % 4 ? ORDINARY : STICK_SLIP, odd_gaits[i % ODD]);
    double v0 = random_start(&r, &c, SCALLOP_EXTENSION), unit = c.L / (c.T * fmin(c.alpha, 1 - c.alpha)) + fabs(v0);
    struct scallop_period_result exact = period_of(&c, v0);
    for (int k = 0; k < 2 && integrator[k]; k++) {
      struct scallop_integrator_period got;
      assert_int_equal(integrator[k]->period(integrator[k], &c, v0, NULL, &got), SCALLOP_OK);
      CHECK_NEAR(got.v_mid, exact.v_mid, 1e-7 * unit);
      CHECK_NEAR(got.v_end, exact.v_end, 1e-7 * unit);
      CHECK_NEAR(got.displacement, exact.displacement, 1e-7 * unit * c.T);
    }
  }
  for (int k = 0; k < 2; k++)
    scallop_integrator_destroy(integrator[k]);
}

static void count_mode(void *context, const struct scallop_interval *interval)
{
  struct scallop_modes *m = context;
  struct scallop_mode *last = &m->kept[1];
  if (m->count == 0 || last->s1 != interval->mode.s1 || last->s2 != interval->mode.s2)
    m->count++;
  *last = interval->mode;
}

/* All are counted; the text has the first ones, "...", and the last. */
TEST(modes_beyond_those_kept)
{
  struct scallop_crawler c = with_gait(&teeth.gait);
  struct scallop_modes counted = { .count = 0 };
  char text[SCALLOP_MODES_TEXT];
  SCOPED(scallop_certified_phase, exact);
  c.F1 = c.F2 = 0.1;
  certify_phase(&exact, &c, SCALLOP_EXTENSION, 5, 30);
  struct scallop_phase_result d = phase_of(&c, SCALLOP_EXTENSION, 5);
  assert_int_equal(scallop_phase_intervals(&c, SCALLOP_EXTENSION, 5, count_mode, &counted), SCALLOP_OK);
  assert_true(d.modes.count == 2 * TEETH + 1 && counted.count == d.modes.count && modes_alike(&exact.modes, &d.modes));
  scallop_modes_text(&d.modes, text);
  assert_int_equal(strlen(text), 3 * SCALLOP_MODES_KEPT - 1 + strlen("... "));
  assert_memory_equal(text, "++ -+ ++ -+ ", strlen("++ -+ ++ -+ "));
  assert_string_equal(text + strlen(text) - strlen("++ ... ++"), "++ ... ++");
}

/* A batch has the modes that one at a time has, all of them where there are more than it keeps. */
TEST(batch)
{
  enum { COUNT = 40 };
  struct random r = { 20261103 };
  static struct columns in;
  double v_start[COUNT];
  enum scallop_status status[COUNT];
  static struct scallop_modes modes[COUNT][2];
  int many = 0;
  for (int i = 0; i < COUNT; i++) {
    struct scallop_crawler c = random_crawler(&r, ORDINARY, i < COUNT / 2 ? &curved_last : &teeth.gait);
    set_eps(&c, random_decades(&r, 1e-3, 1));
    columns_put(&in, i, &c);
  }
  const struct scallop_crawlers all = columns_all(&in, COUNT);
  struct scallop_steady_states out = { .v_start = v_start, .modes = modes, .status = status };
  assert_int_equal(scallop_steady_batch(&all, &out, 1), 0);
  for (int i = 0; i < COUNT; i++) {
    const struct scallop_crawler c = columns_row(&in, i);
    struct scallop_steady_result one;
    assert_int_equal(scallop_steady(&c, &one), status[i]);
    CHECK_EQUAL(v_start[i], one.period.v_start);
    assert_true(same_modes(modes[i], one.period.modes));
    many += modes[i][0].count > SCALLOP_MODES_KEPT;
  }
  assert_true(many > 0);
}

static void check_same_phase(const struct scallop_phase_result *a, const struct scallop_phase_result *b, double way,
                             double tau, double ulps)
{
  assert_true(a->modes.count == b->modes.count && a->regime == b->regime);
  CHECK_RELATIVE(a->t1, b->t1, 2 * ulps * DBL_EPSILON);
  CHECK_RELATIVE(a->dT, b->dT, 8 * ulps * DBL_EPSILON);
  CHECK_NEAR(a->v_end, b->v_end, ulps * DBL_EPSILON * way / tau);
  CHECK_NEAR(a->dx1, b->dx1, ulps * DBL_EPSILON * way);
  CHECK_NEAR(a->dx2, b->dx2, ulps * DBL_EPSILON * way);
  CHECK_NEAR(a->dxC, b->dxC, ulps * DBL_EPSILON * way);
}

/* A phase does not know what the other one is like. */
TEST(phases_of_two_kinds)
{
  struct random r = { 20261104 };
  for (int i = 0; i < check_cases(50); i++) {
    struct scallop_crawler mixed = random_crawler(&r, ORDINARY, &curved_last), pure = mixed;
    for (int kind = 0; kind < 2; kind++) {
      double v0 = random_start(&r, &mixed, (enum scallop_phase_kind)kind);
      pure.gait = kind == SCALLOP_EXTENSION ? &scallop_gait_quadratic : &scallop_gait_sinusoidal;
      struct scallop_phase_result a = phase_of(&mixed, kind, v0), b = phase_of(&pure, kind, v0);
      check_same_phase(&a, &b, 1, 1, 0);
    }
  }
}

/* The quadratic gait in very many pieces: the error does not grow with them, nor do the modes change. */
enum { CUTS = 512 }; /* of each half of a phase */

TEST(cut_up_it_is_the_same)
{
  static struct scallop_piece pieces[2][2 * CUTS];
  struct scallop_gait cut = scallop_gait_quadratic;
  struct random r = { 20261301 };
  for (int kind = 0; kind < 2; kind++) {
    struct scallop_shape *shape = &cut.phase[kind];
    for (int i = 0; i < 2 * CUTS; i++) {
      bool late = i >= CUTS;
      struct scallop_piece *p = &pieces[kind][i];
      *p = shape->pieces[late];
      p->begin = (late ? 2 * CUTS - i : i) * (0.5 / CUTS);
      p->end = (late ? 2 * CUTS - i - 1 : i + 1) * (0.5 / CUTS);
    }
    shape->pieces = pieces[kind];
    shape->count = 2 * CUTS;
    shape->concave = shape->ramps = false;
  }
  for (int i = 0; i < 400; i++) {
    struct scallop_crawler c = random_crawler(&r, i % 4 == 0 ? STICK_SLIP : ORDINARY, &scallop_gait_quadratic);
    enum scallop_phase_kind kind = random_below(&r, 2) ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
    double v0 = random_start(&r, &c, kind), tau = scallop_phase_duration(&c, kind);
    struct scallop_phase_result whole = phase_of(&c, kind, v0);
    c.gait = &cut;
    struct scallop_phase_result parts = phase_of(&c, kind, v0);
    double way = c.L + (fabs(v0) + (c.F1 + c.F2) * tau / (c.m1 + c.m2)) * tau;
    check_same_phase(&parts, &whole, way, tau, 2);
  }
}

int main(void) { return check_run(make_gaits, NULL); }
