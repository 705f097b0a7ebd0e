/* Cases of `stress`: families of crawlers, phases and trajectories that may lose digits. */
#include "compare/stress/stress.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include <gsl/gsl_qrng.h>
#include <gsl/gsl_rng.h>

#include "compare/text/digits.h"

enum { DIMENSIONS = 10 };

enum { NOTHING, SHORT_PHASE, UNEQUAL_PHASES, ANY_PHASES, SHORT_PERIOD, ANY_PERIOD }; /* change   */
enum { FROM_REST, ORDINARY, MOVING, ANYWHERE, WILD, STEADY };                        /* start    */
enum { NO_BOUNDARY, START_VELOCITY, STICKING, OTHER_MODES };                         /* boundary */

static double decades(double x, double lo, double hi) { return pow(10, lo + (hi - lo) * x); }
static double between(double x, double lo, double hi) { return lo + (hi - lo) * x; }

/* Returns 0 for a tenth of all x, else a number of either sign, from 1e-15 to 0.1 in size. */
static double small_number(double x)
{
  double sign = x < 0.55 ? -1 : 1, y = x < 0.55 ? (x - 0.1) / 0.45 : (x - 0.55) / 0.45;
  return x < 0.1 ? 0 : sign * decades(y, -15, -1);
}

/* Returns T with T^2 (F1 + F2)/(M L) = eps, from single square roots, as products may overflow. */
static double period_for(const struct scallop_crawler *c, double eps)
{
  return sqrt(eps) * sqrt(c->m1 + c->m2) * sqrt(c->L) / sqrt(c->F1 + c->F2);
}

/* Scales each of m1, m2, F1, F2 and L by 10^-size to 10^size; each x scales `each` of them. */
static void scale(struct scallop_crawler *c, const double *x, int each, double size)
{
  for (int i = 0; i < 5; i++)
    *crawler_field(c, i) *= decades(x[i / each], -size, size);
}

/* Moves the ratio of two parameters by up to 12 decades either way. */
static void spread(double *a, double *b, double x)
{
  double half = decades(x, -6, 6);
  *a *= half;
  *b /= half;
}

static double phase_velocity(const struct motion *m)
{
  return m->crawler.L / scallop_phase_duration(&m->crawler, m->phase);
}

static void change(struct scallop_crawler *c, const double *x, int what)
{
  switch (what) {
  case NOTHING: break;
  case SHORT_PHASE: c->alpha = x[7] < 0.5 ? decades(x[8], -18, -9) : 1 - decades(x[8], -15, -9); break;
  case UNEQUAL_PHASES: c->alpha = x[8] < 0.5 ? decades(x[5], -4, -0.3) : 1 - decades(x[5], -4, -0.3); break;
  case ANY_PHASES:
    c->alpha = x[7] < 0.3   ? decades(x[5], -12, -0.3)
               : x[7] < 0.6 ? 1 - decades(x[5], -12, -0.3)
                            : between(x[5], 0.01, 0.99);
    break;
  case SHORT_PERIOD: c->T = decades(x[6], -100, log10(period_for(c, 4 * fmin(c->alpha, 1 - c->alpha)))); break;
  case ANY_PERIOD: /* nearly all over- or underflow somewhere, and must be refused or right */
    c->T = period_for(c, x[6] < 0.5 ? decades(2 * x[6], -300, 300) : decades(2 * x[6] - 1, -6, 2.5));
    break;
  }
}

/* Sets the phase and v0; a trajectory starts from the steady velocity, or 1 % off if l' consists of ramps. */
static void start(struct motion *m, const double *x, int how)
{
  struct scallop_steady_result r = { .froude = NAN };
  bool is_off = m->crawler.gait->phase[0].ramps && x[7] < 0.5;
  double half = how == ANYWHERE || how == WILD ? 2 * fmod(x[7], 0.5) : x[7];
  m->phase = half < 0.5 ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
  switch (how) {
  case FROM_REST: break;
  case ORDINARY: m->v0 = x[8] < 0.2 ? 0 : between(x[8], -3, 3) * phase_velocity(m); break;
  case MOVING: m->v0 = (x[8] < 0.5 ? -1 : 1) * decades(x[9], -100, 100); break;
  case ANYWHERE: m->v0 = x[8] < 0.2 ? 0 : (x[8] < 0.6 ? -1 : 1) * decades(x[9], -300, 300); break;
  case WILD: m->v0 = x[8] < 0.2 ? 0 : (x[8] < 0.6 ? -1 : 1) * decades(x[9], -6, 1) * phase_velocity(m); break;
  case STEADY: m->v0 = scallop_steady(&m->crawler, &r) == SCALLOP_OK ? r.period.v_start * (is_off ? 1.01 : 1) : NAN;
  }
}

