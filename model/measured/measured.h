/* Measured gaits: curves through samples of l(t), and the uncertainty of results due to the unknown l between samples.
 *
 *     struct scallop_measured *m = scallop_measured_new(t, l, count, NULL, "mine", &why);
 *     struct scallop_measured_gait best = scallop_measured_gait(m, SCALLOP_MEASURED_BEST);
 *
 * best.gait, with best.L, best.T and best.alpha, goes into a crawler. The same crawler with the gaits 0 to
 * SCALLOP_MEASURED_OTHERS - 1 has other results; scallop_measured_error computes an interval from them. */
#ifndef SCALLOP_MODEL_MEASURED_MEASURED_H
#define SCALLOP_MODEL_MEASURED_MEASURED_H

#include <stddef.h>

#include "model/model.h"

#ifdef __cplusplus
extern "C" {
#endif

/* MONOTONE and CUBIC pass through every sample: with Steffen's slopes (Astron. Astrophys. 239, 1990), and with l''
 * continuous on the whole circle. SMOOTH and PHASES are least-squares splines on at most 72 uniform segments, with a
 * penalty on the third differences of their B-spline coefficients (Eilers & Marx, Stat. Sci. 11, 1996). Its factor
 * gives the residuals the root mean square sigma, or is found by generalized cross-validation (Craven & Wahba, Numer.
 * Math. 31, 1979). In PHASES l'' may jump at the turns (l' = 0), as in the paper's gaits if alpha is not 1/2: the
 * displacement depends on l'' on both sides of a turn. CHOSEN is CUBIC, SMOOTH or PHASES, with the smallest estimated
 * error at samples that are left out. All are piecewise cubic. */
enum scallop_fit {
  SCALLOP_FIT_CHOSEN,
  SCALLOP_FIT_MONOTONE,
  SCALLOP_FIT_CUBIC,
  SCALLOP_FIT_SMOOTH,
  SCALLOP_FIT_PHASES
};
extern const char *const scallop_fit_names[]; /* "chosen", ...; NULL after the last */
/* Options of the fit; 0: default */
struct scallop_measured_options {
  enum scallop_fit fit;
  double sigma;  /* > 0: the noise of a sample, in units of l; 0: cross-validation estimates it */
  double period; /* > 0: period of the recording; 0: it is estimated */
};

struct scallop_measured_gait {
  const struct scallop_gait *gait; /* NULL: no such gait */
  double L, T, alpha;              /* range, period, fraction of the period from minimum to maximum of l */
};

/* Numbers of the other curves: 0 to 2 are fits of other suitable kinds, 3 and 4 are fits to every second sample, and 5
 * to 16 are fits to samples with new noise. */
enum { SCALLOP_MEASURED_BEST = -1, SCALLOP_MEASURED_OTHERS = 17, SCALLOP_MEASURED_MODELS = 5 };
struct scallop_measured;

/* Fits count rows in any order, of one period or several; all numbers finite. options may be NULL: all 0. name: of the
 * gaits; kept, not copied. NULL: *why is the reason (a constant text). The caller frees the result. */
struct scallop_measured *scallop_measured_new(const double *t, const double *l, int count,
                                              const struct scallop_measured_options *options, const char *name,
                                              const char **why);
void scallop_measured_free(struct scallop_measured *measured); /* frees the gaits; NULL is allowed */

/* Returns a gait, valid until scallop_measured_free. Not thread-safe: the first call with i >= 0 makes all others. */
struct scallop_measured_gait scallop_measured_gait(struct scallop_measured *measured, int i);
/* Returns l of the curve at t, not before the first sample. */
double scallop_measured_length(const struct scallop_measured *measured, double t);
/* Writes the samples that the curve was fitted to, within one period, in this order and the caller's units. Returns
 * their count; arrays may be NULL. */
int scallop_measured_samples(const struct scallop_measured *measured, double *t, double *l);
/* Writes a description: "51 rows, one period of 2; a cubic spline through every row". */
void scallop_measured_text(const struct scallop_measured *measured, char *text, size_t size);

/* Returns the estimated error of value: the root of the sum of two squares, of twice the standard deviation with new
 * noise and of the largest change with another curve. others: the quantity of each other gait, or nan. The interval
 * contains the true value of about 95 in 100 synthetic recordings (docs/reference/gaits.md). nan: all others are nan.
 */
double scallop_measured_error(double value, const double others[SCALLOP_MEASURED_OTHERS]);

#ifdef __cplusplus
}
#endif

#endif
