/* One case of `stress`: solved in every arithmetic, and judged. */
#include <fenv.h>
#include <float.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "compare/answers/answer_flint.h"
#include "compare/stress/stress.h"

static const char *const at_the_end[STRESS_QUANTITIES] = { "x", "v" }; /* of a trajectory */

enum { PARAMETERS = 8, CERTIFIED_DIGITS = 36 };

static bool is_phase(const struct stress_case *s) { return s->kind == STRESS_PHASE; }

static enum quantity_id first_of(const struct stress_case *s) { return quantity_first(is_phase(s) ? OF_PHASE : OF_STEADY); }

const char *stress_quantity_name(enum stress_kind kind, int q)
{
  return kind == STRESS_TRAJECTORY
             ? at_the_end[q]
             : quantity_rows[(int)quantity_first(kind == STRESS_PHASE ? OF_PHASE : OF_STEADY) + q].name;
}

static struct motion motion(const struct stress_case *s)
{
  return (struct motion){ is_phase(s) ? OF_PHASE : OF_STEADY, s->crawler, s->phase, s->v0 };
}

/* The six numbers of a case */
static const struct scallop_wide *numbers(const struct stress_case *s, const struct answer *a)
{
  return a->value + first_of(s);
}

/* The multiplier and the switching times jump where modes change, however small the change of a parameter. */
static bool may_jump(const struct stress_case *s, int q) { return is_phase(s) ? q < 2 : q == STRESS_QUANTITIES - 1; }

double stress_difference(const struct scallop_wide *a, const struct scallop_wide *b)
{
  return fabs((a->high - b->high) + (a->low - b->low));
}

static bool solve_double(const struct stress_case *s, struct answer *a)
{
  const struct motion m = motion(s);
  return answer_in_double(a, &m);
}

static bool solve_wide(const struct stress_case *s, enum scallop_width width, struct answer *a)
{
  const struct motion m = motion(s);
  return answer_in_wide(a, &m, width);
}

static struct scallop_wide middle(const arb_t x)
{
  arf_t low;
  struct scallop_wide w = { arf_get_d(arb_midref(x), ARF_RND_NEAR), 0 };
  arf_init(low);
  arf_set_d(low, w.high);
  arf_sub(low, arb_midref(x), low, ARF_PREC_EXACT, ARF_RND_NEAR);
  if (isfinite(w.high))
    w.low = arf_get_d(low, ARF_RND_NEAR);
  arf_clear(low);
  return arb_contains_zero(x) ? (struct scallop_wide){ 0, 0 } : w;
}

static bool certify(const struct stress_case *s, struct answer *a, const char **why)
{
  const struct motion m = motion(s);
  struct ball_answer proven;
  ball_answer_init(&proven);
  bool done = answer_of_doubles(&proven, &m, CERTIFIED_DIGITS);
  for (int q = 0; q < QUANTITIES && done; q++)
    a->value[q] = proven.value[q] ? middle(proven.value[q]) : (struct scallop_wide){ NAN, 0 };
  *why = proven.why;
  ball_answer_clear(&proven);
  return done;
}

static void fail(struct stress_judgement *j, enum stress_outcome outcome, const char *why)
{
  j->outcome = outcome;
  j->why = why;
}

bool stress_neighbour(const struct stress_case *s, int parameter, double towards, int places, struct stress_case *out)
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

