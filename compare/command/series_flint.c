/* series --source derived|limit, and series --bound. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/answers/answer_flint.h"
#include "compare/answers/point_flint.h"
#include "compare/command/series_flint.h"

enum { DEFAULT_DIGITS = 17, ERROR_DIGITS = 3, BOUND_PRECISION = 128 };

static const char *const columns[] = {
  "phase", "start", "quantity", "power", "coefficient", "sum", "error", "status", NULL
};
static const char *const bound_columns[] = { "quantity", "order", "C", "power", "T0", "bound", "T_end", "ends", NULL };

static bool is_limit(const struct series_options *o) { return !o->bound && strcmp(o->source.value, "limit") == 0; }

struct motion_report { /* of one motion: its expansion and its certified values */
  const char *phase, *start;
  enum quantity_of of;
  enum scallop_phase_kind kind;
  fmpq_t v0, T; /* T: of the phase, or the period */
  struct series_answer derived;
  struct ball_answer exact;
  char status[2 * SCALLOP_MODES_TEXT + 60];
};

struct report {
  const struct series_options *options;
  struct scallop_rational_crawler crawler;
  long digits;     /* of what is printed                                                         */
  const char *why; /* something could not be done: the reason                                    */
  struct table table;
};

static void motion_init(struct motion_report *m)
{
  *m = (struct motion_report){ .phase = "period", .start = "steady", .of = OF_STEADY };
  fmpq_init(m->v0);
  fmpq_init(m->T);
  series_answer_init(&m->derived);
  ball_answer_init(&m->exact);
}

static void motion_clear(struct motion_report *m)
{
  fmpq_clear(m->v0);
  fmpq_clear(m->T);
  series_answer_clear(&m->derived);
  ball_answer_clear(&m->exact);
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
      if (s->exact || series_coefficient_is_zero(s, k))
        continue;
      series_coefficient(x, s, k, 64);
      precise = arb_rel_accuracy_bits(x) > (slong)(3.33 * (double)digits) + 4 || arb_contains_zero(x);
    }
  arb_clear(x);
  return precise;
}

/* With so many bits, or as many more as the digits of the coefficients take. */
static enum scallop_status expand(struct motion_report *m, const struct report *r, long order, slong precision,
                                  const char **why)
{
  enum { TRIES = 6 };
  for (int i = 0; i < TRIES; i++, precision *= 2) {
    bool done = answer_in_series(&m->derived, &r->crawler, m->of, m->kind, m->v0, order, precision);
    *why = m->derived.why;
    if (m->derived.status == SCALLOP_EDOMAIN || (done && is_precise(m, order, r->digits)))
      break;
  }
  return m->derived.status;
}

static void compare_modes(struct motion_report *m)
{
  char both[MOTION_MODES_TEXT];
  motion_modes_text(both, m->of, m->exact.modes);
  if (strcmp(both, m->derived.modes) == 0)
    snprintf(m->status, sizeof m->status, "ok");
  else
    snprintf(m->status, sizeof m->status, "not of this motion: its modes are %s", both);
}

/* Certified values with so many digits; without an answer the errors are nan. */
static bool solve(struct motion_report *m, const struct report *r, long digits)
{
  bool solved = answer_in_balls(&m->exact, &r->crawler, m->of, m->kind, m->v0, digits);
  if (solved)
    compare_modes(m);
  else
    snprintf(m->status, sizeof m->status, "not certified: %s",
             m->exact.why ? m->exact.why : scallop_status_text(m->exact.status));
  return solved;
}

