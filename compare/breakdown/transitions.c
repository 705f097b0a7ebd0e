/* Transitions along T: changes of modes, of the part of the gait where a body turns, of the direction of crawling. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/answer.h"
#include "compare/formulas/formula_file.h"
#include "compare/breakdown/motion.h"
#include "compare/points/gaits.h"
#include "compare/text/digits.h"
#include "compare/text/memory.h"
#include "compare/text/progress.h"

/* T increases by steps of 2^(1/PER_OCTAVE); a change that is undone within a step is missed. */
enum { PER_OCTAVE = 256, OCTAVES_BELOW = 24, OF_RECORDED = 64, BELOW_OF_RECORDED = 8 };
/* Relative distance from a change down to which doubles distinguish the modes; binary128 does the rest */
static const double NARROW = 1e-10;
/* Relative distance from a change at which modes are proven; nearer to the end of a mode a proof takes seconds */
static const double PROVEN = 0x1p-40;

/* Modes of a motion, and the parts of the gait: they change at a transition. A single phase has index 0. */
struct signature {
  const struct motion *motion;
  double T;
  struct answer answer;
  int part[2][SCALLOP_MODES_KEPT]; /* of the gait, in which a mode begins, from 1 on; 0: not known */
};

static enum scallop_phase_kind kind_of(const struct motion *m, int phase)
{
  return m->of == OF_STEADY ? (enum scallop_phase_kind)phase : m->phase;
}

/* Returns the number of the part with this piece. Parts of a phase are its pieces, except that neighbours with the same
 * analytic function l' are one part. */
static int part_of(const struct scallop_shape *shape, const struct scallop_piece *piece)
{
  int part = 1;
  bool turned;
  for (const struct scallop_piece *p = shape->pieces + 1; p <= piece; p++)
    part += p->direction != p[-1].direction || !scallop_piece_continues(p - 1, p, &turned);
  return part;
}

/* Computes the signature at T. A phase from the rounded velocity of a steady state may have other modes than the steady
 * state; the parts are then unknown. */
static bool signature_at(struct signature *s, const struct motion *motion, double T)
{
  const struct motion m = motion_at(motion, T);
  struct scallop_modes found[2] = { { 0 } };
  struct mode_segment segment[MAX_SEGMENTS];
  s->motion = motion;
  s->T = T;
  if (!answer_in_double(&s->answer, &m))
    return false;
  int count = motion_segments(segment, &m, &s->answer);
  for (int i = 0; i < count && i < MAX_SEGMENTS; i++) {
    int phase = m.of == OF_STEADY ? (int)segment[i].phase : 0, n = found[phase].count;
    if (n == SCALLOP_MODES_KEPT)
      continue;
    found[phase].kept[n] = segment[i].mode;
    found[phase].count++;
    s->part[phase][n] = part_of(&m.crawler.gait->phase[segment[i].phase], segment[i].piece);
  }
  if (!same_modes(found, s->answer.modes))
    memset(s->part, 0, sizeof s->part);
  return true;
}

/* Returns the first mode, counted through the phases, that begins in another part; -1 if all begin in the same part. a
 * and b have the same modes. */
static int moved_mode(const struct signature *a, const struct signature *b)
{
  for (int phase = 0; phase < 2; phase++)
    for (int i = 0; i < a->answer.modes[phase].count && i < SCALLOP_MODES_KEPT; i++)
      if (a->part[phase][i] != b->part[phase][i] && a->part[phase][i] > 0 && b->part[phase][i] > 0)
        return phase * SCALLOP_MODES_KEPT + i;
  return -1;
}

/* Returns the sign of the displacement, 0 for a phase. */
static int direction(const struct signature *s)
{
  double x = s->answer.value[Q_DISPLACEMENT].high;
  return (x > 0) - (x < 0);
}

static bool same(enum transition_kind of, const struct signature *a, const struct signature *b)
{
  if (of == CHANGE_OF_DIRECTION)
    return direction(a) == direction(b);
  return same_modes(a->answer.modes, b->answer.modes) && (of == CHANGE_OF_MODES || moved_mode(a, b) < 0);
}

/* Returns true if the motion at T has the signature: modes and direction in binary128, parts in doubles. */
static bool holds(enum transition_kind of, double T, const struct signature *s)
{
  struct signature here;
  bool known = of == CHANGE_OF_PART ? signature_at(&here, s->motion, T) : motion_in_wide(s->motion, T, &here.answer);
  return known && same(of, &here, s);
}

static bool is_proven(enum transition_kind of, double T, const struct signature *s)
{
  const struct motion at = motion_at(s->motion, T);
  SCOPED(ball_answer, a);
  if (of == CHANGE_OF_PART || !answer_of_doubles(&a, &at, of == CHANGE_OF_MODES ? 6 : 20))
    return false;
  const arb_struct *x = a.value[Q_DISPLACEMENT];
  return of == CHANGE_OF_MODES ? same_modes(a.modes, s->answer.modes)
                               : x && (direction(s) > 0 ? arb_is_positive(x) : arb_is_negative(x));
}

