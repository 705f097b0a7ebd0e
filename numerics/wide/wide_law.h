/* Part of wide_solve.h: l' by the law of its piece, and the functions of it that the walk needs. */
#include "model/bernstein.h"

/* The circle's number in three doubles: 159 bits. */
static real circle_number(void) { return (real)0x1.921fb54442d18p+1 + 0x1.1a62633145c07p-53 + -0x1.f1976b7ed8fbcp-109; }

/* Returns sin(pi u), 0 <= u <= 1/2, as accurate as u and 1/2 - u are. */
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

static real speed_derivative(const struct scallop_piece *p, real u, int order)
{
  if (p->law->kind == SCALLOP_LAW_BERNSTEIN)
    return bernstein_derivative(bernstein_of(p->law), u, order);
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
  real speed, slope;
  if (p->law->kind == SCALLOP_LAW_BERNSTEIN) {
    struct bernstein f = bernstein_of(p->law);
    bernstein_rates_at(&f, u, &speed, &slope);
  } else {
    speed = speed_derivative(p, u, 0);
    slope = speed_derivative(p, u, 1);
  }
  *velocity = p->direction * speed;
  *acceleration = law_sense(p) * p->direction * slope;
}

static real walk_pi(void) { return circle_number(); }

/* Returns max |l'| of a shape of sines. */
static real walk_peak(const struct scallop_shape *shape) { return walk_pi() / 2 * (shape->peak > 0); }

/* d|l'|/du at the start or at the end of a phase that begins and ends in curved pieces */
static real walk_steepest(const struct scallop_shape *shape, bool at_end)
{
  const struct scallop_piece *p = &shape->pieces[at_end ? shape->count - 1 : 0];
  return law_is_sine(p) ? walk_pi() * walk_pi() / 2 : speed_derivative(p, 0, 1);
}

/* A place to begin Newton's method for a + b x = q |l'(x)|: the root in double, found from start on. */
static real walk_near(const struct scallop_piece *p, real start, real a, real b, real q)
{
  enum { STEPS = 30 };
  double x = (double)start;
  for (int i = 0; i < STEPS; i++) {
    double velocity, acceleration;
    p->curve->rates(p, x, &velocity, &acceleration);
    double gap = (double)a + (double)b * x - (double)q * (p->direction * velocity);
    double step = gap / ((double)q * (law_sense(p) * p->direction * acceleration) - (double)b);
    x += step;
    if (!(fabs(step) > 1e-7 * x))
      break;
  }
  return x > 0 && x <= 1 ? (real)x : start;
}

#define walk_quickly walk_curve

static real walk_way(const struct scallop_piece *p, real from, real to)
{
  real way = 0, apart = from < to ? to - from : from - to;
  if (p->law->kind == SCALLOP_LAW_BERNSTEIN)
    return bernstein_integral(bernstein_of(p->law), from, to);
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
  if (p->law->kind == SCALLOP_LAW_BERNSTEIN)
    return bernstein_rise(bernstein_of(p->law), from, to);
  return speed_derivative(p, to, 0) - speed_derivative(p, from, 0);
}

struct rate_search {
  const struct scallop_piece *piece;
  real wanted; /* of the derivative of |l'| with respect to u */
};

static real rate_beyond(const void *context, real u, real *slope)
{
  const struct rate_search *s = context;
  *slope = speed_derivative(s->piece, u, 2);
  return speed_derivative(s->piece, u, 1) - s->wanted;
}

static real walk_when(const struct scallop_piece *p, real a)
{
  const struct rate_search search = { p, law_sense(p) * p->direction * a };
  const double near = law_is_sine(p) ? p->curve->when(p, (double)a) : NAN;
  if (near > 1e-3 && near < 0.499) { /* the root in double is one or two steps away */
    real u = near, slope, step;
    do {
      step = rate_beyond(&search, u, &slope) / slope;
      u -= step;
    } while (magnitude(step) > SMALL_STEP * u);
    return u;
  }
  struct root_end begin = { .u = p->begin }, end = { .u = p->end };
  begin.f = rate_beyond(&search, begin.u, &begin.slope);
  end.f = rate_beyond(&search, end.u, &end.slope);
  const bool changes = (begin.f > 0) != (end.f > 0) || begin.f == 0 || end.f == 0;
  return changes ? root_between(rate_beyond, &search, begin, end) : NAN;
}
