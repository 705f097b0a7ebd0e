/* Gaits made to measure, exactly: the laws of struct scallop_law in balls and in doubles, certified against double, and
 * derived series. */
#include <float.h>

#include "asymptotics/derived/derived.h"
#include "compare/points/gaits.h"
#include "compare/stress/stress.h"
#include "model/exact/ball.h"
#include "tests/support/certified_balls.h"
#include "tests/support/random_gait.h"

enum { BITS = 300, PRECISION = 400, ORDER = 14 };

static void ball_of(arb_t x, double value) { arb_set_d(x, value); }

/* The ways of all pieces add up to 1, and where one piece ends the next one has the same l': exactly, as far as 300
 * bits tell. */
static void laws_fit_together(const struct scallop_shape *shape, int kind)
{
  SCOPED(arb, sum, way, u, v, before);
  for (int i = 0; i < shape->count; i++) {
    const struct scallop_piece *p = &shape->pieces[i];
    ball_of(u, p->begin);
    ball_of(v, p->end);
    scallop_ball_way(way, p, u, v, BITS);
    arb_addmul_si(sum, way, p->direction, BITS);
    scallop_ball_speed(way, p, u, BITS);
    arb_mul_si(way, way, p->direction, BITS);
    CHECK_AT_MOST(apart(way, before), 1e-60 * shape->peak);
    scallop_ball_speed(before, p, v, BITS);
    if (i == 0)
      assert_true(arb_is_zero(way));
    if (i + 1 == shape->count)
      assert_true(arb_is_zero(before));
    arb_mul_si(before, before, p->direction, BITS);
  }
  arb_set_si(way, kind == SCALLOP_EXTENSION ? 1 : -1);
  CHECK_AT_MOST(apart(sum, way), 1e-60 * shape->peak);
}

/* l', l'' and l in doubles are those of the law: l' to its last digits also where it is next to nothing. Bernstein's
 * form cancels where its coefficients have both signs, by at most the largest of them over |l'|; the curves are
 * evaluated in long double. */
static void doubles_follow_the_law(struct random *r, const struct scallop_shape *shape)
{
  const double ulp = DBL_EPSILON;
  SCOPED(arb, u, value, begin);
  for (int i = 0; i < shape->count; i++) {
    const struct scallop_piece *p = &shape->pieces[i];
    double at = p->begin + (p->end - p->begin) * random_between(r, 0, 1), velocity = p->curve->velocity(p, at);
    double steep = fmax(fabs(p->curve->acceleration(p, p->begin)), fabs(p->curve->acceleration(p, p->end)));
    ball_of(u, at);
    scallop_ball_speed(value, p, u, BITS);
    arb_mul_si(value, value, p->direction, BITS);
    CHECK_NEAR(velocity, middle(value),
               p->linear ? 4 * ulp * (fabs(p->velocity) + fabs(velocity))
                         : 0x1p-8 * ulp * shape->peak + 2 * ulp * fabs(velocity));
    scallop_ball_rate(value, p, u, BITS);
    arb_mul_si(value, value, p->direction, BITS);
    CHECK_NEAR(p->curve->acceleration(p, at), middle(value), 4 * ulp * (steep + shape->peak));
    ball_of(begin, p->begin);
    scallop_ball_way(value, p, begin, u, BITS);
    CHECK_NEAR(p->curve->length(p, at) - p->curve->length(p, p->begin), p->direction * middle(value),
               8 * ulp * fmax(1, shape->peak));
  }
}

TEST(laws)
{
  struct random r = { 20261211 };
  struct random_gait made;
  for (int i = 0; i < check_cases(40 * RANDOM_GAITS); i++) {
    const struct scallop_gait *gait = random_gait(&r, (enum random_gait_kind)(i % RANDOM_GAITS), &made);
    assert_true(scallop_gait_is_exact(gait) && scallop_gait_is_rational(gait));
    for (int kind = 0; kind < 2; kind++) {
      laws_fit_together(&gait->phase[kind], kind);
      doubles_follow_the_law(&r, &gait->phase[kind]);
    }
  }
}

