#include "compare/breakdown/study.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *study_begin(struct study *s, const struct point *point, enum quantity_of of, slong order, slong many)
{
  struct scallop_scaled scaled;
  enum scallop_status status = scallop_scale(&point->crawler, &scaled);
  *s = (struct study){ .motion = motion_of(point, of) };
  s->cache = status == SCALLOP_OK ? exact_cache_new(&s->motion) : NULL;
  if (!s->cache)
    return status == SCALLOP_OK ? "out of memory" : scallop_status_text(status);
  expansions_init(&s->expansions, &s->motion, order, BREAKDOWN_BITS);
  expansions_init(&s->many, &s->motion, many, STUDY_MANY_BITS);
  return NULL;
}

void study_events(struct study *s) { events_find(&s->events, &s->motion, expansions_modes(&s->expansions)); }

void study_clear(struct study *s)
{
  if (!s->cache)
    return;
  events_clear(&s->events);
  expansions_clear(&s->many);
  expansions_clear(&s->expansions);
  free(s->cache);
}

const char *study_why_none(const struct study *s)
{
  const struct series_answer *a = &s->expansions.derived;
  return a->why ? a->why : scallop_status_text(a->status);
}

const struct scallop_modes *study_modes_at(const struct study *s, double T)
{
  const struct scallop_modes *modes = s->events.first;
  for (long i = 0; i < s->events.count && s->events.event[i].T < T; i++)
    modes = s->events.event[i].modes;
  return modes;
}

const char *study_where(const struct study *s, double T)
{
  static char text[200];
  const struct event *e = s->events.event, *modes = e;
  if (s->events.count == 0 || T <= e->T)
    return "below the first event";
  while (modes < e + s->events.count - 1 && !modes->of_modes)
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

bool study_best_order(const struct study *study, enum quantity_id quantity, double T, const arb_struct *exact,
                      slong *order, double *error)
{
  const struct series *s = expansions_of(&study->many, quantity);
  *error = INFINITY;
  *order = 0;
  for (slong k = s->first; exact && k < STUDY_MANY; k++) {
    if (series_coefficient_is_zero(s, k))
      continue;
    struct comparison c = { &study->many, { FROM_DERIVED, quantity, .series = s, .before = k + 1 }, .tolerance = 0 };
    double here = fabs(comparison_error_beside(&c, T, exact, STUDY_MANY_BITS));
    if (here < *error) {
      *error = here;
      *order = k + 1;
    }
  }
  return isfinite(*error);
}

bool study_gains_from_more(const struct study *study, enum quantity_id quantity, slong order)
{
  const struct series *s = expansions_of(&study->many, quantity);
  slong last = STUDY_MANY - 1;
  while (last > 0 && series_coefficient_is_zero(s, last))
    last--;
  return order > last;
}
