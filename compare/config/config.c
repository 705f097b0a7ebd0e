/* A configuration as a whole. */
#include "compare/config/config.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static enum exit_code parse(struct config *c, const char *text)
{
  if (!config_check_text(c, text))
    return EXIT_USAGE;
  if (config_read_string(c->file, text))
    return EXIT_DONE;
  const char *at = config_error_file(c->file), *said = config_error_text(c->file);
  bool mixed = said && strstr(said, "mismatched element type") != NULL;
  complain(c->command, "%s:%d: %s%s", at ? at : c->path, config_error_line(c->file), said,
           mixed ? ": within [ ] all are written alike, [1.0, 2.5]; within ( ) they need not be" : "");
  return EXIT_USAGE;
}

enum exit_code config_open(struct config *c, const char *command, const char *path, const char *text)
{
  const char *slash = strrchr(path, '/');
  char folder[4096], *read = NULL;
  *c = (struct config){ .command = command, .path = path, .file = malloc(sizeof *c->file) };
  if (!c->file) {
    refuse_at(c, NULL, "out of memory");
    return EXIT_UNSOLVED;
  }
  config_init(c->file);
  if (slash && !text) {
    snprintf(folder, sizeof folder, "%.*s", (int)(slash - path), path);
    config_set_include_dir(c->file, folder);
  }
  enum exit_code code = text ? EXIT_DONE : config_text(command, path, &read);
  if (code == EXIT_DONE)
    code = parse(c, text ? text : read);
  free(read);
  return code;
}

void config_close(struct config *c)
{
  while (c->kept) {
    struct kept *first = c->kept;
    c->kept = first->next;
    free(first);
  }
  if (c->file)
    config_destroy(c->file);
  free(c->file);
  *c = (struct config){ .path = NULL };
}

const config_setting_t *config_root(const struct config *c) { return config_root_setting(c->file); }
