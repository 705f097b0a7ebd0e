/* Settings take turns: each is solved once, for its answer and its duration; then rounds over all of them, so that a machine that
 * slows down slows all; then errors against the certified value, and the Pareto front. */
#ifndef SCALLOP_WORKPREC_MEASURE_H
#define SCALLOP_WORKPREC_MEASURE_H

#include "compare/text/progress.h"
#include "compare/workprec/setting.h"

/* limit: seconds for the first solve of each. */
void settings_measure(struct settings *settings, const struct stopwatch_clock *clock, double limit,
                      const struct progress *progress);

/* Is there a row for this quantity? */
bool setting_has(const struct setting *setting, int quantity);
/* Times and errors are compared as they are printed, so that the front can be found again from the table: seconds with four digits;
 * log10 of an error, whose exponent may be beyond a double's, nan if the text is no number >= 0. */
double printed_seconds(double seconds);
double printed_error_log10(const char *error);

#endif
