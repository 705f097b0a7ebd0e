#include "compare/stress/judge.h"

#include <fenv.h>
#include <float.h>
#include <math.h>

#include "compare/stress/periods.h"

enum { PARAMETERS = 8, DIGITS = 36 };

/* All answers to one case. Of a trajectory the closed form stands for both wider ones. */
struct solutions {
  struct answer got, exact, wide[2];
  double errors[QUANTITIES];
};

static bool is_phase(const struct stress_case *s) { return s->kind == STRESS_PHASE; }
static bool is_trajectory(const struct stress_case *s) { return s->kind == STRESS_TRAJECTORY; }

/* Where the numbers of a case begin in an answer. */
static int first_of(enum stress_kind kind)
{
  return kind == STRESS_TRAJECTORY ? 0 : (int)quantity_first(kind == STRESS_PHASE ? OF_PHASE : OF_STEADY);
}

const char *stress_quantity_name(enum stress_kind kind, int q)
{
  static const char *const of_trajectory[STRESS_QUANTITIES] = { [END_X] = "x", [END_V] = "v" };
  return kind == STRESS_TRAJECTORY ? of_trajectory[q] : quantity_rows[first_of(kind) + q].name;
}

static const struct scallop_wide *numbers(const struct stress_case *s, const struct answer *a)
{
  return a->value + first_of(s->kind);
}

/* The multiplier and the switching times jump where modes change, however small the change of a parameter. */
static bool may_jump(const struct stress_case *s, int q)
{
  int id = first_of(s->kind) + q;
  return id == Q_T1 || id == Q_DT || id == Q_MULTIPLIER;
}

static double distance(const struct scallop_wide *a, const struct scallop_wide *b)
{
  return fabs((a->high - b->high) + (a->low - b->low));
}

static bool fail(struct stress_judgement *j, enum stress_outcome outcome, const char *why)
{
  j->outcome = outcome;
  j->why = why;
  return false;
}

static bool solve_double(const struct stress_case *s, struct answer *a)
{
  const struct motion m = stress_motion(s);
  return answer_in_double(a, &m);
}

static bool solve_trajectory(const struct stress_case *s, struct answer *a,
                             bool (*route)(const struct stress_case *, struct scallop_wide *))
{
  *a = (struct answer){ .status = SCALLOP_OK };
  for (int q = 0; q < STRESS_QUANTITIES; q++)
    a->value[q].high = NAN;
  return route(s, a->value);
}

/* In the arithmetic in which changes of parameters are measured */
static bool solve_wider(const struct stress_case *s, struct answer *a)
{
  const struct motion m = stress_motion(s);
  return is_trajectory(s) ? solve_trajectory(s, a, trajectory_in_balls) : answer_in_wide(a, &m, SCALLOP_BINARY128);
}

static bool certify(const struct motion *m, struct answer *a, const char **why)
{
  SCOPED(ball_answer, proven);
  bool done = answer_of_doubles(&proven, m, DIGITS);
  for (int q = 0; q < QUANTITIES && done; q++)
    a->value[q] = proven.value[q] ? ball_middle(proven.value[q]) : (struct scallop_wide){ NAN, 0 };
  *why = proven.why;
  return done;
}

static bool solve_motion(const struct stress_case *s, struct solutions *all, struct stress_judgement *j)
{
  const struct motion m = stress_motion(s);
  const char *why = NULL;
  if (!answer_with_errors(&all->got, &m, all->errors))
    return fail(j, all->got.status == SCALLOP_ERANGE ? STRESS_REFUSED : STRESS_BROKEN,
                scallop_status_text(all->got.status));
  if (all->got.status == SCALLOP_INTERVAL)
    return fail(j, STRESS_REFUSED, "the steady states fill an interval: none of them is the one to judge");
  for (int w = 0; w < 2; w++)
    if (!answer_in_wide(&all->wide[w], &m, (enum scallop_width)w))
      return fail(j, STRESS_BROKEN, "wider arithmetic finds no solution");
  if (!certify(&m, &all->exact, &why)) {
    fail(j, STRESS_UNDECIDED, why);
    all->exact = all->wide[SCALLOP_BINARY128];
  }
  return true;
}

