/* A scene as a whole: its file, its crawler and its start. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/scenes/parts.h"

static bool read_parameter(const struct reading *r, const config_setting_t *at)
{
  struct point *base = &r->scene->base;
  const char *name = config_setting_name(at), *text = text_of(r, at);
  int place = crawler_place(name);
  bool is_gait = place == CRAWLER_NUMBERS;
  if (!name_among(crawler_parameters, name))
    return refuse_at(r, at, "there is no '%s' in a crawler%s", name, did_you_mean(nearest(name, crawler_parameters)));
  if (is_gait ? base->has_gait : base->written[place] != NULL) /* on the command line */
    return true;
  if (text && is_gait)
    text = gait_beside(r, text);
  const char *wrong = text ? point_set(base, name, text) : "it takes a number, or a text in quotes";
  return !wrong || refuse_at(r, at, "%s: %s", name, wrong);
}

static bool read_crawler(const struct reading *r, const config_setting_t *crawler)
{
  point_complete(&r->scene->base);
  if (crawler && !config_setting_is_group(crawler))
    return refuse_at(r, crawler, "crawler is a group of parameters: { F1 = 3.0; T = 0.5; }");
  for (int i = 0; crawler && i < config_setting_length(crawler); i++)
    if (!read_parameter(r, member_at(crawler, i)))
      return false;
  point_complete(&r->scene->base);
  return true;
}

static bool read_start(const struct reading *r, const config_setting_t *start)
{
  struct scene *s = r->scene;
  const char *text = start ? text_of(r, start) : "rest";
  if (text && strcmp(text, "steady") == 0)
    s->start = START_STEADY;
  else if (!text || strcmp(text, "rest") != 0) {
    if (!text || point_set(&s->base, "v0", text))
      return refuse_at(r, start, "start is \"rest\", \"steady\" or a velocity");
    s->start = s->base.v0 == 0 ? START_REST : START_VELOCITY;
  }
  return true;
}

/* The head of a table, and its picture, show them as they are. */
static bool are_lines(const struct reading *r, const config_setting_t *root)
{
  const struct scene *s = r->scene;
  bool fine = !s->title || is_shown(s->title);
  for (int i = 0; i < s->notes; i++)
    fine &= is_shown(s->note[i]);
  return fine || refuse_at(r, root, "title and notes are lines of UTF-8, without a line break or another control character");
}

static bool read_root(const struct reading *r, const config_setting_t *root)
{
  static const char *const phases[] = { "extension", "contraction", NULL };
  static const struct member members[] = { MEMBER(TEXT, "title", scene, title, ),
                                           MEMBER(TEXTS, "notes", scene, note, .high = SCENE_NOTES,
                                                  .count = offsetof(struct scene, notes)),
                                           MEMBER(WORD, "phase", scene, phase, .words = phases),
                                           OTHER("crawler"),
                                           OTHER("start"),
                                           OTHER("vary"),
                                           OTHER("want"),
                                           { .name = NULL } };
  if (!read_members(r, root, members, r->scene, "a scene", NULL) || !are_lines(r, root))
    return false;
  return read_crawler(r, config_setting_get_member(root, "crawler"))
         && read_start(r, config_setting_get_member(root, "start")) && read_vary(r, config_setting_get_member(root, "vary"))
         && read_wants(r, config_setting_get_member(root, "want"));
}

static char *name_of(const char *path)
{
  const char *slash = strrchr(path, '/'), *base = slash ? slash + 1 : path;
  size_t length = strlen(base);
  if (length > 4 && strcmp(base + length - 4, ".cfg") == 0)
    length -= 4;
  return strndup(base, length);
}

static enum exit_code parse(const struct reading *r, const struct scene_source *source, config_t *file)
{
  const char *command = r->options->request.style.command, *slash = strrchr(source->path, '/');
  char folder[4096], *text = NULL;
  if (slash && !source->text) {
    snprintf(folder, sizeof folder, "%.*s", (int)(slash - source->path), source->path);
    config_set_include_dir(file, folder);
  }
  enum exit_code code = source->text ? EXIT_DONE : scene_text_read(command, source->path, &text);
  if (code != EXIT_DONE)
    return code;
  const char *whole = source->text ? source->text : text;
  if (!check_text(r, whole))
    code = EXIT_USAGE;
  else if (!config_read_string(file, whole)) {
    const char *at = config_error_file(file), *said = config_error_text(file);
    bool mixed = said && strstr(said, "mismatched element type") != NULL;
    complain(command, "%s:%d: %s%s", at ? at : r->path, config_error_line(file), said,
             mixed ? ": within [ ] all are written alike, [1.0, 2.5]; within ( ) they need not be" : "");
    code = EXIT_USAGE;
  }
  free(text);
  return code;
}

void scene_free(struct scene *s)
{
  while (s->kept) {
    struct kept *first = s->kept;
    s->kept = first->next;
    free(first);
  }
  sweep_free(&s->sweep);
  for (int w = 0; w < s->wants; w++)
    free(s->want[w].arguments), free(s->want[w].column);
  free(s->name);
  if (s->file)
    config_destroy(s->file);
  free(s->file);
  *s = (struct scene){ .name = NULL };
}

enum exit_code scene_read(struct scene *s, const struct scene_source *source, const struct scene_options *options,
                          scene_command *run_command)
{
  config_t *file = malloc(sizeof *file);
  *s = (struct scene){ .name = name_of(source->path),
                       .path = source->text ? NULL : source->path,
                       .base = options->request.point,
                       .run_command = run_command,
                       .file = file };
  const struct reading r = { s, options, source->path };
  enum exit_code code = EXIT_UNSOLVED;
  if (file)
    config_init(file);
  if (!file || !s->name)
    refuse_at(&r, NULL, "out of memory");
  else
    code = parse(&r, source, file);
  if (code == EXIT_DONE && !read_root(&r, config_root_setting(file)))
    code = EXIT_USAGE;
  if (code == EXIT_DONE)
    make_plan(s);
  else
    scene_free(s);
  return code;
}
