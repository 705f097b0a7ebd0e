/* scallop breakdown, for one crawler. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/defaults.h"
#include "compare/breakdown/asked.h"
#include "compare/breakdown/events.h"
#include "compare/breakdown/motion.h"
#include "compare/breakdown/radius.h"
#include "compare/breakdown/reach.h"
#include "compare/text/progress.h"
#include "compare/text/table.h"
#include "model/version.h"

static const char *const columns[] = { "what",   "quantity", "series", "order", "tolerance", "T",
                                       "froude", "error",    "modes",  "note",  "status",    NULL };

/* Terms below T^MANY tell the best order, and where the poles of a rational function are. */
enum { MANY = 96, MANY_BITS = 1024, BOUND_BITS = 128 };
struct sought {
  bool done, found;
  struct scallop_singularity singularity;
};

struct report {
  const struct breakdown_options *options;
  struct motion motion;
  struct expansions expansions, many;
  struct events events;
  struct sought sought[2]; /* of all crossings; of the first */
  struct exact_cache *cache;
  struct table table;
  long rows;
  struct progress progress;
};

static bool is_wanted(const struct report *r, const char *what)
{
  return !r->options->only || strcmp(r->options->only, what) == 0;
}

static bool is_wanted_quantity(const struct report *r, enum quantity_id quantity)
{
  const char *only = r->options->quantity;
  return motion_has(&r->motion, quantity) && (!only || strcmp(only, quantity_rows[quantity].name) == 0);
}

static bool is_wanted_source(const struct report *r, enum breakdown_source source)
{
  return !r->options->source.given || strcmp(r->options->source.value, breakdown_source_text(source)) == 0;
}

struct row {
  const char *what, *quantity, *series;
  double order, tolerance, T, error;
  const struct scallop_modes *modes;
  const char *note, *status;
};

/* With nothing but this */
static struct row row_of(const char *what, const char *quantity, double T)
{
  return (struct row){ .what = what,
                       .quantity = quantity,
                       .series = "-",
                       .order = NAN,
                       .tolerance = NAN,
                       .T = T,
                       .error = NAN,
                       .note = "-",
                       .status = "-" };
}

static void write_row(struct report *r, const struct row *row)
{
  struct table *t = &r->table;
  char modes[MOTION_MODES_TEXT];
  table_text(t, row->what);
  table_text(t, row->quantity);
  table_text(t, row->series);
  table_number(t, row->order);
  table_number(t, row->tolerance);
  table_number(t, row->T);
  table_number(t, motion_froude(&r->motion, row->T));
  table_rounded(t, row->error, "%.4g");
  table_text(t, row->modes ? motion_modes_text(modes, r->motion.of, row->modes) : "-");
  table_text(t, row->note);
  table_text(t, row->status);
  r->rows++;
}

/* A switching time leaves its piece; the modes stay. */
static bool is_piece_change(const struct event *e) { return strncmp(e->what, "switching time", 14) == 0; }

/* The modes at T, and whether the expansion is about the motion there. */
static const struct scallop_modes *modes_at(const struct report *r, double T)
{
  const struct scallop_modes *modes = r->events.first;
  for (long i = 0; i < r->events.count && r->events.event[i].T < T; i++)
    modes = r->events.event[i].modes;
  return modes;
}

static const char *where(const struct report *r, double T)
{
  static char text[200];
  const struct event *e = r->events.event, *modes = e;
  if (r->events.count == 0 || T <= e->T)
    return "below the first event";
  while (modes < e + r->events.count - 1 && is_piece_change(modes))
    modes++;
  if (modes == e)
    snprintf(text, sizeof text, "above the first event, T = %.6g: from there on the series does not describe the motion",
             e->T);
  else
    snprintf(text, sizeof text,
             "above T = %.6g, where a body turns in another piece of l' and the series is not exact any more; the modes "
             "change at T = %.6g",
             e->T, modes->T);
  return text;
}

