/* Table of `scallop breakdown` for one crawler. */
#include <math.h>
#include <string.h>

#include "compare/points/defaults.h"
#include "compare/points/gaits.h"
#include "compare/formulas/formula_file.h"
#include "compare/breakdown/motion.h"
#include "compare/text/progress.h"
#include "compare/tables/table.h"

struct breakdown_output {
  const struct breakdown_options *options;
  struct study study;
  struct table table;
  long rows;
};

static bool is_requested(const struct breakdown_output *r, const char *kind)
{
  return !r->options->only.given || strcmp(r->options->only.value, kind) == 0;
}

static bool is_about(const struct breakdown_output *r, enum quantity_id q)
{
  const struct optional_word *only = &r->options->quantity;
  return motion_has(&r->study.motion, q) && (!only->given || strcmp(only->value, quantity_rows[q].name) == 0);
}

struct row {
  const char *kind, *quantity, *series;
  double order, tolerance, T, froude, error, low, high;
  const struct scallop_modes *modes; /* or NULL */
  const char *modes_text, *note, *evidence;
};

static struct row row_of(const struct breakdown_output *r, const char *kind, enum quantity_id quantity,
                         const char *series, double T)
{
  const char *name = quantity < QUANTITIES ? quantity_rows[quantity].name : "-";
  double froude = motion_froude(&r->study.motion, T);
  return (struct row){ kind, name, series, NAN, NAN, T, froude, NAN, NAN, NAN, NULL, "-", "-", "-" };
}

#define AT(member) offsetof(struct row, member)
static const struct table_column columns[] = {
  { TABLE_COLUMN("kind", column_text, AT(kind)) },
  { TABLE_COLUMN("quantity", column_text, AT(quantity)) },
  { TABLE_COLUMN("series", column_text, AT(series)) },
  { TABLE_COLUMN("order", column_number, AT(order)) },
  { TABLE_COLUMN("tolerance", column_number, AT(tolerance)) },
  { TABLE_COLUMN("T", column_number, AT(T)) },
  { TABLE_COLUMN("froude", column_number, AT(froude)) },
  { TABLE_COLUMN("error", column_rounded, AT(error)), .format = "%.4g" },
  { TABLE_COLUMN("modes", column_text, AT(modes_text)) },
  { TABLE_COLUMN("note", column_text, AT(note)) },
  { TABLE_COLUMN("evidence", column_text, AT(evidence)) },
  { .name = NULL },
};
/* Interval of T, for a measured gait */
static const struct table_column of_recording[] = {
  { TABLE_COLUMN("low", column_number, AT(low)) },
  { TABLE_COLUMN("high", column_number, AT(high)) },
  { .name = NULL },
};

static bool is_recorded(const struct breakdown_output *r) { return gait_file_of(r->study.motion.crawler.gait) != NULL; }

static void write_row(struct breakdown_output *r, struct row *row, const char *note, const char *evidence)
{
  char modes[MOTION_MODES_TEXT];
  row->modes_text = row->modes ? motion_modes_text(modes, r->study.motion.of, row->modes) : "-";
  row->note = note;
  row->evidence = evidence;
  table_row(&r->table, columns, row, true);
  if (is_recorded(r))
    table_row(&r->table, of_recording, row, true);
  r->rows++;
}

/* Writes the first row: the limit, and the T up to which the motion is proven to have its modes. */
static void write_limit(struct breakdown_output *r)
{
  enum { BITS = 128 };
  struct row row = row_of(r, "transition", QUANTITIES, "-", 0);
  const char *ends;
  SCOPED(arb, T);
  SCOPED(arf, least);
  bool proven = r->study.motion.of == OF_STEADY
                && scallop_steady_modes_hold(&r->study.crawler, BITS, T, &ends, NULL) == SCALLOP_OK;
  arb_get_lbound_arf(least, T, BITS);
  const char *note = !proven ? "the limit T -> 0"
                             : wrong_text("the limit T -> 0; these modes are proven up to T = %.4g",
                                          arf_get_d(least, ARF_RND_FLOOR) * (1 - 5e-4));
  row.modes = r->study.transitions.first;
  write_row(r, &row, note, proven ? "certified" : *r->study.derived.modes ? "derived" : "double");
}

