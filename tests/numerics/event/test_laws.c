/* The intervals of a phase put back into Newton's law, the friction law, and the momentum and energy
 * balances, for thousands of random crawlers. Newton's law with Coulomb's inclusion has one solution
 * (uniqueness: docs/background/theory.md), so an interval list that passes everything here is that solution.
 *
 * Units as in struct scallop_interval: lengths in L, times in the duration tau of the phase, masses in
 * M, forces in M L / tau^2, so friction is eps f_i with eps = tau^2 (F1 + F2)/(M L).
 *
 * Tolerances: ROUNDINGS unit roundoffs (DBL_EPSILON/2) times the sum of the absolute values of the
 * terms of the sum that is checked. ROUNDINGS = 16: an end of an interval comes from one division or
 * one Newton correction of a function with about ten operations on those terms, and the check repeats
 * as many. The largest share of the tolerance that was used is printed. */
#include <float.h>

#include <gsl/gsl_integration.h>

#include "tests/support/interval.h"
#include "tests/support/random_crawler.h"
#include "tests/support/solved.h"

enum { ROUNDINGS = 16, KEPT = 64, NODES = 24, SAMPLES = 7, CRAWLERS = 400 };
enum { STEEPEST_BEND = 60 }; /* max |l'''| of all gaits here: minimum jerk at its ends */
#define ROUNDOFF (ROUNDINGS * (0.5 * DBL_EPSILON))

struct phase { /* one phase, its intervals, and the parameters in scaled units */
  struct scallop_crawler crawler;
  enum scallop_phase_kind kind;
  double v0, tau, unit;
  double force;              /* what a force is multiplied by */
  double mu[2], friction[2]; /* m_i/M, eps f_i */
  struct scallop_interval interval[KEPT];
  int count;
};

static gsl_integration_glfixed_table *nodes;
static double worst_share;
static const struct phase *current;

static void describe(void)
{
  print_crawler(&current->crawler);
  print_error("%s, v0=%.17g\n", current->kind ? "contraction" : "extension", current->v0);
  for (int i = 0; i < current->count; i++) {
    const struct scallop_interval *v = &current->interval[i];
    print_error("  u %.17g..%.17g mode %d %d c %.17g..%.17g slope %.17g glue %.17g x %.17g\n", v->u_begin, v->u_end,
                v->mode.s1, v->mode.s2, v->c_begin, v->c_end, v->c_slope, v->glue, v->x_begin);
  }
}

/* |got - wanted| <= tolerance, with the phase printed if not. */
static void near(const char *what, double got, double wanted, double tolerance, int line)
{
  double share = tolerance > 0 ? fabs(got - wanted) / tolerance : 0;
  if (share > worst_share && share <= 1)
    worst_share = share;
  if (!check_near(got, wanted, tolerance)) {
    describe();
    check_fail(what, got, wanted, tolerance, "absolute", __FILE__, line);
  }
}
#define NEAR(got, wanted, tolerance) near(#got, got, wanted, tolerance, __LINE__)
#define AT_LEAST(got, bound, tolerance) near(#got, fmin(got, bound), bound, tolerance, __LINE__)

static void require(bool holds, const char *what, int line)
{
  if (!holds) {
    describe();
    print_error("%s does not hold\n", what);
    _fail(__FILE__, line);
  }
}
#define REQUIRE(condition) require(condition, #condition, __LINE__)

static int sign_of(const struct scallop_interval *i, int body) { return body == 0 ? i->mode.s1 : i->mode.s2; }

static double centre(const struct scallop_interval *i, double u)
{
  return glued(i) ? i->glue * rate(i, u) : i->c_begin + i->c_slope * (sense(i) * (u - i->u_begin));
}

/* velocity of a body: c - mu2 l', c + mu1 l' */
static double velocity(const struct phase *p, const struct scallop_interval *i, int body, double u)
{
  return centre(i, u) + (body == 0 ? -p->mu[1] : p->mu[0]) * rate(i, u);
}

