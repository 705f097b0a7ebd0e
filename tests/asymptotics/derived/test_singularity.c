/* The singularities of the branch that the series expand: beside the growth of the coefficients, a closed form, and the
 * poles of rational functions. */
#include "asymptotics/derived/continuation.h"
#include "asymptotics/derived/derived.h"
#include "tests/support/odd_gaits.h"
#include "tests/support/exact.h"
#include "tests/support/solved.h"

enum { PRECISION = 128 };

struct subject {
  struct scallop_rational_crawler crawler;
  struct scallop_singularity singularity;
};

static void begin(struct subject *s, const struct scallop_crawler *crawler)
{
  scallop_rational_init(&s->crawler);
  scallop_rational_of(&s->crawler, crawler);
  scallop_singularity_init(&s->singularity);
}

static void end(struct subject *s)
{
  scallop_rational_clear(&s->crawler);
  scallop_singularity_clear(&s->singularity);
}

#define SUBJECT(s, of) \
  ENDED_BY(end) struct subject s; \
  begin(&(s), of)
/* With the singularity of its steady state */
#define STEADY_SUBJECT(s, of) \
  SUBJECT(s, of); \
  assert_int_equal(scallop_steady_singularity(&(s).singularity, &(s).crawler, PRECISION, NULL), SCALLOP_OK)

/* Found, and nothing is nearer */
static void check_proven(const struct scallop_singularity *s)
{
  assert_true(s->found);
  assert_true(arb_equal(s->low, s->T));
  assert_true(arb_rel_accuracy_bits(s->T) > 80);
}

/* How far the coefficients a_j of Z^j, Z = T^4, are from those of branch points at Z and its conjugate: b_j = j^(3/2)
 * a_j |Z|^j is then Re(A e^(i j arg Z)) but for terms of the order of 1/j, and b_(j+1) - 2 cos(arg Z) b_j + b_(j-1), of
 * a real Z b_(j+1) -+ b_j, is of the order of 1/j^2 beside it. */
static double strangeness(const struct series *a, double T, double angle, slong j)
{
  double b[3];
  SCOPED(arb, ball, power);
  for (int i = 0; i < 3; i++) {
    slong k = j - 1 + i;
    series_coefficient(ball, a, 4 * k, PRECISION);
    arb_set_d(power, T);
    arb_pow_ui(power, power, (ulong)(4 * k), PRECISION);
    arb_mul(ball, ball, power, PRECISION);
    b[i] = middle(ball) * pow((double)k, 1.5);
  }
  double most = fmax(fabs(b[0]), fmax(fabs(b[1]), fabs(b[2])));
  bool real = fabs(sin(angle)) < 1e-9;
  return fabs(real ? b[2] - cos(angle) * b[1] : b[2] - 2 * cos(angle) * b[1] + b[0]) / most;
}

/* Twice as many coefficients make that four times smaller; had T an error of 1 %, which is one of 4 % in Z, it would
 * stay at 0.04. */
static void check_growth(const struct subject *s, double error)
{
  enum { FEW = 14, MANY = 28, ORDER = 4 * MANY + 8, BITS = 1024 };
  SCOPED(scallop_expansion, e);
  assert_int_equal(scallop_expand_steady(&s->crawler, ORDER, BITS, &e, NULL), SCALLOP_OK);
  double T = middle(s->singularity.T) * (1 + error);
  double angle = 2 * atan2(middle(acb_imagref(s->singularity.place)), middle(acb_realref(s->singularity.place)));
  double few = strangeness(&e.displacement, T, angle, FEW), many = strangeness(&e.displacement, T, angle, MANY);
  bool agrees = many < 0.04 && (many < few / 2 || many < 1e-3);
  if (agrees != (error == 0))
    fail_msg("T %.17g (error %g), angle %g: %g, then %g", T, error, angle, few, many);
}

TEST(coefficients_grow_as_the_singularity_says)
{
  enum { CRAWLERS = 20 };
  struct random r = { 82 };
  for (int i = 0; i < CRAWLERS; i++) {
    const struct scallop_crawler c = moderate_crawler(&r, 10, 0.05, &scallop_gait_sinusoidal);
    STEADY_SUBJECT(s, &c);
    check_proven(&s.singularity);
    assert_true(s.singularity.even && s.singularity.shows[TRAVEL] && s.singularity.shows[AT_START]);
    check_growth(&s, 0);
    if (i == 0) { /* and the check can fail */
      check_growth(&s, 0.01);
      check_growth(&s, -0.01);
    }
  }
}

