/* Columns that are chosen: which, in which order, and those that are formulas. */
#include "compare/columns/columns.h"

#include "tests/support/check.h"
#include "tests/support/said.h"
#include "tests/support/scratch_folder.h"

static const char *const names[] = { "T", "v end", "status", "coefficient", NULL };

static void write_table(struct table *t, struct style *style, const char *text)
{
  assert_null(columns_read(&style->choice, text));
  assert_true(table_open(t, style));
  table_note(t, "note");
  table_columns(t, names);
  table_begin_rows(t);
  for (int i = 1; i <= 2; i++) {
    table_number(t, 0.1 * i);
    table_rounded(t, 1.0 / 3 * i, "%.2g");
    table_text(t, i == 1 ? "ok" : "a|b");
    table_digits(t, i == 1 ? "-3/40" : "0.30000000000000000000001");
  }
}

TEST(names_and_formulas)
{
  static const struct {
    const char *columns, *wanted;
    enum format format;
  } cases[] = {
    { "status,T", "# note\nstatus\tT\nok\t0.1\na|b\t0.2\n", FORMAT_TSV },
    { "T,v end,status,coefficient",
      "# note\nT\tv end\tstatus\tcoefficient\n0.1\t0.33\tok\t-3/40\n0.2\t0.67\ta|b\t0.30000000000000000000001\n",
      FORMAT_TSV },
    { " c = 4*T , T", "# note\nc\tT\n0.4\t0.1\n0.8\t0.2\n", FORMAT_TSV },
    { "max(T,coefficient),n=T+status", "# note\nmax(T,coefficient)\tn\n0.1\tnan\n0.3\tnan\n", FORMAT_TSV },
    { "c=40*coefficient,status", "{\"c\": -3, \"status\": \"ok\"}\n{\"c\": 12, \"status\": \"a|b\"}\n", FORMAT_JSON },
    { "status,q=2/T", "status,q\nok,20\na|b,10\n", FORMAT_CSV },
    { "status", "| status |\n| --- |\n| ok |\n| a\\|b |\n", FORMAT_MARKDOWN },
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    struct style style = { .command = "test", .output = "table", .format = cases[i].format };
    struct table t;
    write_table(&t, &style, cases[i].columns);
    assert_true(table_close(&t));
    assert_holds("table", cases[i].wanted);
    columns_free(style.choice);
  }
}

TEST(columns_that_are_not_there)
{
  static const struct {
    const char *columns, *message;
  } cases[] = { { "T,statu", "--columns: there is no column 'statu': did you mean 'status'?" },
                { "foo_bar_baz_qux", "there is no column 'foo_bar_baz_qux': there are T, v end, status, coefficient" },
                { "c=4*S", "'4*S': character 3" },
                { "c=4*", "'4*': character" },
                { "T,(28)", "'(28)' is not allowed here: it takes names of columns" },
                { "T,T", "the column 'T' is there twice" },
                { "a=T,a=2*T", "the column 'a' is there twice" },
                { "a\"b=T", "printable ASCII" } };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    struct style style = { .command = "test", .output = "table" };
    struct table t;
    struct said said;
    entries(true);
    said_begin(&said);
    write_table(&t, &style, cases[i].columns);
    assert_true(table_failed(&t) && style.choice->refused);
    assert_false(table_close(&t));
    said_end(&said);
    if (!strstr(said.text, cases[i].message))
      fail_msg("%s: %s", cases[i].columns, said.text);
    assert_int_equal(entries(true), 0);
    columns_free(style.choice);
  }
}

TEST(texts_that_are_no_choice)
{
  static const char *const texts[] = { "", ",", "T,", "T,,status", " ", "a=", "=T", " = ", "T, ,a=T" };
  for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
    struct table_choice *choice;
    const char *wrong = columns_read(&choice, texts[i]);
    assert_non_null(wrong);
    assert_non_null(strstr(wrong, "names of columns and NAME = FORMULA"));
    assert_null(choice);
  }
}

TEST(a_table_that_is_given_up)
{
  struct style style = { .command = "test", .output = "table" };
  struct table t;
  write_table(&t, &style, "T");
  table_abandon(&t);
  assert_int_equal(entries(true), 0);
  assert_true(table_open(&t, &style));
  table_note(&t, "no rows");
  assert_true(table_close(&t));
  assert_holds("table", "# no rows\n");
  columns_free(style.choice);
}

int main(void) { return check_run(scratch_begin, scratch_end); }
