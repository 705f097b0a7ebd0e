#include "compare/stress/families.h"

#include <math.h>
#include <stdio.h>

#include <gsl/gsl_qrng.h>
#include <gsl/gsl_rng.h>

#include "compare/text/table.h"

static double decades(double x, double lo, double hi) { return pow(10, lo + (hi - lo) * x); }
static double between(double x, double lo, double hi) { return lo + (hi - lo) * x; }

/* 0 for a tenth of all x; else of either sign, from 1e-15 to 0.1 in size */
static double small(double x)
{
  double sign = x < 0.55 ? -1 : 1, y = x < 0.55 ? (x - 0.1) / 0.45 : (x - 0.55) / 0.45;
  return x < 0.1 ? 0 : sign * decades(y, -15, -1);
}

/* T for which T^2 (F1 + F2)/(M L) is eps; the square roots one by one, as products may overflow */
static double period_for(const struct scallop_crawler *c, double eps)
{
  return sqrt(eps) * sqrt(c->m1 + c->m2) * sqrt(c->L) / sqrt(c->F1 + c->F2);
}

/* Sets T for an eps of so many decades. */
static void set_eps(struct scallop_crawler *c, double x, double lo, double hi)
{
  c->T = period_for(c, decades(x, lo, hi));
}

/* m1, m2, F1, F2 and L, each from 10^-most to 10^most */
static void set_five(struct scallop_crawler *c, const double *x, double most)
{
  double *const five[] = { &c->m1, &c->m2, &c->F1, &c->F2, &c->L };
  for (int i = 0; i < 5; i++)
    *five[i] = decades(x[i], -most, most);
}

/* What every family begins with, nothing extreme: ratios up to 100, from deep in the expansion to beyond the onset of
 * sticking */
static void calm(struct scallop_crawler *c, const double *x)
{
  set_five(c, x, 1);
  c->alpha = between(x[5], 0.02, 0.98);
  set_eps(c, x[6], -6, 2.5);
}

/* Moves the ratio of two parameters by up to 12 decades either way. */
static void spread(double *a, double *b, double x)
{
  double half = decades(x, -6, 6);
  *a *= half;
  *b /= half;
}

/* Units of any size: the same crawler, far from 1 */
static void scale(struct scallop_crawler *c, const double *x, double most)
{
  double *const five[] = { &c->m1, &c->m2, &c->F1, &c->F2, &c->L };
  for (int i = 0; i < 5; i++)
    *five[i] *= decades(x[7 + i / 2], -most, most);
}

static bool short_phase(struct stress_case *s, const double *x)
{
  s->crawler.alpha = x[7] < 0.5 ? decades(x[8], -18, -9) : 1 - decades(x[8], -15, -9);
  return true;
}

static bool is_in(const struct stress_case *s, enum scallop_regime regime)
{
  struct scallop_steady_result r;
  return scallop_steady(&s->crawler, &r) == SCALLOP_OK && r.period.regime == regime;
}

static bool small_period(struct stress_case *s, const double *x)
{
  double onset = period_for(&s->crawler, 4 * fmin(s->crawler.alpha, 1 - s->crawler.alpha));
  s->crawler.T = decades(x[6], -100, log10(onset));
  return is_in(s, SCALLOP_SLIDING);
}

static bool deep_stick_slip(struct stress_case *s, const double *x)
{
  s->crawler.alpha = x[8] < 0.5 ? decades(x[5], -4, -0.3) : 1 - decades(x[5], -4, -0.3);
  return is_in(s, SCALLOP_STICK_SLIP);
}

static bool at_rest(struct stress_case *s, const double *x)
{
  (void)x;
  return is_in(s, SCALLOP_AT_REST);
}

/* Nearly all of these crawlers over- or underflow somewhere, and must be refused or right. */
static bool any_period(struct stress_case *s, const double *x)
{
  if (x[6] < 0.5)
    set_eps(&s->crawler, 2 * x[6], -300, 300);
  else
    set_eps(&s->crawler, 2 * x[6] - 1, -6, 2.5);
  return true;
}

static bool wild(struct stress_case *s, const double *x)
{
  struct scallop_crawler *c = &s->crawler;
  set_five(c, x, 8);
  c->T = decades(x[6], -12, 12);
  c->alpha = x[7] < 0.3   ? decades(x[5], -12, -0.3)
             : x[7] < 0.6 ? 1 - decades(x[5], -12, -0.3)
                          : between(x[5], 0.01, 0.99);
  return true;
}

/* What differs on the two sides of a boundary */
struct side {
  bool forward; /* the velocity as the motion starts */
  struct answer answer;
};
enum boundary { START_VELOCITY, STICKING, OTHER_MODES };

