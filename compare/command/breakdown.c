#include <stdio.h>
#include <string.h>

#include "compare/answers/flint.h"
#include "compare/answers/vary.h"
#include "compare/breakdown/breakdown.h"
#include "compare/command/commands.h"

#define RANGE "0.01:100:41:log"
#define RANGE_OF_ALPHA "0.01:0.99:41:linear"
/* What an axis may be, as maps and as scenes call it, and what varies where nothing is said */
static const struct {
  const char *name, *variable, *range;
} axes[] = { { "F1/F2", "F1_over_F2", RANGE },
             { "m1/m2", "m1_over_m2", RANGE },
             { "alpha", "alpha", RANGE_OF_ALPHA },
             { "T", "T", RANGE },
             { "froude", "froude", RANGE } };
enum { AXES = sizeof axes / sizeof *axes };
static const char *const sources[] = { "book", "published", "derived", "limit", NULL };
static const char *const quantities[] = { "v_start", "v_mid", "displacement", "mean_velocity", "t1", "dT",
                                          "v_end",   "dx1",   "dx2",          "dxC",           NULL };
static const char *const kinds[] = { "event", "reversal", "reach", "radius", "best", NULL };
static const struct option options_of_breakdown[] = {
  OPTIONS_TO_L,
  OPTIONS_ALPHA_GAIT,
  OPTIONS_PHASE,
  OPTION_WORD("source", breakdown_options, source, sources),
  OPTION_BOOK,
  OPTION_COUNT("order", breakdown_options, order, 1, 1000),
  OPTION_WORD("quantity", breakdown_options, quantity, quantities),
  OPTION_NUMBER("tol", breakdown_options, tolerance,
                FROM_TO(1e-20, DBL_MAX, "a number from 1e-20 on")), /* errors are known to some 1e-32 */
  OPTION_FLAG("all", breakdown_options, all),
  OPTION_WORD("only", breakdown_options, only, kinds),
  OPTION("map", read_text, OPTION_FIELD(breakdown_options, map), .values = 2, .allowed = "the name of what varies"),
  OPTION_TEXT("x", breakdown_options, range[0], "FROM:TO:COUNT"),
  OPTION_TEXT("y", breakdown_options, range[1], "FROM:TO:COUNT"),
  OPTION_T,
  OPTION_FLAG("boundaries", breakdown_options, boundaries),
  OPTIONS_PLOT,
  OPTIONS_OF_DOUBLES,
};
#define NARROWS "all only quantity source order tol phase v0 format columns plot"
static const struct option_rule rules[] = {
  { "all only phase v0", RULE_WITH, "map", NULL },
  { "x y boundaries T", RULE_WITHOUT, "map", NULL },
  { "source order quantity tol book", RULE_WITH, "boundaries", NULL },
  { "quantity=v_start quantity=v_mid quantity=displacement quantity=mean_velocity", RULE_WITH, "phase v0",
    "is of the steady state: a phase has t1, dT, v_end, dx1, dx2 and dxC" },
  { "quantity=t1 quantity=dT quantity=v_end quantity=dx1 quantity=dx2 quantity=dxC", RULE_WITHOUT, "phase v0",
    "is of a phase: it needs --phase or --v0" },
  { "order", RULE_WITH, "source=book source=published source=limit",
    "needs the derived series: leave --source out, or --source derived" },
  { "tol book", RULE_WITH, "only=event only=reversal only=radius only=best", "needs the rows of --only reach" },
  { "quantity source order", RULE_WITH, "only=event only=reversal", "needs rows about series: leave --only out" },
  { "order source=book source=published source=limit", RULE_WITH, "only=radius only=best",
    "needs the rows of --only reach" },
  { "book", RULE_WITH, "source=published source=derived source=limit",
    "needs its own series: leave --source out, or --source book" },
  { "source=book", RULE_WITHOUT, "book", "book needs --book FILE" },
  { NULL, RULE_WITH, NULL, NULL }
};
static const struct breakdown_options initial = { .source = { "published", false },
                                                  .quantity = { "displacement", false },
                                                  .order = { 8, false },
                                                  .tolerance = { 0.1, false } };

