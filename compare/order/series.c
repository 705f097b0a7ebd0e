/* Tables of h and err as files hold them: which columns are which, and the rows with the same texts left of h. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/order/order.h"
#include "compare/text/memory.h"
#include "compare/text/tsv.h"
#include "compare/text/values.h"

enum { MOST_Y = 64 };
static const char out_of_memory[] = "out of memory";

struct reader {
  struct series_list *list;
  const struct columns_wanted *wanted;
  struct tsv t;
  int first;                   /* series of this file                         */
  long rows;                   /* of this file                                */
  int columns;                 /* of a row; 0: the first one is still to come */
  int x, noise, ys, y[MOST_Y]; /* places, -1: there is none; how many y       */
  bool values[MOST_Y];
  char name[MOST_Y][COLUMN_NAME]; /* of y; without a header its number          */
};

/* A number as in C; unlike an option's it may be nan or inf. */
static bool read_cell(const char *text, double *value)
{
  char *end;
  *value = strtod(text, &end);
  return end != text && *end == '\0';
}

/* What is wrong is said with the file and the line (tsv_at); NULL: nothing is. */

/* The place of a column by its name, of which there may be one; -1: there is none. option is what names it. With one it
 * has to be there, by its name or by its number from 1. */
static const char *find(int *place, struct tsv *t, const char *option, const char *name)
{
  long number;
  *place = word_place(name, t->column);
  if (*place >= 0 && word_place(name, t->column + *place + 1) >= 0)
    return tsv_at(t, "%sthe column '%.100s' is there twice", option, name);
  if (*option && *place < 0 && read_count(name, 1, t->count, &number))
    *place = (int)number - 1;
  if (*place >= 0 || !*option)
    return NULL;
  return tsv_at(t, "%sthere is no column '%.100s'%s", option, name, t->columns > 0 ? instead_of(name, t->column) : "");
}

static const char *add_y(struct reader *r, int place, bool values)
{
  struct tsv *t = &r->t;
  for (int i = 0; i < r->ys; i++)
    if (r->y[i] == place)
      return NULL;
  if (r->ys == MOST_Y)
    return tsv_at(t, "more than 64 columns of errors: choose some with --y");
  r->values[r->ys] = values || r->wanted->values;
  if (t->columns > 0)
    snprintf(r->name[r->ys], COLUMN_NAME, "%s", t->column[place]);
  else
    snprintf(r->name[r->ys], COLUMN_NAME, "column %d", place + 1);
  r->y[r->ys++] = place;
  return NULL;
}

static const char *add_list(struct reader *r, const char *list)
{
  const char *wrong = NULL;
  char name[COLUMN_NAME];
  int place;
  while (!wrong && next_item(name, sizeof name, &list)) {
    wrong = find(&place, &r->t, "--y: ", name);
    if (!wrong)
      wrong = place == r->x ? tsv_at(&r->t, "--y: this column is x") : add_y(r, place, strcmp(name, "value") == 0);
  }
  return wrong;
}

/* Each column right of x that holds a number and is neither noise nor an order that the table brings along */
static const char *add_others(struct reader *r)
{
  static const char *const orders[] = { "noise", "order", "orders",   "rate",  "rates",
                                        "eoc",   "EOC",   "pairwise", "ratio", NULL };
  struct tsv *t = &r->t;
  const char *wrong = NULL;
  double number;
  for (int i = r->x + 1; i < t->count && !wrong; i++)
    if (read_cell(t->cell[i], &number) && (i >= t->columns || word_place(t->column[i], orders) < 0))
      wrong = add_y(r, i, false);
  if (wrong || r->ys > 0)
    return wrong;
  return tsv_at(t, "%s",
                t->count == 1 && strchr(t->cell[0], ';')
                    ? "';' separates no columns: blanks, tabs and commas do"
                    : "right of h there is no column of numbers: name it with --y");
}

/* err, error or value; there may be one of them. */
static const char *add_named(struct reader *r)
{
  static const char *const names[] = { "err", "error", "value", NULL };
  int named = -1;
  for (int i = 0; i < r->t.columns; i++) {
    if (word_place(r->t.column[i], names) < 0)
      continue;
    if (named >= 0)
      return tsv_at(&r->t, "one column 'err', 'error' or 'value' is wanted, not two: choose with --y");
    named = i;
  }
  return named >= 0 && named != r->x ? add_y(r, named, r->t.column[named][0] == 'v') : add_others(r);
}

