/* The pages of help (docs/help/): options, length, and the numbers that the code uses. */
#define _GNU_SOURCE /* open_memstream */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/breakdown/breakdown.h"
#include "compare/command/commands.h"
#include "compare/points/defaults.h"
#include "compare/stress/stress.h"
#include "compare/summary/summary.h"
#include "compare/text/shipped.h"
#include "tests/support/check.h"

/* The page of a command or topic as it is printed, until the next call */
static const char *printed(const char *name)
{
  static char *text;
  size_t size;
  free(text);
  FILE *to = open_memstream(&text, &size);
  assert_non_null(to);
  help_print(to, name);
  assert_int_equal(fclose(to), 0);
  return text;
}

enum { NAME = 40, HEADS = 12 };

/* The options that a line of a page is about: in "  --m1 M, --m2 M  masses" those before the text, which can be
 * missing. */
static int options_of_line(const char *line, char names[HEADS][NAME], bool *has_text)
{
  const char *end = line + strcspn(line, "\n"), *text = end > line ? strstr(line + 2, "  ") : NULL;
  int count = 0;
  *has_text = text && text < end;
  for (const char *at = line + 2; strncmp(line, "  --", 4) == 0 && at < end && at != text && count < HEADS; at++)
    if (at[-1] == ' ' && sscanf(at, "--%39[A-Za-z0-9_-]", names[count]) == 1)
      count++;
  return count;
}

/* Is there a line about the option, and, if required, one with a text? */
static bool has_option(const char *page, const char *option, bool with_text)
{
  char names[HEADS][NAME];
  bool has_text;
  for (const char *line = page; *line; line += strcspn(line, "\n") + 1)
    for (int i = options_of_line(line, names, &has_text) - 1; i >= 0; i--)
      if (strcmp(names[i], option) == 0 && (has_text || !with_text))
        return true;
  return false;
}

/* Has a topic that the page names a text about the option? */
static bool has_reference(const char *page, const char *option)
{
  for (const struct shipped *topic = shipped_help; topic->name; topic++)
    if (strstr(page, wrong_text("scallop help %s", topic->name)) && has_option(printed(topic->name), option, true))
      return true;
  return false;
}

TEST(every_option_is_explained_within_one_reference)
{
  for (const struct command *const *c = commands; *c; c++) {
    char *page_of = strdup(printed((*c)->name));
    for (const struct option *o = (*c)->options; o->name; o++) {
      if (!has_option(page_of, o->name, false))
        fail_msg("scallop %s --help does not name --%s", (*c)->name, o->name);
      if (!has_option(page_of, o->name, true) && !has_reference(page_of, o->name))
        fail_msg("scallop %s --help names --%s, and no topic that it names explains it", (*c)->name, o->name);
    }
    free(page_of);
  }
}

static bool is_taken(const struct command *of, const char *option)
{
  bool taken = strcmp(option, "help") == 0;
  for (const struct command *const *c = commands; *c; c++)
    taken = taken || ((!of || of == *c) && option_of(*c, option));
  return taken;
}

/* The page of a command has options of this command, a topic those of any. */
TEST(no_page_has_an_option_that_is_refused)
{
  char names[HEADS][NAME];
  bool has_text;
  for (const struct shipped *page_of = shipped_help; page_of->name; page_of++)
    for (const char *line = printed(page_of->name); *line; line += strcspn(line, "\n") + 1)
      for (int i = options_of_line(line, names, &has_text) - 1; i >= 0; i--)
        if (strcmp(page_of->name, "scallop") != 0 && !is_taken(command_named(page_of->name), names[i]))
          fail_msg("scallop help %s has --%s", page_of->name, names[i]);
}

TEST(a_page_has_at_most_60_lines_of_80_columns)
{
  enum { LINES = 60, COLUMNS = 80 };
  for (const struct shipped *page_of = shipped_help; page_of->name; page_of++) {
    size_t lines = 0;
    for (const char *line = printed(page_of->name), *end; *line; line = end + 1, lines++) {
      end = line + strcspn(line, "\n");
      if (end - line > COLUMNS)
        fail_msg("scallop help %s: %td columns: %.*s", page_of->name, end - line, (int)(end - line), line);
    }
    if (lines > LINES)
      fail_msg("scallop help %s has %zu lines", page_of->name, lines);
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

/* The front page lists each command and topic with the summary at the head of its page. */
TEST(every_page_is_listed)
{
  static char list[PAGE];
  flatten(list, PAGE, printed("scallop"));
  for (const struct shipped *page_of = shipped_help; page_of->name; page_of++) {
    char item[400];
    const char *head = printed(page_of->name), *summary = strstr(head, ": ");
    assert_non_null(summary);
    snprintf(item, sizeof item, " %s %.*s ", page_of->name, (int)strcspn(summary + 2, "\n"), summary + 2);
    if (strcmp(page_of->name, "scallop") != 0 && !strstr(list, item))
      fail_msg("docs/help/scallop.txt does not have:%s", item);
  }
}

TEST(numbers_are_those_of_the_code)
{
  static const double map[] = { BREAKDOWN_MAP_TOLERANCES };
  enum { TEXT = 120, CASES = 9 };
  char stated[CASES][TEXT];
  static const int percent[] = { PAGE_PERCENTS };
  int order;
  assert_int_equal(sscanf(PAGE_TERMS, "derived_%d", &order), 1);
  const char *const pages[CASES] = { "stress",    "stress",    "stress",  "stress",  "breakdown",
                                     "breakdown", "breakdown", "summary", "accuracy" };
  snprintf(stated[0], TEXT, "error %d units", STRESS_BOUND);
  snprintf(stated[1], TEXT, "spread_rounding %d,", STRESS_ROUNDING);
  snprintf(stated[2], TEXT, "change_per_ulp 1 + 2 * %d,", STRESS_BOUND);
  snprintf(stated[3], TEXT, "1 to %d times the error", STRESS_MAX_ESTIMATE);
  snprintf(stated[4], TEXT, "the terms below T^%d are off by less than %d %% and %d %%", order, percent[0], percent[1]);
  snprintf(stated[5], TEXT, "order up to %d with the least error", STUDY_MANY);
  snprintf(stated[6], TEXT, "with --map 1e-%.0f, 1e-%.0f)", -log10(map[0]), -log10(map[1]));
  snprintf(stated[7], TEXT, "more than %d %% and %d %%", percent[0], percent[1]);
  snprintf(stated[8], TEXT, "by %d times its ulp (unit in the last place) or, if larger, %d times the change",
           STRESS_BOUND, STRESS_BOUND);
  assert_int_equal(STRESS_PERTURBED, 1 + 2 * STRESS_BOUND);
  for (int i = 0; i < CASES; i++) {
    flatten(page, PAGE, printed(pages[i]));
    if (!strstr(page, stated[i]))
      fail_msg("docs/help/%s.txt does not have: %s", pages[i], stated[i]);
  }
}
