#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "compare/command/commands.h"
#include "compare/command/run.h"
#include "compare/text/shipped.h"
#include "compare/command/with_flint.h"

#define OF_SCENE "that of the scene"
#define DIGITS DIGITS_PROVEN("where a scene has certified values")

static const struct option options_of_run[] = {
  OPTIONS_CRAWLER(OF_SCENE, OF_SCENE),
  OPTION_FLAG("check-only", "read and check the scenes, and do nothing", scene_options, check_only),
  OPTION_FLAG("explain", "the plan, instead of the work", scene_options, explain),
  OPTION_FLAG("stats", "afterwards, on standard error, what was done: the counters of the plan's stages", scene_options,
              stats),
  OPTION_FLAG("no-plots", "tables only", scene_options, no_plots),
  OPTION_TEXT("into", "FOLDER", "the folder for files that a scene names by a path without / in front", "the current one",
              scene_options, folder, "a file name"),
  OPTION_OUTPUT("the files that the scenes name"),
  OPTION_FORMAT(OF_SCENE),
  OPTION_DIGITS(DIGITS, OF_SCENE, MOST_DIGITS),
  OPTION_QUIET,
  NO_MORE_OPTIONS,
};

enum { MOST_SCENES = 64 };

struct scenes {
  int count;
  const char *input; /* the text of the one on standard input, or NULL */
  struct scene *scene[MOST_SCENES];
};

static int tables_of(const struct scenes *all)
{
  int tables = 0;
  for (int i = 0; i < all->count; i++)
    tables += all->scene[i]->wants;
  return tables;
}

/* What is done first, then what is not requested. */
static enum exit_code explain(const struct scenes *all, const struct scene_options *o)
{
  static const char *const columns[] = { "scene", "stage", "count", "known", "for", NULL };
  static struct table table;
  if (!table_open(&table, &o->request.style))
    return EXIT_FILE;
  table_note(&table, "scallop " SCALLOP_VERSION);
  table_note(&table, "command: run --explain");
  table_note(&table, "count: as --stats will count, where every point can be solved");
  table_columns(&table, columns);
  table_begin_rows(&table);
  for (int i = 0; i < all->count; i++)
    for (int left_out = 0; left_out < 2; left_out++)
      for (int k = 0; k < COUNT_PLANNED; k++) {
        const struct plan_stage *s = &all->scene[i]->plan.stage[k];
        if ((s->count == 0) != (left_out == 1))
          continue;
        table_text(&table, all->scene[i]->name);
        table_text(&table, count_name((enum count)k));
        table_rounded(&table, s->count, "%.15g");
        table_text(&table, s->count == 0 ? "not requested" : s->is_at_most ? "at most" : "exactly");
        table_text(&table, s->count == 0 ? "-" : s->reason);
      }
  return table_close(&table) ? EXIT_DONE : EXIT_FILE;
}

static void print_stats(void)
{
  struct rusage usage;
  fputs("# what was done\nstage\tcount\n", stderr);
  for (int k = 0; k < COUNTS; k++)
    fprintf(stderr, "%s\t%ld\n", count_name((enum count)k), count_of((enum count)k));
  if (getrusage(RUSAGE_SELF, &usage) == 0)
    fprintf(stderr, "peak_memory_kB\t%ld\n", usage.ru_maxrss);
}

/* The tables of commands that a scene can want, each with an option that its name stands for. */
static const struct {
  const char *what;
  const struct command *command;
  char *option[2];
} tables[] = { { "terms", &command_series, { "--source", "derived" } }, { "bounds", &command_series, { "--bound", NULL } },
               { "breakdown", &command_breakdown, { NULL, NULL } },     { "stability", &command_stress, { NULL, NULL } },
               { "work-precision", &command_workprec, { NULL, NULL } }, { "claims", &command_claims, { NULL, NULL } } };

static const struct command *const wanted[] = { &command_series,   &command_breakdown, &command_stress,
                                                &command_workprec, &command_claims,    NULL };

enum { MOST_ARGUMENTS = 128 };

