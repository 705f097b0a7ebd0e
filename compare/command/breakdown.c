/* Options of `scallop breakdown`: table, page, map and boundaries. */
#include <stdio.h>
#include <string.h>

#include "compare/answers/flint.h"
#include "compare/answers/vary.h"
#include "compare/breakdown/breakdown.h"
#include "compare/command/commands.h"

/* Axes of maps: name in --map, variable of a sweep, default range */
static const struct axis_choice {
  const char *name, *variable, *range;
} axes[] = { { "F1/F2", "F1_over_F2", "0.01:100:41" },    { "m1/m2", "m1_over_m2", "0.01:100:41" },
             { "alpha", "alpha", "0.01:0.99:41:linear" }, { "T", "T", "0.01:100:41" },
             { "froude", "froude", "0.01:100:41" },       { NULL } };
#define MAP_AXES "F1/F2, m1/m2, alpha, T or froude"
static const char *const sources[] = { "user", "published", "derived", "limit", NULL };
static const char *const quantities[] = { "v_start", "v_mid", "displacement", "mean_velocity", "t1", "dT",
                                          "v_end",   "dx1",   "dx2",          "dxC",           NULL };
static const char *const kinds[] = { "transition", "reversal", "reach", "radius", "best", NULL };
static const struct option options_of_breakdown[] = {
  OPTIONS_TO_L,
  OPTIONS_ALPHA_GAIT,
  OPTIONS_PHASE,
  OPTION_WORD("source", breakdown_options, source, sources),
  OPTION_FORMULAS,
  OPTION_COUNT("order", breakdown_options, order, 1, 1000),
  OPTION_WORD("quantity", breakdown_options, quantity, quantities),
  OPTION_NUMBER("tol", breakdown_options, tolerance,
                FROM_TO(1e-20, DBL_MAX, "a number from 1e-20 on")), /* errors are known to some 1e-32 */
  OPTION_FLAG("all", breakdown_options, all),
  OPTION_WORD("only", breakdown_options, only, kinds),
  OPTION("map", read_text, OPTION_FIELD(breakdown_options, map), .values = 2, .allowed = MAP_AXES),
  OPTION_TEXT("x", breakdown_options, range[0], "FROM:TO:COUNT"),
  OPTION_TEXT("y", breakdown_options, range[1], "FROM:TO:COUNT"),
  OPTION_POINT("T"),
  OPTION_FLAG("boundaries", breakdown_options, boundaries),
  OPTIONS_PLOT,
  OPTIONS_OF_DOUBLES,
};
static const struct option_rule rules[] = {
  { "all only phase v0", RULE_WITH, "map", NULL },
  { "x y boundaries T", RULE_WITHOUT, "map", NULL },
  { "source order quantity tol formulas", RULE_WITH, "boundaries", NULL },
  { "quantity=v_start quantity=v_mid quantity=displacement quantity=mean_velocity", RULE_WITH, "phase v0",
    "is of the steady state: a phase has t1, dT, v_end, dx1, dx2 and dxC" },
  { "quantity=t1 quantity=dT quantity=v_end quantity=dx1 quantity=dx2 quantity=dxC", RULE_WITHOUT, "phase v0",
    "is of a phase: it needs --phase or --v0" },
  { "order", RULE_WITH, "source=user source=published source=limit",
    "needs the derived series: leave --source out, or --source derived" },
  { "tol formulas", RULE_WITH, "only=transition only=reversal only=radius only=best",
    "needs the rows of --only reach" },
  { "quantity source order", RULE_WITH, "only=transition only=reversal", "needs rows about series: leave --only out" },
  { "order source=user source=published source=limit", RULE_WITH, "only=radius only=best",
    "needs the rows of --only reach" },
  { "formulas", RULE_WITH, "source=published source=derived source=limit",
    "needs its own series: leave --source out, or --source user" },
  { "source=user", RULE_WITHOUT, "formulas", "user needs --formulas FILE" },
  { NULL, RULE_WITH, NULL, NULL }
};
static const struct breakdown_options initial = { .source = { "published", false },
                                                  .quantity = { "displacement", false },
                                                  .order = { 8, false },
                                                  .tolerance = { 0.1, false } };

