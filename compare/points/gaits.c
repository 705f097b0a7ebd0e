#define _GNU_SOURCE /* tdestroy */
#include "compare/points/gaits.h"

#include <search.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/points/counts.h"
#include "compare/points/gait_file.h"
#include "compare/text/message.h"
#include "compare/text/values.h"
#include "model/gaits.h"

enum { MOST_GAITS = 65536, MESSAGE = 480 };

static char message[MESSAGE];

struct made {
  char *text, *parameters;
  const struct scallop_gait_family *family;
  const char *number[SCALLOP_GAIT_NUMBERS]; /* in parameters */
  int count;
  void *kept;
  void (*discard)(void *);
  const struct scallop_gait *gait;
  bool is_unreadable; /* the file of a measured one */
  union {
    union scallop_made_gait numbers;
    struct gait_file file;
  };
};

/* Beside the families that are made of numbers */
static const struct scallop_gait_family measured = {
  .name = "measured",
  .numbers = "FILE",
  .allowed = "measured:FILE, a table of t and l, its name without control "
             "characters",
  .sentence = "a spline through a table of t and l, whose last row is the first "
              "one a period later; L, T and alpha are its own"
};

const struct scallop_gait_family *gait_family(int i)
{
  int count = 0;
  while (scallop_gait_family(count))
    count++;
  return i == count ? &measured : scallop_gait_family(i);
}

static void *all_made; /* a tree (tsearch) by text */
static int made_count;

static struct gait_file *file_of(struct made *made) { return made->family == &measured ? &made->file : NULL; }

static void discard(struct made *made)
{
  if (!made)
    return;
  if (made->kept)
    made->discard(made->kept);
  if (file_of(made))
    gait_file_free(&made->file);
  free(made->text);
  free(made->parameters);
  free(made);
}

static void discard_node(void *made) { discard(made); }
static void free_all(void) { tdestroy(all_made, discard_node); }

/* Of two made ones, which begin with their texts, or of one and a text */
static int by_text(const void *a, const void *b) { return strcmp(*(char *const *)a, *(char *const *)b); }

static struct made *find(const char *text)
{
  struct made **found = made_count > 0 ? tfind(&text, &all_made, by_text) : NULL;
  return found ? *found : NULL;
}

/* False: no memory. */
static bool keep(struct made *made)
{
  count_add(COUNT_GAITS, 1);
  if (made_count++ == 0)
    atexit(free_all);
  return tsearch(made, &all_made, by_text) != NULL;
}

/* Reads numbers between commas. NULL, or what is wrong; "": there are too many. */
static const char *read_numbers(struct made *m, double x[SCALLOP_GAIT_NUMBERS])
{
  static char not_one[120];
  for (char *next = m->parameters; next; m->count++) {
    char *text = next;
    next = strchr(text, ',');
    if (next)
      *next++ = '\0';
    if (m->count == SCALLOP_GAIT_NUMBERS)
      return "";
    if (!read_number(text, &x[m->count])) {
      snprintf(not_one, sizeof not_one, "'%.80s' is not a number", text);
      return not_one;
    }
    m->number[m->count] = text;
  }
  return NULL;
}

static const char *make_of_numbers(struct made *m)
{
  double x[SCALLOP_GAIT_NUMBERS];
  const char *why = read_numbers(m, x);
  m->gait = &m->numbers.gait;
  if (why || scallop_make_gait(&m->numbers, m->family, m->text, x, m->count, &why) == SCALLOP_OK)
    return why;
  return why ? why : "";
}

/* A name with control characters could not be printed in a table. */
static const char *make_measured(struct made *m)
{
  const char *c = m->parameters;
  while ((unsigned char)*c >= ' ')
    c++;
  m->gait = &m->file.spline.gait;
  return *c || c == m->parameters ? "" : gait_file_read(&m->file, m->parameters, m->text, &m->is_unreadable);
}

const char *gait_sample(int i)
{
  const struct scallop_gait_family *family = scallop_gait_family(i);
  return family ? family->sample : NULL;
}

/* The family of that name, up to one of the characters of ends or the end */
static const struct scallop_gait_family *family_until(const char *text, const char *ends)
{
  size_t length = strcspn(text, ends);
  const struct scallop_gait_family *family;
  for (int i = 0; (family = gait_family(i)) != NULL; i++)
    if (strncmp(text, family->name, length) == 0 && family->name[length] == '\0')
      break;
  return family;
}

