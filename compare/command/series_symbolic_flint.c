/* series --symbolic: coefficients as formulas. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/symbolic/language.h"
#include "compare/points/point_flint.h"
#include "compare/command/emit_flint.h"
#include "compare/command/series_flint.h"

static const char *const columns[] = { "phase", "start", "quantity", "power", "coefficient", "modes", NULL };
static const char *const limit_columns[] = { "phase", "in", "quantity", "power", "term", "modes", NULL };

struct report {
  const struct series_options *options;
  struct scallop_rational_crawler crawler;
  fmpq_t v0;
  char why[240]; /* something could not be done: the first reason                                */
  bool as_table;
  struct table table;
  struct emission emission;
};

struct motion_names {
  const char *phase, *start, *modes;
};

static bool is_source(const struct report *r, const char *source)
{
  const struct given_word *given = &r->options->source;
  return strcmp(given->given ? given->value : "derived", source) == 0;
}

static void write_row(struct report *r, const struct motion_names *m, const char *quantity, const char *power,
                      const char *coefficient)
{
  const char *const cells[] = { m->phase, m->start, quantity, power, coefficient, m->modes };
  for (size_t i = 0; i < sizeof cells / sizeof *cells; i++)
    table_text(&r->table, cells[i]);
}

/* A row for a coefficient, or for a closed form, which has no power */
static void write_value(struct report *r, const struct motion_names *m, const char *quantity, const char *power,
                        struct symbols *s, symbolic value)
{
  struct written written = symbolic_written(s, value, 0, &language_text);
  char *text = flint_malloc(strlen(written.text) + 2);
  sprintf(text, "%s%s", written.negative ? "-" : "", written.text);
  write_row(r, m, quantity, power, text);
  flint_free(text);
  free(written.text);
}

static struct emitted emitted_of(const struct motion_names *m, const char *quantity, const struct symbols *s)
{
  return (
      struct emitted){ .phase = m->phase, .start = m->start, .quantity = quantity, .modes = m->modes, .symbols = s };
}

/* The terms of T^first times a series in T, or of one in `small`: a row for each that is not 0, or one row if all are;
 * or a formula with all of them. Where the variable is `small`, its power is part of the term. */
static void report_series(struct report *r, const struct motion_names *m, const char *quantity, struct symbols *s,
                          slong first, const struct symbolic_series *series, const char *small)
{
  struct written terms[SYMBOLIC_TERMS];
  struct emitted emitted = emitted_of(m, quantity, s);
  char power[24];
  bool any = false;
  emitted.terms = terms;
  emitted.below = series->length + first;
  emitted.small = small;
  for (slong k = 0; k < series->length; k++) {
    bool zero = symbolic_is_zero(series->term[k], s), say_zero = r->as_table && k == series->length - 1 && !any;
    if (zero && !say_zero)
      continue;
    any = true;
    snprintf(power, sizeof power, "%ld", zero ? 0 : (long)(k + first));
    if (r->as_table)
      write_value(r, m, quantity, power, s, series->term[k]);
    else {
      terms[emitted.count++] = symbolic_written(s, series->term[k], small ? 0 : k + first, r->emission.language);
      symbolic_uses(series->term[k], s, emitted.used);
    }
  }
  if (!r->as_table)
    emission_add(&r->emission, &emitted);
}

static void report_closed(struct report *r, const struct motion_names *m, const char *quantity, struct symbols *s,
                          symbolic value)
{
  if (r->as_table) {
    write_value(r, m, quantity, "-", s, value);
    return;
  }
  struct written term = symbolic_written(s, value, 0, r->emission.language);
  struct emitted emitted = emitted_of(m, quantity, s);
  emitted.terms = &term;
  emitted.count = 1;
  symbolic_uses(value, s, emitted.used);
  emission_add(&r->emission, &emitted);
}

static bool report_failure(struct report *r, const struct motion_names *m, enum scallop_status status, const char *why)
{
  char text[SCALLOP_BRANCH_TEXT + 240];
  const struct motion_names none = { m->phase, m->start, text };
  why = why ? why : scallop_status_text(status);
  if (r->why[0] == '\0')
    snprintf(r->why, sizeof r->why, "%s", why);
  snprintf(text, sizeof text, "no formula: %s", why);
  if (r->as_table)
    write_row(r, &none, "-", "-", "-");
  return false;
}

static bool report_phase(struct report *r, enum scallop_phase_kind kind, bool from_rest)
{
  struct motion_names m = { kind == SCALLOP_EXTENSION ? "extension" : "contraction", from_rest ? "rest" : "v0", NULL };
  struct symbols s;
  struct symbolic_phase phase;
  const char *why = NULL;
  fmpq_t v0;
  fmpq_init(v0);
  if (!from_rest)
    fmpq_set(v0, r->v0);
  symbols_init(&s);
  enum scallop_status status = symbolic_expand_phase(&s, &r->crawler, kind, v0, r->options->order.value, &phase, &why);
  if (status == SCALLOP_OK) {
    const struct symbolic_series *const series[] = { &phase.t1,  &phase.dT,  &phase.v_end,
                                                     &phase.dx1, &phase.dx2, &phase.dxC };
    static const char *const names[] = { "t1", "dT", "v_end", "dx1", "dx2", "dxC" };
    m.modes = phase.modes;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
      report_series(r, &m, names[i], &s, 0, series[i], NULL);
    symbols_end(&s);
  }
  fmpq_clear(v0);
  return status == SCALLOP_OK || report_failure(r, &m, status, why);
}

