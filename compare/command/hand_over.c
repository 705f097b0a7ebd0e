/* In place of the parts that need FLINT: hands the command over to the program that has them. */
#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/auxv.h>
#endif

#include "compare/answers/answer.h"
#include "compare/scenes/flint.h"
#include "compare/breakdown/breakdown.h"
#include "compare/command/with_flint.h"
#include "compare/maps/maps.h"

/* The path of this program, through any link; false if it is not known. */
static bool own_path(char path[PATH_MAX])
{
  ssize_t length = readlink("/proc/self/exe", path, PATH_MAX - 1);
  if (length >= 0) {
    path[length] = '\0';
    return true;
  }
#ifdef __linux__
  /* without /proc */
  const char *started_as = (const char *)getauxval(AT_EXECFN); /* NOLINT(performance-no-int-to-ptr) */
  return started_as && realpath(started_as, path);
#else
  return false;
#endif
}

/* The program called name in the folder of this one; false if its path is not known. */
static bool beside(char path[PATH_MAX], const char *name)
{
  if (!own_path(path))
    return false;
  char *base = strrchr(path, '/');
  size_t room = base ? (size_t)(PATH_MAX - (base + 1 - path)) : 0;
  if (room <= strlen(name))
    return false;
  memcpy(base + 1, name, strlen(name) + 1);
  return true;
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

bool has_flint(const struct options *options, const char *what)
{
  char path[PATH_MAX];
  const char *command = options->command->name;
  if (!beside(path, "scallop-flint")) {
    complain(command, "%s needs FLINT, and the folder of scallop-flint, which has it, cannot be told", what);
    return false;
  }
  if (is_handed_over()) {
    complain(command, "%s needs FLINT: %s is there, but it is a scallop without FLINT", what, path);
    return false;
  }
  execv(path, options->arguments);
  if (errno == ENOENT)
    complain(command, "%s needs FLINT: there is no %s, which `make` builds and `make WITH_FLINT=0` leaves out", what, path);
  else
    complain(command, "%s needs FLINT: cannot run %s: %s", what, path, strerror(errno));
  return false;
}

/* Not reached: has_flint has said no. */
bool answer_in_decimals(struct answer *answer, char *texts[QUANTITIES], const struct point *point, enum quantity_of of,
                        long digits, const char **why)
{
  (void)answer, (void)texts, (void)point, (void)of, (void)digits, (void)why;
  return false;
}

void decimals_free(char *texts[QUANTITIES]) { (void)texts; }

enum exit_code series_derived(const struct options *options)
{
  (void)options;
  return EXIT_UNSOLVED;
}

enum exit_code claims_table(const struct options *options)
{
  (void)options;
  return EXIT_UNSOLVED;
}

enum exit_code workprec_table(const struct options *options)
{
  (void)options;
  return EXIT_UNSOLVED;
}

enum exit_code stress_table(const struct options *options)
{
  (void)options;
  return EXIT_UNSOLVED;
}

enum exit_code stress_point(const struct options *options)
{
  (void)options;
  return EXIT_UNSOLVED;
}

enum exit_code stress_stiff(const struct options *options)
{
  (void)options;
  return EXIT_UNSOLVED;
}

enum exit_code breakdown_table(const struct options *options)
{
  (void)options;
  return EXIT_UNSOLVED;
}

enum exit_code breakdown_map(const struct options *options)
{
  (void)options;
  return EXIT_UNSOLVED;
}

enum exit_code breakdown_boundaries(const struct options *options)
{
  (void)options;
  return EXIT_UNSOLVED;
}

/* Of scenes: the plan has handed over those that need these. */
void scene_flint_free(struct scene_flint *flint) { (void)flint; }

void scene_flint_forget(struct scene_flint *flint) { (void)flint; }

double scene_flint_sum(struct scene_state *state, const struct quantity *series)
{
  (void)state, (void)series;
  return NAN;
}

double scene_flint_error(struct scene_state *state, const struct quantity *series, double *value, double *exact)
{
  (void)state, (void)series;
  *value = *exact = NAN;
  return NAN;
}

const char *scene_flint_certified(struct scene_state *state, const struct quantity *q, long digits)
{
  (void)state, (void)q, (void)digits;
  return "nan";
}
