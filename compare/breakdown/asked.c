#include "compare/breakdown/asked.h"

#include <stdio.h>
#include <string.h>

enum { DOUBLE_DIGITS = 17 };
/* Errors are known to some 1e-32. */
static const double LEAST_TOLERANCE = 1e-20;

const char *breakdown_source_text(enum breakdown_source source)
{
  static const char *const text[] = { "published", "derived", "limit" };
  return text[source];
}

/* One of the names, or a complaint. */
static bool is_one_of(const char *option, const char *given, const char *const *names)
{
  char all[200] = "";
  size_t used = 0;
  for (const char *const *n = names; *n; n++) {
    if (!given || strcmp(given, *n) == 0)
      return true;
    used += (size_t)snprintf(all + used, sizeof all - used, "%s%s", n == names ? "" : n[1] ? ", " : " or ", *n);
  }
  complain("breakdown", "--%s: '%.40s' is not allowed here: it takes %s%s", option, given, all,
           did_you_mean(nearest(given, names)));
  return false;
}

bool breakdown_quantity_read(enum quantity_id *quantity, const char *name, enum quantity_of of)
{
  const char *names[QUANTITIES + 1] = { NULL };
  int n = 0;
  for (int q = 0; q < QUANTITIES; q++)
    if (quantity_rows[q].has_series && quantity_rows[q].of == of)
      names[n++] = quantity_rows[q].name;
  *quantity = quantity_of_name(name);
  return is_one_of("quantity", name, names);
}

bool breakdown_is_sound(const struct breakdown_options *o, enum quantity_of of)
{
  static const char *const kinds[] = { "event", "reach", "radius", "best", NULL };
  enum quantity_id quantity;
  if (!is_one_of("only", o->only, kinds) || (o->quantity && !breakdown_quantity_read(&quantity, o->quantity, of)))
    return false;
  bool not_derived = o->source.given && strcmp(o->source.value, "derived") != 0;
  if (o->order.given && not_derived) {
    complain("breakdown", "--order needs the derived series: leave --source out, or --source derived");
    return false;
  }
  bool reaches = !o->only || strcmp(o->only, "reach") == 0, events = !reaches && strcmp(o->only, "event") == 0;
  const char *idle = reaches                                      ? NULL
                     : o->tolerance.given                         ? "tol"
                     : o->quantity && events                      ? "quantity"
                     : not_derived || (o->source.given && events) ? "source"
                     : o->order.given                             ? "order"
                                                                  : NULL;
  if (idle) {
    complain("breakdown", "--%s has nothing to do with --only %s", idle, o->only);
    return false;
  }
  if (o->request.style.digits > DOUBLE_DIGITS) {
    complain("breakdown", "--digits: %ld is more than a double has: 1 to 17", o->request.style.digits);
    return false;
  }
  if (o->tolerance.given && o->tolerance.value < LEAST_TOLERANCE) {
    complain("breakdown", "--tol: %g is not allowed here: it takes a number from 1e-20 on", o->tolerance.value);
    return false;
  }
  return true;
}
