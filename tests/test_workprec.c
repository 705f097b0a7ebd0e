/* compare/workprec_measure on ways made up for it: who is on the front, what is an error, what is said of those without an answer. */
#include <stdlib.h>
#include <time.h>

#include "check.h"
#include "compare/command/commands.h"
#include "compare/workprec/workprec.h"
#include "tests/scratch_folder.h"

/* What a made-up way does: waits, and gives the certified answer times (1 + number 1e-3), or what its tolerance says. */
static enum scallop_status give(struct way *way, const struct scallop_patience *patience, struct way_answer *answer)
{
  const struct timespec pause = { .tv_nsec = way->kind == WAY_SIMULATION ? 3000000 : 0 };
  (void)patience;
  if (pause.tv_nsec > 0)
    nanosleep(&pause, NULL);
  *answer = answer_none;
  answer->value[WAY_VELOCITY] = way->point->v_start * (1 + 1e-3 * (double)way->number);
  return SCALLOP_OK;
}

static enum scallop_status end_with(struct way *way, const struct scallop_patience *patience, struct way_answer *answer)
{
  (void)patience;
  *answer = answer_none;
  answer->periods = 17;
  answer->value[WAY_VELOCITY] = way->tolerance;
  return (enum scallop_status)way->number;
}

static enum scallop_status work_forever(struct way *way, const struct scallop_patience *patience, struct way_answer *answer)
{
  (void)way, (void)answer;
  assert_non_null(patience); /* it is not timed again */
  while (patience->lasts(patience->context))
    ;
  return SCALLOP_ESTOPPED;
}

static void say_nothing(void *context, int done, int count, const struct way *way)
{
  int *said = context;
  (void)way;
  assert_int_equal(done, *said);
  assert_true(done < count);
  ++*said;
}

struct bench {
  struct trial point;
  struct ways ways;
};

static struct bench *bench_make(void)
{
  struct bench *b = calloc(1, sizeof *b);
  struct scallop_crawler crawler = scallop_crawler_default();
  crawler.alpha = 0.7; /* no double: an answer is held to the double, not to 7/10 */
  assert_non_null(b);
  assert_null(point_init(&b->point, &crawler));
  return b;
}

static void bench_clear(struct bench *b)
{
  ways_clear(&b->ways);
  point_clear(&b->point);
  free(b);
}

static struct way *add(struct bench *b, enum way_kind kind, long number,
                       enum scallop_status (*solve)(struct way *, const struct scallop_patience *, struct way_answer *))
{
  struct way *way = ways_add(&b->ways, &b->point, "made up", kind, "%ld", number);
  way->solve = solve;
  way->number = number;
  return way;
}

static void measure(struct bench *b, double limit)
{
  struct stopwatch_clock clock = stopwatch_clock();
  int said = 0;
  const struct workprec_progress progress = { say_nothing, &said };
  ways_measure(&b->ways, &clock, limit, &progress);
  assert_int_equal(said, b->ways.count);
}

