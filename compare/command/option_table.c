#include "compare/command/option_table.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "compare/command/compare.h"
#include "compare/answers/gaits.h"
#include "compare/text/plot.h"
#include "compare/text/values.h"

enum { MOST_ORDER = 1000, MOST_CASES = 1000000, MOST_COUNT = 1000000000 };

bool option_accepted(const struct command *command, const char *name)
{
  for (const char *const *a = command->accepts; *a; a++)
    if (strcmp(name, *a) == 0)
      return true;
  return false;
}

static const char *set_parameter(struct options *o, const char *name, const char *text)
{
  return point_set(&o->point, name, text);
}

static double *number_field(struct options *o, const char *name)
{
  return strcmp(name, "expect") == 0 ? &o->expect : &o->tolerance;
}

static const char *set_number(struct options *o, const char *name, const char *text)
{
  double *field = number_field(o, name), value;
  bool positive = field == &o->tolerance;
  if (!read_number(text, &value) || (positive && !(value > 0)))
    return no_number(text, positive ? "a finite number > 0" : "a finite number");
  *field = value;
  o->has_expect |= field == &o->expect;
  o->has_tolerance |= field == &o->tolerance;
  return NULL;
}

static const char *set_start(struct options *o, const char *name, const char *text)
{
  (void)name;
  o->start = text;
  if (strcmp(text, "rest") == 0 || strcmp(text, "steady") == 0 || read_number(text, &o->start_velocity))
    return NULL;
  return no_number(text, "rest, steady or a velocity");
}

static long *count_field(struct options *o, const char *name)
{
  return strcmp(name, "order") == 0     ? &o->order
         : strcmp(name, "cases") == 0   ? &o->cases
         : strcmp(name, "seed") == 0    ? &o->seed
         : strcmp(name, "digits") == 0  ? &o->digits
         : strcmp(name, "periods") == 0 ? &o->periods
                                        : &o->samples;
}

static const char *set_count(struct options *o, const char *name, const char *text)
{
  long *field = count_field(o, name), least = field == &o->seed ? 0 : 1;
  long most = field == &o->order ? MOST_ORDER : field == &o->cases ? MOST_CASES : MOST_COUNT;
  char allowed[80];
  o->has_order |= field == &o->order;
  o->has_seed |= field == &o->seed;
  snprintf(allowed, sizeof allowed, "a whole number from %ld to %ld", least, most);
  return read_count(text, least, most, field) ? NULL : not_allowed(text, allowed);
}

/* Behind a word for what they are. */
static void write_digits_range(char text[OPTION_RANGE], const struct command *command)
{
  int used = snprintf(text, OPTION_RANGE, " from 1 to %d", DOUBLE_DIGITS);
  if (command->proven)
    snprintf(text + used, OPTION_RANGE - (size_t)used, "; %s to %d", command->proven, MOST_DIGITS);
}

const char *digits_refused(const struct command *command, const char *text)
{
  char allowed[OPTION_RANGE + 20] = "a whole number";
  write_digits_range(allowed + strlen(allowed), command);
  return not_allowed(text, allowed);
}

static const char *set_digits(struct options *o, const char *name, const char *text)
{
  (void)name;
  bool good = read_count(text, 1, o->command->proven ? MOST_DIGITS : DOUBLE_DIGITS, &o->digits);
  return good ? NULL : digits_refused(o->command, text);
}

static const char *set_format(struct options *o, const char *name, const char *text)
{
  (void)name;
  if (strcmp(text, "tsv") != 0 && strcmp(text, "json") != 0)
    return not_allowed(text, "tsv or json");
  o->format = *text == 't' ? FORMAT_TSV : FORMAT_JSON;
  o->has_format = true;
  return NULL;
}

static const char *set_file(struct options *o, const char *name, const char *text)
{
  if (*text == '\0')
    return not_allowed(text, "a file name");
  if (strcmp(name, "output") == 0 && plot_kind(text))
    return not_allowed(
        text, "the name of a table, not of a picture; `scallop run` draws: `scallop run figure4` writes figure4.svg");
  o->has_output |= strcmp(name, "output") == 0;
  if (strcmp(name, "output") == 0)
    o->output = strcmp(text, "-") == 0 ? NULL : text;
  else if (strcmp(name, "into") == 0)
    o->folder = text;
  else
    o->points = text;
  return NULL;
}

static const char *set_errors(struct options *o, const char *name, const char *text)
{
  (void)name;
  o->errors = text;
  return *text == '\0' ? not_allowed(text, "names of claims, separated by commas, or all") : NULL;
}

static const char *set_family(struct options *o, const char *name, const char *text)
{
  (void)name;
  o->family = text;
  return *text == '\0' ? not_allowed(text, "the name of a family") : NULL;
}

/* One of the things that a command can be asked for by name: it knows which there are. */
static const char *set_word(struct options *o, const char *name, const char *text)
{
  *(strcmp(name, "quantity") == 0 ? &o->quantity : &o->only) = text;
  return *text == '\0' ? not_allowed(text, "a name") : NULL;
}

