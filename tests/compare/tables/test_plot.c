/* compare/tables/plot and scripts/plots/plot.sh: what gnuplot is told, what becomes of the picture, and what is said
 * where there is none. A program of the test's own takes the place of gnuplot and keeps what it is told as the picture;
 * the last tests are of gnuplot itself, if it is installed. */
#include "compare/tables/plot.h"
#include "tests/support/said.h"
#include "tests/support/scratch_folder.h"

#include <fcntl.h>
#include <sys/stat.h>

static char real_path[4096];
static const char rows[] = "x\ty\tz\n1\t2\t0.1\n1.5\tnan\t0.2\n2\t3\t5e3\n";

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

static const char keeps_script[] = "#!/bin/sh\n"
                                   "cat >script\n"
                                   "eval \"$(sed -n 's/^output_file = /file=/p' script)\"\n"
                                   "cp script \"$file\"\n";

/* Each test begins with this, or with installed(): a folder with the table, and the gnuplot. */
static void ours(void)
{
  unlink("bin/gnuplot");
  entries(true);
  write_text("table", rows);
  install(keeps_script);
}

/* y over x in "table", unless the plot says otherwise */
static struct plot completed(struct plot p)
{
  p.table = p.table ? p.table : "table";
  p.file = p.file ? p.file : "plot.svg";
  p.x = p.x ? p.x : "x";
  p.y = p.y ? p.y : "y";
  return p;
}

static void assert_in(const char *text, const char *part)
{
  if (!strstr(text, part))
    fail_msg("no '%s' in\n%s", part, text);
}

/* Whether the plot is drawn, and what is said; no file stays open. */
static bool attempt(struct plot *plot, struct said *said)
{
  int before = lowest_free();
  *plot = completed(*plot);
  said_begin(said);
  bool drawn = plot_draw(plot, "run");
  said_end(said);
  assert_int_equal(lowest_free(), before);
  return drawn;
}

/* Draws the plot, and gives what is in the picture. */
static const char *draws(struct plot plot)
{
  static char picture[100000];
  struct said said;
  if (!attempt(&plot, &said) || *said.text)
    fail_msg("%s", said.text);
  read_text(plot.file, picture, sizeof picture);
  return picture;
}

/* Nothing is drawn, this is said, and an earlier picture stays. */
static void refused(struct plot plot, const char *wanted)
{
  struct said said;
  write_text("plot.svg", "earlier");
  int files = entries(false);
  assert_false(attempt(&plot, &said));
  assert_in(said.text, wanted);
  assert_int_equal(entries(false), files);
  assert_holds("plot.svg", "earlier");
}

TEST(texts_are_bytes_to_gnuplot)
{
  ours();
  write_text("plot.svg", "earlier");
  write_text("<t", "$x@\ta'`b`\\\"\ty\t\"; !touch hacked\n1\t2\t3\t`touch hacked`\n");
  struct plot nasty = { .table = "<t",
                        .x = "$x@",
                        .y = "a'`b`\\\",y",
                        .by = "\"; !touch hacked",
                        .title = "1\n!touch hacked\xce\xb1",
                        .log_y = true };
  const char *script = draws(nasty);
  assert_in(script, "table = \"./\\0074t\"\noutput_file = \"/");
  assert_in(script,
            "kind = \"svg\"\ntitle = \"1\\0077\\0041touch hacked\\0316\\0261\"\nx_column = \"\\0044x\\0100\"\n");
  assert_in(script, "ys = 2\ny_columns[1] = \"a\\0047\\0140b\\0140\\0134\\0042\"\ny_columns[2] = \"y\"\n");
  assert_in(script, "bys = 1\nby_columns[1] = \"\\0042\\0073 \\0041touch hacked\"\nlog_x = 0\nlog_y = 1\n");
  assert_in(script, "title \"y, \\0140touch hacked\\0140\"\n");
  nasty.script = "<sub/it's.gp";
  assert_in(draws(nasty), "load \"./\\0074sub/it\\0047s.gp\"\nunset output\n");
}

TEST(names_of_pictures)
{
  ours();
  assert_true(plot_kind("a.svg") && plot_kind("dir.png/a.b.png") && plot_kind("a.pdf"));
  assert_false(plot_kind("a.SVG") || plot_kind("a") || plot_kind("a.svgz"));
  mkdir("folder.svg", 0777);
  refused((struct plot){ .file = "folder.svg" },
          "scallop run: cannot draw folder.svg: cannot write it: Is a directory\n");
  refused((struct plot){ .file = "missing/plot.svg" },
          "scallop run: cannot draw missing/plot.svg: cannot write it: No such file or directory\n");
}

TEST(gnuplot_fails)
{
  ours();
  install("#!/bin/sh\nprintf '\\ngnuplot> plot\\n         ^\\n  line 3: \\033undefined\\n\\n' >&2\nexit 1\n");
  refused((struct plot){ .x = NULL }, "scallop run: gnuplot: gnuplot> plot\nscallop run: gnuplot: line 3: ?undefined\n"
                                      "scallop run: cannot draw plot.svg: gnuplot has failed\n");
  install("#!/bin/sh\nkill -9 $$\n");
  refused((struct plot){ .x = NULL }, "scallop run: cannot draw plot.svg: gnuplot has failed\n");
  install("#!/bin/sh\ncat >/dev/null\necho a warning >&2\n");
  refused((struct plot){ .script = "mine.gp" },
          "scallop run: gnuplot: a warning\nscallop run: cannot draw plot.svg: gnuplot has drawn nothing\n");
  setenv("PATH", "/nonexistent", 1);
  refused(
      (struct plot){ .x = NULL },
      "scallop run: cannot draw plot.svg: gnuplot is not installed (Debian: gnuplot-nox); the tables are written\n");
}