/* The first row: the limit, and how far up its modes are proven to be those of the motion. */
static void write_limit(struct report *r)
{
  char note[120] = "the limit T -> 0";
  struct row row = row_of("event", "-", 0);
  const char *ends;
  arb_t T;
  arf_t least;
  arb_init(T);
  arf_init(least);
  row.modes = r->events.first;
  row.note = note;
  row.status = *expansions_modes(&r->expansions) ? "derived" : "double";
  if (r->motion.of == OF_STEADY
      && scallop_steady_modes_hold(&r->expansions.crawler, BOUND_BITS, T, &ends, NULL) == SCALLOP_OK) {
    arb_get_lbound_arf(least, T, BOUND_BITS);
    snprintf(note, sizeof note, "the limit T -> 0; these modes are proven up to T = %.4g",
             arf_get_d(least, ARF_RND_FLOOR) * (1 - 5e-4));
    row.status = "certified";
  }
  write_row(r, &row);
  arf_clear(least);
  arb_clear(T);
}

static void write_events(struct report *r)
{
  write_limit(r);
  for (const struct event *e = r->events.event; e < r->events.event + r->events.count; e++) {
    struct row row = row_of("event", "-", e->T);
    row.modes = e->modes;
    row.note = e->what;
    row.status = e->status;
    write_row(r, &row);
  }
}

/* The error is proven to be below the tolerance just below T, and not just above. Of gaits with many pieces a proof takes seconds, and
 * there would be hundreds. */
static bool is_proven(const struct comparison *c, double T, double tolerance)
{
  enum { DIGITS = 40, MOST_PIECES = 32 };
  const double off = 0x1p-50;
  const struct scallop_shape *phase = c->motion->crawler.gait->phase;
  return phase[0].count <= MOST_PIECES && phase[1].count <= MOST_PIECES
         && comparison_certified_side(c, T * (1 - off), tolerance, DIGITS) < 0
         && comparison_certified_side(c, T * (1 + off), tolerance, DIGITS) > 0;
}

static void write_reach(struct report *r, const struct comparison *c, double tolerance)
{
  char text[160];
  double T = comparison_reach(c, tolerance), limit = T == 0 ? comparison_limit(c) : NAN;
  struct row row = row_of("reach", quantity_rows[c->item.which.quantity].name, T);
  row.series = c->item.name;
  row.order = c->item.which.source == FROM_DERIVED ? (double)c->item.which.order : NAN;
  row.tolerance = tolerance;
  row.note = text;
  row.status = "binary128";
  if (T > 0 && isfinite(T)) {
    row.modes = modes_at(r, T);
    row.error = comparison_error(c, T);
    row.note = where(r, T);
    row.status = is_proven(c, T, tolerance) ? "certified" : row.status;
  } else if (isnan(T)) {
    snprintf(text, sizeof text,
             "there is no value: of the formula, where l'' = 0 at an end of a phase, or of the exact motion");
  } else if (T > 0) {
    snprintf(text, sizeof text, "for every T%s", r->events.count > 0 ? " up to permanent rest" : "");
  } else if (isnan(limit)) {
    snprintf(text, sizeof text, "the error does not fall below the tolerance as T -> 0");
  } else {
    snprintf(text, sizeof text, "the error tends to %.6g as T -> 0, which is not below the tolerance", limit);
    row.error = limit;
  }
  write_row(r, &row);
}

static void write_reaches(struct report *r, enum quantity_id quantity)
{
  static const double tolerances[] = { BREAKDOWN_TOLERANCES };
  enum { TOLERANCES = sizeof tolerances / sizeof *tolerances };
  struct comparison c = { &r->motion, &r->expansions, { .name = NULL }, r->cache };
  while (series_item_next(&c.item, &r->expansions, quantity, r->options->order.value)) {
    if (!is_wanted_source(r, c.item.which.source))
      continue;
    for (int i = 0; i < (r->options->tolerance.given ? 1 : TOLERANCES); i++)
      write_reach(r, &c, r->options->tolerance.given ? r->options->tolerance.value : tolerances[i]);
  }
}

static const char *which_first(const struct report *r, double radius)
{
  static char text[80];
  if (r->events.count == 0)
    return "nothing else ends it";
  snprintf(text, sizeof text, "the first event, T = %.6g, comes %s", r->events.event[0].T,
           r->events.event[0].T < radius ? "before" : "after");
  return text;
}

