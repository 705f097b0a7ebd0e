#include "compare/command/man.h"

#include <ctype.h>
#include <string.h>

#include "compare/command/about.h"
#include "compare/command/commands.h"
#include "compare/command/compare.h"
#include "compare/command/help.h"
#include "compare/command/option_table.h"
#include "compare/command/roff.h"

/* When the wording of the pages was last revised: they are the same whenever they are written. */
static const char revised[] = "2026-11-22";

static const char prefix[] = "scallop-";

enum { NAME = 64 };

/* The name of the page of a command, or, where that is NULL, of the overview. */
static const char *page_name(char name[NAME], const char *command)
{
  snprintf(name, NAME, "%s%s", command ? prefix : "scallop", command ? command : "");
  return name;
}

static void title(struct roff *r, const char *page)
{
  fprintf(r->to, ".\\\" Written by scallop --man %s\n.TH ", page);
  for (const char *p = page; *p; p++)
    if (*p == '-')
      fputs("\\-", r->to);
    else
      putc(toupper((unsigned char)*p), r->to);
  fprintf(r->to, " 1 %s \"scallop %s\" \"The crawling\\-scallop toolkit\"\n", revised, SCALLOP_VERSION);
}

static void name_section(struct roff *r, const char *page, const char *summary)
{
  roff_macro(r, "SH", "NAME");
  roff_text(r, page);
  roff_text(r, "-");
  roff_text(r, summary);
}

/* What an option or a request takes: its own name in bold, those of its values in italics. */
static void tag(struct roff *r, const char *name, const char *placeholder)
{
  char option[NAME];
  snprintf(option, sizeof option, "--%s", name);
  roff_macro(r, "TP", NULL);
  roff_font(r, "", 'B', option, "");
  if (placeholder)
    roff_font(r, "", 'I', placeholder, "");
  roff_break(r);
}

static void example_section(struct roff *r, const char *example)
{
  roff_macro(r, "SH", "EXAMPLE");
  roff_macro(r, "EX", NULL);
  roff_line(r, example);
  roff_macro(r, "EE", NULL);
}

static void exit_section(struct roff *r)
{
  roff_macro(r, "SH", "EXIT STATUS");
  for (int code = 0; exit_meanings[code]; code++) {
    roff_macro(r, "TP", NULL);
    roff_bold_line(r, (const char[]){ (char)('0' + code) }, 1);
    roff_text(r, exit_meanings[code]);
  }
  roff_macro(r, "PP", NULL);
  roff_text(r, exit_notes);
}

/* A page that is referred to; after: a comma, if another one follows. */
static void reference(struct roff *r, const char *command, const char *after)
{
  char name[NAME], section[8];
  snprintf(section, sizeof section, "(1)%s", after);
  roff_font(r, "", 'B', page_name(name, command), section);
}

/* All pages but that of a command, or but the overview. */
static void see_also_section(struct roff *r, const char *but)
{
  roff_macro(r, "SH", "SEE ALSO");
  if (but)
    reference(r, NULL, ",");
  for (const struct command *const *c = commands; *c; c++) {
    bool last = !c[1] || (but && !c[2] && strcmp(c[1]->name, but) == 0);
    if (!but || strcmp((*c)->name, but) != 0)
      reference(r, (*c)->name, last ? "" : ",");
  }
}

static void synopsis(struct roff *r, const struct command *command)
{
  char both[NAME];
  snprintf(both, sizeof both, "scallop %s", command->name);
  roff_macro(r, "SH", "SYNOPSIS");
  roff_font(r, "", 'B', both, "");
  if (command->operand)
    roff_font(r, "", strchr(command->operand, '|') ? 'B' : 'I', command->operand, "");
  roff_font(r, "[", 'I', "options", "]");
}

/* Begins a passage and says what it is about. */
static void begin_passage(struct roff *r, const struct passage *p, bool first)
{
  if (p->name.length > 0) {
    roff_macro(r, "TP", NULL);
    roff_bold_line(r, p->name.start, p->name.length);
  } else if (!first) {
    roff_macro(r, "PP", NULL);
  }
}

static bool is_blank(struct span s)
{
  while (s.length > 0 && strchr(" \n", s.start[s.length - 1]))
    s.length--;
  return s.length == 0;
}

/* The about text without its lists of columns. */
static void description_section(struct roff *r, const char *about)
{
  struct passage p;
  bool first = true;
  roff_macro(r, "SH", "DESCRIPTION");
  while (about_passage(&about, &p)) {
    if (is_blank(p.before) && is_blank(p.after))
      continue;
    begin_passage(r, &p, first);
    roff_words(r, p.before.start, p.before.length);
    roff_words(r, p.after.start, p.after.length);
    first = false;
  }
}

