/* numerics/: the event-driven solver. It has no step size and no tolerance: the motion between two switching times is
 * known in closed form, and the solver computes only these times. With M = m1 + m2 and the directions s1, s2 of the
 * bodies, the velocity c of the centre of mass satisfies
 *
 *     x1' = c - (m2/M) l',   x2' = c + (m1/M) l',   c' = -(F1 s1 + F2 s2)/M,
 *
 * so l' drops out of c'. While no body is stuck, c is piecewise linear in time, and a body reverses where c meets the
 * curve (m2/M) l' or -(m1/M) l'. While a body is stuck, c follows the curve of this body. docs/background/theory.md has
 * the derivation. No function here prints, exits, has a state or uses asymptotics/. The solver allocates nothing;
 * general-purpose methods (integrator.h) do. */
#ifndef SCALLOP_NUMERICS_NUMERICS_H
#define SCALLOP_NUMERICS_NUMERICS_H

#include "model/model.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { SCALLOP_MODES_KEPT = 24, SCALLOP_MODES_TEXT = 3 * SCALLOP_MODES_KEPT + 8 };

/* A mode is the pair of directions of body 1 and body 2: each -1, 0 (stuck) or +1. */
struct scallop_mode {
  signed char s1, s2;
};

/* The modes of one phase in order; those past SCALLOP_MODES_KEPT are counted and not kept. */
struct scallop_modes {
  int count;
  struct scallop_mode kept[SCALLOP_MODES_KEPT];
};
/* Writes a text such as "++ -+ ++" with at most SCALLOP_MODES_TEXT bytes; "..." stands for modes that were not kept. */
void scallop_modes_text(const struct scallop_modes *modes, char *text);

/* sliding: no body is stuck for any length of time, not even in a dwell. at-rest: one body never moves. stick-slip:
 * every other motion. */
enum scallop_regime { SCALLOP_SLIDING, SCALLOP_STICK_SLIP, SCALLOP_AT_REST };
const char *scallop_regime_text(enum scallop_regime regime);

/* An interval of time within one piece of a phase in which the mode does not change. Units: the duration of the phase
 * and L (velocities in L/tau). Offsets u are measured from the piece's anchor. */
struct scallop_interval {
  const struct scallop_piece *piece;
  double u_begin, u_end;
  struct scallop_mode mode;
  double c_begin, c_end; /* velocity of the centre of mass                                       */
  double c_slope;        /* its rate of change, when no body is stuck                            */
  double glue;           /* a stuck body: c = glue * l'; 0 when no body is stuck, or both rest in a dwell */
  double x_begin;        /* displacement of the centre of mass since the start of the phase      */
};
typedef void scallop_visitor(void *context, const struct scallop_interval *interval);

/* Counts of the work for a result */
struct scallop_work {
  long periods;          /* solved                                                             */
  long events;           /* changes of mode, and bodies that stick or are released, over all periods */
  long gait_evaluations; /* of l' or l'' (or both at once) at a time; 0 if l' is linear         */
  long root_iterations;  /* of the start velocity and of switching times, closed forms not counted */
};

struct scallop_phase_result {
  double t1;            /* first change of mode after the start; nan without a change            */
  double dT;            /* from the last change of mode to the end of the phase; nan as above    */
  double v_end;         /* velocity of both bodies at the end                                    */
  double dx1, dx2, dxC; /* displacements of body 1, body 2 and the geometric centre (x1 + x2)/2  */
  enum scallop_regime regime;
  struct scallop_modes modes;
  struct scallop_work work; /* periods: 0                                                           */
};

/* Solves one phase, with start velocity v0 of both bodies (any finite value; 0: from rest). Accuracy: at most 8 units
 * in round-to-nearest, as tested, not proven; docs/background/stability.md defines the unit and lists the exceptions,
 * and wide.h estimates the error of each result. SCALLOP_EDOMAIN: a bad crawler, or v0 not finite; SCALLOP_ERANGE:
 * scaling overflows or underflows. */
enum scallop_status scallop_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                                  struct scallop_phase_result *result);

/* Calls visit for each interval of constant mode of this phase, in the order of time, without intervals of duration 0.
 * Statuses as scallop_phase; on failure visit is not called. */
enum scallop_status scallop_phase_intervals(const struct scallop_crawler *crawler, enum scallop_phase_kind kind,
                                            double v0, scallop_visitor *visit, void *context);

/* An interval in the units of the parameters, for instance seconds, metres and metres per second. Velocities of bodies
 * are those just after the beginning and just before the end. Times are accurate to an ulp or two of tau, the duration
 * of the phase. Velocities and displacements can be differences of larger numbers: they are accurate to a few ulp of
 * L/tau and of c, and of L. Velocity and displacement of a stuck body are exactly 0. A number outside the range of
 * doubles is infinite, or 0. */
struct scallop_span {
  double t_begin, t_end; /* since the phase began                                                */
  double duration;       /* > 0, to its own last digits, also where t_end - t_begin is rounded to 0 */
  double v1_begin, v1_end, v2_begin, v2_end;
  double dx1, dx2; /* displacements of the bodies in this time                             */
  struct scallop_mode mode;
};
/* Returns the span of an interval that scallop_phase_intervals visits, with the same crawler and kind. */
struct scallop_span scallop_interval_span(const struct scallop_interval *interval,
                                          const struct scallop_crawler *crawler, enum scallop_phase_kind kind);

