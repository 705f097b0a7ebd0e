#include "compare/maps/axis.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/command/compare.h"

enum { MOST_COUNT = 100000, RANGE_TEXT = 160 };

static const char *const names[] = { "F1/F2", "m1/m2", "alpha", "T", "froude", NULL };

const char *axis_name(enum axis_kind kind) { return names[kind]; }

static char message[400];

/* ---- reading ---- */

/* The next part of the text, up to a colon, which becomes a NUL. NULL: there is none. */
static char *part(char **text)
{
  char *begin = *text, *colon = begin ? strchr(begin, ':') : NULL;
  if (colon)
    *colon = '\0';
  *text = colon ? colon + 1 : NULL;
  return begin;
}

static bool read_spacing(const char *text, bool *log)
{
  *log = strcmp(text, "log") == 0;
  return *log || strcmp(text, "linear") == 0;
}

static bool read_many(const char *text, long *count)
{
  char *end;
  long n = strtol(text, &end, 10);
  *count = n;
  return *text >= '0' && *text <= '9' && *end == '\0' && n >= 1 && n <= MOST_COUNT;
}

static const char *wrong_range(const char *range, const char *why)
{
  snprintf(message, sizeof message,
           "'%.100s' is not allowed here: it takes FROM:TO:COUNT, and :log or :linear after it if that is to be said; %s",
           range, why);
  return message;
}

static const char *check_ends(const struct axis *a, const char *range)
{
  if (!(a->from > 0) || !(a->to > 0))
    return wrong_range(range, "FROM and TO are > 0");
  if (a->kind == AXIS_ALPHA && (a->from >= 1 || a->to >= 1))
    return wrong_range(range, "alpha lies between 0 and 1, both excluded");
  if (a->count == 1 ? a->from != a->to : !(a->from < a->to))
    return wrong_range(range, a->count == 1 ? "FROM = TO where COUNT is 1" : "FROM < TO where COUNT is 2 or more");
  if (!isfinite(a->to / a->from))
    return wrong_range(range, "TO/FROM is no more than 1.8e308");
  return NULL;
}

static const char *read_range(struct axis *a, const char *range)
{
  char copy[RANGE_TEXT], *rest = copy;
  if (strlen(range) >= sizeof copy)
    return wrong_range(range, "this one is too long");
  memcpy(copy, range, strlen(range) + 1);
  const char *from = part(&rest), *to = part(&rest), *count = part(&rest), *spacing = part(&rest);
  if (!count || rest)
    return wrong_range(range, "this one has not three or four parts");
  if (!read_number(from, &a->from) || !read_number(to, &a->to))
    return wrong_range(range, "FROM and TO are finite numbers > 0");
  if (!read_many(count, &a->count))
    return wrong_range(range, "COUNT is a whole number from 1 to 100000");
  if (spacing && !read_spacing(spacing, &a->log))
    return wrong_range(range, "values are spaced log or linear");
  return check_ends(a, range);
}

const char *axis_read(struct axis *axis, const char *name, const char *range)
{
  int kind = 0;
  while (names[kind] && strcmp(name, names[kind]) != 0)
    kind++;
  if (!names[kind]) {
    const char *near = nearest(name, names);
    snprintf(message, sizeof message, "'%.80s' is not allowed here: it takes F1/F2, m1/m2, alpha, T or froude%s%s%s", name,
             near ? ": did you mean '" : "", near ? near : "", near ? "'?" : "");
    return message;
  }
  struct axis a = { .kind = (enum axis_kind)kind, .log = kind != AXIS_ALPHA };
  const char *wrong = read_range(&a, range ? range : kind == AXIS_ALPHA ? AXIS_ALPHA_RANGE : AXIS_RANGE);
  if (!wrong)
    *axis = a;
  return wrong;
}

const char *axis_sets(enum axis_kind kind)
{
  static const char *const parameters[] = { "F1", "m1", "alpha", "T", "T" };
  return parameters[kind];
}

static bool go_together(const struct axis axes[2], const struct options *o)
{
  if (strcmp(axis_sets(axes[0].kind), axis_sets(axes[1].kind)) == 0) {
    complain(o->command->name, "--map %s %s: %s", o->map[0], o->map[1],
             axes[0].kind == axes[1].kind ? "a map needs two different axes"
                                          : "T and froude set the same; a map needs two that can vary apart");
    return false;
  }
  for (int i = 0; i < 2; i++)
    if (o->point.written[crawler_place(axis_sets(axes[i].kind))]) {
      complain(o->command->name, "--%s has nothing to do with --map %s %s, where %s sets it", axis_sets(axes[i].kind),
               o->map[0], o->map[1], o->map[i]);
      return false;
    }
  return true;
}

bool axes_read(struct axis axes[2], const struct options *o)
{
  for (int i = 0; i < 2; i++) {
    struct axis named;
    const char *wrong = axis_read(&named, o->map[i], NULL), *option = "map";
    if (!wrong) {
      wrong = axis_read(&axes[i], o->map[i], o->range[i]);
      option = i == 0 ? "x" : "y";
    }
    if (wrong) {
      complain(o->command->name, "--%s: %s", option, wrong);
      return false;
    }
  }
  return go_together(axes, o);
}

/* ---- values ---- */

double axis_value(const struct axis *a, double u)
{
  if (u == 0 || u == 1)
    return u == 0 ? a->from : a->to;
  return a->log ? a->from * pow(a->to / a->from, u) : a->from + u * (a->to - a->from);
}

double axis_node(const struct axis *a, long i)
{
  return axis_value(a, a->count == 1 ? 0 : (double)i / (double)(a->count - 1));
}

double axis_scale(const struct axis *a) { return a->log ? log(a->to / a->from) : (a->to - a->from) / a->to; }

static void set(const struct axis *a, double value, struct scallop_crawler *c)
{
  if (a->kind == AXIS_F1_F2)
    c->F1 = value * c->F2;
  else if (a->kind == AXIS_M1_M2)
    c->m1 = value * c->m2;
  else if (a->kind == AXIS_ALPHA)
    c->alpha = value;
  else if (a->kind == AXIS_T)
    c->T = value;
}

struct scallop_crawler axes_crawler(const struct axis axes[2], const struct scallop_crawler *base, double x, double y)
{
  struct scallop_crawler c = *base;
  const double value[2] = { x, y };
  for (int i = 0; i < 2; i++)
    set(&axes[i], value[i], &c);
  for (int i = 0; i < 2; i++)
    if (axes[i].kind == AXIS_FROUDE)
      c.T = sqrt((c.m1 + c.m2) * c.L / ((c.F1 + c.F2) * value[i]));
  return c;
}
