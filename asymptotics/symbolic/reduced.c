/* Conversion of values to independent symbols, and back to the paper's symbols */
#include "asymptotics/symbolic/reduced.h"

#include <flint/fmpq_mpoly.h>

void replacements_init(struct replacements *r)
{
  for (int i = 0; i < MOST_SYMBOLS; i++) {
    struct replacement *replaced = &r->of[i];
    replaced->by = -1;
    replaced->pi_power = 0;
    fmpq_init(replaced->times);
    fmpq_one(replaced->times);
  }
}

void replacements_clear(struct replacements *r)
{
  for (int i = 0; i < MOST_SYMBOLS; i++)
    fmpq_clear(r->of[i].times);
}

static int place_of(const struct symbols *s, enum symbol_meaning meaning)
{
  return symbols_place(s, meaning, 0, SCALLOP_EXTENSION);
}

/* Computes the replacement of a symbol: a polynomial with the integer coefficients of `terms`, times `times`. */
static void set_image(fmpz_mpoly_t terms, fmpq_t times, const struct symbols *s, int place,
                      const struct replacement *replaced, bool independent)
{
  const fmpz_mpoly_ctx_struct *ring = s->names.ring;
  const enum symbol_meaning meaning = s->list[place].meaning;
  SCOPED_POLYNOMIAL(other, &s->names);
  fmpq_one(times);
  if (meaning == NAMED_M && independent) {
    fmpz_mpoly_gen(terms, place_of(s, NAMED_m1), ring);
    fmpz_mpoly_gen(other, place_of(s, NAMED_m2), ring);
    fmpz_mpoly_add(terms, terms, other, ring);
  } else if (meaning == NAMED_beta && independent) {
    fmpz_mpoly_one(terms, ring);
    fmpz_mpoly_gen(other, place_of(s, NAMED_alpha), ring);
    fmpz_mpoly_sub(terms, terms, other, ring);
  } else {
    fmpz_mpoly_gen(terms, replaced->by >= 0 ? replaced->by : place, ring);
    fmpq_set(times, replaced->times);
    if (replaced->pi_power > 0) {
      fmpz_mpoly_gen(other, place_of(s, NAMED_pi), ring);
      fmpz_mpoly_pow_ui(other, other, (ulong)replaced->pi_power, ring);
      fmpz_mpoly_mul(terms, terms, other, ring);
    }
  }
}

/* Computes the value of a polynomial with its symbols replaced. */
static void compose(fmpq_mpoly_t value, const fmpz_mpoly_t polynomial, const struct symbols *s,
                    const struct replacements *replacements, bool independent, const fmpq_mpoly_ctx_t ring)
{
  fmpq_mpoly_struct images[MOST_SYMBOLS], *list[MOST_SYMBOLS];
  fmpq_mpoly_t from;
  fmpq_mpoly_init(from, ring);
  for (int i = 0; i < s->count; i++) {
    list[i] = &images[i];
    fmpq_mpoly_init(list[i], ring);
    set_image(list[i]->zpoly, list[i]->content, s, i, &replacements->of[i], independent);
    fmpq_mpoly_reduce(list[i], ring);
  }
  fmpz_mpoly_set(from->zpoly, polynomial, ring->zctx);
  fmpq_one(from->content);
  fmpq_mpoly_reduce(from, ring);
  fmpq_mpoly_compose_fmpq_mpoly(value, from, list, ring, ring);
  fmpq_mpoly_clear(from, ring);
  for (int i = 0; i < s->count; i++)
    fmpq_mpoly_clear(list[i], ring);
}

/* Divides the polynomial by m1 + m2 as often as possible. Returns the count of divisions. */
static slong take_out_M(fmpz_mpoly_t polynomial, const struct symbols *s)
{
  const fmpz_mpoly_ctx_struct *ring = s->names.ring;
  slong times = 0;
  SCOPED_POLYNOMIAL(M, &s->names);
  SCOPED_POLYNOMIAL(rest, &s->names);
  fmpz_mpoly_gen(M, place_of(s, NAMED_m1), ring);
  fmpz_mpoly_gen(rest, place_of(s, NAMED_m2), ring);
  fmpz_mpoly_add(M, M, rest, ring);
  for (; !fmpz_mpoly_is_zero(polynomial, ring) && fmpz_mpoly_divides(rest, polynomial, M, ring); times++)
    fmpz_mpoly_swap(polynomial, rest, ring);
  return times;
}

/* Replaces the sum of c_k alpha^k, of degree d, by the sum of c_k alpha^k (alpha + beta)^(d - k). */
static void make_homogeneous(fmpz_mpoly_t polynomial, const struct symbols *s)
{
  const fmpz_mpoly_ctx_struct *ring = s->names.ring;
  const slong place = place_of(s, NAMED_alpha);
  const int beta = place_of(s, NAMED_beta);
  if (beta < 0)
    return;
  SCOPED_POLYNOMIAL(alpha, &s->names);
  SCOPED_POLYNOMIAL(both, &s->names);
  SCOPED_POLYNOMIAL(term, &s->names);
  SCOPED_POLYNOMIAL(power, &s->names);
  SCOPED_POLYNOMIAL(sum, &s->names);
  fmpz_mpoly_gen(alpha, place, ring);
  fmpz_mpoly_gen(both, beta, ring);
  fmpz_mpoly_add(both, both, alpha, ring);
  fmpz_mpoly_one(power, ring);
  for (ulong k = 0; (slong)k <= fmpz_mpoly_degree_si(polynomial, place, ring); k++) {
    fmpz_mpoly_get_coeff_vars_ui(term, polynomial, &place, &k, 1, ring);
    fmpz_mpoly_mul(term, term, power, ring);
    fmpz_mpoly_mul(sum, sum, both, ring);
    fmpz_mpoly_add(sum, sum, term, ring);
    fmpz_mpoly_mul(power, power, alpha, ring);
  }
  fmpz_mpoly_swap(polynomial, sum, ring);
}

static symbolic replaced_polynomial(struct symbols *s, const fmpz_mpoly_t polynomial,
                                    const struct replacements *replacements, bool independent)
{
  fmpq_mpoly_ctx_t ring;
  fmpq_mpoly_t value;
  fmpq_mpoly_ctx_init(ring, s->count, ORD_LEX);
  fmpq_mpoly_init(value, ring);
  compose(value, polynomial, s, replacements, independent, ring);
  slong times = independent ? take_out_M(value->zpoly, s) : 0;
  if (independent)
    make_homogeneous(value->zpoly, s);
  symbolic M = symbolic_named(s, NAMED_M),
           replaced = symbolic_mul(s, symbolic_fraction(s, value->content), symbolic_polynomial(s, value->zpoly));
  for (; times > 0; times--)
    replaced = symbolic_mul(s, replaced, M);
  fmpq_mpoly_clear(value, ring);
  fmpq_mpoly_ctx_clear(ring);
  return replaced;
}

symbolic symbolic_replaced(struct symbols *s, symbolic a, const struct replacements *replacements, bool independent)
{
  symbolic over = replaced_polynomial(s, a->over, replacements, independent),
           under = replaced_polynomial(s, a->under, replacements, independent);
  return ratio_is_zero(under) ? NULL : symbolic_div(s, over, under);
}
