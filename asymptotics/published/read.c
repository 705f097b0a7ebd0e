/* Formulas and conditions: read from text, evaluated in double; and the public type of a formula, with copies of its
 * texts. */
#include "asymptotics/published/read.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const struct scallop_formula *scallop_formula_named(const char *name)
{
  const struct scallop_formula *const lists[] = { scallop_published, scallop_corrected };
  for (int i = 0; i < 2; i++)
    for (const struct scallop_formula *f = lists[i]; f->name; f++)
      if (strcmp(f->name, name) == 0)
        return f;
  return NULL;
}

struct formula_request {
  const struct scallop_formula *formula;
  nearest_name *nearest;
};

static int place_of(void *context, const char *name)
{
  (void)context;
  for (int i = 0; i < SCALLOP_SYMBOLS; i++)
    if (strcmp(scallop_symbol_names[i], name) == 0)
      return i;
  return -1;
}

static const char *part_of(void *context, const char *name)
{
  const struct formula_request *request = context;
  for (const struct scallop_part *p = request->formula->parts; p && p->name; p++)
    if (strcmp(p->name, name) == 0)
      return p->text;
  return NULL;
}

static const char *nearest_to(void *context, const char *name, const char *const *functions)
{
  enum { MOST_PARTS = 32 };
  const struct formula_request *request = context;
  const char *names[SCALLOP_SYMBOLS + MOST_PARTS + 1] = { NULL };
  memcpy(names, scallop_symbol_names, sizeof scallop_symbol_names);
  for (int i = 0; request->formula->parts && request->formula->parts[i].name && i < MOST_PARTS; i++)
    names[SCALLOP_SYMBOLS + i] = request->formula->parts[i].name;
  return request->nearest ? request->nearest(name, functions ? functions : names) : NULL;
}

static const char *read_text(struct formula *read, const char *text, const struct scallop_formula *formula,
                             nearest_name *nearest, char message[FORMULA_MESSAGE])
{
  struct formula_request request = { formula, nearest };
  const struct formula_names names = { place_of, nearest_to, part_of, &request };
  return formula_read(read, text, &names, message);
}

const char *scallop_formula_text(struct formula *read, const struct scallop_formula *formula, nearest_name *nearest,
                                 char message[FORMULA_MESSAGE])
{
  return read_text(read, formula->text, formula, nearest, message);
}

bool scallop_formula_is_exchanged(const struct scallop_formula *formula, enum scallop_phase_kind kind)
{
  return kind == SCALLOP_CONTRACTION
         && (formula->setting == SCALLOP_AT_REST_START || formula->setting == SCALLOP_MOVING_EXTENSION);
}

double scallop_formula_value(const struct formula *read, const struct scallop_formula *formula,
                             enum scallop_phase_kind kind, const struct scallop_values *values)
{
  struct scallop_values exchanged;
  bool exchange = scallop_formula_is_exchanged(formula, kind);
  if (exchange)
    exchanged = scallop_exchanged(values);
  return formula_double(read, exchange ? exchanged.of : values->of);
}

double scallop_formula_at(const struct formula *read, const struct scallop_formula *formula,
                          const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0, double t1,
                          double dT, double x_switch)
{
  bool steady = formula->setting == SCALLOP_STEADY;
  struct scallop_values values = steady ? scallop_steady_values(crawler) : scallop_phase_values(crawler, kind, v0);
  values.of[SCALLOP_SYMBOL_t1] = t1;
  values.of[SCALLOP_SYMBOL_dT] = dT;
  values.of[SCALLOP_SYMBOL_x_switch] = x_switch;
  return scallop_formula_value(read, formula, kind, &values);
}

double scallop_published_value(const struct scallop_formula *formula, const struct scallop_crawler *crawler,
                               enum scallop_phase_kind kind, double v0, double t1, double dT, double x_switch)
{
  struct formula read;
  char message[FORMULA_MESSAGE];
  bool is_read = !scallop_formula_text(&read, formula, NULL, message);
  return is_read ? scallop_formula_at(&read, formula, crawler, kind, v0, t1, dT, x_switch) : NAN;
}

char scallop_condition_split(struct scallop_sides *sides, const char *condition)
{
  int length = (int)strcspn(condition, "<>=");
  if (condition[length] == '\0' || strlen(condition) >= SCALLOP_CONDITION)
    return '\0';
  snprintf(sides->left, sizeof sides->left, "%.*s", length, condition);
  snprintf(sides->right, sizeof sides->right, "%*s%s", length + 1, "", condition + length + 1);
  return condition[length];
}

bool scallop_condition_is_equal_forces(const char *condition)
{
  char left[3], right[3], more;
  return sscanf(condition, " %2s = %2s %c", left, right, &more) == 2
         && ((strcmp(left, "F1") == 0 && strcmp(right, "F2") == 0)
             || (strcmp(left, "F2") == 0 && strcmp(right, "F1") == 0));
}

/* Returns the value of a side, nan if it cannot be read. */
static double side_in_double(const char *text, const struct scallop_formula *formula,
                             const struct scallop_values *values)
{
  struct formula side;
  char message[FORMULA_MESSAGE];
  return read_text(&side, text, formula, NULL, message) ? NAN : formula_double(&side, values->of);
}

bool scallop_formula_is_claimed(const struct scallop_formula *formula, const struct scallop_values *values)
{
  struct scallop_sides sides;
  bool claimed = true;
  for (const char *const *when = formula->when; when && *when && claimed; when++) {
    char sign = scallop_condition_split(&sides, *when);
    double left = sign ? side_in_double(sides.left, formula, values) : NAN;
    double right = sign ? side_in_double(sides.right, formula, values) : NAN;
    claimed = sign == '<' ? left < right : sign == '>' ? left > right : left == right;
  }
  return claimed;
}

_Static_assert((int)SCALLOP_FORMULA_MESSAGE == (int)FORMULA_MESSAGE,
               "a message of the public face is one of formula.h");

/* Appends a copy of the text, and makes the operations refer to it. */
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

bool scallop_formula_takes(const struct scallop_read_formula *read, enum scallop_symbol symbol)
{
  int places[FORMULA_STEPS], count = formula_places(&read->operations, places);
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
  struct scallop_read_formula *made = make(&operations, formula);
  if (!made)                                                          /* GCOVR_EXCL_LINE: no memory */
    snprintf(message, SCALLOP_FORMULA_MESSAGE, "there is no memory"); /* GCOVR_EXCL_LINE */
  for (int i = 0; made && formula->setting == SCALLOP_STEADY && i < 4; i++)
    if (scallop_formula_takes(made, of_phases[i])) {
      snprintf(message, SCALLOP_FORMULA_MESSAGE, "the steady state has no %s", scallop_symbol_names[of_phases[i]]);
      scallop_formula_free(made);
      return NULL;
    }
  return made;
}

void scallop_formula_free(struct scallop_read_formula *read) { free(read); }

double scallop_formula_double(const struct scallop_read_formula *read, const struct scallop_crawler *crawler,
                              enum scallop_phase_kind kind, double v0, double t1, double dT, double x_switch)
{
  return scallop_formula_at(&read->operations, &read->formula, crawler, kind, v0, t1, dT, x_switch);
}
