/* steady and phase: the quantities of one motion, a row for each point. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/answers/answer.h"
#include "compare/answers/points.h"
#include "compare/answers/defaults.h"
#include "compare/command/commands.h"
#include "compare/command/with_flint.h"

struct motion_options {
  struct request request;
  bool certified, error;
};

#define DIGITS DIGITS_PROVEN("with --certified")
#define OPTIONS_OF_ROWS \
  OPTION_FLAG("certified", "in ball arithmetic: every digit printed is proven", motion_options, certified), \
      OPTION_FLAG("error", "after each number an estimate of its error", motion_options, error), OPTION_POINTS, \
      OPTION_FORMAT("tsv"), OPTION_DIGITS(DIGITS, READ_BACK "; with --certified " TEXT_OF(CERTIFIED_DIGITS), MOST_DIGITS), \
      OPTIONS_LAST

static const struct option steady_options[] = { OPTIONS_CRAWLER(NULL, NULL), OPTIONS_OF_ROWS };
static const struct option phase_options[] = { OPTIONS_CRAWLER(NULL, NULL), OPTION_PHASE(NULL), OPTION_V0(NULL),
                                               OPTIONS_OF_ROWS };

/* What a row is made with. */
struct asked {
  enum quantity_of of;
  const struct motion_options *options;
};

/* A row of any arithmetic: the cells of the numbers, and why there are none. */
struct cells {
  struct answer answer;
  char *decimals[QUANTITIES]; /* of --certified */
  double errors[QUANTITIES];  /* of --error */
  const char *why;            /* NULL: solved */
  char reason[POINT_STATUS];
};

static void solve(struct cells *c, const struct asked *asked, const struct point *p)
{
  const struct motion_options *o = asked->options;
  const struct motion motion = motion_of(p, asked->of);
  const char *more = NULL;
  long digits = o->request.style.digits > 0 ? o->request.style.digits : CERTIFIED_DIGITS;
  bool done = o->certified ? answer_in_decimals(&c->answer, c->decimals, p, motion.of, digits, &more)
              : o->error   ? answer_with_errors(&c->answer, &motion, c->errors)
                           : answer_in_double(&c->answer, &motion);
  c->why = done ? NULL : c->reason;
  if (!done)
    snprintf(c->reason, sizeof c->reason, "%s%s%s", scallop_status_text(c->answer.status), more ? ": " : "",
             more ? more : "");
}

/* Digits with an exponent at most: what every reader takes for a number */
static bool is_plain(const char *text)
{
  size_t whole = strspn(text, "0123456789");
  const char *rest = text + whole;
  if (whole == 0 || (whole > 1 && *text == '0'))
    return false;
  if (*rest == '.')
    rest += 1 + strspn(rest + 1, "0123456789");
  return rest[-1] != '.' && (*rest == '\0' || *rest == 'e' || *rest == 'E');
}

/* With --certified as it was written: a double would not hold all digits. */
static void write_parameter(struct table *t, bool certified, const char *written, double value)
{
  char text[NUMBER_TEXT];
  if (!certified) {
    table_number(t, value);
    return;
  }
  number_text(text, value, 0);
  if (written && !is_plain(written) && t->style->format == FORMAT_JSON)
    table_text(t, written);
  else
    table_digits(t, written ? written : text);
}

/* refused: as in points.h */
static void write_point(struct table *t, const struct asked *asked, const struct point *p, const char *refused)
{
  double numbers[CRAWLER_NUMBERS];
  bool certified = asked->options->certified;
  crawler_numbers(&p->crawler, numbers);
  if (refused)
    point_crawler(t, &p->crawler, refused);
  else {
    for (int i = 0; i < CRAWLER_NUMBERS; i++)
      write_parameter(t, certified, p->written[i], numbers[i]);
    table_text(t, p->crawler.gait->name);
  }
  if (asked->of != OF_PHASE)
    return;
  table_text(t, refused ? "-" : p->phase == SCALLOP_EXTENSION ? "extension" : "contraction");
  if (refused)
    table_number(t, NAN);
  else
    write_parameter(t, certified, p->written_v0, p->v0);
}

