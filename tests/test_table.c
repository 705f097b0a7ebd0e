/* Tables: lead cells, and what continues an open table. What a whole command writes has its tests in tests/cli_*.sh. */
#include "compare/command/compare.h"
#include "tests/said.h"
#include "tests/scratch_folder.h"

static const struct command command = { .name = "test" };
static const struct options tsv = { .command = &command, .output = "elsewhere" },
                            json = { .command = &command, .output = "elsewhere", .format = FORMAT_JSON };

static const char *const lead[] = { "F1", "gait", NULL };
static const char *const columns[] = { "T", "status", NULL };

static struct options in(const struct options *options, struct table *into)
{
  struct options o = *options;
  o.into = into;
  o.point.crawler = scallop_crawler_default();
  return o;
}

static void write_row(struct table *t, double number, const char *text)
{
  table_number(t, number);
  table_text(t, text);
}

/* As a command does it that knows only its options */
static bool write_command(const struct options *o, const char *const *names, double first, const char *end)
{
  struct table t;
  assert_true(table_open(&t, o));
  table_note(&t, "command: %s, from %g", o->command->name, first);
  table_columns(&t, names);
  table_begin_rows(&t);
  write_row(&t, first, "ok");
  write_row(&t, first + 1, "out of range");
  if (end)
    table_note(&t, "%s", end);
  return table_close(&t);
}

static void lead_cells_begin_every_row(void **state)
{
  (void)state;
  static const double numbers[2][2] = { { 2.385, NAN }, { 0.1, 7.25 } };
  static const char *const texts[] = { NULL, "a \"quoted\"\ttext" };
  static const char *const wanted[] = {
    "# note\nF1\tgait\tT\tstatus\n2.385\ta \"quoted\" text\t1.5\tok\n0.1\t7.25\t2.5\tok\n",
    "{\"F1\": 2.385, \"gait\": \"a \\\"quoted\\\" text\", \"T\": 1.5, \"status\": \"ok\"}\n"
    "{\"F1\": 0.1, \"gait\": 7.25, \"T\": 2.5, \"status\": \"ok\"}\n",
  };
  for (int i = 0; i < 2; i++) {
    struct table t;
    assert_true(table_open_at(&t, i == 0 ? &tsv : &json, "table"));
    table_note(&t, "note");
    table_lead(&t, lead, 2);
    table_columns(&t, columns);
    table_begin_rows(&t);
    table_lead_values(&t, numbers[0], texts);
    write_row(&t, 1.5, "ok");
    table_lead_values(&t, numbers[1], NULL);
    write_row(&t, 2.5, "ok");
    assert_true(table_close(&t));
    assert_holds("table", wanted[i]);
    assert_int_equal(entries(true), 1);
  }
}

static void lead_numbers_are_written_as_others(void **state)
{
  (void)state;
  struct options short_json = json;
  short_json.digits = 3;
  static const double numbers[] = { 2.0 / 3, NAN };
  struct table t;
  assert_true(table_open_at(&t, &short_json, "table"));
  table_lead(&t, lead, 2);
  table_columns(&t, columns);
  table_begin_rows(&t);
  table_lead_values(&t, numbers, NULL);
  write_row(&t, 2.0 / 3, "ok");
  assert_true(table_close(&t));
  assert_holds("table", "{\"F1\": 0.667, \"gait\": null, \"T\": 0.667, \"status\": \"ok\"}\n");
  entries(true);
}

static void continue_twice(const struct options *options, const char *wanted)
{
  struct table t;
  double F1 = 4;
  assert_true(table_open_at(&t, options, "table"));
  table_lead(&t, lead, 1);
  table_lead_values(&t, &F1, NULL);
  struct options o = in(options, &t);
  assert_true(write_command(&o, columns, 1, "after the first"));
  assert_int_equal(access("elsewhere", F_OK), -1);
  F1 = 5;
  assert_true(write_command(&o, columns, 3, "after the second"));
  assert_true(table_close(&t));
  assert_holds("table", wanted);
  assert_int_equal(entries(true), 1);
}

static void rows_follow_rows(void **state)
{
  (void)state;
  continue_twice(&tsv, "# command: test, from 1\nF1\tT\tstatus\n4\t1\tok\n4\t2\tout of range\n# after the first\n"
                       "5\t3\tok\n5\t4\tout of range\n# after the second\n");
  continue_twice(&json, "{\"F1\": 4, \"T\": 1, \"status\": \"ok\"}\n{\"F1\": 4, \"T\": 2, \"status\": \"out of range\"}\n"
                        "{\"F1\": 5, \"T\": 3, \"status\": \"ok\"}\n{\"F1\": 5, \"T\": 4, \"status\": \"out of range\"}\n");
}

