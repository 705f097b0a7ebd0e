/* Series in C, Python, LaTeX and MathML. */
#include "compare/command/emit_flint.h"

#include <stdlib.h>
#include <string.h>

/* What stands around the functions of a program, or the formulas of a document */
static const struct frame {
  const struct language *language;
  const char *escapes[9];                     /* what would end a text, and what stands in its place; in pairs       */
  const char *head[3];                        /* around and between the lines about where it comes from              */
  const char *comment[2];                     /* around what a function is                                           */
  const char *function, *type, *local, *stop; /* before a function's name, an argument, a local; behind a statement  */
  const char *formula, *name[2], *order[2];   /* in a document: before a formula, around a name, around T's power    */
  const char *begin, *sum, *next, *end,
      *tail; /* before the body, the terms, each further term; behind these; at last */
} frames[] = {
  { .language = &language_c,
    .escapes = { "*/", "* /", "/*", "/ *" },
    .head = { "/* ", "\n * ", " */\n#include <math.h>\n" },
    .comment = { "\n/* ", " */\n" },
    .function = "double ",
    .type = "double ",
    .local = "  const double ",
    .stop = ";\n",
    .begin = ")\n{\n",
    .sum = "  return ",
    .next = "\n        ",
    .end = ";\n}\n",
    .tail = "" },
  { .language = &language_python,
    .escapes = { "\\", "\\\\", "\"", "\\\"" },
    .head = { "\"\"\"", "\n", "\"\"\"\n" },
    .comment = { "\n\n# ", "\n" },
    .function = "def ",
    .type = "",
    .local = "    ",
    .stop = "\n",
    .begin = "):\n",
    .sum = "    return (",
    .next = "\n           ",
    .end = ")\n",
    .tail = "" },
  { .language = &language_latex,
    .head = { "% ", "\n% ", "\n" },
    .comment = { "\n% ", "\n" },
    .formula = "\\begin{align*}\n  ",
    .name = { "\\text{", "}" },
    .order = { " + O(T^{", "})" },
    .sum = " &= ",
    .next = " \\\\\n  &\\quad",
    .end = "\n\\end{align*}\n",
    .tail = "" },
  { .language = &language_mathml,
    .escapes = { "&", "&amp;", "<", "&lt;", ">", "&gt;", "\"", "&quot;" },
    .head = { "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><title>Series of the crawling "
              "scallop</title></head>\n"
              "<body>\n<p>",
              "<br>\n", "</p>\n" },
    .comment = { "\n<p>", "</p>\n" },
    .formula = "<math display=\"block\"><mtable displaystyle=\"true\"><mtr><mtd>",
    .name = { "<mtext>", "</mtext>" },
    .order = { "<mo>+</mo><mi>O</mi><mo stretchy=\"false\">(</mo><msup><mi>T</mi><mn>",
               "</mn></msup><mo stretchy=\"false\">)</mo>" },
    .sum = "</mtd><mtd style=\"text-align: left\"><mo>=</mo>",
    .next = "</mtd></mtr>\n  <mtr><mtd></mtd><mtd style=\"text-align: left\">",
    .end = "</mtd></mtr></mtable></math>\n",
    .tail = "</body>\n</html>\n" },
};

static const struct frame *frame_of(const struct language *language)
{
  const struct frame *frame = frames;
  while (frame->language != language)
    frame++;
  return frame;
}

/* A text, which may be the name of a file, in a comment or a paragraph: nothing in it ends that. */
static void put_text(FILE *out, const struct frame *frame, const char *text)
{
  for (int i; *text; text += frame->escapes[i] ? strlen(frame->escapes[i]) : 1) {
    for (i = 0; frame->escapes[i] && strncmp(text, frame->escapes[i], strlen(frame->escapes[i])) != 0;)
      i += 2;
    if (frame->escapes[i])
      fputs(frame->escapes[i + 1], out);
    else
      fputc((unsigned char)*text < 0x20 || *text == 0x7f ? '?' : *text, out);
  }
}

bool emission_open(struct emission *e, const struct style *style, const char *language, const char *command,
                   const char *note)
{
  const struct frame *frame = frames;
  while (strcmp(frame->language->name, language) != 0)
    frame++;
  *e = (struct emission){ .style = style, .language = frame->language };
  int error = file_open(&e->out, style->output);
  if (error != 0)
    return complain(style->command, "cannot write %s: %s", style->output ? style->output : "standard output",
                    file_error(error));
  fprintf(e->out.stream, "%sscallop %s: ", frame->head[0], SCALLOP_VERSION);
  put_text(e->out.stream, frame, command);
  fprintf(e->out.stream, "%sT is the duration of the phase, or the period in the steady state.", frame->head[1]);
  if (note) {
    fputs(frame->head[1], e->out.stream);
    put_text(e->out.stream, frame, note);
  }
  fputs(frame->head[2], e->out.stream);
  return true;
}

