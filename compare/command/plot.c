#include "compare/command/plot.h"

#include <errno.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "compare/text/aside.h"
#include "compare/command/compare.h"
#include "compare/command/plot_data.h"
#include "compare/command/plot_script.h"

extern char **environ;

/* The descriptor of the picture in gnuplot's process, and its name there: the file may have no other (compare/text/aside.h). */
enum { PICTURE = 3 };
static const char picture_name[] = "/dev/fd/3";

static bool fail(const struct plot *p, const char *command, const char *what)
{
  complain(command, "cannot draw %s: %s", p->file, what);
  return false;
}

static bool fail_for(const struct plot *p, const char *command, const char *what, int error)
{
  complain(command, "cannot draw %s: %s: %s", p->file, what, strerror(error));
  return false;
}

const char *plot_kind(const char *file)
{
  static const char *const kinds[] = { "svg", "png", "pdf" };
  const char *point = strrchr(file, '.');
  for (int i = 0; point && i < 3; i++)
    if (strcmp(point + 1, kinds[i]) == 0)
      return kinds[i];
  return NULL;
}

/* ---- the script ---- */

/* plot_common.gp beside a script: a path to be freed, or NULL where there is none. */
static char *common_beside(const char *script)
{
  static const char name[] = "plot_common.gp";
  const char *slash = strrchr(script, '/');
  size_t folder = slash ? (size_t)(slash + 1 - script) : 0;
  char *path = malloc(folder + sizeof name);
  if (path) {
    memcpy(path, script, folder);
    memcpy(path + folder, name, sizeof name);
  }
  if (path && access(path, F_OK) == 0)
    return path;
  free(path);
  return NULL;
}

static bool write_own_script(FILE *to, const struct plot *p, const char *command)
{
  const char *const inputs[] = { p->table, p->script };
  for (int i = 0; i < 2; i++)
    if (inputs[i] && access(inputs[i], R_OK) != 0)
      return fail_for(p, command, inputs[i], errno);
  char *common = p->script ? common_beside(p->script) : NULL;
  plot_script_load(to, p, common, picture_name);
  free(common);
  return true;
}

static bool write_script(FILE *to, const struct plot *p, const char *command)
{
  struct plot_data data;
  if (p->script || p->program)
    return write_own_script(to, p, command);
  if (!plot_data_read(&data, p, command))
    return false;
  plot_script_write(to, p, &data, picture_name);
  plot_data_free(&data);
  return true;
}

/* ---- the process ---- */

/* Starts gnuplot with these for input, output and the picture. Returns an error, or 0. They were opened in this order: each
 * is moved before another takes its place. */
static int start(pid_t *process, FILE *script, FILE *said, FILE *picture)
{
  static char name[] = "gnuplot", plain[] = "-d"; /* without the settings of the user */
  char *const arguments[] = { name, plain, NULL };
  const int from[] = { fileno(script), fileno(said), fileno(said), fileno(picture) };
  posix_spawn_file_actions_t places;
  int error = posix_spawn_file_actions_init(&places);
  if (error != 0)
    return error;
  for (int to = 0; error == 0 && to <= PICTURE; to++)
    error = posix_spawn_file_actions_adddup2(&places, from[to], to);
  if (error == 0)
    error = posix_spawnp(process, name, &places, NULL, arguments, environ);
  posix_spawn_file_actions_destroy(&places);
  return error;
}

static bool ended_well(pid_t process)
{
  int status;
  while (waitpid(process, &status, 0) < 0)
    if (errno != EINTR)
      return false;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/* ---- what gnuplot says ---- */

static bool is_blank(const char *line) { return line[strspn(line, " \t\r\n^")] == '\0'; }

/* Line by line, without the blank ones and the ones that point at a place in another */
static void pass_on(FILE *said, const char *command)
{
  enum { MOST_LINES = 20 };
  char line[400];
  rewind(said);
  for (int count = 0; count < MOST_LINES && fgets(line, sizeof line, said);) {
    line[strcspn(line, "\r\n")] = '\0';
    if (is_blank(line))
      continue;
    for (char *c = line; *c; c++)
      if ((unsigned char)*c < 0x20 || *c == 0x7f)
        *c = '?';
    complain(command, "gnuplot: %s", line + strspn(line, " "));
    count++;
  }
}

/* ---- the picture ---- */

static bool is_drawn(FILE *picture)
{
  struct stat there;
  return fstat(fileno(picture), &there) == 0 && there.st_size > 0;
}

static bool run(const struct plot *p, const char *command, FILE *script, FILE *said, FILE *picture)
{
  pid_t process;
  int error = start(&process, script, said, picture);
  if (error == ENOENT)
    return fail(p, command, "gnuplot is not installed (Debian: gnuplot-nox); the tables are written");
  if (error != 0)
    return fail_for(p, command, "cannot run gnuplot", error);
  bool well = ended_well(process);
  if (!well || p->script || p->program)
    pass_on(said, command);
  if (!well)
    return fail(p, command, "gnuplot has failed");
  return is_drawn(picture) || fail(p, command, "gnuplot has drawn nothing");
}

/* Through files that have no name: a pipe could wait for a reader that waits itself. */
static bool draw_by(const struct plot *p, const char *command, FILE *script, FILE *said)
{
  struct aside picture;
  if (!write_script(script, p, command))
    return false;
  if (fflush(script) != 0 || ferror(script) || fseek(script, 0, SEEK_SET) != 0)
    return fail_for(p, command, "cannot write a temporary file", errno);
  if (!aside_open(&picture, p->file))
    return fail_for(p, command, "cannot write it", errno);
  if (!run(p, command, script, said, picture.file)) {
    aside_drop(&picture);
    return false;
  }
  return aside_keep(&picture) || fail_for(p, command, "cannot write it", errno);
}

bool plot_draw(const struct plot *p, const char *command)
{
  struct stat there;
  if (!plot_kind(p->file))
    return fail(p, command, "its name is to end in .svg, .png or .pdf");
  if (stat(p->file, &there) == 0 && !S_ISREG(there.st_mode))
    return fail(p, command, "there is something of this name that is no file");
  FILE *script = tmpfile(), *said = tmpfile();
  bool drawn = script && said ? draw_by(p, command, script, said) : fail_for(p, command, "no temporary file", errno);
  if (script)
    fclose(script);
  if (said)
    fclose(said);
  return drawn;
}
