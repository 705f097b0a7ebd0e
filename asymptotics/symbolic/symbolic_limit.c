/* The limit T -> 0 of the steady state as a series in a small parameter */
#include <stdio.h>
#include <string.h>

#include "asymptotics/derived/limit.h"
#include "asymptotics/derived/scoped.h"
#include "asymptotics/symbolic/symbolic.h"

/* Limit of the terms of all sums and products, some hundred bytes each: half a minute, half a gigabyte */
#define MOST_TERMS 30000000

/* Sets 1/2 + x/2 or 1/2 - x/2. */
static void set_half(struct series *to, int sign)
{
  SCOPED(fmpq_poly, half);
  fmpq_poly_set_str(half, sign > 0 ? "2  1/2 1/2" : "2  1/2 -1/2");
  series_set_rational_poly(to, half, SERIES_ALL);
}

static symbolic friction_difference(struct symbols *s)
{
  symbolic F1 = symbolic_named(s, NAMED_F1), F2 = symbolic_named(s, NAMED_F2);
  return symbolic_div(s, symbolic_sub(s, F1, F2), symbolic_add(s, F1, F2));
}

static symbolic time_difference(struct symbols *s)
{
  return symbolic_sub(s, symbolic_named(s, NAMED_alpha), symbolic_named(s, NAMED_beta));
}

static symbolic parameter_of(struct symbols *s, enum limit_parameter in)
{
  return in == LIMIT_IN_ALPHA      ? time_difference(s)
         : in == LIMIT_IN_FRICTION ? friction_difference(s)
                                   : symbolic_mul(s, time_difference(s), friction_difference(s));
}

/* Sets a phase with series in the small parameter x. For LIMIT_IN_PRODUCT both differences are fixed, and the driving
 * product is x: the forces of the extension are changed by the required amount. */
static void set_phase(struct phase_series *to, struct symbols *s, enum scallop_phase_kind kind, enum limit_parameter in,
                      const struct ring *ring)
{
  const bool extension = kind == SCALLOP_EXTENSION;
  SCOPED(series, moved, drive);
  named_phase(to, s, kind);
  if (in == LIMIT_IN_ALPHA)
    set_half(&to->fraction, extension ? 1 : -1);
  else
    series_set_ratio(&to->fraction, symbolic_named(s, extension ? NAMED_alpha : NAMED_beta));
  series_set_x(&to->beta[1]);
  if (in != LIMIT_IN_FRICTION)
    series_set_ratio(&to->beta[1], friction_difference(s));
  if (!extension)
    series_neg(&to->beta[1], &to->beta[1]);
  series_set_si(&to->beta[0], -1);
  series_set_si(&to->beta[2], 1);
  if (in == LIMIT_IN_PRODUCT && extension) {
    series_set_ratio(&drive, parameter_of(s, in));
    series_set_x(&moved);
    series_sub(&moved, &moved, &drive, ring);
    series_div(&moved, &moved, &to->fraction, ring);
    for (int i = 0; i < 3; i++)
      series_add(&to->beta[i], &to->beta[i], &moved, ring);
  }
}

/* Sets the laws at the crossings near both ends: of gaits with mirrored phases by the names of the extension, of
 * reversible gaits by the names of the start: |l'| at the end is the same function of the time before it. */
static void set_laws(struct phase_series *to, struct symbols *s, const struct branch *b, enum scallop_phase_kind kind,
                     bool reversible)
{
  const struct ring all = { SYMBOLIC_ORDERS + 2, 2 };
  SCOPED(series, before);
  for (int i = 0; i < b->count; i++)
    named_law(&to->law.at[i], s, b->crossing[reversible ? 0 : i].piece, kind);
  series_set_x(&before);
  series_neg(&before, &before);
  if (reversible)
    series_compose(&to->law.at[1], &to->law.at[1], &before, &all);
}

/* Solves for U by Newton's method, from 0. */
static void solve(struct series *U, struct symbols *s, const struct scallop_rational_crawler *crawler,
                  enum limit_parameter in, const struct symbolic_limit *limit, slong terms)
{
  const struct ring all = { terms, 2 };
  SCOPED(limit, l);
  SCOPED(phase_series, extension, contraction);
  SCOPED(steady_lift, lifted);
  SCOPED(series, eps, M);
  struct phase_series *const phases[] = { &extension, &contraction };
  for (int k = 0; k < 2; k++) {
    phase_constants_set(&l.phase[k], crawler, (enum scallop_phase_kind)k);
    branch_from_ends(&l.branch[k], &l.phase[k], limit->sign, limit->sign);
    set_phase(phases[k], s, (enum scallop_phase_kind)k, in, &all);
    const int like = limit->mirrors ? 0 : k;
    set_laws(phases[k], s, &l.branch[like], (enum scallop_phase_kind)like, limit->reversible);
  }
  steady_lift_start(&lifted, &l, (const struct phase_series *[]){ &extension, &contraction }, &eps, &all);
  series_set_ratio(&M, symbolic_named(s, NAMED_M));
  series_div(U, &lifted.w, &M, &all);
}

