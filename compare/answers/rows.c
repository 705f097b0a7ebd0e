/* Columns of a table from their texts, the cells of a row, and the head of the table. */
#include "compare/answers/rows.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/shard.h"
#include "compare/formulas/formula_file.h"
#include "compare/points/counts.h"
#include "compare/points/defaults.h"
#include "compare/tables/tsv.h"
#include "compare/text/values.h"

_Static_assert(TABLE_COLUMNS >= TSV_CELLS + 128, "a table has at least as many columns as a file of points");

/* Returns the text that defines the sheet's own name, or NULL; *meaning: its definition. */
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

/* Returns the place of a name. An own name that is a formula also becomes a quantity, for use in other formulas. */
static int place_of(void *sheet, const char *name)
{
  struct quantities *all = &((struct sheet *)sheet)->required->quantities;
  const char *meaning, *own = own_text(sheet, name, &meaning);
  int place = quantity_named(all, own ? meaning : name);
  return place < 0 && own ? quantity_of_text(all, own, meaning) : place;
}

static const char *near_to(void *sheet, const char *name, const char *const *functions)
{
  return functions ? nearest(name, functions) : quantity_near(&((struct sheet *)sheet)->required->quantities, name);
}

const char *unknown_quantity_error(const struct requirements *required, const char *name)
{
  const char *near = quantity_near(&required->quantities, name);
  return wrong_text("there is no quantity '%.80s'%s", name,
                    *name == '(' ? formula_hint(name)
                    : near       ? did_you_mean(near)
                                 : " (docs/reference/columns.md lists them)");
}

static const char *missing(void *sheet, const char *name)
{
  return unknown_quantity_error(((struct sheet *)sheet)->required, name);
}

const char *sheet_formula(struct requirements *required, struct formula *formula, const char *text)
{
  static char wrong[FORMULA_MESSAGE];
  struct sheet plain = { .required = required };
  const struct formula_names names = { .place = place_of, .nearest = near_to, .context = &plain };
  return formula_read(formula, text, &names, wrong);
}

/* Returns true if a column takes a quantity for which holds() is true. */
static bool sheet_takes(const struct sheet *s, bool (*holds)(const struct quantity *))
{
  int places[FORMULA_STEPS];
  for (int i = 0; i < s->columns.count; i++)
    for (int k = column_places(&s->columns.item[i], places); k-- > 0;)
      if (holds(&s->required->quantities.item[places[k]]))
        return true;
  return false;
}

static bool is_derived(const struct quantity *q) { return q->kind == QUANTITY_DERIVED || q->kind == QUANTITY_LIMIT; }

/* Returns NULL, or why the column cannot have the quantity. */
static const char *column_error(const struct sheet *s, const struct column *column, const struct quantity *q)
{
  const struct quantity *series = q->of >= 0 ? &s->required->quantities.item[q->of] : q;
  bool is_number = !quantity_is_text(q) || q->kind == QUANTITY_CERTIFIED || q->kind == QUANTITY_CARRIED;
  if (column->formula && !is_number)
    return "is a text and cannot be part of a formula";
  if (q->kind == QUANTITY_SAMPLE && !s->of_samples)
    return "is a quantity of a trajectory";
  if (q->kind == QUANTITY_STATUS && s->of_samples)
    return "is not a quantity of a trajectory";
  if (s->required->from_steady && q->motion == OF_PHASE && is_derived(series))
    return "is derived for a start that stays the same as T falls: from rest, or from a velocity";
  return NULL;
}

static bool is_status(const struct quantity *q) { return q->kind == QUANTITY_STATUS; }

