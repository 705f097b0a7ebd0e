/* The exact solver against a slow reference that knows no events: Moreau's time stepping, implicit in
 * the velocity. Its error is first order: it must halve with the step, from the first step size on, and
 * stay below a constant times the step. That pins the exact result without sharing a line with it.
 *
 * With c the velocity of the centre of mass, one step of size h is the inclusion
 *     c_new in c_old - h (F1 Sgn(c_new - (m2/M) l') + F2 Sgn(c_new + (m1/M) l'))/M,
 * l' at the end of the step. Source: J. J. Moreau, Comput. Methods Appl. Mech. Eng. 177 (1999) 329. */
#include "tests/check.h"

#include "numerics/numerics.h"
#include "tests/random_crawler.h"
#include "tests/solved.h"

enum { COARSEST = 512, LEVELS = 4, CRAWLERS = 48 };

/* The one c with c + k_high Sgn(c - high) + k_low Sgn(c - low) containing `old`, high >= low. From the
 * top: where c is above both kinks, on the upper one, between, on the lower one, below. */
static double resolvent(double old, double high, double k_high, double low, double k_low)
{
  if (old - k_high - k_low > high)
    return old - k_high - k_low;
  if (old + k_high - k_low >= high)
    return high;
  if (old + k_high - k_low > low)
    return old + k_high - k_low;
  if (old + k_high + k_low >= low)
    return low;
  return old + k_high + k_low;
}

struct state {
  double c, x;
}; /* velocity and position of the centre of mass */

static void step_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, int steps, struct state *s)
{
  double M = crawler->m1 + crawler->m2, tau = scallop_phase_duration(crawler, kind), h = tau / steps;
  double k1 = h * crawler->F1 / M, k2 = h * crawler->F2 / M;
  for (int n = 1; n <= steps; n++) {
    double rate;
    scallop_gait_at(crawler->gait, kind, (double)n / steps, NULL, &rate, NULL);
    rate *= crawler->L / tau;
    double rest1 = crawler->m2 / M * rate, rest2 = -crawler->m1 / M * rate; /* c where a body is at rest */
    s->c = rest1 >= rest2 ? resolvent(s->c, rest1, k1, rest2, k2) : resolvent(s->c, rest2, k2, rest1, k1);
    s->x += h * s->c;
  }
}

static struct state step_period(const struct scallop_crawler *crawler, double v0, int steps)
{
  struct state s = { v0, 0 };
  step_phase(crawler, SCALLOP_EXTENSION, steps, &s);
  step_phase(crawler, SCALLOP_CONTRACTION, steps, &s);
  return s;
}

/* The fixed point of the stepped map. The map is monotone and nonexpansive, so v_end - v_start falls. */
static double step_steady(const struct scallop_crawler *crawler, int steps)
{
  double M = crawler->m1 + crawler->m2, fraction = fmin(crawler->alpha, 1 - crawler->alpha);
  double high = 3 * crawler->L / (crawler->T * fraction) + crawler->T * (crawler->F1 + crawler->F2) / M, low = -high;
  for (int i = 0; i < 60; i++) {
    double mid = 0.5 * (low + high);
    *(step_period(crawler, mid, steps).c > mid ? &low : &high) = mid;
  }
  return 0.5 * (low + high);
}

/* Errors against the solver: velocities in L/T, lengths in L */
enum { V_EXTENSION, X_EXTENSION, V_CONTRACTION, X_CONTRACTION, V_PERIOD, X_PERIOD, V_STEADY, X_STEADY, QUANTITIES };

static double centre_of_mass(const struct scallop_crawler *c, const struct scallop_phase_result *r)
{
  return (c->m1 * r->dx1 + c->m2 * r->dx2) / (c->m1 + c->m2);
}

static void exact_values(const struct scallop_crawler *c, double v0, double *value)
{
  for (int kind = 0; kind < 2; kind++) {
    struct scallop_phase_result r = phase_of(c, kind, v0);
    value[V_EXTENSION + 2 * kind] = r.v_end;
    value[X_EXTENSION + 2 * kind] = centre_of_mass(c, &r);
  }
  struct scallop_period_result p = period_of(c, v0);
  value[V_PERIOD] = p.v_end;
  value[X_PERIOD] = p.displacement;
  struct scallop_steady_result s = steady_of(c);
  value[V_STEADY] = s.period.v_start;
  value[X_STEADY] = s.period.displacement;
}