/* The parameters of the scene that the command takes, as options. Returns how many arguments there are then. */
static int add_parameters(char **arguments, int count, const struct command *command, const struct point *base)
{
  static char *const flags[] = { "--m1", "--m2", "--F1", "--F2", "--L", "--T", "--alpha", "--gait", "--v0" };
  bool has_map = false;
  for (int i = 0; i < count; i++)
    has_map |= strcmp(arguments[i], "--map") == 0;
  for (size_t i = 0; i < sizeof flags / sizeof *flags; i++) {
    const char *name = flags[i] + 2, *text = i < CRAWLER_NUMBERS   ? base->written[i]
                                             : i > CRAWLER_NUMBERS ? base->written_v0
                                             : base->has_gait      ? base->crawler.gait->name
                                                                   : NULL;
    bool idle = command == &command_breakdown && !has_map && strcmp(name, "T") == 0; /* all T are looked at */
    if (!text || idle || !option_of(command, name))
      continue;
    arguments[count++] = flags[i];
    arguments[count++] = (char *)text;
  }
  return count;
}

static enum exit_code run_command(const struct scene *scene, const struct scene_want *w, const struct scene_options *o,
                                  bool only_read)
{
  char *arguments[MOST_ARGUMENTS] = { "scallop" }, digits[32];
  struct arguments read;
  enum exit_code code = EXIT_DONE;
  int table = 0, count = 2;
  while (strcmp(tables[table].what, w->what) != 0)
    table++;
  const struct command *command = tables[table].command;
  arguments[1] = (char *)command->name;
  for (int i = 0; i < 2 && tables[table].option[i]; i++)
    arguments[count++] = tables[table].option[i];
  for (int i = 0; i < w->argument_count; i++)
    arguments[count++] = w->arguments[i];
  count = add_parameters(arguments, count, command, &scene->base);
  if (o->request.style.quiet && option_of(command, "quiet"))
    arguments[count++] = "--quiet";
  snprintf(digits, sizeof digits, "--digits=%ld", o->request.style.digits);
  if (o->request.style.digits > 0 && option_of(command, "digits"))
    arguments[count++] = digits;
  if (options_read(&read, command, wanted, count, arguments, &code) == READ_RUN) {
    code = EXIT_DONE;
    read.options.request.style.output = w->file;
    read.options.request.style.format = w->format;
    if (!only_read)
      code = command->run(&read, &read.options);
  }
  options_free(&read);
  return code;
}

static enum exit_code read_all(struct scenes *all, const struct scene_options *o, const struct scene_source *sources,
                               int count)
{
  enum exit_code code = EXIT_DONE;
  for (int i = 0; i < count && code == EXIT_DONE; i++) {
    struct scene *scene = malloc(sizeof *scene);
    if (!scene)
      complain(o->request.style.command, "out of memory");
    code = scene ? scene_read(scene, &sources[i], o, run_command) : EXIT_UNSOLVED;
    if (code == EXIT_DONE)
      all->scene[all->count++] = scene;
    else
      free(scene);
  }
  return code;
}

static void free_all(struct scenes *all)
{
  for (int i = 0; i < all->count; i++) {
    scene_free(all->scene[i]);
    free(all->scene[i]);
  }
}

static bool needs_flint(const struct scenes *all)
{
  for (int i = 0; i < all->count; i++)
    if (all->scene[i]->plan.needs_flint)
      return true;
  return false;
}

/* Another program may take over, and read it again. */
static bool put_back(const char *text)
{
  FILE *again = tmpfile();
  bool kept = again && fputs(text, again) >= 0 && fflush(again) == 0 && lseek(fileno(again), 0, SEEK_SET) == 0
              && dup2(fileno(again), STDIN_FILENO) >= 0;
  if (again)
    fclose(again);
  return kept;
}

static bool hand_over(const struct scenes *all, const struct arguments *arguments, const struct scene_options *o)
{
  if (all->input && !put_back(all->input)) {
    complain(o->request.style.command, "cannot keep the scene on standard input for scallop-flint: %s", strerror(errno));
    return false;
  }
  for (int i = 0; i < all->count; i++) {
    struct stat there;
    const char *path = all->scene[i]->path;
    if (!path || stat(path, &there) != 0 || S_ISREG(there.st_mode))
      continue;
    complain(o->request.style.command, "%s can be read only once, and scallop-flint is to read it again: give it as '-'",
             path);
    return false;
  }
  return has_flint(arguments, "this scene");
}

