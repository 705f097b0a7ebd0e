#include "compare/answers/point_flint.h"

#include <stdlib.h>
#include <string.h>

#include "compare/answers/gait_file.h"
#include "compare/answers/gaits.h"
#include "compare/text/digits.h"
#include "compare/text/table.h"
#include "model/fractions.h"

enum { MOST_NUMBERS = SCALLOP_POLYNOMIAL_DEGREE, OWN = 3 };

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

/* Numbers between commas. Returns how many there are; 0: one of them cannot be read. */
static int read_numbers(fmpq *numbers, const char *text)
{
  int count = 0;
  for (;; text += strcspn(text, ",") + 1) {
    char word[400];
    size_t length = strcspn(text, ",");
    if (count == MOST_NUMBERS || length >= sizeof word)
      return 0;
    memcpy(word, text, length);
    word[length] = '\0';
    if (!scallop_rational_parse(numbers + count, word))
      return 0;
    count++;
    if (text[length] == '\0')
      return count;
  }
}

static bool of_numbers(struct written *w, const struct scallop_gait *gait, const struct gait_source *source)
{
  fmpq *x = _fmpq_vec_init(MOST_NUMBERS), *y = _fmpq_vec_init(4);
  int count = read_numbers(x, source->parameters);
  bool right = count > 0;
  if (right && strcmp(source->kind, "trapezoidal") == 0) {
    for (int i = 0; i < 4; i++) /* up, up, down, down */
      fmpq_set(y + i, x + (i < 2 ? 0 : 1) + (count == 4 && i % 2 ? 2 : 0));
    scallop_exact_trapezoidal(&w->exact, gait, y, y + 2);
  } else if (right && strcmp(source->kind, "skewed") == 0) {
    fmpq_set(y, x);
    fmpq_set(y + 1, x + count - 1);
    scallop_exact_skewed(&w->exact, gait, y);
  } else
    right = right && scallop_exact_polynomial(&w->exact, gait, x, count);
  _fmpq_vec_clear(x, MOST_NUMBERS);
  _fmpq_vec_clear(y, 4);
  return right;
}

struct table_of { /* a period of it, from the least row on: 0 to last, and the same as fractions                      */
  fmpq *t, *l;
  long last, most;
};

/* Of row i from the least row on; what is beyond the last row comes a period later. */
static bool read_row(struct table_of *table, const struct gait_file *file, long i)
{
  long at = file->least + i, turn = at >= file->last ? file->last : 0;
  fmpq_t first, last;
  fmpq_init(first);
  fmpq_init(last);
  bool right = scallop_rational_parse(table->t + i, file->rows[at - turn].written[0])
               && scallop_rational_parse(table->l + i, file->rows[at - turn].written[1])
               && scallop_rational_parse(first, file->rows[0].written[0])
               && scallop_rational_parse(last, file->rows[file->last].written[0]);
  if (turn > 0) {
    fmpq_add(table->t + i, table->t + i, last);
    fmpq_sub(table->t + i, table->t + i, first);
  }
  fmpq_clear(first);
  fmpq_clear(last);
  return right;
}

static void table_clear(struct table_of *table)
{
  _fmpq_vec_clear(table->t, table->last + 1);
  _fmpq_vec_clear(table->l, table->last + 1);
}

