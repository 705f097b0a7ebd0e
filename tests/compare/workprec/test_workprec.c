/* compare/workprec on settings made up for it: the front, errors, and settings without an answer. */
#include <stdlib.h>
#include <time.h>

#include "compare/workprec/setting.h"
#include "tests/support/check.h"

static double v_start(const struct reference *reference)
{
  return arf_get_d(arb_midref(reference->steady.value[Q_V_START]), ARF_RND_NEAR);
}

/* What a made-up setting does: waits, and gives the certified answer times (1 + number 1e-3), or what its tolerance
 * says. */
static enum scallop_status give(struct setting *s, struct setting_answer *answer)
{
  const struct timespec pause = { .tv_nsec = s->kind == METHOD_SIMULATION ? 3000000 : 0 };
  if (pause.tv_nsec > 0)
    nanosleep(&pause, NULL);
  answer->value[VELOCITY] = v_start(s->reference) * (1 + 1e-3 * (double)s->number);
  return SCALLOP_OK;
}

static enum scallop_status end_with(struct setting *s, struct setting_answer *answer)
{
  answer->periods = 17;
  answer->value[VELOCITY] = s->tolerance;
  return (enum scallop_status)s->number;
}

static enum scallop_status work_forever(struct setting *s, struct setting_answer *answer)
{
  (void)answer;
  assert_non_null(s->patience); /* it is not timed again */
  while (s->patience->lasts(s->patience->context))
    ;
  return SCALLOP_ESTOPPED;
}

struct bench {
  struct reference reference;
  struct settings settings;
};

static struct bench *bench_make(void)
{
  struct bench *b = calloc(1, sizeof *b);
  struct scallop_crawler crawler = scallop_crawler_default();
  crawler.alpha = 0.7; /* no double: an answer is held to the double, not to 7/10 */
  assert_non_null(b);
  assert_null(reference_init(&b->reference, &crawler));
  return b;
}

static void bench_clear(struct bench *b)
{
  settings_clear(&b->settings);
  reference_clear(&b->reference);
  free(b);
}

static struct setting *add(struct bench *b, enum method_kind kind, long number, setting_solve *solve)
{
  struct setting *s = settings_add(&b->settings, &b->reference, "made up", kind, solve, "%ld", number);
  s->number = number;
  return s;
}

static void measure(struct bench *b, double limit)
{
  struct stopwatch_clock clock = stopwatch_clock();
  settings_measure(&b->settings, &clock, limit);
}

/* Fast ones take no time to speak of, simulations 3 ms. */
TEST(the_front)
{
  struct bench *b = bench_make();
  enum { SLOW_RIGHT, SLOW_WRONG, FAST_WRONG, SLOW_WORSE, COUNT };
  static const struct {
    enum method_kind kind;
    long number;
  } made[COUNT] = { { METHOD_SIMULATION, 0 }, { METHOD_SIMULATION, 2 }, { METHOD_EXACT, 2 }, { METHOD_SIMULATION, 3 } };
  for (int i = 0; i < COUNT; i++)
    add(b, made[i].kind, made[i].number, give);
  measure(b, 0.05);
  const struct setting *list = b->settings.list;
  for (int i = 0; i < COUNT; i++) {
    assert_string_equal(list[i].status, "ok");
    assert_true(setting_has(&list[i], VELOCITY) && !setting_has(&list[i], DISPLACEMENT));
    assert_true(list[i].time.repetitions >= 1 && list[i].time.least > 0);
    if (made[i].number == 0)
      CHECK_AT_MOST(list[i].error_log10[VELOCITY], -15.9); /* rounding                              */
    else
      CHECK_NEAR(list[i].error_log10[VELOCITY], log10(1e-3 * (double)made[i].number), 0.003);
    CHECK_EQUAL(list[i].error_log10[DISPLACEMENT], NAN);
    assert_false(list[i].front[DISPLACEMENT]);
  }
  assert_true(list[SLOW_RIGHT].front[VELOCITY]);
  assert_false(list[SLOW_WRONG].front[VELOCITY]);
  assert_true(list[FAST_WRONG].front[VELOCITY]);
  assert_false(list[SLOW_WORSE].front[VELOCITY]);
  bench_clear(b);
}

TEST(those_without_an_answer)
{
  struct bench *b = bench_make();
  add(b, METHOD_ROOT, SCALLOP_ECONVERGE, end_with);
  add(b, METHOD_ROOT, SCALLOP_STOPPED, end_with)->tolerance = v_start(&b->reference) * 1.25;
  add(b, METHOD_ROOT, 0, work_forever);
  add(b, METHOD_ROOT, SCALLOP_OK, end_with)->tolerance = INFINITY;
  add(b, METHOD_ROOT, 0, give)->release = free; /* and no memory                                         */
  add(b, METHOD_ROOT, 0, NULL);
  measure(b, 0.002);
  static const char *const status[] = { "no convergence",
                                        "cut off after 0.002 s: 17 periods",
                                        "cut off after 0.002 s, in its first period",
                                        "not a finite number",
                                        "out of memory",
                                        "" };
  for (int i = 0; i < b->settings.count; i++) {
    const struct setting *s = &b->settings.list[i];
    bool stood = i == 1;
    assert_string_equal(s->status, status[i]);
    assert_false(s->solved || s->front[VELOCITY] || s->front[DISPLACEMENT]);
    assert_int_equal(s->time.repetitions, 0);
    assert_true(setting_has(s, VELOCITY) && setting_has(s, DISPLACEMENT));
    CHECK_NEAR(s->error_log10[VELOCITY], stood ? log10(0.25) : NAN, 1e-12);
    assert_string_equal(s->error[VELOCITY], stood ? "0.250" : "nan");
  }
  assert_true(b->settings.list[2].time.median > 0); /* not 0.002: the limit began before the first reading */
  bench_clear(b);
}

TEST(errors_as_they_are_written)
{
  CHECK_EQUAL(printed_error_log10("0"), -INFINITY);
  CHECK_EQUAL(printed_error_log10("0.0100"), -2);
  CHECK_NEAR(printed_error_log10("2.00e-500"), log10(2) - 500, 1e-12);
  CHECK_NEAR(printed_error_log10("3.5E+2"), log10(350), 1e-12);
  static const char *const bad[] = { "nan", "", "-1", "e-5", "inf" };
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
    CHECK_EQUAL(printed_error_log10(bad[i]), NAN);
  CHECK_EQUAL(printed_seconds(1.23456789e-7), 1.235e-7);
}

int main(void) { return check_run(NULL, NULL); }
