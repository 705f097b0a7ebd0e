#include <stdlib.h>
#include <string.h>

#include "compare/answers/at.h"
#include "compare/book/book.h"
#include "compare/scenes/scene.h"

static bool read_parameter(struct scene *s, const config_setting_t *at)
{
  struct point *base = &s->request.point;
  const char *name = config_setting_name(at), *text = text_of(&s->config, at);
  int place = crawler_place(name);
  bool is_gait = place == CRAWLER_NUMBERS;
  if (!name_among(crawler_parameters, name))
    return refuse_at(&s->config, at, "there is no '%s' in a crawler%s", name,
                     did_you_mean(nearest(name, crawler_parameters)));
  if (is_gait ? base->has_gait : base->written[place] != NULL) /* on the command line */
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
  s->request.asked->from_steady = text && strcmp(text, "steady") == 0;
  if (s->request.asked->from_steady || (text && strcmp(text, "rest") == 0))
    return true;
  return (text && !point_set(base, "v0", text))
         || refuse_at(&s->config, start, "start is \"rest\", \"steady\" or a velocity");
}

/* The head of a table, and its picture, show them as they are. */
static bool are_lines(const struct scene *s, const config_setting_t *root)
{
  bool fine = !s->head.title || is_shown(s->head.title);
  for (int i = 0; i < s->head.notes; i++)
    fine &= is_shown(s->head.note[i]);
  return fine
         || refuse_at(&s->config, root,
                      "title and notes are lines of UTF-8, without a line break or another control character");
}

static bool take_wants(struct scene *s, const config_setting_t *want)
{
  s->wants = want ? element_count(want) : 0;
  if (s->wants == 0)
    return refuse_at(&s->config, want, "nothing is wanted: want = ( { what = \"steady\"; } );");
  if (s->wants > SCENE_WANTS)
    return refuse_at(&s->config, want, "%d wants: %d at most", s->wants, SCENE_WANTS);
  for (int i = 0; i < s->wants; i++)
    s->want[i] = element_at(want, i);
  return true;
}

static bool read_root(struct scene *s, const config_setting_t *root)
{
  static const char *const phases[] = { "extension", "contraction", NULL };
  static const struct member members[] = { MEMBER(TEXT, "title", scene, head.title, ),
                                           MEMBER(TEXTS, "notes", scene, head.note, .high = MOST_NOTES,
                                                  .count = offsetof(struct scene, head.notes)),
                                           MEMBER(WORD, "phase", scene, request.point.phase, .words = phases),
                                           MEMBER(TEXT, "book", scene, book, ),
                                           OTHER("crawler"),
                                           OTHER("start"),
                                           OTHER("vary"),
                                           OTHER("want"),
                                           { .name = NULL } };
  const config_setting_t *start = config_setting_get_member(root, "start");
  if (!read_members(&s->config, root, members, s, "a scene") || !are_lines(s, root))
    return false;
  s->head.is_about_phase = start || config_setting_get_member(root, "phase");
  const char *book = s->book ? path_beside(&s->config, s->book) : NULL;
  if (s->book && (!book || book_read(s->config.command, book, NULL, quantity_is_other) != EXIT_DONE))
    return false;
  return read_crawler(s, config_setting_get_member(root, "crawler")) && read_start(s, start)
         && scene_read_vary(s, config_setting_get_member(root, "vary"))
         && take_wants(s, config_setting_get_member(root, "want"));
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
  sweep_free(&s->request.sweep);
  asked_free(s->request.asked);
  free(s->name);
  config_close(&s->config);
  *s = (struct scene){ .name = NULL };
}

enum exit_code scene_read(struct scene *s, const struct scene_source *source, const struct request *given)
{
  *s = (struct scene){
    .name = name_of(source->path),
    .head.given = &given->point,
    .request = { .style = given->style, .point = given->point, .asked = asked_nothing(given->style.command) }
  };
  s->head.scene = s->name;
  s->request.scene = &s->head;
  enum exit_code code = config_open(&s->config, given->style.command, source->path, source->text, shipped_scenes);
  if (code == EXIT_DONE && (!s->name || !s->request.asked)) {
    refuse_at(&s->config, NULL, "out of memory");
    return EXIT_UNSOLVED;
  }
  return code == EXIT_DONE && !read_root(s, config_root(&s->config)) ? EXIT_USAGE : code;
}
