/* Arguments of a command: reading, completion, rules. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/shard.h"
#include "compare/answers/vary.h"
#include "compare/formulas/formula_file.h"
#include "compare/columns/columns.h"
#include "compare/command/commands.h"

const struct option *option_of(const struct command *command, const char *name)
{
  const struct option *o = command->options;
  while (o->name && strcmp(o->name, name) != 0)
    o++;
  return o->name ? o : NULL;
}

/* Options, or values as "NAME VALUE", removed since the last version; command NULL: of all commands. Existing options
 * and values are found first. */
#define AWK \
  "`LC_ALL=C awk -f cheapest.awk FILE` summarises a table; the script is in scripts/plots/ of the sources, and " \
  "installed in share/scallop/"
#define COUNTED "`--stats` prints what was done"
#define BY_SYMPY "sympy makes it of the text form in three lines: docs/reference/formulas.md"
#define CLAIM_TABLES \
  "`scallop claims | diff - FILE` compares with any table of claims; data/claims.tsv of the sources is the tool's own"
static const struct removed_option {
  const char *name, *command, *instead;
} removed[] = {
  { "book", NULL, "`--formulas FILE` reads a formula file" },
  { "against", "claims", CLAIM_TABLES },
  { "check", "claims", CLAIM_TABLES },
  { "emit c", "series", BY_SYMPY },
  { "emit mathml", "series", BY_SYMPY },
  { "explain", "figure", COUNTED },
  { "explain", "run", COUNTED },
  { "format tap", "order", "`--format junit` is what CI reads" },
  { "from", "workprec", AWK },
  { "man", "", "`make install` installs the manual, which `man scallop` and `man scallop-steady` show" },
  { "pager", NULL, "`scallop ... --format table | less -S` shows an aligned table page by page" },
  { "summary", "stress", "`scallop stress --stiff | scallop order - --x delta --y v_end_error` measures the orders" },
  { "summary", "workprec", AWK },
};

const char *option_instead(const char *command, const char *name, const char *value)
{
  char both[OPTION_VALUE];
  snprintf(both, sizeof both, "%s%s%s", name, value ? " " : "", value ? value : "");
  for (const struct removed_option *r = removed; r < removed + sizeof removed / sizeof *removed; r++)
    if (strcmp(r->name, both) == 0 && (!r->command || strcmp(r->command, command) == 0))
      return r->instead;
  return NULL;
}

/* Returns the option that resembles a mistyped name, or has this name in other programs; else NULL. */
static const char *near_option(const struct command *command, const char *name)
{
  static const char *const elsewhere[][2] = { { "mass1", "m1" },     { "mass2", "m2" }, { "friction1", "F1" },
                                              { "friction2", "F2" }, { "stroke", "L" }, { "period", "T" } };
  for (size_t i = 0; i < sizeof elsewhere / sizeof *elsewhere; i++)
    if (strcmp(name, elsewhere[i][0]) == 0 && option_of(command, elsewhere[i][1]))
      return elsewhere[i][1];
  return nearest_in(name + strspn(name, "-"), command->options, sizeof *command->options);
}

static const struct command *const *all_commands; /* from options_read */

const char *option_unknown(const struct arguments *a, const char *name, const char *argument)
{
  const char *command = a->command->name, *instead = option_instead(command, name, NULL);
  if (instead)
    return wrong_text("--%s is no longer there: %s", name, instead);
  for (const struct command *const *c = all_commands; *c; c++)
    if (option_of(*c, name))
      return wrong_text("this command does not take the option '%s' (see scallop %s --help)", argument, command);
  const char *near = near_option(a->command, name);
  return wrong_text("unknown option '%s'%s (see scallop %s --help)", argument,
                    near ? did_you_mean(wrong_text("--%s", near)) : "", command);
}

