#include "compare/points/point_flint.h"

#include <stdlib.h>

#include "compare/points/gait_file.h"
#include "compare/points/gaits.h"
#include "compare/text/digits.h"
#include "compare/text/table.h"
#include "model/exact/fractions.h"

enum { OWN = 3 };

struct written {
  struct scallop_exact_gait exact;
  bool is_exact; /* else the doubles stand for it                */
  fmpq *own;     /* of a measured gait: L, T and alpha, or NULL */
};

static void discard(void *kept)
{
  struct written *w = kept;
  scallop_exact_clear(&w->exact);
  if (w->own)
    _fmpq_vec_clear(w->own, OWN);
  flint_free(w);
}

static bool of_numbers(struct written *w, const struct scallop_gait *gait, const struct gait_source *source)
{
  fmpq *x = _fmpq_vec_init(source->count);
  bool right = true;
  for (int i = 0; i < source->count; i++)
    right = right && scallop_rational_parse(x + i, source->number[i]);
  right = right && scallop_exact_made(&w->exact, source->family, gait, x, source->count);
  _fmpq_vec_clear(x, source->count);
  return right;
}

/* Times and lengths of the rows of a period, from the least row on: 0 to file->last. Rows before that one come a period
 * later. */
static bool read_period(fmpq *t, fmpq *l, const struct gait_file *file)
{
  const struct gait_row *rows = file->rows;
  fmpq_t first, period;
  fmpq_init(first);
  fmpq_init(period);
  bool right = scallop_rational_parse(first, rows[0].written[0])
               && scallop_rational_parse(period, rows[file->last].written[0]);
  fmpq_sub(period, period, first);
  for (long i = 0; right && i <= file->last; i++) {
    const struct gait_row *row = &rows[(file->least + i) % file->last];
    right = scallop_rational_parse(t + i, row->written[0]) && scallop_rational_parse(l + i, row->written[1]);
    if (file->least + i >= file->last)
      fmpq_add(t + i, t + i, period);
  }
  fmpq_clear(first);
  fmpq_clear(period);
  return right;
}

/* (x[i] - x[from])/(x[to] - x[from]) for i from first on */
static void scale(fmpq *scaled, const fmpq *x, long first, long count, long from, long to)
{
  fmpq_t range;
  fmpq_init(range);
  fmpq_sub(range, x + to, x + from);
  for (long i = 0; i < count; i++) {
    fmpq_sub(scaled + i, x + first + i, x + from);
    fmpq_div(scaled + i, scaled + i, range);
  }
  fmpq_clear(range);
}

/* L, T and alpha: l and t of a period, its first row the least one, `most` the largest and `last` its end */
static fmpq *own_of(const fmpq *t, const fmpq *l, long most, long last)
{
  fmpq *own = _fmpq_vec_init(OWN);
  fmpq_sub(own, l + most, l);
  fmpq_sub(own + 1, t + last, t);
  fmpq_sub(own + 2, t + most, t);
  fmpq_div(own + 2, own + 2, own + 1);
  return own;
}

static bool of_table(struct written *w, const struct scallop_gait *gait, const struct gait_file *file)
{
  const long n = file->last, most = file->most - file->least, first[2] = { 0, most }, last[2] = { most, n };
  const int count[2] = { (int)most + 1, (int)(n - most) + 1 };
  fmpq *t = _fmpq_vec_init(n + 1), *l = _fmpq_vec_init(n + 1);
  fmpq *times = _fmpq_vec_init(n + 2), *lengths = _fmpq_vec_init(n + 2);
  const fmpq *const scaled_times[2] = { times, times + count[0] }, *const scaled_lengths[2] = { lengths,
                                                                                                lengths + count[0] };
  bool right = read_period(t, l, file);
  for (int kind = 0; right && kind < 2; kind++) {
    scale(times + (kind == 0 ? 0 : count[0]), t, first[kind], count[kind], first[kind], last[kind]);
    scale(lengths + (kind == 0 ? 0 : count[0]), l, first[kind], count[kind], 0, most);
  }
  if (right)
    w->own = own_of(t, l, most, n);
  right = right && scallop_exact_spline(&w->exact, gait, scaled_times, scaled_lengths, count);
  _fmpq_vec_clear(t, n + 1);
  _fmpq_vec_clear(l, n + 1);
  _fmpq_vec_clear(times, n + 2);
  _fmpq_vec_clear(lengths, n + 2);
  return right;
}

static struct written *work_out(const struct scallop_gait *gait, const struct gait_source *source)
{
  struct written *w = flint_malloc(sizeof *w);
  w->own = NULL;
  scallop_exact_init(&w->exact);
  w->is_exact = source->file ? of_table(w, gait, source->file) : of_numbers(w, gait, source);
  return w;
}

/* NULL: it is not made of numbers. */
static const struct written *written_of(const struct scallop_gait *gait)
{
  struct gait_source source;
  if (!gait || !gait_source_of(gait, &source))
    return NULL;
  if (!*source.kept) {
    *source.kept = work_out(gait, &source);
    *source.discard = discard;
  }
  return *source.kept;
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

static fmpq *field_of(struct scallop_rational_crawler *c, int place)
{
  fmpq *const fields[CRAWLER_NUMBERS] = { c->m1, c->m2, c->F1, c->F2, c->L, c->T, c->alpha };
  return fields[place];
}

void rational_crawler(struct scallop_rational_crawler *exact, const struct scallop_crawler *c)
{
  double values[CRAWLER_NUMBERS];
  crawler_numbers(c, values);
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    rational_number(field_of(exact, i), values[i]);
  exact->gait = written_gait(c->gait);
}

void rational_point(struct scallop_rational_crawler *exact, fmpq_t v0, const struct point *p)
{
  enum { FIRST = CRAWLER_NUMBERS - OWN }; /* of L, T and alpha */
  const struct written *w = written_of(p->crawler.gait);
  double values[CRAWLER_NUMBERS], own[OWN];
  bool has_own = gait_has_own(p->crawler.gait, &own[0], &own[1], &own[2]) && w && w->own;
  crawler_numbers(&p->crawler, values);
  rational_crawler(exact, &p->crawler);
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    if (p->written[i])
      scallop_rational_parse(field_of(exact, i), p->written[i]);
    else if (has_own && i >= FIRST && values[i] == own[i - FIRST])
      fmpq_set(field_of(exact, i), w->own + i - FIRST);
  if (v0)
    rational_number(v0, p->v0);
  if (v0 && p->written_v0)
    scallop_rational_parse(v0, p->written_v0);
}

char *decimal_text(const arb_t x, long digits) { return arb_get_str(x, digits, ARB_STR_NO_RADIUS); }

char *decimal_fraction(const fmpq_t x) { return fmpq_get_str(NULL, 10, x); }

char *decimal_ball(const arb_t x, long digits) { return arb_get_str(x, digits, 0); }
