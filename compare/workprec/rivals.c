/* The rivals of numerics/rival.h, each as two ways: simulating from rest until the periods repeat, and as the root of its period map.
 * The memory of a rival is made beforehand, as its user would. */
#include "compare/workprec/workprec.h"
#include "numerics/cvode.h"
#include "numerics/moreau.h"
#include "numerics/odeiv.h"
#include "numerics/smoothed.h"

static void take(struct way_answer *answer, const struct scallop_rival_steady *steady)
{
  *answer = (struct way_answer){ .value = { steady->v_start, steady->displacement },
                                 .gait_evaluations = (double)steady->evaluations,
                                 .events = (double)steady->events,
                                 .root_iterations = (double)steady->root_iterations,
                                 .periods = (double)steady->periods };
}

static enum scallop_status simulate(struct way *way, const struct scallop_patience *patience, struct way_answer *answer)
{
  struct scallop_rival_steady steady;
  enum scallop_status status = scallop_rival_simulate(way->memory, &way->point->crawler, 0, way->tolerance, patience,
                                                      &steady);
  if (status >= 0)
    take(answer, &steady);
  return status;
}

static enum scallop_status find_root(struct way *way, const struct scallop_patience *patience, struct way_answer *answer)
{
  struct scallop_rival_steady steady;
  enum scallop_status status = scallop_rival_root(way->memory, &way->point->crawler, way->tolerance, patience, &steady);
  if (status >= 0)
    take(answer, &steady);
  return status;
}

static void release(void *memory) { scallop_rival_destroy(memory); }

enum family { ODEIV, CVODE, SMOOTHED, MOREAU };

struct setting {
  enum family family;
  int stepper;
  double tolerance, delta;
  long steps;
};

static struct scallop_rival *make(const struct setting *s)
{
  switch (s->family) {
  case ODEIV: return scallop_odeiv_rival((enum scallop_odeiv_stepper)s->stepper, s->tolerance);
  case CVODE: return scallop_cvode_rival(s->tolerance);
  case SMOOTHED: return scallop_smoothed_rival((enum scallop_smoothed_stepper)s->stepper, s->delta, s->tolerance);
  case MOREAU: return scallop_moreau_rival(s->steps);
  }
  return NULL;
}

static void describe(char text[WAY_TEXT], const struct setting *s)
{
  if (s->family == MOREAU)
    snprintf(text, WAY_TEXT, "%ld steps", s->steps);
  else if (s->family == SMOOTHED)
    snprintf(text, WAY_TEXT, "delta %g, tolerance %g", s->delta, s->tolerance);
  else
    snprintf(text, WAY_TEXT, "tolerance %g", s->tolerance);
}

/* names: of the two ways. Steady to the tolerance of the period; time stepping has none, and its steps are of second order at best. */
static void add(struct ways *ways, const struct trial *point, const char *const names[2], const struct setting *s)
{
  char text[WAY_TEXT];
  describe(text, s);
  for (int i = 0; i < 2; i++) {
    struct way *way = ways_add(ways, point, names[i], i == 0 ? WAY_SIMULATION : WAY_ROOT, "%s", text);
    way->solve = i == 0 ? simulate : find_root;
    way->tolerance = s->family == MOREAU ? 1 / ((double)s->steps * (double)s->steps) : s->tolerance;
    way->memory = make(s);
    way->release = release;
  }
}

/* What is tried of a list: from which place on, and how many. */
struct range {
  int first, count;
};
static const double tolerances[] = { 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14 };

/* to_rounding: of an order high enough for the last of them */
static struct range tolerance_range(bool quick, bool to_rounding)
{
  return quick ? (struct range){ 1, 1 } : (struct range){ 0, to_rounding ? 6 : 5 };
}

static void add_odeiv(struct ways *ways, const struct trial *point, bool quick)
{
  static const struct {
    enum scallop_odeiv_stepper stepper;
    bool to_rounding;
    const char *names[2];
  } steppers[] = {
    { SCALLOP_ODEIV_RKF45, false, { "gsl rkf45, simulated", "gsl rkf45, root" } },
    { SCALLOP_ODEIV_RK8PD, true, { "gsl rk8pd, simulated", "gsl rk8pd, root" } },
    { SCALLOP_ODEIV_MSADAMS, false, { "gsl msadams, simulated", "gsl msadams, root" } },
  };
  for (size_t k = 0; k < sizeof steppers / sizeof *steppers; k++) {
    struct range range = tolerance_range(quick, steppers[k].to_rounding);
    for (int i = range.first; i < range.first + range.count; i++)
      add(ways, point, steppers[k].names,
          &(struct setting){ .family = ODEIV, .stepper = steppers[k].stepper, .tolerance = tolerances[i] });
  }
}

static void add_cvode(struct ways *ways, const struct trial *point, bool quick)
{
  static const char *const names[2] = { "cvode, simulated", "cvode, root" };
  if (!scallop_has_cvode()) {
    for (int i = 0; i < 2; i++) {
      struct way *way = ways_add(ways, point, names[i], WAY_LEFT_OUT, "-");
      snprintf(way->status, sizeof way->status, "left out: built without SUNDIALS");
    }
    return;
  }
  struct range range = tolerance_range(quick, false);
  for (int i = range.first; i < range.first + range.count; i++)
    add(ways, point, names, &(struct setting){ .family = CVODE, .tolerance = tolerances[i] });
}

static void add_smoothed(struct ways *ways, const struct trial *point, bool quick)
{
  static const struct {
    enum scallop_smoothed_stepper stepper;
    const char *names[2];
  } steppers[] = {
    { SCALLOP_SMOOTHED_MSBDF, { "smoothed msbdf, simulated", "smoothed msbdf, root" } },
    { SCALLOP_SMOOTHED_BSIMP, { "smoothed bsimp, simulated", "smoothed bsimp, root" } },
    { SCALLOP_SMOOTHED_RK4IMP, { "smoothed rk4imp, simulated", "smoothed rk4imp, root" } },
  };
  static const double deltas[] = { 1e-2, 1e-4, 1e-6 }, tight[] = { 1e-6, 1e-9 };
  for (size_t k = 0; k < sizeof steppers / sizeof *steppers; k++)
    for (int d = 0; d < (quick ? 1 : 3); d++)
      for (int i = 0; i < (quick ? 1 : 2); i++)
        add(ways, point, steppers[k].names,
            &(struct setting){
                .family = SMOOTHED, .stepper = steppers[k].stepper, .delta = deltas[d], .tolerance = tight[i] });
}

static void add_moreau(struct ways *ways, const struct trial *point, bool quick)
{
  static const char *const names[2] = { "moreau, simulated", "moreau, root" };
  static const long steps[] = { 16, 128, 1024, 8192, 65536 };
  struct range range = quick ? (struct range){ 1, 1 } : (struct range){ 0, 5 };
  for (int i = range.first; i < range.first + range.count; i++)
    add(ways, point, names, &(struct setting){ .family = MOREAU, .steps = steps[i] });
}

void ways_add_rivals(struct ways *ways, const struct trial *point, bool quick)
{
  add_odeiv(ways, point, quick);
  add_cvode(ways, point, quick);
  add_smoothed(ways, point, quick);
  add_moreau(ways, point, quick);
}
