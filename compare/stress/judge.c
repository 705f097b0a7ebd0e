/* One case of `stress`: solved in every arithmetic, and judged. */
#include <fenv.h>
#include <float.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "numerics/numerics.h"
#include "compare/stress/stress.h"
#include "numerics/certified.h"

const char *const stress_quantities[3][STRESS_QUANTITIES] = {
  { "froude", "v_start", "v_mid", "displacement", "mean_velocity", "multiplier" },
  { "t1", "dT", "v_end", "dx1", "dx2", "dxC" },
  { "x", "v" },
};

enum { PARAMETERS = 8, CERTIFIED_DIGITS = 36 };

/* The six numbers of a case, from whatever solver; nan where there is no such number. */
struct numbers {
  struct scallop_wide n[STRESS_QUANTITIES];
  struct scallop_modes modes[2]; /* of a phase the first; not of the certified solver */
};

static bool is_phase(const struct stress_case *s) { return s->kind == STRESS_PHASE; }

/* The multiplier and the switching times jump where modes change, however small the change of a parameter. */
static bool may_jump(const struct stress_case *s, int q) { return is_phase(s) ? q < 2 : q == STRESS_QUANTITIES - 1; }

static bool same_modes(const struct stress_case *s, const struct numbers *a, const struct numbers *b)
{
  bool same = true;
  for (int i = 0; i < (is_phase(s) ? 1 : 2); i++) {
    char text[2][SCALLOP_MODES_TEXT];
    scallop_modes_text(&a->modes[i], text[0]);
    scallop_modes_text(&b->modes[i], text[1]);
    same = same && strcmp(text[0], text[1]) == 0;
  }
  return same;
}

double stress_difference(const struct scallop_wide *a, const struct scallop_wide *b)
{
  return fabs((a->high - b->high) + (a->low - b->low));
}

/* ---- the solvers ---- */

static enum scallop_status solve_double(const struct stress_case *s, struct numbers *out,
                                        struct scallop_steady_result *steady, struct scallop_phase_result *phase)
{
  enum scallop_status status = is_phase(s) ? scallop_phase(&s->crawler, s->phase, s->v0, phase)
                                           : scallop_steady(&s->crawler, steady);
  if (status < 0)
    return status;
  const struct scallop_period_result *p = &steady->period;
  const double of_phase[] = { phase->t1, phase->dT, phase->v_end, phase->dx1, phase->dx2, phase->dxC };
  const double of_steady[] = { steady->froude, p->v_start, p->v_mid, p->displacement, steady->mean_velocity, p->multiplier };
  for (int q = 0; q < STRESS_QUANTITIES; q++)
    out->n[q] = (struct scallop_wide){ is_phase(s) ? of_phase[q] : of_steady[q], 0 };
  for (int i = 0; i < 2; i++)
    out->modes[i] = is_phase(s) ? phase->modes : p->modes[i];
  return status;
}

static enum scallop_status solve_plainly(const struct stress_case *s, struct numbers *out)
{
  struct scallop_steady_result steady = { 0 };
  struct scallop_phase_result phase = { 0 };
  return solve_double(s, out, &steady, &phase);
}