static char message[400];

/* NULL, or what is wrong with the range of an axis, which is then a group of what varies */
static const char *add_axis(struct breakdown_options *o, int i, int axis)
{
  char range[200];
  const char *given = o->range[i] ? o->range[i] : axes[axis].range;
  int colons = 0;
  for (const char *c = given; *c; c++)
    colons += *c == ':';
  bool is_log = colons < 3 && strcmp(axes[axis].name, "alpha") != 0; /* unless it is said */
  snprintf(range, sizeof range, "%s%s", given, is_log ? ":log" : "");
  const char *wrong = colons < 2 ? "it takes FROM:TO:COUNT, FROM:TO:COUNT:log or FROM:TO:COUNT:linear"
                                 : vary_text(&o->request, axes[axis].variable, range);
  if (!wrong)
    return NULL;
  snprintf(message, sizeof message, "--%s: %.300s", o->range[i] ? i == 0 ? "x" : "y" : "map", wrong);
  return message;
}

/* NULL, or the message where an option sets what an axis sets */
static const char *set_by_option(const struct breakdown_options *o, int i, int axis)
{
  struct sweep_variable v;
  sweep_variable_of_name(&v, axes[axis].variable);
  snprintf(message, sizeof message, "--%s has nothing to do with --map %s %s, where %s sets it", v.sets, o->map[0],
           o->map[1], o->map[i]);
  return o->request.point.written[crawler_place(v.sets)] ? message : NULL;
}

/* The axes are what varies, x fastest. */
static const char *vary_axes(void *options)
{
  struct breakdown_options *o = options;
  const char *names[AXES + 1] = { NULL }, *wrong = NULL;
  int axis[2];
  for (int i = 0; i < AXES; i++)
    names[i] = axes[i].name;
  for (int i = 0; o->map[0] && i < 2; i++) {
    axis[i] = 0;
    while (axis[i] < AXES && strcmp(o->map[i], axes[axis[i]].name) != 0
           && strcmp(o->map[i], axes[axis[i]].variable) != 0)
      axis[i]++;
    if (axis[i] == AXES) {
      snprintf(message, sizeof message,
               "--map: '%.80s' is not allowed here: it takes F1/F2, m1/m2, alpha, T or froude%s", o->map[i],
               did_you_mean(nearest(o->map[i], names)));
      return message;
    }
    o->map[i] = axes[axis[i]].name;
  }
  if (o->map[0] && axis[0] == axis[1])
    return "--map: a map needs two different axes";
  for (int i = 0; o->map[0] && i < 2 && !wrong; i++)
    wrong = set_by_option(o, i, axis[i]);
  for (int i = 1; o->map[0] && i >= 0 && !wrong; i--)
    wrong = add_axis(o, i, axis[i]);
  if (!wrong && o->map[0] && sweep_set_twice(o->request.sweep.product))
    return "--map: T and froude set the same; a map needs two that can vary apart";
  return wrong;
}

static bool has_rows(const void *options)
{
  const struct breakdown_options *o = options;
  return o->map[0] && !o->boundaries;
}

static const char *plan(const void *options, struct rows *rows)
{
  const struct flint_part *flint = flint_for("breakdown", "this command");
  return flint ? flint->breakdown_map(options, rows) : "";
}

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  const struct breakdown_options *o = options;
  const struct flint_part *flint = flint_for("breakdown", "this command");
  if (!flint)
    return EXIT_UNSOLVED;
  if (o->boundaries)
    return flint->breakdown_boundaries(o);
  return given_option(arguments, NARROWS) ? flint->breakdown_table(o) : flint->summary_of_breakdown(&o->request);
}

const struct command command_breakdown = {
  .name = "breakdown",
  .options = options_of_breakdown,
  .rules = rules,
  .size = sizeof(struct breakdown_options),
  .initial = &initial,
  .complete = vary_axes,
  .plan = plan,
  .has_rows = has_rows,
  .run = run,
};
