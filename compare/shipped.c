#include "compare/shipped.h"

#include <stddef.h>
#include <string.h>

#include "compare/words.h"

const char *shipped_scene(const char *name)
{
  const struct shipped *s = shipped_scenes;
  while (s->name && strcmp(s->name, name) != 0)
    s++;
  return s->text;
}

const char *shipped_near(const char *name)
{
  enum { MOST = 64 };
  const char *names[MOST + 1] = { NULL };
  for (int i = 0; i < MOST && shipped_scenes[i].name; i++)
    names[i] = shipped_scenes[i].name;
  return nearest(name, names);
}
