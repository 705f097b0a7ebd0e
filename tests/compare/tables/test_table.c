/* Tables: what a cell looks like, and what is left of a table that fails. What a whole command writes has its tests in
 * tests/compare/command/cli_*.sh. */
#include "compare/answers/request.h"
#include "model/version.h"
#include "tests/support/said.h"
#include "tests/support/scratch_folder.h"

static const struct style tsv = { .command = "test", .output = "table" },
                          json = { .command = "test", .output = "table", .format = FORMAT_JSON };

static const char *const columns[] = { "T", "status", NULL };

static void write_row(struct table *t, double number, const char *text)
{
  table_number(t, number);
  table_text(t, text);
}

TEST(cells_follow_the_format)
{
  static const char *const wanted[] = {
    "# note\nT\tstatus\n0.667\ta \"quoted\" text\nnan\tok\n",
    "{\"T\": 0.667, \"status\": \"a \\\"quoted\\\" text\"}\n{\"T\": null, \"status\": \"ok\"}\n",
  };
  for (int i = 0; i < 2; i++) {
    struct style o = i == 0 ? tsv : json;
    struct table t;
    o.digits = 3;
    assert_true(table_open(&t, &o));
    table_note(&t, "note");
    table_columns(&t, columns);
    table_begin_rows(&t);
    write_row(&t, 2.0 / 3, "a \"quoted\"\ttext");
    write_row(&t, NAN, "ok");
    assert_true(table_close(&t));
    assert_holds("table", wanted[i]);
    assert_int_equal(entries(true), 1);
  }
}

/* Names of files, say, may have line breaks and whatever separates cells. */
TEST(a_text_begins_no_row_and_no_cell)
{
  static const char *const wanted[] = { "# formulas: a?b?c?d?e\nT\tstatus\n0\ta\\|b c d,e\n",
                                        "{\"T\": 0, \"status\": \"a\\\\|b c d,e\"}\n", "T,status\n0,\"a\\|b c d,e\"\n",
                                        "| T | status |\n| --- | --- |\n| 0 | a\\\\\\|b c d,e |\n",
                                        "# formulas: a?b?c?d?e\nT  status\n0  a\\|b c d,e\n" };
  for (int i = 0; i <= FORMAT_TABLE; i++) {
    struct style o = { .command = "test", .output = "table", .format = (enum format)i, .has_format = true };
    struct table t;
    assert_true(table_open(&t, &o));
    table_note(&t, "formulas: %s", "a\nb\rc\td\033e");
    table_columns(&t, columns);
    table_begin_rows(&t);
    write_row(&t, 0, "a\\|b\nc\td,e");
    assert_true(table_close(&t));
    assert_holds("table", wanted[i]);
  }
}

/* More than a buffer holds, in turn with notes */
TEST(rows_and_notes_keep_their_order)
{
  enum { PARTS = 4, ROWS = 5000 };
  struct table t;
  assert_true(table_open(&t, &tsv));
  table_columns(&t, columns);
  table_begin_rows(&t);
  for (int i = 0; i < PARTS; i++) {
    for (int j = 0; j < ROWS; j++)
      write_row(&t, i * ROWS + j, "ok");
    table_note(&t, "end of %d", i);
  }
  assert_true(table_close(&t));
  FILE *file = fopen("table", "r");
  assert_non_null(file);
  assert_int_equal(fscanf(file, "T status"), 0);
  for (int i = 0; i < PARTS; i++) {
    int number = -1, end = -1;
    for (int j = 0; j < ROWS; j++) {
      assert_int_equal(fscanf(file, "%d ok", &number), 1);
      assert_int_equal(number, i * ROWS + j);
    }
    assert_int_equal(fscanf(file, " # end of %d", &end), 1);
    assert_int_equal(end, i);
  }
  fclose(file);
  entries(true);
}

/* Blocks of rows: the first decides the width, and a wider one is wider from there on; what is kept does not grow. */
TEST(aligned_rows_come_in_blocks)
{
  const struct style people = { .command = "test", .output = "table", .format = FORMAT_TABLE, .has_format = true };
  struct table t;
  char line[100];
  long rows = 0;
  assert_true(table_open(&t, &people));
  table_columns(&t, columns);
  table_begin_rows(&t);
  for (int i = 0; i < 3 * ALIGNED_ROWS + 1; i++) {
    write_row(&t, i < 2 * ALIGNED_ROWS ? 1 : 123456, "ok");
    assert_true(t.sink[0].aligned.rows <= ALIGNED_ROWS + 1);
  }
  assert_true(table_close(&t));
  FILE *file = fopen("table", "r");
  assert_non_null(file);
  for (; fgets(line, sizeof line, file); rows++)
    assert_string_equal(line, rows == 0 ? "T  status\n" : rows <= 2 * ALIGNED_ROWS ? "1  ok\n" : "123456  ok\n");
  fclose(file);
  assert_int_equal(rows, 3 * ALIGNED_ROWS + 2);
  entries(true);
}

