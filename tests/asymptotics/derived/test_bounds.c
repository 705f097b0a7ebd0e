/* The proven error bounds of the steady state's series, held against certified values; and that the modes change where
 * it is said. */
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "compare/points/gaits.h"
#include "tests/support/exact.h"
#include "tests/support/solved.h"

enum { PRECISION = 128, MOST_ORDER = 9, DIGITS = 60, CRAWLERS = 36, QUANTITIES = 2 };

/* T as parts of T0: to the very end, and down to where the first term left out is nearly all of the error */
static const double parts[] = { 1, 0.999, 0.7, 0.1, 1e-4 };
enum { PARTS = sizeof parts / sizeof *parts };

enum { GAITS = 3 }; /* the first of every_gait */

struct ratios { /* of the bound, |exact - terms below T^order| <= C T^power, to the error */
  double all[CRAWLERS];
  int count;
};

static int ascending(const void *a, const void *b)
{
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
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

static bool modes_are_those_of_the_limit(const struct subject *s, double part)
{
  char modes[BOTH_MODES_TEXT];
  SCOPED(scallop_rational, c);
  SCOPED(scallop_certified_steady, there);
  scallop_rational_copy(&c, &s->crawler);
  set_T(&c, s->bounds[0].T_end, part);
  assert_int_equal(scallop_certified_steady(&c, 20, &there, NULL), SCALLOP_OK);
  return strcmp(both_modes(there.modes, modes), s->expansion.modes) == 0;
}

/* Every order for every gait. A few trapezoids have no series. */
static void draw(struct subject *s, struct random *r, int i)
{
  struct scallop_bound *b = s->bounds;
  s->order = 1 + i / GAITS % MOST_ORDER;
  do
    random_exact_crawler(&s->crawler, r, every_gait[i % GAITS]);
  while (scallop_steady_bounds(&s->crawler, s->order, PRECISION, b, NULL) != SCALLOP_OK && i % GAITS == GAITS - 1);
  assert_int_equal(scallop_expand_steady(&s->crawler, MOST_ORDER + 1, 4 * PRECISION, &s->expansion, NULL), SCALLOP_OK);
  for (int q = 0; q < QUANTITIES; q++)
    assert_true(b[q].power >= s->order && arb_is_positive(b[q].T0) && arb_lt(b[q].T0, b[q].T_end) && b[q].ends);
}

#define SUBJECT(of) \
  of(scallop_rational, &s->crawler) of(scallop_expansion, &s->expansion) of(scallop_bound, &s->bounds[0]) \
      of(scallop_bound, &s->bounds[1])
SCOPED_PARTS(subject, struct subject, SUBJECT)

/* The modes of the limit up to the end, and others beyond, or else a switching time passes a corner of l'; except soon
 * after the end, which is true then. */
static bool modes_last_too_long(const struct subject *s)
{
  static const double at[] = { 1e-3, 0.7, 0.999, 1.05, 1.01 };
  bool right = true;
  for (int k = 0; k < 5; k++) {
    bool same = modes_are_those_of_the_limit(s, at[k]);
    right = k < 3 ? same : !same || strstr(s->bounds[0].ends, "corner");
    if (!right && k < 4) {
      print_exact_crawler(&s->crawler);
      fail_msg("T_end = %.4g, \"%s\": the modes at %g T_end", middle(s->bounds[0].T_end), s->bounds[0].ends, at[k]);
    }
  }
  return !right;
}

TEST(bounds_hold_and_modes_change_at_the_end)
{
  static struct ratios small[QUANTITIES];
  struct random r = { 20260841 };
  int late = 0;
  for (int i = 0; i < CRAWLERS; i++) {
    SCOPED(subject, s);
    draw(&s, &r, i);
    late += modes_last_too_long(&s);
    for (int k = 0; k < PARTS; k++)
      check_at(&s, parts[k], small);
  }
  print_message("the same modes at 1.01 T_end: %d of %d\n", late, CRAWLERS);
  assert_true(late <= CRAWLERS / 10);
  for (int q = 0; q < QUANTITIES; q++) {
    const double *all = small[q].all;
    int count = small[q].count;
    assert_true(count > CRAWLERS / 2);
    qsort(small[q].all, (size_t)count, sizeof *all, ascending);
    print_message("%s: %d bounds, of the error: least %.4g, median %.3g, nine of ten below %.3g, most %.3g\n",
                  q == 0 ? "v_start" : "displacement", count, all[0], all[count / 2], all[9 * count / 10],
                  all[count - 1]);
    CHECK_AT_MOST(all[count / 2], 3);
    CHECK_AT_MOST(all[9 * count / 10], 1e3);
  }
}

/* Where c is about to touch a curve the proof does not halve its pieces until they are as short as c is near: that took
 * two hundred times as long as a plain proof, the first of these. */
TEST(proofs_beside_a_grazed_curve_are_short)
{
  static const struct {
    double m1, m2, F1, F2, L, alpha, event;
  } rows[] = { { 1, 1, 4, 1, 10, 0.75, INFINITY },
               { 3.886, 0.1723, 0.4307, 6.761, 1.992, 0.447, 0.88831012281993 },
               { 2.87, 0.1327, 0.932, 4.669, 8.798, 0.355, 2.51802357079357 } };
  const struct scallop_gait *gait = gait_of_text("polynomial:0,3,-2").gait;
  double unit = 0;
  SCOPED(scallop_rational, exact);
  SCOPED(arb, proven);
  for (int i = 0; i < 3; i++) {
    const struct scallop_crawler c = {
      rows[i].m1, rows[i].m2, rows[i].F1, rows[i].F2, rows[i].L, 1, rows[i].alpha, gait
    };
    const char *ends;
    scallop_rational_of(&exact, &c);
    const clock_t begun = clock();
    assert_int_equal(scallop_steady_modes_hold(&exact, PRECISION, proven, &ends, NULL), SCALLOP_OK);
    double T = middle(proven), time = (double)(clock() - begun) / CLOCKS_PER_SEC; /* of the processor */
    print_message("up to T = %.12g: %.3f s\n", T, time);
    if (i == 0) {
      unit = fmax(time, 0.05);
      continue;
    }
    assert_non_null(strstr(ends, "begins or ceases to turn in the extension"));
    assert_true(T < rows[i].event && T > rows[i].event * (1 - 1e-8));
    assert_true(time < 30 * unit);
  }
}
