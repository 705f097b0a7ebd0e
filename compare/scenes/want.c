/* want = ( { what = "steady"; file = "steady.tsv"; }, ... ): one table each */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/plot.h"
#include "compare/scenes/parts.h"
#include "compare/text/shipped.h"

enum { MOST_PERIODS = 1000000000 };
static const double OF_DOUBLES = 1e-10; /* errors against the solver in doubles are told down to this part */

/* What a want says of its columns and series */
struct wanted {
  const char *columns[SCENE_COLUMNS + 1];
  int count, reference;
  struct series_names series;
};
enum { REFERENCE_NOT_GIVEN = -1, REFERENCE_EXACT, REFERENCE_CERTIFIED };

/* Which reference errors are told against, and how well. */
static bool check_accuracy(const struct reading *r, const config_setting_t *at, struct scene_want *w, int reference)
{
  w->is_certified = reference == REFERENCE_CERTIFIED;
  if (!(w->accuracy >= 1e-300) || !(w->accuracy < 1))
    return refuse_at(r, config_setting_get_member(at, "accuracy"),
                     "accuracy is a part of the exact value, between 1e-300 and 1");
  return reference != REFERENCE_EXACT || w->accuracy >= OF_DOUBLES
         || refuse_at(r, config_setting_get_member(at, "reference"),
                      "the exact solver works in doubles, whose errors are told down to 1e-10; accuracy = %g needs "
                      "reference = \"certified\"",
                      w->accuracy);
}

/* More digits than a double has are digits of something certified. */
static bool check_digits(const struct reading *r, const config_setting_t *at, const struct scene_want *w)
{
  bool has = w->digits <= DIGITS_OF_DOUBLE;
  for (int i = 0; i < w->columns; i++)
    has |= w->column[i].quantity >= 0 && r->scene->quantities.item[w->column[i].quantity].kind == QUANTITY_CERTIFIED;
  return has
         || refuse_at(
             r, config_setting_get_member(at, "digits"),
             "%ld digits are more than a double has, and no column is certified: certified.displacement is, for one",
             w->digits);
}

static bool read_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w,
                         const struct wanted *wanted)
{
  return add_columns(r, config_setting_get_member(at, "columns"), w, wanted->columns);
}

static bool read_rows(const struct reading *r, const config_setting_t *at, struct scene_want *w, struct wanted *wanted)
{
  bool is_series = strcmp(w->what, "series") == 0, is_error = strcmp(w->what, "error") == 0;
  if (wanted->count > 0 && wanted->series.count > 0)
    return refuse_at(r, config_setting_get_member(at, "of"),
                     "of and columns exclude each other: columns may name series and what is said of them");
  if (wanted->count > 0)
    return read_columns(r, at, w, wanted) && check_digits(r, at, w);
  return add_labels(r, at, w)
         && (is_series || is_error ? series_columns(r, at, w, &wanted->series, is_error)
                                   : motion_columns(r, at, w, strcmp(w->what, "steady") == 0 ? OF_STEADY : OF_PHASE));
}

static bool read_trajectory(const struct reading *r, const config_setting_t *at, struct scene_want *w, struct wanted *wanted)
{
  const config_setting_t *until = config_setting_get_member(at, "until");
  bool onset = false;
  w->until = (struct sweep_end){ .number = INFINITY };
  if (until && !read_end(r, until, &w->until, &onset))
    return false;
  if (wanted->count > 0)
    return read_columns(r, at, w, wanted);
  if (!add_labels(r, at, w))
    return false;
  const struct sweep_variable *v;
  for (int k = 0; (v = sweep_variable(&r->scene->sweep, k)); k++) { /* what varies tells the curves apart */
    bool there = v->target == TARGET_LABEL;
    for (int i = 0; i < w->columns; i++)
      there |= strcmp(w->column[i].name, v->name) == 0;
    if (!there && !read_column(r, at, w, v->name))
      return false;
  }
  return add_columns(r, at, w, quantity_samples);
}

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
      return refuse_at(r, at, "orders need T to vary, alone, in the last group of what varies, with 3 to %d values",
                       SCENE_TIMES);
  }
  return true;
}

static bool read_orders(const struct reading *r, const config_setting_t *at, struct scene_want *w, struct wanted *wanted)
{
  const struct series_names *names = &wanted->series;
  w->has_expect = config_setting_get_member(at, "expect") != NULL;
  if (!check_times(r, at) || !find_series(r, at, &wanted->series))
    return false;
  if (!(w->tolerance > 0))
    return refuse_at(r, config_setting_get_member(at, "tol"), "tol is a number > 0");
  for (int i = 0; i < r->scene->quantities.labels; i++)
    if (is_among(r->scene->quantities.label[i], order_columns))
      return refuse_at(r, at, "the label %s has the name of a column of orders", r->scene->quantities.label[i]);
  for (; w->series < names->count; w->series++) {
    const char *name = keep_text(r, "error.", 6, names->name[w->series]);
    int place = name ? quantity_named(&r->scene->quantities, name) : -1;
    if (place < 0)
      return name && refuse_quantity(r, at, names->name[w->series]);
    if (!check_quantity(r, at, w, place))
      return false;
    w->of[w->series] = place;
  }
  return true;
}