static void list_symbols(struct symbols *s, const struct scallop_gait *gait, const struct symbolic_limit *limit,
                         slong order)
{
  static const enum symbol_meaning first[] = { NAMED_m1, NAMED_m2, NAMED_M,     NAMED_F1,
                                               NAMED_F2, NAMED_L,  NAMED_alpha, NAMED_beta };
  for (size_t i = 0; i < sizeof first / sizeof *first; i++)
    symbols_add(s, first[i], 0, SCALLOP_EXTENSION);
  for (int kind = 0; kind < (limit->mirrors ? 1 : 2); kind++) {
    const struct scallop_shape *shape = &gait->phase[kind];
    add_derivatives(s, &shape->pieces[0], (enum scallop_phase_kind)kind, order + 1);
    if (!limit->reversible)
      add_derivatives(s, &shape->pieces[shape->count - 1], (enum scallop_phase_kind)kind, order + 1);
  }
  symbols_begin(s);
}

static bool is_sine(const struct scallop_gait *gait)
{
  bool sine = true;
  for (int kind = 0; kind < 2; kind++) {
    const struct scallop_law *law = gait->phase[kind].pieces[0].law;
    sine = sine && law && law->kind == SCALLOP_LAW_SINE;
  }
  return sine;
}

/* Returns the sign of (F1 - F2)(2 alpha - 1). */
static int sign_of(const struct scallop_rational_crawler *crawler)
{
  SCOPED(fmpq, half);
  fmpq_set_si(half, 1, 2);
  int sign = fmpq_cmp(crawler->alpha, half) * fmpq_cmp(crawler->F1, crawler->F2);
  return (sign > 0) - (sign < 0);
}

const char *symbolic_limit_equation(const struct scallop_rational_crawler *crawler)
{
  static const char *const of_sine[] = {
    "F2*alpha*asin(2*alpha*M*U/(pi*m1*L)) + F1*(1 - alpha)*asin(2*(1 - alpha)*M*U/(pi*m2*L))"
    " = pi/4*(F1 - F2)*(2*alpha - 1)",
    NULL,
    "F1*alpha*asin(2*alpha*M*U/(pi*m2*L)) + F2*(1 - alpha)*asin(2*(1 - alpha)*M*U/(pi*m1*L))"
    " = pi/4*(F1 - F2)*(2*alpha - 1)"
  };
  static const char *const of_any[] = {
    "2*F2*alpha*share_e + 2*F1*(1 - alpha)*share_c = -(F1 - F2)*(2*alpha - 1), share_e "
    "being the part of the extension in which "
    "m1 |l'| < -M U/T, share_c the part of the contraction in which m2 |l'| < -M U/T",
    NULL,
    "2*F1*alpha*share_e + 2*F2*(1 - alpha)*share_c = (F1 - F2)*(2*alpha - 1), share_e "
    "being the part of the extension in which "
    "m2 |l'| < M U/T, share_c the part of the contraction in which m1 |l'| < M U/T"
  };
  return (is_sine(crawler->gait) ? of_sine : of_any)[sign_of(crawler) + 1];
}

/* Returns NULL, or the reason why no series exists: |l'| must increase linearly from 0 at both ends of both phases. */
static const char *obstacle(const struct scallop_rational_crawler *crawler, slong order)
{
  const char *none = order < 1 || order > SYMBOLIC_LIMIT_ORDERS ? "the order of a limit is outside of 1 to 10"
                                                                : not_expandable(crawler, order, 64);
  for (int kind = 0; kind < 2 && !none; kind++) {
    SCOPED(phase_constants, p);
    SCOPED(branch, b);
    phase_constants_set(&p, crawler, (enum scallop_phase_kind)kind);
    if (branch_from_ends(&b, &p, 1, 1) || b.count < 2)
      none = "l'' = 0 or l' jumps at an end of a phase: the limit is no series in what makes it small";
  }
  return none ? none : sign_of(crawler) == 0 ? "alpha = 1/2 or F1 = F2: U = 0" : NULL;
}

enum scallop_status symbolic_expand_limit(struct symbols *s, const struct scallop_rational_crawler *crawler,
                                          enum limit_parameter in, slong order, struct symbolic_limit *limit,
                                          const char **why)
{
  const char *none = obstacle(crawler, order);
  if (none)
    return refused_for(SCALLOP_EDOMAIN, none, why);
  limit->sign = sign_of(crawler);
  limit->mirrors = scallop_gait_mirrors(crawler->gait);
  limit->reversible = scallop_gait_is_reversible(crawler->gait);
  limit->modes = limit->sign > 0 ? "++ -+ ++ | ++ +- ++" : "-- -+ -- | -- +- --";
  slong terms = order < 2 ? 2 : order;
  list_symbols(s, crawler->gait, limit, terms);
  s->names.most_terms = s->most_terms > 0 ? s->most_terms : MOST_TERMS;
  limit->small = parameter_of(s, in);
  solve(&limit->term, s, crawler, in, limit, terms);
  if (names_given_up(&s->names)) {
    snprintf(limit->why, sizeof limit->why,
             "the limit takes more than %ld terms with --order %ld: ask for a lower one, or for numbers without "
             "--symbolic",
             (long)s->names.most_terms, (long)order);
    return refused_for(SCALLOP_EDOMAIN, limit->why, why);
  }
  series_truncate(&limit->term, order);
  named_poly_mul_powers(&limit->term.named, limit->small, limit->term.first, 1);
  return SCALLOP_OK;
}
