#include "compare/claims/trial.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/derived/scoped.h"
#include "asymptotics/published/read.h"
#include "asymptotics/symbolic/left_out.h"
#include "compare/answers/answer.h"
#include "compare/claims/evidence.h"

enum { TERMS = 14, MANY_TERMS = 48, PRECISION = 1400, MODES_PRECISION = 192, MOST_OF_EQUALITY = 11 };

/* One crawler's expansion, with what the formulas need */
struct expanded {
  struct scallop_rational_crawler crawler;
  fmpq_t v0;
  slong terms;
  struct scallop_phase_expansion phase;
  struct scallop_steady_expansion steady;
};

bool trial_is_steady(const struct trial *m) { return m->condition->setting == SCALLOP_STEADY; }

static const char *modes_of(const struct expanded *e, const struct trial *m)
{
  return trial_is_steady(m) ? e->steady.modes : e->phase.modes;
}

const char *trial_modes(const struct trial *m) { return modes_of(m->expanded, m); }

static const struct series *series_of(const struct expanded *e, const struct trial *m, enum scallop_quantity quantity)
{
  return trial_is_steady(m) ? scallop_steady_quantity(&e->steady, quantity)
                            : scallop_phase_quantity(&e->phase, m->condition->kind, quantity);
}

const struct series *trial_series(const struct trial *m, enum scallop_quantity quantity)
{
  return series_of(m->expanded, m, quantity);
}

/* Expansions */

static void expanded_free(struct expanded *e)
{
  if (!e)
    return;
  scallop_rational_clear(&e->crawler);
  fmpq_clear(e->v0);
  scallop_phase_expansion_clear(&e->phase);
  scallop_steady_expansion_clear(&e->steady);
  free(e);
}

static bool expand(struct expanded *e, const struct trial *m, slong terms, const char **why)
{
  e->terms = terms;
  return (trial_is_steady(m)
              ? scallop_expand_steady(&e->crawler, terms, PRECISION, &e->steady, why)
              : scallop_expand_phase(&e->crawler, m->condition->kind, e->v0, terms, PRECISION, NULL, &e->phase, why))
         == SCALLOP_OK;
}

/* Not yet expanded */
static struct expanded *expanded_new(const struct trial *m)
{
  struct expanded *e = malloc(sizeof *e);
  if (!e)
    return NULL;
  scallop_rational_init(&e->crawler);
  scallop_rational_copy(&e->crawler, &m->crawler);
  fmpq_init(e->v0);
  fmpq_set(e->v0, m->v0);
  scallop_phase_expansion_init(&e->phase);
  scallop_steady_expansion_init(&e->steady);
  return e;
}

/* splitmix64 (Steele, Lea & Flood 2014) */
static uint64_t random_bits(uint64_t *state)
{
  uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
  z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
  return z ^ (z >> 31);
}

/* a/b, a and b from 1 to 997 */
static void random_rational(fmpq_t x, uint64_t *state)
{
  fmpq_set_si(x, (slong)(1 + random_bits(state) % 997), 1 + random_bits(state) % 997);
}

/* Not by fmpq_set, which is inline: gcc 12 then warns of reads beyond F1. */
static void make_forces_equal(struct scallop_rational_crawler *c) { fmpq_mul_si(c->F2, c->F1, 1); }

/* The parameter that a condition sets, "F1 = F2", or NULL, and what it is set to */
static fmpq *parameter_set(struct scallop_rational_crawler *c, const char *when, const char **to)
{
  static const char *const names[] = { "m1", "m2", "F1", "F2", "L", "alpha" };
  fmpq *const places[] = { c->m1, c->m2, c->F1, c->F2, c->L, c->alpha };
  size_t length = strcspn(when, " ="), past = length + strspn(when + length, " ");
  if (when[past] != '=')
    return NULL;
  *to = when + past + 1;
  for (int i = 0; i < 6; i++)
    if (strlen(names[i]) == length && strncmp(when, names[i], length) == 0)
      return places[i];
  return NULL;
}

