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

#define AXES "F1/F2", "F1_over_F2", "m1/m2", "m1_over_m2", "alpha", "T", "froude"

/* The first row all of whose columns a table has is its kind. Lists end with NULL. */
static const struct drawing {
  const char *has[6];
  const char *program;               /* a script of scripts/plots/                                          */
  const char *x;                     /* NULL: that of vary which varies most                                */
  const char *vary[12];              /* and a curve is of each value of the others of them that vary        */
  const char *y[PLOT_COLUMNS + 1];   /* columns                                                             */
  const char *by[PLOT_COLUMNS + 1];  /* a curve is of each of their values                                  */
  enum { AS_IS, LOG_Y, LOG_XY } log; /* as the values ask for it, or logarithmic whatever they are          */
  bool is_map;                       /* of vary the first two columns are the axes, and the head says which is logarithmic */
  bool magnitudes;                   /* are drawn                                                                          */
  const char *over;                  /* the column that y is divided by                                                    */
  const char *limit;                 /* the head has this text, and behind it a number that is a limit                    */
} drawings[] = {
  { .has = { "t", "x1", "x2", "xC" }, .program = "curves", .x = "t", .y = { "x1", "x2", "xC" } },
  { .has = { "series", "row", "h", "err" },
    .program = "curves",
    .x = "h",
    .y = { "err" },
    .by = { "file", "series", "y" },
    .log = LOG_XY,
    .magnitudes = true },
  { .has = { "power", "coefficient", "sum", "error" },
    .program = "curves",
    .x = "power",
    .y = { "error" },
    .by = { "phase", "quantity" },
    .log = LOG_Y,
    .magnitudes = true },
  { .has = { "formula", "phase", "published", "exact", "error" },
    .program = "dots",
    .y = { "error" },
    .by = { "formula", "phase", "quantity" },
    .over = "exact" },
  { .has = { "quantity", "C", "T0", "bound" }, .program = "dots", .y = { "bound" }, .by = { "quantity" } },
  { .has = { "what", "series", "tolerance", "T" }, .program = "reach", .x = "T" },
  { .has = { "region_1", "region_2", "curve" }, .program = "boundaries", .vary = { AXES }, .is_map = true },
  { .has = { "modes", "regime", "error_published" }, .program = "map", .vary = { AXES }, .y = { "modes" }, .is_map = true },
  { .has = { "modes", "regime", "T_1e-2_limit" }, .program = "map", .vary = { AXES }, .y = { "modes" }, .is_map = true },
  { .has = { "method", "kind", "gait", "quantity", "time_median" },
    .program = "workprec",
    .x = "time_median",
    .y = { "error" } },
  { .has = { "wanted_error", "next_ratio", "rival_over_exact" },
    .program = "dots",
    .y = { "next_ratio", "rival_over_exact", "simulation_over_exact" },
    .by = { "gait", "T", "quantity", "wanted_error" } },
  { .has = { "family", "gait", "cases", "units" },
    .program = "dots",
    .y = { "units", "rounding", "perturbed" },
    .by = { "family", "gait" },
    .limit = "promised, in units: error " },
  { .has = { "quantity", "certified", "units" },
    .program = "dots",
    .y = { "units", "rounding", "perturbed" },
    .by = { "quantity" } },
  { .has = { "scene", "stepper", "delta", "v_end_error" },
    .program = "curves",
    .x = "delta",
    .y = { "displacement_error" },
    .by = { "scene", "gait", "stepper" },
    .log = LOG_XY,
    .magnitudes = true },
  { .has = { "scene", "stepper", "order_low" },
    .program = "dots",
    .y = { "order", "order_low", "order_high" },
    .by = { "scene", "gait", "stepper", "quantity" } },
  { .has = { "m1", "phase", "v0", "dxC" }, .program = "curves", .vary = { PARAMETERS, "phase", "v0" }, .y = { "dxC" } },
  { .has = { "m1", "froude", "mean_velocity" }, .program = "curves", .vary = { PARAMETERS }, .y = { "mean_velocity" } },
  { .has = { "m1", "v0", "text_steady_xC" }, .program = "curves", .vary = { PARAMETERS, "v0" }, .y = { "text_steady_xC" } },
  { .has = { NULL }, .program = "curves" }, /* any other: x and y are named */
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
  bool log[2];             /* what the head says of the axes of a map */
  double limit;            /* what it says of limits */
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

static bool has_all(const struct seen *s, const char *const *columns)
{
  while (*columns && content_of(s, *columns))
    columns++;
  return !*columns;
}

static const struct drawing *drawing_of(const struct seen *s)
{
  const struct drawing *d = drawings;
  while (!has_all(s, d->has))
    d++;
  return d;
}

/* What the '#' lines say: which axes are logarithmic, a limit, and the parameters, which are the title where none is given. */
static void read_head(struct seen *s, const struct drawing *d)
{
  static char title[TITLE];
  char line[1024];
  FILE *table = fopen(s->plot->table, "r");
  while (table && fgets(line, sizeof line, table) && *line == '#') {
    line[strcspn(line, "\n")] = '\0';
    for (int i = 0; i < 2; i++)
      if (strncmp(line, i == 0 ? "# x: " : "# y: ", 5) == 0)
        s->log[i] = strlen(line) > 5 && strcmp(line + strlen(line) - 5, ", log") == 0;
    if (d->limit && strncmp(line + 2, d->limit, strlen(d->limit)) == 0)
      s->limit = strtod(line + 2 + strlen(d->limit), NULL);
    if (!s->plot->title && strncmp(line, "# parameters: ", 14) == 0) {
      snprintf(title, sizeof title, "%.*s", TITLE - 1, line + 14);
      s->plot->title = title;
    }
  }
  if (table)
    fclose(table);
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

static const char *in_list(const char *const *list, const char *name)
{
  while (*list && strcmp(*list, name) != 0)
    list++;
  return *list;
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

static bool is_wide(const struct content *c, double factor) { return c && c->least > 0 && c->most >= factor * c->least; }

static void choose_map(const struct seen *s, const struct drawing *d)
{
  int found = 0;
  for (int i = 0; i < s->tsv.columns && found < 2; i++) {
    const char *name = in_list(d->vary, s->tsv.column[i]);
    if (name)
      *(found++ == 0 ? &s->plot->x : &s->plot->by[0]) = name;
  }
}

static void choose_axes(const struct seen *s, const struct drawing *d)
{
  enum { OF_X = 30, OF_Y = 1000 };
  struct plot *p = s->plot;
  bool wide = p->y[0] != NULL;
  for (const char *const *y = p->y; *y; y++)
    wide = wide && is_wide(content_of(s, *y), OF_Y);
  if (d->is_map) {
    p->log_x = s->log[0];
    p->log_y = s->log[1];
    return;
  }
  p->log_x = p->x_range.is_given ? p->x_range.is_log : d->log == LOG_XY || is_wide(content_of(s, p->x), OF_X);
  p->log_y = p->y_range.is_given ? p->y_range.is_log : d->log != AS_IS || wide;
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
  if (d->is_map && (p->x || p->by[0]))
    return refuse(s, "the axes of a map are those of --map", "");
  p->program = shipped_text(shipped_scripts, d->program);
  p->x = p->x ? p->x : d->x;
  if (!p->y[0])
    memcpy(p->y, d->y, sizeof p->y);
  choose_names(s, d);
  read_head(s, d);
  title_of_held(s);
  if (d->is_map)
    choose_map(s, d);
  else
    choose_varied(s, d);
  if (!p->x && d->vary[0])
    return refuse(s, "no parameter varies: a curve needs several points: --T 0.1:1:20, or --points FILE", "");
  if (!d->has[0] && (!p->x || !p->y[0]))
    return refuse(s, "--plot-x and --plot-y name the columns of such a table", "");
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
    return read_names(is_by ? p->by : p->y, parts) ? NULL : not_allowed(text, "one to eight columns, with commas between");
  *(strcmp(of, "x") == 0 ? &p->x : &p->title) = text;
  return *text && is_shown(text) ? NULL : not_allowed(text, "a line of UTF-8 without control characters");
}

bool plot_choose(struct plot *plot, const char *command)
{
  struct seen s = { plot, command, .limit = NAN };
  if (plot->program || plot->script)
    return true;
  bool good = tsv_open(&s.tsv, plot->table, TSV_TABS) ? look_at_rows(&s) && choose(&s) : refuse(&s, "its table is gone", "");
  for (int i = 0; s.content && i < s.tsv.columns; i++)
    for (int k = 0; k < s.content[i].count; k++)
      free(s.content[i].value[k]);
  free(s.content);
  tsv_close(&s.tsv);
  return good;
}
