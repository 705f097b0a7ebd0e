#include "numerics/wide/wide.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

#include "numerics/event/motion.h"
#include "numerics/wide/wide_parts.h"

/* Returns the bits of long double; 0 if the processor is set to round to fewer bits than the type has, as under
 * valgrind: an iteration that ends at the last digit would take thousands of steps. */
static int long_double_bits(void)
{
  volatile long double one = 1, least = LDBL_EPSILON;
  return one + least > one ? LDBL_MANT_DIG : 0;
}

int scallop_width_bits(enum scallop_width width)
{
  if (width == SCALLOP_LONG_DOUBLE)
    return long_double_bits();
  return WIDE_HAS_FLOAT128 || LDBL_MANT_DIG == 113 ? 113 : 0;
}

/* status: of the same solve in double */
static enum scallop_status check(enum scallop_width width, const struct scallop_crawler *crawler,
                                 enum scallop_status status)
{
  if (status < 0)
    return status;
  if (status == SCALLOP_INTERVAL) /* no unique steady state */
    return SCALLOP_EDOMAIN;
  return scallop_width_bits(width) > 0 && scallop_gait_is_exact(crawler->gait) ? SCALLOP_OK : SCALLOP_EDOMAIN;
}

static bool are_finite(const struct scallop_wide *const numbers[], int count)
{
  bool finite = true;
  for (int i = 0; i < count; i++)
    finite = finite && isfinite(numbers[i]->high);
  return finite;
}

static bool period_is_finite(const struct scallop_wide_period *p)
{
  const struct scallop_wide *const numbers[] = { &p->v_start, &p->v_mid, &p->v_end, &p->displacement };
  return are_finite(numbers, 4);
}

static bool is_kept(double x) { return x == 0 || isnormal(x); }

/* In long double, unless it is no wider, or more digits cancel than it has beyond double's. */
static bool choose_width(const struct scallop_gait *gait, double left, enum scallop_width *width)
{
  bool long_enough = long_double_bits() > DBL_MANT_DIG && left > ldexp(1, DBL_MANT_DIG + 1 - LDBL_MANT_DIG);
  *width = long_enough || scallop_width_bits(SCALLOP_BINARY128) == 0 ? SCALLOP_LONG_DOUBLE : SCALLOP_BINARY128;
  return scallop_gait_is_exact(gait) && scallop_width_bits(*width) > DBL_MANT_DIG;
}

static const struct wide_solver *const solvers[] = {
  [SCALLOP_LONG_DOUBLE] = &wide_long, [SCALLOP_BINARY128] = &wide_quad
};

bool wide_enough_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0, double left,
                       struct scallop_wide_phase *out)
{
  enum scallop_width width;
  if (!choose_width(crawler->gait, left, &width))
    return false;
  solvers[width]->phase(crawler, kind, v0, out);
  return is_kept(out->dx1.high) && is_kept(out->dx2.high) && is_kept(out->dxC.high);
}

bool wide_enough_period(const struct scallop_crawler *crawler, double v0, double left, struct scallop_wide_period *out)
{
  enum scallop_width width;
  if (!choose_width(crawler->gait, left, &width))
    return false;
  solvers[width]->period(crawler, v0, false, out);
  return is_kept(out->displacement.high);
}

bool wide_enough_steady(const struct scallop_crawler *crawler, const double guess[2], double left,
                        struct scallop_wide_steady *out)
{
  enum scallop_width width;
  if (!choose_width(crawler->gait, left, &width))
    return false;
  solvers[width]->steady(crawler, guess, false, out);
  return is_kept(out->period.displacement.high) && is_kept(out->mean_velocity.high);
}

enum scallop_status scallop_wide_phase(enum scallop_width width, const struct scallop_crawler *crawler,
                                       enum scallop_phase_kind kind, double v0, struct scallop_wide_phase *result)
{
  struct scallop_wide_phase answer;
  struct scallop_phase_result plain;
  struct doubt doubt;
  enum scallop_status status = check(width, crawler, solve_phase(crawler, kind, v0, &plain, &doubt));
  if (status != SCALLOP_OK)
    return status;
  solvers[width]->phase(crawler, kind, v0, &answer);
  const struct scallop_wide *const numbers[] = { &answer.v_end, &answer.dx1, &answer.dx2, &answer.dxC };
  bool finite = are_finite(numbers, 4);
  if (finite)
    *result = answer;
  return finite ? SCALLOP_OK : SCALLOP_ERANGE;
}