/* One side of a condition, a constant, for the crawler as it is written. False: it has no value, as 1/0 */
static bool side_value(struct series *value, const char *text, const struct condition *condition,
                       const struct scallop_rational_crawler *c)
{
  const struct ring ring = { 1, PRECISION };
  struct scallop_formula side = *condition->formula;
  struct scallop_symbols symbols;
  char message[FORMULA_MESSAGE];
  side.text = text;
  scallop_symbols_init(&symbols);
  scallop_symbols_set(&symbols, c, condition->kind, NULL, NULL, &ring);
  bool has = !scallop_formula_expand(value, &side, &symbols, condition->kind, &ring, message);
  scallop_symbols_clear(&symbols);
  return has;
}

/* Sets the parameters that the conditions say to be equal to something; what is no fraction is not set. */
static void set_equalities(const struct condition *condition, struct scallop_rational_crawler *c)
{
  const struct scallop_formula *f = condition->formula;
  enum { AGAIN = 6 };
  const char *right;
  SCOPED(series, value);
  for (int again = 0; again < AGAIN; again++) /* one may need what another sets */
    for (const char *const *when = f ? f->when : NULL; when && *when; when++) {
      fmpq *parameter = parameter_set(c, *when, &right);
      if (parameter && side_value(&value, right, condition, c))
        series_rational_coefficient(parameter, &value, 0);
    }
}

/* Does LEFT < RIGHT, > or = hold, proven? What depends on a function can be equal to nothing. */
static bool is_met(const char *when, const struct condition *condition, const struct scallop_rational_crawler *c)
{
  const struct ring ring = { 1, PRECISION };
  struct scallop_sides sides;
  SCOPED(series, left, right);
  SCOPED(arb, difference);
  char sign = scallop_condition_split(&sides, when);
  bool met = sign && side_value(&left, sides.left, condition, c) && side_value(&right, sides.right, condition, c);
  if (met) {
    series_sub(&left, &left, &right, &ring);
    series_coefficient(difference, &left, 0, PRECISION);
    met = sign == '<'   ? arb_is_negative(difference)
          : sign == '>' ? arb_is_positive(difference)
                        : series_coefficient_is_zero(&left, 0);
  }
  return met;
}

/* Is the limit of the steady state the one that the formula is for? Not where it has no expansion */
static bool turns_there(const struct scallop_formula *f, const struct scallop_rational_crawler *c)
{
  SCOPED(scallop_steady_expansion, limit);
  bool expands = scallop_expand_steady(c, 1, MODES_PRECISION, &limit, NULL) == SCALLOP_OK;
  return expands && turns_in_modes(limit.modes) == f->turns;
}

bool condition_allows(const struct condition *condition, const struct scallop_rational_crawler *c)
{
  const struct scallop_formula *f = condition->formula;
  bool allowed = !f || scallop_rational_is_valid(c);
  for (const char *const *when = f ? f->when : NULL; when && *when && allowed; when++)
    allowed = is_met(*when, condition, c);
  return allowed && (!f || f->turns == SCALLOP_TURNS_IN_BOTH || turns_there(f, c));
}

static void random_crawler(struct scallop_rational_crawler *r, uint64_t *state)
{
  random_rational(r->m1, state);
  random_rational(r->m2, state);
  random_rational(r->F1, state);
  random_rational(r->F2, state);
  random_rational(r->L, state);
  fmpq_set_si(r->alpha, (slong)(1 + random_bits(state) % 996), 997);
}

bool condition_fit(const struct condition *condition, struct scallop_rational_crawler *c)
{
  enum { TRIES = 10000 };
  uint64_t state = 20260102;
  set_equalities(condition, c);
  for (int i = 0; i < TRIES && !condition_allows(condition, c); i++) {
    random_crawler(c, &state);
    set_equalities(condition, c);
  }
  return condition_allows(condition, c);
}

/* Motions */

void trial_set_rounded(fmpq_t x, double value)
{
  char text[32];
  snprintf(text, sizeof text, "%.1e", value);
  scallop_rational_parse(x, text);
}

