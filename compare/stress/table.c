/* The tables of `stress`: a row for each family of cases, or for each number of a single point. */
#include "compare/stress/table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

#include "compare/points/defaults.h"
#include "compare/stress/judge.h"
#include "compare/text/progress.h"
#include "model/exact/flint.h"
#include "numerics/threads.h"

/* The numbers of both tables, in the order of their columns: of a family where error/unit is largest, and from rounding
 * on the largest of all; of a point those of each number, without the three that are of many. */
enum { UNITS, ULP, CONDITION, DIGITS, MEDIAN, ROUNDING, PERTURBED, LOST, LEAST = LOST + 3, MOST, MEASURES };
static const char *const measures[MEASURES] = {
  "units",     "ulp",         "condition",        "digits",         "ulp_median",     "rounding",
  "perturbed", "lost_double", "lost_long_double", "lost_binary128", "estimate_least", "estimate_most"
};

static bool is_column(int m, bool of_point) { return !of_point || (m != MEDIAN && m < LEAST); }

static void begin_rows(struct table *t, const char *const *before, bool of_point, const char *const *after)
{
  table_columns(t, before);
  for (int m = 0; m < MEASURES; m++)
    if (is_column(m, of_point))
      table_columns(t, (const char *const[]){ measures[m], NULL });
  table_columns(t, after);
  table_begin_rows(t);
}

static void write_measures(struct table *t, const double value[MEASURES], bool of_point)
{
  for (int m = 0; m < MEASURES; m++)
    if (is_column(m, of_point))
      table_rounded(t, value[m], m >= LEAST ? "%.4f" : m == DIGITS || m >= LOST ? "%.1f" : "%.3g");
}

/* Of a trajectory: a case takes as long as so many periods do. */
enum { TRAJECTORIES = 4, PERIODS = 1000000, CHECK_PERIODS = 10000, FULL_PERIODS = 10000000 };

/* Of each family of a kind. A check of all gaits takes a few seconds: a phase is judged in less time than a steady
 * state. */
