#include "compare/answers/stretches.h"

#include <stdio.h>

const char *mode_in_words(char text[MODE_WORDS], struct scallop_mode mode)
{
  static const char *const ways[] = { "backward", "stuck", "forward" };
  if (mode.s1 == mode.s2)
    snprintf(text, MODE_WORDS, "both bodies %s", mode.s1 == 0 ? "at rest" : ways[mode.s1 + 1]);
  else
    snprintf(text, MODE_WORDS, "body 1 %s, body 2 %s", ways[mode.s1 + 1], ways[mode.s2 + 1]);
  return text;
}

/* The stretches so far, while the intervals of a phase are visited */
struct stretching {
  struct stretch *stretch;
  int count;
  const struct scallop_crawler *crawler;
  enum scallop_phase_kind phase;
  double since; /* when the phase begins */
};

static void stretch_on(void *context, const struct scallop_interval *interval)
{
  struct stretching *s = context;
  const struct scallop_span span = scallop_interval_span(interval, s->crawler, s->phase);
  const struct stretch now = { s->phase, s->since + span.t_begin, s->since + span.t_end, span.mode, interval->piece };
  const int n = s->count;
  if (n > 0 && n <= MOST_STRETCHES && s->stretch[n - 1].phase == now.phase && s->stretch[n - 1].mode.s1 == now.mode.s1
      && s->stretch[n - 1].mode.s2 == now.mode.s2)
    s->stretch[n - 1].until = now.until;
  else if (++s->count <= MOST_STRETCHES)
    s->stretch[n] = now;
}

int stretches_of(struct stretch stretches[MOST_STRETCHES], const struct motion *m, const struct answer *answer)
{
  const double v0[] = { answer->value[Q_V_START].high, answer->value[Q_V_MID].high };
  struct stretching s = { .stretch = stretches, .crawler = &m->crawler, .phase = m->phase };
  if (m->of == OF_PHASE)
    scallop_phase_intervals(s.crawler, s.phase, m->v0, stretch_on, &s);
  for (int kind = 0; kind < 2 && m->of == OF_STEADY; kind++) {
    s.phase = (enum scallop_phase_kind)kind;
    scallop_phase_intervals(s.crawler, s.phase, v0[kind], stretch_on, &s);
    s.since = scallop_phase_duration(s.crawler, SCALLOP_EXTENSION);
  }
  return s.count;
}

const char *motion_in_words(char text[MOTION_WORDS], const struct motion *m, const struct answer *answer, int digits)
{
  struct stretch s[MOST_STRETCHES];
  int count = stretches_of(s, m, answer);
  size_t used = 0;
  *text = '\0';
  for (int i = 0; i < count && i < MOST_STRETCHES; i++) {
    char words[MODE_WORDS];
    const char *between = i == 0 ? "" : s[i].phase == s[i - 1].phase ? "; " : " | ";
    used += (size_t)snprintf(text + used, MOTION_WORDS - used, "%s%s from %.*g to %.*g", between,
                             mode_in_words(words, s[i].mode), digits, s[i].from, digits, s[i].until);
  }
  if (count > MOST_STRETCHES)
    snprintf(text + used, MOTION_WORDS - used, "; ...");
  return text;
}
