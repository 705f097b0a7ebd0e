/* scallop breakdown, for one crawler. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "compare/breakdown/parts.h"
#include "compare/command/with_flint.h"

static const char *const columns[] = { "what",   "quantity", "series", "order", "tolerance", "T",
                                       "froude", "error",    "modes",  "note",  "status",    NULL };

/* Terms below T^MANY tell the best order, and where the poles of a rational function are. */
enum { MANY = 96, MANY_BITS = 1024, BOUND_BITS = 128, DOUBLE_DIGITS = 17 };
/* Errors are known to some 1e-32. */
static const double LEAST_TOLERANCE = 1e-20;

struct sought {
  bool done, found;
  struct scallop_singularity singularity;
};

struct report {
  const struct options *options;
  struct subject subject;
  struct expansions expansions, many;
  struct events events;
  struct sought sought[2]; /* of all crossings; of the first */
  struct exact_cache *cache;
  struct table table;
  long rows;
  bool shown; /* on a terminal: what is being done                                           */
};

static void show(const struct report *r, const char *what)
{
  if (r->shown && what)
    fprintf(stderr, "\r\033[K%s ...", what);
  else if (r->shown)
    fprintf(stderr, "\r\033[K");
}

static bool is_wanted(const struct report *r, const char *what)
{
  return !r->options->only || strcmp(r->options->only, what) == 0;
}

static bool is_wanted_quantity(const struct report *r, enum quantity_id quantity)
{
  const char *only = r->options->quantity;
  return subject_has(&r->subject, quantity) && (!only || strcmp(only, quantity_rows[quantity].name) == 0);
}

static bool is_wanted_source(const struct report *r, enum breakdown_source source)
{
  static const char *const names[] = { "published", "derived", "limit" };
  return !r->options->has_source || strcmp(r->options->source, names[source]) == 0;
}

/* ---- rows ---- */

struct row {
  const char *what, *quantity, *series;
  double order, tolerance, T, error;
  const struct scallop_modes *modes;
  const char *note, *status;
};

