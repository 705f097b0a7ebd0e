#include "compare/points/gait_file.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/memory.h"
#include "compare/text/message.h"
#include "compare/text/tsv.h"
#include "compare/text/values.h"

enum { MOST_ROWS = 100000 };
static const char no_memory[] = "out of memory";

/* Columns of t and of what l is: l itself, or x1 and x2 */
struct columns {
  int t, l[2];
};
struct rows {
  double *t, *l;
  int count, left_out;
};

/* "Time [s]" is t: the word before a unit in brackets, without regard to capitals */
static bool is_called(const char *cell, const char *const *names)
{
  char word[24];
  size_t length = 0;
  while (isspace((unsigned char)*cell) || *cell == '"')
    cell++;
  while (length + 1 < sizeof word && (isalnum((unsigned char)cell[length]) || cell[length] == '_')) {
    word[length] = (char)tolower((unsigned char)cell[length]);
    length++;
  }
  word[length] = '\0';
  return word_place(word, names) >= 0;
}

static int column_called(const struct tsv *tsv, const char *const *names)
{
  for (int i = 0, column = 0; i < tsv->count; i++) {
    if (is_called(tsv->cell[i], names))
      return column;
    column += *tsv->cell[i] != '[' && *tsv->cell[i] != '('; /* a unit that stands alone between blanks */
  }
  return -1;
}

/* False: this row is no header. */
static bool take_header(struct columns *c, const struct tsv *tsv)
{
  static const char *const times[] = { "t", "time", NULL },
                           *const lengths[] = { "l", "length", "distance", "separation", NULL },
                           *const first[] = { "x1", "x_1", NULL }, *const second[] = { "x2", "x_2", NULL };
  const struct columns found = { column_called(tsv, times), { column_called(tsv, lengths), -1 } };
  const int bodies[2] = { column_called(tsv, first), column_called(tsv, second) };
  if (found.t < 0 || (found.l[0] < 0 && (bodies[0] < 0 || bodies[1] < 0)))
    return false;
  *c = found.l[0] >= 0 ? found : (struct columns){ found.t, { bodies[0], bodies[1] } };
  return true;
}

/* 1: a number, 0: none is there, -1: something else is. */
static int cell_number(const struct tsv *tsv, int column, double *x)
{
  static const char *const none[] = { "", "nan", "na", "null", "-", NULL };
  if (column >= tsv->count)
    return 0;
  return read_number(tsv->cell[column], x) ? 1 : is_called(tsv->cell[column], none) ? 0 : -1;
}

static const char *read_row(struct rows *r, struct tsv *tsv, const struct columns *c)
{
  const int columns[3] = { c->t, c->l[0], c->l[1] };
  double x[3] = { 0 };
  int there = 1;
  if (tsv->fault)
    return tsv_at(tsv, "%s", tsv->fault);
  for (int i = 0; i < (c->l[1] >= 0 ? 3 : 2); i++) {
    int kind = cell_number(tsv, columns[i], &x[i]);
    if (kind < 0)
      return tsv_at(tsv, "column %d, '%.80s', is not allowed: a finite number is wanted", columns[i] + 1,
                    tsv->cell[columns[i]]);
    there = there && kind;
  }
  if (!there) {
    r->left_out++;
    return NULL;
  }
  if (r->count == MOST_ROWS)
    return tsv_at(tsv, "more than %d rows", MOST_ROWS);
  double *t = with_room(r->t, r->count, sizeof *t);
  r->t = t ? t : r->t;
  double *l = with_room(r->l, r->count, sizeof *l);
  r->l = l ? l : r->l;
  if (!t || !l)
    return no_memory;
  t[r->count] = x[0];
  l[r->count++] = c->l[1] >= 0 ? x[2] - x[1] : x[1];
  return NULL;
}

static const char *read_rows(struct rows *r, struct tsv *tsv, struct columns *c)
{
  const char *wrong = NULL;
  for (bool first = true; !wrong && tsv_next(tsv); first = false)
    if (first && take_header(c, tsv))
      continue;
    else if (first && tsv->count != 2 && !tsv->fault)
      wrong = tsv_at(tsv, "%d column%s without a header that names t and l, or t, x1 and x2: two are wanted, t and l",
                     tsv->count, tsv->count == 1 ? "" : "s");
    else
      wrong = read_row(r, tsv, c);
  return wrong ? wrong : tsv_error(tsv);
}

