/* scallop breakdown, for one crawler. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/points/defaults.h"
#include "compare/book/book.h"
#include "compare/breakdown/events.h"
#include "compare/breakdown/radius.h"
#include "compare/breakdown/reach.h"
#include "compare/breakdown/study.h"
#include "compare/text/progress.h"
#include "compare/text/table.h"

enum { BOUND_BITS = 128 };

struct report {
  const struct breakdown_options *options;
  struct study study;
  struct sought { /* a singularity: of all crossings; of the first */
    bool done, found;
    struct scallop_singularity singularity;
  } sought[2];
  struct table table;
  long rows;
  struct progress progress;
};

static bool is_wanted(const struct report *r, const char *what)
{
  return !r->options->only.given || strcmp(r->options->only.value, what) == 0;
}

struct row { /* a text that is NULL is a dash */
  const char *what, *quantity, *series;
  double order, tolerance /* 0: none */, T, froude, error;
  const struct scallop_modes *modes;
  const char *note, *status;
  const struct motion *motion;
};

static void put_text(struct table *t, const struct table_column *c, const void *row)
{
  const char *text = *(const char *const *)((const char *)row + c->at);
  table_text(t, text ? text : "-");
}

static void put_modes(struct table *t, const struct table_column *c, const void *row)
{
  const struct row *r = row;
  char modes[MOTION_MODES_TEXT];
  (void)c;
  table_text(t, r->modes ? motion_modes_text(modes, r->motion->of, r->modes) : "-");
}

static const struct table_column columns[] = {
  { TABLE_COLUMN("what", put_text, offsetof(struct row, what)) },
  { TABLE_COLUMN("quantity", put_text, offsetof(struct row, quantity)) },
  { TABLE_COLUMN("series", put_text, offsetof(struct row, series)) },
  { TABLE_COLUMN("order", column_number, offsetof(struct row, order)) },
  { TABLE_COLUMN("tolerance", column_number, offsetof(struct row, tolerance)) },
  { TABLE_COLUMN("T", column_number, offsetof(struct row, T)) },
  { TABLE_COLUMN("froude", column_number, offsetof(struct row, froude)) },
  { TABLE_COLUMN("error", column_rounded, offsetof(struct row, error)), .format = "%.4g" },
  { TABLE_COLUMN("modes", put_modes, 0) },
  { TABLE_COLUMN("note", put_text, offsetof(struct row, note)) },
  { TABLE_COLUMN("status", put_text, offsetof(struct row, status)) },
  { .name = NULL }
};

static void write_row(struct report *r, struct row row)
{
  row.motion = &r->study.motion;
  row.froude = motion_froude(row.motion, row.T);
  row.tolerance = row.tolerance > 0 ? row.tolerance : NAN;
  table_row(&r->table, columns, &row, true);
  r->rows++;
}

/* The first row: the limit, and how far up its modes are proven to be those of the motion. */
static void write_limit(struct report *r)
{
  char note[120] = "the limit T -> 0";
  struct row row = { "event", .order = NAN, .error = NAN, .modes = r->study.events.first, .note = note };
  const char *ends;
  SCOPED(arb, T);
  SCOPED(arf, least);
  row.status = *expansions_modes(&r->study.expansions) ? "derived" : "double";
  if (r->study.motion.of == OF_STEADY
      && scallop_steady_modes_hold(&r->study.expansions.crawler, BOUND_BITS, T, &ends, NULL) == SCALLOP_OK) {
    arb_get_lbound_arf(least, T, BOUND_BITS);
    snprintf(note, sizeof note, "the limit T -> 0; these modes are proven up to T = %.4g",
             arf_get_d(least, ARF_RND_FLOOR) * (1 - 5e-4));
    row.status = "certified";
  }
  write_row(r, row);
}

static void write_events(struct report *r)
{
  write_limit(r);
  for (const struct event *e = r->study.events.event; e < r->study.events.event + r->study.events.count; e++)
    write_row(r, (struct row){ "event", .T = e->T, .order = NAN, .error = NAN, .modes = e->modes, .note = e->what,
                               .status = e->status });
}

