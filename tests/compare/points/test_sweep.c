/* Sweeps: which points there are, in which order, and what each is. */
#include "compare/points/sweep.h"

#include <stdlib.h>
#include <string.h>

#include "tests/support/check.h"

static struct sweep_variable listed(const char *name, const char **texts, long count)
{
  struct sweep_variable v;
  assert_true(sweep_variable_of_name(&v, name));
  v.texts = texts;
  v.count = count;
  return v;
}

static double no_formula(void *context, const struct sweep_place *place, const struct formula *formula)
{
  (void)context, (void)place, (void)formula;
  fail();
  return NAN;
}

/* To value index[g] of each group g */
static void move(struct sweep_place *place, const struct point *base, struct sweep_product *product, const long *index)
{
  static struct sweep_walk walk;
  const struct sweep sweep = { 1, product };
  long number = 0;
  walk.product = NULL;
  for (int g = 0; g < product->groups; g++)
    number = number * product->group[g].count + index[g];
  sweep_place_copy(place, sweep_point(&walk, &sweep, base, number, no_formula, NULL));
}

TEST(every_combination_the_first_slowest)
{
  const char *F1[] = { "2.385", "7.0" }, *F2[] = { "0.7", "3.0" }, *T[] = { "0.1", "0.2", "0.3" };
  struct sweep_product product = {
    .groups = 2, .group = { { 2, { listed("F1", F1, 2), listed("F2", F2, 2) }, 2 }, { 1, { listed("T", T, 3) }, 3 } }
  };
  struct sweep sweep = { 1, &product };
  struct sweep_place place = { .why = "" };
  assert_int_equal(sweep_points(&sweep), 6);
  assert_null(sweep_set_twice(&product));
  for (int points = 0; points < 6; points++) {
    const struct point base = point_initial(NULL), *point = &place.point;
    move(&place, &base, &product, (const long[SWEEP_GROUPS]){ points / 3, points % 3 });
    assert_string_equal(place.why, "");
    assert_true(point->crawler.F1 == strtod(F1[points / 3], NULL) && point->crawler.F2 == strtod(F2[points / 3], NULL));
    assert_true(point->crawler.T == strtod(T[points % 3], NULL));
    assert_int_equal(place.ends_group, points % 3 == 2);
  }
}

/* Ratios and Froude numbers hold whatever is set after them. */
TEST(ratios_are_settled_last)
{
  const char *froude = "3.25", *ratio = "4.5", *F2 = "0.7";
  struct sweep_product product = { .groups = 2,
                                   .group = {
                                       { 2, { listed("froude", &froude, 1), listed("F1_over_F2", &ratio, 1) }, 1 },
                                       { 1, { listed("F2", &F2, 1) }, 1 } } };
  const struct point base = point_initial(NULL);
  struct sweep_place place = { .why = "" };
  const struct scallop_crawler *c = &place.point.crawler;
  move(&place, &base, &product, (const long[SWEEP_GROUPS]){ 0, 0 });
  assert_string_equal(place.why, "");
  CHECK_RELATIVE(c->F1 / c->F2, 4.5, 1e-15);
  CHECK_RELATIVE((c->m1 + c->m2) * c->L / (c->F1 + c->F2) / (c->T * c->T), 3.25, 1e-14);
  assert_string_equal(sweep_variable(&(struct sweep){ 1, &product }, 1)->sets, "F1");
  product.group[1].variable[0] = listed("T", &F2, 1);
  assert_string_equal(sweep_set_twice(&product)->name, "T");
}

