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

static double no_formula(void *context, const struct formula *formula)
{
  (void)context, (void)formula;
  fail();
  return NAN;
}

TEST(every_combination_the_first_slowest)
{
  const char *F1[] = { "2.385", "7.0" }, *F2[] = { "0.7", "3.0" }, *T[] = { "0.1", "0.2", "0.3" };
  struct sweep_product product = {
    .groups = 2, .group = { { 2, { listed("F1", F1, 2), listed("F2", F2, 2) }, 2 }, { 1, { listed("T", T, 3) }, 3 } }
  };
  struct sweep sweep = { 1, &product };
  struct swept at = { .why = "" };
  long index[SWEEP_GROUPS] = { 0 };
  int points = 0;
  bool more = true;
  assert_int_equal(sweep_points(&sweep), 6);
  assert_null(sweep_set_twice(&product));
  for (; more; points++) {
    struct point point = point_initial(NULL);
    sweep_move(&at, &point, &product, index, no_formula, NULL);
    assert_string_equal(at.why, "");
    assert_true(point.crawler.F1 == strtod(F1[points / 3], NULL) && point.crawler.F2 == strtod(F2[points / 3], NULL));
    assert_true(point.crawler.T == strtod(T[points % 3], NULL));
    more = sweep_next(&product, index);
  }
  assert_int_equal(points, 6);
  assert_int_equal(index[0] + index[1], 0);
}

/* Ratios and Froude numbers hold whatever is set after them. */
TEST(ratios_are_settled_last)
{
  const char *froude = "3.25", *ratio = "4.5", *F2 = "0.7";
  struct sweep_product product = { .groups = 2,
                                   .group = {
                                       { 2, { listed("froude", &froude, 1), listed("F1_over_F2", &ratio, 1) }, 1 },
                                       { 1, { listed("F2", &F2, 1) }, 1 } } };
  struct point point = point_initial(NULL);
  const struct scallop_crawler *c = &point.crawler;
  struct swept at = { .why = "" };
  sweep_move(&at, &point, &product, (const long[]){ 0, 0 }, no_formula, NULL);
  assert_string_equal(at.why, "");
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
    struct point first = point_initial(NULL), second = first, last = first;
    struct swept at = { .why = "" };
    sweep_move(&at, &second, &product, (const long[]){ 1 }, no_formula, NULL);
    assert_string_equal(second.written[6], is_log ? "0.000999974999062" : "0.15");
    sweep_move(&at, &first, &product, (const long[]){ 0 }, no_formula, NULL);
    sweep_move(&at, &last, &product, (const long[]){ 4 }, no_formula, NULL);
    assert_true(first.crawler.alpha == v.from.number && last.crawler.alpha == v.to.number);
  }
}

TEST(what_is_not_allowed_is_said)
{
  const char *alpha[] = { "0.5", "1.0" };
  struct sweep_variable v = listed("alpha", alpha, 2);
  struct sweep_product product = { .groups = 1, .group = { { 1, { v }, 2 } } };
  struct point point = point_initial(NULL);
  struct swept at = { .why = "" };
  assert_null(sweep_wrong(&v, &point, "0.5"));
  assert_non_null(strstr(sweep_wrong(&v, &point, "1.0"), "'1.0' is not allowed"));
  sweep_move(&at, &point, &product, (const long[]){ 1 }, no_formula, NULL);
  assert_non_null(strstr(at.why, "alpha: '1.0' is not allowed"));
  assert_true(point.crawler.alpha == point_initial(NULL).crawler.alpha);
  assert_false(sweep_variable_of_name(&v, "F3"));
  v = listed("froude", alpha, 2);
  assert_non_null(sweep_wrong(&v, &point, "0"));
  assert_non_null(sweep_wrong(&v, &point, "inf"));
}