static void write_reversals(struct report *r)
{
  const struct reversal *v = r->study.events.reversal, *end = v + r->study.events.reversals;
  for (; v < end; v++)
    write_row(r, (struct row){ "reversal", "displacement", .T = v->T, .order = NAN, .error = NAN,
                               .modes = study_modes_at(&r->study, v->T), .status = v->status,
                               .note = v->sign > 0 ? "the direction of crawling reverses: from here on forward"
                                                   : "the direction of crawling reverses: from here on backward" });
}

/* The error is proven to be below the tolerance just below T, and not just above. Of gaits with many pieces a proof
 * takes seconds, and there would be hundreds. */
static bool is_proven(const struct comparison *c, double T)
{
  enum { DIGITS = 40, MOST_PIECES = 32 };
  const double off = 0x1p-50;
  const struct scallop_shape *phase = c->expansions->motion->crawler.gait->phase;
  return phase[0].count <= MOST_PIECES && phase[1].count <= MOST_PIECES
         && comparison_certified_side(c, T * (1 - off), DIGITS) < 0
         && comparison_certified_side(c, T * (1 + off), DIGITS) > 0;
}

static void write_reach(struct report *r, const struct comparison *c)
{
  char text[160];
  double T = comparison_reach(c), limit = T == 0 ? comparison_limit(c) : NAN;
  struct row row = { "reach", .T = T, .error = limit, .note = text, .status = "binary128" };
  row.quantity = quantity_rows[c->item.quantity].name;
  row.series = c->item.name;
  row.order = c->item.source == FROM_DERIVED ? (double)c->item.before : NAN;
  row.tolerance = c->tolerance;
  if (T > 0 && isfinite(T)) {
    row.modes = study_modes_at(&r->study, T);
    row.error = comparison_error(c, T);
    row.note = study_where(&r->study, T);
    row.status = is_proven(c, T) ? "certified" : row.status;
  } else if (isnan(T)) {
    row.note = "there is no value: of the formula, where l'' = 0 at an end of a phase, or of the exact motion";
  } else if (T > 0) {
    row.note = r->study.events.count > 0 ? "for every T up to permanent rest" : "for every T";
  } else if (isnan(limit)) {
    row.note = "the error does not fall below the tolerance as T -> 0";
  } else {
    snprintf(text, sizeof text, "the error tends to %.6g as T -> 0, which is not below the tolerance", limit);
  }
  write_row(r, row);
}

static void write_reaches(struct report *r, enum quantity_id quantity)
{
  static const double usual[] = { BREAKDOWN_TOLERANCES };
  const struct given_number *given = &r->options->tolerance;
  struct series_item items[MOST_ITEMS];
  int count = series_items(items, &r->study.expansions, quantity, r->options->order.value);
  for (int i = 0; i < count; i++)
    for (int k = 0; k < (given->given ? 1 : (int)(sizeof usual / sizeof *usual)); k++)
      if (breakdown_takes(r->options, items[i].source))
        write_reach(r, &(struct comparison){ &r->study.expansions, items[i], r->study.cache,
                                             given->given ? given->value : usual[k] });
}

static const char *which_first(const struct report *r, double radius)
{
  static char text[80];
  if (r->study.events.count == 0)
    return "nothing else ends it";
  snprintf(text, sizeof text, "the first event, T = %.6g, comes %s", r->study.events.event[0].T,
           r->study.events.event[0].T < radius ? "before" : "after");
  return text;
}

/* False: radius.note says why there is none. */
static bool find_radius(struct radius *radius, struct report *r, enum quantity_id quantity)
{
  const struct series *s = expansions_of(&r->study.many, quantity);
  struct sought *sought = &r->sought[quantity == Q_T1];
  if (s && radius_from_poles(radius, s, STUDY_MANY))
    return true;
  *radius = (struct radius){ .note = "there is no derived series" };
  if (s && !sought->done) { /* once for all quantities that depend on it */
    scallop_singularity_init(&sought->singularity);
    progress_show(&r->progress, "singularities ...");
    sought->found = singularity_of(&sought->singularity, &r->study.many, quantity == Q_T1);
    sought->done = true;
  }
  if (s && sought->found)
    radius_from_singularity(radius, &sought->singularity, quantity);
  return s && sought->found;
}

