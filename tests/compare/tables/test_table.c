/* Tables: what a cell looks like, and what is left of a table that fails. What a whole command writes has its tests in
 * tests/compare/command/cli_*. */
#include "compare/tables/table.h"
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

/* Cells follow the format. Names of files, say, may have line breaks and whatever separates cells: they begin no row
 * and no cell. */
TEST(cells_and_texts)
{
  static const char *const wanted[] = {
    "# formulas: a?b?c?d?e\nT\tstatus\n0.667\ta\\|\"b\" c d,e\nnan\tok\n",
    "{\"T\": 0.667, \"status\": \"a\\\\|\\\"b\\\" c d,e\"}\n{\"T\": null, \"status\": \"ok\"}\n",
    "T,status\n0.667,\"a\\|\"\"b\"\" c d,e\"\nnan,ok\n",
    "| T | status |\n| --- | --- |\n| 0.667 | a\\\\\\|\"b\" c d,e |\n| nan | ok |\n",
    "# formulas: a?b?c?d?e\n    T  status\n0.667  a\\|\"b\" c d,e\n  nan  ok\n"
  };
  for (int i = 0; i <= FORMAT_TABLE; i++) {
    struct style o = {
      .command = "test", .output = "table", .format = (enum format)i, .has_format = true, .digits = 3
    };
    struct table t;
    assert_true(table_open(&t, &o));
    table_note(&t, "formulas: %s", "a\nb\rc\td\033e");
    table_columns(&t, columns);
    table_begin_rows(&t);
    write_row(&t, 2.0 / 3, "a\\|\"b\"\nc\td,e");
    write_row(&t, NAN, "ok");
    assert_true(table_close(&t));
    assert_holds("table", wanted[i]);
    assert_int_equal(entries(true), 1);
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

int main(void) { return check_run(scratch_begin, scratch_end); }