/* The singularity that the quantity depends on: looked for once */
static const struct scallop_singularity *singularity_for(struct report *r, enum quantity_id quantity)
{
  struct sought *sought = &r->sought[quantity == Q_T1];
  if (!sought->done) {
    progress_show(&r->progress, "singularities ...");
    sought->found = singularity_of(&sought->singularity, &r->many, quantity == Q_T1);
    sought->done = true;
  }
  return sought->found ? &sought->singularity : NULL;
}

static bool find_radius(struct radius *radius, struct report *r, enum quantity_id quantity)
{
  const struct series *s = expansions_of(&r->many, quantity);
  if (s && radius_from_poles(radius, s, MANY))
    return true;
  const struct scallop_singularity *found = s ? singularity_for(r, quantity) : NULL;
  if (found)
    radius_from_singularity(radius, found, quantity);
  return found;
}

static void write_radius(struct report *r, enum quantity_id quantity)
{
  struct radius radius = { .note = "there is no derived series" };
  char text[sizeof radius.note + 100];
  struct row row = row_of("radius", quantity_rows[quantity].name, NAN);
  row.note = radius.note;
  if (find_radius(&radius, r, quantity)) {
    snprintf(text, sizeof text, "%s; %s", radius.note, which_first(r, radius.T));
    row.series = radius.method;
    row.T = radius.T;
    row.error = isfinite(radius.T) ? fmax(radius.high - radius.T, radius.T - radius.low) : NAN;
    row.note = text;
    row.status = radius.status;
  }
  write_row(r, &row);
}

/* The order with the least |error| at T, of those below MANY; *error: that. False: the motion has no such value. */
static bool best_order(const struct report *r, enum quantity_id quantity, double T, const arb_struct *exact, slong *order,
                       double *error)
{
  const struct series *s = expansions_of(&r->many, quantity);
  *error = INFINITY;
  *order = 0;
  for (slong k = s->first; exact && k < MANY; k++) {
    if (series_coefficient_is_zero(s, k))
      continue;
    struct breakdown_series which = { FROM_DERIVED, k + 1, quantity };
    struct series_item item = { .which = which, .series = s, .before = k + 1, .name = "derived" };
    struct comparison c = { &r->motion, (struct expansions *)&r->many, item, NULL };
    double here = fabs(comparison_error_beside(&c, T, exact, MANY_BITS));
    if (here < *error) {
      *error = here;
      *order = k + 1;
    }
  }
  return isfinite(*error);
}

/* What more terms would do. */
static const char *beyond(const struct report *r, const struct series *s, double T, slong order)
{
  static char text[160];
  slong last = MANY - 1;
  while (last > 0 && series_coefficient_is_zero(s, last))
    last--;
  snprintf(text, sizeof text, "%s%s", order > last ? "more terms are better still; " : "", where(r, T));
  return text;
}

/* At T from a sixteenth of the first event, or of the natural time, to four times that, by steps of a square root of 2. */
enum { BEST_BELOW = 8, BEST_ABOVE = 4, BEST = BEST_BELOW + 1 + BEST_ABOVE };

static double best_time(const struct report *r, int i)
{
  double about = r->events.count > 0 ? r->events.event[0].T : motion_natural_time(&r->motion);
  return i == BEST_BELOW ? about * (1 - 1e-9) : about * exp2((i - BEST_BELOW) / 2.0);
}

/* exact: the certified answers at these times. */
static void write_best(struct report *r, enum quantity_id quantity, const struct ball_answer exact[BEST])
{
  const struct series *s = expansions_of(&r->many, quantity);
  for (int i = 0; s && i < BEST; i++) {
    struct row row = row_of("best", quantity_rows[quantity].name, best_time(r, i));
    slong order;
    if (!best_order(r, quantity, row.T, exact[i].value[quantity], &order, &row.error))
      continue;
    row.series = "derived";
    row.order = (double)order;
    row.modes = modes_at(r, row.T);
    row.note = beyond(r, s, row.T, order);
    row.status = "certified";
    write_row(r, &row);
  }
}

