#include "compare/command/emit_flint.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/points/point_flint.h"
static bool is_python(const struct report *r) { return r->language == &language_python; }

/* A line about what the formulas are. A name of a file in it ends no comment. */
static void put_comment(struct report *r, const char *text)
{
  fputs(is_python(r) ? "# " : "% ", r->out.stream);
  for (; *text; text++)
    fputc((unsigned char)*text < 0x20 || *text == 0x7f ? '?' : *text, r->out.stream);
  fputc('\n', r->out.stream);
}

/* The options that say the same again */
static void command_text(char command[80], const struct series_options *o)
{
  bool has_source = !o->bound && !(o->symbolic && is_from(o, "derived"));
  bool has_order = o->symbolic ? !is_from(o, "closed") : !is_from(o, "limit");
  int used = snprintf(command, 80, "series%s%s%s",
                      o->symbolic ? " --symbolic"
                      : o->bound  ? " --bound"
                                  : "",
                      has_source ? " --source " : "", has_source ? o->source.value : "");
  if (has_order)
    snprintf(command + used, 80 - (size_t)used, " --order %ld", o->order.value);
}

static bool cannot_write(const struct style *style, int error)
{
  return complain(style->command, "cannot write %s: %s", style->output ? style->output : "standard output",
                  file_error(error));
}

static bool open_document(struct report *r, const char *command, const char *note)
{
  const struct style *style = &r->options->request.style;
  static const char *const not_held[] = { "T", NULL };
  char text[PARAMETERS_TEXT + NUMBER_LENGTH + 32];
  int error = file_open(&r->out, style->output);
  if (error != 0)
    return cannot_write(style, error);
  snprintf(text, sizeof text, "scallop %s: %s", SCALLOP_VERSION, command);
  put_comment(r, text);
  put_comment(r, "T is the duration of the phase, or the period in the steady state.");
  size_t used = (size_t)snprintf(text, sizeof text, "Parameters:");
  parameters_text(text + used, &r->options->request.point, not_held, true);
  if (r->options->request.point.has_v0)
    snprintf(text + strlen(text), sizeof text - strlen(text), " v0=%s", r->options->request.point.written[PLACE_OF_V0]);
  put_comment(r, note ? note : text);
  return true;
}

bool report_open(struct report *r, const char *of, const char *const *columns, const char *note, const char *more)
{
  const struct request *request = &r->options->request;
  char command[80];
  command_text(command, r->options);
  if (r->language)
    return open_document(r, command, note);
  if (!table_open(&r->table, &request->style))
    return false;
  r->table.of = of;
  table_note(&r->table, "scallop " SCALLOP_VERSION);
  table_note(&r->table, "command: %s", command);
  note_parameters(&r->table, &request->point, NULL, true);
  if (request->point.has_v0)
    table_note(&r->table, "v0: %s", request->point.written[PLACE_OF_V0]);
  if (note)
    table_note(&r->table, "%s", note);
  if (more)
    table_note(&r->table, "%s", more);
  table_columns(&r->table, columns);
  table_begin_rows(&r->table);
  return true;
}

enum exit_code report_close(struct report *r, bool done)
{
  const struct style *style = &r->options->request.style;
  int error = r->language ? file_close(&r->out, true) : 0;
  if (error != 0)
    cannot_write(style, error);
  if (error != 0 || (!r->language && !table_close(&r->table)))
    return EXIT_FILE;
  if (!done)
    complain("series", r->options->symbolic ? "no formula: %s" : "a motion has no series in powers of T: %s", r->why);
  return done ? EXIT_DONE : EXIT_UNSOLVED;
}

enum exit_code report_run(const struct series_options *o, enum exit_code (*one)(struct report *r))
{
  enum { DEFAULT_DIGITS = 17 };
  SCOPED(scallop_rational, crawler);
  SCOPED(fmpq, v0);
  struct report r = { .options = o,
                      .crawler = &crawler,
                      .v0 = v0,
                      .digits = o->request.style.digits > 0 ? o->request.style.digits : DEFAULT_DIGITS,
                      .language = strcmp(o->emit.value, "latex") == 0    ? &language_latex
                                  : strcmp(o->emit.value, "python") == 0 ? &language_python
                                                                         : NULL };
  rational_point(&crawler, v0, &o->request.point);
  return one(&r);
}

const struct motion_names steady_motion = { "period", "steady", .of = OF_STEADY };

void write_names(struct report *r, const struct motion_names *names, const char *quantity)
{
  table_text(&r->table, names->phase);
  table_text(&r->table, names->start);
  table_text(&r->table, quantity);
}

