/* Branches and limits from the inside: the motions that have no enclosure, and
 * no expansion, are not given one. */
#include "tests/check.h"

#include "asymptotics/derived/holds.h"
#include "asymptotics/derived/limit.h"
#include "numerics/numerics.h"
#include "tests/exact.h"
#include "tests/odd_gaits.h"

enum { PRECISION = 128 };

struct subject {
  struct scallop_rational_crawler crawler;
  struct phase_constants phase;
  struct branch branch;
  arb_t c, eps, one;
};

/* m1 = m2, F1 = 4 F2, an extension */
static void subject_init(struct subject *s, const struct scallop_gait *gait)
{
  const struct scallop_crawler c = { 1, 1, 4, 1, 1, 1, 0.75, gait };
  scallop_rational_init(&s->crawler);
  scallop_rational_of(&s->crawler, &c);
  phase_constants_init(&s->phase, &s->crawler, SCALLOP_EXTENSION);
  branch_init(&s->branch);
  arb_init(s->c);
  arb_init(s->eps);
  arb_init(s->one);
  arb_one(s->one);
}

static void subject_clear(struct subject *s)
{
  scallop_rational_clear(&s->crawler);
  phase_constants_clear(&s->phase);
  branch_clear(&s->branch);
  arb_clear(s->c);
  arb_clear(s->eps);
  arb_clear(s->one);
}

/* ---- levels ---- */

/* |l'| of trapezoid: 0 to 16/13, and curve 0 is half of that. */
static void levels(void **state)
{
  (void)state;
  static const struct {
    double c;
    int crossings; /* -1: cannot be told */
  } cases[] = { { 0, -1 }, { 0.3, 2 }, { -0.3, 2 }, { 0.7, 0 }, { -0.7, 0 } };
  struct subject s;
  subject_init(&s, &trapezoid_gait);
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    arb_set_d(s.c, cases[i].c);
    assert_int_equal(branch_of_level(&s.branch, &s.phase, s.c, PRECISION), cases[i].crossings >= 0);
    if (cases[i].crossings >= 0)
      assert_int_equal(s.branch.count, cases[i].crossings);
  }
  fmpq_t along; /* c = 8/13 runs along the curve */
  fmpq_init(along);
  fmpq_set_si(along, 8, 13);
  arb_set_fmpq(s.c, along, PRECISION);
  assert_false(branch_of_level(&s.branch, &s.phase, s.c, PRECISION));
  fmpq_clear(along);
  subject_clear(&s);
}

/* A branch has room for MOST_CROSSINGS, and 16 teeth are crossed twice as
 * often. */
static void more_crossings_than_there_is_room_for(void **state)
{
  (void)state;
  struct teeth teeth;
  struct subject s;
  grow_teeth(&teeth);
  subject_init(&s, &teeth.gait);
  arb_set_d(s.c, 0.5);
  assert_false(branch_of_level(&s.branch, &s.phase, s.c, PRECISION));
  assert_int_equal(s.branch.count, MOST_CROSSINGS);
  teeth.gait.phase[SCALLOP_EXTENSION].count = MOST_CROSSINGS; /* half of the phase */
  assert_true(branch_of_level(&s.branch, &s.phase, s.c, PRECISION));
  assert_int_equal(s.branch.count, MOST_CROSSINGS);
  for (int i = 0; i < MOST_CROSSINGS; i++) { /* q |l'| = 1/2 at a quarter of a tooth from either side */
    arb_t u;
    arb_init(u);
    series_coefficient(u, &s.branch.crossing[i].offset, 0, PRECISION);
    int tooth = i / 2;
    CHECK_NEAR(nearest(u), (tooth + (i % 2 ? 0.75 : 0.25)) / TEETH, 1e-15);
    arb_clear(u);
  }
  subject_clear(&s);
}

/* ---- crossings that are none ---- */

static void set_offset(struct subject *s, double u)
{
  arb_t at;
  arb_init(at);
  arb_set_d(at, u);
  series_set_ball(&s->branch.crossing[0].offset, at);
  arb_clear(at);
}

