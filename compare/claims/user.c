/* Claims of a formula file, `claims --formulas` and `claims --formula`: each formula for each gait, for the given
 * crawler or one that meets its conditions. */
#define _GNU_SOURCE /* asprintf */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/symbolic/left_out.h"
#include "compare/claims/decide.h"
#include "compare/points/point_flint.h"

enum { PRECISION = 1400, MODES_PRECISION = 192 };

/* Conditions */

static enum scallop_phase_kind phase_of(const struct scallop_formula *f)
{
  return f->setting == SCALLOP_MOVING_CONTRACTION ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION;
}

/* Evaluates one side of a condition, a constant, for the crawler. False: it has no value, as 1/0 */
static bool side_value(struct series *value, const char *text, const struct scallop_formula *f,
                       const struct scallop_rational_crawler *c)
{
  const struct ring ring = { 1, PRECISION };
  struct scallop_formula side = *f;
  char message[FORMULA_MESSAGE];
  SCOPED(scallop_symbols, symbols);
  side.text = text;
  scallop_symbols_set(&symbols, c, phase_of(f), NULL, NULL, &ring);
  return !scallop_formula_expand(value, &side, &symbols, phase_of(f), &ring, message);
}

/* Sets the parameter left of an equality, "F1 = F2", if the value is a fraction. */
static void set_equality(struct scallop_rational_crawler *c, const char *when, const struct scallop_formula *f)
{
  struct scallop_sides sides;
  char name[8], more;
  SCOPED(series, value);
  if (scallop_condition_split(&sides, when) != '=' || sscanf(sides.left, " %7s %c", name, &more) != 1)
    return;
  int place = crawler_place(name);
  if (place < CRAWLER_NUMBERS && side_value(&value, sides.right, f, c))
    series_rational_coefficient(rational_field(c, place), &value, 0);
}

static void set_equalities(const struct scallop_formula *f, struct scallop_rational_crawler *c)
{
  enum { AGAIN = 6 };
  for (int again = 0; again < AGAIN; again++) /* one may need what another sets */
    for (const char *const *when = f->when; when && *when; when++)
      set_equality(c, *when, f);
}

/* Returns true if LEFT < RIGHT, > or = is proven; never for an equality with values of functions. */
static bool is_met(const char *when, const struct scallop_formula *f, const struct scallop_rational_crawler *c)
{
  const struct ring ring = { 1, PRECISION };
  struct scallop_sides sides;
  SCOPED(series, left, right);
  SCOPED(arb, difference);
  char sign = scallop_condition_split(&sides, when);
  if (!sign || !side_value(&left, sides.left, f, c) || !side_value(&right, sides.right, f, c))
    return false;
  series_sub(&left, &left, &right, &ring);
  series_coefficient(difference, &left, 0, PRECISION);
  return sign == '<'   ? arb_is_negative(difference)
         : sign == '>' ? arb_is_positive(difference)
                       : series_coefficient_is_zero(&left, 0);
}

/* Returns true if the limit of the steady state has the turns that the formula assumes; false without an expansion. */
static bool turns_there(const struct scallop_formula *f, const struct scallop_rational_crawler *c)
{
  SCOPED(scallop_expansion, limit);
  return scallop_expand_steady(c, 1, MODES_PRECISION, &limit, NULL) == SCALLOP_OK
         && turns_in_modes(limit.modes) == f->turns;
}

static bool is_for(const struct scallop_formula *f, const struct scallop_rational_crawler *c)
{
  bool allowed = scallop_rational_is_valid(c);
  for (const char *const *when = f->when; when && *when && allowed; when++)
    allowed = is_met(*when, f, c);
  return allowed && (f->turns == SCALLOP_TURNS_IN_BOTH || turns_there(f, c));
}

/* splitmix64 (Steele, Lea & Flood 2014) */
static uint64_t random_bits(uint64_t *state)
{
  uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
  z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
  return z ^ (z >> 31);
}

/* Each a/b, a and b from 1 to 997, alpha k/997 */
static void random_crawler(struct scallop_rational_crawler *c, uint64_t *state)
{
  for (int i = 0; i < 5; i++)
    fmpq_set_si(rational_field(c, i), (slong)(1 + random_bits(state) % 997), 1 + random_bits(state) % 997);
  fmpq_set_si(c->alpha, (slong)(1 + random_bits(state) % 996), 997);
}

/* Changes the crawler to meet the formula's conditions: sets parameters as equalities require; if this fails, tries
 * random crawlers. False: no crawler was found. */
static bool fit(const struct scallop_formula *f, struct scallop_rational_crawler *c)
{
  enum { TRIES = 10000 };
  uint64_t state = 20260102;
  set_equalities(f, c);
  for (int i = 0; i < TRIES && !is_for(f, c); i++) {
    random_crawler(c, &state);
    set_equalities(f, c);
  }
  return is_for(f, c);
}

/* Rows */

static struct condition condition_of(const struct scallop_formula *f)
{
  static const char *const texts[] = { "extension from rest", "extension, v0 > 0 fixed", "contraction, v0 > 0 fixed",
                                       "steady state" };
  bool moving = f->setting == SCALLOP_MOVING_EXTENSION || f->setting == SCALLOP_MOVING_CONTRACTION;
  return (struct condition){ f->setting, phase_of(f), texts[f->setting], .v0 = moving ? CLAIM_SPEED : 0 };
}

static const char *const turns_text[] = { "a body turns in both phases", "no body turns in the contraction",
                                          "no body turns in the extension" };

