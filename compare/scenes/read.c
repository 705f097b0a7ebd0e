#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/scenes/parts.h"
#include "compare/scenes/text.h"

/* ---- messages ---- */

bool refuse_at(const struct reading *r, const config_setting_t *at, const char *format, ...)
{
  char text[600];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  const char *file = at ? config_setting_source_file(at) : NULL;
  unsigned line = at ? (unsigned)config_setting_source_line(at) : 0;
  if (line > 0)
    complain(r->options->command->name, "%s:%u: %s", file ? file : r->path, line, text);
  else
    complain(r->options->command->name, "%s: %s", r->path, text);
  return false;
}

/* ---- members of a group ---- */

static int members(const config_setting_t *group) { return config_setting_length(group); }

static config_setting_t *member_at(const config_setting_t *group, int i)
{
  return config_setting_get_elem(group, (unsigned)i);
}

bool is_sequence(const config_setting_t *at)
{
  int type = config_setting_type(at);
  return type == CONFIG_TYPE_ARRAY || type == CONFIG_TYPE_LIST;
}

bool keys_known(const struct reading *r, const config_setting_t *group, const char *const *names, const char *what)
{
  for (int i = 0; i < members(group); i++) {
    const config_setting_t *member = member_at(group, i);
    const char *name = config_setting_name(member);
    int k = 0;
    while (names[k] && strcmp(name, names[k]) != 0)
      k++;
    if (names[k])
      continue;
    char known[300];
    size_t used = 0;
    for (k = 0; names[k] && used < sizeof known; k++)
      used += (size_t)snprintf(known + used, sizeof known - used, "%s%s", k > 0 ? ", " : "", names[k]);
    const char *near = nearest(name, names);
    return refuse_at(r, member, "there is no '%s' in %s: %s%s%s%s", name, what, near ? "did you mean '" : "it knows ",
                     near ? near : known, near ? "'?" : "", "");
  }
  return true;
}

bool read_member_text(const struct reading *r, const config_setting_t *group, const char *name, const char **value)
{
  const config_setting_t *at = config_setting_get_member(group, name);
  if (!at)
    return true;
  const char *text = config_setting_get_string(at);
  if (!text || *text == '\0')
    return refuse_at(r, at, "%s takes a text in quotes", name);
  *value = text;
  return true;
}

bool read_member_flag(const struct reading *r, const config_setting_t *group, const char *name, bool *value)
{
  const config_setting_t *at = config_setting_get_member(group, name);
  if (at && config_setting_type(at) != CONFIG_TYPE_BOOL)
    return refuse_at(r, at, "%s is true or false", name);
  if (at)
    *value = config_setting_get_bool(at) != 0;
  return true;
}

bool is_number(const config_setting_t *at, double *value, const char **text)
{
  *text = NULL;
  switch (config_setting_type(at)) {
  case CONFIG_TYPE_INT:
  case CONFIG_TYPE_INT64: *value = (double)config_setting_get_int64(at); return true;
  case CONFIG_TYPE_FLOAT: *value = config_setting_get_float(at); return true;
  case CONFIG_TYPE_STRING: *text = config_setting_get_string(at); return read_number(*text, value);
  default: return false;
  }
}

bool read_member_number(const struct reading *r, const config_setting_t *group, const char *name, double *value)
{
  const config_setting_t *at = config_setting_get_member(group, name);
  const char *text;
  double x;
  if (!at)
    return true;
  if (!is_number(at, &x, &text) || !isfinite(x))
    return refuse_at(r, at, "%s is a finite number", name);
  *value = x;
  return true;
}

bool read_member_count(const struct reading *r, const config_setting_t *group, const char *name, long low, long high,
                       long *value)
{
  const config_setting_t *at = config_setting_get_member(group, name);
  if (!at)
    return true;
  int type = config_setting_type(at);
  long long n = type == CONFIG_TYPE_INT || type == CONFIG_TYPE_INT64 ? config_setting_get_int64(at) : low - 1LL;
  if (n < low || n > high)
    return refuse_at(r, at, "%s is a whole number from %ld to %ld", name, low, high);
  *value = (long)n;
  return true;
}

bool read_member_texts(const struct reading *r, const config_setting_t *group, const char *name, const char **values,
                       int most, int *count)
{
  const config_setting_t *at = config_setting_get_member(group, name);
  if (!at)
    return true;
  int n = is_sequence(at) ? members(at) : 1;
  if (n < 1)
    return refuse_at(r, at, "%s is empty", name);
  if (n > most)
    return refuse_at(r, at, "%s has %d texts: %d at most", name, n, most);
  for (int i = 0; i < n; i++) {
    const config_setting_t *element = is_sequence(at) ? member_at(at, i) : at;
    values[i] = config_setting_get_string(element);
    if (!values[i] || *values[i] == '\0')
      return refuse_at(r, element, "%s takes a text in quotes, or several as [\"...\", \"...\"]", name);
  }
  *count = n;
  return true;
}

static int name_of_quantity(void *scene, const char *name)
{
  return quantity_named(&((struct scene *)scene)->quantities, name);
}

