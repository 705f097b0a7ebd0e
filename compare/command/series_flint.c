/* series --source derived|limit, --symbolic and --bound: each is a row of kinds[]. */
#include <math.h>

#include "compare/answers/answer_flint.h"
#include "compare/command/report_flint.h"
#include "compare/points/point_flint.h"

struct numbers { /* the expansion of a motion, and its certified values */
  const struct report *report;
  const struct reported_motion *motion;
  long order;
  fmpq_t T; /* of the phase, or the period */
  struct series_answer derived;
  struct ball_answer exact;
  /* of sums with the digits that their errors take */
  slong precision;
  arb_t at; /* T */
};
#define NUMBERS(of) of(fmpq, s->T) of(series_answer, &s->derived) of(ball_answer, &s->exact) of(arb, s->at)
SCOPED_PARTS(numbers, struct numbers, NUMBERS)

/* Is every coefficient exact, or has it the digits? */
static bool is_precise(const struct numbers *n)
{
  bool precise = true;
  SCOPED(arb, x);
  for (int q = 0; q < QUANTITIES; q++) {
    const struct series *s = n->derived.value[q];
    for (slong k = s ? s->first : n->order; k < n->order && s->kind == SERIES_BALLS && precise; k++) {
      series_coefficient(x, s, k, 64);
      precise = arb_rel_accuracy_bits(x) > bits_of_digits(n->report->digits) + 4 || arb_contains_zero(x);
    }
  }
  return precise;
}

/* Have the exact values the digits that the errors of all sums take? */
static bool errors_are_seen(const struct numbers *n)
{
  bool seen = true;
  SCOPED(arb, error);
  for (int q = 0; q < QUANTITIES; q++)
    if (n->derived.value[q] && n->exact.value[q]) {
      series_value(error, n->derived.value[q], n->at, n->order, n->precision);
      arb_sub(error, error, n->exact.value[q], n->precision);
      seen = seen && (arb_is_zero(error) || arb_rel_accuracy_bits(error) > 12);
    }
  return seen;
}

/* Expands the motion and, for a table, solves it, with as many digits as the coefficients and the errors take, within
 * reason. False: it has no series. */
static bool expand(struct numbers *n)
{
  enum { TRIES = 9, MOST_FAILURES = 6, MOST = 10000 };
  const struct reported_motion *m = n->motion;
  const struct scallop_rational_crawler *c = n->report->crawler;
  bool derived = false, enough = false;
  for (long i = 0, more = n->report->digits + 20; i < TRIES && !enough; i++, more *= 2) {
    long digits = more < MOST ? more : MOST;
    n->precision = 4 * digits + 128 + n->order;
    arb_set_fmpq(n->at, n->T, n->precision);
    if (!derived || n->derived.value[m->of == OF_STEADY ? Q_V_START : Q_V_END]->kind == SERIES_BALLS)
      derived = answer_in_series(&n->derived, c, m->of, m->kind, m->v0, n->order, n->precision);
    if (!derived && (n->derived.status == SCALLOP_EDOMAIN || i + 1 == MOST_FAILURES))
      return false;
    enough = derived && (is_precise(n) || i + 1 == TRIES)
             && (n->report->language || !answer_in_balls(&n->exact, c, m->of, m->kind, m->v0, digits) || digits == MOST
                 || errors_are_seen(n));
  }
  return derived;
}

/* Is the series, whose modes are those for T -> 0, about the motion? */
static void say_status(char *text, size_t size, const struct numbers *n)
{
  char modes[MOTION_MODES_TEXT];
  if (n->exact.status != SCALLOP_OK)
    snprintf(text, size, "not certified: %s", n->exact.why ? n->exact.why : scallop_status_text(n->exact.status));
  else if (strcmp(motion_modes_text(modes, n->motion->of, n->exact.modes), n->derived.modes) != 0)
    snprintf(text, size, "not of this motion: its modes are %s", modes);
  else
    snprintf(text, size, "ok");
}

