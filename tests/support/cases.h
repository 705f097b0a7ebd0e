/* Cases that are short texts, all in one: FOR_CASES(text, "1+2 = 3|2*3 = 6") has text as each of them in turn.
 * Header-only. */
#ifndef SCALLOP_TESTS_SUPPORT_CASES_H
#define SCALLOP_TESTS_SUPPORT_CASES_H

#include "tests/support/check.h"

enum { LONGEST_CASE = 120 };

static inline bool next_case(const char **at, char text[LONGEST_CASE])
{
  if (!*at)
    return false;
  size_t length = strcspn(*at, "|");
  assert_true(length < LONGEST_CASE);
  memcpy(text, *at, length);
  text[length] = '\0';
  *at = (*at)[length] ? *at + length + 1 : NULL;
  return true;
}
#define FOR_CASES(text, cases) \
  for (char text[LONGEST_CASE], *once = text; once; once = NULL) \
    for (const char *at = (cases); next_case(&at, text);)

/* What is wanted, behind " = "; the text ends in front of it. */
static inline const char *wanted_of(char text[LONGEST_CASE])
{
  char *equals = strstr(text, " = ");
  assert_non_null(equals);
  *equals = '\0';
  return equals + 3;
}

#endif
