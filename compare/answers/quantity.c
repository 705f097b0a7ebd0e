#include "compare/answers/quantity.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/point.h"
#include "compare/text/message.h"

enum { MOST_ORDER = 1000, CANDIDATES = 160 };

static const char *const sample_names[] = { "t", "x1", "x2", "xC", "v1", "v2", "l", NULL };
static const struct {
  const char *name;
  enum quantity_kind kind;
  int which;
} single[] = { { "v0", QUANTITY_V0, 0 },
               { "froude", QUANTITY_FROUDE, 0 },
               { "gait", QUANTITY_GAIT, 0 },
               { "status", QUANTITY_STATUS, 0 },
               { "sticking_onset", QUANTITY_ONSET, 0 },
               { "phase", QUANTITY_PHASE_NAME, 0 },
               { "F1_over_F2", QUANTITY_F1_OVER_F2, 0 },
               { "m1_over_m2", QUANTITY_M1_OVER_M2, 0 },
               { "regime", QUANTITY_REGIME, OF_STEADY },
               { "modes", QUANTITY_MODES, OF_STEADY },
               { "phase_regime", QUANTITY_REGIME, OF_PHASE },
               { "phase_modes", QUANTITY_MODES, OF_PHASE } };
enum { SINGLE = sizeof single / sizeof *single };

static const struct {
  const char *prefix;
  enum quantity_kind kind;
} of_series[] = { { "exact.", QUANTITY_EXACT }, { "error.", QUANTITY_ERROR }, { "relative.", QUANTITY_RELATIVE } };
enum { OF_SERIES = sizeof of_series / sizeof *of_series };

static int place_in(const char *const *names, int count, const char *name)
{
  for (int i = 0; i < count; i++)
    if (strcmp(names[i], name) == 0)
      return i;
  return -1;
}

static const struct scallop_formula *formula_named(const char *name)
{
  for (const struct scallop_formula *f = scallop_published; f->name; f++)
    if (strcmp(f->name, name) == 0)
      return f;
  return NULL;
}

/* derived_N.VALUE or limit.VALUE */
static bool derived_named(struct quantity *q, const char *name)
{
  const char *dot = strchr(name, '.');
  if (!dot)
    return false;
  q->which = (int)quantity_of_name(dot + 1);
  if (q->which == NAMED_QUANTITIES || !quantity_rows[q->which].has_series)
    return false;
  if (strncmp(name, "limit.", 6) == 0) {
    q->kind = QUANTITY_LIMIT;
    return true;
  }
  char *end;
  q->kind = QUANTITY_DERIVED;
  if (strncmp(name, "derived_", 8) != 0 || name[8] < '1' || name[8] > '9')
    return false;
  q->order = strtol(name + 8, &end, 10);
  return end == dot && q->order <= MOST_ORDER;
}

static bool series_named(struct quantity *q, const char *name)
{
  q->formula = formula_named(name);
  q->kind = QUANTITY_PUBLISHED;
  return q->formula || derived_named(q, name);
}

/* The quantity of that name, but for those that are about a series. */
static bool plain_named(struct quantity *q, const struct quantities *all, const char *name)
{
  const struct {
    enum quantity_kind kind;
    int place;
  } lists[] = { { QUANTITY_NUMBER, place_in(crawler_parameters, CRAWLER_NUMBERS, name) },
                { QUANTITY_LABEL, place_in(all->label, all->labels, name) },
                { QUANTITY_SAMPLE, place_in(sample_names, SAMPLE_VALUES, name) } };
  for (size_t i = 0; i < sizeof lists / sizeof *lists; i++)
    if (lists[i].place >= 0) {
      q->kind = lists[i].kind;
      q->which = lists[i].place;
      return true;
    }
  for (int i = 0; i < SINGLE; i++)
    if (strcmp(name, single[i].name) == 0) {
      q->kind = single[i].kind;
      q->which = single[i].which;
      return true;
    }
  q->which = (int)quantity_of_name(name);
  q->kind = QUANTITY_ANSWER;
  if (q->which < NAMED_QUANTITIES)
    return true;
  if (strncmp(name, "certified.", 10) == 0) {
    q->kind = QUANTITY_CERTIFIED;
    q->which = (int)quantity_of_name(name + 10);
    return q->which < NAMED_QUANTITIES;
  }
  return series_named(q, name);
}

