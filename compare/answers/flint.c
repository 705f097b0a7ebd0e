#include "compare/answers/flint.h"

#include <dlfcn.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/auxv.h>
#include <unistd.h>

#include "model/version.h"

const struct flint_part *load_flint(const char *command, const char *what)
{
  static const struct flint_part *part; /* stays loaded */
  char folder[PATH_MAX], path[PATH_MAX + 40] = "";
  /* the path of the program, with links resolved; /proc may be missing */
  const char *own = (const char *)getauxval(AT_EXECFN); /* NOLINT(performance-no-int-to-ptr) */
  if (!own || !realpath(own, folder))
    strcpy(folder, "/");
  strrchr(folder, '/')[1] = '\0';
  if (!part) /* the program may be linked with the part */
    part = dlsym(dlopen(NULL, RTLD_LAZY), "flint_part");
  for (int installed = 0; !part && installed < 2 && access(path, F_OK) != 0; installed++) {
    snprintf(path, sizeof path, "%s%sscallop-flint.so", folder, installed ? "../lib/scallop/" : "");
    void *file = dlopen(path, RTLD_LAZY);
    part = file ? dlsym(file, "flint_part") : NULL;
  }
  if (part && strcmp(part->version, SCALLOP_VERSION) == 0)
    return part;
  if (part)
    complain(command, "%s needs FLINT, and %s belongs to scallop %s", what, path, part->version);
  else if (access(path, F_OK) == 0)
    complain(command, "%s needs FLINT: %s", what, dlerror());
  else
    complain(command,
             "%s needs FLINT, and there is no scallop-flint.so in %s or ../lib/scallop: `make` builds it, "
             "`make WITH_FLINT=0` does not",
             what, folder);
  return NULL;
}
