/* want = ( { what = "steady"; file = "steady.tsv"; }, ... ): one table each */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/scenes/parts.h"
#include "compare/text/file.h"
#include "compare/text/plot.h"
#include "compare/text/shipped.h"

enum { MOST_PERIODS = 1000000000 };
/* T varies, alone, in the last group of each product: an order is one of a row of such points. */
static bool check_times(const struct reading *r, const config_setting_t *at)
{
  const struct scene *s = r->scene;
  for (int p = 0; p < s->sweep.products; p++) {
    const struct sweep_product *product = &s->sweep.product[p];
    const struct sweep_group *last = product->groups > 0 ? &product->group[product->groups - 1] : NULL;
    bool is_T = last && last->variables == 1 && last->variable[0].target == TARGET_NUMBER
                && strcmp(last->variable[0].name, "T") == 0;
    if (!is_T || last->count < 3 || last->count > SCENE_TIMES)
      return refuse_at(r->config, at,
                       "orders need T to vary, alone, in the last group of what varies, with 3 to %d values",
                       SCENE_TIMES);
  }
  return true;
}

static bool read_orders(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  struct quantities *all = &r->scene->asked.quantities;
  w->has_expect = config_setting_get_member(at, "expect") != NULL;
  if (!check_times(r, at) || !find_series(r, at, w))
    return false;
  if (!(w->tolerance > 0))
    return refuse_at(r->config, config_setting_get_member(at, "tol"), "tol is a number > 0");
  for (int i = 0; i < w->series; i++) {
    const char *name = keep(r->config, "error.%s", w->series_name[i]);
    w->of[i] = name ? quantity_named(all, name) : -1;
    if (w->of[i] < 0)
      return name && refuse_at(r->config, at, "%s", sheet_no_quantity(&w->sheet, w->series_name[i]));
    const char *why = want_refuses(&w->sheet, &all->item[w->of[i]]);
    if (why)
      return refuse_at(r->config, at, "%s %s", name, why);
  }
  return true;
}

/* A script is a file beside the scene or, with a name that has neither '/' nor '.', comes with the tool. */
static bool find_script(const struct reading *r, const config_setting_t *at, struct plot *p)
{
  if (strpbrk(p->script, "/.")) {
    p->script = path_beside(r->config, p->script);
    FILE *script = p->script ? file_read(p->script) : NULL; /* and no table takes its place */
    if (!script)
      return p->script && refuse_at(r->config, at, "cannot read the plot script %s", p->script);
    fclose(script);
    return true;
  }
  p->program = shipped_text(shipped_scripts, p->script);
  const char *near = shipped_near(shipped_scripts, p->script);
  if (!p->program)
    return refuse_at(
        r->config, at,
        "no plot script '%.80s' comes with the tool%s The name of a script of yours has an ending: '%.80s.gp'",
        p->script, near ? did_you_mean(near) : ".", p->script);
  p->script = NULL;
  return true;
}

/* What is written as on the command line: size, both ranges and the title; NULL: not given. */
static bool set_texts(const struct reading *r, const config_setting_t *at, struct plot *p, const char *const texts[4])
{
  static const char *const options[] = { "plot-size", "plot-x-range", "plot-y-range", "plot-title" }, *const names[] = {
    "size", "x_range", "y_range", "title"
  };
  for (int i = 0; i < 4; i++) {
    const char *wrong = texts[i] ? plot_set(p, options[i], texts[i]) : NULL;
    if (wrong)
      return refuse_at(r->config, at, "%s: %s", names[i], wrong);
  }
  p->log_x = p->log_x || p->x_range.is_log;
  p->log_y = p->log_y || p->y_range.is_log;
  return true;
}

