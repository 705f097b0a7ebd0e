/* The methods of the paper and of this tool: published and derived series, the limit, the exact and the certified
 * solver. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/book/book.h"
#include "compare/workprec/setting.h"

static int place(const struct scallop_formula *formula)
{
  return formula->quantity == SCALLOP_STEADY_VELOCITY ? VELOCITY : DISPLACEMENT;
}

/* What methods in balls work with, and their answers, which live as long as the setting */
struct balls {
  struct series_answer series;
  struct ball_answer certified;
  arb_t T, value[COMPARED];
};

static void *make_balls(const struct setting *s)
{
  struct balls *b = malloc(sizeof *b);
  (void)s;
  if (!b)
    return NULL;
  series_answer_init(&b->series);
  ball_answer_init(&b->certified);
  arb_init(b->T);
  for (int i = 0; i < COMPARED; i++)
    arb_init(b->value[i]);
  return b;
}

static void release_balls(void *memory)
{
  struct balls *b = memory;
  series_answer_clear(&b->series);
  ball_answer_clear(&b->certified);
  arb_clear(b->T);
  for (int i = 0; i < COMPARED; i++)
    arb_clear(b->value[i]);
  free(b);
}

/* The paper's formulas */
static enum scallop_status solve_published(struct setting *s, struct setting_answer *answer)
{
  const struct motion m = { OF_STEADY, s->reference->crawler, SCALLOP_EXTENSION, NAN };
  answer->value[place(s->formula)] = published_value(s->formula, &m, NULL);
  return SCALLOP_OK;
}

/* What replaces them where they are wrong: texts, evaluated in ball arithmetic */
static enum scallop_status solve_corrected(struct setting *s, struct setting_answer *answer)
{
  const struct scallop_rational_crawler *c = &s->reference->exact;
  struct balls *b = s->memory;
  int q = place(s->formula);
  answer->ball[q] = b->value[q];
  bool done = published_in_balls(b->value[q], s->formula, c, SCALLOP_EXTENSION, NULL, c->T, NULL, 64);
  return done ? SCALLOP_OK : SCALLOP_EDOMAIN;
}

/* Does a body turn in both phases for T -> 0? Where that is not known it is said to. */
static enum scallop_turns turns_in_limit(const struct reference *reference)
{
  struct series_answer limit;
  enum scallop_turns turns = SCALLOP_TURNS_IN_BOTH;
  series_answer_init(&limit);
  if (scallop_gait_is_rational(reference->exact.gait)
      && answer_in_series(&limit, &reference->exact, OF_STEADY, SCALLOP_EXTENSION, NULL, 1, 64))
    turns = turns_in_modes(limit.modes);
  series_answer_clear(&limit);
  return turns;
}

static bool is_compared(const void *context, const struct scallop_formula *f)
{
  (void)context;
  return f->quantity == SCALLOP_STEADY_VELOCITY || f->quantity == SCALLOP_STEADY_DISPLACEMENT;
}

bool methods_serve(const char *book)
{
  return book_serves("workprec", book, is_compared, NULL, "the steady v_start or displacement");
}

