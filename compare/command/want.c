#include "compare/command/want.h"

#include <stdlib.h>
#include <string.h>

#include "compare/command/commands.h"

/* The tables that a scene can want, and the options that their names stand for */
static const struct kind {
  const char *what;
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
enum { KINDS = sizeof kinds / sizeof *kinds };

static const struct kind *find_kind(struct scene *s, const config_setting_t *at)
{
  const char *names[KINDS + 1] = { NULL }, *text = at ? text_of(&s->config, at) : NULL;
  char list[200];
  for (int i = 0; i < KINDS; i++) {
    names[i] = kinds[i].what;
    if (text && strcmp(text, names[i]) == 0)
      return &kinds[i];
  }
  if (text)
    refuse_at(&s->config, at, "'%.80s' cannot be wanted, but one of %s%s", text, joined(list, sizeof list, names, ", "),
              did_you_mean(nearest(text, names)));
  return NULL;
}

static bool take(struct want *w, struct scene *s, const config_setting_t *at, const struct option *o, const char *text)
{
  const char *wrong = option_take(&w->arguments, o, text);
  return !wrong || refuse_at(&s->config, at, "%s", wrong);
}

/* A member with the value that the option of that name takes */
static bool take_option(struct want *w, struct scene *s, const config_setting_t *at, const struct option *o)
{
  const char *name = config_setting_name(at);
  int values = option_values(o), count = element_count(at);
  if (config_setting_type(at) == CONFIG_TYPE_BOOL)
    return values > 0 ? refuse_at(&s->config, at, "%s takes a value", name)
                      : !config_setting_get_bool(at) || take(w, s, at, o, NULL);
  if (values > 1 && count != values)
    return refuse_at(&s->config, at, "%s takes %d values", name, values);
  bool fine = true;
  for (int i = 0; i < values && fine; i++) {
    const char *text = values > 1 ? text_of(&s->config, element_at(at, i)) : scene_text_of_list(s, at);
    if (!text || !*text)
      return refuse_at(&s->config, at, "%s takes what it takes on the command line: a number, a text, or true", name);
    fine = take(w, s, at, o, text);
  }
  return fine && (values > 0 || refuse_at(&s->config, at, "%s is true or false", name));
}

/* The option of a member; "of" names series where the command has no such option. */
static const struct option *option_of_member(const struct command *command, const char *name)
{
  const struct option *o = option_of(command, name);
  return o || strcmp(name, "of") != 0 ? o : option_of(command, "only");
}

/* What does not vary is the scene's; what is not written there is the command's own. */
static void take_parameters(struct request *request, const struct scene *s, bool has_rows)
{
  const struct point *base = &s->request.point;
  struct point *p = &request->point;
  if (has_rows) {
    *p = *base;
    return;
  }
  for (int i = 0; i < POINT_NUMBERS; i++)
    if (base->written[i])
      point_set_number(p, i, base->written[i]);
  if (base->has_gait) {
    p->crawler.gait = base->crawler.gait;
    p->has_gait = true;
  }
  point_complete(p);
}

static bool take_members(struct want *w, struct scene *s, const config_setting_t *at)
{
  static const char *const read_elsewhere[] = { "what", "file", "plot", NULL };
  for (int i = 0; i < config_setting_length(at); i++) {
    const config_setting_t *member = member_at(at, i);
    const char *name = config_setting_name(member);
    const struct option *o = option_of_member(w->arguments.command, name);
    if (name_among(read_elsewhere, name))
      continue;
    if (name_among(crawler_parameters, name))
      return refuse_at(&s->config, member, "%s belongs into the crawler", name);
    if (!o)
      return refuse_at(&s->config, member, "%s", option_unknown(&w->arguments, name, name));
    if (!take_option(w, s, member, o))
      return false;
  }
  return true;
}

/* The options of the want's command, over what the scene and the command line say */
static bool read_options(struct want *w, struct scene *s, const config_setting_t *at, const struct kind *kind,
                         const struct scene_options *o)
{
  struct request *r = &w->arguments.options.request;
  const struct style *given = &o->request.style;
  options_initial(&w->arguments, kind->command);
  r->asked = s->request.asked;
  for (int i = 0; i < 2 && kind->option[i][0]; i++)
    option_take(&w->arguments, option_of(kind->command, kind->option[i][0]), kind->option[i][1]);
  if (!take_members(w, s, at))
    return false;
  w->has_rows = command_has_rows(kind->command, r) && !kind->command->complete; /* which has points of its own */
  take_parameters(r, s, w->has_rows);
  r->style.quiet |= given->quiet;
  r->style.digits = given->digits > 0 && option_of(kind->command, "digits") ? given->digits : r->style.digits;
  if (given->has_format)
    r->style.format = given->format;
  r->style.has_format = true;
  if (w->has_rows) {
    r->style.command = given->command;
    r->scene = &s->head;
    r->sweep = s->request.sweep;
  } else if (s->request.sweep.products > 0)
    return refuse_at(&s->config, at,
                     "%s varies, and what = \"%s\" is the whole table of a command, for one crawler: leave out 'vary', "
                     "and run the command once for each value",
                     sweep_variable(&s->request.sweep, 0)->name, kind->what);
  return options_are_sound(&w->arguments)
         || refuse_at(&s->config, at, "the command behind what = \"%s\" refuses these options", kind->what);
}

static bool plan_rows(struct want *w, struct scene *s, const config_setting_t *at, const struct table_choice *chosen)
{
  const struct command *command = w->arguments.command;
  const config_setting_t *columns = config_setting_get_member(at, "columns");
  const struct table_choice *own = w->arguments.options.request.style.choice;
  w->rows = (struct rows){ .request = &w->arguments.options.request, .sheet.asked = s->request.asked };
  const char *wrong = command->plan(&w->arguments.options, &w->rows);
  for (int i = 0; chosen && own && i < own->count && !wrong; i++) /* among the names that the scene gives, too */
    wrong = rows_own(&w->rows, "%s", own->names[i]);
  w->rows.choice = chosen;
  if (wrong)
    return refuse_at(&s->config, at, "%s", wrong);
  wrong = rows_columns(&w->rows);
  if (wrong && chosen)
    return complain(s->config.command, "--columns: %s", wrong);
  return !wrong || refuse_at(&s->config, columns ? columns : at, "%s", wrong);
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

/* A file of the scene, below the folder that the command line names, if it does */
static bool place(struct scene *s, const config_setting_t *group, const char *folder, const char **file)
{
  if (!folder || !*file)
    return true;
  if (!goes_down(*file))
    return refuse_at(&s->config, config_setting_get_member(group, "file"),
                     "'%.200s' may lie outside of %.200s, which --into names: a file is allowed that has no / in front "
                     "and no folder .. in its path",
                     *file, folder);
  *file = keep(&s->config, "%s/%s", folder, *file);
  return *file != NULL;
}

/* Where the command line says that files go */
static bool place_files(struct want *w, struct scene *s, const config_setting_t *at, const struct scene_options *o)
{
  struct scene_files *f = &w->files;
  const config_setting_t *plot = config_setting_get_member(at, "plot");
  if (o->request.style.has_output)
    f->table = o->request.style.output;
  else if (!place(s, at, o->folder, &f->table) || !place(s, plot, o->folder, &f->plot.file))
    return false;
  f->has_plot &= f->table && !o->no_plots;
  if (!f->plot.x || !f->plot.y) /* then the picture is that of such a table */
    f->plot.of = w->rows.of ? w->rows.of : w->arguments.command->name;
  f->plot.table = w->arguments.options.request.style.output = f->table;
  return true;
}

bool want_read(struct want *w, struct scene *s, const config_setting_t *at, const struct scene_options *o)
{
  struct style *style = &w->arguments.options.request.style;
  if (!config_setting_is_group(at))
    return refuse_at(&s->config, at, "want is a list of groups: ( { what = \"steady\"; file = \"steady.tsv\"; } )");
  const config_setting_t *what = config_setting_get_member(at, "what");
  if (!what)
    return refuse_at(&s->config, at, "what is wanted? what = \"steady\", for one");
  const struct kind *kind = find_kind(s, what);
  if (!kind || !read_options(w, s, at, kind, o) || !scene_read_files(&w->files, s, at, style))
    return false;
  style->plot = w->files.plot; /* the table has its columns, too */
  bool is_planned = !w->has_rows || plan_rows(w, s, at, o->request.style.choice);
  style->plot = o->request.style.plot; /* of figure */
  return is_planned && place_files(w, s, at, o);
}

void want_free(struct want *w)
{
  rows_free(&w->rows);
  if (w->has_rows)
    w->arguments.options.request.sweep = (struct sweep){ .products = 0 }; /* the scene's */
  w->arguments.options.request.asked = NULL;
  options_free(&w->arguments);
}
