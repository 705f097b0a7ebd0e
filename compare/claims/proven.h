/* Certified numbers for the claims in words. Needs FLINT. Not public. */
#ifndef SCALLOP_CLAIMS_PROVEN_H
#define SCALLOP_CLAIMS_PROVEN_H

#include <stddef.h>

#include "numerics/certified.h"

enum { PROVEN_DIGITS = 30, PROVEN_BITS = 160 };

/* Parameters are the shortest decimals that read back; v0 is what the double is. false: not decided. */
bool proven_steady(struct scallop_certified_steady *s, const struct scallop_crawler *c);
bool proven_phase(struct scallop_certified_phase *p, const struct scallop_crawler *c, enum scallop_phase_kind kind,
                  double v0);
/* dx_C of a phase from a start velocity somewhere in the ball v0: it rises with v0, since motions under one l never cross. */
bool proven_move(arb_t dxC, const struct scallop_crawler *c, enum scallop_phase_kind kind, const arb_t v0);

/* |l'| and l'' of a phase, in L over its duration (squared), a part of the duration after its start or, from_end, before its end */
void proven_speed(arb_t speed, const struct scallop_crawler *c, enum scallop_phase_kind kind, const arb_t part,
                  bool from_end);
void proven_acceleration(arb_t acceleration, const struct scallop_crawler *c, enum scallop_phase_kind kind, const arb_t part,
                         bool from_end);

/* The middle of the ball */
double proven_middle(const arb_t x);
/* The same over a double, L say */
double proven_over(const arb_t x, double unit);

#endif
