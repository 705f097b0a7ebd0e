#include "compare/breakdown/events.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/breakdown/series.h"
#include "compare/text/halfway.h"
#include "compare/text/memory.h"
#include "compare/text/progress.h"

/* T by steps of 2^(1/PER_OCTAVE): what begins and ends again within a step is not seen. */
enum { PER_OCTAVE = 256, OCTAVES_BELOW = 24 };
/* Doubles tell the modes apart down to this distance from a change, and binary128 settles the rest. */
static const double NARROW = 1e-13, WIDE = 1e-10;
/* As near to a change as modes are proven: nearer to where a mode vanishes that takes seconds. */
static const double PROVEN = 0x1p-40;

/* What a motion is made of: it changes where the expansion ends. */
struct signature {
  struct answer answer;
  const struct scallop_piece *piece[2][SCALLOP_MODES_KEPT]; /* in which a mode begins; NULL: not known */
};

/* The parts of a phase are the pieces, but where l' goes on with the same analytic function two pieces are one part:
 * number of the one that holds the piece. */
static int part_of(const struct scallop_shape *shape, const struct scallop_piece *piece)
{
  int part = 0;
  bool turned;
  for (const struct scallop_piece *p = shape->pieces + 1; p <= piece; p++)
    part += p->direction != p[-1].direction || !scallop_piece_goes_on(p - 1, p, &turned);
  return part;
}

static int phases_of(const struct motion *m) { return m->of == OF_STEADY ? 2 : 1; }

/* Of a motion's phase number 0 or 1 */
static enum scallop_phase_kind kind_of(const struct motion *m, int phase)
{
  return m->of == OF_STEADY ? (enum scallop_phase_kind)phase : m->phase;
}

struct collector {
  struct scallop_modes *modes;
  const struct scallop_piece **piece;
  const struct scallop_shape *shape;
};

static void collect(void *context, const struct scallop_interval *interval)
{
  const struct collector *c = context;
  int n = c->modes->count;
  const struct scallop_mode *last = n > 0 ? &c->modes->kept[n - 1] : NULL;
  if (n == SCALLOP_MODES_KEPT || (last && last->s1 == interval->mode.s1 && last->s2 == interval->mode.s2))
    return;
  c->modes->kept[n] = interval->mode;
  c->piece[n] = n ? interval->piece : c->shape->pieces;
  c->modes->count++;
}

/* Phases that start from the rounded velocities of a steady state may have other modes than the steady state: then the
 * pieces are not known. */
static bool signature_at(struct signature *out, const struct motion *motion, double T)
{
  const struct motion m = motion_at(motion, T);
  struct answer *a = &out->answer;
  struct scallop_modes walked[2] = { { 0 } };
  if (!answer_in_double(a, &m))
    return false;
  for (int phase = 0; phase < phases_of(&m); phase++) {
    enum scallop_phase_kind kind = kind_of(&m, phase);
    struct collector collector = { &walked[phase], out->piece[phase], &m.crawler.gait->phase[kind] };
    double v = m.of == OF_PHASE ? m.v0 : a->value[phase == 0 ? Q_V_START : Q_V_MID].high;
    if (scallop_phase_intervals(&m.crawler, kind, v, collect, &collector) < 0)
      return false;
  }
  if (!same_modes(walked, a->modes))
    memset(out->piece, 0, sizeof out->piece);
  return true;
}

/* The first of the modes, counted through the phases, that begins in another part than before; -1: none does. Of the
 * same modes. */
static int moved(const struct motion *m, const struct signature *a, const struct signature *b)
{
  for (int phase = 0; phase < phases_of(m); phase++)
    for (int i = 0; i < a->answer.modes[phase].count && i < SCALLOP_MODES_KEPT; i++) {
      const struct scallop_shape *shape = &m->crawler.gait->phase[kind_of(m, phase)];
      const struct scallop_piece *p = a->piece[phase][i], *q = b->piece[phase][i];
      if (p && q && part_of(shape, p) != part_of(shape, q))
        return phase * SCALLOP_MODES_KEPT + i;
    }
  return -1;
}

static bool same(const struct motion *m, const struct signature *a, const struct signature *b)
{
  return same_modes(a->answer.modes, b->answer.modes) && a->answer.regime == b->answer.regime && moved(m, a, b) < 0;
}

/* Halves [*low, *high] until they are neighbours. Of a change of modes in binary128; that a switching time leaves its
 * part no mode shows, so that doubles have to do. */
