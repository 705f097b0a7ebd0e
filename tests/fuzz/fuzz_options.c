/* Command lines: the first byte chooses the command, the rest, split at newlines and NULs, its arguments. It is read
 * and not run. Each argument is also given to every parameter. */
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/fuzz/target.h"
#include "tests/support/solved.h"

enum { MOST = 40 };

static int split(char *text, size_t size, char **arguments)
{
  int count = 2;
  for (char *at = text; at <= text + size && count < MOST - 1; at += strlen(at) + 1) {
    arguments[count++] = at;
    at[strcspn(at, "\n")] = '\0';
  }
  return count;
}

static double no_value(void *context, const struct sweep_place *place, const struct formula *formula)
{
  return (void)context, (void)place, (void)formula, 1;
}

/* Lists and ranges: the first and the last point of each product, where no end is a formula */
static void judge_sweep(const struct request *r, const char *text)
{
  struct scallop_complaint wrong;
  const struct sweep_variable *v;
  for (int i = 0; (v = sweep_variable(&r->sweep, i)); i++)
    if (v->from.is_formula || v->to.is_formula || (v->is_sampled && r->samples.count > 1000)
        || (v->target > TARGET_V0 && v->target != TARGET_GAIT && v->target != TARGET_PHASE))
      return;
  long first = 0;
  for (int p = 0; p < r->sweep.products; p++) {
    const struct sweep one = { 1, &r->sweep.product[p] };
    struct sweep_walk walk = { .product = NULL };
    for (int i = 0; i < 2; i++) {
      const struct sweep_place *place = sweep_point(&walk, &r->sweep, &r->point,
                                                    first + (i == 0 ? 0 : sweep_points(&one) - 1), no_value, NULL);
      if (place->why[0] != '\0' || scallop_crawler_check(&place->point.crawler, &wrong) != SCALLOP_OK
          || !isfinite(place->point.v0))
        fuzz_fail("an end is no point (%s) in\n%s", place->why, text);
    }
    sweep_walk_end(&walk);
    first += sweep_points(&one);
  }
}

/* What an accepted command line may hold: each option what its row allows */
static void judge(const struct arguments *a, const char *text)
{
  const struct request *r = &a->options.request;
  struct scallop_complaint wrong;
  if (scallop_crawler_check(&r->point.crawler, &wrong) != SCALLOP_OK)
    fuzz_fail("%s = %g was taken from\n%s", wrong.name, wrong.given, text);
  for (const struct option *o = a->command->options; o->name; o++) {
    const void *field = a->options.bytes + o->field;
    const struct optional_count *count = field;
    const struct optional_number *number = field;
    if (o->read == read_digits && (r->style.digits < 0 || r->style.digits > o->max))
      fuzz_fail("%ld digits from\n%s", r->style.digits, text);
    if (o->read == read_whole && count->given && (count->value < o->min || count->value > o->max))
      fuzz_fail("--%s %ld from\n%s", o->name, count->value, text);
    if (o->read == read_real
        && !(isfinite(number->value) && (!number->given || (number->value >= o->min && number->value <= o->max))))
      fuzz_fail("--%s %g from\n%s", o->name, number->value, text);
  }
  judge_sweep(r, text);
  if (!isfinite(r->point.v0))
    fuzz_fail("v0 %g from\n%s", r->point.v0, text);
  if ((a->command->operand != NULL) != (a->operand_count > 0))
    fuzz_fail("the operand is missing, or not wanted, in\n%s", text);
}

static void judge_parameters(const char *text)
{
  struct point o = point_initial(NULL);
  for (const char *const *name = crawler_parameters; *name; name++) {
    struct scallop_crawler before = o.crawler;
    const char *wrong = point_set(&o, *name, text);
    bool same = before.gait == o.crawler.gait;
    for (int i = 0; i < PARAMETERS; i++)
      same = same && same_bits(*parameter(&before, i), *parameter(&o.crawler, i));
    if (wrong && (!same || *wrong == '\0'))
      fuzz_fail("%s was refused '%s', and changed", *name, text);
    if (scallop_crawler_check(&o.crawler, NULL) != SCALLOP_OK)
      fuzz_fail("%s may be '%s'", *name, text);
  }
}

/* Refused with a message, or help; the arguments are as they were. */
static void judge_line(const struct command *command, char *text, size_t size)
{
  char *arguments[MOST] = { (char *)"scallop", (char *)command->name };
  struct arguments read;
  struct written w;
  enum exit_code code;
  int count = split(text, size, arguments);
  char *before = fuzz_text((const uint8_t *)text, size);
  written_begin(&w);
  enum reading reading = options_read(&read, command, commands, count, arguments, &code);
  written_end(&w);
  if (memcmp(before, text, size) != 0)
    fuzz_fail("the arguments were changed");
  if (reading == READ_RUN)
    judge(&read, text);
  else if (reading == READ_REFUSED && !(code == EXIT_USAGE && w.err_size > 0))
    fuzz_fail("exit code %d without a word for\n%s", (int)code, text);
  for (int i = 2; i < count; i++)
    judge_parameters(arguments[i]);
  options_free(&read);
  written_free(&w);
  free(before);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  int known = 0;
  while (commands[known])
    known++;
  if (size == 0 || known == 0)
    return 0;
  char *text = fuzz_text(data + 1, size - 1);
  judge_line(commands[data[0] % known], text, size - 1);
  free(text);
  return 0;
}