/* Not what varies or is not used; no line where nothing is left. */
TEST(parameters_that_do_not_hold_are_not_said)
{
  static const char *const some[] = { "m1", "F1", "T", NULL };
  struct point p = point_initial(NULL);
  struct table t;
  p.written[0] = "1e0";
  p.written[6] = "0.750";
  for (int i = 0; i < 3; i++) {
    assert_true(table_open(&t, &tsv));
    note_parameters(&t, &p, i == 0 ? some : i == 1 ? NULL : crawler_parameters, i == 1);
    assert_true(table_close(&t));
    assert_holds("table", i == 0   ? "# parameters: m2=1 F2=1 L=10 alpha=0.75 gait=quadratic\n"
                          : i == 1 ? "# parameters: m1=1e0 m2=1 F1=4 F2=1 L=10 T=1 alpha=0.750 gait=quadratic\n"
                                   : "");
  }
  entries(true);
}

struct measured_row {
  double order;
  long row;
  int points;
  const char *status;
};

TEST(columns_join_name_and_value)
{
  static const struct table_column joined[] = {
    { TABLE_COLUMN("row", column_long, offsetof(struct measured_row, row)) },
    { TABLE_COLUMN("order", column_rounded, offsetof(struct measured_row, order)), .format = "%.2f", .blank = "nan" },
    { TABLE_COLUMN("points", column_count, offsetof(struct measured_row, points)), .blank = "-" },
    { TABLE_COLUMN("status", column_text, offsetof(struct measured_row, status)) },
    { .name = NULL },
  };
  static const struct measured_row rows[] = { { -0.001, 1, 4, "ok" }, { 2, 1000000, 5, "unsolved" } };
  static const char *const wanted[] = {
    "# scallop " SCALLOP_VERSION "\n# command: test a?b\nrow\torder\tpoints\tstatus\n1\t0.00\t4\tok\n"
    "1000000\tnan\t-\tunsolved\n",
    "{\"row\": 1, \"order\": 0.00, \"points\": 4, \"status\": \"ok\"}\n"
    "{\"row\": 1000000, \"order\": null, \"points\": \"-\", \"status\": \"unsolved\"}\n{\"all\": 2}\n",
  };
  for (int i = 0; i < 2; i++) {
    struct style style = i == 0 ? tsv : json;
    struct table t;
    assert_true(table_head(&t, &style, "%s", "test a\nb"));
    table_add(&t, joined);
    table_begin_rows(&t);
    table_row(&t, joined, &rows[0], true);
    table_row(&t, joined, &rows[1], false);
    if (table_restart_columns(&t)) {
      table_columns(&t, (const char *const[]){ "all", NULL });
      table_count(&t, 2);
    }
    assert_true(table_close(&t));
    assert_holds("table", wanted[i]);
  }
  entries(true);
}

TEST(an_abandoned_table_leaves_nothing)
{
  struct table t;
  write_text("table", "earlier");
  assert_true(table_open(&t, &tsv));
  table_columns(&t, columns);
  table_begin_rows(&t);
  write_row(&t, 1, "ok");
  table_abandon(&t);
  assert_holds("table", "earlier");
  assert_int_equal(entries(true), 1);
}

TEST(a_failed_write_is_told_once)
{
  const struct style full = { .command = "test", .output = "/dev/full" };
  struct table t;
  struct said said;
  if (access("/dev/full", W_OK) != 0)
    skip();
  assert_true(table_open(&t, &full));
  said_begin(&said);
  table_columns(&t, columns);
  table_begin_rows(&t);
  bool failed_at_first = table_failed(&t);
  for (int j = 0; j < 20000; j++)
    write_row(&t, j, "ok");
  bool failed = table_failed(&t), closed = table_close(&t);
  said_end(&said);
  assert_true(!failed_at_first && failed && !closed);
  assert_string_equal(said.text, "scallop test: cannot write /dev/full: No space left on device\n");
}

TEST(a_refused_output_is_named)
{
  const struct style missing = { .command = "test", .output = "missing/table" };
  struct table t;
  struct said said;
  said_begin(&said);
  bool opened = table_open(&t, &missing);
  said_end(&said);
  assert_false(opened);
  assert_string_equal(said.text, "scallop test: cannot write missing/table: No such file or directory\n");
}

int main(void) { return check_run(scratch_begin, scratch_end); }
