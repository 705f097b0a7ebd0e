/* compare/text/message.h: which bytes can be shown on a terminal and in XML. */
#include "compare/text/message.h"
#include "tests/support/cases.h"

TEST(characters_that_are_shown)
{
  static const char shown[] = " |~|"
                              "\xc2\xa0|" /* the first behind the controls */
                              "\xce\xb1|\xdf\xbf|\xe0\xa0\x80|\xed\x9f\xbf|\xee\x80\x80|\xef\xbf\xbd|"
                              "\xf0\x90\x80\x80|\xf4\x8f\xbf\xbd";
  FOR_CASES (text, shown) {
    assert_int_equal(shown_character(text), strlen(text));
    assert_true(is_shown(text));
  }
  assert_true(is_shown(""));
}

TEST(what_is_not_shown)
{
  static const char other[] = "\n|\t|\x1b[31m|\x7f|\x80|\xbf|\xff|"
                              "\xc2\x9b|"                               /* a control */
                              "\xc1\xbf|\xe0\x9f\xbf|\xf0\x8f\xbf\xbf|" /* longer than need be */
                              "\xed\xa0\x80|"                           /* a surrogate */
                              "\xef\xbf\xbe|\xef\xbf\xbf|"
                              "\xf4\x90\x80\x80|"     /* beyond the last */
                              "\xf8\x88\x80\x80\x80|" /* of five bytes */
                              "\xc3|\xe2\x82|\xe2\x82z|\xf0\x9f\x98";
  FOR_CASES (text, other) {
    assert_int_equal(shown_character(text), 0);
    assert_false(is_shown(text));
  }
  assert_int_equal(shown_character(""), 0);
  assert_false(is_shown("a\x01"));
}
