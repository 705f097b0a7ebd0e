/* Tables of `stress`: a row for each family of cases, or for each number of a single point. */
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

/* Returns the decimal digits of a type that an error costs: its ulp is 2^(53 - bits) of a double's. nan stays nan. */
static double lost(const struct stress_number *n, int wide, int bits)
{
  double ulps = ldexp(n->wide_error[wide] / n->ulp, bits - DBL_MANT_DIG);
  return ulps > 1 ? log10(ulps) : 0 * ulps;
}

/* Measures of a number; nan for an exact value of 0, or a trajectory. */
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
/* Return the estimate of the error over the error; an error below the 128th part of an ulp counts as this part, or
 * nan. */
static double estimate(const struct stress_number *n)
{
  return n->ulp > 0 ? n->estimate / fmax(n->error, 0x1p-7 * n->ulp) : NAN;
}
static double estimate_known(const struct stress_number *n) { return n->error >= 0x1p-7 * n->ulp ? estimate(n) : NAN; }

enum { WORST = -1 };
static const struct measure {
  const char *name, *format;
  double (*of)(const struct stress_number *number);
  double quantile; /* over all numbers of a family; WORST: the number with the largest error/unit */
  bool of_many;    /* for a family, not for a single number */
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

/* Counts of cases of each kind, and periods of a trajectory: its time is proportional to them. A check of all gaits
 * takes a few seconds, with more phases, as a steady state takes longer. */
enum { TRAJECTORIES = 4 };
static const struct effort {
  int cases[3];
  long periods;
} usual = { { STRESS_CASES, STRESS_CASES, TRAJECTORIES }, 1000000 },
  quick = { { STRESS_CHECK_STEADY, STRESS_CHECK_PHASES, 2 }, 10000 },
  full = { { STRESS_FULL_CASES, STRESS_FULL_CASES, TRAJECTORIES }, 10000000 };

/* Returns the i-th gait of a family: the given one, else the family's, else the paper's or, for a check, one of each
 * kind. NULL after the last. */
static const struct scallop_gait *gait_of_row(const struct stress_options *o, const struct stress_family *f, int i)
{
  const struct point *p = &o->request.point;
  if (p->has_gait || f->gait)
    return i > 0 ? NULL : p->has_gait ? p->crawler.gait : gait_of_text(f->gait).gait;
  const struct scallop_gait_family *family = scallop_gait_family(i);
  const char *name = !o->check ? scallop_gait_name(i) : family ? family->sample : NULL;
  return name ? gait_of_text(name).gait : NULL;
}

/* Row of a family with a gait, and results of its cases */
struct row {
  const struct stress_family *family;
  const struct scallop_gait *gait;
  int cases, refused, undecided, other_modes, broken;
  const char *bound;                 /* the first one exceeded, or NULL */
  const struct stress_number *worst; /* or NULL                  */
  const struct stress_case *worst_at;
  const char *quantity;
};

enum { MAX_ROWS = 512 };
struct stress_output {
  const struct stress_options *options;
  const struct effort *effort;
  struct row row[MAX_ROWS];
  int rows;
  long judged, to_judge; /* cases */
  size_t max_cases;      /* of a row, at least 1 */
  struct stress_case *stressed;
  double *values; /* memory for one measure of all numbers of a row */
  struct table table;
};

/* Plans the rows, and allocates memory for the cases of the largest. Prints a message to stderr if this fails. */
static enum exit_code plan(struct stress_output *out)
{
  const struct stress_options *o = out->options;
  const struct scallop_gait *gait;
  for (const struct stress_family *f = stress_families; f->name; f++) {
    int max = f->kind == STRESS_TRAJECTORY ? TRAJECTORIES : INT_MAX, given = (int)o->cases.value;
    int cases = given > max ? max : given > 0 ? given : out->effort->cases[f->kind];
    for (int g = 0; (!o->family || strcmp(f->name, o->family) == 0) && (gait = gait_of_row(o, f, g)); g++) {
      assert(out->rows < MAX_ROWS);
      out->row[out->rows++] = (struct row){ .family = f, .gait = gait, .cases = cases };
      out->to_judge += cases;
      out->max_cases = (size_t)cases > out->max_cases ? (size_t)cases : out->max_cases;
    }
  }
  if (out->rows == 0) {
    complain("stress", "--family: there is no family '%s'%s", o->family,
             did_you_mean(nearest_in(o->family, stress_families, sizeof *stress_families)));
    return EXIT_USAGE;
  }
  out->stressed = calloc(out->max_cases, sizeof *out->stressed);
  out->values = calloc(out->max_cases * QUANTITIES, sizeof *out->values);
  if (out->stressed && out->values)
    return EXIT_DONE;
  complain("stress", "out of memory");
  return EXIT_UNSOLVED;
}

static void judge_all(struct stress_output *out, int count)
{
#pragma omp parallel num_threads(threads_for(0, count))
  {
#pragma omp for schedule(dynamic)
    for (int i = 0; i < count; i++) {
      stress_judge(&out->stressed[i]);
#ifdef _OPENMP
#pragma omp critical
#endif
      progress_count(++out->judged, out->to_judge);
    }
    flint_cleanup();
  }
}

/* Counts an exceeded bound; the first few of a family are printed, each as one command. */
static void add_broken(struct row *r, const struct stress_case *s, const char *bound, int q)
{
  enum { REPORTED = 3 };
  char arguments[STRESS_ARGUMENTS];
  r->bound = r->bound ? r->bound : bound;
  if (r->broken++ >= REPORTED)
    return;
  stress_arguments(s, arguments);
  complain("stress", "%s, %s gait: %s of %s; to see it: scallop %s %s", r->family->name, r->gait->name, bound,
           stress_quantity_name(s, q), s->periods > 0 ? "trajectory" : "stress", arguments);
}

static void sum_up(const struct stress_output *out, struct row *r)
{
  for (int i = 0; i < r->cases; i++) {
    const struct stress_case *s = &out->stressed[i];
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

static double choose(const struct stress_output *out, const struct row *r, const struct measure *m)
{
  size_t count = 0;
  if (m->quantile == WORST)
    return r->worst ? m->of(r->worst) : NAN;
  for (int i = 0; i < r->cases; i++)
    for (int q = 0; q < QUANTITIES; q++) {
      const struct stress_number *n = &out->stressed[i].number[q];
      if (n->judged && !isnan(m->of(n)))
        out->values[count++] = m->of(n);
    }
  gsl_sort(out->values, 1, count);
  return count > 0 ? gsl_stats_quantile_from_sorted_data(out->values, 1, count, m->quantile) : NAN;
}

static void write_row(struct stress_output *out, const struct row *r)
{
  struct table *t = &out->table;
  char arguments[STRESS_ARGUMENTS] = "-";
  const int counts[] = { r->cases, r->refused, r->undecided, r->other_modes };
  table_text(t, r->family->name);
  table_text(t, r->gait->name);
  for (size_t i = 0; i < sizeof counts / sizeof *counts; i++)
    table_count(t, counts[i]);
  table_text(t, r->worst ? r->quantity : "-");
  for (int m = 0; m < MEASURES; m++)
    table_rounded(t, choose(out, r, &measures[m]), measures[m].format);
  table_text(t, verdict(r->bound, r->broken > 1));
  if (r->worst)
    stress_arguments(r->worst_at, arguments);
  table_text(t, arguments);
  table_flush(t);
}

static void judge_row(struct stress_output *out, struct row *r)
{
  progress_show("%s, %s gait", r->family->name, r->gait->name);
  r->cases = stress_make(r->family, r->gait, (unsigned long)out->options->seed.value, r->cases, out->stressed);
  for (int i = 0; i < r->cases; i++)
    out->stressed[i].periods *= out->effort->periods;
  judge_all(out, r->cases);
  sum_up(out, r);
  progress_end();
  write_row(out, r);
}

static bool begin(struct stress_output *out)
{
  static const char *const before[] = { "family",    "gait",        "cases",    "refused",
                                        "undecided", "other_modes", "quantity", NULL };
  static const char *const after[] = { "verdict", "worst_at", NULL };
  const struct stress_options *o = out->options;
  const struct point *p = &o->request.point;
  struct table *t = &out->table;
  const char *cases = o->cases.value > 0 ? wrong_text(" --cases %ld", o->cases.value) : "";
  if (!table_head(t, &o->request.style, "stress%s%s%s%s%s%s%s --seed %ld", o->family ? " --family " : "",
                  o->family ? o->family : "", p->has_gait ? " --gait " : "", p->has_gait ? p->crawler.gait->name : "",
                  o->full ? " --full" : "", o->check ? " --check" : "", cases, o->seed.value))
    return false;
  table_note(t, "unit: max(ulp of the certified value, sum over the parameters of what an ulp of each changes it by)");
  table_note(t, "bounds, in units: error %d, spread over the rounding modes %d, over parameters an ulp apart %d",
             STRESS_BOUND, STRESS_ROUNDING, STRESS_PERTURBED);
  for (const struct row *r = out->row; r < out->row + out->rows; r++)
    if (r == out->row || r->family != r[-1].family)
      table_note(t, "%s: %s", r->family->name, r->family->about);
  begin_rows(t, before, true, after);
  return true;
}

static enum exit_code write_rows(struct stress_output *out)
{
  bool broken = false;
  if (!begin(out))
    return EXIT_FILE;
  for (struct row *r = out->row; r < out->row + out->rows && !table_failed(&out->table); r++) {
    judge_row(out, r);
    broken |= r->broken > 0;
  }
  return !table_close(&out->table) ? EXIT_FILE : out->options->check && broken ? EXIT_CHECK_FAILED : EXIT_DONE;
}

enum exit_code stress_table(const struct stress_options *o)
{
  struct stress_output out = { .options = o, .effort = o->full ? &full : o->check ? &quick : &usual, .max_cases = 1 };
  enum exit_code code = plan(&out);
  if (code == EXIT_DONE)
    code = write_rows(&out);
  free(out.stressed);
  free(out.values);
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
    complain("stress", "a bound is exceeded: see the column 'verdict'");
  if (!table_close(&t))
    return EXIT_FILE;
  return s.outcome == STRESS_REFUSED ? EXIT_UNSOLVED : broken && o->check ? EXIT_CHECK_FAILED : EXIT_DONE;
}
