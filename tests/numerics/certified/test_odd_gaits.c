/* Motions with gaits of every kind that model.h allows: the exact solver against the certified one, which is written
 * apart from it, and what becomes of more modes than are kept. */
#include "numerics/rivals/rival.h"
#include "tests/support/certified_balls.h"
#include "tests/support/columns.h"
#include "tests/support/odd_gaits.h"

enum { ODD = 10, DIGITS = 30 };
static const double TOLERANCE = 1e-12;
static struct teeth teeth;
static struct scallop_gait curved_first, curved_last, jerk_last;
static const struct scallop_gait *const odd_gaits[ODD] = { &there_and_back_gait, &detour_gait, &teeth.gait,
                                                           &pause_gait,          &wait_gait,   &hesitant_gait,
                                                           &curved_first,        &curved_last, &jerk_last,
                                                           &stride_gait };
enum { CONTINUOUS = 9 }; /* the first of them */

static int make_gaits(void **state)
{
  (void)state;
  grow_teeth(&teeth);
  curved_first = mixed_gait(&scallop_gait_sinusoidal, &scallop_gait_quadratic);
  curved_last = mixed_gait(&scallop_gait_quadratic, &scallop_gait_sinusoidal);
  jerk_last = mixed_gait(&scallop_gait_quadratic, &minimum_jerk_gait);
  return 0;
}

/* Each phase gains the amplitude, and l' is the derivative of l. */
TEST(gaits_are_gaits)
{
  enum { PLACES = 64 }; /* ends of pieces are at multiples of 1/32 */
  for (int g = 0; g < ODD; g++)
    for (int kind = 0; kind < 2; kind++) {
      double l, next, v, length = kind == SCALLOP_EXTENSION ? 0 : 1;
      scallop_gait_at(odd_gaits[g], (enum scallop_phase_kind)kind, 0, &l, NULL, NULL);
      CHECK_NEAR(l, length, 1e-15);
      scallop_gait_at(odd_gaits[g], (enum scallop_phase_kind)kind, 1, &l, NULL, NULL);
      CHECK_NEAR(l, 1 - length, 1e-15);
      for (int i = 0; i < PLACES; i++) {
        double s = (i + 0.5) / PLACES, h = 1e-4;
        scallop_gait_at(odd_gaits[g], (enum scallop_phase_kind)kind, s - h, &l, NULL, NULL);
        scallop_gait_at(odd_gaits[g], (enum scallop_phase_kind)kind, s + h, &next, NULL, NULL);
        scallop_gait_at(odd_gaits[g], (enum scallop_phase_kind)kind, s, NULL, &v, NULL);
        CHECK_NEAR((next - l) / (2 * h), v, 1e-6);
      }
    }
}

/* Where rounding is not magnified: ordinary crawlers, some of them stuck for a while, some with equal forces */
static struct scallop_crawler draw(struct random *r, int i, const struct scallop_gait *gait)
{
  static const enum family families[] = { STICK_SLIP, ORDINARY, ORDINARY, EQUAL_FORCES };
  return random_crawler(r, families[i / ODD % 4], gait);
}

/* The same number of them, and the same ones as far as they are kept */
static void check_modes(const struct scallop_modes *certified, const struct scallop_modes *got,
                        enum scallop_regime wanted, enum scallop_regime regime, const struct scallop_crawler *c,
                        double v0)
{
  char one[SCALLOP_MODES_TEXT], other[SCALLOP_MODES_TEXT];
  int kept = got->count <= SCALLOP_MODES_KEPT ? got->count : SCALLOP_MODES_KEPT;
  if (wanted == regime && certified->count == got->count
      && memcmp(certified->kept, got->kept, (size_t)kept * sizeof *got->kept) == 0)
    return;
  scallop_modes_text(certified, one);
  scallop_modes_text(got, other);
  print_crawler(c);
  print_error("v0=%.17g: %d %s, %s certified; %d %s, %s in doubles\n", v0, certified->count, one,
              scallop_regime_text(wanted), got->count, other, scallop_regime_text(regime));
  fail();
}

static void compare_phase(const struct scallop_crawler *c, enum scallop_phase_kind kind, double v0)
{
  struct scallop_phase_result d = phase_of(c, kind, v0);
  double tau = scallop_phase_duration(c, kind), way = TOLERANCE * (c->L + fabs(v0) * tau);
  SCOPED(scallop_certified_phase, r);
  certify_phase(&r, c, kind, v0, DIGITS);
  check_modes(&r.modes, &d.modes, r.regime, d.regime, c, v0);
  if (r.switches) {
    check_number(d.t1, r.t1, TOLERANCE * tau, c, "t1");
    check_number(d.dT, r.dT, TOLERANCE * tau, c, "dT");
  }
  check_number(d.v_end, r.v_end, way / tau, c, "v_end");
  check_number(d.dx1, r.dx1, way, c, "dx1");
  check_number(d.dx2, r.dx2, way, c, "dx2");
  check_number(d.dxC, r.dxC, way, c, "dxC");
}

