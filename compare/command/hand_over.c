#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/auxv.h>
#include <sys/stat.h>
#include <unistd.h>

#include "compare/command/options.h"
#include "compare/command/with_flint.h"
#include "compare/text/progress.h"

/* At its end the memory that FLINT keeps for reuse is given back. A leak checker then sees what was forgotten, the
 * limbs of big integers too, which FLINT holds behind pointers that no checker can read. */
void flint_cleanup(void);
#pragma weak flint_cleanup
static void end_of_program(void) __attribute__((destructor));

static void end_of_program(void)
{
  if (flint_cleanup)
    flint_cleanup();
}

bool has_flint(const struct arguments *arguments, const char *what)
{
  static const char other[] = "scallop-flint", marker[] = "SCALLOP_HANDED_OVER";
  char path[PATH_MAX + sizeof other], number[24];
  const char *command = arguments->command->name;
  if (flint_cleanup)
    return true;
  /* through any link, and without /proc, which need not be there */
  const char *own = (const char *)getauxval(AT_EXECFN); /* NOLINT(performance-no-int-to-ptr) */
  const char *earlier = getenv(marker);
  bool is_known = own && realpath(own, path);
  int error = 0;
  /* The number of this process stays when another program takes it over. Children have another. */
  snprintf(number, sizeof number, "%ld", (long)getpid());
  if (is_known)
    memcpy(strrchr(path, '/') + 1, other, sizeof other);
  if (is_known && !(earlier && strcmp(earlier, number) == 0) && setenv(marker, number, 1) == 0) {
    progress_stop();
    execv(path, arguments->all);
    error = errno;
    unsetenv(marker);
  }
  if (!what)
    return false;
  if (!is_known)
    complain(command, "%s needs FLINT, and the folder of %s, which has it, cannot be told", what, other);
  else if (error == 0)
    complain(command, "%s needs FLINT: %s is there, but it is a scallop without FLINT", what, path);
  else if (error == ENOENT)
    complain(command, "%s needs FLINT: there is no %s, which `make` builds and `make WITH_FLINT=0` leaves out", what,
             path);
  else
    complain(command, "%s needs FLINT: cannot run %s: %s", what, path, strerror(error));
  return false;
}

void hand_over_before(const struct arguments *arguments, const char *path)
{
  struct stat there;
  if (strcmp(path, "-") == 0 || (stat(path, &there) == 0 && !S_ISREG(there.st_mode)))
    has_flint(arguments, NULL);
}
