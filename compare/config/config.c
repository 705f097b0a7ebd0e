/* A configuration as a whole. */
#include "compare/config/config.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What to look for where libconfig says no more than that */
static const char *meaning(const char *said)
{
  static const struct {
    const char *said, *meaning;
  } known[] = {
    { "mismatched element type", ": within [ ] all are written alike, [1.0, 2.5]; within ( ) they need not be" },
    { "syntax error", ": in this line or before it a ; , \" ) ] or } is missing or one too many, or a text has no "
                      "quotes, or [ ] stands around groups, which ( ) takes" },
    { "duplicate setting name", ": a group has each of its members once" }
  };
  for (size_t i = 0; said && i < sizeof known / sizeof *known; i++)
    if (strstr(said, known[i].said))
      return known[i].meaning;
  return "";
}

static enum exit_code parse(struct config *c, const char *text)
{
  if (!config_check_text(c, text))
    return EXIT_USAGE;
  if (config_read_string(c->file, text))
    return EXIT_DONE;
  const char *at = config_error_file(c->file), *said = config_error_text(c->file);
  complain(c->command, "%s:%d: %s%s", at ? at : c->path, config_error_line(c->file), said, meaning(said));
  return EXIT_USAGE;
}

enum exit_code config_open(struct config *c, const char *command, const char *path, const char *text,
                           const struct shipped *shipped)
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
  enum exit_code code = text ? EXIT_DONE : config_text(command, path, shipped, &read);
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
