/* Tables of crawlers, each solved in double, long double, binary128 and balls (tests/support/agree.h): of every family,
 * with gaits of every kind that model.h allows. The certified solver is written apart from the others. */
#include <float.h>
#include <stdlib.h>

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

static enum scallop_phase_kind either(struct random *r)
{
  return random_below(r, 2) ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
}

/* A phase of the crawler from any start */
static struct motion any_phase(struct random *r, const struct scallop_crawler *c)
{
  enum scallop_phase_kind kind = either(r);
  return phase_motion(c, kind, random_start(r, c, kind));
}

static struct scallop_crawler of_family(struct random *r, int i, const struct scallop_gait *gait)
{
  return random_crawler(r, (enum family)(i % FAMILIES), gait);
}

static struct motion phase_of_any_gait(struct random *r, int i)
{
  struct scallop_crawler c = of_family(r, i / ALL_GAITS, every_gait[i % ALL_GAITS]);
  return any_phase(r, &c);
}

static struct motion steady_of_smooth_gait(struct random *r, int i)
{
  struct scallop_crawler c = of_family(r, i / SMOOTH_GAITS, every_gait[i % SMOOTH_GAITS]);
  return steady_motion(&c);
}

static struct motion steady_of_papers_gait(struct random *r, int i)
{
  struct scallop_crawler c = of_family(r, i, every_gait[i % 2]);
  return steady_motion(&c);
}

/* Gaits whose l' changes its sign, rests or jumps within a phase, with more modes than are kept, and with phases of two
 * kinds; all but the last have a steady state to certify. Where rounding is not magnified: ordinary crawlers, some of
 * them stuck for a while, some with equal forces */
enum { ODD = 12, CONTINUOUS = 11 };
static struct scallop_crawler odd_crawler(struct random *r, int i, int gaits)
{
  static const struct scallop_gait *const odd[ODD] = { &there_and_back_gait, &detour_gait, &teeth.gait,
                                                       &pause_gait,          &wait_gait,   &hesitant_gait,
                                                       &curved_first,        &curved_last, &jerk_last,
                                                       &leaning_gait,        &ramps_gait,  &stride_gait };
  static const enum family families[] = { STICK_SLIP, ORDINARY, ORDINARY, EQUAL_FORCES };
  return random_crawler(r, families[i / ODD % 4], odd[i % gaits]);
}

static struct motion odd_phase(struct random *r, int i)
{
  struct scallop_crawler c = odd_crawler(r, i, ODD);
  return any_phase(r, &c);
}

