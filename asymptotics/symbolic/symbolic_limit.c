/* The limit T -> 0 of the steady state, where it is small: as a series in what makes it small. */
#include <stdio.h>
#include <string.h>

#include "asymptotics/derived/limit.h"
#include "asymptotics/derived/scoped.h"
#include "asymptotics/symbolic/crossing.h"

/* Of all sums and products, each of some hundred bytes while it is made: ten seconds, and half a gigabyte */
#define MOST_TERMS 10000000

/* The part of a phase in which mu |l'| < M U, as a series in y = M U f/mu, f the fraction of the phase: the inverses of
 * |l'| near both ends, which are the same where the phase is reversible */
static struct symbolic_series share_of(struct symbols *s, enum scallop_phase_kind kind, bool reversible, slong length)
{
  symbolic one = symbolic_number(s, 1, 1), none = symbolic_number(s, 0, 1);
  const struct line line = { symbolic_series_set(s, one, 1, length), symbolic_series_set(s, none, 0, length) };
  struct symbolic_series share = symbolic_series_set(s, none, 0, length);
  for (int last = 0; last < 2; last++) {
    struct end end = end_of(s, last && !reversible, one, kind);
    struct symbolic_series y = solve_crossing(s, &end, &line, length);
    share = symbolic_series_add(s, &share, &y, length);
  }
  return share;
}

/* F1/(F1 + F2), F2/(F1 + F2), alpha, beta, and (F1 - F2)(2 alpha - 1)/(F1 + F2), as series in the small parameter */
struct weights {
  struct symbolic_series force[2], fraction[2], drive;
};

