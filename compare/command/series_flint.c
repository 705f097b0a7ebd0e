/* Output of series --source derived|limit and --symbolic: quantities of motions as sums of terms, in a table, or each
 * as a function of T in Python or a formula in LaTeX. Each kind of output is a row of kinds[]. */
#include <math.h>
#include <stdlib.h>

#include "asymptotics/symbolic/language.h"
#include "compare/command/expansion_flint.h"
#include "compare/command/series_options.h"
#include "compare/points/point_flint.h"

static const char *const of_numbers[] = { "phase", "start", "quantity", "power", "coefficient",
                                          "sum",   "error", "status",   NULL };
static const char *const of_formulas[] = { "phase", "start", "quantity", "power", "coefficient", "modes", NULL };
static const char *const of_limit[] = { "phase", "in", "quantity", "power", "term", "modes", NULL };
static const char power_of_numbers[] =
    "power: of the duration of the phase, or of the period; sum: of the terms so far at this T; error: sum - exact";
static const char power_of_formulas[] = "power: of T, the duration of the phase, or the period in the steady state";

static const struct kind {
  bool symbolic;
  const char *source;
  bool has_order, has_phases; /* has_phases: single phases too, not only the steady state */
  const char *const *columns;
  const char *meaning; /* of the columns, or NULL */
  expander *expand;
} kinds[] = {
  { false, "derived", true, true, of_numbers, power_of_numbers, expand_numbers },
  { false, "limit", false, false, of_numbers, power_of_numbers, expand_numbers },
  { true, "derived", true, true, of_formulas, power_of_formulas, expand_formulas },
  { true, "closed", false, false, of_formulas, power_of_formulas, expand_formulas },
  { true, "limit", true, false, of_limit, NULL, expand_limit },
};

struct series_output {
  const struct kind *kind;
  const struct series_options *options;
  const struct scallop_rational_crawler *crawler; /* decimals as typed */
  long order, digits;                             /* terms below T^order; digits of decimal numbers */
  const struct language *language;                /* NULL: a table */
  char why[240];                                  /* reason of the first motion without a series */
  struct table table;
  struct file out; /* of a language */
};

struct motion_in_rows {
  const char *phase, *start; /* cells */
  enum quantity_of of;
  int which;         /* kind of phase; for the limit, the small parameter */
  bool from_v0;      /* else from rest */
  const char *small; /* for the limit, the expression of its powers, a part of the terms; else NULL */
};

static bool is_python(const struct series_output *r) { return r->language == &language_python; }

/* Writes a comment of the language, or a note of the table; a line break in a file name does not end it. */
static void __attribute__((format(printf, 2, 3))) remark(struct series_output *r, const char *format, ...)
{
  va_list arguments;
  va_start(arguments, format);
  char *text = printed_line(format, arguments, "");
  va_end(arguments);
  if (r->language)
    fprintf(r->out.stream, "%s %s\n", is_python(r) ? "#" : "%", text ? text : "");
  else
    table_note(&r->table, "%s", text ? text : "");
  free(text);
}

static bool cannot_write(const struct style *style, int error)
{
  return complain(style->command, "cannot write %s: %s", style->output ? style->output : "standard output",
                  file_error(error));
}

static void remark_names(struct series_output *r)
{
  const char *equation = r->kind->expand == expand_limit ? symbolic_limit_equation(r->crawler) : NULL;
  remark(
      r,
      "M = m1 + m2; L is the amplitude; l0/T^2, l3_0/T^3, k0/T^4, l5_0/T^5, ... are the second, third, fourth, "
      "fifth, ... derivative of l at the start of a phase of duration T, lT/T^2, l3_T/T^3, ... those at its end.%s%s%s",
      equation ? " U is v_start T for T -> 0, the root of " : "", equation ? equation : "", equation ? "." : "");
}

static bool open_output(struct series_output *r)
{
  static const char *const varied[] = { "T", NULL };
  const struct request *request = &r->options->request;
  const struct kind *k = r->kind;
  bool has_source = !k->symbolic || strcmp(k->source, "derived") != 0;
  char parameters[PARAMETERS_TEXT];
  int error = r->language ? file_open(&r->out, request->style.output) : 0;
  if (error != 0)
    return cannot_write(&request->style, error);
  if (!r->language && !table_open(&r->table, &request->style))
    return false;
  remark(r, "scallop " SCALLOP_VERSION);
  remark(r, "command: series%s%s%s%s", k->symbolic ? " --symbolic" : "", has_source ? " --source " : "",
         has_source ? k->source : "", k->has_order ? wrong_text(" --order %ld", r->order) : "");
  parameters_text(parameters, &request->point, r->language ? varied : NULL, true);
  remark(r, "parameters:%s", parameters);
  if (request->point.has_v0)
    remark(r, "v0: %s", request->point.written[PLACE_OF_V0]);
  if (k->symbolic)
    remark_names(r);
  if (r->language || k->meaning)
    remark(r, "%s", r->language ? "T is the duration of the phase, or the period in the steady state." : k->meaning);
  if (r->language)
    return true;
  r->table.of = k->symbolic ? NULL : "derived";
  table_columns(&r->table, k->columns);
  table_begin_rows(&r->table);
  return true;
}