static bool solve_to_its_end(const struct stress_case *s, struct solutions *all, struct stress_judgement *j)
{
  if (!solve_trajectory(s, &all->exact, trajectory_in_balls))
    return fail(j, STRESS_REFUSED, "no closed form: the modes change on the way");
  if (!solve_trajectory(s, &all->got, trajectory_in_double))
    return fail(j, STRESS_BROKEN, "the trajectory was not solved");
  all->wide[0] = all->wide[1] = all->exact;
  return true;
}

/* Replaces one of the parameters m1 m2 F1 F2 L T alpha v0 by the double so many places further. False: the case has no
 * such parameter, or the double is not allowed. */
static bool neighbour(const struct stress_case *s, int parameter, double towards, int places, struct stress_case *out)
{
  struct scallop_crawler *c = &out->crawler;
  *out = *s;
  double *const all[PARAMETERS] = { &c->m1, &c->m2, &c->F1, &c->F2, &c->L, &c->T, &c->alpha, &out->v0 };
  if (parameter == PARAMETERS - 1 && (s->kind == STRESS_STEADY || s->v0 == 0)) /* from rest is no rounded number */
    return false;
  for (int i = 0; i < places; i++)
    *all[parameter] = nextafter(*all[parameter], towards);
  return scallop_crawler_check(c, NULL) == SCALLOP_OK;
}

/* What changes of each parameter, so many doubles up and down, do to the numbers, for each double: by one; or by as
 * many as are promised, as a kink that far away counts in proportion. */
static void find_units(const struct stress_case *s, int places, const struct answer *wide,
                       double unit[STRESS_QUANTITIES])
{
  struct stress_case next;
  struct answer there;
  for (int q = 0; q < STRESS_QUANTITIES; q++)
    unit[q] = 0;
  for (int parameter = 0; parameter < PARAMETERS; parameter++) {
    double most[STRESS_QUANTITIES] = { 0 };
    for (int side = -1; side <= 1; side += 2)
      if (neighbour(s, parameter, side * INFINITY, places, &next) && solve_wider(&next, &there))
        for (int q = 0; q < STRESS_QUANTITIES; q++)
          most[q] = fmax(most[q], distance(&numbers(s, &there)[q], &numbers(s, wide)[q]));
    for (int q = 0; q < STRESS_QUANTITIES; q++)
      unit[q] += most[q] / places;
  }
}

/* The same motion, or nearly the same, once more in double. False: it is out of range; any other failure breaks the
 * promise. */
static bool solve_again(const struct stress_case *s, struct answer *there, struct stress_judgement *j, const char *why)
{
  bool solved = solve_double(s, there);
  return solved || there->status == SCALLOP_ERANGE ? solved : fail(j, STRESS_BROKEN, why);
}

/* What changes of one parameter do to the result in double */
static void perturb(const struct stress_case *s, int parameter, const struct answer *got, struct stress_judgement *j)
{
  struct stress_case next;
  struct answer there;
  for (int side = -1; side <= 1; side += 2)
    if (neighbour(s, parameter, side * INFINITY, 1, &next)
        && solve_again(&next, &there, j, "no solution where a parameter is an ulp off"))
      for (int q = 0; q < STRESS_QUANTITIES; q++)
        if (!may_jump(s, q) || same_modes(there.modes, got->modes))
          j->number[q].perturbed = fmax(j->number[q].perturbed, distance(&numbers(s, &there)[q], &numbers(s, got)[q]));
}

