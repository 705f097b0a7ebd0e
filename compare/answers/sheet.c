#include "compare/answers/sheet.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/points/counts.h"
#include "compare/book/book.h"
#include "compare/columns/columns.h"
#include "compare/text/message.h"
#include "compare/text/values.h"

enum { WRONG = 640 };
static char message[WRONG];

/* What one of the sheet's own names stands for, or NULL; *text: the whole text that gives it */
static const char *own_meaning(const struct sheet *s, const char *name, const char **text)
{
  for (const char *const *own = s->own; own && *own; own++) {
    int length;
    const char *meaning = column_formula(*own, &length);
    if ((int)strlen(name) == length && strncmp(*own, name, (size_t)length) == 0) {
      *text = *own;
      return meaning;
    }
  }
  return NULL;
}

static int quantity_place(void *quantities, const char *name) { return quantity_named(quantities, name); }

/* An own name that is a formula of quantities becomes a quantity too, so that other formulas can take it. */
static int place_of_meaning(struct sheet *s, const char *text, const char *meaning)
{
  struct quantities *all = &s->asked->quantities;
  const struct formula_names names = { .place = quantity_place, .context = all };
  char wrong[FORMULA_MESSAGE];
  int own = 0;
  while (own < SHEET_OWN - 1 && s->own[own] != text)
    own++;
  for (int i = 0; i < all->count; i++)
    if (s->meaning[own] && all->item[i].own == s->meaning[own])
      return i;
  s->meaning[own] = s->meaning[own] ? s->meaning[own] : malloc(sizeof *s->meaning[own]);
  if (!s->meaning[own] || formula_read(s->meaning[own], meaning, &names, wrong) || all->count == MOST_QUANTITIES)
    return -1;
  all->item[all->count] = (struct quantity){ .kind = QUANTITY_FORMULA, .of = -1, .phase = -1, .own = s->meaning[own] };
  return all->count++;
}

static int place_of(void *sheet, const char *name)
{
  struct sheet *s = sheet;
  const char *text, *meaning = own_meaning(s, name, &text);
  int place = quantity_named(&s->asked->quantities, meaning ? meaning : name);
  return place < 0 && meaning ? place_of_meaning(s, text, meaning) : place;
}

static const char *near_to(void *sheet, const char *name, const char *const *functions)
{
  return functions ? nearest(name, functions) : quantity_near(&((struct sheet *)sheet)->asked->quantities, name);
}

const char *sheet_formula(struct sheet *s, struct formula *formula, const char *text)
{
  static char wrong[FORMULA_MESSAGE];
  const struct formula_names names = { .place = place_of, .nearest = near_to, .context = s };
  return formula_read(formula, text, &names, wrong);
}

const char *sheet_no_quantity(const struct sheet *s, const char *name)
{
  const char *near = quantity_near(&s->asked->quantities, name);
  snprintf(message, WRONG, "there is no quantity '%.80s'%s", name,
           *name == '(' ? formula_instead(name)
           : near       ? did_you_mean(near)
                        : " (docs/scenes.md lists them)");
  return message;
}

bool sheet_has(const struct sheet *s, const char *name)
{
  int i = 0;
  while (i < s->count && strcmp(s->column[i].name, name) != 0)
    i++;
  return i < s->count;
}

bool sheet_takes(const struct sheet *s, bool (*holds)(const struct quantities *, const struct quantity *))
{
  for (int i = 0; i < s->count; i++) {
    int places[FORMULA_STEPS] = { s->column[i].quantity };
    int count = s->column[i].formula ? formula_places(s->column[i].formula, places) : 1;
    while (count-- > 0)
      if (holds(&s->asked->quantities, &s->asked->quantities.item[places[count]]))
        return true;
  }
  return false;
}

static const char *wrong(const char *text, const char *what)
{
  snprintf(message, WRONG, "'%.100s': %s", text, what);
  return message;
}

/* NULL, or why rows of this sheet have no such quantity */
static const char *refusal(const struct sheet *s, const struct quantity *q)
{
  const struct quantity *series = q->of >= 0 ? &s->asked->quantities.item[q->of] : q;
  if (q->kind == QUANTITY_SAMPLE && !s->of_samples)
    return "is a quantity of a trajectory";
  if (q->kind == QUANTITY_STATUS && s->of_samples)
    return "is nothing that a trajectory has: it ends where it cannot go on";
  if (s->asked->from_steady && (series->kind == QUANTITY_DERIVED || series->kind == QUANTITY_LIMIT)
      && quantity_rows[series->which].of == OF_PHASE)
    return "is derived for a start that stays the same as T falls: from rest, or from a velocity";
  return NULL;
}

