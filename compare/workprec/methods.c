#include "compare/workprec/methods.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/derived/evaluate.h"

static int place(const struct scallop_formula *formula)
{
  return formula->quantity == SCALLOP_STEADY_VELOCITY ? VELOCITY : DISPLACEMENT;
}

/* The paper's formulas */
static enum scallop_status solve_published(struct setting *s, const struct scallop_patience *patience,
                                           struct setting_answer *answer)
{
  const struct scallop_formula *formula = s->memory;
  (void)patience;
  answer->value[place(formula)] = formula->steady(&s->reference->crawler);
  return SCALLOP_OK;
}

static void add_published(struct settings *settings, const struct reference *reference)
{
  for (const struct scallop_formula *f = scallop_published; f->name; f++)
    if (f->setting == SCALLOP_STEADY)
      settings_add(settings, reference, "published", METHOD_FORMULA, solve_published, "%s", f->equation)->memory = (void *)f;
}

/* What replaces them where they are wrong: texts, evaluated in ball arithmetic */
struct corrected {
  const struct scallop_formula *formula;
  struct series value;
  arb_t ball;
};

static void release_corrected(void *memory)
{
  struct corrected *c = memory;
  series_clear(&c->value);
  arb_clear(c->ball);
  free(c);
}

static enum scallop_status solve_corrected(struct setting *s, const struct scallop_patience *patience,
                                           struct setting_answer *answer)
{
  const struct ring ring = { 1, 64 };
  struct corrected *c = s->memory;
  struct scallop_symbols symbols;
  (void)patience;
  scallop_symbols_init(&symbols);
  scallop_symbols_set(&symbols, &s->reference->exact, SCALLOP_EXTENSION, NULL, NULL, &ring);
  series_set_rational(&symbols.value[SYMBOL_T], s->reference->exact.T);
  bool done = scallop_formula_expand(&c->value, c->formula, &symbols, SCALLOP_EXTENSION, &ring);
  series_coefficient(c->ball, &c->value, 0, ring.precision);
  scallop_symbols_clear(&symbols);
  answer->ball[place(c->formula)] = c->ball;
  return done ? SCALLOP_OK : SCALLOP_EDOMAIN;
}

/* How the names of the formulas end that hold where, for T -> 0, no body turns in a phase; NULL where one does in both. */
static const char *no_turn(const struct reference *reference)
{
  struct series_answer limit;
  const char *ending = NULL;
  series_answer_init(&limit);
  if (scallop_gait_is_rational(reference->exact.gait)
      && answer_in_series(&limit, &reference->exact, OF_STEADY, SCALLOP_EXTENSION, NULL, 1, 64)) {
    if (strcmp(strchr(limit.modes, '|'), "| ++") == 0)
      ending = "_no_turn";
    else if (strncmp(limit.modes, "++ |", 4) == 0)
      ending = "_no_turn_extension";
  }
  series_answer_clear(&limit);
  return ending;
}

static void add_corrected(struct settings *settings, const struct reference *reference)
{
  const char *ending = no_turn(reference);
  for (const struct scallop_formula *f = scallop_corrected; ending && f->name; f++) {
    const char *there = strstr(f->name, "_no_turn");
    if (f->setting != SCALLOP_STEADY || !there || strcmp(there, ending) != 0)
      continue;
    struct setting *s = settings_add(settings, reference, "corrected", METHOD_FORMULA, solve_corrected,
                                     "for %s, from its text", f->equation);
    struct corrected *c = calloc(1, sizeof *c);
    s->memory = c;
    s->release = release_corrected;
    if (!c)
      continue;
    c->formula = f;
    series_init(&c->value);
    arb_init(c->ball);
  }
}

/* Bits so that rounding does not show beside the terms from T^order on, which go as eps^(order/2). */
static slong bits(const struct reference *reference, long order)
{
  double smaller = reference->eps < 1 ? -log2(reference->eps) : 0;
  return 64 + 8 * order + (slong)(smaller * (double)order / 2);
}

static bool derive(struct series_answer *series, const struct reference *reference, long order)
{
  return answer_in_series(series, &reference->exact, OF_STEADY, SCALLOP_EXTENSION, NULL, order, bits(reference, order));
}

struct derived {
  struct series_answer series;
  arb_t T, value[COMPARED];
};

static void *make_derived(const struct setting *s)
{
  struct derived *d = malloc(sizeof *d);
  (void)s;
  if (!d)
    return NULL;
  series_answer_init(&d->series);
  arb_init(d->T);
  for (int i = 0; i < COMPARED; i++)
    arb_init(d->value[i]);
  return d;
}