TEST(ranges_are_decimal)
{
  for (int is_log = 0; is_log <= 1; is_log++) {
    struct sweep_variable v = listed("alpha", NULL, 5);
    v.from.number = is_log ? 0.0001 : 0.1;
    v.to.number = is_log ? 0.9999 : 0.3;
    v.is_log = is_log == 1;
    struct sweep_product product = { .groups = 1, .group = { { 1, { v }, 5 } } };
    const struct point base = point_initial(NULL);
    struct sweep_place place = { .why = "" };
    move(&place, &base, &product, (const long[SWEEP_GROUPS]){ 1 });
    assert_string_equal(place.point.written[6], is_log ? "0.000999974999062" : "0.15");
    move(&place, &base, &product, (const long[SWEEP_GROUPS]){ 0 });
    assert_true(place.point.crawler.alpha == v.from.number);
    move(&place, &base, &product, (const long[SWEEP_GROUPS]){ 4 });
    assert_true(place.point.crawler.alpha == v.to.number && place.ends_group);
  }
}

/* In any order, by one walk, and by one for each point */
TEST(a_walk_depends_on_no_other_point)
{
  const char *gaits[] = { "quadratic", "sinusoidal", "minimum-jerk" };
  struct sweep_variable F1 = listed("F1", NULL, 1), alpha = listed("alpha", NULL, 1), T = listed("T", NULL, 7);
  F1.is_sampled = alpha.is_sampled = F1.is_log = true;
  F1.from.number = T.from.number = 1;
  F1.to.number = T.to.number = 10;
  alpha.from.number = 0.2;
  alpha.to.number = 0.8;
  for (int kind = SAMPLING_SOBOL; kind <= SAMPLING_RANDOM; kind++) {
    struct sweep_product product[] = {
      { .groups = 2, .group = { { 1, { listed("gait", gaits, 3) }, 3 }, { 1, { T }, 7 } } },
      { .groups = 2,
        .group = { { 2, { F1, alpha }, 50, (enum sampling)kind, 1303 }, { 1, { listed("gait", gaits, 3) }, 3 } } }
    };
    const struct sweep sweep = { 2, product };
    const struct point base = point_initial(NULL);
    struct sweep_walk walk = { .product = NULL };
    double mean = 0;
    assert_int_equal(sweep_points(&sweep), 171);
    for (long k = 0; k < 171; k++) {
      struct sweep_walk fresh = { .product = NULL };
      const long i = k * 100 % 171;
      const struct point *p = &sweep_point(&walk, &sweep, &base, i, no_formula, NULL)->point,
                         *q = &sweep_point(&fresh, &sweep, &base, i, no_formula, NULL)->point;
      assert_true(same_crawler(&p->crawler, &q->crawler));
      assert_true(i < 21 ? p->crawler.T == 1 + (double)(i % 7) * 1.5
                         : p->crawler.alpha > 0.2 && p->crawler.alpha < 0.8);
      mean += i < 21 ? 0 : p->crawler.alpha / 150;
      sweep_walk_end(&fresh);
    }
    assert_true(fabs(mean - 0.5) <= (kind == SAMPLING_SOBOL ? 0.01 : 0.05));
    sweep_walk_end(&walk);
  }
}

TEST(what_is_not_allowed_is_said)
{
  const char *alpha[] = { "0.5", "1.0" };
  struct sweep_variable v = listed("alpha", alpha, 2);
  struct sweep_product product = { .groups = 1, .group = { { 1, { v }, 2 } } };
  struct point point = point_initial(NULL);
  struct sweep_place place = { .why = "" };
  assert_null(sweep_wrong(&v, &point, "0.5"));
  assert_non_null(strstr(sweep_wrong(&v, &point, "1.0"), "'1.0' is not allowed"));
  move(&place, &point, &product, (const long[SWEEP_GROUPS]){ 1 });
  assert_non_null(strstr(place.why, "alpha: '1.0' is not allowed"));
  assert_true(place.point.crawler.alpha == point.crawler.alpha);
  assert_false(sweep_variable_of_name(&v, "F3"));
  v = listed("froude", alpha, 2);
  assert_non_null(sweep_wrong(&v, &point, "0"));
  assert_non_null(sweep_wrong(&v, &point, "inf"));
}