/* The force of the linkage on body 2, from Newton's law for a body that slides. */
static double linkage_force(const struct phase *p, const struct scallop_interval *i, double u)
{
  double centre_acceleration = glued(i) ? i->glue * bend(i, u) : i->c_slope;
  if (i->mode.s2 != 0)
    return p->mu[1] * (centre_acceleration + p->mu[0] * bend(i, u)) + p->friction[1] * i->mode.s2;
  return -(p->mu[0] * (centre_acceleration - p->mu[1] * bend(i, u)) + p->friction[0] * i->mode.s1);
}

static double largest_bend(const struct scallop_interval *i)
{
  return fmax(fabs(bend(i, i->u_begin)), fabs(bend(i, i->u_end)));
}

/* What a velocity in this interval is a sum of, in absolute values; the time of an event is uncertain
 * by a rounding of u, which is the last term. */
static double size(const struct phase *p, const struct scallop_interval *i, int body)
{
  double mu = p->mu[1 - body], u = fmax(i->u_begin, i->u_end);
  double c = fmax(fabs(i->c_begin), fabs(i->c_end)), l = fmax(fabs(rate(i, i->u_begin)), fabs(rate(i, i->u_end)));
  return c + mu * l + (fabs(i->c_slope) + mu * largest_bend(i)) * u;
}

/* Friction on both bodies while they slide. F1 - F2 from the inputs: it can be small. */
static double total_friction(const struct phase *p, const struct scallop_interval *i)
{
  return -p->force * (p->crawler.F1 * i->mode.s1 + p->crawler.F2 * i->mode.s2);
}

/* Both bodies slide: mu1 x1'' + mu2 x2'' = friction. One is stuck: its acceleration is zero. */
static void newton(const struct phase *p, const struct scallop_interval *i)
{
  if (!glued(i)) {
    double wanted = total_friction(p, i);
    NEAR(i->c_slope, wanted, ROUNDOFF * fabs(wanted));
    return;
  }
  REQUIRE(i->mode.s1 != 0 || i->mode.s2 != 0);
  int stuck = i->mode.s1 == 0 ? 0 : 1, other = 1 - stuck;
  NEAR(i->glue, stuck == 0 ? p->mu[1] : -p->mu[0], ROUNDOFF * p->mu[other]);
  NEAR(i->c_begin, i->glue * rate(i, i->u_begin), ROUNDOFF * size(p, i, stuck));
  NEAR(i->c_end, i->glue * rate(i, i->u_end), ROUNDOFF * size(p, i, stuck));
  /* it has to be held against -m_other (acceleration of the other) - its friction; l'' is monotone */
  const double ends[] = { i->u_begin, i->u_end };
  for (int e = 0; e < 2; e++) {
    double pull = (stuck == 0 ? 1 : -1) * p->mu[other] * bend(i, ends[e]);
    double needed = pull + p->friction[other] * sign_of(i, other);
    double terms = p->mu[other] * largest_bend(i) + p->friction[0] + p->friction[1];
    double rounded_u = DBL_EPSILON * ends[e] * p->mu[other] * STEEPEST_BEND;
    AT_LEAST(p->friction[stuck] - fabs(needed), 0, ROUNDOFF * terms + rounded_u);
  }
}

/* Where the velocity of a body turns: slope = mu l''. By bisection, as l'' is monotone. */
static double turning_point(const struct phase *p, const struct scallop_interval *i, int body)
{
  double level = i->c_slope / (body == 0 ? p->mu[1] : -p->mu[0]), a = i->u_begin, b = i->u_end;
  bool rises = bend(i, b) > bend(i, a);
  for (double mid; (mid = 0.5 * (a + b)) != a && mid != b;)
    *((bend(i, mid) <= level) == rises ? &a : &b) = mid;
  return a;
}