/* done: every motion has a series */
static enum exit_code close_output(struct series_output *r, bool done)
{
  int error = r->language ? file_close(&r->out, true) : 0;
  if (error != 0)
    cannot_write(&r->options->request.style, error);
  if (error != 0 || (!r->language && !table_close(&r->table)))
    return EXIT_FILE;
  if (!done)
    complain("series", r->kind->symbolic ? "no formula: %s" : "a motion has no series in powers of T: %s", r->why);
  return done ? EXIT_DONE : EXIT_UNSOLVED;
}

/* Writes a number with the given digits; NULL: nan */
static void write_ball(struct table *t, const arb_struct *x, long digits)
{
  char *text = x ? decimal_text(x, digits) : NULL;
  table_digits(t, text ? text : "nan");
  flint_free(text);
}

/* Writes a row. power: NULL for a closed form; last: the last cell; sum and error: NULL for formulas */
static void write_row(struct series_output *r, const struct motion_in_rows *m, const char *quantity, const char *power,
                      const char *term, const char *last, const arb_struct *sum, const arb_struct *error)
{
  enum { ERROR_DIGITS = 3 };
  struct table *t = &r->table;
  table_text(t, m->phase);
  table_text(t, m->small ? m->small : m->start);
  table_text(t, quantity);
  if (r->kind->symbolic)
    table_carried(t, power ? power : "-");
  else
    table_digits(t, power ? power : "nan");
  table_text(t, term);
  if (!r->kind->symbolic) {
    write_ball(t, sum, r->digits);
    write_ball(t, error, ERROR_DIGITS);
  }
  table_text(t, last);
}

/* Writes the reason why a motion has no series, in the last column. */
static void write_failure(struct series_output *r, const struct motion_in_rows *m, const struct series_answer *a)
{
  const char *why = a->why ? a->why : scallop_status_text(a->status);
  if (!*r->why) /* a copy: the reason may be freed with the motion */
    snprintf(r->why, sizeof r->why, "%s", why);
  if (!r->language)
    write_row(r, m, "-", NULL, "-", wrong_text("no %s: %s", r->kind->symbolic ? "formula" : "series", why), NULL, NULL);
}

struct sum { /* terms of a quantity of a motion: powers from first to below - 1 */
  const struct motion_in_rows *motion;
  const char *quantity;
  const struct expansion *expansion;
  const struct series *series;
  slong first, below;
  const arb_struct *exact; /* NULL: it is not known */
};

/* Returns true, with the fraction, if the coefficient is one and --digits is not given. In a program, numerator and
 * denominator must be doubles. */
static bool is_fraction(fmpq_t q, const struct series_output *r, const struct series *series, slong power)
{
  enum { LONGEST = 900 }; /* bits of a double's range */
  return r->options->request.style.digits == 0 && series_rational_coefficient(q, series, power)
         && (!r->language || (fmpz_bits(fmpq_numref(q)) < LONGEST && fmpz_bits(fmpq_denref(q)) < LONGEST));
}

/* Returns the coefficient of T^power for a table, or the term with this power for a function or a formula. A small
 * parameter's power is already part of the term. */
static struct written term_of(const struct series_output *r, const struct sum *s, slong power)
{
  const struct language *language = r->language ? r->language : &language_text;
  struct symbols *symbols = s->expansion->symbols;
  slong shown = !r->language || s->motion->small ? 0 : power;
  SCOPED(fmpq, q);
  SCOPED(arb, x);
  if (r->kind->symbolic)
    return symbolic_written(symbols, symbolic_coefficient(symbols, s->series, power), shown, language);
  if (is_fraction(q, r, s->series, power))
    return symbolic_written(symbols, symbolic_fraction(symbols, q), shown, language);
  series_coefficient(x, s->series, power, bits_of_digits(r->digits) + 32);
  char *decimal = decimal_text(x, r->digits);
  struct written written = decimal_written(decimal, shown, language);
  flint_free(decimal);
  return written;
}