bool write_failure(struct report *r, const struct motion_names *names, enum scallop_status status, const char *why)
{
  bool formulas = r->options->symbolic;
  char text[SCALLOP_BRANCH_TEXT + 240];
  why = why ? why : scallop_status_text(status);
  if (!*r->why) /* it may stand in what ends with the motion */
    snprintf(r->why, sizeof r->why, "%s", why);
  if (r->language)
    return false;
  snprintf(text, sizeof text, "no %s: %s", formulas ? "formula" : "series", why);
  write_names(r, names, "-");
  for (const char *kind = formulas ? "--" : "n-nn"; *kind; kind++)
    if (*kind == 'n')
      table_number(&r->table, NAN);
    else
      table_text(&r->table, "-");
  table_text(&r->table, text);
  return false;
}

bool report_motions(struct report *r, bool (*one)(struct report *, const struct motion_names *))
{
  static const struct motion_names phases[] = { { "extension", "rest", OF_PHASE, SCALLOP_EXTENSION, false },
                                                { "extension", "v0", OF_PHASE, SCALLOP_EXTENSION, true },
                                                { "contraction", "rest", OF_PHASE, SCALLOP_CONTRACTION, false },
                                                { "contraction", "v0", OF_PHASE, SCALLOP_CONTRACTION, true } };
  bool done = true;
  for (int i = 0; i < 4; i++)
    if (!phases[i].from_v0 || !fmpq_is_zero(r->v0))
      done = one(r, &phases[i]) && done;
  return one(r, &steady_motion) && done;
}

static bool is_used(const struct emitted *e, enum symbol_meaning meaning)
{
  bool used = false;
  for (int i = 0; e->symbols && i < e->symbols->count; i++)
    used |= e->used[i] && e->symbols->list[i].meaning == meaning;
  return used;
}

/* M and beta are not arguments, but what they are made of is. */
static bool is_argument(const struct emitted *e, int i)
{
  enum symbol_meaning meaning = e->symbols->list[i].meaning;
  bool of_mass = meaning == NAMED_m1 || meaning == NAMED_m2;
  if (meaning == NAMED_M || meaning == NAMED_beta || meaning == NAMED_T)
    return false;
  return e->used[i] || (of_mass && is_used(e, NAMED_M)) || (meaning == NAMED_alpha && is_used(e, NAMED_beta));
}

/* A name with the arguments of a function, and what is computed first */
static void put_function(FILE *out, const struct emitted *e)
{
  const char *gap = "";
  fprintf(out, "def %s_%s_%s(", e->names.phase, e->names.start, e->quantity);
  for (int i = 0; e->symbols && i < e->symbols->count; i++)
    if (is_argument(e, i)) {
      fprintf(out, "%s%s", gap, e->symbols->list[i].name);
      gap = ", ";
    }
  fprintf(out, "%s):\n%s    return (",
          e->small ? ""
          : *gap   ? ", T"
                   : "T",
          is_used(e, NAMED_M) ? "    M = m1 + m2\n" : "");
}

/* t1, dT, dx1, v_end: a letter with an index, perhaps a difference; other names as they are */
static void put_name(FILE *out, const char *name)
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

void emit_begin(struct report *r, const struct emitted *e)
{
  char text[400], below[80] = "";
  if (e->below > 0)
    snprintf(below, sizeof below, e->small ? "terms below (%s)^%ld, " : "terms below %s^%ld, ",
             e->small ? e->small : "T", (long)e->below);
  snprintf(text, sizeof text, "%s, %s %s%s: %smodes %s", e->quantity, e->names.phase,
           strcmp(e->names.phase, "period") == 0 ? "" : "from ", e->names.start, below, e->modes);
  fputc('\n', r->out.stream);
  put_comment(r, text);
  if (is_python(r))
    put_function(r->out.stream, e);
  else
    put_name(r->out.stream, e->quantity);
  r->any = false;
}

void emit_term(struct report *r, struct written term)
{
  const char *next = is_python(r) ? "\n           " : " \\\\\n  &\\quad";
  fprintf(r->out.stream, "%s%s%s", r->any ? next : "",
          r->any          ? term.negative ? " - " : " + "
          : term.negative ? "-"
                          : "",
          term.text);
  r->any = true;
  free(term.text);
}

void emit_end(struct report *r, const struct emitted *e)
{
  fputs(r->any ? "" : "0", r->out.stream);
  if (e->below > 0 && !e->small && !is_python(r))
    fprintf(r->out.stream, " + O(T^{%ld})", (long)e->below);
  fputs(is_python(r) ? ")\n" : "\n\\end{align*}\n", r->out.stream);
}
