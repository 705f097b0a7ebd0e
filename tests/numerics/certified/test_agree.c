/* Tables of crawlers, each solved in double, long double, binary128 and balls (tests/support/agree.h): of every family,
 * with gaits of every kind that model.h allows. The certified solver is written apart from the others. */
#include <float.h>

#include "compare/points/gaits.h"
#include "tests/support/agree.h"
#include "tests/support/odd_gaits.h"
#include "tests/support/random_gait.h"
#include "tests/support/random_rises.h"

static struct teeth teeth;
static struct scallop_gait curved_first, curved_last, jerk_last;
static struct random_gait made;
static struct scallop_polynomial made_far;
static struct rises made_rises;

/* A phase of the crawler from any start */
static struct motion any_phase(struct random *r, const struct scallop_crawler *c)
{
  enum scallop_phase_kind kind = random_below(r, 2) ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
  return phase_motion(c, kind, random_start(r, c, kind));
}

/* Gaits whose l' changes its sign, rests or jumps within a phase, with more modes than are kept, and with phases of two
 * kinds; all but the last have a steady state to certify. Where rounding is not magnified: ordinary crawlers, some of
 * them stuck for a while, some with equal forces */
enum { ODD = 12, CONTINUOUS = 11 };
static const struct scallop_gait *const odd_gaits[ODD] = { &there_and_back_gait, &detour_gait, &teeth.gait,
                                                           &pause_gait,          &wait_gait,   &hesitant_gait,
                                                           &curved_first,        &curved_last, &jerk_last,
                                                           &leaning_gait,        &ramps_gait,  &stride_gait };
static struct motion of_odd_gait(struct random *r, int i)
{
  static const enum family families[] = { STICK_SLIP, ORDINARY, ORDINARY, EQUAL_FORCES };
  bool steady = i % 4 == 0;
  struct scallop_crawler c = random_crawler(r, families[i / ODD % 4], odd_gaits[i / 4 % (steady ? CONTINUOUS : ODD)]);
  return steady ? steady_motion(&c) : any_phase(r, &c);
}

/* Of every family and gait, five phases for each steady state */
static struct motion of_any_gait(struct random *r, int i)
{
  bool steady = i % 6 == 0;
  int gaits = steady ? SMOOTH_GAITS : ALL_GAITS;
  struct scallop_crawler c = random_crawler(r, (enum family)(i / 6 / gaits % FAMILIES), every_gait[i / 6 % gaits]);
  return steady ? steady_motion(&c) : any_phase(r, &c);
}

static struct motion steady_of_papers_gait(struct random *r, int i)
{
  const struct scallop_crawler c = random_crawler(r, (enum family)(i / 2 % FAMILIES), every_gait[i % 2]);
  return steady_motion(&c);
}

/* Gaits of families, steady states and phases in turn */
static struct motion of_made_gait(struct random *r, int i)
{
  static const enum family families[] = {
    ORDINARY, STICK_SLIP, EQUAL_FORCES, EXTREME_RATIOS, SMALL_PERIOD, ALPHA_EDGE
  };
  const struct scallop_gait *gait = random_gait(r, (enum random_gait_kind)(i / 2 % WITHOUT_TURN), &made);
  struct scallop_crawler c = random_crawler(r, families[i / 2 / WITHOUT_TURN % 6], gait);
  return i % 2 ? any_phase(r, &c) : steady_motion(&c);
}

/* l' changes its sign within a phase. */
static struct motion of_turning_gait(struct random *r, int i)
{
  const struct scallop_gait *gait = random_gait(r, i % 2 ? TURNING_SPLINE : TURNING_POLYNOMIAL, &made);
  struct scallop_crawler c = random_crawler(r, i % 3 ? ORDINARY : STICK_SLIP, gait);
  return steady_motion(&c);
}

/* l goes back further than its amplitude, or hardly at all: the ways of the pieces add up to the amplitude all the
 * same. */
static struct motion of_far_turning_gait(struct random *r, int i)
{
  struct scallop_crawler c = with_gait(i / 2 < FAR_TURNING ? gait_of_text(far_turning_texts[i / 2]).gait
                                                           : far_turning(r, &made_far));
  if (i / 2 >= FAR_TURNING)
    c = random_crawler(r, i % 3 ? ORDINARY : STICK_SLIP, c.gait);
  return i % 2 ? any_phase(r, &c) : steady_motion(&c);
}

/* l rises within 1e-2 to 1e-10 of a phase: three phases and a steady state of each gait. Of one crawler in three
 * friction does much within a rise. */
