/* The rivals of numerics/rivals/rival.h: GSL's solvers and SUNDIALS's with events, GSL's stiff solvers on smoothed
 * friction, Moreau's time stepping. Each is two methods: simulation from rest until the periods repeat, and the root of
 * its period map. */
#include <stdio.h>

#include "compare/workprec/setting.h"
#include "numerics/rivals/rival.h"

static enum scallop_status solve_rival(struct setting *s, struct setting_answer *answer)
{
  const struct scallop_crawler *c = &s->reference->crawler;
  struct scallop_rival_steady r;
  enum scallop_status status = s->kind == METHOD_ROOT
                                   ? scallop_rival_root(s->memory, c, s->tolerance, s->patience, &r)
                                   : scallop_rival_simulate(s->memory, c, 0, s->tolerance, s->patience, &r);
  if (status >= 0)
    *answer = (struct setting_answer){ .value = { [VELOCITY] = r.v_start, [DISPLACEMENT] = r.displacement },
                                       .gait_evaluations = (double)r.evaluations,
                                       .events = (double)r.events,
                                       .root_iterations = (double)r.root_iterations,
                                       .periods = (double)r.periods };
  return status;
}

static void release(void *memory) { scallop_rival_destroy(memory); }

/* How exact a rival is to be: those of its numbers that it takes. */
struct accuracy {
  double delta, tolerance;
  long steps;
};
static const struct accuracy tolerances[] = { { .tolerance = 1e-4 },  { .tolerance = 1e-6 },  { .tolerance = 1e-8 },
                                              { .tolerance = 1e-10 }, { .tolerance = 1e-12 }, { .tolerance = 1e-14 } };
static const struct accuracy smoothed[] = { { 1e-2, 1e-6, 0 }, { 1e-2, 1e-9, 0 }, { 1e-4, 1e-6, 0 },
                                            { 1e-4, 1e-9, 0 }, { 1e-6, 1e-6, 0 }, { 1e-6, 1e-9, 0 } };
static const struct accuracy steps[] = {
  { .steps = 16 }, { .steps = 128 }, { .steps = 1024 }, { .steps = 8192 }, { .steps = 65536 }
};

static struct scallop_rival *make_odeiv(int stepper, const struct accuracy *a)
{
  return scallop_odeiv_rival((enum scallop_odeiv_stepper)stepper, a->tolerance);
}

static struct scallop_rival *make_cvode(int stepper, const struct accuracy *a)
{
  (void)stepper;
  return scallop_cvode_rival(a->tolerance);
}

static struct scallop_rival *make_smoothed(int stepper, const struct accuracy *a)
{
  (void)stepper;
  return scallop_smoothed_rival(a->delta, a->tolerance);
}

static struct scallop_rival *make_moreau(int stepper, const struct accuracy *a)
{
  (void)stepper;
  return scallop_moreau_rival(a->steps);
}

/* count: five tolerances, or six where the order is high enough for the last. quick: the place of the only accuracy of
 * --quick. is_there: whether the program was built with it; NULL: always. */
static const struct rival {
  const char *name;
  struct scallop_rival *(*make)(int stepper, const struct accuracy *accuracy);
  int stepper;
  const struct accuracy *accuracies;
  int count, quick;
  bool (*is_there)(void);
} rivals[] = {
  { "gsl rkf45", make_odeiv, SCALLOP_ODEIV_RKF45, tolerances, 5, 1, NULL },
  { "gsl rk8pd", make_odeiv, SCALLOP_ODEIV_RK8PD, tolerances, 6, 1, NULL },
  { "cvode", make_cvode, 0, tolerances, 5, 1, scallop_has_cvode },
  { "smoothed msbdf", make_smoothed, 0, smoothed, 6, 0, NULL },
  { "moreau", make_moreau, 0, steps, 5, 1, NULL },
};

/* NULL: left out. */
static void describe(char text[SETTING_TEXT], const struct accuracy *a)
{
  if (!a)
    snprintf(text, SETTING_TEXT, "-");
  else if (a->steps > 0)
    snprintf(text, SETTING_TEXT, "%ld steps", a->steps);
  else if (a->delta > 0)
    snprintf(text, SETTING_TEXT, "delta %g, tolerance %g", a->delta, a->tolerance);
  else
    snprintf(text, SETTING_TEXT, "tolerance %g", a->tolerance);
}

/* Steady to the tolerance of the period; time stepping has none, and its steps are of second order at best. The memory
 * of a rival is made beforehand, as its user would. */
static void add(struct settings *settings, const struct reference *reference, const struct rival *rival,
                const struct accuracy *a)
{
  static const enum method_kind kinds[] = { METHOD_SIMULATION, METHOD_ROOT };
  char text[SETTING_TEXT], name[SETTING_TEXT];
  describe(text, a);
  for (int i = 0; i < 2; i++) {
    snprintf(name, sizeof name, "%s, %s", rival->name, kinds[i] == METHOD_ROOT ? "root" : "simulated");
    struct setting *s = settings_add(settings, reference, name, kinds[i], a ? solve_rival : NULL, "%s", text);
    if (!a) {
      snprintf(s->status, sizeof s->status, "left out: built without SUNDIALS");
      continue;
    }
    s->tolerance = a->steps > 0 ? 1 / ((double)a->steps * (double)a->steps) : a->tolerance;
    s->memory = rival->make(rival->stepper, a);
    s->release = release;
  }
}

void rivals_add(struct settings *settings, const struct reference *reference, bool quick)
{
  for (size_t k = 0; k < sizeof rivals / sizeof *rivals; k++) {
    const struct rival *rival = &rivals[k];
    bool missing = rival->is_there && !rival->is_there();
    int first = quick ? rival->quick : 0, end = quick || missing ? first + 1 : rival->count;
    for (int i = first; i < end; i++)
      add(settings, reference, rival, missing ? NULL : &rival->accuracies[i]);
  }
}
