#include "compare/answers/mode_change.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static const char *const phase_names[] = { "extension", "contraction" };

struct told {
  char *text;
  size_t used;
};

/* There are four causes at most, of 60 characters at most: the text has room for them. */
static void tell(struct told *t, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void tell(struct told *t, const char *format, ...)
{
  va_list arguments;
  va_start(arguments, format);
  t->used += (size_t)snprintf(t->text + t->used, MODE_CHANGE_TEXT - t->used, "%s", t->used > 0 ? "; " : "");
  t->used += (size_t)vsnprintf(t->text + t->used, MODE_CHANGE_TEXT - t->used, format, arguments);
  va_end(arguments);
}

static int kept(const struct scallop_modes *m) { return m->count < SCALLOP_MODES_KEPT ? m->count : SCALLOP_MODES_KEPT; }
static int direction(const struct scallop_modes *m, int i, int body)
{
  return body == 1 ? m->kept[i].s1 : m->kept[i].s2;
}

struct seen {       /* of one body in one phase */
  int stops, turns; /* how often it comes to rest for a while, and changes its direction                              */
  bool at_start, at_end; /* at rest there */
};

static struct seen look(const struct scallop_modes *m, int body)
{
  struct seen s = { 0 };
  int last = 0;
  for (int i = 0; i < kept(m); i++) {
    int d = direction(m, i, body);
    s.stops += d == 0 && (i == 0 || direction(m, i - 1, body) != 0);
    s.turns += d != 0 && last != 0 && d != last;
    last = d != 0 ? d : last;
    s.at_start |= i == 0 && d == 0;
    s.at_end = d == 0;
  }
  return s;
}

/* Of the common velocity at the start of a phase: its sign, 0 from rest */
static int start_sign(const struct scallop_modes *m)
{
  return m->count > 0 && m->kept[0].s1 == m->kept[0].s2 ? m->kept[0].s1 : 0;
}

/* The body that never moves, or 0 */
static int resting_body(const struct answer *s)
{
  for (int body = 1; body <= 2; body++) {
    bool rests = s->regime == SCALLOP_AT_REST;
    for (int phase = 0; phase < 2; phase++)
      for (int i = 0; i < kept(&s->modes[phase]); i++)
        rests = rests && direction(&s->modes[phase], i, body) == 0;
    if (rests)
      return body;
  }
  return 0;
}

static void tell_stops(struct told *t, const struct scallop_modes *before, const struct scallop_modes *after, int phase,
                       int body)
{
  struct seen a = look(before, body), b = look(after, body);
  if (a.stops == 0 && b.stops > 0)
    tell(t, "onset of sticking: body %d in the %s", body, phase_names[phase]);
  else if (a.stops > 0 && b.stops == 0)
    tell(t, "end of sticking: body %d in the %s", body, phase_names[phase]);
  else if (a.at_end != b.at_end)
    tell(t, "body %d is %s the end of the %s", body, b.at_end ? "held to" : "released before", phase_names[phase]);
  else if (a.at_start != b.at_start)
    tell(t, "body %d %s the start of the %s", body, b.at_start ? "is held from" : "slips at", phase_names[phase]);
  else if (a.stops != b.stops)
    tell(t, "body %d sticks %s often in the %s", body, b.stops > a.stops ? "more" : "less", phase_names[phase]);
}

static void tell_turns(struct told *t, const struct scallop_modes *before, const struct scallop_modes *after, int phase,
                       int body)
{
  struct seen a = look(before, body), b = look(after, body);
  if (a.turns > 0 && b.turns == 0)
    tell(t, "body %d ceases to turn in the %s", body, phase_names[phase]);
  else if (a.turns == 0 && b.turns > 0)
    tell(t, "body %d begins to turn in the %s", body, phase_names[phase]);
  else if (a.turns != b.turns)
    tell(t, "body %d turns %s often in the %s", body, b.turns > a.turns ? "more" : "less", phase_names[phase]);
}

typedef void teller(struct told *, const struct scallop_modes *, const struct scallop_modes *, int phase, int body);

static void tell_all(teller *tells, struct told *t, const struct answer *before, const struct answer *after)
{
  for (int phase = 0; phase < 2; phase++)
    for (int body = 1; body <= 2; body++)
      tells(t, &before->modes[phase], &after->modes[phase], phase, body);
}

static bool mirror_each_other(const struct scallop_modes *a, const struct scallop_modes *b)
{
  bool same = a->count == b->count;
  for (int i = 0; same && i < kept(a); i++)
    same = a->kept[i].s1 == -b->kept[i].s2 && a->kept[i].s2 == -b->kept[i].s1;
  return same;
}

static int sign(double x) { return (x > 0) - (x < 0); }

static void tell_signs(struct told *t, const struct answer *before, const struct answer *after)
{
  const int a[2] = { sign(before->value[Q_V_START].high), start_sign(&before->modes[1]) };
  const int b[2] = { sign(after->value[Q_V_START].high), start_sign(&after->modes[1]) };
  for (int phase = 0; phase < 2; phase++)
    if (a[phase] * b[phase] < 0)
      tell(t, "%s velocity changes sign", phase == 0 ? "start" : "mid");
    else if (a[phase] != b[phase])
      tell(t, "the %s %s from rest", phase_names[phase], b[phase] == 0 ? "begins" : "no longer begins");
}

const char *mode_change_text(char text[MODE_CHANGE_TEXT], const struct answer *before, const struct answer *after)
{
  struct told t = { .text = text };
  int was = resting_body(before), is = resting_body(after);
  text[0] = '\0';
  if (same_modes(before->modes, after->modes))
    tell(&t, "no change of modes");
  else if (mirror_each_other(&before->modes[0], &after->modes[0])
           && mirror_each_other(&before->modes[1],
                                &after->modes[1])) /* F1 = F2 or alpha = 1/2: it crawls the other way */
    tell(&t, "the bodies exchange their roles");
  else if (was != is) {
    if (was != 0)
      tell(&t, "end of the permanent rest of body %d", was);
    if (is != 0)
      tell(&t, "permanent rest of body %d", is);
  } else {
    tell_all(tell_stops, &t, before, after);
    if (t.used == 0)
      tell_signs(&t, before, after);
    if (t.used == 0)
      tell_all(tell_turns, &t, before, after);
    if (t.used == 0)
      tell(&t, "the order of the modes");
  }
  return text;
}

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
  struct stretch stretch[MOST_STRETCHES];
  int count;
  const struct scallop_crawler *crawler;
  enum scallop_phase_kind phase;
  double since; /* when the phase begins */
};

