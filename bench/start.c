#include "bench/start.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "compare/text/stopwatch.h"

enum { NOTHING, STEADY, PROGRAMS };
static const struct {
  const char *file, *argument, *name;
} programs[PROGRAMS] = { { "nothing", NULL, "nothing" }, { "scallop", "steady", "scallop steady" } };

extern char **environ;

/* Seconds, with standard output going nowhere */
static double run_once(char *const *arguments)
{
  posix_spawn_file_actions_t quiet;
  pid_t process;
  int ended = 0, code = posix_spawn_file_actions_init(&quiet);
  if (code == 0)
    code = posix_spawn_file_actions_addopen(&quiet, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  double begin = stopwatch_now();
  if (code == 0)
    code = posix_spawn(&process, arguments[0], &quiet, NULL, arguments, environ);
  if (code == 0 && (waitpid(process, &ended, 0) != process || ended != 0))
    code = ECHILD;
  double seconds = stopwatch_now() - begin;
  posix_spawn_file_actions_destroy(&quiet);
  if (code == 0)
    return seconds;
  fprintf(stderr, "bench: cannot run %s: %s\n", arguments[0], strerror(code));
  exit(3);
}

void bench_start(const char *own_path)
{
  static double seconds[PROGRAMS][START_RUNS];
  const char *base = strrchr(own_path, '/');
  struct stopwatch_spread s[PROGRAMS];
  for (int i = 0; i < START_RUNS; i++)
    for (int k = 0; k < PROGRAMS; k++) {
      char path[PATH_MAX], argument[] = "steady";
      snprintf(path, sizeof path, "%.*s%s", base ? (int)(base + 1 - own_path) : 0, own_path, programs[k].file);
      seconds[k][i] = run_once((char *const[]){ path, programs[k].argument ? argument : NULL, NULL });
    }
  for (int k = 0; k < PROGRAMS; k++) {
    s[k] = stopwatch_spread(seconds[k], START_RUNS);
    printf("start\t-\t-\t%s\t%.4g\t%.4g\t%.4g\tnan\t%.3g\tnan\n", programs[k].name, 1e9 * s[k].median, 1e9 * s[k].q1,
           1e9 * s[k].q3, s[k].median / s[NOTHING].median);
  }
  printf("# scallop steady, from its start to its end: %.2f ms, %.2f times a program that does nothing\n",
         1e3 * s[STEADY].median, s[STEADY].median / s[NOTHING].median);
}