/* Of the default crawler, where other sheets have branch points too: one nearer, which the branch does not meet, and
 * one on the real axis a thousandth farther, between the two that are the nearest. */
TEST(branch_points_of_other_sheets)
{
  struct scallop_crawler c = with_gait(&scallop_gait_sinusoidal);
  STEADY_SUBJECT(s, &c);
  check_proven(&s.singularity);
  assert_false(arb_contains_zero(acb_imagref(s.singularity.place)));
  check_growth(&s, 0);
  check_growth(&s, 0.02);
  check_growth(&s, -0.02);
}

/* From rest the last switch of a sinusoidal extension solves q (pi/2) sin(x) = eps beta x/pi, x = pi s; its branch
 * points are where tan(x) = x, the one that it meets at x = 4.4934, where eps < 0. */
TEST(from_rest)
{
  struct scallop_crawler c = with_gait(&scallop_gait_sinusoidal);
  double x = 4.5;
  for (int i = 0; i < 10; i++)
    x -= (x * cos(x) - sin(x)) / (-x * sin(x));
  double q = c.m2 / (c.m1 + c.m2), beta = (c.F1 - c.F2) / (c.F1 + c.F2), pi = acos(-1);
  double eps = q * pi * pi / 2 * cos(x) / beta, T = sqrt(-eps * (c.m1 + c.m2) * c.L / (c.F1 + c.F2));
  SUBJECT(s, &c);
  SCOPED(fmpq, v0);
  assert_int_equal(scallop_phase_singularity(&s.singularity, &s.crawler, SCALLOP_EXTENSION, v0, 9, PRECISION, NULL),
                   SCALLOP_OK);
  check_proven(&s.singularity);
  CHECK_RELATIVE(middle(s.singularity.T), T, 1e-14);
  assert_true(arb_contains_zero(acb_realref(s.singularity.place)));
  for (int k = AFTER_FIRST_PHASE; k < CONTINUED_VALUES; k++)
    assert_true(s.singularity.shows[k]);
  assert_false(s.singularity.shows[AT_START]);
}

/* The first crossing knows nothing of the second: its series goes on converging where that of the second does not. */
TEST(first_crossing_alone)
{
  struct scallop_crawler c = with_gait(&scallop_gait_sinusoidal);
  double T[2];
  SUBJECT(s, &c);
  SCOPED(fmpq, v0);
  fmpq_set_si(v0, 1, 2);
  for (int i = 0; i < 2; i++) {
    assert_int_equal(
        scallop_phase_singularity(&s.singularity, &s.crawler, SCALLOP_CONTRACTION, v0, 1 + i, PRECISION, NULL),
        SCALLOP_OK);
    check_proven(&s.singularity);
    T[i] = middle(s.singularity.T);
  }
  assert_true(T[0] > 1.5 * T[1]);
}

/* T goes as the square root of L; w = 0 in the limit at alpha = 1/2; nothing is singular of a crawler that rests. */
TEST(special_crawlers)
{
  struct scallop_crawler c = with_gait(&scallop_gait_sinusoidal);
  c.alpha = 0.5;
  STEADY_SUBJECT(s, &c);
  check_proven(&s.singularity);
  assert_true(s.singularity.shows[AT_START] && !s.singularity.shows[TRAVEL]);
  c.L *= 4;
  STEADY_SUBJECT(longer, &c);
  CHECK_RELATIVE(middle(longer.singularity.T), 2 * middle(s.singularity.T), 4 * 0x1p-53);
  c.F1 = c.F2;
  STEADY_SUBJECT(resting, &c);
  assert_true(!resting.singularity.found && arf_is_pos_inf(arb_midref(resting.singularity.low)));
}

/* Of a polynomial gait, whose crossings are joined as those of the sine are */
TEST(minimum_jerk)
{
  struct scallop_crawler c = with_gait(&minimum_jerk_gait);
  STEADY_SUBJECT(s, &c);
  check_proven(&s.singularity);
  check_growth(&s, 0);
}

