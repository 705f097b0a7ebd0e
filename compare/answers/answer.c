#include "compare/answers/answer.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "compare/formulas/formula_file.h"
#include "compare/text/digits.h"
#include "numerics/numerics.h"

/* Results of the solver, of the wide solver and of the error estimates: a motion sets one member of each. */
struct results {
  struct scallop_steady_result steady;
  struct scallop_phase_result phase;
};
struct wide_results {
  struct scallop_wide_steady steady;
  struct scallop_wide_phase phase;
};
struct error_results {
  struct scallop_steady_error steady;
  struct scallop_phase_error phase;
};

#define PLACES(member, error) \
  { \
    offsetof(struct results, member), offsetof(struct wide_results, member), offsetof(struct error_results, error) \
  }
/* The offsets of the quantities in these structs */
static const struct {
  size_t solved, wide, error;
} places[QUANTITIES] = {
  [Q_FROUDE] = PLACES(steady.froude, steady.froude),
  [Q_V_START] = PLACES(steady.period.v_start, steady.v_start),
  [Q_V_MID] = PLACES(steady.period.v_mid, steady.v_mid),
  [Q_DISPLACEMENT] = PLACES(steady.period.displacement, steady.displacement),
  [Q_MEAN_VELOCITY] = PLACES(steady.mean_velocity, steady.mean_velocity),
  [Q_MULTIPLIER] = PLACES(steady.period.multiplier, steady.multiplier),
  [Q_T1] = PLACES(phase.t1, phase.t1),
  [Q_DT] = PLACES(phase.dT, phase.dT),
  [Q_V_END] = PLACES(phase.v_end, phase.v_end),
  [Q_DX1] = PLACES(phase.dx1, phase.dx1),
  [Q_DX2] = PLACES(phase.dx2, phase.dx2),
  [Q_DXC] = PLACES(phase.dxC, phase.dxC),
};

static const void *value_at(const void *results, size_t place) { return (const char *)results + place; }

static void reset(struct answer *a, enum scallop_status status)
{
  *a = (struct answer){ .status = status, .v_low = NAN, .v_high = NAN };
  for (int q = 0; q < ALL_QUANTITIES; q++)
    a->value[q].high = NAN;
}

static void take_modes(struct answer *a, enum scallop_regime regime, const struct scallop_modes *modes, int phases)
{
  a->regime = regime;
  memcpy(a->modes, modes, (size_t)phases * sizeof *modes);
}

static bool solve(struct answer *a, const struct motion *m, struct results *s)
{
  bool steady = m->of == OF_STEADY;
  reset(a, steady ? scallop_steady(&m->crawler, &s->steady) : scallop_phase(&m->crawler, m->phase, m->v0, &s->phase));
  if (a->status < 0)
    return false;
  for (int q = quantity_first(m->of); q < (int)quantity_end(m->of); q++)
    a->value[q].high = *(const double *)value_at(s, places[q].solved);
  if (steady) {
    a->v_low = s->steady.v_low;
    a->v_high = s->steady.v_high;
    a->work = s->steady.work;
    take_modes(a, s->steady.period.regime, s->steady.period.modes, 2);
  } else {
    a->value[Q_CHANGE].high = s->phase.v_end - m->v0;
    a->value[Q_TURNING].high = isnan(s->phase.dT) ? NAN : 0;
    a->work = s->phase.work;
    take_modes(a, s->phase.regime, &s->phase.modes, 1);
  }
  return true;
}

bool answer_in_double(struct answer *a, const struct motion *m)
{
  struct results s;
  return solve(a, m, &s);
}

bool answer_with_errors(struct answer *a, const struct motion *m, double errors[QUANTITIES])
{
  struct results s;
  struct error_results e;
  enum scallop_status status = SCALLOP_EDOMAIN;
  if (solve(a, m, &s))
    status = m->of == OF_STEADY ? scallop_steady_error(&m->crawler, &s.steady, &e.steady)
                                : scallop_phase_error(&m->crawler, m->phase, m->v0, &s.phase, &e.phase);
  for (int q = 0; q < QUANTITIES; q++)
    errors[q] = NAN;
  for (int q = quantity_first(m->of); q < (int)quantity_end(m->of) && status >= 0; q++)
    errors[q] = *(const double *)value_at(&e, places[q].error);
  return a->status >= 0;
}

