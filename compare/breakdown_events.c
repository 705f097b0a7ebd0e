/* What ends the expansion: where the sequence of modes changes as T grows, and where a body turns in another piece of the gait. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/breakdown_parts.h"
#include "numerics/certified.h"

/* T by steps of 2^(1/PER_OCTAVE): what begins and ends again within a step is not seen. */
enum { PER_OCTAVE = 256, OCTAVES_BELOW = 24 };
/* Doubles tell the modes apart down to this distance from a change, and binary128 settles the rest. */
static const double NARROW = 1e-13, WIDE = 1e-10;

struct place { /* where a mode begins: in which of the pieces                                      */
  int phase, piece;
};

/* What a motion is made of: it changes where the expansion ends. */
struct signature {
  struct scallop_modes modes[2];
  enum scallop_regime regime;
  struct place place[2 * SCALLOP_MODES_KEPT];
  double v_start, v_mid;
};

/* ---- the signature at T ---- */

struct collector {
  struct signature *signature;
  const struct scallop_shape *shape;
  int phase;
};

/* Where l' goes on with the same analytic function two pieces are one. */
static int analytic_piece(const struct scallop_shape *shape, const struct scallop_piece *piece)
{
  int n = 0;
  bool turned;
  for (const struct scallop_piece *p = shape->pieces; p != piece; p++)
    n += p->direction != p[1].direction || !scallop_piece_goes_on(p, p + 1, &turned);
  return n;
}

static void collect(void *context, const struct scallop_interval *interval)
{
  const struct collector *c = context;
  struct scallop_modes *modes = &c->signature->modes[c->phase];
  int n = modes->count;
  if (n > 0 && modes->kept[n - 1].s1 == interval->mode.s1 && modes->kept[n - 1].s2 == interval->mode.s2)
    return;
  if (n == SCALLOP_MODES_KEPT)
    return;
  modes->kept[n] = interval->mode;
  c->signature->place[c->phase * SCALLOP_MODES_KEPT + n].piece = n ? analytic_piece(c->shape, interval->piece) : 0;
  modes->count++;
}

static bool signature_at(struct signature *out, const struct subject *s, double T)
{
  struct exact e;
  memset(out, 0, sizeof *out); /* signatures are compared byte by byte */
  exact_in_double(s, T, &e);
  if (e.status < 0)
    return false;
  out->regime = e.regime;
  out->v_start = s->steady ? e.value[OF_V_START].high : s->v0;
  out->v_mid = s->steady ? e.value[OF_V_MID].high : s->v0;
  struct scallop_crawler c = subject_crawler(s, T);
  for (int phase = 0; phase < (s->steady ? 2 : 1); phase++) {
    enum scallop_phase_kind kind = s->steady ? (enum scallop_phase_kind)phase : s->kind;
    struct collector collector = { out, &c.gait->phase[kind], phase };
    if (scallop_phase_intervals(&c, kind, phase == 0 ? out->v_start : out->v_mid, collect, &collector) < 0)
      return false;
  }
  return true;
}

static bool same(const struct signature *a, const struct signature *b)
{
  return subject_same_modes(a->modes, b->modes) && a->regime == b->regime
         && memcmp(a->place, b->place, sizeof a->place) == 0;
}

/* ---- one event ---- */

/* Modes in binary128. Once kept, at most SCALLOP_MODES_KEPT are compared. */
static bool modes_in_wide(struct scallop_modes modes[2], const struct subject *s, double T)
{
  struct exact e;
  exact_in_wide(s, T, &e);
  modes[0] = e.modes[0];
  modes[1] = e.modes[1];
  return e.status >= 0;
}

/* Halves [*low, *high] in binary128 until they are neighbours. False: the modes there are not those that doubles saw outside. */
static bool settle(double *low, double *high, const struct subject *s, const struct signature *before,
                   const struct signature *after)
{
  struct scallop_modes modes[2];
  if (!modes_in_wide(modes, s, *low) || !subject_same_modes(modes, before->modes) || !modes_in_wide(modes, s, *high)
      || !subject_same_modes(modes, after->modes))
    return false;
  for (double T; (T = *low + (*high - *low) / 2) > *low && T < *high;) {
    if (!modes_in_wide(modes, s, T))
      return false;
    *(subject_same_modes(modes, before->modes) ? low : high) = T;
  }
  return true;
}

static bool certified_modes(struct scallop_modes modes[2], const struct subject *s, double T)
{
  enum { DIGITS = 6 };
  struct scallop_crawler c = subject_crawler(s, T);
  struct scallop_rational_crawler exact;
  fmpq_t v0;
  bool done;
  fmpq_init(v0);
  scallop_rational_init(&exact);
  scallop_rational_of(&exact, &c);
  modes[1].count = 0;
  if (s->steady) {
    struct scallop_certified_steady r;
    scallop_certified_steady_init(&r);
    done = scallop_certified_steady(&exact, DIGITS, &r, NULL) == SCALLOP_OK;
    modes[0] = r.modes[0];
    modes[1] = r.modes[1];
    scallop_certified_steady_clear(&r);
  } else {
    struct scallop_certified_phase r;
    scallop_rational_set_double(v0, s->v0);
    scallop_certified_phase_init(&r);
    done = scallop_certified_phase(&exact, s->kind, v0, DIGITS, &r, NULL) == SCALLOP_OK;
    modes[0] = r.modes;
    scallop_certified_phase_clear(&r);
  }
  scallop_rational_clear(&exact);
  fmpq_clear(v0);
  return done;
}

