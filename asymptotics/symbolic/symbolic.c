/* Rational functions of named symbols */
#include "asymptotics/symbolic/symbolic.h"

#include <stdio.h>
#include <string.h>

#include "asymptotics/derived/scoped.h"

void symbols_init(struct symbols *s)
{
  s->count = 0;
  s->made = NULL;
  s->made_count = s->made_allocated = 0;
  s->most_terms = 0;
  names_init(&s->names, 0);
}

static void name_symbol(struct symbol *symbol, bool second)
{
  static const char *const names[] = { "m1", "m2", "M", "F1", "F2", "L", "v0", "alpha", "beta", "T", "pi" };
  int n = symbol->derivative;
  const char *end = symbol->meaning == NAMED_AT_START ? "0" : "T", *phase = second ? "_c" : "";
  if (symbol->meaning < NAMED_AT_START)
    snprintf(symbol->name, SYMBOL_NAME, "%s", names[symbol->meaning]);
  else if (n == 2 || n == 4)
    snprintf(symbol->name, SYMBOL_NAME, "%s%s%s", n == 2 ? "l" : "k", end, phase);
  else
    snprintf(symbol->name, SYMBOL_NAME, "l%d_%s%s", n, end, phase);
}

int symbols_place(const struct symbols *s, enum symbol_meaning meaning, int derivative, enum scallop_phase_kind kind)
{
  for (int i = 0; i < s->count; i++)
    if (s->list[i].meaning == meaning && s->list[i].derivative == derivative
        && (derivative == 0 || s->list[i].kind == kind))
      return i;
  return -1;
}

void symbols_add(struct symbols *s, enum symbol_meaning meaning, int derivative, enum scallop_phase_kind kind)
{
  bool second = false;
  if (symbols_place(s, meaning, derivative, kind) >= 0)
    return;
  for (int i = 0; i < s->count; i++)
    second |= s->list[i].derivative > 0 && s->list[i].kind != kind;
  struct symbol *symbol = &s->list[s->count++];
  *symbol = (struct symbol){ .meaning = meaning, .derivative = derivative, .kind = kind };
  name_symbol(symbol, second);
}

void symbols_begin(struct symbols *s)
{
  names_init(&s->names, s->count);
  s->names.pi = symbols_place(s, NAMED_pi, 0, SCALLOP_EXTENSION);
}

void symbols_end(struct symbols *s)
{
  for (size_t i = 0; i < s->made_count; i++) {
    ratio_clear(s->made[i]);
    flint_free(s->made[i]);
  }
  flint_free(s->made);
  names_clear(&s->names);
}

/* Computes sigma L times n! times the coefficient of |l'| in time, sigma = -1 in a contraction. */
static void derivative_value(fmpq_t value, const struct symbol *symbol, const struct scallop_rational_crawler *crawler,
                             const fmpq_t pi_squared)
{
  const struct scallop_shape *shape = &crawler->gait->phase[symbol->kind];
  const struct scallop_piece *piece = &shape->pieces[symbol->meaning == NAMED_AT_START ? 0 : shape->count - 1];
  SCOPED(fmpq_poly, speed);
  SCOPED(fmpq, zero);
  SCOPED(fmpz, factorial);
  scallop_rational_speed_series(speed, piece, zero, symbol->derivative, pi_squared);
  fmpq_poly_get_coeff_fmpq(value, speed, symbol->derivative - 1);
  fmpz_fac_ui(factorial, (ulong)symbol->derivative - 1);
  fmpq_mul_fmpz(value, value, factorial);
  fmpq_mul(value, value, crawler->L);
  if (symbol->kind == SCALLOP_CONTRACTION)
    fmpq_neg(value, value);
}

void symbol_value(fmpq_t value, const struct symbol *symbol, const struct scallop_rational_crawler *crawler,
                  const fmpq_t v0, const fmpq_t pi_squared)
{
  switch (symbol->meaning) {
  case NAMED_m1: fmpq_set(value, crawler->m1); break;
  case NAMED_m2: fmpq_set(value, crawler->m2); break;
  case NAMED_M: fmpq_add(value, crawler->m1, crawler->m2); break;
  case NAMED_F1: fmpq_set(value, crawler->F1); break;
  case NAMED_F2: fmpq_set(value, crawler->F2); break;
  case NAMED_L: fmpq_set(value, crawler->L); break;
  case NAMED_v0: fmpq_set(value, v0); break;
  case NAMED_alpha: fmpq_set(value, crawler->alpha); break;
  case NAMED_beta: scallop_rational_fraction(value, crawler, SCALLOP_CONTRACTION); break;
  case NAMED_T: fmpq_set(value, crawler->T); break;
  case NAMED_pi: fmpq_one(value); break; /* values that depend on pi do not exist here */
  case NAMED_AT_START:
  case NAMED_AT_END: derivative_value(value, symbol, crawler, pi_squared); break;
  }
}

void symbols_values(fmpq *values, const struct symbols *s, const struct scallop_rational_crawler *crawler,
                    const fmpq_t v0, const fmpq_t pi_squared)
{
  for (int i = 0; i < s->count; i++)
    symbol_value(values + i, &s->list[i], crawler, v0, pi_squared);
}

