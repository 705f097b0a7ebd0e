#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/auxv.h>
#include <unistd.h>

#include "compare/command/options.h"
#include "compare/command/with_flint.h"

/* At its end the memory that FLINT keeps for reuse is given back. A leak checker then sees what was forgotten, the limbs of big
 * integers too, which FLINT holds behind pointers that no checker can read. */
void flint_cleanup(void);
static void end_of_program(void) __attribute__((destructor));

static void end_of_program(void)
{
  if (flint_cleanup)
    flint_cleanup();
}

/* Has this process been handed over already? Its number stays when another program takes it over. Children have another. */
static bool is_handed_over(void)
{
  static const char name[] = "SCALLOP_HANDED_OVER";
  char number[24];
  snprintf(number, sizeof number, "%ld", (long)getpid());
  const char *earlier = getenv(name);
  return (earlier && strcmp(earlier, number) == 0) || setenv(name, number, 1) != 0;
}

bool has_flint(const struct arguments *arguments, const char *what)
{
  static const char other[] = "scallop-flint";
  char path[PATH_MAX + sizeof other];
  const char *command = arguments->command->name;
  if (flint_cleanup)
    return true;
  /* through any link, and without /proc, which need not be there */
  const char *own = (const char *)getauxval(AT_EXECFN); /* NOLINT(performance-no-int-to-ptr) */
  if (!own || !realpath(own, path)) {
    complain(command, "%s needs FLINT, and the folder of %s, which has it, cannot be told", what, other);
    return false;
  }
  memcpy(strrchr(path, '/') + 1, other, sizeof other);
  if (is_handed_over()) {
    complain(command, "%s needs FLINT: %s is there, but it is a scallop without FLINT", what, path);
    return false;
  }
  execv(path, arguments->all);
  if (errno == ENOENT)
    complain(command, "%s needs FLINT: there is no %s, which `make` builds and `make WITH_FLINT=0` leaves out", what, path);
  else
    complain(command, "%s needs FLINT: cannot run %s: %s", what, path, strerror(errno));
  return false;
}
