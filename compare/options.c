#include "compare/options.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "compare/compare.h"
#include "compare/digits.h"
#include "compare/gaits.h"

struct description {
  const char *name;        /* without the dashes, and after a dot that of the only command it is about */
  const char *placeholder; /* NULL: a flag                                                    */
  const char *help;
  const char *(*set)(struct options *, const char *name, const char *text);
};

const char *const crawler_parameters[] = { "m1", "m2", "F1", "F2", "L", "T", "alpha", "gait", NULL };

enum { MOST_DIGITS = 10000, DOUBLE_DIGITS = 17, MOST_ORDER = 1000, MOST_CASES = 1000000 };
enum { ALPHA = CRAWLER_NUMBERS - 1 }; /* its place */

static char message[320];

bool read_number(const char *text, double *value)
{
  char *end;
  if (digits_read(text, value))
    return true;
  if (*text == '\0' || isspace((unsigned char)*text))
    return false;
  errno = 0;
  double x = strtod(text, &end);
  if (*end != '\0' || !isfinite(x) || (errno == ERANGE && x != 0 && !isnormal(x)))
    return false;
  if (errno == ERANGE && x == 0)
    return false;
  *value = x;
  return true;
}

static bool read_count(const char *text, long low, long high, long *value)
{
  char *end;
  errno = 0;
  long x = strtol(text, &end, 10);
  if (*text == '\0' || isspace((unsigned char)*text) || *end != '\0' || errno != 0 || x < low || x > high)
    return false;
  *value = x;
  return true;
}

static const char *not_allowed(const char *text, const char *allowed)
{
  snprintf(message, sizeof message, "'%.80s' is not allowed here: it takes %s", text, allowed);
  return message;
}

/* The same for a number, with what is the matter where the text nearly is one. */
static const char *no_number(const char *text, const char *allowed)
{
  char *end, both[160];
  size_t length = strlen(text);
  bool blank = length > 0 && (isspace((unsigned char)text[0]) || isspace((unsigned char)text[length - 1]));
  errno = 0;
  double x = strtod(text, &end);
  bool beyond = !blank && *end == '\0' && errno == ERANGE;
  snprintf(both, sizeof both, "%s%s", allowed,
           blank                   ? ", without blanks around it"
           : beyond && fabs(x) < 1 ? "; this one is too small: below 2.2e-308 doubles lose digits"
           : beyond                ? "; this one is too large: no double is above 1.8e308"
                                   : "");
  return not_allowed(text, both);
}

int crawler_place(const char *name)
{
  int i = 0;
  while (i < CRAWLER_NUMBERS && strcmp(name, crawler_parameters[i]) != 0)
    i++;
  return i;
}

static double *crawler_field(struct scallop_crawler *c, int place)
{
  double *const fields[CRAWLER_NUMBERS] = { &c->m1, &c->m2, &c->F1, &c->F2, &c->L, &c->T, &c->alpha };
  return fields[place];
}

void crawler_numbers(const struct scallop_crawler *c, double numbers[CRAWLER_NUMBERS])
{
  const double all[CRAWLER_NUMBERS] = { c->m1, c->m2, c->F1, c->F2, c->L, c->T, c->alpha };
  memcpy(numbers, all, sizeof all);
}

