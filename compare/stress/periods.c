#include "compare/stress/periods.h"

#include <float.h>
#include <math.h>

#include "numerics/wide/wide_parts.h"

#if WIDE_HAS_FLOAT128
__extension__ typedef __float128 real;
#else
typedef long double real;
#endif

static void set_end(struct answer *a, struct scallop_wide x, struct scallop_wide v)
{
  *a = (struct answer){ .status = SCALLOP_OK };
  for (int q = 0; q < ALL_QUANTITIES; q++)
    a->value[q].high = NAN;
  a->value[Q_DXC] = x;
  a->value[Q_V_END] = v;
}

static bool keep_last(void *context, const struct scallop_sample *sample)
{
  *(struct scallop_sample *)context = *sample;
  return true;
}

bool trajectory_in_double(const struct stress_case *s, struct answer *end)
{
  struct scallop_sample last = { .t = 0 };
  bool solved = scallop_trajectory(&s->motion.crawler, s->motion.v0, s->periods, 1, keep_last, &last) >= 0;
  set_end(end, (struct scallop_wide){ last.xC, 0 }, (struct scallop_wide){ last.v1, 0 });
  return solved;
}

static real sum(struct scallop_wide w) { return (real)w.high + w.low; }

static struct scallop_wide parts(real x) { return (struct scallop_wide){ (double)x, (double)(x - (double)x) }; }

static real power(real x, long n)
{
  real y = 1;
  for (; n > 0; n /= 2, x *= x)
    y *= n % 2 ? x : 1;
  return y;
}

bool trajectory_closed_form(const struct stress_case *s, struct answer *end)
{
  const struct scallop_crawler *c = &s->motion.crawler;
  struct scallop_wide_steady steady;
  struct scallop_wide_period at, above, below;
  if (scallop_wide_steady(SCALLOP_BINARY128, c, &steady) != SCALLOP_OK)
    return false;
  at = steady.period;
  double v = at.v_start.high, away = fmax(fabs(s->motion.v0 - v), 4 * DBL_EPSILON * fabs(v));
  if (scallop_wide_period(SCALLOP_BINARY128, c, v + away, &above) != SCALLOP_OK
      || scallop_wide_period(SCALLOP_BINARY128, c, v - away, &below) != SCALLOP_OK
      || !same_modes(above.modes, below.modes))
    return false;
  const real D = sum(at.displacement), lambda = sum(at.multiplier), lambda_n = power(lambda, s->periods);
  const real d = s->motion.v0 - sum(at.v_start), e = (v + away) - sum(at.v_start), f = (v - away) - sum(at.v_start);
  const real rise = (sum(above.displacement) - D) / e, C = (rise - (sum(below.displacement) - D) / f) / (e - f);
  const real B = rise - C * e, x = s->periods * D + B * d * (1 - lambda_n) / (1 - lambda)
                                   + C * d * d * (1 - lambda_n * lambda_n) / (1 - lambda * lambda);
  set_end(end, parts(x), parts(sum(at.v_start) + lambda_n * d));
  return true;
}