/* Adds a column. Returns NULL or the error of the text, valid until the next call. */
static const char *sheet_add(struct sheet *s, const char *text)
{
  const char *meaning, *own = own_text(s, text, &meaning), *why;
  struct sheet plain = { .required = s->required }; /* own names are not used in the definition of an own name */
  const struct column_names names = { { place_of, near_to, NULL, own ? &plain : s }, missing };
  int places[FORMULA_STEPS];
  text = own ? own : text;
  s->early_status |= sheet_takes(s, is_status);
  const char *wrong = column_add(&s->columns, text, &names);
  const struct column *added = &s->columns.item[s->columns.count - 1];
  for (int i = wrong ? 0 : column_places(added, places); i-- > 0;) {
    const struct quantity *q = &s->required->quantities.item[places[i]];
    if ((why = column_error(s, added, q)))
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
  enum quantity_kind kind = s->required->quantities.item[quantity].kind;
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
  const struct quantity *q = &s->required->quantities.item[quantity];
  double x = at_number(at, quantity);
  char shortest[NUMBER_TEXT];
  const double unknown = t->sink->digits == ALIGNED_DIGITS && !t->style->digits ? at_data_error(at, quantity) : NAN;
  if (q->kind == QUANTITY_ESTIMATE || !isnan(unknown)) {
    char format[8];
    snprintf(format, sizeof format, "%%.%dg", isnan(unknown) ? 3 : digits_known(x, unknown));
    table_rounded(t, x, format);
  } else if (q->kind != QUANTITY_NUMBER || !s->as_written)
    table_number(t, x);
  else { /* all given digits; --digits applies to certified values */
    const char *written = at->place.is_unread ? NULL : at->place.point.written[q->which];
    if (written && t->sink->format == FORMAT_JSON && !json_takes_number(written))
      written = NULL; /* 3/5, .6 */
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
      (quantity_is_text(&s->required->quantities.item[c->place]) ? put_text : put_number)(s, t, at, c->place);
  count_add(COUNT_ROWS, 1);
}

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

/* Sets the accuracy of errors and the digits for the columns. Returns NULL or the error. */
static const char *set_accuracy(struct rows *r)
{
  const struct request *q = r->request;
  struct requirements *required = r->sheet.required;
  if (sheet_takes(&r->sheet, quantity_is_comparison) || r->has_errors) {
    bool fine = q->accuracy.given && q->accuracy.value < ACCURACY_OF_DOUBLES;
    bool certified = q->reference.given && strcmp(q->reference.value, "certified") == 0;
    if (fine && q->reference.given && !certified)
      return "the exact solver works in doubles and resolves errors down to 1e-10: a finer accuracy needs the "
             "reference certified";
    required->certified_errors |= certified || fine;
    required->accuracy = fmin(q->accuracy.given ? q->accuracy.value : INFINITY, required->accuracy);
  }
  r->sheet.digits = q->style.digits > 0 ? q->style.digits : q->scene ? DIGITS_OF_DOUBLE : CERTIFIED_DIGITS;
  if (q->style.digits > DIGITS_OF_DOUBLE && !sheet_takes(&r->sheet, is_certified))
    return "the digits are more than a double has, and no column is certified: use certified.displacement, for one";
  required->digits = r->sheet.digits > required->digits ? r->sheet.digits : required->digits;
  return NULL;
}

/* Adds the columns of the plot. Missing ones follow the usual columns; if columns are chosen they must be among these,
 * except for a map: it also needs its axes, drawn but not written. Returns NULL or the error. */
static const char *add_drawn(struct rows *r, bool are_chosen)
{
  const struct plot *plot = &r->request->style.plot;
  const char *const lists[] = { plot->x, plot->y, plot->by }, *const options[] = { "x", "y", "by" }, *wrong = NULL;
  const bool is_map = are_chosen && r->of && strcmp(r->of, "map") == 0;
  const int written = r->sheet.columns.count;
  char name[QUANTITY_NAME];
  for (int axis = 0; axis < 2 && plot->file && is_map && !wrong; axis++) {
    const char *text = r->own[axis], *end = strstr(text, " = ");
    snprintf(name, sizeof name, "%.*s", end ? (int)(end - text) : (int)strlen(text), text);
    wrong = column_list_has(&r->sheet.columns, name) ? NULL : sheet_add(&r->sheet, name);
  }
  for (int i = 0; i < 3 && plot->file && !wrong; i++)
    for (const char *rest = lists[i]; next_item(name, sizeof name, &rest);) {
      if (!column_list_has(&r->sheet.columns, name))
        wrong = are_chosen && !is_map ? wrong_text("the table has no column %s", name) : sheet_add(&r->sheet, name);
      if (wrong)
        return wrong_text("--plot-%s: %.350s", options[i], wrong);
    }
  r->only_drawn = is_map ? r->sheet.columns.count - written : 0;
  return wrong;
}

static const char *add_columns(struct rows *r)
{
  const char *const *own = (const char *const *)r->own, *wrong = NULL;
  const struct quantities *all = &r->sheet.required->quantities;
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
    choice = NULL; /* it applies to all columns of the table */
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
  return wrong ? wrong : set_accuracy(r);
}

/* Returns true if a column with the parameter's name has another value, as "T = alpha*T". */
static bool is_renamed(const struct rows *r, const char *parameter)
{
  const struct column_list *all = &r->sheet.columns;
  for (const struct column *c = all->item; c < all->item + all->count; c++)
    if (strcmp(c->name, parameter) == 0
        && (c->place < 0 || strcmp(r->sheet.required->quantities.item[c->place].name, parameter) != 0))
      return true;
  return false;
}

/* Notes the parameters of the command line that override the scene's. Returns false without such parameters. */
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
    table_note(&r->table, "given on the command line in place of the scene's:%s%s",
               parameters_text(text, p, not_given, true), renamed ? " (of the crawler, not the column)" : "");
  return count <= CRAWLER_NUMBERS;
}

/* Notes the parameters that are the same in all rows and no column redefines. */
static void note_constants(struct rows *r)
{
  const char *excluded[CRAWLER_NUMBERS + 2] = { NULL };
  int count = 0;
  for (const char *const *name = crawler_parameters; *name; name++)
    if (!is_constant(r->request, *name) || is_renamed(r, *name))
      excluded[count++] = *name;
  note_parameters(&r->table, &r->request->point, excluded, false);
}

static bool is_of_start(const struct quantity *q)
{
  return q->motion == OF_PHASE || (q->kind == QUANTITY_NUMBER && q->which == PLACE_OF_V0)
         || q->kind == QUANTITY_PHASE_NAME;
}

/* Notes the phase and its start if a row has quantities of a phase. */
static void note_start(struct rows *r)
{
  const struct point *p = &r->request->point;
  char start[NUMBER_TEXT] = "rest";
  if (!r->sheet.of_samples && !sheet_takes(&r->sheet, is_of_start))
    return;
  if (p->v0 != 0)
    number_text(start, p->v0, 0);
  const char *text = !is_constant(r->request, "v0") ? "v0" : r->sheet.required->from_steady ? "steady" : start;
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
    for (int i = 0; i < scene->notes && !given; i++) /* other parameters may make them wrong */
      table_note(&r->table, "%s", scene->note[i]);
  }
  if (r->request->shard.parts > 0)
    table_note(&r->table, SHARD_LINE, r->request->shard.part, r->request->shard.parts, r->request->shard.sweep);
  if (scene || r->notes_parameters)
    note_constants(r);
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
    r->style.choice = NULL; /* the sheet has only the chosen columns */
  r->is_open = table_open(&r->table, &r->style);
  r->cannot_open = !r->is_open;
  if (r->is_open) {
    r->table.of = r->of ? r->of : r->table.of;
    r->table.only_drawn = r->only_drawn;
    write_head(r);
  }
  return r->is_open;
}
