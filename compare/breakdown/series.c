#include "compare/breakdown/series.h"
#include "compare/book/book.h"

#include "compare/points/gaits.h"

void expansions_init(struct expansions *e, const struct motion *motion, slong order, slong precision)
{
  struct scallop_crawler crawler = motion->crawler;
  *e = (struct expansions){ .motion = motion };
  scallop_rational_init(&e->crawler);
  fmpq_init(e->v0);
  series_answer_init(&e->derived);
  crawler.T = 1; /* not used */
  scallop_rational_of(&e->crawler, &crawler);
  scallop_rational_set_double(e->v0, motion->v0);
  answer_in_series(&e->derived, &e->crawler, motion->of, motion->phase, e->v0, order, precision);
}

void expansions_clear(struct expansions *e)
{
  series_answer_clear(&e->derived);
  fmpq_clear(e->v0);
  scallop_rational_clear(&e->crawler);
}

const char *expansions_modes(const struct expansions *e)
{
  return e->derived.status == SCALLOP_OK ? e->derived.modes : "";
}

const struct series *expansions_of(const struct expansions *e, enum quantity_id quantity)
{
  return e->derived.status == SCALLOP_OK ? e->derived.value[quantity] : NULL;
}

bool series_is_about(const struct scallop_formula *f, const struct motion *m, enum quantity_id quantity)
{
  enum quantity_id own = quantity_of_formula(f, m->phase);
  enum scallop_setting moving = m->phase == SCALLOP_EXTENSION ? SCALLOP_MOVING_EXTENSION : SCALLOP_MOVING_CONTRACTION,
                       setting = m->of == OF_STEADY ? SCALLOP_STEADY
                                 : m->v0 == 0       ? SCALLOP_AT_REST_START
                                                    : moving;
  return f->setting == setting && !formula_takes_given(f)
         && (own == quantity || (own == Q_DISPLACEMENT && quantity == Q_MEAN_VELOCITY)
             || (own == Q_CHANGE && quantity == Q_V_END));
}

/* Past its first term that is not 0, or all that is known if there is none */
static slong past_first(const struct series *s)
{
  slong k = s->first;
  while (k < s->known && k < s->first + SCALLOP_MOST_TERMS && series_coefficient_is_zero(s, k))
    k++;
  return k + 1;
}

int series_items(struct series_item items[MOST_ITEMS], const struct expansions *e, enum quantity_id quantity,
                 long order)
{
  const struct series *s = expansions_of(e, quantity);
  int count = 0;
  const struct scallop_formula *f;
  for (int i = 0; (f = listed_formula(i)) && count < MOST_ITEMS - 2; i++)
    if (series_is_about(f, e->motion, quantity))
      items[count++] = (struct series_item){ book_formula(i) ? FROM_BOOK : FROM_PUBLISHED, quantity, f->name,
                                             .formula = f };
  if (s) {
    items[count++] = (struct series_item){ FROM_DERIVED, quantity, "derived", .series = s, .before = order };
    items[count++] = (struct series_item){ FROM_LIMIT, quantity, "limit", .series = s, .before = past_first(s) };
  }
  return count;
}

static void published(arb_t value, const struct series_item *item, const struct expansions *e, const fmpq_t T)
{
  const struct motion *m = e->motion;
  bool is_other = quantity_of_formula(item->formula, m->phase) != item->quantity;
  arb_t x;
  arb_init(x);
  /* where l'' = 0 at an end of a phase the paper's formulas divide by 0, whatever remains of them, and there is no
   * L_kin */
  bool divides = item->source == FROM_PUBLISHED || formula_takes(item->formula, SCALLOP_SYMBOL_L_kin);
  if ((divides && !gait_has_ends(m->crawler.gait))
      || !published_in_balls(value, item->formula, &e->crawler, m->phase, e->v0, T, NULL, BREAKDOWN_BITS))
    arb_indeterminate(value);
  arb_set_fmpq(x, item->quantity == Q_MEAN_VELOCITY ? T : e->v0, BREAKDOWN_BITS);
  if (is_other && item->quantity == Q_MEAN_VELOCITY)
    arb_div(value, value, x, BREAKDOWN_BITS);
  else if (is_other)
    arb_add(value, value, x, BREAKDOWN_BITS);
  arb_clear(x);
}

void series_item_value(arb_t value, const struct series_item *item, const struct expansions *e, double T,
                       slong precision)
{
  arb_t time;
  fmpq_t exact;
  arb_init(time);
  fmpq_init(exact);
  arb_set_d(time, T);
  scallop_rational_set_double(exact, T);
  if (item->formula)
    published(value, item, e, exact);
  else
    series_value(value, item->series, time, item->before, precision);
  fmpq_clear(exact);
  arb_clear(time);
}
