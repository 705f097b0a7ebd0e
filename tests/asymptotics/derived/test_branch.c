/* Branches and limits from the inside: the motions that have no enclosure, and
 * no expansion, are not given one. */
#include "asymptotics/derived/limit.h"
#include "tests/support/exact.h"
#include "tests/support/odd_gaits.h"
#include "tests/support/solved.h"

enum { PRECISION = 128 };

struct subject {
  struct scallop_rational_crawler crawler;
  struct phase_constants phase;
  struct branch branch;
  arb_t c;
};

#define PARTS(of) of(scallop_rational, &s->crawler) of(phase_constants, &s->phase) of(branch, &s->branch) of(arb, s->c)
SCOPED_PARTS(subject, struct subject, PARTS)

/* m1 = m2, F1 = 4 F2, an extension */
static void subject_set(struct subject *s, const struct scallop_gait *gait)
{
  const struct scallop_crawler c = { 1, 1, 4, 1, 1, 1, 0.75, gait };
  scallop_rational_of(&s->crawler, &c);
  phase_constants_set(&s->phase, &s->crawler, SCALLOP_EXTENSION);
}

#define SUBJECT(s, gait) \
  SCOPED(subject, s); \
  subject_set(&(s), gait)

/* What the limit is, of a crawler in doubles */
#define LIMIT(l, exact, crawler) \
  SCOPED(scallop_rational, exact); \
  scallop_rational_of(&(exact), crawler); \
  SCOPED(limit, l); \
  assert_int_equal(limit_find(&(l), &(exact), PRECISION, NULL), SCALLOP_OK)

/* |l'| of trapezoid: 0 to 16/13, and curve 0 is half of that. */
TEST(levels)
{
  static const struct {
    double c;
    int crossings; /* -1: cannot be told */
  } cases[] = { { 0, -1 }, { 0.3, 2 }, { -0.3, 2 }, { 0.7, 0 }, { -0.7, 0 } };
  SUBJECT(s, &trapezoid_gait);
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    arb_set_d(s.c, cases[i].c);
    assert_int_equal(branch_of_level(&s.branch, &s.phase, s.c, PRECISION), cases[i].crossings >= 0);
    if (cases[i].crossings >= 0)
      assert_int_equal(s.branch.count, cases[i].crossings);
  }
  SCOPED(fmpq, along); /* c = 8/13 runs along the curve */
  fmpq_set_si(along, 8, 13);
  arb_set_fmpq(s.c, along, PRECISION);
  assert_false(branch_of_level(&s.branch, &s.phase, s.c, PRECISION));
}

/* A branch has room for MOST_CROSSINGS, and 16 teeth are crossed twice as
 * often. */
TEST(more_crossings_than_there_is_room_for)
{
  struct teeth teeth;
  grow_teeth(&teeth);
  SUBJECT(s, &teeth.gait);
  arb_set_d(s.c, 0.5);
  assert_false(branch_of_level(&s.branch, &s.phase, s.c, PRECISION));
  assert_int_equal(s.branch.count, MOST_CROSSINGS);
  teeth.gait.phase[SCALLOP_EXTENSION].count = MOST_CROSSINGS; /* half of the phase */
  assert_true(branch_of_level(&s.branch, &s.phase, s.c, PRECISION));
  assert_int_equal(s.branch.count, MOST_CROSSINGS);
  for (int i = 0; i < MOST_CROSSINGS; i++) { /* q |l'| = 1/2 at a quarter of a tooth from either side */
    SCOPED(arb, u);
    series_coefficient(u, &s.branch.crossing[i].offset, 0, PRECISION);
    int tooth = i / 2;
    CHECK_NEAR(middle(u), (tooth + (i % 2 ? 0.75 : 0.25)) / TEETH, 1e-15);
  }
}

/* At the plateau, where the slope of the curve is that of the line: no time is
 * the crossing. */
TEST(crossings_along_the_curve)
{
  const struct ring ring = { 4, PRECISION };
  SCOPED(arb, at);
  SCOPED(series, c, eps, one);
  SCOPED(lift, lift);
  SUBJECT(s, &trapezoid_gait);
  series_set_si(&one, 1);
  series_set_si(&eps, 0);
  SCOPED(phase_series, in_series);
  phase_series_set(&in_series, &s.phase, s.crawler.L);
  for (int along = 0; along < 2; along++) { /* first where c does cross */
    double u = along ? 0.5 : 0.125;
    fmpq_set_si(s.crawler.alpha, along ? 8 : 4, 13); /* a fraction at hand: c = q |l'| at u */
    arb_set_fmpq(s.c, s.crawler.alpha, PRECISION);
    series_set_rational(&c, s.crawler.alpha);
    s.branch.count = 1;
    s.branch.first_region = 0;
    s.branch.crossing[0].piece = &s.phase.shape->pieces[along];
    s.branch.crossing[0].curve = 0;
    s.branch.crossing[0].to = 1;
    arb_set_d(at, u);
    series_set_ball(&s.branch.crossing[0].offset, at);
    assert_int_equal(lift_phase(&lift, &s.branch, &in_series, &eps, &c, &one, CROSSINGS_KNOWN, &ring), !along);
    assert_int_equal(lift_phase(&lift, &s.branch, &in_series, &eps, &c, &one, CROSSINGS_ANEW, &ring), !along);
    series_coefficient(at, &s.branch.crossing[0].offset, 0, PRECISION);
    CHECK_NEAR(middle(at), u, 1e-30);
  }
}