static void add_formulas(struct settings *settings, const struct reference *reference)
{
  enum scallop_turns turns = turns_in_limit(reference);
  const struct scallop_formula *published;
  for (int i = 0; (published = listed_formula(i)); i++)
    if (is_compared(NULL, published)) {
      bool of_book = book_formula(i) != NULL;
      settings_add(settings, reference, of_book ? "book" : "published", METHOD_FORMULA, solve_published, "%s",
                   of_book ? published->name : published->equation)
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

static enum scallop_status solve_derived(struct setting *s, struct setting_answer *answer)
{
  struct balls *b = s->memory;
  slong precision = bits(s->reference, s->number);
  if (!derive(&b->series, s->reference, s->number))
    return b->series.status;
  arb_set_fmpq(b->T, s->reference->exact.T, precision);
  for (int i = 0; i < COMPARED; i++) {
    series_value(b->value[i], b->series.value[compared[i]], b->T, s->number, precision);
    answer->ball[i] = b->value[i];
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

static enum scallop_status solve_coefficients(struct setting *s, struct setting_answer *answer)
{
  const struct coefficients *known = s->memory;
  double T = s->reference->crawler.T;
  if (known->status != SCALLOP_OK)
    return known->status;
  answer->value[VELOCITY] = horner(known->of[VELOCITY], known->count[VELOCITY], T * T) / T;
  answer->value[DISPLACEMENT] = horner(known->of[DISPLACEMENT], known->count[DISPLACEMENT], T * T);
  return SCALLOP_OK;
}

/* The exact solver itself, without the answer (answers/answer.h) around it, whose filling would be timed too. */
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

static enum scallop_status solve_period(struct setting *s, struct setting_answer *answer)
{
  struct scallop_period_result r;
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

static enum scallop_status solve_batch(struct setting *s, struct setting_answer *answer)
{
  struct batch *b = s->memory;
  const struct scallop_crawlers crawlers = { BATCH, b->m1, b->m2, b->F1, b->F2, b->L, b->T, b->alpha, b->gait };
  const struct scallop_steady_states states = { .v_start = b->v_start,
                                                .displacement = b->displacement,
                                                .status = b->status };
  scallop_steady_batch(&crawlers, &states, 1);
  if (b->status[0] < 0)
    return b->status[0];
  answer->value[VELOCITY] = b->v_start[0];
  answer->value[DISPLACEMENT] = b->displacement[0];
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

enum { MOST_NUMBERS = 4, QUICK_NUMBERS = 3 };

/* A setting for each number, of terms, digits or crawlers. */
static const struct method {
  const char *name;
  enum method_kind kind;
  setting_solve *solve;
  void *(*make)(const struct setting *setting); /* the memory, or NULL */
  void (*release)(void *memory);
  long numbers[MOST_NUMBERS]; /* 0: no more */
  const char *text;           /* of the setting; it may print the number */
} methods[] = {
  { "limit", METHOD_FORMULA, solve_derived, make_balls, release_balls, { 1 }, "leading terms" },
  { "derived series",
    METHOD_FORMULA,
    solve_derived,
    make_balls,
    release_balls,
    { 4, 8, 16, MOST_TERMS },
    "terms below T^%ld" },
  { "derived series, coefficients known",
    METHOD_OTHER,
    solve_coefficients,
    make_coefficients,
    free,
    { 4, 8, 16, MOST_TERMS },
    "terms below T^%ld" },
  { "exact", METHOD_EXACT, solve_exact, NULL, NULL, { 1 }, "steady state" },
  { "exact, batch", METHOD_OTHER, solve_batch, make_batch, free, { BATCH }, "each of %ld, one thread" },
  { "exact, one period", METHOD_OTHER, solve_period, NULL, NULL, { 1 }, "from the steady velocity" },
  { "certified", METHOD_EXACT, solve_certified, make_balls, release_balls, { 16, 50, 200 }, "%ld digits" },
};

static void add(struct settings *settings, const struct reference *reference, const struct method *m, long number)
{
  struct setting *s = settings_add(settings, reference, m->name, m->kind, m->solve, m->text, number);
  s->number = number;
  s->share = m->make == make_batch ? 1.0 / BATCH : 1;
  s->memory = m->make ? m->make(s) : NULL;
  s->release = m->release;
}

void methods_add(struct settings *settings, const struct reference *reference, bool quick)
{
  add_formulas(settings, reference);
  for (size_t k = 0; k < sizeof methods / sizeof *methods; k++)
    for (int i = 0; i < (quick ? QUICK_NUMBERS : MOST_NUMBERS) && methods[k].numbers[i] > 0; i++)
      add(settings, reference, &methods[k], methods[k].numbers[i]);
}