static bool write_numbers(struct report *r, const struct reported_motion *m)
{
  bool limit = is_from(r->options, "limit");
  char status[2 * SCALLOP_MODES_TEXT + 240];
  ENDED_BY(symbols_end) struct symbols T;
  symbols_init(&T);
  symbols_add(&T, NAMED_T, 0, SCALLOP_EXTENSION);
  symbols_begin(&T);
  SCOPED(numbers, n);
  n.report = r;
  n.motion = m;
  n.order = limit ? 1 : r->options->order.value;
  if (m->of == OF_STEADY)
    fmpq_set(n.T, r->crawler->T);
  else
    scallop_rational_duration(n.T, r->crawler, m->kind);
  if (!expand(&n))
    return report_failure(r, m, n.derived.status, n.derived.why);
  say_status(status, sizeof status, &n);
  struct reported_sum sum = { m,         .modes = n.derived.modes, .symbols = &T, .precision = n.precision,
                              .T = n.at, .status = status };
  for (int q = 0; q < QUANTITIES; q++)
    if ((sum.series = n.derived.value[q])) {
      sum.quantity = quantity_rows[q].name;
      sum.first = sum.series->first < 0 ? sum.series->first : 0;
      sum.below = limit && sum.first < 0 ? 0 : n.order;
      sum.exact = n.exact.status == SCALLOP_OK ? n.exact.value[q] : NULL;
      report_sum(r, &sum);
    }
  return true;
}

static bool write_phase(struct report *r, const struct reported_motion *m)
{
  const char *why = NULL;
  ENDED_BY(symbols_end) struct symbols s;
  symbols_init(&s);
  SCOPED(scallop_phase_expansion, phase);
  enum scallop_status status = symbolic_expand_phase(&s, r->crawler, m->kind, m->v0, r->options->order.value, &phase,
                                                     &why);
  if (status != SCALLOP_OK)
    return report_failure(r, m, status, why);
  const struct series *const values[] = { &phase.t1, &phase.dT, &phase.v_end, &phase.dx1, &phase.dx2, &phase.dxC };
  for (int i = 0; i < 6; i++)
    report_sum(r, &(struct reported_sum){ m, quantity_rows[Q_T1 + i].name, phase.modes, values[i],
                                          .below = r->options->order.value, .symbols = &s });
  return true;
}

/* As series in T, or in closed form */
static bool write_steady(struct report *r, const struct reported_motion *m)
{
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
    struct reported_sum sum = { m, quantity_rows[Q_V_START + i].name, steady.modes, &series, .symbols = &s };
    sum.is_closed = is_from(r->options, "closed");
    sum.first = sum.is_closed || i == 2 ? 0 : -1;
    sum.below = sum.is_closed ? 1 : r->options->order.value;
    if (sum.is_closed)
      series_set_ratio(&series, values[i]);
    else
      symbolic_in_T(&series, &s, values[i], r->options->order.value + 1);
    report_sum(r, &sum);
  }
  return true;
}

static bool write_formulas(struct report *r, const struct reported_motion *m)
{
  return (m->of == OF_PHASE ? write_phase : write_steady)(r, m);
}

/* The limit T -> 0 in powers of each parameter that makes it small */
static bool write_limit(struct report *r, const struct reported_motion *m)
{
  static const char *const names[] = { "product", "alpha", "friction" };
  static const char *const small[] = { "(F1 - F2)*(2*alpha - 1)/(F1 + F2)", "2*alpha - 1", "(F1 - F2)/(F1 + F2)" };
  bool done = true;
  for (int in = 0; in < LIMIT_PARAMETERS; in++) {
    const struct reported_motion in_powers = { m->phase, r->language ? names[in] : small[in], .of = OF_STEADY };
    const char *why = NULL;
    ENDED_BY(symbols_end) struct symbols s;
    symbols_init(&s);
    SCOPED(symbolic_limit, limit);
    enum scallop_status status = symbolic_expand_limit(&s, r->crawler, (enum limit_parameter)in,
                                                       r->options->order.value, &limit, &why);
    if (status == SCALLOP_OK)
      report_sum(r, &(struct reported_sum){ &in_powers, "U", limit.modes, &limit.term, .below = r->options->order.value,
                                            .small = small[in], .symbols = &s });
    else
      done = report_failure(r, &in_powers, status, why);
  }
  return done;
}

