/* Error against run time: the settings of methods for the steady state of one reference. Needs FLINT.
 *
 * A method is a way to get the steady state; a setting is a method with its tolerance, number of terms or digits. The
 * settings of a reference are made by methods.c, timed and held to the certified answer by measure.c, and printed by
 * table.c. */
#ifndef SCALLOP_COMPARE_WORKPREC_SETTING_H
#define SCALLOP_COMPARE_WORKPREC_SETTING_H

#include "compare/answers/answer_flint.h"
#include "compare/text/progress.h"
#include "compare/text/stopwatch.h"
#include "compare/tables/table.h"
#include "numerics/integrators/integrator.h"

/* The quantities that are compared: Q_V_START and Q_DISPLACEMENT. */
enum { VELOCITY, DISPLACEMENT, COMPARED };
extern const enum quantity_id compared[COMPARED];

/* The crawler of the settings. Its doubles are the parameters of all of them, and `exact` holds the very same numbers:
 * a double method must not be charged with the distance from 0.7 to the nearest double. */
struct reference {
  struct scallop_crawler crawler;
  struct scallop_rational_crawler exact;
  double eps; /* T^2 (F1 + F2)/(M L) */
  struct ball_answer steady;
  long digits; /* of it */
};
/* NULL, or why there is no certified steady state to compare with. reference_clear ends it in either case. */
const char *reference_init(struct reference *reference, const struct scallop_crawler *crawler);
void reference_clear(struct reference *reference);

struct setting_answer {
  double value[COMPARED];                                    /* nan: the method does not give it     */
  const arb_struct *ball[COMPARED];                          /* not NULL: the answer is this one     */
  double gait_evaluations, events, root_iterations, periods; /* nan: the method counts no such thing */
};
extern const struct setting_answer no_answer; /* all nan */

enum method_kind {
  METHOD_FORMULA,   /* a series or a limit                          */
  METHOD_EXACT,     /* the solvers of this tool                     */
  METHOD_ROOT,      /* an integrator: the root of its period map          */
  METHOD_SIMULATION /* an integrator: simulation until its periods repeat */
};

struct setting;
/* Solves once; the answer is no_answer before. */
typedef enum scallop_status setting_solve(struct setting *setting, struct setting_answer *answer);

enum { MOST_TERMS = 32 }; /* of the longest series */
enum { SETTING_SAMPLES = 31, SETTING_TEXT = 64, SETTING_STATUS = 120, MOST_SETTINGS = 160 };
struct setting {
  char method[SETTING_TEXT], text[SETTING_TEXT];
  enum method_kind kind;
  const struct reference *reference;
  setting_solve *solve;                  /* NULL: the library is missing, as status says */
  const struct scallop_formula *formula; /* published or corrected                       */
  long number;                           /* of terms, digits or steps                    */
  double tolerance, delta;
  void *memory; /* what the method needs besides, made beforehand */
  void (*release)(void *memory);

  const struct scallop_patience *patience; /* with the solve under way, or NULL           */
  enum scallop_status outcome;             /* from here on: what was measured             */
  struct setting_answer answer;
  double first; /* seconds that the first solve took */
  long passes;
  int repetitions, taken; /* planned and done */
  double samples[SETTING_SAMPLES];
  struct stopwatch_spread time; /* of one answer */
  char status[SETTING_STATUS];
  bool solved;
  char error[COMPARED][SETTING_TEXT]; /* as printed: three digits */
  double error_log10[COMPARED];       /* of that; nan: no error   */
  bool front[COMPARED];
};

struct settings {
  struct setting list[MOST_SETTINGS];
  int count;
  int turn, turns; /* of how many references it is the turn, for progress */
};

/* methods.c. quick: fewer settings. */
void methods_add(struct settings *settings, const struct reference *reference, bool quick);
/* Is a formula of the formula file that was given, if any was, among them? False: the message is on stderr. */
bool methods_serve(const char *formulas);

/* measure.c. Adds a setting; text is printed from format. */
struct setting *settings_add(struct settings *settings, const struct reference *reference, const char *method,
                             enum method_kind kind, setting_solve *solve, const char *format, ...)
    __attribute__((format(printf, 6, 7)));
void settings_clear(struct settings *settings);
/* Settings take turns: each is solved once, for its answer and its duration; then rounds over all of them, so that a
 * machine that slows down slows all; then errors against the certified value, and the Pareto front. limit: seconds for
 * the first solve of each. */
void settings_measure(struct settings *settings, const struct stopwatch_clock *clock, double limit);
/* Is there a row for this quantity? */
bool setting_has(const struct setting *setting, int quantity);
/* Times and errors are compared as they are printed, so that the front can be found again from the table: seconds with
 * four digits; log10 of an error, whose exponent may be beyond a double's, nan if the text is no number. */
double printed_seconds(double seconds);
double printed_error_log10(const char *error);

#endif
