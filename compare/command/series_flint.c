/* series --source derived|limit, and series --bound. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/answer_flint.h"
#include "compare/points/point_flint.h"
#include "compare/command/emit_flint.h"
#include "compare/command/series_flint.h"

enum { DEFAULT_DIGITS = 17, ERROR_DIGITS = 3, BOUND_PRECISION = 128 };

static const char *const columns[] = { "phase", "start", "quantity", "power", "coefficient",
                                       "sum",   "error", "status",   NULL };
static const char *const bound_columns[] = { "quantity", "order", "C", "power", "T0", "bound", "T_end", "ends", NULL };

static bool is_limit(const struct series_options *o) { return !o->bound && strcmp(o->source.value, "limit") == 0; }

struct motion_report { /* of one motion: its expansion and its certified values */
  const char *phase, *start;
  enum quantity_of of;
  enum scallop_phase_kind kind;
  fmpq_t v0, T; /* T: of the phase, or the period */
  struct series_answer derived;
  struct ball_answer exact;
  char status[2 * SCALLOP_MODES_TEXT + 240];
};

struct report {
  const struct series_options *options;
  struct scallop_rational_crawler crawler;
  fmpq_t v0;
  long digits;     /* of what is printed                                                         */
  const char *why; /* something could not be done: the reason                                    */
  bool as_table;   /* otherwise emitted                                                            */
  struct table table;
  struct emission emission;
};

static slong bits_of(long digits) { return (slong)(3.33 * (double)digits); }

static bool derive(struct motion_report *m, const struct report *r, long order, slong precision)
{
  return answer_in_series(&m->derived, &r->crawler, m->of, m->kind, m->v0, order, precision);
}

/* Whether every coefficient below T^order is exact or has the digits. */
static bool is_precise(const struct motion_report *m, long order, long digits)
{
  bool precise = true;
  arb_t x;
  arb_init(x);
  for (int q = 0; q < QUANTITIES; q++)
    for (slong k = m->derived.value[q] ? m->derived.value[q]->first : order; k < order && precise; k++) {
      const struct series *s = m->derived.value[q];
      if (s->kind != SERIES_BALLS || series_coefficient_is_zero(s, k))
        continue;
      series_coefficient(x, s, k, 64);
      precise = arb_rel_accuracy_bits(x) > bits_of(digits) + 4 || arb_contains_zero(x);
    }
  arb_clear(x);
  return precise;
}

/* With so many bits, or as many more as the digits of the coefficients take. */
static bool expand(struct motion_report *m, const struct report *r, long order)
{
  enum { TRIES = 6 };
  slong precision = bits_of(r->digits) + 128 + order;
  for (int i = 0; i < TRIES; i++, precision *= 2) {
    bool done = derive(m, r, order, precision);
    if (m->derived.status == SCALLOP_EDOMAIN || (done && is_precise(m, order, r->digits)))
      break;
  }
  return m->derived.status == SCALLOP_OK;
}

/* Certified values with so many digits; without an answer the errors are nan. */
static bool solve(struct motion_report *m, const struct report *r, long digits)
{
  char modes[MOTION_MODES_TEXT];
  bool solved = answer_in_balls(&m->exact, &r->crawler, m->of, m->kind, m->v0, digits);
  if (!solved)
    snprintf(m->status, sizeof m->status, "not certified: %s",
             m->exact.why ? m->exact.why : scallop_status_text(m->exact.status));
  else if (strcmp(motion_modes_text(modes, m->of, m->exact.modes), m->derived.modes) != 0)
    snprintf(m->status, sizeof m->status, "not of this motion: its modes are %s", modes);
  else
    snprintf(m->status, sizeof m->status, "ok");
  return solved;
}

static void write_ball(struct table *t, const arb_t x, long digits)
{
  char *text = decimal_text(x, digits);
  table_digits(t, text);
  flint_free(text);
}

static void write_names(struct table *t, const struct motion_report *m, const char *quantity)
{
  table_text(t, m->phase);
  table_text(t, m->start);
  table_text(t, quantity);
}

static void write_coefficient(struct table *t, const struct report *r, const struct series *s, slong power)
{
  fmpq_t q;
  arb_t x;
  fmpq_init(q);
  arb_init(x);
  series_coefficient(x, s, power, bits_of(r->digits) + 32);
  bool as_fraction = r->options->request.style.digits == 0 && series_rational_coefficient(q, s, power);
  char *text = as_fraction ? decimal_fraction(q) : decimal_text(x, r->digits);
  table_text(t, text);
  flint_free(text);
  fmpq_clear(q);
  arb_clear(x);
}

