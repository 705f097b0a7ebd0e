/* One phase at fixed v0 as a series in its duration T, and the steady state in closed form, with names for numbers
 *
 * Momentum replaces velocity, because it has fewer denominators: with s for the time in units of the phase, T its
 * duration and l(t) = f(t/T), Pi = M c T is a straight line of slope eps beta between its crossings, eps = T^2 and beta
 * the sum of the forces; at a crossing it meets the curve q |f'(s)|, q = m_front or -m_rear. */
#include "asymptotics/symbolic/symbolic.h"

#include <string.h>

#include "asymptotics/derived/scoped.h"

void add_derivatives(struct symbols *s, const struct scallop_piece *piece, enum scallop_phase_kind kind, slong order)
{
  SCOPED(fmpq_poly, speed);
  SCOPED(fmpq, at_anchor, one);
  fmpq_one(one);
  scallop_rational_speed_series(speed, piece, at_anchor, order > 2 ? order : 2, one);
  for (slong k = 1; k == 1 || k < order - 1; k++)
    if (k < fmpq_poly_length(speed) && !fmpz_is_zero(fmpq_poly_numref(speed) + k))
      symbols_add(s, piece->anchor == SCALLOP_FROM_START ? NAMED_AT_START : NAMED_AT_END, (int)k + 1, kind);
}

void named_law(struct series *law, struct symbols *s, const struct scallop_piece *piece, enum scallop_phase_kind kind)
{
  const struct ring all = { SYMBOLIC_ORDERS + 2, 2 };
  const enum symbol_meaning at = piece->anchor == SCALLOP_FROM_END ? NAMED_AT_END : NAMED_AT_START;
  SCOPED(series, term);
  SCOPED(fmpq, share);
  series_set_si(law, 0);
  for (int place = 0; place < s->count; place++) {
    const struct symbol *symbol = &s->list[place];
    const int power = symbol->derivative - 1;
    if (symbol->meaning != at || symbol->kind != kind)
      continue;
    fmpq_set_si(share, kind == SCALLOP_EXTENSION ? 1 : -1, 1);
    fmpz_fac_ui(fmpq_denref(share), (ulong)power);
    series_set_ratio(&term, symbolic_place(s, place));
    series_scale(&term, &term, share, &all);
    series_shift(&term, &term, power);
    series_add(law, law, &term, &all);
  }
}

void named_phase(struct phase_series *to, struct symbols *s, enum scallop_phase_kind kind)
{
  const bool extension = kind == SCALLOP_EXTENSION;
  symbolic F1 = symbolic_named(s, NAMED_F1), F2 = symbolic_named(s, NAMED_F2), both = symbolic_add(s, F1, F2);
  symbolic m1 = symbolic_named(s, NAMED_m1), m2 = symbolic_named(s, NAMED_m2);
  to->kind = kind;
  to->has_laws = true;
  series_set_ratio(&to->curve[0], extension ? m2 : m1);
  series_set_ratio(&to->curve[1], extension ? m1 : m2);
  series_neg(&to->curve[1], &to->curve[1]);
  series_set_ratio(&to->beta[2], both);
  series_neg(&to->beta[0], &to->beta[2]);
  series_set_ratio(&to->beta[1], extension ? symbolic_sub(s, F1, F2) : symbolic_sub(s, F2, F1));
  series_set_ratio(&to->whole, symbolic_named(s, NAMED_L));
  series_set_ratio(&to->unit, symbolic_div(s, symbolic_number(s, 1, 1), symbolic_named(s, NAMED_M)));
}

static void expand(struct scallop_expansion *phase, struct symbols *s, struct branch *b, enum scallop_phase_kind kind,
                   bool from_rest, slong order)
{
  const struct ring ring = { order, 2 };
  SCOPED(phase_series, p);
  SCOPED(series, v0, start, eps);
  named_phase(&p, s, kind);
  for (int i = 0; i < b->count; i++)
    named_law(&p.law.at[i], s, b->crossing[i].piece, kind);
  if (!from_rest) {
    series_set_ratio(&v0, symbolic_named(s, NAMED_v0));
    series_set_ratio(&start, symbolic_mul(s, symbolic_named(s, NAMED_M), symbolic_named(s, NAMED_v0)));
  }
  series_shift(&start, &start, 1);
  series_set_x(&eps);
  series_shift(&eps, &eps, 1);
  expand_branch(phase, b, &p, &start, &eps, &v0, &ring);
}

