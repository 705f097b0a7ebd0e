/* A phase, put back into Newton's law and the balances of momentum and energy, interval by interval:
 * tests/numerics/event/test_laws.c for whatever crawler the fuzzer thinks of.
 *
 * Units as in struct scallop_interval: lengths in L, times in the duration tau of the phase, masses in M, so that
 * friction is f_i = tau^2 F_i/(M L). Between the ends of an interval every balance is a closed form of c, l, l' and x
 * there.
 *
 * Tolerances are ROUNDINGS unit roundoffs of the sum of the absolute values of the terms. The time of an event is
 * uncertain by a rounding, and with it what changes at that time: size(). */
#include <float.h>

#include "tests/fuzz/crawler.h"
#include "tests/fuzz/target.h"
#include "tests/support/interval.h"

enum { ROUNDINGS = 64, KEPT = 256 };
#define ROUNDOFF (ROUNDINGS * (0.5 * DBL_EPSILON))

struct phase {
  struct fuzz_case input;
  enum scallop_phase_kind kind;
  double mu[2], f[2], unit;
  struct scallop_interval interval[KEPT];
  int count;
};
static struct phase now;

static const char *place(const struct scallop_interval *i)
{
  static char text[480];
  snprintf(text, sizeof text, "interval %d of %d, %s, %s", 1 + (int)(i - now.interval), now.count,
           now.kind == SCALLOP_EXTENSION ? "extension" : "contraction", fuzz_describe(&now.input));
  return text;
}