/* Texts of options: what stays of them, in which order they vary, and which are one value. */
TEST(lists_and_ranges_of_options)
{
  struct sweep sweep = { .products = 0 };
  struct point point = point_initial(NULL);
  static const struct {
    const char *name, *text;
    bool many;
  } texts[] = { { "T", "0.5", false },
                { "T", "0.5,0.6", true },
                { "v0", "-1:1:3", true },
                { "gait", "quadratic", false },
                { "gait", "skewed:0.2", false },
                { "gait", "trapezoidal:0.1,0.2", false },
                { "phase", "extension", false },
                { "gait", "trapezoidal:0.1,0.2,sinusoidal", true },
                { "gait", "constant:0.1,skewed:0.2", true },
                { "phase", "extension,contraction", true } };
  for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
    assert_int_equal(sweep_is_many(texts[i].name, texts[i].text), texts[i].many);
  assert_null(sweep_vary(&sweep, &point, "T", "0.5,0.60"));
  assert_true(point.crawler.T == 0.5 && point.written[5]);
  assert_null(sweep_vary(&sweep, &point, "gait", "trapezoidal:0.1,0.2,sinusoidal"));
  assert_null(sweep_vary(&sweep, &point, "v0", "-1:1:3"));
  assert_true(point.has_gait && point.has_v0 && point.v0 == -1);
  assert_int_equal(sweep_points(&sweep), 12);
  assert_string_equal(sweep_variable(&sweep, 1)->texts[0], "trapezoidal:0.1,0.2");
  assert_null(sweep_vary(&sweep, &point, "T", "1e-3:10:5:log")); /* in place of the list, and last */
  assert_string_equal(sweep_variable(&sweep, 2)->name, "T");
  assert_int_equal(sweep_points(&sweep), 30);
  assert_null(sweep_vary(&sweep, &point, "gait", "constant:0.1,quadratic,skewed:0.2"));
  assert_int_equal(sweep_points(&sweep), 45);
  sweep_hold(&sweep, "gait");
  sweep_hold(&sweep, "gait");
  assert_int_equal(sweep_points(&sweep), 15);
  struct swept at = { .why = "" };
  sweep_move(&at, &point, sweep.product, (const long[]){ 1, 2 }, no_formula, NULL);
  assert_true(point.v0 == 0 && point.crawler.T == 0.1);
  sweep_free(&sweep);
  assert_int_equal(sweep_points(&sweep), 0);
}

TEST(no_lists_and_ranges)
{
  struct sweep sweep = { .products = 0 };
  struct point point = point_initial(NULL);
  static const struct {
    const char *name, *text, *message;
  } texts[] = { { "F1", "1:10:0", "'1:10:0' is no range: FROM:TO:COUNT" },
                { "F1", "1:10:1", "COUNT is from 2 to 1000000000" },
                { "F1", "1:10:-3", "COUNT is" },
                { "F1", "1:10:2.5", "COUNT is" },
                { "F1", "1:10:1000000001", "COUNT is" },
                { "F1", "1:10", "is no range" },
                { "F1", "1:10:5:log:", "is no range" },
                { "F1", "1:10:5:Log", "is no range" },
                { "F1", "1:2:3,4", "is no range" },
                { "F1", "0:1:5:log", "'0' is not allowed here: it takes a finite number > 0" },
                { "v0", "0:1:5:log", "log spacing is > 0" },
                { "v0", "-1:1:5:log", "log spacing is > 0" },
                { "F1", "nan:1:5", "'nan' is not allowed" },
                { "F1", "1:inf:5", "'inf' is not allowed" },
                { "alpha", "0.5:1:5", "between 0 and 1" },
                { "alpha", "0.5,", "'' is not allowed" },
                { "alpha", ",", "'' is not allowed" },
                { "T", "1, 2", "without blanks" },
                { "gait", "foo,quadratic", "'foo' is not allowed" },
                { "phase", "extension,phase", "extension or contraction" } };
  for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
    const char *wrong = sweep_vary(&sweep, &point, texts[i].name, texts[i].text);
    assert_non_null(wrong);
    if (!strstr(wrong, texts[i].message))
      fail_msg("%s %s: %s", texts[i].name, texts[i].text, wrong);
    assert_int_equal(sweep.product->groups, 0);
  }
  assert_null(sweep_vary(&sweep, &point, "m1", "1:2:100000000"));
  assert_non_null(strstr(sweep_vary(&sweep, &point, "m2", "1:2:10000001"), "more than 1e+15"));
  assert_null(sweep_vary(&sweep, &point, "m2", "1:2:10000000"));
  sweep_free(&sweep);
}

/* What a group that stays has set is kept: as if each point were the first. */
TEST(steps_are_those_of_single_moves)
{
  struct sweep sweep = { .products = 0 };
  struct point base = point_initial(NULL);
  long index[SWEEP_GROUPS] = { 0 };
  struct swept at = { .why = "" };
  assert_null(sweep_vary(&sweep, &base, "F2", "0.3:7:4"));
  assert_null(sweep_vary(&sweep, &base, "alpha", "0.2,0.7"));
  assert_null(sweep_vary(&sweep, &base, "T", "0.01:3:5:log"));
  do {
    struct point point = base, alone = base;
    struct swept first = { .why = "" };
    sweep_move(&at, &point, sweep.product, index, no_formula, NULL);
    sweep_move(&first, &alone, sweep.product, index, no_formula, NULL);
    assert_true(same_crawler(&point.crawler, &alone.crawler));
    for (int i = 0; i < CRAWLER_NUMBERS; i++)
      assert_true(point.written[i] == alone.written[i] || strcmp(point.written[i], alone.written[i]) == 0);
  } while (sweep_next(sweep.product, index));
  sweep_free(&sweep);
}