/* The crawler under its condition */
static void set_condition(struct trial *m)
{
  const struct condition *condition = m->condition;
  struct scallop_rational_crawler *r = &m->crawler;
  if (condition->exchange_forces)
    fmpq_swap(r->F1, r->F2);
  if (condition->equal_forces)
    make_forces_equal(r);
  if (condition->light_1)
    fmpq_div_fmpz(r->m1, r->m1, (fmpz[]){ 100 });
  if (condition->mirror_alpha)
    scallop_rational_fraction(r->alpha, r, SCALLOP_CONTRACTION);
  double M = fmpq_get_d(r->m1) + fmpq_get_d(r->m2), F = fmpq_get_d(r->F1) + fmpq_get_d(r->F2), L = fmpq_get_d(r->L);
  trial_set_rounded(m->v0, condition->v0 * sqrt(L * F / M));
  if (m->mirrored) {
    fmpq_swap(r->m1, r->m2);
    fmpq_swap(r->F1, r->F2);
    fmpq_neg(m->v0, m->v0);
  }
}

bool trial_init(struct trial *m, const struct scallop_rational_crawler *crawler, const struct condition *condition,
                bool mirrored)
{
  *m = (struct trial){ .condition = condition, .mirrored = mirrored };
  fmpq_init(m->v0);
  scallop_rational_init(&m->crawler);
  scallop_rational_copy(&m->crawler, crawler);
  set_condition(m);
  m->expanded = expanded_new(m);
  m->why = "out of memory";
  bool done = m->expanded && expand(m->expanded, m, TERMS, &m->why);
  if (done)
    m->why = NULL;
  return done;
}

void trial_clear(struct trial *m)
{
  expanded_free(m->expanded);
  scallop_rational_clear(&m->crawler);
  fmpq_clear(m->v0);
}

/* Proofs */

void proof_init(struct proof *p)
{
  *p = (struct proof){ .found = false };
  series_init(&p->left_out);
}

void proof_clear(struct proof *p)
{
  series_clear(&p->left_out);
  free(p->term);
}

slong trial_leading_power(const struct scallop_formula *f) { return f->quantity == SCALLOP_STEADY_VELOCITY ? -1 : 0; }

/* derived - formula, of so many terms */
static bool left_out(struct series *difference, const struct trial *m, const struct scallop_formula *f, slong terms,
                     char why[FORMULA_MESSAGE])
{
  const struct expanded *e = m->expanded;
  const struct ring ring = { terms, PRECISION };
  struct scallop_symbols symbols;
  SCOPED(series, value);
  series_set(difference, series_of(e, m, f->quantity));
  if (!f->text) {
    series_set_zero(difference, trial_leading_power(f));
    return true;
  }
  scallop_symbols_init(&symbols);
  scallop_symbols_set(&symbols, &e->crawler, m->condition->kind, e->v0, NULL, &ring);
  series_set(&symbols.value[SCALLOP_SYMBOL_t1], &e->phase.t1);
  series_set(&symbols.value[SCALLOP_SYMBOL_dT], &e->phase.dT);
  series_set(&symbols.value[SCALLOP_SYMBOL_x_switch], &e->phase.at_last);
  for (int i = SCALLOP_SYMBOL_t1; i <= SCALLOP_SYMBOL_x_switch && !trial_is_steady(m) && !e->phase.switches; i++)
    series_set_unknown(&symbols.value[i]);
  bool expanded = !scallop_formula_expand(&value, f, &symbols, m->condition->kind, &ring, why);
  if (f->quantity == SCALLOP_VELOCITY_CHANGE) /* the series is that of the velocity */
    series_add(&value, &value, &symbols.value[SCALLOP_SYMBOL_v0], &ring);
  series_sub(difference, series_of(e, m, f->quantity), &value, &ring);
  scallop_symbols_clear(&symbols);
  return expanded;
}

/* The first power whose coefficient is not known to be exactly 0; known of the series if there is none. */
static slong first_power(const struct series *s)
{
  slong k = s->first, end = s->first + series_terms(s);
  while (k < end && series_coefficient_is_zero(s, k))
    k++;
  return k < end ? k : s->known;
}

static bool holds_zero(const struct series *s, slong power)
{
  SCOPED(arb, x);
  series_coefficient(x, s, power, PRECISION);
  return arb_contains_zero(x);
}