/* The columns, from the header of the table or, where it has none, from the number of columns; the current row is the
 * first one with data. */
static const char *find_columns(struct reader *r)
{
  const struct columns_wanted *wanted = r->wanted;
  struct tsv *t = &r->t;
  const char *wrong = wanted->x ? find(&r->x, t, "--x: ", wanted->x) : find(&r->x, t, "", "h");
  if (r->x < 0) /* the first one, but for the index without a name that pandas writes */
    r->x = t->columns > 1 && *t->column[0] == '\0';
  wrong = wrong ? wrong : find(&r->noise, t, "", "noise");
  for (int i = 0; i < wanted->ys && !wrong; i++)
    wrong = add_list(r, wanted->y[i]);
  if (wanted->ys == 0 && !wrong)
    wrong = add_named(r);
  r->noise = r->ys == 1 ? r->noise : -1;
  return wrong;
}

void series_free(struct series_list *list)
{
  for (int i = 0; i < list->count; i++)
    free(list->series[i].points);
  free(list->series);
  *list = (struct series_list){ 0 };
}

/* The series of that name and the i-th y, a new one if there is none; NULL: out of memory, or too many */
static struct series *series_named(struct reader *r, const char *name, int i)
{
  struct series_list *list = r->list;
  for (int k = list->count - 1; k >= r->first; k--)
    if (strcmp(list->series[k].name, name) == 0 && strcmp(list->series[k].y, r->name[i]) == 0)
      return &list->series[k];
  struct series *all = list->count < MOST_SERIES ? with_room(list->series, list->count, sizeof *all) : NULL;
  if (!all)
    return NULL;
  list->series = all;
  struct series *s = &all[list->count++];
  *s = (struct series){ .file = r->t.name, .wanted.values = r->values[i] };
  snprintf(s->name, sizeof s->name, "%s", name);
  snprintf(s->y, sizeof s->y, "%s", r->name[i]);
  return s;
}

static bool append(struct series *s, struct scallop_order_point point)
{
  struct scallop_order_point *points = with_room(s->points, s->count, sizeof point);
  if (!points)
    return false;
  s->points = points;
  s->points[s->count++] = point;
  return true;
}

/* The cells left of x that are no numbers, joined */
static void read_name(char name[SERIES_NAME], const struct reader *r)
{
  size_t used = 0;
  double number;
  *name = '\0';
  for (int i = 0; i < r->x && used < SERIES_NAME; i++)
    if (!read_cell(r->t.cell[i], &number))
      used += (size_t)snprintf(name + used, SERIES_NAME - used, "%s%s", used ? "; " : "", r->t.cell[i]);
}

static const char *read_at(struct reader *r, int place, double *number)
{
  if (place < 0 || read_cell(r->t.cell[place], number))
    return NULL;
  const char *text = r->t.cell[place], *hint = strpbrk(text, "dD") ? ": an exponent begins with e" : "";
  return tsv_at(&r->t, "column %d: '%.60s' is not a number%s", place + 1, text, hint);
}

/* Of one y: point goes into its series. */
static const char *add_point(struct reader *r, const char *name, int i, struct scallop_order_point point)
{
  const char *wrong = read_at(r, r->y[i], &point.err);
  if (wrong)
    return wrong;
  if (r->list->rows++ == MOST_ROWS)
    return tsv_at(&r->t, "more than a million rows");
  struct series *s = series_named(r, name, i);
  if (!s && r->list->count == MOST_SERIES)
    return tsv_at(&r->t, "more than 4096 series: rows with the same text left of h are one");
  return s && append(s, point) ? NULL : tsv_at(&r->t, out_of_memory);
}

static const char *read_row(struct reader *r)
{
  struct scallop_order_point point = { .row = ++r->rows };
  char name[SERIES_NAME];
  const char *wrong = read_at(r, r->x, &point.h);
  read_name(name, r);
  wrong = wrong ? wrong : read_at(r, r->noise, &point.noise);
  for (int i = 0; i < r->ys && !wrong; i++)
    wrong = add_point(r, name, i, point);
  return wrong;
}

