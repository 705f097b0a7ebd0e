#include "compare/formulas/formula_file.h"
#include "compare/breakdown/motion.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* There are four causes at most, of 60 characters at most: the text has room for them. */
static void tell(char *text, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void tell(char *text, const char *format, ...)
{
  size_t used = strlen(text);
  va_list arguments;
  va_start(arguments, format);
  used += (size_t)snprintf(text + used, MODE_CHANGE_TEXT - used, "%s", used > 0 ? "; " : "");
  vsnprintf(text + used, MODE_CHANGE_TEXT - used, format, arguments);
  va_end(arguments);
}

static int kept(const struct scallop_modes *m) { return m->count < SCALLOP_MODES_KEPT ? m->count : SCALLOP_MODES_KEPT; }

/* What is seen of one body in one phase: how often it comes to rest for a while and how often it changes its direction;
 * whether it is at rest at the start and at the end; in how many modes it moves. */
enum { STOPS, TURNS, STARTS_STUCK, ENDS_STUCK, MOVES, SEEN };

static void look(int seen[SEEN], const struct scallop_modes *m, int body)
{
  int before = 1, last = 0; /* the direction, and the last one that was not 0 */
  memset(seen, 0, SEEN * sizeof *seen);
  for (int i = 0; i < kept(m); i++) {
    int direction = body == 1 ? m->kept[i].s1 : m->kept[i].s2;
    seen[STOPS] += direction == 0 && before != 0;
    seen[TURNS] += direction * last < 0;
    seen[STARTS_STUCK] += i == 0 && direction == 0;
    seen[ENDS_STUCK] = direction == 0;
    seen[MOVES] += direction != 0;
    before = direction;
    last = direction != 0 ? direction : last;
  }
}

/* Of a body in a phase the first of these that differs is told, of stops and then of turns; of those `from_none` it
 * must be 0 before or after. */
static const struct difference {
  int of;
  bool from_none;
  const char *more, *less;
} differences[] = {
  { STOPS, true, "onset of sticking: body %d in the %s", "end of sticking: body %d in the %s" },
  { ENDS_STUCK, false, "body %d is held to the end of the %s", "body %d is released before the end of the %s" },
  { STARTS_STUCK, false, "body %d is held from the start of the %s", "body %d slips at the start of the %s" },
  { STOPS, false, "body %d sticks more often in the %s", "body %d sticks less often in the %s" },
  { TURNS, true, "body %d begins to turn in the %s", "body %d ceases to turn in the %s" },
  { TURNS, false, "body %d turns more often in the %s", "body %d turns less often in the %s" },
};
enum { OF_STOPS = 4, OF_TURNS = 2 };

static void tell_differences(char *text, const struct difference *first, int count, const struct answer *before,
                             const struct answer *after)
{
  for (int i = 0; i < 4; i++) {
    int a[SEEN], b[SEEN], phase = i / 2, body = i % 2 + 1;
    const struct difference *d = first;
    look(a, &before->modes[phase], body);
    look(b, &after->modes[phase], body);
    while (d < first + count && (a[d->of] == b[d->of] || (d->from_none && a[d->of] > 0 && b[d->of] > 0)))
      d++;
    if (d < first + count)
      tell(text, b[d->of] > a[d->of] ? d->more : d->less, body, phase_names[phase]);
  }
}

/* The sign of the common velocity at the start of a phase; 0: from rest */
static int start_sign(const struct answer *s, int phase)
{
  const struct scallop_modes *m = &s->modes[phase];
  double v = s->value[Q_V_START].high;
  if (phase == 0)
    return (v > 0) - (v < 0);
  return m->count > 0 && m->kept[0].s1 == m->kept[0].s2 ? m->kept[0].s1 : 0;
}

static void tell_signs(char *text, const struct answer *before, const struct answer *after)
{
  for (int phase = 0; phase < 2; phase++) {
    int a = start_sign(before, phase), b = start_sign(after, phase);
    if (a * b < 0)
      tell(text, "%s velocity changes sign", phase == 0 ? "start" : "mid");
    else if (a != b)
      tell(text, "the %s %s from rest", phase_names[phase], b == 0 ? "begins" : "no longer begins");
  }
}

/* The body that never moves, or 0 */
static int resting_body(const struct answer *s)
{
  int extension[SEEN], contraction[SEEN];
  look(extension, &s->modes[0], 1);
  look(contraction, &s->modes[1], 1);
  return s->regime != SCALLOP_AT_REST ? 0 : extension[MOVES] + contraction[MOVES] == 0 ? 1 : 2;
}

/* Does each body do what the other one did, the other way? */
static bool mirror_each_other(const struct answer *a, const struct answer *b)
{
  struct answer mirrored = *a;
  for (int phase = 0; phase < 2; phase++)
    for (int i = 0; i < kept(&a->modes[phase]); i++) {
      const struct scallop_mode mode = a->modes[phase].kept[i];
      mirrored.modes[phase].kept[i] = (struct scallop_mode){ (signed char)-mode.s2, (signed char)-mode.s1 };
    }
  return same_modes(mirrored.modes, b->modes);
}

const char *mode_change_text(char text[MODE_CHANGE_TEXT], const struct answer *before, const struct answer *after)
{
  int was = resting_body(before), is = resting_body(after);
  *text = '\0';
  if (same_modes(before->modes, after->modes))
    tell(text, "no change of modes");
  else if (mirror_each_other(before, after)) /* F1 = F2 or alpha = 1/2: it crawls the other way */
    tell(text, "the bodies exchange their roles");
  else if (was != is) {
    if (was != 0)
      tell(text, "end of the permanent rest of body %d", was);
    if (is != 0)
      tell(text, "permanent rest of body %d", is);
  } else
    tell_differences(text, differences, OF_STOPS, before, after);
  if (!*text)
    tell_signs(text, before, after);
  if (!*text)
    tell_differences(text, differences + OF_STOPS, OF_TURNS, before, after);
  if (!*text)
    tell(text, "the order of the modes");
  return text;
}
