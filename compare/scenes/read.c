/* Reading of a scene: its crawler, start, list of tables, and the output files of these. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/at.h"
#include "compare/formulas/formula_file.h"
#include "compare/scenes/scene.h"
#include "compare/text/file.h"
#include "compare/text/shipped.h"

static bool read_parameter(struct scene *s, const config_setting_t *at)
{
  struct point *base = &s->request.point;
  const char *name = config_setting_name(at), *text = text_of(&s->config, at);
  int place = crawler_place(name);
  bool is_gait = place == CRAWLER_NUMBERS;
  if (!name_among(crawler_parameters, name))
    return refuse_at(&s->config, at, "a crawler has no parameter '%s'%s", name,
                     did_you_mean(nearest(name, crawler_parameters)));
  if (is_gait ? base->has_gait : base->written[place] != NULL) /* given on the command line */
    return true;
  if (text && is_gait)
    text = gait_beside(&s->config, text);
  const char *wrong = text ? point_set(base, name, text) : "it takes a number, or a text in quotes";
  return !wrong || refuse_at(&s->config, at, "%s: %s", name, wrong);
}

static bool read_crawler(struct scene *s, const config_setting_t *crawler)
{
  point_complete(&s->request.point);
  if (crawler && !config_setting_is_group(crawler))
    return refuse_at(&s->config, crawler, "crawler is a group of parameters: { F1 = 3.0; T = 0.5; }");
  for (int i = 0; crawler && i < config_setting_length(crawler); i++)
    if (!read_parameter(s, member_at(crawler, i)))
      return false;
  point_complete(&s->request.point);
  return true;
}

static bool read_start(struct scene *s, const config_setting_t *start)
{
  const char *text = start ? text_of(&s->config, start) : "rest";
  struct point *base = &s->request.point;
  base->has_v0 = false;
  s->request.required->from_steady = text && strcmp(text, "steady") == 0;
  if (s->request.required->from_steady || (text && strcmp(text, "rest") == 0))
    return true;
  return (text && !point_set(base, "v0", text))
         || refuse_at(&s->config, start, "start is \"rest\", \"steady\" or a velocity");
}

/* Checks title and notes: heads and pictures show them unchanged. */
static bool are_lines(const struct scene *s, const config_setting_t *root)
{
  bool fine = !s->head.title || is_shown(s->head.title);
  for (int i = 0; i < s->head.notes; i++)
    fine = fine && is_shown(s->head.note[i]);
  return fine
         || refuse_at(&s->config, root,
                      "title and notes are lines of UTF-8, without a line break or another control character");
}

static bool take_tables(struct scene *s, const config_setting_t *table)
{
  s->tables = table ? element_count(table) : 0;
  if (s->tables == 0)
    return refuse_at(&s->config, table, "no table is requested: tables = ( { kind = \"steady\"; } );");
  if (s->tables > SCENE_TABLES)
    return refuse_at(&s->config, table, "%d tables: %d at most", s->tables, SCENE_TABLES);
  for (int i = 0; i < s->tables; i++)
    s->table[i] = element_at(table, i);
  return true;
}

static bool read_root(struct scene *s, const config_setting_t *root)
{
  static const char *const phases[] = { "extension", "contraction", NULL };
  static const struct member members[] = { MEMBER(TEXT, "title", scene, head.title, ),
                                           MEMBER(TEXTS, "notes", scene, head.note, .high = MAX_NOTES,
                                                  .count = offsetof(struct scene, head.notes)),
                                           MEMBER(WORD, "phase", scene, request.point.phase, .words = phases),
                                           MEMBER(TEXT, "formulas", scene, formulas, ),
                                           OTHER("crawler"),
                                           OTHER("start"),
                                           OTHER("vary"),
                                           OTHER("tables"),
                                           { .name = NULL } };
  const config_setting_t *start = config_setting_get_member(root, "start");
  if (!read_members(&s->config, root, members, s, "a scene") || !are_lines(s, root))
    return false;
  s->head.is_about_phase = start || config_setting_get_member(root, "phase");
  const char *formulas = s->formulas ? path_beside(&s->config, s->formulas) : NULL;
  if (s->formulas
      && (!formulas || formula_file_read(s->config.command, formulas, NULL, quantity_is_other) != EXIT_DONE))
    return false;
  return read_crawler(s, config_setting_get_member(root, "crawler")) && read_start(s, start)
         && scene_read_vary(s, config_setting_get_member(root, "vary"))
         && take_tables(s, config_setting_get_member(root, "tables"));
}

static char *name_of(const char *path)
{
  const char *slash = strrchr(path, '/'), *base = slash ? slash + 1 : path;
  const size_t length = strlen(base);
  return strndup(base, length > 4 && strcmp(base + length - 4, ".cfg") == 0 ? length - 4 : length);
}

void scene_free(struct scene *s)
{
  sweep_free(&s->request.sweep);
  requirements_free(s->request.required);
  free(s->name);
  config_close(&s->config);
  *s = (struct scene){ .name = NULL };
}

