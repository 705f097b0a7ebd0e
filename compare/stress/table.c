/* The tables of `stress`: families of cases, and a single point. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "compare/stress/stress.h"
#include "compare/answers/defaults.h"
#include "model/flint.h"
#include "numerics/threads.h"

static const char *const family_columns[] = { "family",
                                              "gait",
                                              "cases",
                                              "refused",
                                              "undecided",
                                              "other_modes",
                                              "quantity",
                                              "units",
                                              "ulp",
                                              "condition",
                                              "digits",
                                              "ulp_median",
                                              "rounding",
                                              "perturbed",
                                              "lost_double",
                                              "lost_long_double",
                                              "lost_binary128",
                                              "estimate_least",
                                              "estimate_most",
                                              "verdict",
                                              "worst_at",
                                              NULL };
static const char *const point_columns[] = { "quantity",         "value",          "certified", "units",     "ulp",
                                             "condition",        "digits",         "rounding",  "perturbed", "lost_double",
                                             "lost_long_double", "lost_binary128", "estimate",  "verdict",   NULL };

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

/* ---- one number of one case ---- */

static double over(double error, double unit) { return error == 0 ? 0 : error / unit; }

static double digits_kept(double error, double value)
{
  double most = 53 * log10(2);
  return value == 0 || isnan(value) ? NAN : error == 0 ? most : fmin(most, fmax(0, -log10(error / fabs(value))));
}

/* Decimal digits of a type that the error takes away: its ulp is 2^(53 - bits) of a double's */
static double digits_lost(double error, double ulp, int bits)
{
  double ulps = ldexp(over(error, ulp), bits - 53);
  return ulp == 0 ? NAN : ulps > 1 ? log10(ulps) : 0;
}

/* The same for double, long double and binary128. */
static void all_lost(const struct stress_judgement *j, int q, double lost[3])
{
  lost[0] = digits_lost(j->error[q], j->ulp[q], 53);
  for (int w = 0; w < 2; w++)
    lost[1 + w] = scallop_width_bits((enum scallop_width)w) == 0
                      ? NAN
                      : digits_lost(j->wide_error[w][q], j->ulp[q], scallop_width_bits((enum scallop_width)w));
}

static bool is_judged(const struct stress_judgement *j, int q)
{
  return (j->outcome == STRESS_SOLVED || j->outcome == STRESS_UNDECIDED) && j->has[q];
}

/* How many times the error its estimate is; an error below the 128th part of an ulp counts as that. */
static double generosity(const struct stress_judgement *j, int q)
{
  double least = 0x1p-7 * j->ulp[q];
  return over(j->estimate[q], fmax(j->error[q], least));
}

/* ---- a family: the row ---- */

struct row {
  const struct stress_family *family;
  const struct scallop_gait *gait;
  int cases, refused, undecided, other_modes, broken;
  int worst, quantity;  /* where error/unit is largest: the case, or -1, and which of its numbers        */
  double units, median; /* there; of errors in ulp over all numbers                                       */
  double rounding, perturbed, lost[3], estimate_least, estimate_most;
  const char *what; /* is broken, first of all; NULL: nothing                                      */
};

static int by_size(const void *a, const void *b)
{
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static double median_of(double *x, int count)
{
  if (count == 0)
    return NAN;
  qsort(x, (size_t)count, sizeof *x, by_size);
  return count % 2 ? x[count / 2] : (x[count / 2 - 1] + x[count / 2]) / 2;
}

static void add_number(struct row *r, const struct stress_judgement *j, int i, int q)
{
  double units = over(j->error[q], j->unit[q]), lost[3], generous = generosity(j, q);
  if (r->worst < 0 || units > r->units) {
    r->units = units;
    r->worst = i;
    r->quantity = q;
  }
  r->rounding = fmax(r->rounding, over(j->rounding[q], j->unit[q]));
  r->perturbed = fmax(r->perturbed, over(j->perturbed[q], j->unit[q]));
  if (j->only_error)
    return;
  all_lost(j, q, lost);
  for (int k = 0; k < 3; k++)
    r->lost[k] = fmax(r->lost[k], lost[k]);
  if (j->ulp[q] > 0 && j->error[q] > 0 && j->error[q] >= 0x1p-7 * j->ulp[q])
    r->estimate_least = fmin(r->estimate_least, generous);
  if (j->ulp[q] > 0)
    r->estimate_most = fmax(r->estimate_most, generous);
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
      if (!is_judged(j, q))
        continue;
      add_number(r, j, i, q);
      if (j->ulp[q] > 0)
        errors[count++] = over(j->error[q], j->ulp[q]);
    }
  }
  r->median = median_of(errors, count);
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
  static const struct stress_judgement none = { 0 };
  char arguments[STRESS_ARGUMENTS] = "-";
  const struct stress_judgement *j = r->worst >= 0 ? &judgements[r->worst] : &none;
  int q = r->quantity;
  bool has_ulp = j->ulp[q] > 0;
  table_text(t, r->family->name);
  table_text(t, r->gait->name);
  table_number(t, r->cases);
  table_number(t, r->refused);
  table_number(t, r->undecided);
  table_number(t, r->other_modes);
  table_text(t, r->worst >= 0 ? stress_quantity_name(r->family->kind, q) : "-");
  table_rounded(t, r->worst >= 0 ? r->units : NAN, "%.3g");
  table_rounded(t, has_ulp ? over(j->error[q], j->ulp[q]) : NAN, "%.3g");
  table_rounded(t, has_ulp ? j->unit[q] / j->ulp[q] : NAN, "%.3g");
  table_rounded(t, has_ulp ? digits_kept(j->error[q], j->exact[q]) : NAN, "%.1f");
  table_rounded(t, r->median, "%.3g");
  bool more = !j->only_error;
  table_rounded(t, more ? r->rounding : NAN, "%.3g");
  table_rounded(t, more ? r->perturbed : NAN, "%.3g");
  for (int k = 0; k < 3; k++)
    table_rounded(t, more ? r->lost[k] : NAN, "%.1f");
  table_rounded(t, isfinite(r->estimate_least) ? r->estimate_least : NAN, "%.4f");
  table_rounded(t, more ? r->estimate_most : NAN, "%.4f");
  write_verdict(t, r->what, r->broken);
  if (r->worst >= 0)
    stress_arguments(&cases[r->worst], arguments);
  table_text(t, arguments);
}

