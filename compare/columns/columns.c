#include "compare/columns/columns.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/memory.h"
#include "compare/text/message.h"
#include "compare/text/values.h"

enum { WRONG = 640, MOST_COLUMNS = 256 };
static char message[WRONG];
static const char no_memory[] = "out of memory";

const char *column_formula(const char *text, int *length)
{
  const char *equals = strchr(text, '='), *formula = equals ? equals + 1 : text;
  *length = (int)(equals ? equals - text : (ptrdiff_t)strlen(text));
  while (*length > 0 && text[*length - 1] == ' ')
    --*length;
  return formula + strspn(formula, " ");
}

/* NULL, or what is wrong with the name of a column */
static const char *wrong_name(const char *name)
{
  bool may = *name != '\0';
  for (; *name; name++)
    may = may && *name >= ' ' && *name <= '~' && *name != '"' && *name != '\\';
  return may ? NULL : "a column is called something of printable ASCII, without quotes and backslashes";
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
  if (why) {
    snprintf(message, WRONG, "'%.100s': %s", text, why);
    return message;
  }
  if (!is_named && formula_places(c->formula, places) == 0) /* such as "(28)", an equation */
    return not_allowed(text, "names of columns; NAME = FORMULA may be a number alone");
  return wrong_name(c->name);
}

const char *column_add(struct column_list *list, const char *text, const struct column_names *names)
{
  int length;
  const char *formula = column_formula(text, &length), *wrong = NULL;
  struct column *grown = with_room(list->item, list->count, sizeof *grown);
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
  if (!wrong && is_there)
    snprintf(message, WRONG, "the column '%.80s' is there twice", name);
  return wrong || !is_there ? wrong : message;
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
  double x, over = 1;
  char whole[64];
  const char *slash = strchr(text, '/');
  if (!slash)
    return read_number(text, &x) ? x : NAN;
  int length = snprintf(whole, sizeof whole, "%.*s", (int)(slash - text), text);
  bool is = length < (int)sizeof whole && read_number(whole, &x) && read_number(slash + 1, &over) && over != 0;
  return is ? x / over : NAN;
}

/* A choice of columns of a table */
struct chosen {
  struct table_choice choice; /* first: the writer knows this alone */
  const char *text[MOST_COLUMNS];
  struct column_list list;
  const char *names[MOST_COLUMNS];
  const char *column[TABLE_COLUMNS + 1]; /* of the table, NULL-terminated, and a row of it */
  bool used[TABLE_COLUMNS];
  double value[TABLE_COLUMNS]; /* of those used */
};

static int place_of(void *context, const char *name)
{
  const char *const *columns = ((const struct chosen *)context)->column, *const *c = columns;
  while (*c && strcmp(*c, name) != 0)
    c++;
  return *c ? (int)(c - columns) : -1;
}

static const char *near_to(void *context, const char *name, const char *const *functions)
{
  return nearest(name, functions ? functions : ((const struct chosen *)context)->column);
}

static const char *no_column(void *context, const char *name)
{
  snprintf(message, WRONG, "there is no column '%.80s'%s", name,
           instead_of(name, ((const struct chosen *)context)->column));
  return message;
}

static const char *begin(struct table_choice *choice, const char *const *columns, int count)
{
  struct chosen *c = (struct chosen *)choice;
  const struct column_names names = { { .place = place_of, .nearest = near_to, .context = c }, no_column };
  int places[FORMULA_STEPS];
  const char *wrong = NULL;
  memcpy(c->column, columns, (size_t)count * sizeof *columns);
  for (int i = 0; i < choice->count && !wrong; i++) {
    wrong = column_add(&c->list, c->text[i], &names);
    for (int k = wrong ? 0 : column_places(&c->list.item[i], places); k-- > 0;)
      c->used[places[k]] = true;
    c->names[i] = wrong ? "" : c->list.item[i].name;
  }
  choice->names = c->names;
  return wrong;
}

static void show(struct table_choice *choice, const struct table_cell *row, struct table_cell *shown)
{
  struct chosen *c = (struct chosen *)choice;
  for (int i = 0; c->column[i]; i++)
    if (c->used[i])
      c->value[i] = row[i].kind == CELL_NUMBER || row[i].kind == CELL_ROUNDED ? row[i].value : text_number(row[i].text);
  for (const struct column *item = c->list.item; item < c->list.item + c->list.count; item++, shown++)
    if (item->place >= 0)
      *shown = row[item->place];
    else
      *shown = (struct table_cell){ .kind = CELL_NUMBER, .value = formula_double(item->formula, c->value) };
}

/* The comma that ends the item, or the end of the text */
static const char *end_of_item(const char *text)
{
  int nested = 0;
  for (; *text && (*text != ',' || nested > 0); text++)
    nested += *text == '(' ? 1 : *text == ')' && nested > 0 ? -1 : 0;
  return text;
}

static const char *add_text(struct chosen *c, const char *text, const char *end)
{
  int length = 0;
  text += strspn(text, " ");
  while (end > text && end[-1] == ' ')
    end--;
  if (c->choice.count == MOST_COLUMNS)
    return "more than 256 columns";
  char *copy = strndup(text, (size_t)(end - text));
  if (!copy)
    return no_memory;
  c->text[c->choice.count++] = copy;
  const char *formula = column_formula(copy, &length);
  return length > 0 && *formula ? NULL : not_allowed(copy, "names of columns and NAME = FORMULA, with commas between");
}

const char *columns_read(struct table_choice **choice, const char *text)
{
  struct chosen *c = calloc(1, sizeof *c);
  const char *wrong = NULL, *end;
  if (!c)
    return no_memory;
  c->choice = (struct table_choice){ .begin = begin, .show = show, .names = c->text };
  do {
    end = end_of_item(text);
    wrong = add_text(c, text, end);
    text = end + 1;
  } while (!wrong && *end);
  *choice = wrong ? NULL : &c->choice;
  if (wrong)
    columns_free(&c->choice);
  return wrong;
}

void columns_free(struct table_choice *choice)
{
  struct chosen *c = (struct chosen *)choice;
  for (int i = 0; c && i < choice->count; i++)
    free((char *)c->text[i]);
  if (c)
    column_list_free(&c->list);
  free(c);
}
