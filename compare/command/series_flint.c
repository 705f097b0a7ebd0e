/* series --source derived|limit, --symbolic and --bound. */
#include <math.h>

#include "compare/answers/answer_flint.h"
#include "compare/command/report_flint.h"
#include "compare/points/point_flint.h"

enum { BOUND_PRECISION = 128 };

struct numbers { /* the expansion of a motion, and its certified values */
  const struct report *report;
  const struct reported_motion *motion;
  fmpq_t T; /* of the phase, or the period */
  struct series_answer derived;
  struct ball_answer exact;
  char status[2 * SCALLOP_MODES_TEXT + 240];
};
#define NUMBERS(of) of(fmpq, s->T) of(series_answer, &s->derived) of(ball_answer, &s->exact)
SCOPED_PARTS(numbers, struct numbers, NUMBERS)

static bool derive(struct numbers *n, long order, slong precision)
{
  const struct reported_motion *m = n->motion;
  return answer_in_series(&n->derived, n->report->crawler, m->of, m->kind, m->v0, order, precision);
}

/* Whether every coefficient below T^order is exact or has the digits. */
static bool is_precise(const struct numbers *n, long order)
{
  bool precise = true;
  SCOPED(arb, x);
  for (int q = 0; q < QUANTITIES; q++)
    for (slong k = n->derived.value[q] ? n->derived.value[q]->first : order; k < order && precise; k++) {
      const struct series *s = n->derived.value[q];
      if (s->kind != SERIES_BALLS || series_coefficient_is_zero(s, k))
        continue;
      series_coefficient(x, s, k, 64);
      precise = arb_rel_accuracy_bits(x) > bits_of_digits(n->report->digits) + 4 || arb_contains_zero(x);
    }
  return precise;
}

/* With so many bits, or as many more as the digits of the coefficients take. */
static bool expand(struct numbers *n, long order)
{
  enum { TRIES = 6 };
  slong precision = bits_of_digits(n->report->digits) + 128 + order;
  for (int i = 0; i < TRIES; i++, precision *= 2) {
    bool done = derive(n, order, precision);
    if (n->derived.status == SCALLOP_EDOMAIN || (done && is_precise(n, order)))
      break;
  }
  return n->derived.status == SCALLOP_OK;
}

/* Certified values with so many digits; without an answer the errors are nan. */
static bool solve(struct numbers *n, long digits)
{
  const struct reported_motion *m = n->motion;
  char modes[MOTION_MODES_TEXT];
  bool solved = answer_in_balls(&n->exact, n->report->crawler, m->of, m->kind, m->v0, digits);
  if (!solved)
    snprintf(n->status, sizeof n->status, "not certified: %s",
             n->exact.why ? n->exact.why : scallop_status_text(n->exact.status));
  else if (strcmp(motion_modes_text(modes, m->of, n->exact.modes), n->derived.modes) != 0)
    snprintf(n->status, sizeof n->status, "not of this motion: its modes are %s", modes);
  else
    snprintf(n->status, sizeof n->status, "ok");
  return solved;
}

/* Has the exact value of each quantity the digits that the error of its series takes? */
static bool errors_are_seen(const struct numbers *n, long order, slong precision)
{
  bool seen = true;
  SCOPED(arb, T, sum, error);
  arb_set_fmpq(T, n->T, precision);
  for (int q = 0; q < QUANTITIES; q++)
    if (n->derived.value[q] && n->exact.value[q]) {
      series_value(sum, n->derived.value[q], T, order, precision);
      seen = report_error(error, sum, n->exact.value[q], precision) && seen;
    }
  return seen;
}

/* As many digits of the exact value, and of the coefficients, as the smallest error takes, within reason. */
static bool solve_well(struct numbers *n, long order)
{
  enum { TRIES = 9, MOST = 10000 };
  bool solved = false, enough = false;
  int main_quantity = n->motion->of == OF_STEADY ? Q_V_START : Q_V_END;
  for (long i = 0, more = n->report->digits + 20; i < TRIES && !enough; i++, more *= 2) {
    long digits = more < MOST ? more : MOST;
    slong precision = 4 * digits + 128 + order;
    solved = solve(n, digits);
    if (solved && i > 0 && n->derived.value[main_quantity]->kind == SERIES_BALLS && !derive(n, order, precision))
      break;
    enough = !solved || digits == MOST || errors_are_seen(n, order, precision);
  }
  return solved;
}

