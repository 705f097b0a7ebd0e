#include "compare/breakdown/motion.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PARTS(of) \
  of(scallop_rational, &s->crawler) of(fmpq, s->v0) of(series_answer, &s->derived) of(series_answer, &s->many)

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
  s->cache = status == SCALLOP_OK ? exact_cache_new(motion) : NULL;
  if (!s->cache)
    return status == SCALLOP_OK ? "out of memory" : scallop_status_text(status);
  PARTS(SCOPED_INIT)
  scallop_rational_of(&s->crawler, &motion->crawler);
  scallop_rational_set_double(s->v0, motion->v0);
  expand(&s->derived, s, order, BREAKDOWN_BITS);
  return NULL;
}

void study_clear(struct study *s)
{
  if (s->cache) {
    PARTS(SCOPED_CLEAR)
  }
  events_clear(&s->events);
  free(s->cache);
  *s = (struct study){ .cache = NULL };
}

const struct events *study_events(struct study *s)
{
  if (s->events.until == 0)
    events_find(&s->events, &s->motion, s->derived.modes);
  return &s->events;
}

const struct series *study_many(struct study *s, enum quantity_id quantity)
{
  if (!s->many.modes) /* not yet */
    expand(&s->many, s, STUDY_MANY, STUDY_MANY_BITS);
  return s->many.value[quantity];
}

const char *study_why_none(const struct study *s)
{
  return s->derived.why ? s->derived.why : scallop_status_text(s->derived.status);
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
