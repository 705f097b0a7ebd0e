#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "compare/command/commands.h"
#include "compare/command/want.h"
#include "compare/points/counts.h"
#include "compare/text/file.h"
#include "compare/text/plot.h"
#include "compare/text/shipped.h"

static const struct option options_of_run[] = {
  OPTIONS_CRAWLER,
  OPTION_FLAG("check-only", scene_options, check_only),
  OPTION_STATS,
  OPTION_FLAG("no-plots", scene_options, no_plots),
  OPTION_TEXT("into", scene_options, folder, "a file name"),
  OPTION_OUTPUT,
  OPTION_FORMAT,
  OPTION_DIGITS(DIGITS_PROVEN("where a scene has certified values"), MOST_DIGITS),
  OPTION_QUIET,
  NO_MORE_OPTIONS,
};
static const struct option_rule rules[] = { { "into", RULE_WITH, "output", "and -o exclude each other" },
                                            { NULL, RULE_WITH, NULL, NULL } };

/* A scene whose wants have been read */
struct running {
  struct scene scene;
  struct want *want; /* scene.wants of them */
  struct rows *rows; /* those of tables with a row for each point, which share their points */
};

static void running_free(struct running *r)
{
  for (int i = 0; r->want && i < r->scene.wants; i++)
    want_free(&r->want[i]);
  free(r->want);
  free(r->rows);
  scene_free(&r->scene);
}

static enum exit_code read_scene(struct running *r, const struct scene_source *source, const struct scene_options *o)
{
  enum exit_code code = scene_read(&r->scene, source, &o->request);
  if (code != EXIT_DONE)
    return code;
  r->want = calloc((size_t)r->scene.wants, sizeof *r->want);
  r->rows = calloc((size_t)r->scene.wants, sizeof *r->rows);
  if (!r->want || !r->rows)
    return complain(o->request.style.command, "out of memory"), EXIT_UNSOLVED;
  for (int i = 0; i < r->scene.wants; i++)
    if (!want_read(&r->want[i], &r->scene, r->scene.want[i], o))
      return EXIT_USAGE;
  return EXIT_DONE;
}

/* What tells files apart, however their paths are spelled: a file that is there, or a name in a folder. A device or a
 * pipe takes any number of tables, and that a folder is not there opening the file will say: name is NULL. */
struct place {
  dev_t device;
  ino_t number;
  const char *name;
};
static struct place place_of(const char *path)
{
  const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
  char folder[PATH_MAX] = ".";
  struct stat at;
  if (stat(path, &at) == 0)
    return (struct place){ at.st_dev, at.st_ino, S_ISREG(at.st_mode) ? "" : NULL };
  if (slash)
    snprintf(folder, sizeof folder, "%.*s", (int)(name - path), path);
  return stat(folder, &at) == 0 ? (struct place){ at.st_dev, at.st_ino, name } : (struct place){ .name = NULL };
}

/* NULL is standard output. */
static bool is_same_file(const char *a, const char *b)
{
  if (!a || !b)
    return a == b;
  const struct place of_a = place_of(a), of_b = place_of(b);
  return of_a.name && of_b.name && of_a.device == of_b.device && of_a.number == of_b.number
         && strcmp(of_a.name, of_b.name) == 0;
}

