/* compare/text/message.h: which bytes can be shown on a terminal and in XML. */
#include "check.h"
#include "compare/text/message.h"

TEST(characters_that_are_shown)
{
  const struct {
    const char *text;
    size_t length;
  } shown[] = { { " ", 1 },
                { "~", 1 },
                { "\xc2\xa0", 2 }, /* the first behind the controls */
                { "\xce\xb1", 2 },
                { "\xdf\xbf", 2 },
                { "\xe0\xa0\x80", 3 },
                { "\xed\x9f\xbf", 3 },
                { "\xee\x80\x80", 3 },
                { "\xef\xbf\xbd", 3 },
                { "\xf0\x90\x80\x80", 4 },
                { "\xf4\x8f\xbf\xbd", 4 } };
  for (size_t i = 0; i < sizeof shown / sizeof *shown; i++) {
    assert_int_equal(shown_character(shown[i].text), shown[i].length);
    assert_true(is_shown(shown[i].text));
  }
  assert_true(is_shown(""));
}

TEST(what_is_not_shown)
{
  static const char *const other[] = { "\n",
                                       "\t",
                                       "\x1b[31m",
                                       "\x7f",
                                       "\x80",
                                       "\xbf",
                                       "\xff",
                                       "\xc2\x9b", /* a control */
                                       "\xc1\xbf", /* longer than need be */
                                       "\xe0\x9f\xbf",
                                       "\xf0\x8f\xbf\xbf",
                                       "\xed\xa0\x80", /* a surrogate */
                                       "\xef\xbf\xbe",
                                       "\xef\xbf\xbf",
                                       "\xf4\x90\x80\x80",     /* beyond the last */
                                       "\xf8\x88\x80\x80\x80", /* of five bytes */
                                       "\xc3",
                                       "\xe2\x82",
                                       "\xe2\x82z",
                                       "\xf0\x9f\x98" };
  for (size_t i = 0; i < sizeof other / sizeof *other; i++) {
    assert_int_equal(shown_character(other[i]), 0);
    assert_false(is_shown(other[i]));
  }
  assert_int_equal(shown_character(""), 0);
  assert_false(is_shown("a\x01"));
}
