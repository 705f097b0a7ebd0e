#include "compare/scenes/plan_parts.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const char *plan_known_text(enum plan_known known)
{
  static const char *const text[] = { "left out", "exactly", "at most", "about", "at least" };
  return text[known];
}

/* ---- how often ---- */

/* How often something is found anew that does not depend on T, and is kept where only T changes: the runs of points with the same
 * other parameters. */
static double runs_but_T(const struct scene *s)
{
  double runs = 0;
  for (int i = 0; i < s->products; i++) {
    const struct scene_product *product = &s->product[i];
    int last = -1;
    for (int g = 0; g < product->groups; g++)
      for (int v = 0; v < product->group[g].variables; v++) {
        const struct scene_variable *variable = &product->group[g].variable[v];
        bool only_T = variable->target == TARGET_FROUDE || variable->target == TARGET_LABEL
                      || (variable->target == TARGET_NUMBER && strcmp(variable->name, "T") == 0);
        if (!only_T && variable->count > 1)
          last = g;
      }
    double product_runs = 1;
    for (int g = 0; g <= last; g++)
      product_runs *= (double)product->group[g].count;
    runs += product_runs;
  }
  return runs;
}

/* Points at which the range of an inner variable needs the onset: one for each combination of what is set further out. */
static double onsets_of_ranges(const struct scene *s)
{
  double onsets = 0;
  for (int i = 0; i < s->products; i++) {
    double outer = 1;
    for (int g = 0; g < s->product[i].groups; g++) {
      const struct scene_group *group = &s->product[i].group[g];
      bool needs = false;
      for (int v = 0; v < group->variables; v++)
        needs |= group->variable[v].needs_onset;
      if (needs) {
        onsets += outer;
        break;
      }
      outer *= (double)group->count;
    }
  }
  return onsets;
}

/* ---- stages ---- */

static struct plan_stage *stage(struct planning *p, enum count count, double work, enum plan_known known, double each,
                                const char *format, ...) __attribute__((format(printf, 6, 7)));

static struct plan_stage *stage(struct planning *p, enum count count, double work, enum plan_known known, double each,
                                const char *format, ...)
{
  struct plan_stage *s = &p->plan->stage[count];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(s->why, sizeof s->why, format, arguments);
  va_end(arguments);
  s->work = work;
  s->known = work > 0 || known == PLAN_AT_LEAST ? known : PLAN_LEFT_OUT;
  s->seconds = work * each;
  return s;
}

/* No closed form of the whole phase is at hand: the pieces are walked through. */
static bool is_walked(const struct scallop_gait *gait) { return !gait->phase[0].ramps || !gait->phase[1].ramps; }

static bool shape_is_linear(const struct scallop_shape *shape)
{
  for (int i = 0; i < shape->count; i++)
    if (!shape->pieces[i].linear)
      return false;
  return true;
}

static bool gait_is_linear(const struct scallop_gait *gait)
{
  return shape_is_linear(&gait->phase[0]) && shape_is_linear(&gait->phase[1]);
}

/* What the gaits that a scene goes through have in common */
struct gaits {
  bool linear, walked, concave; /* all have pieces in which l' is linear; some are walked through; all are concave   */
  double made;                  /* at most: one that is named twice is made once                                    */
};

static void add_gait(struct gaits *all, const struct scallop_gait *gait, bool is_used)
{
  all->made += gait != &scallop_gait_quadratic && gait != &scallop_gait_sinusoidal;
  if (!is_used)
    return;
  all->linear &= gait_is_linear(gait);
  all->walked |= is_walked(gait);
  all->concave &= gait->phase[0].concave && gait->phase[1].concave;
}

static struct gaits gaits_of(const struct scene *s)
{
  struct gaits all = { .linear = true, .concave = true };
  struct options probe = s->base;
  const struct scene_variable *variable;
  for (int i = 0; (variable = scene_variable(s, i)); i++)
    for (long k = 0; variable->target == TARGET_GAIT && k < variable->count; k++) {
      point_set(&probe.point, "gait", variable->texts[k]);
      add_gait(&all, probe.point.crawler.gait, true);
    }
  add_gait(&all, s->base.point.crawler.gait, !every_product_sets(s, TARGET_GAIT));
  return all;
}