/* What the changes of one parameter do to the result, in binary128 and in double. */
static void disturb(const struct stress_case *s, int parameter, const struct answer *wide, const struct answer *got,
                    struct stress_judgement *j)
{
  double most[STRESS_QUANTITIES] = { 0 };
  for (int side = -1; side <= 1; side += 2) {
    struct stress_case next;
    struct answer there;
    if (!stress_neighbour(s, parameter, side * INFINITY, 1, &next))
      continue;
    if (solve_wide(&next, SCALLOP_BINARY128, &there))
      for (int q = 0; q < STRESS_QUANTITIES; q++)
        most[q] = fmax(most[q], stress_difference(&numbers(s, &there)[q], &numbers(s, wide)[q]));
    bool solved = solve_double(&next, &there);
    if (!solved && there.status != SCALLOP_ERANGE)
      fail(j, STRESS_LIED, "no solution where a parameter is an ulp off");
    if (!solved)
      continue;
    bool same = same_modes(there.modes, got->modes);
    for (int q = 0; q < STRESS_QUANTITIES; q++)
      if (same || !may_jump(s, q))
        j->perturbed[q] = fmax(j->perturbed[q], stress_difference(&numbers(s, &there)[q], &numbers(s, got)[q]));
  }
  for (int q = 0; q < STRESS_QUANTITIES; q++)
    j->unit[q] += most[q];
}

/* A kink that is further than an ulp away, and not more than as many as are promised, counts in proportion. */
static void look_further(const struct stress_case *s, const struct answer *wide, struct stress_judgement *j)
{
  double unit[STRESS_QUANTITIES] = { 0 };
  for (int parameter = 0; parameter < PARAMETERS; parameter++) {
    double most[STRESS_QUANTITIES] = { 0 };
    for (int side = -1; side <= 1; side += 2) {
      struct stress_case next;
      struct answer there;
      if (stress_neighbour(s, parameter, side * INFINITY, STRESS_PROMISE, &next)
          && solve_wide(&next, SCALLOP_BINARY128, &there))
        for (int q = 0; q < STRESS_QUANTITIES; q++)
          most[q] = fmax(most[q], stress_difference(&numbers(s, &there)[q], &numbers(s, wide)[q]));
    }
    for (int q = 0; q < STRESS_QUANTITIES; q++)
      unit[q] += most[q] / STRESS_PROMISE;
  }
  for (int q = 0; q < STRESS_QUANTITIES; q++)
    j->unit[q] = fmax(j->unit[q], unit[q]);
}

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
    bool solved = solve_double(s, &there);
    fesetround(before);
    if (!solved && there.status != SCALLOP_ERANGE)
      fail(j, STRESS_LIED, "no solution in a directed rounding");
    bool same = solved && same_modes(there.modes, got->modes);
    for (int q = 0; solved && q < STRESS_QUANTITIES; q++) {
      if (!same && may_jump(s, q))
        continue;
      low[q] = fmin(low[q], numbers(s, &there)[q].high);
      high[q] = fmax(high[q], numbers(s, &there)[q].high);
    }
  }
  for (int q = 0; q < STRESS_QUANTITIES; q++)
    j->rounding[q] = high[q] - low[q];
}

/* tau, L/tau and L of a phase; of a steady state L/tau of its shorter phase, L, L/T and 1: at 2^-960 of these, about 1e-289, digits may be
 * lost. */
static double floor_of(const struct stress_case *s, int q)
{
  const struct scallop_crawler *c = &s->crawler;
  double shorter = fmin(scallop_phase_duration(c, SCALLOP_EXTENSION), scallop_phase_duration(c, SCALLOP_CONTRACTION));
  double tau = is_phase(s) ? scallop_phase_duration(c, s->phase) : shorter, velocity = c->L / tau;
  const double of_phase[] = { tau, tau, velocity, c->L, c->L, c->L };
  const double of_steady[] = { 0, velocity, velocity, c->L, c->L / c->T, 1 };
  return 0x1p-960 * (is_phase(s) ? of_phase : of_steady)[q];
}

