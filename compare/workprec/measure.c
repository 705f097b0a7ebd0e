/* Measurement of settings: times, errors and the Pareto front. */
#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/workprec/setting.h"
#include "model/exact/scoped.h"

enum { ERROR_DIGITS = 3, REFERENCE_DIGITS = 250 };

/* Share of the limit for repetitions of one setting; a solve longer than half of this time is not repeated. */
static const double budget_share = 0.5;

const enum quantity_id compared[COMPARED] = { [VELOCITY] = Q_V_START, [DISPLACEMENT] = Q_DISPLACEMENT };

const struct setting_answer no_answer = {
  .value = { NAN, NAN }, .gait_evaluations = NAN, .events = NAN, .root_iterations = NAN, .periods = NAN
};

const char *reference_init(struct reference *t, const struct scallop_crawler *crawler)
{
  struct scallop_scaled scaled;
  enum scallop_status status = scallop_scale(crawler, &scaled);
  *t = (struct reference){ .crawler = *crawler };
  scallop_rational_init(&t->exact);
  ball_answer_init(&t->steady);
  if (status != SCALLOP_OK)
    return scallop_status_text(status);
  t->eps = scaled.eps;
  /* more than in the certified rows, and enough for the error of the longest series, about eps^(terms/2) */
  t->digits = REFERENCE_DIGITS + (scaled.eps < 1 ? (long)(-log10(scaled.eps) * MAX_TERMS / 2) : 0);
  scallop_rational_of(&t->exact, crawler);
  if (!answer_in_balls(&t->steady, &t->exact, OF_STEADY, SCALLOP_EXTENSION, NULL, t->digits))
    return t->steady.why ? t->steady.why : scallop_status_text(t->steady.status);
  return NULL;
}

void reference_clear(struct reference *t)
{
  scallop_rational_clear(&t->exact);
  ball_answer_clear(&t->steady);
}

struct setting *settings_add(struct settings *settings, const struct reference *reference, const char *method,
                             enum method_kind kind, setting_solve *solve, const char *format, ...)
{
  va_list arguments;
  assert(settings->count < MAX_SETTINGS);
  struct setting *s = &settings->list[settings->count++];
  *s = (struct setting){ .kind = kind, .solve = solve, .reference = reference, .answer = no_answer };
  snprintf(s->method, sizeof s->method, "%s", method);
  va_start(arguments, format);
  vsnprintf(s->text, sizeof s->text, format, arguments);
  va_end(arguments);
  return s;
}

void settings_clear(struct settings *settings)
{
  for (int i = 0; i < settings->count; i++)
    if (settings->list[i].release && settings->list[i].memory)
      settings->list[i].release(settings->list[i].memory);
  settings->count = 0;
}

bool setting_has(const struct setting *s, int quantity)
{
  return !s->solved || s->answer.ball[quantity] || !isnan(s->answer.value[quantity]);
}

double printed_seconds(double seconds)
{
  char text[SETTING_TEXT];
  snprintf(text, sizeof text, "%.4g", seconds);
  return strtod(text, NULL);
}

static bool is_infinite(const struct setting_answer *a, int quantity)
{
  return !a->ball[quantity] && isinf(a->value[quantity]);
}

/* Solves the first time, with the limit. */
static void try_once(struct setting *s, double seconds)
{
  struct stopwatch_limit limit = { .end = stopwatch_now() + seconds };
  const struct scallop_patience patience = { stopwatch_is_running, &limit };
  s->first = NAN;
  if (!s->solve)
    return;
  if (s->release && !s->memory) {
    snprintf(s->status, sizeof s->status, "out of memory");
    return;
  }
  double start = stopwatch_now();
  s->patience = &patience;
  s->outcome = s->solve(s, &s->answer);
  s->patience = NULL;
  s->first = stopwatch_now() - start;
  if (s->outcome < 0)
    s->answer = no_answer;
  if (s->outcome == SCALLOP_STOPPED)
    snprintf(s->status, sizeof s->status, "cut off after %g s: %.0f periods", seconds, s->answer.periods);
  else if (s->outcome == SCALLOP_ESTOPPED)
    snprintf(s->status, sizeof s->status, "cut off after %g s, in its first period", seconds);
  else if (s->outcome < 0)
    snprintf(s->status, sizeof s->status, "%s", scallop_status_text(s->outcome));
  else if (is_infinite(&s->answer, VELOCITY) || is_infinite(&s->answer, DISPLACEMENT))
    snprintf(s->status, sizeof s->status, "not a finite number");
  else {
    s->solved = true;
    snprintf(s->status, sizeof s->status, "ok");
  }
}

/* Solves again, without a limit. */
static double solve_again(void *context)
{
  struct setting *s = context;
  struct setting_answer answer = no_answer;
  enum scallop_status status = s->solve(s, &answer);
  return (double)status + answer.value[0] + answer.value[1];
}