static bool read_plot(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  struct picture {
    struct plot plot;
    int ys, bys;
    const char *size, *x_range, *y_range;
  } picture = { .ys = 0 };
  static const struct member members[] = {
    MEMBER(TEXT, "file", plot, file, ),
    MEMBER(TEXT, "script", plot, script, ),
    MEMBER(TEXT, "x", plot, x, ),
    MEMBER(TEXTS, "y", plot, y, .high = PLOT_COLUMNS, .count = offsetof(struct picture, ys)),
    MEMBER(TEXTS, "by", plot, by, .high = PLOT_COLUMNS, .count = offsetof(struct picture, bys)),
    MEMBER(FLAG, "log_x", plot, log_x, ),
    MEMBER(FLAG, "log_y", plot, log_y, ),
    MEMBER(TEXT, "title", plot, title, ),
    MEMBER(TEXT, "size", picture, size, ),
    MEMBER(TEXT, "x_range", picture, x_range, ),
    MEMBER(TEXT, "y_range", picture, y_range, ),
    { .name = NULL }
  };
  const struct style *given = &r->options->request.style;
  struct plot *p = &w->plot;
  if (!config_setting_is_group(at))
    return refuse_at(r->config, at, "plot is a group: { file = \"error.svg\"; x = \"T\"; y = \"error\"; }");
  if (!read_members(r->config, at, members, &picture, "a plot", NULL))
    return false;
  *p = picture.plot;
  if (!set_texts(r, at, p, (const char *const[]){ picture.size, picture.x_range, picture.y_range, p->title }))
    return false;
  if (!p->file || !plot_kind(p->file))
    return refuse_at(r->config, at, "a plot needs a file that ends in .svg, .png or .pdf");
  /* of a table in the format of the command line there is none */
  w->has_plot = !given->has_format || given->format == FORMAT_TSV;
  if (w->has_plot && (!w->file || w->format != FORMAT_TSV))
    return refuse_at(r->config, at,
                     "a plot is made from a table in a file, format tsv: this want needs file = \"...\"");
  if (p->script)
    return find_script(r, at, p);
  if (!p->x || !p->y[0])
    return refuse_at(r->config, at, "a plot without a script of its own needs x and y, columns of the table");
  for (int i = -1; i < picture.ys && w->sheet.count > 0; i++) { /* else they are a command's own: it will show */
    const char *name = i < 0 ? p->x : p->y[i];
    if (!has_column(w, name))
      return refuse_at(r->config, at, "the table has no column %s", name);
  }
  return true;
}

/* The kinds of wants. The last are the tables of commands. */
static const struct {
  const char *what;
  enum want_kind kind;
  long most_digits; /* beyond a double's are digits of certified values */
} kinds[] = { { "trajectory", WANT_TRAJECTORY, DIGITS_OF_DOUBLE },
              { "phase", WANT_ROWS, MOST_CERTIFIED_DIGITS },
              { "steady", WANT_ROWS, MOST_CERTIFIED_DIGITS },
              { "series", WANT_ROWS, DIGITS_OF_DOUBLE },
              { "error", WANT_ROWS, DIGITS_OF_DOUBLE },
              { "orders", WANT_ORDERS, DIGITS_OF_DOUBLE },
              { "terms", WANT_COMMAND, 0 },
              { "bounds", WANT_COMMAND, 0 },
              { "breakdown", WANT_COMMAND, 0 },
              { "stability", WANT_COMMAND, 0 },
              { "work-precision", WANT_COMMAND, 0 },
              { "claims", WANT_COMMAND, 0 } };
enum { KINDS = sizeof kinds / sizeof *kinds };

