/* A formula that was read and owns what it needs: the public face of read.c. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/published/read.h"

_Static_assert((int)SCALLOP_FORMULA_MESSAGE == (int)FORMULA_MESSAGE,
               "a message of the public face is one of formula.h");

/* Appends a copy of the text, which the operations then refer to. */
static void keep_text(struct formula *operations, char **end, const char *text)
{
  size_t size = strlen(text) + 1;
  for (int i = 0; i < operations->count; i++)
    if (operations->steps[i].text == text)
      operations->steps[i].text = *end;
  memcpy(*end, text, size);
  *end += size;
}

static struct scallop_read_formula *make(const struct formula *operations, const struct scallop_formula *formula)
{
  size_t size = strlen(formula->text) + 1;
  for (const struct scallop_part *p = formula->parts; p && p->name; p++)
    size += strlen(p->text) + 1;
  struct scallop_read_formula *made = malloc(sizeof *made + size);
  if (made) {
    char *end = made->texts;
    made->operations = *operations;
    made->formula = (struct scallop_formula){ .setting = formula->setting };
    keep_text(&made->operations, &end, formula->text);
    for (const struct scallop_part *p = formula->parts; p && p->name; p++)
      keep_text(&made->operations, &end, p->text);
  }
  return made;
}

static bool takes(const struct formula *operations, enum scallop_symbol symbol)
{
  int places[FORMULA_STEPS], count = formula_places(operations, places);
  bool found = false;
  for (int i = 0; i < count; i++)
    found = found || places[i] == (int)symbol;
  return found;
}

struct scallop_read_formula *scallop_formula_read(const struct scallop_formula *formula,
                                                  char message[SCALLOP_FORMULA_MESSAGE])
{
  static const enum scallop_symbol of_phases[] = { SCALLOP_SYMBOL_v0, SCALLOP_SYMBOL_t1, SCALLOP_SYMBOL_dT,
                                                   SCALLOP_SYMBOL_x_switch };
  struct formula operations;
  if (scallop_formula_text(&operations, formula, NULL, message))
    return NULL;
  for (size_t i = 0; formula->setting == SCALLOP_STEADY && i < sizeof of_phases / sizeof *of_phases; i++)
    if (takes(&operations, of_phases[i])) {
      snprintf(message, SCALLOP_FORMULA_MESSAGE, "the steady state has no %s", scallop_symbol_names[of_phases[i]]);
      return NULL;
    }
  struct scallop_read_formula *made = make(&operations, formula);
  if (!made)                                                          /* GCOVR_EXCL_LINE: no memory */
    snprintf(message, SCALLOP_FORMULA_MESSAGE, "there is no memory"); /* GCOVR_EXCL_LINE */
  return made;
}

void scallop_formula_free(struct scallop_read_formula *read) { free(read); }

bool scallop_formula_takes(const struct scallop_read_formula *read, enum scallop_symbol symbol)
{
  return takes(&read->operations, symbol);
}

double scallop_formula_double(const struct scallop_read_formula *read, const struct scallop_crawler *crawler,
                              enum scallop_phase_kind kind, double v0, double t1, double dT, double x_switch)
{
  return scallop_formula_at(&read->operations, &read->formula, crawler, kind, v0, t1, dT, x_switch);
}