static bool has_column(const struct reading *r, const config_setting_t *at, const struct scene_want *w, const char *name)
{
  bool has = w->columns == 0; /* a command's own, or those of orders: it will show */
  for (int i = 0; i < w->columns; i++)
    has |= strcmp(w->column[i].name, name) == 0;
  return has || refuse_at(r, at, "the table has no column %s", name);
}

/* A script is a file beside the scene or, with a name that has neither '/' nor '.', comes with the tool. */
static bool find_script(const struct reading *r, const config_setting_t *at, struct plot *p)
{
  if (strpbrk(p->script, "/.")) {
    p->script = path_beside(r, p->script);
    return p->script != NULL;
  }
  p->program = shipped_text(shipped_scripts, p->script);
  const char *near = shipped_near(shipped_scripts, p->script);
  if (!p->program)
    return refuse_at(r, at,
                     "no plot script '%.80s' comes with the tool%s The name of a script of yours has an ending: '%.80s.gp'",
                     p->script, near ? did_you_mean(near) : ".", p->script);
  p->script = NULL;
  return true;
}

static bool read_plot(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  struct plot *p = &w->plot;
  int ys = 0, bys = 0;
  const struct member members[] = { A_TEXT("file", &p->file),
                                    A_TEXT("script", &p->script),
                                    A_TEXT("x", &p->x),
                                    TEXTS("y", p->y, PLOT_COLUMNS, &ys),
                                    TEXTS("by", p->by, PLOT_COLUMNS, &bys),
                                    A_FLAG("log_x", &p->log_x),
                                    A_FLAG("log_y", &p->log_y),
                                    NO_MORE };
  w->has_plot = true;
  if (!config_setting_is_group(at))
    return refuse_at(r, at, "plot is a group: { file = \"error.svg\"; x = \"T\"; y = \"error\"; }");
  if (!read_members(r, at, members, "a plot"))
    return false;
  if (!p->file || !plot_kind(p->file))
    return refuse_at(r, at, "a plot needs a file that ends in .svg, .png or .pdf");
  if (r->options->request.style.has_format
      && r->options->request.style.format != FORMAT_TSV) /* of what the command line asks for there is none */
    w->has_plot = false;
  else if (!w->file || w->format != FORMAT_TSV)
    return refuse_at(r, at, "a plot is made from a table in a file, format tsv: this want needs file = \"...\"");
  if (p->script)
    return find_script(r, at, p);
  if (!p->x || ys == 0)
    return refuse_at(r, at, "a plot without a script of its own needs x and y, columns of the table");
  bool good = has_column(r, at, w, p->x);
  for (int i = 0; i < ys && good; i++)
    good = has_column(r, at, w, p->y[i]);
  return good;
}

/* The kinds of wants. The last are the tables of commands. */
static const struct {
  const char *what;
  enum want_kind kind;
  long most_digits; /* beyond a double's are digits of certified values */
  bool (*read)(const struct reading *, const config_setting_t *, struct scene_want *, struct wanted *);
} kinds[] = { { "trajectory", WANT_TRAJECTORY, DIGITS_OF_DOUBLE, read_trajectory },
              { "phase", WANT_ROWS, MOST_CERTIFIED_DIGITS, read_rows },
              { "steady", WANT_ROWS, MOST_CERTIFIED_DIGITS, read_rows },
              { "series", WANT_ROWS, DIGITS_OF_DOUBLE, read_rows },
              { "error", WANT_ROWS, DIGITS_OF_DOUBLE, read_rows },
              { "orders", WANT_ORDERS, DIGITS_OF_DOUBLE, read_orders },
              { "terms", WANT_COMMAND, 0, NULL },
              { "bounds", WANT_COMMAND, 0, NULL },
              { "breakdown", WANT_COMMAND, 0, NULL },
              { "stability", WANT_COMMAND, 0, NULL },
              { "work-precision", WANT_COMMAND, 0, NULL },
              { "claims", WANT_COMMAND, 0, NULL } };
enum { KINDS = sizeof kinds / sizeof *kinds };

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
    refuse_at(r, at, "'%.80s' cannot be wanted, but one of %s%s", what, joined(list, sizeof list, names, false),
              did_you_mean(nearest(what, names)));
  return k;
}

/* Members that mean something to some kinds only */
static bool check_members(const struct reading *r, const config_setting_t *at, const struct scene_want *w)
{
  static const struct {
    const char *name, *kinds;
  } only[] = { { "of", "series error orders" },
               { "source", "series error orders" },
               { "order", "series error orders" },
               { "expect", "orders" },
               { "tol", "orders" },
               { "periods", "trajectory" },
               { "samples", "trajectory" },
               { "until", "trajectory" },
               { "columns", "trajectory phase steady series error" },
               { "accuracy", "phase steady series error orders" },
               { "reference", "phase steady series error orders" } };
  for (size_t i = 0; i < sizeof only / sizeof *only; i++) {
    const config_setting_t *member = config_setting_get_member(at, only[i].name);
    if (member && !strstr(only[i].kinds, w->what))
      return refuse_at(r, member, "%s is not for what = \"%s\", but for: %s", only[i].name, w->what, only[i].kinds);
  }
  return true;
}