#define OF_SERIES "series error orders"
static const char *const references[] = { "exact", "certified", NULL };
static const struct member members[] = {
  MEMBER(TEXT, "what", scene_want, what, ),
  MEMBER(TEXT, "file", scene_want, file, ),
  MEMBER(WORD, "format", scene_want, format, .words = format_names),
  OTHER("plot"),
  MEMBER(COUNT, "digits", scene_want, digits, .low = 1, .high = MOST_CERTIFIED_DIGITS,
         .only = "trajectory phase steady " OF_SERIES),
  MEMBER(TEXTS, "columns", scene_want, name, .high = SCENE_COLUMNS, .count = offsetof(struct scene_want, named),
         .only = "trajectory phase steady series error"),
  MEMBER(TEXTS, "of", scene_want, series_name, .high = SCENE_COLUMNS, .count = offsetof(struct scene_want, series),
         .only = OF_SERIES),
  MEMBER(WORD, "source", scene_want, source, .words = series_sources, .only = OF_SERIES),
  MEMBER(COUNT, "order", scene_want, order, .low = 1, .high = 1000, .only = OF_SERIES),
  MEMBER(NUMBER, "accuracy", scene_want, accuracy, .only = "phase steady " OF_SERIES),
  MEMBER(WORD, "reference", scene_want, reference, .words = references, .only = "phase steady " OF_SERIES),
  MEMBER(NUMBER, "expect", scene_want, expect, .only = "orders"),
  MEMBER(NUMBER, "tol", scene_want, tolerance, .only = "orders"),
  MEMBER(COUNT, "periods", scene_want, periods, .low = 1, .high = MOST_PERIODS, .only = "trajectory"),
  MEMBER(COUNT, "samples", scene_want, samples, .low = 1, .high = MOST_PERIODS, .only = "trajectory"),
  MEMBER(OTHER, "until", scene_want, until, .only = "trajectory"),
  { .name = NULL }
};

/* The place of what among the kinds, or KINDS, and it is refused. */
static int find_kind(const struct reading *r, const config_setting_t *at, const char *what)
{
  const char *names[KINDS + 1] = { NULL };
  char list[200];
  int k = 0;
  for (int i = 0; i < KINDS; i++)
    names[i] = kinds[i].what;
  while (k < KINDS && strcmp(what, names[k]) != 0)
    k++;
  if (k == KINDS)
    refuse_at(r->config, at, "'%.80s' cannot be wanted, but one of %s%s", what, joined(list, sizeof list, names, ", "),
              did_you_mean(nearest(what, names)));
  return k;
}

/* How well errors are told, and against which reference; and how many digits there can be. */
static bool check_accuracy(const struct reading *r, const config_setting_t *at, struct scene_want *w, long most_digits)
{
  if (!(w->accuracy >= 1e-300) || !(w->accuracy < 1))
    return refuse_at(r->config, config_setting_get_member(at, "accuracy"),
                     "accuracy is a part of the exact value, between 1e-300 and 1");
  if (w->reference == REFERENCE_EXACT && w->accuracy < ACCURACY_OF_DOUBLES)
    return refuse_at(r->config, config_setting_get_member(at, "reference"),
                     "the exact solver works in doubles, whose errors are told down to 1e-10; accuracy = %g needs "
                     "reference = \"certified\"",
                     w->accuracy);
  if (r->options->request.style.digits > 0)
    w->digits = r->options->request.style.digits;
  return w->digits <= most_digits
         || refuse_at(r->config, at, "%ld digits: in this table a whole number from 1 to %ld", w->digits, most_digits);
}

/* More digits than a double has are digits of something certified. */
static bool check_digits(const struct reading *r, const config_setting_t *at, const struct scene_want *w)
{
  bool has = w->digits <= DIGITS_OF_DOUBLE;
  for (int i = 0; i < w->sheet.count; i++)
    has |= w->sheet.column[i].quantity >= 0
           && r->scene->asked.quantities.item[w->sheet.column[i].quantity].kind == QUANTITY_CERTIFIED;
  return has
         || refuse_at(
             r->config, config_setting_get_member(at, "digits"),
             "%ld digits are more than a double has, and no column is certified: certified.displacement is, for one",
             w->digits);
}

/* A table of the scene's own */
static bool read_own(const struct reading *r, const config_setting_t *at, struct scene_want *w, long most_digits)
{
  const config_setting_t *until = config_setting_get_member(at, "until");
  bool onset = false;
  if (!read_members(r->config, at, members, w, "a want", w->what) || !check_accuracy(r, at, w, most_digits)
      || (until && !read_end(r, until, &w->until, &onset)))
    return false;
  if (w->kind == WANT_ORDERS && !read_orders(r, at, w))
    return false;
  if (w->named > 0 && w->series > 0)
    return refuse_at(r->config, config_setting_get_member(at, "of"),
                     "of and columns exclude each other: columns may name series and what is said of them");
  return (w->named > 0 ? add_columns(r, config_setting_get_member(at, "columns"), w, w->name) : usual_columns(r, at, w))
         && check_digits(r, at, w);
}

