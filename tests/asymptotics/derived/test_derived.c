/* The derived expansions against the certified solver, which finds the same motions by another route: the error of the
 * terms below T^N is the next term, to a factor that tends to 1. One wrong coefficient and it does not. */
#include <stdlib.h>

#include "tests/support/exact.h"
#include "tests/support/solved.h"

enum { ORDER = 16, TERMS = 11, TIMES = 2 }; /* expanded so far, compared so far, at T and T/8 */

/* How small T is, and what it takes to see the terms below T^TERMS there: wild crawlers have ratios up to 1e8,
 * in a high power some coefficients. */
struct scale {
  double eps;
  long digits;
  slong precision;
};
static const struct scale ordinary = { 1e-30, 220, 800 }, wild = { 1e-100, 700, 2600 };

struct quantity {
  const char *name;
  const struct series *series;
  const arb_struct *exact[TIMES];
};

/* |error/term - 1|, the error of the terms below x^before beside the term x^power */
static double excess(const struct quantity *q, int i, const fmpq_t T, slong before, slong power, slong precision)
{
  SCOPED(arb, at, sum, term);
  arb_set_fmpq(at, T, precision);
  series_value(sum, q->series, at, before, precision);
  arb_sub(sum, q->exact[i], sum, precision);
  series_coefficient(term, q->series, power, precision);
  arb_div(sum, sum, term, precision);
  if (power < 0)
    arb_inv(at, at, precision);
  arb_pow_ui(at, at, (ulong)labs(power), precision);
  arb_div(sum, sum, at, precision);
  arb_sub_si(sum, sum, 1, precision);
  return at_most(sum);
}

static double worst[TIMES]; /* excess */
static int compared;

static bool terms_are_right(const struct quantity *q, const fmpq_t *T, slong precision)
{
  for (slong before = -1; before < TERMS;) {
    slong power = next_nonzero(q->series, before, ORDER);
    if (power == ORDER && before == -1)
      return arb_contains_zero(q->exact[0]) && arb_contains_zero(q->exact[1]);
    if (power > TERMS)
      break;
    double at_T = excess(q, 0, T[0], before, power, precision), later = excess(q, 1, T[1], before, power, precision);
    if (!(at_T <= 1e-2 && later <= at_T / 7 + 1e-15)) {
      print_error("%s: error/term - 1 before T^%ld is %g, then %g\n", q->name, (long)power, at_T, later);
      return false;
    }
    worst[0] = fmax(worst[0], at_T);
    worst[1] = fmax(worst[1], later);
    compared++;
    before = power + 1;
  }
  return true;
}

static void print_worst(const char *what)
{
  print_message("%d %s: error/term - 1 at most %.2g at T, %.2g at T/8\n", compared, what, worst[0], worst[1]);
  compared = 0;
  worst[0] = worst[1] = 0;
}

/* The expansions and the certified answers of one motion, a phase or the steady state (STEADY) */
enum { NUMBERS = 8, STEADY = 2 };
struct motion {
  int kind;
  struct scallop_expansion phase;
  struct scallop_expansion steady;
  struct scallop_certified_phase phase_at[TIMES];
  struct scallop_certified_steady steady_at[TIMES];
  fmpq_t T[TIMES];
};
#define MOTION(of) \
  of(scallop_expansion, &s->phase) of(scallop_expansion, &s->steady) of(scallop_certified_phase, &s->phase_at[0]) \
      of(scallop_certified_phase, &s->phase_at[1]) of(scallop_certified_steady, &s->steady_at[0]) \
          of(scallop_certified_steady, &s->steady_at[1]) of(fmpq, s->T[0]) of(fmpq, s->T[1])
SCOPED_PARTS(motion, struct motion, MOTION)

