/* Where the expansion breaks down: transitions against closed forms and certified modes, reaches against closed forms
 * and brute force, radii of convergence by two routes. */
#include "compare/points/gaits.h"
#include "compare/breakdown/motion.h"
#include "tests/support/exact.h"
#include "tests/support/solved.h"

#include <stdlib.h>

enum { ORDER = 8 };

/* Quadratic for even i, sinusoidal for odd */
static struct scallop_crawler draw(struct random *r, int i) { return moderate_crawler(r, 3, 0.1, every_gait[i % 2]); }

#define STUDY(name, of) \
  ENDED_BY(study_clear) struct study name = { .places = NULL }; \
  assert_null(study_begin(&(name), of, ORDER))

#define TRANSITIONS(name, of) \
  STUDY(study_of_##name, of); \
  const struct transitions name = *study_transitions(&study_of_##name)

static double time_of(const struct transitions *transitions, bool first, const char *what)
{
  char cause[80];
  snprintf(cause, sizeof cause, what, first ? 1 : 2);
  for (int i = 0; i < transitions->count; i++)
    if (strstr(transitions->transition[i].causes, cause))
      return transitions->transition[i].T;
  return NAN;
}

/* The body with the larger friction is held once the curve is no steeper than what friction does: at the end of its
 * phase (where |l''| L = 4 L/tau^2) from m_other 4 L/tau^2 = F1 + F2 on, and throughout from m_other 4 L/tau^2 = |F1 -
 * F2| on. */
TEST(sticking_begins_where_closed_forms_say)
{
  struct random r = { 61 };
  for (int i = 0; i < 12; i++) {
    struct motion s = { .crawler = draw(&r, 0) };
    struct scallop_crawler *c = &s.crawler;
    TRANSITIONS(transitions, &s);
    bool first = c->F1 > c->F2;
    double other = first ? c->m2 : c->m1, shorter = fmin(c->alpha, 1 - c->alpha);
    double held = sqrt(4 * other * c->L / (c->F1 + c->F2)), rests = sqrt(4 * other * c->L / fabs(c->F1 - c->F2));
    CHECK_RELATIVE(time_of(&transitions, first, "onset of sticking: body %d in the extension"), held / c->alpha,
                   8 * 0x1p-53);
    CHECK_RELATIVE(time_of(&transitions, first, "permanent rest of body %d"), rests / shorter, 8 * 0x1p-53);
  }
}

static void check_certified(const struct motion *s, double T, const struct scallop_modes modes[2])
{
  const struct motion at = motion_at(s, T);
  char wanted[BOTH_MODES_TEXT], got[BOTH_MODES_TEXT];
  SCOPED(scallop_rational, exact);
  scallop_rational_of(&exact, &at.crawler);
  SCOPED(scallop_certified_steady, steady);
  assert_int_equal(scallop_certified_steady(&exact, 6, &steady, NULL), SCALLOP_OK);
  motion_modes_text(wanted, s->of, modes);
  motion_modes_text(got, s->of, steady.modes);
  assert_string_equal(got, wanted);
}

/* In order of T; between two transitions the modes are the same, and those of the next ones differ; each within 1e-14
 * of where certified modes change. */
TEST(transitions_are_where_certified_modes_change)
{
  struct random r = { 62 };
  int certified = 0, all = 0;
  for (int i = 0; i < 8; i++) {
    struct motion s = { .crawler = draw(&r, i) };
    TRANSITIONS(transitions, &s);
    assert_true(transitions.count >= 3);
    const struct scallop_modes *before = transitions.first;
    for (int k = 0; k < transitions.count; k++) {
      const struct transition *e = &transitions.transition[k];
      double from = k > 0 ? transitions.transition[k - 1].T : e->T / 2,
             until = k + 1 < transitions.count ? transitions.transition[k + 1].T : 2 * e->T;
      assert_true(from < e->T && e->T < until);
      check_certified(&s, e->T * (1 - 1e-14), before);
      check_certified(&s, e->T * (1 + 1e-14), e->modes);
      check_certified(&s, sqrt(e->T * until), e->modes);
      before = e->modes;
      all++;
      certified += strcmp(e->evidence, "certified") == 0;
      assert_true(strcmp(e->evidence, "certified") == 0 || e->of != CHANGE_OF_MODES);
    }
    assert_true(strstr(transitions.transition[transitions.count - 1].causes, "permanent rest"));
  }
  assert_true(certified > 3 * all / 4);
}

/* Where friction changes c by less than rounding, a phase that starts from the rounded velocity of the steady state has
 * other modes on a plateau than the steady state. Where l'' = 0 at the start of a phase doubles see a mode less within
 * 3e-10 of where its velocity vanishes, and a body that turns at a corner of l' turns on either side of it. None of
 * that is a transition. Where l' jumps, the last transition is where a body that is thrown comes to rest within its
 * phase. */
TEST(rounding_is_no_transition)
{
  static const struct {
    const char *gait;
    struct scallop_crawler crawler;
    int count, at;
    double T; /* of transition number at, the first by independent arithmetic of 60 digits between ...939 and ...940 */
    const char *cause;
  } cases[] = {
    { "polynomial:0,0,4,-3", { 0.2624, 0.2698, 9.222, 5.557, 1.192, 1, 0.869, NULL }, 9, 4, 0.58804074939761, "" },
    { "polynomial:0,0,4,-3", { 2.386, 0.4319, 0.3532, 0.8713, 7.455, 1, 0.19, NULL }, 0, 0, 0, NULL },
    { "constant:0.1", { 0.5455, 7.341, 6.783, 0.2455, 5.675, 1, 0.686, NULL }, 10, 0, 4.78521795311083, "" },
    { "constant:0.001", { 2.838, 0.437, 0.6061, 0.6268, 0.6074, 1, 0.354, NULL }, 10, 0, 10.1875929395147, "" },
    { "constant:0.02", { 0.3805, 2.869, 1.896, 1.111, 6.262, 1, 0.548, NULL }, 0, 0, 0, NULL },
    { "constant:0",
      { 0.5315, 1.448, 0.6551, 0.4, 2.804, 1, 0.817, NULL },
      2,
      0,
      NAN,
      "body 2 begins to turn in the extension" },
    { "constant:0",
      { 0.5315, 1.448, 0.6551, 0.4, 2.804, 1, 0.817, NULL },
      2,
      1,
      NAN,
      "onset of sticking: body 1 in the contraction" },
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    struct motion s = { .crawler = cases[i].crawler };
    s.crawler.gait = gait_of_text(cases[i].gait).gait;
    ENDED_BY(transitions_clear) struct transitions found;
    transitions_find(&found, &s, "");
    const struct transition *e = &found.transition[cases[i].at];
    if (cases[i].cause) {
      assert_int_equal(found.count, cases[i].count);
      assert_non_null(strstr(e->causes, cases[i].cause));
    }
    if (cases[i].T > 0)
      CHECK_RELATIVE(e->T, cases[i].T, 1e-13);
    if (isnan(cases[i].T)) {
      check_certified(&s, e->T * (1 - 1e-12), cases[i].at > 0 ? e[-1].modes : found.first);
      check_certified(&s, e->T * (1 + 1e-12), e->modes);
      continue;
    }
    assert_true(found.transition[0].T > 0.01 * motion_natural_time(&s));
    for (int k = 0; k < found.count; k++)
      assert_true(strcmp(found.transition[k].evidence, "certified") == 0 || found.transition[k].of == CHANGE_OF_PART);
  }
}

/* No transition is missed below the first: the modes of the limit are proven up to three thousandths below it. */
TEST(the_first_transition_is_the_first)
{
  struct random r = { 63 };
  for (int i = 0; i < 6; i++) {
    struct motion s = { .crawler = draw(&r, i) };
    const char *ends = NULL;
    SCOPED(arb, T);
    SCOPED(scallop_rational, exact);
    scallop_rational_of(&exact, &s.crawler);
    TRANSITIONS(transitions, &s);
    assert_int_equal(scallop_steady_modes_hold(&exact, 128, T, &ends, NULL), SCALLOP_OK);
    double proven = middle(T);
    assert_non_null(ends);
    /* a proof ends at a corner of l' as well, which is no transition while it does not change the modes */
    assert_true(transitions.transition[0].T > proven * (1 - 1e-12));
    if (!strstr(ends, "corner"))
      CHECK_RELATIVE(transitions.transition[0].T, proven, 3e-3);
  }
}

/* Lengths times 4, times times 2; bodies exchanged in a mirror; a phase is what a half of a period is. */
TEST(transitions_scale_and_mirror)
{
  struct random r = { 64 };
  for (int i = 0; i < 4; i++) {
    struct motion s = { .crawler = draw(&r, i) }, t = s, u = s;
    t.crawler.L *= 4;
    u.crawler = exchanged(&s.crawler);
    TRANSITIONS(one, &s);
    TRANSITIONS(larger, &t);
    TRANSITIONS(mirrored, &u);
    assert_int_equal(one.count, larger.count);
    assert_int_equal(one.count, mirrored.count);
    for (int k = 0; k < one.count; k++) {
      CHECK_RELATIVE(larger.transition[k].T, 2 * one.transition[k].T, 4 * 0x1p-52);
      CHECK_RELATIVE(mirrored.transition[k].T, one.transition[k].T,
                     one.transition[k].of == CHANGE_OF_MODES ? 4 * 0x1p-52 : 1e-12);
    }
  }
}

static double reach_to(struct comparison *c, double tolerance)
{
  c->tolerance = tolerance;
  return comparison_reach(c);
}

/* The error of a series at T, by the double solver */
static double error_at(const struct series_item *item, const struct study *study, double T)
{
  const struct motion at = motion_at(&study->motion, T);
  struct answer exact;
  SCOPED(arb, value);
  answer_in_double(&exact, &at);
  series_item_value(value, item, study, T);
  return fabs(middle(value) / exact.value[item->quantity].high - 1);
}

static struct comparison comparison_named(struct study *s, enum quantity_id quantity, const char *name)
{
  struct series_item items[MAX_ITEMS];
  int count = series_items(items, s, quantity, ORDER), i = 0;
  while (i < count && strcmp(series_name(&items[i]), name) != 0)
    i++;
  assert_true(i < count);
  return (struct comparison){ s, items[i], NAN };
}

/* (A.6) t1 = x(1 - y), where for constant l'' it is x/(1 + y), y = T^2 (F1 + F2)/(m2 l0): the relative error is -y^2,
 * so that T* = sqrt(m2 l0/(F1 + F2)) tol^(1/4), until the body does not turn any more. Its unexpanded form (A.5) is
 * exact. */
TEST(reach_of_a_known_error)
{
  struct random r = { 71 };
  for (int i = 0; i < 6; i++) {
    struct motion motion = { .crawler = draw(&r, 0), .of = OF_PHASE };
    struct scallop_crawler *c = &motion.crawler;
    motion.v0 = 0.01 * sqrt(c->L * (c->F1 + c->F2) / (c->m1 + c->m2));
    STUDY(s, &motion);
    struct comparison short_form = comparison_named(&s, Q_T1, "eqA6_t1");
    for (int k = 2; k <= 12; k += 2)
      CHECK_RELATIVE(reach_to(&short_form, pow(10, -k)), sqrt(c->m2 * 4 * c->L / (c->F1 + c->F2)) * pow(10, -k / 4.0),
                     8 * 0x1p-53);
    struct comparison whole = comparison_named(&s, Q_T1, "eqA5_t1_unexpanded");
    CHECK_AT_MOST(fabs(comparison_error(&whole, 0.1)), 1e-30);
  }
}

/* What stands in the table is what a reader would find by trying: the error is below the tolerance at thousands of T
 * below T*, and not right above it. Some of these errors are above the tolerance, below, and above again. */
TEST(reach_against_brute_force)
{
  const int points = (int)check_cases(3000);
  struct random r = { 72 };
  int returning = 0, found = 0;
  for (int i = 0; i < 24; i++) {
    struct motion motion = { .crawler = draw(&r, i) };
    STUDY(s, &motion);
    struct series_item items[MAX_ITEMS];
    enum quantity_id quantity = (enum quantity_id)(Q_V_START + i % 4);
    int count = series_items(items, &s, quantity, ORDER);
    for (int item = 0; item < count; item++) {
      double tolerance = random_decades(&r, 3e-2, 0.5), before = tolerance;
      const struct comparison c = { &s, items[item], tolerance };
      double T = comparison_reach(&c);
      if (!(T > 0 && isfinite(T)))
        continue;
      found++;
      assert_true(comparison_is_proven(&c, T));
      for (int k = 1; k < points + points / 30; k++) {
        double value = k == points ? tolerance : error_at(&c.item, &s, T * exp2((k - points) * 12.0 / points));
        if (k < points)
          CHECK_AT_MOST(value, tolerance);
        else
          returning += value < tolerance && before >= tolerance;
        before = value;
      }
    }
  }
  assert_true(found > 40);
  assert_true(returning > 0);
}

/* The first of many T in the 20 octaves below T at which the error, in double, is not below the tolerance; T if there
 * is none. */
static double first_above(const struct comparison *c, double T)
{
  enum { POINTS = 1500, OCTAVES = 20 };
  for (int k = 0; k < POINTS; k++) {
    double t = T * exp2((double)OCTAVES * (k - POINTS) / POINTS);
    if (!(error_at(&c->item, c->study, t) < c->tolerance))
      return t;
  }
  return T;
}

/* 0 below the limit of the error, and as far as trying finds above it. Counts reaches in found[0], and in found[1]
 * those of errors that fall first, or change their sign. */
static void check_about_limit(struct comparison *c, double limit, double share, int found[2])
{
  double T = reach_to(c, share * limit);
  if (share < 1) {
    CHECK_EQUAL(T, 0);
    return;
  }
  bool ends = isfinite(T);
  assert_true(T > 0);
  if (ends)
    assert_true(comparison_is_proven(c, T));
  double last = ends ? T : motion_last_time(&c->study->motion);
  CHECK_EQUAL(first_above(c, last), last);
  found[0]++;
  found[1] += ends && fabs(comparison_error(c, T / 4)) < limit;
}

/* Formulas whose error tends to a limit other than 0: (28) for alpha < 1/2, and where l' is no straight line; those of
 * a moving body, of the paper's appendices, from a velocity that they take for the steady one. */
TEST(reach_about_the_limit_of_the_error)
{
  static const double shares[] = { 0.99, 1.01, 2 };
  struct random r = { 73 };
  int found[2] = { 0, 0 };
  for (int i = 0; i < 12; i++) {
    struct motion motion = { .crawler = draw(&r, i), .of = i % 4 < 2 ? OF_STEADY : OF_PHASE, .phase = i % 8 < 4 };
    struct scallop_crawler *crawler = &motion.crawler;
    motion.v0 = motion.of == OF_STEADY
                    ? 0
                    : sqrt(crawler->L * (crawler->F1 + crawler->F2) / (crawler->m1 + crawler->m2)) / 8;
    STUDY(s, &motion);
    for (int q = 0; q < QUANTITIES; q++) {
      struct series_item items[MAX_ITEMS];
      int count = motion_has(&motion, (enum quantity_id)q) ? series_items(items, &s, (enum quantity_id)q, ORDER) : 0;
      for (int item = 0; item < count; item++) {
        struct comparison c = { &s, items[item], NAN };
        double limit = fabs(comparison_error(&c, 1e-9 * motion_natural_time(&motion)));
        for (int k = 0; k < 3 && limit > 1e-5 && limit < 1e5; k++)
          check_about_limit(&c, limit, shares[k], found);
      }
    }
  }
  assert_true(found[0] > 20 && found[1] > 4);
}

/* Of gaits with linear l' the branch has poles, and where these are is proven of the series; the proof that follows the
 * branch, which knows nothing of that, ends a little below them. */
TEST(the_branch_ends_at_its_poles)
{
  struct random r = { 81 };
  for (int i = 0; i < 3; i++) {
    struct motion s = { .crawler = draw(&r, 0) };
    STUDY(study, &s);
    for (int q = Q_V_START; q <= Q_MEAN_VELOCITY; q++) {
      struct radius poles, bound;
      assert_true(radius_from_poles(&poles, study_many(&study, (enum quantity_id)q), STUDY_MANY));
      assert_true(poles.high - poles.low <= 1e-14 * poles.T && poles.T >= poles.low);
      assert_true(radius_from_branch(&bound, &study, (enum quantity_id)q));
      assert_string_equal(bound.method, "bound");
      assert_true(bound.T <= poles.high && bound.T >= 0.99 * poles.low);
    }
  }
}

static void set_series(struct series *s, const fmpq_poly_t poly, slong terms)
{
  series_set_rational_poly(s, poly, terms);
  series_inflate(s, s, 2);
}

/* 1/((1 - z/4)(1 + z/9)) and 1/(1 - 6 z/25 + z^2/25), z = T^2: poles at 4 and -9, and at 3 +- 4 i. Of their square
 * roots: the same places, which are no poles. */
TEST(radius_of_known_functions)
{
  enum { COUNT = 60 };
  static const char *const denominators[] = { "3  1 -5/36 -1/36", "3  1 -6/25 1/25" }, *const places[] = {
    "T^2 = 4.000000000:", "T^2 = 3.000000000 +- 4.000000000 i:"
  };
  for (int i = 0; i < 2; i++) {
    struct radius found;
    double R = i == 0 ? 2 : sqrt(5);
    SCOPED(series, s);
    SCOPED(fmpq_poly, poly);
    assert_int_equal(fmpq_poly_set_str(poly, denominators[i]), 0);
    fmpq_poly_inv_series(poly, poly, COUNT);
    set_series(&s, poly, COUNT);
    assert_true(radius_from_poles(&found, &s, 2 * COUNT));
    CHECK_RELATIVE(found.T, R, 4 * 0x1p-53);
    if (!strstr(found.note, places[i]))
      fail_msg("%s: not %s", found.note, places[i]);
    fmpq_poly_sqrt_series(poly, poly, COUNT);
    set_series(&s, poly, COUNT);
    assert_false(radius_from_poles(&found, &s, 2 * COUNT));
  }
}