/* A list; where there is only one in it, a sentence. */
static void list_columns(struct roff *r, struct span columns)
{
  struct span column;
  bool list = memchr(columns.start, ';', columns.length) != NULL;
  while (about_column(&columns, &column)) {
    if (list)
      roff_macro(r, "IP \\(bu 2", NULL);
    roff_words(r, column.start, column.length + !list);
  }
}

static void columns_section(struct roff *r, const char *about)
{
  struct passage p;
  bool first = true;
  while (about_passage(&about, &p)) {
    if (is_blank(p.columns))
      continue;
    roff_macro(r, first ? "SH" : "PP", first ? "COLUMNS" : NULL);
    first = false;
    if (p.name.length > 0) {
      roff_text(r, "With");
      roff_words(r, p.name.start, p.name.length + 1); /* and its colon */
    }
    list_columns(r, p.columns);
  }
}

static void options_section(struct roff *r, const struct command *command)
{
  roff_macro(r, "SH", "OPTIONS");
  roff_text(r, "Defaults are in brackets.");
  for (const char *const *name = command->accepts; *name; name++) {
    char text[HELP_OPTION];
    help_option(command, *name, text);
    tag(r, *name, describe_option(*name, command)->placeholder);
    roff_text(r, text);
  }
  tag(r, "help", NULL);
  roff_text(r, "what this page says, in short");
}

static void command_page(struct roff *r, const struct command *command)
{
  char name[NAME];
  title(r, page_name(name, command->name));
  name_section(r, name, command->summary);
  synopsis(r, command);
  description_section(r, command->about);
  columns_section(r, command->about);
  options_section(r, command);
  example_section(r, command->example);
  exit_section(r);
  see_also_section(r, command->name);
  roff_break(r);
}

static void program_synopsis(struct roff *r)
{
  char both[NAME];
  roff_macro(r, "SH", "SYNOPSIS");
  roff_font(r, "", 'B', "scallop", "");
  roff_font(r, "", 'I', "COMMAND", "");
  roff_font(r, "[", 'I', "options", "]");
  for (const struct request *q = requests; q->name; q++) {
    snprintf(both, sizeof both, "scallop --%s", q->name);
    roff_macro(r, "br", NULL);
    roff_font(r, "", 'B', both, "");
    if (q->placeholder)
      roff_font(r, "", 'I', q->placeholder, "");
  }
}

static void commands_section(struct roff *r)
{
  roff_macro(r, "SH", "COMMANDS");
  for (const struct command *const *c = commands; *c; c++) {
    roff_macro(r, "TP", NULL);
    roff_font(r, "", 'B', (*c)->name, "");
    if ((*c)->operand)
      roff_font(r, "", 'I', (*c)->operand, "");
    roff_break(r);
    roff_text(r, (*c)->summary);
  }
}

static void program_page(struct roff *r)
{
  char name[NAME];
  title(r, page_name(name, NULL));
  name_section(r, name, program_purpose);
  program_synopsis(r);
  roff_macro(r, "SH", "DESCRIPTION");
  roff_text(r, "Each command has a page of its own, such as");
  reference(r, commands[0]->name, ",");
  roff_text(r, "and tells the same in short with --help.");
  commands_section(r);
  roff_macro(r, "SH", "OPTIONS");
  for (const struct request *q = requests; q->name; q++) {
    tag(r, q->name, q->placeholder);
    roff_text(r, q->help);
  }
  example_section(r, program_example);
  exit_section(r);
  see_also_section(r, NULL);
  roff_break(r);
}

static void list_pages(FILE *to)
{
  fputs("scallop\n", to);
  for (const struct command *const *c = commands; *c; c++)
    fprintf(to, "%s%s\n", prefix, (*c)->name);
}

const char *man_subject(const char *name)
{
  size_t length = strlen(prefix);
  return strncmp(name, prefix, length) == 0 ? name + length : name;
}

bool man_page(FILE *to, const char *name)
{
  struct roff roff = { .to = to };
  if (strcmp(name, "list") == 0) {
    list_pages(to);
    return true;
  }
  if (strcmp(name, "scallop") == 0) {
    program_page(&roff);
    return true;
  }
  const struct command *command = command_named(man_subject(name));
  if (command)
    command_page(&roff, command);
  return command != NULL;
}