/* A cubic that is cut in the middle of the phase goes on there, turned; a knot is a corner of l''. */
TEST(pieces_that_go_on)
{
  struct scallop_piece pieces[8];
  struct scallop_law all[8];
  struct scallop_spline s = { .pieces = pieces, .laws = all };
  const struct scallop_knot out[3] = { { 0, 0, 0 }, { 0.75, 0.5, 0.5 }, { 1, 1, 0 } },
                            back[2] = { { 0, 1, 0 }, { 1, 0, 0 } };
  bool turned = false;
  assert_int_equal(
      scallop_make_spline(&s, "", (const struct scallop_knot *const[2]){ out, back }, (const int[2]){ 3, 2 }),
      SCALLOP_OK);
  const struct scallop_piece *p = s.gait.phase[0].pieces;
  assert_true(scallop_piece_goes_on(p, p + 1, &turned));
  assert_true(turned);
  assert_false(scallop_piece_goes_on(p + 1, p + 2, &turned));
  assert_false(turned);
  p = gait_of_text("trapezoidal:0.25,0.125").gait->phase[0].pieces;
  assert_false(scallop_piece_goes_on(p, p + 1, &turned));
  assert_true(scallop_piece_goes_on(p + 1, p + 2, &turned));
  assert_true(turned);
  p = gait_of_text("polynomial:0,0.5,0,-0.25").gait->phase[0].pieces;
  for (int i = 0; i + 1 < gait_of_text("polynomial:0,0.5,0,-0.25").gait->phase[0].count; i++)
    assert_true(scallop_piece_goes_on(p + i, p + i + 1, &turned));
}

/* Pieces that are not those of the paper's gaits add their own: where c goes on from one to the next it is rounded
 * twice, a unit at most. In directed rounding all these have one sign, and no spread is promised. pieces: 0, or how
 * many there are of a spline. */
static void judge(struct stress_case *s, int pieces)
{
  stress_judge(s);
  for (int q = 0; q < QUANTITIES; q++) {
    const struct stress_number *n = &s->number[q];
    const char *broken = n->broken;
    if (pieces > 0 && s->outcome != STRESS_BROKEN)
      broken = !n->judged || n->error <= (STRESS_PROMISE + pieces) * n->unit ? NULL : "error";
    if (!broken)
      continue;
    print_crawler(&s->motion.crawler);
    fail_msg("%s of %s: %.3g units, %.3g over the rounding modes; phase %d, v0 = %.17g", broken,
             stress_quantity_name(s, q), n->error / n->unit, n->rounding / n->unit, (int)s->motion.phase, s->motion.v0);
  }
}

/* The promise of numerics.h: 8 units */
TEST(promise)
{
  static const enum family families[] = {
    ORDINARY, STICK_SLIP, EQUAL_FORCES, EXTREME_RATIOS, SMALL_PERIOD, ALPHA_EDGE
  };
  struct random r = { 20261212 };
  struct random_gait made;
  for (int i = 0; i < check_cases(36 * WITHOUT_TURN); i++) {
    const struct scallop_gait *gait = random_gait(&r, (enum random_gait_kind)(i % WITHOUT_TURN), &made);
    int pieces = i % WITHOUT_TURN == SPLINE ? gait->phase[0].count + gait->phase[1].count : 0;
    struct stress_case s = { .motion = { .of = OF_STEADY,
                                         .crawler = random_crawler(&r, families[i / WITHOUT_TURN % 6], gait) } };
    judge(&s, pieces);
    s.motion.of = OF_PHASE;
    s.motion.phase = i % 2 ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
    s.motion.v0 = random_start(&r, &s.motion.crawler, s.motion.phase);
    judge(&s, pieces);
  }
}

/* Where l' changes its sign within a phase, and c is small there, a body's turn is known to an ulp of the phase and not
 * of the time from there: so velocities are right to an ulp of the largest l'. */
