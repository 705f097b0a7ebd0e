#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/command/commands.h"
#include "compare/command/run.h"
#include "compare/text/shipped.h"
#include "compare/command/flint.h"

#define OF_SCENE "that of the scene"
#define DIGITS DIGITS_PROVEN("where a scene has certified values")

static const struct option options_of_run[] = {
  OPTIONS_CRAWLER(OF_SCENE, OF_SCENE),
  OPTION_FLAG("check-only", "read and check the scenes, and do nothing", scene_options, check_only),
  OPTION_STATS,
  OPTION_FLAG("no-plots", "tables only", scene_options, no_plots),
  OPTION_TEXT("into", "FOLDER",
              "the folder for all files that scenes name; a name that may lead out of it, /x or ../x, is refused",
              "the current one", scene_options, folder, "a file name"),
  OPTION_OUTPUT("the files that the scenes name"),
  OPTION_FORMAT(OF_SCENE),
  OPTION_DIGITS(DIGITS, OF_SCENE, MOST_DIGITS),
  OPTION_QUIET,
  NO_MORE_OPTIONS,
};
static const struct option_rule rules[] = { { "into", RULE_WITH, "output", "and -o exclude each other" },
                                            { NULL, RULE_WITH, NULL, NULL } };

struct scenes {
  int count;
  struct scene *scene;
};

/* The tables of commands that a scene can want, each with an option that its name stands for. */
static const struct {
  const char *what;
  const struct command *command;
  char *option[2];
} tables[] = {
  { "terms", &command_series, { "--source", "derived" } }, { "bounds", &command_series, { "--bound", NULL } },
  { "breakdown", &command_breakdown, { NULL, NULL } },     { "stability", &command_stress, { NULL, NULL } },
  { "work-precision", &command_workprec, { NULL, NULL } }, { "claims", &command_claims, { NULL, NULL } }
};

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
    code = options_book(&read);
    read.options.request.style.output = w->file;
    read.options.request.style.format = w->format;
    if (code == EXIT_DONE && !only_read)
      code = command->run(&read, &read.options);
  }
  options_free(&read);
  return code;
}

static enum exit_code run_all(const struct scenes *all, const struct scene_options *o)
{
  const char *command = o->request.style.command;
  int wants = 0;
  bool needs_flint = false;
  for (int i = 0; i < all->count; i++) {
    wants += all->scene[i].wants;
    needs_flint |= all->scene[i].needs_flint;
  }
  if (o->request.style.has_output && wants > 1) {
    complain(command, "-o names one file, and %d tables are wanted: --into FOLDER says where they go", wants);
    return EXIT_USAGE;
  }
  enum exit_code code = scenes_check_files(all->scene, all->count, o);
  if (code != EXIT_DONE)
    return code;
  if (o->check_only) {
    for (int i = 0; i < all->count && !o->request.style.quiet; i++)
      fprintf(stderr, "scallop %s: %s: fine, points: %ld, tables: %d\n", command, all->scene[i].name,
              sweep_points(&all->scene[i].sweep), all->scene[i].wants);
    return EXIT_DONE;
  }
  if (needs_flint && !flint_for(command, "this scene"))
    return EXIT_UNSOLVED;
  for (int i = 0; i < all->count && code != EXIT_FILE; i++) {
    enum exit_code one = scene_run(&all->scene[i], o);
    code = one > code ? one : code;
  }
  return code;
}

enum exit_code run_scenes(const struct scene_options *o, const struct scene_source *sources, int count)
{
  struct scenes all = { 0, calloc((size_t)count, sizeof *all.scene) };
  enum exit_code code = all.scene ? EXIT_DONE : EXIT_UNSOLVED;
  if (!all.scene)
    complain(o->request.style.command, "out of memory");
  while (code == EXIT_DONE && all.count < count) {
    code = scene_read(&all.scene[all.count], &sources[all.count], o, run_command);
    all.count += code == EXIT_DONE;
  }
  if (code == EXIT_DONE)
    code = run_all(&all, o);
  for (int i = 0; i < all.count; i++)
    scene_free(&all.scene[i]);
  free(all.scene);
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
  .summary = "what a scene asks for and nothing else",
  .example = "scallop run figure5 --stats",
  .operand = "SCENE.cfg...",
  .options = options_of_run,
  .rules = rules,
  .size = sizeof(struct scene_options),
  .quantities = { 0, NAMED_QUANTITIES },
  .run = run,
};
