/* Solutions of motions, comparisons and texts for claims in words. */
#include "compare/claims/decide.h"

#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/columns/columns.h"
#include "compare/points/point_flint.h"
#include "compare/text/digits.h"
#include "compare/tables/table.h"

/* Solutions */

_Static_assert(offsetof(struct solved, multiplier) == Q_MULTIPLIER * sizeof(double)
                   && offsetof(struct solved, dxC) == Q_DXC * sizeof(double)
                   && offsetof(struct solved, at_first) == Q_AT_FIRST * sizeof(double),
               "the names are in the order of enum quantity_id");

double middle(const arb_t x) { return arf_get_d(arb_midref(x), ARF_RND_NEAR); }

double round_certified(const arb_t x)
{
  if (!arb_contains_zero(x))
    return middle(x);
  return mag_cmp_2exp_si(arb_radref(x), -80) < 0 ? 0 : NAN;
}

static bool solve_in_balls(struct solved *s, const struct motion *m)
{
  SCOPED(ball_answer, a);
  SCOPED(scallop_rational, c);
  SCOPED(fmpq, v0);
  const bool possible = isfinite(m->v0) && scallop_crawler_check(&m->crawler, NULL) == SCALLOP_OK;
  if (possible) {
    rational_crawler(&c, &m->crawler);
    scallop_rational_set_double(v0, m->v0);
  }
  const bool done = possible && answer_in_balls(&a, &c, m->of, m->phase, v0, EVIDENCE_DIGITS);
  for (int k = 0; k < ALL_QUANTITIES; k++)
    s->of[k] = done && a.value[k] ? round_certified(a.value[k]) : NAN;
  s->regime = a.regime;
  motion_modes_text(s->modes, m->of, a.modes);
  return done;
}

static struct solved in_double(const struct motion *m)
{
  struct answer a;
  answer_in_double(&a, m);
  struct solved s = { .regime = a.regime, .single = a.v_low == a.v_high };
  for (int k = 0; k < ALL_QUANTITIES; k++)
    s.of[k] = a.value[k].high;
  motion_modes_text(s.modes, m->of, a.modes);
  return s;
}

static struct solved solve(struct question *q, const struct motion *m)
{
  struct solved s = { .regime = SCALLOP_SLIDING };
  if (!q || q->by != CERTIFIED_CRAWLER)
    return in_double(m);
  q->solved = solve_in_balls(&s, m) && q->solved;
  return s;
}

struct solved solve_steady_state(struct question *q, struct scallop_crawler c)
{
  return solve(q, &(struct motion){ .of = OF_STEADY, .crawler = c });
}

struct solved solve_extension(struct question *q, struct scallop_crawler c, double v0)
{
  return solve(q, &(struct motion){ .of = OF_PHASE, .crawler = c, .phase = SCALLOP_EXTENSION, .v0 = v0 });
}

struct solved solve_contraction(struct question *q, struct scallop_crawler c, double v0)
{
  return solve(q, &(struct motion){ .of = OF_PHASE, .crawler = c, .phase = SCALLOP_CONTRACTION, .v0 = v0 });
}

struct scallop_crawler exchange_bodies(struct scallop_crawler c)
{
  return (struct scallop_crawler){ c.m2, c.m1, c.F2, c.F1, c.L, c.T, c.alpha, c.gait };
}

bool set_conditions(struct scallop_crawler *c, const char *conditions)
{
  char name[8], value[32];
  for (const char *part = conditions; *part != '\0'; part += strcspn(part, ",;:"), part += *part != '\0')
    if (sscanf(part, " %7[a-zA-Z0-9] = %31[^,;:]", name, value) == 2 && crawler_place(name) < CRAWLER_NUMBERS) {
      const char *last = strrchr(value, '=') ? strrchr(value, '=') + 2 : value; /* of "F1 = F2 = 1" */
      const int other = crawler_place(last);
      *crawler_field(c, crawler_place(name)) = other < CRAWLER_NUMBERS ? crawler_number(c, other) : text_number(last);
    }
  if (!strstr(conditions, "F1 > F2"))
    return true;
  const double larger = fmax(c->F1, c->F2);
  c->F2 = fmin(c->F1, c->F2);
  c->F1 = larger;
  return c->F1 > c->F2;
}