const char *option_take(struct arguments *a, const struct option *o, const char *const *texts, int count)
{
  static const char *const takes[] = { "takes no value", "needs a value", "needs two values" };
  const char *wrong = NULL, *text = NULL;
  int values = option_values(o);
  if (count != values)
    return wrong_text("--%s %s", o->name, takes[values]);
  for (int i = 0; i < (values == 0 ? 1 : values) && !wrong; i++) {
    text = values == 0 ? NULL : texts[i];
    wrong = o->read(&a->options, o, text);
  }
  a->given |= 1UL << (o - a->command->options);
  const char *instead = wrong && text ? option_instead(a->command->name, o->name, text) : NULL;
  if (instead)
    return wrong_text("--%s %s is no longer there: %s", o->name, text, instead);
  return wrong ? wrong_text("--%s: %s", o->name, wrong) : NULL;
}

/* Returns the value of --smooth, before or after --gait, or NULL: the recording of a gait is read once, with it. */
static const char *smooth_of(const struct arguments *a)
{
  double sigma;
  for (int i = a->count - 1; i >= 2; i--) { /* the last one holds */
    const char *behind = strncmp(a->all[i], "--smooth", 8) == 0 ? a->all[i] + 8 : NULL;
    const char *value = !behind ? NULL : *behind == '=' ? behind + 1 : *behind ? NULL : a->all[i + 1];
    if (value && read_number(value, &sigma) && sigma > 0)
      return value;
  }
  return NULL;
}

static const char *take_gait(struct arguments *a, const struct option *o, const char *gait, const char *smooth)
{
  char text[GAIT_TEXT];
  const bool is_one = strncmp(gait, "measured:", 9) == 0 && !strstr(gait, ",measured:");
  const int length = snprintf(text, sizeof text, "%s:smooth=%s", gait, smooth);
  return is_one && length < GAIT_TEXT ? option_take(a, o, (const char *const[]){ text }, 1)
                                      : "--smooth is the noise of one recording: --gait measured:FILE";
}

/* Reads an option and its values; the first may follow '='. Returns NULL, or an error. */
static const char *read_option(struct arguments *a)
{
  const char *argument = a->all[a->place], *texts[MAX_VALUES] = { NULL };
  bool two_dashes = argument[0] == '-' && argument[1] == '-' && argument[2] != '-', is_o = strcmp(argument, "-o") == 0;
  char before[2 * OPTION_VALUE]; /* the value behind '=' */
  size_t length = strcspn(argument, two_dashes ? "=" : "");
  snprintf(before, sizeof before, "%.*s", (int)length, argument);
  const char *name = is_o ? "output" : before + (two_dashes ? 2 : 0);
  const struct option *o = two_dashes || is_o ? option_of(a->command, name) : NULL;
  int count = argument[length] == '=';
  if (!o)
    return option_unknown(a, name, before);
  if (count > 0)
    texts[0] = argument + length + 1;
  while (count < option_values(o) && a->place + 1 < a->count)
    texts[count++] = a->all[++a->place];
  const char *smooth = strcmp(o->name, "gait") == 0 && count == 1 ? smooth_of(a) : NULL;
  if (smooth)
    return take_gait(a, o, texts[0], smooth);
  return option_take(a, o, texts, count);
}

static const char *take_operand(struct arguments *a)
{
  const struct command *c = a->command;
  bool takes_many = c->operand && strstr(c->operand, "...");
  if (!takes_many && a->operand_count == (c->operand ? 1 : 0))
    return wrong_text("unexpected argument '%.400s' (see scallop %s --help)", a->all[a->place], c->name);
  a->operands[a->operand_count++] = a->all[a->place];
  return NULL;
}

static enum reading read_all(struct arguments *a)
{
  const struct command *c = a->command;
  const char *wrong = NULL;
  for (a->place = 2; a->place < a->count && !wrong; a->place++) {
    const char *argument = a->all[a->place];
    if (strcmp(argument, "--help") == 0 || strcmp(argument, "-h") == 0)
      return READ_HELP;
    wrong = (argument[0] == '-' && argument[1] != '\0' ? read_option : take_operand)(a);
  }
  if (!wrong && c->operand && a->operand_count == 0)
    wrong = wrong_text("an argument is missing: scallop %s %s", c->name, c->operand);
  return wrong ? complain(c->name, "%s", wrong), READ_REFUSED : READ_RUN;
}

