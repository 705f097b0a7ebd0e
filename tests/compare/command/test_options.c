/* compare/options: operands, one or many, and where they are kept. */
#include "compare/command/commands.h"
#include "tests/support/said.h"

struct some_options {
  struct request request;
  const char *map[2];
};
static const struct option options[] = {
  OPTION_POINT("T"),
  OPTION("map", read_text, OPTION_FIELD(some_options, map), .values = 2, .allowed = "a name"),
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

/* Taken with these operands, in order, or refused with this on standard error */
TEST(operands_and_rules)
{
  static const struct {
    const struct command *command;
    const char *words, *operands, *message;
  } cases[] = { { &many, "b.cfg --T 2.5 a.cfg --map F1/F2 alpha - --quiet c.cfg", " b.cfg a.cfg - c.cfg", NULL },
                { &many, "--quiet", NULL, "" },
                { &one, "--quiet a.txt", " a.txt", NULL },
                { &one, "a.txt b.txt", NULL, "" },
                { &one, "--quiet", NULL, "" },
                { &none, "--quiet", "", NULL },
                { &none, "a.txt", NULL, "" },
                { &ruled, "", "", NULL },
                { &ruled, "--map a b", NULL, "--map has nothing to do without --m2 T" },
                { &ruled, "--map a b --T 1", "", NULL },
                { &ruled, "--quiet", "", NULL },
                { &ruled, "--quiet --T 1", NULL, "--quiet goes alone" } };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    struct arguments o;
    struct said said;
    enum exit_code code = EXIT_DONE;
    char text[80], operands[80] = "";
    snprintf(text, sizeof text, "%s", cases[i].words);
    said_begin(&said);
    bool read = read_words(&o, cases[i].command, text, &code);
    said_end(&said);
    assert_int_equal(read, !cases[i].message);
    assert_true(read || code == EXIT_USAGE);
    if (!read && cases[i].message)
      assert_non_null(strstr(said.text, cases[i].message));
    for (int k = 0, used = 0; read && k < o.operand_count; k++)
      used += snprintf(operands + used, sizeof operands - (size_t)used, " %s", o.operands[k]);
    if (read)
      assert_string_equal(operands, cases[i].operands);
    options_free(&o);
    assert_int_equal(o.operand_count, 0);
  }
}

TEST(values_are_read)
{
  struct arguments o;
  enum exit_code code = EXIT_DONE;
  char text[] = "--T 2.5 a.cfg --map F1/F2 alpha";
  assert_true(read_words(&o, &many, text, &code));
  const struct some_options *read = (const void *)&o.options;
  assert_string_equal(read->map[1], "alpha");
  CHECK_EQUAL(read->request.point.crawler.T, 2.5);
  assert_int_equal(option_values(option_of(&many, "map")), 2);
  assert_int_equal(option_values(option_of(&many, "quiet")), 0);
  options_free(&o);
}

/* Each command's struct has room where it is read, begins with the request, and each of its options a name of its
 * own. */
TEST(structs_have_room)
{
  const struct arguments *a = NULL;
  for (const struct command *const *c = commands; *c; c++) {
    assert_true((*c)->size >= sizeof(struct request) && (*c)->size <= sizeof a->options);
    for (const struct option *o = (*c)->options; o->name; o++) {
      assert_true(o->field < (*c)->size);
      assert_ptr_equal(option_of(*c, o->name), o);
    }
  }
}
