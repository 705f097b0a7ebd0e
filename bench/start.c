#include "bench/start.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <spawn.h>
#include <stddef.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST_PROGRAMS = 4 };

extern char **environ;

/* Seconds; nan, with errno, if it fails */
static double run_once(char *const *arguments, const posix_spawn_file_actions_t *quiet)
{
  double begin = stopwatch_now();
  pid_t process;
  int code = posix_spawn(&process, arguments[0], quiet, NULL, arguments, environ);
  if (code != 0) {
    errno = code;
    return NAN;
  }
  if (waitpid(process, &code, 0) != process)
    return NAN;
  if (code != 0) {
    errno = ECHILD;
    return NAN;
  }
  return stopwatch_now() - begin;
}

bool start_measure(char *const *const *arguments, int count, struct stopwatch_spread *spread)
{
  static double seconds[MOST_PROGRAMS][START_RUNS];
  posix_spawn_file_actions_t quiet;
  if (count > MOST_PROGRAMS || posix_spawn_file_actions_init(&quiet) != 0)
    return false;
  bool ran = posix_spawn_file_actions_addopen(&quiet, STDOUT_FILENO, "/dev/null", O_WRONLY, 0) == 0;
  for (int i = 0; ran && i < START_RUNS; i++)
    for (int k = 0; ran && k < count; k++) {
      seconds[k][i] = run_once(arguments[k], &quiet);
      ran = seconds[k][i] > 0;
    }
  posix_spawn_file_actions_destroy(&quiet);
  for (int k = 0; ran && k < count; k++)
    spread[k] = stopwatch_spread(seconds[k], START_RUNS);
  return ran;
}
