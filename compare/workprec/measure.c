/* Ways take turns: each is solved once, for its answer and to see how long it takes; then rounds over all of them, so that a
 * machine that slows down slows all; then errors against the certified value, and the Pareto front. */
#include <assert.h>
#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "numerics/certified.h"
#include "compare/workprec/workprec.h"

enum { ERROR_DIGITS = 3, REFERENCE_DIGITS = 250 };

/* Of the limit, for the repetitions of one way: what takes longer than half of it is not repeated. */
static const double budget_share = 0.5;

const struct way_answer answer_none = {
  .value = { NAN, NAN }, .gait_evaluations = NAN, .events = NAN, .root_iterations = NAN, .periods = NAN
};

/* ---- points and ways ---- */

/* More than the certified rows have, and beyond what the longest series leaves, which goes as eps^(terms/2) */
static long digits_for(double eps) { return REFERENCE_DIGITS + (eps < 1 ? (long)(-log10(eps) * WAY_TERMS / 2) : 0); }

const char *point_init(struct trial *point, const struct scallop_crawler *crawler)
{
  struct scallop_scaled scaled;
  const char *why = NULL;
  enum scallop_status status = scallop_scale(crawler, &scaled);
  *point = (struct trial){ .crawler = *crawler };
  scallop_rational_init(&point->exact);
  scallop_certified_steady_init(&point->steady);
  if (status == SCALLOP_OK) {
    point->eps = scaled.eps;
    point->digits = digits_for(scaled.eps);
    scallop_rational_of(&point->exact, crawler);
    status = scallop_certified_steady(&point->exact, point->digits, &point->steady, &why);
  }
  if (status != SCALLOP_OK)
    return why ? why : scallop_status_text(status);
  point->v_start = arf_get_d(arb_midref(point->steady.v_start), ARF_RND_NEAR);
  return NULL;
}

void point_clear(struct trial *point)
{
  scallop_rational_clear(&point->exact);
  scallop_certified_steady_clear(&point->steady);
}

struct way *ways_add(struct ways *ways, const struct trial *point, const char *method, enum way_kind kind,
                     const char *format, ...)
{
  va_list arguments;
  assert(ways->count < MOST_WAYS);
  struct way *way = &ways->list[ways->count++];
  *way = (struct way){ .method = method, .kind = kind, .point = point, .share = 1, .answer = answer_none };
  va_start(arguments, format);
  vsnprintf(way->setting, sizeof way->setting, format, arguments);
  va_end(arguments);
  return way;
}

void ways_clear(struct ways *ways)
{
  for (int i = 0; i < ways->count; i++)
    if (ways->list[i].release && ways->list[i].memory)
      ways->list[i].release(ways->list[i].memory);
  ways->count = 0;
}

bool way_has(const struct way *way, int quantity)
{
  return !way->solved || way->answer.ball[quantity] || !isnan(way->answer.value[quantity]);
}

/* ---- time ---- */

double way_seconds(double seconds)
{
  char text[WAY_TEXT];
  snprintf(text, sizeof text, "%.4g", seconds);
  return strtod(text, NULL);
}

static void describe_cut(struct way *way, double limit)
{
  if (way->outcome == SCALLOP_STOPPED)
    snprintf(way->status, sizeof way->status, "cut off after %g s: %.0f periods", limit, way->answer.periods);
  else
    snprintf(way->status, sizeof way->status, "cut off after %g s, in its first period", limit);
}

static bool is_finite(const struct way_answer *answer)
{
  for (int i = 0; i < WAY_QUANTITIES; i++)
    if (!answer->ball[i] && isinf(answer->value[i]))
      return false;
  return true;
}

/* The first time, with the limit. */
static void try_once(struct way *way, double seconds)
{
  struct stopwatch_limit limit = stopwatch_limit(seconds);
  const struct scallop_patience patience = { stopwatch_lasts, &limit };
  way->first = NAN;
  if (!way->solve)
    return;
  if (way->release && !way->memory) {
    snprintf(way->status, sizeof way->status, "out of memory");
    return;
  }
  double start = stopwatch_now();
  way->outcome = way->solve(way, &patience, &way->answer);
  way->first = stopwatch_now() - start;
  if (way->outcome < 0)
    way->answer = answer_none;
  if (way->outcome == SCALLOP_STOPPED || way->outcome == SCALLOP_ESTOPPED)
    describe_cut(way, seconds);
  else if (way->outcome < 0)
    snprintf(way->status, sizeof way->status, "%s", scallop_status_text(way->outcome));
  else if (!is_finite(&way->answer))
    snprintf(way->status, sizeof way->status, "not a finite number");
  else {
    way->solved = true;
    snprintf(way->status, sizeof way->status, "ok");
  }
}

/* Once more, with all the time it takes */
static double solve_again(void *context)
{
  struct way *way = context;
  struct way_answer answer = answer_none;
  enum scallop_status status = way->solve(way, NULL, &answer);
  return (double)status + answer.value[0] + answer.value[1];
}

/* Passes of a batch, and as many batches as the budget has room for. A solve that is long beside the budget counts as it was. */
static void plan(struct way *way, double long_enough, double budget)
{
  if (!way->solved)
    return;
  if (way->first > budget / 2) {
    way->samples[way->taken++] = way->first * way->share;
    way->wanted = 1;
    return;
  }
  way->passes = stopwatch_passes(solve_again, way, long_enough);
  double batch = fmax(long_enough, way->first);
  way->wanted = (int)fmin(WAY_SAMPLES, fmax(1, budget / batch));
}