/* Returns true if a list has the option's NAME, or NAME=VALUE with its value. */
static bool is_listed(const struct arguments *a, const struct option *o, const char *names)
{
  char both[2 * OPTION_VALUE];
  const struct optional_word *word = o->read == read_word ? (const void *)(a->options.bytes + o->field) : NULL;
  snprintf(both, sizeof both, "%s=%s", o->name, word && word->value ? word->value : "");
  for (size_t length; *names; names += length + (names[length] == ' ')) {
    length = strcspn(names, " ");
    if (strncmp(names, both, length) == 0 && (length == strlen(o->name) || length == strlen(both)))
      return true;
  }
  return false;
}

const struct option *given_option(const struct arguments *a, const char *names)
{
  for (const struct option *o = a->command->options; o->name; o++)
    if ((a->given >> (o - a->command->options) & 1) != 0 && is_listed(a, o, names))
      return o;
  return NULL;
}

/* Returns NULL, or an error: an option without effect, with or without another option */
static const char *broken_rule(const struct arguments *a, const struct option_rule *rules)
{
  for (const struct option_rule *r = rules; r && r->names; r++) {
    const struct option *idle = given_option(a, r->names), *other = given_option(a, r->others);
    if (!idle || (other != NULL) == (r->when == RULE_WITHOUT))
      continue;
    if (r->message)
      return wrong_text("--%s %s", idle->name, r->message);
    return wrong_text("--%s has nothing to do %s --%s", idle->name, other ? "with" : "without",
                      other ? other->name : r->others);
  }
  return NULL;
}

/* Returns NULL, or an error: a list or a range for a command of one point, or with --points */
static const char *idle_sweep(const struct arguments *a)
{
  const struct request *r = &a->options.request;
  const struct sweep_variable *v = sweep_variable(&r->sweep, 0);
  if (!v || (command_has_rows(a->command, r) && !r->points))
    return NULL;
  return wrong_text(r->points ? "--%s: a list or a range and --points exclude each other: the file has a row for each "
                                "point"
                              : "--%s: this command takes one value: a list or a range is for steady, phase, series "
                                "and trajectory, which print rows for each point",
                    v->name);
}

/* Names the sweep by a hash of all arguments and files that determine its rows. */
static void name_sweep(struct arguments *a)
{
  struct request *r = &a->options.request;
  uint64_t name = shard_name_text(SHARD_NO_NAME, SCALLOP_VERSION);
  for (int i = 1; i < a->count; i++) {
    char option[OPTION_VALUE];
    const char *text = strcmp(a->all[i], "-o") == 0 ? "--output" : a->all[i];
    snprintf(option, sizeof option, "%.*s", (int)strcspn(text, "="), text);
    const struct option *o = strncmp(option, "--", 2) == 0 ? option_of(a->command, option + 2) : NULL;
    if (o
        && word_place(o->name, (const char *const[]){ "shard", "skip-complete", "threads", "output", "quiet", NULL })
               >= 0)
      i += strchr(text, '=') ? 0 : option_values(o);
    else
      name = shard_name_text(name, text);
  }
  name = r->points ? shard_name_file(name, r->points) : name;
  name = r->formulas ? shard_name_file(name, r->formulas) : name;
  snprintf(r->shard.sweep, sizeof r->shard.sweep, "%016" PRIx64, name);
}

/* Names the shard's sweep; returns NULL, or the reason why a shard is not possible. */
static const char *name_shard(struct arguments *a)
{
  const struct request *r = &a->options.request;
  if (!command_has_rows(a->command, r))
    return "--shard: this table has no row for each point";
  if (r->style.format != FORMAT_TSV && r->style.format != FORMAT_NPY)
    return "--shard: a shard is of the format tsv or npy, with its part in the head";
  if (r->points && strcmp(r->points, "-") == 0)
    return "--shard: standard input has no parts: --points FILE";
  name_sweep(a);
  return NULL;
}

