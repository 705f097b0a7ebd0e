#include "compare/claims/evidence.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <gsl/gsl_qrng.h>

#include "compare/text/halfway.h"
#include "compare/text/table.h"
#include "model/exact/scoped.h"

double natural_time(const struct scallop_crawler *c) { return sqrt((c->m1 + c->m2) / (c->F1 + c->F2) * c->L); }

struct scallop_steady_result steady_state(const struct scallop_crawler *c)
{
  struct scallop_steady_result r;
  if (scallop_steady(c, &r) < 0)
    return (struct scallop_steady_result){ .mean_velocity = NAN,
                                           .period = { .v_start = NAN, .displacement = NAN, .multiplier = NAN } };
  return r;
}

struct scallop_phase_result extension(const struct scallop_crawler *c, double v0)
{
  struct scallop_phase_result r;
  if (scallop_phase(c, SCALLOP_EXTENSION, v0, &r) < 0)
    return (struct scallop_phase_result){ .dT = NAN, .v_end = NAN, .dxC = NAN, .regime = SCALLOP_SLIDING };
  return r;
}

double middle(const arb_t x) { return arf_get_d(arb_midref(x), ARF_RND_NEAR); }

double nearest_double(const fmpq_t x)
{
  SCOPED(arb, ball);
  arb_set_fmpq(ball, x, 64);
  return middle(ball);
}

/* 10^x for x in [-1, 1] by its own series: the same bits on every machine */
static double power_of_ten(double x)
{
  double y = x * 2.302585092994046 / 64, p = 1 + y * (1 + y / 2 * (1 + y / 3 * (1 + y / 4 * (1 + y / 5))));
  for (int i = 0; i < 6; i++)
    p *= p;
  return p;
}

int random_crawlers(struct scallop_crawler *c, int count, const struct scallop_gait *gait)
{
  gsl_qrng *sequence = gsl_qrng_alloc(gsl_qrng_sobol, 6);
  if (!sequence)
    return 0;
  for (int i = 0; i < count; i++) {
    double u[6];
    gsl_qrng_get(sequence, u);
    c[i] = (struct scallop_crawler){ .L = 1, .gait = gait, .alpha = 0.05 + 0.9 * u[4] };
    c[i].m1 = power_of_ten(2 * u[0] - 1), c[i].m2 = power_of_ten(2 * u[1] - 1);
    c[i].F1 = power_of_ten(2 * u[2] - 1), c[i].F2 = power_of_ten(2 * u[3] - 1);
    c[i].T = sqrt((c[i].m1 + c[i].m2) / (c[i].F1 + c[i].F2)) * power_of_ten(1.5 * u[5] - 1);
  }
  gsl_qrng_free(sequence);
  return count;
}

double last_positive(function_of *f, const void *context, double low, double high)
{
  for (double x; halfway(&x, low, high);)
    *(f(context, x) > 0 ? &low : &high) = x;
  return low;
}

double highest_between(function_of *f, const void *context, double a, double b)
{
  const double golden = 0.6180339887498949;
  while (b - a > 1e-7 * a) {
    double left = b - golden * (b - a), right = a + golden * (b - a);
    if (f(context, left) > f(context, right))
      b = right;
    else
      a = left;
  }
  return 0.5 * (a + b);
}

double short_number(double x, int digits)
{
  char text[NUMBER_TEXT];
  snprintf(text, sizeof text, "%.*g", digits, x);
  return strtod(text, NULL);
}