enum exit_code scene_read(struct scene *s, const struct scene_source *source, const struct request *given)
{
  *s = (struct scene){
    .name = name_of(source->path),
    .head.given = &given->point,
    .request = { .style = given->style, .point = given->point, .required = requirements_new(given->style.command) }
  };
  s->head.scene = s->name;
  s->request.scene = &s->head;
  enum exit_code code = config_open(&s->config, given->style.command, source->path, source->text, shipped_scenes);
  if (code == EXIT_DONE && (!s->name || !s->request.required)) {
    refuse_at(&s->config, NULL, "out of memory");
    return EXIT_UNSOLVED;
  }
  return code == EXIT_DONE && !read_root(s, config_root(&s->config)) ? EXIT_USAGE : code;
}

const char *scene_text_of_list(struct scene *s, const config_setting_t *at)
{
  const char *text = element_count(at) > 0 ? text_of(&s->config, element_at(at, 0)) : "";
  for (int i = 1; i < element_count(at) && text; i++) {
    const char *next = text_of(&s->config, element_at(at, i));
    text = next ? keep(&s->config, "%s,%s", text, next) : NULL;
  }
  return text;
}

/* Finds the plot script: a name without '/' and '.' is a script of the tool, another one a file beside the scene. */
static bool find_script(struct scene *s, const config_setting_t *at, struct plot *p)
{
  if (strpbrk(p->script, "/.")) {
    p->script = path_beside(&s->config, p->script);
    FILE *script = p->script ? file_read(p->script) : NULL; /* prevents a table from replacing it */
    return script ? fclose(script) == 0
                  : p->script && refuse_at(&s->config, at, "cannot read the plot script %s", p->script);
  }
  const char *near = nearest_in(p->script, shipped_scripts, sizeof *shipped_scripts);
  p->picture = shipped_text(shipped_scripts, p->script) ? p->script : NULL;
  if (!p->picture)
    return refuse_at(
        &s->config, at,
        "no plot script '%.80s' comes with the tool%s The name of a script of yours has an ending: '%.80s.gp'",
        p->script, near ? did_you_mean(near) : ".", p->script);
  p->script = NULL;
  return true;
}

/* Sets a member of the plot by the option of the same meaning: x_range by --plot-x-range. */
static bool take_member(struct scene *s, struct plot *p, const config_setting_t *at)
{
  const char *name = config_setting_name(at), *text = scene_text_of_list(s, at);
  char option[40];
  snprintf(option, sizeof option, strcmp(name, "file") == 0 ? "plot" : "plot-%s", name);
  for (char *c = option; *c; c++)
    *c = *c == '_' ? '-' : *c;
  const char *wrong = text ? plot_set(p, option, text) : "it takes a text";
  return !wrong || refuse_at(&s->config, at, "%s: %s", name, wrong);
}

static bool read_plot(struct scene *s, struct plot *p, const config_setting_t *at)
{
  static const struct member members[] = { OTHER("file"),
                                           MEMBER(TEXT, "script", plot, script, ),
                                           OTHER("x"),
                                           OTHER("y"),
                                           OTHER("by"),
                                           MEMBER(FLAG, "log_x", plot, log_x, ),
                                           MEMBER(FLAG, "log_y", plot, log_y, ),
                                           OTHER("title"),
                                           OTHER("size"),
                                           OTHER("x_range"),
                                           OTHER("y_range"),
                                           { .name = NULL } };
  if (!config_setting_is_group(at))
    return refuse_at(&s->config, at, "plot is a group: { file = \"error.svg\"; x = \"T\"; y = \"error\"; }");
  if (!read_members(&s->config, at, members, p, "a plot"))
    return false;
  for (const struct member *m = members; m->name; m++) {
    const config_setting_t *member = config_setting_get_member(at, m->name);
    if (member && m->kind == MEMBER_OTHER && !take_member(s, p, member))
      return false;
  }
  if (!p->file)
    return refuse_at(&s->config, at, "a plot needs a file that ends in .svg, .png or .pdf");
  return !p->script || find_script(s, at, p);
}

bool scene_read_files(struct scene_files *f, struct scene *s, const config_setting_t *table, const struct style *style)
{
  const struct style *given = &s->request.style;
  const config_setting_t *file = config_setting_get_member(table, "file");
  const config_setting_t *plot = config_setting_get_member(table, "plot");
  f->table = file ? text_of(&s->config, file) : NULL;
  if (file && (!f->table || !*f->table))
    return refuse_at(&s->config, file, "file is a text");
  if (f->table && strcmp(f->table, "-") == 0)
    f->table = NULL;
  if (f->table && plot_kind(f->table))
    return refuse_at(&s->config, file,
                     "'%.200s' is the name of a picture, and the table is written there: plot = { file = ... } draws "
                     "one",
                     f->table);
  if (plot && (!f->table || (style->format != FORMAT_TSV && !given->has_format)))
    return refuse_at(&s->config, plot,
                     "a plot is made from a table in a file, format tsv: this table needs file = \"...\"");
  if (plot && !read_plot(s, &f->plot, plot))
    return false;
  f->has_plot = plot && style->format == FORMAT_TSV;
  f->plot.meaning = quantity_meaning;
  f->plot.title = f->plot.title ? f->plot.title : s->head.title;
  return true;
}
