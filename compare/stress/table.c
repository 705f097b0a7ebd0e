/* The tables of `stress`: a row for each family of cases, or for each number of a single point. */
#include "compare/stress/table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

#include "compare/answers/defaults.h"
#include "compare/stress/judge.h"
#include "compare/text/progress.h"
#include "model/flint.h"
#include "numerics/threads.h"

/* In the order in which the cells are written. */
static const char *const family_columns[] = { "family",    "gait",        "cases",    "refused",
                                              "undecided", "other_modes", "quantity", NULL };
static const char *const point_columns[] = { "quantity", "value", "certified", NULL };
static const char *const error_columns[] = { "units", "ulp", "condition", "digits", NULL };
static const char *const median_column[] = { "ulp_median", NULL };
static const char *const spread_columns[] = { "rounding",         "perturbed",      "lost_double",
                                              "lost_long_double", "lost_binary128", NULL };
static const char *const family_end[] = { "estimate_least", "estimate_most", "verdict", "worst_at", NULL };
static const char *const point_end[] = { "estimate", "verdict", NULL };

/* Of a trajectory: a case takes as long as so many periods do. */
enum { TRAJECTORIES = 4, PERIODS = 1000000, CHECK_PERIODS = 10000, FULL_PERIODS = 10000000 };

/* Of each family of a kind. A check of all gaits takes a few seconds: a phase is judged in less time than a steady state. */
static int cases_of(const struct stress_options *o, enum stress_kind kind)
{
  static const int check[] = {
    [STRESS_STEADY] = STRESS_CHECK_STEADY, [STRESS_PHASE] = STRESS_CHECK_PHASES, [STRESS_TRAJECTORY] = 2
  };
  int cases = o->cases.value > 0 ? (int)o->cases.value : o->full ? STRESS_FULL_CASES : o->check ? check[kind] : STRESS_CASES;
  return kind == STRESS_TRAJECTORY && cases > TRAJECTORIES ? TRAJECTORIES : cases;
}

static double over(double error, double unit) { return error == 0 ? 0 : error / unit; }

static double digits_kept(double error, double value)
{
  double most = 53 * log10(2);
  if (value == 0 || isnan(value))
    return NAN;
  return error == 0 ? most : fmin(most, fmax(0, -log10(error / fabs(value))));
}

/* Decimal digits of a type that the error takes away: its ulp is 2^(53 - bits) of a double's */
static double digits_lost(double error, double ulp, int bits)
{
  double ulps = ldexp(over(error, ulp), bits - 53);
  if (ulp == 0 || bits == 0)
    return NAN;
  return ulps > 1 ? log10(ulps) : 0;
}

/* What the columns from rounding to lost_binary128 hold: of one number, or the largest of many. In units, and in digits. */
enum { ROUNDING, PERTURBED, LOST, SPREADS = LOST + 3 };

static void find_spreads(const struct stress_number *n, double spread[SPREADS])
{
  spread[ROUNDING] = over(n->rounding, n->unit);
  spread[PERTURBED] = over(n->perturbed, n->unit);
  spread[LOST] = digits_lost(n->error, n->ulp, 53);
  for (int w = 0; w < 2; w++)
    spread[LOST + 1 + w] = digits_lost(n->wide_error[w], n->ulp, scallop_width_bits((enum scallop_width)w));
}

/* A row of the table of families */
struct row {
  const struct stress_family *family;
  const struct scallop_gait *gait;
  int cases, refused, undecided, other_modes, broken;
  int worst, quantity; /* where error/unit is largest: the case, or -1, and which of its numbers */
  double units;        /* there                                                                  */
  double median;       /* of errors in ulp over all numbers                                      */
  double spread[SPREADS], estimate_least, estimate_most;
  const char *what; /* is broken, first of all; NULL: nothing */
};

/* Estimates over errors; an error below the 128th part of an ulp counts as that. */
static void add_estimate(struct row *r, const struct stress_number *n)
{
  double least = 0x1p-7 * n->ulp, generous = over(n->estimate, fmax(n->error, least));
  if (!(n->ulp > 0))
    return;
  if (n->error > 0 && n->error >= least)
    r->estimate_least = fmin(r->estimate_least, generous);
  r->estimate_most = fmax(r->estimate_most, generous);
}