static void write_numbers(struct table *t, const struct asked *asked, const struct cells *c)
{
  const struct motion_options *o = asked->options;
  static const double rounded_up = 1.005; /* of an estimate, with three digits */
  int first = (int)quantity_first(asked->of), end = (int)quantity_end(asked->of);
  for (int q = first; q < end; q++)
    if (c->decimals[q])
      table_digits(t, c->decimals[q]);
    else
      table_number(t, c->why || o->certified ? NAN : c->answer.value[q].high);
  for (int q = first; q < end && o->error; q++)
    if (c->why)
      table_number(t, NAN);
    else
      table_rounded(t, rounded_up * c->errors[q], "%.3g");
}

static const char *row(struct table *t, const struct point *p, const void *context, const char *refused)
{
  static struct cells c; /* its reason outlives the call */
  const struct asked *asked = context;
  bool certified = asked->options->certified;
  char modes[MOTION_MODES_TEXT], status[ANSWER_STATUS];
  memset(c.decimals, 0, sizeof c.decimals);
  c.why = refused;
  if (!refused)
    solve(&c, asked, p);
  write_point(t, asked, p, refused);
  write_numbers(t, asked, &c);
  table_text(t, c.why ? "-" : scallop_regime_text(c.answer.regime));
  table_text(t, c.why ? "-" : motion_modes_text(modes, asked->of, c.answer.modes));
  table_text(t, c.why ? c.why : certified ? "certified" : answer_status_text(status, &c.answer));
  if (certified)
    decimals_free(c.decimals);
  return c.why;
}

static enum exit_code run(const struct arguments *arguments, const struct motion_options *o, enum quantity_of of)
{
  enum { MOST = 2 * QUANTITIES + 4, NAME = 32 };
  static const char *const none[] = { NULL }, *const start[] = { "phase", "v0", NULL };
  const char *columns[MOST];
  char errors[QUANTITIES][NAME];
  const struct asked asked = { of, o };
  int n = 0, first = (int)quantity_first(of), end = (int)quantity_end(of);
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
  columns[n++] = "status";
  columns[n] = NULL;
  const struct point_table table = {
    .extra = of == OF_PHASE ? start : none, .columns = columns, .row = row, .context = &asked
  };
  return for_each_point(&o->request, &table);
}

static enum exit_code run_steady(const struct arguments *arguments, const void *options)
{
  return run(arguments, options, OF_STEADY);
}

static enum exit_code run_phase(const struct arguments *arguments, const void *options)
{
  return run(arguments, options, OF_PHASE);
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

static const enum quantity_of of_steady = OF_STEADY, of_phase = OF_PHASE;

#define ABOUT_ARITHMETICS \
  "--error: for each number an estimate of its error: what it is off by in 113 bits (numerics/wide.h). It is of the " \
  "doubles\n" \
  "nearest to the parameters as written; --certified takes the decimals themselves.\n" \
  "--certified: the same in ball arithmetic, with --digits D digits that are proven: the last one is right to a\n" \
  "unit. The parameters are then exactly the numbers that are written (0.7 is 7/10), those of a gait and a table too,\n" \
  "and status is certified. What touches a boundary exactly cannot be decided, which status says. A polynomial\n" \
  "whose l' changes its sign within a phase, or is not exactly 0 at its ends, is that of the doubles."

const struct command command_steady = {
  .name = "steady",
  .summary = "the periodic steady state, exactly",
  .example = "scallop steady --F1 3 --T 0.5 --gait sinusoidal",
  .options = steady_options,
  .size = sizeof(struct motion_options),
  .rules = rules,
  .is_sound = is_sound,
  .about =
      "Columns: the parameters; the quantities below; regime: sliding, stick-slip or at-rest; modes: directions of body 1\n"
      "and body 2 in turn, 0 stuck, | between extension and contraction; status: ok, or why there is no "
      "answer.\n" ABOUT_ARITHMETICS,
  .quantities = &of_steady,
  .run = run_steady,
};

const struct command command_phase = {
  .name = "phase",
  .summary = "one extension or contraction phase from a start velocity, exactly",
  .example = "scallop phase --phase extension --v0 2.5",
  .options = phase_options,
  .size = sizeof(struct motion_options),
  .rules = rules,
  .is_sound = is_sound,
  .about = "T is the period: the phase lasts alpha T (extension) or (1 - alpha) T (contraction).\n"
           "Columns: the parameters, phase and v0; the quantities below; regime: sliding, stick-slip or at-rest; modes:\n"
           "directions of body 1 and body 2 in turn, 0 stuck; status: ok, or why there is no answer.\n" ABOUT_ARITHMETICS,
  .quantities = &of_phase,
  .run = run_phase,
};