static bool report_numbers(struct report *r, const struct reported_motion *m)
{
  bool limit = is_from(r->options, "limit");
  long order = limit ? 1 : r->options->order.value;
  struct symbols T;
  SCOPED(numbers, n);
  n.report = r;
  n.motion = m;
  if (m->of == OF_STEADY)
    fmpq_set(n.T, r->crawler->T);
  else
    scallop_rational_duration(n.T, r->crawler, m->kind);
  if (!expand(&n, order))
    return report_failure(r, m, n.derived.status, n.derived.why);
  bool solved = !r->language && solve_well(&n, order);
  symbols_init(&T);
  symbols_add(&T, NAMED_T, 0, SCALLOP_EXTENSION);
  symbols_begin(&T);
  struct reported_sum sum = { .motion = m, .modes = n.derived.modes, .symbols = &T, .T = n.T, .status = n.status };
  for (int q = 0; q < QUANTITIES; q++)
    if ((sum.series = n.derived.value[q])) {
      sum.quantity = quantity_rows[q].name;
      sum.first = sum.series->first < 0 ? sum.series->first : 0;
      sum.below = limit && sum.first < 0 ? 0 : order;
      sum.exact = solved ? n.exact.value[q] : NULL;
      report_sum(r, &sum);
    }
  symbols_end(&T);
  return true;
}

/* A row of terms for a series in formulas */
static void report_formula(struct report *r, struct reported_sum sum, const char *quantity, const struct series *series)
{
  symbolic term[SYMBOLIC_ORDERS + 1]; /* velocities of the steady state begin with 1/T */
  sum.quantity = quantity;
  sum.term = term;
  sum.below = r->options->order.value;
  for (slong k = sum.first; k < sum.below; k++)
    term[k - sum.first] = symbolic_coefficient(sum.symbols, series, k);
  report_sum(r, &sum);
}

static bool report_phase(struct report *r, const struct reported_motion *m)
{
  const char *why = NULL;
  ENDED_BY(symbols_end) struct symbols s;
  symbols_init(&s);
  SCOPED(scallop_expansion, phase);
  enum scallop_status status = symbolic_expand_phase(&s, r->crawler, m->kind, m->v0, r->options->order.value, &phase,
                                                     &why);
  if (status != SCALLOP_OK)
    return report_failure(r, m, status, why);
  const struct reported_sum sum = { .motion = m, .modes = phase.modes, .symbols = &s };
  if (phase.switches) {
    report_formula(r, sum, "t1", &phase.t1);
    report_formula(r, sum, "dT", &phase.dT);
  }
  report_formula(r, sum, "v_end", &phase.v_end);
  report_formula(r, sum, "dx1", &phase.dx1);
  report_formula(r, sum, "dx2", &phase.dx2);
  report_formula(r, sum, "dxC", &phase.dxC);
  return true;
}

/* As series in T, or in closed form */
static bool report_steady(struct report *r, const struct reported_motion *m)
{
  static const char *const names[] = { "v_start", "v_mid", "displacement" };
  bool closed = is_from(r->options, "closed");
  struct symbolic_steady steady;
  const char *why = NULL;
  ENDED_BY(symbols_end) struct symbols s;
  symbols_init(&s);
  SCOPED(series, series);
  enum scallop_status status = symbolic_solve_steady(&s, r->crawler, &steady, &why);
  if (status != SCALLOP_OK)
    return report_failure(r, m, status, why);
  const symbolic values[] = { steady.v_start, steady.v_mid, steady.displacement };
  for (int i = 0; i < 3; i++) {
    struct reported_sum sum = { .motion = m, .modes = steady.modes, .symbols = &s };
    if (closed) {
      sum.quantity = names[i];
      sum.is_closed = true;
      sum.term = &values[i];
      sum.below = 1;
      report_sum(r, &sum);
    } else {
      sum.first = i < 2 ? -1 : 0;
      symbolic_in_T(&series, &s, values[i], r->options->order.value + 1);
      report_formula(r, sum, names[i], &series);
    }
  }
  return true;
}

/* The limit T -> 0 in powers of what makes it small */
static bool report_limit(struct report *r, enum limit_parameter in)
{
  static const char *const names[] = { "product", "alpha", "friction" };
  static const char *const small[] = { "(F1 - F2)*(2*alpha - 1)/(F1 + F2)", "2*alpha - 1", "(F1 - F2)/(F1 + F2)" };
  const struct reported_motion m = { "period", r->language ? names[in] : small[in], .of = OF_STEADY };
  const char *why = NULL;
  ENDED_BY(symbols_end) struct symbols s;
  symbols_init(&s);
  SCOPED(symbolic_limit, limit);
  enum scallop_status status = symbolic_expand_limit(&s, r->crawler, in, r->options->order.value, &limit, &why);
  if (status != SCALLOP_OK)
    return report_failure(r, &m, status, why);
  const struct reported_sum sum = { .motion = &m, .modes = limit.modes, .small = small[in], .symbols = &s };
  report_formula(r, sum, "U", &limit.term);
  return true;
}

static bool open_numbers(struct report *r)
{
  static const char *const columns[] = { "phase", "start", "quantity", "power", "coefficient",
                                         "sum",   "error", "status",   NULL };
  return report_open(r, "derived", columns, NULL,
                     "power: of the duration of the phase, or of the period; sum: of the terms so far at this T; "
                     "error: sum - exact");
}

