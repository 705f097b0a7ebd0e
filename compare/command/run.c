/* Commands run and figure: the tables of scenes. */
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "compare/command/scene_table.h"
#include "compare/points/counts.h"
#include "compare/text/file.h"

static const struct option options_of_run[] = {
  OPTIONS_CRAWLER,
  OPTION_FLAG("check-only", scene_options, check_only),
  OPTION_STATS,
  OPTION_FLAG("no-plots", scene_options, no_plots),
  OPTION_TEXT("into", scene_options, folder, "a file name"),
  OPTION_OUTPUT,
  OPTION_FORMAT,
  OPTION_DIGITS(DIGITS_PROVEN("where a scene has certified values"), MAX_DIGITS),
  OPTION_QUIET,
  NO_MORE_OPTIONS,
};
static const struct option_rule rules[] = { { "into", RULE_WITH, "output", "and -o exclude each other" },
                                            { NULL, RULE_WITH, NULL, NULL } };

/* Identity of a file, independent of the spelling of its path: an existing file, or a name in a folder. name NULL: not
 * compared, as a device or pipe takes any number of tables, and a missing folder is an error later. */
struct file_place {
  dev_t device;
  ino_t number;
  const char *name;
};
static struct file_place place_of(const char *path)
{
  const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
  char folder[PATH_MAX] = ".";
  struct stat at;
  if (stat(path, &at) == 0)
    return (struct file_place){ at.st_dev, at.st_ino, S_ISREG(at.st_mode) ? "" : NULL };
  if (slash)
    snprintf(folder, sizeof folder, "%.*s", (int)(name - path), path);
  return stat(folder, &at) == 0 ? (struct file_place){ at.st_dev, at.st_ino, name }
                                : (struct file_place){ .name = NULL };
}

/* Returns true if both paths are one file; NULL: standard output. */
static bool is_same_file(const char *a, const char *b)
{
  if (!a || !b)
    return a == b;
  const struct file_place of_a = place_of(a), of_b = place_of(b);
  return of_a.name && of_b.name && of_a.device == of_b.device && of_a.number == of_b.number
         && strcmp(of_a.name, of_b.name) == 0;
}

/* Checks that tables and plots of all scenes go to different files, and not to an input file. */
static enum exit_code check_files(const struct planned_scene *all, int count, const char *command)
{
  enum { MAX_FILES = 2 * SCENE_TABLES * 64 };
  static const char *path[MAX_FILES + 2];
  int files = 0;
  for (const struct planned_scene *s = all; s < all + count; s++)
    for (const struct scene_table *w = s->table; w < s->table + s->scene.tables && files < MAX_FILES; w++) {
      path[files++] = w->files.table;
      if (w->files.has_plot)
        path[files++] = w->files.plot.file;
    }
  for (int i = 0; i < files; i++) {
    int error = path[i] ? file_check_output(path[i]) : 0;
    if (error != 0)
      return complain(command, "cannot write %s: %s", path[i], file_error(error)), EXIT_FILE;
    for (int k = 0; k < i; k++)
      if (is_same_file(path[i], path[k]))
        return complain(command, "two things would go to %s: give each table and each plot a file of its own",
                        path[i] ? path[i] : "standard output"),
               EXIT_USAGE;
  }
  return EXIT_DONE;
}

static enum exit_code worse(enum exit_code a, enum exit_code b) { return a > b ? a : b; }

static void print_written(const struct style *given, const char *file)
{
  if (file && !given->quiet)
    fprintf(stderr, "scallop %s: wrote %s\n", given->command, file);
}

static enum exit_code draw_plots(const struct planned_scene *s, const struct style *given)
{
  enum exit_code code = EXIT_DONE;
  for (const struct scene_table *w = s->table; w < s->table + s->scene.tables; w++) {
    bool drawn = w->files.has_plot && plot_draw(&w->files.plot, given->command);
    code = drawn || !w->files.has_plot ? code : EXIT_FILE;
    count_add(COUNT_PLOTS, drawn);
    print_written(given, drawn ? w->files.plot.file : NULL);
  }
  return code;
}

/* Prints messages about complete tables, draws their plots, and returns the exit code. */
static enum exit_code judge(const struct planned_scene *s, const struct rows_set *run, enum exit_code code,
                            const struct style *given)
{
  long failed = 0;
  for (int i = 0; i < s->scene.tables; i++)
    print_written(given, s->table[i].files.table);
  for (int i = 0; i < run->count; i++)
    failed += run->rows[i].failed_checks;
  if (run->unsolved > 0)
    complain(given->command, "%s: %ld of %ld points could not be solved, the first: %s", s->scene.name, run->unsolved,
             run->points, run->why);
  if (failed > 0)
    complain(given->command, "%s: orders that are not as expected: %ld: the column 'verdict' says how", s->scene.name,
             failed);
  if (draw_plots(s, given) != EXIT_DONE)
    return EXIT_FILE;
  return run->unsolved > 0 ? EXIT_UNSOLVED : failed > 0 ? worse(code, EXIT_CHECK_FAILED) : code;
}

