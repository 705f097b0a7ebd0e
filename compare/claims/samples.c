#include "compare/claims/samples.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/derived.h"

enum { TERMS = 14, MANY_TERMS = 48, PRECISION = 1400, IDENTITY_TRIES = 400 };

static void motion_clear(struct ledger_motion *m)
{
  if (!m)
    return;
  scallop_rational_clear(&m->crawler);
  fmpq_clear(m->v0);
  fmpq_clear(m->pi_squared);
  scallop_phase_expansion_clear(&m->phase);
  scallop_steady_expansion_clear(&m->steady);
  free(m);
}

static enum scallop_status expand(struct ledger_motion *m, const struct ledger_case *c, slong terms)
{
  m->terms = terms;
  return c->setting == SCALLOP_STEADY ? scallop_expand_steady(&m->crawler, terms, PRECISION, &m->steady, NULL)
                                      : scallop_expand_phase(&m->crawler, c->kind, m->v0, terms, PRECISION,
                                                             m->has_pi_squared ? m->pi_squared : NULL, &m->phase, NULL);
}

static struct ledger_motion *motion_of(const struct scallop_rational_crawler *crawler, const fmpq_t v0)
{
  struct ledger_motion *m = malloc(sizeof *m);
  if (!m)
    return NULL;
  scallop_rational_init(&m->crawler);
  scallop_rational_copy(&m->crawler, crawler);
  fmpq_init(m->v0);
  fmpq_set(m->v0, v0);
  fmpq_init(m->pi_squared);
  m->has_pi_squared = false;
  scallop_phase_expansion_init(&m->phase);
  scallop_steady_expansion_init(&m->steady);
  return m;
}

static const char *modes_of(const struct ledger_motion *m, const struct ledger_case *c)
{
  return c->setting == SCALLOP_STEADY ? m->steady.modes : m->phase.modes;
}

const char *ledger_case_modes(const struct ledger_case *c) { return modes_of(c->motion, c); }

/* ---- random crawlers, for identities ---- */

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

/* Another crawler that the condition allows, and with the sinusoidal gait another number in place of pi^2. */
static void randomise(struct ledger_motion *m, const struct ledger_case *c, uint64_t *state)
{
  struct scallop_rational_crawler *r = &m->crawler;
  int sign = fmpq_sgn(c->v0);
  random_rational(r->m1, state);
  random_rational(r->m2, state);
  random_rational(r->F1, state);
  random_rational(r->F2, state);
  random_rational(r->L, state);
  fmpq_set_si(m->crawler.alpha, (slong)(1 + random_bits(state) % 996), 997);
  if (c->condition->light_1)
    fmpq_div_2exp(m->crawler.m1, m->crawler.m1, 7);
  if (c->condition->equal_forces)
    make_forces_equal(&m->crawler);
  if (sign != 0) {
    random_rational(m->v0, state);
    fmpq_mul_si(m->v0, m->v0, sign);
  }
  random_rational(m->pi_squared, state);
  m->has_pi_squared = !scallop_gait_is_rational(m->crawler.gait) && c->setting != SCALLOP_STEADY;
}

static int order_of_forces(const struct scallop_rational_crawler *c)
{
  int order = fmpq_cmp(c->F1, c->F2);
  return (order > 0) - (order < 0);
}

/* The same ordering of forces and side of 1/2 */
static bool condition_allows(const struct ledger_motion *m, const struct ledger_case *c)
{
  fmpq_t twice, here;
  fmpq_init(twice);
  fmpq_init(here);
  fmpq_add(twice, m->crawler.alpha, m->crawler.alpha);
  fmpq_add(here, c->crawler.alpha, c->crawler.alpha);
  bool allowed = order_of_forces(&m->crawler) == order_of_forces(&c->crawler)
                 && (fmpq_cmp_si(twice, 1) > 0) == (fmpq_cmp_si(here, 1) > 0);
  fmpq_clear(twice);
  fmpq_clear(here);
  return allowed;
}

static struct ledger_motion *random_motion(const struct ledger_case *c, uint64_t *state)
{
  struct ledger_motion *m = motion_of(&c->crawler, c->v0);
  for (int i = 0; m && i < IDENTITY_TRIES; i++) {
    randomise(m, c, state);
    if (condition_allows(m, c) && expand(m, c, TERMS) == SCALLOP_OK && strcmp(modes_of(m, c), modes_of(c->motion, c)) == 0)
      return m;
  }
  motion_clear(m);
  return NULL;
}

/* ---- cases ---- */

/* The expansion with whole numbers in the place of pi^2 */
static void put_numbers(struct ledger_case *c)
{
  for (int i = 0; i < LEDGER_NUMBERS; i++) {
    struct ledger_motion *m = motion_of(&c->crawler, c->v0);
    c->numbers[i] = m;
    if (!m)
      return;
    m->has_pi_squared = true;
    fmpq_set_si(m->pi_squared, i + 1, 1);
    if (expand(m, c, TERMS) != SCALLOP_OK) {
      motion_clear(m);
      c->numbers[i] = NULL;
    }
  }
}

