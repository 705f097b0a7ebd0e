/* What ends the expansion: where the sequence of modes changes as T grows, and where a body turns in another piece of the gait. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/breakdown/parts.h"
#include "numerics/certified.h"

/* T by steps of 2^(1/PER_OCTAVE): what begins and ends again within a step is not seen. */
enum { PER_OCTAVE = 256, OCTAVES_BELOW = 24 };
/* Doubles tell the modes apart down to this distance from a change, and binary128 settles the rest. */
static const double NARROW = 1e-13, WIDE = 1e-10;
/* As near to a change as modes are proven: nearer to where a mode vanishes that takes seconds. */
static const double PROVEN = 0x1p-40;

/* What a motion is made of: it changes where the expansion ends. */
struct signature {
  struct scallop_modes modes[2];
  enum scallop_regime regime;
  int part[2 * SCALLOP_MODES_KEPT]; /* of the phase, in which a mode begins                          */
  double v_start, v_mid;
};

/* ---- the signature at T ---- */

struct finder {
  const struct subject *subject;
  struct events *events;
  int *part[2]; /* of each piece of the phases: where l' goes on with the same analytic function two pieces are one part */
};

static bool finder_init(struct finder *f, const struct subject *subject, struct events *events)
{
  *f = (struct finder){ .subject = subject, .events = events };
  for (int kind = 0; kind < 2; kind++) {
    const struct scallop_shape *shape = &subject->crawler.gait->phase[kind];
    f->part[kind] = calloc((size_t)shape->count, sizeof *f->part[kind]);
    if (!f->part[kind])
      return false;
    for (int i = 1; i < shape->count; i++) {
      const struct scallop_piece *p = &shape->pieces[i];
      bool turned, goes_on = p->direction == p[-1].direction && scallop_piece_goes_on(p - 1, p, &turned);
      f->part[kind][i] = f->part[kind][i - 1] + !goes_on;
    }
  }
  return true;
}

static void finder_clear(struct finder *f)
{
  free(f->part[0]);
  free(f->part[1]);
}

struct collector {
  const struct finder *finder;
  struct signature *signature;
  enum scallop_phase_kind kind;
  int phase; /* which of the subject's                                                      */
};

static void collect(void *context, const struct scallop_interval *interval)
{
  const struct collector *c = context;
  const struct scallop_piece *first = c->finder->subject->crawler.gait->phase[c->kind].pieces;
  struct scallop_modes *modes = &c->signature->modes[c->phase];
  int n = modes->count;
  if (n > 0 && modes->kept[n - 1].s1 == interval->mode.s1 && modes->kept[n - 1].s2 == interval->mode.s2)
    return;
  if (n == SCALLOP_MODES_KEPT)
    return;
  modes->kept[n] = interval->mode;
  c->signature->part[c->phase * SCALLOP_MODES_KEPT + n] = n ? c->finder->part[c->kind][interval->piece - first] : 0;
  modes->count++;
}

static bool signature_at(struct signature *out, const struct finder *f, double T)
{
  const struct subject *s = f->subject;
  struct answer e;
  memset(out, 0, sizeof *out); /* signatures are compared byte by byte */
  subject_in_double(s, T, &e);
  if (e.status < 0)
    return false;
  out->regime = e.regime;
  out->v_start = s->steady ? e.value[Q_V_START].high : s->v0;
  out->v_mid = s->steady ? e.value[Q_V_MID].high : s->v0;
  struct scallop_crawler c = subject_crawler(s, T);
  for (int phase = 0; phase < (s->steady ? 2 : 1); phase++) {
    enum scallop_phase_kind kind = s->steady ? (enum scallop_phase_kind)phase : s->kind;
    struct collector collector = { f, out, kind, phase };
    if (scallop_phase_intervals(&c, kind, phase == 0 ? out->v_start : out->v_mid, collect, &collector) < 0)
      return false;
  }
  return true;
}

static bool same(const struct signature *a, const struct signature *b)
{
  return same_modes(a->modes, b->modes) && a->regime == b->regime && memcmp(a->part, b->part, sizeof a->part) == 0;
}

/* ---- one event ---- */

/* Modes in binary128. Once kept, at most SCALLOP_MODES_KEPT are compared. */
static bool modes_in_wide(struct scallop_modes modes[2], const struct subject *s, double T)
{
  struct answer e;
  subject_in_wide(s, T, &e);
  modes[0] = e.modes[0];
  modes[1] = e.modes[1];
  return e.status >= 0;
}

