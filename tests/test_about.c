/* compare/about: the passages of an about text. */
#include <stdio.h>

#include "check.h"
#include "compare/command/about.h"

static void is(struct span got, const char *wanted)
{
  if (got.length != strlen(wanted) || strncmp(got.start, wanted, got.length) != 0)
    fail_msg("'%.*s' is not '%s'", (int)got.length, got.start, wanted);
}

static void next_is(const char **text, const char *name, const char *before)
{
  struct passage p;
  assert_true(about_passage(text, &p));
  is(p.name, name);
  is(p.before, before);
}

static void ends(const char *text)
{
  struct passage p;
  assert_false(about_passage(&text, &p));
}

static void plain_text_is_one_passage_up_to_an_empty_line(void **state)
{
  (void)state;
  const char *text = "One sentence. Another\none.\nA third.\n\nA second passage.";
  next_is(&text, "", "One sentence. Another\none.\nA third.");
  next_is(&text, "", "A second passage.");
  ends(text);
}

static void names_begin_passages_behind_sentences_only(void **state)
{
  (void)state;
  const char *text = "Rows:\nunits: of it; more:\nless: of that.\n--map X Y: a grid, and\nfrom: there.\nA new one. It.\n\n"
                     "with (a. b), c: no name.";
  next_is(&text, "", "Rows:");
  next_is(&text, "units", " of it; more:");
  next_is(&text, "less", " of that.");
  next_is(&text, "--map X Y", " a grid, and\nfrom: there.");
  next_is(&text, "", "A new one. It.");
  next_is(&text, "", "with (a. b), c: no name.");
  ends(text);
}

static void a_column_begins_a_passage_within_a_line(void **state)
{
  (void)state;
  const char *text = "2: positions. 3: an extension. But: no\nmore. Or status: ok.";
  next_is(&text, "2", " positions. ");
  next_is(&text, "3", " an extension. But: no\nmore. Or status: ok.");
  ends(text);
}

static void indented_lines_are_a_list(void **state)
{
  (void)state;
  const char *text = "Kinds:\n  event   where it\n          changes. It: so.\n  best    the order.\nfroude: a number.";
  next_is(&text, "", "Kinds:");
  next_is(&text, "event", "   where it\n          changes. It: so.");
  next_is(&text, "best", "    the order.");
  next_is(&text, "froude", " a number.");
  ends(text);
}

static void columns_are_apart(void **state)
{
  (void)state;
  const char *text = "--source a: T is it. Columns: t (a; b),\nin 0.5 s; x1; status: ok. With it: more.";
  struct passage p;
  struct span column;
  assert_true(about_passage(&text, &p));
  is(p.name, "--source a");
  is(p.before, " T is it. ");
  is(p.columns, " t (a; b),\nin 0.5 s; x1; status: ok");
  is(p.after, " With it: more.");
  assert_true(about_column(&p.columns, &column));
  is(column, " t (a; b),\nin 0.5 s");
  assert_true(about_column(&p.columns, &column));
  is(column, " x1");
  assert_true(about_column(&p.columns, &column));
  is(column, " status: ok");
  assert_false(about_column(&p.columns, &column));
  ends(text);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(plain_text_is_one_passage_up_to_an_empty_line),
    cmocka_unit_test(names_begin_passages_behind_sentences_only),
    cmocka_unit_test(a_column_begins_a_passage_within_a_line),
    cmocka_unit_test(indented_lines_are_a_list),
    cmocka_unit_test(columns_are_apart),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
