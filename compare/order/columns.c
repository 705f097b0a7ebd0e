#include "compare/order/columns.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/message.h"

static char message[640];

bool read_cell(const char *text, double *value)
{
  char *end;
  *value = strtod(text, &end);
  return end != text && *end == '\0';
}

void column_name(char name[COLUMN_NAME], const struct tsv *t, int column)
{
  if (t->columns > 0)
    snprintf(name, COLUMN_NAME, "%.99s", t->column[column]);
  else
    snprintf(name, COLUMN_NAME, "column %d", column + 1);
}

static bool is_among(const char *const *names, const char *name)
{
  while (*names && strcmp(*names, name) != 0)
    names++;
  return *names != NULL;
}

/* The place of the only column that has one of these names; -1: there is none, -2: there are several */
static int only_column(const struct tsv *t, const char *const *names)
{
  int place = -1;
  for (int i = 0; i < t->columns; i++)
    if (is_among(names, t->column[i]))
      place = place == -1 ? i : -2;
  return place;
}

/* A column by its name, or by its number from 1. Returns NULL or what is wrong. */
static const char *chosen(int *place, const struct tsv *t, const char *option, const char *name)
{
  const char *const names[] = { name, NULL };
  char *end;
  long number = strtol(name, &end, 10);
  *place = only_column(t, names);
  if (*place == -1 && end != name && *end == '\0' && number >= 1 && number <= t->count)
    *place = (int)number - 1;
  if (*place >= 0)
    return NULL;
  const char *all[TSV_CELLS + 1] = { NULL };
  memcpy(all, t->column, (size_t)t->columns * sizeof *all);
  if (*place == -2)
    snprintf(message, sizeof message, "--%s: the column '%.100s' is there twice", option, name);
  else
    snprintf(message, sizeof message, "--%s: there is no column '%.100s'%s", option, name,
             t->columns > 0 ? instead_of(name, all) : "");
  return message;
}

static const char *add_y(struct layout *l, int place, bool values)
{
  for (int i = 0; i < l->ys; i++)
    if (l->y[i] == place)
      return NULL;
  if (l->ys == MOST_Y)
    return "more than 64 columns of errors: choose some with --y";
  l->values[l->ys] = values;
  l->y[l->ys++] = place;
  return NULL;
}

static const char *chosen_ys(struct layout *l, const struct tsv *t, const char *list, bool values)
{
  const char *wrong = NULL;
  for (const char *at = list; at && !wrong; at = strchr(at, ',') ? strchr(at, ',') + 1 : NULL) {
    char name[COLUMN_NAME];
    int place, length = (int)strcspn(at, ",");
    snprintf(name, sizeof name, "%.*s", length < COLUMN_NAME ? length : COLUMN_NAME - 1, at);
    wrong = chosen(&place, t, "y", name);
    if (!wrong)
      wrong = place == l->x ? "--y: this column is x" : add_y(l, place, values || strcmp(name, "value") == 0);
  }
  return wrong;
}

/* Each column right of x that holds a number and is neither noise nor an order that the table brings along */
static const char *other_ys(struct layout *l, const struct tsv *t, bool values)
{
  static const char *const orders[] = { "noise", "order", "orders",   "rate",  "rates",
                                        "eoc",   "EOC",   "pairwise", "ratio", NULL };
  const char *wrong = NULL;
  double number;
  for (int i = l->x + 1; i < t->count && !wrong; i++)
    if (read_cell(t->cell[i], &number) && !(i < t->columns && is_among(orders, t->column[i])))
      wrong = add_y(l, i, values);
  if (!wrong && l->ys == 0)
    wrong = t->count == 1 && strchr(t->cell[0], ';') ? "';' separates no columns: blanks, tabs and commas do"
                                                     : "right of h there is no column of numbers: name it with --y";
  return wrong;
}

const char *columns_differ(const struct tsv *t, int columns)
{
  snprintf(message, sizeof message,
           "%d columns, and %d above: blanks, tabs and commas separate columns, so numbers have decimal points",
           t->count, columns);
  return message;
}

static const char *find_x(struct layout *l, const struct tsv *t, const struct columns_wanted *wanted)
{
  static const char *const h[] = { "h", NULL };
  if (wanted->x)
    return chosen(&l->x, t, "x", wanted->x);
  l->x = only_column(t, h);
  if (l->x == -2)
    return "the column 'h' is there twice";
  if (l->x < 0) /* the first one, but for the index without a name that pandas writes */
    l->x = t->columns > 1 && *t->column[0] == '\0';
  return NULL;
}

const char *columns_find(struct layout *l, const struct tsv *t, const struct columns_wanted *wanted)
{
  static const char *const err[] = { "err", "error", "value", NULL }, *const noise[] = { "noise", NULL };
  *l = (struct layout){ .columns = t->columns > 0 ? t->columns : t->count };
  const char *wrong = t->count == l->columns ? NULL : columns_differ(t, l->columns);
  if (wrong)
    return wrong;
  wrong = find_x(l, t, wanted);
  if (wrong)
    return wrong;
  int named = only_column(t, err);
  l->noise = only_column(t, noise);
  if (l->noise == -2)
    return "the column 'noise' is there twice";
  for (int i = 0; i < wanted->ys && !wrong; i++)
    wrong = chosen_ys(l, t, wanted->y[i], wanted->values);
  if (wanted->ys == 0 && named == -2)
    return "one column 'err', 'error' or 'value' is wanted, not two: choose with --y";
  if (wanted->ys == 0 && named >= 0 && named != l->x)
    wrong = add_y(l, named, wanted->values || t->column[named][0] == 'v');
  else if (wanted->ys == 0)
    wrong = other_ys(l, t, wanted->values);
  l->noise = l->ys == 1 ? l->noise : -1;
  return wrong;
}
