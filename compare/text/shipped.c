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

const char *shipped_near(const struct shipped *list, const char *name) { return nearest_in(name, list, sizeof *list); }
