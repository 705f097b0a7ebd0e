#define _DEFAULT_SOURCE /* strsep */
#include "compare/command/plot_data.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/command/compare.h"
#include "compare/text/lines.h"

enum { MOST_CELLS = 256, MOST_BY = 1024, NONE = -1 };

struct reader {
  const struct plot *plot;
  const char *command;
  struct plot_data *data;
  struct lines lines;
  char *cells[MOST_CELLS];
  int columns; /* 0: the header is not read yet */
  int x, y[PLOT_QUANTITIES], by[PLOT_BY], bys;
  long rows;
};

static bool out_of_memory(const struct reader *r)
{
  complain(r->command, "cannot draw %s: out of memory", r->plot->file);
  return false;
}

/* ---- the header ---- */

/* What else there is: the column that was meant, or all of them */
static void suggest(const struct reader *r, const char *name, char *text, size_t size)
{
  const char *names[MOST_CELLS + 1] = { NULL };
  for (int i = 0; i < r->columns; i++)
    names[i] = r->cells[i];
  const char *near = nearest(name, names);
  size_t used = (size_t)snprintf(text, size, near ? "did you mean '%s'?" : "there are %s", near ? near : names[0]);
  for (int i = 1; !near && i < r->columns && used < size; i++)
    used += (size_t)snprintf(text + used, size - used, ", %s", names[i]);
}

static void complain_of_column(const struct reader *r, const char *name)
{
  char suggestion[400];
  suggest(r, name, suggestion, sizeof suggestion);
  if (r->cells[0][0] == '{')
    complain(r->command, "cannot draw %s: %s is no table in TSV: it begins with '{'", r->plot->file, r->plot->table);
  else
    complain(r->command, "cannot draw %s: %s has no column '%s': %s", r->plot->file, r->plot->table, name, suggestion);
}

static bool find_column(struct reader *r, const char *name, int *place)
{
  for (*place = 0; *place < r->columns; ++*place)
    if (strcmp(r->cells[*place], name) == 0)
      return true;
  complain_of_column(r, name);
  return false;
}

/* The columns of by, whose names are separated by commas; one whose own name has a comma is found first. */
static bool find_by(struct reader *r)
{
  char names[MOST_BY], *rest = names;
  const char *by = r->plot->by;
  if (!by)
    return true;
  for (int i = 0; i < r->columns; i++)
    if (strcmp(r->cells[i], by) == 0) {
      r->by[r->bys++] = i;
      return true;
    }
  snprintf(names, sizeof names, "%s", by);
  for (char *name; (name = strsep(&rest, ",")) && r->bys < PLOT_BY; r->bys++)
    if (!find_column(r, name + strspn(name, " "), &r->by[r->bys]))
      return false;
  return true;
}

static bool take_header(struct reader *r)
{
  r->columns = lines_cells(r->lines.line, r->cells, MOST_CELLS);
  if (!find_column(r, r->plot->x, &r->x) || !find_by(r))
    return false;
  for (int i = 0; i < r->data->quantities; i++)
    if (!find_column(r, r->plot->y[i], &r->y[i]))
      return false;
  return true;
}

/* ---- rows ---- */

/* The number in a cell; nan where it is none that the axis can show */
static double shown_number(const char *cell, bool logarithmic)
{
  char *end;
  double number = strtod(cell, &end);
  bool shown = end != cell && *end == '\0' && isfinite(number) && (!logarithmic || number > 0);
  return shown ? number : NAN;
}

static bool add_point(struct plot_data *data, struct plot_curve *c, double x, double y)
{
  bool shown = !isnan(x) && !isnan(y);
  if (!shown && (c->count == 0 || isnan(c->points[c->count - 1].x)))
    return true;
  if (c->count == c->room) {
    long room = c->room > 0 ? 2 * c->room : 16;
    struct plot_point *points = realloc(c->points, (size_t)room * sizeof *points);
    if (!points)
      return false;
    c->points = points;
    c->room = room;
  }
  c->points[c->count++] = shown ? (struct plot_point){ x, y } : (struct plot_point){ NAN, NAN };
  if (shown) {
    c->shown++;
    data->least = (struct plot_point){ fmin(data->least.x, x), fmin(data->least.y, y) };
    data->most = (struct plot_point){ fmax(data->most.x, x), fmax(data->most.y, y) };
  }
  return true;
}

