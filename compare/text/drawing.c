/* Which kind of table is drawn how: the names of its columns tell the kind, and its rows what varies. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/message.h"
#include "compare/text/plot.h"
#include "compare/text/shipped.h"
#include "compare/text/tsv.h"
#include "compare/text/values.h"

#define PARAMETERS "T", "alpha", "F1", "F2", "m1", "m2", "L", "gait"

/* What is drawn of a table, by what it is of (struct table); of several rows the first whose first column of y there
 * is. Lists end with NULL. A name that ends in '.' stands for the columns that begin so. */
static const struct drawing {
  const char *of;
  const char *program;               /* a script of scripts/plots/                                          */
  const char *x;                     /* NULL: that of vary which varies most                                */
  const char *vary[12];              /* and a curve is of each value of the others of them that vary        */
  const char *y[PLOT_COLUMNS + 1];   /* columns                                                             */
  const char *by[PLOT_COLUMNS + 1];  /* a curve is of each of their values                                  */
  enum { AS_IS, LOG_Y, LOG_XY } log; /* as the values ask for it, or logarithmic whatever they are          */
  bool map;          /* the head has the axes                                                              */
  bool magnitudes;   /* are drawn                                                                          */
  const char *over;  /* the column that y is divided by                                                    */
  const char *limit; /* the head has this text, and behind it a number that is a limit                    */
} drawings[] = {
  { .of = "trajectory", .program = "curves", .x = "t", .y = { "x1", "x2", "xC" } },
  { .of = "order",
    .program = "curves",
    .x = "h",
    .y = { "err" },
    .by = { "file", "series", "y" },
    .log = LOG_XY,
    .magnitudes = true },
  { .of = "derived",
    .program = "curves",
    .x = "power",
    .y = { "error" },
    .by = { "phase", "quantity" },
    .log = LOG_Y,
    .magnitudes = true },
  { .of = "published", .program = "dots", .y = { "error" }, .by = { "formula", "phase", "quantity" }, .over = "exact" },
  { .of = "bounds", .program = "dots", .y = { "bound" }, .by = { "quantity" } },
  { .of = "breakdown", .program = "reach", .x = "T" },
  { .of = "boundaries", .map = true, .program = "boundaries" },
  { .of = "map", .map = true, .program = "map", .y = { "modes" } },
  { .of = "workprec", .program = "workprec", .x = "time_median", .y = { "error" } },
  { .of = "stress",
    .program = "dots",
    .y = { "units", "rounding", "perturbed" },
    .by = { "family", "gait" },
    .limit = "promised, in units: error " },
  { .of = "stress of a point", .program = "dots", .y = { "units", "rounding", "perturbed" }, .by = { "quantity" } },
  { .of = "stiff",
    .program = "curves",
    .x = "delta",
    .y = { "displacement_error" },
    .by = { "scene", "gait", "stepper" },
    .log = LOG_XY,
    .magnitudes = true },
  { .of = "stiff orders",
    .program = "dots",
    .y = { "order", "order_low", "order_high" },
    .by = { "scene", "gait", "stepper", "quantity" } },
  { .of = "phase", .program = "curves", .vary = { PARAMETERS, "phase", "v0" }, .y = { "dxC" } },
  { .of = "steady", .program = "curves", .vary = { PARAMETERS }, .y = { "mean_velocity" } },
  { .of = "series",
    .program = "curves",
    .vary = { PARAMETERS, "v0" },
    .y = { "relative." },
    .log = LOG_XY,
    .magnitudes = true },
  { .of = "series", .program = "curves", .vary = { PARAMETERS, "v0" }, .y = { "text_steady_xC" } },
  { .of = NULL,
    .program = "curves",
    .vary = { PARAMETERS, "phase", "v0" } }, /* any other: y is named, and x where nothing varies */
};
enum { MANY = 32, TITLE = 112 };

/* What is in a column: how many different values, at most MANY, and from where to where its numbers go. */
struct content {
  int count;
  char *value[MANY];
  double least, most;
};

struct seen {
  struct plot *plot;
  const char *command;
  struct tsv tsv;
  struct content *content; /* one for each column */
  double limit;            /* what the head says of limits */
};

static bool refuse(const struct seen *s, const char *what, const char *name)
{
  return complain(s->command, "cannot draw %s: %s%s", s->plot->file, what, name);
}