struct scallop_period_result {
  double v_start, v_mid; /* velocity at the start of the extension and of the contraction         */
  double v_end;          /* velocity after the period: the period map                             */
  double displacement;   /* of the geometric centre over the period                               */
  double multiplier;     /* d v_end / d v_start, in [0, 1), or 1 by rounding; from the right if it has two sides    */
  double balance;        /* mean friction force over the period / (F1 + F2): 0 when steady        */
  enum scallop_regime regime;
  struct scallop_modes modes[2];
};

/* Computes the period map P(v0): extension, then contraction. Accuracy and statuses as scallop_phase. */
enum scallop_status scallop_period(const struct scallop_crawler *crawler, double v0,
                                   struct scallop_period_result *result);

struct scallop_steady_result {
  double froude;        /* M L / (T^2 (F1 + F2))                                                 */
  double mean_velocity; /* displacement / T                                                      */
  struct scallop_period_result period;
  double v_low, v_high; /* the steady start velocities: equal unless SCALLOP_INTERVAL            */
  struct scallop_work work;
};

/* Finds the periodic steady state: the start velocity at which the mean friction impulse over a period vanishes. This
 * balance falls monotonically with the start velocity, so a root is always bracketed and found. If l' of the gait is
 * continuous, the root is unique (docs/background/theory.md). For other gaits (constant:0) the roots can fill an
 * interval (Gidoni, Margheri & Rebelo, arXiv 2210.06131): the status is then SCALLOP_INTERVAL, and period is the root
 * nearest to 0. Statuses as scallop_phase. */
enum scallop_status scallop_steady(const struct scallop_crawler *crawler, struct scallop_steady_result *result);

/* Computes the energy that friction takes in a period of the steady state: the sum over the bodies of F_i times the
 * length of the path of body i. The computation follows the period a second time, therefore scallop_steady does not
 * include it. v_start and v_mid: of that steady state. Accuracy as scallop_phase. SCALLOP_ERANGE: scaling overflows or
 * underflows, or the energy is no normal number; SCALLOP_EDOMAIN: a bad crawler, or a velocity that is not finite. */
enum scallop_status scallop_friction_work(const struct scallop_crawler *crawler, double v_start, double v_mid,
                                          double *work);

/* Many crawlers: column by column, count values in each. */
struct scallop_crawlers {
  long count;
  const double *m1, *m2, *F1, *F2, *L, *T, *alpha;
  const struct scallop_gait *const *gait;
};
/* Requested columns, of the steady states or of one phase: arrays of count; NULL: not requested. If a crawler has no
 * answer, its numbers are nan, its count of modes is 0 and its regime is unchanged. */
struct scallop_steady_states {
  double *froude, *v_start, *v_mid, *displacement, *mean_velocity, *multiplier, *v_low, *v_high;
  enum scallop_regime *regime;
  struct scallop_modes (*modes)[2];
  enum scallop_status *status;
};

struct scallop_phases {
  double *t1, *dT, *v_end, *dx1, *dx2, *dxC;
  enum scallop_regime *regime;
  struct scallop_modes *modes;
  enum scallop_status *status;
};

/* Solve for each crawler, with the same bits as scallop_steady, or as scallop_phase from v0[i], for any number of
 * threads (>= 1; at most the number of processors is used, and 1 if the library is built without OpenMP). If the
 * compiler may fuse multiplications and additions (-ffp-contract=fast; the Makefile forbids it), the last bits of
 * steady states may differ. Return the number of crawlers with a negative status. Allocate nothing. */
long scallop_steady_batch(const struct scallop_crawlers *crawlers, const struct scallop_steady_states *states,
                          int threads);
long scallop_phase_batch(const struct scallop_crawlers *crawlers, enum scallop_phase_kind kind, const double *v0,
                         const struct scallop_phases *phases, int threads);

struct scallop_sample {
  double t;          /* from the start of the first period                                    */
  double x1, x2, xC; /* xC = (x1 + x2)/2; x1 = x2 = 0 at t = 0, where l = 0                   */
  double v1, v2;
  double l;
};
/* Return false to end the trajectory early. */
typedef bool scallop_sampler(void *context, const struct scallop_sample *sample);

/* Samples the motion from start velocity v0 over periods >= 1 periods: at samples >= 1 equally spaced times t = (n +
 * j/samples) T in each, and at the end of the last. Velocity and position at the starts of periods are summed in
 * compensated arithmetic, so their rounding errors do not accumulate with the number of periods. Statuses as
 * scallop_phase; SCALLOP_STOPPED: the sampler ended it; SCALLOP_EDOMAIN also for periods or samples < 1; SCALLOP_ERANGE
 * also if a position overflows, after the samples before it. */
enum scallop_status scallop_trajectory(const struct scallop_crawler *crawler, double v0, long periods, long samples,
                                       scallop_sampler *sampler, void *context);

#ifdef __cplusplus
}
#endif

#endif