/* Called for each of the two values. */
static const char *set_map(struct options *o, const char *name, const char *text)
{
  (void)name;
  o->map[o->map[0] ? 1 : 0] = text;
  return *text == '\0' ? not_allowed(text, "the name of what varies") : NULL;
}

static const char *set_range(struct options *o, const char *name, const char *text)
{
  o->range[*name == 'x' ? 0 : 1] = text;
  return *text == '\0' ? not_allowed(text, "FROM:TO:COUNT") : NULL;
}

static const char *set_source(struct options *o, const char *name, const char *text)
{
  (void)name;
  if (strcmp(text, "published") != 0 && strcmp(text, "derived") != 0 && strcmp(text, "limit") != 0)
    return not_allowed(text, "published, derived or limit");
  o->source = text;
  o->has_source = true;
  return NULL;
}

static const char *set_limit(struct options *o, const char *name, const char *text)
{
  double seconds;
  (void)name;
  if (!read_number(text, &seconds) || seconds < 1e-3 || seconds > 3600)
    return no_number(text, "seconds, from 0.001 to 3600");
  o->limit = seconds;
  return NULL;
}

static const char *set_flag(struct options *o, const char *name, const char *text)
{
  (void)text;
  const struct {
    const char *name;
    bool *flag;
  } flags[] = { { "bound", &o->bound },           { "check", &o->check },     { "certified", &o->certified },
                { "quick", &o->quick },           { "summary", &o->summary }, { "full", &o->full },
                { "stiff", &o->stiff },           { "error", &o->error },     { "boundaries", &o->boundaries },
                { "check-only", &o->check_only }, { "explain", &o->explain }, { "stats", &o->stats },
                { "no-plots", &o->no_plots } };
  for (size_t i = 0; i < sizeof flags / sizeof *flags; i++)
    if (strcmp(name, flags[i].name) == 0)
      *flags[i].flag = true;
  return NULL;
}

static const char *set_quiet(struct options *o, const char *name, const char *text)
{
  (void)name, (void)text;
  o->quiet = true;
  return NULL;
}

/* ---- what holds where it is not given ---- */

static void show_gait(const struct options *o, const char *name, char text[OPTION_VALUE])
{
  (void)name;
  snprintf(text, OPTION_VALUE, "%s", o->point.crawler.gait->name);
}

static void show_crawler_number(const struct options *o, const char *name, char text[OPTION_VALUE])
{
  snprintf(text, OPTION_VALUE, "%.15g", crawler_parameter(&o->point.crawler, name));
}

static void show_phase(const struct options *o, const char *name, char text[OPTION_VALUE])
{
  (void)name;
  snprintf(text, OPTION_VALUE, "%s", o->point.phase == SCALLOP_EXTENSION ? "extension" : "contraction");
}

static void show_v0(const struct options *o, const char *name, char text[OPTION_VALUE])
{
  (void)name;
  snprintf(text, OPTION_VALUE, "%.15g", o->point.v0);
}

static void show_number(const struct options *o, const char *name, char text[OPTION_VALUE])
{
  struct options copy = *o;
  snprintf(text, OPTION_VALUE, "%.15g", *number_field(&copy, name));
}

static void show_start(const struct options *o, const char *name, char text[OPTION_VALUE])
{
  (void)name;
  snprintf(text, OPTION_VALUE, "%s", o->start);
}

static void show_count(const struct options *o, const char *name, char text[OPTION_VALUE])
{
  struct options copy = *o;
  snprintf(text, OPTION_VALUE, "%ld", *count_field(&copy, name));
}

static void show_digits(const struct options *o, const char *name, char text[OPTION_VALUE])
{
  if (o->digits > 0)
    show_count(o, name, text);
  else
    snprintf(text, OPTION_VALUE, "as many as read back exactly");
}

static void show_format(const struct options *o, const char *name, char text[OPTION_VALUE])
{
  (void)name;
  snprintf(text, OPTION_VALUE, "%s", o->format == FORMAT_TSV ? "tsv" : "json");
}

static void show_source(const struct options *o, const char *name, char text[OPTION_VALUE])
{
  (void)name;
  snprintf(text, OPTION_VALUE, "%s", o->source);
}

static const struct option_kind of_crawler_number = { set_parameter, show_crawler_number, NULL },
                                of_gait = { set_parameter, show_gait, NULL }, of_phase = { set_parameter, show_phase, NULL },
                                of_v0 = { set_parameter, show_v0, NULL }, of_number = { set_number, show_number, NULL },
                                of_start = { set_start, show_start, NULL }, of_count = { set_count, show_count, NULL },
                                of_format = { set_format, show_format, NULL }, of_source = { set_source, show_source, NULL },
                                of_digits = { set_digits, show_digits, write_digits_range },
                                of_errors = { set_errors, NULL, NULL }, of_flag = { set_flag, NULL, NULL },
                                of_family = { set_family, NULL, NULL }, of_word = { set_word, NULL, NULL },
                                of_map = { set_map, NULL, NULL }, of_range = { set_range, NULL, NULL },
                                of_file = { set_file, NULL, NULL }, of_limit = { set_limit, NULL, NULL },
                                of_quiet = { set_quiet, NULL, NULL };

