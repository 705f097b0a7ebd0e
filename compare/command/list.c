/* The commands by name, and the pages of help: the texts of docs/help/, with the lists of quantities and gaits. An item
 * of a list is two blanks, names, two blanks or more, and a text: scripts/dev/man.awk and completion.bash read it. */
#include <string.h>

#include "compare/command/commands.h"
#include "compare/text/shipped.h"

const struct command *const commands[] = { &command_phase,      &command_steady,
                                           &command_trajectory, &command_series,
                                           &command_claims,     &command_order,
                                           &command_figure,     &command_workprec,
                                           &command_stress,     &command_breakdown,
                                           &command_summary,    &command_run,
                                           &command_merge,      NULL };

const struct command *command_named(const char *name)
{
  const struct command *const *c = commands;
  while (*c && strcmp(name, (*c)->name) != 0)
    c++;
  return *c;
}

/* An item of a list: a name, and from the column on a text in as many lines as it takes */
static void print_item(FILE *to, const char *name, const char *text)
{
  enum { COLUMN = 22, WIDTH = 80 };
  int at = fprintf(to, "  %-*s ", COLUMN - 4, name);
  for (int word; *text; text += word + (text[word] == ' ')) {
    word = (int)strcspn(text, " ");
    if (at + 1 + word > WIDTH)
      at = fprintf(to, "\n%*s", COLUMN - 1, "") - 1;
    at += fprintf(to, " %.*s", word, text);
  }
  fputc('\n', to);
}

/* The quantities that a command prints; NULL: all, and behind them the formulas of quantities. */
static void list_quantities(FILE *to, const struct command *command)
{
  const int first = command ? command->quantities.first : 0;
  const int end = command ? command->quantities.end : NAMED_QUANTITIES;
  for (const struct quantity_row *row = quantity_rows + first;
       row < quantity_rows + end || (end == NAMED_QUANTITIES && row->formula); row++)
    print_item(to, row->name, wrong_text("%s [%s]", row->sentence, row->unit));
}

static void list_gaits(FILE *to)
{
  const struct scallop_gait_family *f;
  for (int i = 0; (f = gait_family(i)) != NULL; i++) {
    const char *name = !f->numbers ? f->name : wrong_text(f->usual ? "%s[:%s]" : "%s:%s", f->name, f->numbers);
    bool has_usual = f->numbers && f->usual;
    print_item(to, name, has_usual ? wrong_text("%s (%s)", f->sentence, f->usual) : f->sentence);
  }
}

void help_print(FILE *to, const char *name)
{
  for (const char *line = shipped_text(shipped_help, name), *next; line && *line; line = next) {
    next = line + strcspn(line, "\n") + 1;
    if (strncmp(line, "{quantities}", strlen("{quantities}")) == 0)
      list_quantities(to, command_named(name));
    else if (strncmp(line, "{gaits}", strlen("{gaits}")) == 0)
      list_gaits(to);
    else
      fprintf(to, "%.*s", (int)(next - line), line);
  }
}