TEST(turning)
{
  struct random r = { 20261213 };
  struct random_gait made;
  SCOPED(scallop_certified_steady, wanted);
  for (int i = 0; i < check_cases(60); i++) {
    const struct scallop_gait *gait = random_gait(&r, i % 2 ? TURNING_SPLINE : TURNING_POLYNOMIAL, &made);
    struct scallop_crawler c = random_crawler(&r, i % 3 ? ORDINARY : STICK_SLIP, gait);
    struct scallop_steady_result got = steady_of(&c);
    certify_steady(&wanted, &c, 20);
    double peak = fmax(gait->phase[0].peak, gait->phase[1].peak),
           unit = peak * c.L / (c.T * fmin(c.alpha, 1 - c.alpha));
    check_number(got.period.v_start, wanted.v_start, 1e-13 * unit, &c, "v_start");
    check_number(got.period.v_mid, wanted.v_mid, 1e-13 * unit, &c, "v_mid");
    check_number(got.period.displacement, wanted.displacement, 1e-13 * unit * c.T, &c, "displacement");
    check_number(got.period.multiplier, wanted.multiplier, 1e-11, &c, "multiplier");
  }
}

/* l' = s^p (1 - s) times factors s - root. The roots are anywhere, and next to the start, the middle, the end and each
 * other: so there are pieces that are much shorter than an ulp of l, and l goes back further than its amplitude. */
static const struct scallop_gait *far_turning(struct random *r, struct scallop_polynomial *g)
{
  enum { MOST = 8 };
  double slope[MOST + 1] = { 0 }, root = 0;
  int degree = 1 + random_below(r, 2), roots = 1 + random_below(r, 4);
  slope[degree] = 1;
  for (int i = 0; i <= roots; i++) { /* times a + s, the last one times 1 - s */
    double closeness = random_decades(r, 1e-9, 0.1), side = random_below(r, 2) ? 1 : -1;
    const double places[] = { random_between(r, 0.02, 0.98), 0.5 + side * closeness, closeness, 1 - closeness,
                              root + 0.02 };
    root = i < roots ? places[random_below(r, 5)] : 1;
    for (int k = ++degree; k >= 0; k--)
      slope[k] = (k > 0 ? slope[k - 1] : 0) - root * slope[k];
  }
  return polynomial_of_slope(g, slope, degree) ? &g->gait : far_turning(r, g);
}

/* l' has the sign that the piece says, also where all of it is next to a turn. */
static void directions_hold(struct random *r, const struct scallop_shape *shape)
{
  SCOPED(arb, u, speed);
  for (int i = 0; i < shape->count; i++)
    for (int k = 0; k < 8; k++) {
      const struct scallop_piece *p = &shape->pieces[i];
      double near = random_decades(r, 1e-6, 1), part = k % 2 ? near : 1 - near;
      double at = p->begin + (p->end - p->begin) * part;
      if (at == p->begin || at == p->end)
        continue;
      ball_of(u, at);
      scallop_ball_speed(speed, p, u, BITS);
      assert_true(arb_is_positive(speed));
    }
}

/* Double and binary128 against certified, in units of what turning() says */
static void all_agree(const struct scallop_crawler *c, enum scallop_phase_kind kind, double v0, bool wide)
{
  struct scallop_wide_steady wide_steady;
  struct scallop_wide_phase wide_phase;
  SCOPED(scallop_certified_steady, s);
  SCOPED(scallop_certified_phase, p);
  double peak = fmax(c->gait->phase[0].peak, c->gait->phase[1].peak),
         unit = peak * c->L / (c->T * fmin(c->alpha, 1 - c->alpha));
  certify_steady(&s, c, 40);
  certify_phase(&p, c, kind, v0, 40);
  struct scallop_steady_result steady = steady_of(c);
  struct scallop_phase_result phase = phase_of(c, kind, v0);
  check_number(steady.period.v_start, s.v_start, 1e-13 * unit, c, "v_start");
  check_number(steady.period.v_mid, s.v_mid, 1e-13 * unit, c, "v_mid");
  check_number(steady.period.displacement, s.displacement, 1e-13 * unit * c->T, c, "displacement");
  check_number(phase.v_end, p.v_end, 1e-13 * (unit + fabs(v0)), c, "v_end");
  check_number(phase.dxC, p.dxC, 1e-13 * (unit + fabs(v0)) * c->T, c, "dxC");
  if (!wide || scallop_width_bits(SCALLOP_BINARY128) == 0)
    return;
  assert_int_equal(scallop_wide_steady(SCALLOP_BINARY128, c, &wide_steady), SCALLOP_OK);
  assert_int_equal(scallop_wide_phase(SCALLOP_BINARY128, c, kind, v0, &wide_phase), SCALLOP_OK);
  check_wide(&wide_steady.period.v_start, s.v_start, 1e-28 * unit, c);
  check_wide(&wide_steady.period.displacement, s.displacement, 1e-28 * unit * c->T, c);
  check_wide(&wide_phase.v_end, p.v_end, 1e-28 * (unit + fabs(v0)), c);
}

