/* The tables of `stress`: a row for each family of cases, or for each number of a single point. */
#include <assert.h>
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

#include "compare/points/defaults.h"
#include "compare/stress/stress.h"
#include "compare/text/progress.h"
#include "model/exact/flint.h"
#include "numerics/threads.h"

/* Decimal digits of a type that an error takes away: its ulp is 2^(53 - bits) of a double's. nan stays nan. */
static double lost(const struct stress_number *n, int wide, int bits)
{
  double ulps = ldexp(n->wide_error[wide] / n->ulp, bits - DBL_MANT_DIG);
  return ulps > 1 ? log10(ulps) : 0 * ulps;
}

/* What is said of a number; nan: of an exact value of 0, or of a trajectory. */
static double units(const struct stress_number *n) { return n->error / n->unit; }
static double ulps(const struct stress_number *n) { return n->error / n->ulp; }
static double condition(const struct stress_number *n) { return n->unit / n->ulp; }
static double digits(const struct stress_number *n)
{
  return n->ulp > 0 ? fmin(DBL_MANT_DIG * log10(2), fmax(0, -log10(n->error / fabs(n->exact)))) : NAN;
}
static double rounding(const struct stress_number *n) { return n->rounding / n->unit; }
static double perturbed(const struct stress_number *n) { return n->perturbed / n->unit; }
static double lost_double(const struct stress_number *n) { return lost(n, 0, DBL_MANT_DIG); }
static double lost_long(const struct stress_number *n) { return lost(n, 1, scallop_width_bits(SCALLOP_LONG_DOUBLE)); }
static double lost_binary128(const struct stress_number *n)
{
  return lost(n, 2, scallop_width_bits(SCALLOP_BINARY128));
}
/* The estimate of the error over it; an error below the 128th part of an ulp counts as that, or for nothing. */
static double estimate(const struct stress_number *n)
{
  return n->ulp > 0 ? n->estimate / fmax(n->error, 0x1p-7 * n->ulp) : NAN;
}
static double estimate_known(const struct stress_number *n) { return n->error >= 0x1p-7 * n->ulp ? estimate(n) : NAN; }

enum { WORST = -1 };
static const struct measure {
  const char *name, *format;
  double (*of)(const struct stress_number *number);
  double quantile; /* over all numbers of a family; WORST: of the one with the largest error/unit */
  bool of_many;    /* the row of a number does not have it */
} measures[] = {
  { "error_units", "%.3g", units, WORST, false },
  { "ulp", "%.3g", ulps, WORST, false },
  { "condition", "%.3g", condition, WORST, false },
  { "digits", "%.1f", digits, WORST, false },
  { "ulp_median", "%.3g", ulps, 0.5, true },
  { "spread_rounding", "%.3g", rounding, 1, false },
  { "change_per_ulp", "%.3g", perturbed, 1, false },
  { "lost_double", "%.1f", lost_double, 1, false },
  { "lost_long_double", "%.1f", lost_long, 1, false },
  { "lost_binary128", "%.1f", lost_binary128, 1, false },
  { "estimate_ratio_min", "%.4f", estimate_known, 0, true },
  { "estimate_ratio_max", "%.4f", estimate, 1, true },
};
enum { MEASURES = sizeof measures / sizeof *measures };

static void begin_rows(struct table *t, const char *const *before, bool of_many, const char *const *after)
{
  table_columns(t, before);
  for (int m = 0; m < MEASURES; m++)
    if (of_many || !measures[m].of_many)
      table_columns(t, (const char *const[]){ measures[m].name, NULL });
  table_columns(t, after);
  table_begin_rows(t);
}

static const char *verdict(const char *broken, bool more)
{
  return broken ? wrong_text("broken: %s%s", broken, more ? ", and more" : "") : "holds";
}

/* How many cases of each kind, and how long a trajectory is: it takes as long as so many periods do. A check of all
 * gaits takes a few seconds: a phase is judged in less time than a steady state. */
enum { TRAJECTORIES = 4 };
static const struct effort {
  int cases[3];
  long periods;
} usual = { { STRESS_CASES, STRESS_CASES, TRAJECTORIES }, 1000000 },
  quick = { { STRESS_CHECK_STEADY, STRESS_CHECK_PHASES, 2 }, 10000 },
  full = { { STRESS_FULL_CASES, STRESS_FULL_CASES, TRAJECTORIES }, 10000000 };

/* The gait that is given; else that of the family, or those of the paper or, for a check, one of each kind. NULL after
 * the last. */
static const struct scallop_gait *gait_of_row(const struct stress_options *o, const struct stress_family *f, int i)
{
  const struct point *p = &o->request.point;
  if (p->has_gait || f->gait)
    return i > 0 ? NULL : p->has_gait ? p->crawler.gait : gait_of_text(f->gait).gait;
  const struct scallop_gait_family *family = scallop_gait_family(i);
  const char *name = !o->check ? scallop_gait_name(i) : family ? family->sample : NULL;
  return name ? gait_of_text(name).gait : NULL;
}