/* Plans the passes of a batch, and batches within the budget. If the first solve was too long to repeat, its time is
 * the result. */
static void plan(struct setting *s, double long_enough, double budget)
{
  if (!s->solved)
    return;
  if (s->first > budget / 2) {
    s->samples[s->taken++] = s->first;
    s->repetitions = 1;
    return;
  }
  s->passes = stopwatch_passes(solve_again, s, long_enough);
  double batch = fmax(long_enough, s->first);
  s->repetitions = (int)fmin(SETTING_SAMPLES, fmax(1, budget / batch));
}

/* Spreads repetitions over all rounds. */
static bool is_due(const struct setting *s, int round)
{
  return s->taken < s->repetitions && round * s->repetitions / SETTING_SAMPLES >= s->taken;
}

/* Finds |answer - certified| / |certified|, or over L/T and L if the certified value is 0, as an upper bound. */
static void find_error(struct setting *s, int quantity)
{
  const struct reference *reference = s->reference;
  const arb_struct *certified = reference->steady.value[compared[quantity]];
  const slong precision = 4 * reference->digits + 64;
  SCOPED(arb, error, size);
  SCOPED(fmpq, unit);
  if (s->answer.ball[quantity])
    arb_set(error, s->answer.ball[quantity]);
  else
    arb_set_d(error, s->answer.value[quantity]);
  arb_sub(error, error, certified, precision);
  arb_abs(error, error);
  arb_abs(size, certified);
  if (quantity == VELOCITY)
    fmpq_div(unit, reference->exact.L, reference->exact.T);
  else
    fmpq_set(unit, reference->exact.L);
  if (arb_contains_zero(certified))
    arb_set_fmpq(size, unit, precision);
  arb_div(error, error, size, precision);
  arb_get_ubound_arf(arb_midref(size), error, precision);
  mag_zero(arb_radref(size));
  char *text = arb_get_str(size, ERROR_DIGITS, ARB_STR_NO_RADIUS);
  snprintf(s->error[quantity], SETTING_TEXT, "%s", text);
  flint_free(text);
}

double printed_error_log10(const char *text)
{
  char mantissa[SETTING_TEXT];
  double exponent = 0;
  bool is_number = sscanf(text, "%63[0-9.]%*1[eE]%lf", mantissa, &exponent) > 0;
  return is_number ? log10(strtod(mantissa, NULL)) + exponent : NAN;
}

static void find_errors(struct setting *s)
{
  for (int i = 0; i < COMPARED; i++) {
    snprintf(s->error[i], SETTING_TEXT, "nan");
    if (s->answer.ball[i] || isfinite(s->answer.value[i]))
      find_error(s, i);
    s->error_log10[i] = printed_error_log10(s->error[i]);
  }
}

/* Returns true if a is solved, not worse than b in error and time, and better in one of them. */
static bool dominates(const struct setting *a, const struct setting *b, int quantity)
{
  double error_a = a->error_log10[quantity], error_b = b->error_log10[quantity];
  double time_a = printed_seconds(a->time.median), time_b = printed_seconds(b->time.median);
  return a->solved && error_a <= error_b && time_a <= time_b && (error_a < error_b || time_a < time_b);
}

static void find_front(struct settings *settings, int quantity)
{
  for (int i = 0; i < settings->count; i++) {
    struct setting *s = &settings->list[i];
    s->front[quantity] = s->solved && !isnan(s->error_log10[quantity]);
    for (int k = 0; k < settings->count && s->front[quantity]; k++)
      s->front[quantity] = !dominates(&settings->list[k], s, quantity);
  }
}

void settings_measure(struct settings *settings, const struct stopwatch_clock *clock, double limit)
{
  double long_enough = stopwatch_long_enough(clock);
  for (int i = 0; i < settings->count; i++) {
    struct setting *s = &settings->list[i];
    progress_show("%s, T = %g: %s, %s:", s->reference->crawler.gait->name, s->reference->crawler.T, s->method, s->text);
    progress_count(settings->turn * settings->count + i, settings->turns * settings->count);
    try_once(s, limit);
    plan(s, long_enough, budget_share * limit);
  }
  for (int round = 0; round < SETTING_SAMPLES; round++)
    for (struct setting *s = settings->list; s < settings->list + settings->count; s++)
      if (is_due(s, round))
        s->samples[s->taken++] = stopwatch_batch(solve_again, s, s->passes) / (double)s->passes;
  for (struct setting *s = settings->list; s < settings->list + settings->count; s++) {
    s->time = stopwatch_spread(s->samples, s->taken);
    if (!s->solved)
      s->time.median = s->time.least = s->first;
    find_errors(s);
  }
  for (int quantity = 0; quantity < COMPARED; quantity++)
    find_front(settings, quantity);
}