/* Where standard input is closed, the script takes its place. */
TEST(standard_input_is_closed)
{
  ours();
  int input = fcntl(STDIN_FILENO, F_DUPFD, 20);
  struct plot plot = completed((struct plot){ .x = NULL });
  close(STDIN_FILENO);
  bool drawn = plot_draw(&plot, "run");
  dup2(input, STDIN_FILENO);
  close(input);
  assert_true(drawn);
}

static void installed(void)
{
  struct said said;
  struct plot plot = { .file = "try.svg" };
  ours();
  unlink("bin/gnuplot");
  setenv("PATH", real_path, 1);
  attempt(&plot, &said);
  if (strstr(said.text, "gnuplot is not installed"))
    skip();
  unlink("try.svg");
}

/* How many times a curve, the first of this colour, is begun (M) or goes on (L) */
static int strokes(const char *picture, const char *colour, char kind)
{
  int count = 0;
  const char *path = strstr(picture, colour);
  assert_non_null(path);
  for (path = strstr(path, "d='") + 3; *path != '\''; path++)
    count += *path == kind;
  return count;
}

/* Rows of other values do not interrupt a curve; values that cannot be shown do. */
TEST(curves_are_of_their_rows)
{
  installed();
  write_text("table", "# note\nx\tF\tg\ty\tz\n1\t2\ta\t1\tnan\n1\t40\ta\t1\tnan\n2\t2\ta\t2\t-\n2\t40\ta\tnan\t-\n"
                      "3\t2\ta\t3\tinf\n3\t40\ta\t3\t0\n4\t2\ta\t4\t5\n4\t40\ta\tinf\t0\n5\t2\ta\t5\t5\n# end\n");
  const char *picture = draws((struct plot){ .by = "F,g" });
  assert_in(picture, ">F = 2, a</");
  assert_in(picture, ">F = 40, a</");
  static const char blue[] = "stroke='rgb( 11,  60, 140)'", red[] = "stroke='rgb(200,  16,  46)'";
  assert_int_equal(strokes(picture, blue, 'M'), 1);
  assert_int_equal(strokes(picture, blue, 'L'), 4);
  assert_int_equal(strokes(picture, red, 'M'), 2);
  assert_int_equal(strokes(picture, red, 'L'), 0);
  picture = draws((struct plot){ .y = "y, z", .by = "F", .log_y = true });
  assert_in(picture, ">y, F = 2</");
  assert_in(picture, ">z, F = 40 (none)</");
}

TEST(axes_of_any_width)
{
  installed();
  static const char *const extreme[] = { "1\t1\n", "1\t1\n1.0000000000000002\t1\n", "1e-307\t1e-307\n",
                                         "1e-300\t1\n1e300\t1\n" };
  for (size_t i = 0; i < 2 * sizeof extreme / sizeof *extreme; i++) {
    char table[100];
    snprintf(table, sizeof table, "x\ty\n%s", extreme[i / 2]);
    write_text("table", table);
    draws((struct plot){ .log_x = i % 2 == 1, .log_y = i % 2 == 1 });
  }
  write_text("table", "x\ty\n0.2\t3\n0\t5\n0.3\tinf\n0.5\t300\n");
  const char *picture = draws((struct plot){ .log_x = true, .log_y = true });
  static const char *const tics[] = { ">0.25<", ">0.45<", ">5<", ">10<", ">200<" };
  for (size_t i = 0; i < sizeof tics / sizeof *tics; i++)
    assert_in(picture, tics[i]);
  assert_null(strstr(picture, ">0.55<"));
  assert_in(draws((struct plot){ .title = "a_b {c}^2 \\n & < > \" ' end" }), "a_b {c}^2 \\n &amp; &lt; ");
}

TEST(gnuplot_says_what_is_wrong)
{
  installed();
  write_text("mine.gp", "plot table using 1:2 skip 1\nplot undefined_variable\n");
  refused((struct plot){ .script = "mine.gp" },
          "scallop run: gnuplot: \"./mine.gp\" line 2: undefined variable: undefined_variable\n"
          "scallop run: cannot draw plot.svg: gnuplot has failed\n");
  refused((struct plot){ .script = "missing.gp" }, "missing.gp");
  refused((struct plot){ .table = "missing" }, "missing");
  assert_false(plot_refused());
  char many[500] = "x\ty\n";
  for (int i = 0; i <= 24; i++)
    snprintf(many + strlen(many), sizeof many - strlen(many), "%d\t1\n", i);
  const struct {
    const char *table;
    struct plot plot;
    const char *message;
  } cases[] = {
    { rows, { .y = "power" }, "scallop run: cannot draw plot.svg: the table has no column power\n" },
    { rows, { .x = "power" }, "the table has no column power\n" },
    { rows, { .by = "y,power" }, "the table has no column power\n" },
    { rows, { .y = "y,,z" }, "one to eight columns" },
    { "# only notes\nx\ty\n", { .x = NULL }, "the table has no rows\n" },
    { "", { .x = NULL }, "the table has no columns\n" },
    { "x\ty\n1\t0\n2\t-5\n", { .log_y = true }, "no row has a number that the axis can show in both columns\n" },
    { many, { .by = "x" }, "more than 24 combinations of values: each has a curve\n" }
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    write_text("table", cases[i].table);
    refused(cases[i].plot, cases[i].message);
    assert_true(i > 0 || plot_refused());
  }
}

static int begin(void **state)
{
  snprintf(real_path, sizeof real_path, "%s", getenv("PATH") ? getenv("PATH") : "/bin:/usr/bin");
  return scratch_begin(state);
}

int main(void) { return check_run(begin, scratch_end); }
