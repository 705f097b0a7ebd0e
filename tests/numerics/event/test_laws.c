/* The intervals of a phase put back into Newton's law, the friction law, and the momentum and energy
 * balances, for thousands of random crawlers. Newton's law with Coulomb's inclusion has one solution
 * (uniqueness: docs/background/theory.md), so an interval list that passes everything here is that solution.
 *
 * Tolerances: ROUNDINGS unit roundoffs (DBL_EPSILON/2) times the sum of the absolute values of the
 * terms of the sum that is checked. ROUNDINGS = 16: an end of an interval comes from one division or
 * one Newton correction of a function with about ten operations on those terms, and the check repeats
 * as many. The largest share of the tolerance that was used is printed. */
#include <float.h>

#include "tests/support/laws.h"
#include "tests/support/random_crawler.h"
#include "tests/support/solved.h"

enum { ROUNDINGS = 16, KEPT = 64, CRAWLERS = 400 };
enum { STEEPEST_BEND = 60 }; /* max |l'''| of all gaits here: minimum jerk at its ends */
#define ROUNDOFF (ROUNDINGS * (0.5 * DBL_EPSILON))

struct kept {
  struct scallop_interval interval[KEPT];
  int count;
};

static int at_rest;

static void law_is_broken(const struct law_phase *p, const struct scallop_interval *culprit, const char *what,
                          double got, double wanted, double tolerance, int line)
{
  print_crawler(&p->crawler);
  print_error("%s, v0=%.17g, interval %d\n", p->kind ? "contraction" : "extension", p->v0,
              culprit ? (int)(culprit - p->interval) : -1);
  for (const struct scallop_interval *v = p->interval; v < p->interval + p->count; v++)
    print_error("  u %.17g..%.17g mode %d %d c %.17g..%.17g slope %.17g glue %.17g x %.17g\n", v->u_begin, v->u_end,
                v->mode.s1, v->mode.s2, v->c_begin, v->c_end, v->c_slope, v->glue, v->x_begin);
  check_fail(what, got, wanted, tolerance, "absolute", __FILE__, line);
}