static void write_row(struct report *r, const struct row *row)
{
  struct table *t = &r->table;
  char modes[2 * SCALLOP_MODES_TEXT + 4] = "-";
  if (row->modes)
    motion_modes_text(modes, r->subject.steady ? OF_STEADY : OF_PHASE, row->modes);
  table_text(t, row->what);
  table_text(t, row->quantity ? row->quantity : "-");
  table_text(t, row->series ? row->series : "-");
  table_number(t, row->order);
  table_number(t, row->tolerance);
  table_number(t, row->T);
  table_number(t, subject_froude(&r->subject, row->T));
  table_rounded(t, row->error, "%.4g");
  table_text(t, modes);
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
  for (int i = 0; i < r->events.count && r->events.event[i].T < T; i++)
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

/* ---- events ---- */

/* The first row: the limit, and how far up its modes are proven to be those of the motion. */
static void write_limit(struct report *r)
{
  char note[120] = "the limit T -> 0";
  const char *ends, *status = *expansions_modes(&r->expansions) ? "derived" : "double";
  arb_t T;
  arf_t least;
  arb_init(T);
  arf_init(least);
  if (r->subject.steady && scallop_steady_modes_hold(&r->expansions.crawler, BOUND_BITS, T, &ends, NULL) == SCALLOP_OK) {
    arb_get_lbound_arf(least, T, BOUND_BITS);
    snprintf(note, sizeof note, "the limit T -> 0; these modes are proven up to T = %.4g",
             arf_get_d(least, ARF_RND_FLOOR) * (1 - 5e-4));
    status = "certified";
  }
  write_row(r, &(struct row){ .what = "event",
                              .order = NAN,
                              .tolerance = NAN,
                              .T = 0,
                              .error = NAN,
                              .modes = r->events.first,
                              .note = note,
                              .status = status });
  arf_clear(least);
  arb_clear(T);
}

static void write_events(struct report *r)
{
  write_limit(r);
  for (int i = 0; i < r->events.count; i++) {
    const struct event *e = &r->events.event[i];
    write_row(r, &(struct row){ .what = "event",
                                .order = NAN,
                                .tolerance = NAN,
                                .T = e->T,
                                .error = NAN,
                                .modes = e->modes,
                                .note = e->what,
                                .status = e->status });
  }
}

/* ---- reach ---- */

/* The error is proven to be below the tolerance just below T, and not just above. Of gaits with many pieces a proof takes seconds, and
 * there would be hundreds. */
static bool is_proven(const struct comparison *c, double T, double tolerance)
{
  enum { DIGITS = 40, MOST_PIECES = 32 };
  const double off = 0x1p-50;
  const struct scallop_shape *phase = c->subject->crawler.gait->phase;
  return phase[0].count <= MOST_PIECES && phase[1].count <= MOST_PIECES
         && comparison_certified_side(c, T * (1 - off), tolerance, DIGITS) < 0
         && comparison_certified_side(c, T * (1 + off), tolerance, DIGITS) > 0;
}

static void write_reach(struct report *r, const struct comparison *c, double tolerance)
{
  char text[160];
  double T = comparison_reach(c, tolerance), limit = T == 0 ? comparison_limit(c) : NAN;
  struct row row = { .what = "reach",
                     .quantity = quantity_rows[c->item.which.quantity].name,
                     .series = c->item.name,
                     .order = c->item.which.source == FROM_DERIVED ? (double)c->item.which.order : NAN,
                     .tolerance = tolerance,
                     .T = T,
                     .error = NAN,
                     .note = text,
                     .status = "binary128" };
  if (T > 0 && isfinite(T)) {
    row.modes = modes_at(r, T);
    row.error = comparison_error(c, T);
    row.note = where(r, T);
    row.status = is_proven(c, T, tolerance) ? "certified" : "binary128";
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
  struct comparison c = { &r->subject, &r->expansions, { .name = NULL }, r->cache };
  while (series_item_next(&c.item, &r->expansions, quantity, r->options->order)) {
    if (!is_wanted_source(r, c.item.which.source))
      continue;
    for (int i = 0; i < (r->options->has_tolerance ? 1 : TOLERANCES); i++)
      write_reach(r, &c, r->options->has_tolerance ? r->options->tolerance : tolerances[i]);
  }
}

/* ---- radius ---- */

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
    show(r, "singularities");
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
  struct radius radius = {
    .method = NULL, .T = NAN, .low = NAN, .high = NAN, .status = "-", .note = "there is no derived series"
  };
  char text[3 * EVENT_TEXT];
  bool found = find_radius(&radius, r, quantity);
  snprintf(text, sizeof text, "%s%s%s", radius.note, found ? "; " : "", found ? which_first(r, radius.T) : "");
  write_row(r, &(struct row){ .what = "radius",
                              .quantity = quantity_rows[quantity].name,
                              .series = radius.method,
                              .order = NAN,
                              .tolerance = NAN,
                              .T = radius.T,
                              .error = isfinite(radius.T) ? fmax(radius.high - radius.T, radius.T - radius.low) : NAN,
                              .note = text,
                              .status = radius.status });
}

/* ---- the best order ---- */

/* The order with the least |error| at T, of those below MANY; *error: that. False: the motion has no such value. */
static bool best_order(const struct report *r, enum quantity_id quantity, double T, const arb_t exact, slong *order,
                       double *error)
{
  const struct series *s = expansions_of(&r->many, quantity);
  *error = INFINITY;
  *order = 0;
  for (slong k = s->first; arb_is_finite(exact) && k < MANY; k++) {
    if (series_coefficient_is_zero(s, k))
      continue;
    struct breakdown_series which = { FROM_DERIVED, k + 1, quantity };
    struct series_item item = { .which = which, .series = s, .before = k + 1, .name = "derived" };
    struct comparison c = { &r->subject, (struct expansions *)&r->many, item, NULL };
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
  double about = r->events.count > 0 ? r->events.event[0].T : subject_natural_time(&r->subject);
  return i == BEST_BELOW ? about * (1 - 1e-9) : about * exp2((i - BEST_BELOW) / 2.0);
}

/* exact: the certified values at these times. */
static void write_best(struct report *r, enum quantity_id quantity, arb_ptr const exact[BEST])
{
  const struct series *s = expansions_of(&r->many, quantity);
  for (int i = 0; s && i < BEST; i++) {
    double T = best_time(r, i), error;
    slong order;
    if (!best_order(r, quantity, T, exact[i] + quantity, &order, &error))
      continue;
    write_row(r, &(struct row){ .what = "best",
                                .quantity = quantity_rows[quantity].name,
                                .series = "derived",
                                .order = (double)order,
                                .tolerance = NAN,
                                .T = T,
                                .error = error,
                                .modes = modes_at(r, T),
                                .note = beyond(r, s, T, order),
                                .status = "certified" });
  }
}

/* ---- the command ---- */

static void write_rows(struct report *r)
{
  enum { DIGITS = 200 };
  arb_ptr exact[BEST];
  for (int i = 0; i < BEST; i++) {
    exact[i] = _arb_vec_init(QUANTITIES);
    if (is_wanted(r, "best"))
      subject_in_balls(&r->subject, best_time(r, i), DIGITS, exact[i]);
  }
  if (is_wanted(r, "event") && !r->options->quantity)
    write_events(r);
  for (int q = 0; q < QUANTITIES; q++)
    if (is_wanted_quantity(r, (enum quantity_id)q)) {
      show(r, quantity_rows[q].name);
      if (is_wanted(r, "reach"))
        write_reaches(r, (enum quantity_id)q);
      if (is_wanted(r, "radius"))
        write_radius(r, (enum quantity_id)q);
      if (is_wanted(r, "best"))
        write_best(r, (enum quantity_id)q, exact);
    }
  for (int i = 0; i < BEST; i++)
    _arb_vec_clear(exact[i], QUANTITIES);
}

static bool begin(struct report *r)
{
  struct table *t = &r->table;
  if (!table_open(t, r->options))
    return false;
  table_note(t, "scallop " SCALLOP_VERSION);
  table_note(t, "command: breakdown");
  /* T is what is looked for; a phase is one of duration T */
  static const char *const unused[] = { "T", "alpha", NULL }, *const unused_by_period[] = { "T", NULL };
  table_parameters(t, r->options, r->subject.steady ? unused_by_period : unused, false);
  if (!r->subject.steady) {
    char v0[NUMBER_TEXT];
    number_text(v0, r->subject.v0, 0);
    table_note(t, "%s from v0 = %s; T: its duration", r->subject.kind == SCALLOP_EXTENSION ? "extension" : "contraction",
               v0);
  }
  if (r->expansions.derived.status != SCALLOP_OK)
    table_note(t, "no derived series: %s",
               r->expansions.derived.why ? r->expansions.derived.why : scallop_status_text(r->expansions.derived.status));
  table_note(t, "modes may change and change back unseen within a 256th of an octave of T, from T = %.3g to %.3g",
             r->events.from, r->events.until);
  table_columns(t, columns);
  table_begin_rows(t);
  return true;
}

/* One of the names, or a complaint. */
static bool is_one_of(const char *option, const char *given, const char *const *names)
{
  char all[200] = "";
  size_t used = 0;
  for (const char *const *n = names; *n; n++) {
    if (!given || strcmp(given, *n) == 0)
      return true;
    used += (size_t)snprintf(all + used, sizeof all - used, "%s%s", n == names ? "" : n[1] ? ", " : " or ", *n);
  }
  const char *near = nearest(given, names);
  complain("breakdown", "--%s: '%.40s' is not allowed here: it takes %s%s%s%s", option, given, all,
           near ? ": did you mean '" : "", near ? near : "", near ? "'?" : "");
  return false;
}

static bool options_are_sound(const struct options *o, bool steady)
{
  static const char *const kinds[] = { "event", "reach", "radius", "best", NULL };
  const char *names[QUANTITIES + 1] = { NULL };
  int n = 0;
  for (int q = 0; q < QUANTITIES; q++)
    if (quantity_rows[q].has_series && (quantity_rows[q].of == OF_STEADY) == steady)
      names[n++] = quantity_rows[q].name;
  if (!is_one_of("only", o->only, kinds) || !is_one_of("quantity", o->quantity, names))
    return false;
  if (o->has_order && o->has_source && strcmp(o->source, "derived") != 0) {
    complain("breakdown", "--order needs the derived series: leave --source out, or --source derived");
    return false;
  }
  const char *only = o->only ? o->only : "", *idle = NULL;
  if (strcmp(only, "event") == 0)
    idle = o->has_tolerance ? "tol" : o->quantity ? "quantity" : o->has_source ? "source" : o->has_order ? "order" : NULL;
  else if (strcmp(only, "radius") == 0 || strcmp(only, "best") == 0)
    idle = o->has_tolerance                                     ? "tol"
           : o->has_source && strcmp(o->source, "derived") != 0 ? "source"
           : o->has_order                                       ? "order"
                                                                : NULL;
  if (idle) {
    complain("breakdown", "--%s has nothing to do with --only %s", idle, only);
    return false;
  }
  if (o->digits > DOUBLE_DIGITS) {
    complain("breakdown", "--digits: %ld is more than a double has: 1 to 17", o->digits);
    return false;
  }
  if (o->has_tolerance && o->tolerance < LEAST_TOLERANCE) {
    complain("breakdown", "--tol: %g is not allowed here: it takes a number from 1e-20 on", o->tolerance);
    return false;
  }
  return true;
}

enum exit_code breakdown_table(const struct options *o)
{
  static struct report r;
  struct scallop_scaled scaled;
  bool steady = !o->point.has_phase && !o->point.has_v0;
  if (!options_are_sound(o, steady))
    return EXIT_USAGE;
  enum scallop_status status = scallop_scale(&o->point.crawler, &scaled);
  if (status != SCALLOP_OK) {
    complain("breakdown", "%s", scallop_status_text(status));
    return EXIT_UNSOLVED;
  }
  r = (struct report){
    .options = o, .subject = { .crawler = o->point.crawler, .steady = steady, .kind = o->point.phase, .v0 = o->point.v0 }
  };
  expansions_init(&r.expansions, &r.subject, o->order, BREAKDOWN_BITS);
  bool only_derived = o->only && (strcmp(o->only, "radius") == 0 || strcmp(o->only, "best") == 0);
  if (r.expansions.derived.status != SCALLOP_OK && only_derived) {
    complain("breakdown", "no derived series: %s",
             r.expansions.derived.why ? r.expansions.derived.why : scallop_status_text(r.expansions.derived.status));
    expansions_clear(&r.expansions);
    return EXIT_UNSOLVED;
  }
  bool looks_far = is_wanted(&r, "radius") || is_wanted(&r, "best");
  expansions_init(&r.many, &r.subject, looks_far ? MANY : 1, MANY_BITS);
  for (int i = 0; i < 2; i++)
    scallop_singularity_init(&r.sought[i].singularity);
  r.cache = exact_cache_new(&r.subject);
  show(&r, "events");
  events_find(&r.events, &r.subject, expansions_modes(&r.expansions));
  show(&r, NULL);
  enum exit_code code = EXIT_FILE;
  if (r.cache && begin(&r)) {
    write_rows(&r);
    show(&r, NULL);
    code = !table_close(&r.table) ? EXIT_FILE : r.rows > 0 ? EXIT_DONE : EXIT_UNSOLVED;
    if (code == EXIT_UNSOLVED)
      complain("breakdown", "no row: %s",
               r.expansions.derived.status != SCALLOP_OK && r.expansions.derived.why
                   ? r.expansions.derived.why
                   : "there is no such series of this quantity, or all of it is 0");
  }
  events_clear(&r.events);
  exact_cache_free(r.cache);
  for (int i = 0; i < 2; i++)
    scallop_singularity_clear(&r.sought[i].singularity);
  expansions_clear(&r.expansions);
  expansions_clear(&r.many);
  return code;
}
