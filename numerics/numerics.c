/* The solves in double (solve.h), joined with those in wider arithmetic (wide_parts.h), which tell what rounding has spoilt. */
#include "numerics/numerics.h"

#include <string.h>

#include "numerics/event/solve.h"
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
  }
  return status;
}

enum scallop_status scallop_period(const struct scallop_crawler *crawler, double v0, struct scallop_period_result *result)
{
  struct doubt doubt;
  struct scallop_wide_period wider;
  enum scallop_status status = solve_period(crawler, v0, result, &doubt);
  if (status >= 0 && doubt.left < 1 && wide_enough_period(crawler, v0, doubt.left, &wider))
    result->displacement = wider.displacement.high;
  return status;
}

static void mend(const struct scallop_crawler *crawler, const struct doubt *doubt, struct scallop_steady_result *result)
{
  struct scallop_wide_steady wider;
  bool told = wide_enough_steady(crawler, result->period.v_start, doubt->left, &wider);
  if (told && doubt->left < 1) {
    result->period.displacement = wider.period.displacement.high;
    result->mean_velocity = wider.mean_velocity.high;
  }
  if (told && doubt->delicate)
    result->period.multiplier = wider.period.multiplier.high;
}

enum scallop_status scallop_steady(const struct scallop_crawler *crawler, struct scallop_steady_result *result)
{
  struct doubt doubt;
  enum scallop_status status = solve_steady(crawler, result, &doubt);
  if (status >= 0 && (doubt.left < 1 || doubt.delicate))
    mend(crawler, &doubt, result);
  return status;
}