static void stepped_values(const struct scallop_crawler *c, double v0, int steps, double *value)
{
  for (int kind = 0; kind < 2; kind++) {
    struct state s = { v0, 0 };
    step_phase(c, (enum scallop_phase_kind)kind, steps, &s);
    value[V_EXTENSION + 2 * kind] = s.c;
    value[X_EXTENSION + 2 * kind] = s.x;
  }
  struct state s = step_period(c, v0, steps);
  value[V_PERIOD] = s.c;
  value[X_PERIOD] = s.x;
  value[V_STEADY] = step_steady(c, steps);
  value[X_STEADY] = step_period(c, value[V_STEADY], steps).x;
}

/* What error times steps is at most, in L/T and L. A step displaces an event by less than itself, and
 * changes c by less than 2 eps steps then; there are at most 6 events in a phase (four meetings, a
 * release, and the start). While c follows l' it is exact at the steps. The position is a rectangle sum
 * besides: half a step times the variation of c, which is at most twice that of l' and eps. The steady
 * state carries the error of a period 1/(1 - multiplier) times. */
static double allowed(const struct scallop_crawler *c, int quantity, double multiplier)
{
  double bound = 12 * crawler_eps(c);
  if (quantity % 2 == 1)
    bound += 4 + crawler_eps(c);
  return quantity >= V_STEADY ? 2 * bound / (1 - multiplier) : bound;
}

struct tally {
  double error[LEVELS];
}; /* sum over the crawlers, each counting 1 at the coarsest level */

static void refine(const struct scallop_crawler *c, double v0, struct tally *tally)
{
  double exact[QUANTITIES], sums[LEVELS] = { 0 }, mean = 0;
  exact_values(c, v0, exact);
  struct scallop_steady_result s = steady_of(c);
  for (int level = 0; level < LEVELS; level++) {
    double stepped[QUANTITIES];
    int steps = COARSEST << level;
    stepped_values(c, v0, steps, stepped);
    for (int q = 0; q < QUANTITIES; q++) {
      double error = fabs(stepped[q] - exact[q]) / (q % 2 == 0 ? c->L / c->T : c->L);
      CHECK_AT_MOST(error * steps, allowed(c, q, s.period.multiplier));
      sums[level] += error;
    }
    mean += sums[level] * steps / LEVELS;
  }
  for (int level = 0; level < LEVELS; level++) {
    /* an event falls anywhere within a step, so the factor of h varies; it must not drift away */
    CHECK_AT_MOST(sums[level] * (COARSEST << level), 3 * mean);
    tally->error[level] += sums[level] * COARSEST / mean;
  }
}

static void first_order(uint64_t seed, enum family family)
{
  struct random r = { seed };
  struct tally tally = { { 0 } };
  for (int n = 0; n < CRAWLERS; n++) {
    struct scallop_crawler c = random_crawler(&r, family, every_gait[n % SMOOTH_GAITS]);
    c.alpha = random_between(&r, 0.2, 0.8);
    set_eps(&c, family == STICK_SLIP ? random_decades(&r, 2, 60) : random_decades(&r, 0.3, 5));
    refine(&c, n % 3 == 0 ? 0 : random_between(&r, -2, 2) * c.L / c.T, &tally);
  }
  for (int level = 0; level + 1 < LEVELS; level++) {
    double ratio = tally.error[level] / tally.error[level + 1];
    print_message("error ratio %.3f from %d to %d steps a phase\n", ratio, COARSEST << level, COARSEST << (level + 1));
    CHECK_NEAR(ratio, 2, 0.3);
  }
  CHECK_NEAR(log2(tally.error[0] / tally.error[LEVELS - 1]) / (LEVELS - 1), 1, 0.07);
}

TEST(sliding) { first_order(31, ORDINARY); }
TEST(stick_slip) { first_order(32, STICK_SLIP); }

/* The reference itself: a free slide, a body that stops, one that stays stuck, and one that is dragged. */
TEST(resolvent_by_hand)
{
  CHECK_EQUAL(resolvent(3, 1, 0.5, -1, 0.25), 2.25);   /* both forward       */
  CHECK_EQUAL(resolvent(1.5, 1, 0.5, -1, 0.25), 1);    /* stops on the upper */
  CHECK_EQUAL(resolvent(0, 1, 0.5, -1, 0.25), 0.25);   /* opposite           */
  CHECK_EQUAL(resolvent(-1.5, 1, 0.5, -1, 0.25), -1);  /* stops on the lower */
  CHECK_EQUAL(resolvent(-3, 1, 0.5, -1, 0.25), -2.25); /* both backward      */
}