double crawler_parameter(const struct scallop_crawler *crawler, const char *name)
{
  double numbers[CRAWLER_NUMBERS + 1] = { [CRAWLER_NUMBERS] = NAN };
  crawler_numbers(crawler, numbers);
  return numbers[crawler_place(name)];
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

void options_complete(struct options *o)
{
  const struct scallop_crawler usual = o->command->defaults ? *o->command->defaults : scallop_crawler_default();
  double L = usual.L, T = usual.T, alpha = usual.alpha;
  gait_has_own(o->crawler.gait, &L, &T, &alpha);
  if (!o->written[crawler_place("L")])
    o->crawler.L = L;
  if (!o->written[crawler_place("T")])
    o->crawler.T = T;
  if (!o->written[crawler_place("alpha")])
    o->crawler.alpha = alpha;
}

const char *options_set_crawler_number(struct options *o, int place, const char *text)
{
  struct scallop_complaint complaint;
  struct scallop_crawler candidate = o->crawler; /* has no other fault */
  if (!read_number(text, crawler_field(&candidate, place)))
    return no_number(text, place == ALPHA ? "a number between 0 and 1, both excluded" : "a finite number > 0");
  if (scallop_crawler_check(&candidate, &complaint) != SCALLOP_OK)
    return not_allowed(text, complaint.allowed);
  o->crawler = candidate;
  o->written[place] = text;
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

static bool accepted(const struct command *command, const char *name)
{
  for (const char *const *a = command->accepts; *a; a++)
    if (strcmp(name, *a) == 0)
      return true;
  return false;
}

static const char *set_count(struct options *o, const char *name, const char *text)
{
  if (strcmp(name, "digits") == 0) {
    bool beyond_double = accepted(o->command, "certified") || accepted(o->command, "source");
    return read_count(text, 1, beyond_double ? MOST_DIGITS : DOUBLE_DIGITS, &o->digits) ? NULL
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
  return NULL;
}

static const char *set_file(struct options *o, const char *name, const char *text)
{
  if (*text == '\0')
    return not_allowed(text, "a file name");
  if (strcmp(name, "output") == 0)
    o->output = strcmp(text, "-") == 0 ? NULL : text;
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
  } flags[] = { { "bound", &o->bound }, { "certified", &o->certified },
                { "quick", &o->quick }, { "summary", &o->summary },
                { "full", &o->full },   { "stiff", &o->stiff },
                { "error", &o->error }, { "boundaries", &o->boundaries } };
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

static const struct description descriptions[] = {
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
  { "check.stress", NULL, "few cases, and exit code 1 if a promise is broken: for CI", set_against },
  { "quick.stress", NULL, "with --stiff: delta down to 1e-5 only", set_flag },
  { "summary.stress", NULL, "with --stiff: the order in delta, and where each stepper gives up", set_flag },
  { "family", "NAME", "of this family only", set_family },
  { "cases", "N", "of each family and gait (1000; 60 with --check, 5000 with --full)", set_count },
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
  { "quiet", NULL, "no notes on standard error, only errors", set_quiet },
};

/* Of an option that several commands take, the description for this one comes first. */
static const struct description *describe(const char *name, const struct command *command)
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

const char *options_set_parameter(struct options *o, const char *name, const char *text)
{
  return describe(name, o->command)->set(o, name, text);
}

/* Levenshtein's, upper and lower case being the same */
static int distance(const char *a, const char *b)
{
  enum { LONGEST = 40 };
  int row[LONGEST + 1];
  size_t m = strlen(b);
  if (m > LONGEST || strlen(a) > LONGEST)
    return LONGEST;
  for (size_t j = 0; j <= m; j++)
    row[j] = (int)j;
  for (size_t i = 1; a[i - 1] != '\0'; i++) {
    int diagonal = row[0];
    row[0] = (int)i;
    for (size_t j = 1; j <= m; j++) {
      int substitute = diagonal + (tolower((unsigned char)a[i - 1]) != tolower((unsigned char)b[j - 1]));
      int insert = (row[j] < row[j - 1] ? row[j] : row[j - 1]) + 1;
      diagonal = row[j];
      row[j] = substitute < insert ? substitute : insert;
    }
  }
  return row[m];
}

bool likely(const char *word, const char *name) { return distance(word, name) == 0; }

const char *nearest(const char *word, const char *const *names)
{
  const char *best = NULL;
  size_t length = strlen(word);
  int least = length > 0 ? (int)length / 3 + 1 : 0;
  for (; *names; names++) {
    int d = length > 2 && strncmp(word, *names, length) == 0 ? 0 : distance(word, *names);
    if (d <= least && (!best || d < least)) {
      best = *names;
      least = d;
    }
  }
  return best;
}

static bool refuse(int *code)
{
  *code = EXIT_USAGE;
  return false;
}

/* The option called name, whose value is text, or the next argument. argument: as it was written. */
static bool take_option(struct options *o, int count, char **arguments, int *i, int *code, char *name, const char *text)
{
  const char *argument = arguments[*i];
  bool two_dashes = argument[0] == '-' && argument[1] == '-' && argument[2] != '-';
  const struct description *d = accepted(o->command, name) ? describe(name, o->command) : NULL;
  if (!d || (!two_dashes && strcmp(argument, "-o") != 0)) {
    const char *near = nearest(name + strspn(name, "-"), o->command->accepts);
    bool elsewhere = describe(name, o->command) != NULL;
    complain(o->command->name, "%s option '%s'%s%s%s (see scallop %s --help)",
             elsewhere ? "this command does not take the" : "unknown", argument,
             near && !elsewhere ? ": did you mean '--" : "", near && !elsewhere ? near : "", near && !elsewhere ? "'?" : "",
             o->command->name);
    return refuse(code);
  }
  if (d->placeholder && !text) {
    if (*i + 1 == count) {
      complain(o->command->name, "--%s needs a value: --%s %s", name, name, d->placeholder);
      return refuse(code);
    }
    text = arguments[++*i];
  }
  if (!d->placeholder && text) {
    complain(o->command->name, "--%s takes no value", name);
    return refuse(code);
  }
  const char *wrong = d->set(o, name, text);
  if (!wrong && d->placeholder && strchr(d->placeholder, ' ')) { /* it takes two */
    if (*i + 1 == count) {
      complain(o->command->name, "--%s needs two values: --%s %s", name, name, d->placeholder);
      return refuse(code);
    }
    wrong = d->set(o, name, arguments[++*i]);
  }
  if (wrong)
    complain(o->command->name, "--%s: %s", name, wrong);
  if (wrong && o->unreadable) {
    *code = EXIT_FILE;
    return false;
  }
  return wrong ? refuse(code) : true;
}

static bool read_option(struct options *o, int count, char **arguments, int *i, int *code)
{
  char *argument = arguments[*i];
  bool two_dashes = argument[0] == '-' && argument[1] == '-' && argument[2] != '-';
  char *name = strcmp(argument, "-o") == 0 ? "output" : argument + (two_dashes ? 2 : 0);
  char *equals = two_dashes ? strchr(name, '=') : NULL;
  if (equals)
    *equals = '\0';
  bool taken = take_option(o, count, arguments, i, code, name, equals ? equals + 1 : NULL);
  if (equals) /* the arguments may be handed on: with_flint.h */
    *equals = '=';
  return taken;
}

bool options_read(struct options *o, const struct command *command, int count, char **arguments, int *code)
{
  *o = (struct options){ .command = command,
                         .arguments = arguments,
                         .start = "rest",
                         .crawler = command->defaults ? *command->defaults : scallop_crawler_default(),
                         .periods = 10,
                         .samples = 40,
                         .source = "published",
                         .order = 8,
                         .seed = 1,
                         .tolerance = 0.1 };
  for (int i = 2; i < count; i++) {
    if (strcmp(arguments[i], "--help") == 0 || strcmp(arguments[i], "-h") == 0) {
      options_help(stdout, command);
      *code = EXIT_DONE;
      return false;
    }
    if (arguments[i][0] == '-' && arguments[i][1] != '\0') {
      if (!read_option(o, count, arguments, &i, code))
        return false;
    } else if (command->operand && !o->operand) {
      o->operand = arguments[i];
    } else {
      complain(command->name, "unexpected argument '%s' (see scallop %s --help)", arguments[i], command->name);
      return refuse(code);
    }
  }
  if (command->operand && !o->operand) {
    complain(command->name, "an argument is missing: scallop %s %s", command->name, command->operand);
    return refuse(code);
  }
  options_complete(o);
  bool beyond_double = o->certified || o->bound || strcmp(o->source, "published") != 0;
  if (o->digits > DOUBLE_DIGITS && !beyond_double) {
    complain(command->name, "--digits: %ld is more than a double has: 1 to 17%s", o->digits,
             accepted(command, "certified") ? ", or up to 10000 with --certified"
             : accepted(command, "source")  ? ", or up to 10000 with --source derived or limit"
                                            : "");
    return refuse(code);
  }
  return true;
}

void options_help(FILE *to, const struct command *command)
{
  fprintf(to, "Example: %s\n\nscallop %s%s%s [options]: %s.\n\n%s\n\nOptions (defaults in brackets):\n", command->example,
          command->name, command->operand ? " " : "", command->operand ? command->operand : "", command->summary,
          command->about);
  for (const char *const *name = command->accepts; *name; name++) {
    const struct description *d = describe(*name, command);
    char left[40];
    snprintf(left, sizeof left, "--%s %s", *name, d->placeholder ? d->placeholder : "");
    fprintf(to, "  %-18s %s\n", left, d->help);
  }
  fprintf(to, "  %-18s %s\n", "--help", "this text");
  if (command->defaults)
    fprintf(to, "Defaults here: m1 = %g, m2 = %g, F1 = %g, F2 = %g, L = %g, alpha = %g.\n", command->defaults->m1,
            command->defaults->m2, command->defaults->F1, command->defaults->F2, command->defaults->L,
            command->defaults->alpha);
}