/* At the plateau, where the slope of the curve is that of the line: no time is
 * the crossing. */
static void crossings_along_the_curve(void **state)
{
  (void)state;
  const struct ring ring = { 4, PRECISION };
  struct subject s;
  struct base base;
  struct lift lift;
  struct series c, eps, one;
  arb_t before;
  arb_init(before);
  series_init(&c);
  series_init(&eps);
  series_init(&one);
  lift_init(&lift);
  base_init(&base);
  subject_init(&s, &trapezoid_gait);
  series_set_si(&one, 1);
  series_set_si(&eps, 0);
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
    set_offset(&s, u);
    assert_int_equal(lift_phase(&lift, &s.branch, &s.phase, &eps, &c, &one, NULL, &ring), !along);
    assert_int_equal(base_follow(&base, &s.branch, &s.phase, s.eps, s.c, s.one, false, PRECISION), !along);
    series_coefficient(before, &s.branch.crossing[0].offset, 0, PRECISION);
    CHECK_NEAR(nearest(before), u, 1e-30);
  }
  subject_clear(&s);
  base_clear(&base);
  lift_clear(&lift);
  series_clear(&c);
  series_clear(&eps);
  series_clear(&one);
  arb_clear(before);
}

/* ---- the limit ---- */

/* m1 = m2, F1 = 7 F2, alpha = 3/4: w = 3/8, crossings and all are fractions
 * with a power of 2 below, so that balls hold them exactly; an enclosure is
 * found all the same, and holds it. */
static void a_limit_that_balls_hold_exactly(void **state)
{
  (void)state;
  const struct scallop_crawler c = { 1, 1, 7, 1, 1, 1, 0.75, &scallop_gait_quadratic };
  struct scallop_rational_crawler exact;
  struct limit l;
  arb_t w, eps;
  fmpq_t value;
  const char *why;
  fmpq_init(value);
  arb_init(w);
  arb_init(eps);
  scallop_rational_init(&exact);
  scallop_rational_of(&exact, &c);
  limit_init(&l, &exact);
  assert_int_equal(limit_find(&l, &exact, PRECISION, &why), SCALLOP_OK);
  assert_true(series_rational_coefficient(value, &l.w, 0));
  CHECK_EQUAL(fmpq_get_d(value), 0.375);
  arb_set_d(w, 0.375);
  assert_true(limit_follow(&l, w, eps, PRECISION));
  assert_true(arb_contains_fmpq(w, value));
  assert_true(mag_cmp_2exp_si(arb_radref(w), -PRECISION / 2) < 0);
  limit_clear(&l);
  scallop_rational_clear(&exact);
  arb_clear(w);
  arb_clear(eps);
  fmpq_clear(value);
}

/* The velocity with which the contraction begins, in units of L and the period */
static void find_w_mid(arb_t w_mid, struct limit *l, const arb_t w, const arb_t eps)
{
  struct base base;
  arb_t fraction, here, c, one;
  base_init(&base);
  arb_init(fraction);
  arb_init(here);
  arb_init(c);
  arb_init(one);
  arb_one(one);
  arb_set_fmpq(fraction, l->phase[0].fraction, PRECISION);
  arb_mul(c, w, fraction, PRECISION);
  arb_mul(here, eps, fraction, PRECISION);
  arb_mul(here, here, fraction, PRECISION);
  assert_true(base_follow(&base, &l->branch[0], &l->phase[0], here, c, one, false, PRECISION));
  arb_div(w_mid, base.c_end, fraction, PRECISION);
  base_clear(&base);
  arb_clear(fraction);
  arb_clear(here);
  arb_clear(c);
  arb_clear(one);
}

/* Minimum jerk is one polynomial in four pieces. F1 = 22 F2 and alpha = 0.9: as eps grows the first crossing of the extension moves from
 * the second piece into the first, and nothing happens there: the modes hold, and this is the steady state. */
