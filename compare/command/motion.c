/* steady and phase: the quantities of one motion, a row for each point. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/sheet.h"
#include "compare/answers/points.h"
#include "compare/points/defaults.h"
#include "compare/command/commands.h"
#include "compare/command/flint.h"

struct motion_options {
  struct request request;
  bool certified, error;
  enum quantity_of of;
};
static const struct motion_options of_steady = { .of = OF_STEADY }, of_phase = { .of = OF_PHASE };

#define DIGITS DIGITS_PROVEN("with --certified")
#define OPTIONS_OF_ROWS \
  OPTION_FLAG("certified", "in ball arithmetic: every digit printed is proven", motion_options, certified), \
      OPTION_FLAG("error", "after each number an estimate of its error", motion_options, error), OPTION_POINTS, \
      OPTION_FORMAT("tsv"), \
      OPTION_DIGITS(DIGITS, READ_BACK "; with --certified " TEXT_OF(CERTIFIED_DIGITS), MOST_DIGITS), OPTIONS_PLOT, \
      OPTION_STATS, OPTIONS_LAST

static const struct option steady_options[] = { OPTIONS_CRAWLER(NULL, NULL), OPTIONS_OF_ROWS };
static const struct option phase_options[] = { OPTIONS_CRAWLER(NULL, NULL), OPTION_PHASE(NULL), OPTION_V0(NULL),
                                               OPTIONS_OF_ROWS };

/* The modes in words are a column of a single answer for people, and of any table whose columns are chosen by name. */
static bool has_words(const struct request *r)
{
  return r->style.choice || (!has_many_points(r) && table_is_for_people(&r->style));
}

/* The texts of the table's own columns, NULL-terminated */
enum { MOST = 2 * QUANTITIES + 5, TEXT = 80 };
static void list_columns(const char *columns[MOST], char texts[QUANTITIES][2][TEXT], const struct motion_options *o)
{
  static const char *const how[][3] = { [OF_STEADY] = { "regime", "modes", "motion" },
                                        [OF_PHASE] = { "regime = phase_regime", "modes = phase_modes",
                                                       "motion = phase_motion" } };
  int n = 0, first = (int)quantity_first(o->of), end = (int)quantity_end(o->of);
  for (int q = first; q < end; q++) {
    snprintf(texts[q][0], TEXT, o->certified ? "%s = certified.%s" : "%s", quantity_rows[q].name,
             quantity_rows[q].name);
    columns[n++] = texts[q][0];
  }
  for (int q = first; q < end && o->error; q++) {
    snprintf(texts[q][1], TEXT, "%s_error", quantity_rows[q].name);
    columns[n++] = texts[q][1];
  }
  for (int i = 0; i < 2 + has_words(&o->request); i++)
    columns[n++] = how[o->of][i];
  columns[n++] = "status";
  columns[n] = NULL;
}

/* Does any of the chosen columns need FLINT? What is wrong with one is told when it is known what a file carries. */
static bool choice_needs_flint(const struct table_choice *choice, struct sheet *sheet)
{
  for (int i = 0; choice && i < choice->count; i++)
    sheet_add(sheet, choice->names[i]);
  sheet_free(sheet);
  bool needs = asked_needs_flint(sheet->asked);
  sheet->asked->quantities.count = 0;
  return needs;
}

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  static const char *const none[] = { NULL }, *const start[] = { "phase", "v0", NULL };
  const struct motion_options *o = options;
  (void)arguments;
  const char *columns[MOST];
  char texts[QUANTITIES][2][TEXT];
  long digits = o->request.style.digits > 0 ? o->request.style.digits : CERTIFIED_DIGITS;
  struct asked *asked = malloc(sizeof *asked);
  if (!asked)
    return complain(o->request.style.command, "out of memory"), EXIT_UNSOLVED;
  *asked = asked_nothing();
  asked->as_written = o->certified;
  asked->digits = digits;
  list_columns(columns, texts, o);
  struct sheet sheet = { .asked = asked, .own = columns, .digits = digits };
  const struct point_table table = { .extra = o->of == OF_PHASE ? start : none, .columns = columns, .sheet = &sheet };
  enum exit_code code = EXIT_UNSOLVED;
  const char *command = o->request.style.command;
  if ((!o->certified || flint_for(command, "--certified"))
      && (!choice_needs_flint(o->request.style.choice, &sheet) || flint_for(command, "such a column")))
    code = for_each_point(&o->request, &table);
  sheet_free(&sheet);
  free(asked);
  return code;
}

static const struct option_rule rules[] = {
  { "error", RULE_WITH, "certified", "has nothing to do with --certified: every digit is proven" },
  { NULL, RULE_WITH, NULL, NULL },
};

static bool is_sound(const void *options)
{
  const struct motion_options *o = options;
  return digits_hold(&o->request.style, o->certified, DIGITS);
}

const struct command command_steady = {
  .name = "steady",
  .summary = "the periodic steady state, exactly",
  .example = "scallop steady --F1 3 --T 0.5 --gait sinusoidal",
  .options = steady_options,
  .initial = &of_steady,
  .size = sizeof(struct motion_options),
  .rules = rules,
  .is_sound = is_sound,
  .quantities = { Q_FROUDE, FIRST_OF_PHASE },
  .run = run,
};

const struct command command_phase = {
  .name = "phase",
  .summary = "one extension or contraction phase from a start velocity, exactly",
  .example = "scallop phase --phase extension --v0 2.5",
  .options = phase_options,
  .initial = &of_phase,
  .size = sizeof(struct motion_options),
  .rules = rules,
  .is_sound = is_sound,
  .quantities = { FIRST_OF_PHASE, QUANTITIES },
  .run = run,
};
