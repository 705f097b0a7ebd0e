/* What must hold of the derived expansions whatever the motion is: they do not depend on how far one looks, on units,
 * on the names of the bodies or on the direction of space, and time reversal leaves its mark; what is no motion, or has
 * no expansion, is refused. */
#include "tests/support/expansions.h"
#include "tests/support/odd_gaits.h"
#include "tests/support/solved.h"

enum { PHASE = 8, STEADY = 3 };

static const struct series *phase_series(const struct scallop_expansion *e, int i)
{
  const struct series *const all[PHASE] = { &e->v_end, &e->dx1, &e->dx2,           &e->dxC,
                                            &e->t1,    &e->dT,  &e->rear_at_first, &e->rear_at_last };
  return all[i];
}
static const int phase_length[PHASE] = { 1, 1, 1, 1, 0, 0, 1, 1 }, phase_time[PHASE] = { -1, 0, 0, 0, 1, 1, 0, 0 };

static const struct series *steady_series(const struct scallop_expansion *e, int i)
{
  const struct series *const all[STEADY] = { &e->v_start, &e->v_mid, &e->displacement };
  return all[i];
}
static const int steady_time[STEADY] = { -1, -1, 0 };

/* Units of mass, length and force such that the unit of time is a fraction */
struct units_of {
  fmpq_t length, time;
};
#define UNITS(of) of(fmpq, s->length) of(fmpq, s->time)
SCOPED_PARTS(units_of, struct units_of, UNITS)

static void same(struct subject *s, struct units_of *u, struct random *r) { (void)s, (void)u, (void)r; }

static void change_units(struct subject *s, struct units_of *u, struct random *r)
{
  struct scallop_rational_crawler *c = &s->crawler;
  SCOPED(fmpq, mass, force);
  random_positive(u->length, r);
  random_positive(u->time, r);
  random_positive(mass, r);
  fmpq_mul(force, mass, u->length);
  fmpq_div(force, force, u->time);
  fmpq_div(force, force, u->time);
  fmpq_mul(c->m1, c->m1, mass);
  fmpq_mul(c->m2, c->m2, mass);
  fmpq_mul(c->F1, c->F1, force);
  fmpq_mul(c->F2, c->F2, force);
  fmpq_mul(c->L, c->L, u->length);
  fmpq_mul(s->v0, s->v0, u->length);
  fmpq_div(s->v0, s->v0, u->time);
}

static void mirror(struct subject *s, struct units_of *u, struct random *r)
{
  (void)u, (void)r;
  fmpq_swap(s->crawler.m1, s->crawler.m2);
  fmpq_swap(s->crawler.F1, s->crawler.F2);
  fmpq_neg(s->v0, s->v0);
}

static void exchange_phases(struct subject *s, struct units_of *u, struct random *r)
{
  mirror(s, u, r);
  fmpq_neg(s->v0, s->v0);
  fmpq_neg(s->crawler.alpha, s->crawler.alpha);
  fmpq_add_si(s->crawler.alpha, s->crawler.alpha, 1);
}

/* What becomes of each quantity of a motion in another one: which of its own it is (-1: none) */
static const struct law {
  const char *name;
  void (*change)(struct subject *s, struct units_of *u, struct random *r);
  int other_kind, mirrored;
  int phase[PHASE], steady[STEADY];
} laws[] = {
  { "few terms and many", same, 0, 0, { 0, 1, 2, 3, 4, 5, 6, 7 }, { 0, 1, 2 } },
  { "units", change_units, 0, 0, { 0, 1, 2, 3, 4, 5, 6, 7 }, { 0, 1, 2 } },
  /* a contraction is an extension with the bodies exchanged, if the gait goes back as it came */
  { "exchanged phases", exchange_phases, 1, 0, { 0, 2, 1, 3, 4, 5, 6, 7 }, { 1, 0, 2 } },
  /* velocities change their signs; at_first, at_last: of the rear body, the front one there */
  { "mirrored", mirror, 0, 1, { 0, 2, 1, 3, 4, 5, -1, -1 }, { 0, 1, 2 } },
};

/* b = (-1 where mirrored) length^i time^j time^-k a, for the coefficients of every T^k below order */
static void check_scaled(const struct series *a, const struct series *b, const struct units_of *u, int i, int j,
                         bool mirrored, slong order, const char *what)
{
  const struct ring ring = { ORDER + 4, PRECISION };
  SCOPED(fmpq, f, power);
  SCOPED(series, scaled);
  assert_true(a->known >= order && b->known >= order && a->kind == b->kind);
  for (slong k = -1; k < order; k++) {
    fmpq_pow_si(f, u->time, j - k);
    fmpq_pow_si(power, u->length, i);
    fmpq_mul(f, f, power);
    fmpq_mul_si(f, f, mirrored ? -1 : 1);
    series_scale(&scaled, a, f, &ring);
    if (!same_coefficient(&scaled, b, k, PRECISION))
      fail_msg("%s: T^%ld", what, (long)k);
  }
}

