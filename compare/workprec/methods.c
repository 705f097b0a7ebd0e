/* Methods: published and derived series, the limit, the exact and the certified solver, and the integrators of
 * numerics/integrators/integrator.h. */
#include <math.h>
#include <stdlib.h>

#include "compare/formulas/formula_file.h"
#include "compare/workprec/setting.h"
#include "model/exact/scoped.h"

static int place(const struct scallop_formula *f)
{
  return f->quantity == SCALLOP_STEADY_VELOCITY ? VELOCITY : DISPLACEMENT;
}

/* Memory of methods in balls, with their answers */
struct balls {
  struct series_answer series;
  struct ball_answer certified;
  arb_t T, value[COMPARED];
};

#define BALLS_PARTS(of) \
  of(series_answer, &s->series) of(ball_answer, &s->certified) of(arb, s->T) of(arb, s->value[VELOCITY]) \
      of(arb, s->value[DISPLACEMENT])
SCOPED_PARTS(balls, struct balls, BALLS_PARTS)

static void *make_balls(const struct setting *s)
{
  struct balls *b = malloc(sizeof *b);
  (void)s;
  if (b)
    balls_init(b);
  return b;
}

static void release_balls(void *memory)
{
  balls_clear(memory);
  free(memory);
}

/* The paper's formulas */
static enum scallop_status solve_published(struct setting *s, struct setting_answer *answer)
{
  const struct motion m = { OF_STEADY, s->reference->crawler, SCALLOP_EXTENSION, NAN };
  answer->value[place(s->formula)] = published_value(s->formula, &m, NULL);
  return SCALLOP_OK;
}

/* Formulas in place of the paper's wrong ones: texts, evaluated in ball arithmetic */
static enum scallop_status solve_corrected(struct setting *s, struct setting_answer *answer)
{
  const struct scallop_rational_crawler *c = &s->reference->exact;
  struct balls *b = s->memory;
  int q = place(s->formula);
  answer->ball[q] = b->value[q];
  bool done = published_in_balls(b->value[q], s->formula, c, SCALLOP_EXTENSION, NULL, c->T, NULL, 64);
  return done ? SCALLOP_OK : SCALLOP_EDOMAIN;
}

/* Returns the phases in which a body turns for T -> 0; if unknown, both. */
static enum scallop_turns turns_in_limit(const struct reference *reference)
{
  SCOPED(series_answer, limit);
  bool known = scallop_gait_is_rational(reference->exact.gait)
               && answer_in_series(&limit, &reference->exact, OF_STEADY, SCALLOP_EXTENSION, NULL, 1, 64);
  return known ? turns_in_modes(limit.modes) : SCALLOP_TURNS_IN_BOTH;
}

static bool is_compared(const void *context, const struct scallop_formula *f)
{
  (void)context;
  return f->quantity == SCALLOP_STEADY_VELOCITY || f->quantity == SCALLOP_STEADY_DISPLACEMENT;
}

bool methods_have_formulas(const char *formulas)
{
  return formula_file_applies("workprec", formulas, is_compared, NULL, "the steady v_start or displacement");
}

static void add_formulas(struct settings *settings, const struct reference *reference)
{
  enum scallop_turns turns = turns_in_limit(reference);
  const struct scallop_formula *published;
  for (int i = 0; (published = listed_formula(i)); i++)
    if (is_compared(NULL, published)) {
      bool of_user = user_formula(i) != NULL;
      settings_add(settings, reference, of_user ? "user" : "published", METHOD_FORMULA, solve_published, "%s",
                   of_user ? published->name : published->equation)
          ->formula = published;
    }
  for (const struct scallop_formula *f = scallop_corrected; turns != SCALLOP_TURNS_IN_BOTH && f->name; f++)
    if (f->turns == turns) {
      struct setting *s = settings_add(settings, reference, "corrected", METHOD_FORMULA, solve_corrected,
                                       "for %s, from its text", f->equation);
      s->formula = f;
      s->memory = make_balls(s);
      s->release = release_balls;
    }
}

/* Returns a precision with roundings far below the first term left out, about eps^(order/2). */
static slong bits(const struct reference *reference, long order)
{
  double smaller = reference->eps < 1 ? -log2(reference->eps) : 0;
  return 64 + 8 * order + (slong)(smaller * (double)order / 2);
}

