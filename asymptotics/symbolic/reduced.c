/* Values in independent symbols, and back in the paper's. */
#include "asymptotics/symbolic/reduced.h"

#include <flint/fmpq_mpoly.h>

void replacements_init(struct replacement replaced[MOST_SYMBOLS])
{
  for (int i = 0; i < MOST_SYMBOLS; i++) {
    replaced[i].by = -1;
    replaced[i].pi_power = 0;
    fmpq_init(replaced[i].times);
    fmpq_one(replaced[i].times);
  }
}

void replacements_clear(struct replacement replaced[MOST_SYMBOLS])
{
  for (int i = 0; i < MOST_SYMBOLS; i++)
    fmpq_clear(replaced[i].times);
}

static int place_of(const struct symbols *s, enum symbol_meaning meaning)
{
  return symbols_place(s, meaning, 0, SCALLOP_EXTENSION);
}

/* What becomes of the values: replacements, and whether M and beta stay symbols */
struct change {
  const struct replacement *replaced;
  bool keeps;
};

/* What stands for the symbol at a place */
static void set_image(fmpq_mpoly_t image, const struct symbols *s, int place, const struct change *change,
                      const fmpq_mpoly_ctx_t ring)
{
  const struct replacement *replaced = &change->replaced[place];
  const enum symbol_meaning meaning = s->list[place].meaning;
  fmpq_mpoly_t other;
  fmpq_mpoly_init(other, ring);
  if (meaning == NAMED_M && !change->keeps) {
    fmpq_mpoly_gen(image, place_of(s, NAMED_m1), ring);
    fmpq_mpoly_gen(other, place_of(s, NAMED_m2), ring);
    fmpq_mpoly_add(image, image, other, ring);
  } else if (meaning == NAMED_beta && !change->keeps) {
    fmpq_mpoly_one(image, ring);
    fmpq_mpoly_gen(other, place_of(s, NAMED_alpha), ring);
    fmpq_mpoly_sub(image, image, other, ring);
  } else {
    fmpq_mpoly_gen(image, replaced->by >= 0 ? replaced->by : place, ring);
    fmpq_mpoly_scalar_mul_fmpq(image, image, replaced->times, ring);
    if (replaced->pi_power > 0) {
      fmpq_mpoly_gen(other, place_of(s, NAMED_pi), ring);
      fmpq_mpoly_pow_ui(other, other, (ulong)replaced->pi_power, ring);
      fmpq_mpoly_mul(image, image, other, ring);
    }
  }
  fmpq_mpoly_clear(other, ring);
}

static void compose(fmpq_mpoly_t value, const fmpz_mpoly_t polynomial, const struct symbols *s,
                    const struct change *change, const fmpq_mpoly_ctx_t ring)
{
  fmpq_mpoly_struct images[MOST_SYMBOLS], *list[MOST_SYMBOLS];
  fmpq_mpoly_t from;
  fmpq_mpoly_init(from, ring);
  fmpz_mpoly_set(from->zpoly, polynomial, ring->zctx);
  fmpq_one(from->content);
  fmpq_mpoly_reduce(from, ring);
  for (int i = 0; i < s->count; i++) {
    fmpq_mpoly_init(&images[i], ring);
    set_image(&images[i], s, i, change, ring);
    list[i] = &images[i];
  }
  fmpq_mpoly_compose_fmpq_mpoly(value, from, list, ring, ring);
  for (int i = 0; i < s->count; i++)
    fmpq_mpoly_clear(&images[i], ring);
  fmpq_mpoly_clear(from, ring);
}