static struct ratio *new_value(struct symbols *s)
{
  if (s->made_count == s->made_allocated) {
    s->made_allocated = 2 * s->made_allocated + 64;
    s->made = flint_realloc(s->made, s->made_allocated * sizeof *s->made);
  }
  struct ratio *value = flint_malloc(sizeof *value);
  s->made[s->made_count++] = value;
  ratio_init(value, &s->names);
  return value;
}

symbolic symbolic_fraction(struct symbols *s, const fmpq_t x)
{
  struct ratio *value = new_value(s);
  ratio_set_fmpq(value, x);
  return value;
}

symbolic symbolic_number(struct symbols *s, slong over, ulong under)
{
  SCOPED(fmpq, x);
  fmpq_set_si(x, over, under);
  return symbolic_fraction(s, x);
}

symbolic symbolic_polynomial(struct symbols *s, const fmpz_mpoly_t polynomial)
{
  struct ratio *value = new_value(s);
  fmpz_mpoly_set(value->over, polynomial, s->names.ring);
  return value;
}

symbolic symbolic_place(struct symbols *s, int place)
{
  struct ratio *value = new_value(s);
  fmpz_mpoly_gen(value->over, place, s->names.ring);
  return value;
}

static int place_of(const struct symbols *s, enum symbol_meaning meaning)
{
  int place = 0;
  while (s->list[place].meaning != meaning)
    place++;
  return place;
}

symbolic symbolic_named(struct symbols *s, enum symbol_meaning meaning)
{
  return symbolic_place(s, place_of(s, meaning));
}

static symbolic combined(struct symbols *s, symbolic a, symbolic b,
                         void (*combine)(struct ratio *, const struct ratio *, const struct ratio *))
{
  struct ratio *value = new_value(s);
  combine(value, a, b);
  return value;
}

symbolic symbolic_add(struct symbols *s, symbolic a, symbolic b) { return combined(s, a, b, ratio_add); }
symbolic symbolic_sub(struct symbols *s, symbolic a, symbolic b) { return combined(s, a, b, ratio_sub); }
symbolic symbolic_mul(struct symbols *s, symbolic a, symbolic b) { return combined(s, a, b, ratio_mul); }
symbolic symbolic_div(struct symbols *s, symbolic a, symbolic b) { return combined(s, a, b, ratio_div); }

symbolic symbolic_coefficient(struct symbols *s, const struct series *series, slong power)
{
  if (power >= series->known)
    return NULL;
  struct ratio *value = new_value(s);
  series_get_ratio(value, series, power);
  return value;
}

/* Sets a series from the powers of T in a polynomial. */
static void set_by_powers(struct series *series, struct symbols *s, const fmpz_mpoly_t polynomial)
{
  const slong T = place_of(s, NAMED_T), degree = fmpz_mpoly_degree_si(polynomial, T, s->names.ring);
  const struct ring all = { degree + 2, 2 };
  SCOPED(series, term);
  series_set_si(series, 0);
  for (ulong k = 0; (slong)k <= degree; k++) {
    struct ratio *coefficient = new_value(s);
    fmpz_mpoly_get_coeff_vars_ui(coefficient->over, polynomial, &T, &k, 1, s->names.ring);
    series_set_ratio(&term, coefficient);
    series_shift(&term, &term, (slong)k);
    series_add(series, series, &term, &all);
  }
}

void symbolic_in_T(struct series *series, struct symbols *s, symbolic value, slong terms)
{
  const struct ring ring = { terms, 2 };
  SCOPED(series, under);
  set_by_powers(series, s, value->over);
  set_by_powers(&under, s, value->under);
  series_div(series, series, &under, &ring);
}

/* Computes the sum of a polynomial's terms. */
static void value_of(fmpq_t value, const fmpz_mpoly_t polynomial, const struct symbols *s, const fmpq *values)
{
  ulong powers[MOST_SYMBOLS];
  SCOPED(fmpq, term, power);
  SCOPED(fmpz, coefficient);
  fmpq_zero(value);
  for (slong i = 0; i < fmpz_mpoly_length(polynomial, s->names.ring); i++) {
    fmpz_mpoly_get_term_coeff_fmpz(coefficient, polynomial, i, s->names.ring);
    fmpz_mpoly_get_term_exp_ui(powers, polynomial, i, s->names.ring);
    fmpq_set_fmpz(term, coefficient);
    for (int j = 0; j < s->count; j++) {
      if (powers[j] == 0)
        continue;
      fmpq_pow_si(power, values + j, (slong)powers[j]);
      fmpq_mul(term, term, power);
    }
    fmpq_add(value, value, term);
  }
}

bool symbolic_value(fmpq_t value, symbolic a, const struct symbols *s, const fmpq *values)
{
  SCOPED(fmpq, under);
  value_of(under, a->under, s, values);
  bool defined = !fmpq_is_zero(under);
  if (defined) {
    value_of(value, a->over, s, values);
    fmpq_div(value, value, under);
  }
  return defined;
}
