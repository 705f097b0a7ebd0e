/* The proven error bounds of the steady state's series, held against certified values; and that the modes change where
 * it is said. */
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "compare/points/gaits.h"
#include "tests/support/exact.h"
#include "tests/support/solved.h"

enum { PRECISION = 128, MOST_ORDER = 9, DIGITS = 60, CRAWLERS = 72, QUANTITIES = 2 };

/* T as parts of T0: to the very end, and down to where the first term left out is nearly all of the error */
static const double parts[] = { 1, 0.999, 0.7, 0.1, 1e-4 };
enum { PARTS = sizeof parts / sizeof *parts };

static const struct scallop_gait *const gaits[] = { &scallop_gait_quadratic, &scallop_gait_sinusoidal,
                                                    &trapezoid_gait };
enum { GAITS = 3 };

struct ratios { /* of the bound, |exact - terms below T^order| <= C T^power, to the error */
  double all[CRAWLERS];
  int count;
};

static int ascending(const void *a, const void *b)
{
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static void print_ratios(struct ratios *r, const char *what)
{
  qsort(r->all, (size_t)r->count, sizeof *r->all, ascending);
  print_message("%s: %d bounds, of the error: least %.4g, median %.3g, nine of ten below %.3g, most %.3g\n", what,
                r->count, r->all[0], r->all[r->count / 2], r->all[9 * r->count / 10], r->all[r->count - 1]);
}

/* T = part T0, rounded down to a fraction */
static void set_T(struct scallop_rational_crawler *c, const arb_t T0, double part)
{
  SCOPED(arb, T);
  SCOPED(arf, low);
  arb_set_d(T, part);
  arb_mul(T, T, T0, PRECISION);
  arb_get_lbound_arf(low, part == 1 ? T0 : T, PRECISION);
  arf_get_fmpq(c->T, low);
}

struct subject {
  struct scallop_rational_crawler crawler;
  struct scallop_expansion expansion;
  slong order;
  struct scallop_bound bounds[QUANTITIES];
};

/* The bound over the error. Below 1 for certain, and it is no bound. */
static double ratio(const struct subject *s, const arb_t exact, int quantity)
{
  const struct scallop_bound *b = &s->bounds[quantity];
  const struct series *series = quantity == 0 ? &s->expansion.v_start : &s->expansion.displacement;
  SCOPED(arb, T, error, bound);
  arb_set_fmpq(T, s->crawler.T, 4 * PRECISION);
  series_value(error, series, T, s->order, 4 * PRECISION);
  arb_sub(error, exact, error, 4 * PRECISION);
  arb_abs(error, error);
  arb_pow_ui(bound, T, (ulong)b->power, PRECISION);
  arb_mul(bound, bound, b->C, PRECISION);
  bool holds = !arb_gt(error, bound);
  arb_div(bound, bound, error, PRECISION);
  double times = arb_is_finite(bound) ? middle(bound) : INFINITY;
  return holds ? times : -times;
}

static void check_at(struct subject *s, double part, struct ratios *small)
{
  SCOPED(scallop_certified_steady, c);
  set_T(&s->crawler, s->bounds[0].T0, part);
  assert_int_equal(scallop_certified_steady(&s->crawler, DIGITS, &c, NULL), SCALLOP_OK);
  for (int q = 0; q < QUANTITIES; q++) {
    double times = ratio(s, q == 0 ? c.v_start : c.displacement, q);
    if (times < 0) {
      print_exact_crawler(&s->crawler);
      fail_msg("order %ld, quantity %d: the bound is %.17g of the error at %g T0", (long)s->order, q, -times, part);
    }
    if (part < 1e-3 && isfinite(times)) /* some series end, and nothing is left to bound */
      small[q].all[small[q].count++] = times;
  }
}

static void modes_at(const struct subject *s, double part, char modes[BOTH_MODES_TEXT])
{
  SCOPED(scallop_rational, c);
  SCOPED(scallop_certified_steady, there);
  scallop_rational_copy(&c, &s->crawler);
  set_T(&c, s->bounds[0].T_end, part);
  assert_int_equal(scallop_certified_steady(&c, 20, &there, NULL), SCALLOP_OK);
  both_modes(there.modes, modes);
}

/* False: they are refused. */
static bool find_bounds(struct subject *s, const char **why)
{
  struct scallop_bound *b = s->bounds;
  if (scallop_steady_bounds(&s->crawler, s->order, PRECISION, b, why) != SCALLOP_OK)
    return false;
  assert_int_equal(scallop_expand_steady(&s->crawler, MOST_ORDER + 1, 4 * PRECISION, &s->expansion, NULL), SCALLOP_OK);
  for (int q = 0; q < QUANTITIES; q++) {
    assert_true(b[q].power >= s->order);
    assert_true(arb_is_positive(b[q].T0) && arb_lt(b[q].T0, b[q].T_end));
    assert_non_null(b[q].ends);
  }
  return true;
}

/* Every order for every gait. A few trapezoids have no series. */
static void draw(struct subject *s, struct random *r, int i)
{
  const char *why;
  s->order = 1 + i / GAITS % MOST_ORDER;
  do
    random_exact_crawler(&s->crawler, r, gaits[i % GAITS]);
  while (!find_bounds(s, &why) && s->crawler.gait == &trapezoid_gait);
}

#define SUBJECT(of) \
  of(scallop_rational, &s->crawler) of(scallop_expansion, &s->expansion) of(scallop_bound, &s->bounds[0]) \
      of(scallop_bound, &s->bounds[1])
SCOPED_PARTS(subject, struct subject, SUBJECT)

/* What both tests look at: crawlers with their bounds, found once */
static struct subject subjects[CRAWLERS];

static int find_all(void **state)
{
  (void)state;
  struct random r = { 20260841 };
  for (int i = 0; i < CRAWLERS; i++) {
    subject_init(&subjects[i]);
    draw(&subjects[i], &r, i);
  }
  return 0;
}

static int forget_all(void **state)
{
  (void)state;
  for (int i = 0; i < CRAWLERS; i++)
    subject_clear(&subjects[i]);
  return 0;
}

TEST(bounds_hold)
{
  static struct ratios small[QUANTITIES];
  for (int i = 0; i < CRAWLERS; i++)
    for (int k = 0; k < PARTS; k++)
      check_at(&subjects[i], parts[k], small);
  for (int q = 0; q < QUANTITIES; q++) {
    assert_true(small[q].count > CRAWLERS / 2);
    print_ratios(&small[q], q == 0 ? "v_start" : "displacement");
    CHECK_AT_MOST(small[q].all[small[q].count / 2], 3);
    CHECK_AT_MOST(small[q].all[9 * small[q].count / 10], 1e3);
  }
}

TEST(modes_of_the_limit_up_to_the_end)
{
  static const double before[] = { 1e-3, 0.7, 0.999 };
  char modes[BOTH_MODES_TEXT];
  for (int i = 0; i < CRAWLERS; i++)
    for (size_t k = 0; k < sizeof before / sizeof *before; k++) {
      modes_at(&subjects[i], before[k], modes);
      assert_string_equal(modes, subjects[i].expansion.modes);
    }
}

/* And others beyond, or else a switching time passes a corner of l'. */
static bool ends_at(const struct subject *s, double part)
{
  char modes[BOTH_MODES_TEXT];
  modes_at(s, part, modes);
  return strcmp(modes, s->expansion.modes) != 0 || strstr(s->bounds[0].ends, "corner");
}

TEST(other_modes_beyond_the_end)
{
  int soon = 0, late = 0;
  for (int i = 0; i < CRAWLERS; i++) {
    bool later = ends_at(&subjects[i], 1.05);
    soon += !ends_at(&subjects[i], 1.01);
    late += !later;
    if (!later) {
      print_exact_crawler(&subjects[i].crawler);
      print_error("T_end = %.4g, \"%s\": the modes at 1.05 T_end are still %s\n", middle(subjects[i].bounds[0].T_end),
                  subjects[i].bounds[0].ends, subjects[i].expansion.modes);
    }
  }
  print_message("the same modes at 1.01 T_end: %d of %d, at 1.05 T_end: %d\n", soon, CRAWLERS, late);
  assert_int_equal(late, 0);
  assert_true(soon <= CRAWLERS / 10);
}

/* Refused, with a reason, and the bounds as they were */
static void refuses_at(struct subject *s, slong order, slong precision, enum scallop_status wanted,
                       const char *fragment)
{
  const char *why = NULL;
  arb_one(s->bounds[0].C);
  s->bounds[0].power = 77;
  assert_int_equal(scallop_steady_bounds(&s->crawler, order, precision, s->bounds, &why), wanted);
  assert_non_null(why);
  assert_non_null(strstr(why, fragment));
  assert_int_equal(scallop_steady_bounds(&s->crawler, order, precision, s->bounds, NULL), wanted);
  assert_true(arb_is_one(s->bounds[0].C) && s->bounds[0].power == 77);
}

static void refuses(struct subject *s, slong order, enum scallop_status wanted, const char *fragment)
{
  refuses_at(s, order, PRECISION, wanted, fragment);
}

TEST(refusals)
{
  struct random r = { 20260842 };
  SCOPED(subject, s);
  for (int i = 0; i < 2; i++) {
    random_exact_crawler(&s.crawler, &r, gaits[i]);
    refuses(&s, 0, SCALLOP_EDOMAIN, "order");
    refuses(&s, -3, SCALLOP_EDOMAIN, "order");
    refuses(&s, SCALLOP_MOST_TERMS + 1, SCALLOP_EDOMAIN, "order");
    refuses_at(&s, 4, 15, SCALLOP_EDOMAIN, "bits");
    fmpq_neg(s.crawler.m2, s.crawler.m2);
    refuses(&s, 4, SCALLOP_EDOMAIN, "domain");
    fmpq_neg(s.crawler.m2, s.crawler.m2);
    fmpq_set_si(s.crawler.alpha, 1, 2);
    refuses(&s, 4, SCALLOP_EDOMAIN, "alpha = 1/2");
    fmpq_set_si(s.crawler.alpha, 1, 3);
    fmpq_set(s.crawler.F2, s.crawler.F1);
    refuses(&s, 4, SCALLOP_EDOMAIN, "F1 = F2");
  }
  random_exact_crawler(&s.crawler, &r, &sawtooth_gait);
  refuses(&s, 4, SCALLOP_EUNDECIDED, "");
}

/* How long the proof takes, in seconds of the processor */
static double time_of_proof(const char *gait, const double numbers[6], double *T, const char **ends)
{
  const struct scallop_crawler c = { numbers[0], numbers[1], numbers[2], numbers[3],
                                     numbers[4], 1,          numbers[5], gait_of_text(gait).gait };
  SCOPED(scallop_rational, exact);
  SCOPED(arb, proven);
  scallop_rational_of(&exact, &c);
  const clock_t begun = clock();
  assert_int_equal(scallop_steady_modes_hold(&exact, PRECISION, proven, ends, NULL), SCALLOP_OK);
  *T = middle(proven);
  return (double)(clock() - begun) / CLOCKS_PER_SEC;
}

/* Where c is about to touch a curve the proof does not halve its pieces until they are as short as c is near: that took
 * two hundred times as long as a plain proof. */
TEST(proofs_beside_a_grazed_curve_are_short)
{
  static const double plain[] = { 1, 1, 4, 1, 10, 0.75 },
                      grazes[][6] = { { 3.886, 0.1723, 0.4307, 6.761, 1.992, 0.447 },
                                      { 2.87, 0.1327, 0.932, 4.669, 8.798, 0.355 } };
  static const double events[] = { 0.88831012281993, 2.51802357079357 };
  const char *ends;
  double T, unit = time_of_proof("polynomial:0,3,-2", plain, &T, &ends);
  for (int i = 0; i < 2; i++) {
    double time = time_of_proof("polynomial:0,3,-2", grazes[i], &T, &ends);
    print_message("up to T = %.12g: %.3f s, against %.3f s\n", T, time, unit);
    assert_non_null(strstr(ends, "begins or ceases to turn in the extension"));
    assert_true(T < events[i] && T > events[i] * (1 - 1e-8));
    assert_true(time < 30 * fmax(unit, 0.05));
  }
}

static void refuse_modes(const struct scallop_rational_crawler *crawler, slong precision, enum scallop_status wanted)
{
  const char *ends = "untouched", *why = NULL;
  SCOPED(arb, T);
  assert_int_equal(scallop_steady_modes_hold(crawler, precision, T, &ends, &why), wanted);
  assert_non_null(why);
  assert_int_equal(scallop_steady_modes_hold(crawler, precision, T, &ends, NULL), wanted);
  assert_string_equal(ends, "untouched");
  assert_true(arb_is_zero(T));
}

TEST(refusals_of_modes)
{
  struct random r = { 20260843 };
  SCOPED(subject, s);
  random_exact_crawler(&s.crawler, &r, &scallop_gait_quadratic);
  refuse_modes(&s.crawler, 15, SCALLOP_EDOMAIN);
  fmpq_neg(s.crawler.m2, s.crawler.m2);
  refuse_modes(&s.crawler, PRECISION, SCALLOP_EDOMAIN);
  random_exact_crawler(&s.crawler, &r, &sawtooth_gait);
  refuse_modes(&s.crawler, PRECISION, SCALLOP_EUNDECIDED);
}

int main(void) { return check_run(find_all, forget_all); }