const struct stress_family stress_families[] = {
  { "ordinary", "ratios up to 100, T^2 (F1 + F2)/(M L) from 1e-6 to 300", .scale = 0 },
  { "masses", "m1/m2 from 1e-12 to 1e12", .masses = 7, .eps = { -6, 6 } },
  { "forces", "F1/F2 from 1e-12 to 1e12", .forces = 7, .eps = { -6, 6 } },
  { "masses-and-forces", "both, T^2 (F1 + F2)/(M L) from 1e-12 to 1e12", .masses = 7, .forces = 8, .eps = { -12, 12 } },
  { "equal-forces", "F1/F2 - 1 down to 1e-15, and 0", .equal_forces = 7 },
  { "equal-phases", "2 alpha - 1 down to 1e-15, and 0", .equal_phases = 7 },
  { "equal-both", "both", .equal_forces = 7, .equal_phases = 8 },
  { "short-phase", "alpha within 1e-9 of 0 or 1", .eps = { -6, 20 }, .change = SHORT_PHASE },
  { "small-period", "T from 1e-100 to the onset of sticking", .change = SHORT_PERIOD, .regime = "sliding" },
  { "near-start-velocity-zero", "1e-3 to 1e-14 from where v_start changes its sign", .eps = { -1.5, 2.5 },
    .boundary = START_VELOCITY },
  { "near-sticking", "1e-3 to 1e-14 from where another body begins or ceases to stick", .eps = { -1.5, 2.5 },
    .boundary = STICKING },
  { "near-grazing", "1e-3 to 1e-14 from any other boundary between sequences of modes", .eps = { -1.5, 2.5 },
    .boundary = OTHER_MODES },
  { "deep-stick-slip", "a body is stuck for a while, T^2 (F1 + F2)/(M L) up to 1e9", .forces = 7, .eps = { 0.5, 9 },
    .change = UNEQUAL_PHASES, .regime = "stick-slip" },
  { "at-rest", "one body never moves", .eps = { 0.5, 30 }, .regime = "at-rest" },
  { "unit-systems", "m, F and L each times 1e-150 to 1e150", .scale = 150, .eps = { -6, 2.5 } },
  { "range", "each times 1e-306 to 1e306: refused where something over- or underflows", .scale = 306,
    .change = ANY_PERIOD },
  { "wild", "every parameter anywhere in 16 decades or more", .sizes = 8, .T = { -12, 12 }, .change = ANY_PHASES },
  { "phase-ordinary", "a phase from rest or up to 3 L/tau", STRESS_PHASE, .start = ORDINARY },
  { "phase-small-period", "the same, T from 1e-100 to 1", STRESS_PHASE, .T = { -100, 0 }, .start = ORDINARY },
  { "phase-velocities", "v0 from 1e-100 to 1e100", STRESS_PHASE, .start = MOVING },
  { "phase-range", "m, F, L, T and v0 anywhere in the range of doubles", STRESS_PHASE, .scale = 306,
    .change = ANY_PERIOD, .start = ANYWHERE },
  { "phase-wild", "every parameter anywhere in 16 decades or more", STRESS_PHASE, .sizes = 8, .T = { -12, 12 },
    .change = ANY_PHASES, .start = WILD },
  { "phase-boundaries", "1e-3 to 1e-14 from a boundary between sequences of modes", STRESS_PHASE,
    .boundary = OTHER_MODES },
  { "high-degree", "every parameter anywhere in 16 decades or more, l as s^15 at first", .sizes = 8, .T = { -12, 12 },
    .change = ANY_PHASES, .gait = "polynomial:0,0,0,0,0,0,0,0,0,0,0,0,0,0,16,-15" },
  { "high-degree-short-phase", "alpha within 1e-9 of 0 or 1, l as s^8 at first", .eps = { -6, 20 },
    .change = SHORT_PHASE, .gait = "polynomial:0,0,0,0,0,0,0,6435,-40040,108108,-163800,150150,-83160,25740,-3432" },
  { "short-ramps", "F1/F2 - 1 and 2 alpha - 1 down to 1e-15, and 0; l' rises and falls within 1e-30 of a phase",
    .equal_forces = 7, .equal_phases = 8, .gait = "constant:1e-30" },
  { "phase-high-degree", "a phase from rest, T from 1e-100 to 1, l as s^7 at first", STRESS_PHASE, .T = { -100, 0 },
    .gait = "polynomial:0,0,0,0,0,0,8,-7" },
  { "trajectory", "x and v at the end of very many periods, from the steady state or 1 % beside it", STRESS_TRAJECTORY,
    .eps = { -6, 0 }, .start = STEADY, .regime = "sliding" },
  { .name = NULL },
};