/* 1/2 + x/2 and 1/2 - x/2 */
static void halves(struct symbols *s, struct symbolic_series both[2], slong length)
{
  for (int k = 0; k < 2; k++) {
    struct symbolic_series x = symbolic_series_set(s, symbolic_number(s, k == 0 ? 1 : -1, 2), 1, length);
    both[k] = symbolic_series_set(s, symbolic_number(s, 1, 2), 0, length);
    both[k] = symbolic_series_add(s, &both[k], &x, length);
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

static struct weights weights_of(struct symbols *s, enum limit_parameter in, slong length)
{
  static const enum symbol_meaning forces[] = { NAMED_F1, NAMED_F2 }, fractions[] = { NAMED_alpha, NAMED_beta };
  symbolic both = symbolic_add(s, symbolic_named(s, NAMED_F1), symbolic_named(s, NAMED_F2));
  struct weights w;
  for (int k = 0; k < 2; k++) {
    w.force[k] = symbolic_series_set(s, symbolic_div(s, symbolic_named(s, forces[k]), both), 0, length);
    w.fraction[k] = symbolic_series_set(s, symbolic_named(s, fractions[k]), 0, length);
  }
  if (in == LIMIT_IN_ALPHA)
    halves(s, w.fraction, length);
  if (in == LIMIT_IN_FRICTION)
    halves(s, w.force, length);
  symbolic drive = in == LIMIT_IN_ALPHA      ? friction_difference(s)
                   : in == LIMIT_IN_FRICTION ? time_difference(s)
                                             : symbolic_number(s, 1, 1);
  w.drive = symbolic_series_set(s, drive, 1, length);
  return w;
}

/* Adds 2 F f share(M U f/mu) of a phase and its derivative by U; sign: of U, which is |U| here. */
static void add_phase(struct symbols *s, struct symbolic_series *sum, struct symbolic_series *slope,
                      const struct weights *w, enum scallop_phase_kind kind, int sign,
                      const struct symbolic_series *share, const struct symbolic_series *U, slong length)
{
  int rear = kind == SCALLOP_EXTENSION ? 0 : 1,
      turns = sign > 0 ? rear : 1 - rear; /* which body turns back and forth */
  symbolic mu = symbolic_named(s, turns == 0 ? NAMED_m2 : NAMED_m1);
  symbolic per_mu = symbolic_div(s, symbolic_named(s, NAMED_M), mu);
  struct symbolic_series scale = symbolic_series_scale(s, &w->fraction[kind], per_mu, length);
  struct symbolic_series y = symbolic_series_mul(s, &scale, U, length), value, rate, weight;
  value = rate = symbolic_series_set(s, symbolic_number(s, 0, 1), 0, length);
  for (slong k = share->length - 1; k >= 0; k--) {
    struct symbolic_series term = symbolic_series_set(s, share->term[k], 0, length);
    rate = symbolic_series_mul(s, &rate, &y, length);
    rate = symbolic_series_add(s, &rate, &value, length);
    value = symbolic_series_mul(s, &value, &y, length);
    value = symbolic_series_add(s, &value, &term, length);
  }
  weight = symbolic_series_mul(s, &w->force[turns], &w->fraction[kind], length);
  weight = symbolic_series_scale(s, &weight, symbolic_number(s, 2, 1), length);
  value = symbolic_series_mul(s, &value, &weight, length);
  rate = symbolic_series_mul(s, &rate, &weight, length);
  rate = symbolic_series_mul(s, &rate, &scale, length);
  *sum = symbolic_series_add(s, sum, &value, length);
  *slope = symbolic_series_add(s, slope, &rate, length);
}

/* |U| by Newton's method; limit->reached: how many terms of it took no more than s->most_terms */
static struct symbolic_series solve(struct symbols *s, const struct weights *w, struct symbolic_limit *limit,
                                    slong terms)
{
  struct symbolic_series U = symbolic_series_set(s, symbolic_number(s, 0, 1), 0, 1), sum, slope, share[2], drive;
  share[0] = share_of(s, SCALLOP_EXTENSION, limit->reversible, terms);
  share[1] = limit->mirrors ? share[0] : share_of(s, SCALLOP_CONTRACTION, limit->reversible, terms);
  drive = symbolic_series_scale(s, &w->drive, symbolic_number(s, limit->sign, 1), terms);
  bool last = false;
  for (slong length = 2; !last; length *= 2) {
    last = length >= terms;
    slong part = last ? terms : length;
    sum = slope = symbolic_series_set(s, symbolic_number(s, 0, 1), 0, part);
    for (int k = 0; k < 2; k++)
      add_phase(s, &sum, &slope, w, (enum scallop_phase_kind)k, limit->sign, &share[k], &U, part);
    sum = symbolic_series_sub(s, &sum, &drive, part);
    sum = symbolic_series_div(s, &sum, &slope, part);
    U = symbolic_series_sub(s, &U, &sum, part);
    limit->reached = s->terms > s->most_terms ? limit->reached : part;
  }
  return U;
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

/* Whether |l'| rises from 0 at both ends of both phases, and at once */
static bool has_ends(const struct scallop_rational_crawler *crawler)
{
  bool rises = true;
  for (int kind = 0; kind < 2; kind++) {
    ENDED_BY(phase_constants_clear) struct phase_constants p;
    phase_constants_init(&p, crawler, (enum scallop_phase_kind)kind);
    ENDED_BY(branch_clear) struct branch b;
    branch_init(&b);
    rises = rises && branch_from_ends(&b, &p, 1, 1) && b.count == 2;
  }
  return rises;
}

static const char *obstacle(const struct scallop_rational_crawler *crawler, slong order)
{
  if (order < 1 || order > SYMBOLIC_LIMIT_ORDERS)
    return "the order of a limit is outside of 1 to 10";
  if (!scallop_rational_is_valid(crawler))
    return "a parameter is outside its domain";
  if (!scallop_gait_is_exact(crawler->gait) || !branch_is_possible(crawler->gait))
    return branch_impossible;
  return has_ends(crawler) ? NULL
                           : "l'' = 0 or l' jumps at an end of a phase: the limit is no series in what makes it small";
}

static void say_given_up(struct symbolic_limit *limit, const struct symbols *s, slong order)
{
  char lower[48] = "";
  if (limit->reached > 0)
    snprintf(lower, sizeof lower, " --order %ld can be printed;", (long)limit->reached);
  snprintf(limit->why, sizeof limit->why,
           "the limit takes more than %ld terms with --order %ld;%s numbers need no --symbolic", (long)s->most_terms,
           (long)order, lower);
}

enum scallop_status symbolic_expand_limit(struct symbols *s, const struct scallop_rational_crawler *crawler,
                                          enum limit_parameter in, slong order, struct symbolic_limit *limit,
                                          const char **why)
{
  const char *reason = obstacle(crawler, order);
  if (!reason && sign_of(crawler) == 0)
    reason = "alpha = 1/2 or F1 = F2: U = 0";
  if (reason) {
    if (why)
      *why = reason;
    return SCALLOP_EDOMAIN;
  }
  limit->sign = sign_of(crawler);
  limit->mirrors = scallop_gait_mirrors(crawler->gait);
  limit->reversible = scallop_gait_is_reversible(crawler->gait);
  limit->reached = 0;
  limit->modes = limit->sign > 0 ? "++ -+ ++ | ++ +- ++" : "-- -+ -- | -- +- --";
  slong terms = order < 2 ? 2 : order;
  list_symbols(s, crawler->gait, limit, terms);
  s->most_terms = s->most_terms > 0 ? s->most_terms : MOST_TERMS;
  symbolic power = symbolic_number(s, limit->sign, 1);
  limit->small = in == LIMIT_IN_ALPHA      ? time_difference(s)
                 : in == LIMIT_IN_FRICTION ? friction_difference(s)
                                           : symbolic_mul(s, time_difference(s), friction_difference(s));
  struct weights w = weights_of(s, in, terms);
  limit->term = solve(s, &w, limit, terms);
  if (s->terms > s->most_terms) {
    say_given_up(limit, s, order);
    if (why)
      *why = limit->why;
    return SCALLOP_EDOMAIN;
  }
  limit->term.length = order;
  for (slong k = 0; k < order; k++, power = symbolic_mul(s, power, limit->small))
    limit->term.term[k] = symbolic_mul(s, limit->term.term[k], power);
  return SCALLOP_OK;
}