static void add_number(struct row *r, const struct stress_judgement *j, int i, int q)
{
  const struct stress_number *n = &j->number[q];
  double units = over(n->error, n->unit), spread[SPREADS];
  if (r->worst < 0 || units > r->units) {
    r->units = units;
    r->worst = i;
    r->quantity = q;
  }
  if (j->only_error)
    return;
  find_spreads(n, spread);
  for (int k = 0; k < SPREADS; k++)
    r->spread[k] = fmax(r->spread[k], spread[k]);
  add_estimate(r, n);
}

/* errors: room for STRESS_QUANTITIES * r->cases numbers */
static void sum_up(struct row *r, const struct stress_judgement *judgements, double *errors)
{
  int count = 0;
  r->worst = -1;
  r->estimate_least = INFINITY;
  for (int i = 0; i < r->cases; i++) {
    const struct stress_judgement *j = &judgements[i];
    r->refused += j->outcome == STRESS_REFUSED;
    r->undecided += j->outcome == STRESS_UNDECIDED;
    r->other_modes += j->other_modes;
    for (int q = 0; q < STRESS_QUANTITIES; q++) {
      const char *what = stress_broken(j, q);
      r->broken += what != NULL;
      r->what = r->what ? r->what : what;
      if (!stress_is_judged(j, q))
        continue;
      add_number(r, j, i, q);
      if (j->number[q].ulp > 0)
        errors[count++] = over(j->number[q].error, j->number[q].ulp);
    }
  }
  gsl_sort(errors, 1, (size_t)count);
  r->median = count > 0 ? gsl_stats_median_from_sorted_data(errors, 1, (size_t)count) : NAN;
}

/* units, ulp, condition and digits; NULL: there is no number */
static void write_errors(struct table *t, const struct stress_number *n)
{
  bool has_ulp = n && n->ulp > 0;
  table_rounded(t, n ? over(n->error, n->unit) : NAN, "%.3g");
  table_rounded(t, has_ulp ? over(n->error, n->ulp) : NAN, "%.3g");
  table_rounded(t, has_ulp ? n->unit / n->ulp : NAN, "%.3g");
  table_rounded(t, has_ulp ? digits_kept(n->error, n->exact) : NAN, "%.1f");
}

static void write_spreads(struct table *t, const double spread[SPREADS], bool known)
{
  for (int k = 0; k < SPREADS; k++)
    table_rounded(t, known ? spread[k] : NAN, k < LOST ? "%.3g" : "%.1f");
}

static void write_verdict(struct table *t, const char *what, int broken)
{
  char text[200];
  snprintf(text, sizeof text, "broken: %s%s", what ? what : "", broken > 1 ? ", and more" : "");
  table_text(t, what ? text : "holds");
}

static void write_row(struct table *t, const struct row *r, const struct stress_case *cases,
                      const struct stress_judgement *judgements)
{
  char arguments[STRESS_ARGUMENTS] = "-";
  const struct stress_judgement *j = r->worst >= 0 ? &judgements[r->worst] : NULL;
  bool more = r->family->kind != STRESS_TRAJECTORY;
  table_text(t, r->family->name);
  table_text(t, r->gait->name);
  table_number(t, r->cases);
  table_number(t, r->refused);
  table_number(t, r->undecided);
  table_number(t, r->other_modes);
  table_text(t, j ? stress_quantity_name(r->family->kind, r->quantity) : "-");
  write_errors(t, j ? &j->number[r->quantity] : NULL);
  table_rounded(t, r->median, "%.3g");
  write_spreads(t, r->spread, more || !j);
  table_rounded(t, isfinite(r->estimate_least) ? r->estimate_least : NAN, "%.4f");
  table_rounded(t, more || !j ? r->estimate_most : NAN, "%.4f");
  write_verdict(t, r->what, r->broken);
  if (j)
    stress_arguments(&cases[r->worst], arguments);
  table_text(t, arguments);
}

