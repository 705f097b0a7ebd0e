/* compare/plot: what gnuplot is told, what becomes of the picture, and what is said where there is none. A program of the
 * test's own is in the place of gnuplot and keeps what it is told as the picture. */
#include "tests/pictures.h"

#include <fcntl.h>
#include <sys/stat.h>

static char real_path[4096];

/* Programs are found in the folder bin, then in the usual ones. */
static void install(const char *gnuplot)
{
  char path[sizeof real_path + 200], here[100];
  assert_non_null(getcwd(here, sizeof here));
  mkdir("bin", 0777);
  write_text("bin/gnuplot", gnuplot);
  chmod("bin/gnuplot", 0777);
  snprintf(path, sizeof path, "%s/bin:%s", here, real_path);
  setenv("PATH", path, 1);
}

static const char keeps_script[] = "#!/bin/sh\ncat >&3\n";

static int with_a_gnuplot_of_ours(void **state)
{
  (void)state;
  unlink("bin/gnuplot");
  entries(true);
  install(keeps_script);
  return 0;
}

/* ---- what gnuplot is told ---- */

static void curves_are_of_their_rows(void **state)
{
  (void)state;
  char script[8192];
  write_text("table",
             "# note\nx\tF\ty\tz\tmodes\n1\t2\t0.1\t5\t++\n1\t40\t0.2\tnan\t++\n2\t2\tinf\t6\t++\n2\t40\t0.4\t-\t++\n"
             "3\t2\tnan\t7\t++\n4\t2\t0.7\t8\t++\n# end\n");
  draws(&(struct plot){ .table = "table", .file = "plot.svg", .x = "x", .y = two, .by = "F" });
  read_picture(script, sizeof script, "plot.svg");
  assert_in(script, "$curve0 << END\n1\t0.10000000000000001\n\n4\t0.69999999999999996\nEND\n"); /* one gap for two rows */
  assert_in(script, "$curve1 << END\n1\t5\n2\t6\n3\t7\n4\t8\nEND\n");
  assert_in(script, "$curve2 << END\n1\t0.20000000000000001\n2\t0.40000000000000002\nEND\n");
  assert_in(script, "$curve3 << END\nEND\n");
  assert_in(script,
            "plot $curve0 using 1:2 with linespoints lw 2 dt 1 lc rgb '#0b3c8c' pt 5 ps 0.6 title \"y, F = 2\", $curve1");
  assert_in(script, "dt 2 lc rgb '#c8102e' pt 7 ps 0.6 title \"z, F = 40 (none)\"\n");
  assert_in(script, ", keyentry with");
  assert_in(
      script,
      "set xlabel \"x\" noenhanced\nset ylabel \"y, z\" noenhanced\nset key noenhanced samplen 2 Left reverse outside");
  assert_in(script, "set terminal svg ");
  assert_in(script, "set output '/dev/fd/3'\n");
  assert_null(strstr(script, "logscale"));
  assert_null(strstr(script, "set title"));
}

static void one_curve_needs_no_key(void **state)
{
  (void)state;
  char script[8192];
  write_text("table", "x\ty\n1\t2\n2\t3\n");
  draws(&(struct plot){ .table = "table", .file = "plot.png", .x = "x", .y = y_only, .title = "A title" });
  read_picture(script, sizeof script, "plot.png");
  assert_in(script, "unset key\n");
  assert_in(script, "set title \"A title\" noenhanced\n");
  assert_in(script, "set terminal pngcairo ");
}

static void logarithmic_axes(void **state)
{
  (void)state;
  char script[8192];
  write_text("table", "x\ty\n0.2\t1e-9\n0\t1e-5\n1\t-1\n0.5\t0.1\n");
  draws(&(struct plot){ .table = "table", .file = "plot.pdf", .x = "x", .y = y_only, .log_x = true, .log_y = true });
  read_picture(script, sizeof script, "plot.pdf");
  assert_in(script, "$curve0 << END\n0.20000000000000001\t1.0000000000000001e-09\n\n0.5\t0.10000000000000001\nEND\n");
  assert_in(script, "set logscale x\nset xrange [0.19");
  assert_in(script, "set xtics (0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5)\n");
  assert_in(script, "set logscale y\nset format y '10^{%T}'\n");
  write_text("table", "x\ty\n3\t1\n300\t1\n");
  draws(&(struct plot){ .table = "table", .file = "plot.pdf", .x = "x", .y = y_only, .log_x = true });
  read_picture(script, sizeof script, "plot.pdf");
  assert_in(script, "set xtics (5, 10, 20, 50, 100, 200)\n");
}

