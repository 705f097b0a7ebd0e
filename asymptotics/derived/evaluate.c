/* The texts of the formulas as series in T: values of their symbols, and their expansion. */
#include "asymptotics/derived/evaluate.h"

#include "asymptotics/derived/formula_flint.h"
#include "asymptotics/derived/scoped.h"
#include "asymptotics/published/read.h"

void scallop_symbols_init(struct scallop_symbols *s)
{
  for (int i = 0; i < SCALLOP_SYMBOLS; i++)
    series_init(&s->value[i]);
  s->names = NULL;
}

void scallop_symbols_clear(struct scallop_symbols *s)
{
  for (int i = 0; i < SCALLOP_SYMBOLS; i++)
    series_clear(&s->value[i]);
}

bool scallop_exact_speed_series(struct series *speed, const struct scallop_piece *piece, const fmpq_t u,
                                const fmpq_t pi_squared, const struct ring *ring)
{
  const struct scallop_law *law = piece->law;
  const bool whole = law ? law->kind == SCALLOP_LAW_POLYNOMIAL && law->degree < ring->length : ring->length > 1;
  SCOPED(fmpq, one);
  fmpq_one(one);
  SCOPED(fmpq_poly, terms);
  bool rational = scallop_rational_speed_series(terms, piece, u, ring->length, pi_squared);
  bool exact = rational
               || (ring->length <= SERIES_PI_TERMS
                   && scallop_rational_speed_series(terms, piece, u, ring->length, one));
  if (rational)
    series_set_rational_poly(speed, terms, whole ? SERIES_ALL : ring->length);
  else if (exact)
    series_set_pi_poly(speed, terms, 1, 1, ring->length); /* the term in x^k has pi^(k + 1) */
  return exact;
}

/* Sets l0, lT, k0, kT: l'' T^2 and l'''' T^4 at the start and the end. */
static void set_shape(struct series *value, const struct scallop_shape *shape, const fmpq_t L, const fmpq_t pi_squared,
                      const struct ring *ring)
{
  const struct ring four = { 4, ring->precision };
  const struct scallop_piece *ends[2] = { &shape->pieces[0], &shape->pieces[shape->count - 1] };
  SCOPED(fmpq, factor, anchor);
  SCOPED(series, speed);
  for (int i = 0; i < 2; i++) {
    scallop_exact_speed_series(&speed, ends[i], anchor, pi_squared, &four); /* four terms are always exact */
    fmpq_mul_si(factor, L, ends[i]->direction);
    struct series *second = &value[i == 0 ? SCALLOP_SYMBOL_l0 : SCALLOP_SYMBOL_lT];
    struct series *fourth = &value[i == 0 ? SCALLOP_SYMBOL_k0 : SCALLOP_SYMBOL_kT];
    series_scale(&speed, &speed, factor, &four);
    series_set_coefficient(second, &speed, 1);
    series_set_coefficient(fourth, &speed, 3);
    series_scale_si(fourth, fourth, 6, ring);
  }
}

/* Sets l_0 l_T / (2 (l_T - l_0)) of an extension, minus this of a contraction; unknown if l0 and lT vanish. */
static void set_kinematic_length(struct series *value, enum scallop_phase_kind kind, const struct ring *ring)
{
  struct series *L_kin = &value[SCALLOP_SYMBOL_L_kin];
  SCOPED(series, difference);
  series_sub(&difference, &value[SCALLOP_SYMBOL_lT], &value[SCALLOP_SYMBOL_l0], ring);
  series_scale_si(&difference, &difference, kind == SCALLOP_EXTENSION ? 2 : -2, ring);
  series_mul(L_kin, &value[SCALLOP_SYMBOL_l0], &value[SCALLOP_SYMBOL_lT], ring);
  if (!series_div(L_kin, L_kin, &difference, ring))
    series_set_unknown(L_kin);
}

void scallop_symbols_complete(struct scallop_symbols *s, enum scallop_phase_kind kind, const struct ring *ring)
{
  struct series *v = s->value;
  const bool extension = kind == SCALLOP_EXTENSION;
  series_set_x(&v[SCALLOP_SYMBOL_T]);
  series_set(&v[extension ? SCALLOP_SYMBOL_l_end : SCALLOP_SYMBOL_l_start], &v[SCALLOP_SYMBOL_L]);
  series_set_si(&v[extension ? SCALLOP_SYMBOL_l_start : SCALLOP_SYMBOL_l_end], 0);
  set_kinematic_length(v, kind, ring);
}