TEST(no_expansion_no_singularity)
{
  const char *why = NULL;
  struct scallop_crawler c = with_gait(&minimum_jerk_gait);
  SUBJECT(s, &c);
  SCOPED(fmpq, v0);
  assert_int_equal(scallop_phase_singularity(&s.singularity, &s.crawler, SCALLOP_EXTENSION, v0, 9, PRECISION, &why),
                   SCALLOP_EDOMAIN);
  assert_ptr_equal(why, branch_without_ends);
  assert_int_equal(scallop_phase_singularity(&s.singularity, &s.crawler, SCALLOP_EXTENSION, v0, 9, PRECISION, NULL),
                   SCALLOP_EDOMAIN);
  why = NULL;
  s.crawler.gait = &there_and_back_gait; /* l' changes its sign within a phase */
  assert_int_equal(scallop_phase_singularity(&s.singularity, &s.crawler, SCALLOP_EXTENSION, v0, 9, PRECISION, &why),
                   SCALLOP_EDOMAIN);
  assert_ptr_equal(why, branch_impossible);
  why = NULL;
  assert_int_equal(scallop_steady_singularity(&s.singularity, &s.crawler, PRECISION, &why), SCALLOP_EDOMAIN);
  assert_non_null(why);
  assert_int_equal(scallop_steady_singularity(&s.singularity, &s.crawler, PRECISION, NULL), SCALLOP_EDOMAIN);
  assert_true(!s.singularity.found && arf_is_pos_inf(arb_midref(s.singularity.low)));
}

/* D = (f(b) - f(a))/(b - a) of the law f: D_a = (D - f'(a))/(b - a), D_b = (f'(b) - D)/(b - a) and so on, in balls */
static void check_joined(struct continued_crossing *at, acb_srcptr a, acb_srcptr b)
{
  acb_ptr d = _acb_vec_init(JET), fa = _acb_vec_init(JET), fb = _acb_vec_init(JET), wanted = _acb_vec_init(JET);
  SCOPED(acb, way);
  acb_sub(way, b, a, PRECISION);
  at->joined = true;
  continued_law(d, at, a, b, PRECISION);
  at->joined = false;
  continued_law(fa, at, a, a, PRECISION);
  continued_law(fb, at, a, b, PRECISION);
  acb_sub(wanted + JET_VALUE, fb + JET_VALUE, fa + JET_VALUE, PRECISION);
  acb_sub(wanted + JET_A, d + JET_VALUE, fa + JET_B, PRECISION);
  acb_sub(wanted + JET_B, fb + JET_B, d + JET_VALUE, PRECISION);
  acb_mul_2exp_si(wanted + JET_AA, d + JET_A, 1);
  acb_sub(wanted + JET_AA, wanted + JET_AA, fa + JET_BB, PRECISION);
  acb_sub(wanted + JET_AB, d + JET_B, d + JET_A, PRECISION);
  acb_mul_2exp_si(wanted + JET_BB, d + JET_B, 1);
  acb_sub(wanted + JET_BB, fb + JET_BB, wanted + JET_BB, PRECISION);
  for (int k = 0; k < JET; k++) {
    acb_div(wanted + k, wanted + k, way, PRECISION);
    assert_true(acb_overlaps(d + k, wanted + k));
    assert_true(acb_rel_accuracy_bits(d + k) > 60);
  }
  _acb_vec_clear(d, JET);
  _acb_vec_clear(fa, JET);
  _acb_vec_clear(fb, JET);
  _acb_vec_clear(wanted, JET);
}

TEST(joined_crossings)
{
  struct random r = { 83 };
  struct continued_crossing at = { .sine = true };
  SCOPED(acb, a, b);
  arb_init(at.q);
  arb_init(at.base);
  arb_poly_init(at.law);
  arb_set_d(at.q, 0.7);
  arb_set_d(at.base, 0.3);
  for (int i = 0; i < 40; i++) {
    double size = i % 4 < 2 ? 1 : 0.1;
    at.sine = i % 2;
    arb_set_d(acb_realref(a), random_between(&r, -1, 1));
    arb_set_d(acb_imagref(a), random_between(&r, -1, 1));
    arb_set_d(acb_realref(b), size * random_between(&r, -1, 1));
    arb_set_d(acb_imagref(b), size * random_between(&r, -1, 1));
    acb_add(b, b, a, PRECISION);
    arb_poly_zero(at.law);
    for (int k = 0; k < 6; k++) {
      arb_set_d(acb_realref(a), random_between(&r, -1, 1));
      arb_poly_set_coeff_arb(at.law, k, acb_realref(a));
    }
    check_joined(&at, a, b);
  }
  arb_clear(at.q);
  arb_clear(at.base);
  arb_poly_clear(at.law);
}

