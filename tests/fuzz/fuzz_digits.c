/* Numbers as text, both ways, against C's library: eight bytes as a double, and all bytes as text. */
#include "compare/text/digits.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/fuzz/target.h"

/* As "%.*g" with 15, 16 and 17 digits */
static void write_plainly(char *text, double x)
{
  for (int precision = 15; precision <= 17; precision++) {
    snprintf(text, DIGITS_TEXT, isnan(x) ? "nan" : "%.*g", precision, x);
    if (strtod(text, NULL) == x)
      return;
  }
}

static void write_and_read(double x)
{
  char text[NUMBER_TEXT], plain[NUMBER_TEXT], quick[NUMBER_TEXT], short_text[NUMBER_TEXT], wanted[NUMBER_TEXT];
  number_text(text, x, 0);
  write_plainly(plain, x);
  if (strcmp(text, plain) != 0 || (digits_write_quickly(quick, x, 0) && strcmp(quick, plain) != 0))
    fuzz_fail("%a is written '%s', plainly '%s'", x, text, plain);
  double back = NAN, quick_back;
  if (isnan(x) ? strcmp(text, "nan") != 0 : !same_bits(strtod(text, NULL), x))
    fuzz_fail("%a is written '%s', which reads back as %a", x, text, strtod(text, NULL));
  if (isfinite(x) && fpclassify(x) != FP_SUBNORMAL && (!read_number(text, &back) || !same_bits(back, x)))
    fuzz_fail("%a is written '%s', which is read as %a", x, text, back);
  if (digits_read(text, &quick_back) && !same_bits(quick_back, x))
    fuzz_fail("'%s' is read as %a, not %a", text, quick_back, x);
  for (int digits = 1; digits <= 17; digits++) {
    number_text(short_text, x, digits);
    snprintf(wanted, sizeof wanted, "%.*g", digits, x);
    if (strcmp(short_text, isnan(x) ? "nan" : wanted) != 0)
      fuzz_fail("%a with %d digits is '%s', not '%s'", x, digits, short_text, wanted);
  }
}

/* The quick reader takes nothing that C's does not, and reads the same; what it leaves it does not touch. The whole
 * reader takes all that C's does, but for words, and digits that are lost below the normal range. */
static void try_text(const char *text)
{
  char *end;
  const double untouched = 0x1.23456789abcdep-7, wanted = strtod(text, &end);
  bool number = end != text && *end == '\0' && !isspace((unsigned char)*text);
  double quick = untouched, got = NAN;
  if (digits_read(text, &quick) ? !number || !same_bits(quick, wanted) : !same_bits(quick, untouched))
    fuzz_fail("'%s' is read as %a, not %a", text, quick, wanted);
  if (read_number(text, &got) ? !number || !isfinite(got) || !same_bits(got, wanted) : number && isnormal(wanted))
    fuzz_fail("'%s' is read as %a in the end, not %a", text, got, wanted);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  char *text = fuzz_text(data, size);
  try_text(text);
  free(text);
  for (double x; size >= sizeof x; data += sizeof x, size -= sizeof x) {
    memcpy(&x, data, sizeof x);
    write_and_read(x);
  }
  return 0;
}
