/* The motions that a claim in words is about, and formulas of them (decide.h). Needs FLINT. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/derived/formula_flint.h"
#include "compare/points/point_flint.h"
#include "compare/book/book.h"
#include "compare/claims/decide.h"
#include "compare/claims/evidence.h"
#include "compare/text/table.h"

enum { DIGITS = 30, NAMES = 32 };

static void moved_init(struct moved *m)
{
  scallop_rational_init(&m->exact);
  arb_init(m->v0);
  ball_answer_init(&m->answer);
  for (int i = 0; i < ALL_QUANTITIES; i++)
    arb_init(&m->value[i]);
}

static void moved_clear(struct moved *m)
{
  scallop_rational_clear(&m->exact);
  arb_clear(m->v0);
  ball_answer_clear(&m->answer);
  for (int i = 0; i < ALL_QUANTITIES; i++)
    arb_clear(&m->value[i]);
}

void question_init(struct question *q, const struct scallop_crawler *crawler)
{
  *q = (struct question){ .crawler = *crawler, .solved = true };
  arb_init(q->root);
  for (int i = 0; i < MOTIONS; i++) {
    moved_init(&q->motion[i]);
    q->motion[i].crawler = *crawler;
  }
}

void question_clear(struct question *q)
{
  arb_clear(q->root);
  for (int i = 0; i < MOTIONS; i++)
    moved_clear(&q->motion[i]);
}

/* What a name means */

static void set_double(arb_t x, double value)
{
  if (isnan(value))
    arb_indeterminate(x);
  else
    arb_set_d(x, value);
}

/* A number that was found is what a command says: its shortest decimal. */
static void set_decimal(arb_t x, double value)
{
  char text[NUMBER_TEXT];
  number_text(text, value, 0);
  set_double(x, value);
  if (isfinite(value))
    arb_set_str(x, text, EVIDENCE_BITS);
}

/* The period, or the duration of a phase */
static void duration_of(fmpq_t T, const struct moved *m)
{
  if (m->of == OF_STEADY)
    fmpq_set(T, m->exact.T);
  else
    scallop_rational_duration(T, &m->exact, m->kind);
}

/* |l'|, or its rate l'', in L over the duration (squared), a part of the duration before its end */
static void law_before_end(arb_t x, const struct moved *m, const arb_t part, bool rate)
{
  const struct scallop_shape *shape = &m->exact.gait->phase[m->kind];
  const struct scallop_piece *piece = shape->pieces, *last = piece + shape->count - 1;
  arb_t since;
  arb_init(since);
  arb_sub_ui(since, part, 1, EVIDENCE_BITS);
  arb_neg(since, since);
  /* within rounding of where pieces meet the earlier one serves */
  while (piece < last && middle(since) > (piece->anchor == SCALLOP_FROM_END ? 1 - piece->end : piece->end))
    piece++;
  arb_srcptr offset = piece->anchor == SCALLOP_FROM_END ? part : since;
  if (rate) {
    scallop_ball_rate(x, piece, offset, EVIDENCE_BITS);
    arb_mul_si(x, x, piece->direction, EVIDENCE_BITS);
  } else
    scallop_ball_speed(x, piece, offset, EVIDENCE_BITS);
  arb_clear(since);
}

/* A formula of the paper, or a name in its formulas */
static void published(arb_t x, const struct moved *m, const char *name)
{
  struct scallop_formula formula = { .text = name, .setting = SCALLOP_STEADY };
  fmpq_t T, v0;
  fmpq_init(T);
  fmpq_init(v0);
  if (m->of == OF_PHASE)
    formula.setting = m->kind == SCALLOP_EXTENSION ? SCALLOP_MOVING_EXTENSION : SCALLOP_MOVING_CONTRACTION;
  const struct scallop_formula *known = formula_named(name);
  if (known)
    formula = *known;
  duration_of(T, m);
  arf_get_fmpq(v0, arb_midref(m->v0));
  arb_indeterminate(x);
  published_in_balls(x, &formula, &m->exact, m->kind, v0, T, NULL, EVIDENCE_BITS);
  fmpq_clear(T);
  fmpq_clear(v0);
}