static void take_cell(struct content *c, const char *cell)
{
  double number;
  int i = c->count == MANY ? MANY : 0; /* of more nothing is asked */
  while (i < c->count && c->value[i] && strcmp(c->value[i], cell) != 0)
    i++;
  if (i == c->count && i < MANY)
    c->value[c->count++] = strdup(cell);
  if (read_number(cell, &number)) {
    c->least = fmin(c->least, number);
    c->most = fmax(c->most, number);
  }
}

static bool look_at_rows(struct seen *s)
{
  long rows = 0;
  if (!tsv_next(&s->tsv) || !tsv_take_header(&s->tsv))
    return refuse(s, "the table has no columns", "");
  s->content = calloc((size_t)s->tsv.columns, sizeof *s->content);
  for (int i = 0; s->content && i < s->tsv.columns; i++)
    s->content[i] = (struct content){ .least = INFINITY, .most = -INFINITY };
  for (; s->content && tsv_next(&s->tsv); rows++)
    for (int i = 0; i < s->tsv.columns && i < s->tsv.count; i++)
      take_cell(&s->content[i], s->tsv.cell[i]);
  return s->content ? rows > 0 || refuse(s, "the table has no rows", "") : refuse(s, "out of memory", "");
}

static const struct content *content_of(const struct seen *s, const char *column)
{
  int place = column ? tsv_column(&s->tsv, column) : -1;
  return place < 0 ? NULL : &s->content[place];
}

/* The columns that a name stands for, at most PLOT_COLUMNS; NULL-terminated. Returns how many. */
static int columns_of(const struct seen *s, const char *name, const char *columns[PLOT_COLUMNS + 1])
{
  size_t length = strlen(name);
  bool many = length > 0 && name[length - 1] == '.';
  int count = 0;
  for (int i = 0; i < s->tsv.columns && count < PLOT_COLUMNS; i++)
    if (many ? strncmp(s->tsv.column[i], name, length) == 0 : strcmp(s->tsv.column[i], name) == 0)
      columns[count++] = s->tsv.column[i];
  columns[count] = NULL;
  return count;
}

/* What stands behind begin in the '#' line of the head that begins so, until the next call; NULL: no line does. */
static const char *in_head(const struct seen *s, const char *begin)
{
  static char line[1024];
  size_t length = strlen(begin);
  bool found = false;
  FILE *table = fopen(s->plot->table, "r");
  while (table && !found && fgets(line, sizeof line, table) && *line == '#')
    found = strncmp(line + 2, begin, length) == 0;
  if (table)
    fclose(table);
  line[strcspn(line, "\n")] = '\0';
  return found ? line + 2 + length : NULL;
}

/* A picture of all of a table, which has no columns y, is not that of those that are named. */
static bool is_drawn_by(const struct seen *s, const struct drawing *d)
{
  const char *columns[PLOT_COLUMNS + 1];
  return !d->of
         || (strcmp(d->of, s->plot->of) == 0
             && (d->map || (d->y[0] ? columns_of(s, d->y[0], columns) > 0 : !s->plot->y[0])));
}

static const struct drawing *drawing_of(const struct seen *s)
{
  const struct drawing *d = drawings;
  while (!is_drawn_by(s, d))
    d++;
  return d;
}

/* A limit, and the parameters that hold, which are the title where none is given */
static void read_head(struct seen *s, const struct drawing *d)
{
  static char title[TITLE];
  const char *limit = d->limit ? in_head(s, d->limit) : NULL;
  if (limit)
    s->limit = strtod(limit, NULL);
  const char *parameters = s->plot->title ? NULL : in_head(s, "parameters: ");
  if (parameters) {
    snprintf(title, sizeof title, "%.*s", TITLE - 1, parameters);
    s->plot->title = title;
  }
}

/* The parameters that are the same in all rows, as a title */
static void title_of_held(const struct seen *s)
{
  static const char *const names[] = { "m1", "m2", "F1", "F2", "L", "T", "alpha", "gait", NULL };
  static char title[TITLE];
  size_t used = 0;
  for (const char *const *name = names; *name; name++) {
    const struct content *c = content_of(s, *name);
    if (c && c->count == 1 && c->value[0] && used < sizeof title)
      used += (size_t)snprintf(title + used, sizeof title - used, "%s%s=%s", used > 0 ? " " : "", *name, c->value[0]);
  }
  if (used > 0 && !s->plot->title)
    s->plot->title = title;
}

