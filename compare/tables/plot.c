#include "compare/tables/plot.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/file.h"
#include "compare/text/message.h"
#include "compare/text/progress.h"
#include "compare/text/shipped.h"
#include "compare/text/values.h"

bool plot_kind(const char *file)
{
  const char *end = strrchr(file, '.');
  return end && (strcmp(end, ".svg") == 0 || strcmp(end, ".png") == 0 || strcmp(end, ".pdf") == 0);
}

static bool is_list(const char *text)
{
  char item[2];
  int count = 0;
  bool fine = is_shown(text);
  for (; fine && next_item(item, sizeof item, &text); count++)
    fine = *item != '\0';
  return fine && count <= 8;
}

static bool is_range(const char *text)
{
  char *end;
  double low = strtod(text, &end), high = *end == ':' ? strtod(end + 1, &end) : NAN;
  bool is_linear = *end == '\0' || strcmp(end, ":linear") == 0, is_log = strcmp(end, ":log") == 0 && low > 0;
  return (is_linear || is_log) && low < high && high - low < INFINITY && !strpbrk(text, "xX"); /* decimals, for awk */
}

static bool is_size(const char *text)
{
  int width, height, end = 0;
  return sscanf(text, "%5dx%5d%n", &width, &height, &end) == 2 && text[end] == '\0' && width >= 200 && height >= 200
         && width <= 10000 && height <= 10000;
}

#define LINE is_shown, "a line of UTF-8 without control characters"
#define LIST is_list, "one to eight columns, with commas between"
#define RANGE is_range, "FROM:TO, FROM:TO:log or FROM:TO:linear, with FROM < TO, of log > 0"
#define TEXT(member) #member, offsetof(struct plot, member)
/* The environment variables PLOT_NAME of the script, and the values that options take */
static const struct text {
  const char *option, *name;
  size_t at;
  bool (*takes)(const char *text);
  const char *allowed;
} texts[] = {
  { "plot", TEXT(file), plot_kind, "a file name that ends in .svg, .png or .pdf" },
  { "plot-x", TEXT(x), LINE },
  { "plot-y", TEXT(y), LIST },
  { "plot-by", TEXT(by), LIST },
  { "plot-x-range", TEXT(x_range), RANGE },
  { "plot-y-range", TEXT(y_range), RANGE },
  { "plot-title", TEXT(title), LINE },
  { "plot-size", TEXT(size), is_size, "WIDTHxHEIGHT in pixels, each from 200 to 10000: 800x500" },
  { NULL, TEXT(table), NULL, NULL },
  { NULL, TEXT(of), NULL, NULL },
  { NULL, TEXT(picture), NULL, NULL },
  { NULL, TEXT(script), NULL, NULL },
};
enum { TEXTS = sizeof texts / sizeof *texts };

const char *plot_set(struct plot *p, const char *option, const char *text)
{
  const struct text *t = texts;
  while (strcmp(t->option, option) != 0)
    t++;
  memcpy((char *)p + t->at, &text, sizeof text);
  return *text && t->takes(text) ? NULL : not_allowed(text, t->allowed);
}

static bool set(const char *name, const char *value)
{
  char variable[40];
  snprintf(variable, sizeof variable, "PLOT_%.30s", name);
  return setenv(variable, value ? value : "", 1) == 0;
}

/* Sets PLOT_units: a line "name<tab>unit" for each known column of the table. Returns false on failure. */
static bool set_units(const struct plot *p)
{
  char *line = NULL, *units = NULL, *rest = NULL;
  size_t room = 0, size;
  FILE *table = fopen(p->table, "r"), *lines = open_memstream(&units, &size);
  while (table && getline(&line, &room, table) > 0 && *line == '#')
    ;
  for (char *name = line ? strtok_r(line, "\t\n", &rest) : NULL; name && lines; name = strtok_r(NULL, "\t\n", &rest)) {
    const struct column_meaning *meaning = p->meaning ? p->meaning(name) : NULL;
    if (meaning)
      fprintf(lines, "%s\t%s\n", name, meaning->unit);
  }
  bool given = lines && fclose(lines) == 0 && set("units", units);
  if (table)
    fclose(table);
  free(line);
  free(units);
  return given;
}

static bool set_all(const struct plot *p, const char *command, const char *output)
{
  bool given = set("command", command) && set("output", output) && set("log_x", p->log_x ? "1" : NULL)
               && set("log_y", p->log_y ? "1" : NULL) && set_units(p);
  for (const struct text *t = texts; t < texts + TEXTS; t++)
    given = given && set(t->name, *(const char *const *)(const void *)((const char *)p + t->at));
  for (const struct shipped *part = shipped_scripts; part->name; part++)
    given = given && set(part->name, part->text);
  return given;
}

static bool is_refused;
bool plot_refused(void) { return is_refused; }

bool plot_draw(const struct plot *p, const char *command)
{
  struct file picture;
  int error = file_open(&picture, p->file), code = EXIT_FILE;
  progress_clear();
  if (error == 0) {
    if (picture.temporary && set_all(p, command, picture.temporary))
      code = file_run(shipped_text(shipped_scripts, "plot"), "plot");
    is_refused = is_refused || code == EXIT_USAGE;
    error = file_close(&picture, code == EXIT_DONE);
  }
  if (error != 0)
    complain(command, "cannot draw %s: cannot write it: %s", p->file, file_error(error));
  return error == 0 && code == EXIT_DONE;
}
