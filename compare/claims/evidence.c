#include "compare/claims/evidence.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_qrng.h>

#include "compare/text/halfway.h"
#include "compare/answers/point_flint.h"
#include "compare/text/table.h"

enum { DIGITS = 30 };

void question_init(struct question *q)
{
  *q = (struct question){ .solved = true };
  for (int i = 0; i < EVIDENCE_SLOTS; i++) {
    scallop_certified_phase_init(&q->phase[i]);
    scallop_certified_steady_init(&q->steady[i]);
    arb_init(&q->number[i]);
  }
}

void question_clear(struct question *q)
{
  for (int i = 0; i < EVIDENCE_SLOTS; i++) {
    scallop_certified_phase_clear(&q->phase[i]);
    scallop_certified_steady_clear(&q->steady[i]);
    arb_clear(&q->number[i]);
  }
}

/* The texts of a row */

static void append(char *text, size_t size, const char *format, va_list arguments)
{
  size_t used = strlen(text);
  vsnprintf(text + used, size - used, format, arguments);
}

#define APPEND(text) \
  va_list arguments; \
  va_start(arguments, format); \
  append((text), sizeof(text), format, arguments); \
  va_end(arguments)

void under(struct question *q, const char *format, ...) { APPEND(q->row.conditions); }
void measured(struct question *q, const char *format, ...) { APPEND(q->row.measured); }
void reason(struct question *q, const char *format, ...) { APPEND(q->row.reason); }

void command(struct question *q, const char *before, const struct scallop_crawler *c, const char *format, ...)
{
  const struct scallop_crawler d = scallop_crawler_default();
  double defaults[CRAWLER_NUMBERS], values[CRAWLER_NUMBERS];
  char number[NUMBER_TEXT];
  crawler_numbers(&d, defaults);
  crawler_numbers(c, values);
  reason(q, "%s", before);
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    if (values[i] != defaults[i]) {
      number_text(number, values[i], 0);
      reason(q, " --%s %s", crawler_parameters[i], number);
    }
  if (c->gait != d.gait)
    reason(q, " --gait %s", c->gait->name);
  APPEND(q->row.reason);
}

void settle(struct question *q, bool holds, bool fails)
{
  q->row.verdict = !q->solved ? CLAIM_UNDECIDED : holds ? CLAIM_HOLDS : fails ? CLAIM_REFUTED : CLAIM_UNDECIDED;
}

void settle_by_sign(struct question *q, const arb_t x) { settle(q, arb_is_positive(x), arb_is_negative(x)); }

/* Crawlers and solutions */

struct scallop_crawler paper_crawler(const struct question *q)
{
  struct scallop_crawler c = scallop_crawler_default();
  c.gait = q->crawler.gait;
  return c;
}

double natural_time(const struct scallop_crawler *c) { return sqrt((c->m1 + c->m2) / (c->F1 + c->F2) * c->L); }

struct scallop_steady_result steady_state(const struct scallop_crawler *c)
{
  struct scallop_steady_result r;
  if (scallop_steady(c, &r) < 0)
    return (struct scallop_steady_result){ .mean_velocity = NAN,
                                           .period = { .v_start = NAN, .displacement = NAN, .multiplier = NAN } };
  return r;
}

struct scallop_phase_result extension(const struct scallop_crawler *c, double v0)
{
  struct scallop_phase_result r;
  if (scallop_phase(c, SCALLOP_EXTENSION, v0, &r) < 0)
    return (struct scallop_phase_result){ .dT = NAN, .v_end = NAN, .dxC = NAN, .regime = SCALLOP_SLIDING };
  return r;
}

const struct scallop_certified_steady *certified_steady(struct question *q, const struct scallop_crawler *c)
{
  struct scallop_certified_steady *s = &q->steady[q->steadies++];
  struct scallop_rational_crawler exact;
  scallop_rational_init(&exact);
  rational_crawler(&exact, c);
  q->solved = scallop_certified_steady(&exact, DIGITS, s, NULL) == SCALLOP_OK && q->solved;
  scallop_rational_clear(&exact);
  return s;
}

static bool solve_phase(struct scallop_certified_phase *p, const struct scallop_crawler *c, enum scallop_phase_kind kind,
                        const arf_t v0)
{
  struct scallop_rational_crawler exact;
  fmpq_t v;
  fmpq_init(v);
  scallop_rational_init(&exact);
  rational_crawler(&exact, c);
  arf_get_fmpq(v, v0);
  bool solved = scallop_certified_phase(&exact, kind, v, DIGITS, p, NULL) == SCALLOP_OK;
  scallop_rational_clear(&exact);
  fmpq_clear(v);
  return solved;
}