static void write_rows(struct report *r)
{
  enum { DIGITS = 200 };
  struct ball_answer exact[BEST];
  for (int i = 0; i < BEST; i++) {
    const struct motion at = motion_at(&r->motion, best_time(r, i));
    ball_answer_init(&exact[i]);
    if (is_wanted(r, "best"))
      answer_of_doubles(&exact[i], &at, DIGITS);
  }
  if (is_wanted(r, "event") && !r->options->quantity)
    write_events(r);
  for (int i = 0; i < QUANTITIES; i++) {
    enum quantity_id q = (enum quantity_id)i;
    if (!is_wanted_quantity(r, q))
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

/* Why there is no derived series */
static const char *why_none(const struct report *r)
{
  const struct series_answer *a = &r->expansions.derived;
  return a->why ? a->why : scallop_status_text(a->status);
}

static bool begin(struct report *r)
{
  struct table *t = &r->table;
  bool steady = r->motion.of == OF_STEADY;
  if (!table_open(t, &r->options->request.style))
    return false;
  table_note(t, "scallop " SCALLOP_VERSION);
  table_note(t, "command: breakdown");
  /* T is what is looked for; a phase is one of duration T */
  note_parameters(t, &r->options->request.point, (const char *const[]){ "T", steady ? NULL : "alpha", NULL }, false);
  if (!steady) {
    char v0[NUMBER_TEXT];
    number_text(v0, r->motion.v0, 0);
    table_note(t, "%s from v0 = %s; T: its duration", r->motion.phase == SCALLOP_EXTENSION ? "extension" : "contraction",
               v0);
  }
  if (r->expansions.derived.status != SCALLOP_OK)
    table_note(t, "no derived series: %s", why_none(r));
  table_note(t, "modes may change and change back unseen within a 256th of an octave of T, from T = %.3g to %.3g",
             r->events.from, r->events.until);
  table_columns(t, columns);
  table_begin_rows(t);
  return true;
}

static enum exit_code report(struct report *r)
{
  bool looks_far = is_wanted(r, "radius") || is_wanted(r, "best");
  if (r->expansions.derived.status != SCALLOP_OK && looks_far && r->options->only) {
    complain("breakdown", "no derived series: %s", why_none(r));
    return EXIT_UNSOLVED;
  }
  expansions_init(&r->many, &r->motion, looks_far ? MANY : 1, MANY_BITS);
  progress_show(&r->progress, "events ...");
  events_find(&r->events, &r->motion, expansions_modes(&r->expansions));
  progress_end(&r->progress);
  enum exit_code code = EXIT_FILE;
  if (begin(r)) {
    write_rows(r);
    progress_end(&r->progress);
    code = !table_close(&r->table) ? EXIT_FILE : r->rows > 0 ? EXIT_DONE : EXIT_UNSOLVED;
    if (code == EXIT_UNSOLVED)
      complain("breakdown", "no row: %s",
               r->expansions.derived.status != SCALLOP_OK ? why_none(r)
                                                          : "there is no such series of this quantity, or all of it is 0");
  }
  events_clear(&r->events);
  expansions_clear(&r->many);
  return code;
}

enum exit_code breakdown_table(const struct breakdown_options *o)
{
  static struct report r;
  struct scallop_scaled scaled;
  enum quantity_of of = o->request.point.has_phase || o->request.point.has_v0 ? OF_PHASE : OF_STEADY;
  if (!breakdown_is_sound(o, of))
    return EXIT_USAGE;
  enum scallop_status status = scallop_scale(&o->request.point.crawler, &scaled);
  if (status != SCALLOP_OK) {
    complain("breakdown", "%s", scallop_status_text(status));
    return EXIT_UNSOLVED;
  }
  r = (struct report){ .options = o,
                       .motion = motion_of(&o->request.point, of),
                       .progress = progress_begin(o->request.style.quiet) };
  r.cache = exact_cache_new(&r.motion);
  expansions_init(&r.expansions, &r.motion, o->order.value, BREAKDOWN_BITS);
  for (int i = 0; i < 2; i++)
    scallop_singularity_init(&r.sought[i].singularity);
  enum exit_code code = EXIT_UNSOLVED;
  if (r.cache)
    code = report(&r);
  else
    complain("breakdown", "out of memory");
  for (int i = 0; i < 2; i++)
    scallop_singularity_clear(&r.sought[i].singularity);
  expansions_clear(&r.expansions);
  free(r.cache);
  return code;
}
