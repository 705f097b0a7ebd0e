/* Gaits made to measure, exactly: the laws of struct scallop_law in balls and in doubles, and derived series. */
#include <float.h>

#include "asymptotics/derived/derived.h"
#include "compare/points/gaits.h"
#include "model/exact/ball.h"
#include "tests/support/certified_balls.h"
#include "tests/support/random_gait.h"

enum { BITS = 300, PRECISION = 400, ORDER = 14 };

/* The ways of all pieces add up to 1, and where one piece ends the next one has the same l': exactly, as far as 300
 * bits tell. */
static void laws_fit_together(const struct scallop_shape *shape, int kind)
{
  SCOPED(arb, sum, way, u, v, before);
  for (int i = 0; i < shape->count; i++) {
    const struct scallop_piece *p = &shape->pieces[i];
    arb_set_d(u, p->begin);
    arb_set_d(v, p->end);
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
    arb_set_d(u, at);
    scallop_ball_speed(value, p, u, BITS);
    arb_mul_si(value, value, p->direction, BITS);
    CHECK_NEAR(velocity, middle(value),
               p->linear ? 4 * ulp * (fabs(p->velocity) + fabs(velocity))
                         : 0x1p-8 * ulp * shape->peak + 2 * ulp * fabs(velocity));
    scallop_ball_rate(value, p, u, BITS);
    arb_mul_si(value, value, p->direction, BITS);
    CHECK_NEAR(p->curve->acceleration(p, at), middle(value), 4 * ulp * (steep + shape->peak));
    arb_set_d(begin, p->begin);
    scallop_ball_way(value, p, begin, u, BITS);
    CHECK_NEAR(p->curve->length(p, at) - p->curve->length(p, p->begin), p->direction * middle(value),
               8 * ulp * fmax(1, shape->peak));
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
  assert_true(scallop_piece_continues(p, p + 1, &turned) && turned);
  assert_true(!scallop_piece_continues(p + 1, p + 2, &turned) && !turned);
  p = gait_of_text("trapezoidal:0.25,0.125").gait->phase[0].pieces;
  assert_false(scallop_piece_continues(p, p + 1, &turned));
  assert_true(scallop_piece_continues(p + 1, p + 2, &turned) && turned);
  const struct scallop_shape *smooth = &gait_of_text("polynomial:0,0.5,0,-0.25").gait->phase[0];
  for (int i = 0; i + 1 < smooth->count; i++)
    assert_true(scallop_piece_continues(smooth->pieces + i, smooth->pieces + i + 1, &turned));
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
      arb_set_d(u, at);
      scallop_ball_speed(speed, p, u, BITS);
      assert_true(arb_is_positive(speed));
    }
}

/* Gaits of every family, and at last far turns */
TEST(laws)
{
  struct random r = { 20261211 };
  struct random_gait made;
  long others = check_cases(40 * RANDOM_GAITS), far = FAR_TURNING + check_cases(24);
  for (long i = 0; i < others + far; i++) {
    long turn = i - others;
    const struct scallop_gait *gait = turn < 0 ? random_gait(&r, (enum random_gait_kind)(i % RANDOM_GAITS), &made)
                                      : turn < FAR_TURNING ? gait_of_text(far_turning_texts[turn]).gait
                                                           : far_turning(&r, &made.polynomial);
    assert_true(scallop_gait_is_exact(gait) && scallop_gait_is_rational(gait));
    for (int kind = 0; kind < 2; kind++) {
      laws_fit_together(&gait->phase[kind], kind);
      (turn < 0 ? doubles_follow_the_law : directions_hold)(&r, &gait->phase[kind]);
    }
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