static void stretch_on(void *context, const struct scallop_interval *interval)
{
  struct stretching *s = context;
  const struct scallop_span span = scallop_interval_span(interval, s->crawler, s->phase);
  struct stretch *last = s->count > 0 && s->count <= MOST_STRETCHES ? &s->stretch[s->count - 1] : NULL;
  const struct stretch now = { s->phase, s->since + span.t_begin, s->since + span.t_end, span.mode };
  if (last && last->phase == now.phase && last->mode.s1 == now.mode.s1 && last->mode.s2 == now.mode.s2)
    last->until = now.until;
  else if (++s->count <= MOST_STRETCHES)
    s->stretch[s->count - 1] = now;
}

int stretches_of(struct stretch stretches[MOST_STRETCHES], const struct motion *m, const struct answer *answer)
{
  struct stretching s = { .crawler = &m->crawler, .phase = m->phase };
  const double v0[] = { answer->value[Q_V_START].high, answer->value[Q_V_MID].high };
  if (m->of == OF_PHASE)
    scallop_phase_intervals(s.crawler, s.phase, m->v0, stretch_on, &s);
  for (int kind = 0; kind < 2 && m->of == OF_STEADY; kind++) {
    s.phase = (enum scallop_phase_kind)kind;
    scallop_phase_intervals(s.crawler, s.phase, v0[kind], stretch_on, &s);
    s.since = scallop_phase_duration(s.crawler, SCALLOP_EXTENSION);
  }
  memcpy(stretches, s.stretch, sizeof s.stretch);
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