void scallop_symbols_set(struct scallop_symbols *s, const struct scallop_rational_crawler *c,
                         enum scallop_phase_kind kind, const fmpq_t v0, const fmpq_t pi_squared,
                         const struct ring *ring)
{
  struct series *v = s->value;
  series_set_rational(&v[SCALLOP_SYMBOL_m1], c->m1);
  series_set_rational(&v[SCALLOP_SYMBOL_m2], c->m2);
  series_set_rational(&v[SCALLOP_SYMBOL_F1], c->F1);
  series_set_rational(&v[SCALLOP_SYMBOL_F2], c->F2);
  series_set_rational(&v[SCALLOP_SYMBOL_L], c->L);
  series_set_rational(&v[SCALLOP_SYMBOL_alpha], c->alpha);
  series_add(&v[SCALLOP_SYMBOL_M], &v[SCALLOP_SYMBOL_m1], &v[SCALLOP_SYMBOL_m2], ring);
  series_set_si(&v[SCALLOP_SYMBOL_v0], 0);
  if (v0)
    series_set_rational(&v[SCALLOP_SYMBOL_v0], v0);
  set_shape(v, &c->gait->phase[kind], c->L, pi_squared, ring);
  scallop_symbols_complete(s, kind, ring);
}

/* Sets the value of a symbol in the formula. exchanged: the bodies are exchanged, and l changes its sign. */
static void set_meant(struct series *value, const struct scallop_symbols *s, int symbol, bool exchanged)
{
  int sign = 1;
  series_set(value, &s->value[exchanged ? (int)scallop_symbol_exchanged((enum scallop_symbol)symbol, &sign) : symbol]);
  if (sign < 0)
    series_neg(value, value);
}

const char *scallop_formula_expand(struct series *value, const struct scallop_formula *f,
                                   const struct scallop_symbols *s, enum scallop_phase_kind kind,
                                   const struct ring *ring, char message[FORMULA_MESSAGE])
{
  struct formula formula;
  int places[FORMULA_STEPS];
  if (scallop_formula_text(&formula, f, NULL, message))
    return message;
  ENDED_BY(scallop_symbols_clear) struct scallop_symbols meant;
  scallop_symbols_init(&meant);
  for (int i = 0, count = formula_places(&formula, places); i < count; i++)
    set_meant(&meant.value[places[i]], s, places[i], scallop_formula_is_exchanged(f, kind));
  return formula_series(value, &formula, meant.value, s->names, ring, message);
}

/* Sets the balls of the names in a formula. exchanged: for the other phase, with the bodies exchanged */
static void set_names(arb_ptr values, const struct scallop_symbols *symbols, arb_srcptr given, bool exchanged,
                      slong precision)
{
  for (int i = 0, sign = 1; i < SCALLOP_SYMBOLS; i++) {
    int meant = exchanged ? (int)scallop_symbol_exchanged((enum scallop_symbol)i, &sign) : i;
    if (series_is_unknown(&symbols->value[meant]))
      arb_indeterminate(values + i);
    else
      series_coefficient(values + i, &symbols->value[meant], 0, precision);
    arb_mul_si(values + i, values + i, sign, precision);
  }
  for (int i = 0; i < 3; i++)
    if (given)
      arb_set(values + SCALLOP_SYMBOL_t1 + i, given + i);
    else
      arb_indeterminate(values + SCALLOP_SYMBOL_t1 + i);
}

void scallop_formula_in_balls(arb_t value, const struct formula *read, const struct scallop_formula *formula,
                              const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind,
                              const fmpq_t v0, const fmpq_t T, arb_srcptr given, slong precision)
{
  const bool is_steady = formula->setting == SCALLOP_STEADY;
  const enum scallop_phase_kind phase = is_steady ? SCALLOP_EXTENSION : kind;
  const struct ring ring = { 1, precision };
  arb_ptr values = _arb_vec_init(SCALLOP_SYMBOLS);
  ENDED_BY(scallop_symbols_clear) struct scallop_symbols symbols;
  scallop_symbols_init(&symbols);
  scallop_symbols_set(&symbols, crawler, phase, is_steady ? NULL : v0, NULL, &ring);
  series_set_rational(&symbols.value[SCALLOP_SYMBOL_T], T);
  set_names(values, &symbols, given, scallop_formula_is_exchanged(formula, phase), precision);
  formula_ball(value, read, values, precision);
  _arb_vec_clear(values, SCALLOP_SYMBOLS);
}