enum { BOUND_PRECISION = 128 };

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
  arb_set_fmpq(T, r->crawler->T, BOUND_PRECISION);
  arb_pow_ui(here, T, (ulong)b->power, BOUND_PRECISION);
  arb_mul(here, here, b->C, BOUND_PRECISION);
  table_text(t, quantity);
  table_count(t, r->options->order.value);
  write_rounded(t, b->C, 1);
  table_count(t, b->power);
  write_rounded(t, b->T0, -1);
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
  const char *why = NULL;
  SCOPED(bounds, bounds);
  enum scallop_status status = scallop_steady_bounds(r->crawler, r->options->order.value, BOUND_PRECISION, bounds.of,
                                                     &why);
  if (status != SCALLOP_OK)
    return complain("series", "no bound: %s", why ? why : scallop_status_text(status)), EXIT_UNSOLVED;
  if (!report_open(r))
    return EXIT_FILE;
  write_bound(r, &bounds.of[0], "v_start");
  write_bound(r, &bounds.of[1], "displacement");
  return report_close(r, true);
}

static const struct report_kind kinds[] = {
#define NUMBERS_OF_TERMS \
  .of = "derived", .write = write_numbers, \
  .columns = { "phase", "start", "quantity", "power", "coefficient", "sum", "error", "status" }, \
  .meaning = \
      "power: of the duration of the phase, or of the period; sum: of the terms so far at this T; error: sum - " \
      "exact"
  { "--source derived", true, .has_phases = true, NUMBERS_OF_TERMS },
  { "--source limit", false, NUMBERS_OF_TERMS },
#define FORMULAS \
  .write = write_formulas, .columns = { "phase", "start", "quantity", "power", "coefficient", "modes" }, \
  .meaning = "power: of T, the duration of the phase, or the period in the steady state"
  { "--symbolic", true, .has_phases = true, FORMULAS },
  { "--symbolic --source closed", false, FORMULAS },
  { "--symbolic --source limit", true, .write = write_limit,
    .columns = { "phase", "in", "quantity", "power", "term", "modes" } },
  { "--bound", true, .of = "bounds", .columns = { "quantity", "order", "C", "power", "T0", "bound", "T_end", "ends" },
    .meaning = "|exact - terms below T^order| <= C T^power for 0 < T <= T0; bound: C T^power at this T" },
};

static const struct report_kind *kind_of(const struct series_options *o)
{
  bool limit = is_from(o, "limit");
  return &kinds[o->bound ? 5 : !o->symbolic ? limit : limit ? 4 : is_from(o, "closed") ? 3 : 2];
}

/* What is asked for of each phase, from rest and from v0, and of the steady state. Had everything a series? */
static bool write_motions(struct report *r, const fmpq *rest, const fmpq *v0)
{
  const struct reported_motion motions[] = {
    { "extension", "rest", OF_PHASE, SCALLOP_EXTENSION, rest },
    { "extension", "v0", OF_PHASE, SCALLOP_EXTENSION, v0 },
    { "contraction", "rest", OF_PHASE, SCALLOP_CONTRACTION, rest },
    { "contraction", "v0", OF_PHASE, SCALLOP_CONTRACTION, v0 },
    { "period", "steady", .of = OF_STEADY, .v0 = rest },
  };
  bool done = true;
  for (const struct reported_motion *m = motions; m < motions + 5; m++)
    if (m->of == OF_STEADY || (r->kind->has_phases && (m->v0 == rest || !fmpq_is_zero(v0))))
      done = r->kind->write(r, m) && done;
  return done;
}

enum exit_code series_report(const struct series_options *o)
{
  enum { DEFAULT_DIGITS = 17 };
  SCOPED(scallop_rational, crawler);
  SCOPED(fmpq, rest, v0);
  struct report r = { .kind = kind_of(o),
                      .options = o,
                      .crawler = &crawler,
                      .digits = o->request.style.digits > 0 ? o->request.style.digits : DEFAULT_DIGITS,
                      .language = strcmp(o->emit.value, "latex") == 0    ? &language_latex
                                  : strcmp(o->emit.value, "python") == 0 ? &language_python
                                                                         : NULL };
  rational_point(&crawler, v0, &o->request.point);
  if (o->bound)
    return report_bounds(&r);
  return report_open(&r) ? report_close(&r, write_motions(&r, rest, v0)) : EXIT_FILE;
}