static void choose_varied(const struct seen *s, const struct drawing *d)
{
  struct plot *p = s->plot;
  int most = 1, bys = 0;
  for (const char *const *name = d->vary; !p->x && *name; name++) {
    const struct content *c = content_of(s, *name);
    bool more = c && c->count > most && c->least < c->most;
    most = more ? c->count : most;
    if (more)
      s->plot->x = *name;
  }
  for (const char *const *name = d->vary; p->x && !p->by[0] && *name && bys < PLOT_COLUMNS; name++) {
    const struct content *c = content_of(s, *name);
    if (c && c->count > 1 && strcmp(*name, p->x) != 0)
      s->plot->by[bys++] = *name;
  }
}

static bool is_wide(const struct content *c, double factor)
{
  return c && c->least > 0 && c->most >= factor * c->least;
}

/* "# x: F1/F2 from 0.01 to 100, 41 values, log", and y: the axes of a map */
static void choose_map(const struct seen *s)
{
  static char axis[2][TITLE];
  struct plot *p = s->plot;
  for (int i = 0; i < 2; i++) {
    const char *line = in_head(s, i == 0 ? "x: " : "y: ");
    snprintf(axis[i], sizeof axis[i], "%.*s", line ? (int)strcspn(line, " ") : 0, line ? line : "");
    *(i == 0 ? &p->x : &p->by[0]) = axis[i];
    *(i == 0 ? &p->log_x : &p->log_y) = line && strlen(line) > 5 && strcmp(line + strlen(line) - 5, ", log") == 0;
  }
}

static void choose_axes(const struct seen *s, const struct drawing *d)
{
  enum { OF_X = 30, OF_Y = 1000 };
  struct plot *p = s->plot;
  bool wide = p->y[0] != NULL;
  for (const char *const *y = p->y; *y; y++)
    wide = wide && is_wide(content_of(s, *y), OF_Y);
  p->log_x = p->x_range.is_given ? p->x_range.is_log : d->log == LOG_XY || is_wide(content_of(s, p->x), OF_X);
  p->log_y = p->y_range.is_given ? p->y_range.is_log : d->log != AS_IS || wide;
}

/* The columns that are drawn; where a name of a drawing stands for some of the table, copies of theirs */
static void choose_y(const struct seen *s, const struct drawing *d)
{
  static char copies[PLOT_COLUMNS][TITLE];
  const char *columns[PLOT_COLUMNS + 1];
  struct plot *p = s->plot;
  memcpy(p->y, d->y, sizeof p->y);
  if (d->y[0] && d->y[0][strlen(d->y[0]) - 1] == '.')
    for (int i = columns_of(s, d->y[0], columns); i-- > 0; p->y[i] = copies[i])
      snprintf(copies[i], TITLE, "%s", columns[i]);
}

/* Of columns that only name a curve those count that are not the same in all rows. */
static void choose_names(const struct seen *s, const struct drawing *d)
{
  int bys = 0;
  bool is_curves = strcmp(d->program, "curves") == 0;
  for (const char *const *name = d->by; !s->plot->by[bys] && *name; name++) {
    const struct content *c = content_of(s, *name);
    if (!is_curves || !c || c->count > 1)
      s->plot->by[bys++] = *name;
  }
}

static bool has_columns(const struct seen *s, const char *const *names)
{
  for (; *names; names++)
    if (!content_of(s, *names))
      return refuse(s, "the table has no column ", *names);
  return true;
}

static bool choose(struct seen *s)
{
  struct plot *p = s->plot;
  const struct drawing *d = drawing_of(s);
  if (d->map && (p->x || p->by[0]))
    return refuse(s, "the axes of a map are those of --map", "");
  if (d->map && p->y[0] && p->y[1])
    return refuse(s, "a map shows one column", "");
  p->program = shipped_text(shipped_scripts, d->program);
  p->x = p->x ? p->x : d->x;
  if (!p->y[0])
    choose_y(s, d);
  choose_names(s, d);
  read_head(s, d);
  title_of_held(s);
  if (d->map)
    choose_map(s);
  else
    choose_varied(s, d);
  if (!p->x && d->vary[0] && d->of)
    return refuse(s, "no parameter varies: a curve needs several points: --T 0.1:1:20, or --points FILE", "");
  if (!d->of && (!p->x || !p->y[0]))
    return refuse(s, "--plot-x NAME and --plot-y NAME choose the columns of this table", "");
  if (!d->map)
    choose_axes(s, d);
  p->magnitudes = d->magnitudes && p->log_y;
  p->over = d->over;
  p->limit = s->limit;
  const char *const x[] = { p->x, NULL };
  return has_columns(s, x) && has_columns(s, p->y) && has_columns(s, p->by);
}

