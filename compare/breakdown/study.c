/* Study of one motion, and the series of its quantities. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/formulas/formula_file.h"
#include "compare/breakdown/motion.h"
#include "compare/points/gaits.h"

#define PARTS(of) \
  of(scallop_rational, &s->crawler) of(fmpq, s->v0) of(series_answer, &s->derived) of(series_answer, &s->many) \
      of(scallop_singularity, &s->singularity)

static void expand(struct series_answer *a, const struct study *s, slong order, slong precision)
{
  if (!answer_in_series(a, &s->crawler, s->motion.of, s->motion.phase, s->v0, order, precision)) {
    memset(a->value, 0, sizeof a->value);
    a->modes = "";
  }
}

const char *study_begin(struct study *s, const struct motion *motion, slong order)
{
  struct scallop_scaled scaled;
  enum scallop_status status = scallop_scale(&motion->crawler, &scaled);
  study_clear(s);
  s->motion = *motion;
  s->places = status == SCALLOP_OK ? calloc(STUDY_PLACES, sizeof *s->places) : NULL;
  if (!s->places)
    return status == SCALLOP_OK ? "out of memory" : scallop_status_text(status);
  PARTS(SCOPED_INIT)
  scallop_rational_of(&s->crawler, &motion->crawler);
  scallop_rational_set_double(s->v0, motion->v0);
  expand(&s->derived, s, order, BREAKDOWN_BITS);
  return NULL;
}

void study_clear(struct study *s)
{
  if (s->places) {
    PARTS(SCOPED_CLEAR)
  }
  transitions_clear(&s->transitions);
  free(s->places);
  *s = (struct study){ .places = NULL };
}

const struct transitions *study_transitions(struct study *s)
{
  if (s->transitions.until == 0)
    transitions_find(&s->transitions, &s->motion, s->derived.modes);
  return &s->transitions;
}

const struct series *study_many(struct study *s, enum quantity_id quantity)
{
  if (!s->many.modes)
    expand(&s->many, s, STUDY_MANY, STUDY_MANY_BITS);
  return s->many.value[quantity];
}

const char *study_no_series_text(const struct study *s)
{
  return s->derived.why ? s->derived.why : scallop_status_text(s->derived.status);
}

const char *study_position_text(const struct study *s, double T)
{
  const struct transition *e = s->transitions.transition, *modes = e;
  if (s->transitions.count == 0 || T <= e->T)
    return "below the first transition";
  while (modes < e + s->transitions.count - 1 && modes->of != CHANGE_OF_MODES)
    modes++;
  if (modes == e)
    return wrong_text("above the first transition, T = %.6g: from there on the series does not describe the motion",
                      e->T);
  return wrong_text("above T = %.6g, where a body turns in another piece of the gait and the series is not exact any "
                    "more; the modes change at T = %.6g",
                    e->T, modes->T);
}

/* Series */

bool breakdown_takes(const struct breakdown_options *o, enum breakdown_source source)
{
  static const char *const names[] = { "user", "published", "derived", "limit" };
  return !o->source.given || strcmp(o->source.value, names[source]) == 0;
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
  while (user_formula(i) && user_formula(i) != f)
    i++;
  return (struct series_item){ user_formula(i) ? FROM_USER : FROM_PUBLISHED, quantity, f, 0 };
}

const char *series_name(const struct series_item *item)
{
  return item->formula ? item->formula->name : item->source == FROM_DERIVED ? "derived" : "limit";
}

int series_items(struct series_item items[MAX_ITEMS], const struct study *study, enum quantity_id quantity, slong order)
{
  const struct scallop_formula *f;
  int count = 0;
  for (int i = 0; (f = listed_formula(i)) && count < MAX_ITEMS - 2; i++)
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
  /* if l'' = 0 at an end of a phase, the paper's formulas divide by 0 and have no value, and L_kin does not exist */
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

struct best_order study_best_order(struct study *study, enum quantity_id quantity, double T)
{
  enum { DIGITS = 200 };
  const struct motion at = motion_at(&study->motion, T);
  const struct series *s = study_many(study, quantity);
  struct best_order best = { .order = 0, .error = INFINITY };
  SCOPED(arb, x, time);
  SCOPED(ball_answer, exact);
  if (!s || !answer_of_doubles(&exact, &at, DIGITS) || !exact.value[quantity])
    return best;
  arb_set_d(time, T);
  for (slong k = s->first; k < STUDY_MANY; k++) {
    if (series_coefficient_is_zero(s, k))
      continue;
    series_value(x, s, time, k + 1, STUDY_MANY_BITS);
    relative_error(x, exact.value[quantity], STUDY_MANY_BITS);
    double here = fabs(arf_get_d(arb_midref(x), ARF_RND_NEAR));
    best.gains_from_more = here < best.error;
    if (best.gains_from_more) {
      best.order = k + 1;
      best.error = here;
    }
  }
  return best;
}