/* A row: a family with a gait. Once its cases are judged: */
struct row {
  const struct stress_family *family;
  const struct scallop_gait *gait;
  int cases, refused, undecided, other_modes, broken;
  const char *what;                  /* is broken first, or NULL */
  const struct stress_number *worst; /* or NULL                  */
  const struct stress_case *worst_at;
  const char *quantity;
};

enum { MOST_ROWS = 512 };
struct run {
  const struct stress_options *options;
  const struct effort *effort;
  struct row row[MOST_ROWS];
  int rows;
  long judged, to_judge; /* cases */
  size_t most;           /* in a row, at least 1 */
  struct stress_case *stressed;
  double *values; /* room for one measure of all numbers */
  struct table table;
};

/* The rows, and room for the cases of the largest. EXIT_DONE, or why not; the message is on stderr. */
static enum exit_code plan(struct run *run)
{
  const struct stress_options *o = run->options;
  const struct scallop_gait *gait;
  for (const struct stress_family *f = stress_families; f->name; f++) {
    int most = f->kind == STRESS_TRAJECTORY ? TRAJECTORIES : INT_MAX, given = (int)o->cases.value;
    int cases = given > most ? most : given > 0 ? given : run->effort->cases[f->kind];
    for (int g = 0; (!o->family || strcmp(f->name, o->family) == 0) && (gait = gait_of_row(o, f, g)); g++) {
      assert(run->rows < MOST_ROWS);
      run->row[run->rows++] = (struct row){ .family = f, .gait = gait, .cases = cases };
      run->to_judge += cases;
      run->most = (size_t)cases > run->most ? (size_t)cases : run->most;
    }
  }
  if (run->rows == 0) {
    complain("stress", "--family: there is no family '%s'%s", o->family,
             did_you_mean(nearest_in(o->family, stress_families, sizeof *stress_families)));
    return EXIT_USAGE;
  }
  run->stressed = calloc(run->most, sizeof *run->stressed);
  run->values = calloc(run->most * QUANTITIES, sizeof *run->values);
  if (run->stressed && run->values)
    return EXIT_DONE;
  complain("stress", "out of memory");
  return EXIT_UNSOLVED;
}

static void judge_all(struct run *run, int count)
{
#pragma omp parallel num_threads(threads_for(0, count))
  {
#pragma omp for schedule(dynamic)
    for (int i = 0; i < count; i++) {
      stress_judge(&run->stressed[i]);
#ifdef _OPENMP
#pragma omp critical
#endif
      progress_count(++run->judged, run->to_judge);
    }
    flint_cleanup();
  }
}

/* The first few broken promises of a family are printed, each as one command. */
static void add_broken(struct row *r, const struct stress_case *s, const char *what, int q)
{
  enum { REPORTED = 3 };
  char arguments[STRESS_ARGUMENTS];
  r->what = r->what ? r->what : what;
  if (r->broken++ >= REPORTED)
    return;
  stress_arguments(s, arguments);
  complain("stress", "%s, %s gait: %s of %s; to see it: scallop %s %s", r->family->name, r->gait->name, what,
           stress_quantity_name(s, q), s->periods > 0 ? "trajectory" : "stress", arguments);
}

static void sum_up(const struct run *run, struct row *r)
{
  for (int i = 0; i < r->cases; i++) {
    const struct stress_case *s = &run->stressed[i];
    r->refused += s->outcome == STRESS_REFUSED;
    r->undecided += s->outcome == STRESS_UNDECIDED;
    r->other_modes += s->other_modes;
    for (int q = (int)quantity_first(s->motion.of); q < (int)quantity_end(s->motion.of); q++) {
      const struct stress_number *n = &s->number[q];
      if (n->broken)
        add_broken(r, s, n->broken, q);
      if (n->judged && (!r->worst || units(n) > units(r->worst))) {
        r->worst = n;
        r->worst_at = s;
        r->quantity = stress_quantity_name(s, q);
      }
    }
  }
}

static double choose(const struct run *run, const struct row *r, const struct measure *m)
{
  size_t count = 0;
  if (m->quantile == WORST)
    return r->worst ? m->of(r->worst) : NAN;
  for (int i = 0; i < r->cases; i++)
    for (int q = 0; q < QUANTITIES; q++) {
      const struct stress_number *n = &run->stressed[i].number[q];
      if (n->judged && !isnan(m->of(n)))
        run->values[count++] = m->of(n);
    }
  gsl_sort(run->values, 1, count);
  return count > 0 ? gsl_stats_quantile_from_sorted_data(run->values, 1, count, m->quantile) : NAN;
}

static void write_row(struct run *run, const struct row *r)
{
  struct table *t = &run->table;
  char arguments[STRESS_ARGUMENTS] = "-";
  const int counts[] = { r->cases, r->refused, r->undecided, r->other_modes };
  table_text(t, r->family->name);
  table_text(t, r->gait->name);
  for (size_t i = 0; i < sizeof counts / sizeof *counts; i++)
    table_count(t, counts[i]);
  table_text(t, r->worst ? r->quantity : "-");
  for (int m = 0; m < MEASURES; m++)
    table_rounded(t, choose(run, r, &measures[m]), measures[m].format);
  table_text(t, verdict(r->what, r->broken > 1));
  if (r->worst)
    stress_arguments(r->worst_at, arguments);
  table_text(t, arguments);
  table_flush(t);
}