TEST(phases)
{
  struct random r = { 20261101 };
  for (int i = 0; i < check_cases(60 * ODD); i++) {
    struct scallop_crawler c = draw(&r, i, odd_gaits[i % ODD]);
    enum scallop_phase_kind kind = random_below(&r, 2) ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
    compare_phase(&c, kind, random_start(&r, &c, kind));
  }
}

static void compare_steady(const struct scallop_crawler *c)
{
  struct scallop_steady_result d = steady_of(c);
  SCOPED(scallop_certified_steady, r);
  certify_steady(&r, c, DIGITS);
  for (int kind = 0; kind < 2; kind++)
    check_modes(&r.modes[kind], &d.period.modes[kind], r.regime, d.period.regime, c, middle(r.v_start));
  check_number(d.period.v_start, r.v_start, TOLERANCE * c->L / c->T, c, "v_start");
  check_number(d.period.v_mid, r.v_mid, TOLERANCE * c->L / c->T, c, "v_mid");
  check_number(d.period.displacement, r.displacement, TOLERANCE * c->L, c, "displacement");
  check_number(d.period.multiplier, r.multiplier, TOLERANCE, c, "multiplier");
}

TEST(steady_states)
{
  struct random r = { 20261102 };
  for (int i = 0; i < check_cases(24 * CONTINUOUS); i++) {
    struct scallop_crawler c = draw(&r, i, odd_gaits[i % CONTINUOUS]);
    compare_steady(&c);
  }
}

/* With phases of one duration a gait leads nowhere if the contraction does the opposite of the extension, and detour
 * does not, though |l'| is the same. */
TEST(the_same_speeds_in_other_directions)
{
  struct scallop_crawler c = with_gait(&there_and_back_gait);
  c.alpha = 0.5;
  compare_steady(&c);
  struct scallop_steady_result d = steady_of(&c);
  CHECK_EQUAL(d.period.displacement, 0);
  c.gait = &detour_gait;
  compare_steady(&c);
  d = steady_of(&c);
  CHECK_AT_MOST(1e-5 * c.L, fabs(d.period.displacement));
}

TEST(rivals)
{
  struct random r = { 20261105 };
  struct scallop_rival *rival[2] = { scallop_odeiv_rival(SCALLOP_ODEIV_RK8PD, 1e-11), scallop_cvode_rival(1e-11) };
  for (int i = 0; i < check_cases(30 * ODD); i++) {
    struct scallop_crawler c = draw(&r, i, odd_gaits[i % ODD]);
    double unit = c.L / (c.T * fmin(c.alpha, 1 - c.alpha)), v0 = random_start(&r, &c, SCALLOP_EXTENSION);
    struct scallop_period_result exact = period_of(&c, v0);
    for (int k = 0; k < 2 && rival[k]; k++) {
      struct scallop_rival_period got;
      assert_int_equal(rival[k]->period(rival[k], &c, v0, NULL, &got), SCALLOP_OK);
      CHECK_NEAR(got.v_mid, exact.v_mid, 1e-7 * (unit + fabs(v0)));
      CHECK_NEAR(got.v_end, exact.v_end, 1e-7 * (unit + fabs(v0)));
      CHECK_NEAR(got.displacement, exact.displacement, 1e-7 * (unit + fabs(v0)) * c.T);
    }
  }
  for (int k = 0; k < 2; k++)
    scallop_rival_destroy(rival[k]);
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
  c.F1 = c.F2 = 0.1;
  compare_phase(&c, SCALLOP_EXTENSION, 5);
  struct scallop_phase_result d = phase_of(&c, SCALLOP_EXTENSION, 5);
  assert_int_equal(scallop_phase_intervals(&c, SCALLOP_EXTENSION, 5, count_mode, &counted), SCALLOP_OK);
  assert_int_equal(d.modes.count, 2 * TEETH + 1);
  assert_int_equal(counted.count, d.modes.count);
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
  assert_int_equal(
      scallop_steady_batch(&all,
                           &(struct scallop_steady_states){ .v_start = v_start, .modes = modes, .status = status }, 1),
      0);
  for (int i = 0; i < COUNT; i++) {
    const struct scallop_crawler c = columns_row(&in, i);
    struct scallop_steady_result one;
    assert_int_equal(scallop_steady(&c, &one), status[i]);
    CHECK_EQUAL(v_start[i], one.period.v_start);
    for (int kind = 0; kind < 2; kind++) {
      const struct scallop_modes *wanted = &one.period.modes[kind], *got = &modes[i][kind];
      int kept = wanted->count < SCALLOP_MODES_KEPT ? wanted->count : SCALLOP_MODES_KEPT;
      assert_int_equal(got->count, wanted->count);
      assert_memory_equal(got->kept, wanted->kept, (size_t)kept * sizeof *got->kept);
      many += wanted->count > SCALLOP_MODES_KEPT;
    }
  }
  assert_true(many > 0);
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
      struct scallop_phase_result a = phase_of(&mixed, kind, v0);
      struct scallop_phase_result b = phase_of(&pure, kind, v0);
      CHECK_EQUAL(a.v_end, b.v_end);
      CHECK_EQUAL(a.dxC, b.dxC);
      CHECK_EQUAL(a.t1, b.t1);
      CHECK_EQUAL(a.dT, b.dT);
    }
  }
}

int main(void) { return check_run(make_gaits, NULL); }