#define AT_LEAST(i, got, terms) LAW(i, fmin(got, 0), 0, terms)
#define REQUIRE(condition) \
  do { \
    if (!(condition)) \
      law_is_broken(p, NULL, #condition, 0, 1, 0, __LINE__); \
  } while (0)

static int sign_of(const struct scallop_interval *i, int body) { return body == 0 ? i->mode.s1 : i->mode.s2; }

static double largest_bend(const struct scallop_interval *i)
{
  return fmax(fabs(bend(i, i->u_begin)), fabs(bend(i, i->u_end)));
}

/* A stuck body has to be held against -m_other (acceleration of the other) - its friction; l'' is monotone. */
static void is_constant(const struct law_phase *p, const struct scallop_interval *i)
{
  int stuck = i->mode.s1 == 0 ? 0 : 1, other = 1 - stuck;
  const double ends[] = { i->u_begin, i->u_end };
  for (int e = 0; e < 2; e++) {
    double pull = (stuck == 0 ? 1 : -1) * p->mu[other] * bend(i, ends[e]);
    double needed = pull + p->f[other] * sign_of(i, other);
    double terms = p->mu[other] * largest_bend(i) + p->f[0] + p->f[1];
    AT_LEAST(i, p->f[stuck] - fabs(needed), terms + 2. / ROUNDINGS * ends[e] * p->mu[other] * STEEPEST_BEND);
  }
}

/* Where the velocity of a body turns: slope = mu l''. By bisection, as l'' is monotone; where it does not, an end */
static double turning_point(const struct law_phase *p, const struct scallop_interval *i, int body)
{
  double level = i->c_slope / (body == 0 ? p->mu[1] : -p->mu[0]), a = i->u_begin, b = i->u_end;
  if ((bend(i, a) <= level) == (bend(i, b) <= level))
    return a;
  bool rises = bend(i, b) > bend(i, a);
  for (double mid; (mid = 0.5 * (a + b)) != a && mid != b;)
    *((bend(i, mid) <= level) == rises ? &a : &b) = mid;
  return a;
}

/* No velocity has another sign where it turns than at the ends, nor in the middle. */
static void sliding_sign(const struct law_phase *p, const struct scallop_interval *i, int body)
{
  int sign = sign_of(i, body);
  double size = law_size_of(p, i, body), largest = 0;
  for (int k = 0; k < (glued(i) ? 1 : 2) && sign != 0; k++) {
    double u = k == 0 ? 0.5 * (i->u_begin + i->u_end) : turning_point(p, i, body);
    double c = glued(i) ? i->glue * rate(i, u) : i->c_begin + i->c_slope * (sense(i) * (u - i->u_begin));
    double v = sign * law_velocity(p, i, body, c, u);
    AT_LEAST(i, v, size);
    largest = fmax(largest, v);
  }
  /* strictly the right sign inside, unless the interval is too short to tell it from a rounding */
  double change = (fabs(i->c_slope) + p->mu[1 - body] * largest_bend(i)) * duration(i);
  REQUIRE(sign == 0 || largest > 0 || change <= ROUNDOFF * size);
}

static bool same_mode(struct scallop_mode a, struct scallop_mode b) { return a.s1 == b.s1 && a.s2 == b.s2; }

static double from_start(const struct scallop_interval *i, double u) { return sense(i) > 0 ? u : 1 - u; }
static double from_end(const struct scallop_interval *i, double u) { return sense(i) > 0 ? 1 - u : u; }

static void modes_and_times(const struct law_phase *p, const struct scallop_phase_result *r)
{
  double t1 = NAN, dT = NAN, tau = scallop_phase_duration(&p->crawler, p->kind);
  int count = 1;
  REQUIRE(same_mode(r->modes.kept[0], p->interval[0].mode));
  for (int k = 1; k < p->count; k++) {
    const struct scallop_interval *i = &p->interval[k];
    if (same_mode(i->mode, i[-1].mode))
      continue;
    REQUIRE(count < r->modes.count && same_mode(r->modes.kept[count], i->mode));
    if (count++ == 1)
      t1 = from_start(i, i->u_begin) * tau;
    dT = from_end(i, i->u_begin) * tau;
  }
  REQUIRE(r->modes.count == count);
  REQUIRE(check_relative(r->t1, t1, ROUNDOFF) && check_relative(r->dT, dT, ROUNDOFF));
}

/* A body that is stuck for all of the phase does not move: 0, and not a rounding. */
static void regime(const struct law_phase *p, const struct scallop_phase_result *r)
{
  bool any = false, always[2] = { true, true };
  for (int k = 0; k < p->count; k++) {
    any |= glued(&p->interval[k]);
    for (int body = 0; body < 2; body++)
      always[body] &= sign_of(&p->interval[k], body) == 0;
  }
  REQUIRE(r->regime == (always[0] || always[1] ? SCALLOP_AT_REST : any ? SCALLOP_STICK_SLIP : SCALLOP_SLIDING));
  REQUIRE((!always[0] || r->dx1 == 0) && (!always[1] || r->dx2 == 0));
  at_rest += always[0] || always[1];
}

/* c is a multiple of l' or linear in time: its integral is a multiple of the change of l, or a trapezium. */
static void displacements(const struct law_phase *p, const struct scallop_phase_result *r)
{
  double L = p->crawler.L, stroke = p->kind == SCALLOP_EXTENSION ? 1 : -1, x = 0, terms = 0, ways = 0;
  double difference = (p->crawler.m1 - p->crawler.m2) / (p->crawler.m1 + p->crawler.m2);
  for (const struct scallop_interval *i = p->interval; i < p->interval + p->count; i++) {
    double l = length(i, i->u_end) - length(i, i->u_begin);
    LAW(i, i->x_begin, x, terms);
    x += glued(i) ? i->glue * l : 0.5 * (i->c_begin + i->c_end) * duration(i);
    /* an end at a curve is off by a rounding of what meets there, for the whole interval */
    terms += law_size(p, i) * duration(i);
    ways += fabs(l);
  }
  LAW(NULL, r->dx1 / L, x - p->mu[1] * stroke, terms + p->mu[1] * ways);
  LAW(NULL, r->dx2 / L, x + p->mu[0] * stroke, terms + p->mu[0] * ways);
  LAW(NULL, r->dxC / L, x + 0.5 * difference * stroke, terms + 0.5 * fabs(difference));
  LAW(NULL, r->dx2 - r->dx1, stroke * L, fabs(r->dx1) + fabs(r->dx2));
}

static void keep(void *context, const struct scallop_interval *interval)
{
  struct kept *k = context;
  assert_true(k->count < KEPT);
  k->interval[k->count++] = *interval;
}

static void check_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0)
{
  struct kept kept = { .count = 0 };
  assert_int_equal(scallop_phase_intervals(crawler, kind, v0, keep, &kept), SCALLOP_OK);
  const struct law_phase phase = law_phase_of(crawler, kind, v0, ROUNDINGS, kept.interval, kept.count), *p = &phase;
  struct scallop_phase_result r = phase_of(crawler, kind, v0);
  laws_hold(p, &r);
  for (const struct scallop_interval *i = p->interval; i < p->interval + p->count; i++) {
    REQUIRE(i == p->interval || i[-1].c_end == i->c_begin);
    if (glued(i))
      is_constant(p, i);
    sliding_sign(p, i, 0);
    sliding_sign(p, i, 1);
  }
  modes_and_times(p, &r);
  regime(p, &r);
  displacements(p, &r);
}

static void family(enum family which, uint64_t seed)
{
  struct random r = { seed };
  law_worst_share = 0;
  for (int gait = 0; gait < ALL_GAITS; gait++)
    for (int n = 0; n < check_cases(CRAWLERS); n++) {
      struct scallop_crawler c = random_crawler(&r, which, every_gait[gait]);
      for (int kind = 0; kind < 2; kind++) {
        check_phase(&c, (enum scallop_phase_kind)kind, 0);
        check_phase(&c, (enum scallop_phase_kind)kind, random_start(&r, &c, (enum scallop_phase_kind)kind));
      }
    }
  print_message("largest share of a tolerance used: %.2g\n", law_worst_share);
}

TEST(ordinary) { family(ORDINARY, 1); }
TEST(stick_slip) { family(STICK_SLIP, 2); }
TEST(extreme_ratios) { family(EXTREME_RATIOS, 3); }
TEST(small_period) { family(SMALL_PERIOD, 4); }
TEST(equal_forces) { family(EQUAL_FORCES, 5); }
TEST(nearly_equal_forces) { family(NEARLY_EQUAL_FORCES, 6); }
TEST(alpha_edge) { family(ALPHA_EDGE, 7); }

/* The phases of the steady state, where the start velocity is not arbitrary. Of all phases some were at rest. */
TEST(steady_phases)
{
  struct random r = { 8 };
  for (int n = 0; n < check_cases(CRAWLERS * FAMILIES); n++) {
    struct scallop_crawler c = random_crawler(&r, (enum family)(n % FAMILIES), every_gait[n % SMOOTH_GAITS]);
    struct scallop_steady_result s = steady_of(&c);
    check_phase(&c, SCALLOP_EXTENSION, s.period.v_start);
    check_phase(&c, SCALLOP_CONTRACTION, s.period.v_mid);
  }
  assert_true(at_rest > 20);
}