static void write_coefficient(struct table *t, const struct report *r, const struct series *s, slong power)
{
  fmpq_t q;
  arb_t x;
  fmpq_init(q);
  arb_init(x);
  char *text;
  if (r->options->request.style.digits == 0 && series_rational_coefficient(q, s, power))
    text = decimal_fraction(q);
  else {
    series_coefficient(x, s, power, (slong)(3.33 * (double)r->digits) + 32);
    text = decimal_text(x, r->digits);
  }
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

/* exact: NULL where the motion has no such quantity, or could not be certified. */
static void write_term(struct report *r, const struct motion_report *m, int q, slong power, const arb_t sum,
                       const arb_struct *exact, slong precision)
{
  struct table *t = &r->table;
  char number[24], *text;
  arb_t error;
  arb_init(error);
  snprintf(number, sizeof number, "%ld", (long)power);
  table_text(t, m->phase);
  table_text(t, m->start);
  table_text(t, quantity_rows[q].name);
  table_digits(t, number);
  write_coefficient(t, r, m->derived.value[q], power);
  text = decimal_text(sum, r->digits);
  table_digits(t, text);
  flint_free(text);
  if (exact) {
    error_of(error, sum, exact, precision);
    text = decimal_text(error, ERROR_DIGITS);
    table_digits(t, text);
    flint_free(text);
  } else
    table_number(t, NAN);
  table_text(t, m->status);
  arb_clear(error);
}

/* One row for each term that is not 0; if all are, one row says so. */
static void write_terms(struct report *r, const struct motion_report *m, int q, long order, bool solved)
{
  const struct series *series = m->derived.value[q];
  const arb_struct *exact = solved ? m->exact.value[q] : NULL;
  slong accuracy = exact ? arb_rel_accuracy_bits(exact) : 0, precision = (slong)(3.33 * (double)r->digits) + 128;
  if (accuracy < WORD_MAX / 4 && accuracy + 64 > precision)
    precision = accuracy + 64;
  slong first = series->first < 0 ? series->first : 0;
  bool any = false;
  arb_t T, power, term, sum;
  arb_init(T);
  arb_init(power);
  arb_init(term);
  arb_init(sum);
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
    write_term(r, m, q, say_zero ? 0 : k, sum, exact, precision);
    any = true;
  }
  arb_clear(T);
  arb_clear(power);
  arb_clear(term);
  arb_clear(sum);
}

