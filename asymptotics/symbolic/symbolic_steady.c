/* The steady state where l' is linear at every crossing, in closed form: times and velocities are then linear in the
 * velocity at the start, so that one step of Newton's method from anywhere ends on them, with T as one more name. */
#include <string.h>

#include "asymptotics/derived/limit.h"
#include "asymptotics/derived/scoped.h"
#include "asymptotics/symbolic/named_phase.h"

/* The crossings are found from the anchors of their pieces. */
static void set_phase(struct phase_series *to, struct branch *b, struct symbols *s, enum scallop_phase_kind kind)
{
  const struct ring ring = { 2, 2 };
  SCOPED(fmpq_poly, speed);
  SCOPED(fmpq, at_anchor);
  named_phase(to, s, kind);
  series_set_ratio(&to->fraction, symbolic_named(s, kind == SCALLOP_EXTENSION ? NAMED_alpha : NAMED_beta));
  for (int i = 0; i < b->count; i++) {
    scallop_rational_speed_series(speed, b->crossing[i].piece, at_anchor, ring.length, NULL);
    series_set_rational_poly(&to->law.at[i], speed, SERIES_ALL);
    series_mul(&to->law.at[i], &to->law.at[i], &to->whole, &ring);
    series_set_si(&b->crossing[i].offset, 0);
  }
}

static void solve(struct symbols *s, struct limit *limit, struct symbolic_steady *steady)
{
  const struct ring constants = { 1, 2 };
  symbolic T = symbolic_named(s, NAMED_T), M = symbolic_named(s, NAMED_M);
  symbolic momentum = symbolic_mul(s, M, T);
  SCOPED(phase_series, extension, contraction);
  SCOPED(steady_lift, lifted);
  SCOPED(series, eps, rest);
  series_set_ratio(&eps, symbolic_mul(s, T, T));
  set_phase(&extension, &limit->branch[0], s, SCALLOP_EXTENSION);
  set_phase(&contraction, &limit->branch[1], s, SCALLOP_CONTRACTION);
  steady_lift_from(&lifted, &rest, limit->branch, (const struct phase_series *[]){ &extension, &contraction }, &eps,
                   &constants);
  steady->v_start = symbolic_div(s, symbolic_coefficient(s, &lifted.w, 0), momentum);
  steady->v_mid = symbolic_div(s, symbolic_coefficient(s, &lifted.w_mid, 0), momentum);
  steady->displacement = symbolic_div(s, symbolic_coefficient(s, &lifted.travel, 0), M);
}

static const char *obstacle(const struct limit *limit)
{
  if (series_coefficient_is_zero(&limit->w, 0))
    return "alpha = 1/2 or F1 = F2: the start velocity is 0 for T -> 0, and bodies turn otherwise than for any alpha, "
           "F1 and F2 near these";
  return limit_is_linear(limit)
             ? NULL
             : "l' is not linear where bodies turn, so that the steady state has no closed form: see --source limit";
}

enum scallop_status symbolic_solve_steady(struct symbols *s, const struct scallop_rational_crawler *crawler,
                                          struct symbolic_steady *steady, const char **why)
{
  static const enum symbol_meaning names[] = { NAMED_m1, NAMED_m2,    NAMED_M,    NAMED_F1, NAMED_F2,
                                               NAMED_L,  NAMED_alpha, NAMED_beta, NAMED_T };
  enum { PRECISION = 128 };
  const char *unused;
  SCOPED(scallop_steady_expansion, numeric);
  enum scallop_status status = scallop_expand_steady(crawler, 1, PRECISION, &numeric, why);
  if (status != SCALLOP_OK)
    return status;
  ENDED_BY(limit_clear) struct limit limit;
  limit_init(&limit, crawler);
  limit_find(&limit, crawler, PRECISION, &unused);
  const char *wrong = obstacle(&limit);
  if (wrong) {
    if (why)
      *why = wrong;
    return SCALLOP_EDOMAIN;
  }
  for (size_t i = 0; i < sizeof names / sizeof *names; i++)
    symbols_add(s, names[i], 0, SCALLOP_EXTENSION);
  symbols_begin(s);
  solve(s, &limit, steady);
  memcpy(steady->modes, numeric.modes, sizeof steady->modes);
  return SCALLOP_OK;
}