static int cases_of(const struct stress_options *o, enum stress_kind kind)
{
  static const int check[] = {
    [STRESS_STEADY] = STRESS_CHECK_STEADY, [STRESS_PHASE] = STRESS_CHECK_PHASES, [STRESS_TRAJECTORY] = 2
  };
  int cases = o->cases.value > 0 ? (int)o->cases.value
              : o->full          ? STRESS_FULL_CASES
              : o->check         ? check[kind]
                                 : STRESS_CASES;
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

/* nan: not judged. In estimates over errors an error below the 128th part of an ulp counts as that. */
static void find_measures(const struct stress_judgement *j, int q, double value[MEASURES])
{
  const struct stress_number *n = &j->number[q];
  const bool judged = stress_is_judged(j, q), has_ulp = judged && n->ulp > 0, all = !j->only_error;
  const double least = 0x1p-7 * n->ulp, estimate = has_ulp && all ? over(n->estimate, fmax(n->error, least)) : NAN;
  value[UNITS] = judged ? over(n->error, n->unit) : NAN;
  value[ULP] = has_ulp ? over(n->error, n->ulp) : NAN;
  value[CONDITION] = has_ulp ? n->unit / n->ulp : NAN;
  value[DIGITS] = has_ulp ? digits_kept(n->error, n->exact) : NAN;
  value[MEDIAN] = NAN;
  value[ROUNDING] = judged && all ? over(n->rounding, n->unit) : NAN;
  value[PERTURBED] = judged && all ? over(n->perturbed, n->unit) : NAN;
  value[LOST] = digits_lost(n->error, has_ulp && all ? n->ulp : 0, 53);
  for (int w = 0; w < 2; w++)
    value[LOST + 1 + w] = digits_lost(n->wide_error[w], has_ulp && all ? n->ulp : 0,
                                      scallop_width_bits((enum scallop_width)w));
  value[LEAST] = n->error > 0 && n->error >= least ? estimate : NAN;
  value[MOST] = estimate;
}

/* A row of the table of families */
struct row {
  const struct stress_family *family;
  const struct scallop_gait *gait;
  int cases, refused, undecided, other_modes, broken;
  int worst, quantity; /* where error/unit is largest: the case, or -1, and which of its numbers */
  double value[MEASURES];
  const char *what; /* is broken, first of all; NULL: nothing */
};

static void add_number(struct row *r, const struct stress_judgement *j, int i, int q)
{
  double value[MEASURES];
  find_measures(j, q, value);
  if (r->worst < 0 || value[UNITS] > r->value[UNITS]) {
    memcpy(r->value, value, MEDIAN * sizeof *value);
    r->worst = i;
    r->quantity = q;
  }
  for (int m = ROUNDING; m < MEASURES; m++)
    r->value[m] = m == LEAST ? fmin(r->value[m], value[m]) : fmax(r->value[m], value[m]);
}

/* errors: room for STRESS_QUANTITIES * r->cases numbers */
static void sum_up(struct row *r, const struct stress_judgement *judgements, double *errors)
{
  size_t count = 0;
  r->worst = -1;
  for (int m = 0; m < MEASURES; m++)
    r->value[m] = NAN;
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
  gsl_sort(errors, 1, count);
  r->value[MEDIAN] = count > 0 ? gsl_stats_median_from_sorted_data(errors, 1, count) : NAN;
}

static void write_verdict(struct table *t, const char *what, int broken)
{
  char text[200];
  snprintf(text, sizeof text, "broken: %s%s", what ? what : "", broken > 1 ? ", and more" : "");
  table_text(t, what ? text : "holds");
}

static void write_row(struct table *t, const struct row *r, const struct stress_case *cases)
{
  char arguments[STRESS_ARGUMENTS] = "-";
  const int counts[] = { r->cases, r->refused, r->undecided, r->other_modes };
  table_text(t, r->family->name);
  table_text(t, r->gait->name);
  for (size_t i = 0; i < sizeof counts / sizeof *counts; i++)
    table_number(t, counts[i]);
  table_text(t, r->worst >= 0 ? stress_quantity_name(r->family->kind, r->quantity) : "-");
  write_measures(t, r->value, false);
  write_verdict(t, r->what, r->broken);
  if (r->worst >= 0)
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
  int broken;            /* rows  */
  long judged, to_judge; /* cases */
};

/* Prints the first few broken promises of a family, each as one command. */
static void report(const struct row *r, const struct run *run)
{
  enum { REPORTED = 3 };
  char arguments[STRESS_ARGUMENTS];
  int reported = 0;
  for (int i = 0; i < r->cases && reported < REPORTED; i++)
    for (int q = 0; q < STRESS_QUANTITIES && reported < REPORTED; q++) {
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
    for (int i = 0; i < count; i++) {
      stress_judge(&run->stressed[i], &run->judgements[i]);
#ifdef _OPENMP
#pragma omp critical
#endif
      progress_count(++run->judged, run->to_judge);
    }
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
  write_row(&run->table, &r, run->stressed);
  table_flush(&run->table);
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

/* The gait that is given; else that of the family, or those of the paper or, for a check, one of each kind. NULL after
 * the last. */
static const struct scallop_gait *gait_of_run(const struct stress_options *o, const struct stress_family *f, int i)
{
  if (o->request.point.has_gait)
    return i == 0 ? o->request.point.crawler.gait : NULL;
  const char *name = f->gait ? (i == 0 ? f->gait : NULL) : o->check ? gait_sample(i) : scallop_gait_name(i);
  return name ? gait_of_text(name).gait : NULL;
}

static void run_families(struct run *run)
{
  const struct stress_options *o = run->options;
  const struct scallop_gait *gait;
  for (const struct stress_family *f = stress_families; f->name; f++)
    for (int g = 0; (!o->family || f == family_named(o->family)) && gait_of_run(o, f, g); g++)
      run->to_judge += cases_of(o, f->kind);
  for (const struct stress_family *f = stress_families; f->name; f++)
    for (int g = 0; (gait = gait_of_run(o, f, g)) && !table_failed(&run->table); g++)
      if (!o->family || f == family_named(o->family))
        run_family(run, f, gait);
}

static void begin(struct run *run)
{
  static const char *const before[] = { "family",    "gait",        "cases",    "refused",
                                        "undecided", "other_modes", "quantity", NULL };
  static const char *const after[] = { "verdict", "worst_at", NULL };
  const struct stress_options *o = run->options;
  struct table *t = &run->table;
  char number[40] = "";
  if (o->cases.value > 0)
    snprintf(number, sizeof number, " --cases %ld", o->cases.value);
  table_command(t, "stress%s%s%s%s%s%s%s --seed %ld", o->family ? " --family " : "", o->family ? o->family : "",
                o->request.point.has_gait ? " --gait " : "",
                o->request.point.has_gait ? o->request.point.crawler.gait->name : "", o->full ? " --full" : "",
                o->check ? " --check" : "", number, o->seed.value);
  table_note(t, "unit: max(ulp of the certified value, sum over the parameters of what an ulp of each changes it by)");
  table_note(t, "promised, in units: error %d, spread over the rounding modes %d, over parameters an ulp apart %d",
             STRESS_PROMISE, STRESS_ROUNDING, STRESS_PERTURBED);
  for (const struct stress_family *f = stress_families; f->name; f++)
    if (!o->family || f == family_named(o->family))
      table_note(t, "%s: %s", f->name, f->about);
  begin_rows(t, before, false, after);
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
  double value[MEASURES];
  find_measures(j, q, value);
  table_text(t, stress_quantity_name(kind, q));
  table_number(t, judged ? n->got : NAN);
  table_number(t, judged ? n->exact : NAN);
  write_measures(t, value, true);
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
  static const char *const before[] = { "quantity", "value", "certified", NULL }, *const after[] = { "estimate",
                                                                                                     "verdict", NULL };
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
  stress_arguments(&s, arguments);
  if (!table_head(&t, &o->request.style, "stress %s", arguments))
    return EXIT_FILE;
  t.of = "stress of a point";
  if (j.outcome == STRESS_UNDECIDED)
    table_note(&t, "certified: not decided (%s); binary128 in its place", j.why ? j.why : "no reason");
  begin_rows(&t, before, true, after);
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
