#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "compare/scenes/scene.h"
#include "compare/text/file.h"

enum { MOST_FILES = 8192 };

static char files[MOST_FILES][320]; /* that are written so far */
static int count;

/* The place of a plain file, known by its device and number or, where it is not there yet, those of its folder and its
 * name. -1: it is no plain file, or its folder is not there, which opening it will say. */
static int place_of(const char *path)
{
  const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
  char folder[4096] = ".", key[sizeof files[0]];
  struct stat there;
  bool exists = stat(path, &there) == 0;
  int i = 0;
  if (slash)
    snprintf(folder, sizeof folder, "%.*s", (int)(slash + 1 - path), path);
  if (exists ? !S_ISREG(there.st_mode) : stat(folder, &there) != 0)
    return -1;
  snprintf(key, sizeof key, "%ju %ju %s", (uintmax_t)there.st_dev, (uintmax_t)there.st_ino, exists ? "" : name);
  while (i < count && strcmp(files[i], key) != 0)
    i++;
  if (i == count && count < MOST_FILES)
    memcpy(files[count++], key, sizeof key);
  return i;
}

/* Devices and pipes take any number of tables. */
static enum exit_code writes(const char *command, const char *path)
{
  int before = count, error = file_spares(path);
  if (error != 0)
    complain(command, "cannot write %s: %s", path, file_error(error));
  else if (place_of(path) >= 0 && count == before) {
    complain(command, "two things would go to %s: give each table and each plot a file of its own", path);
    return EXIT_USAGE;
  }
  return error != 0 ? EXIT_FILE : EXIT_DONE;
}

enum exit_code scenes_check_files(const struct scene *scenes, int scene_count, const struct scene_options *o)
{
  const char *command = o->request.style.command;
  int printed = 0;
  enum exit_code code = EXIT_DONE;
  for (int i = 0; i < scene_count; i++)
    for (int k = 0; k < scenes[i].wants && code == EXIT_DONE; k++) {
      const struct scene_want *w = &scenes[i].want[k];
      if (!w->file && printed++ > 0) {
        complain(command, "two tables would go to standard output: give each want a file of its own");
        return EXIT_USAGE;
      }
      code = w->file ? writes(command, w->file) : EXIT_DONE;
      if (code == EXIT_DONE && w->has_plot)
        code = writes(command, w->plot.file);
    }
  return code;
}