static void a_crossing_moves_to_another_piece(void **state)
{
  (void)state;
  struct scallop_crawler c = { 1, 1, 22, 1, 1, 1, 0.9, &minimum_jerk_gait };
  struct scallop_rational_crawler exact;
  struct scallop_steady_result steady;
  struct limit l;
  arb_t w, w_mid, eps, u;
  const char *why;
  int before = 0, after = 0;
  arb_init(w);
  arb_init(w_mid);
  arb_init(eps);
  arb_init(u);
  scallop_rational_init(&exact);
  scallop_rational_of(&exact, &c);
  limit_init(&l, &exact);
  assert_int_equal(limit_find(&l, &exact, PRECISION, &why), SCALLOP_OK);
  series_coefficient(w, &l.w, 0, PRECISION);
  assert_ptr_equal(l.branch[0].crossing[0].piece, &minimum_jerk_gait.phase[0].pieces[1]);
  for (int i = 1; i <= 16; i++) {
    c.T = 0.02 * i;
    arb_set_d(eps, crawler_eps(&c));
    assert_true(limit_follow(&l, w, eps, PRECISION));
    find_w_mid(w_mid, &l, w, eps);
    series_coefficient(u, &l.branch[0].crossing[0].offset, 0, PRECISION);
    *(nearest(u) < JERK_TURN ? &after : &before) += 1;
    assert_null(limit_holds(&l, w, w_mid, eps, PRECISION));
    assert_int_equal(scallop_steady(&c, &steady), SCALLOP_OK);
    CHECK_RELATIVE(nearest(w), steady.period.v_start * c.T / c.L, 1e-12);
    CHECK_RELATIVE(nearest(w_mid), steady.period.v_mid * c.T / c.L, 1e-12);
  }
  assert_true(before > 0 && after > 0);
  limit_clear(&l);
  scallop_rational_clear(&exact);
  arb_clear(w);
  arb_clear(w_mid);
  arb_clear(eps);
  arb_clear(u);
}

/* Where pieces are one function a crossing may as well be measured in any of them, from either end. */
static void a_crossing_measured_elsewhere(void **state)
{
  (void)state;
  const struct scallop_gait *const gaits[] = { &scallop_gait_sinusoidal, &minimum_jerk_gait, &trapezoid_gait };
  for (int g = 0; g < 3; g++) {
    const struct scallop_crawler c = { 1, 1, 4, 1, 1, 1, 0.75, gaits[g] };
    struct scallop_rational_crawler exact;
    struct limit l;
    arb_t w, zero, u;
    const char *why;
    arb_init(w);
    arb_init(zero);
    arb_init(u);
    scallop_rational_init(&exact);
    scallop_rational_of(&exact, &c);
    limit_init(&l, &exact);
    assert_int_equal(limit_find(&l, &exact, PRECISION, &why), SCALLOP_OK);
    series_coefficient(w, &l.w, 0, PRECISION);
    assert_null(limit_holds(&l, w, w, zero, PRECISION));
    struct crossing *last = &l.branch[0].crossing[1];
    assert_int_equal(last->piece->anchor, SCALLOP_FROM_END);
    series_coefficient(u, &last->offset, 0, PRECISION);
    time_of_offset(u, last->piece, u, PRECISION);
    series_set_ball(&last->offset, u);
    last->piece = &gaits[g]->phase[0].pieces[0];
    assert_int_equal(limit_holds(&l, w, w, zero, PRECISION) != NULL, gaits[g] == &trapezoid_gait);
    limit_clear(&l);
    scallop_rational_clear(&exact);
    arb_clear(w);
    arb_clear(zero);
    arb_clear(u);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(levels),
    cmocka_unit_test(more_crossings_than_there_is_room_for),
    cmocka_unit_test(crossings_along_the_curve),
    cmocka_unit_test(a_limit_that_balls_hold_exactly),
    cmocka_unit_test(a_crossing_moves_to_another_piece),
    cmocka_unit_test(a_crossing_measured_elsewhere),
  };
  return cmocka_run_group_tests_name("branch", tests, NULL, NULL);
}
