#include "compare/answers/quantity.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/command/options.h"

enum { MOST_ORDER = 1000, CANDIDATES = 160 };

static const char *const steady_names[] = { "v_start",    "v_mid",  "displacement", "mean_velocity",
                                            "multiplier", "regime", "modes",        NULL };
static const char *const phase_names[] = { "t1", "dT", "v_end", "dx1", "dx2", "dxC", "phase_regime", "phase_modes", NULL };
static const char *const sample_names[] = { "t", "x1", "x2", "xC", "v1", "v2", "l", NULL };
/* Their series are derived, and their values certified: the multiplier has no series. */
enum { STEADY_SERIES = STEADY_MEAN_VELOCITY + 1 };

static const struct {
  const char *name;
  enum quantity_kind kind;
} single[] = { { "v0", QUANTITY_V0 },
               { "froude", QUANTITY_FROUDE },
               { "gait", QUANTITY_GAIT },
               { "status", QUANTITY_STATUS },
               { "sticking_onset", QUANTITY_ONSET },
               { "phase", QUANTITY_PHASE_NAME },
               { "F1_over_F2", QUANTITY_F1_OVER_F2 },
               { "m1_over_m2", QUANTITY_M1_OVER_M2 } };
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

/* A number of the steady state or of the phase that has a series: its place, those of the phase after those of the steady state */
static int value_named(const char *name, int steady_count)
{
  int steady = place_in(steady_names, steady_count, name), phase = place_in(phase_names, PHASE_NUMBERS, name);
  return steady >= 0 ? steady : phase >= 0 ? STEADY_VALUES + phase : -1;
}

/* derived_N.VALUE or limit.VALUE */
static bool derived_named(struct quantity *q, const char *name)
{
  const char *dot = strchr(name, '.');
  if (!dot)
    return false;
  q->which = value_named(dot + 1, STEADY_SERIES);
  if (strncmp(name, "limit.", 6) == 0) {
    q->kind = QUANTITY_LIMIT;
    return q->which >= 0;
  }
  char *end;
  q->kind = QUANTITY_DERIVED;
  if (strncmp(name, "derived_", 8) != 0 || name[8] < '1' || name[8] > '9')
    return false;
  q->order = strtol(name + 8, &end, 10);
  return end == dot && q->order <= MOST_ORDER && q->which >= 0;
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
                { QUANTITY_STEADY, place_in(steady_names, STEADY_VALUES, name) },
                { QUANTITY_PHASE, place_in(phase_names, PHASE_VALUES, name) },
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
      return true;
    }
  if (strncmp(name, "certified.", 10) == 0) {
    q->kind = QUANTITY_CERTIFIED;
    q->which = value_named(name + 10, STEADY_NUMBERS);
    return q->which >= 0;
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
  for (int i = 0; i < STEADY_VALUES; i++)
    names[n++] = steady_names[i];
  for (int i = 0; i < PHASE_VALUES; i++)
    names[n++] = phase_names[i];
  for (const struct scallop_formula *f = scallop_published; f->name && n < CANDIDATES - 1; f++)
    names[n++] = f->name;
  names[n] = NULL;
  return nearest(stem(name), names);
}

bool quantity_is_text(const struct quantity *q)
{
  return q->kind == QUANTITY_GAIT || q->kind == QUANTITY_LABEL || q->kind == QUANTITY_CERTIFIED || q->kind == QUANTITY_STATUS
         || q->kind == QUANTITY_PHASE_NAME || (q->kind == QUANTITY_STEADY && q->which >= STEADY_NUMBERS)
         || (q->kind == QUANTITY_PHASE && q->which >= PHASE_NUMBERS);
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
  case QUANTITY_PHASE: return true;
  case QUANTITY_PUBLISHED: return q->formula->setting != SCALLOP_STEADY;
  case QUANTITY_DERIVED:
  case QUANTITY_LIMIT:
  case QUANTITY_CERTIFIED: return q->which >= STEADY_VALUES;
  default: return false;
  }
}

bool formula_takes_given(const struct scallop_formula *f)
{
  return strstr(f->text, "t1") || strstr(f->text, "dT") || strstr(f->text, "x_switch");
}