/* The same in the other three rounding modes */
static void round_otherwise(const struct stress_case *s, const struct answer *got, struct stress_judgement *j)
{
  static const int directions[] = { FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO };
  double low[STRESS_QUANTITIES], high[STRESS_QUANTITIES];
  for (int q = 0; q < STRESS_QUANTITIES; q++)
    low[q] = high[q] = numbers(s, got)[q].high;
  for (int i = 0; i < 3; i++) {
    struct answer there;
    int before = fegetround();
    fesetround(directions[i]);
    bool solved = solve_again(s, &there, j, "no solution in a directed rounding");
    fesetround(before);
    for (int q = 0; solved && q < STRESS_QUANTITIES; q++)
      if (!may_jump(s, q) || same_modes(there.modes, got->modes)) {
        low[q] = fmin(low[q], numbers(s, &there)[q].high);
        high[q] = fmax(high[q], numbers(s, &there)[q].high);
      }
  }
  for (int q = 0; q < STRESS_QUANTITIES; q++)
    j->number[q].rounding = high[q] - low[q];
}

/* What a number is counted in: tau, L/tau and L of a phase; of a steady state L/tau of its shorter phase, L, L/T and
 * 1 */
static double natural_unit(const struct stress_case *s, int q)
{
  const struct scallop_crawler *c = &s->crawler;
  double shorter = fmin(scallop_phase_duration(c, SCALLOP_EXTENSION), scallop_phase_duration(c, SCALLOP_CONTRACTION));
  double tau = is_phase(s) ? scallop_phase_duration(c, s->phase) : shorter, velocity = c->L / tau;
  const double of_phase[] = { tau, tau, velocity, c->L, c->L, c->L };
  const double of_steady[] = { 0, velocity, velocity, c->L, c->L / c->T, 1 };
  return is_trajectory(s) ? 0 : (is_phase(s) ? of_phase : of_steady)[q];
}

static void measure(const struct stress_case *s, const struct solutions *all, const double unit[STRESS_QUANTITIES],
                    struct stress_judgement *j)
{
  for (int q = 0; q < STRESS_QUANTITIES; q++) {
    struct stress_number *n = &j->number[q];
    const struct scallop_wide *exact = &numbers(s, &all->exact)[q], *got = &numbers(s, &all->got)[q];
    double y = exact->high, natural = natural_unit(s, q),
           floor = 0x1p-960 * natural; /* below 1e-289 digits may be lost */
    n->exact = y;
    n->got = got->high;
    n->exists = !isnan(y) || !isnan(got->high);
    n->ulp = fabs(y) > 0x1p53 * floor && isfinite(y) ? ldexp(1, ilogb(y) - (DBL_MANT_DIG - 1)) : 0;
    n->unit = fmax(fmax(unit[q], n->ulp), fmax(floor, DBL_MIN));
    n->error = distance(got, exact);
    n->resolved = 0x1p-111 * natural;
    for (int w = 0; w < 2; w++)
      n->wide_error[w] = distance(&numbers(s, &all->wide[w])[q], exact);
    if (fabs(y) > floor && !isnormal(y) && n->exists)
      fail(j, STRESS_BROKEN, "a number beyond the range of doubles was not refused, or one is there that is not");
  }
}

/* What binary128 resolves of a number, from the magnitudes of the parts that it is the sum of; 0 of those that are
 * none */
static void resolve_sums(const struct stress_case *s, struct stress_judgement *j)
{
  struct scallop_wide_phase phase;
  struct scallop_wide_steady steady;
  double size[QUANTITIES] = { 0 };
  if (is_phase(s)) {
    if (scallop_wide_phase(SCALLOP_BINARY128, &s->crawler, s->phase, s->v0, &phase) == SCALLOP_OK) {
      size[Q_DX1] = phase.dx1_size;
      size[Q_DX2] = phase.dx2_size;
      size[Q_DXC] = phase.dxC_size;
    }
  } else if (scallop_wide_steady(SCALLOP_BINARY128, &s->crawler, &steady) == SCALLOP_OK) {
    size[Q_DISPLACEMENT] = steady.period.displacement_size;
    size[Q_MEAN_VELOCITY] = steady.period.displacement_size / s->crawler.T;
  }
  for (int q = 0; q < STRESS_QUANTITIES; q++)
    j->number[q].resolved_sum = 0x1p-111 * size[first_of(s->kind) + q];
}