struct run {
  const struct stress_options *options;
  struct table table;
  struct stress_case *stressed;
  struct stress_judgement *judgements;
  double *errors;
  struct progress progress;
  int broken; /* rows */
};

/* Prints the first few broken promises of a family, each as one command. */
static void report(const struct row *r, const struct run *run)
{
  enum { MOST = 3 };
  char arguments[STRESS_ARGUMENTS];
  int reported = 0;
  for (int i = 0; i < r->cases && reported < MOST; i++)
    for (int q = 0; q < STRESS_QUANTITIES && reported < MOST; q++) {
      const char *what = stress_broken(&run->judgements[i], q);
      if (!what)
        continue;
      stress_arguments(&run->stressed[i], arguments);
      complain("stress", "%s, %s gait: %s of %s; to see it: scallop %s %s", r->family->name, r->gait->name, what,
               stress_quantity_name(r->family->kind, q), r->family->kind == STRESS_TRAJECTORY ? "trajectory" : "stress",
               arguments);
      reported++;
    }
}

static void judge_all(struct run *run, int count)
{
#pragma omp parallel num_threads(threads_for(0, count))
  {
#pragma omp for schedule(dynamic)
    for (int i = 0; i < count; i++)
      stress_judge(&run->stressed[i], &run->judgements[i]);
    flint_cleanup();
  }
}

static void run_family(struct run *run, const struct stress_family *family, const struct scallop_gait *gait)
{
  const struct stress_options *o = run->options;
  struct row r = { .family = family, .gait = gait };
  progress_show(&run->progress, "%s, %s gait", family->name, gait->name);
  r.cases = stress_make(family, gait, (unsigned long)o->seed.value, cases_of(o, family->kind), run->stressed);
  for (int i = 0; i < r.cases; i++)
    run->stressed[i].periods = o->full ? FULL_PERIODS : o->check ? CHECK_PERIODS : PERIODS;
  judge_all(run, r.cases);
  sum_up(&r, run->judgements, run->errors);
  progress_end(&run->progress);
  write_row(&run->table, &r, run->stressed, run->judgements);
  report(&r, run);
  run->broken += r.broken > 0;
}

static const struct stress_family *family_named(const char *name)
{
  const struct stress_family *f = stress_families;
  while (f->name && strcmp(f->name, name) != 0)
    f++;
  return f->name ? f : NULL;
}

/* The gait that is given; else those of the paper or, for a check, one of each kind. NULL after the last. */
static const struct scallop_gait *gait_of_run(const struct stress_options *o, int i)
{
  if (o->request.point.has_gait)
    return i == 0 ? o->request.point.crawler.gait : NULL;
  const char *name = o->check ? gait_sample(i) : scallop_gait_name(i);
  return name ? gait_of_text(name).gait : NULL;
}

static void run_families(struct run *run)
{
  const struct stress_options *o = run->options;
  const struct scallop_gait *gait;
  for (const struct stress_family *f = stress_families; f->name; f++)
    for (int g = 0; (gait = gait_of_run(o, g)) && !table_failed(&run->table); g++)
      if (!o->family || f == family_named(o->family))
        run_family(run, f, gait);
}

static void begin(struct run *run)
{
  const struct stress_options *o = run->options;
  struct table *t = &run->table;
  table_note(t, "scallop " SCALLOP_VERSION);
  char number[40] = "";
  if (o->cases.value > 0)
    snprintf(number, sizeof number, " --cases %ld", o->cases.value);
  table_note(t, "command: stress%s%s%s%s%s%s%s --seed %ld", o->family ? " --family " : "", o->family ? o->family : "",
             o->request.point.has_gait ? " --gait " : "",
             o->request.point.has_gait ? o->request.point.crawler.gait->name : "", o->full ? " --full" : "",
             o->check ? " --check" : "", number, o->seed.value);
  table_note(t, "unit: max(ulp of the certified value, sum over the parameters of what an ulp of each changes it by)");
  table_note(t, "promised, in units: error %d, spread over the rounding modes %d, over parameters an ulp apart %d",
             STRESS_PROMISE, STRESS_ROUNDING, STRESS_PERTURBED);
  for (const struct stress_family *f = stress_families; f->name; f++)
    if (!o->family || f == family_named(o->family))
      table_note(t, "%s: %s", f->name, f->about);
  table_columns(t, family_columns);
  table_columns(t, error_columns);
  table_columns(t, median_column);
  table_columns(t, spread_columns);
  table_columns(t, family_end);
  table_begin_rows(t);
}