/* The modes a little below and above are proven to be these. A little: nearer to where a mode vanishes the proof takes seconds. */
static bool is_certified(const struct subject *s, double T, const struct signature *before, const struct signature *after)
{
  static const double off = 0x1p-47;
  struct scallop_modes modes[2];
  return certified_modes(modes, s, T * (1 - off)) && subject_same_modes(modes, before->modes)
         && certified_modes(modes, s, T * (1 + off)) && subject_same_modes(modes, after->modes);
}

/* A body turns in another piece than before: which one, in which phase. */
static void tell_place(char *text, size_t size, const struct subject *s, const struct signature *before,
                       const struct signature *after)
{
  static const char *const phase_text[] = { "extension", "contraction" };
  for (int i = 0; i < 2 * SCALLOP_MODES_KEPT; i++) {
    int phase = s->steady ? i / SCALLOP_MODES_KEPT : (int)s->kind, n = i % SCALLOP_MODES_KEPT;
    if (before->place[i].piece == after->place[i].piece)
      continue;
    snprintf(text, size, "switching time %d of the %s moves from piece %d of l' to piece %d", n, phase_text[phase],
             before->place[i].piece + 1, after->place[i].piece + 1);
    return;
  }
}

static void describe(struct event *e, const struct subject *s, const struct signature *before, const struct signature *after)
{
  if (subject_same_modes(before->modes, after->modes) && before->regime == after->regime) {
    tell_place(e->what, sizeof e->what, s, before, after);
    return;
  }
  struct scallop_modes modes[2][2] = { { { .count = 0 } } }; /* of a phase alone: the other one has none */
  int first = s->steady ? 0 : (int)s->kind;
  for (int phase = 0; phase < (s->steady ? 2 : 1); phase++) {
    modes[0][first + phase] = before->modes[phase];
    modes[1][first + phase] = after->modes[phase];
  }
  const struct mode_state states[2] = { { modes[0], before->regime, before->v_start },
                                        { modes[1], after->regime, after->v_start } };
  mode_change_text(e->what, &states[0], &states[1]);
}

/* A switching time that leaves its piece: no mode shows it, so that doubles have to do. */
static double settle_place(const struct subject *s, double low, double high, const struct signature *before)
{
  struct signature middle;
  for (double T; (T = low + (high - low) / 2) > low && T < high && signature_at(&middle, s, T);)
    *(same(&middle, before) ? &low : &high) = T;
  return low;
}

/* Something changes between low and high, which are close. Events that doubles cannot tell apart are one. */
static void enter(struct events *events, const struct subject *s, double low, double high)
{
  struct signature before, after;
  low *= 1 - WIDE;
  high *= 1 + WIDE;
  if (events->count == MOST_EVENTS || (events->count > 0 && low <= events->event[events->count - 1].T)
      || !signature_at(&before, s, low) || !signature_at(&after, s, high) || same(&before, &after))
    return;
  struct event *e = &events->event[events->count++];
  e->status = "double";
  e->T = low + (high - low) / 2;
  e->modes[0] = after.modes[0];
  e->modes[1] = after.modes[1];
  e->regime = after.regime;
  describe(e, s, &before, &after);
  if (subject_same_modes(before.modes, after.modes)) {
    e->T = settle_place(s, low, high, &before);
    return;
  }
  if (settle(&low, &high, s, &before, &after)) {
    e->T = low;
    e->status = is_certified(s, low, &before, &after) ? "certified" : "binary128";
  }
}

static void search(struct events *events, const struct subject *s, double low, double high, const struct signature *at_low,
                   const struct signature *at_high)
{
  struct signature middle;
  double T = sqrt(low) * sqrt(high);
  if (same(at_low, at_high))
    return;
  if (high - low <= NARROW * high || !(T > low && T < high) || !signature_at(&middle, s, T)) {
    enter(events, s, low, high);
    return;
  }
  search(events, s, low, T, at_low, &middle);
  search(events, s, T, high, &middle, at_high);
}

void events_find(struct events *events, const struct subject *s, const char *limit_modes)
{
  struct signature low, high;
  char text[2 * SCALLOP_MODES_TEXT + 4];
  double natural = subject_natural_time(s);
  *events = (struct events){ .from = ldexp(natural, -OCTAVES_BELOW), .until = subject_last_time(s) };
  for (int i = 0; i < 8; i++) { /* where the modes are those of T -> 0 */
    if (!signature_at(&low, s, events->from))
      return;
    subject_modes_text(s, low.modes, text);
    if (*limit_modes == '\0' || strcmp(text, limit_modes) == 0)
      break;
    events->from = ldexp(events->from, -OCTAVES_BELOW);
  }
  events->first[0] = low.modes[0];
  events->first[1] = low.modes[1];
  events->regime = low.regime;
  long steps = (long)ceil(PER_OCTAVE * log2(events->until / events->from));
  double before = events->from;
  for (long i = 1; i <= steps; i++) {
    double T = events->from * exp2((double)i / PER_OCTAVE);
    if (!signature_at(&high, s, T)) {
      events->until = before;
      return;
    }
    search(events, s, before, T, &low, &high);
    low = high;
    before = T;
  }
}
