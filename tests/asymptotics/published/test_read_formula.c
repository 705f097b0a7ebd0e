/* Formulas that were read once, through the public face, against the paper's values and against C arithmetic. */
#include <stdio.h>
#include <string.h>

#include "asymptotics/asymptotics.h"
#include "asymptotics/formula.h"
#include "asymptotics/published/read.h"
#include "tests/support/random_crawler.h"

static struct scallop_read_formula *must_read(const struct scallop_formula *formula)
{
  char message[SCALLOP_FORMULA_MESSAGE] = "";
  struct scallop_read_formula *read = scallop_formula_read(formula, message);
  if (!read)
    fail_msg("\"%s\": %s", formula->text, message);
  return read;
}

static struct scallop_crawler some_crawler(struct random *r, const struct scallop_gait *gait)
{
  const struct scallop_crawler crawler = { random_decades(r, 0.1, 10),  random_decades(r, 0.1, 10),
                                           random_decades(r, 0.1, 10),  random_decades(r, 0.1, 10),
                                           random_decades(r, 0.1, 10),  random_decades(r, 0.1, 10),
                                           random_between(r, 0.1, 0.9), gait };
  return crawler;
}

/* Every formula of the paper and every correction: read once and evaluated often, it is scallop_published_value to the
 * last bit. */
TEST(published_formulas)
{
  const struct scallop_formula *const lists[] = { scallop_published, scallop_corrected };
  struct random r = { 20261122 };
  int values = 0;
  for (int i = 0; i < 2; i++)
    for (const struct scallop_formula *f = lists[i]; f->name; f++) {
      struct scallop_read_formula *read = must_read(f);
      for (int k = 0; k < 8; k++) {
        struct scallop_crawler c = some_crawler(&r, every_gait[k % 3]);
        enum scallop_phase_kind kind = k % 2 ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION;
        double v0 = random_between(&r, -3, 3), t1 = random_between(&r, 0, 1), dT = random_between(&r, 0, 1),
               x = t1 - dT;
        double got = scallop_formula_double(read, &c, kind, v0, t1, dT, x);
        CHECK_EQUAL(got, scallop_published_value(f, &c, kind, v0, t1, dT, x));
        values += isfinite(got) != 0;
      }
      scallop_formula_free(read);
    }
  assert_true(values > 400);
}

/* The row and its texts are gone when the formula is evaluated. */
static struct scallop_read_formula *read_from_the_stack(enum scallop_setting setting, const char *text)
{
  char texts[2][80], name[] = "mstar";
  snprintf(texts[0], sizeof texts[0], "%s", text);
  snprintf(texts[1], sizeof texts[1], "m1*m2/M");
  const struct scallop_part parts[] = { { name, texts[1] }, { NULL, NULL } };
  const struct scallop_formula row = { .setting = setting, .text = texts[0], .parts = parts };
  struct scallop_read_formula *read = must_read(&row);
  memset(texts, '?', sizeof texts);
  memset(name, '?', sizeof name);
  return read;
}

/* The formula and the arithmetic beside it round at most 12 times each. */
#define ROUNDING (24 * 0x1p-53)

TEST(own_formulas)
{
  static const char text[] = "-(F1 - F2)/mstar*T^2*sqrt(L)/8";
  static const enum scallop_setting settings[] = { SCALLOP_AT_REST_START, SCALLOP_MOVING_EXTENSION,
                                                   SCALLOP_MOVING_CONTRACTION, SCALLOP_STEADY };
  const struct scallop_crawler c = { 1.3, 0.9, 3.7, 1.1, 2.3, 0.7, 0.6, &scallop_gait_quadratic };
  const double scale = sqrt(2.3) / 8 * (1.3 + 0.9) / (1.3 * 0.9), T = 0.7;
  for (int i = 0; i < 4; i++) {
    struct scallop_read_formula *read = read_from_the_stack(settings[i], text);
    bool steady = settings[i] == SCALLOP_STEADY, from_extension = i < 2;
    double in_extension = steady ? T : 0.6 * T, in_contraction = steady ? T : 0.4 * T;
    double exchange = from_extension ? -1 : 1; /* F1 - F2 */
    CHECK_RELATIVE(scallop_formula_double(read, &c, SCALLOP_EXTENSION, 0, NAN, NAN, NAN),
                   -(3.7 - 1.1) * scale * in_extension * in_extension, ROUNDING);
    CHECK_RELATIVE(scallop_formula_double(read, &c, SCALLOP_CONTRACTION, 0, NAN, NAN, NAN),
                   -(3.7 - 1.1) * exchange * scale * in_contraction * in_contraction, ROUNDING);
    scallop_formula_free(read);
  }
}

