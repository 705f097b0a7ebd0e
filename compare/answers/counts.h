/* What was really done in this run. Every solution that compare/ asks for goes through these, so that none is missed (but where
 * `workprec` times one); `run --stats` prints them. They may be called by several threads at once. */
#ifndef SCALLOP_COUNTS_H
#define SCALLOP_COUNTS_H

#include "asymptotics/asymptotics.h"
#include "numerics/numerics.h"

/* The stages of a plan (compare/scenes/plan.h), and what they count */
enum count {
  COUNT_POINTS,           /* of scenes                                                              */
  COUNT_GAITS,            /* made; the two that are built in are not                                 */
  COUNT_ONSETS,           /* longest periods without sticking                                        */
  COUNT_STEADY,           /* steady states in double                                                 */
  COUNT_PHASES,           /* phases in double, but for those within a steady state                   */
  COUNT_ROOT_ITERATIONS,  /* within both, closed forms not counted                                   */
  COUNT_GAIT_EVALUATIONS, /* of l' and l'' where they are not linear                                 */
  COUNT_FORMULAS,         /* evaluations of the paper's                                              */
  COUNT_EXPANSIONS,       /* series derived                                                          */
  COUNT_SUMS,             /* of derived series at a T                                                */
  COUNT_CERTIFIED,        /* steady states and phases in ball arithmetic                             */
  COUNT_CERTIFIED_DIGITS, /* of all of them together                                                 */
  COUNT_TRAJECTORIES,
  COUNT_SAMPLES,     /* of trajectories                                                         */
  COUNT_INTEGRATORS, /* periods by general-purpose solvers                                      */
  COUNT_ORDERS,      /* fitted                                                                  */
  COUNT_COMMANDS,    /* run at a point                                                          */
  COUNT_ROWS,        /* written by scenes                                                       */
  COUNT_PLOTS,
  COUNTS
};

void count_add(enum count what, long n);
long count_of(enum count what);
/* "steady", "root_iterations", ... */
const char *count_name(enum count what);

/* numerics.h, counted */
enum scallop_status counted_steady(const struct scallop_crawler *crawler, struct scallop_steady_result *result);
enum scallop_status counted_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                                  struct scallop_phase_result *result);
enum scallop_status counted_trajectory(const struct scallop_crawler *crawler, double v0, long periods, long samples,
                                       scallop_sampler *sampler, void *context);

#endif
