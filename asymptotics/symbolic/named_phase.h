/* What the expansions share: a phase whose constants, and whose law of l' near a crossing, are names. Not public.
 *
 * Momentum is in the place of velocity, as it has fewer denominators: with s for the time in units of the phase, T its
 * duration and l(t) = f(t/T), Pi = M c T is a straight line of slope eps beta between its crossings, eps = T^2 and beta
 * the sum of the forces, and meets at a crossing the curve q |f'(s)|, q = m_front or -m_rear. */
#ifndef SCALLOP_ASYMPTOTICS_SYMBOLIC_NAMED_PHASE_H
#define SCALLOP_ASYMPTOTICS_SYMBOLIC_NAMED_PHASE_H

#include "asymptotics/derived/branch.h"
#include "asymptotics/symbolic/symbolic.h"

/* Adds the derivatives of l at the end of a phase where its first or last piece has its anchor: f^(n), 2 <= n < order,
 * that are not 0, and n = 2 in any case. */
void add_derivatives(struct symbols *s, const struct scallop_piece *piece, enum scallop_phase_kind kind, slong order);
/* |f'| near that end, a polynomial in the derivatives of the list. */
void named_law(struct series *law, struct symbols *s, const struct scallop_piece *piece, enum scallop_phase_kind kind);

/* Everything but the laws and the fraction */
void named_phase(struct phase_series *to, struct symbols *s, enum scallop_phase_kind kind);

#endif
