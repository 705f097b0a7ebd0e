#include "compare/scenes/places.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "compare/command/compare.h"

/* False: it is no plain file, or its folder is not there, which opening it will say. */
static bool place_of(const char *path, struct scene_place *place)
{
  struct stat there;
  *place = (struct scene_place){ .is_output = false };
  if (stat(path, &there) == 0) {
    place->device = there.st_dev;
    place->number = there.st_ino;
    return S_ISREG(there.st_mode);
  }
  const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
  char folder[4096] = ".";
  if (slash)
    snprintf(folder, sizeof folder, "%.*s", (int)(slash + 1 - path), path);
  if (strlen(name) >= PLACE_NAME || stat(folder, &there) != 0)
    return false;
  place->device = there.st_dev;
  place->number = there.st_ino;
  snprintf(place->name, sizeof place->name, "%s", name);
  return true;
}

static const struct scene_place *find(const struct scene_places *all, const struct scene_place *place)
{
  for (int i = 0; i < all->count; i++) {
    const struct scene_place *p = &all->place[i];
    if (p->device == place->device && p->number == place->number && strcmp(p->name, place->name) == 0)
      return p;
  }
  return NULL;
}

static void add(struct scene_places *all, const struct scene_place *place, bool is_output)
{
  if (all->count == SCENE_PLACES)
    return;
  all->place[all->count] = *place;
  all->place[all->count++].is_output = is_output;
}

static void reads(struct scene_places *all, const char *path)
{
  struct scene_place place;
  if (place_of(path, &place))
    add(all, &place, false);
}

static void reads_gait(struct scene_places *all, const char *gait)
{
  if (gait && strncmp(gait, "measured:", 9) == 0)
    reads(all, gait + 9);
}

void places_reads(struct scene_places *all, const struct scene *scene)
{
  const struct scene_variable *v;
  if (scene->path)
    reads(all, scene->path);
  if (strcmp(scene->name, "-") == 0)
    reads(all, "/dev/stdin");
  for (int i = 0; i < scene->included; i++)
    if (scene->include[i])
      reads(all, scene->include[i]);
  reads_gait(all, scene->base.crawler.gait->name);
  for (int i = 0; (v = scene_variable(scene, i)); i++)
    for (long k = 0; v->target == TARGET_GAIT && k < v->count; k++)
      reads_gait(all, v->texts[k]);
  for (int w = 0; w < scene->wants; w++)
    if (scene->want[w].plot.script)
      reads(all, scene->want[w].plot.script);
}

bool places_writes(struct scene_places *all, const char *command, const char *path)
{
  struct scene_place place;
  const struct scene_place *before = NULL;
  if (!path) {
    if (all->has_standard_output)
      complain(command, "two tables would go to standard output: give each want a file of its own");
    bool first = !all->has_standard_output;
    all->has_standard_output = true;
    return first;
  }
  if (!place_of(path, &place))
    return true;
  before = find(all, &place);
  if (before && before->is_output)
    complain(command, "two things would go to %s: give each table and each plot a file of its own", path);
  else if (before)
    complain(command, "%s is read by a scene, and would be written by one", path);
  else
    add(all, &place, true);
  return !before;
}
