/* Table of `scallop workprec`: a row for each setting and quantity. */
#include "compare/workprec/table.h"

#include <assert.h>
#include <math.h>

#include "compare/points/defaults.h"
#include "compare/answers/request.h"
#include "compare/workprec/setting.h"

enum { MAX_REFERENCES = 40 };

static const char *const columns[] = { "method",   "kind",        "setting",          "gait",     "T",
                                       "quantity", "error",       "time_median",      "time_min", "time_q1",
                                       "time_q3",  "repetitions", "gait_evaluations", "events",   "root_iterations",
                                       "periods",  "pareto",      "status",           NULL };

static const char *const kind_words[] = {
  [METHOD_FORMULA] = "formula", [METHOD_EXACT] = "exact", [METHOD_ROOT] = "root", [METHOD_SIMULATION] = "simulation"
};

struct workprec_output {
  const struct workprec_options *options;
  struct reference references[MAX_REFERENCES];
  int count;
  double limit;
  struct stopwatch_clock clock;
  struct settings settings; /* of the current reference */
  struct table table;
};

/* Solves all references before anything is written. */
static bool make_references(struct workprec_output *r)
{
  static const double all[] = { WORKPREC_T }, few[] = { WORKPREC_QUICK_T };
  const struct point *p = &r->options->request.point;
  bool one = p->written[5] != NULL, quick = r->options->quick; /* T */
  const double *T = one ? &p->crawler.T : quick ? few : all;
  int times = (int)(one ? 1 : quick ? sizeof few / sizeof *few : sizeof all / sizeof *all);
  struct scallop_crawler c = p->crawler;
  for (int g = 0; p->has_gait ? g == 0 : scallop_gait_name(g) != NULL; g++)
    for (int i = 0; i < times; i++) {
      c.gait = p->has_gait ? p->crawler.gait : scallop_gait_named(scallop_gait_name(g));
      c.T = T[i];
      assert(r->count < MAX_REFERENCES);
      const char *why = reference_init(&r->references[r->count++], &c);
      if (!why)
        continue;
      complain("workprec", "no certified steady state to compare with for the %s gait and T = %.17g: %s", c.gait->name,
               c.T, why);
      return false;
    }
  return true;
}

static double do_nothing(void *context) { return *(const double *)context; }

/* Measures the time that a batch adds to each solve: the loop and a call. */
static double call_cost(const struct stopwatch_clock *clock)
{
  double samples[SETTING_SAMPLES], zero = 0;
  long passes = stopwatch_passes(do_nothing, &zero, stopwatch_long_enough(clock));
  for (int i = 0; i < SETTING_SAMPLES; i++)
    samples[i] = stopwatch_batch(do_nothing, &zero, passes) / (double)passes;
  return stopwatch_spread(samples, SETTING_SAMPLES).median;
}

static bool begin(struct workprec_output *r)
{
  const struct workprec_options *o = r->options;
  static const char *const columns_of_points[] = { "T", "gait", NULL };
  struct table *t = &r->table;
  if (!table_head(t, &o->request.style, "workprec%s --limit %g", o->quick ? " --quick" : "", r->limit))
    return false;
  note_parameters(t, &o->request.point, columns_of_points, false);
  table_note(t, "error: |answer - certified| / |certified|, for these very doubles; over L/T or L where the certified "
                "value is 0");
  table_note(t, "times: seconds for one solve, by the wall clock of one machine: only ratios within one table mean "
                "anything");
  table_note(t,
             "clock: a reading takes %.2g s, the smallest step is %.2g s; shortest batch %.2g s; an empty call %.2g s",
             r->clock.cost, r->clock.step, stopwatch_long_enough(&r->clock), call_cost(&r->clock));
  table_columns(t, columns);
  table_begin_rows(t);
  return true;
}

static void write_setting(struct table *t, const struct setting *s, int quantity)
{
  const struct stopwatch_spread *time = &s->time;
  const struct setting_answer *a = &s->answer;
  table_text(t, s->method);
  table_text(t, kind_words[s->kind]);
  table_text(t, s->text);
  table_text(t, s->reference->crawler.gait->name);
  table_number(t, s->reference->crawler.T);
  table_text(t, quantity_rows[compared[quantity]].name);
  if (isnan(s->error_log10[quantity]))
    table_number(t, NAN);
  else
    table_digits(t, s->error[quantity]);
  for (int i = 0; i < 4; i++)
    table_rounded(t, (const double[]){ time->median, time->least, time->q1, time->q3 }[i], "%.4g");
  table_rounded(t, time->repetitions, "%.0f");
  for (int i = 0; i < 4; i++)
    table_number(t, (const double[]){ a->gait_evaluations, a->events, a->root_iterations, a->periods }[i]);
  table_text(t, !s->solved ? "-" : s->front[quantity] ? "yes" : "no");
  table_text(t, s->status);
}

static void measure(struct workprec_output *r, int reference)
{
  struct settings *all = &r->settings;
  methods_add(all, &r->references[reference], r->options->quick);
  all->turn = reference;
  all->turns = r->count;
  settings_measure(all, &r->clock, r->limit);
  for (const struct setting *s = all->list; s < all->list + all->count; s++)
    for (int quantity = 0; quantity < COMPARED; quantity++)
      if (setting_has(s, quantity))
        write_setting(&r->table, s, quantity);
  settings_clear(all);
}

enum exit_code workprec_table(const struct workprec_options *options)
{
  struct workprec_output r = { .options = options,
                               .limit = options->limit.value > 0 ? options->limit.value
                                        : options->quick         ? WORKPREC_QUICK_LIMIT
                                                                 : WORKPREC_LIMIT };
  enum exit_code code = EXIT_UNSOLVED;
  if (!methods_have_formulas(options->request.formulas))
    return EXIT_USAGE;
  if (make_references(&r)) {
    r.clock = stopwatch_clock();
    bool open = begin(&r);
    for (int i = 0; i < r.count && open; i++)
      measure(&r, i);
    progress_end();
    code = open && table_close(&r.table) ? EXIT_DONE : EXIT_FILE;
  }
  for (int i = 0; i < r.count; i++)
    reference_clear(&r.references[i]);
  return code;
}
