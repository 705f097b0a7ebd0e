#include "compare/columns/columns.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/memory.h"
#include "compare/text/message.h"
#include "compare/text/values.h"

enum { MAX_COLUMNS = 256 };
static const char no_memory[] = "out of memory";

const char *column_formula(const char *text, int *length)
{
  const char *equals = strchr(text, '='), *formula = equals ? equals + 1 : text;
  *length = (int)(equals ? equals - text : (ptrdiff_t)strlen(text));
  while (*length > 0 && text[*length - 1] == ' ')
    --*length;
  return formula + strspn(formula, " ");
}

/* Returns NULL or the error of the name of a column. */
static const char *wrong_name(const char *name)
{
  bool may = *name != '\0';
  for (; *name; name++)
    may = may && *name >= ' ' && *name <= '~' && *name != '"' && *name != '\\';
  return may ? NULL : "the name of a column is printable ASCII, without quotes and backslashes";
}

static const char *read_formula(struct column *c, const char *text, const struct column_names *names, bool is_named)
{
  char wrong[FORMULA_MESSAGE];
  int places[FORMULA_STEPS];
  c->formula = malloc(sizeof *c->formula);
  if (!c->formula)
    return no_memory;
  const char *why = formula_read(c->formula, text, &names->names, wrong);
  if (why && text[strcspn(text, "+-*/^() ")] == '\0')
    return names->missing(names->names.context, text);
  if (why)
    return wrong_text("'%.100s': %s", text, why);
  if (!is_named && formula_places(c->formula, places) == 0) /* "(28)" is an equation */
    return not_allowed(text, "names of columns; NAME = FORMULA may be a number alone");
  return wrong_name(c->name);
}

const char *column_add(struct column_list *list, const char *text, const struct column_names *names)
{
  int length;
  const char *formula = column_formula(text, &length), *wrong = NULL;
  struct column *grown = list_grown(list->item, list->count, sizeof *grown);
  list->item = grown ? grown : list->item;
  char *name = grown ? strndup(text, (size_t)length) : NULL;
  if (!name)
    return no_memory;
  bool is_there = column_list_has(list, name);
  struct column *c = &grown[list->count++];
  *c = (struct column){ .name = name, .place = names->names.place(names->names.context, formula) };
  if (length == 0 || *formula == '\0')
    return not_allowed(text, "NAME or NAME = FORMULA");
  if (c->place < -1)
    return "there are too many quantities";
  if (c->place < 0)
    wrong = read_formula(c, formula, names, formula > text);
  else if (formula > text)
    wrong = wrong_name(name);
  return !wrong && is_there ? wrong_text("the column '%.80s' is there twice", name) : wrong;
}

int column_places(const struct column *c, int places[FORMULA_STEPS])
{
  places[0] = c->place;
  return c->formula ? formula_places(c->formula, places) : 1;
}

bool column_list_has(const struct column_list *list, const char *name)
{
  bool has = false;
  for (int i = 0; i < list->count; i++)
    has |= strcmp(list->item[i].name, name) == 0;
  return has;
}

void column_list_free(struct column_list *list)
{
  for (int i = 0; i < list->count; i++) {
    free(list->item[i].name);
    free(list->item[i].formula);
  }
  free(list->item);
  *list = (struct column_list){ .count = 0 };
}

double text_number(const char *text)
{
  double x, over;
  char *slash;
  if (read_number(text, &x))
    return x;
  x = strtod(text, &slash);
  return slash > text && *slash == '/' && read_number(slash + 1, &over) && over != 0 ? x / over : NAN;
}

/* A choice of columns of a table */
struct chosen {
  struct table_choice choice;    /* first: a table sees only this */
  const char *name[MAX_COLUMNS]; /* until the table begins the text of the column */
  struct column_list list;
  const char *column[TABLE_COLUMNS + 1]; /* columns of the table, NULL-terminated */
  char text[];                           /* the texts, each ended by a NUL */
};

static int place_of(void *columns, const char *name) { return word_place(name, columns); }

static const char *near_to(void *columns, const char *name, const char *const *functions)
{
  return nearest(name, functions ? functions : columns);
}

static const char *no_column(void *columns, const char *name)
{
  return wrong_text("there is no column '%.80s'%s", name, name_hint(name, columns));
}

static const char *begin(struct table_choice *choice, const char *const *columns, int count)
{
  struct chosen *c = (struct chosen *)choice;
  const struct column_names names = { { .place = place_of, .nearest = near_to, .context = c->column }, no_column };
  const char *wrong = NULL;
  memcpy(c->column, columns, (size_t)count * sizeof *columns);
  for (int i = 0; i < choice->count && !wrong; i++) {
    wrong = column_add(&c->list, c->name[i], &names);
    c->name[i] = wrong ? "" : c->list.item[i].name;
  }
  return wrong;
}

static double number_of(const struct table_cell *c)
{
  return c->kind == CELL_NUMBER || !isnan(c->value) ? c->value : text_number(c->text);
}

static void show(struct table_choice *choice, const struct table_cell *row, struct table_cell *shown)
{
  const struct column_list *list = &((struct chosen *)choice)->list;
  int places[FORMULA_STEPS];
  double value[TABLE_COLUMNS];
  for (const struct column *c = list->item; c < list->item + list->count; c++, shown++) {
    for (int i = c->formula ? column_places(c, places) : 0; i-- > 0;)
      value[places[i]] = number_of(&row[places[i]]);
    *shown = c->formula ? (struct table_cell){ .kind = CELL_NUMBER, .value = formula_double(c->formula, value) }
                        : row[c->place];
  }
}

static const char *add_text(struct chosen *c, const char *text)
{
  int length;
  const char *formula = column_formula(text, &length);
  if (c->choice.count == MAX_COLUMNS)
    return "more than 256 columns";
  c->name[c->choice.count++] = text;
  return length > 0 && *formula ? NULL : not_allowed(text, "names of columns and NAME = FORMULA, with commas between");
}

const char *columns_read(struct table_choice **choice, const char *text)
{
  const size_t size = strlen(text) + 1;
  struct chosen *c = calloc(1, sizeof *c + size);
  const char *wrong = c ? NULL : no_memory;
  for (char *item = c ? c->text : NULL; !wrong && next_item(item, size, &text); item += strlen(item) + 1)
    wrong = add_text(c, item);
  if (!wrong)
    c->choice = (struct table_choice){ begin, show, c->name, c->choice.count, false };
  else
    free(c);
  *choice = wrong ? NULL : &c->choice;
  return wrong;
}

void columns_free(struct table_choice *choice)
{
  if (choice)
    column_list_free(&((struct chosen *)choice)->list);
  free(choice);
}