#define REQUIRE(i, condition) \
  do { \
    if (!(condition)) \
      fuzz_fail("line %d: %s does not hold: %s", __LINE__, #condition, place(i)); \
  } while (0)
/* Where terms overflow or leave the normal range there is nothing to hold the difference against. */
#define BALANCED(i, got, wanted, terms) \
  do { \
    double got_ = (got), wanted_ = (wanted), tolerance_ = ROUNDOFF * (terms) + DBL_MIN; \
    if (isfinite(tolerance_) && !(fabs(got_ - wanted_) <= tolerance_)) \
      fuzz_fail("line %d: %s is %.17g, not %.17g within %.3g: %s", __LINE__, #got, got_, wanted_, tolerance_, \
                place(i)); \
  } while (0)

static void keep(void *context, const struct scallop_interval *interval)
{
  (void)context;
  if (now.count < KEPT)
    now.interval[now.count] = *interval;
  now.count++;
}

/* What the velocity of the faster body is a sum of, with a rounding of u, which may be below the normal range */
static double size(const struct scallop_interval *i)
{
  double l = fmax(fabs(rate(i, i->u_begin)), fabs(rate(i, i->u_end)));
  double b = fmax(fabs(bend(i, i->u_begin)), fabs(bend(i, i->u_end)));
  return fmax(fabs(i->c_begin), fabs(i->c_end)) + l + (fabs(i->c_slope) + b) * (fmax(i->u_begin, i->u_end) + DBL_MIN);
}

static void order(void)
{
  const char *wrong = disorder(now.interval, now.count, &now.input.crawler.gait->phase[now.kind]);
  if (wrong)
    fuzz_fail("%s: %s", wrong, place(now.interval));
  for (const struct scallop_interval *b = now.interval + 1; b < now.interval + now.count; b++)
    BALANCED(b, b->c_begin, b[-1].c_end,
             size(b - 1) + size(b)); /* between them may be one that is shorter than a rounding */
}

/* A body that slides has the velocity of its sign at both ends. */
static void signs(const struct scallop_interval *i)
{
  for (int end = 0; end < 2; end++) {
    double u = end ? i->u_end : i->u_begin, c = end ? i->c_end : i->c_begin;
    double v1 = c - now.mu[1] * rate(i, u), v2 = c + now.mu[0] * rate(i, u);
    BALANCED(i, fmin(i->mode.s1 * v1, 0), 0, size(i));
    BALANCED(i, fmin(i->mode.s2 * v2, 0), 0, size(i));
    if (glued(i))
      BALANCED(i, i->mode.s1 == 0 ? v1 : v2, 0, size(i));
  }
}

/* In long double: what is in between may be beyond a double, or too small for one. */
static long double phase_duration(void)
{
  const struct scallop_crawler *c = &now.input.crawler;
  return (now.kind == SCALLOP_EXTENSION ? c->alpha : 1 - c->alpha) * (long double)c->T;
}

/* A force in M L/tau^2 */
static double scaled(double force)
{
  const struct scallop_crawler *c = &now.input.crawler;
  long double tau = phase_duration();
  return (double)(tau / c->L * (force / ((long double)c->m1 + c->m2)) * tau);
}

/* Friction on both bodies while they slide. F1 - F2 from the inputs: it can be small. */
static double friction(const struct scallop_interval *i)
{
  return -scaled(now.input.crawler.F1 * i->mode.s1 + now.input.crawler.F2 * i->mode.s2);
}

/* The kinetic energy changes by what the linkage does, force times l', less what friction takes. x: of the centre of
 * mass, a difference of numbers of the size of reached. */
static void energy(const struct scallop_interval *i, double x, double reached)
{
  double mu1 = now.mu[0], mu2 = now.mu[1], s1 = i->mode.s1, s2 = i->mode.s2;
  double l = length(i, i->u_end) - length(i, i->u_begin),
         l_size = fabs(length(i, i->u_end)) + fabs(length(i, i->u_begin));
  double begin = rate(i, i->u_begin), end = rate(i, i->u_end), squares = end * end - begin * begin;
  double change = 0.5 * (i->c_end * i->c_end - i->c_begin * i->c_begin + mu1 * mu2 * squares);
  double of_centre = glued(i) ? 0.5 * i->glue * squares : friction(i) * l; /* integral of c' l' */
  double work = i->mode.s2 != 0 ? mu2 * (of_centre + 0.5 * mu1 * squares) + now.f[1] * s2 * l
                                : -(mu1 * (of_centre - 0.5 * mu2 * squares) + now.f[0] * s1 * l);
  double lost = now.f[0] * s1 * (x - mu2 * l) + now.f[1] * s2 * (x + mu1 * l);
  double forces = now.f[0] + now.f[1], speed = size(i);
  BALANCED(i, change, work - lost, speed * speed + forces * (l_size + reached + speed * duration(i) + DBL_MIN));
}

static void judge(const struct scallop_phase_result *r)
{
  const struct scallop_interval *last = &now.interval[now.count - 1];
  const struct scallop_crawler *c = &now.input.crawler;
  double total = 0, terms = 0, half = (c->m1 - c->m2) / (c->m1 + c->m2) * 0.5;
  double stroke = now.kind == SCALLOP_EXTENSION ? 1 : -1, travel = r->dxC / c->L - half * stroke;
  for (const struct scallop_interval *i = now.interval; i <= last; i++) {
    double one = friction_impulse(i, now.mu, friction(i)), x = (i < last ? i[1].x_begin : travel) - i->x_begin;
    signs(i);
    if (!glued(i))
      BALANCED(i, i->c_slope, friction(i), fabs(friction(i)));
    BALANCED(i, i->c_end - i->c_begin, one, size(i));
    energy(i, x, fabs(i->x_begin) + fabs(x) + (i < last ? 0 : (fabs(r->dxC) + DBL_MIN) / c->L + fabs(half)));
    total += one;
    terms += fabs(one) + size(i);
  }
  BALANCED(last, last->c_end - now.interval[0].c_begin, total, terms);
  BALANCED(last, r->v_end / now.unit, last->c_end, fabs(last->c_end) + DBL_MIN / now.unit);
  /* unless the bodies brake in less than the least normal number */
  BALANCED(now.interval, now.input.v0 / now.unit, now.interval[0].c_begin,
           fabs(now.interval[0].c_begin) + (now.f[0] + now.f[1]) * (DBL_MIN / ROUNDOFF));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size_of_data)
{
  now = (struct phase){ .input = fuzz_case_of(data, size_of_data), .kind = SCALLOP_EXTENSION };
  const struct scallop_crawler *c = &now.input.crawler;
  double M = c->m1 + c->m2;
  for (int kind = 0; kind < 2; kind++) {
    struct scallop_phase_result r;
    now.kind = (enum scallop_phase_kind)kind;
    now.count = 0;
    enum scallop_status status = scallop_phase_intervals(c, now.kind, now.input.v0, keep, NULL);
    enum scallop_status of_phase = scallop_phase(c, now.kind, now.input.v0, &r);
    REQUIRE(now.interval, status < 0 ? now.count == 0 : now.count > 0 && now.count <= KEPT);
    if (status != of_phase && of_phase != SCALLOP_ERANGE) /* whose results are in the user's units */
      fuzz_fail("status %d and %d for %s", (int)status, (int)of_phase, place(now.interval));
    if (of_phase < 0)
      continue;
    now.unit = (double)(c->L / phase_duration());
    now.mu[0] = c->m1 / M;
    now.mu[1] = c->m2 / M;
    now.f[0] = scaled(c->F1);
    now.f[1] = scaled(c->F2);
    order();
    judge(&r);
  }
  return 0;
}