static enum exit_code run_all(struct scenes *all, const struct arguments *arguments, const struct scene_options *o)
{
  enum exit_code code = EXIT_DONE;
  if (o->request.style.has_output && !o->explain && tables_of(all) > 1) {
    complain(o->request.style.command, "-o names one file, and %d tables are wanted: --into FOLDER says where they go",
             tables_of(all));
    return EXIT_USAGE;
  }
  if (!scenes_check_files(all->scene, all->count, o))
    return EXIT_USAGE;
  if (o->explain)
    return explain(all, o);
  if (o->check_only) {
    for (int i = 0; i < all->count && !o->request.style.quiet; i++)
      fprintf(stderr, "scallop %s: %s: fine, points: %ld, tables: %d\n", o->request.style.command, all->scene[i]->name,
              sweep_points(&all->scene[i]->sweep), all->scene[i]->wants);
    return EXIT_DONE;
  }
  if (needs_flint(all) && !hand_over(all, arguments, o))
    return EXIT_UNSOLVED;
  for (int i = 0; i < all->count && code != EXIT_FILE; i++) {
    enum exit_code one = scene_run(all->scene[i], o);
    code = one > code ? one : code;
  }
  if (o->stats)
    print_stats();
  return code;
}

enum exit_code run_scenes(const struct arguments *arguments, const struct scene_options *o,
                          const struct scene_source *sources, int count)
{
  struct scenes *all = calloc(1, sizeof *all);
  if (!all || count > MOST_SCENES) {
    complain(o->request.style.command, all ? "%d scenes: %d at a time" : "out of memory", count, MOST_SCENES);
    free(all);
    return EXIT_USAGE;
  }
  for (int i = 0; i < count; i++)
    if (strcmp(sources[i].path, "-") == 0)
      all->input = sources[i].text;
  enum exit_code code = read_all(all, o, sources, count);
  if (code == EXIT_DONE)
    code = run_all(all, arguments, o);
  free_all(all);
  free(all);
  return code;
}

static bool is_input(const char *operand) { return strcmp(operand, "-") == 0 || strcmp(operand, "/dev/stdin") == 0; }

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  const struct scene_options *o = options;
  struct scene_source sources[MOST_SCENES];
  int count = arguments->operand_count < MOST_SCENES ? arguments->operand_count : MOST_SCENES;
  if (arguments->operand_count > MOST_SCENES) {
    complain("run", "%d scenes: %d at a time", arguments->operand_count, MOST_SCENES);
    return EXIT_USAGE;
  }
  if (o->folder && o->request.style.has_output) {
    complain("run", "--into and -o exclude each other");
    return EXIT_USAGE;
  }
  char *input = NULL;
  for (int i = 0; i < count; i++) {
    sources[i] = (struct scene_source){ .path = arguments->operands[i],
                                        .text = shipped_text(shipped_scenes, arguments->operands[i]) };
    if (!is_input(arguments->operands[i]))
      continue;
    enum exit_code read = input ? EXIT_DONE : scene_text_read("run", "-", &input);
    if (read != EXIT_DONE)
      return read;
    sources[i] = (struct scene_source){ .path = "-", .text = input };
  }
  enum exit_code code = run_scenes(arguments, o, sources, count);
  free(input);
  return code;
}

const struct command command_run = {
  .name = "run",
  .summary = "what a scene asks for and nothing else",
  .example = "scallop run figure5 --explain",
  .operand = "SCENE.cfg...",
  .options = options_of_run,
  .size = sizeof(struct scene_options),
  .about =
      "A scene is a file that says which crawler and gait, what varies, and what is wanted of it: trajectories, phases, "
      "steady\n"
      "states, series, errors, orders, or the tables of other commands. docs/scenes.md has the language. Each want is a "
      "table\n"
      "with a file and a format of its own, and may have a plot. A name without .cfg is that of a scene that comes with\n"
      "the tool: figure2 to figure5, claims, errors, stress, workprec and the maps are. '-' is a scene on standard input.\n"
      "Parameters, --digits and --format given here take the place of the scene's.\n"
      "--explain: the plan instead of the work. Columns: scene; stage; count: how often, as --stats will count it; known:\n"
      "exactly, at most, or not requested; for: the quantity or table that first needs it.",
  .run = run,
};