static void write_radius(struct report *r, enum quantity_id quantity)
{
  struct radius radius;
  char text[sizeof radius.note + 100];
  struct row row = { "radius", .T = NAN, .order = NAN, .error = NAN, .note = radius.note };
  row.quantity = quantity_rows[quantity].name;
  if (find_radius(&radius, r, quantity)) {
    snprintf(text, sizeof text, "%s; %s", radius.note, which_first(r, radius.T));
    row.series = radius.method;
    row.T = radius.T;
    row.error = isfinite(radius.T) ? fmax(radius.high - radius.T, radius.T - radius.low) : NAN;
    row.note = text;
    row.status = radius.status;
  }
  write_row(r, row);
}

/* What more terms would do. */
static const char *beyond(const struct report *r, enum quantity_id quantity, double T, slong order)
{
  static char text[240];
  snprintf(text, sizeof text, "%s%s",
           study_gains_from_more(&r->study, quantity, order) ? "more terms are better still; " : "",
           study_where(&r->study, T));
  return text;
}

/* At T from a sixteenth of the first event, or of the natural time, to four times that, by steps of a square root of
 * 2. */
enum { BEST_BELOW = 8, BEST_ABOVE = 4, BEST = BEST_BELOW + 1 + BEST_ABOVE };

static double best_time(const struct report *r, int i)
{
  double about = r->study.events.count > 0 ? r->study.events.event[0].T : motion_natural_time(&r->study.motion);
  return i == BEST_BELOW ? about * (1 - 1e-9) : about * exp2((i - BEST_BELOW) / 2.0);
}

/* exact: the certified answers at these times. */
static void write_best(struct report *r, enum quantity_id quantity, const struct ball_answer exact[BEST])
{
  const struct series *s = expansions_of(&r->study.many, quantity);
  for (int i = 0; s && i < BEST; i++) {
    double T = best_time(r, i), error;
    slong order;
    if (study_best_order(&r->study, quantity, T, exact[i].value[quantity], &order, &error))
      write_row(r, (struct row){ "best", quantity_rows[quantity].name, "derived", (double)order, 0, T, 0, error,
                                 study_modes_at(&r->study, T), beyond(r, quantity, T, order), "certified", NULL });
  }
}

static void write_rows(struct report *r, enum quantity_id only)
{
  enum { DIGITS = 200 };
  struct ball_answer exact[BEST];
  for (int i = 0; i < BEST; i++) {
    const struct motion at = motion_at(&r->study.motion, best_time(r, i));
    ball_answer_init(&exact[i]);
    if (is_wanted(r, "best"))
      answer_of_doubles(&exact[i], &at, DIGITS);
  }
  if (is_wanted(r, "event") && !r->options->quantity)
    write_events(r);
  if (is_wanted(r, "reversal") && (!r->options->quantity || only == Q_DISPLACEMENT))
    write_reversals(r);
  for (int i = 0; i < QUANTITIES; i++) {
    enum quantity_id q = (enum quantity_id)i;
    if (!motion_has(&r->study.motion, q) || (r->options->quantity && q != only))
      continue;
    progress_show(&r->progress, "%s ...", quantity_rows[q].name);
    if (is_wanted(r, "reach"))
      write_reaches(r, q);
    if (is_wanted(r, "radius"))
      write_radius(r, q);
    if (is_wanted(r, "best"))
      write_best(r, q, exact);
  }
  for (int i = 0; i < BEST; i++)
    ball_answer_clear(&exact[i]);
}

