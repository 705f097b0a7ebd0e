#include "compare/answers/rows.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "compare/points/defaults.h"
#include "compare/text/tsv.h"
#include "compare/text/values.h"

_Static_assert(TABLE_COLUMNS >= TSV_CELLS + 128, "a table has room for all that is carried along");

const char rows_no_memory[] = "out of memory";

const char *rows_own(struct rows *r, const char *format, ...)
{
  char text[2 * QUANTITY_NAME + 16];
  va_list arguments;
  int count = 0;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  for (; r->own[count]; count++)
    if (strcmp(r->own[count], text) == 0)
      return NULL;
  r->own[count] = count < TABLE_COLUMNS ? strdup(text) : NULL;
  return r->own[count] ? NULL : rows_no_memory;
}

void rows_free(struct rows *r)
{
  for (char **own = r->own; *own; own++)
    free(*own);
  free(r->context);
  column_list_free(&r->sheet.columns);
}

static const char *add_all(struct sheet *s, const char *const *texts, int count)
{
  const char *wrong = NULL;
  for (int i = 0; i < count && texts[i] && !wrong; i++)
    wrong = sheet_add(s, texts[i]);
  return wrong;
}

static bool is_certified(const struct quantity *q) { return q->kind == QUANTITY_CERTIFIED; }

/* How well errors, digits and series have to be known for the columns */
static const char *settle(struct rows *r)
{
  const struct request *q = r->request;
  struct asked *asked = r->sheet.asked;
  if (sheet_takes(&r->sheet, quantity_is_comparison) || r->has_errors) {
    bool fine = q->accuracy.given && q->accuracy.value < ACCURACY_OF_DOUBLES;
    bool certified = q->reference.given && strcmp(q->reference.value, "certified") == 0;
    if (fine && q->reference.given && !certified)
      return "the exact solver works in doubles, whose errors are told down to 1e-10: a finer accuracy needs the "
             "reference certified";
    asked->certified_errors |= certified || fine;
    asked->accuracy = q->accuracy.given && q->accuracy.value < asked->accuracy ? q->accuracy.value : asked->accuracy;
  }
  r->sheet.digits = q->style.digits > 0 ? q->style.digits : q->scene ? DIGITS_OF_DOUBLE : CERTIFIED_DIGITS;
  if (q->style.digits > DIGITS_OF_DOUBLE && !sheet_takes(&r->sheet, is_certified))
    return "so many digits are more than a double has, and no column is certified: certified.displacement is, for one";
  asked->digits = r->sheet.digits > asked->digits ? r->sheet.digits : asked->digits;
  return NULL;
}

/* What is drawn and not among the usual columns stands behind them; among chosen ones it has to be. */
static const char *add_drawn(struct rows *r, bool are_chosen)
{
  const struct plot *plot = &r->request->style.plot;
  const char *const lists[] = { plot->x, plot->y, plot->by }, *const options[] = { "x", "y", "by" }, *wrong = NULL;
  char name[QUANTITY_NAME];
  for (int i = 0; i < 3 && plot->file; i++)
    for (const char *rest = lists[i]; next_item(name, sizeof name, &rest);) {
      if (!column_list_has(&r->sheet.columns, name))
        wrong = are_chosen ? wrong_text("the table has no column %s", name) : sheet_add(&r->sheet, name);
      if (wrong)
        return wrong_text("--plot-%s: %.350s", options[i], wrong);
    }
  return NULL;
}

static const char *add_columns(struct rows *r)
{
  const char *const *own = (const char *const *)r->own, *wrong = NULL;
  const struct quantities *all = &r->sheet.asked->quantities;
  const struct table_choice *choice = r->choice ? r->choice : r->request->style.choice;
  const struct {
    const char *const *texts;
    int count;
  } usual[] = { { all->label, all->labels },
                { crawler_parameters, r->has_parameters ? TABLE_COLUMNS : 0 },
                { r->extra, ROWS_EXTRA },
                { all->carried, all->carries },
                { own, TABLE_COLUMNS } };
  if (r->behind)
    choice = NULL; /* of all columns of the table */
  r->sheet.own = own;
  if (choice)
    wrong = add_all(&r->sheet, choice->names, choice->count);
  for (size_t i = 0; i < sizeof usual / sizeof *usual && !choice && !wrong; i++)
    wrong = add_all(&r->sheet, usual[i].texts, usual[i].count);
  return wrong || r->behind ? wrong : add_drawn(r, choice != NULL);
}

