#define _GNU_SOURCE /* tdestroy */
#include "compare/points/gaits.h"

#include <pthread.h>
#include <search.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/points/counts.h"
#include "compare/points/gait_file.h"
#include "compare/text/message.h"
#include "compare/text/values.h"

enum { MAX_GAITS = 65536, MESSAGE = 480 };

static char message[MESSAGE];

struct made {
  char *text, *parameters;
  const struct scallop_gait *gait;
  struct gait_source source; /* its numbers are in parameters */
  bool is_unreadable;        /* the file of a measured gait */
  union {
    union scallop_made_gait numbers;
    struct gait_file file;
  };
};

/* The family that is not made from numbers */
static const struct scallop_gait_family measured = {
  .name = "measured",
  .numbers = "FILE",
  .allowed = "measured:FILE, a table of t and l, or of t, x1 and x2, its name without control characters",
  .sentence = "a curve through a recording, a table of t and l, or of t, x1 and x2; L, T and alpha are its own. Behind "
              "FILE :monotone, :cubic, :smooth or :phases chooses the curve, :smooth=SIGMA states the noise, :period=P "
              "the period (docs/reference/gaits.md)"
};

const struct scallop_gait_family *gait_family(int i)
{
  const struct scallop_gait_family *family = scallop_gait_family(i);
  return family || !scallop_gait_family(i - 1) ? family : &measured;
}

static void *all_made; /* a tree (tsearch) by text */
static int made_count;

static bool is_measured(const struct made *made) { return made->source.family == &measured; }

static void discard(struct made *made)
{
  if (!made)
    return;
  if (made->source.kept)
    made->source.discard(made->source.kept);
  if (is_measured(made))
    gait_file_free(&made->file);
  free(made->text);
  free(made->parameters);
  free(made);
}

static void discard_node(void *made) { discard(made); }
static void free_all(void) { tdestroy(all_made, discard_node); }

/* Compares two struct made, by their first member, the text, or one with a pointer to a text. */
static int by_text(const void *a, const void *b) { return strcmp(*(char *const *)a, *(char *const *)b); }

static struct made *find(const char *text)
{
  struct made **found = made_count > 0 ? tfind(&text, &all_made, by_text) : NULL;
  return found ? *found : NULL;
}

/* Returns false if memory is short. */
static bool keep(struct made *made)
{
  count_add(COUNT_GAITS, 1);
  if (made_count++ == 0)
    atexit(free_all);
  return tsearch(made, &all_made, by_text) != NULL;
}

/* Reads numbers between commas. Returns NULL or the error; "": too many numbers. */
static const char *read_numbers(struct gait_source *source, char *text, double x[SCALLOP_GAIT_NUMBERS])
{
  static char not_one[120];
  for (char *next = text; next; source->count++) {
    text = next;
    next = strchr(text, ',');
    if (next)
      *next++ = '\0';
    if (source->count == SCALLOP_GAIT_NUMBERS)
      return "";
    if (!read_number(text, &x[source->count])) {
      snprintf(not_one, sizeof not_one, "'%.80s' is not a number", text);
      return not_one;
    }
    source->number[source->count] = text;
  }
  return NULL;
}

static const char *make_of_numbers(struct made *m)
{
  double x[SCALLOP_GAIT_NUMBERS];
  const char *why = read_numbers(&m->source, m->parameters, x);
  m->gait = &m->numbers.gait;
  if (why || scallop_make_gait(&m->numbers, m->source.family, m->text, x, m->source.count, &why) == SCALLOP_OK)
    return why;
  return why ? why : "";
}

/* A name with control characters could not be printed in a table. */
static const char *make_measured(struct made *m)
{
  const char *c = m->parameters;
  while ((unsigned char)*c >= ' ')
    c++;
  const char *wrong = *c || c == m->parameters ? ""
                                               : gait_file_read(&m->file, m->parameters, m->text, &m->is_unreadable);
  m->gait = m->file.best.gait;
  return wrong;
}

/* Returns the family named by text up to one of the characters of ends, or NULL. */
static const struct scallop_gait_family *family_of(const char *text, const char *ends)
{
  size_t length = strcspn(text, ends);
  const struct scallop_gait_family *family;
  for (int i = 0; (family = gait_family(i)) != NULL; i++)
    if (strncmp(text, family->name, length) == 0 && family->name[length] == '\0')
      break;
  return family;
}

bool gait_family_begins(const char *text) { return family_of(text, ":,") != NULL; }

