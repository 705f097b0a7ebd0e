/* numerics/: the event-driven solver. No step size, no tolerance: the motion between two switching times is known in
 * closed form, and only the switching times are solved for. With M = m1 + m2, the velocity c of the centre of mass has
 *     x1' = c - (m2/M) l',   x2' = c + (m1/M) l',   c' = -(F1 s1 + F2 s2)/M,
 * so l' drops out of the dynamics: c is piecewise linear in time, and a body changes direction where c meets (m2/M) l'
 * or -(m1/M) l'. While a body is stuck, c follows its curve. docs/background/theory.md has the rest. Nothing here
 * prints, exits, holds state or uses asymptotics/; the solver allocates nothing, general-purpose methods
 * (integrator.h) do.
 * */
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
/* "++ -+ ++"; text must hold SCALLOP_MODES_TEXT bytes. "..." marks modes that were not kept. */
void scallop_modes_text(const struct scallop_modes *modes, char *text);

/* sliding: no body is stuck for any length of time, not in a dwell either. at-rest: one body never moves. */
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
  double x_begin;        /* how far the centre of mass has come since the phase began            */
};
typedef void scallop_visitor(void *context, const struct scallop_interval *interval);

/* The work that an answer took. */
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

/* One phase, both bodies starting with velocity v0 (any finite value; 0: from rest). Accuracy: at most 8 units in
 * round-to-nearest; docs/background/stability.md defines the unit and lists the exceptions, and wide.h estimates the
 * error of each result. SCALLOP_EDOMAIN: a bad crawler or v0 not finite; SCALLOP_ERANGE: scaling overflows. */
enum scallop_status scallop_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                                  struct scallop_phase_result *result);

/* Solves the phase of scallop_phase and calls visit for each interval of constant mode, in the order of time. Intervals
 * of no duration are left out. Statuses as scallop_phase, and then visit is not called. */
enum scallop_status scallop_phase_intervals(const struct scallop_crawler *crawler, enum scallop_phase_kind kind,
                                            double v0, scallop_visitor *visit, void *context);

/* An interval in the units of the parameters: in seconds, metres and metres a second, if they are. Bodies have the
 * velocities of just after the beginning and just before the end. Times are good to an ulp or two of tau; velocities
 * and displacements (perhaps differences of larger numbers) to a few ulp of L/tau and of the largest |c|, and of L.
 * Velocity and displacement of a stuck body are exactly 0. A number beyond the doubles is infinite, or 0. */
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

/* The period map P(v0): extension, then contraction. Accuracy and statuses as scallop_phase. */
enum scallop_status scallop_period(const struct scallop_crawler *crawler, double v0,
                                   struct scallop_period_result *result);

struct scallop_steady_result {
  double froude;        /* M L / (T^2 (F1 + F2))                                                 */
  double mean_velocity; /* displacement / T                                                      */
  struct scallop_period_result period;
  double v_low, v_high; /* the steady start velocities: equal unless SCALLOP_INTERVAL            */
  struct scallop_work work;
};

/* The periodic steady state: the start velocity at which the mean friction impulse over a period vanishes. The balance
 * falls monotonically with the start velocity, so a root is always bracketed and found. For a gait with continuous l'
 * it is unique (docs/background/theory.md); for others (constant:0) the roots can fill an interval (Gidoni, Margheri &
 * Rebelo, arXiv 2210.06131): SCALLOP_INTERVAL, the root nearest to 0 in period. Statuses as scallop_phase. */
enum scallop_status scallop_steady(const struct scallop_crawler *crawler, struct scallop_steady_result *result);

/* The energy that friction takes in a period of the steady state: the sum over the bodies of F_i times how far body i
 * slides, one way and the other. It takes a second walk through the period, therefore scallop_steady omits it. v_start
 * and v_mid: of that state. Accuracy as scallop_phase. SCALLOP_ERANGE: scaling overflows, or the energy is no normal
 * number; SCALLOP_EDOMAIN: a bad crawler, or a velocity that is not finite. */
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

/* Bit for bit what scallop_steady, and scallop_phase from v0[i], give for each, whatever the number of threads (>= 1;
 * at most the number of processors, and 1 if the library is built without OpenMP). If the compiler may fuse
 * multiplications and additions (-ffp-contract=fast; the Makefile forbids it) the last bits of steady states may
 * differ. Return how many have a negative status. Allocate nothing. */
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

/* periods >= 1 periods from start velocity v0, each sampled at samples >= 1 equally spaced times t = (n + j/samples) T,
 * and once more at the very end. Velocity and position at the period starts are carried in compensated arithmetic:
 * their error does not grow with the number of periods. Statuses as scallop_phase; SCALLOP_STOPPED if the sampler ended
 * it; SCALLOP_EDOMAIN also for periods or samples < 1; SCALLOP_ERANGE, after the samples before, if a position
 * overflows. */
enum scallop_status scallop_trajectory(const struct scallop_crawler *crawler, double v0, long periods, long samples,
                                       scallop_sampler *sampler, void *context);

#ifdef __cplusplus
}
#endif

#endif