static bool open_formulas(struct report *r)
{
  static const char *const columns[] = { "phase", "start", "quantity", "power", "coefficient", "modes", NULL };
  static const char *const limit_columns[] = { "phase", "in", "quantity", "power", "term", "modes", NULL };
  static const char names[] = "M = m1 + m2; L is the amplitude; l0/T^2, l3_0/T^3, k0/T^4, l5_0/T^5, ... are the "
                              "second, third, fourth, fifth, ... derivative of l at the start of a phase of duration "
                              "T, lT/T^2, l3_T/T^3, ... those at its end.";
  bool limit = is_from(r->options, "limit");
  const char *equation = limit ? symbolic_limit_equation(r->crawler) : NULL;
  char note[800];
  snprintf(note, sizeof note, "%s%s%s%s", names, equation ? " U is v_start T for T -> 0, the root of " : "",
           equation ? equation : "", equation ? "." : "");
  return report_open(r, NULL, limit ? limit_columns : columns, note,
                     limit ? NULL : "power: of T, the duration of the phase, or the period in the steady state");
}

/* What is asked for of the steady state, and of each phase, from rest and from v0. Had everything a series? */
static bool report_motions(struct report *r, const fmpq *rest, const fmpq *v0)
{
  const struct reported_motion steady = { "period", "steady", .of = OF_STEADY, .v0 = rest };
  bool formulas = r->options->symbolic, limit = is_from(r->options, "limit"), done = true;
  for (int in = 0; formulas && limit && in < LIMIT_PARAMETERS; in++)
    done = report_limit(r, (enum limit_parameter)in) && done;
  for (int i = 0; i < 4 && !limit && !is_from(r->options, "closed"); i++) {
    const struct reported_motion phase = { i < 2 ? "extension" : "contraction", i % 2 == 0 ? "rest" : "v0", OF_PHASE,
                                           i < 2 ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION, i % 2 == 0 ? rest : v0 };
    if (i % 2 == 0 || !fmpq_is_zero(v0))
      done = (formulas ? report_phase : report_numbers)(r, &phase) && done;
  }
  if (formulas && limit)
    return done;
  return (formulas ? report_steady : report_numbers)(r, &steady) && done;
}

/* Four digits, rounded away from what is claimed: C and the bound up, times down. */
static void write_rounded(struct table *t, const arb_t x, int direction)
{
  enum { SPARE = 1000, DIGITS = 4 }; /* a thousandth is more than the fourth digit's rounding */
  SCOPED(arb, shifted);
  (direction > 0 ? arb_get_ubound_arf : arb_get_lbound_arf)(arb_midref(shifted), x, BOUND_PRECISION);
  arb_mul_si(shifted, shifted, SPARE + direction, BOUND_PRECISION);
  arb_div_si(shifted, shifted, SPARE, BOUND_PRECISION);
  report_ball(t, shifted, DIGITS);
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

struct bounds { /* of v_start and displacement */
  struct scallop_bound of[2];
};
#define BOUNDS(of_type) of_type(scallop_bound, &s->of[0]) of_type(scallop_bound, &s->of[1])
SCOPED_PARTS(bounds, struct bounds, BOUNDS)

static enum exit_code report_bounds(struct report *r)
{
  static const char *const columns[] = { "quantity", "order", "C", "power", "T0", "bound", "T_end", "ends", NULL };
  const char *why = NULL;
  SCOPED(bounds, bounds);
  enum scallop_status status = scallop_steady_bounds(r->crawler, r->options->order.value, BOUND_PRECISION, bounds.of,
                                                     &why);
  if (status != SCALLOP_OK) {
    complain("series", "no bound: %s", why ? why : scallop_status_text(status));
    return EXIT_UNSOLVED;
  }
  if (!report_open(r, "bounds", columns, NULL,
                   "|exact - terms below T^order| <= C T^power for 0 < T <= T0; bound: C T^power at this T"))
    return EXIT_FILE;
  write_bound(r, &bounds.of[0], "v_start");
  write_bound(r, &bounds.of[1], "displacement");
  return report_close(r, true);
}

enum exit_code series_report(const struct series_options *o)
{
  enum { DEFAULT_DIGITS = 17 };
  SCOPED(scallop_rational, crawler);
  SCOPED(fmpq, rest, v0);
  struct report r = { .options = o,
                      .crawler = &crawler,
                      .digits = o->request.style.digits > 0 ? o->request.style.digits : DEFAULT_DIGITS,
                      .language = strcmp(o->emit.value, "latex") == 0    ? &language_latex
                                  : strcmp(o->emit.value, "python") == 0 ? &language_python
                                                                         : NULL };
  rational_point(&crawler, v0, &o->request.point);
  if (o->bound)
    return report_bounds(&r);
  if (!(o->symbolic ? open_formulas : open_numbers)(&r))
    return EXIT_FILE;
  return report_close(&r, report_motions(&r, rest, v0));
}
