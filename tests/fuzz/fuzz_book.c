/* A book of formulas: one that is taken has formulas that can be evaluated; one that is not has a message. */
#include <stdlib.h>
#include <string.h>

#include "compare/answers/quantities.h"
#include "compare/book/book.h"
#include "tests/fuzz/target.h"

static void judge(const struct scallop_formula *f, const struct scallop_values *values)
{
  struct formula read;
  char message[FORMULA_MESSAGE];
  if (!f->name || !f->equation || !f->text || scallop_formula_text(&read, f, NULL, message))
    fuzz_fail("a formula without a name, an equation or a text that can be read was taken");
  double value = formula_double(&read, values->of);
  if (!same_bits(value, formula_double(&read, values->of)))
    fuzz_fail("%s: %g, and then another value", f->name, value);
  bool claimed = scallop_formula_is_claimed(f, values);
  if (!f->when && !claimed)
    fuzz_fail("%s has no condition that could fail", f->name);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  const struct scallop_crawler c = { 1.3, 0.9, 3.7, 1.1, 9.7, 0.3, 0.7, &scallop_gait_sinusoidal };
  const struct scallop_values values = scallop_phase_values(&c, SCALLOP_EXTENSION, 0.25);
  struct written written;
  char *text = fuzz_text(data, size);
  if (text && !strstr(text, "@include")) {
    written_begin(&written);
    enum exit_code code = book_read_text("claims", "x.cfg", text, quantity_is_other);
    written_end(&written);
    if (written.out_size > 0 || (written.err_size > 0) != (code != EXIT_DONE) || (code != EXIT_DONE && code != EXIT_USAGE))
      fuzz_fail("exit code %d, on standard output '%s', on standard error '%s'", (int)code, written.out, written.err);
    written_free(&written);
    for (int i = 0; code == EXIT_DONE && book_formula(i); i++)
      judge(book_formula(i), &values);
    books_forget();
  }
  free(text);
  return 0;
}