/* m1 = m2, F1 = 7 F2, alpha = 3/4: w = 3/8, crossings and all are fractions
 * with a power of 2 below, so that balls hold them exactly; an enclosure is
 * found all the same, and holds it. */
TEST(a_limit_that_balls_hold_exactly)
{
  const struct scallop_crawler c = { 1, 1, 7, 1, 1, 1, 0.75, &scallop_gait_quadratic };
  SCOPED(fmpq, value);
  SCOPED(arb, w, eps);
  LIMIT(l, exact, &c);
  assert_true(series_rational_coefficient(value, &l.w, 0));
  CHECK_EQUAL(fmpq_get_d(value), 0.375);
  arb_set_d(w, 0.375);
  assert_true(limit_follow(&l, w, eps, PRECISION));
  assert_true(arb_contains_fmpq(w, value));
  assert_true(mag_cmp_2exp_si(arb_radref(w), -PRECISION / 2) < 0);
}

/* The velocity with which the contraction begins, in units of L and the period */
static void find_w_mid(arb_t w_mid, struct limit *l, const arb_t w, const arb_t eps)
{
  const struct ring ring = { 1, PRECISION };
  SCOPED(lift, lift);
  SCOPED(phase_series, p);
  SCOPED(fmpq, unit);
  SCOPED(series, here, c, one);
  fmpq_one(unit);
  phase_series_set(&p, &l->phase[0], unit);
  series_set_si(&one, 1);
  series_set_ball(&c, w);
  series_mul(&c, &c, &p.fraction, &ring);
  series_set_ball(&here, eps);
  series_mul(&here, &here, &p.fraction, &ring);
  series_mul(&here, &here, &p.fraction, &ring);
  assert_true(lift_phase(&lift, &l->branch[0], &p, &here, &c, &one, CROSSINGS_ANEW, &ring));
  series_div(&c, &lift.c_end, &p.fraction, &ring);
  series_coefficient(w_mid, &c, 0, PRECISION);
}

/* Minimum jerk is one polynomial in four pieces. F1 = 22 F2 and alpha = 0.9: as eps grows the first crossing of the
 * extension moves from the second piece into the first, and nothing happens there: the modes hold, and this is the
 * steady state. */
TEST(a_crossing_moves_to_another_piece)
{
  struct scallop_crawler c = { 1, 1, 22, 1, 1, 1, 0.9, &minimum_jerk_gait };
  int before = 0, after = 0;
  SCOPED(arb, w, w_mid, eps, u);
  LIMIT(l, exact, &c);
  series_coefficient(w, &l.w, 0, PRECISION);
  assert_ptr_equal(l.branch[0].crossing[0].piece, &minimum_jerk_gait.phase[0].pieces[1]);
  for (int i = 1; i <= 16; i++) {
    c.T = 0.02 * i;
    arb_set_d(eps, crawler_eps(&c));
    assert_true(limit_follow(&l, w, eps, PRECISION));
    find_w_mid(w_mid, &l, w, eps);
    series_coefficient(u, &l.branch[0].crossing[0].offset, 0, PRECISION);
    *(middle(u) < minimum_jerk_gait.phase[0].pieces[0].end ? &after : &before) += 1;
    assert_null(limit_holds(&l, w, w_mid, eps, PRECISION));
    struct scallop_steady_result steady = steady_of(&c);
    CHECK_RELATIVE(middle(w), steady.period.v_start * c.T / c.L, 1e-12);
    CHECK_RELATIVE(middle(w_mid), steady.period.v_mid * c.T / c.L, 1e-12);
  }
  assert_true(before > 0 && after > 0);
}

/* Where pieces are one function a crossing may as well be measured in any of them, from either end. */
TEST(a_crossing_measured_elsewhere)
{
  const struct scallop_gait *const gaits[] = { &scallop_gait_sinusoidal, &minimum_jerk_gait, &trapezoid_gait };
  for (int g = 0; g < 3; g++) {
    const struct scallop_crawler c = { 1, 1, 4, 1, 1, 1, 0.75, gaits[g] };
    SCOPED(arb, w, zero, u);
    LIMIT(l, exact, &c);
    series_coefficient(w, &l.w, 0, PRECISION);
    assert_null(limit_holds(&l, w, w, zero, PRECISION));
    struct crossing *last = &l.branch[0].crossing[1];
    assert_int_equal(last->piece->anchor, SCALLOP_FROM_END);
    series_coefficient(u, &last->offset, 0, PRECISION);
    time_of_offset(u, last->piece, u, PRECISION);
    series_set_ball(&last->offset, u);
    last->piece = &gaits[g]->phase[0].pieces[0];
    assert_int_equal(limit_holds(&l, w, w, zero, PRECISION) != NULL, gaits[g] == &trapezoid_gait);
  }
}
