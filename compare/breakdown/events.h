/* What ends the expansion: where the sequence of modes changes as T grows, and where a body turns in another piece of
 * the gait. And what does not end it: where the crawler turns back. */
#ifndef SCALLOP_COMPARE_BREAKDOWN_EVENTS_H
#define SCALLOP_COMPARE_BREAKDOWN_EVENTS_H

#include "compare/answers/mode_change.h"

enum { EVENT_TEXT = MODE_CHANGE_TEXT };

struct event {
  double T;
  bool of_modes; /* else a body turns in another piece, in the same modes                             */
  char what[EVENT_TEXT];
  struct scallop_modes modes[2]; /* from here on                                                      */
  const char *status;            /* how it is known: certified, binary128 or double                   */
};
/* The displacement in a period changes its sign: from here on it has this one. */
struct reversal {
  double T;
  int sign;
  const char *status;
};
struct events {
  struct scallop_modes first[2]; /* the modes below the first event                                   */
  double from, until;            /* searched: this range of T                                         */
  long count;
  struct event *event;
  long reversals; /* of a steady state */
  struct reversal *reversal;
};
/* limit_modes: those for T -> 0, or "" where they are not known. */
void events_find(struct events *events, const struct motion *motion, const char *limit_modes);
void events_clear(struct events *events);

#endif