/* The smallest error is seen: as many digits of the exact value, and of the coefficients, as that takes, within reason. */
static bool solve_well(struct motion_report *m, const struct report *r, long order)
{
  enum { TRIES = 9, MOST = 10000 };
  long digits = r->digits + 20;
  bool solved = false, enough = false;
  arb_t T, sum, error;
  arb_init(T);
  arb_init(sum);
  arb_init(error);
  for (int i = 0; i < TRIES && !enough; i++, digits *= 2) {
    slong precision = 4 * (digits < MOST ? digits : MOST) + 128 + order;
    solved = enough = solve(m, r, digits < MOST ? digits : MOST);
    if (i > 0 && !m->derived.value[m->of == OF_STEADY ? Q_V_START : Q_V_END]->exact
        && !answer_in_series(&m->derived, &r->crawler, m->of, m->kind, m->v0, order, precision))
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
  arb_clear(T);
  arb_clear(sum);
  arb_clear(error);
  return solved;
}

/* A motion without a series has its reason in status. */
static void write_failure(struct report *r, const struct motion_report *m)
{
  struct table *t = &r->table;
  char status[240];
  snprintf(status, sizeof status, "no series: %s", r->why);
  table_text(t, m->phase);
  table_text(t, m->start);
  table_text(t, "-");
  table_number(t, NAN);
  table_text(t, "-");
  table_number(t, NAN);
  table_number(t, NAN);
  table_text(t, status);
}

static bool report_motion(struct report *r, struct motion_report *m)
{
  bool limit = is_limit(r->options);
  long order = limit ? 1 : r->options->order.value;
  const char *why = NULL;
  slong precision = (slong)(3.33 * (double)r->digits) + 128 + order;
  enum scallop_status status = expand(m, r, order, precision, &why);
  if (status != SCALLOP_OK) {
    r->why = why ? why : scallop_status_text(status);
    write_failure(r, m);
    return false;
  }
  bool solved = solve_well(m, r, order);
  for (int q = 0; q < QUANTITIES; q++)
    if (m->derived.value[q])
      write_terms(r, m, q, limit && m->derived.value[q]->first < 0 ? 0 : order, solved);
  return true;
}

static bool report_phase(struct report *r, enum scallop_phase_kind kind, bool from_rest)
{
  struct motion_report m;
  motion_init(&m);
  m.of = OF_PHASE;
  m.kind = kind;
  m.phase = kind == SCALLOP_EXTENSION ? "extension" : "contraction";
  m.start = from_rest ? "rest" : "v0";
  scallop_rational_duration(m.T, &r->crawler, kind);
  if (!from_rest) {
    struct scallop_rational_crawler unused;
    scallop_rational_init(&unused);
    rational_point(&unused, m.v0, &r->options->request.point);
    scallop_rational_clear(&unused);
  }
  bool reported = report_motion(r, &m);
  motion_clear(&m);
  return reported;
}

static bool report_steady(struct report *r)
{
  struct motion_report m;
  motion_init(&m);
  fmpq_set(m.T, r->crawler.T);
  bool reported = report_motion(r, &m);
  motion_clear(&m);
  return reported;
}

static bool report_all(struct report *r)
{
  bool done = true;
  if (strcmp(r->options->source.value, "derived") == 0)
    for (int kind = 0; kind < 2; kind++) {
      done = report_phase(r, (enum scallop_phase_kind)kind, true) && done;
      if (r->options->request.point.has_v0 && r->options->request.point.v0 != 0)
        done = report_phase(r, (enum scallop_phase_kind)kind, false) && done;
    }
  return report_steady(r) && done;
}

static bool begin(struct report *r)
{
  const struct series_options *o = r->options;
  if (!table_open(&r->table, &o->request.style))
    return false;
  table_note(&r->table, "scallop " SCALLOP_VERSION);
  if (is_limit(o))
    table_note(&r->table, "command: series --source limit");
  else
    table_note(&r->table, "command: series %s --order %ld", o->bound ? "--bound" : "--source derived", o->order.value);
  note_parameters(&r->table, &o->request.point, NULL, true);
  if (o->request.point.has_v0)
    table_note(&r->table, "v0: %s", o->request.point.written_v0);
  if (o->bound)
    table_note(&r->table, "|exact - terms below T^order| <= C T^power for 0 < T <= T0; bound: C T^power at this T");
  else
    table_note(
        &r->table,
        "power: of the duration of the phase, or of the period; sum: of the terms so far at this T; error: sum - exact");
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
  char *text = decimal_text(shifted, DIGITS);
  table_digits(t, text);
  flint_free(text);
  arb_clear(shifted);
}

static void write_bound(struct table *t, const struct scallop_bound *b, const char *quantity, const struct report *r)
{
  arb_t T, here;
  char text[24];
  arb_init(T);
  arb_init(here);
  table_text(t, quantity);
  snprintf(text, sizeof text, "%ld", r->options->order.value);
  table_digits(t, text);
  write_rounded(t, b->C, 1);
  snprintf(text, sizeof text, "%d", b->power);
  table_digits(t, text);
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
  arb_clear(T);
  arb_clear(here);
}

static enum exit_code report_bounds(struct report *r)
{
  struct scallop_bound bounds[2];
  const char *why = NULL;
  enum exit_code code = EXIT_UNSOLVED;
  scallop_bound_init(&bounds[0]);
  scallop_bound_init(&bounds[1]);
  enum scallop_status status = scallop_steady_bounds(&r->crawler, r->options->order.value, BOUND_PRECISION, bounds, &why);
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
  if (!table_close(&r->table))
    return EXIT_FILE;
  if (!done)
    complain("series", "a motion has no series in powers of T: %s", r->why);
  return done ? EXIT_DONE : EXIT_UNSOLVED;
}

enum exit_code series_derived(const struct series_options *options)
{
  struct report r = { .options = options,
                      .digits = options->request.style.digits > 0 ? options->request.style.digits : DEFAULT_DIGITS };
  if (options->request.points) {
    complain("series", "--points is for --source published: one point at a time here");
    return EXIT_USAGE;
  }
  scallop_rational_init(&r.crawler);
  rational_point(&r.crawler, NULL, &options->request.point);
  enum exit_code code = options->bound ? report_bounds(&r) : report_series(&r);
  scallop_rational_clear(&r.crawler);
  return code;
}