bool emission_close(struct emission *e)
{
  fputs(frame_of(e->language)->tail, e->out.stream);
  int error = file_close(&e->out, true);
  if (error != 0)
    complain(e->style->command, "cannot write %s: %s", e->style->output ? e->style->output : "standard output",
             file_error(error));
  return error == 0;
}

/* "dT, extension from rest: terms below T^8, modes -+ ++" */
static void put_comment(FILE *out, const struct frame *frame, const struct emitted *f)
{
  bool of_phase = strcmp(f->phase, "period") != 0;
  fprintf(out, "%s%s, %s %s%s: ", frame->comment[0], f->quantity, f->phase, of_phase ? "from " : "", f->start);
  if (f->below > 0)
    fprintf(out, f->small ? "terms below (%s)^%ld, " : "terms below %s^%ld, ", f->small ? f->small : "T",
            (long)f->below);
  fprintf(out, "modes %s%s", f->modes, frame->comment[1]);
}

static bool is_used(const struct emitted *f, enum symbol_meaning meaning)
{
  bool used = false;
  for (int i = 0; f->symbols && i < f->symbols->count; i++)
    used |= f->used[i] && f->symbols->list[i].meaning == meaning;
  return used;
}

/* M and beta are not arguments, but what they are made of is. */
static bool is_argument(const struct emitted *f, int i)
{
  enum symbol_meaning meaning = f->symbols->list[i].meaning;
  bool of_mass = meaning == NAMED_m1 || meaning == NAMED_m2;
  if (meaning == NAMED_M || meaning == NAMED_beta || meaning == NAMED_T)
    return false;
  return f->used[i] || (of_mass && is_used(f, NAMED_M)) || (meaning == NAMED_alpha && is_used(f, NAMED_beta));
}

static bool mentions(const struct emitted *f, const char *name)
{
  bool found = false;
  for (slong i = 0; i < f->count; i++)
    found |= strstr(f->terms[i].text, name) != NULL;
  return found;
}

/* A name with the arguments of a function, and what is computed first */
static void put_function(FILE *out, const struct frame *frame, const struct emitted *f)
{
  const char *gap = "";
  fprintf(out, "%s%s_%s_%s(", frame->function, f->phase, f->start, f->quantity);
  for (int i = 0; f->symbols && i < f->symbols->count; i++)
    if (is_argument(f, i)) {
      fprintf(out, "%s%s%s", gap, frame->type, f->symbols->list[i].name);
      gap = ", ";
    }
  if (!f->small)
    fprintf(out, "%s%sT", gap, frame->type);
  fputs(frame->begin, out);
  if (mentions(f, "M"))
    fprintf(out, "%sM = m1 + m2%s", frame->local, frame->stop);
  if (mentions(f, "beta"))
    fprintf(out, "%sbeta = 1 - alpha%s", frame->local, frame->stop);
}

/* t1, dT, dx1, v_end: a letter with an index, perhaps a difference; other names as they are */
static void put_name(FILE *out, const struct frame *frame, const char *name)
{
  struct symbol symbol = { .meaning = NAMED_T };
  bool difference = *name == 'd' && (name[1] == 'T' || name[1] == 'x');
  const char *letter = name + difference, *index = letter + 1 + (letter[1] == '_');
  fputs(frame->formula, out);
  if (strchr("txTUv", *letter) && strlen(index) < SYMBOL_NAME - 1) {
    snprintf(symbol.name, SYMBOL_NAME, "%c%s", *letter, index);
    char *text = symbol_written(&symbol, frame->language);
    fprintf(out, "%s%s", difference ? frame->language->difference : "", text);
    free(text);
    return;
  }
  fputs(frame->name[0], out);
  for (; *name; name++)
    fputc(*name == '_' ? ' ' : *name, out);
  fputs(frame->name[1], out);
}

void emission_add(struct emission *e, struct emitted *f)
{
  const struct frame *frame = frame_of(e->language);
  FILE *out = e->out.stream;
  put_comment(out, frame, f);
  if (frame->function)
    put_function(out, frame, f);
  else
    put_name(out, frame, f->quantity);
  fputs(frame->sum, out);
  for (slong i = 0; i < f->count; i++) {
    const struct written *term = &f->terms[i];
    fputs(i == 0 ? "" : frame->next, out);
    fputs(i > 0            ? term->negative ? e->language->minus : e->language->plus
          : term->negative ? e->language->sign
                           : "",
          out);
    fputs(term->text, out);
    free(term->text);
  }
  if (f->count == 0)
    fprintf(out, "%s0%s", e->language->number[0], e->language->number[1]);
  if (f->below > 0 && !f->small && frame->formula)
    fprintf(out, "%s%ld%s", frame->order[0], (long)f->below, frame->order[1]);
  fputs(frame->end, out);
}