/* Axes without a width, and at the ends of the doubles */
static void extreme_axes(void **state)
{
  (void)state;
  static const char *const rows[] = {
    "1\t1\n",           "1\t1\n1.0000000000000002\t1\n", "1\t1.7976931348623157e308\n", "4.9e-324\t1e-320\n",
    "1e-307\t1e-307\n", "1e-300\t1\n1e300\t1\n"
  };
  char table[100];
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    char script[8192];
    snprintf(table, sizeof table, "x\ty\n%s", rows[i]);
    write_text("table", table);
    draws(&(struct plot){ .table = "table", .file = "plot.svg", .x = "x", .y = y_only, .log_x = true, .log_y = true });
    read_picture(script, sizeof script, "plot.svg");
    assert_null(strstr(script, "inf"));
    assert_null(strstr(script, "nan"));
  }
}

static void long_titles_go_below(void **state)
{
  (void)state;
  static const char *const names[] = { "log10(abs(exact - series))", "y", NULL };
  char script[8192];
  write_text("table", "x\ty\tlog10(abs(exact - series))\n1\t2\t3\n");
  draws(&(struct plot){ .table = "table", .file = "plot.svg", .x = "x", .y = names });
  read_picture(script, sizeof script, "plot.svg");
  assert_in(script, "reverse outside right top\n");
  write_text("table", "x\ty\tlog10(abs(exact - series))\n1\t2\t3\n2\t2\t3\n");
  draws(&(struct plot){ .table = "table", .file = "plot.svg", .x = "x", .y = names, .by = "x" });
  read_picture(script, sizeof script, "plot.svg");
  assert_in(script, "reverse below left\n");
}

static void texts_are_bytes_to_gnuplot(void **state)
{
  (void)state;
  static const char *const names[] = { "a'`b`\\\"", NULL };
  char script[8192];
  write_text("table", "$x@\ta'`b`\\\"\t\"; !touch hacked\n1\t2\t`touch hacked`\n");
  draws(&(struct plot){ .table = "table",
                        .file = "plot.svg",
                        .x = "$x@",
                        .y = names,
                        .by = "\"; !touch hacked",
                        .title = "1\n!touch hacked\xce\xb1" });
  read_picture(script, sizeof script, "plot.svg");
  assert_in(script, "set xlabel \"\\044x\\100\" noenhanced\n");
  assert_in(script, "set ylabel \"a\\047\\140b\\140\\134\\042\" noenhanced\n");
  assert_in(script, "title \"\\042\\073 \\041touch hacked = \\140touch hacked\\140\"");
  assert_in(script, "set title \"1\\077\\041touch hacked\\316\\261\" noenhanced\n");
}

static void own_scripts(void **state)
{
  (void)state;
  char script[8192];
  write_text("table", "x\ty\n1\t2\n");
  write_text("mine.gp", "plot table\n");
  draws(&(struct plot){ .table = "table", .file = "plot.svg", .script = "mine.gp" });
  read_picture(script, sizeof script, "plot.svg");
  assert_in(
      script,
      "set datafile separator \"\\t\"\ntable = \"./table\"\noutput_file = '/dev/fd/3'\nkind = 'svg'\nload \"./mine.gp\"\n");
  mkdir("<sub", 0777);
  write_text("<sub/plot_common.gp", "");
  write_text("<sub/it's.gp", "");
  draws(&(struct plot){ .table = "table", .file = "plot.svg", .script = "<sub/it's.gp" });
  read_picture(script, sizeof script, "plot.svg");
  assert_in(script, "load \"./\\074sub/plot_common.gp\"\nload \"./\\074sub/it\\047s.gp\"\n");
  unlink("<sub/plot_common.gp");
  unlink("<sub/it's.gp");
}

/* ---- what becomes of the picture ---- */

static void assert_not_drawn(const struct plot *plot, const char *wanted)
{
  struct said said;
  int before = lowest_free(), files = entries(false);
  said_begin(&said);
  bool drawn = plot_draw(plot, "run");
  said_end(&said);
  assert_string_equal(said.text, wanted);
  assert_false(drawn);
  assert_int_equal(lowest_free(), before);
  assert_int_equal(entries(false), files);
}

/* A plot of y over x in "table", which holds this, where there is a picture already */
static void assert_refused(const char *table, struct plot plot, const char *wanted)
{
  if (table)
    write_text("table", table);
  write_text("plot.svg", "earlier");
  plot.table = plot.table ? plot.table : "table";
  plot.file = plot.file ? plot.file : "plot.svg";
  plot.x = plot.x ? plot.x : "x";
  plot.y = plot.y ? plot.y : y_only;
  assert_not_drawn(&plot, wanted);
  assert_holds("plot.svg", "earlier");
}

static void a_picture_replaces_another(void **state)
{
  (void)state;
  char script[8192];
  write_text("table", "x\ty\n1\t2\n");
  write_text("plot.svg", "earlier");
  int files = entries(false);
  draws(&(struct plot){ .table = "table", .file = "plot.svg", .x = "x", .y = y_only });
  read_picture(script, sizeof script, "plot.svg");
  assert_in(script, "plot $curve0");
  assert_int_equal(entries(false), files);
}

