/* Error against run time: settings of methods for the steady state of one reference. Needs FLINT.
 *
 * A method computes the steady state; a setting is a method with its tolerance, number of terms or digits. methods.c
 * makes the settings of a reference, measure.c times them and compares them with the certified answer, and table.c
 * prints them. */
#ifndef SCALLOP_COMPARE_WORKPREC_SETTING_H
#define SCALLOP_COMPARE_WORKPREC_SETTING_H

#include "compare/answers/answer_flint.h"
#include "compare/text/progress.h"
#include "compare/text/stopwatch.h"
#include "compare/tables/table.h"
#include "numerics/integrators/integrator.h"

/* Quantities compared: Q_V_START and Q_DISPLACEMENT */
enum { VELOCITY, DISPLACEMENT, COMPARED };
extern const enum quantity_id compared[COMPARED];

/* Crawler of the settings. `exact` has exactly its doubles, so a method in double is not charged with the distance from
 * 0.7 to the nearest double. */
struct reference {
  struct scallop_crawler crawler;
  struct scallop_rational_crawler exact;
  double eps; /* T^2 (F1 + F2)/(M L) */
  struct ball_answer steady;
  long digits; /* of steady */
};
/* Solves the certified steady state; returns NULL, or the reason of a failure. Call reference_clear in either case. */
const char *reference_init(struct reference *reference, const struct scallop_crawler *crawler);
void reference_clear(struct reference *reference);

struct setting_answer {
  double value[COMPARED];                                    /* nan: not computed by this method */
  const arb_struct *ball[COMPARED];                          /* if not NULL, the answer, in place of value */
  double gait_evaluations, events, root_iterations, periods; /* nan: not counted by this method */
};
extern const struct setting_answer no_answer; /* all nan */

enum method_kind {
  METHOD_FORMULA,   /* a series or a limit                          */
  METHOD_EXACT,     /* the solvers of this tool                     */
  METHOD_ROOT,      /* an integrator: the root of its period map          */
  METHOD_SIMULATION /* an integrator: simulation until its periods repeat */
};

struct setting;
/* Solves once; the caller sets the answer to no_answer. */
typedef enum scallop_status setting_solve(struct setting *setting, struct setting_answer *answer);

enum { MAX_TERMS = 32 }; /* of the longest series */
enum { SETTING_SAMPLES = 31, SETTING_TEXT = 64, SETTING_STATUS = 120, MAX_SETTINGS = 160 };
struct setting {
  char method[SETTING_TEXT], text[SETTING_TEXT];
  enum method_kind kind;
  const struct reference *reference;
  setting_solve *solve;                  /* NULL: the library is missing, see status */
  const struct scallop_formula *formula; /* published or corrected */
  long number;                           /* of terms, digits or steps */
  double tolerance, delta;
  void *memory; /* state of the method, allocated before it is timed */
  void (*release)(void *memory);

  const struct scallop_patience *patience; /* during a solve with a limit, else NULL */
  enum scallop_status outcome;             /* this and the members below: results */
  struct setting_answer answer;
  double first; /* seconds of the first solve */
  long passes;
  int repetitions, taken; /* planned and done */
  double samples[SETTING_SAMPLES];
  struct stopwatch_spread time; /* of one answer */
  char status[SETTING_STATUS];
  bool solved;
  char error[COMPARED][SETTING_TEXT]; /* as printed: three digits */
  double error_log10[COMPARED];       /* of error; nan: no error */
  bool front[COMPARED];
};

struct settings {
  struct setting list[MAX_SETTINGS];
  int count;
  int turn, turns; /* index and count of references, for progress */
};

/* methods.c. Adds the settings of all methods. quick: fewer settings */
void methods_add(struct settings *settings, const struct reference *reference, bool quick);
/* Returns false, with a message on stderr, if a formula file is given without a formula for v_start or displacement. */
bool methods_have_formulas(const char *formulas);

/* measure.c. Adds a setting; its text is printed from format. */
struct setting *settings_add(struct settings *settings, const struct reference *reference, const char *method,
                             enum method_kind kind, setting_solve *solve, const char *format, ...)
    __attribute__((format(printf, 6, 7)));
void settings_clear(struct settings *settings);
/* Solves each setting once, for its answer and its duration; times all in rounds, since a machine that slows down then
 * slows all; and finds errors against the certified value, and the Pareto front. limit: seconds for each first solve */
void settings_measure(struct settings *settings, const struct stopwatch_clock *clock, double limit);
/* Returns true if the setting has a row for this quantity. */
bool setting_has(const struct setting *setting, int quantity);
/* Return times and errors as printed, to make the front reproducible from the table: seconds with four digits; log10 of
 * an error (its exponent may exceed a double's), nan if the text is no number. */
double printed_seconds(double seconds);
double printed_error_log10(const char *error);

#endif