static const struct scallop_gait_family *family_of(const char *text) { return family_until(text, ":"); }
bool gait_family_begins(const char *text) { return family_until(text, ":,") != NULL; }

static struct gait_answer refused(enum gait_fault fault) { return (struct gait_answer){ NULL, fault, message }; }

static struct gait_answer unknown(const char *text)
{
  enum { MOST = 32 };
  const char *names[MOST] = { NULL };
  char name[40];
  const struct scallop_gait_family *family;
  int used = snprintf(message, sizeof message, "'%.80s' is not allowed here: it takes", text);
  for (int i = 0; i + 1 < MOST && (family = gait_family(i)) != NULL; i++) {
    bool must = family->numbers && !family->usual;
    const char *before = i == 0 ? "" : gait_family(i + 1) ? "," : " or";
    used += snprintf(message + used, sizeof message - (size_t)used, "%s %s%s%s", before, family->name, must ? ":" : "",
                     must ? family->numbers : "");
    names[i] = family->name;
  }
  snprintf(name, sizeof name, "%.*s", (int)strcspn(text, ":"), text);
  snprintf(message + used, sizeof message - (size_t)used, "%s", did_you_mean(nearest(name, names)));
  return refused(GAIT_UNKNOWN);
}

static struct gait_answer make(const struct scallop_gait_family *family, const char *text, const char *parameters)
{
  struct made *m = made_count < MOST_GAITS ? calloc(1, sizeof *m) : NULL;
  if (m)
    *m = (struct made){ .family = family, .text = strdup(text), .parameters = strdup(parameters) };
  if (!m || !m->text || !m->parameters) {
    snprintf(message, sizeof message,
             m ? "out of memory" : "'%.80s' is one gait too many: 65536 different ones are the most", text);
    discard(m);
    return refused(GAIT_UNKNOWN);
  }
  const char *why = file_of(m) ? make_measured(m) : make_of_numbers(m);
  if (!why && keep(m))
    return (struct gait_answer){ m->gait, GAIT_FINE, NULL };
  why = why ? why : "out of memory";
  enum gait_fault fault = m->is_unreadable ? GAIT_UNREADABLE : GAIT_UNKNOWN;
  if (*why && file_of(m))
    snprintf(message, sizeof message, "%s", why);
  else
    snprintf(message, sizeof message, "'%.80s' is not allowed here: %.120s%sit takes %s", text, why, *why ? "; " : "",
             family->allowed);
  discard(m);
  return refused(fault);
}

struct gait_answer gait_of_text(const char *text)
{
  const struct scallop_gait *fixed = scallop_gait_named(text);
  if (fixed)
    return (struct gait_answer){ fixed, GAIT_FINE, NULL };
  struct made *made = find(text);
  if (made)
    return (struct gait_answer){ made->gait, GAIT_FINE, NULL };
  const struct scallop_gait_family *family = family_of(text);
  const char *colon = strchr(text, ':');
  if (!family || family->fixed || (colon && !family->allowed))
    return unknown(text);
  if (strlen(text) > GAIT_TEXT - sizeof "--gait ") {
    snprintf(message, sizeof message, "'%.80s...' is too long", text);
    return refused(GAIT_UNKNOWN);
  }
  const char *parameters = colon ? colon + 1 : family->usual ? family->usual : "";
  return make(family, text, parameters);
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

/* Of those that were made */
static struct made *made_of(const struct scallop_gait *gait)
{
  struct made *made = find(gait->name);
  return made && made->gait == gait ? made : NULL;
}

bool gait_source_of(const struct scallop_gait *gait, struct gait_source *source)
{
  struct made *m = made_of(gait);
  if (!m || file_of(m))
    return false;
  *source = (struct gait_source){ m->family, m->number, m->count, &m->kept, &m->discard };
  return true;
}

bool gait_has_own(const struct scallop_gait *gait, double *L, double *T, double *alpha)
{
  struct made *made = made_of(gait);
  const struct gait_file *file = made ? file_of(made) : NULL;
  if (file) {
    *L = file->L;
    *T = file->T;
    *alpha = file->alpha;
  }
  return file != NULL;
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
