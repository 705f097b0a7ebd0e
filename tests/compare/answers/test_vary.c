/* What varies, from the texts of options and of scenes. */
#include "compare/answers/vary.h"

#include <stdlib.h>
#include <string.h>

#include "compare/answers/at.h"
#include "tests/support/check.h"

/* Texts of options: what stays of them, in which order they vary, and which are one value. */
TEST(lists_and_ranges_of_options)
{
  struct request r = { .point = point_initial(NULL), .required = requirements_new("test") };
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
  for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
    struct request one = { .point = point_initial(NULL) };
    assert_null(vary_text(&one, texts[i].name, texts[i].text));
    assert_int_equal(sweep_variable(&one.sweep, 0) != NULL, texts[i].many);
    sweep_free(&one.sweep);
  }
  assert_null(vary_text(&r, "T", "0.5,0.60"));
  assert_true(r.point.crawler.T == 1 && !r.point.written[5]); /* where T does not vary, behind --and */
  assert_null(vary_text(&r, "gait", "trapezoidal:0.1,0.2,sinusoidal"));
  assert_null(vary_text(&r, "v0", "-1:1:3"));
  assert_true(!r.point.has_gait && r.point.has_v0 && r.point.v0 == 0);
  assert_int_equal(sweep_points(&r.sweep), 12);
  assert_string_equal(sweep_variable(&r.sweep, 1)->texts[0], "trapezoidal:0.1,0.2");
  assert_null(vary_text(&r, "T", "1e-3:10:5:log")); /* in place of the list, and last */
  assert_string_equal(sweep_variable(&r.sweep, 2)->name, "T");
  assert_int_equal(sweep_points(&r.sweep), 30);
  assert_null(vary_text(&r, "gait", "constant:0.1,quadratic,skewed:0.2"));
  assert_int_equal(sweep_points(&r.sweep), 45);
  assert_null(vary_text(&r, "gait", "quadratic"));
  assert_null(vary_text(&r, "gait", "sinusoidal"));
  assert_int_equal(sweep_points(&r.sweep), 15);
  struct sweep_walk walk = { .product = NULL };
  const struct point *p = &sweep_point(&walk, &r.sweep, &r.point, 7, NULL, NULL)->point;
  assert_true(p->v0 == 0 && p->crawler.T == 0.1);
  requirements_free(r.required);
  sweep_free(&r.sweep);
  assert_int_equal(sweep_points(&r.sweep), 1);
}

TEST(no_lists_and_ranges)
{
  struct request r = { .point = point_initial(NULL), .required = requirements_new("test") };
  static const struct {
    const char *name, *text, *message;
  } texts[] = { { "F1", "1:10:0", "'1:10:0' is not a range: FROM:TO:COUNT" },
                { "F1", "1:10:1", "COUNT is from 2 to 1000000000" },
                { "F1", "1:10:-3", "COUNT is" },
                { "F1", "1:10:2.5", "COUNT is" },
                { "F1", "1:10:1000000001", "COUNT is" },
                { "F1", "1:10:", "COUNT is" },
                { "F1", "1:10:5:log:", "is not a range" },
                { "F1", "1:10:5:Log", "is not a range" },
                { "F1", "1:2:3,4", "is not a range" },
                { "F1", "0:1:5:log", "'0' is not allowed here: it takes a finite number > 0" },
                { "v0", "0:1:5:log", "log spacing is > 0" },
                { "v0", "-1:1:5:log", "log spacing is > 0" },
                { "F1", "nan:1:5", "'nan' is neither a number nor a formula" },
                { "F1", "1:inf:5", "'inf' is neither a number nor a formula" },
                { "alpha", "0.5:1:5", "between 0 and 1" },
                { "alpha", "0.5,", "'' is not allowed" },
                { "alpha", ",", "'' is not allowed" },
                { "T", "1, 2", "without blanks" },
                { "gait", "foo,quadratic", "'foo' is not allowed" },
                { "phase", "extension,phase", "extension or contraction" } };
  for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
    const char *wrong = vary_text(&r, texts[i].name, texts[i].text);
    assert_non_null(wrong);
    if (!strstr(wrong, texts[i].message))
      fail_msg("%s %s: %s", texts[i].name, texts[i].text, wrong);
    assert_int_equal(r.sweep.product->groups, 0);
  }
  assert_null(vary_text(&r, "m1", "1:2:100000000"));
  assert_non_null(strstr(vary_text(&r, "m2", "1:2:10000001"), "more than 1e+15"));
  assert_null(vary_text(&r, "m2", "1:2:10000000"));
  requirements_free(r.required);
  sweep_free(&r.sweep);
}

