/* want = ( { what = "steady"; file = "steady.tsv"; }, ... ) */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/plot.h"
#include "compare/scenes/parts.h"
#include "compare/scenes/shipped.h"

enum { MOST_DIGITS = 10000, DOUBLE_DIGITS = 17 };

static const char *const whats[] = { "trajectory", "phase",     "steady",    "series",         "error",  "orders", "terms",
                                     "bounds",     "breakdown", "stability", "work-precision", "claims", NULL };

/* ---- the kinds of wants ---- */

/* Which reference errors are told against, and how well. */
static bool read_accuracy(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  static const double of_doubles = 1e-10;
  const char *reference = NULL;
  const config_setting_t *accuracy = config_setting_get_member(at, "accuracy");
  w->accuracy = of_doubles;
  if (!read_member_text(r, at, "reference", &reference) || !read_member_number(r, at, "accuracy", &w->accuracy))
    return false;
  if (!(w->accuracy > 0) || !(w->accuracy < 1) || w->accuracy < 1e-300)
    return refuse_at(r, accuracy, "accuracy is a part of the exact value, between 1e-300 and 1");
  if (!reference)
    return true;
  const config_setting_t *named = config_setting_get_member(at, "reference");
  if (strcmp(reference, "certified") == 0) {
    w->is_certified = true;
    return true;
  }
  if (strcmp(reference, "exact") != 0)
    return refuse_at(r, named, "reference is \"exact\" (the solver in doubles) or \"certified\"");
  return w->accuracy >= of_doubles
         || refuse_at(r, named,
                      "the exact solver works in doubles, whose errors are told down to 1e-10; accuracy = %g needs "
                      "reference = \"certified\"",
                      w->accuracy);
}

/* More digits than a double has are digits of something certified. */
static bool check_digits(const struct reading *r, const config_setting_t *at, const struct scene_want *w)
{
  bool has = w->digits <= DOUBLE_DIGITS;
  for (int i = 0; i < w->columns; i++)
    has |= w->column[i].quantity >= 0 && r->scene->quantities.item[w->column[i].quantity].kind == QUANTITY_CERTIFIED;
  return has
         || refuse_at(
             r, config_setting_get_member(at, "digits"),
             "%ld digits are more than a double has, and no column is certified: certified.displacement is, for one",
             w->digits);
}

static bool read_rows(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  static const char *const keys[] = { "what",  "file", "format", "digits",   "columns",   "source",
                                      "order", "of",   "plot",   "accuracy", "reference", NULL };
  const char *asked[SCENE_COLUMNS + 1] = { NULL };
  int count = 0;
  bool is_series = strcmp(w->what, "series") == 0, is_error = strcmp(w->what, "error") == 0;
  if (!keys_known(r, at, keys, "this want") || !read_accuracy(r, at, w)
      || !read_member_texts(r, at, "columns", asked, SCENE_COLUMNS, &count))
    return false;
  static const char *const of_series[] = { "of", "source", "order" };
  const config_setting_t *idle = NULL;
  for (int i = 0; i < 3 && !idle && !is_series && !is_error; i++)
    idle = config_setting_get_member(at, of_series[i]);
  if (idle)
    return refuse_at(r, idle, "%s is for what = \"series\", \"error\" and \"orders\"", config_setting_name(idle));
  if (count > 0 && config_setting_get_member(at, "of"))
    return refuse_at(r, config_setting_get_member(at, "of"),
                     "of and columns exclude each other: columns may name series and what is said of them");
  if (count > 0)
    return add_columns(r, config_setting_get_member(at, "columns"), w, asked) && check_digits(r, at, w);
  return add_labels(r, at, w)
         && (is_series || is_error            ? series_columns(r, at, w, is_error)
             : strcmp(w->what, "steady") == 0 ? steady_columns(r, at, w)
                                              : phase_columns(r, at, w));
}

static bool read_trajectory(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  static const char *const keys[] = { "what",    "file",    "format", "digits", "columns",
                                      "periods", "samples", "until",  "plot",   NULL };
  static const char *const usual[] = { "t", "x1", "x2", "xC", "v1", "v2", "l", NULL };
  const char *asked[SCENE_COLUMNS + 1] = { NULL };
  const config_setting_t *until = config_setting_get_member(at, "until");
  int count = 0;
  bool onset = false;
  w->kind = WANT_TRAJECTORY;
  w->periods = 10;
  w->samples = 40;
  w->until = (struct scene_end){ .number = INFINITY };
  if (!keys_known(r, at, keys, "a trajectory") || !read_member_texts(r, at, "columns", asked, SCENE_COLUMNS, &count)
      || !read_member_count(r, at, "periods", 1, 1000000000, &w->periods)
      || !read_member_count(r, at, "samples", 1, 1000000000, &w->samples)
      || (until && (!read_end(r, until, &w->until) || !check_end(r, until, &w->until, &onset))))
    return false;
  if (count > 0)
    return add_columns(r, config_setting_get_member(at, "columns"), w, asked);
  if (!add_labels(r, at, w))
    return false;
  const struct scene_variable *v;
  for (int k = 0; (v = scene_variable(r->scene, k)); k++) { /* what varies tells the curves apart */
    const char *column = v->target == TARGET_F1_OVER_F2   ? "F1_over_F2 = F1/F2"
                         : v->target == TARGET_M1_OVER_M2 ? "m1_over_m2 = m1/m2"
                                                          : v->name;
    bool there = v->target == TARGET_LABEL;
    for (int i = 0; i < w->columns; i++)
      there |= strcmp(w->column[i].name, v->name) == 0;
    if (!there && !read_column(r, at, w, column))
      return false;
  }
  return add_columns(r, at, w, usual);
}

