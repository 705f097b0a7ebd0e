#include "compare/option_table.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "compare/compare.h"
#include "compare/gaits.h"
#include "compare/values.h"

enum { MOST_ORDER = 1000, MOST_CASES = 1000000 };

bool option_accepted(const struct command *command, const char *name)
{
  for (const char *const *a = command->accepts; *a; a++)
    if (strcmp(name, *a) == 0)
      return true;
  return false;
}

static const char *set_gait(struct options *o, const char *name, const char *text)
{
  struct gait_answer answer = gait_of_text(text);
  (void)name;
  o->unreadable = answer.fault == GAIT_UNREADABLE;
  if (!answer.gait)
    return answer.wrong;
  o->crawler.gait = answer.gait;
  o->has_gait = true;
  return NULL;
}

static const char *set_crawler_number(struct options *o, const char *name, const char *text)
{
  return options_set_crawler_number(o, crawler_place(name), text);
}

static const char *set_phase(struct options *o, const char *name, const char *text)
{
  (void)name;
  if (strcmp(text, "extension") != 0 && strcmp(text, "contraction") != 0)
    return not_allowed(text, "extension or contraction");
  o->has_phase = true;
  o->phase = *text == 'e' ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
  return NULL;
}

static const char *set_number(struct options *o, const char *name, const char *text)
{
  double *field = strcmp(name, "v0") == 0 ? &o->v0 : strcmp(name, "expect") == 0 ? &o->expect : &o->tolerance;
  double value;
  bool positive = field == &o->tolerance;
  if (!read_number(text, &value) || (positive && !(value > 0)))
    return no_number(text, positive ? "a finite number > 0" : "a finite number");
  *field = value;
  o->has_expect |= field == &o->expect;
  o->has_tolerance |= field == &o->tolerance;
  o->has_v0 |= field == &o->v0;
  if (field == &o->v0)
    o->written_v0 = text;
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

static const char *set_count(struct options *o, const char *name, const char *text)
{
  if (strcmp(name, "digits") == 0) {
    bool scene = o->command == &command_run; /* whose wants know what is proven */
    bool beyond_double = scene || option_accepted(o->command, "certified") || option_accepted(o->command, "source");
    return read_count(text, 1, beyond_double ? MOST_DIGITS : DOUBLE_DIGITS, &o->digits) ? NULL
           : scene ? not_allowed(text, "a whole number from 1 to 10000; where nothing is certified from 1 to 17")
           : beyond_double
               ? not_allowed(text, "a whole number from 1 to 10000; without --certified or --source from 1 to 17")
               : not_allowed(text, "a whole number from 1 to 17");
  }
  o->has_order |= strcmp(name, "order") == 0;
  if (strcmp(name, "order") == 0)
    return read_count(text, 1, MOST_ORDER, &o->order) ? NULL : not_allowed(text, "a whole number from 1 to 1000");
  o->has_seed |= strcmp(name, "seed") == 0;
  if (strcmp(name, "cases") == 0)
    return read_count(text, 1, MOST_CASES, &o->cases) ? NULL : not_allowed(text, "a whole number from 1 to 1000000");
  if (strcmp(name, "seed") == 0)
    return read_count(text, 0, 1000000000, &o->seed) ? NULL : not_allowed(text, "a whole number from 0 to 1000000000");
  long *field = strcmp(name, "periods") == 0 ? &o->periods : &o->samples;
  return read_count(text, 1, 1000000000, field) ? NULL : not_allowed(text, "a whole number from 1 to 1000000000");
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
  o->has_output |= strcmp(name, "output") == 0;
  if (strcmp(name, "output") == 0)
    o->output = strcmp(text, "-") == 0 ? NULL : text;
  else if (strcmp(name, "into") == 0)
    o->folder = text;
  else
    *(strcmp(name, "points") == 0 ? &o->points : &o->from) = text;
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

static const char *set_against(struct options *o, const char *name, const char *text)
{
  if (text && *text == '\0')
    return not_allowed(text, "a file name");
  o->against = strcmp(name, "check") == 0 ? "data/claims.tsv" : text;
  return NULL;
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
  } flags[] = { { "bound", &o->bound },
                { "certified", &o->certified },
                { "quick", &o->quick },
                { "summary", &o->summary },
                { "full", &o->full },
                { "stiff", &o->stiff },
                { "error", &o->error },
                { "boundaries", &o->boundaries },
                { "check-only", &o->check_only },
                { "explain", &o->explain },
                { "stats", &o->stats },
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

static const struct option_description descriptions[] = {
  { "m1", "M", "mass of body 1 (1)", set_crawler_number },
  { "m2", "M", "mass of body 2 (1)", set_crawler_number },
  { "F1", "F", "Coulomb friction force of body 1 (4)", set_crawler_number },
  { "F2", "F", "Coulomb friction force of body 2 (1)", set_crawler_number },
  { "L", "L", "amplitude of the separation x2 - x1 (10)", set_crawler_number },
  { "T", "T", "period (1)", set_crawler_number },
  { "alpha", "A", "fraction of the period that the extension takes (0.75)", set_crawler_number },
  { "gait", "GAIT", gaits_help, set_gait },
  { "phase", "PHASE", "extension or contraction (extension)", set_phase },
  { "v0", "V", "velocity of both bodies at the start of the phase (0)", set_number },
  { "start", "WHAT", "rest, steady, or a velocity (rest)", set_start },
  { "periods", "N", "number of periods (10)", set_count },
  { "samples", "N", "samples in a period (40)", set_count },
  { "expect", "P", "the order that is expected: gives a verdict, and exit code 1 unless it is met", set_number },
  { "tol.breakdown", "D", "for this relative error only (reach: 1e-1 to 1e-12; maps: 1e-2 and 1e-6)", set_number },
  { "tol", "D", "how far from it the order may be (0.1)", set_number },
  { "errors", "CLAIM", "print the errors behind a claim instead: names separated by commas, or all", set_errors },
  { "check.stress", NULL, "few cases, for a gait of each kind but measured; exit code 1 if a promise is broken",
    set_against },
  { "quick.stress", NULL, "with --stiff: delta down to 1e-5 only", set_flag },
  { "summary.stress", NULL, "with --stiff: the order in delta, and where each stepper gives up", set_flag },
  { "family", "NAME", "of this family only", set_family },
  { "cases", "N", "of each family and gait (1000; 5000 with --full, 4 steady states or 30 phases with --check)", set_count },
  { "seed", "N", "of their parameters (1)", set_count },
  { "full", NULL, "many cases: takes minutes", set_flag },
  { "stiff", NULL, "friction smoothed for stiff ODE solvers, instead", set_flag },
  { "error", NULL, "after each number an estimate of its error", set_flag },
  { "check", NULL, "compare the verdicts with those in data/claims.tsv: exit code 1 if any differs", set_against },
  { "against", "FILE", "the same with another ledger", set_against },
  { "source.breakdown", "SOURCE", "of this series only: published, derived or limit", set_source },
  { "source", "SOURCE", "published, derived or limit (published)", set_source },
  { "order", "N", "derive all terms below T^N, N from 1 to 1000 (8)", set_count },
  { "quantity", "NAME", "of this quantity only", set_word },
  { "only", "WHAT", "rows of this kind only: event, reach, radius or best", set_word },
  { "map", "X Y", "a map over two of F1/F2, m1/m2, alpha, T and froude", set_map },
  { "x", "FROM:TO:N", "N values of X, with :log or :linear for how they are spaced", set_range },
  { "y", "FROM:TO:N", "the same of Y", set_range },
  { "boundaries", NULL, "with --map: the curves between its regions instead", set_flag },
  { "bound", NULL, "bounds for the error of the derived terms below T^N", set_flag },
  { "certified", NULL, "in ball arithmetic: every digit printed is proven", set_flag },
  { "quick", NULL, "few settings, T = 0.5 and 0.01 unless --T is given, a short limit: a look, in seconds", set_flag },
  { "summary", NULL, "for each wanted error the cheapest method, and how many times as long the others take", set_flag },
  { "from", "FILE", "that summary of a table which was written before; nothing is measured", set_file },
  { "limit", "SECONDS", "for each method and setting, from 0.001 to 3600 (1; 0.05 with --quick)", set_limit },
  { "points", "FILE", "read points from a TSV file ('-': standard input) whose header names parameters", set_file },
  { "format", "F", "tsv or json, one object a line (tsv)", set_format },
  { "digits", "N", "significant digits (as many as read back exactly); beyond 17 only where they are proven", set_count },
  { "output", "FILE", "write there when all is done ('-': to standard output, as without it); also -o", set_file },
  { "check-only", NULL, "read and check the scenes, and do nothing", set_flag },
  { "explain", NULL, "the plan, instead of the work", set_flag },
  { "stats", NULL, "afterwards, on standard error, what was done: the counters of the plan's stages", set_flag },
  { "no-plots", NULL, "tables only", set_flag },
  { "into", "FOLDER", "the folder for files that a scene names without one starting with / (this one)", set_file },
  { "quiet", NULL, "no notes on standard error, only errors", set_quiet },
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