const char *rows_columns(struct rows *r)
{
  const char *wrong = add_columns(r);
  return wrong ? wrong : settle(r);
}

/* Has the table a column of that name with something else in it, as "T = alpha*T"? */
static bool is_renamed(const struct rows *r, const char *parameter)
{
  const struct column_list *all = &r->sheet.columns;
  for (const struct column *c = all->item; c < all->item + all->count; c++)
    if (strcmp(c->name, parameter) == 0
        && (c->place < 0 || strcmp(r->sheet.asked->quantities.item[c->place].name, parameter) != 0))
      return true;
  return false;
}

/* Notes the parameters that were given on the command line in place of the scene's. False: none was. */
static bool note_given(struct rows *r)
{
  const struct point *p = r->request->scene->given;
  const char *not_given[CRAWLER_NUMBERS + 2] = { NULL };
  char text[PARAMETERS_TEXT];
  bool renamed = false;
  int count = 0;
  for (int i = 0; i <= CRAWLER_NUMBERS; i++) {
    bool given = i < CRAWLER_NUMBERS ? p->written[i] != NULL : p->has_gait;
    renamed |= given && is_renamed(r, crawler_parameters[i]);
    if (!given)
      not_given[count++] = crawler_parameters[i];
  }
  if (count <= CRAWLER_NUMBERS)
    table_note(&r->table, "in place of what the scene says of them:%s%s", parameters_text(text, p, not_given, true),
               renamed ? " (of the crawler, not the column)" : "");
  return count <= CRAWLER_NUMBERS;
}

/* Notes the parameters that are the same in all rows; a column of that name may be something else. */
static void note_held(struct rows *r)
{
  const char *not_held[CRAWLER_NUMBERS + 2] = { NULL };
  int count = 0;
  for (const char *const *name = crawler_parameters; *name; name++)
    if (!is_held(r->request, *name) || is_renamed(r, *name))
      not_held[count++] = *name;
  note_parameters(&r->table, &r->request->point, not_held, false);
}

static bool is_of_start(const struct quantity *q)
{
  return q->motion == OF_PHASE || (q->kind == QUANTITY_NUMBER && q->which == PLACE_OF_V0)
         || q->kind == QUANTITY_PHASE_NAME;
}

/* What quantities of a phase are about, where a row has any */
static void note_start(struct rows *r)
{
  const struct point *p = &r->request->point;
  char start[NUMBER_TEXT] = "rest";
  if (!r->sheet.of_samples && !sheet_takes(&r->sheet, is_of_start))
    return;
  if (p->v0 != 0)
    number_text(start, p->v0, 0);
  const char *text = !is_held(r->request, "v0") ? "v0" : r->sheet.asked->from_steady ? "steady" : start;
  if (r->sheet.of_samples)
    table_note(&r->table, "start: %s", text);
  else
    table_note(&r->table, "phase: %s, from %s", p->phase == SCALLOP_EXTENSION ? "extension" : "contraction", text);
}

static void write_head(struct rows *r)
{
  const struct scene_head *scene = r->request->scene;
  if (!scene)
    table_command(&r->table, "%s", r->command ? r->command : r->style.command);
  else {
    table_command(&r->table, "run %s%s", scene->scene, strcmp(scene->scene, "-") == 0 ? "" : ".cfg");
    if (scene->title)
      table_note(&r->table, "%s", scene->title);
    bool given = note_given(r);
    for (int i = 0; i < scene->notes && !given; i++) /* with other parameters they may be wrong */
      table_note(&r->table, "%s", scene->note[i]);
  }
  if (scene || r->notes_parameters)
    note_held(r);
  if (scene)
    note_start(r);
  if (r->head)
    r->head(r);
  sheet_head(&r->sheet, &r->table);
  if (r->behind)
    table_columns(&r->table, r->behind);
  table_begin_rows(&r->table);
}

bool rows_open(struct rows *r)
{
  r->style = r->request->style;
  if (!r->behind)
    r->style.choice = NULL; /* the sheet has taken it */
  r->is_open = table_open(&r->table, &r->style);
  r->cannot_open = !r->is_open;
  if (r->is_open) {
    r->table.of = r->of ? r->of : r->table.of;
    write_head(r);
  }
  return r->is_open;
}
