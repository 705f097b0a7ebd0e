/* The ways of this tool and of the paper: formulas, derived series, the exact solver and the certified one. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/derived.h"
#include "asymptotics/evaluate.h"
#include "numerics/certified.h"
#include "compare/workprec/workprec.h"

static int place(const struct scallop_formula *formula)
{
  return formula->quantity == SCALLOP_STEADY_VELOCITY ? WAY_VELOCITY : WAY_DISPLACEMENT;
}

/* ---- the paper's formulas ---- */

static enum scallop_status solve_published(struct way *way, const struct scallop_patience *patience,
                                           struct way_answer *answer)
{
  const struct scallop_formula *formula = way->memory;
  (void)patience;
  *answer = answer_none;
  answer->value[place(formula)] = formula->steady(&way->point->crawler);
  return SCALLOP_OK;
}

static void add_published(struct ways *ways, const struct trial *point)
{
  for (const struct scallop_formula *f = scallop_published; f->name; f++)
    if (f->setting == SCALLOP_STEADY) {
      struct way *way = ways_add(ways, point, "published", WAY_FORMULA, "%s", f->equation);
      way->solve = solve_published;
      way->memory = (void *)f;
    }
}

/* ---- what stands in their place where they are wrong: texts, evaluated in ball arithmetic ---- */

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

static enum scallop_status solve_corrected(struct way *way, const struct scallop_patience *patience,
                                           struct way_answer *answer)
{
  const struct ring ring = { 1, 64 };
  struct corrected *c = way->memory;
  struct scallop_symbols symbols;
  (void)patience;
  scallop_symbols_init(&symbols);
  scallop_symbols_set(&symbols, &way->point->exact, SCALLOP_EXTENSION, NULL, NULL, &ring);
  series_set_rational(&symbols.value[SYMBOL_T], way->point->exact.T);
  bool done = scallop_formula_expand(&c->value, c->formula, &symbols, SCALLOP_EXTENSION, &ring);
  series_coefficient(c->ball, &c->value, 0, ring.precision);
  scallop_symbols_clear(&symbols);
  if (!done)
    return SCALLOP_EDOMAIN;
  *answer = answer_none;
  answer->ball[place(c->formula)] = c->ball;
  return SCALLOP_OK;
}

/* The ending of their names where, for T -> 0, no body turns in a phase; NULL where one does in both. */
static const char *no_turn(const struct trial *point)
{
  struct scallop_steady_expansion expansion;
  const char *ending = NULL;
  scallop_steady_expansion_init(&expansion);
  if (scallop_gait_is_rational(point->exact.gait)
      && scallop_expand_steady(&point->exact, 1, 64, &expansion, NULL) == SCALLOP_OK) {
    const char *bar = strchr(expansion.modes, '|');
    ending = strcmp(bar, "| ++") == 0 ? "_no_turn" : strncmp(expansion.modes, "++ |", 4) == 0 ? "_no_turn_extension" : NULL;
  }
  scallop_steady_expansion_clear(&expansion);
  return ending;
}

static void add_corrected(struct ways *ways, const struct trial *point)
{
  const char *ending = no_turn(point);
  for (const struct scallop_formula *f = scallop_corrected; ending && f->name; f++) {
    const char *there = strstr(f->name, "_no_turn");
    if (f->setting != SCALLOP_STEADY || !there || strcmp(there, ending) != 0)
      continue;
    struct way *way = ways_add(ways, point, "corrected", WAY_FORMULA, "for %s, from its text", f->equation);
    struct corrected *c = calloc(1, sizeof *c);
    way->solve = solve_corrected;
    way->memory = c;
    way->release = release_corrected;
    if (!c)
      continue;
    c->formula = f;
    series_init(&c->value);
    arb_init(c->ball);
  }
}

/* ---- derived series ---- */

struct derived {
  struct scallop_steady_expansion expansion;
  arb_t T, value[WAY_QUANTITIES];
};

static struct derived *derived_make(void)
{
  struct derived *d = malloc(sizeof *d);
  if (!d)
    return NULL;
  scallop_steady_expansion_init(&d->expansion);
  arb_init(d->T);
  for (int i = 0; i < WAY_QUANTITIES; i++)
    arb_init(d->value[i]);
  return d;
}