static void write_changes(struct breakdown_output *r, const char *kind, enum quantity_id of, const struct transition *e,
                          long count)
{
  for (const struct transition *end = e + count; e < end; e++) {
    struct row row = row_of(r, kind, of, "-", e->T);
    row.modes = e->modes;
    row.low = e->T - e->error;
    row.high = e->T + e->error;
    write_row(r, &row, e->causes, e->evidence);
  }
}

static void write_reach(struct breakdown_output *r, const struct comparison *c)
{
  const char *note, *evidence = "binary128";
  double T = comparison_reach(c);
  struct row row = row_of(r, "reach", c->item.quantity, series_name(&c->item), T);
  row.order = c->item.source == FROM_DERIVED ? (double)c->item.before : NAN;
  row.tolerance = c->tolerance;
  if (isnan(T)) {
    note = "there is no value: of the formula, where l'' = 0 at an end of a phase, or of the exact motion";
  } else if (isinf(T)) {
    note = r->study.transitions.count > 0 ? "for every T up to permanent rest" : "for every T";
  } else if (T > 0) {
    row.modes = transitions_modes_at(&r->study.transitions, T);
    row.error = comparison_error(c, T);
    note = study_position_text(&r->study, T);
    evidence = comparison_is_proven(c, T) ? "certified" : evidence;
  } else {
    row.error = comparison_limit(c);
    note = isnan(row.error)
               ? "the error does not fall below the tolerance as T -> 0"
               : wrong_text("the error tends to %.6g as T -> 0, which is not below the tolerance", row.error);
  }
  write_row(r, &row, note, evidence);
}

static void write_reaches(struct breakdown_output *r, enum quantity_id quantity)
{
  static const double usual[] = { BREAKDOWN_TOLERANCES };
  const struct optional_number *given = &r->options->tolerance;
  struct series_item items[MAX_ITEMS];
  int count = series_items(items, &r->study, quantity, r->options->order.value);
  for (int i = 0; i < count; i++)
    for (int k = 0; k < (given->given ? 1 : (int)(sizeof usual / sizeof *usual)); k++)
      if (breakdown_takes(r->options, items[i].source))
        write_reach(r, &(struct comparison){ &r->study, items[i], given->given ? given->value : usual[k] });
}

static void write_radius(struct breakdown_output *r, enum quantity_id quantity)
{
  const struct transition *first = r->study.transitions.count > 0 ? r->study.transitions.transition : NULL;
  struct radius radius;
  char note[sizeof radius.note + 100];
  if (!radius_of(&radius, &r->study, quantity))
    snprintf(note, sizeof note, "%s", radius.note);
  else if (!first)
    snprintf(note, sizeof note, "%s; nothing else ends it", radius.note);
  else
    snprintf(note, sizeof note, "%s; the first transition, T = %.6g, comes %s", radius.note, first->T,
             first->T < radius.T ? "before" : "after");
  struct row row = row_of(r, "radius", quantity, radius.method, radius.T);
  row.error = fmax(radius.high - radius.T, radius.T - radius.low); /* nan if both are infinite */
  write_row(r, &row, note, radius.evidence);
}

/* Rows of the best order: T from a sixteenth of the first transition, or of the natural time, to four times this value,
 * by factors of sqrt(2) */
enum { BEST_BELOW = 8, BEST_ABOVE = 4, BEST = BEST_BELOW + 1 + BEST_ABOVE };

static double time_of_best(const struct breakdown_output *r, int i)
{
  double about = r->study.transitions.count > 0 ? r->study.transitions.transition[0].T
                                                : motion_natural_time(&r->study.motion);
  return i == BEST_BELOW ? about * (1 - 1e-9) : about * exp2((i - BEST_BELOW) / 2.0);
}

static void write_best(struct breakdown_output *r, enum quantity_id quantity)
{
  for (int i = 0; i < BEST; i++) {
    struct row row = row_of(r, "best", quantity, "derived", time_of_best(r, i));
    const struct best_order best = study_best_order(&r->study, quantity, row.T);
    if (isinf(best.error))
      continue;
    row.order = (double)best.order;
    row.error = best.error;
    row.modes = transitions_modes_at(&r->study.transitions, row.T);
    const char *more = best.gains_from_more ? "more terms are better still; " : "";
    write_row(r, &row, wrong_text("%s%s", more, study_position_text(&r->study, row.T)), "certified");
  }
}