static bool sets_flag(arb_t x, const struct question *q, const struct moved *m, const char *name)
{
  char modes[MOTION_MODES_TEXT];
  bool sticks_1 = false, sticks_2 = false, both = false;
  for (int kind = 0; kind < 2; kind++)
    for (int i = 0; i < m->modes[kind].count && i < SCALLOP_MODES_KEPT; i++) {
      const struct scallop_mode *mode = &m->modes[kind].kept[i];
      sticks_1 = sticks_1 || mode->s1 == 0;
      sticks_2 = sticks_2 || mode->s2 == 0;
      both = both || (mode->s1 == 0 && mode->s2 == 0);
    }
  motion_modes_text(modes, m->of, m->modes);
  const struct {
    const char *name;
    bool is;
  } flags[] = { { "sliding", m->regime == SCALLOP_SLIDING },
                { "sticking", m->regime == SCALLOP_STICK_SLIP },
                { "resting", m->regime == SCALLOP_AT_REST },
                { "switches", arb_is_finite(&m->value[Q_T1]) },
                { "sticks_1", sticks_1 },
                { "sticks_2", sticks_2 },
                { "sticks_both", both },
                { "oppose", strcmp(modes, "-+ | +-") == 0 },
                { "turns_once", strcmp(modes, "-+ ++") == 0 },
                { "like_first", same_modes(m->modes, q->motion[1].modes) },
                { "single", m->single },
                { "stronger_1", fmpq_cmp(m->exact.F1, m->exact.F2) > 0 },
                { "longer", m->crawler.alpha > 0.5 },
                { "sinusoidal", m->crawler.gait == &scallop_gait_sinusoidal } };
  for (size_t i = 0; i < sizeof flags / sizeof *flags; i++)
    if (strcmp(flags[i].name, name) == 0) {
      arb_set_si(x, flags[i].is);
      return true;
    }
  return false;
}

static void set_named(arb_t x, const struct question *q, const struct moved *m, const char *name)
{
  const fmpq *const numbers[] = { m->exact.m1, m->exact.m2, m->exact.F1,   m->exact.F2,
                                  m->exact.L,  m->exact.T,  m->exact.alpha };
  enum quantity_id quantity = quantity_of_name(name);
  int number = crawler_place(name);
  fmpq_t T;
  fmpq_init(T);
  duration_of(T, m);
  if (number < CRAWLER_NUMBERS)
    arb_set_fmpq(x, numbers[number], EVIDENCE_BITS);
  else if (quantity < NAMED_QUANTITIES)
    arb_set(x, &m->value[quantity]);
  else if (name[0] == 'x' && name[1] >= '1' && name[1] <= '9')
    set_decimal(x, q->found[name[1] - '1']);
  else if (strcmp(name, "root") == 0)
    arb_set(x, q->root);
  else if (strcmp(name, "x_first") == 0)
    arb_set(x, &m->value[Q_AT_FIRST]);
  else if (strcmp(name, "v0") == 0)
    arb_set(x, m->v0);
  else if (strcmp(name, "duration") == 0)
    arb_set_fmpq(x, T, EVIDENCE_BITS);
  else if (strcmp(name, "rate_at_dT") == 0 || strcmp(name, "speed_at_quarter") == 0) {
    arb_t part;
    arb_init(part);
    arb_set_d(part, 0.75);
    if (*name == 'r') {
      arb_set_fmpq(part, T, EVIDENCE_BITS);
      arb_div(part, &m->value[Q_DT], part, EVIDENCE_BITS);
    }
    law_before_end(x, m, part, *name == 'r');
    arb_clear(part);
  } else if (!sets_flag(x, q, m, name))
    published(x, m, name);
  fmpq_clear(T);
}