/* Seconds, as scenes of many points took them on one core of one machine: right to a factor of ten or so elsewhere. Those of an onset
 * are those of its phases. */
static const double POINT = 4e-7, GAIT = 3e-6, STEADY_LINEAR = 2.3e-7, STEADY_CURVED = 1.1e-6, PHASE_LINEAR = 3.3e-7,
                    PHASE_CURVED = 3.4e-7, FORMULA = 1.4e-8, SUM = 4.8e-6, EXPANSION = 1.4e-3, CERTIFIED = 9e-4,
                    SAMPLE = 5e-8, ORDER = 2.8e-6, CELL = 1.2e-7, PLOT = 0.13;

static double command_seconds(const struct scene_want *w)
{
  static const struct {
    const char *what;
    double seconds;
  } all[] = { { "terms", 0.004 },  { "bounds", 0.1 },         { "breakdown", 1 },
              { "stability", 90 }, { "work-precision", 420 }, { "claims", 4 } };
  for (size_t i = 0; i < sizeof all / sizeof *all; i++)
    if (strcmp(w->what, all[i].what) == 0)
      return all[i].seconds;
  return 1;
}

static void plan_points(struct planning *p, double points)
{
  const struct scene *s = p->scene;
  char text[PLAN_WHY] = "";
  size_t used = 0;
  for (int i = 0; i < s->products && used < sizeof text; i++) {
    used += (size_t)snprintf(text + used, sizeof text - used, "%s", i > 0 ? " + " : "");
    for (int g = 0; g < s->product[i].groups && used < sizeof text; g++) {
      const struct scene_group *group = &s->product[i].group[g];
      used += (size_t)snprintf(text + used, sizeof text - used, "%s%ld", g > 0 ? " x " : "", group->count);
      for (int v = 0; v < group->variables && used < sizeof text; v++)
        used += (size_t)snprintf(text + used, sizeof text - used, "%s%s", v > 0 ? ", " : " ", group->variable[v].name);
    }
  }
  stage(p, COUNT_POINTS, points, PLAN_EXACTLY, POINT, "%s", *text ? text : "nothing varies");
}

static void plan_solutions(struct planning *p, double points, const struct gaits *gaits)
{
  const bool linear = gaits->linear, walked = gaits->walked;
  const double effort = gaits->concave ? 1 : 10; /* without the short cuts for concave gaits */
  const struct needed *n = &p->n;
  const struct scene *s = p->scene;
  bool has_commands = p->plan->stage[COUNT_COMMANDS].work > 0;
  double traced = p->plan->stage[COUNT_TRAJECTORIES].work, steady = n->steady ? points : 0;
  double phases = (n->phase ? points : 0) + (n->turnings ? points : 0), onsets = onsets_of_ranges(s);
  double solved = steady + phases;
  if (n->onset)
    onsets = fmax(onsets, runs_but_T(s));
  const char *nothing = solved == 0 && traced == 0 && !has_commands && p->plan->stage[COUNT_CERTIFIED].work == 0
                            ? "series only: no period is solved"
                            : NULL;
  stage(p, COUNT_ONSETS, onsets, PLAN_AT_MOST, 0,
        onsets > 0 ? "sticking_onset, by bisection to the last bit; not anew where only T changes"
                   : "nobody asked when bodies begin to stick");
  if (steady > 0)
    stage(p, COUNT_STEADY, steady, s->varies_v0 ? PLAN_AT_MOST : PLAN_EXACTLY, linear ? STEADY_LINEAR : STEADY_CURVED,
          "for %s; one for each point, whoever asks", n->for_steady);
  else
    stage(p, COUNT_STEADY, 0, PLAN_EXACTLY, 0, "%s", nothing ? nothing : "nothing of the steady state in doubles is wanted");
  if (phases > 0 || onsets > 0)
    stage(p, COUNT_PHASES, phases + 110 * onsets, onsets > 0 ? PLAN_ABOUT : PLAN_EXACTLY,
          linear ? PHASE_LINEAR : PHASE_CURVED, "%s%s%s%s%s", n->for_phase ? "for " : "", n->for_phase ? n->for_phase : "",
          n->turnings ? ", twice for where the body turns" : "", n->for_phase && onsets > 0 ? "; " : "",
          onsets > 0 ? "some 110 for each onset of sticking" : "");
  else
    stage(p, COUNT_PHASES, 0, PLAN_EXACTLY, 0, "%s", nothing ? nothing : "nothing of a phase alone is wanted");
  bool searched = !linear && (solved > 0 || onsets > 0);
  if (searched) {
    stage(p, COUNT_ROOT_ITERATIONS, effort * (10 * steady + 4 * phases + 400 * onsets), PLAN_ABOUT, 0,
          "l' is curved: switching times are roots");
    stage(p, COUNT_GAIT_EVALUATIONS, effort * (20 * steady + 10 * phases + 1000 * onsets), PLAN_ABOUT, 0,
          "of l' and l'' on the way to them");
  } else {
    const char *why = solved == 0 && onsets == 0
                          ? "nothing is solved in doubles"
                          : "no root finding: l' is linear in each piece, switching times are closed forms";
    struct plan_stage *iterations = stage(
        p, COUNT_ROOT_ITERATIONS, 0, PLAN_EXACTLY, 0, "%s%s", why,
        steady > 0 ? "; so is the start velocity, but where modes are neither regular nor held" : "");
    if (steady > 0)
      iterations->known = PLAN_ABOUT;
    if (walked && (solved > 0 || onsets > 0))
      stage(p, COUNT_GAIT_EVALUATIONS, 8 * steady + 4 * phases + 500 * onsets, PLAN_ABOUT, 0,
            "l' at the corners of the gait");
    else
      stage(p, COUNT_GAIT_EVALUATIONS, 0, PLAN_EXACTLY, 0, "%s", why);
  }
}

