#include "compare/command/report_flint.h"

#include <math.h>
#include <stdlib.h>

#include "compare/points/point_flint.h"

static bool is_python(const struct report *r) { return r->language == &language_python; }

/* A line about what follows: a comment, or a note of the table. A name of a file in it ends no comment. */
static void __attribute__((format(printf, 2, 3))) remark(struct report *r, const char *format, ...)
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

static void remark_names(struct report *r)
{
  const char *equation = r->kind->has_phases || !r->kind->has_order ? NULL : symbolic_limit_equation(r->crawler);
  remark(
      r,
      "M = m1 + m2; L is the amplitude; l0/T^2, l3_0/T^3, k0/T^4, l5_0/T^5, ... are the second, third, fourth, "
      "fifth, ... derivative of l at the start of a phase of duration T, lT/T^2, l3_T/T^3, ... those at its end.%s%s%s",
      equation ? " U is v_start T for T -> 0, the root of " : "", equation ? equation : "", equation ? "." : "");
}

bool report_open(struct report *r)
{
  static const char *const varied[] = { "T", NULL };
  const struct request *request = &r->options->request;
  char parameters[PARAMETERS_TEXT], order[32] = "";
  int error = r->language ? file_open(&r->out, request->style.output) : 0;
  if (error != 0)
    return cannot_write(&request->style, error);
  if (!r->language && !table_open(&r->table, &request->style))
    return false;
  if (r->kind->has_order)
    snprintf(order, sizeof order, " --order %ld", r->options->order.value);
  remark(r, "scallop " SCALLOP_VERSION);
  remark(r, "command: series %s%s", r->kind->options, order);
  parameters_text(parameters, &request->point, r->language ? varied : NULL, true);
  remark(r, "parameters:%s", parameters);
  if (request->point.has_v0)
    remark(r, "v0: %s", request->point.written[PLACE_OF_V0]);
  if (r->options->symbolic)
    remark_names(r);
  if (r->language)
    remark(r, "T is the duration of the phase, or the period in the steady state.");
  else if (r->kind->meaning)
    remark(r, "%s", r->kind->meaning);
  if (!r->language) {
    r->table.of = r->kind->of;
    table_columns(&r->table, r->kind->columns);
    table_begin_rows(&r->table);
  }
  return true;
}

enum exit_code report_close(struct report *r, bool done)
{
  int error = r->language ? file_close(&r->out, true) : 0;
  if (error != 0)
    cannot_write(&r->options->request.style, error);
  if (error != 0 || (!r->language && !table_close(&r->table)))
    return EXIT_FILE;
  if (!done)
    complain("series", r->options->symbolic ? "no formula: %s" : "a motion has no series in powers of T: %s", r->why);
  return done ? EXIT_DONE : EXIT_UNSOLVED;
}

void report_ball(struct table *t, const arb_struct *x, long digits)
{
  char *text = x ? decimal_text(x, digits) : NULL;
  if (text)
    table_digits(t, text);
  else
    table_number(t, NAN);
  flint_free(text);
}

/* power: NULL, there is none; sum: so far, NULL where there are no numbers */
static void write_row(struct report *r, const struct reported_sum *s, const char *power, const char *term,
                      const arb_struct *sum)
{
  enum { ERROR_DIGITS = 3 };
  struct table *t = &r->table;
  table_text(t, s->motion->phase);
  table_text(t, s->motion->start);
  table_text(t, s->quantity);
  if (r->options->symbolic) {
    table_text(t, power ? power : "-");
    table_text(t, term);
    table_text(t, s->modes);
    return;
  }
  SCOPED(arb, error);
  if (sum && s->exact)
    arb_sub(error, sum, s->exact, s->precision);
  table_digits(t, power ? power : "nan");
  table_text(t, term);
  report_ball(t, sum, r->digits);
  report_ball(t, sum && s->exact ? error : NULL, ERROR_DIGITS);
  table_text(t, s->status);
}

bool report_failure(struct report *r, const struct reported_motion *motion, enum scallop_status status, const char *why)
{
  char text[sizeof r->why + 16];
  why = why ? why : scallop_status_text(status);
  if (!*r->why) /* it may stand in what ends with the motion */
    snprintf(r->why, sizeof r->why, "%s", why);
  snprintf(text, sizeof text, "no %s: %s", r->options->symbolic ? "formula" : "series", why);
  if (!r->language)
    write_row(r, &(struct reported_sum){ .motion = motion, .quantity = "-", .modes = text, .status = text }, NULL, "-",
              NULL);
  return false;
}

/* As a fraction, where it is one and no digits are asked for. In a program both of its sides must be doubles. */
static bool is_fraction(fmpq_t q, const struct report *r, const struct series *series, slong power)
{
  enum { LONGEST = 900 }; /* bits of a double's range */
  return r->options->request.style.digits == 0 && series_rational_coefficient(q, series, power)
         && (!r->language || (fmpz_bits(fmpq_numref(q)) < LONGEST && fmpz_bits(fmpq_denref(q)) < LONGEST));
}

/* The coefficient of T^power in a table; in a function or a formula, times that power. Where the variable is small, the
 * power is part of the term, and a closed form has none. */
