/* What an exact answer costs: beside the arithmetic floor, and beside what the general-purpose rival takes for the same
 * one.
 *
 * A batch is a number of passes over a set of seeded crawlers, long enough for the clock; the methods of
 * a case take turns, batch by batch, so that a machine that slows down slows all of them; the table has
 * the median and the quartiles of the batches, in nanoseconds for one period (or one steady state). The
 * rival's memory is made beforehand. Its tolerance is the one that takes the fewest evaluations among
 * those that reach the wanted error on every crawler of the set: it is given its best. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/floor.h"
#include "bench/start.h"
#include "compare/text/stopwatch.h"
#include "numerics/numerics.h"
#include "numerics/rivals/rival.h"

enum { MOST_CRAWLERS = 1024, FEW_CRAWLERS = 64, BATCHES = 61, PARAMETERS = 7 };

static const double batch_seconds = 2e-3;

/* What crawlers a set has. eps = T^2 (F1 + F2)/(M L) decides the regime: small slides, large sticks. */
enum choice { REGULAR, STICK_SLIP, ANY };
static const char *const choice_text[] = { "regular", "stick-slip", "any" };

struct set {
  const char *name; /* what kind of crawlers */
  int count;
  struct scallop_crawler crawler[MOST_CRAWLERS];
  double v0[MOST_CRAWLERS];                          /* near the steady velocity */
  struct scallop_period_result exact[MOST_CRAWLERS]; /* from there               */
  double parameter[PARAMETERS][MOST_CRAWLERS];       /* m1 m2 F1 F2 L T alpha, as a batch wants them */
  const struct scallop_gait *gait[MOST_CRAWLERS];
};

struct method {
  const char *name;
  stopwatch_task *pass; /* over all crawlers of the set; context is the method                    */
  const struct set *set;
  enum scallop_odeiv_stepper stepper;
  struct scallop_rival *rival;
  double goal, tolerance, error;
  long passes;
  double ns[BATCHES];
  struct stopwatch_spread spread;
};

static _Noreturn void give_up(const char *why)
{
  fprintf(stderr, "bench: %s\n", why);
  exit(3);
}

static uint64_t seed = 1303266920130311;

