/* Part of wide_solve.h: l' by the law of its piece, and what the walk asks of it. */
#include "model/bernstein.h"

/* The circle's number in three doubles: 159 bits. */
static real circle_number(void) { return (real)0x1.921fb54442d18p+1 + 0x1.1a62633145c07p-53 + -0x1.f1976b7ed8fbcp-109; }

/* Of pi u, 0 <= u <= 1/2, as accurate as u and 1/2 - u are. */
static real half_turn_sine(real u)
{
  return 4 * u > 1 ? real_cosine(circle_number() * ((real)1 / 2 - u)) : real_sine(circle_number() * u);
}

static real half_turn_cosine(real u)
{
  return 4 * u > 1 ? real_sine(circle_number() * ((real)1 / 2 - u)) : real_cosine(circle_number() * u);
}

static real polynomial(const struct scallop_law *law, real u, int order)
{
  real sum = 0;
  for (int k = law->degree; k >= order; k--) {
    real factor = law->polynomial.c[k];
    for (int i = 0; i < order; i++)
      factor *= k - i;
    sum = sum * u + factor;
  }
  return sum / law->polynomial.denominator;
}

/* The coefficients of the derivative with respect to u */
static void derive(struct bernstein *f)
{
  for (int j = 0; j < f->degree; j++)
    f->b[j] = f->degree * (f->b[j + 1] - f->b[j]) / (f->far - f->near);
  f->degree--;
}

static real bernstein_at(const struct bernstein *f, real u)
{
  real x = (u - f->near) / (f->far - f->near), y = (f->far - u) / (f->far - f->near), sum = f->b[0], factor = 1;
  for (int j = 1; j <= f->degree; j++) {
    factor = factor * x * (f->degree - j + 1) / j;
    sum = sum * y + factor * f->b[j];
  }
  return sum;
}

static real bernstein_derivative(const struct scallop_law *law, real u, int order)
{
  struct bernstein f = bernstein_of(law);
  for (int i = 0; i < order; i++)
    derive(&f);
  return bernstein_at(&f, u);
}

/* The integral over u from the smaller to the larger of the two */
static real bernstein_integral(struct bernstein f, real from, real to)
{
  real low = from < to ? from : to, high = from < to ? to : from, sum = 0;
  bernstein_cut(&f, low, high);
  for (int j = 0; j <= f.degree; j++)
    sum += f.b[j];
  return sum / (f.degree + 1) * (high - low);
}

static real speed_derivative(const struct scallop_piece *p, real u, int order)
{
  if (p->law->kind == SCALLOP_LAW_BERNSTEIN)
    return bernstein_derivative(p->law, u, order);
  if (p->law->kind == SCALLOP_LAW_POLYNOMIAL)
    return polynomial(p->law, u, order);
  real pi = circle_number();
  return pi / 2
         * (order == 0   ? half_turn_sine(u)
            : order == 1 ? pi * half_turn_cosine(u)
                         : -pi * pi * half_turn_sine(u));
}

/* l' at offset 0 and l'' of a linear piece, as its law has them */
static real walk_velocity(const struct scallop_piece *p)
{
  if (!p->law || p->direction == 0)
    return p->velocity;
  const struct scallop_ramp_law *ramp = &p->law->ramp;
  if (p->law->kind == SCALLOP_LAW_RAMP)
    return p->direction * ramp->start / (ramp->divisor * ((real)ramp->parts[0] + ramp->parts[1] + ramp->parts[2]));
  return p->direction * polynomial(p->law, 0, 0);
}

static real walk_acceleration(const struct scallop_piece *p)
{
  int sign = law_sense(p) * p->direction;
  if (!p->law || p->direction == 0)
    return p->acceleration;
  const struct scallop_ramp_law *ramp = &p->law->ramp;
  if (p->law->kind == SCALLOP_LAW_RAMP)
    return sign * ramp->slope / (ramp->divisor * ((real)ramp->parts[0] + ramp->parts[1] + ramp->parts[2]));
  return sign * polynomial(p->law, 0, 1);
}

static void walk_curve(const struct scallop_piece *p, real u, real *velocity, real *acceleration)
{
  *velocity = p->direction * speed_derivative(p, u, 0);
  *acceleration = law_sense(p) * p->direction * speed_derivative(p, u, 1);
}

static real walk_way(const struct scallop_piece *p, real from, real to)
{
  real way = 0, apart = from < to ? to - from : from - to;
  if (p->law->kind == SCALLOP_LAW_BERNSTEIN)
    return apart > 0 ? bernstein_integral(bernstein_of(p->law), from, to) : 0;
  if (p->law->kind == SCALLOP_LAW_POLYNOMIAL) {
    for (int k = p->law->degree; k >= 0; k--) { /* (to^(k + 1) - from^(k + 1))/(to - from), term by term */
      real power = 1, terms = 0;
      for (int i = 0; i <= k; i++, power *= from)
        terms = terms * to + power;
      way += terms * p->law->polynomial.c[k] / (k + 1);
    }
    return way / p->law->polynomial.denominator * apart;
  }
  return half_turn_sine((from + to) / 2) * half_turn_sine(apart / 2);
}

static real walk_rise(const struct scallop_piece *p, real from, real to)
{
  if (p->law->kind == SCALLOP_LAW_BERNSTEIN && from != to) {
    struct bernstein slope = bernstein_of(p->law);
    derive(&slope);
    return from < to ? bernstein_integral(slope, from, to) : -bernstein_integral(slope, from, to);
  }
  return speed_derivative(p, to, 0) - speed_derivative(p, from, 0);
}
