/* The reader of formula files, beside the table that the build makes of the paper's formula file by other means
 * (scripts/dev/formulas.awk). */
#include "compare/answers/quantities.h"
#include "compare/formulas/formula_file.h"
#include "tests/support/said.h"

#include <string.h>

static void check_texts(const char *a, const char *b)
{
  assert_true(!a == !b);
  if (a)
    assert_string_equal(a, b);
}

static void check_same(const struct scallop_formula *read, const struct scallop_formula *built)
{
  check_texts(read->name, built->name);
  check_texts(read->equation, built->equation);
  check_texts(read->text, built->text);
  check_texts(read->corrected, built->corrected);
  assert_int_equal(read->setting, built->setting);
  assert_int_equal(read->quantity, built->quantity);
  assert_int_equal(read->remainder, built->remainder);
  assert_int_equal(read->turns, built->turns);
  const struct scallop_part none = { NULL, NULL }, *part = built->parts ? built->parts : &none;
  for (int i = 0; i == 0 || part[i - 1].name; i++) {
    check_texts(read->parts[i].name, part[i].name);
    check_texts(read->parts[i].text, part[i].text);
  }
  assert_true(!read->when == !built->when);
  for (int i = 0; read->when && built->when && (i == 0 || built->when[i - 1]); i++)
    check_texts(read->when[i], built->when[i]);
}

TEST(the_papers_file_in_both_readers)
{
  const struct scallop_formula *const lists[] = { scallop_published, scallop_corrected };
  int n = 0;
  assert_int_equal(formula_file_read("test", "asymptotics/published/paper.cfg", NULL, quantity_is_other), EXIT_DONE);
  assert_int_equal(formula_file_read("test", "asymptotics/published/paper.cfg", NULL, quantity_is_other),
                   EXIT_DONE); /* once */
  for (int i = 0; i < 2; i++)
    for (const struct scallop_formula *f = lists[i]; f->name; f++, n++) {
      assert_non_null(user_formula(n));
      check_same(user_formula(n), f);
      assert_ptr_equal(formula_named(f->name), user_formula(n)); /* before the one that comes with the tool */
    }
  assert_null(user_formula(n));
  formula_files_free();
  assert_ptr_equal(formula_named("eq14_dT"), scallop_formula_named("eq14_dT"));
  assert_null(user_formula(0));
}

TEST(places_of_formulas)
{
  static const char formulas[] =
      "formulas = ( { name = \"eq14_dT\"; of = \"dT\"; text = \"T\"; }, { name = \"b\"; of = "
      "\"dx2\"; text = \"t1\"; } );";
  int listed = 0, all = 0, published = 0, corrected = 0, conditional = 0;
  for (const struct scallop_formula *f = scallop_published; f->name; f++, published++)
    conditional += f->when != NULL;
  for (const struct scallop_formula *f = scallop_corrected; f->name; f++)
    corrected++;
  assert_int_equal(formula_file_read("test", "a text", formulas, quantity_is_other), EXIT_DONE);
  while (listed_formula(listed))
    listed++;
  while (formula_at(all))
    all++;
  assert_int_equal(listed, 2 + published - conditional);
  assert_int_equal(all, 2 + published + corrected);
  assert_int_equal(formula_at(1)->quantity, SCALLOP_FRONT_AT_END);
  assert_true(formula_takes(formula_at(1), SCALLOP_SYMBOL_t1));
  assert_false(formula_takes(formula_at(0), SCALLOP_SYMBOL_t1));
  assert_string_equal(listed_formula(2)->name, "eq12_v_switch");
}

TEST(sides_of_conditions)
{
  struct scallop_sides sides;
  char long_one[SCALLOP_CONDITION + 1];
  assert_int_equal(scallop_condition_split(&sides, "m1 < 2*F2"), '<');
  assert_string_equal(sides.left, "m1 ");
  assert_string_equal(sides.right, "     2*F2");
  memset(long_one, ' ', sizeof long_one);
  long_one[1] = '=';
  long_one[SCALLOP_CONDITION] = '\0';
  assert_int_equal(scallop_condition_split(&sides, long_one), '\0');
  long_one[SCALLOP_CONDITION - 1] = '\0';
  assert_int_equal(scallop_condition_split(&sides, long_one), '=');
  assert_int_equal(scallop_condition_split(&sides, "m1"), '\0');
}

static bool is_dT(const char *name) { return strcmp(name, "dT") == 0; }

/* What is refused leaves nothing that could be used after its file is closed, and names are asked about. */
TEST(formula_files_forgotten_and_read_again)
{
  static const char good[] = "formulas = ( { name = \"a\"; of = \"dT\"; text = \"T\"; } );",
                    taken[] = "formulas = ( { name = \"a\"; of = \"dT\"; text = \"T\"; },\n"
                              "{ name = \"dT\"; of = \"t1\"; text = \"1\"; } );";
  struct said said;
  formula_files_free();
  for (int i = 0; i < 3; i++) {
    assert_int_equal(formula_file_read("test", "x.cfg", good, NULL), EXIT_DONE);
    assert_int_equal(formula_read_once(formula_named("a"))->count, 1);
    formula_files_free();
    said_begin(&said);
    enum exit_code code = formula_file_read("test", "x.cfg", taken, is_dT);
    assert_non_null(strstr(said_end(&said), "x.cfg:2: 'dT' cannot be the name of a formula"));
    assert_int_equal(code, EXIT_USAGE);
    formula_files_free();
    assert_null(user_formula(0));
  }
}