/* Where l goes back further than its amplitude, or hardly at all, the ways of the pieces add up to the amplitude all
 * the same. */
TEST(turning_far_and_hardly)
{
  static const char *const texts[] = { "polynomial:0,0,-60,125,-64",
                                       "polynomial:0,330,-1420,1860,-768",
                                       "polynomial:0,0,220,-1065,1488,-640",
                                       "polynomial:0,135,-1690,3120,-1536",
                                       "polynomial:0,0,-12,25,-12.8",
                                       "polynomial:0,0,-4,9,-4.8",
                                       "polynomial:0,0,-19.999999976000002,44.999999952000003,-23.999999976000002",
                                       "polynomial:0,-6.0000000012000002e-10,4.0000000012000001,-3.0000000006" };
  enum { TEXTS = sizeof texts / sizeof *texts, GAITS = 24 };
  struct random r = { 20261214 };
  for (int i = 0; i < TEXTS + check_cases(GAITS); i++) {
    struct scallop_polynomial made;
    struct scallop_crawler c = with_gait(i < TEXTS ? gait_of_text(texts[i]).gait : far_turning(&r, &made));
    if (i >= TEXTS)
      c = random_crawler(&r, i % 3 ? ORDINARY : STICK_SLIP, c.gait);
    for (int kind = 0; kind < 2; kind++) {
      laws_fit_together(&c.gait->phase[kind], kind);
      directions_hold(&r, &c.gait->phase[kind]);
    }
    enum scallop_phase_kind kind = i % 2 ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
    all_agree(&c, kind, random_start(&r, &c, kind), i % 8 == 0);
  }
}

/* The terms below T^ORDER are the certified value, up to about the next one; and the first one is the paper's (26), in
 * which 1/l_0 - 1/l_T = (up + down)(1 - up/2 - down/2), for these crawlers to the last digit, as l' is linear where the
 * bodies turn. */
TEST(derived_series)
{
  static const struct {
    const char *text;
    slong numerator, denominator; /* of 1/l_0 - 1/l_T */
  } cases[] = { { "trapezoidal:0.25,0.125", 39, 128 },
                { "trapezoidal:0.5,0.25", 15, 32 },
                { "skewed:0.375", 1, 2 },
                { "skewed:0.3", 1, 2 } };
  SCOPED(arb, at, value);
  SCOPED(fmpq, first, formula);
  SCOPED(scallop_rational, exact);
  SCOPED(scallop_expansion, e);
  SCOPED(scallop_certified_steady, wanted);
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    struct scallop_crawler c = with_gait(gait_of_text(cases[i].text).gait);
    c.T = 0x1p-10;
    scallop_rational_of(&exact, &c);
    assert_int_equal(scallop_expand_steady(&exact, ORDER, PRECISION, &e, NULL), SCALLOP_OK);
    assert_int_equal(scallop_certified_steady(&exact, 40, &wanted, NULL), SCALLOP_OK);
    arb_set_fmpq(at, exact.T, PRECISION);
    series_value(value, &e.v_start, at, ORDER, PRECISION);
    CHECK_AT_MOST(apart(value, wanted.v_start), 1e-30);
    series_value(value, &e.displacement, at, ORDER, PRECISION);
    CHECK_AT_MOST(apart(value, wanted.displacement), 1e-34);
    /* (F1 - F2)(2 alpha - 1) L m* / (2 (1/l_0 - 1/l_T) [alpha^2 F1 m1 + (1 - alpha)^2 F2 m2]) for the default
     * crawler */
    assert_true(series_rational_coefficient(first, &e.v_start, -1));
    fmpq_set_si(formula, 60 * cases[i].denominator, (ulong)(37 * cases[i].numerator));
    fmpq_canonicalise(formula);
    assert_true(fmpq_equal(first, formula));
  }
}