/* How many numbers the motion has: those of switches come last */
static int list(struct quantity q[NUMBERS], const struct motion *m)
{
  const struct scallop_expansion *e = &m->phase;
  const struct scallop_expansion *s = &m->steady;
  const struct scallop_certified_phase *p = m->phase_at;
  const struct scallop_certified_steady *c = m->steady_at;
  const struct quantity of_phase[NUMBERS] = { { "v_end", &e->v_end, { p[0].v_end, p[1].v_end } },
                                              { "dx1", &e->dx1, { p[0].dx1, p[1].dx1 } },
                                              { "dx2", &e->dx2, { p[0].dx2, p[1].dx2 } },
                                              { "dxC", &e->dxC, { p[0].dxC, p[1].dxC } },
                                              { "t1", &e->t1, { p[0].t1, p[1].t1 } },
                                              { "dT", &e->dT, { p[0].dT, p[1].dT } },
                                              { "at_first", &e->rear_at_first, { p[0].at_first, p[1].at_first } },
                                              { "at_last", &e->rear_at_last, { p[0].at_last, p[1].at_last } } };
  const struct quantity of_steady[NUMBERS] = {
    { "v_start", &s->v_start, { c[0].v_start, c[1].v_start } },
    { "v_mid", &s->v_mid, { c[0].v_mid, c[1].v_mid } },
    { "displacement", &s->displacement, { c[0].displacement, c[1].displacement } },
    { "mean_velocity", &s->mean_velocity, { c[0].mean_velocity, c[1].mean_velocity } },
    { "friction_work", &s->friction_work, { c[0].friction_work, c[1].friction_work } },
  };
  memcpy(q, m->kind == STEADY ? of_steady : of_phase, sizeof of_phase);
  return m->kind == STEADY ? 5 : e->switches ? 8 : 4;
}

/* At T and T/8, of the crawler or of its phase, with the modes that are expected as T -> 0 */
static bool certify(struct motion *m, const struct scallop_rational_crawler *crawler, const fmpq_t v0, long digits,
                    char modes[BOTH_MODES_TEXT], const char **why)
{
  SCOPED(scallop_rational, there);
  SCOPED(fmpq, fraction);
  bool steady = m->kind == STEADY, right = true;
  fmpq_one(fraction);
  if (!steady)
    scallop_rational_fraction(fraction, crawler, (enum scallop_phase_kind)m->kind);
  scallop_rational_copy(&there, crawler);
  for (int t = 0; right && t < TIMES; t++) {
    fmpq_div_2exp(m->T[t], crawler->T, 3 * (ulong)t);
    fmpq_div(there.T, m->T[t], fraction);
    enum scallop_phase_kind kind = (enum scallop_phase_kind)m->kind;
    right = (steady ? scallop_certified_steady(&there, digits, &m->steady_at[t], why)
                    : scallop_certified_phase(&there, kind, v0, digits, &m->phase_at[t], why))
            == SCALLOP_OK;
    if (steady)
      both_modes(m->steady_at[t].modes, modes);
    else
      scallop_modes_text(&m->phase_at[t].modes, modes);
    right = right && strcmp(modes, steady ? m->steady.modes : m->phase.modes) == 0
            && (steady || m->phase_at[t].switches == m->phase.switches);
  }
  return right;
}

static int undecided;

/* |l'| of the trapezoid is 16/13 for a while. A range of crawlers would have c there in the limit, where it glides
 * along the curve: a body rests meanwhile, and no power series exists. */
static bool rests_on_a_plateau(const struct scallop_rational_crawler *crawler)
{
  SCOPED(scallop_certified_steady, c);
  return crawler->gait == &trapezoid_gait && scallop_certified_steady(crawler, 20, &c, NULL) == SCALLOP_OK
         && c.regime == SCALLOP_STICK_SLIP;
}

/* T of the crawler is that of the phase here. */
static void check_motion(const struct scallop_rational_crawler *crawler, int kind, const fmpq_t v0,
                         const struct scale *scale)
{
  SCOPED(motion, m);
  struct quantity q[NUMBERS];
  char modes[BOTH_MODES_TEXT] = "";
  const char *why = "";
  m.kind = kind;
  enum scallop_status status = kind == STEADY ? scallop_expand_steady(crawler, ORDER, scale->precision, &m.steady, &why)
                                              : scallop_expand_phase(crawler, (enum scallop_phase_kind)kind, v0, ORDER,
                                                                     scale->precision, NULL, &m.phase, &why);
  if (kind == STEADY && status == SCALLOP_EUNDECIDED && rests_on_a_plateau(crawler)) {
    undecided++;
    return;
  }
  bool right = status == SCALLOP_OK && certify(&m, crawler, v0, scale->digits, modes, &why);
  for (int i = 0; right && i < list(q, &m); i++)
    right = terms_are_right(&q[i], m.T, scale->precision);
  if (right)
    return;
  print_exact_crawler(crawler);
  fail_msg("kind %d, v0=%g: %s; modes %s for T -> 0, %s last", kind, fraction_d(v0), why,
           kind == STEADY ? m.steady.modes : m.phase.modes, modes);
}