/* Finds what the column shows. */
static const char *find(struct sheet *s, struct sheet_column *column, const char *text, const char *formula,
                        bool is_own)
{
  struct quantities *all = &s->asked->quantities;
  int places[FORMULA_STEPS], count = 1;
  column->quantity = places[0] = quantity_named(all, formula);
  if (column->quantity < 0) {
    const char *why = column->quantity == -2 ? "there are too many quantities" : NULL;
    column->formula = why ? NULL : malloc(sizeof *column->formula);
    struct sheet plain = { .asked = s->asked }; /* in the meaning of an own name there are no own names */
    if (column->formula)
      why = sheet_formula(is_own ? &plain : s, column->formula, formula);
    if (why && column->formula && formula[strcspn(formula, "+-*/^() ")] == '\0')
      return sheet_no_quantity(s, formula);
    if (why || !column->formula)
      return wrong(text, why ? why : "out of memory");
    count = formula_places(column->formula, places);
  }
  for (int i = 0; i < count; i++) {
    const struct quantity *q = &all->item[places[i]];
    const char *why = refusal(s, q);
    if (column->formula && quantity_is_text(q) && q->kind != QUANTITY_CERTIFIED && q->kind != QUANTITY_CARRIED)
      why = "is a text, which stands alone in a column";
    if (why) {
      bool is_other = strcmp(text, q->name) != 0;
      snprintf(message, WRONG, "%s%.100s%s%s %s", is_other ? "'" : "", is_other ? text : "", is_other ? "': " : "",
               q->name, why);
      return message;
    }
  }
  return NULL;
}

/* A new column of that name, or NULL: out of memory */
static struct sheet_column *append(struct sheet *s, const char *text, int length)
{
  char *name = strndup(text, (size_t)length);
  struct sheet_column *grown = name ? realloc(s->column, (size_t)(s->count + 1) * sizeof *grown) : NULL;
  if (!grown) {
    free(name);
    return NULL;
  }
  s->column = grown;
  s->column[s->count] = (struct sheet_column){ .name = name, .quantity = -1 };
  return &s->column[s->count++];
}

const char *sheet_add(struct sheet *s, const char *text)
{
  int length;
  const char *meaning = own_meaning(s, text, &text), *formula = column_formula(text, &length);
  struct sheet_column *column = append(s, text, length);
  if (!column)
    return "out of memory";
  if (length == 0 || *formula == '\0')
    return wrong(text, "a column is QUANTITY or NAME = FORMULA");
  if (!meaning && formula > text && !column_may_be_called(column->name))
    return wrong(text, "the name of a column is of printable ASCII, without tabs, quotes and backslashes");
  const char *why = find(s, column, text, formula, meaning != NULL);
  for (int i = 0; i < s->count - 1 && !why; i++)
    if (strcmp(s->column[i].name, column->name) == 0)
      snprintf(message, WRONG, "the column %.100s is there twice", column->name), why = message;
  for (int i = 0; i < s->count - 1; i++)
    s->early_status |= s->column[i].quantity >= 0
                       && s->asked->quantities.item[s->column[i].quantity].kind == QUANTITY_STATUS;
  return why;
}

void sheet_free(struct sheet *s)
{
  for (int i = 0; i < s->count; i++) {
    free(s->column[i].name);
    free(s->column[i].formula);
  }
  free(s->column);
  for (int i = 0; i < SHEET_OWN; i++) {
    free(s->meaning[i]);
    s->meaning[i] = NULL;
  }
  s->column = NULL;
  s->count = 0;
}

void sheet_head(const struct sheet *s, struct table *t)
{
  for (int i = 0; i < s->count; i++)
    table_columns(t, (const char *const[]){ s->column[i].name, NULL });
}

/* A parameter with all the digits that were given */
static void put_as_written(struct table *t, const struct at *at, const struct quantity *q, double value)
{
  const char *written = q->kind == QUANTITY_V0 ? at->place.point.written_v0 : at->place.point.written[q->which];
  char text[NUMBER_TEXT];
  number_text(text, value, 0); /* --digits is of what is proven */
  table_carried(t, written && !at->place.is_unread ? written : text);
}

static void put(const struct sheet *s, struct table *t, struct at *at, const struct sheet_column *c)
{
  const struct quantity *q = c->quantity >= 0 ? &s->asked->quantities.item[c->quantity] : NULL;
  if (!q || !quantity_is_text(q)) {
    double x = q ? at_number(at, c->quantity) : at_formula(at, c->formula);
    if (q && s->as_written && (q->kind == QUANTITY_NUMBER || q->kind == QUANTITY_V0))
      put_as_written(t, at, q, x);
    else if (q && q->kind == QUANTITY_ESTIMATE)
      table_rounded(t, x, "%.3g");
    else
      table_number(t, x);
    return;
  }
  const char *text = at_text(at, c->quantity, s->digits);
  if (q->kind == QUANTITY_CARRIED)
    table_carried(t, text);
  else if (q->kind != QUANTITY_CERTIFIED)
    table_text(t, text);
  else if (strcmp(text, "nan") == 0)
    table_number(t, NAN);
  else
    table_digits(t, text);
}

void sheet_row(const struct sheet *s, struct table *t, struct at *at)
{
  at->as_written = s->as_written;
  for (int i = 0; s->early_status && i < s->count; i++)
    if (s->column[i].formula)
      at_formula(at, s->column[i].formula);
    else if (quantity_is_text(&s->asked->quantities.item[s->column[i].quantity]))
      at_text(at, s->column[i].quantity, s->digits);
    else
      at_number(at, s->column[i].quantity);
  for (int i = 0; i < s->count; i++)
    put(s, t, at, &s->column[i]);
  count_add(COUNT_ROWS, 1);
}
