/* steady and phase: the quantities of one motion, a row for each point. */
#include <string.h>

#include "compare/command/commands.h"
#include "compare/points/defaults.h"

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
      OPTION_DIGITS(DIGITS, READ_BACK "; with --certified " TEXT_OF(CERTIFIED_DIGITS), MOST_DIGITS), \
      OPTIONS_VARY, OPTIONS_ERRORS("1e-10"), OPTIONS_PLOT, OPTION_STATS, OPTIONS_LAST

static const struct option steady_options[] = { OPTIONS_CRAWLER(NULL, NULL), OPTIONS_OF_ROWS };
static const struct option phase_options[] = { OPTIONS_CRAWLER(NULL, NULL), OPTION_PHASE(NULL), OPTION_V0(NULL),
                                               OPTIONS_OF_ROWS };

static bool is_certified(const struct motion_options *o)
{
  return o->certified || (o->request.style.digits > DIGITS_OF_DOUBLE && !o->request.style.choice);
}

/* The modes in words are a column of a single answer for people, and of any table whose columns are chosen by name. */
static bool has_words(const struct request *r)
{
  return r->style.choice || (!r->scene && !has_many_points(r) && table_is_for_people(&r->style));
}

static const char *plan(const void *options, struct rows *rows)
{
  static const char *const how[][3] = { [OF_STEADY] = { "regime", "modes", "motion" },
                                        [OF_PHASE] = { "regime = phase_regime", "modes = phase_modes",
                                                       "motion = phase_motion" } };
  static const char *const start[] = { "phase", "v0" };
  const struct motion_options *o = options;
  int first = (int)quantity_first(o->of), end = (int)quantity_end(o->of);
  bool certified = is_certified(o);
  const char *wrong = NULL;
  rows->has_parameters = true;
  rows->sheet.as_written = certified;
  if (o->of == OF_PHASE)
    memcpy(rows->extra, start, sizeof start);
  for (int q = first; q < end && !wrong; q++)
    wrong = rows_own(rows, certified ? "%s = certified.%s" : "%s", quantity_rows[q].name, quantity_rows[q].name);
  for (int q = first; q < end && o->error && !wrong; q++)
    wrong = rows_own(rows, "%s_error", quantity_rows[q].name);
  for (int i = 0; i < 2 + has_words(&o->request) && !wrong; i++)
    wrong = rows_own(rows, "%s", how[o->of][i]);
  return wrong ? wrong : rows_own(rows, "status");
}

static const struct option_rule rules[] = {
  { "error", RULE_WITH, "certified", "has nothing to do with --certified: every digit is proven" },
  { NULL, RULE_WITH, NULL, NULL },
};

const struct command command_steady = {
  .name = "steady",
  .summary = "the periodic steady state, exactly",
  .example = "scallop steady --F1 3 --T 0.5 --gait sinusoidal",
  .options = steady_options,
  .initial = &of_steady,
  .size = sizeof(struct motion_options),
  .rules = rules,
  .quantities = { Q_FROUDE, FIRST_OF_PHASE },
  .plan = plan,
};

const struct command command_phase = {
  .name = "phase",
  .summary = "one extension or contraction phase from a start velocity, exactly",
  .example = "scallop phase --phase extension --v0 2.5",
  .options = phase_options,
  .initial = &of_phase,
  .size = sizeof(struct motion_options),
  .rules = rules,
  .quantities = { FIRST_OF_PHASE, QUANTITIES },
  .plan = plan,
};