static enum scallop_status solve_wide(const struct stress_case *s, enum scallop_width width, struct numbers *out)
{
  struct scallop_wide_steady steady;
  struct scallop_wide_phase phase;
  enum scallop_status status = is_phase(s) ? scallop_wide_phase(width, &s->crawler, s->phase, s->v0, &phase)
                                           : scallop_wide_steady(width, &s->crawler, &steady);
  if (status < 0)
    return status;
  const struct scallop_wide_period *p = &steady.period;
  *out = is_phase(s) ? (struct numbers){ .n = { phase.t1, phase.dT, phase.v_end, phase.dx1, phase.dx2, phase.dxC } }
                     : (struct numbers){ .n = { steady.froude, p->v_start, p->v_mid, p->displacement, steady.mean_velocity,
                                                p->multiplier } };
  for (int i = 0; i < 2; i++)
    out->modes[i] = is_phase(s) ? phase.modes : p->modes[i];
  return status;
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

static enum scallop_status certify_steady(const struct scallop_rational_crawler *crawler, struct numbers *out,
                                          const char **why)
{
  struct scallop_certified_steady c;
  scallop_certified_steady_init(&c);
  enum scallop_status status = scallop_certified_steady(crawler, CERTIFIED_DIGITS, &c, why);
  if (status >= 0)
    *out = (struct numbers){ .n = { middle(c.froude), middle(c.v_start), middle(c.v_mid), middle(c.displacement),
                                    middle(c.mean_velocity), middle(c.multiplier) } };
  scallop_certified_steady_clear(&c);
  return status;
}

static enum scallop_status certify_phase(const struct scallop_rational_crawler *crawler, const struct stress_case *s,
                                         struct numbers *out, const char **why)
{
  const struct scallop_wide none = { NAN, 0 };
  struct scallop_certified_phase c;
  fmpq_t v0;
  fmpq_init(v0);
  scallop_certified_phase_init(&c);
  scallop_rational_set_double(v0, s->v0);
  enum scallop_status status = scallop_certified_phase(crawler, s->phase, v0, CERTIFIED_DIGITS, &c, why);
  if (status >= 0)
    *out = (struct numbers){ .n = { c.switches ? middle(c.t1) : none, c.switches ? middle(c.dT) : none, middle(c.v_end),
                                    middle(c.dx1), middle(c.dx2), middle(c.dxC) } };
  scallop_certified_phase_clear(&c);
  fmpq_clear(v0);
  return status;
}

static enum scallop_status certify(const struct stress_case *s, struct numbers *out, const char **why)
{
  struct scallop_rational_crawler crawler;
  scallop_rational_init(&crawler);
  scallop_rational_of(&crawler, &s->crawler);
  enum scallop_status status = is_phase(s) ? certify_phase(&crawler, s, out, why) : certify_steady(&crawler, out, why);
  scallop_rational_clear(&crawler);
  return status;
}

static void fail(struct stress_judgement *j, enum stress_outcome outcome, const char *why)
{
  j->outcome = outcome;
  j->why = why;
}

/* ---- an ulp up or down ---- */

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
static void disturb(const struct stress_case *s, int parameter, const struct numbers *wide, const struct numbers *got,
                    struct stress_judgement *j)
{
  double most[STRESS_QUANTITIES] = { 0 };
  for (int side = -1; side <= 1; side += 2) {
    struct stress_case next;
    struct numbers there;
    if (!stress_neighbour(s, parameter, side * INFINITY, 1, &next))
      continue;
    if (solve_wide(&next, SCALLOP_BINARY128, &there) >= 0)
      for (int q = 0; q < STRESS_QUANTITIES; q++)
        most[q] = fmax(most[q], stress_difference(&there.n[q], &wide->n[q]));
    enum scallop_status status = solve_plainly(&next, &there);
    if (status < 0 && status != SCALLOP_ERANGE)
      fail(j, STRESS_LIED, "no solution where a parameter is an ulp off");
    if (status < 0)
      continue;
    bool same = same_modes(s, &there, got);
    for (int q = 0; q < STRESS_QUANTITIES; q++)
      if (same || !may_jump(s, q))
        j->perturbed[q] = fmax(j->perturbed[q], stress_difference(&there.n[q], &got->n[q]));
  }
  for (int q = 0; q < STRESS_QUANTITIES; q++)
    j->unit[q] += most[q];
}

/* A kink that is further than an ulp away, and not more than as many as are promised, counts in proportion. */
static void look_further(const struct stress_case *s, const struct numbers *wide, struct stress_judgement *j)
{
  double unit[STRESS_QUANTITIES] = { 0 };
  for (int parameter = 0; parameter < PARAMETERS; parameter++) {
    double most[STRESS_QUANTITIES] = { 0 };
    for (int side = -1; side <= 1; side += 2) {
      struct stress_case next;
      struct numbers there;
      if (stress_neighbour(s, parameter, side * INFINITY, STRESS_PROMISE, &next)
          && solve_wide(&next, SCALLOP_BINARY128, &there) >= 0)
        for (int q = 0; q < STRESS_QUANTITIES; q++)
          most[q] = fmax(most[q], stress_difference(&there.n[q], &wide->n[q]));
    }
    for (int q = 0; q < STRESS_QUANTITIES; q++)
      unit[q] += most[q] / STRESS_PROMISE;
  }
  for (int q = 0; q < STRESS_QUANTITIES; q++)
    j->unit[q] = fmax(j->unit[q], unit[q]);
}

/* ---- the four roundings ---- */

static void round_otherwise(const struct stress_case *s, const struct numbers *got, struct stress_judgement *j)
{
  static const int directions[] = { FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO };
  double low[STRESS_QUANTITIES], high[STRESS_QUANTITIES];
  for (int q = 0; q < STRESS_QUANTITIES; q++)
    low[q] = high[q] = got->n[q].high;
  for (int i = 0; i < 3; i++) {
    struct numbers there;
    int before = fegetround();
    fesetround(directions[i]);
    enum scallop_status status = solve_plainly(s, &there);
    fesetround(before);
    if (status < 0 && status != SCALLOP_ERANGE)
      fail(j, STRESS_LIED, "no solution in a directed rounding");
    bool same = status >= 0 && same_modes(s, &there, got);
    for (int q = 0; status >= 0 && q < STRESS_QUANTITIES; q++) {
      if (!same && may_jump(s, q))
        continue;
      low[q] = fmin(low[q], there.n[q].high);
      high[q] = fmax(high[q], there.n[q].high);
    }
  }
  for (int q = 0; q < STRESS_QUANTITIES; q++)
    j->rounding[q] = high[q] - low[q];
}

/* ---- what a solve says of its own error ---- */

static bool estimates(const struct stress_case *s, const struct scallop_steady_result *steady,
                      const struct scallop_phase_result *phase, struct stress_judgement *j)
{
  struct scallop_steady_error e;
  struct scallop_phase_error p;
  enum scallop_status status = is_phase(s) ? scallop_phase_error(&s->crawler, s->phase, s->v0, phase, &p)
                                           : scallop_steady_error(&s->crawler, steady, &e);
  if (status < 0)
    return false;
  const double of_phase[] = { p.t1, p.dT, p.v_end, p.dx1, p.dx2, p.dxC };
  const double of_steady[] = { e.froude, e.v_start, e.v_mid, e.displacement, e.mean_velocity, e.multiplier };
  for (int q = 0; q < STRESS_QUANTITIES; q++)
    j->estimate[q] = is_phase(s) ? of_phase[q] : of_steady[q];
  return true;
}

/* ---- all of it ---- */

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

static void measure(const struct stress_case *s, const struct numbers *exact, const struct numbers *got,
                    const struct numbers wide[2], struct stress_judgement *j)
{
  for (int q = 0; q < STRESS_QUANTITIES; q++) {
    double y = exact->n[q].high;
    j->exact[q] = y;
    j->got[q] = got->n[q].high;
    j->has[q] = !isnan(y) || !isnan(got->n[q].high);
    j->ulp[q] = fabs(y) > 0x1p53 * floor_of(s, q) && isfinite(y) ? ldexp(1, ilogb(y) - (DBL_MANT_DIG - 1)) : 0;
    double floor = floor_of(s, q);
    j->unit[q] = fmax(fmax(j->unit[q], j->ulp[q]), fmax(floor, DBL_MIN));
    j->error[q] = stress_difference(&got->n[q], &exact->n[q]);
    for (int w = 0; w < 2; w++)
      j->wide_error[w][q] = stress_difference(&wide[w].n[q], &exact->n[q]);
    if (fabs(y) > floor && !isnormal(y) && j->has[q]) {
      j->outcome = STRESS_LIED;
      j->why = "a number beyond the range of doubles was not refused, or one is there that is not";
    }
  }
}

void stress_judge(const struct stress_case *s, struct stress_judgement *j)
{
  struct numbers got, exact, wide[2];
  struct scallop_steady_result steady = { 0 };
  struct scallop_phase_result phase = { 0 };
  if (s->kind == STRESS_TRAJECTORY) {
    stress_judge_trajectory(s, j);
    return;
  }
  *j = (struct stress_judgement){ .outcome = STRESS_SOLVED };
  enum scallop_status status = solve_double(s, &got, &steady, &phase);
  if (status < 0) {
    fail(j, status == SCALLOP_ERANGE ? STRESS_REFUSED : STRESS_LIED, scallop_status_text(status));
    return;
  }
  for (int w = 0; w < 2; w++)
    if (solve_wide(s, (enum scallop_width)w, &wide[w]) < 0) {
      fail(j, STRESS_LIED, "wider arithmetic finds no solution");
      return;
    }
  const char *why = NULL;
  if (certify(s, &exact, &why) < 0) { /* then wider arithmetic has to do */
    fail(j, STRESS_UNDECIDED, why);
    exact = wide[SCALLOP_BINARY128];
  }
  for (int parameter = 0; parameter < PARAMETERS; parameter++)
    disturb(s, parameter, &wide[SCALLOP_BINARY128], &got, j);
  measure(s, &exact, &got, wide, j);
  j->other_modes = !same_modes(s, &got, &wide[SCALLOP_BINARY128]);
  for (int q = 0; q < STRESS_QUANTITIES; q++)
    j->has[q] = j->has[q] && !(j->other_modes && may_jump(s, q));
  round_otherwise(s, &got, j);
  if (!estimates(s, &steady, &phase, j))
    fail(j, STRESS_LIED, "there is no estimate of the error");
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