/* ---- a family: the work ---- */

struct run {
  const struct stress_options *options;
  struct table table;
  struct stress_case *stressed;
  struct stress_judgement *judgements;
  double *errors;
  bool shown;
  int broken; /* rows */
};

/* Each broken promise as one command; a few of a family are enough. */
static void report(const struct row *r, const struct run *run)
{
  enum { MOST = 3 };
  char arguments[STRESS_ARGUMENTS];
  int said = 0;
  for (int i = 0; i < r->cases && said < MOST; i++)
    for (int q = 0; q < STRESS_QUANTITIES && said < MOST; q++) {
      const char *what = stress_broken(&run->judgements[i], q);
      if (!what)
        continue;
      stress_arguments(&run->stressed[i], arguments);
      complain("stress", "%s, %s gait: %s of %s; to see it: scallop %s %s", r->family->name, r->gait->name, what,
               stress_quantity_name(r->family->kind, q), r->family->kind == STRESS_TRAJECTORY ? "trajectory" : "stress",
               arguments);
      said++;
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
  if (run->shown)
    fprintf(stderr, "\r%s, %s gait\033[K", family->name, gait->name);
  r.cases = stress_make(family, gait, (unsigned long)o->seed.value, cases_of(o, family->kind), run->stressed);
  for (int i = 0; i < r.cases; i++)
    run->stressed[i].periods = o->full ? FULL_PERIODS : o->check ? CHECK_PERIODS : PERIODS;
  judge_all(run, r.cases);
  sum_up(&r, run->judgements, run->errors);
  if (run->shown)
    fprintf(stderr, "\r\033[K");
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
  table_begin_rows(t);
}

enum exit_code stress_table(const struct stress_options *o)
{
  struct run run = { .options = o, .shown = !o->request.style.quiet && isatty(STDERR_FILENO) };
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

/* ---- a point ---- */

static void write_number(struct table *t, const struct stress_case *s, const struct stress_judgement *j, int q)
{
  double lost[3];
  const char *broken = stress_broken(j, q);
  bool judged = is_judged(j, q), has_ulp = judged && j->ulp[q] > 0;
  all_lost(j, q, lost);
  table_text(t, stress_quantity_name(s->kind, q));
  table_number(t, judged ? j->got[q] : NAN);
  table_number(t, judged ? j->exact[q] : NAN);
  table_rounded(t, judged ? over(j->error[q], j->unit[q]) : NAN, "%.3g");
  table_rounded(t, has_ulp ? over(j->error[q], j->ulp[q]) : NAN, "%.3g");
  table_rounded(t, has_ulp ? j->unit[q] / j->ulp[q] : NAN, "%.3g");
  table_rounded(t, has_ulp ? digits_kept(j->error[q], j->exact[q]) : NAN, "%.1f");
  table_rounded(t, judged ? over(j->rounding[q], j->unit[q]) : NAN, "%.3g");
  table_rounded(t, judged ? over(j->perturbed[q], j->unit[q]) : NAN, "%.3g");
  for (int k = 0; k < 3; k++)
    table_rounded(t, judged ? lost[k] : NAN, "%.1f");
  table_rounded(t, judged ? 1.0005 * j->estimate[q] : NAN, "%.4g"); /* up */
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
  table_begin_rows(&t);
  for (int q = 0; q < STRESS_QUANTITIES; q++) {
    write_number(&t, &s, &j, q);
    broken |= stress_broken(&j, q) != NULL;
  }
  if (broken)
    complain("stress", "a promise is broken here: see the column 'verdict'");
  if (!table_close(&t))
    return EXIT_FILE;
  return j.outcome == STRESS_REFUSED ? EXIT_UNSOLVED : broken && o->check ? EXIT_CHECK_FAILED : EXIT_DONE;
}