bool answer_in_wide(struct answer *a, const struct motion *m, enum scallop_width width)
{
  struct wide_results s;
  bool steady = m->of == OF_STEADY;
  reset(a, steady ? scallop_wide_steady(width, &m->crawler, &s.steady)
                  : scallop_wide_phase(width, &m->crawler, m->phase, m->v0, &s.phase));
  if (a->status < 0)
    return false;
  for (int q = quantity_first(m->of); q < (int)quantity_end(m->of); q++)
    a->value[q] = *(const struct scallop_wide *)value_at(&s, places[q].wide);
  if (steady) {
    a->value[Q_FRICTION_WORK] = s.steady.friction_work;
    a->value[Q_COST_OF_TRANSPORT] = s.steady.cost_of_transport;
    take_modes(a, s.steady.period.regime, s.steady.period.modes, 2);
  } else
    take_modes(a, s.phase.regime, &s.phase.modes, 1);
  return true;
}

/* A walk through the phases of a motion: its segments in order, and the position of the rear body, relative to its
 * start and in units of L, at the first and at the last change of mode */
struct segment_walk {
  struct mode_segment *segment;
  int count;
  const struct scallop_crawler *crawler;
  enum scallop_phase_kind phase;
  double since;            /* time at which the phase begins */
  struct mode_segment now; /* the last segment */
  double first, last;
};

static double rear_position(const struct segment_walk *w, const struct scallop_interval *i)
{
  bool extension = w->phase == SCALLOP_EXTENSION;
  double stroke = extension ? 1 : -1, way = i->piece->anchor == SCALLOP_FROM_END ? stroke : 0;
  double mu_front = (extension ? w->crawler->m2 : w->crawler->m1) / (w->crawler->m1 + w->crawler->m2);
  return i->x_begin - mu_front * stroke * (way + i->piece->curve->length(i->piece, i->u_begin));
}

static void note_interval(void *context, const struct scallop_interval *i)
{
  struct segment_walk *w = context;
  const struct scallop_span span = scallop_interval_span(i, w->crawler, w->phase);
  const struct scallop_mode was = w->now.mode;
  bool continues = w->count > 0 && w->now.phase == w->phase && was.s1 == span.mode.s1 && was.s2 == span.mode.s2;
  if (w->count > 0 && !continues) {
    w->last = rear_position(w, i);
    w->first = isnan(w->first) ? w->last : w->first;
  }
  if (!continues)
    w->now = (struct mode_segment){ w->phase, w->since + span.t_begin, 0, span.mode, i->piece };
  w->now.until = w->since + span.t_end;
  w->count += !continues;
  if (w->count <= MAX_SEGMENTS)
    w->segment[w->count - 1] = w->now;
}

int motion_segments(struct mode_segment segments[MAX_SEGMENTS], const struct motion *m, const struct answer *answer)
{
  const double v0[] = { answer->value[Q_V_START].high, answer->value[Q_V_MID].high };
  struct segment_walk w = { .segment = segments, .crawler = &m->crawler, .phase = m->phase };
  if (m->of == OF_PHASE)
    scallop_phase_intervals(w.crawler, w.phase, m->v0, note_interval, &w);
  for (int kind = 0; kind < 2 && m->of == OF_STEADY; kind++) {
    w.phase = (enum scallop_phase_kind)kind;
    scallop_phase_intervals(w.crawler, w.phase, v0[kind], note_interval, &w);
    w.since = scallop_phase_duration(w.crawler, SCALLOP_EXTENSION);
  }
  return w.count;
}

static enum scallop_status find_turnings(struct answer *a, const struct motion *m)
{
  struct mode_segment segments[MAX_SEGMENTS];
  struct segment_walk w = { .segment = segments, .crawler = &m->crawler, .phase = m->phase, .first = NAN, .last = NAN };
  enum scallop_status status = scallop_phase_intervals(w.crawler, w.phase, m->v0, note_interval, &w);
  a->value[Q_AT_FIRST].high = w.first * m->crawler.L;
  a->value[Q_AT_LAST].high = w.last * m->crawler.L;
  return status;
}

static enum scallop_status find_friction(struct answer *a, const struct motion *m)
{
  const struct scallop_crawler *c = &m->crawler;
  double *work = &a->value[Q_FRICTION_WORK].high, way = fabs(a->value[Q_DISPLACEMENT].high);
  enum scallop_status status = scallop_friction_work(c, a->value[Q_V_START].high, a->value[Q_V_MID].high, work);
  if (status == SCALLOP_OK)
    a->value[Q_COST_OF_TRANSPORT].high = way == 0 ? NAN : *work / (c->F1 + c->F2) / way;
  return status;
}

