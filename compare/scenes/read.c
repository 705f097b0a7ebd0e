/* A scene as a whole: its file, its crawler and its start. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/book/book.h"
#include "compare/scenes/parts.h"

static bool read_parameter(const struct reading *r, const config_setting_t *at)
{
  struct point *base = &r->scene->base;
  const char *name = config_setting_name(at), *text = text_of(r->config, at);
  int place = crawler_place(name);
  bool is_gait = place == CRAWLER_NUMBERS;
  if (!name_among(crawler_parameters, name))
    return refuse_at(r->config, at, "there is no '%s' in a crawler%s", name,
                     did_you_mean(nearest(name, crawler_parameters)));
  if (is_gait ? base->has_gait : base->written[place] != NULL) /* on the command line */
    return true;
  if (text && is_gait)
    text = gait_beside(r->config, text);
  const char *wrong = text ? point_set(base, name, text) : "it takes a number, or a text in quotes";
  return !wrong || refuse_at(r->config, at, "%s: %s", name, wrong);
}

static bool read_crawler(const struct reading *r, const config_setting_t *crawler)
{
  point_complete(&r->scene->base);
  if (crawler && !config_setting_is_group(crawler))
    return refuse_at(r->config, crawler, "crawler is a group of parameters: { F1 = 3.0; T = 0.5; }");
  for (int i = 0; crawler && i < config_setting_length(crawler); i++)
    if (!read_parameter(r, member_at(crawler, i)))
      return false;
  point_complete(&r->scene->base);
  return true;
}

static bool read_start(const struct reading *r, const config_setting_t *start)
{
  struct scene *s = r->scene;
  const char *text = start ? text_of(r->config, start) : "rest";
  if (text && strcmp(text, "steady") == 0)
    s->start = START_STEADY;
  s->asked.from_steady = s->start == START_STEADY;
  if (s->asked.from_steady)
    s->base.has_v0 = false;
  else if (!text || strcmp(text, "rest") != 0) {
    if (!text || point_set(&s->base, "v0", text))
      return refuse_at(r->config, start, "start is \"rest\", \"steady\" or a velocity");
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
  return fine
         || refuse_at(r->config, root,
                      "title and notes are lines of UTF-8, without a line break or another control character");
}

static bool read_root(const struct reading *r, const config_setting_t *root)
{
  static const char *const phases[] = { "extension", "contraction", NULL };
  static const struct member members[] = { MEMBER(TEXT, "title", scene, title, ),
                                           MEMBER(TEXTS, "notes", scene, note, .high = SCENE_NOTES,
                                                  .count = offsetof(struct scene, notes)),
                                           MEMBER(WORD, "phase", scene, phase, .words = phases),
                                           MEMBER(TEXT, "book", scene, book, ),
                                           OTHER("crawler"),
                                           OTHER("start"),
                                           OTHER("vary"),
                                           OTHER("want"),
                                           { .name = NULL } };
  if (!read_members(r->config, root, members, r->scene, "a scene", NULL) || !are_lines(r, root))
    return false;
  r->scene->base.phase = r->scene->phase;
  const char *book = r->scene->book ? path_beside(r->config, r->scene->book) : NULL;
  if (r->scene->book && (!book || book_read(r->config->command, book, quantity_is_other) != EXIT_DONE))
    return false;
  return read_crawler(r, config_setting_get_member(root, "crawler"))
         && read_start(r, config_setting_get_member(root, "start"))
         && read_vary(r, config_setting_get_member(root, "vary"))
         && read_wants(r, config_setting_get_member(root, "want"));
}

/* How well certified answers and errors must be known for all wants */
static void find_needs(struct scene *s)
{
  struct asked *a = &s->asked;
  for (int i = 0; i < s->wants; i++) {
    struct scene_want *w = &s->want[i];
    int places[WANT_QUANTITIES];
    bool has_errors = false;
    for (int k = want_quantities(w, places); k-- > 0;)
      has_errors |= a->quantities.item[places[k]].of >= 0;
    if (has_errors) {
      a->certified_errors |= w->reference == REFERENCE_CERTIFIED || w->accuracy < ACCURACY_OF_DOUBLES;
      a->accuracy = fmin(a->accuracy, w->accuracy);
    }
    if (w->kind == WANT_ROWS && w->digits > a->digits)
      a->digits = w->digits;
    w->sheet.digits = w->digits;
    s->needs_flint |= w->kind == WANT_COMMAND;
  }
  s->needs_flint |= asked_needs_flint(a);
}

static char *name_of(const char *path)
{
  const char *slash = strrchr(path, '/'), *base = slash ? slash + 1 : path;
  size_t length = strlen(base);
  if (length > 4 && strcmp(base + length - 4, ".cfg") == 0)
    length -= 4;
  return strndup(base, length);
}

void scene_free(struct scene *s)
{
  sweep_free(&s->sweep);
  for (int w = 0; w < s->wants; w++)
    free(s->want[w].arguments), sheet_free(&s->want[w].sheet);
  free(s->name);
  config_close(&s->config);
  *s = (struct scene){ .name = NULL };
}

enum exit_code scene_read(struct scene *s, const struct scene_source *source, const struct scene_options *options,
                          scene_command *run_command)
{
  *s = (struct scene){ .name = name_of(source->path),
                       .path = source->text ? NULL : source->path,
                       .base = options->request.point,
                       .run_command = run_command,
                       .asked = asked_nothing() };
  const struct reading r = { s, &s->config, options };
  enum exit_code code = config_open(&s->config, options->request.style.command, source->path, source->text,
                                    shipped_scenes);
  if (code == EXIT_DONE && !s->name) {
    refuse_at(r.config, NULL, "out of memory");
    code = EXIT_UNSOLVED;
  }
  if (code == EXIT_DONE && !read_root(&r, config_root(&s->config)))
    code = EXIT_USAGE;
  if (code == EXIT_DONE)
    find_needs(s);
  else
    scene_free(s);
  return code;
}