static int add(struct quantities *all, const struct quantity *q)
{
  if (all->count == MOST_QUANTITIES)
    return -2;
  all->item[all->count] = *q;
  return all->count++;
}

int quantity_find(const struct quantities *all, const char *name)
{
  for (int i = 0; i < all->count; i++)
    if (strcmp(all->item[i].name, name) == 0)
      return i;
  return -1;
}

int quantity_named(struct quantities *all, const char *name)
{
  struct quantity q = { .of = -1 };
  int known = quantity_find(all, name);
  if (known >= 0)
    return known;
  if (strlen(name) >= QUANTITY_NAME)
    return -1;
  snprintf(q.name, sizeof q.name, "%s", name);
  for (int i = 0; i < OF_SERIES; i++) {
    size_t length = strlen(of_series[i].prefix);
    struct quantity series = { .of = -1 };
    if (strncmp(name, of_series[i].prefix, length) != 0)
      continue;
    if (!series_named(&series, name + length))
      return -1;
    q.kind = of_series[i].kind;
    q.of = quantity_named(all, name + length);
    return q.of < 0 ? q.of : add(all, &q);
  }
  return plain_named(&q, all, name) ? add(all, &q) : -1;
}

/* The part of a name after the last prefix, which is what is mistyped most often */
static const char *stem(const char *name)
{
  const char *dot = strrchr(name, '.');
  return dot ? dot + 1 : name;
}

const char *quantity_near(const struct quantities *all, const char *name)
{
  const char *names[CANDIDATES];
  int n = 0;
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    names[n++] = crawler_parameters[i];
  for (int i = 0; i < SINGLE; i++)
    names[n++] = single[i].name;
  for (int i = 0; i < all->labels; i++)
    names[n++] = all->label[i];
  for (int i = 0; i < NAMED_QUANTITIES; i++)
    names[n++] = quantity_rows[i].name;
  for (const struct scallop_formula *f = scallop_published; f->name && n < CANDIDATES - 1; f++)
    names[n++] = f->name;
  names[n] = NULL;
  return nearest(stem(name), names);
}

bool quantity_is_text(const struct quantity *q)
{
  return q->kind == QUANTITY_GAIT || q->kind == QUANTITY_LABEL || q->kind == QUANTITY_CERTIFIED || q->kind == QUANTITY_STATUS
         || q->kind == QUANTITY_PHASE_NAME || q->kind == QUANTITY_REGIME || q->kind == QUANTITY_MODES;
}

bool quantity_is_series(const struct quantity *q)
{
  return q->kind == QUANTITY_PUBLISHED || q->kind == QUANTITY_DERIVED || q->kind == QUANTITY_LIMIT;
}

bool quantity_is_compared(const struct quantities *all, const struct quantity *series)
{
  for (int i = 0; i < all->count; i++)
    if (all->item[i].of >= 0 && &all->item[all->item[i].of] == series)
      return true;
  return false;
}

bool quantity_is_of_phase(const struct quantities *all, const struct quantity *q)
{
  if (q->of >= 0)
    return quantity_is_of_phase(all, &all->item[q->of]);
  switch (q->kind) {
  case QUANTITY_REGIME:
  case QUANTITY_MODES: return q->which == OF_PHASE;
  case QUANTITY_PUBLISHED: return q->formula->setting != SCALLOP_STEADY;
  case QUANTITY_ANSWER:
  case QUANTITY_DERIVED:
  case QUANTITY_LIMIT:
  case QUANTITY_CERTIFIED: return quantity_rows[q->which].of == OF_PHASE;
  default: return false;
  }
}
