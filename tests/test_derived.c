/* The derived expansions against the certified solver, which finds the same motions by another route: the error of the terms
 * below T^N is the next term, to a factor that tends to 1. One wrong coefficient and it does not. */
#include "tests/check.h"

#include <stdio.h>
#include <stdlib.h>

#include "asymptotics/derived/derived.h"
#include "numerics/certified.h"
#include "tests/exact.h"

enum { ORDER = 16, TERMS = 11, TIMES = 2 }; /* expanded so far, compared so far, at T and T/8 */

/* How small T is, and what it takes to see the terms below T^TERMS there: wild crawlers have ratios up to 1e8,
 * in a high power some coefficients. */
struct scale {
  double eps;
  long digits;
  slong precision;
};
static const struct scale ordinary = { 1e-30, 220, 800 }, wild = { 1e-100, 700, 2600 };

/* ---- a quantity: its series and its exact values at T and T/8 ---- */

struct quantity {
  const char *name;
  const struct series *series;
  const arb_struct *exact[TIMES];
};

/* |error/term - 1|, the error of the terms below x^before beside the term x^power */
static double excess(const struct quantity *q, int i, const fmpq_t T, slong before, slong power, slong precision)
{
  arb_t at, sum, term;
  arb_init(at);
  arb_init(sum);
  arb_init(term);
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
  double far = at_most(sum);
  arb_clear(at);
  arb_clear(sum);
  arb_clear(term);
  return far;
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

/* T and T/8, whatever of the crawler it is the duration of */
static void set_times(fmpq_t T[TIMES], const fmpq_t first)
{
  fmpq_init(T[0]);
  fmpq_init(T[1]);
  fmpq_set(T[0], first);
  fmpq_div_2exp(T[1], first, 3);
}

static void print_worst(const char *what)
{
  print_message("%d %s: error/term - 1 at most %.2g at T, %.2g at T/8\n", compared, what, worst[0], worst[1]);
  compared = 0;
  worst[0] = worst[1] = 0;
}

/* ---- phases ---- */

enum { PHASE = 8 };

static void list_phase(struct quantity q[PHASE], const struct scallop_phase_expansion *e,
                       struct scallop_certified_phase c[TIMES])
{
  const struct series *series[PHASE] = { &e->v_end, &e->dx1, &e->dx2, &e->dxC, &e->t1, &e->dT, &e->at_first, &e->at_last };
  static const char *const names[PHASE] = { "v_end", "dx1", "dx2", "dxC", "t1", "dT", "at_first", "at_last" };
  for (int i = 0; i < PHASE; i++)
    q[i] = (struct quantity){ .name = names[i], .series = series[i] };
  for (int t = 0; t < TIMES; t++) {
    const arb_struct *const exact[PHASE] = { c[t].v_end, c[t].dx1, c[t].dx2,      c[t].dxC,
                                             c[t].t1,    c[t].dT,  c[t].at_first, c[t].at_last };
    for (int i = 0; i < PHASE; i++)
      q[i].exact[t] = exact[i];
  }
}

/* T of the crawler is that of the phase here. */
static bool phase_is_right(const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind, const fmpq_t v0,
                           const struct scale *scale)
{
  struct scallop_phase_expansion e;
  struct scallop_certified_phase c[TIMES];
  struct scallop_rational_crawler there;
  struct quantity q[PHASE];
  char modes[SCALLOP_MODES_TEXT];
  fmpq_t T[TIMES], fraction;
  const char *why = "";
  scallop_phase_expansion_init(&e);
  scallop_rational_init(&there);
  scallop_rational_copy(&there, crawler);
  fmpq_init(fraction);
  set_times(T, crawler->T);
  scallop_rational_fraction(fraction, crawler, kind);
  bool right = scallop_expand_phase(crawler, kind, v0, ORDER, scale->precision, NULL, &e, &why) == SCALLOP_OK;
  for (int t = 0; t < TIMES; t++) {
    scallop_certified_phase_init(&c[t]);
    fmpq_div(there.T, T[t], fraction);
    right = right && scallop_certified_phase(&there, kind, v0, scale->digits, &c[t], &why) == SCALLOP_OK;
    scallop_modes_text(&c[t].modes, modes);
    right = right && strcmp(modes, e.modes) == 0 && c[t].switches == e.switches;
  }
  list_phase(q, &e, c);
  for (int i = 0; right && i < (e.switches ? PHASE : PHASE - 4); i++)
    right = terms_are_right(&q[i], T, scale->precision);
  if (!right)
    print_error("kind %d, v0=%g: %s; modes %s for T -> 0, %s at T/8\n", kind, fraction_d(v0), why, e.modes, modes);
  for (int t = 0; t < TIMES; t++) {
    scallop_certified_phase_clear(&c[t]);
    fmpq_clear(T[t]);
  }
  scallop_phase_expansion_clear(&e);
  scallop_rational_clear(&there);
  fmpq_clear(fraction);
  return right;
}

/* From rest and with a velocity of either sign, of the size that friction gives in a phase with eps = 1 */
static void check_phases(const struct scallop_rational_crawler *crawler, struct random *r, const struct scale *scale)
{
  fmpq_t v0;
  fmpq_init(v0);
  double size = sqrt(fraction_d(crawler->L) * (fraction_d(crawler->F1) + fraction_d(crawler->F2))
                     / (fraction_d(crawler->m1) + fraction_d(crawler->m2)));
  for (int kind = 0; kind < 2; kind++)
    for (int sign = -1; sign <= 1; sign++) {
      scallop_rational_set_double(v0, sign * random_between(r, 0.2, 3) * size);
      if (!phase_is_right(crawler, (enum scallop_phase_kind)kind, v0, scale)) {
        print_exact_crawler(crawler);
        fail();
      }
    }
  fmpq_clear(v0);
}

static const struct scallop_gait *const gaits[] = { &scallop_gait_quadratic, &scallop_gait_sinusoidal, &trapezoid_gait,
                                                    &minimum_jerk_gait };
enum { WITH_SERIES_OF_PHASES = 3, GAITS = 4 };

/* Of small fractions, with either body stronger and alpha on either side of 1/2 */
static void phases_of_ordinary_crawlers(void **state)
{
  (void)state;
  struct random r = { 20260821 };
  struct scallop_rational_crawler c;
  scallop_rational_init(&c);
  for (int i = 0; i < 10 * WITH_SERIES_OF_PHASES; i++) {
    random_exact_crawler(&c, &r, gaits[i % WITH_SERIES_OF_PHASES]);
    if (i % 10 == 9)
      fmpq_set(c.F2, c.F1);
    set_small_T(&c, ordinary.eps);
    check_phases(&c, &r, &ordinary);
  }
  scallop_rational_clear(&c);
  print_worst("terms of phases");
}

static const enum family wild_families[] = { EXTREME_RATIOS, NEARLY_EQUAL_FORCES, ALPHA_EDGE };
enum { WILD = 3 };

static void wild_crawler(struct scallop_rational_crawler *exact, struct random *r, int i, const struct scallop_gait *gait)
{
  struct scallop_crawler c = random_crawler(r, wild_families[i % WILD], gait);
  if (wild_families[i % WILD] == NEARLY_EQUAL_FORCES)
    c.F2 = c.F1 * (1 + random_decades(r, 1e-8, 1e-3) * (random_below(r, 2) ? 1 : -1));
  scallop_rational_of(exact, &c);
  set_small_T(exact, wild.eps);
}

static void phases_of_wild_crawlers(void **state)
{
  (void)state;
  struct random r = { 20260822 };
  struct scallop_rational_crawler c;
  scallop_rational_init(&c);
  for (int i = 0; i < WILD * WITH_SERIES_OF_PHASES; i++) {
    wild_crawler(&c, &r, i / WITH_SERIES_OF_PHASES, gaits[i % WITH_SERIES_OF_PHASES]);
    check_phases(&c, &r, &wild);
  }
  scallop_rational_clear(&c);
  print_worst("terms of wild phases");
}

/* l' = 1 throughout: a small velocity changes no mode. */
static void phases_of_the_sawtooth(void **state)
{
  (void)state;
  struct random r = { 20260823 };
  struct scallop_rational_crawler c;
  scallop_rational_init(&c);
  for (int i = 0; i < 10; i++) {
    random_exact_crawler(&c, &r, &sawtooth_gait);
    set_small_T(&c, ordinary.eps);
    check_phases(&c, &r, &ordinary);
  }
  scallop_rational_clear(&c);
  print_worst("terms of the sawtooth");
}

/* ---- steady states ---- */

enum { STEADY = 5 };

static void list_steady(struct quantity q[STEADY], const struct scallop_steady_expansion *e,
                        struct scallop_certified_steady c[TIMES])
{
  q[0] = (struct quantity){ "v_start", &e->v_start, { c[0].v_start, c[1].v_start } };
  q[1] = (struct quantity){ "v_mid", &e->v_mid, { c[0].v_mid, c[1].v_mid } };
  q[2] = (struct quantity){ "displacement", &e->displacement, { c[0].displacement, c[1].displacement } };
  q[3] = (struct quantity){ "mean_velocity", &e->mean_velocity, { c[0].mean_velocity, c[1].mean_velocity } };
  q[4] = (struct quantity){ "friction_work", &e->friction_work, { c[0].friction_work, c[1].friction_work } };
}

static int undecided;

static void steady_modes(char *text, size_t size, const struct scallop_certified_steady *c)
{
  char modes[2][SCALLOP_MODES_TEXT];
  scallop_modes_text(&c->modes[0], modes[0]);
  scallop_modes_text(&c->modes[1], modes[1]);
  snprintf(text, size, "%s | %s", modes[0], modes[1]);
}

/* |l'| of the trapezoid is 16/13 for a while. A range of crawlers would have c there in the limit, where it glides along the
 * curve: a body rests meanwhile, and no power series exists. */
static bool rests_on_a_plateau(const struct scallop_rational_crawler *crawler)
{
  struct scallop_certified_steady c;
  scallop_certified_steady_init(&c);
  bool rests = crawler->gait == &trapezoid_gait && scallop_certified_steady(crawler, 20, &c, NULL) == SCALLOP_OK
               && c.regime == SCALLOP_STICK_SLIP;
  scallop_certified_steady_clear(&c);
  return rests;
}

static bool steady_is_right(const struct scallop_rational_crawler *crawler, const struct scale *scale)
{
  struct scallop_steady_expansion e;
  struct scallop_certified_steady c[TIMES];
  struct scallop_rational_crawler there;
  struct quantity q[STEADY];
  char modes[2 * SCALLOP_MODES_TEXT + 4] = "";
  fmpq_t T[TIMES];
  const char *why = "";
  scallop_steady_expansion_init(&e);
  scallop_rational_init(&there);
  scallop_rational_copy(&there, crawler);
  set_times(T, crawler->T);
  enum scallop_status status = scallop_expand_steady(crawler, ORDER, scale->precision, &e, &why);
  bool right = status == SCALLOP_OK;
  for (int t = 0; t < TIMES; t++) {
    scallop_certified_steady_init(&c[t]);
    fmpq_set(there.T, T[t]);
    right = right && scallop_certified_steady(&there, scale->digits, &c[t], &why) == SCALLOP_OK;
    steady_modes(modes, sizeof modes, &c[t]);
    right = right && strcmp(modes, e.modes) == 0;
  }
  list_steady(q, &e, c);
  for (int i = 0; right && i < STEADY; i++)
    right = terms_are_right(&q[i], T, scale->precision);
  if (status == SCALLOP_EUNDECIDED && rests_on_a_plateau(crawler)) {
    undecided++;
    right = true;
  }
  if (!right) {
    print_error("%s; modes %s for T -> 0, %s at T/8\n", why, e.modes, modes);
    print_exact_crawler(crawler);
  }
  for (int t = 0; t < TIMES; t++) {
    scallop_certified_steady_clear(&c[t]);
    fmpq_clear(T[t]);
  }
  scallop_steady_expansion_clear(&e);
  scallop_rational_clear(&there);
  return right;
}

static void steady_states_of_ordinary_crawlers(void **state)
{
  (void)state;
  struct random r = { 20260824 };
  struct scallop_rational_crawler c;
  scallop_rational_init(&c);
  for (int i = 0; i < 16 * GAITS; i++) {
    random_exact_crawler(&c, &r, gaits[i % GAITS]);
    set_small_T(&c, ordinary.eps);
    assert_true(steady_is_right(&c, &ordinary));
  }
  scallop_rational_clear(&c);
  print_worst("terms of steady states");
}

static void steady_states_of_wild_crawlers(void **state)
{
  (void)state;
  struct random r = { 20260825 };
  struct scallop_rational_crawler c;
  scallop_rational_init(&c);
  for (int i = 0; i < WILD * WITH_SERIES_OF_PHASES; i++) {
    wild_crawler(&c, &r, i / WITH_SERIES_OF_PHASES, gaits[i % WITH_SERIES_OF_PHASES]);
    assert_true(steady_is_right(&c, &wild));
  }
  scallop_rational_clear(&c);
  print_message("%d without a power series\n", undecided);
  print_worst("terms of wild steady states");
}

/* alpha = 1/2: v_start is of the order of T, and the body moves nowhere. F1 = F2: nothing moves. */
static void steady_states_that_go_nowhere(void **state)
{
  (void)state;
  struct random r = { 20260826 };
  struct scallop_rational_crawler c;
  scallop_rational_init(&c);
  for (int i = 0; i < 10 * WITH_SERIES_OF_PHASES; i++) {
    random_exact_crawler(&c, &r, gaits[i % WITH_SERIES_OF_PHASES]);
    if (i % 4 != 3)
      fmpq_set_si(c.alpha, 1, 2);
    if (i % 4 >= 2)
      fmpq_set(c.F2, c.F1);
    set_small_T(&c, ordinary.eps);
    assert_true(steady_is_right(&c, &ordinary));
  }
  scallop_rational_clear(&c);
  print_worst("terms of steady states that go nowhere");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(phases_of_ordinary_crawlers),    cmocka_unit_test(phases_of_wild_crawlers),
    cmocka_unit_test(phases_of_the_sawtooth),         cmocka_unit_test(steady_states_of_ordinary_crawlers),
    cmocka_unit_test(steady_states_of_wild_crawlers), cmocka_unit_test(steady_states_that_go_nowhere),
  };
  return cmocka_run_group_tests_name("derived", tests, NULL, NULL);
}