/* One coefficient that is a ball makes balls of all. What vanishes among fewer terms, without that one, is 0. */
static void set_zeros(struct series *difference, const struct trial *m, const struct scallop_formula *f, slong most)
{
  char why[FORMULA_MESSAGE];
  SCOPED(series, fewer);
  for (slong terms = 1; terms < most; terms++) {
    if (!left_out(&fewer, m, f, terms, why) || first_power(&fewer) < fewer.known)
      return;
    for (slong k = difference->first, end = k + series_terms(difference); k < end && k < fewer.known; k++)
      series_set_zero(difference, k);
  }
}

static bool look_for_order(struct proof *proof, const struct trial *m, const struct scallop_formula *f)
{
  struct series *difference = &proof->left_out;
  const slong terms = m->expanded->terms + 8;
  if (!left_out(difference, m, f, terms, proof->why))
    return false;
  if (difference->kind == SERIES_BALLS)
    set_zeros(difference, m, f, terms);
  proof->order = first_power(difference);
  proof->known = difference->known;
  proof->found = proof->order < proof->known && !holds_zero(difference, proof->order);
  proof->undecided = proof->order < proof->known && !proof->found;
  return true;
}

/* Is there an equality among the conditions, other than F1 = F2? In names it would not hold. */
static bool has_equality(const struct scallop_formula *f)
{
  bool has = false;
  for (const char *const *when = f->when; when && *when; when++)
    has = has || (strchr(*when, '=') && !scallop_condition_is_equal_forces(*when));
  return has;
}

static bool is_of_paper(const struct scallop_formula *f)
{
  const struct scallop_formula *own = scallop_formula_named(f->name);
  return own && own->text && strcmp(own->text, f->text) == 0 && (!f->parts || !f->parts->name);
}

/* The same in names. Where nothing was found, up to the order that is claimed, and some powers more. An equality of
 * finite sums is proven so, and one of the paper's formulas for the quadratic gait, whose degree in T is low
 * (docs/theory.md, The ledger's proofs). */
static void prove_for_all(struct proof *proof, const struct trial *m, const struct scallop_formula *f)
{
  const bool equality = f->remainder == SCALLOP_EQUALITY;
  const bool low_degree = is_of_paper(f) && m->crawler.gait == &scallop_gait_quadratic;
  const slong looked = f->remainder > MOST_OF_EQUALITY ? f->remainder : MOST_OF_EQUALITY;
  const slong most = proof->found ? proof->order : looked < proof->known ? looked : proof->known - 1;
  struct left_out l;
  char why[FORMULA_MESSAGE];
  SCOPED(fmpq, coefficient);
  left_out_init(&l);
  if (f->text && !has_equality(f) && most < SYMBOLIC_ORDERS
      && !symbolic_left_out(&l, f, &m->crawler, m->condition->kind, m->v0, most, why)) {
    proof->general = l.order <= most ? l.order : proof->order;
    proof->for_all = proof->found ? l.order == proof->order
                                  : l.order > most && (!equality || proof->known >= SERIES_ALL || low_degree);
    proof->contradicts = proof->found
                         && (l.order > most
                             || (proof->for_all && l.is_number
                                 && (!series_rational_coefficient(coefficient, &proof->left_out, proof->order)
                                     || !fmpq_equal(coefficient, l.coefficient))));
    proof->for_all_below = l.order > most ? most + 1 : l.order;
    if (proof->for_all) {
      proof->term = l.term;
      l.term = NULL;
    }
  }
  left_out_clear(&l);
}

bool trial_prove(struct proof *proof, const struct trial *m, const struct scallop_formula *f)
{
  if (!trial_series(m, f->quantity)) {
    snprintf(proof->why, sizeof proof->why, "no body turns in this phase, so that %s does not exist",
             scallop_quantity_words[f->quantity]);
    return false;
  }
  bool expanded = look_for_order(proof, m, f);
  bool rational = scallop_gait_is_rational(m->crawler.gait); /* of others the zeros are shown so far and no further */
  if (expanded && !proof->found && !proof->undecided && rational
      && m->expanded->terms < MANY_TERMS) /* perhaps further on */
    expanded = expand(m->expanded, m, MANY_TERMS, NULL) && look_for_order(proof, m, f);
  proof->general = proof->order;
  if (expanded && !proof->undecided)
    prove_for_all(proof, m, f);
  return expanded;
}
