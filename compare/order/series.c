#include "compare/order/series.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/memory.h"

enum { NAME = 1024 };
static const char out_of_memory[] = "out of memory";

struct reader {
  struct series_list *list;
  const char *file;
  int first; /* series of this file                                      */
  long rows; /* of this file                                             */
  struct layout layout;
};

static void series_clear(struct series *s)
{
  free(s->name);
  free(s->y);
  free(s->points);
}

void series_free(struct series_list *list)
{
  for (int i = 0; i < list->count; i++)
    series_clear(&list->series[i]);
  free(list->series);
  *list = (struct series_list){ 0 };
}

/* The series of that name and column, a new one if there is none; NULL: out of memory, or too many */
static struct series *series_named(struct reader *r, const char *name, const char *y, bool values)
{
  struct series_list *list = r->list;
  for (int i = list->count - 1; i >= r->first; i--)
    if (strcmp(list->series[i].name, name) == 0 && strcmp(list->series[i].y, y) == 0)
      return &list->series[i];
  struct series *all = list->count < MOST_SERIES ? with_room(list->series, list->count, sizeof *all) : NULL;
  if (!all)
    return NULL;
  list->series = all;
  struct series s = { .file = r->file, .name = strdup(name), .y = strdup(y), .values = values };
  if (!s.name || !s.y) {
    series_clear(&s);
    return NULL;
  }
  all[list->count] = s;
  return &all[list->count++];
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
static void read_name(char name[NAME], char *const *cells, const struct layout *l)
{
  size_t used = 0;
  double number;
  *name = '\0';
  for (int i = 0; i < l->x && used < NAME; i++) {
    bool is_other = i != l->noise;
    for (int k = 0; k < l->ys; k++)
      is_other = is_other && i != l->y[k];
    if (is_other && !read_cell(cells[i], &number))
      used += (size_t)snprintf(name + used, NAME - used, "%s%s", used ? "; " : "", cells[i]);
  }
}

/* Returns NULL, or that a cell is no number. */
static const char *read_at(struct tsv *t, int place, double *number)
{
  static char message[160];
  if (place < 0 || read_cell(t->cell[place], number))
    return NULL;
  snprintf(message, sizeof message, "column %d: '%.60s' is not a number%s", place + 1, t->cell[place],
           strpbrk(t->cell[place], "dD") ? ": an exponent begins with e" : "");
  return message;
}

/* Takes a row in. Returns NULL, or what is wrong with it. */
static const char *read_row(struct tsv *t, struct reader *r)
{
  const struct layout *l = &r->layout;
  if (t->count != l->columns)
    return columns_differ(t, l->columns);
  struct scallop_order_point point = { .row = ++r->rows };
  const char *wrong = read_at(t, l->x, &point.h);
  char name[NAME], y[COLUMN_NAME];
  read_name(name, t->cell, l);
  wrong = wrong ? wrong : read_at(t, l->noise, &point.noise);
  for (int i = 0; i < l->ys && !wrong; i++) {
    wrong = read_at(t, l->y[i], &point.err);
    if (wrong)
      return wrong;
    if (r->list->rows++ == MOST_ROWS)
      return "more than a million rows";
    column_name(y, t, l->y[i]);
    struct series *s = series_named(r, name, y, l->values[i]);
    if (!s)
      return r->list->count == MOST_SERIES ? "more than 4096 series: rows with the same text left of h are one"
                                           : out_of_memory;
    wrong = append(s, point) ? NULL : out_of_memory;
  }
  return wrong;
}

/* Texts that are different in each row name no series: all rows of a column are one. False: out of memory */
static bool join_single_points(struct reader *r)
{
  struct series *first = r->list->series + r->first;
  int count = r->list->count - r->first, columns = r->layout.ys;
  for (int i = 0; i < count; i++)
    if (first[i].count > 1)
      return true;
  bool joined = true;
  for (int i = columns; i < count; i++) {
    joined = joined && append(&first[i % columns], first[i].points[0]);
    series_clear(&first[i]);
  }
  r->list->count = r->first + (count < columns ? count : columns);
  for (int i = 0; i < columns && i < count; i++)
    if (count > columns)
      *first[i].name = '\0';
  return joined;
}

/* The first row that is not the header settles which columns are read. */
static const char *take_row(struct tsv *t, struct reader *r, const struct columns_wanted *wanted, bool *is_first)
{
  double number;
  if (t->fault || t->count == 0)
    return t->fault ? t->fault : "this line has commas and no cells";
  if (*is_first && t->columns == 0 && !read_cell(t->cell[0], &number))
    return tsv_take_header(t) ? NULL : out_of_memory;
  const char *wrong = *is_first ? columns_find(&r->layout, t, wanted) : NULL;
  *is_first = false;
  return wrong ? wrong : read_row(t, r);
}

/* In place of the series of a file: one that says why there are none */
static void add_unread(struct reader *r, const char *why)
{
  while (r->list->count > r->first)
    series_clear(&r->list->series[--r->list->count]);
  struct series *s = series_named(r, "", "", false);
  if (!s)
    return;
  s->unread = true;
  scallop_order(NULL, &s->count, &(struct scallop_order_wanted){ .order = NAN, .tolerance = 1 }, &s->result);
  snprintf(s->result.reason, sizeof s->result.reason, "%s", why);
}

enum exit_code series_read(struct series_list *list, const char *command, const char *file,
                           const struct columns_wanted *wanted)
{
  struct tsv t;
  struct reader r = { .list = list, .first = list->count };
  const char *wrong = NULL;
  bool is_first = true;
  bool open = tsv_open(&t, file, TSV_ANY);
  r.file = t.name;
  while (open && !wrong && tsv_next(&t))
    wrong = take_row(&t, &r, wanted, &is_first);
  if (!wrong && list->count > r.first && !join_single_points(&r))
    wrong = out_of_memory;
  const char *failure = tsv_error(&t);
  enum exit_code code = failure ? EXIT_FILE : wrong || list->count == r.first ? EXIT_USAGE : EXIT_DONE;
  if (code == EXIT_USAGE)
    failure = wrong ? tsv_at(&t, "%s", wrong) : tsv_at_line(&t, 0, "no data: lines of 'h err' are wanted");
  if (code != EXIT_DONE) {
    complain(command, "%s", failure);
    add_unread(&r, failure);
  }
  tsv_close(&t);
  return code;
}