/* The values of the names of a formula, as they come */
struct values {
  const struct question *q;
  int usual, count; /* usual: the motion of a name without a number */
  arb_ptr value;
};

static int place_of(void *context, const char *name)
{
  struct values *v = context;
  char own[FORMULA_NAME];
  size_t length = strcspn(name, ":");
  int motion = name[length] ? atoi(name + length + 1) : v->usual;
  snprintf(own, sizeof own, "%.*s", (int)length, name);
  bool known = v->count < NAMES && motion < MOTIONS;
  if (known)
    set_named(v->value + v->count, v->q, &v->q->motion[motion], own);
  return known ? v->count++ : -1;
}

static void evaluate(arb_t x, const struct question *q, const char *text, int usual)
{
  char message[FORMULA_MESSAGE];
  struct formula formula;
  struct values values = { q, usual, 0, _arb_vec_init(NAMES) };
  const struct formula_names names = { .place = place_of, .context = &values };
  arb_indeterminate(x);
  if (!formula_read(&formula, text, &names, message))
    formula_ball(x, &formula, values.value, EVIDENCE_BITS);
  _arb_vec_clear(values.value, NAMES);
}

void value_of(arb_t x, struct question *q, const char *formula) { evaluate(x, q, formula, 1); }

double number_of(struct question *q, const char *formula)
{
  arb_t x;
  arb_init(x);
  value_of(x, q, formula);
  double value = middle(x);
  arb_clear(x);
  return value;
}

/* Solutions */

static bool solve_in_balls(struct moved *m)
{
  bool done = true;
  arf_t end[2];
  fmpq_t v0;
  arf_init(end[0]);
  arf_init(end[1]);
  fmpq_init(v0);
  arb_get_interval_arf(end[0], end[1], m->v0, EVIDENCE_BITS);
  for (int i = 0; done && i < (arb_is_exact(m->v0) ? 1 : 2); i++) {
    arf_get_fmpq(v0, end[i]);
    done = answer_in_balls(&m->answer, &m->exact, m->of, m->kind, v0, DIGITS);
    for (int k = 0; k < ALL_QUANTITIES; k++)
      if (!m->answer.value[k])
        arb_indeterminate(&m->value[k]);
      else if (i == 0)
        arb_set(&m->value[k], m->answer.value[k]);
      else
        arb_union(&m->value[k], &m->value[k], m->answer.value[k], EVIDENCE_BITS);
  }
  m->regime = m->answer.regime;
  memcpy(m->modes, m->answer.modes, sizeof m->modes);
  arf_clear(end[0]);
  arf_clear(end[1]);
  fmpq_clear(v0);
  return done;
}

static bool solve_in_double(struct moved *m)
{
  struct answer answer;
  bool done = answer_in_double(&answer, &(struct motion){ m->of, m->crawler, m->kind, middle(m->v0) });
  for (int k = 0; k < ALL_QUANTITIES; k++)
    set_double(&m->value[k], done ? answer.value[k].high : NAN);
  m->regime = answer.regime;
  memcpy(m->modes, answer.modes, sizeof m->modes);
  m->single = answer.v_low == answer.v_high;
  return done;
}

/* Begins a motion: the base crawler, from rest */
static struct moved *begin_motion(struct question *q, int i, bool in_balls)
{
  struct moved *m = &q->motion[i];
  m->crawler = q->crawler;
  (in_balls ? rational_crawler : scallop_rational_of)(&m->exact, &m->crawler);
  arb_zero(m->v0);
  q->motions = i;
  return m;
}

/* The number, if it is known exactly; else its nearest double, in balls as the shortest decimal. 0: it is none. */
static void set_exactly(fmpq_t exact, const arb_t x, bool in_balls)
{
  char text[NUMBER_TEXT];
  number_text(text, middle(x), 0);
  fmpq_zero(exact);
  if (in_balls && arb_is_exact(x))
    arf_get_fmpq(exact, arb_midref(x));
  else if (in_balls && arb_is_finite(x))
    scallop_rational_parse(exact, text);
  else if (arb_is_finite(x))
    scallop_rational_set_double(exact, middle(x));
}