static void tell_columns(struct gait_file *g, const struct rows *r, const struct columns *c)
{
  size_t size = sizeof g->columns;
  int used = c->l[1] < 0 ? snprintf(g->columns, size, "t is column %d, l column %d", c->t + 1, c->l[0] + 1)
                         : snprintf(g->columns, size, "t is column %d, l = x2 - x1 columns %d and %d", c->t + 1,
                                    c->l[1] + 1, c->l[0] + 1);
  if (r->left_out > 0)
    snprintf(g->columns + used, size - (size_t)used, "; rows without a number, left out: %d", r->left_out);
}

/* Of the open table, which is closed. */
static const char *read_table(struct gait_file *g, struct tsv *tsv, bool open, const struct scallop_measured_options *o,
                              const char *text)
{
  struct rows rows = { .count = 0 };
  struct columns columns = { 0, { 1, -1 } };
  *g = (struct gait_file){ .measured = NULL };
  tsv->style = TSV_ANY;
  const char *wrong = open ? read_rows(&rows, tsv, &columns) : tsv_error(tsv), *why = NULL;
  if (!wrong) {
    tell_columns(g, &rows, &columns);
    g->measured = scallop_measured_new(rows.t, rows.l, rows.count, o, text, &why);
    wrong = g->measured ? NULL : tsv_at_line(tsv, 0, "%s", why);
  }
  if (!wrong)
    g->best = scallop_measured_gait(g->measured, SCALLOP_MEASURED_BEST);
  free(rows.t);
  free(rows.l);
  tsv_close(tsv);
  return wrong;
}

/* Takes ":KIND", ":KIND=SIGMA" or ":period=P" off the end of name. False: there is none, or it is part of the name. */
static bool take_choice(char *name, struct scallop_measured_options *o)
{
  char *colon = strrchr(name, ':'), *number = colon ? strchr(colon, '=') : NULL;
  double x = 0;
  if (!colon || (number && (!read_number(number + 1, &x) || !(x > 0))))
    return false;
  *(number ? number : colon) = '\0';
  int kind = word_place(colon + 1, scallop_fit_names);
  bool is_period = number && strcmp(colon + 1, "period") == 0;
  if (number)
    *number = '=';
  if (!is_period && (kind < 0 || (number && kind < SCALLOP_FIT_SMOOTH))) {
    *colon = ':';
    return false;
  }
  if (is_period)
    o->period = x;
  else
    *o = (struct scallop_measured_options){ (enum scallop_fit)kind, x, o->period };
  *colon = '\0';
  return true;
}

static struct tsv reader; /* has the message */

/* The name without the choices behind it, to be freed */
static char *without_choices(const char *name, struct scallop_measured_options *options)
{
  char *file = strdup(name);
  while (file && take_choice(file, options))
    continue;
  return file;
}

const char *gait_file_read(struct gait_file *gait, const char *name, const char *text, bool *unreadable)
{
  struct scallop_measured_options options = { .sigma = 0 };
  char *file = without_choices(name, &options);
  if (!file)
    return no_memory;
  bool open = tsv_open(&reader, strcmp(file, "-") == 0 ? "./-" : file, TSV_ANY);
  const char *wrong = read_table(gait, &reader, open, &options, text);
  *unreadable = reader.error != 0;
  free(file);
  return wrong;
}

const char *gait_file_of_table(struct gait_file *gait, const char *name, const char *table, const char *text)
{
  struct scallop_measured_options options = { .sigma = 0 };
  char *file = without_choices(name, &options);
  bool open = file && tsv_open_text(&reader, file, table);
  const char *wrong = file ? read_table(gait, &reader, open, &options, text) : no_memory;
  free(file);
  return wrong;
}

void gait_file_free(struct gait_file *g)
{
  scallop_measured_free(g->measured);
  *g = (struct gait_file){ .measured = NULL };
}