/* Returns the error for an unknown gait: the families, with the numbers they need, and the nearest name. */
static const char *unknown_gait_error(const char *text)
{
  enum { MAX_NAMES = 32 };
  const char *names[MAX_NAMES] = { NULL }, *shown[MAX_NAMES] = { NULL };
  char name[40], list[320], with_numbers[MAX_NAMES][40];
  const struct scallop_gait_family *family;
  for (int i = 0; i + 1 < MAX_NAMES && (family = gait_family(i)) != NULL; i++) {
    bool must = family->numbers && !family->usual;
    snprintf(with_numbers[i], sizeof *with_numbers, "%s:%s", family->name, must ? family->numbers : "");
    names[i] = family->name;
    shown[i] = must ? with_numbers[i] : family->name;
  }
  snprintf(name, sizeof name, "%.*s", (int)strcspn(text, ":"), text);
  snprintf(message, MESSAGE, "'%.80s' is not allowed here: it takes %s%s", text,
           joined(list, sizeof list, shown, " or "), did_you_mean(nearest(name, names)));
  return message;
}

/* Makes the gait. Returns NULL or the error. */
static const char *make(struct made *m, const char *parameters)
{
  const char *text = m->text, *allowed = m->source.family->allowed;
  m->parameters = strdup(parameters);
  if (!m->parameters)
    return "out of memory";
  const char *why = is_measured(m) ? make_measured(m) : make_of_numbers(m);
  if (!why)
    return keep(m) ? NULL : "out of memory";
  if (*why && is_measured(m))
    return why;
  snprintf(message, MESSAGE, "'%.80s' is not allowed here: %.120s%sit takes %s", text, why, *why ? "; " : "", allowed);
  return message;
}

struct gait_result gait_of_text(const char *text)
{
  const struct scallop_gait *fixed = scallop_gait_named(text);
  const struct made *made = fixed ? NULL : find(text);
  if (fixed || made)
    return (struct gait_result){ .gait = fixed ? fixed : made->gait };
  const struct scallop_gait_family *family = family_of(text, ":");
  const char *colon = strchr(text, ':'), *wrong = NULL;
  if (!family || family->fixed || (colon && !family->allowed))
    return (struct gait_result){ NULL, GAIT_UNKNOWN, unknown_gait_error(text) };
  if (strlen(text) > GAIT_TEXT - sizeof "--gait ")
    wrong = "the name of this gait is too long";
  else if (made_count == MAX_GAITS)
    wrong = "there are more than 65536 different gaits";
  if (wrong)
    return (struct gait_result){ NULL, GAIT_UNKNOWN, wrong };
  struct made *new = calloc(1, sizeof *new);
  if (new)
    *new = (struct made){ .source.family = family, .text = strdup(text) };
  wrong = !new || !new->text ? "out of memory" : make(new, colon ? colon + 1 : family->usual ? family->usual : "");
  if (!wrong)
    return (struct gait_result){ .gait = new->gait };
  enum gait_fault fault = new &&new->is_unreadable ? GAIT_UNREADABLE : GAIT_UNKNOWN;
  discard(new);
  return (struct gait_result){ NULL, fault, wrong };
}

const char gait_no_ends[] =
    "l'' = 0 where a phase of this gait begins or ends: the published formulas, which divide by it, have no value";

bool gait_has_ends(const struct scallop_gait *gait)
{
  for (int kind = 0; kind < 2; kind++)
    if (gait->phase[kind].l0 == 0 || gait->phase[kind].lT == 0)
      return false;
  return true;
}

/* Returns the record of a gait made from text, or NULL. */
static struct made *made_of(const struct scallop_gait *gait)
{
  struct made *made = find(gait->name);
  return made && made->gait == gait ? made : NULL;
}

struct gait_source *gait_source_of(const struct scallop_gait *gait)
{
  struct made *m = made_of(gait);
  return m && !is_measured(m) ? &m->source : NULL;
}

const struct gait_file *gait_file_of(const struct scallop_gait *gait)
{
  const struct made *m = made_of(gait);
  return m && is_measured(m) ? &m->file : NULL;
}

bool gait_exchange(struct scallop_crawler *c, int i)
{
  static pthread_mutex_t by_one_thread = PTHREAD_MUTEX_INITIALIZER;
  const struct gait_file *file = gait_file_of(c->gait);
  if (!file)
    return false;
  pthread_mutex_lock(&by_one_thread);
  const struct scallop_measured_gait other = scallop_measured_gait(file->measured, i);
  pthread_mutex_unlock(&by_one_thread);
  if (!other.gait)
    return false;
  c->gait = other.gait;
  c->L = c->L == file->best.L ? other.L : c->L;
  c->T = c->T == file->best.T ? other.T : c->T;
  c->alpha = c->alpha == file->best.alpha ? other.alpha : c->alpha;
  return true;
}

int gait_reversals(const struct scallop_gait *gait)
{
  int reversals = 0;
  for (int kind = 0; kind < 2; kind++) {
    const struct scallop_shape *shape = &gait->phase[kind];
    int last = kind == SCALLOP_EXTENSION ? 1 : -1;
    for (int i = 0; i < shape->count; i++) {
      int direction = shape->pieces[i].direction;
      reversals += direction != 0 && direction != last;
      last = direction != 0 ? direction : last;
    }
  }
  return reversals;
}
