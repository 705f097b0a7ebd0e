/* steady and phase: the quantities of one motion, a row for each point. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/answers/answer.h"
#include "compare/answers/mode_change.h"
#include "compare/answers/points.h"
#include "compare/answers/defaults.h"
#include "compare/command/commands.h"
#include "compare/command/with_flint.h"

#pragma weak answer_in_decimals
#pragma weak decimals_free

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
      OPTIONS_LAST

static const struct option steady_options[] = { OPTIONS_CRAWLER(NULL, NULL), OPTIONS_OF_ROWS };
static const struct option phase_options[] = { OPTIONS_CRAWLER(NULL, NULL), OPTION_PHASE(NULL), OPTION_V0(NULL),
                                               OPTIONS_OF_ROWS };

/* A row of any arithmetic */
struct cells {
  struct answer answer;
  char *decimals[QUANTITIES]; /* of --certified */
  double errors[QUANTITIES];  /* of --error */
};

/* NULL, or why there are no numbers; that lives until the next call. */
static const char *solve(struct cells *c, const struct motion_options *o, const struct point *p)
{
  static char why[POINT_STATUS];
  const struct motion motion = motion_of(p, o->of);
  const char *more = NULL;
  long digits = o->request.style.digits > 0 ? o->request.style.digits : CERTIFIED_DIGITS;
  bool done = o->certified ? answer_in_decimals(&c->answer, c->decimals, p, o->of, digits, &more)
              : o->error   ? answer_with_errors(&c->answer, &motion, c->errors)
                           : answer_in_double(&c->answer, &motion);
  if (!done)
    snprintf(why, sizeof why, "%s%s%s", scallop_status_text(c->answer.status), more ? ": " : "", more ? more : "");
  return done ? NULL : why;
}

/* The modes in words are a column of a single answer for people, and of any table whose columns are chosen by name. */
static bool has_words(const struct request *r)
{
  return r->style.choice || (!has_many_points(r) && table_is_for_people(&r->style));
}

static void write_words(struct table *t, const struct motion_options *o, const struct point *p)
{
  enum { SHOWN = 6 };
  const struct motion motion = motion_of(p, o->of);
  struct answer answer;
  char words[MOTION_WORDS];
  table_text(t, answer_in_double(&answer, &motion) ? motion_in_words(words, &motion, &answer, SHOWN) : "-");
}

static const char *row(struct table *t, const struct point *p, const void *context, const char *refused)
{
  static const double rounded_up = 1.005; /* of an estimate, with three digits */
  const struct motion_options *o = context;
  struct cells c = { .decimals = { NULL } };
  char modes[MOTION_MODES_TEXT], status[ANSWER_STATUS];
  const char *why = refused ? refused : solve(&c, o, p);
  int first = (int)quantity_first(o->of), end = (int)quantity_end(o->of);
  for (int q = first; q < end; q++)
    if (c.decimals[q])
      table_digits(t, c.decimals[q]);
    else
      table_number(t, why || o->certified ? NAN : c.answer.value[q].high);
  for (int q = first; q < end && o->error; q++)
    table_rounded(t, why ? NAN : rounded_up * c.errors[q], "%.3g");
  table_text(t, why ? "-" : scallop_regime_text(c.answer.regime));
  table_text(t, why ? "-" : motion_modes_text(modes, o->of, c.answer.modes));
  if (has_words(&o->request) && why)
    table_text(t, "-");
  else if (has_words(&o->request))
    write_words(t, o, p);
  table_text(t, why ? why : o->certified ? "certified" : answer_status_text(status, &c.answer));
  if (o->certified)
    decimals_free(c.decimals);
  return why;
}

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  enum { MOST = 2 * QUANTITIES + 5, NAME = 32 };
  static const char *const none[] = { NULL }, *const start[] = { "phase", "v0", NULL };
  const struct motion_options *o = options;
  const char *columns[MOST];
  char errors[QUANTITIES][NAME];
  int n = 0, first = (int)quantity_first(o->of), end = (int)quantity_end(o->of);
  if (o->certified && !has_flint(arguments, "--certified"))
    return EXIT_UNSOLVED;
  for (int q = first; q < end; q++)
    columns[n++] = quantity_rows[q].name;
  for (int q = first; q < end && o->error; q++) {
    snprintf(errors[q], NAME, "%s_error", quantity_rows[q].name);
    columns[n++] = errors[q];
  }
  columns[n++] = "regime";
  columns[n++] = "modes";
  if (has_words(&o->request))
    columns[n++] = "motion";
  columns[n++] = "status";
  columns[n] = NULL;
  const struct point_table table = {
    .extra = o->of == OF_PHASE ? start : none, .columns = columns, .as_written = o->certified, .row = row, .context = o
  };
  return for_each_point(&o->request, &table);
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

#define ABOUT_ROWS \
  "motion: the modes in words with their times, a column of a single answer on a terminal, and\n" \
  "elsewhere where --columns names it.\n" ABOUT_MANY_POINTS ".\n" \
  "--error: for each number an estimate of its error: what it is off by in 113 bits\n" \
  "(numerics/wide/wide.h). It is of the doubles nearest to the parameters as written; --certified takes\n" \
  "the decimals themselves.\n" \
  "--certified: the same in ball arithmetic, with --digits D digits that are proven: the last one is\n" \
  "right to a unit. The parameters are then exactly the numbers that are written (0.7 is 7/10), those\n" \
  "of a gait and a table too; of a range they are the decimals that the row prints. status is\n" \
  "certified. What touches a boundary exactly cannot be decided, which status says. A polynomial whose\n" \
  "l' changes its sign within a phase, or is not exactly 0 at its ends, is that of the doubles."

const struct command command_steady = {
  .name = "steady",
  .summary = "the periodic steady state, exactly",
  .example = "scallop steady --F1 3 --T 0.5 --gait sinusoidal",
  .options = steady_options,
  .initial = &of_steady,
  .size = sizeof(struct motion_options),
  .rules = rules,
  .is_sound = is_sound,
  .about = "Columns: the parameters; the quantities below; regime: sliding, stick-slip or at-rest; modes:\n"
           "directions of body 1 and body 2 in turn, 0 stuck, | between extension and contraction; status: ok,\n"
           "or why there is no answer.\n" ABOUT_ROWS,
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
  .about =
      "T is the period: the phase lasts alpha T (extension) or (1 - alpha) T (contraction).\n"
      "Columns: the parameters, phase and v0; the quantities below; regime: sliding, stick-slip or at-rest;\n"
      "modes: directions of body 1 and body 2 in turn, 0 stuck; status: ok, or why there is no answer.\n" ABOUT_ROWS,
  .quantities = { FIRST_OF_PHASE, QUANTITIES },
  .run = run,
};