/* Do tables and plots of all scenes go to different files, and none to one that is read? */
static enum exit_code check_files(const struct running *all, int count, const char *command)
{
  enum { MOST = 2 * SCENE_WANTS * 64 };
  static const char *path[MOST + 2];
  int files = 0;
  for (int i = 0; i < count; i++)
    for (const struct want *w = all[i].want; w < all[i].want + all[i].scene.wants && files < MOST; w++) {
      path[files++] = w->files.table;
      if (w->files.has_plot)
        path[files++] = w->files.plot.file;
    }
  for (int i = 0; i < files; i++) {
    int error = path[i] ? file_spares(path[i]) : 0;
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

static void tell_written(const struct scene_options *o, const char *file)
{
  if (file && !o->request.style.quiet)
    fprintf(stderr, "scallop %s: wrote %s\n", o->request.style.command, file);
}

/* The tables of commands, each in its place when its command ends */
static enum exit_code run_commands(struct running *r)
{
  enum exit_code code = EXIT_DONE;
  for (int i = 0; i < r->scene.wants && code != EXIT_FILE; i++)
    if (!r->want[i].has_rows) {
      count_add(COUNT_COMMANDS, 1);
      code = worse(code, command_make(&r->want[i].arguments));
    }
  return code;
}

static enum exit_code draw_plots(const struct running *r, const struct scene_options *o)
{
  enum exit_code code = EXIT_DONE;
  for (int i = 0; i < r->scene.wants; i++) {
    const struct want *w = &r->want[i];
    bool drawn = w->files.has_plot && plot_draw(&w->files.plot, o->request.style.command);
    code = drawn || !w->files.has_plot ? code : EXIT_FILE;
    count_add(COUNT_PLOTS, drawn);
    if (drawn)
      tell_written(o, w->files.plot.file);
  }
  return code;
}

/* What is said of tables that are in their places, and the exit code */
static enum exit_code judge(const struct running *r, const struct rows_run *run, enum exit_code code,
                            const struct scene_options *o)
{
  const char *command = o->request.style.command;
  long failed = 0;
  for (int i = 0; i < run->count; i++)
    failed += run->rows[i].failed_checks;
  if (run->unsolved > 0)
    complain(command, "%s: %ld of %ld points could not be solved, the first: %s", r->scene.name, run->unsolved,
             run->points, run->why);
  if (failed > 0)
    complain(command, "%s: orders that are not as expected: %ld: the column 'verdict' says how", r->scene.name, failed);
  if (draw_plots(r, o) != EXIT_DONE)
    return EXIT_FILE;
  return run->unsolved > 0 ? EXIT_UNSOLVED : failed > 0 ? worse(code, EXIT_CHECK_FAILED) : code;
}

/* All tables are complete before the first takes its place: where something goes wrong the earlier files stay. */
static enum exit_code run_scene(struct running *r, const struct scene_options *o)
{
  struct rows_run run = { .rows = r->rows };
  for (int i = 0; i < r->scene.wants; i++)
    if (r->want[i].has_rows)
      run.rows[run.count++] = r->want[i].rows;
  enum exit_code code = run.count > 0 ? rows_visit(&run, NULL) : EXIT_DONE;
  code = code == EXIT_DONE ? run_commands(r) : code;
  bool keep = code != EXIT_FILE && code != EXIT_USAGE;
  if (!rows_close(&run, keep))
    return EXIT_FILE;
  for (int i = 0; keep && i < r->scene.wants; i++)
    tell_written(o, r->want[i].files.table);
  return keep ? judge(r, &run, code, o) : code;
}

static enum exit_code run_all(struct running *all, int count, const struct scene_options *o)
{
  const char *command = o->request.style.command;
  int wants = 0;
  for (int i = 0; i < count; i++)
    wants += all[i].scene.wants;
  if (o->request.style.has_output && wants > 1) {
    complain(command, "-o names one file, and %d tables are wanted: --into FOLDER says where they go", wants);
    return EXIT_USAGE;
  }
  enum exit_code code = check_files(all, count, command);
  for (int i = 0; i < count && code == EXIT_DONE && o->check_only && !o->request.style.quiet; i++)
    fprintf(stderr, "scallop %s: %s: fine, points: %ld, tables: %d\n", command, all[i].scene.name,
            all[i].scene.request.sweep.products > 0 ? sweep_points(&all[i].scene.request.sweep) : 1,
            all[i].scene.wants);
  if (code != EXIT_DONE || o->check_only)
    return code;
  for (int i = 0; i < count && code != EXIT_FILE; i++)
    code = worse(code, run_scene(&all[i], o));
  return code;
}

/* Reads all scenes, and only then runs them. */
static enum exit_code run_scenes(const struct scene_options *o, const struct scene_source *sources, int count)
{
  struct running *all = calloc((size_t)count, sizeof *all);
  enum exit_code code = EXIT_DONE;
  int read = 0;
  if (!all)
    return complain(o->request.style.command, "out of memory"), EXIT_UNSOLVED;
  while (code == EXIT_DONE && read < count) {
    code = read_scene(&all[read], &sources[read], o);
    read++;
  }
  if (code == EXIT_DONE)
    code = run_all(all, count, o);
  for (int i = 0; i < read; i++)
    running_free(&all[i]);
  free(all);
  return code;
}

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  struct scene_source *sources = calloc((size_t)arguments->operand_count, sizeof *sources);
  if (!sources) {
    complain("run", "out of memory");
    return EXIT_UNSOLVED;
  }
  for (int i = 0; i < arguments->operand_count; i++) {
    const char *operand = arguments->operands[i];
    sources[i] = (struct scene_source){ .path = strcmp(operand, "/dev/stdin") == 0 ? "-" : operand,
                                        .text = shipped_text(shipped_scenes, operand) };
  }
  enum exit_code code = run_scenes(options, sources, arguments->operand_count);
  free(sources);
  return code;
}

const struct command command_run = {
  .name = "run",
  .operand = "SCENE.cfg...",
  .options = options_of_run,
  .rules = rules,
  .size = sizeof(struct scene_options),
  .quantities = { 0, NAMED_QUANTITIES },
  .run = run,
};

static const struct option options_of_figure[] = {
  OPTIONS_CRAWLER, OPTION_STATS, OPTION_FORMAT, OPTION_DIGITS(DIGITS_OF_DOUBLES, DOUBLE_DIGITS),
  OPTIONS_PLOT,    OPTIONS_LAST,
};

/* The table behind a figure of the paper is that of a scene (data/scenes/), whatever file that names. Where columns are
 * named they are drawn, else the figure as it is in the paper. */
static enum exit_code run_figure(const struct arguments *arguments, const void *options)
{
  struct scene_options o = *(const struct scene_options *)options;
  struct plot *plot = &o.request.style.plot;
  const char *figure = arguments->operands[0];
  char name[16];
  snprintf(name, sizeof name, "figure%.4s", figure);
  const char *scene = strlen(figure) == 1 ? shipped_text(shipped_scenes, name) : NULL;
  if (!scene) {
    complain("figure", "there is no table for figure '%s': 2, 3, 4 or 5 (figure 1 is a sketch)", figure);
    return EXIT_USAGE;
  }
  o.request.style.has_output = o.no_plots = true;
  plot->picture = plot->x || plot->y || plot->by ? NULL : name;
  return run_scenes(&o, &(struct scene_source){ .path = name, .text = scene }, 1);
}

const struct command command_figure = {
  .name = "figure",
  .operand = "2|3|4|5",
  .options = options_of_figure,
  .size = sizeof(struct scene_options),
  .run = run_figure,
};