/* Adds the group of an axis to the sweep, by default with :log except for alpha. Returns NULL, or an error. */
static const char *add_axis(struct breakdown_options *o, int i)
{
  const struct axis_choice *axis = axes;
  const char *name = o->map[i];
  struct sweep_variable v;
  int colons = 0;
  while (axis->name && strcmp(name, axis->name) != 0 && strcmp(name, axis->variable) != 0)
    axis++;
  if (!axis->name)
    return wrong_text("--map: '%.80s' is not allowed here: it takes " MAP_AXES "%s", name,
                      did_you_mean(nearest_in(name, axes, sizeof *axes)));
  const char *range = o->range[i] ? o->range[i] : axis->range, *option = i == 0 ? "x" : "y";
  o->map[i] = axis->name;
  sweep_variable_of_name(&v, axis->variable);
  if (o->request.point.written[crawler_place(v.sets)])
    return wrong_text("--%s has nothing to do with --map, where %s sets it", v.sets, axis->name);
  for (const char *c = range; *c; c++)
    colons += *c == ':';
  if (colons < 2)
    return wrong_text("--%s: it takes FROM:TO:COUNT, FROM:TO:COUNT:log or FROM:TO:COUNT:linear", option);
  bool is_log = colons == 2 && strcmp(axis->name, "alpha") != 0;
  const char *wrong = vary_text(&o->request, axis->variable, wrong_text("%s%s", range, is_log ? ":log" : ""));
  return wrong ? wrong_text("--%s: %s", o->range[i] ? option : "map", wrong) : NULL;
}

/* Returns true for the page about transitions and reach. A scene sets a format, hence it has no page. */
static bool is_page(const struct breakdown_options *o)
{
  const struct request *r = &o->request;
  bool narrows = o->all || o->map[0] || o->only.given || o->quantity.given || o->source.given || o->order.given
                 || o->tolerance.given || r->point.has_phase || r->point.has_v0;
  return !narrows && !r->style.has_format && !r->style.choice && !r->style.plot.file;
}

/* Adds the axes to the sweep, x fastest; sets the format of a page. */
static const char *complete(void *options)
{
  struct breakdown_options *o = options;
  if (is_page(o))
    o->request.style.format = FORMAT_TABLE;
  if (!o->map[0])
    return NULL;
  struct plot *plot = &o->request.style.plot;
  if (plot->file && !plot->y && !o->boundaries) /* three regimes, but many sequences of modes */
    plot->y = "regime";
  const char *wrong = add_axis(o, 1);
  wrong = wrong ? wrong : add_axis(o, 0);
  if (!wrong && (o->request.sweep.product->groups != 2 || sweep_set_twice(o->request.sweep.product)))
    return "--map: a map needs two different axes that can vary apart: T and froude set the same";
  return wrong;
}

static bool has_rows(const void *options)
{
  const struct breakdown_options *o = options;
  return (is_page(o) && o->request.sweep.products == 0) || (o->map[0] && !o->boundaries);
}

static const char *plan(const void *options, struct rows *rows)
{
  const struct flint_part *flint = load_flint("breakdown", "this command");
  return !flint ? "" : is_page(options) ? flint->breakdown_page(rows) : flint->breakdown_map(options, rows);
}

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  const struct breakdown_options *o = options;
  const struct flint_part *flint = load_flint("breakdown", "this command");
  (void)arguments;
  if (!flint)
    return EXIT_UNSOLVED;
  return o->boundaries ? flint->breakdown_boundaries(o) : flint->breakdown_table(o);
}

const struct command command_breakdown = {
  .name = "breakdown",
  .options = options_of_breakdown,
  .rules = rules,
  .size = sizeof(struct breakdown_options),
  .initial = &initial,
  .complete = complete,
  .plan = plan,
  .has_rows = has_rows,
  .run = run,
};