static bool solve_side(const struct stress_case *s, struct side *side)
{
  const struct motion m = stress_motion(s);
  bool solved = answer_in_double(&side->answer, &m) && side->answer.status == SCALLOP_OK;
  side->forward = (s->kind == STRESS_PHASE ? s->v0 : side->answer.value[Q_V_START].high) > 0;
  return solved;
}

/* Modes differ beyond boundaries of the first two kinds too. */
static bool lies_between(enum boundary kind, const struct side *a, const struct side *b)
{
  switch (kind) {
  case START_VELOCITY: return a->forward != b->forward;
  case STICKING: return a->answer.regime != b->answer.regime;
  default: return !same_modes(a->answer.modes, b->answer.modes);
  }
}

/* One parameter, or the start velocity, is moved from what it is in *s to `other`; at the first boundary of that kind
 * that halving the interval finds it stays, 1e-3 to 1e-14 of its size away, on either side. False: there is none, or
 * another boundary is in the same place. */
static bool approach(struct stress_case *s, double *moved, double other, enum boundary kind, double x)
{
  enum { HALVINGS = 200 };
  double here = *moved, there = other;
  struct side first, second, at;
  if (!solve_side(s, &first))
    return false;
  *moved = there;
  if (!solve_side(s, &second) || !lies_between(kind, &first, &second))
    return false;
  for (int i = 0; i < HALVINGS; i++) {
    *moved = here + (there - here) / 2;
    if (*moved == here || *moved == there)
      break;
    if (!solve_side(s, &at))
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

static bool at_boundary(struct stress_case *s, const double *x, enum boundary kind)
{
  struct scallop_crawler *c = &s->crawler;
  switch ((int)(4 * x[7])) {
  case 0: return approach(s, &c->T, c->T * decades(x[8], -1, 1), kind, x[9]);
  case 1: return approach(s, &c->F1, c->F1 * decades(x[8], -1, 1), kind, x[9]);
  case 2: return approach(s, &c->m2, c->m2 * decades(x[8], -1, 1), kind, x[9]);
  default: return approach(s, &c->alpha, between(x[8], 0.02, 0.98), kind, x[9]);
  }
}

static bool near_start_velocity(struct stress_case *s, const double *x) { return at_boundary(s, x, START_VELOCITY); }
static bool near_sticking(struct stress_case *s, const double *x) { return at_boundary(s, x, STICKING); }
static bool near_grazing(struct stress_case *s, const double *x) { return at_boundary(s, x, OTHER_MODES); }

static double phase_velocity(const struct stress_case *s)
{
  return s->crawler.L / scallop_phase_duration(&s->crawler, s->phase);
}

static void choose_phase(struct stress_case *s, double x)
{
  s->phase = x < 0.5 ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
}

/* From rest, or with velocities up to twice the largest |l'| */
static bool phase_ordinary(struct stress_case *s, const double *x)
{
  choose_phase(s, x[7]);
  s->v0 = x[8] < 0.2 ? 0 : between(x[8], -3, 3) * phase_velocity(s);
  return true;
}

static bool phase_small_period(struct stress_case *s, const double *x)
{
  s->crawler.T = decades(x[6], -100, 0);
  return phase_ordinary(s, x);
}

static bool phase_from_rest(struct stress_case *s, const double *x)
{
  s->crawler.T = decades(x[6], -100, 0);
  choose_phase(s, x[7]);
  return true;
}

/* From rest, or of a size from 10^lo to 10^hi */
static bool start(struct stress_case *s, const double *x, double lo, double hi)
{
  choose_phase(s, 2 * fmod(x[7], 0.5));
  s->v0 = x[8] < 0.2 ? 0 : (x[8] < 0.6 ? -1 : 1) * decades(x[9], lo, hi);
  return true;
}

static bool phase_range(struct stress_case *s, const double *x) { return any_period(s, x) && start(s, x, -300, 300); }

static bool phase_wild(struct stress_case *s, const double *x)
{
  wild(s, x);
  start(s, x, -6, 1);
  s->v0 *= phase_velocity(s);
  return true;
}

static bool phase_velocities(struct stress_case *s, const double *x)
{
  choose_phase(s, x[7]);
  s->v0 = (x[8] < 0.5 ? -1 : 1) * decades(x[9], -100, 100);
  return true;
}

static bool phase_boundaries(struct stress_case *s, const double *x)
{
  choose_phase(s, 2 * fmod(x[7], 0.5));
  s->v0 = x[7] < 0.25 ? 0 : between(x[8], -2, 2) * phase_velocity(s);
  enum boundary kind = x[7] < 0.5 ? STICKING : OTHER_MODES;
  if (s->v0 == 0)
    return approach(s, &s->crawler.T, s->crawler.T * decades(x[8], -1, 1), kind, x[9]);
  return approach(s, &s->v0, s->v0 + between(fmod(16 * x[8], 1), -1, 1) * phase_velocity(s), kind, x[9]);
}

/* Sliding, from the steady state as a double or, where l' is made of ramps, from 1 % beside it. */
static bool trajectory(struct stress_case *s, const double *x)
{
  struct scallop_steady_result r;
  if (scallop_steady(&s->crawler, &r) != SCALLOP_OK || r.period.regime != SCALLOP_SLIDING)
    return false;
  bool beside = s->crawler.gait->phase[0].ramps && x[7] < 0.5;
  s->v0 = r.period.v_start * (beside ? 1.01 : 1);
  return true;
}

const struct stress_family stress_families[] = {
  { "ordinary", "ratios up to 100, T^2 (F1 + F2)/(M L) from 1e-6 to 300", .make = NULL },
  { "masses", "m1/m2 from 1e-12 to 1e12", STRESS_STEADY, .masses = 7, .eps = { -6, 6 } },
  { "forces", "F1/F2 from 1e-12 to 1e12", STRESS_STEADY, .forces = 7, .eps = { -6, 6 } },
  { "masses-and-forces", "both, T^2 (F1 + F2)/(M L) from 1e-12 to 1e12", STRESS_STEADY, .masses = 7, .forces = 8,
    .eps = { -12, 12 } },
  { "equal-forces", "F1/F2 - 1 down to 1e-15, and 0", STRESS_STEADY, .equal_forces = 7 },
  { "equal-phases", "2 alpha - 1 down to 1e-15, and 0", STRESS_STEADY, .equal_phases = 7 },
  { "equal-both", "both", STRESS_STEADY, .equal_forces = 7, .equal_phases = 8 },
  { "short-phase", "alpha within 1e-9 of 0 or 1", STRESS_STEADY, .eps = { -6, 20 }, .make = short_phase },
  { "small-period", "T from 1e-100 to the onset of sticking", STRESS_STEADY, .make = small_period },
  { "near-start-velocity-zero", "1e-3 to 1e-14 from where v_start changes its sign", STRESS_STEADY,
    .eps = { -1.5, 2.5 }, .make = near_start_velocity },
  { "near-sticking", "1e-3 to 1e-14 from where another body begins or ceases to stick", STRESS_STEADY,
    .eps = { -1.5, 2.5 }, .make = near_sticking },
  { "near-grazing", "1e-3 to 1e-14 from any other boundary between sequences of modes", STRESS_STEADY,
    .eps = { -1.5, 2.5 }, .make = near_grazing },
  { "deep-stick-slip", "a body is stuck for a while, T^2 (F1 + F2)/(M L) up to 1e9", STRESS_STEADY, .forces = 7,
    .eps = { 0.5, 9 }, .make = deep_stick_slip },
  { "at-rest", "one body never moves", STRESS_STEADY, .eps = { 0.5, 30 }, .make = at_rest },
  { "units", "m, F and L each times 1e-150 to 1e150", STRESS_STEADY, .scale = 150, .eps = { -6, 2.5 } },
  { "range", "each times 1e-306 to 1e306: refused where something over- or underflows", STRESS_STEADY, .scale = 306,
    .make = any_period },
  { "wild", "every parameter anywhere in 16 decades or more", STRESS_STEADY, .make = wild },
  { "phase-ordinary", "a phase from rest or up to 3 L/tau", STRESS_PHASE, .make = phase_ordinary },
  { "phase-small-period", "the same, T from 1e-100 to 1", STRESS_PHASE, .make = phase_small_period },
  { "phase-velocities", "v0 from 1e-100 to 1e100", STRESS_PHASE, .make = phase_velocities },
  { "phase-range", "m, F, L, T and v0 anywhere in the range of doubles", STRESS_PHASE, .scale = 306,
    .make = phase_range },
  { "phase-wild", "every parameter anywhere in 16 decades or more", STRESS_PHASE, .make = phase_wild },
  { "phase-boundaries", "1e-3 to 1e-14 from a boundary between sequences of modes", STRESS_PHASE,
    .make = phase_boundaries },
  { "high-degree", "every parameter anywhere in 16 decades or more, l as s^15 at first", STRESS_STEADY,
    .gait = "polynomial:0,0,0,0,0,0,0,0,0,0,0,0,0,0,16,-15", .make = wild },
  { "high-degree-short-phase", "alpha within 1e-9 of 0 or 1, l as s^8 at first", STRESS_STEADY, .eps = { -6, 20 },
    .gait = "polynomial:0,0,0,0,0,0,0,6435,-40040,108108,-163800,150150,-83160,25740,-3432", .make = short_phase },
  { "short-ramps", "F1/F2 - 1 and 2 alpha - 1 down to 1e-15, and 0; l' rises and falls within 1e-30 of a phase",
    STRESS_STEADY, .equal_forces = 7, .equal_phases = 8, .gait = "constant:1e-30" },
  { "phase-high-degree", "a phase from rest, T from 1e-100 to 1, l as s^7 at first", STRESS_PHASE,
    .gait = "polynomial:0,0,0,0,0,0,8,-7", .make = phase_from_rest },
  { "trajectory", "x and v at the end of very many periods, from the steady state or 1 % beside it", STRESS_TRAJECTORY,
    .eps = { -6, 0 }, .make = trajectory },
  { .name = NULL },
};

/* False: x gives none. */
static bool make(const struct stress_family *f, struct stress_case *s, const double *x)
{
  struct scallop_crawler *c = &s->crawler;
  calm(c, x);
  if (f->masses > 0)
    spread(&c->m1, &c->m2, x[f->masses]);
  if (f->forces > 0)
    spread(&c->F1, &c->F2, x[f->forces]);
  if (f->equal_forces > 0)
    c->F1 = c->F2 * (1 + small(x[f->equal_forces]));
  if (f->equal_phases > 0)
    c->alpha = 0.5 + 0.5 * small(x[f->equal_phases]);
  if (f->scale > 0)
    scale(c, x, f->scale);
  if (f->eps[0] < f->eps[1])
    set_eps(c, x[6], f->eps[0], f->eps[1]);
  return (!f->make || f->make(s, x)) && scallop_crawler_check(c, NULL) == SCALLOP_OK;
}

/* A shift of the whole sequence, another one for each seed, family and gait (Cranley & Patterson 1976) */
static bool draw_shift(unsigned long seed, const struct stress_family *family, const struct scallop_gait *gait,
                       double shift[STRESS_DIMENSIONS])
{
  gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
  unsigned long mixed = seed;
  if (!random)
    return false;
  const char *const names[] = { family->name, gait->name };
  for (int i = 0; i < 2; i++)
    for (const char *c = names[i]; *c; c++)
      mixed = (mixed * 31 + (unsigned char)*c) & 0xffffffff;
  gsl_rng_set(random, mixed);
  for (int i = 0; i < STRESS_DIMENSIONS; i++)
    shift[i] = gsl_rng_uniform(random);
  gsl_rng_free(random);
  return true;
}

struct motion stress_motion(const struct stress_case *s)
{
  return (struct motion){ s->kind == STRESS_PHASE ? OF_PHASE : OF_STEADY, s->crawler, s->phase, s->v0 };
}

int stress_make(const struct stress_family *family, const struct scallop_gait *gait, unsigned long seed, int count,
                struct stress_case *cases)
{
  enum { TRIES = 300 }; /* for each case, on average */
  double x[STRESS_DIMENSIONS], shift[STRESS_DIMENSIONS];
  int made = 0;
  gsl_qrng *sequence = gsl_qrng_alloc(gsl_qrng_sobol, STRESS_DIMENSIONS);
  if (sequence && draw_shift(seed, family, gait, shift))
    for (long tries = 0; made < count && tries < (long)count * TRIES; tries++) {
      struct stress_case *c = &cases[made];
      gsl_qrng_get(sequence, x);
      for (int i = 0; i < STRESS_DIMENSIONS; i++)
        x[i] = fmod(x[i] + shift[i], 1);
      *c = (struct stress_case){ .kind = family->kind };
      c->crawler.gait = gait;
      made += make(family, c, x);
    }
  gsl_qrng_free(sequence);
  return made;
}

void stress_arguments(const struct stress_case *s, char *text)
{
  double numbers[CRAWLER_NUMBERS];
  char number[NUMBER_TEXT];
  crawler_numbers(&s->crawler, numbers);
  for (int i = 0; i < CRAWLER_NUMBERS; i++) {
    number_text(number, numbers[i], 0);
    text += snprintf(text, 64, "--%s %s ", crawler_parameters[i], number);
  }
  text += snprintf(text, GAIT_TEXT, "--gait %s", s->crawler.gait->name);
  number_text(number, s->v0, 0);
  if (s->kind == STRESS_TRAJECTORY)
    snprintf(text, 80, " --start %s --periods %ld", number, s->periods);
  if (s->kind == STRESS_PHASE)
    snprintf(text, 80, " --phase %s --v0 %s", s->phase == SCALLOP_EXTENSION ? "extension" : "contraction", number);
}