int compare(double a, double b)
{
  const double roundings = 16 * DBL_EPSILON * fmax(fabs(a), fabs(b));
  return (a - b > roundings) - (b - a > roundings);
}

int is_zero(double x) { return x == 0 ? 1 : isnan(x) ? 0 : -1; }

double short_number(double x, int digits)
{
  char text[NUMBER_TEXT];
  snprintf(text, sizeof text, "%.*g", digits, x);
  return strtod(text, NULL);
}

int periods_from_rest(const struct scallop_crawler *c, double near, int max)
{
  const double v = solve_steady_state(NULL, *c).v_start;
  struct scallop_period_result p = { .v_end = 0 };
  for (int n = 1; n <= max && scallop_period(c, p.v_end, &p) >= 0; n++)
    if (fabs(p.v_end - v) <= near * c->L / c->T)
      return n;
  return 0;
}

struct printed_value evaluate_printed(struct scallop_crawler c, const char *formula)
{
  const struct scallop_formula *known = formula_named(formula);
  const struct scallop_formula f = known ? *known
                                         : (struct scallop_formula){ .text = formula, .setting = SCALLOP_STEADY };
  const bool steady = f.setting == SCALLOP_STEADY, rest = f.setting == SCALLOP_AT_REST_START;
  const enum scallop_phase_kind kind = f.setting == SCALLOP_MOVING_CONTRACTION;
  SCOPED(ball_answer, a);
  SCOPED(scallop_rational, exact);
  SCOPED(fmpq, v0, T);
  SCOPED(arb, value, error);
  rational_crawler(&exact, &c);
  fmpq_set_si(v0, !rest, 1);
  scallop_rational_duration(T, &exact, kind);
  published_in_balls(value, &f, &exact, kind, v0, steady ? exact.T : T, NULL, EVIDENCE_BITS);
  answer_in_balls(&a, &exact, steady ? OF_STEADY : OF_PHASE, kind, v0, EVIDENCE_DIGITS);
  const arb_struct *right = a.value[quantity_of_formula(&f, kind)];
  if (!right)
    return (struct printed_value){ round_certified(value), NAN, NAN };
  arb_sub(error, value, right, EVIDENCE_BITS);
  return (struct printed_value){ round_certified(value), round_certified(right), round_certified(error) };
}

/* Texts */

void append(char *text, size_t size, const char *format, ...)
{
  size_t used = strlen(text);
  va_list values;
  va_start(values, format);
  vsnprintf(text + used, size - used, format, values);
  va_end(values);
}

const char *write_options(struct question *q, struct scallop_crawler c)
{
  const struct scallop_crawler usual = scallop_crawler_default();
  char number[NUMBER_TEXT];
  *q->options = '\0';
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    if (crawler_number(&c, i) != crawler_number(&usual, i)) {
      number_text(number, crawler_number(&c, i), 0);
      append(q->options, sizeof q->options, " --%s %s", crawler_parameters[i], number);
    }
  if (c.gait != usual.gait)
    append(q->options, sizeof q->options, " --gait %s", c.gait->name);
  return q->options;
}

void conclude(struct question *q, int verdict, const char *format, ...)
{
  struct claim_row *row = &q->row;
  bool in_theory = verdict > 0 && q->claim->proven && scallop_gait_named(row->gait);
  if (!q->solved) {
    verdict = 0;
    format = "not proven";
  }
  row->verdict = verdict > 0 ? CLAIM_HOLDS : verdict < 0 ? CLAIM_REFUTED : CLAIM_UNDECIDED;
  row->evidence = verdict == 0 ? NO_EVIDENCE : in_theory ? PROVEN_FOR_ALL : q->by;
  va_list numbers;
  va_start(numbers, format);
  vsnprintf(row->summary, sizeof row->summary, format, numbers);
  va_end(numbers);
}

void show(struct question *q, const char *format, ...)
{
  va_list numbers;
  va_start(numbers, format);
  if (q->row.verdict != CLAIM_HOLDS)
    vsnprintf(q->row.reason, sizeof q->row.reason, format, numbers);
  va_end(numbers);
}
