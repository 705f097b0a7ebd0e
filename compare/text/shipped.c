#include "compare/text/shipped.h"

#include <stddef.h>
#include <string.h>

#include "compare/text/message.h"

const char *shipped_text(const struct shipped *list, const char *name)
{
  while (list->name && strcmp(list->name, name) != 0)
    list++;
  return list->text;
}

const char *shipped_near(const struct shipped *list, const char *name)
{
  enum { MOST = 64 };
  const char *names[MOST + 1] = { NULL };
  for (int i = 0; i < MOST && list[i].name; i++)
    names[i] = list[i].name;
  return nearest(name, names);
}