static void plan_series(struct planning *p, double points)
{
  const struct needed *n = &p->n;
  const struct scene_needs *needs = &p->plan->needs;
  double kinds = (n->steady_series ? 1 : 0) + (n->phase_series ? 1 : 0);
  long order = needs->steady_order > needs->phase_order ? needs->steady_order : needs->phase_order;
  stage(p, COUNT_FORMULAS, n->formulas * points, PLAN_EXACTLY, FORMULA, "%s",
        n->formulas > 0 ? "formulas of the paper, each once at a point" : "no formula of the paper is wanted");
  if (kinds > 0) {
    stage(p, COUNT_EXPANSIONS, kinds * runs_but_T(p->scene), PLAN_AT_MOST, EXPANSION * (1 + (double)order / 8),
          "all terms below T^%ld, not anew where only T changes", order);
    stage(p, COUNT_SUMS, n->sums * points, PLAN_EXACTLY, SUM, "their sums at each T");
  } else {
    stage(p, COUNT_EXPANSIONS, 0, PLAN_EXACTLY, 0, "no derived series is wanted");
    stage(p, COUNT_SUMS, 0, PLAN_EXACTLY, 0, "no derived series is wanted");
  }
}

static void plan_certified(struct planning *p, double points)
{
  const struct needed *n = &p->n;
  const struct scene_needs *needs = &p->plan->needs;
  double certified = (n->certified_steady ? points : 0) + (n->certified_phase ? points : 0);
  double of_errors = needs->certified_errors ? ceil(-log10(needs->accuracy) + 8) : 0,
         digits = fmax((double)needs->digits + 3, of_errors);
  if (certified > 0) {
    stage(p, COUNT_CERTIFIED, certified, PLAN_EXACTLY, CERTIFIED * (1 + digits / 400), "for %s, to %.0f digits",
          n->for_certified, digits);
    stage(p, COUNT_CERTIFIED_DIGITS, certified * digits, PLAN_EXACTLY, 0, "of all of them");
    return;
  }
  const char *why = n->errors ? "no certified arithmetic: nobody asked for errors below 1e-10 of the exact value"
                              : "no certified arithmetic: nobody asked for proven digits, or more than 17";
  stage(p, COUNT_CERTIFIED, 0, PLAN_EXACTLY, 0, "%s", why);
  stage(p, COUNT_CERTIFIED_DIGITS, 0, PLAN_EXACTLY, 0, "%s", why);
}