bool read_end(const struct reading *r, const config_setting_t *at, struct scene_end *end)
{
  const char *text;
  if (is_number(at, &end->number, &text))
    return isfinite(end->number) || refuse_at(r, at, "%s is a finite number", config_setting_name(at));
  if (!text)
    return refuse_at(r, at, "%s is a number, or a formula in quotes", config_setting_name(at));
  const char *wrong = arithmetic_compile(&end->formula, text, name_of_quantity, r->scene);
  if (wrong)
    return refuse_at(r, at, "%s = \"%.100s\": %s", config_setting_name(at), text, wrong);
  end->is_formula = true;
  return true;
}

/* ---- texts that the scene keeps ---- */

struct kept {
  struct kept *next;
  char text[];
};

const char *keep_text(const struct reading *r, const char *text, int length, const char *more)
{
  size_t head = (size_t)length, tail = strlen(more);
  struct kept *kept = malloc(sizeof *kept + head + tail + 1);
  if (!kept) {
    refuse_at(r, NULL, "out of memory");
    return NULL;
  }
  memcpy(kept->text, text, head);
  memcpy(kept->text + head, more, tail + 1);
  kept->next = r->scene->kept;
  r->scene->kept = kept;
  return kept->text;
}

const char *path_beside(const struct reading *r, const char *path)
{
  const char *slash = strrchr(r->path, '/');
  return *path == '/' || !slash ? path : keep_text(r, r->path, (int)(slash + 1 - r->path), path);
}

const char *gait_beside(const struct reading *r, const char *gait)
{
  static const char head[] = "measured:";
  enum { HEAD = sizeof head - 1 };
  if (strncmp(gait, head, HEAD) != 0)
    return gait;
  const char *path = path_beside(r, gait + HEAD);
  return path ? keep_text(r, head, HEAD, path) : NULL;
}

/* ---- the crawler and its start ---- */

static bool set_parameter(const struct reading *r, const config_setting_t *at, struct options *base, const char *name,
                          const char *text)
{
  const char *wrong = point_set(&base->point, name, text);
  return !wrong || refuse_at(r, at, "%s: %s", name, wrong);
}

static bool read_crawler(const struct reading *r, const config_setting_t *crawler)
{
  struct options *base = &r->scene->base;
  point_complete(&base->point);
  if (!crawler)
    return true;
  if (!config_setting_is_group(crawler))
    return refuse_at(r, crawler, "crawler is a group of parameters: { F1 = 3.0; T = 0.5; }");
  if (!keys_known(r, crawler, crawler_parameters, "a crawler"))
    return false;
  for (int i = 0; i < members(crawler); i++) {
    const config_setting_t *at = member_at(crawler, i);
    const char *name = config_setting_name(at), *text;
    int place = crawler_place(name);
    double x;
    if (place == CRAWLER_NUMBERS) { /* the gait */
      text = config_setting_get_string(at);
      if (!text)
        return refuse_at(r, at, "gait is a text in quotes, as after --gait");
      if (!base->point.has_gait && (!(text = gait_beside(r, text)) || !set_parameter(r, at, base, name, text)))
        return false;
      continue;
    }
    if (!is_number(at, &x, &text) && !text)
      return refuse_at(r, at, "%s is a number", name);
    if (base->point.written[place]) /* on the command line */
      continue;
    char written[NUMBER_TEXT];
    number_text(written, x, 0);
    if (!text && !(text = keep_text(r, written, 0, written)))
      return false;
    if (!set_parameter(r, at, base, name, text))
      return false;
  }
  point_complete(&base->point);
  return true;
}

