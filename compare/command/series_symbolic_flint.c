/* series --symbolic: coefficients as formulas. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/command/emit_flint.h"

/* A row for a coefficient, or for a closed form, which has no power */
static void write_value(struct report *r, const struct emitted *e, const char *power, struct symbols *s, symbolic value)
{
  struct written written = symbolic_written(s, value, 0, &language_text);
  char *text = flint_malloc(strlen(written.text) + 2);
  sprintf(text, "%s%s", written.negative ? "-" : "", written.text);
  write_names(r, &e->names, e->quantity);
  table_text(&r->table, power);
  table_text(&r->table, text);
  table_text(&r->table, e->modes);
  flint_free(text);
  free(written.text);
}

/* The terms of T^first times a series in T, or of one in e->small: a row for each that is not 0, or one row if all are;
 * or a formula with all of them. Where the variable is small, its power is part of the term. A closed form is one
 * term. */
static void write_terms(struct report *r, struct emitted e, struct symbols *s, slong first,
                        const struct symbolic_series *series, bool closed)
{
  char power[24];
  bool any = false;
  e.symbols = s;
  e.below = closed ? 0 : series->length + first;
  for (slong k = 0; k < series->length; k++)
    symbolic_uses(series->term[k], s, e.used);
  if (r->language)
    emit_begin(r, &e);
  for (slong k = 0; k < series->length; k++) {
    bool zero = symbolic_is_zero(series->term[k], s), say_zero = !r->language && k == series->length - 1 && !any;
    if (zero && !say_zero && !closed)
      continue;
    any = true;
    snprintf(power, sizeof power, "%ld", zero ? 0 : (long)(k + first));
    if (r->language)
      emit_term(r, symbolic_written(s, series->term[k], e.small || closed ? 0 : k + first, r->language));
    else
      write_value(r, &e, closed ? "-" : power, s, series->term[k]);
  }
  if (r->language)
    emit_end(r, &e);
}

static bool report_phase(struct report *r, const struct motion_names *m)
{
  static const char *const names[] = { "t1", "dT", "v_end", "dx1", "dx2", "dxC" };
  struct symbols s;
  struct symbolic_phase phase;
  const char *why = NULL;
  SCOPED(fmpq, v0);
  if (m->from_v0)
    fmpq_set(v0, r->v0);
  symbols_init(&s);
  enum scallop_status status = symbolic_expand_phase(&s, r->crawler, m->kind, v0, r->options->order.value, &phase,
                                                     &why);
  if (status != SCALLOP_OK)
    return write_failure(r, m, status, why);
  const struct symbolic_series *const series[] = { &phase.t1,  &phase.dT,  &phase.v_end,
                                                   &phase.dx1, &phase.dx2, &phase.dxC };
  for (size_t i = 0; i < sizeof names / sizeof *names; i++)
    write_terms(r, (struct emitted){ .names = *m, .quantity = names[i], .modes = phase.modes }, &s, 0, series[i],
                false);
  symbols_end(&s);
  return true;
}

/* As series in T, or in closed form */
static bool report_steady(struct report *r, bool closed)
{
  static const char *const names[] = { "v_start", "v_mid", "displacement" };
  struct symbols s;
  struct symbolic_steady steady;
  const char *why = NULL;
  symbols_init(&s);
  enum scallop_status status = symbolic_solve_steady(&s, r->crawler, &steady, &why);
  if (status != SCALLOP_OK)
    return write_failure(r, &steady_motion, status, why);
  const symbolic values[] = { steady.v_start, steady.v_mid, steady.displacement };
  for (int i = 0; i < 3; i++) {
    slong first = i < 2 && !closed ? -1 : 0; /* velocities begin with 1/T */
    struct symbolic_series series = { 1, { values[i] } };
    if (!closed)
      series = symbolic_series_of(&s, values[i], first, r->options->order.value - first);
    write_terms(r, (struct emitted){ .names = steady_motion, .quantity = names[i], .modes = steady.modes }, &s, first,
                &series, closed);
  }
  symbols_end(&s);
  return true;
}

static bool report_motion(struct report *r, const struct motion_names *m)
{
  return m->of == OF_STEADY ? report_steady(r, false) : report_phase(r, m);
}

/* The limit T -> 0 in powers of what makes it small */
static bool report_limit(struct report *r, enum limit_parameter in)
{
  static const char *const names[] = { "product", "alpha", "friction" };
  static const char *const small[] = { "(F1 - F2)*(2*alpha - 1)/(F1 + F2)", "2*alpha - 1", "(F1 - F2)/(F1 + F2)" };
  const struct motion_names m = { .phase = "period", .start = r->language ? names[in] : small[in] };
  struct symbols s;
  struct symbolic_limit limit;
  const char *why = NULL;
  symbols_init(&s);
  enum scallop_status status = symbolic_expand_limit(&s, r->crawler, in, r->options->order.value, &limit, &why);
  if (status != SCALLOP_OK)
    return write_failure(r, &m, status, why);
  write_terms(r, (struct emitted){ .names = m, .quantity = "U", .modes = limit.modes, .small = small[in] }, &s, 0,
              &limit.term, false);
  symbols_end(&s);
  return true;
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

static bool report_formulas(struct report *r)
{
  bool done = true;
  if (is_from(r->options, "closed"))
    return report_steady(r, true);
  for (int in = 0; is_from(r->options, "limit") && in < LIMIT_PARAMETERS; in++)
    done = report_limit(r, (enum limit_parameter)in) && done;
  return is_from(r->options, "limit") ? done : report_motions(r, report_motion);
}

static enum exit_code report_all(struct report *r)
{
  return open_formulas(r) ? report_close(r, report_formulas(r)) : EXIT_FILE;
}

enum exit_code series_symbolic(const struct series_options *options) { return report_run(options, report_all); }