static struct motion odd_steady(struct random *r, int i)
{
  struct scallop_crawler c = odd_crawler(r, i, CONTINUOUS);
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

/* l' constant out and back, also with a jump in one phase only */
static struct motion of_constant_gait(struct random *r, int i)
{
  static const char *const texts[] = { "constant:0", "constant:0", "constant:0,0.125", "constant:0.25,0" };
  static const enum family families[] = { ORDINARY, STICK_SLIP, SMALL_PERIOD };
  struct scallop_crawler c;
  do
    c = random_crawler(r, families[random_below(r, 3)], gait_of_text(texts[i % 4]).gait);
  while (fabs(c.F1 - c.F2) > 0.9 * (c.F1 + c.F2) || fabs(c.F1 - c.F2) < 1e-3 * (c.F1 + c.F2)
         || fabs(c.alpha - 0.5) < 1e-3);
  return steady_motion(&c);
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

/* A spline of a thousand pieces, as through data: out, back a little, out; a dwell; and the other way. The last motion
 * is a steady state. */
static struct scallop_gait drawn;
static struct motion of_many_pieces(struct random *r, int i)
{
  const struct scallop_crawler last = { 2, 1, 9, 1, 3, 0.5, 0.8, &drawn };
  struct scallop_crawler c = random_crawler(r, i % 3 == 0 ? STICK_SLIP : ORDINARY, &drawn);
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
  struct unit u = natural(m);
  if (m->of == OF_PHASE)
    u.length += (m->crawler.F1 + m->crawler.F2) * u.time / (m->crawler.m1 + m->crawler.m2) * u.time;
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

static struct unit of_constant_rates(const struct motion *m)
{
  const struct scallop_crawler *c = &m->crawler;
  double size = (1 / c->alpha + 1 / (1 - c->alpha) + crawler_eps(c)) / (1 - fabs(c->F1 - c->F2) / (c->F1 + c->F2));
  return (struct unit){ size * c->L / c->T, size * c->L, c->T, 1 };
}

/* Two doubles hold no more than 100 bits. */
#define ULP_LONG 0x1p-63
#define ULP_WIDE 0x1p-99
static void all_agree(uint64_t seed, int count, struct motion (*draw)(struct random *r, int i),
                      struct unit (*unit_of)(const struct motion *m), struct allowed allowed)
{
  struct random r = { seed };
  for (int i = 0; i < check_cases(count); i++) {
    const struct motion m = draw(&r, i);
    const struct unit unit = unit_of(&m);
    agree(&m, &unit, &allowed);
  }
}
#define ALLOWED(...) ((struct allowed){ { __VA_ARGS__ } })

/* Condition numbers of these families are below 1e4 or so. */
TEST(steady_states_of_the_papers_gaits)
{
  all_agree(20261201, 60, steady_of_papers_gait, of_both_rates,
            ALLOWED(1e4 * DBL_EPSILON, 1e4 * ULP_LONG, 1e4 * ULP_WIDE));
}

TEST(odd_phases) { all_agree(20261101, 60 * ODD, odd_phase, natural, ALLOWED(1e-12, 1e-15, 1e-27)); }
TEST(odd_steady_states) { all_agree(20261102, 24 * CONTINUOUS, odd_steady, natural, ALLOWED(1e-12, 1e-15, 1e-27)); }

TEST(turning) { all_agree(20261213, 60, of_turning_gait, of_largest_rate, ALLOWED(1e-13, 1e-16, 1e-28)); }

TEST(turning_far_and_hardly)
{
  all_agree(20261214, 64, of_far_turning_gait, of_largest_rate, ALLOWED(1e-13, 1e-16, 1e-28));
}

TEST(constant_rates)
{
  all_agree(2026112204, 60, of_constant_gait, of_constant_rates, ALLOWED(16 * DBL_EPSILON, 16 * ULP_LONG, 1e-28));
}

static double drawn_length(double s)
{
  double pi = 3.14159265358979323846, part = s < 1. / 3 ? 1.2 * s : s < 0.5 ? 0.4 : 0.4 + 1.2 * (s - 0.5);
  double wave = sin(pi * part), l = (1 - cos(pi * part)) / 2 + 0.1 * wave * wave * sin(6 * pi * part);
  return fmin(fmax(l, 0), 1);
}

enum { KNOTS = 513 };
static void draw_phase(struct random *r, struct scallop_knot *k, bool up)
{
  for (int i = 0; i < KNOTS; i++) {
    double s = (i + (i == 0 || i == KNOTS - 1 ? 0 : random_between(r, -0.3, 0.3))) / (KNOTS - 1);
    double l = i == 0 ? 0 : i == KNOTS - 1 ? 1 : drawn_length(s);
    k[i] = (struct scallop_knot){ scallop_knot_round(s), scallop_knot_round(up ? l : 1 - l), 0 };
  }
  rises_slopes(k, KNOTS);
}

/* The error does not grow with the pieces. Each direction, and none, is among them. */
TEST(a_spline_through_many_knots)
{
  static struct scallop_knot knots[2][KNOTS];
  const struct scallop_knot *const both[2] = { knots[0], knots[1] };
  const int count[2] = { KNOTS, KNOTS };
  struct random r = { 20261302 };
  for (int kind = 0; kind < 2; kind++)
    draw_phase(&r, knots[kind], kind == 0);
  size_t pieces = (size_t)scallop_spline_pieces(count);
  struct scallop_spline spline = { .pieces = calloc(pieces, sizeof *spline.pieces),
                                   .laws = calloc(pieces, sizeof *spline.laws) };
  assert_int_equal(scallop_make_spline(&spline, "drawn", both, count), SCALLOP_OK);
  for (int kind = 0; kind < 2; kind++) {
    const struct scallop_shape *shape = &spline.gait.phase[kind];
    int seen[3] = { 0 };
    for (int i = 0; i < shape->count; i++)
      seen[shape->pieces[i].direction + 1]++;
    assert_true(seen[0] > 10 && seen[1] > 10 && seen[2] > 10 && shape->peak <= 4);
  }
  drawn = spline.gait;
  all_agree(20261303, 25, of_many_pieces, with_friction, ALLOWED(2 * DBL_EPSILON, 0, 1e-27));
  free(spline.pieces);
  free(spline.laws);
}

/* 8 units */
static void all_keep_the_bound(uint64_t seed, int count, struct motion (*draw)(struct random *r, int i), bool solved,
                               bool to_epsilon)
{
  struct random r = { seed };
  for (int i = 0; i < check_cases(count); i++) {
    const struct motion m = draw(&r, i);
    const struct scallop_shape *phase = m.crawler.gait->phase;
    bool spline = strcmp(m.crawler.gait->name, "spline") == 0;
    enum stress_outcome outcome = bound_is_kept(&m, spline ? phase[0].count + phase[1].count : 0, to_epsilon);
    assert_true(!solved || outcome == STRESS_SOLVED || outcome == STRESS_REFUSED);
  }
}

TEST(bound_for_phases) { all_keep_the_bound(20260701, 140 * ALL_GAITS, phase_of_any_gait, true, true); }
TEST(bound_for_steady_states) { all_keep_the_bound(20260702, 28 * SMOOTH_GAITS, steady_of_smooth_gait, true, true); }
TEST(bound_for_families_of_gaits) { all_keep_the_bound(20261212, 2 * 36 * WITHOUT_TURN, of_made_gait, false, false); }
TEST(bound_for_steep_rises) { all_keep_the_bound(20261501, 4 * 54, of_rises, true, false); }

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
  curved_first = mixed_gait(&scallop_gait_sinusoidal, &scallop_gait_quadratic);
  curved_last = mixed_gait(&scallop_gait_quadratic, &scallop_gait_sinusoidal);
  jerk_last = mixed_gait(&scallop_gait_quadratic, &minimum_jerk_gait);
  return 0;
}

int main(void) { return check_run(make_gaits, NULL); }