/* sum - exact. With too few digits of the exact value for this, false. */
static bool error_of(arb_t error, const arb_t sum, const arb_t exact, slong precision)
{
  arb_sub(error, sum, exact, precision);
  return arb_is_zero(error) || arb_rel_accuracy_bits(error) > 12;
}

/* One row for each term that is not 0; if all are, one row says so. exact: NULL where the motion has no such quantity,
 * or could not be certified. */
static void write_terms(struct report *r, const struct motion_report *m, int q, long order, const arb_struct *exact)
{
  const struct series *series = m->derived.value[q];
  struct table *t = &r->table;
  slong accuracy = exact ? arb_rel_accuracy_bits(exact) : 0, precision = bits_of(r->digits) + 128;
  if (accuracy < WORD_MAX / 4 && accuracy + 64 > precision)
    precision = accuracy + 64;
  slong first = series->first < 0 ? series->first : 0;
  bool any = false;
  arb_ptr x = _arb_vec_init(5), T = x, power = x + 1, term = x + 2, sum = x + 3, error = x + 4;
  arb_set_fmpq(T, m->T, precision);
  arb_one(power);
  for (slong k = first; k < 0; k++)
    arb_div(power, power, T, precision);
  for (slong k = first; k < order; k++, arb_mul(power, power, T, precision)) {
    bool zero = series_coefficient_is_zero(series, k), say_zero = zero && k == order - 1 && !any;
    if (zero && !say_zero)
      continue;
    series_coefficient(term, series, k, precision);
    arb_addmul(sum, term, power, precision);
    any = true;
    write_names(t, m, quantity_rows[q].name);
    table_rounded(t, say_zero ? 0 : (double)k, "%.0f");
    write_coefficient(t, r, series, say_zero ? 0 : k);
    write_ball(t, sum, r->digits);
    if (exact) {
      error_of(error, sum, exact, precision);
      write_ball(t, error, ERROR_DIGITS);
    } else
      table_number(t, NAN);
    table_text(t, m->status);
  }
  _arb_vec_clear(x, 5);
}

/* A coefficient times T^power: exact, but where the language would round a fraction's two sides, or cannot hold them */
static struct written write_exactly(const struct report *r, const struct series *series, slong power)
{
  enum { LONGEST = 900 }; /* bits of a double's range */
  const struct language *language = r->emission.language;
  struct written written;
  struct symbols none;
  fmpq_t q;
  arb_t x;
  fmpq_init(q);
  arb_init(x);
  bool exact = series_rational_coefficient(q, series, power) && r->options->request.style.digits == 0;
  if (exact && language != &language_c && fmpz_bits(fmpq_numref(q)) < LONGEST && fmpz_bits(fmpq_denref(q)) < LONGEST) {
    symbols_init(&none);
    symbols_add(&none, NAMED_T, 0, SCALLOP_EXTENSION);
    symbols_begin(&none);
    written = symbolic_written(&none, symbolic_fraction(&none, q), power, language);
    symbols_end(&none);
  } else {
    series_coefficient(x, series, power, bits_of(r->digits) + 32);
    char *decimal = decimal_text(x, r->digits);
    written = decimal_written(decimal, power, language);
    flint_free(decimal);
  }
  fmpq_clear(q);
  arb_clear(x);
  return written;
}

/* A quantity as a function of T */
static void emit_terms(struct report *r, const struct motion_report *m, int q, long order)
{
  const struct series *series = m->derived.value[q];
  slong first = series->first < 0 ? series->first : 0;
  struct emitted emitted = {
    .phase = m->phase, .start = m->start, .quantity = quantity_rows[q].name, .modes = m->derived.modes, .below = order
  };
  emitted.terms = flint_malloc(sizeof *emitted.terms * (size_t)(order - first));
  for (slong k = first; k < order; k++)
    if (!series_coefficient_is_zero(series, k))
      emitted.terms[emitted.count++] = write_exactly(r, series, k);
  emission_add(&r->emission, &emitted);
  flint_free(emitted.terms);
}

/* The smallest error is seen: as many digits of the exact value, and of the coefficients, as that takes, within
 * reason. */
