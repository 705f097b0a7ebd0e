#include "compare/answers/block.h"

#include <stdlib.h>
#include <string.h>

#include "compare/points/counts.h"
#include "numerics/numerics.h"

enum { MAX_VALUES_KEPT = 1 << 16 };

struct block {
  double parameter[CRAWLER_NUMBERS][BLOCK_ROWS], number[FIRST_OF_PHASE][BLOCK_ROWS], v_low[BLOCK_ROWS],
      v_high[BLOCK_ROWS];
  const struct scallop_gait *gait[BLOCK_ROWS];
  enum scallop_status status[BLOCK_ROWS];
  enum scallop_regime regime[BLOCK_ROWS];
  struct scallop_modes modes[BLOCK_ROWS][2];
  bool takes_modes;
  int columns;
  const double *column[TABLE_COLUMNS]; /* NULL: a text */
  enum quantity_kind kind[TABLE_COLUMNS];
  const struct sweep_product *product; /* the current product */
  const struct sweep_group *last;      /* its fastest group, if that is independent of the others; or NULL */
  double *value[SWEEP_VARIABLES];      /* the values of that group's variables; NULL: not kept */
};

/* Returns false if a block cannot have this column. */
static bool add_column(struct block *b, const struct quantity *q)
{
  const double **column = &b->column[b->columns];
  b->kind[b->columns++] = q->kind;
  if (q->kind == QUANTITY_NUMBER && q->which < CRAWLER_NUMBERS)
    *column = b->parameter[q->which];
  else if (q->kind == QUANTITY_RATIO && q->which == FROUDE)
    *column = b->number[Q_FROUDE];
  else if (q->kind == QUANTITY_ANSWER && q->motion == OF_STEADY && q->which < FIRST_OF_PHASE)
    *column = b->number[q->which];
  b->takes_modes |= q->kind == QUANTITY_MODES;
  bool is_how = (q->kind == QUANTITY_REGIME || q->kind == QUANTITY_MODES) && q->motion == OF_STEADY;
  return *column || is_how || q->kind == QUANTITY_STATUS || q->kind == QUANTITY_GAIT;
}

struct block *block_new(const struct rows *r)
{
  const struct column_list *list = &r->sheet.columns;
  bool fine = !r->visit && !r->sheet.as_written && !counts_are_printed && !r->request->points;
  struct block *b = fine ? calloc(1, sizeof *b) : NULL;
  for (int i = 0; i < list->count && b && fine; i++)
    fine = !list->item[i].formula && add_column(b, &r->sheet.required->quantities.item[list->item[i].place]);
  return fine ? b : (free(b), NULL);
}

void block_free(struct block *b)
{
  for (int i = 0; b && i < SWEEP_VARIABLES; i++)
    free(b->value[i]);
  free(b);
}

/* Returns true if the last group consists of numbers that do not depend on slower groups and set no other numbers. */
static bool is_independent(const struct sweep_product *p, const struct point *about)
{
  const struct sweep_group *last = &p->group[p->groups - 1];
  bool plain = last->count > 1;
  for (int i = 0; i < RATIOS; i++)
    plain = plain && about->ratio[i] == 0;
  for (const struct sweep_variable *v = last->variable; v < last->variable + last->variables; v++)
    plain = plain && v->target == TARGET_NUMBER && !v->from.is_formula && !v->to.is_formula;
  return plain;
}

/* Stores all values of the fastest group, up to a maximum; about: any point of the group. */
static void keep_values(struct block *b, struct sweep_walk *w, const struct point *about)
{
  const struct sweep_product *p = b->product = w->product;
  b->last = p->groups > 0 && is_independent(p, about) ? &p->group[p->groups - 1] : NULL;
  for (int k = 0; b->last && k < b->last->variables; k++) {
    free(b->value[k]);
    const long count = b->last->sampling == SAMPLING_NONE && b->last->count <= MAX_VALUES_KEPT ? b->last->count : 0;
    b->value[k] = count > 0 ? malloc((size_t)count * sizeof(double)) : NULL;
    for (long i = 0; i < count && b->value[k]; i++)
      b->value[k][i] = sweep_number(w, b->last, k, i);
  }
}

/* Stores the parameters of at most count points, from this one to the end of its group. Returns their number. */
static int store_points(struct block *b, int at, struct sweep_walk *w, const struct sweep_place *here, int count)
{
  if (w->product && w->product != b->product)
    keep_values(b, w, &here->point);
  const struct sweep_group *last = w->product ? b->last : NULL;
  const long begin = last ? w->value[w->product->groups - 1] : 0, left = last ? last->count - begin : 1;
  count = left < count ? (int)left : count;
  for (int k = 0; k < CRAWLER_NUMBERS; k++) {
    const double x = crawler_number(&here->point.crawler, k);
    for (int i = 0; i < count; i++)
      b->parameter[k][at + i] = x;
  }
  for (int i = 0; i < count; i++)
    b->gait[at + i] = here->point.crawler.gait;
  for (int i = 0; i < count && last; i++)
    for (int k = 0; k < last->variables; k++)
      b->parameter[last->variable[k].place][at + i] = b->value[k] ? b->value[k][begin + i]
                                                                  : sweep_number(w, last, k, begin + i);
  return count;
}

static bool solve(struct block *b, int count)
{
  double(*p)[BLOCK_ROWS] = b->parameter, (*n)[BLOCK_ROWS] = b->number;
  const struct scallop_crawlers crawlers = { count, p[0], p[1], p[2], p[3], p[4], p[5], p[6], b->gait };
  const struct scallop_steady_states states = {
    n[Q_FROUDE],     n[Q_V_START], n[Q_V_MID], n[Q_DISPLACEMENT], n[Q_MEAN_VELOCITY],
    n[Q_MULTIPLIER], b->v_low,     b->v_high,  b->regime,         b->takes_modes ? b->modes : NULL,
    b->status
  };
  return scallop_steady_batch(&crawlers, &states, 1) == 0;
}

static void put_text(const struct block *b, struct table *t, enum quantity_kind kind, int i)
{
  char text[ANSWER_STATUS + MOTION_MODES_TEXT];
  const struct answer a = { .status = b->status[i], .v_low = b->v_low[i], .v_high = b->v_high[i] };
  table_text(t, kind == QUANTITY_GAIT     ? b->gait[i]->name
                : kind == QUANTITY_REGIME ? scallop_regime_text(b->regime[i])
                : kind == QUANTITY_MODES  ? motion_modes_text(text, OF_STEADY, b->modes[i])
                                          : answer_status_text(text, &a));
}

bool block_rows(struct block *b, struct rows *r, struct at *at, struct sweep_walk *w, long first, int count)
{
  const struct request *q = r->request;
  struct table *t = &r->table;
  for (int done = 0; done < count;) {
    const struct sweep_place *here = sweep_point(w, &q->sweep, &q->point, first + done, at_formula_so_far, at);
    if (here->why[0] != '\0' || here->point.ratio[FROUDE] > 0) /* the column froude is then the given number */
      return false;
    done += store_points(b, done, w, here, count - done);
  }
  if (!solve(b, count))
    return false;
  if (table_doubles(t, b->column, count))
    return true;
  for (int i = 0; i < count; i++)
    for (int k = 0; k < b->columns; k++)
      if (b->column[k])
        table_number(t, b->column[k][i]);
      else
        put_text(b, t, b->kind[k], i);
  return true;
}
