/* The numbers in the texts of --help (docs/help/) are those that the code uses. */
#include <stdio.h>

#include "compare/breakdown/breakdown.h"
#include "compare/command/commands.h"
#include "compare/points/defaults.h"
#include "compare/stress/stress.h"
#include "compare/summary/summary.h"
#include "compare/text/shipped.h"
#include "tests/support/check.h"

/* The name of the option that a line of a page is about: "  --NAME ...". NULL: the line is about something else. */
static const char *option_of_line(const char *line, char name[40])
{
  bool is_one = sscanf(line, "  --%39[A-Za-z0-9_-]", name) == 1 && strncmp(line, "  --", 4) == 0;
  return is_one ? name : NULL;
}

/* A line for each option, in their order, and none for another */
TEST(every_option_has_a_line)
{
  for (const struct command *const *c = commands; *c; c++) {
    const struct option *o = (*c)->options;
    char name[40];
    const char *line = shipped_text(shipped_help, (*c)->name);
    assert_non_null(line);
    line = strstr(line, "\nOptions (defaults in brackets):\n");
    assert_non_null(line);
    for (line = strchr(line + 1, '\n'); line; line = strchr(line + 1, '\n'))
      if (option_of_line(line + 1, name)) {
        assert_string_equal(name, o->name ? o->name : "help");
        o += o->name != NULL;
      }
    assert_null(o->name);
  }
}

/* Copies a text, with one blank for any number of blanks and ends of lines. */
static void flatten(char *to, size_t size, const char *text)
{
  size_t used = 0;
  for (; *text && used + 1 < size; text++) {
    char c = *text == '\n' ? ' ' : *text;
    if (c != ' ' || (used > 0 && to[used - 1] != ' '))
      to[used++] = c;
  }
  to[used] = '\0';
}

enum { PAGE = 1 << 14 };
static char page[PAGE];

/* The list of commands says of each what its page begins with. */
TEST(every_command_is_listed)
{
  static char list[PAGE];
  flatten(list, PAGE, shipped_text(shipped_help, "scallop"));
  for (const struct command *const *c = commands; *c; c++) {
    char item[400];
    flatten(page, PAGE, shipped_text(shipped_help, (*c)->name));
    char *summary = strstr(page, "[options]: ");
    assert_non_null(summary);
    summary += strlen("[options]: ");
    summary[strcspn(summary, ".")] = '\0';
    snprintf(item, sizeof item, " %s %s ", (*c)->name, summary);
    if (!strstr(list, item))
      fail_msg("docs/help/scallop.txt does not have:%s", item);
  }
}

TEST(numbers_are_those_of_the_code)
{
  static const double map[] = { BREAKDOWN_MAP_TOLERANCES };
  enum { TEXT = 80, CASES = 8 };
  char said[CASES][TEXT];
  static const int percent[] = { PAGE_PERCENTS };
  int order;
  assert_int_equal(sscanf(PAGE_TERMS, "derived_%d", &order), 1);
  const char *const commands_of[CASES] = { "stress",    "stress",    "stress",  "stress",
                                           "breakdown", "breakdown", "summary", "breakdown" };
  snprintf(said[0], TEXT, "Promised: at most %d units", STRESS_PROMISE);
  snprintf(said[1], TEXT, "promised: %d (each operation", STRESS_ROUNDING);
  snprintf(said[2], TEXT, "promised: %d + 2 * %d", STRESS_PERTURBED - 2 * STRESS_PROMISE, STRESS_PROMISE);
  snprintf(said[3], TEXT, "from 1 to %d,", STRESS_GENEROUS);
  snprintf(said[4], TEXT, "the terms below T^%d, are off", order);
  snprintf(said[5], TEXT, "up to %d, with the least error", STUDY_MANY);
  snprintf(said[6], TEXT, "more than %d %% and %d %%", percent[0], percent[1]);
  snprintf(said[7], TEXT, "for 1e-%.0f and 1e-%.0f", -log10(map[0]), -log10(map[1]));
  for (int i = 0; i < CASES; i++) {
    flatten(page, PAGE, shipped_text(shipped_help, commands_of[i]));
    if (!strstr(page, said[i]))
      fail_msg("docs/help/%s.txt does not have: %s", commands_of[i], said[i]);
  }
}
