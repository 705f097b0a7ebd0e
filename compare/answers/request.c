#include "compare/answers/request.h"

#include <stdio.h>
#include <string.h>

/* L, T and alpha are not among gaits of which a measured one brings its own. */
bool is_held(const struct request *r, const char *parameter)
{
  const struct sweep_variable *v;
  int place = crawler_place(parameter);
  bool is_own = place < CRAWLER_NUMBERS && strchr("LTa", *parameter) && !r->point.written[place];
  for (int i = 0; (v = sweep_variable(&r->sweep, i)); i++) {
    if (v->target != TARGET_LABEL && strcmp(v->sets, parameter) == 0)
      return false;
    for (long k = 0; is_own && v->target == TARGET_GAIT && k < v->count; k++)
      if (strncmp(v->texts[k], "measured:", 9) == 0)
        return false;
  }
  return true;
}

const char *parameters_text(char text[PARAMETERS_TEXT], const struct point *p, const char *const *not_held,
                            bool as_written)
{
  size_t used = 0;
  *text = '\0';
  for (int i = 0; i <= CRAWLER_NUMBERS; i++) {
    const char *written = i == CRAWLER_NUMBERS ? p->crawler.gait->name : as_written ? p->written[i] : NULL;
    char number[NUMBER_TEXT];
    if (name_among(not_held, crawler_parameters[i]))
      continue;
    if (!written)
      number_text(number, crawler_number(&p->crawler, i), 0);
    used += (size_t)snprintf(text + used, PARAMETERS_TEXT - used, " %s=%s", crawler_parameters[i],
                             written ? written : number);
  }
  return text;
}

void note_parameters(struct table *t, const struct point *p, const char *const *not_held, bool as_written)
{
  char text[PARAMETERS_TEXT];
  if (*parameters_text(text, p, not_held, as_written))
    table_note(t, "parameters:%s", text);
}

void point_tell_noise(const struct point *p, const struct style *style)
{
  const struct scallop_gait *gait = p->crawler.gait;
  int reversals = strncmp(gait->name, "measured:", 9) == 0 ? gait_reversals(gait) : 0;
  if (reversals > 0 && !style->quiet)
    fprintf(stderr,
            "scallop %s: note: in %.200s l' changes its sign %d times within the phases. If that is noise, smooth the "
            "table: the spline goes through every point\n",
            style->command, gait->name + 9, reversals);
}
