/* The commands by name, and what --help prints: texts of docs/help/, and the lists of quantities and gaits, in which
 * scripts/dev/completion.bash finds names: two blanks, a name, two blanks or more, what it is for. */
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
static void print_item(FILE *to, const char *name, int column, const char *text)
{
  enum { WIDTH = 100 };
  int at = fprintf(to, "  %-*s  ", column - 4, name);
  bool begins = true;
  for (int word; *text; text += word + (text[word] == ' '), begins = false) {
    word = (int)strcspn(text, " ");
    if (!begins && at + 1 + word > WIDTH)
      at = fprintf(to, "\n%*s", column, "") - 1;
    else if (!begins)
      at += fprintf(to, " ");
    at += fprintf(to, "%.*s", word, text);
  }
  fputc('\n', to);
}

/* Those that are formulas stand behind the list of all. */
static void list_quantities(FILE *to, int first, int end)
{
  fputs("\nQuantities (with their units):\n", to);
  for (const struct quantity_row *row = quantity_rows + first;
       row < quantity_rows + end || (end == NAMED_QUANTITIES && row->formula); row++)
    print_item(to, row->name, 22, wrong_text("%s [%s]", row->sentence, row->unit));
}

static void list_gaits(FILE *to)
{
  const struct scallop_gait_family *f;
  fputs("\nGaits (with their usual numbers):\n", to);
  for (int i = 0; (f = gait_family(i)) != NULL; i++) {
    const char *name = !f->numbers ? f->name : wrong_text(f->usual ? "%s[:%s]" : "%s:%s", f->name, f->numbers);
    bool has_usual = f->numbers && f->usual;
    print_item(to, name, 26, has_usual ? wrong_text("%s (%s)", f->sentence, f->usual) : f->sentence);
  }
}

void help_of(FILE *to, const struct command *command)
{
  fputs(shipped_text(shipped_help, command ? command->name : "scallop"), to);
  if (command && command->quantities.end > 0)
    list_quantities(to, command->quantities.first, command->quantities.end);
  if (command && option_of(command, "gait"))
    list_gaits(to);
}