static struct motion of_rises(struct random *r, int i)
{
  static const struct scallop_gait *gait;
  if (i % 4 == 0)
    gait = rises_draw(&made_rises, r, pow(10, -2 - i / 4 % 9));
  struct scallop_crawler c = random_crawler(r, random_below(r, 2) ? ORDINARY : STICK_SLIP, gait);
  if (random_below(r, 3) == 0)
    set_eps(&c, random_decades(r, 1e2, 1e9));
  const struct motion phase = any_phase(r, &c);
  return i % 4 < 3 ? phase : steady_motion(&c);
}

static double drawn_length(double s)
{
  double pi = 3.14159265358979323846, part = s < 1. / 3 ? 1.2 * s : s < 0.5 ? 0.4 : 0.4 + 1.2 * (s - 0.5);
  double wave = sin(pi * part), l = (1 - cos(pi * part)) / 2 + 0.1 * wave * wave * sin(6 * pi * part);
  return fmin(fmax(l, 0), 1);
}

/* A spline of a thousand pieces, as through data: out, back a little, out; a dwell; and the other way. Each direction,
 * and none, is among them. */
enum { KNOTS = 513, DRAWN_PIECES = 4 * KNOTS };
static struct scallop_piece drawn_pieces[DRAWN_PIECES];
static struct scallop_law drawn_laws[DRAWN_PIECES];
static struct scallop_spline drawn = { .pieces = drawn_pieces, .laws = drawn_laws };
static void draw_spline(void)
{
  static struct scallop_knot knots[2][KNOTS];
  const struct scallop_knot *const both[2] = { knots[0], knots[1] };
  const int count[2] = { KNOTS, KNOTS };
  struct random r = { 20261302 };
  for (int kind = 0; kind < 2; kind++) {
    for (int i = 0; i < KNOTS; i++) {
      bool end = i == 0 || i == KNOTS - 1;
      double s = (i + (end ? 0 : random_between(&r, -0.3, 0.3))) / (KNOTS - 1), l = end ? i > 0 : drawn_length(s);
      knots[kind][i] = (struct scallop_knot){ scallop_knot_round(s), scallop_knot_round(kind == 0 ? l : 1 - l), 0 };
    }
    rises_slopes(knots[kind], KNOTS);
  }
  assert_true(scallop_spline_pieces(count) <= DRAWN_PIECES);
  assert_int_equal(scallop_make_spline(&drawn, "drawn", both, count), SCALLOP_OK);
  for (int kind = 0; kind < 2; kind++) {
    const struct scallop_shape *shape = &drawn.gait.phase[kind];
    int seen[3] = { 0 };
    for (int i = 0; i < shape->count; i++)
      seen[shape->pieces[i].direction + 1]++;
    assert_true(seen[0] > 10 && seen[1] > 10 && seen[2] > 10 && shape->peak <= 4);
  }
}

/* The error does not grow with the pieces. The last motion is a steady state. */
static struct motion of_many_pieces(struct random *r, int i)
{
  const struct scallop_crawler last = { 2, 1, 9, 1, 3, 0.5, 0.8, &drawn.gait };
  struct scallop_crawler c = random_crawler(r, i % 3 == 0 ? STICK_SLIP : ORDINARY, &drawn.gait);
  return i == 24 ? steady_motion(&last) : any_phase(r, &c);
}

/* What their numbers are counted in: the sizes of what is added up */
static struct unit natural(const struct motion *m)
{
  const struct scallop_crawler *c = &m->crawler;
  bool steady = m->of == OF_STEADY;
  double time = steady ? c->T : scallop_phase_duration(c, m->phase), length = c->L + (steady ? 0 : fabs(m->v0) * time);
  return (struct unit){ length / time, length, time, 1 };
}

static struct unit with_friction(const struct motion *m)
{
  const struct scallop_crawler *c = &m->crawler;
  struct unit u = natural(m);
  u.length += m->of == OF_PHASE ? (c->F1 + c->F2) * u.time / (c->m1 + c->m2) * u.time : 0;
  u.velocity = u.length / u.time;
  return u;
}

/* Where c is small at a turn of l' a body's turn is known to an ulp of the phase and not of the time from there: so
 * velocities are right to an ulp of the largest l'. */
static struct unit of_largest_rate(const struct motion *m)
{
  const struct scallop_crawler *c = &m->crawler;
  double peak = fmax(c->gait->phase[0].peak, c->gait->phase[1].peak),
         velocity = peak * c->L / (c->T * fmin(c->alpha, 1 - c->alpha)) + fabs(m->v0);
  return (struct unit){ velocity, velocity * c->T, INFINITY, 100 };
}

static struct unit of_both_rates(const struct motion *m)
{
  const struct scallop_crawler *c = &m->crawler;
  double rate = 10 * c->L / c->T * (1 / c->alpha + 1 / (1 - c->alpha));
  return (struct unit){ rate, 10 * c->L, c->T, 1 };
}

