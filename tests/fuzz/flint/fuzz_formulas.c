/* A formula file: one that is taken has formulas that can be read, and leads to others that there are; one that is not
 * has a message. What formulas are worth: fuzz_formula.c, as series: fuzz_formula_series.c, fuzz_claims.c. */
#include <stdlib.h>

#include "asymptotics/published/read.h"
#include "compare/answers/quantities.h"
#include "compare/formulas/formula_file.h"
#include "tests/fuzz/target.h"

static void judge(const struct scallop_formula *f)
{
  struct formula read;
  char message[FORMULA_MESSAGE];
  if (!f->name || !f->equation || !f->text || scallop_formula_text(&read, f, NULL, message))
    fuzz_fail("a formula without a name, an equation or a text that can be read was taken");
  if (quantity_is_other(f->name))
    fuzz_fail("%s is the name of another quantity", f->name);
  if (f->corrected && !formula_named(f->corrected))
    fuzz_fail("there is no %s", f->corrected);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  struct written written;
  char *text = fuzz_text(data, size);
  written_begin(&written);
  enum exit_code code = formula_file_read("claims", "x.cfg", text, quantity_is_other);
  written_end_read(&written, code);
  for (int i = 0; code == EXIT_DONE && user_formula(i); i++)
    judge(user_formula(i));
  formula_files_free();
  free(text);
  return 0;
}
