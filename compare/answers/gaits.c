#include "compare/answers/gaits.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "compare/text/memory.h"
#include "compare/answers/counts.h"
#include "compare/answers/gait_file.h"
#include "compare/text/message.h"
#include "compare/text/values.h"
#include "model/gaits.h"

const char gaits_help[] =
    "quadratic, sinusoidal, trapezoidal[:UP,DOWN] (0.25,0.25), skewed[:BETA] (0.25), minimum-jerk, polynomial:C1,C2,... or "
    "measured:FILE, which has L, T and alpha of its own";

enum { MOST_GAITS = 65536, BUCKETS = 4096, MOST_NUMBERS = SCALLOP_POLYNOMIAL_DEGREE, MESSAGE = 480 };

static char message[MESSAGE];

struct made {
  struct made *next;
  char *text, *parameters;
  const struct kind *kind;
  const char *number[MOST_NUMBERS]; /* in parameters */
  int count;
  void *kept;
  void (*discard)(void *);
  const struct scallop_gait *gait;
  bool is_unreadable; /* the file of a measured one */
  union {
    struct scallop_straight straight;
    struct scallop_polynomial polynomial;
    struct gait_file file;
  };
};

struct kind {
  const char *name;
  const char *usual;   /* its parameters where none are given, or NULL */
  const char *allowed; /* its parameters in words; NULL: it takes none */
  /* x: made->count numbers. NULL, or what is wrong; "": not as allowed */
  const char *(*make)(struct made *made, const double *x);
  int numbers;        /* it takes, or half of them, which then hold for the contraction too; 0: any number */
  const char *sample; /* one of them, its parameters not the usual ones where there are any; NULL: a file has to be read */
};

static struct made *buckets[BUCKETS];
static int made_count;

static const char *make_measured(struct made *m, const double *none);

static struct gait_file *file_of(struct made *made) { return made->kind->make == make_measured ? &made->file : NULL; }

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

static void free_all(void)
{
  for (int i = 0; i < BUCKETS; i++)
    while (buckets[i]) {
      struct made *first = buckets[i];
      buckets[i] = first->next;
      discard(first);
    }
}

static unsigned bucket_of(const char *text) { return checksum_after(CHECKSUM_OF_NOTHING, text, strlen(text)) % BUCKETS; }

static struct made *find(const char *text)
{
  struct made *m = buckets[bucket_of(text)];
  while (m && strcmp(m->text, text) != 0)
    m = m->next;
  return m;
}

static void keep(struct made *made)
{
  count_add(COUNT_GAITS, 1);
  if (made_count++ == 0)
    atexit(free_all);
  struct made **bucket = &buckets[bucket_of(made->text)];
  made->next = *bucket;
  *bucket = made;
}

/* Reads numbers between commas, and repeats them for the contraction. NULL, or what is wrong; "": there are too many or too few. */
static const char *read_numbers(struct made *m, double x[MOST_NUMBERS])
{
  static char not_one[120];
  for (char *next = m->parameters; next; m->count++) {
    char *text = next;
    next = strchr(text, ',');
    if (next)
      *next++ = '\0';
    if (m->count == MOST_NUMBERS)
      return "";
    if (!read_number(text, &x[m->count])) {
      snprintf(not_one, sizeof not_one, "'%.80s' is not a number", text);
      return not_one;
    }
    m->number[m->count] = text;
  }
  int half = m->kind->numbers / 2;
  for (int i = 0; m->count == half + i && i < half; i++, m->count++) {
    x[m->count] = x[i];
    m->number[m->count] = m->number[i];
  }
  return half == 0 || m->count == 2 * half ? NULL : "";
}

static const char *make_trapezoidal(struct made *m, const double *x)
{
  const double up[2] = { x[0], x[2] }, down[2] = { x[1], x[3] };
  m->gait = &m->straight.gait;
  return scallop_make_trapezoidal(&m->straight, m->text, up, down) == SCALLOP_OK ? NULL : "";
}

static const char *make_skewed(struct made *m, const double *beta)
{
  m->gait = &m->straight.gait;
  return scallop_make_skewed(&m->straight, m->text, beta) == SCALLOP_OK ? NULL : "";
}

static const char *make_polynomial(struct made *m, const double *x)
{
  double c[MOST_NUMBERS + 1] = { 0 }; /* c[0] of s^0 */
  const char *why = "";
  memcpy(c + 1, x, (size_t)m->count * sizeof *x);
  m->gait = &m->polynomial.gait;
  return scallop_make_polynomial(&m->polynomial, m->text, c, m->count, &why) == SCALLOP_OK ? NULL : why;
}

/* A name with control characters could not be printed in a table. */
static const char *make_measured(struct made *m, const double *none)
{
  const char *c = m->parameters;
  (void)none;
  while ((unsigned char)*c >= ' ')
    c++;
  m->gait = &m->file.spline.gait;
  return *c || c == m->parameters ? "" : gait_file_read(&m->file, m->parameters, m->text, &m->is_unreadable);
}