static void measure(const struct stress_case *s, const struct answer *exact, const struct answer *got,
                    const struct answer wide[2], struct stress_judgement *j)
{
  for (int q = 0; q < STRESS_QUANTITIES; q++) {
    double y = numbers(s, exact)[q].high;
    j->exact[q] = y;
    j->got[q] = numbers(s, got)[q].high;
    j->has[q] = !isnan(y) || !isnan(numbers(s, got)[q].high);
    j->ulp[q] = fabs(y) > 0x1p53 * floor_of(s, q) && isfinite(y) ? ldexp(1, ilogb(y) - (DBL_MANT_DIG - 1)) : 0;
    double floor = floor_of(s, q);
    j->unit[q] = fmax(fmax(j->unit[q], j->ulp[q]), fmax(floor, DBL_MIN));
    j->error[q] = stress_difference(&numbers(s, got)[q], &numbers(s, exact)[q]);
    for (int w = 0; w < 2; w++)
      j->wide_error[w][q] = stress_difference(&numbers(s, &wide[w])[q], &numbers(s, exact)[q]);
    if (fabs(y) > floor && !isnormal(y) && j->has[q]) {
      j->outcome = STRESS_LIED;
      j->why = "a number beyond the range of doubles was not refused, or one is there that is not";
    }
  }
}

void stress_judge(const struct stress_case *s, struct stress_judgement *j)
{
  const struct motion m = motion(s);
  struct answer got, exact, wide[2];
  double errors[QUANTITIES];
  if (s->kind == STRESS_TRAJECTORY) {
    stress_judge_trajectory(s, j);
    return;
  }
  *j = (struct stress_judgement){ .outcome = STRESS_SOLVED };
  if (!answer_with_errors(&got, &m, errors)) {
    fail(j, got.status == SCALLOP_ERANGE ? STRESS_REFUSED : STRESS_LIED, scallop_status_text(got.status));
    return;
  }
  for (int w = 0; w < 2; w++)
    if (!solve_wide(s, (enum scallop_width)w, &wide[w])) {
      fail(j, STRESS_LIED, "wider arithmetic finds no solution");
      return;
    }
  const char *why = NULL;
  if (!certify(s, &exact, &why)) { /* then wider arithmetic has to do */
    fail(j, STRESS_UNDECIDED, why);
    exact = wide[SCALLOP_BINARY128];
  }
  for (int parameter = 0; parameter < PARAMETERS; parameter++)
    disturb(s, parameter, &wide[SCALLOP_BINARY128], &got, j);
  measure(s, &exact, &got, wide, j);
  j->other_modes = !same_modes(got.modes, wide[SCALLOP_BINARY128].modes);
  for (int q = 0; q < STRESS_QUANTITIES; q++)
    j->has[q] = j->has[q] && !(j->other_modes && may_jump(s, q));
  round_otherwise(s, &got, j);
  if (isnan(errors[is_phase(s) ? Q_V_END : Q_V_START]))
    fail(j, STRESS_LIED, "there is no estimate of the error");
  for (int q = 0; q < STRESS_QUANTITIES; q++)
    j->estimate[q] = errors[(int)first_of(s) + q];
  for (int q = 0; q < STRESS_QUANTITIES; q++)
    if (stress_broken(j, q)) {
      look_further(s, &wide[SCALLOP_BINARY128], j);
      break;
    }
}

const char *stress_broken(const struct stress_judgement *j, int q)
{
  if (j->outcome == STRESS_LIED)
    return j->why;
  if (j->outcome == STRESS_REFUSED || !j->has[q])
    return NULL;
  if (!(j->error[q] <= STRESS_PROMISE * j->unit[q]))
    return "error";
  if (j->only_error)
    return NULL;
  if (!(j->rounding[q] <= STRESS_ROUNDING * j->unit[q]))
    return "spread over the rounding modes";
  if (!(j->perturbed[q] <= STRESS_PERTURBED * j->unit[q]))
    return "spread over parameters an ulp apart";
  bool told = j->unit[q] <= 0x1p50 * j->ulp[q] || j->ulp[q] == 0; /* by 113 bits */
  if (told && !(j->estimate[q] >= j->error[q]))
    return "estimate of the error too small";
  double small = 0x1p-7 * (j->ulp[q] > 0 ? j->ulp[q] : fmax(j->unit[q], DBL_MIN)); /* nothing that counts */
  if (!(j->estimate[q] <= STRESS_GENEROUS * fmax(j->error[q], small)))
    return "estimate of the error too large";
  return NULL;
}
