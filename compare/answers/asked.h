/* What tables ask of points: quantities, and how well they have to be known. */
#ifndef SCALLOP_COMPARE_ANSWERS_ASKED_H
#define SCALLOP_COMPARE_ANSWERS_ASKED_H

#include "compare/answers/quantities.h"

enum { DIGITS_OF_DOUBLE = 17, MOST_CERTIFIED_DIGITS = 10000 };

/* What is known before the first point */
struct asked {
  const char *command;   /* for messages */
  bool from_steady;      /* a phase without a v0 starts with the velocity of the steady state; else from rest */
  bool tells_no_start;   /* the column v0 is nan where no v0 is given */
  bool certified_errors; /* else errors are those against the double solver */
  double accuracy; /* of errors: below this part of the exact value they are 0; 0: they are as doubles have them */
  long digits;     /* of certified values: the most that are wanted */
  struct quantities quantities;
};
/* Errors against doubles are told down to this part of the exact value. */
#define ACCURACY_OF_DOUBLES 1e-10
/* With no quantities yet; NULL: no memory. */
struct asked *asked_nothing(const char *command);
void asked_free(struct asked *asked);
/* What needs FLINT: the name of the first of these quantities, or NULL. */
const char *asked_needs_flint(const struct asked *asked);
/* Are errors those against certified values? */
bool asked_certifies_errors(const struct asked *asked);

#endif