static void sliding_sign(const struct phase *p, const struct scallop_interval *i, int body)
{
  int sign = sign_of(i, body);
  double tolerance = ROUNDOFF * size(p, i, body);
  if (sign == 0)
    return;
  AT_LEAST(sign * velocity(p, i, body, i->u_end), 0, tolerance);
  AT_LEAST(sign * velocity(p, i, body, i->u_begin), 0, tolerance);
  if (!glued(i))
    AT_LEAST(sign * velocity(p, i, body, turning_point(p, i, body)), 0, tolerance);
  double largest = 0;
  for (int k = 1; k <= SAMPLES; k++) {
    double v = sign * velocity(p, i, body, i->u_begin + (i->u_end - i->u_begin) * k / (SAMPLES + 1));
    AT_LEAST(v, 0, tolerance);
    largest = fmax(largest, v);
  }
  /* strictly the right sign inside, unless the interval is too short to tell it from a rounding */
  double change = (fabs(i->c_slope) + p->mu[1 - body] * largest_bend(i)) * duration(i);
  REQUIRE(largest > 0 || change <= tolerance);
}

static void order_and_continuity(const struct phase *p)
{
  const char *wrong = disorder(p->interval, p->count, &p->crawler.gait->phase[p->kind]);
  require(!wrong, wrong, __LINE__);
  const struct scallop_interval *first = p->interval;
  for (const struct scallop_interval *b = first + 1; b < first + p->count; b++)
    REQUIRE(b[-1].c_end == b->c_begin);
  NEAR(first->c_begin, p->v0 / p->unit, ROUNDOFF * fabs(p->v0 / p->unit));
}

struct integral {
  double value, terms;
}; /* terms: the integral of what was summed, in absolute values */

enum integrand { WORK, DISSIPATION, CENTRE, BODY_1, BODY_2 };

static double summand(const struct phase *p, const struct scallop_interval *i, enum integrand what, double u,
                      double *terms)
{
  double l = rate(i, u), c = centre(i, u), mu1 = p->mu[0], mu2 = p->mu[1];
  double size1 = fabs(c) + mu2 * fabs(l), size2 = fabs(c) + mu1 * fabs(l);
  switch (what) {
  case WORK:
    *terms = (mu1 * mu2 * fabs(bend(i, u)) + p->friction[0] + p->friction[1]) * fabs(l);
    return linkage_force(p, i, u) * l;
  case DISSIPATION:
    *terms = p->friction[0] * size1 + p->friction[1] * size2;
    return p->friction[0] * i->mode.s1 * velocity(p, i, 0, u) + p->friction[1] * i->mode.s2 * velocity(p, i, 1, u);
  case CENTRE: return *terms = fabs(c), c;
  case BODY_1: return *terms = size1, velocity(p, i, 0, u);
  default: return *terms = size2, velocity(p, i, 1, u);
  }
}

/* Gauss-Legendre; exact for linear pieces and minimum jerk, to rounding for the sine. */
static struct integral integrate(const struct phase *p, const struct scallop_interval *i, enum integrand what)
{
  struct integral sum = { 0, 0 };
  for (size_t k = 0; k < NODES; k++) {
    double x, weight, terms;
    gsl_integration_glfixed_point(0, 1, k, &x, &weight, nodes);
    sum.value += weight * duration(i) * summand(p, i, what, i->u_begin + (i->u_end - i->u_begin) * x, &terms);
    sum.terms += weight * duration(i) * terms;
  }
  return sum;
}

static double kinetic(const struct phase *p, double c, double l) { return 0.5 * (c * c + p->mu[0] * p->mu[1] * l * l); }

static void energy_balance(const struct phase *p, const struct scallop_interval *i)
{
  struct integral work = integrate(p, i, WORK), lost = integrate(p, i, DISSIPATION);
  double before = kinetic(p, i->c_begin, rate(i, i->u_begin)), after = kinetic(p, i->c_end, rate(i, i->u_end));
  /* c_end is known to a rounding of the velocities that meet there */
  double at_end = fabs(i->c_end) * fmax(size(p, i, 0), size(p, i, 1));
  NEAR(after - before, work.value - lost.value, ROUNDOFF * (before + after + work.terms + lost.terms + at_end));
}