static bool table_read(struct table_of *table, const struct gait_file *file)
{
  *table = (struct table_of){ .t = _fmpq_vec_init(file->last + 1), .l = _fmpq_vec_init(file->last + 1), .last = file->last };
  table->most = file->most - file->least;
  bool right = true;
  for (long i = 0; right && i <= table->last; i++)
    right = read_row(table, file, i);
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

static void set_own(struct written *w, const struct table_of *table)
{
  w->own = _fmpq_vec_init(OWN);
  fmpq_sub(w->own, table->l + table->most, table->l);
  fmpq_sub(w->own + 1, table->t + table->last, table->t);
  fmpq_sub(w->own + 2, table->t + table->most, table->t);
  fmpq_div(w->own + 2, w->own + 2, w->own + 1);
}

static bool of_table(struct written *w, const struct scallop_gait *gait, const struct gait_file *file)
{
  struct table_of table;
  bool right = table_read(&table, file);
  const long first[2] = { 0, table.most }, last[2] = { table.most, table.last };
  fmpq *times = _fmpq_vec_init(table.last + 2), *lengths = _fmpq_vec_init(table.last + 2);
  const fmpq *const t[2] = { times, times + table.most + 1 }, *const l[2] = { lengths, lengths + table.most + 1 };
  const int count[2] = { (int)table.most + 1, (int)(table.last - table.most) + 1 };
  for (int kind = 0; right && kind < 2; kind++) {
    scale(times + (t[kind] - times), table.t, first[kind], count[kind], first[kind], last[kind]);
    scale(lengths + (l[kind] - lengths), table.l, first[kind], count[kind], 0, table.most);
  }
  if (right)
    set_own(w, &table);
  right = right && scallop_exact_spline(&w->exact, gait, t, l, count);
  _fmpq_vec_clear(times, table.last + 2);
  _fmpq_vec_clear(lengths, table.last + 2);
  table_clear(&table);
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

bool written_gait_has_own(const struct scallop_gait *gait, fmpq_t L, fmpq_t T, fmpq_t alpha)
{
  const struct written *w = written_of(gait);
  if (!w || !w->own)
    return false;
  fmpq_set(L, w->own);
  fmpq_set(T, w->own + 1);
  fmpq_set(alpha, w->own + 2);
  return true;
}

static void rational_number(fmpq_t x, double value)
{
  char text[NUMBER_TEXT];
  number_text(text, value, 0);
  if (!scallop_rational_parse(x, text))
    scallop_rational_set_double(x, value);
}

void rational_crawler(struct scallop_rational_crawler *exact, const struct scallop_crawler *c)
{
  fmpq *const fields[] = { exact->m1, exact->m2, exact->F1, exact->F2, exact->L, exact->T, exact->alpha };
  double values[CRAWLER_NUMBERS];
  crawler_numbers(c, values);
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    rational_number(fields[i], values[i]);
  exact->gait = written_gait(c->gait);
}

/* L, T and alpha that come of the table of a measured gait are those of its decimals. */
static void take_own(struct scallop_rational_crawler *exact, const struct point *p)
{
  enum { FIRST = 4 }; /* of L, T and alpha among the crawler's numbers */
  fmpq_t own[OWN];
  double L, T, alpha;
  for (int i = 0; i < OWN; i++)
    fmpq_init(own[i]);
  if (gait_has_own(p->crawler.gait, &L, &T, &alpha) && written_gait_has_own(p->crawler.gait, own[0], own[1], own[2])) {
    const double is[OWN] = { p->crawler.L, p->crawler.T, p->crawler.alpha }, was[OWN] = { L, T, alpha };
    fmpq *const fields[OWN] = { exact->L, exact->T, exact->alpha };
    for (int i = 0; i < OWN; i++)
      if (!p->written[FIRST + i] && is[i] == was[i])
        fmpq_set(fields[i], own[i]);
  }
  for (int i = 0; i < OWN; i++)
    fmpq_clear(own[i]);
}

void rational_point(struct scallop_rational_crawler *exact, fmpq_t v0, const struct point *p)
{
  fmpq *const fields[] = { exact->m1, exact->m2, exact->F1, exact->F2, exact->L, exact->T, exact->alpha };
  rational_crawler(exact, &p->crawler);
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    if (p->written[i])
      scallop_rational_parse(fields[i], p->written[i]);
  take_own(exact, p);
  if (!v0)
    return;
  rational_number(v0, p->v0);
  if (p->written_v0)
    scallop_rational_parse(v0, p->written_v0);
}

char *decimal_text(const arb_t x, long digits) { return arb_get_str(x, digits, ARB_STR_NO_RADIUS); }

char *decimal_fraction(const fmpq_t x) { return fmpq_get_str(NULL, 10, x); }

char *decimal_ball(const arb_t x, long digits) { return arb_get_str(x, digits, 0); }
