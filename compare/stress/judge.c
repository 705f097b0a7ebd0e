/* Judgement of one case of `stress`: its answer in double against certified numbers. */
#include <fenv.h>
#include <float.h>
#include <math.h>
#include <string.h>

#include "compare/answers/answer_flint.h"
#include "compare/stress/stress.h"
#include "numerics/wide/wide_parts.h"

enum { DIGITS = 36 };

/* Answers of a case. For a trajectory, its end, x as Q_DXC and v as Q_V_END, with the closed form as both wider ones */
struct answers {
  struct answer got, exact, wide[2];
};

static bool is_trajectory(const struct stress_case *s) { return s->periods > 0; }

const char *stress_quantity_name(const struct stress_case *s, int q)
{
  return !is_trajectory(s) ? quantity_rows[q].name : q == Q_DXC ? "x" : "v";
}

static double distance(struct scallop_wide a, struct scallop_wide b)
{
  return fabs((a.high - b.high) + (a.low - b.low));
}

/* Returns the middle of a ball; 0 if the ball contains 0. */
static struct scallop_wide ball_middle(const arb_t x)
{
  double high = arb_contains_zero(x) ? 0 : arf_get_d(arb_midref(x), ARF_RND_NEAR);
  SCOPED(arf, low);
  arf_set_d(low, high);
  arf_sub(low, arb_midref(x), low, ARF_PREC_EXACT, ARF_RND_NEAR);
  return (struct scallop_wide){ high, high != 0 && isfinite(high) ? arf_get_d(low, ARF_RND_NEAR) : 0 };
}

/* Trajectories: the end of millions of periods */

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

static bool trajectory_in_double(const struct stress_case *s, struct answer *end)
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

/* Computes the end in closed form. With v* the steady start velocity, lambda the multiplier, d = v_0 - v* and D(v) the
 * displacement over a period from v, a motion that keeps its modes obeys v_n - v* = lambda^n d exactly if l' consists
 * of ramps, and D is then a quadratic polynomial, D(v) = D(v*) + B (v - v*) + C (v - v*)^2. So
 *
 *     x_n = n D(v*) + B d (1 - lambda^n)/(1 - lambda) + C d^2 (1 - lambda^(2 n))/(1 - lambda^2),
 *
 * B and C from periods that begin |d| below and above v*. For other gaits this holds except for terms of order d^3 and,
 * in v_n, d^2; d is then at most the rounding of v* to a double. False: no answer, or the modes differ between
 * velocities of the trajectory. */
static bool trajectory_closed_form(const struct stress_case *s, struct answer *end)
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

/* Answers */

static bool fail(struct stress_case *s, enum stress_outcome outcome, const char *why)
{
  s->outcome = outcome;
  s->why = why;
  return false;
}

static bool solve_motion(struct stress_case *s, struct answers *f)
{
  const struct motion *m = &s->motion;
  SCOPED(ball_answer, proven);
  double estimate[QUANTITIES];
  if (!answer_with_errors(&f->got, m, estimate))
    return fail(s, f->got.status == SCALLOP_ERANGE ? STRESS_REFUSED : STRESS_BROKEN,
                scallop_status_text(f->got.status));
  if (f->got.status == SCALLOP_INTERVAL)
    return fail(s, STRESS_REFUSED, "the steady states fill an interval: none of them is the one to judge");
  for (int w = 0; w < 2; w++)
    if (!answer_in_wide(&f->wide[w], m, (enum scallop_width)w))
      return fail(s, STRESS_BROKEN, "wider arithmetic finds no solution");
  f->exact = f->wide[SCALLOP_BINARY128];
  bool done = answer_of_doubles(&proven, m, DIGITS) || fail(s, STRESS_UNDECIDED, proven.why);
  for (int q = 0; q < QUANTITIES; q++) {
    s->number[q] = (struct stress_number){ .estimate = estimate[q] };
    if (done)
      f->exact.value[q] = proven.value[q] ? ball_middle(proven.value[q]) : (struct scallop_wide){ NAN, 0 };
  }
  if (isnan(estimate[m->of == OF_PHASE ? Q_V_END : Q_V_START]))
    fail(s, STRESS_BROKEN, "there is no estimate of the error");
  return true;
}

static bool solve_trajectory(struct stress_case *s, struct answers *f)
{
  if (!trajectory_closed_form(s, &f->exact))
    return fail(s, STRESS_REFUSED, "no closed form: the modes change on the way");
  if (!trajectory_in_double(s, &f->got))
    return fail(s, STRESS_BROKEN, "the trajectory was not solved");
  f->wide[0] = f->wide[1] = f->exact;
  for (int q = 0; q < QUANTITIES; q++)
    s->number[q] = (struct stress_number){ .estimate = NAN, .rounding = NAN, .perturbed = NAN };
  return true;
}

