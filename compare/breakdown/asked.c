/* What the command line asks of breakdown. */
#include <stdio.h>
#include <string.h>

#include "compare/breakdown/breakdown.h"

const char *const breakdown_sources[BREAKDOWN_SOURCES] = { "published", "derived", "limit" };

bool breakdown_takes(const struct breakdown_options *o, enum breakdown_source source)
{
  return !o->source.given || strcmp(o->source.value, breakdown_sources[source]) == 0;
}

bool breakdown_quantity(enum quantity_id *quantity, const struct breakdown_options *o, enum quantity_of of)
{
  const char *names[QUANTITIES + 1] = { NULL };
  char all[200] = "";
  int n = 0;
  if (!o->quantity)
    return true;
  *quantity = quantity_of_name(o->quantity);
  for (int q = 0; q < QUANTITIES; q++)
    if (quantity_rows[q].has_series && quantity_rows[q].of == of) {
      if (q == (int)*quantity)
        return true;
      names[n++] = quantity_rows[q].name;
    }
  for (int i = 0; i < n; i++)
    snprintf(all + strlen(all), sizeof all - strlen(all), "%s%s", i == 0 ? "" : i == n - 1 ? " or " : ", ", names[i]);
  complain("breakdown", "--quantity: '%.40s' is not allowed here: it takes %s%s", o->quantity, all,
           did_you_mean(nearest(o->quantity, names)));
  return false;
}
