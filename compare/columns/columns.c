#include "compare/columns/columns.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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

static bool may_be_called(const char *name)
{
  bool may = *name != '\0';
  for (; *name; name++)
    may = may && *name >= ' ' && *name <= '~' && *name != '"' && *name != '\\';
  return may;
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
  return may_be_called(c->name) ? NULL
                                : "a column is called something of printable ASCII, without quotes and backslashes";
}

const char *column_add(struct column_list *list, const char *text, const struct column_names *names)
{
  int length;
  const char *formula = column_formula(text, &length);
  struct column *grown = realloc(list->item, (size_t)(list->count + 1) * sizeof *grown);
  if (!grown)
    return no_memory;
  list->item = grown;
  char *name = strndup(text, (size_t)length);
  if (!name)
    return no_memory;
  struct column *c = &grown[list->count++];
  *c = (struct column){ .name = name, .place = names->names.place(names->names.context, formula) };
  if (length == 0 || *formula == '\0')
    return not_allowed(text, "NAME or NAME = FORMULA");
  if (c->place < -1)
    return "there are too many quantities";
  const char *wrong = c->place >= 0 ? NULL : read_formula(c, formula, names, formula > text);
  if (!wrong && formula > text && !may_be_called(name))
    return "a column is called something of printable ASCII, without quotes and backslashes";
  for (int i = 0; i < list->count - 1 && !wrong; i++)
    if (strcmp(list->item[i].name, name) == 0) {
      snprintf(message, WRONG, "the column '%.80s' is there twice", name);
      wrong = message;
    }
  return wrong;
}

int column_places(const struct column *c, int places[FORMULA_STEPS])
{
  places[0] = c->place;
  return c->formula ? formula_places(c->formula, places) : 1;
}

bool column_list_has(const struct column_list *list, const char *name)
{
  int i = 0;
  while (i < list->count && strcmp(list->item[i].name, name) != 0)
    i++;
  return i < list->count;
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
  size_t length = strcspn(text, "/");
  if (text[length] == '\0')
    return read_number(text, &x) ? x : NAN;
  if (length >= sizeof whole)
    return NAN;
  memcpy(whole, text, length);
  whole[length] = '\0';
  return read_number(whole, &x) && read_number(text + length + 1, &over) && over != 0 ? x / over : NAN;
}

/* A choice of columns of a table */
struct chosen {
  struct table_choice choice; /* first: the writer knows this alone */
  const char *text[MOST_COLUMNS];
  struct column_list list;
  const char *names[MOST_COLUMNS];
  const char *column[TABLE_COLUMNS + 1]; /* of the table, NULL-terminated, and a row of it */
  bool in_formula[TABLE_COLUMNS];
  double value[TABLE_COLUMNS]; /* of those in a formula */
};

static int place_of(void *context, const char *name)
{
  const struct chosen *c = context;
  int i = 0;
  while (c->column[i] && strcmp(c->column[i], name) != 0)
    i++;
  return c->column[i] ? i : -1;
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
      c->in_formula[places[k]] |= c->list.item[i].formula != NULL;
    c->names[i] = wrong ? "" : c->list.item[i].name;
  }
  choice->names = c->names;
  return wrong;
}

static void show(struct table_choice *choice, const struct table_cell *row, struct table_cell *shown)
{
  struct chosen *c = (struct chosen *)choice;
  for (int i = 0; c->column[i]; i++)
    if (c->in_formula[i]) {
      bool is_number = row[i].kind == CELL_NUMBER || row[i].kind == CELL_ROUNDED;
      c->value[i] = is_number ? row[i].value : text_number(row[i].text);
    }
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
  static const char allowed[] = "names of columns and NAME = FORMULA, with commas between";
  int length;
  text += strspn(text, " ");
  while (end > text && end[-1] == ' ')
    end--;
  if (end == text)
    return not_allowed("", allowed);
  if (c->choice.count == MOST_COLUMNS)
    return "more than 256 columns";
  char *copy = strndup(text, (size_t)(end - text));
  if (!copy)
    return no_memory;
  c->text[c->choice.count++] = copy;
  const char *formula = column_formula(copy, &length);
  return length > 0 && *formula ? NULL : not_allowed(copy, allowed);
}

const char *columns_read(struct table_choice **choice, const char *text)
{
  struct chosen *c = calloc(1, sizeof *c);
  const char *wrong = c ? NULL : no_memory, *end;
  if (c)
    c->choice = (struct table_choice){ .begin = begin, .show = show, .names = c->text };
  for (; !wrong; text = end + 1) {
    end = end_of_item(text);
    wrong = add_text(c, text, end);
    if (*end == '\0')
      break;
  }
  *choice = wrong ? NULL : &c->choice;
  if (wrong && c)
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