enum exit_code stress_table(const struct stress_options *o)
{
  struct run run = { .options = o, .progress = progress_begin(o->request.style.quiet) };
  enum exit_code code = EXIT_UNSOLVED;
  const size_t most = (size_t)cases_of(o, STRESS_PHASE);
  if (o->family && !family_named(o->family)) {
    const char *names[64] = { NULL };
    for (int i = 0; i < 63 && stress_families[i].name; i++)
      names[i] = stress_families[i].name;
    complain("stress", "--family: there is no family '%s'%s", o->family, did_you_mean(nearest(o->family, names)));
    return EXIT_USAGE;
  }
  run.stressed = calloc(most, sizeof *run.stressed);
  run.judgements = calloc(most, sizeof *run.judgements);
  run.errors = calloc(most * STRESS_QUANTITIES, sizeof *run.errors);
  if (!run.stressed || !run.judgements || !run.errors)
    complain("stress", "out of memory");
  else if (!table_open(&run.table, &o->request.style))
    code = EXIT_FILE;
  else {
    begin(&run);
    run_families(&run);
    code = !table_close(&run.table) ? EXIT_FILE : o->check && run.broken > 0 ? EXIT_CHECK_FAILED : EXIT_DONE;
  }
  free(run.stressed);
  free(run.judgements);
  free(run.errors);
  return code;
}

static void write_number(struct table *t, enum stress_kind kind, const struct stress_judgement *j, int q)
{
  const char *broken = stress_broken(j, q);
  bool judged = stress_is_judged(j, q);
  const struct stress_number *n = &j->number[q];
  double spread[SPREADS];
  find_spreads(n, spread);
  table_text(t, stress_quantity_name(kind, q));
  table_number(t, judged ? n->got : NAN);
  table_number(t, judged ? n->exact : NAN);
  write_errors(t, judged ? n : NULL);
  write_spreads(t, spread, judged);
  table_rounded(t, judged ? 1.0005 * n->estimate : NAN, "%.4g"); /* up */
  if (j->outcome == STRESS_REFUSED)
    table_text(t, j->why);
  else if (!judged && !broken)
    table_text(t, "-");
  else
    write_verdict(t, broken, 0);
}

enum exit_code stress_point(const struct stress_options *o)
{
  struct table t;
  struct stress_judgement j;
  char arguments[STRESS_ARGUMENTS];
  const struct stress_case s = { .kind = o->request.point.has_phase || o->request.point.has_v0 ? STRESS_PHASE
                                                                                               : STRESS_STEADY,
                                 .crawler = o->request.point.crawler,
                                 .phase = o->request.point.phase,
                                 .v0 = o->request.point.v0 };
  bool broken = false;
  stress_judge(&s, &j);
  flint_cleanup();
  if (!table_open(&t, &o->request.style))
    return EXIT_FILE;
  stress_arguments(&s, arguments);
  table_note(&t, "scallop " SCALLOP_VERSION);
  table_note(&t, "command: stress %s", arguments);
  if (j.outcome == STRESS_UNDECIDED)
    table_note(&t, "certified: not decided (%s); binary128 in its place", j.why ? j.why : "no reason");
  table_columns(&t, point_columns);
  table_columns(&t, error_columns);
  table_columns(&t, spread_columns);
  table_columns(&t, point_end);
  table_begin_rows(&t);
  for (int q = 0; q < STRESS_QUANTITIES; q++) {
    write_number(&t, s.kind, &j, q);
    broken |= stress_broken(&j, q) != NULL;
  }
  if (broken)
    complain("stress", "a promise is broken here: see the column 'verdict'");
  if (!table_close(&t))
    return EXIT_FILE;
  return j.outcome == STRESS_REFUSED ? EXIT_UNSOLVED : broken && o->check ? EXIT_CHECK_FAILED : EXIT_DONE;
}
