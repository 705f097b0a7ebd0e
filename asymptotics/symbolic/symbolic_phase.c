/* One phase at fixed v0 as a series in its duration T. */
#include <string.h>

#include "asymptotics/derived/limit.h"
#include "asymptotics/derived/scoped.h"
#include "asymptotics/symbolic/named_phase.h"

static void list_symbols(struct symbols *s, const struct branch *b, enum scallop_phase_kind kind, slong order)
{
  static const enum symbol_meaning first[] = { NAMED_m1, NAMED_m2, NAMED_M, NAMED_F1, NAMED_F2, NAMED_L, NAMED_v0 };
  for (size_t i = 0; i < sizeof first / sizeof *first; i++)
    symbols_add(s, first[i], 0, kind);
  for (int i = 0; i < b->count; i++)
    add_derivatives(s, b->crossing[i].piece, kind, order);
  symbols_begin(s);
}

static void expand(struct symbols *s, const struct branch *b, enum scallop_phase_kind kind, bool from_rest, slong order,
                   struct scallop_phase_expansion *phase)
{
  const struct ring ring = { order, 2 };
  SCOPED(phase_series, p);
  named_phase(&p, s, kind);
  for (int i = 0; i < b->count; i++)
    named_law(&p.law.at[i], s, b->crossing[i].piece, kind);
  SCOPED(series, start, eps);
  if (!from_rest)
    series_set_ratio(&start, symbolic_mul(s, symbolic_named(s, NAMED_M), symbolic_named(s, NAMED_v0)));
  series_shift(&start, &start, 1);
  series_set_x(&eps);
  series_shift(&eps, &eps, 1);
  expand_branch(phase, b, &p, &start, &eps, NULL, &ring);
}

enum scallop_status symbolic_expand_phase(struct symbols *s, const struct scallop_rational_crawler *crawler,
                                          enum scallop_phase_kind kind, const fmpq_t v0, slong order,
                                          struct scallop_phase_expansion *phase, const char **why)
{
  enum { PRECISION = 64 };
  const char *wrong = order < 1 || order > SYMBOLIC_ORDERS ? "the order of a formula is outside of 1 to 16" : NULL;
  SCOPED(scallop_phase_expansion, numeric);
  SCOPED(fmpq, pi_squared);
  fmpq_one(pi_squared);
  enum scallop_status status = wrong ? SCALLOP_EDOMAIN
                                     : scallop_expand_phase(crawler, kind, v0, 1, PRECISION, pi_squared, &numeric, why);
  if (status == SCALLOP_OK) {
    ENDED_BY(phase_constants_clear) struct phase_constants p;
    phase_constants_init(&p, crawler, kind);
    ENDED_BY(branch_clear) struct branch b;
    branch_init(&b);
    int at_start = fmpq_sgn(v0), at_end = at_start != 0 ? at_start : fmpq_sgn(p.beta[1]) < 0 ? -1 : 1;
    branch_from_ends(&b, &p, at_start, at_end);
    if (b.count > 0 && b.crossing[0].tangent)
      wrong = "l'' = 0 at the start of the phase, where a body is held first: its motion is not derived as a formula";
    else {
      list_symbols(s, &b, kind, order);
      expand(s, &b, kind, at_start == 0, order, phase);
      memcpy(phase->modes, numeric.modes, sizeof phase->modes);
    }
  }
  if (wrong && why)
    *why = wrong;
  return wrong ? SCALLOP_EDOMAIN : status;
}
