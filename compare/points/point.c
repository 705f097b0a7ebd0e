#include "compare/points/point.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "compare/columns/columns.h"
#include "compare/points/gait_file.h"
#include "compare/points/gaits.h"
#include "compare/text/values.h"

const char *const crawler_parameters[] = { "m1", "m2", "F1", "F2", "L", "T", "alpha", "gait", NULL };

static const char positive[] = "a finite number > 0";
#define CRAWLER(name) #name, #name, TARGET_NUMBER, offsetof(struct point, crawler.name)
const struct parameter point_parameters[POINT_PARAMETERS] = {
  { CRAWLER(m1), positive },
  { CRAWLER(m2), positive },
  { CRAWLER(F1), positive },
  { CRAWLER(F2), positive },
  { CRAWLER(L), positive },
  { CRAWLER(T), positive },
  { CRAWLER(alpha), "a number between 0 and 1, both excluded" },
  { "v0", "v0", TARGET_V0, offsetof(struct point, v0), "a finite number" },
  { "m1_over_m2", "m1", TARGET_M1_OVER_M2, offsetof(struct point, ratio[M1_OVER_M2]), positive },
  { "mu1", "F1", TARGET_MU1, offsetof(struct point, ratio[MU1]), positive },
  { "mu2", "F2", TARGET_MU2, offsetof(struct point, ratio[MU2]), positive },
  { "F1_over_F2", "F1", TARGET_F1_OVER_F2, offsetof(struct point, ratio[F1_OVER_F2]), positive },
  { "froude", "T", TARGET_FROUDE, offsetof(struct point, ratio[FROUDE]), positive },
  { "g", "g", TARGET_GRAVITY, offsetof(struct point, gravity), positive },
  { "gait", "gait", TARGET_GAIT, 0, NULL },
  { "phase", "phase", TARGET_PHASE, 0, NULL },
};

const struct parameter *parameter_named(const char *name)
{
  const struct parameter *p = point_parameters;
  while (p < point_parameters + POINT_PARAMETERS && strcmp(name, p->name) != 0)
    p++;
  return p < point_parameters + POINT_PARAMETERS ? p : NULL;
}

const char *name_among(const char *const *names, const char *name)
{
  while (names && *names && strcmp(*names, name) != 0)
    names++;
  return names ? *names : NULL;
}

int crawler_place(const char *name)
{
  int i = 0;
  while (i < CRAWLER_NUMBERS && strcmp(name, point_parameters[i].name) != 0)
    i++;
  return i;
}

_Static_assert(offsetof(struct point, crawler) == 0, "a number's place in a point is that in its crawler");
double *crawler_field(struct scallop_crawler *c, int place)
{
  return (void *)((char *)c + point_parameters[place].field);
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
  return (struct point){ .crawler = crawler, .usual = crawler, .gravity = USUAL_GRAVITY };
}

void point_complete(struct point *p)
{
  const struct gait_file *file = gait_file_of(p->crawler.gait);
  const double own[] = { file ? file->best.L : p->usual.L, file ? file->best.T : p->usual.T,
                         file ? file->best.alpha : p->usual.alpha };
  for (int i = 0; i < 3; i++) {
    const int place = CRAWLER_NUMBERS - 3 + i; /* L, T and alpha are the last */
    if (!p->written[place])
      *crawler_field(&p->crawler, place) = own[i];
  }
}

/* Sets a number of the crawler, v0, g or a ratio. Returns NULL or the error. */
static const char *set_number(struct point *p, const struct parameter *q, const char *text)
{
  struct scallop_complaint complaint = { .allowed = q->allowed };
  double x, *field = (void *)((char *)p + q->field), before = *field;
  if (!read_number(text, &x) && !isfinite(x = text_number(text))) /* 3/5 */
    return no_number(text, q->allowed);
  *field = x; /* all other numbers are valid */
  if (q->target == TARGET_NUMBER ? scallop_crawler_check(&p->crawler, &complaint) != SCALLOP_OK
                                 : q->target != TARGET_V0 && !(x > 0)) {
    *field = before;
    return not_allowed(text, complaint.allowed);
  }
  p->has_v0 |= q->target == TARGET_V0;
  if (q < point_parameters + POINT_NUMBERS)
    p->written[q - point_parameters] = text;
  return NULL;
}

const char *point_set_number(struct point *p, int place, const char *text)
{
  return set_number(p, &point_parameters[place], text);
}

static const char *set_gait(struct point *p, const char *text)
{
  struct gait_result answer = gait_of_text(text);
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
  const struct parameter *q = parameter_named(name);
  if (!q)
    return not_allowed(name, "the name of a parameter");
  return q->target == TARGET_GAIT    ? set_gait(p, text)
         : q->target == TARGET_PHASE ? set_phase(p, text)
                                     : set_number(p, q, text);
}