static bool solve_widely(const struct stress_case *s, struct answer *a)
{
  return is_trajectory(s) ? trajectory_closed_form(s, a) : answer_in_wide(a, &s->motion, SCALLOP_BINARY128);
}

/* Returns the natural unit of a quantity, from L and the duration of the phase, or of the shorter one; else 0. */
static double natural_unit(const struct stress_case *s, int q)
{
  const struct scallop_crawler *c = &s->motion.crawler;
  const double tau[] = { scallop_phase_duration(c, SCALLOP_EXTENSION), scallop_phase_duration(c, SCALLOP_CONTRACTION) };
  double time = s->motion.of == OF_PHASE ? tau[s->motion.phase] : fmin(tau[0], tau[1]);
  const char *unit = quantity_rows[q].unit;
  if (is_trajectory(s) || q == Q_FROUDE)
    return 0;
  return strcmp(unit, "1") == 0        ? 1
         : strcmp(unit, "time") == 0   ? time
         : strcmp(unit, "length") == 0 ? c->L
                                       : c->L / (q == Q_MEAN_VELOCITY ? c->T : time);
}

/* Moves a parameter, by its place with v0 last, by `places` doubles. False: the case has no such parameter, or the
 * double is not allowed. */
static bool neighbour(const struct stress_case *s, int parameter, double towards, int places, struct stress_case *out)
{
  struct motion *m = &out->motion;
  struct scallop_crawler *c = &m->crawler;
  *out = *s;
  double *x = parameter == PLACE_OF_V0 ? &m->v0 : crawler_field(c, parameter);
  if (parameter == PLACE_OF_V0 && (m->of == OF_STEADY || m->v0 == 0)) /* rest is exact */
    return false;
  for (int i = 0; i < places; i++)
    *x = nextafter(*x, towards);
  return scallop_crawler_check(c, NULL) == SCALLOP_OK;
}

/* Returns true for quantities that jump at a change of modes, however small the change of a parameter. */
static bool may_jump(int q) { return q == Q_T1 || q == Q_DT || q == Q_MULTIPLIER; }

/* Solves the motion, or a neighbour, again in double; nan: a missing number, or one that may have jumped. Any failure
 * other than an input out of range is a broken bound. */
static struct answer solve_again(struct stress_case *s, const struct motion *m, const struct answer *got,
                                 const char *why)
{
  struct answer there;
  if (!answer_in_double(&there, m) && there.status != SCALLOP_ERANGE)
    fail(s, STRESS_BROKEN, why);
  for (int q = 0; q < QUANTITIES; q++)
    if (may_jump(q) && !same_modes(there.modes, got->modes))
      there.value[q].high = NAN;
  return there;
}

/* Raises units to the sum over the parameters of the change of a number if one is moved by `places` doubles up or down,
 * over places. With 1 place, the result in double is perturbed too; with STRESS_BOUND places, a kink at that distance
 * counts in proportion. */
static void move_parameters(struct stress_case *s, int places, const struct answers *f)
{
  double unit[QUANTITIES] = { 0 };
  struct stress_case next;
  struct answer there;
  for (int parameter = 0; parameter < POINT_NUMBERS; parameter++) {
    double largest[QUANTITIES] = { 0 };
    for (int side = -1; side <= 1; side += 2) {
      if (!neighbour(s, parameter, side * INFINITY, places, &next))
        continue;
      if (solve_widely(&next, &there))
        for (int q = 0; q < QUANTITIES; q++)
          largest[q] = fmax(largest[q], distance(there.value[q], f->wide[SCALLOP_BINARY128].value[q]));
      if (is_trajectory(s) || places > 1)
        continue;
      there = solve_again(s, &next.motion, &f->got, "no solution where a parameter is an ulp off");
      for (int q = 0; q < QUANTITIES; q++)
        s->number[q].perturbed = fmax(s->number[q].perturbed, distance(there.value[q], f->got.value[q]));
    }
    for (int q = 0; q < QUANTITIES; q++)
      unit[q] += largest[q] / places;
  }
  for (int q = 0; q < QUANTITIES; q++)
    s->number[q].unit = fmax(s->number[q].unit, unit[q]);
}

/* Finds the spread of the result in double over the four rounding modes. */
static void spread_over_roundings(struct stress_case *s, const struct answer *got)
{
  static const int directions[] = { FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO };
  struct answer low = *got, high = *got;
  for (int i = 0; i < 3; i++) {
    int before = fegetround();
    fesetround(directions[i]);
    struct answer there = solve_again(s, &s->motion, got, "no solution in a directed rounding");
    fesetround(before);
    for (int q = 0; q < QUANTITIES; q++) {
      low.value[q].high = fmin(low.value[q].high, there.value[q].high);
      high.value[q].high = fmax(high.value[q].high, there.value[q].high);
    }
  }
  for (int q = 0; q < QUANTITIES; q++)
    s->number[q].rounding = high.value[q].high - low.value[q].high;
}

