#include "compare/breakdown/motion.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *study_begin(struct study *s, const struct point *point, enum quantity_of of, slong order)
{
  struct scallop_scaled scaled;
  enum scallop_status status = scallop_scale(&point->crawler, &scaled);
  study_clear(s);
  s->motion = motion_of(point, of);
  s->cache = status == SCALLOP_OK ? exact_cache_new(&s->motion) : NULL;
  if (!s->cache)
    return status == SCALLOP_OK ? "out of memory" : scallop_status_text(status);
  expansions_init(&s->expansions, &s->motion, order, BREAKDOWN_BITS);
  return NULL;
}

void study_clear(struct study *s)
{
  events_clear(&s->events);
  if (s->many.motion)
    expansions_clear(&s->many);
  if (s->cache)
    expansions_clear(&s->expansions);
  free(s->cache);
  *s = (struct study){ .cache = NULL };
}

const struct events *study_events(struct study *s)
{
  if (s->events.until == 0)
    events_find(&s->events, &s->motion, s->expansions.derived.modes);
  return &s->events;
}

const struct series *study_many(struct study *s, enum quantity_id quantity)
{
  if (!s->many.motion)
    expansions_init(&s->many, &s->motion, STUDY_MANY, STUDY_MANY_BITS);
  return s->many.derived.value[quantity];
}

const char *study_why_none(const struct study *s)
{
  const struct series_answer *a = &s->expansions.derived;
  return a->why ? a->why : scallop_status_text(a->status);
}

const char *study_where(const struct study *s, double T)
{
  static char text[200];
  const struct event *e = s->events.event, *modes = e;
  if (s->events.count == 0 || T <= e->T)
    return "below the first event";
  while (modes < e + s->events.count - 1 && modes->of != CHANGE_OF_MODES)
    modes++;
  if (modes == e)
    snprintf(text, sizeof text,
             "above the first event, T = %.6g: from there on the series does not describe the motion", e->T);
  else
    snprintf(text, sizeof text,
             "above T = %.6g, where a body turns in another piece of the gait and the series is not exact any more; "
             "the modes change at T = %.6g",
             e->T, modes->T);
  return text;
}

struct best_order study_best_order(struct study *study, enum quantity_id quantity, double T, const arb_struct *exact)
{
  const struct series *s = study_many(study, quantity);
  struct best_order best = { .order = 0, .error = INFINITY };
  SCOPED(arb, x, time);
  arb_set_d(time, T);
  for (slong k = s && exact ? s->first : STUDY_MANY; k < STUDY_MANY; k++) {
    if (series_coefficient_is_zero(s, k))
      continue;
    series_value(x, s, time, k + 1, STUDY_MANY_BITS);
    arb_sub(x, x, exact, STUDY_MANY_BITS);
    if (!arb_is_zero(x)) /* 0/0 is no error */
      arb_div(x, x, exact, STUDY_MANY_BITS);
    double here = fabs(arf_get_d(arb_midref(x), ARF_RND_NEAR));
    best.gains_from_more = here < best.error;
    if (best.gains_from_more) {
      best.order = k + 1;
      best.error = here;
    }
  }
  return best;
}
