/* a formula file: one that is taken has formulas that can be evaluated, in double and as series, which agree with
 * themselves; one that is not has a message. */
#include <stdlib.h>
#include <string.h>

#include "asymptotics/derived/evaluate.h"
#include "compare/answers/quantities.h"
#include "compare/formulas/formula_file.h"
#include "tests/fuzz/target.h"
#include "tests/support/scoped.h"

static void judge_message(const struct scallop_formula *f, const char *wrong)
{
  for (const char *c = wrong; *c; c++)
    if (*c < 0x20 || *c > 0x7e)
      fuzz_fail("%s has no series: a message with the byte %d", f->name, *c);
  if (!strstr(wrong, "character "))
    fuzz_fail("%s has no series: '%s' names no character", f->name, wrong);
}

/* Is it evaluated in less than a second? */
static bool is_small(const struct formula *read)
{
  int powers = 0;
  for (int i = 0; i < read->count; i++)
    powers += read->steps[i].operation == FORMULA_POWER;
  return powers <= 3;
}

/* value in balls of these bits; NULL or the message */
static const char *expand(struct series *value, const struct scallop_formula *f, slong length,
                          char message[FORMULA_MESSAGE])
{
  const struct ring ring = { length, 128 };
  const struct scallop_crawler c = { 1.25, 0.75, 3.5, 1.125, 9.5, 1, 0.625, &scallop_gait_quadratic };
  struct scallop_rational_crawler crawler;
  struct scallop_symbols symbols;
  SCOPED(fmpq, v0);
  scallop_rational_init(&crawler);
  scallop_rational_of(&crawler, &c);
  fmpq_set_si(v0, 3, 8);
  scallop_symbols_init(&symbols);
  scallop_symbols_set(&symbols, &crawler, SCALLOP_EXTENSION, f->setting == SCALLOP_STEADY ? NULL : v0, NULL, &ring);
  const char *wrong = scallop_formula_expand(value, f, &symbols, SCALLOP_EXTENSION, &ring, message);
  scallop_symbols_clear(&symbols);
  scallop_rational_clear(&crawler);
  return wrong;
}

/* Three terms more change none of those before. */
static void judge_series(const struct scallop_formula *f)
{
  char message[FORMULA_MESSAGE];
  SCOPED(series, few, many);
  SCOPED(arb, a, b);
  const char *wrong = expand(&few, f, 5, message);
  if (wrong) {
    judge_message(f, wrong);
    return;
  }
  if (expand(&many, f, 8, message))
    fuzz_fail("%s has a series of 5 terms and none of 8: %s", f->name, message);
  slong known = few.known < many.known ? few.known : many.known;
  for (slong k = -8; k < 8 && k < known; k++) {
    series_coefficient(a, &few, k, 128);
    series_coefficient(b, &many, k, 128);
    if (!arb_overlaps(a, b))
      fuzz_fail("%s: the coefficient of T^%ld depends on how many follow", f->name, (long)k);
  }
}

static void judge(const struct scallop_formula *f, const struct scallop_values *values)
{
  struct formula read;
  char message[FORMULA_MESSAGE];
  if (!f->name || !f->equation || !f->text || scallop_formula_text(&read, f, NULL, message))
    fuzz_fail("a formula without a name, an equation or a text that can be read was taken");
  if (quantity_is_other(f->name))
    fuzz_fail("%s is the name of another quantity", f->name);
  if (f->corrected && !formula_named(f->corrected))
    fuzz_fail("there is no %s", f->corrected);
  double value = formula_double(&read, values->of);
  if (!same_bits(value, formula_double(&read, values->of)))
    fuzz_fail("%s: %g, and then another value", f->name, value);
  if (is_small(&read))
    judge_series(f);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  const struct scallop_crawler c = { 1.3, 0.9, 3.7, 1.1, 9.7, 0.3, 0.7, &scallop_gait_sinusoidal };
  const struct scallop_values values = scallop_phase_values(&c, SCALLOP_EXTENSION, 0.25);
  struct written written;
  char *text = fuzz_text(data, size);
  if (text) {
    written_begin(&written);
    enum exit_code code = formula_file_read("claims", "x.cfg", text, quantity_is_other);
    written_end(&written);
    if (written.out_size > 0 || (written.err_size > 0) != (code != EXIT_DONE)
        || (code != EXIT_DONE && code != EXIT_USAGE))
      fuzz_fail("exit code %d, on standard output '%s', on standard error '%s'", (int)code, written.out, written.err);
    written_free(&written);
    for (int i = 0; code == EXIT_DONE && user_formula(i); i++)
      judge(user_formula(i), &values);
    formula_files_free();
  }
  free(text);
  return 0;
}