enum scallop_status scallop_wide_period(enum scallop_width width, const struct scallop_crawler *crawler, double v0,
                                        struct scallop_wide_period *result)
{
  struct scallop_wide_period answer;
  struct scallop_period_result plain;
  struct doubt doubt;
  enum scallop_status status = check(width, crawler, solve_period(crawler, v0, &plain, &doubt));
  if (status != SCALLOP_OK)
    return status;
  solvers[width]->period(crawler, v0, true, &answer);
  if (!period_is_finite(&answer))
    return SCALLOP_ERANGE;
  *result = answer;
  return SCALLOP_OK;
}

enum scallop_status scallop_wide_steady(enum scallop_width width, const struct scallop_crawler *crawler,
                                        struct scallop_wide_steady *result)
{
  struct scallop_wide_steady answer;
  struct scallop_steady_result plain;
  struct doubt doubt;
  enum scallop_status status = check(width, crawler, solve_steady(crawler, &plain, &doubt));
  if (status != SCALLOP_OK)
    return status;
  const double guess[2] = { plain.period.v_start, plain.period.v_mid };
  solvers[width]->steady(crawler, guess, true, &answer);
  if (!period_is_finite(&answer.period) || !isfinite(answer.mean_velocity.high))
    return SCALLOP_ERANGE; /* GCOVR_EXCL_LINE: solve_steady has refused what does not fit a double */
  *result = answer;
  return SCALLOP_OK;
}

static enum scallop_width widest(void)
{
  return scallop_width_bits(SCALLOP_BINARY128) > 0 ? SCALLOP_BINARY128 : SCALLOP_LONG_DOUBLE;
}

/* Returns the estimate for one number; size: of the parts that it is the sum of, or 0. */
static double error_of(double value, const struct scallop_wide *exact, double size)
{
  double rounding = 0x1p-62 * fabs(value) + 0x1p-111 * size;
  return fabs((exact->high - value) + exact->low) * (1 + 0x1p-9) + rounding;
}

enum scallop_status scallop_phase_error(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                                        const struct scallop_phase_result *r, struct scallop_phase_error *error)
{
  struct scallop_wide_phase w;
  enum scallop_status status = scallop_wide_phase(widest(), crawler, kind, v0, &w);
  if (status != SCALLOP_OK)
    return status;
  *error = (struct scallop_phase_error){ error_of(r->t1, &w.t1, 0),
                                         error_of(r->dT, &w.dT, 0),
                                         error_of(r->v_end, &w.v_end, 0),
                                         error_of(r->dx1, &w.dx1, w.dx1_size),
                                         error_of(r->dx2, &w.dx2, w.dx2_size),
                                         error_of(r->dxC, &w.dxC, w.dxC_size) };
  return SCALLOP_OK;
}

enum scallop_status scallop_period_error(const struct scallop_crawler *crawler, double v0,
                                         const struct scallop_period_result *r, struct scallop_period_error *error)
{
  struct scallop_wide_period w;
  enum scallop_status status = scallop_wide_period(widest(), crawler, v0, &w);
  if (status != SCALLOP_OK)
    return status;
  *error = (struct scallop_period_error){ error_of(r->v_mid, &w.v_mid, 0), error_of(r->v_end, &w.v_end, 0),
                                          error_of(r->displacement, &w.displacement, w.displacement_size),
                                          error_of(r->multiplier, &w.multiplier, 0) };
  return SCALLOP_OK;
}

enum scallop_status scallop_steady_error(const struct scallop_crawler *crawler, const struct scallop_steady_result *r,
                                         struct scallop_steady_error *error)
{
  struct scallop_wide_steady w;
  enum scallop_status status = scallop_wide_steady(widest(), crawler, &w);
  if (status != SCALLOP_OK)
    return status;
  const struct scallop_period_result *p = &r->period;
  *error = (struct scallop_steady_error){ error_of(r->froude, &w.froude, 0),
                                          error_of(p->v_start, &w.period.v_start, 0),
                                          error_of(p->v_mid, &w.period.v_mid, 0),
                                          error_of(p->displacement, &w.period.displacement, w.period.displacement_size),
                                          error_of(r->mean_velocity, &w.mean_velocity,
                                                   w.period.displacement_size / crawler->T),
                                          error_of(p->multiplier, &w.period.multiplier, 0) };
  return SCALLOP_OK;
}
