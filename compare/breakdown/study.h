/* What is known of one motion as a function of T: its series, its events, and how well the series do. */
#ifndef SCALLOP_COMPARE_BREAKDOWN_STUDY_H
#define SCALLOP_COMPARE_BREAKDOWN_STUDY_H

#include "compare/breakdown/events.h"
#include "compare/breakdown/reach.h"

/* Terms below T^STUDY_MANY tell the best order, and where the poles of a rational function are. */
enum { STUDY_MANY = 96, STUDY_MANY_BITS = 1024 };

struct study {
  struct motion motion;
  struct expansions expansions, many;
  struct events events;
  struct exact_cache *cache;
};

/* order: of the derived series below T^order, and `many` terms of them. The point must outlive the study. NULL, or what
 * is wrong with the crawler; a study has to be cleared in either case. */
const char *study_begin(struct study *study, const struct point *point, enum quantity_of of, slong order, slong many);
/* The events, and the modes between them: takes a quarter of a second. */
void study_events(struct study *study);
void study_clear(struct study *study);

/* Why there is no derived series. */
const char *study_why_none(const struct study *study);

/* The modes at T. */
const struct scallop_modes *study_modes_at(const struct study *study, double T);
/* Whether the expansion is about the motion at T, in words; until the next call. */
const char *study_where(const struct study *study, double T);
/* The order of truncation with the least |error| at T, of those below `many`, beside the exact value there; *error:
 * that. False: there is none. */
bool study_best_order(const struct study *study, enum quantity_id quantity, double T, const arb_struct *exact,
                      slong *order, double *error);
/* Is that order all the terms that there are, so that more might be better still? */
bool study_gains_from_more(const struct study *study, enum quantity_id quantity, slong order);

#endif
