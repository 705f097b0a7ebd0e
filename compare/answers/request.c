#include "compare/answers/request.h"

#include <stdio.h>
#include <string.h>

#include "compare/points/gait_file.h"
#include "compare/points/gaits.h"

/* L, T and alpha vary with the gait if one of the gaits is measured. */
bool is_constant(const struct request *r, const char *parameter)
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

const char *parameters_text(char text[PARAMETERS_TEXT], const struct point *p, const char *const *excluded,
                            bool as_written)
{
  size_t used = 0;
  *text = '\0';
  for (int i = 0; i <= CRAWLER_NUMBERS; i++) {
    const char *written = i == CRAWLER_NUMBERS ? p->crawler.gait->name : as_written ? p->written[i] : NULL;
    char number[NUMBER_TEXT];
    if (name_among(excluded, crawler_parameters[i]))
      continue;
    if (!written)
      number_text(number, crawler_number(&p->crawler, i), 0);
    used += (size_t)snprintf(text + used, PARAMETERS_TEXT - used, " %s=%s", crawler_parameters[i],
                             written ? written : number);
  }
  return text;
}

void note_parameters(struct table *t, const struct point *p, const char *const *excluded, bool as_written)
{
  char text[PARAMETERS_TEXT];
  if (*parameters_text(text, p, excluded, as_written))
    table_note(t, "parameters:%s", text);
}

void print_decimal_commas(const struct sweep *sweep, const struct style *style)
{
  const struct sweep_variable *v;
  for (int i = 0; (v = sweep_variable(sweep, i)) && !style->quiet; i++)
    if (v->texts && v->count == 2 && v->target <= TARGET_FROUDE && !strpbrk(v->texts[0], ".e/")
        && strspn(v->texts[1], "0123456789") == strlen(v->texts[1]))
      fprintf(stderr, "scallop %s: note: --%s %s,%s is two values, %s and %s; a number has a decimal point: %s.%s\n",
              style->command, v->name, v->texts[0], v->texts[1], v->texts[0], v->texts[1], v->texts[0], v->texts[1]);
}

void print_recording(const struct point *p, const struct style *style)
{
  const struct scallop_gait *gait = p->crawler.gait;
  const struct gait_file *file = gait_file_of(gait);
  int reversals = gait_reversals(gait);
  char text[400];
  if (!file || style->quiet)
    return;
  scallop_measured_text(file->measured, text, sizeof text);
  fprintf(stderr, "scallop %s: note: %.200s: %s; %s\n", style->command, gait->name + strlen("measured:"), file->columns,
          text);
  if (reversals > 0)
    fprintf(stderr, "scallop %s: note: l' changes its sign %d times within the phases, probably by noise\n",
            style->command, reversals);
}
