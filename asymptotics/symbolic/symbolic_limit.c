/* The limit T -> 0 of the steady state, where it is small: as a series in what makes it small. */
#include <stdio.h>
#include <string.h>

#include "asymptotics/derived/limit.h"
#include "asymptotics/derived/scoped.h"
#include "asymptotics/symbolic/symbolic.h"

/* Of all sums and products, each of some hundred bytes while it is made: ten seconds, and half a gigabyte */
#define MOST_TERMS 10000000

/* The part of a phase in which mu |l'| < M U, as a series in y = M U f/mu, f the fraction of the phase: where a level y
 * crosses |l'| near both ends, which is the same where the phase is reversible */
static void set_share(struct series *share, struct symbols *s, const struct scallop_rational_crawler *crawler,
                      enum scallop_phase_kind kind, bool reversible, const struct ring *ring)
{
  SCOPED(phase_constants, constants);
  SCOPED(branch, b);
  SCOPED(phase_series, p);
  SCOPED(lift, lift);
  SCOPED(series, level, none);
  phase_constants_set(&constants, crawler, kind);
  branch_from_ends(&b, &constants, 1, 1);
  b.count = reversible ? 1 : b.count;
  p.has_laws = true;
  series_set_si(&p.curve[0], 1);
  for (int i = 0; i < b.count; i++)
    named_law(&p.law.at[i], s, b.crossing[i].piece, kind);
  series_set_x(&level);
  lift_phase(&lift, &b, &p, &none, &level, &none, CROSSINGS_KNOWN, ring);
  series_add(share, &lift.when.at[0], reversible ? &lift.when.at[0] : &lift.left.at[1], ring);
}

/* F1/(F1 + F2), F2/(F1 + F2), alpha, beta, and (F1 - F2)(2 alpha - 1)/(F1 + F2), as series in the small parameter */
struct weights {
  struct series force[2], fraction[2], drive;
};
#define WEIGHTS(of) \
  of(series, &s->force[0]) of(series, &s->force[1]) of(series, &s->fraction[0]) of(series, &s->fraction[1]) \
      of(series, &s->drive)
SCOPED_PARTS(weights, struct weights, WEIGHTS)