/* A list with commas between its names. False: a name is empty, or there are too many. */
static bool read_names(const char *names[PLOT_COLUMNS + 1], char *text)
{
  int count = 0;
  for (char *name = text, *comma; name; name = comma ? comma + 1 : NULL) {
    comma = strchr(name, ',');
    if (comma)
      *comma = '\0';
    if (count == PLOT_COLUMNS || *name == '\0')
      return false;
    names[count++] = name;
  }
  names[count] = NULL;
  return true;
}

/* FROM:TO, FROM:TO:log or FROM:TO:linear */
static bool read_range(struct plot_range *range, char *text)
{
  struct plot_range r = { .is_given = true };
  char *to = strchr(text, ':'), *kind = to ? strchr(to + 1, ':') : NULL;
  if (!to)
    return false;
  *to++ = '\0';
  if (kind)
    *kind++ = '\0';
  r.is_log = kind && strcmp(kind, "log") == 0;
  if ((kind && !r.is_log && strcmp(kind, "linear") != 0) || !read_number(text, &r.low) || !read_number(to, &r.high)
      || !(r.low < r.high) || (r.is_log && !(r.low > 0)))
    return false;
  *range = r;
  return true;
}

static bool read_size(struct plot *p, char *text)
{
  char *height = strchr(text, 'x');
  if (height)
    *height++ = '\0';
  return height && read_count(text, LEAST_SIZE, MOST_SIZE, &p->width)
         && read_count(height, LEAST_SIZE, MOST_SIZE, &p->height);
}

const char *plot_set(struct plot *p, const char *option, const char *text)
{
  enum { LONGEST = 1000 };
  static char lists[2][LONGEST]; /* of the columns named last */
  char copy[LONGEST];
  const char *of = strlen(option) > 5 ? option + 5 : "";
  bool is_list = strcmp(of, "y") == 0 || strcmp(of, "by") == 0, is_by = is_list && *of == 'b';
  char *parts = is_list ? lists[is_by] : copy;
  if (strlen(text) >= LONGEST)
    return not_allowed(text, "a shorter text");
  snprintf(parts, LONGEST, "%s", text);
  if (*of == '\0') {
    p->file = text;
    return plot_kind(text) ? NULL : not_allowed(text, "a file name that ends in .svg, .png or .pdf");
  }
  if (strcmp(of, "size") == 0)
    return read_size(p, parts) ? NULL : not_allowed(text, "WIDTHxHEIGHT in pixels, each from 200 to 10000: 800x500");
  if (strcmp(of, "x-range") == 0 || strcmp(of, "y-range") == 0)
    return read_range(*of == 'x' ? &p->x_range : &p->y_range, parts)
               ? NULL
               : not_allowed(text, "FROM:TO, FROM:TO:log or FROM:TO:linear, with FROM < TO, of log > 0");
  if (is_list)
    return read_names(is_by ? p->by : p->y, parts) ? NULL
                                                   : not_allowed(text, "one to eight columns, with commas between");
  *(strcmp(of, "x") == 0 ? &p->x : &p->title) = text;
  return *text && is_shown(text) ? NULL : not_allowed(text, "a line of UTF-8 without control characters");
}

bool plot_choose(struct plot *plot, const char *command)
{
  struct seen s = { plot, command, .limit = NAN };
  if (plot->program || plot->script)
    return true;
  bool good = tsv_open(&s.tsv, plot->table, TSV_TABS) ? look_at_rows(&s) && choose(&s)
                                                      : refuse(&s, "its table is gone", "");
  for (int i = 0; s.content && i < s.tsv.columns; i++)
    for (int k = 0; k < s.content[i].count; k++)
      free(s.content[i].value[k]);
  free(s.content);
  tsv_close(&s.tsv);
  return good;
}
