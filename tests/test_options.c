/* compare/options: operands, one or many, and where they are kept. */
#include "check.h"
#include "compare/command/commands.h"
#include "compare/command/list.h"
#include "tests/said.h"

struct some_options {
  struct request request;
  const char *map[2];
};
static const struct option options[] = {
  OPTION_T(NULL),
  OPTION_TEXT("map", "X Y", "a map", NULL, some_options, map, "a name"),
  OPTION_QUIET,
  NO_MORE_OPTIONS,
};
static const struct option_rule rules[] = {
  { "map", RULE_WITHOUT, "m2 T", NULL },
  { "x quiet", RULE_WITH, "map T", "goes alone" },
  { NULL, RULE_WITH, NULL, NULL },
};
static const struct command
    ruled = { .name = "ruled", .options = options, .rules = rules, .size = sizeof(struct some_options) },
    one = { .name = "one", .operand = "FILE", .options = options, .size = sizeof(struct some_options) },
    many = { .name = "many", .operand = "SCENE.cfg...", .options = options, .size = sizeof(struct some_options) },
    none = { .name = "none", .options = options, .size = sizeof(struct some_options) };

enum { MOST = 12 };

/* Reads the words of text, which are separated by single blanks. What is refused says so on standard error. */
static bool read_words(struct arguments *a, const struct command *command, char *text, enum exit_code *code)
{
  char *arguments[MOST + 1] = { "scallop", "command" };
  int count = 2;
  for (char *word = strtok(text, " "); word && count < MOST; word = strtok(NULL, " "))
    arguments[count++] = word;
  return options_read(a, command, commands, count, arguments, code) == READ_RUN;
}

static void all_operands_are_kept_in_order(void **state)
{
  (void)state;
  struct arguments o;
  enum exit_code code = EXIT_DONE;
  char text[] = "b.cfg --T 2.5 a.cfg --map F1/F2 alpha - --quiet c.cfg";
  assert_true(read_words(&o, &many, text, &code));
  assert_int_equal(o.operand_count, 4);
  assert_string_equal(o.operands[0], "b.cfg");
  assert_string_equal(o.operands[1], "a.cfg");
  assert_string_equal(o.operands[2], "-");
  assert_string_equal(o.operands[3], "c.cfg");
  const struct some_options *read = (const void *)&o.options;
  assert_string_equal(read->map[1], "alpha");
  CHECK_EQUAL(read->request.point.crawler.T, 2.5);
  options_free(&o);
  assert_int_equal(o.operand_count, 0);
}

static void one_operand_is_one(void **state)
{
  (void)state;
  struct arguments o;
  enum exit_code code = EXIT_DONE;
  char text[] = "--quiet a.txt", two[] = "a.txt b.txt";
  assert_true(read_words(&o, &one, text, &code));
  assert_int_equal(o.operand_count, 1);
  assert_string_equal(o.operands[0], "a.txt");
  options_free(&o);
  assert_false(read_words(&o, &one, two, &code));
  assert_int_equal(code, EXIT_USAGE);
  options_free(&o);
}

static void an_operand_is_wanted_or_refused(void **state)
{
  (void)state;
  struct arguments o;
  const struct command *const wanting[] = { &one, &many };
  for (int i = 0; i < 2; i++) {
    enum exit_code code = EXIT_DONE;
    char nothing[] = "--quiet";
    assert_false(read_words(&o, wanting[i], nothing, &code));
    assert_int_equal(code, EXIT_USAGE);
    options_free(&o);
  }
  enum exit_code code = EXIT_DONE;
  char nothing[] = "--quiet", something[] = "a.txt";
  assert_true(read_words(&o, &none, nothing, &code));
  assert_int_equal(o.operand_count, 0);
  options_free(&o);
  assert_false(read_words(&o, &none, something, &code));
  assert_int_equal(code, EXIT_USAGE);
  options_free(&o);
}

static void dots_at_the_end_mean_many(void **state)
{
  (void)state;
  assert_true(takes_operands(&many));
  assert_false(takes_operands(&one));
  assert_false(takes_operands(&none));
}

static void values_are_counted(void **state)
{
  (void)state;
  assert_int_equal(option_values(option_of(&many, "map")), 2);
  assert_int_equal(option_values(option_of(&many, "T")), 1);
  assert_int_equal(option_values(option_of(&many, "quiet")), 0);
}

/* An option is refused with one that it does not go with, and without the one that it needs. */
static void rules_are_kept(void **state)
{
  (void)state;
  static const struct {
    const char *words, *message;
  } cases[] = { { "", "" },
                { "--map a b", "--map has nothing to do without --m2 T" },
                { "--map a b --T 1", "" },
                { "--quiet", "" },
                { "--quiet --T 1", "--quiet goes alone" } };
  for (int i = 0; i < 5; i++) {
    struct arguments o;
    struct said said;
    enum exit_code code = EXIT_DONE;
    char text[40];
    snprintf(text, sizeof text, "%s", cases[i].words);
    said_begin(&said);
    bool read = read_words(&o, &ruled, text, &code);
    said_end(&said);
    assert_int_equal(read, *cases[i].message == '\0');
    assert_true(read || code == EXIT_USAGE);
    assert_non_null(strstr(said.text, cases[i].message));
    options_free(&o);
  }
}

/* Each command's struct has room where it is read, begins with the request, and each of its options a name of its own. */
static void structs_have_room(void **state)
{
  (void)state;
  const struct arguments *a = NULL;
  for (const struct command *const *c = commands; *c; c++) {
    assert_true((*c)->size >= sizeof(struct request) && (*c)->size <= sizeof a->options);
    for (const struct option *o = (*c)->options; o->name; o++) {
      assert_true(o->field < (*c)->size);
      assert_ptr_equal(option_of(*c, o->name), o);
    }
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(all_operands_are_kept_in_order),
    cmocka_unit_test(one_operand_is_one),
    cmocka_unit_test(an_operand_is_wanted_or_refused),
    cmocka_unit_test(dots_at_the_end_mean_many),
    cmocka_unit_test(values_are_counted),
    cmocka_unit_test(rules_are_kept),
    cmocka_unit_test(structs_have_room),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