static void derived_release(void *memory)
{
  struct derived *d = memory;
  scallop_steady_expansion_clear(&d->expansion);
  arb_clear(d->T);
  for (int i = 0; i < WAY_QUANTITIES; i++)
    arb_clear(d->value[i]);
  free(d);
}

/* Bits so that rounding does not show beside the terms from T^order on, which go as eps^(order/2). */
static slong bits(const struct trial *point, long order)
{
  double smaller = point->eps < 1 ? -log2(point->eps) : 0;
  return 64 + 8 * order + (slong)(smaller * (double)order / 2);
}

static enum scallop_status solve_derived(struct way *way, const struct scallop_patience *patience, struct way_answer *answer)
{
  struct derived *d = way->memory;
  const struct scallop_rational_crawler *crawler = &way->point->exact;
  slong precision = bits(way->point, way->number);
  (void)patience;
  enum scallop_status status = scallop_expand_steady(crawler, way->number, precision, &d->expansion, NULL);
  if (status != SCALLOP_OK)
    return status;
  arb_set_fmpq(d->T, crawler->T, precision);
  series_value(d->value[WAY_VELOCITY], &d->expansion.v_start, d->T, way->number, precision);
  series_value(d->value[WAY_DISPLACEMENT], &d->expansion.displacement, d->T, way->number, precision);
  *answer = answer_none;
  for (int i = 0; i < WAY_QUANTITIES; i++)
    answer->ball[i] = d->value[i];
  return SCALLOP_OK;
}

static struct way *add_derived(struct ways *ways, const struct trial *point, long order)
{
  struct way *way = order == 1 ? ways_add(ways, point, "limit", WAY_FORMULA, "leading terms")
                               : ways_add(ways, point, "derived series", WAY_FORMULA, "terms below T^%ld", order);
  way->solve = solve_derived;
  way->number = order;
  way->memory = derived_make();
  way->release = derived_release;
  return way;
}

/* ---- derived series whose coefficients are known beforehand: even powers of T in doubles, v_start's over T ---- */

struct known {
  enum scallop_status status;
  int count[WAY_QUANTITIES];
  double coefficient[WAY_QUANTITIES][WAY_TERMS];
};

static void learn(struct known *known, int which, const struct series *series, slong first, slong order)
{
  arb_t c;
  arb_init(c);
  for (slong power = first; power < order; power += 2) {
    series_coefficient(c, series, power, 64);
    known->coefficient[which][known->count[which]++] = arf_get_d(arb_midref(c), ARF_RND_NEAR);
  }
  arb_clear(c);
}

static struct known *known_make(const struct trial *point, long order)
{
  struct known *known = calloc(1, sizeof *known);
  struct scallop_steady_expansion expansion;
  if (!known)
    return NULL;
  scallop_steady_expansion_init(&expansion);
  known->status = scallop_expand_steady(&point->exact, order, bits(point, order), &expansion, NULL);
  if (known->status == SCALLOP_OK) {
    learn(known, WAY_VELOCITY, &expansion.v_start, -1, order);
    learn(known, WAY_DISPLACEMENT, &expansion.displacement, 0, order);
  }
  scallop_steady_expansion_clear(&expansion);
  return known;
}

static double horner(const double *coefficient, int count, double x)
{
  double sum = 0;
  while (count > 0)
    sum = sum * x + coefficient[--count];
  return sum;
}

static enum scallop_status solve_known(struct way *way, const struct scallop_patience *patience, struct way_answer *answer)
{
  const struct known *known = way->memory;
  double T = way->point->crawler.T;
  (void)patience;
  if (known->status != SCALLOP_OK)
    return known->status;
  *answer = answer_none;
  answer->value[WAY_VELOCITY] = horner(known->coefficient[WAY_VELOCITY], known->count[WAY_VELOCITY], T * T) / T;
  answer->value[WAY_DISPLACEMENT] = horner(known->coefficient[WAY_DISPLACEMENT], known->count[WAY_DISPLACEMENT], T * T);
  return SCALLOP_OK;
}

static void add_known(struct ways *ways, const struct trial *point, long order)
{
  struct way *way = ways_add(ways, point, "derived series, coefficients known", WAY_ASIDE, "terms below T^%ld", order);
  way->solve = solve_known;
  way->memory = known_make(point, order);
  way->release = free;
}