static void run_row(struct run *run, struct row *r)
{
  progress_show("%s, %s gait", r->family->name, r->gait->name);
  r->cases = stress_make(r->family, r->gait, (unsigned long)run->options->seed.value, r->cases, run->stressed);
  for (int i = 0; i < r->cases; i++)
    run->stressed[i].periods *= run->effort->periods;
  judge_all(run, r->cases);
  sum_up(run, r);
  progress_end();
  write_row(run, r);
}

static bool begin(struct run *run)
{
  static const char *const before[] = { "family",    "gait",        "cases",    "refused",
                                        "undecided", "other_modes", "quantity", NULL };
  static const char *const after[] = { "verdict", "worst_at", NULL };
  const struct stress_options *o = run->options;
  const struct point *p = &o->request.point;
  struct table *t = &run->table;
  const char *cases = o->cases.value > 0 ? wrong_text(" --cases %ld", o->cases.value) : "";
  if (!table_head(t, &o->request.style, "stress%s%s%s%s%s%s%s --seed %ld", o->family ? " --family " : "",
                  o->family ? o->family : "", p->has_gait ? " --gait " : "", p->has_gait ? p->crawler.gait->name : "",
                  o->full ? " --full" : "", o->check ? " --check" : "", cases, o->seed.value))
    return false;
  table_note(t, "unit: max(ulp of the certified value, sum over the parameters of what an ulp of each changes it by)");
  table_note(t, "promised, in units: error %d, spread over the rounding modes %d, over parameters an ulp apart %d",
             STRESS_PROMISE, STRESS_ROUNDING, STRESS_PERTURBED);
  for (const struct row *r = run->row; r < run->row + run->rows; r++)
    if (r == run->row || r->family != r[-1].family)
      table_note(t, "%s: %s", r->family->name, r->family->about);
  begin_rows(t, before, true, after);
  return true;
}

static enum exit_code run_rows(struct run *run)
{
  bool broken = false;
  if (!begin(run))
    return EXIT_FILE;
  for (struct row *r = run->row; r < run->row + run->rows && !table_failed(&run->table); r++) {
    run_row(run, r);
    broken |= r->broken > 0;
  }
  return !table_close(&run->table) ? EXIT_FILE : run->options->check && broken ? EXIT_CHECK_FAILED : EXIT_DONE;
}

enum exit_code stress_table(const struct stress_options *o)
{
  struct run run = { .options = o, .effort = o->full ? &full : o->check ? &quick : &usual, .most = 1 };
  enum exit_code code = plan(&run);
  if (code == EXIT_DONE)
    code = run_rows(&run);
  free(run.stressed);
  free(run.values);
  return code;
}

static void write_number(struct table *t, const struct stress_case *s, int q)
{
  const struct stress_number *n = &s->number[q];
  table_text(t, quantity_rows[q].name);
  table_number(t, n->judged ? n->got : NAN);
  table_number(t, n->judged ? n->exact : NAN);
  for (int m = 0; m < MEASURES; m++)
    if (!measures[m].of_many)
      table_rounded(t, n->judged ? measures[m].of(n) : NAN, measures[m].format);
  table_rounded(t, n->judged ? 1.0005 * n->estimate : NAN, "%.4g"); /* up */
  table_text(t, s->outcome == STRESS_REFUSED ? s->why : !n->judged && !n->broken ? "-" : verdict(n->broken, false));
}

enum exit_code stress_point(const struct stress_options *o)
{
  static const char *const before[] = { "quantity", "value", "certified", NULL };
  static const char *const after[] = { "estimate", "verdict", NULL };
  const struct point *p = &o->request.point;
  struct stress_case s = { .motion = motion_of(p, p->has_phase || p->has_v0 ? OF_PHASE : OF_STEADY) };
  struct table t;
  char arguments[STRESS_ARGUMENTS];
  bool broken = false;
  stress_judge(&s);
  flint_cleanup();
  stress_arguments(&s, arguments);
  if (!table_head(&t, &o->request.style, "stress %s", arguments))
    return EXIT_FILE;
  t.of = "stress of a point";
  if (s.outcome == STRESS_UNDECIDED)
    table_note(&t, "certified: not decided (%s); binary128 in its place", s.why ? s.why : "no reason");
  begin_rows(&t, before, false, after);
  for (int q = (int)quantity_first(s.motion.of); q < (int)quantity_end(s.motion.of); q++) {
    write_number(&t, &s, q);
    broken |= s.number[q].broken != NULL;
  }
  if (broken)
    complain("stress", "a promise is broken here: see the column 'verdict'");
  if (!table_close(&t))
    return EXIT_FILE;
  return s.outcome == STRESS_REFUSED ? EXIT_UNSOLVED : broken && o->check ? EXIT_CHECK_FAILED : EXIT_DONE;
}
