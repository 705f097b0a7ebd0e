#include "compare/points/point_flint.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/points/gaits.h"
#include "compare/text/digits.h"
#include "compare/tables/table.h"
#include "compare/text/values.h"
#include "model/exact/fractions.h"

struct written {
  struct scallop_exact_gait exact;
  bool is_exact; /* else the doubles are used */
};

static void discard(void *kept)
{
  struct written *w = kept;
  scallop_exact_clear(&w->exact);
  flint_free(w);
}

static struct written *derive_gait(const struct scallop_gait *gait, const struct gait_source *source)
{
  struct written *w = flint_malloc(sizeof *w);
  fmpq *x = _fmpq_vec_init(source->count);
  bool right = true;
  scallop_exact_init(&w->exact);
  for (int i = 0; i < source->count; i++)
    right = right && scallop_rational_parse(x + i, source->number[i]);
  w->is_exact = right && scallop_exact_made(&w->exact, source->family, gait, x, source->count);
  _fmpq_vec_clear(x, source->count);
  return w;
}

/* Returns NULL if the gait is not made from numbers. */
static const struct written *written_of(const struct scallop_gait *gait)
{
  static pthread_mutex_t by_one_thread = PTHREAD_MUTEX_INITIALIZER;
  struct gait_source *source = gait ? gait_source_of(gait) : NULL;
  if (!source)
    return NULL;
  pthread_mutex_lock(&by_one_thread);
  if (!source->kept) {
    source->kept = derive_gait(gait, source);
    source->discard = discard;
  }
  pthread_mutex_unlock(&by_one_thread);
  return source->kept;
}

const struct scallop_gait *written_gait(const struct scallop_gait *gait)
{
  const struct written *w = written_of(gait);
  return w && w->is_exact ? &w->exact.gait : gait;
}

static void rational_number(fmpq_t x, double value)
{
  char text[NUMBER_TEXT];
  number_text(text, value, 0);
  if (!scallop_rational_parse(x, text))
    scallop_rational_set_double(x, value);
}

/* Reads a number as given, 0.6 or 3/5. */
static void read_rational(fmpq_t x, const char *text)
{
  const char *slash = strchr(text, '/');
  char over[NUMBER_LENGTH + 1];
  SCOPED(fmpq, under);
  snprintf(over, sizeof over, "%.*s", slash ? (int)(slash - text) : NUMBER_LENGTH, text);
  scallop_rational_parse(x, over);
  if (slash && scallop_rational_parse(under, slash + 1))
    fmpq_div(x, x, under);
}

fmpq *rational_field(struct scallop_rational_crawler *c, int place)
{
  fmpq *const fields[CRAWLER_NUMBERS] = { c->m1, c->m2, c->F1, c->F2, c->L, c->T, c->alpha };
  return fields[place];
}

void rational_crawler(struct scallop_rational_crawler *exact, const struct scallop_crawler *c)
{
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    rational_number(rational_field(exact, i), crawler_number(c, i));
  exact->gait = written_gait(c->gait);
}

void rational_point(struct scallop_rational_crawler *exact, fmpq_t v0, const struct point *p)
{
  rational_crawler(exact, &p->crawler);
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    if (p->written[i])
      read_rational(rational_field(exact, i), p->written[i]);
  if (v0)
    rational_number(v0, p->v0);
  if (v0 && p->written[PLACE_OF_V0])
    read_rational(v0, p->written[PLACE_OF_V0]);
}

char *decimal_text(const arb_t x, long digits) { return arb_get_str(x, digits, ARB_STR_NO_RADIUS); }

char *decimal_fraction(const fmpq_t x) { return fmpq_get_str(NULL, 10, x); }

char *decimal_ball(const arb_t x, long digits) { return arb_get_str(x, digits, 0); }