const struct scallop_certified_phase *certified_phase(struct question *q, const struct scallop_crawler *c,
                                                      enum scallop_phase_kind kind, double v0)
{
  struct scallop_certified_phase *p = &q->phase[q->phases++];
  arf_t v;
  arf_init(v);
  arf_set_d(v, v0);
  q->solved = solve_phase(p, c, kind, v) && q->solved;
  arf_clear(v);
  return p;
}

arb_ptr certified_move(struct question *q, const struct scallop_crawler *c, enum scallop_phase_kind kind, const arb_t v0)
{
  arb_ptr moved = certified_number(q);
  struct scallop_certified_phase low, high;
  arf_t from, to;
  arf_init(from);
  arf_init(to);
  scallop_certified_phase_init(&low);
  scallop_certified_phase_init(&high);
  arb_get_interval_arf(from, to, v0, EVIDENCE_BITS);
  q->solved = q->solved && solve_phase(&low, c, kind, from) && solve_phase(&high, c, kind, to);
  arb_union(moved, low.dxC, high.dxC, EVIDENCE_BITS);
  scallop_certified_phase_clear(&low);
  scallop_certified_phase_clear(&high);
  arf_clear(from);
  arf_clear(to);
  return moved;
}

void certified_law(arb_t speed, arb_t acceleration, const struct scallop_crawler *c, enum scallop_phase_kind kind,
                   const arb_t part, bool from_end)
{
  const struct scallop_shape *shape = &c->gait->phase[kind];
  const struct scallop_piece *piece = shape->pieces, *last = piece + shape->count - 1;
  arb_t other;
  arb_init(other);
  arb_sub_ui(other, part, 1, EVIDENCE_BITS);
  arb_neg(other, other);
  double time = middle(from_end ? other
                                : part); /* since the start; within rounding of where pieces meet the earlier one serves */
  while (piece < last && time > (piece->anchor == SCALLOP_FROM_END ? 1 - piece->end : piece->end))
    piece++;
  arb_srcptr offset = (piece->anchor == SCALLOP_FROM_END) == from_end ? part : other;
  scallop_ball_speed(speed, piece, offset, EVIDENCE_BITS);
  scallop_ball_rate(acceleration, piece, offset, EVIDENCE_BITS);
  arb_mul_si(acceleration, acceleration, piece->direction, EVIDENCE_BITS);
  arb_clear(other);
}

arb_ptr certified_number(struct question *q) { return &q->number[q->numbers++]; }

double middle(const arb_t x) { return arf_get_d(arb_midref(x), ARF_RND_NEAR); }

/* Samples, roots, maxima */

/* 10^x for x in [-1, 1] by its own series: the same bits on every machine */
static double power_of_ten(double x)
{
  double y = x * 2.302585092994046 / 64, p = 1 + y * (1 + y / 2 * (1 + y / 3 * (1 + y / 4 * (1 + y / 5))));
  for (int i = 0; i < 6; i++)
    p *= p;
  return p;
}

int random_crawlers(struct scallop_crawler *c, int count, const struct scallop_gait *gait)
{
  gsl_qrng *sequence = gsl_qrng_alloc(gsl_qrng_sobol, 6);
  if (!sequence)
    return 0;
  for (int i = 0; i < count; i++) {
    double u[6];
    gsl_qrng_get(sequence, u);
    c[i] = (struct scallop_crawler){ .L = 1, .gait = gait, .alpha = 0.05 + 0.9 * u[4] };
    c[i].m1 = power_of_ten(2 * u[0] - 1), c[i].m2 = power_of_ten(2 * u[1] - 1);
    c[i].F1 = power_of_ten(2 * u[2] - 1), c[i].F2 = power_of_ten(2 * u[3] - 1);
    c[i].T = sqrt((c[i].m1 + c[i].m2) / (c[i].F1 + c[i].F2)) * power_of_ten(1.5 * u[5] - 1);
  }
  gsl_qrng_free(sequence);
  return count;
}

double last_positive(function_of *f, const void *context, double low, double high)
{
  for (double x; halfway(&x, low, high);)
    *(f(context, x) > 0 ? &low : &high) = x;
  return low;
}

double highest_between(function_of *f, const void *context, double a, double b)
{
  const double golden = 0.6180339887498949;
  while (b - a > 1e-7 * a) {
    double left = b - golden * (b - a), right = a + golden * (b - a);
    if (f(context, left) > f(context, right))
      b = right;
    else
      a = left;
  }
  return 0.5 * (a + b);
}

double short_number(double x, int digits)
{
  char text[NUMBER_TEXT];
  snprintf(text, sizeof text, "%.*g", digits, x);
  return strtod(text, NULL);
}