/* Without crossings that are joined the crossing with itself would be met on the way, where the derivative of the
 * equations is singular and the branch is not: for every other crawler or so on the imaginary axis of T^2. */
TEST(a_crossing_does_not_meet_itself)
{
  const struct scallop_crawler c = {
    2.25, 0.1640625, 0.48828125, 0.703125, 1, 1, 0.88671875, &scallop_gait_sinusoidal
  };
  STEADY_SUBJECT(s, &c);
  check_proven(&s.singularity);
  assert_true(arb_contains_zero(acb_realref(s.singularity.place)));
  check_growth(&s, 0);
}

enum gathered { NOTHING, MANY_PLACES, MANY_FOLDS, MANY_SECTORS, MORE_SECTORS };

/* What a long search could have gathered: places and folds that are nowhere near, sectors whose turn never comes. */
static void gather(struct singularity_search *s, enum gathered what)
{
  enum { AT_FIRST = 8 };
  int sectors = what == MORE_SECTORS ? MOST_SECTORS - AT_FIRST : what == MANY_SECTORS ? MOST_SECTORS - AT_FIRST - 1 : 0;
  if (what == MANY_PLACES)
    s->places = MOST_PLACES;
  for (; what == MANY_FOLDS && s->folds < MOST_FOLDS; s->folds++)
    fold_init(&s->fold[s->folds], s->apart);
  for (; s->sectors < sectors; s->sectors++)
    s->sector[s->sectors] =
        (struct sector){ .r = INFINITY, .at = _acb_vec_init(s->n + 1), .around = _acb_vec_init(s->n + 1) };
}

struct outcome {
  double covered, reach;
};

/* Of the steady state of the default crawler, sinusoidal. shift: of the velocity at z = 0 from where the branch
 * begins */
static struct outcome search_after(enum gathered what, slong shift)
{
  struct scallop_crawler c = with_gait(&scallop_gait_sinusoidal);
  struct continuation both[2];
  SUBJECT(subject, &c);
  SCOPED(limit, l);
  SCOPED(fmpq, kappa);
  fmpq_one(kappa);
  assert_int_equal(limit_find(&l, &subject.crawler, PRECISION, NULL), SCALLOP_OK);
  for (int join = 0; join < 2; join++)
    continue_steady(&both[join], &l, kappa, join, PRECISION);
  acb_add_si(both[0].start, both[0].start, shift, PRECISION);
  struct singularity_search *s = search_new(both, 0.5, PRECISION);
  gather(s, what);
  struct outcome outcome = { .covered = search_cover(s) };
  outcome.reach = s->reach;
  search_free(s);
  for (int join = 0; join < 2; join++)
    continuation_clear(&both[join]);
  return outcome;
}

/* Without room the search finds nothing, and the proof goes no farther than the branch point that there is. */
TEST(a_search_without_room)
{
  struct outcome whole = search_after(NOTHING, 0);
  assert_true(whole.covered > 0 && whole.covered >= whole.reach);
  for (int what = MANY_PLACES; what <= MORE_SECTORS; what++) {
    struct outcome less = search_after((enum gathered)what, 0);
    assert_true(isinf(less.reach));
    assert_true(less.covered > whole.reach / 4 && less.covered < whole.reach);
  }
}

TEST(a_search_from_beside_the_branch) { CHECK_EQUAL(search_after(NOTHING, 100).covered, 0); }

/* l' jumps and is then constant: no body turns, however small T is, and the expansion is a polynomial. */
TEST(no_crossing_no_singularity)
{
  struct scallop_straight constant;
  const double ramp[2] = { 0, 0 };
  assert_int_equal(scallop_make_constant(&constant, "x", ramp), SCALLOP_OK);
  struct scallop_crawler c = with_gait(&constant.gait);
  SUBJECT(s, &c);
  SCOPED(fmpq, v0);
  fmpq_one(v0);
  assert_int_equal(scallop_phase_singularity(&s.singularity, &s.crawler, SCALLOP_EXTENSION, v0, 9, PRECISION, NULL),
                   SCALLOP_OK);
  assert_true(!s.singularity.found);
}
