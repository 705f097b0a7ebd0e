#include "compare/claims/trial.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/published/read.h"
#include "compare/answers/answer.h"
#include "compare/claims/evidence.h"

enum { TERMS = 14, MANY_TERMS = 48, PRECISION = 1400, IDENTITY_TRIES = 400 };

/* One crawler's expansion, with what the formulas need */
struct expanded {
  struct scallop_rational_crawler crawler;
  fmpq_t v0, pi_squared;
  bool has_pi_squared; /* a random number in place of pi^2                                            */
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
  fmpq_clear(e->pi_squared);
  scallop_phase_expansion_clear(&e->phase);
  scallop_steady_expansion_clear(&e->steady);
  free(e);
}

static bool expand(struct expanded *e, const struct trial *m, slong terms)
{
  e->terms = terms;
  return (trial_is_steady(m) ? scallop_expand_steady(&e->crawler, terms, PRECISION, &e->steady, NULL)
                             : scallop_expand_phase(&e->crawler, m->condition->kind, e->v0, terms, PRECISION,
                                                    e->has_pi_squared ? e->pi_squared : NULL, &e->phase, NULL))
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
  fmpq_init(e->pi_squared);
  e->has_pi_squared = false;
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

/* a/b, a and b from 1 to 997: an identity of low degree that holds there by chance is a rare one */
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

/* Sets the parameters that the conditions say to be equal to something; what is no fraction is not set. */
static void set_equalities(const struct condition *condition, struct scallop_rational_crawler *c)
{
  const struct scallop_formula *f = condition->formula;
  const struct ring ring = { 1, PRECISION };
  char message[FORMULA_MESSAGE];
  for (const char *const *when = f ? f->when : NULL; when && *when; when++) {
    struct scallop_formula right = *f;
    struct scallop_symbols symbols;
    struct series value;
    fmpq *parameter = parameter_set(c, *when, &right.text);
    if (!parameter)
      continue;
    scallop_symbols_init(&symbols);
    series_init(&value);
    scallop_symbols_set(&symbols, c, condition->kind, NULL, NULL, &ring);
    if (!scallop_formula_expand(&value, &right, &symbols, condition->kind, &ring, message))
      series_rational_coefficient(parameter, &value, 0);
    scallop_symbols_clear(&symbols);
    series_clear(&value);
  }
}

/* Is the limit of the steady state the one that the formula is for? Not where it has no expansion */
static bool turns_there(const struct scallop_formula *f, const struct scallop_rational_crawler *c)
{
  struct scallop_steady_expansion limit;
  scallop_steady_expansion_init(&limit);
  bool expands = scallop_expand_steady(c, 1, PRECISION, &limit, NULL) == SCALLOP_OK;
  bool there = expands && turns_in_modes(limit.modes) == f->turns;
  scallop_steady_expansion_clear(&limit);
  return there;
}

bool condition_allows(const struct condition *condition, const struct scallop_rational_crawler *c)
{
  const struct scallop_formula *f = condition->formula;
  const struct scallop_crawler rounded = { nearest_double(c->m1),    nearest_double(c->m2),
                                           nearest_double(c->F1),    nearest_double(c->F2),
                                           nearest_double(c->L),     1,
                                           nearest_double(c->alpha), c->gait };
  const struct scallop_values values = f && f->setting == SCALLOP_STEADY
                                           ? scallop_steady_values(&rounded)
                                           : scallop_phase_values(&rounded, condition->kind, condition->v0);
  return !f
         || (scallop_crawler_check(&rounded, NULL) == SCALLOP_OK && scallop_formula_is_claimed(f, &values)
             && (f->turns == SCALLOP_TURNS_IN_BOTH || turns_there(f, c)));
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

/* Another crawler, and with the sinusoidal gait another number in place of pi^2. */
static void randomise(struct expanded *e, const struct trial *m, uint64_t *state)
{
  struct scallop_rational_crawler *r = &e->crawler;
  int sign = fmpq_sgn(m->v0);
  random_crawler(r, state);
  if (m->condition->light_1)
    fmpq_div_2exp(r->m1, r->m1, 7);
  if (m->condition->equal_forces)
    make_forces_equal(r);
  set_equalities(m->condition, r);
  if (sign != 0) {
    random_rational(e->v0, state);
    fmpq_mul_si(e->v0, e->v0, sign);
  }
  random_rational(e->pi_squared, state);
  e->has_pi_squared = !scallop_gait_is_rational(r->gait) && !trial_is_steady(m);
}

static int sign_of(int x) { return (x > 0) - (x < 0); }

/* Does the condition allow the random crawler? The same ordering of forces and side of 1/2 */
static bool is_allowed(const struct scallop_rational_crawler *r, const struct scallop_rational_crawler *c)
{
  fmpq_t half;
  fmpq_init(half);
  fmpq_set_si(half, 1, 2);
  bool allowed = sign_of(fmpq_cmp(r->F1, r->F2)) == sign_of(fmpq_cmp(c->F1, c->F2))
                 && (fmpq_cmp(r->alpha, half) > 0) == (fmpq_cmp(c->alpha, half) > 0);
  fmpq_clear(half);
  return allowed;
}

/* A random crawler with the same modes, or, with a number, that number in the place of pi^2 */
static struct expanded *expand_another(const struct trial *m, uint64_t *state, slong number)
{
  struct expanded *e = expanded_new(m);
  for (int i = 0; e && i < (number ? 1 : IDENTITY_TRIES); i++) {
    if (number) {
      e->has_pi_squared = true;
      fmpq_set_si(e->pi_squared, number, 1);
    } else
      randomise(e, m, state);
    if (is_allowed(&e->crawler, &m->crawler) && condition_allows(m->condition, &e->crawler) && expand(e, m, TERMS)
        && strcmp(modes_of(e, m), trial_modes(m)) == 0)
      return e;
  }
  expanded_free(e);
  return NULL;
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
  uint64_t state = 20260101;
  bool rational = scallop_gait_is_rational(crawler->gait);
  *m = (struct trial){ .condition = condition, .mirrored = mirrored };
  fmpq_init(m->v0);
  scallop_rational_init(&m->crawler);
  scallop_rational_copy(&m->crawler, crawler);
  set_condition(m);
  m->expanded = expanded_new(m);
  bool done = m->expanded && expand(m->expanded, m, TERMS);
  for (int i = 0; done && (rational || !trial_is_steady(m)) && i < TRIAL_IDENTITIES; i++)
    m->others[i] = expand_another(m, &state, 0);
  for (int i = 0; done && !rational && !trial_is_steady(m) && i < TRIAL_NUMBERS; i++)
    m->numbers[i] = expand_another(m, &state, i + 1);
  return done;
}

void trial_clear(struct trial *m)
{
  expanded_free(m->expanded);
  for (int i = 0; i < TRIAL_IDENTITIES; i++)
    expanded_free(m->others[i]);
  for (int i = 0; i < TRIAL_NUMBERS; i++)
    expanded_free(m->numbers[i]);
  scallop_rational_clear(&m->crawler);
  fmpq_clear(m->v0);
}

/* Proofs */

void proof_init(struct proof *p)
{
  *p = (struct proof){ .found = false };
  series_init(&p->left_out);
}

void proof_clear(struct proof *p) { series_clear(&p->left_out); }

slong trial_leading_power(const struct scallop_formula *f) { return f->quantity == SCALLOP_STEADY_VELOCITY ? -1 : 0; }

/* derived - formula */
static bool left_out(struct series *difference, const struct expanded *e, const struct trial *m,
                     const struct scallop_formula *f, char why[FORMULA_MESSAGE])
{
  const struct ring ring = { e->terms + 8, PRECISION };
  struct scallop_symbols symbols;
  struct series value;
  series_set(difference, series_of(e, m, f->quantity));
  if (!f->text) {
    series_set_zero(difference, trial_leading_power(f));
    return true;
  }
  scallop_symbols_init(&symbols);
  series_init(&value);
  scallop_symbols_set(&symbols, &e->crawler, m->condition->kind, e->v0, e->has_pi_squared ? e->pi_squared : NULL, &ring);
  series_set(&symbols.value[SCALLOP_SYMBOL_t1], &e->phase.t1);
  series_set(&symbols.value[SCALLOP_SYMBOL_dT], &e->phase.dT);
  series_set(&symbols.value[SCALLOP_SYMBOL_x_switch], &e->phase.at_last);
  bool expanded = !scallop_formula_expand(&value, f, &symbols, m->condition->kind, &ring, why);
  if (f->quantity == SCALLOP_VELOCITY_CHANGE) /* the series is that of the velocity */
    series_add(&value, &value, &symbols.value[SCALLOP_SYMBOL_v0], &ring);
  series_sub(difference, series_of(e, m, f->quantity), &value, &ring);
  scallop_symbols_clear(&symbols);
  series_clear(&value);
  return expanded;
}

/* The first power whose coefficient is not known to be exactly 0, from T^-4 on; known of the series if there is none. */
static slong first_power(const struct series *s)
{
  slong k = -4;
  while (k < s->known && k <= MANY_TERMS && series_coefficient_is_zero(s, k))
    k++;
  return k > MANY_TERMS ? s->known : k;
}

static bool holds_zero(const struct series *s, slong power)
{
  arb_t x;
  arb_init(x);
  series_coefficient(x, s, power, PRECISION);
  bool zero = arb_contains_zero(x);
  arb_clear(x);
  return zero;
}

/* The coefficient vanishes for this very crawler: it does with so many numbers in the place of pi^2 (scallop_zero_tests). */
static bool vanishes(const struct trial *m, const struct scallop_formula *f, slong power)
{
  slong tests = scallop_zero_tests(power);
  bool zero = !trial_is_steady(m) && power < TERMS && tests <= TRIAL_NUMBERS;
  struct series difference;
  char why[FORMULA_MESSAGE];
  series_init(&difference);
  for (slong i = 0; zero && i < tests; i++)
    zero = m->numbers[i] && left_out(&difference, m->numbers[i], m, f, why) && power < difference.known
           && series_coefficient_is_zero(&difference, power);
  series_clear(&difference);
  return zero;
}

static bool look_for_order(struct proof *proof, const struct trial *m, const struct scallop_formula *f)
{
  struct series *difference = &proof->left_out;
  if (!left_out(difference, m->expanded, m, f, proof->why))
    return false;
  while ((proof->order = first_power(difference)) < difference->known && holds_zero(difference, proof->order)) {
    proof->undecided = !vanishes(m, f, proof->order);
    if (proof->undecided)
      return true;
    series_set_zero(difference, proof->order);
  }
  proof->found = proof->order < difference->known;
  proof->known = difference->known;
  return true;
}

bool trial_prove(struct proof *proof, const struct trial *m, const struct scallop_formula *f)
{
  bool expanded = look_for_order(proof, m, f);
  bool rational = scallop_gait_is_rational(m->crawler.gait); /* of others the zeros are shown so far and no further */
  if (expanded && !proof->found && !proof->undecided && rational && m->expanded->terms < MANY_TERMS) /* perhaps further on */
    expanded = expand(m->expanded, m, MANY_TERMS) && look_for_order(proof, m, f);
  struct series other;
  char why[FORMULA_MESSAGE];
  series_init(&other);
  proof->general = proof->order;
  for (int i = 0; expanded && i < TRIAL_IDENTITIES; i++)
    if (m->others[i]) {
      slong order = left_out(&other, m->others[i], m, f, why) ? first_power(&other) : -4;
      proof->general = order < proof->general ? order : proof->general;
    }
  series_clear(&other);
  return expanded;
}
