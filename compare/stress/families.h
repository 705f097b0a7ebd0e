/* The cases of `stress`: families of crawlers, phases and trajectories for which digits are in danger. */
#ifndef SCALLOP_COMPARE_STRESS_FAMILIES_H
#define SCALLOP_COMPARE_STRESS_FAMILIES_H

#include "compare/answers/answer.h"
#include "compare/points/gaits.h"

enum stress_kind { STRESS_STEADY, STRESS_PHASE, STRESS_TRAJECTORY };
struct stress_case {
  enum stress_kind kind;
  struct scallop_crawler crawler;
  enum scallop_phase_kind phase; /* of a phase                  */
  double v0;                     /* of a phase, or a trajectory */
  long periods;                  /* of a trajectory             */
};
/* What is solved for a steady state or a phase. */
struct motion stress_motion(const struct stress_case *stressed);

enum { STRESS_DIMENSIONS = 10 };
/* A family changes ordinary cases, made from x[0] to x[6]; x[STRESS_DIMENSIONS] is quasi-random in [0, 1). */
struct stress_family {
  const char *name, *about;
  enum stress_kind kind;
  double eps[2];                  /* decades of T^2 (F1 + F2)/(M L); 0, 0: those of an ordinary case */
  int masses, forces;             /* which x moves their ratio by up to 12 decades either way; 0: none */
  int equal_forces, equal_phases; /* which x brings their difference near 0; 0: none */
  double scale;                   /* m, F and L each times 10^-scale to 10^scale */
  const char *gait; /* the one gait that it is made for, unless another is given; NULL: it is made for all */
  bool (*make)(struct stress_case *stressed, const double *x); /* what else, or NULL. False: x gives none */
};
extern const struct stress_family stress_families[]; /* the last has no name */

/* count cases of a family, the same for the same seed. Returns how many there are: fewer where hundreds of tries give
 * none. */
int stress_make(const struct stress_family *family, const struct scallop_gait *gait, unsigned long seed, int count,
                struct stress_case *cases);

/* The options of a case: "--m1 1 --m2 ... --gait quadratic", then for a phase "--phase extension --v0 0", for a
 * trajectory "--start 3.1 --periods 1000". text holds STRESS_ARGUMENTS bytes. */
enum { STRESS_ARGUMENTS = 400 + GAIT_TEXT };
void stress_arguments(const struct stress_case *stressed, char *text);

#endif