/* Fast ones take no time to speak of, simulations 3 ms. */
static void the_front(void **state)
{
  (void)state;
  struct bench *b = bench_make();
  enum { ASIDE, SLOW_RIGHT, SLOW_WRONG, FAST_WRONG, SLOW_WORSE, COUNT };
  static const struct {
    enum way_kind kind;
    long number;
  } made[COUNT] = {
    { WAY_ASIDE, 0 }, { WAY_SIMULATION, 0 }, { WAY_SIMULATION, 2 }, { WAY_EXACT, 2 }, { WAY_SIMULATION, 3 }
  };
  for (int i = 0; i < COUNT; i++)
    add(b, made[i].kind, made[i].number, give);
  measure(b, 0.05);
  const struct way *list = b->ways.list;
  for (int i = 0; i < COUNT; i++) {
    assert_string_equal(list[i].status, "ok");
    assert_true(way_has(&list[i], WAY_VELOCITY) && !way_has(&list[i], WAY_DISPLACEMENT));
    assert_true(list[i].time.repetitions >= 1 && list[i].time.least > 0);
    if (made[i].number == 0)
      CHECK_AT_MOST(list[i].error_log10[WAY_VELOCITY], -15.9); /* rounding                              */
    else
      CHECK_NEAR(list[i].error_log10[WAY_VELOCITY], log10(1e-3 * (double)made[i].number), 0.003);
    CHECK_EQUAL(list[i].error_log10[WAY_DISPLACEMENT], NAN);
    assert_false(list[i].front[WAY_DISPLACEMENT]);
  }
  assert_false(list[ASIDE].front[WAY_VELOCITY]);     /* not asked                                       */
  assert_true(list[SLOW_RIGHT].front[WAY_VELOCITY]); /* nor does it beat anybody                        */
  assert_false(list[SLOW_WRONG].front[WAY_VELOCITY]);
  assert_true(list[FAST_WRONG].front[WAY_VELOCITY]);
  assert_false(list[SLOW_WORSE].front[WAY_VELOCITY]);
  bench_clear(b);
}

static void those_without_an_answer(void **state)
{
  (void)state;
  struct bench *b = bench_make();
  add(b, WAY_ROOT, SCALLOP_ECONVERGE, end_with);
  add(b, WAY_ROOT, SCALLOP_STOPPED, end_with)->tolerance = b->point.v_start * 1.25;
  add(b, WAY_ROOT, 0, work_forever);
  add(b, WAY_ROOT, SCALLOP_OK, end_with)->tolerance = INFINITY;
  add(b, WAY_ROOT, 0, give)->release = free; /* and no memory                                         */
  add(b, WAY_LEFT_OUT, 0, NULL);
  measure(b, 0.002);
  static const char *const status[] = { "no convergence",
                                        "cut off after 0.002 s: 17 periods",
                                        "cut off after 0.002 s, in its first period",
                                        "not a finite number",
                                        "out of memory",
                                        "" };
  for (int i = 0; i < b->ways.count; i++) {
    const struct way *way = &b->ways.list[i];
    bool stood = i == 1;
    assert_string_equal(way->status, status[i]);
    assert_false(way->solved || way->front[WAY_VELOCITY] || way->front[WAY_DISPLACEMENT]);
    assert_int_equal(way->time.repetitions, 0);
    assert_true(way_has(way, WAY_VELOCITY) && way_has(way, WAY_DISPLACEMENT));
    CHECK_NEAR(way->error_log10[WAY_VELOCITY], stood ? log10(0.25) : NAN, 1e-12);
    assert_string_equal(way->error[WAY_VELOCITY], stood ? "0.250" : "nan");
  }
  assert_true(b->ways.list[2].time.median >= 0.002);
  bench_clear(b);
}

static void errors_as_they_are_written(void **state)
{
  (void)state;
  CHECK_EQUAL(way_error_log10("0"), -INFINITY);
  CHECK_EQUAL(way_error_log10("0.0100"), -2);
  CHECK_NEAR(way_error_log10("2.00e-500"), log10(2) - 500, 1e-12);
  CHECK_NEAR(way_error_log10("3.5E+2"), log10(350), 1e-12);
  static const char *const bad[] = { "nan", "", "-1", "1e", "1e-5x", "e-5", "inf", "1x" };
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
    CHECK_EQUAL(way_error_log10(bad[i]), NAN);
  CHECK_EQUAL(way_seconds(1.23456789e-7), 1.235e-7);
}

static void points_that_cannot_be(void **state)
{
  (void)state;
  struct scallop_crawler crawler = scallop_crawler_default();
  struct trial point;
  crawler.m1 = 1e-300;
  crawler.m2 = 1e300;
  assert_non_null(point_init(&point, &crawler));
  point_clear(&point);
  crawler = scallop_crawler_default();
  crawler.F1 = NAN;
  assert_non_null(point_init(&point, &crawler));
  point_clear(&point);
}