static enum scallop_status solve_derived(struct setting *s, struct setting_answer *answer)
{
  struct balls *b = s->memory;
  slong precision = bits(s->reference, s->number);
  if (!answer_in_series(&b->series, &s->reference->exact, OF_STEADY, SCALLOP_EXTENSION, NULL, s->number, precision))
    return b->series.status;
  arb_set_fmpq(b->T, s->reference->exact.T, precision);
  for (int i = 0; i < COMPARED; i++) {
    series_value(b->value[i], b->series.value[compared[i]], b->T, s->number, precision);
    answer->ball[i] = b->value[i];
  }
  return SCALLOP_OK;
}

/* The exact solver itself: filling a struct answer would be timed too. */
static enum scallop_status solve_exact(struct setting *s, struct setting_answer *answer)
{
  struct scallop_steady_result r;
  enum scallop_status status = scallop_steady(&s->reference->crawler, &r);
  if (status < 0)
    return status;
  *answer = (struct setting_answer){ .value = { [VELOCITY] = r.period.v_start, [DISPLACEMENT] = r.period.displacement },
                                     .gait_evaluations = (double)r.work.gait_evaluations,
                                     .events = (double)r.work.events,
                                     .root_iterations = (double)r.work.root_iterations,
                                     .periods = (double)r.work.periods };
  return SCALLOP_OK;
}

static enum scallop_status solve_certified(struct setting *s, struct setting_answer *answer)
{
  struct ball_answer *a = &((struct balls *)s->memory)->certified;
  if (!answer_in_balls(a, &s->reference->exact, OF_STEADY, SCALLOP_EXTENSION, NULL, s->number))
    return a->status;
  for (int i = 0; i < COMPARED; i++)
    answer->ball[i] = a->value[compared[i]];
  return SCALLOP_OK;
}

/* An integrator, simulated from rest until the periods repeat, or the root of its period map, to its own tolerance.
 * Time stepping has none; its tolerance is the square of the step, since its order is at most 2. */
static enum scallop_status solve_integrator(struct setting *s, struct setting_answer *answer)
{
  const struct scallop_crawler *c = &s->reference->crawler;
  const double steps = (double)s->number, tolerance = steps > 0 ? 1 / (steps * steps) : s->tolerance;
  struct scallop_integrator_steady r;
  enum scallop_status status = s->kind == METHOD_ROOT
                                   ? scallop_integrator_root(s->memory, c, tolerance, s->patience, &r)
                                   : scallop_integrator_simulate(s->memory, c, 0, tolerance, s->patience, &r);
  if (status >= 0)
    *answer = (struct setting_answer){ .value = { [VELOCITY] = r.v_start, [DISPLACEMENT] = r.displacement },
                                       .gait_evaluations = (double)r.evaluations,
                                       .events = (double)r.events,
                                       .root_iterations = (double)r.root_iterations,
                                       .periods = (double)r.periods };
  return status;
}

static void *make_rkf45(const struct setting *s) { return scallop_odeiv_integrator(SCALLOP_ODEIV_RKF45, s->tolerance); }
static void *make_rk8pd(const struct setting *s) { return scallop_odeiv_integrator(SCALLOP_ODEIV_RK8PD, s->tolerance); }
static void *make_cvode(const struct setting *s) { return scallop_cvode_integrator(s->tolerance); }
static void *make_smoothed(const struct setting *s) { return scallop_smoothed_integrator(s->delta, s->tolerance); }
static void *make_moreau(const struct setting *s) { return scallop_moreau_integrator(s->number); }

static void release_integrator(void *memory) { scallop_integrator_destroy(memory); }

struct accuracy { /* of a setting; 0: not used by the method */
  long number;    /* of terms, digits or steps */
  double tolerance, delta;
};
static const struct accuracy one[] = { { .number = 1 } };
static const struct accuracy terms[] = { { .number = 4 }, { .number = 8 }, { .number = 16 }, { .number = MAX_TERMS } };
static const struct accuracy digits[] = { { .number = 16 }, { .number = 50 }, { .number = 200 } };
static const struct accuracy tolerances[] = { { 0, 1e-4, 0 },  { 0, 1e-6, 0 },  { 0, 1e-8, 0 },
                                              { 0, 1e-10, 0 }, { 0, 1e-12, 0 }, { 0, 1e-14, 0 } };