/* T varies, alone, in the last group of each product: an order is one of a row of such points. */
static bool check_times(const struct reading *r, const config_setting_t *at)
{
  const struct scene *s = r->scene;
  for (int p = 0; p < s->products; p++) {
    const struct scene_product *product = &s->product[p];
    const struct scene_group *last = product->groups > 0 ? &product->group[product->groups - 1] : NULL;
    bool is_T = last && last->variables == 1 && last->variable[0].target == TARGET_NUMBER
                && strcmp(last->variable[0].name, "T") == 0;
    if (!is_T || last->count < 3 || last->count > SCENE_TIMES)
      return refuse_at(r, at, "orders need T to vary, alone, in the last group of what varies, with 3 to %d values",
                       SCENE_TIMES);
  }
  return true;
}

static bool read_orders(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  static const char *const keys[] = { "what",     "file",      "format", "digits", "of",   "source", "order",
                                      "accuracy", "reference", "expect", "tol",    "plot", NULL };
  struct series_names names = { .count = 0 };
  w->kind = WANT_ORDERS;
  w->tolerance = 0.1;
  w->has_expect = config_setting_get_member(at, "expect") != NULL;
  if (!keys_known(r, at, keys, "orders") || !read_accuracy(r, at, w) || !read_series(r, at, &names)
      || !read_member_number(r, at, "expect", &w->expect) || !read_member_number(r, at, "tol", &w->tolerance)
      || !check_times(r, at))
    return false;
  if (!(w->tolerance > 0))
    return refuse_at(r, config_setting_get_member(at, "tol"), "tol is a number > 0");
  for (int i = 0; i < r->scene->quantities.labels; i++)
    for (const char *const *own = order_columns; *own; own++)
      if (strcmp(*own, r->scene->quantities.label[i]) == 0)
        return refuse_at(r, at, "the label %s has the name of a column of orders", *own);
  for (w->series = 0; w->series < names.count; w->series++) {
    const char *name = keep_text(r, "error.", 6, names.name[w->series]);
    int place = name ? quantity_named(&r->scene->quantities, name) : -1;
    if (place < 0)
      return name && refuse_quantity(r, at, names.name[w->series]);
    if (!check_quantity(r, at, w, place))
      return false;
    w->of[w->series] = place;
  }
  return true;
}

/* ---- plots ---- */

static bool has_column(const struct scene_want *w, const char *name)
{
  for (int i = 0; i < w->columns; i++)
    if (strcmp(w->column[i].name, name) == 0)
      return true;
  return w->columns == 0; /* a command's own, or those of orders: it will show */
}

/* A script is a file beside the scene or, with a name that has neither '/' nor '.', comes with the tool. */
static bool find_script(const struct reading *r, const config_setting_t *at, struct plot *p)
{
  if (strpbrk(p->script, "/.")) {
    p->script = path_beside(r, p->script);
    return p->script != NULL;
  }
  p->program = shipped_text(shipped_scripts, p->script);
  if (!p->program) {
    const char *near = shipped_near(shipped_scripts, p->script);
    return refuse_at(
        r, at, "no plot script '%.80s' comes with the tool%s%s%s; the name of a script of yours has an ending: '%.80s.gp'",
        p->script, near ? ": did you mean '" : "", near ? near : "", near ? "'?" : "", p->script);
  }
  p->script = NULL;
  return true;
}

static bool check_curves(const struct reading *r, const config_setting_t *at, const struct scene_want *w)
{
  const struct plot *p = &w->plot;
  if (!p->x || !p->y[0])
    return refuse_at(r, at, "a plot without a script of its own needs x and y, columns of the table");
  if (!has_column(w, p->x))
    return refuse_at(r, at, "the table has no column %s", p->x);
  for (int i = 0; p->y[i]; i++)
    if (!has_column(w, p->y[i]))
      return refuse_at(r, at, "the table has no column %s", p->y[i]);
  return true;
}