/* A way that has been measured: its error, and its time */
static void add_measured(struct bench *b, enum way_kind kind, const char *method, const char *error, double seconds)
{
  struct way *way = ways_add(&b->ways, &b->point, method, kind, "as is");
  way->solved = true;
  way->time.median = seconds;
  snprintf(way->error[WAY_VELOCITY], WAY_TEXT, "%s", error);
  way->error_log10[WAY_VELOCITY] = way_error_log10(error);
  way->error_log10[WAY_DISPLACEMENT] = NAN;
}

static void who_is_cheapest(void **state)
{
  (void)state;
  struct bench *b = bench_make();
  add_measured(b, WAY_ASIDE, "batch", "1e-16", 1e-9); /* answers another question */
  add_measured(b, WAY_FORMULA, "published", "1.00e-6", 1e-7);
  add_measured(b, WAY_EXACT, "exact", "1e-16", 1e-6);
  add_measured(b, WAY_EXACT, "certified", "2.00e-500", 1e-3);
  add_measured(b, WAY_ROOT, "gsl, root", "1.00e-4", 1e-4);
  add_measured(b, WAY_SIMULATION, "gsl, simulated", "1.00e-4", 5e-4);
  static const char *const expected[][2] = {
    { "1e-2",
      "published\tas is\t1.00e-6\texact\tas is\t10\texact\tas is\t10\tgsl, root\tas is\t100\tgsl, simulated\tas is\t500" },
    { "1e-4",
      "published\tas is\t1.00e-6\texact\tas is\t10\texact\tas is\t10\tgsl, root\tas is\t100\tgsl, simulated\tas is\t500" },
    { "1e-6", "published\tas is\t1.00e-6\texact\tas is\t10\texact\tas is\t10\t-\t-\tnan\t-\t-\tnan" },
    { "1e-8", "exact\tas is\t1e-16\tcertified\tas is\t1e+03\texact\tas is\t1\t-\t-\tnan\t-\t-\tnan" },
    { "1e-10", "exact\tas is\t1e-16\tcertified\tas is\t1e+03\texact\tas is\t1\t-\t-\tnan\t-\t-\tnan" },
    { "1e-12", "exact\tas is\t1e-16\tcertified\tas is\t1e+03\texact\tas is\t1\t-\t-\tnan\t-\t-\tnan" },
    { "1e-15", "exact\tas is\t1e-16\tcertified\tas is\t1e+03\texact\tas is\t1\t-\t-\tnan\t-\t-\tnan" },
    { "1e-30", "certified\tas is\t2.00e-500\t-\t-\tnan\tcertified\tas is\t1\t-\t-\tnan\t-\t-\tnan" },
    { "1e-100", "certified\tas is\t2.00e-500\t-\t-\tnan\tcertified\tas is\t1\t-\t-\tnan\t-\t-\tnan" },
  };
  const char *const file = "summary.tsv";
  const struct style style = { .command = "workprec" };
  struct table table;
  char line[400], wanted[400];
  assert_true(table_open_at(&table, &style, file));
  table_columns(&table, summary_columns);
  table_begin_rows(&table);
  summary_write(&table, &b->ways);
  assert_true(table_close(&table));
  FILE *written = fopen(file, "r");
  assert_non_null(written);
  assert_non_null(fgets(line, sizeof line, written)); /* the header */
  for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
    snprintf(wanted, sizeof wanted, "quadratic\t1\tv_start\t%s\t%s\n", expected[i][0], expected[i][1]);
    assert_non_null(fgets(line, sizeof line, written));
    assert_string_equal(line, wanted);
  }
  assert_null(fgets(line, sizeof line, written));
  fclose(written);
  remove(file);
  bench_clear(b);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(the_front),
    cmocka_unit_test(those_without_an_answer),
    cmocka_unit_test(errors_as_they_are_written),
    cmocka_unit_test(who_is_cheapest),
    cmocka_unit_test(points_that_cannot_be),
  };
  return cmocka_run_group_tests(tests, scratch_begin, scratch_end);
}
