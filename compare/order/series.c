/* Series of h and err in files: columns, and rows with the same texts left of h. */
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "compare/order/order.h"
#include "compare/text/memory.h"
#include "compare/tables/tsv.h"
#include "compare/text/values.h"

enum { MAX_Y = 64 };
static const char out_of_memory[] = "out of memory";

struct reader {
  struct series_list *list;
  const struct order_columns *request;
  struct tsv t;
  int first;                  /* series of this file */
  long rows;                  /* of this file */
  int columns;                /* of a row; 0: before the first row */
  double power;               /* h = x^power */
  int x, noise, ys, y[MAX_Y]; /* places of columns, -1: missing; ys: count of y */
  bool values[MAX_Y];
  char name[MAX_Y][COLUMN_NAME]; /* of y; its number without a header */
};

/* Reads a number as in C; nan and inf are allowed, unlike in options. */
static bool read_cell(struct tsv *t, int place, double *value)
{
  const char *text = tsv_number(t, place);
  char *end;
  *value = strtod(text, &end);
  return end != text && *end == '\0';
}

/* Functions that return a text return NULL, or an error with file and line (tsv_at). */

/* Finds the place of the only column with this name; -1: no column has it. An option that names the column may give its
 * number from 1, too, and the column must exist. */
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
  return tsv_at(t, "%sthere is no column '%.100s'%s", option, name, t->columns > 0 ? name_hint(name, t->column) : "");
}

static const char *add_y(struct reader *r, int place, bool values)
{
  struct tsv *t = &r->t;
  for (int i = 0; i < r->ys; i++)
    if (r->y[i] == place)
      return NULL;
  if (r->ys == MAX_Y)
    return tsv_at(t, "more than 64 columns of errors: choose some with --y");
  r->values[r->ys] = values || r->request->values;
  if (t->columns > 0)
    snprintf(r->name[r->ys], COLUMN_NAME, "%s", t->column[place]);
  else
    snprintf(r->name[r->ys], COLUMN_NAME, "column %d", place + 1);
  r->y[r->ys++] = place;
  return NULL;
}

static const char *add_item(struct reader *r, const char *option, const char *name)
{
  int place;
  const char *wrong = find(&place, &r->t, option, name);
  if (wrong)
    return wrong;
  return place == r->x ? tsv_at(&r->t, "%sthis column is x", option) : add_y(r, place, strcmp(name, "value") == 0);
}

static const char *add_list(struct reader *r, const char *list)
{
  const char *wrong = NULL;
  char name[COLUMN_NAME];
  while (!wrong && next_item(name, sizeof name, &list))
    wrong = add_item(r, "--y: ", name);
  return wrong;
}

/* Adds the columns with an expected order by name. */
static const char *add_expected(struct reader *r)
{
  const struct expected_orders *o = r->request->orders;
  const char *wrong = NULL;
  for (int i = 0; i < o->count && o->of[i].name && !wrong; i++) {
    char name[COLUMN_NAME];
    snprintf(name, sizeof name, "%.*s", o->of[i].length, o->of[i].name);
    wrong = add_item(r, o->at_least ? "--at-least: " : "--expect: ", name);
  }
  return wrong;
}

/* Adds each column of numbers right of x except noise and orders. */
static const char *add_others(struct reader *r)
{
  static const char *const orders[] = { "noise", "order", "orders",   "rate",  "rates",
                                        "eoc",   "EOC",   "pairwise", "ratio", NULL };
  struct tsv *t = &r->t;
  const char *wrong = NULL;
  double number;
  for (int i = r->x + 1; i < t->count && !wrong; i++)
    if (read_cell(t, i, &number) && (i >= t->columns || word_place(t->column[i], orders) < 0))
      wrong = add_y(r, i, false);
  return wrong || r->ys > 0 ? wrong : tsv_at(t, "right of h there is no column of numbers: name it with --y");
}

/* Adds the column err, error or value; two of them are an error. */
static const char *add_named(struct reader *r)
{
  static const char *const names[] = { "err", "error", "value", NULL };
  int named = -1;
  for (int i = 0; i < r->t.columns; i++) {
    if (word_place(r->t.column[i], names) < 0)
      continue;
    if (named >= 0)
      return tsv_at(&r->t, "two columns are called 'err', 'error' or 'value': choose one with --y");
    named = i;
  }
  return named >= 0 && named != r->x ? add_y(r, named, r->t.column[named][0] == 'v') : add_others(r);
}

/* Finds the column of h: the requested one, h, or the first one except the unnamed index of pandas. */
static const char *find_x(struct reader *r)
{
  struct tsv *t = &r->t;
  const char *requested = r->request->x, *wrong;
  r->power = r->request->power;
  if (requested && strncmp(requested, "1/", 2) == 0 && word_place(requested, t->column) < 0) {
    requested += 2;
    r->power = -1;
  }
  wrong = requested ? find(&r->x, t, "--x: ", requested) : find(&r->x, t, "", "h");
  if (r->x < 0)
    r->x = t->columns > 1 && *t->column[0] == '\0';
  if (!wrong && r->x >= t->count)
    wrong = tsv_at(t, "this row has no column %d", r->x + 1);
  if (!wrong)
    snprintf(r->list->x, COLUMN_NAME, "%s", r->power != 0 ? "" : t->columns > 0 ? t->column[r->x] : "1");
  return wrong;
}