static bool report_steady(struct report *r, bool closed)
{
  static const char *const names[] = { "v_start", "v_mid", "displacement" };
  struct motion_names m = { "period", "steady", NULL };
  struct symbols s;
  struct symbolic_steady steady;
  const char *why = NULL;
  symbols_init(&s);
  enum scallop_status status = symbolic_solve_steady(&s, &r->crawler, &steady, &why);
  if (status != SCALLOP_OK)
    return report_failure(r, &m, status, why);
  const symbolic values[] = { steady.v_start, steady.v_mid, steady.displacement };
  m.modes = steady.modes;
  for (int i = 0; i < 3; i++) {
    slong first = i < 2 ? -1 : 0; /* velocities begin with 1/T */
    struct symbolic_series series = symbolic_series_of(&s, values[i], first, r->options->order.value - first);
    if (closed)
      report_closed(r, &m, names[i], &s, values[i]);
    else
      report_series(r, &m, names[i], &s, first, &series, NULL);
  }
  symbols_end(&s);
  return true;
}

/* The limit T -> 0 in powers of what makes it small */
static bool report_limit(struct report *r, enum limit_parameter in)
{
  static const char *const names[] = { "product", "alpha", "friction" };
  static const char *const small[] = { "(F1 - F2)*(2*alpha - 1)/(F1 + F2)", "2*alpha - 1", "(F1 - F2)/(F1 + F2)" };
  struct motion_names m = { "period", r->as_table ? small[in] : names[in], NULL };
  struct symbols s;
  struct symbolic_limit limit;
  const char *why = NULL;
  symbols_init(&s);
  enum scallop_status status = symbolic_expand_limit(&s, &r->crawler, in, r->options->order.value, &limit, &why);
  if (status != SCALLOP_OK)
    return report_failure(r, &m, status, why);
  m.modes = limit.modes;
  report_series(r, &m, "U", &s, 0, &limit.term, small[in]);
  symbols_end(&s);
  return true;
}

static bool report_all(struct report *r)
{
  bool done = true;
  if (is_source(r, "closed"))
    return report_steady(r, true);
  if (is_source(r, "limit")) {
    for (int in = 0; in < LIMIT_PARAMETERS; in++)
      done = report_limit(r, (enum limit_parameter)in) && done;
    return done;
  }
  for (int kind = 0; kind < 2; kind++) {
    done = report_phase(r, (enum scallop_phase_kind)kind, true) && done;
    if (!fmpq_is_zero(r->v0))
      done = report_phase(r, (enum scallop_phase_kind)kind, false) && done;
  }
  return report_steady(r, false) && done;
}

static const char names[] =
    "M = m1 + m2; L is the amplitude; l0/T^2, l3_0/T^3, k0/T^4, l5_0/T^5, ... are the second, third, fourth, fifth, "
    "... "
    "derivative of l at the start of a phase of duration T, lT/T^2, l3_T/T^3, ... those at its end.";

static bool begin(struct report *r)
{
  const struct series_options *o = r->options;
  const char *equation = is_source(r, "limit") ? symbolic_limit_equation(&r->crawler) : NULL;
  char command[80], note[800] = "";
  size_t used = (size_t)snprintf(command, sizeof command, "series --symbolic");
  if (!is_source(r, "derived"))
    used += (size_t)snprintf(command + used, sizeof command - used, " --source %s", o->source.value);
  if (!is_source(r, "closed"))
    snprintf(command + used, sizeof command - used, " --order %ld", o->order.value);
  snprintf(note, sizeof note, "%s%s%s%s", names, equation ? " U is v_start T for T -> 0, the root of " : "",
           equation ? equation : "", equation ? "." : "");
  if (!r->as_table)
    return emission_open(&r->emission, &o->request.style, o->emit.value, command, note);
  if (!table_head(&r->table, &o->request.style, "%s", command))
    return false;
  note_parameters(&r->table, &o->request.point, NULL, true);
  if (o->request.point.has_v0)
    table_note(&r->table, "v0: %s", o->request.point.written_v0);
  table_note(&r->table, "%s", note);
  if (!is_source(r, "limit"))
    table_note(&r->table, "power: of T, the duration of the phase, or the period in the steady state");
  table_columns(&r->table, is_source(r, "limit") ? limit_columns : columns);
  table_begin_rows(&r->table);
  return true;
}

enum exit_code series_symbolic(const struct series_options *options)
{
  struct report r = { .options = options, .as_table = strcmp(options->emit.value, "text") == 0 };
  enum exit_code code = EXIT_FILE;
  scallop_rational_init(&r.crawler);
  fmpq_init(r.v0);
  rational_point(&r.crawler, r.v0, &options->request.point);
  if (begin(&r)) {
    bool done = report_all(&r);
    if (r.as_table ? table_close(&r.table) : emission_close(&r.emission))
      code = done ? EXIT_DONE : EXIT_UNSOLVED;
  }
  if (code == EXIT_UNSOLVED)
    complain("series", "no formula: %s", r.why);
  scallop_rational_clear(&r.crawler);
  fmpq_clear(r.v0);
  return code;
}