/* What is judged of a motion besides its errors */
static void judge_motion(const struct stress_case *s, const struct solutions *all, struct stress_judgement *j)
{
  for (int parameter = 0; parameter < PARAMETERS; parameter++)
    perturb(s, parameter, &all->got, j);
  round_otherwise(s, &all->got, j);
  if (isnan(all->errors[is_phase(s) ? Q_V_END : Q_V_START]))
    fail(j, STRESS_BROKEN, "there is no estimate of the error");
  j->other_modes = !same_modes(all->got.modes, all->wide[SCALLOP_BINARY128].modes);
  for (int q = 0; q < STRESS_QUANTITIES; q++) {
    struct stress_number *n = &j->number[q];
    n->estimate = all->errors[first_of(s->kind) + q];
    n->exists = n->exists && !(j->other_modes && may_jump(s, q));
  }
}

static bool any_broken(const struct stress_judgement *j)
{
  for (int q = 0; q < STRESS_QUANTITIES; q++)
    if (stress_broken(j, q))
      return true;
  return false;
}

void stress_judge(const struct stress_case *s, struct stress_judgement *j)
{
  struct solutions all;
  double unit[STRESS_QUANTITIES];
  *j = (struct stress_judgement){ .outcome = STRESS_SOLVED, .only_error = is_trajectory(s) };
  bool solved = is_trajectory(s) ? solve_to_its_end(s, &all, j) : solve_motion(s, &all, j);
  if (!solved)
    return;
  find_units(s, 1, &all.wide[SCALLOP_BINARY128], unit);
  measure(s, &all, unit, j);
  if (is_trajectory(s))
    return;
  judge_motion(s, &all, j);
  if (!any_broken(j))
    return;
  resolve_sums(s, j);
  find_units(s, STRESS_PROMISE, &all.wide[SCALLOP_BINARY128], unit);
  for (int q = 0; q < STRESS_QUANTITIES; q++)
    j->number[q].unit = fmax(j->number[q].unit, unit[q]);
}

bool stress_is_judged(const struct stress_judgement *j, int q)
{
  return (j->outcome == STRESS_SOLVED || j->outcome == STRESS_UNDECIDED) && j->number[q].exists;
}

const char *stress_broken(const struct stress_judgement *j, int q)
{
  const struct stress_number *n = &j->number[q];
  if (j->outcome == STRESS_BROKEN)
    return j->why;
  if (j->outcome == STRESS_REFUSED || !n->exists)
    return NULL;
  if (!(n->error <= STRESS_PROMISE * n->unit))
    return "error";
  if (j->only_error)
    return NULL;
  if (!(n->rounding <= STRESS_ROUNDING * n->unit))
    return "spread over the rounding modes";
  if (!(n->perturbed <= STRESS_PERTURBED * n->unit))
    return "spread over parameters an ulp apart";
  bool resolved = n->unit <= 0x1p50 * n->ulp || n->ulp == 0; /* by 113 bits */
  if (resolved && !(n->estimate >= n->error))
    return "estimate of the error too small";
  /* a number may be 0 whatever the parameters: then its unit is nothing but rounding of 113 bits */
  double negligible = n->ulp > 0 ? 0x1p-7 * n->ulp : fmax(0x1p-7 * fmax(n->unit, DBL_MIN), n->resolved);
  negligible = fmax(negligible, n->resolved_sum);
  if (!(n->estimate <= STRESS_GENEROUS * fmax(n->error, negligible)))
    return "estimate of the error too large";
  return NULL;
}
