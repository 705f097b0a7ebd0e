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

#define SUBJECT_PARTS(of) of(scallop_rational, &s->crawler) of(scallop_singularity, &s->singularity)
SCOPED_PARTS(subject, struct subject, SUBJECT_PARTS)

#define SUBJECT(s, of) \
  SCOPED(subject, s); \
  scallop_rational_of(&(s).crawler, of)
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

/* Random crawlers, and these:
 * 0: the default one, where other sheets have branch points too: one nearer, which the branch does not meet, and one on
 * the real axis a thousandth farther, between the two that are the nearest;
 * 1: without crossings that are joined the crossing with itself would be met on the way, where the derivative of the
 * equations is singular and the branch is not: for every other crawler or so on the imaginary axis of T^2;
 * 2: of a polynomial gait, whose crossings are joined as those of the sine are. */
TEST(coefficients_grow_as_the_singularity_says)
{
  enum { SPECIAL = 3, CRAWLERS = SPECIAL + 4 };
  const struct scallop_crawler special[SPECIAL] = {
    with_gait(&scallop_gait_sinusoidal),
    { 2.25, 0.1640625, 0.48828125, 0.703125, 1, 1, 0.88671875, &scallop_gait_sinusoidal },
    with_gait(&minimum_jerk_gait),
  };
  struct random r = { 82 };
  for (int i = 0; i < CRAWLERS; i++) {
    const struct scallop_crawler c = i < SPECIAL ? special[i]
                                                 : moderate_crawler(&r, 10, 0.05, &scallop_gait_sinusoidal);
    STEADY_SUBJECT(s, &c);
    check_proven(&s.singularity);
    assert_true(s.singularity.even && s.singularity.shows[TRAVEL] && s.singularity.shows[AT_START]);
    assert_true(i != 0 || !arb_contains_zero(acb_imagref(s.singularity.place)));
    assert_true(i != 1 || arb_contains_zero(acb_realref(s.singularity.place)));
    check_growth(&s, 0);
    if (i == 0 || i == SPECIAL) { /* and the check can fail */
      check_growth(&s, i ? 0.01 : 0.02);
      check_growth(&s, i ? -0.01 : -0.02);
    }
  }
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

static void refuses(struct subject *s, bool steady, const char *wanted)
{
  SCOPED(fmpq, v0);
  for (int i = 0; i < 2; i++) {
    const char *why = NULL, **to = i ? NULL : &why;
    assert_int_equal(
        steady ? scallop_steady_singularity(&s->singularity, &s->crawler, PRECISION, to)
               : scallop_phase_singularity(&s->singularity, &s->crawler, SCALLOP_EXTENSION, v0, 9, PRECISION, to),
        SCALLOP_EDOMAIN);
    assert_true(!to || (wanted ? why == wanted : why != NULL));
    assert_true(!s->singularity.found && arf_is_pos_inf(arb_midref(s->singularity.low)));
  }
}

TEST(no_expansion_no_singularity)
{
  struct scallop_crawler c = with_gait(&minimum_jerk_gait);
  SUBJECT(s, &c);
  refuses(&s, false, branch_without_ends);
  s.crawler.gait = &there_and_back_gait; /* l' changes its sign within a phase */
  refuses(&s, false, branch_impossible);
  refuses(&s, true, NULL);
}

/* D = (f(b) - f(a))/(b - a) of the law f: D_a = (D - f'(a))/(b - a), D_b = (f'(b) - D)/(b - a) and so on, in balls */
static void check_joined(struct continued_crossing *at, acb_srcptr a, acb_srcptr b)
{
  SCOPED_BALLS(d, JET);
  SCOPED_BALLS(fa, JET);
  SCOPED_BALLS(fb, JET);
  SCOPED_BALLS(wanted, JET);
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
}

static void random_complex(acb_t z, struct random *r, double size)
{
  arb_set_d(acb_realref(z), size * random_between(r, -1, 1));
  arb_set_d(acb_imagref(z), size * random_between(r, -1, 1));
}

TEST(joined_crossings)
{
  struct random r = { 83 };
  struct continued_crossing at = { .sine = true };
  SCOPED(acb, a, b);
  SCOPED(arb, c);
  arb_init(at.q);
  arb_init(at.base);
  arb_poly_init(at.law);
  arb_set_d(at.q, 0.7);
  arb_set_d(at.base, 0.3);
  for (int i = 0; i < 40; i++) {
    at.sine = i % 2;
    random_complex(a, &r, 1);
    random_complex(b, &r, i % 4 < 2 ? 1 : 0.1);
    acb_add(b, b, a, PRECISION);
    arb_poly_zero(at.law);
    for (int k = 0; k < 6; k++) {
      arb_set_d(c, random_between(&r, -1, 1));
      arb_poly_set_coeff_arb(at.law, k, c);
    }
    check_joined(&at, a, b);
  }
  arb_clear(at.q);
  arb_clear(at.base);
  arb_poly_clear(at.law);
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

/* Of the extension from rest of the default crawler, sinusoidal: how far is proven. shift: of the velocity at z = 0
 * from where the branch begins */
static double search_after(enum gathered what, slong shift, double *reach)
{
  struct scallop_crawler c = with_gait(&scallop_gait_sinusoidal);
  struct continuation both[2];
  SUBJECT(subject, &c);
  SCOPED(phase_constants, phase);
  SCOPED(branch, b);
  SCOPED(fmpq, kappa, v0);
  set_kappa(kappa, &subject.crawler);
  assert_null(branch_of_phase(&b, &phase, &subject.crawler, SCALLOP_EXTENSION, v0, 1, PRECISION));
  for (int join = 0; join < 2; join++)
    continue_phase(&both[join], &b, &phase, b.count, v0, kappa, join, PRECISION);
  acb_add_si(both[0].start, both[0].start, shift, PRECISION);
  struct singularity_search *s = search_new(both, 1, PRECISION);
  gather(s, what);
  double covered = search_cover(s);
  *reach = s->reach;
  search_free(s);
  for (int join = 0; join < 2; join++)
    continuation_clear(&both[join]);
  return covered;
}

/* Without room the search finds nothing, and the proof goes no farther than the branch point that there is; it does not
 * begin beside the branch. */
TEST(a_search_without_room)
{
  double found, reach, covered = search_after(NOTHING, 0, &found);
  assert_true(covered > 0 && covered >= found);
  for (int what = MANY_PLACES; what <= MORE_SECTORS; what++) {
    covered = search_after((enum gathered)what, 0, &reach);
    assert_true(isinf(reach) && covered > found / 4 && covered < found);
  }
  CHECK_EQUAL(search_after(NOTHING, 100, &reach), 0);
}

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
