/* Tables as people have them: what separates cells, which names columns have, how numbers are written. */
#include "compare/tables/tsv.h"
#include "compare/text/message.h"
#include "tests/support/said.h"
#include "tests/support/scratch_folder.h"

/* "names: cells; cells ...", with commas between, numbers read */
static const char *read_all(const char *table, enum tsv_style style)
{
  static char text[1000];
  struct tsv t;
  int used = 0;
  write_text("table.txt", table);
  assert_true(tsv_open(&t, "table.txt", style));
  for (int i = 0; i < t.columns; i++)
    used += snprintf(text + used, sizeof text - (size_t)used, "%s%s", i > 0 ? "," : "", t.column[i]);
  used += snprintf(text + used, sizeof text - (size_t)used, ":");
  while (tsv_next(&t)) {
    for (int i = 0; i < t.count; i++)
      used += snprintf(text + used, sizeof text - (size_t)used, "%s%s", i > 0 ? "," : " ",
                       t.fault ? "" : tsv_number(&t, i));
    used += snprintf(text + used, sizeof text - (size_t)used, ";%s", t.fault ? t.fault : "");
  }
  assert_null(tsv_error(&t));
  tsv_close(&t);
  return text;
}

TEST(separators_and_names)
{
  static const char *const cases[][2] = {
    { "h err\n1 2\n 3 \t 4 \n", "h,err: 1,2; 3,4;" },
    { "1,2\n3,4\n", ": 1,2; 3,4;" },
    { "h\terr\n1\t2\n\t4\n", "h,err: 1,2; ,4;" },
    { "h\t\terr\n1\t\t2\n", "h,err: 1,2;" },
    { "h, err\n1, 2\n\n3,\n4,5,\n", "h,err: 1,2; 3,; 4,5;" },
    { "h;err\n0,5;1,25D-3\n-,5;+1.e+2\n",
      "h,err: 0.5,1.25e-3; -.5,+1.e+2;this table has decimal commas and decimal points" },
    { "h;err\n1,000.5;2\n", "h,err: 1,000.5,2;" },
    { "0,5 0,25\n0,25 1\n", ": 0.5,0.25; 0.25,1;" },
    { "0.5, 0.25\n", ": 0.5,0.25;" },
    { "| h | e\\|r |\n| --- | :-: |\n| 1 | 2 |\n|3|4|\n", "h,e|r: 1,2; 3,4;" },
    { "h |e|\n1 2\n", "h,|e|: 1,2;" },
    { "\xef\xbb\xbf\"T [s]\",\"say \"\"x\"\"\",F (N)\r\n\"1\",\"a, b\",3\r\n", "T,say \"x\",F: 1,a, b,3;" },
    { "L2 (u),L2 (p)\n1,2\n", "L2 (u),L2 (p): 1,2;" },
    { "t [s] l [m]\n1 2\n", "t,l: 1,2;" },
    { ",h,err\n0,1,2\n", ",h,err: 0,1,2;" },
    { "   h  err\n0  1  2\n1  3  4\n", ",h,err: 0,1,2; 1,3,4;" },
    { "# a study\n# t x1 x2\n1 2 3\n", "t,x1,x2: 1,2,3;" },
    { "# command: order\n1 2\n", ": 1,2;" },
    { "% h err\n1 2\n% more\n3 4\n", "h,err: 1,2; 3,4;" },
    { "{\"h\": 1, \"err\": null, \"of\": \"a\\\"\\u00e4\\ud83d\"}\n{\"of\": \"b\", \"h\": 2}\n",
      "h,err,of: 1,,a\"\xc3\xa4?; 2,,b;" },
    { "{\"h\": 1}\n{\"g\": 2}\n", "h: 1; ;this object has a member that the first one lacks" },
    { "{\"h\": [1]}\n", ":;this line is not a JSON object of texts and numbers" },
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
    assert_string_equal(read_all(cases[i][0], TSV_ANY), cases[i][1]);
}

TEST(points_keep_each_byte_between_tabs)
{
  assert_string_equal(read_all("T\tof\n1\t \"a\" \n2\t\n", TSV_POINTS), "T,of: 1, \"a\" ; 2,;");
  assert_string_equal(read_all("1\tof\n1\tx\n", TSV_POINTS), "1,of: 1,x;");
  assert_string_equal(read_all("T;of\n1,5;\"a;b\"\n", TSV_POINTS), "T,of: 1.5,a;b;");
}

TEST(what_it_was_taken_for)
{
  struct tsv t;
  char text[80];
  assert_true(tsv_open_text(&t, "x", "a;b\n1,5;2\n"));
  assert_true(tsv_next(&t));
  assert_string_equal(tsv_number(&t, 0), "1.5");
  assert_string_equal(tsv_format_text(&t, text), "columns between semicolons, decimal commas");
  tsv_close(&t);
  assert_true(tsv_is_missing("") && tsv_is_missing("N/A") && tsv_is_missing("-") && !tsv_is_missing("nan"));
}

int main(void) { return check_run(scratch_begin, scratch_end); }