/* Where there are no units of their own: the bound of numerics.h, 8 units, or 8 * 2^-52 of the number where that is
 * more; and whether all must be solved, or refused. */
#define OFF_BY(...) { { __VA_ARGS__ } }, false, false
#define BOUND(solved, to_epsilon) NULL, { { 0 } }, solved, to_epsilon
static const struct asked {
  const char *what;
  uint64_t seed;
  int count;
  struct motion (*draw)(struct random *r, int i);
  struct unit (*unit_of)(const struct motion *m);
  struct allowed allowed;
  bool solved, to_epsilon;
} all[] = {
  /* Condition numbers of these families are below 1e4 or so. */
  { "steady states of the paper's gaits", 20261201, 60, steady_of_papers_gait, of_both_rates,
    OFF_BY(1e4 * DBL_EPSILON, 1e4 * ULP_LONG, 1e4 * ULP_WIDE) },
  { "odd gaits", 20261101, 76 * ODD, of_odd_gait, natural, OFF_BY(1e-12, 1e-15, 1e-27) },
  { "turning", 20261213, 40, of_turning_gait, of_largest_rate, OFF_BY(1e-13, 1e-16, 1e-28) },
  { "turning far and hardly", 20261214, 48, of_far_turning_gait, of_largest_rate, OFF_BY(1e-13, 1e-16, 1e-28) },
  { "a spline of many pieces", 20261303, 25, of_many_pieces, with_friction, OFF_BY(2 * DBL_EPSILON, 0, 1e-27) },
  { "any gait", 20260701, 168 * ALL_GAITS, of_any_gait, BOUND(true, true) },
  { "families of gaits", 20261212, 2 * 20 * WITHOUT_TURN, of_made_gait, BOUND(false, false) },
  { "steep rises", 20261501, 4 * 36, of_rises, BOUND(true, false) },
};

static void judge(const struct asked *t, struct motion m)
{
  if (t->unit_of) {
    const struct unit unit = t->unit_of(&m);
    agree(&m, &unit, &t->allowed);
    return;
  }
  const struct scallop_shape *phase = m.crawler.gait->phase;
  bool spline = strcmp(m.crawler.gait->name, "spline") == 0;
  enum stress_outcome outcome = bound_is_kept(&m, spline ? phase[0].count + phase[1].count : 0, t->to_epsilon);
  assert_true(!t->solved || outcome == STRESS_SOLVED || outcome == STRESS_REFUSED);
}

static const struct asked *under_test;
static void name_the_culprit(void) { print_error("%s\n", under_test->what); }

TEST(all_agree)
{
  check_failed = name_the_culprit;
  for (under_test = all; under_test < all + sizeof all / sizeof *all; under_test++) {
    struct random r = { under_test->seed };
    for (int i = 0; i < check_cases(under_test->count); i++)
      judge(under_test, under_test->draw(&r, i));
  }
  check_failed = NULL;
}

/* Three rises of 1e-8 between dwells: dx1 was off by 7e6 units. */
TEST(steps_of_a_motor)
{
  struct rises *g = &made_rises;
  const struct scallop_knot back[2] = { { 0, 1, 0 }, { 1, 0, 0 } }, *const knots[2] = { g->knots[0], back };
  const double times[7] = { 0, 1, 1.00000001, 2, 2.00000001, 3, 3.00000001 }, lengths[7] = { 0, 0, 1, 1, 2, 2, 3 };
  for (int i = 0; i < 7; i++)
    g->knots[0][i] = (struct scallop_knot){ .time = scallop_knot_round(times[i] / times[6]),
                                            .length = scallop_knot_round(lengths[i] / 3) };
  g->spline = (struct scallop_spline){ .pieces = g->pieces, .laws = g->laws };
  assert_int_equal(scallop_make_spline(&g->spline, "motor", knots, (const int[]){ 7, 2 }), SCALLOP_OK);
  const struct scallop_crawler c = { 0.14, 2, 2.9, 1.48, 1, 1.7, 3.00000001 / 5, &g->spline.gait };
  const struct motion both[2] = { phase_motion(&c, SCALLOP_EXTENSION, 0), steady_motion(&c) };
  for (int i = 0; i < 2; i++)
    assert_int_equal(bound_is_kept(&both[i], 0, false), STRESS_SOLVED);
}

static int make_gaits(void **state)
{
  (void)state;
  grow_teeth(&teeth);
  draw_spline();
  curved_first = mixed_gait(&scallop_gait_sinusoidal, &scallop_gait_quadratic);
  curved_last = mixed_gait(&scallop_gait_quadratic, &scallop_gait_sinusoidal);
  jerk_last = mixed_gait(&scallop_gait_quadratic, &minimum_jerk_gait);
  return 0;
}

int main(void) { return check_run(make_gaits, NULL); }
