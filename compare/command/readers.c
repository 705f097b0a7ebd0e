/* Readers of the values of options. */
#include <limits.h>
#include <stdio.h>
#include <string.h>

#include "compare/answers/vary.h"
#include "compare/columns/columns.h"
#include "compare/command/readers.h"
#include "compare/tables/plot.h"

const char *const reference_words[] = { "exact", "certified", NULL };

int option_values(const struct option *o)
{
  bool is_flag = o->read == read_flag || o->read == read_product;
  return is_flag ? 0 : o->values > 0 ? o->values : 1;
}

static void *field_of(void *options, const struct option *o) { return (char *)options + o->field; }

const char *read_parameter(void *options, const struct option *o, const char *text)
{
  return vary_text(options, o->name, text);
}

const char *read_product(void *options, const struct option *o, const char *text)
{
  struct request *r = options;
  (void)o, (void)text;
  return r->sweep.products > 0 ? vary_product(r) : "nothing varies in front of it";
}

const char *read_flag(void *options, const struct option *o, const char *text)
{
  (void)text;
  *(bool *)field_of(options, o) = true;
  return NULL;
}

const char *read_real(void *options, const struct option *o, const char *text)
{
  double value;
  if (!read_number(text, &value) || value < o->min || value > o->max)
    return no_number(text, o->allowed);
  *(struct optional_number *)field_of(options, o) = (struct optional_number){ value, true };
  return NULL;
}

const char *read_whole(void *options, const struct option *o, const char *text)
{
  struct optional_count *count = field_of(options, o);
  count->given = read_count(text, (long)o->min, (long)o->max, &count->value);
  return count->given ? NULL : not_allowed(text, wrong_text("a whole number from %.0f to %.0f", o->min, o->max));
}

/* Returns the place of the word, or -1, with an error. */
static int find_word(const char *const *words, const char *text, const char **wrong)
{
  char list[400];
  int place = word_place(text, words);
  *wrong = place < 0 ? not_allowed(
               text, wrong_text("%s%s", joined(list, sizeof list, words, " or "), did_you_mean(nearest(text, words))))
                     : NULL;
  return place;
}

const char *read_word(void *options, const struct option *o, const char *text)
{
  const char *wrong;
  int place = find_word(o->words, text, &wrong);
  if (!wrong)
    *(struct optional_word *)field_of(options, o) = (struct optional_word){ o->words[place], true };
  return wrong;
}

const char *read_format(void *options, const struct option *o, const char *text)
{
  struct request *r = options;
  const char *wrong;
  int place = find_word(format_names, text, &wrong);
  (void)o;
  if (!wrong) {
    r->style.format = (enum format)place;
    r->style.has_format = true;
  }
  return wrong;
}

const char *read_text(void *options, const struct option *o, const char *text)
{
  const char **place = field_of(options, o);
  for (int more = option_values(o) - 1; more > 0 && *place; more--)
    place++;
  *place = text;
  return *text == '\0' ? not_allowed(text, o->allowed) : NULL;
}

const char *read_digits(void *options, const struct option *o, const char *text)
{
  struct request *r = options;
  bool fine = read_count(text, 1, (long)o->max, &r->style.digits);
  return fine ? NULL : not_allowed(text, wrong_text("a whole number %s", o->allowed));
}

const char *read_output(void *options, const struct option *o, const char *text)
{
  struct request *r = options;
  (void)o;
  if (*text == '\0')
    return not_allowed(text, "a file name");
  if (plot_kind(text))
    return not_allowed(text, "the name of a table, not of a picture, which --plot draws (`scallop run` draws the plots "
                             "of its scenes)");
  r->style.output = strcmp(text, "-") == 0 ? NULL : text;
  r->style.has_output = true;
  return NULL;
}

const char *read_plot(void *options, const struct option *o, const char *text)
{
  struct request *r = options;
  return plot_set(&r->style.plot, o->name, text);
}

const char *read_sample(void *options, const struct option *o, const char *text)
{
  struct samples *s = &((struct request *)options)->samples;
  char copy[OPTION_VALUE];
  long seed = 0;
  snprintf(copy, sizeof copy, "%s", text);
  char *count = strchr(copy, ':'), *behind = count ? strchr(count + 1, ':') : NULL;
  const bool is_sobol = strncmp(copy, "sobol:", 6) == 0;
  (void)o;
  if (behind)
    *behind++ = '\0';
  bool fine = is_sobol ? !behind && read_count(count + 1, 1, SWEEP_RANGE, &s->count)
                       : strncmp(copy, "random:", 7) == 0 && behind && read_count(behind, 0, LONG_MAX, &seed)
                             && read_count(count + 1, 1, (long)SWEEP_POINTS, &s->count);
  if (is_sobol && !sweep_sobol.begin)
    return "this program was built without GSL, which has the Sobol sequences: random:N:SEED";
  s->sampling = is_sobol ? SAMPLING_SOBOL : SAMPLING_RANDOM;
  s->seed = (uint64_t)seed;
  return fine ? NULL : not_allowed(text, "sobol:N with N from 1 to 1e9, or random:N:SEED, all whole numbers");
}

const char *read_shard(void *options, const struct option *o, const char *text)
{
  struct shard *s = &((struct request *)options)->shard;
  char part[OPTION_VALUE];
  const char *slash = strchr(text, '/');
  (void)o;
  snprintf(part, sizeof part, "%.*s", (int)(slash ? slash - text : 0), text);
  bool fine = slash && read_count(slash + 1, 1, SWEEP_RANGE, &s->parts) && read_count(part, 1, s->parts, &s->part);
  return fine ? NULL : not_allowed(text, "I/N, the I-th of N parts, with I from 1 to N");
}

const char *read_choice(void *options, const struct option *o, const char *text)
{
  struct request *r = options;
  (void)o;
  columns_free(r->style.choice);
  r->style.chosen = true;
  return columns_read(&r->style.choice, text);
}