static void release_derived(void *memory)
{
  struct derived *d = memory;
  series_answer_clear(&d->series);
  arb_clear(d->T);
  for (int i = 0; i < COMPARED; i++)
    arb_clear(d->value[i]);
  free(d);
}

static enum scallop_status solve_derived(struct setting *s, const struct scallop_patience *patience,
                                         struct setting_answer *answer)
{
  struct derived *d = s->memory;
  slong precision = bits(s->reference, s->number);
  (void)patience;
  if (!derive(&d->series, s->reference, s->number))
    return d->series.status;
  arb_set_fmpq(d->T, s->reference->exact.T, precision);
  for (int i = 0; i < COMPARED; i++) {
    series_value(d->value[i], d->series.value[compared[i]], d->T, s->number, precision);
    answer->ball[i] = d->value[i];
  }
  return SCALLOP_OK;
}

/* Derived series whose coefficients are given: v_start times T and the displacement, in even powers of T, in doubles */
struct coefficients {
  enum scallop_status status;
  int count[COMPARED];
  double of[COMPARED][MOST_TERMS];
};

static void *make_coefficients(const struct setting *s)
{
  static const slong first[COMPARED] = { [VELOCITY] = -1, [DISPLACEMENT] = 0 };
  struct coefficients *known = calloc(1, sizeof *known);
  struct series_answer series;
  arb_t c;
  if (!known)
    return NULL;
  arb_init(c);
  series_answer_init(&series);
  if (derive(&series, s->reference, s->number))
    for (int i = 0; i < COMPARED; i++)
      for (slong power = first[i]; power < s->number; power += 2) {
        series_coefficient(c, series.value[compared[i]], power, 64);
        known->of[i][known->count[i]++] = arf_get_d(arb_midref(c), ARF_RND_NEAR);
      }
  known->status = series.status;
  series_answer_clear(&series);
  arb_clear(c);
  return known;
}

static double horner(const double *coefficient, int count, double x)
{
  double sum = 0;
  while (count > 0)
    sum = sum * x + coefficient[--count];
  return sum;
}

static enum scallop_status solve_coefficients(struct setting *s, const struct scallop_patience *patience,
                                              struct setting_answer *answer)
{
  const struct coefficients *known = s->memory;
  double T = s->reference->crawler.T;
  (void)patience;
  if (known->status != SCALLOP_OK)
    return known->status;
  answer->value[VELOCITY] = horner(known->of[VELOCITY], known->count[VELOCITY], T * T) / T;
  answer->value[DISPLACEMENT] = horner(known->of[DISPLACEMENT], known->count[DISPLACEMENT], T * T);
  return SCALLOP_OK;
}