static void names_of_pictures(void **state)
{
  (void)state;
  assert_string_equal(plot_kind("a.svg"), "svg");
  assert_string_equal(plot_kind("dir.png/a.b.png"), "png");
  assert_string_equal(plot_kind("a.pdf"), "pdf");
  assert_null(plot_kind("a.SVG"));
  assert_null(plot_kind("a"));
  assert_null(plot_kind("a.svgz"));
  const char *ending = "its name is to end in .svg, .png or .pdf\n";
  char wanted[200];
  snprintf(wanted, sizeof wanted, "scallop run: cannot draw plot.gif: %s", ending);
  assert_refused("x\ty\n1\t2\n", (struct plot){ .file = "plot.gif" }, wanted);
  mkdir("folder.svg", 0777);
  assert_refused(NULL, (struct plot){ .file = "folder.svg" },
                 "scallop run: cannot draw folder.svg: there is something of this name that is no file\n");
  assert_refused(NULL, (struct plot){ .file = "missing/plot.svg" },
                 "scallop run: cannot draw missing/plot.svg: cannot write it: No such file or directory\n");
}

static void tables_that_cannot_be_drawn(void **state)
{
  (void)state;
  static const char *const typo[] = { "y", "displacemnt", NULL };
  static const char *const many[PLOT_QUANTITIES + 2] = { "y", "y", "y", "y", "y", "y", "y", "y", "y",
                                                         "y", "y", "y", "y", "y", "y", "y", "y" };
  static const char *const none[] = { NULL };
  struct plot plain = { .x = NULL };
  assert_refused(NULL, (struct plot){ .table = "missing" },
                 "scallop run: cannot draw plot.svg: cannot read missing: No such file or directory\n");
  mkdir("folder", 0777);
  assert_refused(NULL, (struct plot){ .table = "folder" },
                 "scallop run: cannot draw plot.svg: cannot read folder: Is a directory\n");
  assert_refused("", plain, "scallop run: nothing to draw in plot.svg: table has no rows\n");
  assert_refused("# only notes\n", plain, "scallop run: nothing to draw in plot.svg: table has no rows\n");
  assert_refused("x\ty\n", plain, "scallop run: nothing to draw in plot.svg: table has no rows\n");
  assert_refused("x\ty\n1\tnan\n2\tinf\nnan\t1\n-\t-\n", plain,
                 "scallop run: nothing to draw in plot.svg: no row of table has a number in 'x' and a number in 'y'\n");
  assert_refused(
      "x\ty\tz\n1\tnan\tnan\n", (struct plot){ .y = two },
      "scallop run: nothing to draw in plot.svg: no row of table has a number in 'x' and a number in any column y\n");
  assert_refused(
      "x\ty\n1\t0\n2\t-5\n", (struct plot){ .log_y = true },
      "scallop run: nothing to draw in plot.svg: no row of table has a number in 'x' and a positive number in 'y'\n");
  assert_refused("x\ty\tdisplacement\n1\t2\t3\n", (struct plot){ .y = typo },
                 "scallop run: cannot draw plot.svg: table has no column 'displacemnt': did you mean 'displacement'?\n");
  assert_refused("velocity\tpower\n1\t2\n", plain,
                 "scallop run: cannot draw plot.svg: table has no column 'x': there are velocity, power\n");
  assert_refused("x\ty\n1\t2\n", (struct plot){ .by = "froude" },
                 "scallop run: cannot draw plot.svg: table has no column 'froude': there are x, y\n");
  assert_refused("{\"x\": 1, \"y\": 2}\n", plain,
                 "scallop run: cannot draw plot.svg: table is no table in TSV: it begins with '{'\n");
  assert_refused("# note\nx\ty\n1\t2\n3\n", plain,
                 "scallop run: cannot draw plot.svg: table:4: a row of 1 cells, where the header has 2\n");
  assert_refused("x\ty\n1\t2\t3\n", plain,
                 "scallop run: cannot draw plot.svg: table:2: a row of 3 cells, where the header has 2\n");
  assert_refused(NULL, (struct plot){ .y = none },
                 "scallop run: cannot draw plot.svg: without a script it needs a column x and columns y\n");
  assert_refused(NULL, (struct plot){ .y = many }, "scallop run: cannot draw plot.svg: more than 16 columns y\n");
  char rows[500] = "x\ty\n";
  for (int i = 0; i <= PLOT_VALUES; i++)
    snprintf(rows + strlen(rows), sizeof rows - strlen(rows), "%d\t1\n", i);
  assert_refused(
      rows, (struct plot){ .by = "x" },
      "scallop run: cannot draw plot.svg: column 'x' of table has more than 24 values, and each is to have a curve\n");
  FILE *file = fopen("table", "w");
  fwrite("x\ty\n1\0\t2\n", 1, 10, file);
  fclose(file);
  assert_refused(NULL, plain, "scallop run: cannot draw plot.svg: table:2: this is not a text file\n");
}

