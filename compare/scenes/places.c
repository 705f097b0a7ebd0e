#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "compare/scenes/scene.h"

enum { MOST_FILES = 8192 };

/* The files that are read or written so far */
static struct {
  bool is_output;
  char key[320];
} files[MOST_FILES];
static int count;

/* The place of a plain file, known by its device and number or, where it is not there yet, those of its folder and its name; is_output: of
 * one that is new. -1: it is no plain file, or its folder is not there, which opening it will say. */
static int place_of(const char *path, bool is_output)
{
  const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
  char folder[4096] = ".", key[sizeof files->key];
  struct stat there;
  bool exists = stat(path, &there) == 0;
  int i = 0;
  if (slash)
    snprintf(folder, sizeof folder, "%.*s", (int)(slash + 1 - path), path);
  if (exists ? !S_ISREG(there.st_mode) : stat(folder, &there) != 0)
    return -1;
  snprintf(key, sizeof key, "%ju %ju %s", (uintmax_t)there.st_dev, (uintmax_t)there.st_ino, exists ? "" : name);
  while (i < count && strcmp(files[i].key, key) != 0)
    i++;
  if (i == count && count < MOST_FILES) {
    files[count].is_output = is_output;
    memcpy(files[count++].key, key, sizeof key);
  }
  return i;
}

static void reads_gait(const char *gait)
{
  if (strncmp(gait, "measured:", 9) == 0)
    place_of(gait + 9, false);
}

static void reads(const struct scene *s)
{
  const struct sweep_variable *v;
  const char *path = strcmp(s->name, "-") == 0 ? "/dev/stdin" : s->path;
  if (path)
    place_of(path, false);
  for (int i = 0; i < s->config.included; i++)
    place_of(s->config.include[i], false);
  reads_gait(s->base.crawler.gait->name);
  for (int i = 0; (v = sweep_variable(&s->sweep, i)); i++)
    for (long k = 0; v->target == TARGET_GAIT && k < v->count; k++)
      reads_gait(v->texts[k]);
  for (int w = 0; w < s->wants; w++)
    if (s->want[w].plot.script)
      place_of(s->want[w].plot.script, false);
}

/* Devices and pipes take any number of tables. */
static bool writes(const char *command, const char *path)
{
  int before = count, i = place_of(path, true);
  if (i < 0 || count > before)
    return true;
  complain(command,
           files[i].is_output ? "two things would go to %s: give each table and each plot a file of its own"
                              : "%s is read by a scene, and would be written by one",
           path);
  return false;
}

bool scenes_check_files(const struct scene *scenes, int scene_count, const struct scene_options *o)
{
  const char *command = o->request.style.command;
  int printed = 0;
  for (int i = 0; i < scene_count; i++)
    reads(&scenes[i]);
  if (o->explain)
    return !o->request.style.has_output || !o->request.style.output || writes(command, o->request.style.output);
  for (int i = 0; i < scene_count; i++)
    for (int k = 0; k < scenes[i].wants; k++) {
      const struct scene_want *w = &scenes[i].want[k];
      printed += !w->file;
      if (printed > 1)
        complain(command, "two tables would go to standard output: give each want a file of its own");
      if (printed > 1 || (w->file && !writes(command, w->file)) || (w->has_plot && !writes(command, w->plot.file)))
        return false;
    }
  return true;
}
