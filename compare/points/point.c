#include "compare/points/point.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "compare/points/gait_file.h"
#include "compare/points/gaits.h"
#include "compare/text/values.h"

const char *const crawler_parameters[] = { "m1", "m2", "F1", "F2", "L", "T", "alpha", "gait", NULL };

enum { PLACE_OF_L = 4, PLACE_OF_T, PLACE_OF_ALPHA };

const char *name_among(const char *const *names, const char *name)
{
  while (names && *names && strcmp(*names, name) != 0)
    names++;
  return names ? *names : NULL;
}

const struct parameter *parameter_named(const char *name)
{
  static const struct parameter all[] = { { "m1", "m1", TARGET_NUMBER },
                                          { "m2", "m2", TARGET_NUMBER },
                                          { "F1", "F1", TARGET_NUMBER },
                                          { "F2", "F2", TARGET_NUMBER },
                                          { "L", "L", TARGET_NUMBER },
                                          { "T", "T", TARGET_NUMBER },
                                          { "alpha", "alpha", TARGET_NUMBER },
                                          { "v0", "v0", TARGET_V0 },
                                          { "gait", "gait", TARGET_GAIT },
                                          { "phase", "phase", TARGET_PHASE },
                                          { "froude", "T", TARGET_FROUDE },
                                          { "F1_over_F2", "F1", TARGET_F1_OVER_F2 },
                                          { "m1_over_m2", "m1", TARGET_M1_OVER_M2 } };
  for (size_t i = 0; i < sizeof all / sizeof *all; i++)
    if (strcmp(name, all[i].name) == 0)
      return &all[i];
  return NULL;
}

int crawler_place(const char *name)
{
  int i = 0;
  while (i < CRAWLER_NUMBERS && strcmp(name, crawler_parameters[i]) != 0)
    i++;
  return i;
}

double *crawler_field(struct scallop_crawler *c, int place)
{
  static const size_t fields[CRAWLER_NUMBERS] = {
    offsetof(struct scallop_crawler, m1),   offsetof(struct scallop_crawler, m2), offsetof(struct scallop_crawler, F1),
    offsetof(struct scallop_crawler, F2),   offsetof(struct scallop_crawler, L),  offsetof(struct scallop_crawler, T),
    offsetof(struct scallop_crawler, alpha)
  };
  return (void *)((char *)c + fields[place]);
}

double crawler_number(const struct scallop_crawler *c, int place)
{
  return *crawler_field((struct scallop_crawler *)c, place);
}

void crawler_numbers(const struct scallop_crawler *c, double numbers[CRAWLER_NUMBERS])
{
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    numbers[i] = crawler_number(c, i);
}

bool same_crawler(const struct scallop_crawler *a, const struct scallop_crawler *b)
{
  bool same = a->gait == b->gait;
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    same = same && crawler_number(a, i) == crawler_number(b, i);
  return same;
}

struct point point_initial(const struct scallop_crawler *usual)
{
  const struct scallop_crawler crawler = usual ? *usual : scallop_crawler_default();
  return (struct point){ .crawler = crawler, .usual = crawler };
}

void point_complete(struct point *p)
{
  const struct gait_file *file = gait_file_of(p->crawler.gait);
  struct scallop_crawler *c = &p->crawler;
  if (!p->written[PLACE_OF_L])
    c->L = file ? file->best.L : p->usual.L;
  if (!p->written[PLACE_OF_T])
    c->T = file ? file->best.T : p->usual.T;
  if (!p->written[PLACE_OF_ALPHA])
    c->alpha = file ? file->best.alpha : p->usual.alpha;
}

const char *point_set_number(struct point *p, int place, const char *text)
{
  struct scallop_complaint complaint;
  double x;
  if (!read_number(text, &x))
    return no_number(text, place == PLACE_OF_V0      ? "a finite number"
                           : place == PLACE_OF_ALPHA ? "a number between 0 and 1, both excluded"
                                                     : "a finite number > 0");
  double *field = place == PLACE_OF_V0 ? &p->v0 : crawler_field(&p->crawler, place), before = *field;
  *field = x; /* the crawler has no other fault */
  if (place != PLACE_OF_V0 && scallop_crawler_check(&p->crawler, &complaint) != SCALLOP_OK) {
    *field = before;
    return not_allowed(text, complaint.allowed);
  }
  p->has_v0 |= place == PLACE_OF_V0;
  p->written[place] = text;
  return NULL;
}

static const char *set_ratio(struct point *p, enum ratio_place which, const char *text)
{
  double x;
  if (!read_number(text, &x) || !(x > 0))
    return no_number(text, "a finite number > 0");
  p->ratio[which] = x;
  return NULL;
}

static const char *set_gait(struct point *p, const char *text)
{
  struct gait_answer answer = gait_of_text(text);
  p->unreadable = answer.fault == GAIT_UNREADABLE;
  if (!answer.gait)
    return answer.wrong;
  p->crawler.gait = answer.gait;
  p->has_gait = true;
  return NULL;
}

static const char *set_phase(struct point *p, const char *text)
{
  if (strcmp(text, "extension") != 0 && strcmp(text, "contraction") != 0)
    return not_allowed(text, "extension or contraction");
  p->has_phase = true;
  p->phase = *text == 'e' ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
  return NULL;
}

const char *point_set(struct point *p, const char *name, const char *text)
{
  const struct parameter *parameter = parameter_named(name);
  if (!parameter)
    return not_allowed(name, "the name of a parameter");
  switch (parameter->target) {
  case TARGET_GAIT: return set_gait(p, text);
  case TARGET_PHASE: return set_phase(p, text);
  case TARGET_NUMBER:
  case TARGET_V0: return point_set_number(p, crawler_place(name), text);
  default: return set_ratio(p, (enum ratio_place)(parameter->target - TARGET_F1_OVER_F2), text);
  }
}