static bool read_plot(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  static const char *const keys[] = { "file", "script", "x", "y", "by", "log_x", "log_y", NULL };
  struct plot *p = &w->plot;
  int ys = 0, bys = 0;
  w->has_plot = true;
  if (!config_setting_is_group(at))
    return refuse_at(r, at, "plot is a group: { file = \"error.svg\"; x = \"T\"; y = \"error\"; }");
  if (!keys_known(r, at, keys, "a plot") || !read_member_text(r, at, "file", &p->file)
      || !read_member_text(r, at, "script", &p->script) || !read_member_text(r, at, "x", &p->x)
      || !read_member_texts(r, at, "y", p->y, PLOT_COLUMNS, &ys)
      || !read_member_texts(r, at, "by", p->by, PLOT_COLUMNS, &bys) || !read_member_flag(r, at, "log_x", &p->log_x)
      || !read_member_flag(r, at, "log_y", &p->log_y))
    return false;
  if (!p->file)
    return refuse_at(r, at, "a plot needs a file: one that ends in .svg, .png or .pdf");
  if (!plot_kind(p->file))
    return refuse_at(r, at, "'%.200s': a plot's file ends in .svg, .png or .pdf", p->file);
  if (r->options->has_format && r->options->format != FORMAT_TSV) /* of what the command line asks for there is none */
    w->has_plot = false;
  else if (!w->file || w->format != FORMAT_TSV)
    return refuse_at(r, at, "a plot is made from a table in a file, format tsv: this want needs file = \"...\"");
  p->program = shipped_text(shipped_scripts, "curves");
  return p->script ? find_script(r, at, p) : check_curves(r, at, w);
}

/* ---- all of them ---- */

static bool read_output(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  const char *format = NULL;
  bool beyond = strcmp(w->what, "steady") == 0 || strcmp(w->what, "phase") == 0 || w->kind == WANT_COMMAND;
  long most = beyond ? MOST_DIGITS : DOUBLE_DIGITS;
  if (!read_member_text(r, at, "file", &w->file) || !read_member_text(r, at, "format", &format)
      || !read_member_count(r, at, "digits", 1, most, &w->digits))
    return false;
  if (r->options->digits > most)
    return refuse_at(r, at, "--digits %ld: in this table a whole number from 1 to %ld", r->options->digits, most);
  if (r->options->digits > 0)
    w->digits = r->options->digits;
  if (w->file && strcmp(w->file, "-") == 0)
    w->file = NULL;
  if (w->file && plot_kind(w->file))
    return refuse_at(r, config_setting_get_member(at, "file"),
                     "'%.200s' is the name of a picture, and the table is written there: plot = { file = ... } draws one",
                     w->file);
  if (format && strcmp(format, "tsv") != 0 && strcmp(format, "json") != 0)
    return refuse_at(r, config_setting_get_member(at, "format"), "format is \"tsv\" or \"json\"");
  w->format = r->options->has_format ? r->options->format : format && *format == 'j' ? FORMAT_JSON : FORMAT_TSV;
  return true;
}

static bool read_want(const struct reading *r, const config_setting_t *at)
{
  struct scene_want *w = &r->scene->want[r->scene->wants++];
  w->column = calloc(SCENE_COLUMNS, sizeof *w->column);
  if (!w->column)
    return refuse_at(r, at, "out of memory");
  if (!config_setting_is_group(at))
    return refuse_at(r, at, "want is a list of groups: ( { what = \"steady\"; file = \"steady.tsv\"; } )");
  if (!read_member_text(r, at, "what", &w->what))
    return false;
  if (!w->what)
    return refuse_at(r, at, "what is wanted? what = \"steady\", for one");
  int k = 0;
  while (whats[k] && strcmp(w->what, whats[k]) != 0)
    k++;
  if (!whats[k]) {
    const char *near = nearest(w->what, whats);
    return refuse_at(
        r, at,
        "'%.80s' cannot be wanted%s%s%s: one of trajectory, phase, steady, series, error, orders, terms, bounds, "
        "breakdown, stability, work-precision and claims can",
        w->what, near ? "; did you mean '" : "", near ? near : "", near ? "'?" : "");
  }
  w->kind = is_command(w->what) ? WANT_COMMAND : WANT_ROWS;
  const config_setting_t *plot = config_setting_get_member(at, "plot");
  if (!read_output(r, at, w))
    return false;
  bool read = w->kind == WANT_COMMAND              ? read_command(r, at, w)
              : strcmp(w->what, "trajectory") == 0 ? read_trajectory(r, at, w)
              : strcmp(w->what, "orders") == 0     ? read_orders(r, at, w)
                                                   : read_rows(r, at, w);
  return read && (!plot || read_plot(r, plot, w));
}

bool read_wants(const struct reading *r, const config_setting_t *want)
{
  int count = !want ? 0 : config_setting_is_list(want) ? config_setting_length(want) : 1;
  if (count == 0)
    return refuse_at(r, want, "nothing is wanted: want = ( { what = \"steady\"; } );");
  if (count > SCENE_WANTS)
    return refuse_at(r, want, "%d wants: %d at most", count, SCENE_WANTS);
  for (int i = 0; i < count; i++)
    if (!read_want(r, config_setting_is_list(want) ? config_setting_get_elem(want, (unsigned)i) : want))
      return false;
  return true;
}