/* Takes m1 + m2 out as often as it divides the polynomial. Returns how often. */
static slong take_out_M(fmpz_mpoly_t polynomial, const struct symbols *s)
{
  fmpz_mpoly_t M, m2, rest;
  slong times = 0;
  fmpz_mpoly_init(M, s->names.ring);
  fmpz_mpoly_init(m2, s->names.ring);
  fmpz_mpoly_init(rest, s->names.ring);
  fmpz_mpoly_gen(M, place_of(s, NAMED_m1), s->names.ring);
  fmpz_mpoly_gen(m2, place_of(s, NAMED_m2), s->names.ring);
  fmpz_mpoly_add(M, M, m2, s->names.ring);
  for (; !fmpz_mpoly_is_zero(polynomial, s->names.ring) && fmpz_mpoly_divides(rest, polynomial, M, s->names.ring);
       times++)
    fmpz_mpoly_swap(polynomial, rest, s->names.ring);
  fmpz_mpoly_clear(M, s->names.ring);
  fmpz_mpoly_clear(m2, s->names.ring);
  fmpz_mpoly_clear(rest, s->names.ring);
  return times;
}

/* The sum of c_k alpha^k, of degree d, becomes that of c_k alpha^k (alpha + beta)^(d - k). */
static void make_homogeneous(fmpz_mpoly_t polynomial, const struct symbols *s)
{
  const slong place = place_of(s, NAMED_alpha);
  const int beta = place_of(s, NAMED_beta);
  fmpz_mpoly_t alpha, both, term, power, sum;
  if (beta < 0)
    return;
  fmpz_mpoly_init(alpha, s->names.ring);
  fmpz_mpoly_init(both, s->names.ring);
  fmpz_mpoly_init(term, s->names.ring);
  fmpz_mpoly_init(power, s->names.ring);
  fmpz_mpoly_init(sum, s->names.ring);
  fmpz_mpoly_gen(alpha, place, s->names.ring);
  fmpz_mpoly_gen(both, beta, s->names.ring);
  fmpz_mpoly_add(both, both, alpha, s->names.ring);
  fmpz_mpoly_one(power, s->names.ring);
  for (ulong k = 0; (slong)k <= fmpz_mpoly_degree_si(polynomial, place, s->names.ring); k++) {
    fmpz_mpoly_get_coeff_vars_ui(term, polynomial, &place, &k, 1, s->names.ring);
    fmpz_mpoly_mul(term, term, power, s->names.ring);
    fmpz_mpoly_mul(sum, sum, both, s->names.ring);
    fmpz_mpoly_add(sum, sum, term, s->names.ring);
    fmpz_mpoly_mul(power, power, alpha, s->names.ring);
  }
  fmpz_mpoly_swap(polynomial, sum, s->names.ring);
  fmpz_mpoly_clear(alpha, s->names.ring);
  fmpz_mpoly_clear(both, s->names.ring);
  fmpz_mpoly_clear(term, s->names.ring);
  fmpz_mpoly_clear(power, s->names.ring);
  fmpz_mpoly_clear(sum, s->names.ring);
}

static symbolic changed_polynomial(struct symbols *s, const fmpz_mpoly_t polynomial, const struct change *change)
{
  fmpq_mpoly_ctx_t ring;
  fmpq_mpoly_t value;
  fmpq_mpoly_ctx_init(ring, s->count, ORD_LEX);
  fmpq_mpoly_init(value, ring);
  compose(value, polynomial, s, change, ring);
  slong times = change->keeps ? 0 : take_out_M(value->zpoly, s);
  if (!change->keeps)
    make_homogeneous(value->zpoly, s);
  symbolic M = symbolic_named(s, NAMED_M),
           reduced = symbolic_mul(s, symbolic_fraction(s, value->content), symbolic_polynomial(s, value->zpoly));
  for (; times > 0; times--)
    reduced = symbolic_mul(s, reduced, M);
  fmpq_mpoly_clear(value, ring);
  fmpq_mpoly_ctx_clear(ring);
  return reduced;
}

static symbolic changed(struct symbols *s, symbolic a, const struct change *change)
{
  symbolic over = changed_polynomial(s, a->over, change), under = changed_polynomial(s, a->under, change);
  return ratio_is_zero(under) ? NULL : symbolic_div(s, over, under);
}

symbolic symbolic_replaced(struct symbols *s, symbolic a, const struct replacement replaced[MOST_SYMBOLS])
{
  return changed(s, a, &(struct change){ replaced, true });
}

symbolic symbolic_reduced(struct symbols *s, symbolic a, const struct replacement replaced[MOST_SYMBOLS])
{
  return changed(s, a, &(struct change){ replaced, false });
}
