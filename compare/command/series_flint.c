/* series --source derived|limit, and --bound. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/answer_flint.h"
#include "compare/points/point_flint.h"
#include "compare/command/emit_flint.h"

enum { ERROR_DIGITS = 3, BOUND_PRECISION = 128 };

struct motion_report { /* of one motion: its expansion and its certified values */
  struct motion_names names;
  fmpq_t v0, T; /* T: of the phase, or the period */
  struct series_answer derived;
  struct ball_answer exact;
  char status[2 * SCALLOP_MODES_TEXT + 240];
};
#define PARTS_OF_REPORT(of) of(fmpq, s->v0) of(fmpq, s->T) of(series_answer, &s->derived) of(ball_answer, &s->exact)
SCOPED_PARTS(motion_report, struct motion_report, PARTS_OF_REPORT)

static slong bits_of(long digits) { return (slong)(3.33 * (double)digits); }

static bool derive(struct motion_report *m, const struct report *r, long order, slong precision)
{
  return answer_in_series(&m->derived, r->crawler, m->names.of, m->names.kind, m->v0, order, precision);
}

/* Whether every coefficient below T^order is exact or has the digits. */
static bool is_precise(const struct motion_report *m, long order, long digits)
{
  bool precise = true;
  SCOPED(arb, x);
  for (int q = 0; q < QUANTITIES; q++)
    for (slong k = m->derived.value[q] ? m->derived.value[q]->first : order; k < order && precise; k++) {
      const struct series *s = m->derived.value[q];
      if (s->kind != SERIES_BALLS || series_coefficient_is_zero(s, k))
        continue;
      series_coefficient(x, s, k, 64);
      precise = arb_rel_accuracy_bits(x) > bits_of(digits) + 4 || arb_contains_zero(x);
    }
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
  bool solved = answer_in_balls(&m->exact, r->crawler, m->names.of, m->names.kind, m->v0, digits);
  if (!solved)
    snprintf(m->status, sizeof m->status, "not certified: %s",
             m->exact.why ? m->exact.why : scallop_status_text(m->exact.status));
  else if (strcmp(motion_modes_text(modes, m->names.of, m->exact.modes), m->derived.modes) != 0)
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

/* A coefficient as a fraction, where it is one and no digits are asked for */
static bool is_fraction(fmpq_t q, const struct report *r, const struct series *s, slong power)
{
  return r->options->request.style.digits == 0 && series_rational_coefficient(q, s, power);
}

static char *coefficient_text(const struct report *r, const struct series *s, slong power, const fmpq *fraction)
{
  SCOPED(arb, x);
  series_coefficient(x, s, power, bits_of(r->digits) + 32);
  return fraction ? decimal_fraction(fraction) : decimal_text(x, r->digits);
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
  bool any = false;
  SCOPED(arb, T, power, term, sum, error);
  SCOPED(fmpq, fraction);
  arb_set_fmpq(T, m->T, precision);
  for (slong k = series->first < 0 ? series->first : 0; k < order; k++) {
    bool zero = series_coefficient_is_zero(series, k), say_zero = zero && k == order - 1 && !any;
    if (zero && !say_zero)
      continue;
    series_coefficient(term, series, k, precision);
    arb_pow_ui(power, T, (ulong)labs(k), precision);
    if (k < 0)
      arb_inv(power, power, precision);
    arb_addmul(sum, term, power, precision);
    any = true;
    write_names(r, &m->names, quantity_rows[q].name);
    table_rounded(t, say_zero ? 0 : (double)k, "%.0f");
    bool exactly = is_fraction(fraction, r, series, say_zero ? 0 : k);
    char *text = coefficient_text(r, series, say_zero ? 0 : k, exactly ? fraction : NULL);
    table_text(t, text);
    flint_free(text);
    write_ball(t, sum, r->digits);
    if (exact) {
      error_of(error, sum, exact, precision);
      write_ball(t, error, ERROR_DIGITS);
    } else
      table_number(t, NAN);
    table_text(t, m->status);
  }
}

/* A coefficient times T^power: exact, but where its two sides are beyond the range of doubles */
static struct written write_exactly(const struct report *r, const struct series *series, slong power)
{
  enum { LONGEST = 900 }; /* bits of a double's range */
  struct symbols none;
  SCOPED(fmpq, q);
  bool exactly = is_fraction(q, r, series, power);
  if (exactly && fmpz_bits(fmpq_numref(q)) < LONGEST && fmpz_bits(fmpq_denref(q)) < LONGEST) {
    symbols_init(&none);
    symbols_add(&none, NAMED_T, 0, SCALLOP_EXTENSION);
    symbols_begin(&none);
    struct written written = symbolic_written(&none, symbolic_fraction(&none, q), power, r->language);
    symbols_end(&none);
    return written;
  }
  char *decimal = coefficient_text(r, series, power, NULL);
  struct written written = decimal_written(decimal, power, r->language);
  flint_free(decimal);
  return written;
}

/* A quantity as a function of T */
static void emit_terms(struct report *r, const struct motion_report *m, int q, long order)
{
  const struct series *series = m->derived.value[q];
  const struct emitted e = {
    .names = m->names, .quantity = quantity_rows[q].name, .modes = m->derived.modes, .below = order
  };
  emit_begin(r, &e);
  for (slong k = series->first < 0 ? series->first : 0; k < order; k++)
    if (!series_coefficient_is_zero(series, k))
      emit_term(r, write_exactly(r, series, k));
  emit_end(r, &e);
}

/* The smallest error is seen: as many digits of the exact value, and of the coefficients, as that takes, within
 * reason. */
static bool solve_well(struct motion_report *m, const struct report *r, long order)
{
  enum { TRIES = 9, MOST = 10000 };
  long digits = r->digits + 20;
  bool solved = false, enough = false;
  SCOPED(arb, T, sum, error);
  for (int i = 0; i < TRIES && !enough; i++, digits *= 2) {
    slong precision = 4 * (digits < MOST ? digits : MOST) + 128 + order;
    solved = enough = solve(m, r, digits < MOST ? digits : MOST);
    if (i > 0 && m->derived.value[m->names.of == OF_STEADY ? Q_V_START : Q_V_END]->kind == SERIES_BALLS
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
  return solved;
}

static bool report_motion(struct report *r, const struct motion_names *names)
{
  bool limit = is_from(r->options, "limit");
  long order = limit ? 1 : r->options->order.value;
  SCOPED(motion_report, m);
  m.names = *names;
  if (names->from_v0)
    fmpq_set(m.v0, r->v0);
  if (names->of == OF_STEADY)
    fmpq_set(m.T, r->crawler->T);
  else
    scallop_rational_duration(m.T, r->crawler, names->kind);
  if (!expand(&m, r, order))
    return write_failure(r, &m.names, m.derived.status, m.derived.why);
  bool solved = !r->language && solve_well(&m, r, order);
  for (int q = 0; q < QUANTITIES; q++) {
    if (!m.derived.value[q])
      continue;
    long below = limit && m.derived.value[q]->first < 0 ? 0 : order;
    if (r->language)
      emit_terms(r, &m, q, below);
    else
      write_terms(r, &m, q, below, solved ? m.exact.value[q] : NULL);
  }
  return true;
}

static enum exit_code report_series(struct report *r)
{
  static const char *const columns[] = { "phase", "start", "quantity", "power", "coefficient",
                                         "sum",   "error", "status",   NULL };
  if (!report_open(r, "derived", columns, NULL,
                   "power: of the duration of the phase, or of the period; sum: of the terms so far at this T; "
                   "error: sum - exact"))
    return EXIT_FILE;
  return report_close(r, is_from(r->options, "limit") ? report_motion(r, &steady_motion)
                                                      : report_motions(r, report_motion));
}

/* Four digits, rounded away from what is claimed: C and the bound up, times down. */
static void write_rounded(struct table *t, const arb_t x, int direction)
{
  enum { SPARE = 1000, DIGITS = 4 }; /* a thousandth is more than the fourth digit's rounding */
  SCOPED(arb, shifted);
  (direction > 0 ? arb_get_ubound_arf : arb_get_lbound_arf)(arb_midref(shifted), x, BOUND_PRECISION);
  arb_mul_si(shifted, shifted, SPARE + direction, BOUND_PRECISION);
  arb_div_si(shifted, shifted, SPARE, BOUND_PRECISION);
  write_ball(t, shifted, DIGITS);
}

static void write_bound(struct report *r, const struct scallop_bound *b, const char *quantity)
{
  struct table *t = &r->table;
  SCOPED(arb, T, here);
  table_text(t, quantity);
  table_rounded(t, (double)r->options->order.value, "%.0f");
  write_rounded(t, b->C, 1);
  table_rounded(t, b->power, "%.0f");
  write_rounded(t, b->T0, -1);
  arb_set_fmpq(T, r->crawler->T, BOUND_PRECISION);
  arb_pow_ui(here, T, (ulong)b->power, BOUND_PRECISION);
  arb_mul(here, here, b->C, BOUND_PRECISION);
  if (arb_le(T, b->T0))
    write_rounded(t, here, 1);
  else
    table_number(t, NAN);
  write_rounded(t, b->T_end, -1);
  table_text(t, b->ends);
}

static void end_bounds(struct scallop_bound (*bounds)[2])
{
  scallop_bound_clear(&(*bounds)[0]);
  scallop_bound_clear(&(*bounds)[1]);
}

static enum exit_code report_bounds(struct report *r)
{
  static const char *const columns[] = { "quantity", "order", "C", "power", "T0", "bound", "T_end", "ends", NULL };
  const char *why = NULL;
  ENDED_BY(end_bounds) struct scallop_bound bounds[2];
  scallop_bound_init(&bounds[0]);
  scallop_bound_init(&bounds[1]);
  enum scallop_status status = scallop_steady_bounds(r->crawler, r->options->order.value, BOUND_PRECISION, bounds,
                                                     &why);
  if (status != SCALLOP_OK) {
    complain("series", "no bound: %s", why ? why : scallop_status_text(status));
    return EXIT_UNSOLVED;
  }
  if (!report_open(r, "bounds", columns, NULL,
                   "|exact - terms below T^order| <= C T^power for 0 < T <= T0; bound: C T^power at this T"))
    return EXIT_FILE;
  write_bound(r, &bounds[0], "v_start");
  write_bound(r, &bounds[1], "displacement");
  return report_close(r, true);
}

enum exit_code series_derived(const struct series_options *o)
{
  return report_run(o, o->bound ? report_bounds : report_series);
}
