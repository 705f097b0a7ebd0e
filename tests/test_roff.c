/* compare/roff: text that roff does not take for anything else. */
#include <stdlib.h>

#include "check.h"
#include "compare/command/roff.h"

static char *written;
static size_t size;

static struct roff begin(void) { return (struct roff){ .to = open_memstream(&written, &size) }; }

static void is(struct roff *roff, const char *wanted)
{
  roff_break(roff);
  assert_int_equal(fclose(roff->to), 0);
  assert_string_equal(written, wanted);
  free(written);
}

static void text_becomes(const char *text, const char *wanted)
{
  struct roff roff = begin();
  roff_text(&roff, text);
  is(&roff, wanted);
}

static void nothing_is_a_request(void **state)
{
  (void)state;
  text_becomes(".rows 'x' a\\b", "\\&.rows \\(aqx\\(aq a\\(rsb\n");
  text_becomes("T^2 ~ \"a\"", "T\\(ha2 \\(ti \\(dqa\\(dq\n");
  struct roff roff = begin();
  roff_macro(&roff, "SH", "A \"B\" -\\");
  roff_line(&roff, ".rows  'x'");
  is(&roff, ".SH \"A \\(dqB\\(dq \\-\\(rs\"\n\\&.rows  \\(aqx\\(aq\n");
}

static void options_and_quotes_are_bold(void **state)
{
  (void)state;
  text_becomes(
      "(--tol D), x2 - x1; --check-only: -o, stick-slip 1e-3 -> --",
      "(\\fB\\-\\-tol\\fR D), x2 \\- x1; \\fB\\-\\-check\\-only\\fR: \\fB\\-o\\fR, stick\\-slip\n1e\\-3 \\-> \\-\\-\n");
  text_becomes("as `scallop --help` and\n`a`", "as \\fBscallop \\-\\-help\\fR and \\fBa\\fR\n");
}

static void a_sentence_begins_a_line(void **state)
{
  (void)state;
  text_becomes("One. Two (so it is.) --three is. four, C1,C2,... Five",
               "One.\nTwo (so it is.)\n\\fB\\-\\-three\\fR is. four, C1,C2,... Five\n");
}

static void lines_are_filled(void **state)
{
  (void)state;
  char seventy_nine[80], text[200], wanted[200];
  memset(seventy_nine, 'x', 79);
  seventy_nine[79] = '\0';
  snprintf(text, sizeof text, "%s  y\n %.70s. no-sentence", seventy_nine, seventy_nine);
  snprintf(wanted, sizeof wanted, "%s\ny %.70s.\\&\nno\\-sentence\n", seventy_nine, seventy_nine);
  text_becomes(text, wanted);
}

static void fonts_join_what_is_around(void **state)
{
  (void)state;
  struct roff roff = begin();
  roff_font(&roff, "", 'B', "scallop-steady", "(1),");
  roff_font(&roff, "[", 'I', "options", "]");
  is(&roff, "\\fBscallop\\-steady\\fR(1), [\\fIoptions\\fR]\n");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(nothing_is_a_request),      cmocka_unit_test(options_and_quotes_are_bold),
    cmocka_unit_test(a_sentence_begins_a_line),  cmocka_unit_test(lines_are_filled),
    cmocka_unit_test(fonts_join_what_is_around),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
