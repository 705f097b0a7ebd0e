/* Counted like those of compare/answers/counts.h: what needs FLINT. */
#ifndef SCALLOP_COUNTS_FLINT_H
#define SCALLOP_COUNTS_FLINT_H

#include "asymptotics/derived.h"
#include "compare/answers/counts.h"
#include "numerics/certified.h"

/* certified.h */
enum scallop_status counted_certified_phase(const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind,
                                            const fmpq_t v0, long digits, struct scallop_certified_phase *phase,
                                            const char **why);
enum scallop_status counted_certified_steady(const struct scallop_rational_crawler *crawler, long digits,
                                             struct scallop_certified_steady *steady, const char **why);
/* derived.h */
enum scallop_status counted_expand_phase(const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind,
                                         const fmpq_t v0, slong order, slong precision, const fmpq_t pi_squared,
                                         struct scallop_phase_expansion *expansion, const char **why);
enum scallop_status counted_expand_steady(const struct scallop_rational_crawler *crawler, slong order, slong precision,
                                          struct scallop_steady_expansion *expansion, const char **why);

#endif