/* 1/2 + x/2 and 1/2 - x/2 */
static void set_halves(struct series both[2])
{
  SCOPED(fmpq_poly, half);
  for (int k = 0; k < 2; k++) {
    fmpq_poly_set_str(half, k == 0 ? "2  1/2 1/2" : "2  1/2 -1/2");
    series_set_rational_poly(&both[k], half, SERIES_ALL);
  }
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

static void set_weights(struct weights *w, struct symbols *s, enum limit_parameter in)
{
  static const enum symbol_meaning forces[] = { NAMED_F1, NAMED_F2 }, fractions[] = { NAMED_alpha, NAMED_beta };
  symbolic both = symbolic_add(s, symbolic_named(s, NAMED_F1), symbolic_named(s, NAMED_F2));
  for (int k = 0; k < 2; k++) {
    series_set_ratio(&w->force[k], symbolic_div(s, symbolic_named(s, forces[k]), both));
    series_set_ratio(&w->fraction[k], symbolic_named(s, fractions[k]));
  }
  if (in == LIMIT_IN_ALPHA)
    set_halves(w->fraction);
  if (in == LIMIT_IN_FRICTION)
    set_halves(w->force);
  series_set_ratio(&w->drive, in == LIMIT_IN_ALPHA      ? friction_difference(s)
                              : in == LIMIT_IN_FRICTION ? time_difference(s)
                                                        : symbolic_number(s, 1, 1));
  series_shift(&w->drive, &w->drive, 1);
}

/* Adds 2 F f share(M U f/mu) of a phase and its derivative by U; sign: of U, which is |U| here. */
static void add_phase(struct series *sum, struct series *slope, struct symbols *s, const struct weights *w,
                      enum scallop_phase_kind kind, int sign, const struct series *share, const struct series *U,
                      const struct ring *ring)
{
  const int rear = kind == SCALLOP_EXTENSION ? 0 : 1,
            turns = sign > 0 ? rear : 1 - rear; /* which body turns back and forth */
  SCOPED(series, scale, y, value, rate, weight);
  series_set_ratio(&scale,
                   symbolic_div(s, symbolic_named(s, NAMED_M), symbolic_named(s, turns == 0 ? NAMED_m2 : NAMED_m1)));
  series_mul(&scale, &scale, &w->fraction[kind], ring);
  series_mul(&y, &scale, U, ring);
  series_compose(&value, share, &y, ring);
  series_derivative(&rate, share, ring);
  series_compose(&rate, &rate, &y, ring);
  series_mul(&weight, &w->force[turns], &w->fraction[kind], ring);
  series_scale_si(&weight, &weight, 2, ring);
  series_mul(&value, &value, &weight, ring);
  series_add(sum, sum, &value, ring);
  series_mul(&rate, &rate, &weight, ring);
  series_mul(&rate, &rate, &scale, ring);
  series_add(slope, slope, &rate, ring);
}

/* |U| by Newton's method; limit->reached: how many terms of it took no more than the names' most_terms */
static void solve(struct series *U, struct symbols *s, const struct scallop_rational_crawler *crawler,
                  const struct weights *w, struct symbolic_limit *limit, slong terms)
{
  const struct ring all = { terms, 2 };
  bool last = false;
  SCOPED(series, sum, slope, extension, contraction, drive);
  set_share(&extension, s, crawler, SCALLOP_EXTENSION, limit->reversible, &all);
  if (!limit->mirrors)
    set_share(&contraction, s, crawler, SCALLOP_CONTRACTION, limit->reversible, &all);
  const struct series *const share[] = { &extension, limit->mirrors ? &extension : &contraction };
  series_scale_si(&drive, &w->drive, limit->sign, &all);
  series_set_si(U, 0);
  for (slong length = 2; !last; length *= 2) {
    last = length >= terms;
    const struct ring part = { last ? terms : length, 2 };
    U->known = SERIES_ALL; /* right up to half of this length */
    series_set_si(&sum, 0);
    series_set_si(&slope, 0);
    for (int k = 0; k < 2; k++)
      add_phase(&sum, &slope, s, w, (enum scallop_phase_kind)k, limit->sign, share[k], U, &part);
    series_sub(&sum, &sum, &drive, &part);
    series_div(&sum, &sum, &slope, &part);
    series_sub(U, U, &sum, &part);
    limit->reached = names_given_up(&s->names) ? limit->reached : part.length;
  }
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

/* Of (F1 - F2)(2 alpha - 1) */
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

/* NULL, or why there is no series: |l'| must rise from 0 at both ends of both phases, and at once. */
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

static void say_given_up(struct symbolic_limit *limit, const struct symbols *s, slong order)
{
  char lower[48] = "";
  if (limit->reached > 0)
    snprintf(lower, sizeof lower, " --order %ld can be printed;", (long)limit->reached);
  snprintf(limit->why, sizeof limit->why,
           "the limit takes more than %ld terms with --order %ld;%s numbers need no --symbolic",
           (long)s->names.most_terms, (long)order, lower);
}

enum scallop_status symbolic_expand_limit(struct symbols *s, const struct scallop_rational_crawler *crawler,
                                          enum limit_parameter in, slong order, struct symbolic_limit *limit,
                                          const char **why)
{
  const char *none = obstacle(crawler, order);
  if (none)
    return refused(SCALLOP_EDOMAIN, none, why);
  limit->sign = sign_of(crawler);
  limit->mirrors = scallop_gait_mirrors(crawler->gait);
  limit->reversible = scallop_gait_is_reversible(crawler->gait);
  limit->reached = 0;
  limit->modes = limit->sign > 0 ? "++ -+ ++ | ++ +- ++" : "-- -+ -- | -- +- --";
  slong terms = order < 2 ? 2 : order;
  list_symbols(s, crawler->gait, limit, terms);
  s->names.most_terms = s->most_terms > 0 ? s->most_terms : MOST_TERMS;
  limit->small = in == LIMIT_IN_ALPHA      ? time_difference(s)
                 : in == LIMIT_IN_FRICTION ? friction_difference(s)
                                           : symbolic_mul(s, time_difference(s), friction_difference(s));
  SCOPED(weights, w);
  set_weights(&w, s, in);
  solve(&limit->term, s, crawler, &w, limit, terms);
  if (names_given_up(&s->names)) {
    say_given_up(limit, s, order);
    return refused(SCALLOP_EDOMAIN, limit->why, why);
  }
  const struct ring ring = { terms, 2 };
  series_truncate(&limit->term, order);
  series_scale_si(&limit->term, &limit->term, limit->sign, &ring);
  named_poly_mul_powers(&limit->term.named, limit->small, limit->term.first, 1);
  return SCALLOP_OK;
}