/* The place of a value of the column by, a new one where it is the first; or NONE, with a message. */
static int place_of_value(struct reader *r, const char *text)
{
  struct plot_data *data = r->data;
  for (int i = 0; i < data->values; i++)
    if (strcmp(data->value[i], text) == 0)
      return i;
  if (data->values == PLOT_VALUES) {
    complain(r->command, "cannot draw %s: column '%s' of %s has more than %d values, and each is to have a curve",
             r->plot->file, r->plot->by, r->plot->table, PLOT_VALUES);
    return NONE;
  }
  data->value[data->values] = strdup(text);
  if (data->value[data->values])
    return data->values++;
  out_of_memory(r);
  return NONE;
}

static bool take_row(struct reader *r)
{
  int count = lines_cells(r->lines.line, r->cells, MOST_CELLS);
  if (count != r->columns) {
    complain(r->command, "cannot draw %s: %s:%ld: a row of %d cells, where the header has %d", r->plot->file, r->plot->table,
             r->lines.number, count, r->columns);
    return false;
  }
  char values[MOST_BY] = "";
  size_t used = 0;
  for (int i = 0; i < r->bys && used < sizeof values; i++)
    used += (size_t)snprintf(values + used, sizeof values - used, "%s%s", i > 0 ? ", " : "", r->cells[r->by[i]]);
  int value = place_of_value(r, values);
  if (value == NONE)
    return false;
  double x = shown_number(r->cells[r->x], r->plot->log_x);
  for (int i = 0; i < r->data->quantities; i++)
    if (!add_point(r->data, &r->data->curves[value][i], x, shown_number(r->cells[r->y[i]], r->plot->log_y)))
      return out_of_memory(r);
  r->rows++;
  return true;
}

static bool take_line(struct reader *r)
{
  const char *fault = line_fault(&r->lines);
  if (fault) {
    complain(r->command, "cannot draw %s: %s:%ld: %s", r->plot->file, r->plot->table, r->lines.number, fault);
    return false;
  }
  if (r->lines.length == 0 || r->lines.line[0] == '#')
    return true;
  return r->columns > 0 ? take_row(r) : take_header(r);
}

/* ---- the whole ---- */

static const char *axis_kind(bool logarithmic) { return logarithmic ? "positive number" : "number"; }

static bool has_points(const struct reader *r)
{
  const struct plot *p = r->plot;
  bool one = p->y && r->data->quantities == 1;
  if (isfinite(r->data->least.x))
    return true;
  if (r->rows == 0)
    complain(r->command, "nothing to draw in %s: %s has no rows", p->file, p->table);
  else
    complain(r->command, "nothing to draw in %s: no row of %s has a %s in '%s' and a %s in %s%s%s", p->file, p->table,
             axis_kind(p->log_x), p->x, axis_kind(p->log_y), one ? "'" : "", one ? *p->y : "any column y", one ? "'" : "");
  return false;
}

static bool read_lines(struct reader *r)
{
  r->lines.file = fopen(r->plot->table, "r");
  bool good = r->lines.file != NULL;
  int error = errno;
  while (good && next_line(&r->lines))
    good = take_line(r);
  if (r->lines.error) {
    good = false;
    error = r->lines.error;
  }
  if (!r->lines.file || r->lines.error)
    complain(r->command, "cannot draw %s: cannot read %s: %s", r->plot->file, r->plot->table, strerror(error));
  if (r->lines.file)
    fclose(r->lines.file);
  lines_free(&r->lines);
  return good && has_points(r);
}

/* Of the columns y; 0: there are none, or too many, with a message */
static int count_quantities(const struct plot *plot, const char *command)
{
  int count = 0;
  while (plot->x && plot->y && count <= PLOT_QUANTITIES && plot->y[count])
    count++;
  if (count == 0)
    complain(command, "cannot draw %s: without a script it needs a column x and columns y", plot->file);
  else if (count > PLOT_QUANTITIES)
    complain(command, "cannot draw %s: more than %d columns y", plot->file, PLOT_QUANTITIES);
  return count <= PLOT_QUANTITIES ? count : 0;
}

bool plot_data_read(struct plot_data *data, const struct plot *plot, const char *command)
{
  *data = (struct plot_data){ .quantities = count_quantities(plot, command),
                              .least = { INFINITY, INFINITY },
                              .most = { -INFINITY, -INFINITY } };
  struct reader r = { .plot = plot, .command = command, .data = data };
  bool read = data->quantities > 0 && read_lines(&r);
  if (!read)
    plot_data_free(data);
  return read;
}

void plot_data_free(struct plot_data *data)
{
  for (int i = 0; i < data->values; i++) {
    free(data->value[i]);
    for (int j = 0; j < data->quantities; j++)
      free(data->curves[i][j].points);
  }
  *data = (struct plot_data){ .values = 0 };
}