static bool solve(const struct motion *m, struct answer *a)
{
  bool solved = answer_in_double(a, m) && a->status == SCALLOP_OK;
  if (m->of == OF_PHASE)
    a->value[Q_V_START].high = m->v0;
  return solved;
}

/* Returns true if a boundary of the kind is between a and b. Modes change at boundaries of the first two kinds too. */
static bool lies_between(int kind, const struct answer *a, const struct answer *b)
{
  switch (kind) {
  case START_VELOCITY: return (a->value[Q_V_START].high > 0) != (b->value[Q_V_START].high > 0);
  case STICKING: return a->regime != b->regime;
  default: return !same_modes(a->modes, b->modes);
  }
}

/* Moves one parameter, or the start velocity, towards `other` to the first boundary of the kind that bisection finds,
 * 1e-3 to 1e-14 of its size away, on either side. False: no boundary, or another one in the same place. */
static bool approach(const struct motion *m, double *moved, double other, int kind, double x)
{
  enum { HALVINGS = 200 };
  double here = *moved, there = other;
  struct answer first, second, at;
  bool solved = solve(m, &first);
  *moved = there;
  if (!solved || !solve(m, &second) || !lies_between(kind, &first, &second))
    return false;
  for (int i = 0; i < HALVINGS; i++) {
    *moved = here + (there - here) / 2;
    if (*moved == here || *moved == there)
      break;
    if (!solve(m, &at))
      return false;
    bool beyond = lies_between(kind, &first, &at);
    *(beyond ? &there : &here) = *moved;
    second = beyond ? at : second;
  }
  double side = x < 0.5 ? -1 : 1, away = decades(x < 0.5 ? 2 * x : 2 * x - 1, -14, -3);
  *moved = here * (1 + side * away);
  return kind != OTHER_MODES
         || !(lies_between(START_VELOCITY, &first, &second) || lies_between(STICKING, &first, &second));
}

/* Moves a case near a boundary; a phase from rest by its duration, to the onset of sticking of another body. */
static bool near_boundary(struct motion *m, const double *x, int kind)
{
  struct scallop_crawler *c = &m->crawler;
  double *const moved[] = { &c->T, &c->F1, &c->m2, &c->alpha }, *one = moved[m->of == OF_PHASE ? 0 : (int)(4 * x[7])];
  double other = one == &c->alpha ? between(x[8], 0.02, 0.98) : *one * decades(x[8], -1, 1);
  if (m->of == OF_PHASE) {
    m->phase = fmod(x[7], 0.5) < 0.25 ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
    m->v0 = x[7] < 0.25 ? 0 : between(x[8], -2, 2) * phase_velocity(m);
    kind = x[7] < 0.5 ? STICKING : kind;
  }
  if (m->v0 != 0) {
    one = &m->v0;
    other = m->v0 + between(fmod(16 * x[8], 1), -1, 1) * phase_velocity(m);
  }
  return approach(m, one, other, kind, x[9]);
}