static void write_rows(struct breakdown_output *r)
{
  const struct transitions *e = &r->study.transitions;
  if (is_requested(r, "transition") && !r->options->quantity.given) {
    write_limit(r);
    write_changes(r, "transition", QUANTITIES, e->transition, e->count);
  }
  if (is_requested(r, "reversal") && is_about(r, Q_DISPLACEMENT))
    write_changes(r, "reversal", Q_DISPLACEMENT, e->reversal, e->reversals);
  for (enum quantity_id q = 0; q < QUANTITIES; q++) {
    if (!is_about(r, q))
      continue;
    progress_show("%s ...", quantity_rows[q].name);
    if (is_requested(r, "reach"))
      write_reaches(r, q);
    if (is_requested(r, "radius"))
      write_radius(r, q);
    if (is_requested(r, "best"))
      write_best(r, q);
  }
}

static bool begin(struct breakdown_output *r)
{
  const struct request *request = &r->options->request;
  const struct motion *m = &r->study.motion;
  struct table *t = &r->table;
  if (!table_head(t, &request->style, "breakdown"))
    return false;
  if (request->formulas)
    table_note(t, "formulas: %s", request->formulas);
  /* T is in the rows; a phase has duration T, whatever alpha is */
  note_parameters(t, &request->point, (const char *const[]){ "T", m->of == OF_STEADY ? NULL : "alpha", NULL }, false);
  if (m->of == OF_PHASE) {
    char v0[NUMBER_TEXT];
    number_text(v0, m->v0, 0);
    table_note(t, "%s from v0 = %s; T is its duration, not the period", phase_names[m->phase], v0);
  }
  if (r->study.derived.status != SCALLOP_OK)
    table_note(t, "no derived series: %s", study_no_series_text(&r->study));
  table_note(t, "modes may change and change back unseen within a %dth of an octave of T, from T = %.3g to %.3g",
             r->study.transitions.per_octave, r->study.transitions.from, r->study.transitions.until);
  if (is_recorded(r))
    table_note(t, "%ld changes are left out that other curves through the recording do not have",
               r->study.transitions.left_out);
  table_add(t, columns);
  if (is_recorded(r))
    table_add(t, of_recording);
  table_begin_rows(t);
  return true;
}

static enum exit_code write_table(struct breakdown_output *r)
{
  bool derived = r->study.derived.status == SCALLOP_OK;
  if (!derived && r->options->only.given && (is_requested(r, "radius") || is_requested(r, "best"))) {
    complain("breakdown", "no derived series: %s", study_no_series_text(&r->study));
    return EXIT_UNSOLVED;
  }
  progress_show("transitions ...");
  study_transitions(&r->study);
  progress_end();
  if (!begin(r))
    return EXIT_FILE;
  write_rows(r);
  progress_end();
  if (!table_close(&r->table))
    return EXIT_FILE;
  if (r->rows > 0)
    return EXIT_DONE;
  complain("breakdown", "no row: %s",
           is_requested(r, "reversal") ? "the displacement has the same sign at every T"
           : derived                   ? "there is no such series of this quantity, or all of it is 0"
                                       : study_no_series_text(&r->study));
  return EXIT_UNSOLVED;
}

static bool is_of_a_row(const void *context, const struct scallop_formula *f)
{
  const struct breakdown_output *r = context;
  bool is = false;
  for (enum quantity_id q = 0; q < QUANTITIES; q++)
    is |= is_about(r, q) && series_is_about(f, &r->study.motion, q);
  return is;
}

static bool has_formulas(const struct breakdown_output *r)
{
  const struct optional_word *only = &r->options->quantity;
  const char *what = only->given ? wrong_text("the %s of this motion", only->value) : "this motion";
  return formula_file_applies("breakdown", r->options->request.formulas, is_of_a_row, r, what);
}

enum exit_code breakdown_table(const struct breakdown_options *o)
{
  const struct point *point = &o->request.point;
  enum quantity_of of = point->has_phase || point->has_v0 ? OF_PHASE : OF_STEADY;
  const struct motion motion = motion_of(point, of);
  struct breakdown_output r = { .options = o, .study.motion = motion };
  if (!has_formulas(&r))
    return EXIT_USAGE;
  const char *why = study_begin(&r.study, &motion, o->order.value);
  if (why)
    complain("breakdown", "%s", why);
  enum exit_code code = why ? EXIT_UNSOLVED : write_table(&r);
  study_clear(&r.study);
  return code;
}
