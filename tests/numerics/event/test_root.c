/* The root finder of the solver: roots at the ends, and functions on which Newton's method has nothing to go by. */
#include "tests/support/check.h"

#include <float.h>

typedef double real;
#define ROUNDING (DBL_EPSILON / 2)
#include "model/root.h"

struct power { /* f = sign (u - root)^n + lift */
  double root, sign, lift;
  int n;
};

static double power(const void *context, double u, double *slope)
{
  const struct power *p = context;
  *slope = p->sign * p->n * pow(u - p->root, p->n - 1);
  return p->sign * pow(u - p->root, p->n) + p->lift;
}

static double between(const struct power *p, double from, double to)
{
  struct root_end a = { .u = from }, b = { .u = to };
  a.f = power(p, from, &a.slope);
  b.f = power(p, to, &b.slope);
  return root_between(power, p, a, b);
}

/* A root at an end is that end; simple roots to the last digit, and where f' = 0 as near as f tells; from both sides */
TEST(roots_of_powers)
{
  for (int sign = -1; sign <= 1; sign += 2)
    for (int n = 1; n <= 5; n++) {
      const struct power at_end = { 0.375, sign, 0, n }, simple = { 0, sign, -sign * pow(0.3, n), n },
                         flat = { 0.3, sign, 0, 3 };
      for (int back = 0; back < 2; back++) {
        double low = 0.1, high = 1, from = back ? high : low, to = back ? low : high;
        CHECK_RELATIVE(between(&simple, from, to), 0.3, 4 * DBL_EPSILON);
        CHECK_NEAR(between(&flat, from, to), 0.3, 1e-6);
        if (n % 2 == 0)
          continue;
        CHECK_EQUAL(between(&at_end, back ? high : 0.375, back ? 0.375 : high), 0.375);
        CHECK_EQUAL(between(&at_end, back ? 0.375 : low, back ? low : 0.375), 0.375);
      }
    }
}

struct flattened { /* f = low - u - high u^n */
  double low, high;
  int n;
};

static double flattened(const void *context, double u, double *slope)
{
  const struct flattened *p = context;
  *slope = -1 - p->high * p->n * pow(u, p->n - 1);
  return p->low - u - p->high * pow(u, p->n);
}

/* From the end where a high power rules a step comes a fixed part nearer to the root: more steps than there are, and
 * the last may cross it. */
TEST(roots_far_from_the_steep_end)
{
  for (int n = 2; n <= 6; n++)
    for (int k = 1; k < 400; k++) {
      const struct flattened p = { pow(0.93, k), 1e6, n };
      struct root_end a = { .u = 0 }, b = { .u = 0.3 };
      a.f = flattened(&p, a.u, &a.slope);
      b.f = flattened(&p, b.u, &b.slope);
      double root = root_between(flattened, &p, a, b), slope, rest = flattened(&p, root, &slope);
      CHECK_NEAR(rest / slope, 0, 4 * DBL_EPSILON * root);
    }
}

struct counted { /* a function without a slope to go by, that counts how often it is asked */
  double (*value)(double u, double root);
  double root;
  int *count;
};

static double counted(const void *context, double u, double *slope)
{
  const struct counted *c = context;
  ++*c->count;
  *slope = 0;
  return c->value(u, c->root);
}

static double line(double u, double root) { return u - root; }
static double cube(double u, double root) { return pow(u - root, 3); }
static double flat(double u, double root) { return pow(u / root - 1, 31); }
static double root_of_magnitude(double u, double root) { return copysign(sqrt(fabs(u - root)), u - root); }
static double jump(double u, double root) { return u < root ? -1 : 1e300; }
static double pole(double u, double root) { return u == root ? 1 : 1 / (root - u); }
static double steep(double u, double root) { return expm1(300 * (u / root - 1)); }
static double tiny(double u, double root) { return 1e-310 * (u / root - 1); }

static double (*const functions[])(double, double) = { line, cube, flat, root_of_magnitude, jump, pole, steep, tiny };
enum { FUNCTIONS = sizeof functions / sizeof *functions, MOST = 65 };

/* One search ends at a zero or beside a change of sign, however near to 0 the root is. */
static void halve(double (*value)(double, double), double root, double from, double to)
{
  int count = 0;
  const struct counted c = { value, root, &count };
  const struct root_end a = { .u = from, .f = value(from, root) }, b = { .u = to, .f = value(to, root) };
  double u = root_between(counted, &c, a, b);
  assert_true(value(u, root) == 0
              || (value(nextafter(u, 0), root) > 0) != (value(nextafter(u, 2 * to + from), root) > 0));
  assert_true(count <= MOST);
}

TEST(halving_alone)
{
  static const double begins[] = { 0, 1e-310, 1e-30, 0.2385 };
  for (int f = 0; f < FUNCTIONS; f++)
    for (int i = 0; i < 4; i++)
      for (int k = 1; k <= 40; k++) {
        double begin = begins[i], root = begin + (1 - begin) * pow(0.7, k);
        halve(functions[f], root, begin, 1);
        halve(functions[f], root, 1, begin);
      }
}

TEST(roots_near_zero)
{
  for (int n = -1070; n < -300; n += 7)
    halve(line, ldexp(1.375, n), 0, 1);
}
