/* series --symbolic: coefficients as formulas. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/derived/scoped.h"
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

/* The terms of a series in T below T^below, or of one in e->small: a row for each that is not 0, or one row if all are;
 * or a formula with all of them. Where the variable is small, its power is part of the term. */
static void write_terms(struct report *r, struct emitted e, struct symbols *s, const struct series *series, slong below)
{
  char power[24];
  const slong first = series->first < below ? series->first : 0;
  bool any = false;
  e.symbols = s;
  e.below = below;
  for (slong k = first; k < below; k++)
    symbolic_uses(symbolic_coefficient(s, series, k), s, e.used);
  if (r->language)
    emit_begin(r, &e);
  for (slong k = first; k < below; k++) {
    symbolic term = symbolic_coefficient(s, series, k);
    const bool zero = ratio_is_zero(term), say_zero = !r->language && k == below - 1 && !any;
    if (zero && !say_zero)
      continue;
    any = true;
    snprintf(power, sizeof power, "%ld", zero ? 0 : (long)k);
    if (r->language)
      emit_term(r, symbolic_written(s, term, e.small ? 0 : k, r->language));
    else
      write_value(r, &e, power, s, term);
  }
  if (r->language)
    emit_end(r, &e);
}

/* A closed form, as the one term of a formula */
static void write_closed(struct report *r, struct emitted e, struct symbols *s, symbolic value)
{
  e.symbols = s;
  symbolic_uses(value, s, e.used);
  if (r->language) {
    emit_begin(r, &e);
    emit_term(r, symbolic_written(s, value, 0, r->language));
    emit_end(r, &e);
  } else
    write_value(r, &e, "-", s, value);
}

static bool report_phase(struct report *r, const struct motion_names *m)
{
  static const char *const names[] = { "t1", "dT", "v_end", "dx1", "dx2", "dxC" };
  const slong order = r->options->order.value;
  const char *why = NULL;
  ENDED_BY(symbols_end) struct symbols s;
  symbols_init(&s);
  SCOPED(scallop_phase_expansion, phase);
  SCOPED(fmpq, v0);
  if (m->from_v0)
    fmpq_set(v0, r->v0);
  enum scallop_status status = symbolic_expand_phase(&s, r->crawler, m->kind, v0, order, &phase, &why);
  if (status != SCALLOP_OK)
    return write_failure(r, m, status, why);
  const struct series *const series[] = { &phase.t1, &phase.dT, &phase.v_end, &phase.dx1, &phase.dx2, &phase.dxC };
  for (size_t i = 0; i < sizeof names / sizeof *names; i++)
    write_terms(r, (struct emitted){ .names = *m, .quantity = names[i], .modes = phase.modes }, &s, series[i], order);
  return true;
}

/* As series in T, or in closed form */
static bool report_steady(struct report *r, bool closed)
{
  static const char *const names[] = { "v_start", "v_mid", "displacement" };
  const slong order = r->options->order.value;
  const char *why = NULL;
  struct symbolic_steady steady;
  ENDED_BY(symbols_end) struct symbols s;
  symbols_init(&s);
  SCOPED(series, series);
  enum scallop_status status = symbolic_solve_steady(&s, r->crawler, &steady, &why);
  if (status != SCALLOP_OK)
    return write_failure(r, &steady_motion, status, why);
  const symbolic values[] = { steady.v_start, steady.v_mid, steady.displacement };
  for (int i = 0; i < 3; i++) {
    const struct emitted e = { .names = steady_motion, .quantity = names[i], .modes = steady.modes };
    if (closed)
      write_closed(r, e, &s, values[i]);
    else {
      symbolic_in_T(&series, &s, values[i], order + 1); /* velocities begin with 1/T */
      write_terms(r, e, &s, &series, order);
    }
  }
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
  const char *why = NULL;
  ENDED_BY(symbols_end) struct symbols s;
  symbols_init(&s);
  SCOPED(symbolic_limit, limit);
  enum scallop_status status = symbolic_expand_limit(&s, r->crawler, in, r->options->order.value, &limit, &why);
  if (status != SCALLOP_OK)
    return write_failure(r, &m, status, why);
  write_terms(r, (struct emitted){ .names = m, .quantity = "U", .modes = limit.modes, .small = small[in] }, &s,
              &limit.term, r->options->order.value);
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