static struct written term_of(const struct report *r, const struct reported_sum *s, slong power)
{
  const struct language *language = r->language ? r->language : &language_text;
  slong shown = !r->language || s->small || s->is_closed ? 0 : power;
  SCOPED(fmpq, q);
  SCOPED(arb, x);
  if (r->options->symbolic)
    return symbolic_written(s->symbols, symbolic_coefficient(s->symbols, s->series, power), shown, language);
  if (is_fraction(q, r, s->series, power))
    return symbolic_written(s->symbols, symbolic_fraction(s->symbols, q), shown, language);
  series_coefficient(x, s->series, power, bits_of_digits(r->digits) + 32);
  char *decimal = decimal_text(x, r->digits);
  struct written written = decimal_written(decimal, shown, language);
  flint_free(decimal);
  return written;
}

static void put_row(struct report *r, const struct reported_sum *s, slong power, struct written term)
{
  char number[24], *text = flint_malloc(strlen(term.text) + 2);
  SCOPED(arb, sum);
  sprintf(text, "%s%s", term.negative ? "-" : "", term.text);
  snprintf(number, sizeof number, "%ld", (long)(series_coefficient_is_zero(s->series, power) ? 0 : power));
  if (!r->options->symbolic)
    series_value(sum, s->series, s->T, power + 1, s->precision);
  write_row(r, s, s->is_closed ? NULL : number, text, sum);
  flint_free(text);
}

/* A name with the arguments of a function, which are the symbols in it, or what M and beta are made of; and M */
static void begin_function(FILE *out, const struct reported_sum *s, bool is_symbolic)
{
  static const enum symbol_meaning made[][2] = { { NAMED_M, NAMED_m1 },
                                                 { NAMED_M, NAMED_m2 },
                                                 { NAMED_beta, NAMED_alpha } };
  const char *gap = "";
  bool used[MOST_SYMBOLS] = { false }, has_M = false;
  for (slong k = s->first; is_symbolic && k < s->below; k++)
    symbolic_uses(symbolic_coefficient(s->symbols, s->series, k), s->symbols, used);
  for (int i = 0; i < s->symbols->count; i++)
    for (int k = 0; k < 3; k++)
      if (used[i] && s->symbols->list[i].meaning == made[k][0])
        used[symbols_place(s->symbols, made[k][1], 0, SCALLOP_EXTENSION)] = true;
  fprintf(out, "def %s_%s_%s(", s->motion->phase, s->motion->start, s->quantity);
  for (int i = 0; i < s->symbols->count; i++) {
    enum symbol_meaning meaning = s->symbols->list[i].meaning;
    has_M |= used[i] && meaning == NAMED_M;
    if (!used[i] || meaning == NAMED_M || meaning == NAMED_beta || meaning == NAMED_T)
      continue;
    fprintf(out, "%s%s", gap, s->symbols->list[i].name);
    gap = ", ";
  }
  fprintf(out, "%s%s):\n%s    return (", s->small ? "" : gap, s->small ? "" : "T", has_M ? "    M = m1 + m2\n" : "");
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

static void begin_sum(struct report *r, const struct reported_sum *s)
{
  char below[80] = "";
  if (!s->is_closed)
    snprintf(below, sizeof below, s->small ? "terms below (%s)^%ld, " : "terms below %s^%ld, ",
             s->small ? s->small : "T", (long)s->below);
  fputc('\n', r->out.stream);
  remark(r, "%s, %s %s%s: %smodes %s", s->quantity, s->motion->phase, s->motion->of == OF_PHASE ? "from " : "",
         s->motion->start, below, s->modes);
  if (is_python(r))
    begin_function(r->out.stream, s, r->options->symbolic);
  else
    begin_formula(r->out.stream, s->quantity);
}

static void put_term(const struct report *r, struct written term, bool is_first)
{
  const char *next = is_python(r) ? "\n           " : " \\\\\n  &\\quad", *sign = term.negative ? "-" : "";
  if (!is_first)
    sign = term.negative ? " - " : " + ";
  fprintf(r->out.stream, "%s%s%s", is_first ? "" : next, sign, term.text);
}

static void end_sum(const struct report *r, const struct reported_sum *s, bool has_terms)
{
  fputs(has_terms ? "" : "0", r->out.stream);
  if (!s->is_closed && !s->small && !is_python(r))
    fprintf(r->out.stream, " + O(T^{%ld})", (long)s->below);
  fputs(is_python(r) ? ")\n" : "\n\\end{align*}\n", r->out.stream);
}

void report_sum(struct report *r, const struct reported_sum *s)
{
  bool any = false;
  if (r->language)
    begin_sum(r, s);
  for (slong k = s->first; k < s->below; k++) {
    bool stands_alone = !any && !r->language && k == s->below - 1;
    if (series_coefficient_is_zero(s->series, k) && !stands_alone)
      continue;
    struct written term = term_of(r, s, k);
    if (r->language)
      put_term(r, term, !any);
    else
      put_row(r, s, k, term);
    free(term.text);
    any = true;
  }
  if (r->language)
    end_sum(r, s, any);
}
