#include "compare/command/report_flint.h"

#include <math.h>
#include <stdlib.h>

#include "compare/points/point_flint.h"

enum { ERROR_DIGITS = 3 };

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

/* The options that say the same again */
static void remark_command(struct report *r)
{
  const struct series_options *o = r->options;
  bool has_source = !o->bound && !(o->symbolic && is_from(o, "derived"));
  bool has_order = o->symbolic ? !is_from(o, "closed") : !is_from(o, "limit");
  char order[32] = "";
  if (has_order)
    snprintf(order, sizeof order, " --order %ld", o->order.value);
  remark(r, "command: series%s%s%s%s",
         o->symbolic ? " --symbolic"
         : o->bound  ? " --bound"
                     : "",
         has_source ? " --source " : "", has_source ? o->source.value : "", order);
}

static bool cannot_write(const struct style *style, int error)
{
  return complain(style->command, "cannot write %s: %s", style->output ? style->output : "standard output",
                  file_error(error));
}

bool report_open(struct report *r, const char *of, const char *const *columns, const char *note, const char *more)
{
  static const char *const varied[] = { "T", NULL };
  const struct request *request = &r->options->request;
  char parameters[PARAMETERS_TEXT];
  int error = r->language ? file_open(&r->out, request->style.output) : 0;
  if (error != 0)
    return cannot_write(&request->style, error);
  if (!r->language && !table_open(&r->table, &request->style))
    return false;
  remark(r, "scallop " SCALLOP_VERSION);
  remark_command(r);
  parameters_text(parameters, &request->point, r->language ? varied : NULL, true);
  remark(r, "parameters:%s", parameters);
  if (request->point.has_v0)
    remark(r, "v0: %s", request->point.written[PLACE_OF_V0]);
  if (note)
    remark(r, "%s", note);
  if (r->language)
    remark(r, "T is the duration of the phase, or the period in the steady state.");
  else if (more)
    remark(r, "%s", more);
  if (!r->language) {
    r->table.of = of;
    table_columns(&r->table, columns);
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

static void write_names(struct table *t, const struct reported_motion *motion, const char *quantity)
{
  table_text(t, motion->phase);
  table_text(t, motion->start);
  table_text(t, quantity);
}

bool report_failure(struct report *r, const struct reported_motion *motion, enum scallop_status status, const char *why)
{
  bool formulas = r->options->symbolic;
  char text[sizeof r->why + 16];
  why = why ? why : scallop_status_text(status);
  if (!*r->why) /* it may stand in what ends with the motion */
    snprintf(r->why, sizeof r->why, "%s", why);
  if (r->language)
    return false;
  snprintf(text, sizeof text, "no %s: %s", formulas ? "formula" : "series", why);
  write_names(&r->table, motion, "-");
  for (const char *kind = formulas ? "--" : "n-nn"; *kind; kind++)
    if (*kind == 'n')
      table_number(&r->table, NAN);
    else
      table_text(&r->table, "-");
  table_text(&r->table, text);
  return false;
}

void report_ball(struct table *t, const arb_t x, long digits)
{
  char *text = decimal_text(x, digits);
  table_digits(t, text);
  flint_free(text);
}

bool report_error(arb_t error, const arb_t sum, const arb_t exact, slong precision)
{
  arb_sub(error, sum, exact, precision);
  return arb_is_zero(error) || arb_rel_accuracy_bits(error) > 12;
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
  if (s->term)
    return symbolic_written(s->symbols, s->term[power - s->first], shown, language);
  if (is_fraction(q, r, s->series, power))
    return symbolic_written(s->symbols, symbolic_fraction(s->symbols, q), shown, language);
  series_coefficient(x, s->series, power, bits_of_digits(r->digits) + 32);
  char *decimal = decimal_text(x, r->digits);
  struct written written = decimal_written(decimal, shown, language);
  flint_free(decimal);
  return written;
}

static bool is_zero(const struct reported_sum *s, slong power)
{
  return s->term ? ratio_is_zero(s->term[power - s->first]) : series_coefficient_is_zero(s->series, power);
}

/* With all digits that the exact value has */
static slong precision_of(const struct report *r, const struct reported_sum *s)
{
  slong accuracy = s->exact ? arb_rel_accuracy_bits(s->exact) : 0, precision = bits_of_digits(r->digits) + 128;
  return accuracy < WORD_MAX / 4 && accuracy + 64 > precision ? accuracy + 64 : precision;
}

static void add_term(arb_t sum, const struct reported_sum *s, slong power, slong precision)
{
  SCOPED(arb, T, term);
  arb_set_fmpq(T, s->T, precision);
  series_coefficient(term, s->series, power, precision);
  arb_pow_ui(T, T, (ulong)labs(power), precision);
  if (power < 0)
    arb_inv(T, T, precision);
  arb_addmul(sum, term, T, precision);
}

/* sum: of a series, with this term */
static void write_row(struct report *r, const struct reported_sum *s, slong power, struct written term, const arb_t sum)
{
  struct table *t = &r->table;
  char number[24];
  snprintf(number, sizeof number, "%ld", (long)power);
  char *text = flint_malloc(strlen(term.text) + 2);
  sprintf(text, "%s%s", term.negative ? "-" : "", term.text);
  write_names(t, s->motion, s->quantity);
  (s->term ? table_text : table_digits)(t, s->is_closed ? "-" : number);
  table_text(t, text);
  flint_free(text);
  if (s->term) {
    table_text(t, s->modes);
    return;
  }
  SCOPED(arb, error);
  report_ball(t, sum, r->digits);
  if (s->exact) {
    report_error(error, sum, s->exact, precision_of(r, s));
    report_ball(t, error, ERROR_DIGITS);
  } else
    table_number(t, NAN);
  table_text(t, s->status);
}

static bool uses(const struct reported_sum *s, const bool *used, enum symbol_meaning meaning)
{
  bool found = false;
  for (int i = 0; i < s->symbols->count; i++)
    found |= used[i] && s->symbols->list[i].meaning == meaning;
  return found;
}

/* M and beta are not arguments, but what they are made of is. */
static bool is_argument(const struct reported_sum *s, const bool *used, int i)
{
  enum symbol_meaning meaning = s->symbols->list[i].meaning;
  bool of_mass = meaning == NAMED_m1 || meaning == NAMED_m2;
  if (meaning == NAMED_M || meaning == NAMED_beta || meaning == NAMED_T)
    return false;
  return used[i] || (of_mass && uses(s, used, NAMED_M)) || (meaning == NAMED_alpha && uses(s, used, NAMED_beta));
}

/* A name with the arguments of a function, and what is computed first */
static void begin_function(FILE *out, const struct reported_sum *s)
{
  const char *gap = "";
  bool used[MOST_SYMBOLS] = { false };
  for (slong k = s->first; s->term && k < s->below; k++)
    symbolic_uses(s->term[k - s->first], s->symbols, used);
  fprintf(out, "def %s_%s_%s(", s->motion->phase, s->motion->start, s->quantity);
  for (int i = 0; i < s->symbols->count; i++)
    if (is_argument(s, used, i)) {
      fprintf(out, "%s%s", gap, s->symbols->list[i].name);
      gap = ", ";
    }
  if (!s->small)
    fprintf(out, "%sT", gap);
  fprintf(out, "):\n%s    return (", uses(s, used, NAMED_M) ? "    M = m1 + m2\n" : "");
}

/* t1, dT, dx1, v_end: a letter with an index, perhaps a difference; other names as they are */
static void begin_formula(FILE *out, const char *name)
{
  bool difference = *name == 'd' && (name[1] == 'T' || name[1] == 'x');
  const char *letter = name + difference, *index = letter + 1 + (letter[1] == '_');
  bool has_index = strchr("txTUv", *letter) && !strchr(index, '_');
  fprintf(out, "\\begin{align*}\n  ");
  if (has_index)
    fprintf(out, *index ? "%s%c_{%s}" : "%s%c", difference ? "\\Delta " : "", *letter, index);
  else
    fprintf(out, "\\text{");
  for (; !has_index && *name; name++)
    fputc(*name == '_' ? ' ' : *name, out);
  fprintf(out, has_index ? " &= " : "} &= ");
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
    begin_function(r->out.stream, s);
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
  SCOPED(arb, sum);
  bool any = false;
  if (r->language)
    begin_sum(r, s);
  for (slong k = s->first; k < s->below; k++) {
    bool zero = is_zero(s, k), alone = !any && (s->is_closed || (!r->language && k == s->below - 1));
    if (zero && !alone)
      continue;
    struct written term = term_of(r, s, k);
    if (s->series)
      add_term(sum, s, k, precision_of(r, s));
    if (r->language)
      put_term(r, term, !any);
    else
      write_row(r, s, zero ? 0 : k, term, sum);
    free(term.text);
    any = true;
  }
  if (r->language)
    end_sum(r, s, any);
}
