/* Dimensions of formulas, from their values before and after a change of the units of mass, length and time. */
#include <math.h>
#include <string.h>

#include "compare/claims/decide.h"
#include "compare/points/point_flint.h"

enum { UNITS = 3, TEXT = 100 };

/* Returns the value of the formula, or the exact value of its quantity, after a change of one unit. */
static double value_in(const struct scallop_formula *f, struct motion m, bool exact, int unit, double factor)
{
  struct scallop_crawler *c = &m.crawler;
  double by[UNITS] = { 1, 1, 1 };
  struct answer a;
  by[unit] = factor;
  c->m1 *= by[0], c->m2 *= by[0];
  c->F1 *= by[0] * by[1] / by[2] / by[2], c->F2 *= by[0] * by[1] / by[2] / by[2];
  c->L *= by[1], c->T *= by[2], m.v0 *= by[1] / by[2];
  if (!answer_in_double(&a, &m) || answer_complete(&a, &m) != SCALLOP_OK)
    return NAN;
  return exact ? a.value[quantity_of_formula(f, m.phase)].high : published_value(f, &m, &a);
}

/* Returns "mass length/time^2", "a pure number", "" for a sum of unlike quantities, NULL if undecided. */
static const char *dimension(char text[TEXT], const struct scallop_formula *f, const struct motion *m, bool exact)
{
  static const char *const names[] = { "mass", "length", "time" };
  double power[UNITS];
  *text = '\0';
  for (int i = 0; i < UNITS; i++) {
    const double value = value_in(f, *m, exact, i, 1);
    power[i] = log2(value_in(f, *m, exact, i, 2) / value);
    if (!isfinite(value) || value == 0)
      return NULL;
    if (!(fabs(power[i] - log(value_in(f, *m, exact, i, 3) / value) / log(3)) < 1e-6))
      return text;
    power[i] = rint(power[i] * 60) / 60;
  }
  for (int sign = 1; sign >= -1; sign -= 2)
    for (int i = 0; i < UNITS; i++) {
      if (sign * power[i] > 0)
        append(text, TEXT, "%s%s", sign > 0 ? *text ? " " : "" : *text ? "/" : "1/", names[i]);
      if (sign * power[i] > 0 && sign * power[i] != 1)
        append(text, TEXT, "^%g", sign * power[i]);
    }
  return *text ? text : "a pure number";
}

bool dimension_refutes(char why[DIMENSION_WHY], const struct trial *trial, const struct scallop_formula *f)
{
  struct motion m = { trial_is_steady(trial) ? OF_STEADY : OF_PHASE, .phase = trial->condition->kind };
  struct scallop_rational_crawler c = trial->crawler;
  char texts[2][TEXT];
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    *crawler_field(&m.crawler, i) = fmpq_get_d(rational_field(&c, i));
  m.crawler.gait = c.gait;
  m.v0 = fmpq_get_d(trial->v0);
  const char *is = dimension(texts[0], f, &m, false), *expected = dimension(texts[1], f, &m, true);
  if (!is || !expected || !*expected || strcmp(is, expected) == 0)
    return false;
  snprintf(why, DIMENSION_WHY, "by dimension: %s and not %s", *is ? is : "a sum of unlike quantities", expected);
  return true;
}
