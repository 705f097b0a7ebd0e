#include <math.h>
#include <string.h>

#include "compare/book/book.h"
#include "compare/breakdown/motion.h"
#include "compare/points/gaits.h"

bool breakdown_takes(const struct breakdown_options *o, enum breakdown_source source)
{
  static const char *const names[] = { "book", "published", "derived", "limit" };
  return !o->source.given || strcmp(o->source.value, names[source]) == 0;
}

struct motion motion_at(const struct motion *m, double T)
{
  struct motion at = *m;
  at.crawler.T = m->of == OF_STEADY ? T : 2 * T;
  at.crawler.alpha = m->of == OF_STEADY ? m->crawler.alpha : 0.5;
  return at;
}

bool motion_in_wide(const struct motion *m, double T, struct answer *a)
{
  const struct motion at = motion_at(m, T);
  struct answer rounded;
  if (!answer_in_wide(a, &at, SCALLOP_BINARY128))
    return false;
  if (m->of == OF_STEADY && answer_in_double(&rounded, &at) && rounded.value[Q_DISPLACEMENT].high == 0)
    a->value[Q_DISPLACEMENT] = a->value[Q_MEAN_VELOCITY] = (struct scallop_wide){ 0, 0 };
  return true;
}

bool motion_has(const struct motion *m, enum quantity_id quantity)
{
  return quantity_rows[quantity].has_series && quantity_rows[quantity].of == m->of;
}

double motion_froude(const struct motion *s, double T)
{
  const struct scallop_crawler *c = &s->crawler;
  return (c->m1 + c->m2) / (c->F1 + c->F2) * c->L / T / T;
}

double motion_natural_time(const struct motion *s) { return sqrt(motion_froude(s, 1)); }

/* max |l''| of a phase of duration 1: l'' is monotone within a piece. Sets *jumps where l' jumps. */
static double most_acceleration(const struct scallop_shape *shape, bool *jumps)
{
  double most = 0;
  for (const struct scallop_piece *p = shape->pieces; p < shape->pieces + shape->count; p++) {
    most = fmax(most, fmax(fabs(p->curve->acceleration(p, p->begin)), fabs(p->curve->acceleration(p, p->end))));
    *jumps |= p->jump;
  }
  return most;
}

/* A body i that rests is held there while m_j |l''| + F_j <= F_i: for every T from sqrt(m_j max|l''| L/(F_i - F_j)) on,
 * l'' here being that of a phase of duration 1. With equal forces nothing depends on how they differ, and m_j |l''| is
 * to be compared with them. A start velocity is used up after |v0| M/(F1 + F2). Where l' jumps it throws the bodies
 * into motion; the velocity of the centre of mass comes to the level of one of them at the rate |F1 - F2|/M at least,
 * from as far as the fastest motions of both phases are apart. */
double motion_last_time(const struct motion *s)
{
  const struct scallop_crawler *c = &s->crawler;
  const struct scallop_shape *phase = c->gait->phase;
  bool jumps = false;
  double M = c->m1 + c->m2, difference = fmax(fabs(c->F1 - c->F2), 1e-12 * (c->F1 + c->F2));
  if (c->F1 == c->F2)
    difference = c->F1;
  double a = s->of == OF_STEADY ? c->alpha : 1, b = s->of == OF_STEADY ? 1 - c->alpha : 1;
  double most = fmax(most_acceleration(&phase[0], &jumps) / (a * a), most_acceleration(&phase[1], &jumps) / (b * b));
  double thrown = jumps ? (phase[0].peak / a + phase[1].peak / b) / fmin(a, b) : 0;
  double rest = sqrt(fmax(fmax(c->m1, c->m2) * most, M * thrown) * c->L / difference);
  double stop = s->of == OF_STEADY ? 0 : fabs(s->v0) * M / (c->F1 + c->F2);
  return 2 * fmax(rest, 16 * stop);
}

void expansions_init(struct expansions *e, const struct motion *motion, slong order, slong precision)
{
  *e = (struct expansions){ .motion = motion };
  scallop_rational_init(&e->crawler);
  fmpq_init(e->v0);
  series_answer_init(&e->derived);
  scallop_rational_of(&e->crawler, &motion->crawler);
  scallop_rational_set_double(e->v0, motion->v0);
  if (!answer_in_series(&e->derived, &e->crawler, motion->of, motion->phase, e->v0, order, precision)) {
    memset(e->derived.value, 0, sizeof e->derived.value);
    e->derived.modes = "";
  }
}

void expansions_clear(struct expansions *e)
{
  series_answer_clear(&e->derived);
  fmpq_clear(e->v0);
  scallop_rational_clear(&e->crawler);
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

int series_items(struct series_item items[MOST_ITEMS], const struct expansions *e, enum quantity_id quantity,
                 long order)
{
  const struct series *s = e->derived.value[quantity];
  const struct scallop_formula *f;
  int count = 0;
  for (int i = 0; (f = listed_formula(i)) && count < MOST_ITEMS - 2; i++)
    if (series_is_about(f, e->motion, quantity))
      items[count++] = (struct series_item){ book_formula(i) ? FROM_BOOK : FROM_PUBLISHED, quantity, f->name,
                                             .formula = f };
  if (s) {
    items[count++] = (struct series_item){ FROM_DERIVED, quantity, "derived", .series = s, .before = order };
    items[count++] = (struct series_item){ FROM_LIMIT, quantity, "limit", .series = s,
                                           .before = series_first_power(s) + 1 };
  }
  return count;
}

void series_item_value(arb_t value, const struct series_item *item, const struct expansions *e, double T,
                       slong precision)
{
  const struct motion *m = e->motion;
  const struct scallop_formula *f = item->formula;
  SCOPED(arb, x);
  SCOPED(fmpq, time);
  arb_set_d(x, T);
  if (!f) {
    series_value(value, item->series, x, item->before, precision);
    return;
  }
  /* where l'' = 0 at an end of a phase the paper's formulas divide by 0, whatever remains of them, and there is no
   * L_kin */
  bool divides = item->source == FROM_PUBLISHED || formula_takes(f, SCALLOP_SYMBOL_L_kin);
  scallop_rational_set_double(time, T);
  if ((divides && !gait_has_ends(m->crawler.gait))
      || !published_in_balls(value, f, &e->crawler, m->phase, e->v0, time, NULL, BREAKDOWN_BITS))
    arb_indeterminate(value);
  enum quantity_id own = quantity_of_formula(f, m->phase);
  if (own == Q_CHANGE && item->quantity == Q_V_END) {
    arb_set_fmpq(x, e->v0, BREAKDOWN_BITS);
    arb_add(value, value, x, BREAKDOWN_BITS);
  } else if (own == Q_DISPLACEMENT && item->quantity == Q_MEAN_VELOCITY)
    arb_div(value, value, x, BREAKDOWN_BITS);
}
