#include "compare/answers/counts_flint.h"

static void count_certified(long digits)
{
  count_add(COUNT_CERTIFIED, 1);
  count_add(COUNT_CERTIFIED_DIGITS, digits);
}

enum scallop_status counted_certified_phase(const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind,
                                            const fmpq_t v0, long digits, struct scallop_certified_phase *phase,
                                            const char **why)
{
  count_certified(digits);
  return scallop_certified_phase(crawler, kind, v0, digits, phase, why);
}

enum scallop_status counted_certified_steady(const struct scallop_rational_crawler *crawler, long digits,
                                             struct scallop_certified_steady *steady, const char **why)
{
  count_certified(digits);
  return scallop_certified_steady(crawler, digits, steady, why);
}

enum scallop_status counted_expand_phase(const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind,
                                         const fmpq_t v0, slong order, slong precision, const fmpq_t pi_squared,
                                         struct scallop_phase_expansion *expansion, const char **why)
{
  count_add(COUNT_EXPANSIONS, 1);
  return scallop_expand_phase(crawler, kind, v0, order, precision, pi_squared, expansion, why);
}

enum scallop_status counted_expand_steady(const struct scallop_rational_crawler *crawler, slong order, slong precision,
                                          struct scallop_steady_expansion *expansion, const char **why)
{
  count_add(COUNT_EXPANSIONS, 1);
  return scallop_expand_steady(crawler, order, precision, expansion, why);
}
