/* Causes of a change of modes, in words. */
#include "compare/formulas/formula_file.h"
#include "compare/breakdown/motion.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Appends a cause. The text has space for four of 60 characters, the maximum. */
static void add_cause(char *text, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void add_cause(char *text, const char *format, ...)
{
  size_t used = strlen(text);
  va_list arguments;
  va_start(arguments, format);
  used += (size_t)snprintf(text + used, MODE_CHANGE_TEXT - used, "%s", used > 0 ? "; " : "");
  vsnprintf(text + used, MODE_CHANGE_TEXT - used, format, arguments);
  va_end(arguments);
}

static int kept(const struct scallop_modes *m) { return m->count < SCALLOP_MODES_KEPT ? m->count : SCALLOP_MODES_KEPT; }

/* Counts of one body in one phase: times that it comes to rest, changes of direction, rest at the start and at the end
 * (0 or 1), modes in which it moves */
enum { STOPS, TURNS, STARTS_STUCK, ENDS_STUCK, MOVES, COUNTS };

static void count_changes(int count[COUNTS], const struct scallop_modes *m, int body)
{
  int before = 1, last = 0; /* the direction, and the last one other than 0 */
  memset(count, 0, COUNTS * sizeof *count);
  for (int i = 0; i < kept(m); i++) {
    int direction = body == 1 ? m->kept[i].s1 : m->kept[i].s2;
    count[STOPS] += direction == 0 && before != 0;
    count[TURNS] += direction * last < 0;
    count[STARTS_STUCK] += i == 0 && direction == 0;
    count[ENDS_STUCK] = direction == 0;
    count[MOVES] += direction != 0;
    before = direction;
    last = direction != 0 ? direction : last;
  }
}

/* The first count that differs is stated for a body in a phase, first of stops and then of turns. with_zero: it must be
 * 0 before or after. */
static const struct difference {
  int of;
  bool with_zero;
  const char *more, *less;
} differences[] = {
  { STOPS, true, "onset of sticking: body %d in the %s", "end of sticking: body %d in the %s" },
  { ENDS_STUCK, false, "body %d is stuck to the end of the %s", "body %d is released before the end of the %s" },
  { STARTS_STUCK, false, "body %d is stuck from the start of the %s", "body %d slips at the start of the %s" },
  { STOPS, false, "body %d sticks more often in the %s", "body %d sticks less often in the %s" },
  { TURNS, true, "body %d begins to turn in the %s", "body %d ceases to turn in the %s" },
  { TURNS, false, "body %d turns more often in the %s", "body %d turns less often in the %s" },
};
enum { OF_STOPS = 4, OF_TURNS = 2 };

static void add_differences(char *text, const struct difference *first, int count, const struct answer *before,
                            const struct answer *after)
{
  for (int i = 0; i < 4; i++) {
    int a[COUNTS], b[COUNTS], phase = i / 2, body = i % 2 + 1;
    const struct difference *d = first;
    count_changes(a, &before->modes[phase], body);
    count_changes(b, &after->modes[phase], body);
    while (d < first + count && (a[d->of] == b[d->of] || (d->with_zero && a[d->of] > 0 && b[d->of] > 0)))
      d++;
    if (d < first + count)
      add_cause(text, b[d->of] > a[d->of] ? d->more : d->less, body, phase_names[phase]);
  }
}

/* Returns the sign of the common velocity at the start of a phase; 0: from rest */
static int start_sign(const struct answer *s, int phase)
{
  const struct scallop_modes *m = &s->modes[phase];
  double v = s->value[Q_V_START].high;
  if (phase == 0)
    return (v > 0) - (v < 0);
  return m->count > 0 && m->kept[0].s1 == m->kept[0].s2 ? m->kept[0].s1 : 0;
}

static void add_signs(char *text, const struct answer *before, const struct answer *after)
{
  for (int phase = 0; phase < 2; phase++) {
    int a = start_sign(before, phase), b = start_sign(after, phase);
    if (a * b < 0)
      add_cause(text, "%s velocity changes sign", phase == 0 ? "start" : "mid");
    else if (a != b)
      add_cause(text, "the %s %s from rest", phase_names[phase], b == 0 ? "begins" : "no longer begins");
  }
}

/* Returns the body that never moves, or 0. */
static int resting_body(const struct answer *s)
{
  int extension[COUNTS], contraction[COUNTS];
  count_changes(extension, &s->modes[0], 1);
  count_changes(contraction, &s->modes[1], 1);
  return s->regime != SCALLOP_AT_REST ? 0 : extension[MOVES] + contraction[MOVES] == 0 ? 1 : 2;
}

/* Returns true if each body moves as the other one did, in the opposite direction. */
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
    add_cause(text, "no change of modes");
  else if (mirror_each_other(before, after)) /* F1 = F2 or alpha = 1/2: the direction of crawling reverses */
    add_cause(text, "the bodies exchange their roles");
  else if (was != is) {
    if (was != 0)
      add_cause(text, "end of the permanent rest of body %d", was);
    if (is != 0)
      add_cause(text, "permanent rest of body %d", is);
  } else
    add_differences(text, differences, OF_STOPS, before, after);
  if (!*text)
    add_signs(text, before, after);
  if (!*text)
    add_differences(text, differences + OF_STOPS, OF_TURNS, before, after);
  if (!*text)
    add_cause(text, "the order of the modes");
  return text;
}