static const struct kind kinds[] = {
  { "quadratic", NULL, NULL, NULL, 0, "quadratic" },
  { "sinusoidal", NULL, NULL, NULL, 0, "sinusoidal" },
  { "trapezoidal", "0.25,0.25",
    "trapezoidal:UP,DOWN or trapezoidal:UP,DOWN,UP,DOWN, fractions of the extension and of the contraction in which |l'| "
    "rises and falls: "
    "from 2^-100, UP + DOWN at most 1",
    make_trapezoidal, 4, "trapezoidal:0.2,0.3" },
  { "skewed", "0.25",
    "skewed:BETA or skewed:BETA,BETA, fractions of the extension and of the contraction in which |l'| rises: from 2^-100, "
    "below 1",
    make_skewed, 2, "skewed:0.3" },
  { "polynomial", NULL, "polynomial:C1,C2,... of degree 3 to 16 with l' = 0 at both ends and C1 + C2 + ... > 0",
    make_polynomial, 0, "polynomial:0,0,0,35,-84,70,-20" },
  { "minimum-jerk", "0,0,10,-15,6", NULL, make_polynomial, 0, "minimum-jerk" },
  { "measured", NULL, "measured:FILE, a table of t and l, its name without control characters", make_measured, 0, NULL },
};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

const char *gait_sample(int i)
{
  for (int k = 0; k < KINDS; k++)
    if (kinds[k].sample && i-- == 0)
      return kinds[k].sample;
  return NULL;
}

/* The kind of that name, up to the colon or the end */
static const struct kind *kind_of(const char *text)
{
  size_t length = strcspn(text, ":");
  for (int i = 0; i < KINDS; i++)
    if (strncmp(text, kinds[i].name, length) == 0 && kinds[i].name[length] == '\0')
      return &kinds[i];
  return NULL;
}

static struct gait_answer refused(enum gait_fault fault) { return (struct gait_answer){ NULL, fault, message }; }

static struct gait_answer unknown(const char *text)
{
  const char *names[KINDS + 1] = { NULL };
  char name[40];
  for (int i = 0; i < KINDS; i++)
    names[i] = kinds[i].name;
  snprintf(name, sizeof name, "%.*s", (int)strcspn(text, ":"), text);
  snprintf(message, sizeof message,
           "'%.80s' is not allowed here: it takes quadratic, sinusoidal, trapezoidal, skewed, minimum-jerk, "
           "polynomial:C1,C2,... or measured:FILE%s",
           text, did_you_mean(nearest(name, names)));
  return refused(GAIT_UNKNOWN);
}

static struct gait_answer make(const struct kind *kind, const char *text, const char *parameters)
{
  struct made *m = made_count < MOST_GAITS ? calloc(1, sizeof *m) : NULL;
  double x[MOST_NUMBERS];
  if (m)
    *m = (struct made){ .kind = kind, .text = strdup(text), .parameters = strdup(parameters) };
  if (!m || !m->text || !m->parameters) {
    snprintf(message, sizeof message,
             m ? "out of memory" : "'%.80s' is one gait too many: 65536 different ones are the most", text);
    discard(m);
    return refused(GAIT_UNKNOWN);
  }
  const char *why = file_of(m) ? NULL : read_numbers(m, x);
  if (!why)
    why = kind->make(m, x);
  if (!why) {
    keep(m);
    return (struct gait_answer){ m->gait, GAIT_FINE, NULL };
  }
  enum gait_fault fault = m->is_unreadable ? GAIT_UNREADABLE : GAIT_UNKNOWN;
  if (*why && file_of(m))
    snprintf(message, sizeof message, "%s", why);
  else
    snprintf(message, sizeof message, "'%.80s' is not allowed here: %.120s%sit takes %s", text, why, *why ? "; " : "",
             kind->allowed);
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
  const struct kind *kind = kind_of(text);
  const char *colon = strchr(text, ':');
  if (!kind || !kind->make || (colon && !kind->allowed))
    return unknown(text);
  if (strlen(text) > GAIT_TEXT - sizeof "--gait ") {
    snprintf(message, sizeof message, "'%.80s...' is too long", text);
    return refused(GAIT_UNKNOWN);
  }
  const char *parameters = colon ? colon + 1 : kind->usual ? kind->usual : "";
  return make(kind, text, parameters);
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

/* Of those that were made. */
static struct made *made_of(const struct scallop_gait *gait)
{
  struct made *made = made_count > 0 ? find(gait->name) : NULL;
  return made && made->gait == gait ? made : NULL;
}

static bool is_from(struct made *made, const struct stat *there)
{
  struct stat file;
  return file_of(made) && stat(made->parameters, &file) == 0 && file.st_dev == there->st_dev && file.st_ino == there->st_ino;
}

bool gait_is_from(const char *path)
{
  struct stat there;
  bool found = false;
  if (stat(path, &there) == 0)
    for (int i = 0; i < BUCKETS; i++)
      for (struct made *m = buckets[i]; m; m = m->next)
        found = found || is_from(m, &there);
  return found;
}

uint32_t gait_checksum(const struct scallop_gait *gait)
{
  struct made *made = made_of(gait);
  uint32_t knots = made && file_of(made) ? made->file.checksum : CHECKSUM_OF_NOTHING;
  return checksum_after(knots, gait->name, strlen(gait->name));
}

bool gait_source_of(const struct scallop_gait *gait, struct gait_source *source)
{
  struct made *made = made_of(gait);
  if (made)
    *source = (struct gait_source){ .kind = made->kind->name,
                                    .number = made->number,
                                    .count = made->count,
                                    .file = file_of(made),
                                    .kept = &made->kept,
                                    .discard = &made->discard };
  return made != NULL;
}

bool gait_has_own(const struct scallop_gait *gait, double *L, double *T, double *alpha)
{
  struct made *made = made_of(gait);
  if (!made || !file_of(made))
    return false;
  *L = made->file.L;
  *T = made->file.T;
  *alpha = made->file.alpha;
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
