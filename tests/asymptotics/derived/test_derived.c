/* The derived expansions against the certified solver, which finds the same motions by another route: the error of the
 * terms below T^N is the next term, to a factor that tends to 1. One wrong coefficient and it does not. */
#include <stdlib.h>

#include "tests/support/exact.h"
#include "tests/support/odd_gaits.h"
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

/* The expansion and the certified answers of one motion, a phase or the steady state (STEADY) */
enum { NUMBERS = 8, STEADY = 2 };
struct motion {
  int kind;
  struct scallop_expansion e;
  struct scallop_certified_phase phase[TIMES];
  struct scallop_certified_steady steady[TIMES];
  fmpq_t T[TIMES];
};
#define MOTION(of) \
  of(scallop_expansion, &s->e) of(scallop_certified_phase, &s->phase[0]) of(scallop_certified_phase, &s->phase[1]) \
      of(scallop_certified_steady, &s->steady[0]) of(scallop_certified_steady, &s->steady[1]) of(fmpq, s->T[0]) \
          of(fmpq, s->T[1])
SCOPED_PARTS(motion, struct motion, MOTION)

/* How many numbers the motion has: those of switches come last */
static int list(struct quantity q[NUMBERS], const struct motion *m)
{
  const struct scallop_expansion *e = &m->e;
  const struct scallop_certified_phase *p = m->phase;
  const struct scallop_certified_steady *c = m->steady;
  const struct quantity of_phase[NUMBERS] = { { "v_end", &e->v_end, { p[0].v_end, p[1].v_end } },
                                              { "dx1", &e->dx1, { p[0].dx1, p[1].dx1 } },
                                              { "dx2", &e->dx2, { p[0].dx2, p[1].dx2 } },
                                              { "dxC", &e->dxC, { p[0].dxC, p[1].dxC } },
                                              { "t1", &e->t1, { p[0].t1, p[1].t1 } },
                                              { "dT", &e->dT, { p[0].dT, p[1].dT } },
                                              { "at_first", &e->rear_at_first, { p[0].at_first, p[1].at_first } },
                                              { "at_last", &e->rear_at_last, { p[0].at_last, p[1].at_last } } };
  const struct quantity of_steady[NUMBERS] = {
    { "v_start", &e->v_start, { c[0].v_start, c[1].v_start } },
    { "v_mid", &e->v_mid, { c[0].v_mid, c[1].v_mid } },
    { "displacement", &e->displacement, { c[0].displacement, c[1].displacement } },
    { "mean_velocity", &e->mean_velocity, { c[0].mean_velocity, c[1].mean_velocity } },
    { "friction_work", &e->friction_work, { c[0].friction_work, c[1].friction_work } },
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
    right = (steady ? scallop_certified_steady(&there, digits, &m->steady[t], why)
                    : scallop_certified_phase(&there, kind, v0, digits, &m->phase[t], why))
            == SCALLOP_OK;
    if (steady)
      both_modes(m->steady[t].modes, modes);
    else
      scallop_modes_text(&m->phase[t].modes, modes);
    right = right && strcmp(modes, m->e.modes) == 0 && (steady || m->phase[t].switches == m->e.switches);
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
  enum scallop_status status = kind == STEADY ? scallop_expand_steady(crawler, ORDER, scale->precision, &m.e, &why)
                                              : scallop_expand_phase(crawler, (enum scallop_phase_kind)kind, v0, ORDER,
                                                                     scale->precision, NULL, &m.e, &why);
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
  fail_msg("kind %d, v0=%g: %s; modes %s for T -> 0, %s last", kind, fraction_d(v0), why, m.e.modes, modes);
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

enum { WITH_SERIES_OF_PHASES = 3 }; /* the first of every_gait */

/* Crawlers of small fractions, with either body stronger and alpha on either side of 1/2; a sixth with equal forces;
 * with alpha = 1/2, where v_start is of the order of T, and the body moves nowhere, or F1 = F2, where nothing moves;
 * wild ones */
enum drawn { ORDINARY_ONES, SOME_EQUAL, GO_NOWHERE, WILD };
static void draw(struct scallop_rational_crawler *c, struct random *r, const struct scallop_gait *gait,
                 enum drawn drawn, int i)
{
  static const enum family families[] = { EXTREME_RATIOS, NEARLY_EQUAL_FORCES, ALPHA_EDGE };
  if (drawn == WILD) {
    struct scallop_crawler w = random_crawler(r, families[i % 3], gait);
    if (families[i % 3] == NEARLY_EQUAL_FORCES)
      w.F2 = w.F1 * (1 + random_decades(r, 1e-8, 1e-3) * (random_below(r, 2) ? 1 : -1));
    scallop_rational_of(c, &w);
  } else
    random_exact_crawler(c, r, gait);
  if (drawn == GO_NOWHERE && i % 4 != 3)
    fmpq_set_si(c->alpha, 1, 2);
  if ((drawn == GO_NOWHERE && i % 4 >= 2) || (drawn == SOME_EQUAL && i % 6 == 5))
    fmpq_set(c->F2, c->F1);
}

static void check_drawn(const char *what, bool steady, enum drawn drawn, const struct scallop_gait *const *gaits,
                        int count, int each, uint64_t seed)
{
  struct random r = { seed };
  const struct scale *scale = drawn == WILD ? &wild : &ordinary;
  SCOPED(scallop_rational, c);
  for (int i = 0; i < count * each; i++) {
    draw(&c, &r, gaits[i % count], drawn, i / count);
    set_small_T(&c, scale->eps);
    check(&c, steady, &r, scale);
  }
  print_message("%d terms of %s: error/term - 1 at most %.2g at T, %.2g at T/8; %d without a power series\n", compared,
                what, worst[0], worst[1], undecided);
  compared = undecided = 0;
  worst[0] = worst[1] = 0;
}

TEST(phases)
{
  check_drawn("phases", false, SOME_EQUAL, every_gait, WITH_SERIES_OF_PHASES, 6, 20260821);
  check_drawn("wild phases", false, WILD, every_gait, WITH_SERIES_OF_PHASES, 3, 20260822);
  /* l' = 1 throughout: a small velocity changes no mode */
  check_drawn("phases of the sawtooth", false, ORDINARY_ONES, every_gait + SAWTOOTH, 1, 5, 20260823);
}

/* The sine and the ramps of the quadratic gait in one gait, and a gait of one piece, whose crossings are found wherever
 * they are */
TEST(steady_states)
{
  const struct scallop_gait mixed[] = { mixed_gait(&scallop_gait_quadratic, &scallop_gait_sinusoidal),
                                        mixed_gait(&scallop_gait_sinusoidal, &scallop_gait_quadratic) };
  const struct scallop_gait *const others[] = { &parabola_gait, &mixed[0], &mixed[1] };
  check_drawn("steady states", true, ORDINARY_ONES, every_gait, SMOOTH_GAITS, 8, 20260824);
  check_drawn("steady states of other gaits", true, ORDINARY_ONES, others, 3, 3, 20260827);
  check_drawn("wild steady states", true, WILD, every_gait, WITH_SERIES_OF_PHASES, 3, 20260825);
  check_drawn("steady states that go nowhere", true, GO_NOWHERE, every_gait, WITH_SERIES_OF_PHASES, 4, 20260826);
}
