/* The tables behind the paper's figures: each is a scene that comes with the tool (data/scenes/). */
#include <stdio.h>
#include <string.h>

#include "compare/command/commands.h"
#include "compare/command/want.h"
#include "compare/text/shipped.h"

static const struct option options_of_figure[] = {
  OPTIONS_CRAWLER, OPTION_STATS, OPTION_FORMAT, OPTION_DIGITS(DIGITS_OF_DOUBLES, DOUBLE_DIGITS),
  OPTIONS_PLOT,    OPTIONS_LAST,
};

/* Are columns named? Then they are drawn, else the figure as it is in the paper. */
static bool names_columns(const struct plot *p) { return p->x || p->y || p->by; }

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  char name[16];
  const char *figure = arguments->operands[0];
  bool known = strlen(figure) == 1 && strchr("2345", *figure);
  snprintf(name, sizeof name, "figure%.4s", figure);
  const char *scene = known ? shipped_text(shipped_scenes, name) : NULL;
  if (scene) {
    struct scene_options to_output = *(const struct scene_options *)options; /* whatever file the scene names */
    to_output.request.style.has_output = to_output.no_plots = true;
    to_output.commands = arguments->commands;
    if (!names_columns(&to_output.request.style.plot))
      to_output.request.style.plot.picture = name;
    return run_scenes(&to_output, &(struct scene_source){ .path = name, .text = scene }, 1);
  }
  complain("figure", "there is no table for figure '%s': 2, 3, 4 or 5 (figure 1 is a sketch)", figure);
  return EXIT_USAGE;
}

const struct command command_figure = {
  .name = "figure",
  .operand = "2|3|4|5",
  .options = options_of_figure,
  .size = sizeof(struct scene_options),
  .run = run,
};