/* ---- the exact solver ---- */

static enum scallop_status solve_exact(struct way *way, const struct scallop_patience *patience, struct way_answer *answer)
{
  struct scallop_steady_result r;
  (void)patience;
  enum scallop_status status = scallop_steady(&way->point->crawler, &r);
  if (status < 0)
    return status;
  *answer = (struct way_answer){ .value = { r.period.v_start, r.period.displacement },
                                 .gait_evaluations = (double)r.work.gait_evaluations,
                                 .events = (double)r.work.events,
                                 .root_iterations = (double)r.work.root_iterations,
                                 .periods = (double)r.work.periods };
  return SCALLOP_OK;
}

static enum scallop_status solve_period(struct way *way, const struct scallop_patience *patience, struct way_answer *answer)
{
  struct scallop_period_result r;
  (void)patience;
  enum scallop_status status = scallop_period(&way->point->crawler, way->point->v_start, &r);
  if (status < 0)
    return status;
  *answer = answer_none;
  answer->value[WAY_VELOCITY] = r.v_end;
  answer->value[WAY_DISPLACEMENT] = r.displacement;
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

static struct batch *batch_make(const struct scallop_crawler *c)
{
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

static enum scallop_status solve_batch(struct way *way, const struct scallop_patience *patience, struct way_answer *answer)
{
  struct batch *b = way->memory;
  const struct scallop_crawlers crawlers = { BATCH, b->m1, b->m2, b->F1, b->F2, b->L, b->T, b->alpha, b->gait };
  const struct scallop_steady_states states = { .v_start = b->v_start,
                                                .displacement = b->displacement,
                                                .status = b->status };
  (void)patience;
  scallop_steady_batch(&crawlers, &states, 1);
  if (b->status[0] < 0)
    return b->status[0];
  *answer = answer_none;
  answer->value[WAY_VELOCITY] = b->v_start[0];
  answer->value[WAY_DISPLACEMENT] = b->displacement[0];
  return SCALLOP_OK;
}

static void add_exact(struct ways *ways, const struct trial *point)
{
  ways_add(ways, point, "exact", WAY_EXACT, "steady state")->solve = solve_exact;
  struct way *way = ways_add(ways, point, "exact, batch", WAY_ASIDE, "each of %d, one thread", BATCH);
  way->solve = solve_batch;
  way->share = 1.0 / BATCH;
  way->memory = batch_make(&point->crawler);
  way->release = free;
  ways_add(ways, point, "exact, one period", WAY_ASIDE, "from the steady velocity")->solve = solve_period;
}

/* ---- the certified solver ---- */

static void release_certified(void *memory)
{
  scallop_certified_steady_clear(memory);
  free(memory);
}

static enum scallop_status solve_certified(struct way *way, const struct scallop_patience *patience,
                                           struct way_answer *answer)
{
  struct scallop_certified_steady *steady = way->memory;
  (void)patience;
  enum scallop_status status = scallop_certified_steady(&way->point->exact, way->number, steady, NULL);
  if (status != SCALLOP_OK)
    return status;
  *answer = answer_none;
  answer->ball[WAY_VELOCITY] = steady->v_start;
  answer->ball[WAY_DISPLACEMENT] = steady->displacement;
  return SCALLOP_OK;
}

static void add_certified(struct ways *ways, const struct trial *point, long digits)
{
  struct way *way = ways_add(ways, point, "certified", WAY_EXACT, "%ld digits", digits);
  way->solve = solve_certified;
  way->number = digits;
  way->memory = malloc(sizeof(struct scallop_certified_steady));
  way->release = release_certified;
  if (way->memory)
    scallop_certified_steady_init(way->memory);
}

void ways_add_ours(struct ways *ways, const struct trial *point, bool quick)
{
  static const long orders[] = { 4, 8, 16, WAY_TERMS }, digits[] = { 16, 50, 200 };
  int settings = quick ? 3 : 4;
  add_published(ways, point);
  add_corrected(ways, point);
  add_derived(ways, point, 1);
  for (int i = 0; i < settings; i++)
    add_derived(ways, point, orders[i]);
  for (int i = 0; i < settings; i++)
    add_known(ways, point, orders[i]);
  add_exact(ways, point);
  for (int i = 0; i < 3; i++)
    add_certified(ways, point, digits[i]);
}
