/* What the command line asks of breakdown. */
#include <stdio.h>
#include <string.h>

#include "compare/breakdown/breakdown.h"

const char *const breakdown_sources[BREAKDOWN_SOURCES] = { "book", "published", "derived", "limit" };

static bool is_source(const struct breakdown_options *o, enum breakdown_source source)
{
  return strcmp(o->source.value, breakdown_sources[source]) == 0;
}

/* The option that has no effect on the rows of --only, or NULL */
static const char *idle_with_only(const struct breakdown_options *o)
{
  bool events = strcmp(o->only.value, "event") == 0 || strcmp(o->only.value, "reversal") == 0,
       of_derived = !o->source.given || is_source(o, FROM_DERIVED);
  return strcmp(o->only.value, "reach") == 0          ? NULL
         : o->tolerance.given                         ? "tol"
         : o->request.book                            ? "book"
         : o->quantity && events                      ? "quantity"
         : !of_derived || (o->source.given && events) ? "source"
         : o->order.given                             ? "order"
                                                      : NULL;
}

bool breakdown_is_sound(const struct breakdown_options *o)
{
  static const double least_tolerance = 1e-20; /* errors are known to some 1e-32 */
  const char *idle = o->only.given ? idle_with_only(o) : NULL;
  bool of_book = o->source.given && is_source(o, FROM_BOOK);
  if (o->order.given && o->source.given && !is_source(o, FROM_DERIVED))
    complain("breakdown", "--order needs the derived series: leave --source out, or --source derived");
  else if (idle)
    complain("breakdown", "--%s has nothing to do with --only %s", idle, o->only.value);
  else if (o->request.book && o->source.given && !of_book)
    complain("breakdown", "--book has nothing to do with --source %s: leave --source out, or --source book",
             o->source.value);
  else if (of_book && !o->request.book)
    complain("breakdown", "--source book needs --book FILE");
  else if (o->tolerance.given && o->tolerance.value < least_tolerance)
    complain("breakdown", "--tol: %g is not allowed here: it takes a number from 1e-20 on", o->tolerance.value);
  else
    return true;
  return false;
}

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