TEST(given_values)
{
  const struct scallop_crawler c = scallop_crawler_default();
  const struct scallop_formula row = { .setting = SCALLOP_MOVING_EXTENSION, .text = "v0 + 2*t1 + 4*dT + 8*x_switch" };
  struct scallop_read_formula *read = must_read(&row);
  CHECK_EQUAL(scallop_formula_double(read, &c, SCALLOP_EXTENSION, 1, 16, 256, 4096), 33825);
  CHECK_EQUAL(scallop_formula_double(read, &c, SCALLOP_EXTENSION, 1, 16, NAN, 4096), NAN);
  static const enum scallop_symbol taken[] = { SCALLOP_SYMBOL_v0, SCALLOP_SYMBOL_t1, SCALLOP_SYMBOL_dT,
                                               SCALLOP_SYMBOL_x_switch };
  for (int i = 0; i < SCALLOP_SYMBOLS; i++) {
    bool is_taken = false;
    for (int k = 0; k < 4; k++)
      is_taken = is_taken || taken[k] == (enum scallop_symbol)i;
    assert_int_equal(scallop_formula_takes(read, (enum scallop_symbol)i), is_taken);
  }
  scallop_formula_free(read);
  scallop_formula_free(NULL);
}

TEST(refusals)
{
  static const struct scallop_part loop[] = { { "a", "b + 1" }, { "b", "F1*(" }, { NULL, NULL } };
  static const struct {
    enum scallop_setting setting;
    const char *text;
    const struct scallop_part *parts;
    const char *message;
  } refused[] = {
    { SCALLOP_STEADY, "2*(F1 - F2", NULL, "character 3: this '(' is not closed" },
    { SCALLOP_STEADY, "", NULL, "character 1: there is no formula" },
    { SCALLOP_STEADY, "F3*T", NULL, "character 1: 'F3' is no quantity known here" },
    { SCALLOP_STEADY, "F1 + a", loop, "b, character 5: a number, a name or '(' is missing before the end" },
    { SCALLOP_STEADY, "v0*T", NULL, "the steady state has no v0" },
    { SCALLOP_STEADY, "F1*x_switch", NULL, "the steady state has no x_switch" },
  };
  for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
    const struct scallop_formula row = { .setting = refused[i].setting,
                                         .text = refused[i].text,
                                         .parts = refused[i].parts };
    char message[SCALLOP_FORMULA_MESSAGE] = "";
    assert_null(scallop_formula_read(&row, message));
    assert_string_equal(message, refused[i].message);
  }
}

/* The name that has the same last letter */
static const char *same_end(const char *name, const char *const *names)
{
  while (*names && (*names)[strlen(*names) - 1] != name[strlen(name) - 1])
    names++;
  return *names;
}

TEST(a_misspelt_part_is_among_the_names)
{
  static const struct scallop_part parts[] = { { "halfz", "F1/2" }, { NULL, NULL } };
  const struct scallop_formula row = { .setting = SCALLOP_STEADY, .text = "T*hafz", .parts = parts };
  char message[FORMULA_MESSAGE] = "";
  struct formula read;
  assert_non_null(scallop_formula_text(&read, &row, same_end, message));
  assert_string_equal(message, "character 3: 'hafz' is no quantity known here: did you mean 'halfz'?");
}