static void write_term(struct series_output *r, const struct sum *s, slong power, struct written term)
{
  const struct expansion *e = s->expansion;
  char *text = flint_malloc(strlen(term.text) + 2);
  SCOPED(arb, sum, error);
  sprintf(text, "%s%s", term.negative ? "-" : "", term.text);
  if (!r->kind->symbolic)
    series_value(sum, s->series, e->at, power + 1, e->precision);
  if (s->exact)
    arb_sub(error, sum, s->exact, e->precision);
  write_row(r, s->motion, s->quantity, e->is_closed ? NULL : wrong_text("%ld", (long)power), text,
            r->kind->symbolic ? e->derived.modes : e->status, sum, s->exact ? error : NULL);
  flint_free(text);
}

/* Writes the head of a function: its arguments are its symbols, with m1, m2 and alpha for M and beta; then defines
 * M. */
static void begin_function(FILE *out, const struct sum *s, bool is_symbolic)
{
  static const enum symbol_meaning made[][2] = { { NAMED_M, NAMED_m1 },
                                                 { NAMED_M, NAMED_m2 },
                                                 { NAMED_beta, NAMED_alpha } };
  struct symbols *symbols = s->expansion->symbols;
  const char *gap = "";
  bool used[MOST_SYMBOLS] = { false }, has_M = false;
  for (slong k = s->first; is_symbolic && k < s->below; k++)
    symbolic_uses(symbolic_coefficient(symbols, s->series, k), symbols, used);
  for (int i = 0; i < symbols->count; i++)
    for (int k = 0; k < 3; k++)
      if (used[i] && symbols->list[i].meaning == made[k][0])
        used[symbols_place(symbols, made[k][1], 0, SCALLOP_EXTENSION)] = true;
  fprintf(out, "def %s_%s_%s(", s->motion->phase, s->motion->start, s->quantity);
  for (int i = 0; i < symbols->count; i++) {
    enum symbol_meaning meaning = symbols->list[i].meaning;
    has_M |= used[i] && meaning == NAMED_M;
    if (!used[i] || meaning == NAMED_M || meaning == NAMED_beta || meaning == NAMED_T)
      continue;
    fprintf(out, "%s%s", gap, symbols->list[i].name);
    gap = ", ";
  }
  fprintf(out, "%s):\n%s    return (", s->motion->small ? "" : *gap ? ", T" : "T", has_M ? "    M = m1 + m2\n" : "");
}

static void begin_formula(FILE *out, const char *quantity)
{
  static const char *const names[][2] = {
    { "t1", "t_{1}" },
    { "dT", "\\Delta T" },
    { "v_end", "v_{end}" },
    { "dx1", "\\Delta x_{1}" },
    { "dx2", "\\Delta x_{2}" },
    { "dxC", "\\Delta x_{C}" },
    { "v_start", "v_{start}" },
    { "v_mid", "v_{mid}" },
    { "displacement", "\\text{displacement}" },
    { "mean_velocity", "\\text{mean velocity}" },
  };
  const char *name = quantity;
  for (size_t i = 0; i < sizeof names / sizeof *names; i++)
    name = strcmp(quantity, names[i][0]) == 0 ? names[i][1] : name;
  fprintf(out, "\\begin{align*}\n  %s &= ", name);
}

static void begin_sum(struct series_output *r, const struct sum *s)
{
  const struct motion_in_rows *m = s->motion;
  char below[80] = "";
  if (!s->expansion->is_closed)
    snprintf(below, sizeof below, m->small ? "terms below (%s)^%ld, " : "terms below %s^%ld, ",
             m->small ? m->small : "T", (long)s->below);
  fputc('\n', r->out.stream);
  remark(r, "%s, %s %s%s: %smodes %s", s->quantity, m->phase, m->of == OF_PHASE ? "from " : "", m->start, below,
         s->expansion->derived.modes);
  if (is_python(r))
    begin_function(r->out.stream, s, r->kind->symbolic);
  else
    begin_formula(r->out.stream, s->quantity);
}

static void put_term(const struct series_output *r, struct written term, bool is_first)
{
  const char *next = is_python(r) ? "\n           " : " \\\\\n  &\\quad", *sign = term.negative ? "-" : "";
  if (!is_first)
    sign = term.negative ? " - " : " + ";
  fprintf(r->out.stream, "%s%s%s", is_first ? "" : next, sign, term.text);
}

static void end_sum(const struct series_output *r, const struct sum *s, bool has_terms)
{
  fputs(has_terms ? "" : "0", r->out.stream);
  if (!s->expansion->is_closed && !s->motion->small && !is_python(r))
    fprintf(r->out.stream, " + O(T^{%ld})", (long)s->below);
  fputs(is_python(r) ? ")\n" : "\n\\end{align*}\n", r->out.stream);
}