static void momentum_balance(const struct phase *p)
{
  double impulse = 0, terms = 0, jumps = 0;
  for (int k = 0; k < p->count; k++) {
    const struct scallop_interval *i = &p->interval[k];
    double one = friction_impulse(i, p->mu, total_friction(p, i));
    NEAR(i->c_end - i->c_begin, one, ROUNDOFF * fmax(size(p, i, 0), size(p, i, 1)));
    impulse += one;
    terms += fabs(one);
    jumps += fmax(size(p, i, 0), size(p, i, 1));
  }
  NEAR(p->interval[p->count - 1].c_end - p->interval[0].c_begin, impulse, ROUNDOFF * (terms + jumps));
}

static bool same_mode(struct scallop_mode a, struct scallop_mode b) { return a.s1 == b.s1 && a.s2 == b.s2; }

static double from_start(const struct scallop_interval *i, double u) { return sense(i) > 0 ? u : 1 - u; }
static double from_end(const struct scallop_interval *i, double u) { return sense(i) > 0 ? 1 - u : u; }

static void modes_and_times(const struct phase *p, const struct scallop_phase_result *r)
{
  double t1 = NAN, dT = NAN;
  int count = 1;
  REQUIRE(same_mode(r->modes.kept[0], p->interval[0].mode));
  for (int k = 1; k < p->count; k++) {
    const struct scallop_interval *i = &p->interval[k];
    if (same_mode(i->mode, i[-1].mode))
      continue;
    REQUIRE(count < r->modes.count && same_mode(r->modes.kept[count], i->mode));
    if (count++ == 1)
      t1 = from_start(i, i->u_begin) * p->tau;
    dT = from_end(i, i->u_begin) * p->tau;
  }
  REQUIRE(r->modes.count == count);
  NEAR(r->t1, t1, ROUNDOFF * fabs(t1));
  NEAR(r->dT, dT, ROUNDOFF * fabs(dT));
}

static void regime(const struct phase *p, const struct scallop_phase_result *r)
{
  bool any = false, always[2] = { true, true };
  for (int k = 0; k < p->count; k++) {
    any |= glued(&p->interval[k]);
    for (int body = 0; body < 2; body++)
      always[body] &= sign_of(&p->interval[k], body) == 0;
  }
  REQUIRE(r->regime == (always[0] || always[1] ? SCALLOP_AT_REST : any ? SCALLOP_STICK_SLIP : SCALLOP_SLIDING));
}

static void displacements(const struct phase *p, const struct scallop_phase_result *r)
{
  double L = p->crawler.L, stroke = p->kind == SCALLOP_EXTENSION ? 1 : -1;
  double difference = (p->crawler.m1 - p->crawler.m2) / (p->crawler.m1 + p->crawler.m2);
  struct integral x1 = { 0, 0 }, x2 = { 0, 0 }, c = { 0, 0 };
  for (int k = 0; k < p->count; k++) {
    const struct scallop_interval *i = &p->interval[k];
    struct integral one = integrate(p, i, BODY_1), two = integrate(p, i, BODY_2), both = integrate(p, i, CENTRE);
    /* an end at a curve is off by a rounding of what meets there, for the whole interval */
    double loose = fmax(size(p, i, 0), size(p, i, 1)) * duration(i);
    NEAR(i->x_begin, c.value, ROUNDOFF * c.terms);
    x1 = (struct integral){ x1.value + one.value, x1.terms + one.terms };
    x2 = (struct integral){ x2.value + two.value, x2.terms + two.terms };
    c = (struct integral){ c.value + both.value, c.terms + both.terms + loose };
  }
  NEAR(r->dx1 / L, x1.value, ROUNDOFF * (x1.terms + c.terms));
  NEAR(r->dx2 / L, x2.value, ROUNDOFF * (x2.terms + c.terms));
  NEAR(r->dxC / L, c.value + 0.5 * difference * stroke, ROUNDOFF * (c.terms + 0.5 * fabs(difference)));
  NEAR(r->dx2 - r->dx1, stroke * L, ROUNDOFF * (fabs(r->dx1) + fabs(r->dx2)));
}

static void keep(void *context, const struct scallop_interval *interval)
{
  struct phase *p = context;
  assert_true(p->count < KEPT);
  p->interval[p->count++] = *interval;
}