static void settle(double *low, double *high, const struct motion *m, const struct signature *before, bool of_modes)
{
  const struct scallop_modes *modes = before->answer.modes;
  struct signature middle;
  for (double T; halfway(&T, *low, *high);) {
    bool is_before = of_modes ? motion_in_wide(m, T, &middle.answer) && same_modes(middle.answer.modes, modes)
                              : signature_at(&middle, m, T) && same(m, &middle, before);
    *(is_before ? low : high) = T;
  }
}

/* The sign of the displacement, or 0 */
static int way(const struct answer *a)
{
  double x = a->value[Q_DISPLACEMENT].high;
  return (x > 0) - (x < 0);
}

/* Are these proven to be the modes at T, or, of a sign that is not 0, is that of the displacement? */
static bool is_certified(const struct motion *m, double T, const struct signature *s, int sign)
{
  enum { DIGITS = 6, DIGITS_OF_SIGN = 20 };
  const struct motion at = motion_at(m, T);
  SCOPED(ball_answer, a);
  if (!answer_of_doubles(&a, &at, sign == 0 ? DIGITS : DIGITS_OF_SIGN))
    return false;
  const arb_struct *displacement = a.value[Q_DISPLACEMENT];
  return sign == 0 ? same_modes(a.modes, s->answer.modes)
                   : displacement && (sign > 0 ? arb_is_positive : arb_is_negative)(displacement);
}

/* A body turns, stops or starts in another part than before */
static void describe_move(struct event *e, const struct motion *m, const struct signature *before,
                          const struct signature *after)
{
  int place = moved(m, before, after), phase = place / SCALLOP_MODES_KEPT, i = place % SCALLOP_MODES_KEPT;
  enum scallop_phase_kind kind = kind_of(m, phase);
  const struct scallop_shape *shape = &m->crawler.gait->phase[kind];
  const struct scallop_mode *to = &after->answer.modes[phase].kept[i], *from = to - (i > 0);
  int body = to->s1 != from->s1 ? 1 : 2, was = body == 1 ? from->s1 : from->s2, is = body == 1 ? to->s1 : to->s2;
  snprintf(e->what, sizeof e->what, "body %d %s in the %s during piece %d of the gait, no longer during piece %d", body,
           is == 0    ? "stops"
           : was == 0 ? "starts"
                      : "turns",
           kind == SCALLOP_EXTENSION ? "extension" : "contraction", part_of(shape, after->piece[phase][i]) + 1,
           part_of(shape, before->piece[phase][i]) + 1);
}

static void describe(struct event *e, const struct motion *m, const struct signature *before,
                     const struct signature *after)
{
  struct answer was = before->answer, is = after->answer;
  e->of_modes = !same_modes(was.modes, is.modes) || was.regime != is.regime;
  if (!e->of_modes) {
    describe_move(e, m, before, after);
    return;
  }
  if (kind_of(m, 0) == SCALLOP_CONTRACTION) { /* the extension has no modes */
    was.modes[1] = was.modes[0], is.modes[1] = is.modes[0];
    was.modes[0].count = is.modes[0].count = 0;
  }
  mode_change_text(e->what, &was, &is);
}

/* Does the body turn in the same part at these T, too, up or down from T? Where rounding decides, it does not. Of other
 * modes nothing is said. */
static bool stays(const struct motion *m, double T, double step, const struct signature *s)
{
  struct signature there;
  int k = 1;
  while (k <= 8 && signature_at(&there, m, T * (1 + k * step))
         && (!same_modes(there.answer.modes, s->answer.modes) || moved(m, s, &there) < 0))
    k++;
  return k > 8;
}

/* Something changes between low and high, which are close. Events that doubles cannot tell apart are one, and what is
 * none in binary128, nor somewhat farther off, is rounding. */
