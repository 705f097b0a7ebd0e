/* Tables of a scene: their options, columns and files. */
#include "compare/command/scene_table.h"

#include <string.h>

/* Kinds of table in a scene, with their commands and options */
static const struct kind {
  const char *name;
  const struct command *command;
  const char *option[2][2];
} kinds[] = {
  { "trajectory", &command_trajectory, { { NULL } } },
  { "phase", &command_phase, { { NULL } } },
  { "steady", &command_steady, { { NULL } } },
  { "series", &command_series, { { "rows", "" }, { "parts", "value" } } },
  { "error", &command_series, { { "rows", "" }, { "parts", "value,exact,error,relative" } } },
  { "orders", &command_series, { { "orders", "" } } },
  { "terms", &command_series, { { "source", "derived" } } },
  { "bounds", &command_series, { { "bound", "" } } },
  { "breakdown", &command_breakdown, { { NULL } } },
  { "stability", &command_stress, { { NULL } } },
  { "work-precision", &command_workprec, { { NULL } } },
  { "claims", &command_claims, { { NULL } } },
};

static const struct kind *find_kind(struct scene *s, const config_setting_t *at)
{
  enum { KINDS = sizeof kinds / sizeof *kinds };
  const char *names[KINDS + 1] = { NULL }, *text = text_of(&s->config, at);
  for (int i = 0; i < KINDS; i++)
    names[i] = kinds[i].name;
  int place = text ? word_place(text, names) : -1;
  if (text && place < 0)
    refuse_at(&s->config, at, "unknown table '%.80s'%s", text, name_hint(text, names));
  return place < 0 ? NULL : &kinds[place];
}

/* Sets the option with the name of a member; true sets a flag. Returns NULL, or an error. */
static const char *take_member(struct scene_table *w, struct scene *s, const config_setting_t *at,
                               const struct option *o)
{
  const char *texts[MAX_VALUES] = { NULL };
  int values = option_values(o), count = values > 1 ? element_count(at) : 1;
  if (config_setting_type(at) == CONFIG_TYPE_BOOL)
    return config_setting_get_bool(at) ? option_take(&w->arguments, o, texts, 0) : NULL;
  for (int i = 0; i < count && count <= MAX_VALUES; i++) {
    texts[i] = values > 1 ? text_of(&s->config, element_at(at, i)) : scene_text_of_list(s, at);
    if (!texts[i] || !*texts[i])
      return wrong_text("%s takes what it takes on the command line: a number, a text, or true",
                        config_setting_name(at));
  }
  return option_take(&w->arguments, o, texts, count);
}

/* Sets options from all members; "of" is the option --only if the command has no option --of. */
static bool take_members(struct scene_table *w, struct scene *s, const config_setting_t *at)
{
  static const char *const read_elsewhere[] = { "kind", "file", "plot", NULL };
  const struct command *command = w->arguments.command;
  for (int i = 0; i < config_setting_length(at); i++) {
    const config_setting_t *member = member_at(at, i);
    const char *name = config_setting_name(member);
    const struct option *o = option_of(command, name);
    if (name_among(read_elsewhere, name))
      continue;
    if (!o && strcmp(name, "of") == 0)
      o = option_of(command, "only");
    const char *wrong = name_among(crawler_parameters, name) ? wrong_text("%s belongs into the crawler", name)
                        : o                                  ? take_member(w, s, member, o)
                                                             : option_unknown(&w->arguments, name, name);
    if (wrong)
      return refuse_at(&s->config, member, "%s", wrong);
  }
  return true;
}

/* Copies the parameters that the scene gives; the command's defaults remain for the others. */
static void take_parameters(struct point *p, const struct point *base)
{
  for (int i = 0; i < POINT_NUMBERS; i++)
    if (base->written[i])
      point_set_number(p, i, base->written[i]);
  if (base->has_gait)
    p->crawler.gait = base->crawler.gait;
  p->has_gait |= base->has_gait;
  point_complete(p);
}

/* Sets an option of the kind of table. */
static void take_named(struct scene_table *w, const char *name, const char *const *value)
{
  const struct option *o = option_of(w->arguments.command, name);
  option_take(&w->arguments, o, value, option_values(o));
}

/* Sets the options of the table's command, from the scene and the command line. rows: for a table of rows */
static bool read_options(struct scene_table *w, struct scene *s, const config_setting_t *at, const struct kind *kind,
                         const struct style *given, struct rows *rows)
{
  struct request *r = &w->arguments.options.request;
  options_initial(&w->arguments, kind->command);
  r->required = s->request.required;
  for (int i = 0; i < 2 && kind->option[i][0]; i++)
    take_named(w, kind->option[i][0], &kind->option[i][1]);
  if (!take_members(w, s, at))
    return false;
  bool has_own_points = kind->command == &command_breakdown;
  w->rows = command_has_rows(kind->command, r) && !has_own_points ? rows : NULL;
  r->style.quiet |= given->quiet;
  r->style.digits = given->digits > 0 && option_of(kind->command, "digits") ? given->digits : r->style.digits;
  r->style.format = given->has_format ? given->format : r->style.format;
  r->style.has_format = true;
  if (w->rows) {
    r->style.command = given->command;
    r->scene = &s->head;
    r->sweep = s->request.sweep;
    r->point = s->request.point;
  } else {
    take_parameters(&r->point, &s->request.point);
    if (s->request.sweep.products > 0)
      return refuse_at(&s->config, at,
                       "%s varies, and kind = \"%s\" is the whole table of a command, for one crawler: leave out "
                       "'vary', and run the command once for each value",
                       sweep_variable(&s->request.sweep, 0)->name, kind->name);
  }
  return options_complete(&w->arguments)
         || refuse_at(&s->config, at, "the command behind kind = \"%s\" refuses these options", kind->name);
}