/* The exact solver itself: an answer (answers/answer.h) would take as long to fill as a steady state takes to be solved. */
static enum scallop_status solve_exact(struct setting *s, const struct scallop_patience *patience,
                                       struct setting_answer *answer)
{
  struct scallop_steady_result r;
  (void)patience;
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

static enum scallop_status solve_period(struct setting *s, const struct scallop_patience *patience,
                                        struct setting_answer *answer)
{
  struct scallop_period_result r;
  (void)patience;
  enum scallop_status status = scallop_period(&s->reference->crawler, s->reference->v_start, &r);
  if (status < 0)
    return status;
  answer->value[VELOCITY] = r.v_end;
  answer->value[DISPLACEMENT] = r.displacement;
  answer->periods = 1;
  return SCALLOP_OK;
}

/* A batch: the crawler, and others whose first mass differs by up to a thousandth, so that no two are the same. */
enum { BATCH = 1024 };

struct batch {
  double m1[BATCH], m2[BATCH], F1[BATCH], F2[BATCH], L[BATCH], T[BATCH], alpha[BATCH];
  const struct scallop_gait *gait[BATCH];
  double v_start[BATCH], displacement[BATCH];
  enum scallop_status status[BATCH];
};

static void *make_batch(const struct setting *s)
{
  const struct scallop_crawler *c = &s->reference->crawler;
  struct batch *b = malloc(sizeof *b);
  for (int i = 0; b && i < BATCH; i++) {
    b->m1[i] = c->m1 * (1 + 1e-3 * i / BATCH);
    b->m2[i] = c->m2;
    b->F1[i] = c->F1;
    b->F2[i] = c->F2;
    b->L[i] = c->L;
    b->T[i] = c->T;
    b->alpha[i] = c->alpha;
    b->gait[i] = c->gait;
  }
  return b;
}

static enum scallop_status solve_batch(struct setting *s, const struct scallop_patience *patience,
                                       struct setting_answer *answer)
{
  struct batch *b = s->memory;
  const struct scallop_crawlers crawlers = { BATCH, b->m1, b->m2, b->F1, b->F2, b->L, b->T, b->alpha, b->gait };
  const struct scallop_steady_states states = { .v_start = b->v_start,
                                                .displacement = b->displacement,
                                                .status = b->status };
  (void)patience;
  scallop_steady_batch(&crawlers, &states, 1);
  if (b->status[0] < 0)
    return b->status[0];
  answer->value[VELOCITY] = b->v_start[0];
  answer->value[DISPLACEMENT] = b->displacement[0];
  return SCALLOP_OK;
}

static void *make_certified(const struct setting *s)
{
  struct ball_answer *a = malloc(sizeof *a);
  (void)s;
  if (a)
    ball_answer_init(a);
  return a;
}

static void release_certified(void *memory)
{
  ball_answer_clear(memory);
  free(memory);
}

static enum scallop_status solve_certified(struct setting *s, const struct scallop_patience *patience,
                                           struct setting_answer *answer)
{
  struct ball_answer *a = s->memory;
  (void)patience;
  if (!answer_in_balls(a, &s->reference->exact, OF_STEADY, SCALLOP_EXTENSION, NULL, s->number))
    return a->status;
  for (int i = 0; i < COMPARED; i++)
    answer->ball[i] = a->value[compared[i]];
  return SCALLOP_OK;
}

enum { MOST_NUMBERS = 4, QUICK_NUMBERS = 3 };

struct solver {
  setting_solve *solve;
  void *(*make)(const struct setting *setting); /* the memory, or NULL */
  void (*release)(void *memory);
};
static const struct solver derived = { solve_derived, make_derived, release_derived };
static const struct solver coefficients = { solve_coefficients, make_coefficients, free };
static const struct solver exact = { solve_exact, NULL, NULL };
static const struct solver batch = { solve_batch, make_batch, free };
static const struct solver one_period = { solve_period, NULL, NULL };
static const struct solver certified = { solve_certified, make_certified, release_certified };

/* A setting for each number, of terms, digits or crawlers. */
static const struct method {
  const char *name;
  enum method_kind kind;
  const struct solver *solver;
  long numbers[MOST_NUMBERS]; /* 0: no more */
  const char *before, *after; /* the number in the setting's text; after NULL: the text does not print it */
} methods[] = {
  { "limit", METHOD_FORMULA, &derived, { 1 }, "leading terms", NULL },
  { "derived series", METHOD_FORMULA, &derived, { 4, 8, 16, MOST_TERMS }, "terms below T^", "" },
  { "derived series, coefficients known", METHOD_OTHER, &coefficients, { 4, 8, 16, MOST_TERMS }, "terms below T^", "" },
  { "exact", METHOD_EXACT, &exact, { 1 }, "steady state", NULL },
  { "exact, batch", METHOD_OTHER, &batch, { BATCH }, "each of ", ", one thread" },
  { "exact, one period", METHOD_OTHER, &one_period, { 1 }, "from the steady velocity", NULL },
  { "certified", METHOD_EXACT, &certified, { 16, 50, 200 }, "", " digits" },
};

static void add(struct settings *settings, const struct reference *reference, const struct method *m, long number)
{
  setting_solve *solve = m->solver->solve;
  struct setting *s = m->after ? settings_add(settings, reference, m->name, m->kind, solve, "%s%ld%s", m->before, number,
                                              m->after)
                               : settings_add(settings, reference, m->name, m->kind, solve, "%s", m->before);
  s->number = number;
  s->share = m->solver == &batch ? 1.0 / BATCH : 1;
  s->release = m->solver->release;
  if (m->solver->make)
    s->memory = m->solver->make(s);
}

void methods_add(struct settings *settings, const struct reference *reference, bool quick)
{
  add_published(settings, reference);
  add_corrected(settings, reference);
  for (size_t k = 0; k < sizeof methods / sizeof *methods; k++)
    for (int i = 0; i < (quick ? QUICK_NUMBERS : MOST_NUMBERS) && methods[k].numbers[i] > 0; i++)
      add(settings, reference, &methods[k], methods[k].numbers[i]);
}
