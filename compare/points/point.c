#include "compare/points/point.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "compare/points/gaits.h"
#include "compare/text/values.h"

const char *const crawler_parameters[] = { "m1", "m2", "F1", "F2", "L", "T", "alpha", "gait", NULL };

enum { PLACE_OF_L = 4, PLACE_OF_ALPHA = CRAWLER_NUMBERS - 1 }; /* T is between them */

const char *name_among(const char *const *names, const char *name)
{
  while (names && *names && strcmp(*names, name) != 0)
    names++;
  return names ? *names : NULL;
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

double crawler_parameter(const struct scallop_crawler *crawler, const char *name)
{
  int place = crawler_place(name);
  return place < CRAWLER_NUMBERS ? crawler_number(crawler, place) : NAN;
}

struct point point_initial(const struct scallop_crawler *usual)
{
  const struct scallop_crawler crawler = usual ? *usual : scallop_crawler_default();
  return (struct point){ .crawler = crawler, .usual = crawler };
}

void point_complete(struct point *p)
{
  struct scallop_crawler other = p->usual;
  gait_has_own(p->crawler.gait, &other.L, &other.T, &other.alpha);
  for (int place = PLACE_OF_L; place <= PLACE_OF_ALPHA; place++)
    if (!p->written[place])
      *crawler_field(&p->crawler, place) = crawler_number(&other, place);
}

static const char *set_v0(struct point *p, double x, const char *text)
{
  p->v0 = x;
  p->written_v0 = text;
  p->has_v0 = true;
  return NULL;
}

const char *point_set_double(struct point *p, int place, double x, const char *text)
{
  struct scallop_complaint complaint;
  if (place == CRAWLER_NUMBERS)
    return isfinite(x) ? set_v0(p, x, text) : no_number(text, "a finite number");
  double *field = crawler_field(&p->crawler, place), before = *field;
  *field = x; /* the crawler has no other fault */
  if (scallop_crawler_check(&p->crawler, &complaint) != SCALLOP_OK) {
    *field = before;
    return not_allowed(text, complaint.allowed);
  }
  p->written[place] = text;
  return NULL;
}

const char *point_set_number(struct point *p, int place, const char *text)
{
  double x;
  if (read_number(text, &x))
    return point_set_double(p, place, x, text);
  return no_number(text, place == CRAWLER_NUMBERS  ? "a finite number"
                         : place == PLACE_OF_ALPHA ? "a number between 0 and 1, both excluded"
                                                   : "a finite number > 0");
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

static const char *read_v0(struct point *p, const char *text) { return point_set_number(p, CRAWLER_NUMBERS, text); }

const char *point_set(struct point *p, const char *name, const char *text)
{
  static const struct {
    const char *name;
    const char *(*set)(struct point *, const char *text);
  } others[] = { { "gait", set_gait }, { "phase", set_phase }, { "v0", read_v0 } };
  int place = crawler_place(name);
  if (place < CRAWLER_NUMBERS)
    return point_set_number(p, place, text);
  for (size_t i = 0; i < sizeof others / sizeof *others; i++)
    if (strcmp(name, others[i].name) == 0)
      return others[i].set(p, text);
  return not_allowed(name, "the name of a parameter");
}