static bool solve_well(struct motion_report *m, const struct report *r, long order)
{
  enum { TRIES = 9, MOST = 10000 };
  long digits = r->digits + 20;
  bool solved = false, enough = false;
  arb_ptr x = _arb_vec_init(3), T = x, sum = x + 1, error = x + 2;
  for (int i = 0; i < TRIES && !enough; i++, digits *= 2) {
    slong precision = 4 * (digits < MOST ? digits : MOST) + 128 + order;
    solved = enough = solve(m, r, digits < MOST ? digits : MOST);
    if (i > 0 && m->derived.value[m->of == OF_STEADY ? Q_V_START : Q_V_END]->kind == SERIES_BALLS
        && !derive(m, r, order, precision))
      break;
    arb_set_fmpq(T, m->T, precision);
    for (int q = 0; solved && q < QUANTITIES; q++) {
      if (!m->derived.value[q] || !m->exact.value[q])
        continue;
      series_value(sum, m->derived.value[q], T, order, precision);
      enough = error_of(error, sum, m->exact.value[q], precision) && enough;
    }
    enough |= !solved || digits >= MOST;
  }
  _arb_vec_clear(x, 3);
  return solved;
}

/* A motion without a series has its reason in status. */
static void write_failure(struct report *r, struct motion_report *m)
{
  struct table *t = &r->table;
  r->why = m->derived.why ? m->derived.why : scallop_status_text(m->derived.status);
  if (!r->as_table)
    return;
  snprintf(m->status, sizeof m->status, "no series: %s", r->why);
  write_names(t, m, "-");
  table_number(t, NAN);
  table_text(t, "-");
  table_number(t, NAN);
  table_number(t, NAN);
  table_text(t, m->status);
}

static bool report_motion(struct report *r, enum quantity_of of, enum scallop_phase_kind kind, bool from_rest)
{
  bool limit = is_limit(r->options), steady = of == OF_STEADY;
  long order = limit ? 1 : r->options->order.value;
  struct motion_report m = { .phase = steady                      ? "period"
                                      : kind == SCALLOP_EXTENSION ? "extension"
                                                                  : "contraction",
                             .start = steady      ? "steady"
                                      : from_rest ? "rest"
                                                  : "v0",
                             .of = of,
                             .kind = kind };
  fmpq_init(m.v0);
  fmpq_init(m.T);
  series_answer_init(&m.derived);
  ball_answer_init(&m.exact);
  if (!from_rest)
    fmpq_set(m.v0, r->v0);
  if (steady)
    fmpq_set(m.T, r->crawler.T);
  else
    scallop_rational_duration(m.T, &r->crawler, kind);
  bool done = expand(&m, r, order), solved = done && r->as_table && solve_well(&m, r, order);
  for (int q = 0; done && q < QUANTITIES; q++)
    if (m.derived.value[q] && !r->as_table)
      emit_terms(r, &m, q, limit && m.derived.value[q]->first < 0 ? 0 : order);
    else if (m.derived.value[q])
      write_terms(r, &m, q, limit && m.derived.value[q]->first < 0 ? 0 : order, solved ? m.exact.value[q] : NULL);
  if (!done)
    write_failure(r, &m);
  fmpq_clear(m.v0);
  fmpq_clear(m.T);
  series_answer_clear(&m.derived);
  ball_answer_clear(&m.exact);
  return done;
}

static bool report_all(struct report *r)
{
  const struct point *p = &r->options->request.point;
  bool done = true;
  if (!is_limit(r->options))
    for (int kind = 0; kind < 2; kind++) {
      done = report_motion(r, OF_PHASE, (enum scallop_phase_kind)kind, true) && done;
      if (p->has_v0 && p->v0 != 0)
        done = report_motion(r, OF_PHASE, (enum scallop_phase_kind)kind, false) && done;
    }
  return report_motion(r, OF_STEADY, SCALLOP_EXTENSION, true) && done;
}

/* The head of a document says which crawler its numbers are of. */
static bool begin_document(struct report *r, const char *command)
{
  const struct series_options *o = r->options;
  static const char *const not_held[] = { "T", NULL };
  char crawler[PARAMETERS_TEXT + NUMBER_LENGTH + 32];
  size_t used = (size_t)sprintf(crawler, "Parameters:");
  parameters_text(crawler + used, &o->request.point, not_held, true);
  if (o->request.point.has_v0)
    snprintf(crawler + strlen(crawler), sizeof crawler - strlen(crawler), " v0=%s", o->request.point.written_v0);
  return emission_open(&r->emission, &o->request.style, o->emit.value, command, crawler);
}