/* Bisects down to neighbouring doubles. False: the motions at the ends do not have the signatures found in doubles. */
static bool refine(struct transition *e, const struct signature *before, const struct signature *after)
{
  double low = before->T, high = after->T;
  if (!holds(e->of, low, before) || !holds(e->of, high, after))
    return false;
  for (double T; halfway(&T, low, high);)
    *(holds(e->of, T, before) ? &low : &high) = T;
  bool proven = is_proven(e->of, low * (1 - PROVEN), before) && is_proven(e->of, low * (1 + PROVEN), after);
  e->T = low;
  e->evidence = proven ? "certified" : e->of == CHANGE_OF_PART ? "double" : "binary128";
  return true;
}

/* Returns true if bodies turn in the same parts at several T, upwards or downwards; false if rounding decides. Motions
 * with other modes are ignored. */
static bool stays(const struct signature *s, double step)
{
  struct signature there;
  int k = 1;
  while (k <= 8 && signature_at(&there, s->motion, s->T * (1 + k * step))
         && (!same(CHANGE_OF_MODES, s, &there) || moved_mode(s, &there) < 0))
    k++;
  return k > 8;
}

/* Moves the ends apart, not beyond the last transition, until their modes differ in binary128. False: they do not, and
 * the change was rounding. The ends stay unchanged if binary128 cannot solve the motion. */
static bool differ(struct signature *low, struct signature *high, double last)
{
  struct signature a = *low, b = *high;
  for (double by = NARROW; by < 1e-6 && a.T > last; by *= 4) {
    if (!motion_in_wide(a.motion, a.T, &a.answer) || !motion_in_wide(b.motion, b.T, &b.answer))
      return true;
    if (!same(CHANGE_OF_MODES, &a, &b)) {
      *low = a;
      *high = b;
      return true;
    }
    a.T *= 1 - by;
    b.T *= 1 + by;
  }
  return false;
}

static bool is_rounding(enum transition_kind of, struct signature *low, struct signature *high, double last)
{
  const double aside = 0x1p-24;
  return of == CHANGE_OF_MODES ? !differ(low, high, last) : !stays(low, -aside) || !stays(high, aside);
}

static void describe_change(struct transition *e, const struct signature *before, const struct signature *after)
{
  struct answer was = before->answer, is = after->answer;
  if (kind_of(before->motion, 0) == SCALLOP_CONTRACTION) { /* no extension */
    was.modes[1] = was.modes[0], is.modes[1] = is.modes[0];
    was.modes[0].count = is.modes[0].count = 0;
  }
  mode_change_text(e->causes, &was, &is);
}

/* Describes a body that turns, stops or starts in another part. */
static void describe_move(struct transition *e, const struct signature *before, const struct signature *after)
{
  int place = moved_mode(before, after), phase = place / SCALLOP_MODES_KEPT, i = place % SCALLOP_MODES_KEPT;
  const struct scallop_mode to = after->answer.modes[phase].kept[i],
                            from = after->answer.modes[phase].kept[i - (i > 0)];
  int body = to.s1 != from.s1 ? 1 : 2;
  const char *verb = (body == 1 ? to.s1 : to.s2) == 0       ? "stops"
                     : (body == 1 ? from.s1 : from.s2) == 0 ? "starts"
                                                            : "turns";
  snprintf(e->causes, sizeof e->causes, "body %d %s in the %s during piece %d of the gait, no longer during piece %d",
           body, verb, phase_names[kind_of(before->motion, phase)], after->part[phase][i], before->part[phase][i]);
}

/* Appends a transition; without memory it is lost. */
static void add(struct transition **list, long *count, const struct transition *e)
{
  struct transition *larger = list_grown(*list, *count, sizeof *larger);
  if (!larger)
    return;
  *list = larger;
  larger[(*count)++] = *e;
}

/* Adds the transitions between two signatures. Transitions too close for doubles to separate become one. */
static void find_between(struct transitions *transitions, const struct signature *low, const struct signature *high)
{
  struct signature middle;
  double T = sqrt(low->T) * sqrt(high->T);
  if (same(transitions->finest, low, high))
    return;
  if (high->T - low->T > (transitions->is_rough ? 1e-4 : NARROW) * high->T && signature_at(&middle, low->motion, T)) {
    find_between(transitions, low, &middle);
    find_between(transitions, &middle, high);
    return;
  }
  bool of_modes = !same(CHANGE_OF_MODES, low, high);
  struct transition e = { T, of_modes ? CHANGE_OF_MODES : CHANGE_OF_PART, .evidence = "double", .error = NAN };
  struct signature before = *low, after = *high;
  if (!transitions->is_rough
      && is_rounding(e.of, &before, &after,
                     transitions->count > 0 ? transitions->transition[transitions->count - 1].T : 0))
    return;
  memcpy(e.modes, after.answer.modes, sizeof e.modes);
  (of_modes ? describe_change : describe_move)(&e, &before, &after);
  if (!transitions->is_rough)
    refine(&e, &before, &after);
  add(&transitions->transition, &transitions->count, &e);
}

