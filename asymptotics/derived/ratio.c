/* Rational functions as quotients of polynomials in lowest terms; FLINT 3 has them as fmpz_mpoly_q. */
#include "asymptotics/derived/ratio.h"

#include <threads.h>

void names_init(struct names *names, slong count)
{
  fmpz_mpoly_ctx_init(names->ring, count, ORD_LEX);
  names->pi = -1;
  names->only_pi = false;
  names->terms = names->most_terms = 0;
}

void names_clear(struct names *names) { fmpz_mpoly_ctx_clear(names->ring); }

bool names_given_up(const struct names *names) { return names->most_terms > 0 && names->terms > names->most_terms; }

static struct names of_pi;

static void begin_of_pi(void)
{
  names_init(&of_pi, 1);
  of_pi.pi = 0;
  of_pi.only_pi = true;
}

struct names *names_of_pi(void)
{
  static once_flag begun = ONCE_FLAG_INIT;
  call_once(&begun, begin_of_pi);
  return &of_pi;
}

fmpz_mpoly_struct *polynomial_begin(struct polynomial *p, const struct names *names)
{
  p->ring = names->ring;
  fmpz_mpoly_init(p->terms, p->ring);
  return p->terms;
}

void polynomial_end(struct polynomial *p) { fmpz_mpoly_clear(p->terms, p->ring); }

void ratio_init(struct ratio *r, struct names *names)
{
  r->names = names;
  fmpz_mpoly_init(r->over, names->ring);
  fmpz_mpoly_init(r->under, names->ring);
  fmpz_mpoly_one(r->under, names->ring);
}

void ratio_clear(struct ratio *r)
{
  fmpz_mpoly_clear(r->over, r->names->ring);
  fmpz_mpoly_clear(r->under, r->names->ring);
}

void ratio_set(struct ratio *to, const struct ratio *a)
{
  fmpz_mpoly_set(to->over, a->over, a->names->ring);
  fmpz_mpoly_set(to->under, a->under, a->names->ring);
}

void ratio_set_fmpq(struct ratio *to, const fmpq_t value)
{
  fmpz_mpoly_set_fmpz(to->over, fmpq_numref(value), to->names->ring);
  fmpz_mpoly_set_fmpz(to->under, fmpq_denref(value), to->names->ring);
}

void ratio_zero(struct ratio *to)
{
  fmpz_mpoly_zero(to->over, to->names->ring);
  fmpz_mpoly_one(to->under, to->names->ring);
}

bool ratio_is_zero(const struct ratio *r) { return fmpz_mpoly_is_zero(r->over, r->names->ring); }

bool ratio_get_fmpq(fmpq_t value, const struct ratio *r)
{
  const fmpz_mpoly_ctx_struct *ring = r->names->ring;
  const bool constant = fmpz_mpoly_is_fmpz(r->over, ring) && fmpz_mpoly_is_fmpz(r->under, ring);
  if (constant) {
    fmpz_mpoly_get_fmpz(fmpq_numref(value), r->over, ring);
    fmpz_mpoly_get_fmpz(fmpq_denref(value), r->under, ring);
  }
  return constant;
}

/* Neither over nor under vanishes at pi: more bits separate them from 0. */
void ratio_get_ball(arb_t value, const struct ratio *r, slong precision)
{
  enum { SPARE = 16 };
  SCOPED(fmpz_poly, over, under);
  SCOPED(arb, pi, divisor);
  arb_zero(value);
  if (ratio_is_zero(r))
    return;
  fmpz_mpoly_get_fmpz_poly(over, r->over, 0, r->names->ring);
  fmpz_mpoly_get_fmpz_poly(under, r->under, 0, r->names->ring);
  slong bits = precision + SPARE;
  do {
    arb_const_pi(pi, bits);
    arb_fmpz_poly_evaluate_arb(value, over, pi, bits);
    arb_fmpz_poly_evaluate_arb(divisor, under, pi, bits);
    arb_div(value, value, divisor, bits);
    bits *= 2;
  } while (arb_rel_accuracy_bits(value) <= precision);
  arb_set_round(value, value, precision);
}

void ratio_neg(struct ratio *to, const struct ratio *a)
{
  ratio_set(to, a);
  fmpz_mpoly_neg(to->over, to->over, to->names->ring);
}