static void parameters_are_said_once(void **state)
{
  (void)state;
  struct table t;
  assert_true(table_open_at(&t, &tsv, "table"));
  for (int i = 0; i < 2; i++) {
    struct table rows;
    struct options o = in(&tsv, &t);
    assert_true(table_open(&rows, &o));
    table_parameters(&rows, &o, NULL, false);
    table_columns(&rows, columns);
    table_begin_rows(&rows);
    assert_true(table_close(&rows));
  }
  assert_true(table_close(&t));
  assert_holds("table", "# parameters: m1=1 m2=1 F1=4 F2=1 L=10 T=1 alpha=0.75 gait=quadratic\nT\tstatus\n");
  entries(true);
}

/* Not what leads the rows or is set by that, nor what a table says it does not use; no line where nothing is left. */
static void parameters_that_do_not_hold_are_not_said(void **state)
{
  (void)state;
  static const char *const ratio[] = { "m1_over_m2", NULL }, *const some[] = { "F1", "T", NULL };
  struct options o = tsv;
  struct table t;
  o.point.crawler = scallop_crawler_default();
  o.point.written[0] = "1e0";
  o.point.written[6] = "0.750";
  for (int i = 0; i < 3; i++) {
    assert_true(table_open_at(&t, &o, "table"));
    table_lead(&t, ratio, i == 0);
    table_parameters(&t, &o, i == 0 ? some : i == 1 ? NULL : crawler_parameters, i == 1);
    assert_true(table_close(&t));
    assert_holds("table", i == 0   ? "# parameters: m2=1 F2=1 L=10 alpha=0.75 gait=quadratic\n"
                          : i == 1 ? "# parameters: m1=1e0 m2=1 F1=4 F2=1 L=10 T=1 alpha=0.750 gait=quadratic\n"
                                   : "");
  }
  entries(true);
}

static void names_need_not_outlive_their_rows(void **state)
{
  (void)state;
  struct table t;
  char name[] = "T";
  const char *const names[] = { name, "status", NULL };
  assert_true(table_open_at(&t, &tsv, "table"));
  struct options o = in(&tsv, &t);
  assert_true(write_command(&o, names, 1, NULL));
  *name = 'U';
  assert_true(write_command(&o, columns, 3, NULL));
  assert_true(table_close(&t));
  entries(true);
}

/* More than the text buffer holds, in turn with notes, which go past it */
static void long_continuations_keep_their_order(void **state)
{
  (void)state;
  enum { WRITERS = 4, ROWS = 5000 };
  struct table t;
  double number = 0;
  assert_true(table_open_at(&t, &tsv, "table"));
  table_lead(&t, lead, 1);
  table_lead_values(&t, &number, NULL);
  struct options o = in(&tsv, &t);
  for (int i = 0; i < WRITERS; i++) {
    struct table rows;
    assert_true(table_open(&rows, &o));
    table_columns(&rows, columns);
    table_begin_rows(&rows);
    for (int j = 0; j < ROWS; j++, number++)
      write_row(&rows, number, "ok");
    table_note(&rows, "end of %d", i);
    assert_true(table_close(&rows));
  }
  assert_true(table_close(&t));
  FILE *file = fopen("table", "r");
  assert_non_null(file);
  assert_int_equal(fscanf(file, "F1 T status"), 0);
  for (int i = 0; i < WRITERS; i++) {
    int first = -1, second = -1, end = -1;
    for (int j = 0; j < ROWS; j++) {
      assert_int_equal(fscanf(file, "%d %d ok", &first, &second), 2);
      assert_true(first == i * ROWS + j && second == first);
    }
    assert_int_equal(fscanf(file, " # end of %d", &end), 1);
    assert_int_equal(end, i);
  }
  fclose(file);
  entries(true);
}

