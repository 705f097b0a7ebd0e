#include "compare/columns/columns.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/formula.h"
#include "compare/text/memory.h"
#include "compare/text/message.h"
#include "compare/text/values.h"

enum { WRONG = 640, MOST_COLUMNS = 256 };
static char message[WRONG];

struct item {
  char *name;              /* of the column that is shown                          */
  const char *text;        /* of its formula                                       */
  int place;               /* of the column of the table, or -1: a formula       */
  struct formula *formula; /* its own, NULL: none                                 */
};

struct columns {
  struct table_choice choice; /* first: the writer knows this alone */
  struct item item[MOST_COLUMNS];
  const char *names[MOST_COLUMNS + 1];
  /* the table as it is without the choice, and a row of it */
  const char *const *column;
  int columns;
  bool used[TABLE_COLUMNS];
  bool in_formula[TABLE_COLUMNS];
  double value[TABLE_COLUMNS]; /* of those in a formula */
};

const char *column_formula(const char *text, int *length)
{
  const char *equals = strchr(text, '='), *formula = equals ? equals + 1 : text;
  *length = (int)(equals ? equals - text : (ptrdiff_t)strlen(text));
  while (*length > 0 && text[*length - 1] == ' ')
    --*length;
  return formula + strspn(formula, " ");
}

bool column_may_be_called(const char *name)
{
  bool may = *name != '\0';
  for (; *name; name++)
    may = may && *name >= ' ' && *name <= '~' && *name != '"' && *name != '\\';
  return may;
}

/* The comma that ends the item, or the end of the text */
static const char *end_of_item(const char *text)
{
  int nested = 0;
  for (; *text && (*text != ',' || nested > 0); text++)
    nested += *text == '(' ? 1 : *text == ')' && nested > 0 ? -1 : 0;
  return text;
}

static const char *add_item(struct columns *c, const char *text, const char *end)
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
  struct item *item = &c->item[c->choice.count];
  char *copy = item->name = strndup(text, (size_t)(end - text));
  if (!copy)
    return "out of memory";
  c->names[c->choice.count++] = copy;
  item->text = column_formula(copy, &length);
  return length > 0 && *item->text ? NULL : not_allowed(copy, allowed);
}

/* A column of the table by its name */
static int place_of(void *context, const char *name)
{
  const struct columns *c = context;
  for (int i = 0; i < c->columns; i++)
    if (strcmp(c->column[i], name) == 0)
      return i;
  return -1;
}

struct names {
  const char *of[TABLE_COLUMNS + 1]; /* then NULL */
};

static struct names names_of(const struct columns *c)
{
  struct names names = { { NULL } };
  memcpy(names.of, c->column, (size_t)c->columns * sizeof *names.of);
  return names;
}

static const char *near_to(void *context, const char *name, const char *const *functions)
{
  return nearest(name, functions ? functions : names_of(context).of);
}

static const char *no_column(const struct columns *c, const char *name)
{
  snprintf(message, WRONG, "there is no column '%.80s'%s", name, instead_of(name, names_of(c).of));
  return message;
}

/* A formula of columns. Its column has the name before '='. */
static const char *find_formula(struct columns *c, struct item *item)
{
  const struct formula_names names = { .place = place_of, .nearest = near_to, .context = c };
  char wrong[FORMULA_MESSAGE];
  int length, places[FORMULA_STEPS];
  struct formula *formula = item->formula = realloc(item->formula, sizeof *formula);
  if (!formula)
    return "out of memory";
  const char *why = formula_read(formula, item->text, &names, wrong);
  if (why && item->text[strcspn(item->text, "+-*/^() ")] == '\0')
    return no_column(c, item->text);
  if (why) {
    snprintf(message, WRONG, "'%.100s': %s", item->text, why);
    return message;
  }
  int used = formula_places(formula, places);
  if (used == 0 && item->text == item->name) /* such as "(28)", an equation */
    return not_allowed(item->text, "names of columns; NAME = FORMULA may be a number alone");
  while (used-- > 0)
    c->used[places[used]] = c->in_formula[places[used]] = true;
  column_formula(item->name, &length);
  if (item->text > item->name)
    item->name[length] = '\0';
  return column_may_be_called(item->name)
             ? NULL
             : "a column is called something of printable ASCII, without quotes and backslashes";
}

static const char *begin(struct table_choice *choice, const char *const *column, int columns)
{
  struct columns *c = (struct columns *)choice;
  c->column = column;
  c->columns = columns;
  for (int i = 0; i < choice->count; i++) {
    struct item *item = &c->item[i];
    const char *wrong = NULL;
    item->place = place_of(c, item->name);
    if (item->place >= 0)
      c->used[item->place] = true;
    else
      wrong = find_formula(c, item);
    for (int k = 0; k < i && !wrong; k++)
      if (strcmp(c->item[k].name, item->name) == 0) {
        snprintf(message, WRONG, "the column '%.80s' is there twice", item->name);
        wrong = message;
      }
    if (wrong)
      return wrong;
  }
  return NULL;
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

static void show(struct table_choice *choice, const struct table_cell *row, struct table_cell *shown)
{
  struct columns *c = (struct columns *)choice;
  for (int i = 0; i < c->columns; i++)
    if (c->in_formula[i]) {
      bool is_number = row[i].kind == CELL_NUMBER || row[i].kind == CELL_ROUNDED;
      c->value[i] = is_number ? row[i].value : text_number(row[i].text);
    }
  for (int i = 0; i < choice->count; i++)
    if (c->item[i].place >= 0)
      shown[i] = row[c->item[i].place];
    else
      shown[i] = (struct table_cell){ .kind = CELL_NUMBER, .value = formula_double(c->item[i].formula, c->value) };
}

const char *columns_read(struct table_choice **choice, const char *text)
{
  struct columns *c = calloc(1, sizeof *c);
  const char *wrong = c ? NULL : "out of memory", *end;
  if (c)
    c->choice = (struct table_choice){ .begin = begin, .show = show, .names = c->names, .used = c->used };
  for (; c && !wrong; text = end + 1) {
    end = end_of_item(text);
    wrong = add_item(c, text, end);
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
  struct columns *c = (struct columns *)choice;
  for (int i = 0; c && i < choice->count; i++) {
    free(c->item[i].name);
    free(c->item[i].formula);
  }
  free(c);
}
