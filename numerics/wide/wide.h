/* The exact solver in wider arithmetic: the same walk from event to event (walk.h), with 64 bits (long double of x86)
 * or 113 (binary128, in software, about a hundred times slower). It estimates the rounding error of a result in double,
 * without FLINT; it proves nothing. It does not use the double solver's short cuts.
 *
 * Domain: gaits with exact laws (scallop_gait_is_exact); others are SCALLOP_EDOMAIN, as are steady states that fill an
 * interval (possible if l' jumps). Parameters are exactly the doubles given. Allocates nothing.
 */
#ifndef SCALLOP_NUMERICS_WIDE_WIDE_H
#define SCALLOP_NUMERICS_WIDE_WIDE_H

#include "numerics/numerics.h"

#ifdef __cplusplus
extern "C" {
#endif

enum scallop_width { SCALLOP_LONG_DOUBLE, SCALLOP_BINARY128 };
/* Bits of a number: 64 and 113 on x86. 53 where long double is no wider than double; 0: not available, or set to
 * round to fewer bits than the type has. */
int scallop_width_bits(enum scallop_width width);

struct scallop_wide { /* high + low: high is the double nearest to it                                          */
  double high, low;
};

/* As in struct scallop_phase_result and struct scallop_period_result. */
struct scallop_wide_phase {
  struct scallop_wide t1, dT, v_end, dx1, dx2, dxC;
  double dx1_size, dx2_size, dxC_size; /* the magnitudes of the parts that they were summed from */
  enum scallop_regime regime;
  struct scallop_modes modes;
};
struct scallop_wide_period {
  struct scallop_wide v_start, v_mid, v_end, displacement, multiplier;
  double displacement_size; /* size of its parts, as above */
  enum scallop_regime regime;
  struct scallop_modes modes[2];
};
struct scallop_wide_steady {
  struct scallop_wide froude, mean_velocity;
  struct scallop_wide friction_work;     /* as scallop_friction_work                         */
  struct scallop_wide cost_of_transport; /* friction_work/((F1 + F2) |displacement|); nan for displacement 0 */
  struct scallop_wide_period period;
};

/* Statuses as of scallop_phase, scallop_period and scallop_steady; SCALLOP_EDOMAIN also for a width that is not
 * available, and a gait as above; SCALLOP_ERANGE if high is beyond a double's range. */
enum scallop_status scallop_wide_phase(enum scallop_width width, const struct scallop_crawler *crawler,
                                       enum scallop_phase_kind kind, double v0, struct scallop_wide_phase *result);
enum scallop_status scallop_wide_period(enum scallop_width width, const struct scallop_crawler *crawler, double v0,
                                        struct scallop_wide_period *result);
enum scallop_status scallop_wide_steady(enum scallop_width width, const struct scallop_crawler *crawler,
                                        struct scallop_wide_steady *result);

/* Estimates of |computed - true| for each number of a result in double: the distance to the result in the widest
 * arithmetic available, plus 2^-62 of the number and, for a displacement, 2^-111 of the parts that it is the sum of,
 * for the error of that result itself. Not proven: with 113 bits they are bounds unless rounding is magnified more than
 * 2^50 times. tests/numerics/certified/test_agree.c compares them with certified values. nan: the number is nan. */
struct scallop_phase_error {
  double t1, dT, v_end, dx1, dx2, dxC;
};
struct scallop_period_error {
  double v_mid, v_end, displacement, multiplier;
};
struct scallop_steady_error {
  double froude, v_start, v_mid, displacement, mean_velocity, multiplier;
};
/* Estimates the error of a result that the double solver gave for exactly these arguments. Statuses as above. */
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
