/* A formula made of the paper's and of random terms, for a random crawler and gait, from rest, from v0 or in the steady
 * state: the verdict must not contradict itself (numbers against names, expansion against certified errors), and what
 * is undecided has a reason. */
#include <stdio.h>
#include <string.h>

#include "asymptotics/asymptotics.h"
#include "compare/points/gaits.h"
#include "compare/claims/claims.h"
#include "tests/fuzz/target.h"
#include "tests/support/scoped.h"

struct bytes {
  const uint8_t *data;
  size_t size;
};

/* 0 <= byte < below; 0 behind the last one */
static int take(struct bytes *b, int below)
{
  if (b->size == 0)
    return 0;
  b->size--;
  return below > 0 ? *b->data++ % below : 0;
}

static void take_fraction(fmpq_t x, struct bytes *b, int below)
{
  fmpq_set_si(x, 1 + take(b, below - 1), (ulong)below);
}

static void take_crawler(struct scallop_rational_crawler *c, struct bytes *b)
{
  static const char *const gaits[] = {
    "quadratic",    "sinusoidal",           "trapezoidal:0.2,0.3",        "skewed:0.3",
    "constant:0.1", "minimum-jerk",         "polynomial:0,3,-2",          "polynomial:0,0,4,-3",
    "constant:0",   "polynomial:0,12,4,-9", "trapezoidal:0.1,0.4,0.3,0.2"
  };
  fmpq *const numbers[] = { c->m1, c->m2, c->F1, c->F2, c->L };
  c->gait = gait_of_text(gaits[take(b, sizeof gaits / sizeof *gaits)]).gait;
  for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
    take_fraction(numbers[i], b, 64);
    fmpq_mul_2exp(numbers[i], numbers[i], 3);
  }
  if (take(b, 4) == 3)
    fmpq_mul_si(c->F2, c->F1, 1);
  take_fraction(c->alpha, b, 16);
}

/* The formula of the paper's lists to begin with */
static const struct scallop_formula *take_formula(struct bytes *b)
{
  int count = 0;
  while (scallop_published[count].name)
    count++;
  return &scallop_published[take(b, count)];
}

static void take_terms(char *text, size_t size, struct bytes *b, bool steady)
{
  static const char *const names[] = { "m1",     "m2",      "F1",     "F2", "M",     "L",  "l0",
                                       "lT",     "k0",      "kT",     "pi", "L_kin", "T",  "7",
                                       "exp(1)", "sqrt(2)", "sin(T)", "v0", "t1",    "dT", "x_switch" };
  enum { STEADY_NAMES = 17 };
  const int count = steady ? STEADY_NAMES : (int)(sizeof names / sizeof *names);
  for (int i = take(b, 4); i > 0; i--) {
    size_t used = strlen(text);
    used += (size_t)snprintf(text + used, size - used, " %c %s", "+-"[take(b, 2)], names[take(b, count)]);
    for (int j = take(b, 4); j > 0; j--)
      used += (size_t)snprintf(text + used, size - used, "%c%s", "*/"[take(b, 2)], names[take(b, count)]);
    const int power = take(b, 14);
    snprintf(text + used, size - used, "*T^%d", power < 12 ? power - 3 : power == 12 ? -40 : 80);
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  struct bytes bytes = { data, size };
  struct claim_table claims = { .rows = NULL };
  SCOPED(scallop_rational, crawler);
  take_crawler(&crawler, &bytes);
  struct scallop_formula f = *take_formula(&bytes);
  char text[2000];
  snprintf(text, sizeof text, "%s", f.text ? f.text : "0");
  if (take(&bytes, 4) == 0)
    snprintf(text, sizeof text, "0");
  take_terms(text, sizeof text, &bytes, f.setting == SCALLOP_STEADY);
  f.text = text;
  f.remainder = take(&bytes, 8) - 1; /* -1: an equality */
  f.remainder += f.remainder == 0;
  f.when = NULL;
  claim_table_add_formula(&claims, &crawler, true, &f);
  const struct claim_row *row = claims.rows;
  if (*claims.contradiction)
    fuzz_fail("%s, %s of %s: %s", text, scallop_quantity_words[f.quantity], crawler.gait->name, claims.contradiction);
  if (row->verdict == CLAIM_UNDECIDED && !*row->reason)
    fuzz_fail("%s: undecided without a reason", text);
  claim_table_free(&claims);
  return 0;
}
