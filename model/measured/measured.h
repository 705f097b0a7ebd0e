/* Measured gaits: curves through samples of l(t), and how far an answer may be off for what the samples do not tell.
 *
 *     struct scallop_measured *m = scallop_measured_new(t, l, count, NULL, "mine", &why);
 *     struct scallop_measured_gait best = scallop_measured_gait(m, SCALLOP_MEASURED_BEST);
 *
 * best.gait, with best.L, best.T and best.alpha, goes into a crawler. The same crawler with the gaits 0 to
 * SCALLOP_MEASURED_OTHERS - 1 has other answers; scallop_measured_error makes an interval of them. */
#ifndef SCALLOP_MODEL_MEASURED_MEASURED_H
#define SCALLOP_MODEL_MEASURED_MEASURED_H

#include <stddef.h>

#include "model/model.h"

#ifdef __cplusplus
extern "C" {
#endif

/* MONOTONE and CUBIC pass through every sample: with Steffen's slopes (Astron. Astrophys. 239, 1990), and with l''
 * continuous on the whole circle. SMOOTH and PHASES are least-squares splines on at most 72 uniform segments, with a
 * penalty on the third differences of their B-spline coefficients (Eilers & Marx, Stat. Sci. 11, 1996), whose factor
 * gives the residuals the root mean square sigma, or is found by generalized cross-validation (Craven & Wahba, Numer.
 * Math. 31, 1979). In PHASES l'' may jump where l turns from growing to shrinking and back, as that of the paper's
 * gaits does where alpha is not 1/2: the displacement depends on l'' on both sides of the turns. CHOSEN is the one of
 * the last three whose error at samples that it has not seen is estimated to be least. All are cubic in pieces. */
enum scallop_fit {
  SCALLOP_FIT_CHOSEN,
  SCALLOP_FIT_MONOTONE,
  SCALLOP_FIT_CUBIC,
  SCALLOP_FIT_SMOOTH,
  SCALLOP_FIT_PHASES
};
extern const char *const scallop_fit_names[]; /* "chosen", ...; NULL after the last */
struct scallop_measured_options {
  enum scallop_fit fit;
  double sigma;  /* > 0: the noise of a sample, in units of l; 0: cross-validation tells */
  double period; /* > 0: of the recording; 0: it is found */
};

struct scallop_measured_gait {
  const struct scallop_gait *gait; /* NULL: there is none */
  double L, T, alpha;              /* range, period, part of it from the least to the largest l */
};

/* 5 other curves (kinds that suit, one half of the samples, the other), and 12 with new noise. */
enum { SCALLOP_MEASURED_BEST = -1, SCALLOP_MEASURED_OTHERS = 17, SCALLOP_MEASURED_MODELS = 5 };
struct scallop_measured;

/* From count rows in any order, of one period or of several; all numbers finite. options may be NULL: all 0. The gaits
 * have that name, which is kept, not copied. NULL: *why says what is wrong (a constant text). Free the result. */
struct scallop_measured *scallop_measured_new(const double *t, const double *l, int count,
                                              const struct scallop_measured_options *options, const char *name,
                                              const char **why);
void scallop_measured_free(struct scallop_measured *measured);

/* A gait, which lives as long as measured does. The first call with i >= 0 makes all others: in one thread only. */
struct scallop_measured_gait scallop_measured_gait(struct scallop_measured *measured, int i);
/* l of the curve at t, from the first sample's t on */
double scallop_measured_length(const struct scallop_measured *measured, double t);
/* The samples that the curve was laid through, in that order and those units, within one period. Returns how many;
 * arrays may be NULL. */
int scallop_measured_samples(const struct scallop_measured *measured, double *t, double *l);
/* "51 rows, one period of 2; a cubic spline through every row", and the like */
void scallop_measured_text(const struct scallop_measured *measured, char *text, size_t size);

/* How far the truth may be from value, where others has the same quantity of each other gait, nan for none: the root of
 * the sum of the squares of twice the standard deviation with new noise, and of the largest change with another curve.
 * Of synthetic recordings some 95 in 100 have the truth inside (docs/reference/gaits.md). nan: no other has a value. */
double scallop_measured_error(double value, const double others[SCALLOP_MEASURED_OTHERS]);

#ifdef __cplusplus
}
#endif

#endif