/* Halves [*low, *high] in binary128 until they are neighbours. False: the modes there are not those that doubles saw outside. */
static bool settle(double *low, double *high, const struct subject *s, const struct signature *before,
                   const struct signature *after)
{
  struct scallop_modes modes[2];
  if (!modes_in_wide(modes, s, *low) || !same_modes(modes, before->modes) || !modes_in_wide(modes, s, *high)
      || !same_modes(modes, after->modes))
    return false;
  for (double T; (T = *low + (*high - *low) / 2) > *low && T < *high;) {
    if (!modes_in_wide(modes, s, T))
      return false;
    *(same_modes(modes, before->modes) ? low : high) = T;
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

/* The modes a little below and above are proven to be these. */
static bool is_certified(const struct subject *s, double T, const struct signature *before, const struct signature *after)
{
  struct scallop_modes modes[2];
  return certified_modes(modes, s, T * (1 - PROVEN)) && same_modes(modes, before->modes)
         && certified_modes(modes, s, T * (1 + PROVEN)) && same_modes(modes, after->modes);
}

/* A body turns in another piece than before: which one, in which phase. */
static void tell_place(char *text, size_t size, const struct subject *s, const struct signature *before,
                       const struct signature *after)
{
  static const char *const phase_text[] = { "extension", "contraction" };
  for (int i = 0; i < 2 * SCALLOP_MODES_KEPT; i++) {
    int phase = s->steady ? i / SCALLOP_MODES_KEPT : (int)s->kind, n = i % SCALLOP_MODES_KEPT;
    if (before->part[i] == after->part[i])
      continue;
    snprintf(text, size, "switching time %d of the %s moves from piece %d of l' to piece %d", n, phase_text[phase],
             before->part[i] + 1, after->part[i] + 1);
    return;
  }
}

static void describe(struct event *e, const struct subject *s, const struct signature *before, const struct signature *after)
{
  if (same_modes(before->modes, after->modes) && before->regime == after->regime) {
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
static double settle_place(const struct finder *f, double low, double high, const struct signature *before)
{
  struct signature middle;
  for (double T; (T = low + (high - low) / 2) > low && T < high && signature_at(&middle, f, T);)
    *(same(&middle, before) ? &low : &high) = T;
  return low;
}

/* Room for one more, or NULL. */
static struct event *new_event(struct events *events)
{
  if (events->count == events->room) {
    int room = events->room ? 2 * events->room : 16;
    struct event *larger = realloc(events->event, (size_t)room * sizeof *larger);
    if (!larger)
      return NULL;
    events->event = larger;
    events->room = room;
  }
  return &events->event[events->count++];
}

/* Something changes between low and high, which are close. Events that doubles cannot tell apart are one. */
static void enter(struct finder *f, double low, double high)
{
  struct events *events = f->events;
  const struct subject *s = f->subject;
  struct signature before, after;
  struct event *e;
  low *= 1 - WIDE;
  high *= 1 + WIDE;
  if ((events->count > 0 && low <= events->event[events->count - 1].T) || !signature_at(&before, f, low)
      || !signature_at(&after, f, high) || same(&before, &after) || !(e = new_event(events)))
    return;
  e->status = "double";
  e->T = low + (high - low) / 2;
  e->modes[0] = after.modes[0];
  e->modes[1] = after.modes[1];
  e->regime = after.regime;
  describe(e, s, &before, &after);
  if (same_modes(before.modes, after.modes)) {
    e->T = settle_place(f, low, high, &before);
    return;
  }
  if (settle(&low, &high, s, &before, &after)) {
    e->T = low;
    e->status = is_certified(s, low, &before, &after) ? "certified" : "binary128";
  }
}

static void search(struct finder *f, double low, double high, const struct signature *at_low,
                   const struct signature *at_high)
{
  struct signature middle;
  double T = sqrt(low) * sqrt(high);
  if (same(at_low, at_high))
    return;
  if (high - low <= NARROW * high || !(T > low && T < high) || !signature_at(&middle, f, T)) {
    enter(f, low, high);
    return;
  }
  search(f, low, T, at_low, &middle);
  search(f, T, high, &middle, at_high);
}

/* From where the modes are those of T -> 0; false: there is nothing there. */
static bool begin(struct finder *f, const char *limit_modes, struct signature *low)
{
  char text[2 * SCALLOP_MODES_TEXT + 4];
  struct events *events = f->events;
  for (int i = 0; i < 8; i++) {
    if (!signature_at(low, f, events->from))
      return false;
    motion_modes_text(text, f->subject->steady ? OF_STEADY : OF_PHASE, low->modes);
    if (*limit_modes == '\0' || strcmp(text, limit_modes) == 0)
      break;
    events->from = ldexp(events->from, -OCTAVES_BELOW);
  }
  events->first[0] = low->modes[0];
  events->first[1] = low->modes[1];
  events->regime = low->regime;
  return true;
}

void events_find(struct events *events, const struct subject *s, const char *limit_modes)
{
  struct finder f;
  struct signature low, high;
  *events = (struct events){ .from = ldexp(subject_natural_time(s), -OCTAVES_BELOW), .until = subject_last_time(s) };
  bool going = finder_init(&f, s, events) && begin(&f, limit_modes, &low);
  double before = events->from;
  long steps = (long)ceil(PER_OCTAVE * log2(events->until / events->from));
  for (long i = 1; going && i <= steps; i++) {
    double T = events->from * exp2((double)i / PER_OCTAVE);
    going = signature_at(&high, &f, T);
    if (going)
      search(&f, before, T, &low, &high);
    else
      events->until = before;
    low = high;
    before = T;
  }
  finder_clear(&f);
}

void events_clear(struct events *events) { free(events->event); }
