/* The common part of certified.c (a phase) and certified_steady.c. Not public. */
#ifndef SCALLOP_NUMERICS_CERTIFIED_CERTIFY_H
#define SCALLOP_NUMERICS_CERTIFIED_CERTIFY_H

#include "numerics/certified/certified.h"
#include "numerics/certified/march.h"

SCOPED_KIND(scallop_certified_phase, struct scallop_certified_phase)
SCOPED_KIND(scallop_certified_steady, struct scallop_certified_steady)

/* Parameters, digits and gait are such as certified.h allows. */
bool certified_domain(const struct scallop_rational_crawler *crawler, long digits);

/* Precision, in bits: what the digits are; what is lost on the way, about; the next one to try, and the last. */
slong certified_bits(long digits);
slong certified_lost_bits(const struct scallop_rational_crawler *crawler);
slong certified_more(slong precision);
slong certified_most(slong first);

/* Enough bits of its own, or a 0 to enough bits of its natural size. */
bool certified_is_accurate(const arb_t x, const arb_t size, slong bits);

enum scallop_regime certified_regime(bool sticks, bool both_move);

/* *why becomes the reason, unless why is NULL. */
void certified_say(const char **why, const char *reason);
extern const char *const certified_not_enough;

#endif