static void other_columns_are_refused(void **state)
{
  (void)state;
  static const struct {
    const char *names[4];
    const char *says;
  } others[] = {
    { { "T", "regime" }, "column 2 is 'regime', and 'status' in the rows before" },
    { { "Ts", "status" }, "column 1 is 'Ts', and 'T' in the rows before" },
    { { "T" }, "column 2 is missing, and 'status' in the rows before" },
    { { "T", "status", "more" }, "column 3 is 'more', and missing in the rows before" },
  };
  for (size_t i = 0; i < sizeof others / sizeof *others; i++)
    for (int is_json = 0; is_json <= 1; is_json++) {
      struct table t, rows;
      struct said said;
      assert_true(table_open_at(&t, is_json ? &json : &tsv, "table"));
      struct options o = in(is_json ? &json : &tsv, &t);
      assert_true(write_command(&o, columns, 1, NULL));
      assert_true(table_open(&rows, &o));
      table_columns(&rows, others[i].names);
      said_begin(&said);
      table_begin_rows(&rows);
      said_end(&said);
      assert_true(table_failed(&rows));
      for (int j = 0; j < 20000; j++) /* more than the text buffer holds */
        table_number(&rows, 0.123456);
      table_note(&rows, "not written");
      assert_false(table_close(&rows));
      char wanted[200];
      snprintf(wanted, sizeof wanted, "scallop test: cannot write table: %s: a table has the same columns throughout\n",
               others[i].says);
      assert_string_equal(said.text, wanted);
      assert_false(table_failed(&t));
      assert_true(write_command(&o, columns, 3, NULL));
      assert_true(table_close(&t));
      assert_holds("table", is_json
                                ? "{\"T\": 1, \"status\": \"ok\"}\n{\"T\": 2, \"status\": \"out of range\"}\n"
                                  "{\"T\": 3, \"status\": \"ok\"}\n{\"T\": 4, \"status\": \"out of range\"}\n"
                                : "# command: test, from 1\nT\tstatus\n1\tok\n2\tout of range\n3\tok\n4\tout of range\n");
      entries(true);
    }
}

static void an_abandoned_continuation_leaves_the_table(void **state)
{
  (void)state;
  struct table t, rows;
  assert_true(table_open_at(&t, &tsv, "table"));
  struct options o = in(&tsv, &t);
  assert_true(table_open(&rows, &o));
  table_note(&rows, "the first");
  table_abandon(&rows); /* before there are columns */
  assert_true(table_open(&rows, &o));
  table_note(&rows, "the second");
  table_columns(&rows, columns);
  table_begin_rows(&rows);
  write_row(&rows, 1, "ok");
  table_abandon(&rows);
  assert_true(write_command(&o, columns, 3, NULL));
  assert_true(table_close(&t));
  assert_holds("table", "# the first\nT\tstatus\n1\tok\n3\tok\n4\tout of range\n");
  entries(true);
}

static void an_abandoned_table_leaves_nothing(void **state)
{
  (void)state;
  struct table t;
  write_text("table", "earlier");
  assert_true(table_open_at(&t, &tsv, "table"));
  struct options o = in(&tsv, &t);
  assert_true(write_command(&o, columns, 1, NULL));
  table_abandon(&t);
  assert_holds("table", "earlier");
  assert_int_equal(entries(true), 1);
}

/* A continuation sees it at once; the table says it. */
static void a_failed_write_is_told_once(void **state)
{
  (void)state;
  struct table t, rows;
  struct said said;
  if (access("/dev/full", W_OK) != 0)
    skip();
  assert_true(table_open_at(&t, &tsv, "/dev/full"));
  struct options o = in(&tsv, &t);
  said_begin(&said);
  assert_true(table_open(&rows, &o));
  table_columns(&rows, columns);
  table_begin_rows(&rows);
  bool failed_at_first = table_failed(&rows);
  for (int j = 0; j < 20000; j++)
    write_row(&rows, j, "ok");
  bool failed = table_failed(&rows), rows_closed = table_close(&rows), closed = table_close(&t);
  said_end(&said);
  assert_true(!failed_at_first && failed && !rows_closed && !closed);
  assert_string_equal(said.text, "scallop test: cannot write /dev/full: No space left on device\n");
}

static void a_refused_output_is_named(void **state)
{
  (void)state;
  struct table t;
  struct said said;
  said_begin(&said);
  bool opened = table_open_at(&t, &tsv, "missing/table");
  said_end(&said);
  assert_false(opened);
  assert_string_equal(said.text, "scallop test: cannot write missing/table: No such file or directory\n");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(lead_cells_begin_every_row),
    cmocka_unit_test(lead_numbers_are_written_as_others),
    cmocka_unit_test(rows_follow_rows),
    cmocka_unit_test(parameters_are_said_once),
    cmocka_unit_test(parameters_that_do_not_hold_are_not_said),
    cmocka_unit_test(names_need_not_outlive_their_rows),
    cmocka_unit_test(long_continuations_keep_their_order),
    cmocka_unit_test(other_columns_are_refused),
    cmocka_unit_test(an_abandoned_continuation_leaves_the_table),
    cmocka_unit_test(an_abandoned_table_leaves_nothing),
    cmocka_unit_test(a_failed_write_is_told_once),
    cmocka_unit_test(a_refused_output_is_named),
  };
  return cmocka_run_group_tests(tests, scratch_begin, scratch_end);
}
