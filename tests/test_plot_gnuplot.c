/* compare/plot with gnuplot itself, without which the tests are skipped: pictures of each kind, names that would be
 * commands, and what is said of a script with an error. */
#include "tests/pictures.h"

static bool has_gnuplot;

static int begin(void **state)
{
  struct said said;
  int code = scratch_begin(state);
  if (code != 0)
    return code;
  write_text("table", "x\ty\n1\t2\n");
  said_begin(&said);
  plot_draw(&(struct plot){ .table = "table", .file = "plot.svg", .x = "x", .y = y_only }, "run");
  has_gnuplot = !strstr(said_end(&said), "gnuplot is not installed");
  return 0;
}

static int empty(void **state)
{
  (void)state;
  entries(true);
  return 0;
}

static void pictures_of_each_kind(void **state)
{
  (void)state;
  static const char *const files[] = { "plot.svg", "plot.png", "plot.pdf" }, *const heads[] = { "<?xml", "\x89PNG", "%PDF" };
  char head[10];
  if (!has_gnuplot)
    skip();
  write_text("table", "x\ty\tz\n1\t2\t0.1\n1.5\tnan\t0.2\n2\t3\t5e3\n");
  for (int i = 0; i < 3; i++)
    for (int logarithmic = 0; logarithmic <= 1; logarithmic++) {
      draws(&(struct plot){
          .table = "table", .file = files[i], .x = "x", .y = two, .log_x = logarithmic, .log_y = logarithmic });
      read_picture(head, sizeof head, files[i]);
      assert_memory_equal(head, heads[i], strlen(heads[i]));
    }
  assert_int_equal(entries(false), 4);
}

static void gnuplot_takes_extreme_axes(void **state)
{
  (void)state;
  static const char *const rows[] = { "1\t1\n", "1\t1\n1.0000000000000002\t1\n", "1e-307\t1e-307\n",
                                      "1e-300\t1\n1e300\t1\n" };
  if (!has_gnuplot)
    skip();
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
    for (int logarithmic = 0; logarithmic <= 1; logarithmic++) {
      char table[100];
      snprintf(table, sizeof table, "x\ty\n%s", rows[i]);
      write_text("table", table);
      draws(&(struct plot){
          .table = "table", .file = "plot.svg", .x = "x", .y = y_only, .log_x = logarithmic, .log_y = logarithmic });
    }
}

static void gnuplot_runs_nothing_from_names(void **state)
{
  (void)state;
  static const char *const nasty[] = { "`touch hacked`", "'; !touch hacked #",  "\"; system(\"touch hacked\"); \"",
                                       "@hacked",        "\\\"; !touch hacked", "END",
                                       "<touch hacked",  "|touch hacked" };
  char picture[100000], table[300], script[100];
  if (!has_gnuplot)
    skip();
  for (size_t i = 0; i < sizeof nasty / sizeof *nasty; i++) {
    const char *const names[] = { nasty[i], "y", NULL };
    snprintf(table, sizeof table, "x\t%s\ty\tby%s\n1\t2\t3\t%s\n2\t3\t4\tEND\n", nasty[i], nasty[i], nasty[i]);
    snprintf(script, sizeof script, "by%s", nasty[i]);
    write_text("table", table);
    draws(
        &(struct plot){ .table = "table", .file = "plot.svg", .x = nasty[i], .y = names, .by = script, .title = nasty[i] });
    read_picture(picture, sizeof picture, "plot.svg");
    assert_in(picture, "</svg>");
    write_text(nasty[i], "x\ty\n1\t2\n2\t3\n");
    snprintf(script, sizeof script, "%s.gp", nasty[i]);
    write_text(script, "plot table using 1:2 skip 1\n");
    draws(&(struct plot){ .table = nasty[i], .file = "plot.svg", .script = script });
    read_picture(picture, sizeof picture, "plot.svg");
    assert_in(picture, "</svg>");
    unlink(script);
    unlink(nasty[i]);
    assert_int_equal(access("hacked", F_OK), -1);
  }
  draws(&(struct plot){
      .table = "table", .file = "plot.svg", .x = "x", .y = y_only, .title = "a_b {c}^2 \\n & < > \" ' end" });
  read_picture(picture, sizeof picture, "plot.svg");
  assert_in(picture, "a_b {c}^2 \\n &amp; &lt; ");
}

static void gnuplot_says_what_is_wrong(void **state)
{
  (void)state;
  struct said said;
  if (!has_gnuplot)
    skip();
  write_text("table", "x\ty\n1\t2\n2\t3\n");
  write_text("mine.gp", "plot table using 1:2 skip 1\nplot undefined_variable\n");
  said_begin(&said);
  bool drawn = plot_draw(&(struct plot){ .table = "table", .file = "plot.svg", .script = "mine.gp" }, "run");
  said_end(&said);
  assert_false(drawn);
  assert_in(said.text, "scallop run: gnuplot: \"./mine.gp\" line 2: undefined variable: undefined_variable\n");
  assert_in(said.text, "\nscallop run: cannot draw plot.svg: gnuplot has failed\n");
  assert_int_equal(access("plot.svg", F_OK), -1);
}

int main(void)
{
#define DRAWN(test) \
  { \
#test, test, empty, NULL, NULL \
  }
  const struct CMUnitTest tests[] = {
    DRAWN(pictures_of_each_kind),
    DRAWN(gnuplot_takes_extreme_axes),
    DRAWN(gnuplot_runs_nothing_from_names),
    DRAWN(gnuplot_says_what_is_wrong),
  };
  return cmocka_run_group_tests(tests, begin, scratch_end);
}
