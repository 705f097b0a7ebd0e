/* compare/options: operands, one or many, and where they are kept. */
#include "check.h"
#include "compare/command/compare.h"
#include "compare/command/option_table.h"

static const char *const accepts[] = { "T", "map", "quiet", NULL };
static const struct command one = { .name = "one", .operand = "FILE", .accepts = accepts, .about = "" };
static const struct command many = { .name = "many", .operand = "SCENE.cfg...", .accepts = accepts, .about = "" };
static const struct command none = { .name = "none", .accepts = accepts, .about = "" };

enum { MOST = 12 };

/* Reads the words of text, which are separated by single blanks. What is refused says so on standard error. */
static bool read_words(struct options *o, const struct command *command, char *text, int *code)
{
  char *arguments[MOST + 1] = { "scallop", "command" };
  int count = 2;
  for (char *word = strtok(text, " "); word && count < MOST; word = strtok(NULL, " "))
    arguments[count++] = word;
  return options_read(o, command, count, arguments, code);
}

static void all_operands_are_kept_in_order(void **state)
{
  (void)state;
  struct options o;
  int code = -1;
  char text[] = "b.cfg --T 2.5 a.cfg --map F1/F2 alpha - --quiet c.cfg";
  assert_true(read_words(&o, &many, text, &code));
  assert_int_equal(o.operand_count, 4);
  assert_string_equal(o.operands[0], "b.cfg");
  assert_string_equal(o.operands[1], "a.cfg");
  assert_string_equal(o.operands[2], "-");
  assert_string_equal(o.operands[3], "c.cfg");
  assert_ptr_equal(o.operand, o.operands[0]);
  assert_string_equal(o.map[1], "alpha");
  CHECK_EQUAL(o.point.crawler.T, 2.5);
  options_free(&o);
  assert_int_equal(o.operand_count, 0);
}

static void one_operand_is_one(void **state)
{
  (void)state;
  struct options o;
  int code = -1;
  char text[] = "--quiet a.txt", two[] = "a.txt b.txt";
  assert_true(read_words(&o, &one, text, &code));
  assert_int_equal(o.operand_count, 1);
  assert_string_equal(o.operand, "a.txt");
  options_free(&o);
  assert_false(read_words(&o, &one, two, &code));
  assert_int_equal(code, EXIT_USAGE);
  options_free(&o);
}

static void an_operand_is_wanted_or_refused(void **state)
{
  (void)state;
  struct options o;
  const struct command *const wanting[] = { &one, &many };
  for (int i = 0; i < 2; i++) {
    int code = -1;
    char nothing[] = "--quiet";
    assert_false(read_words(&o, wanting[i], nothing, &code));
    assert_int_equal(code, EXIT_USAGE);
    options_free(&o);
  }
  int code = -1;
  char nothing[] = "--quiet", something[] = "a.txt";
  assert_true(read_words(&o, &none, nothing, &code));
  assert_null(o.operand);
  options_free(&o);
  assert_false(read_words(&o, &none, something, &code));
  assert_int_equal(code, EXIT_USAGE);
  options_free(&o);
}

static void dots_at_the_end_mean_many(void **state)
{
  (void)state;
  assert_true(many_operands(&many));
  assert_false(many_operands(&one));
  assert_false(many_operands(&none));
}

static void values_are_counted(void **state)
{
  (void)state;
  assert_int_equal(option_value_count(describe_option("map", &many)), 2);
  assert_int_equal(option_value_count(describe_option("T", &many)), 1);
  assert_int_equal(option_value_count(describe_option("quiet", &many)), 0);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(all_operands_are_kept_in_order),
    cmocka_unit_test(one_operand_is_one),
    cmocka_unit_test(an_operand_is_wanted_or_refused),
    cmocka_unit_test(dots_at_the_end_mean_many),
    cmocka_unit_test(values_are_counted),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
