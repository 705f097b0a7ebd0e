/* Where the tables of a scene and their pictures go. */
#include <stdio.h>
#include <string.h>

#include "compare/scenes/scene.h"
#include "compare/text/file.h"
#include "compare/text/shipped.h"

const char *scene_text_of_list(struct scene *s, const config_setting_t *at)
{
  const char *text = element_count(at) > 0 ? text_of(&s->config, element_at(at, 0)) : "";
  for (int i = 1; i < element_count(at) && text; i++) {
    const char *next = text_of(&s->config, element_at(at, i));
    text = next ? keep(&s->config, "%s,%s", text, next) : NULL;
  }
  return text;
}

/* A script is a file beside the scene or, with a name that has neither '/' nor '.', comes with the tool. */
static bool find_script(struct scene *s, const config_setting_t *at, struct plot *p)
{
  if (strpbrk(p->script, "/.")) {
    p->script = path_beside(&s->config, p->script);
    FILE *script = p->script ? file_read(p->script) : NULL; /* and no table takes its place */
    if (!script)
      return p->script && refuse_at(&s->config, at, "cannot read the plot script %s", p->script);
    fclose(script);
    return true;
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

/* A member is what an option says: x_range what --plot-x-range does. */
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

bool scene_read_files(struct scene_files *f, struct scene *s, const config_setting_t *want, const struct style *style)
{
  const struct style *given = &s->request.style;
  const config_setting_t *file = config_setting_get_member(want, "file");
  const config_setting_t *plot = config_setting_get_member(want, "plot");
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
                     "a plot is made from a table in a file, format tsv: this want needs file = \"...\"");
  if (plot && !read_plot(s, &f->plot, plot))
    return false;
  f->has_plot = plot && style->format == FORMAT_TSV;
  f->plot.meaning = quantity_meaning;
  f->plot.title = f->plot.title ? f->plot.title : s->head.title;
  return true;
}