/* The first row that is not the header settles which columns are read. */
static const char *take_row(struct reader *r)
{
  struct tsv *t = &r->t;
  bool is_first = r->columns == 0;
  double number;
  if (t->fault || t->count == 0)
    return tsv_at(t, "%s", t->fault ? t->fault : "this line has commas and no cells");
  if (is_first && t->columns == 0 && !read_cell(t->cell[0], &number))
    return tsv_take_header(t) ? NULL : tsv_at(t, out_of_memory);
  if (is_first)
    r->columns = t->columns > 0 ? t->columns : t->count;
  if (t->count != r->columns)
    return tsv_at(t,
                  "%d columns, and %d above: blanks, tabs and commas separate columns, so numbers have decimal points",
                  t->count, r->columns);
  const char *wrong = is_first ? find_columns(r) : NULL;
  return wrong ? wrong : read_row(r);
}

/* Texts that are different in each row name no series: all rows of a column are one. False: out of memory */
static bool join_single_points(struct reader *r)
{
  struct series *first = r->list->series + r->first;
  const int count = r->list->count - r->first;
  bool joined = true;
  for (int i = 0; i < count; i++)
    if (first[i].count > 1 || count <= r->ys)
      return true;
  for (int i = 0; i < count; i++) {
    *first[i].name = '\0';
    joined = i < r->ys || (joined && append(&first[i % r->ys], first[i].points[0]));
    if (i >= r->ys)
      free(first[i].points);
  }
  r->list->count = r->first + r->ys;
  return joined;
}

/* In place of the series of a file: one that says why there are none */
static void add_unread(struct reader *r, const char *why)
{
  while (r->list->count > r->first)
    free(r->list->series[--r->list->count].points);
  *r->name[0] = '\0';
  r->values[0] = false;
  struct series *s = series_named(r, "", 0);
  if (!s)
    return;
  s->outcome = UNREAD;
  scallop_order(NULL, &s->count, &(struct scallop_order_wanted){ .order = NAN, .tolerance = 1 }, &s->result);
  snprintf(s->result.reason, sizeof s->result.reason, "%s", why);
}

enum exit_code series_read(struct series_list *list, const char *file, const struct columns_wanted *columns)
{
  struct reader r = { .list = list, .wanted = columns, .first = list->count };
  const char *wrong = NULL;
  bool open = tsv_open(&r.t, file, TSV_ANY);
  while (open && !wrong && tsv_next(&r.t))
    wrong = take_row(&r);
  if (!wrong && list->count > r.first && !join_single_points(&r))
    wrong = tsv_at(&r.t, out_of_memory);
  enum exit_code code = r.t.error ? EXIT_FILE : wrong || list->count == r.first ? EXIT_USAGE : EXIT_DONE;
  if (code == EXIT_FILE)
    wrong = tsv_error(&r.t);
  else if (!wrong && code == EXIT_USAGE)
    wrong = tsv_at_line(&r.t, 0, "no data: lines of 'h err' are wanted");
  if (code != EXIT_DONE) {
    complain("order", "%s", wrong);
    add_unread(&r, wrong);
  }
  tsv_close(&r.t);
  return code;
}

void series_judge(struct series_list *list, const struct scallop_order_wanted *wanted)
{
  list->expects = !isnan(wanted->order);
  for (struct series *s = list->series; s < list->series + list->count; s++) {
    bool values = s->wanted.values;
    s->wanted = *wanted;
    s->wanted.values = values;
    if (s->outcome != UNREAD) {
      scallop_order(s->points, &s->count, &s->wanted, &s->result);
      s->outcome = s->result.verdict == (list->expects ? SCALLOP_ORDER_PASS : SCALLOP_ORDER_MEASURED) ? WELL : FAILED;
    }
    s->names[0] = s->name;
    s->names[1] = s->y;
    s->interval = scallop_order_interval_text(s->result.interval);
    s->test = !list->expects ? "none" : wanted->at_least ? "at-least" : "equal";
    s->verdict = s->outcome == UNREAD ? "error" : scallop_order_verdict_text(s->result.verdict);
    s->reason = s->result.reason;
    list->outcomes[s->outcome]++;
    list->values |= values;
  }
}