enum scallop_status symbolic_expand_phase(struct symbols *s, const struct scallop_rational_crawler *crawler,
                                          enum scallop_phase_kind kind, const fmpq_t v0, slong order,
                                          struct scallop_expansion *phase, const char **why)
{
  static const enum symbol_meaning names[] = { NAMED_m1, NAMED_m2, NAMED_M, NAMED_F1, NAMED_F2, NAMED_L, NAMED_v0 };
  enum { PRECISION = 64 };
  const int sign = fmpq_sgn(v0);
  SCOPED(scallop_expansion, numeric);
  SCOPED(fmpq, pi_squared);
  SCOPED(phase_constants, p);
  SCOPED(branch, b);
  fmpq_one(pi_squared);
  if (order < 1 || order > SYMBOLIC_ORDERS)
    return refused_for(SCALLOP_EDOMAIN, "the order of a formula is outside of 1 to 16", why);
  enum scallop_status status = scallop_expand_phase(crawler, kind, v0, 1, PRECISION, pi_squared, &numeric, why);
  if (status != SCALLOP_OK)
    return status;
  phase_constants_set(&p, crawler, kind);
  branch_from_ends(&b, &p, sign, sign != 0 ? sign : fmpq_sgn(p.beta[1]) < 0 ? -1 : 1);
  if (b.count > 0 && b.crossing[0].tangent)
    return refused_for(
        SCALLOP_EDOMAIN,
        "l'' = 0 at the start of the phase, where a body is stuck first: its motion is not derived as a formula", why);
  for (size_t i = 0; i < sizeof names / sizeof *names; i++)
    symbols_add(s, names[i], 0, kind);
  for (int i = 0; i < b.count; i++)
    add_derivatives(s, b.crossing[i].piece, kind, order);
  symbols_begin(s);
  expand(phase, s, &b, kind, sign == 0, order);
  memcpy(phase->modes, numeric.modes, sizeof phase->modes);
  return SCALLOP_OK;
}

/* Finds the crossings of a phase of the steady state from the anchors of their pieces, where |l'| is linear. */
static void set_steady_phase(struct phase_series *to, struct branch *b, struct symbols *s, enum scallop_phase_kind kind)
{
  const struct ring linear = { 2, 2 };
  SCOPED(fmpq_poly, speed);
  SCOPED(fmpq, at_anchor);
  named_phase(to, s, kind);
  series_set_ratio(&to->fraction, symbolic_named(s, kind == SCALLOP_EXTENSION ? NAMED_alpha : NAMED_beta));
  for (int i = 0; i < b->count; i++) {
    scallop_rational_speed_series(speed, b->crossing[i].piece, at_anchor, linear.length, NULL);
    series_set_rational_poly(&to->law.at[i], speed, SERIES_ALL);
    series_mul(&to->law.at[i], &to->law.at[i], &to->whole, &linear);
    series_set_si(&b->crossing[i].offset, 0);
  }
}

/* Solves in one step of Newton's method, with T as a name: l' is linear at every crossing, therefore times and
 * velocities are linear in the velocity at the start. */
static void solve(struct symbolic_steady *steady, struct symbols *s, struct limit *limit)
{
  const struct ring constants = { 1, 2 };
  symbolic T = symbolic_named(s, NAMED_T), M = symbolic_named(s, NAMED_M), momentum = symbolic_mul(s, M, T);
  SCOPED(phase_series, extension, contraction);
  SCOPED(steady_lift, lifted);
  SCOPED(series, eps);
  series_set_ratio(&eps, symbolic_mul(s, T, T));
  set_steady_phase(&extension, &limit->branch[0], s, SCALLOP_EXTENSION);
  set_steady_phase(&contraction, &limit->branch[1], s, SCALLOP_CONTRACTION);
  series_set_si(&limit->w, 0);
  steady_lift(&lifted, limit, (const struct phase_series *[]){ &extension, &contraction }, &eps, &constants);
  steady->v_start = symbolic_div(s, symbolic_coefficient(s, &lifted.w, 0), momentum);
  steady->v_mid = symbolic_div(s, symbolic_coefficient(s, &lifted.w_mid, 0), momentum);
  steady->displacement = symbolic_div(s, symbolic_coefficient(s, &lifted.travel, 0), M);
}

enum scallop_status symbolic_solve_steady(struct symbols *s, const struct scallop_rational_crawler *crawler,
                                          struct symbolic_steady *steady, const char **why)
{
  static const enum symbol_meaning names[] = { NAMED_m1, NAMED_m2,    NAMED_M,    NAMED_F1, NAMED_F2,
                                               NAMED_L,  NAMED_alpha, NAMED_beta, NAMED_T };
  enum { PRECISION = 128 };
  SCOPED(scallop_expansion, numeric);
  SCOPED(limit, limit);
  enum scallop_status status = scallop_expand_steady(crawler, 1, PRECISION, &numeric, why);
  if (status != SCALLOP_OK)
    return status;
  limit_find(&limit, crawler, PRECISION, NULL);
  if (series_coefficient_is_zero(&limit.w, 0))
    return refused_for(
        SCALLOP_EDOMAIN,
        "alpha = 1/2 or F1 = F2: the start velocity is 0 for T -> 0, and bodies turn otherwise than for any "
        "alpha, F1 and F2 near these",
        why);
  if (!limit_is_linear(&limit))
    return refused_for(SCALLOP_EDOMAIN,
                       "l' is not linear where bodies turn: the steady state has no closed form; see --source limit",
                       why);
  for (size_t i = 0; i < sizeof names / sizeof *names; i++)
    symbols_add(s, names[i], 0, SCALLOP_EXTENSION);
  symbols_begin(s);
  solve(steady, s, &limit);
  memcpy(steady->modes, numeric.modes, sizeof steady->modes);
  return SCALLOP_OK;
}