/* The member of the family */
static void vary(struct scallop_rational_crawler *c, enum varied varied, const fmpq_t x)
{
  if (varied == VARY_PERIOD)
    fmpq_set(c->T, x);
  else if (varied == VARY_RATIO)
    fmpq_mul(c->F1, c->F2, x);
  else {
    fmpq_div(c->F1, c->F1, c->F2);
    fmpq_mul(c->F1, c->F1, x);
    fmpq_set(c->F2, x);
  }
}

/* NAME=FORMULA or NAME~FORMULA */
static void assign(struct question *q, struct moved *m, const char *text, bool in_balls)
{
  struct scallop_rational_crawler *e = &m->exact;
  struct scallop_crawler *c = &m->crawler;
  fmpq *const exact[] = { e->m1, e->m2, e->F1, e->F2, e->L, e->T, e->alpha };
  double *const numbers[] = { &c->m1, &c->m2, &c->F1, &c->F2, &c->L, &c->T, &c->alpha };
  char name[8];
  size_t length = strcspn(text, "=~");
  arb_t x;
  fmpq_t value;
  arb_init(x);
  fmpq_init(value);
  snprintf(name, sizeof name, "%.*s", (int)length, text);
  evaluate(x, q, text + length + 1, 0);
  set_exactly(value, x, in_balls);
  int place = crawler_place(name);
  if (strcmp(name, "at") == 0)
    vary(e, q->claim->varied, value);
  else if (place < CRAWLER_NUMBERS)
    fmpq_set(exact[place], value);
  else if (text[length] == '~')
    arb_set_d(m->v0, middle(x));
  else
    arb_set(m->v0, x);
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    *numbers[i] = nearest_double(exact[i]);
  arb_clear(x);
  fmpq_clear(value);
}

void solve_motions(struct question *q, bool in_balls)
{
  struct moved *m = begin_motion(q, 0, in_balls);
  q->solved = true;
  q->row.evidence = in_balls ? CERTIFIED_CRAWLER : MEASURED;
  for (const char *at = q->claim->motions; at && *at; at += strspn(at, "; ")) {
    char word[100];
    size_t length = strcspn(at, "; ");
    snprintf(word, sizeof word, "%.*s", (int)length, at);
    if (strpbrk(word, "=~"))
      assign(q, m, word, in_balls);
    else {
      m = begin_motion(q, q->motions + 1, in_balls);
      m->of = *word == 's' ? OF_STEADY : OF_PHASE;
      m->kind = *word == 'c' ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION;
    }
    at += length;
    if (*at != ' ')
      q->solved = (in_balls ? solve_in_balls : solve_in_double)(m) && q->solved;
  }
}

int judge(struct question *q, arb_t excess)
{
  const char *says = q->claim->says, *relation = says + strcspn(says, "<>=");
  char difference[400];
  bool or_equal = relation[1] == '=';
  snprintf(difference, sizeof difference, "%.*s - (%s)", (int)(relation - says), says, relation + 1 + or_equal);
  value_of(excess, q, difference);
  if (*relation == '>')
    arb_neg(excess, excess);
  if (!q->solved || !arb_is_finite(excess))
    return 0;
  if (*relation == '=')
    return arb_contains_zero(excess) && mag_cmp_2exp_si(arb_radref(excess), -80) < 0 ? 1
                                                                                     : -(arb_is_nonzero(excess) != 0);
  if (or_equal)
    return arb_is_nonpositive(excess) ? 1 : -(arb_is_positive(excess) != 0);
  return arb_is_negative(excess) ? 1 : -(arb_is_nonnegative(excess) != 0);
}