/* Appends the conditions, ", alpha > 1/2, F1 > F2". */
static void write_conditions(struct claim_row *row, const struct scallop_formula *f)
{
  for (const char *const *when = f->when; when && *when; when++)
    append(row->conditions, sizeof row->conditions, ", %s", *when);
  if (f->turns != SCALLOP_TURNS_IN_BOTH)
    append(row->conditions, sizeof row->conditions, ", %s", turns_text[f->turns]);
}

/* Writes v0 and the numbers of the crawler that were changed, "v0=8/5 F1=3/2 F2=1/2". */
static void write_change(struct claim_row *row, struct scallop_rational_crawler *now,
                         struct scallop_rational_crawler *before, const fmpq_t v0)
{
  for (int i = -1; i < CRAWLER_NUMBERS; i++) {
    const fmpq *x = i < 0 ? v0 : rational_field(now, i);
    if (i < 0 ? fmpq_is_zero(v0) : fmpq_equal(x, rational_field(before, i)))
      continue;
    char *text = decimal_fraction(x);
    append(row->summary, sizeof row->summary, "%s%s=%s", *row->summary ? " " : "", i < 0 ? "v0" : crawler_parameters[i],
           text);
    flint_free(text);
  }
}

/* Returns the reason why the claim cannot be decided, or NULL. */
static const char *undecided(const struct scallop_formula *f, const struct trial *trial, bool is_met)
{
  static _Thread_local char text[240];
  if (!is_met)
    return "no crawler was found for which the conditions hold";
  if (trial->series.status != SCALLOP_OK) {
    snprintf(text, sizeof text, "no expansion in powers of T is known for this motion: %s", trial->series.why);
    return text;
  }
  enum scallop_turns found = turns_in_modes(trial->series.modes);
  if (!trial_is_steady(trial) || !f->turns || found == f->turns)
    return NULL;
  snprintf(text, sizeof text, "the formula assumes that, as T -> 0, %s; for this crawler, %s", turns_text[f->turns],
           turns_text[found]);
  return text;
}

/* Returns the derived terms below the claimed power of T, as a formula that can replace the given one; NULL if they are
 * not known as a formula. */
static char *derived_text(const struct scallop_formula *f, const struct trial *trial)
{
  struct scallop_formula sum = *f;
  char *text = strdup("0"), *more, message[FORMULA_MESSAGE];
  bool is_known = f->remainder > 0, has_next = is_known;
  for (int terms = 0; has_next && text; terms++) {
    ENDED_BY(left_out_clear) struct left_out l;
    left_out_init(&l);
    sum.text = text;
    is_known = !symbolic_left_out(&l, &sum, &trial->crawler, trial->condition->kind, trial->v0, f->remainder - 1,
                                  message);
    has_next = is_known && l.order < f->remainder;
    const bool minus = has_next && *l.term == '-';
    if (!has_next
        || asprintf(&more, "%s%s%s", terms > 0 ? text : "",
                    terms == 0 ? ""
                    : minus    ? " - "
                               : " + ",
                    l.term + (terms > 0 && minus))
               < 0)
      break;
    free(text);
    text = more;
  }
  if (!is_known)
    free(text);
  return is_known ? text : NULL;
}

/* Adds a row. derived: set to the derived terms if the formula is refuted; NULL: only the verdict is requested */
static void add_row(struct claim_table *claims, const struct scallop_rational_crawler *crawler, bool is_given,
                    const struct scallop_formula *f, enum claim_source source, char **derived)
{
  const struct condition condition = condition_of(f);
  struct claim_row row = row_of_formula(f, crawler->gait, &condition);
  SCOPED(scallop_rational, before, now);
  ENDED_BY(trial_clear) struct trial trial;
  row.source = source;
  row.any_crawler = !is_given;
  write_conditions(&row, f);
  scallop_rational_copy(&before, crawler);
  scallop_rational_copy(&now, crawler);
  row.inside = is_given ? is_for(f, &now) : fit(f, &now);
  trial_begin(&trial, &now, &condition, false);
  write_change(&row, &now, &before, trial.v0);
  row.formula = derived ? strdup(f->text) : NULL;
  row.error_at_T = derived ? trial_error_at_T(&trial, f) : NAN;
  claim_table_decide(claims, &row, &trial, f, undecided(f, &trial, is_given || row.inside));
  if (derived && row.verdict == CLAIM_REFUTED && !f->corrected)
    *derived = derived_text(f, &trial);
}

void claim_table_add_formula(struct claim_table *claims, const struct scallop_rational_crawler *crawler, bool is_given,
                             const struct scallop_formula *f)
{
  add_row(claims, crawler, is_given, f, OF_USER, NULL);
}

/* Adds a row, and after a refuted formula a row of the derived terms below the claimed order. */
static void add_with_correction(struct claim_table *claims, const struct scallop_rational_crawler *crawler,
                                bool is_given, const struct scallop_formula *f)
{
  char name[CLAIM_NAME], *derived = NULL, *unused = NULL;
  add_row(claims, crawler, is_given, f, OF_USER, &derived);
  if (!derived)
    return;
  struct scallop_formula right = *f;
  snprintf(name, sizeof name, "%.50s:derived", f->name);
  append(claims->rows[claims->count - 1].corrected, CLAIM_NAME, "%s", name);
  right.name = name;
  right.text = derived;
  right.parts = NULL;
  add_row(claims, crawler, is_given, &right, OF_CORRECTED, &unused);
  free(derived);
  free(unused);
}

void claim_table_add_user(struct claim_table *claims, const struct scallop_rational_crawler *crawler, bool is_given,
                          const char *only)
{
  const struct scallop_formula *f;
  for (int i = 0; (f = user_formula(i)); i++)
    if (f->remainder != 0 && (!only || formula_is_listed(only, f->name)) && !claim_table_expects(claims))
      add_with_correction(claims, crawler, is_given, f);
}
