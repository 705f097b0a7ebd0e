#include "compare/text/values.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/digits.h"
#include "compare/text/message.h"

bool read_number(const char *text, double *value)
{
  char *end;
  if (strnlen(text, NUMBER_LENGTH + 1) > NUMBER_LENGTH)
    return false;
  if (digits_read(text, value))
    return true;
  if (*text == '\0' || isspace((unsigned char)*text))
    return false;
  errno = 0;
  double x = strtod(text, &end);
  if (*end != '\0' || !isfinite(x) || (errno == ERANGE && !isnormal(x)))
    return false;
  *value = x;
  return true;
}

bool json_takes_number(const char *text)
{
  const char *digits = text + (*text == '-'), *point = digits + strspn(digits, "0123456789");
  bool begins = isdigit((unsigned char)*digits) && (*digits != '0' || point == digits + 1);
  double x;
  return begins && (*point != '.' || isdigit((unsigned char)point[1])) && !strpbrk(text, "xX") && read_number(text, &x);
}

bool read_count(const char *text, long low, long high, long *value)
{
  char *end;
  errno = 0;
  long x = strtol(text, &end, 10);
  if (*text == '\0' || isspace((unsigned char)*text) || *end != '\0' || errno != 0 || x < low || x > high)
    return false;
  *value = x;
  return true;
}

bool next_item(char *item, size_t size, const char **list)
{
  if (!*list)
    return false;
  const char *begin = *list + strspn(*list, " "), *end = begin, *stop;
  for (int nested = 0; *end && (*end != ',' || nested > 0); end++)
    nested += *end == '(' ? 1 : *end == ')' && nested > 0 ? -1 : 0;
  for (stop = end; stop > begin && stop[-1] == ' ';)
    stop--;
  snprintf(item, size, "%.*s", (int)(stop - begin), begin);
  *list = *end ? end + 1 : NULL;
  return true;
}

const char *not_allowed(const char *text, const char *allowed)
{
  return wrong_text("'%.80s' is not allowed here: it takes %.200s", text, allowed);
}

const char *no_number(const char *text, const char *allowed)
{
  char *end;
  size_t length = strlen(text);
  bool blank = length > 0 && (isspace((unsigned char)text[0]) || isspace((unsigned char)text[length - 1]));
  errno = 0;
  double x = strtod(text, &end);
  bool beyond = !blank && *end == '\0' && errno == ERANGE;
  return wrong_text("'%.80s' is not allowed here: it takes %.150s%s", text, allowed,
                    blank                    ? ", without blanks around it"
                    : length > NUMBER_LENGTH ? "; this one has more than 10100 characters"
                    : beyond && fabs(x) < 1  ? "; this one is too small: below 2.2e-308 doubles lose digits"
                    : beyond                 ? "; this one is too large: no double is above 1.8e308"
                                             : "");
}