/* x to two significant digits: fractions stay readable, and nothing depends on a library's square root. */
static void rounded(fmpq_t x, double value)
{
  char text[32];
  snprintf(text, sizeof text, "%.1e", value);
  scallop_rational_parse(x, text);
}

static void exchange_bodies(struct scallop_rational_crawler *c)
{
  fmpq_swap(c->m1, c->m2);
  fmpq_swap(c->F1, c->F2);
}

/* The ledger's crawler under the condition; returns the duration at which its Froude number is 1, about. */
static double set_condition(struct ledger_case *c, const struct condition *condition)
{
  struct scallop_rational_crawler *r = &c->crawler;
  if (condition->exchange_forces)
    fmpq_swap(r->F1, r->F2);
  if (condition->equal_forces)
    make_forces_equal(r);
  if (condition->light_1)
    fmpq_div_fmpz(r->m1, r->m1, (fmpz[]){ 100 });
  if (condition->mirror_alpha)
    scallop_rational_fraction(r->alpha, r, SCALLOP_CONTRACTION);
  double M = fmpq_get_d(r->m1) + fmpq_get_d(r->m2), F = fmpq_get_d(r->F1) + fmpq_get_d(r->F2), L = fmpq_get_d(r->L);
  fmpq_zero(c->v0);
  if (condition->v0 != 0)
    rounded(c->v0, condition->v0 * sqrt(L * F / M));
  if (c->mirrored) {
    exchange_bodies(r);
    fmpq_neg(c->v0, c->v0);
  }
  return sqrt(M * L / F);
}

/* The expansion is one in T^2 over the smaller mass and the difference of the forces: where these are far apart, T is smaller. */
static double decades_apart(const struct scallop_rational_crawler *c)
{
  double m1 = fmpq_get_d(c->m1), m2 = fmpq_get_d(c->m2), F1 = fmpq_get_d(c->F1), F2 = fmpq_get_d(c->F2);
  double force = F1 == F2 ? F1 : fmin(fmin(F1, F2), fabs(F1 - F2)); /* equal forces cancel */
  double apart = fmin(m1, m2) / (m1 + m2) * force / (F1 + F2);
  return apart < 0.001 ? ceil(-log10(apart)) : 0;
}

enum scallop_status ledger_case_init(struct ledger_case *c, const struct scallop_rational_crawler *crawler,
                                     enum scallop_setting setting, enum scallop_phase_kind kind,
                                     const struct condition *condition, bool mirrored)
{
  uint64_t state = 20260101;
  fmpq_t T0;
  *c = (struct ledger_case){ .setting = setting, .kind = kind, .condition = condition, .mirrored = mirrored };
  scallop_rational_init(&c->crawler);
  scallop_rational_copy(&c->crawler, crawler);
  fmpq_init(c->v0);
  fmpq_init(T0);
  double natural = set_condition(c, condition), decades = decades_apart(&c->crawler);
  rounded(T0, natural * pow(10, -decades));
  c->motion = motion_of(&c->crawler, c->v0);
  enum scallop_status status = c->motion ? expand(c->motion, c, TERMS) : SCALLOP_ERANGE;
  bool has_identities = setting != SCALLOP_STEADY || scallop_gait_is_rational(crawler->gait);
  for (int i = 0; status == SCALLOP_OK && has_identities && i < LEDGER_IDENTITIES; i++)
    c->others[i] = random_motion(c, &state);
  if (setting != SCALLOP_STEADY && !scallop_gait_is_rational(crawler->gait))
    put_numbers(c);
  if (status == SCALLOP_OK)
    c->samples = ledger_take_samples(c, T0, decades);
  fmpq_clear(T0);
  return status;
}

void ledger_case_clear(struct ledger_case *c)
{
  motion_clear(c->motion);
  for (int i = 0; i < LEDGER_IDENTITIES; i++)
    motion_clear(c->others[i]);
  for (int i = 0; i < LEDGER_NUMBERS; i++)
    motion_clear(c->numbers[i]);
  ledger_free_samples(c->samples);
  scallop_rational_clear(&c->crawler);
  fmpq_clear(c->v0);
}

/* ---- proofs ---- */

void ledger_proof_init(struct ledger_proof *p)
{
  *p = (struct ledger_proof){ .found = false };
  series_init(&p->coefficient);
}

void ledger_proof_clear(struct ledger_proof *p) { series_clear(&p->coefficient); }

