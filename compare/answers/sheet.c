/* The columns of tables by the texts that ask for them, and their cells at a point. */
#include "compare/answers/rows.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/book/book.h"
#include "compare/points/counts.h"
#include "compare/text/message.h"

/* The text that gives the sheet's own name, or NULL; *meaning: what it stands for */
static const char *own_text(const struct sheet *s, const char *name, const char **meaning)
{
  for (const char *const *own = s->own; own && *own; own++) {
    int length;
    *meaning = column_formula(*own, &length);
    if ((int)strlen(name) == length && strncmp(*own, name, (size_t)length) == 0)
      return *own;
  }
  return NULL;
}

/* An own name that is a formula of quantities becomes a quantity too, so that other formulas can take it. */
static int place_of(void *sheet, const char *name)
{
  struct quantities *all = &((struct sheet *)sheet)->asked->quantities;
  const char *meaning, *own = own_text(sheet, name, &meaning);
  int place = quantity_named(all, own ? meaning : name);
  return place < 0 && own ? quantity_of_text(all, own, meaning) : place;
}

static const char *near_to(void *sheet, const char *name, const char *const *functions)
{
  return functions ? nearest(name, functions) : quantity_near(&((struct sheet *)sheet)->asked->quantities, name);
}

const char *sheet_no_quantity(const struct asked *asked, const char *name)
{
  const char *near = quantity_near(&asked->quantities, name);
  return wrong_text("there is no quantity '%.80s'%s", name,
                    *name == '(' ? formula_instead(name)
                    : near       ? did_you_mean(near)
                                 : " (docs/scenes.md lists them)");
}

static const char *missing(void *sheet, const char *name)
{
  return sheet_no_quantity(((struct sheet *)sheet)->asked, name);
}

const char *sheet_formula(struct asked *asked, struct formula *formula, const char *text)
{
  static char wrong[FORMULA_MESSAGE];
  struct sheet plain = { .asked = asked };
  const struct formula_names names = { .place = place_of, .nearest = near_to, .context = &plain };
  return formula_read(formula, text, &names, wrong);
}

bool sheet_takes(const struct sheet *s, bool (*holds)(const struct quantity *))
{
  int places[FORMULA_STEPS];
  for (int i = 0; i < s->columns.count; i++)
    for (int k = column_places(&s->columns.item[i], places); k-- > 0;)
      if (holds(&s->asked->quantities.item[places[k]]))
        return true;
  return false;
}

static bool is_derived(const struct quantity *q) { return q->kind == QUANTITY_DERIVED || q->kind == QUANTITY_LIMIT; }

/* NULL, or why the column cannot have that quantity */
static const char *refusal(const struct sheet *s, const struct column *column, const struct quantity *q)
{
  const struct quantity *series = q->of >= 0 ? &s->asked->quantities.item[q->of] : q;
  bool is_number = !quantity_is_text(q) || q->kind == QUANTITY_CERTIFIED || q->kind == QUANTITY_CARRIED;
  if (column->formula && !is_number)
    return "is a text, which stands alone in a column";
  if (q->kind == QUANTITY_SAMPLE && !s->of_samples)
    return "is a quantity of a trajectory";
  if (q->kind == QUANTITY_STATUS && s->of_samples)
    return "is nothing that a trajectory has: it ends where it cannot go on";
  if (s->asked->from_steady && q->motion == OF_PHASE && is_derived(series))
    return "is derived for a start that stays the same as T falls: from rest, or from a velocity";
  return NULL;
}

static bool is_status(const struct quantity *q) { return q->kind == QUANTITY_STATUS; }

const char *sheet_add(struct sheet *s, const char *text)
{
  const char *meaning, *own = own_text(s, text, &meaning), *why;
  struct sheet plain = { .asked = s->asked }; /* in the meaning of an own name there are no own names */
  const struct column_names names = { { place_of, near_to, NULL, own ? &plain : s }, missing };
  int places[FORMULA_STEPS];
  text = own ? own : text;
  s->early_status |= sheet_takes(s, is_status);
  const char *wrong = column_add(&s->columns, text, &names);
  const struct column *added = &s->columns.item[s->columns.count - 1];
  for (int i = wrong ? 0 : column_places(added, places); i-- > 0;) {
    const struct quantity *q = &s->asked->quantities.item[places[i]];
    if ((why = refusal(s, added, q)))
      return strcmp(text, q->name) == 0 ? wrong_text("%s %s", text, why)
                                        : wrong_text("'%.100s': %s %s", text, q->name, why);
  }
  return wrong;
}

void sheet_head(const struct sheet *s, struct table *t)
{
  for (int i = 0; i < s->columns.count; i++)
    table_columns(t, (const char *const[]){ s->columns.item[i].name, NULL });
}

static void put_text(const struct sheet *s, struct table *t, struct at *at, int quantity)
{
  const char *text = at_text(at, quantity, s->digits);
  enum quantity_kind kind = s->asked->quantities.item[quantity].kind;
  if (kind == QUANTITY_CARRIED)
    table_carried(t, text);
  else if (kind != QUANTITY_CERTIFIED)
    table_text(t, text);
  else if (strcmp(text, "nan") == 0)
    table_number(t, NAN);
  else
    table_digits(t, text);
}

static void put_number(const struct sheet *s, struct table *t, struct at *at, int quantity)
{
  const struct quantity *q = &s->asked->quantities.item[quantity];
  double x = at_number(at, quantity);
  char shortest[NUMBER_TEXT];
  if (q->kind == QUANTITY_ESTIMATE)
    table_rounded(t, x, "%.3g");
  else if (q->kind != QUANTITY_NUMBER || !s->as_written)
    table_number(t, x);
  else { /* with all the digits that were given: --digits is of what is proven */
    const char *written = at->place.is_unread ? NULL : at->place.point.written[q->which];
    number_text(shortest, x, 0);
    table_carried(t, written ? written : shortest);
  }
}

void sheet_row(const struct sheet *s, struct table *t, struct at *at)
{
  const struct column *end = s->columns.item + s->columns.count;
  at->as_written = s->as_written;
  for (const struct column *c = s->columns.item; s->early_status && c < end; c++)
    c->formula ? at_formula(at, c->formula) : at_number(at, c->place);
  for (const struct column *c = s->columns.item; c < end; c++)
    if (c->formula)
      table_number(t, at_formula(at, c->formula));
    else
      (quantity_is_text(&s->asked->quantities.item[c->place]) ? put_text : put_number)(s, t, at, c->place);
  count_add(COUNT_ROWS, 1);
}