/* Makes an ordinary case, with ratios up to 100, from deep in the expansion to beyond the onset of sticking, and
 * applies the changes of the family. False: x gives no case. */
static bool make(const struct stress_family *f, struct motion *m, const double *x)
{
  struct scallop_crawler *c = &m->crawler;
  struct scallop_steady_result r;
  scale(c, x, 1, f->sizes > 0 ? f->sizes : 1);
  c->alpha = between(x[5], 0.02, 0.98);
  c->T = period_for(c, decades(x[6], -6, 2.5));
  if (f->masses > 0)
    spread(&c->m1, &c->m2, x[f->masses]);
  if (f->forces > 0)
    spread(&c->F1, &c->F2, x[f->forces]);
  if (f->equal_forces > 0)
    c->F1 = c->F2 * (1 + small_number(x[f->equal_forces]));
  if (f->equal_phases > 0)
    c->alpha = 0.5 + 0.5 * small_number(x[f->equal_phases]);
  if (f->scale > 0)
    scale(c, x + 7, 2, f->scale);
  if (f->eps[0] < f->eps[1])
    c->T = period_for(c, decades(x[6], f->eps[0], f->eps[1]));
  if (f->T[0] < f->T[1])
    c->T = decades(x[6], f->T[0], f->T[1]);
  change(c, x, f->change);
  start(m, x, f->start);
  if (f->regime
      && (scallop_steady(c, &r) != SCALLOP_OK || strcmp(scallop_regime_text(r.period.regime), f->regime) != 0))
    return false;
  return (f->boundary == NO_BOUNDARY || near_boundary(m, x, f->boundary))
         && scallop_crawler_check(c, NULL) == SCALLOP_OK;
}

/* Shifts the whole sequence, differently for each seed, family and gait (Cranley & Patterson 1976). */
int stress_make(const struct stress_family *family, const struct scallop_gait *gait, unsigned long seed, int count,
                struct stress_case *cases)
{
  enum { TRIES = 300 }; /* for each case, on average */
  const struct scallop_crawler ones = { 1, 1, 1, 1, 1, 1, 1, gait };
  const struct stress_case first = { .motion = { .of = family->kind == STRESS_STEADY ? OF_STEADY : OF_PHASE,
                                                 .crawler = ones },
                                     .periods = family->kind == STRESS_TRAJECTORY };
  const char *const names[] = { family->name, gait->name };
  double x[DIMENSIONS], shift[DIMENSIONS];
  gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
  gsl_qrng *sequence = gsl_qrng_alloc(gsl_qrng_sobol, DIMENSIONS);
  int made = 0;
  for (int i = 0; i < 2; i++)
    for (const char *c = names[i]; *c; c++)
      seed = (seed * 31 + (unsigned char)*c) & 0xffffffff;
  if (random)
    gsl_rng_set(random, seed);
  for (int i = 0; i < DIMENSIONS && random; i++)
    shift[i] = gsl_rng_uniform(random);
  for (long tries = 0; random && sequence && made < count && tries < (long)count * TRIES; tries++) {
    gsl_qrng_get(sequence, x);
    for (int i = 0; i < DIMENSIONS; i++)
      x[i] = fmod(x[i] + shift[i], 1);
    cases[made] = first;
    made += make(family, &cases[made].motion, x);
  }
  gsl_rng_free(random);
  gsl_qrng_free(sequence);
  return made;
}

void stress_arguments(const struct stress_case *s, char *text)
{
  const struct motion *m = &s->motion;
  char number[NUMBER_TEXT];
  for (int i = 0; i < CRAWLER_NUMBERS; i++) {
    number_text(number, crawler_number(&m->crawler, i), 0);
    text += snprintf(text, 64, "--%s %s ", crawler_parameters[i], number);
  }
  text += snprintf(text, GAIT_TEXT, "--gait %s", m->crawler.gait->name);
  number_text(number, m->v0, 0);
  if (s->periods > 0)
    snprintf(text, 120, " --start %s --periods %ld", number, s->periods);
  else if (m->of == OF_PHASE)
    snprintf(text, 120, " --phase %s --v0 %s", m->phase == SCALLOP_EXTENSION ? "extension" : "contraction", number);
}
