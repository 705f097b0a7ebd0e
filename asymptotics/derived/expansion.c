/* The public face of derived.h, by quantity and power, and of formula_flint.h, by crawler. */
#include "asymptotics/derived/expansion.h"

#include "asymptotics/derived/derived.h"
#include "asymptotics/derived/evaluate.h"
#include "asymptotics/derived/scoped.h"
#include "asymptotics/published/read.h"

struct scallop_series {
  bool is_steady;               /* which of the expansions it is */
  enum scallop_phase_kind kind; /* of the phase */
  slong order, precision;
  struct scallop_phase_expansion phase;
  struct scallop_steady_expansion steady;
};

static struct scallop_series *begin(slong order, slong precision)
{
  struct scallop_series *made = flint_calloc(1, sizeof *made);
  made->order = order;
  made->precision = precision;
  scallop_phase_expansion_init(&made->phase);
  scallop_steady_expansion_init(&made->steady);
  return made;
}

void scallop_series_free(struct scallop_series *series)
{
  if (!series)
    return;
  scallop_phase_expansion_clear(&series->phase);
  scallop_steady_expansion_clear(&series->steady);
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
  made->kind = kind;
  return give(series, made, scallop_expand_phase(crawler, kind, v0, order, precision, NULL, &made->phase, why));
}

enum scallop_status scallop_series_of_steady(struct scallop_series **series,
                                             const struct scallop_rational_crawler *crawler, slong order,
                                             slong precision, const char **why)
{
  struct scallop_series *made = begin(order, precision);
  made->is_steady = true;
  return give(series, made, scallop_expand_steady(crawler, order, precision, &made->steady, why));
}

/* NULL: the motion has no such quantity. */
static const struct series *of_quantity(const struct scallop_series *s, enum scallop_quantity quantity)
{
  return s->is_steady ? scallop_steady_quantity(&s->steady, quantity)
                      : scallop_phase_quantity(&s->phase, s->kind, quantity);
}

/* v_change shares the series of v_end, which begins with v0. */
static bool is_start(enum scallop_quantity quantity, slong power)
{
  return quantity == SCALLOP_VELOCITY_CHANGE && power == 0;
}

bool scallop_series_rational(fmpq_t coefficient, const struct scallop_series *s, enum scallop_quantity quantity,
                             slong power)
{
  const struct series *terms = of_quantity(s, quantity);
  if (!terms || power >= s->order)
    return false;
  if (is_start(quantity, power)) {
    fmpq_zero(coefficient);
    return true;
  }
  return series_rational_coefficient(coefficient, terms, power);
}

bool scallop_series_ball(arb_t coefficient, const struct scallop_series *s, enum scallop_quantity quantity, slong power)
{
  const struct series *terms = of_quantity(s, quantity);
  if (!terms || power >= s->order)
    return false;
  if (is_start(quantity, power))
    arb_zero(coefficient);
  else
    series_coefficient(coefficient, terms, power, s->precision);
  return true;
}

slong scallop_series_first(const struct scallop_series *s, enum scallop_quantity quantity)
{
  const struct series *terms = of_quantity(s, quantity);
  slong power = terms ? terms->first : s->order;
  while (power < s->order && (series_coefficient_is_zero(terms, power) || is_start(quantity, power)))
    power++;
  return power < s->order ? power : s->order;
}

const char *scallop_series_modes(const struct scallop_series *s)
{
  return s->is_steady ? s->steady.modes : s->phase.modes;
}

enum scallop_status scallop_formula_ball(arb_t value, const struct scallop_read_formula *read,
                                         const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind,
                                         const fmpq_t v0, arb_srcptr given, slong precision)
{
  const bool is_steady = read->formula.setting == SCALLOP_STEADY;
  if (!scallop_rational_is_valid(crawler) || fmpq_sgn(crawler->T) <= 0 || !scallop_gait_is_exact(crawler->gait)
      || precision < 2)
    return SCALLOP_EDOMAIN;
  SCOPED(fmpq, T);
  fmpq_set(T, crawler->T);
  if (!is_steady)
    scallop_rational_duration(T, crawler, kind);
  scallop_formula_in_balls(value, &read->operations, &read->formula, crawler, kind, v0, T, given, precision);
  return SCALLOP_OK;
}
