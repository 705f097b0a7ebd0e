#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/asked.h"

struct asked *asked_nothing(const char *command)
{
  struct asked *asked = malloc(sizeof *asked);
  if (asked) {
    memset(asked, 0, offsetof(struct asked, quantities.item));
    asked->command = command;
    asked->accuracy = ACCURACY_OF_DOUBLES;
    asked->digits = DIGITS_OF_DOUBLE;
  }
  return asked;
}

void asked_free(struct asked *asked)
{
  if (asked)
    quantities_free(&asked->quantities);
  free(asked);
}

/* A change of velocity in doubles is a small difference of large numbers, and has not the digits that errors are told
 * to. */
bool asked_certifies_errors(const struct asked *asked)
{
  bool certifies = false, has = false;
  for (const struct quantity *q = asked->quantities.item; q < asked->quantities.item + asked->quantities.count; q++) {
    has |= q->is_compared;
    certifies |= q->is_compared && q->formula && q->formula->quantity == SCALLOP_VELOCITY_CHANGE && asked->accuracy > 0;
  }
  return certifies || (has && asked->certified_errors);
}

const char *asked_needs_flint(const struct asked *asked)
{
  bool certifies = asked_certifies_errors(asked);
  for (const struct quantity *q = asked->quantities.item; q < asked->quantities.item + asked->quantities.count; q++)
    if (q->kind == QUANTITY_CERTIFIED || q->kind == QUANTITY_DERIVED || q->kind == QUANTITY_LIMIT
        || q->kind == QUANTITY_STUDIED || q->kind == QUANTITY_STUDIED_TEXT || (certifies && q->of >= 0))
      return q->name;
  return NULL;
}