static bool begin(struct report *r)
{
  struct table *t = &r->table;
  bool steady = r->study.motion.of == OF_STEADY;
  if (!table_head(t, &r->options->request.style, "breakdown"))
    return false;
  if (r->options->request.book)
    table_note(t, "book: %s", r->options->request.book);
  /* T is what is looked for; a phase is one of duration T */
  note_parameters(t, &r->options->request.point, (const char *const[]){ "T", steady ? NULL : "alpha", NULL }, false);
  if (!steady) {
    char v0[NUMBER_TEXT];
    number_text(v0, r->study.motion.v0, 0);
    table_note(t, "%s from v0 = %s; T is its duration, not the period",
               r->study.motion.phase == SCALLOP_EXTENSION ? "extension" : "contraction", v0);
  }
  if (r->study.expansions.derived.status != SCALLOP_OK)
    table_note(t, "no derived series: %s", study_why_none(&r->study));
  table_note(t, "modes may change and change back unseen within a 256th of an octave of T, from T = %.3g to %.3g",
             r->study.events.from, r->study.events.until);
  table_add(t, columns);
  table_begin_rows(t);
  return true;
}

static enum exit_code report(struct report *r, enum quantity_id only)
{
  bool looks_far = is_wanted(r, "radius") || is_wanted(r, "best"),
       derived = r->study.expansions.derived.status == SCALLOP_OK;
  if (!derived && looks_far && r->options->only.given) {
    complain("breakdown", "no derived series: %s", study_why_none(&r->study));
    return EXIT_UNSOLVED;
  }
  progress_show(&r->progress, "events ...");
  study_events(&r->study);
  progress_end(&r->progress);
  enum exit_code code = EXIT_FILE;
  if (begin(r)) {
    write_rows(r, only);
    progress_end(&r->progress);
    code = !table_close(&r->table) ? EXIT_FILE : r->rows > 0 ? EXIT_DONE : EXIT_UNSOLVED;
    if (code == EXIT_UNSOLVED)
      complain("breakdown", "no row: %s",
               is_wanted(r, "reversal") ? "the displacement has the same sign at every T"
               : derived                ? "there is no such series of this quantity, or all of it is 0"
                                        : study_why_none(&r->study));
  }
  return code;
}

/* The quantity of a motion that rows are about; QUANTITIES: any */
struct asked {
  struct motion motion;
  enum quantity_id quantity;
};

static bool is_asked(const void *context, const struct scallop_formula *f)
{
  const struct asked *asked = context;
  bool is = false;
  for (int q = 0; q < QUANTITIES && !is; q++)
    is = (asked->quantity == QUANTITIES || (int)asked->quantity == q)
         && series_is_about(f, &asked->motion, (enum quantity_id)q);
  return is;
}

static bool serves(const struct breakdown_options *o, enum quantity_of of, enum quantity_id only)
{
  const struct asked asked = { motion_of(&o->request.point, of), o->quantity ? only : QUANTITIES };
  char what[80] = "this motion";
  if (o->quantity)
    snprintf(what, sizeof what, "the %s of this motion", o->quantity);
  return book_serves("breakdown", o->request.book, is_asked, &asked, what);
}

enum exit_code breakdown_table(const struct breakdown_options *o)
{
  struct report r = { .options = o, .progress = progress_begin(o->request.style.quiet) };
  enum quantity_of of = o->request.point.has_phase || o->request.point.has_v0 ? OF_PHASE : OF_STEADY;
  enum quantity_id only;
  if (!breakdown_quantity(&only, o, of) || !breakdown_is_sound(o) || !serves(o, of, only))
    return EXIT_USAGE;
  bool looks_far = is_wanted(&r, "radius") || is_wanted(&r, "best");
  const char *why = study_begin(&r.study, &o->request.point, of, o->order.value, looks_far ? STUDY_MANY : 1);
  if (why)
    complain("breakdown", "%s", why);
  enum exit_code code = why ? EXIT_UNSOLVED : report(&r, only);
  for (int i = 0; i < 2; i++)
    if (r.sought[i].done)
      scallop_singularity_clear(&r.sought[i].singularity);
  study_clear(&r.study);
  return code;
}