static void check_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0)
{
  double tau = scallop_phase_duration(crawler, kind), M = crawler->m1 + crawler->m2;
  double force = tau * tau / (M * crawler->L);
  struct phase p = { .crawler = *crawler,
                     .kind = kind,
                     .v0 = v0,
                     .tau = tau,
                     .unit = crawler->L / tau,
                     .force = force,
                     .mu = { crawler->m1 / M, crawler->m2 / M },
                     .friction = { force * crawler->F1, force * crawler->F2 } };
  current = &p;
  assert_int_equal(scallop_phase_intervals(crawler, kind, v0, keep, &p), SCALLOP_OK);
  struct scallop_phase_result r = phase_of(crawler, kind, v0);
  order_and_continuity(&p);
  for (int k = 0; k < p.count; k++) {
    const struct scallop_interval *i = &p.interval[k];
    newton(&p, i);
    sliding_sign(&p, i, 0);
    sliding_sign(&p, i, 1);
    energy_balance(&p, i);
  }
  momentum_balance(&p);
  modes_and_times(&p, &r);
  regime(&p, &r);
  displacements(&p, &r);
  NEAR(r.v_end, p.interval[p.count - 1].c_end * p.unit, ROUNDOFF * fabs(r.v_end));
}

static void family(enum family which, uint64_t seed)
{
  struct random r = { seed };
  worst_share = 0;
  for (int gait = 0; gait < ALL_GAITS; gait++)
    for (int n = 0; n < check_cases(CRAWLERS); n++) {
      struct scallop_crawler c = random_crawler(&r, which, every_gait[gait]);
      for (int kind = 0; kind < 2; kind++) {
        check_phase(&c, (enum scallop_phase_kind)kind, 0);
        check_phase(&c, (enum scallop_phase_kind)kind, random_start(&r, &c, (enum scallop_phase_kind)kind));
      }
    }
  print_message("largest share of a tolerance used: %.2g\n", worst_share);
}

TEST(ordinary) { family(ORDINARY, 1); }
TEST(stick_slip) { family(STICK_SLIP, 2); }
TEST(extreme_ratios) { family(EXTREME_RATIOS, 3); }
TEST(small_period) { family(SMALL_PERIOD, 4); }
TEST(equal_forces) { family(EQUAL_FORCES, 5); }
TEST(nearly_equal_forces) { family(NEARLY_EQUAL_FORCES, 6); }
TEST(alpha_edge) { family(ALPHA_EDGE, 7); }

/* A body that is stuck for all of the phase does not move: 0, and not a rounding. */
TEST(at_rest_means_zero)
{
  struct random r = { 9 };
  int found = 0;
  for (int n = 0; n < 10 * CRAWLERS; n++) {
    struct scallop_crawler c = random_crawler(&r, STICK_SLIP, every_gait[n % SMOOTH_GAITS]);
    struct phase p = { .crawler = c, .kind = n / SMOOTH_GAITS % 2 ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION };
    current = &p;
    struct scallop_phase_result result = phase_of(&c, p.kind, 0);
    if (result.regime != SCALLOP_AT_REST)
      continue;
    found++;
    NEAR(fmin(fabs(result.dx1), fabs(result.dx2)), 0, 0);
  }
  assert_true(found > 20);
}

/* The phases of the steady state, where the start velocity is not arbitrary. */
TEST(steady_phases)
{
  struct random r = { 8 };
  for (int n = 0; n < check_cases(CRAWLERS * FAMILIES); n++) {
    struct scallop_crawler c = random_crawler(&r, (enum family)(n % FAMILIES), every_gait[n % SMOOTH_GAITS]);
    struct scallop_steady_result s = steady_of(&c);
    check_phase(&c, SCALLOP_EXTENSION, s.period.v_start);
    check_phase(&c, SCALLOP_CONTRACTION, s.period.v_mid);
  }
}

static int set_up(void **state)
{
  (void)state;
  nodes = gsl_integration_glfixed_table_alloc(NODES);
  return nodes == NULL;
}

static int tear_down(void **state)
{
  (void)state;
  gsl_integration_glfixed_table_free(nodes);
  return 0;
}

int main(void) { return check_run(set_up, tear_down); }