static void plan_outputs(struct planning *p, double points)
{
  const struct scene *s = p->scene;
  double traces = 0, samples = 0, fits = 0, runs = 0, rows = 0, cells = 0, plots = 0, seconds = 0;
  bool ends_early = false;
  for (int i = 0; i < s->wants; i++) {
    const struct scene_want *w = &s->want[i];
    double own = 0;
    plots += w->has_plot;
    if (w->kind == WANT_ROWS)
      own = points;
    else if (w->kind == WANT_TRAJECTORY) {
      double each = (double)w->periods * (double)w->samples + 1;
      ends_early |= w->until.is_formula || isfinite(w->until.number);
      traces += points;
      samples += each * points;
      own = each * points;
    } else if (w->kind == WANT_ORDERS) {
      for (int k = 0; k < s->products; k++)
        own += (double)w->series * (double)scene_product_points(&s->product[k])
               / (double)s->product[k].group[s->product[k].groups - 1].count;
      fits += own;
    } else {
      runs += points;
      seconds += points * command_seconds(w);
    }
    rows += own;
    cells += own * (w->columns > 0 ? w->columns : 10);
  }
  enum plan_known known = ends_early ? PLAN_AT_MOST : PLAN_EXACTLY;
  const char *none = "nobody asked for positions in time: no sample is computed or stored";
  stage(p, COUNT_TRAJECTORIES, traces, PLAN_EXACTLY, 0, "%s",
        traces > 0 ? "closed forms between switching times; each sample is written and forgotten" : none);
  stage(p, COUNT_SAMPLES, samples, known, SAMPLE, "%s", samples > 0 ? "periods x samples + 1 for each" : none);
  stage(p, COUNT_INTEGRATORS, 0, PLAN_EXACTLY, 0,
        "motion between switching times is known in closed form; general-purpose solvers are for work-precision and "
        "stability");
  stage(p, COUNT_ORDERS, fits, PLAN_EXACTLY, ORDER, "%s",
        fits > 0 ? "one for each series and everything but T" : "no order is wanted");
  stage(p, COUNT_COMMANDS, runs, PLAN_EXACTLY, 0, "%s",
        runs > 0 ? "at each point; what they do inside is theirs to say" : "no table of another command is wanted")
      ->seconds = seconds;
  stage(p, COUNT_ROWS, rows, known, 0, "%s",
        runs > 0 ? "but for those of commands" : "written as they are found: memory does not grow")
      ->seconds = cells * CELL;
  stage(p, COUNT_PLOTS, plots, PLAN_AT_MOST, PLOT, "%s", plots > 0 ? "by gnuplot" : "no plot is wanted");
}

/* What commands do inside is not known before. */
static void leave_open(struct plan *plan)
{
  static const enum count theirs[] = {
    COUNT_GAITS,        COUNT_STEADY,     COUNT_PHASES,      COUNT_ROOT_ITERATIONS, COUNT_GAIT_EVALUATIONS,
    COUNT_FORMULAS,     COUNT_EXPANSIONS, COUNT_SUMS,        COUNT_CERTIFIED,       COUNT_CERTIFIED_DIGITS,
    COUNT_TRAJECTORIES, COUNT_SAMPLES,    COUNT_INTEGRATORS, COUNT_ORDERS
  };
  for (size_t i = 0; i < sizeof theirs / sizeof *theirs; i++) {
    struct plan_stage *s = &plan->stage[theirs[i]];
    s->known = PLAN_AT_LEAST;
    if (s->work == 0)
      snprintf(s->why, sizeof s->why, "none but what commands do");
  }
}

void plan_make(struct plan *plan, const struct scene *scene)
{
  struct planning p = { .scene = scene, .plan = plan };
  double points = (double)scene_points(scene);
  *plan = (struct plan){ .needs_flint = false };
  plan_needs(&p);
  const struct gaits gaits = gaits_of(scene);
  plan_points(&p, points);
  stage(&p, COUNT_GAITS, gaits.made, PLAN_AT_MOST, GAIT, "%s",
        gaits.made > 0 ? "when the scene is read, each once" : "the quadratic and the sinusoidal gait are built in");
  plan_outputs(&p, points);
  plan_certified(&p, points);
  plan_solutions(&p, points, &gaits);
  plan_series(&p, points);
  plan->needs_flint = plan->stage[COUNT_CERTIFIED].work > 0 || plan->stage[COUNT_EXPANSIONS].work > 0
                      || plan->stage[COUNT_COMMANDS].work > 0;
  if (plan->stage[COUNT_COMMANDS].work > 0)
    leave_open(plan);
}