static bool read_phase_and_start(const struct reading *r, const config_setting_t *root)
{
  struct scene *s = r->scene;
  const char *phase = NULL, *text;
  const config_setting_t *start = config_setting_get_member(root, "start");
  if (!read_member_text(r, root, "phase", &phase))
    return false;
  if (phase && strcmp(phase, "extension") != 0 && strcmp(phase, "contraction") != 0)
    return refuse_at(r, config_setting_get_member(root, "phase"), "phase is \"extension\" or \"contraction\"");
  s->phase = phase && *phase == 'c' ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION;
  if (!start)
    return true;
  if (is_number(start, &s->base.point.v0, &text)) {
    char written[NUMBER_TEXT];
    number_text(written, s->base.point.v0, 0);
    s->start = s->base.point.v0 == 0 ? START_REST : START_VELOCITY;
    s->base.point.written_v0 = text ? text : keep_text(r, written, 0, written);
    return isfinite(s->base.point.v0) || refuse_at(r, start, "start is a finite velocity");
  }
  if (!text || (strcmp(text, "rest") != 0 && strcmp(text, "steady") != 0))
    return refuse_at(r, start, "start is \"rest\", \"steady\" or a velocity");
  s->start = *text == 'r' ? START_REST : START_STEADY;
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

static const char *const root_keys[] = { "title", "notes", "crawler", "phase", "start", "vary", "want", NULL };

static bool read_root(const struct reading *r, const config_setting_t *root)
{
  struct scene *s = r->scene;
  return keys_known(r, root, root_keys, "a scene") && read_member_text(r, root, "title", &s->title)
         && read_member_texts(r, root, "notes", s->note, SCENE_NOTES, &s->notes) && are_lines(r, root)
         && read_crawler(r, config_setting_get_member(root, "crawler")) && read_phase_and_start(r, root)
         && read_vary(r, config_setting_get_member(root, "vary")) && read_wants(r, config_setting_get_member(root, "want"));
}

/* ---- the file ---- */

static char *name_of(const char *path)
{
  const char *slash = strrchr(path, '/'), *base = slash ? slash + 1 : path;
  size_t length = strlen(base);
  if (length > 4 && strcmp(base + length - 4, ".cfg") == 0)
    length -= 4;
  char *name = malloc(length + 1);
  if (name)
    snprintf(name, length + 1, "%.*s", (int)length, base);
  return name;
}

static void keep_included(void *context, const char *path)
{
  const struct reading *r = context;
  if (r->scene->included < SCENE_INCLUDED)
    r->scene->include[r->scene->included++] = keep_text(r, path, 0, path);
}

/* Whole and looked through before libconfig sees it (text.c). */
static enum exit_code parse(const struct reading *r, const struct scene_source *source, config_t *file)
{
  const char *command = r->options->command->name, *slash = strrchr(source->path, '/');
  char folder[4096] = "", *text = NULL;
  struct reading copy = *r;
  if (slash && !source->text) {
    snprintf(folder, sizeof folder, "%.*s", (int)(slash - source->path), source->path);
    config_set_include_dir(file, folder);
  }
  enum exit_code code = source->text ? EXIT_DONE : scene_text_read(command, source->path, &text);
  if (code != EXIT_DONE)
    return code;
  const char *whole = source->text ? source->text : text;
  if (!scene_text_check(command, r->path, slash ? folder : ".", whole, keep_included, &copy))
    code = EXIT_USAGE;
  if (code == EXIT_DONE && !config_read_string(file, whole)) {
    const char *at = config_error_file(file), *said = config_error_text(file);
    bool mixed = said && strstr(said, "mismatched element type") != NULL;
    complain(command, "%s:%d: %s%s", at ? at : r->path, config_error_line(file), said,
             mixed ? ": within [ ] all are written alike, [1.0, 2.5]; within ( ) they need not be" : "");
    code = EXIT_USAGE;
  }
  free(text);
  return code;
}

enum exit_code scene_read(struct scene *s, const struct scene_source *source, const struct options *options)
{
  config_t *file = malloc(sizeof *file);
  *s = (struct scene){
    .name = name_of(source->path), .path = source->text ? NULL : source->path, .base = *options, .file = file
  };
  const struct reading r = { s, options, source->path };
  if (!file || !s->name) {
    free(file);
    free(s->name);
    *s = (struct scene){ .products = 0 };
    refuse_at(&r, NULL, "out of memory");
    return EXIT_UNSOLVED;
  }
  config_init(file);
  enum exit_code code = parse(&r, source, file);
  if (code == EXIT_DONE && !read_root(&r, config_root_setting(file)))
    code = EXIT_USAGE;
  if (code != EXIT_DONE)
    scene_free(s);
  return code;
}

static void free_product(struct scene_product *product)
{
  for (int g = 0; g < product->groups; g++)
    for (int v = 0; v < product->group[g].variables; v++) {
      free(product->group[g].variable[v].numbers);
      free(product->group[g].variable[v].texts);
    }
}

void scene_free(struct scene *s)
{
  while (s->kept) {
    struct kept *first = s->kept;
    s->kept = first->next;
    free(first);
  }
  for (int p = 0; p < s->products; p++)
    free_product(&s->product[p]);
  for (int w = 0; w < s->wants; w++)
    free(s->want[w].arguments), free(s->want[w].column);
  free(s->product);
  free(s->name);
  if (s->file)
    config_destroy(s->file);
  free(s->file);
  *s = (struct scene){ .products = 0 };
}

int scene_column_quantities(const struct scene_column *column, int places[ARITHMETIC_STEPS])
{
  if (column->quantity < 0)
    return arithmetic_places(&column->formula, places);
  places[0] = column->quantity;
  return 1;
}

const char *scene_variable_sets(const struct scene_variable *v)
{
  switch (v->target) {
  case TARGET_F1_OVER_F2: return "F1";
  case TARGET_M1_OVER_M2: return "m1";
  case TARGET_FROUDE: return "T";
  default: return v->name;
  }
}

const struct scene_variable *scene_variable(const struct scene *s, int i)
{
  for (int p = 0; p < s->products; p++)
    for (int g = 0; g < s->product[p].groups; g++) {
      const struct scene_group *group = &s->product[p].group[g];
      if (i < group->variables)
        return &group->variable[i];
      i -= group->variables;
    }
  return NULL;
}

long scene_product_points(const struct scene_product *product)
{
  long points = 1;
  for (int g = 0; g < product->groups; g++)
    points *= product->group[g].count;
  return points;
}

long scene_points(const struct scene *s)
{
  long points = 0;
  for (int p = 0; p < s->products; p++)
    points += scene_product_points(&s->product[p]);
  return points;
}
