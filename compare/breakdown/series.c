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

struct series_item series_of_formula(const struct scallop_formula *f, enum quantity_id quantity)
{
  int i = 0;
  while (book_formula(i) && book_formula(i) != f)
    i++;
  return (struct series_item){ book_formula(i) ? FROM_BOOK : FROM_PUBLISHED, quantity, f, 0 };
}

const char *series_name(const struct series_item *item)
{
  return item->formula ? item->formula->name : item->source == FROM_DERIVED ? "derived" : "limit";
}

int series_items(struct series_item items[MOST_ITEMS], const struct study *study, enum quantity_id quantity,
                 slong order)
{
  const struct scallop_formula *f;
  int count = 0;
  for (int i = 0; (f = listed_formula(i)) && count < MOST_ITEMS - 2; i++)
    if (series_is_about(f, &study->motion, quantity))
      items[count++] = series_of_formula(f, quantity);
  if (study->derived.value[quantity]) {
    items[count++] = (struct series_item){ FROM_DERIVED, quantity, NULL, order };
    items[count++] = (struct series_item){ FROM_LIMIT, quantity, NULL, 0 };
  }
  return count;
}

void series_item_value(arb_t value, const struct series_item *item, const struct study *study, double T)
{
  const struct motion *m = &study->motion;
  const struct series *s = study->derived.value[item->quantity];
  const struct scallop_formula *f = item->formula;
  SCOPED(arb, x);
  SCOPED(fmpq, time);
  arb_set_d(x, T);
  if (!f) {
    series_value(value, s, x, item->source == FROM_LIMIT ? series_first_power(s) + 1 : item->before, BREAKDOWN_BITS);
    return;
  }
  /* where l'' = 0 at an end of a phase the paper's formulas divide by 0, whatever remains of them, and there is no
   * L_kin */
  bool divides = item->source == FROM_PUBLISHED || formula_takes(f, SCALLOP_SYMBOL_L_kin);
  scallop_rational_set_double(time, T);
  if ((divides && !gait_has_ends(m->crawler.gait))
      || !published_in_balls(value, f, &study->crawler, m->phase, study->v0, time, NULL, BREAKDOWN_BITS))
    arb_indeterminate(value);
  enum quantity_id own = quantity_of_formula(f, m->phase);
  if (own == Q_CHANGE && item->quantity == Q_V_END) {
    arb_set_fmpq(x, study->v0, BREAKDOWN_BITS);
    arb_add(value, value, x, BREAKDOWN_BITS);
  } else if (own == Q_DISPLACEMENT && item->quantity == Q_MEAN_VELOCITY)
    arb_div(value, value, x, BREAKDOWN_BITS);
}

void relative_error(arb_t x, const arb_t exact, slong precision)
{
  arb_sub(x, x, exact, precision);
  if (!arb_is_zero(x))
    arb_div(x, x, exact, precision);
}
