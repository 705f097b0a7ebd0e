/* Rational functions of named symbols. */
#include "asymptotics/symbolic/symbolic.h"

#include <stdio.h>
#include <string.h>

#include "asymptotics/derived/scoped.h"

void symbols_init(struct symbols *s)
{
  s->count = 0;
  s->made = NULL;
  s->made_count = s->made_room = 0;
  s->terms = s->most_terms = 0;
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

void symbols_begin(struct symbols *s) { fmpz_mpoly_ctx_init(s->ring, s->count, ORD_LEX); }

void symbols_end(struct symbols *s)
{
  for (size_t i = 0; i < s->made_count; i++) {
    fmpz_mpoly_clear(s->made[i]->over, s->ring);
    fmpz_mpoly_clear(s->made[i]->under, s->ring);
    flint_free(s->made[i]);
  }
  flint_free(s->made);
  fmpz_mpoly_ctx_clear(s->ring);
}

/* sigma L times n! times the coefficient of |l'| in time, sigma = -1 in a contraction */
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

void symbols_values(fmpq *values, const struct symbols *s, const struct scallop_rational_crawler *crawler,
                    const fmpq_t v0, const fmpq_t pi_squared)
{
  for (int i = 0; i < s->count; i++) {
    fmpq *value = values + i;
    switch (s->list[i].meaning) {
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
    case NAMED_pi: fmpq_one(value); break; /* what depends on it has no value here */
    case NAMED_AT_START:
    case NAMED_AT_END: derivative_value(value, &s->list[i], crawler, pi_squared); break;
    }
  }
}

static struct symbolic *new_value(struct symbols *s)
{
  if (s->made_count == s->made_room) {
    s->made_room = 2 * s->made_room + 64;
    s->made = flint_realloc(s->made, s->made_room * sizeof *s->made);
  }
  struct symbolic *value = flint_malloc(sizeof *value);
  s->made[s->made_count++] = value;
  fmpz_mpoly_init(value->over, s->ring);
  fmpz_mpoly_init(value->under, s->ring);
  fmpz_mpoly_one(value->under, s->ring);
  return value;
}

symbolic symbolic_number(struct symbols *s, slong over, ulong under)
{
  struct symbolic *value = new_value(s);
  fmpz_mpoly_set_si(value->over, over, s->ring);
  fmpz_mpoly_set_ui(value->under, under, s->ring);
  return value;
}

symbolic symbolic_fraction(struct symbols *s, const fmpq_t x)
{
  struct symbolic *value = new_value(s);
  fmpz_mpoly_set_fmpz(value->over, fmpq_numref(x), s->ring);
  fmpz_mpoly_set_fmpz(value->under, fmpq_denref(x), s->ring);
  return value;
}

symbolic symbolic_polynomial(struct symbols *s, const fmpz_mpoly_t polynomial)
{
  struct symbolic *value = new_value(s);
  fmpz_mpoly_set(value->over, polynomial, s->ring);
  return value;
}

symbolic symbolic_place(struct symbols *s, int place)
{
  struct symbolic *value = new_value(s);
  fmpz_mpoly_gen(value->over, place, s->ring);
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

symbolic symbolic_coefficient(struct symbols *s, symbolic a, bool under, slong power)
{
  struct symbolic *value = new_value(s);
  const slong place[] = { place_of(s, NAMED_T) };
  const ulong powers[] = { (ulong)power };
  fmpz_mpoly_get_coeff_vars_ui(value->over, under ? a->under : a->over, place, powers, 1, s->ring);
  return value;
}

/* Too many terms were made: what is still asked for is 1, so that the work ends soon. */
static bool is_given_up(const struct symbols *s) { return s->most_terms > 0 && s->terms > s->most_terms; }

static symbolic counted(struct symbols *s, symbolic value)
{
  s->terms += fmpz_mpoly_length(value->over, s->ring) + fmpz_mpoly_length(value->under, s->ring);
  return value;
}

/* Takes the greatest common divisor out of a and b. FLINT finds one unless exponents overflow; without it the value is
 * the same. */
static void cancel(fmpz_mpoly_t a, fmpz_mpoly_t b, const struct symbols *s)
{
  fmpz_mpoly_t common;
  fmpz_mpoly_init(common, s->ring);
  if (fmpz_mpoly_gcd(common, a, b, s->ring) && !fmpz_mpoly_is_one(common, s->ring)) {
    fmpz_mpoly_divides(a, a, common, s->ring);
    fmpz_mpoly_divides(b, b, common, s->ring);
  }
  fmpz_mpoly_clear(common, s->ring);
}

/* a + b or a - b: with under_a = g p and under_b = g q, (over_a q +- over_b p)/(g p q), where only g can have more to
 * cancel */
static symbolic sum(struct symbols *s, symbolic a, symbolic b, bool sub)
{
  if (is_given_up(s))
    return symbolic_number(s, 1, 1);
  struct symbolic *value = new_value(s);
  fmpz_mpoly_t g, p, q, term;
  fmpz_mpoly_init(g, s->ring);
  fmpz_mpoly_init(p, s->ring);
  fmpz_mpoly_init(q, s->ring);
  fmpz_mpoly_init(term, s->ring);
  if (!fmpz_mpoly_gcd(g, a->under, b->under, s->ring))
    fmpz_mpoly_one(g, s->ring); /* GCOVR_EXCL_LINE: only if exponents overflow */
  fmpz_mpoly_divides(p, a->under, g, s->ring);
  fmpz_mpoly_divides(q, b->under, g, s->ring);
  fmpz_mpoly_mul(value->over, a->over, q, s->ring);
  fmpz_mpoly_mul(term, b->over, p, s->ring);
  (sub ? fmpz_mpoly_sub : fmpz_mpoly_add)(value->over, value->over, term, s->ring);
  cancel(value->over, g, s);
  fmpz_mpoly_mul(value->under, p, q, s->ring);
  fmpz_mpoly_mul(value->under, value->under, g, s->ring);
  fmpz_mpoly_clear(g, s->ring);
  fmpz_mpoly_clear(p, s->ring);
  fmpz_mpoly_clear(q, s->ring);
  fmpz_mpoly_clear(term, s->ring);
  return counted(s, value);
}

symbolic symbolic_add(struct symbols *s, symbolic a, symbolic b) { return sum(s, a, b, false); }

symbolic symbolic_sub(struct symbols *s, symbolic a, symbolic b) { return sum(s, a, b, true); }

/* (a/b) (c/d) */
static symbolic product(struct symbols *s, const fmpz_mpoly_t a, const fmpz_mpoly_t b, const fmpz_mpoly_t c,
                        const fmpz_mpoly_t d)
{
  if (is_given_up(s))
    return symbolic_number(s, 1, 1);
  struct symbolic *value = new_value(s);
  fmpz_mpoly_t over, under;
  fmpz_mpoly_init(over, s->ring);
  fmpz_mpoly_init(under, s->ring);
  fmpz_mpoly_set(value->over, a, s->ring);
  fmpz_mpoly_set(value->under, b, s->ring);
  fmpz_mpoly_set(over, c, s->ring);
  fmpz_mpoly_set(under, d, s->ring);
  cancel(value->over, under, s);
  cancel(over, value->under, s);
  fmpz_mpoly_mul(value->over, value->over, over, s->ring);
  fmpz_mpoly_mul(value->under, value->under, under, s->ring);
  if (fmpz_sgn(value->under->coeffs) < 0) {
    fmpz_mpoly_neg(value->over, value->over, s->ring);
    fmpz_mpoly_neg(value->under, value->under, s->ring);
  }
  fmpz_mpoly_clear(over, s->ring);
  fmpz_mpoly_clear(under, s->ring);
  return counted(s, value);
}

symbolic symbolic_mul(struct symbols *s, symbolic a, symbolic b)
{
  return product(s, a->over, a->under, b->over, b->under);
}

symbolic symbolic_div(struct symbols *s, symbolic a, symbolic b)
{
  return product(s, a->over, a->under, b->under, b->over);
}

bool symbolic_is_zero(symbolic a, const struct symbols *s) { return fmpz_mpoly_is_zero(a->over, s->ring); }

/* The sum of a polynomial's terms */
static void value_of(fmpq_t value, const fmpz_mpoly_t polynomial, const struct symbols *s, const fmpq *values)
{
  ulong powers[MOST_SYMBOLS];
  SCOPED(fmpq, term, power);
  SCOPED(fmpz, coefficient);
  fmpq_zero(value);
  for (slong i = 0; i < fmpz_mpoly_length(polynomial, s->ring); i++) {
    fmpz_mpoly_get_term_coeff_fmpz(coefficient, polynomial, i, s->ring);
    fmpz_mpoly_get_term_exp_ui(powers, polynomial, i, s->ring);
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