/* Phases from rest and with a velocity of either sign, of the size that friction gives in a phase with eps = 1; or the
 * steady state */
static void check(const struct scallop_rational_crawler *crawler, bool steady, struct random *r,
                  const struct scale *scale)
{
  SCOPED(fmpq, v0);
  double size = sqrt(fraction_d(crawler->L) * (fraction_d(crawler->F1) + fraction_d(crawler->F2))
                     / (fraction_d(crawler->m1) + fraction_d(crawler->m2)));
  if (steady)
    check_motion(crawler, STEADY, v0, scale);
  for (int kind = 0; kind < 2 && !steady; kind++)
    for (int sign = -1; sign <= 1; sign++) {
      scallop_rational_set_double(v0, sign * random_between(r, 0.2, 3) * size);
      check_motion(crawler, kind, v0, scale);
    }
}

static const struct scallop_gait *const gaits[] = { &scallop_gait_quadratic, &scallop_gait_sinusoidal, &trapezoid_gait,
                                                    &minimum_jerk_gait };
enum { WITH_SERIES_OF_PHASES = 3, GAITS = 4 };

/* Of small fractions, with either body stronger and alpha on either side of 1/2; every tenth with equal forces */
static void ordinary_crawlers(uint64_t seed, bool steady, int count)
{
  struct random r = { seed };
  SCOPED(scallop_rational, c);
  int kinds = steady ? GAITS : WITH_SERIES_OF_PHASES;
  for (int i = 0; i < count * kinds; i++) {
    random_exact_crawler(&c, &r, gaits[i % kinds]);
    if (!steady && i % 10 == 9)
      fmpq_set(c.F2, c.F1);
    set_small_T(&c, ordinary.eps);
    check(&c, steady, &r, &ordinary);
  }
  print_worst(steady ? "terms of steady states" : "terms of phases");
}

TEST(phases_of_ordinary_crawlers) { ordinary_crawlers(20260821, false, 10); }
TEST(steady_states_of_ordinary_crawlers) { ordinary_crawlers(20260824, true, 16); }

static void wild_crawlers(uint64_t seed, bool steady)
{
  static const enum family families[] = { EXTREME_RATIOS, NEARLY_EQUAL_FORCES, ALPHA_EDGE };
  struct random r = { seed };
  SCOPED(scallop_rational, exact);
  for (int i = 0; i < 3 * WITH_SERIES_OF_PHASES; i++) {
    enum family family = families[i / WITH_SERIES_OF_PHASES];
    struct scallop_crawler c = random_crawler(&r, family, gaits[i % WITH_SERIES_OF_PHASES]);
    if (family == NEARLY_EQUAL_FORCES)
      c.F2 = c.F1 * (1 + random_decades(&r, 1e-8, 1e-3) * (random_below(&r, 2) ? 1 : -1));
    scallop_rational_of(&exact, &c);
    set_small_T(&exact, wild.eps);
    check(&exact, steady, &r, &wild);
  }
  print_message("%d without a power series\n", undecided);
  print_worst(steady ? "terms of wild steady states" : "terms of wild phases");
}

TEST(phases_of_wild_crawlers) { wild_crawlers(20260822, false); }
TEST(steady_states_of_wild_crawlers) { wild_crawlers(20260825, true); }

/* l' = 1 throughout: a small velocity changes no mode. */
TEST(phases_of_the_sawtooth)
{
  struct random r = { 20260823 };
  SCOPED(scallop_rational, c);
  for (int i = 0; i < 10; i++) {
    random_exact_crawler(&c, &r, &sawtooth_gait);
    set_small_T(&c, ordinary.eps);
    check(&c, false, &r, &ordinary);
  }
  print_worst("terms of the sawtooth");
}

/* alpha = 1/2: v_start is of the order of T, and the body moves nowhere. F1 = F2: nothing moves. */
TEST(steady_states_that_go_nowhere)
{
  struct random r = { 20260826 };
  SCOPED(scallop_rational, c);
  for (int i = 0; i < 10 * WITH_SERIES_OF_PHASES; i++) {
    random_exact_crawler(&c, &r, gaits[i % WITH_SERIES_OF_PHASES]);
    if (i % 4 != 3)
      fmpq_set_si(c.alpha, 1, 2);
    if (i % 4 >= 2)
      fmpq_set(c.F2, c.F1);
    set_small_T(&c, ordinary.eps);
    check(&c, true, &r, &ordinary);
  }
  print_worst("terms of steady states that go nowhere");
}