/* Does a path lead down from its folder? Links on its way are not looked at. */
static bool goes_down(const char *path)
{
  bool up = *path == '/';
  for (const char *part = path; part && !up; part = strchr(part, '/')) {
    part += strspn(part, "/");
    up = strncmp(part, "..", 2) == 0 && (part[2] == '/' || part[2] == '\0');
  }
  return !up;
}

static bool put_into(const struct reading *r, const config_setting_t *group, const char **file)
{
  if (!r->options->folder || !*file)
    return true;
  if (!goes_down(*file))
    return refuse_at(
        r->config, config_setting_get_member(group, "file"),
        "'%.200s' may lie outside of %.200s, which --into names: a file is allowed that has no / in front and no "
        "folder .. in its path",
        *file, r->options->folder);
  *file = keep(r->config, "%s/%s", r->options->folder, *file);
  return *file != NULL;
}

/* Where the table and its plot go, and how the table is written: the command line may name the file, or a folder. */
static bool place(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  const struct scene_options *o = r->options;
  const config_setting_t *plot = config_setting_get_member(at, "plot");
  bool is_named = o->request.style.has_output;
  if (w->file && strcmp(w->file, "-") == 0)
    w->file = NULL;
  if (o->request.style.has_format)
    w->format = o->request.style.format;
  if (w->file && plot_kind(w->file))
    return refuse_at(
        r->config, config_setting_get_member(at, "file"),
        "'%.200s' is the name of a picture, and the table is written there: plot = { file = ... } draws one", w->file);
  if (plot && !read_plot(r, plot, w))
    return false;
  if (is_named)
    w->file = o->request.style.output;
  else if (!put_into(r, at, &w->file) || !put_into(r, plot, &w->plot.file))
    return false;
  w->has_plot = w->has_plot && w->file && !o->no_plots;
  w->plot.table = w->file;
  w->plot.meaning = quantity_meaning;
  w->plot.title = w->plot.title ? w->plot.title : r->scene->title;
  return true;
}

static bool read_want(const struct reading *r, const config_setting_t *at)
{
  struct scene_want *w = &r->scene->want[r->scene->wants++];
  *w = (struct scene_want){ .accuracy = ACCURACY_OF_DOUBLES,
                            .reference = REFERENCE_NOT_GIVEN,
                            .order = 8,
                            .periods = 10,
                            .samples = 40,
                            .until = { .number = INFINITY },
                            .tolerance = 0.1 };
  w->scene = r->scene;
  w->sheet = (struct sheet){ .asked = &r->scene->asked, .refuses = want_refuses, .context = w };
  if (!config_setting_is_group(at))
    return refuse_at(r->config, at, "want is a list of groups: ( { what = \"steady\"; file = \"steady.tsv\"; } )");
  const config_setting_t *what = config_setting_get_member(at, "what");
  if (!what)
    return refuse_at(r->config, at, "what is wanted? what = \"steady\", for one");
  if (!read_member(r->config, what, &members[0], w))
    return false;
  int kind = find_kind(r, at, w->what);
  if (kind == KINDS)
    return false;
  w->kind = kinds[kind].kind;
  return (w->kind == WANT_COMMAND ? read_command(r, at, w, members) : read_own(r, at, w, kinds[kind].most_digits))
         && place(r, at, w);
}

bool read_wants(const struct reading *r, const config_setting_t *want)
{
  int count = want ? element_count(want) : 0;
  if (count == 0)
    return refuse_at(r->config, want, "nothing is wanted: want = ( { what = \"steady\"; } );");
  if (count > SCENE_WANTS)
    return refuse_at(r->config, want, "%d wants: %d at most", count, SCENE_WANTS);
  for (int i = 0; i < count; i++)
    if (!read_want(r, element_at(want, i)))
      return false;
  return true;
}
