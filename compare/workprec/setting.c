#include "compare/workprec/setting.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>

enum { REFERENCE_DIGITS = 250 };

const enum quantity_id compared[COMPARED] = { [VELOCITY] = Q_V_START, [DISPLACEMENT] = Q_DISPLACEMENT };

const char *const kind_words[] = {
  [METHOD_FORMULA] = "formula", [METHOD_EXACT] = "exact", [METHOD_ROOT] = "root", [METHOD_SIMULATION] = "simulation"
};

const struct setting_answer no_answer = {
  .value = { NAN, NAN }, .gait_evaluations = NAN, .events = NAN, .root_iterations = NAN, .periods = NAN
};

/* More than the certified rows have, and beyond what the longest series leaves, which goes as eps^(terms/2) */
static long digits_for(double eps) { return REFERENCE_DIGITS + (eps < 1 ? (long)(-log10(eps) * MOST_TERMS / 2) : 0); }

const char *reference_init(struct reference *t, const struct scallop_crawler *crawler)
{
  struct scallop_scaled scaled;
  enum scallop_status status = scallop_scale(crawler, &scaled);
  *t = (struct reference){ .crawler = *crawler };
  scallop_rational_init(&t->exact);
  ball_answer_init(&t->steady);
  if (status != SCALLOP_OK)
    return scallop_status_text(status);
  t->eps = scaled.eps;
  t->digits = digits_for(scaled.eps);
  scallop_rational_of(&t->exact, crawler);
  if (!answer_in_balls(&t->steady, &t->exact, OF_STEADY, SCALLOP_EXTENSION, NULL, t->digits))
    return t->steady.why ? t->steady.why : scallop_status_text(t->steady.status);
  return NULL;
}

void reference_clear(struct reference *t)
{
  scallop_rational_clear(&t->exact);
  ball_answer_clear(&t->steady);
}

struct setting *settings_add(struct settings *settings, const struct reference *reference, const char *method,
                             enum method_kind kind, setting_solve *solve, const char *format, ...)
{
  va_list arguments;
  assert(settings->count < MOST_SETTINGS);
  struct setting *s = &settings->list[settings->count++];
  *s = (struct setting){ .kind = kind, .solve = solve, .reference = reference, .answer = no_answer };
  snprintf(s->method, sizeof s->method, "%s", method);
  va_start(arguments, format);
  vsnprintf(s->text, sizeof s->text, format, arguments);
  va_end(arguments);
  return s;
}

void settings_clear(struct settings *settings)
{
  for (int i = 0; i < settings->count; i++)
    if (settings->list[i].release && settings->list[i].memory)
      settings->list[i].release(settings->list[i].memory);
  settings->count = 0;
}
