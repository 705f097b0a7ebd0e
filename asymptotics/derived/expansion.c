/* The public functions of derived.h, by quantity and power, and of formula_flint.h, by crawler. */
#include "asymptotics/derived/expansion.h"

#include "asymptotics/derived/derived.h"
#include "asymptotics/derived/evaluate.h"
#include "asymptotics/derived/scoped.h"
#include "asymptotics/published/read.h"

struct scallop_series {
  slong order, precision;
  struct scallop_expansion expansion;
};

static struct scallop_series *begin(slong order, slong precision)
{
  struct scallop_series *made = flint_malloc(sizeof *made);
  made->order = order;
  made->precision = precision;
  scallop_expansion_init(&made->expansion);
  return made;
}

void scallop_series_free(struct scallop_series *series)
{
  if (series)
    scallop_expansion_clear(&series->expansion);
  flint_free(series);
}

static enum scallop_status give(struct scallop_series **series, struct scallop_series *made, enum scallop_status status)
{
  if (status == SCALLOP_OK)
    *series = made;
  else
    scallop_series_free(made);
  return status;
}

enum scallop_status scallop_series_of_phase(struct scallop_series **series,
                                            const struct scallop_rational_crawler *crawler,
                                            enum scallop_phase_kind kind, const fmpq_t v0, slong order, slong precision,
                                            const char **why)
{
  struct scallop_series *made = begin(order, precision);
  return give(series, made, scallop_expand_phase(crawler, kind, v0, order, precision, NULL, &made->expansion, why));
}

enum scallop_status scallop_series_of_steady(struct scallop_series **series,
                                             const struct scallop_rational_crawler *crawler, slong order,
                                             slong precision, const char **why)
{
  struct scallop_series *made = begin(order, precision);
  return give(series, made, scallop_expand_steady(crawler, order, precision, &made->expansion, why));
}

/* Returns the series of the quantity; NULL if the motion has no such coefficient. */
static const struct series *terms_of(const struct scallop_series *s, enum scallop_quantity quantity, slong power)
{
  const bool known = quantity < SCALLOP_QUANTITIES && power < s->order;
  return known ? scallop_expansion_of(&s->expansion, quantity) : NULL;
}

bool scallop_series_rational(fmpq_t coefficient, const struct scallop_series *s, enum scallop_quantity quantity,
                             slong power)
{
  const struct series *terms = terms_of(s, quantity, power);
  return terms && series_rational_coefficient(coefficient, terms, power);
}

bool scallop_series_ball(arb_t coefficient, const struct scallop_series *s, enum scallop_quantity quantity, slong power)
{
  const struct series *terms = terms_of(s, quantity, power);
  if (terms)
    series_coefficient(coefficient, terms, power, s->precision);
  return terms;
}

slong scallop_series_first(const struct scallop_series *s, enum scallop_quantity quantity)
{
  const struct series *terms = terms_of(s, quantity, 0);
  slong power = terms ? terms->first : s->order;
  while (power < s->order && series_coefficient_is_zero(terms, power))
    power++;
  return power < s->order ? power : s->order;
}

const char *scallop_series_modes(const struct scallop_series *s) { return s->expansion.modes; }

enum scallop_status scallop_formula_ball(arb_t value, const struct scallop_read_formula *read,
                                         const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind,
                                         const fmpq_t v0, arb_srcptr given, slong precision)
{
  if (!scallop_rational_is_valid(crawler) || fmpq_sgn(crawler->T) <= 0 || !scallop_gait_is_exact(crawler->gait)
      || precision < 2)
    return SCALLOP_EDOMAIN;
  SCOPED(fmpq, T);
  fmpq_set(T, crawler->T);
  if (read->formula.setting != SCALLOP_STEADY)
    scallop_rational_duration(T, crawler, kind);
  scallop_formula_in_balls(value, &read->operations, &read->formula, crawler, kind, v0, T, given, precision);
  return SCALLOP_OK;
}