/* Plans rows and columns. chosen: the columns of the command line, or NULL */
static bool plan_rows(struct scene_table *w, struct scene *s, const config_setting_t *at,
                      const struct table_choice *chosen)
{
  const struct request *r = &w->arguments.options.request;
  const config_setting_t *columns = config_setting_get_member(at, "columns");
  const struct table_choice *own = r->style.choice;
  *w->rows = (struct rows){ .request = r, .sheet.required = s->request.required };
  const char *wrong = w->arguments.command->plan(r, w->rows);
  for (int i = 0; chosen && own && i < own->count && !wrong; i++) /* from the names of columns in the scene too */
    wrong = rows_own(w->rows, "%s", own->names[i]);
  w->rows->choice = chosen;
  if (wrong)
    return refuse_at(&s->config, at, "%s", wrong);
  wrong = rows_columns(w->rows);
  if (wrong && chosen)
    return complain(s->config.command, "--columns: %s", wrong);
  return !wrong || refuse_at(&s->config, columns ? columns : at, "%s", wrong);
}

/* Returns true if a path stays below its folder; links are not followed. */
static bool goes_down(const char *path)
{
  bool up = *path == '/';
  for (const char *part = path; part && !up; part = strchr(part, '/')) {
    part += strspn(part, "/");
    up = strncmp(part, "..", 2) == 0 && (part[2] == '/' || part[2] == '\0');
  }
  return !up;
}

/* Puts a file of the scene below the folder of the command line, if any. */
static bool place(struct scene *s, const config_setting_t *group, const char *folder, const char **file)
{
  if (!folder || !*file)
    return true;
  if (!goes_down(*file))
    return refuse_at(&s->config, config_setting_get_member(group, "file"),
                     "'%.200s' may lie outside of %.200s, the folder of --into: a path without / in front and without "
                     ".. is allowed",
                     *file, folder);
  *file = keep(&s->config, "%s/%s", folder, *file);
  return *file != NULL;
}

/* Sets the files of table and plot, as the command line states. */
static bool place_files(struct scene_table *w, struct scene *s, const config_setting_t *at,
                        const struct scene_options *o)
{
  struct scene_files *f = &w->files;
  const config_setting_t *plot = config_setting_get_member(at, "plot");
  if (o->request.style.has_output)
    f->table = o->request.style.output;
  else if (!place(s, at, o->folder, &f->table) || !place(s, plot, o->folder, &f->plot.file))
    return false;
  f->has_plot &= f->table && !o->no_plots;
  if (!f->plot.x || !f->plot.y) /* the kind of table determines the picture */
    f->plot.of = w->rows && w->rows->of ? w->rows->of : w->arguments.command->name;
  f->plot.table = w->arguments.options.request.style.output = f->table;
  return true;
}

static bool read_scene_table(struct planned_scene *all, struct scene_table *w, const config_setting_t *at,
                             const struct scene_options *o)
{
  struct scene *s = &all->scene;
  struct style *style = &w->arguments.options.request.style;
  if (!config_setting_is_group(at))
    return refuse_at(&s->config, at, "tables is a list of groups: ( { kind = \"steady\"; file = \"steady.tsv\"; } )");
  const config_setting_t *what = config_setting_get_member(at, "kind");
  if (!what)
    return refuse_at(&s->config, at, "the kind of table is missing: kind = \"steady\", for example");
  const struct kind *kind = find_kind(s, what);
  if (!kind || !read_options(w, s, at, kind, &o->request.style, &all->rows[all->tables])
      || !scene_read_files(&w->files, s, at, style))
    return false;
  all->tables += w->rows != NULL;
  style->plot = w->files.plot; /* the table gets its columns too */
  bool is_planned = !w->rows || plan_rows(w, s, at, o->request.style.choice);
  style->plot = o->request.style.plot; /* of figure */
  return is_planned && place_files(w, s, at, o);
}

enum exit_code planned_scene_read(struct planned_scene *all, const struct scene_source *source,
                                  const struct scene_options *o)
{
  enum exit_code code = scene_read(&all->scene, source, &o->request);
  for (int i = 0; i < all->scene.tables && code == EXIT_DONE; i++)
    code = read_scene_table(all, &all->table[i], all->scene.table[i], o) ? EXIT_DONE : EXIT_USAGE;
  return code;
}

void planned_scene_free(struct planned_scene *all)
{
  for (struct scene_table *w = all->table; w < all->table + all->scene.tables; w++) {
    if (w->rows) /* the scene owns the points, and the list of requested quantities */
      w->arguments.options.request.sweep = (struct sweep){ .products = 0 };
    w->arguments.options.request.required = NULL;
    options_free(&w->arguments);
  }
  for (int i = 0; i < all->tables; i++)
    rows_free(&all->rows[i]);
  scene_free(&all->scene);
}
