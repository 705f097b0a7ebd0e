/* Periodic curves through samples of l(t), cubic in pieces: the kinds of model/measured/measured.h. */
#ifndef SCALLOP_MODEL_MEASURED_FIT_H
#define SCALLOP_MODEL_MEASURED_FIT_H

#include "model/gaits.h"
#include "model/measured/measured.h"

enum { FIT_SEGMENTS = 72, FIT_LEAST = 12 }; /* samples for a least-squares spline */

struct sample {
  double t, l; /* 0 <= t < period, increasing */
};
/* For qsort: of two structs that begin with a time */
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
  struct scallop_knot *knots; /* on a circle: the first one comes again a period later */
  int count;
  double period;
};

struct fit {
  enum scallop_fit kind;
  double sigma; /* what the residuals of a least-squares spline are to be; 0: cross-validation tells */
  /* What is found: the factor of the penalty (0: not yet), PHASES' times of the least and the largest l, the estimated
   * error at a sample that is left out, the noise of a sample. */
  double stiffness, turns[2], score, noise;
  bool moves; /* the turns may move from where they are by half a segment */
};

/* Lays a curve of that kind; CHOSEN is replaced by what was chosen. The caller frees curve->knots. False: out of
 * memory, or there is none. */
bool curve_through(struct curve *curve, struct fit *fit, const struct samples *samples);

/* The root mean square of what the curve leaves of the samples */
double curve_residual(const struct curve *curve, const struct samples *samples);
/* l of the cubic between two knots, b so long after a, where the part x of that has passed */
double cubic_length(const struct scallop_knot *a, const struct scallop_knot *b, double duration, double x);
/* l at any time */
double curve_at(const struct curve *curve, double t);

/* Samples first, first + 2, ...; the caller frees at, which is NULL where there was no memory. */
struct samples samples_every_other(const struct samples *all, int first);

#endif
