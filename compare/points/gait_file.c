#include "compare/points/gait_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "compare/text/memory.h"
#include "compare/text/message.h"
#include "compare/tables/tsv.h"
#include "compare/text/values.h"

enum { MAX_ROWS = 100000 };
static const char no_memory[] = "out of memory";

/* The places of the columns t and l; or t, x1 and x2 */
struct places {
  int t, l[2];
};
struct recording {
  double *t, *l;
  int count, skipped;
};

static int column_called(const struct tsv *tsv, const char *const *names)
{
  for (int i = 0; i < tsv->columns; i++)
    for (int k = 0; names[k]; k++)
      if (strcasecmp(tsv->column[i], names[k]) == 0)
        return i;
  return -1;
}

/* Finds the columns; without names they are t and l. Returns NULL or the error. */
static const char *find_columns(struct places *c, struct tsv *tsv)
{
  static const char *const times[] = { "t", "time", NULL },
                           *const lengths[] = { "l", "length", "distance", "separation", NULL },
                           *const first[] = { "x1", "x_1", NULL }, *const second[] = { "x2", "x_2", NULL };
  const int t = column_called(tsv, times), l = column_called(tsv, lengths);
  const int bodies[2] = { column_called(tsv, first), column_called(tsv, second) };
  const bool has_bodies = bodies[0] >= 0 && bodies[1] >= 0;
  if (tsv->columns == 0 && (tsv->count == 2 || tsv->count == 0 || tsv->fault))
    return NULL;
  if (tsv->columns == 0)
    return tsv_at(tsv,
                  "%d column%s without a header that names t and l, or t, x1 and x2: expected are two columns, t and l",
                  tsv->count, tsv->count == 1 ? "" : "s");
  if (t < 0 || (l < 0 && !has_bodies))
    return tsv_at_line(tsv, 0, "no columns are named t and l, or t, x1 and x2");
  *c = l >= 0 ? (struct places){ t, { l, -1 } } : (struct places){ t, { bodies[0], bodies[1] } };
  return NULL;
}

/* Returns 1: a number, 0: a missing value, -1: another text. */
static int cell_number(struct tsv *tsv, int column, double *x)
{
  if (column >= tsv->count || tsv_is_missing(tsv->cell[column]) || strcasecmp(tsv->cell[column], "nan") == 0)
    return 0;
  return read_number(tsv_number(tsv, column), x) ? 1 : -1;
}

static const char *read_row(struct recording *r, struct tsv *tsv, const struct places *c)
{
  const int columns[3] = { c->t, c->l[0], c->l[1] };
  double x[3] = { 0 };
  int there = 1;
  if (tsv->fault)
    return tsv_at(tsv, "%s", tsv->fault);
  for (int i = 0; i < (c->l[1] >= 0 ? 3 : 2); i++) {
    int kind = cell_number(tsv, columns[i], &x[i]);
    if (kind < 0)
      return tsv_at(tsv, "column %d, '%.80s', is not a finite number", columns[i] + 1, tsv->cell[columns[i]]);
    there = there && kind;
  }
  if (tsv->fault)
    return tsv_at(tsv, "%s", tsv->fault);
  if (!there) {
    r->skipped++;
    return NULL;
  }
  if (r->count == MAX_ROWS)
    return tsv_at(tsv, "more than %d rows", MAX_ROWS);
  double *t = list_grown(r->t, r->count, sizeof *t);
  r->t = t ? t : r->t;
  double *l = list_grown(r->l, r->count, sizeof *l);
  r->l = l ? l : r->l;
  if (!t || !l)
    return no_memory;
  t[r->count] = x[0];
  l[r->count++] = c->l[1] >= 0 ? x[2] - x[1] : x[1];
  return NULL;
}

static const char *read_rows(struct recording *r, struct tsv *tsv, struct places *c)
{
  const char *wrong = find_columns(c, tsv);
  while (!wrong && tsv_next(tsv))
    wrong = read_row(r, tsv, c);
  return wrong ? wrong : tsv_error(tsv);
}

static void describe_columns(struct gait_file *g, const struct recording *r, const struct tsv *tsv,
                             const struct places *c)
{
  size_t size = sizeof g->columns;
  char format[80], l[60];
  if (c->l[1] < 0)
    snprintf(l, sizeof l, "l column %d", c->l[0] + 1);
  else
    snprintf(l, sizeof l, "l = x2 - x1 columns %d and %d", c->l[1] + 1, c->l[0] + 1);
  int used = snprintf(g->columns, size, "%s: t is column %d, %s", tsv_format_text(tsv, format), c->t + 1, l);
  if (r->skipped > 0)
    snprintf(g->columns + used, size - (size_t)used, "; rows without a number, left out: %d", r->skipped);
}

/* Reads the gait from the table and closes it. Returns NULL or the error. */
static const char *read_table(struct gait_file *g, struct tsv *tsv, bool open, const struct scallop_measured_options *o,
                              const char *text)
{
  struct recording rows = { .count = 0 };
  struct places columns = { 0, { 1, -1 } };
  *g = (struct gait_file){ .measured = NULL };
  const char *wrong = open ? read_rows(&rows, tsv, &columns) : tsv_error(tsv), *why = NULL;
  if (!wrong) {
    describe_columns(g, &rows, tsv, &columns);
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

/* Removes ":KIND", ":KIND=SIGMA" or ":period=P" from the end of name. Returns false if name ends otherwise. */
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

static struct tsv reader; /* static: messages refer to it */

/* Returns the name without the choices behind it; the caller frees it. */
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