const struct scallop_modes *transitions_modes_at(const struct transitions *transitions, double T)
{
  long i = 0;
  while (i < transitions->count && transitions->transition[i].T < T)
    i++;
  return i > 0 ? transitions->transition[i - 1].modes : transitions->first;
}

/* Adds the change of the direction of crawling between two signatures, if any. */
static void find_reversal(struct transitions *transitions, const struct signature *low, const struct signature *high)
{
  struct transition e = { .of = CHANGE_OF_DIRECTION, .error = NAN };
  if (transitions->is_rough || direction(low) * direction(high) >= 0 || !refine(&e, low, high))
    return;
  snprintf(e.causes, sizeof e.causes, "the direction of crawling reverses: from here on %s",
           direction(high) > 0 ? "forward" : "backward");
  memcpy(e.modes, transitions_modes_at(transitions, e.T), sizeof e.modes);
  add(&transitions->reversal, &transitions->reversals, &e);
}

static void find_all(struct transitions *transitions, const struct motion *m, int octaves_below,
                     const char *limit_modes)
{
  enum { FARTHEST = 8 }; /* extensions of the range by octaves_below, until its first modes are limit_modes */
  struct signature low, high;
  char text[MOTION_MODES_TEXT];
  transitions->from = ldexp(motion_natural_time(m), -octaves_below);
  transitions->until = motion_last_time(m);
  bool going = signature_at(&low, m, transitions->from);
  for (int i = 0; going && i < FARTHEST && *limit_modes
                  && strcmp(motion_modes_text(text, m->of, low.answer.modes), limit_modes) != 0;
       i++) {
    transitions->from = ldexp(transitions->from, -octaves_below);
    going = signature_at(&low, m, transitions->from);
  }
  memcpy(transitions->first, low.answer.modes, sizeof transitions->first);
  const long steps = (long)ceil(transitions->per_octave * log2(transitions->until / transitions->from));
  const bool counts = !progress_is_counted(); /* else progress counts points */
  for (long i = 1; going && i <= steps; i++) {
    if (counts)
      progress_count(i, steps);
    going = signature_at(&high, m, transitions->from * exp2((double)i / transitions->per_octave));
    if (going) {
      find_between(transitions, &low, &high);
      find_reversal(transitions, &low, &high);
      low = high;
    }
  }
  if (!going)
    transitions->until = low.T;
  if (counts)
    progress_count(0, 0);
}

/* Returns the T of the nearest transition with the same causes, within a factor of two; nan if not found. */
static double find_same_change(const struct transitions *transitions, const struct transition *e)
{
  double found = NAN;
  for (const struct transition *o = transitions->transition; o < transitions->transition + transitions->count; o++)
    if (strcmp(o->causes, e->causes) == 0 && fabs(log2(o->T / e->T)) < 1
        && !(fabs(log(o->T / e->T)) >= fabs(log(found / e->T))))
      found = o->T;
  return found;
}

/* Keeps the transitions that other curves through the recording have too; the error is the largest difference of T. */
static void keep_shared(struct transitions *transitions, const struct motion *m)
{
  long kept = 0;
  for (int i = 0; i < SCALLOP_MEASURED_MODELS; i++) {
    struct transitions there = { .per_octave = OF_RECORDED / 4, .finest = CHANGE_OF_MODES, .is_rough = true };
    struct motion other = *m;
    if (!gait_exchange(&other.crawler, i))
      continue;
    find_all(&there, &other, BELOW_OF_RECORDED, "");
    for (struct transition *e = transitions->transition; e < transitions->transition + transitions->count; e++) {
      const double T = find_same_change(&there, e);
      e->is_own |= isnan(T);
      e->error = fmax(e->error, fabs(T - e->T));
    }
    transitions_clear(&there);
  }
  for (long k = 0; k < transitions->count; k++)
    if (!transitions->transition[k].is_own)
      transitions->transition[kept++] = transitions->transition[k];
  transitions->left_out = transitions->count - kept;
  transitions->count = kept;
}

void transitions_find(struct transitions *transitions, const struct motion *m, const char *limit_modes)
{
  bool is_recorded = gait_file_of(m->crawler.gait) != NULL;
  *transitions = (struct transitions){ .per_octave = is_recorded ? OF_RECORDED : PER_OCTAVE,
                                       .finest = is_recorded ? CHANGE_OF_MODES : CHANGE_OF_PART };
  find_all(transitions, m, is_recorded ? BELOW_OF_RECORDED : OCTAVES_BELOW, limit_modes);
  if (is_recorded)
    keep_shared(transitions, m);
}

void transitions_clear(struct transitions *transitions)
{
  free(transitions->transition);
  free(transitions->reversal);
}