static void enter(struct events *events, const struct motion *m, double low, double high)
{
  struct signature before, after;
  struct answer exact[2];
  const double last = events->count > 0 ? events->event[events->count - 1].T : 0, aside = 0x1p-24;
  low *= 1 - WIDE;
  high *= 1 + WIDE;
  if (low <= last || !signature_at(&before, m, low) || !signature_at(&after, m, high) || same(m, &before, &after))
    return;
  bool of_modes = !same_modes(before.answer.modes, after.answer.modes), wide = of_modes, changes = false;
  for (double by = WIDE; wide && !changes && by < 1e-6 && low > last; by *= 4) {
    wide = motion_in_wide(m, low, &exact[0]) && motion_in_wide(m, high, &exact[1]);
    changes = wide && !same_modes(exact[0].modes, exact[1].modes);
    low *= changes ? 1 : 1 - by;
    high *= changes ? 1 : 1 + by;
  }
  if (wide)
    before.answer = exact[0], after.answer = exact[1];
  if (of_modes ? wide && !changes : !stays(m, low, -aside, &before) || !stays(m, high, aside, &after))
    return;
  struct event *larger = with_room(events->event, events->count, sizeof *larger);
  if (!larger)
    return;
  events->event = larger;
  struct event *e = &events->event[events->count++];
  *e = (struct event){ .T = low + (high - low) / 2, .status = "double" };
  memcpy(e->modes, after.answer.modes, sizeof e->modes);
  describe(e, m, &before, &after);
  if (of_modes && !wide)
    return;
  settle(&low, &high, m, &before, of_modes);
  e->T = low;
  if (of_modes) {
    bool proven = is_certified(m, low * (1 - PROVEN), &before, 0) && is_certified(m, low * (1 + PROVEN), &after, 0);
    e->status = proven ? "certified" : "binary128";
  }
}

static void search(struct events *events, const struct motion *m, double low, double high,
                   const struct signature *at_low, const struct signature *at_high)
{
  struct signature middle;
  double T = sqrt(low) * sqrt(high);
  if (same(m, at_low, at_high))
    return;
  if (high - low <= NARROW * high || !(T > low && T < high) || !signature_at(&middle, m, T)) {
    enter(events, m, low, high);
    return;
  }
  search(events, m, low, T, at_low, &middle);
  search(events, m, T, high, &middle, at_high);
}

static int way_in_wide(const struct motion *m, double T)
{
  struct answer a;
  return motion_in_wide(m, T, &a) ? way(&a) : 0;
}

/* Where the crawler turns back between low and high, if it does */
static void find_reversal(struct events *events, const struct motion *m, double low, double high,
                          const struct signature *at_low, const struct signature *at_high)
{
  int before = m->of == OF_STEADY ? way(&at_low->answer) : 0, after = way(&at_high->answer);
  if (before * after >= 0 || way_in_wide(m, low) != before || way_in_wide(m, high) != after)
    return;
  struct reversal *larger = with_room(events->reversal, events->reversals, sizeof *larger);
  if (!larger)
    return;
  events->reversal = larger;
  for (double T; halfway(&T, low, high);)
    *(way_in_wide(m, T) == before ? &low : &high) = T;
  bool proven = is_certified(m, low * (1 - PROVEN), at_low, before)
                && is_certified(m, low * (1 + PROVEN), at_high, after);
  events->reversal[events->reversals++] = (struct reversal){ low, after, proven ? "certified" : "binary128" };
}

/* From where the modes are those of T -> 0; false: there is nothing there. */
static bool begin(struct events *events, const struct motion *m, const char *limit_modes, struct signature *low)
{
  char text[MOTION_MODES_TEXT];
  for (int i = 0; i < 8; i++) {
    if (!signature_at(low, m, events->from))
      return false;
    motion_modes_text(text, m->of, low->answer.modes);
    if (*limit_modes == '\0' || strcmp(text, limit_modes) == 0)
      break;
    events->from = ldexp(events->from, -OCTAVES_BELOW);
  }
  memcpy(events->first, low->answer.modes, sizeof events->first);
  return true;
}

void events_find(struct events *events, const struct motion *m, const char *limit_modes)
{
  struct signature low, high;
  *events = (struct events){ .from = ldexp(motion_natural_time(m), -OCTAVES_BELOW), .until = motion_last_time(m) };
  bool going = begin(events, m, limit_modes, &low);
  double before = events->from;
  long steps = (long)ceil(PER_OCTAVE * log2(events->until / events->from));
  const bool counts = !progress_is_counted(); /* else points are */
  for (long i = 1; going && i <= steps; i++) {
    if (counts)
      progress_count(i, steps);
    double T = events->from * exp2((double)i / PER_OCTAVE);
    going = signature_at(&high, m, T);
    if (going) {
      search(events, m, before, T, &low, &high);
      find_reversal(events, m, before, T, &low, &high);
    } else
      events->until = before;
    low = high;
    before = T;
  }
  if (counts)
    progress_count(0, 0);
}

void events_clear(struct events *events)
{
  free(events->event);
  free(events->reversal);
}
