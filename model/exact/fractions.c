#include "model/exact/fractions.h"

#include <stdlib.h>
#include <string.h>

#include "model/law.h"

static void set_coefficient(fmpq_poly_t law, int k, double value)
{
  SCOPED(fmpq, c);
  scallop_rational_set_double(c, value);
  fmpq_poly_set_coeff_fmpq(law, k, c);
}

/* law / (values[0] + values[1] + ...) */
static void divide_by_sum(fmpq_poly_t law, const double *values, int count)
{
  SCOPED(fmpq, sum, value);
  for (int i = 0; i < count; i++) {
    scallop_rational_set_double(value, values[i]);
    fmpq_add(sum, sum, value);
  }
  fmpq_poly_scalar_div_fmpq(law, law, sum);
}

/* Computes the coefficients b[j] of a Bernstein law; range is the distance from near to far. */
static void bernstein_coefficients(fmpq *b, const struct scallop_law *law, const fmpq_t range)
{
  const struct scallop_bernstein_law *given = &law->bernstein;
  int n = law->degree, implied = given->implied;
  SCOPED(fmpq, others, more);
  for (int j = 0; j <= n; j++) {
    scallop_rational_set_double(b + j, j == implied ? given->way : given->b[j]);
    if (j != implied)
      fmpq_add(others, others, b + j);
  }
  for (int i = 0; i < given->more_count; i++) {
    scallop_rational_set_double(more, given->more[i]);
    fmpq_add(b + implied, b + implied, more);
  }
  fmpq_mul_si(b + implied, b + implied, n + 1);
  fmpq_div(b + implied, b + implied, range);
  fmpq_sub(b + implied, b + implied, others);
}

/* Computes the powers of u - near: ((u - near)/range)^k has the coefficient binomial(n, k) times the k-th forward
 * difference of b at its start. */
static void bernstein(fmpq_poly_t polynomial, fmpq_t origin, const struct scallop_law *law)
{
  int n = law->degree;
  fmpq *b = _fmpq_vec_init(n + 1);
  SCOPED(fmpq, range, power, c);
  SCOPED(fmpz, binomial);
  scallop_rational_set_double(origin, law->bernstein.near);
  scallop_rational_set_double(range, law->bernstein.far);
  fmpq_sub(range, range, origin);
  bernstein_coefficients(b, law, range);
  fmpq_one(power);
  for (int k = 0; k <= n; k++) {
    fmpz_bin_uiui(binomial, (ulong)n, (ulong)k);
    fmpq_mul_fmpz(c, b, binomial);
    fmpq_div(c, c, power);
    fmpq_poly_set_coeff_fmpq(polynomial, k, c);
    for (int j = 0; j < n - k; j++)
      fmpq_sub(b + j, b + j + 1, b + j);
    fmpq_mul(power, power, range);
  }
  _fmpq_vec_clear(b, n + 1);
}

void fractions_of_doubles(struct scallop_fractions *f, const struct scallop_piece *p)
{
  fmpq_poly_struct *law = f->speed;
  fmpq *origin = f->origin;
  int sense = law_sense(p);
  scallop_rational_set_double(f->least, sense > 0 ? p->begin : p->end);
  scallop_rational_set_double(f->most, sense > 0 ? p->end : p->begin);
  fmpq_poly_zero(law);
  fmpq_zero(origin);
  if (!p->law) {
    set_coefficient(law, 0, p->direction * p->velocity);
    set_coefficient(law, 1, p->direction * (sense * p->acceleration));
  } else if (p->law->kind == SCALLOP_LAW_RAMP) {
    set_coefficient(law, 0, p->law->ramp.start);
    set_coefficient(law, 1, p->law->ramp.slope);
    divide_by_sum(law, &p->law->ramp.divisor, 1);
    divide_by_sum(law, p->law->ramp.parts, 3);
  } else if (p->law->kind == SCALLOP_LAW_BERNSTEIN) {
    bernstein(law, origin, p->law);
  } else {
    for (int k = 0; k <= p->law->degree; k++)
      set_coefficient(law, k, p->law->polynomial.c[k]);
    divide_by_sum(law, &p->law->polynomial.denominator, 1);
  }
}

void scallop_exact_init(struct scallop_exact_gait *e) { *e = (struct scallop_exact_gait){ .count = 0 }; }

void scallop_exact_clear(struct scallop_exact_gait *e)
{
  for (int i = 0; i < e->count; i++)
    fractions_clear(&e->fractions[i]);
  flint_free(e->pieces);
  flint_free(e->fractions);
  scallop_exact_init(e);
}

/* Copies the pieces of both phases, and allocates fractions. */
static void copy_pieces(struct scallop_exact_gait *e, const struct scallop_gait *gait)
{
  scallop_exact_clear(e);
  e->gait = *gait;
  e->count = gait->phase[0].count + gait->phase[1].count;
  e->pieces = flint_malloc((size_t)e->count * sizeof *e->pieces);
  e->fractions = flint_malloc((size_t)e->count * sizeof *e->fractions);
  for (int kind = 0, at = 0; kind < 2; kind++) {
    const struct scallop_shape *shape = &gait->phase[kind];
    memcpy(e->pieces + at, shape->pieces, (size_t)shape->count * sizeof *e->pieces);
    e->gait.phase[kind].pieces = e->pieces + at;
    at += shape->count;
  }
  for (int i = 0; i < e->count; i++)
    fractions_init(&e->fractions[i]);
}

void scallop_exact_of(struct scallop_exact_gait *e, const struct scallop_gait *gait)
{
  copy_pieces(e, gait);
  for (int i = 0; i < e->count; i++)
    if (!e->pieces[i].exact && !law_is_sine(&e->pieces[i]) && (e->pieces[i].law || e->pieces[i].linear)) {
      fractions_of_doubles(&e->fractions[i], &e->pieces[i]);
      e->pieces[i].exact = &e->fractions[i];
    }
}

void scallop_rational_begin(fmpq_t u, const struct scallop_piece *p)
{
  if (p->exact)
    fmpq_set(u, p->anchor == SCALLOP_FROM_START ? p->exact->least : p->exact->most);
  else
    scallop_rational_set_double(u, p->begin);
}

void scallop_rational_end(fmpq_t u, const struct scallop_piece *p)
{
  if (p->exact)
    fmpq_set(u, p->anchor == SCALLOP_FROM_START ? p->exact->most : p->exact->least);
  else
    scallop_rational_set_double(u, p->end);
}
