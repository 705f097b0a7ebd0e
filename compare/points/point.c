#include "compare/points/point.h"

#include <math.h>
#include <string.h>

#include "compare/points/gaits.h"
#include "compare/text/values.h"

const char *const crawler_parameters[] = { "m1", "m2", "F1", "F2", "L", "T", "alpha", "gait", NULL };

enum { ALPHA = CRAWLER_NUMBERS - 1 }; /* its place */

int crawler_place(const char *name)
{
  int i = 0;
  while (i < CRAWLER_NUMBERS && strcmp(name, crawler_parameters[i]) != 0)
    i++;
  return i;
}

static double *crawler_field(struct scallop_crawler *c, int place)
{
  double *const fields[CRAWLER_NUMBERS] = { &c->m1, &c->m2, &c->F1, &c->F2, &c->L, &c->T, &c->alpha };
  return fields[place];
}

void crawler_numbers(const struct scallop_crawler *c, double numbers[CRAWLER_NUMBERS])
{
  const double all[CRAWLER_NUMBERS] = { c->m1, c->m2, c->F1, c->F2, c->L, c->T, c->alpha };
  memcpy(numbers, all, sizeof all);
}

bool same_crawler(const struct scallop_crawler *a, const struct scallop_crawler *b)
{
  double x[CRAWLER_NUMBERS], y[CRAWLER_NUMBERS];
  crawler_numbers(a, x);
  crawler_numbers(b, y);
  bool same = a->gait == b->gait;
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    same = same && x[i] == y[i];
  return same;
}

double crawler_parameter(const struct scallop_crawler *crawler, const char *name)
{
  double numbers[CRAWLER_NUMBERS + 1] = { [CRAWLER_NUMBERS] = NAN };
  crawler_numbers(crawler, numbers);
  return numbers[crawler_place(name)];
}

struct point point_initial(const struct scallop_crawler *usual)
{
  const struct scallop_crawler crawler = usual ? *usual : scallop_crawler_default();
  return (struct point){ .crawler = crawler, .usual = crawler };
}

void point_complete(struct point *p)
{
  static const char *const own[] = { "L", "T", "alpha" };
  struct scallop_crawler other = p->usual;
  gait_has_own(p->crawler.gait, &other.L, &other.T, &other.alpha);
  for (size_t i = 0; i < sizeof own / sizeof *own; i++) {
    int place = crawler_place(own[i]);
    if (!p->written[place])
      *crawler_field(&p->crawler, place) = *crawler_field(&other, place);
  }
}

static const char *set_v0(struct point *p, double x, const char *text)
{
  p->v0 = x;
  p->written_v0 = text;
  p->has_v0 = true;
  return NULL;
}

/* Takes over the candidate, which differs from the point in one number. */
static const char *take(struct point *p, const struct scallop_crawler *candidate, int place, const char *text)
{
  struct scallop_complaint complaint;
  if (scallop_crawler_check(candidate, &complaint) != SCALLOP_OK)
    return not_allowed(text, complaint.allowed);
  p->crawler = *candidate;
  p->written[place] = text;
  return NULL;
}

const char *point_set_double(struct point *p, int place, double x, const char *text)
{
  struct scallop_crawler candidate = p->crawler; /* has no other fault */
  if (place == CRAWLER_NUMBERS)
    return isfinite(x) ? set_v0(p, x, text) : no_number(text, "a finite number");
  *crawler_field(&candidate, place) = x;
  return take(p, &candidate, place, text);
}

const char *point_set_number(struct point *p, int place, const char *text)
{
  struct scallop_crawler candidate = p->crawler;
  double v0;
  if (place == CRAWLER_NUMBERS)
    return read_number(text, &v0) ? set_v0(p, v0, text) : no_number(text, "a finite number");
  if (!read_number(text, crawler_field(&candidate, place)))
    return no_number(text, place == ALPHA ? "a number between 0 and 1, both excluded" : "a finite number > 0");
  return take(p, &candidate, place, text);
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