static void check_law(const struct law *law, const struct scallop_gait *gait, slong few, slong many, struct random *r)
{
  SCOPED(subject, a, b);
  SCOPED(units_of, u);
  draw(&a, r, gait);
  scallop_rational_copy(&b.crawler, &a.crawler);
  fmpq_set(b.v0, a.v0);
  fmpq_one(u.length);
  fmpq_one(u.time);
  law->change(&b, &u, r);
  for (int kind = 0; kind < 2 && gait != &minimum_jerk_gait; kind++) {
    expand_phase(&a, kind, few);
    expand_phase(&b, law->other_kind ? 1 - kind : kind, many);
    for (int q = 0; q < PHASE; q++)
      if (law->phase[q] >= 0)
        check_scaled(phase_series(&a.phase, q), phase_series(&b.phase, law->phase[q]), &u, phase_length[q],
                     phase_time[q], law->mirrored && q < 4, few, law->name);
  }
  bool there = expand_steady(&a, few); /* a range of trapezoids has no series: test_derived.c */
  assert_int_equal(expand_steady(&b, many), there);
  assert_true(there || gait == &trapezoid_gait);
  for (int q = 0; q < STEADY && there; q++)
    check_scaled(steady_series(&a.steady, q), steady_series(&b.steady, law->steady[q]), &u, 1, steady_time[q],
                 law->mirrored, few, law->name);
}

/* Every number of terms gives that many. */
TEST(laws_hold)
{
  struct random r = { 20260831 };
  for (size_t l = 0; l < sizeof laws / sizeof *laws; l++)
    for (int i = 0; i < check_cases(ORDER); i++) {
      bool of_orders = laws[l].change == same;
      check_law(&laws[l], every_gait[i % SMOOTH_GAITS], of_orders ? 1 + i % ORDER : ORDER, of_orders ? 24 : ORDER, &r);
    }
}

/* Backward in time friction drives: eps becomes -eps, T becomes i T, and the steady motion is that of the exchanged
 * phases. So for a gait that looks the same backward v_mid has the coefficients of v_start with alternating signs, and
 * the displacement has powers of T^4 only. For the trapezoid neither holds. */
TEST(reversed_in_time)
{
  struct random r = { 20260836 };
  int differ = 0, others = 0;
  SCOPED(subject, s);
  SCOPED(series, mid);
  const struct scallop_expansion *e = &s.steady;
  for (int i = 0; i < 6 * WITH_SERIES_OF_PHASES; i++) { /* the trapezoid comes last */
    bool reversible = i / 6 < REVERSIBLE;
    random_exact_crawler(&s.crawler, &r, every_gait[i / 6]);
    if (!expand_steady(&s, 2 * ORDER)) {
      assert_false(reversible);
      continue;
    }
    for (slong k = 0; 2 * k - 1 < 2 * ORDER; k++) {
      series_neg(&mid, &e->v_mid);
      differ += !same_coefficient(k % 2 ? &mid : &e->v_mid, &e->v_start, 2 * k - 1, PRECISION);
      others += k % 2 && !series_coefficient_is_zero(&e->displacement, 2 * k);
      assert_true(series_coefficient_is_zero(&e->v_start, 2 * k) && series_coefficient_is_zero(&e->v_mid, 2 * k));
      assert_true(series_coefficient_is_zero(&e->displacement, 2 * k + 1));
    }
    if (reversible && differ + others > 0) {
      print_exact_crawler(&s.crawler);
      fail_msg("%d coefficients of v_mid differ, %d of the displacement are there", differ, others);
    }
  }
  assert_true(differ > 0 && others > 0);
}

/* Each phase of a mixed gait is symmetric about its middle, but they are not mirror images of each other: the
 * displacement has no T^2 but at alpha = 1/2. */
TEST(phases_of_two_kinds)
{
  const struct scallop_gait mixed = mixed_gait(&scallop_gait_quadratic, &scallop_gait_sinusoidal);
  struct scallop_crawler c = with_gait(&mixed);
  SCOPED(subject, s);
  for (int quarters = 1; quarters <= 3; quarters++) {
    c.alpha = 0.25 * quarters;
    scallop_rational_of(&s.crawler, &c);
    assert_true(expand_steady(&s, 4));
    assert_int_equal(series_coefficient_is_zero(&s.steady.displacement, 2), quarters != 2);
  }
}

/* What may be refused: the expansions, the bounds of the steady state, and how far its modes hold */
enum { EXTENDING = 1, CONTRACTING = 2, EXPANDED = 4, BOUNDED = 8, HOLDING = 16, MOVING = 7, BOUNDS = 15, ALL = 31 };