/* Finds the magnitudes of the terms that binary128 sums. */
static void find_sizes(const struct motion *m, double size[QUANTITIES])
{
  struct scallop_wide_phase phase;
  struct scallop_wide_steady steady;
  if (m->of == OF_PHASE) {
    if (scallop_wide_phase(SCALLOP_BINARY128, &m->crawler, m->phase, m->v0, &phase) == SCALLOP_OK) {
      size[Q_DX1] = phase.dx1_size;
      size[Q_DX2] = phase.dx2_size;
      size[Q_DXC] = phase.dxC_size;
    }
  } else if (scallop_wide_steady(SCALLOP_BINARY128, &m->crawler, &steady) == SCALLOP_OK) {
    size[Q_DISPLACEMENT] = steady.period.displacement_size;
    size[Q_MEAN_VELOCITY] = steady.period.displacement_size / m->crawler.T;
  }
}

const char *stress_broken(const struct stress_number *n)
{
  if (!(n->error <= STRESS_BOUND * n->unit))
    return "error";
  if (isnan(n->rounding)) /* a trajectory */
    return NULL;
  if (!(n->rounding <= STRESS_ROUNDING * n->unit))
    return "spread over the rounding modes";
  if (!(n->perturbed <= STRESS_PERTURBED * n->unit))
    return "spread over parameters an ulp apart";
  bool known = !(n->unit > 0x1p50 * n->ulp); /* 113 bits resolve the error */
  if (known && !(n->estimate >= n->error))
    return "estimate of the error too small";
  /* the unit of a number that is 0 for all parameters is rounding of 113 bits */
  double negligible = fmax(0x1p-7 * (n->ulp > 0 ? n->ulp : n->unit), n->resolved);
  return n->estimate <= STRESS_MAX_ESTIMATE * fmax(n->error, negligible) ? NULL : "estimate of the error too large";
}

/* Sets the numbers of the case; returns true if a bound is exceeded. */
static bool measure(struct stress_case *s, const struct answers *f, const double size[QUANTITIES])
{
  bool any = false;
  s->other_modes = !same_modes(f->got.modes, f->wide[SCALLOP_BINARY128].modes);
  for (int q = 0; q < QUANTITIES; q++) {
    struct stress_number *n = &s->number[q];
    const struct scallop_wide exact = f->exact.value[q], got = f->got.value[q];
    double y = exact.high, natural = natural_unit(s, q), floor = 0x1p-960 * natural; /* below it digits may be lost */
    bool exists = !isnan(y) || !isnan(got.high), has_ulp = fabs(y) > 0x1p53 * floor && isfinite(y);
    n->exact = y;
    n->got = got.high;
    n->error = distance(got, exact);
    n->judged = exists && !(s->other_modes && may_jump(q));
    n->ulp = has_ulp ? ldexp(1, ilogb(y) - (DBL_MANT_DIG - 1)) : NAN;
    n->unit = fmax(fmax(n->unit, n->ulp), fmax(floor, DBL_MIN));
    n->resolved = 0x1p-111 * fmax(size[q], has_ulp ? 0 : natural);
    for (int w = 0; w < 3; w++)
      n->wide_error[w] = is_trajectory(s) ? NAN : w == 0 ? n->error : distance(f->wide[w - 1].value[q], exact);
    if (exists && fabs(y) > floor && !isnormal(y))
      fail(s, STRESS_BROKEN, "a number beyond the range of doubles was not refused");
    n->broken = n->judged ? stress_broken(n) : NULL;
    any = any || n->broken;
  }
  return any;
}

void stress_judge(struct stress_case *s)
{
  struct answers f;
  double size[QUANTITIES] = { 0 };
  *s = (struct stress_case){ .motion = s->motion, .periods = s->periods };
  if (is_trajectory(s) ? solve_trajectory(s, &f) : solve_motion(s, &f)) {
    move_parameters(s, 1, &f);
    if (!is_trajectory(s))
      spread_over_roundings(s, &f.got);
    if (measure(s, &f, size) && !is_trajectory(s)) {
      find_sizes(&s->motion, size);
      move_parameters(s, STRESS_BOUND, &f);
      measure(s, &f, size);
    }
  }
  for (int q = 0; q < QUANTITIES && s->outcome == STRESS_BROKEN; q++)
    s->number[q] = (struct stress_number){ .broken = s->why };
}
