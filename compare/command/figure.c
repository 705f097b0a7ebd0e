/* The tables behind the paper's figures: each is a scene that comes with the tool (data/scenes/). */
#include <stdio.h>
#include <string.h>

#include "compare/command/run.h"
#include "compare/text/shipped.h"

static const char *const accepts[] = { "m1",      "m2",    "F1",     "F2",     "L",      "T",     "alpha", "gait",
                                       "explain", "stats", "format", "digits", "output", "quiet", NULL };

static enum exit_code run(const struct options *options)
{
  char name[16];
  bool known = strlen(options->operand) == 1 && strchr("2345", options->operand[0]);
  snprintf(name, sizeof name, "figure%.4s", options->operand);
  const char *scene = known ? shipped_text(shipped_scenes, name) : NULL;
  if (scene) {
    struct options to_output = *options; /* whatever file the scene names */
    to_output.has_output = to_output.no_plots = true;
    return run_scenes(&to_output, &(struct scene_source){ .path = name, .text = scene }, 1);
  }
  complain("figure", "there is no table for figure '%s': 2, 3, 4 or 5 (figure 1 is a sketch)", options->operand);
  return EXIT_USAGE;
}

static const struct unless_given unless_given[] = {
  { "m1 m2 F1 F2 L T alpha gait format digits", "that of the figure's scene" },
  { NULL, NULL },
};

const struct command command_figure = {
  .name = "figure",
  .summary = "the table behind a figure of the paper: 2, 3, 4 or 5",
  .example = "scallop figure 4 -o figure4.tsv",
  .operand = "2|3|4|5",
  .accepts = accepts,
  .about = "2: positions in time from rest, with symmetric and asymmetric kinematics. 3: one extension from rest.\n"
           "4: change of position and velocity over an extension from rest, against its duration up to the onset of\n"
           "sticking, exact and by the series. 5: mean velocity over alpha and over F1/F2. Normalised as in the paper.\n"
           "What a caption leaves out is chosen, and the table's header says so after 'assumed'. Each is the scene\n"
           "data/scenes/figureN.cfg, for `run`; parameters that are given here take the place of the scene's.",
  .unless_given = unless_given,
  .run = run,
};