/* Writes the tables of a scene: tables of rows together, point by point, then the other ones by their commands. The
 * tables of rows replace earlier files only after all are complete; after an error, earlier files stay. */
static enum exit_code run_scene(struct planned_scene *s, const struct style *given)
{
  struct rows_set run = { .count = s->tables, .rows = s->rows };
  enum exit_code code = run.count > 0 ? rows_visit(&run, NULL) : EXIT_DONE;
  bool is_fine = code == EXIT_DONE;
  for (int i = 0; is_fine && i < s->scene.tables && code != EXIT_FILE; i++)
    if (!s->table[i].rows) {
      count_add(COUNT_COMMANDS, 1);
      code = worse(code, command_make(&s->table[i].arguments));
    }
  bool keep = code != EXIT_FILE && code != EXIT_USAGE;
  if (!rows_close(&run, keep))
    return EXIT_FILE;
  return keep ? judge(s, &run, code, given) : code;
}

static enum exit_code run_all(struct planned_scene *all, int count, const struct scene_options *o)
{
  const struct style *given = &o->request.style;
  int tables = 0;
  for (int i = 0; i < count; i++)
    tables += all[i].scene.tables;
  if (given->has_output && tables > 1) {
    complain(given->command, "-o names one file, and %d tables are requested: use --into FOLDER", tables);
    return EXIT_USAGE;
  }
  enum exit_code code = check_files(all, count, given->command);
  bool is_fine = code == EXIT_DONE;
  for (struct planned_scene *s = all; is_fine && s < all + count && code != EXIT_FILE; s++)
    if (!o->check_only)
      code = worse(code, run_scene(s, given));
    else if (!given->quiet)
      fprintf(stderr, "scallop %s: %s: fine, points: %ld, tables: %d\n", given->command, s->scene.name,
              sweep_points(&s->scene.request.sweep), s->scene.tables);
  return code;
}

/* Reads all scenes, then runs them. */
static enum exit_code run_scenes(const struct scene_options *o, const char *const *names, int count)
{
  struct planned_scene *all = calloc((size_t)count, sizeof *all);
  enum exit_code code = EXIT_DONE;
  int read = 0;
  if (!all)
    return complain(o->request.style.command, "out of memory"), EXIT_UNSOLVED;
  for (; read < count && code == EXIT_DONE; read++) {
    const char *name = strcmp(names[read], "/dev/stdin") == 0 ? "-" : names[read];
    code = planned_scene_read(&all[read],
                              &(struct scene_source){ .path = name, .text = shipped_text(shipped_scenes, name) }, o);
  }
  if (code == EXIT_DONE)
    code = run_all(all, count, o);
  while (read > 0)
    planned_scene_free(&all[--read]);
  free(all);
  return code;
}

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  return run_scenes(options, arguments->operands, arguments->operand_count);
}

const struct command command_run = {
  .name = "run",
  .operand = "SCENE.cfg...",
  .options = options_of_run,
  .rules = rules,
  .size = sizeof(struct scene_options),
  .run = run,
};

static const struct option options_of_figure[] = {
  OPTIONS_CRAWLER, OPTION_STATS, OPTION_FORMAT, OPTION_DIGITS(DIGITS_OF_DOUBLES, DOUBLE_DIGITS),
  OPTIONS_PLOT,    OPTIONS_LAST,
};

/* Writes the table of a figure, from a scene of data/scenes/. The plot shows the named columns, or else the figure of
 * the paper. */
static enum exit_code run_figure(const struct arguments *arguments, const void *options)
{
  struct scene_options o = *(const struct scene_options *)options;
  struct plot *plot = &o.request.style.plot;
  const char *figure = arguments->operands[0];
  char name[16];
  snprintf(name, sizeof name, "figure%.4s", figure);
  if (strlen(figure) != 1 || !shipped_text(shipped_scenes, name)) {
    complain("figure", "there is no table for figure '%s': 2, 3, 4 or 5 (figure 1 is a sketch)", figure);
    return EXIT_USAGE;
  }
  o.request.style.has_output = o.no_plots = true;
  plot->picture = plot->x || plot->y || plot->by ? NULL : name;
  return run_scenes(&o, (const char *const[]){ name }, 1);
}

const struct command command_figure = {
  .name = "figure",
  .operand = "2|3|4|5",
  .options = options_of_figure,
  .size = sizeof(struct scene_options),
  .run = run_figure,
};
