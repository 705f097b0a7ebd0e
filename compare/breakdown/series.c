/* The series beside the exact motion: the paper's, the derived ones, the limit. */
#include <math.h>
#include <string.h>

#include "compare/breakdown/series.h"

static const struct ring ring = { 1, BREAKDOWN_BITS };

void expansions_init(struct expansions *e, const struct motion *motion, slong order, slong precision)
{
  struct scallop_crawler crawler = motion->crawler;
  fmpq_t v0;
  fmpq_init(v0);
  *e = (struct expansions){ .motion = motion };
  scallop_rational_init(&e->crawler);
  series_answer_init(&e->derived);
  scallop_symbols_init(&e->symbols);
  crawler.T = 1; /* not used */
  scallop_rational_of(&e->crawler, &crawler);
  scallop_rational_set_double(v0, motion->v0);
  answer_in_series(&e->derived, &e->crawler, motion->of, motion->phase, v0, order, precision);
  enum scallop_phase_kind kind = motion->of == OF_STEADY ? SCALLOP_EXTENSION : motion->phase;
  scallop_symbols_set(&e->symbols, &e->crawler, kind, motion->of == OF_STEADY ? NULL : v0, NULL, &ring);
  fmpq_clear(v0);
}

void expansions_clear(struct expansions *e)
{
  scallop_symbols_clear(&e->symbols);
  series_answer_clear(&e->derived);
  scallop_rational_clear(&e->crawler);
}

const char *expansions_modes(const struct expansions *e) { return e->derived.status == SCALLOP_OK ? e->derived.modes : ""; }

const struct series *expansions_of(const struct expansions *e, enum quantity_id quantity)
{
  return e->derived.status == SCALLOP_OK ? e->derived.value[quantity] : NULL;
}

/* Whether the formula is about the quantity, itself or (*by_T) its product with T, or what it gains (*change). */
static bool is_about(const struct scallop_formula *f, const struct motion *m, enum quantity_id quantity, bool *by_T,
                     bool *change)
{
  *by_T = *change = false;
  if (m->of == OF_STEADY) {
    *by_T = f->quantity == SCALLOP_STEADY_DISPLACEMENT && quantity == Q_MEAN_VELOCITY;
    return f->setting == SCALLOP_STEADY && (*by_T || quantity_of_formula(f, SCALLOP_EXTENSION) == quantity);
  }
  enum scallop_setting moving = m->phase == SCALLOP_EXTENSION ? SCALLOP_MOVING_EXTENSION : SCALLOP_MOVING_CONTRACTION;
  if (f->setting != (m->v0 == 0 ? SCALLOP_AT_REST_START : moving) || formula_takes_given(f))
    return false;
  *change = f->quantity == SCALLOP_VELOCITY_CHANGE;
  return quantity_of_formula(f, m->phase) == quantity || (*change && quantity == Q_V_END);
}

static bool next_published(struct series_item *item, const struct expansions *e, enum quantity_id quantity)
{
  const struct scallop_formula *f = item->name ? item->formula + 1 : scallop_published;
  for (; f->name; f++)
    if (is_about(f, e->motion, quantity, &item->divide_by_T, &item->add_v0)) {
      item->which = (struct breakdown_series){ FROM_PUBLISHED, 0, quantity };
      item->formula = f;
      item->name = f->name;
      return true;
    }
  return false;
}

/* Its first term that is not 0; known if there is none. */
static slong first_power(const struct series *s)
{
  slong k = s->first;
  while (k < s->known && k < s->first + SCALLOP_MOST_TERMS && series_coefficient_is_zero(s, k))
    k++;
  return k;
}

bool series_item_next(struct series_item *item, const struct expansions *e, enum quantity_id quantity, long order)
{
  bool begin = !item->name;
  if ((begin || item->which.source == FROM_PUBLISHED) && next_published(item, e, quantity))
    return true;
  enum breakdown_source source = begin || item->which.source == FROM_PUBLISHED ? FROM_DERIVED : FROM_LIMIT;
  if (!begin && item->which.source == FROM_LIMIT)
    return false;
  const struct series *s = expansions_of(e, quantity);
  if (!s)
    return false;
  *item = (struct series_item){ .which = { source, source == FROM_DERIVED ? order : 0, quantity },
                                .series = s,
                                .before = source == FROM_DERIVED ? order : first_power(s) + 1,
                                .name = source == FROM_DERIVED ? "derived" : "limit" };
  return true;
}

/* Where l'' = 0 at an end of a phase the paper's formulas divide by 0, whatever remains of them. */
static bool has_ends(const struct motion *s)
{
  const struct scallop_shape *phase = s->crawler.gait->phase;
  bool has = true;
  for (int kind = 0; kind < 2; kind++)
    if (s->of == OF_STEADY || kind == (int)s->phase)
      has = has && phase[kind].l0 != 0 && phase[kind].lT != 0;
  return has;
}

static bool formula_value(arb_t value, const struct series_item *item, struct expansions *e, const fmpq_t T)
{
  if (!has_ends(e->motion))
    return false;
  struct series v;
  series_init(&v);
  series_set_rational(&e->symbols.value[SYMBOL_T], T);
  enum scallop_phase_kind kind = e->motion->of == OF_STEADY ? SCALLOP_EXTENSION : e->motion->phase;
  bool found = scallop_formula_expand(&v, item->formula, &e->symbols, kind, &ring);
  if (found)
    series_coefficient(value, &v, 0, BREAKDOWN_BITS);
  series_clear(&v);
  return found;
}

void series_item_value(arb_t value, const struct series_item *item, struct expansions *e, double T, slong precision)
{
  arb_t time;
  arb_init(time);
  arb_set_d(time, T);
  if (item->series) {
    series_value(value, item->series, time, item->before, precision);
  } else {
    fmpq_t t;
    fmpq_init(t);
    scallop_rational_set_double(t, T);
    if (!formula_value(value, item, e, t))
      arb_indeterminate(value);
    fmpq_clear(t);
    if (item->divide_by_T)
      arb_div(value, value, time, precision);
    if (item->add_v0) {
      arb_set_d(time, e->motion->v0);
      arb_add(value, value, time, precision);
    }
  }
  arb_clear(time);
}
