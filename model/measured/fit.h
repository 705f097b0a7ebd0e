/* Periodic, piecewise cubic curves through samples of l(t), of the kinds of model/measured/measured.h. */
#ifndef SCALLOP_MODEL_MEASURED_FIT_H
#define SCALLOP_MODEL_MEASURED_FIT_H

#include "model/gaits.h"
#include "model/measured/measured.h"

enum { FIT_SEGMENTS = 72, FIT_LEAST = 12 }; /* segments of a least-squares spline; samples that it requires */

struct sample {
  double t, l; /* 0 <= t < period, increasing */
};
/* Compares two structs that begin with a time, for qsort. */
static inline int by_time(const void *a, const void *b)
{
  double s = *(const double *)a, t = *(const double *)b;
  return (s > t) - (s < t);
}

struct samples {
  struct sample *at;
  int count;
  double period;
};

struct curve {
  struct scallop_knot *knots; /* knots of one period; the first repeats a period later */
  int count;
  double period;
};

struct fit {
  enum scallop_fit kind;
  double sigma; /* required residual of a least-squares spline; 0: cross-validation chooses it */
  /* Results: factor of the penalty (0: unknown), times of extrema of l (PHASES), error at an omitted sample, noise. */
  double stiffness, turns[2], score, noise;
  bool moves; /* the turns may move by half a segment */
};

/* Fits a curve of this kind; CHOSEN is replaced by the chosen kind. The caller frees curve->knots. Returns false if
 * memory is short or no such curve exists. */
bool curve_through(struct curve *curve, struct fit *fit, const struct samples *samples);

/* Returns the root mean square of the differences between samples and curve. */
double curve_residual(const struct curve *curve, const struct samples *samples);
/* Returns l of the cubic between two knots, `duration` apart, at the fraction x of it. */
double cubic_length(const struct scallop_knot *a, const struct scallop_knot *b, double duration, double x);
/* Returns l at any time. */
double curve_at(const struct curve *curve, double t);

/* Returns samples first, first + 2, ...; the caller frees `at`. NULL: memory is short. */
struct samples samples_every_other(const struct samples *all, int first);

#endif