const struct series *ledger_expansion(const struct ledger_motion *m, const struct ledger_case *c,
                                      enum scallop_quantity quantity)
{
  return c->setting == SCALLOP_STEADY ? scallop_steady_quantity(&m->steady, quantity)
                                      : scallop_phase_quantity(&m->phase, c->kind, quantity);
}

/* derived - formula */
static bool left_out(struct series *difference, const struct ledger_motion *m, const struct ledger_case *c,
                     const struct scallop_formula *formula, enum scallop_quantity quantity, bool limit)
{
  const struct ring ring = { m->terms + 8, PRECISION };
  const struct series *derived = ledger_expansion(m, c, quantity);
  struct scallop_symbols symbols;
  struct series value;
  bool expanded = true;
  scallop_symbols_init(&symbols);
  series_init(&value);
  series_set(difference, derived);
  if (formula) {
    scallop_symbols_set(&symbols, &m->crawler, c->kind, m->v0, m->has_pi_squared ? m->pi_squared : NULL, &ring);
    series_set(&symbols.value[SYMBOL_t1], &m->phase.t1);
    series_set(&symbols.value[SYMBOL_dT], &m->phase.dT);
    series_set(&symbols.value[SYMBOL_x_switch], &m->phase.at_last);
    expanded = scallop_formula_expand(&value, formula, &symbols, c->kind, &ring);
    if (quantity == SCALLOP_VELOCITY_CHANGE)
      series_add(&value, &value, &symbols.value[SYMBOL_v0], &ring);
    series_sub(difference, derived, &value, &ring);
  } else if (limit)
    series_set_zero(difference, quantity == SCALLOP_STEADY_VELOCITY ? -1 : 0);
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
static bool vanishes(const struct ledger_case *c, const struct scallop_formula *formula, enum scallop_quantity quantity,
                     slong power)
{
  slong tests = scallop_zero_tests(power);
  bool zero = c->setting != SCALLOP_STEADY && power < TERMS && tests <= LEDGER_NUMBERS;
  struct series difference;
  series_init(&difference);
  for (slong i = 0; zero && i < tests; i++)
    zero = c->numbers[i] && left_out(&difference, c->numbers[i], c, formula, quantity, false) && power < difference.known
           && series_coefficient_is_zero(&difference, power);
  series_clear(&difference);
  return zero;
}

/* The order of what is left out for a random crawler */
static slong order_of(const struct ledger_motion *m, const struct ledger_case *c, const struct scallop_formula *formula,
                      enum scallop_quantity quantity, bool limit)
{
  struct series difference;
  series_init(&difference);
  slong order = left_out(&difference, m, c, formula, quantity, limit) ? first_power(&difference) : -4;
  series_clear(&difference);
  return order;
}

static void look_for_order(struct ledger_proof *proof, struct series *difference, const struct ledger_case *c,
                           const struct scallop_formula *formula, enum scallop_quantity quantity)
{
  proof->order = first_power(difference);
  while (proof->order < difference->known && holds_zero(difference, proof->order)) {
    if (!vanishes(c, formula, quantity, proof->order)) {
      proof->undecided = true;
      return;
    }
    series_set_zero(difference, proof->order);
    proof->order = first_power(difference);
  }
  proof->found = proof->order < difference->known;
  proof->known = difference->known;
}

bool ledger_prove(struct ledger_proof *proof, const struct ledger_case *c, const struct scallop_formula *formula,
                  enum scallop_quantity quantity, bool limit)
{
  struct series difference;
  arb_t x;
  fmpq_t q;
  series_init(&difference);
  arb_init(x);
  fmpq_init(q);
  bool expanded = left_out(&difference, c->motion, c, formula, quantity, limit);
  if (expanded)
    look_for_order(proof, &difference, c, formula, quantity);
  bool rational = scallop_gait_is_rational(c->crawler.gait); /* of others the zeros are shown so far and no further */
  if (expanded && !proof->found && !proof->undecided && rational && c->motion->terms < MANY_TERMS) { /* perhaps further on */
    expanded = expand(c->motion, c, MANY_TERMS) == SCALLOP_OK
               && left_out(&difference, c->motion, c, formula, quantity, limit);
    if (expanded)
      look_for_order(proof, &difference, c, formula, quantity);
  }
  if (expanded && proof->found) {
    if (series_rational_coefficient(q, &difference, proof->order))
      series_set_rational(&proof->coefficient, q);
    else {
      series_coefficient(x, &difference, proof->order, PRECISION);
      series_set_ball(&proof->coefficient, x);
    }
  }
  proof->general = proof->order;
  for (int i = 0; expanded && i < LEDGER_IDENTITIES; i++)
    if (c->others[i]) {
      slong order = order_of(c->others[i], c, formula, quantity, limit);
      proof->general = order < proof->general ? order : proof->general;
      proof->confirmed++;
    }
  series_clear(&difference);
  arb_clear(x);
  fmpq_clear(q);
  return expanded;
}