static enum scallop_status ask(int what, const struct scallop_rational_crawler *c, slong order, slong precision,
                               const char **why)
{
  SCOPED(subject, s);
  SCOPED(fmpq, kept);
  struct scallop_bound bounds[2];
  const char *ends = "kept";
  enum scallop_status status;
  series_set_si(&s.phase.dxC, 7);
  series_set_si(&s.steady.displacement, 7);
  for (int i = 0; i < 2; i++)
    scallop_bound_init(&bounds[i]);
  bounds[1].power = 7;
  strcpy(s.phase.modes, "kept");
  strcpy(s.steady.modes, "kept");
  fmpq_set_si(s.v0, 2, 1);
  switch (what) {
  case EXPANDED: status = scallop_expand_steady(c, order, precision, &s.steady, why); break;
  case BOUNDED: status = scallop_steady_bounds(c, order, precision, bounds, why); break;
  case HOLDING: status = scallop_steady_modes_hold(c, precision, bounds[1].T_end, &ends, why); break;
  default:
    status = scallop_expand_phase(c, what == EXTENDING ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION, s.v0, order,
                                  precision, NULL, &s.phase, why);
  }
  const struct series *const sevens[] = { &s.phase.dxC, &s.steady.displacement };
  for (int i = 0; i < 2; i++) {
    assert_true(series_rational_coefficient(kept, sevens[i], 0) && fmpq_equal_si(kept, 7));
    assert_true(bounds[i].power == 7 * i && arb_is_zero(bounds[i].C) && arb_is_zero(bounds[i].T_end));
    scallop_bound_clear(&bounds[i]);
  }
  assert_string_equal(s.phase.modes, "kept");
  assert_string_equal(s.steady.modes, "kept");
  assert_string_equal(ends, "kept");
  return status;
}

/* By all of these, with a reason, also if it is not asked for, and the answer as it was */
static void refuses(int all, const struct scallop_rational_crawler *c, slong order, slong precision,
                    enum scallop_status wanted, const char *fragment)
{
  for (int what = 1; what <= all; what *= 2) {
    const char *why = NULL;
    if (!(what & all))
      continue;
    enum scallop_status status = ask(what, c, order, precision, &why);
    if (status != wanted || !why || !strstr(why, fragment))
      fail_msg("%s, order %ld, question %d: %s, not %s", c->gait->name, (long)order, what, why ? why : "no reason",
               fragment);
    assert_int_equal(ask(what, c, order, precision, NULL), wanted);
  }
}

static void no_gait(int all, const struct scallop_gait *gait, double alpha, const char *fragment)
{
  struct scallop_crawler c = with_gait(gait);
  SCOPED(scallop_rational, exact);
  c.alpha = alpha;
  scallop_rational_of(&exact, &c);
  refuses(all, &exact, 4, PRECISION, *fragment ? SCALLOP_EDOMAIN : SCALLOP_EUNDECIDED, fragment);
}

TEST(refusals)
{
  static const slong orders[] = { 0, -1, SCALLOP_MOST_TERMS + 1, WORD_MAX };
  struct scallop_crawler defaults = scallop_crawler_default();
  SCOPED(scallop_rational, c);
  scallop_rational_of(&c, &defaults);
  for (size_t i = 0; i < sizeof orders / sizeof *orders; i++)
    refuses(BOUNDS, &c, orders[i], PRECISION, SCALLOP_EDOMAIN, "order");
  refuses(ALL, &c, 4, 0, SCALLOP_EDOMAIN, "bits");
  refuses(ALL, &c, 4, 15, SCALLOP_EDOMAIN, "bits");
  fmpq *const fields[] = { c.m1, c.m2, c.F2, c.L, c.alpha };
  for (size_t i = 0; i < sizeof fields / sizeof *fields; i++) {
    fmpq_neg(fields[i], fields[i]);
    refuses(ALL, &c, 4, PRECISION, SCALLOP_EDOMAIN, "domain");
    fmpq_neg(fields[i], fields[i]);
  }
  fmpq_set(c.F1, c.F2);
  refuses(BOUNDED, &c, 4, PRECISION, SCALLOP_EDOMAIN, "F1 = F2");
  no_gait(BOUNDED, &scallop_gait_sinusoidal, 0.5, "alpha = 1/2");
}