bool options_complete(struct arguments *a)
{
  static const struct option_rule of_all[] = {
    { "smooth", RULE_WITHOUT, "gait", NULL },
    { "mu1", RULE_WITH, "F1 F1_over_F2", "sets F1, and is beside another option that does" },
    { "mu2", RULE_WITH, "F2", "sets F2, and is beside another option that does" },
    { "g", RULE_WITHOUT, "mu1 mu2", "is the gravity behind --mu1 and --mu2, and both are missing" },
    { "skip-complete", RULE_WITHOUT, "shard", NULL },
    { "skip-complete", RULE_WITHOUT, "output", "needs -o FILE: the shard that may be there" },
    { "shard", RULE_WITH, "plot", "has nothing to do with --plot: draw the merged table" },
    { "plot-x plot-y plot-by plot-x-range plot-y-range plot-title plot-size", RULE_WITHOUT, "plot", NULL },
    { NULL, RULE_WITH, NULL, NULL }
  };
  const struct command *c = a->command;
  const struct request *r = &a->options.request;
  const struct style *style = &r->style;
  const char *wrong = idle_sweep(a);
  wrong = wrong ? wrong : vary_sample(&a->options.request);
  wrong = wrong ? wrong : broken_rule(a, of_all);
  if (!wrong && r->shard.parts > 0)
    wrong = name_shard(a);
  if (!wrong && style->format == FORMAT_NPY && !style->output && option_of(c, "format"))
    wrong = no_npy_to_pipe;
  wrong = wrong ? wrong : broken_rule(a, c->rules);
  wrong = wrong || !c->complete ? wrong : c->complete(&a->options);
  return !wrong || complain(c->name, "%s", wrong);
}

void options_initial(struct arguments *a, const struct command *command)
{
  memset(a, 0, sizeof *a);
  a->command = command;
  if (command->initial)
    memcpy(&a->options, command->initial, command->size);
  const enum format format = a->options.request.style.format; /* default of the command */
  a->options.request =
      (struct request){ .style = { .command = command->name, .format = format, .meaning = quantity_meaning },
                        .point = point_initial(command->defaults) };
}

enum reading options_read(struct arguments *a, const struct command *command, const struct command *const *others,
                          int count, char **all, enum exit_code *code)
{
  all_commands = others;
  struct request *r = &a->options.request;
  options_initial(a, command);
  a->all = all;
  a->count = count;
  a->operands = calloc((size_t)count, sizeof *a->operands);
  r->required = requirements_new(command->name);
  *code = EXIT_UNSOLVED;
  if (!a->operands || !r->required)
    return complain(command->name, "out of memory"), READ_REFUSED;
  enum reading reading = read_all(a);
  *code = reading == READ_HELP ? EXIT_DONE : r->point.unreadable ? EXIT_FILE : EXIT_USAGE;
  point_complete(&r->point);
  if (r->points && strcmp(r->points, "-") == 0)
    r->style.has_format = true; /* each row appears after its point, on a terminal too */
  return reading == READ_RUN && !options_complete(a) ? READ_REFUSED : reading;
}

bool command_has_rows(const struct command *c, const void *options)
{
  return c->plan && (!c->has_rows || c->has_rows(options));
}

enum exit_code command_make(const struct arguments *a)
{
  const struct request *request = &a->options.request;
  struct rows rows = { .request = request, .sheet.required = request->required };
  enum exit_code code = request->formulas
                            ? formula_file_read(a->command->name, request->formulas, NULL, quantity_is_other)
                            : EXIT_DONE;
  if (code != EXIT_DONE)
    return code;
  if (!command_has_rows(a->command, request))
    return a->command->run(a, request);
  const char *wrong = a->command->plan(request, &rows);
  if (wrong && *wrong)
    complain(request->style.command, "%s", wrong);
  code = !wrong ? rows_table(&rows) : wrong == rows_no_memory ? EXIT_UNSOLVED : EXIT_USAGE;
  rows_free(&rows);
  return code;
}

void options_free(struct arguments *a)
{
  sweep_free(&a->options.request.sweep);
  columns_free(a->options.request.style.choice);
  requirements_free(a->options.request.required);
  free(a->operands);
  a->operands = NULL;
  a->operand_count = 0;
}
