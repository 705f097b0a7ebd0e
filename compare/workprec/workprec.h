/* Error against run time: every way to get the steady state, timed in turns, its answer held to the certified one.
 *
 * A way is a method at one setting. The ways of one point (a gait and a T) are made by ours.c and
 * rivals.c, timed and judged by measure.c, and written by table.c. Needs FLINT. */
#ifndef SCALLOP_WORKPREC_H
#define SCALLOP_WORKPREC_H

#include "compare/answers/points.h"
#include "compare/text/values.h"
#include <stdbool.h>

#include "compare/text/message.h"
#include "compare/workprec/stopwatch.h"
#include "numerics/certified.h"
#include "numerics/rival.h"

enum { WAY_VELOCITY, WAY_DISPLACEMENT, WAY_QUANTITIES }; /* at the start of the extension; over a period */
enum { WAY_SAMPLES = 31, WAY_TEXT = 64, WAY_STATUS = 120, WAY_TERMS = 32 /* of the longest series */ };

/* Where the ways meet. The doubles are the parameters of all of them, and `exact` is the very same numbers: a double method must not
 * be charged with the distance from 0.7 to the nearest double. */
struct trial {
  struct scallop_crawler crawler;
  struct scallop_rational_crawler exact;
  double eps; /* T^2 (F1 + F2)/(M L)                                                                  */
  struct scallop_certified_steady steady;
  long digits;    /* of it                                                                            */
  double v_start; /* the certified one, rounded                                                       */
};
/* NULL, or why there is no certified steady state to compare with. */
const char *point_init(struct trial *point, const struct scallop_crawler *crawler);
void point_clear(struct trial *point);

struct way_answer {
  double value[WAY_QUANTITIES];           /* nan: the way does not give it                                   */
  const arb_struct *ball[WAY_QUANTITIES]; /* not NULL: the answer is this one                                */
  double gait_evaluations, events, root_iterations, periods; /* nan: it counts no such thing                    */
};
extern const struct way_answer answer_none; /* all nan                                                          */

/* What a way is, for the front and for the summary. */
enum way_kind {
  WAY_FORMULA,    /* a series or a limit                                                              */
  WAY_EXACT,      /* the solvers of this tool                                                         */
  WAY_ASIDE,      /* answers another question (is told coefficients or a velocity, needs many crawlers): not on the front */
  WAY_ROOT,       /* a rival, to the root of its period map                                           */
  WAY_SIMULATION, /* a rival, simulating until its periods repeat                                     */
  WAY_LEFT_OUT    /* the library is not there                                                         */
};

struct way {
  const char *method;
  char setting[WAY_TEXT];
  enum way_kind kind;
  const struct trial *point;
  enum scallop_status (*solve)(struct way *way, const struct scallop_patience *patience, struct way_answer *answer);
  void *memory; /* what the method needs besides, made beforehand                                      */
  void (*release)(void *memory);
  long number; /* of terms or digits                                                                  */
  double tolerance;
  double share; /* of one answer in what one call does: 1, or 1/1024                                   */

  /* what was measured */
  enum scallop_status outcome;
  struct way_answer answer;
  double first; /* seconds that the first solve took                                                   */
  long passes;
  int wanted; /* repetitions */
  int taken;
  double samples[WAY_SAMPLES];
  struct stopwatch_spread time; /* of one answer                                                           */
  char status[WAY_STATUS];
  bool solved;
  char error[WAY_QUANTITIES][WAY_TEXT]; /* as it is written: three digits                          */
  double error_log10[WAY_QUANTITIES];   /* of that; nan: no error                                   */
  bool front[WAY_QUANTITIES];
};

enum { MOST_WAYS = 160 };
struct ways {
  struct way list[MOST_WAYS];
  int count;
};

/* Adds a way; its setting is printed from format. release is called for memory by ways_clear. */
struct way *ways_add(struct ways *ways, const struct trial *point, const char *method, enum way_kind kind,
                     const char *format, ...) __attribute__((format(printf, 5, 6)));
void ways_clear(struct ways *ways);

/* Published and derived series, the limit, the exact and the certified solver. quick: fewer settings. */
void ways_add_ours(struct ways *ways, const struct trial *point, bool quick);
/* GSL's solvers with events, GSL's stiff ones on smoothed friction, Moreau's time stepping, CVODE. */
void ways_add_rivals(struct ways *ways, const struct trial *point, bool quick);

struct workprec_progress {
  void (*say)(void *context, int done, int count, const struct way *way);
  void *context;
};
/* Solves, times and judges them all. limit: seconds for the first solve of each. */
void ways_measure(struct ways *ways, const struct stopwatch_clock *clock, double limit,
                  const struct workprec_progress *progress);
/* Times and errors are compared as they are written, so that who reads the table finds the same front. */
double way_seconds(double seconds);                /* with four digits                                             */
double way_error_log10(const char *error);         /* whose exponent may be beyond a double's; nan if this is no number */
bool way_has(const struct way *way, int quantity); /* whether there is a row for it                         */

extern const char *const way_quantities[]; /* their names, NULL-terminated                                 */
extern const char *const summary_columns[];
struct table;
/* The rows of one point: for each wanted error that somebody reaches. */
void summary_write(struct table *table, const struct ways *ways);

/* `scallop workprec` */
struct workprec_options {
  struct request request;
  bool quick, summary;
  struct given_number limit; /* seconds for each setting; 0: not given */
};
enum exit_code workprec_table(const struct workprec_options *options);

#endif