static const struct accuracy deltas[] = { { 0, 1e-6, 1e-2 }, { 0, 1e-9, 1e-2 }, { 0, 1e-6, 1e-4 },
                                          { 0, 1e-9, 1e-4 }, { 0, 1e-6, 1e-6 }, { 0, 1e-9, 1e-6 } };
static const struct accuracy steps[] = {
  { .number = 16 }, { .number = 128 }, { .number = 1024 }, { .number = 8192 }, { .number = 65536 }
};

/* Methods, with a setting for each accuracy; an integrator has two, first its simulation, then its root. */
static const struct method {
  const char *name, *text; /* text: a format of the setting, for its number */
  enum method_kind kind;
  setting_solve *solve;
  void *(*make)(const struct setting *setting); /* allocates the memory, or NULL */
  void (*release)(void *memory);
  const struct accuracy *of;
  int count, first, end;      /* accuracies; range of --quick */
  bool (*is_available)(void); /* in this build; NULL: always */
} methods[] = {
  { "limit", "leading terms", METHOD_FORMULA, solve_derived, make_balls, release_balls, one, 1, 0, 1, NULL },
  { "derived series", "terms below T^%ld", METHOD_FORMULA, solve_derived, make_balls, release_balls, terms, 4, 0, 3,
    NULL },
  { "exact", "steady state", METHOD_EXACT, solve_exact, NULL, NULL, one, 1, 0, 1, NULL },
  { "certified", "%ld digits", METHOD_EXACT, solve_certified, make_balls, release_balls, digits, 3, 0, 3, NULL },
  { "gsl rkf45", "", METHOD_ROOT, solve_integrator, make_rkf45, release_integrator, tolerances, 5, 1, 2, NULL },
  { "gsl rk8pd", "", METHOD_ROOT, solve_integrator, make_rk8pd, release_integrator, tolerances, 6, 1, 2, NULL },
  { "cvode", "", METHOD_ROOT, solve_integrator, make_cvode, release_integrator, tolerances, 5, 1, 2,
    scallop_has_cvode },
  { "smoothed msbdf", "", METHOD_ROOT, solve_integrator, make_smoothed, release_integrator, deltas, 6, 0, 1, NULL },
  { "moreau", "%ld steps", METHOD_ROOT, solve_integrator, make_moreau, release_integrator, steps, 5, 1, 2, NULL },
};

/* Adds a setting. a NULL: the method is not available. */
static void add(struct settings *settings, const struct reference *reference, const struct method *m,
                enum method_kind kind, const struct accuracy *a)
{
  const char *suffix = kind == METHOD_ROOT ? ", root" : kind == METHOD_SIMULATION ? ", simulated" : "";
  char name[SETTING_TEXT];
  snprintf(name, sizeof name, "%s%s", m->name, suffix);
  struct setting *s = settings_add(settings, reference, name, kind, a ? m->solve : NULL, "-");
  if (!a) {
    snprintf(s->status, sizeof s->status, "left out: built without SUNDIALS");
    return;
  }
  if (a->delta > 0)
    snprintf(s->text, SETTING_TEXT, "delta %g, tolerance %g", a->delta, a->tolerance);
  else if (a->tolerance > 0)
    snprintf(s->text, SETTING_TEXT, "tolerance %g", a->tolerance);
  else
    snprintf(s->text, SETTING_TEXT, m->text, a->number);
  s->number = a->number;
  s->tolerance = a->tolerance;
  s->delta = a->delta;
  s->memory = m->make ? m->make(s) : NULL;
  s->release = m->release;
}

static void add_method(struct settings *settings, const struct reference *reference, const struct method *m, bool quick)
{
  bool available = !m->is_available || m->is_available();
  int first = quick ? m->first : 0, end = !available ? first + 1 : quick ? m->end : m->count;
  for (int i = first; i < end; i++) {
    const struct accuracy *a = available ? &m->of[i] : NULL;
    if (m->kind == METHOD_ROOT)
      add(settings, reference, m, METHOD_SIMULATION, a);
    add(settings, reference, m, m->kind, a);
  }
}

void methods_add(struct settings *settings, const struct reference *reference, bool quick)
{
  add_formulas(settings, reference);
  for (size_t k = 0; k < sizeof methods / sizeof *methods; k++)
    add_method(settings, reference, &methods[k], quick);
}
