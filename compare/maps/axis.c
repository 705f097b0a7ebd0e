#include "compare/maps/maps.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MOST_COUNT = 100000, RANGE_TEXT = 160 };

static const char *const names[] = { "F1/F2", "m1/m2", "alpha", "T", "froude", NULL };
static const char *const in_scenes[] = { "F1_over_F2", "m1_over_m2", "alpha", "T",
                                         "froude" }; /* the same names there */
static const char *const parameters[] = { "F1", "m1", "alpha", "T", "T" };

/* The next part of the text, up to a colon, which becomes a NUL. NULL: there is none. */
static char *part(char **text)
{
  char *begin = *text, *colon = begin ? strchr(begin, ':') : NULL;
  if (colon)
    *colon = '\0';
  *text = colon ? colon + 1 : NULL;
  return begin;
}

/* NULL, or what is wrong with the range, whose colons are overwritten. */
static const char *read_range(struct axis *a, char *rest)
{
  const char *from = part(&rest), *to = part(&rest), *count = part(&rest), *spacing = part(&rest);
  if (!count || rest)
    return "this one has not three or four parts";
  if (!read_number(from, &a->from) || !read_number(to, &a->to) || !(a->from > 0) || !(a->to > 0))
    return "FROM and TO are finite numbers > 0";
  if (!read_count(count, 1, MOST_COUNT, &a->count))
    return "COUNT is a whole number from 1 to 100000";
  if (spacing && strcmp(spacing, "log") != 0 && strcmp(spacing, "linear") != 0)
    return "values are spaced log or linear";
  a->log = spacing ? strcmp(spacing, "log") == 0 : a->log;
  if (a->kind == AXIS_ALPHA && (a->from >= 1 || a->to >= 1))
    return "alpha lies between 0 and 1, both excluded";
  if (a->count == 1 ? a->from != a->to : !(a->from < a->to))
    return a->count == 1 ? "FROM = TO where COUNT is 1" : "FROM < TO where COUNT is 2 or more";
  return isfinite(a->to / a->from) ? NULL : "TO/FROM is no more than 1.8e308";
}

const char *axis_read(struct axis *axis, const char *name, const char *range)
{
  char copy[RANGE_TEXT], takes[2 * RANGE_TEXT];
  int kind = 0;
  while (names[kind] && strcmp(name, names[kind]) != 0 && strcmp(name, in_scenes[kind]) != 0)
    kind++;
  if (!names[kind]) {
    snprintf(takes, sizeof takes, "F1/F2, m1/m2, alpha, T or froude%s", did_you_mean(nearest(name, names)));
    return not_allowed(name, takes);
  }
  struct axis a = { (enum axis_kind)kind, names[kind], parameters[kind], .log = kind != AXIS_ALPHA };
  if (!range)
    range = kind == AXIS_ALPHA ? AXIS_ALPHA_RANGE : AXIS_RANGE;
  bool fits = (size_t)snprintf(copy, sizeof copy, "%s", range) < sizeof copy;
  const char *wrong = fits ? read_range(&a, copy) : "this one is too long";
  if (wrong) {
    snprintf(takes, sizeof takes, "FROM:TO:COUNT, FROM:TO:COUNT:log or FROM:TO:COUNT:linear; %s", wrong);
    return not_allowed(range, takes);
  }
  *axis = a;
  return NULL;
}

bool axes_read(struct axis axes[2], const char *const given[2], const char *const ranges[2], const struct point *point)
{
  for (int i = 0; i < 2; i++) {
    bool named = !axis_read(&axes[i], given[i], NULL);
    const char *wrong = axis_read(&axes[i], given[i], ranges[i]);
    if (wrong) {
      complain("breakdown", "--%s: %s", !named ? "map" : i == 0 ? "x" : "y", wrong);
      return false;
    }
  }
  if (strcmp(axes[0].sets, axes[1].sets) == 0) {
    complain("breakdown", "--map %s %s: %s", given[0], given[1],
             axes[0].kind == axes[1].kind ? "a map needs two different axes"
                                          : "T and froude set the same; a map needs two that can vary apart");
    return false;
  }
  for (int i = 0; i < 2; i++)
    if (point->written[crawler_place(axes[i].sets)]) {
      complain("breakdown", "--%s has nothing to do with --map %s %s, where %s sets it", axes[i].sets, given[0],
               given[1], given[i]);
      return false;
    }
  return true;
}

void axes_head(struct table *t, const struct breakdown_options *o, const struct axis axes[2], const char *about)
{
  table_command(t, "breakdown --map %s %s%s", o->map[0], o->map[1], about);
  if (o->request.book)
    table_note(t, "book: %s", o->request.book);
  for (int i = 0; i < 2; i++) {
    const struct axis *a = &axes[i];
    char from[NUMBER_TEXT], to[NUMBER_TEXT];
    number_text(from, a->from, 0);
    number_text(to, a->to, 0);
    table_note(t, "%c: %s from %s to %s, %ld values, %s", "xy"[i], a -> name, from, to, a -> count,
               a -> log ? "log" : "linear");
  }
  note_parameters(t, &o->request.point, (const char *const[]){ axes[0].sets, axes[1].sets, NULL }, false);
}

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

struct scallop_crawler axes_crawler(const struct axis axes[2], const struct scallop_crawler *base, double x, double y)
{
  struct scallop_crawler c = *base;
  double froude = 0, *const set[AXIS_KINDS] = { &c.F1, &c.m1, &c.alpha, &c.T, &froude };
  const double unit[AXIS_KINDS] = { c.F2, c.m2, 1, 1, 1 };
  *set[axes[0].kind] = x * unit[axes[0].kind];
  *set[axes[1].kind] = y * unit[axes[1].kind];
  if (froude > 0)
    c.T = sqrt((c.m1 + c.m2) * c.L / ((c.F1 + c.F2) * froude));
  return c;
}