enum scallop_status answer_complete(struct answer *a, const struct motion *m)
{
  return (m->of == OF_STEADY ? find_friction : find_turnings)(a, m);
}

static bool slides_from_rest(struct scallop_crawler c, double T)
{
  struct scallop_phase_result r;
  c.T = T;
  return scallop_phase(&c, SCALLOP_EXTENSION, 0, &r) == SCALLOP_OK && r.regime == SCALLOP_SLIDING;
}

double sticking_onset(const struct scallop_crawler *c)
{
  enum { MAX_DOUBLINGS = 400 };
  double sliding = 0, sticking = 1;
  int doublings = 0;
  while (slides_from_rest(*c, sticking) && doublings++ < MAX_DOUBLINGS)
    sticking *= 2;
  for (double mid; doublings < MAX_DOUBLINGS && halfway(&mid, sliding, sticking);)
    *(slides_from_rest(*c, mid) ? &sliding : &sticking) = mid;
  return doublings < MAX_DOUBLINGS && sliding > 0 ? sliding : NAN;
}

double published_value(const struct scallop_formula *formula, const struct motion *motion, const struct answer *given)
{
  const struct formula *read = formula_read_once(formula);
  bool steady = formula->setting == SCALLOP_STEADY;
  struct scallop_values values = steady ? scallop_steady_values(&motion->crawler)
                                        : scallop_phase_values(&motion->crawler, motion->phase, motion->v0);
  if (given) {
    values.of[SCALLOP_SYMBOL_t1] = given->value[Q_T1].high;
    values.of[SCALLOP_SYMBOL_dT] = given->value[Q_DT].high;
    values.of[SCALLOP_SYMBOL_x_switch] = given->value[Q_AT_LAST].high;
  }
  return read ? scallop_formula_value(read, formula, motion->phase, &values) : NAN;
}

const char *motion_modes_text(char text[MOTION_MODES_TEXT], enum quantity_of of, const struct scallop_modes modes[2])
{
  scallop_modes_text(&modes[0], text);
  if (of == OF_PHASE)
    return text;
  size_t length = strlen(text);
  memcpy(text + length, " | ", sizeof " | ");
  scallop_modes_text(&modes[1], text + length + 3);
  return text;
}

enum scallop_turns turns_in_modes(const char *modes)
{
  const char *bar = strchr(modes, '|');
  return bar && strcmp(bar, "| ++") == 0         ? SCALLOP_NO_TURN_IN_CONTRACTION
         : bar && strncmp(modes, "++ |", 4) == 0 ? SCALLOP_NO_TURN_IN_EXTENSION
                                                 : SCALLOP_TURNS_IN_BOTH;
}

bool same_modes(const struct scallop_modes a[2], const struct scallop_modes b[2])
{
  for (int phase = 0; phase < 2; phase++) {
    int kept = a[phase].count < SCALLOP_MODES_KEPT ? (int)a[phase].count : SCALLOP_MODES_KEPT;
    if (a[phase].count != b[phase].count
        || memcmp(a[phase].kept, b[phase].kept, (size_t)kept * sizeof *a[phase].kept) != 0)
      return false;
  }
  return true;
}

const char *answer_status_text(char text[ANSWER_STATUS], const struct answer *a)
{
  char low[NUMBER_TEXT], high[NUMBER_TEXT];
  if (a->status < 0)
    return scallop_status_text(a->status);
  if (a->status != SCALLOP_INTERVAL)
    return "ok";
  number_text(low, a->v_low, 0);
  number_text(high, a->v_high, 0);
  snprintf(text, ANSWER_STATUS, "interval of steady states: v_start from %s to %s", low, high);
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

const char *motion_in_words(char text[MOTION_WORDS], const struct motion *m, const struct answer *answer, int digits)
{
  struct mode_segment s[MAX_SEGMENTS];
  int count = motion_segments(s, m, answer);
  size_t used = 0;
  *text = '\0';
  for (int i = 0; i < count && i < MAX_SEGMENTS; i++) {
    char words[MODE_WORDS];
    const char *between = i == 0 ? "" : s[i].phase == s[i - 1].phase ? "; " : " | ";
    used += (size_t)snprintf(text + used, MOTION_WORDS - used, "%s%s from %.*g to %.*g", between,
                             mode_in_words(words, s[i].mode), digits, s[i].from, digits, s[i].until);
  }
  if (count > MAX_SEGMENTS)
    snprintf(text + used, MOTION_WORDS - used, "; ...");
  return text;
}