/* Divides a and b by their greatest common divisor. If exponents overflow, FLINT finds none; the value is the same. */
static void cancel(fmpz_mpoly_t a, fmpz_mpoly_t b, const struct names *names)
{
  SCOPED_POLYNOMIAL(common, names);
  if (fmpz_mpoly_gcd(common, a, b, names->ring) && !fmpz_mpoly_is_one(common, names->ring)) {
    fmpz_mpoly_divides(a, a, common, names->ring);
    fmpz_mpoly_divides(b, b, common, names->ring);
  }
}

/* Returns true if work has stopped; the result is then 1. */
static bool has_stopped(struct ratio *to)
{
  const bool given_up = names_given_up(to->names);
  if (given_up) {
    fmpz_mpoly_one(to->over, to->names->ring);
    fmpz_mpoly_one(to->under, to->names->ring);
  }
  return given_up;
}

static void count_terms(const struct ratio *made)
{
  struct names *names = made->names;
  if (names->most_terms > 0)
    names->terms += fmpz_mpoly_length(made->over, names->ring) + fmpz_mpoly_length(made->under, names->ring);
}

typedef void combine_polynomials(fmpz_mpoly_t, const fmpz_mpoly_t, const fmpz_mpoly_t, const fmpz_mpoly_ctx_t);

/* Computes a + b or a - b: with under_a = g p and under_b = g q, (over_a q +- over_b p)/(g p q); only g can cancel. */
static void sum(struct ratio *to, const struct ratio *a, const struct ratio *b, combine_polynomials *combine)
{
  const fmpz_mpoly_ctx_struct *ring = to->names->ring;
  SCOPED_POLYNOMIAL(g, to->names);
  SCOPED_POLYNOMIAL(p, to->names);
  SCOPED_POLYNOMIAL(q, to->names);
  SCOPED_POLYNOMIAL(term, to->names);
  if (has_stopped(to))
    return;
  if (!fmpz_mpoly_gcd(g, a->under, b->under, ring))
    fmpz_mpoly_one(g, ring); /* GCOVR_EXCL_LINE: only if exponents overflow */
  fmpz_mpoly_divides(p, a->under, g, ring);
  fmpz_mpoly_divides(q, b->under, g, ring);
  fmpz_mpoly_mul(term, b->over, p, ring);
  fmpz_mpoly_mul(to->over, a->over, q, ring);
  combine(to->over, to->over, term, ring);
  cancel(to->over, g, to->names);
  fmpz_mpoly_mul(to->under, p, q, ring);
  fmpz_mpoly_mul(to->under, to->under, g, ring);
  count_terms(to);
}

void ratio_add(struct ratio *to, const struct ratio *a, const struct ratio *b) { sum(to, a, b, fmpz_mpoly_add); }
void ratio_sub(struct ratio *to, const struct ratio *a, const struct ratio *b) { sum(to, a, b, fmpz_mpoly_sub); }

/* Computes to = (a/b) other, or (a/b)/other if inverse. */
static void product(struct ratio *to, const fmpz_mpoly_t a, const fmpz_mpoly_t b, const struct ratio *other,
                    bool inverse)
{
  const fmpz_mpoly_ctx_struct *ring = to->names->ring;
  SCOPED_POLYNOMIAL(over, to->names);
  SCOPED_POLYNOMIAL(under, to->names);
  if (has_stopped(to))
    return;
  fmpz_mpoly_set(over, inverse ? other->under : other->over, ring);
  fmpz_mpoly_set(under, inverse ? other->over : other->under, ring);
  fmpz_mpoly_set(to->over, a, ring);
  fmpz_mpoly_set(to->under, b, ring);
  cancel(to->over, under, to->names);
  cancel(over, to->under, to->names);
  fmpz_mpoly_mul(to->over, to->over, over, ring);
  fmpz_mpoly_mul(to->under, to->under, under, ring);
  if (fmpz_sgn(to->under->coeffs) < 0) {
    fmpz_mpoly_neg(to->over, to->over, ring);
    fmpz_mpoly_neg(to->under, to->under, ring);
  }
  count_terms(to);
}

void ratio_mul(struct ratio *to, const struct ratio *a, const struct ratio *b)
{
  product(to, a->over, a->under, b, false);
}

void ratio_div(struct ratio *to, const struct ratio *a, const struct ratio *b)
{
  product(to, a->over, a->under, b, true);
}

void ratio_mul_fmpq(struct ratio *to, const struct ratio *a, const fmpq_t factor)
{
  ENDED_BY(ratio_clear) struct ratio constant;
  ratio_init(&constant, a->names);
  ratio_set_fmpq(&constant, factor);
  ratio_mul(to, a, &constant);
}