static bool read_own(const struct reading *r, const config_setting_t *at, struct scene_want *w, int kind)
{
  static const char *const references[] = { "exact", "certified", NULL };
  struct wanted wanted = { .reference = REFERENCE_NOT_GIVEN, .series = { .order = 8 } };
  const long most = kinds[kind].most_digits;
  const struct member members[] = { OTHER("what"),
                                    OTHER("file"),
                                    OTHER("format"),
                                    OTHER("plot"),
                                    A_COUNT("digits", &w->digits, 1, most),
                                    TEXTS("columns", wanted.columns, SCENE_COLUMNS, &wanted.count),
                                    TEXTS("of", wanted.series.name, SCENE_COLUMNS, &wanted.series.count),
                                    A_WORD("source", &wanted.series.source, series_sources),
                                    A_COUNT("order", &wanted.series.order, 1, 1000),
                                    A_NUMBER("accuracy", &w->accuracy),
                                    A_WORD("reference", &wanted.reference, references),
                                    A_NUMBER("expect", &w->expect),
                                    A_NUMBER("tol", &w->tolerance),
                                    A_COUNT("periods", &w->periods, 1, MOST_PERIODS),
                                    A_COUNT("samples", &w->samples, 1, MOST_PERIODS),
                                    OTHER("until"),
                                    NO_MORE };
  if (!read_members(r, at, members, "a want") || !check_members(r, at, w) || !check_accuracy(r, at, w, wanted.reference))
    return false;
  if (r->options->request.style.digits > most)
    return refuse_at(r, at, "--digits %ld: in this table a whole number from 1 to %ld", r->options->request.style.digits,
                     most);
  if (r->options->request.style.digits > 0)
    w->digits = r->options->request.style.digits;
  return kinds[kind].read(r, at, w, &wanted);
}

/* Where the table goes, and how it is written */
static bool read_output(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  static const char *const formats[] = { "tsv", "json", NULL };
  int format = 0;
  const struct member members[] = { A_TEXT("what", &w->what), A_TEXT("file", &w->file), A_WORD("format", &format, formats),
                                    THE_REST };
  if (!read_members(r, at, members, "a want"))
    return false;
  if (w->file && strcmp(w->file, "-") == 0)
    w->file = NULL;
  w->format = r->options->request.style.has_format ? r->options->request.style.format
              : format == 0                        ? FORMAT_TSV
                                                   : FORMAT_JSON;
  return !w->file || !plot_kind(w->file)
         || refuse_at(r, config_setting_get_member(at, "file"),
                      "'%.200s' is the name of a picture, and the table is written there: plot = { file = ... } draws one",
                      w->file);
}

static bool put_into(const struct reading *r, const char *folder, const char **file)
{
  if (!folder || !*file || **file == '/')
    return true;
  const char *head = keep_text(r, folder, (int)strlen(folder), "/");
  *file = head ? keep_text(r, head, (int)strlen(head), *file) : NULL;
  return *file != NULL;
}

/* Where the table and its plot go in the end: the command line may name the file, or a folder. */
static bool place(const struct reading *r, struct scene_want *w)
{
  const struct scene_options *o = r->options;
  bool is_named = o->request.style.has_output && !o->explain; /* else -o names the plan's */
  if (is_named)
    w->file = o->request.style.output;
  w->has_plot = w->has_plot && w->file && !o->no_plots;
  return is_named || (put_into(r, o->folder, &w->file) && put_into(r, o->folder, &w->plot.file));
}

static bool read_want(const struct reading *r, const config_setting_t *at)
{
  struct scene_want *w = &r->scene->want[r->scene->wants++];
  *w = (struct scene_want){ .accuracy = OF_DOUBLES, .periods = 10, .samples = 40, .tolerance = 0.1 };
  w->column = calloc(SCENE_COLUMNS, sizeof *w->column);
  if (!w->column)
    return refuse_at(r, at, "out of memory");
  if (!config_setting_is_group(at))
    return refuse_at(r, at, "want is a list of groups: ( { what = \"steady\"; file = \"steady.tsv\"; } )");
  if (!read_output(r, at, w))
    return false;
  if (!w->what)
    return refuse_at(r, at, "what is wanted? what = \"steady\", for one");
  int kind = find_kind(r, at, w->what);
  if (kind == KINDS)
    return false;
  w->kind = kinds[kind].kind;
  const config_setting_t *plot = config_setting_get_member(at, "plot");
  return (w->kind == WANT_COMMAND ? read_command(r, at, w) : read_own(r, at, w, kind)) && (!plot || read_plot(r, plot, w))
         && place(r, w);
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