static bool begin(struct report *r)
{
  const struct series_options *o = r->options;
  char command[64] = "series --source limit";
  if (!is_limit(o))
    snprintf(command, sizeof command, "series %s --order %ld", o->bound ? "--bound" : "--source derived",
             o->order.value);
  if (!r->as_table)
    return begin_document(r, command);
  if (!table_head(&r->table, &o->request.style, "%s", command))
    return false;
  r->table.of = o->bound ? "bounds" : "derived";
  note_parameters(&r->table, &o->request.point, NULL, true);
  if (o->request.point.has_v0)
    table_note(&r->table, "v0: %s", o->request.point.written_v0);
  if (o->bound)
    table_note(&r->table, "|exact - terms below T^order| <= C T^power for 0 < T <= T0; bound: C T^power at this T");
  else
    table_note(&r->table, "power: of the duration of the phase, or of the period; sum: of the terms so far at this T; "
                          "error: sum - exact");
  table_columns(&r->table, o->bound ? bound_columns : columns);
  table_begin_rows(&r->table);
  return true;
}

/* Four digits, rounded away from what is claimed: C and the bound up, times down. */
static void write_rounded(struct table *t, const arb_t x, int direction)
{
  enum { SPARE = 1000, DIGITS = 4 }; /* a thousandth is more than the fourth digit's rounding */
  arb_t shifted;
  arb_init(shifted);
  (direction > 0 ? arb_get_ubound_arf : arb_get_lbound_arf)(arb_midref(shifted), x, BOUND_PRECISION);
  arb_mul_si(shifted, shifted, SPARE + direction, BOUND_PRECISION);
  arb_div_si(shifted, shifted, SPARE, BOUND_PRECISION);
  write_ball(t, shifted, DIGITS);
  arb_clear(shifted);
}

static void write_bound(struct table *t, const struct scallop_bound *b, const char *quantity, const struct report *r)
{
  arb_ptr T = _arb_vec_init(2), here = T + 1;
  table_text(t, quantity);
  table_rounded(t, (double)r->options->order.value, "%.0f");
  write_rounded(t, b->C, 1);
  table_rounded(t, b->power, "%.0f");
  write_rounded(t, b->T0, -1);
  arb_set_fmpq(T, r->crawler.T, BOUND_PRECISION);
  arb_pow_ui(here, T, (ulong)b->power, BOUND_PRECISION);
  arb_mul(here, here, b->C, BOUND_PRECISION);
  if (arb_le(T, b->T0))
    write_rounded(t, here, 1);
  else
    table_number(t, NAN);
  write_rounded(t, b->T_end, -1);
  table_text(t, b->ends);
  _arb_vec_clear(T, 2);
}

static enum exit_code report_bounds(struct report *r)
{
  struct scallop_bound bounds[2];
  const char *why = NULL;
  enum exit_code code = EXIT_UNSOLVED;
  scallop_bound_init(&bounds[0]);
  scallop_bound_init(&bounds[1]);
  enum scallop_status status = scallop_steady_bounds(&r->crawler, r->options->order.value, BOUND_PRECISION, bounds,
                                                     &why);
  if (status != SCALLOP_OK)
    complain("series", "no bound: %s", why ? why : scallop_status_text(status));
  else if (!begin(r))
    code = EXIT_FILE;
  else {
    write_bound(&r->table, &bounds[0], "v_start", r);
    write_bound(&r->table, &bounds[1], "displacement", r);
    code = table_close(&r->table) ? EXIT_DONE : EXIT_FILE;
  }
  scallop_bound_clear(&bounds[0]);
  scallop_bound_clear(&bounds[1]);
  return code;
}

static enum exit_code report_series(struct report *r)
{
  if (!begin(r))
    return EXIT_FILE;
  bool done = report_all(r);
  if (!(r->as_table ? table_close(&r->table) : emission_close(&r->emission)))
    return EXIT_FILE;
  if (!done)
    complain("series", "a motion has no series in powers of T: %s", r->why);
  return done ? EXIT_DONE : EXIT_UNSOLVED;
}

enum exit_code series_derived(const struct series_options *options)
{
  struct report r = { .options = options,
                      .as_table = strcmp(options->emit.value, "text") == 0,
                      .digits = options->request.style.digits > 0 ? options->request.style.digits : DEFAULT_DIGITS };
  if (options->request.points) {
    complain("series", "--points is for --source published: one point at a time here");
    return EXIT_USAGE;
  }
  scallop_rational_init(&r.crawler);
  fmpq_init(r.v0);
  rational_point(&r.crawler, r.v0, &options->request.point);
  enum exit_code code = options->bound ? report_bounds(&r) : report_series(&r);
  scallop_rational_clear(&r.crawler);
  fmpq_clear(r.v0);
  return code;
}