/* Writes a row for each term other than 0, or one row if all are 0; or a function or a formula. */
static void write_sum(struct series_output *r, const struct sum *s)
{
  bool any = false;
  if (r->language)
    begin_sum(r, s);
  for (slong k = s->first; k < s->below; k++) {
    bool is_zero = series_coefficient_is_zero(s->series, k), is_only_row = !any && !r->language && k == s->below - 1;
    if (is_zero && !is_only_row)
      continue;
    struct written term = term_of(r, s, k);
    if (r->language)
      put_term(r, term, !any);
    else
      write_term(r, s, is_zero ? 0 : k, term);
    free(term.text);
    any = true;
  }
  if (r->language)
    end_sum(r, s, any);
}

/* Writes the quantities of a motion; false: it has no series. */
static bool write_motion(struct series_output *r, const struct motion_in_rows *m, const fmpq *v0)
{
  ENDED_BY(symbols_end) struct symbols symbols;
  symbols_init(&symbols);
  SCOPED(expansion, e);
  e.crawler = r->crawler;
  e.of = m->of;
  e.kind = m->small ? SCALLOP_EXTENSION : (enum scallop_phase_kind)m->which;
  e.in = m->small ? (enum limit_parameter)m->which : LIMIT_IN_PRODUCT;
  e.v0 = v0;
  e.order = r->order;
  e.digits = r->digits;
  e.is_certified = !r->language;
  e.is_closed = is_from(r->options, "closed");
  e.symbols = &symbols;
  r->kind->expand(&e);
  if (e.derived.status != SCALLOP_OK)
    return write_failure(r, m, &e.derived), false;
  for (int q = 0; q < QUANTITIES; q++)
    if (e.derived.value[q]) {
      struct sum sum = {
        m, m->small ? "U" : quantity_rows[q].name, &e, e.derived.value[q], 0, r->order, e.exact.value[q]
      };
      sum.first = sum.series->first < 0 ? sum.series->first : 0;
      if (sum.first < 0 && !r->kind->symbolic && !r->kind->has_order)
        sum.below = 0; /* the limit is the first term alone */
      write_sum(r, &sum);
    }
  return true;
}

/* Writes all motions: each phase, from rest and from v0, and the steady state. False: one of them has no series. */
static bool write_motions(struct series_output *r, const fmpq *rest, const fmpq *v0)
{
  static const struct motion_in_rows usual[] = {
    { "extension", "rest", OF_PHASE, SCALLOP_EXTENSION, false, NULL },
    { "extension", "v0", OF_PHASE, SCALLOP_EXTENSION, true, NULL },
    { "contraction", "rest", OF_PHASE, SCALLOP_CONTRACTION, false, NULL },
    { "contraction", "v0", OF_PHASE, SCALLOP_CONTRACTION, true, NULL },
    { "period", "steady", OF_STEADY, 0, false, NULL },
    { .phase = NULL },
  };
  static const struct motion_in_rows limits[] = {
    { "period", "product", OF_STEADY, LIMIT_IN_PRODUCT, false, "(F1 - F2)*(2*alpha - 1)/(F1 + F2)" },
    { "period", "alpha", OF_STEADY, LIMIT_IN_ALPHA, false, "2*alpha - 1" },
    { "period", "friction", OF_STEADY, LIMIT_IN_FRICTION, false, "(F1 - F2)/(F1 + F2)" },
    { .phase = NULL },
  };
  bool done = true;
  for (const struct motion_in_rows *m = r->kind->expand == expand_limit ? limits : usual; m->phase; m++)
    if ((m->of == OF_STEADY || r->kind->has_phases) && (!m->from_v0 || !fmpq_is_zero(v0)))
      done = write_motion(r, m, m->from_v0 ? v0 : rest) && done;
  return done;
}

enum exit_code series_report(const struct series_options *o)
{
  enum { DEFAULT_DIGITS = 17 };
  const struct kind *kind = kinds;
  while (kind->symbolic != o->symbolic || !is_from(o, kind->source))
    kind++;
  SCOPED(scallop_rational, crawler);
  SCOPED(fmpq, rest, v0);
  struct series_output r = { .kind = kind,
                             .options = o,
                             .crawler = &crawler,
                             .order = kind->has_order ? o->order.value : 1,
                             .digits = o->request.style.digits > 0 ? o->request.style.digits : DEFAULT_DIGITS,
                             .language = strcmp(o->emit.value, "latex") == 0    ? &language_latex
                                         : strcmp(o->emit.value, "python") == 0 ? &language_python
                                                                                : NULL };
  rational_point(&crawler, v0, &o->request.point);
  if (o->bound)
    return series_bound(o, &crawler);
  return open_output(&r) ? close_output(&r, write_motions(&r, rest, v0)) : EXIT_FILE;
}