static double uniform(double low, double high) /* splitmix64 */
{
  uint64_t z = seed += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return low + (high - low) * (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/* T = 1 */
static struct scallop_crawler any_crawler(const struct scallop_gait *gait, enum choice choice)
{
  double log_eps = choice == REGULAR ? uniform(-4, -1) : choice == STICK_SLIP ? uniform(0, 3) : uniform(-9, 7);
  struct scallop_crawler c = { .m1 = exp(uniform(-1, 1)),
                               .m2 = exp(uniform(-1, 1)),
                               .F1 = exp(uniform(-1, 1)),
                               .F2 = exp(uniform(-1, 1)),
                               .T = 1,
                               .alpha = uniform(0.2, 0.8),
                               .gait = gait };
  c.L = (c.F1 + c.F2) / (c.m1 + c.m2) / exp(log_eps);
  return c;
}

/* The regular case of the paper: each phase begins and ends with both bodies moving forward, and in between they move
 * apart or together, turning while the separation speeds up and while it slows down. */
static bool is_regular(const struct scallop_crawler *c, const struct scallop_period_result *r, double *worst)
{
  struct floor_result f;
  if (r->regime != SCALLOP_SLIDING || r->modes[0].count != 3 || r->modes[1].count != 3 || r->v_start <= 0)
    return false;
  if (c->gait != &scallop_gait_quadratic)
    return true;
  floor_steady(c, &f);
  double error = fmax(fabs(f.v_start / r->v_start - 1), fabs(f.displacement / r->displacement - 1));
  if (error > 1e-10) /* the turning point of l' lies outside of the opposite motion */
    return false;
  *worst = fmax(*worst, error);
  return true;
}

/* Relative errors mean something only where the answer is not a small difference. */
static bool sizeable(const struct scallop_crawler *c, const struct scallop_period_result *r)
{
  return fabs(r->v_end) > 0.05 * c->L / c->T && fabs(r->displacement) > 0.05 * c->L;
}

static bool is_wanted(const struct scallop_crawler *c, const struct scallop_period_result *r, enum choice choice,
                      double *worst)
{
  return choice == ANY || (choice == STICK_SLIP ? r->regime == SCALLOP_STICK_SLIP : is_regular(c, r, worst));
}

static void put(struct set *set, int i, const struct scallop_crawler *c)
{
  const double parameter[PARAMETERS] = { c->m1, c->m2, c->F1, c->F2, c->L, c->T, c->alpha };
  set->crawler[i] = *c;
  set->gait[i] = c->gait;
  for (int k = 0; k < PARAMETERS; k++)
    set->parameter[k][i] = parameter[k];
}

/* Crawlers of the wanted kind. With starts: and a velocity within a fifth of the steady one, from which a period is of
 * the same regime and its results are not small. Returns how far the floor is from the exact solver, where it
 * applies. */
static double fill(struct set *set, int count, const struct scallop_gait *gait, enum choice choice, bool starts)
{
  struct scallop_steady_result steady;
  double worst = 0;
  set->name = choice_text[choice];
  set->count = count;
  for (int i = 0, tries = 0; i < count; tries++) {
    struct scallop_crawler c = any_crawler(gait, choice);
    struct scallop_period_result *r = &set->exact[i];
    if (tries > 1000 * count || scallop_steady(&c, &steady) < 0)
      give_up("no crawlers of the wanted regime");
    if (!is_wanted(&c, &steady.period, choice, &worst))
      continue;
    set->v0[i] = steady.period.v_start * uniform(0.8, 1.2);
    if (scallop_period(&c, set->v0[i], r) != SCALLOP_OK)
      give_up("a crawler has no period");
    if (starts && (!sizeable(&c, r) || r->regime != steady.period.regime))
      continue;
    put(set, i++, &c);
  }
  return worst;
}

static double exact_periods(void *context)
{
  const struct method *m = context;
  double sum = 0;
  for (int i = 0; i < m->set->count; i++) {
    struct scallop_period_result r;
    enum scallop_status status = scallop_period(&m->set->crawler[i], m->set->v0[i], &r);
    sum += status == SCALLOP_OK ? r.v_end + r.displacement : NAN;
  }
  return sum;
}

static double odeiv_periods(void *context)
{
  const struct method *m = context;
  double sum = 0;
  for (int i = 0; i < m->set->count; i++) {
    struct scallop_rival_period r;
    enum scallop_status status = m->rival->period(m->rival, &m->set->crawler[i], m->set->v0[i], NULL, &r);
    sum += status == SCALLOP_OK ? r.v_end + r.displacement : NAN;
  }
  return sum;
}

static double steady_states(void *context)
{
  const struct method *m = context;
  double sum = 0;
  for (int i = 0; i < m->set->count; i++) {
    struct scallop_steady_result r;
    sum += scallop_steady(&m->set->crawler[i], &r) >= 0 ? r.mean_velocity : NAN;
  }
  return sum;
}

static double floors(void *context)
{
  const struct method *m = context;
  double sum = 0;
  for (int i = 0; i < m->set->count; i++) {
    struct floor_result r;
    floor_steady(&m->set->crawler[i], &r);
    sum += r.mean_velocity + r.multiplier;
  }
  return sum;
}

static double batches(void *context)
{
  const struct set *s = ((const struct method *)context)->set;
  static double out[6][MOST_CRAWLERS];
  const double(*in)[MOST_CRAWLERS] = s->parameter;
  const struct scallop_crawlers crawlers = { s->count, in[0], in[1], in[2], in[3], in[4], in[5], in[6], s->gait };
  const struct scallop_steady_states states = { .froude = out[0],
                                                .v_start = out[1],
                                                .v_mid = out[2],
                                                .displacement = out[3],
                                                .multiplier = out[4],
                                                .mean_velocity = out[5] };
  double sum = scallop_steady_batch(&crawlers, &states, 1) == 0 ? 0 : NAN;
  for (int i = 0; i < s->count; i++)
    sum += states.mean_velocity[i];
  return sum;
}

/* The larger error, where nan is larger than all. */
static double larger(double worst, double error) { return isnan(worst) || error <= worst ? worst : error; }

/* Largest relative error in v_end and displacement over the set, and the evaluations it took. */
static double odeiv_error(const struct method *m, struct scallop_rival *rival, long *evaluations)
{
  double worst = 0;
  *evaluations = 0;
  for (int i = 0; i < m->set->count; i++) {
    const struct scallop_period_result *exact = &m->set->exact[i];
    struct scallop_rival_period r;
    if (rival->period(rival, &m->set->crawler[i], m->set->v0[i], NULL, &r) != SCALLOP_OK)
      return INFINITY;
    worst = larger(worst, fabs(r.v_end / exact->v_end - 1));
    worst = larger(worst, fabs(r.displacement / exact->displacement - 1));
    *evaluations += r.evaluations;
  }
  return worst;
}

/* The cheapest tolerance that reaches the goal. */
static void choose_tolerance(struct method *m)
{
  long fewest = 0, evaluations = 0;
  for (int i = 4; i <= 30; i++) { /* half decades: 1e-2 to 1e-15 */
    double tolerance = pow(10, -0.5 * i);
    struct scallop_rival *rival = scallop_odeiv_rival(m->stepper, tolerance);
    double error = rival ? odeiv_error(m, rival, &evaluations) : INFINITY;
    scallop_rival_destroy(rival);
    if (error <= m->goal && (fewest == 0 || evaluations < fewest)) {
      fewest = evaluations;
      m->tolerance = tolerance;
      m->error = error;
    }
  }
  m->rival = scallop_odeiv_rival(m->stepper, m->tolerance);
  if (fewest == 0 || !m->rival)
    give_up("no tolerance reaches the wanted error");
}

/* How far a period moves the steady state: it should not. */
static double steady_error(const struct set *set)
{
  double worst = 0;
  struct scallop_steady_result r;
  for (int i = 0; i < set->count; i++) {
    if (scallop_steady(&set->crawler[i], &r) != SCALLOP_OK)
      give_up("no steady state");
    worst = larger(worst, fabs(r.period.v_end - r.period.v_start) / (set->crawler[i].L / set->crawler[i].T));
  }
  return worst;
}

static void measure(struct method *methods, int count)
{
  for (int k = 0; k < count; k++) {
    struct method *m = &methods[k];
    if (isnan(m->pass(m)))
      give_up("a method failed");
    m->passes = stopwatch_passes(m->pass, m, batch_seconds);
  }
  for (int batch = 0; batch < BATCHES; batch++)
    for (int k = 0; k < count; k++) {
      struct method *m = &methods[k];
      m->ns[batch] = 1e9 * stopwatch_batch(m->pass, m, m->passes) / ((double)m->passes * m->set->count);
    }
  for (int k = 0; k < count; k++)
    methods[k].spread = stopwatch_spread(methods[k].ns, BATCHES);
}

static double ratio(const struct method *m, const struct method *reference)
{
  return m->spread.median / reference->spread.median;
}

/* A row for each; the first so many are the references of the others, in turn. */
static void measure_and_print(const char *what, struct method *methods, int count, int references)
{
  measure(methods, count);
  for (int k = 0; k < count; k++) {
    const struct method *m = &methods[k];
    printf("%s\t%s\t%s\t%s\t%.4g\t%.4g\t%.4g\t%.2g\t%.3g\t%.2g\n", what, m->set->name, m->set->crawler[0].gait->name,
           m->name, m->spread.median, m->spread.q1, m->spread.q3, m->error, ratio(m, &methods[k % references]),
           m->tolerance);
  }
  fflush(stdout);
}

/* Every way to a steady state, beside the floor. */
static void bench_steady(void)
{
  enum { FLOOR, ONE, ONE_HELD, ONE_ANY, BATCH, BATCH_HELD, BATCH_ANY, SINE, SINE_HELD, SINE_ANY, SINE_BATCH, METHODS };
  static struct set quadratic[3], sine[3];
  double off = 0;
  for (int choice = 0; choice < 3; choice++) {
    off = fmax(off, fill(&quadratic[choice], MOST_CRAWLERS, &scallop_gait_quadratic, (enum choice)choice, false));
    fill(&sine[choice], MOST_CRAWLERS, &scallop_gait_sinusoidal, (enum choice)choice, false);
  }
  struct method m[METHODS] = {
    [FLOOR] = { .name = "floor", .pass = floors, .set = &quadratic[REGULAR] },
    [ONE] = { .name = "one at a time", .pass = steady_states, .set = &quadratic[REGULAR] },
    [ONE_HELD] = { .name = "one at a time", .pass = steady_states, .set = &quadratic[STICK_SLIP] },
    [ONE_ANY] = { .name = "one at a time", .pass = steady_states, .set = &quadratic[ANY] },
    [BATCH] = { .name = "batch", .pass = batches, .set = &quadratic[REGULAR] },
    [BATCH_HELD] = { .name = "batch", .pass = batches, .set = &quadratic[STICK_SLIP] },
    [BATCH_ANY] = { .name = "batch", .pass = batches, .set = &quadratic[ANY] },
    [SINE] = { .name = "one at a time", .pass = steady_states, .set = &sine[REGULAR] },
    [SINE_HELD] = { .name = "one at a time", .pass = steady_states, .set = &sine[STICK_SLIP] },
    [SINE_ANY] = { .name = "one at a time", .pass = steady_states, .set = &sine[ANY] },
    [SINE_BATCH] = { .name = "batch", .pass = batches, .set = &sine[ANY] },
  };
  for (int k = 0; k < METHODS; k++) {
    m[k].tolerance = NAN;
    m[k].error = k == FLOOR ? off : steady_error(m[k].set);
  }
  measure_and_print("steady", m, METHODS, 1);
  printf("# quadratic steady state, times the floor: regular %.1f, stick-slip %.1f, any %.1f; in a batch %.1f, %.1f, "
         "%.1f\n",
         ratio(&m[ONE], m), ratio(&m[ONE_HELD], m), ratio(&m[ONE_ANY], m), ratio(&m[BATCH], m),
         ratio(&m[BATCH_HELD], m), ratio(&m[BATCH_ANY], m));
  printf("# sinusoidal steady state, times the quadratic one: regular %.1f, stick-slip %.1f, any %.1f\n",
         ratio(&m[SINE], &m[ONE]), ratio(&m[SINE_HELD], &m[ONE_HELD]), ratio(&m[SINE_ANY], &m[ONE_ANY]));
}

/* One period beside the rival's */
static void bench_period(const struct set *set)
{
  enum { METHODS = 5 };
  const char *gait = set->crawler[0].gait->name;
  struct method m[METHODS] = {
    { .name = "exact", .pass = exact_periods, .set = set, .tolerance = NAN },
    { .name = "gsl rkf45", .pass = odeiv_periods, .set = set, .stepper = SCALLOP_ODEIV_RKF45, .goal = 1e-12 },
    { .name = "gsl rk8pd", .pass = odeiv_periods, .set = set, .stepper = SCALLOP_ODEIV_RK8PD, .goal = 1e-12 },
    { .name = "gsl rkf45 to 1e-6", .pass = odeiv_periods, .set = set, .stepper = SCALLOP_ODEIV_RKF45, .goal = 1e-6 },
    { .name = "gsl rk8pd to 1e-6", .pass = odeiv_periods, .set = set, .stepper = SCALLOP_ODEIV_RK8PD, .goal = 1e-6 },
  };
  for (int k = 1; k < METHODS; k++)
    choose_tolerance(&m[k]);
  measure_and_print("period", m, METHODS, 1);
  const struct method *best = m[1].spread.median < m[2].spread.median ? &m[1] : &m[2];
  printf("# %s %s period: the best GSL at error <= %g is %s: %.1f times the exact solver's time\n", set->name, gait,
         best->goal, best->name, ratio(best, m));
  for (int k = 1; k < METHODS; k++)
    scallop_rival_destroy(m[k].rival);
}

/* One period of each kind, in turns. */
static void bench_periods(void)
{
  enum { QUADRATIC, QUADRATIC_HELD, SINE, SINE_HELD, METHODS };
  static struct set sets[METHODS];
  struct method m[METHODS];
  for (int k = 0; k < METHODS; k++) {
    fill(&sets[k], FEW_CRAWLERS, k < SINE ? &scallop_gait_quadratic : &scallop_gait_sinusoidal,
         k % 2 ? STICK_SLIP : REGULAR, true);
    m[k] = (struct method){ .name = "exact", .pass = exact_periods, .set = &sets[k], .tolerance = NAN };
  }
  measure_and_print("period", m, METHODS, 2);
  printf("# sinusoidal period, times the quadratic one: regular %.1f, stick-slip %.1f\n",
         ratio(&m[SINE], &m[QUADRATIC]), ratio(&m[SINE_HELD], &m[QUADRATIC_HELD]));
}

/* The same crawlers at ever smaller T: it must not cost more. */
static void bench_small_T(const struct scallop_gait *gait)
{
  enum { TIMES = 5 };
  static const double T[TIMES] = { 1, 1e-2, 1e-4, 1e-6, 1e-8 };
  static const char *const name[TIMES] = { "T=1", "T=1e-2", "T=1e-4", "T=1e-6", "T=1e-8" };
  static struct set sets[TIMES];
  struct method m[TIMES];
  fill(&sets[0], FEW_CRAWLERS, gait, REGULAR, false);
  for (int k = 0; k < TIMES; k++) {
    sets[k] = sets[0];
    sets[k].name = "small T";
    for (int i = 0; i < FEW_CRAWLERS; i++) {
      struct scallop_crawler c = sets[0].crawler[i];
      c.T = T[k];
      put(&sets[k], i, &c);
    }
    m[k] = (struct method){ .name = name[k], .pass = steady_states, .set = &sets[k], .tolerance = NAN };
    m[k].error = steady_error(&sets[k]);
  }
  measure_and_print("steady", m, TIMES, 1);
}

static void print_head(void)
{
  struct stopwatch_clock clock = stopwatch_clock();
  printf("# scallop %s: time for one period and for one steady state\n", SCALLOP_VERSION);
  printf("# %d batches of at least %g ms, methods in turn, one thread; the clock costs %.0f ns a reading\n", BATCHES,
         1e3 * batch_seconds, 1e9 * clock.cost);
  printf("# sets of %d crawlers (steady) and %d (period, small T); any: T^2 (F1 + F2)/(M L) from e^-9 to e^7\n",
         MOST_CRAWLERS, FEW_CRAWLERS);
  printf("# floor: the closed form of the regular modes written out by hand, which checks nothing\n");
  printf("# ns: median and quartiles over the batches, for one answer\n");
  printf("# error: steady: how far one period moves the steady velocity, over L/T (floor: its largest relative\n");
  printf("#        difference from exact); period: largest relative difference of v_end and displacement from exact\n");
  printf("# ratio: of the medians, to the floor; period: to exact in the same case and gait, or to the quadratic one; "
         "small "
         "T: to T=1\n");
  printf("# start: a process from being made to its end, %d times; ratio: to one that does nothing\n", START_RUNS);
  printf("# tolerance: GSL's, the cheapest of 1e-2, 3e-3 ... 1e-15 with error <= 1e-12, or 1e-6 as said\n");
  printf("# quadratic: x1'' is constant in a mode, so Runge-Kutta steps of any length are exact\n");
  printf("what\tcrawlers\tgait\tmethod\tns_median\tns_q1\tns_q3\terror\tratio\ttolerance\n");
}

/* Nothing but passes over one set, for who counts instructions (scripts/dev/instructions.sh). */
static int repeat(const char *what, const char *choice_name, const char *gait_name, long passes)
{
  static struct set set;
  const struct scallop_gait *gait = scallop_gait_named(gait_name);
  struct method m = { .set = &set,
                      .pass = strcmp(what, "batch") == 0    ? batches
                              : strcmp(what, "steady") == 0 ? steady_states
                              : strcmp(what, "period") == 0 ? exact_periods
                                                            : floors };
  int choice = 0;
  while (choice <= ANY && strcmp(choice_name, choice_text[choice]) != 0)
    choice++;
  if (!gait || choice > ANY || passes < 0)
    give_up("usage: scallop-bench [floor|steady|batch|period regular|stick-slip|any quadratic|sinusoidal PASSES]");
  fill(&set, FEW_CRAWLERS, gait, (enum choice)choice, false);
  double sum = 0;
  for (long i = 0; i < passes; i++)
    sum += m.pass(&m);
  printf("%ld answers, sum %.17g\n", passes * set.count, sum);
  return 0;
}

int main(int count, char **arguments)
{
  static struct set set;
  static const struct scallop_gait *const gaits[] = { &scallop_gait_quadratic, &scallop_gait_sinusoidal };
  if (count == 5)
    return repeat(arguments[1], arguments[2], arguments[3], strtol(arguments[4], NULL, 10));
  print_head();
  bench_steady();
  bench_periods();
  for (int i = 0; i < 2; i++)
    for (int choice = REGULAR; choice <= STICK_SLIP; choice++) {
      fill(&set, FEW_CRAWLERS, gaits[i], (enum choice)choice, true);
      bench_period(&set);
    }
  for (int i = 0; i < 2; i++)
    bench_small_T(gaits[i]);
  bench_start(arguments[0]);
  return 0;
}
