#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "compare/scenes/scene.h"

/* The key of a plain file: its device and number or, where it is not there yet, those of its folder and its name. False: it is no plain
 * file, or its folder is not there, which opening it will say. */
static bool key_of(const char *path, char key[PLACE_KEY])
{
  const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
  char folder[4096] = ".";
  struct stat there;
  bool exists = stat(path, &there) == 0;
  if (slash)
    snprintf(folder, sizeof folder, "%.*s", (int)(slash + 1 - path), path);
  if (exists ? !S_ISREG(there.st_mode) : stat(folder, &there) != 0)
    return false;
  int length = snprintf(key, PLACE_KEY, "%ju %ju %s", (uintmax_t)there.st_dev, (uintmax_t)there.st_ino, exists ? "" : name);
  return length < PLACE_KEY;
}

static void add(struct scene_places *all, const char *key, bool is_output)
{
  if (all->count == SCENE_PLACES)
    return;
  struct scene_place *place = &all->place[all->count++];
  place->is_output = is_output;
  snprintf(place->key, sizeof place->key, "%s", key);
}

static void reads(struct scene_places *all, const char *path)
{
  char key[PLACE_KEY];
  if (path && key_of(path, key))
    add(all, key, false);
}

static void reads_gait(struct scene_places *all, const char *gait)
{
  if (strncmp(gait, "measured:", 9) == 0)
    reads(all, gait + 9);
}

void places_reads(struct scene_places *all, const struct scene *scene)
{
  const struct sweep_variable *v;
  reads(all, strcmp(scene->name, "-") == 0 ? "/dev/stdin" : scene->path);
  for (int i = 0; i < scene->included; i++)
    reads(all, scene->include[i]);
  reads_gait(all, scene->base.crawler.gait->name);
  for (int i = 0; (v = sweep_variable(&scene->sweep, i)); i++)
    for (long k = 0; v->target == TARGET_GAIT && k < v->count; k++)
      reads_gait(all, v->texts[k]);
  for (int w = 0; w < scene->wants; w++)
    reads(all, scene->want[w].plot.script);
}

bool places_writes(struct scene_places *all, const char *command, const char *path)
{
  char key[PLACE_KEY] = "standard output";
  int i = 0;
  if (path && !key_of(path, key))
    return true;
  while (i < all->count && strcmp(all->place[i].key, key) != 0)
    i++;
  bool is_new = i == all->count;
  if (is_new)
    add(all, key, true);
  else if (!path)
    complain(command, "two tables would go to standard output: give each want a file of its own");
  else if (all->place[i].is_output)
    complain(command, "two things would go to %s: give each table and each plot a file of its own", path);
  else
    complain(command, "%s is read by a scene, and would be written by one", path);
  return is_new;
}
