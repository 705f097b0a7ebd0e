/* The solver in double (solve.h), with wider arithmetic (wide_parts.h) for numbers that rounding has spoilt. */
#include "numerics/numerics.h"

#include <math.h>
#include <string.h>

#include "numerics/digits.h"
#include "numerics/event/motion.h"
#include "numerics/wide/wide_parts.h"

const char *scallop_regime_text(enum scallop_regime regime)
{
  static const char *const text[] = { "sliding", "stick-slip", "at-rest" };
  return text[regime];
}

void scallop_modes_text(const struct scallop_modes *modes, char *text)
{
  static const char sign[] = { '-', '0', '+' };
  int kept = modes->count < SCALLOP_MODES_KEPT ? modes->count : SCALLOP_MODES_KEPT;
  for (int i = 0; i < kept; i++) {
    if (i > 0)
      *text++ = ' ';
    if (i == SCALLOP_MODES_KEPT - 1 && modes->count > kept) { /* the last place holds the last mode */
      memcpy(text, "... ", 4);
      text += 4;
    }
    *text++ = sign[modes->kept[i].s1 + 1];
    *text++ = sign[modes->kept[i].s2 + 1];
  }
  *text = '\0';
}

struct scallop_span scallop_interval_span(const struct scallop_interval *i, const struct scallop_crawler *crawler,
                                          enum scallop_phase_kind kind)
{
  const struct scallop_piece *p = i->piece;
  const double tau = scallop_phase_duration(crawler, kind), L = crawler->L, unit = L / tau,
               M = crawler->m1 + crawler->m2;
  const double mu1 = crawler->m1 / M, mu2 = crawler->m2 / M;
  const double begin = p->curve->velocity(p, i->u_begin), end = p->curve->velocity(p, i->u_end);
  const double gain = p->curve->length(p, i->u_end) - p->curve->length(p, i->u_begin);
  bool forward = p->anchor == SCALLOP_FROM_START, stuck_1 = i->mode.s1 == 0, stuck_2 = i->mode.s2 == 0;
  double way = fabs(i->u_end - i->u_begin)
               * (i->c_begin / 2 + i->c_end / 2); /* of the centre of mass, while both slide */
  return (struct scallop_span){
    .t_begin = (forward ? i->u_begin : 1 - i->u_begin) * tau,
    .t_end = (forward ? i->u_end : 1 - i->u_end) * tau,
    .duration = fabs(i->u_end - i->u_begin) * tau,
    .v1_begin = stuck_1 ? 0 : (stuck_2 ? -begin : i->c_begin - mu2 * begin) * unit,
    .v1_end = stuck_1 ? 0 : (stuck_2 ? -end : i->c_end - mu2 * end) * unit,
    .v2_begin = stuck_2 ? 0 : (stuck_1 ? begin : i->c_begin + mu1 * begin) * unit,
    .v2_end = stuck_2 ? 0 : (stuck_1 ? end : i->c_end + mu1 * end) * unit,
    .dx1 = stuck_1 ? 0 : (stuck_2 ? -gain : way - mu2 * gain) * L,
    .dx2 = stuck_2 ? 0 : (stuck_1 ? gain : way + mu1 * gain) * L,
    .mode = i->mode,
  };
}

enum scallop_status scallop_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                                  struct scallop_phase_result *result)
{
  struct doubt doubt;
  struct scallop_wide_phase wider;
  enum scallop_status status = solve_phase(crawler, kind, v0, result, &doubt);
  if (status >= 0 && doubt.left < 1 && wide_enough_phase(crawler, kind, v0, doubt.left, &wider)) {
    result->dx1 = wider.dx1.high;
    result->dx2 = wider.dx2.high;
    result->dxC = wider.dxC.high;
    if (doubt.amplified)
      result->v_end = wider.v_end.high;
    if (doubt.amplified && wider.modes.count == result->modes.count)
      result->dT = wider.dT.high;
  }
  return status;
}

enum scallop_status scallop_period(const struct scallop_crawler *crawler, double v0,
                                   struct scallop_period_result *result)
{
  struct doubt doubt;
  struct scallop_wide_period wider;
  enum scallop_status status = solve_period(crawler, v0, result, &doubt);
  if (status >= 0 && doubt.left < 1 && wide_enough_period(crawler, v0, doubt.left, &wider)) {
    result->displacement = wider.displacement.high;
    if (doubt.amplified) {
      result->v_mid = wider.v_mid.high;
      result->v_end = wider.v_end.high;
    }
  }
  return status;
}

static void mend(const struct scallop_crawler *crawler, const struct doubt *doubt, struct scallop_steady_result *result)
{
  struct scallop_wide_steady wider;
  const double guess[2] = { result->period.v_start, result->period.v_mid };
  if (!wide_enough_steady(crawler, guess, doubt->left, &wider))
    return;
  if (doubt->left < 1 && !(doubt->amplified && result->period.displacement == 0)) {
    result->period.displacement = wider.period.displacement.high;
    result->mean_velocity = wider.mean_velocity.high;
  }
  if (doubt->delicate)
    result->period.multiplier = wider.period.multiplier.high;
  if (doubt->amplified) {
    result->period.v_start = result->period.v_end = wider.period.v_start.high;
    result->period.v_mid = wider.period.v_mid.high;
    result->v_low = result->v_high = wider.period.v_start.high;
  }
}

enum scallop_status steady_in(const struct scallop_crawler *crawler, enum digits digits,
                              struct scallop_steady_result *result)
{
  struct doubt doubt;
  enum scallop_status status = solve_steady(crawler, result, &doubt);
  if (status >= 0 && ((doubt.left < 1 && digits != PICTURE_DIGITS) || (doubt.delicate && digits == ALL_DIGITS)))
    mend(crawler, &doubt, result);
  return status;
}

enum scallop_status scallop_steady(const struct scallop_crawler *crawler, struct scallop_steady_result *result)
{
  return steady_in(crawler, ALL_DIGITS, result);
}
