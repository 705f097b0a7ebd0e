/* The solver of numerics.h in wider arithmetic: the same sequence of events (walk.h), with 64 bits (long double of x86)
 * or 113 bits (binary128, in software, about a hundred times slower). It estimates the rounding error of a result in
 * double, without FLINT; it proves nothing. It uses none of the short cuts of the double solver.
 *
 * Domain: gaits with exact laws (scallop_gait_is_exact). SCALLOP_EDOMAIN for other gaits, and if the steady states fill
 * an interval, as they can if l' jumps. Parameters are exactly the doubles given. Nothing is allocated. */
#ifndef SCALLOP_NUMERICS_WIDE_WIDE_H
#define SCALLOP_NUMERICS_WIDE_WIDE_H

#include "numerics/numerics.h"

#ifdef __cplusplus
extern "C" {
#endif

enum scallop_width { SCALLOP_LONG_DOUBLE, SCALLOP_BINARY128 };
/* Returns the bits of a number: 64 and 113 on x86; 53 if long double is no wider than double; 0 if the width is not
 * available, or set to round to fewer bits than the type has. */
int scallop_width_bits(enum scallop_width width);

struct scallop_wide { /* high + low: high is the double nearest to it                                          */
  double high, low;
};

/* Members as in struct scallop_phase_result and struct scallop_period_result. */
struct scallop_wide_phase {
  struct scallop_wide t1, dT, v_end, dx1, dx2, dxC;
  double dx1_size, dx2_size, dxC_size; /* sums of the magnitudes of their parts */
  enum scallop_regime regime;
  struct scallop_modes modes;
};
struct scallop_wide_period {
  struct scallop_wide v_start, v_mid, v_end, displacement, multiplier;
  double displacement_size; /* sum of the magnitudes of its parts */
  enum scallop_regime regime;
  struct scallop_modes modes[2];
};
struct scallop_wide_steady {
  struct scallop_wide froude, mean_velocity;
  struct scallop_wide friction_work;     /* as scallop_friction_work                         */
  struct scallop_wide cost_of_transport; /* friction_work/((F1 + F2) |displacement|); nan: the displacement is 0 */
  struct scallop_wide_period period;
};

/* Solve as scallop_phase, scallop_period and scallop_steady, with the same statuses. SCALLOP_EDOMAIN also for a width
 * that is not available, or a gait outside the domain above; SCALLOP_ERANGE also if high is outside the range of
 * doubles. */
enum scallop_status scallop_wide_phase(enum scallop_width width, const struct scallop_crawler *crawler,
                                       enum scallop_phase_kind kind, double v0, struct scallop_wide_phase *result);
enum scallop_status scallop_wide_period(enum scallop_width width, const struct scallop_crawler *crawler, double v0,
                                        struct scallop_wide_period *result);
enum scallop_status scallop_wide_steady(enum scallop_width width, const struct scallop_crawler *crawler,
                                        struct scallop_wide_steady *result);

/* Estimates of |computed - exact| for each number of a result in double. An estimate is the distance to the result in
 * the widest arithmetic available, plus 2^-62 of the number and, for a displacement, 2^-111 of the sum of the
 * magnitudes of its parts; the added terms allow for the error of the wide result. Estimates are not proven. With 113
 * bits they were bounds in all tests in which rounding is magnified at most 2^50 times
 * (tests/numerics/certified/test_agree.c compares them with certified values). nan: the number is nan. */
struct scallop_phase_error {
  double t1, dT, v_end, dx1, dx2, dxC;
};
struct scallop_period_error {
  double v_mid, v_end, displacement, multiplier;
};
struct scallop_steady_error {
  double froude, v_start, v_mid, displacement, mean_velocity, multiplier;
};
/* Estimate the errors of a result of the double solver for these very arguments. Statuses as above. */
enum scallop_status scallop_phase_error(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                                        const struct scallop_phase_result *result, struct scallop_phase_error *error);
enum scallop_status scallop_period_error(const struct scallop_crawler *crawler, double v0,
                                         const struct scallop_period_result *result,
                                         struct scallop_period_error *error);
enum scallop_status scallop_steady_error(const struct scallop_crawler *crawler,
                                         const struct scallop_steady_result *result,
                                         struct scallop_steady_error *error);

#ifdef __cplusplus
}
#endif

#endif