TEST(gaits_without_an_expansion)
{
  struct teeth teeth;
  grow_teeth(&teeth);
  const struct scallop_gait backward = { "backward",
                                         { scallop_gait_quadratic.phase[1], scallop_gait_quadratic.phase[0] } };
  /* l' falls to 0 and jumps away from there, or jumps to 0 */
  static const struct scallop_piece to_0[] = { RUN(0, 0.5, 1, 2, -4), STRIDE(0.5, 1, 1) };
  static const struct scallop_piece from_0[] = { STRIDE(0, 0.5, 1), RUN(0.5, 1, 1, -2, 4) };
  struct scallop_gait falls = trapezoid_gait, rises = trapezoid_gait;
  falls.phase[0].pieces = to_0;
  rises.phase[0].pieces = from_0;
  falls.phase[0].count = rises.phase[0].count = 2;
  const struct scallop_gait *const within[] = { &falls,       &rises,      &there_and_back_gait,
                                                &detour_gait, &teeth.gait, &backward };
  for (int i = 0; i < 12; i++)
    no_gait(EXTENDING | EXPANDED | BOUNDED, within[i / 2], i % 2 ? 0.5 : 0.75, "within a phase");
  no_gait(MOVING, &parabola_gait, 0.5, "anchored elsewhere");            /* crossings at an end that is not an anchor */
  no_gait(EXTENDING | CONTRACTING, &minimum_jerk_gait, 0.75, "l'' = 0"); /* at the ends of its phases */
  no_gait(EXPANDED, &minimum_jerk_gait, 0.5, "l'' = 0");
  no_gait(EXPANDED, &sawtooth_gait, 0.5, "jumps");
  no_gait(EXPANDED | BOUNDED | HOLDING, &sawtooth_gait, 0.6875, "");
}

/* One phase, or one piece of it, without a law is enough. */
TEST(gaits_without_a_law)
{
  struct scallop_piece lawless[2][2];
  for (int kind = 0; kind < 2; kind++)
    for (int piece = 0; piece < 2; piece++) {
      struct scallop_gait gait = scallop_gait_sinusoidal;
      memcpy(lawless[kind], gait.phase[kind].pieces, sizeof lawless[kind]);
      gait.phase[kind].pieces = lawless[kind];
      assert_true(scallop_gait_is_exact(&gait) && !scallop_gait_is_rational(&gait));
      lawless[kind][piece].law = NULL;
      assert_true(!scallop_gait_is_exact(&gait) && !scallop_gait_is_rational(&gait));
      no_gait(BOUNDS, &gait, 0.75, "no exact law");
    }
}

/* A sine has exact coefficients at its zero only, and does not go on as a polynomial nor the other way round. */
TEST(sines_and_polynomials)
{
  const struct scallop_piece *sine = scallop_gait_sinusoidal.phase[0].pieces,
                             *ramp = scallop_gait_quadratic.phase[0].pieces;
  bool turned;
  SCOPED(fmpq_poly, series);
  SCOPED(fmpq, u, ten);
  fmpq_set_si(ten, 10, 1);
  assert_true(scallop_piece_continues(&sine[0], &sine[1], &turned) && turned);
  assert_false(scallop_piece_continues(&sine[0], &ramp[1], &turned));
  assert_false(scallop_piece_continues(&ramp[0], &sine[1], &turned));
  assert_true(scallop_rational_speed_series(series, &sine[0], u, 4, ten));
  assert_int_equal(fmpq_poly_degree(series), 3);
  assert_false(scallop_rational_speed_series(series, &sine[0], u, 4, NULL));
  fmpq_set_si(u, 1, 4);
  assert_false(scallop_rational_speed_series(series, &sine[0], u, 4, ten));
  assert_true(scallop_rational_speed_series(series, &ramp[0], u, 4, NULL));
}

/* At m1 = 0.08627301503..., otherwise the default crawler, body 2 ceases to turn in the contraction as T -> 0. Near
 * that, above it, the limit is either refused or the one with the right modes: an extrapolation from the other side
 * would be smooth and wrong. */
TEST(limit_near_a_touch)
{
  struct scallop_crawler defaults = with_gait(&scallop_gait_sinusoidal);
  static const char *const masses[] = {
    "0.0863", "0.0862731", "0.086273115", "0.0862730151", "0.08627301504", "0.0862"
  };
  int refused = 0;
  SCOPED(subject, s);
  scallop_rational_of(&s.crawler, &defaults);
  for (size_t i = 0; i < sizeof masses / sizeof *masses; i++) {
    assert_true(scallop_rational_parse(s.crawler.m1, masses[i]));
    enum scallop_status status = scallop_expand_steady(&s.crawler, 4, PRECISION, &s.steady, NULL);
    bool turns = fmpq_get_d(s.crawler.m1) > 0.08627301503417;
    assert_true(status == SCALLOP_OK || status == SCALLOP_EUNDECIDED);
    refused += status != SCALLOP_OK;
    if (status == SCALLOP_OK)
      assert_string_equal(s.steady.modes, turns ? "++ -+ ++ | ++ +- ++" : "++ -+ ++ | ++");
  }
  assert_true(refused < (int)(sizeof masses / sizeof *masses));
}