/* A copy is written as its origin was, in memory of its own, and so is a copy of the copy. */
TEST(copies_stand_alone)
{
  struct request r = { .point = point_initial(NULL), .required = requirements_new("test") };
  struct sweep_walk walk = { .product = NULL };
  struct sweep_place place, copy[2];
  assert_null(vary_text(&r, "F2", "0.3:7:4"));
  assert_null(vary_text(&r, "alpha", "0.2,0.7"));
  assert_null(vary_text(&r, "T", "0.01:3:5:log"));
  sweep_place_copy(&place, sweep_point(&walk, &r.sweep, &r.point, 10 + 5 + 1, NULL, NULL));
  assert_string_equal(place.point.written[5], "0.0416179145029");
  const struct point origin = place.point;
  sweep_place_copy(&copy[0], &place);
  sweep_place_copy(&place, sweep_point(&walk, &r.sweep, &r.point, 10 + 5 + 3, NULL, NULL));
  sweep_place_copy(&copy[1], &copy[0]);
  for (int i = 0; i < 2; i++) {
    assert_true(same_crawler(&copy[i].point.crawler, &origin.crawler));
    assert_string_equal(copy[i].point.written[3], "2.53333333333333");
    assert_string_equal(copy[i].point.written[5], "0.0416179145029");
    assert_true(copy[i].point.written[5] == copy[i].written[5] && copy[i].point.written[6] == origin.written[6]);
  }
  requirements_free(r.required);
  sweep_free(&r.sweep);
}

/* Ratios, the Froude number and labels have values of their own; an end of a range may be a formula; a product follows
 * another. */
TEST(what_no_point_has_of_itself)
{
  struct request r = { .point = point_initial(NULL), .required = requirements_new("test") };
  struct sweep_variable label;
  assert_null(vary_text(&r, "F1_over_F2", "2.5"));
  assert_null(vary_text(&r, "label", "panel=A"));
  assert_null(vary_text(&r, "T", "sticking_onset/4:2*L:3"));
  assert_true(r.sweep.product->group[2].variable[0].from.is_formula);
  assert_null(vary_product(&r));
  assert_null(vary_text(&r, "label", "panel=B"));
  assert_null(vary_text(&r, "froude", "0.5,2"));
  assert_int_equal(sweep_points(&r.sweep), 5);
  assert_int_equal(r.required->quantities.labels, 1);
  assert_non_null(strstr(vary_text(&r, "T", "v_start:2:3"), "not of v_start"));
  assert_non_null(strstr(vary_text(&r, "label", "panel"), "NAME=TEXT"));
  assert_non_null(strstr(vary_label(&r, "displacement", &label), "which is a quantity"));
  assert_null(vary_group(&r));
  assert_true(sweep_variable_of_name(&label, "m1"));
  assert_null(vary_list(&r, label, (const char *const[]){ "1", "2" }, 2));
  assert_true(sweep_variable_of_name(&label, "m2"));
  assert_non_null(
      strstr(vary_list(&r, label, (const char *const[]){ "1", "2", "3" }, 3), "have 2: they advance together"));
  requirements_free(r.required);
  sweep_free(&r.sweep);
}