/* Few repetitions are spread over all rounds. */
static bool is_due(const struct way *way, int round)
{
  return way->taken < way->wanted && round * way->wanted / WAY_SAMPLES >= way->taken;
}

static void time_in_turns(struct ways *ways)
{
  for (int round = 0; round < WAY_SAMPLES; round++)
    for (int i = 0; i < ways->count; i++) {
      struct way *way = &ways->list[i];
      if (is_due(way, round))
        way->samples[way->taken++] = stopwatch_batch(solve_again, way, way->passes) / (double)way->passes * way->share;
    }
}

static void conclude_time(struct way *way)
{
  way->time = stopwatch_spread(way->samples, way->taken);
  if (!way->solved)
    way->time.median = way->time.least = way->first;
}

/* ---- error ---- */

/* |answer - certified| / |certified|, or over L/T and L where the certified value is 0; from the far end of both balls. */
static void find_error(struct way *way, int quantity)
{
  const struct trial *point = way->point;
  const arb_struct *certified = quantity == WAY_VELOCITY ? point->steady.v_start : point->steady.displacement;
  const slong precision = 4 * point->digits + 64;
  const arb_struct *ball = way->answer.ball[quantity];
  arb_t error, size;
  arb_init(error);
  arb_init(size);
  if (ball)
    arb_set(error, ball);
  else
    arb_set_d(error, way->answer.value[quantity]);
  arb_sub(error, error, certified, precision);
  arb_abs(error, error);
  arb_abs(size, certified);
  if (arb_contains_zero(certified)) {
    arb_set_fmpq(size, point->exact.L, precision);
    if (quantity == WAY_VELOCITY)
      arb_div_fmpz(size, size, fmpq_numref(point->exact.T), precision);
    if (quantity == WAY_VELOCITY)
      arb_mul_fmpz(size, size, fmpq_denref(point->exact.T), precision);
  }
  arb_div(error, error, size, precision);
  arb_get_ubound_arf(arb_midref(size), error, precision);
  mag_zero(arb_radref(size));
  char *text = arb_get_str(size, ERROR_DIGITS, ARB_STR_NO_RADIUS);
  snprintf(way->error[quantity], WAY_TEXT, "%s", text);
  flint_free(text);
  arb_clear(error);
  arb_clear(size);
}

/* Only what JSON takes for a number >= 0 too, as it is copied into tables. */
double way_error_log10(const char *text)
{
  static const char digits[] = "0123456789";
  char mantissa[WAY_TEXT];
  size_t whole = strspn(text, digits), length = whole;
  if (text[whole] == '.' && isdigit((unsigned char)text[whole + 1]))
    length += 1 + strspn(text + whole + 1, digits);
  if (whole == 0 || (text[0] == '0' && whole > 1) || length >= sizeof mantissa)
    return NAN;
  memcpy(mantissa, text, length);
  mantissa[length] = '\0';
  if (text[length] == '\0')
    return log10(strtod(mantissa, NULL));
  const char *exponent = text + length + 1, *size = exponent + (*exponent == '-' || *exponent == '+');
  if (!strchr("eE", text[length]) || *size == '\0' || size[strspn(size, digits)] != '\0')
    return NAN;
  return log10(strtod(mantissa, NULL)) + strtod(exponent, NULL);
}

static void find_errors(struct way *way)
{
  for (int i = 0; i < WAY_QUANTITIES; i++) {
    bool there = way->answer.ball[i] || isfinite(way->answer.value[i]);
    if (there)
      find_error(way, i);
    else
      snprintf(way->error[i], WAY_TEXT, "nan");
    way->error_log10[i] = there ? way_error_log10(way->error[i]) : NAN;
  }
}

/* ---- the front ---- */

static bool may_lead(const struct way *way, int quantity)
{
  return way->solved && way->kind != WAY_ASIDE && !isnan(way->error_log10[quantity]);
}

/* Whether a is no worse than b in both, and better in one. */
static bool beats(const struct way *a, const struct way *b, int quantity)
{
  double error_a = a->error_log10[quantity], error_b = b->error_log10[quantity];
  double time_a = way_seconds(a->time.median), time_b = way_seconds(b->time.median);
  return error_a <= error_b && time_a <= time_b && (error_a < error_b || time_a < time_b);
}

static void find_front(struct ways *ways, int quantity)
{
  for (int i = 0; i < ways->count; i++) {
    struct way *way = &ways->list[i];
    way->front[quantity] = may_lead(way, quantity);
    for (int k = 0; k < ways->count && way->front[quantity]; k++)
      if (may_lead(&ways->list[k], quantity) && beats(&ways->list[k], way, quantity))
        way->front[quantity] = false;
  }
}

void ways_measure(struct ways *ways, const struct stopwatch_clock *clock, double limit,
                  const struct workprec_progress *progress)
{
  double long_enough = stopwatch_long_enough(clock);
  for (int i = 0; i < ways->count; i++) {
    struct way *way = &ways->list[i];
    progress->say(progress->context, i, ways->count, way);
    try_once(way, limit);
    plan(way, long_enough, budget_share * limit);
  }
  time_in_turns(ways);
  for (int i = 0; i < ways->count; i++) {
    conclude_time(&ways->list[i]);
    find_errors(&ways->list[i]);
  }
  for (int quantity = 0; quantity < WAY_QUANTITIES; quantity++)
    find_front(ways, quantity);
}