/* Finds all columns, by the header or, without one, by number; the current row is the first one with data. */
static const char *find_columns(struct reader *r)
{
  const struct order_columns *request = r->request;
  const struct expected_orders *o = request->orders;
  struct tsv *t = &r->t;
  const char *wrong = find_x(r);
  wrong = wrong ? wrong : find(&r->noise, t, "", "noise");
  for (int i = 0; i < request->lists && !wrong; i++)
    wrong = add_list(r, request->y[i]);
  if (request->lists == 0 && !wrong)
    wrong = add_expected(r);
  if (r->ys == 0 && !wrong)
    wrong = add_named(r);
  const int ys = r->ys;
  wrong = wrong ? wrong : add_expected(r);
  if (!wrong && r->ys > ys)
    wrong = tsv_at(t, "an order is expected of a column that --y does not name");
  if (!wrong && o->count > 1 && !o->of[0].name && o->count != r->ys)
    wrong = tsv_at(t, "%d orders are expected, and the columns of errors are %d: choose with --y", o->count, r->ys);
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

/* Returns the series of this name and the i-th y, a new one if necessary; NULL: out of memory, or too many series */
static struct error_series *find_series(struct reader *r, const char *name, int i)
{
  struct series_list *list = r->list;
  for (int k = list->count - 1; k >= r->first; k--)
    if (strcmp(list->series[k].name, name) == 0 && strcmp(list->series[k].y, r->name[i]) == 0)
      return &list->series[k];
  struct error_series *all = list->count < MAX_SERIES ? list_grown(list->series, list->count, sizeof *all) : NULL;
  if (!all)
    return NULL;
  list->series = all;
  struct error_series *s = &all[list->count++];
  *s = (struct error_series){ .file = r->t.name, .place = i, .expected.values = r->values[i] };
  snprintf(s->name, sizeof s->name, "%s", name);
  snprintf(s->y, sizeof s->y, "%s", r->name[i]);
  return s;
}

static bool append(struct error_series *s, struct scallop_order_point point)
{
  struct scallop_order_point *points = list_grown(s->points, s->count, sizeof point);
  if (!points)
    return false;
  s->points = points;
  s->points[s->count++] = point;
  return true;
}

/* Joins the cells left of x that are not numbers. */
static void read_name(char name[SERIES_NAME], struct reader *r)
{
  size_t used = 0;
  double number;
  *name = '\0';
  for (int i = 0; i < r->x && used < SERIES_NAME; i++)
    if (!read_cell(&r->t, i, &number))
      used += (size_t)snprintf(name + used, SERIES_NAME - used, "%s%s", used ? "; " : "", r->t.cell[i]);
}

static const char *read_at(struct reader *r, int place, double *number)
{
  if (place < 0 || read_cell(&r->t, place, number))
    return NULL;
  return tsv_at(&r->t, "column %d: '%.60s' is not a number", place + 1, r->t.cell[place]);
}

/* Adds the point of one y to its series; a missing value is counted. */
static const char *add_point(struct reader *r, const char *name, int i, struct scallop_order_point point)
{
  const bool is_missing = tsv_is_missing(r->t.cell[r->y[i]]);
  const char *wrong = is_missing ? NULL : read_at(r, r->y[i], &point.err);
  if (wrong)
    return wrong;
  if (r->list->rows++ == MAX_ROWS)
    return tsv_at(&r->t, "more than a million rows");
  struct error_series *s = find_series(r, name, i);
  if (!s && r->list->count == MAX_SERIES)
    return tsv_at(&r->t, "more than 4096 series: rows with the same text left of h are one");
  if (s && is_missing)
    s->missing++;
  return s && (is_missing || append(s, point)) ? NULL : tsv_at(&r->t, out_of_memory);
}

static const char *read_row(struct reader *r)
{
  struct scallop_order_point point = { .row = ++r->rows };
  char name[SERIES_NAME];
  const char *wrong = read_at(r, r->x, &point.h);
  if (r->power != 0)
    point.h = pow(point.h, r->power);
  read_name(name, r);
  wrong = wrong ? wrong : read_at(r, r->noise, &point.noise);
  for (int i = 0; i < r->ys && !wrong; i++)
    wrong = add_point(r, name, i, point);
  return wrong || !r->t.fault ? wrong : tsv_at(&r->t, "%s", r->t.fault);
}

/* Reads a row; the first one determines the columns. */
static const char *take_row(struct reader *r)
{
  struct tsv *t = &r->t;
  bool is_first = r->columns == 0;
  char format[80];
  if (t->fault || t->count == 0)
    return tsv_at(t, "%s", t->fault ? t->fault : "this line has no cells");
  if (is_first)
    r->columns = t->columns > 0 ? t->columns : t->count;
  if (t->count != r->columns)
    return tsv_at(t, "%d column%s, and %d above (%s)", t->count, t->count == 1 ? "" : "s", r->columns,
                  tsv_format_text(t, format));
  const char *wrong = is_first ? find_columns(r) : NULL;
  return wrong ? wrong : read_row(r);
}

/* Prints a note about the format and the columns. */
static void note_columns(struct reader *r)
{
  const struct tsv *t = &r->t;
  char format[80], errors[200], x[COLUMN_NAME + 60];
  int used = 0, size = sizeof errors;
  for (int i = 0; i < r->ys && used < size; i++)
    used += snprintf(errors + used, (size_t)(size - used), "%s%s", i > 0 ? ", " : "", r->name[i]);
  used = snprintf(x, sizeof x, "column %d%s%.99s%s", r->x + 1, t->columns > 0 ? " (" : "",
                  t->columns > 0 ? t->column[r->x] : "", t->columns > 0 ? ")" : "");
  if (r->power != 0)
    snprintf(x + used, sizeof x - (size_t)used, " to the power %.3g", r->power);
  complain("order", "note: %s: %s; h is %s, %s: %s; rows: %ld", t->name, tsv_format_text(t, format), x,
           r->request->values ? "values" : "errors", errors, r->rows);
}

/* Joins series of one point each, with another text in every row, to one series a column. False: out of memory */
static bool join_single_points(struct reader *r)
{
  struct error_series *first = r->list->series + r->first;
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

/* Replaces the series of a file by one with the reason why it cannot be read. */
static void add_unread(struct reader *r, const char *why)
{
  while (r->list->count > r->first)
    free(r->list->series[--r->list->count].points);
  *r->name[0] = '\0';
  r->values[0] = false;
  struct error_series *s = find_series(r, "", 0);
  if (!s)
    return;
  s->outcome = UNREAD;
  scallop_order(NULL, &s->count, &(struct scallop_order_wanted){ .order = NAN, .tolerance = 1 }, &s->result);
  snprintf(s->result.reason, sizeof s->result.reason, "%s", why);
}

enum exit_code series_read(struct series_list *list, const char *file, const struct order_columns *columns)
{
  struct reader r = { .list = list, .request = columns, .first = list->count };
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
    wrong = tsv_at_line(&r.t, 0, "no data: it needs lines of 'h err'");
  if (code != EXIT_DONE) {
    complain("order", "%s", wrong);
    add_unread(&r, wrong);
  } else if (!columns->quiet)
    note_columns(&r);
  tsv_close(&r.t);
  return code;
}

/* Returns the expected order of a series, or nan. */
static double order_of(const struct expected_orders *o, const struct error_series *s)
{
  for (int i = 0; i < o->count && o->of[i].name; i++)
    if (strncmp(o->of[i].name, s->y, (size_t)o->of[i].length) == 0 && s->y[o->of[i].length] == '\0')
      return o->of[i].order;
  return o->count == 0 || o->of[0].name ? NAN : o->of[o->count > 1 ? s->place : 0].order;
}

__attribute__((format(printf, 2, 3))) static void add_reason(struct error_series *s, const char *format, ...)
{
  char *const reason = s->result.reason;
  size_t used = strlen(reason);
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(reason + used, sizeof s->result.reason - used, format, arguments);
  va_end(arguments);
}

/* Returns true if h are whole numbers with which the error grows, as it does if they are numbers of cells. */
static bool looks_like_cells(const struct error_series *s)
{
  bool whole = s->result.order < -0.25;
  for (int i = 0; i < s->count && whole; i++)
    whole = s->points[i].h >= 2 && s->points[i].h == floor(s->points[i].h);
  return whole;
}

static void judge(struct error_series *s, const char *x)
{
  const bool expects = !isnan(s->expected.order);
  scallop_order(s->points, &s->count, &s->expected, &s->result);
  const enum scallop_order_verdict verdict = s->result.verdict;
  s->outcome = expects                             ? verdict == SCALLOP_ORDER_PASS ? PASSED : FAILED
               : verdict == SCALLOP_ORDER_MEASURED ? MEASURED
                                                   : NOT_MEASURED;
  if (s->missing > 0)
    add_reason(s, "; rows without a value: %d", s->missing);
  if (*x && looks_like_cells(s))
    add_reason(s, "; h looks like a number of cells: --x 1/%s, or --per", x);
}

void series_judge(struct series_list *list, const struct expected_orders *orders)
{
  for (struct error_series *s = list->series; s < list->series + list->count; s++) {
    s->expected = (struct scallop_order_wanted){ order_of(orders, s), orders->tolerance, orders->at_least,
                                                 s->expected.values };
    if (s->outcome != UNREAD)
      judge(s, list->x);
    s->names[0] = s->name;
    s->names[1] = s->y;
    s->interval = scallop_order_interval_text(s->result.interval);
    s->test = isnan(s->expected.order) ? "none" : orders->at_least ? "at-least" : "equal";
    s->verdict = s->outcome == UNREAD ? "error" : scallop_order_verdict_text(s->result.verdict);
    s->reason = s->result.reason;
    list->outcomes[s->outcome]++;
    list->values |= s->expected.values;
  }
}
