/* What the expansions share: the bodies of a phase as symbols, and a crossing near an end of a phase as a series. Not
 * public.
 *
 * Momentum is in the place of velocity: Pi = M c T, which meets the curve mu |f'(s)|, mu = m_front where the rear body
 * turns and -m_rear where the front body does; s is the time in units of the phase, T its duration, and l(t) =
 * f(t/T). */
#ifndef SCALLOP_ASYMPTOTICS_SYMBOLIC_CROSSING_H
#define SCALLOP_ASYMPTOTICS_SYMBOLIC_CROSSING_H

#include "asymptotics/derived/branch.h"
#include "asymptotics/symbolic/symbolic.h"

struct bodies {
  symbolic rear_mass, front_mass;
  symbolic force[3]; /* M times the slope of c in each region: -(F1 + F2), F_rear - F_front, F1 + F2 */
};
struct bodies bodies_of(struct symbols *s, enum scallop_phase_kind kind);
/* mu of curve 0 or 1 */
symbolic bodies_curve(struct symbols *s, const struct bodies *bodies, int curve);

/* Adds the derivatives of l at the end of a phase where its first or last piece has its anchor: f^(n), 2 <= n < order,
 * that are not 0, and n = 2 in any case. */
void add_derivatives(struct symbols *s, const struct scallop_piece *piece, enum scallop_phase_kind kind, slong order);

struct end { /* of a phase: |f'| = law(y), y the time from there, a polynomial in the derivatives of the list */
  bool last; /* y is counted back from the end                                                   */
  int degree;
  symbolic mu, law[SYMBOLIC_TERMS];
};
struct end end_of(struct symbols *s, bool last, symbolic mu, enum scallop_phase_kind kind);
/* s of y */
struct symbolic_series time_of(struct symbols *s, const struct end *end, const struct symbolic_series *y, slong length);

/* |l - l(start of the phase)| at y */
struct symbolic_series way_to(struct symbols *s, const struct end *end, const struct symbolic_series *y, slong length);

struct line { /* Pi = a + b s                                                                            */
  struct symbolic_series a, b;
};
/* The root y of mu law(y) = a + b s(y), where a and b are 0 at T = 0, to so many terms */
struct symbolic_series solve_crossing(struct symbols *s, const struct end *end, const struct line *line, slong terms);

#endif