static void gnuplot_fails(void **state)
{
  (void)state;
  static const char rows[] = "x\ty\n1\t2\n";
  install("#!/bin/sh\necho part >&3\nprintf '\\ngnuplot> plot\\n         ^\\n  line 3: \\033undefined\\n\\n' >&2\nexit 1\n");
  assert_refused(rows, (struct plot){ .x = NULL },
                 "scallop run: gnuplot: gnuplot> plot\nscallop run: gnuplot: line 3: ?undefined\n"
                 "scallop run: cannot draw plot.svg: gnuplot has failed\n");
  install("#!/bin/sh\necho part >&3\nkill -9 $$\n");
  assert_refused(rows, (struct plot){ .x = NULL }, "scallop run: cannot draw plot.svg: gnuplot has failed\n");
  install("#!/bin/sh\necho a warning >&2\n");
  assert_refused(rows, (struct plot){ .x = NULL }, "scallop run: cannot draw plot.svg: gnuplot has drawn nothing\n");
  write_text("mine.gp", "");
  assert_refused(rows, (struct plot){ .script = "mine.gp" },
                 "scallop run: gnuplot: a warning\nscallop run: cannot draw plot.svg: gnuplot has drawn nothing\n");
  assert_refused(rows, (struct plot){ .script = "missing.gp" },
                 "scallop run: cannot draw plot.svg: missing.gp: No such file or directory\n");
  assert_refused(rows, (struct plot){ .script = "mine.gp", .table = "missing" },
                 "scallop run: cannot draw plot.svg: missing: No such file or directory\n");
  setenv("PATH", "/nonexistent", 1);
  assert_refused(
      rows, (struct plot){ .x = NULL },
      "scallop run: cannot draw plot.svg: gnuplot is not installed (Debian: gnuplot-nox); the tables are written\n");
}

/* Whatever descriptors are free, gnuplot has its three and the picture: also where standard input is closed, and what is
 * opened then takes its place. */
static void low_descriptors(void **state)
{
  (void)state;
  static const char begins[] = "set encoding utf8\n";
  install("#!/bin/sh\necho said >&2\ncat >&3\n");
  write_text("table", "x\ty\n1\t2\n");
  write_text("mine.gp", "");
  for (int fd = STDERR_FILENO + 1; fd < 16; fd++) /* inherited from whoever runs the test */
    close(fd);
  for (int closed = 0; closed <= 1; closed++) {
    char script[8192];
    struct said said;
    int input = fcntl(STDIN_FILENO, F_DUPFD, 20);
    for (int i = 0; i < 3; i++) /* what the test opens itself comes after */
      assert_true(dup(STDIN_FILENO) >= 0);
    said_begin(&said);
    for (int fd = STDERR_FILENO + 1; fd <= STDERR_FILENO + 3; fd++)
      close(fd);
    if (closed)
      close(STDIN_FILENO);
    bool drawn = plot_draw(&(struct plot){ .table = "table", .file = "plot.svg", .script = "mine.gp" }, "run");
    dup2(input, STDIN_FILENO);
    close(input);
    said_end(&said);
    assert_true(drawn);
    assert_string_equal(said.text, "scallop run: gnuplot: said\n");
    read_picture(script, sizeof script, "plot.svg");
    assert_memory_equal(script, begins, sizeof begins - 1);
  }
}

static int begin(void **state)
{
  snprintf(real_path, sizeof real_path, "%s", getenv("PATH") ? getenv("PATH") : "/bin:/usr/bin");
  return scratch_begin(state);
}

static int end(void **state)
{
  unlink("bin/gnuplot");
  return scratch_end(state);
}

int main(void)
{
#define TOLD(test) \
  { \
#test, test, with_a_gnuplot_of_ours, NULL, NULL \
  }
  const struct CMUnitTest tests[] = {
    TOLD(curves_are_of_their_rows),
    TOLD(one_curve_needs_no_key),
    TOLD(logarithmic_axes),
    TOLD(extreme_axes),
    TOLD(long_titles_go_below),
    TOLD(texts_are_bytes_to_gnuplot),
    TOLD(own_scripts),
    TOLD(a_picture_replaces_another),
    TOLD(names_of_pictures),
    TOLD(tables_that_cannot_be_drawn),
    TOLD(gnuplot_fails),
    TOLD(low_descriptors),
  };
  return cmocka_run_group_tests(tests, begin, end);
}