static const struct option_description descriptions[] = {
  { "m1", "M", "mass of body 1", &of_crawler_number },
  { "m2", "M", "mass of body 2", &of_crawler_number },
  { "F1", "F", "Coulomb friction force of body 1", &of_crawler_number },
  { "F2", "F", "Coulomb friction force of body 2", &of_crawler_number },
  { "L", "L", "amplitude of the separation x2 - x1", &of_crawler_number },
  { "T", "T", "period", &of_crawler_number },
  { "alpha", "A", "fraction of the period that the extension takes", &of_crawler_number },
  { "gait", "GAIT", gaits_help, &of_gait },
  { "phase", "PHASE", "extension or contraction", &of_phase },
  { "v0", "V", "velocity of both bodies at the start of the phase", &of_v0 },
  { "start", "WHAT", "rest, steady, or a velocity", &of_start },
  { "periods", "N", "number of periods", &of_count },
  { "samples", "N", "samples in a period", &of_count },
  { "expect", "P", "the order that is expected: gives a verdict, and exit code 1 unless it is met", &of_number },
  { "tol.breakdown", "D", "for this relative error only", &of_number },
  { "tol", "D", "how far the order may be from --expect", &of_number },
  { "errors", "CLAIM", "print the errors behind a claim instead: names separated by commas, or all", &of_errors },
  { "check.stress", NULL, "few cases, for a gait of each kind but measured; exit code 1 if a promise is broken", &of_flag },
  { "quick.stress", NULL, "with --stiff: delta down to 1e-5 only", &of_flag },
  { "summary.stress", NULL, "with --stiff: the order in delta, and where each stepper gives up", &of_flag },
  { "family", "NAME", "this family only", &of_family },
  { "cases", "N", "cases of each family and gait", &of_count },
  { "seed", "N", "seed of the parameters of the cases", &of_count },
  { "full", NULL, "many cases: takes minutes", &of_flag },
  { "stiff", NULL, "friction smoothed for stiff ODE solvers, instead", &of_flag },
  { "error", NULL, "after each number an estimate of its error", &of_flag },
  { "check", NULL, "compare the verdicts with those of the ledger that comes with the tool: exit code 1 if any differs",
    &of_flag },
  { "source.breakdown", "SOURCE", "this series only: published, derived or limit", &of_source },
  { "source", "SOURCE", "published, derived or limit", &of_source },
  { "order", "N", "derive all terms below T^N, N from 1 to 1000", &of_count },
  { "quantity", "NAME", "this quantity only", &of_word },
  { "only", "WHAT", "rows of this kind only: event, reach, radius or best", &of_word },
  { "map", "X Y", "a map over two of F1/F2, m1/m2, alpha, T and froude", &of_map },
  { "x", "FROM:TO:N", "N values of X, with :log or :linear for how they are spaced", &of_range },
  { "y", "FROM:TO:N", "N values of Y", &of_range },
  { "boundaries", NULL, "with --map: the curves between its regions instead", &of_flag },
  { "bound", NULL, "bounds for the error of the derived terms below T^N", &of_flag },
  { "certified", NULL, "in ball arithmetic: every digit printed is proven", &of_flag },
  { "quick", NULL, "few settings, few T and a short limit: a look, in seconds", &of_flag },
  { "summary", NULL, "for each wanted error the cheapest method, and how many times as long the others take", &of_flag },
  { "limit", "SECONDS", "for each method and setting, from 0.001 to 3600", &of_limit },
  { "points", "FILE", "read points from a TSV file ('-': standard input) whose header names parameters", &of_file },
  { "format", "F", "tsv or json, one object a line", &of_format },
  { "digits", "N", "significant digits", &of_digits },
  { "output", "FILE", "write there when all is done ('-': to standard output, as without it); also -o", &of_file },
  { "check-only", NULL, "read and check the scenes, and do nothing", &of_flag },
  { "explain", NULL, "the plan, instead of the work", &of_flag },
  { "stats", NULL, "afterwards, on standard error, what was done: the counters of the plan's stages", &of_flag },
  { "no-plots", NULL, "tables only", &of_flag },
  { "into", "FOLDER", "the folder for files that a scene names by a path without / in front", &of_file },
  { "quiet", NULL, "no notes on standard error, only errors", &of_quiet },
};

const struct option_description *describe_option(const char *name, const struct command *command)
{
  size_t length = strlen(name);
  for (size_t i = 0; i < sizeof descriptions / sizeof *descriptions; i++) {
    const char *candidate = descriptions[i].name, *dot = strchr(candidate, '.');
    if (strncmp(name, candidate, length) == 0
        && (candidate[length] == '\0' || (candidate + length == dot && strcmp(dot + 1, command->name) == 0)))
      return &descriptions[i];
  }
  return NULL;
}

int option_value_count(const struct option_description *option)
{
  int count = option->placeholder ? 1 : 0;
  for (const char *p = option->placeholder; p && *p; p++)
    count += *p == ' ';
  return count;
}

bool many_operands(const struct command *command)
{
  size_t length = command->operand ? strlen(command->operand) : 0;
  return length > 3 && strcmp(command->operand + length - 3, "...") == 0;
}
